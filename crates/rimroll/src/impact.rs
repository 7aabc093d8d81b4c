//! Impact after flight: the impulse of the table on a rim that strikes it.
//!
//! Routh's incremental method with Coulomb friction. As the normal impulse P grows from zero, the
//! velocity (u_x, u_y, v) of the rim's lowest point changes by
//!
//! ```text
//! du_x = a (dP_x + κ dP),   du_y = b dP_y,   dv = d dP + κ du_x,
//!
//! a = 1/m + z²/A,   b = 1/m + R²/C + H²/A,   κ = −mρz/(A + mz²),   d = 1/m + ρ²/(A + mz²),
//! ```
//!
//! While the rim slips, the friction is (dP_x, dP_y) = −μ (u_x, u_y)/|u| dP. When the slip stops, the rim
//! sticks if |dP_x| ≤ μ dP suffices to hold it; otherwise it slips along e_x1. Compression ends at v = 0.
//! Restitution ends when the fraction e² of the work of compression has been returned, so no impact gains
//! energy. Source: W. J. Stronge, *Impact Mechanics* (2000), chapters 3 to 5.
//!
//! The impulses of friction, the change of the body's motion and the energy loss all follow from P and from
//! the change of (u_x, u_y). So they are consistent with each other: no slip ends without the impulse that
//! ends it.
//!
//! As the slip ends, its direction changes infinitely fast with respect to P, but the equations are smooth
//! with respect to ζ, where dP = |u| dζ. In any case u_y decays as exp(−μbζ), so explicit steps follow the
//! slip until it has stopped or is directed along e_x1. That happens before about ζ = 70/(μb) and takes at
//! most a few hundred steps for every body: either the rates are only a few times μb, or the slip turns into
//! e_x1 correspondingly sooner. After that everything is linear in P, even where u_x decays far more slowly
//! than u_y.

use crate::law::Parameters;
use crate::solve::{Stepper, System};
use crate::state::Coordinates;
use core::ops::ControlFlow;

/// The velocity changes of the rim's lowest point per unit of impulse at it.
#[derive(Debug, Clone, Copy)]
struct Mobility {
    /// a, 1/kg.
    along: f64,
    /// b, 1/kg.
    across: f64,
    /// d, for v at constant u_x, 1/kg.
    normal: f64,
    /// κ. A normal impulse of 1 with an impulse of −κ along e_x1 leaves u_x unchanged.
    coupling: f64,
}

/// The state of an impact in progress.
#[derive(Debug, Clone, Copy)]
struct ImpactState {
    slip: [f64; 2],
    /// P, N s.
    normal_impulse: f64,
    /// The work done by the normal impulse, J.
    work: f64,
}

/// The condition that ends a phase of an impact.
#[derive(Debug, Clone, Copy)]
enum PhaseEnd {
    /// Compression ends: v = 0.
    Compressed,
    /// Restitution ends: the work has risen to this value, J.
    Restored(f64),
}

/// An impact: its initial velocities and its parameters.
struct Impact {
    mobility: Mobility,
    friction: f64,
    /// The initial slip, m/s.
    slip: [f64; 2],
    /// The initial v, negative.
    approach: f64,
}

/// The coordinates after a body at `u` has struck a table with the given coefficients of friction and
/// restitution. A rebound slower than `rest` (m/s) counts as none. The energy loss is added to
/// `impact_loss`. Returns `None` where the slip cannot be followed to its end.
pub(crate) fn resolve(
    k: &Parameters<f64>,
    u: &Coordinates<f64>,
    friction: f64,
    restitution: f64,
    rest: f64,
) -> Option<Coordinates<f64>> {
    let impact = Impact {
        mobility: Mobility::new(k, u),
        friction,
        slip: [u.slip_x, u.slip_y],
        approach: u.gap_rate,
    };
    let compressed = impact.follow_phase(impact.initial_state(), PhaseEnd::Compressed)?;
    if restitution > 0.0 {
        let back = compressed.work * (1.0 - restitution * restitution);
        let restored = impact.follow_phase(compressed, PhaseEnd::Restored(back))?;
        let rebound = impact.velocity(&restored);
        if rebound > rest {
            return Some(impact.after(k, u, &restored, rebound));
        }
    }
    Some(impact.after(k, u, &compressed, 0.0))
}

impl Mobility {
    fn new(k: &Parameters<f64>, u: &Coordinates<f64>) -> Self {
        let (rho, z) = (k.rho(u), k.z(u));
        let inertia = k.a + k.m * z * z;
        Mobility {
            along: inertia / (k.m * k.a),
            across: k.sideways_mobility(),
            normal: 1.0 / k.m + rho * rho / inertia,
            coupling: -k.m * rho * z / inertia,
        }
    }
}

impl Impact {
    fn initial_state(&self) -> ImpactState {
        ImpactState {
            slip: self.slip,
            normal_impulse: 0.0,
            work: 0.0,
        }
    }

    /// v.
    fn velocity(&self, state: &ImpactState) -> f64 {
        let Mobility {
            normal, coupling, ..
        } = self.mobility;
        self.approach + normal * state.normal_impulse + coupling * (state.slip[0] - self.slip[0])
    }

    /// The event function of a phase: negative during the phase, zero at its end.
    fn event(&self, phase_end: PhaseEnd, state: &ImpactState) -> f64 {
        match phase_end {
            PhaseEnd::Compressed => self.velocity(state),
            PhaseEnd::Restored(work) => state.work - work,
        }
    }

    /// The state at the end of one phase; `None` where the slip cannot be followed.
    fn follow_phase(&self, mut state: ImpactState, phase_end: PhaseEnd) -> Option<ImpactState> {
        if self.event(phase_end, &state) >= 0.0 {
            return Some(state);
        }
        if self.friction == 0.0 {
            let (_, to_end) = self.impulses_of_straight_slip(&state, 0.0, phase_end);
            return Some(self.advanced(&state, 0.0, to_end));
        }
        if state.slip[1] != 0.0 {
            match self.follow_slip(state, phase_end)? {
                ControlFlow::Break(end) => return Some(end),
                ControlFlow::Continue(straight) => state = straight,
            }
        }
        if state.slip[0] != 0.0 {
            let friction_ratio = -self.friction * state.slip[0].signum();
            let (to_stop, to_end) =
                self.impulses_of_straight_slip(&state, friction_ratio, phase_end);
            if to_end <= to_stop {
                return Some(self.advanced(&state, friction_ratio, to_end));
            }
            state = self.advanced(&state, friction_ratio, to_stop);
            state.slip[0] = 0.0;
        }
        let friction_ratio = (-self.mobility.coupling).clamp(-self.friction, self.friction);
        let (_, to_end) = self.impulses_of_straight_slip(&state, friction_ratio, phase_end);
        Some(self.advanced(&state, friction_ratio, to_end))
    }

    /// Follows a slip in two dimensions. Breaks at the end of the phase; continues where the slip has
    /// stopped or is directed along e_x1.
    fn follow_slip(
        &self,
        mut state: ImpactState,
        phase_end: PhaseEnd,
    ) -> Option<ControlFlow<ImpactState, ImpactState>> {
        const MAX_STEPS: usize = 10_000;
        let Mobility {
            along,
            across,
            normal,
            coupling,
        } = self.mobility;
        let speed = libm::hypot(state.slip[0], state.slip[1]);
        let turning = self.friction * (along + across) + coupling.abs() * along;
        let pressing = normal * speed / self.approach.abs();
        let sliding = SlipFlow {
            impact: self,
            rate: turning + pressing,
        };
        let stopped = f64::EPSILON * (speed + self.approach.abs());
        let mut stepper = Stepper::new(&sliding, state.as_array(), 0.01 / sliding.rate, 1e-14);
        let event = |a: &[f64; 4]| self.event(phase_end, &ImpactState::from_array(a));
        for _ in 0..MAX_STEPS {
            let [ux, uy] = state.slip;
            if libm::hypot(ux, uy) <= stopped {
                state.slip = [0.0; 2];
                return Some(ControlFlow::Continue(state));
            }
            if uy.abs() <= 0.5 * f64::EPSILON * ux.abs() {
                state.slip[1] = 0.0;
                return Some(ControlFlow::Continue(state));
            }
            let step = stepper.advance().ok()?;
            if event(&step.end) >= 0.0 {
                let dense = step.dense(&sliding);
                let end = dense.at(dense.root(0.0, 1.0, event));
                return Some(ControlFlow::Break(ImpactState::from_array(&end)));
            }
            state = ImpactState::from_array(&step.end);
        }
        None
    }

    /// The further normal impulses that stop u_x and that end the phase while dP_x = `friction_ratio` dP
    /// (infinite where they never do). Requires u_y = 0 or no friction, so that everything is linear in P.
    fn impulses_of_straight_slip(
        &self,
        state: &ImpactState,
        friction_ratio: f64,
        phase_end: PhaseEnd,
    ) -> (f64, f64) {
        let (slipping, rising) = self.per_impulse(friction_ratio);
        let v = self.velocity(state);
        let to_stop = -state.slip[0] / slipping;
        let to_end = match phase_end {
            PhaseEnd::Compressed if rising > 0.0 => -v / rising,
            PhaseEnd::Compressed => f64::INFINITY,
            PhaseEnd::Restored(work) => {
                // v² grows by 2 · rising · work.
                let missing = work - state.work;
                let end = (v * v + 2.0 * rising * missing).sqrt();
                if v >= 0.0 {
                    2.0 * missing / (v + end)
                } else {
                    (end - v) / rising
                }
            }
        };
        let positive = |p: f64| if p >= 0.0 { p } else { f64::INFINITY };
        (positive(to_stop), positive(to_end))
    }

    /// du_x/dP and dv/dP while dP_x = `friction_ratio` dP.
    fn per_impulse(&self, friction_ratio: f64) -> (f64, f64) {
        let Mobility {
            along,
            normal,
            coupling,
            ..
        } = self.mobility;
        let slipping = along * (coupling + friction_ratio);
        (slipping, normal + coupling * slipping)
    }

    fn advanced(&self, state: &ImpactState, friction_ratio: f64, by: f64) -> ImpactState {
        let (slipping, rising) = self.per_impulse(friction_ratio);
        let [ux, uy] = state.slip;
        ImpactState {
            slip: [ux + slipping * by, uy],
            normal_impulse: state.normal_impulse + by,
            work: state.work + (self.velocity(state) + 0.5 * rising * by) * by,
        }
    }

    /// The body after the impact, rebounding at `v`.
    fn after(
        &self,
        k: &Parameters<f64>,
        u: &Coordinates<f64>,
        end: &ImpactState,
        v: f64,
    ) -> Coordinates<f64> {
        let (rho, z) = (k.rho(u), k.z(u));
        let Mobility {
            along,
            across,
            coupling,
            ..
        } = self.mobility;
        let change: [f64; 2] = core::array::from_fn(|i| end.slip[i] - self.slip[i]);
        let impulse = [
            change[0] / along - coupling * end.normal_impulse,
            change[1] / across,
            end.normal_impulse,
        ];
        // The work of an impulse is its product with the mean of the velocities before and after.
        let twice_mean = [
            self.slip[0] + end.slip[0],
            self.slip[1] + end.slip[1],
            self.approach + v,
        ];
        let work: f64 = (0..3).map(|i| 0.5 * twice_mean[i] * impulse[i]).sum();
        Coordinates {
            p: u.p + (k.m * z * change[0] - rho * end.normal_impulse) / (k.a + k.m * z * z),
            w: u.w + k.h * impulse[1] / k.a,
            s: u.s - k.r * impulse[1] / k.c,
            slip_x: end.slip[0],
            slip_y: end.slip[1],
            gap: 0.0,
            gap_rate: v,
            impact_loss: u.impact_loss - work,
            ..*u
        }
    }
}

impl ImpactState {
    fn as_array(&self) -> [f64; 4] {
        [self.slip[0], self.slip[1], self.normal_impulse, self.work]
    }

    fn from_array(&[ux, uy, normal_impulse, work]: &[f64; 4]) -> Self {
        ImpactState {
            slip: [ux, uy],
            normal_impulse,
            work,
        }
    }
}

/// The differential equations of the slip, the normal impulse and its work, with respect to ζ.
struct SlipFlow<'a> {
    impact: &'a Impact,
    /// The sum of all rates with respect to ζ, for the error scales.
    rate: f64,
}

impl System<f64, 4> for SlipFlow<'_> {
    fn rates(&self, a: &[f64; 4]) -> [f64; 4] {
        let friction = self.impact.friction;
        let Mobility {
            along,
            across,
            coupling,
            ..
        } = self.impact.mobility;
        let state = ImpactState::from_array(a);
        let [ux, uy] = state.slip;
        let pressing = (ux * ux + uy * uy).sqrt();
        [
            along * (coupling * pressing - friction * ux),
            -across * friction * uy,
            pressing,
            self.impact.velocity(&state) * pressing,
        ]
    }

    fn scale(&self, a: &[f64; 4]) -> [f64; 4] {
        let [ux, uy, normal_impulse, work] = *a;
        let slip = (ux * ux + uy * uy).sqrt();
        let impulse = normal_impulse + slip / self.rate;
        let speed = self.impact.velocity(&ImpactState::from_array(a)).abs() + slip;
        // The error of u_y is relative to its own size; otherwise u_y would stop decaying at the tolerance.
        [slip, uy.abs(), impulse, work.abs() + speed * impulse]
    }
}

#[cfg(test)]
mod tests;
