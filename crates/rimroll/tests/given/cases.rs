//! How many random cases the property tests draw.

use proptest::prelude::ProptestConfig;
use proptest::test_runner::RngSeed;

/// This many random cases by default. `PROPTEST_CASES`, by default 256, multiplies the number by
/// `PROPTEST_CASES`/256. The seed is fixed, so a test that passes keeps passing; no file is written.
pub fn cases(count: u32) -> ProptestConfig {
    const DEFAULT: f64 = 256.0;
    let config = ProptestConfig::default();
    let scaled =
        |number: u32| (f64::from(number) * f64::from(config.cases) / DEFAULT).ceil() as u32;
    ProptestConfig {
        cases: scaled(count),
        max_global_rejects: scaled(config.max_global_rejects),
        rng_seed: RngSeed::Fixed(2007),
        failure_persistence: None,
        ..config
    }
}
