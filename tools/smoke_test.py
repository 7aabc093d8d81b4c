"""Checks an installed rimroll: run it by the Python that rimroll is installed for.

It needs only what rimroll itself installs, so it also runs where there are no test packages and no
compiler. `--without-page` leaves out the page of the lab.
"""

import contextlib
import io
import re
import struct
import sys
from importlib import metadata, resources
from pathlib import Path

import rimroll as rr
from rimroll.cli import main

ROOT = Path(__file__).parents[1]


def check_the_bits() -> None:
    """The last moment of two motions, bit by bit, is the one that the core's test holds."""
    held = (ROOT / "crates/rimroll/tests/integration/same_bits.rs").read_text("utf-8")
    start = rr.State(tilt=0.5, tilt_rate=-0.5, yaw_rate=0.005, spin_rate=0.005)
    for name, law in ("NO_SLIP", rr.NoSlip()), ("FRICTIONLESS", rr.Frictionless()):
        block = re.search(rf"const {name}: \[u64; 7\] = \[(.*?)\]", held, re.S)
        assert block, name
        expected = [int(number) for number in re.findall(r"\d+", block[1])]
        motion = rr.simulate(rr.bodies.can_2007(), start, law, duration=2.0)
        names = ("tilt", "tilt_rate", "yaw", "yaw_rate", "spin", "spin_rate", "axial_spin")
        ends = [float(motion[name][-1]) for name in names]
        computed = [struct.unpack("<Q", struct.pack("<d", end))[0] for end in ends]
        assert computed == expected, f"{name}: {computed}, not {expected}"


def check_the_readme() -> None:
    """The five lines of the README print what it says."""
    found = re.search(
        r"```python\n(.*?)```\s+```\n(.*?)```", (ROOT / "README.md").read_text("utf-8"), re.S
    )
    assert found
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        exec(found[1], {})
    for number, expected in zip(printed.getvalue().split(), found[2].split(), strict=True):
        # NumPy may convert radians to degrees with another last bit.
        assert abs(float(number) / float(expected) - 1) <= 4e-16, f"{number}, not {expected}"


def check_many_falls() -> None:
    """An ensemble gives each start the turn that it has alone, whatever the number of threads."""
    can = rr.bodies.can_2007()
    rates = [0.001 * number for number in range(1, 40)]
    starts = rr.State(tilt=0.5, tilt_rate=-0.5, yaw_rate=rates)
    turns = [rr.ensemble(can, starts, rr.NoSlip(), threads=threads).turn for threads in (1, 2)]
    assert (turns[0] == turns[1]).all()
    alone = rr.ensemble(can, rr.State(tilt=0.5, tilt_rate=-0.5, yaw_rate=rates[7]), rr.NoSlip())
    assert float(alone.turn[0]) == float(turns[0][7])


def check_the_command() -> None:
    """`rimroll` writes a table, and reports a mistake by its exit code."""
    written = io.StringIO()
    with contextlib.redirect_stdout(written), contextlib.redirect_stderr(written):
        assert main(["turn", "soda_can"]) == 0
        assert main(["turn", "no_such_body"]) != 0
    scripts = metadata.entry_points(group="console_scripts")
    assert "rimroll" in {script.name for script in scripts}


def check_the_page() -> None:
    """The page of the lab is installed with its compiled core and its licences."""
    page = resources.files("rimroll") / "page"
    assert (page / "index.html").is_file(), "the wheel was built without its page: make web"
    assert (page / "licences.txt").is_file()
    assert (page / "alone.js").is_file()
    assets = (page / "assets").iterdir()
    assert any(file.name.endswith(".wasm") for file in assets)


def run(arguments: list[str]) -> None:
    checks = [check_the_bits, check_the_readme, check_many_falls, check_the_command]
    if arguments != ["--without-page"]:
        assert not arguments, f"unknown: {arguments}"
        checks.append(check_the_page)
    for check in checks:
        check()
        print("passed:", check.__doc__)
    where = Path(rr.__file__).parent
    print(f"rimroll {metadata.version('rimroll')} in {where} works with Python {sys.version}")


if __name__ == "__main__":
    run(sys.argv[1:])
