//! Properties of every motion: any body, on any table, thrown in any way.
//!
//! Energies are relative to that of the start: |kinetic + potential|, or m g R sin φ if that is larger.
//! Forces are relative to m (g + (R + H) (rates)²), the scale of their terms. `census` examines any number of
//! motions and reports their endings and largest errors.

#[path = "given/bodies.rs"]
mod bodies;

use bodies::{any_body, cases, powers_of_ten, wild_body};
use core::f64::consts::{FRAC_PI_2, PI};
use core::ops::ControlFlow;
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::{RngAlgorithm, TestRng, TestRunner};
use rimroll::law::{
    AirDrag, DryFriction, PivotingFriction, Resistance, RollingResistance, Tabulated,
};
use rimroll::law::{Coulomb, DryFrictionModel, Stribeck, Viscous};
use rimroll::motion::{COLUMNS, EventKind, Instant, Phase};
use rimroll::turn::painleve_friction;
use rimroll::{Body, ContactLaw, FrictionLaw, Motion, Options, State, Status, simulate};
use std::collections::BTreeMap;

/// A start on a table.
#[derive(Debug, Clone)]
struct Case {
    body: Body,
    contact_law: ContactLaw,
    start: State,
    options: Options,
}

const GRAVITY: f64 = 9.8;

/// √(g/R), rad/s.
fn falling_rate(body: &Body) -> f64 {
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
fn faster(table: &Tabulated, factor: f64) -> FrictionLaw {
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

fn any_case() -> impl Strategy<Value = Case> {
    any_case_of(any_body())
}

/// Bodies at the limits of rigid-body inertias, at tight tolerances. These cases have few steps, because the
/// fastest relaxation requires slow, implicit steps.
fn wild_case() -> impl Strategy<Value = Case> {
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

fn follow(case: &Case) -> Motion {
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

/// The violations found in a motion, and the largest errors measured.
#[derive(Debug, Default, Clone)]
struct Found {
    violations: Vec<String>,
    /// The energy change that no loss accounts for.
    budget: f64,
    /// The increase of energy.
    rise: f64,
    /// The negative normal force.
    pull: f64,
    /// Friction outside the friction cone, or less than the friction of slip.
    cone: f64,
    /// The depth of the rim below the table, in radii.
    under: f64,
    /// The jump of the position or of the velocities at a change of contact, in radians and relative to the
    /// sum of all rates.
    joint: f64,
}

impl Found {
    fn report(&mut self, what: &str, amount: f64, at: &Instant) {
        if self.violations.len() < 4 {
            let where_ = format!("t = {:e}, {:?}, tilt {:e}", at.t, at.phase, at.tilt());
            self.violations
                .push(format!("{what} by {amount:e} at {where_}"));
        }
    }

    /// Keeps the largest amount, and reports it if it exceeds `allowed`.
    fn measure(
        &mut self,
        worst: fn(&mut Found) -> &mut f64,
        what: &str,
        amount: f64,
        allowed: f64,
        at: &Instant,
    ) {
        let largest = worst(self);
        *largest = largest.max(amount);
        // A NaN is a violation, too.
        if amount.is_nan() || amount > allowed {
            self.report(what, amount, at);
        }
    }
}

fn examine(case: &Case, motion: &Motion) -> Found {
    let mut found = Found::default();
    numbers(motion, &mut found);
    forces(case, motion, &mut found);
    energies(case, motion, &mut found);
    joints(case, motion, &mut found);
    events(motion, &mut found);
    turns(case, motion, &mut found);
    ending(case, motion, &mut found);
    found
}

/// Every number is finite, and time increases.
fn numbers(motion: &Motion, found: &mut Found) {
    let mut t = 0.0;
    for at in motion.track.samples(3) {
        for (name, value) in COLUMNS.iter().zip(motion.moment(&at)) {
            // With zero normal force, friction that is not proportional to it has an infinite ratio.
            let follows_load = motion.dynamics(&at).friction_ratio(&at).is_some();
            let infinite = *name == "friction_ratio" && !value.is_nan() && !follows_load;
            if !(value.is_finite() || infinite) {
                found.report(name, value, &at);
            }
        }
        // Within a step, time is a polynomial that is accurate to the last digits.
        if at.t < t * (1.0 - 1e-13) {
            found.report("time goes back", t - at.t, &at);
        }
        t = t.max(at.t);
    }
}

/// The normal force is positive, the rim does not penetrate the table, and friction obeys Coulomb's law.
fn forces(case: &Case, motion: &Motion, found: &mut Found) {
    let Case {
        body,
        contact_law,
        options,
        ..
    } = case;
    let reach = body.radius() + body.height();
    let allowed = 1e-7 + 10.0 * options.rtol;
    let last = motion.track.end().t;
    for at in motion.track.nodes() {
        let deep = -at.gap / body.radius();
        found.measure(
            |f| &mut f.under,
            "under the table",
            deep,
            1e-12 + 1e-5 * options.rtol,
            &at,
        );
        if matches!(at.phase, Phase::Flying | Phase::Lying) {
            continue;
        }
        if (at.gap, at.gap_rate) != (0.0, 0.0) {
            found.report("touches and is off the table", at.gap, &at);
        }
        let law = motion.dynamics(&at);
        let force = law.contact(&at);
        let friction = libm::hypot(force.along, force.across);
        let inertial = at.sin * at.p * at.p + at.w * at.w + (at.w * at.sin * at.s).abs();
        let size = body.mass() * (at.sin * GRAVITY + reach * inertial) + friction;
        // Only the first and the last instant may violate these conditions.
        if at.t == 0.0 || at.t == last {
            continue;
        }
        found.measure(
            |f| &mut f.pull,
            "pulled down",
            -force.normal / size,
            allowed,
            &at,
        );
        if at.phase == Phase::Rolling {
            let [slip_x, slip_y] = law.slip(&at);
            if (slip_x, slip_y) != (0.0, 0.0) {
                found.report("slips while it rolls", libm::hypot(slip_x, slip_y), &at);
            }
        }
        let [slip_x, slip_y] = law.slip(&at);
        let coefficients = match &contact_law.friction {
            FrictionLaw::Coulomb(Coulomb {
                friction,
                static_friction,
            }) => Some((*friction, *static_friction)),
            FrictionLaw::Tabulated(table) => {
                let kinetic = table.coefficient(libm::hypot(slip_x, slip_y));
                Some((kinetic, table.static_friction()))
            }
            _ => None,
        };
        if let Some((kinetic, static_friction)) = coefficients {
            let excess = match at.phase {
                Phase::Rolling => friction - static_friction * force.normal,
                _ => (friction - kinetic * force.normal).abs(),
            };
            found.measure(
                |f| &mut f.cone,
                "off the friction cone",
                excess / size,
                allowed,
                &at,
            );
        }
    }
}

/// Energy does not increase, every loss is recorded, and no recorded loss decreases.
fn energies(case: &Case, motion: &Motion, found: &mut Found) {
    let energy = |at: &Instant| motion.dynamics(at).energy(at).total();
    let losses = |at: &Instant| [at.friction_loss, at.resistance_loss, at.impact_loss];
    let begin = motion.track.start();
    let start = energy(&begin);
    let weight = case.body.mass() * GRAVITY * case.body.radius();
    let scale = start.abs().max(weight * begin.sin);
    let allowed = if case.options.rtol <= 1e-11 {
        1e-9
    } else {
        1e-9 + 300.0 * case.options.rtol
    };
    let (mut lowest, mut lost) = (start, [0.0; 3]);
    for at in motion.track.nodes() {
        let (now, losses) = (energy(&at), losses(&at));
        let missing = (now + losses.iter().sum::<f64>() - start).abs() / scale;
        found.measure(
            |f| &mut f.budget,
            "the budget is off",
            missing,
            allowed,
            &at,
        );
        found.measure(
            |f| &mut f.rise,
            "energy rises",
            (now - lowest) / scale,
            allowed,
            &at,
        );
        lowest = lowest.min(now);
        for (before, now) in lost.iter_mut().zip(losses) {
            if now < *before - 0.01 * allowed * scale {
                found.report("a loss falls", (*before - now) / scale, &at);
            }
            *before = before.max(now);
        }
    }
}

/// Where one phase follows another the position is continuous and, except in an impact, so are the
/// velocities. The end of a dry slip is one straight step, so short that the relative change of the
/// velocities is below the square root of the tolerance; the error is of second order in that change.
fn joints(case: &Case, motion: &Motion, found: &mut Found) {
    let reach = case.body.radius() + case.body.height();
    let rtol = case.options.rtol;
    let allowed = |before: &Instant| match before.phase {
        Phase::Sliding => 1e-9 + rtol.sqrt(),
        _ => 1e-9 + 10.0 * rtol,
    };
    let place = |at: &Instant| {
        let [x, y] = at.center();
        [at.yaw, at.sin, at.cos, x / reach, y / reach]
    };
    let moving = |at: &Instant| {
        let [vx, vy] = motion.dynamics(at).center_velocity(at);
        [at.p, at.w, at.s, vx / reach, vy / reach]
    };
    let apart = |one: [f64; 5], other: [f64; 5]| {
        let apart = one.into_iter().zip(other).map(|(a, b)| (a - b).abs());
        apart.fold(0.0, f64::max)
    };
    let nodes: Vec<_> = motion.track.nodes().collect();
    for pair in nodes.windows(2) {
        let [before, after] = [&pair[0], &pair[1]];
        if before.phase == after.phase {
            continue;
        }
        let size = 1.0 + before.yaw.abs();
        found.measure(
            |f| &mut f.joint,
            "moved where the contact changes",
            apart(place(before), place(after)) / size,
            allowed(before),
            after,
        );
        if before.phase == Phase::Flying || after.phase == Phase::Lying {
            continue;
        }
        let rates = before.p.abs() + before.w.abs() + before.s.abs() + falling_rate(&case.body);
        found.measure(
            |f| &mut f.joint,
            "jerked where the contact changes",
            apart(moving(before), moving(after)) / rates,
            allowed(before),
            after,
        );
    }
}

/// Events are in order and agree with the phases.
fn events(motion: &Motion, found: &mut Found) {
    let begins_with = |phase| match phase {
        Phase::Rolling => EventKind::Stick,
        Phase::Sliding => EventKind::Slip,
        Phase::Flying => EventKind::LiftOff,
        Phase::Lying => EventKind::Topple,
    };
    let mut t = 0.0;
    for event in &motion.events {
        if event.at.t < t {
            found.report("events out of order", t - event.at.t, &event.at);
        }
        t = event.at.t;
    }
    let mut phase = motion.track.start().phase;
    for at in motion.track.phases() {
        let has_event = |kind| {
            let mut events = motion.events.iter();
            events.any(|event| event.at.t == at.t && event.kind == kind)
        };
        if at.phase != phase && !has_event(begins_with(at.phase)) {
            found.report("a phase begins without its event", 0.0, &at);
        }
        phase = at.phase;
    }
}

/// Turns follow one another without a gap and end before the motion does. A body with height does not pass
/// its edge.
fn turns(case: &Case, motion: &Motion, found: &mut Found) {
    let end = motion.track.end();
    let mut last = None;
    for turn in &motion.turns {
        let inside = 0.0 <= turn.start && turn.end <= end.t;
        if !(inside && turn.start <= turn.t && turn.t <= turn.end) {
            found.report("a turn outside the motion", turn.end - end.t, &end);
        }
        if last.is_some_and(|last| last != turn.start) {
            found.report("a gap between turns", turn.start, &end);
        }
        last = Some(turn.end);
    }
    let on_edge = |event: &rimroll::motion::Event| event.kind == EventKind::OnEdge;
    if case.body.height() > 0.0 && motion.events.iter().any(on_edge) {
        found.report("passes its edge", 0.0, &end);
    }
}

/// The motion ended as its status says.
fn ending(case: &Case, motion: &Motion, found: &mut Found) {
    let Case {
        body,
        contact_law,
        options,
        ..
    } = case;
    let end = motion.track.end();
    let begin = motion.track.start();
    let above_rest = |at: &Instant| {
        let energy = motion.dynamics(at).energy(at);
        energy.kinetic + energy.potential.abs()
    };
    let paradoxical = |friction: f64| friction >= painleve_friction(body) * (1.0 - 1e-6);
    let fits = match motion.status {
        Status::Finished => end.t == options.duration,
        Status::Toppled => body.height() > 0.0 && (end.tilt() - FRAC_PI_2).abs() < 1e-7,
        Status::LiftedOff => contact_law.friction.ideal().is_some(),
        Status::FaceDown => end.sin <= 1.001e-9,
        // The energy left when the body lies flat is lost with the ending.
        Status::AtRest => end.sin <= 1.001e-9 || above_rest(&end) <= 1.001e-10 * above_rest(&begin),
        Status::Painleve => match &contact_law.friction {
            FrictionLaw::Tabulated(table) => {
                let frictions = table.points().map(|(_, friction)| friction);
                paradoxical(frictions.fold(table.static_friction(), f64::max))
            }
            FrictionLaw::Coulomb(Coulomb {
                static_friction, ..
            })
            | FrictionLaw::Stribeck(Stribeck {
                static_friction, ..
            }) => paradoxical(*static_friction),
            _ => false,
        },
        Status::Failed => motion.work.steps >= options.max_steps,
        Status::Interrupted => false,
    };
    if !fits {
        found.violations.push(motion.message());
    }
}

/// A motion and its violations, or the message of a panic.
fn look(case: &Case) -> Result<(Motion, Found), String> {
    let run = std::panic::catch_unwind(|| {
        let motion = follow(case);
        let found = examine(case, &motion);
        (motion, found)
    });
    run.map_err(|_| "panicked".to_owned())
}

proptest! {
    #![proptest_config(cases(1000))]

    #[test]
    fn every_motion_obeys_mechanics_and_ends_in_truth(case in any_case()) {
        let (_, found) = look(&case).map_err(TestCaseError::fail)?;
        prop_assert!(found.violations.is_empty(), "{:?}\n{case:?}", found.violations);
    }
}

proptest! {
    #![proptest_config(cases(300))]

    #[test]
    fn so_do_bodies_that_nobody_would_build(case in wild_case()) {
        let (_, found) = look(&case).map_err(TestCaseError::fail)?;
        prop_assert!(found.violations.is_empty(), "{:?}\n{case:?}", found.violations);
    }
}

proptest! {
    #![proptest_config(cases(150))]

    /// Mirror images move alike. (`endings.rs` tests that without slip or friction they agree to the last
    /// bit.)
    #[test]
    fn mirror_images_agree(case in any_case()) {
        let start = case.start;
        let image = Case {
            start: State {
                yaw: -start.yaw,
                yaw_rate: -start.yaw_rate,
                spin: -start.spin,
                spin_rate: -start.spin_rate,
                ..start
            },
            ..case.clone()
        };
        agree_at_first(&case, &follow(&case), &follow(&image), -1.0)?;
    }

    /// The table is isotropic.
    #[test]
    fn a_turned_start_is_a_turned_motion(case in any_case(), yaw in -3.0..3.0) {
        let turned = Case { start: State { yaw, ..case.start }, ..case.clone() };
        agree_at_first(&case, &follow(&case), &follow(&turned), 1.0)?;
    }

    /// Similarity: a body larger and heavier by powers of two has the same motion on a longer time scale, to
    /// the last bit, since powers of two do not round. Lengths scale by 4, so that times scale by 2.
    #[test]
    fn a_larger_body_does_the_same_slower(case in any_case()) {
        let b = case.body;
        let (length, mass, time) = (4.0, 8.0, 2.0);
        let inertia = mass * length * length;
        let body = Body::new(
            mass * b.mass(),
            length * b.radius(),
            length * b.height(),
            inertia * b.transverse_inertia(),
            inertia * b.axial_inertia(),
        ).expect("a rigid body");
        let slower = |rate: f64| rate / time;
        let larger = Case {
            body,
            contact_law: ContactLaw {
                friction: match case.contact_law.friction.clone() {
                    FrictionLaw::Tabulated(table) => faster(&table, length / time),
                    FrictionLaw::Viscous(Viscous { coefficient }) => FrictionLaw::Viscous(Viscous {
                        coefficient: coefficient * mass / time,
                    }),
                    FrictionLaw::Stribeck(Stribeck { friction, static_friction, stribeck_speed, creep_speed }) => {
                        FrictionLaw::Stribeck(Stribeck {
                            friction,
                            static_friction,
                            stribeck_speed: stribeck_speed * length / time,
                            creep_speed: creep_speed * length / time,
                        })
                    }
                    dry => dry,
                },
                resistance: Resistance::default(),
                ..case.contact_law.clone()
            },
            start: State {
                tilt_rate: slower(case.start.tilt_rate),
                yaw_rate: slower(case.start.yaw_rate),
                spin_rate: slower(case.start.spin_rate),
                ..case.start
            },
            options: Options { duration: time * case.options.duration, ..case.options },
        };
        let contact_law = ContactLaw { resistance: Resistance::default(), ..case.contact_law.clone() };
        let (one, other) = (follow(&Case { contact_law, ..case.clone() }), follow(&larger));
        prop_assert_eq!(one.status, other.status);
        prop_assert_eq!(one.work, other.work);
        let (a, b) = (one.track.end(), other.track.end());
        prop_assert_eq!((a.sin, a.yaw, time * a.t), (b.sin, b.yaw, b.t));
        prop_assert_eq!((a.p, a.w, a.s), (time * b.p, time * b.w, time * b.s));
        prop_assert_eq!(a.impact_loss * inertia / (time * time), b.impact_loss);
    }

    /// A tighter tolerance brings the motion closer to that with the tightest tolerance.
    #[test]
    fn tolerances_converge(case in any_case()) {
        let at = |rtol| {
            let options = Options { rtol, ..case.options };
            follow(&Case { options, ..case.clone() })
        };
        let (loose, tight, tightest) = (at(1e-6), at(1e-9), at(1e-12));
        // The duration is short, because a motion can be chaotic after a threshold or a near-collision.
        let ends = [&loose, &tight, &tightest].map(|motion| motion.track.end().t);
        let t = 0.05 * ends.into_iter().fold(f64::INFINITY, f64::min);
        let tilt = |motion: &Motion| motion.track.at(t).tilt();
        let (off, less) = (tilt(&loose) - tilt(&tightest), tilt(&tight) - tilt(&tightest));
        prop_assert!(off.abs() < 1e-3 && less.abs() < 1e-6, "{off:e} {less:e}");
    }

    /// Dry friction with μ = 0 equals no friction while the rim stays on the table.
    #[test]
    fn no_dry_friction_is_frictionless(case in any_case()) {
        let on = |friction| {
            let contact_law = ContactLaw {
                friction,
                resistance: Resistance::default(),
                ..case.contact_law.clone()
            };
            follow(&Case { contact_law, ..case.clone() })
        };
        agree_while_they_last(&case, &on(FrictionLaw::Frictionless), &on(FrictionLaw::coulomb(0.0)))?;
    }

    /// Dry friction that always suffices to stick equals no slip.
    #[test]
    fn much_dry_friction_is_no_slip(case in any_case()) {
        let on = |friction| {
            let contact_law = ContactLaw {
                friction,
                resistance: Resistance::default(),
                ..case.contact_law.clone()
            };
            follow(&Case { contact_law, ..case.clone() })
        };
        agree_while_they_last(&case, &on(FrictionLaw::NoSlip), &on(FrictionLaw::coulomb(1e5)))?;
    }
}

/// Whether two motions agree up to rounding and the sign of yaw and spin. The comparison is short, because
/// near-collisions, thresholds and chaos amplify rounding errors.
fn agree_at_first(
    case: &Case,
    one: &Motion,
    other: &Motion,
    sign: f64,
) -> Result<(), TestCaseError> {
    let ends = [one, other].map(|motion| motion.track.end().t);
    let t = 0.05 * case.options.duration.min(ends[0]).min(ends[1]);
    let (a, b) = (one.track.at(t), other.track.at(t));
    let rates = a.p.abs() + a.w.abs() + a.s.abs() + falling_rate(&case.body);
    let allowed = 1e-6 + 1e4 * case.options.rtol;
    prop_assert!(a.phase == b.phase || (one.track.at(0.9 * t).phase != a.phase));
    prop_assert!((a.tilt() - b.tilt()).abs() < allowed);
    prop_assert!((a.s - sign * b.s).abs() < allowed * rates);
    Ok(())
}

/// Whether a motion under an ideal law and the same motion under dry friction agree until the end of the
/// first phase or of the shorter motion.
fn agree_while_they_last(case: &Case, ideal: &Motion, dry: &Motion) -> Result<(), TestCaseError> {
    let start = ideal.track.start();
    let phases: Vec<_> = dry.track.phases().collect();
    if phases[0].phase == Phase::Flying {
        prop_assert_eq!(ideal.status, Status::LiftedOff);
        return Ok(());
    }
    let changed = phases.get(1).map_or(dry.track.end().t, |at| at.t);
    let t = changed.min(ideal.track.end().t);
    let (a, b) = (ideal.track.at(t), dry.track.at(t));
    // A near-collision amplifies errors by the ratio of the tilts.
    let lowest = ideal.track.nodes().filter(|at| at.t <= t);
    let lowest = lowest.fold(start.sin, |lowest, at| lowest.min(at.sin));
    let allowed = (1e-9 + 1e3 * case.options.rtol) / lowest;
    prop_assert!(
        (a.tilt() - b.tilt()).abs() < allowed,
        "tilt {} {}",
        a.tilt(),
        b.tilt()
    );
    prop_assert!(
        (a.yaw - b.yaw).abs() < allowed * (1.0 + a.yaw.abs()),
        "yaw {} {}",
        a.yaw,
        b.yaw
    );
    Ok(())
}

/// The case with a given number in a series.
fn numbered(series: u64, number: u64) -> Case {
    let mut seed = [7u8; 32];
    seed[..8].copy_from_slice(&series.to_le_bytes());
    seed[8..16].copy_from_slice(&number.to_le_bytes());
    let rng = TestRng::from_seed(RngAlgorithm::ChaCha, &seed);
    let mut runner = TestRunner::new_with_rng(cases(1), rng);
    let cases = match std::env::var("WILD") {
        Ok(_) => wild_case().boxed(),
        Err(_) => any_case().boxed(),
    };
    cases.new_tree(&mut runner).expect("a case").current()
}

/// The path length of the motion, in radians of yaw, tilt and spin, to judge the number of steps.
fn way(motion: &Motion) -> f64 {
    let nodes: Vec<_> = motion.track.nodes().collect();
    let between = |pair: &[Instant]| {
        let [a, b] = [pair[0], pair[1]];
        (b.yaw - a.yaw).abs() + (b.tilt() - a.tilt()).abs() + (a.s * (b.t - a.t)).abs()
    };
    nodes.windows(2).map(between).sum()
}

/// `SERIES=1 COUNT=10000 cargo test --release --test robustness -- --ignored --nocapture census`; `ONLY=17`
/// shows one case in full, `WILD=1` draws extreme bodies.
#[test]
#[ignore = "minutes: a census of many motions"]
fn census() {
    let number = |name: &str| std::env::var(name).ok().and_then(|text| text.parse().ok());
    let (series, count) = (
        number("SERIES").unwrap_or(1),
        number("COUNT").unwrap_or(2000),
    );
    let only: Option<u64> = number("ONLY");
    let mut census = Census::default();
    for i in only.map_or(0..count, |only| only..only + 1) {
        let mut case = numbered(series, i);
        case.options.max_steps = 50_000;
        if only.is_some() {
            println!("{case:#?}");
        }
        match look(&case) {
            Ok((motion, found)) => census.count(i, &case, &motion, &found),
            Err(panic) => println!("#{i} {panic} {case:?}"),
        }
    }
    census.print();
}

#[derive(Default)]
struct Census {
    statuses: BTreeMap<(String, &'static str), usize>,
    steps: Vec<usize>,
    with_violations: usize,
    slow: usize,
    worst: Found,
    /// The largest energy error of motions with a tolerance of 1e-11 or less.
    tight_budget: f64,
}

impl Census {
    fn count(&mut self, i: u64, case: &Case, motion: &Motion, found: &Found) {
        let Motion { status, work, .. } = motion;
        let kind = (format!("{status:?}"), case.contact_law.friction.name());
        *self.statuses.entry(kind).or_insert(0) += 1;
        self.steps.push(work.steps);
        for (worst, new) in [
            (&mut self.worst.budget, found.budget),
            (&mut self.worst.rise, found.rise),
            (&mut self.worst.pull, found.pull),
            (&mut self.worst.cone, found.cone),
            (&mut self.worst.under, found.under),
            (&mut self.worst.joint, found.joint),
        ] {
            *worst = worst.max(new);
        }
        if case.options.rtol <= 1e-11 {
            self.tight_budget = self.tight_budget.max(found.budget);
        }
        let slow = (work.steps + work.rejected) as f64
            > 50.0 * (100.0 + way(motion) + motion.events.len() as f64);
        self.slow += usize::from(slow);
        self.with_violations += usize::from(!found.violations.is_empty());
        if slow || !found.violations.is_empty() {
            println!(
                "#{i} {} {work:?} way {:.0} rtol {:.0e}",
                motion.message(),
                way(motion),
                case.options.rtol
            );
            println!("    {:?} {:?}", found.violations, case.contact_law);
        }
    }

    fn print(mut self) {
        self.steps.sort_unstable();
        let quantile = |q: f64| self.steps[((self.steps.len() - 1) as f64 * q) as usize];
        let quantiles = [0.5, 0.9, 0.99, 0.999, 1.0].map(quantile);
        println!(
            "{} motions, {} with complaints, {} slow",
            self.steps.len(),
            self.with_violations,
            self.slow
        );
        println!("steps: median, 90, 99, 99.9 %, most: {quantiles:?}");
        println!(
            "{:?}, budget at tight tolerances {:e}",
            self.worst, self.tight_budget
        );
        for (kind, count) in &self.statuses {
            println!("{count:6} {kind:?}");
        }
    }
}
