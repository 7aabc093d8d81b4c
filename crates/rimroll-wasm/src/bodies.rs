//! Bodies: ready-made, and put together by the visitor.

use crate::asked::{Asked, named};
use crate::exchange::{answer, unless_refused};
use rimroll::{Body, InvalidInput, presets};

/// The ready-made bodies by their places in the page's list.
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
        named("preset", place, &PRESETS).and_then(|name| match name {
            "can_2007" => presets::can_2007(),
            "soda_can" => presets::soda_can(argument),
            "beer_bottle" => presets::beer_bottle(argument),
            "coin" => presets::coin(),
            "ring" => presets::ring(argument),
            "battery" => presets::battery(),
            _ => presets::euler_disk(),
        }),
    )
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
