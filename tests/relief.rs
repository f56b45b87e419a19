//! Relief: every river falls, all water finds the sea, and nothing else affects it.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use std::sync::Arc;

use crate::common::lands::every_land;
use crate::common::property::large;
use crate::common::random_link;
use crate::common::tier::{first, one_in, pairs, tiers};
use glam::Vec2;
use proptest::prelude::*;
use riverseed::analyse::proof::{Breach, falls};
use riverseed::export::svg;
use riverseed::network::NONE;
use riverseed::picture::Picture;
use riverseed::recipe::{Key, link};
use riverseed::relief::Grid;
use riverseed::relief::{CELL_SIZE, Relief};
use riverseed::scale::USUAL_METRES;
use riverseed::session::{Phase, Session};

fn finished(text: &str) -> Session {
    let mut session = Session::new(link::read(text).unwrap()).unwrap();
    session.finish().unwrap();
    session
}

fn relief(session: &Session) -> &Relief {
    session.relief().unwrap()
}

/// The cells around one, those beyond the map left out.
fn around(relief: &Relief, cell: usize) -> Vec<usize> {
    let (columns, rows) = (relief.columns(), relief.rows());
    let near = |i: usize, count: usize| i.saturating_sub(1)..=(i + 1).min(count - 1);
    let (column, row) = (cell % columns, cell / columns);
    near(row, rows)
        .flat_map(|row| near(column, columns).map(move |column| row * columns + column))
        .filter(|&beside| beside != cell)
        .collect()
}

/// Returns `true` if the sea lies beyond the border of the map at a cell.
fn leaves_the_map(session: &Session, relief: &Relief, cell: usize) -> bool {
    let sides = session.recipe().sides();
    let (column, row) = (cell % relief.columns(), cell / relief.columns());
    let is_at =
        [('w', column == 0), ('e', column + 1 == relief.columns()), ('n', row == 0), ('s', row + 1 == relief.rows())];
    let has_starts = !session.recipe().rivers().is_empty();
    session.land().is_none() && is_at.into_iter().any(|(side, is_at)| is_at && (has_starts || sides.contains(side)))
}

/// The cells of land that have no lower neighbour and no sea beside them.
fn pits(session: &Session, relief: &Relief) -> Vec<usize> {
    let heights = relief.heights();
    let is_pit = |&cell: &usize| {
        heights[cell] > 0.0
            && !leaves_the_map(session, relief, cell)
            && around(relief, cell).into_iter().all(|beside| heights[beside] >= heights[cell])
    };
    (0..heights.len()).filter(is_pit).collect()
}

/// The places where rivers do not fall from one cell of their ways to a later one.
fn climbs(session: &Session, relief: &Relief) -> Vec<Breach> {
    falls(session.network().unwrap(), relief).breaches
}

proptest! {
    #![proptest_config(first(2, large(160)))]

    fn no_land_is_a_pit_and_no_river_climbs(text in random_link(2500)) {
        let mut recipe = link::read(&text).unwrap();
        recipe.set(Key::Style, "atlas").unwrap();
        let mut session = Session::new(recipe).unwrap();
        session.finish().unwrap();
        prop_assert_eq!(pits(&session, relief(&session)), Vec::<usize>::new());
        prop_assert_eq!(climbs(&session, relief(&session)), vec![]);
        prop_assert!(relief(&session).heights().iter().all(|height| height.is_finite()));
    }
}

tiers!(no_land_is_a_pit_and_no_river_climbs);

const GROWTHS: [&str; 3] = ["drainage", "colonize", "brownian&sensitivity=24"];

fn no_land_of_usual_maps_is_a_pit() {
    for (land, growth) in one_in(7, pairs(every_land(), GROWTHS)) {
        let session = finished(&format!("country=usual&seed=kea&{land}&growth={growth}&attractors=3000&style=night"));
        let relief = relief(&session);
        assert_eq!((pits(&session, relief), climbs(&session, relief)), (vec![], vec![]), "{land}, {growth}");
    }
}

tiers!(no_land_of_usual_maps_is_a_pit);

/// The relief of a session on a finer grid, with a number of cells on the longer side.
fn finer(session: &Session, cells: u32) -> Relief {
    let mut settings = session.map().unwrap().relief_settings();
    settings.grid = Grid::with_longer_side(&settings.domain, cells).unwrap();
    let own = session.map().unwrap().make_relief().unwrap();
    own.on_grid_of(session.network().unwrap(), settings).unwrap()
}

proptest! {
    #![proptest_config(first(1, large(40)))]

    fn no_land_is_a_pit_and_no_river_climbs_on_finer_grids(text in random_link(1500), times in 1.01f32..4.0) {
        let session = finished(&text);
        let own = *Grid::sizes(&session.domain()).start();
        let finer = finer(&session, ((own as f32 * times) as u32).min(2400));
        prop_assert_eq!(pits(&session, &finer), Vec::<usize>::new());
        prop_assert_eq!(climbs(&session, &finer), vec![]);
        prop_assert!(finer.heights().iter().all(|height| height.is_finite()));
    }
}

tiers!(no_land_is_a_pit_and_no_river_climbs_on_finer_grids);

fn no_land_of_usual_maps_is_a_pit_on_finer_grids() {
    let maps = pairs(every_land(), GROWTHS).map(|(land, growth)| format!("{land}&growth={growth}&attractors=3000"));
    let maps = maps.zip([700, 1025, 1500, 1025, 1500, 700, 1500, 700, 1025].into_iter().cycle());
    // The last is the largest, on a map that is small there.
    for (link, cells) in one_in(14, maps.chain([("aspect=4&attractors=2000".into(), Grid::MOST)])) {
        let session = finished(&format!("country=usual&seed=kea&{link}"));
        let finer = finer(&session, cells);
        assert_eq!(finer.columns().max(finer.rows()), cells as usize);
        assert_eq!((pits(&session, &finer), climbs(&session, &finer)), (vec![], vec![]), "{link}");
    }
}

tiers!(no_land_of_usual_maps_is_a_pit_on_finer_grids);

/// The share of some values that is greater than a bound.
fn share_above(values: &[f32], bound: f32) -> f32 {
    values.iter().filter(|value| **value > bound).count() as f32 / values.len() as f32
}

fn finer_grids_keep_the_heights_of_rivers_and_the_shape_of_the_land() {
    let texts = [
        ("country=usual&seed=kea&sea=0.55&attractors=1500", 1000),
        ("country=usual&seed=kea&growth=colonize&land=rectangle&attractors=3000", 2000),
    ];
    for (text, cells) in one_in(2, texts) {
        let session = finished(text);
        let (own, finer) = (session.map().unwrap().make_relief().unwrap(), finer(&session, cells));
        let highest = own.quantile(0.99);
        let network = session.network().unwrap();
        let rivers = network.vertices.iter().filter(|vertex| own.at(vertex.at) > 0.0);
        let off: Vec<f32> =
            rivers.map(|vertex| (finer.at(vertex.at) - own.at(vertex.at)).abs() * USUAL_METRES).collect();
        // Within the fall of a cell or two, rivers having no stairs of cells here; lower where they would stand on
        // dams.
        let [near, far, farthest] = [12.0, 31.0, 90.0].map(|metres| share_above(&off, metres));
        assert!(off.len() > 1000 && near < 0.1 && far < 0.025 && farthest < 0.01, "{text}: {near}, {far}, {farthest}");
        let rises = network.vertices.iter().map(|vertex| (finer.at(vertex.at) - own.at(vertex.at)) / highest);
        let most = rises.fold(0.0, f32::max);
        // A bed that lies below the ground at its sides may fall by more from one cell to the next.
        assert!(most < 0.015, "{text}: a river is {most} higher");
        let land = own.heights().iter().enumerate().filter(|(_, height)| **height > 0.0).map(|(cell, height)| {
            let at = Vec2::new((cell % own.columns()) as f32, (cell / own.columns()) as f32) + 0.5;
            (finer.at(at * CELL_SIZE) - height).abs() / highest
        });
        // Fast marching of the first order is a little too high, the more so the larger cells are.
        let land: Vec<f32> = land.collect();
        let (two, five) = (share_above(&land, 0.02), share_above(&land, 0.05));
        assert!(two < 0.15 && five < 0.01, "{text}: {two} and {five} of the land are elsewhere");
    }
}

tiers!(finer_grids_keep_the_heights_of_rivers_and_the_shape_of_the_land);

#[test]
fn relief_is_made_for_finished_rivers_and_kept_while_only_the_look_changes() {
    const ATLAS: &str = "country=usual&seed=kea&mouths=3&attractors=3000";
    let with = |change: &str| {
        let mut recipe = link::read(ATLAS).unwrap();
        for pair in "attractors=1500&style=atlas".split('&').chain(change.split('&')).filter(|pair| !pair.is_empty()) {
            let (key, value) = pair.split_once('=').unwrap();
            recipe.set(Key::from_name(key).unwrap(), value).unwrap();
        }
        recipe
    };
    let mut session = Session::new(with("")).unwrap();
    let mut steps = 0;
    while session.advance(1).unwrap() {
        assert!(session.relief().is_none(), "before all rivers are finished");
        steps += usize::from(session.phase() == Phase::Relief);
    }
    assert!(steps > 10, "in {steps} steps");
    let first = session.relief().unwrap().clone();
    for change in ["style=night", "style=atlas&shade=1", "style=ink", "style=atlas"] {
        session.change(with(change)).unwrap();
        session.finish().unwrap();
        let shown = session.relief();
        assert_eq!(shown.is_none(), change == "style=ink", "{change}");
        assert!(shown.is_none_or(|relief| Arc::ptr_eq(relief, &first)), "{change}");
    }
    for change in ["mountains=3", "plains=50", "width=20", "trim=40", "attractors=1400", "sea=0.3"] {
        session.change(with(change)).unwrap();
        assert!(session.relief().is_none(), "{change}");
        session.finish().unwrap();
        assert!(*relief(&session) != *first, "{change}");
        let mut fresh = Session::new(with(change)).unwrap();
        fresh.finish().unwrap();
        assert!(relief(&session) == relief(&fresh), "{change}");
    }
    assert!(finished("country=usual&seed=kea&attractors=300&style=ink").relief().is_none(), "ink shows none");
}

/// Ink once showed the relief of the atlas before it.
fn after_a_change_of_style_everything_is_as_of_a_fresh_recipe() {
    let painted = |session: &Session| {
        let mut picture = Picture::new(120, 80).unwrap();
        picture.paint(session);
        (picture.pixmap().data().to_vec(), svg::svg(&session.map().unwrap()).unwrap())
    };
    let chains: [(&str, &[&str]); 3] = [
        ("island", &["ink", "atlas"]),
        ("island", &["night", "skeleton", "dark", "atlas"]),
        ("rectangle", &["ink", "night", "skeleton", "dark", "atlas"]),
    ];
    for (land, styles) in one_in(3, chains) {
        let with = |style: &str| {
            link::read(&format!("country=usual&seed=kea&land={land}&attractors=900&style={style}")).unwrap()
        };
        let mut session = Session::new(with("atlas")).unwrap();
        session.finish().unwrap();
        for style in styles {
            session.change(with(style)).unwrap();
            session.finish().unwrap();
            let mut fresh = Session::new(with(style)).unwrap();
            fresh.finish().unwrap();
            assert!(painted(&session) == painted(&fresh), "{land}, {style}");
        }
    }
}

tiers!(after_a_change_of_style_everything_is_as_of_a_fresh_recipe);

#[test]
fn between_neighbours_no_step_is_higher_than_a_hillside_rises() {
    // With slopes of at most e to the 2.2 times that of mountains; banks of rivers are not looked at.
    let session = finished("country=usual&seed=kea&attractors=3000&style=atlas");
    let (relief, network) = (relief(&session), session.network().unwrap());
    let mut is_river = vec![false; relief.heights().len()];
    for river in network.rivers.iter() {
        let course: Vec<_> = network.course(river).map(|vertex| vertex.at).collect();
        for pair in course.windows(2) {
            for i in 0..=8 {
                let at = pair[0].lerp(pair[1], i as f32 / 8.0) / CELL_SIZE;
                is_river[(at.y as usize).min(relief.rows() - 1) * relief.columns()
                    + (at.x as usize).min(relief.columns() - 1)] = true;
            }
        }
        assert!(river.junction == NONE || river.parent != NONE);
    }
    let most = CELL_SIZE * 1.5 * libm::expf(2.2);
    for (cell, &height) in relief.heights().iter().enumerate().filter(|(_, height)| **height > 0.0) {
        for beside in [cell + 1, cell + relief.columns()] {
            let Some(&other) = relief.heights().get(beside).filter(|height| **height > 0.0) else { continue };
            let is_bank = is_river[cell] || is_river[beside];
            assert!(
                is_bank || (height - other).abs() <= most || beside % relief.columns() == 0,
                "{height} and {other}"
            );
        }
    }
}

/// The power of the shading of a relief along the axes of its grid, over that along the diagonals, for waves of 2 to 8
/// cells in windows of land: streaks along rows and columns have more than their share.
fn streaks(relief: &Relief) -> f64 {
    const SIDE: usize = 64;
    let (columns, rows, heights) = (relief.columns(), relief.rows(), relief.heights());
    let is_land = |left: usize, top: usize| {
        (top..top + SIDE + 2).all(|row| heights[row * columns + left..][..SIDE + 2].iter().all(|height| *height > 0.0))
    };
    let turn = |i: usize| libm::sincos(std::f64::consts::TAU * (i % SIDE) as f64 / SIDE as f64);
    let window = |i: usize| 0.5 - 0.5 * libm::cos(std::f64::consts::TAU * (i as f64 + 0.5) / SIDE as f64);
    let (mut axes, mut diagonals) = (0.0, 0.0);
    for top in (0..rows.saturating_sub(SIDE + 2)).step_by(SIDE / 2) {
        for left in (0..columns.saturating_sub(SIDE + 2)).step_by(SIDE / 2) {
            if !is_land(left, top) {
                continue;
            }
            // Lit from the north-west, so that both diagonals together are as bright as both axes.
            let light = |i: usize| {
                let cell = (top + 1 + i / SIDE) * columns + left + 1 + i % SIDE;
                let [east, south] = [1, columns].map(|far| f64::from(heights[cell + far] - heights[cell - far]) / 4.0);
                (east + south) / (1.0 + east * east + south * south).sqrt() * window(i % SIDE) * window(i / SIDE)
            };
            let light: Vec<f64> = (0..SIDE * SIDE).map(light).collect();
            for across in 0..SIDE {
                // Transformed along rows, then down the columns.
                let along = |row: usize| {
                    light[row * SIDE..][..SIDE].iter().enumerate().fold((0.0, 0.0), |sum, (i, light)| {
                        let (sin, cos) = turn(across * i);
                        (sum.0 + light * cos, sum.1 - light * sin)
                    })
                };
                let along: Vec<(f64, f64)> = (0..SIDE).map(along).collect();
                for down in 0..SIDE {
                    let signed = |i: usize| if i > SIDE / 2 { i as f64 - SIDE as f64 } else { i as f64 };
                    let (x, y) = (signed(across), signed(down));
                    let angle = libm::atan2(y, x).to_degrees().rem_euclid(90.0);
                    if !(8.0..=30.0).contains(&libm::hypot(x, y)) {
                        continue;
                    }
                    let sum = along.iter().enumerate().fold((0.0, 0.0), |sum, (row, value)| {
                        let (sin, cos) = turn(down * row);
                        (sum.0 + value.0 * cos + value.1 * sin, sum.1 + value.1 * cos - value.0 * sin)
                    });
                    let power = sum.0 * sum.0 + sum.1 * sum.1;
                    axes += if !(4.0..=86.0).contains(&angle) { power } else { 0.0 };
                    diagonals += if (angle - 45.0).abs() < 4.0 { power } else { 0.0 };
                }
            }
        }
    }
    axes / diagonals
}

/// On land with few rivers, whose hillsides are long, relief once was full of streaks: the median was 1.4.
#[test]
fn the_grid_does_not_show_in_the_relief() {
    let seeds = ["kauri", "rimu", "skye", "tay", "orinoco", "mara", "totara"];
    let streaks = |seed: &&str| {
        streaks(relief(&finished(&format!(
            "country=usual&seed={seed}&land=continent&sea=0.35&attractors=300&style=atlas"
        ))))
    };
    let mut values: Vec<f64> = seeds.iter().map(streaks).collect();
    values.sort_by(f64::total_cmp);
    println!("{values:?}");
    assert!(values[values.len() / 2] < 1.2, "{values:?}");
}
