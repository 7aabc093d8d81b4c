"""The files of a motion: one format for each suffix."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import numpy as np

from rimroll.cli.formats import Forms, pictures, write_csv, write_json
from rimroll.cli.request import Request
from rimroll.cli.screen import Bar
from rimroll.ground.dataset import SAMPLES, TIMES
from rimroll.motion import UNITS, Array, Moments, Motion
from rimroll.motion.moments import footprint_of

TWICE = "times may repeat where the contact changes: once as before, once as after"
"""A comment on the times in the files."""

ROWS = 4096  # written between two looks at the progress bar


@dataclass(frozen=True)
class Record:
    """A motion, the moments of it to write, and the request."""

    motion: Motion
    moments: Moments
    request: Request

    @property
    def parameters(self) -> dict[str, Any]:
        """All that the motion was computed from."""
        options = {
            "duration": self.request.options.duration,
            "max_steps": self.request.options.max_steps,
        }
        return {"body": self.request.name, **self.motion.parameters(), **options}


def summary(record: Record) -> dict[str, Any]:
    """A motion without its samples, as a dictionary."""
    motion = record.motion
    return {
        "parameters": record.parameters,
        "status": motion.status,
        "message": motion.message,
        "stats": asdict(motion.stats),
        "turns": [asdict(turn) for turn in motion.turns],
        "events": [asdict(event) for event in motion.events],
        "phases": [asdict(phase) for phase in motion.phases],
        **({} if motion.ground is None else {"shaken": shaken(motion)}),
        "losses": {
            "friction": float(motion.friction_loss[-1]),
            "resistance": float(motion.resistance_loss[-1]),
            "impact": float(motion.impact_loss[-1]),
        },
    }


def shaken(motion: Motion) -> dict[str, Any]:
    """What became of a body on a table that moved, in SI units and radians."""
    assert motion.ground is not None
    return {
        "ground_duration": motion.ground.duration,
        "ground_peak": motion.ground.peak._asdict(),
        "overturned": motion.overturned,
        "overturning_time": motion.overturning_time,
        "uplift_time": motion.uplift_time,
        "max_tilt": motion.max_tilt,
        "max_tilt_ratio": motion.max_tilt_ratio,
        "stands": motion.stands,
        "residual_displacement": motion.residual_displacement,
        "residual_yaw": motion.residual_yaw,
        "ground_work": float(motion.ground_work[-1]),
    }


FOOTPRINT_COLUMNS = ("footprint_x", "footprint_y")
"""Columns for the centre of the footprint, m, in files of a shaken motion."""

GROUND_COLUMNS = ("ground_x", "ground_y", "ground_z")
"""Columns for the acceleration of the ground, m/s², in files of a shaken motion."""


def _columns(record: Record) -> dict[str, tuple[str, Array]]:
    """The columns of a file, each with its unit."""
    columns = {name: (unit, record.moments[name]) for name, unit in UNITS.items()}
    if (ground := record.motion.ground) is not None:
        for names, unit, values in (
            (FOOTPRINT_COLUMNS, "m", footprint_of(record.moments, record.motion.body).T),
            (GROUND_COLUMNS, "m/s^2", ground(record.moments.t).T),
        ):
            columns |= {name: (unit, one) for name, one in zip(names, values, strict=True)}
    return columns


def _csv(part: Path, record: Record, bar: Bar) -> None:
    """A column ``name[unit]`` for each quantity, doubles in full."""
    comments = {**record.parameters, "status": record.motion.status, "t": TWICE}
    columns = _columns(record)
    names = (f"{name}[{unit}]" for name, (unit, _) in columns.items())
    write_csv(part, names, _rows([values for _, values in columns.values()], bar), comments)


def _rows(values: list[Array], bar: Bar) -> Iterator[Iterable[str]]:
    columns = np.stack(values, axis=-1)
    for first in range(0, len(columns), ROWS):
        bar(first, len(columns), "")
        yield from (map(repr, row) for row in columns[first : first + ROWS].tolist())


def _netcdf(part: Path, record: Record, bar: Bar) -> None:
    import xarray as xr

    whole = record.motion.to_xarray()
    columns = {name: column for name, column in _columns(record).items() if name != "t"}
    ground = [name for name in (SAMPLES, TIMES, "component") if name in whole.variables]
    phases = record.motion.phases
    in_seconds = {"units": "s"}
    dataset = xr.Dataset(
        {
            **{name: ("t", values, {"units": unit}) for name, (unit, values) in columns.items()},
            **whole[ground].variables,
            "phase_kind": ("phase", [phase.kind for phase in phases]),
            "phase_start": ("phase", [phase.start for phase in phases], in_seconds),
            "phase_end": ("phase", [phase.end for phase in phases], in_seconds),
        },
        coords={"t": ("t", record.moments.t, {**whole["t"].attrs, "comment": TWICE})},
        attrs={**whole.attrs, **record.parameters},
    )
    dataset.to_netcdf(part, engine="scipy")


def _json(part: Path, record: Record, bar: Bar) -> None:
    content = {
        **summary(record),
        "units": {name: unit for name, (unit, _) in _columns(record).items()},
        "comments": {"t": TWICE},
        "samples": {name: values for name, (_, values) in _columns(record).items()},
    }
    write_json(part, content)


def _film(part: Path, record: Record, bar: Bar) -> None:
    record.motion.animate(part, progress=lambda done, total: bar(done, total, ""))


FORMS: Forms[Record] = {
    ".csv": _csv,
    ".nc": _netcdf,
    ".json": _json,
    **pictures(lambda record: record.motion.plot()),
    **dict.fromkeys((".gif", ".html", ".mp4"), _film),
}
