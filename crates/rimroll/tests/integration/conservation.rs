//! The conservation laws of mechanics, at every point and along whole motions, and the laws of Newton and
//! Euler, formulated here in the frame e_x1, e_y1, e_z without use of the equations under test.
//!
//! The tolerances of 1e-12 allow for rounding: each balance is compared with the sum of the magnitudes of its
//! terms, and the terms themselves are differences.

use crate::given::bodies;
use crate::given::cases;
use crate::given::motions;

use bodies::{any_body, powers_of_ten};
use cases::cases;
use motions::{PAPER_GRAVITY, follow, paper_start, tight};
use proptest::prelude::*;
use rimroll::law::{
    self, AirDrag, Contact, Dynamics, DynamicsExt, Parameters, PivotingFriction, Resistance,
    Resisted, Response, RollingResistance,
};
use rimroll::motion::Instant;
use rimroll::real::{Dual, Real};
use rimroll::state::Coordinates;
use rimroll::turn::painleve_friction;
use rimroll::{Body, IdealLaw, Motion, Options, State, Status, presets};

/// States from 1e-12 rad above one face to flat on the other face, with any rates.
fn any_coordinates() -> impl Strategy<Value = Coordinates<f64>> {
    let tilt = prop_oneof![powers_of_ten(-12.0, 0.0), 0.1..3.1];
    let rate = || -20.0..20.0;
    let slip = (powers_of_ten(-9.0, 0.0), -3.0..3.0);
    let moving = (tilt, -4.0..4.0, rate(), rate(), rate());
    (moving, slip).prop_map(|((tilt, yaw, p, w, s), (speed, direction))| {
        let (sin, cos) = libm::sincos(tilt);
        let (across, along) = libm::sincos(direction);
        Coordinates {
            yaw,
            sin,
            cos,
            p,
            w,
            s,
            slip_x: speed * along,
            slip_y: speed * across,
            gap_rate: 0.0,
            ..Coordinates::zero()
        }
    })
}

/// All laws of contact.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Mode {
    NoSlip,
    InPlace,
    Frictionless,
    Coulomb,
    Viscous,
    Stribeck,
    Flight,
}

use Mode::{Coulomb, Flight, Frictionless, InPlace, NoSlip, Stribeck, Viscous};

const MODES: [Mode; 7] = [
    NoSlip,
    InPlace,
    Frictionless,
    Coulomb,
    Viscous,
    Stribeck,
    Flight,
];

/// The coordinates with the spin that the law demands, where it does.
fn under(mode: Mode, at: &Coordinates<f64>) -> Coordinates<f64> {
    match mode {
        InPlace => Coordinates {
            s: -(at.w * at.sin / (1.0 + at.cos)),
            ..*at
        },
        _ => *at,
    }
}

fn law_of<T: Real + 'static>(mode: Mode, body: &Body) -> Box<dyn Dynamics<T>> {
    let k = Parameters::new(body, PAPER_GRAVITY);
    // Below the friction at which the Painlevé paradox becomes possible.
    let friction = T::from(0.5 * painleve_friction(body).min(1.0));
    match mode {
        NoSlip => Box::new(law::NoSlip::new(k)),
        InPlace => Box::new(law::InPlace::new(k)),
        Frictionless => Box::new(law::Frictionless::new(k)),
        Coulomb => Box::new(law::Sliding::new(k, law::Coulomb::uniform(friction))),
        Viscous => {
            let coefficient = T::from(0.3 * body.mass());
            Box::new(law::Sliding::new(k, law::Viscous { coefficient }))
        }
        Stribeck => {
            let stribeck = law::Stribeck {
                friction,
                static_friction: T::from(1.5) * friction,
                stribeck_speed: T::from(0.1),
                creep_speed: T::from(0.01),
            };
            Box::new(law::Sliding::new(k, stribeck))
        }
        Flight => Box::new(law::Flight::new(k)),
    }
}

/// The law with all kinds of resistance.
fn resisted<T: Real + 'static>(mode: Mode, body: &Body) -> Box<dyn Dynamics<T>> {
    let resistance = Resistance {
        rolling: RollingResistance {
            dry: 1e-2,
            viscous: 0.1 * body.mass(),
        },
        pivoting: PivotingFriction {
            length: 0.1 * body.radius(),
        },
        air: AirDrag {
            coefficient: 1e-3 * body.axial_inertia(),
            exponent: 2.5,
        },
    };
    struct Boxed<T>(Box<dyn Dynamics<T>>);
    impl<T: Real> Dynamics<T> for Boxed<T> {
        fn parameters(&self) -> &Parameters<T> {
            self.0.parameters()
        }
        fn reduced_rates(&self, u: &Coordinates<T>) -> Coordinates<T> {
            self.0.reduced_rates(u)
        }
        fn contact(&self, u: &Coordinates<T>) -> Contact<T> {
            self.0.contact(u)
        }
        fn center_velocity(&self, u: &Coordinates<T>) -> [T; 2] {
            self.0.center_velocity(u)
        }
        fn constrained_response(&self, u: &Coordinates<T>, moment: [T; 2]) -> Option<Response<T>> {
            self.0.constrained_response(u, moment)
        }
    }
    let tolerance = 1e-14;
    Box::new(Resisted::new(
        Boxed(law_of(mode, body)),
        resistance,
        tolerance,
    ))
}

const ROUNDING: f64 = 1e-12;

/// The coordinates as dual numbers whose slopes are their rates with respect to τ. Whatever is computed from
/// them then has its own rate as slope.
fn along_the_motion(law: &dyn Dynamics<f64>, u: &Coordinates<f64>) -> Coordinates<Dual> {
    let (values, slopes) = (u.into_array(), law.rates(u).into_array());
    Coordinates::from_array(&core::array::from_fn(|i| Dual {
        value: values[i],
        slope: slopes[i],
    }))
}

fn vanishes(terms: &[f64]) -> bool {
    let size: f64 = terms.iter().map(|x| x.abs()).sum();
    terms.iter().sum::<f64>().abs() <= ROUNDING * size
}

fn length(v: Vector) -> f64 {
    (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]).sqrt()
}

/// Whether vectors add up to zero, relative to the sum of their lengths.
fn balance(vectors: &[Vector]) -> bool {
    let size: f64 = vectors.iter().map(|&v| length(v)).sum();
    let sum = core::array::from_fn(|i| vectors.iter().map(|v| v[i]).sum());
    length(sum) <= ROUNDING * size
}

type Vector = [f64; 3];

fn cross(a: Vector, b: Vector) -> Vector {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

fn slopes(v: [Dual; 3]) -> Vector {
    v.map(|x| x.slope)
}

fn values(v: [Dual; 3]) -> Vector {
    v.map(|x| x.value)
}

/// A body in the yawing frame e_x1, e_y1, e_z.
struct NewtonEuler {
    /// m v_G.
    momentum: [Dual; 3],
    /// The angular momentum about the centre of mass: A w e_x2 − A φ̇ e_y1 + C s e_z2.
    angular_momentum: [Dual; 3],
    /// The angular velocity, the yaw rate of the frame with respect to τ, and the arm from G to the contact
    /// point.
    angular_velocity: Vector,
    yawing: Vector,
    arm: Vector,
    /// The contact force and the weight, times sin φ since the rates are with respect to τ.
    force: Vector,
    weight: Vector,
}

impl NewtonEuler {
    fn new(mode: Mode, body: &Body, at: &Coordinates<f64>) -> NewtonEuler {
        let law = law_of::<f64>(mode, body);
        let at = &under(mode, at);
        let u = along_the_motion(&*law, at);
        let [m, a, c] =
            [body.mass(), body.transverse_inertia(), body.axial_inertia()].map(Dual::from);
        let [vx, vy] = law_of::<Dual>(mode, body).center_velocity(&u);
        let (radius, height) = (Dual::from(body.radius()), Dual::from(body.height()));
        // P → G is R e_x2 + H e_z2, with e_x2 = (cos φ, 0, sin φ) and e_z2 = (−sin φ, 0, cos φ).
        let across = radius * u.cos - height * u.sin;
        let up = radius * u.sin + height * u.cos;
        let turn_by_tilt =
            |x2: Dual, y: Dual, z2: Dual| [x2 * u.cos - z2 * u.sin, y, x2 * u.sin + z2 * u.cos];
        let contact = law.contact(at);
        NewtonEuler {
            momentum: [m * vx, m * vy, m * (across * u.p + u.gap_rate)],
            angular_momentum: turn_by_tilt(a * u.w, -(a * u.p), c * u.s),
            angular_velocity: values(turn_by_tilt(u.w, -u.p, u.s)),
            yawing: [0.0, 0.0, at.w],
            arm: [-across.value, 0.0, -up.value],
            force: [contact.along, contact.across, contact.normal],
            weight: [0.0, 0.0, -body.mass() * PAPER_GRAVITY * at.sin],
        }
    }
}

proptest! {
    #![proptest_config(cases(400))]

    /// Friction dissipates exactly what `friction_loss` records, which is zero for rolling, frictionless
    /// sliding and flight. Resistance dissipates what `resistance_loss` records.
    #[test]
    fn energy_and_losses_together_have_no_rate(body in any_body(), at in any_coordinates()) {
        let plain = MODES.map(|mode| (mode, law_of(mode, &body), law_of(mode, &body)));
        // In flight there is no resistance.
        let worn = [NoSlip, InPlace, Frictionless, Coulomb, Viscous, Stribeck]
            .map(|mode| (mode, resisted(mode, &body), resisted(mode, &body)));
        for (mode, law, duals) in plain.into_iter().chain(worn) {
            let at = under(mode, &at);
            let rates = law.rates(&at);
            // A negative normal force, which no motion has for long, would make friction drive the rim
            // instead of braking it.
            let pressed = law.contact(&at).normal >= 0.0;
            let lost = rates.friction_loss >= 0.0 && rates.resistance_loss >= 0.0;
            prop_assert!(lost || !pressed, "{mode:?} {rates:?}");
            if matches!(mode, NoSlip | InPlace | Frictionless | Flight) {
                prop_assert_eq!(rates.friction_loss, 0.0);
            }
            let coordinates = along_the_motion(&*law, &at).into_array();
            // The power through each coordinate separately: only that coordinate has a rate.
            let mut power: Vec<f64> = (0..coordinates.len())
                .map(|moving| {
                    let u = core::array::from_fn(|i| match i == moving {
                        true => coordinates[i],
                        false => Dual::from(coordinates[i].value),
                    });
                    duals.energy(&Coordinates::from_array(&u)).total().slope
                })
                .collect();
            power.extend([rates.friction_loss, rates.resistance_loss]);
            prop_assert!(vanishes(&power), "{mode:?} {power:?}");
        }
    }

    /// A l + C s cos φ with l = ψ̇ sin² φ (Eq. `slipangmom` and row 1 of Eq. `nofric_eqs`) is conserved,
    /// because the table exerts only a normal force.
    #[test]
    fn without_friction_the_vertical_angular_momentum_has_no_rate(
        body in any_body(),
        at in any_coordinates(),
    ) {
        let law = law_of::<f64>(Frictionless, &body);
        let u = along_the_motion(&*law, &at);
        // The rate of l = w sin φ is a small difference of large terms, so the tolerance is relative to these
        // terms.
        let yaw_part = body.transverse_inertia();
        let spin_part = Dual::from(body.axial_inertia()) * u.s * u.cos;
        prop_assert!(vanishes(&[
            yaw_part * u.w.slope * u.sin.value,
            yaw_part * u.w.value * u.sin.slope,
            spin_part.slope,
        ]));
        prop_assert_eq!(u.s.slope, 0.0);
    }

    /// d(m v_G)/dt = contact force + weight, in the frame that yaws at ψ̇.
    #[test]
    fn momentum_changes_by_the_contact_force_and_the_weight(
        body in any_body(),
        at in any_coordinates(),
    ) {
        for kind in MODES {
            let n = NewtonEuler::new(kind, &body, &at);
            let by_frame = cross(n.yawing, values(n.momentum));
            let [force, weight] = [n.force, n.weight].map(|f| f.map(|x| -x));
            prop_assert!(balance(&[slopes(n.momentum), by_frame, force, weight]), "{kind:?}");
        }
    }

    /// d(I Ω)/dt about the centre of mass = the moment of the contact force and, in place, a twisting moment. That does no
    /// work on the rotation about e_x1 + tan(φ/2) e_z and about e_y1.
    #[test]
    fn angular_momentum_changes_by_the_moment_of_the_contact_force(
        body in any_body(),
        at in any_coordinates(),
    ) {
        for kind in MODES {
            let n = NewtonEuler::new(kind, &body, &at);
            let by_frame = cross(n.yawing, values(n.angular_momentum));
            let moment = cross(n.arm, n.force).map(|x| -x);
            let change = slopes(n.angular_momentum);
            let twist = match kind {
                InPlace => change[2] + by_frame[2] + moment[2],
                _ => 0.0,
            };
            let reaction = [twist * at.sin / (1.0 + at.cos), 0.0, -twist];
            let terms = [change, by_frame, moment, reaction];
            prop_assert!(balance(&terms), "{kind:?}");
        }
    }

    /// v_P = v_G + Ω × r_GP is zero without slip; without friction only its vertical part is.
    #[test]
    fn the_point_of_contact_is_at_rest_without_slip(body in any_body(), at in any_coordinates()) {
        for kind in [NoSlip, InPlace, Frictionless] {
            let n = NewtonEuler::new(kind, &body, &at);
            let swing = cross(n.angular_velocity, n.arm);
            let velocity = values(n.momentum).map(|p| p / body.mass());
            let at = under(kind, &at);
            let size = (body.radius() + body.height()) * (at.p.abs() + at.w.abs() + at.s.abs());
            let held = match kind {
                NoSlip | InPlace => 0..3,
                _ => 2..3,
            };
            for i in held {
                prop_assert!((velocity[i] + swing[i]).abs() <= ROUNDING * size, "{kind:?} axis {i}");
            }
        }
    }

    /// The centre of mass moves with its velocity, wherever it is, and dt/dτ = sin φ.
    #[test]
    fn the_centre_of_mass_moves_with_its_velocity(body in any_body(), at in any_coordinates()) {
        for mode in MODES {
            let law = law_of::<f64>(mode, &body);
            let at = Coordinates { x1: 0.1, y1: -0.3, ..at };
            let u = along_the_motion(&*law, &at);
            let [vx, vy] = law.center_velocity(&at);
            let (sin, cos) = libm::sincos(at.yaw);
            let size = ROUNDING * ((vx.abs() + vy.abs()) * u.t.slope + at.w.abs());
            let [x, y] = u.center();
            prop_assert!((x.slope - u.t.slope * (vx * cos - vy * sin)).abs() <= size);
            prop_assert!((y.slope - u.t.slope * (vx * sin + vy * cos)).abs() <= size);
            prop_assert_eq!(u.t.slope, at.sin);
        }
    }
}

/// The largest change of the energy along a motion, relative to the energy.
fn drift(motion: &Motion) -> f64 {
    let energy = |at: &Instant| motion.dynamics(at).energy(at).total();
    let nodes: Vec<_> = motion.trajectory.nodes().collect();
    let start = energy(&nodes[0]);
    nodes
        .iter()
        .map(|u| (energy(u) / start - 1.0).abs())
        .fold(0.0, f64::max)
}

#[test]
fn the_energy_of_the_can_survives_twenty_rockings() {
    let can = presets::can_2007().expect("the paper's can");
    for law in IdealLaw::ALL {
        for (rtol, allowed) in [
            (Options::default().rtol, 1e-10),
            (1e-13, 1e-13),
            (1e-14, 1e-13),
        ] {
            let options = Options {
                rtol,
                ..tight(13.0)
            };
            let motion = follow(&can, &paper_start(0.005), law, &options);
            assert!(motion.turns.len() >= 20);
            let drift = drift(&motion);
            assert!(drift < allowed, "{law:?} rtol {rtol:e}: {drift:e}");
        }
    }
}

proptest! {
    #![proptest_config(cases(60))]

    /// Over several rocking motions, however they end, at the default tolerance of 1e-10.
    #[test]
    fn the_energy_of_any_body_survives_its_motion(
        body in any_body(),
        lean in 0.05..0.95,
        sideways in prop_oneof![-1.0..1.0, -1e-6..1e-6],
        spin in -1.0..1.0,
    ) {
        let falling_rate = (PAPER_GRAVITY / body.radius()).sqrt();
        let start = State {
            tilt: lean * body.balance_tilt(),
            yaw_rate: sideways * falling_rate,
            spin_rate: sideways * spin * falling_rate,
            ..State::default()
        };
        let options = Options {
            rtol: Options::default().rtol,
            ..tight(20.0 / falling_rate)
        };
        for law in IdealLaw::ALL {
            let motion = follow(&body, &start, law, &options);
            let drift = drift(&motion);
            prop_assert!(motion.status != Status::Failed);
            prop_assert!(drift < 1e-10, "{:?} {}: {:e}", law, motion.message(), drift);
        }
    }
}
