//! The endings and events of motions, and special motions with known solutions.

use crate::given::motions;

use core::f64::consts::{FRAC_PI_2, PI};
use core::ops::ControlFlow;
use motions::{PAPER_GRAVITY, follow, paper_start, tight};
use rimroll::motion::{AngleUnit, EndingKind, EventKind};
use rimroll::steady::steady_wobble_rate;
use rimroll::turn::{lift_off_rate, turn_limit};
use rimroll::{Body, IdealLaw, Motion, Options, State, Status, presets, simulate};

fn can() -> Body {
    presets::can_2007().expect("the paper's can")
}

fn disk() -> Body {
    presets::disk(0.051).expect("a disk")
}

fn kinds(motion: &Motion) -> Vec<EventKind> {
    motion.events.iter().map(|event| event.kind).collect()
}

/// The horizontal position of the centre of mass, m.
fn center_height(body: &Body, tilt: f64) -> f64 {
    let (sin, cos) = libm::sincos(tilt);
    body.radius() * sin + body.height() * cos
}

/// J′(φ) of the plane pendulum, kg m²: J without slip, A + mρ² without friction.
fn pendulum_inertia(body: &Body, law: IdealLaw, tilt: f64) -> f64 {
    let (sin, cos) = libm::sincos(tilt);
    let rho = body.radius() * cos - body.height() * sin;
    match law {
        IdealLaw::NoSlip => body.rim_inertia(),
        IdealLaw::Frictionless => body.transverse_inertia() + body.mass() * rho * rho,
    }
}

/// φ̇² of the plane pendulum at a tilt, from the conservation of energy.
fn pendulum_rate_squared(body: &Body, law: IdealLaw, start: &State, tilt: f64) -> f64 {
    let drop = center_height(body, start.tilt) - center_height(body, tilt);
    let kinetic = pendulum_inertia(body, law, start.tilt) * start.tilt_rate * start.tilt_rate
        + 2.0 * body.mass() * PAPER_GRAVITY * drop;
    kinetic / pendulum_inertia(body, law, tilt)
}

/// ∫ dφ/|φ̇| from the start to flat, s, by Simpson's rule in x with φ = φ₀ − x². In x the integrand is smooth
/// although φ̇ is small at first; the error is below 1e-13 s.
fn pendulum_time(body: &Body, law: IdealLaw, start: &State) -> f64 {
    const INTERVALS: u32 = 20_000;
    let width = start.tilt.sqrt() / f64::from(INTERVALS);
    let sum: f64 = (0..=INTERVALS)
        .map(|i| {
            let weight = match i {
                0 | INTERVALS => 1.0,
                _ if i % 2 == 1 => 4.0,
                _ => 2.0,
            };
            let x = width * f64::from(i);
            let rate = pendulum_rate_squared(body, law, start, start.tilt - x * x).sqrt();
            weight * 2.0 * x / rate
        })
        .sum();
    sum * width / 3.0
}

#[test]
fn without_any_sideways_motion_the_body_falls_face_down_like_a_plane_pendulum() {
    let start = paper_start(0.0);
    for law in IdealLaw::ALL {
        for body in [can(), disk(), presets::coin().expect("a coin")] {
            let motion = follow(&body, &start, law, &tight(2.0));
            assert_eq!(motion.status, Status::FaceDown);
            assert_eq!(kinds(&motion), [EventKind::FaceDown]);
            assert!(motion.turns.is_empty());
            let end = motion.trajectory.end();
            assert!((end.t - pendulum_time(&body, law, &start)).abs() < 1e-12);
            let rate = pendulum_rate_squared(&body, law, &start, 0.0).sqrt();
            assert!((end.p + rate).abs() < 1e-11 * rate);
            assert_eq!((end.yaw, end.w), (0.0, 0.0));
        }
    }
}

#[test]
fn face_down_says_why_nothing_follows_and_what_to_do() {
    let motion = follow(&can(), &paper_start(0.0), IdealLaw::NoSlip, &tight(2.0));
    for words in [
        "face down at t = 0.243087 s",
        "simultaneous impacts",
        "1e-12",
    ] {
        assert!(motion.message().contains(words), "{}", motion.message());
    }
}

#[test]
fn an_ending_is_told_in_the_unit_that_is_asked_for() {
    let start = State {
        tilt: 0.7,
        yaw_rate: 0.1,
        ..State::default()
    };
    let options = Options {
        topple_tilt: Some(1.5),
        ..tight(5.0)
    };
    let ending = follow(&can(), &start, IdealLaw::NoSlip, &options).ending;
    assert_eq!(
        (ending.kind, ending.status()),
        (EndingKind::Toppled, Status::Toppled)
    );
    assert!((ending.tilt - 1.5).abs() < 1e-10);
    let t = format!("t = {:.6} s", ending.t);
    assert_eq!(
        ending.sentence(AngleUnit::Radians),
        format!("toppled: the tilt reached 1.500000 rad at {t}")
    );
    assert_eq!(
        ending.sentence(AngleUnit::Degrees),
        format!("toppled: the tilt reached 85.944° at {t}")
    );
}

/// Beyond the balance point tan φ* = R/H, 0.6365 rad for the can, the can falls on its side.
#[test]
fn past_its_balance_point_the_can_topples_onto_its_side() {
    let balance = can().balance_tilt();
    for law in IdealLaw::ALL {
        for (beyond, status) in [(1e-3, Status::Toppled), (-1e-3, Status::Finished)] {
            let start = State {
                tilt: balance + beyond,
                yaw_rate: 1e-6,
                ..State::default()
            };
            let motion = follow(&can(), &start, law, &tight(3.0));
            assert_eq!(motion.status, status);
        }
    }
}

#[test]
fn toppling_is_found_at_the_tilt_that_was_asked_for() {
    let start = State {
        tilt: 0.7,
        tilt_rate: 0.3,
        yaw_rate: 0.4,
        spin_rate: -0.2,
        ..State::default()
    };
    for law in IdealLaw::ALL {
        for (asked, expected) in [
            (None, FRAC_PI_2),
            (Some(1.5), 1.5),
            (Some(0.70001), 0.70001),
            (Some(1.8), 1.8),
            (Some(FRAC_PI_2 - 1e-12), FRAC_PI_2),
            (Some(FRAC_PI_2.next_up()), FRAC_PI_2),
            (Some(FRAC_PI_2 + 1e-9), FRAC_PI_2 + 1e-9),
        ] {
            let options = Options {
                topple_tilt: asked,
                ..tight(5.0)
            };
            let motion = follow(&can(), &start, law, &options);
            assert_eq!(motion.status, Status::Toppled);
            assert_eq!(motion.status.name(), "toppled");
            assert_eq!(kinds(&motion).last(), Some(&EventKind::Topple));
            let end = motion.trajectory.end();
            assert!((end.tilt() - expected).abs() < 1e-10, "{}", end.tilt());
            assert_eq!(motion.events.last().map(|event| event.at), Some(end));
            assert!(motion.message().contains("toppled: the tilt reached"));
            // It passes its edge only on its way to a tilt beyond.
            let passes = kinds(&motion).contains(&EventKind::OnEdge);
            assert_eq!(passes, expected > FRAC_PI_2, "{asked:?}");
        }
    }
}

/// At a loose tolerance the dense output is inaccurate, but an extremum is located by a real step.
#[test]
fn extremes_of_the_tilt_are_where_its_rate_is_zero_whatever_the_tolerance() {
    for law in IdealLaw::ALL {
        for rtol in [1e-4, 1e-6, 1e-10, 1e-13] {
            let options = Options { rtol, ..tight(2.0) };
            let motion = follow(&can(), &paper_start(0.005), law, &options);
            assert!(motion.events.len() >= 6);
            for event in &motion.events {
                // Relative to √(g/R) = 14 rad/s and to the yaw rate.
                let size = 14.0 + event.at.w.abs();
                assert!(
                    event.at.p.abs() < 1e-9 * size,
                    "{law:?} {rtol:e} {:?}",
                    event.kind
                );
            }
        }
    }
}

/// A flick from 30° with which the can reaches the table at the given tipping rate.
fn flick(arrival_rate: f64) -> State {
    let (body, tilt) = (can(), PI / 6.0);
    let drop = center_height(&body, tilt) - body.height();
    let square =
        arrival_rate * arrival_rate - 2.0 * body.mass() * PAPER_GRAVITY * drop / body.rim_inertia();
    State {
        tilt,
        tilt_rate: -square.sqrt(),
        yaw_rate: 1e-11,
        ..State::default()
    }
}

/// ω² = gK/(JH), 10.605 rad/s for the can: above it the rim would have to be pulled down at the end of the
/// tipping phase. The test checks a relative difference of 10⁻⁵ to either side. The near-collision is so
/// close that its own normal force begins later.
#[test]
fn a_flick_past_the_lift_off_rate_lifts_the_can_before_its_near_collision() {
    let limit = lift_off_rate(&can(), PAPER_GRAVITY).expect("valid");
    let options = Options {
        topple_tilt: Some(1.0),
        ..tight(0.5)
    };
    let below = follow(&can(), &flick(limit * 0.99999), IdealLaw::NoSlip, &options);
    assert_eq!(below.status, Status::Toppled);
    assert_eq!(kinds(&below), [EventKind::TiltMin, EventKind::Topple]);

    let above = follow(&can(), &flick(limit * 1.00001), IdealLaw::NoSlip, &options);
    assert_eq!(above.status, Status::LiftedOff);
    assert_eq!(kinds(&above), [EventKind::LiftOff]);
    assert!(above.message().contains("lifted off at t = "));
    let end = above.trajectory.end();
    assert!(end.tilt() < 1e-3 && end.p < 0.0);
    let contact = above.dynamics(&end).contact(&end);
    assert!((contact.normal / end.sin).abs() < 1e-9 * can().mass() * PAPER_GRAVITY);
}

/// A state in which the table would have to pull at the rim is not a valid start.
#[test]
fn a_start_already_off_the_table_ends_at_once() {
    let start = flick(30.0);
    for law in IdealLaw::ALL {
        let motion = follow(&can(), &start, law, &tight(0.5));
        assert_eq!(motion.status, Status::LiftedOff);
        assert_eq!(motion.trajectory.end().t, 0.0);
    }
}

/// The square of the spin rate is three times the g/(3R) that keeps a uniform disk from falling over (Cushman
/// & Duistermaat 2006).
#[test]
fn a_fast_disk_on_its_edge_rolls_straight_ahead() {
    let spin_rate = (PAPER_GRAVITY / disk().radius()).sqrt();
    let start = State {
        tilt: FRAC_PI_2,
        spin_rate,
        ..State::default()
    };
    let motion = follow(&disk(), &start, IdealLaw::NoSlip, &tight(3.0));
    assert_eq!(motion.status, Status::Finished);
    for u in motion.trajectory.samples(4) {
        // The disk rolls along e_y1.
        assert!((u.center()[1] - disk().radius() * spin_rate * u.t).abs() < 1e-12);
        assert!(u.center()[0].abs() < 1e-14 && u.yaw.abs() < 1e-12);

        assert!((u.tilt() - FRAC_PI_2).abs() < 1e-12);
    }
}

/// A slightly disturbed disk nods through the upright position at the rate √((3s² − g/R)/(5/4)) of the
/// linearised equations for a uniform disk, and its path is curved. Disturbances to either side give mirror
/// images. The amplitude of 0.006 rad changes the rate in proportion to its square.
#[test]
fn a_fast_disk_that_is_pushed_nods_through_the_upright() {
    let rolling = PAPER_GRAVITY / disk().radius();
    let start = |push: f64| State {
        tilt: FRAC_PI_2,
        tilt_rate: push,
        spin_rate: rolling.sqrt(),
        ..State::default()
    };
    let one = follow(&disk(), &start(0.1), IdealLaw::NoSlip, &tight(3.0));
    let other = follow(&disk(), &start(-0.1), IdealLaw::NoSlip, &tight(3.0));
    let half_period = PI / (1.6 * rolling).sqrt();
    for motion in [&one, &other] {
        assert_eq!(motion.status, Status::Finished);
        // The start itself can count as one.
        let uprights: Vec<_> = motion
            .events
            .iter()
            .filter(|event| event.kind == EventKind::OnEdge && event.at.t > 0.5 * half_period)
            .map(|event| event.at)
            .collect();
        assert!(uprights.len() >= 16);
        for (nods, upright) in (1..).map(f64::from).zip(&uprights) {
            assert!(upright.cos.abs() < 1e-14);
            assert!((upright.t / (nods * half_period) - 1.0).abs() < 1e-4);
        }
    }
    for i in 0..100 {
        let t = 0.03 * f64::from(i);
        let (u, v) = (one.trajectory.at(t), other.trajectory.at(t));
        assert!((u.tilt() + v.tilt() - PI).abs() < 1e-12);
        assert!((u.yaw + v.yaw).abs() < 1e-12);
        let ([ux, uy], [vx, vy]) = (u.center(), v.center());
        assert!((uy - vy).abs() < 1e-12 && (ux + vx).abs() < 1e-12);
    }
}

/// From sin φ₀ = 0.8, where the normal force stays positive.
#[test]
fn a_disk_falls_onto_the_face_it_leans_to() {
    let lean = libm::asin(0.8);
    for law in IdealLaw::ALL {
        for (tilt, face) in [(lean, 0.0), (PI - lean, PI)] {
            let start = State {
                tilt,
                ..State::default()
            };
            let motion = follow(&disk(), &start, law, &tight(5.0));
            assert_eq!(motion.status, Status::FaceDown);
            assert!((motion.trajectory.end().tilt() - face).abs() < 1e-15);
        }
    }
}

/// From rest at φ₀ without slip, the energy gives φ̇² = 8g(σ₀ − σ)/(5R) with σ = sin φ, and N = mg(1/5 −
/// 8σ₀σ/5 + 12σ²/5), which vanishes at φ = 30° for σ₀ = 1.
#[test]
fn a_uniform_disk_that_topples_from_its_edge_without_slip_lifts_off_at_30_degrees() {
    for towards in [1.0, -1.0] {
        let start = State {
            tilt: FRAC_PI_2 - towards * 1e-3,
            ..State::default()
        };
        let motion = follow(&disk(), &start, IdealLaw::NoSlip, &tight(5.0));
        assert_eq!(motion.status, Status::LiftedOff);
        let from = libm::sin(start.tilt);
        let expected = (from + (from * from - 0.75).sqrt()) / 3.0;

        assert!((motion.trajectory.end().sin - expected).abs() < 1e-12);
        assert!((libm::asin(expected).to_degrees() - 30.0).abs() < 1e-4);
    }
}

/// Without friction a flick carries the disk over its edge from one face to the other and back. On the other
/// face it has a near-collision with the same limit.
#[test]
fn a_disk_flicked_over_its_edge_turns_on_its_other_face() {
    let start = State {
        tilt: 0.5,
        tilt_rate: 14.6,
        yaw_rate: 1e-6,
        spin_rate: 1e-6,
        ..State::default()
    };
    let law = IdealLaw::Frictionless;
    let motion = follow(&disk(), &start, law, &tight(1.0));
    assert_eq!(
        kinds(&motion)[..4],
        [
            EventKind::OnEdge,
            EventKind::TiltMax,
            EventKind::OnEdge,
            EventKind::TiltMin
        ]
    );
    let far = motion.events[1].at.tilt();
    let turn = motion.turns[0];

    assert!(far > 3.1 && (turn.min_tilt - (PI - far)).abs() < 1e-15);
    assert!(
        (turn.angle.abs() - turn_limit(&disk(), law)).abs() < 1e-5,
        "{turn:?}"
    );
}

/// With the centre of mass at rest the body wobbles at a constant tilt, and the contact force is the weight
/// alone.
///
/// The can's wobble at 0.3 rad is stable. The tilt drifts only by rounding; a tolerance of 1e-9 rad is ample.
#[test]
fn a_steady_wobble_stays_steady_for_a_hundred_turns() {
    for law in IdealLaw::ALL {
        for (body, tilt) in [(can(), 0.3), (disk(), 0.3), (disk(), 1.2), (can(), 0.01)] {
            let yaw_rate = steady_wobble_rate(&body, tilt, PAPER_GRAVITY).expect("exists");
            let (sin, cos) = libm::sincos(tilt);
            let start = State {
                tilt,
                yaw_rate,
                spin_rate: yaw_rate * (body.height() * sin / body.radius() - cos),
                ..State::default()
            };
            let motion = follow(&body, &start, law, &tight(200.0 * PI / yaw_rate));
            assert_eq!(motion.status, Status::Finished);
            assert!(
                motion.events.is_empty(),
                "{law:?} {body:?} {tilt} {:?}",
                kinds(&motion)
            );
            let weight = body.mass() * PAPER_GRAVITY;
            for u in motion.trajectory.nodes() {
                assert!((u.tilt() - tilt).abs() < 1e-9);
                let [x, y] = u.center().map(|x| x / body.radius());
                assert!(x.abs() < 1e-9 && y.abs() < 1e-9);
                let contact = motion.dynamics(&u).contact(&u);
                assert!((contact.normal / u.sin / weight - 1.0).abs() < 1e-8);
                assert!(libm::hypot(contact.along, contact.across) / u.sin < 1e-8 * weight);
            }
            let turned = motion.trajectory.end().yaw / (200.0 * PI);
            assert!((turned - 1.0).abs() < 1e-9, "{turned}");
        }
    }
}

#[test]
fn a_motion_lasts_exactly_as_long_as_asked_for() {
    for law in IdealLaw::ALL {
        for duration in [1e-6, 0.1, 0.24308731, 1.0 / 3.0, 2.0] {
            let motion = follow(&can(), &paper_start(0.005), law, &tight(duration));
            assert_eq!(motion.status, Status::Finished);
            assert_eq!(motion.trajectory.end().t, duration);
            assert_eq!(motion.trajectory.at(duration), motion.trajectory.end());
            assert_eq!(
                motion.trajectory.at(2.0 * duration),
                motion.trajectory.end()
            );
            assert_eq!(
                motion.trajectory.at(0.0).state(),
                motion.trajectory.at(-1.0).state()
            );
        }
    }
}

/// The dense output is one order less accurate than the ends of the steps. The default tolerance of 1e-10
/// still gives nine digits of the yaw.
#[test]
fn a_motion_evaluated_anywhere_agrees_with_its_steps_and_with_a_finer_motion() {
    for law in IdealLaw::ALL {
        let fine = follow(&can(), &paper_start(0.005), law, &tight(1.0));
        let options = Options {
            rtol: Options::default().rtol,
            ..tight(1.0)
        };
        let motion = follow(&can(), &paper_start(0.005), law, &options);
        for node in motion.trajectory.nodes() {
            let at = motion.trajectory.at(node.t);
            // ψ̇ reaches 8e4 rad/s, so the last bit of t corresponds to 1e-11 rad.
            assert!((at.yaw - node.yaw).abs() < 1e-10);
            assert!((at.p - node.p).abs() < 1e-10);
        }

        for u in motion.trajectory.samples(7) {
            let exact = fine.trajectory.at(u.t);
            // The near-collision is so fast that a time error of 1e-11 s is visible.
            let allowed = 1e-9 + 1e-11 * exact.yaw_rate().abs();
            assert!((u.yaw - exact.yaw).abs() < allowed);
            assert!((u.tilt() - exact.tilt()).abs() < 1e-10);
        }
    }
}

/// Mechanics is reversible: with all rates reversed the can returns to its start. A near-collision at φ_c
/// turns an error of 1e-14 in l = ψ̇ sin² φ into an error of 1e-14/φ_c in the turn. ψ̇ = 0.05 rad/s gives φ_c
/// = 2e-3, so four passages stay well below 1e-11.
#[test]
fn time_runs_backward_to_the_start() {
    let start = paper_start(0.05);
    for law in IdealLaw::ALL {
        let forward = follow(&can(), &start, law, &tight(1.3));
        assert!(forward.turns.len() >= 2);
        let end = forward.trajectory.end().state();
        let reversed = State {
            tilt_rate: -end.tilt_rate,
            yaw_rate: -end.yaw_rate,
            spin_rate: -end.spin_rate,
            ..end
        };
        let back = follow(&can(), &reversed, law, &tight(1.3))
            .trajectory
            .end()
            .state();
        for (value, expected) in [
            (back.tilt, start.tilt),
            (back.yaw, start.yaw),
            (back.spin, start.spin),
            (back.tilt_rate, -start.tilt_rate),
            (back.yaw_rate, -start.yaw_rate),
            (back.spin_rate, -start.spin_rate),
        ] {
            assert!(
                (value - expected).abs() < 1e-11,
                "{law:?} {value} {expected}"
            );
        }
    }
}

/// A reflection changes the sign of yaw and spin and leaves the tilt unchanged. The results agree exactly,
/// because rounding is symmetric in sign.
#[test]
fn mirror_images_agree_to_the_last_bit() {
    let start = State {
        yaw_rate: 0.03,
        spin_rate: -0.02,
        ..paper_start(0.0)
    };
    let image = State {
        yaw_rate: -start.yaw_rate,
        spin_rate: -start.spin_rate,
        ..start
    };
    for law in IdealLaw::ALL {
        let one = follow(&can(), &start, law, &tight(2.0));
        let other = follow(&can(), &image, law, &tight(2.0));
        assert_eq!(one.work, other.work);
        for (u, v) in one.trajectory.nodes().zip(other.trajectory.nodes()) {
            assert_eq!((u.t, u.sin, u.cos, u.p), (v.t, v.sin, v.cos, v.p));
            assert_eq!((u.yaw, u.spin, u.w, u.s), (-v.yaw, -v.spin, -v.w, -v.s));
            assert_eq!((u.x1, u.y1), (v.x1, -v.y1));
        }
        for (turn, mirrored) in one.turns.iter().zip(&other.turns) {
            assert_eq!(turn.angle, -mirrored.angle);
            assert_eq!(turn.min_tilt, mirrored.min_tilt);
        }
    }
}

#[test]
fn a_motion_that_runs_out_of_steps_says_so() {
    let options = Options {
        max_steps: 50,
        ..tight(2.0)
    };
    let motion = follow(&can(), &paper_start(0.005), IdealLaw::NoSlip, &options);
    assert_eq!(motion.status, Status::Failed);
    assert_eq!(motion.work.steps, 50);
    assert!(
        motion
            .message()
            .contains("after 50 steps, the limit max_steps"),
        "{}",
        motion.message()
    );
}

#[test]
fn a_caller_can_stop_a_long_motion() {
    let options = tight(1e4);
    let motion = simulate(
        &can(),
        &paper_start(0.005),
        IdealLaw::NoSlip,
        &options,
        |t| {
            if t > 20.0 {
                ControlFlow::Break(())
            } else {
                ControlFlow::Continue(())
            }
        },
    )
    .expect("valid input");
    assert_eq!(motion.status, Status::Interrupted);
    assert!(motion.trajectory.end().t > 20.0 && motion.trajectory.end().t < 100.0);
    assert!(motion.message().contains("interrupted at t = "));
}

/// The tilt exceeds the topple tilt and returns within one step, so only the dense output shows it.
#[test]
fn a_topple_tilt_just_under_the_maximum_is_not_stepped_over() {
    let can = presets::can_2007().unwrap();
    for law in IdealLaw::ALL {
        for tilt in [0.30, 0.34, 0.38, 0.42, 0.46, 0.50] {
            let start = State {
                tilt,
                tilt_rate: -0.5,
                yaw_rate: 0.005,
                spin_rate: 0.005,
                ..State::default()
            };
            let loose = Options {
                rtol: 1e-3,
                ..Options::default()
            };
            let free = simulate(&can, &start, law, &loose, |_| ControlFlow::Continue(())).unwrap();
            let caught = Options {
                topple_tilt: Some(free.turns[0].max_tilt - 2e-4),
                ..loose
            };
            let motion =
                simulate(&can, &start, law, &caught, |_| ControlFlow::Continue(())).unwrap();
            assert_eq!(motion.status, Status::Toppled, "{law:?} from {tilt}");
        }
    }
}
