//! The falls of a chunk of work, in lanes where the contact law allows it.

use super::active_fall::ActiveFall;
use super::chunk::{BodyNumbers, Chunk, Setup};
use super::dry_friction::Dry;
use super::pool::{Exit, Pool};
use super::reduced_system::{ReducedFrictionless, ReducedNoSlip, ReducedSystem};
use crate::contact_law::ContactLaw;
use crate::law::Coulomb;
use crate::law::FrictionLaw;
use crate::motion::{Fall, Options, Status, fall};
use crate::real::LANES;
use crate::state::Coordinates;

/// Whether falls under a contact law can be computed in lanes.
pub(super) fn fits_lanes(contact_law: &ContactLaw) -> bool {
    use FrictionLaw::{Coulomb, Frictionless, NoSlip};
    matches!(contact_law.friction, NoSlip | Frictionless | Coulomb { .. }) && !contact_law.resists()
}

/// The falls of a chunk of setups in order. When `should_continue` returns false before a scalar fall, the result
/// ends before that fall. The options and the setups must have been checked.
pub(super) fn batch(
    setups: &[Setup<'_>],
    options: &Options,
    should_continue: &dyn Fn() -> bool,
) -> Vec<Fall> {
    let mut falls = Falls {
        chunk: Chunk::new(setups, options),
        done: vec![None; setups.len()],
    };
    falls.conservative::<ReducedNoSlip<f64, false>>(FrictionLaw::NoSlip);
    falls.conservative::<ReducedFrictionless<f64>>(FrictionLaw::Frictionless);
    let dry = |(_, _, contact_law): &Setup<'_>| {
        matches!(contact_law.friction, FrictionLaw::Coulomb(Coulomb { .. }))
            && fits_lanes(contact_law)
    };
    if setups.iter().any(dry) {
        let waiting = (0..setups.len()).filter(|&index| dry(&setups[index]));
        Dry::new(&falls.chunk, &mut falls.done).follow(waiting);
    }
    (0..setups.len())
        .map_while(|index| {
            falls.done[index]
                .take()
                .or_else(|| should_continue().then(|| falls.scalar_fall(index)))
        })
        .collect()
}

struct Falls<'a> {
    chunk: Chunk<'a>,
    done: Vec<Option<Fall>>,
}

impl Falls<'_> {
    fn scalar_fall(&self, index: usize) -> Fall {
        let (body, start, contact_law) = &self.chunk.setups[index];
        match fall(body, start, contact_law, self.chunk.options) {
            Ok(fall) => fall,
            Err(_) => unreachable!("the setups have been checked"),
        }
    }

    /// Computes all falls under one of the paper's two laws.
    fn conservative<A: ReducedSystem<f64, 7>>(&mut self, law: FrictionLaw) {
        let Falls { chunk, done } = self;
        let bounds = &chunk.bounds;
        let waiting = (0..chunk.setups.len()).filter(|&index| {
            let (.., contact_law) = &chunk.setups[index];
            contact_law.friction == law && fits_lanes(contact_law)
        });
        let mut waiting = waiting.peekable();
        let Some(&first) = waiting.peek() else { return };
        let mut pool: Pool<'_, A, 7> = Pool::new(chunk.body(first), bounds);
        let new_contact = |body: &BodyNumbers| (body.place, A::new(body.parameters, 0.0));
        let mut contact = new_contact(chunk.body(first));
        loop {
            while pool.len() < LANES {
                let Some(index) = waiting.next() else { break };
                let (_, start, _) = &chunk.setups[index];
                let (u, body) = (Coordinates::from_state(start), chunk.body(index));
                if contact.0 != body.place {
                    contact = new_contact(body);
                }
                if bounds.are_far_from(&u, &body.topple)
                    && contact.1.contact_margin(&A::project(&u)) > 0.0
                {
                    let fall = ActiveFall::new(index, &u, law != FrictionLaw::NoSlip);
                    pool.put(fall, &u, (body, 0.0), body.error_scale.first_step(&u));
                }
            }
            if pool.len() == 0 {
                return;
            }
            pool.step(|fall, exit, at| {
                let status = match exit {
                    Exit::Over(status) => status,
                    Exit::ContactEnds => Status::LiftedOff,
                    Exit::SlipEnds | Exit::NeedsScalar => return,
                };
                done[fall.index] =
                    Some(fall.result(&chunk.body(fall.index).parameters, status, at));
            });
        }
    }
}
