//! Channel heads: the places where enough water has gathered for a river to begin. Drainage trees cover the hillsides
//! too, and the part above the heads is removed.

use crate::base::random::{DEVIATION, Purpose, Seed};
use crate::tree::Tree;

/// The rule by which channels begin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Heads {
    /// The discharge at which a channel begins, in the middle of its range; 0 if channels are everywhere.
    pub channel_area: u32,
    /// The deviation of the logarithm of that discharge from place to place.
    pub variation: f32,
    /// The greatest discharge at a mouth: a channel begins there at the latest, so that no map stays empty.
    pub largest_basin: u32,
    /// The wavelength of the variation, in units.
    pub wavelength: f32,
}

impl Default for Heads {
    /// Returns the rule by which channels are everywhere.
    fn default() -> Self {
        Self { channel_area: 0, variation: 0.0, largest_basin: u32::MAX, wavelength: f32::INFINITY }
    }
}

impl Heads {
    /// Returns, for each node, `true` if it belongs to a channel. A channel that has begun goes on to the sea.
    pub fn channels(&self, tree: &Tree, discharge: &[u32], seed: Seed) -> Vec<bool> {
        let mut channels = vec![false; tree.len()];
        let is_head = self.is_head(tree, seed);
        for node in (0..tree.len()).rev() {
            channels[node] = channels[node] || is_head(node, discharge[node]);
            if let Some(parent) = tree.parent_of(node).filter(|_| channels[node]) {
                channels[parent] = true;
            }
        }
        channels
    }

    /// Returns a test for a node without a channel upstream, given with its discharge: `true` if a channel begins there.
    pub fn is_head(&self, tree: &Tree, seed: Seed) -> impl Fn(usize, u32) -> bool {
        let mut noise = seed.noise(Purpose::Trimming, 0, 1.0 / self.wavelength, 3);
        noise.set_fractal_gain(Some(0.6));
        let Self { channel_area, variation, largest_basin, .. } = *self;
        // Noise lies between −1 and 1.
        let least = (channel_area as f32 * libm::expf(-variation * DEVIATION)).min(largest_basin as f32);
        move |node, discharge| {
            if variation == 0.0 {
                return discharge >= channel_area.min(largest_basin);
            }
            if (discharge as f32) < least {
                return false;
            }
            let at = tree.at[node];
            let deviate = DEVIATION * noise.get_noise_2d(at.x, at.y);
            discharge >= largest_basin || discharge as f32 >= channel_area as f32 * libm::expf(variation * deviate)
        }
    }
}
