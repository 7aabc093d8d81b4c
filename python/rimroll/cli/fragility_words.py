"""The answer of ``rimroll fragility`` in words and in a table."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

from rich.table import Table

from rimroll import _core
from rimroll.cli.contact import in_words
from rimroll.cli.fragility_study import LimitState, Study
from rimroll.cli.hints import undecided_hints
from rimroll.cli.screen import prose, say, table, unbroken
from rimroll.cli.turn import body_line, start_in_words
from rimroll.files.recorded import ending_in_words
from rimroll.shaking.lognormal import Fragility


def show(study: Study, paths: list[Path]) -> None:
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
