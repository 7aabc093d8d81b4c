//! Properties of every motion: any body, on any table, thrown in any way.

use crate::given::cases;
mod census;
mod examination;
mod random_cases;

use cases::cases;
use examination::look;
use proptest::prelude::*;
use random_cases::{Case, any_case, case_in_place, falling_rate, faster, follow, wild_case};
use rimroll::law::{Resistance, Stribeck, Viscous};
use rimroll::motion::Phase;
use rimroll::{Body, ContactLaw, FrictionLaw, Motion, Options, State, Status};

proptest! {
    #![proptest_config(cases(1000))]

    #[test]
    fn every_motion_obeys_mechanics_and_ends_in_truth(case in any_case()) {
        let (_, found) = look(&case).map_err(TestCaseError::fail)?;
        prop_assert!(found.violations.is_empty(), "{:?}\n{case:?}", found.violations);
    }
}

proptest! {
    #![proptest_config(cases(300))]

    #[test]
    fn so_do_bodies_that_wobble_in_place(case in case_in_place()) {
        let (_, found) = look(&case).map_err(TestCaseError::fail)?;
        prop_assert!(found.violations.is_empty(), "{:?}\n{case:?}", found.violations);
    }

    #[test]
    fn so_do_bodies_that_nobody_would_build(case in wild_case()) {
        let (_, found) = look(&case).map_err(TestCaseError::fail)?;
        prop_assert!(found.violations.is_empty(), "{:?}\n{case:?}", found.violations);
    }
}

proptest! {
    #![proptest_config(cases(150))]

    /// Mirror images move alike. (`endings.rs` tests that without slip or friction they agree to the last
    /// bit.)
    #[test]
    fn mirror_images_agree(case in any_case()) {
        let start = case.start;
        let image = Case {
            start: State {
                yaw: -start.yaw,
                yaw_rate: -start.yaw_rate,
                spin: -start.spin,
                spin_rate: -start.spin_rate,
                ..start
            },
            ..case.clone()
        };
        agree_at_first(&case, &follow(&case), &follow(&image), -1.0)?;
    }

    /// The table is isotropic.
    #[test]
    fn a_turned_start_is_a_turned_motion(case in any_case(), yaw in -3.0..3.0) {
        let turned = Case { start: State { yaw, ..case.start }, ..case.clone() };
        agree_at_first(&case, &follow(&case), &follow(&turned), 1.0)?;
    }

    /// Similarity: a body larger and heavier by powers of two has the same motion on a longer time scale, to
    /// the last bit, since powers of two do not round. Lengths scale by 4, so that times scale by 2.
    #[test]
    fn a_larger_body_does_the_same_slower(case in any_case()) {
        let b = case.body;
        let (length, mass, time) = (4.0, 8.0, 2.0);
        let inertia = mass * length * length;
        let body = Body::new(
            mass * b.mass(),
            length * b.radius(),
            length * b.height(),
            inertia * b.transverse_inertia(),
            inertia * b.axial_inertia(),
        ).expect("a rigid body");
        let slower = |rate: f64| rate / time;
        let larger = Case {
            body,
            contact_law: ContactLaw {
                friction: match case.contact_law.friction.clone() {
                    FrictionLaw::Tabulated(table) => faster(&table, length / time),
                    FrictionLaw::Viscous(Viscous { coefficient }) => FrictionLaw::Viscous(Viscous {
                        coefficient: coefficient * mass / time,
                    }),
                    FrictionLaw::Stribeck(Stribeck { friction, static_friction, stribeck_speed, creep_speed }) => {
                        FrictionLaw::Stribeck(Stribeck {
                            friction,
                            static_friction,
                            stribeck_speed: stribeck_speed * length / time,
                            creep_speed: creep_speed * length / time,
                        })
                    }
                    dry => dry,
                },
                resistance: Resistance::default(),
                ..case.contact_law.clone()
            },
            start: State {
                tilt_rate: slower(case.start.tilt_rate),
                yaw_rate: slower(case.start.yaw_rate),
                spin_rate: slower(case.start.spin_rate),
                ..case.start
            },
            options: Options { duration: time * case.options.duration, ..case.options },
        };
        let contact_law = ContactLaw { resistance: Resistance::default(), ..case.contact_law.clone() };
        let (one, other) = (follow(&Case { contact_law, ..case.clone() }), follow(&larger));
        prop_assert_eq!(one.status, other.status);
        prop_assert_eq!(one.work, other.work);
        let (a, b) = (one.trajectory.end(), other.trajectory.end());
        prop_assert_eq!((a.sin, a.yaw, time * a.t), (b.sin, b.yaw, b.t));
        prop_assert_eq!((a.p, a.w, a.s), (time * b.p, time * b.w, time * b.s));
        prop_assert_eq!(a.impact_loss * inertia / (time * time), b.impact_loss);
    }

    /// A tighter tolerance brings the motion closer to that with the tightest tolerance.
    #[test]
    fn tolerances_converge(case in any_case()) {
        let at = |rtol| {
            let options = Options { rtol, ..case.options };
            follow(&Case { options, ..case.clone() })
        };
        let (loose, tight, tightest) = (at(1e-6), at(1e-9), at(1e-12));
        // The duration is short, because a motion can be chaotic after a threshold or a near-collision.
        let ends = [&loose, &tight, &tightest].map(|motion| motion.trajectory.end().t);
        let t = 0.05 * ends.into_iter().fold(f64::INFINITY, f64::min);
        let tilt = |motion: &Motion| motion.trajectory.at(t).tilt();
        let (off, less) = (tilt(&loose) - tilt(&tightest), tilt(&tight) - tilt(&tightest));
        prop_assert!(off.abs() < 1e-3 && less.abs() < 1e-6, "{off:e} {less:e}");
    }

    /// Dry friction with μ = 0 equals no friction while the rim stays on the table.
    #[test]
    fn no_dry_friction_is_frictionless(case in any_case()) {
        let on = |friction| {
            let contact_law = ContactLaw {
                friction,
                resistance: Resistance::default(),
                ..case.contact_law.clone()
            };
            follow(&Case { contact_law, ..case.clone() })
        };
        agree_while_they_last(&case, &on(FrictionLaw::Frictionless), &on(FrictionLaw::coulomb(0.0)))?;
    }

    /// Dry friction that always suffices to stick equals no slip.
    #[test]
    fn much_dry_friction_is_no_slip(case in any_case()) {
        let on = |friction| {
            let contact_law = ContactLaw {
                friction,
                resistance: Resistance::default(),
                ..case.contact_law.clone()
            };
            follow(&Case { contact_law, ..case.clone() })
        };
        agree_while_they_last(&case, &on(FrictionLaw::NoSlip), &on(FrictionLaw::coulomb(1e5)))?;
    }
}

/// Whether two motions agree up to rounding and the sign of yaw and spin. The comparison is short, because
/// near-collisions, thresholds and chaos amplify rounding errors.
fn agree_at_first(
    case: &Case,
    one: &Motion,
    other: &Motion,
    sign: f64,
) -> Result<(), TestCaseError> {
    let ends = [one, other].map(|motion| motion.trajectory.end().t);
    let t = 0.05 * case.options.duration.min(ends[0]).min(ends[1]);
    let (a, b) = (one.trajectory.at(t), other.trajectory.at(t));
    let rates = a.p.abs() + a.w.abs() + a.s.abs() + falling_rate(&case.body);
    let allowed = 1e-6 + 1e4 * case.options.rtol;
    prop_assert!(a.phase == b.phase || (one.trajectory.at(0.9 * t).phase != a.phase));
    prop_assert!((a.tilt() - b.tilt()).abs() < allowed);
    prop_assert!((a.s - sign * b.s).abs() < allowed * rates);
    Ok(())
}

/// Whether a motion under an ideal law and the same motion under dry friction agree until the end of the
/// first phase or of the shorter motion.
fn agree_while_they_last(case: &Case, ideal: &Motion, dry: &Motion) -> Result<(), TestCaseError> {
    let start = ideal.trajectory.start();
    let phases: Vec<_> = dry.trajectory.phases().collect();
    if phases[0].phase == Phase::Flying {
        prop_assert_eq!(ideal.status, Status::LiftedOff);
        return Ok(());
    }
    let changed = phases.get(1).map_or(dry.trajectory.end().t, |at| at.t);
    let t = changed.min(ideal.trajectory.end().t);
    let (a, b) = (ideal.trajectory.at(t), dry.trajectory.at(t));
    // A near-collision amplifies errors by the ratio of the tilts.
    let lowest = ideal.trajectory.nodes().filter(|at| at.t <= t);
    let lowest = lowest.fold(start.sin, |lowest, at| lowest.min(at.sin));
    let allowed = (1e-9 + 1e3 * case.options.rtol) / lowest;
    prop_assert!(
        (a.tilt() - b.tilt()).abs() < allowed,
        "tilt {} {}",
        a.tilt(),
        b.tilt()
    );
    prop_assert!(
        (a.yaw - b.yaw).abs() < allowed * (1.0 + a.yaw.abs()),
        "yaw {} {}",
        a.yaw,
        b.yaw
    );
    Ok(())
}
