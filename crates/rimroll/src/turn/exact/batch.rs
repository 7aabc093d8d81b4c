//! Many starts, by lanes and threads.
//!
//! A block of starts goes through the parts of its turns one after another; in each, starts that need
//! rules of the same size share lanes. What is rare is treated alone.

use super::dispatch::Group;
use super::rocking::TurnPart;
use super::rule::{Choice, RULES};
use super::scalar::Quadrature;
use super::segments::Integral;
use super::start::Start;
use super::tilting::Conserved;
use super::top::is_on_top;
use super::toppling::{Stretch, ToppleLimits};
use super::waiting::Waiting;
use super::{Exact, ExactTurn, Outcome, SHORT, turn_of_quadrature};
use crate::error::InvalidInput;
use crate::real::{LANES, Lanes, Real};
use crate::state::State;
#[cfg(feature = "threads")]
use rayon::prelude::*;

/// Starts that a thread takes at a time: so many that most rules find sixteen.
const BLOCK: usize = 1024;

/// A start on its way through the lanes.
#[derive(Debug, Clone, Copy)]
pub(super) struct Lane {
    pub(super) start: Start<f64>,
    pub(super) conserved: Conserved<f64>,
    /// At the smallest tilt tan(φ/2), its logarithm, and how much the collision counts there.
    pub(super) low: [f64; 3],
    /// At the largest tan(φ/2) and its logarithm.
    pub(super) high: [f64; 2],
    /// Both tilts, rad.
    tilts: [f64; 2],
    /// Of the ridge that it passes.
    pub(super) width: f64,
    /// About how many nodes its three pieces need.
    nodes: [f64; 3],
    square: [f64; 2],
    course: Course,
    /// Yaw and time from the smallest tilt to the largest or, of one that passes, to the start.
    half: [f64; 2],
    /// Yaw and time from the start's tilt to the largest, or to the end.
    leg: [f64; 2],
}

/// What is known of what becomes of it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Course {
    /// Nothing: it is treated alone.
    ScalarQuadrature,
    /// It is past the balance point or, but for yaw and spin, goes there.
    GoesOver,
    /// It is not, and does not.
    StaysUnder,
    /// It comes down and rocks.
    Rocks,
    /// It comes down and passes over the balance point.
    Passes,
    /// It falls over as it is.
    FallsBack,
}

impl Exact {
    /// The turns of many starts, on the threads of the pool that it is called from. Those of a start do
    /// not depend on the others, nor on the number of threads.
    ///
    /// # Errors
    /// Refuses a start outside its bounds: the first.
    pub fn turns(&self, starts: &[State]) -> Result<Vec<ExactTurn>, InvalidInput> {
        let turns = self.turns_while(starts, || true)?;
        Ok(turns.expect("nothing has ended the work"))
    }

    /// The same, unless `goes_on`, which is asked every few thousandths of a second, says that it is no longer
    /// wanted.
    ///
    /// # Errors
    /// As [`Exact::turns`].
    pub fn turns_while(
        &self,
        starts: &[State],
        goes_on: impl Fn() -> bool + Sync,
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
            .try_for_each(|(turns, starts)| self.block(starts, turns, &goes_on));
        Ok(done.map(|()| turns))
    }

    /// Fills in the turns of some starts, unless the work is no longer wanted.
    fn block(
        &self,
        starts: &[State],
        turns: &mut [ExactTurn],
        goes_on: impl Fn() -> bool,
    ) -> Option<()> {
        if !goes_on() {
            return None;
        }
        let mut lanes = Lane::of(self, starts);
        self.find_rocking(&mut lanes);
        self.find_passing(&mut lanes);
        self.rock(&mut lanes);
        self.pass(&mut lanes);
        let end = self.end();
        for ((turn, lane), start) in turns.iter_mut().zip(&lanes).zip(starts) {
            *turn = match lane.course {
                Course::Rocks => lane.rocked(),
                Course::Passes => lane.passed(end),
                Course::FallsBack => {
                    turn_of_quadrature(&Quadrature::without_turn(Outcome::FellBack, None))
                }
                // One that has to be stepped may take long.
                _ if goes_on() => self.turn_of(start),
                _ => return None,
            };
        }
        Some(())
    }

    /// Finds those that rock; the others may pass.
    fn find_rocking(&self, lanes: &mut [Lane]) {
        let engine = self.rocking_engine();
        let (highest, least_slope) = (self.highest(), self.least_slope());
        for group in which(lanes, |lane| lane.course == Course::StaysUnder).chunks(LANES) {
            let found = engine.extremes(&Group::of(lanes, group), highest, least_slope);
            let sound = found.sound;
            for (place, &i) in group.iter().enumerate() {
                let lane = &mut lanes[i];
                if sound & (1 << place) == 0 {
                    lane.course = Course::GoesOver;
                    continue;
                }
                let here = |all: Lanes| all.0[place];
                lane.course = Course::Rocks;
                lane.conserved = found.conserved.map(here);
                lane.low = found.low.map(here);
                lane.high = found.high.map(here);
                lane.tilts = found.tilts.map(here);
                lane.nodes = found.nodes.map(here);
                lane.square = found.square.map(here);
            }
        }
    }

    /// Finds those that nothing turns back below the end.
    fn find_passing(&self, lanes: &mut [Lane]) {
        let (engine, way) = (self.passing_engine(), self.way());
        let over = which(lanes, |lane| lane.course == Course::GoesOver);
        let (falling, rising): (Vec<_>, Vec<_>) =
            over.into_iter().partition(|&i| lanes[i].start.p < 0.0);
        for group in falling.chunks(LANES) {
            let found = engine.toppling(&Group::of(lanes, group), &way);
            let sound = found.sound;
            for (place, &i) in group.iter().enumerate() {
                if sound & (1 << place) == 0 {
                    continue;
                }
                let (lane, here) = (&mut lanes[i], |all: Lanes| all.0[place]);
                lane.course = Course::Passes;
                lane.conserved = found.conserved.map(here);
                lane.low = found.low.map(here);
                lane.tilts = [here(found.tilt), self.end_tilt()];
                lane.width = here(found.width);
                lane.nodes = found.nodes.map(here);
            }
        }
        if way.ending == Outcome::Rocked {
            return; // A disk goes on to its other face.
        }
        for group in rising.chunks(LANES) {
            let sound = engine.falling_back(&Group::of(lanes, group), &way);
            for (place, &i) in group.iter().enumerate() {
                if sound & (1 << place) != 0 {
                    lanes[i].course = Course::FallsBack;
                }
            }
        }
    }

    /// Yaw and time of those that rock.
    fn rock(&self, lanes: &mut [Lane]) {
        let engine = self.rocking_engine();
        for part in [
            TurnPart::Foot,
            TurnPart::Head,
            TurnPart::Leg,
            TurnPart::ShortLeg,
        ] {
            add(
                lanes,
                |lane| self.choice(part, lane),
                |group, choice| engine.part(part, group, choice),
                |lane, segment| match part {
                    TurnPart::Foot => lane.half = segment,
                    TurnPart::Head => lane.half = sum(lane.half, segment),
                    TurnPart::Leg | TurnPart::ShortLeg => lane.leg = segment,
                },
            );
        }
    }

    /// Yaw and time of those that pass.
    fn pass(&self, lanes: &mut [Lane]) {
        let (engine, way) = (self.passing_engine(), self.way());
        for stretch in [Stretch::Foot, Stretch::Approach, Stretch::Rest] {
            add(
                lanes,
                |lane| {
                    let has = match stretch {
                        Stretch::Foot | Stretch::Rest => true,
                        Stretch::Approach => way.has_approach(lane.start.eta),
                    };
                    let passes = lane.course == Course::Passes && has;
                    passes.then(|| Choice::plain(lane.nodes[stretch as usize]))
                },
                |group, choice| engine.stretch(stretch, group, &way, choice),
                |lane, segment| match stretch {
                    Stretch::Foot => lane.half = segment,
                    Stretch::Approach => lane.half = sum(lane.half, segment),
                    Stretch::Rest => lane.leg = segment,
                },
            );
        }
    }

    pub(super) fn way(&self) -> ToppleLimits {
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

    /// The rule to begin with, where a lane that rocks has that part.
    fn choice(&self, part: TurnPart, lane: &Lane) -> Option<Choice> {
        if lane.course != Course::Rocks {
            return None;
        }
        let leg = lane.high[1] - lane.start.eta;
        let has_leg = lane.start.p != 0.0;
        let [foot, head, along_leg] = lane.nodes;
        match part {
            TurnPart::Foot => Some(Choice::plain(foot)),
            TurnPart::Head => Some(Choice::to_highest(head, lane.square[0])),
            TurnPart::Leg if has_leg && leg >= SHORT => {
                Some(Choice::to_highest(along_leg, lane.square[1]))
            }
            TurnPart::ShortLeg if has_leg && leg < SHORT => Some(Choice::plain(0.0)),
            TurnPart::Leg | TurnPart::ShortLeg => None,
        }
    }
}

impl Lane {
    /// Of the starts of a block.
    pub(super) fn of(exact: &Exact, starts: &[State]) -> Vec<Lane> {
        let engine = exact.rocking_engine();
        let mut lanes = Vec::with_capacity(starts.len());
        for group in starts.chunks(LANES) {
            let (start, over) = engine.start(columns(group), &exact.balance);
            lanes.extend(group.iter().enumerate().map(|(place, given)| {
                let start = start.lane(place);
                // One that lingers next to the balance point takes more care.
                let lingers = is_on_top(&start, exact.parameters.a, &exact.balance);
                let course = match over & (1 << place) {
                    _ if lingers || exact.is_beyond(given) => Course::ScalarQuadrature,
                    0 => Course::StaysUnder,
                    _ => Course::GoesOver,
                };
                Lane::new(start, course)
            }));
        }
        lanes
    }

    fn new(start: Start<f64>, course: Course) -> Lane {
        Lane {
            start,
            course,
            conserved: [0.0; 4],
            low: [0.0; 3],
            high: [0.0; 2],
            tilts: [0.0; 2],
            width: 0.0,
            nodes: [0.0; 3],
            square: [0.0; 2],
            half: [0.0; 2],
            leg: [0.0; 2],
        }
    }

    fn rocked(&self) -> ExactTurn {
        let ([half_yaw, half_time], [leg_yaw, leg_time]) = (self.half, self.leg);
        let (turn, min_time, yaw) = if self.start.p > 0.0 {
            let turn = 2.0 * half_yaw;
            (turn, leg_time + half_time, turn + leg_yaw)
        } else {
            let turn = 2.0 * half_yaw - leg_yaw;
            (turn, half_time - leg_time, turn)
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

    fn passed(&self, (_, ending): (f64, Outcome)) -> ExactTurn {
        let ([half_yaw, half_time], [leg_yaw, leg_time]) = (self.half, self.leg);
        let turn = half_yaw + (half_yaw + leg_yaw);
        ExactTurn {
            ending,
            outcome: ending,
            turn,
            min_tilt: self.tilts[0],
            max_tilt: self.tilts[1],
            min_time: half_time,
            time: half_time + (half_time + leg_time),
            yaw: turn,
        }
    }
}

/// [tilt, tilt rate, yaw rate, spin rate] of sixteen starts; where there are fewer, the last repeat the first.
pub(super) fn columns(group: &[State]) -> [Lanes; 4] {
    let mut columns = [Lanes::from(0.0); 4];
    for place in 0..LANES {
        let start = group.get(place).unwrap_or(&group[0]);
        columns[0].0[place] = start.tilt;
        columns[1].0[place] = start.tilt_rate;
        columns[2].0[place] = start.yaw_rate;
        columns[3].0[place] = start.spin_rate;
    }
    columns
}

/// The lanes of which something is true.
fn which(lanes: &[Lane], is_so: impl Fn(&Lane) -> bool) -> Vec<usize> {
    (0..lanes.len()).filter(|&i| is_so(&lanes[i])).collect()
}

fn sum([yaw, time]: [f64; 2], [more_yaw, more_time]: [f64; 2]) -> [f64; 2] {
    [yaw + more_yaw, time + more_time]
}

/// Adds a piece, yaw and time, to all lanes that have it, each by the smallest rule that resolves it.
fn add(
    lanes: &mut [Lane],
    choice: impl Fn(&Lane) -> Option<Choice>,
    answer: impl Fn(&Group, Choice) -> Integral,
    done: impl Fn(&mut Lane, [f64; 2]),
) {
    let mut waiting = Waiting::new(lanes.len());
    for (i, lane) in lanes.iter().enumerate() {
        if let Some(choice) = choice(lane) {
            waiting.push(choice, i);
        }
    }
    let mut group = Vec::with_capacity(LANES);
    for choice in (0..RULES).map(Choice::at) {
        while waiting.take(choice, &mut group) {
            let integral = answer(&Group::of(lanes, &group), choice);
            let (resolved, pushed) = (integral.resolved, integral.pushed);
            for (place, &i) in group.iter().enumerate() {
                let segment = [integral.yaw.0[place], integral.time.0[place]];
                // Where G has been negative at a node, what was taken for the motion's extremes are not.
                let is_real = segment.iter().all(|number| number.is_finite());
                match choice.larger() {
                    _ if !is_real || pushed & (1 << place) == 0 => {
                        lanes[i].course = Course::ScalarQuadrature
                    }
                    _ if resolved & (1 << place) != 0 => done(&mut lanes[i], segment),
                    Some(larger) => waiting.push(larger, i),
                    None => lanes[i].course = Course::ScalarQuadrature,
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Exact;
    use crate::body::Body;
    use crate::law::IdealLaw;
    use crate::presets;
    use crate::state::State;

    /// Throws of all kinds, by Halton's points.
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
            // Every third comes down all but flat.
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
    fn many_end_and_turn_as_each_does_alone() {
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
                let by_itself = &exact.turns(&[*start]).unwrap()[0];
                assert_eq!(format!("{by_itself:?}"), format!("{batch:?}"), "{start:?}");
                let one = exact.turn(start).unwrap();
                assert_eq!(one.ending, batch.ending, "{start:?}");
                assert_eq!(one.turn.is_nan(), batch.turn.is_nan(), "{start:?}");
                // Next to the balance point the last digits of a start decide more.
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
    fn work_that_is_no_longer_wanted_ends_without_turns() {
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
