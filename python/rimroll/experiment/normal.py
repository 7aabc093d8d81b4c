"""The normal distribution: its quantiles for arrays, without SciPy, which is slow to import.

Quantiles are Wichura's rational functions (algorithm AS 241, Applied Statistics 37, 1988), right to
about 1e-16 of their value.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Coefficients = tuple[float, ...]

# Numerators and denominators from the highest power down: of q² for |q| = |p − 1/2| up to 0.425,
# and of r = √(−log p) up to 5 and beyond, each counted from the middle of its stretch.
_MIDDLE: tuple[Coefficients, Coefficients] = (
    (
        2.5090809287301226727e3,
        3.3430575583588128105e4,
        6.7265770927008700853e4,
        4.5921953931549871457e4,
        1.3731693765509461125e4,
        1.9715909503065514427e3,
        1.3314166789178437745e2,
        3.3871328727963666080,
    ),
    (
        5.2264952788528545610e3,
        2.8729085735721942674e4,
        3.9307895800092710610e4,
        2.1213794301586595867e4,
        5.3941960214247511077e3,
        6.8718700749205790830e2,
        4.2313330701600911252e1,
        1.0,
    ),
)
_TAIL: tuple[Coefficients, Coefficients] = (
    (
        7.74545014278341407640e-4,
        2.27238449892691845833e-2,
        2.41780725177450611770e-1,
        1.27045825245236838258,
        3.64784832476320460504,
        5.76949722146069140550,
        4.63033784615654529590,
        1.42343711074968357734,
    ),
    (
        1.05075007164441684324e-9,
        5.47593808499534494600e-4,
        1.51986665636164571966e-2,
        1.48103976427480074590e-1,
        6.89767334985100004550e-1,
        1.67638483018380384940,
        2.05319162663775882187,
        1.0,
    ),
)
_FAR_TAIL: tuple[Coefficients, Coefficients] = (
    (
        2.01033439929228813265e-7,
        2.71155556874348757815e-5,
        1.24266094738807843860e-3,
        2.65321895265761230930e-2,
        2.96560571828504891230e-1,
        1.78482653991729133580,
        5.46378491116411436990,
        6.65790464350110377720,
    ),
    (
        2.04426310338993978564e-15,
        1.42151175831644588870e-7,
        1.84631831751005468180e-5,
        7.86869131145613259100e-4,
        1.48753612908506148525e-2,
        1.36929880922735805310e-1,
        5.99832206555887937690e-1,
        1.0,
    ),
)


def quantiles(chances: Array) -> Array:
    """The numbers below which a standard normal number lies with chances inside (0, 1)."""
    offset = chances - 0.5
    found = offset * _ratio(_MIDDLE, 0.180625 - offset * offset)
    outside = np.abs(offset) > 0.425
    if outside.any():
        below = chances[outside]
        root = np.sqrt(-np.log(np.minimum(below, 1.0 - below)))
        size = np.where(root <= 5.0, _ratio(_TAIL, root - 1.6), _ratio(_FAR_TAIL, root - 5.0))
        found[outside] = np.copysign(size, offset[outside])
    return np.asarray(found)


def chance_below(x: float) -> float:
    """The chance of a standard normal number below x."""
    return 0.5 * math.erfc(-x / math.sqrt(2.0))


def density(x: Array) -> Array:
    """The probability density of a standard normal number at x."""
    return np.asarray(np.exp(-0.5 * x * x) / math.sqrt(2.0 * math.pi))


def _ratio(coefficients: tuple[Coefficients, Coefficients], x: Array) -> Array:
    above, below = (_polynomial(some, x) for some in coefficients)
    return np.asarray(above / below)


def _polynomial(coefficients: Coefficients, x: Array) -> Array:
    value = np.full_like(x, coefficients[0])
    for coefficient in coefficients[1:]:
        value *= x
        value += coefficient
    return value
