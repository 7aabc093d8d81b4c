"""Prints what the changelog says of a release, once every place agrees on its version and day.

`release_notes.py v0.1.0` is for the tag of that name; `release_notes.py --unreleased` prints what
the next release will bring.
"""

import re
import sys
import tomllib
from pathlib import Path

ROOT = Path(__file__).parents[1]


def section(changelog: str, heading: str) -> str | None:
    """What stands under a heading of the changelog, such as `[0.1.0] - 2026-01-31`."""
    found = re.search(
        rf"^## {re.escape(heading)}\n(.*?)(?=^## |^\[[^]]+\]: |\Z)", changelog, re.S | re.M
    )
    return found and found[1].strip()


def faults(tag: str, cargo: str, citation: str, changelog: str) -> list[str]:
    """What keeps a tag from being released; nothing if it can be."""
    found = []
    version = tomllib.loads(cargo)["workspace"]["package"]["version"]
    if tag != f"v{version}":
        found.append(f"Cargo.toml has version {version}, but the tag is {tag}")
    if f"\nversion: {version}\n" not in citation:
        found.append(f"CITATION.cff has another version than Cargo.toml, {version}")
    day = re.search(r"^date-released: (\d{4}-\d{2}-\d{2})$", citation, re.M)
    if not day:
        found.append("CITATION.cff has no line such as date-released: 2026-01-31")
    elif not section(changelog, f"[{version}] - {day[1]}"):
        found.append(f"CHANGELOG.md has nothing under ## [{version}] - {day[1]}")
    if section(changelog, "[Unreleased]"):
        found.append("CHANGELOG.md still has changes under ## [Unreleased]")
    return found


def main(argument: str) -> int:
    cargo, citation, changelog = (
        (ROOT / name).read_text("utf-8") for name in ("Cargo.toml", "CITATION.cff", "CHANGELOG.md")
    )
    if argument == "--unreleased":
        print(section(changelog, "[Unreleased]") or "Nothing has changed since the last release.")
        return 0
    for fault in (found := faults(argument, cargo, citation, changelog)):
        print(f"rimroll: {fault}", file=sys.stderr)
    if found:
        return 1
    day = re.search(r"^date-released: (.*)$", citation, re.M)
    assert day
    print(section(changelog, f"[{argument.removeprefix('v')}] - {day[1]}"))
    return 0


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1]))
