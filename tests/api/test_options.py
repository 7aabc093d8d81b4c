"""Options of motions: as keywords, as one object, and in signatures."""

import inspect
from functools import partial

import numpy as np
import pytest

import rimroll as rr

CAN = rr.bodies.can_2007()
START = rr.State(tilt=0.3, yaw_rate=0.02)
COLUMN = rr.bodies.cylinder(1.0, 0.1, 0.6)
PULSE = rr.ground.sine(4.0, 0.6)

FUNCTIONS = {
    rr.simulate: lambda **options: rr.simulate(CAN, START, rr.NoSlip(), **options).to_xarray(),
    rr.ensemble: lambda **options: rr.ensemble(CAN, START, rr.Coulomb(0.2), **options),
    rr.topple: lambda **options: rr.topple(CAN, rr.Coulomb(0.2), 3, seed=1, **options),
    rr.turn_map: lambda **options: rr.turn_map(
        CAN, START, rr.Coulomb(0.2), [0.01, 0.02], [0.0], **options
    ),
    rr.shake_many: lambda **options: rr.shake_many(
        COLUMN, rr.State.standing(), rr.NoSlip(), PULSE, **options
    ),
}
"""Functions whose results say what they were computed with."""

OTHERS = {"gravity": 9.7, "rtol": 1e-7, "topple_tilt": 1.2, "max_steps": 40_000}


def defaults(function):
    """The options that a signature shows, with their defaults."""
    known = inspect.signature(rr.Options).parameters
    shown = inspect.signature(function).parameters
    return {name: shown[name].default for name in known if name in shown}


@pytest.mark.parametrize("function", FUNCTIONS, ids=lambda function: function.__name__)
def test_the_defaults_in_a_signature_are_those_that_are_used(function):
    used = FUNCTIONS[function]().attrs
    for name, default in defaults(function).items():
        if default is not None:
            assert used[name] == default


@pytest.mark.parametrize("function", FUNCTIONS, ids=lambda function: function.__name__)
def test_options_in_one_object_are_those_of_the_keywords(function):
    call = FUNCTIONS[function]
    whole = {name: value for name, value in defaults(function).items() if value is not None}
    if function is rr.shake_many:  # else it follows bodies for a time of its own
        call = partial(call, duration=2.0)
    by_keywords = call(**OTHERS)
    assert {name: by_keywords.attrs[name] for name in OTHERS} == OTHERS
    assert by_keywords.identical(call(options=rr.Options(**{**whole, **OTHERS})))
    mixed = call(options=rr.Options(**{**whole, **OTHERS, "rtol": 1e-4}), rtol=OTHERS["rtol"])
    assert by_keywords.identical(mixed)


@pytest.mark.parametrize(
    "call",
    [
        *FUNCTIONS.values(),
        lambda **options: rr.random_maxima(
            COLUMN, rr.State.standing(), rr.NoSlip(), PULSE, 2, tilt_noise=1e-3, **options
        ),
        lambda **options: rr.rocking_spectrum(COLUMN, PULSE, [1.0], **options),
        lambda **options: rr.overturning_scale(
            COLUMN, rr.State.standing(), rr.NoSlip(), PULSE, [1.0], **options
        ),
        lambda **options: rr.overturning_spectrum(COLUMN, rr.ground.sine, [1.0], **options),
    ],
)
def test_what_is_no_option_is_refused(call):
    with pytest.raises(TypeError, match="unknown option 'gravty': did you mean 'gravity'"):
        call(gravty=9.8)
    with pytest.raises(rr.RimrollError, match=r"^options must be a rimroll.Options or None, got 1"):
        call(options=1)
    with pytest.raises(rr.RimrollError, match=r"^rtol must be between 1e-14 and 1e-3, got 1"):
        call(rtol=1.0)


@pytest.mark.parametrize("ground", [None, PULSE])
def test_a_motion_is_followed_again_from_what_it_keeps(ground):
    motion = rr.simulate(CAN, START, rr.Coulomb(0.2), "300 ms", ground=ground, **OTHERS)
    again = rr.simulate(
        motion.body, motion.start, motion.law, ground=motion.ground, options=motion.options
    )
    assert again.parameters() == motion.parameters()
    np.testing.assert_array_equal(again.tilt, motion.tilt)
    assert again.options.flat == ("stop" if ground is None else "housner")


def test_options_carry_units():
    options = rr.Options("500 ms", gravity="1.62 m/s^2", topple_tilt="80 deg", flat="smooth:3")
    assert options == rr.Options(
        0.5, gravity=1.62, topple_tilt=np.radians(80.0), flat=("smooth", 3)
    )
    with pytest.raises(rr.RimrollError, match=r"^gravity must be an acceleration"):
        rr.Options(gravity="9.8 m")


@pytest.mark.parametrize("option", [{"flat": "housner"}, {"flat_gap": "0.1 mm"}])
def test_falls_end_where_the_base_comes_down_flat(option):
    for options in ({"options": rr.Options(**option)}, option):
        with pytest.raises(rr.RimrollError, match=r"^flat and flat_gap are for single motions"):
            rr.ensemble(CAN, START, rr.NoSlip(), **options)
