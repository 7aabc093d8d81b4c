//! What is known without computing a motion.

use crate::asked::Asked;
use crate::exchange::{answer, unless_refused};
use rimroll::turn::{Arrival, needed_friction, painleve_friction, turn_limit, turn_limit_of};
use rimroll::{IdealLaw, InvalidInput};

/// Arguments: body, start, surface, gravity. The answer: the limiting angles of turn without slip,
/// without friction, and on this surface for a body that comes down as from this start (NaN where it
/// does not come down); the friction needed to roll through; the friction from which on rigid-body
/// mechanics has no one answer; the balance tilt. Angles in rad.
#[unsafe(no_mangle)]
pub extern "C" fn theory() -> bool {
    unless_refused(known(Asked::new())).map(answer).is_some()
}

fn known(mut asked: Asked) -> Result<[f64; 6], InvalidInput> {
    let (body, start, surface) = (asked.body()?, asked.start(), asked.surface()?);
    let gravity = asked.number();
    let here = Arrival::of(&body, &start, &surface, gravity)
        .and_then(|arrival| turn_limit_of(&body, &surface.friction, &arrival));
    Ok([
        turn_limit(&body, IdealLaw::NoSlip),
        turn_limit(&body, IdealLaw::Frictionless),
        here.unwrap_or(f64::NAN),
        needed_friction(&body),
        painleve_friction(&body),
        body.balance_tilt(),
    ])
}
