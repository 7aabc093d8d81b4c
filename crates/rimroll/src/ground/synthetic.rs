//! Synthetic records: filtered noise with the same bits on every machine.

use super::{Ground, Record};
use crate::error::{InvalidInput, positive};
use core::f64::consts::TAU;

/// Frequency of the high-pass filter over that of the soil.
const SLOW: f64 = 0.1;
const SLOW_DAMPING: f64 = 0.6;
/// The part of the strongest shaking that is left at the end.
const FADED: f64 = 0.05;

/// Numbers from which a record that resembles an earthquake is made.
///
/// Gaussian white noise, independent in each component, under the envelope of P. C. Jennings (it rises as t² in the first
/// tenth of the duration, is constant for three tenths and then decays exponentially to 5 %) passes the filter of K. Kanai
/// and H. Tajimi, a layer of soil on rock, and the high-pass filter of R. W. Clough and J. Penzien, which removes drift.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Synthetic {
    /// The seed of the random numbers.
    pub seed: u64,
    /// The largest acceleration along x, y and z, m/s².
    pub peak: [f64; 3],
    /// The time between two samples, s.
    pub step: f64,
    /// The number of samples, at least 2.
    pub count: usize,
    /// The natural period of the soil, s.
    pub soil_period: f64,
    /// The damping ratio of the soil.
    pub soil_damping: f64,
}

#[cfg(feature = "ground")]
impl Ground {
    /// A synthetic record.
    ///
    /// # Errors
    /// Refuses fewer than two samples, a step, period or damping that is not positive, and a peak beyond 1e9 m/s².
    pub fn synthetic(made_from: &Synthetic) -> Result<Ground, InvalidInput> {
        positive("step", made_from.step, "s")?;
        positive("soil period", made_from.soil_period, "s")?;
        positive("soil damping", made_from.soil_damping, "")?;
        let mut samples = vec![[0.0; 3]; made_from.count];
        for component in 0..3 {
            let shaken = made_from.component(component as u64);
            let largest = shaken.iter().fold(0.0, |most: f64, a| most.max(a.abs()));
            let peak = made_from.peak[component];
            if peak != 0.0 {
                for (sample, a) in samples.iter_mut().zip(shaken) {
                    sample[component] = peak * (a / largest);
                }
            }
        }
        Ok(Ground::of(
            Vec::new(),
            Some(Record::new(made_from.step, samples)?),
        ))
    }
}

impl Synthetic {
    /// The shaking of the soil in one component, before it is scaled to its peak.
    fn component(&self, component: u64) -> Vec<f64> {
        let mut soil = Oscillator::at_rest(self.soil_period, self.soil_damping, self.step);
        let mut slow = Oscillator::at_rest(self.soil_period / SLOW, SLOW_DAMPING, self.step);
        let last = self.count.saturating_sub(1) as f64;
        let sample = |index: usize| {
            let rock =
                normal(self.seed, 3 * index as u64 + component) * envelope(index as f64 / last);
            let surface = rock + soil.relative_acceleration(rock);
            -slow.relative_acceleration(surface)
        };
        (0..self.count).map(sample).collect()
    }
}

/// Jennings' envelope over the part of the duration that has passed.
fn envelope(part: f64) -> f64 {
    if part < 0.1 {
        (part / 0.1) * (part / 0.1)
    } else if part < 0.4 {
        1.0
    } else {
        libm::exp(libm::log(FADED) * (part - 0.4) / 0.6)
    }
}

/// A damped oscillator on a moving base, by Newmark's method of constant average acceleration.
struct Oscillator {
    step: f64,
    /// 2ζω, 1/s.
    damping: f64,
    /// ω², 1/s².
    stiffness: f64,
    displacement: f64,
    velocity: f64,
    acceleration: f64,
}

impl Oscillator {
    fn at_rest(period: f64, damping_ratio: f64, step: f64) -> Oscillator {
        let omega = TAU / period;
        Oscillator {
            step,
            damping: 2.0 * damping_ratio * omega,
            stiffness: omega * omega,
            displacement: 0.0,
            velocity: 0.0,
            acceleration: 0.0,
        }
    }

    /// The acceleration relative to the base one step later, when that of the base is `base`.
    fn relative_acceleration(&mut self, base: f64) -> f64 {
        let half = 0.5 * self.step;
        let velocity = self.velocity + half * self.acceleration;
        let displacement = self.displacement + half * (self.velocity + velocity);
        let force = base + self.damping * velocity + self.stiffness * displacement;
        self.acceleration = -force / (1.0 + half * (self.damping + half * self.stiffness));
        self.velocity = velocity + half * self.acceleration;
        self.displacement = displacement + half * half * self.acceleration;
        self.acceleration
    }
}

/// A random number of the standard normal distribution (G. E. P. Box & M. E. Muller, 1958).
fn normal(seed: u64, index: u64) -> f64 {
    let uniform = |k| ((random_bits(seed, 2 * index + k) >> 11) as f64 + 0.5) / (1u64 << 53) as f64;
    (-2.0 * libm::log(uniform(0))).sqrt() * libm::cos(TAU * uniform(1))
}

/// Random bits by the generator SplitMix64 (G. L. Steele, D. Lea & C. H. Flood, 2014).
pub(crate) fn random_bits(seed: u64, index: u64) -> u64 {
    const INCREMENT: u64 = 0x9e37_79b9_7f4a_7c15;
    let mut z = seed.wrapping_add(INCREMENT.wrapping_mul(index.wrapping_add(1)));
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}
