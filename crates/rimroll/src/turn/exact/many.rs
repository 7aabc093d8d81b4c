//! Many starts, by lanes and threads.
//!
//! A block of starts goes through the parts of its turns one after another; in each, starts that need
//! rules of the same size share lanes. Those that do not rock, and the odd ones, are treated alone.

use super::dispatch::{Eight, Engine};
use super::pieces::Piece;
use super::rule::{Choice, RULES};
use super::start::Start;
use super::tilting::gap_beyond;
use super::together::Part;
use super::{Ending, Exact, ExactTurn, MOST_OUTER, SHORT};
use crate::error::InvalidInput;
use crate::real::LANES;
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
    /// From the one to the other.
    half: Piece<f64>,
    /// From the start's tilt to the largest.
    leg: Piece<f64>,
    /// Whether it is still among the others.
    together: bool,
}

impl Exact {
    /// The turns of many starts, on the threads of the pool that it is called from. Those of a start do
    /// not depend on the others, nor on the number of threads.
    ///
    /// # Errors
    /// Refuses a start outside its bounds: the first.
    pub fn turns(&self, starts: &[State]) -> Result<Vec<ExactTurn>, InvalidInput> {
        for start in starts {
            self.check(start)?;
        }
        #[cfg(feature = "threads")]
        let blocks: Vec<_> = starts
            .par_chunks(BLOCK)
            .map(|block| self.block(block))
            .collect();
        #[cfg(not(feature = "threads"))]
        let blocks: Vec<_> = starts
            .chunks(BLOCK)
            .map(|block| self.block(block))
            .collect();
        Ok(blocks.concat())
    }

    fn block(&self, starts: &[State]) -> Vec<ExactTurn> {
        let engine = self.engine();
        let mut lanes: Vec<Lane> = starts.iter().map(Lane::new).collect();
        for (lane, start) in lanes.iter_mut().zip(starts) {
            lane.together = !self.is_beyond(start);
        }
        self.find_extremes(&engine, &mut lanes);
        for part in [Part::Foot, Part::Head, Part::Leg, Part::ShortLeg] {
            self.add(part, &engine, &mut lanes);
        }
        let turn = |(lane, start): (&Lane, &State)| {
            if lane.together {
                lane.told()
            } else {
                self.turn_of(start)
            }
        };
        lanes.iter().zip(starts).map(turn).collect()
    }

    fn find_extremes(&self, engine: &Engine<'_>, lanes: &mut [Lane]) {
        let open: Vec<usize> = (0..lanes.len()).filter(|&i| lanes[i].together).collect();
        for eight in open.chunks(LANES) {
            let found = engine.extremes(&Eight::of(lanes, eight), self.highest());
            let sound = found.sound.bits();
            for (lane, &i) in eight.iter().enumerate() {
                lanes[i].low = [found.low.y.0[lane], found.low.eta.0[lane]];
                lanes[i].high = [found.high.y.0[lane], found.high.eta.0[lane]];
                lanes[i].together = sound & (1 << lane) != 0;
            }
        }
    }

    /// Adds a part to all lanes that have it, each by the smallest rule that resolves it.
    fn add(&self, part: Part, engine: &Engine<'_>, lanes: &mut [Lane]) {
        let mut waiting: Vec<Vec<usize>> = vec![Vec::new(); RULES];
        for (i, lane) in lanes.iter().enumerate() {
            if let Some(choice) = self.choice(part, lane) {
                waiting[choice.place()].push(i);
            }
        }
        for place in 0..RULES {
            let open = core::mem::take(&mut waiting[place]);
            let choice = Choice::at(place);
            for eight in open.chunks(LANES) {
                let pieces = engine.part(part, &Eight::of(lanes, eight), choice);
                for (place, &i) in eight.iter().enumerate() {
                    let piece = pieces.map(|all| all.0[place]);
                    if part == Part::ShortLeg || piece.is_resolved(choice.nodes()) {
                        lanes[i].add(part, piece);
                    } else if let Some(larger) = choice.larger() {
                        waiting[larger.place()].push(i);
                    } else {
                        lanes[i].together = false;
                    }
                }
            }
        }
    }

    /// The rule to begin with, where a lane has that part.
    fn choice(&self, part: Part, lane: &Lane) -> Option<Choice> {
        if !lane.together {
            return None;
        }
        let gap = || gap_beyond(self.body.radius(), self.body.height(), lane.high[0]);
        let span = lane.high[1] - lane.low[1];
        let outer = (0.5 * span).min(MOST_OUTER);
        let leg = lane.high[1] - lane.start.eta;
        let has_leg = lane.start.p != 0.0;
        match part {
            Part::Foot => Some(Choice::from_lowest(span - outer)),
            Part::Head => Some(Choice::to_highest(outer, gap())),
            Part::Leg if has_leg && leg >= SHORT => Some(Choice::to_highest(leg, gap())),
            Part::ShortLeg if has_leg && leg < SHORT => Some(Choice::plain(0.0)),
            Part::Leg | Part::ShortLeg => None,
        }
    }
}

impl Lane {
    fn new(start: &State) -> Lane {
        Lane {
            start: Start::of(start),
            low: [f64::NAN; 2],
            high: [f64::NAN; 2],
            half: Piece::nothing(),
            leg: Piece::nothing(),
            together: true,
        }
    }

    fn add(&mut self, part: Part, piece: Piece<f64>) {
        match part {
            Part::Foot | Part::Head => self.half = self.half + piece,
            Part::Leg | Part::ShortLeg => self.leg = piece,
        }
    }

    fn told(&self) -> ExactTurn {
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
}
