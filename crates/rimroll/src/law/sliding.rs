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
//! which fails to be one equation for one push N where A + mρη ≤ 0 (Painlevé's paradox).
//! The equations are derived by computer algebra in `tests/test_sliding_equations.py`.

use super::{Contact, Law, Parameters};
use crate::real::Real;
use crate::state::Coordinates;

/// The force T = N a + b of a table on a rim that slips.
#[derive(Debug, Clone, Copy)]
pub struct Pull<T> {
    /// a times `of`: the friction along e_x1 and e_y1 that so many newtons of normal force bring. Dry
    /// friction is −μu for each |u|, which takes no division.
    pub per_normal: [T; 2],
    /// Positive.
    pub of: T,
    /// b: whatever the normal force, N; `None` where there is no such part.
    pub own: Option<[T; 2]>,
}

impl<T: Real> Pull<T> {
    /// Friction −factor · slip for each newton of normal force.
    #[inline(always)]
    pub fn per_normal(slip: [T; 2], factor: T) -> Self {
        Pull::per_normals(slip, factor, T::from(1.0))
    }

    /// Friction −factor · slip for so many newtons of normal force.
    #[inline(always)]
    pub fn per_normals(slip: [T; 2], factor: T, of: T) -> Self {
        let against = -factor;
        Pull {
            per_normal: [against * slip[0], against * slip[1]],
            of,
            own: None,
        }
    }
}

/// How friction answers slip.
pub trait Friction<T: Real> {
    /// The friction at a slip (m/s, along e_x1 and e_y1).
    fn pull(&self, slip: [T; 2]) -> Pull<T>;
}

/// The law of a rim that slides under the friction `F`.
#[derive(Debug, Clone, Copy)]
pub struct Sliding<T, F> {
    k: Parameters<T>,
    friction: F,
    /// 1/m + R²/C + H²/A.
    sideways_mobility: T,
    /// 1/m.
    per_mass: T,
    c_over_a: T,
    h_over_a: T,
    r_over_c: T,
}

/// The accelerations times sin φ.
struct Accelerations<T> {
    p: T,
    w: T,
    s: T,
    slip: [T; 2],
}

impl<T: Real, F> Sliding<T, F> {
    /// The same law for numbers of another type, under another friction.
    #[inline(always)]
    pub(crate) fn map<U, G>(&self, friction: G, f: impl Fn(T) -> U) -> Sliding<U, G> {
        Sliding {
            k: self.k.map(&f),
            friction,
            sideways_mobility: f(self.sideways_mobility),
            per_mass: f(self.per_mass),
            c_over_a: f(self.c_over_a),
            h_over_a: f(self.h_over_a),
            r_over_c: f(self.r_over_c),
        }
    }
}

impl<T: Real, F: Friction<T>> Sliding<T, F> {
    /// The law for one body under one gravity.
    pub fn new(k: Parameters<T>, friction: F) -> Self {
        Sliding {
            k,
            friction,
            sideways_mobility: k.sideways_mobility(),
            per_mass: T::from(1.0) / k.m,
            c_over_a: k.c / k.a,
            h_over_a: k.h / k.a,
            r_over_c: k.r / k.c,
        }
    }

    /// The friction at a slip.
    #[inline(always)]
    pub(crate) fn friction(&self) -> &F {
        &self.friction
    }

    /// η times what the pull is of.
    #[inline(always)]
    fn eta(&self, u: &Coordinates<T>, pull: &Pull<T>) -> T {
        pull.of * self.k.rho(u) - pull.per_normal[0] * self.k.z(u)
    }

    /// What a push on the rim has to move, A + mρη, times what the pull is of.
    #[inline(always)]
    pub(crate) fn inertia(&self, u: &Coordinates<T>, pull: &Pull<T>) -> T {
        self.k.a * pull.of + self.k.m * self.k.rho(u) * self.eta(u, pull)
    }

    /// The table's force, and φ̈ times sin φ; `per_inertia` is 1 over the [inertia](Self::inertia).
    #[inline(always)]
    fn forces(&self, u: &Coordinates<T>, pull: &Pull<T>, per_inertia: T) -> (Contact<T>, T) {
        let k = &self.k;
        let (rho, z) = (k.rho(u), k.z(u));
        let Pull {
            per_normal,
            of,
            own,
        } = *pull;
        let mut turning = u.w * (k.a * u.w * u.cos - u.sin * k.c * u.s);
        let pressing = u.sin * (k.g - z * u.p * u.p);
        // N, too, over what the pull is of.
        let unaided = k.m * (k.a * pressing + rho * turning) * per_inertia;
        let mut contact = Contact {
            along: unaided * per_normal[0],
            across: unaided * per_normal[1],
            normal: unaided * of,
        };
        if let Some(own) = own {
            let lifting = -(k.m * rho * u.sin * own[0] * z) * per_inertia;
            let kept = kept(unaided, lifting);
            let normal = unaided - kept * lifting;
            let own = [kept * u.sin * own[0], kept * u.sin * own[1]];
            turning = turning + own[0] * z;
            contact = Contact {
                along: normal * per_normal[0] + own[0],
                across: normal * per_normal[1] + own[1],
                normal: normal * of,
            };
        }
        let falling = of * turning - k.m * pressing * self.eta(u, pull);
        (contact, falling * per_inertia)
    }

    /// N sin φ without a pull's own part, times the [inertia](Self::inertia) over what the pull is of, which
    /// is no division.
    #[inline(always)]
    pub(crate) fn pressing(&self, u: &Coordinates<T>) -> T {
        let k = &self.k;
        let turning = u.w * (k.a * u.w * u.cos - u.sin * k.c * u.s);
        let pressing = u.sin * (k.g - k.z(u) * u.p * u.p);
        k.m * (k.a * pressing + k.rho(u) * turning)
    }

    #[inline(always)]
    fn accelerations(&self, u: &Coordinates<T>, contact: &Contact<T>, dp: T) -> Accelerations<T> {
        let k = &self.k;
        let Contact { along, across, .. } = *contact;
        let spun = u.sin * self.c_over_a * u.p * u.s;
        let carried = u.slip_y + k.r * u.s - k.h * u.w;
        Accelerations {
            p: dp,
            w: spun + self.h_over_a * across - u.w * u.p * u.cos,
            s: -(self.r_over_c * across),
            slip: [
                u.w * carried + u.sin * k.rho(u) * u.p * u.p + k.z(u) * dp + self.per_mass * along,
                u.sin * k.r * u.w * u.p - u.w * u.slip_x
                    + k.h * spun
                    + across * self.sideways_mobility,
            ],
        }
    }

    /// The table's force (times sin φ) and the rates, under a friction that is given rather than found
    /// from the slip.
    #[inline]
    pub(crate) fn under(&self, u: &Coordinates<T>, pull: &Pull<T>) -> (Contact<T>, Coordinates<T>) {
        let (contact, rates) = self.under_but_place(u, pull);
        (contact, u.with_place(rates, self.center_velocity(u)))
    }

    /// The same but for spin and place.
    #[inline(always)]
    pub(crate) fn under_but_place(
        &self,
        u: &Coordinates<T>,
        pull: &Pull<T>,
    ) -> (Contact<T>, Coordinates<T>) {
        self.moving(u, pull, T::from(1.0) / self.inertia(u, pull))
    }

    /// The same for whoever has 1 over the [inertia](Self::inertia).
    #[inline(always)]
    pub(crate) fn moving(
        &self,
        u: &Coordinates<T>,
        pull: &Pull<T>,
        per_inertia: T,
    ) -> (Contact<T>, Coordinates<T>) {
        let (contact, dp) = self.forces(u, pull, per_inertia);
        let Accelerations { p, w, s, slip } = self.accelerations(u, &contact, dp);
        let rates = Coordinates {
            p,
            w,
            s,
            slip_x: slip[0],
            slip_y: slip[1],
            friction_loss: -(contact.along * u.slip_x + contact.across * u.slip_y),
            ..u.kinematics()
        };
        (contact, rates)
    }

    /// [`Law::consistency`] under a friction that is given.
    #[inline(always)]
    pub(crate) fn consistency_under(&self, u: &Coordinates<T>, pull: &Pull<T>) -> T {
        let k = &self.k;
        let (rho, z) = (k.rho(u), k.z(u));
        let along = pull.per_normal[0] / pull.of;
        T::from(1.0) - k.m * rho * z * along / (k.a + k.m * rho * rho)
    }

    /// [`Law::consistency`] less `margin`, times A + mρ² and what the pull is of, which is no division.
    #[inline(always)]
    pub(crate) fn clearance(&self, u: &Coordinates<T>, margin: T) -> T {
        let k = &self.k;
        let (rho, z) = (k.rho(u), k.z(u));
        let pull = self.pull(u);
        let kept = (T::from(1.0) - margin) * (k.a + k.m * rho * rho);
        kept * pull.of - k.m * rho * z * pull.per_normal[0]
    }

    /// The friction at the slip that there is.
    #[inline(always)]
    pub(crate) fn pull(&self, u: &Coordinates<T>) -> Pull<T> {
        self.friction.pull([u.slip_x, u.slip_y])
    }
}

impl<T: Real, F: Friction<T>> Law<T> for Sliding<T, F> {
    fn parameters(&self) -> &Parameters<T> {
        &self.k
    }

    #[inline(always)]
    fn rates_but_place(&self, u: &Coordinates<T>) -> Coordinates<T> {
        self.under_but_place(u, &self.pull(u)).1
    }

    #[inline(always)]
    fn contact(&self, u: &Coordinates<T>) -> Contact<T> {
        let pull = self.pull(u);
        self.forces(u, &pull, T::from(1.0) / self.inertia(u, &pull))
            .0
    }

    #[inline(always)]
    fn center_velocity(&self, u: &Coordinates<T>) -> [T; 2] {
        let [vx, vy] = self.k.rolling_velocity(u);
        [vx + u.slip_x, vy + u.slip_y]
    }

    fn slip(&self, u: &Coordinates<T>) -> [T; 2] {
        [u.slip_x, u.slip_y]
    }

    #[inline(always)]
    fn consistency(&self, u: &Coordinates<T>) -> T {
        self.consistency_under(u, &self.pull(u))
    }
}

/// How much is kept of a pull of its own that would lift the rim it needs to touch: it gives way until
/// nothing presses, and altogether where nothing would without it.
fn kept<T: Real>(unaided: T, lifting: T) -> T {
    let (none, all) = (T::from(0.0), T::from(1.0));
    let part = unaided.where_negative(none, unaided / lifting);
    lifting.where_negative(all, (unaided - lifting).where_negative(part, all))
}
