//! Growth along valleys: attractors have heights, and pull one at a time. The lowest within reach of any node draws a
//! river to itself, step by step, then the lowest of those within reach by then (as water invades the ground: Wilkinson
//! and Willemsen 1983).

use glam::Vec2;

use super::heading::curl_toward;
use super::pull::Pull;
use super::rivers::{Rivers, Told};
use super::waiting::Waiting;
use crate::base::memory::Refused;
use crate::base::work;
use crate::grow::{Ending, GrowthSettings, front};

/// The attractors that rivers may reach next.
#[derive(Clone, Debug)]
pub(super) struct Valleys {
    waiting: Waiting,
    /// The number of nodes in a tick, apart from the rest of a river's way to an attractor.
    nodes_a_tick: usize,
}

impl Valleys {
    /// Begins with no attractor within reach. `places` are those of the attractors in their index, the lowest
    /// attractor's first.
    pub fn new(settings: &GrowthSettings, places: Vec<u32>) -> Result<Self, Refused> {
        Ok(Self { waiting: Waiting::new(places)?, nodes_a_tick: front(settings.attractors as usize) })
    }

    /// Grows by one tick: the lowest attractor within reach of a node draws a river to itself, then the next lowest.
    /// The number of nodes in a tick does not affect the tree.
    pub fn grow(&mut self, rivers: &mut Rivers) -> Result<(), Ending> {
        use_up(rivers);
        let enough = rivers.len() + self.nodes_a_tick;
        while rivers.len() < enough
            && let Some((rank, place)) = self.waiting.next()
        {
            work::count(1);
            self.grow_toward(rivers, rank, place)?;
        }
        Ok(())
    }

    /// Grows a river from its node nearest to an attractor until the attractor is used up, or until no step comes
    /// nearer to it.
    fn grow_toward(&mut self, rivers: &mut Rivers, rank: u32, place: u32) -> Result<(), Ending> {
        let first = rivers.len();
        while let Some((node, squared, attractor)) = rivers.attractors.remaining_at(place) {
            let steps = (rivers.len() - first) as u32;
            let Some(child) = step_toward(rivers, node as usize, squared, attractor, steps) else {
                self.waiting.put_back(rank);
                return Ok(());
            };
            rivers.make_room(1)?;
            rivers.add(child, node);
            self.capture(rivers);
            use_up(rivers);
        }
        Ok(())
    }

    /// Adds the attractors within reach of new nodes to those that wait.
    pub fn capture(&mut self, rivers: &mut Rivers) {
        for node in rivers.newcomers() {
            rivers.capture(node, &mut Told::Waiting(&mut self.waiting));
        }
    }
}

/// Uses up the attractors that rivers have come near to.
pub(super) fn use_up(rivers: &mut Rivers) {
    rivers.use_up(|_, _| ());
}

/// Returns a step from a node that comes nearer to an attractor, given the squared distance to it and the number of
/// previous steps; `None` if there is none.
fn step_toward(rivers: &Rivers, node: usize, squared: f32, attractor: Vec2, steps: u32) -> Option<Vec2> {
    let at = rivers.tree.at[node];
    let pull = Pull::toward(at, attractor).direction()?;
    let ([column, row], clockwise) = curl_toward(&rivers.settings, attractor);
    rivers.steps(node, pull, clockwise, [column, row, steps]).into_iter().find(|&child| {
        child.distance_squared(attractor) < squared
            && rivers.settings.allows(at, child)
            && !rivers.has_twin(node, child)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grow::Colonize;
    use crate::grow::colonize::Pulling;
    use crate::recipe::link;
    use crate::tree::Tree;

    fn grown(link: &str, nodes_a_tick: usize) -> Tree {
        let mut growth = Colonize::new(GrowthSettings::of(&link::read(link).unwrap())).unwrap();
        let Pulling::LowestFirst(valleys) = &mut growth.pulling else { panic!("{link} has no valleys") };
        valleys.nodes_a_tick = nodes_a_tick;
        while growth.tick() {}
        Tree::clone(&growth.rivers.tree)
    }

    #[test]
    fn how_much_a_tick_shows_changes_no_tree() {
        for link in
            ["land=island", "land=archipelago&mouths=20", "land=valley&reach=8&curl=1.5", "land=basin&momentum=0.5"]
        {
            let link = format!("{link}&growth=colonize&valleys=0.4&attractors=2000&seed=kauri");
            let at_once = grown(&link, usize::MAX / 2);
            for nodes_a_tick in [1, 7, 100] {
                let tree = grown(&link, nodes_a_tick);
                assert!(tree.tick_starts.len() > at_once.tick_starts.len(), "{link}");
                assert_eq!(
                    (tree.at, tree.parent, tree.drained),
                    (at_once.at.clone(), at_once.parent.clone(), at_once.drained.clone())
                );
            }
        }
    }
}
