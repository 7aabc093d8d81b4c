"""`rimroll reproduce`: the whole report, and interruptions."""

import json
import re

import pytest

import rimroll as rr
from rimroll.paper import report
from rimroll.paper.figures import FIGURES
from rimroll.paper.report import reproduce


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    folder = tmp_path_factory.mktemp("report") / "paper"
    steps = []
    page = reproduce(folder, lambda done, total, what: steps.append((done, total, what)))
    assert page == folder / "index.html"
    assert [done for done, _, _ in steps] == list(range(len(FIGURES) + 4))
    assert all(done <= total for done, total, _ in steps)
    return folder


def test_the_page_carries_all_that_it_shows(folder):
    page = (folder / "index.html").read_text(encoding="utf-8")
    sources = re.findall(r'src="([^"]{0,40})', page)
    assert len(sources) == len(FIGURES) + 1
    assert all(source.startswith("data:image/") for source in sources)
    assert not re.search(r"<(script|link|iframe)|url\(|@import", page)
    linked = set(re.findall(r'href="([^"#]+)"', page))
    # A reader may follow a reference; the page itself loads nothing.
    cited = {link for link in linked if link.startswith("https://arxiv.org/abs/")}
    assert all((folder / name).is_file() for name in linked - cited)


def test_every_figure_is_there_as_svg_and_png(folder):
    vectors = {path.stem for path in folder.glob("*.svg")}
    assert len(vectors) == len(FIGURES)
    assert vectors == {path.stem for path in folder.glob("*.png")}
    for path in folder.glob("*.png"):
        assert path.read_bytes().startswith(b"\x89PNG")


def test_the_page_says_that_the_printed_formula_is_upside_down(folder):
    page = (folder / "index.html").read_text(encoding="utf-8")
    assert "The printed no-slip formula is upside down" in page
    assert "202.29°" in page
    assert "160.17" in page


def test_every_anchor_of_the_page_leads_somewhere(folder):
    page = (folder / "index.html").read_text(encoding="utf-8")
    anchors = set(re.findall(r'href="#([^"]+)"', page))
    assert anchors <= set(re.findall(r'id="([^"]+)"', page))


def test_the_numbers_are_those_of_the_library(folder):
    numbers = json.loads((folder / "numbers.json").read_text())
    assert numbers["rimroll_version"] == rr.__version__
    assert len(numbers["figures"]) == len(FIGURES)
    verdicts = {claim["verdict"] for claim in numbers["claims"]}
    assert verdicts == {"agrees", "cut, not rounded", "differs", "input", "measured"}
    assert len(numbers["errata"]) == 19


def test_only_whole_files_are_left_when_the_report_is_interrupted(tmp_path):
    def interrupt(done, total, what):
        if done == 2:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        reproduce(tmp_path / "paper", interrupt)
    left = {path.name for path in (tmp_path / "paper").iterdir()}
    assert "index.html" not in left
    assert "numbers.json" not in left
    assert all(not name.startswith(".") for name in left)


def test_a_full_disk_leaves_no_half_page(tmp_path, monkeypatch):
    def full(*_, **__):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(report, "_page", full)
    monkeypatch.setattr(report, "FIGURES", FIGURES[:1])
    monkeypatch.setattr(report, "animate", lambda motion, path, **_: path.write_bytes(b"GIF"))
    with pytest.raises(OSError, match="No space left"):
        reproduce(tmp_path)
    assert not (tmp_path / "index.html").exists()


def test_a_folder_that_cannot_be_made_is_refused_in_a_line(tmp_path):
    (tmp_path / "taken").write_text("a file")
    with pytest.raises(rr.RimrollError, match="cannot make the folder"):
        reproduce(tmp_path / "taken")
