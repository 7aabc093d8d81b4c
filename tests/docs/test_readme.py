"""The README's example runs as printed and prints what it says."""

import contextlib
import io
import re
from pathlib import Path

import numpy as np
import pytest

README = (Path(__file__).parents[2] / "README.md").read_text(encoding="utf-8")


def test_the_five_lines_print_what_the_readme_says():
    code, output = re.search(r"```python\n(.*?)```\s+```\n(.*?)```", README, re.S).groups()
    assert len(code.splitlines()) == 5
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        exec(code, {})
    # The same bits everywhere, except that NumPy may turn radians into degrees its own way.
    assert np.array(printed.getvalue().split(), float) == pytest.approx(
        np.array(output.split(), float), rel=4e-16
    )


def test_the_pictures_of_the_readme_are_there():
    pictures = re.findall(r"!\[[^]]+\]\(([^)]+)\)", README)
    assert len(pictures) == 5
    for picture in pictures:
        assert (Path(__file__).parents[2] / picture).is_file()
