"""Bodies with corners against Newton and Euler's vectors, impact for impact."""

import numpy as np
import pytest

import rimroll as rr
from oracles.cornered_body import Cornered, tilt_and_heading

GRAVITY = 9.8
BODIES = {
    "nut": rr.polygons.hexagonal_nut(),
    "column": rr.polygons.square_column(0.1, 0.3),
    "triangle": rr.PolygonalBody.prism(0.1, 3, 0.03, 0.004),
    "glass": rr.polygons.cut_glass(),
    "coin": rr.PolygonalBody.prism(8e-3, 12, 0.0115, 2.3e-3),
}
STARTS = {
    "flicked": rr.State(tilt=0.25, tilt_rate=-0.6, yaw=0.3, yaw_rate=0.4, spin=0.2, spin_rate=-0.3),
    "spun": rr.State(tilt=0.2, tilt_rate=0.1, yaw_rate=-2.0, spin=2.9, spin_rate=2.5),
}


@pytest.mark.parametrize("law", [rr.NoSlip(), rr.Frictionless()], ids=lambda law: law.name)
@pytest.mark.parametrize("start", STARTS.values(), ids=STARTS)
@pytest.mark.parametrize("body", BODIES.values(), ids=BODIES)
def test_the_first_impacts_are_those_of_newton_and_euler(body, start, law):
    oracle = Cornered(body, law.name == "no_slip", GRAVITY)
    motion = rr.simulate(body, start, law, 5.0, gravity=GRAVITY, rtol=1e-12)
    impacts = [event for event in motion.impacts if event.support != "face"][:5]
    # A flat triangle comes down on an edge, and on its face next.
    assert len(impacts) == 5 or (impacts[-1].support, motion.status) == ("edge", "at_rest")
    expected = oracle.follow(start, len(impacts))[1:]
    compare(motion, impacts, expected)


@pytest.mark.parametrize("law", [rr.NoSlip(), rr.Frictionless()], ids=lambda law: law.name)
@pytest.mark.parametrize("start", STARTS.values(), ids=STARTS)
@pytest.mark.parametrize("body", BODIES.values(), ids=BODIES)
def test_bounces_and_flights_are_those_of_newton_and_euler(body, start, law):
    oracle = Cornered(body, law.name == "no_slip", GRAVITY, 0.6)
    motion = rr.simulate(
        body, start, law, 5.0, gravity=GRAVITY, rtol=1e-12, restitution=0.6, max_steps=4000
    )
    impacts = motion.impacts[:6]
    assert len(impacts) >= 1
    expected = oracle.bounces(start, len(impacts))
    compare(motion, impacts, expected)


def compare(motion, impacts, expected):
    body = motion.body
    scale = np.sqrt(GRAVITY / body.radius)
    for impact, (t, u, down) in zip(impacts, expected, strict=True):
        at = motion(impact.t)
        tilt, heading = tilt_and_heading(u)
        assert impact.t == pytest.approx(t, rel=1e-8)
        assert impact.state.tilt == pytest.approx(tilt, rel=1e-7, abs=1e-9)
        turned = impact.state.yaw + impact.state.spin - heading
        assert np.sin(0.5 * turned) == pytest.approx(0.0, abs=1e-8)
        assert impact.support == ("flight", "corner", "edge")[len(down)]
        assert not down or int(at.corner[0]) == down[0]
        turn = u[:9].reshape(3, 3)
        rate = turn.T @ u[12:15]
        assert impact.state.spin_rate + impact.state.yaw_rate * np.cos(tilt) == pytest.approx(
            rate[2], abs=1e-7 * scale
        )
        assert impact.state.tilt_rate == pytest.approx(
            np.cross(turn[:, 2], u[12:15])[2] / np.sin(tilt), abs=1e-6 * scale
        )
        assert at.center[0] == pytest.approx(u[9:12], abs=1e-8 * body.radius * 100)
