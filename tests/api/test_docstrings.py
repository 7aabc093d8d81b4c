"""Docstrings: examples are true, everything public has one, and sections hold items only."""

import ast
import doctest
import importlib
import re
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


def docstrings():
    for file in PACKAGE.rglob("*.py"):
        for node in ast.walk(ast.parse(file.read_text("utf-8"))):
            if isinstance(node, ast.FunctionDef | ast.ClassDef) and (
                text := ast.get_docstring(node)
            ):
                yield f"{file.relative_to(PACKAGE)}: {node.name}", text


def test_no_sentence_of_a_docstring_is_taken_for_a_parameter():
    # Below a title such as "Parameters", each paragraph is a name and an indented description.
    checked = 0
    for name, text in docstrings():
        section = None
        for paragraph in text.split("\n\n"):
            if title := re.match(r"(\w+)\n-{3,}\n", paragraph):
                section = title[1]
                checked += 1
            elif section not in (None, "Examples", "Notes"):
                assert re.search(r"^\s", paragraph, re.M), f"{name}: {paragraph}"
    assert checked > 100
