"""Runs the code of a page and compares what it prints with what the page shows.

The Python blocks of a page run in their order, in one namespace, and so do its commands (`sh`
blocks). The plain block that follows a Python block shows all that it prints; without one it prints
nothing. A `text` block that follows commands shows what they print, up to spaces. The page shows a
picture that its code saves as NAME by a link to `made/NAME`.
"""

import contextlib
import io
import re
import shlex
import traceback
from logging import getLogger
from pathlib import Path

DOCS = Path(__file__).parents[1]
PYTHON = re.compile(r"^```python\n(.*?)^```$(?:\s+^```\n(.*?)^```$)?", re.M | re.S)
COMMANDS = re.compile(r"^```sh\n(.*?)^```$(?:\s+^```text\n(.*?)^```$)?", re.M | re.S)
PICTURE = re.compile(r"\]\(made/([^)]+)\)")
ANGLES = re.compile(r"^```csv\n(.*?)^```$", re.M | re.S)


def wrong_examples(text):
    """Runs the Python blocks; yields what is shown and what was printed where they differ."""
    names = {}
    for code, shown in PYTHON.findall(text):
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            try:
                exec(code, names)
            except Exception:
                traceback.print_exc(file=printed)
        if printed.getvalue() != shown:
            yield shown, printed.getvalue()


def wrong_commands(text):
    """Runs the commands, likewise. `angles.csv` holds the file of angles that the page shows."""
    from rimroll.cli import main

    for angles in ANGLES.findall(text):
        Path("angles.csv").write_text(angles, "utf-8")
    for block, shown in COMMANDS.findall(text):
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            for command in block.replace("\\\n", " ").splitlines():
                program, *arguments = shlex.split(command)
                status = main(arguments) if program == "rimroll" else None
                if status != 0:
                    yield command, f"{program}: {status}"
        words = [
            [line.split() for line in output.strip().splitlines()]
            for output in (shown, printed.getvalue())
        ]
        if not words[1] or (shown and words[0] != words[1]):
            yield shown, printed.getvalue()


@contextlib.contextmanager
def folder_with_examples(folder):
    """Works in a folder that has the repository's examples."""
    folder.mkdir(parents=True, exist_ok=True)
    examples = folder / "examples"
    if not examples.exists():
        examples.symlink_to(DOCS.parent / "examples")
    with contextlib.chdir(folder):
        yield


def run(app, env, names):
    from sphinx.util import logging

    getLogger("fontTools").setLevel("WARNING")
    logger = logging.getLogger(__name__)
    for name in names:
        page = Path(env.doc2path(name))
        text = page.read_text("utf-8")
        if page.suffix != ".md" or not (PYTHON.search(text) or COMMANDS.search(text)):
            continue
        logger.info("running the code of %s", name)
        folder = DOCS.parent / "out/docs-work" / name
        with folder_with_examples(folder):
            for wrong in wrong_examples, wrong_commands:
                for shown, printed in wrong(text):
                    logger.warning("shows\n%sbut prints\n%s", shown, printed, location=name)
        for picture in PICTURE.findall(text):
            publish(folder / picture, page.parent / "made")


def publish(picture, target):
    """Puts a picture where the page looks for it."""
    target.mkdir(exist_ok=True)
    (target / picture.name).write_bytes(picture.read_bytes())


def setup(app):
    from pygments.lexers import TextLexer

    app.add_lexer("csv", TextLexer)
    app.connect("env-before-read-docs", run)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
