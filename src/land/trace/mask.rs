//! Pictures that become land directly, in full detail: the outline in a link has room for only a limited number of
//! points.

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
    /// Makes land from a mask, which holds `true` for each pixel of land, row by row. The mask fills the domain and
    /// should have its aspect. The coast runs halfway between the middles of pixels; steps are smoothed if pixels are
    /// larger than two units. A cell is land if its middle is, so detail finer than a unit is lost, as are islets and
    /// ponds of less than four square units.
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
    /// Fails if the mask's size is out of range, or if it shows no coast.
    pub fn from_mask(domain: &Domain, width: u32, height: u32, mask: &[bool]) -> Result<Arc<Self>, TraceError> {
        if mask.len() != width as usize * height as usize {
            return Err(TraceError::Pixels { pixels: mask.len(), width, height });
        }
        let rgba: Vec<u8> = mask.iter().flat_map(|&is_land| if is_land { [255; 4] } else { [0, 0, 0, 255] }).collect();
        super::check_size(width, height, rgba.len())?;
        let ground = Ground::of(width as usize, height as usize, &rgba, &Detail::MASK);
        let (coasts, _) = lines(&ground, |at| at)?;
        let coasts = without_stairs(coasts, domain.size.x / ground.columns as f32);
        of_lines(domain, coasts, Vec::new())
    }

    /// Makes land from a picture, given as RGBA bytes row by row, not premultiplied. Land, water and ridges are
    /// recognized as by [`trace`](super::trace()), but nothing is simplified and hardly anything left out. `domain`
    /// should have the aspect that tracing gives.
    ///
    /// # Errors
    /// Fails if the picture's size is out of range, or if it shows no coast.
    pub fn from_picture(domain: &Domain, width: u32, height: u32, rgba: &[u8]) -> Result<Arc<Self>, TraceError> {
        check_is_picture(width, height, rgba)?;
        let ground = Ground::of(width as usize, height as usize, rgba, &Detail::MASK);
        let frame = Frame::of(&ground);
        let (coasts, ridges) = lines(&ground, |at| frame.place(at))?;
        let coasts = without_stairs(coasts, domain.size.x / ground.columns as f32);
        of_lines(domain, coasts, ridges)
    }
}

/// Smooths the steps of coasts if pixels are large enough to show them; `pixel` is their side in units. Points on the
/// border stay there.
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

/// The smallest number of points of a ring that is smoothed. Shorter rings, around two or three pixels, would shrink.
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
