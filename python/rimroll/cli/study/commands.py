"""The commands of ``rimroll study``."""

from __future__ import annotations

import re
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import numpy as np
import typer
from rich.console import Console

from rimroll.cli.formats import Forms, check, pictures, write
from rimroll.cli.options import JsonOption, whole
from rimroll.cli.screen import prose, say, show_json, table, working
from rimroll.errors import RimrollError
from rimroll.study.axes import Axis
from rimroll.study.columns import TRIAL
from rimroll.study.plan import Plan, Probe, expect_room, free, in_bytes, in_time, probe, processors
from rimroll.study.run import claimed
from rimroll.study.run import run as compute
from rimroll.study.status import status_of
from rimroll.study.status import verify as look
from rimroll.study.store import Store
from rimroll.study.study import Study

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.figure import Figure


StudyArgument = Annotated[Path, typer.Argument(help="The study, a TOML file.", metavar="STUDY")]

StoredArgument = Annotated[
    Path,
    typer.Argument(help="The study, a TOML file, or the folder of its results.", metavar="STUDY"),
]

StoreOption = Annotated[
    Path | None,
    typer.Option(
        help="The folder with the results. [that of the file, or its name with .zarr]",
        metavar="PATH",
    ),
]

LargerOption = Annotated[
    bool,
    typer.Option("--larger-than-disk", help="Also if the results may not fit on the disk."),
]


def requested(path: Path) -> Study:
    """The study of a file; raises ``RimrollError``, which names the file."""
    if path.suffix.lower() != ".toml":
        raise RimrollError(f"a study is a .toml file, got {path}")
    return Study.from_file(path)


def place(study: Study, store: Path | None) -> Path:
    """The folder of the results: as typed, or that of the study of a file."""
    folder = store or study.store
    assert folder is not None
    return folder


def planned(study: Study, path: Path) -> Plan:
    """The plan of the study of a file; raises ``RimrollError``, which names the file."""
    try:
        return study.plan()
    except RimrollError as error:
        raise error.inside(f"{path}:") from None


def stored(path: Path, store: Path | None) -> tuple[Store, Plan | None]:
    """The store of the study of a file, with its plan; or the store in a folder.

    Raises ``RimrollError`` if the store is of another study.
    """
    if store is None and path.is_dir():
        return Store(path), None
    study = requested(path)
    opened = Store(place(study, store))
    plan = planned(study, path)
    opened.expect_study(plan)
    return opened, plan


def plan(
    study: StudyArgument,
    store: StoreOption = None,
    larger: LargerOption = False,
    json: JsonOption = False,
) -> int:
    """What a study varies, how much that is, and how long it takes.

    Every value is tried, and some rows are computed to measure the time. A study that may not fit
    on the disk is refused.

    Example:

    $ rimroll study plan turn_of_presets.toml
    """
    what = requested(study)
    whole = planned(what, study)
    folder = place(what, store)
    if not larger:
        expect_room(whole, folder)
    measured = probe(whole)
    if json:
        show_json(_answer(whole, folder, measured))
    else:
        _show(whole, folder, measured)
    return 0


def _answer(plan: Plan, store: Path, probe: Probe) -> dict[str, Any]:
    return {
        "title": plan.description.title,
        "kind": plan.attrs["kind"],
        "dims": dict(plan.dims),
        "rows": plan.rows,
        "chunk": plan.chunk,
        "chunks": plan.chunks,
        "variables": list(plan.variables),
        "bytes": plan.bytes,
        "store": str(store),
        "free": free(store),
        "seconds": probe.of(plan.rows),
        "attributes": dict(plan.attrs),
    }


def _show(plan: Plan, store: Path, probe: Probe) -> None:
    if plan.description.title:
        prose(plan.description.title)
        say()
    rows = table("axis", "of", "values", "from", "to", "unit")
    for axis in plan.description.axes:
        dim = "" if axis.along == axis.name else f" along {axis.along}"
        rows.add_row(axis.name + dim, axis.of, str(axis.size), *_ends(axis), axis.unit)
    for one in plan.description.randoms:
        unit = "" if one.unit == "1" else one.unit
        numbers = ", ".join(f"{name} {value:g}" for name, value in one.numbers.items())
        rows.add_row(one.name, one.of, "random", one.distribution, numbers, unit)
    if TRIAL in plan.dims:
        trials, sampling = plan.dims[TRIAL], plan.description.sampling.method
        rows.add_row(TRIAL, "", str(trials), sampling, f"seed {plan.attrs['seed']}", "")
    if rows.row_count:
        say(rows)
        say()
    _show_sizes(plan, store, probe)


def _show_sizes(plan: Plan, store: Path, probe: Probe) -> None:
    sizes = " x ".join(f"{size} {dim}" for dim, size in plan.dims.items())
    say(f"kind      {plan.attrs['kind']}")
    say(f"rows      {plan.rows:,} = {sizes}")
    say(f"chunks    {plan.chunks:,} of {plan.chunk:,} rows, {in_time(probe.of(plan.chunk))} each")
    kept = "statistics" if plan.statistics is not None else "columns"
    prose(f"{kept:9} {', '.join(plan.variables)}", hanging=10)
    room = f"{in_bytes(free(store))} are free"
    say(f"size      at most {in_bytes(plan.bytes)} in {store}; {room}")
    threads = processors()
    took = in_time(probe.of(plan.rows))
    say(f"time      {took} on the {threads} processors of this machine")


def _ends(axis: Axis) -> tuple[str, str]:
    ends = [axis.labels[0], axis.labels[-1]]
    first, last = (f"{end:.4g}" if isinstance(end, np.floating) else str(end) for end in ends)
    return first, last


EVERY = 60.0
"""Time (s) between two lines in a log."""


class Watcher:
    """Writes notes, and how far a run is, as lines."""

    def __init__(self) -> None:
        self.done = 0
        self._begin: tuple[float, int] | None = None
        self._written = time.monotonic()

    def progress(self, done: int, total: int) -> None:
        """Show that ``done`` motions are complete."""
        self.done = done
        now = time.monotonic()
        if self._begin is None:
            self._begin = now, done
        elif now - self._written >= EVERY:
            self._written = now
            begin, before = self._begin
            rate = (done - before) / (now - begin)
            left = f", {_time(total - done, rate)} left" if rate > 0.0 else ""
            self.note(f"{done:,} of {total:,} motions, {rate:,.0f}/s{left}")

    def note(self, text: str) -> None:
        """A sentence for the user."""
        print(text, file=sys.stderr, flush=True)


class Bar(Watcher):
    """Shows how far a run is by a bar with the rate and the time left."""

    def __init__(self, console: Console) -> None:
        from rich.progress import (
            BarColumn,
            Progress,
            ProgressColumn,
            Task,
            TextColumn,
            TimeRemainingColumn,
        )
        from rich.text import Text

        class Rate(ProgressColumn):
            def render(self, task: Task) -> Text:
                return Text(f"{task.speed:,.0f}/s" if task.speed else "")

        super().__init__()
        self.bar = Progress(
            TextColumn("{task.completed:,.0f} of {task.total:,.0f} motions"),
            BarColumn(),
            Rate(),
            TimeRemainingColumn(),
            console=console,
            transient=True,
            speed_estimate_period=120.0,
        )

    def progress(self, done: int, total: int) -> None:
        self.done = done
        if not self.bar.task_ids:  # what was done before says nothing about the rate
            self.bar.add_task("", total=total, completed=done)
        self.bar.update(self.bar.task_ids[0], completed=done, total=total)

    def note(self, text: str) -> None:
        self.bar.console.print(text, markup=False, highlight=False, soft_wrap=True)


@contextmanager
def watching() -> Iterator[Watcher]:
    """Shows how far a run is until the block ends."""
    console = Console(stderr=True)
    if not console.is_terminal:
        yield Watcher()
        return
    bar = Bar(console)
    with bar.bar:
        yield bar


def _time(rows: int, rate: float) -> str:
    seconds = round(rows / rate)
    hours, minutes = seconds // 3600, seconds // 60 % 60
    return f"{hours} h {minutes} min" if hours else f"{minutes} min {seconds % 60} s"


def _number(help: str) -> Any:
    """An option that is a number of processes or threads."""
    return typer.Option(help=help, metavar="NUMBER", parser=whole(least=1, most=10_000))


WorkersOption = Annotated[
    Any, _number("Number of processes on this machine to compute on; they share its processors.")
]

SchedulerOption = Annotated[
    str | None,
    typer.Option(help="Compute on a running Dask cluster: its address.", metavar="ADDRESS"),
]

ThreadsOption = Annotated[
    Any, _number("Threads in this process; one for each processor by default.")
]

ChunksOption = Annotated[
    str | None,
    typer.Option(
        help="Compute only these chunks, as 120:240, from the first to before the second.",
        metavar="A:B",
    ),
]

OtherVersionsOption = Annotated[
    bool,
    typer.Option(
        "--other-versions",
        help="Also continue a store, and use workers, of another build or version of rimroll, NumPy"
        " or SciPy; numbers may differ.",
    ),
]


def run(
    study: StudyArgument,
    store: StoreOption = None,
    larger: LargerOption = False,
    workers: WorkersOption = None,
    scheduler: SchedulerOption = None,
    threads: ThreadsOption = None,
    chunks: ChunksOption = None,
    other: OtherVersionsOption = False,
) -> int:
    """Compute what is not done of a study, into its store.

    Chunks that are done are kept, so run it again after Ctrl-C, a crash or a full disk.
    Jobs that compute other chunks, as of a Slurm array, share a store.

    Examples:

    $ rimroll study run falls.toml

    $ rimroll study run falls.toml --workers 4

    $ rimroll study run falls.toml --scheduler tcp://10.0.0.1:8786

    $ rimroll study run falls.toml --chunks 120:240
    """
    what = requested(study)
    folder = place(what, store)
    asked = planned(what, study)
    if not larger and not folder.exists():
        expect_room(asked, folder)
    with watching() as watcher:
        try:
            filled = compute(
                asked,
                folder,
                chunks=_range(chunks),
                workers=workers,
                scheduler=scheduler,
                threads=threads,
                other_versions=other,
                progress=watcher.progress,
                note=watcher.note,
            )
        except KeyboardInterrupt:
            watcher.note("what is done is kept: run again to continue")
            raise
    found = status_of(filled)
    say(f"{folder}: {found.motions_done:,} of {found.motions:,} motions are done")
    return 0


def _range(text: str | None) -> range | None:
    if text is None:
        return None
    found = re.fullmatch(r"\s*(\d+)\s*:\s*(\d+)\s*", text)
    if found is None:
        raise RimrollError(f"--chunks must be two whole numbers such as 120:240, got {text!r}")
    return range(int(found[1]), int(found[2]))


def status(study: StoredArgument, store: StoreOption = None, json: JsonOption = False) -> int:
    """How much of a study is done, and who is at work.

    Examples:

    $ rimroll study status falls.toml
    """
    opened, _ = stored(study, store)
    found = status_of(opened)
    if json:
        show_json({"store": str(opened.path), **vars(found)})
        return 0
    say(f"{opened.path}: {found.chunks_done:,} of {found.chunks:,} chunks are done")
    say(f"motions: {found.motions_done:,} of {found.motions:,}")
    if found.seconds is not None:
        say(f"a chunk took {found.seconds:.3g} s on average")
    if found.chunks_done == found.chunks and opened.unmerged:
        say("the statistics are not written: run writes them")
    for owner in found.owners:
        say(owner)
    return 0


@dataclass(frozen=True)
class View:
    """What is drawn."""

    quantities: tuple[str, ...]
    along: tuple[str, ...]
    places: dict[str, str]
    form: str | None

    def drawn(self, dataset: xr.Dataset) -> Figure:
        """The figure of a study."""
        from rimroll.study.figures import study_figure

        return study_figure(
            dataset, self.quantities, along=self.along, places=self.places, form=self.form
        )


def show(
    study: StoredArgument,
    store: StoreOption = None,
    of: Annotated[
        list[str] | None,
        typer.Option(
            help="What is drawn, such as turn, overturned or outcome=toppled; two are drawn against"
            " each other. [the first that there is]",
            metavar="QUANTITY",
        ),
    ] = None,
    along: Annotated[
        list[str] | None,
        typer.Option(help="A dimension for an axis; may be repeated.", metavar="DIMENSION"),
    ] = None,
    at: Annotated[
        list[str] | None,
        typer.Option(help="A value of another dimension; may be repeated.", metavar="NAME=VALUE"),
    ] = None,
    form: Annotated[
        str | None,
        typer.Option("--as", help="map, curve or histogram.", metavar="FORM"),
    ] = None,
    output: Annotated[
        list[Path] | None,
        typer.Option(
            "--output", "-o", help="Draw a .png, .svg or .pdf; may be repeated.", metavar="FILE"
        ),
    ] = None,
    json: JsonOption = False,
) -> int:
    """Maps, curves and histograms of a finished or partial study.

    Dimensions with words, and one more, have a panel for each value; trials are averaged. Without
    -o, the quantities that can be drawn are listed with their ranges.

    Examples:

    $ rimroll study show turn_of_presets.toml -o turns.svg

    $ rimroll study show turns.zarr --of turn --as curve --along friction --at body=coin -o c.svg
    """
    files = output or []
    view = View(tuple(of or ()), tuple(along or ()), _places(at or ()), form)
    forms: Forms[xr.Dataset] = pictures(view.drawn)
    check(files, forms)
    dataset = _opened(study, store)
    for file in files:
        write(file, dataset, forms)
    if json:
        show_json({"quantities": _ranges_of(dataset, view), "files": [str(file) for file in files]})
    elif files:
        for file in files:
            say(f"wrote {file}")
    else:
        _show_ranges(dataset, view)
    return 0


def _places(given: Any) -> dict[str, str]:
    found = {}
    for one in given:
        name, equals, value = one.partition("=")
        if not equals:
            raise RimrollError(f"--at must be NAME=VALUE, got {one!r}")
        found[name] = value
    return found


def _opened(path: Path, store: Path | None) -> xr.Dataset:
    """The dataset of a store; of a partial one with statistics, those of the chunks so far."""
    from rimroll.study.plan import dataset_of

    results, plan = stored(path, store)
    if (results.finished and not results.unmerged) or not results.merged:
        return results.open()
    if plan is None:
        raise RimrollError(
            f"{path} is not finished: give the study, a .toml file, to see its statistics so far"
        )
    assert plan.statistics is not None
    done = sorted(results.marks.done())
    return dataset_of(plan, plan.statistics.merged(map(results.numbers.read, done)))


def _ranges_of(dataset: xr.Dataset, view: View) -> dict[str, dict[str, Any]]:
    """The number of values, the least, the mean and the largest of each quantity."""
    from rimroll.study.quantities import at, names, quantity_of

    found = {}
    for name in view.quantities or names(dataset):
        array = at(quantity_of(dataset, name), view.places)
        values = array.values[np.isfinite(array.values)]
        ends = (
            map(float, (values.min(), values.mean(), values.max())) if values.size else [None] * 3
        )
        numbers = dict(zip(("least", "mean", "largest"), ends, strict=True))
        found[name] = {"unit": array.attrs.get("units", ""), "values": values.size, **numbers}
    return found


def _show_ranges(dataset: xr.Dataset, view: View) -> None:
    if dataset.attrs.get("title"):
        prose(dataset.attrs["title"])
    say(", ".join(f"{size} {dim}" for dim, size in dataset.sizes.items()))
    say()
    rows = table("quantity", "values", "least", "mean", "largest", "unit")
    for name, one in _ranges_of(dataset, view).items():
        ends = [
            "" if one[key] is None else f"{one[key]:.5g}" for key in ("least", "mean", "largest")
        ]
        if one["values"] and ("=" not in name or one["largest"] > 0.0):  # no word that never occurs
            rows.add_row(name, f"{one['values']:,}", *ends, one["unit"])
    say(rows)


RepairOption = Annotated[
    bool, typer.Option("--repair", help="Forget that damaged chunks are done: run computes them.")
]


def verify(
    study: StoredArgument,
    store: StoreOption = None,
    repair: RepairOption = False,
    json: JsonOption = False,
) -> int:
    """Read all numbers of a store again, and print one hash of them.

    The hash is that of all numbers and coordinates. Equal studies have equal hashes, whatever the
    chunks and the machines. The exit code is 1 if chunks are damaged or missing.

    Examples:

    $ rimroll study verify falls.toml

    $ rimroll study verify falls.toml --repair
    """
    opened, _ = stored(study, store)
    with working("reading") as bar:
        found = look(opened, lambda done, total: bar(done, total, ""))
    unwritten = opened.unmerged
    if repair and (found.damaged or found.unmerged):
        with claimed(opened.marks.folder, 0, opened.blocks.number):
            opened.marks.remove_merged()
            for chunk in found.damaged:
                opened.marks.remove(chunk)
    if json:
        show_json({"store": str(opened.path), **vars(found), "repaired": repair})
    else:
        then = "run computes them again" if repair else "--repair has run compute them again"
        if found.damaged:
            say(f"damaged chunks: {_spans(found.damaged)}; {then}")
        if found.unmerged and unwritten:
            say("the statistics are not written: run writes them")
        elif found.unmerged:
            say(f"damaged statistics; {then}")
        if found.missing:
            say(f"missing chunks: {_spans(found.missing)}; run computes them")
        if found.sha256:
            say(f"sha256 {found.sha256}")
    return 0 if found.sha256 else 1


def _spans(chunks: list[int]) -> str:
    """Numbers in order, neighbours together.

    >>> _spans([1, 2, 3, 7])
    '1-3, 7'
    """
    spans: list[list[int]] = []
    for chunk in chunks:
        if spans and spans[-1][1] == chunk - 1:
            spans[-1][1] = chunk
        else:
            spans.append([chunk, chunk])
    return ", ".join(f"{a}-{b}" if b > a else str(a) for a, b in spans)
