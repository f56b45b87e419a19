//! Lakes along rivers: each is level, has one outlet, touches no other and no sea, and water runs down everywhere else. Together
//! they are as many and as indented as those of nature.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use crate::common::tier::{one_in, tiers};
use riverseed::map::Map;
use riverseed::relief::{Flow, Relief};
use riverseed::{Recipe, Session};

/// Words, each in a country of its own, and links with many lakes.
const LINKS: [&str; 6] = [
    "seed=kauri",
    "seed=Veldemar",
    "seed=saimaa&country=lakeland",
    "seed=Oriel&country=young-land",
    "seed=weka&growth=colonize&country=usual&lakes=0.5",
    "seed=moa&land=rectangle&lakes=0.6",
];

fn map(link: &str) -> Map {
    Session::new(link.parse().unwrap()).unwrap().finish().unwrap()
}

/// The lakes of a map, cell by cell.
struct Found {
    map: Map,
    relief: std::sync::Arc<Relief>,
    flow: Flow,
    /// The lake of each cell; `u32::MAX` for none.
    lakes: Vec<u32>,
    surface: Vec<f32>,
}

const NONE: u32 = u32::MAX;

impl Found {
    fn of(link: &str) -> Self {
        let map = map(link);
        let relief = map.make_relief().unwrap();
        let flow = Flow::new(&relief, map.network(), &map.relief_settings()).unwrap();
        let (lakes, surface) = (map.lakes().on(&relief.grid()), map.lakes().surface(&relief));
        Self { map, relief, flow, lakes, surface }
    }

    fn next(&self, cell: usize) -> Option<usize> {
        self.flow.next(&self.relief.grid(), cell)
    }

    /// Lists the cells around one, at most so many columns and rows away.
    fn around(&self, cell: usize, far: isize) -> Vec<usize> {
        let (columns, rows) = (self.relief.columns() as isize, self.relief.rows() as isize);
        let (column, row) = (cell as isize % columns, cell as isize / columns);
        let steps = || -far..=far;
        let all = steps().flat_map(|down| steps().map(move |east| (column + east, row + down)));
        let inside = all.filter(|(x, y)| (0..columns).contains(x) && (0..rows).contains(y));
        inside.map(|(x, y)| (y * columns + x) as usize).collect()
    }

    fn check(&self, link: &str) {
        assert!(!self.map.lakes().is_empty(), "{link}");
        let mut outlets = vec![0; self.map.lakes().list.len()];
        for (cell, &lake) in self.lakes.iter().enumerate() {
            let next = self.next(cell);
            let is_same = next.is_some_and(|next| lake != NONE && self.lakes[next] == lake);
            if let Some(next) = next.filter(|_| !is_same) {
                assert!(self.surface[next] < self.surface[cell], "{link}: a pit at {cell}");
            }
            if lake == NONE {
                continue;
            }
            outlets[lake as usize] += usize::from(!is_same);
            let level = self.map.lakes().list[lake as usize].level;
            assert_eq!(self.surface[cell].to_bits(), level.to_bits(), "{link}: a lake is not level");
            for beside in self.around(cell, 2) {
                assert!(self.lakes[beside] == NONE || self.lakes[beside] == lake, "{link}: two lakes touch");
                assert!(
                    self.relief.heights()[beside] > 0.0 || !self.around(cell, 1).contains(&beside),
                    "{link}: the sea"
                );
            }
        }
        assert!(outlets.iter().all(|outlets| *outlets == 1), "{link}: {outlets:?}");
    }
}

#[test]
fn lakes_are_level_and_apart_and_have_one_outlet() {
    for link in LINKS {
        Found::of(link).check(link);
    }
}

fn lakes_are_level_and_apart_on_many_maps() {
    for i in one_in(25, 0..200) {
        let link = format!("seed=lake-{i}&lakes=0.6");
        let found = Found::of(&link);
        if !found.map.lakes().is_empty() {
            found.check(&link);
        }
    }
}

tiers!(lakes_are_level_and_apart_on_many_maps);

#[test]
fn rivers_run_through_their_lakes_and_leave_them_at_the_outlet() {
    let map = map("seed=saimaa&country=lakeland");
    let (network, lakes) = (map.network(), map.lakes());
    for lake in &lakes.list {
        let river = &network.rivers[lake.outlet.river as usize];
        assert!(river.vertex_range().contains(&(lake.outlet.vertex as usize)));
    }
    let passages: usize = network.rivers.iter().map(|river| lakes.passages(network, river).len()).sum();
    assert!(passages >= lakes.list.len(), "{passages} passages of {} lakes", lakes.list.len());
}

#[test]
fn without_lakes_a_map_is_as_it_was() {
    let with = map("seed=kauri&lakes=0.5&style=ink");
    let without = map("seed=kauri&lakes=0&style=ink");
    assert!(without.lakes().is_empty() && without.relief().is_none(), "nobody needs a relief");
    assert_eq!(with.network(), without.network(), "lakes are the last to come");
    assert_eq!(with.make_relief(), without.make_relief());
}

#[test]
fn lakes_follow_their_parameter_on_the_same_relief() {
    let mut session = Session::new("seed=kauri&lakes=0.5".parse().unwrap()).unwrap();
    session.finish().unwrap();
    let relief = session.relief().unwrap().clone();
    let other: Recipe = "seed=kauri&lakes=0.2".parse().unwrap();
    session.change(other).unwrap();
    let changed = session.finish().unwrap();
    assert!(std::sync::Arc::ptr_eq(&relief, session.relief().unwrap()));
    assert_eq!(changed.lakes(), map("seed=kauri&lakes=0.2").lakes());
}

/// Pooled lakes of 24 maps: the exponent of their areas, and the dimension of their shores, both by the rank and the area-perimeter
/// relations of Cael and Seekell (2016), who find 2.14 and 1.4 in nature.
#[test]
#[ignore = "second tier"]
fn lakes_are_as_many_and_as_indented_as_in_nature() {
    let (mut areas, mut shores, mut asked) = (Vec::new(), Vec::new(), Vec::new());
    for i in 0..24 {
        let map = map(&format!("seed=lakes-{i}&country=lakeland"));
        let land: f32 =
            map.make_relief().unwrap().heights().iter().filter(|height| **height > 0.0).count() as f32 * 4.0;
        let lakes = &map.lakes().list;
        asked.push(lakes.iter().map(|lake| lake.area).sum::<f32>() / (0.7 * 0.12 * land));
        for lake in lakes.iter().filter(|lake| lake.area >= 80.0) {
            let ring = &lake.rings[0];
            let length: f32 = ring.iter().zip(ring.iter().cycle().skip(1)).map(|(a, b)| a.distance(*b)).sum();
            areas.push(f64::from(lake.area));
            shores.push((libm::log(f64::from(lake.area)), libm::log(f64::from(length))));
        }
    }
    // The estimate of greatest likelihood for areas from 80 square units on.
    let tau = 1.0 + areas.len() as f64 / areas.iter().map(|area| libm::log(area / 80.0)).sum::<f64>();
    let mean = |of: fn(&(f64, f64)) -> f64| shores.iter().map(of).sum::<f64>() / shores.len() as f64;
    let (x, y) = (mean(|pair| pair.0), mean(|pair| pair.1));
    let slope = shores.iter().map(|pair| (pair.0 - x) * (pair.1 - y)).sum::<f64>()
        / shores.iter().map(|pair| (pair.0 - x) * (pair.0 - x)).sum::<f64>();
    let dimension = 2.0 * slope;
    asked.sort_by(f32::total_cmp);
    println!("{} lakes, tau {tau:.2}, dimension {dimension:.2}, area of asked {asked:?}", areas.len());
    assert!((1.9..=2.4).contains(&tau), "{tau}");
    assert!((1.2..=1.5).contains(&dimension), "{dimension}");
    assert!((0.75..=1.25).contains(&asked[asked.len() / 2]), "{asked:?}");
}
