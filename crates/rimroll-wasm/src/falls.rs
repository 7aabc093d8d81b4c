//! Falls, of which only the outcome is returned.

use crate::arguments::Arguments;
use crate::exchange::{answer, name, unless_refused};
use rimroll::InvalidInput;
use rimroll::motion::{Fall, Outcome, fall};

/// Simulates a body through its first turn from each of many starts. Arguments: body, contact law, options,
/// then for each fall its start and a factor of the friction. The result has for each fall the index of its
/// outcome in [`outcomes`], the angle of turn and the smallest tilt (NaN if there is no turn), and the time,
/// tilt and yaw of its end.
///
/// The falls are computed one by one. Batches of sixteen would be faster, but would make the page half again
/// as large to load.
#[unsafe(no_mangle)]
pub extern "C" fn falls() -> bool {
    let Some(falls) = unless_refused(followed(Arguments::new())) else {
        return false;
    };
    answer(falls.iter().flat_map(|fall| {
        let turn = fall.turn.as_ref();
        [
            f64::from(fall.outcome as u8),
            turn.map_or(f64::NAN, |turn| turn.angle),
            turn.map_or(f64::NAN, |turn| turn.min_tilt),
            fall.end.t,
            fall.end.tilt,
            fall.end.yaw,
        ]
    }));
    true
}

/// The names of the outcomes.
#[unsafe(no_mangle)]
pub extern "C" fn outcomes() {
    name(Outcome::ALL.map(Outcome::name));
}

fn followed(mut arguments: Arguments) -> Result<Vec<Fall>, InvalidInput> {
    let (body, contact_law, options) = (
        arguments.body()?,
        arguments.contact_law()?,
        arguments.options(),
    );
    let mut falls = Vec::new();
    while arguments.any_left() {
        let start = arguments.start();
        let contact_law = contact_law.clone().with_friction_scaled(arguments.number());
        falls.push(fall(&body, &start, &contact_law, &options)?);
    }
    Ok(falls)
}
