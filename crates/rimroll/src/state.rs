//! Position and motion of the body: Euler angles for the user, regular coordinates for the solver.

use crate::error::{InvalidInput, bounded, within};
use crate::real::Real;
use core::f64::consts::PI;

/// Position and motion in the paper's Euler angles (rad, rad/s), as users give and receive them.
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
    /// ψ: follows the contact point round.
    pub yaw: f64,
    /// ψ̇.
    pub yaw_rate: f64,
    /// θ.
    pub spin: f64,
    /// θ̇.
    pub spin_rate: f64,
}

impl State {
    /// The six numbers in the order of the fields.
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

    /// The state with these six numbers, in the order of the fields.
    pub fn from_numbers(numbers: [f64; 6]) -> State {
        let [tilt, tilt_rate, yaw, yaw_rate, spin, spin_rate] = numbers;
        State {
            tilt,
            tilt_rate,
            yaw,
            yaw_rate,
            spin,
            spin_rate,
        }
    }

    /// A body that stands flat on the table, at rest.
    pub fn standing() -> State {
        State::default()
    }

    /// Whether the body stands flat on the table, at rest.
    pub fn is_standing(&self) -> bool {
        let State { yaw, spin, .. } = *self;
        *self
            == State {
                yaw,
                spin,
                ..State::standing()
            }
    }

    /// Checks yaw and spin.
    pub(crate) fn check_angles(&self) -> Result<(), InvalidInput> {
        // A larger angle would leave too few digits for the turn that is added to it.
        within("yaw", self.yaw, 1e6, "between -1e6 and 1e6", "rad")?;
        within("spin", self.spin, 1e6, "between -1e6 and 1e6", "rad")?;
        Ok(())
    }

    /// Checks an initial state: tilt inside (0, π), |yaw| and |spin| up to 1e6 rad, rates up to 1e30 rad/s.
    ///
    /// # Errors
    /// Names the first field that is out of bounds.
    pub fn check(&self) -> Result<(), InvalidInput> {
        bounded(
            "tilt",
            self.tilt,
            |tilt| tilt > 0.0 && tilt < PI,
            "inside (0, pi)",
            "rad",
        )?;
        self.check_angles()?;
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
pub const COORDINATES: usize = 18;

/// The number of leading coordinates that can change on a table at rest.
pub(crate) const COORDINATES_AT_REST: usize = 17;

/// The number of leading coordinates that describe the body's position and rotation. The others (slip, gap
/// and losses) stay constant without slip, without friction and in place.
pub const RIGID_COORDINATES: usize = 10;

/// The number of leading coordinates that are ignorable (cyclic) on a table at rest: no rate depends on yaw and
/// spin. No rate depends on the time either; it stays among the eight that fill two registers.
pub(crate) const IGNORABLE: usize = 2;

/// Index of the time among the coordinates.
pub const TIME: usize = 7;

/// The coordinates that are integrated. They are regular through the near-collision.
///
/// As the base almost slaps the table, ψ̇ and θ̇ grow without bound like 1/φ, but the body's angular
/// velocity (w, −φ̇, s) in the frame e_x2, e_y2, e_z2 stays finite. The Sundman time transformation
/// dt = sin φ dτ stretches the near-collision, so that every coordinate here has a bounded rate with
/// respect to the independent variable τ. sin φ and cos φ replace φ, which makes the right-hand sides
/// rational and avoids cancellation down to the smallest tilt. The slip velocity replaces the velocity of
/// the centre of mass, because friction depends on the direction of the slip however small it is.
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
    /// Horizontal displacement of the centre of mass since the start along e_x1, m. In the yawing frame
    /// its rate is polynomial, too, and needs no sine of the yaw.
    pub x1: T,
    /// Horizontal displacement of the centre of mass since the start along e_y1, m.
    pub y1: T,
    /// Horizontal velocity of the rim's lowest point along e_x1, m/s, under laws that allow slip.
    pub slip_x: T,
    /// Horizontal velocity of the rim's lowest point along e_y1, m/s.
    pub slip_y: T,
    /// Height of the rim's lowest point above the table, m: zero except in flight.
    pub gap: T,
    /// Rate of the gap, m/s.
    pub gap_rate: T,
    /// Energy lost to friction since the start, J.
    pub friction_loss: T,
    /// Energy lost to rolling resistance, pivoting friction and air drag since the start, J.
    pub resistance_loss: T,
    /// Energy lost in impacts since the start, J.
    pub impact_loss: T,
    /// Work of the moving table on the body since the start, in the frame of the table, J.
    pub ground_work: T,
}

impl<T: Copy> Coordinates<T> {
    /// Reads the solver's state vector.
    #[rustfmt::skip]
    #[inline(always)]
    pub fn from_array(array: &[T; COORDINATES]) -> Self {
        let [
            yaw, spin, sin, cos, p, w, s, t, x1, y1, slip_x, slip_y, gap, gap_rate,
            friction_loss, resistance_loss, impact_loss, ground_work,
        ] = *array;
        Coordinates {
            yaw, spin, sin, cos, p, w, s, t, x1, y1, slip_x, slip_y, gap, gap_rate,
            friction_loss, resistance_loss, impact_loss, ground_work,
        }
    }

    /// The solver's state vector.
    #[rustfmt::skip]
    #[inline(always)]
    pub fn into_array(self) -> [T; COORDINATES] {
        [
            self.yaw, self.spin, self.sin, self.cos, self.p, self.w, self.s, self.t, self.x1, self.y1,
            self.slip_x, self.slip_y, self.gap, self.gap_rate,
            self.friction_loss, self.resistance_loss, self.impact_loss, self.ground_work,
        ]
    }
}

impl<T: Real> Coordinates<T> {
    /// self + `factor` · `other`, coordinate by coordinate.
    pub(crate) fn plus(&self, factor: T, other: &Self) -> Self {
        let (a, b) = (self.into_array(), other.into_array());
        Coordinates::from_array(&core::array::from_fn(|i| a[i] + factor * b[i]))
    }

    /// All coordinates, or all rates, zero.
    #[inline(always)]
    pub fn zero() -> Self {
        Coordinates::from_array(&[T::from(0.0); COORDINATES])
    }

    /// Reads the first N entries of the solver's state vector; the others are zero.
    #[inline(always)]
    pub(crate) fn from_first<const N: usize>(leading: &[T; N]) -> Self {
        let mut array = [T::from(0.0); COORDINATES];
        array[..N].copy_from_slice(leading);
        Coordinates::from_array(&array)
    }

    /// The start of a motion: t = 0, the centre of mass above the origin, no slip. The argument lists the
    /// fields of a [`State`] in their order.
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

    /// The rates with respect to τ that follow from the velocities alone: those of yaw, tilt and time. All
    /// other rates are zero.
    #[inline(always)]
    pub fn kinematics(&self) -> Self {
        self.scaled_kinematics(T::from(1.0))
    }

    /// [`Coordinates::kinematics`] with respect to σ, where dτ = `factor` dσ.
    #[inline(always)]
    pub(crate) fn scaled_kinematics(&self, factor: T) -> Self {
        let time_rate = factor * self.sin;
        let tilt_rate = time_rate * self.p;
        Coordinates {
            yaw: factor * self.w,
            t: time_rate,
            sin: tilt_rate * self.cos,
            cos: -(tilt_rate * self.sin),
            ..Coordinates::zero()
        }
    }

    /// Adds to `rates` the rates of the spin and of the centre of mass, which moves with `velocity` (m/s)
    /// along e_x1 and e_y1.
    #[inline(always)]
    pub fn with_spin_and_center(&self, rates: Self, velocity: [T; 2]) -> Self {
        let [vx, vy] = velocity;
        Coordinates {
            spin: self.sin * self.s - self.w * self.cos,
            x1: self.sin * vx + self.w * self.y1,
            y1: self.sin * vy - self.w * self.x1,
            ..rates
        }
    }

    /// Horizontal displacement of the centre of mass since the start, m, in axes fixed to the table.
    pub fn center(&self) -> [T; 2] {
        let (sin, cos) = self.yaw.sin_cos();
        [self.x1 * cos - self.y1 * sin, self.x1 * sin + self.y1 * cos]
    }
}

impl Coordinates<f64> {
    /// The start of a motion in the paper's Euler angles (see [`Coordinates::starting`]).
    pub fn from_state(state: &State) -> Self {
        Coordinates::starting(state.numbers())
    }

    /// φ, rad. It stays below π even where rounding puts a disk flat on its other face.
    pub fn tilt(&self) -> f64 {
        const LAST_BELOW_PI: f64 = f64::from_bits(PI.to_bits() - 1);
        libm::atan2(self.sin, self.cos).min(LAST_BELOW_PI)
    }

    /// Whether all coordinates are finite.
    #[inline(always)]
    pub(crate) fn is_finite(&self) -> bool {
        // Zero times an infinity or a NaN is a NaN.
        self.into_array()
            .iter()
            .map(|value| 0.0 * value)
            .sum::<f64>()
            == 0.0
    }

    /// Speed of slip, m/s.
    pub fn slip_speed(&self) -> f64 {
        libm::hypot(self.slip_x, self.slip_y)
    }

    /// The paper's Euler angles and their rates.
    pub fn state(&self) -> State {
        let is_level = self.sin == 0.0;
        State {
            tilt: self.tilt(),
            tilt_rate: self.p,
            yaw: self.yaw,
            yaw_rate: if is_level { 0.0 } else { self.yaw_rate() },
            spin: self.spin,
            spin_rate: if is_level { self.s } else { self.spin_rate() },
        }
    }
}
