"""Derivatives of whole motions, against multiprecision and neighbouring motions."""

import pickle

import mpmath as mp
import numpy as np
import pytest

import rimroll as rr
from given.ctrl_c import needs_signals, processor_time_after_ctrl_c
from rimroll.motion.jacobian import PARAMETERS, QUANTITIES

CAN = rr.bodies.can_2007()
START = {
    "tilt": 0.5,
    "tilt_rate": -0.4,
    "yaw": 0.3,
    "yaw_rate": 0.2,
    "spin": -0.1,
    "spin_rate": 0.4,
}
BODY = {
    name: getattr(CAN, name)
    for name in ("mass", "radius", "height", "transverse_inertia", "axial_inertia")
}
NUMBERS = START | BODY | {"gravity": 9.8}
LAWS = [rr.NoSlip(), rr.Frictionless()]
by_law = pytest.mark.parametrize("law", LAWS, ids=lambda law: law.name)


def simulated(law, numbers=NUMBERS, **options):
    body = rr.Body(**{name: numbers[name] for name in BODY})
    start = rr.State(**{name: numbers[name] for name in START})
    options = {"duration": 2.0, "gravity": numbers["gravity"], "rtol": 1e-12} | options
    return rr.simulate(body, start, law, **options)


class Rolling:
    """The motion without slip as a Taylor series, with any number of digits.

    The equations are those linear in l = w sin φ and s, with the tilt as clock, and row 2 of the
    paper's; the series goes by τ, dt = sin φ dτ, in which they are polynomial.
    """

    ORDER = 30

    def __init__(self, mass, radius, height, transverse_inertia, axial_inertia, gravity):
        self.c, self.mrr, self.mhr = axial_inertia, mass * radius**2, mass * height * radius
        self.k = transverse_inertia + mass * height**2
        self.determinant = self.c * self.k + self.mrr * transverse_inertia
        self.s_of_w = self.mrr * transverse_inertia
        self.weight = mass * gravity * radius, mass * gravity * height

    def series(self, at):
        """Coefficients of sin φ, cos φ, φ̇, w, s, yaw and time."""
        columns = [[value] for value in at]
        sin, cos, p, w, s, *_ = columns
        mhr, rolling = self.mhr, self.c + self.mrr
        falling, level, across, along, turning, l_rate, s_rate = ([] for _ in range(7))

        def times(x, y):
            return mp.fdot(x, y[::-1])

        for n in range(self.ORDER):
            falling.append(times(sin, p))
            level.append(times(w, cos))
            across.append(self.k * w[n] - mhr * s[n])
            along.append(mhr * w[n] - rolling * s[n])
            l_rate.append(self.c * (rolling * s[n] - mhr * w[n]) / self.determinant)
            s_rate.append((self.s_of_w * w[n] + self.c * mhr * s[n]) / self.determinant)
            weight = self.weight[1] * sin[n] - self.weight[0] * cos[n]
            turning.append(times(w, along) + weight)
            rates = (
                times(falling, cos),
                -times(falling, sin),
                (times(level, across) + times(sin, turning)) / (self.k + self.mrr),
                times(falling, l_rate) - times(p, level),
                times(falling, s_rate),
                w[n],
                sin[n],
            )
            for column, rate in zip(columns, rates, strict=True):
                column.append(rate / (n + 1))
        return [column[::-1] for column in columns]

    def state(self, tilt, tilt_rate, yaw, yaw_rate, spin_rate, until):
        """Tilt, tilt rate, yaw and yaw rate at a time."""
        sin, cos = mp.sin(tilt), mp.cos(tilt)
        at = [sin, cos, tilt_rate, yaw_rate * sin, spin_rate + yaw_rate * cos, yaw, mp.mpf(0)]
        while at[-1] < until:
            series = self.series(at)
            h = 1 / (3 * sum(map(abs, at[2:5]), mp.mpf(3)))
            if mp.polyval(series[-1], h) > until:
                h = mp.findroot(lambda x, t=series[-1]: mp.polyval(t, x) - until, h)
                at = [mp.polyval(column, h) for column in series]
                break
            at = [mp.polyval(column, h) for column in series]
        return mp.atan2(at[0], at[1]), at[2], at[5], at[3] / at[0]


@pytest.mark.parametrize("parameter", ["tilt_rate", "height"])
def test_multiprecision_has_the_same_derivatives(parameter):
    """Through the near-collision, by differences too small for ordinary numbers."""
    t = 0.35

    def state(by):
        numbers = {name: mp.mpf(value) for name, value in NUMBERS.items()}
        numbers[parameter] += by
        rolling = Rolling(*(numbers[name] for name in (*BODY, "gravity")))
        names = ("tilt", "tilt_rate", "yaw", "yaw_rate", "spin_rate")
        return rolling.state(*(numbers[name] for name in names), mp.mpf(t))

    with mp.workdps(34):
        width = mp.mpf(10) ** -11
        pairs = zip(state(width), state(-width), strict=True)
        expected = [float((ahead - behind) / (2 * width)) for ahead, behind in pairs]
    motion = simulated(rr.NoSlip(), jacobian=True)
    assert motion.turns[0].t < t
    jacobian = motion.jacobian(t)
    found = [jacobian[name, parameter] for name in ("tilt", "tilt_rate", "yaw", "yaw_rate")]
    np.testing.assert_allclose(found, expected, rtol=1e-9)


@by_law
def test_a_jacobian_is_the_difference_of_neighbouring_motions(law):
    t = np.array([0.1, 0.5, 1.2])
    motion = simulated(law, jacobian=True)
    jacobian = motion.jacobian(t)
    assert jacobian.values.shape == (3, len(QUANTITIES), len(PARAMETERS))
    for parameter in PARAMETERS:
        width = 1e-5 * NUMBERS[parameter]
        ahead, behind = (
            simulated(law, NUMBERS | {parameter: NUMBERS[parameter] + by})(t)
            for by in (width, -width)
        )
        for quantity in QUANTITIES:
            expected = (getattr(ahead, quantity) - getattr(behind, quantity)) / (2 * width)
            size = np.abs(jacobian.values[:, QUANTITIES.index(quantity)] @ list(NUMBERS.values()))
            allowed = 1e-4 * (np.abs(expected) + (size + 1) / NUMBERS[parameter])
            assert np.all(np.abs(jacobian[quantity, parameter] - expected) < np.abs(allowed))


@by_law
def test_the_turns_have_derivatives_too(law):
    motion = simulated(law, jacobian=True)
    assert len(motion.turn_jacobians) == len(motion.turns) > 1
    width = 1e-6
    faster = simulated(law, NUMBERS | {"tilt_rate": NUMBERS["tilt_rate"] + width})
    for jacobian, turn, other in zip(
        motion.turn_jacobians, motion.turns, faster.turns, strict=True
    ):
        assert tuple(jacobian) == PARAMETERS
        expected = (other.angle - turn.angle) / width
        assert jacobian["tilt_rate"] == pytest.approx(expected, rel=1e-3)
        assert abs(jacobian["yaw"]) < 1e-9


def test_one_time_has_one_derivative():
    motion = simulated(rr.NoSlip(), jacobian=True)
    assert motion.jacobian(0.3).values.shape == (6, 12)
    # Names are matched as elsewhere.
    assert motion.jacobian(0.0)["tilt rate", "tilt-rate"] == 1.0
    with pytest.raises(rr.RimrollError, match="unknown parameter 'weight'"):
        motion.jacobian(0.3)["yaw", "weight"]
    with pytest.raises(rr.RimrollError, match="t must be inside the motion"):
        motion.jacobian(3.0)


def test_a_jacobian_says_what_it_is_of():
    motion = simulated(rr.NoSlip(), jacobian=True)
    one, several = repr(motion.jacobian(0.3)), repr(motion.jacobian([0.1, 0.2, 0.3]))
    assert one.startswith("<Jacobian at one time, shape (6, 12): d(tilt, tilt_rate, yaw, yaw_rate,")
    assert "transverse_inertia, axial_inertia, gravity)" in one
    assert several.startswith("<Jacobian at 3 times, shape (3, 6, 12): ")


def test_a_motion_is_the_same_with_its_derivatives():
    plain, with_them = simulated(rr.NoSlip()), simulated(rr.NoSlip(), jacobian=True)
    assert np.array_equal(plain.yaw, with_them.yaw)
    copy = pickle.loads(pickle.dumps(with_them))
    assert np.array_equal(copy.jacobian(1.0).values, with_them.jacobian(1.0).values)


def test_derivatives_that_there_are_not_are_refused():
    with pytest.raises(rr.RimrollError, match="jacobian=True"):
        simulated(rr.NoSlip()).jacobian(0.3)
    planar = dict.fromkeys(("yaw_rate", "spin_rate"), 0.0)
    with pytest.raises(rr.RimrollError, match="comes down flat and smoothly under friction"):
        simulated(rr.Coulomb(0.2), NUMBERS | planar, flat="smooth", jacobian=True)


@pytest.mark.parametrize(
    "law", [rr.Coulomb(0.2), rr.NoSlip() + rr.RollingResistance(dry=1e-3)], ids=["dry", "resisted"]
)
def test_a_motion_with_losses_has_derivatives_too(law):
    """The can slips before its near-collision, and rolls and slips again after it."""
    motion = simulated(law, duration=0.6, jacobian=True)
    width = 1e-5
    for name in ("tilt_rate", "height"):
        ends = [
            simulated(law, NUMBERS | {name: NUMBERS[name] + by}, duration=0.6)(0.6)
            for by in (-width, width)
        ]
        for quantity in QUANTITIES:
            before, after = (getattr(end, quantity) for end in ends)
            expected = (after - before) / (2.0 * width)
            # Differences err by about the square of the width over the height, and by rounding.
            found = motion.jacobian(0.6)[quantity, name]
            assert found == pytest.approx(expected, rel=1e-5, abs=1e-4)


def test_a_rim_that_never_slips_has_the_derivatives_of_rolling():
    t = 0.2
    dry, rolling = (
        simulated(law, duration=t, jacobian=True) for law in (rr.Coulomb(2.0), rr.NoSlip())
    )
    assert [phase.kind for phase in dry.phases] == ["rolling"]
    np.testing.assert_allclose(
        dry.jacobian(t).values, rolling.jacobian(t).values, rtol=1e-9, atol=1e-9
    )


LONG = """
import time
from given import ctrl_c
import rimroll as rr

start = rr.State(tilt=0.5, tilt_rate=-0.4, yaw_rate=0.2, spin_rate=0.4)
times = []
with ctrl_c.timed() as ready:

    def progress(t):
        if times and t < times[-1]:  # the motion is over, its derivatives begin
            ready()
        if t < max(times, default=0.0):
            time.sleep(0.01)  # so that they do not end before the signal comes
        times.append(t)

    rr.simulate(rr.bodies.can_2007(), start, rr.NoSlip(), 500, jacobian=True, progress=progress)
"""


@needs_signals
def test_ctrl_c_does_not_wait_for_the_derivatives():
    assert processor_time_after_ctrl_c(LONG) < 0.3


def test_progress_goes_through_the_motion_and_then_through_its_derivatives():
    times = []
    simulated(LAWS[0], duration=20.0, jacobian=True, progress=times.append)
    begins = times.index(0.0)
    motion, derivatives = times[:begins], times[begins:]
    assert motion == sorted(motion) and derivatives == sorted(derivatives)
    assert motion and len(derivatives) > 10 * len(motion) and derivatives[-1] == 20.0


def test_what_progress_raises_ends_the_derivatives():
    def stop(t):
        if t == 0.0:  # the first of the derivatives
            raise LookupError("enough")

    with pytest.raises(LookupError, match="enough"):
        simulated(LAWS[0], jacobian=True, progress=stop)
