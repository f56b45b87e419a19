//! Random tests are the same in every run.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

#[path = "common/property.rs"]
mod property;

use std::fs;
use std::path::{Path, PathBuf};

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

fn rust_files(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let files = entries.flat_map(|path| if path.is_dir() { rust_files(&path) } else { vec![path] });
    files.filter(|path| path.extension().is_some_and(|extension| extension == "rs")).collect()
}

#[test]
fn every_property_draws_from_the_fixed_seed() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut properties = 0;
    for path in ["src", "tests"].iter().flat_map(|folder| rust_files(&root.join(folder))) {
        let text = fs::read_to_string(&path).unwrap();
        let mut lines = text.lines().map(str::trim);
        while lines.any(|line| line == "proptest! {") {
            let next = lines.next().unwrap_or_default();
            let is_fixed = ["cases", "large"].iter().any(|how| next.starts_with(&format!("#![proptest_config({how}(")));
            assert!(is_fixed, "{}: no proptest_config(cases(…)) or large(…) after {:?}", path.display(), "proptest! {");
            properties += 1;
        }
    }
    assert!(properties > 20, "{properties} blocks of properties were found: the test looks in the wrong place");
}
