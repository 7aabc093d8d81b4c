"""The variables of a plan as a dataset of xarray."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from rimroll.study.plan import Plan

if TYPE_CHECKING:
    import xarray as xr


def dataset_of(plan: Plan, values: Mapping[str, NDArray[Any]]) -> xr.Dataset:
    """Columns of all rows, each (rows,), or finished statistics, as a labelled dataset."""
    import xarray as xr

    sizes = plan.sizes
    coords = plan.coords if plan.statistics is None else plan.statistics.coords
    return xr.Dataset(
        {
            name: (
                one.dims,
                np.reshape(values[name], [sizes[dim] for dim in one.dims]),
                one.attrs,
            )
            for name, one in plan.variables.items()
        },
        coords={name: (one.dims, one.values, one.attrs) for name, one in coords.items()},
        attrs=dict(plan.attrs),
    )
