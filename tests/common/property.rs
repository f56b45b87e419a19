//! The seed and the number of a property's cases. They are the same in every run, so that a passing test passes until
//! somebody breaks it.
//!
//! With `PROPTEST_RNG_SEED`, cases are drawn from that seed, and large properties try all of theirs: `make explore`
//! does so with fresh seeds.
#![allow(dead_code, reason = "each test file uses its own part")]

use proptest::test_runner::{Config, RngSeed};

/// Drawn once, at random.
pub const SEED: u64 = 11_400_714_819_323_198_485;

/// A configuration with this number of cases.
pub fn cases(count: u32) -> Config {
    // A seed from the environment replaces this one.
    Config { cases: count, rng_seed: RngSeed::Fixed(SEED), ..Config::default() }
}

/// A configuration with this number of cases when exploring, otherwise a twentieth of them: for properties whose cases
/// take long.
pub fn large(count: u32) -> Config {
    cases(if is_exploring() { count } else { count.div_ceil(20) })
}

/// Returns `true` where a seed is given, to try what no test has tried.
pub fn is_exploring() -> bool {
    std::env::var_os("PROPTEST_RNG_SEED").is_some()
}
