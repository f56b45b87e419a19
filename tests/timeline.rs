//! Moving back and forth through the making of a map shows the same pictures as on the way.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use crate::common::tier::{one_in, pairs, tiers};
use riverseed::picture::Picture;
use riverseed::recipe::link;
use riverseed::session::{Moment, Session, Timeline};

fn session(text: &str) -> Session {
    Session::new(link::read(text).unwrap()).unwrap()
}

fn picture() -> Picture {
    Picture::new(120, 80).unwrap()
}

fn pixels(picture: &mut Picture, session: &Session) -> Vec<u8> {
    picture.paint(session);
    picture.pixmap().data().to_vec()
}

fn go(timeline: &mut Timeline, session: &mut Session, to: Moment) {
    while timeline.seek(session, to).unwrap() {}
    assert_eq!(session.moment(), to);
}

/// Every moment of a session as it is played, with its picture.
fn played(text: &str) -> Vec<(Moment, Vec<u8>)> {
    let mut session = session(text);
    let mut seen = vec![(session.moment(), pixels(&mut picture(), &session))];
    loop {
        let goes_on = session.advance(1).unwrap();
        if seen.last().unwrap().0 != session.moment() {
            seen.push((session.moment(), pixels(&mut picture(), &session)));
        }
        if !goes_on {
            return seen;
        }
    }
}

fn each_moment_looks_as_when_it_was_played_however_one_comes_there() {
    for (growth, style) in one_in(5, pairs(["drainage", "colonize", "brownian"], ["ink", "atlas"])) {
        let text =
            format!("country=usual&seed=kea&land=island&growth={growth}&attractors=600&meander-rounds=9&style={style}");
        let played = played(&text);
        let mut session = session(&text);
        session.finish().unwrap();
        let mut timeline = Timeline::new(&session).unwrap();
        let mut picture = picture();
        let mut at = 0;
        for i in 0..60 {
            // Near and far, back and forth, to the end now and then.
            at = if i % 9 == 8 { played.len() - 1 } else { (at * 7 + i * 31 + 5) % played.len() };
            let (moment, expected) = &played[at];
            go(&mut timeline, &mut session, *moment);
            assert!(pixels(&mut picture, &session) == *expected, "{text}: {moment:?}");
        }
    }
}

tiers!(each_moment_looks_as_when_it_was_played_however_one_comes_there);

#[test]
fn each_tick_and_round_is_a_moment_and_the_ends_are_known() {
    let text = "country=usual&seed=kea&land=island&growth=drainage&attractors=600&meander-rounds=9&style=ink";
    let played = played(text);
    let mut session = session(text);
    session.finish().unwrap();
    let timeline = Timeline::new(&session).unwrap();
    let moments: Vec<Moment> = played.iter().map(|(moment, _)| *moment).collect();
    let expected = (0..timeline.ticks()).map(Moment::Growth);
    let expected: Vec<_> =
        expected.chain((0..=timeline.rounds()).map(Moment::Bends)).chain([Moment::Finished]).collect();
    assert_eq!(moments, expected);
    // The ninth is the end.
    assert_eq!(timeline.rounds(), 8);
}

#[test]
fn only_a_finished_session_has_a_timeline_and_what_is_beyond_its_end_is_its_end() {
    let mut session = session("country=usual&seed=kea&attractors=300&meander-rounds=2");
    assert!(Timeline::new(&session).is_none());
    session.finish().unwrap();
    let mut timeline = Timeline::new(&session).unwrap();
    for beyond in [Moment::Growth(u32::MAX), Moment::Bends(u32::MAX)] {
        go(&mut timeline, &mut session, Moment::Growth(1));
        while timeline.seek(&mut session, beyond).unwrap() {}
        assert!(session.moment() > beyond || session.moment() == Moment::Finished);
    }
}
