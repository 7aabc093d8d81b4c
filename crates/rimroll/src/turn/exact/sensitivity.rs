//! Derivatives of the turn with respect to start, body and gravity, by the quadrature in dual numbers.

use super::frictionless::FrictionlessTilt;
use super::fundamental_solutions::Fundamental;
use super::no_slip::NoSlipTilt;
use super::start::Start;
use super::{Exact, Outcome};
use crate::error::InvalidInput;
use crate::law::Parameters;
use crate::motion::{PARAMETERS, Slope};
use crate::real::{Dual, Slopes};
use crate::state::State;
#[cfg(feature = "threads")]
use rayon::prelude::*;

type Number = Dual<Slopes<{ PARAMETERS.len() }>>;

impl Exact {
    /// The derivatives of the turns of many starts with respect to each of [`PARAMETERS`] (rad per SI unit), for
    /// bodies that rock or topple. NaN for other outcomes and for the few starts outside the range of the
    /// quadrature.
    ///
    /// # Errors
    /// As [`Exact::turns`].
    pub fn turn_slopes(&self, starts: &[State]) -> Result<Vec<Slope>, InvalidInput> {
        let slopes = self.turn_slopes_while(starts, || true)?;
        Ok(slopes.expect("nothing has ended the work"))
    }

    /// The derivatives of the turns of many starts, or `None` if `should_continue` returns false. It is called
    /// before each start.
    ///
    /// # Errors
    /// As [`Exact::turns`].
    pub fn turn_slopes_while(
        &self,
        starts: &[State],
        should_continue: impl Fn() -> bool + Sync,
    ) -> Result<Option<Vec<Slope>>, InvalidInput> {
        for start in starts {
            self.check(start)?;
        }
        let k = self.varied_parameters();
        let table = self.table.as_ref().map(|table| Fundamental::like(table, k));
        let slope = |start: &State| {
            let slope = || self.slope_of(start, k, table.as_ref());
            should_continue().then(|| slope().unwrap_or([f64::NAN; PARAMETERS.len()]))
        };
        #[cfg(feature = "threads")]
        let starts = starts.par_iter();
        #[cfg(not(feature = "threads"))]
        let starts = starts.iter();
        Ok(starts.map(slope).collect())
    }

    fn slope_of(
        &self,
        start: &State,
        k: Parameters<Number>,
        table: Option<&Fundamental<Number>>,
    ) -> Option<Slope> {
        if self.is_beyond(start) {
            return None;
        }
        let varied = [
            (start.tilt, "tilt"),
            (start.tilt_rate, "tilt_rate"),
            (start.yaw_rate, "yaw_rate"),
            (start.spin_rate, "spin_rate"),
        ];
        let start = Start::new(varied.map(|(value, name)| along(value, name)));
        let outcome = match table {
            Some(table) => self.scalar(&NoSlipTilt::new(table, &start), &k, start),
            None => self.scalar(&FrictionlessTilt::new(k, &start), &k, start),
        }?;
        let known = matches!(outcome.ending, Outcome::Rocked | Outcome::Toppled);
        let turn = (outcome.down? + outcome.up?).yaw;
        known.then_some(turn.slope.0)
    }

    fn varied_parameters(&self) -> Parameters<Number> {
        let k = self.parameters;
        Parameters {
            m: along(k.m, "mass"),
            r: along(k.r, "radius"),
            h: along(k.h, "height"),
            a: along(k.a, "transverse_inertia"),
            c: along(k.c, "axial_inertia"),
            g: along(k.g, "gravity"),
        }
    }
}

/// A dual number whose slope is 1 in the direction of the named parameter.
fn along(value: f64, name: &str) -> Number {
    Dual {
        value,
        slope: Slopes(PARAMETERS.map(|parameter| f64::from(u8::from(parameter == name)))),
    }
}
