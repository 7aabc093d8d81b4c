"""Random releases have the distribution that they state."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy import stats
from scipy.spatial.transform import Rotation
from scipy.special import ndtr, ndtri

import rimroll as rr
from given.strategies import bodies, examples
from rimroll.experiment.release import MAX_TRIALS, PRESETS, _chance_below, normal_quantiles

CAN = rr.bodies.can_2007()
MANY = 20_000

WIDE = rr.Release(
    tilt=(0.5, 0.1),
    tilt_rate=(-3.0, 0.4),
    sideways=(0.2, 0.3),
    twist=(-0.1, 0.6),
    friction_scale=(1.0, 0.2),
)


def quantities(release, n, seed):
    """What was drawn, (5, n), with sideways and twist undone from the Euler rates."""
    start, scales = release.draw(n, seed)
    sideways = -np.sin(start.tilt) * start.spin_rate
    twist = start.yaw_rate + np.cos(start.tilt) * start.spin_rate
    return np.array([start.tilt, start.tilt_rate, sideways, twist, scales])


def test_means_and_spreads_are_those_given():
    drawn = quantities(WIDE, MANY, seed=1)
    for values, (mean, spread) in zip(drawn, vars(WIDE).values(), strict=True):
        # Tilts beyond 5 spreads and scales below 0 are cut off.
        assert stats.kstest((values - mean) / spread, "norm").pvalue > 1e-3
        assert values.mean() == pytest.approx(mean, abs=4.0 * spread / np.sqrt(MANY))
        assert values.std() == pytest.approx(spread, rel=4.0 / np.sqrt(2.0 * MANY))


def test_normal_numbers_are_right_from_the_first_to_the_last_chance_that_is_drawn():
    small = 2.0 ** np.linspace(-54.0, -1.0, 200)
    chances = np.concatenate([small, 1.0 - small[4:]])[:, None] * np.ones(2)
    assert normal_quantiles(chances) == pytest.approx(ndtri(chances), rel=1e-14, abs=1e-15)
    # An ulp of -30 changes the chance there by 1e-13 of it.
    assert _chance_below(-30.0) == pytest.approx(ndtr(-30.0), rel=4e-13, abs=0.0)


def test_the_quantities_are_independent():
    correlations = np.corrcoef(quantities(WIDE, MANY, seed=2))
    off_diagonal = correlations[~np.eye(5, dtype=bool)]
    assert np.abs(off_diagonal).max() < 4.5 / np.sqrt(MANY)


def test_trial_k_is_the_same_whatever_their_number():
    few, few_scales = WIDE.draw(7, seed=3)
    many, many_scales = WIDE.draw(400, seed=3)
    for name in ("tilt", "tilt_rate", "yaw_rate", "spin_rate"):
        assert np.array_equal(getattr(few, name), getattr(many, name)[:7])
    assert np.array_equal(few_scales, many_scales[:7])
    other, _ = WIDE.draw(7, seed=4)
    assert not np.array_equal(few.tilt, other.tilt)


@given(
    st.floats(0.05, 1.5),
    st.floats(-5.0, 5.0),
    st.floats(-2.0, 2.0),
    st.floats(-2.0, 2.0),
    st.floats(-3.0, 3.0),
)
def test_sideways_and_twist_are_the_angular_velocity_of_the_body(
    tilt, tilt_rate, sideways, twist, spin
):
    # A can at yaw 0 leans along −x: its contact point is at azimuth π. The paper's rotations: yaw
    # about z, −tilt about y, spin about z.
    release = rr.Release(tilt, tilt_rate, sideways, twist)
    start, _ = release.draw(1, seed=0)

    def attitude(t):
        yaw, spin_angle = start.yaw_rate[0] * t, spin + start.spin_rate[0] * t
        return Rotation.from_euler("ZYZ", [yaw, -(tilt + start.tilt_rate[0] * t), spin_angle])

    step = 1e-5
    turned = attitude(step) * attitude(-step).inv()
    omega = turned.as_rotvec() / (2.0 * step)
    # Rotation at −dφ/dt about y tilts; sideways is about the line of lean, x; twist about z.
    scale = 1.0 + np.abs([start.yaw_rate[0], start.spin_rate[0], tilt_rate]).max() ** 3
    np.testing.assert_allclose(omega, [sideways, -tilt_rate, twist], atol=1e-9 * scale)


def test_a_tilt_is_never_drawn_outside_upright_and_lying():
    wide = rr.Release(tilt=(0.1, 1.0))
    tilts = quantities(wide, MANY, seed=5)[0]
    assert 0.0 < tilts.min() < 0.01 and 1.55 < tilts.max() < 0.5 * np.pi
    low, high = -0.1, 0.5 * np.pi - 0.1
    assert stats.kstest(tilts - 0.1, stats.truncnorm(low, high).cdf).pvalue > 1e-3


def test_a_friction_scale_is_never_below_0():
    scales = quantities(rr.Release(0.5, friction_scale=(0.5, 1.0)), 1000, seed=6)[4]
    assert scales.min() == 0.0


def test_a_perfect_hand_does_the_same_each_time():
    release = rr.Release(0.4, -2.0)
    assert release.symmetric and release.tilt == (0.4, 0.0) and release.friction_scale == (1.0, 0.0)
    start, scales = release.draw(5, seed=7)
    assert set(start.tilt) == {0.4} and set(start.tilt_rate) == {-2.0} and set(scales) == {1.0}
    assert not np.any(start.yaw_rate) and not np.any(start.spin_rate)


def test_an_unsteady_hand_scatters_more_to_the_sides_only():
    hand = WIDE.with_unsteadiness(3.0)
    assert hand.sideways == (0.2, pytest.approx(0.9)) and hand.twist == (-0.1, pytest.approx(1.8))
    assert (hand.tilt, hand.tilt_rate, hand.friction_scale) == (
        WIDE.tilt,
        WIDE.tilt_rate,
        WIDE.friction_scale,
    )


@examples(20)
@given(bodies(), st.sampled_from([rr.NoSlip(), rr.Frictionless(), rr.Coulomb(0.3)]), st.data())
def test_a_mirrored_release_falls_to_the_mirror_image(body, law, data):
    gravity = 9.8
    release = rr.Release.named("let_go", body, gravity)
    slow = release.sideways[1]
    sideways = data.draw(st.floats(-3.0, 3.0)) * slow
    twist = data.draw(st.floats(-3.0, 3.0)) * slow + 0.01 * slow
    ends = [
        rr.ensemble(
            body,
            rr.Release(release.tilt[0], -slow, side * sideways, side * twist).draw(1, 0)[0],
            law,
            duration=20.0 * np.sqrt(body.radius / gravity),
            max_steps=5000,
        )
        for side in (1.0, -1.0)
    ]
    assert ends[0]["outcome"].item() == ends[1]["outcome"].item()
    # Not to the last bit: where the rim sticks and slips, roundings of the two sides differ.
    np.testing.assert_allclose(ends[0]["turn"], -ends[1]["turn"], rtol=1e-6)
    np.testing.assert_allclose(ends[0]["min_tilt"], ends[1]["min_tilt"], rtol=1e-6)


TABLES = (rr.NoSlip(), rr.Frictionless(), rr.Coulomb(0.15), rr.Coulomb(0.6))


def share(body, law, release, word):
    """The number of 60 releases with that outcome."""
    falls = rr.topple(body, law, 60, release, seed=1)
    return float((falls["outcome"] == word).mean())


def test_names_of_releases_are_written_as_those_of_bodies_and_laws_are():
    assert all(name.isidentifier() for name in PRESETS)


@pytest.mark.parametrize("law", TABLES, ids=str)
@pytest.mark.parametrize("name", rr.bodies.PRESETS)
def test_every_body_rocks_when_it_is_let_go(name, law):
    assert share(rr.bodies.by_name(name), law, "let_go", "rocked") == 1.0


TALL = ("can_2007", "soda_can", "beer_bottle", "battery")


@pytest.mark.parametrize("law", TABLES, ids=str)
@pytest.mark.parametrize("name", rr.bodies.PRESETS)
def test_what_is_tall_topples_when_it_is_flicked_and_what_is_flat_rocks(name, law):
    body = rr.bodies.by_name(name)
    if name in TALL:
        # Without friction, flicks turn less of their energy into tipping over.
        least = 0.3 if isinstance(law, rr.Frictionless) else 0.95
        assert share(body, law, "flick", "toppled") >= least
    else:
        assert share(body, law, "flick", "rocked") >= 0.95


@pytest.mark.parametrize("law", TABLES, ids=str)
def test_the_papers_can_topples_from_the_papers_release(law):
    assert share(CAN, law, "paper", "toppled") >= 0.95


@examples(50)
@given(bodies(), st.sampled_from(list(PRESETS)), st.sampled_from([1.62, 9.8]))
def test_presets_are_releases_of_any_body(body, name, gravity):
    release = rr.Release.named(name, body, gravity)
    assert release.symmetric
    assert release.sideways[1] > 0.0 and release.twist[1] > 0.0
    if name == "flick":
        assert release.tilt_rate[0] < 0.0


def test_presets_are_found_however_they_are_typed():
    for name in ("let go", "let-go", "Let_Go", "letgo"):
        assert rr.Release.named(name, CAN) == rr.Release.named("let_go", CAN)
    with pytest.raises(rr.RimrollError, match="did you mean 'flick'"):
        rr.Release.named("flik", CAN)
    with pytest.raises(rr.RimrollError, match="body must be a rimroll"):
        rr.Release.named("flick", "can")


def test_parameters_name_means_and_spreads():
    parameters = WIDE.parameters()
    assert parameters["release_tilt"] == 0.5 and parameters["release_tilt_spread"] == 0.1
    assert (
        parameters["release_twist"] == -0.1 and parameters["release_friction_scale_spread"] == 0.2
    )
    assert len(parameters) == 10


@pytest.mark.parametrize(
    ("wrong", "words"),
    [
        ({"tilt": 0.0}, "tilt must be inside"),
        ({"tilt": 1.6}, "tilt must be inside"),
        ({"tilt": (20, 2)}, r'got 20 rad: for degrees write np.radians\(20\) or "20 deg"$'),
        ({"tilt": (0.3, -0.1)}, "tilt_spread must be finite and >= 0"),
        ({"tilt": (0.3, 0.1, 0.1)}, r"tilt must be \(mean, spread\) or a mean"),
        ({"tilt": "steep"}, "tilt must be an angle"),
        ({"tilt": 0.3, "twist": np.inf}, "twist must be finite"),
        ({"tilt": 0.3, "sideways": (0.0, np.nan)}, "sideways_spread must be finite"),
        ({"tilt": 0.3, "friction_scale": 0.0}, "friction_scale must be > 0"),
    ],
)
def test_what_is_no_release_is_refused_with_a_sentence(wrong, words):
    with pytest.raises(rr.RimrollError, match=words):
        rr.Release(**wrong)


@pytest.mark.parametrize(
    ("n", "seed", "words"),
    [
        (0, 1, "n must be a whole number"),
        (1.5, 1, "n must be a whole number"),
        (MAX_TRIALS + 1, 1, "n must be at most"),
        (1, -1, "seed must be a whole number"),
        (1, 1.0, "seed must be a whole number"),
        (1, True, "seed must be a whole number"),
        (1, 2**63, "seed must be a whole number"),
    ],
)
def test_what_cannot_be_drawn_is_refused_with_a_sentence(n, seed, words):
    with pytest.raises(rr.RimrollError, match=words):
        WIDE.draw(n, seed)
