"""A study's columns are those of the functions of rimroll, whatever the chunks."""

import itertools
import json
import pickle

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import rimroll as rr
from given.strategies import examples
from rimroll.errors import RimrollError
from rimroll.study.description import described
from rimroll.study.plan import Plan
from rimroll.study.setups import _read_ground_once

START = rr.State(tilt="30 deg", tilt_rate=-0.5, yaw_rate=0.005)


def falls_over(**more):
    given = {
        "body": rr.bodies.can_2007(),
        "law": rr.Coulomb(0.2),
        "start": START,
        "axes": {"law.friction": [0.1, 0.2, 0.3], "body.height": ["5 cm", "7 cm"]},
    }
    return rr.Study(**(given | more))


def flicks(**more):
    given = {
        "kind": "topple",
        "body": {"preset": "can_2007"},
        "law": {"kind": "coulomb"},
        "release": "paper",
        "axes": {"law.friction": [0.05, 0.1, 0.2]},
        "trials": 40,
        "seed": 3,
    }
    return rr.Study(**(given | more))


def words(plan: Plan, columns, name):
    return np.array(plan.columns[name].flags)[columns[name]]


def test_a_product_has_the_falls_of_an_ensemble_over_named_axes():
    plan = falls_over().plan()
    assert dict(plan.dims) == {"friction": 3, "height": 2}
    assert plan.coords["height"].unit == "m"
    columns = plan.compute(0, plan.rows)
    height, friction = rr.axis("height", [0.05, 0.07]), rr.axis("friction", [0.1, 0.2, 0.3])
    can = rr.bodies.can_2007()
    body = rr.Body(can.mass, can.radius, height, can.transverse_inertia, can.axial_inertia)
    falls = rr.ensemble(body, START, rr.Coulomb(friction)).transpose("friction", "height")
    for name in plan.columns.keys() - {"outcome"}:
        assert np.array_equal(columns[name], falls[name].values.ravel(), equal_nan=True), name
    assert (words(plan, columns, "outcome") == falls.outcome.values.ravel()).all()


def test_the_trials_of_a_study_are_those_of_topple():
    plan = flicks(sampling="common").plan()
    columns = plan.compute(0, plan.rows)
    for k, friction in enumerate([0.05, 0.1, 0.2]):
        falls = rr.topple(rr.bodies.can_2007(), rr.Coulomb(friction), 40, "paper", seed=3)
        here = slice(40 * k, 40 * (k + 1))
        for name in ("turn", "direction", "start_tilt", "start_yaw_rate", "friction_scale"):
            assert np.array_equal(columns[name][here], falls[name].values, equal_nan=True), name
        assert (words(plan, columns, "outcome")[here] == falls.outcome.values).all()


@pytest.mark.parametrize("sampling", ["independent", "common", "sobol", "latin_hypercube"])
@examples(8)
@given(cuts=st.sets(st.integers(1, 119), max_size=5))
def test_columns_depend_on_no_chunk(sampling, cuts):
    plan = flicks(
        sampling=sampling,
        random={"body.height": {"distribution": "normal", "mean": "7 cm", "spread": "2 mm"}},
    ).plan()
    whole = plan.compute(0, plan.rows)
    ends = [0, *sorted(cuts), plan.rows]
    parts = [plan.compute(a, b, threads=1) for a, b in itertools.pairwise(ends)]
    for name, column in whole.items():
        again = np.concatenate([part[name] for part in parts])
        assert np.array_equal(column, again, equal_nan=True), name


def test_a_plan_survives_pickling_and_json():
    plan = flicks().plan()
    columns = plan.compute(30, 50)
    for again in (
        pickle.loads(pickle.dumps(plan)),
        rr.Study.from_dict(json.loads(json.dumps(plan.content))).plan(),
    ):
        assert again.attrs == plan.attrs
        for name, column in again.compute(30, 50).items():
            assert np.array_equal(column, columns[name], equal_nan=True), name


def test_described_is_what_the_content_says(tmp_path):
    content = {"body": {"preset": "coin"}, "start": {"tilt": "1 deg"}}
    assert described(content, tmp_path).rows == 1


def test_the_order_of_axes_and_of_dimensions_of_a_design_is_among_the_attributes_that_decide():
    axes = {"law.friction": [0.1, 0.2], "body.height": ["5 cm", "7 cm"]}
    ends = {"distribution": "uniform", "low": "5 cm", "high": "7 cm"}
    random = {"body.height": ends, "body.radius": ends}
    for more in ({"axes": axes}, {"axes": {}, "random": random, "trials": 8, "sampling": "sobol"}):
        turned = {
            name: dict(reversed(one.items())) if isinstance(one, dict) else one
            for name, one in more.items()
        }
        one, other = falls_over(**more).plan(), falls_over(**turned).plan()
        assert not np.array_equal(one.compute(0, one.rows)["turn"], other.compute(0, 4)["turn"])
        assert one.attrs != other.attrs


def test_a_record_that_is_edited_is_read_anew_and_not_in_the_middle_of_a_plan(tmp_path):
    file = tmp_path / "quake.csv"

    def write(size):
        lines = (f"{k / 50},{size * np.sin(k / 5):.6f}\n" for k in range(100))
        file.write_text("t,x\n" + "".join(lines), "utf-8")

    content = {
        "kind": "shake",
        "body": {"preset": "cylinder", "radius": "0.5 m", "length": "4 m"},
        "ground": {"record": "quake.csv", "units": "m/s^2"},
        "axes": {"law": ["no_slip", "in_place"]},
    }
    study = rr.Study.from_dict({"study": content, "folder": str(tmp_path)})
    write(4.0)
    weak = study.plan()
    tilt = weak.compute(0, 1)["max_tilt"]
    write(5.0)
    strong = study.plan()
    assert strong.attrs["records"] != weak.attrs["records"]
    assert strong.compute(0, 1)["max_tilt"] > tilt
    assert weak.compute(0, 1)["max_tilt"] == tilt
    write(6.0)
    _read_ground_once.cache_clear()
    with pytest.raises(RimrollError, match=r"quake\.csv has changed since the study was planned"):
        weak.compute(0, 1)


def test_a_file_without_a_store_has_its_store_beside_it(tmp_path):
    file = tmp_path / "falls.toml"
    file.write_text("body = { preset = 'coin' }\nstart = { tilt = 1 }\n", "utf-8")
    assert rr.Study.from_file(file).store == tmp_path / "falls.zarr"


def test_trials_are_only_numbered():
    assert list(flicks().plan().coords) == ["friction"]
