"""The figure of a body on a table that moves shows the motion that it is of."""

from pathlib import Path

import numpy as np
import pytest

import rimroll as rr
from rimroll.scenario import load

COLUMN = load(Path(__file__).parents[2] / "examples" / "column.toml")


def shaken(ground, **options):
    standing = rr.State.standing()
    return rr.simulate(COLUMN.body, standing, rr.Coulomb(0.6), 30.0, ground=ground, **options)


def panels(motion):
    figure = motion.plot()
    return {axes.get_title("left")[1]: axes for axes in figure.axes if axes.get_title("left")}


@pytest.mark.parametrize("scale", [1.0, 1.3])
def test_the_panels_show_the_motion(scale):
    motion = shaken(COLUMN.ground.scaled(scale), flat="housner")
    shown = panels(motion)
    assert set(shown) == set("abcde")
    tilt = shown["b"].lines[0]
    assert np.radians(tilt.get_ydata()).max() == pytest.approx(motion.max_tilt, rel=1e-4)
    uplift = next(line for line in shown["b"].lines if line.get_label() == "uplift")
    assert uplift.get_xdata()[0] == motion.uplift_time
    (second,) = shown["b"].child_axes
    assert second.get_ylabel() == "over the balance tilt (1)"
    path = next(line for line in shown["d"].lines if line.get_label() == "path of its centre")
    moved = path.get_xydata()[-1] - path.get_xydata()[0]
    assert moved == pytest.approx(motion.footprint[-1] - motion.footprint[0], abs=1e-12)
    turned = shown["c"].lines[0].get_ydata()
    assert np.radians(turned[-1] - turned[0]) == pytest.approx(
        motion.body_yaw[-1] - motion.body_yaw[0], abs=1e-12
    )
    record = shown["a"].lines[0].get_ydata()
    assert abs(record).max() == motion.ground.peak.x


def test_the_second_scale_is_the_tilt_over_the_balance_tilt():
    motion = shaken(COLUMN.ground, flat="housner")
    axes = panels(motion)["b"]
    axes.figure.draw_without_rendering()
    low, high = axes.get_ylim()
    balance = np.degrees(rr.balance_tilt(COLUMN.body))
    assert axes.child_axes[0].get_ylim() == pytest.approx((low / balance, high / balance))


@pytest.mark.parametrize(
    "ground", [rr.ground.rectangular(1e-3, 0.1), rr.ground.sine((0.0, 0.0, 3.0), 0.5)]
)
def test_a_body_that_only_stands_is_drawn_too(ground):
    shown = panels(shaken(ground))
    assert np.all(shown["b"].lines[0].get_ydata() == 0.0)


def test_sliding_flat_is_shaded():
    motion = rr.simulate(
        COLUMN.body, rr.State.standing(), rr.Coulomb(0.1), 3.0, ground=rr.ground.sine(3.0, 1.0)
    )
    shown = panels(motion)
    assert shown["b"].get_title("left") == "(b) tilt, sliding shaded"
    sliding = [phase for phase in motion.phases if phase.kind == "sliding_flat"]
    assert len(shown["b"].patches) == len(sliding) > 0


def test_a_motion_on_a_table_at_rest_keeps_its_nine_panels():
    motion = rr.simulate(COLUMN.body, rr.State(tilt=0.1, yaw_rate=0.1), rr.NoSlip())
    assert len(panels(motion)) == 9
