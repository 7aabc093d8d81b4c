//! What became of a body let go: how the motion ended, and what the tilt did before.

use super::Status;

/// What became of a body let go, through its first turn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Outcome {
    /// It comes down and rises again to a largest tilt; a disk may rise to the vertical, and past it.
    Rocked,
    /// It comes down, rises again and falls over.
    Toppled,
    /// It falls over without coming down.
    FellBack,
    /// The rim leaves the table, or the table would have to pull to keep it.
    LiftedOff,
    /// The whole rim meets the table at once.
    FaceDown,
    /// Time is up before its first turn is over.
    Hovered,
    /// Its energy is spent, and it lies flat.
    AtRest,
    /// Painlevé's paradox: rigid-body mechanics with this friction has no one answer.
    Painleve,
    /// It could not be computed.
    Failed,
}

/// What the tilt did before the end.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Tilting {
    /// Whether it was smallest once.
    pub came_down: bool,
    /// Whether it was largest after that, so that the turn is over.
    pub turned: bool,
    /// Whether it ended past the balance point.
    pub past_balance: bool,
}

impl Outcome {
    /// All of them, in the order of their codes, `outcome as usize`.
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
    pub(crate) fn of(status: Status, tilting: Tilting) -> Outcome {
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

    /// The outcome of a body whose rim leaves the table, as it rises past its balance point or not:
    /// there it falls over whether the rim leaves the table or not.
    pub fn lifted_off(rises_past_balance: bool) -> Outcome {
        if rises_past_balance {
            Outcome::Toppled
        } else {
            Outcome::LiftedOff
        }
    }

    /// Whether the motion was cut short before mechanics ended it, so that its turn has no end.
    pub(crate) fn is_cut_short(self) -> bool {
        matches!(self, Outcome::Hovered | Outcome::Failed)
    }
}

#[cfg(test)]
mod tests {
    use super::Outcome;

    #[test]
    fn codes_are_places_in_the_list() {
        for (place, outcome) in Outcome::ALL.into_iter().enumerate() {
            assert_eq!(outcome as usize, place);
        }
    }
}
