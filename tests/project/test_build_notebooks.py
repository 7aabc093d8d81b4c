"""The packages that notebooks in the page load are complete, unchanged, and no more than needed."""

import hashlib
import json
import re
import zipfile
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]


@pytest.fixture
def tool():
    spec = spec_from_file_location("build_notebooks", ROOT / "tools/build_notebooks.py")
    module = module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def write_wheel(folder, name, *requires):
    """A wheel with one module."""
    folder.mkdir(parents=True, exist_ok=True)
    wheel = folder / f"{name}-1.0-py3-none-any.whl"
    lines = ["Metadata-Version: 2.1", f"Name: {name}", "Version: 1.0"]
    lines += [f"Requires-Dist: {text}" for text in requires]
    with zipfile.ZipFile(wheel, "w") as archive:
        archive.writestr(f"{name}/__init__.py", "")
        archive.writestr(f"{name}/data/table.csv", "")
        archive.writestr(f"{name}-1.0.dist-info/METADATA", "\n".join(lines) + "\n")
    return wheel


@pytest.fixture
def pyodide(tool, tmp_path):
    """A folder like a distribution of Pyodide, with packages of which some are not needed."""
    folder = tmp_path / "pyodide"
    needs = {"comm": [], "ipython": ["traitlets"], "traitlets": [], "jedi": [], "micropip": []}
    needs |= {"numpy": [], "big": ["numpy"]}
    packages = {
        name: tool.locked(write_wheel(folder, name, *requires)) for name, requires in needs.items()
    }
    (folder / tool.LOCK).write_text(json.dumps({"info": {}, "packages": packages}))
    for name in tool.CORE:
        (folder / name).write_bytes(name.encode())
    return folder


def test_a_notebook_finds_rimroll_and_all_that_it_needs_but_no_more(tool, pyodide, tmp_path):
    wheel = write_wheel(tmp_path / "dist", "rimroll", "numpy>=2", 'pytest; extra == "dev"')
    made = tmp_path / "made"
    tool.write_pyodide(str(pyodide), wheel, made)
    packages = json.loads((made / tool.LOCK).read_text())["packages"]
    assert set(packages) == {*tool.ROOTS, "traitlets", "numpy"}
    assert packages["rimroll"]["imports"] == ["rimroll"]
    assert packages["rimroll"]["depends"] == ["numpy"]
    for package in packages.values():
        content = (made / package["file_name"]).read_bytes()
        assert hashlib.sha256(content).hexdigest() == package["sha256"]
    assert {file.name for file in made.iterdir()} == {
        tool.LOCK,
        *tool.CORE,
        *(package["file_name"] for package in packages.values()),
    }


def test_a_package_that_is_not_the_one_named_is_refused(tool, pyodide, tmp_path):
    wheel = write_wheel(tmp_path / "dist", "rimroll", "numpy")
    with (pyodide / "numpy-1.0-py3-none-any.whl").open("ab") as file:
        file.write(b"changed")
    with pytest.raises(SystemExit, match=r"numpy-1\.0-py3-none-any\.whl is not the file"):
        tool.write_pyodide(str(pyodide), wheel, tmp_path / "made")


def test_requirements_of_other_systems_are_left_out(tool, tmp_path):
    requires = 'colorama; sys_platform == "win32"', 'Tz.Data; sys_platform == "emscripten"'
    assert tool.required(write_wheel(tmp_path, "one", *requires)) == {"tz-data"}


def test_the_site_has_the_pyodide_for_which_the_wheel_is_tried():
    site = (ROOT / "docs/releasing.md").read_text("utf-8")
    tried = (ROOT / "tools/try_wheel.sh").read_text("utf-8")
    version = re.search(r"pyodide/v([\d.]+)/", site)[1]
    assert f"pyodide@{version}\n" in tried
