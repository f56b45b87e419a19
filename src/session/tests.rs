//! What holds when there is too little memory, and when a session goes back or to another size.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use super::*;
use crate::memory::testing::with_lists_up_to;
use crate::recipe::link;

/// Less than anything takes, in bytes.
const NOTHING: usize = 100;

const BENDS: &str = "attractors=300&trim=0&meander=flow&meander-rounds=3";

fn recipe(text: &str) -> Recipe {
    link::read(text).unwrap()
}

fn planted(text: &str) -> Session {
    Session::new(recipe(text), 60, 60).unwrap()
}

fn grown(text: &str) -> Session {
    let mut session = planted(text);
    while session.phase() == Phase::Growing {
        session.advance(1).unwrap();
    }
    session
}

fn finish(session: &mut Session) {
    while session.advance(50).unwrap() {}
    session.paint();
}

fn finished(text: &str) -> Session {
    let mut session = planted(text);
    finish(&mut session);
    session
}

/// All that there is to see of a session.
fn seen(session: &Session) -> (Recipe, Summary, Phase, Option<Network>, Vec<u8>) {
    let network = session.network().cloned();
    (session.recipe().clone(), session.summary(), session.phase(), network, session.pixmap().data().to_vec())
}

/// Asserts without printing pixels.
fn assert_same(session: &Session, expected: &Session) {
    assert!(seen(session) == seen(expected), "{:?}, not {:?}", session.summary(), expected.summary());
}

#[test]
fn recipe_that_there_is_no_memory_for_is_refused() {
    let refused = |text: &str, side: u32, bytes: usize| {
        with_lists_up_to(bytes, || Session::new(recipe(text), side, side)).map(drop).unwrap_err()
    };
    let attractors = SessionError::Grow(GrowError::OutOfMemory { attractors: 300, megabytes: 1 });
    assert_eq!(refused("attractors=300", 1, NOTHING), attractors);
    let field = refused("growth=brownian&sensitivity=60", 1, NOTHING);
    assert!(matches!(field, SessionError::Grow(GrowError::NoRoomForField { .. })), "{field:?}");
    let picture = SessionError::Paint(PaintError::OutOfMemory { width: 500, height: 500, megabytes: 3 });
    assert_eq!(refused("attractors=300", 500, 2_000_000), picture);
}

#[test]
fn tree_that_the_memory_ran_out_of_is_an_error_until_it_grows_anew() {
    for text in ["attractors=300", "growth=brownian&sensitivity=60"] {
        let mut session = planted(text);
        let failure = with_lists_up_to(NOTHING, || session.advance(u32::MAX)).unwrap_err();
        assert!(matches!(failure, SessionError::Grow(_)), "{failure:?}");
        assert_eq!(session.summary().ending, Some(Ending::OutOfMemory));
        assert_eq!(session.advance(1), Err(failure), "there is memory again, but half of the tree is missing");
        assert!(!session.is_finished() && session.network().is_none());
        session.restart().unwrap();
        finish(&mut session);
        assert_same(&session, &finished(text));
    }
}

#[test]
fn rivers_that_there_is_no_memory_for_are_an_error_and_come_when_there_is() {
    let mut session = grown(BENDS);
    let nodes = session.tree().len();
    // Too little to trim the tree; enough for that, but not for rivers.
    for bytes in [NOTHING, 64 * nodes] {
        let failure = with_lists_up_to(bytes, || session.advance(1)).unwrap_err();
        assert!(matches!(failure, SessionError::NoRivers { megabytes: 1, .. }), "{failure:?}");
        assert!(session.phase() == Phase::Shaping && session.network().is_none());
    }
    finish(&mut session);
    assert_same(&session, &finished(BENDS));
}

#[cfg(feature = "tools")]
#[test]
fn file_that_there_is_no_memory_for_is_refused() {
    use crate::export::{ExportError, geojson, json, svg};

    let session = finished(BENDS);
    let refused = ExportError::OutOfMemory { megabytes: 1 };
    with_lists_up_to(NOTHING, || {
        assert_eq!(svg::svg(&session).err(), Some(refused));
        assert_eq!(geojson::collection(&session).map(drop).err(), Some(refused));
        assert_eq!(json::network(&session, false).map(drop).err(), Some(refused));
    });
    let mut starved = grown(BENDS);
    assert!(with_lists_up_to(NOTHING, || starved.advance(1)).is_err());
    assert_eq!(svg::svg(&starved).err(), Some(ExportError::Unfinished));
}

#[test]
fn change_that_fails_leaves_everything_as_before() {
    // Enough to grow, but not for a picture of another shape.
    const NO_PICTURE: usize = 45_000;
    for (change, bytes) in [
        ("attractors=400&trim=0&meander=flow&meander-rounds=3", NOTHING),
        ("attractors=300&trim=0&meander=flow&meander-rounds=3&land=valley", NOTHING),
        ("attractors=300&trim=0&meander=flow&meander-rounds=3&growth=brownian", NOTHING),
        ("attractors=300&trim=0&meander=flow&meander-rounds=3&aspect=2", NO_PICTURE),
    ] {
        let mut session = Session::new(recipe(BENDS), 100, 100).unwrap();
        finish(&mut session);
        let before = session.clone();
        let failure = with_lists_up_to(bytes, || session.change(recipe(change))).unwrap_err();
        assert_eq!(matches!(failure, SessionError::Paint(_)), bytes == NO_PICTURE, "{change}: {failure}");
        assert_same(&session, &before);
        assert_eq!(session.paint(), None, "{change}: there is something to paint");
        assert_same(&session, &before);
        assert!(session.change(recipe(change)).is_ok_and(|stage| stage.is_some()));
    }
}

#[test]
fn restart_goes_back_to_tick_0_and_ends_the_same() {
    let mut session = finished(BENDS);
    let before = session.clone();
    assert!(with_lists_up_to(NOTHING, || session.restart()).is_err());
    assert_same(&session, &before);
    session.restart().unwrap();
    session.paint();
    let mut fresh = planted(BENDS);
    fresh.paint();
    assert!(session.summary().ticks == 0 && session.phase() == Phase::Growing && session.network().is_none());
    assert_same(&session, &fresh);
    finish(&mut session);
    assert_same(&session, &before);
}

#[test]
fn resize_paints_the_same_rivers() {
    let mut session = finished(BENDS);
    let before = session.clone();
    assert!(with_lists_up_to(NOTHING, || session.resize(90, 70)).is_err());
    assert!(session.resize(0, 70).is_err());
    assert_same(&session, &before);
    session.resize(90, 70).unwrap();
    assert_eq!((session.network(), session.summary()), (before.network(), before.summary()));
    session.paint();
    let mut fresh = Session::new(recipe(BENDS), 90, 70).unwrap();
    finish(&mut fresh);
    assert_same(&session, &fresh);
}
