//! Closed forms and limits, which need no simulation.

use crate::exchange::{Arguments, answer, unless_refused};
use core::cell::RefCell;
use rimroll::turn::{Arrival, needed_friction, painleve_friction, turn_limit, turn_limit_of};
use rimroll::{Body, FrictionLaw, IdealLaw, InvalidInput};

/// Arguments: body, start, contact law, gravity. The result: the limiting angles of turn without slip,
/// without friction, and under this contact law for a body that arrives as from this start (NaN if it does
/// not come down); the friction needed to roll through the near-collision; the friction from which the
/// Painlevé paradox is possible; the balance tilt. Angles in rad.
#[unsafe(no_mangle)]
pub extern "C" fn theory() -> bool {
    unless_refused(known(Arguments::new()))
        .map(answer)
        .is_some()
}

thread_local! {
    /// The last limit computed for an arrival without slip and spin, with its body and friction.
    static AT_REST: RefCell<Option<(Body, FrictionLaw, f64)>> = const { RefCell::new(None) };
}

/// The limiting turn. Without slip and spin on arrival it does not depend on the tipping rate, so it is
/// cached while the visitor changes only that. If friction is close to the critical value μ*, it takes longer
/// to compute than a motion.
fn limit_here(body: &Body, friction: &FrictionLaw, arrival: &Arrival) -> Result<f64, InvalidInput> {
    if arrival.slip != 0.0 || arrival.spin != 0.0 {
        return turn_limit_of(body, friction, arrival);
    }
    let before = AT_REST.with_borrow(|before| {
        let (last_body, last_friction, limit) = before.as_ref()?;
        (last_body == body && last_friction == friction).then_some(*limit)
    });
    if let Some(limit) = before {
        return Ok(limit);
    }
    let limit = turn_limit_of(body, friction, &Arrival::at_rest())?;
    AT_REST.set(Some((*body, friction.clone(), limit)));
    Ok(limit)
}

fn known(mut arguments: Arguments) -> Result<[f64; 6], InvalidInput> {
    let (body, start, contact_law) = (
        arguments.body()?,
        arguments.start(),
        arguments.contact_law()?,
    );
    let gravity = arguments.number();
    let here = Arrival::from_start(&body, &start, &contact_law, gravity)
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
