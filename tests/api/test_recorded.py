"""Conversion to datasets and back; how motions, moments and derivatives are displayed."""

import pickle

import numpy as np
import pandas as pd
import pytest
import xarray as xr

import rimroll as rr
from rimroll.experiment.toppling import let_go, limits
from rimroll.laws import law_of
from rimroll.motion import UNITS

CAN = rr.bodies.can_2007()
START = rr.State(tilt=0.5, tilt_rate=-0.5, yaw=0.1, yaw_rate=0.05, spin_rate=-0.02)
LAWS = [
    rr.NoSlip(),
    rr.Coulomb(0.2, static=0.3, restitution=0.1) + rr.RollingResistance(1e-5, 1e-6),
    rr.Tabulated([0.0, 0.01, 0.2], [0.3, 0.2, 0.15], static=0.35) + rr.RollingResistance(1e-6),
    rr.Stribeck(0.2, creep_speed=2e-3) + rr.PivotingFriction(1e-5) + rr.AirDrag(1e-9, 2.5),
]


@pytest.mark.parametrize("law", LAWS, ids=lambda law: law.name)
@pytest.mark.parametrize("options", [{}, {"topple_tilt": 1.2, "rtol": 1e-8, "max_steps": 5000}])
def test_a_motion_comes_back_from_its_dataset_bit_for_bit(tmp_path, law, options):
    motion = rr.simulate(CAN, START, law, 0.8, gravity=9.8, **options)
    path = tmp_path / "motion.nc"
    motion.to_xarray().to_netcdf(path, engine="scipy")
    with xr.open_dataset(path) as read:
        again = rr.Motion.from_xarray(read)
    assert (again.body, again.law, again.parameters()) == (CAN, law, motion.parameters())
    assert (again.status, again.message) == (motion.status, motion.message)
    for column in UNITS:
        np.testing.assert_array_equal(again[column], motion[column])


def test_a_file_of_the_command_line_is_a_motion_too(tmp_path, capsys):
    from rimroll.cli import main

    path = tmp_path / "can.nc"
    assert main(f"simulate --tilt 30deg --yaw-rate 0.05 --points 9 -o {path}".split()) == 0
    with xr.open_dataset(path) as read:
        again = rr.Motion.from_xarray(read)
        np.testing.assert_array_equal(again.evaluate(read["t"].values).tilt, read["tilt"])


def test_falls_can_be_followed_again_from_their_dataset():
    law = LAWS[1]
    starts = rr.State(tilt=np.linspace(0.2, 0.5, 5), tilt_rate=-3.0, yaw_rate=0.1)
    falls = rr.ensemble(CAN, starts, law, friction_scale=np.linspace(0.5, 1.0, 5), gravity=9.8)
    again = rr.ensemble(
        rr.Body.from_xarray(falls),
        rr.State.from_xarray(falls),
        rr.Law.from_xarray(falls),
        friction_scale=falls["friction_scale"].values,
        **{name: falls.attrs[name] for name in ("duration", "gravity", "rtol", "max_steps")},
    )
    xr.testing.assert_identical(again, falls)


@pytest.mark.parametrize("law", LAWS, ids=lambda law: law.name)
def test_falls_keep_the_law_that_their_dataset_says(law):
    falls = let_go(CAN, law, 3, "flick", seed=1)
    assert law_of(falls) is law
    named = falls.to_xarray().assign_attrs(body="can_2007")  # as in files of the command line
    assert law_of(named) == law
    assert limits(named) == limits(falls)


def test_a_fall_is_no_motion_as_it_has_a_friction_scale():
    falls = rr.ensemble(CAN, START, rr.Coulomb(0.5), friction_scale=0.2)
    with pytest.raises(rr.RimrollError, match="that of a motion, got one of falls"):
        rr.Motion.from_xarray(falls.isel(trial=0))


def test_starts_in_other_units_are_converted():
    falls = rr.ensemble(CAN, START, rr.NoSlip())
    in_degrees = falls["start_yaw_rate"] * 180.0 / np.pi
    other = falls.assign(start_yaw_rate=in_degrees.assign_attrs(units="deg/s"))
    assert rr.State.from_xarray(other).yaw_rate == pytest.approx(0.05, rel=1e-14, abs=0.0)
    motion = rr.simulate(CAN, START, rr.NoSlip(), 0.1).to_xarray()
    worded = motion.assign_attrs(start_tilt="30 deg")
    assert rr.State.from_xarray(worded).tilt == pytest.approx(np.pi / 6.0, rel=1e-15, abs=0.0)


def test_a_motion_with_derivatives_comes_back_with_them():
    motion = rr.simulate(CAN, START, rr.NoSlip(), 0.5, jacobian=True)
    again = rr.Motion.from_xarray(motion.to_xarray(), jacobian=True)
    np.testing.assert_array_equal(again.jacobian(0.3).values, motion.jacobian(0.3).values)


@pytest.mark.parametrize(
    "make",
    [rr.Motion.from_xarray, rr.Body.from_xarray, rr.Law.from_xarray, rr.State.from_xarray],
)
def test_what_is_no_dataset_of_rimroll_is_refused(make):
    with pytest.raises(rr.RimrollError, match=r"dataset must be a xarray\.Dataset, got 3"):
        make(3)
    with pytest.raises(rr.RimrollError, match="there is no"):
        make(xr.Dataset())


def test_a_dataset_without_options_is_refused():
    dataset = rr.simulate(CAN, START, rr.NoSlip(), 0.1).to_xarray()
    del dataset.attrs["rtol"]
    with pytest.raises(rr.RimrollError, match="there is no rtol in it"):
        rr.Motion.from_xarray(dataset)


def test_derivatives_as_a_dataset():
    motion = rr.simulate(CAN, START, rr.NoSlip(), 0.5, jacobian=True)
    one, some = motion.jacobian(0.3).to_xarray(), motion.jacobian([0.1, 0.3]).to_xarray()
    assert one["derivative"].dims == ("quantity", "parameter") and float(one["t"]) == 0.3
    assert some["derivative"].dims == ("t", "quantity", "parameter")
    place = {"quantity": "yaw", "parameter": "tilt_rate"}
    assert one["derivative"].sel(place).item() == motion.jacobian(0.3)["yaw", "tilt_rate"]
    np.testing.assert_array_equal(some["derivative"].sel(t=0.3), one["derivative"])
    assert str(some["parameter_units"].sel(parameter="axial_inertia").item()) == "kg m^2"
    assert str(some["quantity_units"].sel(quantity="yaw_rate").item()) == "rad/s"


def test_moments_are_columns_by_name():
    motion = rr.simulate(CAN, START, rr.NoSlip(), 0.5)
    assert list(motion) == list(UNITS) == motion.keys()
    assert "tilt" in motion and "colour" not in motion
    some = motion.evaluate([0.1, 0.2, 0.3])
    frame = pd.DataFrame(dict(some))
    np.testing.assert_array_equal(frame["yaw"], some.yaw)
    assert len(frame) == len(some) == 3
    assert repr(some).startswith("<Moments at 3 times, t from 0.1 to 0.3 s; columns: t, tilt,")
    assert repr(motion).startswith("<Motion no_slip, finished")


def test_a_notebook_shows_the_ending_and_the_turns_of_a_motion():
    motion = rr.simulate(CAN, START, rr.NoSlip(), 2.0)
    shown = motion._repr_html_()
    assert motion.message in shown and f"{np.degrees(motion.turns[0].angle):.4f}°" in shown
    assert shown.count("<tr>") == 1 + len(motion.turns[:6])
    short = rr.simulate(CAN, START, rr.NoSlip(), 1e-3)
    assert "no turns" in short._repr_html_()
    law = rr.simulate(CAN, START, rr.Coulomb(0.3), 0.1)._repr_html_()
    assert "Coulomb(friction=0.3)" in law


def test_a_notebook_shows_the_losses_of_a_motion():
    law = rr.Coulomb(0.05) + rr.RollingResistance(viscous=0.1)
    motion = rr.simulate(CAN, START, law, 0.5)
    friction, resistances = motion.friction_loss[-1], motion.resistance_loss[-1]
    assert min(friction, resistances) > 0.0
    lost = f"lost: {friction:.4g} J to friction, {resistances:.4g} J to resistances, "
    assert lost + f"{motion.impact_loss[-1]:.4g} J to impacts" in motion._repr_html_()


def test_states_and_derivatives_can_be_pickled():
    motion = rr.simulate(CAN, START, rr.NoSlip(), 0.5, jacobian=True)
    assert pickle.loads(pickle.dumps(motion(0.2))).tilt == motion(0.2).tilt
    copy = pickle.loads(pickle.dumps(motion.jacobian([0.1, 0.2])))
    np.testing.assert_array_equal(copy.t, [0.1, 0.2])
