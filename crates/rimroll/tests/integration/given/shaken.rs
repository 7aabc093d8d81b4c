//! What the property tests of shaken motions draw.

use super::bodies::powers_of_ten;
use proptest::prelude::*;
use rimroll::ground::{Ground, Pulse, Shape};
use rimroll::law::{
    AirDrag, Coulomb, PivotingFriction, Resistance, RollingResistance, Stribeck, Tabulated, Viscous,
};
use rimroll::motion::{FlatLanding, Side};
use rimroll::{Body, FrictionLaw, State};
use std::f64::consts::TAU;
use std::sync::Arc;

pub const GRAVITY: f64 = 9.81;

/// Columns of all sizes.
pub fn any_column() -> impl Strategy<Value = Body> {
    let sizes = (powers_of_ten(-2.0, 3.0), powers_of_ten(-2.0, 0.0), 1.2..6.0);
    (sizes, 0.3..1.0, 0.2..0.5).prop_map(|((mass, radius, slenderness), axial, transverse)| {
        let height = slenderness * radius;
        let c = axial * mass * radius * radius;
        let a = 0.5 * c + transverse * mass * height * height;
        Body::new(mass, radius, height, a, c).unwrap()
    })
}

/// A friction law of each kind.
pub fn any_friction(body: &Body) -> impl Strategy<Value = FrictionLaw> + use<> {
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
pub fn resistance(body: &Body, kind: usize, size: f64) -> Resistance {
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

pub fn any_flat() -> impl Strategy<Value = FlatLanding> {
    prop_oneof![
        Just(FlatLanding::Stop),
        Just(FlatLanding::Smooth(Side::Left)),
        Just(FlatLanding::Smooth(Side::Right)),
        Just(FlatLanding::Housner),
        (0.3..0.95).prop_map(FlatLanding::Restitution),
    ]
}

/// Motions of the ground that lift a column: pulses and records, along a line and in all directions.
pub fn any_ground(body: &Body) -> impl Strategy<Value = Arc<Ground>> + use<> {
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
pub fn any_start(body: &Body) -> impl Strategy<Value = State> + use<> {
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
