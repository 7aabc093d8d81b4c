"""The equations of motion of the paper's can, for any solver's number type.

Each returns the rates of an autonomous system as a tuple; ``sin`` and ``cos`` are those of the
solver's own numbers. Constants are per unit of mass, those of `rimroll.bodies.can_2007`.
"""

R, H, A, C, G = 0.051, 0.069, 5.13e-3, 2.0e-3, 9.8
K = A + H * H
J = K + R * R
D = C * K + R * R * A

YAW = 0
TILT_RATE = {"regular": 3, "printed": 4}
"""Index of the tilt rate in the state; the yaw comes first in both."""


def rates(coordinates, law, sin, cos):
    """The function of the state's components that gives their rates."""
    if coordinates == "regular":
        return {"no_slip": regular_no_slip, "frictionless": regular_frictionless}[law]
    printed = {"no_slip": printed_no_slip, "frictionless": printed_frictionless}[law]
    return printed(sin, cos)


def begin(coordinates, start, sin, cos):
    """The state at the release from (tilt, tilt rate, yaw rate, spin rate); numbers or arrays."""
    tilt, tilt_rate, yaw_rate, spin_rate = start
    zero = 0.0 * tilt
    if coordinates == "printed":
        return zero, tilt, zero, yaw_rate, tilt_rate, spin_rate
    s = spin_rate + yaw_rate * cos(tilt)
    return zero, sin(tilt), cos(tilt), tilt_rate, yaw_rate * sin(tilt), s, zero


# (ψ, sin φ, cos φ, p = φ̇, w = ψ̇ sin φ, s = θ̇ + ψ̇ cos φ, t) over τ, dt = sin φ dτ


def regular_no_slip(yaw, sin, cos, p, w, s, t):
    through_collision = cos * w * (K / J * w - H * R / J * s)
    falling = G * R / J * cos - G * H / J * sin
    elsewhere = w * (H * R / J * w - (C + R * R) / J * s) - falling
    return (
        w,
        sin * cos * p,
        -sin * sin * p,
        through_collision + sin * elsewhere,
        p * (sin * (C * (C + R * R) / D * s - C * H * R / D * w) - w * cos),
        sin * p * (R * R * A / D * w + C * H * R / D * s),
        sin,
    )


def regular_frictionless(yaw, sin, cos, p, w, s, t):
    rho = R * cos - H * sin
    z = R * sin + H * cos
    elsewhere = rho * (z * p * p - G) - C * w * s
    return (
        w,
        sin * cos * p,
        -sin * sin * p,
        (A * w * w * cos + sin * elsewhere) / (A + rho * rho),
        p * (sin * (C / A) * s - w * cos),
        0.0 * s,
        sin,
    )


# (ψ, φ, θ, ψ̇, φ̇, θ̇) over t: the printed Q q̈ = S, solved by Cramer's rule


def printed_no_slip(sine, cosine):
    """Eq. (noslip_eqs)."""

    def rates(yaw, tilt, spin, psi, phi, theta):
        sin, cos = sine(tilt), cosine(tilt)
        q11, q13 = (A + H * H) * sin - H * R * cos, -H * R
        q31, q33 = (C + R * R) * cos - R * H * sin, C + R * R
        s1 = (
            (C - 2.0 * A - 2.0 * H * H) * psi * phi * cos
            + C * phi * theta
            - 2.0 * H * R * psi * phi * sin
        )
        s2 = (
            (C - A + R * R - H * H) * psi * psi * sin * cos
            + (C + R * R) * theta * psi * sin
            + H * R * psi * theta * cos
            + H * R * psi * psi * (cos * cos - sin * sin)
            + G * (R * cos - H * sin)
        )
        s3 = C * psi * phi * sin + 2.0 * R * psi * phi * (R * sin + H * cos)
        determinant = q11 * q33 - q13 * q31
        return (
            psi,
            phi,
            theta,
            (s1 * q33 - q13 * s3) / determinant,
            -s2 / (R * R + H * H + A),
            (q11 * s3 - s1 * q31) / determinant,
        )

    return rates


def printed_frictionless(sine, cosine):
    """Eq. (nofric_eqs)."""

    def rates(yaw, tilt, spin, psi, phi, theta):
        sin, cos = sine(tilt), cosine(tilt)
        q22 = -A + 2.0 * H * R * sin * cos - H * H * sin * sin - R * R * cos * cos
        s1 = -2.0 * A * psi * phi * cos + C * phi * theta + C * phi * psi * cos
        s2 = (
            (C - A) * psi * psi * sin * cos
            + C * theta * psi * sin
            + G * R * cos
            - G * H * sin
            - H * R * phi * phi * (cos * cos - sin * sin)
            + (H * H - R * R) * phi * phi * sin * cos
        )
        psi_dot = s1 / (A * sin)
        return psi, phi, theta, psi_dot, s2 / q22, psi * phi * sin - psi_dot * cos

    return rates
