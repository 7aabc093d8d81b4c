"""Each script in examples/ answers its question with what its docstring says."""

import ast
import contextlib
import io
import re
import runpy
from pathlib import Path
from textwrap import dedent

import pytest

EXAMPLES = Path(__file__).parents[2] / "examples"
SCRIPTS = sorted(EXAMPLES.glob("*.py"))
SLOW = {"falls_of_a_class"}
LONGEST = 40
"""Lines of code that a reader takes in at once."""

each_script = pytest.mark.parametrize(
    "script",
    [pytest.param(s, id=s.stem, marks=[pytest.mark.slow] * (s.stem in SLOW)) for s in SCRIPTS],
)


def promised(script):
    """The block at the end of the docstring, which shows what the script prints."""
    description = ast.get_docstring(ast.parse(script.read_text("utf-8")), clean=False)
    (block,) = re.findall(r"\n\n((?:    .*\n|\n)+)$", description)
    return dedent(block)


def printed(script):
    out = io.StringIO()
    with contextlib.redirect_stdout(out):
        runpy.run_path(str(script))
    return re.sub(r" +$", "", out.getvalue(), flags=re.M)


@each_script
def test_a_script_prints_what_its_docstring_promises(script):
    assert printed(script) == promised(script)


@each_script
def test_a_script_is_a_question_and_a_screenful(script):
    text = script.read_text("utf-8")
    tree = ast.parse(text)
    assert ast.get_docstring(tree).splitlines()[0].endswith("?")
    first = tree.body[1].lineno
    assert len(text.splitlines()) - first < LONGEST


def test_there_are_scripts():
    assert len(SCRIPTS) > 10
    assert {script.stem for script in SCRIPTS} >= SLOW
