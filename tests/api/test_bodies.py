"""Bodies: from numbers, presets, and composed of solids."""

import math
import pickle
from dataclasses import FrozenInstanceError, asdict, replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import rimroll as rr
from given.motions import CAN
from given.strategies import few, upright_solids


def test_a_body_is_a_value():
    other = rr.Body(*asdict(CAN).values())
    assert other == CAN and hash(other) == hash(CAN) and {CAN: 1}[other] == 1
    assert replace(CAN, height=0.07) != CAN
    assert pickle.loads(pickle.dumps(CAN)) == CAN
    assert eval(repr(CAN), {"Body": rr.Body}) == CAN
    with pytest.raises(FrozenInstanceError):
        CAN.mass = 1.0


@pytest.mark.parametrize(
    ("changed", "complaint"),
    [
        ({"mass": 0.0}, "mass must be > 0, got 0 kg"),
        ({"radius": -1.0}, "radius must be > 0, got -1 m"),
        ({"height": -0.1}, "height must be >= 0, got -0.1 m"),
        ({"transverse_inertia": 0.0}, "transverse_inertia must be > 0, got 0 kg m2"),
        ({"axial_inertia": np.nan}, "axial_inertia must be a finite number, got NaN"),
        ({"axial_inertia": 1.0}, "no rigid body has more), got 1 kg m2"),
        ({"mass": "heavy"}, "mass must be a mass such as"),
        ({"mass": [1.0, -2.0]}, "mass[1] must be > 0, got -2 kg"),
        ({"mass": ["heavy"]}, "mass[0] must be a mass such as"),
    ],
)
def test_what_is_no_body_is_refused_with_a_sentence(changed, complaint):
    with pytest.raises(rr.RimrollError) as refusal:
        replace(CAN, **changed)
    assert complaint in str(refusal.value)


def test_a_body_takes_numbers_of_any_kind():
    body = rr.Body(1, np.float32(0.5), 0, np.float64(0.2), np.array(0.25))
    assert [type(value) for value in asdict(body).values()] == [float] * 5


def summed(parts, rim):
    """The body of rings of matter: each part fills radii a..b and heights p..q with a density.

    Parts are (density, a, b, p, q) in kg/m3 and m; 300 x 300 rings each, so 1e-5 from exact.
    """
    rings = []
    for density, a, b, p, q in parts:
        n = 300
        r = a + (b - a) * (np.arange(n) + 0.5) / n
        z = p + (q - p) * (np.arange(n) + 0.5) / n
        r, z = np.meshgrid(r, z)
        rings.append((density * 2 * np.pi * r * (b - a) * (q - p) / n**2, r, z))
    dm, r, z = (np.concatenate([part[i].ravel() for part in rings]) for i in range(3))
    mass = dm.sum()
    height = (dm * z).sum() / mass
    axial = (dm * r**2).sum()
    return rr.Body(mass, rim, height, axial / 2 + (dm * (z - height) ** 2).sum(), axial)


def assert_same_body(body, other, rtol):
    np.testing.assert_allclose(list(asdict(body).values()), list(asdict(other).values()), rtol)


def solid_part(mass, radius, length):
    return (mass / (np.pi * radius**2 * length), 0.0, radius, 0.0, length)


def test_the_can_of_the_paper_has_the_paper_s_numbers():
    """Section "Quantitative comparisons"; C is estimated."""
    assert (CAN.mass, CAN.radius, CAN.height) == (0.070, 0.051, 0.069)
    assert CAN.transverse_inertia / CAN.mass == pytest.approx(5.13e-3, rel=1e-15, abs=0.0)
    assert CAN.axial_inertia / CAN.mass == pytest.approx(2.0e-3, rel=1e-15, abs=0.0)


@pytest.mark.parametrize("fill", [0.0, 0.4, 1.0])
def test_a_soda_can_weighs_and_turns_as_its_nominal_sizes_say(fill):
    """The preset takes the sheets as infinitely thin: 0.3 mm of 33 mm, squared."""
    aluminium, mm = 2700.0, 1e-3
    parts = [
        (aluminium, 32.95 * mm, 33.05 * mm, 0.0, 115 * mm),
        (aluminium, 0.0, 33 * mm, 4.85 * mm, 5.15 * mm),
        (aluminium, 0.0, 26 * mm, 114.875 * mm, 115.125 * mm),
    ]
    if fill:
        parts.append((1000.0, 0.0, 33 * mm, 5 * mm, (5 + 97 * fill) * mm))
    assert_same_body(rr.bodies.soda_can(fill), summed(parts, 24 * mm), 1e-4)


@pytest.mark.parametrize("fill", [0.0, 0.4, 1.0])
def test_a_beer_bottle_weighs_and_turns_as_its_nominal_sizes_say(fill):
    """The preset takes the glass as infinitely thin: in the neck 2.8 mm of 13.6 mm, squared/4."""
    glass, mm = 2500.0, 1e-3
    parts = [
        (glass, 28.3 * mm, 30.5 * mm, 0.0, 130 * mm),
        (glass, 12.2 * mm, 15.0 * mm, 130 * mm, 230 * mm),
        (glass, 0.0, 28.3 * mm, 0.0, 6 * mm),
    ]
    if fill:
        parts.append((1000.0, 0.0, 28.3 * mm, 6 * mm, (6 + 124 * fill) * mm))
    assert_same_body(rr.bodies.beer_bottle(fill), summed(parts, 26 * mm), 2e-3)


@pytest.mark.parametrize(
    ("body", "part"),
    [
        # European Central Bank; IEC 60086-2; the toy; water.
        (rr.bodies.coin(), solid_part(7.5e-3, 11.625e-3, 2.33e-3)),
        (rr.bodies.battery(), solid_part(23e-3, 7.25e-3, 50.5e-3)),
        (rr.bodies.euler_disk(), (7850.0, 0.0, 37.5e-3, 0.0, 12.7e-3)),
        (rr.bodies.cylinder(0.05, 0.2), (1000.0, 0.0, 0.05, 0.0, 0.2)),
    ],
    ids=["coin", "battery", "euler_disk", "cylinder"],
)
def test_solid_cylinders_weigh_and_turn_as_their_sizes_say(body, part):
    assert_same_body(body, summed([part], part[2]), 2e-5)
    assert body.height == pytest.approx(part[4] / 2)


def test_a_toy_euler_disk_weighs_440_g():
    assert rr.bodies.euler_disk().mass == pytest.approx(0.440, abs=1e-3)


def test_ideal_disk_and_ring_are_flat_with_the_textbook_moments():
    """k^2 = 1/2 and k = 1; C = 2A for flat bodies."""
    for body, k_squared in (rr.bodies.disk(0.3), 0.5), (rr.bodies.ring(0.3), 1.0):
        assert (body.mass, body.radius, body.height) == (1.0, 0.3, 0.0)
        assert body.axial_inertia == pytest.approx(k_squared * 0.3**2, rel=1e-15, abs=0.0)
        assert body.axial_inertia == pytest.approx(2 * body.transverse_inertia, rel=1e-15, abs=0.0)


def test_presets_are_found_by_name():
    for name, preset in rr.bodies.PRESETS.items():
        assert rr.bodies.by_name(name) == rr.bodies.by_name(name.replace("_", "-")) == preset()
    with pytest.raises(rr.RimrollError, match="unknown body 'keg'"):
        rr.bodies.by_name("keg")
    with pytest.raises(rr.RimrollError, match=r'got 50: for percent write 0\.5 or "50 %"$'):
        rr.bodies.soda_can(50)
    with pytest.raises(rr.RimrollError, match=r"fill must be between 0 and 1, got 1\.5"):
        rr.bodies.soda_can(1.5)


@few
@given(solid=upright_solids(0.1))
def test_composing_one_solid_keeps_its_numbers(solid):
    body = rr.Body.from_solids(0.1, [solid])
    assert (body.mass, body.height) == (solid.mass, pytest.approx(solid.height, rel=1e-15, abs=0.0))
    assert body.transverse_inertia == pytest.approx(solid.transverse_inertia, rel=1e-14, abs=0.0)
    assert body.axial_inertia == pytest.approx(solid.axial_inertia, rel=1e-14, abs=0.0)


@few
@given(solids=st.lists(upright_solids(0.1), min_size=2, max_size=5))
def test_composing_follows_the_parallel_axis_theorem(solids):
    body = rr.Body.from_solids(0.1, solids)
    mass = sum(s.mass for s in solids)
    height = sum(s.mass * s.height for s in solids) / mass
    transverse = sum(s.transverse_inertia + s.mass * (s.height - height) ** 2 for s in solids)
    axial = sum(s.axial_inertia for s in solids)
    assert_same_body(body, rr.Body(mass, 0.1, height, transverse, axial), 1e-12)


@pytest.mark.parametrize(
    ("solid", "part"),
    [
        (rr.solids.cylinder(1.0, 0.1, 0.3, 0.2), (1 / (np.pi * 0.003), 0.0, 0.1, 0.2, 0.5)),
        (
            rr.solids.hollow_cylinder(1.0, 0.06, 0.1, 0.3),
            (1 / (np.pi * 0.3 * 0.0064), 0.06, 0.1, 0.0, 0.3),
        ),
        (rr.solids.filling(800.0, 0.1, 0.3, 0.2), (800.0, 0.0, 0.1, 0.2, 0.5)),
        # Thin bodies have a thickness of 1e-6 m.
        (rr.solids.disk(1.0, 0.1, 0.2), (1 / (np.pi * 1e-8), 0.0, 0.1, 0.2, 0.200001)),
        (rr.solids.wall(1.0, 0.1, 0.3, 0.2), (1 / (np.pi * 0.06e-6), 0.1, 0.100001, 0.2, 0.5)),
        (
            rr.solids.ring(1.0, 0.1, 0.2),
            (1 / (np.pi * 0.2e-12), 0.1, 0.100001, 0.2, 0.200001),
        ),
    ],
    ids=["cylinder", "hollow_cylinder", "filling", "disk", "wall", "ring"],
)
def test_solids_have_the_moments_of_the_rings_they_are_made_of(solid, part):
    assert_same_body(rr.Body.from_solids(0.1, [solid]), summed([part], 0.1), 5e-5)


def test_a_box_has_the_mean_of_its_moments_across():
    """From the second moments of points that fill it, by integration on a grid."""
    width, thickness, length, base = 0.07, 0.008, 0.15, 0.02
    sides = np.meshgrid(*[(np.arange(60) + 0.5) / 60 - 0.5] * 3, indexing="ij")
    x, y, z = (side * one for side, one in zip(sides, (width, thickness, length), strict=True))
    mean_across = np.mean((y**2 + z**2 + x**2 + z**2) / 2)
    box = rr.solids.box("190 g", width, thickness, length, base)
    assert (box.mass, box.height) == (0.19, pytest.approx(base + 0.5 * length))
    assert box.transverse_inertia == pytest.approx(0.19 * mean_across, rel=1e-3)
    assert box.axial_inertia == pytest.approx(0.19 * np.mean(x**2 + y**2), rel=1e-3)


@pytest.mark.parametrize(
    ("make", "complaint"),
    [
        (lambda: rr.solids.box(1.0, 0.0, 0.1, 0.1), "width must be > 0 and finite, got 0 m"),
        (lambda: rr.solids.disk(-1.0, 0.1), "mass must be > 0, got -1 kg"),
        (lambda: rr.solids.ring(1.0, 0.0), "radius must be > 0, got 0 m"),
        (lambda: rr.solids.wall(1.0, 0.1, -0.1), "length must be >= 0, got -0.1 m"),
        (lambda: rr.solids.hollow_cylinder(1, 2, 1, 1), "at most outer_radius = 1 m, got 2 m"),
        (lambda: rr.solids.filling(0.0, 1, 1), "density must be > 0, got 0 kg/m3"),
        (lambda: rr.Body.from_solids(0.1, []), "solids must name at least one solid, got none"),
        (
            lambda: rr.Body.from_solids(0.1, [rr.solids.disk(1.0, 0.1, -0.2)]),
            "height must be >= 0, got -0.2 m",
        ),
    ],
)
def test_what_is_no_solid_is_refused_with_a_sentence(make, complaint):
    with pytest.raises(rr.RimrollError) as refusal:
        make()
    assert complaint in str(refusal.value)


def test_arrays_of_no_bodies_are_refused():
    with pytest.raises(rr.RimrollError, match=r"^bodies must be one or more, got none"):
        rr.Body([], 0.05, 0.07, 3e-4, 1e-4)


@pytest.mark.parametrize(
    ("given", "factor"), [({"density": "2700 kg/m3"}, 2.7), ({"mass": 54.0}, 5.4)]
)
def test_a_cylinder_has_the_mass_or_the_density_that_is_given(given, factor):
    radius, length = (0.01 / (math.pi * 0.25)) ** 0.5, 0.25  # 10 l, which are 10 kg of water
    water = rr.bodies.cylinder(radius, length)
    body = rr.bodies.cylinder(radius, length, **given)
    assert (body.radius, body.height) == (water.radius, water.height)
    for name in ("mass", "transverse_inertia", "axial_inertia"):
        assert getattr(body, name) == pytest.approx(factor * getattr(water, name), rel=1e-12)
    with pytest.raises(rr.RimrollError, match="give one"):
        rr.bodies.cylinder(radius, length, mass=1.0, density=1.0)
