"""The paper's simulation figure (``purerollnumresults``), and its twin without friction."""

from __future__ import annotations

import numpy as np

from rimroll.figures import style
from rimroll.laws import Frictionless, Law, NoSlip
from rimroll.motion import Motion
from rimroll.motion.figure import nine_panels
from rimroll.paper import setting
from rimroll.paper.drawing import Drawing
from rimroll.theory.closed_forms import needed_friction, turn_limit


def draw() -> Drawing:
    """The can rolling without slip from the paper's start."""
    motion = setting.motion(NoSlip())
    turn = motion.turns[1]
    numbers = _numbers(NoSlip(), motion)
    limit = np.degrees(turn_limit(setting.CAN, NoSlip()))
    peak = motion.normal_force.max()
    weights = peak / (setting.CAN.mass * setting.GRAVITY)
    caption = (
        "The paper’s nine panels, computed: the can tipped 30°, pushed down at 0.5 rad/s and "
        "sideways at ψ̇ = θ̇ = 0.005 rad/s, rolling without slip. "
        f"The base comes within {np.degrees(turn.min_tilt):.4f}° of the table and the yaw steps by "
        f"{np.degrees(abs(turn.angle)):.3f}° (limit {limit:.3f}°); the lens in (b) shows it "
        f"smooth, half of it within {1e6 * _half_time(motion):.0f} µs. The normal force peaks at "
        f"{peak:.0f} N, {weights:.0f} times the weight, yet friction never exceeds "
        f"{motion.friction_ratio.max():.4f} of it: as the paper says, finite friction is enough, "
        f"and μ* = mHR/(A+mH²) = {needed_friction(setting.CAN):.4f} says how much."
    )
    return Drawing(
        "simulation",
        "The simulation: rolling without slip",
        style.settle(nine_panels(motion)),
        caption,
        numbers,
    )


def draw_frictionless() -> Drawing:
    """The can sliding without friction from the paper's start."""
    motion = setting.motion(Frictionless())
    turn = motion.turns[1]
    caption = (
        "The same can and start on a table without friction, which the paper describes in words. "
        f"It comes closer to the table ({np.degrees(turn.min_tilt):.4f}°), turns by "
        f"{np.degrees(abs(turn.angle)):.3f}° (limit "
        f"{np.degrees(turn_limit(setting.CAN, Frictionless())):.3f}°) and rocks faster, a fall "
        f"every {turn.end - turn.start:.3f} s, because its centre of mass moves only up and down. "
        "Yaw and spin rates are again equal and opposite (i)."
    )
    return Drawing(
        "simulation_frictionless",
        "The simulation: sliding without friction",
        style.settle(nine_panels(motion)),
        caption,
        _numbers(Frictionless(), motion),
    )


def _half_time(motion: Motion) -> float:
    """Time in which the middle half of a turn passes, 2φ_c/ω, s."""
    turn = motion.turns[1]
    limit: float = turn_limit(motion.body, motion.law)
    return 2.0 * limit / (np.pi * abs(turn.yaw_rate))


def _numbers(law: Law, motion: Motion) -> dict[str, object]:
    turn = motion.turns[1]
    samples = motion.samples(8)  # a peak lies between steps
    return {
        "turn": abs(turn.angle),
        "turn_limit": turn_limit(motion.body, law),
        "turn_from_release": abs(motion.turns[0].angle),
        "collision_time": motion.turns[0].t,
        "min_tilt": turn.min_tilt,
        "peak_yaw_rate": abs(turn.yaw_rate),
        "rocking_period": turn.end - turn.start,
        "max_tilt": turn.max_tilt,
        "peak_normal_force": float(samples.normal_force.max()),
        "peak_friction_ratio": float(samples.friction_ratio.max()),
        "needed_friction": needed_friction(motion.body),
    }
