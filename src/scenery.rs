//! The woods and hills of a session's map, and what they are placed by.

use crate::chart::{Box, Heights, Label, Scenery, SceneryInput, Standing, Stream};
use crate::labels::{ridges, total_discharge};
use crate::memory;
use crate::network::{Network, Oxbow, PastCourses, Place};
use crate::random::Seed;
use crate::recipe::{Key, Style};
use crate::relief::Relief;
use crate::session::{Phase, Session};

/// The scenery of a map with these labels, what is behind first; none if the recipe wants none, or the style shows none.
#[cfg(feature = "files")]
pub(crate) fn scenery(session: &Session, labels: &[Label]) -> Vec<Standing> {
    input(session, labels).map_or_else(Vec::new, |input| Scenery::whole(&input))
}

/// What it is placed by. None if there is to be none, if rivers are not finished, or their relief, or if there is not enough memory.
pub fn input<'a>(session: &'a Session, labels: &[Label]) -> Option<SceneryInput<'a>> {
    /// Two lists of a course's pieces, their numbers in squares, and its places.
    const BYTES_A_VERTEX: usize = 90;
    let (recipe, land) = (session.recipe(), session.land());
    let style: Style = recipe.get();
    let wanted = |key: Key, is_shown: bool| if is_shown { recipe.number(key) } else { 0.0 };
    let (woods, hills) = (wanted(Key::Woods, style.has_woods()), wanted(Key::Hills, style.has_hills()));
    let network = session.network().filter(|_| session.phase() == Phase::Finished && (woods > 0.0 || hills > 0.0))?;
    if !memory::can_allocate(Scenery::BYTES + network.vertices.len() * BYTES_A_VERTEX) {
        return None;
    }
    Some(SceneryInput {
        size: session.domain().size,
        seed: Seed::from_text(recipe.seed()),
        woods,
        hills,
        total_discharge: total_discharge(network),
        streams: streams(network),
        lakes: lakes(session, network),
        ridges: land.map_or_else(Vec::new, |land| ridges(land)),
        coast: land.map(|land| land.coast_distance()),
        heights: session.relief().filter(|_| style.has_relief()).map(|relief| heights(relief)),
        letters: boxes(labels),
    })
}

fn streams(network: &Network) -> Vec<Stream> {
    let stream = |river: &crate::River| Stream {
        course: network.middle(river),
        discharge: network.discharge(river),
        parent: river.parent,
    };
    network.rivers.iter().map(stream).collect()
}

/// Lakes that rivers have left, and the beds in which they ran before, if the style shows those.
fn lakes(session: &Session, network: &Network) -> Vec<Vec<Place>> {
    let past = session.past().filter(|_| session.recipe().get::<Style>() == Style::PastCourses);
    let rounds = past.map_or(&[][..], PastCourses::rounds);
    let beds = rounds.iter().flat_map(|round| round.courses.iter().chain(&round.loops)).map(|bed| bed.line.clone());
    network.oxbows.iter().map(Oxbow::middle).chain(beds).collect()
}

fn heights(relief: &Relief) -> Heights<'_> {
    /// The share of all land that lies below what counts as the highest: peaks alone would make all else low.
    const HIGHEST: f32 = 0.995;
    Heights {
        heights: relief.heights(),
        columns: relief.columns(),
        cell_size: relief.cell_size(),
        highest: relief.quantile(HIGHEST),
    }
}

/// The boxes of all letters.
fn boxes(labels: &[Label]) -> Vec<Box> {
    labels.iter().flat_map(|label| label.letters.iter().map(|letter| letter.around(label.em))).collect()
}
