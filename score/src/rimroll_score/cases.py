"""The cases, read from ``cases.toml``: scenes, starts and what truly happens."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from rimroll_score import euler
from rimroll_score.protocol import Body, Scene, State

FILE = Path(__file__).with_name("cases.toml")


@dataclass(frozen=True)
class Case:
    """A motion that is known."""

    name: str
    title: str
    scene: Scene
    state: State
    duration: float
    """s"""
    measure: str
    """What its angle error is: see :mod:`rimroll_score.measures`."""
    truth: Mapping[str, Any]


@dataclass(frozen=True)
class Falls:
    """Many flicks of a body, and the direction in which each falls (rad, from the first lean)."""

    title: str
    scene: Scene
    states: tuple[State, ...]
    duration: float
    fallen: float
    """Tilt at which the direction is read, rad."""
    directions: tuple[float, ...] = field(repr=False)


def cases() -> list[Case]:
    """All cases but the distribution of falls."""
    data = _data()
    return [_case(name, data["bodies"], table) for name, table in data["case"].items()]


def falls() -> Falls:
    """The distribution of falls."""
    data = _data()
    table = data["falls"]
    body = Body(**data["bodies"][table["body"]])
    return Falls(
        title=table["title"],
        scene=Scene(body, table["friction"], table["gravity"]),
        states=tuple(
            euler.state(body, euler.Angles(tilt, tilt_rate, 0.0, yaw_rate, 0.0, spin_rate))
            for tilt, tilt_rate, yaw_rate, spin_rate in table["starts"]
        ),
        duration=table["duration"],
        fallen=table["fallen"],
        directions=tuple(table["directions"]),
    )


def _data() -> dict[str, Any]:
    return tomllib.loads(FILE.read_text("utf-8"))


def _case(name: str, bodies: Mapping[str, Any], table: Mapping[str, Any]) -> Case:
    body = Body(**bodies[table["body"]])
    start = {key: np.array(value, float) for key, value in table["start"].items()}
    return Case(
        name=name,
        title=table["title"],
        scene=Scene(body, table["friction"], table["gravity"], table["table"]),
        state=State(**start),
        duration=table["duration"],
        measure=table["measure"],
        truth=table["truth"],
    )
