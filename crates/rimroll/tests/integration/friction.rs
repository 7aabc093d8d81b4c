//! The turn under dry friction, between the two limits, and properties that all laws have in common.
//!
//! The tables were computed independently of this code, from the equations of the full model and of the inner
//! problem; `tests/oracles/inner_problem.py` repeats that computation.

use crate::given::bodies;
use crate::given::cases;
use crate::given::motions;

use bodies::any_body;
use cases::cases;
use motions::{PAPER_GRAVITY, follow, paper_start, tight};
use proptest::prelude::*;
use rimroll::law::{Coulomb, Stribeck, Viscous};
use rimroll::motion::EventKind;
use rimroll::turn::{
    Arrival, disk_turn_limit, needed_friction, painleve_friction, passage, turn_limit,
    turn_limit_of, turn_limit_with_spin,
};
use rimroll::{Body, FrictionLaw, IdealLaw, Motion, Options, State, Status, presets};

fn can() -> Body {
    presets::can_2007().expect("the paper's can")
}

fn options(duration: f64) -> Options {
    Options {
        rtol: 1e-11,
        ..tight(duration)
    }
}

fn limit(body: &Body, friction: f64, arrival: &Arrival) -> f64 {
    let law = FrictionLaw::coulomb(friction);
    turn_limit_of(body, &law, arrival).expect("a near-collision that passes")
}

/// The turn in degrees, for a body that arrives without slip and spin, and after the paper's tipping phase.
const LIMITS: [(f64, f64, Option<f64>); 9] = [
    (0.00, 220.9692, Some(220.9692)),
    (0.05, 218.4468, Some(220.5720)),
    (0.10, 215.6640, Some(218.7488)),
    (0.15, 212.7315, Some(214.9925)),
    (0.20, 209.7999, Some(210.7838)),
    (0.25, 207.0289, Some(207.0289)),
    (0.30, 204.5504, None),
    (0.34, 202.8544, None),
    (0.40, 202.2872, None),
];

#[test]
fn the_limiting_turn_of_the_can_falls_from_frictionless_to_no_slip() {
    for (friction, at_rest, _) in LIMITS {
        let turn = limit(&can(), friction, &Arrival::at_rest()).to_degrees();
        assert!((turn - at_rest).abs() < 1e-4, "{friction}: {turn}");
    }
}

#[test]
fn a_tipping_phase_that_slides_makes_the_turn_larger() {
    for (friction, at_rest, after_sliding) in LIMITS {
        let contact_law = FrictionLaw::coulomb(friction).into();
        let arrival = Arrival::from_start(&can(), &paper_start(0.0), &contact_law, PAPER_GRAVITY);
        let arrival = arrival.expect("a tipping phase that ends flat");
        let turn = limit(&can(), friction, &arrival).to_degrees();
        let expected = after_sliding.unwrap_or(at_rest);
        assert!((turn - expected).abs() < 1e-4, "{friction}: {turn}");
        // The rim slides if friction is below the 0.2516 that this start needs during its tipping phase.
        assert_eq!(arrival.slip < 0.0, friction < 0.25, "{friction}");
    }
}

/// Where closed forms exist, the solution of the inner problem agrees with them.
#[test]
fn the_computed_near_collision_is_that_of_the_closed_forms() {
    let turn = |law, arrival: &Arrival| passage(&can(), &law, arrival).expect("it passes").turn;
    let at_rest = Arrival::at_rest();
    let spinning = Arrival {
        spin: -2.0,
        tipping_rate: 3.0,
        ..at_rest
    };
    let rolling = turn_limit(&can(), IdealLaw::NoSlip);
    for law in [FrictionLaw::NoSlip, FrictionLaw::coulomb(0.36)] {
        assert!((turn(law, &at_rest) - rolling).abs() < 1e-9);
    }
    let with_spin = turn_limit_with_spin(&can(), -2.0, 3.0).expect("a tipping rate");
    assert!((turn(FrictionLaw::NoSlip, &spinning) - with_spin).abs() < 1e-5);
    let sliding = turn_limit(&can(), IdealLaw::Frictionless);
    let film = FrictionLaw::Viscous(Viscous { coefficient: 3.0 });
    for law in [FrictionLaw::Frictionless, FrictionLaw::coulomb(0.0), film] {
        assert!((turn(law, &at_rest) - sliding).abs() < 1e-8);
    }
}

/// Just below μ* the limit is interpolated; it must be continuous at both ends of the interval.
#[test]
fn the_limiting_turn_is_continuous_at_the_needed_friction() {
    let needed = needed_friction(&can());
    let turn = |part: f64| limit(&can(), needed * part, &Arrival::at_rest());
    let rolling = turn_limit(&can(), IdealLaw::NoSlip);
    assert_eq!(turn(1.0), rolling);
    let slope = (turn(1.0 - 2e-4) - rolling) / 2e-4;
    for part in [1.01e-4, 0.99e-4, 5e-5, 1e-6] {
        let off = turn(1.0 - part) - (rolling + slope * part);
        assert!(off.abs() < 1e-7, "{part}: {off}");
    }
}

/// The change of yaw from the tilt δ down and back up to δ, with corrections for the rest. Near face down the
/// orbit leaves and reaches a fixed point as w ~ e^{∓|φ̇|τ}, so ∫ w dτ = w/|φ̇| at each end. The correction
/// neglects terms of order (φ_c/δ)², and the other phases of the motion contribute terms of order δ. The
/// total error is smallest at δ = φ_c^{2/3}.
fn near_collision_turn(motion: &Motion, min_tilt: f64) -> f64 {
    let delta = libm::pow(min_tilt, 2.0 / 3.0);
    let low = motion
        .events
        .iter()
        .find(|event| event.kind == EventKind::TiltMin)
        .expect("a near-collision")
        .at;
    let tilt = |t: f64| motion.trajectory.at(t).tilt();
    let at = |mut outside: f64| {
        let mut inside = low.t;
        for _ in 0..200 {
            let middle = 0.5 * (inside + outside);
            if tilt(middle) < delta {
                inside = middle;
            } else {
                outside = middle;
            }
        }
        motion.trajectory.at(outside)
    };
    let (before, after) = (at(0.0), at(low.t + 0.05));
    let tail = before.w / before.p.abs() + after.w / after.p.abs();
    after.yaw - before.yaw + tail
}

#[test]
fn full_motions_near_the_limit_turn_as_the_near_collision_by_itself() {
    for friction in [0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.34, 0.4] {
        let contact_law = FrictionLaw::coulomb(friction);
        let motion = follow(&can(), &paper_start(1e-6), &contact_law, &options(0.3));
        let arrival = Arrival::from_start(
            &can(),
            &paper_start(0.0),
            &contact_law.into(),
            PAPER_GRAVITY,
        );
        let expected = limit(&can(), friction, &arrival.expect("it comes down flat"));
        let low = motion.turns.first().map_or(1e-7, |turn| turn.min_tilt);
        let turn = near_collision_turn(&motion, low);
        let off = (turn - expected).to_degrees();
        assert!(off.abs() < 0.005, "{friction}: {off} degrees off");
    }
}

/// Friction μ; the turn in degrees from release to the next tilt maximum from (30°, −0.5 rad/s); and the yaw
/// in degrees at φ = 1.5 rad of a fall from (20°, −4.5 rad/s). Both have ε = 1e-5 rad/s.
const WHOLE_TURNS: [(f64, Option<f64>, Option<f64>); 10] = [
    (0.00, None, Some(220.97)),
    (0.05, Some(219.685), Some(213.80)),
    (0.10, Some(216.133), Some(214.75)),
    (0.15, Some(212.985), Some(213.61)),
    (0.20, Some(209.736), Some(211.24)),
    (0.25, Some(206.837), Some(208.99)),
    (0.30, Some(205.117), Some(206.06)),
    (0.34, Some(203.175), None),
    (0.36, Some(202.287), None),
    (0.40, Some(202.287), Some(202.29)),
];

#[test]
fn slip_leaves_spin_behind_and_the_can_turns_on_as_it_rises() {
    let flick = State {
        tilt: 20f64.to_radians(),
        tilt_rate: -4.5,
        ..paper_start(1e-5)
    };
    let to_fall = Options {
        topple_tilt: Some(1.5),
        ..options(3.0)
    };
    for (friction, to_maximum, to_side) in WHOLE_TURNS {
        let law = FrictionLaw::coulomb(friction);
        if let Some(expected) = to_maximum {
            let motion = follow(&can(), &paper_start(1e-5), &law, &options(1.0));
            let turn = motion.turns[0].angle.to_degrees();
            // The source prints thousandths that are not always correctly rounded.
            assert!((turn - expected).abs() < 1.5e-3, "{friction}: {turn}");
        }
        if let Some(expected) = to_side {
            let motion = follow(&can(), &flick, &law, &to_fall);
            assert_eq!(motion.status, Status::Toppled);
            let turn = motion.trajectory.end().yaw.to_degrees();
            // The source prints hundredths.
            assert!((turn - expected).abs() < 0.6e-2, "{friction}: {turn}");
        }
    }
}

/// Every law, with gentle and violent starts.
fn laws() -> Vec<FrictionLaw> {
    let mut laws = vec![
        FrictionLaw::NoSlip,
        FrictionLaw::Frictionless,
        FrictionLaw::Viscous(Viscous { coefficient: 0.1 }),
        FrictionLaw::Viscous(Viscous { coefficient: 10.0 }),
        FrictionLaw::Coulomb(Coulomb {
            friction: 0.1,
            static_friction: 0.3,
        }),
        FrictionLaw::Stribeck(Stribeck {
            friction: 0.2,
            static_friction: 0.3,
            stribeck_speed: 0.01,
            creep_speed: 1e-3,
        }),
    ];
    laws.extend([0.01, 0.1, 0.3, 0.8].map(FrictionLaw::coulomb));
    laws
}

/// The paper: "friction does not matter" for disks. This is true of the turn in the near-collision, both in
/// the inner problem and in full motions.
#[test]
fn a_disk_turns_by_the_same_angle_under_every_law() {
    for (body, gyration) in [
        (presets::disk(0.051).expect("a disk"), 0.5f64.sqrt()),
        (presets::ring(0.051).expect("a ring"), 1.0),
    ] {
        let expected = disk_turn_limit(gyration).expect("k > 0");
        for law in laws() {
            let alone = passage(&body, &law, &Arrival::at_rest()).expect("it passes");
            assert!((alone.turn - expected).abs() < 1e-8, "{law:?}");
            let motion = follow(&body, &paper_start(1e-6), &law, &options(0.3));
            let low = motion
                .events
                .iter()
                .find(|event| event.kind == EventKind::TiltMin)
                .unwrap_or_else(|| panic!("{law:?}: {}", motion.message()));
            let turn = near_collision_turn(&motion, low.at.tilt());
            let off = (turn.abs() - expected).to_degrees();
            assert!(off.abs() < 0.05, "{law:?}: {off} degrees off");
        }
    }
}

/// The turn from release to the next maximum does depend on friction.
#[test]
fn a_disk_that_slides_on_its_way_down_and_up_turns_by_another_angle_in_all() {
    let disk = presets::disk(0.051).expect("a disk");
    for (law, expected) in [
        (FrictionLaw::Frictionless, 402.49),
        (FrictionLaw::coulomb(0.8), 399.07),
    ] {
        let motion = follow(&disk, &paper_start(1e-6), &law, &options(1.0));
        let turn = motion.turns[0].angle.to_degrees().abs();
        assert!((turn - expected).abs() < 0.006, "{law:?}: {turn}");
    }
}

#[test]
fn painleve_frictions_are_those_known() {
    let ring = presets::ring(0.051).expect("a ring");
    let disk = presets::disk(0.051).expect("a disk");
    for (body, expected, digits) in [
        (can(), 2.175, 5e-4),
        (disk, 5f64.sqrt() / 2.0, 1e-12),
        (ring, 3f64.sqrt(), 1e-12),
    ] {
        assert!((painleve_friction(&body) - expected).abs() < digits);
    }
}

proptest! {
    #![proptest_config(cases(60))]

    /// The turn lies between the limits and decreases with friction. (For a low, wide body, slight friction
    /// can give a slightly larger turn than none.)
    #[test]
    fn the_limiting_turn_of_a_body_as_tall_as_wide_lies_between_the_closed_forms(
        body in any_body(), part in 0.05..0.95,
    ) {
        prop_assume!(body.height() >= body.radius());
        let needed = needed_friction(&body);
        let max = turn_limit(&body, IdealLaw::Frictionless);
        let min = turn_limit(&body, IdealLaw::NoSlip);
        prop_assume!(max - min > 1e-6 && needed < 0.9 * painleve_friction(&body));
        let turn = limit(&body, part * needed, &Arrival::at_rest());
        prop_assert!(min - 1e-8 < turn && turn < max + 1e-8, "{min} {turn} {max}");
        let more = limit(&body, (part + 0.05) * needed, &Arrival::at_rest());
        prop_assert!(more < turn + 1e-8);
    }

    /// The turn depends only on the ratios slip/(Hω) and spin/ω.
    #[test]
    fn the_limiting_turn_depends_on_relative_slip_and_spin_only(
        friction in 0.02..0.3, slip in -0.5..0.0, spin in -0.5..0.0, rate in 0.01..100.0,
    ) {
        let turn = |rate: f64| {
            let arrival = Arrival {
                tipping_rate: rate,
                slip: slip * can().height() * rate,
                spin: spin * rate,
                ..Arrival::at_rest()
            };
            turn_limit_of(&can(), &FrictionLaw::coulomb(friction), &arrival)
        };
        match (turn(1.0), turn(rate)) {
            (Ok(one), Ok(other)) => prop_assert!((one - other).abs() < 1e-7),
            (one, other) => prop_assert_eq!(one.is_err(), other.is_err()),
        }
    }
}
