"""The numbers of a study on the disk: a Zarr store that is planned first and filled chunk by chunk.

The store is created empty, with all sizes, coordinates and units; its attributes hold everything
that decides the numbers. xarray opens it without rimroll:
``xarray.open_zarr(path, consolidated=False)``. Consolidated metadata are no part of Zarr's
specification and go stale, so there are none.

What is true or false is kept as 1 or 0, so that what is not computed, -1, is neither.

Columns are on the dimensions of the study, and a chunk of the study is one chunk of each array
(:mod:`rimroll.study.columns`), so writers never share a file. Statistics are merged from the parts
of all chunks when these are done. In the store lies the folder ``done`` with the marks of the
chunks that are complete (:mod:`rimroll.study.chunks`). To Zarr it is an empty group.
"""

from __future__ import annotations

import hashlib
import json
import os
import re
import secrets
import shutil
from collections.abc import Iterable, Iterator, Mapping
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np
from numpy.typing import NDArray

from rimroll.files.output import flush, flush_all
from rimroll.study.chunks import Marks, Parts, StoreError, as_store_errors, digest, zarr
from rimroll.study.columns import Blocks
from rimroll.study.versions import NAMES as VERSIONS
from rimroll.study.versions import difference

if TYPE_CHECKING:
    import xarray as xr

    from rimroll.study.columns import Columns
    from rimroll.study.plan import Plan


class RowsOnDisk:
    """Columns of chunks, each flat in its rows."""

    def __init__(self, path: Path, store: Store) -> None:
        self._path = path
        self._store = store
        self._flushed: set[Path] = set()

    def write(self, chunk: int, columns: Mapping[str, NDArray[Any]]) -> str:
        """Write the columns of a chunk to the disk; return their hash."""
        place = self._store.blocks.place(chunk)
        shape = tuple(part.stop - part.start for part in place)
        arrays = self._store.arrays
        # Contiguous once, for both the disk and the hash.
        written = {
            name: np.ascontiguousarray(columns[name], one.dtype) for name, one in arrays.items()
        }
        with as_store_errors(self._path):
            for name, array in arrays.items():
                array[place or ...] = written[name].reshape(shape)
            # At the same time, since a disk writes many files at once nearly as fast as one.
            with ThreadPoolExecutor(len(arrays)) as pool:
                list(pool.map(self._flush, self.files(chunk)))
        return digest(written)

    def read(self, chunk: int) -> Columns:
        """The columns of a chunk, with fill values where files are missing.

        Raises ``StoreError`` for files that cannot be read.
        """
        place = self._store.blocks.place(chunk) or ...
        try:
            return {name: np.ravel(one[place]) for name, one in self._store.arrays.items()}
        except Exception as error:  # codecs raise errors of many classes
            raise StoreError(f"chunk {chunk} of {self._path} cannot be read: {error}") from None

    def files(self, chunk: int) -> Iterator[Path]:
        """The files of a chunk, one for each column."""
        index = map(str, self._store.blocks.index(chunk))
        key = os.path.join("c", *index)
        return (self._path / name / key for name in self._store.arrays)

    def _flush(self, file: Path) -> None:
        """Wait until a file is on the disk, with the folders that were made for it."""
        flush(file)
        folder = file.parent
        flush(folder)
        while folder != self._path and folder not in self._flushed:
            self._flushed.add(folder)
            folder = folder.parent
            flush(folder)


LONGEST = 40
"""Values with more characters are shortened."""


def changes(old: Any, new: Any, key: str = "") -> Iterator[str]:
    """What differs between two trees of JSON, in which texts may hold further JSON.

    >>> list(changes({"law": {"friction": 0.2}}, {"law": {"friction": 0.3}}))
    ['law.friction was 0.2, is 0.3']
    """
    old, new = _tree(old), _tree(new)
    if isinstance(old, dict) and isinstance(new, dict):
        for name in [*old, *(name for name in new if name not in old)]:
            path = f"{key}.{name}" if key else name
            if name not in new:
                yield f"{path} was {_short(old[name])}, is not given"
            elif name not in old:
                yield f"{path} was not given, is {_short(new[name])}"
            else:
                yield from changes(old[name], new[name], path)
    elif old != new:
        yield f"{key} was {_short(old)}, is {_short(new)}"


def _tree(value: Any) -> Any:
    """A value; for a text that is a table in JSON, the table."""
    if isinstance(value, str) and value.startswith("{"):
        with suppress(ValueError):
            return json.loads(value)
    return value


def _short(value: Any) -> str:
    text = json.dumps(value, ensure_ascii=False)
    return text if len(text) <= LONGEST else f"{text[: LONGEST - 3]}..."


FORMAT = "rimroll_store"
"""The attribute that only stores of rimroll have: their form and how they are divided."""

TRUTH = {"flag_values": [0, 1], "flag_meanings": "false true"}
"""The attributes of an array of what is true (1), false (0) or not computed (-1)."""

VERSION = 1
"""The form of stores that this version of rimroll writes and reads."""

DONE = "done"
"""What a dataset of an unfinished store says of its rows; also the folder of the marks."""

WITHOUT_EFFECT = ("title",)
"""Attributes that may change."""


class Numbers(Protocol):
    """The numbers of the chunks of a store."""

    def write(self, chunk: int, columns: Mapping[str, NDArray[Any]]) -> str:
        """Write the numbers of a chunk to the disk; return their hash."""

    def read(self, chunk: int) -> Columns:
        """The numbers of a chunk; raises ``StoreError`` if they cannot be read."""

    def files(self, chunk: int) -> Iterable[Path]:
        """The files of a chunk."""


class Store:
    """A store that is there.

    Attributes
    ----------
    path
        Its folder.
    attrs
        Everything that decides its numbers, by name.
    blocks
        How the rows of the study are divided into chunks.
    numbers
        The numbers of each chunk: columns of its rows, or its part of the statistics.
    merged
        Whether its variables are merged from the parts of all chunks.
    marks
        Which chunks are done.
    """

    def __init__(self, path: str | os.PathLike[str]) -> None:
        """Open a store; ``StoreError`` if there is none, or one of another program."""
        self.path = Path(path)
        with as_store_errors(self.path):
            self.attrs = _attributes(self.path)
        form = self.attrs.pop(FORMAT)
        if form["version"] != VERSION:
            raise StoreError(
                f"{path} is a store in form {form['version']}, this rimroll knows form {VERSION}:"
                " use the rimroll that made it"
            )
        self._labels = str(self.attrs.pop("coordinates", "")).split()
        self.blocks = Blocks(tuple(form["shape"]), tuple(form["block"]))
        self.marks = Marks(self.path / DONE)
        self.merged = bool(form["parts"])
        self.numbers: Numbers = (
            Parts(self.path / DONE) if self.merged else RowsOnDisk(self.path, self)
        )

    @classmethod
    def create(cls, path: str | os.PathLike[str], plan: Plan) -> Store:
        """Make an empty store for a plan, or open the one that is there.

        Several processes may do so at once. Raises ``StoreError`` if the folder holds something
        else, or cannot be made.
        """
        place = Path(path)
        if _is_store(place):
            return cls._swept(place)
        with as_store_errors(place):
            place.parent.mkdir(parents=True, exist_ok=True)
            part = place.with_name(f".{place.name}.{secrets.token_hex(4)}.partial")
            try:
                _write_empty(part, plan)
                flush_all(part)
                os.replace(part, place)
                flush(place.parent)
            except Exception:
                if not _is_store(place):  # made by another process in the meantime
                    raise
            finally:
                shutil.rmtree(part, ignore_errors=True)
        return cls._swept(place)

    @classmethod
    def _swept(cls, place: Path) -> Store:
        """Open a store, and remove what processes left that were killed while they made it.

        One that is making it now finds it made.
        """
        name = re.compile(rf"\.{re.escape(place.name)}\.[0-9a-f]{{8}}\.partial")
        with suppress(OSError):
            for part in place.parent.iterdir():
                if name.fullmatch(part.name):
                    shutil.rmtree(part, ignore_errors=True)
        return cls(place)

    @property
    def finished(self) -> bool:
        """Whether all chunks are done."""
        return not self.pending(range(self.blocks.number))

    @cached_property
    def arrays(self) -> dict[str, Any]:
        """The Zarr arrays of the variables."""
        group = zarr().open_group(self.path, mode="r+", use_consolidated=False)
        return {
            name: array.with_config({"write_empty_chunks": True})
            for name, array in sorted(group.arrays())
            if name not in self._labels
        }

    @cached_property
    def coordinates(self) -> dict[str, NDArray[Any]]:
        """What labels the dimensions, by name."""
        group = zarr().open_group(self.path, mode="r", use_consolidated=False)
        try:
            return {name: group[name][...] for name in sorted(self._labels)}
        except Exception as error:  # codecs raise errors of many classes
            raise StoreError(f"coordinates of {self.path} cannot be read: {error}") from None

    @property
    def identity(self) -> str:
        """A hash of what the store is for and how it is divided, as 16 hexadecimal digits."""
        whole = json.dumps([self.attrs, self.blocks.shape, self.blocks.block], sort_keys=True)
        return hashlib.sha256(whole.encode()).hexdigest()[:16]

    @property
    def unmerged(self) -> bool:
        """Whether it keeps statistics that are not merged from the parts of its chunks."""
        return self.merged and self.marks.merged() is None

    def expect(self, plan: Plan, *, other_versions: bool = False) -> None:
        """Raise ``StoreError``, which says what differs, unless a run may continue the store.

        It must be of this plan, and made by the same build of rimroll with the same packages, or by
        others where these are accepted.
        """
        self.expect_study(plan)
        found = difference(self.attrs, plan.attrs)
        if found and not other_versions:
            raise StoreError(
                f"{self.path} was made with {found[0]}, here is {found[1]}: numbers may differ; use"
                " that one, give another --store, or accept it with --other-versions"
            )

    def expect_study(self, plan: Plan) -> None:
        """Raise ``StoreError``, which says what differs, unless the store is of this study."""
        mine, wanted = (
            {name: one for name, one in attrs.items() if name not in (*WITHOUT_EFFECT, *VERSIONS)}
            for attrs in (self.attrs, json.loads(json.dumps(dict(plan.attrs))))
        )
        found = list(changes(mine, wanted))
        if found:
            more = f", and {len(found) - 5} more" if len(found) > 5 else ""
            raise StoreError(
                f"{self.path} is the store of another study: {'; '.join(found[:5])}{more};"
                " give another --store, or the study that it was made with"
            )

    def pending(self, chunks: Iterable[int]) -> list[int]:
        """The chunks among these that are not done."""
        with as_store_errors(self.path):
            done = self.marks.done()
        return [chunk for chunk in chunks if chunk not in done]

    def sweep(self, chunks: Iterable[int]) -> int:
        """Remove what killed writers of these chunks left; return how many files."""
        begun: dict[Path, set[str]] = {}
        for chunk in chunks:
            for file in (*self.numbers.files(chunk), self.marks.file(chunk)):
                begun.setdefault(file.parent, set()).add(file.stem)
        return sum(_sweep(folder, names) for folder, names in begun.items())

    def merge(self, plan: Plan) -> None:
        """Write the statistics of all chunks, which must be done, unless they are written.

        Raises ``StoreError`` for a part that cannot be read.
        """
        if plan.statistics is None or self.marks.merged() is not None:
            return
        merged = plan.statistics.merged(map(self.numbers.read, range(self.blocks.number)))
        with as_store_errors(self.path):
            for name, array in self.arrays.items():
                array[...] = merged[name]
                flush_all(self.path / name)
            self.marks.add_merged(digest({name: merged[name] for name in self.arrays}))

    def open(self) -> xr.Dataset:
        """The store as a dataset whose numbers are read when they are used.

        While columns are not finished, the coordinate ``done`` says which rows are, and what is
        true or false is 1 or 0.
        """
        import xarray as xr

        dataset: xr.Dataset = xr.open_zarr(self.path, consolidated=False)
        if self.merged:
            return dataset
        if self.finished:
            truths = [name for name, one in dataset.data_vars.items() if is_truth(one)]
            for name in truths:
                attrs = {key: one for key, one in dataset[name].attrs.items() if key not in TRUTH}
                dataset[name] = dataset[name].astype(bool)
                dataset[name].attrs = attrs
            return dataset
        done = np.zeros(self.blocks.shape, bool)
        for chunk in self.marks.done():
            done[self.blocks.place(chunk)] = True
        dims = next(iter(self.arrays.values())).metadata.dimension_names or ()
        return dataset.assign_coords({DONE: (dims, done)})


def is_truth(array: xr.DataArray) -> bool:
    """Whether an array of a store says what is true and what is false."""
    return str(array.attrs.get("flag_meanings")) == TRUTH["flag_meanings"]


def _is_store(place: Path) -> bool:
    """Whether something is there; ``StoreError`` unless that is a store of rimroll."""
    with as_store_errors(place):
        if not place.exists() or (place.is_dir() and not any(place.iterdir())):
            return False
        _attributes(place)
    return True


def _attributes(place: Path) -> dict[str, Any]:
    if not place.exists():
        raise StoreError(f"there is no store {place}: rimroll study run makes it")
    with suppress(FileNotFoundError, NotADirectoryError, ValueError, KeyError, TypeError):
        attrs = json.loads((place / "zarr.json").read_bytes())["attributes"]
        if FORMAT in attrs:
            return dict(attrs)
    raise StoreError(f"{place} is no store of a study: give another --store")


def _write_empty(path: Path, plan: Plan) -> None:
    form = {
        "version": VERSION,
        "shape": list(plan.blocks.shape),
        "block": list(plan.blocks.block),
        "parts": plan.statistics is not None,
    }
    coords = plan.coords if plan.statistics is None else plan.statistics.coords
    group = zarr().open_group(
        path,
        mode="w",
        zarr_format=3,
        # xarray reads from "coordinates" which arrays are labels.
        attributes={FORMAT: form, "coordinates": " ".join(coords), **plan.attrs},
    )
    group.create_group(DONE)
    for name, coordinate in coords.items():
        values = np.asarray(coordinate.values)
        words = values.dtype.kind == "U"
        array = group.create_array(
            name,
            shape=values.shape,
            chunks=tuple(max(1, size) for size in values.shape),
            dtype=str if words else values.dtype,
            dimension_names=coordinate.dims,
            attributes=coordinate.attrs,
        )
        array[...] = values.astype(object) if words else values
    for name, variable in plan.variables.items():
        truth = variable.dtype == "bool"
        dtype = np.dtype("int8" if truth else variable.dtype)
        group.create_array(
            name,
            shape=tuple(plan.sizes[dim] for dim in variable.dims),
            chunks="auto" if plan.statistics else plan.blocks.block,
            dtype=dtype,
            fill_value={"f": np.nan, "i": -1}[dtype.kind],
            dimension_names=variable.dims,
            attributes={**variable.attrs, **TRUTH} if truth else variable.attrs,
            # Flags and equal numbers shrink to little; doubles are as fast as uncompressed.
            compressors=zarr().codecs.BloscCodec(cname="lz4", clevel=5, shuffle="shuffle"),
        )


def _sweep(folder: Path, names: set[str]) -> int:
    """Remove files ``NAME.*.partial`` with one of these names."""
    if not folder.is_dir():
        return 0
    litter = [file for file in folder.glob("*.partial") if file.name.split(".")[0] in names]
    for file in litter:
        file.unlink(missing_ok=True)
    return len(litter)
