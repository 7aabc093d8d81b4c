//! The numbers that say how far the model holds in a turn.

use crate::given::bodies;
use crate::given::cases;

use bodies::any_body;
use cases::cases;
use core::f64::consts::PI;
use core::ops::ControlFlow;
use proptest::prelude::*;
use rimroll::law::DynamicsExt;
use rimroll::motion::SPEED_OF_SOUND;
use rimroll::{Body, ContactLaw, FrictionLaw, IdealLaw, Motion, Options, State, presets, simulate};

fn motion(body: &Body, start: &State, contact_law: impl Into<ContactLaw>) -> Motion {
    let options = Options {
        rtol: 1e-10,
        ..Options::default()
    };
    let watch = |_| ControlFlow::Continue(());
    simulate(body, start, contact_law, &options, watch).expect("a valid start")
}

fn nearly_flat(tilt: f64, yaw_rate: f64) -> State {
    State {
        tilt,
        yaw_rate,
        ..State::default()
    }
}

/// Close to the table, φ² = φ₀² + (kt)² and ψ = (turn/π) atan(kt/φ₀), where k is the tilt rate on arrival.
fn agrees_with_the_small_angle_solution(body: &Body, law: IdealLaw, sideways: f64) {
    let tilt = 0.5 * body.balance_tilt().min(1.0);
    let motion = motion(body, &nearly_flat(tilt, sideways), law);
    let (turn, k) = (&motion.turns[0], motion.contacts.parameters());
    let validity = motion.validity(turn);
    let low = turn.min_tilt;
    // Where the tilt is far above the smallest, but still small.
    let nodes: Vec<_> = motion
        .trajectory
        .nodes()
        .take_while(|at| at.t <= turn.t)
        .collect();
    let arrival = nodes
        .iter()
        .rfind(|at| at.tilt() > 300.0 * low)
        .expect("a step above");
    assert!(arrival.tilt() < 0.01, "{}", arrival.tilt());
    let rate = arrival.state().tilt_rate.abs();
    let close = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 0.02, "{a} {b} {body:?} {law:?}");
    close(validity.gap, 2.0 * k.r * low);
    close(
        validity.contact_speed,
        k.r * turn.angle.abs() / PI * rate / low,
    );
    close(
        validity.passage_time,
        2.0 * libm::tan(0.4 * PI) * low / rate,
    );
    close(validity.force_ratio, 1.0 + k.r * rate * rate / (low * k.g));
    assert_eq!(validity.sound_time, 2.0 * k.r / SPEED_OF_SOUND);
    assert!(validity.loss_ratio.abs() < 1e-12);
    assert!(validity.exceeded()[3]);
}

proptest! {
    #![proptest_config(cases(60))]

    #[test]
    fn a_near_collision_has_the_numbers_of_the_small_angle_solution(
        body in any_body(),
        law in prop_oneof![Just(IdealLaw::NoSlip), Just(IdealLaw::Frictionless)],
        log_sideways in -7.0..-5.0,
    ) {
        let falling_rate = (9.81 / body.radius()).sqrt();
        agrees_with_the_small_angle_solution(&body, law, falling_rate * libm::pow(10.0, log_sideways));
    }
}

#[test]
fn the_energy_lost_is_that_of_the_motion() {
    let can = presets::can_2007().expect("the paper's can");
    let start = nearly_flat(0.4, 0.3);
    let motion = motion(&can, &start, FrictionLaw::coulomb(0.1));
    let turn = motion.turns[0];
    let energies = |t: f64| {
        motion
            .dynamics(&motion.trajectory.at(t))
            .energy(&motion.trajectory.at(t))
    };
    let total = |t| energies(t).kinetic + energies(t).potential;
    let kinetic = (0..=20_000).map(|i| energies(turn.end * f64::from(i) / 20_000.0).kinetic);
    let expected = (total(0.0) - total(turn.end)) / kinetic.fold(0.0, f64::max);
    assert!(expected > 0.01);
    let found = motion.validity(&turn).loss_ratio;
    assert!((found / expected - 1.0).abs() < 1e-4, "{found} {expected}");
}

#[test]
fn a_slow_wobble_is_within_the_limits_and_a_flat_arrival_beyond_them() {
    let can = presets::can_2007().expect("the paper's can");
    let exceeded = |sideways| {
        let motion = motion(&can, &nearly_flat(0.3, sideways), IdealLaw::NoSlip);
        motion.validity(&motion.turns[0]).exceeded()
    };
    assert_eq!(exceeded(0.5), [false, false, false, true]);
    assert_eq!(exceeded(1e-4), [true; 4]);
}
