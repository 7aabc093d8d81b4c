"""The set-up: one line says what a machine lacks, and versions agree."""

import ast
import json
import os
import re
import shutil
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]

RUSTC = """echo 'rustc {}.0 (0a1b2c3d4 2020-01-01)'"""
PYTHON = """case "$2" in
    *base_executable*) echo "$0" ;;
    *ensurepip*) exit {no_venv:d} ;;
    *) echo {version} ;;
esac"""


@pytest.fixture
def machine(tmp_path):
    """A machine with only what a test gives it: `has(name, script)`; `check()` runs the check."""

    class Machine:
        path = tmp_path / "bin"

        def has(self, name, script="exit 0"):
            tool = self.path / name
            tool.write_text(f"#!/bin/sh\n{script}\n")
            tool.chmod(0o755)

        def has_python(self, version, name="python3", no_venv=False):
            self.has(name, PYTHON.format(version=version, no_venv=no_venv))

        def lacks(self, name):
            (self.path / name).unlink()

        def check(self, **environment):
            return subprocess.run(
                ["/bin/sh", ROOT / "tools/toolchain.sh"],
                env={"PATH": str(self.path), **environment},
                capture_output=True,
                text=True,
            )

        def complaint(self, **environment):
            """The one line that the check ends with."""
            run = self.check(**environment)
            assert run.returncode != 0
            assert run.stdout == ""
            assert re.fullmatch(r"rimroll: .+\n", run.stderr), run.stderr
            return run.stderr

    machine = Machine()
    machine.path.mkdir()
    for tool in "sed", "dirname":
        (machine.path / tool).symlink_to(shutil.which(tool))
    machine.has("cargo")
    machine.has("rustc", RUSTC.format("1.95"))
    machine.has("cc")
    machine.has_python("3.12")
    return machine


def test_on_a_complete_machine_there_is_no_message_and_its_python_is_chosen(machine):
    run = machine.check()
    assert (run.returncode, run.stderr) == (0, "")
    assert run.stdout == f"{machine.path}/python3\n"


@pytest.mark.parametrize("tool", ["cargo", "rustc"])
def test_without_rust_one_line_says_how_to_get_it(machine, tool):
    machine.lacks(tool)
    assert re.search(r"Rust is missing.*1\.\d+ or newer.*rustup", machine.complaint())


@pytest.mark.parametrize("version", ["1.63", "1.9", "0.99"])
def test_an_old_rust_is_named_with_what_is_needed(machine, version):
    machine.has("rustc", RUSTC.format(version))
    assert f"Rust {version} is too old" in machine.complaint()


@pytest.mark.parametrize("version", ["1.100", "2.0"])
def test_a_later_rust_will_do(machine, version):
    machine.has("rustc", RUSTC.format(version))
    assert machine.check().returncode == 0


def test_a_rustup_without_a_toolchain_is_one_line(machine):
    machine.has("rustc", "echo 'error: no default toolchain' >&2; exit 1")
    assert "rustup default stable" in machine.complaint()


def test_without_a_linker_one_line_says_what_to_install(machine):
    machine.lacks("cc")
    assert "apt install gcc" in machine.complaint()


def test_without_python_one_line_says_what_to_install(machine):
    machine.lacks("python3")
    assert re.search(r"Python is missing.*Python 3\.11 or newer", machine.complaint())


@pytest.mark.parametrize("version", ["3.10", "3.9", "2.7"])
def test_an_old_python_is_named_with_what_is_needed(machine, version):
    machine.has_python(version)
    assert f"Python {version} is too old" in machine.complaint()


def test_a_newer_python_beside_an_old_one_is_found(machine):
    machine.has_python("3.9")
    machine.has_python("3.13", name="python3.13")
    assert machine.check().stdout == f"{machine.path}/python3.13\n"


def test_a_python_that_does_not_run_is_passed_over(machine):
    machine.has("python3", "echo 'python3: command not found' >&2; exit 127")
    machine.has_python("3.11", name="python3.11")
    assert machine.check().stdout == f"{machine.path}/python3.11\n"


def test_a_python_without_venv_says_which_package_has_it(machine):
    machine.has_python("3.11", no_venv=True)
    assert "apt install python3.11-venv" in machine.complaint()


def test_only_the_named_python_is_tried(machine):
    machine.has_python("3.10", name="mine")
    assert "Python 3.10 is too old" in machine.complaint(PYTHON="mine")
    assert "no-such-python is missing" in machine.complaint(PYTHON="no-such-python")
    machine.has_python("3.14", name="mine")
    assert machine.check(PYTHON="mine").stdout == f"{machine.path}/mine\n"


def test_make_says_no_more_than_the_one_line_and_its_own(machine):
    machine.lacks("cargo")
    tree = machine.path.parent / "a tree"
    tree.mkdir()
    for name in "Makefile", "Cargo.toml", "pyproject.toml", "constraints.txt":
        shutil.copy(ROOT / name, tree)
    shutil.copytree(ROOT / "tools", tree / "tools")
    for tool in "cat", "find", "sh":
        (machine.path / tool).symlink_to(shutil.which(tool))
    for crate in "rimroll", "rimroll-py", "rimroll-wasm":
        (tree / "crates" / crate / "src").mkdir(parents=True)
        (tree / "crates" / crate / "Cargo.toml").touch()
    for folder in "python/rimroll", "web/src", "web/public", "web/licences":
        (tree / folder).mkdir(parents=True)
    run = subprocess.run(
        [shutil.which("make"), "test"],
        cwd=tree,
        env={"PATH": str(machine.path)},
        capture_output=True,
        text=True,
    )
    assert run.returncode != 0
    complaint, make = run.stderr.splitlines()
    assert complaint.startswith("rimroll: Rust is missing")
    assert make.startswith("make: ***")
    assert run.stdout == ""


def test_constraints_pin_every_package_and_name_no_address():
    lines = (ROOT / "constraints.txt").read_text().splitlines()
    pins = [line for line in lines if not line.startswith("#")]
    for line in pins:
        assert re.fullmatch(r"[a-z0-9-]+==[0-9][0-9a-z.]*", line), line
    pinned = {line.split("==")[0] for line in pins}
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())
    requirements = project["project"]["dependencies"] + project["dependency-groups"]["dev"]
    score = tomllib.loads((ROOT / "score/pyproject.toml").read_text())
    requirements += score["build-system"]["requires"]
    assert {re.split("[<>=]", requirement)[0] for requirement in requirements} <= pinned


def test_every_package_that_is_imported_is_declared():
    """Indirect dependencies may be missing or too old."""
    imported = set()
    for file in (ROOT / "python").rglob("*.py"):
        for node in ast.walk(ast.parse(file.read_text("utf-8"))):
            if isinstance(node, ast.Import):
                imported |= {alias.name.split(".")[0] for alias in node.names}
            elif isinstance(node, ast.ImportFrom) and not node.level:
                imported.add(node.module.split(".")[0])
    own = {"rimroll", "rimroll_command", "rimroll_score"}
    type_checkers_only = {"typing_extensions"}
    packages = imported - sys.stdlib_module_names - own - type_checkers_only
    distributions = {
        "PIL": "pillow",
        "mpl_toolkits": "matplotlib",
        "pydantic_core": "pydantic",  # pydantic asks for exactly one version of it
    }
    needed = {distributions.get(package, package) for package in packages}
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    extra = project["optional-dependencies"]["cluster"]
    declared, optional = (
        {re.split("[<>=]", requirement)[0] for requirement in requirements}
        for requirements in (project["dependencies"], extra)
    )
    assert needed - optional == declared
    assert optional - needed <= {"dask"}  # distributed runs its tasks, xarray reads by it
    table = re.search(r"\n\| Python \|.*\n\| page \|", (ROOT / "CONTRIBUTING.md").read_text(), re.S)
    assert table and all(f"`{name}`" in table[0] for name in needed)


def test_one_version_everywhere():
    version = tomllib.loads((ROOT / "Cargo.toml").read_text())["workspace"]["package"]["version"]
    crates = list(ROOT.glob("crates/*/Cargo.toml"))
    assert crates
    for crate in crates:
        package = tomllib.loads(crate.read_text())["package"]
        assert package["version"] == {"workspace": True}, crate
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    assert "version" in project["dynamic"] and "version" not in project  # maturin takes Cargo's
    assert f"\nversion: {version}\n" in (ROOT / "CITATION.cff").read_text()
    score = tomllib.loads((ROOT / "score/pyproject.toml").read_text())["project"]
    assert score["version"] == version
    assert f"rimroll=={version}" in score["dependencies"]
    for name in "package.json", "package-lock.json":
        assert json.loads((ROOT / "web" / name).read_text())["version"] == version, name


@pytest.mark.parametrize("script", [".ci/run", *sorted(ROOT.glob("tools/*.sh"))])
def test_scripts_can_be_run(script):
    assert os.access(ROOT / script, os.X_OK)
    shell = (ROOT / script).read_text().splitlines()[0].split("/")[-1].split()[-1]
    subprocess.run([shell, "-n", ROOT / script], check=True)


def test_every_folder_of_tests_is_run_by_make_test_but_the_proofs():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())
    files = [*ROOT.glob("tests/*/test_*.py"), *ROOT.glob("score/tests/test_*.py")]
    folders = {file.parent.relative_to(ROOT).as_posix() for file in files}
    assert folders - {*project["tool"]["pytest"]["ini_options"]["testpaths"]} == {"tests/proofs"}
