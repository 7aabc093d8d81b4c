"""Code in docs/ prints what the pages show, and their tables and pictures are those of the
report."""

import re
from pathlib import Path

import pytest
from run_pages import PICTURE, folder_with_examples, wrong_commands, wrong_examples

from rimroll.paper.figures import turn_against_friction

DOCS = Path(__file__).parents[2] / "docs"
FRICTION = DOCS / "how-friction-decides-the-turn.md"
PAGES = sorted(DOCS.rglob("*.md"))

each_page = pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)


def pages_with(language):
    found = [page for page in PAGES if f"\n```{language}\n" in page.read_text("utf-8")]
    return pytest.mark.parametrize("page", found, ids=lambda page: page.stem)


@pages_with("python")
def test_the_examples_of_a_page_run_in_order_and_print_what_it_shows(page, tmp_path):
    text = page.read_text("utf-8")
    with folder_with_examples(tmp_path):
        assert list(wrong_examples(text)) == []
    saved = {picture.name for picture in tmp_path.iterdir()}
    assert set(PICTURE.findall(text)) <= saved


@pages_with("sh")
def test_the_commands_of_a_page_run_in_order_and_say_what_it_shows(page, tmp_path):
    with folder_with_examples(tmp_path):
        assert list(wrong_commands(page.read_text("utf-8"))) == []


@each_page
def test_pictures_and_pages_that_a_page_links_to_are_there(page):
    text = re.sub(
        r"^```.*?^```|\$\$.*?\$\$|`[^`]*`", "", page.read_text("utf-8"), flags=re.M | re.S
    )
    for link in re.findall(r"\]\(([^)#]+)\)", text):
        made = link.startswith("made/")  # as the page's code saves it
        assert link.startswith("https://") or made or (page.parent / link).is_file(), link


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
