"""A strip below a film: the acceleration of the ground, with the present moment marked."""

from __future__ import annotations

import numpy as np
from PIL import Image

from rimroll import scene
from rimroll.animation.painter import Painter
from rimroll.animation.stage import LABEL, POINT
from rimroll.ground.ground import Ground
from rimroll.scene import Array

COLORS = (scene.BLUE, scene.ORANGE, scene.GREEN)
TO_COME = 0.3  # opacity of what is still to come


class Strip:
    """The record of a ground from t = 0 to ``end`` (s) in a picture of ``size`` pixels."""

    def __init__(self, ground: Ground, end: float, size: tuple[int, int]) -> None:
        self.size = size
        width, height = size
        self._left, self._right = 0.035 * width, 0.965 * width
        self._end = end
        self._top, self._bottom = POINT * LABEL * 1.7, height - POINT * LABEL * 1.6
        self._curves(ground)
        self.past, self.to_come = self._painted(1.0), self._painted(TO_COME)

    def _curves(self, ground: Ground) -> None:
        lines = ground._lines
        last = max(self._end, float(lines.t[-1]))
        t = np.concatenate([lines.t, [lines.t[-1], last]])
        values = np.concatenate([lines.acceleration, np.zeros((2, 3))])
        self._peaks = np.abs(values[t <= self._end]).max(axis=0)
        largest = float(self._peaks.max()) or 1.0
        middle, half = 0.5 * (self._top + self._bottom), 0.5 * (self._bottom - self._top)
        x, y = self._place(t), middle - half * values / largest
        shown = np.searchsorted(t, self._end, side="right") + 1
        self.curves = [
            (color, extremes(x[:shown], y[:shown, axis]))
            for axis, color in enumerate(COLORS)
            if self._peaks[axis] > 0.0
        ]
        self._middle = middle

    def _place(self, t: Array | float) -> Array:
        """Where times are, pixels from the left."""
        return np.asarray(self._left + (self._right - self._left) * np.asarray(t) / self._end)

    def _painted(self, opacity: float) -> Image.Image:
        picture = Image.new("RGB", self.size, "white")
        painter = Painter(picture)
        axis = np.array([[self._left, self._middle], [self._right, self._middle]])
        painter.line(axis, 0.5 * POINT, scene.INK, 0.4)
        for color, curve in self.curves:
            painter.line(curve, 0.8 * POINT, color, opacity)
        # What runs beyond the end is covered.
        picture.paste("white", (round(self._right) + 2, 0, *self.size))
        self._write(painter)
        return picture

    def _write(self, painter: Painter) -> None:
        size = POINT * LABEL
        x = self._left
        head = "ground acceleration:" if self._peaks.any() else "the ground is at rest"
        painter.words((x, 0.1 * size), head, size, scene.INK, "la", 0.0)
        x += 0.57 * size * len(head)
        for axis, color, peak in zip("xyz", COLORS, self._peaks, strict=True):
            if peak > 0.0:
                text = f"{axis} ≤ {peak:.3g}"
                painter.words((x, 0.1 * size), text, size, color, "la", 0.0)
                x += 0.62 * size * (len(text) + 1)
        if self._peaks.any():
            painter.words((x, 0.1 * size), "m/s²", size, scene.INK, "la", 0.0)
        below = self.size[1] - 0.25 * size
        for x, text, anchor in (
            (self._left, "0", "ls"),
            (self._right, f"{self._end:.3g} s", "rs"),
        ):
            painter.words((x, below), text, size, scene.INK, anchor, 0.0)

    def at(self, t: float) -> Image.Image:
        """The strip at a time, s: what is still to come is pale."""
        picture = self.to_come.copy()
        x = float(self._place(min(max(t, 0.0), self._end)))
        whole = round(x)
        picture.paste(self.past.crop((0, 0, whole, self.size[1])), (0, 0))
        painter = Painter(picture)
        mark = np.array([[x, self._top - 2.0], [x, self._bottom + 2.0]])
        painter.line(mark, 1.2 * POINT, scene.VERMILLION)
        return picture


def extremes(x: Array, y: Array) -> Array:
    """A curve (m, 2) that looks like that through the points (n,), with at most four a pixel.

    It has the first, the last, the lowest and the highest point of each column of pixels.
    """
    column = np.floor(x).astype(int)
    starts = np.flatnonzero(np.diff(column, prepend=column[0] - 1))
    if len(starts) * 4 >= len(x):
        return np.stack([x, y], axis=-1)
    ends = np.append(starts[1:], len(x))
    keep = []
    for start, end in zip(starts, ends, strict=True):
        part = y[start:end]
        keep += sorted({start, start + int(part.argmin()), start + int(part.argmax()), end - 1})
    return np.stack([x[keep], y[keep]], axis=-1)
