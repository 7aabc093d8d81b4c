"""Numbers as users give them, converted to floats and arrays in SI units and radians.

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
from decimal import Decimal
from fractions import Fraction
from numbers import Real
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rimroll.errors import RimrollError, UnitError
from rimroll.grid import is_labelled
from rimroll.units import factor_of, mismatch, quantity, tidy

if TYPE_CHECKING:
    import xarray as xr


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
