"""Paints shapes and words into a picture in pixels, with smooth edges.

Pillow draws hard edges. So shapes are drawn several times as large and made smaller again, which
averages over the parts of a pixel, in a box no larger than the shape.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from importlib.util import find_spec
from math import ceil
from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw, ImageFont

from rimroll.figures.scene import Array

FINE = 3
"""Shapes are drawn this many times larger: a pixel has nine parts."""

Box = tuple[int, int, int, int]
"""Left, top, right and bottom of a part of a picture, pixels."""


class Painter:
    """Paints on a picture (RGB); places are (x, y), pixels to the right and down from a corner."""

    def __init__(self, picture: Image.Image) -> None:
        self.picture = picture

    def facets(self, polygons: Array, colors: Array) -> None:
        """Paint polygons (n, c, 2), each over the previous ones, in colours (n, 3) from 0 to 1."""
        box = _box(polygons, self.picture)
        if box is None:
            return
        piece = self.picture.resize(_fine_size(box), Image.Resampling.NEAREST, box)
        draw = ImageDraw.Draw(piece)
        inks = np.rint(255.0 * colors).astype(int).tolist()
        corners = (FINE * (polygons - box[:2])).reshape(len(polygons), -1).tolist()
        for polygon, ink in zip(corners, inks, strict=True):
            draw.polygon(polygon, tuple(ink))
        self.picture.paste(piece.reduce(FINE), box)

    def layers(self, polygons: Array, color: str, opacity: float) -> None:
        """Paint polygons (n, c, 2) in one translucent colour, each inside the one before."""
        box = _box(polygons, self.picture)
        if box is None:
            return
        mask = Image.new("L", _fine_size(box))
        draw = ImageDraw.Draw(mask)
        through = 1.0
        for polygon in polygons:
            through *= 1.0 - opacity
            draw.polygon(_fine(polygon, box), round(255.0 * (1.0 - through)))
        self.picture.paste(color, box, mask.reduce(FINE))

    def line(self, line: Array, width: float, color: str, opacity: float = 1.0) -> None:
        """Paint a line through points (n, 2), ``width`` pixels wide."""
        box = _box(line, self.picture, 1.0 + width)
        if box is None:
            return
        mask = Image.new("L", _fine_size(box))
        draw = ImageDraw.Draw(mask)
        draw.line(_fine(line, box), round(255.0 * opacity), ceil(FINE * width))
        self.picture.paste(color, box, mask.reduce(FINE))

    def trail(self, trail: Trail, color: str, opacity: float = 1.0) -> None:
        """Paint the part of a trail that has been drawn so far."""
        if trail.box is not None:
            mask = trail.mask.crop(trail.box)
            faded = mask if opacity == 1.0 else mask.point(_faded(opacity))
            self.picture.paste(color, trail.box, faded)

    def spot(self, place: Array, size: float, edge: float, color: str, opacity: float) -> None:
        """Paint a disk with a white edge; ``size`` is its diameter to the middle of the edge."""
        inner, outer = 0.5 * (size - edge), 0.5 * (size + edge)
        box = _box(place, self.picture, 1.0 + outer)
        if box is None:
            return
        level = round(255.0 * opacity)
        for paint, disks in (
            ("white", ((outer, level), (inner, 0))),
            (color, ((inner, level),)),
        ):
            mask = Image.new("L", _fine_size(box))
            draw = ImageDraw.Draw(mask)
            for radius, shade in disks:
                draw.ellipse(_fine(np.array([place - radius, place + radius]), box), shade)
            self.picture.paste(paint, box, mask.reduce(FINE))

    def words(
        self, place: Sequence[float], text: str, size: float, color: str, anchor: str, halo: float
    ) -> None:
        """Write text ``size`` pixels high, with a white ``halo`` of that width; anchors as in
        Pillow.

        A text with a halo has one line.
        """
        draw, x, y = ImageDraw.Draw(self.picture), float(place[0]), float(place[1])
        if halo > 0.0:
            style = {"stroke_width": halo, "stroke_fill": "white"}
            draw.text((x, y), text, color, _font(size), anchor, **style)  # type: ignore[arg-type]
        else:
            draw.multiline_text((x, y), text, color, _font(size), anchor)


class Trail:
    """A line that grows from picture to picture; only what is new is drawn."""

    def __init__(self, path: Array, width: float, size: tuple[int, int]) -> None:
        self._path, self._width = path, width
        self._fine = Image.new("L", (FINE * size[0], FINE * size[1]))
        self._done = 0
        self.mask = Image.new("L", size)
        """Which part of each pixel it covers so far."""
        self.box: Box | None = None
        """Its box so far."""

    def go_to(self, last: int) -> None:
        """Reach the point numbered ``last``."""
        if last < self._done:
            self._done, self.box = 0, None
            for image in (self._fine, self.mask):
                image.paste(0, (0, 0, *image.size))
        new = self._path[self._done : last + 1]
        box = _box(new, self.mask, 1.0 + self._width)
        self._done = last
        if box is None:
            return
        draw = ImageDraw.Draw(self._fine)
        whole = (0, 0, *self.mask.size)
        draw.line(_fine(new, whole), 255, ceil(FINE * self._width))
        reach = 0.5 * self._width
        for end in (new[0], new[-1]):
            draw.ellipse(_fine(np.array([end - reach, end + reach]), whole), 255)
        left, top, right, bottom = (FINE * side for side in box)
        self.mask.paste(self._fine.reduce(FINE, (left, top, right, bottom)), box)
        self.box = box if self.box is None else _both(self.box, box)


def _box(points: Array, picture: Image.Image, margin: float = 1.0) -> Box | None:
    """The part of a picture that holds all points (..., 2); None if it is empty."""
    flat = points.reshape(-1, 2)
    left, top = np.floor(flat.min(axis=0) - margin).astype(int).tolist()
    right, bottom = np.ceil(flat.max(axis=0) + margin).astype(int).tolist()
    box = (max(left, 0), max(top, 0), min(right, picture.width), min(bottom, picture.height))
    return box if box[0] < box[2] and box[1] < box[3] else None


def _both(one: Box, other: Box) -> Box:
    low = [min(pair) for pair in zip(one[:2], other[:2], strict=True)]
    high = [max(pair) for pair in zip(one[2:], other[2:], strict=True)]
    return low[0], low[1], high[0], high[1]


def _fine_size(box: Box) -> tuple[int, int]:
    return FINE * (box[2] - box[0]), FINE * (box[3] - box[1])


def _fine(points: Array, box: Box) -> list[float]:
    """Points (n, 2) as x, y, x, y, ... in the enlarged box; Pillow cuts off the fractions."""
    found: list[float] = (FINE * (points - box[:2])).ravel().tolist()
    return found


@cache
def _faded(opacity: float) -> list[int]:
    return [round(opacity * level) for level in range(256)]


@cache
def _font(size: float) -> ImageFont.FreeTypeFont:
    """DejaVu Sans, the font of the figures, at a height in pixels.

    It is read from matplotlib, which brings it and which rimroll needs anyway. matplotlib is not
    imported, which would take a twentieth of the time of a film.
    """
    matplotlib = find_spec("matplotlib")
    assert matplotlib is not None
    assert matplotlib.origin is not None
    fonts = Path(matplotlib.origin).parent / "mpl-data" / "fonts" / "ttf"
    return ImageFont.truetype(fonts / "DejaVuSans.ttf", size)
