//! The falls of a piece of work, sixteen at a time where they are of the common kind.

use super::Release;
use super::carried::{Carried, Gliding, Rolling};
use super::dry::Dry;
use super::piece::{BodyNumbers, Piece};
use super::pool::{Exit, Pool};
use super::trial::Trial;
use crate::motion::{Fall, Options, Status, fall};
use crate::real::LANES;
use crate::state::Coordinates;
use crate::surface::{FrictionLaw, Surface};

/// Whether falls on a surface go in lanes, but for what is rare.
pub(super) fn go_in_lanes(surface: &Surface) -> bool {
    use FrictionLaw::{Coulomb, Frictionless, NoSlip};
    matches!(surface.friction, NoSlip | Frictionless | Coulomb { .. }) && !surface.resists()
}

/// The falls from some of the trials, in their order: all, or those before the first that was to be followed
/// by itself when the work did not go on. The options and trials have been checked.
pub(super) fn together(
    trials: &[Release<'_>],
    options: &Options,
    goes_on: impl Fn() -> bool,
) -> Vec<Fall> {
    let mut falls = Falls {
        piece: Piece::new(trials, options),
        done: vec![None; trials.len()],
    };
    falls.conservative::<Rolling<f64, false>>(FrictionLaw::NoSlip);
    falls.conservative::<Gliding<f64>>(FrictionLaw::Frictionless);
    let dry = |(_, _, surface): &Release<'_>| {
        matches!(surface.friction, FrictionLaw::Coulomb { .. }) && go_in_lanes(surface)
    };
    if trials.iter().any(dry) {
        let waiting = (0..trials.len()).filter(|&index| dry(&trials[index]));
        Dry::new(&falls.piece, &mut falls.done).follow(waiting);
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
    piece: Piece<'a>,
    done: Vec<Option<Fall>>,
}

impl Falls<'_> {
    /// Follows a fall by itself.
    fn alone(&self, index: usize) -> Fall {
        let (body, start, surface) = &self.piece.trials[index];
        match fall(body, start, surface, self.piece.options) {
            Ok(fall) => fall,
            Err(_) => unreachable!("the trials have been checked"),
        }
    }

    /// Follows all falls under one of the paper's two laws.
    fn conservative<A: Carried<f64, 7>>(&mut self, law: FrictionLaw) {
        let Falls { piece, done } = self;
        let limits = &piece.limits;
        let waiting = (0..piece.trials.len()).filter(|&index| {
            let (.., surface) = &piece.trials[index];
            surface.friction == law && go_in_lanes(surface)
        });
        let mut waiting = waiting.peekable();
        let Some(&first) = waiting.peek() else { return };
        let mut pool: Pool<'_, A, 7> = Pool::new(piece.body(first), limits);
        let new_contact = |body: &BodyNumbers| (body.place, A::new(body.parameters, 0.0));
        let mut contact = new_contact(piece.body(first));
        loop {
            while pool.len() < LANES {
                let Some(index) = waiting.next() else { break };
                let (_, start, _) = &piece.trials[index];
                let (u, body) = (Coordinates::from_state(start), piece.body(index));
                if contact.0 != body.place {
                    contact = new_contact(body);
                }
                if limits.are_far_from(&u, &body.topple) && contact.1.holds(&A::of(&u)) > 0.0 {
                    let trial = Trial::new(index, &u, law != FrictionLaw::NoSlip);
                    pool.put(trial, &u, (body, 0.0), body.yardstick.first_step(&u));
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
                done[trial.index] =
                    Some(trial.fall(&piece.body(trial.index).parameters, status, at));
            });
        }
    }
}
