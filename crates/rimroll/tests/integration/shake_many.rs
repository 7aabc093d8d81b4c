//! Many motions on tables that move, of which only the ends and the extremes are kept.

use rimroll::ground::{Ground, Pulse, Shape};
use rimroll::law::Coulomb;
use rimroll::motion::{EventKind, FlatLanding, Shaken};
use rimroll::{
    Body, ContactLaw, FrictionLaw, IdealLaw, InvalidInput, Motion, Options, Shaking, State, Status,
    shake_many, simulate_on,
};
use std::ops::ControlFlow;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

fn column() -> Body {
    Body::new(1000.0, 0.5, 2.0, 1_395.833_333_333_333_3, 125.0).unwrap()
}

fn options() -> Options {
    Options {
        gravity: 9.81,
        rtol: 1e-9,
        flat: FlatLanding::Housner,
        ..Options::default()
    }
}

fn sine(amplitude: [f64; 3], period: f64) -> Pulse {
    Pulse {
        amplitude,
        shape: Shape::Sine { period },
        duration: period,
    }
}

fn grounds() -> [Arc<Ground>; 3] {
    let record = |i: usize| {
        let t = i as f64;
        [3.5 * libm::sin(0.3 * t), 2.5 * libm::cos(0.21 * t), 0.5]
    };
    [
        Ground::pulses(vec![sine([3.0, 1.5, 2.0], 1.2)]),
        Ground::pulses(vec![sine([4.0, 0.0, 0.0], 1.0)]),
        Ground::sampled(0.05, (0..40).map(record).collect()),
    ]
    .map(|ground| Arc::new(ground.unwrap()))
}

fn laws() -> [ContactLaw; 3] {
    let coulomb = FrictionLaw::from(Coulomb::uniform(0.15));
    [
        IdealLaw::NoSlip.into(),
        IdealLaw::Frictionless.into(),
        coulomb.into(),
    ]
}

/// Rows that roll, slide, stand, rock and overturn.
fn rows<'a>(body: &'a Body, grounds: &'a [Arc<Ground>]) -> Vec<Shaking<'a>> {
    let leaning = State {
        tilt: 0.03,
        yaw: 0.3,
        ..State::default()
    };
    let mut rows = Vec::new();
    for ground in grounds {
        for contact_law in laws() {
            for start in [State::standing(), leaning] {
                for scale in [0.3, 1.0, 1.7] {
                    rows.push(Shaking {
                        body,
                        start,
                        contact_law: contact_law.clone(),
                        ground: Some(ground),
                        scale,
                        duration: 4.0,
                    });
                }
            }
        }
    }
    rows
}

fn on_threads(rows: &[Shaking<'_>], threads: usize) -> Vec<Shaken> {
    watched_on_threads(rows, threads, |_| ControlFlow::Continue(()))
}

fn watched_on_threads(
    rows: &[Shaking<'_>],
    threads: usize,
    watch: impl Fn(usize) -> ControlFlow<()> + Sync + Send,
) -> Vec<Shaken> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
    let shaken = || shake_many(rows, &options(), watch).unwrap();
    pool.build().unwrap().install(shaken)
}

fn motion(row: &Shaking<'_>) -> Motion {
    let ground = row.ground.map(|ground| Arc::new(ground.scaled(row.scale)));
    let options = Options {
        duration: row.duration,
        ..options()
    };
    let watch = |_| ControlFlow::Continue(());
    let law = row.contact_law.clone();
    simulate_on(ground, row.body, &row.start, law, &options, watch).unwrap()
}

#[test]
fn the_results_do_not_depend_on_threads_or_order() {
    let (body, grounds) = (column(), grounds());
    let mut rows = rows(&body, &grounds);
    let bits = |all: &[Shaken]| format!("{all:?}");
    let alone = on_threads(&rows, 1);
    assert_eq!(bits(&alone), bits(&on_threads(&rows, 2)));
    assert_eq!(bits(&alone), bits(&on_threads(&rows, 5)));
    rows.reverse();
    let mut reversed = on_threads(&rows, 2);
    reversed.reverse();
    assert_eq!(bits(&alone), bits(&reversed));
}

#[test]
fn each_row_is_what_the_whole_motion_gives() {
    let (body, grounds) = (column(), grounds());
    let rows = rows(&body, &grounds);
    let (mut overturned, mut uplifted, mut slid) = (0, 0, 0);
    for (row, shaken) in rows.iter().zip(on_threads(&rows, 2)) {
        let motion = motion(row);
        let first = |kind| motion.events.iter().find(|event| event.kind == kind);
        let time_of = |kind| first(kind).map(|event| event.at.t);
        assert_eq!(shaken.status, motion.status);
        assert_eq!(shaken.steps, motion.work.steps);
        let balance_tilt = libm::atan2(0.5, 2.0);
        let lifted_off = motion.status == Status::LiftedOff && shaken.end_tilt > balance_tilt;
        assert_eq!(
            shaken.overturning_time,
            time_of(EventKind::Topple).or_else(|| lifted_off.then_some(shaken.end_time))
        );
        assert_eq!(shaken.uplift_time, time_of(EventKind::Uplift));
        assert_eq!(shaken.undecided, motion.is_undecided());
        assert_eq!(shaken.stands, motion.stands());
        // Dense output at samples inside the steps never exceeds the largest tilt by more than its error.
        let samples = motion.trajectory.samples(16);
        let tilts = samples.iter().map(|at| at.tilt());
        let sampled = tilts.fold(0.0, f64::max);
        let excess = sampled - shaken.max_tilt;
        assert!((-1e-3 * sampled..=1e-6).contains(&excess), "{excess}");
        let end =
            first(EventKind::Topple).map_or_else(|| motion.trajectory.end(), |event| event.at);
        assert_eq!(
            (shaken.end_time, shaken.end_tilt, shaken.ground_work),
            (end.t, end.tilt(), end.ground_work)
        );
        overturned += usize::from(shaken.overturning_time.is_some());
        uplifted += usize::from(shaken.uplift_time.is_some());
        slid += usize::from(shaken.friction_loss > 0.0);
    }
    assert!(
        overturned > 3 && overturned < rows.len() - 3,
        "{overturned}"
    );
    assert!(uplifted > 3 && slid > 3, "{uplifted} {slid}");
}

#[test]
fn a_footprint_that_slides_flat_is_displaced_as_its_centre_of_mass() {
    let (body, law) = (column(), laws()[2].clone());
    // Friction 0.15 moves a body that slides flat by less than the table moves under it.
    let ground = Arc::new(Ground::pulses(vec![sine([2.2, 1.1, 0.0], 0.8)]).unwrap());
    let row = Shaking {
        body: &body,
        start: State::standing(),
        contact_law: law,
        ground: Some(&ground),
        scale: 1.0,
        duration: 3.0,
    };
    let [shaken] = on_threads(std::slice::from_ref(&row), 1)[..] else {
        panic!("one row")
    };
    let end = motion(&row).trajectory.end();
    let [x, y] = end.center();
    let [dx, dy] = shaken.residual_displacement;
    assert!(shaken.max_tilt == 0.0 && shaken.friction_loss > 0.0 && dx.abs() > 1e-4);
    assert!((shaken.friction_loss - shaken.ground_work).abs() < 1e-6 * shaken.friction_loss);
    assert!((dx - x).abs() + (dy - y).abs() < 1e-12);
    assert_eq!(shaken.residual_yaw, 0.0);
}

/// The least durations of rectangular pulses that overturn bodies, from a quadrature in 40 digits.
#[test]
fn the_least_duration_of_a_rectangular_pulse_is_found_back() {
    const EXACT: f64 = 0.580_520_881_038_643;
    let body = column();
    let amplitude = 1.5 * 9.81 * 0.25;
    let pulse = |duration| {
        let pulse = Pulse {
            amplitude: [amplitude, 0.0, 0.0],
            shape: Shape::Constant,
            duration,
        };
        Arc::new(Ground::pulses(vec![pulse]).unwrap())
    };
    let grounds = [1.0 - 1e-7, 1.0 + 1e-7].map(|factor| pulse(factor * EXACT));
    let row = |ground| Shaking {
        body: &body,
        start: State::standing(),
        contact_law: IdealLaw::NoSlip.into(),
        ground: Some(ground),
        scale: 1.0,
        duration: 20.0,
    };
    let rows: Vec<_> = grounds.iter().map(row).collect();
    let shaken = on_threads(&rows, 2);
    let overturned: Vec<_> = shaken
        .iter()
        .map(|s| s.overturning_time.is_some())
        .collect();
    assert_eq!(overturned, [false, true]);
}

#[test]
fn the_watch_counts_and_stops() {
    let (body, grounds) = (column(), grounds());
    let rows = rows(&body, &grounds);
    let done = AtomicUsize::new(0);
    let counted = shake_many(&rows, &options(), |count| {
        done.fetch_add(count, Relaxed);
        ControlFlow::Continue(())
    });
    assert_eq!(counted.unwrap().len(), rows.len());
    assert_eq!(done.into_inner(), rows.len());
    let whole = format!("{:?}", on_threads(&rows, 1));
    for threads in [1, 2, 5] {
        let some = AtomicUsize::new(0);
        let stopped = watched_on_threads(&rows, threads, |count| {
            if some.fetch_add(count, Relaxed) + count < 5 {
                ControlFlow::Continue(())
            } else {
                ControlFlow::Break(())
            }
        });
        // Other threads can finish their chunks before they see the break, so only one thread leaves a known rest.
        if threads == 1 {
            assert!((5..rows.len()).contains(&stopped.len()));
        }
        let begin = format!("{stopped:?}");
        assert!(whole.starts_with(&begin[..begin.len() - 1]));
    }
}

#[test]
fn the_first_invalid_row_is_refused() {
    let (body, grounds) = (column(), grounds());
    let mut rows = rows(&body, &grounds);
    rows[3].start.tilt = 2.0;
    rows[7].duration = -1.0;
    let refused = shake_many(&rows, &options(), |_| ControlFlow::Continue(()));
    assert!(matches!(
        refused,
        Err(InvalidInput::OutOfBounds { field: "tilt", .. })
    ));
    assert_eq!(rimroll::shaking::first_refused(&rows, &options()), Some(3));
    let nothing = shake_many(&[], &options(), |_| ControlFlow::Continue(()));
    assert!(nothing.unwrap().is_empty());
}
