//! A fall in progress.

use crate::law::Parameters;
use crate::motion::{Fall, FallRecord, Status, Turn, direction_at_release};
use crate::state::Coordinates;

/// The facts about a fall in progress from which its result is made.
#[derive(Debug, Clone)]
pub(super) struct ActiveFall {
    /// The index of its setup in the chunk.
    pub index: usize,
    /// The beginning of the turn: the release, or a tilt maximum after it.
    pub from: Coordinates<f64>,
    /// The tilt minimum, once it is reached.
    pub lowest: Option<Coordinates<f64>>,
    /// Whether a tilt maximum after the minimum is reached.
    pub turned: bool,
    /// The sign of the tilt rate, or 0 while the sign is not significant.
    pub direction: f64,
    /// The number of accepted steps.
    pub steps: f64,
    /// Whether the rim has slid.
    pub slid: bool,
    /// Energy lost in slips that have ended, J.
    pub friction_loss: f64,
}

impl ActiveFall {
    pub(super) fn new(index: usize, start: &Coordinates<f64>, slid: bool) -> ActiveFall {
        ActiveFall {
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

    /// The result of the fall, which ended with `status` at `end`.
    pub(super) fn result(
        &self,
        k: &Parameters<f64>,
        status: Status,
        end: &Coordinates<f64>,
    ) -> Fall {
        let turn = |lowest| Turn::between(&self.from, lowest, end);
        let record = FallRecord {
            turn: self.lowest.as_ref().map(turn),
            turned: self.turned,
            slid: self.slid,
            // Under a law without flight the fall ends where flight would begin.
            flew: status == Status::LiftedOff,
            steps: self.steps as usize,
        };
        Fall::new(k, status, record, end)
    }
}
