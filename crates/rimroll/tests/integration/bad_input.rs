//! Every error message names the field, the value, the bound and the unit.

use core::f64::consts::{FRAC_PI_2, PI};
use core::ops::ControlFlow;
use rimroll::steady::steady_wobble_rate;
use rimroll::turn::{
    NearCollision, disk_turn_limit, error_law, error_law_coefficient, lift_off_rate,
    point_mass_turn_limit, slip_rate, turn_limit_with_spin,
};
use rimroll::{Body, IdealLaw, InvalidInput, Options, Solid, State, presets, simulate};

const NAN: f64 = f64::NAN;
const INFINITE: f64 = f64::INFINITY;

/// The text of the error.
fn refusal<T>(result: Result<T, InvalidInput>) -> String {
    match result {
        Ok(_) => "accepted".to_owned(),
        Err(error) => error.to_string(),
    }
}

fn can() -> Body {
    presets::can_2007().expect("the paper's can")
}

#[test]
fn a_body_needs_positive_mass_radius_and_inertias() {
    let cases = [
        ([0.0, 0.05, 0.07, 4e-4, 1e-4], "mass must be > 0, got 0 kg"),
        (
            [-0.5, 0.05, 0.07, 4e-4, 1e-4],
            "mass must be > 0, got -0.5 kg",
        ),
        ([0.07, 0.0, 0.07, 4e-4, 1e-4], "radius must be > 0, got 0 m"),
        (
            [0.07, -0.1, 0.07, 4e-4, 1e-4],
            "radius must be > 0, got -0.1 m",
        ),
        (
            [0.07, 0.05, -0.01, 4e-4, 1e-4],
            "height must be >= 0, got -0.01 m",
        ),
        (
            [0.07, 0.05, 0.07, 0.0, 1e-4],
            "transverse_inertia must be > 0, got 0 kg m2",
        ),
        (
            [0.07, 0.05, 0.07, 4e-4, -1e-4],
            "axial_inertia must be > 0, got -0.0001 kg m2",
        ),
        (
            [NAN, 0.05, 0.07, 4e-4, 1e-4],
            "mass must be a finite number, got NaN",
        ),
        (
            [0.07, INFINITE, 0.07, 4e-4, 1e-4],
            "radius must be a finite number, got inf",
        ),
        (
            [0.07, 0.05, -INFINITE, 4e-4, 1e-4],
            "height must be a finite number, got -inf",
        ),
        (
            [0.07, 0.05, 0.07, NAN, 1e-4],
            "transverse_inertia must be a finite number, got NaN",
        ),
        (
            [0.07, 0.05, 0.07, 4e-4, NAN],
            "axial_inertia must be a finite number, got NaN",
        ),
    ];
    for ([m, r, h, a, c], message) in cases {
        assert_eq!(refusal(Body::new(m, r, h, a, c)), message);
    }
}

/// A moment of inertia given per unit mass by mistake usually violates this bound.
#[test]
fn no_rigid_body_has_an_axial_inertia_above_twice_the_transverse() {
    assert_eq!(
        refusal(Body::new(0.07, 0.051, 0.069, 3.5e-4, 8e-3)),
        "axial_inertia must be at most 2 transverse_inertia = 0.0007 kg m2 (no rigid body has more), \
         got 0.008 kg m2"
    );
    // A flat body lies on the bound, and its two moments of inertia are rounded separately.
    for i in 1..100 {
        let a = 1e-4 / f64::from(i);
        let disk = Body::new(0.07, 0.051, 0.0, a, (2.0 * a).next_up());
        assert_eq!(refusal(disk), "accepted");
    }
}

#[test]
fn a_body_of_solids_needs_solids_over_its_base() {
    assert_eq!(
        refusal(Body::from_solids(0.05, &[])),
        "solids must name at least one solid, got none"
    );
    let below = Solid::disk(1.0, 0.05, -0.02).expect("a disk under the table");
    assert_eq!(
        refusal(Body::from_solids(0.05, &[below])),
        "height must be >= 0, got -0.02 m"
    );
    let disk = Solid::disk(1.0, 0.05, 0.02).expect("a disk");
    assert_eq!(
        refusal(Body::from_solids(0.0, &[disk])),
        "radius must be > 0, got 0 m"
    );
}

#[test]
fn solids_need_sizes() {
    let cases = [
        (
            Solid::cylinder(0.0, 0.1, 0.1, 0.0),
            "mass must be > 0, got 0 kg",
        ),
        (Solid::disk(-1.0, 0.1, 0.0), "mass must be > 0, got -1 kg"),
        (
            Solid::ring(NAN, 0.1, 0.0),
            "mass must be a finite number, got NaN",
        ),
        (
            Solid::cylinder(1.0, 0.0, 0.1, 0.0),
            "radius must be > 0, got 0 m",
        ),
        (
            Solid::cylinder(1.0, 0.1, -0.1, 0.0),
            "length must be >= 0, got -0.1 m",
        ),
        (
            Solid::disk(1.0, 0.1, NAN),
            "base must be a finite number, got NaN",
        ),
        (
            Solid::hollow_cylinder(1.0, -0.1, 0.1, 0.1, 0.0),
            "inner_radius must be >= 0, got -0.1 m",
        ),
        (
            Solid::hollow_cylinder(1.0, 0.2, 0.1, 0.1, 0.0),
            "inner_radius must be at most outer_radius = 0.1 m, got 0.2 m",
        ),
        (
            Solid::filling(0.0, 0.1, 0.1, 0.0),
            "density must be > 0, got 0 kg/m3",
        ),
        (
            Solid::filling(1000.0, -0.1, 0.1, 0.0),
            "radius must be > 0, got -0.1 m",
        ),
        (
            Solid::filling(1000.0, 0.1, 0.0, 0.0),
            "depth must be > 0, got 0 m",
        ),
    ];
    for (solid, message) in cases {
        assert_eq!(refusal(solid), message);
    }
}

#[test]
fn presets_refuse_impossible_fillings_and_sizes() {
    for (body, message) in [
        (
            presets::soda_can(1.5),
            "fill must be between 0 and 1, got 1.5",
        ),
        (
            presets::beer_bottle(-0.1),
            "fill must be between 0 and 1, got -0.1",
        ),
        (presets::cylinder(0.0, 1.0), "radius must be > 0, got 0 m"),
        (presets::cylinder(1.0, -2.0), "length must be > 0, got -2 m"),
        (presets::disk(-1.0), "radius must be > 0, got -1 m"),
        (presets::ring(-1.0), "radius must be > 0, got -1 m"),
    ] {
        assert_eq!(refusal(body), message);
    }
    assert!(presets::ring(0.0).is_err() && presets::disk(-1.0).is_err());
}

#[test]
fn a_start_is_tilted_between_its_two_faces_and_finite() {
    let start = State {
        tilt: 0.5,
        ..State::default()
    };
    let cases = [
        (
            State {
                tilt: 0.0,
                yaw_rate: 0.1,
                ..start
            },
            "tilt must be inside (0, pi), got 0 rad",
        ),
        (
            State {
                tilt: -0.3,
                ..start
            },
            "tilt must be inside (0, pi), got -0.3 rad",
        ),
        (
            State { tilt: 3.5, ..start },
            "tilt must be inside (0, pi), got 3.5 rad",
        ),
        (
            State { tilt: NAN, ..start },
            "tilt must be a finite number, got NaN",
        ),
        (
            State {
                tilt_rate: NAN,
                ..start
            },
            "tilt_rate must be a finite number, got NaN",
        ),
        (
            State {
                yaw: INFINITE,
                ..start
            },
            "yaw must be a finite number, got inf",
        ),
        (
            State {
                yaw_rate: NAN,
                ..start
            },
            "yaw_rate must be a finite number, got NaN",
        ),
        (
            State { spin: NAN, ..start },
            "spin must be a finite number, got NaN",
        ),
        (
            State {
                spin_rate: -INFINITE,
                ..start
            },
            "spin_rate must be a finite number, got -inf",
        ),
    ];
    assert_eq!(refusal(start.check()), "accepted");
    for (state, message) in cases {
        assert_eq!(refusal(state.check()), message);
        let motion = simulate(
            &can(),
            &state,
            IdealLaw::NoSlip,
            &Options::default(),
            |_| ControlFlow::Continue(()),
        );
        assert_eq!(refusal(motion), message);
    }
}

/// The error of `simulate` with these options, for the can released at 0.5 rad.
fn refused_options(options: &Options) -> String {
    let start = State {
        tilt: 0.5,
        yaw_rate: 0.01,
        ..State::default()
    };
    refusal(simulate(&can(), &start, IdealLaw::NoSlip, options, |_| {
        ControlFlow::Continue(())
    }))
}

#[test]
fn options_are_bounded() {
    let usual = Options::default();
    let cases = [
        (
            Options {
                duration: 0.0,
                ..usual
            },
            "duration must be > 0, got 0 s",
        ),
        (
            Options {
                duration: INFINITE,
                ..usual
            },
            "duration must be a finite number, got inf",
        ),
        (
            Options {
                gravity: -9.8,
                ..usual
            },
            "gravity must be > 0, got -9.8 m/s2",
        ),
        (
            Options {
                gravity: NAN,
                ..usual
            },
            "gravity must be a finite number, got NaN",
        ),
        (
            Options {
                rtol: 1e-15,
                ..usual
            },
            "rtol must be between 1e-14 and 1e-3, got 1e-15",
        ),
        (
            Options {
                rtol: 0.01,
                ..usual
            },
            "rtol must be between 1e-14 and 1e-3, got 0.01",
        ),
        (
            Options {
                max_steps: 0,
                ..usual
            },
            "max_steps must be >= 1, got 0",
        ),
        (
            Options {
                topple_tilt: Some(NAN),
                ..usual
            },
            "topple_tilt must be a finite number, got NaN",
        ),
        (
            Options {
                topple_tilt: Some(0.4),
                ..usual
            },
            "tilt must be below topple_tilt = 0.4 rad, got 0.5 rad",
        ),
    ];
    assert_eq!(refused_options(&usual), "accepted");
    for (options, message) in cases {
        assert_eq!(refused_options(&options), message);
    }
}

/// Beyond π/2 + φ* the centre of mass would be below the table.
#[test]
fn a_topple_tilt_keeps_the_centre_of_mass_over_the_table() {
    let max = FRAC_PI_2 + can().balance_tilt();
    for tilt in [0.0, -1.0, max, 4.0] {
        let options = Options {
            topple_tilt: Some(tilt),
            ..Options::default()
        };
        assert_eq!(
            refused_options(&options),
            format!(
                "topple_tilt must be inside (0, {max}), where the centre of mass is over the table, \
                 got {tilt} rad"
            )
        );
    }
    // By default a body with height topples at π/2, and it cannot start beyond that tilt.
    let lying = State {
        tilt: 1.6,
        ..State::default()
    };
    let motion = simulate(
        &can(),
        &lying,
        IdealLaw::NoSlip,
        &Options::default(),
        |_| ControlFlow::Continue(()),
    );
    assert_eq!(
        refusal(motion),
        "tilt must be below topple_tilt = 1.5707963267948966 rad, got 1.6 rad"
    );
}

#[test]
fn a_law_is_known_by_its_name() {
    for law in IdealLaw::ALL {
        assert_eq!(IdealLaw::from_name(law.name()), Ok(law));
    }
    assert_eq!(IdealLaw::from_name("no-slip"), Ok(IdealLaw::NoSlip));
    assert_eq!(
        refusal(IdealLaw::from_name("coulomp")),
        "unknown law \"coulomp\": choose from no_slip, frictionless"
    );
}

#[test]
fn closed_forms_refuse_what_they_do_not_describe() {
    let body = can();
    let law = IdealLaw::NoSlip;
    let cases = [
        (
            refusal(turn_limit_with_spin(&body, NAN, 7.0)),
            "spin must be a finite number, got NaN",
        ),
        (
            refusal(turn_limit_with_spin(&body, 1.0, 0.0)),
            "tipping_rate must be > 0, got 0 rad/s",
        ),
        (
            refusal(disk_turn_limit(0.0)),
            "gyration_ratio must be > 0, got 0",
        ),
        (
            refusal(point_mass_turn_limit(0.0, 1.0, law)),
            "radius must be > 0, got 0 m",
        ),
        (
            refusal(point_mass_turn_limit(1.0, -1.0, law)),
            "height must be >= 0, got -1 m",
        ),
        (
            refusal(error_law_coefficient(&body, law, -1.0, 9.8)),
            "tipping_rate must be > 0, got -1 rad/s",
        ),
        (
            refusal(error_law_coefficient(&body, law, 1.0, 0.0)),
            "gravity must be > 0, got 0 m/s2",
        ),
        (
            refusal(error_law(0.0, 1.0, 1.0)),
            "min_tilt must be > 0, got 0 rad",
        ),
        (
            refusal(lift_off_rate(&body, 0.0)),
            "gravity must be > 0, got 0 m/s2",
        ),
        (
            refusal(slip_rate(&body, -1.0)),
            "gravity must be > 0, got -1 m/s2",
        ),
        (
            refusal(steady_wobble_rate(&body, 0.3, 0.0)),
            "gravity must be > 0, got 0 m/s2",
        ),
        (
            refusal(steady_wobble_rate(&body, 0.7, 9.8)),
            &format!("tilt must be one at which a steady wobble exists ({SAME_SIGN}), got 0.7 rad"),
        ),
        (
            refusal(steady_wobble_rate(&body, PI, 9.8)),
            &format!("tilt must be inside (0, pi), got {PI} rad"),
        ),
        (
            refusal(NearCollision::new(&body, law, 0.0, 1.0, 1.0)),
            "min_tilt must be > 0, got 0 rad",
        ),
        (
            refusal(NearCollision::new(&body, law, 1e-3, 0.0, 1.0)),
            "tipping_rate must be > 0, got 0 rad/s",
        ),
        (
            refusal(NearCollision::new(&body, law, 1e-3, 1.0, 0.5)),
            "direction must be 1 or -1, got 0.5",
        ),
    ];
    for (said, message) in &cases {
        assert_eq!(said, message);
    }
}

const SAME_SIGN: &str = "(R cos(tilt) - H sin(tilt))/(A R cos(tilt) - C H sin(tilt)) > 0";

/// Between the balance tilt and the tilt where C H tan φ = A R no yaw rate balances the weight. Here a body with its mass
/// far out and high up, for which the balance tilt is the larger of the two.
#[test]
fn no_steady_wobble_where_no_yaw_rate_balances_the_body() {
    let body = Body::new(1.0, 0.1, 0.1, 1e-3, 2e-3).expect("a rigid body");
    let (other, balance) = (libm::atan(0.5), body.balance_tilt());
    for tilt in [other + 1e-9, 0.7, balance - 1e-9] {
        assert_eq!(
            refusal(steady_wobble_rate(&body, tilt, 9.8)),
            format!(
                "tilt must be one at which a steady wobble exists ({SAME_SIGN}), got {tilt} rad"
            )
        );
    }
    for tilt in [0.4, other - 1e-9, balance + 1e-9, 1.0, 3.0] {
        assert!(steady_wobble_rate(&body, tilt, 9.8).is_ok());
    }
}

#[test]
fn a_composite_approximation_needs_a_near_collision() {
    use rimroll::composite_approximation::composite;
    let refused =
        |start: &State| refusal(composite(&can(), start, IdealLaw::NoSlip, 9.8).map(|_| ()));
    let still = State {
        tilt: 0.5,
        ..State::default()
    };
    assert_eq!(
        refused(&still),
        "this start has no near-collision: with hardly any yaw rate and spin rate it falls face down"
    );
    let past_balance = State {
        tilt: 0.7,
        yaw_rate: 0.01,
        ..State::default()
    };
    let message = refused(&past_balance);
    assert!(
        message.starts_with(
            "this start has no near-collision: its plane pendulum does not come down: toppled"
        ),
        "{message}"
    );
    assert_eq!(
        refused(&State::default()),
        "tilt must be inside (0, pi), got 0 rad"
    );
}
