"""A whole motion fitted to a record: its derivatives, and the truth inside its intervals."""

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import rimroll as rr
from rimroll.cli import main
from rimroll.cli.fitted import show_fit
from rimroll.scenario import load
from rimroll.sensors.fits import UNREACHED, Estimate, Minimum, fitted_names, least, with_numbers
from rimroll.sensors.gyro.motion_fit import notes_of
from rimroll.sensors.gyro.motion_model import (
    FARTHEST,
    SHARED,
    Model,
    Prior,
    Sensing,
    Window,
    part_left,
)
from rimroll.sensors.gyro.motion_search import Chain

EXAMPLES = Path(__file__).parents[2] / "examples"
CAN = rr.bodies.can_2007()
START = rr.State(tilt=0.5, tilt_rate=-0.2, yaw_rate=0.1, spin_rate=0.05)
SENSOR = rr.gyro.phone(200.0)


def recorded(law, body=CAN, start=START, duration=0.75, seed=2):
    return SENSOR.record(rr.simulate(body, start, law, duration), seed=seed)


@pytest.fixture(scope="module")
def slipping():
    """The paper's can, 1 % of its inertia wrong, under friction 0.15."""
    body = replace(CAN, transverse_inertia=1.01 * CAN.transverse_inertia)
    record = recorded(rr.Coulomb(0.15), body)
    return rr.fit_motion(record, CAN, axis="z", most_collisions=1)


def test_friction_and_start_come_back(slipping):
    low, high = slipping.friction.interval
    assert low < 0.15 < high
    assert high - low < 0.02
    assert slipping.friction.method == "profile"
    for name, true in (("tilt", 0.5), ("yaw_rate", 0.1), ("spin_rate", 0.05)):
        found = slipping.numbers[name]
        assert abs(found.value - true) < 3.0 * found.error + 2e-3  # the filter and the hand


def test_ideal_laws_are_excluded_and_the_side_is_sure(slipping):
    fitted, rolling, sliding = slipping.verdicts
    assert not fitted.excluded
    assert rolling.excluded
    assert sliding.excluded
    assert slipping.sides_are_sure == [True]
    assert slipping.residual < np.radians(1.0)


@pytest.mark.slow
def test_rolling_leaves_the_friction_without_upper_end():
    fit = rr.fit_motion(recorded(rr.NoSlip()), CAN, axis="z", most_collisions=1)
    assert fit.friction.interval[1] is None
    assert fit.friction.interval[0] < rr.needed_friction(CAN)
    _, rolling, sliding = fit.verdicts
    assert not rolling.excluded
    assert sliding.excluded


@pytest.mark.slow
def test_a_rolling_resistance_comes_back():
    law = rr.Coulomb(0.2) + rr.RollingResistance(dry=3e-4)
    given = rr.Coulomb(0.1) + rr.RollingResistance(dry=1e-4)
    fit = rr.fit_motion(recorded(law), CAN, given, axis="z", most_collisions=1)
    for name, true in (("friction", 0.2), ("rolling_dry", 3e-4)):
        found = fit.numbers[name]
        assert abs(found.value - true) < 3.0 * found.error
    for one in fit.verdicts[1:]:  # each law has a resistance of its own
        resistance = one.law.numbers["rolling_dry"]
        assert resistance >= 0.0
        assert resistance not in (1e-4, fit.numbers["rolling_dry"].value)


@pytest.mark.soak
def test_a_motion_of_another_body_is_refused():
    wider = replace(CAN, radius=1.6 * CAN.radius)
    record = recorded(rr.Coulomb(0.15))
    with pytest.raises(rr.RimrollError, match=r"no motion under|no fall|never upright"):
        rr.fit_motion(record, wider, axis="z", body_error=0.0, most_collisions=1)


def model_of(law, free):
    """The paper's can, seen by a sensor that is askew, without noise."""
    start = replace(START, spin=0.3)
    motion = rr.simulate(CAN, start, law, 0.6, rtol=1e-12)
    t = np.arange(0.01, 0.6, 0.005)
    t = t[np.abs(t - motion.turns[0].t) > 0.01]
    rates = motion.evaluate(t).body_angular_velocity
    window = Window(0.0, t, rates, np.full((len(t), 1), 1e-3))
    prior = Prior(np.zeros(len(SHARED)), np.full(len(SHARED), 0.01), 0.005)
    return Model(CAN, law, free, rr.STANDARD_GRAVITY, Sensing(np.eye(3)), [window], prior)


@pytest.mark.parametrize(
    ("law", "free"),
    [
        (rr.NoSlip(), ()),
        (rr.Coulomb(0.15), ("friction",)),
        (rr.Coulomb(0.2) + rr.RollingResistance(dry=1e-4), ("friction", "rolling_dry")),
    ],
)
def test_derivatives_are_those_of_differences(law, free):
    model = model_of(law, free)
    numbers = [law.numbers[name] for name in free]
    shared = 0.01 * np.random.default_rng(0).standard_normal(len(SHARED))
    vector = np.array([*numbers, *shared, 0.5, -0.2, 0.1, 0.05, 0.3, 1e-4])
    exact = model.jacobian(vector)
    for i, name in enumerate(model.names):
        step = 1e-7 if name == "rolling_dry" else 1e-5
        ahead, behind = vector.copy(), vector.copy()
        ahead[i] += step
        behind[i] -= step
        rough = (model.residuals(ahead) - model.residuals(behind)) / (2.0 * step)
        assert exact[:, i] == pytest.approx(rough, abs=1e-3 * np.abs(rough).max() + 1e-6), name


def test_after_a_motion_topples_every_sample_counts_as_unreached():
    model = model_of(rr.NoSlip(), ())
    vector = np.array([*np.zeros(len(SHARED)), 0.5, 6.0, 0.1, 0.05, 0.3, 0.0])
    motion = model.motion(vector, 0, model.law)
    assert motion.status == "toppled"
    after = model.windows[0].t > motion.t[-1]
    assert 0.1 < after.mean() < 0.9
    assert np.array_equal(np.isnan(model.shown(vector, 0)), np.tile(after[:, np.newaxis], 3))
    left = model.residuals(vector)[: model.count].reshape(-1, 3)
    assert np.all(left[after] == UNREACHED)
    derivatives = model.jacobian(vector)[: model.count].reshape(len(after), 3, -1)
    assert np.all(derivatives[after] == 0.0)
    assert np.all(np.abs(derivatives[~after]).max(axis=(1, 2)) > 0.0)
    assert np.isnan(part_left(Minimum(model, vector, float(np.sum(left**2)), derivatives)))


def test_after_a_body_comes_to_rest_the_sensor_shows_its_bias():
    law = rr.Coulomb(0.3) + rr.RollingResistance(dry=5e-4) + rr.PivotingFriction(3e-4)
    model = replace(model_of(rr.Coulomb(0.3), ()), law=law)
    vector = np.array([*np.zeros(len(SHARED)), 0.5, -0.2, 0.1, 0.05, 0.3, 0.0])
    vector[2:5] = (0.01, -0.02, 0.03)
    motion = model.motion(vector, 0, law)
    assert motion.status == "at_rest"
    after = model.windows[0].t > motion.t[-1]
    assert 0.1 < after.mean() < 0.9
    shown = model.shown(vector, 0)
    assert np.all(shown[after] == vector[2:5])
    assert np.all(np.linalg.norm(shown[~after] - vector[2:5], axis=1) > 0.0)
    by = model.jacobian(vector)[: model.count].reshape(len(after), 3, -1)[after]
    assert np.all(by[:, :, model.place(0)] == 0.0)
    assert by[:, 0, 2] == pytest.approx(1.0 / model.windows[0].scatter[after, 0])


def test_the_minimum_without_noise_is_the_truth():
    model = model_of(rr.Coulomb(0.15), ("friction",))
    truth = np.array([0.15, *np.zeros(len(SHARED)), 0.5, -0.2, 0.1, 0.05, 0.3, 0.0])
    near = truth * (1.0 + 1e-3) + 1e-4
    found = least(model, near, 30)
    assert found.squares < 1e-2
    assert found.vector[0] == pytest.approx(0.15, abs=1e-5)


def test_a_search_stays_near_the_sensor_and_the_body_that_are_expected():
    """From afar, a search without limits ends with a height below zero."""
    model = model_of(rr.Coulomb(0.15), ("friction",))
    afar = np.array([0.4, *np.zeros(len(SHARED)), 0.9, 1.0, -0.8, 0.6, 2.0, 0.02])
    found = least(model, afar, 30)
    shared = np.abs(model.shared(found.vector)) / model.prior.shared_error
    assert shared.max() <= FARTHEST
    assert abs(found.vector[-1]) <= FARTHEST * model.prior.delay_error


def test_the_numbers_of_a_law_may_be_chosen():
    law = rr.Coulomb(0.2, static=0.3, restitution=0.1) + rr.RollingResistance(dry=1e-4)
    assert fitted_names(law, None) == ["friction", "static", "rolling_dry"]
    assert fitted_names(law, ["rolling_dry"]) == ["rolling_dry"]
    changed = with_numbers(law, {"friction": 0.25, "rolling_dry": 2e-4})
    assert (changed.friction, changed.static, changed.numbers["rolling_dry"]) == (0.25, 0.3, 2e-4)
    with pytest.raises(rr.RimrollError, match="has no number 'slip' to fit"):
        fitted_names(law, ["slip"])


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"body_error": -0.1}, "body_error must be from 0"),
        ({"most_collisions": 0}, "most_collisions must be a whole number"),
        ({"fit": ["static"]}, "has no number 'static'"),
    ],
)
def test_impossible_arguments_are_refused(options, message):
    record = rr.gyro.read(EXAMPLES / "simulated_phone_in_a_can.csv")
    tin = load(EXAMPLES / "can_with_phone.toml").body
    with pytest.raises(rr.RimrollError, match=message):
        rr.fit_motion(record, tin, axis="y", **options)


@pytest.mark.slow
def test_the_command_gives_the_fit_as_json(capsys):
    record = str(EXAMPLES / "simulated_phone_in_a_can.csv")
    body = str(EXAMPLES / "can_with_phone.toml")
    assert main(["gyro", record, "--body", body, "--fit", "--json"]) == 0
    answer = json.loads(capsys.readouterr().out)
    low, high = answer["fit"]["numbers"]["friction"]["interval"]
    assert low < 0.2 < high  # the friction of examples/phone_in_a_can.py
    assert high - low < 0.01


@pytest.mark.slow
def test_the_command_prints_the_fit_that_a_resistance_implies(capsys):
    record = str(EXAMPLES / "simulated_phone_in_a_can.csv")
    body = str(EXAMPLES / "can_with_phone.toml")
    assert main(["gyro", record, "--body", body, "--resistance"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert any(line.startswith("fit of the whole motion over ") for line in lines)
    rows = {line.split()[0]: line.split() for line in lines if line.strip()}
    assert float(rows["friction"][1]) == pytest.approx(0.2, abs=0.01)
    assert rows["friction"][-1] == "profile"
    assert rows["rolling_dry"][-1] == "covariance"
    verdicts = [line for line in lines if line.startswith(("NoSlip()", "Frictionless()"))]
    assert len(verdicts) == 2
    assert all(line.endswith(": excluded") for line in verdicts)


def test_numbers_are_printed_with_the_digits_that_their_errors_leave(slipping, capsys):
    delay = Estimate(-1.36e-9, 7.5e-3, (-0.0147, 0.0147), "covariance")
    numbers = {**slipping.numbers, "delay": delay}
    show_fit(replace(slipping, numbers=numbers))
    rows = {line.split()[0]: line.split() for line in capsys.readouterr().out.splitlines() if line}
    assert rows["delay"][1:] == ["0.0", "ms", "7.5", "-14.7", "to", "14.7", "covariance"]
    assert len(rows["friction"][2]) == len(rows["friction"][1])


def test_what_the_record_cannot_tell_is_printed_once(slipping, capsys):
    chains = [Chain(list(slipping.analysis.collisions[:1]))]
    notes = notes_of(chains, [1], [True], (0.0, None), False, 1.0)
    show_fit(replace(slipping, friction_is_told=False, notes=notes))
    assert capsys.readouterr().out.count("cannot tell") == 1


@pytest.mark.parametrize(
    ("later", "words"),
    [(1, "1 later near-collision, which depends"), (2, "2 later near-collisions, which depend ")],
)
def test_the_notes_count_and_do_not_blame_the_sensor_alone(slipping, later, words):
    one = slipping.analysis.collisions[0]
    notes = notes_of([Chain([one] * (1 + later))], [1], [True], None, False, 9.0)
    assert words in "\n".join(notes)
    assert "or hang together from sample to sample" in notes[-1]
    assert "all intervals are 3.0 times wider" in notes[-1]


def test_the_figure_shows_record_motion_and_residuals(slipping):
    titles = [ax.get_title(loc="left") for ax in slipping.plot().axes]
    assert titles[0].startswith("(a) simulated record")
    assert titles[1].startswith("(b) record less motion")
