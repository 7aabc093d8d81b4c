"""Many motions on moving tables, each as simulate gives it."""

from __future__ import annotations

import numpy as np
import pytest

import rimroll as rr

COLUMN = rr.Body(1000, 0.5, 2.0, 1395.8333333333333, 125.0)
SINE = rr.ground.sine((3.0, 1.5, 2.0), (1.2, 0.8, 0.5), (1, 1, 2))
STANDING = rr.State.standing()


def record(seed: int) -> rr.Ground:
    samples = 4.0 * np.random.default_rng(seed).standard_normal((40, 3))
    return rr.ground.sampled(0.05, samples)


def test_rows_are_what_simulate_gives() -> None:
    grounds = [SINE, record(0), record(1), SINE]
    starts = rr.State(tilt=np.array([0.02, 0.05, 0.1, 0.2]), yaw=0.3)
    scale = np.array([0.5, 1.0, 0.7, 1.5])
    law = rr.Coulomb(np.array([0.3, 0.6, 0.1, 0.5]))
    shaken = rr.shake_many(COLUMN, starts, law, grounds, scale=scale, duration=3.0, flat="housner")
    for row, ground in enumerate(grounds):
        motion = rr.simulate(
            COLUMN,
            rr.State(tilt=float(np.asarray(starts.tilt)[row]), yaw=0.3),
            rr.Coulomb(float(np.asarray(law.numbers["friction"])[row])),
            duration=3.0,
            rtol=1e-8,
            ground=ground.scaled(scale[row]),
            flat="housner",
        )
        one = shaken.isel(trial=row)
        assert str(one["status"].item()) == motion.status
        assert one["steps"].item() == motion.stats.steps
        # A body that topples then lies on its side, which changes only its velocity.
        assert one["end_time"].item() == motion.t[-1]
        assert one["end_tilt"].item() == pytest.approx(motion.tilt[-1], abs=1e-14)
        assert one["max_tilt"].item() == motion.max_tilt >= motion.tilt.max()
        assert one["ground_work"].item() == motion.ground_work[-1]
        # The footprint is R from the contact point toward the axis.
        heading = np.stack([np.cos(motion.yaw), np.sin(motion.yaw)], axis=-1)
        footprint = motion.contact_path + 0.5 * heading
        moved = [one["end_x"].item(), one["end_y"].item()]
        np.testing.assert_allclose(moved, footprint[-1] - footprint[0], atol=1e-12)
        turned = (motion.yaw + motion.spin)[-1] - (motion.yaw + motion.spin)[0]
        assert one["end_yaw"].item() == pytest.approx(turned, abs=1e-12)
        assert one["overturned"].item() is bool(motion.overturned)
        assert one["undecided"].item() is (motion.overturned is None)
        assert one["stands"].item() is motion.stands
        assert np.isnan(one["residual_yaw"].item()) == (motion.residual_yaw is None)
    assert shaken["overturned"].any()
    assert not shaken["overturned"].all()


def test_the_number_of_threads_changes_no_bit() -> None:
    grounds = [record(seed) for seed in range(12)]
    one, three = (
        rr.shake_many(COLUMN, STANDING, rr.NoSlip(), grounds, flat="smooth", threads=threads)
        for threads in (1, 3)
    )
    assert one.identical(three)


@pytest.mark.parametrize(
    ("body", "ratio", "gravity", "least"),
    [
        (COLUMN, 1.2, 9.81, 0.944283985340178271),
        (COLUMN, 1.5, 9.81, 0.580520881038642924),
        (rr.bodies.can_2007(), 2.0, 9.8, 0.0854629901171597591),
    ],
)
def test_the_least_duration_of_a_rectangular_pulse(
    body: rr.Body, ratio: float, gravity: float, least: float
) -> None:
    """Exact by quadrature of the planar motion about the rim; the amplitude is ratio g R/H."""
    amplitude = ratio * gravity * body.radius / body.height
    durations = least * (1.0 + np.array([-1e-3, -1e-7, 1e-7, 1e-3]))
    grounds = [rr.ground.rectangular(amplitude, duration) for duration in durations]
    options = {"flat": "housner", "gravity": gravity, "rtol": 1e-11, "duration": 20.0}
    shaken = rr.shake_many(body, STANDING, rr.NoSlip(), grounds, **options)  # type: ignore[arg-type]
    assert list(shaken["overturned"].values) == [False, False, True, True]
    assert np.all(shaken["uplift_time"] == 0.0)
    # The least pulse leaves the body at the balance tilt.
    assert shaken["max_tilt_ratio"].values[1] == pytest.approx(1.0, abs=1e-3)


def test_grounds_by_name_and_scales_are_dimensions() -> None:
    grounds = {"sine": SINE, "record": record(2)}
    scale = rr.axis("scale", [0.1, 1.0, 2.0])
    shaken = rr.shake_many(COLUMN, STANDING, rr.NoSlip(), grounds, scale=scale, flat="smooth")
    assert shaken["overturned"].dims == ("ground", "scale")
    assert list(shaken["ground"].values) == ["sine", "record"]
    one = rr.shake_many(COLUMN, STANDING, rr.NoSlip(), SINE.scaled(2.0), flat="smooth")
    assert shaken["max_tilt"].sel(ground="sine", scale=2.0).item() == one["max_tilt"].item()
    listed = rr.shake_many(
        COLUMN, STANDING, rr.NoSlip(), list(grounds.values()), scale=scale, flat="smooth"
    )
    np.testing.assert_array_equal(listed["max_tilt"].values, shaken["max_tilt"].values)


def test_units_are_named_and_converted() -> None:
    shaken = rr.shake_many(
        COLUMN, rr.State(tilt="2 deg"), rr.NoSlip(), SINE, duration="500 ms", gravity="981 cm/s2"
    )
    assert shaken["end_time"].item() == 0.5
    assert shaken["start_tilt"].item() == np.radians(2.0)
    assert shaken["residual_x"].attrs["units"] == "m"
    assert shaken["ground_work"].attrs["units"] == "J"
    assert shaken.attrs["gravity"] == 9.81


def test_the_duration_of_the_options_counts_unless_another_is_given() -> None:
    ground, start = rr.ground.sine(amplitude=1.0, period=1.0), rr.State(tilt=0.05, yaw_rate=0.1)
    options = rr.Options(duration=0.4)
    for duration, expected in ((None, 0.4), (0.3, 0.3)):
        found = rr.shake_many(
            COLUMN, start, rr.NoSlip(), ground, duration=duration, options=options
        )
        assert found.end_time.item() == expected


def test_a_body_below_the_threshold_of_uplift_stands() -> None:
    shaken = rr.shake_many(COLUMN, STANDING, rr.NoSlip(), rr.ground.sine(2.4, 1.0))
    assert np.isnan(shaken["uplift_time"].item())
    assert shaken["max_tilt"].item() == shaken["residual_displacement"].item() == 0.0
    # The default is the duration of the ground and 20/p.
    p = rr.rocking_frequency(COLUMN)
    assert shaken["end_time"].item() == pytest.approx(1.0 + 20.0 / p)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"scale": 0.0}, "scale must be > 0"),
        ({"scale": np.array([1.0, 1e9])}, r"scale\[1\] must be between"),
        ({"duration": -1.0}, "duration must be > 0"),
        ({"grounds": []}, "grounds must be one or more"),
        ({"grounds": "el centro"}, "grounds must be a rimroll.Ground"),
        ({"grounds": [SINE, 3.0]}, r"grounds\[1\] must be a rimroll.Ground"),
        ({"starts": rr.State(tilt=np.array([0.1, 2.0]))}, r"tilt\[1\] must be below"),
        ({"grounds": [SINE, SINE], "scale": np.ones(3)}, "arrays must broadcast"),
        ({"scale": np.ones((2, 2))}, "must be flat arrays"),
        ({"flat": "hop"}, "flat must be one of"),
        ({"flat_gap": "1 m"}, "flat_gap must be between 0 and .*, a tenth of the radius, got 1 m"),
        ({"flat_gap": "1 s"}, '"s" does not measure a length'),
    ],
)
def test_refusals(arguments: dict[str, object], message: str) -> None:
    given = {"starts": STANDING, "grounds": SINE} | arguments
    starts, grounds = given.pop("starts"), given.pop("grounds")
    with pytest.raises(rr.RimrollError, match=message):
        rr.shake_many(COLUMN, starts, rr.NoSlip(), grounds, **given)  # type: ignore[arg-type]


def test_progress_and_interruption() -> None:
    seen: list[tuple[int, int]] = []
    grounds = [record(seed) for seed in range(5)]

    def note(done: int, count: int) -> None:
        seen.append((done, count))

    rr.shake_many(COLUMN, STANDING, rr.NoSlip(), grounds, flat="smooth", progress=note)
    assert seen[-1] == (5, 5)

    def stop(done: int, count: int) -> None:
        raise KeyboardInterrupt

    many = [record(seed) for seed in range(5)] * 400
    with pytest.raises(rr.Interrupted) as interrupted:
        rr.shake_many(COLUMN, STANDING, rr.NoSlip(), many, flat="smooth", progress=stop)
    assert interrupted.value.done.sizes["trial"] < len(many)
