"""The documentation site has a place for every page and for every public name.

`make docs` builds it, and fails on a broken link or an example that prints something else.
"""

import re
from pathlib import Path
from types import ModuleType

import pytest

import rimroll

DOCS = Path(__file__).parents[2] / "docs"
PAGES = {page for end in ("md", "rst") for page in DOCS.rglob(f"*.{end}")}
MARKDOWN = re.compile(r"^```\{toctree\}\n(.*?)^```", re.M | re.S)
RESTRUCTURED = re.compile(r"^\.\. toctree::\n((?:   .*\n|\n)*)", re.M)
DESCRIBED = re.compile(r"^\.\. auto(?:class|function|exception|data|module):: (\S+)", re.M)


def entries(page):
    """The pages in the tables of contents of a page."""
    text = page.read_text("utf-8")
    for tree in MARKDOWN.findall(text) + RESTRUCTURED.findall(text):
        for line in tree.split("\n"):
            name = line.strip()
            if name and not name.startswith(":"):
                (found,) = PAGES & {page.parent / f"{name}.{end}" for end in ("md", "rst")}
                yield found


def reached(page):
    found = {page}
    for entry in entries(page):
        found |= reached(entry)
    return found


def test_every_page_is_reached_from_the_first_by_tables_of_contents():
    assert reached(DOCS / "index.md") == PAGES


def public_names():
    """The public names; a module has its own, such as rimroll.laws.surfaces."""
    public = {name: getattr(rimroll, name) for name in rimroll.__all__}
    return {
        one.__name__ if isinstance(one, ModuleType) else f"rimroll.{name}"
        for name, one in public.items()
    }


def test_every_public_name_is_described_once():
    texts = [page.read_text("utf-8") for page in DOCS.glob("reference/python/*.rst")]
    described = [name for text in texts for name in DESCRIBED.findall(text)]
    assert public_names() <= set(described)
    assert len(described) == len(set(described))


def test_the_overview_lists_what_the_pages_describe():
    overview = (DOCS / "reference/python/index.rst").read_text("utf-8")
    listed = set(re.findall(r"^   (rimroll\.[\w.]+)$", overview, re.M))
    public = public_names() - {"rimroll.__version__"}
    assert public <= listed
    # The others are functions of public modules, such as rimroll.gyro.phone.
    assert {name.rpartition(".")[0] for name in listed - public} <= public


@pytest.mark.parametrize("file", ["CONTRIBUTING.md", "CHANGELOG.md", "SECURITY.md"])
def test_files_of_the_repository_are_pages(file):
    pages = [page.read_text("utf-8") for page in DOCS.glob("project/*.md")]
    assert f"<!-- file: {file} -->\n" in pages
