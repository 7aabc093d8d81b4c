"""Simulate one motion."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, overload

from rimroll.bodies.body import Body, one_body
from rimroll.bodies.polygons import PolygonalBody
from rimroll.errors import RimrollError, callback, expect
from rimroll.laws import Law, one_law
from rimroll.motion.motion import Motion, follow
from rimroll.options import Keywords, Options, ground_given, takes_options
from rimroll.state import State, single
from rimroll.units import Number, number

if TYPE_CHECKING:
    from typing import Unpack

    from rimroll.ground.ground import Ground
    from rimroll.motion.polygons import PolygonMotion


@overload
def simulate(
    body: PolygonalBody,
    start: State,
    law: Law,
    duration: Number | None = None,
    *,
    restitution: float = 0.0,
    progress: Callable[[float], object] | None = None,
    options: Options | None = None,
    **keywords: Unpack[Keywords],
) -> PolygonMotion: ...


@overload
def simulate(
    body: Body,
    start: State,
    law: Law,
    duration: Number | None = None,
    *,
    ground: Ground | None = None,
    progress: Callable[[float], object] | None = None,
    jacobian: bool = False,
    options: Options | None = None,
    **keywords: Unpack[Keywords],
) -> Motion: ...


@takes_options(Options())
def simulate(
    body: Body | PolygonalBody,
    start: State,
    law: Law,
    duration: Number | None = None,
    *,
    ground: Ground | None = None,
    restitution: float = 0.0,
    progress: Callable[[float], object] | None = None,
    jacobian: bool = False,
    options: Options | None = None,
    **keywords: Unpack[Keywords],
) -> Motion | PolygonMotion:
    """Follow a body from a start under a contact law.

    Parameters
    ----------
    body, start, law
        What rolls, how it is released (single numbers), and how its rim meets the table. A
        :class:`rimroll.PolygonalBody` pivots from corner to corner, with impacts and flights,
        under ``NoSlip`` or ``Frictionless`` on a table at rest, and gives a
        :class:`rimroll.PolygonMotion`; at spin 0 it leans over a corner, at spin π/n over an edge.
        Without slip, a start over an edge with a spin rate stands on the corner from which the
        other one rises. With a yaw rate alone the middle of the edge is at rest; its ends cannot
        go on turning about it, so such a motion begins with an impact at t = 0 that takes the
        difference.
    duration
        Length of the motion, s. The motion may end earlier; its status says why.
    gravity
        m/s²; 9.80665 unless given. The paper used 9.8.
    rtol
        Intended error over some tens of rockings, relative to the size of each quantity, 1e-14 to
        1e-3; below 1e-13 rounding dominates. Each step may have a fiftieth of this error, and the
        errors add up: after thousands of steps, the energy may be wrong by a hundred times
        ``rtol``, which matters if ``rtol`` is large.
    topple_tilt
        The tilt that counts as toppled, rad. By default π/2 for a body with height, whose side
        then meets the table; none for a disk, which may stand on its edge and fall to either face.
        With corners π/2, and at most that; at exactly π/2 a flat polygon (height 0) rolls on its
        side, and does not topple until it leans further.
    max_steps
        Largest number of steps, after which the status is ``failed``; a step takes 0.3 kB. A
        rocking takes tens of steps. It takes hundreds if slip oscillates as the contact point runs
        many times round the rim: regularised friction under a body with little transverse inertia.
    ground
        The motion of the table: see :mod:`rimroll.ground`. Positions, velocities and energies are
        then relative to the table. After its end the table is at rest.
    flat
        What follows where the whole base comes down flat at once, as in planar motions, which
        rigid-body mechanics does not determine; by default ``housner`` with a ground, else
        ``stop``. ``stop``: the motion ends as ``face_down``.
        ``smooth``: the limit of near-collisions, which lose no energy; the contact point runs round
        the rim to a side that is drawn at random, always the same for the same motion, or to the
        given side with ``smooth_left`` (yaw increases) and ``smooth_right``; ``("smooth", seed)``
        draws other sides. ``housner``: a plastic collision with the opposite point of the rim
        (Housner 1963). A number r from 0 to 1: the tilt rate falls by this factor. The same follows
        where a resistance has stopped the contact point, so that the base comes down flat; but with
        ``stop`` and ``smooth`` a body comes to rest if it has fallen from a tilt at which the
        resistance still holds the contact point.
    flat_gap
        The base comes down flat also where the tilt falls below that at which the opposite point of
        the rim is this far above the table, m: from 0, which means never, to a tenth of the radius
        or, for a slender body, to where the tilt is a quarter of the balance tilt.
        It goes on in the direction in which the axis moves, with its energy and the work of the
        table's acceleration over the gap; ``smooth`` runs to the side of the yaw rate. On the way
        up nothing happens at this tilt, and a body whose energy does not suffice to reach it
        stands.
    restitution
        Restitution in the impacts of a body with corners, 0 (plastic) to 1 (no energy is lost in
        the normal direction). That of a round body belongs to its law: ``Coulomb(0.3,
        restitution=0.5)``.
    progress
        Called occasionally in a long motion with the time reached, s. With ``jacobian`` the
        derivatives are computed after the motion, and the times begin again at 0.
    options
        All of duration, gravity, rtol, topple_tilt, max_steps, flat and flat_gap together; any of
        these keywords that is given as well takes the place of theirs.
    jacobian
        Whether to compute derivatives, too: see :meth:`Motion.jacobian`. They take about thirty
        times as long under ``NoSlip`` and ``Frictionless``, and longer under other laws.

    Returns
    -------
    Motion
        A valid start never raises an error: the status of the motion says how it ended. A start
        with yaw_rate = spin_rate = 0 falls exactly face down and ends there.

    Notes
    -----
    Near-collisions are computed down to a tilt of 1e-16 rad; below it a motion ends as
    ``face_down``. With a resistance it ends below 1e-9 rad, but only if the resistance has stopped
    the contact point on the rim for good. The criterion: the resistance would slow down a contact
    point that is fast enough to raise the body again a hundred times as strongly as the falling
    tilt accelerates it. A weaker resistance ends no motion, and as it vanishes the motion becomes
    that without it. On a table at rest and with ``flat="stop"``, such an ending is ``at_rest`` if
    at most 1 % of the energy at the start is left, which the last slap takes; the message says how
    much. On a table that moves, the criterion holds below 1e-7 rad, and all resistances fade out
    below 1e-8 rad. With friction or a resistance, a
    motion is also ``at_rest`` when 1e-10 of its energy is left.

    Raises
    ------
    RimrollError
        A number outside its bounds, or a start of arrays; derivatives of a motion whose base comes
        down flat with ``smooth`` under friction or resistance, or from below ``flat_gap``, or that
        passes through upright in flight.
    """
    if not isinstance(body, PolygonalBody):
        one_body(body)
    expect("start", start, State)
    one_law(law)
    chosen = Options().changed(options, duration, keywords)
    if isinstance(body, PolygonalBody):
        from rimroll.motion.polygons import follow as follow_corners

        if ground is not None or chosen.flat not in (None, "stop") or chosen.flat_gap or jacobian:
            raise RimrollError(
                "a body with corners takes no ground, flat, flat_gap or jacobian: its table is"
                " level and at rest. rimroll.Body, with a round rim, takes them"
            )
        callback("progress", progress)
        bounce = number("restitution", restitution)
        return follow_corners(body, single(start), law, chosen, bounce, progress)
    if restitution != 0.0:
        raise RimrollError(
            "the restitution of a round body belongs to its law: Coulomb(0.3, restitution=0.5)"
        )
    moving = ground_given(ground)
    callback("progress", progress)
    return follow(body, single(start), law, chosen, bool(jacobian), progress, moving)
