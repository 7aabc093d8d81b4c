"""Draws the scene in vectors on matplotlib axes, which hold metres as the camera sees them.

Every ``draw_...`` function returns the artists it added, in drawing order.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.patheffects import withStroke

from rimroll.figures import scene
from rimroll.figures.scene import Array, Camera, Pose, Profile, RoundBody


def draw_body(
    ax: Axes,
    body: RoundBody,
    pose: Pose,
    camera: Camera,
    *,
    fade: float = 0.0,
    shadow: bool = True,
    zorder: float = 3.0,
) -> list[Artist]:
    """Draw the body, with its shadow on the table and the rim of its base.

    ``fade`` from 0 to 1 makes the body paler, so that text drawn over it can be read.
    """
    profile = Profile.of(body)
    artists = _draw_shadow(ax, body, pose, camera, profile) if shadow else []
    polygons, colors = scene.visible_facets(body, pose, camera, profile)
    paint = PolyCollection(
        polygons,  # type: ignore[arg-type]  # one array, which is quicker than many
        facecolors=colors + fade * (1.0 - colors),
        edgecolors="face",
        linewidths=0.75,
        zorder=zorder,
    )
    artists.append(ax.add_collection(paint, autolim=False))
    return artists + _draw_rim(ax, body, pose, camera, zorder=zorder + 0.1)


def _draw_shadow(
    ax: Axes, body: RoundBody, pose: Pose, camera: Camera, profile: Profile
) -> list[Artist]:
    shade = PolyCollection(
        scene.shadow_layers(body, pose, camera, profile),  # type: ignore[arg-type]
        facecolors=(*scene.rgb(scene.SHADOW), scene.SHADE),
        linewidths=0,
        zorder=1.0,
    )
    return [ax.add_collection(shade, autolim=False)]


def _draw_rim(ax: Axes, body: RoundBody, pose: Pose, camera: Camera, zorder: float) -> list[Artist]:
    stretches = scene.rim_stretches(body, pose, camera)
    ink = scene.rgb(scene.INK)
    rim = LineCollection(
        [line for line, _ in stretches],
        colors=[(*ink, scene.RIM if seen else scene.HIDDEN_RIM) for _, seen in stretches],
        linewidths=scene.RIM_WIDTH,
        zorder=zorder,
    )
    return [ax.add_collection(rim, autolim=False)]


def draw_contact(
    ax: Axes, body: RoundBody, pose: Pose, camera: Camera, *, color: str = scene.VERMILLION
) -> list[Artist]:
    """Mark the contact point, dimmed when the body hides it."""
    alpha = 1.0 if scene.contact_seen(body, pose, camera) else scene.HIDDEN_CONTACT
    return draw_point(ax, camera, pose.contact(body), color=color, alpha=alpha)


def draw_table(
    ax: Axes, camera: Camera, *, center: tuple[float, float], radius: float
) -> list[Artist]:
    """Draw the table as a round patch of ``radius`` (m) that fades out toward its edge."""
    rings, colors = scene.table_rings(camera, center, radius)
    table = PolyCollection(list(rings), facecolors=colors, linewidths=0, zorder=0.0)
    return [ax.add_collection(table, autolim=False)]


def draw_point(
    ax: Axes,
    camera: Camera,
    spot: Sequence[float] | Array,
    *,
    color: str = scene.VERMILLION,
    size: float = scene.CONTACT_SIZE,
    alpha: float = 1.0,
    zorder: float = 5.0,
) -> list[Artist]:
    """Mark a point (x, y) or (x, y, z), m; usually the contact point."""
    x, y = camera.project(np.array([*spot, 0.0][:3]))
    edge = {"mec": "white", "mew": scene.CONTACT_EDGE}
    style: dict[str, Any] = {"marker": "o", "ms": size, "ls": "none", **edge}
    return list(ax.plot(x, y, color=color, alpha=alpha, zorder=zorder, **style))


def draw_wedge(
    ax: Axes,
    camera: Camera,
    center: Sequence[float] | Array,
    radius: float,
    start: float,
    turn: float,
    *,
    color: str = scene.ORANGE,
    fontsize: float = 9.0,
    label_at: float = 1.0,
    zorder: float = 1.5,
) -> list[Artist]:
    """Draw an angle on the table, as :func:`rimroll.figures.scene.wedge` gives it."""
    wedge = scene.wedge(camera, center, radius, start, turn, label_at)
    fill = PolyCollection(
        [wedge.sector],
        facecolors=(*scene.rgb(color), scene.WEDGE),
        linewidths=0,
        zorder=zorder,
    )
    artists: list[Artist] = [ax.add_collection(fill, autolim=False)]
    artists += ax.plot(*wedge.arc.T, color=color, lw=scene.ARC_WIDTH, zorder=zorder + 0.01)
    far = scene.label_offset(fontsize)
    style = {"color": scene.INK, "size": fontsize}
    return artists + write_beside(
        ax, camera, wedge.text, wedge.spot, wedge.azimuth, far=far, **style
    )


def write_beside(
    ax: Axes,
    camera: Camera,
    text: str,
    spot: Array,
    azimuth: float,
    *,
    far: tuple[float, float],
    **style: Any,
) -> list[Artist]:
    """Write beside a spot (x, y) of the table, toward ``azimuth``; ``far`` (x, y) in points."""
    x, y = camera.project(scene.on_table(spot))
    right, up = scene.way_in_picture(camera, azimuth)
    words = ax.annotate(
        text,
        (float(x), float(y)),
        (far[0] * right, far[1] * up),
        textcoords="offset points",
        ha="center",
        va="center_baseline",
        zorder=6.0,
        path_effects=[withStroke(linewidth=2.0, foreground="white", alpha=0.85)],
        **style,
    )
    return [words]
