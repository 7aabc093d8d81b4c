"""Options of a release by hand."""

from __future__ import annotations

import math
from dataclasses import dataclass, fields, replace
from typing import Annotated

from rimroll.cli.contact import option
from rimroll.cli.options import value_option
from rimroll.cli.request import Request
from rimroll.cli.screen import NO_BREAK, unbroken
from rimroll.errors import RimrollError, typed
from rimroll.experiment import release as releases
from rimroll.experiment.release import Release
from rimroll.units import quantity, tilt_angle

Text = str | None


NAMES = ", ".join(map(typed, releases.PRESETS))

RATE = "RATE"


@dataclass(frozen=True)
class ReleaseOptions:
    """The release by a hand, and its scatter."""

    release: Annotated[
        str,
        value_option(f"{NAMES}; the options below change parts of it.", "NAME", "Release"),
    ] = "flick"
    tilt: Annotated[Text, value_option("Mean tilt.", "ANGLE", "Release")] = None
    tilt_spread: Annotated[
        Text, value_option("Standard deviation, like all spreads.", "ANGLE", "Release")
    ] = None
    tilt_rate: Annotated[
        Text, value_option("Mean tilt rate; negative: flicked upright.", RATE, "Release")
    ] = None
    tilt_rate_spread: Annotated[Text, value_option("Its spread.", RATE, "Release")] = None
    sideways: Annotated[
        Text,
        value_option(
            "Rate about the line of lean: the error of aim times the tilt rate.", RATE, "Release"
        ),
    ] = None
    sideways_spread: Annotated[Text, value_option("Its spread.", RATE, "Release")] = None
    twist: Annotated[Text, value_option("Rate about the vertical.", RATE, "Release")] = None
    twist_spread: Annotated[Text, value_option("Its spread.", RATE, "Release")] = None
    friction_scale_spread: Annotated[
        Text,
        value_option("Spread of the friction, relative to it: 0.1 or 10%.", "PART", "Release"),
    ] = None
    unsteadiness: Annotated[
        Text, value_option("Multiply the spreads of sideways and twist.", "FACTOR", "Release")
    ] = None


def requested_release(hand: ReleaseOptions, what: Request) -> Release:
    """The preset with what options change of it.

    Raises ``RimrollError`` naming the option that is at fault.
    """
    release = Release.named(hand.release, what.body, what.options.gravity)
    for field in fields(Release):
        unit = {"tilt": "rad", "friction_scale": "1"}.get(field.name, "rad/s")
        mean, spread = getattr(release, field.name)
        if (text := getattr(hand, field.name, None)) is not None:
            read = tilt_angle if field.name == "tilt" else _rate
            mean = read(text, option(field.name))
        if (text := getattr(hand, f"{field.name}_spread")) is not None:
            spread = quantity(text, unit, option(f"{field.name}_spread"))
        release = replace(release, **{field.name: (mean, spread)})
    if hand.unsteadiness is None:
        return release
    factor = quantity(hand.unsteadiness, "1", "--unsteadiness")
    if factor < 0.0:
        raise RimrollError(f"--unsteadiness must be >= 0, got {factor:g}")
    return release.with_unsteadiness(factor)


def _rate(text: str, name: str) -> float:
    return quantity(text, "rad/s", name)


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
