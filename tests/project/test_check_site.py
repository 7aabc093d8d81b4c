"""tools/check_site.py finds what is wrong with a built site."""

import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]


def check(folder, body):
    (folder / "index.html").write_text(f"<html><body>{body}</body></html>", "utf-8")
    (folder / "other.html").write_text('<p id="here">', "utf-8")
    return subprocess.run(
        [sys.executable, ROOT / "tools/check_site.py", folder], capture_output=True, text=True
    )


@pytest.mark.parametrize(
    "body",
    [
        '<a href="other.html#here">',
        '<a href="https://example.org">',
        '<img src="data:image/png;base64,AAAA">',
        '<link rel="canonical" href="https://example.org">',
    ],
)
def test_a_sound_site_passes(tmp_path, body):
    run = check(tmp_path, body)
    assert (run.returncode, run.stderr) == (0, "")


@pytest.mark.parametrize(
    ("body", "fault"),
    [
        ('<a href="gone.html">', "links to gone.html, which is not there"),
        ('<a href="other.html#gone">', "links to other.html#gone, which has no such place"),
        ('<img src="gone.png">', "links to gone.png, which is not there"),
        ('<script src="https://example.org/x.js">', "loads https://example.org/x.js"),
        ('<link rel="stylesheet" href="//example.org/x.css">', "loads //example.org/x.css"),
    ],
)
def test_a_broken_link_and_a_file_from_elsewhere_are_found(tmp_path, body, fault):
    run = check(tmp_path, body)
    assert run.returncode == 1
    assert run.stderr == f"index.html {fault}\n"


@pytest.mark.parametrize(
    ("page", "is_checked"),
    [
        ("lab.html", True),
        ("paper.html", True),
        ("reference/rust.html", True),
        ("lab/index.html", False),
        ("notebooks/lab/index.html", False),
        ("paper/index.html", False),
        ("reference/rust/index.html", False),
    ],
)
def test_only_folders_that_other_builds_check_are_passed_over(tmp_path, page, is_checked):
    path = tmp_path / page
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text('<a href="gone.html">', "utf-8")
    fault = f"{page} links to gone.html, which is not there\n" if is_checked else ""
    assert check(tmp_path, "").stderr == fault
