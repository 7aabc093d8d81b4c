"""The benchmark problem for the IFToMM library: its reference, its error and its files."""

import importlib.util
import math
import sys
import zipfile
from pathlib import Path

import numpy as np
import pytest

FOLDER = Path(__file__).parents[1] / "iftomm"


@pytest.fixture(scope="module")
def error():
    return loaded("error")


@pytest.fixture(scope="module")
def make(error):
    sys.modules["error"] = error
    yield loaded("make")
    del sys.modules["error"]


def loaded(name):
    spec = importlib.util.spec_from_file_location(name, FOLDER / f"{name}.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="module")
def reference(error):
    return error.read(error.REFERENCE)


def test_the_reference_is_what_rimroll_computes(make, reference):
    np.testing.assert_allclose(make.solved(rtol=make.RTOL), reference, rtol=0.0, atol=2e-11)


class Rolling:
    """The equations of the description, in vectors of the fixed frame."""

    def __init__(self, case):
        self.body, self.gravity = case.scene.body, case.scene.gravity

    def rates(self, values):
        """Rates of the centre's place, the axis and the angular velocity."""
        body, axis, turning = self.body, values[3:6], values[6:]
        up = np.array([0.0, 0.0, 1.0])
        level = up - axis[2] * axis
        length = np.linalg.norm(level)
        e, axis_rate = level / length, np.cross(turning, axis)
        level_rate = -axis_rate[2] * axis - axis[2] * axis_rate
        arm = body.radius * e + body.height * axis
        arm_rate = body.radius * (level_rate - (e @ level_rate) * e) / length
        arm_rate += body.height * axis_rate
        cross = np.cross(np.eye(3), arm)  # cross @ v = arm x v
        more = body.axial_inertia - body.transverse_inertia
        left = body.transverse_inertia * np.eye(3) + more * np.outer(axis, axis)
        left -= body.mass * cross @ cross  # arm x (v x arm)
        force = np.cross(turning, arm_rate) + self.gravity * up
        right = -more * (axis @ turning) * axis_rate - body.mass * np.cross(arm, force)
        return np.concatenate([np.cross(turning, arm), axis_rate, np.linalg.solve(left, right)])

    def step(self, values, dt):
        one = self.rates(values)
        two = self.rates(values + 0.5 * dt * one)
        three = self.rates(values + 0.5 * dt * two)
        four = self.rates(values + dt * three)
        return values + dt / 6.0 * (one + 2.0 * two + 2.0 * three + four)


@pytest.mark.soak
def test_the_equations_of_the_description_lead_to_the_reference(make, reference):
    case = make.the_case()
    rolling, state = Rolling(case), case.state
    values = np.concatenate([state.position, state.rotation[:, 2], state.angular_velocity])
    t, off = 0.0, 0.0
    for row in reference[1:]:
        while t < row[0] - 1e-12:
            across = math.hypot(values[3], values[4])  # the smaller, the faster the contact runs
            dt = min(2e-4, 2e-3 * across**2 / 0.25 + 4e-7, row[0] - t)
            values, t = rolling.step(values, dt), t + dt
        off = max(off, np.abs(values[:6] - row[1:7]).max())
    assert off < 1e-10


def test_the_error_of_a_result_is_that_of_the_description(error, reference):
    assert error.errors(reference, reference) == (0.0, pytest.approx(0.0, abs=1e-10))
    shifted = reference.copy()
    shifted[:, 1] += 0.003 * error.RADIUS
    shifted[:, 5] += 0.004
    shifted[40, 7] *= 0.98
    assert error.errors(shifted, reference) == pytest.approx((0.005, 0.02))


@pytest.mark.parametrize(
    "text, says",
    [
        ("", "it must have 8"),
        ("1 2 3\n", "it must have 8"),
        ("a b c\n", "no table of numbers"),
        ("0 0 0 0 0 0 0 nan\n", "not finite"),
        ("0 0 0 0 0 0 1 1\n", "the times must be 81, evenly spaced from 0 to 0.8 s"),
    ],
)
@pytest.mark.filterwarnings("ignore:loadtxt")
def test_files_that_are_no_result_are_refused(error, text, says, tmp_path, capsys):
    file = tmp_path / "result.txt"
    file.write_text(text)
    assert error.main(str(file)) == 2
    assert says in capsys.readouterr().err


def test_a_result_beyond_a_bound_is_not_acceptable(error, reference, tmp_path, capsys):
    file = tmp_path / "result.txt"
    np.savetxt(file, reference)
    assert error.main(str(file)) == 0
    reference = reference.copy()
    reference[:, 1] += 0.02 * error.RADIUS
    np.savetxt(file, reference)
    assert error.main(str(file)) == 1
    assert "error 0.02," in capsys.readouterr().out
    assert error.main(str(tmp_path / "none.txt")) == 2


def test_one_command_writes_all_that_the_form_asks_for(make, error, tmp_path, monkeypatch):
    pytest.importorskip("typst")
    monkeypatch.setattr(sys, "argv", ["make.py", str(tmp_path)])
    make.main()
    assert (tmp_path / "rocking_can.pdf").read_bytes().startswith(b"%PDF-")
    assert (tmp_path / "rocking_can_result.txt").read_bytes() == error.REFERENCE.read_bytes()
    assert error.main(str(tmp_path / "rocking_can_by_rimroll.txt")) == 0
    form = (tmp_path / "rocking_can_by_rimroll_form.txt").read_text("utf-8")
    assert "processor time, s: " in form and "software: rimroll " in form
    with zipfile.ZipFile(tmp_path / "rocking_can_code.zip") as archive:
        assert {"error.py", "make.py", "reference.txt"} <= set(archive.namelist())
    assert {file.suffix for file in tmp_path.iterdir()} == {".pdf", ".txt", ".zip"}
