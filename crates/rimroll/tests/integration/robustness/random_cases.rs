//! Random bodies on random tables, thrown in any way.

use crate::given::bodies::{any_body, powers_of_ten, wild_body};
use core::f64::consts::{FRAC_PI_2, PI};
use core::ops::ControlFlow;
use proptest::prelude::*;
use rimroll::law::{
    AirDrag, Coulomb, DryFrictionModel, PivotingFriction, Resistance, RollingResistance, Stribeck,
    Tabulated, Viscous,
};
use rimroll::{Body, ContactLaw, FrictionLaw, Motion, Options, State, simulate};

/// A start on a table.
#[derive(Debug, Clone)]
pub struct Case {
    pub body: Body,
    pub contact_law: ContactLaw,
    pub start: State,
    pub options: Options,
}

pub const GRAVITY: f64 = 9.8;

/// √(g/R), rad/s.
pub fn falling_rate(body: &Body) -> f64 {
    (GRAVITY / body.radius()).sqrt()
}

fn any_friction() -> impl Strategy<Value = FrictionLaw> {
    let coefficient = || {
        prop_oneof![
            1 => Just(0.0),
            1 => powers_of_ten(-9.0, -1.0),
            6 => 0.0..1.0,
            2 => 1.0..3.0,
        ]
    };
    let excess = prop_oneof![2 => Just(1.0), 1 => 1.0..1.01, 2 => 1.0..3.0];
    let speed = || powers_of_ten(-3.0, 0.0);
    prop_oneof![
        1 => Just(FrictionLaw::NoSlip),
        1 => Just(FrictionLaw::Frictionless),
        10 => (coefficient(), excess.clone()).prop_map(|(friction, excess)| FrictionLaw::Coulomb(Coulomb {
            friction,
            static_friction: friction * excess,
        })),
        // In units of m √(g/R) and √(gR): see `any_case`.
        4 => any_table(),
        2 => powers_of_ten(-3.0, 1.0).prop_map(|coefficient| FrictionLaw::Viscous(Viscous { coefficient })),
        2 => (coefficient(), excess, speed(), speed()).prop_map(|(friction, excess, stribeck_speed, creep_speed)| {
            FrictionLaw::Stribeck(Stribeck {
                friction,
                static_friction: friction * excess,
                stribeck_speed,
                creep_speed,
            })
        }),
    ]
}

/// The table with all speeds multiplied by a factor.
pub fn faster(table: &Tabulated, factor: f64) -> FrictionLaw {
    let (speeds, frictions): (Vec<_>, Vec<_>) =
        (table.points()).map(|(v, f)| (factor * v, f)).unzip();
    let sticking = Some(table.static_friction());
    FrictionLaw::Tabulated(Tabulated::new(&speeds, &frictions, sticking).expect("a table"))
}

/// Decreasing and increasing curves, for slow to fast slip, with intervals of all widths.
fn any_table() -> impl Strategy<Value = FrictionLaw> {
    let begin = prop_oneof![2 => Just(0.0), 1 => powers_of_ten(-3.0, -1.0)];
    let points = prop::collection::vec((powers_of_ten(-3.0, 0.0), 0.0..1.5), 1..8);
    let excess = prop_oneof![1 => Just(1.0), 1 => 1.0..1.5];
    (begin, 0.01..1.5, points, excess).prop_map(|(mut speed, slowest, points, excess)| {
        let (mut speeds, mut frictions) = (vec![speed], vec![slowest]);
        for (step, friction) in points {
            speed += step;
            speeds.push(speed);
            frictions.push(friction);
        }
        let sticking = Some(slowest * excess);
        FrictionLaw::Tabulated(Tabulated::new(&speeds, &frictions, sticking).expect("a table"))
    })
}

/// The parameters of a contact law that have units are given in units of the body's mass and radius and of
/// gravity.
fn in_units_of(body: &Body, contact_law: ContactLaw) -> ContactLaw {
    let (m, r, rate) = (body.mass(), body.radius(), falling_rate(body));
    let friction = match contact_law.friction {
        FrictionLaw::Tabulated(table) => faster(&table, r * rate),
        FrictionLaw::Viscous(Viscous { coefficient }) => FrictionLaw::Viscous(Viscous {
            coefficient: coefficient * m * rate,
        }),
        FrictionLaw::Stribeck(Stribeck {
            friction,
            static_friction,
            stribeck_speed,
            creep_speed,
        }) => FrictionLaw::Stribeck(Stribeck {
            friction,
            static_friction,
            stribeck_speed: stribeck_speed * r * rate,
            creep_speed: creep_speed * r * rate,
        }),
        dry => dry,
    };
    let Resistance {
        rolling,
        pivoting,
        air,
    } = contact_law.resistance;
    ContactLaw {
        friction,
        resistance: Resistance {
            rolling: RollingResistance {
                dry: rolling.dry,
                viscous: rolling.viscous * m * rate,
            },
            pivoting: PivotingFriction {
                length: pivoting.length * r,
            },
            air: AirDrag {
                coefficient: air.coefficient * m * r * r * libm::pow(rate, 3.0 - air.exponent),
                ..air
            },
        },
        ..contact_law
    }
}

fn any_resistance() -> impl Strategy<Value = Resistance> {
    let some = || prop_oneof![2 => Just(0.0), 1 => powers_of_ten(-5.0, -0.5)];
    let exponent = prop_oneof![Just(4.0), Just(2.5), 1.5..5.0];
    let resistance_rate = (some(), some(), some(), some(), exponent).prop_map(
        |(dry, viscous, length, coefficient, exponent)| Resistance {
            rolling: RollingResistance { dry, viscous },
            pivoting: PivotingFriction { length },
            air: AirDrag {
                coefficient,
                exponent,
            },
        },
    );
    prop_oneof![3 => Just(Resistance::default()), 2 => resistance_rate]
}

/// In units of √(g/R).
fn any_rate() -> impl Strategy<Value = f64> {
    let size = prop_oneof![
        2 => Just(0.0),
        2 => powers_of_ten(-12.0, -2.0),
        5 => powers_of_ten(-2.0, 0.5),
        2 => powers_of_ten(0.5, 2.0),
    ];
    (size, any::<bool>()).prop_map(|(size, back)| if back { -size } else { size })
}

fn any_tilt() -> impl Strategy<Value = f64> {
    prop_oneof![
        1 => powers_of_ten(-6.0, -1.0),
        6 => 0.01..1.5,
        1 => Just(FRAC_PI_2),
        1 => 1.5..3.1,
        1 => powers_of_ten(-6.0, -1.0).prop_map(|tilt| PI - tilt),
    ]
}

fn any_start() -> impl Strategy<Value = State> {
    (
        any_tilt(),
        -4.0..4.0,
        -4.0..4.0,
        any_rate(),
        any_rate(),
        any_rate(),
    )
        .prop_map(|(tilt, yaw, spin, tilt_rate, yaw_rate, spin_rate)| State {
            tilt,
            tilt_rate,
            yaw,
            yaw_rate,
            spin,
            spin_rate,
        })
}

fn any_contact_law() -> impl Strategy<Value = ContactLaw> {
    let restitution =
        prop_oneof![2 => Just(0.0), 1 => Just(1.0), 1 => powers_of_ten(-6.0, -1.0), 3 => 0.0..1.0];
    (any_friction(), restitution, any_resistance()).prop_map(
        |(friction, restitution, resistance)| ContactLaw {
            friction,
            restitution,
            resistance,
        },
    )
}

pub fn any_case() -> impl Strategy<Value = Case> {
    any_case_of(any_body())
}

/// Bodies that wobble in place.
pub fn case_in_place() -> impl Strategy<Value = Case> {
    any_case().prop_map(|mut case| {
        case.contact_law.friction = FrictionLaw::InPlace;
        case.start.spin_rate = -case.start.yaw_rate;
        case
    })
}

/// Bodies at the limits of rigid-body inertias, at tight tolerances. These cases have few steps, because the
/// fastest relaxation requires slow, implicit steps.
pub fn wild_case() -> impl Strategy<Value = Case> {
    (any_case_of(wild_body()), powers_of_ten(-13.0, -11.0)).prop_map(|(mut case, rtol)| {
        case.options.max_steps = 500;
        case.options.rtol = rtol;
        case
    })
}

fn any_case_of(body: impl Strategy<Value = Body>) -> impl Strategy<Value = Case> {
    let rtol = prop_oneof![1 => powers_of_ten(-13.0, -4.0), 1 => powers_of_ten(-13.0, -11.0)];
    (body, any_contact_law(), any_start(), 0.5..10.0, rtol).prop_map(
        |(body, contact_law, start, duration, rtol)| {
            let rate = falling_rate(&body);
            let mut start = State {
                tilt_rate: start.tilt_rate * rate,
                yaw_rate: start.yaw_rate * rate,
                spin_rate: start.spin_rate * rate,
                ..start
            };
            if body.height() > 0.0 && start.tilt > FRAC_PI_2 - 1e-3 {
                // Such a start counts as toppled; this one is its mirror image before π/2.
                start.tilt = PI - start.tilt;
            }
            if start.tilt >= FRAC_PI_2 && body.height() > 0.0 {
                start.tilt = 1.5;
            }
            Case {
                body,
                contact_law: in_units_of(&body, contact_law),
                start,
                options: Options {
                    duration: duration / rate,
                    gravity: GRAVITY,
                    rtol,
                    max_steps: MAX_STEPS,
                    ..Options::default()
                },
            }
        },
    )
}

/// The maximal number of steps; a longer wobble is cut off there.
const MAX_STEPS: usize = 4_000;

pub fn follow(case: &Case) -> Motion {
    let Case {
        body,
        start,
        contact_law,
        options,
    } = case;
    simulate(body, start, contact_law.clone(), options, |_| {
        ControlFlow::Continue(())
    })
    .expect("valid input")
}
