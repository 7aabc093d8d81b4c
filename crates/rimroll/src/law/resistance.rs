//! Rolling resistance, pivoting friction and air drag: dissipative moments that can be added to any law.
//!
//! * [`RollingResistance`]: the rim dissipates energy as the contact point runs along it at R|θ̇|. The
//!   generalised force acts on θ alone, Q = −(k N R + c R² |θ̇|) sgn θ̇. It does no work in a rotation about
//!   the vertical, so it is the moment Q about e_z2 and −Q cos φ/sin φ about e_x2. (This is the "contour
//!   friction" of R. I. Leine, Arch. Appl. Mech. 79 (2009), and the "rolling friction" of the literature
//!   on Euler's disk.)
//! * [`PivotingFriction`]: a moment −k N sgn ω_z about the vertical, due to a contact area of finite size.
//! * [`AirDrag`]: a moment about e_x2 against the wobble, which dissipates the power k |ψ̇|ⁿ.
//!
//! A nearly flat uniform disk at the tilt α wobbles at Ω² = 4g/(Rα). If it dissipates a power ~ Ω^λ, then
//! α ~ (t₀ − t)^{2/(2+λ)}. Dry rolling resistance has λ = 1, viscous rolling resistance λ = 2, air λ = n.
//!
//! Viscous rolling resistance and air drag fade out where the normal force is below a few thousandths of
//! the weight.
//!
//! On a table that moves, all of them fade out below a tilt of 1e-8 rad, where the gap under the rim is far smaller than the
//! roughness of any surface. There rounding decides on ψ̇ just after a body that stood has begun to rock.
//!
//! sgn is smoothed to x/√(x² + x₀²), so that rates can pass smoothly through zero. x is the angular velocity
//! about the vertical or, for rolling, θ̇ sin φ, the one about e_x1, the horizontal direction in the
//! plane of the tilt; x₀ = √(g/R)/1000.

use super::{
    Contact, Dynamics, FrictionLaw, InPlace, NamedParameters, NoSlip, OnTable, Parameters,
    Response, Table,
};
use crate::error::{InvalidInput, bounded, not_negative};
use crate::real::{Real, Scalar};
use crate::state::Coordinates;

/// Resistance to the motion of the contact point along the rim.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct RollingResistance {
    /// k: the resisting force per unit of normal force.
    pub dry: f64,
    /// c, N s/m: the resisting force per unit of speed.
    pub viscous: f64,
}

/// Resistance to rotation about the vertical through the contact point.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct PivotingFriction {
    /// k, m: the moment per unit of normal force.
    pub length: f64,
}

/// Resistance of the air between base and table to the wobble.
///
/// For exponents below 2 it is smoothed below the yaw rate 0.002 rtol (√(g/R) + |axial spin rate|), with 2.5e-13
/// in place of a smaller rtol, since the tolerance of a step has a floor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AirDrag {
    /// k, W (s/rad)ⁿ.
    pub coefficient: f64,
    /// n: 4 for a viscous film (Moffatt, Nature 404, 2000), 5/2 for boundary layers (Bildsten,
    /// Phys. Rev. E 66, 2002).
    pub exponent: f64,
}

impl Default for AirDrag {
    fn default() -> Self {
        AirDrag {
            coefficient: 0.0,
            exponent: 4.0,
        }
    }
}

/// The resistance that is added to a law.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Resistance {
    /// Rolling resistance.
    pub rolling: RollingResistance,
    /// Pivoting friction.
    pub pivoting: PivotingFriction,
    /// Air drag.
    pub air: AirDrag,
}

impl Resistance {
    /// The resistance of numbers by name, such as `rolling_dry`. Missing ones have their default.
    pub(crate) fn from_named(given: &NamedParameters<'_>) -> Self {
        Resistance {
            rolling: RollingResistance {
                dry: given.number("rolling_dry"),
                viscous: given.number("rolling_viscous"),
            },
            pivoting: PivotingFriction {
                length: given.number("pivoting_length"),
            },
            air: AirDrag {
                coefficient: given.number("air_coefficient"),
                exponent: given
                    .optional("air_exponent")
                    .unwrap_or(AirDrag::default().exponent),
            },
        }
    }

    /// Checks every number.
    pub(crate) fn check(&self) -> Result<(), InvalidInput> {
        let Resistance {
            rolling,
            pivoting,
            air,
        } = self;
        not_negative("rolling_resistance dry", rolling.dry, "")?;
        not_negative("rolling_resistance viscous", rolling.viscous, "N s/m")?;
        not_negative("pivoting_friction", pivoting.length, "m")?;
        not_negative("air_drag", air.coefficient, "W (s/rad)^exponent")?;
        let moderate = |n: f64| (1.5..=8.0).contains(&n);
        bounded(
            "air_drag exponent",
            air.exponent,
            moderate,
            "between 1.5 and 8",
            "",
        )?;
        Ok(())
    }

    /// Whether all resistances are zero.
    pub fn is_none(&self) -> bool {
        let none = Resistance::default();
        self.rolling == none.rolling
            && self.pivoting == none.pivoting
            && self.air.coefficient == 0.0
    }

    /// The moments about e_x2 and e_z2, times sin φ, under the normal force N = `normal`/sin φ. Air drag is
    /// smoothed within `tolerance`. At tilts that are zero or negative within rounding, where ψ̇ is not defined, there are
    /// none.
    fn moment<T: Real>(
        &self,
        k: &Parameters<T>,
        u: &Coordinates<T>,
        normal: T,
        tolerance: f64,
    ) -> [T; 2] {
        let falling_rate = (k.g / k.r).sqrt();
        let smooth = T::from(1e-3) * falling_rate;
        let contact_factor = contact_factor(k, u, normal);
        let [rolling_x, rolling_z] = self.rolling.moment(k, u, normal, smooth, contact_factor);
        let [pivoting_x, pivoting_z] = self.pivoting.moment(u, normal, smooth);
        let about_x =
            rolling_x + pivoting_x + contact_factor * self.air.moment(u, falling_rate, tolerance);
        let tilted = u.sin - T::from(f64::MIN_POSITIVE);
        [about_x, rolling_z + pivoting_z].map(|moment| tilted.where_negative(T::from(0.0), moment))
    }
}

/// A factor of the resistances that are not proportional to the load. It is 1 except where the normal force
/// almost vanishes, and 0 in flight. If it jumped to 0 at the lift-off, the resistance could hold the rim on
/// the table and vanish as soon as the rim leaves it.
fn contact_factor<T: Real>(k: &Parameters<T>, u: &Coordinates<T>, normal: T) -> T {
    const SOFT: f64 = 1000.0;
    let load = normal / (k.m * u.sin * k.g);
    let in_contact = T::from(1.0) - (T::from(-SOFT) * load).exp();
    normal.where_negative(T::from(0.0), in_contact)
}

impl RollingResistance {
    fn moment<T: Real>(
        &self,
        k: &Parameters<T>,
        u: &Coordinates<T>,
        normal: T,
        smooth: T,
        contact_factor: T,
    ) -> [T; 2] {
        // θ̇ sin φ, the angular velocity about −e_x1, stays finite as sin φ → 0.
        let running = u.sin * u.s - u.w * u.cos;
        let sign = running / (running * running + smooth * smooth).sqrt();
        let dry = T::from(self.dry) * k.r * normal * sign;
        let viscous = contact_factor * T::from(self.viscous) * k.r * k.r * running;
        let moment = dry + viscous;
        [moment * u.cos / u.sin, -moment]
    }
}

impl PivotingFriction {
    fn moment<T: Real>(&self, u: &Coordinates<T>, normal: T, smooth: T) -> [T; 2] {
        let vertical_rate = u.w * u.sin + u.s * u.cos;
        let sign = vertical_rate / (vertical_rate * vertical_rate + smooth * smooth).sqrt();
        let vertical = T::from(self.length) * normal * sign;
        [-vertical * u.sin, -vertical * u.cos]
    }
}

impl AirDrag {
    /// −k ψ̇ |ψ̇|ⁿ⁻². For n < 2 its slope is infinite at ψ̇ = 0, so a ψ̇ that drag and gyroscopic moments
    /// keep close to 0 would relax infinitely fast. There √(ψ̇² + ψ̇₀²) replaces |ψ̇|.
    ///
    /// ψ̇₀ is a tenth of `tolerance` times |s| + √(g/R). For ψ̇ > ψ̇₀ and 3/2 ≤ n ≤ 2 the smoothed drag at ψ̇ lies
    /// between the exact drag at ψ̇ − ψ̇₀ and that at ψ̇: the logarithms of the three are linear in n, so it
    /// suffices to compare them at n = 3/2 and n = 2. Where the smoothed and the exact solution differ by ψ̇₀,
    /// drag, which increases with ψ̇, therefore does not drive them farther apart; the gyroscopic moment can, as it
    /// amplifies any difference of ψ̇ while the tilt falls. A ψ̇ below ψ̇₀ decays exponentially instead of
    /// stopping after a finite time.
    fn moment<T: Real>(&self, u: &Coordinates<T>, falling_rate: T, tolerance: f64) -> T {
        let (yaw_rate, k) = (u.yaw_rate(), T::from(-self.coefficient));
        if self.exponent >= 2.0 {
            return k * yaw_rate.odd_power(self.exponent - 1.0);
        }
        let slow = T::from(0.1 * tolerance) * (u.s.abs() + falling_rate);
        let size = (yaw_rate * yaw_rate + slow * slow).sqrt();
        k * (yaw_rate / size) * size.odd_power(self.exponent - 1.0)
    }
}

/// Equations of motion with resistance added.
#[derive(Debug, Clone, Copy)]
pub struct Resisted<L> {
    dynamics: L,
    resistance: Resistance,
    /// Whether any resistance is not zero.
    resists: bool,
    /// The tolerance of a step, within which air drag is smoothed.
    tolerance: f64,
}

impl<L> Resisted<L> {
    /// `dynamics` with `resistance`, for steps that may err by `tolerance`. Air drag with an exponent below 2 is
    /// smoothed where the yaw rate is smaller than a tenth of that, relative to the axial spin rate and √(g/R).
    pub fn new(dynamics: L, resistance: Resistance, tolerance: f64) -> Self {
        Resisted {
            dynamics,
            resistance,
            resists: !resistance.is_none(),
            tolerance,
        }
    }

    /// The equations without resistance.
    pub(crate) fn dynamics(&self) -> &L {
        &self.dynamics
    }

    /// The moments of resistance about e_x2 and e_z2 that act, times sin φ, under the normal force N = `normal`/sin φ.
    fn moment<T: Real>(&self, u: &Coordinates<T>, normal: T) -> [T; 2]
    where
        L: Dynamics<T>,
    {
        const FAINT_TILT: f64 = 1e-8;
        let k = self.dynamics.parameters();
        let moment = self.resistance.moment(k, u, normal, self.tolerance);
        if !self.dynamics.is_shaken() {
            return moment;
        }
        let ratio = u.sin * T::from(1.0 / FAINT_TILT);
        let fourth = (ratio * ratio) * (ratio * ratio);
        let factor = fourth / (T::from(1.0) + fourth);
        moment.map(|component| factor * component)
    }

    /// Adds the effect of resistance to the rates. It is not inlined, because a step has many copies of the rates.
    #[inline(never)]
    fn resisted<T: Real>(&self, u: &Coordinates<T>, rates: Coordinates<T>) -> Coordinates<T>
    where
        L: Dynamics<T>,
    {
        self.resist(u, rates, self.dynamics.contact(u).normal)
    }

    /// Adds the effect of resistance to the rates, given the normal force (times sin φ).
    #[inline(always)]
    pub(crate) fn resist<T: Real>(
        &self,
        u: &Coordinates<T>,
        rates: Coordinates<T>,
        normal: T,
    ) -> Coordinates<T>
    where
        L: Dynamics<T>,
    {
        if !self.resists {
            return rates;
        }
        self.with_moment(u, rates, self.moment(u, normal))
    }

    /// Adds the effect of moments of resistance to the rates.
    #[inline(always)]
    fn with_moment<T: Real>(
        &self,
        u: &Coordinates<T>,
        mut rates: Coordinates<T>,
        moment: [T; 2],
    ) -> Coordinates<T>
    where
        L: Dynamics<T>,
    {
        let k = self.dynamics.parameters();
        let constrained = self.dynamics.constrained_response(u, moment);
        let response = constrained.unwrap_or_else(|| Response::to(k, moment, T::from(0.0)));
        rates.w = rates.w + response.w;
        rates.s = rates.s + response.s;
        if constrained.is_none() {
            rates.slip_y = rates.slip_y + k.h * response.w - k.r * response.s;
        }
        let [about_x, about_z] = moment;
        rates.resistance_loss = -(about_x * u.w + about_z * u.s);
        rates
    }
}

impl<T: Real, L: Dynamics<T>> Dynamics<T> for Resisted<L> {
    fn parameters(&self) -> &Parameters<T> {
        self.dynamics.parameters()
    }

    #[inline(always)]
    fn reduced_rates(&self, u: &Coordinates<T>) -> Coordinates<T> {
        let rates = self.dynamics.reduced_rates(u);
        if self.resists {
            self.resisted(u, rates)
        } else {
            rates
        }
    }

    fn contact(&self, u: &Coordinates<T>) -> Contact<T> {
        let mut contact = self.dynamics.contact(u);
        if self.resists {
            let moment = self.moment(u, contact.normal);
            let constrained = self.dynamics.constrained_response(u, moment);
            let reaction = constrained.map_or(T::from(0.0), |response| response.across);
            contact.across = contact.across + reaction;
        }
        contact
    }

    fn center_velocity(&self, u: &Coordinates<T>) -> [T; 2] {
        self.dynamics.center_velocity(u)
    }

    fn slip(&self, u: &Coordinates<T>) -> [T; 2] {
        self.dynamics.slip(u)
    }

    fn constrained_response(&self, u: &Coordinates<T>, moment: [T; 2]) -> Option<Response<T>> {
        self.dynamics.constrained_response(u, moment)
    }

    fn resistance_rate(&self, u: &Coordinates<T>) -> T {
        let (k, normal) = (self.dynamics.parameters(), self.dynamics.contact(u).normal);
        let moment = self.resistance.moment(k, u, normal, self.tolerance);
        self.with_moment(u, Coordinates::zero(), moment).w
    }

    fn is_shaken(&self) -> bool {
        self.dynamics.is_shaken()
    }

    fn table_acceleration(&self, u: &Coordinates<T>) -> [T; 3] {
        self.dynamics.table_acceleration(u)
    }

    fn friction_ratio(&self, u: &Coordinates<T>) -> Option<T> {
        self.dynamics.friction_ratio(u)
    }

    fn flat_friction(&self, slip: [T; 2], normal: T) -> [T; 2] {
        self.dynamics.flat_friction(slip, normal)
    }

    fn consistency(&self, u: &Coordinates<T>) -> T {
        self.dynamics.consistency(u)
    }

    fn is_conservative(&self) -> bool {
        !self.resists && self.dynamics.is_conservative()
    }
}

/// The dynamics of a rim that rolls, with resistance.
#[derive(Clone)]
pub(crate) enum RollingDynamics<T: Scalar> {
    /// The rim rolls freely.
    Freely(Resisted<OnTable<NoSlip<T>, T>>),
    /// The rim rolls on the circle on which the body stood.
    InPlace(Resisted<OnTable<InPlace<T>, T>>),
}

impl<T: Scalar> RollingDynamics<T> {
    /// The dynamics on a table, with the arguments of [`Resisted::new`].
    pub(crate) fn new(
        friction: &FrictionLaw,
        k: Parameters<T>,
        table: &Table<T>,
        resistance: Resistance,
        tolerance: f64,
    ) -> Self {
        match friction {
            FrictionLaw::InPlace => {
                let rolling = OnTable::new(InPlace::new(k), table);
                RollingDynamics::InPlace(Resisted::new(rolling, resistance, tolerance))
            }
            _ => {
                let rolling = OnTable::new(NoSlip::new(k), table);
                RollingDynamics::Freely(Resisted::new(rolling, resistance, tolerance))
            }
        }
    }

    /// The equations of motion.
    pub(crate) fn dynamics(&self) -> &dyn Dynamics<T> {
        match self {
            RollingDynamics::Freely(dynamics) => dynamics,
            RollingDynamics::InPlace(dynamics) => dynamics,
        }
    }
}
