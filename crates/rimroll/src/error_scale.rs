//! What a motion is measured by: for each coordinate the size that an error is compared with, and the
//! clock that dry friction is followed by. Steps of one motion and of sixteen in lanes are held to the same.

use crate::law::Parameters;
use crate::real::{Real, fieldwise};
use crate::state::Coordinates;

/// Added to what may be 0 and is divided by.
pub(crate) const NEVER_ZERO: f64 = 1e-200;

/// Slip this slow, beside the other velocities, need not be known better than if it were as fast: well
/// below what counts as stopped, a tenth of the tolerance.
const SLOW: f64 = 1e-2;

/// For one body under one gravity.
#[derive(Clone, Copy)]
pub(crate) struct ErrorScale<T> {
    mass: T,
    radius: T,
    /// √(g/R): the rate of falling, a yardstick for rates.
    falling_rate: T,
    per_falling_rate: T,
    /// A slip this slow is about to end, m/s.
    slow: T,
}

fieldwise!(ErrorScale { mass, radius, falling_rate, per_falling_rate, slow; });

impl<T: Real> ErrorScale<T> {
    pub(crate) fn new(k: &Parameters<T>) -> Self {
        // Beside the speed of falling.
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

    /// A rate (rad/s) to compare the tilt rate with.
    #[inline(always)]
    pub(crate) fn tilt_rate(&self, u: &Coordinates<T>) -> T {
        u.p.abs() + u.w.abs() + u.sin * self.falling_rate
    }

    /// All rates together, rad/s.
    #[inline(always)]
    pub(crate) fn rate(&self, u: &Coordinates<T>) -> T {
        u.p.abs() + u.w.abs() + u.s.abs() + self.falling_rate
    }

    /// A first guess for the length of a step by τ.
    #[inline(always)]
    pub(crate) fn first_step(&self, u: &Coordinates<T>) -> T {
        T::from(0.01) / self.rate(u)
    }

    /// A speed (m/s) to compare sideways slip with: what w and s, which are held to their own sizes,
    /// make of it.
    #[inline(always)]
    pub(crate) fn sideways_speed(&self, u: &Coordinates<T>) -> T {
        self.radius * (u.w.abs() + u.sin * u.s.abs())
    }

    /// w and s obey linear equations and pass through the tipping phase as small as the start made
    /// them, to become large in the collision; so each is held to its own size, with a floor of what
    /// the other one feeds into it. sin φ is held to its own size for the same reason. The slip
    /// across e_x1 feeds w and is fed by it: an error of the one is as good as one of the other, but never
    /// worse than one of the slip along e_x1, or slip would stay where errors as large as itself are good
    /// and never stop. A slow slip is about to begin or to end, and its direction matters less the slower
    /// it is: then it follows the forces at once.
    #[inline(always)]
    pub(crate) fn scales(&self, u: &Coordinates<T>) -> Coordinates<T> {
        const SMALL_GAP: f64 = 1e-6;
        let (one, never_zero) = (T::from(1.0), T::from(NEVER_ZERO));
        let small_gap = T::from(SMALL_GAP) * self.radius;
        let tilting = self.tilt_rate(u);
        let slip = slip_speed(u) + T::from(SLOW) * self.radius * tilting;
        let fallen = self.falling_rate * self.falling_rate;
        let away = self.radius + u.x1.abs() + u.y1.abs();
        let energy = self.mass
            * self.radius
            * self.radius
            * (tilting * tilting + u.s * u.s + u.sin * fallen);
        Coordinates {
            yaw: one,
            spin: one,
            t: self.per_falling_rate,
            sin: u.sin + never_zero,
            cos: one,
            p: tilting,
            w: u.w.abs() + u.sin * u.s.abs() + never_zero,
            s: u.s.abs() + u.sin * u.w.abs() + never_zero,
            x1: away,
            y1: away,
            slip_x: slip,
            slip_y: u.slip_y.abs() + slip.min(self.sideways_speed(u)) + never_zero,
            gap: u.gap.abs() + small_gap,
            gap_rate: u.gap_rate.abs() + small_gap * self.falling_rate,
            friction_loss: energy,
            resistance_loss: energy,
            impact_loss: energy,
        }
    }

    /// The same while a slip begins under dry friction, which makes w and s of what is lost in sideways slip:
    /// errors of the three count alike.
    #[inline(always)]
    pub(crate) fn scales_at_slip_onset(&self, u: &Coordinates<T>) -> Coordinates<T> {
        Coordinates {
            s: u.s.abs() + u.w.abs() + T::from(NEVER_ZERO),
            ..self.scales(u)
        }
    }

    /// The same for a slip that is to stop, for which it has to go [straight](Self::slip_persists): were errors good
    /// that turn the last of it, it would be turned to and fro and never stop.
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

    /// Under dry friction, whose direction changes at a rate that grows like 1/|u| as the slip ends, a
    /// clock that slows down with the slip makes the end as smooth as the rest: it goes as fast as τ times
    /// the speed of the slip over this, m/s. What counts as slow matters little, since steps adapt.
    #[inline(always)]
    pub(crate) fn sundman_denominator(&self, u: &Coordinates<T>) -> T {
        slip_speed(u) + self.slow
    }

    /// How fast that clock goes, as a part of τ.
    #[inline(always)]
    pub(crate) fn sundman_factor(&self, u: &Coordinates<T>) -> T {
        slip_speed(u) / self.sundman_denominator(u)
    }
}

impl ErrorScale<f64> {
    /// −1 or 1 where the tilt clearly falls or rises, by more than a part `significant` of its scale; 0 where
    /// it cannot be told.
    pub(crate) fn sign_of_tilt_rate(&self, u: &Coordinates<f64>, significant: f64) -> f64 {
        if u.p.abs() > significant * self.tilt_rate(u) {
            u.p.signum()
        } else {
            0.0
        }
    }
}

impl<T: Real> ErrorScale<T> {
    /// Negative where a dry slip stops so soon that the last of it can go at the rate at which it stops,
    /// to within the tolerance: neither its direction nor anything else changes much until then. The rates
    /// are by a clock that goes as fast as this part of τ.
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
        // In a plane nothing moves sideways, and nothing turns.
        let sideways = self.sideways_speed(u) + T::from(NEVER_ZERO);
        let straight = T::from(0.1 * tolerance) * sideways * stopping - speed * turning;
        (-brief).max(-straight)
    }
}

/// By what part of themselves velocities may change meanwhile: what that does to the rates is of the
/// second order.
pub(crate) fn max_brief_change(tolerance: f64) -> f64 {
    (0.1 * tolerance).sqrt()
}

/// Of slip, m/s.
#[inline(always)]
pub(crate) fn slip_speed<T: Real>(u: &Coordinates<T>) -> T {
    (u.slip_x * u.slip_x + u.slip_y * u.slip_y).sqrt()
}

/// The size of the angle by which a slip of some speed turns from a direction (unit vector), by the sizes
/// of its components: it need be as good as the slip across.
#[inline(always)]
pub(crate) fn direction_scale<T: Real>(scales: &Coordinates<T>, direction: [T; 2], speed: T) -> T {
    let [x, y] = direction;
    let across = x.abs() * scales.slip_y + y.abs() * scales.slip_x;
    across / speed.max(T::from(NEVER_ZERO))
}
