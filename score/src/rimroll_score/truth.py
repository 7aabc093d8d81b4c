"""Writes ``cases.toml`` from rimroll: ``python -m rimroll_score.truth > cases.toml``.

Numbers are computed at a relative tolerance of 1e-13 and written to twelve digits.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

import rimroll as rr
from rimroll_score.euler import Angles, state
from rimroll_score.protocol import Body

Array = NDArray[np.float64]

GRAVITY = 9.8
RTOL = 1e-13
TINY = 1e-11
"""Numbers below this are rounding errors of 0."""

BODIES = {
    # The can of Srinivasan & Ruina (2007), C/m = 2e-3 m² in place of a misprint.
    "can": Body(0.07, 0.051, 0.069, 0.07 * 5.13e-3, 0.07 * 2.0e-3),
    # A uniform disk of radius 5 cm and thickness 5 mm.
    "disk": Body(0.1, 0.05, 0.0025, 0.1 * (0.05**2 / 4 + 0.005**2 / 12), 0.1 * 0.05**2 / 2),
}


@dataclass(frozen=True)
class Plan:
    """A case before its truth is computed."""

    title: str
    body: str
    law: rr.Law
    angles: Angles
    duration: float
    measure: str

    @property
    def rolls(self) -> rr.Body:
        return rr.Body(**asdict(BODIES[self.body]))

    @property
    def friction(self) -> float:
        known = {"no_slip": math.inf, "frictionless": 0.0}
        return known.get(self.law.name, getattr(self.law, "friction", math.nan))


def rocking(push: float) -> Angles:
    """The paper's start, with sideways rates ``push`` (rad/s)."""
    return Angles(math.pi / 6, -0.5, 0.0, push, 0.0, push)


def steady(body: str, law: rr.Law, tilt: float, yaw_rate: float) -> Angles:
    """The start of the steady motion at a tilt (degrees) with a yaw rate."""
    rolls = rr.Body(**asdict(BODIES[body]))
    (motion,) = rr.steady_motions(
        rolls, law, math.radians(tilt), yaw_rate=yaw_rate, gravity=GRAVITY
    )
    return Angles(motion.tilt, 0.0, 0.0, yaw_rate, 0.0, motion.spin_rate)


def wobble(body: str, tilt: float) -> Angles:
    """The start of the steady wobble at a tilt (degrees) with the centre of mass at rest."""
    rolls, angle = rr.Body(**asdict(BODIES[body])), math.radians(tilt)
    rate = float(rr.steady_wobble_rate(rolls, angle, gravity=GRAVITY))
    ratio = rolls.height * math.sin(angle) / rolls.radius - math.cos(angle)
    return Angles(angle, 0.0, 0.0, rate, 0.0, rate * ratio)


def plans() -> Iterator[tuple[str, Plan]]:
    """The cases on the table, by name."""
    roll, slide = rr.NoSlip(), rr.Frictionless()
    for law, way, seconds in ((roll, "rolling", 0.8), (slide, "sliding", 0.6)):
        for push, near in ((0.5, "far"), (0.1, "near"), (0.02, "nearer")):
            title = f"near-collision, {way}, sideways rates of {push} rad/s"
            yield f"{way}_{near}", Plan(title, "can", law, rocking(push), seconds, "turn")
    title = "near-collision with friction 0.2, sideways rates of 0.1 rad/s"
    yield "friction", Plan(title, "can", rr.Coulomb(0.2), rocking(0.1), 0.7, "turn")
    title = "steady wobble of the can at 15°"
    yield "wobble", Plan(title, "can", roll, wobble("can", 15.0), 0.5, "axis")
    title = "Euler's disk at 5° without dissipation"
    yield "euler_disk", Plan(title, "disk", roll, wobble("disk", 5.0), 0.5, "axis")
    title = "disk that rolls in a circle at 70°, once round in a second"
    yield "circle", Plan(title, "disk", roll, steady("disk", roll, 70.0, math.tau), 1.0, "axis")
    thin = rr.Body(0.1, 0.05, 0.0, 0.1 * 0.05**2 / 4, 0.1 * 0.05**2 / 2)
    critical = float(rr.critical_spinning_rate(thin, gravity=GRAVITY))
    title = "coin that spins at 80° twice as fast as a thin one must to stand"
    fast = steady("disk", roll, 80.0, 2.0 * critical)
    yield "spin_fast", Plan(title, "disk", roll, fast, 0.5, "axis")
    title = "coin that spins at 84° half as fast as a thin one must to stand"
    slow = Angles(math.radians(84.0), 0.0, 0.0, 0.5 * critical)
    yield "spin_slow", Plan(title, "disk", roll, slow, 0.2, "axis")
    balance = float(rr.balance_tilt(rr.Body(**asdict(BODIES["can"]))))
    title = "fall to the side from 3° beyond balance"
    falling = Angles(balance + math.radians(3.0))
    yield "fall", Plan(title, "can", roll, falling, 0.42, "axis")


def followed(plan: Plan) -> dict[str, Any]:
    """The truth of a case on the table."""
    angles = rr.State(**asdict(plan.angles))
    motion = rr.simulate(
        plan.rolls, angles, plan.law, duration=plan.duration, gravity=GRAVITY, rtol=RTOL
    )
    truth: dict[str, Any] = {"largest_yaw_rate": float(np.abs(motion.samples().yaw_rate).max())}
    if plan.measure == "turn":
        turn = motion.turns[0]
        # rimroll counts the energy from the body at rest on its base.
        kept = motion.evaluate(np.array([turn.end])).energy[0] / motion.energy[0]
        conserved = plan.law.name != "coulomb"
        return truth | {
            "largest_yaw_rate": abs(turn.yaw_rate),
            "turn": math.degrees(turn.angle),
            "smallest_tilt": math.degrees(turn.min_tilt),
            "time_of_smallest_tilt": turn.t,
            "time_of_largest_tilt": turn.end,
            "energy_lost": 0.0 if conserved else float(1.0 - kept),
        }
    last = motion.evaluate(np.array([plan.duration]))
    tilt, yaw = float(last.tilt[0]), float(last.yaw[0])
    flat = -math.sin(tilt)
    axis = [flat * math.cos(yaw), flat * math.sin(yaw), math.cos(tilt)]
    begin = motion.center[0] * [1.0, 1.0, 0.0]  # the engine starts above the origin
    return truth | {
        "axis": axis,
        "position": [float(x) for x in last.center[0] - begin],
        "energy_lost": 0.0,
    }


def flight() -> dict[str, Any]:
    """The can in free flight: its axis turns about the angular momentum at the rate L/A."""
    body, duration = BODIES["can"], 1.0
    start = state(body, Angles(math.radians(40.0), -3.0, 0.0, 4.0, 0.0, 15.0))
    axis = start.rotation[:, 2]
    momentum = body.transverse_inertia * start.angular_velocity
    momentum = (
        momentum
        + (body.axial_inertia - body.transverse_inertia) * (axis @ start.angular_velocity) * axis
    )
    rate = float(np.linalg.norm(momentum)) / body.transverse_inertia
    about = momentum / np.linalg.norm(momentum)
    c, s = math.cos(rate * duration), math.sin(rate * duration)
    turned = c * axis + s * np.cross(about, axis) + (1.0 - c) * (about @ axis) * about
    place = start.position + start.velocity * duration
    return {
        "title": "free flight of the can, without gravity",
        "body": "can",
        "friction": 0.0,
        "gravity": 0.0,
        "table": False,
        "duration": duration,
        "measure": "axis",
        "start": {name: value.tolist() for name, value in vars(start).items()},
        "truth": {
            "axis": turned.tolist(),
            "position": place.tolist(),
            "energy_lost": 0.0,
            "largest_yaw_rate": rate,
        },
    }


def straight() -> dict[str, Any]:
    """The disk, upright, rolls straight at the speed R s."""
    body, duration, spin = BODIES["disk"], 0.5, 15.0
    start = state(Body(**{**asdict(body), "height": 0.0}), Angles(0.5 * math.pi, spin_rate=spin))
    place = start.position + start.velocity * duration
    return {
        "title": "disk that rolls straight on, upright",
        "body": "disk",
        "friction": math.inf,
        "gravity": GRAVITY,
        "table": True,
        "duration": duration,
        "measure": "place",
        "start": {name: value.tolist() for name, value in vars(start).items()},
        "truth": {
            "axis": start.rotation[:, 2].tolist(),
            "position": place.tolist(),
            "energy_lost": 0.0,
            "largest_yaw_rate": spin,
        },
    }


def table(plan: Plan) -> dict[str, Any]:
    """A case on the table, as it stands in the file."""
    start = state(BODIES[plan.body], plan.angles, slides=plan.law.name == "frictionless")
    return {
        "title": plan.title,
        "body": plan.body,
        "friction": plan.friction,
        "gravity": GRAVITY,
        "table": True,
        "duration": plan.duration,
        "measure": plan.measure,
        "start": {name: value.tolist() for name, value in vars(start).items()},
        "truth": followed(plan),
    }


def falls() -> dict[str, Any]:
    """Forty-two flicks of the can with friction 0.2, by an unsteady hand."""
    can, fallen = rr.Body(**asdict(BODIES["can"])), math.radians(60.0)
    found = rr.topple(
        can, rr.Coulomb(0.2), 42, "flick", seed=2007,
        gravity=GRAVITY, rtol=1e-12, topple_tilt=fallen,
    )  # fmt: skip
    columns = ("start_tilt", "start_tilt_rate", "start_yaw_rate", "start_spin_rate")
    return {
        "title": "42 flicks of the can with friction 0.2, by an unsteady hand",
        "body": "can",
        "friction": 0.2,
        "gravity": GRAVITY,
        "duration": 0.6,
        "fallen": fallen,
        "starts": np.column_stack([found[name].values for name in columns]).tolist(),
        "directions": found["direction"].values.tolist(),
    }


def written(value: Any) -> str:
    """A value in TOML; numbers have twelve digits."""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, str):
        return f'"{value}"'
    if isinstance(value, list):
        return "[" + ", ".join(map(written, value)) + "]"
    if math.isinf(value):
        return "inf"
    number = f"{value if abs(value) > TINY else 0.0:.12g}"
    return number if any(c in number for c in ".e") else number + ".0"


def lines() -> Iterator[str]:
    """The file, line by line."""
    yield "# Written by `python -m rimroll_score.truth > cases.toml`: do not edit."
    yield "# SI units and radians, but for turn and smallest_tilt, which are in degrees."
    for name, body in BODIES.items():
        yield from ("", f"[bodies.{name}]")
        yield from (f"{key} = {written(value)}" for key, value in asdict(body).items())
    tables = {name: table(plan) for name, plan in plans()}
    for name, whole in {**tables, "straight": straight(), "flight": flight()}.items():
        yield from ("", f"[case.{name}]")
        for key, value in whole.items():
            if isinstance(value, dict):
                yield f"[case.{name}.{key}]"
                yield from (f"{one} = {written(number)}" for one, number in value.items())
            else:
                yield f"{key} = {written(value)}"
    yield from ("", "[falls]")
    for key, value in falls().items():
        if key == "starts":
            yield from ("starts = [", *(f"  {written(row)}," for row in value), "]")
        else:
            yield f"{key} = {written(value)}"


if __name__ == "__main__":
    print("\n".join(lines()))
