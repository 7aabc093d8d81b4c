"""Where commands write: files, links, standard output, and pipes that may be closed."""

import csv
import io
import json
import os
import stat
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

import rimroll as rr
from given.ctrl_c import heard
from rimroll.cli import main
from rimroll.files.output import writing

START = "simulate --tilt 30deg --yaw-rate 0.05"


def entry_point():
    """The function that the installed script runs, as ``module:function``."""
    project = tomllib.loads((Path(__file__).parents[2] / "pyproject.toml").read_text())
    return project["project"]["scripts"]["rimroll"]


def script(before=""):
    """A command that runs as the installed script does, after some lines of Python."""
    module, function = entry_point().split(":")
    return [
        sys.executable,
        "-c",
        f"import sys\n{before}\nfrom {module} import {function}\nsys.exit({function}())",
    ]


@pytest.mark.parametrize("command", ["topple -n 20 --seed 1", START, "map --starts 4"])
def test_a_table_is_one_block_and_its_comments_come_last(tmp_path, capsys, command):
    path = tmp_path / "table.csv"
    assert main([*command.split(), "-o", str(path)]) == 0
    lines = path.read_text().splitlines()
    first = next(i for i, line in enumerate(lines) if line.startswith("#"))
    assert all(line.startswith("# ") and " = " in line for line in lines[first:])
    widths = {len(row) for row in csv.reader(lines[:first])}
    assert len(widths) == 1 and first > 2


@pytest.mark.parametrize("command", ["topple -n 5 --seed 1", START, "map --starts 3"])
def test_standard_output_gets_the_same_csv_and_nothing_else(tmp_path, capfdbinary, command):
    path = tmp_path / "table.csv"
    assert main([*command.split(), "-o", str(path)]) == 0
    capfdbinary.readouterr()
    assert main([*command.split(), "-o", "-"]) == 0
    captured = capfdbinary.readouterr()
    assert captured.out == path.read_bytes()
    assert captured.err == b""


@pytest.mark.slow
def test_what_topple_says_fit_reads(monkeypatch, capfdbinary):
    assert (
        main(
            [
                "topple",
                "-n",
                "40",
                "--seed",
                "1",
                "--friction",
                "0.2",
                "--release",
                "paper",
                "-o",
                "-",
            ]
        )
        == 0
    )
    written = capfdbinary.readouterr().out
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(written)))
    assert main(["fit", "-", "--release", "paper", "--json"]) == 0
    assert json.loads(capfdbinary.readouterr().out)["falls"] == 40


@pytest.mark.parametrize(
    ("command", "says"),
    [
        ("turn nosuch --json", "unknown body 'nosuch'"),
        ("topple --json --number many", "must be a whole number"),
        ("simulate -o - --json", "--json and -o - both go to standard output"),
        ("simulate --json -o none/can.csv", "there is no folder none"),
    ],
)
def test_with_json_errors_are_json_too(capsys, command, says):
    assert main(command.split()) == 2
    captured = capsys.readouterr()
    assert captured.out == "" and captured.err.count("\n") == 1
    answer = json.loads(captured.err)
    assert list(answer) == ["error"] and says in answer["error"]


def test_a_link_stays_a_link_and_its_target_is_written(tmp_path, capsys):
    (tmp_path / "data").mkdir()
    target, link = tmp_path / "data" / "target.csv", tmp_path / "link.csv"
    link.symlink_to(Path("data") / "target.csv")
    for _ in range(2):  # to a target that does not exist yet, and to one that does
        assert main([*START.split(), "-o", str(link)]) == 0
        assert link.is_symlink() and target.read_text().startswith("t[s],tilt[rad]")
    assert sorted(path.name for path in tmp_path.rglob("*")) == ["data", "link.csv", "target.csv"]


def test_a_link_into_nowhere_is_refused(tmp_path, capsys):
    link = tmp_path / "link.csv"
    link.symlink_to(tmp_path / "none" / "target.csv")
    assert main([*START.split(), "-o", str(link)]) == 2
    assert "there is no folder" in capsys.readouterr().err


def test_a_file_that_is_replaced_passes_on_its_permissions(tmp_path):
    path = tmp_path / "a.txt"
    path.write_text("old")
    path.chmod(0o640)
    with writing(path) as part:
        part.write_text("new")
    assert path.read_text() == "new" and stat.S_IMODE(path.stat().st_mode) == 0o640


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no such files here")
def test_what_is_no_regular_file_is_not_replaced(tmp_path):
    path = tmp_path / "pipe.csv"
    os.mkfifo(path)
    with pytest.raises(rr.RimrollError, match="it is no regular file"), writing(path):
        pass
    assert stat.S_ISFIFO(path.stat().st_mode)


def test_a_film_makes_no_folder_either(tmp_path):
    start = rr.State(tilt=0.3, yaw_rate=0.1)
    motion = rr.simulate(rr.bodies.can_2007(), start, rr.NoSlip(), 0.1)
    with pytest.raises(rr.RimrollError, match=r"there is no folder .*none"):
        motion.animate(tmp_path / "none" / "x.gif")
    assert not any(tmp_path.iterdir())


def test_a_thousand_may_be_typed_as_1e3(capsys):
    assert main(["topple", "--number", "1e2", "--seed", "1", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["number"] == 100


@pytest.mark.parametrize("command", ["map --starts 20", "map --starts 10 --friction 0.2"])
def test_maps_are_the_same_for_any_number_of_threads(tmp_path, capsys, command):
    texts = set()
    for threads in ("1", "2"):
        path = tmp_path / f"{threads}.csv"
        assert main([*command.split(), "--threads", threads, "-o", str(path)]) == 0
        texts.add(path.read_text())
    assert len(texts) == 1


@pytest.mark.parametrize(
    "arguments", [["bodies"], ["--help"], ["bodies", "--json"], [*START.split(), "-o", "-"]]
)
def test_a_reader_that_has_had_enough_is_no_error(arguments):
    reading, writing_end = os.pipe()
    os.close(reading)
    with os.fdopen(writing_end, "wb") as stdout:
        done = subprocess.run(
            [*script(), *arguments], stdout=stdout, stderr=subprocess.PIPE, check=False
        )
    assert (done.returncode, done.stderr) == (0, b"")


@pytest.mark.parametrize("module", ["numpy", "rimroll._core", "typer", "rich"])
def test_ctrl_c_while_modules_are_loaded_is_one_line(module):
    interrupts = (
        "import os, signal\n"
        "class Finder:\n"
        "    def find_spec(self, name, *_):\n"
        f"        if name == {module!r}:\n"
        "            os.kill(os.getpid(), signal.SIGINT)\n"
        "sys.meta_path.insert(0, Finder())"
    )
    with heard():
        done = subprocess.run(
            [*script(interrupts), "bodies"], capture_output=True, text=True, check=False
        )
    assert (done.returncode, done.stdout, done.stderr) == (130, "", "rimroll: interrupted\n")


def test_an_ignored_ctrl_c_stays_ignored_while_modules_are_loaded():
    ignores = (
        "import os, signal\n"
        "signal.signal(signal.SIGINT, signal.SIG_IGN)\n"
        "class Finder:\n"
        "    def find_spec(self, name, *_):\n"
        "        if name == 'numpy':\n"
        "            os.kill(os.getpid(), signal.SIGINT)\n"
        "sys.meta_path.insert(0, Finder())"
    )
    done = subprocess.run(
        [*script(ignores), "--version"], capture_output=True, text=True, check=False
    )
    assert (done.returncode, done.stdout) == (0, f"rimroll {rr.__version__}\n")


def test_a_shell_can_complete_commands_and_bodies():
    for words, found in (("rimroll tu", "turn"), ("rimroll turn soda", "soda_can")):
        request = {"_RIMROLL_COMPLETE": "complete_bash", "COMP_WORDS": words}
        count = {"COMP_CWORD": str(len(words.split()) - 1)}
        done = subprocess.run(
            script(), env={**os.environ, **request, **count}, capture_output=True, text=True
        )
        assert done.stdout.split() == [found], done.stderr
