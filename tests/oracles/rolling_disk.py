"""The rolling disk in hypergeometric functions: an oracle for quadrature without slip where H = 0.

With the tilt as clock, kappa = mR2/(C + mR2) and l = psi_dot sin2 phi, the spin s about the axis
obeys

    ds/dphi = kappa l / sin phi,   dl/dphi = (C/A) s sin phi,

so that s is a Legendre function of cos phi: s'' + cot(phi) s' + nu (nu + 1) s = 0 with
nu (nu + 1) = -kappa C/A. Source: P. Appell, Rend. Circ. Mat. Palermo 14 (1900), and D. J.
Korteweg in the same volume; R. Cushman & J. J. Duistermaat, Regul. Chaotic Dyn. 11 (2006). The
energy then gives phi_dot, and the turn is an integral over the tilt.

A `body` has mass, radius, transverse_inertia, axial_inertia (kg, m, kg m2, kg m2).
"""

from mpmath import mp


class Disk:
    """l and s of a disk let go at a tilt maximum, and how fast it tilts then."""

    def __init__(self, body, start, gravity):
        self.m, self.R, self.A, self.C = (
            mp.mpf(getattr(body, name))
            for name in ("mass", "radius", "transverse_inertia", "axial_inertia")
        )
        self.kappa = self.m * self.R**2 / (self.C + self.m * self.R**2)
        self.nu = -mp.mpf(1) / 2 + mp.sqrt(mp.mpf(1) / 4 - self.kappa * self.C / self.A)
        self.weight = 2 * self.m * mp.mpf(gravity) * self.R
        self.tilt, yaw_rate, spin_rate = (
            mp.mpf(getattr(start, name)) for name in ("tilt", "yaw_rate", "spin_rate")
        )
        l, s = yaw_rate * mp.sin(self.tilt) ** 2, spin_rate + yaw_rate * mp.cos(self.tilt)
        regular, other = self.solutions(self.tilt)
        self.parts = mp.lu_solve(mp.matrix([regular, other]).T, mp.matrix([l, s]))
        self.doubled_energy = self._aside(self.tilt)

    @property
    def J(self):
        """A + mR2."""
        return self.A + self.m * self.R**2

    def solutions(self, tilt):
        """(l, s) that is regular at phi = 0, where s = 1, and that which is so at phi = pi."""

        def legendre(z, slope):
            a, b = -self.nu, self.nu + 1
            s = mp.re(mp.hyp2f1(a, b, 1, z))
            ds = slope * mp.re(a * b * mp.hyp2f1(a + 1, b + 1, 2, z))
            return mp.sin(tilt) * ds / self.kappa, s

        half = mp.sin(tilt) / 2  # the derivative of sin2(phi/2)
        return legendre(mp.sin(tilt / 2) ** 2, half), legendre(mp.cos(tilt / 2) ** 2, -half)

    def turning(self, tilt):
        """l and s at a tilt."""
        (l, s), (other_l, other_s) = self.solutions(tilt)
        a, b = self.parts
        return a * l + b * other_l, a * s + b * other_s

    def _aside(self, tilt):
        """What of twice the energy is not that of tilting."""
        l, s = self.turning(tilt)
        yawing = self.A * (l / mp.sin(tilt)) ** 2
        return yawing + (self.C + self.m * self.R**2) * s**2 + self.weight * mp.sin(tilt)

    def tilting(self, tilt):
        """phi_dot squared at a tilt; negative where the disk does not come."""
        return (self.doubled_energy - self._aside(tilt)) / self.J

    def lowest(self):
        """The smallest tilt of a disk that falls from the start."""
        high = self.tilt * 2 / 3
        while self.tilting(low := high * 2 / 3) > 0:
            high = low
        tolerance = (mp.mpf(10) ** 5 * mp.eps * self.doubled_energy / self.J) ** 2
        return mp.findroot(self.tilting, (low, high), solver="anderson", tol=tolerance)


def turn(body, start, gravity, points=32, digits=25):
    """The first turn, rad, of a disk let go with no tilt rate, and its smallest tilt.

    The start is the tilt maximum, so down and up are the same. The tilt is clock by
    u = ln tan(phi/2), du = dphi/sin phi, between whose ends u0 and u1 an angle runs,
    u = (u0 + u1)/2 - (u1 - u0)/2 cos(angle): the roots at both ends cancel, and what is summed over
    points evenly apart is periodic.
    """
    with mp.workdps(digits):
        disk = Disk(body, start, gravity)
        least = disk.lowest()
        low, high = (mp.log(mp.tan(tilt / 2)) for tilt in (least, disk.tilt))

        def yawing(angle):
            tilt = 2 * mp.atan(mp.exp((low + high) / 2 - (high - low) / 2 * mp.cos(angle)))
            l, _ = disk.turning(tilt)
            return l / mp.sin(tilt) * mp.sin(angle) / mp.sqrt(disk.tilting(tilt))

        total = mp.fsum(yawing(mp.pi * (k + mp.mpf(1) / 2) / points) for k in range(points))
        return mp.pi / points * (high - low) * total, least
