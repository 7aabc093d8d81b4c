//! Derivatives of motions, against difference quotients and against identities that follow from dimensional
//! analysis.

use crate::given::motions;

use core::ops::ControlFlow;
use motions::{PAPER_GRAVITY, follow, paper_start, tight};
use rimroll::motion::{PARAMETERS, Sensitivity, Slope};
use rimroll::{Body, FrictionLaw, IdealLaw, Motion, Options, State, presets};

/// The parameters of a motion, in the order of [`PARAMETERS`].
type Numbers = [f64; PARAMETERS.len()];

/// A can that passes the near-collision with rates on which all parameters have an influence.
fn numbers(body: &Body) -> Numbers {
    let (a, c) = (body.transverse_inertia(), body.axial_inertia());
    let [m, r, h] = [body.mass(), body.radius(), body.height()];
    [0.5, -0.4, 0.3, 0.2, -0.1, 0.4, m, r, h, a, c, PAPER_GRAVITY]
}

fn moved(numbers: &Numbers, law: IdealLaw, duration: f64) -> Motion {
    let [
        tilt,
        tilt_rate,
        yaw,
        yaw_rate,
        spin,
        spin_rate,
        m,
        r,
        h,
        a,
        c,
        gravity,
    ] = *numbers;
    let body = Body::new(m, r, h, a, c).expect("a body");
    let start = State {
        tilt,
        tilt_rate,
        yaw,
        yaw_rate,
        spin,
        spin_rate,
    };
    let options = Options {
        gravity,
        ..tight(duration)
    };
    follow(&body, &start, law, &options)
}

const CONTINUE: ControlFlow<()> = ControlFlow::Continue(());

fn derivatives(motion: &Motion) -> Sensitivity {
    let derivatives = motion.sensitivity(|_| CONTINUE);
    derivatives.expect("a smooth motion").expect("not stopped")
}

fn can() -> Body {
    presets::can_2007().expect("the paper's can")
}

/// Central differences of two widths, extrapolated to a relative error of about 1e-8.
fn difference(index: usize, parameters: &Numbers, f: impl Fn(&Numbers) -> f64) -> f64 {
    let width = 1e-3 * parameters[index].abs();
    let slope = |width: f64| {
        let neighbour = |by: f64| {
            let mut numbers = *parameters;
            numbers[index] += by;
            f(&numbers)
        };
        (neighbour(width) - neighbour(-width)) / (2.0 * width)
    };
    let [wide, middle, narrow] = [width, 0.5 * width, 0.25 * width].map(slope);
    let (better, best) = ((4.0 * middle - wide) / 3.0, (4.0 * narrow - middle) / 3.0);
    (16.0 * best - better) / 15.0
}

fn size(slope: &Slope, parameters: &Numbers) -> f64 {
    let terms = slope
        .iter()
        .zip(parameters)
        .map(|(slope, x)| (slope * x).abs());
    terms.fold(0.0, f64::max)
}

/// Before, during and after the near-collision, which is over at 0.3 s, and at the end.
const TIMES: [f64; 4] = [0.1, 0.25, 0.4, 0.9];

#[test]
fn the_state_changes_with_each_parameter_as_neighbouring_motions_say() {
    let parameters = numbers(&can());
    for law in IdealLaw::ALL {
        let motion = moved(&parameters, law, 1.0);
        let sensitivity = derivatives(&motion);
        for t in TIMES {
            let slopes = sensitivity.at(&motion, t);
            for (quantity, slope) in slopes.iter().enumerate() {
                let allowed = 1e-6 * size(slope, &parameters);
                for (i, name) in PARAMETERS.iter().enumerate() {
                    let state = |numbers: &Numbers| {
                        moved(numbers, law, 1.0).trajectory.at(t).state().numbers()[quantity]
                    };
                    let expected = difference(i, &parameters, state);
                    let error = (slope[i] - expected).abs() * parameters[i].abs();
                    assert!(
                        error < allowed,
                        "{law:?} {t} quantity {quantity} by {name}: {} not {expected}",
                        slope[i]
                    );
                }
            }
        }
    }
}

#[test]
fn the_angles_of_turn_change_with_each_parameter_as_neighbouring_motions_say() {
    let parameters = numbers(&can());
    for law in IdealLaw::ALL {
        let motion = moved(&parameters, law, 2.0);
        let sensitivity = derivatives(&motion);
        assert_eq!(sensitivity.turns().len(), motion.turns.len());
        assert!(motion.turns.len() > 1);
        for (k, slope) in sensitivity.turns().iter().enumerate() {
            for (i, name) in PARAMETERS.iter().enumerate() {
                let turn = |numbers: &Numbers| moved(numbers, law, 2.0).turns[k].angle;
                let expected = difference(i, &parameters, turn);
                let error = (slope[i] - expected).abs() * parameters[i].abs();
                assert!(
                    error < 1e-6 * size(slope, &parameters),
                    "{law:?} turn {k} by {name}: {} not {expected}",
                    slope[i]
                );
            }
        }
    }
}

/// A disk passes from face to face over its edge, where the tilt has no extremum.
#[test]
fn turns_of_a_disk_over_its_edge_have_derivatives_too() {
    let disk = presets::disk(0.05).expect("a disk");
    let mut parameters = numbers(&disk);
    (parameters[0], parameters[1]) = (1.2, 5.5);
    let moved = |numbers: &Numbers| moved(numbers, IdealLaw::NoSlip, 0.6);
    let motion = moved(&parameters);
    let kinds: Vec<_> = motion
        .events
        .iter()
        .map(|event| event.kind.name())
        .collect();
    assert_eq!(kinds, ["on_edge", "tilt_max", "on_edge"]);
    let slope = derivatives(&motion).turns()[0];
    // No disk permits a change of its height or of one moment of inertia alone.
    for i in [0, 1, 3, 5, 7, 11] {
        let expected = difference(i, &parameters, |numbers| moved(numbers).turns[0].angle);
        let error = (slope[i] - expected).abs() * parameters[i].abs();
        let name = PARAMETERS[i];
        assert!(
            error < 1e-6 * size(&slope, &parameters),
            "by {name}: {} not {expected}",
            slope[i]
        );
    }
}

/// Scaling the mass and all moments of inertia by two leaves the motion unchanged, and so does scaling all
/// lengths and gravity by two. The initial yaw and spin are only added.
#[test]
fn derivatives_know_the_units_of_the_parameters() {
    let parameters = numbers(&can());
    for law in IdealLaw::ALL {
        let motion = moved(&parameters, law, 1.0);
        let sensitivity = derivatives(&motion);
        let slopes = TIMES.map(|t| sensitivity.at(&motion, t));
        let turns = sensitivity.turns().iter();
        for slope in slopes.iter().flatten().chain(turns) {
            let terms: [f64; 12] = core::array::from_fn(|i| slope[i] * parameters[i]);
            let [.., m, r, h, a, c, g] = terms;
            let rounding = 1e-10 * size(slope, &parameters);
            assert!((m + a + c).abs() < rounding, "{law:?} {slope:?}");
            assert!(
                (r + h + 2.0 * (a + c) + g).abs() < rounding,
                "{law:?} {slope:?}"
            );
        }
        for [_, _, yaw, _, spin, _] in slopes {
            assert_eq!((yaw[2], spin[4], yaw[4], spin[2]), (1.0, 1.0, 0.0, 0.0));
        }
    }
}

#[test]
fn turns_of_a_motion_that_slips_have_derivatives() {
    let moved = |tilt_rate: f64| {
        let start = State {
            tilt_rate,
            ..paper_start(0.05)
        };
        follow(&can(), &start, FrictionLaw::coulomb(0.2), &tight(1.0))
    };
    let (motion, width) = (moved(-0.5), 1e-4);
    assert!(
        motion
            .events
            .iter()
            .any(|event| event.kind.name() == "slip")
    );
    let sensitivity = derivatives(&motion);
    assert!(motion.turns.len() > 1);
    for (k, slope) in sensitivity.turns().iter().enumerate() {
        let [before, after] = [-0.5 - width, -0.5 + width].map(|rate| moved(rate).turns[k].angle);
        let expected = (after - before) / (2.0 * width);
        // The error of the difference is of the order of the square of the width.
        assert!(
            (slope[1] - expected).abs() < 1e-5,
            "turn {k}: {} {expected}",
            slope[1]
        );
    }
}

/// A step with its derivatives takes about 15 µs, so this takes a few milliseconds.
const MAX_STEPS_BETWEEN_REPORTS: usize = 300;

#[test]
fn a_caller_hears_of_the_derivatives_every_few_hundred_steps() {
    let motion = moved(&numbers(&can()), IdealLaw::NoSlip, 60.0);
    let mut times = Vec::new();
    let report = |t| {
        times.push(t);
        CONTINUE
    };
    motion.sensitivity(report).expect("a smooth motion");
    assert!(motion.work.steps > 10 * MAX_STEPS_BETWEEN_REPORTS);
    assert!(times.len() >= motion.work.steps / MAX_STEPS_BETWEEN_REPORTS);
    assert_eq!(times[0], 0.0);
    assert!(times.is_sorted());
    // The turns are differentiated after the last steps.
    assert_eq!(times.last(), Some(&60.0));
}

#[test]
fn a_caller_can_stop_the_derivatives_at_any_report() {
    let motion = moved(&numbers(&can()), IdealLaw::NoSlip, 20.0);
    let mut all = 0;
    let counted = |_| {
        all += 1;
        CONTINUE
    };
    motion.sensitivity(counted).expect("a smooth motion");
    for last in 1..=all {
        let mut reports = 0;
        let stop = |_| {
            reports += 1;
            if reports == last {
                ControlFlow::Break(())
            } else {
                CONTINUE
            }
        };
        let stopped = motion.sensitivity(stop).expect("a smooth motion");
        assert!(stopped.is_none());
        assert_eq!(reports, last);
    }
}
