"""Turns to 30 digits and more, by Taylor series in multiprecision: an oracle for the quadratures.

The equations of motion are stepped, not integrated over the tilt, from the paper's `noslip_eqs` and
`nofric_eqs` in the coordinates

    sin phi, cos phi, p = phi_dot, w = psi_dot sin phi, s = theta_dot + psi_dot cos phi, psi, t

by the clock tau, dt = sin phi dtau, in which they are polynomials or, without friction, quotients
of them, and stay bounded however flat the body comes down. test_exact_oracles.py holds them
against the print.

A `body` has mass, radius, height, transverse_inertia, axial_inertia (kg, m, m, kg m2, kg m2); a
`start` has tilt, tilt_rate, yaw_rate, spin_rate (rad, rad/s), taken for the exact numbers that
they are. A `law` is "no_slip" or "frictionless".
"""

from dataclasses import dataclass

from mpmath import mp

DIGITS = 65
"""Digits of the computation unless given; the last 15 or so are lost on the way."""

LOOKS = 8
"""In each step, for the normal force."""


class LeftTheTable(ArithmeticError):
    """The rim would have to be pulled down."""


@dataclass(frozen=True)
class ExactTurn:
    """A first turn; rad, and s from the release.

    `outcome` is as rimroll's: "rocked", "toppled" or, of a body that falls over without coming down
    and has no turn, "fell_back".
    """

    outcome: str
    turn: mp.mpf = mp.nan
    min_tilt: mp.mpf = mp.nan
    end_tilt: mp.mpf = mp.nan
    min_tilt_time: mp.mpf = mp.nan
    end_time: mp.mpf = mp.nan


class Series:
    """The beginning of a power series in tau; coefficients may be appended later."""

    def __init__(self, first=()):
        self.terms = list(first)

    def __getitem__(self, k):
        return self.terms[k]

    def at(self, tau):
        return mp.polyval(self.terms[::-1], tau)

    def slope(self, tau):
        return mp.polyval([k * c for k, c in enumerate(self.terms)][:0:-1], tau)


def times(a, b, k):
    """The k-th coefficient of a product."""
    return mp.fdot(a.terms[: k + 1], b.terms[k::-1])


def over(a, b, quotient, k):
    """The k-th coefficient of a / b, whose earlier ones are known."""
    return (a[k] - mp.fdot(quotient.terms[:k], b.terms[k:0:-1])) / b[0]


def symbols(body):
    """The body's numbers as multiprecision ones."""
    names = ("mass", "radius", "height", "transverse_inertia", "axial_inertia")
    return tuple(mp.mpf(getattr(body, name)) for name in names)


class NoSlip:
    """`noslip_eqs`: K = A + mH2, J = K + mR2, D = CK + AmR2.

    w' = sin p (C/D) [(C + mR2) s - mHR w] - w p cos
    s' = sin p (mR/D) [HC s + AR w]
    J p' = w cos (K w - mHR s) - w sin [(C + mR2) s - mHR w] - mg sin (R cos - H sin)
    """

    def __init__(self, body, gravity):
        m, R, H, A, C = symbols(body)
        K = A + m * H**2
        D = C * K + A * m * R**2
        self.J, self.weight = K + m * R**2, (m * gravity * R, m * gravity * H)
        self.side = K, m * H * R, C + m * R**2
        self.turning = C * (C + m * R**2) / D, C * m * H * R / D
        self.spinning = m * R * H * C / D, m * R * R * A / D

    def rates(self, u, k):
        """The k-th coefficients of the rates of p, w and s."""
        K, bend, about = self.side
        straight, back = self.turning
        spin, roll = self.spinning
        upright, hanging = self.weight
        c = u.part
        c["w cos"].terms.append(times(u.w, u.cos, k))
        c["w sin"].terms.append(times(u.w, u.sin, k))
        c["K w - mHR s"].terms.append(K * u.w[k] - bend * u.s[k])
        c["(C + mR2) s - mHR w"].terms.append(about * u.s[k] - bend * u.w[k])
        c["weight"].terms.append(upright * u.cos[k] - hanging * u.sin[k])
        c["w gain"].terms.append(straight * u.s[k] - back * u.w[k])
        c["s gain"].terms.append(spin * u.s[k] + roll * u.w[k])
        tilting = (
            times(c["w cos"], c["K w - mHR s"], k)
            - times(c["w sin"], c["(C + mR2) s - mHR w"], k)
            - times(u.sin, c["weight"], k)
        )
        return (
            tilting / self.J,
            times(c["sin p"], c["w gain"], k) - times(u.p, c["w cos"], k),
            times(c["sin p"], c["s gain"], k),
        )


class Frictionless:
    """`nofric_eqs`: rho = R cos - H sin, z = R sin + H cos.

    w' = (C/A) sin p s - w p cos
    s' = 0
    (A + m rho2) p' = A w2 cos - C s w sin - m rho sin (g - z p2)
    """

    def __init__(self, body, gravity):
        m, R, H, A, C = symbols(body)
        self.mass, self.gravity, self.size, self.inertia = m, mp.mpf(gravity), (R, H), (A, C)

    def rates(self, u, k):
        """The k-th coefficients of the rates of p, w and s."""
        m, g, (R, H), (A, C) = self.mass, self.gravity, self.size, self.inertia
        c = u.part
        c["w cos"].terms.append(times(u.w, u.cos, k))
        c["A w cos - C s sin"].terms.append(A * c["w cos"][k] - C * u.s[0] * u.sin[k])
        c["rho"].terms.append(R * u.cos[k] - H * u.sin[k])
        c["z"].terms.append(R * u.sin[k] + H * u.cos[k])
        c["p2"].terms.append(times(u.p, u.p, k))
        c["pressing"].terms.append((g if k == 0 else 0) - times(c["z"], c["p2"], k))
        c["rho sin"].terms.append(times(c["rho"], u.sin, k))
        c["inertia"].terms.append((A if k == 0 else 0) + m * times(c["rho"], c["rho"], k))
        c["moment"].terms.append(
            times(u.w, c["A w cos - C s sin"], k) - m * times(c["rho sin"], c["pressing"], k)
        )
        c["tilting"].terms.append(over(c["moment"], c["inertia"], c["tilting"], k))
        return (
            c["tilting"][k],
            (C / A) * u.s[0] * c["sin p"][k] - times(u.p, c["w cos"], k),
            mp.zero,
        )


LAWS = {"no_slip": NoSlip, "frictionless": Frictionless}


class Parts(dict):
    """Series that are computed when first used."""

    def __missing__(self, name):
        self[name] = Series()
        return self[name]


class Step:
    """The coordinates as power series in tau about an instant, with about a term a digit.

    A step is as long as its last terms stay below `negligible` of what they are added to.
    """

    COORDINATES = ("sin", "cos", "p", "w", "s", "psi", "t")

    def __init__(self, law, numbers):
        for name, number in zip(self.COORDINATES, numbers, strict=True):
            setattr(self, name, Series([number]))
        self.part = Parts()
        self.order, self.negligible = mp.dps - 7, mp.mpf(10) ** (15 - mp.dps)
        for k in range(self.order):
            self.part["sin p"].terms.append(times(self.sin, self.p, k))
            sin_p = self.part["sin p"]
            p, w, s = law.rates(self, k)
            rates = (
                times(sin_p, self.cos, k),
                -times(sin_p, self.sin, k),
                p,
                w,
                s,
                self.w[k],
                self.sin[k],
            )
            for name, rate in zip(self.COORDINATES, rates, strict=True):
                getattr(self, name).terms.append(rate / (k + 1))

    def length(self, rate):
        """How far the series reach; `rate` is the size of the body's own rates, rad/s."""
        rate = mp.sqrt(rate**2 + self.p[0] ** 2 + self.w[0] ** 2 + self.s[0] ** 2)
        sizes = (1, 1, rate, rate, rate)
        named = list(zip(self.COORDINATES, sizes, strict=False))
        reach = []
        for k in (self.order - 1, self.order):
            last = max(abs(getattr(self, name)[k]) / size for name, size in named)
            if last:
                reach.append((self.negligible / last) ** (mp.one / k))
        return min(reach)

    def at(self, tau):
        return [getattr(self, name).at(tau) for name in self.COORDINATES]

    def extreme(self, end):
        """Where, up to the end, the tilt rate changes its sign; None if it does not.

        A release from rest is no change of sign.
        """
        before = self.p[0] or self.p[1]
        if before * self.p.at(end) > 0:
            return None
        tau = end * self.p[0] / (self.p[0] - self.p.at(end)) if self.p[0] else end
        for _ in range(100):
            change = self.p.at(tau) / self.p.slope(tau)
            tau -= change
            if abs(change) < 100 * self.negligible * end:
                return tau
        raise ArithmeticError("the extreme of the tilt was not found")

    def passing(self, tilt, end):
        """Where, up to the end, the tilt rises past a value; None if it is not so large there."""
        sin, cos = mp.sin(tilt), mp.cos(tilt)

        def beyond(tau):
            return self.sin.at(tau) * cos - self.cos.at(tau) * sin

        if beyond(end) <= 0:
            return None
        return mp.findroot(beyond, (0, end), solver="anderson", tol=self.negligible**2)

    def must_press(self, body, gravity, end):
        """Raise LeftTheTable where N/m = g + d2z/dt2 is negative."""
        _, R, H, _, _ = symbols(body)
        for look in range(LOOKS + 1):
            tau = end * look / LOOKS
            sin, cos, p = self.sin.at(tau), self.cos.at(tau), self.p.at(tau)
            rho, z = R * cos - H * sin, R * sin + H * cos
            if gravity + rho * self.p.slope(tau) / sin - z * p**2 < 0:
                raise LeftTheTable


def numbers_of(start):
    """The coordinates at a start."""
    tilt, tilt_rate, yaw_rate, spin_rate = (
        mp.mpf(getattr(start, name)) for name in ("tilt", "tilt_rate", "yaw_rate", "spin_rate")
    )
    sin, cos = mp.sin(tilt), mp.cos(tilt)
    return sin, cos, tilt_rate, yaw_rate * sin, spin_rate + yaw_rate * cos, mp.zero, mp.zero


def moments(body, law, start, gravity, topple_tilt):
    """The coordinates at each extreme of the tilt, to the topple tilt; and which it is."""
    law = LAWS[law](body, gravity)
    rate = mp.sqrt(mp.mpf(gravity) / mp.mpf(body.radius))
    numbers = numbers_of(start)
    while True:
        step = Step(law, numbers)
        end = step.length(rate)
        extreme = step.extreme(end)
        toppled = step.passing(topple_tilt, end if extreme is None else extreme)
        step.must_press(body, gravity, end if toppled is None else toppled)
        if toppled is not None:
            yield step.at(toppled), "topple"
            return
        if extreme is not None:
            yield step.at(extreme), "tilt_max" if (step.p[0] or step.p[1]) > 0 else "tilt_min"
            # Continue a little later, in order not to find the same event again.
            end = extreme + end / 8
        numbers = step.at(end)


def first_turn(body, law, start, gravity, topple_tilt=None, digits=DIGITS):
    """The first turn from the release or, if the tilt rises then, from the maximum after it.

    It ends at the first tilt maximum after the near-collision or, before that, at the topple tilt:
    the vertical unless given, where a disk, which falls on to its other face, has not toppled.
    Raises LeftTheTable.
    """
    with mp.workdps(digits):
        vertical = mp.pi / 2
        end = vertical if topple_tilt is None else mp.mpf(topple_tilt)
        found = moments(body, law, start, gravity, end)
        first, kind = next(found)
        if kind == "topple":
            return ExactTurn("fell_back")
        yaw = first[5] if kind == "tilt_max" else mp.zero
        lowest = next(found)[0] if kind == "tilt_max" else first
        highest, kind = next(found)
        rocked = kind == "tilt_max" or (topple_tilt is None and body.height == 0)
        sin, cos, *_, highest_yaw, time = highest
        return ExactTurn(
            outcome="rocked" if rocked else "toppled",
            turn=highest_yaw - yaw,
            min_tilt=mp.atan2(lowest[0], lowest[1]),
            end_tilt=mp.atan2(sin, cos),
            min_tilt_time=lowest[6],
            end_time=time,
        )
