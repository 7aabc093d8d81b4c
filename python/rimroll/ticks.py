"""Ticks of directions, and of zoomed axes in few digits.

The power of ten and the offset of a zoomed axis go into its label: where matplotlib writes them,
beside the axis, they collide with the title or another label.
"""

from __future__ import annotations

import numpy as np
from matplotlib.axis import Axis
from matplotlib.ticker import FuncFormatter, MultipleLocator
from numpy.typing import NDArray

from rimroll.style import superscript

FAR = 20.0
"""If ticks are farther from zero than this multiple of their range, they get an offset."""

PLAIN = range(-1, 4)
"""Powers of ten that stay in the ticks."""

DEGREES = (5, 10, 20, 30, 60)
"""Steps between ticks of directions, degrees."""

Array = NDArray[np.float64]


def directions_in_degrees(axis: Axis, half: float) -> None:
    """Ticks of directions, whose axis shows ``half`` degrees to either side of its middle.

    They are numbers from 0 to 360 without a sign; the label of the axis says that they are degrees.
    """
    step = next((step for step in DEGREES if 7 * step >= 2 * half), DEGREES[-1])
    axis.set_major_locator(MultipleLocator(step))
    axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value % 360.0:g}"))


def powers_into_label(axis: Axis) -> None:
    """Fix the ticks of a settled axis, whose label ends in a unit: ``yaw rate (10⁻⁹ rad/s)``."""
    low, high = sorted(axis.get_view_interval())
    at = np.array([tick for tick in axis.get_majorticklocs() if low <= tick <= high])
    if len(at) < 2:
        return
    step = float(at[1] - at[0])
    offset = float(at[len(at) // 2]) if np.abs(at).max() > FAR * (high - low) else 0.0
    power = _power(np.abs(at - offset).max())
    unit_of_ticks = 1.0 if power in PLAIN else 10.0**power
    axis.set_ticks(at, _texts((at - offset) / unit_of_ticks, step / unit_of_ticks))
    name, unit = axis.get_label_text().removesuffix(")").rsplit(" (", 1)
    if offset:
        digits = np.format_float_positional(abs(offset), 2 - _power(step), trim="-")
        name += f" {'−' if offset > 0.0 else '+'} {digits} {unit}"
    if power not in PLAIN:
        unit = f"10{superscript(power)} {unit}"
    axis.set_label_text(f"{name} ({unit})")


def _power(number: float) -> int:
    """The power of ten of a number's first digit."""
    return int(f"{number:.3e}".split("e")[1])


def _texts(numbers: Array, step: float) -> list[str]:
    """Numbers with as many decimals as their step has."""
    decimals = next((n for n in range(4) if abs(round(step, n) - step) < 1e-3 * step), 4)
    shown = np.round(numbers, decimals) + 0.0  # no minus before a zero
    return [f"{number:.{decimals}f}".replace("-", "−") for number in shown]
