//! The relief as a mesh with the picture on it, in one binary file (glTF 2.0).
//!
//! Metres, y up, x east, z south, the origin at the map's centre and the sea's surface. The sea is flat, and so is each lake.

use std::io::{Error, Result, Write};

use riverseed::domain::Domain;
use riverseed::export::png;
use riverseed::export::rasters::Rasters;
use riverseed::glam::{DVec3, Vec2};
use riverseed::paint::View;
use riverseed::tiny_skia::Pixmap;
use serde_json::{Value, json};

use super::terrain::Terrain;
use crate::memory::ask;

/// The most vertices on a side: readers take a million easily, and the picture shows what is finer.
const MOST: usize = 1025;

const MAGIC: u32 = 0x4654_6c67;
const VERSION: u32 = 2;
const JSON: u32 = 0x4e4f_534a;
const BINARY: u32 = 0x004e_4942;
const HEADER: usize = 12;
const CHUNK: usize = 8;

/// Writes a map.
///
/// # Errors
/// Fails if there is not enough memory, and with the writer's errors.
pub fn write(mut out: impl Write, domain: &Domain, rasters: &Rasters, picture: &Pixmap) -> Result<()> {
    /// The parts, with six corners of triangles for each vertex, and all of them once more in one list.
    const BYTES_A_VERTEX: usize = 2 * (32 + 24) + 8;
    /// The text, and the memory of compression.
    const BYTES: usize = 4_000_000;
    let grid = Grid::of(rasters);
    ask(grid.columns.len() * grid.rows.len() * BYTES_A_VERTEX + 6 * picture.data().len() + BYTES)?;
    let mesh = Mesh::of(&grid, domain, rasters, picture)?;
    let mut image = Vec::new();
    png::write(&mut image, picture, &rasters.link).map_err(Error::from)?;
    let (binary, parts) = mesh.binary(&image);
    let mut json = document(&mesh, &parts, binary.len(), rasters, picture).to_string().into_bytes();
    pad(&mut json, b' ');
    let length = HEADER + CHUNK + json.len() + CHUNK + binary.len();
    let words = [MAGIC, VERSION, length as u32, json.len() as u32, JSON];
    words.iter().try_for_each(|word| out.write_all(&word.to_le_bytes()))?;
    out.write_all(&json)?;
    [binary.len() as u32, BINARY].iter().try_for_each(|word| out.write_all(&word.to_le_bytes()))?;
    out.write_all(&binary)
}

/// Reads what a file says about itself, if it is complete: the `extras` of its asset.
pub fn about(file: &[u8]) -> Option<Value> {
    let word = |at: usize| file.get(at..at + 4).and_then(|bytes| bytes.try_into().ok()).map(u32::from_le_bytes);
    let is_whole = word(0)? == MAGIC && word(8)? as usize == file.len();
    let json = file.get(HEADER + CHUNK..HEADER + CHUNK + word(HEADER)? as usize)?;
    let document: Value = serde_json::from_slice(json).ok().filter(|_| is_whole)?;
    document.pointer("/asset/extras").cloned()
}

/// Makes the `extras` of a file.
pub fn extras(link: &str, rasters: [u32; 2], picture: [u32; 2]) -> Value {
    json!({ "riverseed": link, "rasters": rasters, "picture": picture })
}

/// The columns and rows of the rasters that have vertices.
struct Grid {
    columns: Vec<usize>,
    rows: Vec<usize>,
}

impl Grid {
    fn of(rasters: &Rasters) -> Self {
        let stride = (rasters.columns.max(rasters.rows) - 1).div_ceil(MOST - 1).max(1);
        // The last one closes the map, after a shorter way if need be.
        let every = |count: usize| (0..count - 1).step_by(stride).chain([count - 1]).collect();
        Self { columns: every(rasters.columns), rows: every(rasters.rows) }
    }
}

struct Mesh {
    positions: Vec<[f32; 3]>,
    normals: Vec<[f32; 3]>,
    places: Vec<[f32; 2]>,
    triangles: Vec<u32>,
}

impl Mesh {
    fn of(grid: &Grid, domain: &Domain, rasters: &Rasters, picture: &Pixmap) -> Result<Self> {
        let view = View::new(domain, picture.width(), picture.height()).map_err(Error::other)?;
        let [north_west, south_east] = view.frame();
        let terrain = Terrain::of(rasters);
        let corners = || grid.rows.iter().flat_map(|&row| grid.columns.iter().map(move |&column| (column, row)));
        let at = |(column, row): (usize, usize)| Vec2::new(column as f32 + 0.5, row as f32 + 0.5) * rasters.cell_size;
        let position = |corner: (usize, usize)| {
            let from_centre = (at(corner) - domain.size * 0.5).as_dvec2() * terrain.scale.metres_a_unit;
            let height = terrain.height(corner.0 as isize, corner.1 as isize).max(0.0);
            [from_centre.x as f32, height as f32, from_centre.y as f32]
        };
        // The middles of the last pixels may lie beyond the map, where there is no picture.
        let on_picture = |corner| (at(corner) - north_west) / (south_east - north_west);
        let place = |corner| on_picture(corner).clamp(Vec2::ZERO, Vec2::ONE).to_array();
        let count = grid.columns.len() * grid.rows.len();
        Ok(Self {
            positions: listed(count, corners().map(position)),
            normals: listed(count, corners().map(|corner| normal(&terrain, corner))),
            places: listed(count, corners().map(place)),
            triangles: triangles(grid.columns.len() as u32, grid.rows.len() as u32),
        })
    }

    /// Writes the bytes of all parts one after the other, and where each begins and how long it is.
    fn binary(&self, image: &[u8]) -> (Vec<u8>, Vec<[usize; 2]>) {
        let numbers = 6 * self.positions.len() + 2 * self.places.len() + self.triangles.len();
        let (mut bytes, mut parts) = (Vec::with_capacity(numbers * 4 + image.len() + 4), Vec::new());
        let mut add = |part: &mut dyn Iterator<Item = [u8; 4]>| {
            let start = bytes.len();
            part.for_each(|word| bytes.extend(word));
            parts.push([start, bytes.len() - start]);
        };
        add(&mut self.positions.iter().flatten().map(|number| number.to_le_bytes()));
        add(&mut self.normals.iter().flatten().map(|number| number.to_le_bytes()));
        add(&mut self.places.iter().flatten().map(|number| number.to_le_bytes()));
        add(&mut self.triangles.iter().map(|vertex| vertex.to_le_bytes()));
        parts.push([bytes.len(), image.len()]);
        bytes.extend(image);
        pad(&mut bytes, 0);
        (bytes, parts)
    }

    /// Finds the least and the greatest of each coordinate.
    fn bounds(&self) -> [[f32; 3]; 2] {
        let [least, most] = [f32::min as fn(f32, f32) -> f32, f32::max].map(|of| {
            let first = self.positions.first().copied().unwrap_or_default();
            self.positions.iter().fold(first, |a, b| [of(a[0], b[0]), of(a[1], b[1]), of(a[2], b[2])])
        });
        [least, most]
    }
}

/// Makes a list without spare room.
fn listed<T>(count: usize, items: impl Iterator<Item = T>) -> Vec<T> {
    let mut list = Vec::with_capacity(count);
    list.extend(items);
    list
}

/// Returns the direction that the ground faces; the sea faces up.
fn normal(terrain: &Terrain, (column, row): (usize, usize)) -> [f32; 3] {
    if terrain.height(column as isize, row as isize) <= 0.0 {
        return [0.0, 1.0, 0.0];
    }
    let slope = terrain.slope(column, row);
    DVec3::new(-slope.x, 1.0, -slope.y).normalize().as_vec3().to_array()
}

/// Makes two triangles for each square, counterclockwise from above.
fn triangles(columns: u32, rows: u32) -> Vec<u32> {
    let squares = (0..rows - 1).flat_map(|row| (0..columns - 1).map(move |column| row * columns + column));
    let corners = |north_west: u32| {
        let (north_east, south_west) = (north_west + 1, north_west + columns);
        [north_west, south_west, north_east, north_east, south_west, south_west + 1]
    };
    let mut triangles = Vec::with_capacity(6 * (rows as usize - 1) * (columns as usize - 1));
    squares.for_each(|square| triangles.extend(corners(square)));
    triangles
}

fn document(mesh: &Mesh, parts: &[[usize; 2]], bytes: usize, rasters: &Rasters, picture: &Pixmap) -> Value {
    const FLOAT: u32 = 5126;
    const UNSIGNED: u32 = 5125;
    const LINEAR: u32 = 9729;
    const SMOOTH: u32 = 9987;
    const CLAMP: u32 = 33071;
    let vertices = mesh.positions.len();
    let [least, most] = mesh.bounds().map(|bounds| bounds.map(f64::from));
    let sides = [rasters.columns as u32, rasters.rows as u32];
    json!({
        "asset": {
            "version": "2.0",
            "generator": "Riverseed",
            "extras": extras(&rasters.link, sides, [picture.width(), picture.height()]),
        },
        "scene": 0,
        "scenes": [{ "nodes": [0] }],
        "nodes": [{ "name": "map", "mesh": 0 }],
        "meshes": [{ "name": "relief", "primitives": [{
            "attributes": { "POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2 }, "indices": 3, "material": 0,
        }] }],
        "materials": [{ "name": "picture", "pbrMetallicRoughness": {
            "baseColorTexture": { "index": 0 }, "metallicFactor": 0.0, "roughnessFactor": 1.0,
        } }],
        "textures": [{ "sampler": 0, "source": 0 }],
        "samplers": [{ "magFilter": LINEAR, "minFilter": SMOOTH, "wrapS": CLAMP, "wrapT": CLAMP }],
        "images": [{ "name": "picture", "mimeType": "image/png", "bufferView": 4 }],
        "accessors": [
            { "bufferView": 0, "componentType": FLOAT, "count": vertices, "type": "VEC3", "min": least, "max": most },
            { "bufferView": 1, "componentType": FLOAT, "count": vertices, "type": "VEC3" },
            { "bufferView": 2, "componentType": FLOAT, "count": vertices, "type": "VEC2" },
            { "bufferView": 3, "componentType": UNSIGNED, "count": mesh.triangles.len(), "type": "SCALAR" },
        ],
        "bufferViews": views(parts),
        "buffers": [{ "byteLength": bytes }],
    })
}

/// Says where each part of the bytes lies, and which are those of vertices and triangles.
fn views(parts: &[[usize; 2]]) -> Vec<Value> {
    const OF_VERTICES: u32 = 34962;
    const OF_TRIANGLES: u32 = 34963;
    let targets = [Some(OF_VERTICES), Some(OF_VERTICES), Some(OF_VERTICES), Some(OF_TRIANGLES), None];
    let view = |([start, length], target): (&[usize; 2], Option<u32>)| {
        let mut view = json!({ "buffer": 0, "byteOffset": start, "byteLength": length });
        if let (Some(target), Some(members)) = (target, view.as_object_mut()) {
            members.insert("target".into(), target.into());
        }
        view
    };
    parts.iter().zip(targets).map(view).collect()
}

/// Fills bytes up to a whole number of words.
fn pad(bytes: &mut Vec<u8>, with: u8) {
    bytes.resize(bytes.len().next_multiple_of(4), with);
}
