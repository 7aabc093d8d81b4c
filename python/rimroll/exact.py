"""First turns by quadrature: to 10⁻¹² rad, and a million of them in seconds."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from rimroll import _core
from rimroll.body import Body
from rimroll.errors import RimrollError, expect
from rimroll.given import Number, number, optional
from rimroll.grid import Grid
from rimroll.jacobian import PARAMETERS
from rimroll.laws import Frictionless, Law, NoSlip, contact_law
from rimroll.motion import thread_count
from rimroll.rows import Rows
from rimroll.state import Numbers, State

Array = NDArray[np.float64]

AT_A_TIME = 1 << 16
"""Turns between two moves of a progress bar, and what Ctrl-C may lose: a fraction of a second."""

DERIVED_AT_A_TIME = 1 << 11
"""The same with derivatives."""

OUTCOMES = np.array(_core.OUTCOMES)
"""What can become of a body, by the core's codes."""

NUMBERS = tuple(_core.EXACT_COLUMNS)
"""Of an :class:`ExactTurn`."""


@dataclass(frozen=True, eq=False)
class ExactTurn:
    """The first turn from each of some starts: single numbers, or arrays shaped like these.

    Where a start or body has data arrays of xarray, so has this.

    A turn begins at the release or, where the tilt rises then, at the tilt maximum that follows:
    the sign of ``tilt_rate`` decides, however small it is, and at exactly 0 that of the tilt's
    acceleration. So a body let go about where its tilt is smallest has half the turn if it falls
    by however little, and the whole if it is at rest or rises. A turn ends at the first tilt
    maximum after the near-collision, or where the body topples or its rim leaves the table before
    that. Numbers that a motion does not have are NaN.
    """

    turn: Numbers
    """Signed change of yaw in the turn, rad: by how much the contact point went round. A body that
    dips and falls over near where it leaned has a small one."""
    min_tilt: Numbers
    """The smallest tilt, rad: how near the near-collision was."""
    max_tilt: Numbers
    """The tilt at which the turn ends, the largest of a body that rocked, rad."""
    min_time: Numbers
    """Time of the smallest tilt, s from the release."""
    time: Numbers
    """Time of the end of the turn, s from the release."""
    yaw: Numbers
    """Change of yaw from the release to the end of the turn, rad."""
    status: str | NDArray[np.str_]
    """What became of the body: ``rocked`` (came down and rose again to a tilt maximum), ``toppled``
    (came down, be it only a little, and rose over the topple tilt, on whatever side), ``fell_back``
    (fell over as it leaned: its tilt only grew, or was smallest at the release),
    ``lifted_off`` (the rim would have to be pulled down), ``face_down`` (came down flat),
    ``hovered`` (did neither for very long, as in steady precession) or ``failed``. A disk that
    rises to the vertical counts as ``rocked``. None but ``rocked`` and ``toppled`` have a turn,
    save one whose rim leaves the table as it rises."""
    jacobian: Mapping[str, Numbers] | None = None
    """If asked for: ∂turn/∂parameter for each of ``tilt``, ``tilt_rate``, ``yaw``, ``yaw_rate``,
    ``spin``, ``spin_rate``, ``mass``, ``radius``, ``height``, ``transverse_inertia``,
    ``axial_inertia`` and ``gravity``; rad per the parameter's SI unit."""


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

    Without slip or without friction energy is kept, and yaw and spin rates follow from the tilt
    alone; so turn and times are integrals over the tilt. The turn is right to 1e-12 rad, whether
    the body rocks or topples, however flat it comes down and however near the balance point it is
    let go; and the times to 2e-11 of the whole, or, of one that lingers at the balance point, 1e-9.
    Where the last digit of a start moves the turn by more (``jacobian`` tells), as that of a coin
    which all but stands on its edge, the error is some ten times that. Of tilts that hardly change
    there is a digit less for each digit by which the swing is smaller than a hundredth of the tilt.
    The few starts that no rule resolves, next to the edge between rocking and toppling, are
    stepped. The results are the same, to the last bit, for any number of threads and in any
    company.

    Parameters
    ----------
    body, start
        What rolls and how it is let go: single ones, or arrays, which broadcast against one another
        as in NumPy, and data arrays of xarray by the names of their dimensions. A body is prepared
        once for all of its starts, which takes as long as about a hundred of them.
    law
        ``NoSlip()`` or ``Frictionless()``.
    gravity
        m/s².
    topple_tilt
        The tilt at which the body counts as toppled, rad; π/2 unless given, none for a disk.
    threads
        How many to use; as many as there are processors unless given.
    jacobian
        Whether to differentiate the turn by all that it depends on.

    Raises
    ------
    RimrollError
        Another law, a resistance, a number outside its bounds; of an array the message names the
        element, ``tilt[1]``.
    """
    if not conserves_energy(law):
        raise RimrollError(
            "law must be NoSlip or Frictionless without resistances, under which turns are"
            f" integrals, got {law!r}: rimroll.ensemble follows falls under any law"
        )
    expect("body", body, Body)
    expect("start", start, State)
    rows = Rows.of(body, start)
    parts = turns_in_parts(rows, law, gravity, topple_tilt, threads, bool(jacobian))
    codes, table, derivatives = (np.concatenate(of, axis=-1) for of in zip(*parts, strict=True))
    endings, _ = codes
    return ExactTurn(
        **_named(rows.grid, NUMBERS, table),
        status=rows.grid.laid_out(OUTCOMES[endings]),
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
    """The turns of some rows after the other, at least once.

    For each row two codes of :data:`OUTCOMES`, how the turn ended and what became of the body,
    and a column of the :data:`NUMBERS` and, if asked for, of derivatives.
    """
    options = (
        number("gravity", gravity, "m/s^2"),
        optional("topple_tilt", topple_tilt, "rad"),
        thread_count(threads),
    )
    at_a_time = DERIVED_AT_A_TIME if jacobian else AT_A_TIME
    for first in range(0, max(1, rows.grid.size), at_a_time):
        part = slice(first, first + at_a_time)
        bodies, starts = rows.bodies.part(part), rows.starts.part(part)
        try:
            codes, table, derivatives = _core.exact_turns(
                bodies, starts, law.name, *options, jacobian
            )
        except RimrollError as refusal:
            raise rows.placed(refusal, *options[:2]) from None
        none = np.empty((0, codes.shape[1]))
        yield codes, table, none if derivatives is None else derivatives


def conserves_energy(law: Law) -> bool:
    """Whether nothing is lost under a law, so that turns are integrals."""
    contact_law(law)
    return type(law) in (NoSlip, Frictionless) and not law.resistances


def _named(grid: Grid, names: tuple[str, ...], table: Array) -> dict[str, Numbers]:
    return {name: grid.laid_out(row) for name, row in zip(names, table, strict=True)}
