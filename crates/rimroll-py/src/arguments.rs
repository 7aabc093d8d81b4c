//! Conversion of Python arguments, read attribute by attribute, and of errors.

use numpy::PyReadonlyArray1;
use pyo3::prelude::*;
use rimroll::motion::AngleUnit;
use rimroll::{Body, ContactLaw, IdealLaw, InvalidInput, Solid, State};
use std::collections::HashMap;

pyo3::import_exception!(rimroll.errors, RimrollError);
pyo3::import_exception!(rimroll.errors, NoNearCollision);

/// The core's error as the Python package's own exception, with its data as the attributes.
pub fn refusal(error: InvalidInput) -> PyErr {
    let text = error.predicate();
    match error {
        InvalidInput::NoNearCollision { ref ending, .. } => {
            let status = ending.map(|ending| ending.status().name());
            NoNearCollision::new_err((text, error.sentence(AngleUnit::Degrees), status))
        }
        InvalidInput::OutOfBounds {
            field,
            index,
            value,
            bound,
            unit,
            other,
        } => {
            let index: Vec<usize> = index.into_iter().collect();
            RimrollError::new_err((text, field, value, bound, unit, index, other))
        }
        InvalidInput::WrongLength {
            field,
            bound,
            count,
        } => RimrollError::new_err((text, field, count, bound)),
        _ => RimrollError::new_err(text),
    }
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

/// Any object with the attributes of `rimroll.Body` as arrays, each of length one for all rows or with one
/// number per row.
#[derive(FromPyObject)]
pub struct BodiesArgument<'py> {
    mass: PyReadonlyArray1<'py, f64>,
    radius: PyReadonlyArray1<'py, f64>,
    height: PyReadonlyArray1<'py, f64>,
    transverse_inertia: PyReadonlyArray1<'py, f64>,
    axial_inertia: PyReadonlyArray1<'py, f64>,
}

impl BodiesArgument<'_> {
    /// The bodies in order, or the errors of invalid ones.
    pub fn each(&self) -> PyResult<impl Iterator<Item = Result<Body, InvalidInput>>> {
        let columns = [
            self.mass.as_slice()?,
            self.radius.as_slice()?,
            self.height.as_slice()?,
            self.transverse_inertia.as_slice()?,
            self.axial_inertia.as_slice()?,
        ];
        let count = columns.iter().map(|column| column.len()).max();
        Ok((0..count.unwrap_or(0)).map(move |row| {
            let [mass, radius, height, transverse, axial] =
                columns.map(|column| *of_row(column, row));
            Body::new(mass, radius, height, transverse, axial)
        }))
    }

    /// One body for all rows, or one for each row.
    pub fn bodies(&self) -> PyResult<Vec<Body>> {
        let bodies: Result<_, _> = self.each()?.collect();
        bodies.map_err(refusal)
    }
}

/// The element of a row, where there is one element for each row or one for all.
pub fn of_row<T>(all: &[T], row: usize) -> &T {
    &all[if all.len() == 1 { 0 } else { row }]
}

/// Any object with the attributes of `rimroll.bodies.solids.Solid`.
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

/// Any object with the attributes of `rimroll.laws.Law`: the contact law.
#[derive(FromPyObject)]
pub struct ContactLawArgument {
    name: String,
    numbers: HashMap<String, Given>,
}

/// A parameter of a law: a number or a list of numbers.
#[derive(FromPyObject)]
enum Given {
    Number(f64),
    Table(Vec<f64>),
}

impl ContactLawArgument {
    pub fn contact_law(&self) -> PyResult<ContactLaw> {
        let (numbers, tables) = self.given();
        ContactLaw::named(&self.name, &numbers, &tables).map_err(refusal)
    }

    /// The numbers and the lists of numbers by name.
    #[allow(clippy::type_complexity)]
    fn given(&self) -> (Vec<(String, f64)>, Vec<(String, Vec<f64>)>) {
        let (mut numbers, mut tables) = (Vec::new(), Vec::new());
        for (name, given) in &self.numbers {
            match given {
                Given::Number(number) => numbers.push((name.clone(), *number)),
                Given::Table(table) => tables.push((name.clone(), table.clone())),
            }
        }
        (numbers, tables)
    }

    /// One contact law for all rows, or one for each row if some parameters differ between rows.
    pub fn of_rows(&self, varied: &VariedArgument<'_>) -> PyResult<Vec<ContactLaw>> {
        if varied.is_empty() {
            return Ok(vec![self.contact_law()?]);
        }
        let contact_laws: Result<_, _> = self.varied(varied)?.collect();
        contact_laws.map_err(refusal)
    }

    /// Contact laws that differ from this one in some parameters, given as arrays with one number per law; or
    /// the errors of invalid ones.
    pub fn varied(
        &self,
        varied: &VariedArgument<'_>,
    ) -> PyResult<impl Iterator<Item = Result<ContactLaw, InvalidInput>>> {
        let (mut numbers, tables) = self.given();
        let mut columns = Vec::with_capacity(varied.len());
        for (name, column) in varied {
            columns.push((numbers.len(), column.as_slice()?));
            numbers.push((name.clone(), f64::NAN));
        }
        let count = columns.iter().map(|(_, column)| column.len()).min();
        Ok((0..count.unwrap_or(0)).map(move |row| {
            for &(place, column) in &columns {
                numbers[place].1 = column[row];
            }
            ContactLaw::named(&self.name, &numbers, &tables)
        }))
    }
}

/// Parameters of a law by name, as arrays of equal length.
pub type VariedArgument<'py> = HashMap<String, PyReadonlyArray1<'py, f64>>;
