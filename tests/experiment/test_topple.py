"""The paper's experiment: falls by hand, their directions, their files and their picture."""

from __future__ import annotations

import errno
import itertools
import json
from pathlib import Path

import numpy as np
import pytest
import xarray as xr
from hypothesis import given
from hypothesis import strategies as st
from matplotlib.text import Text

import rimroll as rr
from given.strategies import examples
from rimroll.cli import main
from rimroll.experiment.histogram import falls_figure
from rimroll.experiment.toppling import counted, limits
from rimroll.figures import style
from rimroll.many.ensemble import VARIABLES
from rimroll.paper.setting import MEASURED

CAN = rr.bodies.can_2007()
COIN = rr.bodies.coin()

# The falls


def test_there_is_one_row_for_each_trial_with_the_release_and_the_seed():
    falls = rr.topple(CAN, rr.Coulomb(0.2), 5, "paper", seed=7)
    release = rr.Release.named("paper", CAN)
    assert falls.sizes == {"trial": 5}
    assert set(falls) >= {"outcome", "friction_scale", *VARIABLES, "start_tilt", "start_yaw_rate"}
    assert falls.attrs.items() >= release.parameters().items()
    assert falls.attrs["seed"] == 7 and falls.attrs["law_friction"] == 0.2
    starts, scales = release.draw(5, 7)
    assert np.array_equal(falls["start_tilt"], starts.tilt)
    assert np.array_equal(falls["friction_scale"], scales)
    assert falls.drop_attrs().identical(
        rr.ensemble(CAN, starts, rr.Coulomb(0.2), friction_scale=scales, rtol=1e-6).drop_attrs()
    )


def test_a_seed_makes_the_same_falls_again_and_chance_tells_its_seed():
    by_chance = rr.topple(CAN, rr.NoSlip(), 20)
    again = rr.topple(CAN, rr.NoSlip(), 20, seed=by_chance.attrs["seed"])
    assert again.identical(by_chance)
    other = rr.topple(CAN, rr.NoSlip(), 20)
    assert other.attrs["seed"] != by_chance.attrs["seed"]
    more = rr.topple(CAN, rr.NoSlip(), 40, seed=np.int64(again.attrs["seed"]), threads=1)
    assert more.isel(trial=slice(20)).identical(again)


def test_ctrl_c_hands_back_falls_that_tell_their_release_and_seed():
    def stop(done, total):
        if done:
            raise KeyboardInterrupt

    with pytest.raises(rr.Interrupted) as caught:
        rr.topple(CAN, rr.NoSlip(), 500_000, seed=3, threads=1, progress=stop)
    done = caught.value.done
    assert 0 < done.sizes["trial"] < 500_000
    whole = rr.topple(CAN, rr.NoSlip(), done.sizes["trial"], seed=3)
    assert done.identical(whole)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"n": 0}, "n must be a whole number >= 1"),
        ({"n": 10**8}, "n must be at most 10000000"),
        ({"seed": -1}, "seed must be a whole number >= 0"),
        ({"release": "throw"}, "unknown release 'throw'"),
        ({"release": 3}, r"release must be a rimroll.Release or the name of a preset, got 3"),
        ({"body": rr.bodies.can_2007}, "call it"),
        ({"law": 0.2}, r"law must be a rimroll.Law"),
    ],
)
def test_what_makes_no_experiment_is_refused_with_a_sentence(change, words):
    with pytest.raises(rr.RimrollError, match=words):
        rr.topple(**{"body": CAN, "law": rr.NoSlip(), "seed": 1, **change})


# Their message


def flicks(spread):
    """Flicks of the can with this spread of the sideways motion, rad/s."""
    return rr.Release((0.35, 0.02), (-5.0, 0.2), (0.0, spread), (0.0, spread))


@pytest.mark.parametrize(
    ("law", "limit"),
    [
        (rr.NoSlip(), rr.NoSlip()),
        (rr.Frictionless(), rr.Frictionless()),
        (rr.Coulomb(0.6), rr.NoSlip()),  # it rolls through for frictions above 0.356
        (rr.Coulomb(0.0), rr.Frictionless()),
    ],
    ids=str,
)
def test_falls_of_a_steadier_hand_come_closer_to_the_limits(law, limit):
    turn = rr.turn_limit(CAN, limit)
    farthest = []
    for spread in (1e-3, 1e-4, 1e-5):
        falls = rr.topple(CAN, law, 60, flicks(spread), seed=1, rtol=1e-9)
        assert (falls["outcome"] == "toppled").all()
        farthest.append(float(np.abs(np.abs(falls["turn"]) - turn).max()))
    assert farthest[0] < np.radians(0.5)
    # The error goes as ε ln ε (:func:`rimroll.error_law_coefficient`).
    assert farthest[1] < farthest[0] / 6.0 and farthest[2] < farthest[1] / 6.0


@examples(15)
@given(
    st.sampled_from([rr.NoSlip(), rr.Frictionless(), rr.Coulomb(0.1), rr.Coulomb(0.3)]),
    st.integers(0, 2**32),
    st.floats(1e-4, 0.05),
)
def test_no_fall_is_straight_ahead(law, seed, spread):
    falls = rr.topple(CAN, law, 60, flicks(spread), seed)
    beside = np.abs(np.degrees(falls["direction"]) - 180.0)
    assert (falls["outcome"] == "toppled").all()
    assert beside.min() > 15.0 and beside.max() < 50.0
    left = (falls["direction"] > np.pi).values
    assert np.array_equal(left, falls["turn"].values > 0.0)
    assert 5 < left.sum() < 55


def test_a_hand_that_misses_to_one_side_makes_more_falls_there():
    lefts = []
    for sideways in (0.1, -0.1):
        release = rr.Release((0.35, 0.02), (-5.0, 0.2), (sideways, 0.1), (0.0, 0.1))
        assert not release.symmetric
        falls = rr.topple(CAN, rr.NoSlip(), 400, release, seed=1)
        lefts.append(float((falls["direction"] > np.pi).mean()))
    # Missing to the left of the can turns the contact point anticlockwise.
    assert lefts[0] > 0.75
    assert lefts[0] + lefts[1] == pytest.approx(1.0, abs=0.1)  # mirror images, except for chance


def test_what_counts_is_what_most_of_those_did_that_came_down():
    toppled, word = counted(rr.topple(CAN, rr.NoSlip(), 30, "flick", seed=1))
    assert word == "toppled" and toppled.size == 30
    rocked, word = counted(rr.topple(COIN, rr.NoSlip(), 30, "let_go", seed=1))
    assert word == "rocked" and rocked.size == 30
    assert ((rocked >= 0.0) & (rocked <= 2.0 * np.pi)).all()
    # Released near its balance point, the can has all outcomes.
    mixed = rr.topple(CAN, rr.NoSlip(), 60, rr.Release((0.6, 0.05), sideways=(0, 0.3)), seed=1)
    directions, word = counted(mixed)
    same = (mixed["outcome"] == word).values
    assert 0 < same.sum() < 60
    assert np.array_equal(directions, mixed["direction"].values[same])
    nothing, _ = counted(rr.topple(CAN, rr.NoSlip(), 5, rr.Release(0.8, 1.0), seed=1))
    assert nothing.size == 0


def test_limits_are_those_of_theory_for_the_mean_release():
    law = rr.Coulomb(0.15)
    falls = rr.topple(CAN, law, 5, "paper", seed=1)
    start = rr.State(tilt=np.radians(20.0), tilt_rate=-5.0)
    assert limits(falls) == {
        "no_slip": rr.turn_limit(CAN, rr.NoSlip()),
        "frictionless": rr.turn_limit(CAN, rr.Frictionless()),
        "coulomb": rr.turn_limit(CAN, law, rr.arrival(CAN, start, law)),
    }
    assert list(limits(rr.topple(CAN, rr.NoSlip(), 5, seed=1))) == ["no_slip", "frictionless"]


def test_limits_know_the_friction_scale_and_leave_out_what_is_none():
    half = rr.Release(np.radians(20.0), -5.0, twist=(0.0, 0.1), friction_scale=0.5)
    found = limits(rr.topple(CAN, rr.Coulomb(0.3), 3, half, seed=1))["coulomb"]
    whole = rr.Release(np.radians(20.0), -5.0, twist=(0.0, 0.1))
    assert found == limits(rr.topple(CAN, rr.Coulomb(0.15), 3, whole, seed=1))["coulomb"]
    fast = rr.Release(np.radians(20.0), -14.0, twist=(0.0, 0.1))  # lifts off on the way down
    assert "coulomb" not in limits(rr.topple(CAN, rr.Coulomb(0.3), 3, fast, seed=1))


def test_limits_of_falls_without_a_release_are_for_their_mean_start():
    starts = rr.State(tilt=np.array([0.3, 0.4]), tilt_rate=-5.0, yaw_rate=0.1)
    law = rr.Coulomb(0.15)
    falls = rr.ensemble(CAN, starts, law)
    mean = rr.State(tilt=0.35, tilt_rate=-5.0)
    expected = rr.turn_limit(CAN, law, rr.arrival(CAN, mean, law))
    assert limits(falls)["coulomb"] == pytest.approx(expected)


# The picture


@pytest.fixture(scope="module")
def papers():
    return rr.topple(CAN, rr.Coulomb(0.15), 200, "paper", seed=1)


def lines_at(ax):
    """The places of vertical lines across a panel."""
    return [line.get_xdata()[0] for line in ax.lines if len(set(line.get_xdata())) == 1]


def bins(ax):
    """Counts of the first histogram, and its edges."""
    data = ax.patches[0].get_data()
    return np.nan_to_num(data.values), data.edges


def test_the_histogram_has_every_fall_in_its_bin(papers):
    ax = falls_figure(papers).axes[0]
    counts, edges = bins(ax)
    directions = np.degrees(counted(papers)[0])
    assert counts.sum() == directions.size
    assert np.array_equal(counts, np.histogram(directions, edges)[0])
    assert 180.0 in edges and len(set(np.round(np.diff(edges), 9))) == 1
    assert ax.get_xlabel() == "direction of fall (degrees)"
    assert ax.get_ylabel().startswith("falls (per")


def test_limits_and_measurements_stand_on_both_sides(papers):
    figure = falls_figure(papers)
    for turn in np.degrees(list(limits(papers).values())):
        for side in (turn, 360.0 - turn):
            assert np.isclose(lines_at(figure.axes[0]), side).any()
            assert np.isclose(np.degrees(lines_at(figure.axes[1])), side).any()
    (left, spread), (right, _) = MEASURED
    marks = [line for line in figure.axes[0].lines if line.get_marker() == "o"]
    assert [line.get_xdata()[0] for line in marks] == pytest.approx([left, 360.0 - right])
    texts = [text.get_text() for text in figure.legends[0].texts]
    assert any("202.29°" in text for text in texts) and any("220.97°" in text for text in texts)
    assert any(f"{left}° ± {spread}°" in text for text in texts)


def test_the_papers_measurements_are_drawn_for_its_can_only_by_default(papers):
    def measured(figure):
        return any("measured" in text.get_text() for text in figure.legends[0].texts)

    bottle = rr.topple(rr.bodies.beer_bottle(), rr.NoSlip(), 10, seed=1)
    assert measured(falls_figure(papers)) and not measured(falls_figure(papers, measured=False))
    assert not measured(falls_figure(bottle)) and measured(falls_figure(bottle, measured=True))


def test_left_is_left_of_the_hand_at_the_bottom(papers):
    figure = falls_figure(papers)
    rose = figure.axes[1]
    figure.draw_without_rendering()
    x0, y0 = rose.transData.transform((0.0, 0.0))
    to_left = rose.transData.transform((np.radians(213.0), 1.0))
    hand = rose.transData.transform((0.0, 1.0))
    assert to_left[0] < x0 and to_left[1] > y0
    assert hand[1] < y0 and hand[0] == pytest.approx(x0, abs=1e-6)


def test_a_disk_is_drawn_around_its_first_lean_and_rocks():
    falls = rr.topple(COIN, rr.NoSlip(), 100, "let_go", seed=1)
    ax = falls_figure(falls).axes[0]
    counts, edges = bins(ax)
    assert counts.sum() == 100
    assert edges[0] == -edges[-1] and edges[-1] < 90.0
    assert "largest tilt" in ax.get_xlabel() and "rocked" in ax.get_title(loc="left")
    turn = np.degrees(rr.turn_limit(COIN, rr.NoSlip()))
    assert np.isclose(lines_at(ax), turn - 360.0).any()
    assert np.isclose(lines_at(ax), 360.0 - turn).any()


def test_bins_are_narrower_where_there_are_more_falls():
    widths = []
    for n in (42, 400, 4000):
        edges = bins(falls_figure(rr.topple(CAN, rr.NoSlip(), n, "paper", seed=1)).axes[0])[1]
        widths.append(edges[1] - edges[0])
    assert 1.0 <= widths[0] <= 3.0
    assert widths[0] > widths[1] > widths[2]


def test_a_title_says_what_was_done_and_what_became_of_it(papers):
    title = falls_figure(papers).get_suptitle()
    assert title.startswith("can_2007, coulomb, friction 0.15; 200 trials:")
    assert "toppled" in title and "20 ± 2°" in title and "seed 1" in title
    assert falls_figure(papers, name="my can").get_suptitle().startswith("my can,")


def test_several_falls_share_a_picture_if_they_are_of_one_body(papers):
    ice = rr.topple(CAN, rr.surfaces.ice(), 50, "paper", seed=1)
    figure = falls_figure({"wood": papers, "ice": ice})
    texts = [text.get_text() for text in figure.legends[0].texts]
    assert any(text.startswith("ice, ") for text in texts)
    assert any(text.startswith("wood limit") for text in texts)
    bottle = rr.topple(rr.bodies.beer_bottle(), rr.NoSlip(), 10, seed=1)
    with pytest.raises(rr.RimrollError, match="one body"):
        falls_figure({"can": papers, "bottle": bottle})
    with pytest.raises(rr.RimrollError, match="no falls"):
        falls_figure({})
    with pytest.raises(rr.RimrollError, match="there is no"):
        falls_figure(papers.drop_attrs())


NONE_DOWN = rr.Release(0.8, 1.0)
PICTURES = {
    "the paper's": lambda: rr.topple(CAN, rr.Coulomb(0.15), 42, "paper", seed=1),
    "one": lambda: rr.topple(CAN, rr.NoSlip(), 1, seed=1),
    "none that came down": lambda: rr.topple(CAN, rr.NoSlip(), 5, NONE_DOWN, seed=1),
    "none at all": lambda: rr.topple(CAN, rr.NoSlip(), 5, seed=1).isel(trial=slice(0)),
    "humps that meet": lambda: rr.topple(rr.bodies.beer_bottle(), rr.NoSlip(), 300, "paper", 1),
    "a coin": lambda: rr.topple(COIN, rr.Coulomb(0.2), 100, "let_go", seed=1),
    "all round": lambda: rr.topple(rr.bodies.battery(), rr.Frictionless(), 300, "paper", 1),
    "a long title": lambda: rr.topple(
        CAN, rr.Stribeck(0.2, 0.3, restitution=0.5) + rr.RollingResistance(1e-5), 20, "flick", 1
    ),
}


def texts(figure):
    """The visible texts and their boxes."""
    figure.draw_without_rendering()
    flat = figure.axes[0]
    beyond = [
        label
        for axis, (low, high) in ((flat.xaxis, flat.get_xlim()), (flat.yaxis, flat.get_ylim()))
        for label, at in zip(axis.get_ticklabels(), axis.get_ticklocs(), strict=True)
        if not min(low, high) <= at <= max(low, high)
    ]
    return {
        text: text.get_window_extent()
        for text in figure.findobj(Text)
        if text.get_text().strip() and text.get_visible() and text not in beyond
    }


@pytest.mark.parametrize("name", PICTURES)
def test_no_text_covers_another(name):
    with style.figure_style():
        figure = falls_figure(PICTURES[name]())
        boxes = texts(figure)
    assert len(boxes) > 20
    for (one, a), (other, b) in itertools.combinations(boxes.items(), 2):
        apart = a.x1 <= b.x0 or b.x1 <= a.x0 or a.y1 <= b.y0 or b.y1 <= a.y0
        assert apart, (one.get_text(), other.get_text())
    for text, box in boxes.items():
        inside = box.x0 >= 0.0 and box.x1 <= figure.bbox.x1 and box.y1 <= figure.bbox.y1
        assert inside, text.get_text()


# The command


@pytest.fixture
def stdout_of(capsys):
    """Runs a command that must succeed, and returns its stdout."""

    def run(arguments):
        assert main(arguments.split()) == 0
        captured = capsys.readouterr()
        assert captured.err == ""
        return captured.out

    return run


def test_topple_tells_left_and_right_beside_the_limits(stdout_of):
    text = stdout_of("topple --seed 1 --release paper --friction 0.15")
    falls = rr.topple(CAN, rr.Coulomb(0.15), 42, "paper", seed=1)
    turns = np.degrees(falls["turn"][falls["outcome"] == "toppled"].values)
    assert f"{turns[turns > 0].mean():.3f}°" in text
    assert f"{turns[turns > 0].std(ddof=1):.3f}°" in text
    assert "202.287°" in text and "220.969°" in text
    assert f"{np.degrees(limits(falls)['coulomb']):.3f}°" in text
    assert "42 falls:" in text and "seed 1" in text and "left" in text and "right" in text
    assert "from tilt 20° ± 2°, rates of tilt -5 ± 0.35" in text


def test_topple_in_json_is_the_api(stdout_of):
    answer = json.loads(stdout_of("topple soda_can -n 50 --seed 3 --json"))
    falls = rr.topple(rr.bodies.soda_can(), rr.NoSlip(), 50, seed=3)
    assert answer["parameters"] == {**falls.attrs, "body": "soda_can"}
    assert answer["number"] == 50 and sum(answer["outcomes"].values()) == 50
    assert answer["turn_limit"] == limits(falls)
    left = falls["turn"].values[falls["turn"].values > 0]
    assert answer["sides"]["anticlockwise"]["mean_turn"] == float(left.mean())
    assert answer["sides"]["anticlockwise"]["side"] == "left"
    assert answer["outcome"] == "toppled"


def test_options_change_parts_of_the_release(stdout_of):
    changes = (
        "--release let-go --tilt 22deg --tilt-spread 1deg --tilt-rate -5rad/s --tilt-rate-spread"
        " 20deg/s --sideways 0.01 --sideways-spread 0.2 --twist -1deg/s --twist-spread 0.1"
        " --friction-scale-spread 10% --unsteadiness 2"
    )
    answer = json.loads(stdout_of(f"topple -n 3 --seed 1 {changes} --json"))["parameters"]
    expected = rr.Release(
        tilt=(np.radians(22.0), np.radians(1.0)),
        tilt_rate=(-5.0, np.radians(20.0)),
        sideways=(0.01, 0.4),
        twist=(np.radians(-1.0), 0.2),
        friction_scale=(1.0, 0.1),
    )
    for name, value in expected.parameters().items():
        assert answer[name] == pytest.approx(value), name


def test_motion_options_and_the_table_are_those_of_the_other_commands(stdout_of):
    answer = json.loads(
        stdout_of(
            "topple -n 3 --seed 1 --gravity 9.8 --duration 3s --rtol 1e-7 --max-steps 5000"
            " --topple-tilt 80deg --surface wood --rolling-resistance 1e-5 --threads 1 --json"
        )
    )["parameters"]
    assert (answer["gravity"], answer["duration"], answer["rtol"]) == (9.8, 3.0, 1e-7)
    assert (answer["max_steps"], answer["topple_tilt"]) == (5000, np.radians(80.0))
    assert (answer["law_friction"], answer["law_rolling_dry"]) == (0.3, 1e-5)


def test_csv_begins_with_degrees_and_outcome_and_keeps_every_bit(stdout_of, tmp_path):
    path = tmp_path / "falls.csv"
    assert f"wrote {path}" in stdout_of(f"topple -n 20 --seed 1 --friction 0.2 -o {path}")
    falls = rr.topple(CAN, rr.Coulomb(0.2), 20, seed=1)
    lines = path.read_text().splitlines()
    assert lines[0].startswith("direction[deg],outcome,turn[rad],direction[rad],")
    comments = [line for line in lines if line.startswith("# ")]
    assert "# seed = 1" in comments and "# law_friction = 0.2" in comments
    assert "# body = can_2007" in comments and f"# rimroll_version = {rr.__version__}" in comments
    read = np.genfromtxt(
        path, delimiter=",", names=True, deletechars="", dtype=None, encoding="utf-8"
    )
    assert np.array_equal(read["direction[deg]"], np.degrees(falls["direction"]))
    assert read["outcome"].tolist() == falls["outcome"].values.tolist()
    assert np.array_equal(read["turn[rad]"], falls["turn"])
    assert np.array_equal(read["start_yaw_rate[rad/s]"], falls["start_yaw_rate"])
    assert np.array_equal(read["slid"], falls["slid"])


@pytest.mark.parametrize("seed", [1, 2**40])
def test_netcdf_opens_again_as_the_same_falls(stdout_of, tmp_path, seed):
    path = tmp_path / "falls.nc"
    stdout_of(f"topple -n 20 --seed {seed} -o {path}")
    with xr.open_dataset(path) as read:
        falls = rr.topple(CAN, rr.NoSlip(), 20, seed=seed)
        assert read.equals(falls)
        assert int(read.attrs["seed"]) == seed and read.attrs["body_mass"] == CAN.mass
        assert read["turn"].attrs["units"] == "rad"
        assert falls_figure(read.load()).get_suptitle() == falls_figure(falls).get_suptitle()


def test_json_files_have_every_fall(stdout_of, tmp_path):
    path = tmp_path / "falls.json"
    stdout_of(f"topple -n 20 --seed 1 --release let-go -o {path}")
    read = json.loads(path.read_text())
    falls = rr.topple(CAN, rr.NoSlip(), 20, "let_go", seed=1)
    assert read["falls"]["turn"] == falls["turn"].values.tolist()
    assert read["falls"]["outcome"] == falls["outcome"].values.tolist()
    assert read["units"]["turn"] == "rad" and read["parameters"]["seed"] == 1


@pytest.mark.parametrize("suffix", ["svg", "png", "pdf"])
def test_topple_draws_the_histogram(stdout_of, tmp_path, suffix):
    path = tmp_path / f"falls.{suffix}"
    stdout_of(f"topple --seed 1 -o {path}")
    assert path.read_bytes()[:4] in (b"<?xm", b"\x89PNG", b"%PDF")


@pytest.mark.parametrize("threads", [1, 2])
@pytest.mark.parametrize("asked_for", ["", "--json"])
def test_ctrl_c_writes_the_falls_done_so_far_and_says_so(
    capsys, tmp_path, monkeypatch, asked_for, threads
):
    from contextlib import contextmanager

    @contextmanager
    def impatient(title):
        def bar(done, total, what):
            if done:
                raise KeyboardInterrupt

        yield bar

    monkeypatch.setattr("rimroll.cli.topple.working", impatient)
    csv, picture = tmp_path / "falls.csv", tmp_path / "falls.svg"
    command = f"topple -n 300000 --seed 1 --threads {threads} -o {csv} -o {picture} {asked_for}"
    assert main(command.split()) == 130
    captured = capsys.readouterr()
    line = '{"error": "interrupted"}' if asked_for else "rimroll: interrupted"
    assert captured.err == f"{line}\n"
    lines = csv.read_text().splitlines()
    rows = sum(not line.startswith("# ") for line in lines) - 1
    assert 0 < rows < 300_000
    assert f"# interrupted = after {rows} of 300000 falls" in lines
    assert f"after {rows} of 300000 falls" in captured.out and picture.exists()
    assert asked_for or f"wrote {csv}: a part, {rows} falls" in captured.out
    assert {path.name for path in tmp_path.iterdir()} == {"falls.csv", "falls.svg"}


def test_ctrl_c_before_the_first_fall_says_nothing_of_directions(capsys, monkeypatch):
    none = rr.topple(CAN, rr.NoSlip(), 1, seed=1).isel(trial=slice(0))

    def interrupted(*given, **options):
        raise rr.Interrupted(none)

    monkeypatch.setattr("rimroll.cli.topple.let_go", interrupted)
    assert main(["topple", "-n", "5", "--seed", "1"]) == 130
    out = capsys.readouterr().out
    assert "\n0 falls; seed 1\n" in out and "interrupted after 0 of 5 falls" in out
    assert "No body came down" not in out and "limit" not in out


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ("--release throw", "unknown release 'throw'"),
        ("-n 0", "--number must be a whole number >= 1"),
        ("--seed -1", "seed must be a whole number >= 0"),
        ("--tilt 20", "for degrees write 20deg"),
        ("--tilt 95deg", "--tilt must be inside (0, pi/2)"),
        ("--twist-spread -1deg/s", "--twist-spread must be finite and >= 0"),
        ("--sideways 3kg", '--sideways must be an angular rate such as "-30 deg/s"'),
        ("--friction-scale-spread 1deg", "--friction-scale-spread must be a pure number"),
        ("--unsteadiness -1", "--unsteadiness must be >= 0"),
        ("--threads 0", "threads must be a whole number >= 1"),
        ("-o falls.gif", "its suffix must be one of .csv, .nc, .json, .png, .svg, .pdf"),
        ("no_such_body", "unknown body 'no_such_body'"),
    ],
)
def test_bad_input_is_one_line_and_exit_code_2(capsys, arguments, words):
    assert main(f"topple {arguments}".split()) == 2
    captured = capsys.readouterr()
    assert words in captured.err and captured.err.count("\n") == 1 and captured.out == ""


def test_all_falls_failing_is_exit_code_1(capsys):
    assert main(["topple", "-n", "3", "--max-steps", "2", "--seed", "1"]) == 1
    assert "3 failed" in capsys.readouterr().out


def test_help_has_examples_that_work(stdout_of, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "100")
    lines = stdout_of("topple --help").splitlines()
    examples = [line.split("$ rimroll ")[1] for line in lines if "$ rimroll topple" in line]
    assert len(examples) == 4
    for example in examples:
        assert "falls" in stdout_of(example)
    assert (tmp_path / "falls.csv").exists()


@pytest.mark.parametrize("gravity", ["-1", "0", "nan"])
@pytest.mark.parametrize("command", ["topple", "map"])
def test_gravity_that_is_none_is_refused_in_a_line(command, gravity, capsys):
    with pytest.raises(rr.RimrollError, match="gravity must be > 0 and finite"):
        rr.Release.named("let_go", CAN, float(gravity))
    assert main([command, "--gravity", gravity]) == 2
    assert "gravity" in capsys.readouterr().err


def test_a_full_disk_gives_one_line_for_every_format(tmp_path, monkeypatch, capsys):
    def full(*_: object) -> int:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(Path, "write_bytes", full)
    for suffix in ("pdf", "svg", "png"):
        assert main(["topple", "-n", "8", "--seed", "1", "-o", str(tmp_path / f"x.{suffix}")]) == 2
        assert "No space left on device" in capsys.readouterr().err
    assert not list(tmp_path.iterdir())
