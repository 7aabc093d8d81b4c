//! Motion of the table: its acceleration as a function of time.
//!
//! The table translates and does not turn. A [`Ground`] is a sum of pulses in closed form and a record that is
//! linear between its samples. Its acceleration is smooth except at corners: the samples of the record, and
//! the beginnings and ends of pulses. The solver ends a step at each corner, and in between follows one
//! stretch, so that its order is not lost. After its end the acceleration is zero. A [`GroundKinematics`] is the velocity and the
//! displacement.
//!
//! Without the crate's feature `ground`, no ground can be made, and what follows moving tables is not compiled.

#![cfg_attr(not(feature = "ground"), allow(dead_code, unused_imports))]

mod kinematics;
mod pulse;
mod record;
mod synthetic;

pub use kinematics::GroundKinematics;
pub use pulse::{Pulse, Shape};
pub use record::Record;
pub use synthetic::Synthetic;
pub(crate) use synthetic::random_bits;

use crate::error::InvalidInput;
use crate::real::Real;
use record::Segment;
use std::sync::Arc;

/// The acceleration of the table along x, y and z, in m/s², as a function of time.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Ground {
    pulses: Vec<Pulse>,
    record: Option<Record>,
    /// The largest horizontal amplitude of a ground that moves along a line except for rounding, m/s²; 0 for any
    /// other.
    straight_peak: f64,
}

/// The part of a [`Ground`] between two corners, continued smoothly beyond them.
#[derive(Debug, Clone)]
pub(crate) struct Stretch {
    ground: Arc<Ground>,
    segment: Option<Segment>,
    /// A time inside this part, which decides which pulses act and which are over.
    begin: f64,
    /// The next corner, s; infinite after the last.
    pub(crate) end: f64,
}

impl Ground {
    /// The sum of pulses.
    ///
    /// # Errors
    /// Names the first field of a pulse that is out of bounds.
    #[cfg(feature = "ground")]
    pub fn pulses(pulses: Vec<Pulse>) -> Result<Ground, InvalidInput> {
        pulses.iter().try_for_each(Pulse::check)?;
        Ok(Ground::of(pulses, None))
    }

    /// Samples of the acceleration (m/s²) along x, y and z at equal intervals of `step` seconds, the first at
    /// t = 0. Between samples the acceleration is linear.
    ///
    /// # Errors
    /// Refuses fewer than two samples, a step that is not positive, and a sample that is not finite or exceeds
    /// 1e9 m/s².
    #[cfg(feature = "ground")]
    pub fn sampled(step: f64, acceleration: Vec<[f64; 3]>) -> Result<Ground, InvalidInput> {
        let record = Record::new(step, acceleration)?;
        Ok(Ground::of(Vec::new(), Some(record)))
    }

    fn of(pulses: Vec<Pulse>, record: Option<Record>) -> Ground {
        let samples = record.as_ref().map_or(&[][..], Record::samples);
        let amplitudes = pulses.iter().map(|pulse| pulse.amplitude);
        let straight_peak = straight_peak(amplitudes.chain(samples.iter().copied()));
        Ground {
            pulses,
            record,
            straight_peak,
        }
    }

    /// The time from which on the acceleration is zero, s.
    pub fn duration(&self) -> f64 {
        let record = self.record.as_ref().map_or(0.0, Record::duration);
        let ends = self.pulses.iter().map(|pulse| pulse.duration);
        ends.fold(record, f64::max)
    }

    /// The acceleration along x, y and z at a time (s), m/s². Where it jumps, the value after the jump.
    pub fn acceleration(&self, t: f64) -> [f64; 3] {
        let segment = self.record.as_ref().and_then(|record| record.segment(t));
        self.sum(segment.as_ref(), t, t)
    }

    /// The shortest time in which a pulse that acts after `t` (s) changes much, s; infinite without pulses.
    pub(crate) fn shortest_period(&self, t: f64) -> f64 {
        let acting = self.pulses.iter().filter(|pulse| pulse.duration > t);
        acting
            .map(|pulse| pulse.shape.period())
            .fold(f64::INFINITY, f64::min)
    }

    /// This ground with all accelerations multiplied by `factor`.
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Ground {
        self.mapped(|a| a.map(|component| factor * component))
    }

    /// This ground turned about the vertical by an angle (rad), from x toward y.
    #[must_use]
    pub fn rotated(&self, angle: f64) -> Ground {
        let (sin, cos) = libm::sincos(angle);
        self.mapped(|[x, y, z]| [x * cos - y * sin, x * sin + y * cos, z])
    }

    /// The sum of this ground and another.
    ///
    /// # Errors
    /// Refuses two records that differ in step or in number of samples.
    pub fn plus(&self, other: &Ground) -> Result<Ground, InvalidInput> {
        let record = match (&self.record, &other.record) {
            (Some(mine), Some(theirs)) => Some(mine.plus(theirs)?),
            (mine, theirs) => mine.as_ref().or(theirs.as_ref()).cloned(),
        };
        let pulses = [&self.pulses[..], &other.pulses].concat();
        Ok(Ground::of(pulses, record))
    }

    /// The pulses, and the record if there is one.
    pub fn parts(&self) -> (&[Pulse], Option<&Record>) {
        (&self.pulses, self.record.as_ref())
    }

    /// The record of a ground without pulses.
    #[cfg(feature = "ground")]
    pub(crate) fn record_alone(&self) -> Option<&Record> {
        self.record.as_ref().filter(|_| self.pulses.is_empty())
    }

    fn mapped(&self, map: impl Fn([f64; 3]) -> [f64; 3] + Copy) -> Ground {
        let pulse = |pulse: &Pulse| Pulse {
            amplitude: map(pulse.amplitude),
            ..*pulse
        };
        let record = self.record.as_ref().map(|record| record.mapped(map));
        Ground::of(self.pulses.iter().map(pulse).collect(), record)
    }

    /// The largest horizontal amplitude of a ground that moves along a line except for rounding, m/s²; 0 for any
    /// other.
    pub(crate) fn straight_peak(&self) -> f64 {
        self.straight_peak
    }

    /// The stretch that contains a time (s) or begins there.
    pub(crate) fn stretch(self: &Arc<Self>, t: f64) -> Stretch {
        let segment = self.record.as_ref().and_then(|record| record.segment(t));
        let next_sample = segment
            .as_ref()
            .map_or(f64::INFINITY, |segment| segment.end);
        let ends = self.pulses.iter().map(|pulse| pulse.duration);
        Stretch {
            ground: Arc::clone(self),
            segment,
            begin: t,
            end: ends.filter(|&end| end > t).fold(next_sample, f64::min),
        }
    }

    /// The acceleration at `t` of the pulses that act at the time `at` and of a segment of the record.
    #[inline(always)]
    fn sum<T: Real>(&self, segment: Option<&Segment>, at: f64, t: T) -> [T; 3] {
        let mut sum = segment.map_or([T::from(0.0); 3], |segment| segment.acceleration(t));
        for pulse in &self.pulses {
            if (0.0..pulse.duration).contains(&at) {
                let shape = pulse.shape.at(t);
                for (sum, &amplitude) in sum.iter_mut().zip(&pulse.amplitude) {
                    *sum = *sum + T::from(amplitude) * shape;
                }
            }
        }
        sum
    }
}

impl Stretch {
    /// The acceleration along x, y and z at a time (s), m/s².
    #[inline(always)]
    pub(crate) fn acceleration<T: Real>(&self, t: T) -> [T; 3] {
        self.ground.sum(self.segment.as_ref(), self.begin, t)
    }

    /// [`Ground::straight_peak`] of the whole ground.
    pub(crate) fn straight_peak(&self) -> f64 {
        self.ground.straight_peak
    }
}

/// The length of the longest of these horizontal vectors if all are parallel except for rounding; otherwise 0.
fn straight_peak(vectors: impl Iterator<Item = [f64; 3]> + Clone) -> f64 {
    const ROUNDING: f64 = 1e-14;
    let square = |[x, y, _]: [f64; 3]| x * x + y * y;
    let longest = |a: &[f64; 3], b: &[f64; 3]| square(*a).total_cmp(&square(*b));
    let Some(longest) = vectors.clone().max_by(longest) else {
        return 0.0;
    };
    let peak = libm::hypot(longest[0], longest[1]);
    let across = |[x, y, _]: [f64; 3]| longest[0] * y - longest[1] * x;
    let mut deviations = vectors.map(|vector| across(vector).abs());
    let is_straight = deviations.all(|deviation| deviation <= ROUNDING * peak * peak);
    if is_straight { peak } else { 0.0 }
}

#[cfg(test)]
mod tests {
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
        assert!(
            x == 0.0 && (y - 1.5 * libm::sin(core::f64::consts::TAU * 1.7 / 0.8)).abs() < 1e-14
        );
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
}
