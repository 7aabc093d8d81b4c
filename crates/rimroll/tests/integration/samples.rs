//! Steps from sample to sample of a record, for one motion and in lanes.

use crate::given::cases;

use cases::cases;
use proptest::prelude::*;
use rimroll::ground::{Ground, Pulse, Shape};
use rimroll::law::Coulomb;
use rimroll::law::DynamicsExt;
use rimroll::motion::{EventKind, FlatLanding, Shaken, shaken};
use rimroll::{
    Body, ContactLaw, FrictionLaw, IdealLaw, Options, Shaking, State, Status, shake_many,
    simulate_on,
};
use std::ops::ControlFlow;
use std::sync::Arc;

fn options(rtol: f64) -> Options {
    Options {
        gravity: 9.81,
        rtol,
        duration: 3.0,
        flat: FlatLanding::Housner,
        ..Options::default()
    }
}

/// A random record: sines of many periods.
fn record(seed: u64, step: f64, peak: f64) -> Ground {
    let mut seed = seed.wrapping_mul(2) + 1;
    let mut random = move || {
        seed = seed
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (seed >> 11) as f64 / (1_u64 << 53) as f64
    };
    let waves: Vec<[f64; 3]> = (0..24)
        .map(|_| {
            [
                1.0 + 40.0 * random(),
                6.0 * random(),
                peak * (random() - 0.5),
            ]
        })
        .collect();
    let at = |t: f64, axis: usize| -> f64 {
        let mine = waves.iter().skip(axis).step_by(3);
        mine.map(|[rate, phase, size]| size * libm::sin(rate * t + phase))
            .sum()
    };
    let count = (2.7 / step) as usize;
    let samples = (0..count)
        .map(|i| core::array::from_fn(|axis| at(step * i as f64, axis)))
        .collect();
    Ground::sampled(step, samples).unwrap()
}

/// Returns the ground in a form that these steps do not follow.
fn with_a_pulse_of_no_size(ground: &Ground) -> Ground {
    let pulse = Pulse {
        amplitude: [0.0; 3],
        shape: Shape::Constant,
        duration: 100.0,
    };
    let pulses = Ground::pulses(vec![pulse]).unwrap();
    ground.plus(&pulses).unwrap()
}

fn alone(row: &Shaking<'_>, options: &Options) -> Shaken {
    let ground = row.ground.map(|ground| Arc::new(ground.scaled(row.scale)));
    let options = Options {
        duration: row.duration,
        ..*options
    };
    let go_on = |_| ControlFlow::Continue(());
    shaken(
        ground,
        row.body,
        &row.start,
        &row.contact_law,
        &options,
        go_on,
    )
    .unwrap()
}

fn many(rows: &[Shaking<'_>], options: &Options, threads: usize) -> Vec<Shaken> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
    let compute = || shake_many(rows, options, |_| ControlFlow::Continue(())).unwrap();
    pool.build().unwrap().install(compute)
}

fn bits(shaken: &[Shaken]) -> Vec<String> {
    shaken.iter().map(|one| format!("{one:?}")).collect()
}

fn column() -> Body {
    Body::new(1000.0, 0.5, 2.0, 1_395.833_333_333_333_3, 125.0).unwrap()
}

prop_compose! {
    fn bodies()(
        radius in 0.1..1.0_f64,
        slenderness in 0.8..5.0_f64,
        transverse in 0.2..0.5_f64,
        axial in 0.3..0.9_f64,
    ) -> Body {
        let height = slenderness * radius;
        // The second term is the flat disk's part, half of the axial inertia: no body has less.
        let transverse = transverse * height * height + 0.5 * axial * radius * radius;
        Body::new(3.0, radius, height, 3.0 * transverse, 3.0 * axial * radius * radius).unwrap()
    }
}

prop_compose! {
    fn starts()(
        stands in prop::bool::weighted(0.2),
        tilt in 0.01..0.15_f64,
        yaw in -3.0..3.0_f64,
        rates in [-0.3..0.3_f64, -0.3..0.3, -0.3..0.3],
    ) -> State {
        if stands {
            return State::standing();
        }
        State { tilt, yaw, tilt_rate: rates[0], yaw_rate: rates[1], spin_rate: rates[2], ..State::default() }
    }
}

fn laws() -> impl Strategy<Value = ContactLaw> {
    prop_oneof![
        Just(ContactLaw::from(IdealLaw::NoSlip)),
        (0.1..0.8_f64).prop_map(|friction| FrictionLaw::from(Coulomb::uniform(friction)).into()),
        Just(ContactLaw::from(IdealLaw::Frictionless)),
    ]
}

proptest! {
    #![proptest_config(cases(6))]

    /// Motions in lanes have the bits of motions alone, whatever is in the other lanes.
    #[test]
    fn lanes_change_no_bit(
        given in prop::collection::vec((bodies(), starts(), laws(), 0_u64..4, 0.3..1.5_f64), 1..40),
    ) {
        let steps = [0.005, 0.01, 0.02, 0.013];
        let grounds: Vec<_> = (0..4).map(|i| Arc::new(record(i, steps[i as usize], 1.5))).collect();
        let mut rows: Vec<_> = given
            .iter()
            .map(|(body, start, contact_law, ground, scale)| Shaking {
                body,
                start: *start,
                contact_law: contact_law.clone(),
                ground: Some(&grounds[*ground as usize]),
                scale: *scale,
                duration: 3.0,
            })
            .collect();
        let options = options(1e-8);
        let one_by_one: Vec<_> = rows.iter().map(|row| alone(row, &options)).collect();
        prop_assert_eq!(bits(&many(&rows, &options, 1)), bits(&one_by_one));
        prop_assert_eq!(bits(&many(&rows, &options, 3)), bits(&one_by_one));
        rows.reverse();
        let mut reversed = many(&rows, &options, 1);
        reversed.reverse();
        prop_assert_eq!(bits(&reversed), bits(&one_by_one));
    }

    /// Both kinds of steps lead to the same motion, within the tolerance.
    #[test]
    fn they_agree_with_the_usual_steps(
        body in bodies(),
        start in starts(),
        law in laws(),
        seed in 0_u64..1000,
        step in 0.005..0.02_f64,
    ) {
        let ground = record(seed, step, 1.5);
        let usual = Arc::new(with_a_pulse_of_no_size(&ground));
        let row = |ground| Shaking {
            body: &body,
            start,
            contact_law: law.clone(),
            ground: Some(ground),
            scale: 1.0,
            duration: 3.0,
        };
        let ground = Arc::new(ground);
        let difference = |rtol: f64| {
            let (a, b) = (alone(&row(&ground), &options(rtol)), alone(&row(&usual), &options(rtol)));
            let tilts = (a.end_tilt - b.end_tilt).abs().max((a.max_tilt - b.max_tilt).abs());
            let places = [0, 1].map(|i| (a.residual_displacement[i] - b.residual_displacement[i]).abs());
            let work = (a.ground_work - b.ground_work).abs() / (3.0 * 9.81 * body.radius());
            (a.status, b.status, tilts.max(places[0]).max(places[1]).max(work))
        };
        let (mine, theirs, loose) = difference(1e-7);
        let (.., tight) = difference(1e-11);
        // A motion that the usual steps alone do not determine at the loose tolerance is not compared.
        let [one, other] = [1e-7, 1e-11].map(|rtol| alone(&row(&usual), &options(rtol)));
        prop_assume!(one.status == other.status && (one.end_tilt - other.end_tilt).abs() < 1e-4);
        prop_assert_eq!(mine, theirs);
        prop_assert!(tight < 1e-6_f64.min(loose + 1e-9), "{} and {}", loose, tight);
    }
}

/// The track of a motion is continuous, its energy balance holds, and its end is that of the outcome.
#[test]
fn the_track_of_such_steps_is_a_motion() {
    let (body, ground) = (column(), Arc::new(record(7, 0.005, 0.9)));
    let start = State {
        tilt: 0.06,
        yaw: 0.4,
        ..State::default()
    };
    let options = options(1e-10);
    let go_on = |_| ControlFlow::Continue(());
    let law = ContactLaw::from(IdealLaw::NoSlip);
    let motion = simulate_on(
        Some(Arc::clone(&ground)),
        &body,
        &start,
        law.clone(),
        &options,
        go_on,
    )
    .unwrap();
    assert_eq!(motion.status, Status::Finished);
    let energy = |t: f64| {
        let at = motion.trajectory.at(t);
        motion.dynamics(&at).energy(&at).total() - at.ground_work
    };
    let (mut before, first) = (motion.trajectory.at(0.0), energy(0.0));
    for i in 1..3000 {
        let t = 1e-3 * f64::from(i);
        let at = motion.trajectory.at(t);
        assert!((at.tilt() - before.tilt()).abs() < 2e-3 && (at.t - t).abs() < 1e-9);
        assert!(
            (energy(t) - first).abs() < 1e-7 * first,
            "{}",
            energy(t) - first
        );
        before = at;
    }
    let row = Shaking {
        body: &body,
        start,
        contact_law: law,
        ground: Some(&ground),
        scale: 1.0,
        duration: 3.0,
    };
    let outcome = alone(&row, &options);
    let end = motion.trajectory.end();
    assert_eq!(
        (outcome.end_tilt, outcome.ground_work),
        (end.tilt(), end.ground_work)
    );
    assert_eq!(outcome.steps, motion.work.steps);
    // Most nodes are samples or halves of the time between two.
    let times = motion
        .trajectory
        .nodes()
        .map(|at| at.t / 0.0025)
        .collect::<Vec<_>>();
    let regular = times.iter().filter(|t| (*t - t.round()).abs() < 1e-9);
    assert!(3 * regular.count() > 2 * times.len());
}

/// Steps that pass an extremum of the tilt find it where the usual steps do.
#[test]
fn no_extremum_of_the_tilt_is_lost() {
    let (body, options) = (column(), options(1e-10));
    let law = ContactLaw::from(IdealLaw::NoSlip);
    let go_on = |_| ControlFlow::Continue(());
    let extrema = |ground: Ground, start: &State| -> Vec<(EventKind, f64, f64, f64)> {
        let ground = Some(Arc::new(ground));
        let motion = simulate_on(ground, &body, start, law.clone(), &options, go_on).unwrap();
        let events = motion.events.iter();
        events
            .filter(|event| matches!(event.kind, EventKind::TiltMax | EventKind::TiltMin))
            .map(|event| (event.kind, event.at.t, event.at.tilt(), event.at.p))
            .collect()
    };
    let mut count = 0;
    for seed in 0..12 {
        let start = State {
            tilt: 0.02 + 0.004 * seed as f64,
            yaw: 0.5 * seed as f64,
            ..State::default()
        };
        let step = [0.005, 0.01, 0.02][seed as usize % 3];
        let ground = record(seed, step, 0.7);
        let usual = extrema(with_a_pulse_of_no_size(&ground), &start);
        let mine = extrema(ground, &start);
        assert_eq!(mine.len(), usual.len(), "seed {seed}");
        for (a, b) in mine.iter().zip(&usual) {
            assert_eq!(a.0, b.0);
            // Where the tilt hardly changes, small errors shift an extremum by much.
            let close = (a.1 - b.1).abs() < 1e-4 && (a.2 - b.2).abs() < 1e-8;
            assert!(close && a.3.abs() < 1e-9, "seed {seed}: {a:?} {b:?}");
        }
        count += mine.len();
    }
    assert!(count > 60, "{count}");
}
