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
from rimroll.motion import UNITS, Moments, Motion

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
        "losses": {
            "friction": float(motion.friction_loss[-1]),
            "resistance": float(motion.resistance_loss[-1]),
            "impact": float(motion.impact_loss[-1]),
        },
    }


def _csv(part: Path, record: Record, bar: Bar) -> None:
    """A column ``name[unit]`` for each quantity, doubles in full."""
    comments = {**record.parameters, "status": record.motion.status, "t": TWICE}
    names = (f"{name}[{unit}]" for name, unit in UNITS.items())
    write_csv(part, names, _rows(record.moments, bar), comments)


def _rows(moments: Moments, bar: Bar) -> Iterator[Iterable[str]]:
    columns = np.stack([moments[name] for name in UNITS], axis=-1)
    for first in range(0, len(columns), ROWS):
        bar(first, len(columns), "")
        yield from (map(repr, row) for row in columns[first : first + ROWS].tolist())


def _netcdf(part: Path, record: Record, bar: Bar) -> None:
    import xarray as xr

    whole = record.motion.to_xarray()
    names = [name for name in UNITS if name != "t"]
    phases = record.motion.phases
    in_seconds = {"units": "s"}
    dataset = xr.Dataset(
        {
            **{name: ("t", record.moments[name], whole[name].attrs) for name in names},
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
        "units": UNITS,
        "comments": {"t": TWICE},
        "samples": {name: record.moments[name] for name in UNITS},
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
