//! What Python hands over, read attribute by attribute, and errors on their way back.

use pyo3::prelude::*;
use rimroll::{Body, IdealLaw, InvalidInput, Solid, State, Surface};
use std::collections::HashMap;

pyo3::import_exception!(rimroll.errors, RimrollError);

/// The core's refusal as the Python package's own exception.
pub fn refusal(error: InvalidInput) -> PyErr {
    RimrollError::new_err(error.to_string())
}

/// Any object with the attributes of `rimroll.Body`.
#[derive(FromPyObject)]
pub struct BodyArgument {
    mass: f64,
    radius: f64,
    height: f64,
    transverse_inertia: f64,
    axial_inertia: f64,
}

impl BodyArgument {
    pub fn body(&self) -> PyResult<Body> {
        Body::new(
            self.mass,
            self.radius,
            self.height,
            self.transverse_inertia,
            self.axial_inertia,
        )
        .map_err(refusal)
    }
}

/// Any object with the attributes of `rimroll.solids.Solid`.
#[derive(FromPyObject)]
pub struct SolidArgument {
    mass: f64,
    height: f64,
    transverse_inertia: f64,
    axial_inertia: f64,
}

impl From<SolidArgument> for Solid {
    fn from(solid: SolidArgument) -> Solid {
        Solid {
            mass: solid.mass,
            height: solid.height,
            transverse_inertia: solid.transverse_inertia,
            axial_inertia: solid.axial_inertia,
        }
    }
}

/// Any object with the attributes of `rimroll.State`, as single numbers.
#[derive(FromPyObject)]
pub struct StateArgument {
    tilt: f64,
    tilt_rate: f64,
    yaw: f64,
    yaw_rate: f64,
    spin: f64,
    spin_rate: f64,
}

impl From<StateArgument> for State {
    fn from(state: StateArgument) -> State {
        State {
            tilt: state.tilt,
            tilt_rate: state.tilt_rate,
            yaw: state.yaw,
            yaw_rate: state.yaw_rate,
            spin: state.spin,
            spin_rate: state.spin_rate,
        }
    }
}

/// The name of an ideal law.
pub fn ideal_law(name: &str) -> PyResult<IdealLaw> {
    IdealLaw::from_name(name).map_err(refusal)
}

/// Any object with the attributes of `rimroll.laws.Law`: what the table is like.
#[derive(FromPyObject)]
pub struct SurfaceArgument {
    name: String,
    numbers: HashMap<String, Given>,
}

/// A number of a law, or a list of them.
#[derive(FromPyObject)]
enum Given {
    Number(f64),
    Table(Vec<f64>),
}

impl SurfaceArgument {
    pub fn surface(&self) -> PyResult<Surface> {
        let (mut numbers, mut tables) = (Vec::new(), Vec::new());
        for (name, given) in &self.numbers {
            match given {
                Given::Number(number) => numbers.push((name.clone(), *number)),
                Given::Table(table) => tables.push((name.clone(), table.clone())),
            }
        }
        Surface::named(&self.name, &numbers, &tables).map_err(refusal)
    }
}
