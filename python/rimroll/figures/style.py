"""The style of rimroll's figures: type, lines, colours by meaning, and ticks in few digits.

Sizes are those of a page 180 mm wide. Colours are Okabe and Ito's, distinguishable with any colour
vision; line styles and markers differ as well, so that no meaning depends on colour alone.

The power of ten and the offset of a zoomed axis go into its label: where matplotlib writes them,
beside the axis, they collide with the title or another label.
"""

from __future__ import annotations

import io
import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from matplotlib.axis import Axis
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, MultipleLocator, NullFormatter, NullLocator
from numpy.typing import NDArray

from rimroll.laws import Frictionless, Law, NoSlip

NO_SLIP = NoSlip.color
FRICTIONLESS = Frictionless.color
THEORY = "#000000"
MEASURED = "#009E73"
CONTRAST = "#8A8A8A"
NORMAL_FORCE = "#56B4E9"
SERIES = ("#0072B2", "#E69F00", "#009E73", "#CC79A7", "#56B4E9", "#D55E00")
"""Colours of data series without a colour of their own, in order."""

SHOWN_DPI = 110.0
"""Resolution of figures in notebooks."""

SLIDING = "#F0E442"
"""Background colour of the times at which the rim slides; drawn faintly."""

PAGE_WIDTH = 180.0
"""Width of the page, mm."""

STYLE: dict[str, Any] = {
    "font.family": "DejaVu Sans",
    "font.size": 7.5,
    "mathtext.fontset": "dejavusans",
    "axes.titlesize": 8.0,
    "axes.titlepad": 4.0,
    "axes.titley": 1.0,  # fixed, not computed for each picture
    "axes.labelsize": 7.5,
    "axes.labelpad": 2.5,
    "axes.linewidth": 0.6,
    "axes.edgecolor": "#333333",
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.formatter.limits": (-3, 4),
    "xtick.labelsize": 6.8,
    "ytick.labelsize": 6.8,
    "xtick.major.width": 0.6,
    "ytick.major.width": 0.6,
    "xtick.minor.width": 0.4,
    "ytick.minor.width": 0.4,
    "xtick.major.size": 3.0,
    "ytick.major.size": 3.0,
    "xtick.minor.size": 1.6,
    "ytick.minor.size": 1.6,
    "lines.linewidth": 1.1,
    "lines.markersize": 3.8,
    "lines.markeredgewidth": 0.8,
    "legend.fontsize": 6.8,
    "legend.frameon": False,
    "legend.handlelength": 2.0,
    "legend.borderaxespad": 0.4,
    "legend.labelspacing": 0.35,
    "figure.dpi": 150,
    "figure.facecolor": "white",
    "figure.autolayout": False,
    "figure.constrained_layout.use": False,  # page() asks for it; placed axes must not be moved
    "figure.constrained_layout.h_pad": 0.05,
    "figure.constrained_layout.w_pad": 0.05,
    "savefig.dpi": 150,
    "svg.fonttype": "path",
    "svg.hashsalt": "rimroll",  # else the names inside a file differ from run to run
    "pdf.fonttype": 42,
}

_DATE = {".pdf": "CreationDate", ".svg": "Date"}
"""The names of the date of writing in file formats."""


@contextmanager
def figure_style() -> Iterator[None]:
    """The style while figures are drawn and saved; previous settings are restored afterwards."""
    with mpl.rc_context(STYLE):  # type: ignore[arg-type]  # its keys are literals
        yield


class ShownFigure(Figure):
    """A figure that a notebook shows even if pyplot has not been imported there."""

    def _repr_png_(self) -> bytes:
        """The view in notebooks."""
        picture = io.BytesIO()
        with figure_style():
            self.savefig(picture, format="png", dpi=SHOWN_DPI)
        return picture.getvalue()


def page(height: float, width: float = PAGE_WIDTH) -> Figure:
    """An empty figure of a size in mm that lays out its own axes, free of pyplot's state."""
    return ShownFigure(figsize=(width / 25.4, height / 25.4), layout="constrained")


def settle(figure: Figure) -> Figure:
    """Lay a page out once, so that saving it to several files does not do it again."""
    engine = figure.get_layout_engine()
    if engine is not None:
        engine.execute(figure)
        # Not "none", which leaves a placeholder, for which matplotlib draws each file twice.
        with figure_style():
            figure.set_layout_engine(None)
    return figure


def save(figure: Figure, path: str | os.PathLike[str], dpi: int = 200) -> None:
    """Write a figure in its style; without a date, so that the same figure is the same file."""
    suffix = Path(path).suffix.lower()
    undated = {_DATE[suffix]: None} if suffix in _DATE else {}
    drawn = io.BytesIO()  # written at once: not every backend handles a full disk
    with figure_style():
        figure.savefig(drawn, format=suffix[1:], dpi=dpi, metadata=undated)
    Path(path).write_bytes(drawn.getvalue())


def label(ax: Axes, letter: str, title: str, x: str, y: str) -> None:
    """Name a panel and its axes; ``x`` and ``y`` carry their units."""
    ax.set_title(f"({letter}) {title}" if letter else title, loc="left")
    ax.set_xlabel(x)
    ax.set_ylabel(y)


def look(law: Law) -> dict[str, Any]:
    """Colour and marker of results under a law; filled if the rim can stick."""
    face = law.color if law.can_stick else "white"
    return {"color": law.color, "marker": law.marker, "markerfacecolor": face}


def decades(*axes: Axis) -> None:
    """Write the ticks of logarithmic axes as powers of ten, in plain text."""
    for axis in axes:
        axis.set_major_formatter(lambda value, _: power_of_ten(value))
        axis.set_minor_formatter(NullFormatter())
        axis.set_minor_locator(NullLocator())


def power_of_ten(value: float) -> str:
    """A power of ten as text, 10⁻³; 1, 10 and other numbers in digits."""
    if value == 0.0:
        return "0"
    power = float(np.log10(abs(value)))
    sign = "−" if value < 0.0 else ""
    if not power.is_integer() or power in (0.0, 1.0):
        return sign + f"{abs(value):g}"
    return sign + "10" + superscript(int(power))


def superscript(number: int) -> str:
    """A whole number written high: ⁻¹²."""
    return str(number).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))


def plain(value: float) -> str:
    """A small positive number as text with one digit: 0.005, 10⁻⁴, 5×10⁻⁵."""
    if value >= 1e-3:
        return f"{value:g}"
    mantissa, power = f"{value:.0e}".split("e")
    return ("" if mantissa == "1" else f"{mantissa}×") + "10" + superscript(int(power))


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
