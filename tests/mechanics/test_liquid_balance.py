"""The balance of bodies with a liquid filling, against the maximum of their potential energy."""

import pickle
from dataclasses import asdict, replace

import numpy as np
import pytest
from scipy.optimize import brentq, minimize_scalar

import rimroll as rr

NODES = 800
# Gauss quadrature with the weight sqrt(1 - x^2): slices of a round vessel across its tilt.
ANGLES = np.pi * np.arange(1, NODES + 1) / (NODES + 1)
SLICES, AREAS = np.cos(ANGLES), 2.0 * np.pi / (NODES + 1) * np.sin(ANGLES) ** 2


def columns(filling, tilt):
    """The depth of the liquid in each slice, found by its volume; m."""
    below = SLICES * filling.radius * np.tan(tilt)
    wanted = np.pi * filling.depth
    highest = filling.depth + abs(below).max() + 1e-6

    def depths(surface):
        return np.clip(surface - below, 0.0, filling.length)

    return depths(brentq(lambda c: AREAS @ depths(c) - wanted, -highest, highest, xtol=1e-16))


def energy(body, tilt):
    """The potential energy over g of a body on its rim with a level filling, kg m."""
    filling, sin, cos = body.filling, np.sin(tilt), np.cos(tilt)
    shell = body.mass - filling.mass
    height = (body.mass * body.height - filling.mass * filling.height) / shell
    depth = columns(filling, tilt)
    across = body.radius + SLICES * filling.radius
    level = across * sin + (filling.base + 0.5 * depth) * cos
    liquid = AREAS @ (depth * level) / (np.pi * filling.depth)
    return shell * (body.radius * sin + height * cos) + filling.mass * liquid


def vessel(draw):
    """A random cylinder of wall and liquid on a rim of another radius, with a lid or open."""
    inner, tall = draw.uniform(0.02, 0.05), draw.uniform(0.01, 0.15)
    base = draw.uniform(0.0, 0.01)
    depth = tall * draw.uniform(*draw.choice([(0.01, 0.1), (0.1, 0.9), (0.9, 0.99)]))
    wall = rr.solids.wall(draw.uniform(0.005, 0.3), inner, tall, base)
    lid = None if draw.random() < 0.2 else tall
    liquid = rr.solids.filling(draw.uniform(700, 1500), inner, depth, base, lid)
    return rr.Body.from_solids(inner * draw.uniform(0.6, 1.3), [wall, liquid])


def test_the_balance_is_where_the_potential_energy_is_largest():
    draw = np.random.default_rng(5)
    seen = []
    for _ in range(40):
        body = vessel(draw)
        tilt = rr.balance_tilt(body, liquid=True)
        most = minimize_scalar(
            lambda t, body=body: -energy(body, t),
            bounds=(0.0, rr.balance_tilt(body)),
            method="bounded",
            options={"xatol": 1e-7},
        )
        # The sum over slices is wrong by some 1e-7 where the surface cuts the floor or the lid.
        assert tilt == pytest.approx(most.x, abs=3e-5)
        assert tilt < rr.balance_tilt(body)
        # There is no second balance, at which the body would rest.
        along = np.array([energy(body, t) for t in np.linspace(0.0, 1.5, 15)])
        assert np.all(np.diff(along, 2) < 0.0)
        depth = columns(body.filling, tilt)
        seen.append((depth.min() == 0.0, depth.max() == body.filling.length))
    cases = {case: seen.count(case) for case in seen}
    assert len(cases) == 4 and min(cases.values()) >= 3, cases


# From quadrature of the liquid in slices, to all digits shown.
@pytest.mark.parametrize(
    ("fill", "degrees"),
    [(0.1, 30.5749), (0.3, 35.7882), (0.5, 32.9825), (0.8, 26.6147), (1.0, 23.0508)],
)
def test_a_drinks_can_balances_at_known_tilts(fill, degrees):
    can = rr.bodies.soda_can(fill)
    assert np.degrees(rr.balance_tilt(can, liquid=True)) == pytest.approx(degrees, abs=6e-5)


@pytest.mark.parametrize("preset", [rr.bodies.soda_can, rr.bodies.beer_bottle])
@pytest.mark.parametrize("fill", [1e-6, 0.4, 1.0])
def test_a_filled_body_is_the_empty_one_with_its_filling(preset, fill):
    body, empty = preset(fill), preset(0.0)
    shell = rr.solids.Solid(empty.mass, empty.height, empty.transverse_inertia, empty.axial_inertia)
    whole = rr.Body.from_solids(body.radius, [shell, body.filling])
    for name, value in asdict(whole).items():
        assert value == pytest.approx(getattr(body, name), rel=1e-12)
    assert rr.balance_tilt(whole, liquid=True) == pytest.approx(
        rr.balance_tilt(body, liquid=True), rel=1e-10
    )


def test_a_vessel_that_is_full_to_its_lid_is_as_if_frozen():
    wall = rr.solids.wall(0.02, 0.03, 0.1)
    for part, differs in (1.0, 1e-15), (1.0 - 1e-9, 1e-6), (0.999, 1e-3):
        liquid = rr.solids.filling(1000, 0.03, 0.1 * part, length=0.1)
        body = rr.Body.from_solids(0.03, [wall, liquid])
        assert 0.0 <= rr.balance_tilt(body) - rr.balance_tilt(body, liquid=True) <= differs


def test_a_body_knows_its_filling_until_its_numbers_change():
    can = rr.bodies.soda_can(0.3)
    assert pickle.loads(pickle.dumps(can)).filling == can.filling
    for body in rr.bodies.soda_can(), replace(can, height=0.05), rr.bodies.coin():
        assert body.filling is None
        with pytest.raises(rr.RimrollError, match="body has no filling to be liquid"):
            rr.balance_tilt(body, liquid=True)


def test_a_filling_is_not_deeper_than_its_vessel():
    with pytest.raises(rr.RimrollError, match=r"length must be at least the depth, 0.1 m, got 0"):
        rr.solids.filling(1000, "3 cm", "10 cm", length="9 cm")
