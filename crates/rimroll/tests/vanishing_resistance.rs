//! Resistances on tables that move: as one vanishes, the motion becomes that without it, and no number of a motion is infinite
//! or undefined.

use proptest::prelude::*;
use rimroll::ground::{Ground, Pulse, Shape};
use rimroll::law::{
    AirDrag, Coulomb, PivotingFriction, Resistance, RollingResistance, Stribeck, Tabulated, Viscous,
};
use rimroll::motion::{COLUMNS, FlatLanding, STANDING_TILT, Side};
use rimroll::{
    Body, ContactLaw, FrictionLaw, Motion, Options, Shaking, State, Status, shake_many, simulate_on,
};
use std::f64::consts::TAU;
use std::ops::ControlFlow;
use std::sync::Arc;

#[path = "given/bodies.rs"]
mod bodies;
#[path = "given/cases.rs"]
mod cases;
use bodies::{any_body, powers_of_ten};
use cases::cases;

const GRAVITY: f64 = 9.81;

/// Columns of all sizes.
fn any_column() -> impl Strategy<Value = Body> {
    let sizes = (powers_of_ten(-2.0, 3.0), powers_of_ten(-2.0, 0.0), 1.2..6.0);
    (sizes, 0.3..1.0, 0.2..0.5).prop_map(|((mass, radius, slenderness), axial, transverse)| {
        let height = slenderness * radius;
        let c = axial * mass * radius * radius;
        let a = 0.5 * c + transverse * mass * height * height;
        Body::new(mass, radius, height, a, c).unwrap()
    })
}

/// A friction law of each kind.
fn any_friction(body: &Body) -> impl Strategy<Value = FrictionLaw> + use<> {
    let (unit, mass) = ((GRAVITY * body.radius()).sqrt(), body.mass());
    let rate = GRAVITY / unit;
    let coefficient = 0.2..1.2;
    prop_oneof![
        2 => Just(FrictionLaw::NoSlip),
        1 => Just(FrictionLaw::Frictionless),
        1 => Just(FrictionLaw::InPlace),
        1 => coefficient.clone().prop_map(|friction| Coulomb::uniform(friction).into()),
        1 => powers_of_ten(-1.0, 1.0).prop_map(move |factor| {
            let coefficient = factor * mass * rate;
            Viscous { coefficient }.into()
        }),
        1 => coefficient.clone().prop_map(move |friction| {
            let (stribeck_speed, creep_speed) = (0.3 * unit, 0.03 * unit);
            let static_friction = 1.2 * friction;
            Stribeck { friction, static_friction, stribeck_speed, creep_speed }.into()
        }),
        1 => coefficient.prop_map(move |friction| {
            let speeds = [0.0, 0.2 * unit, unit];
            let frictions = [1.1 * friction, friction, 0.9 * friction];
            Tabulated::new(&speeds, &frictions, None).unwrap().into()
        }),
    ]
}

/// A resistance of each kind, or a sum, in units of the body.
fn resistance(body: &Body, kind: usize, size: f64) -> Resistance {
    let (m, r) = (body.mass(), body.radius());
    let rate = (GRAVITY / r).sqrt();
    let rolling = |dry: f64, viscous: f64| RollingResistance {
        dry: dry * size,
        viscous: viscous * size * m * rate,
    };
    let pivoting = PivotingFriction { length: size * r };
    let air = |exponent: f64| AirDrag {
        coefficient: size * m * GRAVITY * r / libm::pow(rate, exponent - 1.0),
        exponent,
    };
    let none = Resistance::default();
    match kind {
        0 => Resistance {
            rolling: rolling(1.0, 0.0),
            ..none
        },
        1 => Resistance {
            rolling: rolling(0.0, 1.0),
            ..none
        },
        2 => Resistance { pivoting, ..none },
        3 => Resistance {
            air: air(4.0),
            ..none
        },
        4 => Resistance {
            air: air(2.5),
            ..none
        },
        _ => Resistance {
            rolling: rolling(1.0, 1.0),
            pivoting,
            air: air(4.0),
        },
    }
}

fn any_flat() -> impl Strategy<Value = FlatLanding> {
    prop_oneof![
        Just(FlatLanding::Stop),
        Just(FlatLanding::Smooth(Side::Left)),
        Just(FlatLanding::Smooth(Side::Right)),
        Just(FlatLanding::Housner),
        (0.3..0.95).prop_map(FlatLanding::Restitution),
    ]
}

/// Motions of the ground that lift a column: pulses and records, along a line and in all directions.
fn any_ground(body: &Body) -> impl Strategy<Value = Arc<Ground>> + use<> {
    let (r, h) = (body.radius(), body.height().max(0.1 * body.radius()));
    let period = TAU * ((r * r + h * h) / (GRAVITY * r)).sqrt();
    let strength = GRAVITY * r / h;
    let shape = (1.05..2.5, powers_of_ten(-0.7, 0.2), 0.0..TAU);
    (shape, any::<bool>(), any::<bool>()).prop_map(move |(shape, is_planar, is_record)| {
        let (factor, length, heading) = shape;
        let (a, period) = (factor * strength, length * period);
        let across = if is_planar { 0.0 } else { 0.4 * a };
        let turned = |x: f64, y: f64, z: f64| {
            let (sin, cos) = (libm::sin(heading), libm::cos(heading));
            [x * cos - y * sin, x * sin + y * cos, z]
        };
        let wave = |amplitude: [f64; 3], period: f64| Pulse {
            amplitude,
            shape: Shape::Sine { period },
            duration: period,
        };
        let ground = if is_record {
            let sample = |i: u32| {
                let x = f64::from(i) / 200.0;
                turned(
                    a * libm::sin(TAU * x),
                    across * libm::sin(10.0 * x + 0.3),
                    0.0,
                )
            };
            Ground::sampled(period / 200.0, (0..=200).map(sample).collect())
        } else {
            let waves = [
                wave(turned(a, 0.0, 0.0), period),
                wave(turned(0.0, across, 0.2 * across), 0.7 * period),
            ];
            Ground::pulses(waves.to_vec())
        };
        Arc::new(ground.unwrap())
    })
}

/// A start that stands, or leans within the balance tilt.
fn any_start(body: &Body) -> impl Strategy<Value = State> + use<> {
    let balance = libm::atan2(body.radius(), body.height().max(0.1 * body.radius()));
    let rate = (GRAVITY / body.radius()).sqrt();
    let yaw_rate = prop_oneof![Just(0.0), (-0.2..0.2).prop_map(move |x| x * rate)];
    prop_oneof![
        Just(State::standing()),
        (0.05..0.6, 0.0..TAU, yaw_rate).prop_map(move |(part, yaw, yaw_rate)| State {
            tilt: part * balance,
            yaw,
            yaw_rate,
            ..State::default()
        }),
    ]
}

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
