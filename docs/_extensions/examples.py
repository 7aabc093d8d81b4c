"""Pages made from the repository's examples.

`<!-- scripts -->` in a page becomes a section for each script in examples/, from its docstring. A
page that consists of `<!-- notebook: NAME -->` shows that notebook, executed by a kernel. If
`notebooks_run` is set, it links to the copy that the reader can run.
"""

import ast
import base64
import re
from logging import getLogger
from pathlib import Path

ROOT = Path(__file__).parents[2]
SCRIPTS = "<!-- scripts -->"
RUN = (
    '<p><a href="../notebooks/notebooks/index.html?path={notebook}">Run this notebook in your '
    "browser</a>: nothing has to be installed. Python starts in the page, which takes a while at "
    "first.</p>"
)
NOTEBOOK = re.compile(r"<!-- notebook: (\S+) -->\s*")


def scripts():
    return sorted((ROOT / "examples").glob("*.py"))


def section(script):
    """The question of a script, its answer and its code."""
    text = script.read_text("utf-8")
    tree = ast.parse(text)
    words, promised = ast.get_docstring(tree).split("\n\n    ", 1)
    question, explanation = words.split("\n", 1)
    lines = "\n".join(line.removeprefix("    ") for line in promised.split("\n"))
    code = "\n".join(text.splitlines()[tree.body[0].end_lineno :]).strip()
    link = f"[{script.name}](../../examples/{script.name})"
    return (
        f"## {question}\n\n{explanation.strip()}\n\n```\n{lines}\n```\n\n"
        f"```python\n{code}\n```\n\n{link}\n"
    )


def executed(notebook):
    """The notebook with its outputs, as a kernel computes them in the folder of examples."""
    import nbformat
    from nbclient import NotebookClient

    found = nbformat.read(notebook, as_version=4)
    resources = {"metadata": {"path": str(notebook.parent)}}
    getLogger("traitlets").setLevel("WARNING")
    # The kernel would warn that other programs of this machine can read what it is told.
    quiet = ["--IPKernelApp.log_level=ERROR"]
    client = NotebookClient(
        found, timeout=600, kernel_name="python3", resources=resources, extra_arguments=quiet
    )
    return client.execute()


def page_of(notebook, pictures, runs):
    """The notebook as Markdown; its pictures are written to a folder beside the page."""
    parts = []
    for number, cell in enumerate(executed(notebook).cells):
        if cell.cell_type == "markdown":
            parts.append(cell.source)
            continue
        parts.append(f"```python\n{cell.source}\n```")
        for output in cell.outputs:
            name = f"{notebook.stem}-{number}.png"
            parts.append(shown(output, pictures / name))
    if runs:
        parts.insert(1, RUN.format(notebook=notebook.name))  # below the question
    return "\n\n".join(parts) + "\n"


def shown(output, picture):
    """An output in Markdown."""
    if output.output_type == "stream":
        return f"```\n{output.text}```"
    data = output.data
    if "text/html" in data:
        return f"```{{raw}} html\n{data['text/html']}\n```"
    if "image/png" in data:
        picture.parent.mkdir(exist_ok=True)
        picture.write_bytes(base64.b64decode(data["image/png"]))
        return f"![The figure that the cell draws]({picture.parent.name}/{picture.name})"
    return f"```\n{data['text/plain']}\n```"


def read(app, name, source):
    page = Path(app.env.doc2path(name))
    found = NOTEBOOK.fullmatch(source[0])
    if found:
        notebook = ROOT / found[1]
        app.env.note_dependency(str(notebook))
        source[0] = page_of(notebook, page.parent / "made", app.config.notebooks_run)
    elif SCRIPTS in source[0]:
        for script in scripts():
            app.env.note_dependency(str(script))
        sections = "\n".join(section(script) for script in scripts())
        source[0] = source[0].replace(SCRIPTS, sections)


def setup(app):
    app.add_config_value("notebooks_run", default=False, rebuild="env")
    app.connect("source-read", read, priority=400)  # before links are led to their pages
    return {"parallel_read_safe": True, "parallel_write_safe": True}
