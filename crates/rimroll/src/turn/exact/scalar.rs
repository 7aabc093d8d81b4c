//! One start by itself, whatever becomes of it.

use super::extremes::{Extreme, highest, lowest};
use super::ridge::{Balance, Ridge};
use super::rule::{Choice, Rule, nodes_across, nodes_to_highest};
use super::segments::{Segment, across, from_lowest, short, to_highest};
use super::sign_search::{Energy, Unclear, first_sign_change, first_turn_back, is_clear};
use super::start::Start;
use super::tilting::Tilting;
use super::wobble::{LONGEST, Wobble};
use super::{FLAT, MAX_OUTER, Outcome, SHORT};
use crate::real::{Dual, Real, Slope};

/// A number that stands for one motion, so that it can decide.
pub(super) trait Scalar: Real {
    /// Its value.
    fn value(self) -> f64;
}

impl Scalar for f64 {
    fn value(self) -> f64 {
        self
    }
}

impl<S: Slope> Scalar for Dual<S> {
    fn value(self) -> f64 {
        self.value
    }
}

impl<T: Scalar> Segment<T> {
    fn values(&self) -> Segment<f64> {
        self.map(T::value)
    }
}

/// What quadrature has found: as [`ExactTurn`](super::ExactTurn), with tan(φ/2) for the tilts.
#[derive(Debug, Clone, Copy)]
pub(super) struct Quadrature<T> {
    pub(super) ending: Outcome,
    pub(super) low: Option<T>,
    pub(super) high: Option<T>,
    /// Yaw and time from the release to the first largest tilt, if it rises at first.
    pub(super) before: Option<Segment<T>>,
    /// From there, or the release, down to the smallest tilt.
    pub(super) down: Option<Segment<T>>,
    /// From there up to the end.
    pub(super) up: Option<Segment<T>>,
}

impl<T> Quadrature<T> {
    pub(super) fn without_turn(ending: Outcome, low: Option<T>) -> Self {
        Quadrature {
            ending,
            low,
            high: None,
            before: None,
            down: None,
            up: None,
        }
    }
}

/// Where the way up ends.
enum Top<T> {
    /// At a largest tilt.
    Rest(Extreme<T>),
    /// On the move, at tan(φ/2).
    Toppling(T, Outcome),
}

/// One motion and what is looked up on the way.
///
/// The motion is known by its table of functions, so that all this is compiled once for each kind of number and not
/// for each law, too; what a rule asks of it at a node takes far longer than the call.
pub(super) struct ScalarQuadrature<'a, T> {
    motion: &'a dyn Tilting<T>,
    start: Start<T>,
    /// Where it ends if nothing turns it back: tan(φ/2), and what that is called.
    end: (f64, Outcome),
    balance: Balance,
}

/// A start nearer to an extreme, in η, is followed there with η and G counted from it.
const CLOSE: f64 = 0.1;

/// By its clock, to both sides of its middle, a passage that one rule resolves.
const LONGEST_PASSAGE: f64 = 5.0;

/// Of Newton's iteration, where only the last digits of an extreme are missing.
const ROUNDS: usize = 4;

/// Changes of the tilt, in η, in which even the slope of its energy has no digits left.
const SHORTEST: f64 = 1e-4;

impl<'a, T: Scalar> ScalarQuadrature<'a, T> {
    pub(super) fn new(
        motion: &'a dyn Tilting<T>,
        start: Start<T>,
        end: (f64, Outcome),
        balance: Balance,
    ) -> Self {
        ScalarQuadrature {
            motion,
            start,
            end,
            balance,
        }
    }

    /// `None` where quadrature does not reach: near the edge between rocking and toppling, and where
    /// the tilt hardly changes.
    pub(super) fn quadrature(&self) -> Option<Quadrature<T>> {
        let start = self.start;
        let point = self.motion.at(start.y, start.eta);
        if self.motion.pressing(&point).value() < 0.0 {
            return Some(Quadrature::without_turn(Outcome::LiftedOff, None));
        }
        let p = start.p.value();
        // At rest the tilt's acceleration decides, if rounding leaves it a sign.
        let at_rest = p == 0.0;
        if at_rest && point.slope.value().abs() <= self.motion.rounding(&point, start.eta).value() {
            return None;
        }
        let rising = p > 0.0 || (at_rest && point.slope.value() > 0.0);
        let low = self.low(at_rest && rising).ok()?;
        let high = self.high(at_rest && !rising).ok()?;
        let low = match low {
            _ if rising && high.is_none() => return self.fell_back(),
            Some(low) if low.point.sin.value() >= FLAT => low,
            _ => return Some(self.came_down_flat(high.filter(|_| rising))),
        };
        let top = match high {
            Some(high) => Top::Rest(high),
            None => Top::Toppling(T::from(self.end.0), self.end.1),
        };
        match top {
            Top::Rest(high) if (high.eta - low.eta).value() < LONGEST => {
                self.wobbling(&low, &high, rising)
            }
            top => self.pressed(self.motion, &start, &low, top, rising),
        }
    }

    /// Along the whole, or to where the table would have to pull.
    fn pressed(
        &self,
        motion: &dyn Tilting<T>,
        start: &Start<T>,
        low: &Extreme<T>,
        top: Top<T>,
        rising: bool,
    ) -> Option<Quadrature<T>> {
        // Extremes may be counted from the start; the table's push is not.
        let counted_from = self.start.eta - start.eta;
        let moved = |extreme: &Extreme<T>| Extreme {
            eta: extreme.eta + counted_from,
            ..*extreme
        };
        let absolute = match top {
            Top::Rest(high) => Top::Rest(moved(&high)),
            Top::Toppling(y, outcome) => Top::Toppling(y, outcome),
        };
        let low_there = moved(low);
        match self.lifting(&low_there, &absolute, rising) {
            None => self.along(motion, start, low, &top, rising),
            Some(None) => Some(Quadrature::without_turn(Outcome::LiftedOff, None)),
            Some(Some(y)) => {
                let top = Top::Toppling(y, Outcome::LiftedOff);
                self.along(self.motion, &self.start, &low_there, &top, rising)
            }
        }
    }

    /// The same with the energy of a tilt that hardly changes.
    fn wobbling(&self, low: &Extreme<T>, high: &Extreme<T>, rising: bool) -> Option<Quadrature<T>> {
        let eta = self.start.eta;
        let (from, to) = ((low.eta - eta).value(), (high.eta - eta).value());
        let margin = 0.1 * (to - from);
        if to - from < SHORTEST {
            return None;
        }
        let wobble = Wobble::new(self.motion, self.start, from - margin, to + margin);
        let [low, high] = [low, high].map(|extreme| wobble.extreme(extreme.eta - eta, ROUNDS));
        let start = Start {
            eta: T::from(0.0),
            ..self.start
        };
        self.pressed(&wobble, &start, &low, Top::Rest(high), rising)
    }

    fn fell_back(&self) -> Option<Quadrature<T>> {
        if self.end.1 == Outcome::Rocked {
            // A disk, which goes on to its other face.
            return None;
        }
        let eta = self.start.eta.value();
        let end = libm::log(self.end.0);
        let ending = match first_sign_change(eta, end, |eta| self.pressing(eta)) {
            Some(_) => Outcome::LiftedOff,
            None => Outcome::FellBack,
        };
        Some(Quadrature::without_turn(ending, None))
    }

    /// Without a smallest tilt: the whole rim meets the table, unless it leaves it on the way from the
    /// start or, if it rises at first, from the largest tilt.
    fn came_down_flat(&self, from: Option<Extreme<T>>) -> Quadrature<T> {
        let highest = from.map_or(self.start.eta, |high| high.eta.max(self.start.eta));
        // Where sin φ = 2 tan(φ/2) is that at which steps end.
        let flat = libm::log(0.5 * FLAT);
        let ending = if self.lifts_coming_down(highest.value(), flat) {
            Outcome::LiftedOff
        } else {
            Outcome::FaceDown
        };
        Quadrature::without_turn(ending, None)
    }

    /// Yaw and time along the whole.
    fn along(
        &self,
        motion: &dyn Tilting<T>,
        start: &Start<T>,
        low: &Extreme<T>,
        top: &Top<T>,
        rising: bool,
    ) -> Option<Quadrature<T>> {
        let eta_top = match top {
            Top::Rest(high) => high.eta,
            Top::Toppling(y, _) => y.ln(),
        };
        let length = eta_top - low.eta;
        let outer = if length.value() > 2.0 * MAX_OUTER {
            T::from(MAX_OUTER)
        } else {
            T::from(0.5) * length
        };
        let inner = length - outer;
        let split = low.eta + inner;
        let bottom = foot(motion, low, inner)?;
        let upper = match top {
            Top::Rest(high) => head(motion, high, outer, self.gap(motion, high), 0.0)?,
            Top::Toppling(..) => self.passage([split, eta_top])?,
        };
        let up = bottom + upper;
        let from_start = eta_top - start.eta;
        let to_start = start.eta - low.eta;
        // From the smallest tilt to the start's.
        let risen = if to_start.value() <= inner.value() {
            self.next_to_lowest(motion, start, low, [to_start, length], rising)?
        } else {
            match top {
                Top::Rest(high) => {
                    let time = up.values().time;
                    up - self.next_to_highest(
                        motion,
                        start,
                        high,
                        [from_start, length],
                        time,
                        rising,
                    )?
                }
                Top::Toppling(..) => bottom + self.passage([split, start.eta])?,
            }
        };
        let (before, down) = if rising {
            (Some(up - risen), up)
        } else {
            (None, risen)
        };
        Some(Quadrature {
            ending: match top {
                Top::Rest(_) => Outcome::Rocked,
                Top::Toppling(_, ending) => *ending,
            },
            low: Some(low.y),
            high: Some(match top {
                Top::Rest(high) => high.y,
                Top::Toppling(y, _) => *y,
            }),
            before,
            down: Some(down),
            up: Some(up),
        })
    }

    /// From the smallest tilt to the start, `to_start` in η of a way of `length`.
    fn next_to_lowest(
        &self,
        motion: &dyn Tilting<T>,
        start: &Start<T>,
        low: &Extreme<T>,
        [to_start, length]: [T; 2],
        rising: bool,
    ) -> Option<Segment<T>> {
        if is_short(to_start, length.value()) {
            Some(short(motion, low.place(), to_start, self.speed(rising)))
        } else if to_start.value() < CLOSE {
            let wobble = wobble_to(motion, start, -to_start);
            let low = wobble.extreme(-to_start, ROUNDS);
            foot(&wobble, &low, -low.eta)
        } else {
            foot(motion, low, to_start)
        }
    }

    /// From the start to the largest tilt, `from_start` in η of a way of `length`, of a motion that lasts `time` (s).
    fn next_to_highest(
        &self,
        motion: &dyn Tilting<T>,
        start: &Start<T>,
        high: &Extreme<T>,
        [from_start, length]: [T; 2],
        time: f64,
        rising: bool,
    ) -> Option<Segment<T>> {
        let gap = self.gap(motion, high);
        if is_short(from_start, length.value().min(gap)) {
            Some(short(motion, high.place(), -from_start, self.speed(rising)))
        } else if from_start.value() < gap.min(CLOSE) {
            let wobble = wobble_to(motion, start, from_start);
            let high = wobble.extreme(from_start, ROUNDS);
            head(&wobble, &high, high.eta, gap, time)
        } else {
            head(motion, high, from_start, gap, time)
        }
    }

    /// √G at the start. Its derivative has a sign also where the tilt is at rest.
    fn speed(&self, rising: bool) -> T {
        let Start { y, eta, p, .. } = self.start;
        let rate = if rising { p } else { -p };
        self.motion.at(y, eta).inertia.sqrt() * rate
    }

    /// How much farther than the largest tilt G has its next root, in η.
    fn gap(&self, motion: &dyn Tilting<T>, high: &Extreme<T>) -> f64 {
        /// So near to the balance point, G is a parabola: yaw and spin move that, but bend it little.
        const NEAR: f64 = 0.2;
        /// As if there were a root here: nearer than that rounding decides.
        const LEAST: f64 = 1e-9;
        let gap = if (high.y.value() / self.balance.y - 1.0).abs() < NEAR {
            -high.point.slope.value() / self.balance.curvature
        } else {
            motion.gap_beyond(high.y).value()
        };
        gap.max(LEAST)
    }

    /// From one η to another on the move.
    fn passage(&self, [from, to]: [T; 2]) -> Option<Segment<T>> {
        let Balance { y, eta, .. } = self.balance;
        let drive = self.motion.at(T::from(y), T::from(eta)).drive;
        let ridge = Ridge::new(self.balance, drive);
        let half = T::from(0.5) * (ridge.clock(to) - ridge.clock(from));
        if half.value() > LONGEST_PASSAGE {
            let (_, between, _) = ridge.at(ridge.clock(from) + half);
            return Some(self.passage([from, between])? + self.passage([between, to])?);
        }
        let choice = Choice::plain(nodes_across(half.value()));
        agreed(choice, 0.0, ridge.width().value(), |rule| {
            across(self.motion, [from, to], &ridge, rule)
        })
    }

    /// The smallest tilt, at the start if `here`.
    fn low(&self, here: bool) -> Result<Option<Extreme<T>>, Unclear> {
        let start = self.start;
        let guess = if here { start.y } else { self.motion.lowest() };
        let guess = [guess, guess.ln()];
        let good = |low: &Extreme<T>| {
            low.change.value() < 1e-12
                && low.point.slope.value() > 0.0
                && low.y.value() <= start.y.value() * (1.0 + 1e-9)
                && self.clear(low.eta.value(), start.eta.value())
        };
        let low = lowest(self.motion, guess, 12);
        if good(&low) {
            return Ok(Some(low));
        }
        let flat = libm::log(0.25 * FLAT);
        let root = first_turn_back(start.eta.value(), flat, |eta| self.energy(eta))?;
        root.map(|eta| met(lowest(self.motion, at(eta), 4)))
            .transpose()
    }

    /// The largest tilt, at the start if `here`; none if it goes past the end.
    fn high(&self, here: bool) -> Result<Option<Extreme<T>>, Unclear> {
        let start = self.start;
        let guess = if here { start.y } else { self.motion.highest() };
        let guess = [guess, guess.ln()];
        let good = |high: &Extreme<T>| {
            high.change.value() < 1e-12
                && high.point.slope.value() < 0.0
                && high.y.value() >= start.y.value() * (1.0 - 1e-9)
                && high.y.value() < self.end.0
                && self.clear(start.eta.value(), high.eta.value())
        };
        if guess[0].value() < self.end.0 {
            let high = highest(self.motion, guess, 12);
            if good(&high) {
                return Ok(Some(high));
            }
        }
        let end = libm::log(self.end.0);
        let root = first_turn_back(start.eta.value(), end, |eta| self.energy(eta))?;
        root.map(|eta| met(highest(self.motion, at(eta), 4)))
            .transpose()
    }

    /// Whether the tilt does not turn back between two others.
    fn clear(&self, from: f64, to: f64) -> bool {
        (to - from).abs() < SHORT || is_clear(from, to, |eta| self.energy(eta))
    }

    /// Where the table would have to pull: `Some(None)` before the smallest tilt is reached.
    fn lifting(&self, low: &Extreme<T>, top: &Top<T>, rising: bool) -> Option<Option<T>> {
        let (bottom, start) = (low.eta.value(), self.start.eta.value());
        let end = match top {
            Top::Rest(high) => high.eta.value(),
            Top::Toppling(y, _) => libm::log(y.value()),
        };
        let turned = if rising { end } else { start };
        if !self.is_sure(low, turned) && self.lifts_coming_down(turned, bottom) {
            return Some(None);
        }
        if self.is_sure(low, end) {
            return None;
        }
        let pressing = |eta| self.pressing(eta);
        let eta = first_sign_change(start.max(bottom), end, pressing)?;
        Some(Some(T::from(eta).exp()))
    }

    /// Whether the table would have to pull on the way down from one η, where the tilt may turn back, to another.
    fn lifts_coming_down(&self, from: f64, to: f64) -> bool {
        let pressing = |eta| self.pressing(eta);
        pressing(from) < 0.0 || first_sign_change(from, to, pressing).is_some()
    }

    /// Whether it is sure that the table pushes all the way from the smallest tilt up to another.
    fn is_sure(&self, low: &Extreme<T>, eta: f64) -> bool {
        let y = libm::exp(eta);
        let point = self.motion.at(T::from(y), T::from(eta));
        y < self.balance.y && self.motion.surely_pressing(&low.point, &point).value() > 0.0
    }

    fn energy(&self, eta: f64) -> Energy {
        let point = self.motion.at(T::from(libm::exp(eta)), T::from(eta));
        Energy {
            drive: point.drive.value(),
            slope: point.slope.value(),
            rounding: self.motion.rounding(&point, T::from(eta)).value(),
        }
    }

    fn pressing(&self, eta: f64) -> f64 {
        let point = self.motion.at(T::from(libm::exp(eta)), T::from(eta));
        self.motion.pressing(&point).value()
    }
}

/// A piece by the first rule, from a choice on, with which the next but one agrees: what one rule tells of
/// itself can deceive where the integrand is singular at two points to the sides, as past the balance
/// point, and its Legendre coefficients swing. Of the two the smaller, whose nodes keep farther from where
/// G is rounding: of which there is the more the closer to one another, `gap` in η, it has two roots.
fn agreed<T: Scalar>(
    choice: Choice,
    whole: f64,
    gap: f64,
    segment: impl Fn(&Rule) -> Segment<T>,
) -> Option<Segment<T>> {
    /// Where G is a small difference, rounding lets rules agree no better than to so many tolerances.
    const ROUNDING: f64 = 20.0;
    /// The same where that is as small as it can be: less than the start's own rounding decides.
    const MAX_ROUNDING: f64 = 1e4;
    let rounding = (1e-4 / (gap * gap)).clamp(ROUNDING, MAX_ROUNDING);
    let mut before = segment(choice.rule());
    let mut best: Option<(f64, Segment<T>)> = None;
    let mut next = choice.larger().and_then(Choice::larger);
    while let Some(choice) = next {
        let segment = segment(choice.rule());
        let off = segment.values().difference(&before.values(), whole);
        if off <= 1.0 {
            return Some(before);
        }
        if best.is_none_or(|(least, _)| off < least) {
            best = Some((off, before));
        }
        before = segment;
        next = choice.larger().and_then(Choice::larger);
    }
    best.filter(|&(off, _)| off <= rounding)
        .map(|(_, segment)| segment)
}

/// From the smallest tilt up by `length` in η.
fn foot<T: Scalar>(motion: &dyn Tilting<T>, low: &Extreme<T>, length: T) -> Option<Segment<T>> {
    // With each unit of η the time grows e-fold over it.
    let choice = Choice::plain(9.0 + 0.8 * length.value());
    agreed(choice, 0.0, 1.0, |rule| {
        from_lowest(
            motion,
            [low.y, low.eta, low.singular_coefficient()],
            length,
            rule,
        )
    })
}

/// Up to the largest tilt by `length` in η, of a motion that lasts `whole` (s) or as long; `gap` beyond it G has its
/// next root.
fn head<T: Scalar>(
    motion: &dyn Tilting<T>,
    high: &Extreme<T>,
    length: T,
    gap: f64,
    whole: f64,
) -> Option<Segment<T>> {
    // The smallest tilt, in the plane of τ².
    const FAR: f64 = 100.0;
    let square = gap / length.value();
    let choice = Choice::to_highest(nodes_to_highest(square, FAR), square);
    agreed(choice, whole, gap, |rule| {
        to_highest(motion, high.place(), length, rule)
    })
}

/// An extreme on which the iteration settles; where it does not, two of them are close together.
fn met<T: Scalar>(extreme: Extreme<T>) -> Result<Extreme<T>, Unclear> {
    let settled = extreme.change.value() < 1e-8;
    settled.then_some(extreme).ok_or(Unclear)
}

/// Whether a piece next to an extreme is so short that G has no digits left in it, but not for being part
/// of a motion that is no longer, `whole` in η, or for being next to where G is smaller still.
fn is_short<T: Scalar>(segment: T, whole: f64) -> bool {
    segment.value() < SHORT.min(1e-5 * whole)
}

/// From the start to `away` in η and a little beyond.
fn wobble_to<'a, T: Scalar>(
    motion: &'a dyn Tilting<T>,
    start: &Start<T>,
    away: T,
) -> Wobble<'a, T> {
    let (near, far) = (-0.1 * away.value(), 1.1 * away.value());
    Wobble::new(motion, *start, near.min(far), near.max(far))
}

/// A guess of y and η.
fn at<T: Scalar>(eta: f64) -> [T; 2] {
    [T::from(libm::exp(eta)), T::from(eta)]
}
