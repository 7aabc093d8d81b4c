//! Sixteen starts at a time under one of the laws, compiled three times: for processors with registers of eight or of
//! four numbers, and for any. The numbers are the same to the last bit.

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
use crate::real::{Bits, LANES, Lanes, Mask, Packed, Real, Task, Vector, in_widest};

/// A body under one of the laws.
#[derive(Debug, Clone, Copy)]
pub(super) enum Engine<'a> {
    /// Without slip, by its table.
    Rolling(&'a Fundamental<f64>),
    /// Without friction.
    Sliding(&'a Parameters<f64>),
}

/// Sixteen motions; where there are fewer, the last lanes repeat the first.
#[derive(Debug, Clone, Copy)]
pub(super) struct Group {
    start: Start<Lanes>,
    conserved: Conserved<Lanes>,
    low: [Lanes; 3],
    high: [Lanes; 2],
    width: Lanes,
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
        Group {
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
    fn from<T: Real>(&self, start: &Start<T>) -> impl Tilting<T>;
    /// A motion that has been looked at before.
    fn again<T: Real>(&self, conserved: Conserved<T>) -> impl Tilting<T>;
    /// Twice the energy over the body at rest upright, but for yaw and spin.
    fn tilting_energy<T: Real>(&self, start: &Start<T>) -> T;
}

impl Moved for Fundamental<f64> {
    #[inline(always)]
    fn from<T: Real>(&self, start: &Start<T>) -> impl Tilting<T> {
        Rolling::new(self, start)
    }

    #[inline(always)]
    fn again<T: Real>(&self, conserved: Conserved<T>) -> impl Tilting<T> {
        Rolling::with(self, conserved)
    }

    #[inline(always)]
    fn tilting_energy<T: Real>(&self, start: &Start<T>) -> T {
        Rolling::tilting_energy(self, start)
    }
}

impl Moved for Parameters<f64> {
    #[inline(always)]
    fn from<T: Real>(&self, start: &Start<T>) -> impl Tilting<T> {
        Sliding::new(*self, start)
    }

    #[inline(always)]
    fn again<T: Real>(&self, conserved: Conserved<T>) -> impl Tilting<T> {
        Sliding::with(*self, conserved)
    }

    #[inline(always)]
    fn tilting_energy<T: Real>(&self, start: &Start<T>) -> T {
        Sliding::tilting_energy(self, start)
    }
}

/// What is asked of sixteen starts.
trait Asked {
    type Told;
    fn of<V: Vector>(&self, body: &impl Moved) -> Self::Told;
}

/// [tilt, tilt rate, yaw rate, spin rate], and the balance point.
struct AskStart([Lanes; 4], Balance);

impl Asked for AskStart {
    type Told = (Start<Lanes>, Bits);

    #[inline(always)]
    fn of<V: Vector>(&self, body: &impl Moved) -> (Start<Lanes>, Bits) {
        let AskStart(given, balance) = self;
        let start = Start::<V>::new(V::load_all(given));
        let short = body.tilting_energy(&start).at_most(V::from(balance.energy));
        let over = !short.and(start.y.at_most(V::from(balance.y)));
        (start.store(), over.bits())
    }
}

struct AskExtremes<'a> {
    group: &'a Group,
    most: f64,
    least_slope: f64,
}

impl Asked for AskExtremes<'_> {
    type Told = Extremes;

    #[inline(always)]
    fn of<V: Vector>(&self, body: &impl Moved) -> Extremes {
        let start = &Start::<V>::load(&self.group.start);
        let motion = body.from(start);
        extremes(&motion, start, self.most, self.least_slope)
    }
}

struct AskPart<'a> {
    group: &'a Group,
    part: Part,
    rule: &'static Rule,
}

impl Asked for AskPart<'_> {
    type Told = Told;

    #[inline(always)]
    fn of<V: Vector>(&self, body: &impl Moved) -> Told {
        let Group {
            start,
            conserved,
            low,
            high,
            ..
        } = self.group;
        let motion = body.again::<V>(V::load_all(conserved));
        let (start, low, high) = (Start::load(start), V::load_all(low), V::load_all(high));
        part(self.part, &motion, &start, low, high, self.rule).told(self.rule.nodes.len())
    }
}

struct AskPassing<'a> {
    group: &'a Group,
    way: &'a Way,
}

impl Asked for AskPassing<'_> {
    type Told = Passing;

    #[inline(always)]
    fn of<V: Vector>(&self, body: &impl Moved) -> Passing {
        let start = &Start::<V>::load(&self.group.start);
        passing(&body.from(start), start, self.way)
    }
}

struct AskFallingBack<'a> {
    group: &'a Group,
    way: &'a Way,
}

impl Asked for AskFallingBack<'_> {
    type Told = Bits;

    #[inline(always)]
    fn of<V: Vector>(&self, body: &impl Moved) -> Bits {
        let start = &Start::<V>::load(&self.group.start);
        falling_back(&body.from(start), start, self.way)
    }
}

struct AskStretch<'a> {
    group: &'a Group,
    stretch: Stretch,
    way: &'a Way,
    rule: &'static Rule,
}

impl Asked for AskStretch<'_> {
    type Told = Told;

    #[inline(always)]
    fn of<V: Vector>(&self, body: &impl Moved) -> Told {
        let Group {
            start,
            conserved,
            low,
            width,
            ..
        } = self.group;
        let motion = body.again::<V>(V::load_all(conserved));
        stretch(
            self.stretch,
            &motion,
            &Start::load(start),
            V::load_all(low),
            V::load(width),
            self.way,
            self.rule,
        )
        .surely_told(self.rule.nodes.len())
    }
}

impl Engine<'_> {
    /// Starts in the terms of the quadrature, and which of them, as bits, are past the balance point or, but for
    /// yaw and spin, go there; of [tilt, tilt rate, yaw rate, spin rate].
    pub(super) fn start(&self, given: [Lanes; 4], balance: &Balance) -> (Start<Lanes>, Bits) {
        self.ask(&AskStart(given, *balance))
    }

    pub(super) fn extremes(&self, group: &Group, most: f64, least_slope: f64) -> Extremes {
        self.ask(&AskExtremes {
            group,
            most,
            least_slope,
        })
    }

    pub(super) fn part(&self, part: Part, group: &Group, choice: Choice) -> Told {
        let rule = choice.rule();
        self.ask(&AskPart { group, part, rule })
    }

    pub(super) fn passing(&self, group: &Group, way: &Way) -> Passing {
        self.ask(&AskPassing { group, way })
    }

    pub(super) fn falling_back(&self, group: &Group, way: &Way) -> Bits {
        self.ask(&AskFallingBack { group, way })
    }

    pub(super) fn stretch(
        &self,
        stretch: Stretch,
        group: &Group,
        way: &Way,
        choice: Choice,
    ) -> Told {
        let rule = choice.rule();
        self.ask(&AskStretch {
            group,
            stretch,
            way,
            rule,
        })
    }

    fn ask<A: Asked>(&self, asked: &A) -> A::Told {
        in_widest(Asking(self, asked))
    }
}

/// Something that is asked of a body.
struct Asking<'a, A>(&'a Engine<'a>, &'a A);

impl<A: Asked> Task for Asking<'_, A> {
    type Done = A::Told;

    #[inline(always)]
    fn run<V: Vector>(self) -> A::Told {
        let Asking(engine, asked) = self;
        match engine {
            Engine::Rolling(table) => asked.of::<V>(*table),
            Engine::Sliding(k) => asked.of::<V>(*k),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{
        AskExtremes, AskFallingBack, AskPart, AskPassing, AskStart, AskStretch, Asked, Asking,
        Engine, Group,
    };
    use crate::law::IdealLaw;
    use crate::presets;
    use crate::real::{Bits, LANES, in_every_width};
    use crate::state::State;
    use crate::turn::exact::Exact;
    use crate::turn::exact::many::{Lane, columns};
    use crate::turn::exact::passing::Stretch;
    use crate::turn::exact::rule::Choice;
    use crate::turn::exact::together::Part;
    use core::fmt::Debug;

    /// What is told by registers of each width that the processor has; digits enough for every bit.
    fn told<A: Asked<Told: Debug>>(engine: &Engine<'_>, asked: &A) -> Vec<String> {
        let told = in_every_width(|| Asking(engine, asked));
        told.iter().map(|told| format!("{told:?}")).collect()
    }

    fn group(tilt_rate: f64) -> [State; LANES] {
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
            let lanes = |rate: f64| Lane::of(&exact, &group(rate));
            let all: Vec<usize> = (0..LANES).collect();

            let engine = exact.rocking_engine();
            let given = columns(&group(-1.0));
            same(told(&engine, &AskStart(given, exact.balance)));
            let mut rocking = Group::of(&lanes(-1.0), &all);
            let most = exact.highest();
            let least_slope = exact.least_slope();
            let found = engine.extremes(&rocking, most, least_slope);
            assert_eq!(found.sound, Bits::MAX);
            let group = &rocking;
            let asked = AskExtremes {
                group,
                most,
                least_slope,
            };
            same(told(&engine, &asked));
            rocking = Group {
                conserved: found.conserved,
                low: found.low,
                high: found.high,
                ..rocking
            };
            let group = &rocking;
            for part in [Part::Foot, Part::Head, Part::Leg, Part::ShortLeg] {
                same(told(&engine, &AskPart { group, part, rule }));
            }

            let engine = exact.passing_engine();
            let mut passing = Group::of(&lanes(-5.0), &all);
            let found = engine.passing(&passing, way);
            assert_eq!(found.sound, Bits::MAX);
            let group = &passing;
            same(told(&engine, &AskPassing { group, way }));
            passing = Group {
                conserved: found.conserved,
                low: found.low,
                width: found.width,
                ..passing
            };
            let group = &passing;
            for stretch in [Stretch::Foot, Stretch::Approach, Stretch::Rest] {
                let asked = AskStretch {
                    group,
                    stretch,
                    way,
                    rule,
                };
                same(told(&engine, &asked));
            }

            let group = &Group::of(&lanes(4.0), &all);
            assert_eq!(engine.falling_back(group, way), Bits::MAX);
            same(told(&engine, &AskFallingBack { group, way }));
        }
    }
}
