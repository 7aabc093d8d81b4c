"""States: where a motion begins."""

from dataclasses import FrozenInstanceError

import numpy as np
import pytest

import rimroll as rr
from given.motions import PAPER_START


def test_fields_of_a_state_may_be_arrays_of_one_shape():
    state = rr.State(tilt=np.full((2, 3), 0.5), yaw_rate=[[1, 2, 3], [4, 5, 6]], spin=1)
    assert state.shape == (2, 3)
    assert state.yaw_rate.dtype == np.float64 and state.spin == 1.0
    assert rr.State(tilt=0.5).shape == () and isinstance(rr.State(tilt=1).tilt, float)
    assert rr.State(tilt=np.array(0.5)).shape == ()


@pytest.mark.parametrize(
    ("fields", "complaint"),
    [
        ({"tilt": 0.0}, "tilt must be inside (0, pi), got 0 rad"),
        ({"tilt": [0.5, 3.2]}, "tilt[1] must be inside (0, pi), got 3.2 rad"),
        ({"tilt": 30}, 'got 30 rad: for degrees write np.radians(30) or "30 deg"'),
        (
            {"tilt": np.array([0.5, 30])},
            "tilt[1] must be inside (0, pi), got 30 rad: for degrees",
        ),
        ({"tilt": 0.5, "yaw": np.nan}, "yaw must be finite, got nan"),
        ({"tilt": 0.5, "spin_rate": [0.0, -np.inf]}, "spin_rate[1] must be finite, got -inf"),
        (
            {"tilt": "steep"},
            'tilt must be an angle such as "30 deg"',
        ),
        ({"tilt": [0.1, 0.2], "yaw": [1, 2, 3]}, "must agree in shape, got tilt (2,), yaw (3,)"),
    ],
)
def test_what_is_no_state_is_refused_with_a_sentence(fields, complaint):
    with pytest.raises(rr.RimrollError) as refusal:
        rr.State(**fields)
    assert complaint in str(refusal.value)


def test_a_state_takes_names_only_and_stays_as_it_is():
    with pytest.raises(TypeError):
        rr.State(0.5)
    with pytest.raises(FrozenInstanceError):
        PAPER_START.tilt = 1.0
