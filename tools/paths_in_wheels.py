"""Looks for paths of the machine that built the given wheels and source distributions."""

import os
import re
import sys
import tarfile
import zipfile
from collections.abc import Iterator
from pathlib import Path

HERE = re.escape(os.fsencode(Path(__file__).parents[1])) + rb"[/\\]+"
HOMES = rb"(?:/(?:root|home|tmp|Users|github|__w)/|[A-Za-z]:[/\\]+(?:Users|a)[/\\]+)"
PATTERN = re.compile(rb"(?:" + HERE + rb"|" + HOMES + rb"[\w.@+-]+[/\\]+)[\w.@+/\\-]+")


def files(archive: Path) -> Iterator[tuple[str, bytes]]:
    if archive.suffix == ".whl":
        with zipfile.ZipFile(archive) as wheel:
            for name in wheel.namelist():
                yield name, wheel.read(name)
    else:
        with tarfile.open(archive) as source:
            for member in source:
                file = source.extractfile(member)
                if file:
                    yield member.name, file.read()


def paths(archive: Path) -> list[str]:
    """Where a path was found, and the path."""
    return [
        f"{name}: {found.decode(errors='replace')}"
        for name, content in files(archive)
        for found in sorted(set(PATTERN.findall(content)))
    ]


if __name__ == "__main__":
    archives = [Path(argument) for argument in sys.argv[1:]]
    assert archives, "name wheels or source distributions"
    found = [f"{archive.name}: {line}" for archive in archives for line in paths(archive)]
    print("\n".join(found) or f"no paths in {len(archives)} files")
    sys.exit(bool(found))
