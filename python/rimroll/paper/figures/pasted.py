"""The paper's two motions pasted together, compared with the computed motion."""

from __future__ import annotations

from functools import cache

import numpy as np
from matplotlib.axes import Axes

from rimroll.figures import style
from rimroll.laws import Law, NoSlip
from rimroll.motion import Array
from rimroll.paper import setting
from rimroll.paper.drawing import Drawing
from rimroll.theory.approximations import Composite, composite
from rimroll.theory.closed_forms import error_law_coefficient

SHOWN = {0.1: (style.SERIES[1], 4.6), 0.005: (style.NO_SLIP, 2.2)}
"""ψ̇ = θ̇ = ε at the release, rad/s: one that shows a difference, and the paper's own."""

SIDEWAYS = np.array([float(f"1e-{power}") for power in range(1, 7)])
"""The ε along which the error is followed, rad/s."""

NEAR = 6.0  # φ_c/ω shown of the near-collision before and after the smallest tilt


def draw() -> Drawing:
    """Tilt and yaw, whole and near the collision; the error in time, and as ε shrinks."""
    with style.figure_style():
        figure = style.page(104.0)
        panels = figure.subplots(2, 3)
        _draw_whole(panels[:, 0])
        _draw_near(panels[:, 1])
        _draw_errors(panels[0, 2])
        _draw_scaling(panels[1, 2])
        style.settle(figure)
    return Drawing("pasted", "Two motions pasted together", figure, _caption(), _numbers())


def approximation(law: Law, sideways: float) -> Composite:
    """The pasted motion from the paper's start."""
    return composite(setting.CAN, setting.start(sideways), law, setting.GRAVITY)


def times(one: Composite) -> Array:
    """Times over the rocking that is approximated, crowded around the smallest tilt, s, (n,)."""
    brief = one.min_tilt / one.tipping_rate
    away = np.geomspace(1e-2 * brief, one.half_width, 240)
    t = one.min_tilt_time + np.concatenate([-away[::-1], [0.0], away])
    return t[t >= 0.0]


def errors(law: Law, sideways: float) -> tuple[Array, Array, Array]:
    """Times (s), and |computed − pasted| of tilt and of yaw (rad)."""
    one = approximation(law, sideways)
    motion = setting.motion(law, sideways)
    t = times(one)
    state = motion(t)
    return t, np.abs(state.tilt - one.tilt(t)), np.abs(state.yaw - one.yaw(t))


def _draw_whole(column: Array) -> None:
    tilt, yaw = column
    for sideways, (color, width) in SHOWN.items():
        one = approximation(NoSlip(), sideways)
        t, state = times(one), setting.motion(NoSlip(), sideways)(times(one))
        for ax, values in ((tilt, state.tilt), (yaw, state.yaw)):
            ax.plot(t, values, color=color, lw=width, alpha=0.7)
        name = "pasted" if sideways == min(SHOWN) else None
        for ax, values in ((tilt, one.tilt(t)), (yaw, one.yaw(t))):
            ax.plot(t, values, color=style.THEORY, lw=0.8, ls=(0, (4, 2)), label=name)
    for sideways, (color, width) in SHOWN.items():
        tilt.plot([], [], color=color, lw=width, alpha=0.7, label=f"computed, $ε$ = {sideways}")
    style.label(tilt, "a", "tilt", "time $t$ (s)", "$φ$ (rad)")
    style.label(yaw, "d", "yaw", "time $t$ (s)", "$ψ$ (rad)")
    tilt.set_ylim(0.0, 0.8)
    tilt.legend(loc="upper center")


def _draw_near(column: Array) -> None:
    tilt, yaw = column
    scaled = np.linspace(-NEAR, NEAR, 241)
    for sideways, (color, width) in SHOWN.items():
        one = approximation(NoSlip(), sideways)
        t = one.min_tilt_time + scaled * one.min_tilt / one.tipping_rate
        state = setting.motion(NoSlip(), sideways)(t)
        for ax, values in ((tilt, state.tilt / one.min_tilt), (yaw, state.yaw)):
            ax.plot(scaled, values, color=color, lw=width, alpha=0.7)
        for ax, values in ((tilt, one.tilt(t) / one.min_tilt), (yaw, one.yaw(t))):
            ax.plot(scaled, values, color=style.THEORY, lw=0.8, ls=(0, (4, 2)))
    x = "scaled time $ω$($t$ − $t_c$)/$φ_c$ (1)"
    style.label(tilt, "b", "tilt, magnified", x, "$φ$/$φ_c$ (1)")
    style.label(yaw, "e", "yaw, magnified", x, "$ψ$ (rad)")
    tilt.set_ylim(0.0, None)


def _draw_errors(ax: Axes) -> None:
    for sideways, (color, _) in SHOWN.items():
        t, tilt, yaw = errors(NoSlip(), sideways)
        ax.semilogy(t, yaw, color=color, ls="-", lw=1.0, label=f"$ψ$, $ε$ = {sideways}")
        ax.semilogy(t, tilt, color=color, ls=":", lw=1.2, label=f"$φ$, $ε$ = {sideways}")
    style.label(ax, "c", "error", "time $t$ (s)", "|computed − pasted| (rad)")
    ax.set_ylim(1e-10, 1e3)
    style.decades(ax.yaxis)
    ax.legend(loc="upper center", ncols=2, columnspacing=1.0)


def _draw_scaling(ax: Axes) -> None:
    min_tilt, tilt, yaw = _largest_errors(NoSlip())
    b, a = _yaw_law(NoSlip())
    line = {"color": style.THEORY, "lw": 0.8, "zorder": 0}
    ax.loglog(min_tilt, yaw, ls="none", label="$ψ$", **style.look(NoSlip()))
    ax.loglog(
        min_tilt, min_tilt * (b * np.log(min_tilt) + a), label="$φ_c(b\\,\\ln φ_c + a)$", **line
    )
    ax.loglog(min_tilt, tilt, ls="none", marker="^", color=style.MEASURED, label="$φ$")
    square = tilt[-2] * (min_tilt / min_tilt[-2]) ** 2
    ax.loglog(min_tilt, square, ls=":", label="∝ $φ_c^2$", **line)
    name = "largest error"
    style.label(ax, "f", name, "smallest tilt $φ_c$ (rad)", "|computed − pasted| (rad)")
    style.decades(ax.xaxis, ax.yaxis)
    ax.set_ylim(1e-15, 1e4)
    ax.legend(loc="upper left", ncols=2, columnspacing=1.0)


@cache
def _largest_errors(law: Law) -> tuple[Array, Array, Array]:
    """Smallest tilt and the largest errors of tilt and yaw for each ε, rad."""
    found = [errors(law, float(sideways)) for sideways in SIDEWAYS]
    min_tilt = [approximation(law, float(sideways)).min_tilt for sideways in SIDEWAYS]
    largest = np.array([(tilt.max(), yaw.max()) for _, tilt, yaw in found])
    return np.array(min_tilt), largest[:, 0], largest[:, 1]


def _yaw_law(law: Law) -> tuple[float, float]:
    """b of theory and a, from ε = 1e-5, of the yaw's largest error, φ_c (b ln φ_c + a)."""
    min_tilt, _, yaw = _largest_errors(law)
    rate = approximation(law, 1e-5).tipping_rate
    b = error_law_coefficient(setting.CAN, law, rate, setting.GRAVITY)
    return b, float(yaw[4] / min_tilt[4] - b * np.log(min_tilt[4]))


def _caption() -> str:
    worst = {sideways: errors(NoSlip(), sideways)[2].max() for sideways in SHOWN}
    b, _ = _yaw_law(NoSlip())
    largest = " and ".join(f"{worst[s]:.4f} rad at ε = {s} rad/s" for s in SHOWN)
    return (
        "The paper describes the motion as an inverted pendulum pasted to a near-collision of a "
        "vastly shorter time-scale, without writing it down. Here is the pasted formula (dashed), "
        "computed from the start alone, over the full motion without slip. "
        f"Its yaw is wrong by at most {largest}, which is the approach to the limit: "
        f"the largest error follows φ<sub>c</sub>(b ln φ<sub>c</sub> + a) with the same "
        f"b = {b:.4f}; the tilt’s errors are of the order φ<sub>c</sub>²."
    ).replace(" -", " −")


def _numbers() -> dict[str, object]:
    numbers: dict[str, object] = {"sideways": SIDEWAYS}
    for law in setting.LAWS:
        min_tilt, tilt, yaw = _largest_errors(law)
        b, a = _yaw_law(law)
        numbers[law.name] = {
            "min_tilt": min_tilt,
            "largest_tilt_error": tilt,
            "largest_yaw_error": yaw,
            "b": b,
            "a_fitted": a,
        }
    return numbers
