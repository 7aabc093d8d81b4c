"""A release says one thing everywhere: version, day, addresses, links."""

import re
import runpy
import zipfile
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
NOTES = runpy.run_path(str(ROOT / "tools/release_notes.py"))
README = runpy.run_path(str(ROOT / "tools/readme_for_pypi.py"))
LICENCES = runpy.run_path(str(ROOT / "tools/crate_licences.py"))
WHEELS = runpy.run_path(str(ROOT / "tools/paths_in_wheels.py"))

CARGO = '[workspace.package]\nversion = "1.2.0"\n'
CITATION = "title: x\nversion: 1.2.0\ndate-released: 2026-01-31\n"
CHANGELOG = """# Changelog

## [Unreleased]

## [1.2.0] - 2026-01-31

### Added
* A thing.

## [1.1.0] - 2025-12-24

* Another.

[Unreleased]: https://example.org
"""


def test_a_tag_that_agrees_with_every_file_is_released():
    assert NOTES["faults"]("v1.2.0", CARGO, CITATION, CHANGELOG) == []
    assert NOTES["section"](CHANGELOG, "[1.2.0] - 2026-01-31") == "### Added\n* A thing."
    assert NOTES["section"](CHANGELOG, "[1.1.0] - 2025-12-24") == "* Another."


@pytest.mark.parametrize(
    ("changed", "fault"),
    [
        ({"tag": "v1.2.1"}, "the tag is v1.2.1"),
        ({"citation": CITATION.replace("1.2.0", "1.1.0")}, "CITATION.cff has another version"),
        ({"citation": CITATION.replace("date-released", "date")}, "no line such as date-released"),
        ({"citation": CITATION.replace("-31", "-30")}, "nothing under ## [1.2.0] - 2026-01-30"),
        (
            {"changelog": CHANGELOG.replace("[Unreleased]\n", "[Unreleased]\n* New.\n")},
            "still has changes under ## [Unreleased]",
        ),
    ],
)
def test_what_disagrees_is_named(changed, fault):
    given = {"tag": "v1.2.0", "cargo": CARGO, "citation": CITATION, "changelog": CHANGELOG}
    (found,) = NOTES["faults"](**given | changed)
    assert fault in found


def test_the_changelog_says_what_is_new():
    changelog = (ROOT / "CHANGELOG.md").read_text("utf-8")
    headings = re.findall(r"^## (.*)$", changelog, re.M)
    assert headings[0] == "[Unreleased]"
    for heading in headings[1:]:
        assert re.fullmatch(r"\[\d+\.\d+\.\d+\] - \d{4}-\d{2}-\d{2}", heading)
        assert NOTES["section"](changelog, heading)
    for heading in headings:
        assert f"\n{heading.split(' - ')[0]}: https://" in changelog


def test_links_of_the_readme_are_addresses_on_pypi():
    repository = "https://github.com/someone/rimroll"
    text = (ROOT / "README.md").read_text("utf-8")
    absolute = README["absolute"](text, repository, "v1.2.0")
    links = re.findall(r"(!?)\[[^]]+\]\(([^)]+)\)", absolute)
    assert len(links) == len(re.findall(r"\]\(", text)) >= 10
    for picture, link in links:
        assert link.startswith("https://"), link
        tree = f"{repository}/blob/v1.2.0/"
        if picture:
            tree = "https://raw.githubusercontent.com/someone/rimroll/v1.2.0/"
            assert link.startswith(tree)
        if link.startswith(tree):
            assert (ROOT / link.removeprefix(tree)).is_file(), link
    assert README["absolute"](absolute, repository, "v1.2.0") == absolute


def test_a_wheel_holds_the_licences_of_all_that_is_compiled_into_it():
    """tools/crate_licences.py writes them again."""
    held = (ROOT / "LICENSE-CRATES").read_text("utf-8")
    assert held == LICENCES["text"]()


@pytest.mark.parametrize(
    "path",
    [
        b"/home/me/rimroll/src/lib.rs",
        b"C:\\Users\\me\\.cargo\\x.rs",
        b"/root/.cargo/a/b.rs",
        bytes(ROOT / "Cargo.toml"),
    ],
)
def test_paths_of_the_machine_that_built_a_wheel_are_found(tmp_path, path):
    wheel = tmp_path / "one.whl"
    with zipfile.ZipFile(wheel, "w") as file:
        file.writestr("core.so", b"\0\1" + path + b"\0")
    (found,) = WHEELS["paths"](wheel)
    assert found == f"core.so: {path.decode()}"


def test_other_slashes_are_no_paths(tmp_path):
    wheel = tmp_path / "one.whl"
    with zipfile.ZipFile(wheel, "w") as file:
        file.writestr("core.so", b"rimroll/crates/rimroll/src/lib.rs /rustc/0a1b/library/core.rs")
        file.writestr("a.py", b'"The folder /tmp/ and /home."')
    assert WHEELS["paths"](wheel) == []
