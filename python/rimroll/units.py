"""Quantities with units, as people write them: ``30 deg``, ``5.1cm``, ``-30deg/s``.

Inside there are only SI units and radians; this is the edge where others are turned into them.
"""

from __future__ import annotations

import math
import re
from decimal import Decimal
from functools import cache
from typing import TYPE_CHECKING, Any

from rimroll._core import STANDARD_GRAVITY
from rimroll.errors import UnitError

if TYPE_CHECKING:
    from pint import UnitRegistry

KINDS = {
    "rad": ("an angle", "30 deg"),
    "rad/s": ("an angular rate", "-30 deg/s"),
    "m": ("a length", "5.1 cm"),
    "kg": ("a mass", "70 g"),
    "kg m^2": ("a moment of inertia", "359 kg mm^2"),
    "kg/m^3": ("a density", "1000 kg/m^3"),
    "s": ("a time", "2 s"),
    "m/s": ("a speed", "1 cm/s"),
    "m/s^2": ("an acceleration", "9.8 m/s^2"),
    "N s/m": ("a viscous resistance", "0.5 N s/m"),
    "Pa s": ("a viscosity", "1.8e-5 Pa s"),
    "1": ("a pure number", "0.5"),
}
"""The quantity of each SI unit in words, and an example."""

UNIT_OF = {
    "mass": "kg",
    "radius": "m",
    "inner_radius": "m",
    "outer_radius": "m",
    "height": "m",
    "length": "m",
    "depth": "m",
    "width": "m",
    "thickness": "m",
    "base": "m",
    "density": "kg/m^3",
    "transverse_inertia": "kg m^2",
    "axial_inertia": "kg m^2",
    "fill": "1",
}
"""The SI unit of each number that describes a body or a solid."""

START_UNIT_OF = {
    "tilt": "rad",
    "tilt_rate": "rad/s",
    "yaw": "rad",
    "yaw_rate": "rad/s",
    "spin": "rad",
    "spin_rate": "rad/s",
}
"""The SI unit of each number of a start."""

_EVERYDAY = {
    ("rad", "rad"): 1.0,
    ("deg", "rad"): math.pi / 180.0,
    ("rad/s", "rad/s"): 1.0,
    ("deg/s", "rad/s"): math.pi / 180.0,
    ("m", "m"): 1.0,
    ("cm", "m"): 0.01,
    ("mm", "m"): 0.001,
    ("kg", "kg"): 1.0,
    ("g", "kg"): 0.001,
    ("s", "s"): 1.0,
    ("ms", "s"): 0.001,
    ("m/s", "m/s"): 1.0,
    ("cm/s", "m/s"): 0.01,
    ("mm/s", "m/s"): 0.001,
    ("m/s^2", "m/s^2"): 1.0,
    ("cm/s^2", "m/s^2"): 0.01,
    ("N s/m", "N s/m"): 1.0,
    ("%", "1"): 0.01,
}
"""Factors without the registry, whose loading takes longer than most motions."""

SECONDS = {
    **dict.fromkeys(("s", "sec", "secs", "second", "seconds", "sekunden"), 1.0),
    **dict.fromkeys(("ms", "msec", "msecs", "millis", "milliseconds", "millisecond"), 1e-3),
    **dict.fromkeys(("us", "µs", "μs", "usec", "usecs", "micros", "microseconds"), 1e-6),
    **dict.fromkeys(("ns", "nsec", "nsecs", "nanos", "nanoseconds"), 1e-9),
    **dict.fromkeys(("min", "minutes"), 60.0),
}
"""Units of time as titles and people spell them, in s."""

_ACCELERATIONS = {"g": STANDARD_GRAVITY, "gal": 0.01}
"""Units that measure something else elsewhere: to the registry these are a gram and a gallon."""

_NUMBER = re.compile(r"([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)[\s*]*(.*)", re.DOTALL)
_NOT_FINITE = re.compile(r"[+-]?(nan|inf|infinity)\b", re.IGNORECASE)
_TOWER = re.compile(r"\d\s*(\*\*|\^)|\d\d")  # of powers, which a parser could climb for ever
_BARE_POWER = re.compile(r"\b(mm|cm|m|s)(-?[1-9])\b")
_PLUS_MINUS = re.compile(r"±|\+\s*/?\s*[-−]")
_IN_BRACKETS = re.compile(r"\s*\(([^()]*)\)\s*(.*)", re.DOTALL)
_LAST_DIGITS = re.compile(r"\s*([+-]?\d+\.?\d*)\((\d+)\)(.*)", re.DOTALL)


def tilt_angle(value: object, name: str) -> float:
    """A tilt, rad, with a hint for users who meant degrees and wrote a plain number.

    Raises ``UnitError`` as :func:`quantity` does, and for a plain number too large for radians.
    """
    angle = quantity(value, "rad", name)
    if abs(angle) >= math.pi:
        if _has_unit(value):
            raise UnitError(f"must be between -180 and 180 deg, got {value}", name, value)
        raise UnitError(
            f"{name}: {value} is read as radians, and a tilt is less than pi; "
            f"for degrees write {str(value).strip()}deg"
        )
    return angle


_LARGE = {
    "kg": (5.0, ("g", "kg")),
    "m": (1.0, ("mm", "cm", "m")),
    "kg m^2": (1.0, ("kg mm^2", "kg m^2")),
}
"""Above what a plain number is no body on a table, and the units that may have been meant."""


def size_of_body(value: object, unit: str, name: str) -> float:
    """A number of a body in its SI unit, with a hint for users who forgot the unit.

    Raises ``UnitError`` as :func:`quantity` does, and for a plain number that would make the body
    too large for a table.
    """
    size = quantity(value, unit, name)
    bound, units = _LARGE.get(unit, (math.inf, ()))
    if size > bound and not _has_unit(value):
        written = str(value).strip()
        choices = " or ".join(f'"{written} {one}"' for one in units)
        raise UnitError(
            f"{name}: {written} is read as {size:g} {unit}; with its unit write {choices}"
        )
    return size


def _has_unit(value: object) -> bool:
    number = _NUMBER.fullmatch(value.strip().replace("−", "-")) if isinstance(value, str) else None
    return number is not None and bool(number[2])


def in_degrees_hint(angle: float) -> str:
    """What to add to the refusal of an angle (rad) that may have been meant in degrees."""
    return f': for degrees write np.radians({angle:g}) or "{angle:g} deg"'


def air_unit(exponent: float) -> str:
    """The SI unit of the coefficient of air drag of an exponent."""
    return f"W (s/rad)^{exponent:g}"


def quantity(value: object, unit: str, name: str = "the value") -> float:
    """A quantity in its SI unit, one of :data:`KINDS` or an :func:`air_unit`.

    ``value`` is a number, taken to be in that unit already, or a text with or without a unit;
    ``name`` is what the message calls it. An angle needs an angle's unit: hertz is no angular rate.

    >>> quantity("6.9 cm", "m")
    0.069

    Raises ``UnitError`` for anything else, and for numbers that are not finite.
    """
    if isinstance(value, int | float) and not isinstance(value, bool):
        number, factor = float(value), 1.0
    elif isinstance(value, str):
        number, factor = _read(value, unit, name)
    else:
        raise _refusal(name, unit, value, "neither a number nor a text")
    if not math.isfinite(number):
        raise _refusal(name, unit, value, "not a finite number")
    # Exact decimals, so that 6.9 cm is the same double as 0.069.
    result = float(Decimal(repr(number)) * Decimal(repr(factor)))
    if not math.isfinite(result):
        raise _refusal(name, unit, value, "too large")
    return result


def reading(value: object, unit: str, name: str = "the value") -> tuple[float, float]:
    """A measured quantity: its value and standard uncertainty, in its SI unit.

    Texts may carry the uncertainty, as in ``70 ± 1 g``, ``70 +- 1 g``, ``6.9 cm ± 2%`` or
    ``6.9(1) cm``, where 1 is of the last digit; in others it is half a unit of the last digit
    written. Numbers are exact.

    >>> reading("6.9(1) cm", "m")
    (0.069, 0.001)
    >>> reading("6.9 cm", "m")
    (0.069, 0.0005)

    Raises ``UnitError`` as :func:`quantity` does, and for an uncertainty below zero.
    """
    if not isinstance(value, str):
        return quantity(value, unit, name), 0.0
    if last := _LAST_DIGITS.fullmatch(value):
        digits, uncertain, given = last.groups()
        step = Decimal(int(uncertain)).scaleb(_last_place(digits))
        return quantity(digits + given, unit, name), quantity(f"{step}{given}", unit, name)
    if not has_uncertainty(value):
        number = quantity(value, unit, name)
        digits, given = _NUMBER.fullmatch(value.strip().replace("−", "-")).groups()  # type: ignore[union-attr]
        half = Decimal(5).scaleb(_last_place(digits) - 1)
        return number, quantity(f"{half}{given}", unit, name)
    return _with_uncertainty(value, unit, name)


def has_uncertainty(value: object) -> bool:
    """Whether a text states its uncertainty."""
    return isinstance(value, str) and bool(_PLUS_MINUS.search(value) or _LAST_DIGITS.match(value))


def _with_uncertainty(text: str, unit: str, name: str) -> tuple[float, float]:
    """Reads ``70 ± 1 g``, ``(70 ± 1) g``, ``70 g ± 1 g`` and ``70 g ± 2%``."""
    inside = _IN_BRACKETS.fullmatch(text)
    both, given = inside.groups() if inside else (text, "")
    left, right = (part.strip() for part in _PLUS_MINUS.split(both, maxsplit=1))
    number, more = _NUMBER.fullmatch(left), _NUMBER.fullmatch(right)
    if number is None or more is None:
        raise _refusal(name, unit, text, 'it does not read as in "70 ± 1 g"')
    if more[2].strip() == "%" and unit != "1":
        value = quantity(left + given, unit, name)
        uncertainty = abs(value) * quantity(right, "1", name)
    else:
        theirs = number[2] or given or more[2]
        value = quantity(number[1] + theirs, unit, name)
        uncertainty = quantity(more[1] + (more[2] or theirs), unit, name)
    if uncertainty < 0.0:
        raise _refusal(name, unit, text, "its uncertainty is below zero")
    return value, uncertainty


def _last_place(digits: str) -> int:
    """The power of ten of the last digit of a number as it is written."""
    exponent = Decimal(digits).as_tuple().exponent
    assert isinstance(exponent, int)
    return exponent


def _read(text: str, unit: str, name: str) -> tuple[float, float]:
    """The number in a text and the factor of its unit."""
    plain = text.strip().replace("−", "-")
    if not plain:
        raise _refusal(name, unit, text, "an empty text")
    if _NOT_FINITE.match(plain):
        raise _refusal(name, unit, text, "not a finite number")
    parts = _NUMBER.fullmatch(plain)
    if parts is None:
        raise _refusal(name, unit, text, "it does not begin with a number")
    number, given = parts.groups()
    if given.startswith(","):
        raise _refusal(name, unit, text, "decimals follow a point, not a comma")
    return float(number), factor_of(given, unit, name, text) if given else 1.0


def factor_of(given: str, unit: str, name: str, value: object) -> float:
    """The factor from a ``given`` unit to the SI unit; the message quotes ``value``."""
    given = _BARE_POWER.sub(r"\1^\2", given.replace("²", "^2").replace("³", "^3").strip())
    everyday = _EVERYDAY.get((given.replace("°", "deg"), unit))
    if unit == "m/s^2":
        everyday = _ACCELERATIONS.get(given, everyday)
    if everyday is not None:
        return everyday
    units = registry()
    if _TOWER.search(given):
        raise _refusal(name, unit, value, f'"{given}" is no unit')
    try:
        ours = units.parse_units(given)
    except AttributeError as error:  # pint's UndefinedUnitError
        unknown = getattr(error, "unit_names", given)
        first = unknown if isinstance(unknown, str) else next(iter(unknown))
        raise _refusal(name, unit, value, f'unknown unit "{first}"') from None
    except Exception:  # pint's parser raises many kinds of error
        raise _refusal(name, unit, value, f'"{given}" is no unit') from None
    theirs = units.parse_units("dimensionless" if unit == "1" else unit.replace(" ", "*"))
    # Root units keep radians apart from pure numbers, as a comparison of dimensions does not.
    scale: Any
    scale_si: Any
    scale, root = units.get_root_units(ours)
    scale_si, root_si = units.get_root_units(theirs)
    if root != root_si:
        raise mismatch(name, unit, value, given)
    return tidy(float(scale) / float(scale_si))


def tidy(factor: float) -> float:
    """A factor without rounding errors: 1e-06 for 9.999999999999999e-07."""
    return float(f"{factor:.15g}") if math.isclose(factor, float(f"{factor:.6g}")) else factor


def mismatch(name: str, unit: str, value: object, given: str) -> UnitError:
    """The error for a value whose unit, ``given``, is of another kind."""
    return _refusal(name, unit, value, f'"{given}" does not measure {_kind(unit)[0]}')


def _kind(unit: str) -> tuple[str, str]:
    return KINDS.get(unit) or ("a coefficient of air drag", f"1e-9 {unit}")


def _refusal(name: str, unit: str, value: object, why: str) -> UnitError:
    kind, example = _kind(unit)
    plain = "" if unit == "1" else f" (plain numbers are in {unit})"
    got = f'"{value}"' if isinstance(value, str) else repr(value)
    bound = f'{kind} such as "{example}"{plain}'
    got = why if isinstance(value, str) and not value.strip() else f"{got}: {why}"
    error = UnitError(f"must be {bound}, got {got}", name, value, bound)
    error.why = why
    return error


@cache
def registry() -> UnitRegistry[Any]:
    """The registry of units, loaded when first needed."""
    from pint import UnitRegistry

    units: UnitRegistry[Any] = UnitRegistry()
    units.define("@alias turn = rev")
    return units
