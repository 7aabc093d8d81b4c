//! How the rim can meet the table on a given surface, and what follows when one way gives over to
//! another.

use crate::body::Body;
use crate::impact;
use crate::law::{
    Coulomb, Flight, Frictionless, Law, NoSlip, Parameters, Resisted, Sliding, Stribeck, Viscous,
};
use crate::state::Coordinates;
use crate::surface::{FrictionLaw, Surface};
use core::f64::consts::TAU;

/// How the rim meets the table at a moment.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Phase {
    /// It rolls: its lowest point is at rest.
    Rolling,
    /// Its lowest point slips.
    Sliding,
    /// It is off the table.
    Flying,
}

impl Phase {
    /// The name that the user reads.
    pub fn name(self) -> &'static str {
        match self {
            Phase::Rolling => "rolling",
            Phase::Sliding => "sliding",
            Phase::Flying => "flying",
        }
    }
}

/// The law of a rim that slides under dry friction.
pub(super) type DrySliding = Resisted<Sliding<f64, Coulomb<f64>>>;

/// The law of a rim that slides.
enum SlidingLaw {
    Never,
    Dry(DrySliding),
    Smooth(Box<dyn Law<f64> + Send + Sync>),
}

/// What becomes of a rim on the table.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Next {
    /// It rolls.
    Roll,
    /// It slides on with the slip that it has.
    Slide,
    /// It begins to slip in this direction (unit vector along e_x1, e_y1), from rest.
    BeginToSlip([f64; 2]),
    /// It leaves the table.
    Fly,
    /// Rigid-body mechanics does not say.
    Paradox,
}

/// Below this part of the velocities at hand a slip or a rebound counts as none.
pub(super) const STOPPED: f64 = 1e-14;

/// The laws of a body on a surface.
pub struct Contacts {
    parameters: Parameters<f64>,
    surface: Surface,
    rolling: Resisted<NoSlip<f64>>,
    sliding: SlidingLaw,
    flying: Flight<f64>,
}

impl Contacts {
    /// The laws of a body on a surface under gravity g (m/s²).
    pub fn new(body: &Body, surface: &Surface, gravity: f64) -> Self {
        let parameters = Parameters::new(body, gravity);
        let resistance = surface.resistance;
        let dry = |friction| {
            let law = Sliding::new(parameters, Coulomb { friction });
            SlidingLaw::Dry(Resisted::new(law, resistance))
        };
        fn smooth(law: impl Law<f64> + Send + Sync + 'static) -> SlidingLaw {
            SlidingLaw::Smooth(Box::new(law))
        }
        let sliding = match surface.friction {
            FrictionLaw::NoSlip => SlidingLaw::Never,
            FrictionLaw::Frictionless => {
                smooth(Resisted::new(Frictionless::new(parameters), resistance))
            }
            FrictionLaw::Coulomb { friction, .. } => dry(friction),
            FrictionLaw::Viscous { coefficient } => {
                let law = Sliding::new(parameters, Viscous { coefficient });
                smooth(Resisted::new(law, resistance))
            }
            FrictionLaw::Stribeck {
                friction,
                static_friction,
                stribeck_speed,
                creep_speed,
            } => {
                let friction = Stribeck {
                    friction,
                    static_friction,
                    stribeck_speed,
                    creep_speed,
                };
                smooth(Resisted::new(
                    Sliding::new(parameters, friction),
                    resistance,
                ))
            }
        };
        Contacts {
            parameters,
            surface: *surface,
            rolling: Resisted::new(NoSlip::new(parameters), resistance),
            sliding,
            flying: Flight::new(parameters),
        }
    }

    /// The law that holds in a phase.
    pub fn law(&self, phase: Phase) -> &dyn Law<f64> {
        match (phase, &self.sliding) {
            (Phase::Rolling, _) | (Phase::Sliding, SlidingLaw::Never) => &self.rolling,
            (Phase::Sliding, SlidingLaw::Dry(law)) => law,
            (Phase::Sliding, SlidingLaw::Smooth(law)) => &**law,
            (Phase::Flying, _) => &self.flying,
        }
    }

    /// The body and gravity.
    pub fn parameters(&self) -> &Parameters<f64> {
        &self.parameters
    }

    /// The surface.
    pub fn surface(&self) -> &Surface {
        &self.surface
    }

    /// The law of sliding under dry friction, where there is dry friction.
    pub(super) fn dry(&self) -> Option<&DrySliding> {
        match &self.sliding {
            SlidingLaw::Dry(law) => Some(law),
            _ => None,
        }
    }

    /// Whether the contact may be lost and found again: the two ideal laws end there instead.
    pub(super) fn can_fly(&self) -> bool {
        self.surface.friction.ideal().is_none()
    }

    /// By how much dry friction could hold the rolling rim yet, N sin φ: μ_s N − |T|.
    pub(super) fn grip(&self, u: &Coordinates<f64>) -> f64 {
        let FrictionLaw::Coulomb {
            static_friction, ..
        } = self.surface.friction
        else {
            return 1.0;
        };
        let contact = self.rolling.contact(u);
        static_friction * contact.normal - libm::hypot(contact.along, contact.across)
    }

    /// What keeps the rim on the table, N sin φ: where friction has given way so far that nothing presses,
    /// the force that would be had without it.
    pub(super) fn pressing(&self, phase: Phase, u: &Coordinates<f64>) -> f64 {
        let normal = self.law(phase).contact(u).normal;
        if normal > 0.0 || phase == Phase::Rolling {
            normal
        } else {
            -self.parameters.m * self.flying.rates(u).gap_rate
        }
    }

    /// A speed (m/s) to compare a slip or a rebound with.
    pub(super) fn slip_scale(&self, u: &Coordinates<f64>) -> f64 {
        let k = &self.parameters;
        k.r * (u.p.abs() + u.w.abs() + u.s.abs() + (k.g / k.r).sqrt())
    }

    /// A speed (m/s) below which a slip or a rebound counts as none.
    fn stopped_speed(&self, u: &Coordinates<f64>) -> f64 {
        STOPPED * self.slip_scale(u)
    }

    /// How a rim on the table goes on.
    pub(super) fn settle(&self, u: &Coordinates<f64>) -> Next {
        match self.surface.friction {
            FrictionLaw::NoSlip => Next::Roll,
            FrictionLaw::Frictionless => Next::Slide,
            FrictionLaw::Coulomb { .. } if u.slip_speed() <= self.stopped_speed(u) => {
                let pressed = self.rolling.contact(u).normal > 0.0;
                if pressed && self.grip(u) >= 0.0 {
                    Next::Roll
                } else {
                    self.begin_to_slip(u)
                }
            }
            _ => {
                let law = self.law(Phase::Sliding);
                if law.consistency(u) <= 0.0 {
                    Next::Paradox
                } else if self.pressing(Phase::Sliding, u) >= 0.0 {
                    Next::Slide
                } else {
                    Next::Fly
                }
            }
        }
    }

    /// How a rim at rest that friction cannot hold begins to slip: in the direction in which it then
    /// accelerates, which is against the friction that would be needed where that is just too much.
    pub(super) fn begin_to_slip(&self, u: &Coordinates<f64>) -> Next {
        let Some(dry) = self.dry() else {
            return Next::Slide;
        };
        let needed = self.rolling.contact(u);
        let size = libm::hypot(needed.along, needed.across);
        let against = if size > 0.0 {
            [-needed.along / size, -needed.across / size]
        } else {
            [1.0, 0.0]
        };
        if self.direction_is_kept(dry, u, against) {
            return Next::BeginToSlip(polished(dry, u, against));
        }
        const LOOKS: u32 = 64;
        let angle = |i: u32| TAU * (f64::from(i) / f64::from(LOOKS) - 0.5);
        let sideways = |angle: f64| onset(dry, u, against, angle).sideways;
        let kept = (0..LOOKS).filter_map(|i| {
            // A direction attracts when the slip is turned toward it from both sides.
            let (from, to) = (angle(i), angle(i + 1));
            let attracts = sideways(from) >= 0.0 && sideways(to) < 0.0;
            let root = attracts.then(|| crate::solve::bracketed(from, to, sideways))?;
            onset(dry, u, against, root).is_possible().then_some(root)
        });
        match kept.min_by(|a, b| a.abs().total_cmp(&b.abs())) {
            Some(angle) => Next::BeginToSlip(polished(dry, u, turned(against, angle))),
            None if self.flying.rates(u).gap_rate > 0.0 => Next::Fly,
            None => Next::Paradox,
        }
    }

    /// The rates at the start of a motion, by the law that then holds.
    pub(crate) fn first_rates(&self, u: &Coordinates<f64>) -> Coordinates<f64> {
        match (self.settle(u), self.dry()) {
            (Next::Roll, _) => self.rolling.rates(u),
            (Next::BeginToSlip(e), Some(dry)) => {
                let pull = dry.law().friction().against(e);
                dry.law().rates_under(u, &pull)
            }
            _ => self.law(Phase::Sliding).rates(u),
        }
    }

    /// Whether a slip that begins in this direction keeps it: beside it, it is turned toward it.
    fn direction_is_kept(&self, dry: &DrySliding, u: &Coordinates<f64>, e: [f64; 2]) -> bool {
        const BESIDE: f64 = 1e-4;
        let there = onset(dry, u, e, 0.0);
        let beside = |angle: f64| onset(dry, u, e, angle).sideways;
        there.sideways.abs() <= 1e-9 * there.size
            && there.is_possible()
            && beside(BESIDE) < beside(-BESIDE)
    }

    /// The coordinates after a landing, and how the rim goes on.
    pub(super) fn land(&self, u: &Coordinates<f64>) -> (Coordinates<f64>, Next) {
        let friction = self.surface.friction.friction_in_impact();
        let restitution = self.surface.restitution;
        // Rebounds that fall off by a factor need an end: one that lasts no time to speak of.
        let rest = 1e3 * self.stopped_speed(u);
        let after = impact::land(&self.parameters, u, friction, restitution, rest);
        if after.gap_rate > 0.0 {
            return (after, Next::Fly);
        }
        (after, self.settle(&after))
    }
}

/// How a slip from rest would begin in a direction.
struct Onset {
    /// The slip's acceleration across the direction.
    sideways: f64,
    /// The same along it.
    forward: f64,
    /// Of the forces on it, to compare with.
    size: f64,
    normal: f64,
    consistency: f64,
}

impl Onset {
    fn is_possible(&self) -> bool {
        self.forward >= -1e-9 * self.size && self.normal > 0.0 && self.consistency > 0.0
    }
}

fn onset(dry: &DrySliding, u: &Coordinates<f64>, base: [f64; 2], angle: f64) -> Onset {
    let e = turned(base, angle);
    let at_rest = Coordinates {
        slip_x: 0.0,
        slip_y: 0.0,
        ..*u
    };
    let sliding = dry.law();
    let pull = sliding.friction().against(e);
    let contact = sliding.contact_under(&at_rest, &pull);
    let rates = dry.resist(
        &at_rest,
        sliding.rates_under(&at_rest, &pull),
        contact.normal,
    );
    let k = sliding.parameters();
    Onset {
        sideways: rates.slip_y * e[0] - rates.slip_x * e[1],
        forward: rates.slip_x * e[0] + rates.slip_y * e[1],
        size: libm::hypot(contact.along, contact.across) * k.sideways_mobility()
            + libm::hypot(rates.slip_x, rates.slip_y),
        normal: contact.normal,
        consistency: sliding.consistency_under(&at_rest, &pull),
    }
}

/// A direction that slip nearly keeps, turned to the one that it keeps: by Newton's method, as long as
/// that helps. In a motion that is almost plane the smallest angle counts.
fn polished(dry: &DrySliding, u: &Coordinates<f64>, e: [f64; 2]) -> [f64; 2] {
    const NUDGE: f64 = 1e-5;
    let sideways = |e: [f64; 2]| onset(dry, u, e, 0.0).sideways;
    let mut kept = (e, sideways(e));
    for _ in 0..5 {
        let (e, now) = kept;
        let slope = (sideways(turned(e, NUDGE)) - sideways(turned(e, -NUDGE))) / (2.0 * NUDGE);
        let next = turned(e, -now / slope);
        let then = sideways(next);
        // Written so that a NaN does not help.
        if then.abs() < now.abs() {
            kept = (next, then);
        } else {
            break;
        }
    }
    kept.0
}

/// A unit vector turned by an angle.
pub(super) fn turned(e: [f64; 2], angle: f64) -> [f64; 2] {
    let (sin, cos) = libm::sincos(angle);
    [e[0] * cos - e[1] * sin, e[1] * cos + e[0] * sin]
}
