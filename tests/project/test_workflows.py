"""The workflows of .github call what exists, at the versions that the project itself names."""

import json
import os
import re
import runpy
import shutil
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
WORKFLOWS = sorted((ROOT / ".github").glob("workflows/*.yml"))
STEPS = [*WORKFLOWS, *sorted((ROOT / ".github").glob("actions/*/action.yml"))]
TEXTS = {path: path.read_text("utf-8") for path in STEPS}

each_workflow = pytest.mark.parametrize("path", WORKFLOWS, ids=lambda path: path.stem)
each_file = pytest.mark.parametrize("path", STEPS, ids=lambda path: path.parent.name + path.stem)


def toml(name):
    return tomllib.loads((ROOT / name).read_text("utf-8"))


def jobs(text):
    """The text of each job by its name."""
    _, below = text.split("\njobs:\n")
    found = re.split(r"^  ([a-z-]+):\n", below, flags=re.M)
    return dict(zip(found[1::2], found[2::2], strict=True))


@each_file
def test_the_make_targets_of_a_workflow_exist(path):
    makefile = (ROOT / "Makefile").read_text("utf-8")
    called = re.findall(r"(?:run: |^ +)make ([a-z ]+)$", TEXTS[path], re.M)
    for target in " ".join(called).split():
        assert re.search(rf"^{target}:", makefile, re.M), target


@each_file
def test_the_files_that_a_workflow_runs_exist(path):
    for name in re.findall(r"\b(?:tools|tests)/[\w./-]+", TEXTS[path]):
        assert (ROOT / name).exists(), name
    for name in re.findall(r"uses: (\./\S+)", TEXTS[path]):
        assert (ROOT / name).exists(), name


@each_file
def test_actions_of_others_are_pinned_by_commit_with_their_version_beside(path):
    for action in re.findall(r"uses: (?!\./)(.*)", TEXTS[path]):
        assert re.fullmatch(r"[\w.-]+(/[\w.-]+)+@[0-9a-f]{40} # v\d+(\.\d+)*", action), action


def test_an_action_has_one_version_everywhere():
    pins = re.findall(r"uses: (\S+)@(\S+)", "".join(TEXTS.values()))
    assert len(dict(pins)) == len(set(pins))


@each_workflow
def test_a_workflow_asks_for_few_rights_and_ends(path):
    text = TEXTS[path]
    assert re.search(r"^permissions:( \{\}|\n  contents: read)\n", text, re.M)
    assert re.search(r"^concurrency:\n", text, re.M)
    for name, job in jobs(text).items():
        assert "timeout-minutes: " in job or "uses: ./.github/workflows/" in job, name
    assert text.count("actions/checkout@") == text.count("persist-credentials: false")


def test_the_check_that_a_branch_requires_waits_for_all_others():
    found = jobs(TEXTS[ROOT / ".github/workflows/checks.yml"])
    needs = re.search(r"needs: \[(.*)\]", found.pop("passed"))
    assert set(needs[1].split(", ")) == set(found)


@pytest.mark.skipif(not shutil.which("jq"), reason="jq is missing")
@pytest.mark.parametrize(
    ("results", "passes"),
    [
        ({"all": "success", "soak": "success"}, True),
        ({"all": "success", "soak": "skipped"}, True),
        ({"all": "success", "soak": "failure"}, False),
        ({"all": "success", "soak": "cancelled"}, False),
        ({"all": "skipped", "soak": "success"}, False),
        ({"all": "failure", "soak": "skipped"}, False),
    ],
)
def test_the_check_that_a_branch_requires_lets_only_soak_be_skipped(results, passes):
    passed = jobs(TEXTS[ROOT / ".github/workflows/checks.yml"])["passed"]
    expression = re.search(r"jq --exit-status '(.*?)'", passed, re.S)[1]
    needs = json.dumps({job: {"result": result} for job, result in results.items()})
    run = subprocess.run(
        ["jq", "--exit-status", expression], input=needs, capture_output=True, text=True
    )
    assert (run.returncode, run.stdout) == ((0, "true\n") if passes else (1, "false\n"))


def test_soak_runs_every_week_and_before_a_release():
    checks = TEXTS[ROOT / ".github/workflows/checks.yml"]
    assert "\n  schedule:\n" in checks
    soak = jobs(checks)["soak"]
    assert "if: github.event_name == 'schedule' || inputs.soak\n" in soak
    assert "run: make soak\n" in soak
    release = jobs(TEXTS[ROOT / ".github/workflows/release.yml"])
    assert "checks.yml\n    with:\n      soak: true\n" in release["checks"]


def test_only_the_documentation_of_main_is_published():
    deploy = jobs(TEXTS[ROOT / ".github/workflows/docs.yml"])["deploy"]
    assert "if: github.ref == 'refs/heads/main'\n" in deploy
    assert "run: make docs\n" in jobs(TEXTS[ROOT / ".github/workflows/checks.yml"])["site"]


def test_every_wheel_is_built_and_tried():
    """`make wheels` tries the source distribution itself."""
    wheels = TEXTS[ROOT / ".github/workflows/wheels.yml"]
    builds = set(runpy.run_path(str(ROOT / "tools/build_wheels.py"))["BUILDS"])
    on_linux = re.search(r'WHEELS="([^"]*)"', wheels)[1].split()
    elsewhere = re.findall(r"- \{ name: ([\w-]+),", wheels)
    assert sorted([*on_linux, *elsewhere]) == sorted(builds)
    tried = re.findall(r"- \{ wheel: ([\w-]+),|^    name: try (\w+)$", wheels, re.M)
    assert {name for names in tried for name in names if name} == builds - {"sdist"}


def test_caches_lie_where_the_tools_of_each_system_keep_them():
    """On Windows they are in no folder that can be named by ~."""
    prepare = TEXTS[ROOT / ".github/actions/prepare/action.yml"]
    assert "uv cache dir" in prepare and "npm config get cache" in prepare
    assert "~/" not in prepare


def test_the_interface_is_compared_with_that_of_the_release_before(tmp_path):
    """Also on the commit of a release, which has a tag itself."""
    (tmp_path / "tools").mkdir()
    shutil.copy(ROOT / "tools/semver.sh", tmp_path / "tools")
    (tmp_path / "bin").mkdir()
    (tmp_path / "bin/cargo").write_text('#!/bin/sh\necho "$@"\n')
    (tmp_path / "bin/cargo").chmod(0o755)

    def git(*arguments):
        own = ["-c", "user.name=x", "-c", "user.email=x", "-c", "commit.gpgsign=false"]
        subprocess.run(["git", *own, *arguments], cwd=tmp_path, check=True, capture_output=True)

    def compared():
        run = subprocess.run(
            ["/bin/sh", tmp_path / "tools/semver.sh"],
            env={"PATH": f"{tmp_path / 'bin'}{os.pathsep}{os.environ['PATH']}"},
            capture_output=True,
            text=True,
            check=True,
        )
        found = re.search(r"--baseline-rev (\S+)", run.stdout)
        return found and found[1]

    git("init")
    git("commit", "--allow-empty", "--message", "first")
    git("-c", "tag.gpgsign=false", "tag", "v0.1.0")
    assert compared() is None
    git("commit", "--allow-empty", "--message", "second")
    assert compared() == "v0.1.0"
    git("-c", "tag.gpgsign=false", "tag", "v0.2.0")
    assert compared() == "v0.1.0"


def test_nothing_that_is_released_comes_from_a_cache():
    wheels = TEXTS[ROOT / ".github/workflows/wheels.yml"]
    assert not re.search(r"rust-cache|actions/cache|  cache: |actions/prepare|sccache", wheels)


def test_python_is_tried_at_the_oldest_and_the_newest_version_that_the_package_names():
    project = toml("pyproject.toml")["project"]
    oldest = project["requires-python"].removeprefix(">=")
    minor = "Programming Language :: Python :: 3."
    classified = [c.rsplit(" ", 1)[1] for c in project["classifiers"] if c.startswith(minor)]
    newest = max(classified, key=lambda version: int(version.split(".")[1]))
    for name in "checks.yml", "wheels.yml":
        text = TEXTS[ROOT / ".github/workflows" / name]
        assert set(re.findall(r'python(?:-version)?: "(3[\d.]+)"', text)) == {oldest, newest}, name
    assert classified[0] == oldest
    # The other places that hold the oldest Python.
    tools = toml("pyproject.toml")["tool"]
    assert tools["mypy"]["python_version"] == oldest
    features = toml("crates/rimroll-py/Cargo.toml")["dependencies"]["pyo3"]["features"]
    assert f"abi3-py{oldest.replace('.', '')}" in features
    assert f"Python ≥ {oldest}" in (ROOT / "README.md").read_text("utf-8")
    header = (ROOT / "constraints.txt").read_text("utf-8")
    assert f"for Python {oldest} to {newest}." in header
    assert f"--python-version {oldest} " in (ROOT / "CONTRIBUTING.md").read_text("utf-8")


def test_wheels_are_built_by_the_maturin_that_is_tested():
    pins = (ROOT / "constraints.txt").read_text("utf-8")
    tested = re.search(r"^maturin==(.*)$", pins, re.M)[1]
    wheels = TEXTS[ROOT / ".github/workflows/wheels.yml"]
    assert set(re.findall(r"maturin-version: (\S+)", wheels)) == {f"v{tested}"}
    assert wheels.count("PyO3/maturin-action@") == wheels.count("maturin-version: ")


def test_the_oldest_rust_is_that_of_the_manifest(tmp_path):
    """tools/oldest_rust.sh reads it, so that no workflow repeats it."""
    oldest = toml("Cargo.toml")["workspace"]["package"]["rust-version"]
    for tool in "rustup", "cargo":
        (tmp_path / tool).write_text(f'#!/bin/sh\necho {tool} "$@"\n')
        (tmp_path / tool).chmod(0o755)
    for tool in "sed", "dirname":
        (tmp_path / tool).symlink_to(shutil.which(tool))
    run = subprocess.run(
        ["/bin/sh", ROOT / "tools/oldest_rust.sh"],
        env={"PATH": str(tmp_path)},
        capture_output=True,
        text=True,
        check=True,
    )
    assert f"rustup toolchain install {oldest} " in run.stdout
    assert f"cargo +{oldest} check" in run.stdout
    assert not any(oldest in text for text in TEXTS.values())
    assert f"(≥ {oldest}," in (ROOT / "README.md").read_text("utf-8")


def test_what_is_published_is_published_by_an_environment_of_its_own():
    """Owners can ask for an approval of each, and registries trust only these."""
    release = jobs(TEXTS[ROOT / ".github/workflows/release.yml"])
    environments = {
        "pypi": "pypi", "score": "pypi-score", "rehearsal": "testpypi", "crate": "crates-io",
    }  # fmt: skip
    for job, environment in environments.items():
        assert f"environment:\n      name: {environment}\n" in release[job]
        assert "id-token: write" in release[job]
    # A rehearsal publishes nothing: all else waits for the attestation, which only a tag gets.
    assert "if: github.event_name == 'push'" in release["attest"]
    for job in "pypi", "crate":
        assert "needs: attest\n" in release[job]
    assert "needs: pypi " in release["score"]  # it asks for rimroll of its own version
    assert "needs: [pypi, score, crate]\n" in release["github"]
    # Both packages are rehearsed and attested.
    for job in "attest", "rehearsal", "github":
        assert "pattern: dist-*\n" in release[job] and "name: score\n" in release[job], job


def test_the_page_about_releases_says_what_every_job_does():
    page = (ROOT / "docs/releasing.md").read_text("utf-8")
    _, table = page.split("| job of `release.yml` |")
    rows = re.findall(r"^\| (`.*?) \|", table.split("\n\n")[0], re.M)
    listed = {name for row in rows for name in re.findall(r"`(\w+)`", row)}
    release = jobs(TEXTS[ROOT / ".github/workflows/release.yml"])
    assert listed | {"rehearsal"} == set(release)


def test_the_smoke_test_passes_here_too():
    run = subprocess.run(
        [sys.executable, ROOT / "tools/smoke_test.py", "--without-page"],
        capture_output=True,
        text=True,
    )
    assert run.returncode == 0, run.stderr
    assert run.stdout.count("passed: ") == 4


def test_what_runs_before_a_commit_is_what_make_lint_runs():
    hooks = (ROOT / ".pre-commit-config.yaml").read_text("utf-8")
    tools = re.findall(r"entry: (?:\.venv/bin/|tools/node\.sh )?(\S+)", hooks)
    assert set(tools) == {"ruff", "cargo", "prettier", "typos", "zizmor"}
    makefile = (ROOT / "Makefile").read_text("utf-8")
    lint = re.search(r"^lint: .*\n((?:\t.*\n)+)", makefile, re.M)[1]
    for tool in tools:
        assert re.search(rf"\b{tool}\b", lint), tool
