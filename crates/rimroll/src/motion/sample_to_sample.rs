//! Steps of a rim that rolls, from one sample of a record of the table's motion to the next.
//!
//! The acceleration of the table has a corner at each sample, where a step has to end. Between two samples of an
//! earthquake, 5 ms to 20 ms apart, a body moves so little that a method of order 5 with six evaluations is often
//! accurate enough, and nearly always one of order 8 with twelve, or a few of them. So these steps are tried first, with
//! time as the independent variable. A step counts only if its estimated error in the coordinates on which the rates depend
//! is within the tolerance, and if exclusion tests show that it contains no event, except at most one extremum of the tilt,
//! which is then located. Any other step is left to the usual stepper.
//!
//! All numbers go through the same operations for one motion and in lanes, so that their bits are the same.

pub(super) mod lanes;
mod runge_kutta;

use super::contacts::Contacts;
use super::options::Options;
use super::phase_system::rate_floor;
use super::topple_tilt::ToppleTilt;
use crate::error_scale::ErrorScale;
use crate::law::{Acceleration, Contact, Dynamics, NoSlip, across_plane};
use crate::real::{
    Real, Task, call_vectorized, fieldwise, sin_cos_of_small, sin_cos_without_branches,
};
use crate::solve::{ErrorEstimate, bracketed_root_in};
use crate::state::Coordinates;
use runge_kutta::{ERRORS_OF_5, ERRORS_OF_8, MAX_STAGES, ORDER_5, ORDER_8, Stages};

/// The number of coordinates.
pub(super) const N: usize = 10;

/// The number of leading coordinates on which the rates depend.
const ESSENTIAL: usize = 6;

/// Below this sin φ the usual stepper decides whether the body stands.
const FLAT: f64 = 1e-5;

/// The largest change of the yaw in a step, rad.
const MAX_TURN: f64 = 0.1;

/// How far a linear function of a cubic can fall below its Bernstein coefficients in the true motion, as a fraction of
/// their spread.
const SPREAD: f64 = 0.25;

/// (sin φ, cos φ, φ̇, w, s, ψ, θ, x, y, work of the ground), where x and y are the horizontal displacement of the
/// centre of mass in axes fixed to the table.
pub(super) type Reduced<T> = [T; N];

/// The equations of a rolling rim, with the bounds of a step without events.
#[derive(Clone, Copy)]
pub(super) struct Rolling<T> {
    dynamics: NoSlip<T>,
    error_scale: ErrorScale<T>,
    topple: ToppleTilt<T>,
    /// Added to the error scales of the rates of rotation, rad/s.
    rate_floor: T,
    /// μ_s².
    static_friction_squared: T,
    tolerance: T,
    /// The sign of a tilt rate is significant if the rate exceeds this fraction of its error scale.
    significant: T,
    /// sin φ below which the usual stepper decides whether the base is flat.
    flat: T,
    /// See [`Ground::straight_peak`](crate::ground::Ground::straight_peak), m/s².
    peak: T,
}

fieldwise!(Rolling {
    rate_floor, static_friction_squared, tolerance, significant, flat, peak; dynamics, error_scale, topple
});

/// The beginning of a step.
#[derive(Clone, Copy)]
pub(super) struct StepEnd<T> {
    pub u: Reduced<T>,
    /// The rates with respect to the time.
    rates: Reduced<T>,
    /// The margin of the rim to the friction cone.
    margin: T,
}

/// The acceleration of the table between two samples, m/s².
#[derive(Clone, Copy)]
pub(super) struct SampleInterval<T> {
    pub from: [T; 3],
    pub to: [T; 3],
    /// The time between them, s.
    pub h: T,
}

/// The method of a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Order {
    Five,
    Eight,
}

/// An attempted step.
pub(super) struct Attempt<T> {
    pub end: StepEnd<T>,
    /// Negative if the step may contain an event other than one extremum of the tilt.
    pub margin: T,
    pub estimate: ErrorEstimate<T>,
}

impl Rolling<f64> {
    /// The equations under a contact law whose rolling rim these steps can follow.
    pub(super) fn new(contacts: &Contacts, options: &Options) -> Self {
        // Without slip the margin to the friction cone has the sign of the normal force.
        const UNLIMITED: f64 = 1e50;
        // A record has thousands of samples, and the errors of all steps add up.
        const STRICTER: f64 = 0.05;
        let k = contacts.parameters();
        let static_friction = contacts.contact_law().friction.static_friction();
        let static_friction = static_friction.unwrap_or(UNLIMITED);
        Rolling {
            dynamics: NoSlip::new(*k),
            error_scale: ErrorScale::new(k),
            topple: options
                .topple_tilt
                .map_or(ToppleTilt::never(), ToppleTilt::at),
            rate_floor: rate_floor(k),
            static_friction_squared: static_friction * static_friction,
            tolerance: STRICTER * options.step_tolerance(),
            significant: options.significant_tilt_rate(),
            flat: FLAT.max(contacts.sine_at_gap()),
            peak: contacts
                .ground()
                .map_or(0.0, |ground| ground.straight_peak()),
        }
    }

    /// [`Rolling::attempt`], in the instructions of the processor.
    pub(super) fn attempt_alone(
        &self,
        order: Order,
        at: &StepEnd<f64>,
        between: &SampleInterval<f64>,
        direction: f64,
    ) -> Attempt<f64> {
        struct Alone<'a>(
            &'a Rolling<f64>,
            Order,
            &'a StepEnd<f64>,
            &'a SampleInterval<f64>,
            f64,
        );
        impl Task for Alone<'_> {
            type Done = Attempt<f64>;

            #[inline(always)]
            fn call(self) -> Attempt<f64> {
                let Alone(rolling, order, at, between, direction) = self;
                rolling.attempt(order, at, between, direction)
            }
        }
        call_vectorized(Alone(self, order, at, between, direction))
    }

    /// The fraction of a step at which the tilt has its extremum, and the coordinates there.
    pub(super) fn extremum(
        &self,
        order: Order,
        at: &StepEnd<f64>,
        between: &SampleInterval<f64>,
        end: &StepEnd<f64>,
    ) -> (f64, Reduced<f64>) {
        const ROUNDS: usize = 12;
        const SMALL: f64 = 1e-6;
        let h = between.h;
        let [from, to, from_rate, to_rate] = [at.u[2], end.u[2], h * at.rates[2], h * end.rates[2]];
        // The tilt rate as a cubic.
        let tilt_rate = |x: f64| {
            let y = 1.0 - x;
            let linear = y * from + x * to;
            linear + x * y * (y * (from_rate - (to - from)) + x * (to - from - to_rate))
        };
        let until = |x: f64| {
            let end = &self.attempt_alone(order, at, &between.until(x), 1.0).end;
            (end.u, h * end.rates[2])
        };
        let mut x = bracketed_root_in(ROUNDS, 0.0, 1.0, tilt_rate);
        // Newton's method, whose error after a correction is about its square.
        for _ in 0..ROUNDS {
            let (u, rate) = until(x);
            let corrected = (x - u[2] / rate).clamp(0.0, 1.0);
            let change = (corrected - x).abs();
            x = corrected;
            if change < SMALL {
                break;
            }
        }
        (x, until(x).0)
    }
}

impl SampleInterval<f64> {
    /// The part up to a fraction of the time.
    fn until(&self, x: f64) -> SampleInterval<f64> {
        let to = core::array::from_fn(|i| self.from[i] + x * (self.to[i] - self.from[i]));
        SampleInterval {
            to,
            h: x * self.h,
            ..*self
        }
    }
}

impl Attempt<f64> {
    /// Whether the step counts.
    pub(super) fn is_accepted(&self) -> bool {
        self.estimate.is_accepted() && self.margin >= 0.0
    }
}

impl<T: Real> Rolling<T> {
    /// The beginning of a first step from `u`.
    #[inline(always)]
    pub(super) fn at(&self, u: &Reduced<T>, acceleration: [T; 3]) -> StepEnd<T> {
        let frame = Frame::new(u[5], acceleration, acceleration);
        let (rates, margin) = self.rates(u, &frame, 0.0);
        StepEnd {
            u: *u,
            rates,
            margin,
        }
    }

    /// A step from one sample to the next, or from part to part between them. At its start the tilt rate has the sign
    /// `direction`.
    #[inline(always)]
    pub(super) fn attempt(
        &self,
        order: Order,
        at: &StepEnd<T>,
        between: &SampleInterval<T>,
        direction: T,
    ) -> Attempt<T> {
        let (u, h) = (&at.u, between.h);
        let frame = Frame::new(u[5], between.from, between.to);
        let mut stages: Stages<T, N> = [at.rates; MAX_STAGES];
        macro_rules! stages {
            ($rows:ident: $($i:literal)*; $last:literal, $inner:literal) => {{
                // The margin to the friction cone inside the step.
                let mut inner_margin = at.margin;
                $(
                    let argument = runge_kutta::argument($rows[$i], u, h, &stages, ESSENTIAL);
                    let (rates, margin) = self.rates(&argument, &frame, const { runge_kutta::node($rows[$i]) });
                    stages[$i + 1] = rates;
                    if $i == $inner {
                        inner_margin = margin;
                    }
                )*
                let end = runge_kutta::argument($rows[$last], u, h, &stages, N);
                let (rates, margin) = self.rates(&end, &frame, 1.0);
                stages[$last + 1] = rates;
                (StepEnd { u: end, rates, margin }, inner_margin)
            }};
        }
        let (end, inner_margin) = match order {
            Order::Five => stages!(ORDER_5: 0 1 2 3 4; 5, 1),
            Order::Eight => stages!(ORDER_8: 0 1 2 3 4 5 6 7 8 9 10; 11, 4),
        };
        let errors = match order {
            Order::Five => ERRORS_OF_5,
            Order::Eight => ERRORS_OF_8,
        };
        let margins = clearance([at.margin, inner_margin, end.margin], UNDERSHOOT);
        let estimate = runge_kutta::estimate(errors, h, &stages, &self.per_allowed(u));
        Attempt {
            margin: self.margin(at, &end, h, direction).min(margins),
            estimate: without_long_turn(estimate, end.u[5] - u[5]),
            end,
        }
    }

    /// The rates with respect to the time, and the margin to the friction cone, at a fraction of the step.
    #[inline(always)]
    fn rates(&self, u: &Reduced<T>, frame: &Frame<T>, fraction: f64) -> (Reduced<T>, T) {
        let at = expand(u);
        let (mut acceleration, [sin_yaw, cos_yaw]) = frame.at(u[5], fraction);
        let across = &mut acceleration.horizontal[1];
        *across = across_plane(*across, T::from(0.0), self.peak, &at);
        let rates = acceleration.rates(&self.dynamics, &at);
        let contact = acceleration.contact(&self.dynamics, &at);
        let [along, across] = self.dynamics.center_velocity(&at);
        let per_sin = T::from(1.0) / at.sin;
        let rates = [
            per_sin * rates.sin,
            per_sin * rates.cos,
            per_sin * rates.p,
            per_sin * rates.w,
            per_sin * rates.s,
            per_sin * rates.yaw,
            at.s - per_sin * at.w * at.cos,
            along * cos_yaw - across * sin_yaw,
            along * sin_yaw + across * cos_yaw,
            per_sin * rates.ground_work,
        ];
        (rates, self.cone_margin(&contact))
    }

    /// (μ_s² N |N| − T²) sin² φ, positive where friction holds the rim on the table.
    #[inline(always)]
    fn cone_margin(&self, contact: &Contact<T>) -> T {
        let available = self.static_friction_squared * contact.normal * contact.normal.abs();
        available - (contact.along * contact.along + contact.across * contact.across)
    }

    /// The reciprocals of the allowed errors of the essential coordinates.
    #[inline(always)]
    fn per_allowed(&self, u: &Reduced<T>) -> [T; ESSENTIAL] {
        let scales = self.error_scale.scales(&expand(u));
        let floor = self.rate_floor;
        let scales = [
            scales.sin,
            scales.cos,
            scales.p + floor,
            scales.w + floor,
            scales.s + floor,
            scales.yaw,
        ];
        let mut allowed = scales;
        for i in 0..ESSENTIAL {
            allowed[i] = T::from(1.0) / (self.tolerance * scales[i]);
        }
        allowed
    }

    /// Negative if the tilt may have several extrema in the step, or come near a tilt at which the motion changes.
    #[inline(always)]
    fn margin(&self, from: &StepEnd<T>, to: &StepEnd<T>, h: T, direction: T) -> T {
        let (a, b) = (expand(&from.u), expand(&to.u));
        let third = h * T::from(1.0 / 3.0);
        // The coefficients of the tilt rate in the direction in which the tilt changes at first.
        let rates = [
            direction * a.p,
            direction * (a.p + third * from.rates[2]),
            direction * (b.p - third * to.rates[2]),
            direction * b.p,
        ];
        let insignificant = self.significant * self.error_scale.tilt_rate(&b);
        let one_extremum = (-rates[3] - insignificant).min(self.margin_of_extremum(&a, &b, third));
        let none_or_one = monotonicity(rates)
            .min(rates[0])
            .min(rates[3].max(one_extremum));
        clearance(rates, SPREAD)
            .max(none_or_one)
            .min(b.sin - self.flat)
            .min(b.cos)
            .min(self.topple.below(&b))
    }

    /// Negative if an extremum of the tilt in a step may be near a tilt at which the motion changes.
    #[inline(always)]
    fn margin_of_extremum(&self, a: &Coordinates<T>, b: &Coordinates<T>, third: T) -> T {
        // How far the coefficients of the tilt exceed the tilts at the ends.
        let (after, before) = (third * a.p.abs(), third * b.p.abs());
        let either = |at_a: T, at_b: T| (at_a - after).min(at_b - before);
        (either(a.sin, b.sin) - self.flat)
            .min(either(a.cos, b.cos))
            .min(either(self.topple.below(a), self.topple.below(b)))
    }
}

/// Negative if the cubic with these Bernstein coefficients may rise and fall.
#[inline(always)]
fn monotonicity<T: Real>([a, b, c, d]: [T; 4]) -> T {
    clearance([b - a, c - b, d - c], SPREAD).max(clearance([a - b, b - c, c - d], SPREAD))
}

/// The estimate of a step, in which an error is too large also if the yaw changes by more than [`MAX_TURN`].
#[inline(always)]
fn without_long_turn<T: Real>(estimate: ErrorEstimate<T>, turn: T) -> ErrorEstimate<T> {
    // Its 16th power grows with the step size as the square of the error.
    let mut power = turn * T::from(1.0 / MAX_TURN);
    for _ in 0..4 {
        power = power * power;
    }
    ErrorEstimate {
        error_squared: estimate.error_squared.max(power * estimate.allowed),
        ..estimate
    }
}

/// How far a parabola through three values can fall below the smallest of them, as a fraction of their spread. It is
/// (1 − c)²/4c if the second value is that at the fraction c of the step, which is 0.3 or 1/3.
const UNDERSHOOT: f64 = 0.41;

/// Negative if the smallest value is less than a fraction of the spread, or negative. Otherwise the polynomial is positive
/// that has the values as its Bernstein coefficients or, with [`UNDERSHOOT`], passes through them.
#[inline(always)]
fn clearance<T: Real, const M: usize>(values: [T; M], undershoot: f64) -> T {
    let (mut min, mut max) = (values[0], values[0]);
    for value in values {
        min = min.min(value);
        max = max.max(value);
    }
    min.min(min - T::from(undershoot) * (max - min))
}

/// The frame in which the components of the acceleration are linear functions of the time: that of e_x1 and e_y1 at the
/// start of the step.
struct Frame<T> {
    yaw: T,
    sin_yaw: T,
    cos_yaw: T,
    from: [T; 3],
    change: [T; 3],
}

impl<T: Real> Frame<T> {
    #[inline(always)]
    fn new(yaw: T, from: [T; 3], to: [T; 3]) -> Self {
        let (sin_yaw, cos_yaw) = sin_cos_without_branches(yaw);
        let change = [to[0] - from[0], to[1] - from[1], to[2] - from[2]];
        Frame {
            yaw,
            sin_yaw,
            cos_yaw,
            from: turned(from, sin_yaw, cos_yaw),
            change: turned(change, sin_yaw, cos_yaw),
        }
    }

    /// The acceleration at a yaw and a fraction of the step, and the sine and cosine of the yaw.
    #[inline(always)]
    fn at(&self, yaw: T, fraction: f64) -> (Acceleration<T>, [T; 2]) {
        let (sin, cos) = sin_cos_of_small(yaw - self.yaw);
        let fraction = T::from(fraction);
        let x = self.from[0] + fraction * self.change[0];
        let y = self.from[1] + fraction * self.change[1];
        let acceleration = Acceleration {
            horizontal: [x * cos + y * sin, y * cos - x * sin],
            vertical: self.from[2] + fraction * self.change[2],
        };
        let yaw = [
            self.sin_yaw * cos + self.cos_yaw * sin,
            self.cos_yaw * cos - self.sin_yaw * sin,
        ];
        (acceleration, yaw)
    }
}

/// A vector in axes that are turned about the vertical by a yaw. (A closure would not be inlined, and so not use the
/// registers.)
#[inline(always)]
fn turned<T: Real>([x, y, z]: [T; 3], sin_yaw: T, cos_yaw: T) -> [T; 3] {
    [x * cos_yaw + y * sin_yaw, y * cos_yaw - x * sin_yaw, z]
}

/// All coordinates on which rates, contact forces and error scales depend.
#[inline(always)]
fn expand<T: Real>(u: &Reduced<T>) -> Coordinates<T> {
    let [sin, cos, p, w, s, yaw, ..] = *u;
    Coordinates {
        sin,
        cos,
        p,
        w,
        s,
        yaw,
        ..Coordinates::zero()
    }
}

/// The reduced coordinates.
pub(super) fn reduce(u: &Coordinates<f64>) -> Reduced<f64> {
    let [x, y] = u.center();
    [
        u.sin,
        u.cos,
        u.p,
        u.w,
        u.s,
        u.yaw,
        u.spin,
        x,
        y,
        u.ground_work,
    ]
}

/// `before` with the reduced coordinates `u` at another time (s).
pub(super) fn advanced(before: &Coordinates<f64>, u: &Reduced<f64>, t: f64) -> Coordinates<f64> {
    let [sin, cos, p, w, s, yaw, spin, x, y, ground_work] = *u;
    let (sin_yaw, cos_yaw) = libm::sincos(yaw);
    Coordinates {
        sin,
        cos,
        p,
        w,
        s,
        yaw,
        spin,
        t,
        x1: x * cos_yaw + y * sin_yaw,
        y1: y * cos_yaw - x * sin_yaw,
        ground_work,
        ..*before
    }
}

#[cfg(test)]
mod tests {
    use super::{UNDERSHOOT, clearance};

    #[test]
    fn a_parabola_that_falls_below_zero_between_its_values_is_not_clear() {
        for c in [0.3, 1.0 / 3.0] {
            let lowest = -(1.0 - c) * (1.0 - c) / (4.0 * c);
            let raised = |by: f64| clearance([1.0 + by, by, by], UNDERSHOOT);
            assert!(raised(0.999 * -lowest) < 0.0);
            assert!(raised(UNDERSHOOT + 1e-9) > 0.0);
        }
    }
}
