//! A digest of everything that a recipe determines. It checks that two machines draw and write the same.

use glam::Vec2;
use thiserror::Error;

use crate::base::hash::Fnv1a;
use crate::export::{ExportError, Json, geojson, json, svg};
use crate::map::Map;
use crate::network::Vertex;
use crate::paint::PaintError;
use crate::picture::Picture;
use crate::prune::Pruned;
use crate::recipe::Recipe;
use crate::session::{Session, SessionError};

/// The width and height, in pixels, of the picture that goes into a digest.
pub const WIDTH: u32 = 160;

/// The size of that picture in bytes.
const BYTES: usize = 4 * (WIDTH * WIDTH) as usize;

/// The committed digests that every change is tested against, one a line: a digest, a space and a link.
pub const COMMITTED: &str = concat!(include_str!("../tests/digest.txt"), include_str!("../tests/digest-annotated.txt"));

/// Reasons why there is no digest.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum DigestError {
    /// The recipe cannot be shown.
    #[error(transparent)]
    Session(#[from] SessionError),
    /// The recipe cannot be painted.
    #[error(transparent)]
    Paint(#[from] PaintError),
    /// The recipe's files cannot be written.
    #[error(transparent)]
    Export(#[from] ExportError),
    /// The recipe asks for labels, a cartouche, woods or hills, which this build cannot draw: it lacks the feature
    /// `names`.
    #[error("there is no digest of a map with labels, a cartouche, woods or hills here: this build draws none of them")]
    NoNames,
    /// The picture does not have the size that goes into a digest.
    #[error("a digest takes a picture of {BYTES} bytes, not {bytes}")]
    Picture {
        /// The size that was given.
        bytes: usize,
    },
}

/// Grows, paints and exports a recipe. Returns a 64-bit FNV-1a hash as 16 hexadecimal digits. It covers the tree, its
/// hydrology, the rivers, the pixels, and the contents of the SVG and JSON files; in a style with relief also the
/// heights and the GeoJSON. Names in JSON and GeoJSON count if the map has labels, a cartouche, woods or hills.
///
/// # Errors
/// Fails if there is not enough memory, or if this build cannot draw such a map.
pub fn digest(recipe: &Recipe) -> Result<String, DigestError> {
    refuse_annotation(recipe)?;
    digest_of_session(&mut Session::new(recipe.clone())?)
}

/// Returns the [`digest`] of a session's recipe, on the session's land. Runs what is left to do of the session.
///
/// # Errors
/// Fails if there is not enough memory, or if this build cannot draw such a map.
pub fn digest_of_session(session: &mut Session) -> Result<String, DigestError> {
    let map = session.finish()?;
    let mut picture = Picture::new(WIDTH, WIDTH)?;
    picture.paint(session);
    digest_of(&map, picture.pixmap().data(), &session.growth().scattered())
}

/// Refuses a recipe that this build cannot draw.
fn refuse_annotation(recipe: &Recipe) -> Result<(), DigestError> {
    if recipe.is_annotated() && !cfg!(feature = "names") { Err(DigestError::NoNames) } else { Ok(()) }
}

/// Returns the digest of a map that has been painted elsewhere, from the RGBA bytes of its picture, [`WIDTH`] pixels
/// square, and the attractors that it grew to.
///
/// # Errors
/// Fails if the picture has another size, if there is not enough memory, or if this build cannot draw such a map.
pub fn digest_of(map: &Map, picture: &[u8], attractors: &[Vec2]) -> Result<String, DigestError> {
    refuse_annotation(map.recipe())?;
    if picture.len() != BYTES {
        return Err(DigestError::Picture { bytes: picture.len() });
    }
    let has_names = map.recipe().is_annotated();
    let mut hash = Fnv1a::new();
    hash_rivers(&mut hash, map);
    if let Some(relief) = map.shown_relief() {
        hash.words(relief.heights().iter().map(|height| height.to_bits()));
        // Maps in other styles have no relief yet, and GeoJSON would have to make one.
        let write = if has_names { geojson::collection } else { geojson::unnamed };
        hash.value(&write(map)?);
    }
    hash.bytes(picture);
    hash.bytes(svg::svg(map)?.as_bytes());
    let write = if has_names { json::network } else { json::unnamed };
    hash.value(&write(map, Some(attractors))?);
    Ok(format!("{:016x}", hash.0))
}

fn hash_rivers(hash: &mut Fnv1a, map: &Map) {
    let Pruned { tree, hydrology, origin } = map.pruned();
    map.tree().at.iter().for_each(|at| hash.words([at.x.to_bits(), at.y.to_bits()]));
    hash.words(map.tree().parent.iter().copied());
    hash.words(map.tree().drained.iter().copied());
    hash.words(tree.ticks());
    hash.words(origin);
    hash.words(hydrology.depth);
    hash.words(hydrology.order.into_iter().map(u32::from));
    hash.words(hydrology.magnitude);
    hash.words(hydrology.discharge);
    let network = map.network();
    hash.words(network.rivers.iter().flat_map(|river| [river.start, river.end, river.junction, river.parent]));
    let vertices = network.vertices.iter().chain(network.oxbows.iter().flat_map(|oxbow| &oxbow.vertices));
    vertices.for_each(|vertex| {
        let Vertex { at, discharge, left, right, mobility, .. } = *vertex;
        hash.words([at.x.to_bits(), at.y.to_bits(), discharge, left.to_bits(), right.to_bits(), mobility.to_bits()]);
    });
}

impl Fnv1a {
    /// Hashes a text with its length, so that two different sequences of texts never hash alike.
    fn text(&mut self, text: &str) {
        self.words([7, text.len() as u32]);
        self.bytes(text.as_bytes());
    }

    /// Hashes a file's data before it is written as text. Programs print the shortest decimals of a 32-bit float, and
    /// pages those of a 64-bit float, but the numbers are the same. Each kind of value starts with its own number.
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
