//! The equations of motion of each phase.

use super::instant::Phase;
use super::mechanics::Mechanics;
use crate::contact_law::ContactLaw;
use crate::law::{Dynamics, Flight, NoSlip, Parameters, Resisted, SlidingDynamics};
use crate::real::Scalar;

/// The equations of motion of a body under a contact law in each phase.
#[derive(Clone)]
pub(super) struct PhaseDynamics<T: Scalar> {
    pub(super) rolling: Resisted<NoSlip<T>>,
    pub(super) sliding: SlidingDynamics<T>,
    pub(super) flying: Flight<T>,
}

impl<T: Scalar> PhaseDynamics<T> {
    /// Under a law, for steps that may err by `tolerance`.
    pub(super) fn new(k: Parameters<T>, contact_law: &ContactLaw, tolerance: f64) -> Self {
        let (friction, resistance) = (&contact_law.friction, contact_law.resistance);
        PhaseDynamics {
            rolling: Resisted::new(NoSlip::new(k), resistance, tolerance),
            sliding: SlidingDynamics::new(friction, k, resistance, tolerance),
            flying: Flight::new(k),
        }
    }

    /// Those that hold in a phase.
    pub(super) fn in_phase(&self, phase: Phase) -> &dyn Dynamics<T> {
        match phase {
            Phase::Rolling => &self.rolling,
            Phase::Sliding => self.sliding.dynamics().unwrap_or(&self.rolling),
            // A body that lies on its side does not move; only its energy is computed.
            Phase::Flying | Phase::Lying => &self.flying,
        }
    }

    /// Those that hold in a phase, as the solver sees them.
    pub(super) fn mechanics(&self, phase: Phase) -> Mechanics<'_, T> {
        let dynamics = self.in_phase(phase);
        if phase == Phase::Sliding && self.sliding.is_dry() {
            Mechanics::slipping(dynamics)
        } else {
            Mechanics::new(dynamics)
        }
    }
}
