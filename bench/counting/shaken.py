"""Random bodies on tables that move, and their mirror images and scaled copies."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

import rimroll as rr
from counting.draws import decades
from counting.engines import Array
from rimroll.laws import Resistance

MAX_STEPS = 30_000
RESISTANCES = ("rolling", "viscous rolling", "pivoting", "air")
MIRRORED = {"smooth_left": "smooth_right", "smooth_right": "smooth_left"}
RATES = ("tilt_rate", "yaw_rate", "spin_rate")


@dataclass(frozen=True)
class Shaken:
    """All that determines a motion on a moving table. The last five numbers make copies of it."""

    body: rr.Body
    start: rr.State
    law: rr.Law
    pulse: tuple[str, Array, float]
    """Kind, amplitude (m/s²), and period or duration (s)."""
    record: tuple[float, Array]
    """The step (s) and samples (n, 3), none where the table moves by the pulse alone."""
    flat: Any
    flat_gap: float
    duration: float
    gravity: float
    rtol: float
    slower: float = 1.0
    mirrored: bool = False
    turned: float = 0.0
    ground_scale: float = 1.0
    upward: float = 0.0
    """A further constant acceleration of the table, m/s²."""

    def ground(self) -> rr.Ground:
        """The motion of the table."""
        signs = self.ground_scale * np.array([1.0, -1.0 if self.mirrored else 1.0, 1.0])
        kind, amplitude, time = self.pulse
        step, samples = self.record
        ground: rr.Ground = getattr(rr.ground, kind)(signs * amplitude, self.slower * time)
        if len(samples):
            record = rr.ground.sampled(self.slower * step, samples * signs)
            # A record alone has steps of its own.
            ground = ground + record if amplitude.any() else record
        if self.upward:
            ground += rr.ground.rectangular((0.0, 0.0, self.upward), 2.0 * self.duration)
        return ground.rotated(self.turned) if self.turned else ground

    def options(self) -> dict[str, Any]:
        """Options of ``rr.simulate`` and ``rr.shake_many``."""
        names = ("duration", "gravity", "rtol", "flat", "flat_gap")
        return {name: getattr(self, name) for name in names} | {"max_steps": MAX_STEPS}

    def motion(self, jacobian: bool = False) -> rr.Motion:
        """The motion."""
        options = self.options() | {"ground": self.ground(), "jacobian": jacobian}
        return rr.simulate(self.body, self.start, self.law, **options)

    def started(self, **numbers: float) -> Shaken:
        """The same from a start that differs in some numbers."""
        return replace(self, start=rr.State.computed(**(vars(self.start) | numbers)))

    def mirror_image(self) -> Shaken:
        """What a mirror shows that exchanges y and -y."""
        start = {name: -getattr(self.start, name) for name in ("yaw", "spin", *RATES[1:])}
        flat = MIRRORED.get(self.flat, self.flat)
        return replace(self.started(**start), mirrored=True, flat=flat)

    def turned_by(self, angle: float) -> Shaken:
        """The same in another direction."""
        return replace(self.started(yaw=self.start.yaw + angle), turned=angle)

    def enlarged(self, size: float) -> Shaken:
        """A body of another size, whose times grow with the square root; without resistances."""
        slower, body = math.sqrt(size), self.body
        start = {name: getattr(self.start, name) / slower for name in RATES}
        inertias = (size**2 * body.transverse_inertia, size**2 * body.axial_inertia)
        large = rr.Body(body.mass, size * body.radius, size * body.height, *inertias)
        sizes = {"duration": slower * self.duration, "flat_gap": size * self.flat_gap}
        return replace(self.started(**start), body=large, slower=slower, **sizes)


def resistance(kind: str, size: float, body: rr.Body, gravity: float) -> Resistance:
    """A resistance of about ``size`` times the weight, or that takes such a part of the energy in
    the time of falling."""
    rate = math.sqrt(gravity / body.radius)
    if kind == "rolling":
        return rr.RollingResistance(dry=size)
    if kind == "viscous rolling":
        return rr.RollingResistance(viscous=size * body.mass * rate)
    if kind == "pivoting":
        return rr.PivotingFriction(size * body.radius)
    return rr.AirDrag(size * body.mass * gravity * body.radius / rate**3)


def draw(seed: int, number: int) -> Shaken:
    """Motion ``number`` of the census with a seed."""
    rng = np.random.default_rng([seed, number])
    radius, mass = decades(rng, 0.01, 1.0), decades(rng, 1e-3, 1e3)
    slenderness = decades(rng, 1.0, 12.0) if rng.random() < 0.5 else decades(rng, 0.01, 3.0)
    height = radius * slenderness * float(rng.random() < 0.9)
    axial, arms = mass * radius**2 * decades(rng, 0.05, 1.5), mass * (radius**2 + height**2)
    transverse = 0.5 * axial + arms * decades(rng, 0.02, 1.5)
    body = rr.Body(mass, radius, height, transverse, axial)
    gravity = rr.STANDARD_GRAVITY if rng.random() < 0.5 else decades(rng, 0.1, 100.0)
    time = 2 * math.pi * math.sqrt((transverse + arms) / (gravity * math.sqrt(mass * arms)))
    law = _law(rng, body, gravity)
    pulse, record = _table(rng, gravity, gravity * radius / max(height, 0.2 * radius), time)
    landings = ("stop", "smooth_left", "smooth_right", "housner", float(rng.random()))
    flat, rtol = landings[int(rng.integers(5))], float(rng.choice([1e-8, 1e-9, 1e-10]))
    start = _start(rng, body, time, law)
    # From the roughness of stone to the flatness of a coarse base; half of the motions have none.
    largest = min(0.1, 0.5 * radius / math.hypot(radius, body.height))
    gap = radius * decades(rng, 1e-6, largest) * float(rng.random() < 0.5)
    shaken = Shaken(body, start, law, pulse, record, flat, gap, 1.0, gravity, rtol)
    duration = 1.2 * shaken.ground().duration + time * decades(rng, 0.3, 3.0)
    return replace(shaken, duration=duration)


def _law(rng: np.random.Generator, body: rr.Body, gravity: float) -> rr.Law:
    friction, bounce = decades(rng, 0.05, 2.0), float(rng.random() * rng.integers(2))
    speed, static = math.sqrt(gravity * body.radius), friction * (1.0 + decades(rng, 1e-6, 1.0))
    viscous = body.mass * gravity / speed * decades(rng, 0.01, 100.0)
    speeds = speed * np.cumsum([0.0, *rng.exponential(0.1, 3)])
    laws = (
        rr.NoSlip(),
        rr.Frictionless(),
        rr.InPlace(),
        rr.Coulomb(friction, None, bounce),
        rr.Coulomb(friction, static, bounce),
        rr.Viscous(viscous, bounce),
        rr.Stribeck(friction, static, speed * decades(rng, 0.01, 1.0), 0.01 * speed, bounce),
        rr.Tabulated(speeds, friction * rng.uniform(0.3, 1.5, 4), None, bounce),
    )
    law = laws[int(rng.choice(len(laws), p=[0.2, 0.1, 0.1, 0.2, 0.1, 0.1, 0.1, 0.1]))]
    if law.name == "in_place" or rng.random() < 0.7:
        return law
    return law + resistance(str(rng.choice(RESISTANCES)), decades(rng, 1e-5, 1e-2), body, gravity)


def _table(
    rng: np.random.Generator, gravity: float, tipping: float, time: float
) -> tuple[tuple[str, Array, float], tuple[float, Array]]:
    size = tipping * decades(rng, 0.3, 5.0)
    directions = ([1, 0, 0], [1, 1, 0], [1, 1, 1], [1, 0, 1], [0, 0, 1])
    along = rng.choice(directions, p=[0.3, 0.2, 0.35, 0.1, 0.05]) * [size, size, 0.3 * gravity]
    kinds = ("sine", "cosine", "half_sine", "rectangular", "ricker")
    pulse = (str(rng.choice(kinds)), along * rng.normal(size=3), time * decades(rng, 0.1, 3.0))
    choice, count, step = rng.random(), int(rng.integers(20, 300)), time * decades(rng, 0.005, 0.2)
    if choice < 0.45:
        return pulse, (0.0, np.zeros((0, 3)))
    noise = rng.normal(size=(count, 3)) * along
    if choice < 0.6:  # slow
        noise = np.cumsum(noise, axis=0) / math.sqrt(count)
    elif choice < 0.7:  # mostly at rest
        noise *= rng.random((count, 1)) < 0.1
    elif choice < 0.8:  # in steps
        noise = np.repeat(noise[: (count + 9) // 10], 10, axis=0)[:count]
    if choice < 0.85:  # a table that falls away
        down = np.array([0.0, 0.0, -gravity * decades(rng, 0.999, 2.0)])
        pulse = ("rectangular", down * float(choice > 0.8), 0.1 * time)
    return pulse, (step, noise)


def _start(rng: np.random.Generator, body: rr.Body, time: float, law: rr.Law) -> rr.State:
    yaw, spin = (float(angle) for angle in rng.uniform(-3.0, 3.0, 2))
    if body.height > 0.0 and rng.random() < 0.5:
        return rr.State.standing(yaw=yaw * float(rng.integers(2)))
    rates = 2 * math.pi / time * rng.normal(size=3) * rng.choice([0.0, 0.01, 0.3, 1.0], size=3)
    if law.name == "in_place":
        spin, rates[2] = 0.0, -rates[1]
    tilt = float(rng.uniform(0.02, 0.95)) * min(rr.balance_tilt(body), 1.4)
    return rr.State(tilt=tilt, yaw=yaw, spin=spin, **dict(zip(RATES, rates.tolist(), strict=True)))
