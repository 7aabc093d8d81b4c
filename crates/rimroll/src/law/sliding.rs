//! Sliding under a friction that depends on the slip: what the paper's two laws have between them.
//!
//! Newton's and Euler's equations with the table's force (T_x, T_y, N) on the rim, in the frame
//! e_x1, e_y1, e_z that yaws; w = ψ̇ sin φ, and (u_x, u_y) is the slip:
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
//! which fails to be one equation for one push N where A + mρη ≤ 0 (Painlevé's paradox). Forces and moments of
//! inertia are here taken over m, which saves multiplications.
//! The equations are derived by computer algebra in `tests/test_sliding_equations.py`.

use super::{Contact, Coulomb, Dynamics, Parameters, Resisted};
use crate::real::{Real, fieldwise};
use crate::state::Coordinates;

/// The force T = N a + b of a table on a rim that slips.
#[derive(Debug, Clone, Copy)]
pub struct FrictionForce<T> {
    /// a times `of`: the friction along e_x1 and e_y1 that so many newtons of normal force bring. Dry
    /// friction is −μu for each |u|, which takes no division.
    pub per_normal: [T; 2],
    /// Positive.
    pub of: T,
    /// b: whatever the normal force, N; `None` where there is no such part.
    pub own: Option<[T; 2]>,
}

impl<T: Real> FrictionForce<T> {
    /// Friction −factor · slip for each newton of normal force.
    #[inline(always)]
    pub fn per_normal(slip: [T; 2], factor: T) -> Self {
        FrictionForce::per_scaled_normal(slip, factor, T::from(1.0))
    }

    /// Friction −factor · slip for so many newtons of normal force.
    #[inline(always)]
    pub fn per_scaled_normal(slip: [T; 2], factor: T, of: T) -> Self {
        let against = -factor;
        FrictionForce {
            per_normal: [against * slip[0], against * slip[1]],
            of,
            own: None,
        }
    }
}

/// How friction answers slip.
pub trait Friction<T: Real> {
    /// The friction at a slip (m/s, along e_x1 and e_y1).
    fn friction_force(&self, slip: [T; 2]) -> FrictionForce<T>;
}

/// Dry friction: against the slip however slow it is, T = −μ(|u|) N u/|u|. A rim that does not slip is held,
/// and rolls.
pub trait DryFriction<T: Real>: Friction<T> {
    /// μ of a slip of this speed (m/s), which may be 0.
    fn coefficient(&self, speed: T) -> T;

    /// The friction at a slip: [`Friction::friction_force`] of dry friction.
    #[inline(always)]
    fn dry_friction_force(&self, slip: [T; 2]) -> FrictionForce<T> {
        let speed = (slip[0] * slip[0] + slip[1] * slip[1]).sqrt();
        FrictionForce::per_scaled_normal(slip, self.coefficient(speed), speed)
    }
}

/// Sliding under dry friction, whatever its coefficient: what is asked of it where the slip begins.
pub(crate) trait DryDynamics: Dynamics<f64> {
    /// The table's force (times sin φ) and the rates at a slip in the direction of a unit vector,
    /// however slow.
    fn slipping(
        &self,
        u: &Coordinates<f64>,
        direction: [f64; 2],
        speed: f64,
    ) -> (Contact<f64>, Coordinates<f64>);

    /// [`Dynamics::consistency`] where a slip begins in the direction of a unit vector.
    fn consistency_at_onset(&self, u: &Coordinates<f64>, direction: [f64; 2]) -> f64;
}

impl<F: DryFriction<f64>> DryDynamics for Resisted<Sliding<f64, F>> {
    fn slipping(
        &self,
        u: &Coordinates<f64>,
        direction: [f64; 2],
        speed: f64,
    ) -> (Contact<f64>, Coordinates<f64>) {
        let sliding = self.dynamics();
        let (contact, rates) = sliding.under(u, &sliding.against(direction, speed));
        (contact, self.resist(u, rates, contact.normal))
    }

    fn consistency_at_onset(&self, u: &Coordinates<f64>, direction: [f64; 2]) -> f64 {
        let sliding = self.dynamics();
        sliding.consistency_under(u, &sliding.against(direction, 0.0))
    }
}

/// The law of a rim that slides under the friction `F`.
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

/// The clock by which rates are wanted.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Pace<T> {
    /// How fast it goes, as a part of τ.
    pub clock: T,
    /// That over what a push on the rim has to [move](Sliding::inertia).
    pub per_inertia: T,
}

/// The rates of the velocities by a clock.
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
    /// The law for one body under one gravity.
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

    /// The friction at a slip.
    #[inline(always)]
    pub(crate) fn friction(&self) -> &F {
        &self.friction
    }

    /// η times what the pull is of.
    #[inline(always)]
    fn eta(&self, u: &Coordinates<T>, friction_force: &FrictionForce<T>) -> T {
        friction_force.of * self.k.rho(u) - friction_force.per_normal[0] * self.k.z(u)
    }

    /// What a push on the rim has to move, A/m + ρη, times what the pull is of.
    #[inline(always)]
    pub(crate) fn inertia(&self, u: &Coordinates<T>, friction_force: &FrictionForce<T>) -> T {
        self.a * friction_force.of + self.k.rho(u) * self.eta(u, friction_force)
    }

    /// By τ itself.
    #[inline(always)]
    fn pace(&self, u: &Coordinates<T>, friction_force: &FrictionForce<T>) -> Pace<T> {
        let one = T::from(1.0);
        Pace {
            clock: one,
            per_inertia: one / self.inertia(u, friction_force),
        }
    }

    /// The table's force over m, and φ̈, by a clock.
    #[inline(always)]
    fn forces(
        &self,
        u: &Coordinates<T>,
        friction_force: &FrictionForce<T>,
        pace: Pace<T>,
    ) -> (Contact<T>, T) {
        let (rho, z) = (self.k.rho(u), self.k.z(u));
        let FrictionForce {
            per_normal,
            of,
            own,
        } = *friction_force;
        let (mut gyroscopic_term, scaled_normal_force) =
            (self.gyroscopic_term(u), self.gravity_term(u));
        // N, too, over what the pull is of.
        let unaided = (self.a * scaled_normal_force + rho * gyroscopic_term) * pace.per_inertia;
        let mut contact = Contact {
            along: unaided * per_normal[0],
            across: unaided * per_normal[1],
            normal: unaided * of,
        };
        if let Some([x, y]) = own {
            let lifting = -(rho * u.sin * self.per_mass * x * z) * pace.per_inertia;
            let normal_factor = normal_factor(unaided, lifting);
            let normal = unaided - normal_factor * lifting;
            let share = normal_factor * u.sin * self.per_mass;
            let own = [share * x, share * y];
            gyroscopic_term = gyroscopic_term + own[0] * z;
            contact = Contact {
                along: normal * per_normal[0] + pace.clock * own[0],
                across: normal * per_normal[1] + pace.clock * own[1],
                normal: normal * of,
            };
        }
        let falling = of * gyroscopic_term - scaled_normal_force * self.eta(u, friction_force);
        (contact, falling * pace.per_inertia)
    }

    /// What the body's own motion does to turn it further, over m and times sin φ.
    #[inline(always)]
    fn gyroscopic_term(&self, u: &Coordinates<T>) -> T {
        u.w * (self.a * u.w * u.cos - u.sin * self.c * u.s)
    }

    /// (g − z φ̇²) sin φ.
    #[inline(always)]
    fn gravity_term(&self, u: &Coordinates<T>) -> T {
        u.sin * (self.k.g - self.k.z(u) * u.p * u.p)
    }

    /// N sin φ without a pull's own part, times the [inertia](Self::inertia) over (m times what the pull is of),
    /// which is no division.
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
        clock: T,
    ) -> Accelerations<T> {
        let k = &self.k;
        let Contact { along, across, .. } = *contact;
        let (yawing, falling) = (clock * u.w, clock * u.sin * u.p);
        let spun = falling * self.c_over_a * u.s;
        let carried = u.slip_y + k.r * u.s - k.h * u.w;
        Accelerations {
            p: dp,
            w: spun + self.h_over_a * across - yawing * (u.p * u.cos),
            s: -self.r_over_c * across,
            slip: [
                yawing * carried + falling * u.p * k.rho(u) + k.z(u) * dp + along,
                falling * k.r * u.w - yawing * u.slip_x
                    + k.h * spun
                    + across * self.sideways_mobility,
            ],
        }
    }

    /// The table's force (times sin φ) and the rates, under a friction that is given rather than found
    /// from the slip.
    #[inline]
    pub(crate) fn under(
        &self,
        u: &Coordinates<T>,
        friction_force: &FrictionForce<T>,
    ) -> (Contact<T>, Coordinates<T>) {
        let (contact, rates) = self.reduced_rates_under(u, friction_force);
        (contact, u.with_place(rates, self.center_velocity(u)))
    }

    /// The same but for spin and place.
    #[inline(always)]
    pub(crate) fn reduced_rates_under(
        &self,
        u: &Coordinates<T>,
        friction_force: &FrictionForce<T>,
    ) -> (Contact<T>, Coordinates<T>) {
        self.rates_under(u, friction_force, self.pace(u, friction_force))
    }

    /// The same by another clock.
    #[inline(always)]
    pub(crate) fn rates_under(
        &self,
        u: &Coordinates<T>,
        friction_force: &FrictionForce<T>,
        pace: Pace<T>,
    ) -> (Contact<T>, Coordinates<T>) {
        let (contact, dp) = self.forces(u, friction_force, pace);
        let Accelerations { p, w, s, slip } = self.accelerations(u, &contact, dp, pace.clock);
        let rates = Coordinates {
            p,
            w,
            s,
            slip_x: slip[0],
            slip_y: slip[1],
            friction_loss: -self.k.m * (contact.along * u.slip_x + contact.across * u.slip_y),
            ..u.kinematics_in(pace.clock)
        };
        (contact.times(self.k.m), rates)
    }

    /// [`Dynamics::consistency`] under a friction that is given.
    #[inline(always)]
    pub(crate) fn consistency_under(
        &self,
        u: &Coordinates<T>,
        friction_force: &FrictionForce<T>,
    ) -> T {
        let k = &self.k;
        let (rho, z) = (k.rho(u), k.z(u));
        let along = friction_force.per_normal[0] / friction_force.of;
        T::from(1.0) - k.m * rho * z * along / (k.a + k.m * rho * rho)
    }

    /// [`Dynamics::consistency`] less `margin`, times A/m + ρ² and what the pull is of, which is no division.
    #[inline(always)]
    pub(crate) fn clearance(&self, u: &Coordinates<T>, margin: T) -> T {
        let (rho, z) = (self.k.rho(u), self.k.z(u));
        let friction_force = self.friction_force(u);
        let normal_factor = (T::from(1.0) - margin) * (self.a + rho * rho);
        normal_factor * friction_force.of - rho * z * friction_force.per_normal[0]
    }

    /// The friction at the slip that there is.
    #[inline(always)]
    pub(crate) fn friction_force(&self, u: &Coordinates<T>) -> FrictionForce<T> {
        self.friction.friction_force([u.slip_x, u.slip_y])
    }
}

impl<T: Real, F: DryFriction<T>> Sliding<T, F> {
    /// The friction on a slip in the direction of a unit vector, however slow.
    #[inline(always)]
    fn against(&self, direction: [T; 2], speed: T) -> FrictionForce<T> {
        FrictionForce::per_normal(direction, self.friction.coefficient(speed))
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
        let (contact, _) = self.forces(u, &friction_force, self.pace(u, &friction_force));
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
            per_normal: [x, y],
            of,
            own,
        } = self.friction_force(u);
        own.is_none().then(|| (x * x + y * y).sqrt() / of)
    }

    #[inline(always)]
    fn consistency(&self, u: &Coordinates<T>) -> T {
        self.consistency_under(u, &self.friction_force(u))
    }
}

/// How much is kept of a pull of its own that would lift the rim it needs to touch: it gives way until
/// nothing presses, and altogether where nothing would without it.
fn normal_factor<T: Real>(unaided: T, lifting: T) -> T {
    let (none, all) = (T::from(0.0), T::from(1.0));
    let part = unaided.where_negative(none, unaided / lifting);
    lifting.where_negative(all, (unaided - lifting).where_negative(part, all))
}
