//! The equations of motion of each phase.

use super::instant::Phase;
use super::phase_system::{IndependentVariable, PhaseSystem};
use crate::contact_law::ContactLaw;
use crate::law::{Dynamics, Flight, OnTable, Parameters, RollingDynamics, SlidingDynamics, Table};
use crate::real::Scalar;
use crate::solve::System;
use crate::state::{COORDINATES, COORDINATES_AT_REST, RIGID_COORDINATES};

/// A computation with the system of equations of a phase. It is compiled separately for each of the most
/// frequent laws.
pub(super) trait SystemVisitor {
    type Output;

    /// Runs the computation on a system in which only the first N coordinates change.
    fn with<S: System<f64, N>, const N: usize>(self, system: &S) -> Self::Output;
}

/// The equations of motion of a body under a contact law in each phase.
#[derive(Clone)]
pub(super) struct PhaseDynamics<T: Scalar> {
    pub(super) rolling: RollingDynamics<T>,
    pub(super) sliding: SlidingDynamics<T>,
    pub(super) flying: OnTable<Flight<T>, T>,
    /// What a step may err by.
    tolerance: f64,
}

impl<T: Scalar> PhaseDynamics<T> {
    /// Under a law on a table, for steps that may err by `tolerance`.
    pub(super) fn new(
        k: Parameters<T>,
        contact_law: &ContactLaw,
        table: &Table<T>,
        tolerance: f64,
    ) -> Self {
        let (friction, resistance) = (&contact_law.friction, contact_law.resistance);
        PhaseDynamics {
            rolling: RollingDynamics::new(friction, k, table, resistance, tolerance),
            sliding: SlidingDynamics::new(friction, k, table, resistance, tolerance),
            flying: OnTable::new(Flight::new(k), table),
            tolerance,
        }
    }

    /// The equations that hold in a phase.
    pub(super) fn in_phase(&self, phase: Phase) -> &dyn Dynamics<T> {
        match phase {
            Phase::Rolling => self.rolling.dynamics(),
            Phase::Sliding => self.sliding.dynamics().unwrap_or(self.rolling.dynamics()),
            // Only the energy of a body that is level or lies on its side is computed by these.
            Phase::Flying
            | Phase::Standing
            | Phase::SlidingFlat
            | Phase::FlyingLevel
            | Phase::Lying => &self.flying,
        }
    }

    /// The system of a phase, as the solver integrates it.
    pub(super) fn phase_system(
        &self,
        phase: Phase,
        variable: IndependentVariable,
    ) -> PhaseSystem<'_, T> {
        let dynamics = self.in_phase(phase);
        let phase_system = if phase == Phase::Sliding && self.sliding.is_dry() {
            PhaseSystem::slipping(dynamics, variable)
        } else {
            PhaseSystem::new(dynamics, variable)
        };
        if self.flying.moves() {
            phase_system.on_moving_table(self.tolerance)
        } else {
            phase_system
        }
    }
}

impl PhaseDynamics<f64> {
    /// Runs a computation with the system of differential equations of a phase. It is compiled for each of the most
    /// frequent laws on a table at rest, and once for all others.
    pub(super) fn solve<K: SystemVisitor>(
        &self,
        phase: Phase,
        variable: IndependentVariable,
        visitor: K,
    ) -> K::Output {
        if self.flying.moves() {
            return visitor.with::<_, COORDINATES>(&self.phase_system(phase, variable));
        }
        match (phase, &self.sliding, &self.rolling) {
            (Phase::Rolling, _, RollingDynamics::Freely(rolling))
            | (Phase::Sliding, SlidingDynamics::Never, RollingDynamics::Freely(rolling))
                if rolling.is_conservative() =>
            {
                let rolling = rolling.dynamics().dynamics();
                visitor.with::<_, RIGID_COORDINATES>(&PhaseSystem::new(rolling, variable))
            }
            (Phase::Sliding, SlidingDynamics::Frictionless(sliding), _)
                if sliding.is_conservative() =>
            {
                let sliding = sliding.dynamics();
                visitor.with::<_, RIGID_COORDINATES>(&PhaseSystem::new(sliding, variable))
            }
            (Phase::Sliding, SlidingDynamics::Coulomb(sliding), _) => {
                visitor.with::<_, COORDINATES_AT_REST>(&PhaseSystem::slipping(sliding, variable))
            }
            _ => visitor.with::<_, COORDINATES_AT_REST>(&self.phase_system(phase, variable)),
        }
    }
}
