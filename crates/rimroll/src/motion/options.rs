//! The options of a simulation and their checks.

use super::flat_landing::{FlatLanding, check_gap};
use super::instant::LEVEL_PHASES;
use crate::body::Body;
use crate::error::{InvalidInput, bounded, out_of_bounds, positive};
use crate::law::{FrictionLaw, InPlace};
use crate::state::State;
use core::f64::consts::{FRAC_PI_2, PI};

/// Standard gravity, m/s² (exact by convention). The paper used 9.8.
pub const STANDARD_GRAVITY: f64 = 9.80665;

/// Options of a simulation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Options {
    /// The duration of the motion, s.
    pub duration: f64,
    /// g, m/s².
    pub gravity: f64,
    /// The target error over tens of rocking motions, relative to the error scale of each coordinate. Below
    /// 1e-13 rounding dominates. The error of a step may be a fiftieth of `rtol`, and the errors add up:
    /// after thousands of steps the energy can be off by a few hundred times `rtol`.
    pub rtol: f64,
    /// The tilt at which the body counts as toppled, rad. `None` means π/2 for a body with height, where
    /// its side meets the table, and no limit for a disk, which can stand on its edge and fall to either
    /// face.
    pub topple_tilt: Option<f64>,
    /// What follows where the whole base comes down flat at once.
    pub flat: FlatLanding,
    /// The base comes down flat also where it falls below the tilt at which the opposite point of the rim is this far above
    /// the table, m. From 0, which means only there where it is flat, to a tenth of the radius.
    pub flat_gap: f64,
    /// The maximal number of steps. A rocking motion takes tens of steps, but hundreds if slip oscillates while
    /// the contact point runs many times round the rim, as under regularised friction with a small transverse
    /// inertia: each oscillation takes a few steps.
    pub max_steps: usize,
}

impl Default for Options {
    fn default() -> Self {
        Options {
            duration: 2.0,
            gravity: STANDARD_GRAVITY,
            rtol: 1e-10,
            topple_tilt: None,
            flat: FlatLanding::Stop,
            flat_gap: 0.0,
            max_steps: 1_000_000,
        }
    }
}

impl Options {
    /// The tolerance of one step, relative to the error scale of each coordinate.
    ///
    /// The errors of the steps add up, so the tolerance of a step is a fiftieth of `rtol`. Measured over 20
    /// rocking motions of a can, a disk, a coin and a bottle under both ideal laws, the error of the energy
    /// is then at most 0.4 rtol, and those of the yaw and of the times of the near-collisions at most 2 rtol.
    /// Below 5e-15 the error estimate would consist of rounding errors.
    pub(crate) fn step_tolerance(&self) -> f64 {
        (0.02 * self.rtol).max(5e-15)
    }

    /// The sign of a tilt rate is significant if the rate exceeds this fraction of its error scale. In a steady
    /// wobble it never is.
    pub(crate) fn significant_tilt_rate(&self) -> f64 {
        10.0 * self.rtol
    }

    /// The index of the first body and start from which no motion can be computed under the friction law of this name,
    /// if there is one.
    pub fn first_refused<'a>(
        &self,
        law: &str,
        starts: impl IntoIterator<Item = (&'a Body, State)>,
    ) -> Option<usize> {
        let in_place = law == FrictionLaw::InPlace.name();
        let mut checks = self.checks(starts, |_| in_place);
        checks.position(|check| check.is_err())
    }

    /// Checks many bodies and starts, some of which (by their index) wobble in place.
    pub(crate) fn check_all<'a>(
        &self,
        starts: impl IntoIterator<Item = (&'a Body, State)>,
        in_place: impl Fn(usize) -> bool,
    ) -> Result<(), InvalidInput> {
        // An empty list does not make invalid options acceptable.
        self.check_numbers()?;
        self.checks(starts, in_place).collect()
    }

    fn checks<'a>(
        &self,
        starts: impl IntoIterator<Item = (&'a Body, State)>,
        in_place: impl Fn(usize) -> bool,
    ) -> impl Iterator<Item = Result<(), InvalidInput>> {
        let mut last: Option<(&Body, Options)> = None;
        let starts = starts.into_iter().enumerate();
        starts.map(move |(index, (body, start))| {
            let options = match last {
                Some((known, options)) if known == body => options,
                _ => self.completed(body)?,
            };
            last = Some((body, options));
            options.check(&start)?;
            if in_place(index) {
                InPlace::start(&start)?;
            }
            Ok(())
        })
    }

    /// Checks the options and a start, and fills in the body's default topple tilt.
    pub(crate) fn checked(self, body: &Body, start: &State) -> Result<Options, InvalidInput> {
        let options = self.completed(body)?;
        options.check(start)?;
        Ok(options)
    }

    /// As [`Self::checked`], for a start that may also stand flat.
    pub(crate) fn checked_standing_or_tilted(
        self,
        body: &Body,
        start: &State,
    ) -> Result<Options, InvalidInput> {
        if !LEVEL_PHASES || !start.is_standing() {
            return self.checked(body, start);
        }
        start.check_angles()?;
        self.completed(body)
    }

    /// Checks the options and fills in the body's default topple tilt.
    fn completed(mut self, body: &Body) -> Result<Options, InvalidInput> {
        self.check_numbers()?;
        check_gap(self.flat_gap, body)?;
        self.topple_tilt = self.topple_tilt_of(body);
        if let Some(topple) = self.topple_tilt {
            // Beyond this tilt the centre of mass would be below the table.
            let max = (FRAC_PI_2 + body.balance_tilt()).min(PI);
            let within = topple > 0.0 && (topple <= FRAC_PI_2 || topple < max);
            if !within {
                // The text is formatted only on failure, because this check runs for every body.
                let bound =
                    format!("inside (0, {max}), where the centre of mass is over the table");
                bounded("topple_tilt", topple, |_| false, &bound, "rad")?;
            }
        }
        Ok(self)
    }

    /// The tilt (rad) at which a body counts as toppled, if there is one.
    pub(crate) fn topple_tilt_of(&self, body: &Body) -> Option<f64> {
        let has_side = body.height() > 0.0;
        self.topple_tilt.or_else(|| has_side.then_some(FRAC_PI_2))
    }

    /// Checks the options that do not depend on the body.
    pub(crate) fn check_numbers(&self) -> Result<(), InvalidInput> {
        self.flat.check()?;
        positive("duration", self.duration, "s")?;
        positive("gravity", self.gravity, "m/s2")?;
        bounded(
            "rtol",
            self.rtol,
            |rtol| (1e-14..=1e-3).contains(&rtol),
            "between 1e-14 and 1e-3",
            "",
        )?;
        if self.max_steps == 0 {
            return Err(out_of_bounds("max_steps", 0.0, ">= 1", ""));
        }
        Ok(())
    }

    /// Checks a start against completed options.
    pub(crate) fn check(&self, start: &State) -> Result<(), InvalidInput> {
        start.check()?;
        if let Some(topple) = self.topple_tilt
            && start.tilt >= topple
        {
            // The text is formatted only on failure, because this check runs for every start.
            let bound = format!("below topple_tilt = {topple} rad");
            bounded("tilt", start.tilt, |_| false, &bound, "rad")
                .map_err(|error| error.beside("topple_tilt"))?;
        }
        Ok(())
    }
}
