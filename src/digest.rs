//! A digest of everything a recipe decides: what proves that two machines draw the same.

use crate::network::Vertex;
use crate::prune::Pruned;
use crate::recipe::Recipe;
use crate::session::{Session, SessionError};

/// The pixel width of the picture that goes into a digest.
const WIDTH: u32 = 160;

/// Grows and paints a recipe and returns the FNV-1a hash (64 bits) of its tree, its hydrology, its rivers and its pixels, as 16
/// hexadecimal digits.
///
/// # Errors
/// If the memory is not to be had.
pub fn digest(recipe: &Recipe) -> Result<String, SessionError> {
    let mut session = Session::new(recipe.clone(), WIDTH, WIDTH)?;
    while session.advance(u32::MAX)? {}
    session.paint();
    let mut hash = Fnv1a::new();
    let Pruned { tree, hydrology, origin } = session.pruned();
    session.tree().at.iter().for_each(|at| hash.words([at.x.to_bits(), at.y.to_bits()]));
    hash.words(session.tree().parent.iter().copied());
    hash.words(session.tree().drained.iter().copied());
    hash.words(tree.ticks());
    hash.words(origin);
    hash.words(hydrology.depth);
    hash.words(hydrology.order.into_iter().map(u32::from));
    hash.words(hydrology.magnitude);
    hash.words(hydrology.discharge);
    if let Some(network) = session.network() {
        hash.words(network.rivers.iter().flat_map(|river| [river.start, river.end, river.joins, river.parent]));
        let vertices = network.vertices.iter().chain(network.oxbows.iter().flat_map(|oxbow| &oxbow.vertices));
        vertices.for_each(|vertex| {
            let Vertex { at, discharge, left, right, sway } = *vertex;
            hash.words([at.x.to_bits(), at.y.to_bits(), discharge, left.to_bits(), right.to_bits(), sway.to_bits()]);
        });
    }
    hash.bytes(session.pixmap().data());
    Ok(format!("{:016x}", hash.0))
}

struct Fnv1a(u64);

impl Fnv1a {
    fn new() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }

    fn bytes(&mut self, bytes: &[u8]) {
        self.0 = bytes.iter().fold(self.0, |hash, &byte| (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3));
    }

    fn words(&mut self, words: impl IntoIterator<Item = u32>) {
        words.into_iter().for_each(|word| self.bytes(&word.to_le_bytes()));
    }
}
