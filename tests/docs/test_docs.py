"""Code in docs/ prints what the pages show, and their tables and pictures are those of the
report."""

import contextlib
import io
import re
import shlex
from pathlib import Path

import pytest

from rimroll.cli import main
from rimroll.paper.figures import turn_against_friction

DOCS = Path(__file__).parents[2] / "docs"
FRICTION = DOCS / "how-friction-decides-the-turn.md"


@pytest.mark.parametrize("page", sorted(DOCS.glob("*.md")), ids=lambda page: page.stem)
def test_the_examples_of_a_page_run_in_order_and_print_what_it_shows(page):
    examples = re.findall(r"```python\n(.*?)```\s+```\n(.*?)```", page.read_text("utf-8"), re.S)
    names: dict[str, object] = {}
    for code, output in examples:
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            exec(code, names)
        assert printed.getvalue() == output


@pytest.mark.parametrize("page", sorted(DOCS.glob("*.md")), ids=lambda page: page.stem)
def test_the_commands_of_a_page_run_in_order_and_say_what_it_shows(
    page, tmp_path, monkeypatch, capsys
):
    """Runs in a temporary folder with the examples and the file of angles that the page shows."""
    (tmp_path / "examples").symlink_to(DOCS.parent / "examples")
    monkeypatch.chdir(tmp_path)
    text = page.read_text("utf-8")
    for angles in re.findall(r"```csv\n(.*?)```", text, re.S):
        (tmp_path / "angles.csv").write_text(angles, "utf-8")
    for block, _, shown in re.findall(r"```sh\n(.*?)```(\s+```text\n(.*?)```)?", text, re.S):
        for command in block.splitlines():
            program, *arguments = shlex.split(command)
            assert program == "rimroll"
            assert main(arguments) == 0
        output = capsys.readouterr().out
        assert output
        if shown:
            assert _words(output) == _words(shown)


def _words(text: str) -> list[list[str]]:
    """Compares line by line, without spaces at the ends."""
    return [line.split() for line in text.strip().splitlines()]


@pytest.mark.parametrize("page", sorted(DOCS.glob("*.md")), ids=lambda page: page.stem)
def test_pictures_and_pages_that_a_page_links_to_are_there(page):
    for link in re.findall(r"\]\(([^)#]+)\)", page.read_text("utf-8")):
        assert link.startswith("https://") or (DOCS / link).is_file(), link


def test_the_table_of_turns_against_friction_is_the_report_s():
    _, below = FRICTION.read_text("utf-8").split("<!-- the report's table -->\n")
    lines = below.split("\n\n")[0].splitlines()
    head, _, *rows = [[cell.strip() for cell in line.strip("|").split("|")] for line in lines]
    table = turn_against_friction.table()
    assert head == table.head
    assert rows == table.rows


def test_the_frictions_of_the_falls_are_the_report_s():
    text = " ".join(FRICTION.read_text("utf-8").split())
    (left,), (right,) = (turn_against_friction.friction_for_fall(turn) for turn in (213.0, 217.9))
    assert f"μ = {left:.3f} for 213.0° and {right:.3f} for 217.9°" in text
