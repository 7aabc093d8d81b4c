"""``rimroll bodies``: what there is to roll."""

from __future__ import annotations

import inspect
import re
from collections.abc import Callable
from dataclasses import asdict
from typing import Any

from rimroll._core import __version__
from rimroll.bodies.body import Bodies, Body
from rimroll.bodies.solids import SIZES
from rimroll.cli.contact import option
from rimroll.cli.options import JsonOption
from rimroll.cli.screen import prose, say, show_json, table
from rimroll.scenario import presets


def bodies(json: JsonOption = False) -> int:
    """The bodies that have a name, their numbers and sources.

    Example:

    $ rimroll bodies

    Each name can be given to the other commands, as in rimroll turn coin.
    """
    if json:
        listed = {name: _described(preset) for name, preset in presets().items()}
        show_json({"rimroll_version": __version__, "bodies": listed})
        return 0
    numbers = table("body", "m (kg)", "R (m)", "H (m)", "A (kg m²)", "C (kg m²)")
    for name, preset in presets().items():
        if (body := _by_name_alone(preset)) is not None:
            numbers.add_row(name, *(f"{getattr(body, field):.4g}" for field in Bodies._fields))
    say(numbers)
    say()
    for name, preset in presets().items():
        if _by_name_alone(preset) is None:
            prose(f"{name} in any size: {_as_typed(name, preset)}")
    prose("your own: rimroll measure makes a file of it from readings")
    say()
    for name, preset in presets().items():
        say(_as_typed(name, preset))
        prose(f"    {_about(preset)}")
    return 0


def _as_typed(name: str, preset: Callable[..., Body]) -> str:
    """A preset with its sizes as they are typed, those that may be left out in brackets."""
    words = [name]
    for size in inspect.signature(preset).parameters.values():
        typed = f"{option(size.name)} {SIZES[size.name].metavar}"
        words.append(typed if size.default is size.empty else f"[{typed}]")
    return " ".join(words)


def _described(preset: Callable[..., Body]) -> dict[str, Any]:
    body = _by_name_alone(preset)
    return {
        **({} if body is None else asdict(body)),
        "arguments": list(inspect.signature(preset).parameters),
        "about": _about(preset),
    }


def _by_name_alone(preset: Callable[..., Body]) -> Body | None:
    """The body of a preset, if it needs no size."""
    arguments = inspect.signature(preset).parameters.values()
    needed = [argument for argument in arguments if argument.default is argument.empty]
    return None if needed else preset()


def _about(preset: Callable[..., Body]) -> str:
    """The docstring of a preset in one line."""
    text = re.sub(r":\w+:`(\w+)`", r"\1", inspect.getdoc(preset) or "")
    return " ".join(text.split())
