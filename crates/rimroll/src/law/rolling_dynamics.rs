//! The equations of motion of a rim that rolls, under a friction law.

use super::{
    Dynamics, FrictionLaw, InPlace, NoSlip, OnTable, Parameters, Resistance, Resisted, Table,
};
use crate::real::Scalar;

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
