"""Who computes the numbers of a study: this build of rimroll, and the packages beside it.

Builds with the same version number differ while rimroll is developed, so files identify a build.
"""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from functools import cache
from pathlib import Path

import numpy as np

from rimroll import _core

CODE = ("*.py", "_core*")
"""The files of the package that compute: Python, and the compiled core."""

NAMES = ("rimroll_version", "rimroll_build", "numpy_version", "scipy_version")
"""The attributes of a store that say who computed it."""


@cache
def versions() -> Mapping[str, str]:
    """What computes here, by the names of the attributes."""
    import scipy

    return dict(
        zip(NAMES, (_core.__version__, build(), np.__version__, scipy.__version__), strict=True)
    )


@cache
def build() -> str:
    """A hash of this package, as 12 hexadecimal digits.

    Two of the same version number differ in it if any of their code differs.
    """
    return hash_of(Path(__file__).parents[1])


def hash_of(package: Path) -> str:
    """The hash of the code in a folder: of the names and contents of its files."""
    hashed = hashlib.sha256()
    files = {file for pattern in CODE for file in package.rglob(pattern) if file.is_file()}
    for file in sorted(files - set(package.rglob("*.pyi"))):
        content = file.read_bytes()
        hashed.update(f"{file.relative_to(package).as_posix()} {len(content)}\n".encode())
        hashed.update(content)
    return hashed.hexdigest()[:12]


def of_mark() -> str:
    """The version and the build, as marks of chunks name them."""
    return f"{_core.__version__} build {build()}"


def difference(one: Mapping[str, str], other: Mapping[str, str]) -> tuple[str, str] | None:
    """The first thing in which versions differ, as each has it; None if they are equal.

    >>> difference({"numpy_version": "2.1.0"}, {"numpy_version": "2.2.0"})
    ('numpy 2.1.0', 'numpy 2.2.0')
    """
    for name in NAMES:
        if one.get(name) != other.get(name):
            package, _, kind = name.partition("_")
            what = f"{package} " if kind == "version" else f"{package} {kind} "
            return what + str(one.get(name)), what + str(other.get(name))
    return None
