"""A law is added in the documented way: one class and its place in the list."""

import json
import subprocess
import sys
from dataclasses import fields

import pytest

import rimroll as rr
from rimroll.laws import LAWS
from rimroll.units import quantities_of

PROGRAM = '''
import contextlib, io, json, sys
from dataclasses import dataclass
from typing import ClassVar
from rimroll import laws
from rimroll.laws import Law
from rimroll.laws.parameters import RESTITUTION
from rimroll.units import Quantity

@dataclass(frozen=True, repr=False, eq=False)
class Grease(Law):
    """A film of grease, in place of the law of that name, since the core has no other."""

    name: ClassVar[str] = "viscous"
    color: ClassVar[str] = "#117733"
    marker: ClassVar[str] = "*"

    coefficient: float = Quantity("N s/m", "For grease: drag over slip.", "grease_drag").field()
    restitution: float = RESTITUTION.field(0.0)
    fading: float = Quantity("s", "For grease: how fast it fades.", "fading_time").field(0.25)

laws.LAWS["viscous"] = Grease

import rimroll as rr
from rimroll import scenario
from rimroll.figures import style
from rimroll.cli import main
from rimroll.study.axes import targets

def output_of(command):
    out, err = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        code = main(command)
    return [code, out.getvalue() + err.getvalue()]

file, = sys.argv[1:]
law = Grease("200 mN s/m", fading="20 ms")
motion = rr.simulate(rr.bodies.can_2007(), rr.State(tilt=0.5, yaw_rate=0.1), law, duration=0.1)
json.dump({
    "repr": repr(law),
    "key": targets()["law.fading"],
    "again": repr(rr.Law.from_xarray(motion.to_xarray())),
    "file": repr(scenario.load(file).law),
    "look": style.look(law),
    "help": output_of(["turn", "--help"]),
    "fading": output_of(["turn", "--grease-drag", "1", "--fading-time", "3 ms"]),
    "implied": output_of(["turn", "--grease-drag", "1", "--tilt", "30deg", "--yaw-rate", "0.1"]),
    "unit": output_of(["turn", "--grease-drag", "1 m"]),
    "negative": output_of(["turn", "--grease-drag", "-1"]),
    "needs": output_of(["turn", "--law", "viscous"]),
    "alien": output_of(["turn", "--law", "viscous", "--friction", "0.2"]),
}, sys.stdout)
'''


@pytest.fixture(scope="module")
def found(tmp_path_factory):
    file = tmp_path_factory.mktemp("law") / "greased.toml"
    file.write_text(
        '[body]\npreset = "can_2007"\n[law]\nkind = "viscous"\n'
        'coefficient = "3 mN s/m"\nfading = 0.5\n'
    )
    run = subprocess.run(
        [sys.executable, "-c", PROGRAM, file], capture_output=True, text=True, check=False
    )
    assert run.returncode == 0, run.stderr
    return json.loads(run.stdout)


def test_a_new_law_has_units_in_programs_and_files(found):
    assert found["repr"] == found["again"] == "Grease(coefficient=0.2, fading=0.02)"
    assert found["file"] == "Grease(coefficient=0.003, fading=0.5)"
    assert found["key"] == "s"


def test_a_new_law_has_its_look_in_figures(found):
    assert found["look"] == {"color": "#117733", "marker": "*", "markerfacecolor": "white"}


def test_a_new_law_has_its_option_on_the_command_line(found):
    assert "--grease-drag NUMBER" in found["help"][1]
    assert "For grease: drag over slip." in found["help"][1]
    assert "viscous-coefficient" not in found["help"][1]
    assert "--fading-time TIME" in found["help"][1]
    assert "viscous, coefficient 1 N s/m, fading 0.003 s" in found["fading"][1]
    code, text = found["implied"]
    assert code == 0 and "viscous, coefficient 1 N s/m, fading 0.25 s" in text
    for case, message in (
        ("unit", "--grease-drag must be a viscous resistance"),
        ("negative", "--grease-drag must be >= 0, got -1 N s/m"),
        ("needs", "viscous needs --grease-drag"),
        ("alien", "--friction does not go with viscous, which takes --grease-drag"),
    ):
        code, text = found[case]
        assert code != 0 and message in text


def test_laws_look_different():
    for name in ("color", "marker"):
        assert len({getattr(law, name) for law in LAWS.values()}) == len(LAWS)


def test_laws_with_an_option_in_common_read_and_explain_it_alike():
    known = {}
    for law in LAWS.values():
        for parameter in quantities_of(law).values():
            if not parameter.is_list:
                mine = (parameter.unit, parameter.help)
                assert known.setdefault(parameter.option, mine) == mine
    assert known["viscous_coefficient"][0] == "N s/m"
    assert all(text for _, text in known.values())


def test_the_arguments_of_a_law_are_its_parameters():
    for law in LAWS.values():
        names = [field.name for field in fields(law)]
        assert list(quantities_of(law)) == [name for name in names if name != "resistances"]
    assert quantities_of(rr.Coulomb)["friction"].required
    assert not quantities_of(rr.Coulomb)["static"].required
