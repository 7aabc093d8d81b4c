//! A rim with an imperfection: plastic collisions against closed forms, for any body and any position of the
//! imperfection.

use crate::given::bodies;
use crate::given::cases;

use bodies::any_body;
use cases::cases;
use core::f64::consts::{PI, TAU};
use proptest::prelude::*;
use rimroll::imperfection::{ImperfectRim, imperfect_rim};
use rimroll::{Body, IdealLaw, InvalidInput, presets};

const RATE: f64 = 3.0;

fn fall(body: &Body, law: IdealLaw, angle: f64) -> ImperfectRim {
    imperfect_rim(body, law, angle, RATE).expect("a valid angle")
}

fn can() -> Body {
    presets::can_2007().expect("the paper's can")
}

fn any_law() -> impl Strategy<Value = IdealLaw> {
    prop_oneof![Just(IdealLaw::NoSlip), Just(IdealLaw::Frictionless)]
}

/// Disks with little mass near the rim.
fn flat_body() -> impl Strategy<Value = Body> {
    (0.01..0.99).prop_map(|a| Body::new(1.0, 1.0, 0.0, a, 2.0 * a).expect("a disk"))
}

/// K′ and mR² in units of J′.
fn shares(body: &Body, law: IdealLaw) -> (f64, f64) {
    let mrr = body.mass() * body.radius() * body.radius();
    let k = match law {
        IdealLaw::NoSlip => body.transverse_inertia() + body.mass() * body.height() * body.height(),
        IdealLaw::Frictionless => body.transverse_inertia(),
    };
    (k / (k + mrr), mrr / (k + mrr))
}

fn close(a: f64, b: f64, within: f64) -> bool {
    (a - b).abs() <= within * (1.0 + b.abs())
}

/// Housner (1963): the angular momentum about B gives J ω₊ = (K − mR²) ω without slip. If that is negative,
/// the point A would be pushed into the table, and the body stops.
#[test]
fn an_imperfection_opposite_to_the_contact_rocks_the_body_back_like_a_block() {
    for law in IdealLaw::ALL {
        let (k, m) = shares(&can(), law);
        let end = fall(&can(), law, PI);
        assert_eq!(end.turn, Some(PI));
        assert_eq!(end.collisions.len(), 1);
        assert!(close(end.tipping_rate, (k - m) * RATE, 1e-15));
        assert!(close(end.energy_kept, (k - m) * (k - m), 1e-15));
    }
    let disk = presets::disk(0.2).expect("a disk");
    for law in IdealLaw::ALL {
        let end = fall(&disk, law, PI);
        assert_eq!(end.turn, None);
        assert_eq!((end.tipping_rate, end.energy_kept), (0.0, 0.0));
        let [only] = end.collisions[..] else {
            panic!("one collision")
        };
        assert_eq!((only.lean_azimuth, only.lean_rate), (None, 0.0));
        assert!(only.impulse > 0.0 && only.held_impulse > 0.0);
    }
}

/// β → 0 and β = π are both limits of the flat slap, and both leave the same energy; flat bodies keep none.
#[test]
fn an_imperfection_close_to_the_contact_ends_like_one_opposite() {
    for law in IdealLaw::ALL {
        let (near, opposite) = (fall(&can(), law, 1e-7), fall(&can(), law, PI - 1e-7));
        for end in [&near, &opposite] {
            assert!((end.turn.expect("it rises") - PI).abs() < 1e-6);
            assert!(close(
                end.energy_kept,
                fall(&can(), law, PI).energy_kept,
                1e-12
            ));
        }
        let disk = presets::disk(0.2).expect("a disk");
        assert!(fall(&disk, law, 1e-7).energy_kept < 1e-12);
        assert!(fall(&disk, law, PI - 1e-7).energy_kept < 1e-12);
    }
}

proptest! {
    #![proptest_config(cases(1000))]

    #[test]
    fn energy_never_rises_and_the_table_never_pulls(
        body in any_body(), law in any_law(), angle in 1e-3..TAU - 1e-3,
    ) {
        let end = fall(&body, law, angle);
        let mut before = 1.0;
        for collision in &end.collisions {
            prop_assert!(collision.energy_kept <= before * (1.0 + 1e-15));
            prop_assert!(collision.impulse > 0.0 && collision.held_impulse >= 0.0);
            prop_assert!(collision.lean_azimuth.is_some_and(|a| (0.0..=TAU).contains(&a)));
            before = collision.energy_kept;
        }
        // Rolling off and rocking over the chord dissipate no energy.
        prop_assert!(close(end.energy_kept, before, 1e-14));
        prop_assert!(close(end.tipping_rate, end.energy_kept.sqrt() * RATE, 1e-15));
        prop_assert!(end.turn.is_some_and(|turn| turn > 0.0 && turn < TAU));
    }

    #[test]
    fn mirrored_imperfections_have_mirrored_outcomes(
        body in any_body(), law in any_law(), angle in 1e-3..PI - 1e-3,
    ) {
        let (left, right) = (fall(&body, law, angle), fall(&body, law, TAU - angle));
        let [one, other] = [&left, &right].map(|end| end.turn.expect("it rises"));
        prop_assert!(close(one + other, TAU, 1e-9));
        prop_assert!(close(left.energy_kept, right.energy_kept, 1e-12));
        for (a, b) in left.collisions.iter().zip(&right.collisions) {
            prop_assert!(close(libm::cos(a.azimuth), libm::cos(b.azimuth), 1e-9));
            prop_assert!(close(libm::sin(a.azimuth), -libm::sin(b.azimuth), 1e-9));
            prop_assert!(close(a.impulse, b.impulse, 1e-9));
        }
    }

    /// The loss is ½ N |v_B| with the impulse N and the approach velocity of B.
    #[test]
    fn the_first_collision_loses_its_closed_form_when_a_lifts_off(
        body in any_body(), law in any_law(), angle in 1e-3..PI,
    ) {
        let (k, m) = shares(&body, law);
        let first = fall(&body, law, angle).collisions[0];
        let cos = libm::cos(angle);
        prop_assume!((k + m * cos).abs() > 1e-12);
        prop_assert_eq!(first.held_impulse == 0.0, k + m * cos > 0.0);
        if first.held_impulse == 0.0 {
            let lost = m * k * (1.0 - cos) * (1.0 - cos);
            prop_assert!(close(first.energy_kept, 1.0 - lost, 1e-14));
        }
    }

    /// The centre of mass can pass over B only if K′ cos β < −mR².
    #[test]
    fn the_body_rises_over_the_imperfection_only_near_the_opposite_point(
        body in any_body(), law in any_law(), angle in 1e-3..PI,
    ) {
        let (k, m) = shares(&body, law);
        let cos = libm::cos(angle);
        prop_assume!((k * cos + m).abs() > 1e-12);
        let first = fall(&body, law, angle).collisions[0];
        prop_assert_eq!(first.rise_rate > 0.0, k * cos < -m);
    }

    /// The formula at the head of `imperfection.rs`.
    #[test]
    fn the_turn_of_all_but_flat_bodies_is_the_closed_form(
        body in any_body(), law in any_law(), angle in 1e-3..PI - 1e-3,
    ) {
        let (k, m) = shares(&body, law);
        let d = k - m;
        prop_assume!(d >= 0.0);
        let (s, c) = (libm::sin(0.5 * angle), libm::cos(0.5 * angle));
        let stretch = (1.0 / k).sqrt();
        let rolled = libm::atan2(4.0 * m * s * c * c * c, stretch * d * (1.0 - 4.0 * k * m * s * s * s * s));
        let expected = angle + 2.0 * libm::atan2(c, d * s) - stretch * rolled;
        let end = fall(&body, law, angle);
        prop_assert!(close(end.turn.expect("it rises"), expected, 1e-12));
        prop_assert_eq!(end.collisions.len(), 2);
        prop_assert!(end.collisions.iter().all(|c| c.held_impulse == 0.0));
    }

    /// The force at B vanishes at cos χ = −K′/(mR²), whatever the angle of the imperfection.
    #[test]
    fn flat_bodies_lean_at_a_fixed_angle_from_the_imperfection(
        body in flat_body(), law in any_law(), angle in 1e-3..PI - 1e-3,
    ) {
        let (k, m) = shares(&body, law);
        let released = PI - libm::acos(k / m);
        let left = libm::atan2(k.sqrt(), (m - k).sqrt()) / k.sqrt();
        let end = fall(&body, law, angle);
        prop_assert!(close(end.turn.expect("it rises") - angle, released - left, 1e-9));
        prop_assert!(end.collisions.last().is_some_and(|c| c.held_impulse > 0.0));
    }

    #[test]
    fn the_outcome_is_continuous_in_the_angle(
        body in any_body(), law in any_law(), angle in 1e-2..PI - 1e-2,
    ) {
        let step = 1e-7;
        let (one, other) = (fall(&body, law, angle), fall(&body, law, angle + step));
        prop_assert!((one.energy_kept - other.energy_kept).abs() < 10.0 * step);
        let [a, b] = [&one, &other].map(|end| end.turn.expect("it rises"));
        prop_assert!((a - b).abs() < 1e3 * step);
    }
}

#[test]
fn rates_and_impulses_are_in_proportion_to_the_tipping_rate() {
    let slow = imperfect_rim(&can(), IdealLaw::NoSlip, 2.0, 1.0).expect("valid");
    let fast = imperfect_rim(&can(), IdealLaw::NoSlip, 2.0, 8.0).expect("valid");
    assert_eq!((slow.turn, slow.energy_kept), (fast.turn, fast.energy_kept));
    assert_eq!(8.0 * slow.tipping_rate, fast.tipping_rate);
    for (a, b) in slow.collisions.iter().zip(&fast.collisions) {
        assert_eq!(8.0 * a.impulse, b.impulse);
        assert_eq!(8.0 * a.rise_rate, b.rise_rate);
        assert_eq!(8.0 * a.lean_rate, b.lean_rate);
    }
}

#[test]
fn bodies_of_any_size_have_finite_outcomes() {
    for (radius, inertia) in [(1e-60, 1e60), (1e60, 1e-60), (1e60, 1e60), (1e-60, 1e-60)] {
        let body = Body::new(1.0, radius, 0.0, inertia, inertia).expect("a body");
        for angle in [1e-9, 1.0, 3.0, PI, 6.0] {
            let end = fall(&body, IdealLaw::NoSlip, angle);
            assert!(end.turn.is_none_or(f64::is_finite));
            assert!(end.energy_kept.is_finite() && end.tipping_rate.is_finite());
        }
    }
}

#[test]
fn angles_and_rates_that_are_none_are_refused_with_a_sentence() {
    let refused = |angle, rate| {
        let refusal: InvalidInput =
            imperfect_rim(&can(), IdealLaw::NoSlip, angle, rate).expect_err("refused");
        refusal.to_string()
    };
    assert_eq!(
        refused(0.0, 1.0),
        "angle must be inside (0, 2 pi), got 0 rad"
    );
    assert!(refused(TAU, 1.0).starts_with("angle must be inside (0, 2 pi), got 6.28"));
    assert_eq!(
        refused(f64::NAN, 1.0),
        "angle must be a finite number, got NaN"
    );
    assert_eq!(refused(1.0, -1.0), "tipping_rate must be > 0, got -1 rad/s");
}
