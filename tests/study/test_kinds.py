"""Each kind of study has the numbers of the function that it stands for."""

import numpy as np
import pytest

import rimroll as rr

COLUMN = {"preset": "cylinder", "radius": "0.5 m", "length": "4 m"}


def same(plan, columns, dataset):
    for name, one in plan.columns.items():
        if one.flags:
            assert (np.array(one.flags)[columns[name]] == dataset[name].values.ravel()).all(), name
        else:
            assert np.array_equal(columns[name], dataset[name].values.ravel(), equal_nan=True), name


def test_turns_by_quadrature():
    tilts = np.linspace(0.1, 0.5, 7)
    study = rr.Study(
        kind="exact_turn",
        body={"preset": "can_2007"},
        law="frictionless",
        start={"tilt": 0.3, "yaw_rate": 0.02},
        axes={"start.tilt": tilts, "simulation.gravity": [9.8, 1.62]},
    )
    plan = study.plan()
    columns = plan.compute(0, 14)
    for k, gravity in enumerate([9.8, 1.62]):
        start = rr.State(tilt=tilts, yaw_rate=0.02)
        turns = rr.exact_turn(rr.bodies.can_2007(), start, rr.Frictionless(), gravity=gravity)
        for name in ("turn", "min_tilt", "end_time"):
            assert np.array_equal(columns[name][k::2], getattr(turns, name)), name
        words = np.array(plan.columns["outcome"].flags)[columns["outcome"][k::2]]
        assert (words == turns.outcome).all()


def test_shaken_columns_over_scales_and_laws():
    laws = [{"kind": "coulomb", "friction": 0.5}, "no_slip"]
    study = rr.Study(
        kind="shake",
        body=COLUMN,
        ground={"pulse": "sine", "amplitude": "0.3 g", "period": "1 s"},
        simulation={"flat": "housner", "flat_gap": "0.1 mm"},
        axes={
            "law": laws,
            "strength": {"of": "ground.scale", "log_range": [0.5, 3.0], "number": 4},
        },
    )
    plan = study.plan()
    assert plan.coords["law"].values.tolist() == ["coulomb friction=0.5", "no_slip"]
    columns = plan.compute(0, 8)
    body, ground = rr.bodies.cylinder(0.5, 4.0), rr.ground.sine("0.3 g", 1.0)
    scale = plan.coords["strength"].values
    for k, law in enumerate((rr.Coulomb(0.5), rr.NoSlip())):
        shaken = rr.shake_many(
            body, rr.State.standing(), law, ground, scale=scale, flat="housner", flat_gap=1e-4
        )
        same(plan, {name: one[4 * k : 4 * k + 4] for name, one in columns.items()}, shaken)


def test_synthetic_records_and_records_of_files(tmp_path):
    (tmp_path / "quake.csv").write_text(
        "t,x\n" + "".join(f"{k / 50},{np.sin(k / 9):.6f}\n" for k in range(200)), "utf-8"
    )
    content = {
        "kind": "shake",
        "body": COLUMN,
        "axes": {
            "quake": {
                "of": "ground",
                "values": [
                    {"synthetic": 3, "amplitude": "0.4 g", "duration": "5 s"},
                    {"record": "quake.csv", "units": "m/s^2"},
                ],
                "labels": ["noise", "wave"],
            }
        },
    }
    plan = rr.Study.from_dict({"study": content, "folder": str(tmp_path)}).plan()
    assert '"quake.csv": "' in plan.attrs["records"]
    columns = plan.compute(0, 2)
    grounds = [
        rr.ground.synthetic(3, "0.4 g", duration=5.0),
        rr.ground.read(tmp_path / "quake.csv", units="m/s^2"),
    ]
    body = rr.bodies.cylinder(0.5, 4.0)
    same(plan, columns, rr.shake_many(body, rr.State.standing(), rr.NoSlip(), grounds))


def test_zipped_axes_go_along_one_dimension():
    study = rr.Study(
        body={"preset": "can_2007"},
        law="coulomb",
        start={"tilt": 0.3, "yaw_rate": 0.02},
        axes={"law.friction": [0.1, 0.2, 0.3], "start.tilt": ["15 deg", "16 deg", "17 deg"]},
        combine="zip",
    )
    plan = study.plan()
    assert dict(plan.dims) == {"case": 3}
    assert plan.coords["tilt"].dims == ("case",)
    np.testing.assert_allclose(plan.coords["tilt"].values, np.radians([15.0, 16.0, 17.0]))
    starts = rr.State(tilt=plan.coords["tilt"].values, yaw_rate=0.02)
    falls = rr.ensemble(rr.bodies.can_2007(), starts, rr.Coulomb([0.1, 0.2, 0.3]))
    same(plan, plan.compute(0, 3), falls)


def test_presets_and_their_numbers_vary():
    study = rr.Study(
        body={"preset": "soda_can"},
        start={"tilt": 0.1, "yaw_rate": 0.02},
        axes={"body.fill": [0.0, 0.5, 1.0], "body.factors.mass": [1.0, 2.0]},
    )
    plan = study.plan()
    cans = [rr.bodies.soda_can(fill) for fill in (0.0, 0.0, 0.5, 0.5, 1.0, 1.0)]
    stacked = rr.Body.stack(cans)
    factors = np.array([1.0, 2.0] * 3)
    body = rr.Body(
        stacked.mass * factors,
        stacked.radius,
        stacked.height,
        stacked.transverse_inertia,
        stacked.axial_inertia,
    )
    falls = rr.ensemble(body, rr.State(tilt=0.1, yaw_rate=0.02), rr.NoSlip())
    same(plan, plan.compute(0, 6), falls)


def test_hands_differ_from_body_to_body_and_may_be_unsteady():
    study = rr.Study(
        kind="topple",
        body={"preset": "coin"},
        law={"kind": "coulomb", "friction": 0.3},
        release="let_go",
        axes={"body.preset": ["coin", "can_2007"], "release.unsteadiness": [1.0, 3.0]},
        sampling="common",
        trials=6,
        seed=8,
    )
    plan = study.plan()
    columns = plan.compute(0, plan.rows)
    for k, body in enumerate((rr.bodies.coin(), rr.bodies.can_2007())):
        hand = rr.Release.named("let_go", body)
        for j, release in enumerate((hand, hand.with_unsteadiness(3.0))):
            falls = rr.topple(body, rr.Coulomb(0.3), 6, release, seed=8)
            here = slice(6 * (2 * k + j), 6 * (2 * k + j + 1))
            same(plan, {name: one[here] for name, one in columns.items()}, falls)


@pytest.mark.parametrize(
    "given",
    [
        {"body": rr.bodies.coin(), "law": rr.Coulomb(0.3) + rr.RollingResistance(dry=1e-4)},
        {"start": rr.State(tilt="20 deg", spin_rate=0.1), "body": rr.bodies.can_2007()},
        {"law": rr.Stribeck(0.2, static=0.4, stribeck_speed=0.1), "body": rr.bodies.can_2007()},
    ],
)
def test_objects_of_rimroll_describe_a_study_exactly(given):
    start = given.get("start", rr.State(tilt=0.1, yaw_rate=0.02))
    law = given.get("law", rr.NoSlip())
    plan = rr.Study(**({"start": start} | given)).plan()
    falls = rr.ensemble(
        given["body"],
        rr.State(
            tilt=[start.tilt], tilt_rate=0.0, yaw_rate=start.yaw_rate, spin_rate=start.spin_rate
        ),
        law,
    )
    same(plan, plan.compute(0, 1), falls)


@pytest.fixture(scope="module")
def fits():
    axes = {"fit.falls": [12, 30], "law.friction": [0.05, 0.2]}
    return rr.Study(kind="fit", body={"preset": "can_2007"}, axes=axes, trials=2, seed=1).plan()


@pytest.mark.slow
def test_fits_depend_on_no_chunk_and_find_the_friction(fits):
    found = fits.compute(0, 8)
    for name, one in fits.compute(3, 6).items():
        assert np.array_equal(one, found[name][3:6], equal_nan=True), name
    assert found["fitted_falls"].tolist() == [12] * 4 + [30] * 4
    true = np.tile([0.05, 0.05, 0.2, 0.2], 2)
    assert np.abs(found["fitted_friction"] - true).max() < 0.08
    for name in ("fitted_friction_chance", "fitted_bias_chance"):
        assert ((found[name] > 0.0) & (found[name] <= 1.0)).all()


@pytest.mark.slow
def test_an_experiment_is_fitted_as_by_fit(fits, monkeypatch):
    from rimroll.study import kinds

    given = []

    class Spied(kinds.Likelihood):
        def __init__(self, predicted, directions):
            given.append((predicted, directions))
            super().__init__(predicted, directions)

    monkeypatch.setattr(kinds, "Likelihood", Spied)
    found = fits.compute(6, 7)
    ((predicted, directions),) = given
    fitted = rr.fit(predicted.body, directions, predicted=predicted)
    assert fitted.friction.friction == pytest.approx(found["fitted_friction"][0], abs=1e-4)
