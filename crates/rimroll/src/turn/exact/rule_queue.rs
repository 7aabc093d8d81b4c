//! Queues of starts, one for each quadrature rule.

use super::quadrature_rule::{Choice, RULES};
use crate::real::LANES;

/// The end of a list.
const NONE: u32 = u32::MAX;

/// A linked list of starts for each rule. A start is in at most one list.
pub(super) struct RuleQueue {
    /// The first start of each list.
    first: [u32; RULES],
    /// For each start, the next in its list.
    next: Vec<u32>,
}

impl RuleQueue {
    /// Empty queues for the given number of starts.
    pub(super) fn new(starts: usize) -> RuleQueue {
        RuleQueue {
            first: [NONE; RULES],
            next: vec![NONE; starts],
        }
    }

    pub(super) fn push(&mut self, choice: Choice, start: usize) {
        let first = &mut self.first[choice.index()];
        self.next[start] = core::mem::replace(first, start as u32);
    }

    /// Moves up to [`LANES`] starts from the list of a rule into `group`. Returns false if the list is empty.
    pub(super) fn take(&mut self, choice: Choice, group: &mut Vec<usize>) -> bool {
        let first = &mut self.first[choice.index()];
        group.clear();
        while *first != NONE && group.len() < LANES {
            let start = *first as usize;
            group.push(start);
            *first = self.next[start];
        }
        !group.is_empty()
    }
}
