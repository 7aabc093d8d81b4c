"""Starting rimroll loads little, and every public name is found."""

import ast
import inspect
import subprocess
import sys
from importlib import import_module
from pathlib import Path

import pytest

import rimroll as rr
from rimroll.cli.commands import COMMANDS

HELP = {"typer", "annotated_doc", "shellingham"}
"""typer, and the packages that it loads."""

LOADED = {
    "import rimroll": set(),
    "import rimroll as rr; rr.simulate; rr.ensemble; rr.bodies.can_2007()": {"numpy"},
    "--version": HELP,
    "--help": HELP,
    "turn can_2007": {*HELP, "numpy", "rich"},
    "turn --friction 0.2 --tilt 30deg --yaw-rate 0.005": {*HELP, "numpy", "rich"},
    "bodies": {*HELP, "numpy", "rich"},
}
"""The packages, besides Python's own, that a program or a command may load."""


@pytest.mark.parametrize("what", LOADED)
def test_only_what_is_needed_is_loaded(what):
    program = what if "import" in what else f"from rimroll.cli import main; main({what.split()})"
    show = "import sys; print(*{name.split('.')[0] for name in sys.modules})"
    # Without site, which loads packages that some .pth files name.
    path = f"import sys; sys.path[:0] = {[path for path in sys.path if path]}"
    run = subprocess.run(
        [sys.executable, "-S", "-c", "\n".join((path, program, show))],
        capture_output=True,
        text=True,
        check=True,
    )
    loaded = set(run.stdout.splitlines()[-1].split()) - sys.stdlib_module_names
    ours = {"__main__", "rimroll"}
    assert {name for name in loaded if not name.startswith("_sysconfig")} - ours <= LOADED[what]


@pytest.mark.parametrize("command", ["turn can_2007", "topple -n 2 --json"])
def test_commands_on_a_table_at_rest_load_no_motions_of_the_ground(command):
    program = (
        f"from rimroll.cli import main; main({command.split()}); import sys; print(*sys.modules)"
    )
    run = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=True
    )
    loaded = run.stdout.splitlines()[-1].split()
    assert "rimroll.motion" in loaded
    assert "rimroll.ground" not in loaded


def test_the_names_that_type_checkers_see_are_there():
    stub = Path(rr.__file__).with_suffix(".pyi").read_text()
    seen = {
        alias.asname: (node.module, alias.name)
        for node in ast.parse(stub).body
        if isinstance(node, ast.ImportFrom)
        for alias in node.names
    }
    assert sorted(seen) == rr.__all__ == dir(rr)
    for name, (module, named) in seen.items():
        assert name == named
        home = import_module(module)
        assert getattr(rr, name) is (getattr(home, name, None) or import_module(f"{module}.{name}"))


def test_every_public_name_is_found_in_a_new_process():
    program = "import rimroll as rr; print(len([getattr(rr, name) for name in rr.__all__]))"
    for order in ("sorted", "reversed"):
        run = subprocess.run(
            [sys.executable, "-c", program.replace("rr.__all__", f"{order}(rr.__all__)")],
            capture_output=True,
            text=True,
        )
        assert run.stdout.strip() == str(len(rr.__all__)), run.stderr


def test_a_name_that_there_is_not_is_an_attribute_error_with_a_suggestion():
    run = subprocess.run(
        [sys.executable, "-c", "import rimroll as rr; rr.ensembel"], capture_output=True, text=True
    )
    assert "module 'rimroll' has no attribute 'ensembel'. Did you mean: 'ensemble'?" in run.stderr


def test_public_names_stay_what_they_are_when_modules_are_loaded():
    entries = Path(rr.__file__).parent.iterdir()
    names = {entry.stem for entry in entries if entry.suffix == ".py" or entry.is_dir()}
    assert names & set(rr.__all__) == {"bodies", "filmed", "ground", "gyro"}


@pytest.mark.parametrize("name", COMMANDS)
def test_the_list_of_commands_has_the_first_lines_of_their_help(name):
    command = getattr(import_module(f"rimroll.cli.{name}"), name)
    assert inspect.getdoc(command).splitlines()[0] == COMMANDS[name]
