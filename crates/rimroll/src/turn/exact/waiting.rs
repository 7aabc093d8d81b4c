//! Starts that wait for a rule.

use super::rule::{Choice, RULES};
use crate::real::LANES;

/// No start.
const NONE: u32 = u32::MAX;

/// A list of starts for each rule. A start is in one at most.
pub(super) struct Waiting {
    /// The first of each list.
    first: [u32; RULES],
    /// After each start the next of its list.
    next: Vec<u32>,
}

impl Waiting {
    /// For so many starts.
    pub(super) fn new(starts: usize) -> Waiting {
        Waiting {
            first: [NONE; RULES],
            next: vec![NONE; starts],
        }
    }

    pub(super) fn push(&mut self, choice: Choice, start: usize) {
        let first = &mut self.first[choice.place()];
        self.next[start] = core::mem::replace(first, start as u32);
    }

    /// Takes up to [`LANES`] that wait for a rule into `group`; false if there are none.
    pub(super) fn take(&mut self, choice: Choice, group: &mut Vec<usize>) -> bool {
        let first = &mut self.first[choice.place()];
        group.clear();
        while *first != NONE && group.len() < LANES {
            let start = *first as usize;
            group.push(start);
            *first = self.next[start];
        }
        !group.is_empty()
    }
}
