use super::testing::{SMALL, finished, painted};
use super::*;
use crate::base::memory::testing::with_lists_up_to;
use crate::recipe::link;

#[test]
fn picture_that_there_is_no_memory_for_is_refused() {
    let refused = with_lists_up_to(2_000_000, || Picture::new(500, 500)).map(drop).unwrap_err();
    assert_eq!(refused, PaintError::OutOfMemory { width: 500, height: 500, megabytes: 16 });
    assert_eq!(Picture::new(0, 70).map(drop).unwrap_err(), PaintError::Size { width: 0, height: 70 });
}

#[test]
fn nothing_is_painted_twice() {
    let session = finished(SMALL);
    let mut picture = Picture::new(100, 80).unwrap();
    assert!(picture.paint(&session).is_some());
    assert_eq!(picture.paint(&session), None);
}

#[test]
fn rivers_stay_in_the_picture_until_there_are_others_of_their_tree() {
    let mut session = finished(SMALL);
    let mut picture = Picture::new(100, 80).unwrap();
    picture.paint(&session);
    let before = painted(&session);
    session.change(link::read(&format!("{SMALL}&width=30&style=atlas")).unwrap()).unwrap();
    let mut steps = 0;
    while session.phase() == Phase::Shaping {
        assert_eq!(picture.paint(&session), None);
        assert!(picture.pixmap().data() == before);
        session.advance(1).unwrap();
        steps += 1;
    }
    assert!(steps > 1 && picture.paint(&session).is_some());
    assert!(picture.pixmap().data() == painted(&session), "{steps} steps");
}

#[test]
fn relief_stays_in_the_picture_until_there_is_another_of_its_rivers() {
    let mut session = finished(&format!("{SMALL}&style=atlas"));
    let mut picture = Picture::new(100, 80).unwrap();
    picture.paint(&session);
    let before = painted(&session);
    for change in ["mountains=3", "mountains=3&plains=20"] {
        let steps = steps_of_relief(&mut session, change, |session| {
            assert_eq!(picture.paint(session), None, "{change}");
            assert!(picture.pixmap().data() == before, "{change}");
        });
        assert!(steps > 1, "{change}");
    }
    assert!(picture.paint(&session).is_some());
    assert!(picture.pixmap().data() == painted(&session) && picture.pixmap().data() != before);
    // A picture without a relief goes on to the final rivers.
    let mut flat = Picture::new(100, 80).unwrap();
    session.change(link::read(&format!("{SMALL}&style=atlas&width=20")).unwrap()).unwrap();
    while session.phase() != Phase::Relief {
        flat.paint(&session);
        session.advance(2).unwrap();
    }
    flat.paint(&session);
    assert!(flat.pixmap().data() == painted(&session));
}

/// Changes a session and calls `look` before each step of its relief. Returns the number of steps.
fn steps_of_relief(session: &mut Session, change: &str, mut look: impl FnMut(&Session)) -> u32 {
    session.change(link::read(&format!("{SMALL}&style=atlas&{change}")).unwrap()).unwrap();
    let mut steps = 0;
    while session.phase() == Phase::Relief {
        look(session);
        session.advance(1).unwrap();
        steps += 1;
    }
    steps
}

#[test]
fn a_map_is_painted_as_its_session_is_whatever_was_shown_before() {
    let mut picture = Picture::new(100, 80).unwrap();
    let labelled = SMALL.replace("labels=none", "labels=many");
    for (small, change) in [
        (SMALL, "style=ink"),
        (&labelled, "style=atlas&woods=1&hills=1"),
        (SMALL, "land=island&style=night"),
        (SMALL, "style=past-courses"),
    ] {
        let session = finished(&format!("{small}&{change}"));
        let map = session.map().unwrap();
        assert!(picture.paint_map(&map).is_some(), "{change}");
        assert!(picture.pixmap().data() == painted(&session), "{change}");
        assert_eq!(picture.paint_map(&map), None, "{change}");
    }
    let growing = Session::new(link::read(SMALL).unwrap()).unwrap();
    picture.paint(&growing);
    assert!(picture.pixmap().data() == painted(&growing));
}

#[test]
fn the_sea_is_seen_rising_over_the_rivers() {
    for style in ["ink", "skeleton"] {
        let text = format!("country=usual&seed=kea&attractors=2000&land=island&drowning=0.6&style={style}");
        let mut session = Session::new(link::read(&text).unwrap()).unwrap();
        let mut picture = Picture::new(300, 240).unwrap();
        while session.transgression().is_none() {
            session.advance(1).unwrap();
            picture.paint(&session);
        }
        let mut before = picture.pixmap().data().to_vec();
        while session.phase() == Phase::Drowning {
            assert_eq!(picture.paint(&session), None, "{style}: painted twice");
            session.advance(1).unwrap();
            assert!(picture.paint(&session).is_some(), "{style}");
            let mut fresh = Picture::new(300, 240).unwrap();
            fresh.paint(&session);
            assert!(picture.pixmap().data() == fresh.pixmap().data(), "{style}: it depends on what was shown before");
            assert!(picture.pixmap().data() != before, "{style}: nothing has risen");
            before = picture.pixmap().data().to_vec();
            assert_no_river_at_sea(&picture, &session, style);
        }
    }
}

/// Checks that rivers of a skeleton, which are white, have gone where the sea of the moment is.
fn assert_no_river_at_sea(picture: &Picture, session: &Session, style: &str) {
    let Some(land) = session.transgression().map(|transgression| transgression.land()).filter(|_| style == "skeleton")
    else {
        return;
    };
    let mut drowned = 0;
    for at in session.tree().at.iter().filter(|at| land.coast_distance().height(**at) < -3.0) {
        let [x, y] = picture.view().pixel(*at).to_array().map(|of| of as u32);
        let pixel = picture.pixmap().pixel(x, y).unwrap();
        assert!(pixel.red() < 255, "a river is left at {at}");
        drowned += 1;
    }
    assert!(drowned > 0);
}

#[test]
fn whatever_becomes_of_the_session_the_picture_is_that_of_a_fresh_one() {
    let mut session = finished(SMALL);
    let mut picture = Picture::new(100, 80).unwrap();
    picture.paint(&session);
    for change in
        ["aspect=0.5", "land=valley", "land=rectangle", "land=rectangle&momentum=0.5", "style=atlas", "width=30"]
    {
        session.change(link::read(&format!("{SMALL}&{change}")).unwrap()).unwrap();
        while session.advance(50).unwrap() {}
        picture.paint(&session);
        assert!(picture.pixmap().data() == painted(&session), "{change}");
    }
    session.restart().unwrap();
    picture.paint(&session);
    assert!(picture.pixmap().data() == painted(&session), "restarted");
    let other = finished(&format!("{SMALL}&country=usual&seed=rimu&land=rectangle"));
    let mut picture = Picture::new(100, 80).unwrap();
    for session in [finished(&format!("{SMALL}&land=rectangle")), other] {
        picture.paint(&session);
        assert!(picture.pixmap().data() == painted(&session), "another session");
    }
}

#[test]
fn the_places_of_labels_are_chosen_once_for_a_map_however_its_pictures_are_moved() {
    let link = SMALL.replace("labels=none", "labels=many");
    let mut session = finished(&link);
    let names = |picture: &Picture| picture.labels().iter().filter(|label| label.river.is_some()).count();
    let paint_at = |picture: &mut Picture, session: &Session, x: f32| {
        picture.frame(session, Framing::new(x, 0.1, 0.6));
        picture.paint(session);
        names(picture)
    };
    let new = || Picture::new(600, 480).unwrap();
    let mut picture = new();
    assert!(paint_at(&mut picture, &session, 0.1) > 0);
    // What is not chosen again is missing from now on.
    picture.annotator.places().empty();
    for x in [0.15, 0.2, 0.25] {
        assert_eq!(paint_at(&mut picture, &session, x), 0, "moved to {x}");
    }
    let mut picture = new().in_place_of(picture);
    assert_eq!(paint_at(&mut picture, &session, 0.1), 0, "another picture in its place");
    // Another map has its own places.
    session.change(link::read(&link.replace("trim=0", "trim=2")).unwrap()).unwrap();
    while session.advance(1000).unwrap() {}
    assert!(paint_at(&mut picture, &session, 0.1) > 0);
}
