"""One sentence says how an engine went wrong, and the next run goes on."""

import re
import sys
import tomllib
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from rimroll.cli import main
from rimroll_score import worker as worker_module
from rimroll_score.cases import cases
from rimroll_score.checks import check, lifted
from rimroll_score.environments import PINS, NotInstalled, advice, installed
from rimroll_score.protocol import State
from rimroll_score.registry import NoAdapter, engines, located
from rimroll_score.samples import BadSample, Recorder
from rimroll_score.scoring import Missing, Plan, Unknown, score
from rimroll_score.sweep import sweep, task
from rimroll_score.worker import Worker

FAKES = Path(__file__).with_name("fakes.py")
CASE = next(case for case in cases() if case.name == "rolling_near")
TASK = task(CASE.scene, CASE.state, 0.1, 0.01, "defaults")


def fake(name):
    return f"{FAKES}:{name}"


@pytest.mark.parametrize(
    ("name", "status", "says"),
    [
        ("Raises", "raised", "RuntimeError: the solver diverged"),
        ("Dies", "crashed", "ended with code 7: terminate called"),
        ("ReturnsNaN", "invalid", "position is not finite at t = 0.03 s"),
        ("WrongShape", "invalid", r"position has shape \(4,\) at t = 0 s; it must be \(3,\)"),
        ("NoRotation", "invalid", "rotation is no rotation matrix at t = 0 s"),
        ("SlowClock", "invalid", "the engine's clock shows 0.005 s at t = 0.01 s"),
        ("NoTable", "unsupported", "it has no table"),
        ("NoSuchClass", "raised", "NoSuchClass"),
        ("NoState", "raised", "AttributeError: .* has no attribute 'position'"),
        ("TellsNoDepartures", "raised", "TypeError: 'NoneType' object is not iterable"),
        ("TellsNumbers", "crashed", "Object of type ndarray is not JSON serializable"),
        ("Incomplete", "raised", "AttributeError: .* has no attribute 'make'"),
    ],
)
def test_what_goes_wrong_is_told(name, status, says):
    with Worker(fake(name)) as worker:
        outcome = worker.run(TASK)
    assert outcome.status == status
    assert outcome.samples is None
    assert re.search(says, outcome.message)


def test_an_engine_that_hangs_is_stopped_and_started_again():
    with Worker(fake("Hangs"), limit=0.3) as worker:
        for _ in range(2):
            outcome = worker.run(TASK)
            assert (outcome.status, outcome.message) == ("too_slow", "no answer within 0.3 s")


def test_an_engine_that_hangs_before_it_tells_its_version_is_stopped(monkeypatch):
    monkeypatch.setattr(worker_module, "START_LIMIT", 0.3)
    with pytest.raises(Missing, match=r"HangsAtFirst cannot be loaded: no answer within 0\.3 s$"):
        score(fake("HangsAtFirst"), Plan(), "")


def test_an_engine_that_dies_between_two_runs_is_told_and_started_again():
    with Worker(fake("Still")) as worker:
        assert worker.run(TASK).status == "ok"
        worker._process.kill()
        worker._process.wait()
        outcome = worker.run(TASK)
        assert outcome.status == "crashed"
        assert re.fullmatch("its process ended with code -?[0-9]+", outcome.message)
        assert worker.run(TASK).status == "ok"


def test_an_engine_that_is_not_installed_is_told_with_the_line_that_installs_it():
    assert advice("mujoco") == "add --install, or pip install mujoco==4.0.0"
    assert advice("mine") == "install it beside rimroll-score"


def test_an_adapter_file_that_is_not_there_is_told(tmp_path):
    with pytest.raises(Missing, match=r"cannot be loaded: FileNotFoundError.*none.py'$"):
        score(f"{tmp_path / 'none.py'}:Engine", Plan(), "")


def test_an_environment_that_cannot_be_made_is_told_by_the_end_of_what_pip_says(
    monkeypatch, tmp_path
):
    monkeypatch.setenv("RIMROLL_ENGINES", str(tmp_path))
    monkeypatch.setitem(PINS, "broken", ["no such requirement"])
    with pytest.raises(NotInstalled, match=r"(?i)no such requirement|invalid requirement"):
        installed("broken")


@pytest.mark.parametrize("text", ["", "[]", "{}", '{"format": 1, "engines": {}}'])
def test_a_file_of_results_in_another_format_is_refused(text, tmp_path, capsys):
    (tmp_path / "results.json").write_text(text, "utf-8")
    fake_still = ["score", fake("Still"), "--cases", "flight", "--dt", "1e-2", "--no-checks"]
    assert main([*fake_still, "-o", str(tmp_path)]) == 2
    assert "results.json is not a file of results in format 2" in capsys.readouterr().err
    assert (tmp_path / "results.json").read_text("utf-8") == text


def test_an_engine_that_is_not_installed_is_missing(tmp_path):
    adapter = tmp_path / "adapter.py"
    adapter.write_text("import no_such_engine\n")
    with Worker(f"{adapter}:Engine") as worker:
        assert worker.run(TASK).status == "missing"
    with pytest.raises(Missing, match="No module named 'no_such_engine'; install it"):
        score(f"{adapter}:Engine", Plan(), "")


def test_what_an_engine_prints_disturbs_nothing():
    with Worker(fake("Loud")) as worker:
        outcome = worker.run(TASK)
    assert outcome.status == "ok"
    assert outcome.departures == ("it never moves",)
    assert len(outcome.samples.time) == 11
    np.testing.assert_array_equal(outcome.samples.position[-1], CASE.state.position)


def test_no_window_can_open(monkeypatch, tmp_path):
    monkeypatch.setenv("DISPLAY", ":0")
    adapter = tmp_path / "adapter.py"
    adapter.write_text(
        "import os\nclass Asks:\n    settings, known_versions = {}, ''\n"
        "    def version(self): return os.environ.get('DISPLAY', 'none')\n"
    )
    with Worker(f"{adapter}:Asks") as worker:
        assert worker.describe()["version"] == "none"


@pytest.mark.skipif(sys.platform != "linux", reason="windows open without DISPLAY")
def test_an_engine_that_opens_a_window_is_told_instead(monkeypatch):
    pytest.importorskip("tkinter")
    monkeypatch.setenv("DISPLAY", ":0")
    with pytest.raises(Missing, match="cannot be loaded: TclError: no display name"):
        score(fake("OpensWindow"), Plan(), "")


def test_a_version_that_the_adapter_does_not_know_is_a_warning():
    with Worker(fake("OfTomorrow")) as worker:
        described = worker.describe()
    assert described["warning"] == "the adapter was written for version 0. or 0b, this is 1.0"


def test_too_few_samples_are_refused():
    recorder = Recorder(0.1)
    recorder.add(0.0, 0.0, CASE.state)
    with pytest.raises(BadSample, match="1 samples were returned instead of 3"):
        recorder.samples(3)


def test_states_are_copied_because_engines_may_overwrite_them():
    live = State(*(value.copy() for value in vars(CASE.state).values()))
    recorder = Recorder(0.1)
    recorder.add(0.0, 0.0, live)
    live.position[:] += 1.0
    recorder.add(0.1, 0.1, live)
    found = recorder.samples(2).position
    np.testing.assert_array_equal(found, np.add(CASE.state.position, [[0.0], [1.0]]))


def test_numbers_whose_energy_would_be_infinite_are_refused():
    huge = State(CASE.state.position * 1e200 + 1e200, *list(vars(CASE.state).values())[1:])
    with pytest.raises(BadSample, match="position is not finite"):
        Recorder(0.1).add(0.0, 0.0, huge)


@pytest.mark.parametrize(
    "options, says",
    [
        (["--time-limit", "-1 s"], "time-limit must be > 0"),
        (["--limit", "-1 s"], "time-limit must be > 0"),
        (["--install", "--python", "python3"], "give either --install"),
        (["--dt", "0"], "dt must be between 1e-7 and 0.1 s, got 0"),
        (["--dt", "1e-3,often"], "dt"),
        (["--repeats", "0"], "repeats must be at least 1, got 0"),
        (["--max-error", "small"], "--max-error must be an angle"),
        (["--max-energy", "1 J"], "--max-energy must be a pure number"),
        (["--cases", "wabble"], "no case is called 'wabble'"),
    ],
)
def test_options_that_make_no_sense_are_refused(options, says, capsys, tmp_path):
    assert main(["score", "rimroll", "-o", str(tmp_path), *options]) == 2
    assert says in capsys.readouterr().err


def test_a_bound_that_is_not_given_does_not_decide(capsys, tmp_path):
    fake_still = ["score", fake("Still"), "--cases", "flight", "--dt", "1e-2", "--no-checks"]
    assert main([*fake_still, "-o", str(tmp_path), "--max-energy", "1e9"]) == 0
    assert main([*fake_still, "-o", str(tmp_path), "--max-error", "1e-9deg"]) == 1


def test_the_workflow_of_the_documentation_fails_for_an_engine_that_is_wrong(tmp_path):
    page = (Path(__file__).parents[2] / "docs/physics-engines.md").read_text("utf-8")
    (line,) = re.findall(r"- run: rimroll (score my_engine .*)", page)
    words = [fake("Still") if word == "my_engine" else word for word in line.split()]
    assert main([*words, "--no-checks", "-o", str(tmp_path)]) == 1
    badge = (tmp_path / "Still.svg").read_text("utf-8")  # which the page names, too
    assert "my_engine.svg" in page and "right at no step tried" in badge


def test_after_a_step_that_took_too_long_no_finer_one_is_tried():
    with Worker(fake("Hangs"), limit=0.3) as worker:
        runs = sweep(worker, [CASE], (1e-2, 1e-3), ("defaults",))
    assert [(run.dt, run.status) for run in runs] == [(1e-2, "too_slow"), (1e-3, "too_slow")]


def test_a_table_is_moved_by_adapters_alone_that_say_they_do():
    with Worker(fake("Still")) as worker:
        outcome = worker.run(replace(TASK, scene=lifted(CASE).scene))
        table = {one.name: one for one in check(worker, CASE, 0.1, "defaults")}["table"]
    assert (outcome.status, outcome.message) == (
        "unsupported",
        "the adapter does not move the table",
    )
    assert (table.angle, table.note) == (None, outcome.message)
    with Worker(fake("OnTheGround")) as worker:
        outcome = worker.run(replace(TASK, scene=lifted(CASE).scene))
    assert outcome.message == "its ground is at rest"


def test_an_engine_that_is_not_deterministic_is_run_ten_times(tmp_path):
    plan = Plan(steps=(1e-2,), cases=("wobble",), check_step=None)
    (once,) = score(fake("Still"), plan, "").runs
    (ten,) = score(fake("Random"), plan, "").runs
    assert (once.repeats, once.differ) == (1, False)
    assert (ten.repeats, ten.differ) == (10, True)
    (asked,) = score(fake("Random"), replace(plan, repeats=2), "").runs
    assert asked.repeats == 2


def test_without_an_engine_those_that_have_an_adapter_are_listed(capsys):
    assert main(["score"]) == 0
    heading, *lines = capsys.readouterr().out.splitlines()
    assert heading.startswith("engines that have an adapter")
    assert [line.split()[0] for line in lines] == list(engines())


def test_an_unknown_engine_case_or_setting_is_told_with_those_that_there_are():
    with pytest.raises(NoAdapter, match=r"'mujocco'; there are .*your own as module:class"):
        located("mujocco")
    with pytest.raises(Unknown, match="no case is called 'wabble'; there are rolling_far"):
        score(fake("Still"), Plan(cases=("wabble",)), "")
    with pytest.raises(Unknown, match="no setting is called 'best'; there are defaults"):
        score(fake("Still"), Plan(settings=("best",)), "")


def test_adapters_are_classes_that_their_entry_points_name():
    file = Path(__file__).parents[1] / "pyproject.toml"
    places = tomllib.loads(file.read_text("utf-8"))["project"]["entry-points"]["rimroll.engines"]
    folder = file.parent / "src"
    for place in places.values():
        module, _, name = place.partition(":")
        text = (folder / (module.replace(".", "/") + ".py")).read_text("utf-8")
        assert f"class {name}:" in text
    assert set(engines()) >= set(places) or not engines()  # none if it is not installed


def test_the_last_sample_is_at_the_end_or_just_after_it():
    for dt in (2e-3, 3.3e-4, 7e-5):
        asked = task(CASE.scene, CASE.state, CASE.duration, dt, "defaults")
        end = asked.samples * asked.every * dt
        assert CASE.duration - 1e-9 <= end < CASE.duration + asked.every * dt
        assert asked.samples <= 2000
