//! The effect of the tolerance under dry friction, in an ensemble and in the scalar driver: the error is of
//! the size of the tolerance, and the cost grows as for a method of order 8.

use crate::given::bodies;
use crate::given::cases;

use bodies::any_body;
use cases::cases;
use core::ops::ControlFlow;
use proptest::prelude::*;
use rimroll::motion::{Fall, fall};
use rimroll::{Body, ContactLaw, FrictionLaw, Options, State, Status, ensemble};

/// A driver that computes a fall.
type Driver = fn(&Case, f64) -> Fall;

const DRIVERS: [(&str, Driver); 2] = [("in an ensemble", in_ensemble), ("alone", alone)];

/// A body released on a table.
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

/// Falls from tilts between upright and the balance point, with tilt rates up to the order of √(g/R) and
/// sideways rates of all orders of magnitude.
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

/// The largest derivative of the turn with respect to the relative change of one number of the start, rad;
/// `None` if such a change leads to another kind of fall, or if there is no turn.
fn sensitivity(case: &Case, exact: &Fall) -> Option<f64> {
    const CHANGE: f64 = 1e-5;
    let angle = exact.turn?.angle;
    let changed = |change: fn(&mut State)| {
        let mut start = case.start;
        change(&mut start);
        let neighbour = in_ensemble(&Case { start, ..*case }, 1e-12);
        let same_kind = neighbour.status == exact.status && neighbour.slid == exact.slid;
        let difference = neighbour.turn.filter(|_| same_kind)?.angle - angle;
        Some(difference.abs() / CHANGE)
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

    /// The tolerance of a step is a fiftieth of `rtol`, and the errors of about a hundred steps partly
    /// cancel. The total error of the turn is at most `rtol`, plus the effect of a relative change of the
    /// start by `rtol`.
    #[test]
    fn the_error_of_the_turn_is_within_the_tolerance(case in any_case()) {
        let exact = in_ensemble(&case, 1e-13);
        let Some(sensitivity) = sensitivity(&case, &exact) else {
            return Ok(());
        };
        let exact = exact.turn.expect("it turns").angle;
        for (name, driver) in DRIVERS {
            for rtol in [1e-8, 1e-10] {
                let found = driver(&case, rtol);
                let error = found.turn.expect("it turns").angle - exact;
                prop_assert!(
                    error.abs() <= rtol * (1.0 + sensitivity),
                    "{name}, rtol {rtol}: {error:e}, sensitivity {sensitivity}"
                );
            }
        }
    }

    /// With an error proportional to the 8th power of the step size, four decades of tolerance need 10^(4/8)
    /// = 3.2 times as many steps.
    #[test]
    fn the_tightest_tolerance_is_within_reach(case in any_case()) {
        for (name, driver) in DRIVERS {
            let (loose, tight) = (driver(&case, 1e-9), driver(&case, 1e-13));
            prop_assert!(tight.status != Status::Failed, "{name}: {tight:?}");
            prop_assert!(
                tight.steps < 20 * loose.steps,
                "{name}: {} steps, {} at 1e-9", tight.steps, loose.steps
            );
        }
    }
}

/// Just after the near-collision a slip begins almost exactly in the direction away from the centre of the
/// rim.
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
    for (name, driver) in DRIVERS {
        let (loose, tight) = (driver(&case, 1e-9), driver(&case, 1e-13));
        assert!(tight.status != Status::Failed, "{name}");
        assert!(tight.steps < 20 * loose.steps, "{name}: {}", tight.steps);
    }
}
