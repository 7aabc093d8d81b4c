"""Figures and tables of finished and partial studies."""

import json
import re

import numpy as np
import pytest

import rimroll as rr
from rimroll.cli import main
from rimroll.errors import RimrollError
from rimroll.study.figures import study_figure
from rimroll.study.plan import dataset_of
from rimroll.study.quantities import names, quantity_of

FILE = """
title = "Cans and coins"
trials = 5
chunk = 40
body = { preset = "coin" }
law = "coulomb"
release = "let_go"
keep = ["turn", "outcome", "slid", "steps"]

[axes]
body = { of = "body.preset", values = ["coin", "can_2007"] }
height = { of = "body.factors.height", range = [0.8, 1.2], number = 3 }
friction = { of = "law.friction", range = [0.1, 0.4], number = 4 }
"""


def finished(plan):
    columns = plan.compute(0, plan.rows)
    if plan.statistics is not None:
        columns = plan.statistics.merged([plan.statistics.of(0, plan.rows, columns)])
    return dataset_of(plan, columns)


@pytest.fixture(scope="module")
def study(tmp_path_factory):
    file = tmp_path_factory.mktemp("study") / "cans.toml"
    file.write_text(FILE, "utf-8")
    return file


@pytest.fixture(scope="module")
def dataset(study):
    return finished(rr.Study.from_file(study).plan())


def test_a_study_of_two_bodies_is_a_map_for_each(dataset):
    figure = study_figure(dataset)
    titles = [ax.get_title(loc="left") for ax in figure.axes if ax.get_title(loc="left")]
    assert titles == ["coin", "can 2007"]
    first = figure.axes[0]
    assert first.get_ylabel() == "height"
    (mesh,) = first.collections
    shown = np.degrees(dataset.turn.sel(body="coin").mean("trial").values)
    np.testing.assert_allclose(np.asarray(mesh.get_array()).reshape(3, 4), shown)


def test_curves_have_a_line_for_each_value_of_one_dimension(dataset):
    figure = study_figure(dataset, ["slid"], form="curve", along=["friction"])
    lines = figure.axes[1].get_lines()
    assert len(lines) == 3
    part = dataset.slid.isel(body=1).mean("trial")
    for k, line in enumerate(lines):
        np.testing.assert_allclose(line.get_ydata(), part.isel(height=k))


def test_histograms_and_pairs_count_all_motions(dataset):
    histogram = study_figure(dataset, ["turn"], form="histogram").axes[0]
    assert sum(bar.get_height() for bar in histogram.patches) == dataset.turn.notnull().sum()
    pair = study_figure(dataset, ["turn", "steps"])
    assert pair.axes[0].get_xlabel() == "angle of turn (°)"
    assert pair.axes[0].get_ylabel() == "steps of the solver"


def test_a_part_is_the_share_of_a_word(dataset):
    part = quantity_of(dataset, "outcome=rocked")
    flags = dataset.outcome.attrs["flag_meanings"].split()
    np.testing.assert_array_equal(part, dataset.outcome == flags.index("rocked"))


def test_statistics_show_means_parts_and_their_histogram(study):
    content = rr.Study.from_file(study).to_dict()
    content["study"]["statistics"] = {
        "count": ["outcome", "slid"],
        "mean": ["turn"],
        "histogram": {"turn": {"range": [-8.0, 8.0], "bins": 20}},
    }
    dataset = finished(rr.Study.from_dict(content).plan())
    assert {"turn", "slid", "outcome=rocked"} <= set(names(dataset))
    np.testing.assert_array_equal(quantity_of(dataset, "slid"), dataset.slid_count / 5)
    axes = study_figure(dataset, ["turn"], form="histogram").axes[0]
    assert sum(bar.get_height() for bar in axes.patches) == dataset.turn_histogram.sum()
    panels = study_figure(dataset, ["turn"], along=["friction"], form="histogram").axes
    assert len(panels) == dataset.sizes["friction"]
    for k, panel in enumerate(panels):
        counts = [bar.get_height() for bar in panel.patches]
        there = dataset.turn_histogram.isel(friction=k)
        others = [dim for dim in there.dims if dim != "turn_bin"]
        np.testing.assert_array_equal(counts, there.sum(others))
    with pytest.raises(RimrollError, match=r"one dimension of .*friction.*, got turn"):
        study_figure(dataset, ["turn"], along=["turn"], form="histogram")


@pytest.mark.parametrize(
    ("view", "message"),
    [
        ({"quantities": ["turm"]}, "unknown quantity 'turm': did you mean 'turn'?"),
        ({"quantities": ["outcome=rokced"]}, "did you mean 'outcome=rocked'?"),
        ({"along": ["frction"]}, "unknown dimension 'frction': did you mean 'friction'?"),
        ({"places": {"body": "bottle"}}, "unknown body 'bottle': choose from coin, can_2007"),
        ({"places": {"friction": "low"}}, "friction must be a number, got 'low'"),
        ({"form": "pie"}, "unknown form 'pie'"),
        ({"quantities": ["turn", "slid", "steps"]}, "give one or two quantities, got 3"),
    ],
)
def test_what_cannot_be_drawn_is_refused(dataset, view, message):
    with pytest.raises(RimrollError, match=re.escape(message)):
        study_figure(dataset, **view)


def test_show_draws_and_lists_a_partial_and_a_finished_study(study, capsys):
    pytest.importorskip("zarr")
    assert main(["study", "run", str(study), "--chunks", "0:2"]) == 0
    picture = study.with_suffix(".svg")
    assert main(["study", "show", str(study), "-o", str(picture)]) == 0
    assert "<svg" in picture.read_text("utf-8")
    capsys.readouterr()
    assert main(["study", "show", str(study), "--of", "steps", "--json"]) == 0
    assert (
        json.loads(capsys.readouterr().out)["quantities"]["steps"]["values"] == 60
    )  # a chunk is a box
    assert main(["study", "run", str(study)]) == 0
    capsys.readouterr()
    assert main(["study", "show", str(study.with_suffix(".zarr")), "--at", "body=coin"]) == 0
    shown = capsys.readouterr().out
    assert "Cans and coins" in shown
    assert " 60 " in shown


def test_show_has_the_statistics_of_the_chunks_that_are_done(tmp_path, capsys):
    pytest.importorskip("zarr")
    study = tmp_path / "counted.toml"
    study.write_text(FILE + '\n[statistics]\ncount = ["slid"]\n', "utf-8")
    assert main(["study", "run", str(study), "--chunks", "0:1"]) == 0
    capsys.readouterr()
    assert main(["study", "show", str(study), "--json"]) == 0
    # 40 rows are 8 of the 24 places.
    assert json.loads(capsys.readouterr().out)["quantities"]["slid"]["values"] == 8
    assert main(["study", "show", str(study.with_suffix(".zarr"))]) == 2
    assert "is not finished: give the study" in capsys.readouterr().err
