//! Sliding under a friction that depends on the slip, between the paper's two ideal laws.
//!
//! Newton's and Euler's equations with the contact force (T_x, T_y, N) on the rim, in the yawing frame
//! e_x1, e_y1, e_z; w = ψ̇ sin φ, and (u_x, u_y) is the slip:
//!
//! ```text
//! A (ẇ + ψ̇ φ̇ cosφ) = C φ̇ s + H T_y
//! A φ̈ = A w ψ̇ cosφ − C w s − N ρ + T_x z,     C ṡ = −R T_y
//! N = m (g + ρ φ̈ − z φ̇²)
//! u̇_x =  ψ̇ (u_y + R s − H w) + ρ φ̇² + z φ̈ + T_x/m
//! u̇_y = −ψ̇ u_x + R w φ̇ + (HC/A) φ̇ s + T_y (1/m + R²/C + H²/A)
//! ```
//!
//! The friction is linear in the normal force, T = N a(u) + b(u), so with η = ρ − a_x z
//!
//! ```text
//! (A + mρη) N = m (A (g − z φ̇²) + ρ (A w ψ̇ cosφ − C w s + b_x z))
//! ```
//!
//! which does not determine N where A + mρη ≤ 0 (the Painlevé paradox). In the code, forces and moments of
//! inertia are divided by m, which saves multiplications. The equations are derived by computer algebra in
//! `tests/proofs/test_sliding_equations.py`.

use super::{
    Contact, Coulomb, DryFriction, Dynamics, Friction, FrictionForce, InertialEffect, Movable,
    OnTable, Parameters, Resisted,
};
use crate::real::{Real, fieldwise};
use crate::state::Coordinates;

/// Sliding under any dry friction, with what the onset of slip needs.
pub(crate) trait DryDynamics: Dynamics<f64> {
    /// The contact force (times sin φ) and the rates at a slip of the given speed, which may be 0, in the
    /// direction of a unit vector.
    fn slipping(
        &self,
        u: &Coordinates<f64>,
        direction: [f64; 2],
        speed: f64,
    ) -> (Contact<f64>, Coordinates<f64>);

    /// [`Dynamics::consistency`] at the onset of a slip in the direction of a unit vector.
    fn consistency_at_onset(&self, u: &Coordinates<f64>, direction: [f64; 2]) -> f64;
}

impl<F: DryFriction<f64> + Clone> DryDynamics for Resisted<OnTable<Sliding<f64, F>>> {
    fn slipping(
        &self,
        u: &Coordinates<f64>,
        direction: [f64; 2],
        speed: f64,
    ) -> (Contact<f64>, Coordinates<f64>) {
        let on_table = self.dynamics();
        let friction_force = on_table.dynamics().against(direction, speed);
        let (contact, rates) = on_table.under_friction(u, &friction_force);
        (contact, self.resist(u, rates, contact.normal))
    }

    fn consistency_at_onset(&self, u: &Coordinates<f64>, direction: [f64; 2]) -> f64 {
        let sliding = self.dynamics().dynamics();
        sliding.consistency_under(u, &sliding.against(direction, 0.0))
    }
}

/// The equations of motion of a rim that slides under the friction `F`.
#[derive(Debug, Clone, Copy)]
pub struct Sliding<T, F> {
    k: Parameters<T>,
    friction: F,
    /// 1/m.
    per_mass: T,
    /// A/m.
    a: T,
    /// C/m.
    c: T,
    /// 1 + mR²/C + mH²/A.
    sideways_mobility: T,
    c_over_a: T,
    /// mH/A.
    h_over_a: T,
    /// mR/C.
    r_over_c: T,
}

/// The independent variable σ of the rates, with dτ = `factor` dσ.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SundmanScaling<T> {
    /// dτ/dσ.
    pub factor: T,
    /// `factor` divided by the [inertia](Sliding::inertia).
    pub per_inertia: T,
}

/// The rates of the velocities with respect to σ.
struct Accelerations<T> {
    p: T,
    w: T,
    s: T,
    slip: [T; 2],
}

/// Sliding under dry friction.
pub(crate) type SlidingDry<T> = Sliding<T, Coulomb<T>>;

fieldwise!(SlidingDry {
    per_mass, a, c, sideways_mobility, c_over_a, h_over_a, r_over_c; k, friction
});

impl<T: Real, F: Friction<T>> Sliding<T, F> {
    /// The equations for one body under one gravity.
    pub fn new(k: Parameters<T>, friction: F) -> Self {
        Sliding {
            k,
            friction,
            per_mass: T::from(1.0) / k.m,
            a: k.a / k.m,
            c: k.c / k.m,
            sideways_mobility: k.m * k.sideways_mobility(),
            c_over_a: k.c / k.a,
            h_over_a: k.m * k.h / k.a,
            r_over_c: k.m * k.r / k.c,
        }
    }

    /// The friction law.
    #[inline(always)]
    pub(crate) fn friction(&self) -> &F {
        &self.friction
    }

    /// η times the denominator of the friction.
    #[inline(always)]
    fn eta(&self, u: &Coordinates<T>, friction_force: &FrictionForce<T>) -> T {
        friction_force.denominator * self.k.rho(u) - friction_force.numerator[0] * self.k.z(u)
    }

    /// A/m + ρη, times the denominator of the friction.
    #[inline(always)]
    pub(crate) fn inertia(&self, u: &Coordinates<T>, friction_force: &FrictionForce<T>) -> T {
        self.a * friction_force.denominator + self.k.rho(u) * self.eta(u, friction_force)
    }

    /// The scaling for rates with respect to τ itself.
    #[inline(always)]
    fn scaling(&self, u: &Coordinates<T>, friction_force: &FrictionForce<T>) -> SundmanScaling<T> {
        let one = T::from(1.0);
        SundmanScaling {
            factor: one,
            per_inertia: one / self.inertia(u, friction_force),
        }
    }

    /// The contact force over m and φ̈, both times dt/dσ.
    #[inline(always)]
    fn forces(
        &self,
        u: &Coordinates<T>,
        friction_force: &FrictionForce<T>,
        scaling: SundmanScaling<T>,
    ) -> (Contact<T>, T) {
        let (rho, z) = (self.k.rho(u), self.k.z(u));
        let FrictionForce {
            numerator,
            denominator,
            load_independent,
        } = *friction_force;
        let (mut gyroscopic_term, gravity_term) = (self.gyroscopic_term(u), self.gravity_term(u));
        // N over the denominator of the friction.
        let normal_alone = (self.a * gravity_term + rho * gyroscopic_term) * scaling.per_inertia;
        let mut contact = Contact {
            along: normal_alone * numerator[0],
            across: normal_alone * numerator[1],
            normal: normal_alone * denominator,
        };
        if let Some([x, y]) = load_independent {
            let lift = -(rho * u.sin * self.per_mass * x * z) * scaling.per_inertia;
            let fraction = load_independent_fraction(normal_alone, lift);
            let normal = normal_alone - fraction * lift;
            let scale = fraction * u.sin * self.per_mass;
            let load_independent = [scale * x, scale * y];
            gyroscopic_term = gyroscopic_term + load_independent[0] * z;
            contact = Contact {
                along: normal * numerator[0] + scaling.factor * load_independent[0],
                across: normal * numerator[1] + scaling.factor * load_independent[1],
                normal: normal * denominator,
            };
        }
        let falling = denominator * gyroscopic_term - gravity_term * self.eta(u, friction_force);
        (contact, falling * scaling.per_inertia)
    }

    /// The gyroscopic moment (A w ψ̇ cos φ − C w s) sin φ over m.
    #[inline(always)]
    fn gyroscopic_term(&self, u: &Coordinates<T>) -> T {
        u.w * (self.a * u.w * u.cos - u.sin * self.c * u.s)
    }

    /// (g − z φ̇²) sin φ.
    #[inline(always)]
    fn gravity_term(&self, u: &Coordinates<T>) -> T {
        u.sin * (self.k.g - self.k.z(u) * u.p * u.p)
    }

    /// N sin φ without load-independent friction, times [`Self::inertia`] and divided by m and by the
    /// denominator of the friction. It takes no division and has the sign of N where A + mρη > 0.
    #[inline(always)]
    pub(crate) fn scaled_normal_force(&self, u: &Coordinates<T>) -> T {
        self.a * self.gravity_term(u) + self.k.rho(u) * self.gyroscopic_term(u)
    }

    #[inline(always)]
    fn accelerations(
        &self,
        u: &Coordinates<T>,
        contact: &Contact<T>,
        dp: T,
        factor: T,
    ) -> Accelerations<T> {
        let k = &self.k;
        let Contact { along, across, .. } = *contact;
        let (yawing, falling) = (factor * u.w, factor * u.sin * u.p);
        let spun = falling * self.c_over_a * u.s;
        let yawed = u.slip_y + k.r * u.s - k.h * u.w;
        Accelerations {
            p: dp,
            w: spun + self.h_over_a * across - yawing * (u.p * u.cos),
            s: -self.r_over_c * across,
            slip: [
                yawing * yawed + falling * u.p * k.rho(u) + k.z(u) * dp + along,
                falling * k.r * u.w - yawing * u.slip_x
                    + k.h * spun
                    + across * self.sideways_mobility,
            ],
        }
    }

    /// The contact force (times sin φ) and the rates under a given friction force.
    #[inline]
    pub(crate) fn under(
        &self,
        u: &Coordinates<T>,
        friction_force: &FrictionForce<T>,
    ) -> (Contact<T>, Coordinates<T>) {
        let (contact, rates) = self.reduced_rates_under(u, friction_force);
        (
            contact,
            u.with_spin_and_center(rates, self.center_velocity(u)),
        )
    }

    /// The contact force (times sin φ) and the rates of the reduced state, without spin and position.
    #[inline(always)]
    pub(crate) fn reduced_rates_under(
        &self,
        u: &Coordinates<T>,
        friction_force: &FrictionForce<T>,
    ) -> (Contact<T>, Coordinates<T>) {
        self.rates_under(u, friction_force, self.scaling(u, friction_force))
    }

    /// As [`Self::reduced_rates_under`], with respect to the σ of `scaling`.
    #[inline(always)]
    pub(crate) fn rates_under(
        &self,
        u: &Coordinates<T>,
        friction_force: &FrictionForce<T>,
        scaling: SundmanScaling<T>,
    ) -> (Contact<T>, Coordinates<T>) {
        let (contact, dp) = self.forces(u, friction_force, scaling);
        let Accelerations { p, w, s, slip } = self.accelerations(u, &contact, dp, scaling.factor);
        let rates = Coordinates {
            p,
            w,
            s,
            slip_x: slip[0],
            slip_y: slip[1],
            friction_loss: -self.k.m * (contact.along * u.slip_x + contact.across * u.slip_y),
            ..u.scaled_kinematics(scaling.factor)
        };
        (contact.times(self.k.m), rates)
    }

    /// [`Dynamics::consistency`] under a given friction force.
    #[inline(always)]
    pub(crate) fn consistency_under(
        &self,
        u: &Coordinates<T>,
        friction_force: &FrictionForce<T>,
    ) -> T {
        let k = &self.k;
        let (rho, z) = (k.rho(u), k.z(u));
        let along = friction_force.numerator[0] / friction_force.denominator;
        T::from(1.0) - k.m * rho * z * along / (k.a + k.m * rho * rho)
    }

    /// [`Dynamics::consistency`] less `margin`, times A/m + ρ² and the denominator of the friction, which
    /// avoids a division.
    #[inline(always)]
    pub(crate) fn consistency_margin(&self, u: &Coordinates<T>, margin: T) -> T {
        let (rho, z) = (self.k.rho(u), self.k.z(u));
        let friction_force = self.friction_force(u);
        let required = (T::from(1.0) - margin) * (self.a + rho * rho);
        required * friction_force.denominator - rho * z * friction_force.numerator[0]
    }

    /// The friction force at the present slip.
    #[inline(always)]
    pub(crate) fn friction_force(&self, u: &Coordinates<T>) -> FrictionForce<T> {
        self.friction.friction_force([u.slip_x, u.slip_y])
    }
}

impl<T: Real, F: DryFriction<T>> Sliding<T, F> {
    /// The friction force at a slip of the given speed, which may be 0, in the direction of a unit vector.
    #[inline(always)]
    fn against(&self, direction: [T; 2], speed: T) -> FrictionForce<T> {
        FrictionForce::proportional_to_normal(direction, self.friction.coefficient(speed))
    }
}

impl<T: Real, F: Friction<T>> Dynamics<T> for Sliding<T, F> {
    fn parameters(&self) -> &Parameters<T> {
        &self.k
    }

    #[inline(always)]
    fn reduced_rates(&self, u: &Coordinates<T>) -> Coordinates<T> {
        self.reduced_rates_under(u, &self.friction_force(u)).1
    }

    #[inline(always)]
    fn contact(&self, u: &Coordinates<T>) -> Contact<T> {
        let friction_force = self.friction_force(u);
        let (contact, _) = self.forces(u, &friction_force, self.scaling(u, &friction_force));
        contact.times(self.k.m)
    }

    #[inline(always)]
    fn center_velocity(&self, u: &Coordinates<T>) -> [T; 2] {
        let [vx, vy] = self.k.rolling_velocity(u);
        [vx + u.slip_x, vy + u.slip_y]
    }

    fn slip(&self, u: &Coordinates<T>) -> [T; 2] {
        [u.slip_x, u.slip_y]
    }

    fn friction_ratio(&self, u: &Coordinates<T>) -> Option<T> {
        let FrictionForce {
            numerator: [x, y],
            denominator,
            load_independent,
        } = self.friction_force(u);
        load_independent
            .is_none()
            .then(|| (x * x + y * y).sqrt() / denominator)
    }

    fn flat_friction(&self, slip: [T; 2], normal: T) -> [T; 2] {
        let FrictionForce {
            numerator,
            denominator,
            load_independent,
        } = self.friction.friction_force(slip);
        let independent = load_independent.unwrap_or([T::from(0.0); 2]);
        core::array::from_fn(|i| normal * numerator[i] / denominator + independent[i])
    }

    #[inline(always)]
    fn consistency(&self, u: &Coordinates<T>) -> T {
        self.consistency_under(u, &self.friction_force(u))
    }
}

impl<T: Real, F: Friction<T> + Clone> Movable<T> for Sliding<T, F> {
    #[inline(always)]
    fn set_gravity(&mut self, gravity: T) {
        self.k.g = gravity;
    }

    #[inline(always)]
    fn inertial_effect(&self, u: &Coordinates<T>, acceleration: [T; 2]) -> InertialEffect<T> {
        InertialEffect::staying_behind(u, acceleration)
    }
}

/// The fraction λ of a load-independent friction that acts, so that it does not lift the rim off the film.
/// It is 1 while the normal force is positive, else the value at which the normal force is zero, and 0
/// where the normal force is negative without that friction.
fn load_independent_fraction<T: Real>(normal_alone: T, lift: T) -> T {
    let (zero, one) = (T::from(0.0), T::from(1.0));
    let partial = normal_alone.where_negative(zero, normal_alone / lift);
    lift.where_negative(one, (normal_alone - lift).where_negative(partial, one))
}
