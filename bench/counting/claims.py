"""What must hold of every motion on a moving table, of its copies and of its derivatives."""

from __future__ import annotations

import contextlib
import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace

import numpy as np

import rimroll as rr
from counting.engines import Array
from counting.shaken import MAX_STEPS, RESISTANCES, Shaken, resistance

PROBE = 1e-10
"""The relative change of the neighbours, whose distance tells how well a motion is determined."""
CLOSE = 1e-6
"""What copies may differ by if neighbours do not differ, rad."""
UNDETERMINED = 0.01
"""Motions are compared until they may differ by this, rad."""
SIZES = (1e-300, 1e-12, 1e-9, 1e-6, 1e-4)
"""Sizes of a resistance that vanishes."""
PARAMETERS = ("ground_scale", "gravity", "radius", "height", "tilt", "yaw_rate")


@dataclass(frozen=True)
class Finding:
    """A claim that was tried. ``what`` is empty if it holds; ``why`` explains why it need not."""

    claim: str
    what: str = ""
    why: str = ""


def findings(shaken: Shaken, rng: np.random.Generator) -> Iterator[Finding]:
    """Everything that is claimed about a motion."""
    motion = shaken.motion()
    errors = dict(misses(motion, shaken))
    for claim, miss in errors.items():
        what = f"{miss:.3g} times what is allowed ({motion.message})"
        stiff = motion.status == "failed" and motion.stats.steps >= MAX_STEPS
        yield Finding(claim, "" if miss <= 1.0 else what, f"{MAX_STEPS} steps" if stiff else "")
    if all(miss <= 1.0 for miss in errors.values()):
        known = Known.of(shaken, motion)
        yield many(shaken, motion)
        yield from copies(shaken, known, rng)
        yield from vanishing(shaken, known, rng)
        yield from derivatives(shaken, known, rng)


def misses(motion: rr.Motion, shaken: Shaken) -> Iterator[tuple[str, float]]:
    """Errors of what holds of one motion, in units of what is allowed; none may be above 1."""
    body, rtol, law = shaken.body, shaken.rtol, shaken.law
    columns = [name for name in rr.motion.UNITS if name != "friction_ratio"]
    finite = all(np.isfinite(motion[name]).all() for name in columns)
    yield "numbers are finite", 0.0 if finite else math.inf
    yield "does not fail", math.inf if motion.status == "failed" else 0.0
    if not finite:
        return
    t, budget = motion.t, motion.energy_budget
    yield "time grows", math.inf if np.diff(t).min(initial=0.0) < 0.0 else 0.0
    energies = (motion.kinetic_energy, motion.potential_energy, motion.ground_work)
    least = 1e-12 * body.mass * shaken.gravity * body.radius
    energy = max(least, *(float(np.abs(one).max()) for one in energies))
    # A body begins to rock at a tilt of 1e-15 rad. One that resistance has stopped falls from
    # 1e-7 rad in one step, whose error is a part of what friction takes in it.
    uplift = 2e-15 * body.mass * shaken.gravity * body.radius
    is_last_fall = (motion.tilt[:-1] < 1.001e-7) & (motion.tilt[:-1] > 100.0 * motion.tilt[1:])
    steps = np.where(is_last_fall, 0.0, np.diff(budget))
    missing = float(np.ptp(np.append(0.0, np.cumsum(steps))))
    yield "energy budget", missing / (max(1e-8, 300 * rtol) * energy + uplift)
    taken = sum(np.diff(loss) for loss in (motion.friction_loss, motion.resistance_loss))
    wrong = np.abs(np.diff(budget)) / (0.1 * taken + 1e-7 * energy)
    yield "energy budget of last falls", float(wrong[is_last_fall].max(initial=0.0))
    losses = (motion.friction_loss, motion.resistance_loss, motion.impact_loss)
    gain = max(float(-np.diff(loss).min(initial=0.0)) for loss in losses)
    yield "losses grow", gain / ((1e-9 + 30 * rtol) * energy)
    # Forces are compared with the weight and the inertial forces, within phases.
    turning = np.abs(motion.axial_spin * motion.yaw_rate * np.sin(motion.tilt))
    table = float(np.abs(motion.ground.peak[:3]).sum())
    moving = max(body.radius, body.height) * (motion.tilt_rate**2 + turning)
    force = body.mass * (shaken.gravity + table + moving)
    push, pull = motion.normal_force / force, np.hypot(*motion.friction_force.T) / force
    inside = np.append(np.diff(t) > 0.0, False) & np.append(False, np.diff(t) > 0.0)
    yield "table pushes", float(-push[inside].min(initial=0.0)) / (300 * rtol + 1e-9)
    if isinstance(law, rr.Coulomb):
        slides = np.hypot(*motion.slip.T) > 0.0
        most = np.where(slides, law.friction, law.static or law.friction)
        outside = (pull - most * push)[inside].max(initial=0.0)
        yield "friction in its cone", float(outside) / (300 * rtol + 1e-6)


@dataclass(frozen=True)
class Known:
    """A motion at times ``t``, and the largest distance of neighbours until each, ``spread``."""

    motion: rr.Motion
    t: Array
    spread: Array
    ends: bool
    """Whether all neighbours end in the same way at the same time."""

    @classmethod
    def of(cls, shaken: Shaken, motion: rr.Motion) -> Known:
        """Neighbours differ in body, ground, gravity and tolerance, and stay in a plane."""
        larger = rr.Body(
            *(value * (1 + PROBE * k) for k, value in enumerate(vars(shaken.body).values()))
        )
        fine = replace(shaken, rtol=max(1e-13, shaken.rtol / 30))
        changes = (
            {},
            {"body": larger},
            {"ground_scale": 1 + PROBE},
            {"gravity": shaken.gravity * (1 - PROBE)},
        )
        beside = [replace(fine, **change).motion() for change in changes]
        t = np.linspace(0.0, min(float(one.t[-1]) for one in (motion, *beside)), 60)[1:-1]
        apart = [distance(motion, one, t) for one in beside]
        spread = np.maximum.accumulate(np.max(apart, axis=0))
        same = [
            one.status == motion.status and abs(one.t[-1] - motion.t[-1]) < 1e-6 * motion.t[-1]
            for one in beside
        ]
        return cls(motion, t, spread, all(same) and float(spread[-1]) < CLOSE)

    def apart(self, other: rr.Motion, **copy: float) -> Array:
        """The distance of a motion that may be a copy, infinite after its end."""
        reached = copy.get("slower", 1.0) * self.t <= other.t[-1]
        apart = np.full(len(self.t), math.inf)
        apart[reached] = distance(self.motion, other, self.t[reached], **copy)
        return apart

    def finding(
        self,
        claim: str,
        other: rr.Motion,
        times: float = 1.0,
        close: float = CLOSE,
        **copy: float,
    ) -> Finding:
        """Whether another motion is a copy of this one, ``times`` as far away as neighbours."""
        allowed = close + 1e3 * times * self.spread
        apart = self.apart(other, **copy)
        wrong = (apart > allowed) & (allowed < UNDETERMINED)
        both = f"{self.motion.status} and {other.status}"
        if wrong.any():
            k = int(np.argmax(wrong))
            what = f"{apart[k]:.2g} rad apart at {self.t[k]:.6g} s, neighbours {self.spread[k]:.1g}"
            return Finding(claim, f"{what} ({both})")
        if self.motion.status != other.status and times == 1.0:
            return Finding(claim, both, "" if self.ends else "neighbours end otherwise, too")
        return Finding(claim, "apart" if (apart > CLOSE).any() else "", "so are neighbours")


def distance(
    one: rr.Motion,
    other: rr.Motion,
    t: Array,
    slower: float = 1.0,
    sign: float = 1.0,
    turned: float = 0.0,
) -> Array:
    """How far two motions are apart in tilt and heading at times of the first, (n,), rad."""
    a, b = one(t), other(np.minimum(slower * t, other.t[-1]))
    heading = (a.yaw + a.spin) - sign * (b.yaw + b.spin) + turned
    if one.max_tilt > 0.5 * math.pi:  # the other face of a disk counts whole turns differently
        heading = np.remainder(heading + math.pi, 2.0 * math.pi) - math.pi
    return np.maximum(np.abs(a.tilt - b.tilt), np.abs(heading))


def many(shaken: Shaken, motion: rr.Motion) -> Finding:
    """``rr.shake_many`` has the same end, and for a body that overturns the same outcome."""
    found = rr.shake_many(
        shaken.body, shaken.start, shaken.law, shaken.ground(), threads=1, **shaken.options()
    ).isel(trial=0)
    mine = {
        "overturned": float(motion.overturned is True),
        "undecided": float(motion.overturned is None),
        "stands": float(motion.stands),
    }
    if not motion.overturned:
        mine |= {"end_tilt": motion.tilt[-1], "end_time": motion.t[-1]}
        mine |= {"max_tilt": motion.max_tilt, "end_yaw": motion.body_yaw[-1] - motion.body_yaw[0]}
        mine |= {name: motion[name][-1] for name in ("ground_work", "friction_loss")}
    wrong = [
        name for name, one in mine.items() if not abs(float(found[name]) - one) <= 1e-12 * abs(one)
    ]
    names = [f"{name} {float(found[name])!r}, not {float(mine[name])!r}" for name in wrong]
    return Finding("shake_many", "; ".join(names))


def copies(shaken: Shaken, known: Known, rng: np.random.Generator) -> Iterator[Finding]:
    """Mirror image, other headings, other sizes, and gravity as an acceleration upward."""
    angle, size = float(rng.uniform(-3.0, 3.0)), float(np.exp(rng.uniform(-4.0, 4.0)))
    yield known.finding("mirror", shaken.mirror_image().motion(), sign=-1.0)
    yield known.finding("heading", shaken.turned_by(angle).motion(), turned=angle)
    if shaken.law.resistances:
        return  # they are smoothed at rates that depend on size and gravity
    if isinstance(shaken.law, (rr.NoSlip, rr.Frictionless, rr.InPlace, rr.Coulomb)):
        large = shaken.enlarged(size)
        yield known.finding("size", large.motion(), slower=large.slower)
    part = float(rng.uniform(0.2, 0.8)) * shaken.gravity
    lifted = replace(shaken, gravity=shaken.gravity - part, upward=part)
    # Gravity also decides when a wobble is so small that the body stands.
    yield known.finding("gravity", lifted.motion(), close=1e-4)


def vanishing(shaken: Shaken, known: Known, rng: np.random.Generator) -> Iterator[Finding]:
    """As a resistance vanishes, the motion becomes that without it.

    Its effect is about as large as that of another change of the same size. Where it is larger, as
    for a body that begins to rock or nearly falls flat, the motion must change continuously with
    the resistance, except where another small change makes it jump, too.
    """
    if shaken.law.resistances or shaken.law.name == "in_place":
        return
    kind = str(rng.choice(RESISTANCES))
    energy = shaken.body.mass * shaken.gravity * shaken.body.radius

    def resisted(size: float) -> Shaken:
        law = shaken.law + resistance(kind, size, shaken.body, shaken.gravity)
        return replace(shaken, law=law)

    for size in SIZES:
        other = resisted(size).motion()
        times = max(1.0, (size + float(other.resistance_loss[-1]) / energy) / PROBE)
        found = known.finding(f"{kind} resistance vanishes", other, times)
        if found.what and not found.why:
            found = replace(found, why=continuity(known, resisted, size))
        yield replace(found, what=found.what and f"at {size:g} {found.what}")


def continuity(known: Known, resisted: Callable[[float], Shaken], largest: float) -> str:
    """Why a motion may differ from that without resistance; empty if it jumps without reason.

    The place of the largest change is sought between no resistance and the largest one. One moment
    may be between the impacts of two motions, so the second largest distance counts.
    """
    allowed = CLOSE + 1e3 * (resisted(largest).rtol + known.spread)

    def jumps(one: rr.Motion, other: rr.Motion) -> float:
        ends = float(one.t[-1]), float(other.t[-1])
        if one.status != other.status or not math.isclose(*ends, rel_tol=1e-3):
            return math.inf
        common = (known.t <= min(ends)) & (allowed < UNDETERMINED)
        apart = np.sort(distance(one, other, known.t[common]) / allowed[common])
        return float(apart[-2]) if len(apart) > 1 else 0.0

    (low, below), (high, above) = ((size, resisted(size).motion()) for size in (1e-300, largest))
    if jumps(known.motion, below) > 1.0:
        return ""
    while jumps(below, above) > 1.0:
        if high < low * (1 + PROBE):
            sides = ((low, below), (high, above))
            unsure = any(not Known.of(resisted(size), one).ends for size, one in sides)
            return f"neighbours jump at {high:g}, too" if unsure else ""
        middle = math.sqrt(low) * math.sqrt(high)
        between = resisted(middle).motion()
        if jumps(below, between) > jumps(between, above):
            high, above = middle, between
        else:
            low, below = middle, between
    return "it changes continuously"


def derivatives(shaken: Shaken, known: Known, rng: np.random.Generator) -> Iterator[Finding]:
    """Derivatives of tilt and heading by a parameter are central differences."""

    def exact(rtol: float) -> Array:
        found = replace(shaken, rtol=rtol).motion(jacobian=True).jacobian(t)
        return np.stack([found["tilt", name], found["yaw", name] + found["spin", name]])

    name, t = str(rng.choice(PARAMETERS)), known.t[known.spread < 1e-7][5::12]
    value = {**vars(shaken.start), **vars(shaken.body), "ground_scale": 1.0}.get(
        name, shaken.gravity
    )
    if not len(t) or not value or (shaken.law.name == "in_place" and name == "yaw_rate"):
        return
    try:
        found = exact(shaken.rtol)
    except rr.RimrollError:
        return  # refused in words
    rough, fine = (_difference(shaken, name, value, step, t) for step in (1e-5, 1e-6))
    if np.isnan(fine).all():
        return
    scale = np.nanmax(np.abs(fine)) + 1e-3 / abs(value)

    def miss(found: Array) -> float:
        return float(np.nanmax(np.abs(found - fine), initial=0.0) / scale)

    what = "" if miss(found) < 3e-3 else f"by {name} wrong by {miss(found):.2g} of the largest"
    why = ""
    if not np.nanmax(np.abs(rough - fine)) < 3e-4 * scale:
        why = "central differences differ, too"
    elif what and miss(found) < 1e6 * shaken.rtol:
        with contextlib.suppress(rr.RimrollError):
            if miss(exact(1e-2 * shaken.rtol)) < 3e-3:
                why = "the tolerance, which near-collisions amplify"
    yield Finding("derivative", what, why)


def _difference(shaken: Shaken, name: str, value: float, step: float, t: Array) -> Array:
    """Central differences of tilt and heading, (2, n), NaN where a motion has ended."""
    fine, ends = replace(shaken, rtol=1e-13), []
    for changed in (value * (1 + step), value * (1 - step)):
        if name in vars(shaken.start):
            motion = fine.started(**{name: changed}).motion()
        elif name in vars(shaken.body):
            motion = replace(fine, body=replace(shaken.body, **{name: changed})).motion()
        else:
            motion = replace(fine, **{name: changed}).motion()
        if motion.status == "failed":  # a resistance is too stiff for the tightest tolerance
            return np.full((2, len(t)), np.nan)
        state = motion(np.minimum(t, motion.t[-1]))
        numbers = np.stack([state.tilt, state.yaw + state.spin])
        ends.append(np.where(t <= motion.t[-1] * (1 + CLOSE), numbers, np.nan))
    return np.asarray((ends[0] - ends[1]) / (2 * step * value))
