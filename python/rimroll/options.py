"""How motions are followed, and what follows where the whole base comes down flat at once."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Mapping
from dataclasses import dataclass, fields, replace
from typing import TYPE_CHECKING, Any, TypedDict, TypeVar

from rimroll import _core
from rimroll.errors import RimrollError, expect, nearest
from rimroll.files.recorded import not_recorded
from rimroll.units import Number, Quantity, convert_fields, number, quantities_of, whole_number

if TYPE_CHECKING:
    from typing import Unpack

    import xarray as xr

    from rimroll.ground.ground import Ground


F = TypeVar("F", bound=Callable[..., Any])


class Keywords(TypedDict, total=False):
    """The options of a motion as keywords of functions, besides ``duration``."""

    gravity: Number
    rtol: float
    topple_tilt: Number | None
    max_steps: int
    flat: FlatLanding | None
    flat_gap: Number


@dataclass(frozen=True)
class Options:
    """How a motion is followed: the keywords of :func:`rimroll.simulate`, whose defaults these are.

    Functions that follow motions take these keywords, or all of them together as ``options``, of
    which keywords then change single ones. Those that follow many motions have other defaults,
    which their signatures show.

    >>> import rimroll as rr
    >>> options = rr.Options(gravity=9.8, rtol=1e-8)
    >>> can, start = rr.bodies.can_2007(), rr.State(tilt=0.5, yaw_rate=0.01)
    >>> rr.simulate(can, start, rr.NoSlip(), options=options, rtol=1e-12).rtol
    1e-12

    Raises ``RimrollError`` for what is no number, or in a unit of another kind.
    """

    duration: float = Quantity("s", "Duration of the motion. [2 s]").field(2.0)
    gravity: float = Quantity("m/s^2", "The paper used 9.8. [9.80665 m/s^2]").field(
        _core.STANDARD_GRAVITY
    )
    rtol: float = Quantity("1", "Intended relative error. [1e-10]").field(1e-10)
    topple_tilt: float | None = Quantity(
        "rad", "Tilt that counts as toppled. [90 deg; a disk: none]", hint="tilt"
    ).field(None)
    max_steps: int = 1_000_000
    flat: FlatLanding | None = None
    """None: ``housner`` on a table that moves, else ``stop``."""
    flat_gap: float = Quantity(
        "m", "The base comes down flat also where its far side is this far above the table. [0]"
    ).field(0.0)

    if TYPE_CHECKING:

        def __init__(self, duration: Number = 2.0, **keywords: Unpack[Keywords]) -> None: ...

    def __post_init__(self) -> None:
        convert_fields(self, quantities_of(Options), number)
        vars(self)["max_steps"] = whole_number("max_steps", self.max_steps)
        if self.flat is not None:
            vars(self)["flat"] = flat_given(self.flat)

    def changed(
        self, options: Options | None, duration: Number | None, keywords: Mapping[str, Any]
    ) -> Options:
        """These options, or those given in their place, with some changed by keywords."""
        expect("options", options, Options | None)
        chosen = self if options is None else options
        if duration is not None:
            keywords = {**keywords, "duration": duration}
        known = [field.name for field in fields(self)]
        for name in keywords.keys() - known:
            raise TypeError(f"unknown option {name!r}{nearest(name, known)}")
        return replace(chosen, **keywords) if keywords else chosen

    @property
    def values(self) -> tuple[float, float, float, float | None, int]:
        """The options of all motions in the order of the core's arguments."""
        return self.duration, self.gravity, self.rtol, self.topple_tilt, self.max_steps


def takes_options(defaults: Options, *but: str) -> Callable[[F], F]:
    """Show the options that a function takes as ``keywords`` in its signature, with their defaults.

    Those named in ``but`` are shown as the function itself has them, if it does.
    """

    def with_signature(function: F) -> F:
        plain = inspect.signature(function)
        shown = {name: one for name, one in plain.parameters.items() if name != "keywords"}
        for name, hint in Keywords.__annotations__.items():
            if name not in but:
                kind, text = inspect.Parameter.KEYWORD_ONLY, hint.__forward_arg__
                shown[name] = inspect.Parameter(name, kind, annotation=text)
        for name in shown.keys() & vars(defaults).keys() - set(but):
            shown[name] = shown[name].replace(default=getattr(defaults, name))
        function.__signature__ = plain.replace(parameters=[*shown.values()])  # type: ignore[attr-defined]
        return function

    return with_signature


def options_of(dataset: xr.Dataset) -> Options:
    """The options of a motion or of falls.

    Raises ``RimrollError`` for a dataset without them.
    """
    given: dict[str, Any] = {field.name: dataset.attrs.get(field.name) for field in fields(Options)}
    given["flat_gap"] = dataset.attrs.get("flat_gap", Options.flat_gap)
    for name, value in given.items():
        if value is None and name not in ("topple_tilt", "flat"):
            raise not_recorded("options", name)
    return Options(**given)


FlatLanding = str | float | tuple[str, int]
"""See ``flat`` of :func:`rimroll.simulate`."""

KINDS = ("stop", "smooth", "smooth_left", "smooth_right", "housner")


ON_MOVING_TABLES: FlatLanding = "housner"
"""What follows on a table that moves unless it is given: a plastic collision."""


def landing_given(flat: object, moves: bool) -> FlatLanding:
    """As :func:`flat_given`; None stands for ``housner`` on a table that moves, else ``stop``."""
    if flat is None:
        return ON_MOVING_TABLES if moves else "stop"
    return flat_given(flat)


def flat_given(flat: object) -> FlatLanding:
    """A flat landing as users give it, or as a text; raises ``RimrollError`` for another value."""
    if isinstance(flat, str):
        flat = _of_text(flat)
    if isinstance(flat, str) and flat in KINDS:
        return flat
    if isinstance(flat, tuple) and len(flat) == 2 and flat[0] == "smooth":
        return ("smooth", whole_number("flat seed", flat[1]))
    if isinstance(flat, str | bool | tuple) or flat is None:
        raise RimrollError(
            field="flat",
            value=flat,
            bound=f"""one of {", ".join(KINDS)}, ("smooth", seed) or a restitution from 0 to 1""",
        )
    return number("flat", flat)


def _of_text(text: str) -> object:
    """``smooth:7`` and ``0.5`` as they are given in Python; another text with _ for -."""
    kind, colon, seed = text.partition(":")
    if colon and seed.isdecimal():
        return kind, int(seed)
    try:
        return float(text)
    except ValueError:
        return text.replace("-", "_")


def flat_as_text(flat: FlatLanding) -> str | float:
    """A flat landing as a text or a number, which :func:`flat_given` reads."""
    return ":".join(map(str, flat)) if isinstance(flat, tuple) else flat


def flat_in_core(flat: FlatLanding, gap: float) -> tuple[str, float, int, float]:
    """A flat landing as the core takes it: its kind, the restitution, the seed and the gap, m."""
    if isinstance(flat, str):
        return flat, 0.0, 0, gap
    if isinstance(flat, tuple):
        return flat[0], 0.0, flat[1], gap
    return "restitution", float(flat), 0, gap


def ground_given(ground: object) -> Ground | None:
    """A motion of the table as users give it; raises ``RimrollError`` for another value."""
    if ground is None:
        return None
    from rimroll.errors import expect
    from rimroll.ground.ground import Ground

    expect("ground", ground, Ground)
    assert isinstance(ground, Ground)
    return ground
