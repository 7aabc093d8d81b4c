//! Motions in which something relaxes far faster than the body moves, so that explicit steps must be short.

use crate::given::motions;

use motions::{follow, paper_start, tight};
use rimroll::law::{AirDrag, Resistance, RollingResistance, Stribeck, Viscous};
use rimroll::presets::can_2007;
use rimroll::{Body, ContactLaw, FrictionLaw, Options, State, Status};

/// A body with almost no moment of inertia, whose creep under regularised friction relaxes at rates beyond
/// 10⁸/s. Finite-difference Jacobians have errors of 7e-4 there, with which Newton's method converges only in
/// steps below 10⁻⁵ s.
///
/// The expected numbers are a solution of the sliding equations in Euler angles by SciPy's Radau at rtol 1e-9
/// with Jacobians by complex steps.
#[test]
fn creep_with_almost_no_inertia_takes_few_steps() {
    const END: [f64; 6] = [
        2.908_787_098_587_3e-3,
        -0.587_708_769_738_151,
        0.496_674_507_552_128,
        5.245_758_336_337_89,
        0.826_588_222_738_505,
        -5.264_833_386_312_34,
    ];
    let body = Body::new(
        0.002_944_242_252_346_658,
        0.478_818_083_361_459_26,
        3.466_671_753_830_571_6,
        6.589_179_824_933_931e-10,
        1.317_835_945_284_044_8e-9,
    )
    .expect("a rigid body");
    let start = State {
        tilt: 0.137_251_997_966_446_02,
        tilt_rate: -0.582_172_110_469_742_5,
        yaw: 0.471_307_550_140_513_95,
        yaw_rate: 0.002_145_849_745_075_836,
        spin: 0.856_383_022_553_334_4,
        spin_rate: -0.021_575_603_241_007_06,
    };
    let friction = Stribeck {
        friction: 0.573_999_440_366_278_1,
        static_friction: 0.573_999_440_366_278_1,
        stribeck_speed: 0.001_560_410_458_780_138_2,
        creep_speed: 0.000_441_676_303_807_391_74,
    };
    let options = Options {
        duration: 0.23,
        gravity: 1.310_274_272_201_064_3,
        rtol: 1e-8,
        max_steps: 1000,
        ..Options::default()
    };
    let motion = follow(&body, &start, friction, &options);
    assert_eq!(motion.status, Status::Finished);
    for (number, exact) in motion.trajectory.end().state().numbers().iter().zip(END) {
        let error = (number - exact).abs() / exact.abs();
        assert!(error < 1e-7, "{number} is not {exact}");
    }
}

/// Under strong viscous friction the slip relaxes at a rate proportional to the coefficient c, and the motion
/// differs from that without slip by a series in 1/c. Two coefficients give its first term.
#[test]
fn strong_viscous_friction_tends_to_no_slip_in_few_steps() {
    let can = can_2007().expect("a rigid body");
    let start = paper_start(1.0);
    let options = Options {
        max_steps: 500,
        ..tight(0.3)
    };
    let end = |friction: FrictionLaw| {
        let motion = follow(&can, &start, friction, &options);
        assert_eq!(motion.status, Status::Finished);
        motion.trajectory.end().state().numbers()
    };
    let viscous = |coefficient| end(FrictionLaw::Viscous(Viscous { coefficient }));
    // The slip relaxes in about a microsecond.
    let coefficient = 1e6 * can.mass();
    let (one, two) = (viscous(coefficient), viscous(2.0 * coefficient));
    let rolling = end(FrictionLaw::NoSlip);
    for ((one, two), rolling) in one.iter().zip(two).zip(rolling) {
        let first_term = 2.0 * (one - two);
        assert!(first_term.abs() < 1e-3, "{first_term:e}");
        let off = 2.0 * two - one - rolling;
        assert!(off.abs() < 1e-8, "{off:e}, of {first_term:e}");
    }
}

/// The yaw rate below which air drag is smoothed, in units of the axial spin rate and √(g/R): a tenth of the
/// tolerance of a step.
fn smoothing(rtol: f64) -> f64 {
    0.1 * (0.02 * rtol).max(5e-15)
}

/// Drag with an exponent n < 2 is smoothed below the yaw rate ψ̇₀: there its moment about the vertical is
/// −k ψ̇₀ⁿ⁻² ψ̇. Without friction and axial spin it alone changes the angular momentum A sin²φ ψ̇, so that ψ̇
/// sin²φ decays by the factor exp(−k ψ̇₀ⁿ⁻²/A ∫ dt/sin²φ).
#[test]
fn drag_on_a_yaw_rate_below_its_smoothing_makes_it_decay_exponentially() {
    const EXPONENT: f64 = 1.5;
    const DECAY: f64 = 0.5;
    const INTERVALS: u32 = 2000;
    let can = can_2007().expect("a rigid body");
    let falling_rate = (tight(1.0).gravity / can.radius()).sqrt();
    for rtol in [1e-6, 1e-10, 1e-13] {
        let slow = smoothing(rtol) * falling_rate;
        let start = State {
            tilt: 0.3,
            yaw_rate: 1e-6 * slow,
            spin_rate: -1e-6 * slow * libm::cos(0.3),
            ..State::default()
        };
        let coefficient =
            DECAY * falling_rate * can.transverse_inertia() / libm::pow(slow, EXPONENT - 2.0);
        let contact_law = ContactLaw {
            friction: FrictionLaw::Frictionless,
            restitution: 0.0,
            resistance: Resistance {
                air: AirDrag {
                    coefficient,
                    exponent: EXPONENT,
                },
                ..Resistance::default()
            },
        };
        let options = Options {
            rtol,
            ..tight(0.7 / falling_rate)
        };
        let motion = follow(&can, &start, contact_law, &options);
        assert_eq!(motion.status, Status::Finished, "{}", motion.message());
        let end = motion.trajectory.end();
        let dt = end.t / f64::from(INTERVALS);
        let integral: f64 = (0..INTERVALS)
            .map(|i| {
                let sin = motion.trajectory.at((f64::from(i) + 0.5) * dt).sin;
                dt / (sin * sin)
            })
            .sum();
        let expected = DECAY * falling_rate * integral;
        let begin = motion.trajectory.start();
        let decay = libm::log(begin.w * begin.sin / (end.w * end.sin));
        assert!(expected > 3.0);
        assert!((decay / expected - 1.0).abs() < 1e-5, "{decay} {expected}");
    }
}

/// As a body falls almost flat, air drag holds the yaw rate where it balances the gyroscopic moment, far below
/// its smoothing. There explicit steps are stable only within 10⁻¹⁸ s, and within their errors the drag
/// changes so much that friction seems to be exceeded again and again.
#[test]
fn drag_that_stops_the_yaw_of_a_body_falling_flat_takes_few_steps() {
    let body = Body::new(
        1.868_936_177_587_299,
        0.677_178_048_299_017_6,
        0.050_256_878_930_197_875,
        0.648_182_849_199_642,
        1.296_365_698_399_284,
    )
    .expect("a rigid body");
    let start = State {
        tilt: 1.120_911_009_224_417_2e-9,
        tilt_rate: -0.794_896_249_665_043_5,
        yaw_rate: -1.124_509_937_483_565_6,
        spin_rate: 0.172_994_367_343_604_03,
        ..State::default()
    };
    let contact_law = ContactLaw {
        friction: FrictionLaw::coulomb(0.020_887_830_322_665_158),
        restitution: 0.0,
        resistance: Resistance {
            air: AirDrag {
                coefficient: 7.668_425_894_690_515e-5,
                exponent: 1.5,
            },
            ..Resistance::default()
        },
    };
    let options = Options {
        duration: 8.0,
        gravity: 9.80665,
        rtol: 2.577_033_793_680_234e-7,
        max_steps: 500,
        ..Options::default()
    };
    let motion = follow(&body, &start, contact_law, &options);
    assert_eq!(motion.status, Status::FaceDown, "{}", motion.message());
    // In a nanosecond the tilt rate hardly changes.
    let end = motion.trajectory.end();
    let tilt = start.tilt + start.tilt_rate * end.t;
    assert!((end.tilt() - tilt).abs() < 1e-6 * start.tilt);
}

/// Resistance stops the contact point on the rim while the base falls flat so fast that it would leave the table: the
/// resistance, which does not depend on the load, and the rise of the rim hold the normal force in a balance near zero.
/// At large tolerances that force is soon smaller than its error.
#[test]
fn a_balance_of_resistance_and_lift_off_ends_face_down_at_any_tolerance() {
    let body = Body::new(1.0, 1.0, 3.193_080_519_055_307, 0.05, 0.0025).expect("a rigid body");
    let start = State {
        tilt: 0.1,
        tilt_rate: -3.130_495_168_499_705_5,
        yaw_rate: 3.130_495_168_499_705_5,
        ..State::default()
    };
    let law = ContactLaw {
        friction: FrictionLaw::coulomb(0.0),
        restitution: 0.0,
        resistance: Resistance {
            rolling: RollingResistance {
                dry: 0.0,
                viscous: 0.989_949_493_661_166_6,
            },
            ..Resistance::default()
        },
    };
    for rtol in [1e-3, 1e-4, 1e-5] {
        let options = Options {
            rtol,
            gravity: 9.8,
            ..Options::default()
        };
        let motion = follow(&body, &start, law.clone(), &options);
        assert_eq!(motion.status, Status::FaceDown, "{}", motion.message());
        // At a tolerance of 1e-12 it is face down at 0.036 822 318 52 s.
        let t = motion.trajectory.end().t;
        assert!((t - 0.036_822_318_52).abs() < 0.5 * rtol, "{t}");
    }
}
