//! Falls, of which only the outcome is given.

use crate::asked::Asked;
use crate::exchange::{answer, name, unless_refused};
use rimroll::InvalidInput;
use rimroll::motion::{Fall, Outcome, fall};

/// Follows a body through its first turn from each of many starts. Arguments: body, surface, options,
/// then for each fall its start and a factor of the friction. The answer has for each fall the place
/// of its outcome in [`outcomes`], the angle of turn and the smallest tilt (NaN where there is no turn),
/// and the time, tilt and yaw of its end.
///
/// They are followed one by one: sixteen at a time would be sooner done, and make the page half as
/// long again to load.
#[unsafe(no_mangle)]
pub extern "C" fn falls() -> bool {
    let Some(falls) = unless_refused(followed(Asked::new())) else {
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

fn followed(mut asked: Asked) -> Result<Vec<Fall>, InvalidInput> {
    let (body, contact_law, options) = (asked.body()?, asked.contact_law()?, asked.options());
    let mut falls = Vec::new();
    while asked.more() {
        let start = asked.start();
        let gripped = contact_law.clone().with_grip(asked.number());
        falls.push(fall(&body, &start, &gripped, &options)?);
    }
    Ok(falls)
}
