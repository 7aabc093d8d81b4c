"""Tables for the views of bodies, starts, turns, fits and measurements in notebooks."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import fields
from html import escape
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from rimroll.body import Body
    from rimroll.experiment.fitting.fit import Fit
    from rimroll.experiment.measurement import Measurement
    from rimroll.motion.parts import Turn
    from rimroll.state import State


CELL = 'style="text-align: left; padding-right: 1em"'

TURN_HEAD = ("angle", "smallest tilt", "at t")
"""The head of a table of turns."""


def view(title: str, *parts: str) -> str:
    """A view with a title in bold; the parts are HTML."""
    return f"<div><p><b>{escape(title)}</b></p>{''.join(parts)}</div>"


def table(rows: Iterable[Sequence[str]], head: Sequence[str] = ()) -> str:
    """A table of texts."""
    titles = "".join(f"<th {CELL}>{escape(name)}</th>" for name in head)
    top = f"<thead><tr>{titles}</tr></thead>" if head else ""
    body = "".join(
        "<tr>" + "".join(f"<td {CELL}>{escape(cell)}</td>" for cell in row) + "</tr>"
        for row in rows
    )
    return f"<table>{top}<tbody>{body}</tbody></table>"


def sentences(texts: Iterable[str]) -> str:
    """A list of sentences."""
    items = "".join(f"<li>{escape(text)}</li>" for text in texts)
    return f"<ul>{items}</ul>" if items else ""


def turn_cells(turn: Turn) -> tuple[str, ...]:
    """The cells of a turn under :data:`TURN_HEAD`."""
    angle, smallest = np.degrees([turn.angle, turn.min_tilt])
    return f"{angle:.4f}°", f"{smallest:.4g}°", f"{turn.t:.6g} s"


def turn_in_html(turn: Turn) -> str:
    """The angle of a turn and its near-collision."""
    return view("Turn", table([turn_cells(turn)], TURN_HEAD))


def body_in_html(body: Body) -> str | None:
    """The five numbers of a body, and what follows from them; None for many bodies."""
    if body.shape:
        return None
    from rimroll.laws import Frictionless, NoSlip
    from rimroll.theory import balance_tilt, needed_friction, turn_limit

    numbers = (
        ("mass", f"{1e3 * body.mass:.6g} g"),
        ("radius of the rim", f"{1e2 * body.radius:.6g} cm"),
        ("height of the centre of mass", f"{1e2 * body.height:.6g} cm"),
        ("transverse inertia A", f"{body.transverse_inertia:.6g} kg m²"),
        ("axial inertia C", f"{body.axial_inertia:.6g} kg m²"),
    )
    derived = (
        ("balances at", _degrees(balance_tilt(body))),
        *(
            [("with its filling liquid", _degrees(balance_tilt(body, liquid=True)))]
            if body.filling
            else []
        ),
        ("turns without slip", _degrees(turn_limit(body, NoSlip()))),
        ("turns without friction", _degrees(turn_limit(body, Frictionless()))),
        ("friction needed to roll", f"{needed_friction(body):.3f}"),
    )
    return view("Body", table([*numbers, *derived]))


def state_in_html(state: State) -> str | None:
    """The angles and rates of a state; None for many states."""
    if any(map(np.ndim, vars(state).values())):
        return None
    rows = []
    for field in fields(state):
        value = float(getattr(state, field.name))
        is_rate = field.name.endswith("rate")
        shown = f"{value:.6g} rad/s" if is_rate else f"{np.degrees(value):.6g}°"
        rows.append((field.name, shown))
    return view("State", table(rows))


def fit_in_html(fit: Fit) -> str:
    """The friction of a fit, the hand, and the verdicts."""
    rows = [("friction", str(fit.friction))]
    for name, side in (
        ("from falls to the left", fit.left),
        ("from falls to the right", fit.right),
    ):
        if side is not None:
            rows.append((name, str(side)))
    bias = _degrees(fit.bias, 1)
    if fit.bias_interval is not None:
        low, high = fit.bias_interval
        bias += f" ({_degrees(low, 1)} to {_degrees(high, 1)})"
    rows += [("bias", bias), ("unsteadiness", f"{fit.unsteadiness:.2f}")]
    doubts = f"<p>{escape(' '.join(fit.warnings))}</p>" if fit.warnings else ""
    title = f"Fit to {len(fit.directions)} falls"
    return view(title, table(rows), sentences(v.sentence for v in fit.verdicts), doubts)


def measurement_in_html(measurement: Measurement) -> str:
    """The numbers of a measured body with their uncertainties."""
    from rimroll.experiment.readings import pretty

    estimated = "" if measurement.axial_inertia_measured else " (estimated)"
    rows = (
        ("mass", measurement.mass, "kg"),
        ("radius of the rim", measurement.radius, "m"),
        ("height of the centre of mass", measurement.height, "m"),
        ("transverse inertia A", measurement.transverse_inertia, "kg m^2"),
        (f"axial inertia C{estimated}", measurement.axial_inertia, "kg m^2"),
        ("turns without slip", measurement.turn_no_slip, "rad"),
        ("turns without friction", measurement.turn_frictionless, "rad"),
        ("friction needed to roll", measurement.needed_friction, "1"),
    )
    return view("Measurement", table((name, pretty(value, unit)) for name, value, unit in rows))


def _degrees(angle: float, decimals: int = 2) -> str:
    return f"{np.degrees(angle):.{decimals}f}°"
