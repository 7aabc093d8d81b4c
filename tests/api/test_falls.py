"""Falls in plain columns: they convert to datasets and back, and Ctrl-C keeps complete falls."""

from __future__ import annotations

import copy
import pickle

import numpy as np
import pytest

import rimroll as rr
from rimroll.many.falls import Falls

CAN = rr.bodies.can_2007()
RATES = np.linspace(-1.0, 1.0, 3)
DATASETS = {
    "rows": lambda: rr.topple(CAN, rr.Coulomb(0.2), 5, "paper", seed=7),
    "none": lambda: rr.topple(CAN, rr.NoSlip(), 5, seed=7).isel(trial=slice(0)),
    "a stepped map": lambda: rr.turn_map(
        CAN, rr.State(tilt=0.35, tilt_rate=-5.0), rr.Coulomb(0.2), RATES, RATES[:2]
    ),
    "an exact map": lambda: rr.turn_map(CAN, rr.State(tilt=0.3), rr.NoSlip(), RATES, RATES),
}


@pytest.fixture(params=DATASETS)
def dataset(request):
    return DATASETS[request.param]()


def test_a_dataset_of_falls_comes_back_from_plain_columns_as_it_was(dataset):
    assert Falls.of(dataset).to_xarray().identical(dataset)


def test_what_else_was_put_into_a_dataset_is_not_taken_for_a_column_of_falls():
    dataset = DATASETS["rows"]()
    assert "more" not in Falls.of(dataset.assign(more=("else", [1.0, 2.0])))
    with pytest.raises(rr.RimrollError, match="it has no outcome"):
        Falls.of(dataset.drop_vars("outcome"))


@pytest.mark.parametrize("copied", [lambda one: pickle.loads(pickle.dumps(one)), copy.copy])
def test_interrupted_can_be_sent_to_another_process(dataset, copied):
    sent = rr.Interrupted(dataset)
    arrived = copied(sent)
    assert arrived.done.identical(dataset)
    assert str(arrived) == str(sent) == f"interrupted after {dataset.outcome.size} falls"
