"""A ground as a scenario file or the command line describes it: a pulse, a record, or both."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from rimroll.errors import RimrollError, choose, typed
from rimroll.ground.files import read
from rimroll.ground.ground import MAX_FACTOR, Ground
from rimroll.ground.pulses import cosine, half_sine, rectangular, ricker, sine
from rimroll.units import Quantity, table_of

PULSES: dict[str, Callable[..., Ground]] = {
    "sine": sine,
    "cosine": cosine,
    "half_sine": half_sine,
    "rectangular": rectangular,
    "ricker": ricker,
}

NUMBERS = table_of(
    amplitude=Quantity("m/s^2", "Of the pulse: along x, or x,y,z as in 0.3g,1m/s2,0."),
    period=Quantity("s", "Of sine, cosine and ricker; or x,y,z."),
    cycles=Quantity("1", "Periods of sine and cosine; or x,y,z. [1]"),
    duration=Quantity("s", "Of half-sine and rectangular; or x,y,z.", option="pulse_duration"),
    center=Quantity("s", "Time of the peak of ricker. [two periods]"),
)
"""The numbers of pulses."""

CHANGES = table_of(
    scale=Quantity("1", "Multiply all accelerations.", metavar="FACTOR"),
    rotation=Quantity(
        "rad", "Turn the ground about the vertical, from x toward y.", option="rotate"
    ),
)
"""The numbers that change a ground."""

Three = float | list[float]
"""A number, or three (x, y, z)."""


@dataclass(frozen=True)
class Description:
    """What a ground consists of.

    ``numbers`` are the arguments of the pulse, in SI units; ``scale`` multiplies all
    accelerations, and ``rotation`` (rad) turns them about the vertical, from x toward y.
    """

    record: Sequence[str | Path] = ()
    pulse: str | None = None
    numbers: Mapping[str, Three] = field(default_factory=dict)
    scale: float | None = None
    rotation: float | None = None
    units: str | None = None
    component: str | None = None
    pad: bool = False
    headings: Sequence[str] | None = None
    columns: Mapping[str, str | int] | None = None
    step: float | None = None
    time_unit: str | None = None

    def made(self, called: Callable[[str], str] = str) -> Ground | None:
        """The ground; None if there is neither a record nor a pulse.

        ``called`` says what errors call a field. Raises ``RimrollError`` for fields that do not go
        together, and what :func:`rimroll.ground.read` and the pulses raise.
        """
        parts = [part for part in (self._recorded(called), self._pulsed(called)) if part]
        if not parts:
            return None
        return self.changed(parts[0] if len(parts) == 1 else parts[0] + parts[1], called)

    def changed(self, ground: Ground, called: Callable[[str], str] = str) -> Ground:
        """A ground scaled and turned as this describes it; ``called`` as for :meth:`made`."""
        if self.scale is not None:
            if not 1.0 / MAX_FACTOR <= self.scale <= MAX_FACTOR:
                raise RimrollError(
                    f"{called('scale')} must be between 1e-6 and 1e6, got {self.scale:g}"
                )
            ground = ground.scaled(self.scale)
        return ground if self.rotation is None else ground.rotated(self.rotation)

    def _recorded(self, called: Callable[[str], str]) -> Ground | None:
        if self.record:
            return read(
                *self.record,
                headings=self.headings,
                units=self.units,
                component=self.component,
                pad=self.pad,
                columns=self.columns,
                step=self.step,
                time_unit=self.time_unit,
            )
        for name in ("headings", "units", "component", "pad", "columns", "step", "time_unit"):
            if getattr(self, name) not in (None, False):
                raise RimrollError(f"{called(name)} needs {called('record')}")
        return None

    def _pulsed(self, called: Callable[[str], str]) -> Ground | None:
        if self.pulse is None:
            if self.numbers:
                raise RimrollError(f"{called(next(iter(self.numbers)))} needs {called('pulse')}")
            return None
        make = choose("pulse", self.pulse, PULSES)
        takes = inspect.signature(make).parameters
        for name in self.numbers:
            if name not in takes:
                known = ", ".join(map(called, takes))
                raise RimrollError(
                    f"{called(name)} does not go with the pulse {typed(self.pulse)}, which takes"
                    f" {known}"
                )
        for name, parameter in takes.items():
            if parameter.default is parameter.empty and name not in self.numbers:
                raise RimrollError(f"the pulse {typed(self.pulse)} needs {called(name)}")
        return make(**self.numbers)
