"""Samples of a motion that an engine computed, and what is wrong with them."""

from __future__ import annotations

from dataclasses import dataclass, field, fields
from pathlib import Path
from typing import Self

import numpy as np
from numpy.typing import NDArray

from rimroll_score.protocol import State

Array = NDArray[np.float64]

SHAPES = {"position": (3,), "rotation": (3, 3), "velocity": (3,), "angular_velocity": (3,)}


LARGEST = 1e100
"""No number of a state may be larger, in SI units."""


class BadSample(Exception):
    """What an engine returned is no state of a rigid body; the message says what and when."""


@dataclass(frozen=True)
class Samples:
    """A motion at n times, s: arrays (n, ...) of the fields of ``State``."""

    time: Array
    position: Array
    rotation: Array
    velocity: Array
    angular_velocity: Array

    @property
    def axis(self) -> Array:
        """The symmetry axis, (n, 3)."""
        return self.rotation[:, :, 2]

    def save(self, path: Path) -> None:
        np.savez(path, **{one.name: getattr(self, one.name) for one in fields(self)})

    @classmethod
    def load(cls, path: Path) -> Self:
        with np.load(path) as stored:
            return cls(**{one.name: stored[one.name] for one in fields(cls)})


@dataclass
class Recorder:
    """Takes copies of states one by one, and refuses what is none."""

    dt: float
    rows: list[tuple[float, State]] = field(default_factory=list)

    def add(self, time: float, due: float, state: State) -> None:
        """Add the state at an engine's time, which is due at a time that follows from the steps.

        Raises ``BadSample`` for a wrong shape, a number that is not finite, or a clock that is off
        by more than a hundredth.
        """
        where = f"at t = {due:.6g} s"
        copies = {name: np.array(getattr(state, name), dtype=float) for name in SHAPES}
        for name, shape in SHAPES.items():
            value = copies[name]
            if value.shape != shape:
                raise BadSample(f"{name} has shape {value.shape} {where}; it must be {shape}")
            # Larger numbers would have infinite energies. NaN is not below the bound either.
            if not np.abs(value).max() < LARGEST:
                raise BadSample(f"{name} is not finite {where}")
        if not abs(time - due) <= 0.01 * max(due, self.dt):
            raise BadSample(f"the engine's clock shows {time:.6g} s {where}")
        # Copied: an engine may give a view of what it overwrites in the next step.
        self.rows.append((due, State(**copies)))

    def samples(self, expected: int) -> Samples:
        """All samples; ``BadSample`` if some are missing or a matrix is no rotation."""
        if len(self.rows) < expected:
            raise BadSample(f"{len(self.rows)} samples were returned instead of {expected}")
        columns = {
            name: np.array([getattr(state, name) for _, state in self.rows], dtype=float)
            for name in SHAPES
        }
        times, turned = np.array([time for time, _ in self.rows]), columns["rotation"]
        off = np.abs(turned @ turned.transpose(0, 2, 1) - np.eye(3)).max(axis=(1, 2))
        wrong = np.flatnonzero((off > 1e-3) | (np.linalg.det(turned) < 0.0))
        if wrong.size:
            raise BadSample(f"rotation is no rotation matrix at t = {times[wrong[0]]:.6g} s")
        return Samples(times, **columns)
