//! The long profile of rivers: their elevation above the sea, by the ground that they run through.

use super::cells::Cells;
use super::rills::LEAST_CATCHMENT;
use crate::base::geometry::distance;
use crate::network::{Network, hydrology};

/// The slope of a small river as a share of that of the hillsides around it.
const SHARE: f32 = 0.6;

/// The exponent of the catchment with which a river's slope falls (Flint 1974).
const CONCAVITY: f32 = 0.4;

/// Computes the elevation of each vertex of a network above the sea, in units; 0 at mouths. A river's slope falls with
/// a power of the area it drains (Flint 1974), and grows with the slope of the hillsides, so that mountain rivers are
/// steep. `total_discharge` is that of a river that would drain all of the land, and `rises` are how much the
/// hillsides rise from cell to cell, in units.
pub(super) fn elevations(network: &Network, total_discharge: u32, cells: &Cells, rises: &[f32]) -> Vec<f32> {
    let (downstream, straightness) = (network.downstream(), hydrology::straightness(network));
    let catchment = cells.land_area() / total_discharge as f32;
    hydrology::upward(network, |i, below| {
        let (vertex, next) = (&network.vertices[i], &network.vertices[downstream[i] as usize]);
        let share = share_of_slope(vertex.discharge as f32 * catchment);
        let slope = rises[cells.of(vertex.at)] / cells.size * share;
        (below + slope * distance(vertex.at, next.at) * straightness[i]).max(below.next_up())
    })
}

/// Returns the slope of a river as a share of that of the hillsides around it, by its catchment in square units.
pub(super) fn share_of_slope(catchment: f32) -> f32 {
    SHARE * libm::powf((catchment / LEAST_CATCHMENT).max(1.0), -CONCAVITY)
}
