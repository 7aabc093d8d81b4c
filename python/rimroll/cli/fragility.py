"""``rimroll fragility``: how likely a shaking is to overturn a body."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import numpy as np
import typer

from rimroll.cli.falls import NUMBERS
from rimroll.cli.formats import STDOUT, Forms, check, pictures, write, write_json
from rimroll.cli.fragility_study import Study, answer, follow
from rimroll.cli.fragility_words import show
from rimroll.cli.ground import (
    FlatOption,
    LeanOptions,
    ShakenOptions,
    body_and_records,
    given_flat,
)
from rimroll.cli.options import (
    BodyOptions,
    JsonOption,
    LawOptions,
    ResistanceOptions,
    ThreadsOption,
)
from rimroll.cli.records import (
    IntensityOptions,
    RecordsOptions,
    requested_levels,
    requested_limits,
    requested_records,
)
from rimroll.cli.request import Request, Shaking, requested
from rimroll.cli.screen import Bar, show_json
from rimroll.cli.simulate import UNDECIDED
from rimroll.errors import RimrollError
from rimroll.ground.ground import Ground
from rimroll.shaking.incremental import Rocking, counts

if TYPE_CHECKING:
    from matplotlib.figure import Figure

RecordsArgument = Annotated[
    list[Path] | None,
    typer.Argument(help="Files of records, as with --record.", metavar="RECORDS"),
]


@dataclass(frozen=True)
class ManyOptions(ShakenOptions):
    """Duration and accuracy of many motions on tables that move."""

    duration: Annotated[
        str | None,
        typer.Option(
            help="Duration of each motion. [that of the ground and 20/p, p the rocking frequency]",
            metavar="TIME",
            rich_help_panel="Motion",
        ),
    ] = None
    rtol: Annotated[
        float | None,
        typer.Option(
            help="Intended relative error. [1e-8]", metavar="NUMBER", rich_help_panel="Motion"
        ),
    ] = None


FragilityOutput = Annotated[
    list[Path] | None,
    typer.Option(
        "--output",
        "-o",
        help="Write a file; may be repeated. Its suffix says what: .svg, .png or .pdf the curves"
        " and the largest tilts, .csv, .nc or .json all motions; - writes .csv to stdout.",
        metavar="FILE",
        rich_help_panel="Output",
    ),
]


def _figure(study: Study) -> Figure:
    from rimroll.shaking.figures import incremental_figure

    measure, motions = study.levels.measure, study.motions
    unit = f" ({measure.unit.replace('^2', '²')})" if measure.unit else ""
    states = [(counts(motions, measure, one.limit), one.curve, one.limit) for one in study.states]
    strength = np.broadcast_to(motions[measure.name], motions["overturned"].shape)
    return incremental_figure(states, motions, strength, f"{measure.symbol}{unit}")


def _json(part: Path, study: Study, bar: Bar) -> None:
    motions = study.motions
    content = {
        **answer(study),
        "units": {name: one.units for name, one in motions.columns.items() if one.units},
        "columns": {name: column.values for name, column in motions.columns.items()},
    }
    write_json(part, content)


def _motions(suffix: str) -> Callable[[Path, Study, Bar], None]:
    return lambda part, study, bar: NUMBERS[suffix](part, study.motions, bar)


FORMS: Forms[Study] = {
    ".csv": _motions(".csv"),
    ".nc": _motions(".nc"),
    ".json": _json,
    **pictures(_figure),
}


def fragility(
    body: BodyOptions,
    records: RecordsOptions,
    intensity: IntensityOptions,
    start: LeanOptions,
    motion: ManyOptions,
    law: LawOptions,
    resistances: ResistanceOptions,
    flat: FlatOption = None,
    files: RecordsArgument = None,
    threads: ThreadsOption = None,
    output: FragilityOutput = None,
    json: JsonOption = False,
) -> int:
    """How likely a shaking is to overturn a body: a fragility curve.

    Each record is scaled to several intensities, its vertical component too, and
    the curve is a lognormal distribution, fitted by maximum likelihood. Its
    intervals are those of the jackknife over the records. The body stands
    unless a start is given, and rolls without slip unless another law is given.
    It is one rigid body: a monolithic column, without drums.
    Ctrl-C keeps the records done so far.

    Examples:

    $ rimroll fragility column.toml --synthetic 20 -o fragility.svg

    $ rimroll fragility column.toml peer/*.AT2 --intensities 0.2g..1g -o all.csv

    $ rimroll fragility column.toml peer/*.AT2 --measure pgv --limit 0.5 --json

    $ rimroll fragility column.toml peer/*.AT2 --measure sa --period 1s
    """
    paths = output or []
    check(paths, FORMS, json)
    levels, limits = requested_levels(intensity), requested_limits(intensity)
    body, more = body_and_records(body, files or ())
    grounds = requested_records(records, more)
    shaking = Shaking(next(iter(grounds.values()), None), given_flat(flat))
    what = requested(body, start, motion, law, resistances, shaking=shaking)
    if not grounds:
        grounds = _ground_of_file(what)
    rocking = _rocking(what, motion, limits, threads)
    study, cut_short = follow(what, rocking, levels, grounds)
    for path in paths:
        write(path, study, FORMS)
    if json:
        show_json({**answer(study), "files": [str(path) for path in paths]})
    elif STDOUT not in paths:
        show(study, paths)
    if cut_short:
        return 130
    if (study.motions["status"] == "failed").all():
        return 1
    is_open = all(one.undecided.total() == study.motions.size for one in study.states)
    return UNDECIDED if is_open else 0


def _ground_of_file(what: Request) -> dict[str, Ground]:
    if what.ground is None:
        raise RimrollError(
            "nothing says how the ground moves: give --record, --synthetic or a file with a ground"
        )
    return {Path(what.name).stem: what.ground}


def _rocking(
    what: Request, motion: ManyOptions, limits: tuple[float | None, ...], threads: int | None
) -> Rocking:
    assert what.start is not None
    options = what.options
    return Rocking(
        what.body,
        what.start,
        what.law,
        replace(options, rtol=1e-8 if motion.rtol is None else options.rtol),
        options.duration if what.has_duration else None,
        limits,
        threads,
    )
