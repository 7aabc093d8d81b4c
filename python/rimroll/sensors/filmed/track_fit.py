"""A motion fitted to a filmed track by least squares."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from itertools import product

import numpy as np
from numpy.typing import NDArray

from rimroll import _core
from rimroll.bodies.body import Body, one_body
from rimroll.errors import RimrollError, callback, expect
from rimroll.laws import Coulomb, Law, one_law
from rimroll.motion import Motion, simulate
from rimroll.sensors.filmed.film_model import FilmModel, Marker, plane_of
from rimroll.sensors.filmed.track import MIN_SAMPLES, Track
from rimroll.sensors.filmed.track_result import TrackFit
from rimroll.sensors.fits import (
    BODY,
    Estimate,
    Minimum,
    at_friction,
    chi_square,
    fitted_names,
    friction_interval,
    highest_friction,
    inflation,
    least,
    with_numbers,
)
from rimroll.state import State
from rimroll.theory.closed_forms import balance_tilt, needed_friction
from rimroll.units import Number, number, positive

Array = NDArray[np.float64]

TILTS = 10
"""Tilts at the release from which a search begins, up to the balance point."""
FRICTIONS = 5
"""And frictions,"""
SIDES = (0.06, -0.06)
"""yaw rates, rad/s,"""
EARLIER = 8
"""and moments of the release before the first movement that is seen."""
LONGEST = 0.3
"""How much earlier than that the release may be, s."""
BEST = 6
"""The starts from which the search goes on."""
MOVED = 5.0
"""What is taken for movement, in errors of a sample."""
ROUNDS = 100
"""Most evaluations of the last searches; a marker beside the axis makes long valleys."""
NEAR = 2.0
"""Searches that leave at most so many times as much as the best one count as minima."""
MAX_RESTARTS = 3
"""How often the interval is sought anew because a lower minimum was met."""
TOO_LATE = 0.05
"""How long after the release a track may begin, s."""
LONG = 1.5
"""Duration of the motions of a search, s."""
LARGEST_START = 0.5
"""What the best start may leave of the movement."""
LARGEST_LEFT = 0.1
"""Residual over the movement (root mean squares) from which on no motion describes a track."""
LARGEST_NOISE = 0.22
"""The same where the residual is less than ``FEW_ERRORS``."""
FEW_ERRORS = 3.0
"""In errors of a sample."""
ERRORS = {"path": 1e-3, "lean": math.radians(1.0), "tilt": math.radians(1.0)}
"""The error of a sample unless it is given, m or rad."""


def fit_track(
    track: Track,
    body: Body,
    law: Law | None = None,
    *,
    marker: tuple[Number, Number] | None = None,
    error: Number | None = None,
    gravity: Number = _core.STANDARD_GRAVITY,
    confidence: Number = 0.95,
    body_error: Number = 0.01,
    fit: Sequence[str] | None = None,
    progress: Callable[[int, int], None] | None = None,
) -> TrackFit:
    """Fit the motion after a release to a film of it.

    The track begins while a hand holds the body at rest at the tilt of the release, at most 0.05 s
    after it. The fit goes to the largest tilt after the first near-collision. The start, the
    numbers of the law, the moment of the release, and the camera's direction, origin and scale
    follow together by least squares. The camera looks straight down from far away. The rates at the
    release are expected to be 0 within 0.5 rad/s, the scale to be right within 2 % (standard
    deviations).

    Raises ``RimrollError`` for a track in which nothing moves, one that moves farther than the body
    can carry its marker, one that ends before the largest tilt after a near-collision, and one that
    no motion describes.

    Parameters
    ----------
    track
        From :func:`rimroll.filmed.read`.
    body
        The body with its marker.
    law
        How the rim meets the table; ``Coulomb`` unless given. Its numbers are those from which the
        search begins, except for the friction, which is searched everywhere.
    marker
        For a path: the marker's distance from the axis and its height above the base, m.
    error
        The standard deviation of a position, m, or of an angle, rad: 1 mm or 1 degree unless given.
        Larger residuals widen all intervals.
    gravity, confidence, body_error, fit
        As for :func:`rimroll.fit_motion`.
    progress
        Called with what is done and what is to do in all, as the search goes on.

    Returns
    -------
    TrackFit

    Examples
    --------
    >>> import numpy as np, rimroll as rr
    >>> can = rr.bodies.can_2007()
    >>> start = rr.State(tilt=0.5, yaw_rate=0.1)
    >>> motion = rr.simulate(can, start, rr.Coulomb(0.15), duration=0.8)
    >>> t = np.arange(0.0, 1.0, 1 / 120)
    >>> moments = motion.evaluate(np.clip(t - 0.2, 0.0, 0.8))
    >>> angles = np.stack([moments.tilt, moments.yaw], axis=-1)
    >>> fitted = rr.filmed.fit_track(rr.filmed.Track(t, angles, "lean"), can)
    >>> abs(fitted.friction.value - 0.15) < 0.01
    True
    """
    expect("track", track, Track)
    one_body(body)
    if track.kind == "path" and marker is None:
        raise RimrollError("a path needs marker=(distance from the axis, height above the base)")
    beside, height = marker or (0.0, 0.0)
    point = Marker(number("marker", beside, "m"), number("marker", height, "m"))
    if not (0.0 <= point.radius < math.inf and 0.0 <= point.height < math.inf):
        raise RimrollError(f"must have lengths that are not negative, got {marker}", "marker")
    needed = float(needed_friction(body))
    given = Coulomb(0.5 * needed or 0.2) if law is None else one_law(law)
    sigma = positive("error", ERRORS[track.kind] if error is None else error)
    level = number("confidence", confidence)
    if not 0.5 <= level < 1.0:
        raise RimrollError(field="confidence", value=level, bound="at least 0.5 and below 1")
    deviation = number("body_error", body_error)
    if not 0.0 <= deviation <= 0.2:
        raise RimrollError(field="body_error", value=deviation, bound="from 0 to 0.2")
    free = tuple(fitted_names(given, fit))
    pull = positive("gravity", gravity, "m/s^2")
    end = float(track.t[-1])
    first = FilmModel(body, given, free, pull, track, point, end, sigma, deviation)
    callback("progress", progress)
    _expect_within_reach(first)
    tell = progress or (lambda done, total: None)
    guesses = _guesses(first)
    parts = len(guesses) + 2  # the searches, the last ones, the interval
    begun = []
    for i, guess in enumerate(guesses):
        tell(i, parts)
        begun.append(_refined(first, *guess))
    tell(parts - 2, parts)
    minima = _minima(begun)
    tell(parts - 1, parts)
    return _result(minima, level)


def _expect_within_reach(model: FilmModel) -> None:
    """Refuse a track in which a marker goes where no rocking body carries it.

    In a rocking, from its largest tilt on one side to that on the other, the centre of the base
    moves by less than two diameters, and the marker leans by less than its distance from the base's
    centre on either side.
    """
    track, body = model.track, model.body
    if track.kind != "path":
        tilt, farthest = float(np.abs(track.plane()).max()), math.pi / 2.0
        if tilt > farthest:
            raise RimrollError(
                f"{track.name}: a tilt of {math.degrees(tilt):.0f} degrees is beyond lying down:"
                " check the unit of the angles"
            )
        return
    seen = track.plane()
    extent = float(np.abs(seen - np.median(seen[:3].real) - 1j * np.median(seen[:3].imag)).max())
    reach = 4.0 * body.radius + 2.0 * math.hypot(model.marker.radius, model.marker.height)
    if extent > reach:
        raise RimrollError(
            f"{track.name}: the marker moves by {extent:.3g} m, but this body carries it by at most"
            f" {reach:.2g} m while it rocks: check the units, the scale and the body, and cut the"
            " film where it topples or rolls away"
        )


def _guesses(model: FilmModel) -> list[tuple[Array, float]]:
    """Vectors that suit roughly, and the times to which they are fitted, the best ones first."""
    body, track, seen = model.body, model.track, model.track.plane()
    moved = _first_movement(model)
    tilts = np.linspace(0.15, 0.97, TILTS) * balance_tilt(body)
    earlier = np.linspace(0.0, LONGEST, EARLIER)
    found: list[tuple[float, Array, float]] = []
    azimuths = [0.0]
    if "marker_azimuth" in model.names:
        azimuths = [*np.linspace(0.0, math.tau, 8, endpoint=False)]
    for tilt, friction, yaw_rate in product(tilts, _frictions(model), SIDES):
        law = with_numbers(model.law, {"friction": friction}) if friction is not None else model.law
        motion = _motion(model, State(tilt=float(tilt), yaw_rate=yaw_rate), law)
        last = None if motion is None else _largest_after(motion)
        if motion is None or last is None:
            continue
        for before, azimuth in product(earlier, azimuths):
            release = moved - before
            until = release + last
            used = track.t <= until
            spread = float(np.var(seen[used])) if used.any() else 0.0
            # The body is held where the track begins.
            if release < track.t[0] - TOO_LATE:
                continue
            # A track without noise that ends before it moves has no spread to compare with.
            if used.sum() < MIN_SAMPLES or spread == 0.0 or until > track.t[-1] + 1e-2:
                continue
            moments = motion.evaluate(np.clip(track.t[used] - release, 0.0, float(motion.t[-1])))
            at = (model.marker.radius * np.exp(1j * azimuth), model.marker.height)
            path = plane_of(moments, body, track.kind, at)
            turn, origin = _laid(path, seen[used], track.kind)
            laid = path * np.exp(1j * turn) + origin
            left = laid - seen[used] if track.kind != "tilt" else np.abs(laid) - seen[used].real
            # Over what moves, so that no short part of the track suits best.
            squares = float(np.mean(np.abs(left) ** 2)) / spread
            numbers = {
                "friction": friction, "tilt": tilt, "yaw_rate": yaw_rate, "camera": turn,
                "release": release, "origin_x": origin.real, "origin_y": origin.imag,
                "scale": 1.0, "marker_azimuth": azimuth,
            }  # fmt: skip
            start = {**model.law.numbers, **numbers}
            vector = np.array([float(start.get(name, 0.0)) for name in model.names])
            found.append((squares, vector, until))
    found.sort(key=lambda one: one[0])
    if not found:
        raise RimrollError(
            f"{track.name}: it begins after the release, or ends before the largest tilt after a"
            " near-collision, or the body is another one"
        )
    if found[0][0] > LARGEST_START**2:
        raise RimrollError(
            f"{track.name}: no fall of this body looks like it: at best,"
            f" {100.0 * math.sqrt(found[0][0]):.0f} % of the movement is left. Check the body, the"
            " marker and the units, and that the track begins while the body is held"
        )
    # The best one of each friction and side, because several minima may lie close together.
    chosen: dict[tuple[float, ...], tuple[Array, float]] = {}
    places = [i for i, name in enumerate(model.names) if name in ("friction", "yaw_rate")]
    for _, vector, until in found:
        chosen.setdefault(tuple(vector[places]), (vector, until))
    return list(chosen.values())[:BEST]


def _frictions(model: FilmModel) -> list[float | None]:
    if "friction" not in model.free:
        return [None]
    highest = highest_friction(model.body)
    return [float(one) for one in np.linspace(0.08, 0.95, FRICTIONS) * highest]


def _first_movement(model: FilmModel) -> float:
    """When the track leaves its first place, s."""
    track, seen = model.track, model.track.plane()
    away = np.abs(seen - np.median(seen[:3].real) - 1j * np.median(seen[:3].imag))
    extent = float(away.max())
    if not extent > 2.0 * MOVED * model.error:
        raise RimrollError(
            f"{track.name}: nothing moves in it by more than {extent:.2g}"
            f" {'m' if track.kind == 'path' else 'rad'}: check the units and the scale"
        )
    first = int(np.argmax(away > MOVED * model.error))
    return float(track.t[first])


def _motion(model: FilmModel, start: State, law: Law) -> Motion | None:
    try:
        return simulate(model.body, start, law, LONG, gravity=model.gravity, rtol=1e-7)
    except RimrollError:
        return None


def _largest_after(motion: Motion) -> float | None:
    """The time of the largest tilt after the first near-collision, s."""
    lows = [event.t for event in motion.events if event.kind == "tilt_min"]
    highs = [event.t for event in motion.events if event.kind == "tilt_max"]
    return next((t for t in highs if lows and t > lows[0]), None)


def _laid(
    path: NDArray[np.complex128], seen: NDArray[np.complex128], kind: str
) -> tuple[float, complex]:
    """The turn and the shift that lay a path over the one that is seen."""
    if kind == "tilt":
        return 0.0, 0j
    shift = kind == "path"
    middle, its = (seen.mean(), path.mean()) if shift else (0j, 0j)
    turn = float(np.angle(np.sum((seen - middle) * np.conj(path - its))))
    return turn, complex(middle - its * np.exp(1j * turn))


def _refined(model: FilmModel, vector: Array, until: float) -> Minimum[FilmModel]:
    """The minimum near a guess: first as if the film were coarse, then as it is."""
    exact = replace(model, until=until)
    coarse = least(replace(exact, error=5.0 * model.error), vector)
    return least(exact, coarse.vector)


def _minima(begun: list[Minimum[FilmModel]]) -> list[Minimum[FilmModel]]:
    """The minima to which the searches lead, over the samples of the best one; the lowest first."""
    best = min(begun, key=_part_left)
    near = [one for one in begun if _part_left(one) < NEAR * _part_left(best)]
    found = [least(best.model, one.vector, ROUNDS) for one in near]
    return sorted(found, key=lambda one: one.squares)


def _part_left(one: Minimum[FilmModel]) -> float:
    """What is left over what moves, root mean squares."""
    model = one.model
    try:
        left = model.left(one.vector)
    except RimrollError:
        return math.inf
    squares = float(np.sum(left**2)) / len(left)
    part = math.sqrt(squares / float(np.var(model.track.plane()[model.used])))
    return part if math.isfinite(part) else math.inf


def _result(minima: list[Minimum[FilmModel]], confidence: float) -> TrackFit:
    best = minima[0]
    model = best.model
    level = chi_square(confidence)
    left = model.left(best.vector)
    is_noise = np.mean((left / model.error) ** 2) < FEW_ERRORS**2
    if not _part_left(best) < (LARGEST_NOISE if is_noise else LARGEST_LEFT):
        raise RimrollError(
            f"{model.track.name}: no motion under {model.law!r} describes it. Check the body, the"
            " marker, the units, and that the track begins while the body is held"
        )
    factor = inflation(left / model.error, len(best.vector))
    interval = None
    if "friction" in model.free:
        interval, best = _friction_interval(minima, level * factor, highest_friction(model.body))
    errors = np.sqrt(np.diag(best.covariance) * factor)
    numbers = {}
    for name, value, one in zip(model.names, best.vector, errors, strict=True):
        half = math.sqrt(level) * float(one)
        floor = 0.0 if name in model.free else -math.inf
        ends = (max(float(value) - half, floor), float(value) + half)
        numbers[name] = Estimate(float(value), float(one), ends, "covariance")
    if interval is not None:
        there = numbers["friction"]
        numbers["friction"] = Estimate(there.value, there.error, interval, "profile")
    return TrackFit(
        model.track, model.law_at(best.vector), model.motion(best.vector), numbers,
        model.track.t[model.used], model.shown(best.vector), model.left(best.vector), factor,
        _notes(model, best, factor, interval),
    )  # fmt: skip


def _friction_interval(
    minima: list[Minimum[FilmModel]], rise: float, highest: float
) -> tuple[tuple[float, float | None], Minimum[FilmModel]]:
    """The interval of the friction over all minima, and the lowest minimum that was met."""
    for _ in range(MAX_RESTARTS):
        best, lowest = minima[0], minima[0]
        lows, highs = [], []
        for one in minima:
            left = rise - (one.squares - best.squares)
            if left <= 0.0:
                continue
            low, high, lower = friction_interval(one, left, highest, ROUNDS)
            lowest = min(lowest, lower, key=lambda each: each.squares)
            lows.append(low)
            highs.append(math.inf if high is None else high)
        if lowest is best:
            break
        minima = [lowest, *minima]
    place = lowest.model.free.index("friction")
    rolling = least(at_friction(lowest.model, highest), np.delete(lowest.vector, place), ROUNDS)
    rolls = rolling.squares - lowest.squares <= rise  # beyond a friction that is less likely
    end = max(highs)
    return (min(lows), None if rolls or end == math.inf else end), lowest


def _notes(
    model: FilmModel,
    best: Minimum[FilmModel],
    factor: float,
    interval: tuple[float, float | None] | None,
) -> list[str]:
    notes = [*model.track.notes]
    if factor > 2.0:
        notes.append(
            "The residuals are larger than the error of a sample, or hang together from frame to"
            f" frame, so all intervals are {math.sqrt(factor):.1f} times wider."
        )
    if model.track.kind == "tilt":
        notes.append(
            "Tilts show no direction: the friction follows from the energy that is lost alone."
        )
    if interval is not None:
        needed = float(needed_friction(model.body))
        if interval[0] < 0.05 * needed and (interval[1] is None or interval[1] > 0.95 * needed):
            notes.append("The film hardly limits the friction.")
    largest = max(abs(float(best.vector[model.names.index(f"{one}_deviation")])) for one in BODY)
    if model.body_error > 0.0 and largest > 3.0 * model.body_error:
        notes.append("The body differs from what was measured by more than three of its errors.")
    return notes
