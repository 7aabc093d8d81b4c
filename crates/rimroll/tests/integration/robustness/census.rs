//! A census, run by hand, of any number of motions: how they end, and their largest errors.

use super::examination::{Found, look};
use super::random_cases::{Case, any_case, wild_case};
use crate::given::cases::cases;
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::{RngAlgorithm, TestRng, TestRunner};
use rimroll::Motion;
use rimroll::motion::Instant;
use std::collections::BTreeMap;

/// The case with a given number in a series.
fn numbered(series: u64, number: u64) -> Case {
    let mut seed = [7u8; 32];
    seed[..8].copy_from_slice(&series.to_le_bytes());
    seed[8..16].copy_from_slice(&number.to_le_bytes());
    let rng = TestRng::from_seed(RngAlgorithm::ChaCha, &seed);
    let mut runner = TestRunner::new_with_rng(cases(1), rng);
    let cases = match std::env::var("WILD") {
        Ok(_) => wild_case().boxed(),
        Err(_) => any_case().boxed(),
    };
    cases.new_tree(&mut runner).expect("a case").current()
}

/// The path length of the motion, in radians of yaw, tilt and spin, to judge the number of steps.
fn way(motion: &Motion) -> f64 {
    let nodes: Vec<_> = motion.trajectory.nodes().collect();
    let between = |pair: &[Instant]| {
        let [a, b] = [pair[0], pair[1]];
        (b.yaw - a.yaw).abs() + (b.tilt() - a.tilt()).abs() + (a.s * (b.t - a.t)).abs()
    };
    nodes.windows(2).map(between).sum()
}

/// `SERIES=1 COUNT=10000 cargo test --release --test integration -- --ignored --nocapture census`; `ONLY=17`
/// shows one case in full, `WILD=1` draws extreme bodies.
#[test]
#[ignore = "minutes: a census of many motions"]
fn census() {
    let number = |name: &str| std::env::var(name).ok().and_then(|text| text.parse().ok());
    let (series, count) = (
        number("SERIES").unwrap_or(1),
        number("COUNT").unwrap_or(2000),
    );
    let only: Option<u64> = number("ONLY");
    let mut census = Census::default();
    for i in only.map_or(0..count, |only| only..only + 1) {
        let mut case = numbered(series, i);
        case.options.max_steps = 50_000;
        if only.is_some() {
            println!("{case:#?}");
        }
        match look(&case) {
            Ok((motion, found)) => census.count(i, &case, &motion, &found),
            Err(panic) => println!("#{i} {panic} {case:?}"),
        }
    }
    census.print();
}

#[derive(Default)]
struct Census {
    statuses: BTreeMap<(String, &'static str), usize>,
    steps: Vec<usize>,
    with_violations: usize,
    slow: usize,
    worst: Found,
    /// The largest energy error of motions with a tolerance of 1e-11 or less.
    tight_budget: f64,
}

impl Census {
    fn count(&mut self, i: u64, case: &Case, motion: &Motion, found: &Found) {
        let Motion { status, work, .. } = motion;
        let kind = (format!("{status:?}"), case.contact_law.friction.name());
        *self.statuses.entry(kind).or_insert(0) += 1;
        self.steps.push(work.steps);
        for (worst, new) in [
            (&mut self.worst.budget, found.budget),
            (&mut self.worst.rise, found.rise),
            (&mut self.worst.pull, found.pull),
            (&mut self.worst.cone, found.cone),
            (&mut self.worst.under, found.under),
            (&mut self.worst.joint, found.joint),
        ] {
            *worst = worst.max(new);
        }
        if case.options.rtol <= 1e-11 {
            self.tight_budget = self.tight_budget.max(found.budget);
        }
        let slow = (work.steps + work.rejected) as f64
            > 50.0 * (100.0 + way(motion) + motion.events.len() as f64);
        self.slow += usize::from(slow);
        self.with_violations += usize::from(!found.violations.is_empty());
        if slow || !found.violations.is_empty() {
            println!(
                "#{i} {} {work:?} way {:.0} rtol {:.0e}",
                motion.message(),
                way(motion),
                case.options.rtol
            );
            println!("    {:?} {:?}", found.violations, case.contact_law);
        }
    }

    fn print(mut self) {
        self.steps.sort_unstable();
        let quantile = |q: f64| self.steps[((self.steps.len() - 1) as f64 * q) as usize];
        let quantiles = [0.5, 0.9, 0.99, 0.999, 1.0].map(quantile);
        println!(
            "{} motions, {} with complaints, {} slow",
            self.steps.len(),
            self.with_violations,
            self.slow
        );
        println!("steps: median, 90, 99, 99.9 %, most: {quantiles:?}");
        println!(
            "{:?}, budget at tight tolerances {:e}",
            self.worst, self.tight_budget
        );
        for (kind, count) in &self.statuses {
            println!("{count:6} {kind:?}");
        }
    }
}
