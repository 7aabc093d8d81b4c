//! The cost of one motion: the paper's can over two seconds, with its events and dense output.
//!
//! `cargo bench --bench motion` prints the best time of many runs, and the error of the turns against a
//! motion at the tightest tolerance.

use rimroll::law::Coulomb;
use rimroll::{ContactLaw, FrictionLaw, IdealLaw, Motion, Options, State, presets, simulate};
use std::hint::black_box;
use std::ops::ControlFlow;
use std::time::{Duration, Instant};

fn motion(contact_law: ContactLaw, rtol: f64) -> Motion {
    let can = presets::can_2007().expect("the paper's can");
    let start = State {
        tilt: core::f64::consts::FRAC_PI_6,
        tilt_rate: -0.5,
        yaw_rate: 0.005,
        spin_rate: 0.005,
        ..State::default()
    };
    let options = Options {
        gravity: 9.8,
        rtol,
        ..Options::default()
    };
    simulate(&can, &start, contact_law, &options, |_| {
        ControlFlow::Continue(())
    })
    .expect("a valid start")
}

fn main() {
    let contact_laws = [
        ("no slip", ContactLaw::from(IdealLaw::NoSlip)),
        ("frictionless", ContactLaw::from(IdealLaw::Frictionless)),
        (
            "friction 0.2",
            ContactLaw::from(FrictionLaw::Coulomb(Coulomb {
                friction: 0.2,
                static_friction: 0.2,
            })),
        ),
    ];
    println!("law           rtol     time/ms   steps  evaluations  error of the turns/rad");
    for (name, contact_law) in contact_laws {
        let turns = |motion: &Motion| {
            motion
                .turns
                .iter()
                .map(|turn| turn.angle)
                .collect::<Vec<_>>()
        };
        let exact = turns(&motion(contact_law.clone(), 1e-13));
        for rtol in [1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-12] {
            let last = motion(contact_law.clone(), rtol);
            let errors = turns(&last)
                .into_iter()
                .zip(&exact)
                .map(|(a, b)| (a - b).abs());
            let error = errors.fold(0.0, f64::max);
            let mut best = Duration::MAX;
            let begun = Instant::now();
            while begun.elapsed() < Duration::from_millis(150) {
                let before = Instant::now();
                black_box(motion(contact_law.clone(), black_box(rtol)));
                best = best.min(before.elapsed());
            }
            println!(
                "{name:13} {rtol:.0e}  {:9.4}  {:6}  {:11}  {error:.1e}",
                best.as_secs_f64() * 1e3,
                last.work.steps,
                last.work.evaluations,
            );
        }
    }
}
