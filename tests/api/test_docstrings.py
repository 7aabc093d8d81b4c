"""Examples in docstrings are true, and everything public has a docstring."""

import doctest

import pytest

import rimroll as rr
import rimroll.body
import rimroll.motion.motion


@pytest.mark.parametrize(
    "module", [rr, rimroll.body, rimroll.motion.motion], ids=lambda module: module.__name__
)
def test_examples_in_the_docstrings_are_true(module):
    results = doctest.testmod(module)
    assert results.attempted > 0 and results.failed == 0


def test_everything_public_is_documented():
    for name in rr.__all__:
        if not name.startswith("__") and name not in ("STANDARD_GRAVITY", "Law"):
            assert getattr(rr, name).__doc__, name
