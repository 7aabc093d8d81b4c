"""``rimroll fragility``: how likely a shaking is to overturn a body."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import numpy as np
import typer
from rich.table import Table

from rimroll import _core
from rimroll.cli.contact import in_words
from rimroll.cli.falls import NUMBERS
from rimroll.cli.formats import STDOUT, Forms, check, pictures, write, write_json
from rimroll.cli.fragility_study import LimitState, Study, answer, follow
from rimroll.cli.ground import (
    FlatOption,
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
    options,
    with_helps,
)
from rimroll.cli.records import (
    IntensityOptions,
    RecordsOptions,
    requested_levels,
    requested_limits,
    requested_records,
)
from rimroll.cli.request import Request, Shaking, requested
from rimroll.cli.screen import Bar, prose, say, show_json, table, unbroken
from rimroll.cli.simulate import UNDECIDED
from rimroll.cli.turn import body_line, start_in_words
from rimroll.errors import RimrollError
from rimroll.files.recorded import ending_in_words
from rimroll.ground.ground import Ground
from rimroll.options import Options
from rimroll.shaking.incremental import Rocking, counts
from rimroll.shaking.lognormal import Fragility
from rimroll.units import quantities_of

if TYPE_CHECKING:
    from matplotlib.figure import Figure

RecordsArgument = Annotated[
    list[Path] | None,
    typer.Argument(help="Files of records, as with --record.", metavar="RECORDS"),
]


_MANY = with_helps(
    quantities_of(Options),
    duration="Duration of each motion. [that of the ground and 20/p, p the rocking frequency]",
    rtol="Intended relative error. [1e-8]",
)


@options({"Motion": _MANY})
class ManyOptions(ShakenOptions):
    """Duration and accuracy of many motions on tables that move."""


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
        _show(study, paths)
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


def _show(study: Study, paths: list[Path]) -> None:
    """Write the answer and the names of the files to the screen."""
    rocking, what = study.rocking, study.request
    prose(body_line(what.name, what.body))
    law = f"{in_words(what.law)}; {start_in_words(rocking.start, what.options.gravity)}"
    gap = rocking.options.flat_gap
    below = f", below a gap of {1e3 * gap:g} mm" if gap else ""
    prose(f"{law}; where the base comes down flat{below}: {rocking.options.flat}")
    prose(_records_in_words(study))
    say()
    say(_table(study))
    say()
    for state in study.states:
        prose(_curve_in_words(study, state))
    if study.states[0].curve is not None and len(study.motions["ground"]) == 1:
        prose("this is the curve of one record; it says nothing about other earthquakes")
    undecided = study.states[0].undecided
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
    measure, levels = study.levels.measure, study.motions[study.axis]
    is_level = not study.levels.are_factors
    in_g = is_level and measure.unit == "m/s^2"
    unit = f" ({_shown(measure.unit)})" if measure.unit else ""
    heads = [f"{measure.symbol}{unit}" if is_level else "scale", *["(g)"][:in_g], "motions"]
    several = len(study.states) > 1
    for state in study.states:
        heads += [_word(state), "undecided" if not several else "(open)"]
    rows = table(*heads)
    counts = [state.rows(study) for state in study.states]
    for place, level in enumerate(levels.tolist()):
        cells = [f"{level:.4g}", f"{level / _core.STANDARD_GRAVITY:.3g}"][: 1 + in_g]
        cells.append(str(counts[0][place]["motions"]))
        for one in counts:
            cells += [str(one[place]["failed"]), str(one[place]["undecided"])]
        rows.add_row(*cells)
    return rows


def _word(state: LimitState) -> str:
    return "overturned" if state.limit is None else f"reached {state.limit:g}"


def _shown(unit: str) -> str:
    return unit.replace("^2", "²")


def _curve_in_words(study: Study, state: LimitState) -> str:
    """The median and the dispersion with their intervals, or why there is no curve."""
    curve, measure = state.curve, study.levels.measure
    what = "overturning" if state.limit is None else f"a tilt of {state.limit:g} balance tilts"
    if curve is None:
        return f"no curve of {what}: {state.why_not}"
    unit = _shown(measure.unit)
    is_acceleration = measure.unit == "m/s^2"
    in_g = f" ({curve.median / _core.STANDARD_GRAVITY:.3g} g)" if is_acceleration else ""
    return (
        f"the probability of {what} is 50 % at a {measure.symbol} of"
        f" {unbroken(f'{curve.median:.3g} {unit}'.strip())}{in_g}; dispersion"
        f" {curve.dispersion:.2g}; {_intervals_in_words(curve, unit)}"
    )


def _intervals_in_words(curve: Fragility, unit: str) -> str:
    """The intervals of both, and on how many records they rest."""
    if curve.method == "jackknife" and curve.without is None:
        return f"no interval, for which {_records(curve)} and these levels are too few"
    low, high = curve.median_interval
    least, most = curve.dispersion_interval
    rest = "independent motions"
    if curve.records is not None:
        rest = f"jackknife over {_records(curve)}"
    return (
        f"{100.0 * curve.level:g} % intervals {low:.3g} to"
        f" {unbroken(f'{high:.3g} {unit}'.strip())} and"
        f" {least:.2g} to {most:.2g} ({rest})"
    )


def _records(curve: Fragility) -> str:
    return "1 record" if curve.records == 1 else f"{curve.records} records"
