//! Fishhooks: brooks that turn back on themselves within a short way.

use super::parallels::evenly;
use crate::network::{Network, greatest_turns};

/// The distance between the places that a brook is measured at, in spacings.
const STEP: f32 = 0.7;

/// The least length of a brook that counts, in spacings.
const SHORTEST: f32 = 1.7;

/// The turn of a hook, in degrees, and the way within which it is made, in spacings.
const TURN: f32 = 120.0;
const WITHIN: f32 = 2.5;

/// Returns the share, from 0 to 1, of the rivers of order 1 that turn by more than 120 degrees within two and a half spacings. Those
/// shorter than 1.7 spacings do not count. `None` if none does.
pub fn hooks(network: &Network, spacing: f32) -> Option<f64> {
    let brooks = network.rivers.iter().filter(|river| river.order == 1 && network.length(river) >= SHORTEST * spacing);
    let (mut all, mut hooks) = (0u32, 0u32);
    for brook in brooks {
        let line = evenly(&network.places(brook), STEP * spacing);
        all += 1;
        hooks += u32::from(greatest_turns(&line, WITHIN * spacing).iter().any(|turn| turn.to_degrees() > TURN));
    }
    (all > 0).then(|| f64::from(hooks) / f64::from(all))
}

#[cfg(test)]
mod tests {
    use super::super::samples::{Sample, network, to_sea};
    use super::*;

    /// Makes a network of rivers of order 1.
    fn brooks(samples: &[Sample<'_>]) -> Network {
        let mut network = network(samples);
        network.rivers.iter_mut().for_each(|river| river.order = 1);
        network
    }

    #[test]
    fn a_brook_that_turns_back_is_a_hook_and_one_that_does_so_slowly_is_none() {
        let hook = [(0.0, 0.0), (3.0, 0.0), (4.0, 1.0), (3.0, 2.0), (0.0, 2.0)];
        let wide = [(0.0, 10.0), (9.0, 10.0), (9.0, 16.0), (0.0, 16.0)];
        let short = [(30.0, 0.0), (30.5, 0.0), (30.5, 0.5), (30.0, 0.5)];
        let rivers = [to_sea(&hook), to_sea(&wide), to_sea(&short)];
        assert_eq!(hooks(&brooks(&rivers), 1.0), Some(0.5));
        assert_eq!(hooks(&brooks(&rivers[1..]), 1.0), Some(0.0));
        assert_eq!(hooks(&brooks(&rivers[2..]), 1.0), None);
        assert_eq!(hooks(&network(&rivers), 1.0), None, "rivers of order 2 are no brooks");
    }
}
