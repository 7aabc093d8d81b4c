"""The README's example runs as printed, and the page of features names what is there."""

import contextlib
import io
import re
from pathlib import Path

import numpy as np
import pytest

import rimroll as rr
from rimroll.files.recorded import OUTCOMES, STATUSES

ROOT = Path(__file__).parents[2]
README = (ROOT / "README.md").read_text(encoding="utf-8")
FEATURES = (ROOT / "docs/what-it-does.md").read_text(encoding="utf-8")


def test_the_five_lines_print_what_the_readme_says():
    code, output = re.search(r"```python\n(.*?)```\s+```\n(.*?)```", README, re.S).groups()
    assert len(code.splitlines()) == 5
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        exec(code, {})
    # Bits are the same everywhere, except in NumPy's conversion from radians to degrees.
    assert np.array(printed.getvalue().split(), float) == pytest.approx(
        np.array(output.split(), float), rel=4e-16, abs=0.0
    )


def test_what_the_page_of_features_calls_an_attribute_is_one():
    motion = rr.simulate(rr.bodies.can_2007(), rr.State(tilt=0.5, yaw_rate=0.1), rr.NoSlip(), 0.1)
    names = re.search(r"at any time, and\s+(.*?) are attributes", FEATURES, re.S)[1]
    listed = re.findall(r"`(\w+)`", names)
    assert len(listed) == 7
    for name in listed:
        assert hasattr(motion, name)


def test_the_page_of_features_names_every_ending_of_a_motion_and_of_a_fall():
    (endings,) = re.findall(r"\* \*\*Endings\*\*: (.*?)\n\*", FEATURES, re.S)
    assert {*STATUSES, *OUTCOMES, "rr.Interrupted"} == set(re.findall(r"`([\w.]+)`", endings))


def test_the_pictures_of_the_readme_are_there():
    pictures = re.findall(r"!\[[^]]+\]\(([^)]+)\)", README)
    assert len(pictures) == 3
    for picture in pictures:
        assert (ROOT / picture).is_file()
