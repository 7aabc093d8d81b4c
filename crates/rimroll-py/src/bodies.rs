//! Bodies, the solids that they are composed of, and presets.

use crate::arguments::{BodiesArgument, BodyArgument, SolidArgument, refusal};
use pyo3::prelude::*;
use rimroll::{Body, InvalidInput, Solid, presets};

/// (mass, radius, height, transverse_inertia, axial_inertia)
type BodyNumbers = (f64, f64, f64, f64, f64);
/// (mass, height, transverse_inertia, axial_inertia)
type SolidNumbers = (f64, f64, f64, f64);

fn body_numbers(body: Result<Body, InvalidInput>) -> PyResult<BodyNumbers> {
    let b = body.map_err(refusal)?;
    Ok((
        b.mass(),
        b.radius(),
        b.height(),
        b.transverse_inertia(),
        b.axial_inertia(),
    ))
}

fn solid_numbers(solid: Result<Solid, InvalidInput>) -> PyResult<SolidNumbers> {
    let s = solid.map_err(refusal)?;
    Ok((s.mass, s.height, s.transverse_inertia, s.axial_inertia))
}

#[pyfunction]
pub fn check_body(body: BodyArgument) -> PyResult<()> {
    body.body().map(|_| ())
}

/// The index of the first invalid body and its error, if there is one.
#[pyfunction]
pub fn first_bad_body(bodies: BodiesArgument<'_>) -> PyResult<Option<(usize, PyErr)>> {
    let mut bad = bodies.each()?.enumerate();
    Ok(bad.find_map(|(row, body)| body.err().map(|error| (row, refusal(error)))))
}

#[pyfunction]
pub fn check_solid(solid: SolidArgument) -> PyResult<()> {
    Solid::from(solid).check().map_err(refusal)
}

#[pyfunction]
pub fn body_from_solids(radius: f64, solids: Vec<SolidArgument>) -> PyResult<BodyNumbers> {
    let solids: Vec<Solid> = solids.into_iter().map(Solid::from).collect();
    body_numbers(Body::from_solids(radius, &solids))
}

#[pyfunction]
pub fn cylinder(mass: f64, radius: f64, length: f64, base: f64) -> PyResult<SolidNumbers> {
    solid_numbers(Solid::cylinder(mass, radius, length, base))
}

#[pyfunction]
pub fn hollow_cylinder(
    mass: f64,
    inner_radius: f64,
    outer_radius: f64,
    length: f64,
    base: f64,
) -> PyResult<SolidNumbers> {
    solid_numbers(Solid::hollow_cylinder(
        mass,
        inner_radius,
        outer_radius,
        length,
        base,
    ))
}

#[pyfunction]
pub fn disk(mass: f64, radius: f64, height: f64) -> PyResult<SolidNumbers> {
    solid_numbers(Solid::disk(mass, radius, height))
}

#[pyfunction]
pub fn ring(mass: f64, radius: f64, height: f64) -> PyResult<SolidNumbers> {
    solid_numbers(Solid::ring(mass, radius, height))
}

#[pyfunction]
pub fn wall(mass: f64, radius: f64, length: f64, base: f64) -> PyResult<SolidNumbers> {
    solid_numbers(Solid::wall(mass, radius, length, base))
}

#[pyfunction]
pub fn filling(density: f64, radius: f64, depth: f64, base: f64) -> PyResult<SolidNumbers> {
    solid_numbers(Solid::filling(density, radius, depth, base))
}

/// The preset of a name, with its sizes in order.
#[pyfunction]
pub fn preset(name: &str, sizes: Vec<f64>) -> PyResult<BodyNumbers> {
    body_numbers(presets::named(name, &sizes))
}
