"""The paper's experiment: one flick after another by hand, and where the body falls."""

from __future__ import annotations

import secrets
from collections.abc import Callable
from contextlib import suppress
from dataclasses import fields, replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from rimroll.bodies.body import Body, body_of, one_body
from rimroll.errors import RimrollError
from rimroll.experiment.release import Release
from rimroll.laws import IDEAL, Law, law_of, one_law
from rimroll.many.ensemble import OPTIONS, follow
from rimroll.many.falls import Falls, Interrupted
from rimroll.options import Keywords, Options, takes_options
from rimroll.state import State
from rimroll.theory.closed_forms import arrival, turn_limit
from rimroll.units import Number

if TYPE_CHECKING:
    from typing import Unpack

    import xarray as xr


FALLING = replace(OPTIONS, rtol=1e-6)
"""The defaults of :func:`topple`."""


@takes_options(FALLING, "flat", "flat_gap")
def topple(
    body: Body,
    law: Law,
    n: int = 42,
    release: Release | str = "flick",
    seed: int | None = None,
    *,
    duration: Number | None = None,
    threads: int | None = None,
    progress: Callable[[int, int], object] | None = None,
    options: Options | None = None,
    **keywords: Unpack[Keywords],
) -> xr.Dataset:
    """Release a body ``n`` times by hand, and compute each fall.

    Parameters
    ----------
    body, law
        What is flicked, and how its rim meets the table.
    n
        Number of releases. The paper: 42.
    release
        How the hand releases the body: a :class:`rimroll.Release`, or the name of a preset,
        ``let_go``, ``flick`` or ``paper`` (see :data:`rimroll.experiment.release.PRESETS`).
    seed
        Seed of the scatter, a whole number >= 0. By default it is random, and stored in the
        attributes. Trial k is the same whatever ``n`` and ``threads``.
    duration, gravity, rtol, topple_tilt, max_steps, options, threads, progress
        As for :func:`rimroll.ensemble`. At the default ``rtol`` a turn is right to 1e-4 degrees.

    Returns
    -------
    xarray.Dataset
        The columns of :func:`rimroll.ensemble`, one row for each trial; the attributes include the
        release and the seed. Angles are in rad. ``direction`` is counted anticlockwise from the
        direction of the first lean, so falls to the left of a hand that flicks the body away from
        itself are above π.

    Raises
    ------
    RimrollError
        A number outside its bounds, an unknown preset.
    Interrupted
        On Ctrl-C; it carries the falls done so far.
    """
    chosen = FALLING.changed(options, duration, keywords)
    return let_go(body, law, n, release, seed, chosen, threads, progress).to_xarray()


def let_go(
    body: Body,
    law: Law,
    n: int,
    release: Release | str,
    seed: int | None,
    options: Options = FALLING,
    threads: int | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> Falls:
    """What :func:`topple` computes, in plain columns; arguments and errors are its own."""
    one_body(body)
    one_law(law)
    if isinstance(release, str):
        release = Release.named(release, body, options.gravity)
    if not isinstance(release, Release):
        raise RimrollError(
            field="release", value=release, bound="a rimroll.Release or the name of a preset"
        )
    seed = secrets.randbits(31) if seed is None else seed
    starts, friction_scale = release.draw(n, seed)
    hand = release.parameters() | {"seed": int(seed)}
    try:
        falls = follow(
            body,
            starts,
            law,
            options,
            friction_scale=friction_scale,
            threads=threads,
            progress=progress,
        )
    except Interrupted as interrupted:
        raise Interrupted(interrupted.falls.with_attrs(hand)) from None
    return falls.with_attrs(hand)


def counted(falls: Falls | xr.Dataset) -> tuple[NDArray[np.float64], str]:
    """The directions of the falls that count, rad, and their outcome.

    The outcome is ``toppled`` or, if that is more common, ``rocked``; the directions of the latter
    are those at the largest tilt, as for a coin that gets up again.
    """
    outcome = np.asarray(falls["outcome"])
    word = outcome_to_count(outcome)
    return np.asarray(falls["direction"])[outcome == word], word


def outcome_to_count(outcomes: NDArray[np.str_]) -> str:
    """``toppled`` or ``rocked``, whichever is more common among outcomes (n,)."""
    return "toppled" if np.sum(outcomes == "toppled") >= np.sum(outcomes == "rocked") else "rocked"


def limits(falls: Falls | xr.Dataset) -> dict[str, float]:
    """Limiting angles of turn, rad, by the name of the law: the ideal laws and that of the falls.

    Under friction the limit depends on the arrival. It is computed for the release's mean tilt,
    tilt rate and friction scale, without sideways rates. The law is left out where it has no limit,
    for example because the rim then lifts off.
    """
    body, law = one_body(body_of(falls)), one_law(law_of(falls))
    found = {ideal.name: turn_limit(body, ideal) for ideal in IDEAL}
    if law.name not in found:
        scaled = _scaled(law, _mean(falls, "friction_scale"))
        start = State(tilt=_mean(falls, "tilt"), tilt_rate=_mean(falls, "tilt_rate"))
        gravity = float(falls.attrs["gravity"])
        with suppress(RimrollError):
            found[law.name] = turn_limit(body, scaled, arrival(body, start, scaled, gravity))
    return found


def _mean(falls: Falls | xr.Dataset, name: str) -> float:
    """The release's mean, or that of the starts where there was no release."""
    if f"release_{name}" in falls.attrs:
        return float(falls.attrs[f"release_{name}"])
    return float(falls[name if name in falls else f"start_{name}"].mean())


def _scaled(law: Law, factor: float) -> Law:
    """The law with its friction changed by a factor."""
    if factor == 1.0:
        return law
    scaled = {
        field.name: factor * value
        for field in fields(law)
        if field.name in ("friction", "static", "coefficient")
        and (value := getattr(law, field.name)) is not None
    }
    return replace(law, **scaled)
