"""Addresses of the project, and what the paper cites, are the same everywhere."""

import re
import subprocess
import tomllib
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]


def text(name):
    return (ROOT / name).read_text("utf-8")


def address(name):
    return tomllib.loads(text("pyproject.toml"))["project"]["urls"][name]


def test_the_manifests_give_the_same_addresses():
    package = tomllib.loads(text("Cargo.toml"))["workspace"]["package"]
    assert package["repository"] == address("Repository")
    assert package["homepage"] == address("Homepage")
    citation = text("CITATION.cff")
    assert f'\nrepository-code: "{address("Repository")}"\n' in citation
    assert f'\nurl: "{address("Homepage")}"\n' in citation
    for crate in ROOT.glob("crates/*/Cargo.toml"):
        manifest = tomllib.loads(crate.read_text("utf-8"))["package"]
        assert manifest["repository"] == manifest["homepage"] == {"workspace": True}


@pytest.mark.skipif(not (ROOT / ".git").exists(), reason="lists the files that git tracks")
def test_an_owner_finds_every_file_that_holds_an_address():
    """As docs/releasing.md lists them. Tests may name them, too."""
    listed = re.search(r"<!-- addresses -->(.*?)<!-- end -->", text("docs/releasing.md"), re.S)[1]
    owner, name = address("Repository").split("/")[-2:]
    pattern = rf"github\.com/{owner}/{name}|{owner}\.github\.io"
    git = ["git", "-c", "safe.directory=*"]
    found = subprocess.run(
        [*git, "grep", "--cached", "--files-with-matches", "-E", pattern, "--", ".", ":!tests"],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=True,
    )
    rows = set(re.findall(r"^ *\| `([^`]+)` \|", listed, re.M))
    held = set(found.stdout.splitlines())
    assert rows == held, "docs/releasing.md is to list the files that hold an address"


def test_the_paper_cites_what_its_list_holds():
    paper, listed = text("paper.md"), text("paper.bib")
    keys = re.findall(r"^@\w+\{(\w+),$", listed, re.M)
    assert sorted(set(re.findall(r"@(\w+)", paper))) == sorted(keys)
    for entry in listed.split("\n\n"):
        assert re.search(r"\b(doi|url) += \{", entry), entry


def test_the_paper_is_cited_by_one_identifier():
    doi = re.search(r"doi: (\S+)", text("CITATION.cff"))[1]
    assert f"doi     = {{{doi}}}" in text("paper.bib")
    assert f"https://doi.org/{doi}" in text("web/index.html")


@pytest.mark.parametrize("page", ["good-first-tasks", "releasing"])
def test_the_files_that_a_page_for_contributors_names_exist(page):
    named = re.findall(r"`((?:crates|python|tests|tools|web)/[\w./-]+)`", text(f"docs/{page}.md"))
    assert named
    for name in named:
        assert (ROOT / name).exists(), name
