//! What an exact turn costs: microseconds on one thread, of starts that rock, of a flick that topples and of
//! throws of all kinds, with what becomes of them; for one body, and for a body in each row. The time of the thread is Linux's.

#[path = "timing/bodies.rs"]
mod bodies;
#[path = "timing/thread_time.rs"]
mod thread_time;

use bodies::all_but_equal;
use rimroll::motion::Outcome;
use rimroll::turn::exact::{Exact, ExactRows};
use rimroll::{IdealLaw, State, presets};
use thread_time::timed;

/// Numbers between 0 and 1 without a pattern.
fn random(seed: &mut u64) -> f64 {
    *seed = seed
        .wrapping_mul(6_364_136_223_846_793_005)
        .wrapping_add(1_442_695_040_888_963_407);
    (*seed >> 11) as f64 / (1u64 << 53) as f64
}

fn starts(kind: &str, n: usize) -> Vec<State> {
    let mut seed = 1;
    let mut between = |low: f64, high: f64| low + (high - low) * random(&mut seed);
    (0..n)
        .map(|_| {
            let [tilt, tilt_rate, yaw_rate, spin_rate] = match kind {
                "rocking" => {
                    let mut tiny = || libm::pow(10.0, between(-5.0, -1.0));
                    let (yaw, spin) = (tiny(), tiny());
                    [between(0.3, 0.6), -between(0.0, 0.5), yaw, spin]
                }
                "flick" => [0.318_26, -4.0, between(-1.0, 1.0), between(-1.0, 1.0)],
                "thrown" => [
                    between(0.1, 1.2),
                    between(-5.0, 5.0),
                    between(-1.0, 1.0),
                    between(-1.0, 1.0),
                ],
                other => panic!("no kind {other}"),
            };
            State {
                tilt,
                tilt_rate,
                yaw_rate,
                spin_rate,
                ..State::default()
            }
        })
        .collect()
}

fn main() {
    let given: Vec<String> = std::env::args().skip(1).collect();
    let number = |i: usize, default| {
        given
            .get(i)
            .map_or(default, |s| s.parse().expect("a number"))
    };
    let (n, runs) = (number(0, 1 << 18), number(1, 5));
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build();
    let pool = pool.expect("a thread");
    let can = presets::can_2007().expect("a can");
    for kind in ["rocking", "flick", "thrown"] {
        if given.get(2).is_some_and(|only| only != kind) {
            continue;
        }
        for law in [IdealLaw::NoSlip, IdealLaw::Frictionless] {
            if given.get(3).is_some_and(|only| only != law.name()) {
                continue;
            }
            let exact = Exact::new(&can, law, 9.8, None).expect("valid");
            let starts = starts(kind, n);
            let of_one = || exact.turns(&starts).expect("valid");
            let (turns, cost) = pool.install(|| timed(n, runs, of_one));
            let bodies = all_but_equal(&can, n.min(1 << 11));
            let rows: Vec<_> = bodies.iter().zip(starts.iter().copied()).collect();
            let of_each = || {
                let exact = ExactRows::new(law, 9.8, None, &rows);
                exact.turns_while(|| true).expect("valid")
            };
            let (_, cost_of_each) = pool.install(|| timed(rows.len(), runs, of_each));
            print!(
                "{kind:8} {:13} {cost:7.3} us, {cost_of_each:7.3} us with a body a row ",
                law.name()
            );
            for ending in Outcome::ALL {
                let count = turns.iter().filter(|turn| turn.ending == ending).count();
                if count > 0 {
                    print!(" {} {:.1}%", ending.name(), 100.0 * count as f64 / n as f64);
                }
            }
            println!();
        }
    }
}
