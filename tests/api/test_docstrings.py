"""Examples in docstrings are true, and everything public has a docstring."""

import doctest
import importlib
from pathlib import Path

import pytest

import rimroll as rr

PACKAGE = Path(rr.__file__).parent
WITH_EXAMPLES = sorted(
    ".".join(file.relative_to(PACKAGE.parent).with_suffix("").parts).removesuffix(".__init__")
    for file in PACKAGE.rglob("*.py")
    if "\n>>> " in (text := file.read_text("utf-8")) or "    >>> " in text
)


@pytest.mark.parametrize("name", WITH_EXAMPLES)
def test_examples_in_the_docstrings_are_true(name):
    results = doctest.testmod(importlib.import_module(name))
    assert results.attempted > 0 and results.failed == 0


def test_everything_public_is_documented():
    for name in rr.__all__:
        if not name.startswith("__") and name not in ("STANDARD_GRAVITY", "Law"):
            assert getattr(rr, name).__doc__, name
