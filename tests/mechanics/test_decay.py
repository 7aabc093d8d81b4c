"""The slow decay of steady motions, against whole motions with resistance."""

from dataclasses import replace

import numpy as np
import pytest

import rimroll as rr
from given.motions import CAN, DISK

MASS, RADIUS = 0.1, 0.03


def hollow(hole, length):
    """A ring with a hole of this part of its diameter, and this length over its diameter."""
    axial = 0.5 * MASS * RADIUS**2 * (1.0 + hole**2)
    across = 0.5 * axial + MASS * (2.0 * length * RADIUS) ** 2 / 12.0
    return rr.Body(MASS, RADIUS, length * RADIUS, across, axial)


RING = hollow(0.9, 0.1)


def wobble(body, tilt):
    """The steady motion with the centre of mass at rest."""
    rate = rr.steady_wobble_rate(body, tilt)
    spin = body.height / body.radius * rate * np.sin(tilt)
    (motion,) = rr.steady_motions(body, rr.NoSlip(), tilt, yaw_rate=rate, axial_spin=spin)
    return motion


def first_at(motion, tilt):
    """The event at which a motion first has a tilt."""
    return motion.crossings(lambda at: at.tilt - tilt)[0]


@pytest.mark.parametrize(
    "resistance",
    [
        rr.RollingResistance(dry=1e-3),
        rr.RollingResistance(viscous=1e-3),
        rr.AirDrag(1e-6, exponent=2.5),
        rr.AirDrag(1e-10),
    ],
    ids=["dry", "viscous", "boundary layer", "film"],
)
@pytest.mark.parametrize("body", [DISK, RING, CAN], ids=["disk", "ring", "can"])
def test_a_weak_resistance_leads_through_the_steady_motions_of_the_slow_decay(body, resistance):
    """The theory is of the first order in the resistance; this one takes 300 revolutions."""
    steady = wobble(body, 0.6 * rr.balance_tilt(body) if body.height > 0.0 else 0.5)
    unit = rr.decay(steady, rr.NoSlip() + resistance, until=0.05)
    factor = unit.t[-1] / (300.0 / steady.yaw_rate * 2.0 * np.pi)
    scaled = type(resistance)(
        **{
            name: value if name == "exponent" else factor * value
            for name, value in vars(resistance).items()
        }
    )
    law = rr.NoSlip() + scaled
    slow = rr.decay(steady, law, until=0.05)
    motion = rr.simulate(body, steady.start, law, 1.2 * slow.t[-1], rtol=1e-8)
    for part in 0.8, 0.5, 0.2:
        at = np.searchsorted(-slow.tilt, -part * steady.tilt)
        if at >= len(slow.tilt):
            continue
        reached = first_at(motion, slow.tilt[at])
        state, t = reached.state, reached.t
        spin = state.spin_rate + state.yaw_rate * np.cos(state.tilt)
        scale = abs(slow.yaw_rate[at]) * np.sin(state.tilt)
        assert t == pytest.approx(slow.t[at], abs=3e-3 * slow.t[-1])
        assert spin == pytest.approx(slow.axial_spin[at], abs=0.01 * scale)
        assert state.yaw_rate == pytest.approx(slow.yaw_rate[at], rel=0.01)


def test_the_end_and_the_exponents_of_a_decay():
    law = rr.NoSlip() + rr.RollingResistance(dry=1e-3)
    slow = rr.decay(wobble(DISK, 0.5), law)
    motion = rr.simulate(DISK, wobble(DISK, 0.5).start, law, 100.0, rtol=1e-8)
    assert slow.end == pytest.approx(motion.t[-1], rel=1e-3)
    for exponent, resistance in [
        (2 / 3, rr.RollingResistance(dry=1e-4)),
        (1 / 2, rr.RollingResistance(viscous=1e-4)),
        (4 / 9, rr.AirDrag(1e-8, exponent=2.5)),
        (1 / 3, rr.AirDrag(1e-12)),
    ]:
        slow = rr.decay(wobble(DISK, 0.5), rr.NoSlip() + resistance)
        # The core smooths the sign of dry resistance, which is 1e-3 of it at this tilt.
        assert slow.exponent[-10] == pytest.approx(exponent, abs=2e-3)


def test_rolling_friction_gives_way_to_air_at_the_crossover():
    """Where both take the same power: k m g R Ω = c Ω^(5/2), Ω² φ = m g R/A."""
    k, c, weight = 1e-4, 5e-8, DISK.mass * rr.STANDARD_GRAVITY
    rate = (k * weight * DISK.radius / c) ** (2 / 3)
    crossover = weight * DISK.radius / (DISK.transverse_inertia * rate**2)
    law = rr.NoSlip() + rr.RollingResistance(dry=k) + rr.AirDrag(c, exponent=2.5)
    slow = rr.decay(wobble(DISK, 0.5), law, until=1e-4 * crossover)

    def exponent(tilt):
        return np.interp(-tilt, -slow.tilt, slow.exponent)

    assert exponent(1e-3 * crossover) == pytest.approx(4 / 9, abs=0.005)
    # t_end − t = ∫ dφ (3/2) m g R/(k m g R Ω (1 + x)), with x = (φ/φ_x)^(−3/4) on the way down.
    x = np.linspace(0.0, 1.0, 20_001)[1:] ** 8
    left = np.trapezoid(np.sqrt(x) / (1.0 + x**-0.75), x)
    assert exponent(crossover) == pytest.approx(left * 2.0, abs=0.01)


def turning_tilts(body, law, size, end):
    """Tilts at which the yaw advance of a nutation falls below one revolution."""
    steady = wobble(body, np.radians(60.0))
    start = replace(steady.start, tilt=steady.tilt + size)
    motion = rr.simulate(body, start, law, end, rtol=1e-8)
    maxima = motion.crossings(lambda at: at.tilt_rate, rising=False)
    at = motion.evaluate([event.t for event in maxima])
    advance = np.diff(at.yaw) - 2.0 * np.pi
    return at.tilt[1:-1][(advance[:-1] > 0.0) & (advance[1:] <= 0.0)]


def test_a_ring_turns_back_where_its_slow_decay_meets_the_resonance_and_a_disk_does_not():
    law = rr.NoSlip() + rr.RollingResistance(dry=1e-3)
    slow = rr.decay(wobble(RING, np.radians(60.0)), law, until=0.05)
    found = turning_tilts(RING, law, 0.003, slow.t[-1])
    assert len(found) == 1
    # The tilt maximum is above the mean tilt, and the nutation shifts the resonance.
    assert found[0] == pytest.approx(slow.turning_tilt, rel=0.08)
    disk = hollow(0.0, 0.02)
    slow = rr.decay(wobble(disk, np.radians(60.0)), law, until=0.05)
    assert np.isnan(slow.turning_tilt)
    assert len(turning_tilts(disk, law, 0.003, slow.t[-1])) == 0


def test_the_mean_path_of_a_ring_bends_to_the_other_side_after_it_turns_back():
    law = rr.NoSlip() + rr.RollingResistance(dry=2e-3)
    steady = wobble(RING, np.radians(60.0))
    start = replace(steady.start, yaw_rate=1.1 * steady.yaw_rate)
    motion = rr.simulate(RING, start, law, 60.0, rtol=1e-8)
    maxima = motion.crossings(lambda at: at.tilt_rate, rising=False)
    at = motion.evaluate([event.t for event in maxima])
    moves = np.diff(at.contact_path, axis=0)
    bends = moves[:-1, 0] * moves[1:, 1] - moves[:-1, 1] * moves[1:, 0]
    above = np.diff(at.yaw)[:-1] > 2.0 * np.pi
    seen = at.tilt[2:] > 0.04
    near = np.abs(np.diff(at.yaw)[:-1] - 2.0 * np.pi) < 0.5
    assert (bends[seen & near & above] > 0.0).mean() > 0.9
    assert (bends[seen & ~above] < 0.0).mean() > 0.9
    assert (seen & ~above).sum() > 5


def test_the_curve_of_states_is_the_same_for_dry_and_viscous_rolling_resistance():
    found = [
        rr.decay(wobble(RING, 1.0), rr.NoSlip() + resistance, until=0.02)
        for resistance in (rr.RollingResistance(dry=1e-3), rr.RollingResistance(viscous=2e-5))
    ]
    np.testing.assert_allclose(found[0].axial_spin, found[1].axial_spin, rtol=1e-5, atol=1e-5)
    assert found[0].turning_tilt == pytest.approx(found[1].turning_tilt, rel=1e-5)


def test_pivoting_friction_brings_no_disk_to_rest():
    """It stops the turning about the vertical; then a wobble goes on almost without losses."""
    law = rr.NoSlip() + rr.PivotingFriction(2e-5)
    motion = rr.simulate(DISK, wobble(DISK, 0.3).start, law, 85.0, rtol=1e-8)
    assert motion.status == "finished"
    lost = np.interp([60.0, 85.0], motion.t, motion.resistance_loss)
    assert 0.05 * motion.energy[0] < lost[0] < 0.2 * motion.energy[0]
    assert lost[1] - lost[0] < 0.01 * lost[0]
    with pytest.raises(rr.RimrollError, match="without pivoting friction"):
        rr.decay(wobble(DISK, 0.3), law)


def test_what_is_refused():
    resisted = rr.NoSlip() + rr.RollingResistance(dry=1e-3)
    with pytest.raises(rr.RimrollError, match="with a resistance added"):
        rr.decay(wobble(DISK, 0.3), rr.NoSlip())
    with pytest.raises(rr.RimrollError, match="until must be inside"):
        rr.decay(wobble(DISK, 0.3), resisted, until=0.4)
    slow, _ = rr.steady_motions(DISK, rr.NoSlip(), 1.5, axial_spin=5.0)
    with pytest.raises(rr.RimrollError, match=r"is not stable at a tilt of 1\.5 rad"):
        rr.decay(slow, resisted)
