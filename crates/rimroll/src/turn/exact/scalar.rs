//! The turn of one start, with any outcome.

use super::balance_passage::{Balance, BalancePassage};
use super::quadrature_rule::{Choice, MAX_OUTER, Rule, nodes_across, nodes_to_highest};
use super::segments::{Segment, across, from_lowest, short, to_highest};
use super::sign_search::{
    Energy, Undecided, first_sign_change, first_turning_point, is_positive_between,
};
use super::small_energy::{MAX_SPAN, SmallOscillation};
use super::small_energy::{NearBalance, lingers};
use super::tilt_equation::Start;
use super::tilt_equation::{FLAT, SHORT, TiltEquation};
use super::tilt_extremes::{Extreme, highest, lowest};
use crate::law::Parameters;
use crate::motion::Outcome;
use crate::real::Scalar;

impl<T: Scalar> Segment<T> {
    fn values(&self) -> Segment<f64> {
        self.map(T::value)
    }
}

/// The result of the quadrature: as [`ExactTurn`](super::ExactTurn), with tilts given as tan(φ/2).
#[derive(Debug, Clone, Copy)]
pub(super) struct Quadrature<T> {
    pub(super) ending: Outcome,
    pub(super) low: Option<T>,
    pub(super) high: Option<T>,
    /// Yaw and time from the release to the first largest tilt, if the tilt increases at the release.
    pub(super) before: Option<Segment<T>>,
    /// From there, or from the release, to the smallest tilt.
    pub(super) down: Option<Segment<T>>,
    /// From the smallest tilt to the end.
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

/// The upper end of the motion after the smallest tilt.
enum UpperEnd<T> {
    /// The largest tilt.
    TurningPoint(Extreme<T>),
    /// A tilt, as tan(φ/2), at which the motion ends with a positive tilt rate, and its outcome.
    Moving(T, Outcome),
}

/// The quadrature of a motion of a body from a start. `end` is that of [`ScalarQuadrature`].
pub(super) fn quadrature_of<T: Scalar>(
    motion: &dyn TiltEquation<T>,
    k: &Parameters<T>,
    start: Start<T>,
    end: (f64, Outcome),
    balance: Balance,
) -> Option<Quadrature<T>> {
    if lingers(motion, &start, &balance) {
        let motion = NearBalance::new(motion, k, start, [balance.eta, libm::log(end.0)]);
        return ScalarQuadrature::new(&motion, start, end, balance).quadrature();
    }
    ScalarQuadrature::new(motion, start, end, balance).quadrature()
}

/// One motion and its limits.
///
/// The motion is a trait object, so that this code is compiled once per number type and not once per law. The
/// evaluation at a node takes far longer than the dynamic call.
pub(super) struct ScalarQuadrature<'a, T> {
    motion: &'a dyn TiltEquation<T>,
    start: Start<T>,
    /// The end of a motion without an upper turning point: tan(φ/2) and the outcome.
    end: (f64, Outcome),
    balance: Balance,
}

/// Distance in η between a start and a turning point below which η and G are measured from the start.
const CLOSE: f64 = 0.1;

/// Half-length in u of the longest passage over the balance point that one rule resolves.
const LONGEST_PASSAGE: f64 = 5.0;

/// Number of Newton iterations if only the last digits of a turning point are missing.
const ROUNDS: usize = 4;

/// Distance in η between two turning points below which rounding errors dominate even dG/dη.
const SHORTEST: f64 = 1e-4;

impl<'a, T: Scalar> ScalarQuadrature<'a, T> {
    pub(super) fn new(
        motion: &'a dyn TiltEquation<T>,
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

    /// The turn. `None` outside the range of the quadrature: near the boundary between rocking and toppling, and
    /// for oscillations of very small amplitude.
    pub(super) fn quadrature(&self) -> Option<Quadrature<T>> {
        let start = self.start;
        let point = self.motion.at(start.y, start.eta);
        if self.motion.scaled_normal_force(&point).value() < 0.0 {
            return Some(Quadrature::without_turn(Outcome::LiftedOff, None));
        }
        let p = start.p.value();
        // At rest, the sign of the tilt acceleration decides, unless it is within rounding errors.
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
            Some(high) => UpperEnd::TurningPoint(high),
            None => UpperEnd::Moving(T::from(self.end.0), self.end.1),
        };
        match top {
            UpperEnd::TurningPoint(high) if (high.eta - low.eta).value() < MAX_SPAN => {
                self.small_oscillation(&low, &high, rising)
            }
            top => self.until_lift_off(self.motion, &start, &low, top, rising),
        }
    }

    /// Integrates the motion to its end, or to the tilt at which the normal force becomes zero.
    fn until_lift_off(
        &self,
        motion: &dyn TiltEquation<T>,
        start: &Start<T>,
        low: &Extreme<T>,
        top: UpperEnd<T>,
        rising: bool,
    ) -> Option<Quadrature<T>> {
        // The turning points may be given relative to the start. The normal force needs absolute η.
        let counted_from = self.start.eta - start.eta;
        let moved = |extreme: &Extreme<T>| Extreme {
            eta: extreme.eta + counted_from,
            ..*extreme
        };
        let absolute = match top {
            UpperEnd::TurningPoint(high) => UpperEnd::TurningPoint(moved(&high)),
            UpperEnd::Moving(y, outcome) => UpperEnd::Moving(y, outcome),
        };
        let absolute_low = moved(low);
        match self.lift_off(&absolute_low, &absolute, rising) {
            None => self.integrate(motion, start, low, &top, rising),
            Some(None) => Some(Quadrature::without_turn(Outcome::LiftedOff, None)),
            Some(Some(y)) => {
                let top = UpperEnd::Moving(y, Outcome::LiftedOff);
                self.integrate(self.motion, &self.start, &absolute_low, &top, rising)
            }
        }
    }

    /// Integrates an oscillation of small amplitude.
    fn small_oscillation(
        &self,
        low: &Extreme<T>,
        high: &Extreme<T>,
        rising: bool,
    ) -> Option<Quadrature<T>> {
        let eta = self.start.eta;
        let (from, to) = ((low.eta - eta).value(), (high.eta - eta).value());
        let margin = 0.1 * (to - from);
        if to - from < SHORTEST {
            return None;
        }
        let oscillation =
            SmallOscillation::new(self.motion, self.start, from - margin, to + margin);
        let [low, high] = [low, high].map(|extreme| oscillation.extreme(extreme.eta - eta, ROUNDS));
        let start = Start {
            eta: T::from(0.0),
            ..self.start
        };
        self.until_lift_off(
            &oscillation,
            &start,
            &low,
            UpperEnd::TurningPoint(high),
            rising,
        )
    }

    fn fell_back(&self) -> Option<Quadrature<T>> {
        if self.end.1 == Outcome::Rocked {
            // A disk passes the vertical and falls to its other face.
            return None;
        }
        let eta = self.start.eta.value();
        let end = libm::log(self.end.0);
        let ending = match first_sign_change(eta, end, |eta| self.scaled_normal_force(eta)) {
            Some(_) => Outcome::LiftedOff,
            None => Outcome::FellBack,
        };
        Some(Quadrature::without_turn(ending, None))
    }

    /// The result without a smallest tilt. The body comes down flat, unless it lifts off on the way down from the
    /// start or, if the tilt increases at first, from the largest tilt `from`.
    fn came_down_flat(&self, from: Option<Extreme<T>>) -> Quadrature<T> {
        let highest = from.map_or(self.start.eta, |high| high.eta.max(self.start.eta));
        // Here sin φ ≈ 2 tan(φ/2) equals FLAT, at which time integration ends, too.
        let flat = libm::log(0.5 * FLAT);
        let ending = if self.lifts_off_coming_down(highest.value(), flat) {
            Outcome::LiftedOff
        } else {
            Outcome::FaceDown
        };
        Quadrature::without_turn(ending, None)
    }

    /// Integrates yaw and time along all segments.
    fn integrate(
        &self,
        motion: &dyn TiltEquation<T>,
        start: &Start<T>,
        low: &Extreme<T>,
        top: &UpperEnd<T>,
        rising: bool,
    ) -> Option<Quadrature<T>> {
        let eta_top = match top {
            UpperEnd::TurningPoint(high) => high.eta,
            UpperEnd::Moving(y, _) => y.ln(),
        };
        let length = eta_top - low.eta;
        let outer = if length.value() > 2.0 * MAX_OUTER {
            T::from(MAX_OUTER)
        } else {
            T::from(0.5) * length
        };
        let inner = length - outer;
        let split = low.eta + inner;
        let bottom = segment_from_lowest(motion, low, inner)?;
        let upper = match top {
            UpperEnd::TurningPoint(high) => {
                segment_to_highest(motion, high, outer, self.gap(motion, high), 0.0)?
            }
            UpperEnd::Moving(..) => self.passage([split, eta_top])?,
        };
        let up = bottom + upper;
        let from_start = eta_top - start.eta;
        let to_start = start.eta - low.eta;
        // From the smallest tilt to the start.
        let low_to_start = if to_start.value() <= inner.value() {
            self.next_to_lowest(motion, start, low, [to_start, length], rising)?
        } else {
            match top {
                UpperEnd::TurningPoint(high) => {
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
                UpperEnd::Moving(..) => bottom + self.passage([split, start.eta])?,
            }
        };
        let (before, down) = if rising {
            (Some(up - low_to_start), up)
        } else {
            (None, low_to_start)
        };
        Some(Quadrature {
            ending: match top {
                UpperEnd::TurningPoint(_) => Outcome::Rocked,
                UpperEnd::Moving(_, ending) => *ending,
            },
            low: Some(low.y),
            high: Some(match top {
                UpperEnd::TurningPoint(high) => high.y,
                UpperEnd::Moving(y, _) => *y,
            }),
            before,
            down: Some(down),
            up: Some(up),
        })
    }

    /// Integrates from the smallest tilt to the start, `to_start` in η above it. `length` is the distance in η to the
    /// upper end.
    fn next_to_lowest(
        &self,
        motion: &dyn TiltEquation<T>,
        start: &Start<T>,
        low: &Extreme<T>,
        [to_start, length]: [T; 2],
        rising: bool,
    ) -> Option<Segment<T>> {
        if is_short(to_start, length.value()) {
            Some(short(motion, low.position(), to_start, self.speed(rising)))
        } else if to_start.value() < CLOSE {
            let oscillation = oscillation_to(motion, start, -to_start);
            let low = oscillation.extreme(-to_start, ROUNDS);
            segment_from_lowest(&oscillation, &low, -low.eta)
        } else {
            segment_from_lowest(motion, low, to_start)
        }
    }

    /// Integrates from the start to the largest tilt, `from_start` in η above it. `length` is the distance in η between
    /// the turning points, and `time` (s) the time between them.
    fn next_to_highest(
        &self,
        motion: &dyn TiltEquation<T>,
        start: &Start<T>,
        high: &Extreme<T>,
        [from_start, length]: [T; 2],
        time: f64,
        rising: bool,
    ) -> Option<Segment<T>> {
        let gap = self.gap(motion, high);
        if is_short(from_start, length.value().min(gap)) {
            Some(short(
                motion,
                high.position(),
                -from_start,
                self.speed(rising),
            ))
        } else if from_start.value() < gap.min(CLOSE) {
            let oscillation = oscillation_to(motion, start, from_start);
            let high = oscillation.extreme(from_start, ROUNDS);
            segment_to_highest(&oscillation, &high, high.eta, gap, time)
        } else {
            segment_to_highest(motion, high, from_start, gap, time)
        }
    }

    /// √G at the start, in a form whose derivative has the correct sign even if the tilt is at rest.
    fn speed(&self, rising: bool) -> T {
        let Start { y, eta, p, .. } = self.start;
        let rate = if rising { p } else { -p };
        self.motion.at(y, eta).inertia.sqrt() * rate
    }

    /// Distance in η from the largest tilt to the next root of G above it.
    fn gap(&self, motion: &dyn TiltEquation<T>, high: &Extreme<T>) -> f64 {
        /// Relative distance from the balance point within which G is taken as a parabola. Yaw and spin shift it but
        /// hardly change its curvature.
        const NEAR: f64 = 0.2;
        /// Minimum of the distance. Smaller ones depend on rounding errors.
        const LEAST: f64 = 1e-9;
        let gap = if (high.y.value() / self.balance.y - 1.0).abs() < NEAR {
            -high.point.slope.value() / self.balance.curvature
        } else {
            motion.gap_beyond(high.y).value()
        };
        gap.max(LEAST)
    }

    /// Integrates between two η without a turning point in between.
    fn passage(&self, [from, to]: [T; 2]) -> Option<Segment<T>> {
        let Balance { y, eta, .. } = self.balance;
        let drive = self.motion.at(T::from(y), T::from(eta)).drive;
        let balance_passage = BalancePassage::new(self.balance, drive);
        let half = T::from(0.5) * (balance_passage.u(to) - balance_passage.u(from));
        if half.value() > LONGEST_PASSAGE {
            let (_, between, _) = balance_passage.at(balance_passage.u(from) + half);
            return Some(self.passage([from, between])? + self.passage([between, to])?);
        }
        let choice = Choice::plain(nodes_across(half.value()));
        by_agreeing_rules(choice, 0.0, balance_passage.width().value(), |rule| {
            across(self.motion, [from, to], &balance_passage, rule)
        })
    }

    /// The smallest tilt. If `here`, it is at the start.
    fn low(&self, here: bool) -> Result<Option<Extreme<T>>, Undecided> {
        let start = self.start;
        let guess = if here {
            start.y
        } else {
            self.motion.guess_lowest()
        };
        let guess = [guess, guess.ln()];
        let good = |low: &Extreme<T>| {
            low.change.value() < 1e-12
                && low.point.slope.value() > 0.0
                && low.y.value() <= start.y.value() * (1.0 + 1e-9)
                && self.has_no_turning_point(low.eta.value(), start.eta.value())
        };
        let low = lowest(self.motion, guess, 12);
        if good(&low) {
            return Ok(Some(low));
        }
        let flat = libm::log(0.25 * FLAT);
        let root = first_turning_point(start.eta.value(), flat, |eta| self.energy(eta))?;
        root.map(|eta| converged(lowest(self.motion, at(eta), 4)))
            .transpose()
    }

    /// The largest tilt, or `None` if it would be past the end. If `here`, it is at the start.
    fn high(&self, here: bool) -> Result<Option<Extreme<T>>, Undecided> {
        let start = self.start;
        let guess = if here {
            start.y
        } else {
            self.motion.guess_highest()
        };
        let guess = [guess, guess.ln()];
        let good = |high: &Extreme<T>| {
            high.change.value() < 1e-12
                && high.point.slope.value() < 0.0
                && high.y.value() >= start.y.value() * (1.0 - 1e-9)
                && high.y.value() < self.end.0
                && self.has_no_turning_point(start.eta.value(), high.eta.value())
        };
        if guess[0].value() < self.end.0 {
            let high = highest(self.motion, guess, 12);
            if good(&high) {
                return Ok(Some(high));
            }
        }
        let end = libm::log(self.end.0);
        let root = first_turning_point(start.eta.value(), end, |eta| self.energy(eta))?;
        root.map(|eta| converged(highest(self.motion, at(eta), 4)))
            .transpose()
    }

    /// Whether there is no turning point between two η.
    fn has_no_turning_point(&self, from: f64, to: f64) -> bool {
        (to - from).abs() < SHORT || is_positive_between(from, to, |eta| self.energy(eta))
    }

    /// The tilt of lift-off, where the normal force becomes zero, as tan(φ/2). `Some(None)` if that happens before the
    /// smallest tilt is reached, `None` if it does not happen.
    fn lift_off(&self, low: &Extreme<T>, top: &UpperEnd<T>, rising: bool) -> Option<Option<T>> {
        let (bottom, start) = (low.eta.value(), self.start.eta.value());
        let end = match top {
            UpperEnd::TurningPoint(high) => high.eta.value(),
            UpperEnd::Moving(y, _) => libm::log(y.value()),
        };
        let turned = if rising { end } else { start };
        if !self.surely_in_contact(low, turned) && self.lifts_off_coming_down(turned, bottom) {
            return Some(None);
        }
        if self.surely_in_contact(low, end) {
            return None;
        }
        let scaled_normal_force = |eta| self.scaled_normal_force(eta);
        let eta = first_sign_change(start.max(bottom), end, scaled_normal_force)?;
        Some(Some(T::from(eta).exp()))
    }

    /// Whether the normal force becomes negative on the way down from one η, which may be a turning point, to
    /// another.
    fn lifts_off_coming_down(&self, from: f64, to: f64) -> bool {
        let scaled_normal_force = |eta| self.scaled_normal_force(eta);
        scaled_normal_force(from) < 0.0
            || first_sign_change(from, to, scaled_normal_force).is_some()
    }

    /// Whether the bound shows that the normal force is positive everywhere between the smallest tilt and η.
    fn surely_in_contact(&self, low: &Extreme<T>, eta: f64) -> bool {
        let y = libm::exp(eta);
        let point = self.motion.at(T::from(y), T::from(eta));
        y < self.balance.y && self.motion.normal_force_bound(&low.point, &point).value() > 0.0
    }

    fn energy(&self, eta: f64) -> Energy {
        let point = self.motion.at(T::from(libm::exp(eta)), T::from(eta));
        Energy {
            drive: point.drive.value(),
            slope: point.slope.value(),
            rounding: self.motion.rounding(&point, T::from(eta)).value(),
        }
    }

    fn scaled_normal_force(&self, eta: f64) -> f64 {
        let point = self.motion.at(T::from(libm::exp(eta)), T::from(eta));
        self.motion.scaled_normal_force(&point).value()
    }
}

/// Integrates a segment with increasing rules, from `choice` on, until a rule agrees with the next but one.
///
/// The error estimate of a single rule can mislead if the integrand has a conjugate pair of singularities, as past the
/// balance point, because its Legendre coefficients then oscillate. The result is that of the smaller of the two
/// rules, whose nodes stay farther from the turning point, where rounding errors dominate G. These errors are the
/// larger the smaller the distance `gap` in η between two roots of G is. `whole` is the time (s) of
/// [`Segment::difference`].
fn by_agreeing_rules<T: Scalar>(
    choice: Choice,
    whole: f64,
    gap: f64,
    segment: impl Fn(&Rule) -> Segment<T>,
) -> Option<Segment<T>> {
    /// Accepted difference of two rules, in tolerances, if rounding errors of G prevent better agreement.
    const ROUNDING: f64 = 20.0;
    /// Maximum of the accepted difference, in tolerances. It is below the effect of rounding the start.
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

/// Integrates from the smallest tilt up to `length` in η above it.
fn segment_from_lowest<T: Scalar>(
    motion: &dyn TiltEquation<T>,
    low: &Extreme<T>,
    length: T,
) -> Option<Segment<T>> {
    // The integrand of the time grows by a factor of e per unit of η.
    let choice = Choice::plain(9.0 + 0.8 * length.value());
    by_agreeing_rules(choice, 0.0, 1.0, |rule| {
        from_lowest(
            motion,
            [low.y, low.eta, low.singular_coefficient()],
            length,
            rule,
        )
    })
}

/// Integrates from `length` in η below the largest tilt up to it. The next root of G is `gap` in η above it. `whole` is
/// the time (s) of [`Segment::difference`].
fn segment_to_highest<T: Scalar>(
    motion: &dyn TiltEquation<T>,
    high: &Extreme<T>,
    length: T,
    gap: f64,
    whole: f64,
) -> Option<Segment<T>> {
    // τ² of the smallest tilt, which is far away.
    const FAR: f64 = 100.0;
    let square = gap / length.value();
    let choice = Choice::to_highest(nodes_to_highest(square, FAR), square);
    by_agreeing_rules(choice, whole, gap, |rule| {
        to_highest(motion, high.position(), length, rule)
    })
}

/// A turning point, if the iteration has converged. It does not if two turning points nearly coincide.
fn converged<T: Scalar>(extreme: Extreme<T>) -> Result<Extreme<T>, Undecided> {
    let settled = extreme.change.value() < 1e-8;
    settled.then_some(extreme).ok_or(Undecided)
}

/// Whether a segment next to a turning point is so short that rounding errors dominate G in it. This does not apply if
/// the whole motion is similarly short (`whole`, in η), or if another root of G is that near.
fn is_short<T: Scalar>(segment: T, whole: f64) -> bool {
    segment.value() < SHORT.min(1e-5 * whole)
}

/// The motion with η and G measured from the start, in an interval that extends slightly beyond `away` in η.
fn oscillation_to<'a, T: Scalar>(
    motion: &'a dyn TiltEquation<T>,
    start: &Start<T>,
    away: T,
) -> SmallOscillation<'a, T> {
    let (near, far) = (-0.1 * away.value(), 1.1 * away.value());
    SmallOscillation::new(motion, *start, near.min(far), near.max(far))
}

/// y and η, as a guess.
fn at<T: Scalar>(eta: f64) -> [T; 2] {
    [T::from(libm::exp(eta)), T::from(eta)]
}
