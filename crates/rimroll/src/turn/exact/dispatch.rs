//! Dispatch of the computations on sixteen starts by law and by register width. Each is compiled three times:
//! for registers of eight and of four numbers, and for any processor. The results are equal to the last bit.

use super::balance_passage::Balance;
use super::frictionless::FrictionlessTilt;
use super::fundamental_solutions::Fundamental;
use super::lane_groups::Group;
use super::no_slip::NoSlipTilt;
use super::quadrature_rule::Rule;
use super::rocking_batch::{Extremes, TurnPart, extremes, turn_part};
use super::segments::Integral;
use super::tilt_equation::Start;
use super::tilt_equation::{Conserved, TiltEquation};
use super::toppling_batch::{
    ToppleLimits, TopplePart, Toppling, falling_back, topple_part, toppling,
};
use crate::law::Parameters;
use crate::real::{Bits, Lanes, Mask, Real, SimdKernel, Vector, run_widest};

/// A body under one of the ideal laws, selected at run time.
#[derive(Debug, Clone, Copy)]
pub(super) enum Engine<'a> {
    /// No slip, with the table of the body.
    NoSlip(&'a Fundamental<f64>),
    /// Frictionless.
    Frictionless(&'a Parameters<f64>),
}

/// A body under one of the ideal laws, selected at compile time.
pub(super) trait ReducedBody {
    /// The motion from a start.
    fn motion_from<T: Real>(&self, start: &Start<T>) -> impl TiltEquation<T>;
    /// The motion with known conserved quantities.
    fn motion_with<T: Real>(&self, conserved: Conserved<T>) -> impl TiltEquation<T>;
    /// Twice the energy relative to the body at rest upright, without that of yaw and spin, J.
    fn tilting_energy<T: Real>(&self, start: &Start<T>) -> T;
}

impl ReducedBody for Fundamental<f64> {
    #[inline(always)]
    fn motion_from<T: Real>(&self, start: &Start<T>) -> impl TiltEquation<T> {
        NoSlipTilt::new(self, start)
    }

    #[inline(always)]
    fn motion_with<T: Real>(&self, conserved: Conserved<T>) -> impl TiltEquation<T> {
        NoSlipTilt::from_conserved(self, conserved)
    }

    #[inline(always)]
    fn tilting_energy<T: Real>(&self, start: &Start<T>) -> T {
        NoSlipTilt::tilting_energy(self, start)
    }
}

impl ReducedBody for Parameters<f64> {
    #[inline(always)]
    fn motion_from<T: Real>(&self, start: &Start<T>) -> impl TiltEquation<T> {
        FrictionlessTilt::new(*self, start)
    }

    #[inline(always)]
    fn motion_with<T: Real>(&self, conserved: Conserved<T>) -> impl TiltEquation<T> {
        FrictionlessTilt::from_conserved(*self, conserved)
    }

    #[inline(always)]
    fn tilting_energy<T: Real>(&self, start: &Start<T>) -> T {
        FrictionlessTilt::tilting_energy(self, start)
    }
}

/// A computation on sixteen starts.
pub(super) trait Query {
    type Answer;
    fn of<V: Vector>(&self, body: &impl ReducedBody) -> Self::Answer;
}

/// Converts starts given as [tilt, tilt rate, yaw rate, spin rate] to the variables of the quadrature. The bits mark the
/// lanes that start past the balance point or whose energy without yaw and spin suffices to reach it.
pub(super) struct StartQuery(pub(super) [Lanes; 4], pub(super) Balance);

impl Query for StartQuery {
    type Answer = (Start<Lanes>, Bits);

    #[inline(always)]
    fn of<V: Vector>(&self, body: &impl ReducedBody) -> (Start<Lanes>, Bits) {
        let StartQuery(given, balance) = self;
        let start = Start::<V>::new(V::load_all(given));
        let short = body.tilting_energy(&start).at_most(V::from(balance.energy));
        let over = !short.and(start.y.at_most(V::from(balance.y)));
        (start.map(|number| number.store()), over.bits())
    }
}

/// [`extremes`] of a group.
pub(super) struct ExtremesQuery<'a> {
    pub(super) group: &'a Group,
    pub(super) max_y: f64,
    pub(super) min_slope: f64,
}

impl Query for ExtremesQuery<'_> {
    type Answer = Extremes;

    #[inline(always)]
    fn of<V: Vector>(&self, body: &impl ReducedBody) -> Extremes {
        let start = &self.group.start.map(V::load);
        let motion = body.motion_from(start);
        extremes(&motion, start, self.max_y, self.min_slope)
    }
}

/// [`turn_part`] of a group, integrated.
pub(super) struct TurnPartQuery<'a> {
    pub(super) group: &'a Group,
    pub(super) part: TurnPart,
    pub(super) rule: &'static Rule,
}

impl Query for TurnPartQuery<'_> {
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
        let motion = body.motion_with::<V>(V::load_all(conserved));
        let (start, low, high) = (start.map(V::load), V::load_all(low), V::load_all(high));
        turn_part(self.part, &motion, &start, low, high, self.rule).integral(self.rule.nodes.len())
    }
}

/// [`toppling`] of a group.
pub(super) struct TopplingQuery<'a> {
    pub(super) group: &'a Group,
    pub(super) limits: &'a ToppleLimits,
}

impl Query for TopplingQuery<'_> {
    type Answer = Toppling;

    #[inline(always)]
    fn of<V: Vector>(&self, body: &impl ReducedBody) -> Toppling {
        let start = &self.group.start.map(V::load);
        toppling(&body.motion_from(start), start, self.limits)
    }
}

/// [`falling_back`] of a group.
pub(super) struct FallingBackQuery<'a> {
    pub(super) group: &'a Group,
    pub(super) limits: &'a ToppleLimits,
}

impl Query for FallingBackQuery<'_> {
    type Answer = Bits;

    #[inline(always)]
    fn of<V: Vector>(&self, body: &impl ReducedBody) -> Bits {
        let start = &self.group.start.map(V::load);
        falling_back(&body.motion_from(start), start, self.limits)
    }
}

/// [`topple_part`] of a group, integrated.
pub(super) struct TopplePartQuery<'a> {
    pub(super) group: &'a Group,
    pub(super) part: TopplePart,
    pub(super) limits: &'a ToppleLimits,
    pub(super) rule: &'static Rule,
}

impl Query for TopplePartQuery<'_> {
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
        let motion = body.motion_with::<V>(V::load_all(conserved));
        topple_part(
            self.part,
            &motion,
            &start.map(V::load),
            V::load_all(low),
            V::load(width),
            self.limits,
            self.rule,
        )
        .conservative_integral(self.rule.nodes.len())
    }
}

impl Engine<'_> {
    /// The answer for this body, in the widest registers.
    pub(super) fn answer<A: Query>(&self, query: &A) -> A::Answer {
        run_widest(QueryKernel(self, query))
    }
}

/// A query to an engine, as a kernel for any register width.
struct QueryKernel<'a, A>(&'a Engine<'a>, &'a A);

impl<A: Query> SimdKernel for QueryKernel<'_, A> {
    type Done = A::Answer;

    #[inline(always)]
    fn run<V: Vector>(self) -> A::Answer {
        let QueryKernel(engine, query) = self;
        match engine {
            Engine::NoSlip(table) => query.of::<V>(*table),
            Engine::Frictionless(k) => query.of::<V>(*k),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{
        Engine, ExtremesQuery, FallingBackQuery, Group, Query, QueryKernel, StartQuery,
        TopplePartQuery, TopplingQuery, TurnPartQuery,
    };
    use crate::law::IdealLaw;
    use crate::presets;
    use crate::real::{Bits, LANES, in_every_width};
    use crate::state::State;
    use crate::turn::exact::Exact;
    use crate::turn::exact::lane_groups::{Lane, columns};
    use crate::turn::exact::quadrature_rule::Choice;
    use crate::turn::exact::rocking_batch::TurnPart;
    use crate::turn::exact::toppling_batch::TopplePart;
    use core::fmt::Debug;

    /// The results in registers of each width that the processor has, printed with enough digits to identify
    /// every bit.
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
    fn registers_of_every_width_give_the_same_bits() {
        let can = presets::can_2007().unwrap();
        let same = |integral: Vec<String>| {
            assert!(
                integral.iter().all(|one| *one == integral[0]),
                "{integral:?}"
            )
        };
        for law in [IdealLaw::NoSlip, IdealLaw::Frictionless] {
            let exact = Exact::new(&can, law, 9.8, None).unwrap();
            let limits = &exact.topple_limits();
            let rule = Choice::plain(20.0).rule();
            let lanes = |rate: f64| Lane::of(&exact, &group(rate));
            let all: Vec<usize> = (0..LANES).collect();

            let engine = exact.rocking_engine();
            let given = columns(&group(-1.0));
            same(integral(&engine, &StartQuery(given, exact.balance)));
            let mut rocking = Group::of(&lanes(-1.0), &all);
            let query = ExtremesQuery {
                group: &rocking,
                max_y: exact.highest(),
                min_slope: exact.min_slope(),
            };
            let found = engine.answer(&query);
            assert_eq!(found.valid, Bits::MAX);
            same(integral(&engine, &query));
            rocking = Group {
                conserved: found.conserved,
                low: found.low,
                high: found.high,
                ..rocking
            };
            let group = &rocking;
            for part in [
                TurnPart::FromLowest,
                TurnPart::ToHighest,
                TurnPart::StartToHighest,
                TurnPart::ShortStartToHighest,
            ] {
                same(integral(&engine, &TurnPartQuery { group, part, rule }));
            }

            let engine = exact.general_engine();
            let mut toppling = Group::of(&lanes(-5.0), &all);
            let group = &toppling;
            let query = TopplingQuery { group, limits };
            let found = engine.answer(&query);
            assert_eq!(found.valid, Bits::MAX);
            same(integral(&engine, &query));
            toppling = Group {
                conserved: found.conserved,
                low: found.low,
                width: found.width,
                ..toppling
            };
            let group = &toppling;
            for part in [
                TopplePart::FromLowest,
                TopplePart::ToStart,
                TopplePart::ToEnd,
            ] {
                let query = TopplePartQuery {
                    group,
                    part,
                    limits,
                    rule,
                };
                same(integral(&engine, &query));
            }

            let group = &Group::of(&lanes(4.0), &all);
            let query = FallingBackQuery { group, limits };
            assert_eq!(engine.answer(&query), Bits::MAX);
            same(integral(&engine, &query));
        }
    }
}
