//! What wears a motion down besides friction: moments that can be added to any law.
//!
//! * [`RollingResistance`]: the contact point works the rim as it runs along it at R|θ̇|. Generalised
//!   force on θ alone, Q = −(k N R + c R² |θ̇|) sgn θ̇; being felt by no turn about the vertical, it is the
//!   moment Q about e_z2 and −Q cos φ/sin φ about e_x2. (The "contour friction" of R. I. Leine,
//!   Arch. Appl. Mech. 79 (2009), and the "rolling friction" of the Euler's-disk literature.)
//! * [`PivotingFriction`]: a moment −k N sgn ω_z about the vertical, of a contact of finite size.
//! * [`AirDrag`]: a moment about e_x2 against the wobble, of power k |ψ̇|ⁿ.
//!
//! Let a disk lie nearly flat at the tilt α, wobbling at Ω² = 4g/(Rα) (uniform disk), and lose a power
//! ~ Ω^λ: then α ~ (t₀ − t)^{2/(2+λ)}. Dry rolling resistance has λ = 1, viscous λ = 2, air λ = n.
//!
//! The viscous part and the air's fade out where less than some thousandths of the weight press.
//!
//! sgn is smoothed to x/√(x² + x₀²), so that a rate may pass through zero: x is the angular velocity
//! about the vertical or, for rolling, about the horizontal through the contact point and the centre of
//! the base, θ̇ sin φ; x₀ = √(g/R)/1000.

use super::{Contact, Dynamics, Parameters};
use crate::real::Real;
use crate::state::Coordinates;

/// Resistance to the contact point's running along the rim.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct RollingResistance {
    /// k: the resisting force for each newton of normal force.
    pub dry: f64,
    /// c, N s/m: the resisting force for each m/s.
    pub viscous: f64,
}

/// Resistance to turning about the vertical on the spot.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct PivotingFriction {
    /// k, m: the moment for each newton of normal force.
    pub length: f64,
}

/// Resistance of the air between base and table to the wobble.
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

/// All that is added to a law.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Resistance {
    /// To rolling.
    pub rolling: RollingResistance,
    /// To pivoting.
    pub pivoting: PivotingFriction,
    /// Of the air.
    pub air: AirDrag,
}

impl Resistance {
    /// Whether there is none.
    pub fn is_none(&self) -> bool {
        let none = Resistance::default();
        self.rolling == none.rolling
            && self.pivoting == none.pivoting
            && self.air.coefficient == 0.0
    }

    /// The moments about e_x2 and e_z2 times sin φ, under the force N = `normal`/sin φ.
    fn moment<T: Real>(&self, k: &Parameters<T>, u: &Coordinates<T>, normal: T) -> [T; 2] {
        let smooth = T::from(1e-3) * (k.g / k.r).sqrt();
        let touching = touching(k, u, normal);
        let [rolling_x, rolling_z] = self.rolling.moment(k, u, normal, smooth, touching);
        let [pivoting_x, pivoting_z] = self.pivoting.moment(u, normal, smooth);
        [
            rolling_x + pivoting_x + touching * self.air.moment(u, smooth),
            rolling_z + pivoting_z,
        ]
    }
}

/// How much there is of a resistance that does not grow with the load: all of it but where hardly
/// anything presses any more. In flight there is none, and were it to end at once, the rim could be held
/// on the table by what ends as it leaves.
fn touching<T: Real>(k: &Parameters<T>, u: &Coordinates<T>, normal: T) -> T {
    const SOFT: f64 = 1000.0;
    let load = normal / (k.m * u.sin * k.g);
    let some = T::from(1.0) - (T::from(-SOFT) * load).exp();
    normal.where_negative(T::from(0.0), some)
}

impl RollingResistance {
    fn moment<T: Real>(
        &self,
        k: &Parameters<T>,
        u: &Coordinates<T>,
        normal: T,
        smooth: T,
        touching: T,
    ) -> [T; 2] {
        // θ̇ sin φ, the angular velocity about −e_x1, which stays finite.
        let running = u.sin * u.s - u.w * u.cos;
        let sign = running / (running * running + smooth * smooth).sqrt();
        let dry = T::from(self.dry) * k.r * normal * sign;
        let viscous = touching * T::from(self.viscous) * k.r * k.r * running;
        let resistance_rate = dry + viscous;
        [resistance_rate * u.cos / u.sin, -resistance_rate]
    }
}

impl PivotingFriction {
    fn moment<T: Real>(&self, u: &Coordinates<T>, normal: T, smooth: T) -> [T; 2] {
        let gyroscopic_term = u.w * u.sin + u.s * u.cos;
        let sign = gyroscopic_term / (gyroscopic_term * gyroscopic_term + smooth * smooth).sqrt();
        let vertical = T::from(self.length) * normal * sign;
        [-vertical * u.sin, -vertical * u.cos]
    }
}

impl AirDrag {
    /// −k ψ̇ |ψ̇|ⁿ⁻². Below n = 2 its slope is infinite at ψ̇ = 0, and a ψ̇ that drag and gyroscopic moments
    /// hold close to 0 would relax infinitely fast; so |ψ̇| is there √(ψ̇² + ψ̇₀²).
    fn moment<T: Real>(&self, u: &Coordinates<T>, smooth: T) -> T {
        const NEGLIGIBLE: f64 = 1e-15;
        let (yaw_rate, k) = (u.yaw_rate(), T::from(-self.coefficient));
        if self.exponent >= 2.0 {
            return k * yaw_rate.odd_power(self.exponent - 1.0);
        }
        let slow = T::from(NEGLIGIBLE) * (u.s.abs() + T::from(1e3) * smooth);
        let size = (yaw_rate * yaw_rate + slow * slow).sqrt();
        k * (yaw_rate / size) * size.odd_power(self.exponent - 1.0)
    }
}

/// A law with resistance added.
#[derive(Debug, Clone, Copy)]
pub struct Resisted<L> {
    law: L,
    resistance: Resistance,
    /// Whether there is any.
    resists: bool,
}

impl<L> Resisted<L> {
    /// `law` with `resistance`.
    pub fn new(law: L, resistance: Resistance) -> Self {
        Resisted {
            law,
            resistance,
            resists: !resistance.is_none(),
        }
    }

    /// The law without it.
    pub(crate) fn dynamics(&self) -> &L {
        &self.law
    }

    /// Rates under moments beside the law's forces, given those without.
    #[inline(always)]
    pub(crate) fn resist<T: Real>(
        &self,
        u: &Coordinates<T>,
        mut rates: Coordinates<T>,
        normal: T,
    ) -> Coordinates<T>
    where
        L: Dynamics<T>,
    {
        if !self.resists {
            return rates;
        }
        let k = self.law.parameters();
        let [about_x, about_z] = self.resistance.moment(k, u, normal);
        let held = self.law.constraint_reaction([about_x, about_z]);
        let across = held.unwrap_or(T::from(0.0));
        let dw = (about_x + k.h * across) / k.a;
        let ds = (about_z - k.r * across) / k.c;
        rates.w = rates.w + dw;
        rates.s = rates.s + ds;
        if held.is_none() {
            rates.slip_y = rates.slip_y + k.h * dw - k.r * ds;
        }
        rates.resistance_loss = -(about_x * u.w + about_z * u.s);
        rates
    }
}

impl<T: Real, L: Dynamics<T>> Dynamics<T> for Resisted<L> {
    fn parameters(&self) -> &Parameters<T> {
        self.law.parameters()
    }

    #[inline(always)]
    fn reduced_rates(&self, u: &Coordinates<T>) -> Coordinates<T> {
        let rates = self.law.reduced_rates(u);
        if !self.resists {
            return rates;
        }
        self.resist(u, rates, self.law.contact(u).normal)
    }

    fn contact(&self, u: &Coordinates<T>) -> Contact<T> {
        let mut contact = self.law.contact(u);
        if self.resists {
            let moment = self
                .resistance
                .moment(self.law.parameters(), u, contact.normal);
            let held = self.law.constraint_reaction(moment).unwrap_or(T::from(0.0));
            contact.across = contact.across + held;
        }
        contact
    }

    fn center_velocity(&self, u: &Coordinates<T>) -> [T; 2] {
        self.law.center_velocity(u)
    }

    fn slip(&self, u: &Coordinates<T>) -> [T; 2] {
        self.law.slip(u)
    }

    fn constraint_reaction(&self, moment: [T; 2]) -> Option<T> {
        self.law.constraint_reaction(moment)
    }

    fn resistance_rate(&self, u: &Coordinates<T>) -> T {
        let normal = self.law.contact(u).normal;
        self.resist(u, Coordinates::zero(), normal).w
    }

    fn friction_ratio(&self, u: &Coordinates<T>) -> Option<T> {
        self.law.friction_ratio(u)
    }

    fn consistency(&self, u: &Coordinates<T>) -> T {
        self.law.consistency(u)
    }

    fn is_conservative(&self) -> bool {
        !self.resists && self.law.is_conservative()
    }
}
