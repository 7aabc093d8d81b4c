"""The set-up that the options of a command describe, with a scenario file if there is one."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rimroll import bodies
from rimroll.bodies.body import Bodies, Body
from rimroll.bodies.solids import SIZES
from rimroll.cli.contact import option, requested_law, with_resistances
from rimroll.cli.options import (
    BodyOptions,
    FallOptions,
    LawOptions,
    MotionOptions,
    ResistanceOptions,
    StartOptions,
)
from rimroll.errors import RimrollError, choose
from rimroll.experiment.release import nudged
from rimroll.options import FlatLanding, Options, landing_given
from rimroll.scenario import AFTER, Scenario, load, presets
from rimroll.state import START_NUMBERS, State
from rimroll.units import positive, quantities_of

if TYPE_CHECKING:
    from rimroll.ground.ground import Ground

DEFAULT = "can_2007"


@dataclass(frozen=True)
class Shaking:
    """What options say of the ground and of flat landings; None where they say nothing."""

    ground: Ground | None = None
    flat: FlatLanding | None = None
    change: Callable[[Ground], Ground] = field(default=lambda ground: ground)
    """What options change of the ground of a file."""


@dataclass(frozen=True, kw_only=True)
class Request(Scenario):
    """A scenario, with the name that was given for its body."""

    name: str
    has_file: bool = False
    """Whether it is based on a scenario file."""
    nudged: bool = False
    """Whether no start was given, so that it is :func:`nudged`."""


def requested(
    body: BodyOptions,
    start: StartOptions | None = None,
    motion: MotionOptions | None = None,
    law: LawOptions | None = None,
    resistances: ResistanceOptions | None = None,
    needs_start: bool = False,
    shaking: Shaking | None = None,
) -> Request:
    """The set-up that options describe; every body has a default start for commands that need one.

    ``shaking`` is what the options say of the ground. Without it, a file with a ground is refused.
    On a ground that moves a body stands unless a start is given.

    Raises ``RimrollError`` naming the option, or the file and its field, that is at fault.
    """
    start, motion = start or StartOptions(), motion or MotionOptions()
    law, resistances = law or LawOptions(), resistances or ResistanceOptions()
    file, preset = body.scenario, body.body
    if preset is not None and is_file(preset):
        if file is not None:
            raise RimrollError(f"{preset} and --scenario {file} are both scenario files: give one")
        file, preset = Path(preset), None
    scenario = load(file) if file is not None else None
    sizes = {name: text for name in SIZES if (text := getattr(body, name, None)) is not None}
    what = _body(preset, sizes, scenario)
    options = _options(motion, scenario.options if scenario else Options())
    ground, flat = _shaken(shaking, scenario, file)
    options = replace(options, flat=flat)
    has_duration = motion.duration is not None or bool(scenario and scenario.has_duration)
    if ground is not None and not has_duration:
        options = replace(options, duration=ground.duration + AFTER)
    positive("gravity", options.gravity, "m/s^2")  # commands compute with it before the core does
    of_file = scenario.law if scenario else None
    contact = requested_law(law, resistances, of_file)
    if of_file is not None:
        contact = replace(contact, resistances=of_file.resistances)
    given, begin = _given(start), scenario.start if scenario else None
    stands = given.get("tilt") == 0.0
    is_nudged = needs_start and begin is None and ground is None and not stands
    if is_nudged:
        begin = _nudged(what, options.gravity, given)
    if stands or (ground is not None and begin is None and "tilt" not in given):
        begin = _standing(given, shaking is not None, ground is not None)
        given = {}
    return Request(
        body=what,
        start=_start(given, begin),
        law=with_resistances(contact, resistances, what, options.gravity),
        options=options,
        ground=ground,
        has_duration=has_duration,
        has_file=scenario is not None,
        name=preset or (str(file) if file else "your body" if sizes else DEFAULT),
        nudged=is_nudged and not given,
    )


def _shaken(
    shaking: Shaking | None, scenario: Scenario | None, file: Path | None
) -> tuple[Ground | None, FlatLanding]:
    """The ground and the flat landing of the options, or else of the file."""
    ground = scenario.ground if scenario else None
    flat = scenario.options.flat if scenario else None
    if shaking is None:
        if ground is not None or flat is not None or (scenario and scenario.options.flat_gap):
            raise RimrollError(
                f"{file}: [ground], flat and flat_gap are for rimroll simulate, shake and fragility"
            )
        return None, "stop"
    if shaking.ground is not None:
        ground = shaking.ground
    elif ground is not None:
        ground = shaking.change(ground)
    given = flat if shaking.flat is None else shaking.flat
    return ground, landing_given(given, ground is not None)


def is_file(name: str) -> bool:
    """Whether a body's name looks like a file's."""
    return name.endswith(".toml") or "/" in name or Path(name).is_file()


def _body(preset: str | None, sizes: dict[str, str], scenario: Scenario | None) -> Body:
    if preset is not None:
        return preset_body(preset, sizes)
    for name in sizes:
        if name not in Bodies._fields:
            raise RimrollError(
                f"{option(name)} is for a preset: name it, as in cylinder or soda_can"
            )
    numbers = {name: SIZES[name].read(text, option(name)) for name, text in sizes.items()}
    if scenario is not None:
        return replace(scenario.body, **numbers)
    if not numbers:
        return bodies.by_name(DEFAULT)
    missing = [option(name) for name in Bodies._fields if name not in numbers]
    if missing:
        raise RimrollError(f"a body of your own also needs {', '.join(missing)}")
    return Body(**numbers)


def preset_body(name: str, sizes: dict[str, str]) -> Body:
    """A preset with the sizes that it takes."""
    try:
        function = choose("body", name, presets())
    except RimrollError as error:
        raise error.with_hint(", or give a .toml file") from None
    taken = inspect.signature(function).parameters
    for size in sizes:
        if size not in taken:
            takes = ", ".join(map(option, taken)) or "none"
            raise RimrollError(f"{option(size)} does not go with {name} (its options: {takes})")
    for size, parameter in taken.items():
        if parameter.default is parameter.empty and size not in sizes:
            raise RimrollError(f"{name} needs {option(size)}")
    return function(**{size: SIZES[size].read(text, option(size)) for size, text in sizes.items()})


def _given(options: StartOptions) -> dict[str, float]:
    """The numbers of a start that options give."""
    return {
        name: one.read(text, option(name))
        for name, one in START_NUMBERS.items()
        if (text := getattr(options, name, None)) is not None
    }


def _nudged(body: Body, gravity: float, given: dict[str, float]) -> State:
    """The usual start at the tilt that is given; without its push if there is another."""
    start = nudged(body, gravity, given.get("tilt"))
    pushed = "yaw_rate" in given or "spin_rate" in given
    return replace(start, yaw_rate=0.0, spin_rate=0.0) if pushed else start


def _standing(given: dict[str, float], may_stand: bool, moves: bool) -> State:
    """A body that stands flat, which a knock or a table that moves sets in motion."""
    if not may_stand:
        raise RimrollError(
            "--tilt 0 is a body that stands, which rimroll simulate and shake can start; else give"
            " a tilt, as --tilt 20deg"
        )
    for name, value in given.items():
        if value and name not in ("yaw", "tilt_rate"):
            raise RimrollError(
                f"{option(name)} is for a body that leans: give a tilt, as --tilt 20deg; a body"
                " that stands takes --tilt-rate, which is a knock"
            )
    rate = given.get("tilt_rate", 0.0)
    if rate < 0.0:
        raise RimrollError(
            f"--tilt-rate must be > 0 for a body that stands, got {rate:g} rad/s: a knock lifts it"
        )
    if not rate and not moves:
        raise RimrollError(
            "--tilt 0 is a body that stands, and stays: give --tilt-rate, as a knock of 3rad/s, or"
            " a tilt, as --tilt 20deg"
        )
    return State.standing(yaw=given.get("yaw", 0.0), tilt_rate=rate)


def _start(given: dict[str, float], start: State | None) -> State | None:
    if start is not None:
        return replace(start, **given) if given else start
    if given and "tilt" not in given:
        raise RimrollError(
            "a start needs --tilt, for instance --tilt 30deg; at --tilt 0 a body stands, and"
            " --tilt-rate is a knock"
        )
    return State(**given) if given else None


def _options(motion: MotionOptions, options: Options) -> Options:
    given: dict[str, Any] = {
        name: one.read(text, option(name))
        for name, one in quantities_of(Options).items()
        if (text := getattr(motion, name, None)) is not None
    }
    if motion.max_steps is not None:
        given["max_steps"] = motion.max_steps
    return replace(options, **given) if given else options


def options_of_falls(given: FallOptions, read: Options, defaults: Options) -> Options:
    """The options of many falls.

    ``read`` holds the given values. From a scenario file, whose accuracy is that of a
    single motion, only gravity and topple tilt are used.
    """
    own = ("duration", "rtol", "max_steps")
    names = ("gravity", "topple_tilt", *(name for name in own if getattr(given, name) is not None))
    return replace(defaults, **{name: getattr(read, name) for name in names})
