"""The package rimroll-score is built whole, with its licences, and what is not is refused."""

import ast
import importlib.util
import re
import sys
import tomllib
import zipfile
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]


@pytest.fixture
def tool(tmp_path, monkeypatch):
    """The module, which writes into a folder of the test."""
    spec = importlib.util.spec_from_file_location("tool", ROOT / "tools/build_score.py")
    module = importlib.util.module_from_spec(spec)
    monkeypatch.setitem(sys.modules, "tool", module)
    spec.loader.exec_module(module)
    monkeypatch.setattr(module, "DIST", tmp_path / "dist")
    return module


def wheel(folder, names, content=b"x"):
    file = folder / "rimroll_score-0.1.0-py3-none-any.whl"
    with zipfile.ZipFile(file, "w") as archive:
        for name in names:
            archive.writestr(name, content)
    return file


WHOLE = ["a/licenses/LICENSE-MIT", "a/licenses/LICENSE-APACHE", "b/cases.toml", "b/page.html"]


def test_a_whole_wheel_passes_and_one_without_a_licence_is_refused(tool, tmp_path):
    tool.check(wheel(tmp_path, WHOLE))
    with pytest.raises(tool.Failed, match="lacks LICENSE-MIT"):
        tool.check(wheel(tmp_path, WHOLE[1:]))


def test_a_wheel_that_is_too_large_is_refused(tool, tmp_path, monkeypatch):
    monkeypatch.setattr(tool, "LARGEST", 0.1)
    with pytest.raises(tool.Failed, match=r"more than 0\.1"):
        tool.check(wheel(tmp_path, WHOLE))


def test_licences_are_those_of_rimroll():
    for name in "LICENSE-MIT", "LICENSE-APACHE":
        assert (ROOT / "score" / name).read_bytes() == (ROOT / name).read_bytes()
    mine, own = (
        tomllib.loads((ROOT / name).read_text("utf-8"))["project"]["license"]
        for name in ("score/pyproject.toml", "pyproject.toml")
    )
    assert mine == own


def test_every_package_that_is_imported_is_declared():
    """Engines are no dependencies: each adapter loads its own where it is installed."""
    imported = set()
    folder = ROOT / "score/src/rimroll_score"
    for file in folder.glob("*.py"):
        for node in ast.walk(ast.parse(file.read_text("utf-8"))):
            if isinstance(node, ast.Import):
                imported |= {alias.name.split(".")[0] for alias in node.names}
            elif isinstance(node, ast.ImportFrom):
                imported.add(node.module.split(".")[0])
    needed = {"pillow" if name == "PIL" else name for name in imported - sys.stdlib_module_names}
    score = tomllib.loads((ROOT / "score/pyproject.toml").read_text("utf-8"))["project"]
    declared = {re.split("[<>=]", name)[0] for name in score["dependencies"]}
    assert needed - {"rimroll_score"} == declared
