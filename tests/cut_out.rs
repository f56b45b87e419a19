//! Pictures without their ground, and the progress of a picture.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use crate::common::styles;
use riverseed::domain::Domain;
use riverseed::paint::{Painted, View};
use riverseed::{Picture, Recipe, Session};

const BARE: &str = "country=usual&seed=skye&attractors=1500&land=island&labels=none";
const NAMED: &str = "country=usual&seed=skye&attractors=1500&land=island&labels=many&cartouche=framed";

fn finished(text: &str) -> Session {
    let recipe: Recipe = text.parse().unwrap();
    let mut session = Session::new(recipe).unwrap();
    session.finish().unwrap();
    session
}

/// The pixels of a picture, before and after its ground is taken out.
fn both(session: &Session) -> [Vec<[u8; 4]>; 2] {
    let mut picture = Picture::new(480, 300).unwrap();
    picture.paint(session);
    let pixels = |picture: &Picture| picture.pixmap().data().as_chunks().0.to_vec();
    let before = pixels(&picture);
    picture.cut_out(session);
    let after = pixels(&picture);
    picture.paint(session);
    assert!(pixels(&picture) == before, "painted again, it is whole");
    [before, after]
}

fn share(pixels: &[[u8; 4]], is: impl Fn(&[u8; 4]) -> bool) -> f32 {
    pixels.iter().filter(|pixel| is(pixel)).count() as f32 / pixels.len() as f32
}

#[test]
fn without_its_sea_a_map_has_its_land_as_it_is() {
    for style in styles(|style| style.has_relief() || style.has_beds()) {
        let [before, after] = both(&finished(&format!("{BARE}&style={style}")));
        let (sea, land) = (share(&after, |pixel| pixel[3] == 0), share(&after, |pixel| pixel[3] == 255));
        assert!(sea > 0.2 && land > 0.2, "{style}: {sea} and {land}");
        // What lies between is the rim of the coast.
        assert!(sea + land > 0.95, "{style}: {sea} and {land}");
        // Corners are sea.
        assert_eq!([after[0], after[after.len() - 1]], [[0; 4]; 2], "{style}");
        let kept = before.iter().zip(&after).filter(|(_, after)| after[3] == 255);
        let most = kept.map(|(before, after)| (0..3).map(|i| before[i].abs_diff(after[i])).max().unwrap()).max();
        assert!(most.unwrap() <= 2, "{style}: {most:?}");
    }
}

#[test]
fn names_at_sea_stay() {
    let sea = |recipe: &str| share(&both(&finished(recipe))[1], |pixel| pixel[3] == 0);
    let (bare, named) = (sea(BARE), sea(NAMED));
    assert!(bare - named > 0.002, "{bare} and {named}");
}

#[test]
fn without_its_paper_a_drawing_has_its_lines_alone() {
    // Between the banks of ink's rivers there is water, which is taken out like the paper.
    let papers = [
        ("ink", [[0xf6u8, 0xf0, 0xe2], [0xdd, 0xe6, 0xe4]]),
        ("dark", [[0x16, 0x1f, 0x2b]; 2]),
        ("skeleton", [[0; 3]; 2]),
    ];
    for (style, papers) in papers {
        for land in ["island", "rectangle"] {
            let [before, after] = both(&finished(&NAMED.replace("island", &format!("{land}&style={style}"))));
            let (bare, drawn) = (share(&after, |pixel| pixel[3] == 0), share(&after, |pixel| pixel[3] > 128));
            assert!(bare > 0.4 && drawn > 0.007, "{style}, {land}: {bare} and {drawn}");
            if land == "island" {
                continue;
            }
            // Laid on its paper again it is what it was.
            let apart = |pixel: &[u8; 4], before: &[u8; 4], paper: [u8; 3]| {
                let [parts @ .., opacity] = pixel.map(u32::from);
                let back = |i: usize| ((parts[i] * opacity + u32::from(paper[i]) * (255 - opacity) + 127) / 255) as u8;
                (0..3).map(|i| back(i).abs_diff(before[i])).max().unwrap()
            };
            let nearest = |(after, before)| papers.map(|paper| apart(after, before, paper)).into_iter().min().unwrap();
            let most = after.iter().zip(&before).map(nearest).max().unwrap();
            assert!(most <= 2, "{style}: {most}");
        }
    }
}

#[test]
fn a_picture_says_how_far_it_is() {
    for recipe in [
        "country=usual&seed=skye&attractors=300&style=atlas",
        "country=usual&seed=skye&attractors=300&style=ink&land=island",
        "country=usual&seed=skye&attractors=300&style=ink&land=rectangle",
    ] {
        let session = finished(recipe);
        let mut picture = Picture::new(1600, 1000).unwrap();
        let mut told = vec![picture.progress(&session)];
        while picture.paint_part(&session) == Painted::Part {
            told.push(picture.progress(&session));
        }
        told.push(picture.progress(&session));
        assert!(told.is_sorted(), "{recipe}: {told:?}");
        assert_eq!((told[0], told[told.len() - 1]), (0.0, 1.0), "{recipe}");
    }
}

#[test]
fn the_longer_side_of_a_picture_is_the_one_that_is_asked_for() {
    for aspect in [0.25, 0.75, 1.0, 1.5, 1.6, 4.0] {
        let (width, height) = View::sides_for(&Domain::with_aspect(aspect), 4961);
        assert_eq!(width.max(height), 4961, "{aspect}");
        assert!((width as f32 / height as f32 / aspect - 1.0).abs() < 1e-3, "{aspect}: {width} x {height}");
    }
}
