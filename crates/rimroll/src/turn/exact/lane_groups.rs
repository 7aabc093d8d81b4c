//! The starts of a batch, and groups of them in SIMD lanes.

use super::tilt_equation::Conserved;
use super::tilt_equation::Start;
use crate::real::{LANES, Lanes, Packed};
use crate::state::State;

/// One start and the results for it so far.
#[derive(Debug, Clone, Copy)]
pub(super) struct Lane {
    pub(super) start: Start<f64>,
    pub(super) conserved: Conserved<f64>,
    /// tan(φ/2), its logarithm and the singular coefficient at the smallest tilt.
    pub(super) low: [f64; 3],
    /// tan(φ/2) and its logarithm at the largest tilt.
    pub(super) high: [f64; 2],
    /// The smallest and the largest tilt, or the tilt at the end, rad.
    pub(super) tilts: [f64; 2],
    /// Width in η of the [`BalancePassage`](super::balance_passage::BalancePassage) at the balance point, if it topples.
    pub(super) width: f64,
    /// Estimated numbers of nodes for its three segments.
    pub(super) nodes: [f64; 3],
    /// −τ² at the singularity of the integrand, for the two segments that end at the largest tilt.
    pub(super) square: [f64; 2],
    pub(super) class: Class,
    /// Yaw (rad) and time (s) from the smallest tilt to the largest, or to the start if the body topples.
    pub(super) from_lowest: [f64; 2],
    /// Yaw (rad) and time (s) from the start to the largest tilt, or to the end if the body topples.
    pub(super) from_start: [f64; 2],
}

/// The outcome of a start, as far as it is known.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Class {
    /// Unknown; the scalar code handles it.
    NeedsScalar,
    /// It starts past the balance point, or its energy without yaw and spin suffices to reach it.
    AboveBalance,
    /// Neither holds.
    BelowBalance,
    /// Its tilt has a minimum and then a maximum.
    Rocks,
    /// Its tilt has a minimum, and then it passes the balance point.
    Topples,
    /// Its tilt increases from the start until it topples.
    FallsBack,
}

impl Lane {
    pub(super) fn new(start: Start<f64>, class: Class) -> Lane {
        Lane {
            start,
            class,
            conserved: [0.0; 4],
            low: [0.0; 3],
            high: [0.0; 2],
            tilts: [0.0; 2],
            width: 0.0,
            nodes: [0.0; 3],
            square: [0.0; 2],
            from_lowest: [0.0; 2],
            from_start: [0.0; 2],
        }
    }
}

/// Up to sixteen motions in lanes. Unused lanes repeat the first motion.
#[derive(Debug, Clone, Copy)]
pub(super) struct Group {
    pub(super) start: Start<Lanes>,
    pub(super) conserved: Conserved<Lanes>,
    pub(super) low: [Lanes; 3],
    pub(super) high: [Lanes; 2],
    pub(super) width: Lanes,
}

impl Group {
    pub(super) fn of(lanes: &[Lane], which: &[usize]) -> Group {
        let group: [&Lane; LANES] =
            core::array::from_fn(|i| &lanes[*which.get(i).unwrap_or(&which[0])]);
        let all = |number: fn(&Lane) -> f64| {
            let mut lanes = [0.0; LANES];
            for (lane, one) in lanes.iter_mut().zip(group) {
                *lane = number(one);
            }
            Packed(lanes)
        };
        let mut start = group[0].start.map(|&number| Lanes::from(number));
        for (place, lane) in group.iter().enumerate() {
            let put = |number: &f64, lanes: &mut Lanes| lanes.0[place] = *number;
            lane.start.write(&mut start, put);
        }
        Group {
            start,
            conserved: [
                all(|lane| lane.conserved[0]),
                all(|lane| lane.conserved[1]),
                all(|lane| lane.conserved[2]),
                all(|lane| lane.conserved[3]),
            ],
            low: [
                all(|lane| lane.low[0]),
                all(|lane| lane.low[1]),
                all(|lane| lane.low[2]),
            ],
            high: [all(|lane| lane.high[0]), all(|lane| lane.high[1])],
            width: all(|lane| lane.width),
        }
    }
}

/// [tilt, tilt rate, yaw rate, spin rate] of up to sixteen starts. Unused lanes repeat the first start.
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
