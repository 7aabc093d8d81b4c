"""Quantities with units as people write them, such as 30 deg, converted to SI units and radians.

Inside there are only SI units and radians; this is the edge where others are turned into them.

One rule holds for every number of the Python interface that has a unit. It may be a plain number or
array in the SI unit; a text such as ``"30 deg"``, as in scenario files; a quantity of pint or of a
package with the same interface; or a data array with a ``units`` attribute. All of these are
converted. A unit of another kind raises an error; no unit is ignored. This module imports no unit
package: quantities convert themselves.
"""

from __future__ import annotations

import math
import operator
import re
from collections.abc import Callable, Mapping
from dataclasses import MISSING, dataclass, field, fields, replace
from decimal import Decimal
from fractions import Fraction
from functools import cache
from numbers import Real
from typing import TYPE_CHECKING, Any, Literal, Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rimroll._core import STANDARD_GRAVITY
from rimroll.errors import RimrollError, UnitError
from rimroll.many.grid import is_labelled

if TYPE_CHECKING:
    import xarray as xr
    from pint import UnitRegistry


KINDS = {
    "rad": ("an angle", "30 deg", "ANGLE"),
    "rad/s": ("an angular rate", "-30 deg/s", "RATE"),
    "m": ("a length", "5.1 cm", "LENGTH"),
    "kg": ("a mass", "70 g", "MASS"),
    "kg m^2": ("a moment of inertia", "359 kg mm^2", "INERTIA"),
    "kg/m^3": ("a density", "1000 kg/m^3", "DENSITY"),
    "s": ("a time", "2 s", "TIME"),
    "m/s": ("a speed", "1 cm/s", "SPEED"),
    "m/s^2": ("an acceleration", "9.8 m/s^2", "ACCELERATION"),
    "N s/m": ("a viscous resistance", "0.5 N s/m", "NUMBER"),
    "Pa s": ("a viscosity", "1.8e-5 Pa s", "NUMBER"),
    "1": ("a pure number", "0.5", "NUMBER"),
}
"""The quantity of each SI unit in words, an example, and what stands for it in the help."""


@dataclass(frozen=True)
class Quantity:
    """A number of a set-up, as people give it.

    It stands in the field of a dataclass, which has its name and its default. The options of the
    command line, the tables of scenario files, the keys of studies and the units of datasets derive
    from it. Its bounds stand in the core, beside the equations that need them.
    """

    unit: str = "1"
    """SI unit."""
    help: str = ""
    """The help of its option; without one it has no option."""
    option: str = ""
    """The option of the command line, ``static_friction``; the name of the number by default."""
    metavar: str = ""
    """What stands for its value in the help; by default the word for its unit."""
    hint: Literal["", "tilt", "size"] = ""
    """As what a plain number can be too large, so that a unit has been forgotten."""
    is_list: bool = False
    """Whether it is a list of numbers, which only files and programs can give."""
    required: bool = True

    def field(self, default: Any = MISSING) -> Any:
        """A field of a dataclass that is this number."""
        return field(default=default, metadata={Quantity.__name__: self})

    def read(self, value: object, name: str) -> float:
        """The value that a file or an option gives, in the SI unit.

        Raises ``UnitError`` as :func:`quantity`, :func:`tilt_angle` and :func:`size_of_body` do.
        """
        if self.hint == "tilt":
            return tilt_angle(value, name)
        if self.hint == "size":
            return size_of_body(value, self.unit, name)
        return quantity(value, self.unit, name)


def table_of(**numbers: Quantity) -> dict[str, Quantity]:
    """A table of numbers by name, each with its option and what stands for its value."""
    return {
        name: replace(
            number,
            option=number.option or name,
            metavar=number.metavar
            or (KINDS[number.unit][2] if number.unit in KINDS else number.unit),
        )
        for name, number in numbers.items()
    }


def quantities_of(kind: type) -> dict[str, Quantity]:
    """The numbers of a dataclass by name."""
    hashable: Any = kind  # mypy takes the __hash__ of its instances for its own
    return _quantities_of(hashable)


@cache
def _quantities_of(kind: Any) -> dict[str, Quantity]:
    numbers = {
        one.name: replace(number, required=one.default is MISSING)
        for one in fields(kind)
        if (number := one.metadata.get(Quantity.__name__)) is not None
    }
    return table_of(**numbers)


def convert_fields(
    made: Any,
    numbers: Mapping[str, Quantity],
    read: Callable[[str, object, str], object] | None = None,
) -> None:
    """Convert the numbers of a dataclass that is being made to SI units.

    ``read`` is :func:`values` by default. None stays where it is the default.
    """
    for one in fields(made):
        value = getattr(made, one.name)
        if one.name in numbers and (value is not None or one.default is not None):
            converted = (read or values)(one.name, value, numbers[one.name].unit)
            object.__setattr__(made, one.name, converted)


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
    return KINDS[unit][:2] if unit in KINDS else ("a coefficient of air drag", f"1e-9 {unit}")


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


class HasUnit(Protocol):
    """A quantity of pint, or anything else that has a unit and converts itself with ``to``."""

    def to(self, unit: Any, /) -> Any:
        """This quantity in another unit."""


Number = float | str | HasUnit
"""A single number in its SI unit, or with a unit: ``0.5``, ``"30 deg"``, ``30 * ureg.deg``."""

Values = ArrayLike | HasUnit
"""A number or an array of them, in SI units or with a unit."""

MAX_THREADS = 1024

_BARE = frozenset({float, int, np.float64, np.ndarray, str, bool, type(None)})
_POWER_OF_RATIO = re.compile(r"\((\w+)/(\w+)\)\^([\d.]+)")


def number(field: str, value: object, unit: str = "1") -> float:
    """The value of a field as a float in an SI unit, one of :data:`rimroll.units.KINDS`.

    Raises ``RimrollError`` naming the field when the value is not a single number, or is in a unit
    of another kind.
    """
    if type(value) is float:
        return value
    if isinstance(value, str):
        return quantity(value, unit, field)
    bare = without_unit(field, value, unit)
    try:
        # "O" is that of exact numbers such as Decimal. float() would take booleans, too, and the
        # real part of a complex number.
        if np.asarray(bare).dtype.kind in "iufO":
            return float(bare)  # type: ignore[arg-type]
    except (TypeError, ValueError, OverflowError):
        pass
    raise RimrollError(field=field, value=value, bound="a single number")


def positive(field: str, value: object, unit: str = "1") -> float:
    """A number as :func:`number` reads it; ``RimrollError`` unless it is > 0 and finite."""
    read = number(field, value, unit)
    if not 0.0 < read < math.inf:
        raise RimrollError(field=field, value=read, bound="> 0 and finite", unit=unit)
    return read


def optional(field: str, value: object, unit: str = "1") -> float | None:
    """A number as :func:`number` reads it, or None."""
    return None if value is None else number(field, value, unit)


def numbers(field: str, value: object, unit: str = "1") -> NDArray[np.float64]:
    """A number, or an array of any shape, in an SI unit: a read-only copy.

    Raises ``RimrollError`` naming the field for anything else, and for a unit of another kind.
    """
    if isinstance(value, str):
        array = np.asarray(quantity(value, unit, field))
    else:
        bare = without_unit(field, value, unit)
        try:
            array = np.asarray(bare)
        except ValueError:  # rows of different lengths
            array = np.asarray(None)
    if array.dtype.kind == "O" and all(type(entry) is int for entry in array.flat):
        try:  # beyond 64 bits
            array = array.astype(np.float64)
        except OverflowError:
            raise RimrollError("must be below 1.8e308, got a larger integer", field) from None
    if array.dtype.kind not in "iuf":
        raise RimrollError(field=field, value=value, bound="a number or an array of numbers")
    array = array.astype(np.float64)
    array.flags.writeable = False
    return array


def values(field: str, value: object, unit: str = "1") -> Any:
    """A number as a float, an array as :func:`numbers` reads it, a data array with its labels.

    Raises ``RimrollError`` as these do.
    """
    try:
        is_one = np.ndim(value) == 0  # type: ignore[arg-type]
    except ValueError:  # rows of different lengths
        is_one = False
    if is_one:
        return number(field, value, unit)
    array = numbers(field, value, unit)
    if not is_labelled(value):
        return array
    named = value.copy(data=array)
    if "units" in named.attrs:
        named.attrs["units"] = unit
    return named


def whole_number(field: str, value: object) -> int:
    """A count from 1 to below 2⁵³ as an int; ``RimrollError`` for all else, also for a text."""
    count = math.nan if isinstance(value, str) else number(field, value)
    if count.is_integer() and count >= 2**53:
        raise RimrollError(field=field, value=value, bound=f"below 2^53 = {2**53}")
    if not (count.is_integer() and count >= 1):
        raise RimrollError(field=field, value=value, bound="a whole number >= 1")
    return int(count)


def random_seed(value: object) -> int:
    """A seed of random numbers: a whole number from 0 to below 2⁶³, else ``RimrollError``."""
    try:
        seed = -1 if isinstance(value, bool) else operator.index(value)  # type: ignore[arg-type]
    except TypeError:
        seed = -1
    if not 0 <= seed < 2**63:
        raise RimrollError(field="seed", value=value, bound="a whole number >= 0 and below 2^63")
    return seed


def thread_count(threads: object) -> int:
    """A number of threads; 0, which stands for as many as there are processors, for None."""
    count = 0 if threads is None else whole_number("threads", threads)
    if count > MAX_THREADS:
        raise RimrollError(field="threads", value=count, bound=f"at most {MAX_THREADS}")
    return count


def without_unit(field: str, value: Any, unit: str) -> object:
    """What carries a unit as plain numbers in the SI unit; anything else as it is.

    Lists are searched for elements that carry one. Raises ``UnitError`` for a unit of another kind,
    and for one that cannot be converted, and ``RimrollError`` for masked elements.
    """
    if type(value) in _BARE:
        return value
    _expect_unmasked(field, value)
    if isinstance(value, list | tuple):
        return [_item(field, i, item, unit) for i, item in enumerate(value)]
    units = _units(value)
    if units is not None and (hasattr(value, "to") or not isinstance(units, str)):
        return _converted(field, value, units, unit)
    data = getattr(value, "data", None)
    if not isinstance(data, memoryview) and _units(data) is not None:
        return value.copy(data=without_unit(field, data, unit))  # a data array of quantities
    # A data array may say its unit in an attribute.
    if not units:
        return value
    factor = factor_of(units, unit, field, value)
    if is_labelled(value):
        _expect_unconverted(field, value, units, factor)
    return value * factor


def _expect_unconverted(field: str, value: xr.DataArray, units: str, factor: float) -> None:
    """Refuse an axis whose values are converted and whose attribute still has the old unit.

    xarray keeps attributes in ``np.radians(axis)``.
    """
    for name, labels in value.coords.items():
        if labels.attrs.get("units") != units or labels.dims != value.dims or not labels.any():
            continue
        for times in (factor, math.pi / 180.0, 180.0 / math.pi):
            if times != 1.0 and np.allclose(value, times * labels, rtol=1e-12, atol=0.0):
                raise UnitError(
                    f"{field}: the values are those of {name} in another unit, and the attribute"
                    f' units still says "{units}", since functions such as np.radians keep it:'
                    f" give the axis {name} itself, which is converted"
                )


def _expect_unmasked(field: str, value: Any) -> None:
    """Refuse missing data, which would be computed with as if they were there."""
    if np.ma.is_masked(value):
        raise RimrollError(f"must have no masked elements, got {value!r}", field, value)


def _item(field: str, place: int, value: object, unit: str) -> object:
    try:
        if isinstance(value, str):
            return quantity(value, unit, field)
        return without_unit(field, value, unit)
    except RimrollError as error:
        raise error.at((place, *error.index)) from None


def _units(value: object) -> Any:
    """The unit that a value carries, if any: an object, or a text."""
    found = getattr(value, "units", None)
    return getattr(value, "unit", None) if found is None else found


def _converted(field: str, value: Any, units: Any, unit: str) -> object:
    if not hasattr(value, "to"):
        raise UnitError(
            f"{field}: the unit of {value!r} cannot be converted: give a plain number in {unit}, a"
            " text with a unit, or a quantity of pint"
        )
    si = _spelled(unit)
    try:
        converted = _magnitude(value.to(si))
        if hasattr(value, "to_root_units"):  # pint takes radians for pure numbers
            fits = type(value)(1.0, si).to_root_units().units == value.to_root_units().units
        else:
            fits = True
    except Exception:  # each package has its own errors
        fits = False
    if not fits:
        raise mismatch(field, unit, value, str(units) or "dimensionless")
    _expect_unmasked(field, converted)
    if np.ndim(converted):
        return np.asarray(converted)
    return _exact(float(converted), value, units, si) if isinstance(converted, Real) else converted


def _exact(converted: float, value: Any, units: Any, si: str) -> float:
    """The double that the decimals name, as of a text: 6.9 cm is 0.069 m."""
    try:
        factor = tidy(float(_magnitude((1.0 * units).to(si))))
        exact = float(Decimal(repr(float(_magnitude(value)))) * Decimal(repr(factor)))
    except Exception:  # a unit that is not a factor, or not a finite number
        return converted
    return exact if math.isclose(exact, converted, rel_tol=1e-12) else converted


def _magnitude(value: Any) -> Any:
    return value.magnitude if hasattr(value, "magnitude") else value.value


def _spelled(unit: str) -> str:
    """An SI unit as every package reads it: ``kg*m**2``."""
    if unit == "1":
        return ""
    return _POWER_OF_RATIO.sub(_both_powers, unit).replace(" ", "*").replace("^", "**")


def _both_powers(found: re.Match[str]) -> str:
    """``s^(5/2)/rad^(5/2)`` for ``(s/rad)^2.5``, which not every package reads."""
    power = Fraction(found[3])
    return f"{found[1]}^({power})/{found[2]}^({power})"
