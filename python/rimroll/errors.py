"""The errors that rimroll raises, and suggestions for unknown names."""

from __future__ import annotations

import difflib
from collections.abc import Callable, Iterable, Mapping
from numbers import Real
from typing import TYPE_CHECKING, Any, TypeVar

if TYPE_CHECKING:
    from typing import Self

    import numpy as np
    from numpy.typing import NDArray


class RimrollError(ValueError):
    """An invalid request, in one sentence: ``str(error)``.

    Where a single value is invalid, the attributes say which and why. In other errors they are None
    or empty.

    >>> import rimroll as rr
    >>> try:
    ...     rr.State(tilt=[0.5, -0.1])
    ... except rr.RimrollError as error:
    ...     error.field, error.index, error.value, error.unit, error.bound
    ('tilt', (1,), -0.1, 'rad', 'inside (0, pi)')

    Attributes
    ----------
    field
        The name of the value, such as ``tilt_rate``.
    index
        Its place in an array or in a list, ``(3,)``.
    value, unit
        What was given, in this unit.
    bound
        What it must be, in words: ``> 0``.
    other
        The field that the bound depends on and names, such as ``topple_tilt``.
    name
        What those who gave the value call it, if not ``field``: ``--tilt-rate``.
    where
        The place that has the value, such as a file and its table: ``my_cup.toml: [law]``.
    """

    def __init__(
        self,
        text: str = "",
        field: str | None = None,
        value: object = None,
        bound: str = "",
        unit: str = "",
        index: Iterable[int] = (),
        other: str | None = None,
        hint: str = "",
    ) -> None:
        """An error that says ``text`` of a field, or of no field.

        Without a text it says what the value must be and is, and ends with the ``hint``.
        """
        super().__init__(text, field, value, bound, unit, index, other, hint)
        self.text = text or f"must be {bound}, got {in_words(value, unit)}{hint}"
        self.field, self.value, self.bound, self.unit = field, value, bound, unit
        self.index, self.other = tuple(index), other
        self.name, self.where = field or "", ""

    def __str__(self) -> str:
        return " ".join(filter(None, (self.where, element(self.name, self.index), self.text)))

    def at(self, index: Iterable[int]) -> Self:
        """A copy that names the element of an array by its index."""
        return self._with(index=tuple(index))

    def called(self, names: Mapping[str, str]) -> Self:
        """A copy that calls each field by the name that the user knows, such as ``--tilt-rate``."""
        text = self.text
        if self.other:
            text = text.replace(f"{self.other} = ", f"{names.get(self.other, self.other)} = ")
        return self._with(text=text, name=names.get(self.field or "", self.name))

    def inside(self, where: str) -> Self:
        """A copy that puts this place, such as a file, before the places that it names so far."""
        return self._with(where=f"{where} {self.where}".rstrip())

    def with_hint(self, hint: str) -> Self:
        """A copy that ends with a hint."""
        return self._with(text=self.text + hint)

    def _with(self, **attributes: object) -> Self:
        kind = type(self)  # not copy.copy: what tblib makes of it shares its attributes
        error = kind.__new__(kind, *self.args)
        vars(error).update(vars(self) | attributes)
        return error


def in_words(value: object, unit: str = "") -> str:
    """A value in a sentence, with its unit unless it is a pure number, ``""`` or ``"1"``."""
    if isinstance(value, float):
        words = f"{value:.15g}"
    else:
        words = str(value) if isinstance(value, Real) else repr(value)
    return f"{words} {unit}".removesuffix(" 1").rstrip()


def expect(field: str, value: object, kind: Any) -> None:
    """Raise ``RimrollError`` unless the value is of the kind, a class or a union of classes."""
    if not isinstance(value, kind):
        kinds = " or ".join(
            "None" if k is type(None) else f"{k.__module__.split('.')[0]}.{k.__name__}"
            for k in getattr(kind, "__args__", (kind,))
        )
        name = getattr(value, "__name__", "something callable")
        given = f"{name} itself: call it" if callable(value) else repr(value)
        raise RimrollError(f"must be a {kinds}, got {given}", field, value, f"a {kinds}")


def hold(
    field: str,
    values: NDArray[np.float64],
    holds: NDArray[np.bool_],
    bound: str,
    unit: str = "",
    hint: Callable[[float], str] | None = None,
) -> None:
    """Raise ``RimrollError`` unless the bound holds for a number, or for each element of an array.

    The error is about the first invalid element, as in ``tilt[1] must be finite, got nan``. It ends
    with the ``hint`` for that element.
    """
    if not holds.all():
        import numpy as np  # not before: whoever only reports errors needs none

        index = tuple(map(int, np.argwhere(~holds)[0]))
        value = values[index].item()
        more = hint(float(value)) if hint else ""
        raise RimrollError("", field, value, bound, unit, index, hint=more)


def element(field: str, index: Iterable[int]) -> str:
    """How messages name an element of an array, ``tilt[1]``, and a single number, ``tilt``."""
    place = ", ".join(map(str, index))
    return f"{field}[{place}]" if place else field


def callback(field: str, value: object) -> None:
    """Raise ``RimrollError`` unless the value is None or can be called."""
    if value is not None and not callable(value):
        raise RimrollError("", field, value, "None or something to call")


class NoNearCollision(RimrollError):
    """A start whose motion has no near-collision to describe.

    Attributes
    ----------
    in_degrees
        The message with angles in degrees instead of radians.
    status
        How the motion ends that comes in place of one, as ``Motion.status``; None where the start
        is refused for another reason.
    """

    def __init__(self, message: str, in_degrees: str = "", status: str | None = None) -> None:
        super().__init__(message)
        self.args = (message, in_degrees, status)
        self.in_degrees = in_degrees
        self.status = status


class UnitError(RimrollError):
    """A quantity whose text has no number, an unknown unit, or a unit of another kind.

    ``why`` says which of these.
    """

    why = ""


T = TypeVar("T")


def choose(what: str, name: str, choices: Mapping[str, T]) -> T:
    """The choice of that name: ``no-slip`` is found as ``no_slip``, ``noslip`` and ``No Slip`` too.

    Raises ``RimrollError`` with the nearest name and all choices.
    """
    found = {_bare(known): choice for known, choice in choices.items()}
    if _bare(name) not in found:
        raise RimrollError(f"unknown {what} {name!r}{nearest(name, choices)}")
    return found[_bare(name)]


def nearest(name: str, known: Iterable[str]) -> str:
    """The end of a message: the nearest known name, and all known names."""
    names = list(known)
    near = difflib.get_close_matches(name, names, n=1)
    choices = ", ".join(names) or "none"
    return f": did you mean {near[0]!r}? Known: {choices}" if near else f": choose from {choices}"


def typed(name: str) -> str:
    """The name of a field or law as users type it: ``no-slip``."""
    return name.replace("_", "-")


def _bare(name: str) -> str:
    return name.lower().replace("-", "").replace("_", "").replace(" ", "")
