//! Whole pictures: from a link, or after a change.

use riverseed::picture::Picture;
use riverseed::recipe::{Key, Recipe};
use riverseed::session::Session;

use super::{ATTRACTORS_FOR_SEGMENTS, BARE, Repetition, SIDE, recipe};

/// Makes an island from its link to the finished picture. Returns the number of rivers.
pub fn finished(growth: &str, attractors: &str) -> Option<Repetition> {
    pictured(recipe(&format!("growth={growth}&land=island&mouths=0&attractors={attractors}"))?)
}

/// Makes a map from its recipe to the finished picture. Returns the number of rivers.
pub fn pictured(recipe: Recipe) -> Option<Repetition> {
    pictured_at(recipe, SIDE, SIDE)
}

/// The same in a picture of another size.
pub fn pictured_at(recipe: Recipe, width: u32, height: u32) -> Option<Repetition> {
    let rivers = move || -> Option<u32> {
        let mut session = Session::new(recipe.clone()).ok()?;
        let mut picture = Picture::new(width, height).ok()?;
        session.advance(u32::MAX).ok()?;
        picture.paint(&session);
        Some(session.network()?.rivers.len() as u32)
    };
    Some(Box::new(move || rivers().unwrap_or(0)))
}

/// Changes a parameter of the network or of its painting on a finished plain map, up to the finished picture.
pub fn late(one: &str, other: &str) -> Option<Repetition> {
    let recipes = [recipe(one)?, recipe(other)?];
    let mut session = Session::new(recipes[0].clone()).ok()?;
    let mut picture = Picture::new(SIDE, SIDE).ok()?;
    session.advance(u32::MAX).ok()?;
    picture.paint(&session);
    let mut turn = 0;
    Some(Box::new(move || {
        turn = 1 - turn;
        if session.change(recipes[turn].clone()).is_err() || session.advance(u32::MAX).is_err() {
            return 0;
        }
        picture.paint(&session);
        session.network().map_or(0, |network| network.rivers.len() as u32)
    }))
}

/// Switches a session from one recipe to another and back, and paints each. Returns the number of nodes.
pub fn changes(one: &str, other: &str, attractors: u32, common: &str) -> Option<Repetition> {
    // If a link names a key twice, the last value counts.
    let recipe = |change: &str| {
        let mut recipe = recipe(&format!("{common}&attractors={attractors}"))?;
        if let Some((name, value)) = change.split_once('=') {
            recipe.set(Key::from_name(name)?, value).ok()?;
        }
        Some(recipe)
    };
    let recipes = [recipe(one)?, recipe(other)?];
    let mut session = Session::new(recipes[0].clone()).ok()?;
    let mut picture = Picture::new(SIDE, SIDE).ok()?;
    grow(&mut session)?;
    let mut turn = 0;
    Some(Box::new(move || {
        turn = 1 - turn;
        if session.change(recipes[turn].clone()).is_err() || grow(&mut session).is_none() {
            return 0;
        }
        picture.paint(&session);
        session.tree().len() as u32
    }))
}

/// Grows the tree that is turned into rivers in the following frames. `None` if there is not enough memory.
fn grow(session: &mut Session) -> Option<()> {
    while session.growth().ending().is_none() {
        session.advance(1).ok()?;
    }
    Some(())
}

/// The number of bytes in which a picture painted during growth differs from the picture painted at once.
pub fn differing_bytes() -> Option<u32> {
    const TICKS_A_FRAME: u32 = 8;
    let recipe = recipe(&format!("{BARE}&attractors={ATTRACTORS_FOR_SEGMENTS}"))?;
    let painted = |ticks: u32| {
        let mut session = Session::new(recipe.clone()).ok()?;
        let mut picture = Picture::new(SIDE, SIDE).ok()?;
        while session.growth().ending().is_none() {
            for _ in 0..ticks {
                if session.growth().ending().is_none() {
                    session.advance(1).ok()?;
                }
            }
            picture.paint(&session);
        }
        Some(picture.pixmap().data().to_vec())
    };
    let (frames, at_once) = (painted(TICKS_A_FRAME)?, painted(u32::MAX)?);
    Some(frames.iter().zip(&at_once).filter(|(a, b)| a != b).count() as u32)
}
