//! A gap below which the base comes down flat: the energy and the spin that the motion keeps, and what it becomes as the gap
//! closes.

use proptest::prelude::*;
use rimroll::ground::{Ground, Pulse, Shape};
use rimroll::law::DynamicsExt;
use rimroll::motion::{
    EventKind, FlatLanding, Phase, SHAKEN_PARAMETERS, Side, shaken as shaken_one,
};
use rimroll::{
    Body, ContactLaw, FrictionLaw, Motion, Options, Shaking, State, Status, shake_many, simulate,
    simulate_on,
};
use std::f64::consts::PI;
use std::ops::ControlFlow;
use std::sync::Arc;

use crate::given::bodies;
use crate::given::cases;
use crate::given::shaken;
use bodies::powers_of_ten;
use cases::cases;
use shaken::{GRAVITY, any_column, any_flat, any_friction, any_ground, any_start, resistance};

/// What a motion begins with.
#[derive(Debug, Clone)]
struct Case {
    body: Body,
    law: ContactLaw,
    ground: Option<Arc<Ground>>,
    start: State,
    options: Options,
}

impl Case {
    fn motion(&self) -> Motion {
        let watch = |_| ControlFlow::Continue(());
        let ground = self.ground.clone();
        simulate_on(
            ground,
            &self.body,
            &self.start,
            self.law.clone(),
            &self.options,
            watch,
        )
        .unwrap()
    }

    fn with_gap(&self, gap: f64) -> Case {
        let mut case = self.clone();
        case.options.flat_gap = gap;
        case
    }
}

/// Shaken motions of all kinds, with gaps from 1e-6 R to 0.08 R, which is allowed for the most slender column.
fn any_case() -> impl Strategy<Value = Case> {
    any_column()
        .prop_flat_map(|body| {
            let law = (
                any_friction(&body),
                0..6_usize,
                prop_oneof![Just(0.0), powers_of_ten(-6.0, -2.0)],
            );
            let gap = powers_of_ten(-6.0, -1.1);
            (
                Just(body),
                law,
                any_ground(&body),
                any_start(&body),
                any_flat(),
                gap,
            )
        })
        .prop_map(
            |(body, (friction, kind, size), ground, mut start, flat, gap)| {
                if friction == FrictionLaw::InPlace {
                    start.spin_rate = -start.yaw_rate;
                }
                let (r, h) = (body.radius(), body.height());
                let options = Options {
                    duration: ground.duration() + 8.0 * ((r * r + h * h) / (GRAVITY * r)).sqrt(),
                    gravity: GRAVITY,
                    rtol: 1e-9,
                    flat,
                    flat_gap: gap * r,
                    max_steps: 20_000,
                    ..Options::default()
                };
                let law = ContactLaw {
                    resistance: resistance(&body, kind, size),
                    ..friction.into()
                };
                Case {
                    body,
                    law,
                    ground: Some(ground),
                    start,
                    options,
                }
            },
        )
}

/// A column that is let go in a plane on a table at rest.
fn any_release() -> impl Strategy<Value = Case> {
    let flat = prop_oneof![
        Just(FlatLanding::Housner),
        Just(FlatLanding::Restitution(1.0)),
        (0.3..1.0).prop_map(FlatLanding::Restitution),
    ];
    let law = prop_oneof![
        Just(FrictionLaw::NoSlip),
        Just(FrictionLaw::Frictionless),
        Just(FrictionLaw::InPlace),
    ];
    (any_column(), law, flat, 0.2..0.9, powers_of_ten(-7.0, -1.1)).prop_map(
        |(body, law, flat, part, gap)| {
            let (r, h) = (body.radius(), body.height());
            let options = Options {
                duration: 20.0 * ((r * r + h * h) / (GRAVITY * r)).sqrt(),
                gravity: GRAVITY,
                rtol: 1e-12,
                flat,
                flat_gap: gap * r,
                ..Options::default()
            };
            let start = State {
                tilt: part * libm::atan2(r, h),
                ..State::default()
            };
            Case {
                body,
                law: law.into(),
                ground: None,
                start,
                options,
            }
        },
    )
}

fn constant(amplitude: [f64; 3], duration: f64) -> Arc<Ground> {
    let shape = Shape::Constant;
    let pulse = Pulse {
        amplitude,
        shape,
        duration,
    };
    Arc::new(Ground::pulses(vec![pulse]).unwrap())
}

/// The factor of the tilt rate in an impact of the whole base.
fn factor_of(case: &Case) -> f64 {
    if let FlatLanding::Restitution(factor) = case.options.flat {
        return factor;
    }
    let body = &case.body;
    let rim = body.mass() * body.radius() * body.radius();
    let own = match case.law.friction {
        FrictionLaw::Frictionless => body.transverse_inertia(),
        _ => body.transverse_inertia() + body.mass() * body.height() * body.height(),
    };
    ((own - rim) / (own + rim)).max(0.0)
}

fn kinds(motion: &Motion, kind: EventKind) -> Vec<f64> {
    let found = motion.events.iter().filter(|event| event.kind == kind);
    found.map(|event| event.at.tilt()).collect()
}

proptest! {
    #![proptest_config(cases(40))]

    /// What the energy does not keep is in the budget, losses only grow, and motions among many have the same bits.
    #[test]
    fn the_energy_budget_closes(case in any_case()) {
        let motion = case.motion();
        let energy = |at: &rimroll::motion::Instant| {
            let energy = motion.dynamics(at).energy(at).total();
            energy + at.friction_loss + at.resistance_loss + at.impact_loss - at.ground_work
        };
        let (mut lost, start) = (0.0, motion.trajectory.start());
        let scale = case.body.mass() * GRAVITY * case.body.radius();
        for at in motion.trajectory.samples(2) {
            let size = scale + at.ground_work.abs() + at.friction_loss + at.impact_loss;
            let missing = energy(&at) - energy(&start);
            prop_assert!(missing.abs() < 1e-5 * size, "{missing:e} of {size:e} J at {} s", at.t);
            prop_assert!(at.impact_loss >= lost - 1e-12 * size, "{lost} {}", at.impact_loss);
            lost = at.impact_loss;
        }
        prop_assert!(!motion.message().contains("NaN"));
        let one = shaken_one(
            case.ground.clone(), &case.body, &case.start, &case.law, &case.options,
            |_| ControlFlow::Continue(()),
        ).unwrap();
        let row = Shaking {
            body: &case.body,
            start: case.start,
            contact_law: case.law.clone(),
            ground: case.ground.as_ref(),
            scale: 1.0,
            duration: case.options.duration,
        };
        let outcomes = shake_many(&vec![row; 5], &case.options, |_| ControlFlow::Continue(())).unwrap();
        for outcome in outcomes {
            prop_assert_eq!(outcome, one);
        }
        prop_assert_eq!(one.status, motion.status);
    }

    /// Times 4 in all lengths, times 2 in all times.
    #[test]
    fn the_gap_is_a_length(case in any_case()) {
        let b = &case.body;
        let large = Body::new(
            b.mass(), 4.0 * b.radius(), 4.0 * b.height(),
            16.0 * b.transverse_inertia(), 16.0 * b.axial_inertia(),
        ).unwrap();
        let mut other = Case { body: large, ..case.clone() };
        prop_assume!(matches!(
            case.law.friction,
            FrictionLaw::NoSlip | FrictionLaw::InPlace | FrictionLaw::Frictionless
        ));
        other.law.resistance = Default::default();
        let case = Case { law: other.law.clone(), ground: None, ..case };
        other.ground = None;
        prop_assume!(!case.start.is_standing());
        other.start.yaw_rate *= 0.5;
        other.start.spin_rate *= 0.5;
        other.options.duration *= 2.0;
        other.options.flat_gap *= 4.0;
        let (a, b) = (case.motion(), other.motion());
        prop_assert_eq!(a.status, b.status);
        prop_assert_eq!(a.events.len(), b.events.len());
        for (a, b) in a.events.iter().zip(&b.events) {
            prop_assert!((2.0 * a.at.t - b.at.t).abs() < 1e-9 * (1.0 + b.at.t), "{} {}", a.at.t, b.at.t);
        }
    }
}

proptest! {
    #![proptest_config(cases(60))]

    /// Each swing has the energy of the one before, at the tilt 0, times the square of the factor, until it does not
    /// suffice for the gap. A constant acceleration of the table changes gravity and, where the rim rolls, its direction.
    #[test]
    fn a_plane_swing_follows_from_its_energy(
        case in any_release(), upward in 0.0..0.9_f64, lean in -0.04..0.04_f64, moves in any::<bool>(),
    ) {
        let mut case = case;
        let (r, h) = (case.body.radius(), case.body.height());
        let rolls = case.law.friction != FrictionLaw::Frictionless;
        let lean = if moves && rolls { lean * r / h } else { 0.0 };
        if moves {
            case.ground = Some(constant([lean * GRAVITY, 0.0, upward * GRAVITY], 2.0 * case.options.duration));
            case.options.gravity = (1.0 - upward) * GRAVITY;
            case.start.tilt = case.start.tilt.min(0.6 * libm::atan2(r, h));
        }
        let motion = case.motion();
        // The energy over the weight. The rim's side that rises changes at every impact.
        let lift = |tilt: f64| r * libm::sin(tilt) - h * (1.0 - libm::cos(tilt));
        let energy = |tilt: f64, side: f64| {
            let along = r * (1.0 - libm::cos(tilt)) + h * libm::sin(tilt);
            lift(tilt) - side * lean * along
        };
        let factor = factor_of(&case);
        let gap = 0.5 * case.options.flat_gap;
        let lowest = |side| energy(libm::asin(gap / r), side);
        let (mut side, mut expected) = (1.0, energy(case.start.tilt, 1.0));
        prop_assert_eq!(motion.status, Status::Finished, "{}", motion.message());
        for tilt in kinds(&motion, EventKind::FaceDown) {
            prop_assert!((r * libm::sin(tilt) / gap - 1.0).abs() < 1e-6, "{tilt}");
        }
        let maxima = kinds(&motion, EventKind::TiltMax);
        for (i, tilt) in maxima.iter().enumerate() {
            side = -side;
            expected *= factor * factor;
            let found = energy(*tilt, side);
            // Nothing is lost on the way; the tilt at which a body comes down is exact to the tolerance.
            prop_assert!((found / expected - 1.0).abs() < 1e-8, "{i}: {found:e} {expected:e}");
            prop_assert!(expected > lowest(side) * (1.0 - 1e-9));
        }
        let next = factor * factor * expected;
        if motion.trajectory.end().phase.is_level() {
            prop_assert!(next <= lowest(-side).max(1.1e-7 * r));
        } else {
            prop_assert!(!maxima.is_empty() || next > lowest(-side));
        }
    }

    /// A body with a sideways velocity goes on to the side to which its axis moves. No energy is gained.
    #[test]
    fn beside_its_plane_a_body_goes_on_where_its_axis_moves(
        case in any_release(), sideways in 0.01..3.0_f64, spin in -1.0..1.0_f64,
    ) {
        let mut case = case;
        let rate = (GRAVITY / case.body.radius()).sqrt();
        case.start.yaw_rate = 0.1 * sideways * rate * case.options.flat_gap / case.body.radius();
        case.start.spin_rate = spin * rate;
        if case.law.friction == FrictionLaw::Frictionless {
            // The axial spin keeps the body from coming down.
            case.start.spin_rate = -case.start.yaw_rate * libm::cos(case.start.tilt);
        }
        if case.law.friction == FrictionLaw::InPlace {
            case.start.spin_rate = -case.start.yaw_rate;
        }
        let motion = case.motion();
        let body = &case.body;
        let rim = body.mass() * body.radius() * body.radius();
        let mut compared = 0;
        let landings: Vec<usize> = (0..motion.events.len())
            .filter(|&i| motion.events[i].kind == EventKind::FaceDown)
            .collect();
        for i in landings {
            let before = motion.events[i].at;
            let Some(after) = motion.events.get(i + 1).filter(|next| next.at.t == before.t) else {
                continue;
            };
            if after.kind != EventKind::TiltMin {
                continue;
            }
            let after = after.at;
            compared += 1;
            // The direction of the velocity of the axis, which is toward the raised side afterwards.
            let [from, to] = [(before.p, before.w), (after.p, 0.0)].map(|(p, w)| [p, w]);
            let turned = |[p, w]: [f64; 2], yaw: f64| libm::atan2(w, p) + yaw;
            let change = turned(to, after.yaw) - turned(from, before.yaw);
            prop_assert!(libm::sin(change).abs() < 1e-9 && libm::cos(change) > 0.0, "{change}");
            let energy = |at: &rimroll::motion::Instant| motion.dynamics(at).energy(at).total();
            let lost = after.impact_loss - before.impact_loss;
            prop_assert!(lost > -1e-12 * energy(&before), "{lost:e}");
            prop_assert!((energy(&before) - energy(&after) - lost).abs() < 1e-9 * energy(&before));
            if case.law.friction == FrictionLaw::InPlace {
                prop_assert_eq!(after.s, 0.0);
            } else if before.phase == Phase::Rolling {
                let c = body.axial_inertia();
                // The fall keeps the spin unless it needs its energy; the collision keeps the angular momentum about the
                // vertical through the new contact point.
                let moment = (c - rim) * before.s;
                let is_slower = after.p == 0.0 && after.s.abs() <= before.s.abs();
                let apart = (moment - (c + rim) * after.s).abs();
                prop_assert!(is_slower || apart < 1e-9 * (c + rim) * (before.s.abs() + rate * 1e-9));
            } else {
                prop_assert!((before.s - after.s).abs() <= 1e-12 * before.s.abs());
            }
        }
        prop_assume!(compared > 0);
    }

    /// A disk that turns over is the same body: its motion beyond the edge is that on its first face.
    #[test]
    fn the_other_face_of_a_disk_comes_down_as_the_first(
        (case, start) in any_disk(), resistance_size in prop_oneof![Just(0.0), powers_of_ten(-5.0, -2.0)],
        kind in 0..6_usize,
    ) {
        let mut case = case;
        case.law.resistance = resistance(&case.body, kind, resistance_size);
        let other = Case { start, ..case.clone() };
        let (a, b) = (case.motion(), other.motion());
        prop_assert_eq!(a.status, b.status, "{} {}", a.message(), b.message());
        let end = a.trajectory.end().t.min(b.trajectory.end().t);
        // Rounding differs between the faces, and every landing amplifies it.
        for i in 0..20 {
            let t = 0.5 * end * f64::from(i) / 20.0;
            let (a, b) = (a.trajectory.at(t), b.trajectory.at(t));
            prop_assert!((a.tilt() - (PI - b.tilt())).abs() < 1e-6, "{} {} at {t}", a.tilt(), PI - b.tilt());
        }
    }
}

/// A disk near its first face, and the start of the same motion on its other face.
fn any_disk() -> impl Strategy<Value = (Case, State)> {
    let body = (powers_of_ten(-2.0, 0.0), 0.5..2.0).prop_map(|(radius, axial)| {
        let c = axial * 0.5 * radius * radius;
        Body::new(1.0, radius, 0.0, 0.5 * c, c).unwrap()
    });
    body.prop_flat_map(|body| {
        let friction = any_friction(&body).prop_filter("it turns on its other face", |friction| {
            *friction != FrictionLaw::InPlace
        });
        let rates = (0.05..1.0, prop_oneof![Just(0.0), -0.3..0.3], -0.3..0.3);
        (
            Just(body),
            friction,
            any_flat(),
            rates,
            powers_of_ten(-5.0, -1.0),
            any::<bool>(),
        )
    })
    .prop_map(
        |(body, friction, flat, (tilt, yaw_rate, spin_rate), gap, moves)| {
            let rate = (GRAVITY / body.radius()).sqrt();
            let planar = yaw_rate == 0.0;
            let spin_rate = if planar { 0.0 } else { spin_rate };
            let start = State {
                tilt,
                yaw_rate: yaw_rate * rate,
                spin_rate: spin_rate * rate,
                ..State::default()
            };
            let over = State {
                tilt: PI - tilt,
                yaw: PI,
                spin_rate: -start.spin_rate,
                ..start
            };
            let still =
                Arc::new(Ground::sampled(0.1, vec![[0.0; 3], [0.0, 0.0, 1e-3], [0.0; 3]]).unwrap());
            let options = Options {
                duration: 6.0 / rate,
                gravity: GRAVITY,
                rtol: 1e-11,
                flat,
                flat_gap: gap * body.radius(),
                max_steps: 20_000,
                ..Options::default()
            };
            let ground = moves.then_some(still);
            (
                Case {
                    body,
                    law: friction.into(),
                    ground,
                    start,
                    options,
                },
                over,
            )
        },
    )
}

proptest! {
    #![proptest_config(cases(20))]

    /// Where every impact is flat, the motion becomes that without a gap.
    #[test]
    fn a_vanishing_gap_changes_nothing_in_a_plane(case in any_release()) {
        let none = case.with_gap(0.0).motion();
        let end = none.trajectory.end();
        let until = none
            .events
            .iter()
            .find(|event| event.kind == EventKind::Stand)
            .map_or(end.t, |event| 0.9 * event.at.t);
        let mut larger = f64::INFINITY;
        for part in [1e-5, 1e-7, 1e-9] {
            let motion = case.with_gap(part * case.body.radius()).motion();
            let difference = (0..60)
                .map(|i| until * f64::from(i) / 60.0)
                .map(|t| (none.trajectory.at(t).tilt() - motion.trajectory.at(t).tilt()).abs())
                .fold(0.0, f64::max);
            prop_assert!(difference < 1e-9 + 0.1 * larger, "{part:e}: {difference:e} {larger:e}");
            larger = difference;
        }
    }

    /// Below the gap a body can rise.
    #[test]
    fn a_body_rises_from_below_the_gap(case in any_release(), part in 0.0..1.0_f64) {
        let mut case = case;
        let sine = 0.5 * case.options.flat_gap / case.body.radius();
        case.start.tilt = part * sine + 1e-12;
        // Only the first event matters.
        case.options.max_steps = 1000;
        case.start.tilt_rate = 0.5 * (GRAVITY / case.body.radius() * sine).sqrt();
        let motion = case.motion();
        let first = motion.events[0].kind;
        prop_assert!(matches!(first, EventKind::TiltMax | EventKind::Topple), "{first:?}");
        case.start.tilt_rate *= -1.0;
        let first = case.motion().events[0];
        prop_assert_eq!((first.kind, first.at.t), (EventKind::FaceDown, 0.0));
    }
}

proptest! {
    #![proptest_config(cases(60))]

    /// A body that is about to pass upright beside its plane, at a tilt that counts as none, keeps its energy, too.
    #[test]
    fn a_body_hardly_beside_its_plane_keeps_its_energy(
        case in any_release(),
        across in powers_of_ten(-17.0, -10.0),
        flat in prop_oneof![
            Just(FlatLanding::Smooth(Side::Left)),
            Just(FlatLanding::Restitution(1.0)),
            Just(FlatLanding::Housner),
        ],
    ) {
        let mut case = case.with_gap(0.0);
        case.options.flat = flat;
        case.options.duration *= 0.5;
        case.ground = Some(constant([0.0, across * GRAVITY, 0.0], 2.0 * case.options.duration));
        let motion = case.motion();
        let energy = |at: &rimroll::motion::Instant| motion.dynamics(at).energy(at).total();
        let whole = energy(&motion.trajectory.start());
        for at in motion.trajectory.samples(2) {
            let missing = whole - energy(&at) - at.impact_loss + at.ground_work;
            prop_assert!(missing.abs() < 1e-9 * whole, "{missing:e} of {whole:e} J at {} s", at.t);
            if flat != FlatLanding::Housner {
                prop_assert!(at.impact_loss.abs() < 1e-7 * whole, "{:e}", at.impact_loss);
            }
        }
    }
}

/// The derivatives of tilt, yaw and spin after some landings are those of neighbouring motions.
#[test]
fn derivatives_over_a_gap_are_those_of_neighbouring_motions() {
    let body = Body::new(1000.0, 0.5, 2.0, 1_395.833_333_333_333_3, 125.0).unwrap();
    let record = |i: usize| {
        let t = i as f64;
        [
            3.5 * libm::sin(0.3 * t),
            0.4 * libm::cos(0.21 * t),
            0.5 * libm::sin(0.1 * t),
        ]
    };
    let ground = Arc::new(Ground::sampled(0.05, (0..80).map(record).collect()).unwrap());
    let flats = [
        FlatLanding::Housner,
        FlatLanding::Restitution(0.9),
        FlatLanding::Smooth(Side::Left),
    ];
    let mut landings = 0;
    for (friction, flat) in [
        FrictionLaw::NoSlip,
        FrictionLaw::Frictionless,
        FrictionLaw::InPlace,
    ]
    .into_iter()
    .flat_map(|friction| flats.map(|flat| (friction.clone(), flat)))
    {
        for ground in [None, Some(Arc::clone(&ground))] {
            let in_place = friction == FrictionLaw::InPlace;
            let spin_rate = if in_place { -0.05 } else { 0.03 };
            let state = [0.08, 0.0, 0.3, 0.05, 0.0, spin_rate];
            let motion = |change: &dyn Fn(&mut [f64; 7])| {
                let mut numbers = [state[0], state[1], state[2], state[3], state[5], 0.5, 9.81];
                change(&mut numbers);
                let [tilt, tilt_rate, yaw, yaw_rate, spin_rate, radius, gravity] = numbers;
                let spin_rate = if in_place { -yaw_rate } else { spin_rate };
                let start = State {
                    tilt,
                    tilt_rate,
                    yaw,
                    yaw_rate,
                    spin: 0.0,
                    spin_rate,
                };
                let body = Body::new(
                    body.mass(),
                    radius,
                    body.height(),
                    body.transverse_inertia(),
                    body.axial_inertia(),
                )
                .unwrap();
                let options = Options {
                    duration: 3.0,
                    gravity,
                    rtol: 1e-13,
                    flat,
                    flat_gap: 0.01,
                    ..Options::default()
                };
                let case = Case {
                    body,
                    law: friction.clone().into(),
                    ground: ground.clone(),
                    start,
                    options,
                };
                case.motion()
            };
            let values = |motion: &Motion, t: f64| {
                let state = motion.trajectory.at(t).state();
                [
                    state.tilt,
                    state.tilt_rate,
                    state.yaw,
                    state.yaw_rate,
                    state.spin,
                    state.spin_rate,
                ]
            };
            let given = motion(&|_| {});
            let t = 1.7_f64.min(0.99 * given.trajectory.end().t);
            landings += given
                .events
                .iter()
                .filter(|event| event.kind == EventKind::FaceDown && event.at.t < t)
                .count();
            let watch = |_| ControlFlow::Continue(());
            let found = if ground.is_some() {
                given
                    .shaken_sensitivity(watch)
                    .map(|slopes| slopes.unwrap().at(&given, t))
            } else {
                given.sensitivity(watch).map(|slopes| {
                    let slopes = slopes.unwrap().at(&given, t);
                    slopes.map(|slope| core::array::from_fn(|i| *slope.get(i).unwrap_or(&0.0)))
                })
            };
            let found = match found {
                Ok(found) => found,
                Err(refused) => {
                    let why = "smoothly beside its plane";
                    assert!(refused.to_string().contains(why), "{refused}");
                    assert!(matches!(flat, FlatLanding::Smooth(_)) && !in_place);
                    continue;
                }
            };
            let names = [
                "tilt",
                "tilt_rate",
                "yaw",
                "yaw_rate",
                "spin_rate",
                "radius",
                "gravity",
            ];
            for (i, name) in names.iter().enumerate() {
                if in_place && matches!(*name, "spin_rate" | "yaw_rate") {
                    continue;
                }
                let at = |step: f64| values(&motion(&|numbers| numbers[i] += step), t);
                let central = |h: f64| {
                    let (up, down) = (at(h), at(-h));
                    core::array::from_fn::<f64, 6, _>(|k| (up[k] - down[k]) / (2.0 * h))
                };
                let (wide, narrow) = (central(2e-5), central(1e-5));
                let index = SHAKEN_PARAMETERS
                    .iter()
                    .position(|other| other == name)
                    .unwrap();
                for k in 0..6 {
                    let expected = (4.0 * narrow[k] - wide[k]) / 3.0;
                    let slope = found[k][index];
                    let allowed =
                        1e-5 * (1.0 + expected.abs()) + 0.01 * (wide[k] - narrow[k]).abs();
                    assert!(
                        (slope - expected).abs() < allowed,
                        "{friction:?} {flat:?} {name} {k}: {slope} {expected}"
                    );
                }
            }
        }
    }
    assert!(landings > 12, "{landings}");
}

/// No derivative follows a landing at the start.
#[test]
fn derivatives_of_a_body_that_lands_at_the_start_are_refused() {
    let body = Body::new(1.0, 0.5, 1.0, 0.5, 0.2).unwrap();
    let start = State {
        tilt: 1e-3,
        tilt_rate: -0.1,
        ..State::default()
    };
    let ground =
        Arc::new(Ground::sampled(0.1, vec![[0.0; 3], [0.0, 0.0, 1e-3], [0.0; 3]]).unwrap());
    let options = Options {
        flat: FlatLanding::Housner,
        flat_gap: 0.01,
        ..Options::default()
    };
    let law = ContactLaw::from(FrictionLaw::NoSlip);
    let go_on = |_| ControlFlow::Continue(());
    let motion = simulate_on(Some(ground), &body, &start, law, &options, go_on).unwrap();
    assert_eq!(motion.events[0].kind, EventKind::FaceDown);
    let refused = motion
        .shaken_sensitivity(|_| ControlFlow::Continue(()))
        .err();
    assert!(refused.unwrap().to_string().contains("from below flat_gap"));
}

#[test]
fn a_gap_beyond_a_tenth_of_the_radius_or_a_quarter_of_the_balance_tilt_is_refused() {
    let body = Body::new(1.0, 0.5, 1.0, 0.5, 0.2).unwrap();
    let start = State {
        tilt: 0.1,
        ..State::default()
    };
    for flat_gap in [-1e-9, 0.051, f64::NAN, f64::INFINITY] {
        let options = Options {
            flat_gap,
            ..Options::default()
        };
        let refused = simulate(&body, &start, FrictionLaw::NoSlip, &options, |_| {
            ControlFlow::Continue(())
        });
        let message = refused.err().unwrap().to_string();
        assert!(message.starts_with("flat_gap must be"), "{message}");
        if flat_gap == 0.051 {
            let bound = "between 0 and 0.05, a tenth of the radius, got 0.051 m";
            assert!(message.contains(bound), "{message}");
        }
        let needle = Body::new(1.0, 0.5, 12.0, 0.5, 0.2).unwrap();
        let options = Options {
            flat_gap: 0.02,
            ..Options::default()
        };
        let upright = State {
            tilt: 0.01,
            ..State::default()
        };
        let refused = simulate(&needle, &upright, FrictionLaw::NoSlip, &options, |_| {
            ControlFlow::Continue(())
        });
        let message = refused.err().unwrap().to_string();
        assert!(
            message.contains("a quarter of the balance tilt, got 0.02 m"),
            "{message}"
        );
    }
}
