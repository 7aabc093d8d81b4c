//! What a fall costs in an ensemble, and how exact it is: microseconds a turn on one thread, for one body and for a
//! body in each row, and the errors against falls followed at a far tighter tolerance. The time of the thread is
//! Linux's.

#[path = "timing/bodies.rs"]
mod bodies;
#[path = "timing/thread_time.rs"]
mod thread_time;

use bodies::all_but_equal;
use rimroll::motion::{Fall, fall};
use rimroll::{ContactLaw, FrictionLaw, IdealLaw, Options, Setup, State, ensemble, presets};
use thread_time::timed;

/// How often everything is computed.
const RUNS: usize = 6;

fn starts(n: usize) -> Vec<State> {
    let mut seed = 1u64;
    let mut random = move || {
        seed = seed
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        (seed >> 11) as f64 / (1u64 << 53) as f64
    };
    (0..n)
        .map(|_| {
            let log = |x: f64| libm::pow(10.0, -5.0 + 4.0 * x);
            State {
                tilt: 0.3 + 0.3 * random(),
                tilt_rate: -random(),
                yaw_rate: log(random()),
                spin_rate: log(random()),
                ..State::default()
            }
        })
        .collect()
}

fn main() {
    let can = presets::can_2007().expect("a can");
    let n: usize = std::env::args()
        .nth(1)
        .and_then(|s| s.parse().ok())
        .unwrap_or(20000);
    let laws: [(&str, ContactLaw); 3] = [
        ("no_slip", IdealLaw::NoSlip.into()),
        ("frictionless", IdealLaw::Frictionless.into()),
        ("coulomb", FrictionLaw::coulomb(0.2).into()),
    ];
    let only = std::env::args().nth(2);
    for (name, contact_law) in laws {
        if only.as_ref().is_some_and(|o| o != name) {
            continue;
        }
        for rtol in [1e-6, 1e-8, 1e-9] {
            let options = Options {
                rtol,
                gravity: 9.8,
                duration: 10.0,
                ..Options::default()
            };
            let setups: Vec<_> = starts(n)
                .into_iter()
                .map(|s| (&can, s, contact_law.clone()))
                .collect();
            let pool = rayon::ThreadPoolBuilder::new()
                .num_threads(1)
                .build()
                .expect("a thread");
            let follow = |setups: &[Setup<'_>]| {
                let watch = |_| core::ops::ControlFlow::Continue(());
                ensemble(setups, &options, watch).expect("valid")
            };
            let (falls, us) = pool.install(|| timed(n, RUNS, || follow(&setups)));
            let bodies = all_but_equal(&can, n);
            let mixed: Vec<_> = (bodies.iter().zip(&setups))
                .map(|(body, (_, start, contact_law))| (body, *start, contact_law.clone()))
                .collect();
            let (_, us_mixed) = pool.install(|| timed(n, RUNS, || follow(&mixed)));
            let few = 300;
            let tight = Options {
                rtol: 1e-13,
                ..options
            };
            let exact: Vec<Fall> = setups[..few]
                .iter()
                .map(|(_, s, f)| fall(&can, s, f, &tight).expect("valid"))
                .collect();
            let alone = || -> Vec<Fall> {
                let one = |(_, s, f): &Setup<'_>| fall(&can, s, f, &options).expect("valid");
                setups[..few].iter().map(one).collect()
            };
            let (scalar, us1) = timed(few, 1, alone);
            let errors = |found: &[Fall]| {
                let mut e: Vec<f64> = found
                    .iter()
                    .zip(&exact)
                    .map(|(a, b)| match (a.turn, b.turn) {
                        (Some(x), Some(y)) if a.status == b.status => (x.angle - y.angle).abs(),
                        (None, None) if a.status == b.status => 0.0,
                        _ => 9.0,
                    })
                    .collect();
                e.sort_by(f64::total_cmp);
                let rms = (e.iter().map(|x| x * x).sum::<f64>() / e.len() as f64).sqrt();
                format!("{:.1e} {rms:.1e} {:.1e}", e[e.len() / 2], e[e.len() - 1])
            };
            let steps: usize = falls.iter().map(|f| f.steps).sum();
            println!(
                "{name:13} rtol {rtol:.0e}: {us:6.2} us a turn, {us_mixed:6.2} with a body a row, {:.1} steps; error (median, rms, max) {}   alone {us1:.0} us, {}",
                steps as f64 / n as f64,
                errors(&falls),
                errors(&scalar)
            );
        }
    }
}
