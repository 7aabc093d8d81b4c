//! Bodies: presets, and those that the visitor composes.

use crate::exchange::{Arguments, SHAPES, answer, name, named, unless_refused};
use rimroll::{Body, InvalidInput, presets as ready};

/// The numbers of the preset at an index of [`NAMES`](ready::NAMES). Its argument is the filled fraction or the
/// radius of presets that have one.
#[unsafe(no_mangle)]
pub extern "C" fn preset(place: f64) -> bool {
    let sizes = Arguments::new().rest();
    tell(named("preset", place, ready::NAMES).and_then(|preset| ready::named(preset, &sizes)))
}

/// The names of the presets.
#[unsafe(no_mangle)]
pub extern "C" fn presets() {
    name(ready::NAMES.iter().copied());
}

/// The names of the shapes of which bodies are composed.
#[unsafe(no_mangle)]
pub extern "C" fn shapes() {
    name(SHAPES);
}

/// The numbers of a body on a rim, composed of coaxial solids. Arguments: the rim's radius, then the solids.
#[unsafe(no_mangle)]
pub extern "C" fn composed() -> bool {
    let mut arguments = Arguments::new();
    let radius = arguments.number();
    let mut solids = Vec::new();
    while arguments.any_left() {
        solids.push(arguments.solid());
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
