//! Sessions with too little memory, after a restart, and after changes.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use super::*;
use crate::base::memory::testing::with_lists_up_to;
use crate::base::work;
use crate::grow::Ending;
use crate::land::Cell;
use crate::picture::Picture;
use crate::recipe::link;

/// A limit below anything's needs, in bytes.
const NOTHING: usize = 100;

/// An island with a ridge along its whole coast.
const NO_COAST: &str = "land=drawn&roughness=0&aspect=1&outline=.MzMzzMMzzMzMMzzM..M1M1zKM1zKzKM1zKM1M1";

/// An island with a ring of ridges around the middle quarter of its area.
const CUT_OFF: &str = "land=drawn&roughness=0&aspect=1&outline=.MzMzzMMzzMzMMzzM..YAYAnnYAnnnnYAnnYAYA";

const BENDS: &str = "growth=colonize&attractors=300&trim=0&meander=flow&meander-rounds=3&lakes=0";

/// The same rivers with lakes.
const LAKES: &str = "growth=colonize&attractors=300&trim=0&meander=flow&meander-rounds=3&lakes=0.5";

fn recipe(text: &str) -> Recipe {
    link::read(text).unwrap()
}

fn planted(text: &str) -> Session {
    Session::new(recipe(text)).unwrap()
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
}

fn finished(text: &str) -> Session {
    let mut session = planted(text);
    finish(&mut session);
    session
}

/// Returns the visible state of a session.
fn seen(session: &Session) -> (&Recipe, Summary, Phase, &Tree, Option<&Network>) {
    (session.recipe(), session.summary(), session.phase(), session.tree(), session.network())
}

/// Asserts equality without printing the whole states.
fn assert_same(session: &Session, expected: &Session) {
    assert!(seen(session) == seen(expected), "{:?}, not {:?}", session.summary(), expected.summary());
}

#[test]
fn recipe_that_there_is_no_memory_for_is_refused() {
    let refused = |text: &str| with_lists_up_to(NOTHING, || Session::new(recipe(text))).map(drop).unwrap_err();
    let attractors = SessionError::Grow(GrowError::OutOfMemory { attractors: 300, megabytes: 1 });
    assert_eq!(refused("growth=colonize&valleys=1&land=rectangle&aspect=1&attractors=300"), attractors);
    assert_eq!(refused("growth=colonize&valleys=0&attractors=300"), attractors);
    assert_eq!(refused("growth=drainage&attractors=300"), attractors);
    let raster = refused("growth=brownian&sensitivity=60");
    assert!(matches!(raster, SessionError::Grow(GrowError::NoRoomForRaster { .. })), "{raster:?}");
}

#[test]
fn tree_that_the_memory_ran_out_of_is_an_error_until_it_grows_again() {
    for text in [
        "growth=colonize&valleys=0&attractors=300",
        "growth=colonize&valleys=0.3&attractors=300",
        "growth=drainage&attractors=300",
        "growth=brownian&sensitivity=60",
    ] {
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
    // Limits: too little to trim the tree; enough for that, but not for rivers; enough for rivers, but not for their
    // courses.
    for bytes in [NOTHING, 64 * nodes, 256 * nodes + 500_000] {
        let failure = with_lists_up_to(bytes, || session.advance(1)).unwrap_err();
        assert!(matches!(failure, SessionError::Shape(ShapeError::OutOfMemory { megabytes: 1, .. })), "{failure:?}");
        assert!(session.phase() == Phase::Shaping && session.network().is_none());
    }
    finish(&mut session);
    assert_same(&session, &finished(BENDS));
}

#[test]
fn file_that_there_is_no_memory_for_is_refused() {
    use crate::export::{ExportError, geojson, json, svg};

    let map = finished(BENDS).map().unwrap();
    let refused = ExportError::OutOfMemory { megabytes: 1 };
    with_lists_up_to(NOTHING, || {
        assert_eq!(svg::svg(&map).err(), Some(refused));
        assert_eq!(geojson::collection(&map).map(drop).err(), Some(refused));
        assert_eq!(json::network(&map, None).map(drop).err(), Some(refused));
    });
    let mut starved = grown(BENDS);
    assert!(with_lists_up_to(NOTHING, || starved.advance(1)).is_err());
    assert_eq!(starved.map(), None);
}

#[test]
fn change_that_fails_leaves_everything_as_before() {
    for change in ["attractors=400", "attractors=300&land=valley", "attractors=300&growth=brownian", "aspect=2"] {
        let change = recipe(&format!("trim=0&meander=flow&meander-rounds=3&{change}"));
        let mut session = finished(BENDS);
        let (before, generation) = (session.clone(), session.generation());
        assert!(with_lists_up_to(NOTHING, || session.change(change.clone())).is_err());
        assert_same(&session, &before);
        assert_eq!(session.generation(), generation, "there is something to paint");
        assert!(session.change(change).is_ok_and(|stage| stage.is_some()));
        assert!(session.generation() != generation);
    }
}

#[test]
fn restart_goes_back_to_tick_0_and_ends_the_same() {
    let mut session = finished(BENDS);
    let before = session.clone();
    assert!(with_lists_up_to(NOTHING, || session.restart()).is_err());
    assert_same(&session, &before);
    session.restart().unwrap();
    let fresh = planted(BENDS);
    assert!(session.summary().ticks == 0 && session.phase() == Phase::Growing && session.network().is_none());
    assert_same(&session, &fresh);
    finish(&mut session);
    assert_same(&session, &before);
}

#[test]
fn a_copy_has_come_as_far_and_goes_its_own_way() {
    for text in [BENDS, "growth=brownian&sensitivity=40", "attractors=300&land=rectangle&meander=none"] {
        let whole = finished(text);
        let mut session = planted(text);
        loop {
            let mut copy = session.try_clone().unwrap();
            assert_same(&copy, &session);
            let as_it_was = session.clone();
            finish(&mut copy);
            assert_same(&copy, &whole);
            copy.change(recipe("attractors=100")).unwrap();
            assert_same(&session, &as_it_was);
            if !session.advance(40).unwrap() {
                break;
            }
        }
        assert_same(&session, &whole);
    }
}

#[test]
fn advice_fits_how_rivers_grow() {
    let shortfall = |text: &str| finished(text).summary().shortfall();
    for growth in ["growth=colonize", "growth=drainage", "growth=brownian&sensitivity=30"] {
        let summary = finished(&format!("attractors=300&{growth}&{NO_COAST}")).summary();
        assert_eq!(summary.shortfall(), Some(Shortfall::NoRiver), "{growth}: {summary:?}");
        assert_eq!(shortfall(&format!("attractors=300&{growth}")), None);
    }
    assert_eq!(shortfall("growth=colonize&attractors=300&kill=0.5&step=1.2"), Some(Shortfall::Unreached));
    // In drainage, only land without a way to the sea stays dry: here the middle of an island, within a ring of ridges.
    assert_eq!(shortfall("growth=drainage&attractors=300&kill=0.5&step=1.2"), None);
    assert_eq!(shortfall(&format!("growth=drainage&attractors=900&{CUT_OFF}")), Some(Shortfall::CutOff));
    // Attractors and their step do not matter to a Brownian tree.
    assert_eq!(shortfall("attractors=300&kill=0.5&step=1.2&growth=brownian&sensitivity=30"), None);
}

#[test]
fn progress_is_whole_once_all_is_finished() {
    for text in [BENDS, "attractors=300&meander=none", "attractors=300&meander-rounds=0"] {
        assert_eq!(finished(text).progress(), 1.0, "{text}");
    }
}

/// Changes of each late stage, at every step from the last of growth on.
#[test]
fn changed_at_any_step_a_session_ends_as_a_fresh_one() {
    for (change, stage) in [
        ("trim=0&simplify=20", Stage::Shape),
        ("trim=0&width=30", Stage::Shape),
        ("trim=0&meander-rounds=5&meander-strength=1", Stage::Shape),
        ("trim=70", Stage::Prune),
    ] {
        let change = format!("growth=colonize&attractors=300&{change}");
        let fresh = finished(&change);
        let mut session = grown(BENDS);
        loop {
            let mut changed = session.clone();
            assert_eq!(changed.change(recipe(&change)), Ok(Some(stage)));
            finish(&mut changed);
            assert_same(&changed, &fresh);
            if session.is_finished() {
                break;
            }
            session.advance(1).unwrap();
        }
    }
}

#[test]
fn one_picture_of_a_session_and_of_its_copy_shows_each() {
    let session = grown(BENDS);
    let mut copy = session.try_clone().unwrap();
    finish(&mut copy);
    let painted = |picture: &mut Picture, session: &Session| {
        picture.paint(session);
        picture.pixmap().data().to_vec()
    };
    let mut picture = Picture::new(60, 40).unwrap();
    for session in [&copy, &session, &copy] {
        assert!(painted(&mut picture, session) == painted(&mut Picture::new(60, 40).unwrap(), session));
    }
}

#[test]
fn a_copy_that_there_is_no_memory_for_is_refused() {
    let session = finished(BENDS);
    let refused = with_lists_up_to(6_000_000, || session.try_clone()).map(drop).unwrap_err();
    assert_eq!(refused, SessionError::Copy { megabytes: 7 });
    assert_eq!(refused.to_string(), "a copy of the rivers needs about 7 MB, and the allocation failed");
}

/// Rivers that are finished, in a style that shows their relief.
fn shaped(text: &str) -> Session {
    let mut session = planted(text);
    while session.phase() != Phase::Relief {
        assert!(session.advance(1).unwrap(), "{text} shows no relief");
    }
    session
}

#[test]
fn relief_that_there_is_no_memory_for_is_an_error_and_comes_when_there_is() {
    for land in ["land=rectangle", "land=island"] {
        let text = format!("{BENDS}&{land}&style=atlas");
        let expected = finished(&text);
        // Limits: enough for nothing; enough for the lists of cells but not for everything; enough for all but the
        // queue.
        for bytes in [NOTHING, 2_000_000, 3_000_000] {
            let (mut session, mut refused) = (shaped(&text), 0);
            while !session.is_finished() {
                if let Err(failure) = with_lists_up_to(bytes, || session.advance(1)) {
                    assert!(matches!(failure, SessionError::Relief(_)), "{failure:?}");
                    assert!(failure.to_string().contains("needs about 6 MB"), "{failure}");
                    assert_eq!((session.phase(), session.relief()), (Phase::Relief, None));
                    refused += 1;
                    session.advance(1).unwrap();
                }
            }
            assert!(refused > 1, "{refused} of {bytes}");
            assert!(session.relief() == expected.relief(), "{land}, {bytes} bytes");
        }
    }
}

#[test]
fn each_step_of_a_relief_that_asks_for_memory_can_be_refused_and_made_again() {
    let text = format!("{BENDS}&land=island&style=atlas");
    let (expected, mut session) = (finished(&text), shaped(&text));
    let mut refused = Vec::new();
    for step in 0.. {
        let failure = with_lists_up_to(NOTHING, || session.advance(1));
        refused.extend(failure.is_err().then_some(step));
        if failure.is_err() && !session.advance(1).unwrap() || session.is_finished() {
            break;
        }
    }
    // Refused: the whole, the cells, the hillsides, profiles of rivers, their paths, the front, the heights of each time that
    // it comes to rest, after four of which beds are lowered, those after creep, and those handed on.
    assert_eq!(refused.len(), 13, "{refused:?}");
    assert!(session.relief() == expected.relief());
}

#[test]
fn each_step_of_lakes_can_be_refused_and_made_again() {
    for style in ["atlas", "ink"] {
        let text = format!("{LAKES}&land=island&style={style}");
        let (expected, mut session) = (finished(&text), shaped(&text));
        while session.lakes().is_none() && session.relief().is_none() && session.relief.relief().is_none() {
            session.advance(1).unwrap();
        }
        let mut refused = 0;
        while with_lists_up_to(NOTHING, || session.advance(1)) != Ok(false) && !session.is_finished() {
            refused += 1;
            assert!(refused < 100, "{style}: it begins again and again");
            session.advance(1).unwrap();
        }
        assert!(refused > 1, "{style}: {refused}");
        assert!(session.lakes().is_some_and(|lakes| !lakes.is_empty()), "{style}");
        assert!(session.lakes() == expected.lakes(), "{style}");
    }
}

#[test]
fn a_copy_begins_a_relief_in_the_making_again_and_ends_the_same() {
    let text = format!("{BENDS}&style=atlas");
    let mut session = shaped(&text);
    let copied = |session: &Session| with_lists_up_to(10_000_000, || session.try_clone()).map(drop);
    session.advance(9).unwrap();
    assert!(session.progress() > 0.0);
    assert_eq!(copied(&session), Ok(()), "what is being made is not copied");
    let mut copy = session.try_clone().unwrap();
    assert_eq!(copy.progress(), 0.0);
    finish(&mut copy);
    finish(&mut session);
    assert!(session.relief().is_some() && session.relief() == copy.relief());
    assert_eq!(copied(&session), Ok(()), "what is solved is shared");
}

#[test]
fn progress_of_a_relief_never_goes_back() {
    let texts = [(BENDS, "land=rectangle&style=night"), (BENDS, "land=archipelago&style=night"), (LAKES, "style=ink")];
    for (text, more) in texts {
        let mut session = shaped(&format!("{text}&{more}"));
        let mut seen = vec![session.progress()];
        while session.advance(1).unwrap() {
            seen.push(session.progress());
        }
        assert!(seen.iter().all(|share| *share < 1.0), "it is not finished yet: {seen:?}");
        assert!(seen.is_sorted() && seen[0] == 0.0 && seen.iter().all(|share| *share <= 1.0), "{seen:?}");
        // It does not jump either.
        assert!(seen.windows(2).all(|pair| pair[1] - pair[0] < 0.5), "{seen:?}");
        assert_eq!(session.progress(), 1.0);
    }
}

#[test]
fn a_change_that_changes_nothing_leaves_relief_and_lakes() {
    for text in [BENDS, LAKES].into_iter().flat_map(|text| [format!("{text}&style=atlas"), format!("{text}&style=ink")])
    {
        let mut session = finished(&text);
        let lakes = session.lakes().cloned();
        assert_eq!(session.change(session.recipe().clone()).unwrap(), None);
        assert_eq!((session.phase(), session.lakes()), (Phase::Finished, lakes.as_ref()), "{text}");
    }
}

#[test]
fn change_of_a_late_stage_makes_no_step() {
    let mut session = finished(BENDS);
    for change in ["&width=30", "&width=30&simplify=20", "&width=30&simplify=20&neck=2"] {
        let before = work::steps();
        session.change(recipe(&format!("{BENDS}{change}"))).unwrap();
        assert_eq!((session.phase(), work::steps() - before), (Phase::Shaping, 0), "{change}");
        finish(&mut session);
    }
}

#[test]
fn relief_is_made_in_steps_in_any_style_and_is_that_of_all_styles() {
    let expected = finished(&format!("{BENDS}&style=atlas"));
    let mut session = finished(&format!("{BENDS}&style=ink"));
    let steps = std::iter::from_fn(|| session.raise_relief().unwrap().then_some(())).count();
    assert!(steps > 10, "{steps}");
    assert_eq!((session.phase(), session.relief()), (Phase::Finished, None), "the style shows none");
    let before = work::steps();
    assert!(session.map().unwrap().make_relief().as_ref() == Ok(expected.relief().unwrap()));
    assert_eq!(work::steps(), before, "nothing is left to do");
    let mut growing = planted(BENDS);
    assert_eq!(growing.raise_relief(), Ok(false), "there are no rivers yet");
    // Other rivers have another relief.
    session.change(recipe(&format!("{BENDS}&style=ink&width=30"))).unwrap();
    finish(&mut session);
    assert!(session.map().unwrap().make_relief().as_ref() != Ok(expected.relief().unwrap()));
    assert!(
        session.map().unwrap().make_relief()
            == finished(&format!("{BENDS}&style=dark&width=30")).map().unwrap().make_relief()
    );
}

#[test]
fn relief_of_a_file_is_refused_where_there_is_no_memory_for_it() {
    let session = finished(&format!("{BENDS}&style=ink"));
    let refused = with_lists_up_to(NOTHING, || session.map().unwrap().make_relief()).unwrap_err();
    assert!(refused.to_string().contains("needs about 6 MB"), "{refused}");
}

/// Returns the share of cells that are land in one of two lands alone.
fn difference(one: &Land, other: &Land) -> f32 {
    let cells = || (0..one.rows()).flat_map(|row| (0..one.columns()).map(move |column| (column, row)));
    let is_other = |&(column, row): &(i32, i32)| {
        (one.cell(column, row) == Cell::Water) != (other.cell(column, row) == Cell::Water)
    };
    cells().filter(is_other).count() as f32 / cells().count() as f32
}

#[test]
fn drafts_of_drowned_coasts_are_near_the_lands_that_come() {
    for land in ["island", "archipelago", "continent", "basin"] {
        let text = format!("country=usual&seed=skye&attractors=6000&land={land}");
        let read = |more: &str| link::read(&format!("{text}&{more}")).unwrap();
        let session = finished(&format!("{text}&sea=0.5&drowning=0.5"));
        let mut drafts = SessionDrafts::default();
        for (more, most) in [
            ("sea=0.51&drowning=0.5", 0.02),
            ("sea=0.56&drowning=0.5", 0.04),
            ("sea=0.5&drowning=0.52", 0.02),
            ("sea=0.5&drowning=0.8", 0.07),
            ("sea=0.5&drowning=0.5&roughness=0.95", 0.03),
        ] {
            let wanted = read(more);
            let draft = drafts.land(&session, &wanted).unwrap();
            let exact = finished(&format!("{text}&{more}")).land().cloned().unwrap();
            let plain = Land::draft_of(&wanted).unwrap();
            let (off, plain) = (difference(&draft, &exact), difference(&plain, &exact));
            assert!(off < most && off < plain, "{land} {more}: {off}, without drowning {plain}");
        }
    }
}

#[test]
fn each_step_of_the_seas_rise_can_be_refused_and_made_again() {
    let text = "country=usual&seed=kea&attractors=2000&land=island&drowning=0.5";
    let mut session = Session::new(link::read(text).unwrap()).unwrap();
    while session.phase() != Phase::Drowning {
        session.advance(1).unwrap();
    }
    let mut refused = 0;
    while session.phase() == Phase::Drowning && refused < 40 {
        let failed = with_lists_up_to(300_000, || session.advance(1));
        refused += u32::from(failed.is_err());
        assert!(failed.is_ok() || matches!(failed, Err(SessionError::Relief(_))), "{failed:?}");
    }
    assert_eq!(refused, 40, "so little memory is never enough");
    assert!(session.finish().unwrap().land() == finished(text).land());
}

/// Makes a session of drowned coasts whose sea is about to be seen rising.
fn before_the_transgression(text: &str) -> Session {
    let mut session = Session::new(link::read(text).unwrap()).unwrap();
    while session.transgression().is_none() {
        assert!(session.advance(1).unwrap());
    }
    session
}

#[test]
fn a_transgression_that_nobody_looks_at_is_no_work() {
    let mut session = before_the_transgression("country=usual&seed=kea&attractors=2000&land=island&drowning=0.5");
    let (mut before, mut steps) = (session.progress(), 0);
    while session.transgression().is_some_and(|transgression| transgression.step() + 1 < Transgression::STEPS) {
        let work = work::steps();
        session.advance(1).unwrap();
        assert_eq!(work::steps(), work, "step {steps}");
        assert!(session.progress() > before && session.phase() == Phase::Drowning);
        (before, steps) = (session.progress(), steps + 1);
    }
    session.advance(1).unwrap();
    assert!(
        steps == Transgression::STEPS - 1 && session.transgression().is_none() && session.phase() == Phase::Shaping
    );
}

#[test]
fn a_copy_in_the_transgression_counts_its_heights_and_ends_as_the_session_does() {
    let text = "country=usual&seed=kea&attractors=2000&land=island&drowning=0.5";
    let mut session = before_the_transgression(text);
    session.advance(3).unwrap();
    // The low stand's distances are as many.
    assert_eq!(session.coasts.bytes(), size_of_val(session.land().unwrap().coast_distance().heights()));
    let mut copy = session.try_clone().unwrap();
    let expected = finished(text);
    for mut session in [session, copy.clone()] {
        let map = session.finish().unwrap();
        assert!(map.land() == expected.land() && **map.network() == *expected.network().unwrap());
    }
    // Seeking passes through the transgression in both directions.
    let mut timeline = Timeline::new(&expected).unwrap();
    for to in [Moment::Bends(2), Moment::Growth(3), Moment::Finished, Moment::Bends(0)] {
        while timeline.seek(&mut copy, to).unwrap() {}
        assert_eq!(copy.moment(), to);
    }
    assert!(copy.finish().unwrap().land() == expected.land());
}

#[test]
fn a_cut_that_is_refused_at_its_end_is_made_again() {
    let text = "country=usual&seed=kea&attractors=2000&land=island&drowning=0.5";
    let mut session = before_the_transgression(text);
    session.advance(Transgression::STEPS - 1).unwrap();
    for _ in 0..2 {
        assert!(with_lists_up_to(1_000, || session.advance(1)).is_err() && session.phase() == Phase::Drowning);
    }
    assert!(session.finish().unwrap().land() == finished(text).land());
}
