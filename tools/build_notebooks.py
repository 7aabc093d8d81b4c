"""Adds JupyterLite to a documentation site, so that the notebooks run in the page.

Run as: build_notebooks.py PYODIDE WHEEL SITE. PYODIDE is the folder or the address of a full
distribution of Pyodide, WHEEL that of rimroll for it. The site gets its own copy of the packages
that a notebook loads, and a reader's browser asks no other host for anything.
"""

import hashlib
import json
import shutil
import subprocess
import sys
import zipfile
from email.parser import Parser
from pathlib import Path
from urllib.request import urlopen

from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

ROOT = Path(__file__).parents[1]
WORK = ROOT / "out/docs-work/notebooks"
LOCK = "pyodide-lock.json"
CORE = "pyodide.mjs", "pyodide.asm.mjs", "pyodide.asm.wasm", "python_stdlib.zip"
# What a notebook loads: rimroll, and what the kernel of JupyterLite itself needs.
ROOTS = "rimroll", "ipython", "jedi", "comm", "micropip"
PAGES = "lab", "notebooks"  # of JupyterLite


def read(source, name):
    """A file of Pyodide, from a folder or an address."""
    if source.startswith("https://"):
        with urlopen(f"{source.rstrip('/')}/{name}") as answer:
            return answer.read()
    return (Path(source) / name).read_bytes()


def metadata(wheel):
    """What a wheel says about itself."""
    with zipfile.ZipFile(wheel) as archive:
        (name,) = (name for name in archive.namelist() if name.endswith(".dist-info/METADATA"))
        return Parser().parsestr(archive.read(name).decode())


def required(wheel):
    """The packages that a wheel requires in Pyodide, without extras."""
    place = {"extra": "", "sys_platform": "emscripten", "platform_system": "Emscripten"}
    found = map(Requirement, metadata(wheel).get_all("Requires-Dist", []))
    return {
        canonicalize_name(requirement.name)
        for requirement in found
        if requirement.marker is None or requirement.marker.evaluate(place)
    }


def imported(wheel):
    """The names by which Python imports what a wheel contains."""
    with zipfile.ZipFile(wheel) as archive:
        tops = {name.split("/")[0] for name in archive.namelist() if name.endswith(".py")}
    return sorted(name.removesuffix(".py") for name in tops if "." not in name.removesuffix(".py"))


def locked(wheel):
    """The entry of a wheel in the lock file, by which Pyodide finds and loads it."""
    said = metadata(wheel)
    return {
        "name": canonicalize_name(said["Name"]),
        "version": said["Version"],
        "file_name": wheel.name,
        "install_dir": "site",
        "sha256": hashlib.sha256(wheel.read_bytes()).hexdigest(),
        "package_type": "package",
        "imports": imported(wheel),
        "depends": sorted(required(wheel)),
        "unvendored_tests": False,
    }


def fetch_missing(packages, folder):
    """Adds to a folder the wheels from PyPI that its wheels require and Pyodide lacks."""
    have = set(packages) | {"rimroll"}
    wanted = {"comm"}.union(*map(required, folder.glob("*.whl")))
    while missing := wanted - have:
        have |= missing
        before = set(folder.glob("*.whl"))
        subprocess.run(
            [
                *(sys.executable, "-m", "pip", "download", "--quiet", "--no-deps"),
                *("--disable-pip-version-check", "--only-binary", ":all:", "--dest", folder),
                *("--constraint", ROOT / "constraints.txt", *sorted(missing)),
            ],
            check=True,
        )
        wanted = wanted.union(*map(required, set(folder.glob("*.whl")) - before))


def closure(packages, names):
    """These packages and all that they depend on."""
    found, left = {}, list(names)
    while left:
        name = canonicalize_name(left.pop())
        if name not in found:
            found[name] = packages[name]
            left += packages[name]["depends"]
    return found


def write_pyodide(source, wheel, folder):
    """Pyodide with rimroll and what it requires, and nothing else."""
    folder.mkdir(parents=True)
    lock = json.loads(read(source, LOCK))
    shutil.copy(wheel, folder)
    fetch_missing(lock["packages"], folder)
    added = {entry["name"]: entry for entry in map(locked, folder.glob("*.whl"))}
    lock["packages"] = closure(lock["packages"] | added, ROOTS)
    for package in lock["packages"].values():
        file = folder / package["file_name"]
        if not file.exists():
            file.write_bytes(read(source, file.name))
        if hashlib.sha256(file.read_bytes()).hexdigest() != package["sha256"]:
            raise SystemExit(f"rimroll: {file.name} is not the file that {LOCK} names")
    for name in CORE:
        (folder / name).write_bytes(read(source, name))
    (folder / LOCK).write_text(json.dumps(lock))


def write_contents(folder):
    """The notebooks, and the files that they read."""
    folder.mkdir(parents=True)
    for notebook in (ROOT / "examples").glob("*.ipynb"):
        shutil.copy(notebook, folder)


def main(source, wheel, site):
    shutil.rmtree(WORK, ignore_errors=True)
    write_pyodide(source, wheel, WORK / "static/pyodide")
    write_contents(WORK / "contents")
    kernel = {"disablePyPIFallback": True}
    settings = {"litePluginSettings": {"@jupyterlite/pyodide-kernel-extension:kernel": kernel}}
    (WORK / "jupyter-lite.json").write_text(
        json.dumps({"jupyter-lite-schema-version": 0, "jupyter-config-data": settings})
    )
    output = Path(site).resolve() / "notebooks"
    shutil.rmtree(output, ignore_errors=True)
    subprocess.run(
        [
            *(Path(sys.executable).with_name("jupyter"), "lite", "build", "--no-sourcemaps"),
            *("--lite-dir", WORK, "--contents", WORK / "contents", "--output-dir", output),
            *(argument for page in PAGES for argument in ("--apps", page)),
        ],
        cwd=WORK,
        check=True,
    )


if __name__ == "__main__":
    main(*sys.argv[1:])
