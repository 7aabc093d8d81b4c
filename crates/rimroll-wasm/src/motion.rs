//! Whole motions, kept here while the page looks at them.

use crate::asked::Asked;
use crate::exchange::{answer, name, say, unless_refused};
use core::ops::ControlFlow;
use rimroll::motion::{COLUMNS, Instant, Moment};
use rimroll::{FrictionLaw, InvalidInput, Motion};

/// Computes the motion of a body from a start on a surface, and keeps it until [`forget`] is called;
/// null when it is refused. Arguments: body, start, surface, options.
#[unsafe(no_mangle)]
pub extern "C" fn simulate() -> *mut Motion {
    unless_refused(computed(Asked::new())).map_or(core::ptr::null_mut(), |motion| {
        Box::into_raw(Box::new(motion))
    })
}

fn computed(mut asked: Asked) -> Result<Motion, InvalidInput> {
    let (body, start) = (asked.body()?, asked.start());
    let (contact_law, options) = (asked.contact_law()?, asked.options());
    rimroll::simulate(&body, &start, contact_law, &options, |_| {
        ControlFlow::Continue(())
    })
}

/// The names of the laws of friction.
#[unsafe(no_mangle)]
pub extern "C" fn laws() {
    name(FrictionLaw::NAMES);
}

/// Gives back the memory of a motion.
///
/// # Safety
/// The address is one that [`simulate`] returned, and is not used again.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn forget(motion: *mut Motion) {
    // SAFETY: as this function asks for.
    drop(unsafe { Box::from_raw(motion) });
}

/// The names of the columns in which moments are told.
#[unsafe(no_mangle)]
pub extern "C" fn columns() {
    name(COLUMNS);
}

/// The motion at so many moments inside each step and at its end, close together just where it is fast:
/// the columns one after the other.
#[unsafe(no_mangle)]
pub extern "C" fn samples(motion: &Motion, per_step: usize) {
    tell(motion, &motion.track.samples(per_step));
}

/// The motion at the times (s) among the arguments, in the same way.
#[unsafe(no_mangle)]
pub extern "C" fn at(motion: &Motion) {
    let mut look_up = motion.track.look_up();
    let times = Asked::new().rest();
    let instants: Vec<Instant> = times.iter().map(|&t| look_up.at(t)).collect();
    tell(motion, &instants);
}

/// The moments of the events in the same way, and their kinds as words.
#[unsafe(no_mangle)]
pub extern "C" fn events(motion: &Motion) {
    let moments: Vec<Instant> = motion.events.iter().map(|event| event.at).collect();
    tell(motion, &moments);
    name(motion.events.iter().map(|event| event.kind.name()));
}

/// The times (s) at which phases begin, and their kinds as words.
#[unsafe(no_mangle)]
pub extern "C" fn phases(motion: &Motion) {
    answer(motion.track.phases().map(|at| at.t));
    name(motion.track.phases().map(|at| at.phase.name()));
}

/// For each turn its angle, smallest tilt, the time and the yaw rate then, its start, its end and the
/// tilt maximum after it.
#[unsafe(no_mangle)]
pub extern "C" fn turns(motion: &Motion) {
    answer(motion.turns.iter().flat_map(|turn| {
        [
            turn.angle,
            turn.min_tilt,
            turn.t,
            turn.yaw_rate,
            turn.start,
            turn.end,
            turn.max_tilt,
        ]
    }));
}

/// How the motion ended, in a word.
#[unsafe(no_mangle)]
pub extern "C" fn status(motion: &Motion) {
    say(motion.status.name());
}

/// How the motion ended, in a sentence.
#[unsafe(no_mangle)]
pub extern "C" fn message(motion: &Motion) {
    say(&motion.message);
}

fn tell(motion: &Motion, instants: &[Instant]) {
    let rows: Vec<Moment> = instants.iter().map(|at| motion.moment(at)).collect();
    answer((0..COLUMNS.len()).flat_map(|column| rows.iter().map(move |row| row[column])));
}
