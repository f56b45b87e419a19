//! A picture as the land itself, at full detail: a link has room for only a limited number of points of an outline.

use std::sync::Arc;

use glam::Vec2;

use super::frame::Frame;
use super::ground::{Detail, Ground};
use super::{Lines, TraceError, check_is_picture, lines};
use crate::domain::Domain;
use crate::land::outline::Drawing;
use crate::land::queries::LEAST_DRAWN;
use crate::land::strokes::DrawError;
use crate::land::{CoastDistance, Land};

impl Land {
    /// The land of a mask: of each pixel, row by row, whether it is land. The mask fills the domain, which should have its aspect;
    /// the coast runs half-way between the middles of pixels, and of pixels that are over two units large the stairs are taken out. A cell
    /// is land if its middle is, so detail finer than a unit is lost, and with it islets and ponds of less than four square units.
    ///
    /// ```
    /// use riverseed::domain::Domain;
    /// use riverseed::{Land, Recipe, Session};
    ///
    /// let recipe: Recipe = "seed=matai&land=drawn&aspect=1".parse()?;
    /// let is_land = |i: i32| (i % 400 - 200).pow(2) + (i / 400 - 200).pow(2) < 150 * 150;
    /// let mask: Vec<bool> = (0..400 * 400).map(is_land).collect();
    /// let land = Land::from_mask(&Domain::of(&recipe), 400, 400, &mask)?;
    /// let mut session = Session::on_land(recipe, land)?;
    /// assert!(session.finish()?.rivers.len() > 100);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// If the mask's size is out of range, it shows no coast, or there is not enough memory.
    pub fn from_mask(domain: &Domain, width: u32, height: u32, mask: &[bool]) -> Result<Arc<Self>, TraceError> {
        if mask.len() != width as usize * height as usize {
            return Err(TraceError::Pixels { pixels: mask.len(), width, height });
        }
        super::check_size(width, height, mask.len() * 4)?;
        let rgba: Vec<u8> = mask.iter().flat_map(|&is_land| if is_land { [255; 4] } else { [0, 0, 0, 255] }).collect();
        let ground = Ground::of(width as usize, height as usize, &rgba, &Detail::MASK);
        let (coasts, _) = lines(&ground, |at| at)?;
        let coasts = without_stairs(coasts, domain.size.x / ground.columns as f32);
        of_lines(domain, coasts, Vec::new())
    }

    /// The land of a picture, given as RGBA bytes row by row, not premultiplied: what is land, water and ridge is as [`trace`](super::trace())
    /// says, but nothing is simplified, and next to nothing left out. `domain` should have the aspect that tracing gives.
    ///
    /// # Errors
    /// If the picture's size is out of range, it shows no coast, or there is not enough memory.
    pub fn from_picture(domain: &Domain, width: u32, height: u32, rgba: &[u8]) -> Result<Arc<Self>, TraceError> {
        check_is_picture(width, height, rgba)?;
        let ground = Ground::of(width as usize, height as usize, rgba, &Detail::MASK);
        let frame = Frame::of(&ground);
        let (coasts, ridges) = lines(&ground, |at| frame.place(at))?;
        let coasts = without_stairs(coasts, domain.size.x / ground.columns as f32);
        of_lines(domain, coasts, ridges)
    }
}

/// Takes the stairs out of coasts whose pixels, of a side in units, are large enough to show. What lies on the border stays there.
fn without_stairs(mut coasts: Lines, pixel: f32) -> Lines {
    const ROUNDS: usize = 2;
    if pixel <= CoastDistance::FINE_SPACING {
        return coasts;
    }
    for ring in coasts.iter_mut().filter(|ring| ring.len() >= SHORTEST) {
        (0..ROUNDS).for_each(|_| *ring = smoothed(ring));
    }
    coasts
}

/// Rings of fewer points, around two or three pixels, would shrink.
const SHORTEST: usize = 12;

fn smoothed(ring: &[Vec2]) -> Vec<Vec2> {
    let before = ring.iter().cycle().skip(ring.len().saturating_sub(1));
    let after = ring.iter().cycle().skip(1);
    let is_inside = |at: Vec2| at.min_element() > 0.0 && at.max_element() < 1.0;
    let middle = |((&a, &here), &b)| if is_inside(here) { (a + here * 2.0 + b) / 4.0 } else { here };
    before.zip(ring).zip(after).map(middle).collect()
}

fn of_lines(domain: &Domain, coasts: Lines, ridges: Lines) -> Result<Arc<Land>, TraceError> {
    let drawing = Drawing::on(domain, coasts, ridges);
    let coast_distance = drawing.coast_distance(domain, CoastDistance::FINE_SPACING);
    let grid = drawing.grid(domain);
    match grid.share_of_land() {
        share if share < LEAST_DRAWN => Err(TraceError::Nothing(DrawError::TooSmall)),
        1.0 => Err(TraceError::AllLand),
        _ => Ok(Land::on(grid, coast_distance, drawing.ridges).into()),
    }
}
