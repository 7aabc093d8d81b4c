//! A fall in the making.

use crate::law::Parameters;
use crate::motion::{Fall, FallRecord, Status, Turn, direction_at_release};
use crate::state::Coordinates;

/// What is to be remembered of a fall on its way.
#[derive(Debug, Clone)]
pub(super) struct Trial {
    /// Which it is.
    pub index: usize,
    /// Where its turn begins: the release, or a tilt maximum after it.
    pub from: Coordinates<f64>,
    /// Where it was lowest.
    pub lowest: Option<Coordinates<f64>>,
    /// Whether it has risen to a largest tilt after that.
    pub turned: bool,
    /// The sign of the tilt rate, 0 before it has one.
    pub direction: f64,
    /// Steps made.
    pub steps: f64,
    /// Whether the rim has slid.
    pub slid: bool,
    /// Energy lost in slips that are over, J.
    pub friction_loss: f64,
}

impl Trial {
    /// One that begins.
    pub(super) fn new(index: usize, start: &Coordinates<f64>, slid: bool) -> Trial {
        Trial {
            index,
            from: *start,
            lowest: None,
            turned: false,
            direction: direction_at_release(start),
            steps: 0.0,
            slid,
            friction_loss: 0.0,
        }
    }

    /// What has become of it, a body with these parameters.
    pub(super) fn fall(&self, k: &Parameters<f64>, status: Status, end: &Coordinates<f64>) -> Fall {
        let turn = |lowest| Turn::between(&self.from, lowest, end);
        let seen = FallRecord {
            turn: self.lowest.as_ref().map(turn),
            turned: self.turned,
            slid: self.slid,
            // A law that knows no flight ends where it would begin.
            flew: status == Status::LiftedOff,
            steps: self.steps as usize,
        };
        Fall::new(k, status, seen, end)
    }
}
