//! Bodies that wobble in place: what is conserved, where the rim touches the table, the turn by quadrature, and what is
//! refused.

use crate::given::bodies;
use crate::given::cases;
use crate::given::motions;

use bodies::any_body;
use cases::cases;
use core::ops::ControlFlow;
use motions::{PAPER_GRAVITY, follow, paper_start, tight};
use proptest::prelude::*;
use rimroll::law::DynamicsExt;
use rimroll::law::{InPlace, Parameters};
use rimroll::motion::{COLUMNS, Instant, Outcome, Phase, fall};
use rimroll::turn::exact::turn_in_place;
use rimroll::turn::{Arrival, passage, turn_limit, turn_limit_of};
use rimroll::{
    Body, ContactLaw, FrictionLaw, IdealLaw, Motion, Options, State, Status, ensemble, presets,
    simulate,
};

fn can() -> Body {
    presets::can_2007().expect("the paper's can")
}

fn falling_rate(body: &Body) -> f64 {
    (PAPER_GRAVITY / body.radius()).sqrt()
}

/// Starts below the balance tilt, many of which come down nearly flat.
fn any_start() -> impl Strategy<Value = State> {
    let sideways = prop_oneof![-1.0..1.0, -1e-6..1e-6];
    (0.05..0.95, -0.6..0.6, sideways, -3.0..3.0).prop_map(|(tilt, tilt_rate, yaw_rate, yaw)| {
        State {
            tilt,
            tilt_rate,
            yaw_rate,
            yaw,
            ..State::default()
        }
    })
}

/// A start whose tilt is given as a fraction of the balance tilt and whose rates are given in √(g/R).
fn scaled(body: &Body, start: &State) -> State {
    let rate = falling_rate(body);
    State {
        tilt: start.tilt * body.balance_tilt(),
        tilt_rate: start.tilt_rate * rate,
        yaw_rate: start.yaw_rate * rate,
        ..*start
    }
}

fn column(motion: &Motion, at: &Instant, name: &str) -> f64 {
    let index = COLUMNS.iter().position(|column| *column == name);
    motion.observables(at)[index.expect("a column")]
}

/// The centre of the circle on which the body stood, one radius from the contact point toward the centre of mass.
fn center_of_circle(motion: &Motion, body: &Body, at: &Instant) -> [f64; 2] {
    let (sin, cos) = libm::sincos(at.yaw);
    [
        column(motion, at, "contact_x") + body.radius() * cos,
        column(motion, at, "contact_y") + body.radius() * sin,
    ]
}

proptest! {
    #![proptest_config(cases(60))]

    /// Along whole motions at the default tolerance of 1e-10.
    #[test]
    fn yaw_momentum_energy_and_place_are_conserved(body in any_body(), start in any_start()) {
        let rate = falling_rate(&body);
        let options = Options { rtol: 1e-10, ..tight(20.0 / rate) };
        let motion = follow(&body, &scaled(&body, &start), FrictionLaw::InPlace, &options);
        prop_assert!(motion.status != Status::Failed, "{}", motion.message());
        let law = InPlace::new(Parameters::new(&body, PAPER_GRAVITY));
        let begin = motion.trajectory.start();
        let momentum = law.yaw_momentum(&begin);
        let energy = |at: &Instant| motion.dynamics(at).energy(at).total();
        let place = center_of_circle(&motion, &body, &begin);
        for at in motion.trajectory.nodes() {
            prop_assert_eq!(at.phase, Phase::Rolling);
            let change = (law.yaw_momentum(&at) - momentum).abs();
            prop_assert!(change <= 1e-8 * momentum.abs(), "{:e} of {:e}", change, momentum);
            prop_assert!((energy(&at) / energy(&begin) - 1.0).abs() < 1e-9);
            let free = (at.s * (1.0 + at.cos) + at.w * at.sin).abs();
            prop_assert!(free <= 1e-8 * (at.w.abs() + at.s.abs()), "{:e}", free);
            let now = center_of_circle(&motion, &body, &at);
            let off = libm::hypot(now[0] - place[0], now[1] - place[1]);
            prop_assert!(off < 1e-7 * (body.radius() + body.height()), "{:e} at {}", off, at.t);
        }
    }

    /// The quadrature and the steps have nothing in common but the conservation laws.
    #[test]
    fn the_turn_by_quadrature_is_that_of_steps(body in any_body(), start in any_start()) {
        let start = scaled(&body, &start);
        let exact = turn_in_place(&body, &start, PAPER_GRAVITY, None).expect("valid");
        let options = tight(1e3 / falling_rate(&body));
        let stepped = fall(&body, &start, &FrictionLaw::InPlace.into(), &options).expect("valid");
        let ending = match stepped.status {
            Status::LiftedOff => Outcome::LiftedOff,
            _ => stepped.outcome,
        };
        prop_assert_eq!(exact.ending, ending);
        if let Some(turn) = stepped.turn.filter(|_| ending == Outcome::Rocked) {
            let error = (exact.turn - turn.angle).abs();
            prop_assert!(error < 1e-9 * (1.0 + turn.angle.abs()), "{} {}", exact.turn, turn.angle);
            prop_assert!((exact.min_tilt / turn.min_tilt - 1.0).abs() < 1e-8);
            prop_assert!((exact.time / turn.end - 1.0).abs() < 1e-8);
        }
    }

    /// π √(J/K), as without slip; the error law has the order ε ln ε.
    #[test]
    fn the_turn_tends_to_that_without_slip(body in any_body(), lean in 0.1..0.5) {
        let limit = turn_limit(&body, IdealLaw::NoSlip);
        let rate = falling_rate(&body);
        let turn = |yaw_rate: f64| {
            let start = State { tilt: lean * body.balance_tilt(), yaw_rate, ..State::default() };
            turn_in_place(&body, &start, PAPER_GRAVITY, None).expect("valid")
        };
        let last = turn(1e-11 * rate);
        // A tall body that falls from far lifts off in the near-collision.
        prop_assume!(last.ending == Outcome::Rocked);
        prop_assert!((last.turn - limit).abs() < 1e-7 * limit, "{} {}", last.turn, limit);
        let mirrored = turn(-1e-11 * rate);
        prop_assert_eq!(mirrored.turn, -last.turn);
    }
}

#[test]
fn the_limit_is_that_without_slip_also_in_the_inner_problem() {
    let limit = turn_limit(&can(), IdealLaw::NoSlip);
    let law = FrictionLaw::InPlace;
    assert_eq!(turn_limit_of(&can(), &law, &Arrival::at_rest()), Ok(limit));
    let passed = passage(&can(), &law, &Arrival::at_rest()).expect("it rolls through");
    assert!((passed.turn - limit).abs() < 3e-8);
    assert!((passed.rising_rate - 1.0).abs() < 1e-9 && passed.loss.abs() < 1e-9);
    let spinning = Arrival {
        spin: 0.5,
        ..Arrival::at_rest()
    };
    let refusal = "spin must be 0 for a body that wobbles in place, got 0.5 rad/s";
    for refused in [
        turn_limit_of(&can(), &law, &spinning).map(|_| ()),
        passage(&can(), &law, &spinning).map(|_| ()),
    ] {
        assert_eq!(refused.unwrap_err().to_string(), refusal);
    }
}

/// A plane motion needs no twisting moment.
#[test]
fn a_plane_motion_is_one_without_slip() {
    let options = tight(0.2);
    let [in_place, rolling] = [FrictionLaw::InPlace, FrictionLaw::NoSlip]
        .map(|law| follow(&can(), &paper_start(0.0), law, &options));
    for t in [0.05, 0.1, 0.2] {
        let [a, b] =
            [&in_place, &rolling].map(|motion| motion.observables(&motion.trajectory.at(t)));
        for (a, b) in a.iter().zip(b) {
            // Both are accurate to the tolerance; the steps differ by rounding.
            assert!((a - b).abs() <= 1e-12, "at {t} s: {a} and {b}");
        }
    }
}

/// A ring falls over its edge to the other face and still stands on its circle. (A uniform disk would lift off.)
#[test]
fn a_disk_can_pass_its_edge() {
    let disk = presets::ring(0.1).expect("a ring");
    let start = State {
        tilt: 1.5,
        tilt_rate: 0.7,
        yaw_rate: 0.5,
        ..State::default()
    };
    let motion = follow(&disk, &start, FrictionLaw::InPlace, &tight(1.0));
    let law = InPlace::new(Parameters::new(&disk, PAPER_GRAVITY));
    let momentum = law.yaw_momentum(&motion.trajectory.start());
    let end = motion.trajectory.end();
    assert_eq!(motion.status, Status::FaceDown, "{}", motion.message());
    assert!(end.cos < 0.0);
    for at in motion.trajectory.nodes() {
        assert!((law.yaw_momentum(&at) / momentum - 1.0).abs() < 1e-11);
        // θ̇ = −ψ̇, without cancellation on the other face.
        let free = at.w * (1.0 - at.cos) + at.s * at.sin;
        assert!(free.abs() < 1e-9 * at.w.abs(), "{free:e} {:e}", at.w);
    }
}

#[test]
fn a_start_has_no_spin_of_its_own() {
    let start = paper_start(0.005);
    let options = tight(1.0);
    let watch = |_| ControlFlow::Continue(());
    let law = ContactLaw::from(FrictionLaw::InPlace);
    let refusal =
        "spin_rate must be 0 or -yaw_rate for a body that wobbles in place, got 0.005 rad/s";
    let rocking = State {
        spin_rate: 0.0,
        ..start
    };
    let refused = [
        simulate(&can(), &start, law.clone(), &options, watch).map(|_| ()),
        fall(&can(), &start, &law, &options).map(|_| ()),
        turn_in_place(&can(), &start, 9.8, None).map(|_| ()),
        ensemble(
            &[(&can(), rocking, law.clone()), (&can(), start, law.clone())],
            &options,
            |_| ControlFlow::Continue(()),
        )
        .map(|_| ()),
    ];
    for refused in refused {
        assert_eq!(refused.unwrap_err().to_string(), refusal);
    }
    let opposite = State {
        spin_rate: -0.005,
        ..start
    };
    let [a, b] = [rocking, opposite].map(|start| follow(&can(), &start, law.clone(), &options));
    assert_eq!(a.trajectory.end(), b.trajectory.end());
    // A motion can go on from any of its states.
    let from = a.trajectory.at(0.4).u.state();
    let further = follow(&can(), &from, law.clone(), &tight(0.6));
    let (end, expected) = (further.trajectory.end(), a.trajectory.end());
    assert!((end.tilt() - expected.tilt()).abs() < 1e-9);
    assert!((end.yaw - expected.yaw).abs() < 1e-9);
}

#[test]
fn an_ensemble_gives_the_falls_one_by_one() {
    let law = ContactLaw::from(FrictionLaw::InPlace);
    let can = can();
    let starts = [0.005, -0.3, 1.0, 1e-9].map(|yaw_rate| State {
        spin_rate: 0.0,
        ..paper_start(yaw_rate)
    });
    let trials: Vec<_> = starts
        .iter()
        .map(|start| (&can, *start, law.clone()))
        .collect();
    let options = tight(2.0);
    let falls = ensemble(&trials, &options, |_| ControlFlow::Continue(())).expect("valid");
    for (start, found) in starts.iter().zip(falls) {
        assert_eq!(found, fall(&can, start, &law, &options).expect("valid"));
        assert_eq!(found.outcome, Outcome::Rocked);
    }
}

#[test]
fn the_law_has_a_name() {
    for typed in ["in_place", "in-place"] {
        let law = ContactLaw::named(typed, &[], &[]).expect("a law");
        assert_eq!(law.friction, FrictionLaw::InPlace);
    }
    assert_eq!(FrictionLaw::InPlace.name(), "in_place");
    assert_eq!(FrictionLaw::InPlace.ideal(), None);
}

/// A quick tall body lifts off, where the motion ends, as under the ideal laws.
#[test]
fn the_motion_ends_at_a_lift_off() {
    let start = State {
        tilt_rate: -9.5,
        spin_rate: 0.0,
        ..paper_start(0.01)
    };
    let motion = follow(&can(), &start, FrictionLaw::InPlace, &tight(1.0));
    assert_eq!(motion.status, Status::LiftedOff);
    let end = motion.trajectory.end();
    assert!(end.t > 0.0);
    assert!(column(&motion, &end, "normal_force").abs() < 1e-9 * can().mass() * PAPER_GRAVITY);
}

#[test]
fn the_motion_has_derivatives() {
    let moved = |tilt_rate: f64| {
        let start = State {
            spin_rate: 0.0,
            tilt_rate,
            ..paper_start(0.01)
        };
        follow(&can(), &start, FrictionLaw::InPlace, &tight(0.5))
    };
    let (motion, width) = (moved(-0.5), 1e-4);
    let sensitivity = motion.sensitivity(|_| ControlFlow::Continue(()));
    let sensitivity = sensitivity.expect("offered").expect("not stopped");
    let [before, after] =
        [-0.5 - width, -0.5 + width].map(|rate| moved(rate).trajectory.at(0.5).tilt());
    let expected = (after - before) / (2.0 * width);
    let [tilt, ..] = sensitivity.at(&motion, 0.5);
    assert!((tilt[1] - expected).abs() < 1e-6, "{} {expected}", tilt[1]);
    // The spin rate of a start is not free.
    assert!(tilt[5].is_nan());
}
