//! Bodies with corners: Housner's block, conservation between impacts, and what impacts take.

use core::f64::consts::PI;
use proptest::prelude::*;
use rimroll::polygon::{
    COLUMNS, Observables, PolygonEventKind, PolygonMotion, PolygonOptions, PolygonalBody, Support,
    simulate,
};
use rimroll::{Body, IdealLaw, State, Status};
use std::ops::ControlFlow;

const GRAVITY: f64 = 9.80665;

fn column(name: &str) -> usize {
    COLUMNS
        .iter()
        .position(|&column| column == name)
        .expect("a column")
}

fn value(at: &Observables, name: &str) -> f64 {
    at[column(name)]
}

fn follow(body: &PolygonalBody, start: State, law: IdealLaw, duration: f64) -> PolygonMotion {
    bouncing(body, start, law, duration, 0.0)
}

fn bouncing(
    body: &PolygonalBody,
    start: State,
    law: IdealLaw,
    duration: f64,
    restitution: f64,
) -> PolygonMotion {
    let options = PolygonOptions {
        duration,
        rtol: 1e-11,
        restitution,
        ..PolygonOptions::default()
    };
    simulate(body, &start, law, &options, |_| ControlFlow::Continue(())).expect("a motion")
}

/// A square column of the given half-width over half-height, at rest over an edge.
fn block(slenderness: f64, tilt: f64) -> (PolygonalBody, State) {
    let (width, height) = (0.1, 0.1 / slenderness);
    let corner = width * core::f64::consts::FRAC_1_SQRT_2;
    let body = PolygonalBody::prism(2.0, 4, corner, height, 0.0).expect("a column");
    let start = State {
        tilt,
        spin: 0.25 * PI,
        ..State::default()
    };
    (body, start)
}

#[test]
fn a_block_loses_at_each_impact_what_housner_says() {
    for law in IdealLaw::ALL {
        for slenderness in [0.1, 0.3, 0.6] {
            let (body, start) = block(slenderness, 0.03);
            let alpha = libm::atan(slenderness);
            let ratio = 1.0 - 1.5 * libm::sin(alpha) * libm::sin(alpha);
            assert!((body.housner_ratio() - ratio).abs() < 1e-14);
            let motion = follow(&body, start, law, 5.0);
            let impacts = motion
                .events
                .iter()
                .filter(|e| e.kind == PolygonEventKind::Impact);
            let mut before = value(&motion.at(0.0), "energy");
            let lying = body.round().mass() * GRAVITY * body.round().height();
            for impact in impacts.take(4) {
                // On a smooth table the centre of mass moves straight down, and the lever of the whole momentum is
                // absent: the ratio is that of the vertical motion and the rotation alone.
                let expected = match law {
                    IdealLaw::NoSlip => ratio,
                    IdealLaw::Frictionless => smooth_ratio(&body),
                };
                let after = value(&impact.observables(), "energy");
                let measured = (after - lying) / (before - lying);
                assert!(
                    (measured - expected * expected).abs() < 1e-8,
                    "{law:?} {measured}"
                );
                assert!(matches!(impact.support(), Support::Edge(_)));
                before = after;
            }
            assert!(motion.events.len() > 4);
        }
    }
}

/// The ratio of the tilt rates on a smooth table, from the moments about the two edges without horizontal momentum.
fn smooth_ratio(body: &PolygonalBody) -> f64 {
    let round = body.round();
    let arm = round.radius() * libm::cos(0.5 * body.corner_angle());
    let (inertia, lever) = (round.transverse_inertia(), round.mass() * arm * arm);
    (inertia - lever) / (inertia + lever)
}

#[test]
fn a_block_that_bounces_keeps_what_its_plane_impact_leaves() {
    for law in IdealLaw::ALL {
        for (slenderness, restitution) in [(0.1, 0.3), (0.3, 0.5), (0.6, 1.0)] {
            let (body, start) = block(slenderness, 0.03);
            let motion = bouncing(&body, start, law, 1.0, restitution);
            let ratio = match law {
                IdealLaw::NoSlip => body.housner_ratio(),
                IdealLaw::Frictionless => smooth_ratio(&body),
            };
            let impact = &motion.events[0];
            assert_eq!(impact.kind, PolygonEventKind::Impact);
            assert!(matches!(impact.support(), Support::Flight(_)));
            let lying = body.round().mass() * GRAVITY * body.round().height();
            let energy = value(&motion.at(0.0), "energy") - lying;
            let lost = (1.0 - restitution * restitution) * (1.0 - ratio * ratio);
            assert!((impact.loss / energy - lost).abs() < 1e-8, "{law:?}");
            // The plane of the base turned with ω about the old edge, and turns with (ratio − e (1 − ratio)) ω.
            let t = value(&impact.observables(), "t");
            let before = value(&motion.at(t - 1e-9), "tilt_rate").abs();
            let after = value(&motion.at(t + 1e-9), "tilt_rate");
            let expected = ratio - restitution * (1.0 - ratio);
            assert!(
                (after.abs() / before - expected.abs()).abs() < 1e-6,
                "{after} {before}"
            );
        }
    }
}

#[test]
fn a_corner_that_strikes_beside_one_that_stays_rebounds_alone() {
    // The edge of a flat triangle comes down at one end: the other corner stays, as in the plastic impact.
    let round = Body::new(0.1, 0.03, 0.0, 1.2e-5, 2.4e-5).expect("a body");
    let body = PolygonalBody::new(3, round).expect("corners");
    let start = State {
        tilt: 0.25,
        spin: 0.8,
        ..State::default()
    };
    for law in IdealLaw::ALL {
        let plastic = follow(&body, start, law, 0.3);
        let bounce = bouncing(&body, start, law, 0.3, 0.5);
        let [plastic, first] = [&plastic, &bounce].map(|motion| &motion.events[0]);
        assert!(matches!(plastic.support(), Support::Edge(_)));
        assert!(matches!(first.support(), Support::Corner(_)));
        // Without friction nothing but the approach of the corner is lost in the plastic impact.
        if law == IdealLaw::Frictionless {
            assert!((first.loss / plastic.loss - 0.75).abs() < 1e-9);
        }
        assert!(first.loss <= plastic.loss);
        // Ever smaller bounces end on the edge.
        let supports = bounce.supports();
        assert!(
            supports
                .iter()
                .any(|(support, _)| matches!(support, Support::Edge(_)))
        );
    }
}

#[test]
fn a_body_thrown_up_falls_on_its_parabola() {
    // Spun so fast that the force of the table vanishes at once.
    let (body, start) = block(0.5, 0.3);
    let flung = State {
        tilt_rate: 12.0,
        spin: 0.5,
        ..start
    };
    for law in IdealLaw::ALL {
        let motion = follow(&body, flung, law, 0.3);
        let (support, from) = motion.supports()[1];
        assert!(matches!(support, Support::Flight(_)), "{support:?}");
        let until = motion
            .supports()
            .get(2)
            .map_or(motion.at(9.0)[0], |next| next.1);
        let times: Vec<f64> = (0..5)
            .map(|i| from + 0.25 * f64::from(i) * (until - from))
            .collect();
        let steps: Vec<Observables> = times
            .iter()
            .map(|&t| motion.at(t.min(until - 1e-12)))
            .collect();
        let h = times[1] - times[0];
        for three in steps.windows(3) {
            let second = |name| {
                (value(&three[0], name) - 2.0 * value(&three[1], name) + value(&three[2], name))
                    / (h * h)
            };
            assert!((second("z") + GRAVITY).abs() < 1e-4, "{}", second("z"));
            assert!(second("x").abs() < 1e-4 && second("y").abs() < 1e-4);
            assert_eq!(value(&three[1], "normal"), 0.0);
        }
    }
}

#[test]
fn a_slender_block_has_housners_period() {
    let (body, _) = block(0.02, 0.01);
    let alpha = libm::atan(0.02);
    let half_diagonal = libm::hypot(0.05, 2.5);
    let p = (0.75 * GRAVITY / half_diagonal).sqrt();
    for part in [0.1, 0.4, 0.8] {
        let (_, start) = block(0.02, part * alpha);
        let motion = follow(&body, start, IdealLaw::NoSlip, 30.0);
        let first = motion
            .events
            .iter()
            .find(|e| e.kind == PolygonEventKind::Impact);
        let quarter = value(&first.expect("an impact").observables(), "t");
        let closed = libm::acosh(1.0 / (1.0 - part)) / p;
        // The closed form replaces sin(α − θ) by α − θ, which is right to α²/6.
        assert!(
            (quarter / closed - 1.0).abs() < alpha * alpha,
            "{quarter} {closed}"
        );
    }
}

#[test]
fn a_wide_block_stays_down() {
    let (body, start) = block(2.0, 0.05);
    assert!(body.housner_ratio() < 0.0);
    let motion = follow(&body, start, IdealLaw::NoSlip, 5.0);
    assert_eq!(motion.status, Status::AtRest);
    let impacts = motion
        .events
        .iter()
        .filter(|e| e.kind == PolygonEventKind::Impact);
    assert_eq!(impacts.count(), 1);
}

#[test]
fn a_block_past_its_balance_topples() {
    let alpha = libm::atan(0.2);
    for (part, status) in [(0.99, Status::Finished), (1.01, Status::Toppled)] {
        let (body, start) = block(0.2, part * alpha);
        let motion = follow(&body, start, IdealLaw::NoSlip, 1.5);
        assert_eq!(motion.status, status);
    }
}

#[test]
fn on_a_smooth_table_one_end_of_an_edge_can_lift() {
    let (body, start) = block(0.5, 0.3);
    let turning = State {
        yaw_rate: 6.0,
        tilt_rate: -3.0,
        ..start
    };
    let motion = follow(&body, turning, IdealLaw::Frictionless, 0.2);
    let first = &motion.events[0];
    assert_eq!(first.kind, PolygonEventKind::CornerLift);
    // The mirrored body lifts the mirrored corner: the corners of the edge are 3 and 0, counted 0 and -1 from either side.
    let mirrored = State {
        yaw_rate: -6.0,
        ..turning
    };
    let other = &follow(&body, mirrored, IdealLaw::Frictionless, 0.2).events[0];
    assert_eq!(other.kind, PolygonEventKind::CornerLift);
    let corners = [first, other].map(|event| value(&event.observables(), "corner"));
    assert_ne!(corners[0], corners[1]);
    // At that moment the edge needs no force on the corner that lifts, so the force does not jump.
    let t = value(&first.observables(), "t");
    let (before, after) = (motion.at(t - 1e-9), motion.at(t + 1e-9));
    assert!((value(&before, "normal") / value(&after, "normal") - 1.0).abs() < 1e-6);
}

#[test]
fn endless_rocking_along_an_edge_ends_on_the_edge() {
    let (body, start) = block(1.0, 0.4);
    let unlevel = State {
        spin: 0.25 * PI + 0.01,
        ..start
    };
    let motion = follow(&body, unlevel, IdealLaw::NoSlip, 2.0);
    assert_eq!(motion.status, Status::AtRest);
    assert!(
        motion
            .supports()
            .iter()
            .any(|(support, _)| matches!(support, Support::Edge(_)))
    );
}

/// Angular momentum about the next corner stays: (C + m R² cos 2π/n)/(C + m R²), which is 11/17 for a uniform hexagonal
/// prism (International Physics Olympiad 1998, problem 1).
#[test]
fn a_flat_body_on_its_side_rolls_like_a_prism() {
    for corners in [4, 6, 11] {
        let prism = PolygonalBody::prism(0.01, corners, 0.004, 0.1, 0.0).expect("a prism");
        let c = prism.round().axial_inertia();
        let round = Body::new(0.01, 0.004, 0.0, 0.5 * c, c).expect("a body");
        let body = PolygonalBody::new(corners, round).expect("corners");
        let upright = State {
            tilt: 0.5 * PI,
            spin_rate: 20.0,
            ..State::default()
        };
        let arm = 0.01 * 0.004 * 0.004;
        let expected = (c + arm * libm::cos(body.corner_angle())) / (c + arm);
        let motion = follow(&body, upright, IdealLaw::NoSlip, 0.3);
        let impact = &motion.events[0];
        assert_eq!(impact.kind, PolygonEventKind::Impact);
        let t = value(&impact.observables(), "t");
        let before = value(&motion.at(t - 1e-12), "spin_rate");
        let ratio = value(&impact.observables(), "spin_rate") / before;
        assert!((ratio - expected).abs() < 1e-8, "{ratio} {expected}");
        assert_eq!(value(&impact.observables(), "tilt"), 0.5 * PI);
        if corners == 6 {
            assert!((expected - 11.0 / 17.0).abs() < 1e-14);
        }
        let options = PolygonOptions::default();
        let lying = simulate(&prism, &upright, IdealLaw::NoSlip, &options, |_| {
            ControlFlow::Continue(())
        });
        let refusal = lying.err().expect("it lies along its length").to_string();
        assert!(refusal.contains("height 0"), "{refusal}");
    }
}

fn any_polygonal_body() -> impl Strategy<Value = PolygonalBody> {
    let height = prop_oneof![1 => Just(0.0), 4 => 0.05..4.0];
    (3..40_u64, 0.01..1.0_f64, height, 0.1..4.0, 0.1..2.0).prop_map(
        |(corners, radius, slenderness, transverse, axial)| {
            let a = transverse * 0.7 * radius * radius;
            let round = Body::new(0.7, radius, slenderness * radius, a, axial * a);
            PolygonalBody::new(corners, round.expect("a rigid body")).expect("corners")
        },
    )
}

/// A start on a corner, with rates in units of √(g/R).
fn any_start() -> impl Strategy<Value = [f64; 6]> {
    let rate = || -1.0..1.0_f64;
    (0.02..0.8_f64, rate(), -3.0..3.0, rate(), -3.0..3.0, rate()).prop_map(
        |(tilt, p, yaw, yaw_rate, spin, spin_rate)| [tilt, p, yaw, yaw_rate, spin, spin_rate],
    )
}

fn start_of(body: &PolygonalBody, numbers: [f64; 6]) -> State {
    let unit = (GRAVITY / body.round().radius()).sqrt();
    let [tilt, tilt_rate, yaw, yaw_rate, spin, spin_rate] = numbers;
    State {
        tilt,
        tilt_rate: unit * tilt_rate,
        yaw,
        yaw_rate: unit * yaw_rate,
        spin,
        spin_rate: unit * spin_rate,
    }
}

/// A time (s) before a body that falls from an edge strikes with many corners at once: rounding decides what follows.
fn before_flat(motion: &PolygonMotion, duration: f64) -> f64 {
    let supports = motion.supports();
    let edge = supports
        .iter()
        .position(|(support, _)| matches!(support, Support::Edge(_)));
    let flat = edge
        .and_then(|i| supports.get(i + 1))
        .map_or(duration, |&(_, t)| t);
    duration.min(flat - 1e-3 * duration).max(0.0)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    #[test]
    fn energy_changes_at_impacts_alone_and_is_never_gained(
        body in any_polygonal_body(),
        numbers in any_start(),
        restitution in prop_oneof![Just(0.0), Just(1.0), 0.0..1.0],
    ) {
        let start = start_of(&body, numbers);
        let duration = 12.0 * (body.round().radius() / GRAVITY).sqrt();
        for law in IdealLaw::ALL {
            let motion = bouncing(&body, start, law, duration, restitution);
            prop_assert_ne!(motion.status, Status::Failed);
            let samples = motion.samples(2);
            let total = |at: &Observables| value(at, "energy") + value(at, "impact_loss");
            let scale = total(&samples[0]);
            for at in &samples {
                prop_assert!((total(at) - scale).abs() < 1e-9 * scale, "{} {}", total(at), scale);
                prop_assert!(value(at, "normal") >= 0.0);
            }
            for event in &motion.events {
                prop_assert!(event.loss >= -1e-12 * scale, "{} of {scale}", event.loss);
            }
            // The loss reported at the events is the loss in the table.
            let reported: f64 = motion.events.iter().map(|event| event.loss).sum();
            let last = samples.last().expect("a sample");
            prop_assert!((reported - value(last, "impact_loss")).abs() < 1e-12 * scale);
        }
    }

    #[test]
    fn a_mirrored_start_has_the_mirrored_motion(body in any_polygonal_body(), numbers in any_start()) {
        let start = start_of(&body, numbers);
        let mirrored = State {
            yaw: -start.yaw,
            yaw_rate: -start.yaw_rate,
            spin: -start.spin,
            spin_rate: -start.spin_rate,
            ..start
        };
        let duration = 2.0 * (body.round().radius() / GRAVITY).sqrt();
        for law in IdealLaw::ALL {
            let [one, other] = [start, mirrored].map(|start| follow(&body, start, law, duration));
            let until = before_flat(&one, duration);
            let (one, other) = (one.at(until), other.at(until));
            prop_assert!((value(&one, "tilt") - value(&other, "tilt")).abs() < 1e-6);
            let turned = value(&one, "yaw") + value(&one, "spin");
            let turned_back = value(&other, "yaw") + value(&other, "spin");
            prop_assert!((turned + turned_back).abs() < 1e-6);
            prop_assert!((value(&one, "y") + value(&other, "y")).abs() < 1e-6);
        }
    }

    /// Over each edge, in its mirror image, at every heading and in every size.
    #[test]
    fn starts_over_an_edge_that_are_equivalent_have_the_same_motion(
        body in any_polygonal_body(),
        numbers in any_start(),
        spins in prop_oneof![4 => Just(0.0), 1 => Just(1.0)],
        edge in -9..9_i32,
        size in 0.1..10.0_f64,
    ) {
        let [tilt, tilt_rate, yaw, yaw_rate, _, spin_rate] = numbers;
        let spin = PI / f64::from(body.corners());
        let over = |body: &PolygonalBody, side: f64, spin, yaw| {
            start_of(body, [tilt, tilt_rate, yaw, side * yaw_rate, side * spin, side * spins * spin_rate])
        };
        let round = body.round();
        let grown = size * size;
        let (a, c) = (grown * round.transverse_inertia(), grown * round.axial_inertia());
        let larger = Body::new(round.mass(), size * round.radius(), size * round.height(), a, c).expect("a body");
        let larger = PolygonalBody::new(u64::from(body.corners()), larger).expect("corners");
        let duration = 2.0 * (round.radius() / GRAVITY).sqrt();
        let longer = duration * size.sqrt();
        let other_spin = spin + 2.0 * PI * f64::from(edge) / f64::from(body.corners());
        for law in IdealLaw::ALL {
            let one = follow(&body, over(&body, 1.0, spin, 0.0), law, duration);
            let until = before_flat(&one, duration) / duration;
            let tilt_of = |motion: &PolygonMotion, part: f64, duration: f64| value(&motion.at(part * duration), "tilt");
            for part in [0.02, 0.2, 1.0].map(|part| part * until) {
                let expected = tilt_of(&one, part, duration);
                for side in [1.0, -1.0] {
                    let turned = follow(&body, over(&body, side, other_spin, yaw), law, duration);
                    let scaled = follow(&larger, over(&larger, side, other_spin, yaw), law, longer);
                    for found in [tilt_of(&turned, part, duration), tilt_of(&scaled, part, longer)] {
                        prop_assert!((found - expected).abs() < 1e-6, "{law:?} {side}: {found} {expected}");
                    }
                }
            }
        }
    }

    #[test]
    fn no_corner_is_below_the_table(body in any_polygonal_body(), numbers in any_start(), restitution in 0.0..1.0) {
        let start = start_of(&body, numbers);
        let duration = 6.0 * (body.round().radius() / GRAVITY).sqrt();
        let n = body.corners();
        for law in IdealLaw::ALL {
            let motion = bouncing(&body, start, law, duration, restitution);
            for at in motion.samples(5) {
                let (tilt, spin) = (value(&at, "tilt"), value(&at, "spin"));
                let lowest = (0..n).map(|k| {
                    let angle = PI + f64::from(k) * body.corner_angle() + spin;
                    body.round().radius() * libm::sin(tilt) * libm::cos(angle)
                });
                let lowest = lowest.fold(f64::INFINITY, f64::min);
                let height = value(&at, "z") - body.round().height() * libm::cos(tilt) + lowest;
                prop_assert!(height > -1e-9 * body.round().radius(), "{height}");
                let is_carried = value(&at, "normal") > 0.0;
                prop_assert!(!is_carried || height < 1e-9 * body.round().radius(), "{height}");
            }
        }
    }
}
