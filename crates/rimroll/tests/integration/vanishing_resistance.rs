//! Resistances on tables that move: as one vanishes, the motion becomes that without it, and no number of a motion is infinite
//! or undefined.

use proptest::prelude::*;
use rimroll::ground::Ground;
use rimroll::motion::{COLUMNS, FlatLanding, STANDING_TILT};
use rimroll::{
    Body, ContactLaw, FrictionLaw, Motion, Options, Shaking, State, Status, shake_many, simulate_on,
};
use std::ops::ControlFlow;
use std::sync::Arc;

use crate::given::bodies;
use crate::given::cases;
use crate::given::shaken;
use bodies::{any_body, powers_of_ten};
use cases::cases;
use shaken::{GRAVITY, any_column, any_flat, any_friction, any_ground, any_start, resistance};

/// What a motion begins with, without a resistance and its kind.
#[derive(Debug, Clone)]
struct Case {
    body: Body,
    friction: FrictionLaw,
    kind: usize,
    ground: Arc<Ground>,
    flat: FlatLanding,
    start: State,
}

fn any_case(body: impl Strategy<Value = Body>) -> impl Strategy<Value = Case> {
    body.prop_flat_map(|body| {
        let given = (any_friction(&body), 0..6_usize, any_ground(&body));
        (Just(body), given, any_flat(), any_start(&body))
    })
    .prop_map(|(body, (friction, kind, ground), flat, mut start)| {
        if friction == FrictionLaw::InPlace {
            start.spin_rate = -start.yaw_rate;
        }
        Case {
            body,
            friction,
            kind,
            ground,
            flat,
            start,
        }
    })
}

impl Case {
    fn duration(&self) -> f64 {
        let (r, h) = (self.body.radius(), self.body.height());
        self.ground.duration() + 8.0 * ((r * r + h * h) / (GRAVITY * r)).sqrt()
    }

    fn options(&self, max_steps: usize) -> Options {
        Options {
            duration: self.duration(),
            gravity: GRAVITY,
            flat: self.flat,
            max_steps,
            ..Options::default()
        }
    }

    fn law(&self, size: f64) -> ContactLaw {
        ContactLaw {
            resistance: resistance(&self.body, self.kind, size),
            ..self.friction.clone().into()
        }
    }

    fn motion(&self, size: f64, factor: f64, max_steps: usize) -> Motion {
        let ground = Some(Arc::new(self.ground.scaled(factor)));
        let watch = |_| ControlFlow::Continue(());
        let options = self.options(max_steps);
        simulate_on(
            ground,
            &self.body,
            &self.start,
            self.law(size),
            &options,
            watch,
        )
        .unwrap()
    }
}

/// The largest difference of the tilts of two motions (rad) up to each of some times.
fn differences(a: &Motion, b: &Motion, times: &[f64]) -> Vec<f64> {
    let largest = |largest: &mut f64, t: &f64| {
        let difference = a.trajectory.at(*t).tilt() - b.trajectory.at(*t).tilt();
        *largest = largest.max(difference.abs());
        Some(*largest)
    };
    times.iter().scan(0.0, largest).collect()
}

proptest! {
    #![proptest_config(cases(20))]

    /// The difference from the motion without resistance falls with the resistance, besides errors as large as those that a
    /// change of the ground by 1e-9 makes. The differences are compared until a resistance that is a thousand times
    /// larger has changed the tilt by 1e-3 rad: air drag alone does so early, where the contact point runs round fast.
    #[test]
    fn a_vanishing_resistance_changes_nothing(case in any_case(any_column())) {
        const CHANGE: f64 = 1e-9;
        // A body that rocks less than this, in radians, may stand or not.
        const STANDING: f64 = 3.0 * STANDING_TILT;
        let max_steps = 6_000;
        let without = case.motion(0.0, 1.0, max_steps);
        prop_assume!(without.status != Status::Failed);
        let end = without.trajectory.end().t;
        let times: Vec<f64> = (0..100).map(|i| end * f64::from(i) / 100.0).collect();
        let changed = differences(&without, &case.motion(0.0, 1.0 + CHANGE, max_steps), &times);
        let mut larger = differences(&without, &case.motion(1e-6, 1.0, max_steps), &times);
        for size in [1e-9, 1e-12, 1e-15, 1e-300] {
            let motion = case.motion(size, 1.0, max_steps);
            let found = differences(&without, &motion, &times);
            for (i, t) in times.iter().enumerate().take_while(|(i, _)| larger[*i] < 1e-3) {
                let allowed = STANDING + changed[i] + 0.1 * larger[i];
                prop_assert!(
                    found[i] < allowed,
                    "{size:e} at {t} s: {:e}, allowed {allowed:e}; {} {}",
                    found[i],
                    without.message(),
                    motion.message()
                );
            }
            if changed[99] < 1e-4 && larger[99] < 1e-3 {
                prop_assert_eq!(motion.status, without.status, "{}", motion.message());
            }
            larger = found;
        }
    }
}

proptest! {
    #![proptest_config(cases(60))]

    /// Whatever becomes of a motion, alone or among many, all its numbers are finite.
    #[test]
    fn every_number_of_a_motion_is_finite(
        case in prop_oneof![any_case(any_column()), any_case(any_body())],
        size in prop_oneof![powers_of_ten(-300.0, 0.0), powers_of_ten(-12.0, 1.0)],
        factor in powers_of_ten(-1.0, 2.0),
    ) {
        let motion = case.motion(size, factor, 1_000);
        let undefined = |column: &str| column == "friction_ratio";
        for instant in motion.trajectory.samples(3) {
            for (column, value) in COLUMNS.iter().zip(motion.observables(&instant)) {
                prop_assert!(value.is_finite() || undefined(column), "{column} at {} s", instant.t);
            }
        }
        for event in &motion.events {
            prop_assert!(event.at.t.is_finite() && event.at.tilt().is_finite());
        }
        prop_assert!(!motion.message().contains("NaN"), "{}", motion.message());
        let row = Shaking {
            body: &case.body,
            start: case.start,
            contact_law: case.law(size),
            ground: Some(&case.ground),
            scale: factor,
            duration: case.duration(),
        };
        let rows = vec![row; 3];
        let outcomes = shake_many(&rows, &case.options(1_000), |_| ControlFlow::Continue(())).unwrap();
        for outcome in outcomes {
            let numbers = [
                outcome.end_time,
                outcome.end_tilt,
                outcome.max_tilt,
                outcome.residual_yaw,
                outcome.friction_loss,
                outcome.resistance_loss,
                outcome.impact_loss,
                outcome.ground_work,
            ];
            prop_assert!(numbers.iter().all(|number| number.is_finite()), "{outcome:?}");
            prop_assert_eq!(outcome.status, motion.status);
        }
    }
}
