//! What the page asks about, read off its arguments one after the other.

use rimroll::{Body, ContactLaw, FrictionLaw, InvalidInput, Options, Solid, State};

/// The shapes of solids; the page names them by their places here.
pub const SHAPES: [&str; 3] = ["disc", "wall", "cylinder"];

/// The numbers of a surface by name, in the order in which the page writes them; NaN where one is not
/// given.
const SURFACE: [&str; 3] = ["friction", "restitution", "rolling_dry"];

/// The arguments not read yet.
pub struct Asked {
    numbers: std::vec::IntoIter<f64>,
}

impl Asked {
    pub fn new() -> Self {
        Asked {
            numbers: crate::exchange::asked().into_iter(),
        }
    }

    /// The next number; NaN where there is none, which the core refuses.
    pub fn number(&mut self) -> f64 {
        self.numbers.next().unwrap_or(f64::NAN)
    }

    fn given(&mut self) -> Option<f64> {
        Some(self.number()).filter(|number| !number.is_nan())
    }

    fn array<const N: usize>(&mut self) -> [f64; N] {
        core::array::from_fn(|_| self.number())
    }

    /// The numbers that are left.
    pub fn rest(self) -> Vec<f64> {
        self.numbers.collect()
    }

    /// Whether any are left.
    pub fn more(&self) -> bool {
        self.numbers.len() > 0
    }

    /// Mass, radius, height, transverse and axial moment of inertia.
    pub fn body(&mut self) -> Result<Body, InvalidInput> {
        let [mass, radius, height, transverse, axial] = self.array();
        Body::new(mass, radius, height, transverse, axial)
    }

    /// The shape's place in [`SHAPES`], mass, radius, length and height of its base.
    pub fn solid(&mut self) -> Result<Solid, InvalidInput> {
        let [shape, mass, radius, length, base] = self.array();
        match named("shape", shape, &SHAPES)? {
            "disc" => Solid::disc(mass, radius, base),
            "wall" => Solid::wall(mass, radius, length, base),
            _ => Solid::cylinder(mass, radius, length, base),
        }
    }

    /// Tilt, yaw and spin, each with its rate.
    pub fn start(&mut self) -> State {
        let [tilt, tilt_rate, yaw, yaw_rate, spin, spin_rate] = self.array();
        State {
            tilt,
            tilt_rate,
            yaw,
            yaw_rate,
            spin,
            spin_rate,
        }
    }

    /// The law's place in [`FrictionLaw::NAMES`], then the numbers of [`SURFACE`].
    pub fn contact_law(&mut self) -> Result<ContactLaw, InvalidInput> {
        let law = named("law", self.number(), &FrictionLaw::NAMES)?;
        let given: Vec<_> = SURFACE
            .into_iter()
            .filter_map(|name| Some((name.to_owned(), self.given()?)))
            .collect();
        ContactLaw::named(law, &given, &[])
    }

    /// Duration, gravity, rtol and the most steps.
    pub fn options(&mut self) -> Options {
        let [duration, gravity, rtol, max_steps] = self.array();
        Options {
            duration,
            gravity,
            rtol,
            topple_tilt: None,
            max_steps: max_steps as usize,
        }
    }
}

/// The name at a place of a list. What is no place of it, as the page's -1 for a name that it does not
/// find, is refused, not taken for another.
pub fn named(
    what: &'static str,
    place: f64,
    names: &[&'static str],
) -> Result<&'static str, InvalidInput> {
    let found = (0..).zip(names).find(|&(at, _)| f64::from(at) == place);
    let (_, name) = found.ok_or_else(|| InvalidInput::UnknownName {
        what,
        name: place.to_string(),
        choices: names.join(", "),
    })?;
    Ok(name)
}
