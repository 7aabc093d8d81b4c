//! What mechanics conserves, at every point and along whole motions, and the laws of Newton and
//! Euler, written here in the frame e_x1, e_y1, e_z without use of the equations under test.
//!
//! Tolerances of 1e-12 stand for rounding: each balance is compared with the sum of the magnitudes of
//! its terms, and the terms themselves are differences.

#[path = "given/bodies.rs"]
mod bodies;
#[path = "given/motions.rs"]
mod motions;

use bodies::{any_body, cases, powers_of_ten};
use motions::{PAPER_GRAVITY, follow, paper_start, tight};
use proptest::prelude::*;
use rimroll::law::{Frictionless, Law, NoSlip, Parameters};
use rimroll::motion::Instant;
use rimroll::real::Dual;
use rimroll::state::Coordinates;
use rimroll::{Body, IdealLaw, Motion, Options, State, Status, presets};

/// Anywhere from 1e-12 rad of lying flat to lying on its other face, moving in any way.
fn any_coordinates() -> impl Strategy<Value = Coordinates<f64>> {
    let tilt = prop_oneof![powers_of_ten(-12.0, 0.0), 0.1..3.1];
    let rate = || -20.0..20.0;
    (tilt, -4.0..4.0, rate(), rate(), rate()).prop_map(|(tilt, yaw, p, w, s)| {
        let (sin, cos) = libm::sincos(tilt);
        Coordinates {
            yaw,
            sin,
            cos,
            p,
            w,
            s,
            ..Coordinates::zero()
        }
    })
}

const ROUNDING: f64 = 1e-12;

/// The law on numbers that carry their derivative along the motion.
fn law_on_duals(law: IdealLaw, body: &Body) -> Box<dyn Law<Dual>> {
    let parameters = Parameters::new(body, PAPER_GRAVITY);
    match law {
        IdealLaw::NoSlip => Box::new(NoSlip::new(parameters)),
        IdealLaw::Frictionless => Box::new(Frictionless::new(parameters)),
    }
}

/// The coordinates, each with its rate by the solver's clock τ as slope: whatever is computed from
/// them has its own rate as slope.
fn along_the_motion(law: &dyn Law<f64>, u: &Coordinates<f64>) -> Coordinates<Dual> {
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

/// Whether vectors add up to zero, beside the sum of their lengths.
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

/// A body in the frame e_x1, e_y1, e_z that yaws with it.
struct NewtonEuler {
    /// m v_G.
    momentum: [Dual; 3],
    /// About the centre of mass: A w e_x2 − A φ̇ e_y1 + C s e_z2.
    angular_momentum: [Dual; 3],
    /// The angular velocity, its frame's τ-rate of yaw, and the arm from G to the contact point.
    angular_velocity: Vector,
    yawing: Vector,
    arm: Vector,
    /// The table's force and the weight, times sin φ as is all that goes by the clock τ.
    force: Vector,
    weight: Vector,
}

impl NewtonEuler {
    fn new(kind: IdealLaw, body: &Body, at: &Coordinates<f64>) -> NewtonEuler {
        let law = kind.of(body, PAPER_GRAVITY);
        let u = along_the_motion(&*law, at);
        let [m, a, c] =
            [body.mass(), body.transverse_inertia(), body.axial_inertia()].map(Dual::from);
        let [vx, vy] = law_on_duals(kind, body).center_velocity(&u);
        let (radius, height) = (Dual::from(body.radius()), Dual::from(body.height()));
        // P → G is R e_x2 + H e_z2, with e_x2 = (cos φ, 0, sin φ) and e_z2 = (−sin φ, 0, cos φ).
        let across = radius * u.cos - height * u.sin;
        let up = radius * u.sin + height * u.cos;
        let turn_by_tilt =
            |x2: Dual, y: Dual, z2: Dual| [x2 * u.cos - z2 * u.sin, y, x2 * u.sin + z2 * u.cos];
        let contact = law.contact(at);
        NewtonEuler {
            momentum: [m * vx, m * vy, m * across * u.p],
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

    /// The rim rolls or slides without friction: in both cases the table does no work.
    #[test]
    fn energy_has_no_rate(body in any_body(), at in any_coordinates()) {
        for kind in IdealLaw::ALL {
            let law = kind.of(&body, PAPER_GRAVITY);
            let duals = law_on_duals(kind, &body);
            let all = along_the_motion(&*law, &at).into_array();
            // The power through each coordinate by itself: only that one moves.
            let power: Vec<f64> = (0..all.len())
                .map(|moving| {
                    let u = core::array::from_fn(|i| match i == moving {
                        true => all[i],
                        false => Dual::from(all[i].value),
                    });
                    duals.energy(&Coordinates::from_array(&u)).total().slope
                })
                .collect();
            prop_assert!(vanishes(&power), "{kind:?} {power:?}");
        }
    }

    /// A l + C s cos φ with l = ψ̇ sin² φ (Eq. `slipangmom` and row 1 of Eq. `nofric_eqs`): the table
    /// pushes upward only.
    #[test]
    fn without_friction_the_vertical_angular_momentum_has_no_rate(
        body in any_body(),
        at in any_coordinates(),
    ) {
        let law = IdealLaw::Frictionless.of(&body, PAPER_GRAVITY);
        let u = along_the_motion(&*law, &at);
        // The rate of l = w sin φ is a small difference of large terms: they count by themselves.
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
        for kind in IdealLaw::ALL {
            let n = NewtonEuler::new(kind, &body, &at);
            let by_frame = cross(n.yawing, values(n.momentum));
            let [force, weight] = [n.force, n.weight].map(|f| f.map(|x| -x));
            prop_assert!(balance(&[slopes(n.momentum), by_frame, force, weight]), "{kind:?}");
        }
    }

    /// d(I Ω)/dt about the centre of mass = the moment of the contact force.
    #[test]
    fn angular_momentum_changes_by_the_moment_of_the_contact_force(
        body in any_body(),
        at in any_coordinates(),
    ) {
        for kind in IdealLaw::ALL {
            let n = NewtonEuler::new(kind, &body, &at);
            let by_frame = cross(n.yawing, values(n.angular_momentum));
            let moment = cross(n.arm, n.force).map(|x| -x);
            prop_assert!(balance(&[slopes(n.angular_momentum), by_frame, moment]), "{kind:?}");
        }
    }

    /// v_P = v_G + Ω × r_GP is zero without slip; without friction only its vertical part is.
    #[test]
    fn the_point_of_contact_is_at_rest_without_slip(body in any_body(), at in any_coordinates()) {
        for kind in IdealLaw::ALL {
            let n = NewtonEuler::new(kind, &body, &at);
            let swing = cross(n.angular_velocity, n.arm);
            let velocity = values(n.momentum).map(|p| p / body.mass());
            let size = (body.radius() + body.height()) * (at.p.abs() + at.w.abs() + at.s.abs());
            let held = match kind {
                IdealLaw::NoSlip => 0..3,
                IdealLaw::Frictionless => 2..3,
            };
            for i in held {
                prop_assert!((velocity[i] + swing[i]).abs() <= ROUNDING * size, "{kind:?} axis {i}");
            }
        }
    }

    /// The coordinates x, y, t move as the velocity of the centre of mass and the clock say.
    #[test]
    fn the_centre_of_mass_moves_with_its_velocity(body in any_body(), at in any_coordinates()) {
        for kind in IdealLaw::ALL {
            let law = kind.of(&body, PAPER_GRAVITY);
            let rates = law.rates(&at);
            let [vx, vy] = law.center_velocity(&at);
            let (sin, cos) = libm::sincos(at.yaw);
            let size = ROUNDING * (vx.abs() + vy.abs()) * rates.t;
            prop_assert!((rates.x - rates.t * (vx * cos - vy * sin)).abs() <= size);
            prop_assert!((rates.y - rates.t * (vx * sin + vy * cos)).abs() <= size);
            prop_assert_eq!(rates.t, at.sin);
        }
    }
}

/// The largest change of the energy along a motion, relative to the energy.
fn drift(motion: &Motion) -> f64 {
    let energy = |at: &Instant| motion.law(at).energy(at).total();
    let nodes: Vec<_> = motion.track.nodes().collect();
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

    /// Over some rockings, however the motion ends; at the default tolerance of 1e-10.
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
            prop_assert!(drift < 1e-10, "{:?} {}: {:e}", law, motion.message, drift);
        }
    }
}
