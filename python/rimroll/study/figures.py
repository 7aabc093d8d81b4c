"""Figures of a finished or partial study: maps, curves and histograms."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.axis import Axis
from matplotlib.figure import Figure
from matplotlib.ticker import LogLocator, NullFormatter

from rimroll.errors import RimrollError, nearest
from rimroll.figures import style
from rimroll.study.columns import TRIAL
from rimroll.study.quantities import (
    HISTOGRAM,
    at,
    is_number,
    label_of,
    mean,
    names,
    quantity_of,
    words_on_axis,
)

if TYPE_CHECKING:
    import xarray as xr

FORMS = ("map", "curve", "histogram")

MAX_PANELS = 12
MAX_LINES = 8
BINS = 60

COUNT = "count"
"""What a histogram shows: motions, or fits."""

PANEL = 44.0
"""The height of a panel, mm."""


def study_figure(
    dataset: xr.Dataset,
    quantities: Sequence[str] = (),
    *,
    along: Sequence[str] = (),
    places: Mapping[str, str] | None = None,
    form: str | None = None,
) -> Figure:
    """Draw a study.

    Raises ``RimrollError`` for unknown names, and for forms that the quantities do not have.

    Parameters
    ----------
    dataset
        A finished or partial study; rows that are not done are left out.
    quantities
        One or two, as :func:`rimroll.study.quantities.quantity_of` names them. By default the first
        that the study has; two are drawn against each other.
    along
        The dimensions of the axes; by default the last ones whose labels are numbers. What is not
        drawn along an axis or in panels of its own is averaged if it is the trials; of the others
        the middle value is taken, and the title says which. For a histogram in place of the rows,
        the dimension of its panels.
    places
        Values of dimensions at which the study is drawn.
    form
        ``map``, ``curve`` or ``histogram``; by default a map over two dimensions, a curve over
        one, and a histogram of trials.
    """
    if form is not None and form not in FORMS:
        raise RimrollError(f"unknown form {form!r}{nearest(form, FORMS)}")
    chosen = list(quantities) or names(dataset)[:1]
    if not chosen:
        raise RimrollError("the study holds nothing to draw")
    if len(chosen) > 2:
        raise RimrollError(f"give one or two quantities, got {len(chosen)}")
    if form == "histogram" and f"{chosen[0]}{HISTOGRAM}" in dataset:
        with style.figure_style():
            return _kept_histogram(dataset, chosen[0], along, places or {})
    arrays = [at(quantity_of(dataset, name), places or {}) for name in chosen]
    with style.figure_style():
        if len(arrays) == 2:
            return _against(*arrays)
        if form == "histogram" or set(arrays[0].dims) <= {TRIAL}:
            return _histogram(arrays[0])
        return _over(arrays[0], along, form)


def _over(array: xr.DataArray, along: Sequence[str], form: str | None) -> Figure:
    """Maps or curves, in panels."""
    array = mean(array, [dim for dim in array.dims if dim == TRIAL and TRIAL not in along])
    dims = [str(dim) for dim in array.dims]
    for dim in along:
        if dim not in dims:
            raise RimrollError(f"unknown dimension {dim!r}{nearest(dim, dims)}")
    numeric = [dim for dim in dims if is_number(label_of(array, dim)) and array.sizes[dim] > 1]
    axes = list(along) or numeric[-1 if form == "curve" else -2 :]
    if not axes:
        return _bars(array)
    if form == "map" and len(axes) != 2:
        raise RimrollError(f"a map has two dimensions, this study has {', '.join(dims)}")
    width = 1 if form == "curve" else min(len(axes), 2)
    axes = axes[-width:]
    rest = [dim for dim in dims if dim not in axes]
    # A curve has lines for the last of the other dimensions, and panels for what has words.
    lines = rest.pop() if width == 1 and rest else None
    panels = next((dim for dim in rest if not is_number(label_of(array, dim))), None)
    panels = panels or (rest[0] if rest else None)
    array, fixed = _middle(array, [dim for dim in rest if dim != panels])
    parts = [("", array)] if panels is None else _slices(array, panels, MAX_PANELS)
    own = panels is not None and not is_number(label_of(array, panels))
    figure, every = _page(len(parts), share_y=width == 2 or not own)
    reach = _reach(array)
    for k, ((title, part), ax) in enumerate(zip(parts, every, strict=True)):
        if width == 2:
            image = _map(ax, part, axes, _reach(part) if own else reach)
            if own:
                figure.colorbar(image, ax=ax, pad=0.02)
        else:
            _curves(ax, part, axes[0], lines, legend=k == 0)
        ax.set_title(title, loc="left")
    if width == 2 and not own:
        figure.colorbar(image, ax=every, pad=0.02, label=words_on_axis(array))
    above = ", ".join(filter(None, [words_on_axis(array) if width == 2 and own else "", fixed]))
    if above:
        figure.suptitle(above, fontsize=8)
    return figure


def _reach(array: xr.DataArray) -> tuple[float, float]:
    """The ends of a colour scale: those of the numbers, but not closer than 1 % of them."""
    low, high = float(array.min()), float(array.max())
    least = 0.005 * max(abs(low), abs(high))
    middle = 0.5 * (low + high)
    return min(low, middle - least), max(high, middle + least)


def _page(panels: int, share_y: bool = True) -> tuple[Figure, list[Axes]]:
    across = 1 if panels == 1 else 2 if panels in (2, 4) else min(3, panels)
    down = -(-panels // across)
    size = (74.0, 110.0) if panels == 1 else (PANEL * down + 12.0, style.PAGE_WIDTH)
    figure = style.page(*size)
    every = figure.subplots(down, across, sharex=True, sharey=share_y, squeeze=False).ravel()
    for ax in every[panels:]:
        ax.set_visible(False)
    for ax in every[max(0, panels - across) : panels]:  # those below which there is none
        ax.tick_params(labelbottom=True)
    return figure, list(every[:panels])


def _map(ax: Axes, part: xr.DataArray, axes: Sequence[str], reach: tuple[float, float]) -> Any:
    y, x = axes
    part = part.transpose(y, x)
    across, up = label_of(part, x), label_of(part, y)
    image = ax.pcolormesh(
        across.values,
        up.values,
        part.values,
        shading="nearest",
        cmap="viridis",
        vmin=reach[0],
        vmax=reach[1],
        rasterized=True,
    )
    if _is_logarithmic(across.values):
        ax.set_xscale("log")
        _write_plainly(ax.xaxis)
    if _is_logarithmic(up.values):
        ax.set_yscale("log")
        _write_plainly(ax.yaxis)
    _label(ax, words_on_axis(across), words_on_axis(up))
    return image


def _write_plainly(axis: Axis) -> None:
    """Ticks of a logarithmic axis at 1, 2, 5, 10, ... in plain numbers."""
    axis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
    axis.set_major_formatter(lambda value, _: f"{value:g}")
    axis.set_minor_formatter(NullFormatter())


def _curves(ax: Axes, part: xr.DataArray, x: str, lines: str | None, *, legend: bool) -> None:
    along = label_of(part, x)
    every = [("", part)] if lines is None else _slices(part, lines, MAX_LINES)
    colors = style.SERIES if len(every) <= len(style.SERIES) else _shades(len(every))
    for (name, one), color in zip(every, colors, strict=False):
        ax.plot(along.values, one.values, ".-", ms=2.5, color=color, label=name)
    if _is_logarithmic(along.values):
        ax.set_xscale("log")
        _write_plainly(ax.xaxis)
    if len(every) > 1 and legend:
        ax.legend()
    _label(ax, words_on_axis(along), words_on_axis(part))


def _shades(count: int) -> list[Any]:
    import matplotlib as mpl

    return list(mpl.colormaps["viridis"](np.linspace(0.0, 0.9, count)))


def _bars(array: xr.DataArray) -> Figure:
    """A quantity over words."""
    (dim, *more) = [str(one) for one in array.dims]
    array, _ = _middle(array, more)
    figure, (ax,) = _page(1)
    words = [str(one) for one in label_of(array, dim).values]
    ax.barh(words[::-1], array.values[::-1], color=style.SERIES[0])
    _label(ax, words_on_axis(array), "")
    return figure


def _histogram(array: xr.DataArray) -> Figure:
    values = array.values[np.isfinite(array.values)].ravel()
    figure, (ax,) = _page(1)
    ax.hist(values, bins=min(BINS, max(5, values.size // 5)), color=style.SERIES[0])
    _label(ax, words_on_axis(array), COUNT)
    return figure


def _kept_histogram(
    dataset: xr.Dataset, name: str, along: Sequence[str], places: Mapping[str, str]
) -> Figure:
    """A histogram that was kept in place of the rows, over all groups, or with panels for some."""
    counts = at(dataset[f"{name}{HISTOGRAM}"], places)
    bins = f"{name}_bin"
    dims = [str(dim) for dim in counts.dims if dim != bins]
    if len(along) > 1 or not set(along) <= set(dims):
        raise RimrollError(f"panels are along one dimension of {', '.join(dims)}, got {along[-1]}")
    long_name = str(counts.attrs.get("long_name", name)).removeprefix("histogram: ")
    centres = label_of(counts, bins).assign_attrs(long_name=long_name)
    total = counts.where(counts >= 0).sum([dim for dim in dims if dim not in along])
    parts = [("", total)] if not along else _slices(total, along[0], MAX_PANELS)
    figure, every = _page(len(parts))
    width = float(centres.values[1] - centres.values[0]) if len(centres) > 1 else 1.0
    for (title, part), ax in zip(parts, every, strict=True):
        ax.bar(centres.values, part.values, width=width, color=style.SERIES[0])
        ax.set_title(title, loc="left")
        _label(ax, words_on_axis(centres), COUNT)
    return figure


def _against(x: xr.DataArray, y: xr.DataArray) -> Figure:
    """Two quantities of the same rows, as numbers of rows in cells."""
    if set(x.dims) != set(y.dims):
        raise RimrollError(f"{x.name} and {y.name} have different dimensions")
    across, up = x.values.ravel(), y.transpose(*x.dims).values.ravel()
    there = np.isfinite(across) & np.isfinite(up)
    figure, (ax,) = _page(1)
    *_, image = ax.hist2d(across[there], up[there], bins=BINS, cmin=1, cmap="viridis")
    figure.colorbar(image, ax=ax, label=COUNT)
    _label(ax, words_on_axis(x), words_on_axis(y))
    return figure


def _slices(array: xr.DataArray, dim: str, most: int) -> list[tuple[str, xr.DataArray]]:
    """Some places along a dimension, evenly taken, with what they are."""
    size = array.sizes[dim]
    taken = np.unique(np.linspace(0, size - 1, min(size, most)).round().astype(int))
    labels = label_of(array, dim)
    return [(_place(labels, k), array.isel({dim: k})) for k in taken.tolist()]


def _middle(array: xr.DataArray, dims: Sequence[str]) -> tuple[xr.DataArray, str]:
    """An array at the middle of dimensions, and where that is."""
    places = []
    for dim in dims:
        middle = array.sizes[dim] // 2
        places.append(_place(label_of(array, dim), middle))
        array = array.isel({dim: middle})
    return array, ", ".join(places)


def _place(labels: xr.DataArray, k: int) -> str:
    value = labels.values[k]
    if not is_number(labels):
        return str(value).replace("_", " ")
    unit = labels.attrs.get("units", "")
    name = str(labels.name).replace("_", " ")
    return f"{name} {value:.4g}{'' if unit == '°' else ' '}{unit}".rstrip()


def _is_logarithmic(values: Any) -> bool:
    """Whether numbers are spaced by a factor over half a decade or more."""
    numbers = np.asarray(values, np.float64)
    if len(numbers) < 4 or not (numbers > 0.0).all():
        return False
    ratios, steps = np.diff(np.log(numbers)), np.diff(numbers)
    even = np.ptp(ratios) < 1e-6 * abs(ratios).max()
    return bool(even and np.ptp(steps) > 1e-6 * abs(steps).max() and abs(ratios.sum()) > 1.1)


def _label(ax: Axes, x: str, y: str) -> None:
    spec = ax.get_subplotspec()
    if any(label.get_visible() for label in ax.get_xticklabels()):
        ax.set_xlabel(x)
    if spec is None or spec.is_first_col():
        ax.set_ylabel(y)
