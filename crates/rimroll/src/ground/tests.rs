//! Tests of the table's acceleration.

use super::{Ground, Pulse, Shape};
use std::sync::Arc;

fn record() -> Ground {
    let samples = vec![[0.0, 1.0, -2.0], [3.0, 1.0, 4.0], [-1.0, 0.5, 0.0]];
    Ground::sampled(0.1, samples).unwrap()
}

fn sine() -> Ground {
    let pulse = |amplitude, period, cycles: f64| Pulse {
        amplitude,
        shape: Shape::Sine { period },
        duration: cycles * period,
    };
    Ground::pulses(vec![
        pulse([3.0, 0.0, 0.0], 1.2, 1.0),
        pulse([0.0, 1.5, 0.0], 0.8, 2.0),
    ])
    .unwrap()
}

#[test]
fn a_record_is_linear_between_samples_and_then_at_rest() {
    let ground = record();
    let close = |t: f64, expected: [f64; 3]| {
        for (a, b) in ground.acceleration(t).into_iter().zip(expected) {
            assert!((a - b).abs() < 1e-14, "at {t} s: {a} and {b}");
        }
    };
    close(0.0, [0.0, 1.0, -2.0]);
    close(0.025, [0.75, 1.0, -0.5]);
    close(0.1, [3.0, 1.0, 4.0]);
    close(0.15, [1.0, 0.75, 2.0]);
    close(0.2, [0.0; 3]);
    close(7.0, [0.0; 3]);
    close(-1.0, [0.0; 3]);
    assert_eq!(ground.duration(), 0.2);
}

/// The quotient of a time and the step is not always the number of the sample.
#[test]
fn the_corners_of_a_record_follow_each_other() {
    for step in [0.005, 0.01, 0.02, 1.0 / 3.0, 0.1] {
        let samples = (0..5000).map(|i| [f64::from(i), 0.0, 0.0]).collect();
        let ground = Arc::new(Ground::sampled(step, samples).unwrap());
        let mut t = 0.0;
        for i in 1..5000 {
            let stretch = ground.stretch(t);
            assert_eq!(stretch.end, f64::from(i) * step);
            t = stretch.end;
        }
        assert_eq!(ground.stretch(t).end, f64::INFINITY);
    }
}

#[test]
fn pulses_end_one_after_another() {
    let ground = Arc::new(sine());
    assert_eq!(ground.duration(), 1.6);
    assert_eq!(ground.stretch(0.0).end, 1.2);
    let last = ground.stretch(1.2);
    assert_eq!(last.end, 1.6);
    assert_eq!(last.acceleration(1.5)[0], 0.0);
    // A stretch continues smoothly beyond its end.
    let [x, y, _] = last.acceleration(1.7);
    assert!(x == 0.0 && (y - 1.5 * libm::sin(core::f64::consts::TAU * 1.7 / 0.8)).abs() < 1e-14);
    assert_eq!(ground.acceleration(1.7), [0.0; 3]);
}

#[test]
fn a_turned_and_scaled_ground_has_turned_and_scaled_accelerations() {
    for ground in [record(), sine()] {
        let changed = ground.rotated(0.7).scaled(-2.0);
        for t in [0.0, 0.03, 0.11, 0.9, 1.5] {
            let [x, y, z] = ground.acceleration(t);
            let (sin, cos) = libm::sincos(0.7);
            let expected = [x * cos - y * sin, x * sin + y * cos, z].map(|a| -2.0 * a);
            for (a, b) in changed.acceleration(t).into_iter().zip(expected) {
                assert!((a - b).abs() < 1e-14);
            }
        }
    }
}

#[test]
fn grounds_add_up() {
    let [record, sine] = [record(), sine()];
    let sum = record.plus(&sine).unwrap().plus(&record).unwrap();
    for t in [-0.1, 0.0, 0.03, 0.11, 0.9, 1.5, 1.7] {
        let [a, b] = [record.acceleration(t), sine.acceleration(t)];
        for (i, total) in sum.acceleration(t).into_iter().enumerate() {
            assert!((total - 2.0 * a[i] - b[i]).abs() < 1e-14);
        }
    }
    let refused = |step, count| {
        let other = Ground::sampled(step, vec![[0.0; 3]; count]).unwrap();
        record.plus(&other).unwrap_err().to_string()
    };
    assert!(refused(0.2, 3).contains("step"));
    assert!(refused(0.1, 4).contains("samples"));
}

#[test]
fn before_it_begins_a_ground_is_at_rest() {
    for ground in [record(), sine()] {
        assert_eq!(ground.acceleration(-0.01), [0.0; 3]);
    }
}

#[test]
fn a_ricker_wavelet_has_no_net_velocity() {
    let shape = Shape::Ricker {
        period: 0.5,
        center: 1.0,
    };
    let pulse = Pulse {
        amplitude: [2.0, 0.0, 0.0],
        shape,
        duration: 2.0,
    };
    let ground = Ground::pulses(vec![pulse]).unwrap();
    assert_eq!(ground.acceleration(1.0)[0], 2.0);
    let sum: f64 = (0..2000)
        .map(|i| ground.acceleration(0.001 * f64::from(i))[0])
        .sum();
    assert!((0.001 * sum).abs() < 1e-12, "{sum:e}");
}

#[test]
fn grounds_that_are_none_are_refused() {
    let message = |ground: Result<Ground, crate::InvalidInput>| ground.unwrap_err().to_string();
    assert!(message(Ground::sampled(0.0, vec![[0.0; 3]])).contains("step"));
    assert!(message(Ground::sampled(0.1, vec![[0.0; 3]])).contains("at least 2 samples"));
    let spike = vec![[0.0; 3], [f64::NAN, 0.0, 0.0]];
    assert!(message(Ground::sampled(0.1, spike)).contains("acceleration[1]"));
    let endless = Pulse {
        amplitude: [1.0; 3],
        shape: Shape::Sine { period: 0.0 },
        duration: 1.0,
    };
    assert!(message(Ground::pulses(vec![endless])).contains("period"));
}
