"""Stored results as tables in Markdown: ``python -m rimroll_score.tables FOLDER PAGE.md``.

The page gets the tables of the folder's ``results.json`` and ``search.json`` between comments, and
the folder the static page.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

from rimroll_score import search
from rimroll_score.page import CHECKS, Bounds, in_ms, in_words
from rimroll_score.paths import NEAR as NEAR_CASE
from rimroll_score.results import EngineResult, load
from rimroll_score.search import Tried
from rimroll_score.sweep import STEPS, grade

NEAR = [f"{way}_{near}" for way in ("rolling", "sliding") for near in ("far", "near", "nearer")]
OTHERS = ["wobble", "euler_disk", "circle", "spin_fast", "spin_slow", "fall", "straight", "flight"]
NONE = "—"
"""What an engine does not have."""
STEP = 1e-4
"""Step of the table of costs, s."""
REPRODUCED = [
    ("steps that are too long", "mujoco", "best"),
    ("a contact of fixed softness", "mujoco", "defaults"),
    ("a rim that is a polygon", "mujoco", "polygon"),
    ("a contact that comes late", "dart", "ode"),
    ("friction once for all contacts", "rapier", "defaults"),
    ("friction that is proportional to small slip", "exudyn", "defaults"),
    ("losses that nobody asked for", "pybullet", "defaults"),
    ("an angle that is right, an energy that is not", "dart", "defaults"),
]
"""What goes wrong, and the engine and setting that show it."""
SHOWN_IN = {
    "friction once for all contacts": "circle",
    "friction that is proportional to small slip": "circle",
    "losses that nobody asked for": "flight",
}
"""The cases that show it, where that is not ``rolling_near``."""


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
            *_costs(shown),
            "",
            *_measured_on(shown),
        ]
    )


def put(page: str, name: str, text: str) -> str:
    """The page with the text in place of what stood between the two comments of that name.

    Raises ``NoPlace`` for a page without them.
    """
    begin, end = f"<!-- {name} -->", f"<!-- end of {name} -->"
    before, found, rest = page.partition(begin)
    _, closed, after = rest.partition(end)
    if not found or not closed:
        raise NoPlace(f"the page needs the lines {begin} and {end}")
    return f"{before}{begin}\n{text}\n{end}{after}"


def filled(page: str, results: Sequence[EngineResult], tried: Sequence[Tried]) -> str:
    """The page with all tables."""
    page = put(page, "results", tables(results))
    page = put(page, "search", searched(tried))
    return put(page, "reproductions", reproductions(results))


def searched(tried: Sequence[Tried]) -> str:
    """The options of the best settings and what else was tried."""
    lines = list(_head(["engine", "option", "best", "other values"], []))
    for engine in sorted({one.engine for one in tried}):
        all_of = [one for one in tried if one.engine == engine]
        plain = next(one for one in all_of if not one.option)
        lines.append(f"| {engine} {plain.version} | | {_misfit(plain)} | |")
        for option in dict.fromkeys(one.option for one in all_of if one.option):
            others = [one for one in all_of if one.option == option]
            texts = [f"{_value(one.value)}: {_misfit(one)}" for one in others]
            best = _value(plain.value[option])
            lines.append(f"| | {option.replace('_', ' ')} | {best} | {'; '.join(texts)} |")
    return "\n".join(lines)


def _misfit(one: Tried) -> str:
    return f"{one.passed} of {one.runs}, {one.misfit:+.2f}"


def _value(value: Any) -> str:
    if isinstance(value, bool):
        return "yes" if value else "no"
    return f"{value:g}" if isinstance(value, int | float) else str(value)


def reproductions(results: Sequence[EngineResult]) -> str:
    """Commands that show what goes wrong, and what they show at three steps."""
    by_name = {one.name: one for one in results}
    lines = list(_head(["what goes wrong", "engine, setting, case", "it shows"], []))
    for wrong, engine, setting in REPRODUCED:
        result, case = by_name[engine], SHOWN_IN.get(wrong, NEAR_CASE)
        runs = [run for run in result.of(case, setting) if run.measured]
        shown = [run for run in runs if run.dt in (1e-3, 1e-4, 2e-5)]
        texts = [f"{in_ms(run.dt)}: {in_words(run)}" for run in shown]
        if setting == "polygon":
            checks = [one for one in result.checks if one.setting == setting]
            turned = next(one.angle for one in checks if one.name == "spin")
            texts.append(f"turned about its own axis, the can rises {turned:.2g}° elsewhere")
        lines.append(f"| {wrong} | `{engine}`, `{setting}`, `{case}` | {'; '.join(texts)} |")
    return "\n".join(lines)


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
    if step is not None:
        return f"{1e3 * step:g}"
    finest = min(run.dt for run in runs)
    return "·" if finest == min(STEPS) else f"· to {1e3 * finest:g}"


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
        if not found:
            continue
        cells = []
        for name in CHECKS:
            one = found[name]
            plain = "no turn" if one.angle is None else f"{one.angle:.2g}°"
            cells.append(NONE if one.note else plain)
        yield f"| {result.name}, {setting} | {' | '.join(cells)} |"


def _costs(results: Sequence[EngineResult]) -> Iterator[str]:
    (itself,) = (one for one in results if one.name == "rimroll")
    unit = next(run.cost for run in itself.of(NEAR_CASE, "defaults") if run.dt == max(STEPS))
    assert unit is not None
    yield f"**Cost**: processor time of *rolling near* at a step of {in_ms(STEP)}, and of *rolling"
    yield "far* at the largest step that passes, in units of what rimroll takes for *rolling near*"
    yield f"({1e3 * unit:.2g} ms per simulated second on the machine named below)."
    yield ""
    yield from _head(["engine, setting"], [f"at {in_ms(STEP)}", "far, where it passes"])
    for result, setting in _rows(results):
        near = [run.cost for run in result.of(NEAR_CASE, setting) if run.dt == STEP]
        far = result.of("rolling_far", setting)
        step = grade(far, Bounds().angle, Bounds().energy)
        passing = [run.cost for run in far if run.dt == step]
        cells = [_ratio(costs, unit) for costs in (near, passing)]
        yield f"| {result.name}, {setting} | {' | '.join(cells)} |"


def _ratio(costs: Sequence[float | None], unit: float) -> str:
    if not costs or costs[0] is None:
        return NONE
    return f"{float(f'{costs[0] / unit:.2g}'):g}"


def _measured_on(results: Sequence[EngineResult]) -> Iterator[str]:
    machines = {
        "{processor}, {cores} cores, {system}, Python {python}".format(**one.machine)
        for one in results
    }
    yield f"Measured on {'; '.join(sorted(machines))}, with"
    yield f"{'; '.join(sorted({one.scored_by for one in results}))}, while the machine also did"
    yield "other work."
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
    page.write_text(filled(page.read_text("utf-8"), results, search.load(folder)), "utf-8")
    for one in results:
        film.write(folder, one)
    write(folder, results, Bounds())


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(Path(sys.argv[1]), Path(sys.argv[2]))
