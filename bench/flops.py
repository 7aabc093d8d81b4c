"""The floating-point operations of a turn, counted in the compiled code itself.

Valgrind's callgrind counts how often each instruction of the core ran, and objdump shows what each
does; the operations in all vector lanes are added up. Two runs with different numbers of turns
separate the cost of a turn from that of starting up. Run after `make bench`:

    .venv/bin/python bench/flops.py
"""

from __future__ import annotations

import json
import os
import re
import subprocess
import tempfile
from collections import Counter
from pathlib import Path

from contest.contestants import BUILT, LAWS, ROOT
from contest.results import Results
from contest.starts import SIXTY
from contest.tables import put_between

CORE = BUILT / "core-rs/release/core-rs"
ENGINES = {
    "quadrature": ("core_quadrature", 1e-12),
    "stepping, at 10⁻⁹": ("core_ensemble", 1e-9),
}
"""The engines by the names that the core's worker uses, and their tolerances."""

FEWER, MORE = 10, 30
"""How many times the sixty starts are computed."""

ARITHMETIC = re.compile(r"v?(add|sub|mul|div|sqrt|addsub|fn?m(?:add|sub)\d*)([ps])d$")
FUSED = 2


def instructions() -> dict[int, tuple[str, int]]:
    """The arithmetic instructions of the program: kind and operations, by address."""
    listing = subprocess.run(
        ["objdump", "--disassemble", "--no-show-raw-insn", CORE],
        capture_output=True,
        text=True,
        check=True,
    ).stdout
    found = {}
    for line in listing.splitlines():
        match = re.match(r"\s*([0-9a-f]+):\s+(\S+)\s*(.*)", line)
        if match and (arithmetic := ARITHMETIC.match(match[2])):
            kind, packed = arithmetic[1], arithmetic[2] == "p"
            lanes = 1 if not packed else 8 if "zmm" in match[3] else 4 if "ymm" in match[3] else 2
            each = FUSED if kind.startswith("f") else 1
            found[int(match[1], 16)] = (kind, lanes * each)
    return found


def executed(question: str, folder: Path) -> Counter[int]:
    """How often each instruction of the program ran to answer a question."""
    profile = folder / "profile"
    subprocess.run(
        [
            *("valgrind", "--tool=callgrind", "--dump-instr=yes", "--compress-pos=no"),
            *("--compress-strings=no", f"--callgrind-out-file={profile}", str(CORE)),
        ],
        input=question,
        text=True,
        capture_output=True,
        check=True,
        env={**os.environ, "RAYON_NUM_THREADS": "1"},
    )
    counts: Counter[int] = Counter()
    inside, skip = False, False
    for line in profile.read_text().splitlines():
        if line.startswith("ob="):
            inside = line.endswith("core-rs")
        elif line.startswith("calls="):
            skip = True  # the next line is the cost of the callee
        elif line.startswith("0x"):
            if inside and not skip:
                address, *_, cost = line.split()
                counts[int(address, 16)] += int(cost)
            skip = False
    return counts


def of_a_turn(method: str, law: str, tolerance: float) -> dict[str, float]:
    """Operations of each kind, and all instructions, per turn."""
    known = instructions()
    with tempfile.TemporaryDirectory() as folder:
        runs = []
        for times in FEWER, MORE:
            question = f"turn {method} regular {law} {tolerance!r} {times} {SIXTY}\n"
            runs.append(executed(question, Path(folder)))
    fewer, more = runs
    turns = 60 * (MORE - FEWER)
    totals: Counter[str] = Counter()
    for address, count in more.items():
        extra = (count - fewer[address]) / turns
        totals["instructions"] += extra
        if address in known:
            kind, operations = known[address]
            totals[kind] += operations * extra
            totals["flops"] += operations * extra
            totals["arithmetic instructions"] += extra
    return dict(totals)


def table(results: Results) -> str:
    """Operations, speed and fraction of the peak, one line for each engine and law."""
    peak = results.machine["peak_flops"]["separate"]
    head = ["", "law", "operations a turn", "of them ÷ and √", "instructions", "time"]
    lines = [[*head, "GFLOP/s", f"of {peak / 1e9:.1f}"]]
    lines.append(["---"] * 2 + ["--:"] * 6)
    for name, (method, tolerance) in ENGINES.items():
        for law, words in LAWS.items():
            counted = of_a_turn(method, law, tolerance)
            measured = [r for r in results.turns if r.method == method and r.law == law]
            seconds = next(r.seconds for r in measured if r.tolerance == tolerance)
            flops = counted["flops"]
            lines.append(
                [
                    name,
                    words,
                    f"{flops:,.0f}".replace(",", " "),
                    f"{counted['div'] + counted['sqrt']:,.0f}".replace(",", " "),
                    f"{counted['instructions']:,.0f}".replace(",", " "),
                    f"{1e6 * seconds:.3g} µs",
                    f"{flops / seconds / 1e9:.1f}",
                    f"**{100 * flops / seconds / peak:.0f} %**",
                ]
            )
    return "\n".join("| " + " | ".join(cells) + " |" for cells in lines)


def main() -> None:
    text = (ROOT / "bench/results/results.json").read_text("utf-8")
    put_between(ROOT / "docs/performance.md", "profile", table(Results.from_json(json.loads(text))))


if __name__ == "__main__":
    main()
