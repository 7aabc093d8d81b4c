//! The outcome of a release, which depends on how the motion ended and on the tilt before.

use crate::ending::Status;

/// The outcome of a release, through the first turn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Outcome {
    /// The body comes down and rises again to a tilt maximum; a disk can rise to the vertical and beyond.
    Rocked,
    /// The body comes down, rises again and falls over.
    Toppled,
    /// The body falls over without coming down.
    FellBack,
    /// The rim leaves the table, or the normal force would become negative.
    LiftedOff,
    /// The whole rim meets the table at once.
    FaceDown,
    /// The duration ends before the first turn does.
    Hovered,
    /// The energy is spent, and the body lies flat.
    AtRest,
    /// The Painlevé paradox: rigid-body mechanics with this friction has no unique solution.
    Painleve,
    /// The motion could not be computed.
    Failed,
}

/// The history of the tilt before the end.
#[derive(Debug, Clone, Copy)]
pub(crate) struct TiltHistory {
    /// Whether the tilt had a minimum.
    pub came_down: bool,
    /// Whether it had a maximum after that, so that the turn is complete.
    pub turned: bool,
    /// Whether it ended beyond the balance point.
    pub past_balance: bool,
}

impl Outcome {
    /// All outcomes in the order of their codes, `outcome as usize`.
    pub const ALL: [Outcome; 9] = [
        Outcome::Rocked,
        Outcome::Toppled,
        Outcome::FellBack,
        Outcome::LiftedOff,
        Outcome::FaceDown,
        Outcome::Hovered,
        Outcome::AtRest,
        Outcome::Painleve,
        Outcome::Failed,
    ];

    /// The name that the user reads.
    pub fn name(self) -> &'static str {
        match self {
            Outcome::Rocked => "rocked",
            Outcome::Toppled => "toppled",
            Outcome::FellBack => "fell_back",
            Outcome::LiftedOff => "lifted_off",
            Outcome::FaceDown => "face_down",
            Outcome::Hovered => "hovered",
            Outcome::AtRest => "at_rest",
            Outcome::Painleve => "painleve",
            Outcome::Failed => "failed",
        }
    }

    /// The outcome of a motion that ended with this status.
    pub(crate) fn of(status: Status, tilting: TiltHistory) -> Outcome {
        match status {
            Status::Finished if tilting.turned => Outcome::Rocked,
            Status::Finished => Outcome::Hovered,
            Status::Toppled if tilting.came_down => Outcome::Toppled,
            Status::Toppled => Outcome::FellBack,
            Status::LiftedOff => Outcome::lifted_off(tilting.came_down && tilting.past_balance),
            Status::FaceDown => Outcome::FaceDown,
            Status::AtRest => Outcome::AtRest,
            Status::Painleve => Outcome::Painleve,
            Status::Failed | Status::Interrupted => Outcome::Failed,
        }
    }

    /// The outcome of a body whose rim leaves the table. If that happens while it rises beyond its balance
    /// point, it counts as toppled, because it falls over whether or not the rim leaves the table.
    pub fn lifted_off(rises_past_balance: bool) -> Outcome {
        if rises_past_balance {
            Outcome::Toppled
        } else {
            Outcome::LiftedOff
        }
    }

    /// Whether the motion was cut short, so that its turn has no end.
    pub(crate) fn is_cut_short(self) -> bool {
        matches!(self, Outcome::Hovered | Outcome::Failed)
    }
}

#[cfg(test)]
mod tests {
    use super::Outcome;

    #[test]
    fn codes_are_indices_into_the_list() {
        for (index, outcome) in Outcome::ALL.into_iter().enumerate() {
            assert_eq!(outcome as usize, index);
        }
    }
}
