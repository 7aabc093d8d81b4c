"""The tables of a run: Markdown for people, CSV with every point."""

from __future__ import annotations

import csv
import math
from collections.abc import Iterable
from pathlib import Path

from .contestants import COORDINATES, LAWS, OF_A_MOTION, Contestant
from .results import Results, Row, best_peer, cheapest, contestants

ERRORS = (1e-6, 1e-9, 1e-12)
COMPARED_AT = (1e-9, 1e-12)
MOTION_ERROR = 1e-9


def write(results: Results, folder: Path) -> None:
    (folder / "table.md").write_text(page(results), "utf-8")
    write_points(results, folder / "points.csv")


def put_between(path: Path, name: str, text: str) -> None:
    """Replaces the text between two marks of a name in a page."""
    before, after = f"<!-- the {name}: ", f"<!-- the {name} end -->"
    page = path.read_text("utf-8")
    head, rest = page.split(before)
    mark = rest.split("\n")[0]
    tail = rest.split(after)[1]
    path.write_text(f"{head}{before}{mark}\n{text}\n{after}{tail}", "utf-8")


def summary(results: Results) -> str:
    """The cost of a turn for every contestant under both laws, in one table."""
    head = ["µs a turn, one core", "coordinates"]
    head += [f"{words}, {power(error)}" for words in LAWS.values() for error in COMPARED_AT]
    table = [
        _who(one)
        + [cost(cheapest(results.turns, one, law, error)) for law in LAWS for error in COMPARED_AT]
        for one in contestants(results.turns)
    ]
    table = [row for row in table if any(cell != "—" for cell in row[2:])]
    return "\n\n".join(
        [
            _machine(results),
            markdown(head, table),
            "Who is not in the table had no setting with all turns within 10⁻⁹ rad: "
            + "; ".join(_left_out(results))
            + ".",
            motions_table(results.motions, "µs a motion of 2 s, to 10⁻⁹ rad"),
        ]
    )


def _left_out(results: Results) -> list[str]:
    rows = results.turns
    return [
        f"{one.label} (best: {min(r.worst for r in rows if r.key == one.key):.0e} rad)"
        for one in contestants(rows)
        if not any(cheapest(rows, one, law, COMPARED_AT[0]) for law in LAWS)
    ]


def page(results: Results) -> str:
    """All tables, and the machine."""
    parts = [
        "# rimroll against its peers",
        _machine(results),
        "Cost of one turn of the can of 2007, from the release to the tilt maximum after the "
        "near-collision: µs of one core, at the cheapest setting with which the *worst* of 60 "
        "turns is within 10⁻⁶, 10⁻⁹ and 10⁻¹² rad of the truth (— where no setting gets there); "
        "and the cost of the best peer, of all in either coordinates, over its own.",
    ]
    for law, words in LAWS.items():
        parts += [f"## A turn {words}", turns_table(results.turns, law)]
    parts += [
        "## One motion",
        "The paper's motion over two seconds without slip and without friction: µs of one core, at "
        "the cheapest setting with yaw and tilt at its end within 10⁻⁹ rad of the truth. rimroll "
        "keeps every step for dense output and finds all events; heyoka finds the tilt's extrema; "
        "Boost.odeint does neither.",
        motions_table(results.motions),
    ]
    return "\n\n".join(parts) + "\n"


def _machine(results: Results) -> str:
    machine = results.machine
    versions = ", ".join(f"{name} {version}" for name, version in machine["versions"].items())
    peak = machine.get("peak_flops") or {}
    of_peak = (
        f" Measured peak of a core, in vectors of {peak['lanes']}: {peak['separate'] / 1e9:.0f} "
        f"GFLOP/s, {peak['fused'] / 1e9:.0f} with fused multiply-add."
        if peak
        else ""
    )
    return (
        f"Measured on one core of {machine['processor']}, {machine['cores']} cores, "
        f"{machine['system']}; medians of {results.rounds} rounds.{of_peak} Versions: {versions}."
    )


def markdown(head: list[str], rows: Iterable[list[str]]) -> str:
    lines = [head, ["---"] * 2 + ["--:"] * (len(head) - 2), *rows]
    return "\n".join("| " + " | ".join(cells) + " |" for cells in lines)


def _who(one: Contestant) -> list[str]:
    name = f"**{one.name}**" if one.is_ours else one.name
    return [name + (f" ({60 // one.every} starts)" if one.every > 1 else ""), _where(one)]


def _where(one: Contestant) -> str:
    return "integrals" if "quadrature" in one.method else COORDINATES[one.coordinates]


def cost(row: Row | None) -> str:
    return "—" if row is None else _three_digits(1e6 * row.seconds)


def _three_digits(value: float) -> str:
    if value >= 1000.0:
        return f"{float(f'{value:.3g}'):,.0f}".replace(",", " ")
    return f"{value:#.3g}".rstrip(".")


def turns_table(rows: list[Row], law: str) -> str:
    head = ["", "coordinates", *(f"at {power(e)} rad" for e in ERRORS), "best error"]
    head += [f"best peer / this at {power(error)}" for error in COMPARED_AT]
    table = []
    everyone = contestants(rows)
    for one in everyone:
        mine = [row for row in rows if row.key == one.key and row.law == law]
        best = min((row.worst for row in mine), default=math.inf)
        cells = [cost(cheapest(rows, one, law, error)) for error in ERRORS]
        cells.append(f"{best:.0e}" if math.isfinite(best) else "—")
        for error in COMPARED_AT:
            row, peer = cheapest(rows, one, law, error), best_peer(rows, law, error, everyone)
            cells.append(f"{peer.times_of(row):.3g}" if row and peer else "—")
        table.append(_who(one) + cells)
    return markdown(head, table)


def motions_table(rows: list[Row], title: str = "") -> str:
    table = []
    for one in contestants(rows, OF_A_MOTION):
        costs = [cost(cheapest(rows, one, law, MOTION_ERROR)) for law in LAWS]
        table.append([*_who(one), *costs])
    return markdown([title, "coordinates", *LAWS.values()], table)


def power(error: float) -> str:
    high = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
    return "10" + str(round(math.log10(error))).translate(high)


def write_points(results: Results, path: Path) -> None:
    """Every point of the run; errors in rad, cost in µs a start."""
    with path.open("w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        head = ["study", "method", "coordinates", "law", "tolerance", "eps", "starts_every"]
        writer.writerow([*head, "worst_error_rad", "median_error_rad", "cost_us", "rounds"])
        for study in "turns", "near", "motions":
            for row in getattr(results, study):
                who = [study, row.method, row.coordinates, row.law, row.tolerance]
                of = ["" if row.eps is None else row.eps, row.every]
                found = [f"{row.worst:.3e}", f"{row.median:.3e}", f"{1e6 * row.seconds:.4g}"]
                writer.writerow([*who, *of, *found, len(row.rounds)])
