"""The contact laws as Python objects: their numbers, names, sums and surfaces."""

import math

import numpy as np
import pytest

import rimroll as rr
from rimroll import laws, units
from rimroll.errors import typed
from rimroll.laws import surfaces

CAN = rr.bodies.can_2007()
NOT_NUMBERS = [np.nan, np.inf, -np.inf, "0.2 m", None, True, [0.1, -0.2]]


@pytest.mark.parametrize("value", [*NOT_NUMBERS, -0.1, 1e7])
def test_friction_is_a_number_not_below_zero(value):
    with pytest.raises(rr.RimrollError, match=r"^friction(\[1\])? must be"):
        rr.Coulomb(value)
    with pytest.raises(rr.RimrollError, match=r"^friction(\[1\])? must be"):
        rr.Stribeck(value)


def test_sticking_is_not_easier_to_break_than_sliding_is_to_keep():
    with pytest.raises(rr.RimrollError, match=r"^static must be between friction = 0.3"):
        rr.Coulomb(0.3, static=0.2)
    assert rr.Coulomb(0.3, static=0.3).static == 0.3


@pytest.mark.parametrize("value", [-0.1, 1.1, 2, np.nan])
def test_no_landing_gives_back_more_than_it_took(value):
    for law in (
        lambda: rr.Coulomb(0.3, restitution=value),
        lambda: rr.Viscous(1.0, restitution=value),
        lambda: rr.Stribeck(0.3, restitution=value),
    ):
        with pytest.raises(rr.RimrollError, match=r"^restitution must be"):
            law()


@pytest.mark.parametrize(
    ("law", "says"),
    [
        (lambda: rr.Viscous(-1.0), "coefficient must be >= 0, got -1 N s/m"),
        (lambda: rr.Stribeck(0.3, stribeck_speed=0.0), "stribeck_speed must be > 0, got 0 m/s"),
        (lambda: rr.Stribeck(0.3, creep_speed=-1.0), "creep_speed must be > 0, got -1 m/s"),
        (lambda: rr.NoSlip() + rr.RollingResistance(-1.0), "rolling_resistance dry must be >= 0"),
        (lambda: rr.NoSlip() + rr.RollingResistance(0, -1), "rolling_resistance viscous must be"),
        (lambda: rr.NoSlip() + rr.PivotingFriction(-1.0), "pivoting_friction must be >= 0"),
        (lambda: rr.NoSlip() + rr.AirDrag(1.0, 9.0), "air_drag exponent must be between 1.5"),
        (lambda: rr.NoSlip() + rr.AirDrag(np.nan), "air_drag must be a finite number"),
        (lambda: rr.NoSlip() + 0.3, "what is added to a law must be a rimroll.RollingResistance"),
        (lambda: rr.NoSlip() + rr.Coulomb(0.3), "what is added to a law must be"),
        (
            lambda: rr.NoSlip() + rr.AirDrag(1e-9) + rr.AirDrag(1e-9),
            "a law takes one AirDrag, got two",
        ),
    ],
)
def test_each_number_of_a_law_has_its_bounds(law, says):
    with pytest.raises(rr.RimrollError, match=says):
        law()


@pytest.mark.parametrize("value", [-0.05, 0.0, math.nan, math.inf])
@pytest.mark.parametrize(
    ("name", "unit"), [("radius", "m"), ("viscosity", "Pa s"), ("gravity", "m/s^2")]
)
def test_a_film_needs_a_radius_a_viscosity_and_gravity(name, unit, value):
    with pytest.raises(rr.RimrollError) as refusal:
        rr.AirDrag.film(**{"radius": 0.05, name: value})
    assert str(refusal.value) == f"{name} must be > 0 and finite, got {value:g} {unit}"


def test_resistances_add_up_and_are_shown():
    law = rr.Coulomb(0.3) + rr.RollingResistance(dry=1e-3) + rr.PivotingFriction(1e-4)
    assert repr(law) == (
        "Coulomb(friction=0.3) + RollingResistance(dry=0.001) + PivotingFriction(length=0.0001)"
    )
    assert law == rr.Coulomb(0.3) + rr.RollingResistance(dry=1e-3) + rr.PivotingFriction(1e-4)
    assert law.numbers["rolling_dry"] == 1e-3 and law.numbers["pivoting_length"] == 1e-4


def test_a_law_repeats_as_python_would_write_it():
    for law in (rr.NoSlip(), rr.Coulomb(0.3, 0.4, 0.5), rr.Viscous(2.0), rr.Stribeck(0.1)):
        assert eval(repr(law), vars(rr)) == law


@pytest.mark.parametrize("name", laws.LAWS)
def test_a_law_is_found_however_its_name_is_spelt(name):
    spelt = {name, typed(name), name.replace("_", ""), name.upper(), typed(name).title()}
    assert {laws.kind(spelling) for spelling in spelt} == {laws.LAWS[name]}


def test_a_law_by_name_takes_its_numbers():
    assert laws.by_name("coulomb", {"friction": 0.2}) == rr.Coulomb(0.2)
    with pytest.raises(rr.RimrollError, match=r"^coulomb needs friction"):
        laws.by_name("coulomb")
    with pytest.raises(rr.RimrollError, match=r"^no-slip takes no numbers, got friction"):
        laws.by_name("no-slip", {"friction": 0.2})
    with pytest.raises(rr.RimrollError, match=r"^viscous takes coefficient, restitution, got"):
        laws.by_name("viscous", {"friction": 0.2})


@pytest.mark.parametrize(
    ("typo", "meant"),
    [("noslp", "no-slip"), ("colomb", "coulomb"), ("frictionles", "frictionless")],
)
def test_the_error_about_a_misspelt_law_suggests_the_right_name(typo, meant):
    with pytest.raises(rr.RimrollError, match=f"unknown law '{typo}': did you mean '{meant}'"):
        laws.by_name(typo)


def test_surfaces_are_dry_friction_in_rising_order():
    friction = [make().friction for make in surfaces.SURFACES.values()]
    assert friction == sorted(friction)
    assert surfaces.ice() == rr.Coulomb(0.03)
    assert surfaces.wood(static=0.5, restitution=0.2) == rr.Coulomb(0.3, 0.5, 0.2)
    assert surfaces.by_name("Rubber") == surfaces.rubber()
    for make in surfaces.SURFACES.values():
        assert "Source: " in make.__doc__


def test_the_papers_can_slips_on_wood_and_rolls_on_rubber():
    needed = rr.needed_friction(CAN)
    assert surfaces.wood().friction < needed < surfaces.rubber().friction
    assert rr.turn_limit(CAN, surfaces.rubber()) == pytest.approx(
        rr.turn_limit(CAN, rr.NoSlip()), abs=1e-8
    )
    assert rr.turn_limit(CAN, surfaces.wood()) > rr.turn_limit(CAN, rr.NoSlip()) + 1e-3


@pytest.mark.parametrize(
    ("text", "unit", "value"),
    [
        ("2 N s/m", "N s/m", 2.0),
        ("3 mN s/m", "N s/m", 3e-3),
        ("3 kg/s", "N s/m", 3.0),
        ("2 cm/s", "m/s", 0.02),
        ("1e-9 W s^4/rad^4", units.air_unit(4.0), 1e-9),
        ("1e-9 W (s/rad)^2.5", units.air_unit(2.5), 1e-9),
        (1e-9, units.air_unit(4.0), 1e-9),
    ],
)
def test_numbers_of_laws_carry_units(text, unit, value):
    assert units.quantity(text, unit) == value


def test_air_drag_in_another_exponents_unit_is_refused():
    with pytest.raises(rr.RimrollError, match="does not measure a coefficient of air drag"):
        units.quantity("1e-9 W s^4/rad^4", units.air_unit(2.5))


def test_laws_are_values_that_are_found_by_name():
    assert rr.NoSlip() == rr.NoSlip() != rr.Frictionless()
    assert laws.by_name("no-slip") == rr.NoSlip()
    with pytest.raises(rr.RimrollError, match="unknown law 'glue': choose from no-slip"):
        laws.by_name("glue")
