"""What the IFToMM library of benchmark problems takes: ``python make.py FOLDER``.

Writes the description as PDF, the reference result, rimroll's own result with its error and
processor time, and an archive of what else helps. ``python make.py --reference`` computes
``reference.txt`` again.
"""

from __future__ import annotations

import argparse
import json
import sys
import time
import zipfile
from dataclasses import asdict
from pathlib import Path
from typing import Any

import error
import numpy as np
from matplotlib.figure import Figure
from matplotlib.patches import Polygon

import rimroll as rr
from rimroll.figures.style import figure_style
from rimroll_score.cases import Case, cases
from rimroll_score.euler import frame
from rimroll_score.machine import machine
from rimroll_score.paths import start_of

HERE = Path(__file__).parent
NAME = "rocking_can"
CASE = "rolling_near"
EVERY = 0.01
"""Time between the rows of a result, s."""
RTOL = 1e-13
"""Relative tolerance of the reference."""
REPEATS = 20
"""Runs of which the shortest processor time counts."""

HEADER = (
    "t (s), x y z of the centre of mass (m), x y z of the unit vector of the axis, "
    "kinetic and potential energy (J)"
)


def the_case() -> Case:
    """The case of the scorecard that the problem is."""
    return next(case for case in cases() if case.name == CASE)


def solved(**options: Any) -> error.Array:
    """The rows of a result by rimroll."""
    case = the_case()
    body = rr.Body(**asdict(case.scene.body))
    count = round(case.duration / EVERY)
    times = EVERY * np.arange(count + 1)
    motion = rr.simulate(
        body, start_of(case), rr.NoSlip(), duration=times[-1], gravity=case.scene.gravity, **options
    )
    found = motion.evaluate(times)
    center = found.center + (case.state.position - found.center[0])
    axes = np.array([frame(*angles) for angles in zip(found.tilt, found.yaw, strict=True)])
    rows = [times, center, axes[:, :, 2], found.energy]
    return np.column_stack(rows) + 0.0  # without -0


def write_rows(file: Path, rows: error.Array) -> None:
    """A result file."""
    np.savetxt(file, rows, fmt="%.12g", header=HEADER)


def figure(file: Path, rows: error.Array) -> None:
    """The can from the side, and the reference: tilt, and the tip of the axis from above."""
    body, tilt = the_case().scene.body, np.arccos(rows[:, 6])
    with figure_style():
        drawn = Figure(figsize=(6.6, 2.5), layout="constrained")
        side, falls, above = drawn.subplots(1, 3, width_ratios=[0.9, 1.0, 1.3])
        _side(side, body, float(tilt[0]))
        falls.plot(rows[:, 0], np.degrees(tilt))
        falls.set_xlabel("$t$, s")
        falls.set_ylabel("tilt, degrees")
        above.plot(rows[:, 4], rows[:, 5])
        above.plot(*rows[0, 4:6], "o", color="black")
        above.set_aspect("equal")
        above.set_xlabel("$k_x$")
        above.set_ylabel("$k_y$")
        drawn.savefig(file, metadata={"Date": None})


def _side(axis: Any, body: Any, tilt: float) -> None:
    """The can in its plane of symmetry at the start."""
    e = np.array([np.cos(tilt), np.sin(tilt)])  # from the contact to the base's centre
    k = np.array([-np.sin(tilt), np.cos(tilt)])
    width, length = 2.0 * body.radius * e, 2.0 * body.height * k
    corners = [0.0 * e, width, width + length, length]
    axis.add_patch(Polygon(corners, fill=False, linewidth=1.2))
    center = body.radius * e + body.height * k
    axis.plot(*center, "o", color="black", markersize=3)
    axis.annotate("$G$", center, (4, -9), textcoords="offset points")
    axis.annotate("$C$", (0.0, 0.0), (-9, 4), textcoords="offset points")
    tip = center + 0.05 * k
    arrow = {"arrowstyle": "->"}
    axis.annotate("", tip, center, arrowprops=arrow)
    axis.annotate("$\\mathbf{k}$", tip, (4, 0), textcoords="offset points")
    rim = 0.05 * e
    axis.annotate("", rim, (0.0, 0.0), arrowprops=arrow)
    axis.annotate("$\\mathbf{e}$", rim, (2, 4), textcoords="offset points")
    axis.axhline(0.0, color="black", linewidth=1.0)
    axis.set_aspect("equal")
    axis.set_xlim(-0.09, 0.11)
    axis.set_axis_off()


def write_description(folder: Path, rows: error.Array) -> Path:
    """The PDF."""
    import typst  # of the group ``docs``

    case = the_case()
    picture = folder / "figure.svg"
    figure(picture, rows)
    data = {
        "body": asdict(case.scene.body),
        "start": {name: value.tolist() for name, value in vars(case.state).items()},
        "gravity": case.scene.gravity,
        "duration": case.duration,
        "rows": len(rows),
        "truth": case.truth,
        "largest_error": error.LARGEST_ERROR,
        "largest_energy": error.LARGEST_ENERGY,
        "energy": rows[0, 7],
    }
    (folder / "data.json").write_text(json.dumps(data), "utf-8")
    source = folder / "description.typ"
    source.write_bytes((HERE / "description.typ").read_bytes())
    made = folder / f"{NAME}.pdf"
    typst.compile(source, output=made, root=folder)
    for used in (source, picture, folder / "data.json"):
        used.unlink()
    return made


def write_solution(folder: Path, reference: error.Array) -> None:
    """rimroll's result at its default tolerance, and what the form asks about it."""
    spent = []
    for _ in range(REPEATS):
        before = time.process_time()
        rows = solved()
        spent.append(time.process_time() - before)
    write_rows(folder / f"{NAME}_by_rimroll.txt", rows)
    off, energy = error.errors(rows, reference)
    known = {
        "accuracy": f"{off:.3g}",
        "change of energy": f"{energy:.3g}",
        "processor time, s": f"{min(spent):.3g}",
        "software": f"rimroll {rr.__version__}, rimroll.simulate, defaults",
        **machine(),
    }
    lines = [f"{name}: {value}" for name, value in known.items()]
    (folder / f"{NAME}_by_rimroll_form.txt").write_text("\n".join(lines) + "\n", "utf-8")


def write_archive(folder: Path) -> None:
    """What may be uploaded along: the code of the error, of rimroll's result and of this PDF."""
    with zipfile.ZipFile(folder / f"{NAME}_code.zip", "w", zipfile.ZIP_DEFLATED) as archive:
        for name in ("error.py", "make.py", "description.typ", "reference.txt", "README.md"):
            archive.write(HERE / name, name)


def main() -> None:
    """Write everything into a folder."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", nargs="?", type=Path, default=Path("out/iftomm"))
    parser.add_argument("--reference", action="store_true")
    options = parser.parse_args()
    if options.reference:
        write_rows(error.REFERENCE, solved(rtol=RTOL))
        return
    reference = error.read(error.REFERENCE)
    options.folder.mkdir(parents=True, exist_ok=True)
    made = write_description(options.folder, reference)
    (options.folder / f"{NAME}_result.txt").write_bytes(error.REFERENCE.read_bytes())
    write_solution(options.folder, reference)
    write_archive(options.folder)
    print(f"The description is {made}.", file=sys.stderr)


if __name__ == "__main__":
    main()
