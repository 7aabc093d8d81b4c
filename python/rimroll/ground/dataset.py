"""A ground in the dataset of a motion: its pulses, and its record with its step."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

import numpy as np

from rimroll import _core
from rimroll.errors import RimrollError
from rimroll.ground.ground import Ground
from rimroll.units import number, numbers

if TYPE_CHECKING:
    import xarray as xr


PULSES, STEP, HEADING = "ground_pulses", "ground_step", "ground_heading"
"""The attributes: the pulses as JSON, the step of the record in s, the heading of x in rad."""

SAMPLES, TIMES = "ground_record", "ground_t"
"""The variable with the samples of the record, m/s², over its times, s, and components."""


def attributes(ground: Ground) -> dict[str, Any]:
    """The ground as plain numbers and texts; all of it but the samples of a record."""
    record = ground.core.samples()
    return {
        PULSES: json.dumps(ground.core.pulses()),
        **({} if record is None else {STEP: record[0]}),
        **({} if ground.heading is None else {HEADING: ground.heading}),
    }


def with_record(dataset: xr.Dataset, ground: Ground) -> xr.Dataset:
    """The dataset with the samples of the ground's record, if there is one."""
    record = ground.core.samples()
    if record is None:
        return dataset
    step, samples = record
    times = step * np.arange(len(samples))
    of_record = {SAMPLES: ((TIMES, "component"), samples, {"units": "m/s^2"})}
    coordinates = {TIMES: (TIMES, times, {"units": "s"}), "component": list("xyz")}
    return dataset.assign(of_record).assign_coords(coordinates)


def ground_of(dataset: xr.Dataset) -> Ground | None:
    """The ground of a motion's dataset; None if the table was at rest.

    Raises ``RimrollError`` where the dataset lacks a part of it.
    """
    if PULSES not in dataset.attrs:
        return None
    core = _core.CoreGround.from_pulses(_pulses(str(dataset.attrs[PULSES])))
    if STEP in dataset.attrs:
        if SAMPLES not in dataset:
            raise RimrollError(
                f"this dataset has a ground without its record: there is no {SAMPLES} in it"
            )
        samples = numbers(SAMPLES, dataset[SAMPLES].transpose(TIMES, "component"), "m/s^2")
        step = number(STEP, dataset.attrs[STEP], "s")
        core = core.plus(_core.CoreGround.from_samples(step, np.ascontiguousarray(samples)))
    heading = dataset.attrs.get(HEADING)
    return Ground(core, None if heading is None else number(HEADING, heading, "rad"))


def _pulses(text: str) -> list[_core.Pulse]:
    try:
        return [
            (
                str(kind),
                [float(a) for a in amplitude],
                float(period),
                float(duration),
                float(center),
            )
            for kind, amplitude, period, duration, center in json.loads(text)
        ]
    except (TypeError, ValueError):
        raise RimrollError(f"{PULSES} must be pulses in JSON, got {text[:80]!r}") from None
