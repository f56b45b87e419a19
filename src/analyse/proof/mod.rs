//! A map that proves itself: the promises that every map keeps, checked on one finished map.
//!
//! Each check reads the finished rivers alone and shares nothing with the code that made them. Tests hold random maps
//! against the same checks; here they answer for the one map that somebody has before them.

mod bits;
mod breach;
mod crossings;
mod falls;
mod joins;
mod sums;
#[cfg(test)]
mod tests;

pub use bits::{BITS, Bits};
pub use breach::{Breach, Fault};
pub use crossings::{CROSSINGS, crossings};
pub use falls::{FALLS, falls};
pub use joins::{JOINS, joins};
pub use sums::{SUMS, sums};

use crate::digest::DigestError;
use crate::map::Map;
use crate::session::{Session, SessionError};

/// A promise that every map keeps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Promise {
    /// Its name in JSON.
    pub name: &'static str,
    /// The promise, such as `Nothing crosses`.
    pub says: &'static str,
    /// What its check looks at and counts, in the plural.
    pub counted: &'static str,
}

/// What the check of one promise has found.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Finding {
    /// The promise.
    pub promise: Promise,
    /// The number of things looked at, which [`Promise::counted`] names; 0 on a map that has none, which keeps the
    /// promise.
    pub looked_at: usize,
    /// The places where it is broken, river by river; empty if it is kept.
    pub breaches: Vec<Breach>,
}

/// What was found of all promises on one map.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Proof {
    /// The promises of rivers: that none climbs or crosses, that each arrives, and that what they carry adds up.
    pub findings: [Finding; 4],
    /// The promise that the map is the same everywhere.
    pub bits: Bits,
}

impl Proof {
    /// Checks the map of a session against all promises, running what is left to do. `again` is the digest of the same
    /// recipe and land, grown once more: [`digest_of_session`](crate::digest::digest_of_session), here or elsewhere.
    ///
    /// # Errors
    /// Fails if there is not enough memory, or if this build cannot draw such a map.
    pub fn of(session: &mut Session, again: String) -> Result<Self, DigestError> {
        let map = session.finish()?.with_relief().map_err(SessionError::from)?;
        Ok(Self { findings: findings(&map)?, bits: Bits::of(session, &map, again)? })
    }

    /// Counts the promises that are broken.
    pub fn broken(&self) -> usize {
        let of_rivers = self.findings.iter().filter(|finding| !finding.breaches.is_empty()).count();
        of_rivers + usize::from(!self.bits.are_the_same())
    }
}

/// Checks the promises of a map's rivers. Makes the relief if the map has none yet.
///
/// # Errors
/// Fails if there is not enough memory for the relief.
pub fn findings(map: &Map) -> Result<[Finding; 4], SessionError> {
    let network = map.network();
    let relief = map.make_relief()?;
    Ok([falls(network, &relief), crossings(network), joins(map), sums(network)])
}
