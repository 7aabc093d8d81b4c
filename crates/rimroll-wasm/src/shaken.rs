//! Motions on a table that moves: what the page loads only when a visitor shakes the floor.

use crate::exchange::{Arguments, answer, name, named, unless_refused};
use crate::motion::kept;
use core::ops::ControlFlow;
use rimroll::ground::{Ground, Pulse, Shape};
use rimroll::motion::{FlatLanding, Side, simulate_on};
use rimroll::{InvalidInput, Motion, Options};
use std::sync::Arc;

/// The functions of time of pulses; the page refers to them by index.
const SHAPES: [&str; 4] = ["constant", "sine", "cosine", "ricker"];

/// What follows where the base comes down flat, as in Python; the page refers to it by index.
const FLAT_LANDINGS: [&str; 4] = ["stop", "smooth_left", "smooth_right", "housner"];

/// As [`crate::motion::simulate`], on a table that moves. Arguments: body, start, contact law, options, the index of the
/// flat landing in [`FLAT_LANDINGS`], ground.
#[unsafe(no_mangle)]
pub extern "C" fn simulate_shaken() -> *mut Motion {
    kept(computed(Arguments::new()))
}

fn computed(mut arguments: Arguments) -> Result<Motion, InvalidInput> {
    let (body, start) = (arguments.body()?, arguments.start());
    let (contact_law, options) = (arguments.contact_law()?, arguments.options());
    let flat = arguments.flat_landing()?;
    let ground = Some(Arc::new(arguments.ground()?));
    let options = Options { flat, ..options };
    simulate_on(ground, &body, &start, contact_law, &options, |_| {
        ControlFlow::Continue(())
    })
}

/// The names of the functions of time of pulses.
#[unsafe(no_mangle)]
pub extern "C" fn pulse_shapes() {
    name(SHAPES);
}

/// The names of the flat landings.
#[unsafe(no_mangle)]
pub extern "C" fn flat_landings() {
    name(FLAT_LANDINGS);
}

/// How the table moves at times. Arguments: ground, then the times (s). The result has for each time the acceleration
/// (m/s²) and the displacement (m) along x, y and z.
#[unsafe(no_mangle)]
pub extern "C" fn table_motion() -> bool {
    let mut arguments = Arguments::new();
    let Some(ground) = unless_refused(arguments.ground()) else {
        return false;
    };
    let kinematics = ground.kinematics();
    let times = arguments.rest();
    answer(
        times
            .iter()
            .flat_map(|&t| [ground.acceleration(t), kinematics.displacement(t)].concat()),
    );
    true
}

impl Arguments {
    fn flat_landing(&mut self) -> Result<FlatLanding, InvalidInput> {
        let flat = named("flat landing", self.number(), &FLAT_LANDINGS)?;
        Ok(match flat {
            "smooth_left" => FlatLanding::Smooth(Side::Left),
            "smooth_right" => FlatLanding::Smooth(Side::Right),
            "housner" => FlatLanding::Housner,
            _ => FlatLanding::Stop,
        })
    }

    /// A pulse (the number 1, then its numbers) or a record (the number 0, the step, the number of samples and the
    /// samples along x, y and z).
    fn ground(&mut self) -> Result<Ground, InvalidInput> {
        if self.number() == 1.0 {
            return Ground::pulses(vec![self.pulse()?]);
        }
        let (step, count) = (self.number(), self.number() as usize);
        Ground::sampled(step, (0..count).map(|_| self.array()).collect())
    }

    /// The index of the shape in [`SHAPES`], the amplitudes along x, y and z, period, duration and centre.
    fn pulse(&mut self) -> Result<Pulse, InvalidInput> {
        let shape = named("shape of a pulse", self.number(), &SHAPES)?;
        let amplitude = self.array();
        let [period, duration, center] = self.array();
        let shape = match shape {
            "constant" => Shape::Constant,
            "sine" => Shape::Sine { period },
            "cosine" => Shape::Cosine { period },
            _ => Shape::Ricker { period, center },
        };
        Ok(Pulse {
            amplitude,
            shape,
            duration,
        })
    }
}
