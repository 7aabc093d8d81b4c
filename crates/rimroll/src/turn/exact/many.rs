//! Many starts, by lanes and threads.
//!
//! A block of starts goes through the parts of its turns one after another; in each, starts that need
//! rules of the same size share lanes. What is rare is treated alone.

use super::alone::Outcome;
use super::dispatch::Eight;
use super::passing::{Stretch, Way};
use super::pieces::Piece;
use super::rule::{Choice, RULES};
use super::start::Start;
use super::tilting::sin_and_versine;
use super::together::Part;
use super::top::is_on_top;
use super::{Ending, Exact, ExactTurn, SHORT, told};
use crate::error::InvalidInput;
use crate::real::{LANES, Lanes, Real};
use crate::state::State;
#[cfg(feature = "threads")]
use rayon::prelude::*;

/// Starts that a thread takes at a time.
const BLOCK: usize = 512;

/// A start on its way through the lanes.
#[derive(Debug, Clone, Copy)]
pub(super) struct Lane {
    pub(super) start: Start<f64>,
    /// tan(φ/2) and its logarithm at the smallest and the largest tilt.
    pub(super) low: [f64; 2],
    pub(super) high: [f64; 2],
    /// Of the ridge that it passes.
    pub(super) width: f64,
    /// About how many nodes its three pieces need.
    nodes: [f64; 3],
    square: [f64; 2],
    course: Course,
    /// From the smallest tilt to the largest or, of one that passes, to the start.
    half: Piece<f64>,
    /// From the start's tilt to the largest, or to the end.
    leg: Piece<f64>,
}

/// What is known of what becomes of it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Course {
    /// Nothing: it is treated alone.
    Alone,
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
        for start in starts {
            self.check(start)?;
        }
        #[cfg(feature = "threads")]
        let blocks = starts.par_chunks(BLOCK);
        #[cfg(not(feature = "threads"))]
        let blocks = starts.chunks(BLOCK);
        let done: Option<Vec<_>> = blocks.map(|block| self.block(block, &goes_on)).collect();
        Ok(done.map(|blocks| blocks.concat()))
    }

    fn block(&self, starts: &[State], goes_on: impl Fn() -> bool) -> Option<Vec<ExactTurn>> {
        if !goes_on() {
            return None;
        }
        let mut lanes: Vec<Lane> = starts.iter().map(Lane::new).collect();
        // One that lingers next to the balance point takes more care.
        let a = self.parameters.a;
        let lingers = |lane: &Lane| is_on_top(&lane.start, a, &self.balance);
        let in_lanes = |&i: &usize| !self.is_beyond(&starts[i]) && !lingers(&lanes[i]);
        let near = (0..lanes.len()).filter(in_lanes);
        let (over, under) = near.partition(|&i| self.has_energy_to_pass(&lanes[i].start));
        let left = self.find_rocking(&mut lanes, under);
        self.find_passing(&mut lanes, [over, left].concat());
        self.rock(&mut lanes);
        self.pass(&mut lanes);
        let turn = |(lane, start): (&Lane, &State)| match lane.course {
            // One that has to be stepped may take long.
            Course::Alone => goes_on().then(|| self.turn_of(start)),
            Course::Rocks => Some(lane.rocked()),
            Course::Passes => Some(lane.passed(self.end())),
            Course::FallsBack => Some(told(&Outcome::without_turn(Ending::FellBack, None))),
        };
        lanes.iter().zip(starts).map(turn).collect()
    }

    /// Finds those that rock, and returns the others.
    fn find_rocking(&self, lanes: &mut [Lane], which: Vec<usize>) -> Vec<usize> {
        let engine = self.rocking_engine();
        let mut left = Vec::new();
        for eight in which.chunks(LANES) {
            let found =
                engine.extremes(&Eight::of(lanes, eight), self.highest(), self.least_slope());
            let sound = found.sound.bits();
            for (place, &i) in eight.iter().enumerate() {
                lanes[i].low = [found.low.y.0[place], found.low.eta.0[place]];
                lanes[i].high = [found.high.y.0[place], found.high.eta.0[place]];
                lanes[i].nodes = found.nodes.map(|all| all.0[place]);
                lanes[i].square = found.square.map(|all| all.0[place]);
                if sound & (1 << place) != 0 {
                    lanes[i].course = Course::Rocks;
                } else {
                    left.push(i);
                }
            }
        }
        left
    }

    /// Finds those that nothing turns back below the end.
    fn find_passing(&self, lanes: &mut [Lane], which: Vec<usize>) {
        let (engine, way) = (self.passing_engine(), self.way());
        let (falling, rising): (Vec<_>, Vec<_>) =
            which.into_iter().partition(|&i| lanes[i].start.p < 0.0);
        for eight in falling.chunks(LANES) {
            let found = engine.passing(&Eight::of(lanes, eight), &way);
            let sound = found.sound.bits();
            for (place, &i) in eight.iter().enumerate() {
                if sound & (1 << place) != 0 {
                    lanes[i].low = [found.low.y.0[place], found.low.eta.0[place]];
                    lanes[i].width = found.width.0[place];
                    lanes[i].nodes = found.nodes.map(|all| all.0[place]);
                    lanes[i].course = Course::Passes;
                }
            }
        }
        if way.ending == Ending::Rocked {
            return; // A disk goes on to its other face.
        }
        for eight in rising.chunks(LANES) {
            let sound = engine.falling_back(&Eight::of(lanes, eight), &way).bits();
            for (place, &i) in eight.iter().enumerate() {
                if sound & (1 << place) != 0 {
                    lanes[i].course = Course::FallsBack;
                }
            }
        }
    }

    /// Yaw and time of those that rock.
    fn rock(&self, lanes: &mut [Lane]) {
        let engine = self.rocking_engine();
        for part in [Part::Foot, Part::Head, Part::Leg, Part::ShortLeg] {
            add(
                lanes,
                |lane| self.choice(part, lane),
                |eight, choice| engine.part(part, eight, choice),
                Piece::is_resolved,
                |lane, piece| match part {
                    Part::Foot | Part::Head => lane.half = lane.half + piece,
                    Part::Leg | Part::ShortLeg => lane.leg = piece,
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
                |eight, choice| engine.stretch(stretch, eight, &way, choice),
                Piece::is_surely_resolved,
                |lane, piece| {
                    if piece.pull > 0.0 {
                        lane.course = Course::Alone;
                    }
                    match stretch {
                        Stretch::Foot | Stretch::Approach => lane.half = lane.half + piece,
                        Stretch::Rest => lane.leg = piece,
                    }
                },
            );
        }
    }

    pub(super) fn way(&self) -> Way {
        let (end, ending) = self.end();
        Way {
            balance: self.balance,
            end: [end, Real::ln(end)],
            ending,
        }
    }

    /// Whether it is past the balance point or, but for yaw and spin, goes there.
    fn has_energy_to_pass(&self, start: &Start<f64>) -> bool {
        let (balance, k) = (self.balance.y, &self.parameters);
        let (sin, versine) = sin_and_versine(start.y);
        let (sin_balance, versine_balance) = sin_and_versine(balance);
        let to_rise = k.r * (sin_balance - sin) - k.h * (versine_balance - versine);
        let inertia = match &self.table {
            Some(table) => table.rim_inertia,
            None => {
                let rho = k.r * (1.0 - versine) - k.h * sin;
                k.a + k.m * rho * rho
            }
        };
        start.y > balance || inertia * start.p * start.p > 2.0 * k.m * k.g * to_rise
    }

    /// The rule to begin with, where a lane that rocks has that part.
    fn choice(&self, part: Part, lane: &Lane) -> Option<Choice> {
        if lane.course != Course::Rocks {
            return None;
        }
        let leg = lane.high[1] - lane.start.eta;
        let has_leg = lane.start.p != 0.0;
        let [foot, head, along_leg] = lane.nodes;
        match part {
            Part::Foot => Some(Choice::plain(foot)),
            Part::Head => Some(Choice::to_highest(head, lane.square[0])),
            Part::Leg if has_leg && leg >= SHORT => {
                Some(Choice::to_highest(along_leg, lane.square[1]))
            }
            Part::ShortLeg if has_leg && leg < SHORT => Some(Choice::plain(0.0)),
            Part::Leg | Part::ShortLeg => None,
        }
    }
}

impl Lane {
    pub(super) fn new(start: &State) -> Lane {
        Lane {
            start: Start::of(start),
            low: [f64::NAN; 2],
            high: [f64::NAN; 2],
            width: f64::NAN,
            nodes: [f64::NAN; 3],
            square: [f64::NAN; 2],
            course: Course::Alone,
            half: Piece::nothing(),
            leg: Piece::nothing(),
        }
    }

    fn rocked(&self) -> ExactTurn {
        let Lane { half, leg, .. } = self;
        let (turn, min_time, yaw) = if self.start.p > 0.0 {
            let turn = 2.0 * half.yaw;
            (turn, leg.time + half.time, turn + leg.yaw)
        } else {
            let turn = 2.0 * half.yaw - leg.yaw;
            (turn, half.time - leg.time, turn)
        };
        ExactTurn {
            ending: Ending::Rocked,
            turn,
            min_tilt: 2.0 * libm::atan(self.low[0]),
            max_tilt: 2.0 * libm::atan(self.high[0]),
            min_time,
            time: min_time + half.time,
            yaw,
        }
    }

    fn passed(&self, (end, ending): (f64, Ending)) -> ExactTurn {
        let Lane { half, leg, .. } = self;
        let turn = half.yaw + (half.yaw + leg.yaw);
        ExactTurn {
            ending,
            turn,
            min_tilt: 2.0 * libm::atan(self.low[0]),
            max_tilt: 2.0 * libm::atan(end),
            min_time: half.time,
            time: half.time + (half.time + leg.time),
            yaw: turn,
        }
    }
}

/// Adds a piece to all lanes that have it, each by the smallest rule that resolves it.
fn add(
    lanes: &mut [Lane],
    choice: impl Fn(&Lane) -> Option<Choice>,
    ask: impl Fn(&Eight, Choice) -> Piece<Lanes>,
    is_resolved: impl Fn(&Piece<f64>, usize) -> bool,
    done: impl Fn(&mut Lane, Piece<f64>),
) {
    let mut waiting: Vec<Vec<usize>> = vec![Vec::new(); RULES];
    for (i, lane) in lanes.iter().enumerate() {
        if let Some(choice) = choice(lane) {
            waiting[choice.place()].push(i);
        }
    }
    for place in 0..RULES {
        let open = core::mem::take(&mut waiting[place]);
        let choice = Choice::at(place);
        for eight in open.chunks(LANES) {
            let pieces = ask(&Eight::of(lanes, eight), choice);
            for (place, &i) in eight.iter().enumerate() {
                let piece = pieces.map(|all| all.0[place]);
                if is_resolved(&piece, choice.nodes()) {
                    done(&mut lanes[i], piece);
                } else if !(piece.yaw.is_finite() && piece.time.is_finite()) {
                    // G has been negative at a node: what was taken for the motion's extremes are not.
                    lanes[i].course = Course::Alone;
                } else if let Some(larger) = choice.larger() {
                    waiting[larger.place()].push(i);
                } else {
                    lanes[i].course = Course::Alone;
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
        let thrown = |i: usize| State {
            tilt: 0.05 + 1.35 * digits_reversed(i, 2),
            tilt_rate: 0.4 * natural * (2.0 * digits_reversed(i, 3) - 1.0),
            yaw_rate: 0.1 * natural * (2.0 * digits_reversed(i, 5) - 1.0),
            spin_rate: 0.1 * natural * (2.0 * digits_reversed(i, 7) - 1.0),
            ..State::default()
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
            let together = exact.turns(&starts).unwrap();
            for (start, many) in starts.iter().zip(&together) {
                let one = exact.turn(start).unwrap();
                assert_eq!(one.ending, many.ending, "{start:?}");
                assert_eq!(one.turn.is_nan(), many.turn.is_nan(), "{start:?}");
                // Next to the balance point the last digits of a start decide more.
                for (a, b) in [(one.turn, many.turn), (one.time, many.time)] {
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
