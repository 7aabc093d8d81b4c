"""Bodies, starts and laws in rows: each row equals the result for its body, start and law alone."""

import pickle
import subprocess
import sys
from dataclasses import asdict, fields, replace

import numpy as np
import pytest
import xarray as xr

import rimroll as rr
from rimroll.bodies.body import body_of
from rimroll.laws import law_of
from rimroll.units import registry

DEGREE = registry().deg
CAN, COIN = rr.bodies.can_2007(), rr.bodies.coin()
FIELDS = [field.name for field in fields(rr.Body)]


def random_bodies(count, seed):
    """Cans of many shapes, every fifth a disk."""
    rng = np.random.default_rng(seed)
    mass, radius = rng.uniform(0.01, 2.0, count), rng.uniform(0.01, 0.2, count)
    height = radius * rng.uniform(0.2, 2.0, count)
    height[::5] = 0.0
    axial = mass * radius**2 * rng.uniform(0.3, 1.0, count)
    return rr.Body(mass, radius, height, axial * rng.uniform(0.5, 2.0, count), axial)


def random_starts(count, seed):
    rng = np.random.default_rng(seed)
    return rr.State(
        tilt=rng.uniform(0.1, 0.6, count),
        tilt_rate=-rng.uniform(0.0, 2.0, count),
        yaw=rng.uniform(-1.0, 1.0, count),
        yaw_rate=10.0 ** rng.uniform(-4.0, 0.0, count),
        spin_rate=rng.normal(0.0, 1.0, count),
    )


def one_of(many, row):
    """One row of a body, start or law of arrays."""
    arrays = {
        field.name: value[row]
        for field in fields(many)
        if isinstance(value := getattr(many, field.name), np.ndarray)
    }
    return replace(many, **arrays)


def results(falls):
    """The results of falls, without their inputs."""
    given = ("start_", "body_", "law_", "friction_scale")
    results = falls[[name for name in falls.data_vars if not name.startswith(given)]]
    return results.drop_attrs(deep=False)


# ensemble


@pytest.mark.parametrize(
    "law",
    [
        rr.NoSlip(),
        rr.Frictionless(),
        rr.Coulomb(np.linspace(0.01, 0.5, 60)),
        rr.Coulomb(np.linspace(0.01, 0.5, 60), np.linspace(0.6, 0.5, 60), 0.3),
        rr.Stribeck(0.2, creep_speed=np.geomspace(1e-3, 1e-2, 60)),
        rr.Viscous(np.linspace(0.0, 2.0, 60)) + rr.RollingResistance(np.linspace(0.0, 1e-4, 60)),
    ],
    ids=lambda law: type(law).__name__,
)
def test_a_row_is_the_fall_of_its_body_under_its_law_to_the_last_bit(law):
    bodies, starts = random_bodies(60, 1), random_starts(60, 2)
    options = {"rtol": 1e-6, "duration": 3.0, "max_steps": 5000}
    together = results(rr.ensemble(bodies, starts, law, **options))
    for row in range(60):
        own_law = one_of(law, row)
        own_law = replace(own_law, resistances=tuple(one_of(r, row) for r in law.resistances))
        alone = rr.ensemble(one_of(bodies, row), one_of(starts, row), own_law, **options)
        xr.testing.assert_identical(
            together.isel(trial=[row]).drop_vars("trial"), results(alone).drop_vars("trial")
        )


def test_order_threads_and_company_change_no_bit():
    n = 3000
    bodies, starts = random_bodies(n, 3), random_starts(n, 4)
    friction = np.random.default_rng(5).uniform(0.01, 0.6, n)
    one = results(rr.ensemble(bodies, starts, rr.Coulomb(friction), threads=1))
    many = results(rr.ensemble(bodies, starts, rr.Coulomb(friction), threads=3))
    xr.testing.assert_identical(one, many)
    order = np.random.default_rng(6).permutation(n)[: n // 2]
    some = rr.ensemble(one_of(bodies, order), one_of(starts, order), rr.Coulomb(friction[order]))
    xr.testing.assert_identical(
        one.isel(trial=order).drop_vars("trial"), results(some).drop_vars("trial")
    )


def test_a_sweep_of_friction_is_that_of_its_scale():
    start, friction = rr.State(tilt=0.5, yaw_rate=0.01), np.linspace(0.05, 0.4, 30)
    swept = rr.ensemble(CAN, start, rr.Coulomb(friction))
    scaled = rr.ensemble(CAN, start, rr.Coulomb(1.0), friction_scale=friction)
    xr.testing.assert_identical(results(swept), results(scaled))


def test_what_varies_is_a_variable_and_what_does_not_an_attribute():
    bodies = replace(CAN, height=np.array([0.05, 0.06, 0.07]))
    law = rr.Coulomb([0.1, 0.2, 0.3], 0.4) + rr.RollingResistance(1e-6)
    falls = rr.ensemble(bodies, rr.State(tilt=0.3, yaw_rate=0.1), law)
    assert falls.sizes == {"trial": 3}
    assert falls["body_height"].values.tolist() == [0.05, 0.06, 0.07]
    assert falls["body_height"].attrs["units"] == "m"
    assert falls["law_friction"].values.tolist() == [0.1, 0.2, 0.3]
    assert "body_height" not in falls.attrs and "law_friction" not in falls.attrs
    assert falls.attrs["body_mass"] == CAN.mass and falls.attrs["law_static"] == 0.4
    assert "body_mass" not in falls and "law_static" not in falls
    assert body_of(falls) == bodies
    assert law_of(falls) == law


def test_a_fall_over_the_balance_point_of_its_own_body_has_toppled():
    bodies = rr.Body.stack([CAN, rr.bodies.beer_bottle(0.0)])
    start = rr.State(tilt=np.full(2, 0.15), tilt_rate=-1.5, yaw_rate=0.3)
    together = rr.ensemble(bodies, start, rr.NoSlip())
    alone = [rr.ensemble(one_of(bodies, i), one_of(start, i), rr.NoSlip()) for i in range(2)]
    assert together["outcome"].values.tolist() == [fall["outcome"].item() for fall in alone]


# names of dimensions


def test_named_dimensions_come_back_as_those_of_the_falls():
    friction = rr.axis("friction", [0.1, 0.2, 0.3])
    yaw_rate = rr.axis("yaw_rate", [0.5, 1.0], units="deg/s")
    start = rr.State(tilt=0.4, yaw_rate=yaw_rate)
    falls = rr.ensemble(CAN, start, rr.Coulomb(friction))
    assert dict(falls.sizes) == {"yaw_rate": 2, "friction": 3}
    assert falls["turn"].dims == ("yaw_rate", "friction")
    assert falls["yaw_rate"].values.tolist() == [0.5, 1.0]
    assert falls["yaw_rate"].attrs["units"] == "deg/s"
    point = falls["turn"].sel(friction=0.2, yaw_rate=1.0).item()
    alone = rr.ensemble(CAN, rr.State(tilt=0.4, yaw_rate="1 deg/s"), rr.Coulomb(0.2))
    assert point == alone["turn"].item()
    assert (falls["law_friction"] == falls["friction"]).all()


def test_bodies_by_name_are_a_dimension():
    bodies = rr.Body.stack({"can": CAN, "coin": COIN})
    tilt = rr.axis("tilt", [0.2, 0.3, 0.4])
    falls = rr.ensemble(bodies, rr.State(tilt=tilt, yaw_rate=0.01), rr.NoSlip())
    assert dict(falls.sizes) == {"body": 2, "tilt": 3}
    own = rr.ensemble(COIN, rr.State(tilt=tilt, yaw_rate=0.01), rr.NoSlip())
    assert falls["turn"].sel(body="coin").values.tolist() == own["turn"].values.tolist()
    limits = rr.turn_limit(bodies, rr.NoSlip())
    assert limits.sel(body="can").item() == rr.turn_limit(CAN, rr.NoSlip())
    turns = rr.exact_turn(bodies, rr.State(tilt=tilt, yaw_rate=0.01), rr.NoSlip())
    assert turns.turn.dims == ("body", "tilt") and turns.outcome.dims == ("body", "tilt")
    exact = rr.exact_turn(COIN, rr.State(tilt=0.3, yaw_rate=0.01), rr.NoSlip())
    assert turns.turn.sel(body="coin", tilt=0.3).item() == exact.turn


def test_labels_that_are_no_index_are_kept_where_they_agree():
    surface = xr.DataArray(
        [0.2, 0.4],
        dims="surface",
        coords={"surface": ["wood", "steel"], "wet": ("surface", [1, 0])},
    )
    falls = rr.ensemble(CAN, rr.State(tilt=0.3, yaw_rate=0.1), rr.Coulomb(surface))
    assert falls["wet"].values.tolist() == [1, 0]
    falls.sel(surface="wood")


def test_falls_of_an_ensemble_can_be_let_go_again():
    starts = random_starts(5, 7)
    first = rr.ensemble(CAN, starts, rr.NoSlip())
    again = rr.State(**{field.name: first[f"start_{field.name}"] for field in fields(rr.State)})
    xr.testing.assert_identical(rr.ensemble(CAN, again, rr.NoSlip()), first)


def test_no_xarray_is_imported_unless_labels_are_given():
    program = (
        "import sys, rimroll as rr; b = rr.Body.stack([rr.bodies.coin()] * 2);"
        " rr.turn_limit(b, rr.Coulomb([0.1, 0.2]));"
        " rr.exact_turn(b, rr.State(tilt=0.3, yaw_rate=0.1), rr.NoSlip());"
        " print('xarray' in sys.modules)"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert done.stdout.strip() == "False", done.stderr


# exact turns


@pytest.mark.parametrize("law", [rr.NoSlip(), rr.Frictionless()], ids=lambda law: law.name)
def test_exact_turns_of_many_bodies_are_those_of_each_to_the_last_bit(law):
    bodies, starts = random_bodies(40, 8), random_starts(40, 9)
    order = np.random.default_rng(10).permutation(np.arange(40) % 25)
    bodies = one_of(bodies, order)
    turns = rr.exact_turn(bodies, starts, law, jacobian=True)
    for row in range(40):
        alone = rr.exact_turn(one_of(bodies, row), one_of(starts, row), law, jacobian=True)
        for name, value in vars(alone).items():
            if name == "jacobian":
                found = {key: slopes[row] for key, slopes in turns.jacobian.items()}
                np.testing.assert_equal(found, dict(value))
            else:
                np.testing.assert_equal(getattr(turns, name)[row], value)


def test_bodies_and_starts_broadcast_as_in_numpy():
    bodies = rr.Body.stack([CAN, COIN])
    start = rr.State(tilt=np.array([[0.2], [0.3], [0.4]]), yaw_rate=0.01)
    turns = rr.exact_turn(bodies, start, rr.NoSlip())
    assert turns.turn.shape == (3, 2)
    assert (
        turns.turn[2, 1] == rr.exact_turn(COIN, rr.State(tilt=0.4, yaw_rate=0.01), rr.NoSlip()).turn
    )


# closed forms


@pytest.mark.parametrize(
    "closed_form",
    [
        rr.needed_friction,
        rr.painleve_friction,
        rr.balance_tilt,
        rr.lift_off_rate,
        rr.slip_rate,
        lambda body: rr.turn_limit(body, rr.NoSlip()),
        lambda body: rr.turn_limit(body, rr.Frictionless()),
        lambda body: rr.tall_turn_limit(body, rr.NoSlip()),
        lambda body: rr.turn_limit_with_spin(body, 0.1, 2.0),
        lambda body: rr.error_law_coefficient(body, rr.NoSlip(), 1.0),
        lambda body: rr.steady_wobble_rate(body, 0.1),
    ],
)
def test_closed_forms_of_many_bodies_are_those_of_each(closed_form):
    bodies = random_bodies(12, 11)
    expected = [closed_form(one_of(bodies, row)) for row in range(12)]
    assert closed_form(bodies).tolist() == expected
    in_two = replace(bodies, **{name: getattr(bodies, name).reshape(3, 4) for name in FIELDS})
    assert closed_form(in_two).shape == (3, 4)


def test_limits_of_turn_are_those_of_each_friction():
    friction = np.linspace(0.0, 0.5, 6)
    limits = rr.turn_limit(CAN, rr.Coulomb(friction))
    assert limits.tolist() == [rr.turn_limit(CAN, rr.Coulomb(one)) for one in friction]
    both = rr.turn_limit(rr.Body.stack([CAN, COIN]), rr.Coulomb(friction[:, None]))
    assert both.shape == (6, 2)
    assert both[:, 0].tolist() == limits.tolist()


def test_closed_forms_of_numbers_broadcast():
    assert rr.disk_turn_limit([0.5, 1.0]).tolist() == [
        rr.disk_turn_limit(0.5),
        rr.disk_turn_limit(1.0),
    ]
    heights = rr.axis("height", [0.1, 0.2])
    assert rr.point_mass_turn_limit(0.1, heights, rr.NoSlip()).dims == ("height",)
    spins = rr.turn_limit_with_spin(CAN, np.array([0.0, 0.1]), np.array([[1.0], [2.0]]))
    assert spins.shape == (2, 2)


# bodies and laws of arrays


def test_a_body_of_arrays_is_a_value_like_any_body():
    bodies = rr.Body.stack([CAN, COIN])
    assert bodies.shape == (2,) and CAN.shape == ()
    assert bodies == rr.Body.stack([CAN, COIN]) != rr.Body.stack([COIN, CAN])
    assert hash(bodies) == hash(rr.Body.stack([CAN, COIN]))
    assert bodies != CAN and CAN != "can"
    assert pickle.loads(pickle.dumps(bodies)) == bodies
    with pytest.raises(ValueError, match="read-only"):
        bodies.mass[0] = 1.0
    assert one_of(bodies, 1) == COIN
    named = rr.Body.stack({"can": CAN, "coin": COIN})
    assert pickle.loads(pickle.dumps(named)) == named != bodies
    assert hash(named) == hash(rr.Body.stack({"can": CAN, "coin": COIN}))
    assert asdict(CAN) == {name: getattr(CAN, name) for name in FIELDS}


def test_a_law_of_arrays_is_a_value_like_any_law():
    law = rr.Coulomb([0.1, 0.2]) + rr.RollingResistance(dry=[1e-3, 2e-3])
    assert law.shape == (2,) and rr.Coulomb(0.2).shape == ()
    same = rr.Coulomb(np.array([0.1, 0.2])) + rr.RollingResistance(dry=[1e-3, 2e-3])
    assert law == same and hash(law) == hash(same)
    assert law != rr.Coulomb([0.1, 0.2]) and law != rr.Coulomb(0.1)
    assert pickle.loads(pickle.dumps(law)) == law
    assert repr(rr.Coulomb([0.1, 0.2])) == "Coulomb(friction=array([0.1, 0.2]))"


def test_units_are_converted_in_arrays_of_bodies_too():
    body = replace(CAN, radius=["51 mm", "6 cm"])
    assert body.radius.tolist() == [0.051, 0.06]


# refusals


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: replace(CAN, height=[0.1, 0.2, -0.3]), r"^height\[2\] must be >= 0, got -0.3 m"),
        (
            lambda: replace(CAN, mass=[0.1, 0.2], height=[[0.1], [-0.2]]),
            r"^height\[1, 0\] must be >= 0",
        ),
        (
            lambda: replace(CAN, mass=[1.0, 2.0], height=-1.0),
            r"^at \[0\]: height must be >= 0",
        ),
        (
            lambda: replace(CAN, mass=[1.0, 2.0], height=[1.0, 2.0, 3.0]),
            r"arrays must broadcast to one shape, got mass \(2,\), height \(3,\)",
        ),
        (lambda: replace(CAN, mass=[1.0, np.nan]), r"^mass\[1\] must be"),
        (lambda: rr.Coulomb([0.1, -0.1]), r"^friction\[1\] must be between 0 and 1e6, got -0.1"),
        (
            lambda: rr.Coulomb([0.1, 0.3], 0.2),
            r"^at \[1\]: static must be between friction = 0.3",
        ),
        (
            lambda: rr.Coulomb([0.1, 0.3], [0.2, 0.2]),
            r"^static\[1\] must be between friction = 0.3",
        ),
        (lambda: rr.RollingResistance([0.1, -0.1]), "rolling_resistance dry must be"),
        (lambda: rr.Body.stack([]), "bodies must be one or more"),
        (lambda: rr.Body.stack([CAN, "coin"]), r"^bodies\[1\] must be a rimroll.Body, got 'coin'"),
        (
            lambda: rr.Body.stack([CAN, rr.Body.stack([CAN, COIN])]),
            r"^bodies\[1\] must be a single body, got bodies of shape \(2,\)",
        ),
        (
            lambda: replace(CAN, mass=[1.0, 2.0], height=rr.axis("height", [0.1, 0.2])),
            r"^mass has shape \(2,\) and no named dimensions, but height has",
        ),
        (
            lambda: rr.State(tilt=rr.axis("a", [0.1, 0.2]), yaw=rr.axis("a", [0.1, 0.3])),
            "^yaw has other coordinates along a than others",
        ),
        (
            lambda: rr.State(tilt=rr.axis("a", [0.1, 0.2]), yaw=rr.axis("a", [0.1])),
            "^yaw has 1 values along a, others have 2",
        ),
        (lambda: rr.axis("a", [[0.1]]), "values must be a flat array"),
        (lambda: rr.axis("a", ["15 deg", "20 deg"]), r'write rr\.axis\("a", .*, units="deg"\)'),
        (lambda: rr.axis("a", [DEGREE * 15, DEGREE * 20]), "values must be numbers, or one quant"),
    ],
)
def test_arrays_that_cannot_be_are_refused_by_their_element(make, words):
    with pytest.raises(rr.RimrollError, match=words):
        make()


MANY, START = rr.Body.stack([CAN, COIN]), rr.State(tilt=0.3)


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (
            lambda: rr.simulate(MANY, START, rr.NoSlip()),
            "body must be a single body, got bodies of",
        ),
        (lambda: rr.simulate(CAN, START, rr.Coulomb([0.1, 0.2])), "law must be a single law"),
        (lambda: rr.passage(MANY, rr.NoSlip()), "body must be a single body"),
        (lambda: rr.arrival(CAN, START, rr.Coulomb([0.1, 0.2])), "law must be a single law"),
        (lambda: rr.composite(MANY, START, rr.NoSlip()), "body must be a single body"),
        (lambda: rr.topple(MANY, rr.NoSlip()), "body must be a single body"),
        (lambda: rr.topple(CAN, rr.Coulomb([0.1, 0.2])), "law must be a single law"),
        (lambda: rr.watershed_slope(MANY, 0.3, rr.NoSlip()), "body must be a single body"),
        (
            lambda: rr.ensemble(MANY, rr.State(tilt=[0.1, 0.2, 0.3]), rr.NoSlip()),
            r"arrays must broadcast to one shape, got mass \(2,\)",
        ),
        (
            lambda: rr.ensemble(MANY, rr.State(tilt=[[0.1], [0.2]]), rr.NoSlip()),
            r"must be flat arrays, got shape \(2, 2\): for a grid, name its dimensions",
        ),
        (
            lambda: rr.ensemble(CAN, rr.State(tilt=rr.axis("turn", [0.1])), rr.NoSlip()),
            "a dimension cannot be called turn",
        ),
        (
            lambda: rr.ensemble(MANY, rr.State(tilt=[0.3, 1.2]), rr.NoSlip(), topple_tilt=1.0),
            r"^tilt\[1\] must be below topple_tilt",
        ),
        (
            lambda: rr.exact_turn(MANY, rr.State(tilt=rr.axis("t", [0.3])), rr.NoSlip()),
            "no named dimensions",
        ),
        (
            lambda: rr.exact_turn(
                MANY, rr.State(tilt=[[0.3], [2.0]]), rr.NoSlip(), topple_tilt=1.0
            ),
            r"^tilt\[1, 0\] must be below topple_tilt",
        ),
        (lambda: rr.steady_wobble_rate(CAN, [0.1, 0.8]), r"^at \[1\]: tilt must be"),
    ],
)
def test_what_cannot_be_computed_for_rows_is_refused_with_a_sentence(call, words):
    with pytest.raises(rr.RimrollError, match=words):
        call()


def test_an_axis_of_a_quantity_keeps_its_unit():
    tilt = rr.State(tilt=rr.axis("lean", [15.0, 20.0] * DEGREE)).tilt
    assert tilt.values == pytest.approx(np.radians([15.0, 20.0]), rel=1e-15, abs=0.0)
    rate = rr.axis("push", np.array([1, 10]) * DEGREE / registry().s)
    found = rr.State(tilt=0.5, yaw_rate=rate).yaw_rate
    assert found.values == pytest.approx(np.radians([1.0, 10.0]), rel=1e-15, abs=0.0)


@pytest.mark.parametrize(
    ("units", "values", "convert"),
    [
        ("deg", [15, 20], np.radians),
        ("deg", [15, 20], np.deg2rad),
        ("rad", [0.01, 0.02], np.degrees),
        ("turn", [0.01, 0.02], lambda lean: 2.0 * np.pi * lean),
    ],
)
def test_an_axis_that_is_converted_already_but_keeps_its_unit_is_refused(units, values, convert):
    lean = rr.axis("lean", values, units=units)
    assert rr.State(tilt=lean).shape == (2,)
    converted = convert(lean).assign_attrs(units=units)  # xarray keeps it, by its version
    with pytest.raises(rr.RimrollError, match="give the axis lean itself, which is converted"):
        rr.State(tilt=converted)
    # A unit that is given explicitly counts.
    labelled = converted.assign_attrs(units="deg" if convert is np.degrees else "rad")
    expected = rr.State(tilt=lean).tilt.values
    assert rr.State(tilt=labelled).tilt.values == pytest.approx(expected, rel=1e-14, abs=0.0)


def test_other_arithmetic_with_an_axis_is_as_it_was():
    lean = rr.axis("lean", [15, 20], units="deg")
    half = (0.5 * lean).assign_attrs(units="deg")
    assert rr.State(tilt=half).tilt.values == pytest.approx(
        np.radians([7.5, 10.0]), rel=1e-15, abs=0.0
    )
