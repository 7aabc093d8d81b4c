"""Builds the source distribution and the wheel of rimroll-score into score/dist, and checks them.

The wheel is tried where dist has a wheel of rimroll for this machine. Needs .venv.
"""

import platform
import shutil
import subprocess
import sys
import tarfile
import zipfile
from pathlib import Path

ROOT = Path(__file__).parents[1]
DIST = ROOT / "score/dist"
UV = ROOT / ".venv/bin/uv"
KILOBYTE = 1e3
LARGEST = 90.0
"""The size that a file may have at most, in kB."""
LICENCES = {"LICENSE-MIT", "LICENSE-APACHE"}
TRY = "score rimroll --dt 2e-3 --cases rolling_near --max-error 1deg --max-energy 1%"


class Failed(Exception):
    """A command failed, or a file is not as it must be."""


def run(*command: str | Path, cwd: Path = ROOT) -> None:
    """Runs a command. Raises Failed, and shows its output, if it fails."""
    result = subprocess.run(
        command, cwd=cwd, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True
    )
    if result.returncode:
        print(result.stdout, file=sys.stderr)
        raise Failed(" ".join(map(str, command[:3])))


def build() -> list[Path]:
    """Writes both files, with the tools of constraints.txt."""
    shutil.rmtree(DIST, ignore_errors=True)
    pins = ("--build-constraints", ROOT / "constraints.txt")
    run(UV, "build", "--quiet", *pins, "--out-dir", DIST, ROOT / "score")
    (DIST / ".gitignore").unlink(missing_ok=True)  # what uv writes is no file of a release
    return sorted(DIST.iterdir())


def names(file: Path) -> set[str]:
    """The names, without folders, of what a wheel or source distribution holds."""
    if file.suffix == ".whl":
        with zipfile.ZipFile(file) as wheel:
            held = wheel.namelist()
    else:
        with tarfile.open(file) as source:
            held = source.getnames()
    return {Path(name).name for name in held}


def check(file: Path) -> None:
    """Raises Failed if a file is too large or lacks a licence or the cases."""
    size = file.stat().st_size / KILOBYTE
    if size > LARGEST:
        raise Failed(f"{file.name} has {size:.0f} kB, more than {LARGEST:g}")
    if missing := (LICENCES | {"cases.toml", "page.html"}) - names(file):
        raise Failed(f"{file.name} lacks {', '.join(sorted(missing))}")


def tried(wheel: Path) -> str:
    """What came of trying the wheel beside one of rimroll, in words."""
    fits = list((ROOT / "dist").glob(f"rimroll-*manylinux*_{platform.machine()}.whl"))
    if platform.system() != "Linux" or not fits:
        return "not tried: needs a wheel of rimroll for this machine in dist (make wheels)"
    place = ROOT / "target/wheels/score"
    shutil.rmtree(place, ignore_errors=True)
    run(sys.executable, "-m", "venv", place)
    python = place / "bin/python"
    run(UV, "pip", "install", "--quiet", "--python", python, *fits, wheel)
    run(place / "bin/rimroll", *TRY.split(), cwd=place)
    if not (place / "scorecard/index.html").is_file():
        raise Failed("rimroll score wrote no page")
    return "works"


def main() -> int:
    """Builds, checks and tries; 1 if something failed."""
    try:
        files = build()
        for file in files:
            check(file)
        run(sys.executable, "tools/paths_in_wheels.py", *files)
        (wheel,) = (file for file in files if file.suffix == ".whl")
        came = tried(wheel)
    except Failed as error:
        print(f"FAILED: {error}")
        return 1
    sizes = ", ".join(f"{file.name} {file.stat().st_size / KILOBYTE:.0f} kB" for file in files)
    print(f"{sizes}: {came}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
