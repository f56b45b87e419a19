//! Promises about deltas, on whole maps.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use super::*;
use crate::base::geometry::{direction, distance, meet};
use crate::land::{Cell, Land};
use crate::map::Map;
use crate::recipe::{NumberKey, link};
use crate::session::Session;

const FEW: &[&str] = &["Thornwick", "Oriel"];
const MANY: &[&str] = &[
    "kauri",
    "Veldemar",
    "Tamsin",
    "Oriel",
    "Thornwick",
    "Oslund",
    "Greywater",
    "Valtara",
    "Isolde",
    "Lundmark",
    "Quillmere",
    "Maribel",
    "Brackenfell",
    "Pemberley",
    "Zanzara",
    "rimu",
    "Elbrand",
    "Harrowgate",
    "Calder",
    "Ysmir",
    "Ferrow",
    "Sable",
    "Winterbourne",
    "Marisco",
];

fn finished(text: &str) -> Map {
    let style = "&style=ink&labels=none";
    Session::new(link::read(&format!("{text}{style}")).unwrap()).unwrap().finish().unwrap()
}

fn arms(deltas: &Deltas, of: u32, parent: Option<u32>) -> Vec<&Distributary> {
    deltas.distributaries.iter().filter(|branch| branch.river == of && branch.parent == parent).collect()
}

fn length(branch: &Distributary) -> f32 {
    branch.line.windows(2).map(|pair| distance(pair[0].at, pair[1].at)).sum()
}

/// Checks the pairs of arms of a river's delta: their widths, angles and lengths.
fn check_splits(map: &Map, of: u32, text: &str) {
    let deltas = map.deltas();
    let trunk = map.network().middle(&map.network().rivers[of as usize])[..].iter().rev().nth(1).unwrap().half;
    let parents = deltas.distributaries.iter().filter(|branch| branch.river == of && !branch.reaches_sea);
    for parent in parents.map(Some).chain([None]) {
        let arms = arms(deltas, of, parent.map(|parent| parent.id));
        let [one, other] = arms[..] else { panic!("{text}: {} arms", arms.len()) };
        let half = parent.map_or(trunk, |parent| parent.line[0].half);
        let square = |half: f32| half * half;
        let sum = square(one.line[0].half) + square(other.line[0].half);
        assert!((sum / square(half) - 1.0).abs() < 1e-4, "{text}: {sum} of {half}");
        let way = |branch: &Distributary| direction(branch.line[1].at - branch.line[0].at);
        let angle = libm::acosf(way(one).dot(way(other))).to_degrees();
        assert!((57.0..=87.0).contains(&angle), "{text}: {angle}°");
        let longest = parent.map_or(f32::INFINITY, length);
        assert!(arms.iter().all(|arm| length(arm) <= longest + 1e-3), "{text}: longer than {longest}");
    }
}

/// Checks that no two branches meet, nor a branch and a river, but where they begin.
fn check_apart(map: &Map, text: &str) {
    let rivers = map.network();
    let branches = &map.deltas().distributaries;
    let lines: Vec<Vec<Vec2>> =
        branches.iter().map(|branch| branch.line.iter().map(|place| place.at).collect()).collect();
    let pieces = |line: &[Vec2]| line.windows(2).map(|pair| (pair[0], pair[1])).collect::<Vec<_>>();
    for (i, line) in lines.iter().enumerate() {
        // The first piece begins where others do.
        let own = &pieces(line)[1..];
        for (j, other) in lines.iter().enumerate().filter(|(j, _)| *j != i) {
            let from = usize::from(branches[j].parent == Some(i as u32));
            assert!(
                !own.iter().any(|&a| pieces(other)[from..].iter().any(|&b| meet(a, b))),
                "{text}: branches {i} and {j}"
            );
        }
        for (id, river) in rivers.rivers.iter().enumerate() {
            let course = rivers.places(river);
            assert!(
                !own.iter().any(|&a| pieces(&course).iter().any(|&b| meet(a, b))),
                "{text}: branch {i} and river {id}"
            );
        }
    }
}

fn check(word: &str, more: &str) -> [usize; 2] {
    let text = format!("seed={word}&{more}");
    let map = finished(&text);
    let land = map.land().unwrap();
    let deltas = map.deltas();
    for branch in deltas.distributaries.iter().filter(|branch| branch.reaches_sea) {
        let tip = branch.line.last().unwrap().at;
        assert!(land.coast_distance().height(tip) <= 0.5, "{text}: a tip {} inland", land.coast_distance().height(tip));
    }
    for delta in &deltas.list {
        check_splits(&map, delta.river, &text);
        let tips =
            deltas.distributaries.iter().filter(|branch| branch.river == delta.river && branch.reaches_sea).count();
        assert!(tips >= 3 && delta.area > 0.0 && !delta.rings.is_empty(), "{text}: {tips} tips");
    }
    check_apart(&map, &text);
    for id in map.network().mouths().into_iter().filter(|id| deltas.list.iter().all(|delta| delta.river != *id)) {
        let mouth = map.network().vertices[map.network().rivers[id as usize].end as usize - 1].at;
        let inland = land.coast_distance().height(mouth);
        assert!(inland < 3.0, "{text}: river {id} ends {inland} inland");
    }
    let sea = map.recipe().number(NumberKey::Sea);
    assert!(sea == 0.0 || (land.share_of_sea() - sea).abs() < 0.01, "{text}: {} of {sea}", land.share_of_sea());
    of_great_mouths(&map)
}

/// Counts the deltas, and the mouths wider than a twelfth of the widest, of a map's twelve greatest mouths.
fn of_great_mouths(map: &Map) -> [usize; 2] {
    let network = map.network();
    let width = |id: u32| network.vertices[network.rivers[id as usize].end as usize - 1].width();
    let mut widths: Vec<f32> = network.mouths().into_iter().map(width).collect();
    widths.sort_by(|a, b| b.total_cmp(a));
    let wide = widths.iter().take(RIVERS).filter(|far| **far > widths[0] / 12.0).count();
    [map.deltas().list.len(), wide]
}

#[test]
fn deltas_of_a_few_words_are_sound() {
    let all = FEW.iter().map(|word| check(word, "deltas=0.6")).fold([0, 0], |a, b| [a[0] + b[0], a[1] + b[1]]);
    assert!(all[0] > 1, "{all:?}");
}

#[test]
#[ignore = "slow"]
fn deltas_of_many_words_are_sound_and_as_many_as_in_nature() {
    let all = MANY.iter().map(|word| check(word, "deltas=0.4")).fold([0, 0], |a, b| [a[0] + b[0], a[1] + b[1]]);
    let share = all[0] as f32 / all[1] as f32;
    assert!((0.25..=0.55).contains(&share), "{all:?}: {share}");
}

#[test]
fn without_sediment_there_are_no_deltas_and_waves_change_nothing() {
    let [one, other] =
        ["0", "1"].map(|waves| finished(&format!("seed=Thornwick&deltas=0&waves={waves}&attractors=4000")));
    assert!(one.deltas().is_empty() && one.network() == other.network() && one.land() == other.land());
}

#[test]
fn a_change_of_sediment_leads_to_the_map_that_a_new_session_makes() {
    let recipe = |deltas: &str| {
        link::read(&format!("seed=Oriel&style=ink&labels=none&attractors=4000&deltas={deltas}")).unwrap()
    };
    let mut session = Session::new(recipe("0.6")).unwrap();
    session.finish().unwrap();
    for deltas in ["0", "0.5", "0.6"] {
        session.change(recipe(deltas)).unwrap();
        let changed = session.finish().unwrap();
        let fresh = Session::new(recipe(deltas)).unwrap().finish().unwrap();
        assert!(changed.land() == fresh.land() && changed.network() == fresh.network(), "{deltas}");
        assert_eq!(changed.deltas(), fresh.deltas(), "{deltas}");
    }
}

#[test]
fn land_of_deltas_is_land() {
    let map = finished("seed=Thornwick&deltas=0.6");
    let land: &Land = map.land().unwrap();
    for branch in &map.deltas().distributaries {
        let middle = branch.line[branch.line.len() / 2].at;
        assert_ne!(land.at(middle), Cell::Water, "branch {} of river {}", branch.id, branch.river);
    }
}

#[test]
fn a_changed_session_is_painted_as_a_new_one() {
    use crate::picture::Picture;
    let recipe = |more: &str| {
        let usual = "seed=kauri&country=usual&land=island&drowning=0.6&attractors=800&style=ink&labels=none";
        let width = if more.contains("width") { "" } else { "&width=24" };
        link::read(&format!("{usual}&{more}{width}")).unwrap()
    };
    // As a page does: it shows what there is while a hand moves, in every `every`-th step, as a draft, which may be whole or
    // begun, and then as it is.
    let painted = |picture: &mut Picture, session: &mut Session, every: usize| {
        for step in 0_usize.. {
            if !session.advance(1).unwrap() {
                break;
            }
            let recipe = session.recipe().clone();
            if step.is_multiple_of(every) {
                let _ = picture.paint_draft(session, &recipe);
                picture.paint(session);
            }
        }
        picture.paint(session);
        picture.pixmap().data().to_vec()
    };
    let new = || Picture::new(900, 600).unwrap();
    let (mut picture, mut session) = (new(), Session::new(recipe("deltas=0.7")).unwrap());
    picture.frame(&session, None);
    painted(&mut picture, &mut session, 1);
    for more in ["deltas=0.7&waves=0.9", "deltas=0.7", "deltas=0.7&width=12", "deltas=0.3", "deltas=0"] {
        let (mut other, mut fresh) = (new(), Session::new(recipe(more)).unwrap());
        fresh.finish().unwrap();
        other.frame(&fresh, None);
        let expected = painted(&mut other, &mut fresh, 1);
        for every in [1, 1000] {
            session.change(recipe("deltas=0.7&waves=0.2")).unwrap();
            painted(&mut picture, &mut session, 1);
            session.change(recipe(more)).unwrap();
            let changed = painted(&mut picture, &mut session, every);
            assert!(changed == expected, "{more}, every {every}");
        }
    }
}
