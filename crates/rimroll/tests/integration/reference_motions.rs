//! Motions of the paper's can that were also computed independently from the printed equations of motion, in
//! quadruple precision where more than ten digits are needed.

use crate::given::motions;

use motions::{PAPER_GRAVITY, follow, paper_start, tight};
use rimroll::motion::Turn;
use rimroll::turn::{NearCollision, error_law, error_law_coefficient, turn_limit};
use rimroll::{Body, IdealLaw, Motion, Options, State, presets};

/// The numbers of the paper's simulation figure as an independent integration prints them. The test rounds
/// the results to the same digits.
struct Figure {
    near_collision_time: &'static str,
    min_tilt: &'static str,
    yaw_rate: &'static str,
    /// Tilt maximum to tilt maximum, deg.
    turn: &'static str,
    /// Release to first tilt maximum, deg.
    first_turn: &'static str,
    rocking_period: &'static str,
    max_tilt: &'static str,
    friction_ratio: &'static str,
    normal_force: &'static str,
}

const NO_SLIP: Figure = Figure {
    near_collision_time: "0.24308731",
    min_tilt: "1.83292507e-4",
    yaw_rate: "3.111697e4",
    turn: "202.67510452",
    first_turn: "202.6546207673",
    rocking_period: "0.63365199",
    max_tilt: "0.54149376",
    friction_ratio: "0.354996",
    normal_force: "502.0",
};

const FRICTIONLESS: Figure = Figure {
    near_collision_time: "0.17648604",
    min_tilt: "9.65920625e-5",
    yaw_rate: "8.174367e4",
    turn: "221.16124707",
    first_turn: "221.1530871944",
    rocking_period: "0.41047835",
    max_tilt: "0.53071394",
    friction_ratio: "0.000000",
    normal_force: "1529.4",
};

fn figure(law: IdealLaw) -> Figure {
    match law {
        IdealLaw::NoSlip => NO_SLIP,
        IdealLaw::Frictionless => FRICTIONLESS,
    }
}

fn can() -> Body {
    presets::can_2007().expect("the paper's can")
}

fn paper_motion(law: IdealLaw, rtol: f64) -> Motion {
    let options = Options { rtol, ..tight(2.0) };
    follow(&can(), &paper_start(0.005), law, &options)
}

fn first_two_turns(motion: &Motion) -> (Turn, Turn) {
    (motion.turns[0], motion.turns[1])
}

#[test]
fn the_simulation_figure_is_reproduced_to_the_digits_printed() {
    for law in IdealLaw::ALL {
        let expected = figure(law);
        let (first, second) = first_two_turns(&paper_motion(law, 1e-12));
        assert_eq!(format!("{:.8}", first.t), expected.near_collision_time);
        assert_eq!(format!("{:.8e}", first.min_tilt), expected.min_tilt);
        assert_eq!(format!("{:.6e}", first.yaw_rate), expected.yaw_rate);
        assert_eq!(format!("{:.8}", second.angle.to_degrees()), expected.turn);
        assert_eq!(
            format!("{:.10}", first.angle.to_degrees()),
            expected.first_turn
        );
        assert_eq!(
            format!("{:.8}", second.end - second.start),
            expected.rocking_period
        );
        assert_eq!(format!("{:.8}", first.max_tilt), expected.max_tilt);
    }
}

/// The paper notes "only a finite coefficient" of friction and large normal forces. The peaks are smooth
/// maxima over the motion; with 50 samples per step their error is below the last printed digit.
#[test]
fn friction_stays_finite_while_the_normal_force_peaks_in_the_near_collision() {
    for law in IdealLaw::ALL {
        let motion = paper_motion(law, 1e-12);
        let (mut ratio, mut normal) = (0.0_f64, 0.0_f64);
        for u in motion.trajectory.samples(50) {
            let contact = motion.dynamics(&u).contact(&u);
            ratio = ratio.max(libm::hypot(contact.along, contact.across) / contact.normal);
            normal = normal.max(contact.normal / u.sin);
        }
        assert_eq!(format!("{ratio:.6}"), figure(law).friction_ratio);
        assert_eq!(format!("{normal:.1}"), figure(law).normal_force);
    }
}

/// The default tolerance, 1e-10, is meant for tens of rocking motions; over the first two an error of 1e-9 is
/// ample.
#[test]
fn the_default_tolerance_gives_nine_digits() {
    let default = Options::default().rtol;
    for law in IdealLaw::ALL {
        let (first, second) = first_two_turns(&paper_motion(law, default));
        let (fine_first, fine_second) = first_two_turns(&paper_motion(law, 1e-13));
        for (turn, fine) in [(first, fine_first), (second, fine_second)] {
            for (value, exact) in [
                (turn.angle, fine.angle),
                (turn.min_tilt, fine.min_tilt),
                (turn.t, fine.t),
                (turn.yaw_rate, fine.yaw_rate),
                (turn.end, fine.end),
                (turn.max_tilt, fine.max_tilt),
            ] {
                assert!(
                    (value / exact - 1.0).abs() < 1e-9,
                    "{law:?} {value} {exact}"
                );
            }
        }
    }
}

/// 60 starts of the can whose turns are known to 20 digits: they were integrated in 128-bit arithmetic from
/// the printed equations, extrapolated, and confirmed by a Taylor integration of reduced equations.
///
/// The turn of 3.5 rad is a sum over some 200 steps, so 1e-12 rad allows for rounding. The error of the
/// smallest tilt is relative to its own size. The maximum is located where φ̇ = 0, to 1e-12 s.
#[test]
fn sixty_turns_of_the_can_agree_with_128_bit_arithmetic() {
    let table = include_str!("given/turns_of_the_can.csv");
    let rows = table
        .lines()
        .skip_while(|line| line.starts_with('#'))
        .skip(1);
    let mut count = 0;
    for row in rows {
        let field: Vec<f64> = row
            .split(',')
            .map(|x| x.parse().expect("a number"))
            .collect();
        let start = State {
            tilt: field[0],
            tilt_rate: field[1],
            yaw_rate: field[2],
            spin_rate: field[3],
            ..State::default()
        };
        for (law, expected) in [
            (IdealLaw::NoSlip, &field[4..7]),
            (IdealLaw::Frictionless, &field[7..10]),
        ] {
            let motion = follow(&can(), &start, law, &tight(expected[2] + 0.01));
            let turn = motion.turns[0];
            assert!(
                (turn.angle - expected[0]).abs() < 1e-12,
                "{law:?} {row}: {turn:?}"
            );
            assert!(
                (turn.min_tilt / expected[1] - 1.0).abs() < 1e-11,
                "{law:?} {row}: {turn:?}"
            );
            assert!(
                (turn.end - expected[2]).abs() < 1e-12,
                "{law:?} {row}: {turn:?}"
            );
        }
        count += 1;
    }
    assert_eq!(count, 60);
}

/// The difference between |Δψ|, from tilt maximum to tilt maximum, and its limit, rad; and φ_c.
fn excess(body: &Body, law: IdealLaw, sideways: f64) -> (f64, f64) {
    let motion = follow(body, &paper_start(sideways), law, &tight(1.5));
    let turn = motion.turns[1];
    (turn.angle.abs() - turn_limit(body, law), turn.min_tilt)
}

/// Turn minus limit in rad for ψ̇ = θ̇ = 0.1, 0.01, … rad/s, by an independent integration. The test asks for
/// its six digits plus 3e-12 rad, because that integration was done in Euler angles, whose rounding errors
/// grow like 1/φ_c and reached this size at ψ̇ = 1e-7.
#[test]
fn turns_of_the_can_converge_as_tabulated() {
    const NO_SLIP: [f64; 8] = [
        1.05839e-1, 1.28566e-2, 1.51289e-3, 1.74012e-4, 1.96736e-5, 2.19460e-6, 2.42184e-7,
        2.64909e-8,
    ];
    const FRICTIONLESS: [f64; 8] = [
        5.13251e-2, 6.34129e-3, 7.55019e-4, 8.75911e-5, 9.96802e-6, 1.11769e-6, 1.23861e-7,
        1.35954e-8,
    ];
    converges_as_tabulated(&can(), IdealLaw::NoSlip, &NO_SLIP);
    converges_as_tabulated(&can(), IdealLaw::Frictionless, &FRICTIONLESS);
}

/// A uniform disk and a ring of the can's radius come closer to the table than the can. The errors of
/// the Euler angles are 1e-12 rad at 1e-7 and 2e-11 rad at 1e-8, so there the error law replaces them.
#[test]
fn turns_of_disk_and_ring_converge_as_tabulated() {
    const DISK: [f64; 6] = [
        -7.03353e-3,
        2.41535e-4,
        1.16853e-4,
        2.09343e-5,
        3.01809e-6,
        3.94273e-7,
    ];
    const RING: [f64; 6] = [
        -7.64852e-3,
        2.49939e-4,
        1.26466e-4,
        2.27937e-5,
        3.29409e-6,
        4.30882e-7,
    ];
    let disk = presets::disk(0.051).expect("a disk");
    let ring = presets::ring(0.051).expect("a ring");
    converges_as_tabulated(&disk, IdealLaw::NoSlip, &DISK);
    converges_as_tabulated(&ring, IdealLaw::Frictionless, &RING);
}

fn converges_as_tabulated(body: &Body, law: IdealLaw, tabulated: &[f64]) {
    let mut sideways = 1.0;
    for &expected in tabulated {
        sideways /= 10.0;
        let (excess, _) = excess(body, law, sideways);
        let last_digit = 1e-5 * libm::pow(10.0, libm::floor(libm::log10(expected.abs())));
        assert!(
            (excess - expected).abs() < 0.5 * last_digit + 3e-12,
            "{law:?} {sideways:e}: {excess:e}, tabulated {expected:e}"
        );
    }
}

/// Down to ε = 1e-12 the turn obeys φ_c (b ln φ_c + a), with a taken from the start with ε = 1e-6, where the
/// next term of the law, of order φ_c² ln² φ_c, is below 1e-14 rad. The tolerance of 1e-13 rad allows for the
/// rounding of turns from 3.5 rad (can) to 7 rad (disk).
#[test]
fn the_turn_follows_the_error_law_down_to_starts_of_1e_12() {
    let disk = presets::disk(0.051).expect("a disk");
    let ring = presets::ring(0.051).expect("a ring");
    for law in IdealLaw::ALL {
        for body in [can(), disk, ring] {
            let b = b_of_paper_start(&body, law);
            let (known, tilt) = excess(&body, law, 1e-6);
            let a = known / tilt - b * libm::log(tilt);
            for sideways in [1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12] {
                let (excess, min_tilt) = excess(&body, law, sideways);
                let expected = error_law(min_tilt, b, a).expect("a tilt");
                assert!(
                    (excess - expected).abs() < 1e-13,
                    "{law:?} {body:?} {sideways:e}: {excess:e} instead of {expected:e}"
                );
            }
        }
    }
}

/// b, with the tipping rate on arrival from the near-collision itself: ψ̇ = ω √(J′/K′)/φ_c at the smallest
/// tilt.
fn b_of_paper_start(body: &Body, law: IdealLaw) -> f64 {
    let start = paper_start(1e-12);
    let motion = follow(body, &start, law, &tight(1.0));
    let turn = motion.turns[0];
    let stretch = NearCollision::new(body, law, 1.0, 1.0, 1.0)
        .expect("valid")
        .stretch;
    let tipping_rate = turn.yaw_rate.abs() * turn.min_tilt / stretch;
    error_law_coefficient(body, law, tipping_rate, PAPER_GRAVITY).expect("valid")
}

/// A stiff solver of the printed equations needs more and more steps as ε decreases. Here each decade of ε
/// has the same cost, since the range of τ grows like ln(1/φ_c).
#[test]
fn steps_grow_no_faster_than_the_logarithm_of_the_near_collision() {
    for law in IdealLaw::ALL {
        let steps = |sideways: f64| {
            let motion = follow(&can(), &paper_start(sideways), law, &tight(0.4));
            motion.work.steps as f64
        };
        let (at_3, at_6, at_9, at_12) = (steps(1e-3), steps(1e-6), steps(1e-9), steps(1e-12));
        let per_decade = (at_6 - at_3) / 3.0;
        assert!(per_decade < 60.0);
        assert!(at_9 - at_6 < 3.3 * per_decade && at_12 - at_9 < 3.3 * per_decade);
    }
}
