"""Builds the source distribution and wheels into dist/, checks them, and tries what runs here.

Arguments name some of `BUILDS`; without arguments all are built, except those whose tools are
missing. The wheels are built from the unpacked source distribution. Needs .venv with the group
`wheels`, the page of the lab, and rustup, which has Rust's libraries for other systems.
"""

import os
import platform
import shutil
import subprocess
import sys
import tarfile
import time
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).parents[1]
DIST = ROOT / "dist"
WORK = ROOT / "target/wheels"
BIN = ROOT / ".venv/bin"
MEGABYTE = 1e6


@dataclass(frozen=True)
class Build:
    """One file of a release."""

    size: float
    """The size that it may have at most, in MB; a tenth more than measured."""
    target: str = ""
    """Rust's name of the system; none for the source distribution."""
    options: tuple[str, ...] = ()
    """Options of maturin. zig links for other systems, and for old versions of glibc."""
    way: str = ""
    """How tools/try_wheel.sh tries it on Linux on x86_64."""
    untried: str = ""
    """Why it is not tried there."""
    needs: str = ""
    """A command without which it cannot be built, and its package in Debian."""


MANYLINUX = ("--zig", "--compatibility", "manylinux2014")
MUSLLINUX = ("--zig", "--compatibility", "musllinux_1_2")
ALPINE = "needs a Python for musl, such as Alpine's"
BUILDS = {
    "sdist": Build(2.3, way="offline"),
    "manylinux-x86_64": Build(5.5, "x86_64-unknown-linux-gnu", MANYLINUX, way="here"),
    "manylinux-aarch64": Build(4.7, "aarch64-unknown-linux-gnu", MANYLINUX, way="arm64"),
    "musllinux-x86_64": Build(5.5, "x86_64-unknown-linux-musl", MUSLLINUX, untried=ALPINE),
    "musllinux-aarch64": Build(4.7, "aarch64-unknown-linux-musl", MUSLLINUX, untried=ALPINE),
    "pyodide": Build(4.0, "wasm32-unknown-emscripten", ("--interpreter", "3.14"), way="pyodide"),
    "macos-x86_64": Build(6.7, "x86_64-apple-darwin", ("--zig",), untried="needs macOS"),
    "macos-arm64": Build(5.8, "aarch64-apple-darwin", ("--zig",), untried="needs macOS"),
    # With zig, maturin asks for a symbol that no module in a package has: PyInit_rimroll._core.
    "windows-x86_64": Build(
        6.5,
        "x86_64-pc-windows-gnu",
        untried="needs Windows",
        needs="x86_64-w64-mingw32-gcc gcc-mingw-w64-x86-64-win32",
    ),
}

ENVIRONMENT = os.environ | {
    "VIRTUAL_ENV": str(ROOT / ".venv"),
    "PATH": f"{BIN}{os.pathsep}{os.environ['PATH']}",
    # The binary interface of the Pyodide for which the wheel is (PEP 783), and what links it.
    "MATURIN_PYEMSCRIPTEN_PLATFORM_VERSION": "2026_0",
    "CARGO_TARGET_WASM32_UNKNOWN_EMSCRIPTEN_LINKER": str(ROOT / "tools/pyodide_linker.py"),
    "CARGO_TARGET_DIR": os.environ.get("CARGO_TARGET_DIR", str(ROOT / "target")),
}
ENVIRONMENT.pop("CONDA_PREFIX", None)


class Failed(Exception):
    """A command failed, or a file is not as it must be."""


def run(*command: str | Path, cwd: Path = ROOT, **more: str) -> None:
    """Runs a command. Raises Failed, and shows the last lines of its output, if it fails."""
    try:
        result = subprocess.run(
            command,
            cwd=cwd,
            env=ENVIRONMENT | more,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
        )
    except FileNotFoundError:
        raise Failed(f"{command[0]} is missing") from None
    if result.returncode:
        print("\n".join(result.stdout.splitlines()[-30:]), file=sys.stderr)
        raise Failed(" ".join(map(str, command[:3])))


def write_sdist() -> Path:
    """The source distribution of the files that git knows and of the page, with PyPI's README."""
    tree = WORK / "tree"
    shutil.rmtree(tree, ignore_errors=True)
    listed = subprocess.run(
        ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
        cwd=ROOT,
        check=True,
        stdout=subprocess.PIPE,
        text=True,
    ).stdout
    for name in listed.rstrip("\0").split("\0"):
        if (ROOT / name).is_file():
            (tree / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / name, tree / name)
    shutil.copytree(ROOT / "python/rimroll/page", tree / "python/rimroll/page")
    run("git", "init", "--quiet", tree)  # so that what git ignores in ROOT is not ignored there
    run(sys.executable, tree / "tools/readme_for_pypi.py")
    for old in WORK.glob("*.tar.gz"):
        old.unlink()
    run("maturin", "sdist", "--out", WORK, cwd=tree)
    shutil.rmtree(tree)
    (sdist,) = WORK.glob("*.tar.gz")
    return sdist


def unpacked(sdist: Path) -> Path:
    """The tree that a source distribution contains."""
    tree = WORK / sdist.name.removesuffix(".tar.gz")
    shutil.rmtree(tree, ignore_errors=True)
    with tarfile.open(sdist) as archive:
        archive.extractall(WORK, filter="data")
    for file in tree.rglob("*"):
        file.touch()  # its files have one old time, and cargo compiles what is newer
    run("cargo", "fetch", "--locked", cwd=tree)
    return tree


def write_wheel(build: Build, tree: Path) -> None:
    """The wheel of a system, in which no path of this machine stays."""
    run("rustup", "target", "add", build.target)
    shown = {tree: "rimroll", Path.home(): "home"}
    flags = [f"--remap-path-prefix={path}={name}" for path, name in shown.items()]
    run(
        "maturin",
        *("build", "--release", "--locked", "--target", build.target),
        *(*build.options, "--out", DIST),
        cwd=tree,
        CARGO_ENCODED_RUSTFLAGS="\x1f".join(flags),
    )


def tried(build: Build, file: Path) -> str:
    """What came of trying a file, in words."""
    if build.untried:
        return f"not tried: {build.untried}"
    if (platform.system(), platform.machine()) != ("Linux", "x86_64"):
        return "not tried: needs Linux on x86_64"
    if build.way == "arm64" and platform.freedesktop_os_release()["ID"] != "debian":
        return "not tried: needs Debian, for an emulator"
    run("tools/try_wheel.sh", build.way, file)
    return "works"


def made(build: Build, sdist: Path, tree: Path) -> str:
    """Builds, checks and tries one file in DIST. What came of it, in words."""
    before = set(DIST.iterdir())
    if build.target:
        write_wheel(build, tree)
    else:
        shutil.copy(sdist, DIST)
    (file,) = set(DIST.iterdir()) - before
    size = file.stat().st_size / MEGABYTE
    if size > build.size:
        raise Failed(f"{file.name} has {size:.2f} MB, more than {build.size}")
    run(sys.executable, "tools/paths_in_wheels.py", file)
    return f"{size:.2f} MB of {build.size}, {tried(build, file)}"


def main(names: list[str]) -> int:
    """Builds some files, or all that can be built here; 1 if one failed."""
    if unknown := set(names) - set(BUILDS):
        print(f"rimroll: unknown: {', '.join(unknown)}; choose from {', '.join(BUILDS)}")
        return 2
    shutil.rmtree(DIST, ignore_errors=True)
    DIST.mkdir()
    try:
        sdist = write_sdist()
        tree = unpacked(sdist)
    except Failed as error:
        print(f"FAILED: {error}")
        return 1
    failed = False
    for name in names or BUILDS:
        build, start = BUILDS[name], time.monotonic()
        command, _, package = build.needs.partition(" ")
        if not names and command and not shutil.which(command):
            came = f"not built: needs {command} (on Debian or Ubuntu: apt install {package})"
        else:
            try:
                came = made(build, sdist, tree)
            except Failed as error:
                failed, came = True, f"FAILED: {error}"
        print(f"{name:<17} {time.monotonic() - start:4.0f} s  {came}", flush=True)
    return int(failed)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
