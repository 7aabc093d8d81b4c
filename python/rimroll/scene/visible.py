"""The parts of a body that a camera sees: facets, rim and contact point."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import numpy.typing as npt

from rimroll.scene.camera import Camera
from rimroll.scene.pose import Array, Pose, RoundBody, corner_ways
from rimroll.scene.shape import Profile, mesh


def visible_facets(
    body: RoundBody, pose: Pose, camera: Camera, profile: Profile
) -> tuple[Array, Array]:
    """Facets that face the eye, far to near: polygons (n, 4, 2) in the picture, colours (n, 3)."""
    shape = mesh(profile)
    corners = pose.place(shape.corners, body)
    normals = shape.normals @ pose.rotation().T
    middle = corners.mean(axis=1)
    sight = camera.sight(middle)
    seen = np.flatnonzero(np.einsum("ij,ij->i", normals, sight) > 0.0)
    seen = seen[np.argsort(camera.depth(middle[seen]), kind="stable")]
    lamps = camera.light(), camera.light(np.radians(20.0))
    colors = _lit(shape.colors[seen], normals[seen], sight[seen], *lamps)
    return camera.project(corners[seen]), colors


def _lit(colors: Array, normals: Array, sight: Array, lamp: Array, window: Array) -> Array:
    """Lambert's law for a lamp and a uniform sky, with the reflection of a low window."""
    lambert = np.clip(normals @ lamp, 0.0, None)
    sky = 0.6 + 0.06 * normals[:, 2]
    half = window + sight
    half = half / np.linalg.norm(half, axis=-1, keepdims=True)
    gleam = 0.2 * np.clip(np.einsum("ij,ij->i", normals, half), 0.0, None) ** 28
    return np.asarray(np.clip(colors * (sky + 0.5 * lambert)[:, None] + gleam[:, None], 0.0, 1.0))


def rim_stretches(body: RoundBody, pose: Pose, camera: Camera) -> list[tuple[Array, bool]]:
    """The rim of the base as lines (n, 2), and whether each is seen or behind the body."""
    points, outward = _rim(body)
    ring = pose.place(points, body)
    seen = rim_seen(outward @ pose.rotation().T, ring, pose, camera)
    flat = camera.project(ring)
    firm = seen[1:] & seen[:-1]
    # Each stretch is one line, so that a faint one has no dark joints.
    ends = [0, *(np.flatnonzero(firm[1:] != firm[:-1]) + 1).tolist(), len(firm)]
    return [(flat[start : end + 1], bool(firm[start])) for start, end in pairwise(ends)]


def _rim(body: RoundBody) -> tuple[Array, Array]:
    """Points (n, 3) once round the rim, from the base's centre, m, and outward unit vectors."""
    corners = corner_ways(body)
    if corners is None:
        angle = np.linspace(0.0, 2.0 * np.pi, 121)
        way = np.stack([np.cos(angle), np.sin(angle), np.zeros_like(angle)], axis=-1)
        return body.radius * way, way
    share = np.linspace(0.0, 1.0, 12)[:, None]
    ends = list(zip(corners, np.roll(corners, -1, axis=0), strict=True))
    points = np.concatenate([(1.0 - share) * one + share * other for one, other in ends])
    middles = np.array([one + other for one, other in ends])
    outward = middles / np.linalg.norm(middles, axis=1, keepdims=True)
    return body.radius * points, np.repeat(outward, len(share), axis=0)


def rim_seen(
    outward: Array, ring: Array, pose: Pose, camera: Camera, limb: float = 0.0
) -> npt.NDArray[np.bool_]:
    """Whether the camera sees points ``ring`` (n, 3) of the rim, where the wall faces ``outward``.

    Points count as seen as far as ``limb`` (sine of an angle) behind the body's edge.
    """
    sight = camera.sight(ring)
    wall = np.einsum("ij,ij->i", outward, sight)
    return np.asarray((wall > -1e-9 - limb) | (sight @ -pose.axes()[2] > 0.0))


def contact_seen(body: RoundBody, pose: Pose, camera: Camera) -> bool:
    """Whether the camera sees the contact point; else the body hides it."""
    spot = pose.contact(body)[None]
    outward = (spot - pose.base_center(body)) / body.radius
    return bool(rim_seen(outward, spot, pose, camera, limb=0.25)[0])
