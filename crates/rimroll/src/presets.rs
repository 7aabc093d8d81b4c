//! Everyday bodies.
//!
//! Each states the source of its numbers: the paper, a manufacturer's data, or the solids that it is
//! composed of. Bodies with nominal sizes are typical of their kind and describe no particular specimen.

use crate::body::Body;
use crate::error::{InvalidInput, bounded, positive};
use crate::solids::Solid;

/// Defines [`NAMES`] and [`named`] for a list of presets with their sizes.
macro_rules! presets {
    ($($preset:ident($($size:ident),*),)*) => {
        /// The names of the presets.
        pub const NAMES: &[&str] = &[$(stringify!($preset),)*];

        /// The preset of a name, with its sizes in the order of its function's arguments. A size that is
        /// missing counts as NaN.
        ///
        /// # Errors
        /// Refuses an unknown name, and sizes as the function of the preset does.
        pub fn named(name: &str, sizes: &[f64]) -> Result<Body, InvalidInput> {
            #[allow(unused_mut, unused_variables)]
            match name {
                $(stringify!($preset) => {
                    let mut sizes = sizes.iter().copied();
                    $(let $size = sizes.next().unwrap_or(f64::NAN);)*
                    $preset($($size),*)
                })*
                _ => Err(InvalidInput::UnknownName {
                    what: "preset",
                    name: name.to_owned(),
                    choices: NAMES.join(", "),
                }),
            }
        }
    };
}

presets! {
    can_2007(),
    soda_can(fill),
    beer_bottle(fill),
    coin(),
    battery(),
    ring(radius),
    disk(radius),
    cylinder(radius, length),
    euler_disk(),
}

/// Density of aluminium, kg/m³.
const ALUMINIUM: f64 = 2700.0;
/// Density of soda-lime glass, kg/m³.
const GLASS: f64 = 2500.0;
/// Density of water, kg/m³; drinks are within 5 %.
const WATER: f64 = 1000.0;
/// Density of steel, kg/m³.
const STEEL: f64 = 7850.0;

/// The can of Srinivasan & Ruina (2007): m = 0.070 kg, R = 5.1 cm, H = 6.9 cm,
/// A/m = 5.13e-3 m² (section "Quantitative comparisons").
///
/// C/m = 2.0e-3 m² replaces the 8e-3 m² of the simulation figure's caption: no can that lies inside its
/// own rim can have C/m > R² = 2.6e-3 m², and a wall with two discs has 1.3e-3 to 2.2e-3 m². No
/// limiting angle depends on C.
pub fn can_2007() -> Result<Body, InvalidInput> {
    let mass = 0.070;
    Body::new(mass, 0.051, 0.069, 5.13e-3 * mass, 2.0e-3 * mass)
}

/// A 330 ml aluminium drinks can; `fill` is the filled fraction, between 0 (empty) and 1.
///
/// Nominal sizes: a body of 66 mm diameter and 115 mm height with a wall of 0.10 mm; a base 0.30 mm thick,
/// 5 mm above a rim of 48 mm diameter; a lid 0.25 mm thick of 52 mm diameter. The empty can weighs 10.6 g.
/// The filling is water, 97 mm deep when full, and moves as if frozen.
pub fn soda_can(fill: f64) -> Result<Body, InvalidInput> {
    let fill = fraction("fill", fill)?;
    let (radius, height) = (0.033, 0.115);
    let mut solids = vec![
        wall(ALUMINIUM, radius, 0.10e-3, height, 0.0)?,
        plate(ALUMINIUM, radius, 0.30e-3, 0.005)?,
        plate(ALUMINIUM, 0.026, 0.25e-3, height)?,
    ];
    if fill > 0.0 {
        solids.push(Solid::filling(WATER, radius, 0.097 * fill, 0.005)?);
    }
    Body::from_solids(0.024, &solids)
}

/// A 330 ml long-neck glass bottle; `fill` is the filled fraction of its body, between 0 (empty) and 1.
///
/// Nominal sizes: a body of 61 mm diameter and 130 mm height with a wall of 2.2 mm; shoulder and neck as one
/// wall 100 mm long, of 30 mm outer diameter and 2.8 mm thick; a base 6 mm thick on a rim of 52 mm
/// diameter. The empty bottle weighs 0.23 kg. The filling is water and moves as if frozen.
pub fn beer_bottle(fill: f64) -> Result<Body, InvalidInput> {
    let fill = fraction("fill", fill)?;
    let (radius, body, neck) = (0.0305, 0.130, 0.100);
    let mut solids = vec![
        wall(GLASS, radius - 0.0011, 2.2e-3, body, 0.0)?,
        wall(GLASS, 0.0136, 2.8e-3, neck, body)?,
        plate(GLASS, radius - 0.0022, 6.0e-3, 0.003)?,
    ];
    if fill > 0.0 {
        let depth = (body - 0.006) * fill;
        solids.push(Solid::filling(WATER, radius - 0.0022, depth, 0.006)?);
    }
    Body::from_solids(0.026, &solids)
}

/// A 1 euro coin as a uniform cylinder: 7.5 g, 23.25 mm across, 2.33 mm thick (European Central
/// Bank, technical specifications of the euro coins).
pub fn coin() -> Result<Body, InvalidInput> {
    uniform_cylinder(7.5e-3, 0.5 * 23.25e-3, 2.33e-3)
}

/// An AA alkaline cell as a uniform cylinder: 14.5 mm across and 50.5 mm long (the largest size
/// that IEC 60086-2 allows for LR6), 23 g.
pub fn battery() -> Result<Body, InvalidInput> {
    uniform_cylinder(23e-3, 0.5 * 14.5e-3, 50.5e-3)
}

/// A thin ring of mass 1 kg: H = 0, C = mR², A = C/2, so k = 1 (the paper's "Disks" section). No
/// turn depends on its mass.
pub fn ring(radius: f64) -> Result<Body, InvalidInput> {
    Body::from_solids(radius, &[Solid::ring(1.0, radius, 0.0)?])
}

/// A uniform thin disk of mass 1 kg: H = 0, C = mR²/2, A = C/2, so k² = ½ (the paper's "Disks"
/// section). No turn depends on its mass.
pub fn disk(radius: f64) -> Result<Body, InvalidInput> {
    Body::from_solids(radius, &[Solid::disk(1.0, radius, 0.0)?])
}

/// The toy called Euler's disk: a steel cylinder of 75 mm diameter and 12.7 mm (½ inch) thickness, 0.44 kg,
/// on the rim of one face, so H = 6.35 mm.
pub fn euler_disk() -> Result<Body, InvalidInput> {
    cylinder_of(STEEL, 0.0375, 12.7e-3)
}

/// A uniform solid cylinder with the density of water: H is half its length, C = mR²/2,
/// A = m(R²/4 + L²/12). No turn depends on its mass.
pub fn cylinder(radius: f64, length: f64) -> Result<Body, InvalidInput> {
    cylinder_of(WATER, radius, length)
}

fn cylinder_of(density: f64, radius: f64, length: f64) -> Result<Body, InvalidInput> {
    positive("radius", radius, "m")?;
    positive("length", length, "m")?;
    Body::from_solids(radius, &[Solid::filling(density, radius, length, 0.0)?])
}

fn uniform_cylinder(mass: f64, radius: f64, length: f64) -> Result<Body, InvalidInput> {
    Body::from_solids(radius, &[Solid::cylinder(mass, radius, length, 0.0)?])
}

/// A thin wall of the given thickness; `radius` is that of its mid-surface.
fn wall(
    density: f64,
    radius: f64,
    thickness: f64,
    length: f64,
    base: f64,
) -> Result<Solid, InvalidInput> {
    let area = 2.0 * core::f64::consts::PI * radius * thickness;
    Solid::wall(density * area * length, radius, length, base)
}

/// A thin disk of the given thickness; `height` is that of its mid-plane.
fn plate(density: f64, radius: f64, thickness: f64, height: f64) -> Result<Solid, InvalidInput> {
    let area = core::f64::consts::PI * radius * radius;
    Solid::disk(density * area * thickness, radius, height)
}

fn fraction(field: &'static str, value: f64) -> Result<f64, InvalidInput> {
    bounded(
        field,
        value,
        |v| (0.0..=1.0).contains(&v),
        "between 0 and 1",
        "",
    )
}
