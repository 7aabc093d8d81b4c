"""Dry friction over the slip speed, as a table or a function."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np

from rimroll import _core
from rimroll.errors import RimrollError, hold
from rimroll.given import Number, Values, number
from rimroll.given import numbers as array
from rimroll.laws.law import Law
from rimroll.laws.parameters import Parameter, listed
from rimroll.laws.resistances import Resistances
from rimroll.laws.shared import RESTITUTION, STATIC
from rimroll.sampled_curve import sampled


@dataclass(frozen=True, repr=False, eq=False)
class Tabulated(Law):
    """Dry friction whose coefficient is a curve μ(u) of the slip speed u: T = −μ(u) N u/|u|.

    The curve goes through the points (``speeds`` in m/s, ``frictions``). Between them it is the
    monotone piecewise cubic of Fritsch & Butland (SIAM J. Sci. Stat. Comput. 5, 1984; SciPy's
    ``PchipInterpolator``), which has a continuous slope and overshoots no point; below the first
    speed and beyond the last it is constant. A curve may fall and rise.

    Everything else is as under :class:`Coulomb`: exact phases of rolling, sliding and flight,
    without regularisation. The rim rolls while |T| ≤ ``static`` · N; ``static`` is by default the
    friction at the lowest speed, and must not be smaller. In a landing, the coefficient is that of
    the slip speed with which the rim comes down, throughout the impulse.

    >>> import rimroll as rr
    >>> law = rr.Tabulated(speeds=[0.0, 0.05, 0.2], frictions=[0.3, 0.22, 0.2], static=0.35)
    >>> law.friction_at(0.05)
    0.22

    Raises ``RimrollError`` for fewer than two points, speeds that do not rise from 0 or more,
    frictions outside 0 to 1e6.
    """

    name: ClassVar[str] = "tabulated"
    color: ClassVar[str] = "#882255"
    marker: ClassVar[str] = "P"
    can_stick: ClassVar[bool] = True

    speeds: Sequence[float] = Parameter("m/s", is_list=True).field()
    frictions: Sequence[float] = Parameter(is_list=True).field()
    static: float | None = STATIC.field(None)
    restitution: float = RESTITUTION.field(0.0)

    if TYPE_CHECKING:

        def __init__(
            self,
            speeds: Values,
            frictions: Values,
            static: Values | None = None,
            restitution: Values = 0.0,
            *,
            resistances: Resistances = (),
        ) -> None: ...

    def friction_at(self, speeds: Values) -> Any:
        """μ at slip speeds (m/s, >= 0): a number, or an array of their shape."""
        given = array("speeds", speeds, "m/s")
        hold("speeds", given, given >= 0.0, ">= 0", "m/s")
        values = _core.friction_at(self, np.ascontiguousarray(given).ravel())
        return values.reshape(given.shape) if given.ndim else float(values[0])

    @classmethod
    def from_function(
        cls,
        mu: Callable[[float], float],
        speeds: Values,
        *,
        tolerance: Number = 1e-6,
        static: Number | None = None,
        restitution: Number = 0.0,
    ) -> Tabulated:
        """A table of the function μ(u), which is called with one slip speed (m/s) at a time.

        Raises ``RimrollError`` if ``mu`` returns anything but a number from 0 to 1e6, is not
        continuous, or needs more than ten thousand points.

        Parameters
        ----------
        mu
            The coefficient of friction: a continuous function.
        speeds
            The initial speeds, m/s, at least two: from the lowest to the one beyond which the
            friction is taken as constant.
        tolerance
            Largest difference between the curve and ``mu``. Intervals are halved where the
            difference is larger at a quarter, half or three quarters of the interval, or at one of
            64 places between each two of ``speeds``. A feature of ``mu`` that is narrower than 1/46
            of the interval between two ``speeds`` can be missed: give speeds around it.
        static, restitution
            As for :class:`Tabulated`.

        Examples
        --------
        >>> import math
        >>> import rimroll as rr
        >>> fading = rr.Tabulated.from_function(
        ...     lambda u: 0.2 + 0.1 * math.exp(-u / 0.05), speeds=[0.0, 1.0]
        ... )
        >>> round(fading.friction_at(0.05), 5)
        0.23679
        """
        if not callable(mu):
            raise RimrollError(field="mu", value=mu, bound="a function of the slip speed")
        tolerance = number("tolerance", tolerance)
        if not tolerance > 0.0:
            raise RimrollError(field="tolerance", value=tolerance, bound="> 0")
        begin = listed("speeds", speeds, "m/s")
        # Raises errors about the speeds before the function is called.
        cls(begin, [0.0] * len(begin))
        points = sampled(mu, begin, lambda u, mus: cls(u, mus).friction_at, tolerance)
        sticking = None if static is None else number("static", static)
        return cls(*points, sticking, number("restitution", restitution))
