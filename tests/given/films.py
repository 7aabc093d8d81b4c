"""Films of falling bodies, simulated: the path of a marker from above, and the lean."""

import numpy as np

HELD = 0.25
"""How long the film shows the body at rest in the hand, s."""
TURN, ORIGIN, SCALE = 1.1, 0.3 - 0.2j, 1.01
"""The camera: its turn about the vertical, where it sees the table's origin (m), and its scale."""


def rotations(moments):
    """The attitude (n, 3, 3) by products of elementary rotations about z, y and z."""

    def about_z(angle):
        c, s, one, no = np.cos(angle), np.sin(angle), np.ones_like(angle), np.zeros_like(angle)
        return np.moveaxis(np.array([[c, -s, no], [s, c, no], [no, no, one]]), -1, 0)

    c, s = np.cos(moments.tilt), np.sin(moments.tilt)
    one, no = np.ones_like(c), np.zeros_like(c)
    about_y = np.moveaxis(np.array([[c, no, -s], [no, one, no], [s, no, c]]), -1, 0)
    return about_z(moments.yaw) @ about_y @ about_z(moments.spin)


def filmed(motion, marker, rate=120.0, noise=5e-4, seed=1):
    """Times, and positions (n, 2) in m of a marker (x, y, z) of the body from its base's centre."""
    t = np.arange(0.0, HELD + float(motion.t[-1]), 1.0 / rate)
    moments = motion.evaluate(np.maximum(t - HELD, 0.0))
    from_center = np.array(marker) - [0.0, 0.0, motion.body.height]
    placed = moments.center + rotations(moments) @ from_center
    seen = SCALE * (placed[:, 0] + 1j * placed[:, 1]) * np.exp(1j * TURN) + ORIGIN
    values = np.stack([seen.real, seen.imag], axis=-1)
    return t, values + noise * np.random.default_rng(seed).normal(size=values.shape)


def leaning(motion, rate=120.0, noise=0.01, seed=1):
    """Times, and tilt and direction of lean (n, 2) in rad, from the axis of the body."""
    t = np.arange(0.0, HELD + float(motion.t[-1]), 1.0 / rate)
    axis = rotations(motion.evaluate(np.maximum(t - HELD, 0.0)))[:, :, 2]
    tilt = np.arccos(np.clip(axis[:, 2], -1.0, 1.0))
    direction = np.unwrap(np.arctan2(axis[:, 1], axis[:, 0]))
    draw = np.random.default_rng(seed)
    return t, np.stack(
        [
            tilt + noise * draw.normal(size=len(t)),
            direction + noise / np.maximum(np.sin(tilt), noise) * draw.normal(size=len(t)),
        ],
        axis=-1,
    )
