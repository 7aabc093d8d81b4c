"""Quantities as people write them are converted to SI units and radians, or refused with a
reason."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from rimroll import RimrollError, units
from rimroll.errors import UnitError
from rimroll.units import quantity

KEPT = [  # texts that give the double nearest to their decimals
    ("5.1cm", "m", 0.051),
    ("6.9 cm", "m", 0.069),
    ("  70 g ", "kg", 0.07),
    ("-0.5 rad/s", "rad/s", -0.5),
    ("5130 mm^2 kg", "kg m^2", 5.13e-3),
    ("359.1 kg mm2", "kg m^2", 3.591e-4),
    ("0.14 g m²", "kg m^2", 1.4e-4),
    ("1 g/cm^3", "kg/m^3", 1000.0),
    ("9.8 m/s^2", "m/s^2", 9.8),
    ("9.8 m s^-2", "m/s^2", 9.8),
    ("980 cm/s**2", "m/s^2", 9.8),
    ("0.5 g", "m/s^2", 4.903325),
    ("980 gal", "m/s^2", 9.8),
    ("980 Gal", "m/s^2", 9.8),
    ("2", "s", 2.0),
    ("1e3 ms", "s", 1.0),
    ("2 min", "s", 120.0),
    ("1 in", "m", 0.0254),
    ("50%", "1", 0.5),
    ("0.5", "1", 0.5),
    (7, "m", 7.0),
    (0.25, "rad", 0.25),
]


@pytest.mark.parametrize(("text", "unit", "value"), KEPT)
def test_a_quantity_is_the_double_that_its_decimals_name(text, unit, value):
    assert quantity(text, unit) == value


@pytest.mark.parametrize("text", ["30deg", "30 deg", "30°", "30 degrees", "+30.0deg", "3e1 deg"])
def test_thirty_degrees_are_a_sixth_of_pi_however_written(text):
    assert quantity(text, "rad") == np.pi / 6


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("-30deg/s", -math.pi / 6),
        ("−30 °/s", -math.pi / 6),
        ("1 rev/s", 2 * math.pi),
        ("60 rpm", 2 * math.pi),
    ],
)
def test_rates_of_turning_count_in_radians(text, value):
    assert quantity(text, "rad/s") == pytest.approx(value, rel=1e-15, abs=0.0)


@given(st.floats(allow_nan=False, allow_infinity=False))
def test_a_plain_number_keeps_every_bit(number):
    assert quantity(repr(number), "m") == number
    assert quantity(number, "m") == number


def test_the_everyday_units_agree_with_the_registry():
    registry = units.registry()
    for (given_unit, si), factor in units._EVERYDAY.items():
        ours = registry.Quantity(1.0, given_unit)
        theirs = ours.to("dimensionless" if si == "1" else si).magnitude
        assert factor == pytest.approx(theirs, rel=1e-15, abs=0.0), given_unit


@pytest.mark.parametrize("unit", units.KINDS)
def test_the_example_in_each_message_is_itself_good(unit):
    _, example, _ = units.KINDS[unit]
    assert math.isfinite(quantity(example, unit))


BAD = [
    ("", "rad", "empty"),
    ("  ", "rad", "empty"),
    ("deg", "rad", "does not begin with a number"),
    ("thirty deg", "rad", "does not begin with a number"),
    ("30 foo", "rad", 'unknown unit "foo"'),
    ("30 cm", "rad", '"cm" does not measure an angle'),
    ("30 %", "rad", '"%" does not measure an angle'),
    ("3 Hz", "rad/s", '"Hz" does not measure an angular rate'),
    ("3 deg", "rad/s", '"deg" does not measure an angular rate'),
    ("3 rad", "1", '"rad" does not measure a pure number'),
    ("3 mm^2", "kg m^2", "does not measure a moment of inertia"),
    ("20 degC", "m", "does not measure a length"),
    ("5,1cm", "m", "point, not a comma"),
    ("5 cm 3", "m", "is no unit"),
    ("5 m/", "m", "is no unit"),
    ("5 m)", "m", "is no unit"),
    ("1 m^9**9**9**9", "m", "is no unit"),
    ("nan", "m", "not a finite number"),
    ("-inf kg", "kg", "not a finite number"),
    ("1e999 m", "m", "not a finite number"),
    ("1e308 km", "m", "too large"),
    (math.nan, "m", "not a finite number"),
    (math.inf, "m", "not a finite number"),
    (True, "m", "neither a number nor a text"),
    (None, "m", "neither a number nor a text"),
    ([1.0], "m", "neither a number nor a text"),
]


@pytest.mark.parametrize(("value", "unit", "why"), BAD)
def test_a_refusal_names_option_text_kind_example_and_reason(value, unit, why):
    with pytest.raises(UnitError) as refusal:
        quantity(value, unit, "--tilt")
    message = str(refusal.value)
    kind, example, _ = units.KINDS[unit]
    assert message.startswith(f'--tilt must be {kind} such as "{example}"')
    assert why in message
    assert "\n" not in message
    if not isinstance(value, str) or value.strip():
        assert str(value) in message


def test_a_unit_error_is_a_rimroll_error():
    assert issubclass(UnitError, RimrollError)
