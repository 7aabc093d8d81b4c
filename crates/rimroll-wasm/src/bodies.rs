//! Bodies: ready-made, and put together by the visitor.

use crate::asked::{Asked, SHAPES, named};
use crate::exchange::{answer, name, unless_refused};
use rimroll::{Body, InvalidInput, presets as ready};

/// The ready-made bodies; the page names them by their places here.
const PRESETS: [&str; 7] = [
    "can_2007",
    "soda_can",
    "beer_bottle",
    "coin",
    "ring",
    "battery",
    "euler_disk",
];

/// The numbers of the preset at a place in [`PRESETS`]; its argument is the filling or the radius
/// of those that have one.
#[unsafe(no_mangle)]
pub extern "C" fn preset(place: f64) -> bool {
    let argument = Asked::new().number();
    tell(
        named("preset", place, &PRESETS).and_then(|preset| match preset {
            "can_2007" => ready::can_2007(),
            "soda_can" => ready::soda_can(argument),
            "beer_bottle" => ready::beer_bottle(argument),
            "coin" => ready::coin(),
            "ring" => ready::ring(argument),
            "battery" => ready::battery(),
            _ => ready::euler_disk(),
        }),
    )
}

/// The names of the ready-made bodies.
#[unsafe(no_mangle)]
pub extern "C" fn presets() {
    name(PRESETS);
}

/// The names of the shapes that bodies are put together from.
#[unsafe(no_mangle)]
pub extern "C" fn shapes() {
    name(SHAPES);
}

/// The numbers of a body on a rim, put together from coaxial solids: the rim's radius, then the solids.
#[unsafe(no_mangle)]
pub extern "C" fn composed() -> bool {
    let mut asked = Asked::new();
    let radius = asked.number();
    let mut solids = Vec::new();
    while asked.more() {
        solids.push(asked.solid());
    }
    let solids: Result<Vec<_>, _> = solids.into_iter().collect();
    tell(solids.and_then(|solids| Body::from_solids(radius, &solids)))
}

fn tell(body: Result<Body, InvalidInput>) -> bool {
    let Some(body) = unless_refused(body) else {
        return false;
    };
    answer([
        body.mass(),
        body.radius(),
        body.height(),
        body.transverse_inertia(),
        body.axial_inertia(),
    ]);
    true
}
