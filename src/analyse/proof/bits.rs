//! The same bits everywhere: digests of one map, made in several ways, to be compared.

use std::num::NonZero;

use super::Promise;
use crate::digest::{COMMITTED, DigestError, digest_of_session};
use crate::map::Map;
use crate::recipe::{Recipe, link};
use crate::relief::Relief;
use crate::session::{Session, SessionError};

/// The promise that a recipe gives the same map everywhere.
pub const BITS: Promise = Promise { name: "same-bits", says: "The same bits", counted: "growths" };

/// The number of threads for a relief that is compared with that of one thread.
const THREADS: NonZero<usize> = NonZero::new(4).unwrap();

/// The digests of one map.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Bits {
    /// The map's [digest](crate::digest::digest), which is the same on every machine.
    pub digest: String,
    /// The digest of the map when it was grown once more.
    pub again: String,
    /// The digest that is committed for this very recipe; `None` for most, which have none.
    pub committed: Option<&'static str>,
    /// `true` if the relief has the same heights on several threads as on one.
    pub relief_is_the_same: bool,
}

impl Bits {
    /// Compares the map of a session, which has its relief, with `again`, the digest of the same recipe and land when they
    /// were grown once more.
    pub(super) fn of(session: &mut Session, map: &Map, again: String) -> Result<Self, DigestError> {
        let digest = digest_of_session(session)?;
        let mut settings = map.relief_settings();
        settings.threads = THREADS;
        let on_threads = Relief::of(map.network(), settings).map_err(SessionError::from)?;
        let relief_is_the_same = map.relief().is_some_and(|relief| **relief == on_threads);
        Ok(Self { digest, again, committed: committed(map.recipe()), relief_is_the_same })
    }

    /// Returns `true` if all ways of making the map gave the same bits, and those that are committed.
    pub fn are_the_same(&self) -> bool {
        let as_committed = self.committed.is_none_or(|committed| committed == self.digest);
        self.digest == self.again && as_committed && self.relief_is_the_same
    }
}

/// Returns the committed digest of a recipe.
fn committed(recipe: &Recipe) -> Option<&'static str> {
    let is_it = |text: &str| link::read(text).is_ok_and(|other| other == *recipe);
    COMMITTED.lines().filter_map(|line| line.split_once(' ')).find(|(_, text)| is_it(text)).map(|(digest, _)| digest)
}
