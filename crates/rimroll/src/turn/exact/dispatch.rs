//! Sixteen starts at a time under one of the laws, compiled three times: for processors with registers of eight or of
//! four numbers, and for any. The numbers are the same to the last bit.

use super::batch::Lane;
use super::fundamental::Fundamental;
use super::ridge::Balance;
use super::rocking::{Extremes, TurnPart, extremes, part};
use super::rolling::Rolling;
use super::rule::{Choice, Rule};
use super::segments::Integral;
use super::sliding::Sliding;
use super::start::Start;
use super::tilting::{Conserved, Tilting};
use super::toppling::{Stretch, ToppleLimits, Toppling, falling_back, stretch, toppling};
use crate::law::Parameters;
use crate::real::{Bits, LANES, Lanes, Mask, Packed, Real, SimdKernel, Vector, run_widest};

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
trait ReducedBody {
    /// The motion from a start.
    fn from<T: Real>(&self, start: &Start<T>) -> impl Tilting<T>;
    /// A motion that has been looked at before.
    fn again<T: Real>(&self, conserved: Conserved<T>) -> impl Tilting<T>;
    /// Twice the energy over the body at rest upright, but for yaw and spin.
    fn tilting_energy<T: Real>(&self, start: &Start<T>) -> T;
}

impl ReducedBody for Fundamental<f64> {
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

impl ReducedBody for Parameters<f64> {
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
trait Query {
    type Answer;
    fn of<V: Vector>(&self, body: &impl ReducedBody) -> Self::Answer;
}

/// [tilt, tilt rate, yaw rate, spin rate], and the balance point.
struct StartQuery([Lanes; 4], Balance);

impl Query for StartQuery {
    type Answer = (Start<Lanes>, Bits);

    #[inline(always)]
    fn of<V: Vector>(&self, body: &impl ReducedBody) -> (Start<Lanes>, Bits) {
        let StartQuery(given, balance) = self;
        let start = Start::<V>::new(V::load_all(given));
        let short = body.tilting_energy(&start).at_most(V::from(balance.energy));
        let over = !short.and(start.y.at_most(V::from(balance.y)));
        (start.store(), over.bits())
    }
}

struct ExtremesQuery<'a> {
    group: &'a Group,
    most: f64,
    least_slope: f64,
}

impl Query for ExtremesQuery<'_> {
    type Answer = Extremes;

    #[inline(always)]
    fn of<V: Vector>(&self, body: &impl ReducedBody) -> Extremes {
        let start = &Start::<V>::load(&self.group.start);
        let motion = body.from(start);
        extremes(&motion, start, self.most, self.least_slope)
    }
}

struct PieceQuery<'a> {
    group: &'a Group,
    part: TurnPart,
    rule: &'static Rule,
}

impl Query for PieceQuery<'_> {
    type Answer = Integral;

    #[inline(always)]
    fn of<V: Vector>(&self, body: &impl ReducedBody) -> Integral {
        let Group {
            start,
            conserved,
            low,
            high,
            ..
        } = self.group;
        let motion = body.again::<V>(V::load_all(conserved));
        let (start, low, high) = (Start::load(start), V::load_all(low), V::load_all(high));
        part(self.part, &motion, &start, low, high, self.rule).integral(self.rule.nodes.len())
    }
}

struct TopplingQuery<'a> {
    group: &'a Group,
    way: &'a ToppleLimits,
}

impl Query for TopplingQuery<'_> {
    type Answer = Toppling;

    #[inline(always)]
    fn of<V: Vector>(&self, body: &impl ReducedBody) -> Toppling {
        let start = &Start::<V>::load(&self.group.start);
        toppling(&body.from(start), start, self.way)
    }
}

struct FallingBackQuery<'a> {
    group: &'a Group,
    way: &'a ToppleLimits,
}

impl Query for FallingBackQuery<'_> {
    type Answer = Bits;

    #[inline(always)]
    fn of<V: Vector>(&self, body: &impl ReducedBody) -> Bits {
        let start = &Start::<V>::load(&self.group.start);
        falling_back(&body.from(start), start, self.way)
    }
}

struct StretchQuery<'a> {
    group: &'a Group,
    stretch: Stretch,
    way: &'a ToppleLimits,
    rule: &'static Rule,
}

impl Query for StretchQuery<'_> {
    type Answer = Integral;

    #[inline(always)]
    fn of<V: Vector>(&self, body: &impl ReducedBody) -> Integral {
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
        .integral_if_sure(self.rule.nodes.len())
    }
}

impl Engine<'_> {
    /// Starts in the terms of the quadrature, and which of them, as bits, are past the balance point or, but for
    /// yaw and spin, go there; of [tilt, tilt rate, yaw rate, spin rate].
    pub(super) fn start(&self, given: [Lanes; 4], balance: &Balance) -> (Start<Lanes>, Bits) {
        self.answer(&StartQuery(given, *balance))
    }

    pub(super) fn extremes(&self, group: &Group, most: f64, least_slope: f64) -> Extremes {
        self.answer(&ExtremesQuery {
            group,
            most,
            least_slope,
        })
    }

    pub(super) fn part(&self, part: TurnPart, group: &Group, choice: Choice) -> Integral {
        let rule = choice.rule();
        self.answer(&PieceQuery { group, part, rule })
    }

    pub(super) fn toppling(&self, group: &Group, way: &ToppleLimits) -> Toppling {
        self.answer(&TopplingQuery { group, way })
    }

    pub(super) fn falling_back(&self, group: &Group, way: &ToppleLimits) -> Bits {
        self.answer(&FallingBackQuery { group, way })
    }

    pub(super) fn stretch(
        &self,
        stretch: Stretch,
        group: &Group,
        way: &ToppleLimits,
        choice: Choice,
    ) -> Integral {
        let rule = choice.rule();
        self.answer(&StretchQuery {
            group,
            stretch,
            way,
            rule,
        })
    }

    fn answer<A: Query>(&self, query: &A) -> A::Answer {
        run_widest(QueryKernel(self, query))
    }
}

/// Something that is asked of a body.
struct QueryKernel<'a, A>(&'a Engine<'a>, &'a A);

impl<A: Query> SimdKernel for QueryKernel<'_, A> {
    type Done = A::Answer;

    #[inline(always)]
    fn run<V: Vector>(self) -> A::Answer {
        let QueryKernel(engine, query) = self;
        match engine {
            Engine::Rolling(table) => query.of::<V>(*table),
            Engine::Sliding(k) => query.of::<V>(*k),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{
        Engine, ExtremesQuery, FallingBackQuery, Group, PieceQuery, Query, QueryKernel, StartQuery,
        StretchQuery, TopplingQuery,
    };
    use crate::law::IdealLaw;
    use crate::presets;
    use crate::real::{Bits, LANES, in_every_width};
    use crate::state::State;
    use crate::turn::exact::Exact;
    use crate::turn::exact::batch::{Lane, columns};
    use crate::turn::exact::rocking::TurnPart;
    use crate::turn::exact::rule::Choice;
    use crate::turn::exact::toppling::Stretch;
    use core::fmt::Debug;

    /// What is told by registers of each width that the processor has; digits enough for every bit.
    fn integral<A: Query<Answer: Debug>>(engine: &Engine<'_>, query: &A) -> Vec<String> {
        let integral = in_every_width(|| QueryKernel(engine, query));
        integral
            .iter()
            .map(|integral| format!("{integral:?}"))
            .collect()
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
        let same = |integral: Vec<String>| {
            assert!(
                integral.iter().all(|one| *one == integral[0]),
                "{integral:?}"
            )
        };
        for law in [IdealLaw::NoSlip, IdealLaw::Frictionless] {
            let exact = Exact::new(&can, law, 9.8, None).unwrap();
            let way = &exact.way();
            let rule = Choice::plain(20.0).rule();
            let lanes = |rate: f64| Lane::of(&exact, &group(rate));
            let all: Vec<usize> = (0..LANES).collect();

            let engine = exact.rocking_engine();
            let given = columns(&group(-1.0));
            same(integral(&engine, &StartQuery(given, exact.balance)));
            let mut rocking = Group::of(&lanes(-1.0), &all);
            let most = exact.highest();
            let least_slope = exact.least_slope();
            let found = engine.extremes(&rocking, most, least_slope);
            assert_eq!(found.sound, Bits::MAX);
            let group = &rocking;
            let query = ExtremesQuery {
                group,
                most,
                least_slope,
            };
            same(integral(&engine, &query));
            rocking = Group {
                conserved: found.conserved,
                low: found.low,
                high: found.high,
                ..rocking
            };
            let group = &rocking;
            for part in [
                TurnPart::Foot,
                TurnPart::Head,
                TurnPart::Leg,
                TurnPart::ShortLeg,
            ] {
                same(integral(&engine, &PieceQuery { group, part, rule }));
            }

            let engine = exact.passing_engine();
            let mut toppling = Group::of(&lanes(-5.0), &all);
            let found = engine.toppling(&toppling, way);
            assert_eq!(found.sound, Bits::MAX);
            let group = &toppling;
            same(integral(&engine, &TopplingQuery { group, way }));
            toppling = Group {
                conserved: found.conserved,
                low: found.low,
                width: found.width,
                ..toppling
            };
            let group = &toppling;
            for stretch in [Stretch::Foot, Stretch::Approach, Stretch::Rest] {
                let query = StretchQuery {
                    group,
                    stretch,
                    way,
                    rule,
                };
                same(integral(&engine, &query));
            }

            let group = &Group::of(&lanes(4.0), &all);
            assert_eq!(engine.falling_back(group, way), Bits::MAX);
            same(integral(&engine, &FallingBackQuery { group, way }));
        }
    }
}
