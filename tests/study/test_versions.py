"""Builds of rimroll that have the same version number are told apart."""

import shutil
from pathlib import Path

import pytest

import rimroll
from rimroll.study.versions import build, hash_of, versions

PACKAGE = Path(rimroll.__file__).parent


@pytest.fixture
def package(tmp_path):
    """A copy of a part of rimroll, with its core."""
    core = next(file for file in PACKAGE.glob("_core*") if file.suffix != ".pyi")
    (tmp_path / "study").mkdir()
    for file in (core, PACKAGE / "state.py", PACKAGE / "study" / "draws.py"):
        shutil.copy(file, tmp_path / file.relative_to(PACKAGE))
    return tmp_path


def changed(file):
    content = bytearray(file.read_bytes())
    content[len(content) // 2] ^= 1
    file.write_bytes(content)


def renamed(file):
    file.rename(file.with_name("other.py"))


@pytest.mark.parametrize("change", [changed, Path.unlink, renamed])
@pytest.mark.parametrize("pattern", ["state.py", "study/draws.py", "_core*"])
def test_any_change_of_the_code_makes_another_build(package, change, pattern):
    before = hash_of(package)
    change(next(package.glob(pattern)))
    assert hash_of(package) != before


def test_what_is_no_code_makes_no_difference(package):
    before = hash_of(package)
    (package / "_core.pyi").write_text("...")
    (package / "notes.txt").write_text("...")
    assert hash_of(package) == before


def test_the_build_is_that_of_the_package_and_is_known_to_stores():
    assert build() == hash_of(PACKAGE)
    assert versions()["rimroll_build"] == build()
