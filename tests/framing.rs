//! Pictures of a part of a map, and of its surroundings.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use crate::common::styles;
use riverseed::paint::Framing;
use riverseed::recipe::Style;
use riverseed::{Picture, Recipe, Session};

const SMALL: &str = "country=usual&seed=skye&attractors=2000&labels=none";
const LABELLED: &str = "country=usual&seed=skye&attractors=2000";

fn finished(text: &str) -> Session {
    let recipe: Recipe = text.parse().unwrap();
    let mut session = Session::new(recipe).unwrap();
    session.finish().unwrap();
    session
}

fn painted(session: &Session, [width, height]: [u32; 2], framing: [f32; 3]) -> Vec<u8> {
    let mut picture = Picture::new(width, height).unwrap();
    picture.frame(session, Framing::of(&framing));
    picture.paint(session);
    picture.pixmap().data().to_vec()
}

/// The bytes of a part of a picture.
fn cut(pixels: &[u8], width: usize, [left, top]: [usize; 2], [across, down]: [usize; 2]) -> Vec<u8> {
    let row = |y: usize| &pixels[((top + y) * width + left) * 4..][..across * 4];
    (0..down).flat_map(|y| row(y).to_vec()).collect()
}

/// The mean difference between the bytes of two pictures.
fn apart(one: &[u8], other: &[u8]) -> f32 {
    assert_eq!(one.len(), other.len());
    one.iter().zip(other).map(|(a, b)| u32::from(a.abs_diff(*b))).sum::<u32>() as f32 / one.len() as f32
}

#[test]
fn a_part_of_a_map_is_a_part_of_its_picture() {
    for style in styles(|_| true) {
        let session = finished(&format!("{SMALL}&aspect=2&style={style}"));
        let whole = painted(&session, [800, 400], [0.0, 0.0, 1.0]);
        let part = painted(&session, [400, 200], [0.25, 0.125, 0.5]);
        let mean = apart(&part, &cut(&whole, 800, [200, 100], [400, 200]));
        // Paper has its darker edges where the picture ends; contours that are thinner than a pixel are not wholly the
        // same.
        let most = if ["parchment", "survey", "orbit", "ink-wash", "blueprint"].contains(&style) { 8.0 } else { 0.4 };
        assert!(mean < most, "{style}: {mean} of 255 apart");
    }
}

#[test]
fn the_whole_map_framed_is_the_map() {
    for style in styles(|_| true) {
        let session = finished(&format!("{SMALL}&aspect=2&style={style}"));
        let mut picture = Picture::new(400, 200).unwrap();
        picture.paint(&session);
        // Its scale may differ in the last bit.
        let mean = apart(picture.pixmap().data(), &painted(&session, [400, 200], [0.0, 0.0, 1.0]));
        assert!(mean < 0.01, "{style}: {mean} of 255 apart");
    }
}

#[test]
fn whatever_was_shown_before_a_framed_picture_is_that_of_a_fresh_one() {
    let session = finished(&format!("{LABELLED}&style=atlas&labels=some&woods=0.5"));
    let mut picture = Picture::new(300, 200).unwrap();
    picture.paint(&session);
    let before = picture.pixmap().data().to_vec();
    let mut last = before.clone();
    for framing in [[-0.2, -0.1, 1.5], [0.4, 0.2, 0.1], [-3.0, 2.0, 0.5], [0.1, 0.1, 0.7]] {
        picture.frame(&session, Framing::of(&framing));
        picture.paint(&session);
        let now = picture.pixmap().data();
        assert!(now == painted(&session, [300, 200], framing), "{framing:?}");
        assert!(now != last, "{framing:?}");
        last = now.to_vec();
    }
    picture.frame(&session, None);
    picture.paint(&session);
    assert!(picture.pixmap().data() == before);
}

#[test]
fn a_growing_tree_is_painted_in_a_frame_as_it_is_at_once() {
    let mut session = Session::new(format!("{SMALL}&growth=colonize&meander=none").parse().unwrap()).unwrap();
    let framing = [-0.1, -0.2, 1.4];
    let mut picture = Picture::new(240, 200).unwrap();
    picture.frame(&session, Framing::of(&framing));
    while session.advance(7).unwrap() {
        picture.paint(&session);
    }
    picture.paint(&session);
    assert!(picture.pixmap().data() == painted(&session, [240, 200], framing));
}

#[test]
fn a_land_that_runs_off_the_map_ends_at_a_line_on_paper() {
    for style in styles(|style| style != Style::Skeleton) {
        let session = finished(&format!("{SMALL}&aspect=1&land=rectangle&style={style}"));
        // The map lies in the middle, from pixel 200 to 600.
        let pixels = painted(&session, [800, 800], [-0.5, -0.5, 2.0]);
        let at = |x: usize, y: usize| &pixels[(y * 800 + x) * 4..][..3];
        let lines: Vec<_> = [(400, 199), (199, 400), (400, 600), (600, 400)].map(|(x, y)| at(x, y)).to_vec();
        // Paper has a grain.
        let apart = |one: &[u8], other: &[u8]| one.iter().zip(other).map(|(a, b)| a.abs_diff(*b)).max().unwrap();
        assert!(lines.iter().all(|line| apart(line, lines[0]) < 40), "{style}: {lines:?}");
        for (line, paper) in lines.iter().zip([at(400, 150), at(150, 400), at(400, 650), at(650, 400)]) {
            assert!(apart(line, paper) > 40, "{style}: {line:?} on {paper:?}");
        }
    }
}

#[test]
fn beyond_an_island_map_there_is_sea_without_a_seam_and_beyond_land_the_map_ends() {
    for (land, is_sea) in [("island", true), ("rectangle", false)] {
        let session = finished(&format!("{SMALL}&aspect=1&land={land}&sea=0.7&style=ink"));
        // A unit of the map is 0.4 pixels; it lies in the middle.
        let pixels = painted(&session, [800, 800], [-0.5, -0.5, 2.0]);
        let at = |x: usize, y: usize| &pixels[(y * 800 + x) * 4..][..3];
        let differs = (201..600).filter(|&x| at(x, 198) != at(x, 202)).count();
        assert_eq!(differs < 40, is_sea, "{land}: {differs}");
        assert_eq!(at(3, 3), at(796, 400), "{land}: far away all is alike");
    }
}

#[test]
fn no_letter_stands_where_other_things_cover_the_picture() {
    let lettered = |framing: [f32; 7]| {
        let pixels = |labels: &str| {
            let session = finished(&format!("{LABELLED}&aspect=2&style=ink&labels={labels}"));
            let mut picture = Picture::new(800, 400).unwrap();
            picture.frame(&session, Framing::of(&framing));
            picture.paint(&session);
            picture.pixmap().data().to_vec()
        };
        let (bare, with) = (pixels("none"), pixels("many"));
        let differs = |&i: &usize| bare[i * 4..i * 4 + 4] != with[i * 4..i * 4 + 4];
        (0..800 * 400).filter(differs).map(|i| [i % 800, i / 800]).collect::<Vec<_>>()
    };
    let of_side = |place: fn(&[usize; 2]) -> bool, covered: [f32; 4]| {
        let [west, north, east, south] = covered;
        lettered([0.0, 0.0, 1.0, west, north, east, south]).iter().filter(|at| place(at)).count()
    };
    // A width of the map is 800 pixels. No halo is wider than a few.
    type Place = fn(&[usize; 2]) -> bool;
    let sides: [(Place, [f32; 4]); 4] = [
        (|at| at[0] < 390, [0.5, 0.0, 0.0, 0.0]),
        (|at| at[1] < 190, [0.0, 0.25, 0.0, 0.0]),
        (|at| at[0] > 410, [0.0, 0.0, 0.5, 0.0]),
        (|at| at[1] > 210, [0.0, 0.0, 0.0, 0.25]),
    ];
    for (place, covered) in sides {
        assert!(of_side(place, [0.0; 4]) > 100, "letters stand there else");
        assert_eq!(of_side(place, covered), 0, "{covered:?}");
    }
}

#[test]
fn framings_that_show_nothing_are_none() {
    let none: [&[f32]; 10] = [
        &[],
        &[0.0, 0.0],
        &[0.0, 0.0, 0.0],
        &[0.0, 0.0, f32::NAN],
        &[f32::INFINITY, 0.0, 1.0],
        &[0.0, f32::NAN, 1.0],
        &[0.0, 0.0, 21.0],
        &[0.0, 0.0, 1.0, 0.0],
        &[0.0, 0.0, 1.0, 0.0, 0.0, -0.1, 0.0],
        &[0.0, 0.0, 1.0, 0.0, f32::NAN, 0.0, 0.0],
    ];
    assert!(none.iter().all(|numbers| Framing::of(numbers).is_none()));
    assert!(Framing::of(&[-1.0, 1.0, 0.05]).is_some());
    assert!(Framing::of(&[-1.0, 1.0, 1.0, 0.1, 0.0, 1.0, 0.0]).is_some());
}
