"""Studies: many motions as one object, described in a file or in Python."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping, Sequence
from dataclasses import asdict, replace
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from rimroll.bodies.body import Body, one_body
from rimroll.errors import RimrollError, callback
from rimroll.experiment.release import Release
from rimroll.laws import Law, one_law
from rimroll.scenario import RESISTANCES
from rimroll.state import State, single

if TYPE_CHECKING:
    import xarray as xr

    from rimroll.study.columns import Progress
    from rimroll.study.description import Description
    from rimroll.study.plan import Plan

Varied = Mapping[str, Any]
"""What varies, by name or by key."""


class Study:
    """A computation over many bodies, frictions, starts and records.

    A study is described by tables like those of a scenario file and by what varies of them. Random
    numbers of a row depend on the seed and on the number of the row only, so results depend on no
    chunk, order or process.

    Parameters
    ----------
    kind
        What is computed for each row: ``ensemble``, ``topple``, ``exact_turn`` or ``shake``, with
        the columns of :func:`rimroll.ensemble`, :func:`rimroll.topple`, :func:`rimroll.exact_turn`
        and :func:`rimroll.shake_many`; or ``fit``, which simulates an experiment with a known
        friction and fits it, as :func:`rimroll.fit` does.
    body, law, start, release, ground, simulation
        What rolls, how its rim meets the table, how it starts, how the table moves, and how motions
        are followed: tables as in scenario files, or a ``Body``, ``Law``, ``State`` or ``Release``.
    fit
        The experiments of a study of fits: a table with the number of ``falls``, the
        ``reading_error`` and the standard deviation of the ``bias``.
    axes
        What is varied systematically: the values, or a table with ``values``, ``range`` or
        ``log_range``, by a key such as ``"law.friction"``; or, by another name, a table with
        ``of``, the key.
    random
        What is drawn for each row: tables with ``distribution`` and its numbers, by key or name.
    trials
        The number of rows at each place of the axes.
    seed
        Seed of all random numbers, a whole number >= 0.
    combine
        ``product``, all combinations of the values of the axes, or ``zip``, the first of each axis,
        the second of each, and so on.
    sampling
        How trials are drawn: ``independent``, ``common``, ``sobol`` or ``latin_hypercube``.
    keep
        The columns that are kept, or ``"all"``.
    statistics
        What is kept of the columns in place of these: a table with ``over``, ``count``, ``mean``,
        ``extremes``, ``histogram`` and ``fragility``.
    store
        Where results are kept, unless ``run`` says otherwise.
    chunk
        Rows that are computed at a time; results do not depend on it.
    title
        A line that says what the study is about.
    most_rows
        More rows than this are refused; by default 10¹⁰.

    Raises
    ------
    RimrollError
        When it is planned: for unknown keys and names, values outside their bounds, no values, and
        more rows than allowed.

    Examples
    --------
    >>> import rimroll as rr
    >>> study = rr.Study(
    ...     body=rr.bodies.can_2007(),
    ...     law=rr.Coulomb(0.2),
    ...     start=rr.State(tilt="30 deg", tilt_rate=-0.5, yaw_rate=0.005),
    ...     axes={"law.friction": [0.1, 0.2, 0.3], "body.height": ["5 cm", "7 cm"]},
    ... )
    >>> study.plan().dims
    {'friction': 3, 'height': 2}
    """

    def __init__(
        self,
        *,
        body: Body | Varied,
        kind: str = "ensemble",
        law: Law | Varied | str | None = None,
        start: State | Varied | str | None = None,
        release: Release | Varied | str | None = None,
        ground: Varied | str | None = None,
        fit: Varied | None = None,
        simulation: Varied | None = None,
        axes: Mapping[str, Any] | None = None,
        random: Mapping[str, Varied] | None = None,
        trials: int = 1,
        seed: int = 0,
        combine: str = "product",
        sampling: str = "independent",
        keep: str | Sequence[str] = "all",
        statistics: Varied | None = None,
        store: str | os.PathLike[str] | None = None,
        chunk: int | None = None,
        title: str | None = None,
        most_rows: int | None = None,
    ) -> None:
        given = {
            "title": title,
            "kind": kind,
            "seed": seed,
            "trials": trials,
            "combine": combine,
            "sampling": sampling,
            "keep": keep,
            "chunk": chunk,
            "most_rows": most_rows,
            "store": None if store is None else os.fspath(store),
            "body": body,
            "law": law,
            "start": start,
            "release": release,
            "ground": ground,
            "fit": fit,
            "simulation": simulation,
            "axes": axes,
            "random": random,
            "statistics": statistics,
        }
        content = {name: _as_json(name, one) for name, one in given.items() if one is not None}
        self._keep(content, Path())

    def _keep(self, content: dict[str, Any], folder: Path) -> None:
        self._content = content
        self._folder = folder

    @classmethod
    def from_file(cls, path: str | os.PathLike[str]) -> Study:
        """The study of a TOML file; paths in it are relative to the folder of the file.

        Unless it names a ``store``, that is beside the file, with its name and ``.zarr``.
        Raises ``RimrollError``, which names the file, when it cannot be read or is not valid.
        """
        from rimroll.scenario.tables import read

        file = Path(path)
        try:
            content = read(file)
            if content:
                content.setdefault("store", file.with_suffix(".zarr").name)
            study = cls.from_dict({"study": content, "folder": str(file.parent)})
            _ = study.description
        except RimrollError as error:
            raise error.inside(f"{file}:") from None
        return study

    @classmethod
    def from_dict(cls, content: Mapping[str, Any]) -> Study:
        """The study that :meth:`to_dict` describes."""
        study = cls.__new__(cls)
        study._keep(_as_json("the study", content["study"]), Path(content["folder"]))
        return study

    def to_dict(self) -> dict[str, Any]:
        """The study as JSON knows it: the content of its file, and the folder of its records."""
        content: dict[str, Any] = json.loads(json.dumps(self._content))
        return {"study": content, "folder": str(self._folder.resolve())}

    def __reduce__(self) -> tuple[Any, ...]:
        return Study.from_dict, (self.to_dict(),)

    def __repr__(self) -> str:
        title = self._content.get("title") or self._content.get("kind", "ensemble")
        return f"<Study {title!r}>"

    @cached_property
    def description(self) -> Description:
        """The checked tables; raises ``RimrollError`` if they are not valid."""
        from rimroll.study.description import described

        return described(self._content, self._folder)

    @property
    def title(self) -> str | None:
        """What the study is about."""
        return self.description.title

    @property
    def store(self) -> Path | None:
        """Where results are kept, unless :meth:`run` says otherwise."""
        store = self.description.store
        return None if store is None else self._folder / store

    def plan(self) -> Plan:
        """The rows of the study, its dimensions, and how its columns are computed.

        What is drawn for the first rows is tried, and every value of each axis, with the first
        values of the others and the middle of each distribution. So are the ends of each
        distribution that this many rows are likely to reach. Records are read. Raises
        ``RimrollError`` for what is not possible; a later row may still be refused where several
        quantities are extreme together.
        """
        from rimroll.study.plan import planned

        return planned(self.description, self.to_dict())

    def run(
        self,
        store: str | os.PathLike[str] | None = None,
        *,
        client: Any = None,
        workers: int | None = None,
        threads: int | None = None,
        other_versions: bool = False,
        progress: Progress | None = None,
    ) -> xr.Dataset:
        """Compute what is not done of the study, and return its results, read when they are used.

        Results are kept in a store, chunk by chunk, so a run that was stopped is continued by the
        next. This needs zarr: ``pip install 'rimroll[cluster]'``.

        Parameters
        ----------
        store
            The folder of the results; by default the ``store`` of the study, or the name of its
            file with ``.zarr``.
        client
            A client of a Dask cluster (``distributed.Client``) that computes. Its workers need the
            same build of rimroll, and must see the store at the same path.
        workers
            Number of processes on this machine to compute on. A script that asks for them begins
            with ``if __name__ == "__main__":``, because each process loads it.
        threads
            Threads in this process, by default one for each processor.
        other_versions
            Also continues a store, and computes on workers, of another build of rimroll, or with
            other versions of NumPy or SciPy. Numbers may differ.
        progress
            Called with the number of rows done and the number of all rows.

        Raises
        ------
        RimrollError
            No store, the store of another study, a full disk, chunks that fail on every worker.
        Interrupted
            On Ctrl-C. What is done is kept.
        """
        from rimroll.study.run import run

        callback("progress", progress)
        path = store or self.store
        if path is None:
            raise RimrollError("must be given: the folder of the results", "store")
        report = progress or (lambda done, total: None)
        filled = run(
            self.plan(),
            path,
            client=client,
            workers=workers,
            threads=threads,
            other_versions=other_versions,
            progress=report,
        )
        return filled.open()


def _as_json(name: str, value: Any) -> Any:
    """A value of Python in the form that TOML gives."""
    match value:
        case Body():
            return {key: float(one) for key, one in asdict(one_body(value, name)).items()}
        case Law():
            return _law_as_json(one_law(value))
        case State():
            numbers = vars(single(value))
            return dict(numbers) if value.tilt else {"standing": True, **_nonzero(numbers)}
        case Release():
            return {
                key.removeprefix("release_"): float(one) for key, one in value.parameters().items()
            }
        case Mapping():
            return {str(key): _as_json(str(key), one) for key, one in value.items()}
        case np.ndarray() | np.generic():
            return value.tolist()
        case list() | tuple():
            return [_as_json(name, one) for one in value]
        case os.PathLike():
            return os.fspath(value)
        case str() | int() | float() | bool() | None:
            return value
        case _:
            bound = "a number, a text, a list or a table"
            raise RimrollError(f"must be {bound}, got {value}", name, value, bound)


def _nonzero(numbers: Mapping[str, float]) -> dict[str, float]:
    return {name: one for name, one in numbers.items() if one}


def _law_as_json(law: Law) -> dict[str, Any]:
    found: dict[str, Any] = {"kind": law.name}
    for name, one in replace(law, resistances=()).numbers.items():
        found[name] = list(one) if isinstance(one, tuple) else one
    tables = {kind: name for name, kind in RESISTANCES.items()}
    for resistance in law.resistances:
        numbers = {key: float(one) for key, one in vars(resistance).items()}
        found[tables[type(resistance)]] = numbers
    return found
