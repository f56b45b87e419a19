//! Land from a mask equals the mask and stays as it is.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use std::sync::Arc;

use crate::common::tier::{one_in, tiers};
use fastnoise_lite::{FastNoiseLite, FractalType};
use glam::Vec2;
use riverseed::domain::Domain;
use riverseed::land::trace::{TraceError, trace};
use riverseed::land::{Cell, DrawError, Land};
use riverseed::recipe::{Stage, link};
use riverseed::session::{Session, SessionError};
use riverseed::{Key, Picture, Recipe, export};

/// A mask with the domain that it fills.
struct Mask {
    width: usize,
    height: usize,
    is_land: Vec<bool>,
    domain: Domain,
}

impl Mask {
    /// An island with a coast that is rough at every scale, down to a few pixels.
    fn rough(width: usize, height: usize, seed: i32) -> Self {
        Self::with_octaves(width, height, seed, 7)
    }

    /// Makes a rough island; with fewer octaves it is smoother.
    fn with_octaves(width: usize, height: usize, seed: i32, octaves: i32) -> Self {
        let mut noise = FastNoiseLite::with_seed(seed);
        noise.set_fractal_type(Some(FractalType::FBm));
        noise.set_fractal_octaves(Some(octaves));
        noise.set_fractal_gain(Some(0.6));
        noise.set_frequency(Some(2.0));
        let size = Vec2::new(width as f32, height as f32);
        let is_land = |i: usize| {
            let at = (Vec2::new((i % width) as f32, (i / width) as f32) + 0.5) / size * 2.0 - 1.0;
            0.5 - at.length_squared() + noise.get_noise_2d(at.x * size.x / size.y, at.y) > 0.0
        };
        let is_land = (0..width * height).map(is_land).collect();
        Self { width, height, is_land, domain: Domain::with_aspect(size.x / size.y) }
    }

    fn land(&self) -> Arc<Land> {
        Land::from_mask(&self.domain, self.width as u32, self.height as u32, &self.is_land).unwrap()
    }

    fn rgba(&self) -> Vec<u8> {
        self.is_land.iter().flat_map(|&is_land| if is_land { [255; 4] } else { [0, 0, 0, 255] }).collect()
    }

    fn holds(&self, at: Vec2) -> bool {
        let pixel = at / self.domain.size * Vec2::new(self.width as f32, self.height as f32);
        let (x, y) = (pixel.x.max(0.0) as usize, pixel.y.max(0.0) as usize);
        self.is_land[y.min(self.height - 1) * self.width + x.min(self.width - 1)]
    }

    /// The area that is land in both, as a share of the area that is land in either.
    fn overlap(&self, land: &Land) -> f64 {
        let (mut both, mut any) = (0u32, 0u32);
        for (column, row) in (0..land.columns()).flat_map(|column| (0..land.rows()).map(move |row| (column, row))) {
            let there = self.holds(land.point(column as u32, row as u32, Vec2::splat(0.5)));
            let here = land.cell(column, row) != Cell::Water;
            both += u32::from(here && there);
            any += u32::from(here || there);
        }
        f64::from(both) / f64::from(any)
    }
}

fn recipe(text: &str) -> Recipe {
    link::read(&format!("country=usual&seed=matai&land=drawn&aspect=1.5&{text}")).unwrap()
}

#[test]
fn land_is_the_mask_where_its_outline_is_not() {
    for seed in [1, 2, 3] {
        let mask = Mask::rough(1200, 800, seed);
        let overlap = mask.overlap(&mask.land());
        let outline = trace(1200, 800, &mask.rgba()).unwrap().outline;
        let traced = Land::of(&recipe(&format!("roughness=0&outline={outline}"))).unwrap();
        println!("seed {seed}: overlap {overlap:.4}, of the outline {:.4}", mask.overlap(&traced));
        assert!(overlap >= 0.99, "seed {seed}: {overlap}");
        assert!(mask.overlap(&traced) < 0.97, "seed {seed}: an outline does as well");
    }
}

#[test]
fn coast_distances_are_those_of_the_mask_s_pixels() {
    let mask = Mask::with_octaves(1200, 800, 4, 3);
    let land = mask.land();
    let units = mask.domain.size.x / 1200.0;
    let middle = |i: usize| (Vec2::new((i % 1200) as f32, (i / 1200) as f32) + 0.5) * units;
    let beside = |i: usize| [i.wrapping_sub(1), i + 1, i.wrapping_sub(1200), i + 1200];
    let is_coast =
        |&i: &usize| beside(i).iter().any(|&j| mask.is_land.get(j).is_some_and(|&land| land != mask.is_land[i]));
    let coast: Vec<usize> = (0..mask.is_land.len()).filter(is_coast).collect();
    // Near the coast and far from it.
    for i in coast.iter().step_by(7).map(|i| (i + 4) % mask.is_land.len()).chain((0..mask.is_land.len()).step_by(997)) {
        let others = coast.iter().filter(|&&other| mask.is_land[other] != mask.is_land[i]);
        let nearest =
            others.map(|&other| middle(other).distance_squared(middle(i))).fold(f32::INFINITY, f32::min).sqrt();
        // The coast runs half-way to it.
        let expected = (nearest - units / 2.0) * if mask.is_land[i] { 1.0 } else { -1.0 };
        let height = land.coast_distance().height(middle(i));
        assert!((height - expected).abs() < 1.6, "{}: {height} is not {expected}", middle(i));
    }
}

#[test]
fn large_pixels_make_no_stairs() {
    // Each of them ten units large.
    let is_land = |i: usize| Vec2::new((i % 100) as f32 - 49.5, (i / 100) as f32 - 49.5).length() < 35.0;
    let mask: Vec<bool> = (0..100 * 100).map(is_land).collect();
    let land = Land::from_mask(&Domain::with_aspect(1.0), 100, 100, &mask).unwrap();
    let turn = |i: u32| {
        let angle = i as f32 / 720.0 * std::f32::consts::TAU;
        let outward = Vec2::new(libm::cosf(angle), libm::sinf(angle));
        let inland = land.coast_distance().slope(outward * 350.0 + 500.0).normalize();
        inland.angle_to(-outward).abs().to_degrees()
    };
    // The coast of a circle faces outward: steps of large pixels would turn it by up to half of a right angle.
    let mean = (0..720).map(turn).sum::<f32>() / 720.0;
    assert!(mean < 6.0, "{mean} degrees");
}

#[test]
fn every_river_stays_on_the_mask_s_land() {
    let mask = Mask::rough(1200, 800, 5);
    let land = mask.land();
    for growth in ["colonize", "drainage", "brownian"] {
        let mut session = Session::on_land(recipe(&format!("growth={growth}&attractors=4000")), land.clone()).unwrap();
        let rivers = session.finish().unwrap();
        assert!(rivers.network().rivers.len() > 30, "{growth}: {}", rivers.network().rivers.len());
        // Within a cell of the land, half a diagonal long.
        let around = [-1.5, 0.0, 1.5].map(|x| [-1.5, 0.0, 1.5].map(|y| (x, y))).concat();
        for vertex in &rivers.network().vertices {
            // Mouths lie on the coast itself.
            let is_on_land = around.iter().any(|&aside| mask.holds(vertex.at + Vec2::from(aside)));
            assert!(is_on_land, "{growth}: a river at {}", vertex.at);
        }
    }
}

fn picture_and_files_are_made_of_the_land_given() {
    let mask = Mask::rough(900, 600, 6);
    let land = Land::from_picture(&mask.domain, 900, 600, &mask.rgba()).unwrap();
    assert!(mask.overlap(&land) >= 0.99, "{}", mask.overlap(&land));
    for style in one_in(5, ["atlas", "night", "ink", "dark", "skeleton"]) {
        let mut session = Session::on_land(recipe(&format!("style={style}")), land.clone()).unwrap();
        session.finish().unwrap();
        let mut picture = Picture::new(900, 600).unwrap();
        picture.paint(&session);
        let svg = export::svg::svg(&session.map().unwrap()).unwrap();
        assert!(svg.contains("class=\"coast\"") && svg.contains("id=\"river-0\""), "{style}");
        if style == "atlas" {
            let of = |is_land: bool| {
                let pixels = picture.pixmap().pixels().iter().zip(&mask.is_land);
                // Land is green or brown, water blue.
                let warm = |pixel: &tiny_skia::PremultipliedColorU8| i32::from(pixel.red()) - i32::from(pixel.blue());
                let all: Vec<i32> = pixels.filter(|(_, own)| **own == is_land).map(|(pixel, _)| warm(pixel)).collect();
                all.iter().sum::<i32>() / all.len() as i32
            };
            assert!(of(true) > of(false) + 40, "land {}, water {}", of(true), of(false));
        }
    }
}

tiers!(picture_and_files_are_made_of_the_land_given);

#[test]
fn land_given_stays_whatever_the_recipe_is_changed_to() {
    let mask = Mask::rough(600, 400, 7);
    let land = mask.land();
    let mut session = Session::on_land(recipe(""), land.clone()).unwrap();
    let before = session.finish().unwrap();
    assert_eq!(session.change(recipe("roughness=0.2&bending=0.5")).unwrap(), Some(Stage::Land));
    assert!(Arc::ptr_eq(session.land().unwrap(), &land));
    assert_ne!(session.finish().unwrap().network(), before.network());
    session.restart().unwrap();
    let mut other = recipe("");
    other.set(Key::Land, "island").unwrap();
    session.change(other).unwrap();
    assert!(Arc::ptr_eq(session.land().unwrap(), &land));
    session.change(recipe("")).unwrap();
    assert_eq!(session.finish().unwrap().network(), before.network());
    let mut copy = session.try_clone().unwrap();
    copy.change(recipe("sea=0.3")).unwrap();
    assert!(Arc::ptr_eq(copy.land().unwrap(), &land));
}

#[test]
fn land_of_another_map_is_refused_and_leaves_the_session_as_it_is() {
    let mask = Mask::rough(600, 400, 8);
    let mut wide = recipe("");
    wide.set(Key::Aspect, "2").unwrap();
    let refused = SessionError::OtherMap { width: 1225, height: 816, wanted_width: 1414, wanted_height: 707 };
    assert_eq!(Session::on_land(wide.clone(), mask.land()).map(drop), Err(refused.clone()));
    let mut session = Session::on_land(recipe(""), mask.land()).unwrap();
    let before = session.finish().unwrap();
    assert_eq!(session.change(wide), Err(refused));
    assert_eq!((session.recipe(), session.network()), (&recipe(""), Some(&**before.network())));
}

#[test]
fn a_picture_longer_than_any_map_is_not_squeezed() {
    // A disc in the middle of a map of 2000 by 500 units, and land along its southern side.
    let is_land = |i: i32| (i % 800 - 400).pow(2) + (i / 800 - 50).pow(2) < 30 * 30 || i / 800 > 90;
    let rgba: Vec<u8> = (0..800 * 100).flat_map(|i| if is_land(i) { [255; 4] } else { [0, 0, 0, 255] }).collect();
    let land = Land::from_picture(&Domain::with_aspect(4.0), 800, 100, &rgba).unwrap();
    let at = |x: f32, y: f32| land.at(Vec2::new(x, y)) == Cell::Land;
    assert!(at(1000.0, 250.0) && at(1070.0, 250.0) && at(1000.0, 320.0) && !at(1080.0, 250.0) && !at(1000.0, 330.0));
    assert!(at(1000.0, 360.0) && at(10.0, 495.0) && !at(10.0, 5.0));
}

#[test]
fn masks_that_are_no_land_are_refused_by_name() {
    let domain = Domain::with_aspect(1.0);
    let of = |side: u32, is_land: &dyn Fn(u32) -> bool| {
        let mask: Vec<bool> = (0..side * side).map(is_land).collect();
        Land::from_mask(&domain, side, side, &mask).map(drop)
    };
    assert_eq!(of(100, &|_| true), Err(TraceError::AllLand));
    assert_eq!(of(100, &|_| false), Err(TraceError::AllWater));
    assert_eq!(of(100, &|i| i % 100 < 5 && i < 500), Err(TraceError::Nothing(DrawError::TooSmall)));
    assert_eq!(of(8, &|_| true), Err(TraceError::TooSmall { width: 8, height: 8 }));
    let pixels = TraceError::Pixels { pixels: 7, width: 20, height: 20 };
    assert_eq!(Land::from_mask(&domain, 20, 20, &[true; 7]).map(drop), Err(pixels));
    let large = TraceError::TooLarge { width: 5000, height: 20 };
    assert_eq!(Land::from_mask(&domain, 5000, 20, &[true; 100_000]).map(drop), Err(large));
    let clear = vec![0; 40 * 40 * 4];
    assert_eq!(Land::from_picture(&domain, 40, 40, &clear).map(drop), Err(TraceError::Empty));
}
