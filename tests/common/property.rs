//! From which seed a property's cases are drawn, and how many: the same in every run, so that a test that passes goes on
//! passing until somebody breaks it.
//!
//! With a seed in `PROPTEST_RNG_SEED` cases are drawn from that one, and large properties try all of theirs: `make explore`
//! does so with fresh seeds.
#![allow(dead_code, reason = "each test file uses its own part")]

use proptest::test_runner::{Config, RngSeed};

/// Drawn once, by chance.
const SEED: u64 = 11_400_714_819_323_198_485;

/// So many cases.
pub fn cases(count: u32) -> Config {
    // proptest puts a seed from the environment in the place of this one.
    Config { cases: count, rng_seed: RngSeed::Fixed(SEED), ..Config::default() }
}

/// So many cases when exploring, else a twentieth of them: for properties whose cases take long.
pub fn large(count: u32) -> Config {
    let is_exploring = std::env::var_os("PROPTEST_RNG_SEED").is_some();
    cases(if is_exploring { count } else { count.div_ceil(20) })
}
