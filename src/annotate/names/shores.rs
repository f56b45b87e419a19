//! Bays, gulfs, straits and capes: parts of a coast that have names.

use glam::Vec2;

use super::PlaceKind;
use super::lattice::{Lattice, SEA, SIDE, distance};
use super::regions::Found;
use crate::base::sort;
use crate::land::Land;

/// The greatest numbers of bays, gulfs, straits and capes of a map.
const MOST_BAYS: usize = 6;
const MOST_GULFS: usize = 2;
const MOST_STRAITS: usize = 4;
const MOST_CAPES: usize = 6;

/// Finds gulfs, and then bays, capes and straits, by kind, the most important of each first.
pub(super) fn found(lattice: &Lattice, land: &Land) -> [Vec<Found>; 2] {
    let views = lattice.views();
    let straits = straits(lattice, &views);
    let gulfs = enclosed(lattice, &views, PlaceKind::Gulf, land);
    let mut others = enclosed(lattice, &views, PlaceKind::Bay, land);
    let is_apart = |bay: &Found, others: &[Found]| others.iter().all(|other| bay.at.distance(other.at) > APART);
    others.retain(|bay| is_apart(bay, &gulfs) && is_apart(bay, &straits));
    others.truncate(MOST_BAYS);
    others.extend(capes(lattice));
    others.extend(straits);
    [gulfs, others]
}

/// The least distance of a bay from a gulf or a strait, in units.
const APART: f32 = 48.0;

type View = [(u16, u8); 16];

/// Finds bays or gulfs: sea that sees land near in eleven of sixteen directions at least, all others side by side, and nearly all of one
/// land.
fn enclosed(lattice: &Lattice, views: &[View], kind: PlaceKind, land: &Land) -> Vec<Found> {
    /// The distance within which land counts as near, in units, and the least area of a bay or gulf, in square units.
    const BAY: (f32, f32) = (72.0, 1000.0);
    const GULF: (f32, f32) = (190.0, 16_000.0);
    let ((near, least), most) = if kind == PlaceKind::Gulf { (GULF, MOST_GULFS) } else { (BAY, usize::MAX) };
    let class = |cell: usize| u32::from(lattice.lands[cell] == SEA && is_enclosed(&views[cell], near));
    let classes: Vec<u32> = (0..views.len()).map(class).collect();
    let mut components = lattice.components(&classes);
    components.retain(|cells| cells.len() as f32 * SIDE * SIDE >= least);
    let mut places = Vec::new();
    for i in sort::argsort(components.iter().map(|cells| u32::MAX - cells.len() as u32)) {
        let cells = &components[i];
        let size = mouth(lattice, &classes, cells);
        // Water without a mouth is the sea itself, or surrounded by land.
        if size > 0.0 && places.len() < most {
            places.push(Found { kind, at: midst(lattice, cells, land), line: Vec::new(), size });
        }
    }
    places
}

/// Returns the middle of the cell that is farthest from the coast; the last of equals.
fn midst(lattice: &Lattice, cells: &[usize], land: &Land) -> Vec2 {
    let mut midst = (Vec2::ZERO, 0.0);
    for at in cells.iter().map(|&cell| lattice.at(cell)) {
        let far = land.coast_distance().height(at).abs();
        if far >= midst.1 {
            midst = (at, far);
        }
    }
    midst.0
}

fn is_enclosed(view: &View, near: f32) -> bool {
    const LEAST: u32 = 11;
    let is_land =
        |&(direction, (land, steps)): &(usize, &(u16, u8))| *land != SEA && distance(direction, *steps) <= near;
    let bits = |of: &dyn Fn(u16) -> bool| {
        let seen = view.iter().enumerate().filter(is_land).filter(|(_, (land, _))| of(*land));
        seen.fold(0_u16, |bits, (direction, _)| bits | 1 << direction)
    };
    let all = bits(&|_| true);
    let gaps = (all & !all.rotate_left(1)).count_ones();
    let is_most = |land: u16| bits(&|other| other == land).count_ones() * 4 >= all.count_ones() * 3;
    all.count_ones() >= LEAST && gaps <= 1 && view.iter().any(|(land, _)| *land != SEA && is_most(*land))
}

/// Returns the width of the opening of a bay, in units: the larger side of the box around its cells beside open sea.
fn mouth(lattice: &Lattice, classes: &[u32], cells: &[usize]) -> f32 {
    let is_open = |cell: usize| lattice.lands[cell] == SEA && classes[cell] == 0;
    let is_mouth = |cell: usize| {
        let mut beside = [[1, 0], [0, 1], [-1, 0], [0, -1]].into_iter().filter_map(|step| lattice.from(cell, step));
        beside.any(is_open)
    };
    let (mut least, mut most) = (Vec2::MAX, Vec2::MIN);
    for at in cells.iter().filter(|&&cell| is_mouth(cell)).map(|&cell| lattice.at(cell)) {
        (least, most) = (least.min(at), most.max(at));
    }
    if least.x > most.x { 0.0 } else { (most - least).max_element() + SIDE }
}

/// Finds straits: sea with one land on one side and another on the other, near to both, and much longer than wide.
fn straits(lattice: &Lattice, views: &[View]) -> Vec<Found> {
    /// The greatest distance between the two shores of a strait, its least length, both in units, and the fewest cells of each land
    /// beside it.
    const WIDEST: f32 = 80.0;
    const SHORTEST: f32 = 56.0;
    const LEAST_LAND: u32 = 12;
    let mut cells_of = vec![0_u32; usize::from(u16::MAX) + 1];
    lattice.lands.iter().for_each(|&land| cells_of[usize::from(land)] += 1);
    let size = |land: u32| cells_of[usize::from(land as u16)];
    let class = |cell: usize| {
        let across = |direction: usize| {
            let [(one, steps), (other, others)] = [views[cell][direction], views[cell][direction + 8]];
            let width = distance(direction, steps) + distance(direction, others);
            let lands = [one.min(other), one.max(other)].map(u32::from);
            let is_strait = lands[0] != 0 && lands[0] != lands[1] && width <= WIDEST;
            is_strait.then_some((width, lands)).filter(|_| lands.map(size).into_iter().min() >= Some(LEAST_LAND))
        };
        let narrowest = (0..8).filter_map(across).min_by(|a, b| a.0.total_cmp(&b.0));
        narrowest.filter(|_| lattice.lands[cell] == SEA).map_or(0, |(_, [one, other])| one << 16 | other)
    };
    let classes: Vec<u32> = (0..views.len()).map(class).collect();
    let mut straits = Vec::new();
    for cells in lattice.components(&classes) {
        let line = lattice.spine(&cells);
        let length: f32 = line.windows(2).map(|pair| pair[0].distance(pair[1])).sum();
        let width = cells.len() as f32 * SIDE * SIDE / length.max(SIDE);
        let Some(&at) = line.get(line.len() / 2).filter(|_| length >= SHORTEST && length >= 1.4 * width) else {
            continue;
        };
        let smaller = size(classes[cells[0]] & 0xffff).min(size(classes[cells[0]] >> 16));
        straits.push((length * (smaller as f32).sqrt(), Found { kind: PlaceKind::Strait, at, line, size: length }));
    }
    best(straits, MOST_STRAITS, APART)
}

/// Finds capes: land with little of its own land around it, however far one looks.
fn capes(lattice: &Lattice) -> Vec<Found> {
    /// The radii of discs around a cape, in cells, and the greatest share of them that is land: on a straight coast it is half.
    const RADII: [i32; 4] = [4, 7, 10, 14];
    const MOST_LAND: f32 = 0.34;
    /// The least distance between two capes, in units, and the fewest cells of the land of one.
    const SPARE: f32 = 110.0;
    const LEAST_LAND: usize = 60;
    let discs = discs(RADII);
    let juts = |cell: usize| {
        let own = |step: &[i32; 2]| {
            let beside = lattice.from(cell, *step);
            // Off the map it may be land.
            beside.is_none_or(|beside| lattice.lands[beside] == lattice.lands[cell])
        };
        let (mut land, mut all, mut juts) = (0.0, 0.0, (0.0, 0.0));
        for (ring, radius) in discs.iter().zip(RADII) {
            land += ring.iter().filter(|step| own(step)).count() as f32;
            all += ring.len() as f32;
            if land > MOST_LAND * all {
                break;
            }
            // Of two that jut out as far, the sharper one.
            juts = (radius as f32 * SIDE, 1.0 - land / all);
        }
        juts
    };
    let mut lands = vec![0_usize; usize::from(u16::MAX) + 1];
    lattice.lands.iter().for_each(|&land| lands[usize::from(land)] += 1);
    let is_sea = |cell: usize| lattice.lands[cell] == SEA;
    let is_shore = |cell: usize| {
        let mut beside = [[1, 0], [0, 1], [-1, 0], [0, -1]].into_iter().filter_map(|step| lattice.from(cell, step));
        !is_sea(cell) && lands[usize::from(lattice.lands[cell])] >= LEAST_LAND && beside.any(is_sea)
    };
    let shore = (0..lattice.lands.len()).filter(|&cell| lattice.lands[cell] != u16::MAX && is_shore(cell));
    let cape = |cell: usize| {
        let (size, sharpness) = juts(cell);
        let found = Found { kind: PlaceKind::Cape, at: lattice.at(cell), line: Vec::new(), size };
        (size > 0.0).then_some((size * sharpness, found))
    };
    best(shore.filter_map(cape).collect(), MOST_CAPES, SPARE)
}

/// Returns the cells of a disc around a cell, and of the rings around the disc, every other cell of each.
fn discs<const N: usize>(radii: [i32; N]) -> [Vec<[i32; 2]>; N] {
    let mut inner = 0;
    radii.map(|radius| {
        let side = (-radius..=radius).step_by(2);
        let all = side.clone().flat_map(|south| side.clone().map(move |east| [east, south]));
        let ring =
            all.filter(|[east, south]| (inner * inner + 1..=radius * radius).contains(&(east * east + south * south)));
        let ring = ring.collect();
        inner = radius;
        ring
    })
}

/// Chooses places by a number, the greatest first, each of them at least `apart` units from all better ones.
fn best(places: Vec<(f32, Found)>, most: usize, apart: f32) -> Vec<Found> {
    let mut kept: Vec<Found> = Vec::new();
    for i in sort::argsort(places.iter().map(|(worth, _)| sort::key(-worth))) {
        let place = &places[i].1;
        if kept.len() < most && kept.iter().all(|other| other.at.distance(place.at) >= apart) {
            kept.push(place.clone());
        }
    }
    kept
}
