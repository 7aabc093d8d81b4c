//! What is known without computing a motion.

use crate::asked::Asked;
use crate::exchange::{answer, unless_refused};
use core::cell::RefCell;
use rimroll::turn::{Arrival, needed_friction, painleve_friction, turn_limit, turn_limit_of};
use rimroll::{Body, FrictionLaw, IdealLaw, InvalidInput};

/// Arguments: body, start, surface, gravity. The answer: the limiting angles of turn without slip,
/// without friction, and on this surface for a body that comes down as from this start (NaN where it
/// does not come down); the friction needed to roll through; the friction from which on rigid-body
/// mechanics has no one answer; the balance tilt. Angles in rad.
#[unsafe(no_mangle)]
pub extern "C" fn theory() -> bool {
    unless_refused(known(Asked::new())).map(answer).is_some()
}

thread_local! {
    /// The last limit of a body that arrived at rest on its rim, and what it is the limit of.
    static AT_REST: RefCell<Option<(Body, FrictionLaw, f64)>> = const { RefCell::new(None) };
}

/// The limiting turn. That of a body which arrives at rest on its rim does not depend on how fast it
/// comes down, so while a visitor changes only that it is not computed again: with a friction of
/// almost what rolling through needs it takes longer than a motion.
fn limit_here(body: &Body, friction: &FrictionLaw, arrival: &Arrival) -> Result<f64, InvalidInput> {
    if arrival.slip != 0.0 || arrival.spin != 0.0 {
        return turn_limit_of(body, friction, arrival);
    }
    let before = AT_REST.with_borrow(|before| {
        let (of, under, limit) = before.as_ref()?;
        (of == body && under == friction).then_some(*limit)
    });
    if let Some(limit) = before {
        return Ok(limit);
    }
    let limit = turn_limit_of(body, friction, &Arrival::at_rest())?;
    AT_REST.set(Some((*body, friction.clone(), limit)));
    Ok(limit)
}

fn known(mut asked: Asked) -> Result<[f64; 6], InvalidInput> {
    let (body, start, contact_law) = (asked.body()?, asked.start(), asked.contact_law()?);
    let gravity = asked.number();
    let here = Arrival::of(&body, &start, &contact_law, gravity)
        .and_then(|arrival| limit_here(&body, &contact_law.friction, &arrival));
    Ok([
        turn_limit(&body, IdealLaw::NoSlip),
        turn_limit(&body, IdealLaw::Frictionless),
        here.unwrap_or(f64::NAN),
        needed_friction(&body),
        painleve_friction(&body),
        body.balance_tilt(),
    ])
}
