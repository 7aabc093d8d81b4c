//! The buffers through which page and core exchange numbers and text. [`Arguments`] reads the page's numbers one after
//! another.

use core::cell::RefCell;
use rimroll::{Body, ContactLaw, FrictionLaw, InvalidInput, Options, Solid, State};

/// The buffers between a call and the reading of its results.
#[derive(Default)]
struct Exchange {
    arguments: Vec<f64>,
    numbers: Vec<f64>,
    text: String,
}

thread_local! {
    static EXCHANGE: RefCell<Exchange> = RefCell::default();
}

/// The address at which the page must write its next `count` arguments.
#[unsafe(no_mangle)]
pub extern "C" fn arguments(count: usize) -> *mut f64 {
    EXCHANGE.with_borrow_mut(|exchange| {
        exchange.arguments.clear();
        exchange.arguments.resize(count, f64::NAN);
        exchange.arguments.as_mut_ptr()
    })
}

/// The address of the numbers of the last result.
#[unsafe(no_mangle)]
pub extern "C" fn numbers() -> *const f64 {
    EXCHANGE.with_borrow(|exchange| exchange.numbers.as_ptr())
}

/// The count of these numbers.
#[unsafe(no_mangle)]
pub extern "C" fn number_count() -> usize {
    EXCHANGE.with_borrow(|exchange| exchange.numbers.len())
}

/// The address of the text of the last result, in UTF-8.
#[unsafe(no_mangle)]
pub extern "C" fn text() -> *const u8 {
    EXCHANGE.with_borrow(|exchange| exchange.text.as_ptr())
}

/// The length of this text in bytes.
#[unsafe(no_mangle)]
pub extern "C" fn text_length() -> usize {
    EXCHANGE.with_borrow(|exchange| exchange.text.len())
}

/// Provides numbers to the page.
pub fn answer(numbers: impl IntoIterator<Item = f64>) {
    EXCHANGE.with_borrow_mut(|exchange| {
        exchange.numbers.clear();
        exchange.numbers.extend(numbers);
    });
}

/// Provides text to the page.
pub fn say(words: &str) {
    EXCHANGE.with_borrow_mut(|exchange| {
        exchange.text.clear();
        exchange.text.push_str(words);
    });
}

/// Provides names to the page, separated by spaces.
pub fn name(names: impl IntoIterator<Item = &'static str>) {
    say(&names.into_iter().collect::<Vec<_>>().join(" "));
}

/// The value, or `None` with the core's error message as the text.
pub fn unless_refused<T>(result: Result<T, InvalidInput>) -> Option<T> {
    result.map_err(|refusal| say(&refusal.to_string())).ok()
}

/// The shapes of solids; the page refers to them by index.
pub const SHAPES: [&str; 3] = ["disk", "wall", "cylinder"];

/// The parameters of a contact law by name, in the order in which the page writes them; NaN if absent.
const PARAMETERS: [&str; 3] = ["friction", "restitution", "rolling_dry"];

/// The arguments of the current call that are not yet read.
pub struct Arguments {
    numbers: std::vec::IntoIter<f64>,
}

impl Arguments {
    pub fn new() -> Self {
        Arguments {
            numbers: EXCHANGE
                .with_borrow_mut(|exchange| core::mem::take(&mut exchange.arguments))
                .into_iter(),
        }
    }

    /// The next number, or NaN, which the core refuses, if there is none.
    pub fn number(&mut self) -> f64 {
        self.numbers.next().unwrap_or(f64::NAN)
    }

    fn given(&mut self) -> Option<f64> {
        Some(self.number()).filter(|number| !number.is_nan())
    }

    /// The next numbers.
    pub fn array<const N: usize>(&mut self) -> [f64; N] {
        core::array::from_fn(|_| self.number())
    }

    /// The remaining numbers.
    pub fn rest(self) -> Vec<f64> {
        self.numbers.collect()
    }

    /// Whether numbers remain.
    pub fn any_left(&self) -> bool {
        self.numbers.len() > 0
    }

    /// Mass, radius, height, transverse and axial moment of inertia.
    pub fn body(&mut self) -> Result<Body, InvalidInput> {
        let [mass, radius, height, transverse, axial] = self.array();
        Body::new(mass, radius, height, transverse, axial)
    }

    /// The shape's index in [`SHAPES`], mass, radius, length and height of its base.
    pub fn solid(&mut self) -> Result<Solid, InvalidInput> {
        let [shape, mass, radius, length, base] = self.array();
        match named("shape", shape, &SHAPES)? {
            "disk" => Solid::disk(mass, radius, base),
            "wall" => Solid::wall(mass, radius, length, base),
            _ => Solid::cylinder(mass, radius, length, base),
        }
    }

    /// Tilt, yaw and spin, each with its rate.
    pub fn start(&mut self) -> State {
        State::from_numbers(self.array())
    }

    /// The law's index in [`FrictionLaw::NAMES`], then the numbers of [`PARAMETERS`].
    pub fn contact_law(&mut self) -> Result<ContactLaw, InvalidInput> {
        let law = named("law", self.number(), FrictionLaw::NAMES)?;
        let given: Vec<_> = PARAMETERS
            .into_iter()
            .filter_map(|name| Some((name.to_owned(), self.given()?)))
            .collect();
        ContactLaw::named(law, &given, &[])
    }

    /// Duration, gravity, rtol and the maximal number of steps.
    pub fn options(&mut self) -> Options {
        let [duration, gravity, rtol, max_steps] = self.array();
        Options {
            duration,
            gravity,
            rtol,
            max_steps: max_steps as usize,
            ..Options::default()
        }
    }
}

/// The name at an index of a list. Refuses an invalid index, such as the -1 that the page sends for an
/// unknown name.
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
