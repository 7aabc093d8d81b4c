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
use crate::real::{Dual, Scalar, Slopes};
use crate::solve::{Step, Stepper, System};
use crate::state::Coordinates;
use core::ops::ControlFlow;

/// The velocity changes of the rim's lowest point per unit of impulse at it.
#[derive(Debug, Clone, Copy)]
struct Mobility<T> {
    /// a, 1/kg.
    along: T,
    /// b, 1/kg.
    across: T,
    /// d, for v at constant u_x, 1/kg.
    normal: T,
    /// κ. A normal impulse of 1 with an impulse of −κ along e_x1 leaves u_x unchanged.
    coupling: T,
}

/// The state of an impact in progress.
#[derive(Debug, Clone, Copy)]
struct ImpactState<T> {
    slip: [T; 2],
    /// P, N s.
    normal_impulse: T,
    /// The work done by the normal impulse, J.
    work: T,
}

/// The condition that ends a phase of an impact.
#[derive(Debug, Clone, Copy)]
pub(crate) enum PhaseEnd<T> {
    /// Compression ends: v = 0.
    Compressed,
    /// Restitution ends: the work has risen to this value, J.
    Restored(T),
}

impl<T: Scalar> PhaseEnd<T> {
    /// Without derivatives.
    fn value(self) -> PhaseEnd<f64> {
        match self {
            PhaseEnd::Compressed => PhaseEnd::Compressed,
            PhaseEnd::Restored(work) => PhaseEnd::Restored(work.value()),
        }
    }
}

/// An impact: its initial velocities and its parameters.
pub(crate) struct Impact<T> {
    mobility: Mobility<T>,
    friction: T,
    /// The initial slip, m/s.
    slip: [T; 2],
    /// The initial v, negative.
    approach: T,
}

/// A number type in which the steps of a slip can be repeated.
pub(crate) trait Repeated: Scalar {
    /// The end of a step that was made from values, where `start` has those at its start.
    fn end_of_step(flow: &SlipFlow<'_, Self>, start: [Self; 4], step: &Step<f64, 4>) -> [Self; 4];

    /// The state in that step where a phase ends, given its values there and the fraction of the step.
    fn end_of_phase(
        flow: &SlipFlow<'_, Self>,
        start: [Self; 4],
        step: (f64, [f64; 4]),
        phase_end: PhaseEnd<Self>,
    ) -> [Self; 4];
}

impl Repeated for f64 {
    fn end_of_step(_: &SlipFlow<'_, f64>, _: [f64; 4], step: &Step<f64, 4>) -> [f64; 4] {
        step.end
    }

    fn end_of_phase(
        _: &SlipFlow<'_, f64>,
        _: [f64; 4],
        (_, end): (f64, [f64; 4]),
        _: PhaseEnd<f64>,
    ) -> [f64; 4] {
        end
    }
}

/// The step sizes are held constant, and the end of a phase is where its event function is zero.
impl<const K: usize> Repeated for Dual<Slopes<K>> {
    fn end_of_step(flow: &SlipFlow<'_, Self>, start: [Self; 4], step: &Step<f64, 4>) -> [Self; 4] {
        Step::take(flow, &start, step.h.into()).end
    }

    fn end_of_phase(
        flow: &SlipFlow<'_, Self>,
        start: [Self; 4],
        (h, _): (f64, [f64; 4]),
        phase_end: PhaseEnd<Self>,
    ) -> [Self; 4] {
        let end = Step::take(flow, &start, h.into()).end;
        let rates = flow.rates(&end);
        let level = |a: &[Self; 4]| flow.impact.event(phase_end, &ImpactState::from_array(a));
        // The rate of the event function, from values that move along the rates alone.
        let pressing = rates[2].value;
        let event_rate = match phase_end {
            PhaseEnd::Compressed => {
                let Mobility {
                    normal, coupling, ..
                } = flow.impact.mobility;
                normal.value * pressing + coupling.value * rates[0].value
            }
            PhaseEnd::Restored(_) => rates[3].value,
        };
        let delay = level(&end).slope * (-1.0 / event_rate);
        core::array::from_fn(|i| Dual {
            value: end[i].value,
            slope: end[i].slope + delay * rates[i].value,
        })
    }
}

/// The coordinates after a body at `u` has struck a table with the given coefficients of friction and
/// restitution. A rebound slower than `rest` (m/s) counts as none. The energy loss is added to
/// `impact_loss`. Returns `None` where the slip cannot be followed to its end.
pub(crate) fn resolve<T: Repeated>(
    k: &Parameters<T>,
    u: &Coordinates<T>,
    friction: T,
    restitution: f64,
    rest: f64,
) -> Option<Coordinates<T>> {
    let impact = Impact {
        mobility: Mobility::new(k, u),
        friction,
        slip: [u.slip_x, u.slip_y],
        approach: u.gap_rate,
    };
    let compressed = impact.follow_phase(impact.initial_state(), PhaseEnd::Compressed)?;
    if restitution > 0.0 {
        let back = compressed.work * T::from(1.0 - restitution * restitution);
        let restored = impact.follow_phase(compressed, PhaseEnd::Restored(back))?;
        let rebound = impact.velocity(&restored);
        if rebound.value() > rest {
            return Some(impact.after(k, u, &restored, rebound));
        }
    }
    Some(impact.after(k, u, &compressed, T::from(0.0)))
}

impl<T: Scalar> Mobility<T> {
    fn new(k: &Parameters<T>, u: &Coordinates<T>) -> Self {
        let (rho, z) = (k.rho(u), k.z(u));
        let inertia = k.a + k.m * z * z;
        Mobility {
            along: inertia / (k.m * k.a),
            across: k.sideways_mobility(),
            normal: T::from(1.0) / k.m + rho * rho / inertia,
            coupling: -k.m * rho * z / inertia,
        }
    }

    /// Without derivatives.
    fn value(&self) -> Mobility<f64> {
        Mobility {
            along: self.along.value(),
            across: self.across.value(),
            normal: self.normal.value(),
            coupling: self.coupling.value(),
        }
    }
}

impl<T: Repeated> Impact<T> {
    /// Without derivatives.
    fn value(&self) -> Impact<f64> {
        Impact {
            mobility: self.mobility.value(),
            friction: self.friction.value(),
            slip: self.slip.map(Scalar::value),
            approach: self.approach.value(),
        }
    }

    fn initial_state(&self) -> ImpactState<T> {
        ImpactState {
            slip: self.slip,
            normal_impulse: T::from(0.0),
            work: T::from(0.0),
        }
    }

    /// v.
    fn velocity(&self, state: &ImpactState<T>) -> T {
        let Mobility {
            normal, coupling, ..
        } = self.mobility;
        self.approach + normal * state.normal_impulse + coupling * (state.slip[0] - self.slip[0])
    }

    /// The event function of a phase: negative during the phase, zero at its end.
    fn event(&self, phase_end: PhaseEnd<T>, state: &ImpactState<T>) -> T {
        match phase_end {
            PhaseEnd::Compressed => self.velocity(state),
            PhaseEnd::Restored(work) => state.work - work,
        }
    }

    /// The state at the end of one phase; `None` where the slip cannot be followed.
    fn follow_phase(
        &self,
        mut state: ImpactState<T>,
        phase_end: PhaseEnd<T>,
    ) -> Option<ImpactState<T>> {
        let zero = T::from(0.0);
        if self.event(phase_end, &state).value() >= 0.0 {
            return Some(state);
        }
        if self.friction.value() == 0.0 {
            let (_, to_end) = self.impulses_of_straight_slip(&state, zero, phase_end);
            return Some(self.advanced(&state, zero, to_end));
        }
        if state.slip[1].value() != 0.0 {
            match self.follow_slip(state, phase_end)? {
                ControlFlow::Break(end) => return Some(end),
                ControlFlow::Continue(straight) => state = straight,
            }
        }
        if state.slip[0].value() != 0.0 {
            let friction_ratio = state.slip[0].where_negative(self.friction, -self.friction);
            let (to_stop, to_end) =
                self.impulses_of_straight_slip(&state, friction_ratio, phase_end);
            if to_end.value() <= to_stop.value() {
                return Some(self.advanced(&state, friction_ratio, to_end));
            }
            state = self.advanced(&state, friction_ratio, to_stop);
            state.slip[0] = zero;
        }
        let holding = -self.mobility.coupling;
        let friction_ratio = holding.max(-self.friction).min(self.friction);
        let (_, to_end) = self.impulses_of_straight_slip(&state, friction_ratio, phase_end);
        Some(self.advanced(&state, friction_ratio, to_end))
    }

    /// Follows a slip in two dimensions. Breaks at the end of the phase; continues where the slip has
    /// stopped or is directed along e_x1.
    fn follow_slip(
        &self,
        mut state: ImpactState<T>,
        phase_end: PhaseEnd<T>,
    ) -> Option<ControlFlow<ImpactState<T>, ImpactState<T>>> {
        const MAX_STEPS: usize = 10_000;
        let (impact, phase_end_value) = (self.value(), phase_end.value());
        let Mobility {
            along,
            across,
            normal,
            coupling,
        } = impact.mobility;
        let speed = libm::hypot(state.slip[0].value(), state.slip[1].value());
        let turning = impact.friction * (along + across) + coupling.abs() * along;
        let pressing = normal * speed / impact.approach.abs();
        let rate = turning + pressing;
        let sliding = SlipFlow {
            impact: &impact,
            rate,
        };
        let repeated = SlipFlow {
            impact: self,
            rate: T::from(rate),
        };
        let stopped = f64::EPSILON * (speed + impact.approach.abs());
        let start = state.as_array().map(Scalar::value);
        let mut stepper = Stepper::new(&sliding, start, 0.01 / sliding.rate, 1e-14);
        let event = |a: &[f64; 4]| impact.event(phase_end_value, &ImpactState::from_array(a));
        let mut values = ImpactState::from_array(&start);
        for _ in 0..MAX_STEPS {
            let [ux, uy] = values.slip;
            if libm::hypot(ux, uy) <= stopped {
                state.slip = [T::from(0.0); 2];
                return Some(ControlFlow::Continue(state));
            }
            if uy.abs() <= 0.5 * f64::EPSILON * ux.abs() {
                state.slip[1] = T::from(0.0);
                return Some(ControlFlow::Continue(state));
            }
            let step = stepper.advance().ok()?;
            if event(&step.end) >= 0.0 {
                let dense = step.dense(&sliding);
                let x = dense.root(0.0, 1.0, event);
                let end = (x * dense.h, dense.at(x));
                let end = T::end_of_phase(&repeated, state.as_array(), end, phase_end);
                return Some(ControlFlow::Break(ImpactState::from_array(&end)));
            }
            values = ImpactState::from_array(&step.end);
            let end = T::end_of_step(&repeated, state.as_array(), step);
            state = ImpactState::from_array(&end);
        }
        None
    }

    /// The further normal impulses that stop u_x and that end the phase while dP_x = `friction_ratio` dP
    /// (infinite where they never do). Requires u_y = 0 or no friction, so that everything is linear in P.
    fn impulses_of_straight_slip(
        &self,
        state: &ImpactState<T>,
        friction_ratio: T,
        phase_end: PhaseEnd<T>,
    ) -> (T, T) {
        let (never, two) = (T::from(f64::INFINITY), T::from(2.0));
        let (slipping, rising) = self.per_impulse(friction_ratio);
        let v = self.velocity(state);
        let to_stop = -state.slip[0] / slipping;
        let to_end = match phase_end {
            PhaseEnd::Compressed if rising.value() > 0.0 => -v / rising,
            PhaseEnd::Compressed => never,
            PhaseEnd::Restored(work) => {
                // v² grows by 2 · rising · work.
                let missing = work - state.work;
                let end = (v * v + two * rising * missing).sqrt();
                if v.value() >= 0.0 {
                    two * missing / (v + end)
                } else {
                    (end - v) / rising
                }
            }
        };
        let positive = |p: T| if p.value() >= 0.0 { p } else { never };
        (positive(to_stop), positive(to_end))
    }

    /// du_x/dP and dv/dP while dP_x = `friction_ratio` dP.
    fn per_impulse(&self, friction_ratio: T) -> (T, T) {
        let Mobility {
            along,
            normal,
            coupling,
            ..
        } = self.mobility;
        let slipping = along * (coupling + friction_ratio);
        (slipping, normal + coupling * slipping)
    }

    fn advanced(&self, state: &ImpactState<T>, friction_ratio: T, by: T) -> ImpactState<T> {
        let (slipping, rising) = self.per_impulse(friction_ratio);
        let [ux, uy] = state.slip;
        ImpactState {
            slip: [ux + slipping * by, uy],
            normal_impulse: state.normal_impulse + by,
            work: state.work + (self.velocity(state) + T::from(0.5) * rising * by) * by,
        }
    }

    /// The body after the impact, rebounding at `v`.
    fn after(
        &self,
        k: &Parameters<T>,
        u: &Coordinates<T>,
        end: &ImpactState<T>,
        v: T,
    ) -> Coordinates<T> {
        let (rho, z) = (k.rho(u), k.z(u));
        let Mobility {
            along,
            across,
            coupling,
            ..
        } = self.mobility;
        let change: [T; 2] = core::array::from_fn(|i| end.slip[i] - self.slip[i]);
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
        let half = T::from(0.5);
        let [x, y, z_work] = core::array::from_fn(|i: usize| half * twice_mean[i] * impulse[i]);
        let work = x + y + z_work;
        Coordinates {
            p: u.p + (k.m * z * change[0] - rho * end.normal_impulse) / (k.a + k.m * z * z),
            w: u.w + k.h * impulse[1] / k.a,
            s: u.s - k.r * impulse[1] / k.c,
            slip_x: end.slip[0],
            slip_y: end.slip[1],
            gap: T::from(0.0),
            gap_rate: v,
            impact_loss: u.impact_loss - work,
            ..*u
        }
    }
}

impl<T: Scalar> ImpactState<T> {
    fn as_array(&self) -> [T; 4] {
        [self.slip[0], self.slip[1], self.normal_impulse, self.work]
    }

    fn from_array(&[ux, uy, normal_impulse, work]: &[T; 4]) -> Self {
        ImpactState {
            slip: [ux, uy],
            normal_impulse,
            work,
        }
    }
}

/// The differential equations of the slip, the normal impulse and its work, with respect to ζ.
pub(crate) struct SlipFlow<'a, T> {
    impact: &'a Impact<T>,
    /// The sum of all rates with respect to ζ, for the error scales.
    rate: T,
}

impl<T: Repeated> System<T, 4> for SlipFlow<'_, T> {
    fn rates(&self, a: &[T; 4]) -> [T; 4] {
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
            -(across * friction * uy),
            pressing,
            self.impact.velocity(&state) * pressing,
        ]
    }

    fn scale(&self, a: &[T; 4]) -> [T; 4] {
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
