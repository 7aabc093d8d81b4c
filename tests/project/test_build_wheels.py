"""`make wheels` refuses what must not be released, and links for Pyodide without Emscripten."""

import importlib.util
import os
import random
import runpy
import subprocess
import sys
import tarfile
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
LINKER = runpy.run_path(str(ROOT / "tools/pyodide_linker.py"))


@pytest.fixture
def tool(tmp_path, monkeypatch):
    """The module, which writes into a folder of the test."""
    spec = importlib.util.spec_from_file_location("tool", ROOT / "tools/build_wheels.py")
    module = importlib.util.module_from_spec(spec)
    monkeypatch.setitem(sys.modules, "tool", module)
    spec.loader.exec_module(module)
    (tmp_path / "dist").mkdir()
    monkeypatch.setattr(module, "DIST", tmp_path / "dist")
    return module


def archive(folder, content):
    """A source distribution with one file."""
    (folder / "lib.rs").write_bytes(content)
    with tarfile.open(folder / "rimroll-0.1.0.tar.gz", "w:gz") as file:
        file.add(folder / "lib.rs", "lib.rs")
    return folder / "rimroll-0.1.0.tar.gz"


def test_a_file_that_is_as_it_must_be_is_kept_and_described(tool, tmp_path):
    sdist = archive(tmp_path, b"fn main() {}")
    came = tool.made(tool.Build(0.1, untried="needs nothing"), sdist, tmp_path)
    assert came == "0.00 MB of 0.1, not tried: needs nothing"
    assert (tmp_path / "dist" / sdist.name).read_bytes() == sdist.read_bytes()


@pytest.mark.parametrize(
    ("content", "fault"),
    [
        (random.Random(1).randbytes(5000), r"more than 0\.004"),
        (os.fsencode(ROOT / "src/lib.rs"), "paths_in_wheels"),
    ],
)
def test_a_file_that_is_too_large_or_contains_paths_is_refused(tool, tmp_path, content, fault):
    sdist = archive(tmp_path, content)
    with pytest.raises(tool.Failed, match=fault):
        tool.made(tool.Build(0.004, untried="needs nothing"), sdist, tmp_path)


def test_an_unknown_name_is_refused_before_anything_is_built(tool, tmp_path, capsys):
    (tmp_path / "dist/old.whl").touch()
    assert tool.main(["sdist", "freebsd"]) == 2
    assert "unknown: freebsd; choose from sdist, manylinux-x86_64" in capsys.readouterr().out
    assert (tmp_path / "dist/old.whl").exists()


def test_a_tool_that_is_missing_is_named(tool):
    with pytest.raises(tool.Failed, match="rustup-of-nobody is missing"):
        tool.run("rustup-of-nobody", "target", "add", "wasm32-unknown-emscripten")


def test_a_side_module_is_linked_by_the_linker_of_rust():
    given = ["-s", 'EXPORTED_FUNCTIONS=["_PyInit__core"]', "a.o", "b.rlib", "-B/rust/gcc-ld"]
    command = LINKER["command"]([*given, "-o", "_core.wasm", "-sSIDE_MODULE=2", "-O3"])
    assert command[0] == str(Path("/rust/gcc-ld/wasm-ld"))
    assert {"-shared", "--experimental-pic", "--export=PyInit__core"} < set(command)
    assert command[-4:] == ["a.o", "b.rlib", "-o", "_core.wasm"]


def test_what_is_no_side_module_is_not_linked():
    with pytest.raises(ValueError, match="side module"):
        LINKER["command"](["a.o", "-o", "a.js"])


def test_the_core_alone_passes_its_smoke_test():
    run = subprocess.run(
        [sys.executable, ROOT / "tools/smoke_test_core.py"], capture_output=True, text=True
    )
    assert run.returncode == 0, run.stderr
    assert run.stdout.startswith("passed: ")
