"""Options of a release by hand."""

from __future__ import annotations

import math
from dataclasses import fields, replace
from typing import Annotated

from rimroll.cli.contact import option
from rimroll.cli.options import Texts, options, value_option
from rimroll.cli.request import Request
from rimroll.cli.screen import NO_BREAK, unbroken
from rimroll.errors import RimrollError, typed
from rimroll.experiment import release as releases
from rimroll.experiment.release import Release
from rimroll.units import quantity

NAMES = ", ".join(map(typed, releases.PRESETS))


@options({"Release": releases.NUMBERS}, "friction_scale")
class ReleaseOptions(Texts):
    """The release by a hand, and its scatter."""

    release: Annotated[
        str,
        value_option(f"{NAMES}; the options below change parts of it.", "NAME", "Release"),
    ] = "flick"


def requested_release(hand: ReleaseOptions, what: Request) -> Release:
    """The preset with what options change of it.

    Raises ``RimrollError`` naming the option that is at fault.
    """
    release = Release.named(hand.release, what.body, what.options.gravity)
    for field in fields(Release):
        numbers = list(getattr(release, field.name))
        for place, name in enumerate((field.name, field.name + releases.SPREAD)):
            if (text := getattr(hand, name, None)) is not None:
                numbers[place] = releases.NUMBERS[name].read(text, option(name))
        release = replace(release, **{field.name: tuple(numbers)})
    if hand.unsteadiness is None:
        return release
    factor = quantity(hand.unsteadiness, "1", "--unsteadiness")
    if factor < 0.0:
        raise RimrollError(f"--unsteadiness must be >= 0, got {factor:g}")
    return release.with_unsteadiness(factor)


def release_line(release: Release) -> str:
    """A release in a line of prose: means ± standard deviations."""
    tilt, spread = map(math.degrees, release.tilt)
    rates = ", ".join(
        unbroken(f"{name} {mean:.3g} ± {deviation:.2g}")
        for name, (mean, deviation) in (
            ("tilt", release.tilt_rate),
            ("sideways", release.sideways),
            ("twist", release.twist),
        )
    )
    scatter = release.friction_scale[1]
    friction = f"; friction scale ± {100.0 * scatter:.2g} %" if scatter else ""
    return f"from tilt {tilt:.3g}° ± {spread:.2g}°, rates of {rates}{NO_BREAK}rad/s{friction}"
