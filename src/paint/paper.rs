//! Paper and other uneven ground: blotches, a grain and darker edges.

use fastnoise_lite::{FastNoiseLite, FractalType, NoiseType};
use glam::Vec2;

use super::ground::land_share;
use super::palette::{Colour, Palette, Paper, mix};
use super::view::{Rows, View};

/// The ageing of a picture's paper.
pub(super) struct Ageing<'a> {
    view: &'a View,
    paper: &'a Paper,
    noise: FastNoiseLite,
}

impl<'a> Ageing<'a> {
    #[inline(never)] // one copy
    pub fn new(view: &'a View, paper: &'a Paper) -> Self {
        let mut noise = FastNoiseLite::with_seed(1);
        noise.set_noise_type(Some(NoiseType::OpenSimplex2));
        noise.set_fractal_type(Some(FractalType::FBm));
        noise.set_fractal_octaves(Some(paper.octaves));
        noise.set_frequency(Some(1.0 / paper.size));
        Self { view, paper, noise }
    }

    /// Returns the strength of the blotch at a place of the picture.
    #[inline(never)]
    fn blotch(&self, pixel: Vec2) -> f32 {
        let at = self.view.point(pixel);
        (self.noise.get_noise_2d(at.x, at.y) * 1.4 + 0.1).clamp(0.0, 1.0)
    }

    /// Ages a colour in a pixel: stains it, and makes it as dark as the paper there.
    fn aged(&self, colour: Colour, stained: f32, x: u32, y: u32) -> Colour {
        let size = Vec2::new(self.view.width as f32, self.view.height as f32);
        let edged = edge((Vec2::new(x as f32, y as f32) + 0.5) / size) * self.paper.edged;
        let aged = mix(mix(colour, self.paper.blotch, stained * self.paper.blotched), self.paper.edge, edged);
        aged.map(|part| (f32::from(part) * grain(x, y)).min(255.0) as u8)
    }

    /// Ages a colour of the sea in a pixel.
    pub fn at_sea(&self, colour: Colour, x: u32, y: u32) -> Colour {
        let blotch = self.blotch(Vec2::new(x as f32, y as f32) + 0.5);
        self.aged(colour, blotch * self.paper.at_sea, x, y)
    }
}

/// The colour of water at the coast in a picture.
pub(super) struct WaterColour<'a> {
    shallows: Colour,
    ageing: Option<Ageing<'a>>,
}

impl<'a> WaterColour<'a> {
    pub fn new(view: &'a View, palette: &'a Palette) -> Self {
        Self { shallows: palette.shallows, ageing: palette.paper.as_ref().map(|paper| Ageing::new(view, paper)) }
    }

    /// Returns the colour in a pixel.
    pub fn at(&self, x: u32, y: u32) -> Colour {
        self.ageing.as_ref().map_or(self.shallows, |ageing| ageing.at_sea(self.shallows, x, y))
    }
}

/// Ages some rows of a ground.
pub(super) fn lay(view: &View, paper: &Paper, rows: Rows, pixels: &mut [[u8; 4]]) {
    let ageing = Ageing::new(view, paper);
    let columns = view.width as usize;
    // Blotches are looked up only at every so many pixels of a row.
    let every = ((paper.size * view.scale / 18.0) as usize).clamp(1, 8);
    for (y, row) in rows.zip(pixels.chunks_mut(columns)) {
        let mut blotch = [0.0, ageing.blotch(Vec2::new(0.0, y as f32) + 0.5)];
        for (x, pixel) in row.iter_mut().enumerate() {
            if x.is_multiple_of(every) {
                blotch = [blotch[1], ageing.blotch(Vec2::new((x + every) as f32, y as f32) + 0.5)];
            }
            let way = (x % every) as f32 / every as f32;
            let [r, g, b, open] = *pixel;
            let here = paper.at_sea + (1.0 - paper.at_sea) * f32::from(land_share(open)) / 255.0;
            let stained = (blotch[0] + (blotch[1] - blotch[0]) * way) * here;
            let [r, g, b] = ageing.aged([r, g, b], stained, x as u32, y);
            *pixel = [r, g, b, open];
        }
    }
}

/// Returns the closeness of a place to the edges, from 0 to 1. Places are shares of the picture's sides.
fn edge(place: Vec2) -> f32 {
    let off = (place * 2.0 - 1.0).length_squared() - 0.55;
    let way = (off / 1.45).clamp(0.0, 1.0);
    way * way * (3.0 - 2.0 * way)
}

/// Returns the grain of the paper in a pixel, which makes it a little lighter or darker.
fn grain(x: u32, y: u32) -> f32 {
    const STRENGTH: f32 = 0.018;
    let mut bits = x.wrapping_mul(0x9e37_79b1) ^ y.wrapping_mul(0x85eb_ca77);
    bits = (bits ^ (bits >> 15)).wrapping_mul(0x2c1b_3c6d);
    1.0 + ((bits >> 16) as f32 / 65_535.0 - 0.5) * 2.0 * STRENGTH
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::domain::Domain;
    use crate::paint::styles::palette;
    use crate::recipe::Style;

    #[test]
    fn forests_grow_on_land_alone() {
        let view = View::new(&Domain::with_aspect(1.0), 200, 100).unwrap();
        let paper = palette(Style::Orbit.into()).paper.unwrap();
        let darkest = |open: u8| {
            let mut pixels = vec![[120, 120, 120, open]; view.pixels()];
            lay(&view, &paper, 0..100, &mut pixels);
            pixels.iter().map(|pixel| pixel[0]).min().unwrap()
        };
        assert!(darkest(0) >= 117, "no more than the grain");
        assert!(darkest(255) < 90);
    }
}
