//! The beginning and the end of the first turn, in both engines: steps (scalar and in lanes) and quadrature.

use crate::given::bodies;
use crate::given::cases;

use bodies::any_body;
use cases::cases;
use core::f64::consts::FRAC_PI_2;
use core::ops::ControlFlow;
use proptest::prelude::*;
use rimroll::motion::{EventKind, Fall, Outcome, fall};
use rimroll::turn::exact::{Exact, ExactTurn};
use rimroll::{Body, IdealLaw, Options, State, ensemble, simulate};

const GRAVITY: f64 = 9.8;

fn options(rtol: f64) -> Options {
    Options {
        duration: 100.0,
        gravity: GRAVITY,
        rtol,
        ..Options::default()
    }
}

fn by_steps(body: &Body, law: IdealLaw, start: &State, rtol: f64) -> [Fall; 2] {
    let (options, contact_law) = (options(rtol), law.into());
    let watch = |_| ControlFlow::Continue(());
    let alone = fall(body, start, &contact_law, &options).expect("valid");
    let among_others = ensemble(&[(body, *start, contact_law)], &options, watch).expect("valid");
    [alone, among_others[0]]
}

fn by_quadrature(body: &Body, law: IdealLaw, start: &State) -> ExactTurn {
    let exact = Exact::new(body, law, GRAVITY, None).expect("valid");
    exact.turn(start).expect("valid")
}

fn laws() -> impl Strategy<Value = IdealLaw> {
    prop_oneof![Just(IdealLaw::NoSlip), Just(IdealLaw::Frictionless)]
}

/// A start with zero tilt rate and axial spin, whose yaw rate is `fraction` of the rate at which the tilt
/// stays constant.
fn yawing(body: &Body, lean: f64, fraction: f64) -> State {
    let tilt = lean * body.balance_tilt();
    let (sin, cos) = libm::sincos(tilt);
    let rho = body.radius() * cos - body.height() * sin;
    let steady = body.mass() * GRAVITY * rho / (body.transverse_inertia() * sin * cos);
    let yaw_rate = fraction * steady.sqrt();
    State {
        tilt,
        yaw_rate,
        spin_rate: -yaw_rate * cos,
        ..State::default()
    }
}

proptest! {
    #![proptest_config(cases(60))]

    /// Released where the yaw rate makes the tilt rise. A body with a negative tilt rate, however small,
    /// comes down at once. Its turn is half as long as that of a body that starts at rest or rising, which
    /// counts from the maximum that follows.
    #[test]
    fn a_turn_counts_from_the_release_unless_the_tilt_rises_there(
        body in any_body(), law in laws(), lean in 0.1..0.5, fraction in 1.2..1.5,
        digits in 9.0..300.0_f64,
    ) {
        let at_rest = yawing(&body, lean, fraction);
        let whole = by_quadrature(&body, law, &at_rest);
        prop_assume!(whole.ending == Outcome::Rocked && whole.max_tilt > 1.05 * at_rest.tilt);
        let tiny = (GRAVITY / body.radius()).sqrt() * libm::pow(10.0, -digits);
        for (tilt_rate, fraction) in [(-tiny, 0.5), (0.0, 1.0), (tiny, 1.0)] {
            let start = State { tilt_rate, ..at_rest };
            let expected = fraction * whole.turn;
            let exact = by_quadrature(&body, law, &start);
            prop_assert_eq!(exact.ending, Outcome::Rocked);
            prop_assert!((exact.turn - expected).abs() < 1e-6 * (1.0 + expected.abs()), "{exact:?} {expected}");
            for rtol in [1e-5, 1e-8, 1e-11] {
                for fall in by_steps(&body, law, &start, rtol) {
                    prop_assert_eq!(fall.outcome, Outcome::Rocked);
                    let turn = fall.turn.expect("a turn").angle;
                    let off = (turn - expected).abs();
                    prop_assert!(off < (1e-6 + 1e2 * rtol) * (1.0 + expected.abs()), "{turn} {expected} {rtol}");
                }
            }
        }
    }

    /// Released where gravity makes the tilt fall. The sign of a tiny tilt rate then has only a tiny effect
    /// on the turn.
    #[test]
    fn a_turn_from_about_a_largest_tilt_is_that_from_it(
        body in any_body(), law in laws(), lean in 0.1..0.9, fraction in 0.01..0.5,
        digits in 9.0..300.0_f64,
    ) {
        let at_rest = yawing(&body, lean, fraction);
        let whole = by_quadrature(&body, law, &at_rest);
        // The turn begins at the tilt maximum.
        prop_assume!(whole.ending == Outcome::Rocked && whole.max_tilt < 1.000_001 * at_rest.tilt);
        let tiny = (GRAVITY / body.radius()).sqrt() * libm::pow(10.0, -digits);
        for tilt_rate in [-tiny, 0.0, tiny] {
            let start = State { tilt_rate, ..at_rest };
            let exact = by_quadrature(&body, law, &start);
            prop_assert!((exact.turn - whole.turn).abs() < 1e-6);
            for fall in by_steps(&body, law, &start, 1e-8) {
                prop_assert_eq!(fall.outcome, Outcome::Rocked);
                let turn = fall.turn.expect("a turn").angle;
                prop_assert!((turn - whole.turn).abs() < 1e-5 * (1.0 + turn.abs()), "{turn} {whole:?}");
            }
        }
    }

    /// A disk released at rest within a tiny angle of the vertical, to either side.
    #[test]
    fn a_disk_let_go_just_past_its_edge_turns_as_one_let_go_just_before(
        gyration in 0.4..1.0, law in laws(), yaw in 1.0..10.0, spin in 10.0..60.0,
        digits in 6.0..12.0_f64,
    ) {
        let (mass, radius) = (0.0057, 0.01213);
        let axial = gyration * mass * radius * radius;
        let disk = Body::new(mass, radius, 0.0, 0.5 * axial, axial).expect("a disk");
        let offset = libm::pow(10.0, -digits);
        let start = |past: f64| State {
            tilt: FRAC_PI_2 + past,
            yaw_rate: yaw,
            spin_rate: spin,
            ..State::default()
        };
        let before = by_quadrature(&disk, law, &start(-offset));
        prop_assert_eq!(before.ending, Outcome::Rocked);
        // The time that it spends beyond the vertical is proportional to the square root of that angle, and
        // errors of the tilt change this time by their own square root.
        let close = |rtol: f64| 20.0 * yaw * ((offset + rtol) * disk.radius() / GRAVITY).sqrt();
        let exact = by_quadrature(&disk, law, &start(offset));
        prop_assert_eq!(exact.ending, Outcome::Rocked);
        prop_assert!((exact.turn - before.turn).abs() < close(1e-13), "{exact:?} {before:?}");
        for past in [-offset, offset] {
            for rtol in [1e-6, 1e-8, 1e-10] {
                for fall in by_steps(&disk, law, &start(past), rtol) {
                    prop_assert_eq!(fall.outcome, Outcome::Rocked);
                    let turn = fall.turn.expect("a turn").angle;
                    let off = (turn - before.turn).abs();
                    prop_assert!(off < close(rtol), "{turn} {before:?} {rtol}");
                }
            }
        }
    }
}

/// Before and after each stay beyond the vertical it passes its edge.
#[test]
fn a_disk_passes_its_edge_twice_for_each_tilt_maximum_beyond_it() {
    let axial = 0.5 * 0.0057 * 0.01213 * 0.01213;
    let coin = Body::new(0.0057, 0.01213, 0.0, 0.5 * axial, axial).expect("a coin");
    let start = State {
        tilt: FRAC_PI_2 + 1e-9,
        yaw_rate: 5.0,
        spin_rate: 40.0,
        ..State::default()
    };
    let options = Options {
        duration: 3.0,
        rtol: 1e-12,
        ..Options::default()
    };
    let watch = |_| ControlFlow::Continue(());
    let motion = simulate(&coin, &start, IdealLaw::NoSlip, &options, watch).expect("valid");
    let mut past = true;
    let (mut edges, mut beyond) = (0_usize, 0_usize);
    for event in &motion.events {
        match event.kind {
            EventKind::OnEdge => {
                past = !past;
                edges += 1;
            }
            EventKind::TiltMax => {
                assert_eq!(event.at.u.tilt() > FRAC_PI_2, past);
                beyond += usize::from(past);
            }
            EventKind::TiltMin => assert!(!past),
            _ => {}
        }
    }
    // The motion begins beyond the edge.
    assert!(
        beyond > 20 && edges.abs_diff(2 * beyond + 1) <= 1,
        "{edges} {beyond}"
    );
    // Half of the turns are those on the other face, which are nearly zero.
    let long = motion.turns.iter().filter(|turn| turn.angle.abs() > 0.01);
    assert!(long.count().abs_diff(27) <= 1);
}

fn can() -> Body {
    rimroll::presets::can_2007().expect("the paper's can")
}

/// These bodies are beyond the balance point and lack the energy to return over it, whatever the sideways
/// rates: the potential barrier stops plane motion, and all other motions have even less energy to spare.
#[test]
fn a_body_past_its_balance_point_does_not_come_down_flat_for_lack_of_sideways_rates() {
    let (can, balance) = (can(), can().balance_tilt());
    for law in [IdealLaw::NoSlip, IdealLaw::Frictionless] {
        for rate in [0.0, 1e-300, 1e-17, 1e-16, 1e-15, 1e-12] {
            for (yaw_rate, spin_rate) in [(rate, 0.0), (0.0, rate), (rate, -rate)] {
                for (past, tilt_rate) in [(0.3, -0.1), (1e-3, -1e-4), (1e-6, -1e-7), (1e-7, -1e-8)]
                {
                    let start = State {
                        tilt: balance + past,
                        tilt_rate,
                        yaw_rate,
                        spin_rate,
                        ..State::default()
                    };
                    let found = by_quadrature(&can, law, &start);
                    assert_eq!(found.ending, Outcome::Toppled, "{law:?} {start:?}");
                    assert!(found.min_tilt > balance);
                }
            }
        }
    }
}

/// A fast top: gravity pulls it down, and its spin turns that into a nutation of about 1e-8 rad, whose energy
/// is a small difference of the much larger energy of the spin.
#[test]
fn a_body_that_spins_like_a_top_nods_and_keeps_its_rim_on_the_table() {
    let body = Body::new(2.9356, 4.43825, 2.08665, 30.4646, 8.66772).expect("a body");
    let gravity = 0.012584;
    for law in [IdealLaw::NoSlip, IdealLaw::Frictionless] {
        let exact = Exact::new(&body, law, gravity, None).expect("valid");
        for spin_rate in [300.0, 1000.0, 3000.0] {
            let start = State {
                tilt: FRAC_PI_2 - 1e-4,
                spin_rate,
                ..State::default()
            };
            let found = exact.turn(&start).expect("valid");
            assert_eq!(found.ending, Outcome::Rocked, "{law:?} {spin_rate}");
            assert!((found.max_tilt - start.tilt).abs() < 1e-5);
        }
    }
}

/// The tilt falls from the start, so the sign of the normal force at the largest tilt of that energy does not
/// matter.
#[test]
fn a_disk_that_comes_down_flat_from_next_to_the_table_does_not_lift_off() {
    let disk = Body::new(
        0.005722410954995901,
        0.09789746812194981,
        0.0,
        2.9346757575736527e-06,
        5.823825404944242e-06,
    )
    .expect("a disk");
    let start = State {
        tilt: 5.008639415196606e-11,
        tilt_rate: -22.517875044911875,
        yaw_rate: -2890.7617650370416,
        spin_rate: 3.187081393070162,
        ..State::default()
    };
    let found = by_quadrature(&disk, IdealLaw::NoSlip, &start);
    assert_eq!(found.ending, Outcome::FaceDown);
}

/// Beyond the vertical a disk leans on its other face; it has not passed a balance point.
#[test]
fn a_disk_whose_rim_leaves_the_table_on_its_other_face_has_lifted_off() {
    let disk = Body::new(
        335.0631123521191,
        2.1046001612198477,
        0.0,
        483.32222670917787,
        907.0104445556736,
    )
    .expect("a disk");
    let start = State {
        tilt: 3.1415658149048338,
        tilt_rate: 0.017979788349599145,
        yaw_rate: 9.93063262227416e-12,
        spin_rate: -1.9110972027063529,
        ..State::default()
    };
    let options = Options {
        duration: 7000.0,
        gravity: 0.06841342232770131,
        ..Options::default()
    };
    let found = fall(&disk, &start, &IdealLaw::NoSlip.into(), &options).expect("valid");
    assert!(found.turn.is_some() && found.end.tilt > FRAC_PI_2);
    assert_eq!(found.outcome, Outcome::LiftedOff);
}
