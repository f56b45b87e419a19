//! Random tests are the same in every run.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use crate::common::property;
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::TestRunner;

fn drawn(runner: &mut TestRunner) -> Vec<u64> {
    (0..20).map(|_| any::<u64>().new_tree(runner).unwrap().current()).collect()
}

#[test]
fn two_runs_draw_the_same_cases() {
    let [first, second] = [(); 2].map(|()| drawn(&mut TestRunner::new(property::cases(20))));
    assert_eq!(first, second);
}
