//! Eight starts at a time under one of the laws, compiled three times: as it is, and for
//! processors with registers of four or eight numbers. The numbers are the same to the last bit.

use super::fundamental::Fundamental;
use super::many::Lane;
use super::passing::{Passing, Stretch, Way, falling_back, passing, stretch};
use super::pieces::Piece;
use super::rolling::Rolling;
use super::rule::{Choice, Rule};
use super::sliding::Sliding;
use super::start::Start;
use super::tilting::Tilting;
use super::together::{Extremes, Part, extremes, part};
use crate::law::Parameters;
use crate::real::{LANES, Lanes, Mask};

/// A body under one of the laws.
#[derive(Debug, Clone, Copy)]
pub(super) enum Engine<'a> {
    /// Without slip, by its table.
    Rolling(&'a Fundamental<f64>),
    /// Without friction.
    Sliding(&'a Parameters<f64>),
}

/// Eight starts; where there are fewer, the last lanes repeat the first.
#[derive(Debug, Clone, Copy)]
pub(super) struct Eight {
    start: Start<Lanes>,
    low: [Lanes; 2],
    high: [Lanes; 2],
    width: Lanes,
}

impl Eight {
    pub(super) fn of(lanes: &[Lane], which: &[usize]) -> Eight {
        let eight: [&Lane; LANES] =
            core::array::from_fn(|i| &lanes[*which.get(i).unwrap_or(&which[0])]);
        let all = |number: fn(&Lane) -> f64| {
            let mut lanes = [0.0; LANES];
            for (lane, one) in lanes.iter_mut().zip(eight) {
                *lane = number(one);
            }
            Lanes(lanes)
        };
        Eight {
            start: Start {
                y: all(|lane| lane.start.y),
                eta: all(|lane| lane.start.eta),
                p: all(|lane| lane.start.p),
                w: all(|lane| lane.start.w),
                s: all(|lane| lane.start.s),
            },
            low: [all(|lane| lane.low[0]), all(|lane| lane.low[1])],
            high: [all(|lane| lane.high[0]), all(|lane| lane.high[1])],
            width: all(|lane| lane.width),
        }
    }
}

/// What is asked of eight starts.
trait Asked {
    type Told;
    fn of(&self, motion: &impl Tilting<Lanes>, eight: &Eight) -> Self::Told;
}

struct AskExtremes {
    most: f64,
    least_slope: f64,
}

impl Asked for AskExtremes {
    type Told = Extremes;

    #[inline(always)]
    fn of(&self, motion: &impl Tilting<Lanes>, eight: &Eight) -> Extremes {
        extremes(motion, &eight.start, self.most, self.least_slope)
    }
}

struct AskPart {
    part: Part,
    rule: &'static Rule,
}

impl Asked for AskPart {
    type Told = Piece<Lanes>;

    #[inline(always)]
    fn of(&self, motion: &impl Tilting<Lanes>, eight: &Eight) -> Piece<Lanes> {
        part(
            self.part,
            motion,
            &eight.start,
            eight.low,
            eight.high,
            self.rule,
        )
    }
}

struct AskPassing<'a> {
    way: &'a Way,
}

impl Asked for AskPassing<'_> {
    type Told = Passing;

    #[inline(always)]
    fn of(&self, motion: &impl Tilting<Lanes>, eight: &Eight) -> Passing {
        passing(motion, &eight.start, self.way)
    }
}

struct AskFallingBack<'a> {
    way: &'a Way,
}

impl Asked for AskFallingBack<'_> {
    type Told = Mask;

    #[inline(always)]
    fn of(&self, motion: &impl Tilting<Lanes>, eight: &Eight) -> Mask {
        falling_back(motion, &eight.start, self.way)
    }
}

struct AskStretch<'a> {
    stretch: Stretch,
    way: &'a Way,
    rule: &'static Rule,
}

impl Asked for AskStretch<'_> {
    type Told = Piece<Lanes>;

    #[inline(always)]
    fn of(&self, motion: &impl Tilting<Lanes>, eight: &Eight) -> Piece<Lanes> {
        let Eight {
            start, low, width, ..
        } = eight;
        stretch(
            self.stretch,
            motion,
            start,
            *low,
            *width,
            self.way,
            self.rule,
        )
    }
}

impl Engine<'_> {
    pub(super) fn extremes(&self, eight: &Eight, most: f64, least_slope: f64) -> Extremes {
        self.ask(&AskExtremes { most, least_slope }, eight)
    }

    pub(super) fn part(&self, part: Part, eight: &Eight, choice: Choice) -> Piece<Lanes> {
        let rule = choice.rule();
        self.ask(&AskPart { part, rule }, eight)
    }

    pub(super) fn passing(&self, eight: &Eight, way: &Way) -> Passing {
        self.ask(&AskPassing { way }, eight)
    }

    pub(super) fn falling_back(&self, eight: &Eight, way: &Way) -> Mask {
        self.ask(&AskFallingBack { way }, eight)
    }

    pub(super) fn stretch(
        &self,
        stretch: Stretch,
        eight: &Eight,
        way: &Way,
        choice: Choice,
    ) -> Piece<Lanes> {
        let rule = choice.rule();
        self.ask(&AskStretch { stretch, way, rule }, eight)
    }

    fn ask<A: Asked>(&self, asked: &A, eight: &Eight) -> A::Told {
        #[cfg(target_arch = "x86_64")]
        if std::arch::is_x86_feature_detected!("avx512f")
            && std::arch::is_x86_feature_detected!("avx512dq")
        {
            // SAFETY: the processor has what the function is compiled for.
            return unsafe { self.ask_by_avx512(asked, eight) };
        }
        #[cfg(target_arch = "x86_64")]
        if std::arch::is_x86_feature_detected!("avx2") {
            // SAFETY: the processor has what the function is compiled for.
            return unsafe { self.ask_by_avx2(asked, eight) };
        }
        self.ask_anywhere(asked, eight)
    }

    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx512f,avx512dq")]
    fn ask_by_avx512<A: Asked>(&self, asked: &A, eight: &Eight) -> A::Told {
        self.ask_anywhere(asked, eight)
    }

    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx2")]
    fn ask_by_avx2<A: Asked>(&self, asked: &A, eight: &Eight) -> A::Told {
        self.ask_anywhere(asked, eight)
    }

    #[inline(always)]
    fn ask_anywhere<A: Asked>(&self, asked: &A, eight: &Eight) -> A::Told {
        match self {
            Engine::Rolling(table) => asked.of(&Rolling::new(table, &eight.start), eight),
            Engine::Sliding(k) => asked.of(&Sliding::new(**k, &eight.start), eight),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{
        AskExtremes, AskFallingBack, AskPart, AskPassing, AskStretch, Asked, Eight, Engine,
    };
    use crate::law::IdealLaw;
    use crate::presets;
    use crate::real::LANES;
    use crate::state::State;
    use crate::turn::exact::Exact;
    use crate::turn::exact::many::Lane;
    use crate::turn::exact::passing::Stretch;
    use crate::turn::exact::rule::Choice;
    use crate::turn::exact::together::Part;
    use core::fmt::Debug;

    /// What is told by registers of each width that the processor has; digits enough for every bit.
    fn told<A: Asked<Told: Debug>>(engine: &Engine<'_>, asked: &A, eight: &Eight) -> Vec<String> {
        let mut told = vec![format!("{:?}", engine.ask_anywhere(asked, eight))];
        #[cfg(target_arch = "x86_64")]
        if std::arch::is_x86_feature_detected!("avx2") {
            // SAFETY: the processor has what the function is compiled for.
            told.push(format!("{:?}", unsafe { engine.ask_by_avx2(asked, eight) }));
        }
        #[cfg(target_arch = "x86_64")]
        if std::arch::is_x86_feature_detected!("avx512f")
            && std::arch::is_x86_feature_detected!("avx512dq")
        {
            // SAFETY: the processor has what the function is compiled for.
            told.push(format!("{:?}", unsafe {
                engine.ask_by_avx512(asked, eight)
            }));
        }
        told
    }

    fn eight(tilt_rate: f64) -> [State; LANES] {
        core::array::from_fn(|i| State {
            tilt: 0.3 + 0.01 * i as f64,
            tilt_rate,
            yaw_rate: 0.3 - 0.07 * i as f64,
            spin_rate: 0.1 * i as f64,
            ..State::default()
        })
    }

    #[test]
    fn registers_of_every_width_tell_the_same_bits() {
        let can = presets::can_2007().unwrap();
        let same = |told: Vec<String>| assert!(told.iter().all(|one| *one == told[0]), "{told:?}");
        for law in [IdealLaw::NoSlip, IdealLaw::Frictionless] {
            let exact = Exact::new(&can, law, 9.8, None).unwrap();
            let way = &exact.way();
            let rule = Choice::plain(20.0).rule();
            let lanes = |rate: f64| eight(rate).map(|start| Lane::new(&start));
            let all: Vec<usize> = (0..LANES).collect();

            let engine = exact.rocking_engine();
            let mut rocking = Eight::of(&lanes(-1.0), &all);
            let most = exact.highest();
            let least_slope = exact.least_slope();
            let found = engine.extremes(&rocking, most, least_slope);
            assert_eq!(found.sound.bits(), u8::MAX);
            same(told(&engine, &AskExtremes { most, least_slope }, &rocking));
            (rocking.low, rocking.high) = (found.low.place(), found.high.place());
            for part in [Part::Foot, Part::Head, Part::Leg, Part::ShortLeg] {
                same(told(&engine, &AskPart { part, rule }, &rocking));
            }

            let engine = exact.passing_engine();
            let mut passing = Eight::of(&lanes(-5.0), &all);
            let found = engine.passing(&passing, way);
            assert_eq!(found.sound.bits(), u8::MAX);
            same(told(&engine, &AskPassing { way }, &passing));
            (passing.low, passing.width) = (found.low.place(), found.width);
            for stretch in [Stretch::Foot, Stretch::Approach, Stretch::Rest] {
                same(told(&engine, &AskStretch { stretch, way, rule }, &passing));
            }

            let falling_back = Eight::of(&lanes(4.0), &all);
            assert_eq!(engine.falling_back(&falling_back, way).bits(), u8::MAX);
            same(told(&engine, &AskFallingBack { way }, &falling_back));
        }
    }
}
