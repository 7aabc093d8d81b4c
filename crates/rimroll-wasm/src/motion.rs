//! Whole motions, kept in memory while the page uses them, and falls, of which only the outcome is returned.

use crate::exchange::{Arguments, answer, name, say, unless_refused};
use core::ops::ControlFlow;
use rimroll::motion::{
    COLUMNS, Fall, Instant, Observables, Outcome, SPEED_OF_SOUND, UNEVENNESS, fall,
};
use rimroll::{FrictionLaw, InvalidInput, Motion};

/// Simulates the motion of a body from a start under a contact law and keeps it until [`forget`] is called;
/// null if the core refuses it. Arguments: body, start, contact law, options.
#[unsafe(no_mangle)]
pub extern "C" fn simulate() -> *mut Motion {
    kept(computed(Arguments::new()))
}

/// The address of a motion that is kept until [`forget`] is called; null if the core refused it.
pub fn kept(motion: Result<Motion, InvalidInput>) -> *mut Motion {
    unless_refused(motion).map_or(core::ptr::null_mut(), |motion| {
        Box::into_raw(Box::new(motion))
    })
}

fn computed(mut arguments: Arguments) -> Result<Motion, InvalidInput> {
    let (body, start) = (arguments.body()?, arguments.start());
    let (contact_law, options) = (arguments.contact_law()?, arguments.options());
    rimroll::simulate(&body, &start, contact_law, &options, |_| {
        ControlFlow::Continue(())
    })
}

/// The names of the friction laws.
#[unsafe(no_mangle)]
pub extern "C" fn laws() {
    name(FrictionLaw::NAMES.iter().copied());
}

/// Frees the memory of a motion.
///
/// # Safety
/// The address must be one that [`simulate`] returned, and must not be used again.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn forget(motion: *mut Motion) {
    // SAFETY: guaranteed by the caller, as stated above.
    drop(unsafe { Box::from_raw(motion) });
}

/// The names of the quantities at a moment.
#[unsafe(no_mangle)]
pub extern "C" fn columns() {
    name(COLUMNS);
}

/// The motion at `per_step` moments of each step, including its end, which are dense where it is fast: all
/// numbers of one quantity, then those of the next.
#[unsafe(no_mangle)]
pub extern "C" fn samples(motion: &Motion, per_step: usize) {
    provide_moments(motion, &motion.trajectory.samples(per_step));
}

/// The motion at the times (s) given as arguments, in the same layout.
#[unsafe(no_mangle)]
pub extern "C" fn at(motion: &Motion) {
    let mut look_up = motion.trajectory.look_up();
    let times = Arguments::new().rest();
    let instants: Vec<Instant> = times.iter().map(|&t| look_up.at(t)).collect();
    provide_moments(motion, &instants);
}

/// The moments of the events in the same layout, and their kinds as text.
#[unsafe(no_mangle)]
pub extern "C" fn events(motion: &Motion) {
    let moments: Vec<Instant> = motion.events.iter().map(|event| event.at).collect();
    provide_moments(motion, &moments);
    name(motion.events.iter().map(|event| event.kind.name()));
}

/// The times (s) at which phases begin, and their kinds as text.
#[unsafe(no_mangle)]
pub extern "C" fn phases(motion: &Motion) {
    answer(motion.trajectory.phases().map(|at| at.t));
    name(motion.trajectory.phases().map(|at| at.phase.name()));
}

/// For each turn: the angle, the smallest tilt, its time and the yaw rate then, the start and end of the
/// turn, and the tilt maximum at its end.
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

/// How far the model holds from `start` to `end` with the smallest tilt at `lowest` (s): the numbers of a
/// [`rimroll::motion::Validity`] in the order of its fields, 1 or 0 for each that is exceeded, and the limits in its
/// table: the unevenness from fine to coarse (m) and the speed of sound (m/s).
#[unsafe(no_mangle)]
pub extern "C" fn validity(motion: &Motion, start: f64, lowest: f64, end: f64) {
    let validity = motion.validity_between(start, lowest, end);
    let numbers = [
        validity.gap,
        validity.contact_speed,
        validity.passage_time,
        validity.sound_time,
        validity.force_ratio,
        validity.loss_ratio,
    ];
    let exceeded = validity.exceeded().map(|is| f64::from(u8::from(is)));
    let [fine, coarse] = UNEVENNESS;
    answer(
        numbers
            .into_iter()
            .chain(exceeded)
            .chain([fine, coarse, SPEED_OF_SOUND]),
    );
}

/// The status: one word on how the motion ended.
#[unsafe(no_mangle)]
pub extern "C" fn status(motion: &Motion) {
    say(motion.status.name());
}

/// A sentence on how the motion ended.
#[unsafe(no_mangle)]
pub extern "C" fn message(motion: &Motion) {
    say(&motion.message());
}

fn provide_moments(motion: &Motion, instants: &[Instant]) {
    let rows: Vec<Observables> = instants.iter().map(|at| motion.observables(at)).collect();
    answer((0..COLUMNS.len()).flat_map(|column| rows.iter().map(move |row| row[column])));
}

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
