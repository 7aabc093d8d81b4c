//! The paper's two laws by name.

use super::{Dynamics, Frictionless, NoSlip, Parameters};
use crate::body::Body;
use crate::error::InvalidInput;

/// The paper's two laws, which have closed forms. All friction laws lie between them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum IdealLaw {
    /// [`NoSlip`].
    NoSlip,
    /// [`Frictionless`].
    Frictionless,
}

impl IdealLaw {
    /// Both laws, in the order in which they are listed to the user.
    pub const ALL: [IdealLaw; 2] = [IdealLaw::NoSlip, IdealLaw::Frictionless];

    /// The name that users type.
    pub const fn name(self) -> &'static str {
        match self {
            IdealLaw::NoSlip => "no_slip",
            IdealLaw::Frictionless => "frictionless",
        }
    }

    /// The law of that name; `-` may replace `_`.
    ///
    /// # Errors
    /// Refuses an unknown name and lists the known ones.
    pub fn from_name(name: &str) -> Result<IdealLaw, InvalidInput> {
        let wanted = name.replace('-', "_");
        IdealLaw::ALL
            .into_iter()
            .find(|law| law.name() == wanted)
            .ok_or_else(|| InvalidInput::UnknownName {
                what: "law",
                name: name.to_owned(),
                choices: IdealLaw::ALL.map(IdealLaw::name).join(", "),
            })
    }

    /// The equations of motion of a body under gravity g (m/s²).
    pub fn dynamics(self, body: &Body, gravity: f64) -> Box<dyn Dynamics<f64> + Send + Sync> {
        let parameters = Parameters::new(body, gravity);
        match self {
            IdealLaw::NoSlip => Box::new(NoSlip::new(parameters)),
            IdealLaw::Frictionless => Box::new(Frictionless::new(parameters)),
        }
    }
}
