"""The figures of a run: work against precision, and cost against how near the collision is."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from rimroll.figures import style

from .contestants import LAWS, Contestant
from .results import Results, Row, contestants, frontier

OURS = {
    "rimroll_quadrature": ("#0072B2", "*"),
    "rimroll_ensemble": ("#0072B2", "o"),
    "core_quadrature": ("#0072B2", "*"),
    "core_ensemble": ("#0072B2", "o"),
}
PEERS = {
    "heyoka_8_lanes": ("#D55E00", "s"),
    "heyoka": ("#D55E00", "D"),
    "boost_rkf78": ("#009E73", "^"),
    "boost_bulirsch_stoer": ("#009E73", "v"),
    "ode_solvers_dop853": ("#CC79A7", "P"),
    "diffsol_tsit45": ("#CC79A7", "X"),
    "numba_dop853": ("#E69F00", "<"),
    "diffrax_dopri8": ("#56B4E9", ">"),
    "scipy_dop853": ("#000000", "p"),
    "scipy_radau": ("#8A8A8A", "h"),
}
"""Colour by library, marker by method; filled in rimroll's coordinates, open and dashed for the
printed equations."""

NEAR = (*OURS, "heyoka_8_lanes", "boost_rkf78", "ode_solvers_dop853", "scipy_dop853")
NO_WORSE = 1e-8
"""Error (rad) up to which a turn counts as computed: ten times the target."""


def write(results: Results, folder: Path) -> None:
    with style.figure_style():
        for name, figure in (
            ("work_precision", work_precision(results.turns)),
            ("cost_against_eps", cost_against_eps(results.near)),
        ):
            for suffix in "svg", "png":
                style.save(figure, folder / f"{name}.{suffix}")


def look(one: Contestant) -> dict[str, Any]:
    color, marker = (OURS | PEERS)[one.method]
    printed = one.coordinates == "printed"
    return {
        "color": color,
        "marker": marker,
        "markersize": 9.0 if marker == "*" else 5.0 if one.is_ours else 3.8,
        "markerfacecolor": "white" if printed else color,
        "linestyle": "--" if printed else "-",
        "linewidth": 2.0 if one.is_ours else 0.7 if printed else 1.1,
        "zorder": 5 if one.is_ours else 3,
        # One entry for each method; another explains open and dashed.
        "label": one.name if not printed or one.method == "scipy_radau" else "_",
    }


def work_precision(rows: list[Row]) -> Figure:
    """Turns per second and core against the worst error, one panel for each law."""
    figure = style.page(115.0)
    panels = figure.subplots(1, 2, sharex=True, sharey=True)
    for ax, letter, (law, words) in zip(panels, "ab", LAWS.items(), strict=True):
        for one in drawn(rows):
            errors, costs = frontier(r for r in rows if r.key == one.key and r.law == law)
            if len(errors):
                ax.loglog(errors, 1.0 / costs, **look(one))
        style.label(
            ax, letter, f"a turn {words}", "worst error of 60 turns (rad)", "turns a second a core"
        )
        style.decades(ax.xaxis, ax.yaxis)
        ax.grid(True, color="#DDDDDD", linewidth=0.4)
    panels[0].invert_xaxis()
    panels[1].set_ylabel("")
    legend(figure, panels[0], columns=4)
    return style.settle(figure)


def cost_against_eps(rows: list[Row]) -> Figure:
    """Cost and error of a turn as the start approaches a face-down fall."""
    figure = style.page(150.0)
    panels = figure.subplots(2, 2, sharex=True, sharey="row")
    for column, (law, words) in zip(panels.T, LAWS.items(), strict=True):
        for one in drawn(rows, NEAR):
            mine = [row for row in rows if row.key == one.key and row.law == law]
            if mine:
                draw_near(column, one, sorted(mine, key=lambda row: -row.eps))
        column[0].set_title(f"a turn {words}", loc="left")
        column[1].set_xlabel("ε = yaw rate = spin rate at the release (rad/s)")
        for ax in column:
            style.decades(ax.xaxis, ax.yaxis)
            ax.grid(True, color="#DDDDDD", linewidth=0.4)
    panels[0, 0].invert_xaxis()
    panels[0, 0].set_ylabel("cost of a turn (µs of a core)")
    panels[1, 0].set_ylabel("worst error of 8 turns (rad)")
    legend(figure, panels[0, 0], columns=3)
    return style.settle(figure)


def draw_near(axes: np.ndarray, one: Contestant, rows: list[Row]) -> None:
    """Cost and error over eps; no cost where the turn was not computed."""
    eps = np.array([row.eps for row in rows])
    errors = np.array([row.worst for row in rows])
    costs = np.array([1e6 * row.seconds for row in rows])
    axes[0].loglog(eps, np.where(errors <= NO_WORSE, costs, np.nan), **look(one))
    shown = np.where(np.isfinite(errors), np.maximum(errors, 1e-16), np.nan)
    axes[1].loglog(eps, shown, **look(one))


def drawn(rows: list[Row], methods: tuple[str, ...] = (*OURS, *PEERS)) -> list[Contestant]:
    """The rows that are drawn; of rimroll's two, that called from Python."""
    here = [one for one in contestants(rows) if one.method in methods]
    names = {one.method for one in here}
    return [
        one for one in here if one.method.replace("core_", "rimroll_") not in names - {one.method}
    ]


def legend(figure: Figure, ax: Axes, columns: int) -> None:
    handles, labels = ax.get_legend_handles_labels()
    grey: dict[str, Any] = {"color": style.CONTRAST, "marker": "o", "linewidth": 0.9}
    handles += [
        Line2D([], [], **grey),
        Line2D([], [], **grey, linestyle="--", markerfacecolor="white"),
    ]
    labels += ["filled: in our coordinates", "open: the printed equations"]
    figure.legend(handles, labels, loc="outside lower center", ncols=columns)
