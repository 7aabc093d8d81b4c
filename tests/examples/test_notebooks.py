"""The notebooks in examples/ run from top to bottom; `make docs` runs them in a kernel."""

import ast
import contextlib
import io
import json
from importlib import resources
from pathlib import Path

import matplotlib as mpl
import pytest

EXAMPLES = Path(__file__).parents[2] / "examples"
NOTEBOOKS = sorted(EXAMPLES.glob("*.ipynb"))
PAGE = resources.files("rimroll") / "page"

each_notebook = pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)


def cells(path, kind):
    notebook = json.loads(path.read_text("utf-8"))
    return [cell for cell in notebook["cells"] if cell["cell_type"] == kind]


def run(code, names):
    """Runs a cell; returns its result, as a notebook shows it."""
    *statements, last = ast.parse(code).body
    if not isinstance(last, ast.Expr):
        statements, last = [*statements, last], None
    exec(compile(ast.Module(statements, []), "cell", "exec"), names)
    return last and eval(compile(ast.Expression(last.value), "cell", "eval"), names)


@pytest.mark.slow
@each_notebook
def test_a_notebook_runs_from_top_to_bottom(path, monkeypatch):
    source = path.read_text("utf-8")
    if ".lab(" in source and not (PAGE / "alone.js").is_file():
        pytest.skip("the page is not built: make web")
    monkeypatch.setattr("rimroll.browser.view._in_notebook", lambda: True)
    names, results = {}, []
    with mpl.rc_context({"backend": "agg"}), contextlib.redirect_stdout(io.StringIO()):
        for cell in cells(path, "code"):
            results.append(run("".join(cell["source"]), names))
    for result in results:
        views = [getattr(result, name, None) for name in ("_repr_html_", "_repr_png_")]
        assert result is None or any(view and view() for view in views)


@each_notebook
def test_a_notebook_is_kept_without_outputs(path):
    for cell in cells(path, "code"):
        assert (cell["outputs"], cell["execution_count"], cell["metadata"]) == ([], None, {})


@each_notebook
def test_a_notebook_begins_with_its_question_and_has_a_page(path):
    question = "".join(cells(path, "markdown")[0]["source"]).splitlines()[0]
    assert question.startswith("# ") and question.endswith("?")
    pages = EXAMPLES.parent / "docs/examples"
    page = pages / f"{path.stem.replace('_', '-')}.md"
    assert page.read_text("utf-8") == f"<!-- notebook: examples/{path.name} -->\n"
    assert f"[{question[2:]}]({page.name})" in (pages / "index.md").read_text("utf-8")
