//! What happens within a step.

use super::pose::{COORDINATES, Pose};
use super::support::{Support, SupportedBody};
use crate::solve::{Dense, bracketed_root};
use core::f64::consts::FRAC_PI_2;

/// Something that happens within a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum StepEvent {
    /// The tilt is largest.
    TiltMax,
    /// The tilt is smallest.
    TiltMin,
    /// This corner touches the table.
    Touch(i64),
    /// The force on the first (0) or second (1) corner of an edge vanishes.
    Release(usize),
    /// The force of the table vanishes.
    LiftOff,
    /// The topple tilt is reached.
    Topple,
}

/// The samples of a step at which signs are compared.
const SAMPLES: usize = 8;

/// The step of a body on a support.
pub(super) struct EventDetector<'a> {
    pub supported: &'a SupportedBody,
    pub dense: &'a Dense<f64, COORDINATES>,
    /// The fraction of the step at which the motion ends.
    pub until: f64,
    pub topple_tilt: f64,
}

impl EventDetector<'_> {
    /// The events in order; the motion goes on after a tilt extremum, other events end its phase.
    pub fn events(&self) -> Vec<(f64, StepEvent)> {
        let poses: Vec<Pose> = (0..=SAMPLES).map(|i| self.pose(self.fraction(i))).collect();
        let mut found = self.tilt_extrema(&poses);
        found.extend(self.topple(&poses));
        found.extend(self.lost_force(&poses));
        for corner in self.candidates(&poses) {
            let touch = self.touch(&poses, corner);
            found.extend(touch.map(|x| (x, StepEvent::Touch(corner))));
        }
        found.sort_by(|a, b| a.0.total_cmp(&b.0));
        if let Some(end) = found.iter().position(|(_, event)| event.ends_phase()) {
            found.truncate(end + 1);
        }
        found
    }

    /// The corners that may touch next: those beside the support; in flight those that are lowest, and those beside them.
    fn candidates(&self, poses: &[Pose]) -> Vec<i64> {
        match self.supported.support {
            Support::Corner(k) | Support::Face(k) => vec![k + 1, k - 1],
            Support::Edge(k) => vec![k + 2, k - 1],
            Support::Flight(_) => {
                let count = i64::from(self.supported.body.corners());
                let mut lowest = *self.supported;
                let (mut from, mut to) = (lowest.support.corner(), lowest.support.corner());
                for at in poses {
                    let before = lowest.support.corner();
                    lowest = lowest.with_lowest(at);
                    let corner = lowest.support.corner();
                    if 8 * (corner - before).abs() > count {
                        // Nearly flat it may have gone round on either side.
                        to = from + count;
                    }
                    (from, to) = (from.min(corner), to.max(corner));
                }
                (from - 1..=(to + 1).min(from + count - 2)).collect()
            }
        }
    }

    fn fraction(&self, i: usize) -> f64 {
        self.until * i as f64 / SAMPLES as f64
    }

    fn pose(&self, x: f64) -> Pose {
        Pose::from_array(&self.dense.at(x))
    }

    fn root(&self, i: usize, function: impl Fn(&Pose) -> f64) -> f64 {
        let value = |x| function(&self.pose(x));
        bracketed_root(self.fraction(i), self.fraction(i + 1), value)
    }

    fn tilt_extrema(&self, poses: &[Pose]) -> Vec<(f64, StepEvent)> {
        let mut found = Vec::new();
        for (i, pair) in poses.windows(2).enumerate() {
            let (from, to) = (pair[0].tilting(), pair[1].tilting());
            let event = match (from, to) {
                (from, to) if from > 0.0 && to <= 0.0 => StepEvent::TiltMax,
                (from, to) if from < 0.0 && to >= 0.0 => StepEvent::TiltMin,
                _ => continue,
            };
            found.push((self.root(i, Pose::tilting), event));
        }
        found
    }

    fn topple(&self, poses: &[Pose]) -> Option<(f64, StepEvent)> {
        // The double next to π/2 stands for π/2. A flat body that rolls on its side does not topple.
        let cos = match self.topple_tilt == FRAC_PI_2 {
            true => 0.0,
            false => libm::cos(self.topple_tilt),
        };
        let upright = |at: &Pose| at.up[2] - cos;
        let i = (0..SAMPLES).find(|&i| upright(&poses[i + 1]) < 0.0)?;
        Some((self.root(i, upright), StepEvent::Topple))
    }

    /// Where the body lifts off, or one end of an edge.
    fn lost_force(&self, poses: &[Pose]) -> Option<(f64, StepEvent)> {
        if self.supported.support.is_flight() {
            return None;
        }
        let weight = self.supported.body.mass() * self.supported.gravity;
        let is_edge = matches!(self.supported.support, Support::Edge(_));
        let normal = |at: &Pose| self.supported.reaction(at).normal;
        let least = |at: &Pose| match normal(at) {
            [first, second] if is_edge => first.min(second),
            [first, _] => first,
        };
        let significant = -1e-12 * weight;
        let forces: Vec<f64> = poses.iter().map(least).collect();
        let x = if forces[0] < significant {
            0.0
        } else {
            let i = (0..SAMPLES).find(|&i| forces[i + 1] < significant)?;
            self.root(i, least)
        };
        let [first, second] = normal(&self.pose(x));
        let equal = (first - second).abs() <= 1e-9 * weight;
        let event = match is_edge && !equal {
            true => StepEvent::Release(usize::from(second < first)),
            false => StepEvent::LiftOff,
        };
        Some((x, event))
    }

    /// Where a corner comes down. One that has just left the table is at the height 0 at first.
    fn touch(&self, poses: &[Pose], corner: i64) -> Option<f64> {
        let gap = |at: &Pose| self.supported.gap(at, corner).0;
        let rate = |at: &Pose| self.supported.gap(at, corner).1;
        let mut is_clear = false;
        for (i, at) in poses.iter().enumerate() {
            let tolerance = touching_gap(self.supported, at);
            let height = gap(at);
            if height > tolerance {
                if is_clear && rate(&poses[i - 1]) < 0.0 && rate(at) > 0.0 {
                    // It may have come down and risen between two samples.
                    let bottom = self.root(i - 1, rate);
                    if gap(&self.pose(bottom)) <= 0.0 {
                        let value = |x| gap(&self.pose(x));
                        return Some(bracketed_root(self.fraction(i - 1), bottom, value));
                    }
                }
                is_clear = true;
            } else if i > 0 && is_clear && height <= 0.0 {
                return Some(self.root(i - 1, gap));
            } else if i > 0 && !is_clear && height < -tolerance {
                // It may have risen and come down between two samples.
                if rate(&poses[i - 1]) <= 0.0 {
                    return Some(self.fraction(i - 1));
                }
                let top = self.root(i - 1, rate);
                let value = |x| gap(&self.pose(x));
                return Some(bracketed_root(top, self.fraction(i), value));
            }
        }
        None
    }
}

impl StepEvent {
    pub fn ends_phase(self) -> bool {
        !matches!(self, StepEvent::TiltMax | StepEvent::TiltMin)
    }
}

/// The height below which a corner counts as touching, m: rounding of the lean, and of a lean of zero.
pub(super) fn touching_gap(supported: &SupportedBody, at: &Pose) -> f64 {
    let radius = supported.body.round().radius();
    // In flight the height of a corner is the difference of two heights.
    let rounding = match supported.support.is_flight() {
        true => 1e-14 * (1.0 + at.height / radius),
        false => 1e-15,
    };
    radius * (1e-11 * at.sin_tilt() + rounding)
}

/// The corners that touch the table: those of the support and those beside them, as far as they touch.
pub(super) fn touching(supported: &SupportedBody, at: &Pose, struck: i64) -> Vec<i64> {
    let count = supported.body.corners() as usize;
    let tolerance = touching_gap(supported, at);
    let touches = |k: i64| k == struck || supported.gap(at, k).0 <= tolerance;
    let mut corners = match supported.support {
        Support::Flight(_) => vec![struck],
        _ => supported.corners(),
    };
    let (mut right, mut left) = (corners[corners.len() - 1], corners[0]);
    while corners.len() < count / 2 + 1 && touches(right + 1) {
        right += 1;
        corners.push(right);
    }
    while corners.len() < count && touches(left - 1) {
        left -= 1;
        corners.push(left);
    }
    corners
}
