"""Random bodies and random starts, for properties that hold for all of them."""

from dataclasses import dataclass

import numpy as np
from hypothesis import settings
from hypothesis import strategies as st

import rimroll as rr
from oracles.paper_equations import LAWS, doubled_kinetic_energy


def drawn(count):
    """`count` in `make soak`; otherwise the fraction of it that the current profile draws."""
    return max(1, count * settings.default.max_examples // 100)


def examples(count, **options):
    """Settings for this many random examples in `make soak`, and for fewer otherwise."""
    return settings(max_examples=drawn(count), **options)


few = examples(60, derandomize=True)


def sizes(low, high):
    """Numbers over decades: each decade between `low` and `high` is equally likely."""
    return st.floats(np.log(low), np.log(high)).map(np.exp).map(float)


@st.composite
def upright_solids(draw, radius):
    """A part of a body that stands on a rim of this radius (m); it may be wider than the rim."""
    mass = draw(sizes(0.01, 3.0))
    across = radius * draw(st.floats(0.3, 1.5))
    length = radius * draw(st.floats(0.1, 5.0))
    base = radius * draw(st.floats(0.0, 2.0))
    shape = draw(st.sampled_from(["cylinder", "hollow_cylinder", "disk", "ring", "wall"]))
    if shape == "hollow_cylinder":
        bore = across * draw(st.floats(0.1, 0.95))
        return rr.solids.hollow_cylinder(mass, bore, across, length, base)
    if shape in ("disk", "ring"):
        return getattr(rr.solids, shape)(mass, across, base)
    return getattr(rr.solids, shape)(mass, across, length, base)


@st.composite
def flat_solids(draw, radius):
    """A part without height, at the height of the rim: of such a body, H = 0."""
    shape = draw(st.sampled_from([rr.solids.disk, rr.solids.ring]))
    return shape(draw(sizes(0.01, 3.0)), radius * draw(st.floats(0.6, 1.5)))


@st.composite
def composed_bodies(draw, solids=upright_solids):
    """Bodies composed of one to three solids."""
    radius = draw(sizes(0.01, 0.5))
    return rr.Body.from_solids(radius, draw(st.lists(solids(radius), min_size=1, max_size=3)))


@st.composite
def free_bodies(draw, height=None):
    """Bodies given by five numbers, up to the C = 2A beyond which there is no rigid body."""
    mass, radius = draw(sizes(0.01, 3.0)), draw(sizes(0.01, 0.5))
    if height is None:
        height = draw(st.floats(0.05, 5.0) | st.floats(0.0, 0.5) | st.just(0.0))
    transverse = draw(sizes(0.25, 10.0))
    return rr.Body(
        mass=mass,
        radius=radius,
        height=height * radius,
        transverse_inertia=transverse * mass * radius**2,
        axial_inertia=transverse * draw(st.floats(0.1, 2.0)) * mass * radius**2,
    )


def disks():
    """Bodies with H = 0."""
    return composed_bodies(flat_solids) | free_bodies(height=0.0)


def bodies():
    """Bodies of all kinds, disks among them."""
    return composed_bodies() | free_bodies()


@dataclass(frozen=True)
class Rocking:
    """A body, its start, and gravity (m/s2)."""

    body: rr.Body
    start: rr.State
    gravity: float

    @property
    def time(self):
        """2 sqrt(J/(mgR)), s: about as long as a fall and a rise take."""
        tipping = _inertia_about_the_rim(self.body)
        return 2.0 * np.sqrt(tipping / (self.body.mass * self.gravity * self.body.radius))


@st.composite
def rockings(draw, bodies=bodies(), least_sideways=1e-3):  # noqa: B008 (a strategy is a constant)
    """Bodies with starts from which they rock, since their energy is too small to pass the balance
    point.

    Yaw and spin rates are between `least_sideways` and 0.1 of sqrt(g/R), in all combinations of
    signs; the tilt rate is up or down.
    """
    body, gravity = draw(bodies), draw(st.sampled_from([1.62, 9.8, 24.8]))
    tilt = rr.balance_tilt(body) * draw(st.floats(0.2, 0.8))
    lift = np.hypot(body.radius, body.height) * (1 - np.cos(rr.balance_tilt(body) - tilt))
    barrier = body.mass * gravity * lift
    falling_rate = np.sqrt(gravity / body.radius)

    def sideways_rate():
        sign = draw(st.sampled_from([-1.0, 1.0]))
        return sign * falling_rate * draw(sizes(least_sideways, 0.1))

    rates = np.array(
        [
            sideways_rate(),
            draw(st.floats(-0.5, 0.5)) * np.sqrt(2 * barrier / _inertia_about_the_rim(body)),
            sideways_rate(),
        ]
    )
    energy = max(doubled_kinetic_energy(body, law, tilt, *rates) for law in LAWS) / 2
    yaw_rate, tilt_rate, spin_rate = rates * min(1.0, np.sqrt(0.7 * barrier / energy))
    start = rr.State(
        tilt=tilt,
        tilt_rate=tilt_rate,
        yaw=draw(st.floats(-3.0, 3.0)),
        yaw_rate=yaw_rate,
        spin=draw(st.floats(-3.0, 3.0)),
        spin_rate=spin_rate,
    )
    return Rocking(body, start, gravity)


def _inertia_about_the_rim(body):
    return body.transverse_inertia + body.mass * (body.radius**2 + body.height**2)
