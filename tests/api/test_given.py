"""Quantities with units are converted or refused wherever Python takes a number, never stripped."""

import math
import subprocess
import sys
from decimal import Decimal
from fractions import Fraction

import numpy as np
import pint
import pytest
import xarray as xr
from hypothesis import given
from hypothesis import strategies as st
from uncertainties import ufloat

import rimroll as rr
from rimroll.errors import UnitError
from rimroll.units import quantity

u = pint.UnitRegistry()
CAN = rr.bodies.can_2007()
START = rr.State(tilt=0.5, tilt_rate=-0.5, yaw_rate=0.01)
FALL = rr.State(tilt=0.3, tilt_rate=-5.0, yaw_rate=0.5)


class Package:
    """A quantity of another package, with the common interface.

    It is an array, so numpy drops its unit silently.
    """

    FACTORS = {  # noqa: RUF012
        ("deg", "rad"): math.pi / 180.0,
        ("deg/s", "rad/s"): math.pi / 180.0,
        ("g", "kg"): 1e-3,
        ("cm", "m"): 1e-2,
    }

    def __init__(self, value, unit):
        self.value, self.unit = value, Unit(unit)

    def to(self, unit):
        factor = 1.0 if unit == str(self.unit) else self.FACTORS[str(self.unit), unit]
        return Package(self.value * factor, unit)

    def __array__(self, dtype=None, copy=None):
        return np.asarray(self.value, dtype)

    def __float__(self):
        return float(self.value)


class Unit:
    def __init__(self, name):
        self.name = name

    def __str__(self):
        return self.name

    def __rmul__(self, number):
        return Package(number, self.name)


def body(**changed):
    numbers = {"mass": 0.07, "radius": 0.051, "height": 0.069}
    return rr.Body(**{**numbers, "transverse_inertia": 3.591e-4, "axial_inertia": 1.4e-4} | changed)


CALLS = {
    "Body mass": ("g", lambda x: body(mass=x)),
    "Body radius": ("cm", lambda x: body(radius=x)),
    "Body transverse_inertia": ("kg m^2", lambda x: body(transverse_inertia=x)),
    "Solid mass": ("g", lambda x: rr.Solid(x, 0.1, 1e-4, 1e-4)),
    "cylinder length": ("cm", lambda x: rr.solids.cylinder(0.1, 0.03, x)),
    "filling density": ("g/cm^3", lambda x: rr.solids.filling(x, 0.03, 0.1)),
    "from_solids radius": (
        "cm",
        lambda x: rr.Body.from_solids(x, [rr.solids.disk(0.02, 0.03, 0.01)]),
    ),
    "disk radius": ("cm", rr.bodies.disk),
    "soda_can fill": ("percent", rr.bodies.soda_can),
    "State tilt": ("deg", lambda x: rr.State(tilt=x).tilt),
    "State tilt_rate": ("deg/s", lambda x: rr.State(tilt=0.5, tilt_rate=x).tilt_rate),
    "State yaw": ("deg", lambda x: rr.State(tilt=0.5, yaw=x).yaw),
    "Coulomb friction": ("percent", rr.Coulomb),
    "Coulomb static": ("percent", lambda x: rr.Coulomb(0.0, static=x)),
    "Viscous coefficient": ("mN s/m", rr.Viscous),
    "Stribeck creep_speed": ("mm/s", lambda x: rr.Stribeck(0.3, creep_speed=x)),
    "RollingResistance viscous": ("mN s/m", lambda x: rr.RollingResistance(viscous=x)),
    "PivotingFriction length": ("mm", rr.PivotingFriction),
    "AirDrag coefficient": ("nW s^4/rad^4", rr.AirDrag),
    "AirDrag coefficient of 5/2": ("nW s^2.5/rad^2.5", lambda x: rr.AirDrag(x, 2.5)),
    "film radius": ("cm", rr.AirDrag.film),
    "film viscosity": ("mPa s", lambda x: rr.AirDrag.film(0.05, viscosity=x)),
    "simulate duration": (
        "ms",
        lambda x: rr.simulate(CAN, START, rr.NoSlip(), duration=x).t[-1],
    ),
    "simulate gravity": (
        "cm/s^2",
        lambda x: rr.simulate(CAN, START, rr.NoSlip(), 0.1, gravity=x).tilt[-1],
    ),
    "simulate topple_tilt": (
        "deg",
        lambda x: rr.simulate(CAN, START, rr.NoSlip(), 0.01, topple_tilt=x).topple_tilt,
    ),
    "motion(t)": ("ms", lambda x: rr.simulate(CAN, START, rr.NoSlip())(x).tilt),
    "exact_turn gravity": (
        "cm/s^2",
        lambda x: rr.exact_turn(CAN, START, rr.NoSlip(), gravity=x).end_time,
    ),
    "ensemble duration": (
        "ms",
        lambda x: rr.ensemble(CAN, FALL, rr.NoSlip(), duration=x).attrs["duration"],
    ),
    "topple gravity": (
        "m/s^2",
        lambda x: rr.topple(CAN, rr.NoSlip(), 2, seed=1, gravity=x).turn.values.tolist(),
    ),
    "Release tilt": ("deg", lambda x: rr.Release(tilt=(x, x))),
    "Release sideways": ("deg/s", lambda x: rr.Release(0.3, sideways=(x, x))),
    "Release.named gravity": ("m/s^2", lambda x: rr.Release.named("flick", CAN, x)),
    "turn_map yaw_rates": (
        "deg/s",
        lambda x: rr.turn_map(CAN, START, rr.NoSlip(), x, [0.0]).turn.values.tolist(),
    ),
    "watershed spin_rates": (
        "deg/s",
        lambda x: rr.watershed(CAN, START, rr.NoSlip(), x).tolist(),
    ),
    "watershed_slope tilt": ("deg", lambda x: rr.watershed_slope(CAN, x, rr.NoSlip())),
    "Arrival slip": ("cm/s", lambda x: rr.Arrival(slip=x).slip),
    "arrival gravity": ("cm/s^2", lambda x: rr.arrival(CAN, START, rr.NoSlip(), x)),
    "turn_limit_with_spin": ("deg/s", lambda x: rr.turn_limit_with_spin(CAN, x, x)),
    "point_mass_turn_limit": ("cm", lambda x: rr.point_mass_turn_limit(x, x, rr.NoSlip())),
    "error_law_coefficient": (
        "deg/s",
        lambda x: rr.error_law_coefficient(CAN, rr.NoSlip(), x),
    ),
    "steady_wobble_rate tilt": ("deg", lambda x: rr.steady_wobble_rate(CAN, x)),
    "lift_off_rate gravity": ("cm/s^2", lambda x: rr.lift_off_rate(CAN, x)),
    "slip_rate gravity": ("cm/s^2", lambda x: rr.slip_rate(CAN, x)),
    "NearCollision min_tilt": (
        "deg",
        lambda x: rr.NearCollision(CAN, rr.NoSlip(), x, 1.0).tilt("3 ms").tolist(),
    ),
    "composite gravity": (
        "cm/s^2",
        lambda x: rr.composite(CAN, START, rr.NoSlip(), x).min_tilt_time,
    ),
    "imperfect_rim angle": ("deg", lambda x: rr.imperfect_rim(CAN, x, rr.NoSlip())),
    "ground.sine amplitude": ("cm/s^2", lambda x: rr.ground.sine(x, 1.0)),
    "ground.sine period": ("ms", lambda x: rr.ground.sine(1.0, (x, 1.0, 1.0))),
    "ground.rectangular duration": ("ms", lambda x: rr.ground.rectangular(1.0, x)),
    "ground.ricker center": ("ms", lambda x: rr.ground.ricker(1.0, 1.0, x)),
    "ground.sampled step": ("ms", lambda x: rr.ground.sampled(x, [1.0, 2.0])),
    "ground.function duration": ("ms", lambda x: rr.ground.function(lambda t: t, x, 0.001)),
    "ground.synthetic soil_period": ("ms", lambda x: rr.ground.synthetic(1, soil_period=x)),
    "ground rotated": ("deg", lambda x: rr.ground.sine(1.0, 1.0).rotated(x)),
    "ground scaled": ("percent", lambda x: rr.ground.sine(1.0, 1.0).scaled(x)),
    "ground(t)": ("ms", lambda x: rr.ground.sine(1.0, 1.0)(x).tolist()),
    "measure diameter": (
        "cm",
        lambda x: rr.measure(mass=0.07, diameter=x, balance_point=x, swing_period=0.6).body,
    ),
    "summary left": (
        "deg",
        lambda x: rr.directions_from_summary(left=(x, x, 5), right=(3.0, 0.1, 5)).tolist(),
    ),
    "predict_falls reading_error": (
        "deg",
        lambda x: rr.predict_falls(CAN, reading_error=x, frictions=25, falls=128).reading_error,
    ),
}
AMOUNT = {
    "motion(t)": 30.0,
    "ensemble duration": 100.0,
    "simulate duration": 100.0,
    "simulate topple_tilt": 100.0,
}
SI = {
    "g": "kg",
    "cm": "m",
    "mm": "m",
    "kg m^2": "kg m^2",
    "g/cm^3": "kg/m^3",
    "percent": "1",
    "deg": "rad",
    "deg/s": "rad/s",
    "mN s/m": "N s/m",
    "mm/s": "m/s",
    "cm/s": "m/s",
    "nW s^4/rad^4": "W (s/rad)^4",
    "nW s^2.5/rad^2.5": "W (s/rad)^2.5",
    "mPa s": "Pa s",
    "ms": "s",
    "cm/s^2": "m/s^2",
    "m/s^2": "m/s^2",
}


@pytest.mark.parametrize("name", CALLS)
def test_texts_and_pint_quantities_are_the_same_as_the_si_number(name):
    unit, call = CALLS[name]
    amount = AMOUNT.get(name, 7.0 if unit != "kg m^2" else 3.591e-4)
    plain = quantity(f"{amount!r} {unit}", SI[unit])
    assert call(amount * u(unit)) == call(plain)
    assert call(f"{amount!r} {unit}") == call(plain)


@pytest.mark.parametrize("name", CALLS)
def test_a_unit_of_another_kind_is_refused_with_what_it_measures(name):
    _, call = CALLS[name]
    with pytest.raises(UnitError, match='"kelvin" does not measure'):
        call(3.0 * u.kelvin)


# Subnormal numbers have too few digits for equal conversions.
@given(
    st.floats(-1e6, 1e6, allow_subnormal=False),
    st.sampled_from(["rad", "deg", "arcmin", "turn"]),
)
def test_a_pint_number_is_the_double_that_the_text_is(number, unit):
    given_as_text = rr.State(tilt=0.5, yaw=f"{number!r} {unit}").yaw
    assert rr.State(tilt=0.5, yaw=number * u(unit)).yaw == given_as_text


def test_arrays_with_units_are_converted():
    degrees = np.array([[30.0, 20.0], [10.0, 5.0]])
    ways = [
        degrees * u.deg,
        [[30.0 * u.deg, "20 deg"], (10.0 * u.deg, 5.0 * u.deg)],
        Package(degrees, "deg"),
        xr.DataArray(degrees, attrs={"units": "deg"}),
        xr.DataArray(degrees * u.deg),
        xr.DataArray(np.radians(degrees), attrs={"units": "rad"}),
    ]
    for way in ways:
        state = rr.State(tilt=way)
        assert type(state.tilt) in (np.ndarray, type(way))
        assert not np.asarray(state.tilt).flags.writeable
        np.testing.assert_allclose(state.tilt, np.radians(degrees), rtol=1e-15)


def test_times_of_a_motion_carry_units():
    motion = rr.simulate(CAN, START, rr.NoSlip(), "1 s")
    np.testing.assert_array_equal(
        motion([100.0, 200.0] * u.ms).tilt, motion([100.0 * 1e-3, 200.0 * 1e-3]).tilt
    )
    assert motion.evaluate(["100 ms", 200.0 * u.ms]).t.tolist() == [0.1, 0.2]
    with pytest.raises(rr.RimrollError, match=r"^t\[1\] must be inside the motion"):
        motion([100.0, 2000.0] * u.ms)


def test_quantities_of_other_packages_are_converted():
    assert rr.State(tilt=Package(30.0, "deg")).tilt == math.pi / 6
    assert body(mass=Package(70.0, "g")) == body()
    assert body(radius=Package(5.1, "cm")) == body()


@pytest.mark.parametrize(
    ("value", "says"),
    [
        (0.5 * u.m, '"meter" does not measure an angular rate'),
        (5.0 * u.Hz, '"hertz" does not measure an angular rate'),  # pint would take it for rad/s
        (5.0 * u.dimensionless, '"dimensionless" does not measure an angular rate'),
        (np.ones(3) / u.s, '"1 / second" does not measure an angular rate'),
        ([1.0, 5.0 * u.m], "yaw_rate[1] must be an angular rate"),
        (Package(5.0, "cm"), '"cm" does not measure an angular rate'),
        (xr.DataArray([1.0], attrs={"units": "cm"}), '"cm" does not measure an angular rate'),
        (np.timedelta64(5, "s"), "must be a number or an array of numbers"),
        ([np.timedelta64(5, "s")], "must be a number or an array of numbers"),
    ],
)
def test_what_is_no_angular_rate_is_refused(value, says):
    with pytest.raises(rr.RimrollError) as refusal:
        rr.State(tilt=0.5, yaw_rate=value)
    assert str(refusal.value).startswith("yaw_rate") and says in str(refusal.value)


def test_a_unit_that_cannot_be_converted_is_refused_and_not_dropped():
    class Stuck(np.ndarray):
        units = "furlong"

    stuck = np.array(0.5).view(Stuck)
    stuck.units = object()
    for make in (lambda: rr.State(tilt=stuck), lambda: body(mass=stuck)):
        with pytest.raises(UnitError, match="cannot be converted: give a plain number in"):
            make()


def test_a_time_of_numpy_is_no_number_of_seconds():
    with pytest.raises(rr.RimrollError, match=r"^duration must be a single number"):
        rr.simulate(CAN, START, rr.NoSlip(), np.timedelta64(500, "ms"))


@pytest.mark.parametrize("value", [True, np.True_, 1 + 5j, np.complex128(1 + 5j), b"1", None, []])
def test_what_is_no_real_number_is_refused(value):
    with pytest.raises(rr.RimrollError, match=r"^radius must be a single number"):
        rr.AirDrag.film(value)


@pytest.mark.parametrize(
    "one", [Decimal("0.07"), Fraction(7, 100), np.float64(0.07), np.array(0.07)]
)
def test_exact_numbers_and_numbers_of_numpy_are_taken(one):
    assert body(mass=one) == body()


MASKED = np.ma.masked_array([0.3, 0.4], [False, True])


@pytest.mark.parametrize("value", [MASKED, MASKED * u.rad, [MASKED, MASKED], MASKED[1]])
def test_masked_elements_are_no_data(value):
    with pytest.raises(rr.RimrollError, match="must have no masked elements"):
        rr.State(tilt=value)
    with pytest.raises(rr.RimrollError, match="must have no masked elements"):
        rr.fit(CAN, value)
    with pytest.raises(rr.RimrollError, match=r"^mass must have no masked elements"):
        body(mass=MASKED[1])


def test_an_array_with_a_mask_that_hides_nothing_is_taken():
    tilts = np.ma.masked_array([0.3, 0.4], [False, False])
    assert rr.State(tilt=tilts).tilt.tolist() == [0.3, 0.4]


def test_integers_beyond_64_bits_are_numbers_like_others():
    assert rr.State(tilt=0.5, yaw=2**70).yaw == 2.0**70
    assert rr.State(tilt=[0.5, 0.6], yaw=[2**70, 1]).yaw.tolist() == [2.0**70, 1.0]
    with pytest.raises(rr.RimrollError, match=r"yaw must be below 1\.8e308"):
        rr.State(tilt=[0.5, 0.6], yaw=[2**2000, 1])


def test_counts_are_plain_numbers():
    for count in ("5", 5.0 * u.m):
        with pytest.raises(rr.RimrollError, match=r"^max_steps must be"):
            rr.simulate(CAN, START, rr.NoSlip(), max_steps=count)


def test_measurements_keep_the_uncertainty_of_quantities():
    found = rr.measure(
        mass=u.Quantity(ufloat(70.0, 1.0), "g"),
        radius=ufloat(0.051, 0.0005),
        balance_point=6.9 * u.cm,
        swing_period="0.77 s",
    )
    assert found.mass.std_dev == pytest.approx(1e-3)
    assert found.radius.std_dev == 0.0005
    assert found.height.std_dev == 0.0


def test_pint_is_not_loaded_for_plain_numbers_and_everyday_texts():
    code = (
        "import sys, rimroll as rr\n"
        "rr.State(tilt='30 deg', yaw_rate='1 deg/s')\n"
        "rr.simulate(rr.bodies.can_2007(), rr.State(tilt=[0.5][0]), rr.NoSlip(), '10 ms')\n"
        "sys.exit('pint' in sys.modules)"
    )
    subprocess.run([sys.executable, "-c", code], check=True)
