//! How far a rigid body on a rigid, smooth table is a good model for a turn.

use super::{COLUMNS, Motion, Turn};
use crate::motion::Instant;

/// How far rims and tables depart from a plane, from fine to coarse, m: the general tolerances H and L for the flatness
/// of faces between 30 and 100 mm across (ISO 2768-2). Roughness is smaller.
pub const UNEVENNESS: [f64; 2] = [1e-4, 4e-4];
/// The speed of sound in the material of the body, m/s. In steel, aluminium and glass it is between 5 and 6 km/s.
pub const SPEED_OF_SOUND: f64 = 5000.0;
/// A body moves as one piece only if sound crosses its base this many times while it turns.
const CROSSINGS: f64 = 10.0;
/// Sound, air and bending take at least this part of the kinetic energy of a real can in each turn.
const LOSS: f64 = 0.01;

/// Numbers of a turn to compare with a real body. Between impacts only: the forces of impacts are infinite.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Validity {
    /// Height of the highest point of the rim above its lowest at the smallest tilt, m.
    pub gap: f64,
    /// Speed of the contact point along the rim then, m/s.
    pub contact_speed: f64,
    /// Time from a tenth to nine tenths of the angle of turn, s.
    pub passage_time: f64,
    /// Time in which sound crosses the base, s.
    pub sound_time: f64,
    /// Largest normal force over the weight.
    pub force_ratio: f64,
    /// Energy lost over the largest kinetic energy; 0 for a body that stays at rest.
    pub loss_ratio: f64,
}

impl Validity {
    /// Whether the gap, the contact speed, the passage time and the loss are beyond what the model describes. The force
    /// has no such limit: at how many weights a rim yields depends on the weight, the material and the rounding of its
    /// edge.
    pub fn exceeded(&self) -> [bool; 4] {
        [
            self.gap < UNEVENNESS[1],
            self.contact_speed > SPEED_OF_SOUND,
            self.passage_time < CROSSINGS * self.sound_time,
            self.loss_ratio < LOSS,
        ]
    }
}

impl Motion {
    /// How far the model holds in a turn.
    pub fn validity(&self, turn: &Turn) -> Validity {
        self.validity_between(turn.start, turn.t, turn.end)
    }

    /// As [`Motion::validity`] for a part of the motion from `start` to `end` with its smallest tilt at `lowest`, s.
    pub fn validity_between(&self, start: f64, lowest: f64, end: f64) -> Validity {
        let k = self.contacts.parameters();
        let low = self.trajectory.at(lowest);
        let (mut force, mut kinetic) = (0.0_f64, 0.0_f64);
        for at in self.instants_between(start, end) {
            let moment = self.observables(&at);
            force = force.max(moment[NORMAL_FORCE]);
            kinetic = kinetic.max(moment[KINETIC_ENERGY]);
        }
        let lost = total_loss(&self.trajectory.at(end)) - total_loss(&self.trajectory.at(start));
        Validity {
            gap: 2.0 * k.r * low.u.sin,
            contact_speed: k.r * low.u.state().spin_rate.abs(),
            passage_time: self.passage_time(start, lowest, end),
            sound_time: 2.0 * k.r / SPEED_OF_SOUND,
            force_ratio: force / (k.m * k.g),
            loss_ratio: if kinetic > 0.0 { lost / kinetic } else { 0.0 },
        }
    }

    /// The instants at the steps from `start` to `end` and halfway through each, and those two.
    fn instants_between(&self, start: f64, end: f64) -> impl Iterator<Item = Instant> {
        let ends = [start, end].map(|t| self.trajectory.at(t));
        self.trajectory.samples_in(start..=end, 2).chain(ends)
    }

    /// The time from a tenth to nine tenths of the change of yaw, s. A tenth is reached before the smallest tilt, and
    /// nine tenths after it.
    fn passage_time(&self, start: f64, lowest: f64, end: f64) -> f64 {
        let mut look_up = self.trajectory.look_up();
        let from = look_up.at(start).yaw;
        let angle = look_up.at(end).yaw - from;
        let mut first_time = |part: f64, mut low: f64, mut high: f64| {
            // Each halving gains a bit of the 53 of a time.
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                if (look_up.at(middle).yaw - from) / angle >= part {
                    high = middle;
                } else {
                    low = middle;
                }
            }
            high
        };
        first_time(0.9, lowest, end) - first_time(0.1, start, lowest)
    }
}

const NORMAL_FORCE: usize = column("normal_force");
const KINETIC_ENERGY: usize = column("kinetic_energy");

/// The place of a quantity in [`Observables`](super::Observables).
const fn column(name: &str) -> usize {
    let mut place = 0;
    while !same(COLUMNS[place].as_bytes(), name.as_bytes()) {
        place += 1;
    }
    place
}

const fn same(a: &[u8], b: &[u8]) -> bool {
    let mut place = 0;
    while place < a.len() && place < b.len() && a[place] == b[place] {
        place += 1;
    }
    place == a.len() && place == b.len()
}

fn total_loss(at: &Instant) -> f64 {
    at.u.friction_loss + at.u.resistance_loss + at.u.impact_loss
}
