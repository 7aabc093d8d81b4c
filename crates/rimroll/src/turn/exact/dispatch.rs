//! Eight starts at a time under one of the laws, compiled three times: as it is, and for
//! processors with registers of four or eight numbers. The numbers are the same to the last bit.

use super::fundamental::Fundamental;
use super::many::Lane;
use super::passing::{Passing, Stretch, Way, falling_back, passing, stretch};
use super::pieces::Told;
use super::ridge::Balance;
use super::rolling::Rolling;
use super::rule::{Choice, Rule};
use super::sliding::Sliding;
use super::start::Start;
use super::tilting::{Conserved, Tilting};
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

/// Eight motions; where there are fewer, the last lanes repeat the first.
#[derive(Debug, Clone, Copy)]
pub(super) struct Eight {
    start: Start<Lanes>,
    conserved: Conserved<Lanes>,
    low: [Lanes; 3],
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

/// A body under one of the laws, as the compiler knows it.
trait Moved {
    /// The motion from a start.
    fn from(&self, start: &Start<Lanes>) -> impl Tilting<Lanes>;
    /// A motion that has been looked at before.
    fn again(&self, conserved: Conserved<Lanes>) -> impl Tilting<Lanes>;
    /// Twice the energy over the body at rest upright, but for yaw and spin.
    fn tilting_energy(&self, start: &Start<Lanes>) -> Lanes;
}

impl Moved for Fundamental<f64> {
    #[inline(always)]
    fn from(&self, start: &Start<Lanes>) -> impl Tilting<Lanes> {
        Rolling::new(self, start)
    }

    #[inline(always)]
    fn again(&self, conserved: Conserved<Lanes>) -> impl Tilting<Lanes> {
        Rolling::with(self, conserved)
    }

    #[inline(always)]
    fn tilting_energy(&self, start: &Start<Lanes>) -> Lanes {
        Rolling::tilting_energy(self, start)
    }
}

impl Moved for Parameters<f64> {
    #[inline(always)]
    fn from(&self, start: &Start<Lanes>) -> impl Tilting<Lanes> {
        Sliding::new(*self, start)
    }

    #[inline(always)]
    fn again(&self, conserved: Conserved<Lanes>) -> impl Tilting<Lanes> {
        Sliding::with(*self, conserved)
    }

    #[inline(always)]
    fn tilting_energy(&self, start: &Start<Lanes>) -> Lanes {
        Sliding::tilting_energy(self, start)
    }
}

/// What is asked of eight starts.
trait Asked {
    type Told;
    fn of(&self, body: &impl Moved) -> Self::Told;
}

/// [tilt, tilt rate, yaw rate, spin rate], and the balance point.
struct AskStart([Lanes; 4], Balance);

impl Asked for AskStart {
    type Told = (Start<Lanes>, Mask);

    #[inline(always)]
    fn of(&self, body: &impl Moved) -> (Start<Lanes>, Mask) {
        let AskStart(given, balance) = self;
        let start = Start::new(*given);
        let short = body
            .tilting_energy(&start)
            .at_most(Lanes::from(balance.energy));
        (start, !short.and(start.y.at_most(Lanes::from(balance.y))))
    }
}

struct AskExtremes<'a> {
    eight: &'a Eight,
    most: f64,
    least_slope: f64,
}

impl Asked for AskExtremes<'_> {
    type Told = Extremes;

    #[inline(always)]
    fn of(&self, body: &impl Moved) -> Extremes {
        let start = &self.eight.start;
        extremes(&body.from(start), start, self.most, self.least_slope)
    }
}

struct AskPart<'a> {
    eight: &'a Eight,
    part: Part,
    rule: &'static Rule,
}

impl Asked for AskPart<'_> {
    type Told = Told;

    #[inline(always)]
    fn of(&self, body: &impl Moved) -> Told {
        let Eight {
            start,
            conserved,
            low,
            high,
            ..
        } = self.eight;
        let motion = body.again(*conserved);
        part(self.part, &motion, start, *low, *high, self.rule).told(self.rule.nodes.len())
    }
}

struct AskPassing<'a> {
    eight: &'a Eight,
    way: &'a Way,
}

impl Asked for AskPassing<'_> {
    type Told = Passing;

    #[inline(always)]
    fn of(&self, body: &impl Moved) -> Passing {
        let start = &self.eight.start;
        passing(&body.from(start), start, self.way)
    }
}

struct AskFallingBack<'a> {
    eight: &'a Eight,
    way: &'a Way,
}

impl Asked for AskFallingBack<'_> {
    type Told = Mask;

    #[inline(always)]
    fn of(&self, body: &impl Moved) -> Mask {
        let start = &self.eight.start;
        falling_back(&body.from(start), start, self.way)
    }
}

struct AskStretch<'a> {
    eight: &'a Eight,
    stretch: Stretch,
    way: &'a Way,
    rule: &'static Rule,
}

impl Asked for AskStretch<'_> {
    type Told = Told;

    #[inline(always)]
    fn of(&self, body: &impl Moved) -> Told {
        let Eight {
            start,
            conserved,
            low,
            width,
            ..
        } = self.eight;
        let motion = body.again(*conserved);
        stretch(
            self.stretch,
            &motion,
            start,
            *low,
            *width,
            self.way,
            self.rule,
        )
        .surely_told(self.rule.nodes.len())
    }
}

impl Engine<'_> {
    /// Starts in the terms of the quadrature, and which of them are past the balance point or, but for yaw and
    /// spin, go there; of [tilt, tilt rate, yaw rate, spin rate].
    pub(super) fn start(&self, given: [Lanes; 4], balance: &Balance) -> (Start<Lanes>, Mask) {
        self.ask(&AskStart(given, *balance))
    }

    pub(super) fn extremes(&self, eight: &Eight, most: f64, least_slope: f64) -> Extremes {
        self.ask(&AskExtremes {
            eight,
            most,
            least_slope,
        })
    }

    pub(super) fn part(&self, part: Part, eight: &Eight, choice: Choice) -> Told {
        let rule = choice.rule();
        self.ask(&AskPart { eight, part, rule })
    }

    pub(super) fn passing(&self, eight: &Eight, way: &Way) -> Passing {
        self.ask(&AskPassing { eight, way })
    }

    pub(super) fn falling_back(&self, eight: &Eight, way: &Way) -> Mask {
        self.ask(&AskFallingBack { eight, way })
    }

    pub(super) fn stretch(
        &self,
        stretch: Stretch,
        eight: &Eight,
        way: &Way,
        choice: Choice,
    ) -> Told {
        let rule = choice.rule();
        self.ask(&AskStretch {
            eight,
            stretch,
            way,
            rule,
        })
    }

    fn ask<A: Asked>(&self, asked: &A) -> A::Told {
        #[cfg(target_arch = "x86_64")]
        if std::arch::is_x86_feature_detected!("avx512f")
            && std::arch::is_x86_feature_detected!("avx512dq")
        {
            // SAFETY: the processor has what the function is compiled for.
            return unsafe { self.ask_by_avx512(asked) };
        }
        #[cfg(target_arch = "x86_64")]
        if std::arch::is_x86_feature_detected!("avx2") {
            // SAFETY: the processor has what the function is compiled for.
            return unsafe { self.ask_by_avx2(asked) };
        }
        self.ask_anywhere(asked)
    }

    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx512f,avx512dq")]
    fn ask_by_avx512<A: Asked>(&self, asked: &A) -> A::Told {
        self.ask_anywhere(asked)
    }

    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx2")]
    fn ask_by_avx2<A: Asked>(&self, asked: &A) -> A::Told {
        self.ask_anywhere(asked)
    }

    #[inline(always)]
    fn ask_anywhere<A: Asked>(&self, asked: &A) -> A::Told {
        match self {
            Engine::Rolling(table) => asked.of(*table),
            Engine::Sliding(k) => asked.of(*k),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{
        AskExtremes, AskFallingBack, AskPart, AskPassing, AskStart, AskStretch, Asked, Eight,
        Engine,
    };
    use crate::law::IdealLaw;
    use crate::presets;
    use crate::real::LANES;
    use crate::state::State;
    use crate::turn::exact::Exact;
    use crate::turn::exact::many::{Lane, columns};
    use crate::turn::exact::passing::Stretch;
    use crate::turn::exact::rule::Choice;
    use crate::turn::exact::together::Part;
    use core::fmt::Debug;

    /// What is told by registers of each width that the processor has; digits enough for every bit.
    fn told<A: Asked<Told: Debug>>(engine: &Engine<'_>, asked: &A) -> Vec<String> {
        let mut told = vec![format!("{:?}", engine.ask_anywhere(asked))];
        #[cfg(target_arch = "x86_64")]
        if std::arch::is_x86_feature_detected!("avx2") {
            // SAFETY: the processor has what the function is compiled for.
            told.push(format!("{:?}", unsafe { engine.ask_by_avx2(asked) }));
        }
        #[cfg(target_arch = "x86_64")]
        if std::arch::is_x86_feature_detected!("avx512f")
            && std::arch::is_x86_feature_detected!("avx512dq")
        {
            // SAFETY: the processor has what the function is compiled for.
            told.push(format!("{:?}", unsafe { engine.ask_by_avx512(asked) }));
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
            let lanes = |rate: f64| Lane::of(&exact, &eight(rate));
            let all: Vec<usize> = (0..LANES).collect();

            let engine = exact.rocking_engine();
            let given = columns(&eight(-1.0));
            same(told(&engine, &AskStart(given, exact.balance)));
            let mut rocking = Eight::of(&lanes(-1.0), &all);
            let most = exact.highest();
            let least_slope = exact.least_slope();
            let found = engine.extremes(&rocking, most, least_slope);
            assert_eq!(found.sound.bits(), u8::MAX);
            let eight = &rocking;
            let asked = AskExtremes {
                eight,
                most,
                least_slope,
            };
            same(told(&engine, &asked));
            rocking = Eight {
                conserved: found.conserved,
                low: found.low,
                high: found.high,
                ..rocking
            };
            let eight = &rocking;
            for part in [Part::Foot, Part::Head, Part::Leg, Part::ShortLeg] {
                same(told(&engine, &AskPart { eight, part, rule }));
            }

            let engine = exact.passing_engine();
            let mut passing = Eight::of(&lanes(-5.0), &all);
            let found = engine.passing(&passing, way);
            assert_eq!(found.sound.bits(), u8::MAX);
            let eight = &passing;
            same(told(&engine, &AskPassing { eight, way }));
            passing = Eight {
                conserved: found.conserved,
                low: found.low,
                width: found.width,
                ..passing
            };
            let eight = &passing;
            for stretch in [Stretch::Foot, Stretch::Approach, Stretch::Rest] {
                let asked = AskStretch {
                    eight,
                    stretch,
                    way,
                    rule,
                };
                same(told(&engine, &asked));
            }

            let eight = &Eight::of(&lanes(4.0), &all);
            assert_eq!(engine.falling_back(eight, way).bits(), u8::MAX);
            same(told(&engine, &AskFallingBack { eight, way }));
        }
    }
}
