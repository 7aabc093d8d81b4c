"""Left or right: the direction of fall over a plane of starts, and the line on which it jumps.

A body released without yaw rate and spin rate comes down flat. The smallest of either decides to
which side it rises again. The starts that come down flat form a line in the plane of the two rates:
the watershed between falls to the left and falls to the right.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import fields, replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rimroll import _core
from rimroll.bodies.body import Body, body_of, one_body
from rimroll.errors import RimrollError, callback, expect, hold
from rimroll.laws import IDEAL, Law, ideal, law_of
from rimroll.many.ensemble import OPTIONS, VARIABLES, exact_falls, fell, follow
from rimroll.many.falls import Column, Falls, Interrupted
from rimroll.options import Keywords, Options, takes_options
from rimroll.state import State, single
from rimroll.theory.exact import conserves_energy
from rimroll.units import Number, Values, number, numbers

if TYPE_CHECKING:
    from typing import Unpack

    import xarray as xr


Array = NDArray[np.float64]

HALVINGS = 50
"""How often bisection halves the interval around a watershed: to the last digits of a double."""


MAPPING = replace(OPTIONS, rtol=1e-6)
"""The defaults of :func:`turn_map`."""


@takes_options(MAPPING, "flat", "flat_gap")
def turn_map(
    body: Body,
    start: State,
    law: Law,
    yaw_rates: Values,
    spin_rates: Values,
    *,
    duration: Number | None = None,
    threads: int | None = None,
    progress: Callable[[int, int], object] | None = None,
    options: Options | None = None,
    **keywords: Unpack[Keywords],
) -> xr.Dataset:
    """Follow a body from each start in a plane of yaw and spin rates: its turn and direction.

    Parameters
    ----------
    body, law
        What rolls, and how its rim meets the table.
    start
        One start; the yaw and spin rates of the map replace its own.
    yaw_rates, spin_rates
        dψ/dt and dθ/dt, rad/s, each a flat array in rising order.
    duration, gravity, rtol, topple_tilt, max_steps, options, threads, progress
        As for :func:`rimroll.ensemble`. At the default ``rtol`` a turn is right to 1e-4 degrees.
        Under ``NoSlip()``, ``Frictionless()`` and ``InPlace()`` turns are computed by quadrature,
        see :func:`rimroll.exact_turn`; there ``duration``, ``rtol`` and ``max_steps`` are checked
        but not used.

    Returns
    -------
    xarray.Dataset
        ``outcome`` and the variables of :func:`rimroll.ensemble`, among them ``turn``,
        ``direction`` and ``min_tilt``, over (``spin_rate``, ``yaw_rate``). Variables about losses
        and steps are left out where turns are computed by quadrature. Angles are in rad; a
        direction above π is a fall to the left of a hand that flicks the body away from itself. The
        attributes hold everything else that the map was computed from.

    Raises
    ------
    RimrollError
        A number outside its bounds, rates that are not a flat array or do not increase.
    Interrupted
        On Ctrl-C; it carries the rows of the map, one for each spin rate, that are complete.
    """
    chosen = MAPPING.changed(options, duration, keywords)
    falls = map_falls(body, start, law, yaw_rates, spin_rates, chosen, threads, progress)
    return falls.to_xarray()


def map_falls(
    body: Body,
    start: State,
    law: Law,
    yaw_rates: Values,
    spin_rates: Values,
    options: Options,
    threads: int | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> Falls:
    """What :func:`turn_map` computes, in plain columns; arguments and errors are its own."""
    expect("start", start, State)
    start = single(start)
    yaw, spin = _rising("yaw_rates", yaw_rates), _rising("spin_rates", spin_rates)
    callback("progress", progress)
    given: State = start
    starts = replace(given, yaw_rate=np.tile(yaw, len(spin)), spin_rate=np.repeat(spin, len(yaw)))
    try:
        if conserves_energy(law):
            # One step of one fall, for the errors of a stepped map.
            follow(body, start, law, replace(options, max_steps=1), threads=threads)
            falls = exact_falls(
                body,
                starts,
                law,
                gravity=options.gravity,
                topple_tilt=options.topple_tilt,
                threads=threads,
                progress=progress,
            )
        else:
            falls = follow(body, starts, law, options, threads=threads, progress=progress)
    except Interrupted as interrupted:
        raise Interrupted(_plane(interrupted.falls, yaw, spin, start)) from None
    return _plane(falls, yaw, spin, start)


def watershed(
    body: Body,
    start: State,
    law: Law,
    spin_rates: Values,
    *,
    gravity: Number = _core.STANDARD_GRAVITY,
    rtol: Number = 1e-8,
) -> Array:
    """The yaw rates (n,), rad/s, at which the direction of fall jumps from right to left.

    One for each of the spin rates (n,), rad/s, which replace that of the start. They are found by
    bisection over simulated falls, under any law. Under the two ideal laws the watershed is a
    straight line, see :func:`watershed_slope`.

    Raises ``RimrollError`` where no yaw rate in a plausible interval separates left from right, as
    for starts that do not come down.
    """
    one_body(body)
    expect("start", start, State)
    given: State = single(start)
    spin = _flat("spin_rates", spin_rates)
    options = replace(
        OPTIONS, gravity=number("gravity", gravity, "m/s^2"), rtol=number("rtol", rtol)
    )
    slope = max(watershed_slope(body, single(start).tilt, one) for one in IDEAL)
    ends = np.sort([-slope * spin, 3.0 * slope * spin], axis=0)

    def to_the_left(yaw_rate: Array) -> NDArray[np.bool_]:
        starts = replace(given, yaw_rate=yaw_rate, spin_rate=spin)
        return goes_left(body, starts, law, options)

    turning = spin != 0.0  # without spin the watershed is at yaw rate 0, by symmetry
    low, high = ends
    if np.any(to_the_left(low)[turning]) or not np.all(to_the_left(high)[turning]):
        raise RimrollError("these starts have no watershed between falls to the left and right")
    return np.where(turning, halved(to_the_left, low, high, HALVINGS), 0.0)


def goes_left(body: Body, starts: State, law: Law, options: Options) -> NDArray[np.bool_]:
    """Whether the body turns left from each of the starts (n,), by :func:`rimroll.ensemble`."""
    turn = follow(body, starts, law, options)["turn"]
    # Rolling with a spin along its turn, the body lifts off before its tilt is smallest.
    return np.where(np.isnan(turn), starts.spin_rate > 0.0, turn > 0.0)


def halved(
    to_the_left: Callable[[Array], NDArray[np.bool_]], low: Array, high: Array, times: int
) -> Array:
    """The yaw rates where the side changes, by bisection between ``low`` (right) and ``high``."""
    for _ in range(times):
        middle = 0.5 * (low + high)
        left = to_the_left(middle)
        low, high = np.where(left, low, middle), np.where(left, middle, high)
    return 0.5 * (low + high)


def watershed_slope(body: Body, tilt: Number, law: Law) -> float:
    """The ratio of yaw rate to spin rate of the starts at a tilt (rad) that come down flat.

    Without slip or without friction yaw and spin rates obey linear equations with the tilt as
    independent variable. The watershed is therefore a straight line through the start without
    either rate, whatever the tilt rate and gravity. Frictionless: A l + C s cos φ and s are
    constant and l = 0 at φ = 0, hence C/(A (1 + cos φ) − C cos φ). No slip: the solution of the
    linear equations that is regular at φ = 0, as a power series. The paper says only that the side
    depends sensitively on the start.

    Raises ``RimrollError`` for other laws and for a tilt outside (0, π/2).
    """
    return _core.watershed_slope(one_body(body), number("tilt", tilt, "rad"), ideal(law).name)


def _plane(falls: Falls, yaw: Array, spin: Array, start: State) -> Falls:
    """The falls laid out in the plane; an incomplete last row is left out."""
    shape = falls.size // len(yaw), len(yaw)
    whole = shape[0] * shape[1]
    kept = ("tilt", "tilt_rate", "yaw", "spin")
    return replace(
        falls,
        columns={
            name: replace(column, values=column.values[:whole].reshape(shape))
            for name, column in falls.columns.items()
            if name in ("outcome", *VARIABLES)
        },
        axes={
            "spin_rate": Column(spin[: shape[0]], "rad/s", "dθ/dt at the start"),
            "yaw_rate": Column(yaw, "rad/s", "dψ/dt at the start"),
        },
        attrs={**{f"start_{name}": getattr(start, name) for name in kept}, **falls.attrs},
    )


def _flat(name: str, values: Values) -> Array:
    """Rates (n,), rad/s."""
    array = np.atleast_1d(numbers(name, values, "rad/s"))
    if array.ndim > 1 or not array.size:
        raise RimrollError(field=name, value=values, bound="a flat array of numbers")
    hold(name, array, np.isfinite(array), "finite")
    return array


def _rising(name: str, values: Values) -> Array:
    array = _flat(name, values)
    falling = np.flatnonzero(np.diff(array) <= 0.0)
    if falling.size:
        k = falling[0]
        raise RimrollError(
            f"must rise from one to the next, got {name}[{k + 1}] = {array[k + 1]} after"
            f" {array[k]} rad/s",
            name,
        )
    return array


ROWS = 60
"""Largest number of rows in which bisection seeks the line; between them it is nearly straight."""

LINE_HALVINGS = 8
"""Bisections between two starts of a map: to less than a picture shows."""


def side_line(falls: Falls | xr.Dataset, lowest: float, highest: float) -> tuple[Array, Array]:
    """Yaw and spin rates along the line between falls to the right and to the left, rad/s.

    Under the ideal laws it is straight, from one spin rate to the other. Under friction it has a
    point for each row of the map (for some rows of a large map) in which the side changes once,
    from right to left. Without such rows, or without falls, the arrays are empty.
    """
    falls = Falls.of(falls)
    law, tilt = law_of(falls), falls.attrs["start_tilt"]
    if not fell(falls).any():
        return np.empty(0), np.empty(0)
    if law not in IDEAL:
        return _by_bisection(falls)
    spin = np.array([lowest, highest] if tilt < 0.5 * np.pi else [])
    slope = watershed_slope(body_of(falls), tilt, law) if spin.size else 0.0
    return slope * spin, spin


def _by_bisection(falls: Falls) -> tuple[Array, Array]:
    attrs = falls.attrs
    rows = np.unique(np.linspace(0, len(falls["spin_rate"]) - 1, ROWS).astype(int))
    between = {k: ends for k in rows if (ends := _change(falls, k)) is not None}
    low, high = np.array([*between.values()]).reshape(-1, 2).T
    spin = falls["spin_rate"][[*between]] if between else np.empty(0)
    start = {name: attrs[f"start_{name}"] for name in ("tilt", "tilt_rate", "yaw", "spin")}
    options = replace(
        OPTIONS,
        **{field.name: attrs[field.name] for field in fields(Options) if field.name in attrs},
    )
    body, law = body_of(falls), law_of(falls)

    def to_the_left(yaw_rate: Array) -> NDArray[np.bool_]:
        starts = State(**start, yaw_rate=yaw_rate, spin_rate=spin)
        return goes_left(body, starts, law, options)

    return halved(to_the_left, low, high, LINE_HALVINGS), spin


def _change(falls: Falls, row: int) -> tuple[float, float] | None:
    """The yaw rates between which the side changes in a row of a map, if it does so once."""
    turn = falls["turn"][row]
    known = np.flatnonzero(~np.isnan(turn))
    left = turn[known] > 0.0
    changes = np.flatnonzero(left[1:] & ~left[:-1])
    if len(changes) != 1:
        return None
    low, high = falls["yaw_rate"][known[[changes[0], changes[0] + 1]]]
    return float(low), float(high)


def away(middle: float, degrees: ArrayLike) -> Array:
    """Differences of directions from another one, −180 to 180."""
    return np.asarray(np.mod(np.asarray(degrees, np.float64) - middle + 180.0, 360.0) - 180.0)


def around(middle: float, degrees: ArrayLike) -> Array:
    """Directions as angles within half a turn of another."""
    return middle + away(middle, degrees)


def middle_of(degrees: ArrayLike) -> float:
    """180 or 0, whichever is closer to the directions on average."""
    return min((180.0, 0.0), key=lambda middle: float(np.abs(away(middle, degrees)).mean()))
