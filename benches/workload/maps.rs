//! Whole maps as people meet them: a link, all its defaults, and a picture of the usual size.

use riverseed::picture::Picture;
use riverseed::recipe::{Recipe, link};
use riverseed::session::{Phase, Session};

use super::{Repetition, pictures};

/// The size of the picture, in pixels.
const WIDTH: u32 = 1024;
const HEIGHT: u32 = 640;

/// Makes a map from its link to the finished picture. Returns the number of rivers.
pub fn whole(look: &str) -> Option<Repetition> {
    pictures::pictured_at(link::read(look).ok()?, WIDTH, HEIGHT)
}

/// Counts the parcels that a map begins with, or the vertices of its finished rivers.
pub fn count(what: &str, look: &str) -> Option<Repetition> {
    let mut session = Session::new(link::read(look).ok()?).ok()?;
    let count = match what {
        "parcels" => session.growth().attractors(),
        "vertices" => session.finish().ok()?.network().vertices.len() as u32,
        _ => return None,
    };
    Some(Box::new(move || count))
}

/// Hashes the finished picture of a map.
pub fn picture(look: &str) -> Option<Repetition> {
    let mut session = Session::new(link::read(look).ok()?).ok()?;
    let mut picture = Picture::new(WIDTH, HEIGHT).ok()?;
    session.finish().ok()?;
    picture.paint(&session);
    let bytes = picture.pixmap().data().iter();
    let hash = bytes.fold(0, |hash: u32, &byte| hash.wrapping_mul(31).wrapping_add(byte.into()));
    Some(Box::new(move || hash))
}

/// Makes the next phase of a map each time: first its land and its parcels, last its picture, and then the first again. Returns the
/// number of the phase, which is 0 for the first.
pub fn phases(look: &str) -> Option<Repetition> {
    let recipe = link::read(look).ok()?;
    let mut making = None;
    Some(Box::new(move || next_phase(&recipe, &mut making).unwrap_or(u32::MAX)))
}

/// Makes the next phase of a session, which begins with the first and is gone after the last.
fn next_phase(recipe: &Recipe, making: &mut Option<Session>) -> Option<u32> {
    let Some(session) = making else {
        *making = Some(Session::new(recipe.clone()).ok()?);
        return Some(0);
    };
    let phase = session.phase();
    if phase == Phase::Finished {
        Picture::new(WIDTH, HEIGHT).ok()?.paint(session);
        *making = None;
    } else {
        while session.phase() == phase {
            session.advance(1).ok()?;
        }
    }
    Some(1 + phase as u32)
}
