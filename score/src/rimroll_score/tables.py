"""Stored results as tables in Markdown: ``python -m rimroll_score.tables FOLDER PAGE.md``.

The page gets the tables of the folder's ``results.json`` between two comments, and the folder the
static page.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator, Sequence
from pathlib import Path

from rimroll_score.page import CHECKS, Bounds
from rimroll_score.results import EngineResult, load
from rimroll_score.sweep import grade

BEGIN, END = "<!-- results -->", "<!-- end of results -->"

NEAR = [f"{way}_{near}" for way in ("rolling", "sliding") for near in ("far", "near", "nearer")]
OTHERS = ["wobble", "euler_disk", "circle", "spin_fast", "spin_slow", "fall", "straight", "flight"]
NONE = "—"
"""What an engine does not have."""


class NoPlace(ValueError):
    """A page has no place for tables; the message says what it needs."""


def tables(results: Sequence[EngineResult]) -> str:
    """All tables, and on what they were measured."""
    shown = sorted(results, key=lambda one: one.name)
    return "\n".join(
        [
            "**Near-collisions of a can.** The rim rolls, slides without friction, or slips with "
            "friction 0.2; from far to nearer the sideways",
            "rates are 0.5, 0.1 and 0.02 rad/s.",
            "",
            *_grades(shown, [*NEAR, "friction"]),
            "",
            "**Other motions.** Steady wobble of the can, Euler's disk without dissipation, a disk "
            "that rolls once round a circle, coins that spin",
            "fast enough to stand and too slowly, a fall to the side, straight rolling, free "
            "flight. A dash: the engine has no such scene.",
            "",
            *_grades(shown, OTHERS),
            "",
            *_falls(shown),
            "",
            *_checks(shown),
            "",
            *_measured_on(shown),
        ]
    )


def put(page: str, text: str) -> str:
    """The page with the text in place of what stood between the two comments.

    Raises ``NoPlace`` for a page without them.
    """
    before, begin, rest = page.partition(BEGIN)
    _, end, after = rest.partition(END)
    if not begin or not end:
        raise NoPlace(f"the page needs the lines {BEGIN} and {END}")
    return f"{before}{BEGIN}\n{text}\n{END}{after}"


def _grades(results: Sequence[EngineResult], cases: Sequence[str]) -> Iterator[str]:
    """The largest steps that pass, in ms."""
    yield from _head(["engine, setting"], [name.replace("_", " ") for name in cases])
    for result, setting in _rows(results):
        cells = [_grade(result, case, setting) for case in cases]
        yield f"| {result.name} {result.version}, {setting} | {' | '.join(cells)} |"


def _grade(result: EngineResult, case: str, setting: str) -> str:
    runs = result.of(case, setting)
    if all(run.status == "unsupported" for run in runs):
        return NONE
    step = grade(runs, Bounds().angle, Bounds().energy)
    return "·" if step is None else f"{1e3 * step:g}"


def _falls(results: Sequence[EngineResult]) -> Iterator[str]:
    found = [(one, falls) for one in results for falls in one.falls]
    steps = " and ".join(sorted({f"{1e3 * falls.dt:g} ms" for _, falls in found}))
    yield f"**42 flicks** of the can with friction 0.2, at a step of {steps}: how many fell, how"
    yield "many of these to the true side of straight across, and the median error of the"
    yield "direction."
    yield ""
    yield from _head(["engine, setting"], ["fell", "true side", "median error"])
    for result, falls in found:
        fell = sum(one is not None for one in falls.directions)
        error = NONE if falls.median_error is None else f"{falls.median_error:.2g}°"
        yield f"| {result.name}, {falls.setting} | {fell} | {falls.right_sides} | {error} |"


def _checks(results: Sequence[EngineResult]) -> Iterator[str]:
    steps = {f"{1e3 * check.dt:g} ms" for one in results for check in one.checks}
    yield f"**Checks that need no truth**, at a step of {' and '.join(sorted(steps))}: by how much"
    yield "the turn of *rolling near* changes under a change that should not change it. *No turn*:"
    yield "the can lay down flat in one of the motions. A dash: the engine cannot move its table."
    yield ""
    yield from _head(["engine, setting"], list(CHECKS.values()))
    for result, setting in _rows(results):
        found = {one.name: one for one in result.checks if one.setting == setting}
        cells = []
        for name in CHECKS:
            one = found[name]
            plain = "no turn" if one.angle is None else f"{one.angle:.2g}°"
            cells.append(NONE if one.note else plain)
        yield f"| {result.name}, {setting} | {' | '.join(cells)} |"


def _measured_on(results: Sequence[EngineResult]) -> Iterator[str]:
    machines = {
        "{processor}, {cores} cores, {system}, Python {python}".format(**one.machine)
        for one in results
    }
    yield f"Measured on {'; '.join(sorted(machines))}, with"
    yield f"{'; '.join(sorted({one.scored_by for one in results}))}. The cost in `results.json` is"
    yield "processor time."
    differ = sorted({one.name for one in results if any(run.differ for run in one.runs)})
    if differ:
        yield f"Not deterministic, so the worst of ten runs counts: {', '.join(differ)}."
    elif not any("--repeats" in one.command for one in results):
        yield "Every engine gave the same numbers for *rolling near* in two processes."


def _rows(results: Sequence[EngineResult]) -> Iterator[tuple[EngineResult, str]]:
    for result in results:
        for setting in result.settings:
            yield result, setting


def _head(texts: Sequence[str], numbers: Sequence[str]) -> Iterator[str]:
    yield f"| {' | '.join([*texts, *numbers])} |"
    yield f"|{'---|' * len(texts)}{'--:|' * len(numbers)}"


def main(folder: Path, page: Path) -> None:
    """Write the tables into a page, and the static page and the films into the folder."""
    from rimroll_score import film
    from rimroll_score.page import write

    results = list(load(folder).values())
    page.write_text(put(page.read_text("utf-8"), tables(results)), "utf-8")
    for one in results:
        film.write(folder, one)
    write(folder, results, Bounds())


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(Path(sys.argv[1]), Path(sys.argv[2]))
