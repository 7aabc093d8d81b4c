//! What a tolerance buys under dry friction, in an ensemble and alone: an error of that size, at a price
//! that grows as the steps of a method of order 8 do.

#[path = "given/bodies.rs"]
mod bodies;

use bodies::{any_body, cases};
use core::ops::ControlFlow;
use proptest::prelude::*;
use rimroll::motion::{Fall, fall};
use rimroll::{Body, ContactLaw, FrictionLaw, Options, State, Status, ensemble};

/// One way of following a fall.
type Way = fn(&Case, f64) -> Fall;

const WAYS: [(&str, Way); 2] = [("in an ensemble", in_ensemble), ("alone", alone)];

/// A body let go on a table.
#[derive(Debug, Clone, Copy)]
struct Case {
    body: Body,
    start: State,
    friction: f64,
}

impl Case {
    fn contact_law(&self) -> ContactLaw {
        FrictionLaw::coulomb(self.friction).into()
    }
}

fn options(rtol: f64) -> Options {
    Options {
        rtol,
        gravity: 9.8,
        duration: 10.0,
        ..Options::default()
    }
}

fn in_ensemble(case: &Case, rtol: f64) -> Fall {
    let trials = [(&case.body, case.start, case.contact_law())];
    let watch = |_| ControlFlow::Continue(());
    ensemble(&trials, &options(rtol), watch).expect("a valid start")[0]
}

fn alone(case: &Case, rtol: f64) -> Fall {
    fall(&case.body, &case.start, &case.contact_law(), &options(rtol)).expect("a valid start")
}

/// Falls from between upright and the balance point, gentle beside the rate of falling √(g/R), with
/// sideways rates that are anything from next to nothing on.
fn any_case() -> impl Strategy<Value = Case> {
    let sideways = || (-7.0..0.0, prop::bool::ANY);
    let rates = (0.0..0.6, sideways(), sideways());
    (any_body(), 0.02..0.9, rates, 0.02..0.6).prop_map(|(body, leaning, rates, friction)| {
        let falling_rate = (9.8 / body.radius()).sqrt();
        let (tilt_rate, yaw_rate, spin_rate) = rates;
        let signed = |(power, left): (f64, bool)| {
            libm::pow(10.0, power) * if left { falling_rate } else { -falling_rate }
        };
        let start = State {
            tilt: leaning * body.balance_tilt(),
            tilt_rate: -falling_rate * tilt_rate,
            yaw_rate: signed(yaw_rate),
            spin_rate: signed(spin_rate),
            ..State::default()
        };
        Case {
            body,
            start,
            friction,
        }
    })
}

/// By how much the turn changes with the relative change of whatever of the start matters most, rad;
/// `None` where such a change makes another kind of fall of it, or none turns.
fn sensitivity(case: &Case, exact: &Fall) -> Option<f64> {
    const CHANGE: f64 = 1e-5;
    let angle = exact.turn?.angle;
    let changed = |change: fn(&mut State)| {
        let mut start = case.start;
        change(&mut start);
        let beside = in_ensemble(&Case { start, ..*case }, 1e-12);
        let same = beside.status == exact.status && beside.slid == exact.slid;
        let turned = beside.turn.filter(|_| same)?.angle - angle;
        Some(turned.abs() / CHANGE)
    };
    let changes: [fn(&mut State); 4] = [
        |start| start.tilt *= 1.0 + CHANGE,
        |start| start.tilt_rate *= 1.0 + CHANGE,
        |start| start.yaw_rate *= 1.0 + CHANGE,
        |start| start.spin_rate *= 1.0 + CHANGE,
    ];
    let each: Option<Vec<f64>> = changes.into_iter().map(changed).collect();
    Some(each?.into_iter().fold(0.0, f64::max))
}

proptest! {
    #![proptest_config(cases(150))]

    /// Steps are held to a fiftieth of the tolerance, and there are some hundred of them, whose errors
    /// partly cancel: together they do to the turn what a change of the start by as much as the tolerance
    /// would, and at least the tolerance itself.
    #[test]
    fn the_turn_is_as_good_as_was_asked_for(case in any_case()) {
        let exact = in_ensemble(&case, 1e-13);
        let Some(sensitivity) = sensitivity(&case, &exact) else {
            return Ok(());
        };
        let exact = exact.turn.expect("it turns").angle;
        for (name, way) in WAYS {
            for rtol in [1e-8, 1e-10] {
                let found = way(&case, rtol);
                let error = found.turn.expect("it turns").angle - exact;
                prop_assert!(
                    error.abs() <= rtol * (1.0 + sensitivity),
                    "{name}, rtol {rtol}: {error:e}, sensitivity {sensitivity}"
                );
            }
        }
    }

    /// Four decades take 10^(4/8) = 3.2 times the steps where the error grows with the eighth power of
    /// their length.
    #[test]
    fn the_tightest_tolerance_is_within_reach(case in any_case()) {
        for (name, way) in WAYS {
            let (loose, tight) = (way(&case, 1e-9), way(&case, 1e-13));
            prop_assert!(tight.status != Status::Failed, "{name}: {tight:?}");
            prop_assert!(
                tight.steps < 20 * loose.steps,
                "{name}: {} steps, {} at 1e-9", tight.steps, loose.steps
            );
        }
    }
}

/// Just after the collision a slip begins that is all but straight away from the rim's centre.
#[test]
fn a_slip_that_begins_in_the_collision_is_followed_at_the_tightest_tolerance() {
    let case = Case {
        body: Body::new(0.3, 0.02, 0.2, 0.016, 0.0001).expect("a rigid body"),
        start: State {
            tilt: 0.007894155166003914,
            tilt_rate: -0.9679900984004975,
            yaw_rate: -3.8954707250197365e-7,
            spin_rate: 0.006824410923821938,
            ..State::default()
        },
        friction: 0.05,
    };
    for (name, way) in WAYS {
        let (loose, tight) = (way(&case, 1e-9), way(&case, 1e-13));
        assert!(tight.status != Status::Failed, "{name}");
        assert!(tight.steps < 20 * loose.steps, "{name}: {}", tight.steps);
    }
}
