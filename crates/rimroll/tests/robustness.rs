//! Any body, on any table, thrown in any way: what must be true of every motion.

#[path = "given/bodies.rs"]
mod bodies;

use bodies::{any_body, cases, powers_of_ten};
use core::f64::consts::{FRAC_PI_2, PI};
use core::ops::ControlFlow;
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::{RngAlgorithm, TestRng, TestRunner};
use rimroll::law::{AirDrag, PivotingFriction, Resistance, RollingResistance};
use rimroll::motion::{COLUMNS, EventKind, Instant, Phase};
use rimroll::turn::painleve_friction;
use rimroll::{Body, FrictionLaw, Motion, Options, State, Status, Surface, simulate};

/// A start on a table.
#[derive(Debug, Clone, Copy)]
struct Case {
    body: Body,
    surface: Surface,
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
        10 => (coefficient(), excess.clone()).prop_map(|(friction, excess)| FrictionLaw::Coulomb {
            friction,
            static_friction: friction * excess,
        }),
        // In units of m √(g/R) and √(gR): see `any_case`.
        2 => powers_of_ten(-3.0, 1.0).prop_map(|coefficient| FrictionLaw::Viscous { coefficient }),
        2 => (coefficient(), excess, speed(), speed()).prop_map(|(friction, excess, stribeck_speed, creep_speed)| {
            FrictionLaw::Stribeck {
                friction,
                static_friction: friction * excess,
                stribeck_speed,
                creep_speed,
            }
        }),
    ]
}

/// The numbers of a surface, with a unit, are given in those of a body of mass, radius and gravity 1.
fn in_units_of(body: &Body, surface: Surface) -> Surface {
    let (m, r, rate) = (body.mass(), body.radius(), falling_rate(body));
    let friction = match surface.friction {
        FrictionLaw::Viscous { coefficient } => FrictionLaw::Viscous {
            coefficient: coefficient * m * rate,
        },
        FrictionLaw::Stribeck {
            friction,
            static_friction,
            stribeck_speed,
            creep_speed,
        } => FrictionLaw::Stribeck {
            friction,
            static_friction,
            stribeck_speed: stribeck_speed * r * rate,
            creep_speed: creep_speed * r * rate,
        },
        dry => dry,
    };
    let Resistance {
        rolling,
        pivoting,
        air,
    } = surface.resistance;
    Surface {
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
        ..surface
    }
}

fn any_resistance() -> impl Strategy<Value = Resistance> {
    let some = || prop_oneof![2 => Just(0.0), 1 => powers_of_ten(-5.0, -0.5)];
    let exponent = prop_oneof![Just(4.0), Just(2.5), 1.5..5.0];
    let resisting = (some(), some(), some(), some(), exponent).prop_map(
        |(dry, viscous, length, coefficient, exponent)| Resistance {
            rolling: RollingResistance { dry, viscous },
            pivoting: PivotingFriction { length },
            air: AirDrag {
                coefficient,
                exponent,
            },
        },
    );
    prop_oneof![3 => Just(Resistance::default()), 2 => resisting]
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

fn any_surface() -> impl Strategy<Value = Surface> {
    let restitution =
        prop_oneof![2 => Just(0.0), 1 => Just(1.0), 1 => powers_of_ten(-6.0, -1.0), 3 => 0.0..1.0];
    (any_friction(), restitution, any_resistance()).prop_map(
        |(friction, restitution, resistance)| Surface {
            friction,
            restitution,
            resistance,
        },
    )
}

fn any_case() -> impl Strategy<Value = Case> {
    let rtol = prop_oneof![1 => powers_of_ten(-13.0, -4.0), 1 => powers_of_ten(-13.0, -11.0)];
    (any_body(), any_surface(), any_start(), 0.5..10.0, rtol).prop_map(
        |(body, surface, start, duration, rtol)| {
            let rate = falling_rate(&body);
            let mut start = State {
                tilt_rate: start.tilt_rate * rate,
                yaw_rate: start.yaw_rate * rate,
                spin_rate: start.spin_rate * rate,
                ..start
            };
            if body.height() > 0.0 && start.tilt > FRAC_PI_2 - 1e-3 {
                // It would have toppled: as much before as this is after.
                start.tilt = PI - start.tilt;
            }
            if start.tilt >= FRAC_PI_2 && body.height() > 0.0 {
                start.tilt = 1.5;
            }
            Case {
                body,
                surface: in_units_of(&body, surface),
                start,
                options: Options {
                    duration: duration / rate,
                    gravity: GRAVITY,
                    rtol,
                    max_steps: MOST_STEPS,
                    ..Options::default()
                },
            }
        },
    )
}

const MOST_STEPS: usize = 50_000;

fn follow(case: &Case) -> Motion {
    simulate(&case.body, &case.start, case.surface, &case.options, |_| {
        ControlFlow::Continue(())
    })
    .expect("valid input")
}

/// What is measured of a motion, to be compared with what is allowed.
#[derive(Debug, Default, Clone)]
struct Found {
    complaints: Vec<String>,
    /// Of the energy's budget, over the largest energy.
    budget: f64,
    rise: f64,
    pull: f64,
    cone: f64,
    under: f64,
}

fn examine(case: &Case, motion: &Motion) -> Found {
    let mut found = Found::default();
    finite_and_in_order(motion, &mut found);
    forces(case, motion, &mut found);
    energies(case, motion, &mut found);
    events_agree(motion, &mut found);
    ending(case, motion, &mut found);
    found
}

fn finite_and_in_order(motion: &Motion, found: &mut Found) {
    let mut t = 0.0;
    for at in motion.track.samples(3) {
        let moment = motion.moment(&at);
        for (name, value) in COLUMNS.iter().zip(moment) {
            let fine = if *name == "friction_ratio" {
                !value.is_nan()
            } else {
                value.is_finite()
            };
            if !fine {
                found.complaints.push(format!(
                    "{name} = {value} at t = {:e} in {:?} tilt {:e}",
                    at.t,
                    at.phase,
                    at.tilt()
                ));
                return;
            }
        }
        if at.t < t - 1e-13 * t {
            found.complaints.push(format!(
                "time goes back from {t:e} to {:e} by {:e} in {:?} sin {:e}",
                at.t,
                t - at.t,
                at.phase,
                at.sin
            ));
            return;
        }
        t = at.t.max(t);
    }
}

fn forces(case: &Case, motion: &Motion, found: &mut Found) {
    let b = &case.body;
    let reach = b.radius() + b.height();
    let rate = falling_rate(b);
    let mut said = [false; 5];
    for at in motion.track.nodes() {
        if at.gap < -(1e-12 + 1e-7 * case.options.rtol) * b.radius()
            && !core::mem::replace(&mut said[0], true)
        {
            found
                .complaints
                .push(format!("gap = {:e} at t = {:e}", at.gap, at.t));
        }
        found.under = found.under.max(-at.gap / b.radius());
        if at.phase == Phase::Flying {
            continue;
        }
        if (at.gap != 0.0 || at.gap_rate != 0.0) && !core::mem::replace(&mut said[4], true) {
            found.complaints.push(format!(
                "gap {:e} or rate {:e} in contact at t = {:e}",
                at.gap, at.gap_rate, at.t
            ));
        }
        let law = motion.law(&at);
        let contact = law.contact(&at);
        let size = b.mass()
            * (at.sin * GRAVITY
                + reach
                    * (at.sin * (at.p * at.p) + at.w.abs() * (at.w.abs() + at.sin * at.s.abs())));
        let pull = -contact.normal / size;
        found.pull = found.pull.max(pull);
        let ended = at == motion.track.end() || at == motion.track.start();
        let allowed = if ended {
            f64::INFINITY
        } else {
            1e-7 + 10.0 * case.options.rtol
        };
        if pull > allowed && !core::mem::replace(&mut said[1], true) {
            found.complaints.push(format!(
                "N/scale = {:e} at t = {:e} in {:?}",
                -pull, at.t, at.phase
            ));
        }
        let slip = law.slip(&at);
        if at.phase == Phase::Rolling && slip != [0.0; 2] && !core::mem::replace(&mut said[2], true)
        {
            let speed = libm::hypot(slip[0], slip[1]);
            if speed > 1e-13 * reach * (at.p.abs() + at.w.abs() + at.s.abs() + rate) {
                found
                    .complaints
                    .push(format!("slip {speed:e} while rolling"));
            }
        }
        if let FrictionLaw::Coulomb {
            friction,
            static_friction,
        } = case.surface.friction
        {
            let friction_force = libm::hypot(contact.along, contact.across);
            let excess = match at.phase {
                Phase::Rolling => friction_force - static_friction * contact.normal,
                _ if at.slip_speed() > 0.0 => (friction_force - friction * contact.normal).abs(),
                _ => 0.0,
            } / size;
            found.cone = found.cone.max(excess);
            if excess > allowed && !core::mem::replace(&mut said[3], true) {
                found.complaints.push(format!(
                    "|T| − μN = {excess:e} at t = {:e} in {:?}",
                    at.t, at.phase
                ));
            }
        }
    }
}

fn energies(case: &Case, motion: &Motion, found: &mut Found) {
    let energy = |at: &Instant| {
        let law = if at.phase == Phase::Sliding
            && at.slip_speed() == 0.0
            && !matches!(case.surface.friction, FrictionLaw::Frictionless)
        {
            motion.contacts.law(Phase::Rolling)
        } else {
            motion.law(at)
        };
        law.energy(at).total()
    };
    let nodes: Vec<_> = motion.track.nodes().collect();
    let b = &case.body;
    let start = energy(&nodes[0]);
    let scale = start
        .abs()
        .max(b.mass() * GRAVITY * b.radius() * nodes[0].sin);
    let (mut least, mut losses) = (start, [0.0; 3]);
    let mut said = [false; 3];
    let allowed = 1e-9 + 10.0 * case.options.rtol;
    for at in &nodes {
        let now = energy(at);
        let lost = [at.friction_loss, at.resistance_loss, at.impact_loss];
        let budget = ((now + lost.iter().sum::<f64>() - start) / scale).abs();
        found.budget = found.budget.max(budget);
        found.rise = found.rise.max((now - least) / scale);
        if budget > allowed && !core::mem::replace(&mut said[0], true) {
            found.complaints.push(format!(
                "budget off by {budget:e} at t = {:e} in {:?}",
                at.t, at.phase
            ));
        }
        if now - least > allowed * scale && !core::mem::replace(&mut said[1], true) {
            found.complaints.push(format!(
                "energy rises by {:e} at t = {:e} in {:?}",
                (now - least) / scale,
                at.t,
                at.phase
            ));
        }
        for i in 0..3 {
            if lost[i] < losses[i] - 1e-2 * allowed * scale
                && !core::mem::replace(&mut said[2], true)
            {
                found.complaints.push(format!(
                    "loss {i} falls by {:e} at t = {:e} in {:?}",
                    (losses[i] - lost[i]) / scale,
                    at.t,
                    at.phase
                ));
            }
            losses[i] = lost[i].max(losses[i]);
        }
        least = least.min(now);
    }
}

fn events_agree(motion: &Motion, found: &mut Found) {
    let mut t = 0.0;
    for event in &motion.events {
        if event.at.t < t {
            found
                .complaints
                .push(format!("events out of order at {t:e}"));
        }
        t = event.at.t;
        let phase = event.at.phase;
        let fits = match event.kind {
            EventKind::Slip => phase == Phase::Sliding,
            EventKind::Stick => phase == Phase::Rolling,
            EventKind::LiftOff => phase == Phase::Flying || motion.status == Status::LiftedOff,
            _ => true,
        };
        if !fits {
            found
                .complaints
                .push(format!("{:?} in {phase:?}", event.kind));
        }
    }
    let mut phase = motion.track.start().phase;
    let mut changes = motion.events.iter().filter(|event| {
        matches!(
            event.kind,
            EventKind::Slip | EventKind::Stick | EventKind::LiftOff | EventKind::Land
        )
    });
    let _ = &mut changes;
    for at in motion.track.phases() {
        if at.phase != phase {
            let said = motion.events.iter().any(|event| {
                event.at.t == at.t
                    && match at.phase {
                        Phase::Rolling => matches!(event.kind, EventKind::Stick),
                        Phase::Sliding => matches!(event.kind, EventKind::Slip),
                        Phase::Flying => event.kind == EventKind::LiftOff,
                        Phase::Lying => event.kind == EventKind::Topple,
                    }
            });
            if !said {
                found.complaints.push(format!(
                    "{:?} → {:?} at t = {:e} unsaid",
                    phase, at.phase, at.t
                ));
                return;
            }
            phase = at.phase;
        }
    }
}

fn ending(case: &Case, motion: &Motion, found: &mut Found) {
    let end = motion.track.end();
    let b = &case.body;
    let energy = |at: &Instant| motion.law(at).energy(at).total();
    let fits = match motion.status {
        Status::Finished => end.t == case.options.duration,
        Status::Toppled => b.height() > 0.0 && (end.tilt() - FRAC_PI_2).abs() < 1e-7,
        Status::LiftedOff => {
            case.surface.friction.ideal().is_some()
                && motion.law(&end).contact(&end).normal.abs() < f64::INFINITY
        }
        Status::FaceDown => end.sin <= 1e-15,
        Status::AtRest => energy(&end) <= 1.001e-10 * energy(&motion.track.start()),
        Status::Painleve => match case.surface.friction {
            FrictionLaw::Coulomb { friction, .. } => {
                friction >= painleve_friction(b) * (1.0 - 1e-6)
            }
            FrictionLaw::Stribeck {
                static_friction, ..
            } => static_friction >= painleve_friction(b) * (1.0 - 1e-6),
            _ => false,
        },
        Status::Failed | Status::Interrupted => false,
    };
    if !fits {
        found.complaints.push(motion.message.clone());
    }
}

/// How motions of a kind went.
#[test]
#[ignore = "minutes: a census of many motions"]
fn census() {
    let var = |name: &str, default: u64| {
        std::env::var(name)
            .ok()
            .and_then(|v| v.parse().ok())
            .unwrap_or(default)
    };
    let (seed, count) = (var("SEED", 1), var("COUNT", 2000));
    let only = std::env::var("ONLY")
        .ok()
        .and_then(|v| v.parse::<u64>().ok());
    let mut statuses = std::collections::BTreeMap::new();
    let mut worst = Found::default();
    let mut steps = Vec::new();
    let mut bad = 0;
    for i in 0..count {
        if only.is_some_and(|only| only != i) {
            continue;
        }
        let mut bytes = [7u8; 32];
        bytes[..8].copy_from_slice(&seed.to_le_bytes());
        bytes[8..16].copy_from_slice(&i.to_le_bytes());
        let mut runner =
            TestRunner::new_with_rng(cases(1), TestRng::from_seed(RngAlgorithm::ChaCha, &bytes));
        let case = any_case().new_tree(&mut runner).unwrap().current();
        if only.is_some() {
            println!("{case:#?}");
        }
        let clock = std::time::Instant::now();
        let run = std::panic::catch_unwind(|| {
            let m = follow(&case);
            let f = examine(&case, &m);
            (m, f)
        });
        let took = clock.elapsed().as_secs_f64();
        let (motion, mut found) = match run {
            Ok(run) => run,
            Err(_) => {
                bad += 1;
                println!("#{i} PANIC {case:?}");
                continue;
            }
        };
        *statuses
            .entry((format!("{:?}", motion.status), case.surface.friction.name()))
            .or_insert(0) += 1;
        steps.push(motion.work.steps);
        let (mut natural, mut last) = (0.0, motion.track.start());
        for at in motion.track.nodes() {
            natural += (at.yaw - last.yaw).abs()
                + (at.tilt() - last.tilt()).abs()
                + (at.s * (at.t - last.t)).abs();
            last = at;
        }
        let per = (motion.work.steps + motion.work.rejected) as f64 / (100.0 + natural);
        if per > 30.0 {
            found.complaints.push(format!(
                "slow: {} steps {} rejected {took:.2} s natural {natural:.0}",
                motion.work.steps, motion.work.rejected
            ));
        }
        worst.budget = worst.budget.max(found.budget);
        worst.rise = worst.rise.max(found.rise);
        worst.pull = worst.pull.max(found.pull);
        worst.cone = worst.cone.max(found.cone);
        worst.under = worst.under.max(found.under);
        if !found.complaints.is_empty() {
            bad += 1;
            println!(
                "#{i} {:?} steps {} events {} rtol {:.0e}: {}",
                motion.status,
                motion.work.steps,
                motion.events.len(),
                case.options.rtol,
                found.complaints.join("; ")
            );
            println!(
                "     {:?} e={:.3} {}",
                case.surface.friction,
                case.surface.restitution,
                if case.surface.resistance.is_none() {
                    ""
                } else {
                    "resisted"
                }
            );
            if only.is_some() {
                for e in &motion.events {
                    println!(
                        "   {:?} t={:e} {:?} tilt={:e} p={:e} w={:e} s={:e} slip={:e},{:e} gap={:e}",
                        e.kind,
                        e.at.t,
                        e.at.phase,
                        e.at.tilt(),
                        e.at.p,
                        e.at.w,
                        e.at.s,
                        e.at.slip_x,
                        e.at.slip_y,
                        e.at.gap
                    );
                }
                let e = motion.track.end();
                println!(
                    "   END {:?} {:?} energy {:e} of {:e}",
                    e.phase,
                    e.u,
                    motion.law(&e).energy(&e).total(),
                    motion
                        .law(&motion.track.start())
                        .energy(&motion.track.start())
                        .total()
                );
                let nodes: Vec<_> = motion.track.nodes().collect();
                for at in nodes.iter().rev().take(
                    std::env::var("LAST")
                        .ok()
                        .and_then(|v| v.parse().ok())
                        .unwrap_or(5),
                ) {
                    println!(
                        "   near end: t={:e} {:?} tilt={:e} p={:e} w={:e} s={:e} slip={:e},{:e}",
                        at.t,
                        at.phase,
                        at.tilt(),
                        at.p,
                        at.w,
                        at.s,
                        at.slip_x,
                        at.slip_y
                    );
                }
            }
        }
    }
    steps.sort();
    let at = |q: f64| steps[((steps.len() - 1) as f64 * q) as usize];
    println!(
        "{bad} bad of {count}; steps median {} 90% {} 99% {} most {}",
        at(0.5),
        at(0.9),
        at(0.99),
        at(1.0)
    );
    println!("{statuses:#?}\n{worst:?}");
}
