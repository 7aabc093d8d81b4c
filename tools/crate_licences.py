"""Writes LICENSE-CRATES, the licences of the crates that are compiled into the Python extension.

Wheels contain it, as these licences ask. Run it again after a change of Cargo.lock.
"""

import json
import subprocess
from pathlib import Path

ROOT = Path(__file__).parents[1]
FILE = ROOT / "LICENSE-CRATES"
RULE = "\n" + "-" * 80 + "\n\n"


def cargo(*arguments: str) -> str:
    command = ["cargo", *arguments, "--locked"]
    return subprocess.run(command, cwd=ROOT, check=True, stdout=subprocess.PIPE, text=True).stdout


def crates() -> dict[str, Path]:
    """Name and version of each crate of others, and the folder of its source."""
    tree = ["--package=rimroll-py", "--target=all", "--edges=normal,no-proc-macro"]
    # A line is "libm v0.2.16"; " (*)" follows if it was there before.
    lines = cargo("tree", *tree, "--prefix=none").splitlines()
    compiled = {line.removesuffix(" (*)") for line in lines}
    packages = json.loads(cargo("metadata", "--format-version=1"))["packages"]
    return {
        f"{package['name']} {package['version']}": Path(package["manifest_path"]).parent
        for package in sorted(packages, key=lambda package: package["name"])
        if package["source"] and f"{package['name']} v{package['version']}" in compiled
    }


def licence(folder: Path) -> str:
    """The licence in a folder; the MIT licence if there is a choice."""
    found = sorted(path for path in folder.iterdir() if path.name.lower().startswith("licen"))
    chosen = next((path for path in found if "mit" in path.name.lower()), found[0])
    lines = chosen.read_text("utf-8").strip().splitlines()
    return "\n".join(line.rstrip() for line in lines) + "\n"


def text() -> str:
    rust = (ROOT / "web/licences/rust.txt").read_text("utf-8")
    parts = [f"{name}\n\n{licence(folder)}" for name, folder in crates().items()]
    return RULE.join([*parts, rust])


if __name__ == "__main__":
    FILE.write_text(text(), "utf-8", newline="\n")
