"""The paper's experiment: one flick after another by hand, and where the body falls."""

from __future__ import annotations

import secrets
from collections.abc import Callable
from typing import TYPE_CHECKING

from rimroll import _core
from rimroll.body import Body
from rimroll.ensemble import Interrupted, ensemble
from rimroll.errors import RimrollError, expect
from rimroll.laws import Law
from rimroll.motion import whole_number
from rimroll.release import MOST_TRIALS, Release

if TYPE_CHECKING:
    import xarray as xr


def topple(
    body: Body,
    law: Law,
    n: int = 42,
    release: Release | str = "flick",
    seed: int | None = None,
    *,
    gravity: float = _core.STANDARD_GRAVITY,
    duration: float = 10.0,
    rtol: float = 1e-6,
    topple_tilt: float | None = None,
    max_steps: int = 100_000,
    threads: int | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> xr.Dataset:
    """Let a body go ``n`` times by hand and tell what became of it.

    Parameters
    ----------
    body, law
        What is flicked, and how its rim meets the table.
    n
        How many times. The paper: 42.
    release
        How the hand lets go: a :class:`rimroll.Release`, or the name of a preset, ``let go``,
        ``flick`` or ``paper`` (see :data:`rimroll.release.PRESETS`).
    seed
        Of the scatter, a whole number >= 0; drawn by chance and told in the attributes unless
        given. Trial k is the same whatever ``n`` and ``threads``.
    gravity, duration, rtol, topple_tilt, max_steps, threads, progress
        As for :func:`rimroll.ensemble`. At the default ``rtol`` a turn is right to 1e-4 degrees.

    Returns
    -------
    xarray.Dataset
        As of :func:`rimroll.ensemble`, one row a trial, with the release and the seed among the
        attributes. Angles in rad; ``direction`` is counted anticlockwise from the direction in
        which the body leaned at first, so falls to the left of a hand that flicks it away from
        itself are above π.

    Raises
    ------
    RimrollError
        A number outside its bounds, an unknown preset.
    Interrupted
        On Ctrl-C; it carries the falls done so far.
    """
    expect("body", body, Body)
    expect("law", law, Law)
    expect("release", release, Release | str)
    count = whole_number("n", n)
    if count > MOST_TRIALS:
        raise RimrollError(f"n must be at most {MOST_TRIALS}, got {count}")
    seed = secrets.randbits(32) if seed is None else _seed(seed)
    if isinstance(release, str):
        release = Release.named(release, body, gravity)
    starts, grip = release.draw(count, seed)
    try:
        falls = ensemble(
            body,
            starts,
            law,
            grip=grip,
            duration=duration,
            gravity=gravity,
            rtol=rtol,
            topple_tilt=topple_tilt,
            max_steps=max_steps,
            threads=threads,
            progress=progress,
        )
    except Interrupted as interrupted:
        interrupted.done.attrs |= release.parameters() | {"seed": seed}
        raise
    return falls.assign_attrs(release.parameters(), seed=seed)


def _seed(value: object) -> int:
    if isinstance(value, bool) or not isinstance(value, int) or not 0 <= value < 2**63:
        raise RimrollError(f"seed must be a whole number >= 0 and below 2^63, got {value!r}")
    return value
