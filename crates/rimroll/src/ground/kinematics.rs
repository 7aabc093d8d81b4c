//! Velocity and displacement of the table, the integrals of its acceleration.

use super::Ground;
use super::record::Record;

/// How the table moves: its velocity and displacement as functions of time, from rest in its place at t = 0.
///
/// Pulses are integrated in closed form. For a record, whose acceleration is linear between samples, the integrals at all
/// samples are computed once. After the ground's end the velocity is constant. It is not zero unless the acceleration
/// has no net impulse, as in records whose baseline has drifted.
#[derive(Debug, Clone)]
pub struct GroundKinematics<'a> {
    ground: &'a Ground,
    /// Velocity (m/s) and displacement (m) at the samples of the record.
    at_samples: Vec<[[f64; 3]; 2]>,
}

impl Ground {
    /// The velocity and the displacement of the table. This takes a time in proportion to the number of samples.
    pub fn kinematics(&self) -> GroundKinematics<'_> {
        let at_samples = self.record.as_ref().map_or_else(Vec::new, integrated);
        GroundKinematics {
            ground: self,
            at_samples,
        }
    }
}

/// Velocity and displacement at each sample.
fn integrated(record: &Record) -> Vec<[[f64; 3]; 2]> {
    let mut all = Vec::with_capacity(record.samples().len());
    let mut last = [[0.0; 3]; 2];
    all.push(last);
    for index in 1..record.samples().len() {
        last = after(record, index - 1, last, record.time(index));
        all.push(last);
    }
    all
}

/// Velocity and displacement at a time t inside the segment that follows a sample, from those at the sample.
fn after(record: &Record, index: usize, from: [[f64; 3]; 2], t: f64) -> [[f64; 3]; 2] {
    let elapsed = t - record.time(index);
    let Some(segment) = record.segment_after(index) else {
        let moved = |i: usize| from[1][i] + from[0][i] * elapsed;
        return [from[0], core::array::from_fn(moved)];
    };
    let (value, slope) = (segment.value, segment.slope);
    [
        core::array::from_fn(|i| from[0][i] + (value[i] + 0.5 * slope[i] * elapsed) * elapsed),
        core::array::from_fn(|i| {
            from[1][i]
                + (from[0][i] + (0.5 * value[i] + slope[i] * elapsed / 6.0) * elapsed) * elapsed
        }),
    ]
}

impl GroundKinematics<'_> {
    /// The velocity along x, y and z at a time (s), m/s; zero before t = 0.
    pub fn velocity(&self, t: f64) -> [f64; 3] {
        self.at(t)[0]
    }

    /// The displacement along x, y and z since t = 0 at a time (s), m; zero before t = 0.
    pub fn displacement(&self, t: f64) -> [f64; 3] {
        self.at(t)[1]
    }

    fn at(&self, t: f64) -> [[f64; 3]; 2] {
        if t <= 0.0 {
            return [[0.0; 3]; 2];
        }
        let mut sum = match &self.ground.record {
            Some(record) => {
                let index = record.sample_before(t);
                after(record, index, self.at_samples[index], t)
            }
            None => [[0.0; 3]; 2],
        };
        for pulse in &self.ground.pulses {
            let integrals = pulse.integrals(t);
            for (sum, integral) in sum.iter_mut().zip(integrals) {
                for (sum, &amplitude) in sum.iter_mut().zip(&pulse.amplitude) {
                    *sum += amplitude * integral;
                }
            }
        }
        sum
    }
}

/// Velocities and displacements against quadrature of the acceleration.
#[cfg(test)]
mod tests {
    use crate::ground::{Ground, Pulse, Shape};

    fn record() -> Ground {
        let samples = vec![
            [0.0, 1.0, -2.0],
            [3.0, 1.0, 4.0],
            [-1.0, 0.5, 0.0],
            [-2.0, -4.0, 1.5],
        ];
        Ground::sampled(0.1, samples).unwrap()
    }

    fn pulses() -> Ground {
        let shapes = [
            (Shape::Constant, 0.9),
            (Shape::Sine { period: 0.7 }, 1.0),
            (Shape::Cosine { period: 1.1 }, 1.3),
            (
                Shape::Ricker {
                    period: 0.6,
                    center: 0.4,
                },
                1.6,
            ),
        ];
        let each = shapes.into_iter().zip([
            [1.0, -0.5, 0.3],
            [-2.0, 0.7, 0.0],
            [0.2, 1.1, -0.9],
            [1.5, -1.2, 2.0],
        ]);
        let pulse = |((shape, duration), amplitude)| Pulse {
            amplitude,
            shape,
            duration,
        };
        Ground::pulses(each.map(pulse).collect()).unwrap()
    }

    /// Gauss-Legendre quadrature with three points between the corners of the ground, in 512 parts.
    /// The displacement is the integral of (t - s) a(s).
    fn by_quadrature(ground: &Ground, t: f64) -> [[f64; 3]; 2] {
        let mut corners = vec![0.0, 0.9, 1.0, 1.3, 1.6, t];
        corners.extend((0..4).map(|index| f64::from(index) * 0.1));
        corners.retain(|&corner| corner <= t);
        corners.sort_by(f64::total_cmp);
        let mut sum = [[0.0; 3]; 2];
        for ends in corners.windows(2) {
            let half = 0.5 * (ends[1] - ends[0]) / 512.0;
            for part in 0..512 {
                let middle = ends[0] + f64::from(2 * part + 1) * half;
                for (node, weight) in [(-0.6, 5.0), (0.0, 8.0), (0.6, 5.0)] {
                    let at = middle + half * f64::signum(node) * f64::abs(node).sqrt();
                    let acceleration = ground.acceleration(at);
                    for i in 0..3 {
                        let share = weight / 9.0 * half * acceleration[i];
                        sum[0][i] += share;
                        sum[1][i] += share * (t - at);
                    }
                }
            }
        }
        sum
    }

    #[test]
    fn velocity_and_displacement_are_integrals_of_the_acceleration() {
        let both = record().plus(&pulses()).unwrap();
        for ground in [record(), pulses(), both] {
            let kinematics = ground.kinematics();
            for t in [0.0, 0.03, 0.1, 0.25, 0.3, 0.31, 0.95, 1.2, 1.6, 4.0] {
                let expected = by_quadrature(&ground, t);
                let found = [kinematics.velocity(t), kinematics.displacement(t)];
                for (found, expected) in found.iter().flatten().zip(expected.iter().flatten()) {
                    assert!((found - expected).abs() < 1e-12, "at {t} s: {found}");
                }
            }
        }
    }

    #[test]
    fn a_table_rests_before_it_begins_and_coasts_after_its_end() {
        for ground in [record(), pulses()] {
            let kinematics = ground.kinematics();
            assert_eq!(kinematics.velocity(-0.1), [0.0; 3]);
            assert_eq!(kinematics.displacement(-0.1), [0.0; 3]);
            let end = ground.duration();
            let last = kinematics.velocity(end);
            assert!(last[0] != 0.0);
            assert_eq!(kinematics.velocity(end + 2.0), last);
            let [before, after] = [end, end + 2.0].map(|t| kinematics.displacement(t));
            for ((before, after), speed) in before.iter().zip(after).zip(last) {
                assert!((after - before - 2.0 * speed).abs() < 1e-14);
            }
        }
    }

    /// A sine of one cycle moves the table by a T²/2π and leaves it at rest.
    #[test]
    fn a_cycle_of_a_sine_moves_the_table_by_a_period_squared_over_two_pi() {
        let pulse = Pulse {
            amplitude: [3.0, 0.0, 0.0],
            shape: Shape::Sine { period: 1.2 },
            duration: 1.2,
        };
        let ground = Ground::pulses(vec![pulse]).unwrap();
        let kinematics = ground.kinematics();
        let expected = 3.0 * 1.2 * 1.2 / core::f64::consts::TAU;
        assert!((kinematics.displacement(5.0)[0] - expected).abs() < 1e-14);
        assert!(kinematics.velocity(5.0)[0].abs() < 1e-15);
    }
}
