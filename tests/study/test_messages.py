"""What is wrong with a study is said by file, field, value, bound and unit."""

import re

import numpy as np
import pytest

import rimroll as rr
from rimroll.errors import RimrollError

FALLS = {
    "body": {"preset": "can_2007"},
    "law": {"kind": "coulomb", "friction": 0.2},
    "start": {"tilt": "20 deg", "yaw_rate": 0.01},
}
SHAKEN = {
    "kind": "shake",
    "body": {"preset": "cylinder", "radius": "0.5 m", "length": "4 m"},
    "ground": {"synthetic": 1, "amplitude": "0.3 g"},
}


def friction(**table):
    return {"axes": {"friction": {"of": "law.friction", **table}}}


def drawn(**table):
    return {"random": {"friction": {"of": "law.friction", **table}}, "trials": 3}


WRONG = [
    ({"kind": "ensembel"}, "unknown kind 'ensembel': did you mean 'ensemble'?"),
    ({"trails": 3}, "has an unknown key 'trails': did you mean 'trials'?"),
    ({"trials": 0}, "trials is 0: input should be greater than 0"),
    ({"trials": 5}, "trials must be 1 where nothing is random, got 5"),
    ({"seed": -1}, "seed must be a whole number >= 0 and below 2^63, got -1"),
    ({"combine": "sum"}, "unknown combine 'sum': choose from product, zip"),
    ({"sampling": "sobl"}, "unknown sampling 'sobl': did you mean 'sobol'?"),
    ({"start": None}, "has no [start] and no [release]"),
    ({"release": "flick"}, "has both [start] and [release]: give one"),
    ({"start": "flying"}, 'start must be a table or "standing", got "flying"'),
    ({"start": {"tilt": "200 deg"}}, "[start] tilt must be between -180 and 180 deg, got 200 deg"),
    ({"start": {"tilt": -0.1}}, "[start] tilt must be inside (0, pi), got -0.1 rad"),
    ({"body": {"preset": "can"}}, "[body] unknown preset 'can'"),
    ({"body": {"preset": "coin", "factors": {"length": 2}}}, "[body.factors] has an unknown key"),
    ({"law": {"kind": "coulomb"}}, "[law] coulomb needs friction"),
    ({"ground": {"pulse": "sine"}}, "[ground] does not go with kind 'ensemble'"),
    ({"simulation": {"gravity": "9.8 m"}}, "gravity must be an acceleration"),
    ({"keep": ["turm"]}, "keep: unknown column 'turm': did you mean 'turn'?"),
    ({"keep": []}, 'keep must be "all" or a list of columns, got []'),
    (friction(), "[axes.friction] needs one of values, range and log_range, got none"),
    (friction(values=[]), "[axes.friction] values must be one or more, got none"),
    (friction(values=[0.1], range=[0, 1]), "got values and range"),
    (friction(range=[0, 1]), "[axes.friction] range lacks 'number': how many values"),
    (friction(range=[0, 1, 2], number=3), "range must be two numbers, got [0, 1, 2]"),
    (friction(range=[0, 1], number=0), "number must be between 1 and 1000000, got 0"),
    (friction(log_range=[0, 1], number=3), "log_range must be > 0, got 0 to 1"),
    (friction(values=[0.1, -0.2]), "[axes.friction] [law] friction[1] must be"),
    (
        friction(values=["1 m"]),
        '[axes.friction] values[0] must be a pure number such as "0.5", got "1 m"',
    ),
    (friction(values=[0.1], labels=["a", "b"]), "labels must be as many as the values, 1, got 2"),
    (friction(values=[0.1], steps=3), "[axes.friction] has an unknown key 'steps'"),
    ({"axes": {"friction": {"values": [1]}}}, "[axes.friction] lacks 'of'"),
    ({"axes": {"law.frictoin": [1]}}, "unknown quantity 'law.frictoin': did you mean"),
    ({"axes": {"turn": {"of": "law.friction", "values": [1]}}}, "'turn' is the name of a result"),
    ({"axes": {"trial": {"of": "law.friction", "values": [1]}}}, "the name of the trials"),
    ({"axes": {"body.preset": ["coin", "cup"]}}, "[axes.preset] [body] unknown preset 'cup'"),
    ({"axes": {"body.preset": {"range": [1, 2], "number": 2}}}, "body.preset is no number"),
    ({"axes": {"body.height": ["5 cm", "-1 cm"]}}, "height[1] must be"),
    (
        {"axes": {"a": {"of": "law.friction", "values": [1]}, "law.friction": [1]}},
        "law.friction is varied twice, by a and friction",
    ),
    (
        {"combine": "zip", "axes": {"law.friction": [1, 2], "start.tilt": [0.1]}},
        "axes along 'case' must be of one length: friction has 2 values, tilt has 1",
    ),
    (
        {"axes": {"law.friction": {"range": [0, 1], "number": 100}}, "most_rows": 10},
        "100 friction are 100 rows, more than most_rows = 10",
    ),
    (drawn(), "[random.friction] lacks 'distribution', a text"),
    (drawn(distribution="normal", mean=0.2), "lacks 'spread': normal has mean and spread"),
    (drawn(distribution="normal", mean=0.2, spread=-1), "spread must be >= 0, got -1"),
    (drawn(distribution="normal", mean=0.2, sd=1), "has an unknown key 'sd'"),
    (drawn(distribution="lognormal", median=0, dispersion=1), "median must be > 0, got 0"),
    (drawn(distribution="uniform", low=1, high=0), "high must be above low, 1, got 0"),
    (drawn(distribution="nromal"), "unknown distribution 'nromal': did you mean 'normal'?"),
    (drawn(distribution="gamma", scale=1), "lacks 'a': gamma has a, loc, scale"),
    (drawn(distribution="gamma", a=-1), "gamma has no quantiles for { a = -1 }"),
    (
        {"random": {"law.kind": {"distribution": "normal"}}, "trials": 2},
        "law.kind is no number, so it has no distribution",
    ),
    (
        {"law": {"kind": "coulomb", "friction": 0.2, "air_drag": {"coefficient": "film"}}}
        | {"axes": {"simulation.gravity": [9.8, 1.6]}},
        '[law.air_drag] coefficient "film" needs a single body and gravity: simulation.gravity',
    ),
    (
        {"law": {"kind": "coulomb", "friction": 0.2, "air_drag": {"coefficient": "film"}}}
        | {"random": {"body.radius": {"distribution": "normal", "mean": 1, "spread": 0}}}
        | {"trials": 2},
        "needs a single body and gravity: body.radius varies",
    ),
    ({"axes": {"my friction": {"of": "law.friction", "values": [1]}}}, "name 'my friction' must"),
    ({"axes": {"a/b": {"of": "law.friction", "values": [1]}}}, "name 'a/b' must consist of"),
    (friction(values=[1], along="a b"), "[axes.friction] the name 'a b' must consist of"),
    ({"random": {"a b": {"of": "law.friction"}}}, "[random.a b] the name 'a b' must consist of"),
    (friction(values=[1], along="done"), "'done' is the name of a folder of the store"),
    (
        {"axes": {"a": {"of": "start.tilt", "values": [1], "along": "b"}}}
        | {
            "random": {
                "b": {"of": "law.friction", "distribution": "normal", "mean": 1, "spread": 0}
            }
        },
        "'b' is the name of a random quantity",
    ),
    (
        {
            "axes": {"number": {"of": "law.friction", "values": [1]}},
            "statistics": {"mean": ["turn"]},
        },
        "[statistics] 'number' is also the name of an axis: take another",
    ),
    (
        {"axes": {"turn_bin": {"of": "law.friction", "values": [1]}}}
        | {"statistics": {"histogram": {"turn": {"range": [0, 1], "bins": 2}}}},
        "'turn_bin' is also the name of an axis",
    ),
    (friction(values=[1, 2], labels=["a", 1]), 'labels must be all numbers or all texts, got ["a"'),
    (
        drawn(distribution="normal", mean=0.5, spread=0.1)
        | {"trials": 2**30 + 1, "sampling": "sobol"},
        "trials must be at most 1073741824 with sampling 'sobol', got 1073741825",
    ),
    (
        drawn(distribution="normal", mean=0.5, spread=0.1) | {"trials": 10**8},
        "[random.friction] reaches about -0.07307, 1.073 in 100000000 draws: [law] friction must",
    ),
    (
        {"kind": "exact_turn", "law": "no_slip", "simulation": {"rtol": 1e-8}},
        "[simulation] rtol has no effect",
    ),
    ({"simulation": {"flat": "housner"}}, "[simulation] flat has no effect on kind 'ensemble'"),
    ({"simulation": {"flat_gap": 1e-4}}, "[simulation] flat_gap has no effect on kind"),
    ({"axes": {"simulation.flat": ["stop"]}}, "[simulation] flat has no effect on kind 'ensemble'"),
    ({"statistics": {}}, "[statistics] is empty"),
    ({"statistics": {"mean": ["outcome"]}}, "mean: outcome is no number: count it"),
    ({"statistics": {"count": ["turn"]}}, "count: turn is a number"),
    ({"statistics": {"over": ["x"], "mean": ["turn"]}}, "over: unknown dimension 'x'"),
    ({"statistics": {"fragility": "friction"}}, "fragility: unknown dimension 'friction'"),
    (
        {"statistics": {"histogram": {"turn": {"range": [1, 0], "bins": 3}}}},
        "histogram.turn range must rise, got [1, 0]",
    ),
    (
        {"statistics": {"histogram": {"turn": {"range": [0, 1], "bins": 0}}}},
        "bins must be between 1 and 100000, got 0",
    ),
]


@pytest.mark.parametrize(("change", "message"), WRONG)
def test_studies_of_falls(change, message):
    content = {name: one for name, one in (FALLS | change).items() if one is not None}
    with pytest.raises(RimrollError, match=re.escape(message)):
        rr.Study.from_dict({"study": content, "folder": "."}).plan()


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"ground": None}, "has no table [ground]: say how the table moves"),
        (
            {"ground": {"synthetic": 1.5, "amplitude": 1}},
            "synthetic must be a seed, a whole number",
        ),
        ({"ground": {"synthetic": 1}}, "[ground] lacks 'amplitude'"),
        ({"ground": {"record": "no.at2"}}, "no.at2"),
        ({"axes": {"ground.scale": [1, -1]}}, "scale[1] must be between 1e-6 and 1e6, got -1"),
        ({"release": "flick"}, "has both [start] and [release]"),
        ({"start": {"standing": True, "tilt": 1}}, "a body that stands has no tilt"),
    ],
)
def test_studies_of_shaken_bodies(change, message):
    content = {name: one for name, one in (SHAKEN | change).items() if one is not None}
    if message.startswith("has both"):
        content["start"] = {"tilt": 0.1}
    with pytest.raises(RimrollError, match=re.escape(message)):
        rr.Study.from_dict({"study": content, "folder": "."}).plan()


def test_what_is_no_number_text_or_table_is_no_study():
    with pytest.raises(RimrollError, match="law must be a number, a text, a list or a table"):
        rr.Study(body={"preset": "coin"}, law=object())


def test_rows_that_there_are_not():
    plan = rr.Study(**FALLS).plan()
    with pytest.raises(RimrollError, match="rows must be between 0 and 1, got 0 to before 2"):
        plan.compute(0, 2)


def test_files_are_named(tmp_path):
    with pytest.raises(RimrollError, match=r"none\.toml: there is no such file"):
        rr.Study.from_file(tmp_path / "none.toml")
    file = tmp_path / "empty.toml"
    file.write_text("", "utf-8")
    with pytest.raises(RimrollError, match=r"empty\.toml: is empty: write what rolls"):
        rr.Study.from_file(file)


def test_a_hand_keeps_columns_whose_names_are_taken():
    content = {"kind": "topple", "body": {"preset": "coin"}, "law": FALLS["law"]}
    content["axes"] = {"release.friction_scale": [1, 2]}
    with pytest.raises(RimrollError, match="'friction_scale' is the name of a column"):
        rr.Study(**content).plan()


def test_a_date_in_a_file_is_refused(tmp_path):
    file = tmp_path / "dated.toml"
    file.write_text("start = { tilt = 1979-05-27 }\nbody = { preset = 'coin' }", "utf-8")
    with pytest.raises(RimrollError, match=r"dated\.toml: tilt must be a number, .* 1979-05-27"):
        rr.Study.from_file(file)


def test_a_value_that_is_refused_names_its_row_and_its_chunk(tmp_path, monkeypatch):
    drawn = {"distribution": "normal", "spread": 0.08}
    study = rr.Study(
        body={"preset": "coin"},
        law="coulomb",
        start={"tilt": 0.3, "yaw_rate": 0.1},
        random={"law.friction": {**drawn, "mean": 0.7}, "law.static": {**drawn, "mean": 0.9}},
        trials=50,
        chunk=5,
    )
    friction, static = (one.array for one in study.description.block(0, 50).given)
    row = int(np.flatnonzero(static < friction)[0])
    with pytest.raises(RimrollError, match=rf"^row {row}: \[law\] static must be between friction"):
        study.plan()
    monkeypatch.setattr("rimroll.study.plan.TRIED", 1)
    with pytest.raises(RimrollError, match=rf"^chunk {row // 5}: row {row}: \[law\] static must"):
        study.run(tmp_path / "slips.zarr")
