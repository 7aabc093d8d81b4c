"""What of a study can vary, and the values that it takes."""

from __future__ import annotations

import inspect
import math
from collections.abc import Mapping
from dataclasses import dataclass, fields
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rimroll.bodies.body import Body
from rimroll.bodies.solids import SIZES
from rimroll.errors import RimrollError, nearest
from rimroll.experiment.release import NUMBERS as OF_RELEASE
from rimroll.ground.described import CHANGES, NUMBERS
from rimroll.laws import LAWS
from rimroll.options import Options
from rimroll.scenario import RESISTANCES, presets
from rimroll.scenario.tables import Table, as_toml, readable
from rimroll.state import START_NUMBERS
from rimroll.units import Quantity, quantities_of, quantity, table_of

OF_FIT = table_of(falls=Quantity(), reading_error=Quantity("rad"), bias=Quantity("rad"))
"""The numbers of a simulated experiment."""


@cache
def targets() -> Mapping[str, str | None]:
    """The keys that can vary and their SI units; None for those whose values are not numbers."""
    words = [
        *("body", "body.preset", "law", "law.kind", "law.surface", "release", "release.preset"),
        *("ground", "ground.record", "ground.pulse", "simulation.flat"),
    ]
    return {
        **dict.fromkeys(words),
        **_of_body(),
        **_of_law(),
        **_in_section("start", START_NUMBERS),
        **_in_section("release", OF_RELEASE),
        **_in_section("ground", NUMBERS | CHANGES),
        "ground.synthetic": "1",
        **_in_section("fit", OF_FIT),
        **_in_section("simulation", quantities_of(Options)),
    }


def _in_section(section: str, numbers: Mapping[str, Quantity]) -> dict[str, str | None]:
    return {f"{section}.{name}": None if one.is_list else one.unit for name, one in numbers.items()}


def unit_of(target: str) -> str | None:
    """The SI unit of a key, None for words and tables; ``RimrollError`` for an unknown key."""
    known = targets()
    if target not in known:
        section = target.partition(".")[0]
        near = [name for name in known if name.partition(".")[0] == section] or list(known)
        raise RimrollError(f"unknown quantity {target!r}{nearest(target, near)}")
    return known[target]


def _of_body() -> dict[str, str | None]:
    numbers = [field.name for field in fields(Body)]
    arguments = {name for make in presets().values() for name in inspect.signature(make).parameters}
    return {
        **_in_section("body", {name: SIZES[name] for name in (*numbers, *sorted(arguments))}),
        **{f"body.factors.{name}": "1" for name in numbers},
    }


def _of_law() -> dict[str, str | None]:
    found: dict[str, str | None] = {}
    for kind in LAWS.values():
        found |= _in_section("law", quantities_of(kind))
    for table, resistance in RESISTANCES.items():
        found |= _in_section(f"law.{table}", quantities_of(resistance))
    return found


MAX_VALUES = 1_000_000
"""The largest number of values of an axis."""


@dataclass(frozen=True, eq=False)
class Axis:
    """A quantity and the values that it takes, along a dimension of the result."""

    name: str
    of: str
    """The key of the tables that varies, such as ``law.friction``."""
    along: str
    """The dimension; axes along the same one are zipped."""
    values: tuple[Any, ...] | NDArray[np.float64]
    """Numbers in SI units; or words, lists and tables."""
    labels: NDArray[Any]
    """What the coordinate shows: numbers or words."""
    unit: str
    long_name: str | None = None

    @property
    def size(self) -> int:
        """The number of values."""
        return len(self.values)


class Described(Table):
    """An axis as a file or a program describes it."""

    of: str
    values: list[Any] | None = None
    range: list[Any] | None = None
    log_range: list[Any] | None = None
    number: int | None = None
    along: str | None = None
    labels: list[Any] | None = None
    unit: str | None = None
    long_name: str | None = None

    def axis(self, name: str) -> Axis:
        """The axis of that name.

        Raises ``RimrollError`` for no values, no numbers where the quantity is one, a range that
        does not have two ends, labels that are not as many as the values.
        """
        unit = unit_of(self.of)
        values = self._values(unit)
        labels = self._labels(name, values)
        return Axis(
            name,
            self.of,
            self.along or name,
            values,
            labels,
            self.unit or ("" if self.labels is not None else _shown(unit)),
            self.long_name,
        )

    def _values(self, unit: str | None) -> tuple[Any, ...] | NDArray[np.float64]:
        given = [one for one in ("values", "range", "log_range") if getattr(self, one) is not None]
        if len(given) != 1:
            got = " and ".join(given) or "none"
            raise RimrollError(f"needs one of values, range and log_range, got {got}")
        if self.values is not None:
            return self._listed(unit, self.values)
        if unit is None:
            raise RimrollError(f"{given[0]}: {self.of} is no number: list its values")
        return self._between(given[0], unit)

    def _listed(self, unit: str | None, values: list[Any]) -> tuple[Any, ...] | NDArray[np.float64]:
        if self.number is not None:
            raise RimrollError("number needs range or log_range, not values")
        if not values:
            raise RimrollError("must be one or more, got none", "values")
        if len(values) > MAX_VALUES:
            raise RimrollError(field="values", value=len(values), bound=f"at most {MAX_VALUES}")
        if unit is None:
            return tuple(values)
        return np.array(
            [quantity(readable(one), unit, f"values[{k}]") for k, one in enumerate(values)]
        )

    def _between(self, key: str, unit: str) -> NDArray[np.float64]:
        ends = getattr(self, key)
        if len(ends) != 2:
            raise RimrollError(f"must be two numbers, got {as_toml(ends)}", key)
        low, high = (quantity(readable(end), unit, key) for end in ends)
        count = self.number
        if count is None:
            raise RimrollError(f"{key} lacks 'number': how many values")
        if not 1 <= count <= MAX_VALUES:
            raise RimrollError(field="number", value=count, bound=f"between 1 and {MAX_VALUES}")
        if key == "range":
            return np.linspace(low, high, count)
        if not (low > 0.0 and high > 0.0):
            text = f"must be > 0, got {low:g} to {high:g} {_shown(unit)}"
            raise RimrollError(text, key, (low, high), "> 0", unit)
        # Not geomspace, whose powers depend on the version of NumPy.
        logs = np.linspace(math.log(low), math.log(high), count)
        values = np.array([math.exp(one) for one in logs])
        values[0], values[-1] = low, high if count > 1 else low
        return values

    def _labels(self, name: str, values: tuple[Any, ...] | NDArray[np.float64]) -> NDArray[Any]:
        if self.labels is not None:
            if len(self.labels) != len(values):
                raise RimrollError(
                    field="labels",
                    value=len(self.labels),
                    bound=f"as many as the values, {len(values)}",
                )
            return _as_labels(self.labels)
        if isinstance(values, np.ndarray):
            return values
        return _as_labels([_word(one, k) for k, one in enumerate(values)])


def _as_labels(labels: list[Any]) -> NDArray[Any]:
    array = np.array(labels)
    texts = sum(isinstance(one, str) for one in labels)
    if array.dtype.kind not in "iufU" or array.ndim != 1 or texts not in (0, len(labels)):
        raise RimrollError(f"must be all numbers or all texts, got {as_toml(labels)}", "labels")
    return array if array.dtype.kind == "U" else array.astype(np.float64)


def _word(value: Any, number: int) -> str:
    """A word for a value that is no number."""
    if isinstance(value, Mapping):
        for key in ("name", "preset", "kind", "surface", "pulse"):
            if isinstance(value.get(key), str):
                rest = [f"{k}={v}" for k, v in value.items() if k != key and _is_plain(v)]
                return " ".join([value[key], *rest])
        return str(number)
    if isinstance(value, list):
        return " ".join(map(str, value))
    return str(value)


def _is_plain(value: object) -> bool:
    return isinstance(value, str | int | float)


def _shown(unit: str | None) -> str:
    """A unit as variables have it: "" for pure numbers and words."""
    return "" if unit in (None, "1") else str(unit)
