"""The figure of a motion of a body with corners."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from rimroll.figures.scene.shape import BLUE, GREEN, INK, VERMILLION

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from rimroll.polygon.motion import PolygonMotion


def polygon_figure(motion: PolygonMotion) -> Figure:
    """Tilt, yaw and energy over time, and the way of the supporting corner on the table."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(8.0, 5.2), layout="constrained")
    (tilt, yaw), (energy, path) = figure.subplots(2, 2)
    fine = motion.samples(8)
    for axes, values, label in (
        (tilt, np.degrees(fine.tilt), "tilt (°)"),
        (yaw, np.degrees(fine.yaw), "yaw (°)"),
        (energy, 1e3 * fine.energy, "energy (mJ)"),
    ):
        axes.plot(fine.t, values, color=BLUE, lw=1.2)
        axes.set(xlabel="time (s)", ylabel=label)
    struck = np.array([event.t for event in motion.impacts])
    angles = np.degrees([event.state.tilt for event in motion.impacts])
    tilt.plot(struck, angles, ".", color=VERMILLION, ms=4, label=f"{len(struck)} impacts")
    if len(struck):
        tilt.legend(frameon=False)
    # The face has no corner of its own to show.
    standing = motion.phases[-1].kind == "face"
    supports = fine.contact_path[: -1 if standing else None]
    path.plot(*(1e3 * fine.center[:, :2].T), color=GREEN, lw=1.0, label="centre of mass")
    path.plot(*(1e3 * supports.T), ".-", color=VERMILLION, lw=0.6, ms=4, label="support")
    path.set(xlabel="x (mm)", ylabel="y (mm)", aspect="equal")
    path.legend(frameon=False, fontsize="small", loc="center left", bbox_to_anchor=(1.0, 0.5))
    figure.suptitle(
        f"{motion.body.corners} corners, {motion.law!r}: {motion.message_in_degrees}",
        fontsize="medium",
        color=INK,
    )
    return figure
