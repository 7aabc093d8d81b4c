//! How many random cases the property tests draw.

use proptest::prelude::ProptestConfig;
use proptest::test_runner::RngSeed;

/// This many random cases, times `RIMROLL_CASES` if that is set. (`PROPTEST_CASES` would give every test the same
/// number.) The seed is fixed, so a test that passes keeps passing; no file is written.
pub fn cases(count: u32) -> ProptestConfig {
    let times = std::env::var("RIMROLL_CASES").map_or(1, |times| {
        times.parse().expect("RIMROLL_CASES is a whole number")
    });
    let config = ProptestConfig::default();
    ProptestConfig {
        cases: times * count,
        max_global_rejects: times * config.max_global_rejects,
        rng_seed: RngSeed::Fixed(2007),
        failure_persistence: None,
        ..config
    }
}
