"""``rimroll study show``: maps, curves and histograms of a finished or partial study."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import numpy as np
import typer

from rimroll.cli.formats import Forms, check, pictures, write
from rimroll.cli.options import JsonOption
from rimroll.cli.screen import prose, say, show_json, table
from rimroll.cli.study.options import (
    StoredArgument,
    StoreOption,
    stored,
)
from rimroll.errors import RimrollError

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.figure import Figure


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
        show_json({"quantities": _ranges(dataset, view), "files": [str(file) for file in files]})
    elif files:
        for file in files:
            say(f"wrote {file}")
    else:
        _show(dataset, view)
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
    from rimroll.study.dataset import dataset_of

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


def _ranges(dataset: xr.Dataset, view: View) -> dict[str, dict[str, Any]]:
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


def _show(dataset: xr.Dataset, view: View) -> None:
    if dataset.attrs.get("title"):
        prose(dataset.attrs["title"])
    say(", ".join(f"{size} {dim}" for dim, size in dataset.sizes.items()))
    say()
    rows = table("quantity", "values", "least", "mean", "largest", "unit")
    for name, one in _ranges(dataset, view).items():
        ends = [
            "" if one[key] is None else f"{one[key]:.5g}" for key in ("least", "mean", "largest")
        ]
        if one["values"] and ("=" not in name or one["largest"] > 0.0):  # no word that never occurs
            rows.add_row(name, f"{one['values']:,}", *ends, one["unit"])
    say(rows)
