"""How often do the intervals of rr.filmed.fit_track contain the true value?

Falls of the paper's can under dry friction are simulated, with the can's radius, height and moments
of inertia wrong by 1 % at random, and filmed from above. The camera is turned at random, and its
scale is wrong by 1 % at random. The script prints, for films of several kinds, how many tracks were
fitted, the median error of the friction, the median width of its 95 % interval, how many of these
intervals contain the true value, and for how many tracks those of the yaw rate and the spin rate at
the release do. Run:

    .venv/bin/python bench/filmed_fit.py [--tracks 40] [--processes 2]
"""

from __future__ import annotations

import argparse
import math
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, replace
from functools import partial

import numpy as np
from scipy.spatial.transform import Rotation

import rimroll as rr

CAN = rr.bodies.can_2007()
LID = 0.12
"""Height of the dot above the base, m."""
HELD = 0.25
"""How long the film shows the can at rest in the hand, s."""
DURATION = 0.9
BODY_ERROR = 0.01
SCALE_ERROR = 0.01


@dataclass(frozen=True)
class Film:
    """What is filmed, and how."""

    kind: str = "path"
    rate: float = 120.0
    """Hz"""
    noise: float = 5e-4
    """Standard deviation of a coordinate, m, or of the direction of the axis, rad."""
    beside: float = 0.0
    """Distance of the dot from the can's axis, m."""
    distance: float = math.inf
    """Height of the camera above the lid, m."""

    def track(self, motion: rr.Motion, draw: np.random.Generator) -> rr.filmed.Track:
        """The track of a motion that begins after the hand has held the can."""
        t = np.arange(0.0, HELD + float(motion.t[-1]), 1.0 / self.rate)
        seen = motion.evaluate(np.maximum(t - HELD, 0.0))
        turned = Rotation.from_euler("ZYZ", np.stack([seen.yaw, -seen.tilt, seen.spin], axis=-1))
        if self.kind == "path":
            azimuth = draw.uniform(0.0, 2.0 * math.pi)
            dot = [self.beside * math.cos(azimuth), self.beside * math.sin(azimuth), LID]
            place = seen.center + turned.apply(np.array(dot) - [0.0, 0.0, motion.body.height])
            # A dot below the height of calibration, that of the lid, looks smaller.
            shrunk = 1.0 / (1.0 + (LID - place[:, 2]) / self.distance)
            scale = 1.0 + SCALE_ERROR * draw.normal()
            camera = scale * np.exp(1j * draw.uniform(0.0, 2.0 * math.pi))
            plane = camera * shrunk * (place[:, 0] + 1j * place[:, 1]) + 0.3 - 0.2j
            values = np.stack([plane.real, plane.imag], axis=-1)
            return rr.filmed.Track(t, values + self.noise * draw.normal(size=values.shape))
        axis = turned.apply([0.0, 0.0, 1.0])
        tilt = np.arccos(np.clip(axis[:, 2], -1.0, 1.0))
        direction = np.unwrap(np.arctan2(axis[:, 1], axis[:, 0]))
        across = self.noise / np.maximum(np.sin(tilt), self.noise)
        noisy = [
            tilt + self.noise * draw.normal(size=len(t)),
            direction + across * draw.normal(size=len(t)),
        ]
        width = 2 if self.kind == "lean" else 1
        return rr.filmed.Track(t, np.stack(noisy, axis=-1)[:, :width], self.kind)


FILMS = {
    "path, 120 Hz, 0.5 mm": Film(),
    "60 Hz": Film(rate=60.0),
    "240 Hz": Film(rate=240.0),
    "2 mm": Film(noise=2e-3),
    "dot 20 mm beside the axis": Film(beside=0.02),
    "camera 1 m above the lid": Film(distance=1.0),
    "lean, 120 Hz, 0.5°": Film("lean", noise=math.radians(0.5)),
    "tilt alone, 120 Hz, 0.5°": Film("tilt", noise=math.radians(0.5)),
}


@dataclass(frozen=True)
class Fitted:
    """One track: the friction and its interval; None where it was refused."""

    truth: float
    friction: float | None = None
    interval: tuple[float, float | None] | None = None
    start_holds: bool = False
    why: str = ""

    @property
    def holds(self) -> bool:
        """Whether the interval contains the true value."""
        assert self.interval is not None
        low, high = self.interval
        return low <= self.truth and (high is None or self.truth <= high)


def fitted(film: Film, seed: int) -> Fitted:
    """One track, fitted; one in six rolls, one in six slides without friction."""
    draw = np.random.default_rng(seed)
    true = replace(
        CAN,
        **{
            name: getattr(CAN, name) * (1.0 + BODY_ERROR * draw.normal())
            for name in ("radius", "height", "transverse_inertia", "axial_inertia")
        },
    )
    needed = rr.needed_friction(true)
    kind = draw.integers(6)
    friction = {0: 2.0 * needed, 1: 0.0}.get(int(kind), draw.uniform(0.05, 0.95) * needed)
    start = rr.State(
        tilt=rr.balance_tilt(CAN) * draw.uniform(0.6, 0.85),
        yaw_rate=draw.normal(0.0, 0.1),
        spin_rate=draw.normal(0.0, 0.1),
    )
    track = film.track(rr.simulate(true, start, rr.Coulomb(friction), DURATION), draw)
    marker = (film.beside, LID) if film.kind == "path" else None
    try:
        fit = rr.filmed.fit_track(
            track, CAN, marker=marker, error=film.noise, body_error=BODY_ERROR
        )
    except rr.RimrollError as error:
        return Fitted(friction, why=str(error))
    found = fit.friction
    start_holds = True
    for name in ("yaw_rate", "spin_rate"):
        low, high = fit.numbers[name].interval
        start_holds &= low <= getattr(start, name) <= high
    return Fitted(friction, found.value, found.interval, start_holds, "; ".join(fit.notes))


def row(name: str, film: Film, all_of_them: list[Fitted]) -> str:
    """A line of the table."""
    some = [one for one in all_of_them if one.friction is not None]
    counted = f"| {name} | {len(some)} of {len(all_of_them)} |"
    if not some:
        return counted + " | | | |"
    needed = rr.needed_friction(CAN)
    slips = [one for one in some if 0.0 < one.truth < needed]
    error = np.median([abs(one.friction - one.truth) for one in slips])
    widths = [
        math.inf if one.interval[1] is None else one.interval[1] - one.interval[0] for one in slips
    ]
    starts = sum(one.start_holds for one in some) if film.kind != "tilt" else ""
    return (
        f"{counted} {error:.3f} | {np.median(widths):.3f}"
        f" | {sum(one.holds for one in some)} of {len(some)} | {starts} |"
    )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--tracks", type=int, default=40, help="for each film")
    parser.add_argument("--films", type=int, default=len(FILMS), help="how many films")
    parser.add_argument("--processes", type=int, default=2)
    parser.add_argument("--each", action="store_true", help="print every track, too")
    given = parser.parse_args()
    print("| film | fitted | median error | median width | holds | start holds |")
    print("|---|--:|--:|--:|--:|--:|")
    with ProcessPoolExecutor(given.processes) as pool:
        for name, film in list(FILMS.items())[: given.films]:
            found = list(pool.map(partial(fitted, film), range(given.tracks)))
            print(row(name, film, found), flush=True)
            if given.each:
                for seed, one in enumerate(found):
                    print(seed, one)


if __name__ == "__main__":
    main()
