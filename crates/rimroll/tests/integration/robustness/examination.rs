//! What must hold for every motion.
//!
//! Energies are relative to that of the start: |kinetic + potential|, or m g R sin φ if that is larger.
//! Forces are relative to m (g + (R + H) (rates)²), the scale of their terms.

use super::random_cases::{Case, GRAVITY, falling_rate, follow};
use core::f64::consts::FRAC_PI_2;
use rimroll::law::DynamicsExt;
use rimroll::law::{Coulomb, DryFriction, DryFrictionModel, Stribeck};
use rimroll::motion::{COLUMNS, EventKind, Instant, Phase};
use rimroll::turn::painleve_friction;
use rimroll::{FrictionLaw, Motion, Status};

/// The violations found in a motion, and the largest errors measured.
#[derive(Debug, Default, Clone)]
pub struct Found {
    pub violations: Vec<String>,
    /// The energy change that no loss accounts for.
    pub budget: f64,
    /// The increase of energy.
    pub rise: f64,
    /// The negative normal force.
    pub pull: f64,
    /// Friction outside the friction cone, or less than the friction of slip.
    pub cone: f64,
    /// The depth of the rim below the table, in radii.
    pub under: f64,
    /// The jump of the position or of the velocities at a change of contact, in radians and relative to the
    /// sum of all rates.
    pub joint: f64,
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
    for at in motion.trajectory.samples(3) {
        for (name, value) in COLUMNS.iter().zip(motion.observables(&at)) {
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
    let last = motion.trajectory.end().t;
    for at in motion.trajectory.nodes() {
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
    let begin = motion.trajectory.start();
    let start = energy(&begin);
    let weight = case.body.mass() * GRAVITY * case.body.radius();
    let scale = start.abs().max(weight * begin.sin);
    let allowed = if case.options.rtol <= 1e-11 {
        1e-9
    } else {
        1e-9 + 300.0 * case.options.rtol
    };
    let (mut lowest, mut lost) = (start, [0.0; 3]);
    for at in motion.trajectory.nodes() {
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
    let nodes: Vec<_> = motion.trajectory.nodes().collect();
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
        Phase::Flying | Phase::FlyingLevel => EventKind::LiftOff,
        Phase::Standing => EventKind::Stand,
        Phase::SlidingFlat => EventKind::Slip,
        Phase::Lying => EventKind::Topple,
    };
    let mut t = 0.0;
    for event in &motion.events {
        if event.at.t < t {
            found.report("events out of order", t - event.at.t, &event.at);
        }
        t = event.at.t;
    }
    let mut phase = motion.trajectory.start().phase;
    for at in motion.trajectory.phases() {
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
    let end = motion.trajectory.end();
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
    let end = motion.trajectory.end();
    let begin = motion.trajectory.start();
    let above_rest = |at: &Instant| {
        let energy = motion.dynamics(at).energy(at);
        energy.kinetic + energy.potential.abs()
    };
    let paradoxical = |friction: f64| friction >= painleve_friction(body) * (1.0 - 1e-6);
    let fits = match motion.status {
        Status::Finished => end.t == options.duration,
        Status::Toppled => body.height() > 0.0 && (end.tilt() - FRAC_PI_2).abs() < 1e-7,
        Status::LiftedOff => {
            contact_law.friction.ideal().is_some() || contact_law.friction == FrictionLaw::InPlace
        }
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
pub fn look(case: &Case) -> Result<(Motion, Found), String> {
    let run = std::panic::catch_unwind(|| {
        let motion = follow(case);
        let found = examine(case, &motion);
        (motion, found)
    });
    run.map_err(|_| "panicked".to_owned())
}
