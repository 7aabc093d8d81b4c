"""First turns by quadrature: to 10⁻¹² rad, and a million of them in seconds."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from rimroll import _core
from rimroll.bodies.body import Body
from rimroll.errors import RimrollError, expect
from rimroll.laws import Frictionless, InPlace, Law, NoSlip, contact_law
from rimroll.many.grid import Grid
from rimroll.many.rows import Rows
from rimroll.motion.jacobian import PARAMETERS
from rimroll.state import Numbers, State
from rimroll.units import Number, number, optional, thread_count

Array = NDArray[np.float64]

CHUNK = 1 << 16
"""Starts in a chunk, which takes a fraction of a second: after each, progress is reported and
Ctrl-C is heard."""

JACOBIAN_CHUNK = 1 << 11
"""Starts in a chunk when derivatives are computed, which takes longer."""

OUTCOME_OF = np.array(_core.OUTCOMES)
"""The outcomes by the core's codes."""

NUMBERS = ("turn", "min_tilt", "end_tilt", "min_tilt_time", "end_time", "yaw_change")
"""The numbers of an :class:`ExactTurn`, in the core's order."""


@dataclass(frozen=True, eq=False)
class ExactTurn:
    """The first turn from each start: single numbers, or arrays of the starts' shape.

    They are data arrays of xarray where a body or start has data arrays. The names are those of the
    columns of :func:`rimroll.ensemble`, with the same meaning.

    A turn begins at the release if the tilt falls then, else at the next tilt maximum. The sign of
    ``tilt_rate`` decides, however small it is; at exactly 0, the sign of the tilt's acceleration
    decides. So a body released near its smallest tilt has half a turn if it falls even slightly,
    and a whole turn if it is at rest or rises. A turn ends at the first tilt maximum after the
    near-collision, or earlier if the body topples or its rim leaves the table. Numbers that a
    motion does not have are NaN.
    """

    turn: Numbers
    """Angle of turn, rad: the change of yaw in the turn, with its sign. It is small for a body that
    dips and falls over near where it leaned at first."""
    min_tilt: Numbers
    """The smallest tilt, rad: how close the near-collision was."""
    end_tilt: Numbers
    """The tilt at the end of the turn, rad; for a body that rocked, its largest tilt."""
    min_tilt_time: Numbers
    """Time of the smallest tilt, s from the release."""
    end_time: Numbers
    """Time of the end of the turn, s from the release."""
    yaw_change: Numbers
    """Change of yaw from the release to the end of the turn, rad."""
    outcome: str | NDArray[np.str_]
    """What became of the body, as in :func:`rimroll.ensemble`: ``rocked`` (passed a tilt minimum,
    then a tilt maximum), ``toppled`` (passed a tilt minimum, then reached the topple tilt, or
    lifted off beyond the balance tilt), ``fell_back`` (fell over without a tilt minimum),
    ``lifted_off`` (the table would have had to pull the rim down), ``face_down`` (came down flat),
    ``hovered`` (none of these for very long, as in steady precession) or ``failed``. A disk that
    rises to the vertical counts as ``rocked``. Only ``rocked`` and ``toppled`` have a turn, and
    ``lifted_off`` if the rim leaves the table as the body rises."""
    jacobian: Mapping[str, Numbers] | None = None
    """With ``jacobian=True``: ∂turn/∂parameter for each of ``tilt``, ``tilt_rate``, ``yaw``,
    ``yaw_rate``, ``spin``, ``spin_rate``, ``mass``, ``radius``, ``height``,
    ``transverse_inertia``, ``axial_inertia`` and ``gravity``; rad per the parameter's SI unit."""


def exact_turn(
    body: Body,
    start: State,
    law: Law,
    *,
    gravity: Number = _core.STANDARD_GRAVITY,
    topple_tilt: Number | None = None,
    threads: int | None = None,
    jacobian: bool = False,
) -> ExactTurn:
    """The first turn of a body that rocks, from each start, without stepping through its motion.

    Without slip, without friction and in place, energy is conserved and the tilt alone determines
    the yaw and spin rates; so turn and times are integrals over the tilt.

    Without slip and without friction, errors are below 1e-12 rad in the turn, whether the body
    rocks or topples, however flat it comes down and however near the balance point it is released.
    Errors of times are below 2e-11 of the whole time, or 1e-9 for a body that lingers at the
    balance point. In place, turns agree with steps to 1e-9 rad. Two kinds of start have larger
    errors. If a change in the last digit of the start changes the turn by more than this (see
    ``jacobian``), as for a coin almost on its edge, the error is about ten times that change. For
    oscillations smaller than 1 % of the tilt, one digit is lost per further factor of ten. A few
    starts at the boundary between rocking and toppling are too hard for quadrature and are stepped.

    The results are the same, to the last bit, for any number of threads and whatever the other
    rows.

    Parameters
    ----------
    body, start
        What rolls and how it is released. Arrays in their fields broadcast as in NumPy, data arrays
        of xarray by the names of their dimensions. Each body is prepared once for all its starts,
        which takes as long as about a hundred turns.
    law
        ``NoSlip()``, ``Frictionless()`` or ``InPlace()``, whose spin rate is 0 or minus the yaw
        rate.
    gravity
        m/s².
    topple_tilt
        The tilt at which the body counts as toppled, rad; π/2 unless given, none for a disk.
    threads
        Number of threads; by default one for each processor.
    jacobian
        Whether to compute the derivatives of the turn; not for ``InPlace()``.

    Raises
    ------
    RimrollError
        Another law, a resistance, derivatives under ``InPlace()``, a number outside its bounds; for
        an array the message names the element, as ``tilt[1]``.
    """
    if not conserves_energy(law):
        raise RimrollError(
            field="law",
            value=law,
            bound=(
                "NoSlip, Frictionless or InPlace without resistances, under which turns"
                " are integrals"
            ),
            hint=": rimroll.ensemble follows falls under any law",
        )
    if jacobian and isinstance(law, InPlace):
        raise RimrollError(
            "must be False under InPlace, under which the spin rate of a start is not free",
            "jacobian",
        )
    expect("body", body, Body)
    expect("start", start, State)
    rows = Rows.of(body, start)
    parts = turns_in_parts(rows, law, gravity, topple_tilt, threads, bool(jacobian))
    codes, table, derivatives = (np.concatenate(of, axis=-1) for of in zip(*parts, strict=True))
    return ExactTurn(
        **_named(rows.grid, NUMBERS, table),
        outcome=rows.grid.laid_out(OUTCOME_OF[codes]),
        jacobian=_named(rows.grid, PARAMETERS, derivatives) if jacobian else None,
    )


def turns_in_parts(
    rows: Rows,
    law: Law,
    gravity: Number,
    topple_tilt: Number | None,
    threads: int | None,
    jacobian: bool = False,
) -> Iterator[tuple[NDArray[np.uint8], Array, Array]]:
    """The turns, some rows at a time; one part, which is empty, where there are no rows.

    For n rows: their outcomes (n,) as places in :data:`OUTCOME_OF`, the :data:`NUMBERS`, one column
    a row, and the derivatives likewise, without a row unless asked for.
    """
    options = (
        number("gravity", gravity, "m/s^2"),
        optional("topple_tilt", topple_tilt, "rad"),
        thread_count(threads),
    )
    at_a_time = JACOBIAN_CHUNK if jacobian else CHUNK
    for first in range(0, max(1, rows.grid.size), at_a_time):
        part = slice(first, first + at_a_time)
        bodies, starts = rows.bodies.part(part), rows.starts.part(part)
        try:
            codes, table, derivatives = _core.exact_turns(
                bodies, starts, law.name, *options, jacobian
            )
        except RimrollError as refusal:
            raise rows.placed(refusal, law.name, *options[:2]) from None
        _, outcomes = codes
        none = np.empty((0, len(outcomes)))
        yield outcomes, table, none if derivatives is None else derivatives


def conserves_energy(law: Law) -> bool:
    """Whether a law conserves energy, so that turns are integrals."""
    contact_law(law)
    return type(law) in (NoSlip, Frictionless, InPlace) and not law.resistances


def _named(grid: Grid, names: tuple[str, ...], table: Array) -> dict[str, Numbers]:
    return {name: grid.laid_out(row) for name, row in zip(names, table, strict=True)}
