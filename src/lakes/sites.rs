//! Sites of dams: places along rivers, in an order that chance decides, with lake districts and flat valleys first.

use crate::base::geometry::distance;
use crate::base::random::{DEVIATION, Purpose, Seed};
use crate::base::sort;
use crate::base::work;
use crate::network::{Network, River};
use crate::relief::Relief;

/// A place at which a river may be dammed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Site {
    /// The cell of the dam.
    pub cell: usize,
    pub river: u32,
    pub vertex: u32,
    /// The number of the site along its river, from the end up.
    pub number: u32,
    /// The least area of a lake there, in square units: a lake is much wider than its river.
    pub least: f32,
}

/// The number of vertices from one site to the next.
const VERTICES: usize = 5;

/// The least number of parcels that drain at a dam.
const PARCELS: u32 = 8;

/// The least area of a lake, in squares of the width of its river.
const SQUARES: f32 = 8.0;

/// The wavelength of lake districts, in units, and by how many powers of e a site is likelier at a deviation of their noise.
const DISTRICTS: f32 = 260.0;
const CONTRAST: f32 = 1.6;

/// The slope of a valley that halves the likelihood of a lake, in units of height for a unit of length.
const STEEP: f32 = 0.03;

/// Lists the sites of a network, the likeliest first.
pub(super) fn sites(network: &Network, relief: &Relief, seed: Seed) -> Vec<Site> {
    let mut sites = Vec::new();
    for (id, river) in (0..).zip(&network.rivers) {
        sites.extend(along(network, id, river, relief));
    }
    work::count(8 * sites.len());
    let (noise, chance) = (seed.noise(Purpose::Lakes, 0, 1.0 / DISTRICTS, 2), seed.item_hash(Purpose::Lakes));
    let turn = |site: &Site| {
        let at = network.vertices[site.vertex as usize].at;
        let district = libm::expf(CONTRAST * DEVIATION * noise.get_noise_2d(at.x, at.y));
        let river = &network.rivers[site.river as usize];
        let weight = district * STEEP / (STEEP + slope(network, river, site.vertex, relief));
        // The least of exponential deviates is that of an item with a chance in proportion to its weight.
        -libm::logf(1.0 - chance.unit([river.identity, site.number, 0])) / weight
    };
    let order = sort::argsort(sites.iter().map(|site| sort::key(turn(site))));
    order.into_iter().map(|i| sites[i]).collect()
}

/// Iterates over the sites along a river.
fn along<'a>(network: &'a Network, id: u32, river: &'a River, relief: &'a Relief) -> impl Iterator<Item = Site> + 'a {
    let vertices = river.vertex_range().rev().step_by(VERTICES);
    let site = move |(number, vertex): (u32, usize)| Site {
        cell: relief.cell(network.vertices[vertex].at),
        river: id,
        vertex: vertex as u32,
        number,
        least: SQUARES * network.vertices[vertex].width() * network.vertices[vertex].width(),
    };
    (0..).zip(vertices).filter(|&(_, vertex)| network.vertices[vertex].discharge >= PARCELS).map(site)
}

/// Returns the slope of a river above a vertex.
fn slope(network: &Network, river: &River, vertex: u32, relief: &Relief) -> f32 {
    /// The number of vertices over which it is measured.
    const OVER: u32 = 8;
    let upper = vertex.saturating_sub(OVER).max(river.start);
    let [from, to] = [upper, vertex].map(|vertex| network.vertices[vertex as usize].at);
    let far = distance(from, to).max(relief.cell_size());
    (relief.at(from) - relief.at(to)).max(0.0) / far
}
