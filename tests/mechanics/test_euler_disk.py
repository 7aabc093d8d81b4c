"""Euler's disk: it wobbles faster and faster until it rests.

A uniform disk that lies nearly flat at a tilt α wobbles at Ω² = 4 g/(R α), and its energy is
(3/2) m g R α. Losing a power ~ Ω^λ it goes down as α ~ (t₀ − t)^(2/(2+λ)).
"""

import numpy as np
import pytest

import rimroll as rr

DISK = rr.bodies.disk(0.0375)


def wobble(tilt):
    """The steady wobble at a tilt (rad): the centre of mass at rest, and without spin."""
    rate = rr.steady_wobble_rate(DISK, tilt)
    return rr.State(tilt=tilt, yaw_rate=rate, spin_rate=-rate * np.cos(tilt))


def run_down(law, tilt=0.1):
    return rr.simulate(DISK, wobble(tilt), law, 500.0, rtol=1e-9)


def exponent(motion):
    """Slope of ln α over ln(t₀ − t) while the tilt falls from a half to a tenth of the first.

    t₀ is the motion's end. At the beginning of the window the law of the wobble, above, is off by
    some 1e-3, and at its end the disk no longer goes down slowly beside its wobble. Hence a
    tolerance of 0.004.
    """
    t = np.linspace(0.0, motion.t[-1], 20_001)
    tilt = motion.evaluate(t).tilt
    window = (tilt < 0.5 * tilt[0]) & (tilt > 0.1 * tilt[0])
    return np.polyfit(np.log(motion.t[-1] - t[window]), np.log(tilt[window]), 1)[0]


@pytest.mark.parametrize("law", [rr.NoSlip(), rr.Coulomb(0.3)], ids=lambda law: law.name)
@pytest.mark.parametrize(
    ("resistance", "power"),
    [
        (rr.RollingResistance(dry=1e-4), 1.0),
        (rr.RollingResistance(viscous=3e-5), 2.0),
        (rr.AirDrag(1e-8, exponent=2.5), 2.5),
        (rr.AirDrag.film(DISK.radius), 4.0),
    ],
    ids=["dry", "viscous", "boundary layer", "film"],
)
def test_each_way_of_losing_energy_has_its_exponent(law, resistance, power):
    motion = run_down(law + resistance)
    assert motion.status in ("at_rest", "face_down")
    assert exponent(motion) == pytest.approx(2.0 / (2.0 + power), abs=0.004)


def test_friction_alone_does_not_stop_a_disk_that_rolls():
    """A steady wobble needs no friction: the rim sticks, and nothing is lost."""
    motion = rr.simulate(DISK, wobble(0.1), rr.Coulomb(0.3), 5.0)
    assert [phase.kind for phase in motion.phases] == ["rolling"]
    assert np.ptp(motion.energy) < 1e-9 * motion.energy[0]


def test_a_disk_goes_to_rest_through_dozens_of_slip_and_roll_phases():
    start = wobble(0.3)
    nutating = rr.State(tilt=0.3, yaw_rate=start.yaw_rate, spin_rate=1.03 * start.spin_rate)
    law = rr.Coulomb(0.3) + rr.RollingResistance(dry=2e-4)
    motion = rr.simulate(DISK, nutating, law, 100.0, rtol=1e-9)
    kinds = [event.kind for event in motion.events]
    assert motion.status == "at_rest"
    assert min(kinds.count("slip"), kinds.count("stick")) > 24
    assert kinds[-1] == "rest"
    assert np.ptp(motion.energy_budget) < 1e-9 * motion.energy[0]
    assert motion.friction_loss[-1] > 0.0
    lost = motion.friction_loss[-1] + motion.resistance_loss[-1] + motion.impact_loss[-1]
    assert lost == pytest.approx(motion.energy[0], rel=2e-3)


def test_the_power_of_each_resistance_is_what_it_says():
    """At the start: rates of the energy budget by small differences."""
    start, dt = wobble(0.2), 1e-7
    weight = DISK.mass * rr.STANDARD_GRAVITY
    for resistance, power in [
        (rr.RollingResistance(dry=1e-3), 1e-3 * weight * DISK.radius * abs(start.spin_rate)),
        (rr.RollingResistance(viscous=1e-4), 1e-4 * (DISK.radius * start.spin_rate) ** 2),
        (rr.AirDrag(1e-9, 4.0), 1e-9 * start.yaw_rate**4),
        (
            rr.PivotingFriction(1e-4),
            1e-4 * weight * (start.yaw_rate + start.spin_rate * np.cos(0.2)),
        ),
    ]:
        motion = rr.simulate(DISK, start, rr.NoSlip() + resistance, dt, rtol=1e-12)
        # The normal force is the weight to 1e-3: the resistance itself begins to tip the disk.
        assert motion.resistance_loss[-1] / dt == pytest.approx(power, rel=2e-3), resistance
