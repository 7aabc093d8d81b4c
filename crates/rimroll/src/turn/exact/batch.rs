//! Many starts, in SIMD lanes and threads.
//!
//! The segments of the turns of a block are integrated one after another. For each segment, starts that
//! need the same quadrature rule share a group of lanes. Rare cases are left to the scalar code.

use super::dispatch::{
    ExtremesQuery, FallingBackQuery, StartQuery, TopplePartQuery, TopplingQuery, TurnPartQuery,
};
use super::lane_groups::{Class, Group, Lane, columns};
use super::quadrature_rule::{Choice, RULES, Rule};
use super::rocking_batch::TurnPart;
use super::scalar::Quadrature;
use super::segments::Integral;
use super::small_energy::is_near_balance;
use super::tilt_equation::SHORT;
use super::toppling_batch::{ToppleLimits, TopplePart};
use super::{Exact, ExactTurn, turn_of_quadrature};
use crate::error::InvalidInput;
use crate::motion::Outcome;
use crate::real::{LANES, Lanes, Real};
use crate::state::State;
#[cfg(feature = "threads")]
use rayon::prelude::*;

/// Starts per thread and block, large enough to fill the lanes of most rules.
const BLOCK: usize = 1024;

impl Exact {
    /// The turns of many starts, computed in the current thread pool. The result for a start depends neither
    /// on the other starts nor on the number of threads.
    ///
    /// # Errors
    /// Refuses the first start that is outside its bounds.
    pub fn turns(&self, starts: &[State]) -> Result<Vec<ExactTurn>, InvalidInput> {
        let turns = self.turns_while(starts, || true)?;
        Ok(turns.expect("nothing has ended the work"))
    }

    /// The turns of many starts, or `None` if `should_continue` returns false. It is called every few
    /// milliseconds.
    ///
    /// # Errors
    /// As [`Exact::turns`].
    pub fn turns_while(
        &self,
        starts: &[State],
        should_continue: impl Fn() -> bool + Sync,
    ) -> Result<Option<Vec<ExactTurn>>, InvalidInput> {
        let refused = |block: &[State]| block.iter().find_map(|start| self.check(start).err());
        let mut turns = vec![
            turn_of_quadrature(&Quadrature::without_turn(Outcome::Failed, None));
            starts.len()
        ];
        #[cfg(feature = "threads")]
        let (first, (of_turns, of_starts)) = (
            starts.par_chunks(BLOCK).find_map_first(refused),
            (turns.par_chunks_mut(BLOCK), starts.par_chunks(BLOCK)),
        );
        #[cfg(not(feature = "threads"))]
        let (first, (of_turns, of_starts)) = (
            starts.chunks(BLOCK).find_map(refused),
            (turns.chunks_mut(BLOCK), starts.chunks(BLOCK)),
        );
        if let Some(refusal) = first {
            return Err(refusal);
        }
        let done = of_turns
            .zip(of_starts)
            .try_for_each(|(turns, starts)| self.block(starts, turns, &should_continue));
        Ok(done.map(|()| turns))
    }

    /// Writes the turns of some starts; `None` if the computation is cancelled.
    fn block(
        &self,
        starts: &[State],
        turns: &mut [ExactTurn],
        should_continue: impl Fn() -> bool,
    ) -> Option<()> {
        if !should_continue() {
            return None;
        }
        let mut lanes = Lane::of(self, starts);
        self.find_rocking(&mut lanes);
        self.find_toppling(&mut lanes);
        self.rock(&mut lanes);
        self.topple(&mut lanes);
        let end = self.end();
        for ((turn, lane), start) in turns.iter_mut().zip(&lanes).zip(starts) {
            *turn = match lane.class {
                Class::Rocks => lane.rocked(),
                Class::Topples => lane.toppled(end),
                Class::FallsBack => {
                    turn_of_quadrature(&Quadrature::without_turn(Outcome::FellBack, None))
                }
                // Time integration, where it is needed, may take long.
                _ if should_continue() => self.turn_of(start),
                _ => return None,
            };
        }
        Some(())
    }

    /// Finds the extremes of the starts that rock. The others may topple.
    fn find_rocking(&self, lanes: &mut [Lane]) {
        let engine = self.rocking_engine();
        for group in indices_where(lanes, |lane| lane.class == Class::BelowBalance).chunks(LANES) {
            let found = engine.answer(&ExtremesQuery {
                group: &Group::of(lanes, group),
                max_y: self.highest(),
                min_slope: self.min_slope(),
            });
            let valid = found.valid;
            for (place, &i) in group.iter().enumerate() {
                let lane = &mut lanes[i];
                if valid & (1 << place) == 0 {
                    lane.class = Class::AboveBalance;
                    continue;
                }
                let here = |all: Lanes| all.0[place];
                lane.class = Class::Rocks;
                lane.conserved = found.conserved.map(here);
                lane.low = found.low.map(here);
                lane.high = found.high.map(here);
                lane.tilts = found.tilts.map(here);
                lane.nodes = found.nodes.map(here);
                lane.square = found.square.map(here);
            }
        }
    }

    /// Finds the starts that have no upper turning point below the end.
    fn find_toppling(&self, lanes: &mut [Lane]) {
        let (engine, limits) = (self.general_engine(), self.topple_limits());
        let over = indices_where(lanes, |lane| lane.class == Class::AboveBalance);
        let (falling, rising): (Vec<_>, Vec<_>) =
            over.into_iter().partition(|&i| lanes[i].start.p < 0.0);
        for group in falling.chunks(LANES) {
            let found = engine.answer(&TopplingQuery {
                group: &Group::of(lanes, group),
                limits: &limits,
            });
            let valid = found.valid;
            for (place, &i) in group.iter().enumerate() {
                if valid & (1 << place) == 0 {
                    continue;
                }
                let (lane, here) = (&mut lanes[i], |all: Lanes| all.0[place]);
                lane.class = Class::Topples;
                lane.conserved = found.conserved.map(here);
                lane.low = found.low.map(here);
                lane.tilts = [here(found.tilt), self.end_tilt()];
                lane.width = here(found.width);
                lane.nodes = found.nodes.map(here);
            }
        }
        if limits.ending == Outcome::Rocked {
            return; // A disk passes the vertical and falls to its other face.
        }
        for group in rising.chunks(LANES) {
            let valid = engine.answer(&FallingBackQuery {
                group: &Group::of(lanes, group),
                limits: &limits,
            });
            for (place, &i) in group.iter().enumerate() {
                if valid & (1 << place) != 0 {
                    lanes[i].class = Class::FallsBack;
                }
            }
        }
    }

    /// Integrates yaw and time of the starts that rock.
    fn rock(&self, lanes: &mut [Lane]) {
        let engine = self.rocking_engine();
        for part in [
            TurnPart::FromLowest,
            TurnPart::ToHighest,
            TurnPart::StartToHighest,
            TurnPart::ShortStartToHighest,
        ] {
            integrate_part(
                lanes,
                |lane| self.choice(part, lane),
                |group, rule| engine.answer(&TurnPartQuery { group, part, rule }),
                |lane, segment| match part {
                    TurnPart::FromLowest => lane.from_lowest = segment,
                    TurnPart::ToHighest => lane.from_lowest = sum(lane.from_lowest, segment),
                    TurnPart::StartToHighest | TurnPart::ShortStartToHighest => {
                        lane.from_start = segment
                    }
                },
            );
        }
    }

    /// Integrates yaw and time of the starts that topple.
    fn topple(&self, lanes: &mut [Lane]) {
        let (engine, limits) = (self.general_engine(), self.topple_limits());
        for part in [
            TopplePart::FromLowest,
            TopplePart::ToStart,
            TopplePart::ToEnd,
        ] {
            integrate_part(
                lanes,
                |lane| {
                    let has = match part {
                        TopplePart::FromLowest | TopplePart::ToEnd => true,
                        TopplePart::ToStart => limits.starts_near_balance(lane.start.eta),
                    };
                    let passes = lane.class == Class::Topples && has;
                    passes.then(|| Choice::plain(lane.nodes[part as usize]))
                },
                |group, rule| {
                    engine.answer(&TopplePartQuery {
                        group,
                        part,
                        limits: &limits,
                        rule,
                    })
                },
                |lane, segment| match part {
                    TopplePart::FromLowest => lane.from_lowest = segment,
                    TopplePart::ToStart => lane.from_lowest = sum(lane.from_lowest, segment),
                    TopplePart::ToEnd => lane.from_start = segment,
                },
            );
        }
    }

    pub(super) fn topple_limits(&self) -> ToppleLimits {
        let (end, ending) = self.end();
        ToppleLimits {
            balance: self.balance,
            end: [end, Real::ln(end)],
            ending,
        }
    }

    fn end_tilt(&self) -> f64 {
        2.0 * Real::atan(self.end().0)
    }

    /// The first rule to try for a part of a rocking turn; `None` if the turn has no such part.
    fn choice(&self, part: TurnPart, lane: &Lane) -> Option<Choice> {
        if lane.class != Class::Rocks {
            return None;
        }
        let start_to_highest = lane.high[1] - lane.start.eta;
        let starts_moving = lane.start.p != 0.0;
        let [from_lowest, to_highest, from_start] = lane.nodes;
        match part {
            TurnPart::FromLowest => Some(Choice::plain(from_lowest)),
            TurnPart::ToHighest => Some(Choice::to_highest(to_highest, lane.square[0])),
            TurnPart::StartToHighest if starts_moving && start_to_highest >= SHORT => {
                Some(Choice::to_highest(from_start, lane.square[1]))
            }
            TurnPart::ShortStartToHighest if starts_moving && start_to_highest < SHORT => {
                Some(Choice::plain(0.0))
            }
            TurnPart::StartToHighest | TurnPart::ShortStartToHighest => None,
        }
    }
}

impl Lane {
    /// Converts and classifies the starts of a block.
    pub(super) fn of(exact: &Exact, starts: &[State]) -> Vec<Lane> {
        let engine = exact.rocking_engine();
        let mut lanes = Vec::with_capacity(starts.len());
        for group in starts.chunks(LANES) {
            let (start, over) = engine.answer(&StartQuery(columns(group), exact.balance));
            lanes.extend(group.iter().enumerate().map(|(place, given)| {
                let start = start.map(|lanes| lanes.0[place]);
                // Next to the balance point, only the scalar code keeps the digits of G.
                let lingers = is_near_balance(&start, exact.parameters.a, &exact.balance);
                let class = match over & (1 << place) {
                    _ if lingers || exact.is_beyond(given) => Class::NeedsScalar,
                    0 => Class::BelowBalance,
                    _ => Class::AboveBalance,
                };
                Lane::new(start, class)
            }));
        }
        lanes
    }

    fn rocked(&self) -> ExactTurn {
        let ([half_yaw, half_time], [start_yaw, start_time]) = (self.from_lowest, self.from_start);
        let (turn, min_time, yaw) = if self.start.p > 0.0 {
            let turn = 2.0 * half_yaw;
            (turn, start_time + half_time, turn + start_yaw)
        } else {
            let turn = 2.0 * half_yaw - start_yaw;
            (turn, half_time - start_time, turn)
        };
        ExactTurn {
            ending: Outcome::Rocked,
            outcome: Outcome::Rocked,
            turn,
            min_tilt: self.tilts[0],
            max_tilt: self.tilts[1],
            min_time,
            time: min_time + half_time,
            yaw,
        }
    }

    fn toppled(&self, (_, ending): (f64, Outcome)) -> ExactTurn {
        let ([half_yaw, half_time], [start_yaw, start_time]) = (self.from_lowest, self.from_start);
        let turn = half_yaw + (half_yaw + start_yaw);
        ExactTurn {
            ending,
            outcome: ending,
            turn,
            min_tilt: self.tilts[0],
            max_tilt: self.tilts[1],
            min_time: half_time,
            time: half_time + (half_time + start_time),
            yaw: turn,
        }
    }
}

/// The indices of the lanes that satisfy a condition.
fn indices_where(lanes: &[Lane], condition: impl Fn(&Lane) -> bool) -> Vec<usize> {
    (0..lanes.len()).filter(|&i| condition(&lanes[i])).collect()
}

fn sum([yaw, time]: [f64; 2], [more_yaw, more_time]: [f64; 2]) -> [f64; 2] {
    [yaw + more_yaw, time + more_time]
}

/// Integrates one part, yaw and time, in all lanes that have it, each with the smallest rule that resolves it.
fn integrate_part(
    lanes: &mut [Lane],
    choice: impl Fn(&Lane) -> Option<Choice>,
    answer: impl Fn(&Group, &'static Rule) -> Integral,
    done: impl Fn(&mut Lane, [f64; 2]),
) {
    let mut queue = RuleQueue::new(lanes.len());
    for (i, lane) in lanes.iter().enumerate() {
        if let Some(choice) = choice(lane) {
            queue.push(choice, i);
        }
    }
    let mut group = Vec::with_capacity(LANES);
    for choice in (0..RULES).map(Choice::from_index) {
        while queue.take(choice, &mut group) {
            let integral = answer(&Group::of(lanes, &group), choice.rule());
            let (resolved, in_contact) = (integral.resolved, integral.in_contact);
            for (place, &i) in group.iter().enumerate() {
                let segment = [integral.yaw.0[place], integral.time.0[place]];
                // If G is negative at a node, the computed extremes are not those of the motion.
                let is_real = segment.iter().all(|number| number.is_finite());
                match choice.larger() {
                    _ if !is_real || in_contact & (1 << place) == 0 => {
                        lanes[i].class = Class::NeedsScalar
                    }
                    _ if resolved & (1 << place) != 0 => done(&mut lanes[i], segment),
                    Some(larger) => queue.push(larger, i),
                    None => lanes[i].class = Class::NeedsScalar,
                }
            }
        }
    }
}

/// The end of a list in a [`RuleQueue`].
const NONE: u32 = u32::MAX;

/// A linked list of starts for each rule. A start is in at most one list.
struct RuleQueue {
    /// The first start of each list.
    first: [u32; RULES],
    /// For each start, the next in its list.
    next: Vec<u32>,
}

impl RuleQueue {
    /// Empty queues for the given number of starts.
    fn new(starts: usize) -> RuleQueue {
        RuleQueue {
            first: [NONE; RULES],
            next: vec![NONE; starts],
        }
    }

    fn push(&mut self, choice: Choice, start: usize) {
        let first = &mut self.first[choice.index()];
        self.next[start] = core::mem::replace(first, start as u32);
    }

    /// Moves up to [`LANES`] starts from the list of a rule into `group`. Returns false if the list is empty.
    fn take(&mut self, choice: Choice, group: &mut Vec<usize>) -> bool {
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

#[cfg(test)]
mod tests {
    use super::Exact;
    use crate::body::Body;
    use crate::law::IdealLaw;
    use crate::presets;
    use crate::state::State;

    /// Starts of all kinds, from a Halton sequence.
    fn throws(body: &Body, count: usize) -> Vec<State> {
        let natural = (9.8 / body.radius()).sqrt();
        let digits_reversed = |mut i: usize, base: usize| {
            let (mut sum, mut unit) = (0.0, 1.0);
            while i > 0 {
                unit /= base as f64;
                sum += unit * (i % base) as f64;
                i /= base;
            }
            sum
        };
        let thrown = |i: usize| {
            // Every third start comes down nearly flat.
            let sideways = natural * if i.is_multiple_of(3) { 1e-5 } else { 0.1 };
            State {
                tilt: 0.05 + 1.35 * digits_reversed(i, 2),
                tilt_rate: 0.4 * natural * (2.0 * digits_reversed(i, 3) - 1.0),
                yaw_rate: sideways * (2.0 * digits_reversed(i, 5) - 1.0),
                spin_rate: sideways * (2.0 * digits_reversed(i, 7) - 1.0),
                ..State::default()
            }
        };
        (1..=count).map(thrown).collect()
    }

    #[test]
    fn batch_and_scalar_turns_agree() {
        let bodies = [
            presets::can_2007().unwrap(),
            Body::new(0.3, 0.1, 0.05, 0.003, 0.005).unwrap(),
            Body::new(0.3, 0.02, 0.2, 0.016, 0.0001).unwrap(),
            Body::new(0.1, 0.02, 0.0, 1e-5, 2e-5).unwrap(),
        ];
        for (body, law) in bodies
            .iter()
            .flat_map(|body| [(body, IdealLaw::NoSlip), (body, IdealLaw::Frictionless)])
        {
            let exact = Exact::new(body, law, 9.8, None).unwrap();
            let starts = throws(body, 600);
            let rocking = exact.turns(&starts).unwrap();
            for (start, batch) in starts.iter().zip(&rocking) {
                let single = &exact.turns(&[*start]).unwrap()[0];
                assert_eq!(format!("{single:?}"), format!("{batch:?}"), "{start:?}");
                let one = exact.turn(start).unwrap();
                assert_eq!(one.ending, batch.ending, "{start:?}");
                assert_eq!(one.turn.is_nan(), batch.turn.is_nan(), "{start:?}");
                // Next to the balance point the result is more sensitive to the last digits of the start.
                for (a, b) in [(one.turn, batch.turn), (one.time, batch.time)] {
                    assert!(
                        a.is_nan() || (a - b).abs() < 1e-11 * (1.0 + a.abs()),
                        "{start:?}"
                    );
                }
            }
        }
    }

    #[test]
    fn a_cancelled_computation_returns_no_turns() {
        let can = presets::can_2007().unwrap();
        let exact = Exact::new(&can, IdealLaw::NoSlip, 9.8, None).unwrap();
        let starts = throws(&can, 100);
        assert!(exact.turns_while(&starts, || false).unwrap().is_none());
        let slopes = exact.turn_slopes_while(&starts, || false);
        assert!(slopes.unwrap().is_none());
        assert_eq!(
            exact.turns_while(&starts, || true).unwrap().unwrap().len(),
            100
        );
    }
}
