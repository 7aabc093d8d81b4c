//! Derivatives of motions that change between rolling, sliding and flight, against differences of neighbouring motions and
//! against closed forms.

use crate::given::cases;

use cases::cases;
use core::ops::ControlFlow;
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::TestRunner;
use rimroll::ground::{Ground, Pulse, Shape};
use rimroll::law::{Coulomb, Tabulated, Viscous};
use rimroll::motion::SHAKEN_PARAMETERS;
use rimroll::{Body, ContactLaw, FrictionLaw, Motion, Options, State, simulate_on};
use std::collections::BTreeMap;
use std::sync::Arc;

const PARAMETERS: usize = SHAKEN_PARAMETERS.len();

/// Start, body, gravity and the scale of the ground, in the order of [`SHAKEN_PARAMETERS`].
type Numbers = [f64; PARAMETERS];

const CONTINUE: ControlFlow<()> = ControlFlow::Continue(());

/// What a motion consists of, except for the numbers.
#[derive(Debug, Clone)]
struct Case {
    law: ContactLaw,
    /// `None` for a table at rest.
    ground: Option<Ground>,
    duration: f64,
    numbers: Numbers,
    rtol: f64,
}

impl Case {
    fn motion(&self, numbers: &Numbers) -> Motion {
        let [state @ .., m, r, h, a, c, gravity, scale] = *numbers;
        let options = Options {
            duration: self.duration,
            gravity,
            rtol: self.rtol,
            max_steps: 50_000,
            ..Options::default()
        };
        let ground = self.ground.as_ref().map(|one| Arc::new(one.scaled(scale)));
        let body = Body::new(m, r, h, a, c).expect("a body");
        let start = State::from_numbers(state);
        simulate_on(ground, &body, &start, self.law.clone(), &options, |_| {
            CONTINUE
        })
        .expect("valid input")
    }

    /// The derivatives of the state at a time; those by the scale are zero on a table at rest.
    fn slopes(&self, motion: &Motion, times: &[f64]) -> Vec<[Numbers; 6]> {
        if self.ground.is_some() {
            let found = motion.shaken_sensitivity(|_| CONTINUE);
            let found = found.expect("offered").expect("not stopped");
            return times.iter().map(|&t| found.at(motion, t)).collect();
        }
        let found = motion.sensitivity(|_| CONTINUE);
        let found = found.expect("offered").expect("not stopped");
        let widened = |t: &f64| {
            found
                .at(motion, *t)
                .map(|slope| core::array::from_fn(|i| slope.get(i).copied().unwrap_or(0.0)))
        };
        times.iter().map(widened).collect()
    }
}

/// The size of a parameter's changes that a motion notices about as much as those of the others.
fn size_of(index: usize, numbers: &Numbers) -> f64 {
    let rate = (numbers[11] / numbers[7]).sqrt();
    match index {
        1 | 3 | 5 => 0.1 * rate,
        2 | 4 => 1.0,
        _ => numbers[index],
    }
}

/// The kinds of the events.
fn kinds(motion: &Motion) -> Vec<&'static str> {
    let events = motion.events.iter();
    events.map(|event| event.kind.name()).collect()
}

fn states(motion: &Motion, times: &[f64]) -> Vec<[f64; 6]> {
    let at = |t: &f64| motion.trajectory.at(*t).state().numbers();
    times.iter().map(at).collect()
}

/// Differences by one parameter, extrapolated from three widths, with the change that the last extrapolation made; `None`
/// where neighbouring motions have other events.
fn differences(
    case: &Case,
    index: usize,
    times: &[f64],
    events: &[&str],
) -> Option<Vec<[(f64, f64); 6]>> {
    let width = 1e-4 * size_of(index, &case.numbers);
    let mut slopes = Vec::new();
    for width in [width, 0.5 * width, 0.25 * width] {
        let mut ends = Vec::new();
        for sign in [1.0, -1.0] {
            let mut numbers = case.numbers;
            numbers[index] += sign * width;
            let motion = case.motion(&numbers);
            if kinds(&motion) != events {
                return None;
            }
            ends.push(states(&motion, times));
        }
        let slope = |k: usize, q: usize| (ends[0][k][q] - ends[1][k][q]) / (2.0 * width);
        slopes.push(
            (0..times.len())
                .map(|k| core::array::from_fn(|q| slope(k, q)))
                .collect::<Vec<[f64; 6]>>(),
        );
    }
    let extrapolated = |k: usize, q: usize| {
        let [wide, middle, narrow] = [0, 1, 2].map(|i: usize| slopes[i][k][q]);
        let (better, best) = ((4.0 * middle - wide) / 3.0, (4.0 * narrow - middle) / 3.0);
        let last = (16.0 * best - better) / 15.0;
        (last, (last - best).abs())
    };
    Some(
        (0..times.len())
            .map(|k| core::array::from_fn(|q| extrapolated(k, q)))
            .collect(),
    )
}

/// What a comparison of a motion's derivatives found.
#[derive(Default)]
struct Comparison {
    compared: usize,
    /// Where there is no derivative, or where differences do not converge.
    left_out: usize,
    worst: f64,
    report: String,
}

/// Compares the derivatives at three times.
fn compare(case: &Case) -> Comparison {
    let mut comparison = Comparison::default();
    let motion = case.motion(&case.numbers);
    let end = motion.trajectory.end().t;
    let times = [0.35, 0.7, 0.999].map(|part| part * end);
    let slopes = case.slopes(&motion, &times);
    let events = kinds(&motion);
    let rate = (case.numbers[11] / case.numbers[7]).sqrt();
    for i in 0..PARAMETERS {
        let Some(expected) = differences(case, i, &times, &events) else {
            comparison.left_out += 18;
            continue;
        };
        for (k, quantities) in expected.iter().enumerate() {
            for (q, &(expected, uncertainty)) in quantities.iter().enumerate() {
                let unit = if q % 2 == 1 { rate } else { 1.0 };
                let found = slopes[k][q][i];
                let terms =
                    (0..PARAMETERS).map(|i| (slopes[k][q][i] * size_of(i, &case.numbers)).abs());
                let size = terms.filter(|x| x.is_finite()).fold(0.1 * unit, f64::max);
                let relative = |x: f64| x.abs() * size_of(i, &case.numbers) / size;
                if found.is_nan() || relative(uncertainty) > 1e-7 {
                    comparison.left_out += 1;
                    continue;
                }
                comparison.compared += 1;
                let error = relative(found - expected);
                if error > comparison.worst {
                    comparison.worst = error;
                    comparison.report = format!(
                        "time {k}, quantity {q} by {}: {found} not {expected} ± {uncertainty:e}",
                        SHAKEN_PARAMETERS[i]
                    );
                }
            }
        }
    }
    comparison
}

/// `speed` is a factor on the rates of the start.
fn any_numbers(speed: f64) -> impl Strategy<Value = Numbers> {
    let state = (
        0.1..1.0,
        -2.0..2.0,
        -1.0..1.0,
        -3.0..3.0,
        -1.0..1.0,
        -6.0..6.0,
    );
    let body = (0.5..2.0, 0.05..0.2, 0.3..2.5, 0.2..1.2, 0.2..1.6);
    (state, body).prop_map(move |((tilt, p, yaw, w, spin, s), (m, r, h, a, c))| {
        let a = a * m * r * r * (1.0 + h * h / 3.0);
        [
            tilt,
            speed * p,
            yaw,
            speed * w,
            spin,
            speed * s,
            m,
            r,
            h * r,
            a,
            c * a,
            9.81,
            1.0,
        ]
    })
}

fn any_law() -> impl Strategy<Value = ContactLaw> {
    let table =
        || Tabulated::new(&[0.0, 0.1, 0.4, 2.0], &[0.3, 0.22, 0.2, 0.25], None).expect("a table");
    prop_oneof![
        4 => (0.05..0.6).prop_map(|friction| FrictionLaw::coulomb(friction).into()),
        2 => (0.05..0.6, 1.05..1.5).prop_map(|(friction, ratio)| {
            FrictionLaw::Coulomb(Coulomb { friction, static_friction: ratio * friction }).into()
        }),
        3 => (0.05..0.6, 0.2..0.9).prop_map(|(friction, restitution)| ContactLaw {
            restitution,
            ..FrictionLaw::coulomb(friction).into()
        }),
        1 => Just(FrictionLaw::from(table()).into()),
        1 => (0.1..1.0).prop_map(|coefficient| FrictionLaw::from(Viscous { coefficient }).into()),
    ]
}

/// A table at rest, or one that shakes, vertically with this amplitude (m/s²).
fn any_ground(vertical: f64) -> impl Strategy<Value = Option<Ground>> {
    let pulse = |amplitude, period| Pulse {
        amplitude,
        shape: Shape::Sine { period },
        duration: 5.0,
    };
    let shaking = Ground::pulses(vec![
        pulse([2.0, 1.0, 0.0], 0.4),
        pulse([0.0, 0.0, vertical], 0.23),
    ]);
    prop_oneof![2 => Just(None), 1 => Just(Some(shaking.unwrap()))]
}

fn any_case((speed, vertical): (f64, f64)) -> impl Strategy<Value = Case> {
    let parts = (
        any_numbers(speed),
        any_law(),
        any_ground(vertical),
        0.3..0.8,
    );
    parts.prop_map(|(numbers, law, ground, duration)| Case {
        law,
        ground,
        duration,
        numbers,
        rtol: 1e-13,
    })
}

/// Motions that mostly stay on the table.
const MILD: (f64, f64) = (1.0, 3.0);

/// Motions that leave the table.
const WILD: (f64, f64) = (4.0, 15.0);

/// The error that a derivative may have, relative to the largest change of the value that a parameter makes. Found are
/// errors of up to 4e-9, which are those of the differences.
fn accuracy(law: &FrictionLaw) -> f64 {
    match law {
        FrictionLaw::Coulomb(_) => 1e-7,
        // The rates have kinks, at the points of the table or where the film would lift the rim.
        _ => 1e-6,
    }
}

fn drawn<S: Strategy>(count: u32, strategy: &S) -> Vec<S::Value> {
    let mut runner = TestRunner::new(cases(count));
    let count = cases(count).cases;
    let mut draw = || strategy.new_tree(&mut runner).expect("a case").current();
    (0..count).map(|_| draw()).collect()
}

#[test]
fn the_state_changes_with_each_parameter_as_neighbouring_motions_say() {
    let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
    let mut all = Comparison::default();
    let cases = [drawn(20, &any_case(MILD)), drawn(40, &any_case(WILD))].concat();
    for case in &cases {
        let comparison = compare(case);
        assert!(
            comparison.worst < accuracy(&case.law.friction),
            "{case:?}: {:e}, {}",
            comparison.worst,
            comparison.report
        );
        for kind in kinds(&case.motion(&case.numbers)) {
            *counts.entry(kind).or_default() += 1;
        }
        all.compared += comparison.compared;
        all.left_out += comparison.left_out;
    }
    for kind in ["slip", "stick", "lift_off", "land"] {
        assert!(counts[kind] > 10, "{counts:?}");
    }
    assert!(all.left_out < all.compared / 20, "{}", all.left_out);
}

/// The largest steps that a tolerance allows suit the motion. The derivatives have to be as accurate where they do not suit
/// these: as a slip stops, at the kinks of a friction, and where a resistance fades out.
#[test]
fn derivatives_depend_on_the_tolerance_as_little_as_the_motion() {
    let (mut compared, mut stopped) = (0, 0);
    for case in [drawn(30, &any_case(MILD)), drawn(30, &any_case(WILD))].concat() {
        let fine = case.motion(&case.numbers);
        let rough = Case {
            rtol: 1e-9,
            ..case.clone()
        };
        let roughly = rough.motion(&case.numbers);
        let events = kinds(&fine);
        let end = fine.trajectory.end().t.min(roughly.trajectory.end().t);
        let times = [0.35, 0.7, 0.99].map(|part| part * end);
        let far =
            |(a, b): (&[f64; 6], &[f64; 6])| a.iter().zip(b).any(|(a, b)| (a - b).abs() > 1e-6);
        let (there, here) = (states(&fine, &times), states(&roughly, &times));
        if kinds(&roughly) != events || there.iter().zip(&here).any(far) {
            continue;
        }
        compared += 1;
        stopped += events.iter().filter(|&&kind| kind == "stick").count();
        let (expected, found) = (case.slopes(&fine, &times), rough.slopes(&roughly, &times));
        for (expected, found) in expected.iter().flatten().zip(found.iter().flatten()) {
            let terms = (0..PARAMETERS).map(|i| (expected[i] * size_of(i, &case.numbers)).abs());
            let size = terms.filter(|x| x.is_finite()).fold(0.1, f64::max);
            for i in 0..PARAMETERS {
                let error = (found[i] - expected[i]).abs() * size_of(i, &case.numbers) / size;
                assert!(
                    error < 1e-5 || expected[i].is_nan(),
                    "{}: {} not {} ± {error:e}, {case:?}",
                    SHAKEN_PARAMETERS[i],
                    found[i],
                    expected[i]
                );
            }
        }
    }
    assert!(
        compared > 40 && stopped > 15,
        "{compared} motions, {stopped} stops"
    );
}

/// Coulomb friction is proportional to the normal force. So scaling the mass and all moments of inertia leaves the motion
/// unchanged, and so does scaling all lengths and accelerations.
#[test]
fn derivatives_know_the_units_of_the_parameters() {
    for case in drawn(40, &any_case(WILD)) {
        if !matches!(case.law.friction, FrictionLaw::Coulomb(_)) {
            continue;
        }
        let motion = case.motion(&case.numbers);
        let times = [0.35, 0.7, 0.999].map(|part| part * motion.trajectory.end().t);
        for slope in case.slopes(&motion, &times).as_flattened() {
            let terms: Numbers = core::array::from_fn(|i| slope[i] * case.numbers[i]);
            let [.., m, r, h, a, c, g, scale] = terms;
            let size = terms
                .iter()
                .fold(0.1_f64, |size, term| size.max(term.abs()));
            let (masses, lengths) = (m + a + c, r + h + 2.0 * (a + c) + g + scale);
            assert!(
                masses.abs() < 1e-9 * size,
                "{masses:e} of {size:e}: {case:?}"
            );
            assert!(
                lengths.abs() < 1e-9 * size,
                "{lengths:e} of {size:e}: {case:?}"
            );
        }
    }
}

/// A column slides flat under a rectangular pulse of the acceleration s a and duration T and stops by itself. With
/// v = (s a − μg) T the distance is v T/2 + v²/(2μg).
#[test]
fn a_column_that_slides_flat_has_the_derivatives_of_a_block() {
    let (a, friction, pulse, g) = (2.0, 0.1, 0.5, 9.81);
    let ground = Ground::pulses(vec![Pulse {
        amplitude: [a, 0.0, 0.0],
        shape: Shape::Constant,
        duration: pulse,
    }]);
    let case = Case {
        law: FrictionLaw::coulomb(friction).into(),
        ground: Some(ground.unwrap()),
        duration: 3.0,
        numbers: [
            0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1000.0, 0.5, 2.0, 1400.0, 125.0, g, 1.0,
        ],
        rtol: 1e-13,
    };
    let motion = case.motion(&case.numbers);
    assert_eq!(kinds(&motion), ["slip", "stick"]);
    let found = motion.shaken_sensitivity(|_| CONTINUE).unwrap().unwrap();
    let [x, y] = found.residual_displacement();
    let speed = (a - friction * g) * pulse;
    let per_speed = 0.5 * pulse + speed / (friction * g);
    let by_scale = per_speed * a * pulse;
    let by_gravity = -per_speed * friction * pulse - 0.5 * speed * speed / (friction * g * g);
    assert!((x[12] + by_scale).abs() < 1e-8, "{} {by_scale}", x[12]);
    assert!((x[11] + by_gravity).abs() < 1e-8, "{} {by_gravity}", x[11]);
    // The motion turns with the yaw of the coordinates, so this is a derivative at a fixed direction.
    assert!(x[2].abs() < 1e-12 && y[12].abs() < 1e-12);
}
