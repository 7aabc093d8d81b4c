"""The figures of rocking spectra, overturning spectra, fragility curves and distributions."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import ListedColormap
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from numpy.typing import NDArray

from rimroll.figures import style

if TYPE_CHECKING:
    from rimroll.many.falls import Falls
    from rimroll.shaking.curve import Array, Counts, LognormalCurve

OVERTURNED = "#F3D9C9"
"""The background of what overturns."""

Marks = NDArray[np.bool_]

UNDECIDED = "#DDDDDD"
"""The background of motions that end before they are decided."""

HEIGHT, WIDTH = 70.0, 110.0
"""The size of a figure of one panel, mm."""


def _panel() -> tuple[Figure, Axes]:
    figure = style.page(HEIGHT, WIDTH)
    return figure, figure.add_subplot()


def rocking_figure(
    period: Array, max_tilt_ratio: Array, overturned: Marks, undecided: Marks
) -> Figure:
    """The largest tilt over the balance tilt against 2π/p (s), all of shape (n,)."""
    handles = []
    shades = ((overturned, OVERTURNED, "overturns"), (undecided, UNDECIDED, "not determined"))
    with style.figure_style():
        figure, ax = _panel()
        ax.plot(period, max_tilt_ratio, ".-", color=style.SERIES[0], ms=3.0)
        for which, color, words in shades:
            for begin, end in _intervals(period, which):
                ax.axvspan(begin, end, color=color, lw=0.0)
            if which.any():
                handles.append(Patch(color=color, label=words))
        ax.set_xlim(period.min(), period.max())
        ax.set_ylim(bottom=0.0)
        style.label(ax, "", "rocking spectrum", "period $2π/p$ (s)", "largest tilt / balance tilt")
        if handles:
            ax.legend(handles=handles, loc="upper right")
    return figure


def _intervals(x: np.ndarray, inside: np.ndarray) -> list[tuple[float, float]]:
    """The intervals of ascending points at which something holds, up to halfway to the others."""
    order = np.argsort(x)
    x, inside = x[order], inside[order]
    edges = np.concatenate([x[:1], 0.5 * (x[1:] + x[:-1]), x[-1:]])
    changes = np.flatnonzero(np.diff(np.concatenate([[False], inside, [False]]).astype(int)))
    return [(float(edges[a]), float(edges[b])) for a, b in changes.reshape(-1, 2)]


def overturning_figure(
    frequency_ratio: Array, tried: Array, overturned: Marks, undecided: Marks, least: Array
) -> Figure:
    """The least amplitude (n,) that overturns against the frequency (n,), over what was tried.

    ``overturned`` and ``undecided`` (n, m) are for each frequency and each amplitude tried (m,).
    """
    order = np.argsort(frequency_ratio)
    ratio = frequency_ratio[order]
    with style.figure_style():
        figure, ax = _panel()
        handles = [Patch(color=OVERTURNED, label="overturns")]
        if undecided.any():
            handles.append(Patch(color=UNDECIDED, label="not determined"))
        if len(ratio) > 1:
            ax.pcolormesh(
                ratio,
                tried,
                (overturned + 2.0 * undecided)[order].T,
                cmap=ListedColormap(["white", OVERTURNED, UNDECIDED]),
                vmin=0.0,
                vmax=2.0,
                shading="nearest",
                rasterized=True,
            )
        (line,) = ax.plot(
            ratio,
            least[order],
            ".-",
            color=style.SERIES[0],
            ms=3.0,
            label="least amplitude",
        )
        uplift = ax.axhline(1.0, color=style.CONTRAST, ls="--", lw=0.8, label="uplift")
        ax.set_yscale("log")
        ax.yaxis.set_major_formatter(lambda value, _: f"{value:g}")
        ax.set_ylim(min(0.9, tried.min()), tried.max())
        ax.set_xlim(ratio.min(), ratio.max())
        style.label(ax, "", "overturning spectrum", "$ω_p/p$", r"$a_p/(g\,\tan\,α)$")
        ax.legend(
            handles=[line, *handles, uplift],
            loc="upper left",
            frameon=True,
            framealpha=0.9,
            edgecolor="none",
        )
    return figure


LimitState = tuple["Counts", "LognormalCurve | None", float | None]
"""The data of a limit state, its curve, and its largest tilt over the balance tilt, or None."""

FRACTILES = (0.16, 0.5, 0.84)
"""The fractiles of the largest tilts: the median and, of a normal distribution, one deviation."""

TOPPLED = 1.3
"""Where the largest tilt of a body that overturned is drawn, over the balance tilt."""


def fragility_figure(
    counts: Counts, curve: LognormalCurve | None, label: str, limit: float | None = None
) -> Figure:
    """The fractions that overturned or reached a limit, and the curve with its median's interval.

    A curve of motions that share records also has the band of :meth:`rimroll.Fragility.band`. The
    unit of θ is what the label has in parentheses at its end.

    Trials of the same intensity are one point. Without a curve there are only the points.
    """
    with style.figure_style():
        figure, ax = _panel()
        _draw_states(ax, [(counts, curve, limit)], label)
        style.label(ax, "", "fragility", label, f"probability of {_event(limit)}")
    return figure


def incremental_figure(
    states: Sequence[LimitState], motions: Falls, intensity: np.ndarray, label: str
) -> Figure:
    """Fragility curves of limit states, and the largest tilt against the intensity.

    The second panel has a line for each record (incremental dynamic analysis): the columns of
    ``motions`` are over records and levels, as is ``intensity``. A body that overturned lies on the
    right edge, and one that is undecided is left out. Where all records have the same intensities,
    there are fractiles of the tilt at each.
    """
    with style.figure_style():
        figure = style.page(HEIGHT, 2.0 * WIDTH)
        one, other = figure.subplots(1, 2)
        _draw_states(one, states, label)
        only = states[0][2] if len(states) == 1 else None
        event = _event(only) if len(states) == 1 else "the limit state"
        style.label(one, "a", "fragility", label, f"probability of {event}")
        _draw_tilts(other, motions, intensity)
        for _, _, limit in states:
            other.axvline(limit or 1.0, color=style.CONTRAST, ls="--", lw=0.7)
        title = f"incremental, {len(intensity)} record{'s' * (len(intensity) > 1)}"
        style.label(other, "b", title, "largest tilt / balance tilt", label)
    return figure


def _event(limit: float | None) -> str:
    return "overturning" if limit is None else f"a tilt ≥ {limit:g} of the balance tilt"


def _draw_states(ax: Axes, states: Sequence[LimitState], label: str) -> None:
    every = np.concatenate([counts.intensity for counts, *_ in states])
    low, high = every.min(), every.max()
    margin = 0.08 * np.log(max(high / low, 1.01))
    x = np.exp(np.linspace(np.log(low) - margin, np.log(high) + margin, 300))
    unit = label[label.rindex("(") + 1 : -1] if label.endswith(")") and " (" in label else ""
    several = len(states) > 1
    for place, (counts, curve, limit) in enumerate(states):
        color = style.SERIES[place % len(style.SERIES)]
        words = f"{_short(limit)}: " if several else ""
        if curve is not None:
            if not several:
                _draw_intervals(ax, curve, x)
            ax.plot(x, curve(x), color=color, label=words + _parameters(curve, unit))
        intensity, fraction = _fractions(counts)
        ax.plot(
            intensity,
            fraction,
            "o",
            color=color if several else style.MEASURED,
            markerfacecolor="none",
            label=None if several and curve is not None else words + _motions(counts),
            alpha=0.7,
        )
    ax.set_xlim(x[0], x[-1])
    ax.set_ylim(-0.03, 1.03)
    ax.legend(loc="best")


def _short(limit: float | None) -> str:
    return "overturning" if limit is None else f"≥ {limit:g}"


def _draw_intervals(ax: Axes, curve: LognormalCurve, x: np.ndarray) -> None:
    """The band of a curve, and the interval of its median with the number of records."""
    if curve.without is not None:
        ax.fill_between(x, *curve.band(x), color=style.SERIES[0], alpha=0.15, lw=0.0)
    ends = np.clip(curve.median_interval, x[0], x[-1])
    of = "" if curve.records is None else f", {curve.records} records"
    words = f"{100.0 * curve.level:g} % interval of θ{of}"
    ax.plot(ends, [0.5, 0.5], "|-", color=style.THEORY, lw=0.9, label=words)


def _draw_tilts(ax: Axes, motions: Falls, intensity: np.ndarray) -> None:
    """The largest tilt of each record against the intensity, and fractiles over the records."""
    fell, undecided = (np.asarray(motions[name], bool) for name in ("overturned", "undecided"))
    ratio = np.where(fell, np.inf, np.asarray(motions["max_tilt_ratio"]))
    ratio[undecided] = np.nan
    for tilts, levels in zip(ratio, intensity, strict=True):
        order = np.argsort(levels)
        shown = np.minimum(tilts, TOPPLED)[order]
        ax.plot(
            shown,
            levels[order],
            ".-",
            color=style.CONTRAST,
            lw=0.5,
            ms=2.0,
            alpha=0.5,
            clip_on=False,
        )
    if np.allclose(intensity, intensity[0]) and len(ratio) > 1:
        for part, dashes in zip(FRACTILES, ("--", "-", ":"), strict=True):
            levels = [_fractile(column, part) for column in ratio.T]
            words = f"{100.0 * part:g} % fractile"
            ax.plot(levels, intensity[0], dashes, color=style.SERIES[0], label=words)
        ax.legend(loc="lower right")
    ax.set_xlim(0.0, TOPPLED)
    ax.set_xticks([0.0, 0.25, 0.5, 0.75, 1.0, TOPPLED], ["0", "0.25", "0.5", "0.75", "1", "fell"])


def _fractile(tilts: np.ndarray, part: float) -> float:
    """The least tilt that a part of the decided motions does not exceed; NaN without any."""
    known = np.sort(tilts[~np.isnan(tilts)])
    if not known.size:
        return float("nan")
    return float(min(known[max(0, int(np.ceil(part * len(known))) - 1)], TOPPLED))


def _fractions(counts: Counts) -> tuple[np.ndarray, np.ndarray]:
    """The intensities, and the fraction of the motions at each that is decided and overturned."""
    each, place = np.unique(counts.intensity, return_inverse=True)
    decided = np.bincount(place, counts.trials - counts.undecided)
    fell = np.bincount(place, counts.overturned)
    known = decided > 0.0
    return each[known], fell[known] / decided[known]


def _motions(counts: Counts) -> str:
    left_out = counts.undecided.sum()
    words = f"fraction of {counts.trials.sum() - left_out:.0f} motions"
    return f"{words}; {left_out:.0f} others undecided" if left_out else words


def _parameters(curve: LognormalCurve, unit: str) -> str:
    return f"θ = {curve.median:.3g} {unit}".rstrip() + f", β = {curve.dispersion:.2g}"


def maxima_figure(sample: Array, other: Array | None = None, distance: str = "") -> Figure:
    """Empirical distributions of the largest tilt over the balance tilt, of one or two samples.

    ``distance`` is the title where there are two.
    """
    with style.figure_style():
        figure, ax = _panel()
        samples = [(sample, style.SERIES[0], "-")]
        if other is not None:
            samples.append((other, style.SERIES[1], "--"))
        finite = [values[np.isfinite(values)] for values, *_ in samples]
        right = 1.1 * max((float(values.max()) for values in finite if values.size), default=1.0)
        for values, (every, color, dashes) in zip(finite, samples, strict=True):
            x = np.concatenate([[0.0], values, [right]])
            fractions = np.minimum(np.arange(len(x)), len(values)) / len(every)
            ax.step(x, fractions, where="post", color=color, ls=dashes)
        ax.set_ylim(0.0, 1.03)
        ax.set_xlim(0.0, right)
        title = "largest tilt"
        if other is not None:
            title = distance
            names = [Line2D([], [], color=c, ls=d) for _, c, d in samples]
            ax.legend(names, ["this sample", "the other"], loc="upper left")
        style.label(ax, "", title, "largest tilt / balance tilt", "fraction of the bodies")
    return figure
