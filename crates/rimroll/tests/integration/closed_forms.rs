//! The closed forms of the angle of turn, of the near-collision and of the forces that it requires, against
//! the paper's numbers and against simulated motions.

use crate::given::bodies;
use crate::given::cases;
use crate::given::motions;

use bodies::any_body;
use cases::cases;
use core::f64::consts::PI;
use motions::{PAPER_GRAVITY, follow, paper_start, tight};
use proptest::prelude::*;
use rimroll::composite_approximation::{Composite, composite};
use rimroll::law::{DynamicsExt, NoSlip, Parameters};
use rimroll::motion::Turn;
use rimroll::small_angle::lean_vector;
use rimroll::solve::{Stepper, System};
use rimroll::state::{COORDINATES, Coordinates};
use rimroll::steady::steady_wobble_rate;
use rimroll::turn::{
    NearCollision, disk_turn_limit, error_law_coefficient, lift_off_rate, needed_friction,
    point_mass_turn_limit, slip_rate, tall_turn_limit, turn_limit, turn_limit_with_spin,
};
use rimroll::{Body, IdealLaw, State, Status, presets};

fn can() -> Body {
    presets::can_2007().expect("the paper's can")
}

fn degrees(turn: f64) -> String {
    format!("{:.8}", turn.to_degrees())
}

/// The paper, sections "Quantitative comparisons" and "Disks", with more digits; without slip with the
/// corrected fraction of Eq. `noslipangleofturn`.
#[test]
fn limits_of_the_can_the_disk_and_the_ring() {
    assert_eq!(
        degrees(turn_limit(&can(), IdealLaw::NoSlip)),
        "202.28719483"
    );
    assert_eq!(
        degrees(turn_limit(&can(), IdealLaw::Frictionless)),
        "220.96915717"
    );
    for law in IdealLaw::ALL {
        for radius in [0.01, 3.0] {
            let disk = presets::disk(radius).expect("a disk");
            let ring = presets::ring(radius).expect("a ring");
            assert_eq!(degrees(turn_limit(&disk, law)), "402.49223595");
            assert_eq!(degrees(turn_limit(&ring, law)), "311.76914536");
        }
    }
}

/// π √(1 + mR²/K′) with A = m(R²/4 + H²/3): K′/mR² is 1/4 + H²/3R² without friction, and larger by H²/R²
/// without slip.
#[test]
fn limits_of_solid_cylinders() {
    for (height, no_slip, frictionless) in [
        (1.0, "229.920", "296.552"),
        (2.0, "195.456", "229.920"),
        (5.0, "182.660", "190.197"),
    ] {
        let body = presets::cylinder(0.04, 2.0 * 0.04 * height).expect("a cylinder");
        let printed = |law| format!("{:.3}", turn_limit(&body, law).to_degrees());
        assert_eq!(printed(IdealLaw::NoSlip), no_slip);
        assert_eq!(printed(IdealLaw::Frictionless), frictionless);
    }
}

#[test]
fn turn_of_a_uniform_disk_is_pi_sqrt_5_whatever_the_friction() {
    let disk = presets::disk(0.3).expect("a disk");
    for law in IdealLaw::ALL {
        assert!((turn_limit(&disk, law) - PI * 5f64.sqrt()).abs() < 1e-14);
    }
    // k² = 1/2 for the uniform disk, k = 1 for the ring.
    let uniform = disk_turn_limit(0.5f64.sqrt()).expect("valid");
    assert!((uniform - PI * 5f64.sqrt()).abs() < 1e-14);
    let ring = disk_turn_limit(1.0).expect("valid");
    assert!((ring - PI * 3f64.sqrt()).abs() < 1e-14);
}

proptest! {
    #![proptest_config(cases(300))]

    /// "the angle of turn is always more than 180 degrees", and it is larger without friction.
    #[test]
    fn every_body_turns_by_more_than_pi_and_by_more_on_a_smooth_table(body in any_body()) {
        let [no_slip, frictionless] = IdealLaw::ALL.map(|law| turn_limit(&body, law));
        prop_assert!(PI < no_slip && no_slip <= frictionless);
        prop_assert_eq!(no_slip == frictionless, body.height() == 0.0);
    }

    /// √(1 + x) is smaller than 1 + x/2 by less than x²/8.
    #[test]
    fn the_tall_limit_exceeds_the_limit_by_less_than_its_bound(body in any_body()) {
        for law in IdealLaw::ALL {
            let ratio = turn_limit(&body, law) / PI;
            let x = ratio * ratio - 1.0;
            let beyond = tall_turn_limit(&body, law) - turn_limit(&body, law);
            let rounding = 1e-14 * (1.0 + x);
            prop_assert!(beyond >= -rounding && beyond <= PI / 8.0 * x * x + rounding);
        }
    }

    /// H = 0 and C = mk²R² = 2A.
    #[test]
    fn a_disk_turns_as_its_radius_of_gyration_says(k in 0.05..1.0, radius in 0.01..1.0) {
        let c = 2.0 * k * k * radius * radius;
        let disk = Body::new(2.0, radius, 0.0, 0.5 * c, c).expect("a disk");
        let expected = disk_turn_limit(k).expect("valid");
        for law in IdealLaw::ALL {
            prop_assert!((turn_limit(&disk, law) / expected - 1.0).abs() < 1e-14);
        }
    }

    /// A → 0: a relative size a of A changes the limit by a relative amount of order a.
    #[test]
    fn a_point_mass_is_the_limit_of_small_inertia(radius in 0.01..1.0, slenderness in 0.1..10.0) {
        let height: f64 = slenderness * radius;
        let a = 1e-12 * height * height;
        let body = Body::new(1.0, radius, height, a, a).expect("a body");
        let point = point_mass_turn_limit(radius, height, IdealLaw::NoSlip).expect("valid");
        prop_assert!((turn_limit(&body, IdealLaw::NoSlip) / point - 1.0).abs() < 1e-11);
        let smooth = point_mass_turn_limit(radius, height, IdealLaw::Frictionless);
        prop_assert_eq!(smooth, Ok(f64::INFINITY));
        prop_assert!(turn_limit(&body, IdealLaw::Frictionless) > 1e5);
    }
}

/// μ* = mHR/(A + mH²), and the tipping rates above which the can slips or lifts off: closed forms evaluated
/// at g = 9.8 m/s².
#[test]
fn what_the_can_asks_of_the_table() {
    let can = can();
    assert_eq!(format!("{:.8}", needed_friction(&can)), "0.35577798");
    let rates = [
        lift_off_rate(&can, PAPER_GRAVITY),
        slip_rate(&can, PAPER_GRAVITY),
    ];
    let printed = rates.map(|rate| format!("{:.3}", rate.expect("valid")));
    assert_eq!(printed, ["10.605", "8.549"]);
    let disk = presets::disk(0.05).expect("a disk");
    assert_eq!(needed_friction(&disk), 0.0);
    assert_eq!(lift_off_rate(&disk, PAPER_GRAVITY), Ok(f64::INFINITY));
}

/// The end of a plane tipping motion, just before the near-collision.
fn arriving(rate: f64) -> Coordinates<f64> {
    Coordinates::from_state(&State {
        tilt: 1e-12,
        tilt_rate: -rate,
        ..State::default()
    })
}

proptest! {
    #![proptest_config(cases(300))]

    #[test]
    fn at_the_lift_off_rate_the_table_carries_nothing(body in any_body()) {
        prop_assume!(body.height() > 0.0);
        let law = IdealLaw::NoSlip.dynamics(&body, PAPER_GRAVITY);
        let rate = lift_off_rate(&body, PAPER_GRAVITY).expect("valid");
        let normal = |rate: f64| {
            let u = arriving(rate);
            law.contact(&u).normal / (u.sin * body.mass() * PAPER_GRAVITY)
        };
        prop_assert!(normal(rate).abs() < 1e-9);
        prop_assert!(normal(0.99 * rate) > 0.0 && normal(1.01 * rate) < 0.0);
    }

    #[test]
    fn at_the_slip_rate_the_tipping_phase_asks_for_as_much_friction_as_the_near_collision(
        body in any_body(),
    ) {
        prop_assume!(body.height() > 0.0);
        let law = IdealLaw::NoSlip.dynamics(&body, PAPER_GRAVITY);
        let rate = slip_rate(&body, PAPER_GRAVITY).expect("valid");
        let ratio = |rate: f64| {
            let contact = law.contact(&arriving(rate));
            contact.along.abs() / contact.normal
        };
        let needed = needed_friction(&body);
        prop_assert!((ratio(rate) / needed - 1.0).abs() < 1e-8);
        prop_assert!(ratio(0.99999 * rate) < needed && ratio(1.00001 * rate) > needed);
    }

    /// The steady wobble is a solution of appendix A's equations: only yaw and spin change.
    #[test]
    fn a_steady_wobble_solves_the_equations_of_both_laws(body in any_body(), tilt in 0.01..3.1) {
        let yaw_rate = match steady_wobble_rate(&body, tilt, PAPER_GRAVITY) {
            Ok(rate) => rate,
            Err(_) => return Err(TestCaseError::reject("no wobble at this tilt")),
        };
        let (sin, cos) = libm::sincos(tilt);
        let u = Coordinates::from_state(&State {
            tilt,
            yaw_rate,
            spin_rate: yaw_rate * (body.height() * sin / body.radius() - cos),
            ..State::default()
        });
        for kind in IdealLaw::ALL {
            let law = kind.dynamics(&body, PAPER_GRAVITY);
            let rates = law.rates(&u);
            let [vx, vy] = law.center_velocity(&u);
            let scale = u.w * u.w + PAPER_GRAVITY / body.radius();
            prop_assert!(rates.p.abs() < 1e-12 * scale, "{kind:?} {}", rates.p / scale);
            prop_assert_eq!((rates.w, rates.s, rates.sin, rates.cos), (0.0, 0.0, -0.0, 0.0));
            prop_assert!(vx == 0.0 && vy.abs() < 1e-12 * body.radius() * u.w.abs());
        }
    }
}

/// |T|/N equals μ* through the whole near-collision, to the order of the tilt.
#[test]
fn friction_in_the_near_collision_is_the_needed_one() {
    let motion = follow(&can(), &paper_start(1e-8), IdealLaw::NoSlip, &tight(0.4));
    let needed = needed_friction(&can());
    let close: Vec<_> = motion
        .trajectory
        .samples(4)
        .into_iter()
        // Here the forces of the near-collision, of order φ_c²/φ³, are large compared with the weight.
        .filter(|u| u.sin < 1e-8)
        .collect();
    assert!(close.len() > 100);
    for u in close {
        let contact = motion.dynamics(&u).contact(&u);
        let ratio = libm::hypot(contact.along, contact.across) / contact.normal;
        assert!(
            (ratio / needed - 1.0).abs() < 1e-4,
            "{ratio} at tilt {:e}",
            u.sin
        );
    }
}

/// The tipping rate ω of a body that falls flat from rest, from the energy of the plane pendulum.
fn arrival_rate(body: &Body, law: IdealLaw, start: &State) -> f64 {
    let (sin, cos) = libm::sincos(start.tilt);
    let drop = body.radius() * sin - body.height() * (1.0 - cos);
    let rho = body.radius() * cos - body.height() * sin;
    let (m, a, r) = (body.mass(), body.transverse_inertia(), body.radius());
    let (at_start, flat) = match law {
        IdealLaw::NoSlip => (body.rim_inertia(), body.rim_inertia()),
        IdealLaw::Frictionless => (a + m * rho * rho, a + m * r * r),
    };
    let kinetic = at_start * start.tilt_rate * start.tilt_rate + 2.0 * m * PAPER_GRAVITY * drop;
    (kinetic / flat).sqrt()
}

/// The values for the paper's start, from the closed form.
#[test]
fn error_law_of_the_can() {
    for (law, expected) in [
        (IdealLaw::NoSlip, "-2.6919"),
        (IdealLaw::Frictionless, "-2.7181"),
    ] {
        let tipping_rate = arrival_rate(&can(), law, &paper_start(0.0));
        let b = error_law_coefficient(&can(), law, tipping_rate, PAPER_GRAVITY).expect("valid");
        assert_eq!(format!("{b:.4}"), expected);
    }
}

/// The turn of a body released at rest, up to the next tilt maximum; `None` if it lifts off before.
fn turn_from_rest(body: &Body, law: IdealLaw, tilt: f64, sideways: f64) -> Option<Turn> {
    let falling_rate = (PAPER_GRAVITY / body.radius()).sqrt();
    let start = State {
        tilt,
        yaw_rate: sideways * falling_rate,
        ..State::default()
    };
    let motion = follow(body, &start, law, &tight(25.0 / falling_rate));
    let turn = motion.turns.first().copied();
    assert!(turn.is_some() || motion.status == Status::LiftedOff);
    turn
}

proptest! {
    #![proptest_config(cases(60))]

    /// (|Δψ| − limit)/φ_c is linear in ln φ_c with the slope b. The difference quotient of two close turns
    /// has this slope up to terms of order φ_c ln² φ_c, which were measured to be below 1e-4 b.
    #[test]
    fn the_turn_of_any_body_approaches_its_limit_with_the_slope_b(
        body in any_body(),
        part in 0.1..0.7,
    ) {
        let tilt = part * body.balance_tilt();
        for law in IdealLaw::ALL {
            let start = State { tilt, ..State::default() };
            let tipping_rate = arrival_rate(&body, law, &start);
            let expected =
                error_law_coefficient(&body, law, tipping_rate, PAPER_GRAVITY).expect("valid");
            let turns = [1e-6, 1e-7].map(|x| turn_from_rest(&body, law, tilt, x));
            let [Some(far), Some(near)] = turns else { continue };
            let excess = |turn: &Turn| (turn.angle.abs() - turn_limit(&body, law)) / turn.min_tilt;
            let b = (excess(&far) - excess(&near)) / libm::log(far.min_tilt / near.min_tilt);
            // The rounding error of the turns, divided by φ_c.
            let rounding = 1e-14 / near.min_tilt;
            prop_assert!((b - expected).abs() < 1e-3 * expected.abs() + rounding, "{b} not {expected}");
        }
    }
}

/// The no-slip equations alone, with a contact that can push and pull.
struct Bilateral(NoSlip<f64>);

impl System<f64, COORDINATES> for Bilateral {
    fn rates(&self, u: &[f64; COORDINATES]) -> [f64; COORDINATES] {
        self.0.rates(&Coordinates::from_array(u)).into_array()
    }

    fn scale(&self, u: &[f64; COORDINATES]) -> [f64; COORDINATES] {
        let u = Coordinates::from_array(u);
        Coordinates {
            yaw: 1.0,
            spin: 1.0,
            t: 1.0,
            sin: u.sin,
            cos: 1.0,
            p: u.p.abs() + u.w.abs(),
            w: u.w.abs() + u.sin * u.s.abs(),
            s: u.s.abs() + u.sin * u.w.abs(),
            ..Coordinates::from_array(&[1.0; COORDINATES])
        }
        .into_array()
    }
}

/// From the tilt 1e-8 rad, where gravity and the body's dimensions are negligible, down to about 1e-14 rad
/// and up again.
fn turn_of_a_spinning_body(body: &Body, spin: f64, tipping_rate: f64) -> f64 {
    const EDGE: f64 = 1e-8;
    const L: f64 = 1e-13;
    let law = Bilateral(NoSlip::new(Parameters::new(body, PAPER_GRAVITY)));
    let start = Coordinates {
        p: -tipping_rate,
        w: L / EDGE,
        s: spin,
        ..Coordinates::from_state(&State {
            tilt: EDGE,
            ..State::default()
        })
    };
    let mut stepper = Stepper::new(&law, start.into_array(), 0.01 / tipping_rate, 1e-13);
    loop {
        let step = stepper.advance().expect("a step").dense(&law);
        let end = Coordinates::from_array(&step.end);
        if end.p > 0.0 && end.sin > EDGE {
            let x = step.root(0.0, 1.0, |u| Coordinates::from_array(u).sin - EDGE);
            return Coordinates::from_array(&step.at(x)).yaw;
        }
    }
}

/// The turn depends on the spin; here it is compared with the solution of the inner problem. Tilts above 1e-8
/// rad contribute another 2l/(ω · 1e-8) = 3e-6 of the turn, which is left out.
#[test]
fn a_spinning_body_turns_by_another_limit() {
    let mut bodies = vec![can(), presets::disk(0.05).expect("a disk")];
    bodies.push(presets::euler_disk().expect("the toy"));
    for body in bodies {
        for spin in [-30.0, -5.0, 0.0, 2.0, 20.0] {
            let expected = turn_limit_with_spin(&body, spin, 7.0).expect("valid");
            let turn = turn_of_a_spinning_body(&body, spin, 7.0);
            assert!(
                (turn - expected).abs() < 1e-5,
                "spin {spin}: {turn} not {expected}"
            );
        }
    }
    let limit = turn_limit(&can(), IdealLaw::NoSlip);
    let still = turn_limit_with_spin(&can(), 0.0, 7.0).expect("valid");
    assert!((still - limit).abs() < 1e-15);
}

/// With a spin against the turn the normal force stays positive; with a spin along the turn it would have to
/// be negative.
#[test]
fn a_can_that_spins_with_its_turn_lifts_off() {
    let start = |spin: f64| {
        let (tilt, yaw_rate) = (1e-7, 1e-13 / 1e-14);
        State {
            tilt,
            tilt_rate: -7.0,
            yaw_rate,
            spin_rate: spin - yaw_rate,
            ..State::default()
        }
    };
    let with = follow(&can(), &start(5.0), IdealLaw::NoSlip, &tight(1e-6));
    assert_eq!(with.status, Status::LiftedOff);
    let against = follow(&can(), &start(-5.0), IdealLaw::NoSlip, &tight(1e-6));
    assert_eq!(against.status, Status::Finished);
    let expected = turn_limit_with_spin(&can(), -5.0, 7.0).expect("valid");
    assert!((against.trajectory.end().yaw - expected).abs() < 1e-5);
}

proptest! {
    #![proptest_config(cases(100))]

    #[test]
    fn a_near_collision_turns_by_the_limit(
        body in any_body(),
        direction in prop_oneof![Just(1.0), Just(-1.0)],
    ) {
        for law in IdealLaw::ALL {
            let near = NearCollision::new(&body, law, 1e-6, 3.0, direction).expect("valid");
            let turn = near.yaw(f64::INFINITY) - near.yaw(f64::NEG_INFINITY);
            prop_assert!((direction * turn / turn_limit(&body, law) - 1.0).abs() < 1e-15);
            prop_assert_eq!(near.tilt(0.0), 1e-6);
            // Eq. `psidotandphi`: ψ̇ φ² is constant.
            for t in [0.0, 1e-7, -1e-6, 1e-3] {
                let tilt = near.tilt(t);
                let l = near.yaw_rate(t) * tilt * tilt;
                prop_assert!((l / (near.stretch * 1e-6 * 3.0) - 1.0).abs() < 1e-15);
            }
        }
    }

    /// The heuristic lean vector follows the same spiral as Eqs. `phiandt` and `psidotandphi`.
    #[test]
    fn the_lean_vector_is_the_near_collision(body in any_body(), min_tilt in 1e-9..1e-3) {
        for law in IdealLaw::ALL {
            let near = NearCollision::new(&body, law, min_tilt, 5.0, -1.0).expect("valid");
            let samples = lean_vector(&near, 0.1).unwrap();
            prop_assert!(samples.len() > 20 && samples[samples.len() - 1][0] > 0.02);
            for [t, tilt, yaw] in samples {
                prop_assert!((tilt / near.tilt(t) - 1.0).abs() < 1e-11);
                prop_assert!((yaw - near.yaw(t)).abs() < 1e-11 * near.stretch.abs());
            }
        }
    }
}

/// The near-collision is the limit of the full motion: at the tilt φ they differ by about φ.
#[test]
fn the_near_collision_agrees_with_the_full_motion_to_the_order_of_the_tilt() {
    for law in IdealLaw::ALL {
        let motion = follow(&can(), &paper_start(1e-6), law, &tight(1.0));
        let turn = motion.turns[0];
        let lowest = motion.trajectory.at(turn.t);
        let rate = arrival_rate(&can(), law, &paper_start(0.0));
        let near = NearCollision::new(&can(), law, turn.min_tilt, rate, 1.0).expect("valid");
        let rocking = motion.trajectory.samples(3);
        for u in rocking.iter().filter(|u| u.t < turn.end && u.sin < 0.1) {
            let (tilt, yaw) = (near.tilt(u.t - turn.t), near.yaw(u.t - turn.t));
            assert!((u.tilt() / tilt - 1.0).abs() < 1.5 * tilt);
            assert!((u.yaw - lowest.yaw - yaw).abs() < 1.5 * tilt);
        }
    }
}

/// The composite approximation and its largest errors (rad) over one rocking motion; `None` if the body
/// leaves the table or does not come down.
fn composite_errors(body: &Body, law: IdealLaw, start: &State) -> Option<(Composite, [f64; 2])> {
    let composite = composite(body, start, law, PAPER_GRAVITY).ok()?;
    let motion = follow(
        body,
        start,
        law,
        &tight(composite.time + composite.half_width),
    );
    if motion.status != Status::Finished {
        return None;
    }
    let [mut tilt, mut yaw] = [0.0_f64; 2];
    for u in motion.trajectory.samples(4) {
        if (u.t - composite.time).abs() < composite.half_width {
            tilt = tilt.max((composite.tilt(u.t) - u.tilt()).abs());
            yaw = yaw.max((composite.yaw(u.t) - u.yaw).abs());
        }
    }
    Some((composite, [tilt, yaw]))
}

proptest! {
    #![proptest_config(cases(60))]

    /// The composite approximation from one tilt maximum to the next. The error of the yaw is
    /// φ_c (b′ ln φ_c + a). Relative to φ_c ln φ_c, it grows by less than half as φ_c decreases a
    /// hundredfold; the additional 2b allows for starts at which the logarithm and a cancel. The error of
    /// the tilt is below φ_c |ln φ_c|.
    #[test]
    fn the_composite_approximation_errs_by_the_order_of_phi_c_ln_phi_c(
        body in any_body(),
        part in 0.1..0.7,
        flick in -0.3..0.3,
        spin in -1.0..1.0,
    ) {
        let falling_rate = (PAPER_GRAVITY / body.radius()).sqrt();
        let start = |sideways: f64| State {
            tilt: part * body.balance_tilt(),
            tilt_rate: flick * falling_rate,
            yaw: 1.0,
            yaw_rate: sideways * falling_rate,
            spin_rate: spin * sideways * falling_rate,
            ..State::default()
        };
        for law in IdealLaw::ALL {
            let errors = [1e-4, 1e-6].map(|x| composite_errors(&body, law, &start(x)));
            let [Some((far, far_errors)), Some((near, near_errors))] = errors else { continue };
            let order = |p: &Composite| {
                let min_tilt = p.near_collision.min_tilt;
                min_tilt * libm::log(min_tilt).abs()
            };
            prop_assert!(far_errors[0] < order(&far) && near_errors[0] < order(&near));

            let rate = near.near_collision.tipping_rate;
            let b = error_law_coefficient(&body, law, rate, PAPER_GRAVITY).expect("valid");
            let expected = order(&near) * (1.5 * far_errors[1] / order(&far) + 2.0 * b.abs());
            // The rounding error of the time times the largest yaw rate of the near-collision.
            let rounding = 1e-14 * near.time * near.near_collision.yaw_rate(0.0).abs();
            prop_assert!(
                near_errors[1] < expected + rounding,
                "{law:?} {} {expected} {rounding}", near_errors[1]
            );
        }
    }
}
