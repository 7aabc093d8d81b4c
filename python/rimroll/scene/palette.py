"""Colours, opacities and widths of lines."""

from __future__ import annotations

import numpy as np
from PIL import ImageColor

from rimroll.scene.pose import Array

# Okabe and Ito's palette, distinguishable with any colour vision.
BLUE, VERMILLION, ORANGE, GREEN = "#0072B2", "#D55E00", "#E69F00", "#009E73"
MARK = -0.5 * np.pi  # rad: azimuth of the mark on the body
INK, METAL, TABLE, SHADOW = "#2b2f33", "#d4d9de", "#e6e8ea", "#1d2733"

# Opacities of a layer of shadow, a wedge, the rim (seen and hidden) and a hidden contact point.
SHADE, WEDGE, RIM, HIDDEN_RIM, HIDDEN_CONTACT = 0.05, 0.28, 0.85, 0.16, 0.65

# Widths of lines and the size of the contact point, points.
RIM_WIDTH, ARC_WIDTH, CONTACT_SIZE, CONTACT_EDGE = 0.9, 1.4, 6.0, 0.8


def rgb(color: str) -> Array:
    """Red, green and blue (3,) of a named colour, from 0 to 1."""
    return np.array(ImageColor.getrgb(color)[:3]) / 255.0
