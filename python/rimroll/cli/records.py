"""Several records, and the intensities to which they are scaled, from options."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any

import numpy as np
import typer

from rimroll.cli.contact import option
from rimroll.cli.ground import RecordOptions
from rimroll.cli.options import completing, ends, value_option, whole
from rimroll.errors import RimrollError, choose, typed
from rimroll.ground.files import read_all
from rimroll.ground.ground import MAX_FACTOR, Ground
from rimroll.ground.lines import HORIZONTAL
from rimroll.ground.pulses import synthetic
from rimroll.shaking.incremental import MEASURES, Measure
from rimroll.units import quantity

MAX_RECORDS, MAX_LEVELS = 1000, 1000

OVERTURNING = "overturning"
"""The limit state of a body that overturns."""

Array = np.ndarray[Any, np.dtype[np.float64]]


@dataclass(frozen=True)
class RecordsOptions(RecordOptions):
    """Several records."""

    record: Annotated[
        list[Path] | None,
        value_option(
            "AT2 or CSV files; more may follow. AT2 files of one earthquake and station (line"
            " 2) are one record; or join the files of a record by commas.",
            "FILE",
            "Ground",
        ),
    ] = None
    synthetic: Annotated[
        int | None,
        typer.Option(
            parser=whole(1, MAX_RECORDS),
            help="So many synthetic records in place of files, which resemble earthquakes: x and y,"
            " 20 s.",
            metavar="NUMBER",
            rich_help_panel="Ground",
        ),
    ] = None
    soil_period: Annotated[
        str | None,
        value_option("Of the soil under synthetic records. [0.4 s]", "TIME", "Ground"),
    ] = None


@dataclass(frozen=True)
class IntensityOptions:
    """How strong the shaking is, and what counts as failure."""

    measure: Annotated[
        str,
        typer.Option(
            help="Measure of the intensity: pga, pgv, sa (with --period), pga-ratio, PGA/(g tan α),"
            " or pgv-ratio, p PGV/(g tan α), with tan α = R/H and the rocking frequency p.",
            metavar="NAME",
            rich_help_panel="Intensity",
            autocompletion=completing(map(typed, MEASURES)),
        ),
    ] = "pga"
    horizontal: Annotated[
        str,
        typer.Option(
            help="How both horizontal components become one number: vector (the largest magnitude),"
            " rotd50 or geomean.",
            metavar="HOW",
            rich_help_panel="Intensity",
            autocompletion=completing(HORIZONTAL),
        ),
    ] = "vector"
    period: Annotated[
        str | None,
        value_option("Natural period of sa.", "TIME", "Intensity"),
    ] = None
    damping: Annotated[
        str | None,
        value_option("Damping ratio of sa. [5%]", "RATIO", "Intensity"),
    ] = None
    intensities: Annotated[
        str | None,
        value_option(
            "Levels to which each record is scaled: 0.2g..1g, or 0.2g,0.4g,0.8g. [from g R/H"
            " of acceleration to where most overturn]",
            "RANGE",
            "Intensity",
        ),
    ] = None
    scale: Annotated[
        str | None,
        value_option(
            "Factors on the records as they are, in place of levels: 0.5..3, or 1,2,4.",
            "RANGE",
            "Intensity",
        ),
    ] = None
    levels: Annotated[
        int | None,
        typer.Option(
            parser=whole(2, MAX_LEVELS),
            help="Number of levels or factors of a range, evenly apart. [10]",
            metavar="NUMBER",
            rich_help_panel="Intensity",
        ),
    ] = None
    limit: Annotated[
        str | None,
        value_option(
            "Largest tilt over the balance tilt that counts as failure, such as 0.5; several"
            " limit states in a list: 0.25,0.5,overturning. [overturning]",
            "LIST",
            "Intensity",
        ),
    ] = None


def requested_records(options: RecordsOptions, more: Sequence[Path]) -> dict[str, Ground]:
    """The records that options name; none where they name none.

    Raises ``RimrollError`` naming the file or the option that is at fault.
    """
    files = [*(options.record or ()), *more]
    if options.synthetic is None:
        if options.soil_period is not None:
            raise RimrollError("--soil-period needs --synthetic")
        if not files:
            for name in ("units", "pad", "columns", "step", "time_unit"):
                if getattr(options, name):
                    raise RimrollError(f"{option(name)} needs --record")
            return {}
        paths = map(_files_of, files)
        return read_all(*paths, units=options.units, pad=options.pad, **options.layout)
    if files:
        raise RimrollError(f"--synthetic and the record {files[0]} are both given: give one")
    period = quantity(options.soil_period or "0.4 s", "s", "--soil-period")
    return {
        f"synthetic {seed}": synthetic(seed, (1.0, 1.0, 0.0), soil_period=period)
        for seed in range(options.synthetic)
    }


def _files_of(word: Path) -> Path | list[Path]:
    """A file, or the files of one record with commas between them."""
    if word.exists() or "," not in str(word):
        return word
    return [Path(part.strip()) for part in str(word).split(",")]


def requested_limits(options: IntensityOptions) -> tuple[float | None, ...]:
    """The tilts that count as failure, over the balance tilt; None for overturning."""
    if options.limit is None:
        return (None,)
    limits = tuple(map(_limit, options.limit.split(",")))
    if len(set(limits)) < len(limits):
        raise RimrollError(f"--limit has a limit state twice: {options.limit!r}")
    return limits


def _limit(text: str) -> float | None:
    if text.strip().lower() == OVERTURNING:
        return None
    ratio = quantity(text, "1", "--limit")
    if not 0.0 < ratio <= 1.0:
        raise RimrollError(
            f"--limit must be above 0 and at most 1, or {OVERTURNING}, got {ratio:g}"
        )
    return ratio


@dataclass(frozen=True)
class Levels:
    """The levels of a measure, or factors on the records: ``values`` is None for the usual."""

    measure: Measure
    are_factors: bool
    values: Array | None
    points: int


def requested_levels(options: IntensityOptions) -> Levels:
    """The levels that options describe; ``RimrollError`` naming the option that is at fault."""
    measure = _measure(options)
    if options.intensities is not None and options.scale is not None:
        raise RimrollError("--intensities and --scale both say how strong: give one")
    points = options.levels or 10
    if options.scale is not None:
        factors = _values(options.scale, "1", "--scale", "0.5..3 or 1,2,4", options.levels)
        outside = factors[(factors < 1.0 / MAX_FACTOR) | (factors > MAX_FACTOR)]
        if outside.size:
            raise RimrollError(f"--scale must be between 1e-6 and 1e6, got {outside[0]:g}")
        return Levels(measure, True, factors, len(factors))
    if options.intensities is None:
        return Levels(measure, False, None, points)
    option, unit = "--intensities", measure.unit or "1"
    examples = {"m/s^2": "0.2g..1g or 0.2g,0.4g", "m/s": "0.2..1m/s or 20cm/s,40cm/s"}.get(
        unit, "1..4 or 1,2,4"
    )
    levels = _values(options.intensities, unit, option, examples, options.levels)
    if not (levels > 0.0).all():
        raise RimrollError(field=option, value=levels.min(), bound="> 0", unit=unit)
    return Levels(measure, False, levels, len(levels))


def _measure(options: IntensityOptions) -> Measure:
    """The measure of the intensity."""
    name = choose("measure", options.measure, {name: name for name in MEASURES})
    horizontal = choose("horizontal", options.horizontal, {name: name for name in HORIZONTAL})
    for given, text in (("--period", options.period), ("--damping", options.damping)):
        if text is not None and name != "sa":
            raise RimrollError(f"{given} is that of the oscillator of --measure sa")
    if name != "sa":
        return Measure(name, horizontal)
    if options.period is None:
        raise RimrollError("--measure sa needs --period, the natural period of its oscillator")
    period = quantity(options.period, "s", "--period")
    return Measure(name, horizontal, period, quantity(options.damping or "5%", "1", "--damping"))


def _values(text: str, unit: str, option: str, examples: str, points: int | None) -> Array:
    """The numbers of a list or of a range, ascending."""
    if ".." in text:
        return np.linspace(*ends(text, unit, option, examples), points or 10)
    if points is not None:
        raise RimrollError(f"--levels is for a range such as {examples.split(' or ')[0]}")
    values = np.array([quantity(part, unit, option) for part in text.split(",")])
    if not np.isfinite(values).all():
        raise RimrollError(field=option, value=text, bound="finite")
    if len(set(values.tolist())) < len(values):
        raise RimrollError(f"{option} has a number twice: {text!r}")
    return np.sort(values)
