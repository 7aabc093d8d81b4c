//! Where the body is and how it moves.

use crate::error::{InvalidInput, bounded, within};
use crate::real::Real;
use core::f64::consts::PI;

/// Position and motion in the paper's Euler angles (rad, rad/s): what goes in and comes out.
///
/// Yaw ψ about the vertical, tilt −φ about the horizontal axis in the base, spin θ about the
/// symmetry axis, relative to the frame that yaws and tilts. The contact point is at azimuth ψ + π
/// as seen from the centre of the base.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct State {
    /// φ: 0 = upright, base flat on the table.
    pub tilt: f64,
    /// φ̇.
    pub tilt_rate: f64,
    /// ψ: turns with the contact point.
    pub yaw: f64,
    /// ψ̇.
    pub yaw_rate: f64,
    /// θ.
    pub spin: f64,
    /// θ̇.
    pub spin_rate: f64,
}

impl State {
    /// Its six numbers, in the order in which they are listed.
    pub fn numbers(&self) -> [f64; 6] {
        [
            self.tilt,
            self.tilt_rate,
            self.yaw,
            self.yaw_rate,
            self.spin,
            self.spin_rate,
        ]
    }

    /// Checks a start: the tilt inside (0, π), yaw and spin within 1e6 rad, rates within 1e30 rad/s.
    ///
    /// # Errors
    /// Names the first field that is not.
    pub fn check(&self) -> Result<(), InvalidInput> {
        bounded(
            "tilt",
            self.tilt,
            |tilt| tilt > 0.0 && tilt < PI,
            "inside (0, pi)",
            "rad",
        )?;
        // A larger angle has no digits left for the turn that is added to it.
        within("yaw", self.yaw, 1e6, "between -1e6 and 1e6", "rad")?;
        within("spin", self.spin, 1e6, "between -1e6 and 1e6", "rad")?;
        for (field, rate) in [
            ("tilt_rate", self.tilt_rate),
            ("yaw_rate", self.yaw_rate),
            ("spin_rate", self.spin_rate),
        ] {
            within(field, rate, 1e30, "between -1e30 and 1e30", "rad/s")?;
        }
        Ok(())
    }
}

/// The number of [`Coordinates`].
pub const COORDINATES: usize = 17;

/// How many of them, the first, say where the body is and how it turns.
pub const RIGID_COORDINATES: usize = 10;

/// How many of them, the first, no rate depends on: yaw and spin. (Nor does one on the time, which makes
/// up the eight that fill two registers.)
pub(crate) const IGNORABLE: usize = 2;

/// Index of the time among them.
pub const TIME: usize = 7;

/// The coordinates that are integrated: regular through the near-collision.
///
/// As the base almost slaps the table ψ̇ and θ̇ grow without bound like 1/φ, but the body's angular
/// velocity (w, −φ̇, s) in the frame e_x2, e_y2, e_z2 stays finite, and the step variable τ with
/// dt = sin φ dτ stretches the moment so that every coordinate here changes at a bounded rate.
/// sin φ and cos φ are carried instead of φ: then the right-hand sides are rational, and nothing
/// cancels down to the smallest tilt. The slip is carried instead of the centre's velocity, because
/// friction depends on its direction, however small it is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Coordinates<T> {
    /// ψ, rad.
    pub yaw: T,
    /// θ, rad.
    pub spin: T,
    /// Time, s.
    pub t: T,
    /// sin φ.
    pub sin: T,
    /// cos φ.
    pub cos: T,
    /// p = φ̇, rad/s.
    pub p: T,
    /// w = ψ̇ sin φ, rad/s.
    pub w: T,
    /// s = θ̇ + ψ̇ cos φ, rad/s: the spin about the symmetry axis.
    pub s: T,
    /// Where the centre of mass is from where it started: along e_x1, m. In the frame that yaws, its rate
    /// is polynomial, too: nothing here asks for the sine of the yaw.
    pub x1: T,
    /// The same along e_y1, m.
    pub y1: T,
    /// Horizontal velocity of the rim's lowest point along e_x1, m/s, where the law makes use of it.
    pub slip_x: T,
    /// The same along e_y1, m/s.
    pub slip_y: T,
    /// Height of the rim's lowest point over the table, m: zero but in flight.
    pub gap: T,
    /// Its rate, m/s.
    pub gap_rate: T,
    /// Energy lost to friction so far, J.
    pub friction_loss: T,
    /// Energy lost to rolling resistance, pivoting friction and air, J.
    pub resistance_loss: T,
    /// Energy lost in landings, J.
    pub impact_loss: T,
}

impl<T: Copy> Coordinates<T> {
    /// From the order in which the solver keeps them.
    #[rustfmt::skip]
    #[inline(always)]
    pub fn from_array(array: &[T; COORDINATES]) -> Self {
        let [
            yaw, spin, sin, cos, p, w, s, t, x1, y1, slip_x, slip_y, gap, gap_rate,
            friction_loss, resistance_loss, impact_loss,
        ] = *array;
        Coordinates {
            yaw, spin, sin, cos, p, w, s, t, x1, y1, slip_x, slip_y, gap, gap_rate,
            friction_loss, resistance_loss, impact_loss,
        }
    }

    /// Into the order in which the solver keeps them.
    #[rustfmt::skip]
    #[inline(always)]
    pub fn into_array(self) -> [T; COORDINATES] {
        [
            self.yaw, self.spin, self.sin, self.cos, self.p, self.w, self.s, self.t, self.x1, self.y1,
            self.slip_x, self.slip_y, self.gap, self.gap_rate,
            self.friction_loss, self.resistance_loss, self.impact_loss,
        ]
    }
}

impl Coordinates<f64> {
    /// This and `factor` times another, coordinate by coordinate.
    pub(crate) fn plus(&self, factor: f64, other: &Self) -> Self {
        let (a, b) = (self.into_array(), other.into_array());
        Coordinates::from_array(&core::array::from_fn(|i| a[i] + factor * b[i]))
    }
}

impl<T: Real> Coordinates<T> {
    /// All zero: rates of nothing.
    #[inline(always)]
    pub fn zero() -> Self {
        Coordinates::from_array(&[T::from(0.0); COORDINATES])
    }

    /// From the first of them in the order in which the solver keeps them, the others being zero.
    #[inline(always)]
    pub(crate) fn from_first<const N: usize>(first: &[T; N]) -> Self {
        let mut all = [T::from(0.0); COORDINATES];
        all[..N].copy_from_slice(first);
        Coordinates::from_array(&all)
    }

    /// The start of a motion: t = 0, the centre of mass over the origin, the rim at rest where it
    /// touches the table. The numbers are those of a [`State`], in its order.
    pub fn starting([tilt, tilt_rate, yaw, yaw_rate, spin, spin_rate]: [T; 6]) -> Self {
        let (sin, cos) = tilt.sin_cos();
        Coordinates {
            yaw,
            spin,
            sin,
            cos,
            p: tilt_rate,
            w: yaw_rate * sin,
            s: spin_rate + yaw_rate * cos,
            ..Coordinates::zero()
        }
    }

    /// ψ̇ = w / sin φ, rad/s.
    pub fn yaw_rate(&self) -> T {
        self.w / self.sin
    }

    /// θ̇ = s − ψ̇ cos φ, rad/s.
    pub fn spin_rate(&self) -> T {
        self.s - self.yaw_rate() * self.cos
    }

    /// The rates by the solver's clock τ that follow from the velocities alone, whatever the
    /// forces: of yaw, tilt and time. All others are zero.
    #[inline(always)]
    pub fn kinematics(&self) -> Self {
        self.kinematics_in(T::from(1.0))
    }

    /// The same by a clock that goes as fast as this part of τ.
    #[inline(always)]
    pub(crate) fn kinematics_in(&self, clock: T) -> Self {
        let passing = clock * self.sin;
        let falling = passing * self.p;
        Coordinates {
            yaw: clock * self.w,
            t: passing,
            sin: falling * self.cos,
            cos: -(falling * self.sin),
            ..Coordinates::zero()
        }
    }

    /// These rates with those of the spin, and of the centre of mass, which moves with `velocity`
    /// (m/s) along e_x1 and e_y1.
    #[inline(always)]
    pub fn with_place(&self, rates: Self, velocity: [T; 2]) -> Self {
        let [vx, vy] = velocity;
        Coordinates {
            spin: self.sin * self.s - self.w * self.cos,
            x1: self.sin * vx + self.w * self.y1,
            y1: self.sin * vy - self.w * self.x1,
            ..rates
        }
    }

    /// The centre of mass over the table, m, from where it started.
    pub fn center(&self) -> [T; 2] {
        let (sin, cos) = self.yaw.sin_cos();
        [self.x1 * cos - self.y1 * sin, self.x1 * sin + self.y1 * cos]
    }
}

impl Coordinates<f64> {
    /// The start of a motion from the paper's Euler angles, as [`Coordinates::starting`].
    pub fn from_state(state: &State) -> Self {
        Coordinates::starting(state.numbers())
    }

    /// φ, rad; of a disk that all but lies on its other face the last number below π.
    pub fn tilt(&self) -> f64 {
        const LAST_BELOW_PI: f64 = f64::from_bits(PI.to_bits() - 1);
        libm::atan2(self.sin, self.cos).min(LAST_BELOW_PI)
    }

    /// Speed of slip, m/s.
    pub fn slip_speed(&self) -> f64 {
        libm::hypot(self.slip_x, self.slip_y)
    }

    /// Back to the paper's Euler angles.
    pub fn state(&self) -> State {
        State {
            tilt: self.tilt(),
            tilt_rate: self.p,
            yaw: self.yaw,
            yaw_rate: self.yaw_rate(),
            spin: self.spin,
            spin_rate: self.spin_rate(),
        }
    }
}
