//! Normal maps: the direction that the ground faces in each pixel.

use std::io::{Result, Write};

use png::ColorType;

use super::terrain::Terrain;
use super::textures;
use crate::memory::ask;

/// The first words of their description.
pub const SUBJECT: &str = "The direction that the ground faces";

/// The direction in which green grows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Green {
    /// To the north, up in the picture, as OpenGL, Unity and Godot have it.
    Up,
    /// To the south, down in the picture, as DirectX and Unreal have it.
    Down,
}

/// Writes the normal map of a landscape.
///
/// # Errors
/// Fails if there is not enough memory, and with the writer's errors.
pub fn write(out: impl Write, terrain: &Terrain, green: Green, link: &str) -> Result<()> {
    ask(terrain.columns * terrain.rows * 3)?;
    let cells = (0..terrain.rows).flat_map(|row| (0..terrain.columns).map(move |column| (column, row)));
    let bytes: Vec<u8> = cells.flat_map(|(column, row)| texel(terrain, green, column, row)).collect();
    let down = match green {
        Green::Up => "north",
        Green::Down => "south",
    };
    let meaning = format!("{SUBJECT}: red grows to the east, green to the {down}, blue up; 0 to 255 are -1 to 1.");
    textures::write(out, [terrain.columns, terrain.rows], ColorType::Rgb, &bytes, link, &meaning)
}

fn texel(terrain: &Terrain, green: Green, column: usize, row: usize) -> [u8; 3] {
    let slope = terrain.slope(column, row);
    let length = (slope.length_squared() + 1.0).sqrt();
    // The ground faces away from where it rises; rows run south.
    let south = -slope.y / length;
    let parts = [-slope.x / length, if green == Green::Up { -south } else { south }, 1.0 / length];
    parts.map(|part| ((part * 0.5 + 0.5) * 255.0).round() as u8)
}
