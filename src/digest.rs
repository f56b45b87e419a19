//! A digest of everything a recipe decides, to check that two machines draw and write the same.

use thiserror::Error;

use crate::export::{ExportError, Json, geojson, json, svg};
use crate::network::Vertex;
use crate::paint::PaintError;
use crate::picture::Picture;
use crate::prune::Pruned;
use crate::recipe::Recipe;
use crate::session::{Session, SessionError};

/// The pixel width of the picture that goes into a digest.
const WIDTH: u32 = 160;

/// The committed digests that every change is tested against, one a line: a digest, a space and a link.
pub const COMMITTED: &str = include_str!("../tests/digest.txt");

/// Why there is no digest.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum DigestError {
    /// The recipe cannot be shown.
    #[error(transparent)]
    Session(#[from] SessionError),
    /// It cannot be painted.
    #[error(transparent)]
    Paint(#[from] PaintError),
    /// Its files cannot be written.
    #[error(transparent)]
    Export(#[from] ExportError),
}

/// Grows, paints and exports a recipe and returns the FNV-1a hash (64 bits) of its tree, its hydrology, its rivers, its
/// pixels, the text of its SVG and all that its JSON holds but names, and in a style with relief, of that and all that its GeoJSON holds but
/// names, as 16 hexadecimal digits.
///
/// # Errors
/// If there is not enough memory.
pub fn digest(recipe: &Recipe) -> Result<String, DigestError> {
    let mut session = Session::new(recipe.clone())?;
    while session.advance(u32::MAX)? {}
    let mut picture = Picture::new(WIDTH, WIDTH)?;
    picture.paint(&session);
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
        hash.words(network.rivers.iter().flat_map(|river| [river.start, river.end, river.junction, river.parent]));
        let vertices = network.vertices.iter().chain(network.oxbows.iter().flat_map(|oxbow| &oxbow.vertices));
        vertices.for_each(|vertex| {
            let Vertex { at, discharge, left, right, mobility, .. } = *vertex;
            hash.words([
                at.x.to_bits(),
                at.y.to_bits(),
                discharge,
                left.to_bits(),
                right.to_bits(),
                mobility.to_bits(),
            ]);
        });
    }
    if let Some(relief) = session.relief() {
        hash.words(relief.heights().iter().map(|height| height.to_bits()));
        // Of other maps a relief would have to be made for it.
        hash.value(&geojson::unnamed(&session)?);
    }
    hash.bytes(picture.pixmap().data());
    hash.bytes(svg::svg(&session)?.as_bytes());
    hash.value(&json::unnamed(&session, true)?);
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

    /// A text, with its length, so that no two texts in a row are another two.
    fn text(&mut self, text: &str) {
        self.words([7, text.len() as u32]);
        self.bytes(text.as_bytes());
    }

    /// What a file holds, before it is written: programs write a number's shortest decimals as a float of 32 bits, pages as one of
    /// 64, but both write the same numbers. Each kind of value begins with a number of its own.
    fn value(&mut self, value: &Json) {
        match value {
            Json::Null => self.words([0]),
            Json::Truth(truth) => self.words([1, u32::from(*truth)]),
            Json::Whole(number) => {
                self.words([2]);
                self.bytes(&number.to_le_bytes());
            }
            Json::Single(number) => self.words([3, number.to_bits()]),
            Json::Double(number) => {
                self.words([4]);
                self.bytes(&number.to_le_bytes());
            }
            Json::Text(text) => self.text(text),
            Json::Owned(text) => self.text(text),
            Json::Object(members) => {
                self.words([5, members.len() as u32]);
                members.iter().for_each(|(name, value)| {
                    self.text(name);
                    self.value(value);
                });
            }
            Json::List(count, item) => {
                self.words([6, *count as u32]);
                (0..*count).for_each(|i| self.value(&item(i)));
            }
        }
    }
}
