"""What datasets of motions and falls record: what these were computed from, and how they ended."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from rimroll import _core
from rimroll.errors import RimrollError, expect
from rimroll.many.falls import Falls
from rimroll.many.grid import is_array
from rimroll.units import number

if TYPE_CHECKING:
    import xarray as xr

    Record = Falls | xr.Dataset


def parameters(
    law_name: str, options: Mapping[str, object], /, **numbers: Mapping[str, object]
) -> dict[str, object]:
    """The attributes of a dataset: everything that it was computed from.

    ``numbers`` are those of the law, the body and the start, by the word that their names begin
    with. Those that are arrays, and options that are None, are left out.
    """
    return {
        "law": law_name,
        **{
            f"{what}_{name}": value
            for what, values in numbers.items()
            for name, value in values.items()
            if not is_array(value)
        },
        **{name: value for name, value in options.items() if value is not None},
        "rimroll_version": _core.__version__,
    }


def is_recorded(record: Record, name: str) -> bool:
    """Whether the record has a value of that name: one for all falls, or one for each."""
    return name in record.attrs or name in record


def recorded(record: Record, name: str) -> Any:
    """The number of that name; an array or a data array where it differs from fall to fall.

    Raises ``RimrollError`` for a record without it.
    """
    if name in record.attrs:
        return number(name, record.attrs[name])
    if name not in record:
        raise not_recorded(name, name)
    if isinstance(record, Falls) or record[name].dims == ("trial",):
        return np.asarray(record[name])
    return record[name]


def not_recorded(what: str, name: str) -> RimrollError:
    """The error for a dataset of something else, in which a name is missing."""
    return RimrollError(f"this dataset records no {what}: there is no {name} in it")


def expect_dataset(value: object) -> None:
    """Raise ``RimrollError`` unless the value is an ``xarray.Dataset``."""
    import xarray as xr

    expect("dataset", value, xr.Dataset)


STATUSES = {
    "finished": "was followed for the whole duration",
    "toppled": "reached the topple tilt",
    "lifted_off": "would have left the table, under a law without flight",
    "face_down": "came down flat",
    "at_rest": "came to rest",
    "painleve": "met Painlevé's paradox",
    "failed": "could not be computed further",
}
"""How a motion ends (``Motion.status``), and what that means."""

OUTCOMES = {
    "toppled": "passed a tilt minimum, then reached the topple tilt; or, under a law without"
    " flight, lifted off beyond the balance tilt",
    "rocked": "passed a tilt minimum, then a tilt maximum",
    "fell_back": "fell over without a tilt minimum after the release",
    "hovered": "did none of these in the time given",
    "lifted_off": STATUSES["lifted_off"],
    "face_down": STATUSES["face_down"],
    "at_rest": STATUSES["at_rest"],
    "painleve": STATUSES["painleve"],
    "failed": "could not be computed",
}
"""The outcomes of a fall (``outcome`` in :func:`rimroll.ensemble`), and what they mean."""

FELL = ("toppled", "rocked")
"""The outcomes that have a direction: that of the fall, or that of the largest tilt."""


def ending_in_words(name: str) -> str:
    """A status, an outcome or the kind of an event as people read it: ``fell back``."""
    return name.replace("_", " ").replace("painleve", "Painlevé")
