"""Turns of all kinds of bodies to 25 digits: the table given/exact_turns.csv, and who wrote it.

    cd tests; python -m oracles.tabulated_turns > given/exact_turns.csv

draws bodies and starts of each kind below until as many as wanted keep to the table, both rolling
and sliding without friction, and rock or may also topple; and follows them by taylor_turns. The
numbers drawn are short and stand in the table as they are, each the double that it reads as; so the
turns are those of just these doubles.
"""

import csv
import sys
from dataclasses import dataclass, fields
from pathlib import Path
from types import SimpleNamespace

import numpy as np
from mpmath import mp

from oracles.taylor_turns import LAWS, ExactTurn, LeftTheTable, first_turn

TABLE = Path(__file__).parents[1] / "given" / "exact_turns.csv"

BODY = ("mass", "radius", "height", "transverse_inertia", "axial_inertia")
START = ("tilt", "tilt_rate", "yaw_rate", "spin_rate")
RESULTS = tuple(field.name for field in fields(ExactTurn))
NUMBERS = tuple(name for name in RESULTS if name != "outcome")

HEAD = """\
# First turns of bodies of all kinds, without slip and without friction, by Taylor series in 65
# digits (tests/oracles/tabulated_turns.py). From the release or, where the tilt then rises, from
# the tilt maximum after it, to the first tilt maximum after the near-collision or, where it
# topples, to the topple tilt: the vertical if none is given. SI units and rad; times from the
# release."""


@dataclass(frozen=True)
class Row:
    """A line of the table: what was given, as doubles, and what became of it under each law."""

    kind: str
    body: SimpleNamespace
    start: SimpleNamespace
    gravity: float
    topple_tilt: float | None
    turns: dict[str, ExactTurn]


def rows():
    """The table, results in multiprecision."""
    with TABLE.open(encoding="utf-8") as file, mp.workdps(30):
        lines = [line for line in file if not line.startswith("#")]
        return [_row(line) for line in csv.DictReader(lines)]


def _row(line):
    return Row(
        line["kind"],
        SimpleNamespace(**{name: float(line[name]) for name in BODY}),
        SimpleNamespace(**{name: float(line[name]) for name in START}),
        float(line["gravity"]),
        float(line["topple_tilt"]) if line["topple_tilt"] else None,
        {law: _turn(line, law) for law in LAWS},
    )


def _turn(line, law):
    numbers = {name: mp.mpf(line[f"{name}_{law}"]) for name in NUMBERS}
    return ExactTurn(line[f"outcome_{law}"], **numbers)


# Random draws


def short(number):
    """The number to six digits."""
    return float(f"{number:.5e}")


def decades(random, low, high):
    """A number whose logarithm is uniform."""
    return 10.0 ** random.uniform(np.log10(low), np.log10(high))


def signed(random, number):
    return number * random.choice([-1.0, 1.0])


def some_body(random):
    """Tall or flat, hollow or not, of any size."""
    m, R = decades(random, 1e-3, 1e3), decades(random, 1e-3, 10.0)
    shape = random.choice(["tall", "can", "flat", "disk", "ring", "lamina", "wide"])
    k2 = random.uniform(0.2, 1.0)
    height, transverse = 0.0, 0.5 * k2
    if shape == "tall":
        height = decades(random, 3.0, 30.0)
        transverse = 0.5 * k2 + height**2 * random.uniform(0.1, 0.4)
    elif shape == "can":
        height = random.uniform(0.3, 3.0)
        transverse = 0.5 * k2 + height**2 * random.uniform(0.2, 1.0)
    elif shape == "flat":
        height = decades(random, 1e-4, 0.3)
        transverse = 0.5 * k2 + height**2 * random.uniform(0.1, 0.5)
    elif shape == "ring":
        k2, transverse = 1.0, 0.5
    elif shape == "lamina":  # without thickness, held up by massless legs: C = 2A
        height = random.uniform(0.0, 1.0)
    elif shape == "wide":  # wider than its rim
        k2 = random.uniform(1.0, 4.0)
        height, transverse = random.uniform(0.0, 1.0), 0.5 * k2 * random.uniform(1.0, 2.0)
    axial = short(k2 * m * R**2)
    return SimpleNamespace(
        mass=short(m),
        radius=short(R),
        height=short(height * R),
        transverse_inertia=max(short(transverse * m * R**2), 0.5 * axial),
        axial_inertia=axial,
    )


def about_the_rim(body):
    """J = A + mH2 + mR2."""
    return body.transverse_inertia + body.mass * (body.radius**2 + body.height**2)


def up_to_the_balance(body, gravity, tilt):
    """The rate that takes a body without yaw and spin from a tilt to its balance point, rad/s."""
    balance = np.arctan2(body.radius, body.height)
    lift = np.hypot(body.radius, body.height) * (1.0 - np.cos(balance - tilt))
    return np.sqrt(2.0 * body.mass * gravity * lift / about_the_rim(body))


def let_go(random, body, gravity, least, most, share=(-0.8, 0.0)):
    """From some tilt, with yaw and spin rates between `least` and `most` of sqrt(g/R).

    The tilt rate is a share of what would take the body to its balance point.
    """
    natural = np.sqrt(gravity / body.radius)
    tilt = short(random.uniform(0.1, 0.8) * np.arctan2(body.radius, body.height))
    return SimpleNamespace(
        tilt=tilt,
        tilt_rate=short(random.uniform(*share) * up_to_the_balance(body, gravity, tilt)),
        yaw_rate=short(signed(random, natural * decades(random, least, most))),
        spin_rate=short(signed(random, natural * decades(random, least, most))),
    )


def gently(random, body, gravity):
    return let_go(random, body, gravity, 1e-3, 0.3)


def at_rest_but_for_yaw(random, body, gravity):
    start = let_go(random, body, gravity, 1e-3, 0.3, (0.0, 0.0))
    start.spin_rate = 0.0
    return start


def nearly_straight(random, body, gravity):
    return let_go(random, body, gravity, 3e-14, 1e-4)


def rising(random, body, gravity):
    return let_go(random, body, gravity, 1e-6, 0.3, (0.1, 0.8))


def spinning(random, body, gravity):
    """A spin like the rate at which the body tips, as the base comes down nearly flat."""
    start = let_go(random, body, gravity, 1e-8, 1e-1)
    start.spin_rate = short(signed(random, up_to_the_balance(body, gravity, 0.0)) * random.random())
    return start


def nearly_toppling(random, body, gravity):
    """Up to near the balance point, where all takes long."""
    rate = np.sqrt(1.0 - decades(random, 3e-4, 0.1))
    return let_go(random, body, gravity, 1e-5, 1e-2, (-rate, -rate))


def inside(random, body, gravity):
    """Let go in the near-collision, while the contact point runs."""
    rate = up_to_the_balance(body, gravity, 0.0)
    tilt = short(decades(random, 1e-10, 1e-2))
    angle, size = random.uniform(-3.1, 3.1), rate * random.uniform(0.2, 0.9)
    yaw_rate = short(signed(random, size * abs(np.cos(angle)) / tilt))
    # Not shortened: of the yaw and spin rates together it leaves no more than a small spin.
    spin_rate = signed(random, rate * decades(random, 1e-4, 0.1)) - yaw_rate * np.cos(tilt)
    return SimpleNamespace(
        tilt=tilt,
        tilt_rate=short(size * np.sin(angle)),
        yaw_rate=yaw_rate,
        spin_rate=float(spin_rate),
    )


def over_the_top(random, body, gravity):
    """Up to the balance point and easily over it."""
    return let_go(random, body, gravity, 3e-14, 0.3, (-1.6, -1.05))


def hardly_over_the_top(random, body, gravity):
    """Next to where one of the laws lets it rest at the balance point, where all takes long."""
    start = let_go(random, body, gravity, 1e-7, 1e-2)
    if random.random() < 0.5:
        rate = up_to_the_balance(body, gravity, start.tilt)
    else:
        rho = body.radius * np.cos(start.tilt) - body.height * np.sin(start.tilt)
        sliding = body.transverse_inertia + body.mass * rho**2
        rate = up_to_the_balance(body, gravity, start.tilt) * np.sqrt(about_the_rim(body) / sliding)
    start.tilt_rate = short(-rate * np.sqrt(1.0 + signed(random, decades(random, 1e-5, 0.1))))
    return start


def from_the_top(random, body, gravity):
    """Let go next to the balance point, to either side of it, in whichever direction."""
    start = let_go(random, body, gravity, 1e-8, 1e-1)
    balance = np.arctan2(body.radius, body.height)
    away = signed(random, decades(random, 1e-5, 0.1)) * balance
    start.tilt = short(balance + (-abs(away) if body.height == 0.0 else away))
    rate = up_to_the_balance(body, gravity, start.tilt) * decades(random, 0.1, 100.0)
    start.tilt_rate = signed(random, short(rate))
    return start


def held(random, body, gravity):
    """With so much yaw or spin that it may turn back past the balance point."""
    return let_go(random, body, gravity, 0.01, 2.0, (-1.2, 1.2))


def wobbling(random, body, gravity):
    """Nearly as steadily as a wobble in which the centre of mass rests."""
    m, R, H = body.mass, body.radius, body.height
    tilt = short(decades(random, 1e-2, 0.6 * np.arctan2(R, H)))
    sin, cos = np.sin(tilt), np.cos(tilt)
    falling = m * gravity * R * (R * cos - H * sin)
    turning = sin * (body.transverse_inertia * R * cos - body.axial_inertia * H * sin)
    if turning <= 0.0:
        return None
    yaw_rate = signed(random, np.sqrt(falling / turning))
    off = decades(random, 3e-3, 0.3)
    return SimpleNamespace(
        tilt=tilt,
        tilt_rate=short(random.choice([-off, off]) * abs(yaw_rate) * sin),
        yaw_rate=short(yaw_rate),
        spin_rate=short(yaw_rate * (H / R * sin - cos)),
    )


KINDS = {
    gently: 16,
    at_rest_but_for_yaw: 6,
    nearly_straight: 20,
    rising: 14,
    spinning: 12,
    nearly_toppling: 10,
    inside: 14,
    wobbling: 14,
}
"""The number of each kind."""


TOPPLING = {
    over_the_top: 10,
    hardly_over_the_top: 12,
    from_the_top: 20,
    held: 10,
}
"""The numbers of starts that may topple, half of them at a given tilt."""


def some_topple_tilt(random, body, start):
    """Above the start, and the balance point or nearly so; or none, for the vertical."""
    least = max(1.02 * start.tilt, 0.9 * np.arctan2(body.radius, body.height))
    if random.random() < 0.5 or least > 1.5:
        return None
    return short(random.uniform(least, 0.5 * np.pi))


def turned(body, start, gravity, topple_tilt):
    """The first turn under each law; None where one leaves the table or falls to its other face."""
    try:
        turns = {law: first_turn(body, law, start, gravity, topple_tilt) for law in LAWS}
    except LeftTheTable:
        return None
    fell = any(turn.outcome == "fell_back" for turn in turns.values())
    return None if fell and body.height == 0.0 and topple_tilt is None else turns


def rocked(turns):
    return turns and all(t.outcome == "rocked" and t.end_tilt <= 1.5 for t in turns.values())


def drawn(seed=2007):
    """The wanted rows."""
    random = np.random.default_rng(seed)
    for kind, wanted in KINDS.items():
        found = 0
        while found < wanted:
            body, gravity, start = release(random, kind)
            turns = start and turned(body, start, gravity, None)
            if rocked(turns):
                found += 1
                yield Row(kind.__name__, body, start, gravity, None, turns)
    for kind in TOPPLING:
        yield from drawn_toppling(kind, seed)


def drawn_toppling(kind, seed=2007):
    """The rows of one kind of those that may topple."""
    random = np.random.default_rng([seed, list(TOPPLING).index(kind)])
    found = 0
    while found < TOPPLING[kind]:
        body, gravity, start = release(random, kind)
        topple_tilt = some_topple_tilt(random, body, start)
        if turns := turned(body, start, gravity, topple_tilt):
            found += 1
            yield Row(kind.__name__, body, start, gravity, topple_tilt, turns)


def release(random, kind):
    """Some body, gravity and start; None for the start if such a body has none of the kind."""
    body, gravity = some_body(random), float(random.choice([1.62, 9.8, 24.8]))
    return body, gravity, kind(random, body, gravity)


def write(file):
    """The table."""
    file.write(HEAD + "\n")
    columns = [f"{name}_{law}" for law in LAWS for name in RESULTS]
    file.write(",".join(["kind", *BODY, "gravity", "topple_tilt", *START, *columns]) + "\n")
    for row in drawn():
        file.write(line_of(row) + "\n")
        file.flush()


def line_of(row):
    given = [getattr(row.body, name) for name in BODY] + [row.gravity]
    start = [getattr(row.start, name) for name in START]
    numbers = [*map(repr, map(float, given)), repr(row.topple_tilt) if row.topple_tilt else ""]
    results = [getattr(row.turns[law], name) for law in LAWS for name in RESULTS]
    digits = [
        x if isinstance(x, str) else mp.nstr(x, 25, min_fixed=0, max_fixed=0) for x in results
    ]
    return ",".join([row.kind, *numbers, *map(repr, map(float, start)), *digits])


if __name__ == "__main__":
    write(sys.stdout)
