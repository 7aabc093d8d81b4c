//! Error scales (the sc_i of Hairer, Nørsett & Wanner), one for each coordinate, and the Sundman time
//! transformation used in dry slip. Both steppers, for one motion and for sixteen in lanes, use them.

use crate::law::Parameters;
use crate::real::{Real, fieldwise};
use crate::state::Coordinates;

/// Added to divisors that may be 0.
pub(crate) const NEVER_ZERO: f64 = 1e-200;

/// The floor of the slip's error scale, as a fraction of the other velocities. An error of `tolerance` times
/// this floor is well below the slip that counts as stopped, a tenth of the tolerance.
const SLOW: f64 = 1e-2;

/// The error scales for one body under one gravity.
#[derive(Clone, Copy)]
pub(crate) struct ErrorScale<T> {
    mass: T,
    pub(crate) radius: T,
    /// √(g/R), the natural unit of rates.
    falling_rate: T,
    per_falling_rate: T,
    /// The slip speed below which the Sundman transformation of dry slip takes effect, m/s.
    slow: T,
}

fieldwise!(ErrorScale { mass, radius, falling_rate, per_falling_rate, slow; });

impl<T: Real> ErrorScale<T> {
    pub(crate) fn new(k: &Parameters<T>) -> Self {
        // Relative to R √(g/R).
        const ENDING: f64 = 0.03;
        let falling_rate = (k.g / k.r).sqrt();
        ErrorScale {
            mass: k.m,
            radius: k.r,
            falling_rate,
            per_falling_rate: T::from(1.0) / falling_rate,
            slow: T::from(ENDING) * k.r * falling_rate,
        }
    }

    /// The error scale of the tilt rate, rad/s.
    #[inline(always)]
    pub(crate) fn tilt_rate(&self, u: &Coordinates<T>) -> T {
        u.p.abs() + u.w.abs() + u.sin * self.falling_rate
    }

    /// The sum of all rates, rad/s.
    #[inline(always)]
    pub(crate) fn rate(&self, u: &Coordinates<T>) -> T {
        u.p.abs() + u.w.abs() + u.s.abs() + self.falling_rate
    }

    /// A first guess for the step size in τ.
    #[inline(always)]
    pub(crate) fn first_step(&self, u: &Coordinates<T>) -> T {
        T::from(0.01) / self.rate(u)
    }

    /// The scale of the sideways slip, m/s: its contributions from w and s, whose errors are relative to
    /// their own sizes.
    #[inline(always)]
    pub(crate) fn sideways_speed(&self, u: &Coordinates<T>) -> T {
        self.radius * (u.w.abs() + u.sin * u.s.abs())
    }

    /// The error scales of all coordinates.
    ///
    /// w and s obey linear equations. They pass through the tipping phase as small as the initial state made
    /// them and become large in the near-collision. So the error of each is relative to its own size, with
    /// a floor given by what the other one contributes to it. sin φ is relative to its own size for the same
    /// reason. The slip across e_x1 and w drive each other, so their errors are comparable; but the scale of
    /// the slip across never exceeds that of the slip along e_x1, because a slip with errors as large as
    /// itself would never stop. A slow slip is about to begin or to end. The slower it is, the less its
    /// direction matters, because the forces then change that direction at once.
    #[inline(always)]
    pub(crate) fn scales(&self, u: &Coordinates<T>) -> Coordinates<T> {
        const SMALL_GAP: f64 = 1e-6;
        let (one, never_zero) = (T::from(1.0), T::from(NEVER_ZERO));
        let small_gap = T::from(SMALL_GAP) * self.radius;
        let tilting = self.tilt_rate(u);
        let slip = slip_speed(u) + T::from(SLOW) * self.radius * tilting;
        let falling_rate_squared = self.falling_rate * self.falling_rate;
        let distance = self.radius + u.x1.abs() + u.y1.abs();
        let energy = self.mass
            * self.radius
            * self.radius
            * (tilting * tilting + u.s * u.s + u.sin * falling_rate_squared);
        Coordinates {
            yaw: one,
            spin: one,
            t: self.per_falling_rate,
            sin: u.sin + never_zero,
            cos: one,
            p: tilting,
            w: u.w.abs() + u.sin * u.s.abs() + never_zero,
            s: u.s.abs() + u.sin * u.w.abs() + never_zero,
            x1: distance,
            y1: distance,
            slip_x: slip,
            slip_y: u.slip_y.abs() + slip.min(self.sideways_speed(u)) + never_zero,
            gap: u.gap.abs() + small_gap,
            gap_rate: u.gap_rate.abs() + small_gap * self.falling_rate,
            friction_loss: energy,
            resistance_loss: energy,
            impact_loss: energy,
            ground_work: energy,
        }
    }

    /// The error scales while a slip begins under dry friction. Friction converts sideways slip into w and s,
    /// so errors of the three get the same weight.
    #[inline(always)]
    pub(crate) fn scales_at_slip_onset(&self, u: &Coordinates<T>) -> Coordinates<T> {
        Coordinates {
            s: u.s.abs() + u.w.abs() + T::from(NEVER_ZERO),
            ..self.scales(u)
        }
    }

    /// The error scales in dry slip that can stop. The slip can only stop while its direction is steady
    /// (see [`Self::slip_persists`]); errors that rotated a slow slip would keep it from ever stopping.
    #[inline(always)]
    pub(crate) fn scales_in_dry_slip(&self, u: &Coordinates<T>) -> Coordinates<T> {
        let never_zero = T::from(NEVER_ZERO);
        let sideways = self.sideways_speed(u);
        let slow = sideways.min(self.radius * self.tilt_rate(u));
        let slip = slip_speed(u) + T::from(SLOW) * slow + never_zero;
        Coordinates {
            slip_x: slip,
            slip_y: u.slip_y.abs() + slip.min(sideways) + never_zero,
            ..self.scales_at_slip_onset(u)
        }
    }

    /// The denominator d (m/s) of the Sundman time transformation dτ = (|u|/d) dσ used in dry slip.
    ///
    /// As the slip u ends, the direction of dry friction changes at a rate that grows like 1/|u|. With
    /// respect to σ the end of the slip is as smooth as the rest. The speed that counts as slow matters
    /// little, because the step size adapts.
    #[inline(always)]
    pub(crate) fn sundman_denominator(&self, u: &Coordinates<T>) -> T {
        slip_speed(u) + self.slow
    }

    /// dτ/dσ of that transformation.
    #[inline(always)]
    pub(crate) fn sundman_factor(&self, u: &Coordinates<T>) -> T {
        slip_speed(u) / self.sundman_denominator(u)
    }
}

impl ErrorScale<f64> {
    /// The sign of the tilt rate, or 0 where the rate is at most `significant` times its scale.
    pub(crate) fn sign_of_tilt_rate(&self, u: &Coordinates<f64>, significant: f64) -> f64 {
        if u.p.abs() > significant * self.tilt_rate(u) {
            u.p.signum()
        } else {
            0.0
        }
    }
}

impl<T: Real> ErrorScale<T> {
    /// An event function that is negative where a dry slip is about to stop so soon that, within the
    /// tolerance, its deceleration and its direction stay constant until then. The rates are with respect
    /// to σ with dτ = `sundman_factor` dσ.
    #[inline(always)]
    pub(crate) fn slip_persists(
        &self,
        u: &Coordinates<T>,
        rates: &Coordinates<T>,
        sundman_factor: T,
        tolerance: f64,
    ) -> T {
        let speed = slip_speed(u);
        let stopping = -(rates.slip_x * u.slip_x + rates.slip_y * u.slip_y);
        let turning = (rates.slip_x * u.slip_y - rates.slip_y * u.slip_x).abs();
        let change = speed * speed * sundman_factor * self.rate(u);
        let brief = T::from(max_brief_change(tolerance)) * stopping - change;
        // In plane motion the sideways speed and the turning are both zero.
        let sideways = self.sideways_speed(u) + T::from(NEVER_ZERO);
        let straight = T::from(0.1 * tolerance) * sideways * stopping - speed * turning;
        (-brief).max(-straight)
    }
}

/// The allowed relative change of velocities until the slip stops. Its effect on the rates is of second
/// order.
pub(crate) fn max_brief_change(tolerance: f64) -> f64 {
    (0.1 * tolerance).sqrt()
}

/// |u|, m/s.
#[inline(always)]
pub(crate) fn slip_speed<T: Real>(u: &Coordinates<T>) -> T {
    (u.slip_x * u.slip_x + u.slip_y * u.slip_y).sqrt()
}

/// The error scale (rad) of the angle by which a slip of the given speed deviates from a direction (unit
/// vector). It follows from the scale of the slip component across that direction.
#[inline(always)]
pub(crate) fn direction_scale<T: Real>(scales: &Coordinates<T>, direction: [T; 2], speed: T) -> T {
    let [x, y] = direction;
    let across = x.abs() * scales.slip_y + y.abs() * scales.slip_x;
    across / speed.max(T::from(NEVER_ZERO))
}
