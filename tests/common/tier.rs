//! The two tiers of a test: few of its cases in the first, all others in the second.

use std::cell::Cell;

use super::property::{SEED, is_exploring};
use proptest::test_runner::{Config, RngSeed};

#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Tier {
    First,
    Second,
}

thread_local! {
    static HERE: Cell<Option<Tier>> = const { Cell::new(None) };
}

impl Tier {
    /// The tier of the test that runs here.
    pub fn here() -> Self {
        HERE.get().expect("`tiers!` makes tests of a function that has cases of two tiers")
    }

    /// Tries the cases of this tier.
    pub fn run(self, test: fn()) {
        HERE.set(Some(self));
        test();
        HERE.set(None);
    }
}

/// One case in so many in the first tier, beginning with the first one, and all others in the second.
pub fn one_in<T>(stride: usize, all: impl IntoIterator<Item = T>) -> impl Iterator<Item = T> {
    let tier = Tier::here();
    let is_here = move |i: usize| i.is_multiple_of(stride) == (tier == Tier::First);
    all.into_iter().enumerate().filter(move |(i, _)| is_here(*i)).map(|(_, case)| case)
}

/// The first so many cases of a configuration in the first tier; in the second as many others as are left, and those
/// that are kept in files. All of them when exploring.
pub fn first(few: u32, all: Config) -> Config {
    match Tier::here() {
        _ if is_exploring() => all,
        Tier::First => Config { cases: few, failure_persistence: None, ..all },
        Tier::Second => Config { cases: all.cases - few, rng_seed: RngSeed::Fixed(SEED + 1), ..all },
    }
}

/// All pairs of two kinds, as cases to choose from.
pub fn pairs<A: Clone, B>(
    first: impl IntoIterator<Item = A>,
    second: impl IntoIterator<Item = B> + Clone,
) -> impl Iterator<Item = (A, B)> {
    first.into_iter().flat_map(move |a| second.clone().into_iter().map(move |b| (a.clone(), b)))
}

/// Makes a test of each tier of functions without arguments, properties among them, whose cases `one_in`, `first` or
/// `Tier::here` chooses.
macro_rules! tiers {
    ($($name:ident),+ $(,)?) => { $(
        mod $name {
            use crate::common::tier::Tier;

            #[test]
            fn first_tier() {
                Tier::First.run(super::$name);
            }

            #[test]
            #[ignore = "second tier"]
            fn second_tier() {
                Tier::Second.run(super::$name);
            }
        }
    )+ };
}
pub(crate) use tiers;
