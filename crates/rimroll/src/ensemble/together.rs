//! Falls of one body, sixteen at a time where they are of the common kind.

use super::carried::{Carried, Gliding, Rolling};
use super::dry::Dry;
use super::lockstep::Limits;
use super::pool::{Exit, Pool};
use super::trial::Trial;
use crate::body::Body;
use crate::law::Parameters;
use crate::motion::{Fall, Options, Status, fall};
use crate::real::LANES;
use crate::state::{Coordinates, State};
use crate::surface::{FrictionLaw, Surface};
use crate::yardstick::Yardstick;

/// Whether falls on a surface go in lanes, but for what is rare.
pub(super) fn go_in_lanes(surface: &Surface) -> bool {
    use FrictionLaw::{Coulomb, Frictionless, NoSlip};
    matches!(surface.friction, NoSlip | Frictionless | Coulomb { .. }) && !surface.resists()
}

/// The falls from some of the trials, in their order: all, or those before the first that was to be followed
/// by itself when the work did not go on. The options and trials have been checked.
pub(super) fn together(
    body: &Body,
    trials: &[(State, Surface)],
    options: &Options,
    goes_on: impl Fn() -> bool,
) -> Vec<Fall> {
    let mut falls = Falls {
        body,
        trials,
        options,
        parameters: Parameters::new(body, options.gravity),
        limits: Limits::of(options),
        done: vec![None; trials.len()],
    };
    falls.conservative::<Rolling<f64, false>>(FrictionLaw::NoSlip);
    falls.conservative::<Gliding<f64>>(FrictionLaw::Frictionless);
    let dry = |(_, surface): &(State, Surface)| {
        matches!(surface.friction, FrictionLaw::Coulomb { .. }) && go_in_lanes(surface)
    };
    if trials.iter().any(dry) {
        let waiting = (0..trials.len()).filter(|&index| dry(&trials[index]));
        Dry::new(body, trials, options, &falls.limits, &mut falls.done).follow(waiting);
    }
    (0..trials.len())
        .map_while(|index| {
            falls.done[index]
                .take()
                .or_else(|| goes_on().then(|| falls.alone(index)))
        })
        .collect()
}

struct Falls<'a> {
    body: &'a Body,
    trials: &'a [(State, Surface)],
    options: &'a Options,
    parameters: Parameters<f64>,
    limits: Limits,
    done: Vec<Option<Fall>>,
}

impl Falls<'_> {
    /// Follows a fall by itself.
    fn alone(&self, index: usize) -> Fall {
        let (start, surface) = &self.trials[index];
        match fall(self.body, start, surface, self.options) {
            Ok(fall) => fall,
            Err(_) => unreachable!("the trials have been checked"),
        }
    }

    /// Follows all falls under one of the paper's two laws.
    fn conservative<A: Carried<f64, 7>>(&mut self, law: FrictionLaw) {
        let Falls {
            limits,
            parameters,
            trials,
            done,
            ..
        } = self;
        let mut pool: Pool<'_, A, 7> = Pool::new(*parameters, limits);
        let mut waiting = (0..trials.len()).filter(|&index| {
            let (_, surface) = &trials[index];
            surface.friction == law && go_in_lanes(surface)
        });
        let contact = A::new(*parameters, 0.0);
        let yardstick = Yardstick::new(parameters);
        loop {
            while pool.len() < LANES {
                let Some(index) = waiting.next() else { break };
                let (start, _) = &trials[index];
                let u = Coordinates::from_state(start);
                if limits.are_far_from(&u) && contact.holds(&A::of(&u)) > 0.0 {
                    let trial =
                        Trial::new(index, &u, limits, parameters, law != FrictionLaw::NoSlip);
                    pool.put(trial, &u, 0.0, yardstick.first_step(&u));
                }
            }
            if pool.len() == 0 {
                return;
            }
            pool.step(|trial, exit, at| {
                let status = match exit {
                    Exit::Over(status) => status,
                    Exit::GivesWay => Status::LiftedOff,
                    Exit::Stops | Exit::Rare => return,
                };
                done[trial.index] = Some(trial.fall(parameters, status, at));
            });
        }
    }
}
