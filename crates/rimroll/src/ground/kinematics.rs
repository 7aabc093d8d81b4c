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

#[cfg(test)]
mod tests;
