"""``rimroll fragility``: how likely a shaking is to overturn a body."""

from __future__ import annotations

import warnings
from collections import Counter
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import numpy as np
import typer
from rich.table import Table

from rimroll import _core
from rimroll.cli.contact import in_words
from rimroll.cli.falls import NUMBERS
from rimroll.cli.formats import STDOUT, Forms, check, pictures, write, write_json
from rimroll.cli.ground import (
    FlatOfMany,
    LeanOptions,
    ShakenOptions,
    body_and_records,
    given_flat,
)
from rimroll.cli.hints import undecided_hints
from rimroll.cli.options import (
    BodyOptions,
    JsonOption,
    LawOptions,
    ResistanceOptions,
    ThreadsOption,
)
from rimroll.cli.records import (
    IntensityOptions,
    Levels,
    RecordsOptions,
    requested_levels,
    requested_limit,
    requested_records,
)
from rimroll.cli.request import Request, Shaking, requested
from rimroll.cli.screen import Bar, prose, say, show_json, table, unbroken, working
from rimroll.cli.turn import body_line, start_in_words
from rimroll.endings import ending_in_words
from rimroll.errors import RimrollError
from rimroll.falls import Column, Falls, Interrupted
from rimroll.ground.ground import Ground
from rimroll.shaking.incremental import MEASURES, Rocking, counts, laid_out, measured
from rimroll.shaking.lognormal import Fragility, UndecidedWarning, reached
from rimroll.shaking.lognormal import fragility as fitted

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
        help="Write a file; may be repeated. Its suffix says what: .svg, .png or .pdf the curve,"
        " .csv, .nc or .json all motions; - writes .csv to stdout.",
        metavar="FILE",
        rich_help_panel="Output",
    ),
]


@dataclass(frozen=True)
class Study:
    """Motions over records and levels, and the curve that fits them, or why there is none."""

    request: Request
    rocking: Rocking
    levels: Levels
    grounds: Mapping[str, Ground]
    motions: Falls
    curve: Fragility | None
    why_not: str

    @property
    def axis(self) -> str:
        """The name of the dimension of the levels."""
        return list(self.motions.axes)[1]

    def done(self) -> dict[str, Ground]:
        """The records whose motions are all done."""
        return {name: self.grounds[name] for name in map(str, self.motions["ground"])}

    def rows(self) -> list[dict[str, Any]]:
        """What became of the motions at each level."""
        far, undecided = reached(self.motions, self.rocking.limit)
        return [
            {
                self.axis: float(value),
                "motions": len(far),
                "overturned": int(self.motions["overturned"][:, place].sum()),
                "failed": int(far[:, place].sum()),
                "undecided": int(undecided[:, place].sum()),
            }
            for place, value in enumerate(self.motions[self.axis])
        ]

    def undecided(self) -> Counter[str]:
        """How many of the motions that are undecided ended in which status."""
        _, undecided = reached(self.motions, self.rocking.limit)
        return Counter(map(str, self.motions["status"][undecided].tolist()))


def _figure(study: Study) -> Figure:
    from rimroll.shaking.figures import fragility_figure

    measure, limit = study.levels.measure, study.rocking.limit
    data = counts(study.motions, measure, limit)
    label = f"{measure.name.upper()} ({measure.unit.replace('^2', '²')})"
    return fragility_figure(data, study.curve, label, limit)


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
    flat: FlatOfMany = None,
    files: RecordsArgument = None,
    threads: ThreadsOption = None,
    output: FragilityOutput = None,
    json: JsonOption = False,
) -> int:
    """How likely a shaking is to overturn a body: a fragility curve.

    Each record is scaled to several intensities, its vertical component too, and
    the curve is a lognormal distribution, fitted by maximum likelihood. The
    body stands unless a start is given, and rolls without slip unless another
    law is given. Ctrl-C keeps the records done so far.

    Examples:

    $ rimroll fragility examples/column.toml --synthetic 20 -o fragility.svg

    $ rimroll fragility column.toml peer/*.AT2 --intensities 0.2g..1g -o all.csv

    $ rimroll fragility column.toml peer/*.AT2 --measure pgv --limit 0.5 --json
    """
    paths = output or []
    check(paths, FORMS, json)
    levels, limit = requested_levels(intensity), requested_limit(intensity)
    body, more = body_and_records(body, files or ())
    grounds = requested_records(records, more)
    shaking = Shaking(next(iter(grounds.values()), None), given_flat(flat))
    what = requested(body, start, motion, law, resistances, shaking=shaking)
    if not grounds:
        grounds = _ground_of_file(what)
    rocking = _rocking(what, motion, limit, flat is not None, threads)
    study, cut_short = _follow(what, rocking, levels, grounds)
    for path in paths:
        write(path, study, FORMS)
    if json:
        show_json({**answer(study), "files": [str(path) for path in paths]})
    elif STDOUT not in paths:
        _show(study, paths)
    if cut_short:
        return 130
    return int(bool((study.motions["status"] == "failed").all()))


def _ground_of_file(what: Request) -> dict[str, Ground]:
    if what.ground is None:
        raise RimrollError(
            "nothing says how the ground moves: give --record, --synthetic or a file with a ground"
        )
    return {Path(what.name).stem: what.ground}


def _rocking(
    what: Request, motion: ManyOptions, limit: float | None, has_flat: bool, threads: int | None
) -> Rocking:
    assert what.start is not None
    options = what.options
    return Rocking(
        what.body,
        what.start,
        what.law,
        replace(options, rtol=1e-8 if motion.rtol is None else options.rtol),
        what.flat if has_flat or what.flat != "stop" else "housner",
        options.duration if what.has_duration else None,
        limit,
        threads,
    )


def _follow(
    what: Request, rocking: Rocking, asked: Levels, grounds: Mapping[str, Ground]
) -> tuple[Study, bool]:
    """The motions and their curve, and whether Ctrl-C cut them short."""
    measure, levels = asked.measure, asked.values
    with working(f"shaking {what.name}") as bar:
        strength = measured(grounds, measure)
        if levels is None:
            bar(0, 1, "how strong?")
            levels = rocking.usual_levels(grounds, measure, asked.points)
        factors = np.broadcast_to(levels, (len(grounds), len(levels)))
        if not asked.are_factors:
            factors = levels / strength[:, np.newaxis]
        attrs: dict[str, Any] = {"records": len(grounds)}
        try:
            found = rocking.follow(grounds, factors, lambda done, total: bar(done, total, ""))
        except Interrupted as interrupted:
            found = interrupted.falls
            done = found.size // len(levels)
            if done == 0:
                raise
            attrs["interrupted"] = f"after {done} of {len(grounds)} records"
    axis, level = measure.name, Column(levels, measure.unit, measure.long_name)
    if asked.are_factors:
        axis, level = "scale", Column(levels, "", "factor on the acceleration of the ground")
    motions = laid_out(found, grounds, level, axis)
    curve, why_not = _fitted(motions, asked, rocking.limit)
    named = {"body": what.name, **attrs, **_numbers(curve)}
    motions = motions.with_attrs(named)
    return Study(what, rocking, asked, grounds, motions, curve, why_not), "interrupted" in attrs


def _fitted(motions: Falls, asked: Levels, limit: float | None) -> tuple[Fragility | None, str]:
    """The curve, or None and why there is none."""
    dataset = motions.to_xarray()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UndecidedWarning)  # the answer counts them
        try:
            return fitted(dataset, dataset[asked.measure.name], limit=limit), ""
        except RimrollError as error:
            return None, str(error)


def _numbers(curve: Fragility | None) -> dict[str, Any]:
    """The numbers of a curve in the attributes of a file."""
    if curve is None:
        return {}
    names = ("median", "dispersion", "median_interval", "dispersion_interval", "level")
    return {f"fragility_{name}": getattr(curve, name) for name in names}


def answer(study: Study) -> dict[str, Any]:
    """The study without its single motions, as a dictionary in SI units."""
    measure, curve = study.levels.measure, study.curve
    names = ("median", "dispersion", "median_interval", "dispersion_interval", "level")
    return {
        "parameters": study.motions.attrs,
        "measure": measure.name,
        "unit": measure.unit,
        "limit": study.rocking.limit,
        "records": {
            name: {"duration": ground.duration, **{m.name: m.of(ground) for m in MEASURES.values()}}
            for name, ground in study.done().items()
        },
        "levels": study.rows(),
        "curve": None if curve is None else {name: getattr(curve, name) for name in names},
        "why_no_curve": study.why_not or None,
        "undecided": dict(study.undecided()),
    }


def _show(study: Study, paths: list[Path]) -> None:
    rocking, what = study.rocking, study.request
    prose(body_line(what.name, what.body))
    law = f"{in_words(what.law)}; {start_in_words(rocking.start, what.options.gravity)}"
    prose(f"{law}; where the base comes down flat: {rocking.flat}")
    prose(_records_in_words(study))
    say()
    say(_table(study))
    say()
    prose(_curve_in_words(study))
    if study.curve is not None and len(study.motions["ground"]) == 1:
        prose("this is the curve of one record; it says nothing about other earthquakes")
    undecided = study.undecided()
    if undecided:
        words = ", ".join(
            f"{count} {ending_in_words(status)}" for status, count in undecided.items()
        )
        be = "is" if undecided.total() == 1 else "are"
        prose(
            f"{undecided.total()} of {study.motions.size} motions {be} undecided and left out"
            f" ({words}): the motion ended before it was determined what becomes of the body"
        )
        for hint in undecided_hints(undecided, what.law, "--friction"):
            prose(hint)
    if "interrupted" in study.motions.attrs:
        say(f"interrupted {study.motions.attrs['interrupted']}")
    for path in paths:
        say(f"wrote {path}")


def _records_in_words(study: Study) -> str:
    """How many records of which components, and for how long they last."""
    done = study.done()
    kinds: Counter[str] = Counter()
    for ground in done.values():
        axes = [axis for axis, peak in zip("xyz", ground.peak, strict=False) if peak > 0.0]
        kinds[" and ".join(axes) if len(axes) < 3 else "x, y and z"] += 1
    if len(kinds) == 1:
        components = f" of {next(iter(kinds))}"
    else:
        components = ": " + ", ".join(f"{count} of {axes}" for axes, count in kinds.items())
    word = "records" if len(done) > 1 else "record"
    name = f", {next(iter(done))}" if len(done) == 1 else ""
    return f"{len(done)} {word}{components}{name}"


def _table(study: Study) -> Table:
    """The counts at each level; accelerations in g, too."""
    measure, far = study.levels.measure, _word(study)
    in_g = study.axis == "pga"
    heads = [f"{measure.name.upper()} ({_shown(measure.unit)})", "(g)"][: 1 + in_g]
    rows = table(
        *(heads if not study.levels.are_factors else ["scale"]), "motions", far, "undecided"
    )
    for row in study.rows():
        level = row[study.axis]
        cells = [f"{level:.4g}", f"{level / _core.STANDARD_GRAVITY:.3g}"][: 1 + in_g]
        rows.add_row(*cells, *(str(row[name]) for name in ("motions", "failed", "undecided")))
    return rows


def _word(study: Study) -> str:
    limit = study.rocking.limit
    return "overturned" if limit is None else f"reached {limit:g}"


def _shown(unit: str) -> str:
    return unit.replace("^2", "²")


def _curve_in_words(study: Study) -> str:
    """The median and the dispersion with their intervals, or why there is no curve."""
    curve, measure = study.curve, study.levels.measure
    if curve is None:
        return f"no curve: {study.why_not}"
    unit = _shown(measure.unit)
    what = "overturn" if curve.limit is None else f"reach {curve.limit:g} of the balance tilt"
    low, high = curve.median_interval
    in_g = f" ({curve.median / _core.STANDARD_GRAVITY:.3g} g)" if measure.name == "pga" else ""
    least, most = curve.dispersion_interval
    return (
        f"half of the bodies {what} at a {measure.name.upper()} of"
        f" {unbroken(f'{curve.median:.3g} {unit}')}{in_g}; {100.0 * curve.level:g} % interval"
        f" {low:.3g} to {unbroken(f'{high:.3g} {unit}')}; dispersion {curve.dispersion:.2g}"
        f" ({least:.2g} to {most:.2g})"
    )
