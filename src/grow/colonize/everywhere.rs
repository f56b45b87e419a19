//! Growth wherever attractors pull, all at once, as in the paper.

use glam::Vec2;

use super::changed::Changed;
use super::heading::is_clockwise;
use super::pull::Pull;
use super::rivers::{Rivers, Told};
use crate::base::memory::{self, Refused};
use crate::grow::Ending;

/// The pulls on all nodes.
#[derive(Clone, Debug, Default)]
pub(super) struct Everywhere {
    /// The total pull on each node by its attractors.
    pull: Vec<Pull>,
    /// Nodes whose attractors have changed since they last tried to grow.
    changed: Changed,
    /// Buffer for one tick's work, kept between ticks.
    trying: Vec<u32>,
}

impl Everywhere {
    /// Reserves memory for more nodes.
    pub fn reserve(&mut self, nodes: usize) -> Result<(), Refused> {
        memory::reserve(&mut self.pull, nodes)
    }

    /// Grows by one tick. New nodes are those from `born_from` on.
    pub fn grow(&mut self, rivers: &mut Rivers, born_from: usize) -> Result<(), Ending> {
        self.try_all(rivers)?;
        if rivers.len() == born_from {
            reach_out(rivers);
        }
        Ok(())
    }

    /// Lets every node whose attractors have changed try to grow (steps 3 and 4 of the paper).
    fn try_all(&mut self, rivers: &mut Rivers) -> Result<(), Ending> {
        self.changed.drain_into(&mut self.trying);
        rivers.make_room(self.trying.len())?;
        self.reserve(self.trying.len()).map_err(|_| Ending::OutOfMemory)?;
        let tick = rivers.tree.tick_starts.len() as u32 - 1;
        for &node in &self.trying {
            if let Some(pull) = self.pull[node as usize].direction() {
                try_to_grow(rivers, node, pull, tick);
            }
        }
        Ok(())
    }

    /// Lets new nodes take the attractors that are now nearer to them.
    pub fn capture(&mut self, rivers: &mut Rivers) {
        let Self { pull, changed, .. } = self;
        changed.grow(rivers.len());
        pull.resize(rivers.len(), Pull::default());
        for node in rivers.newcomers() {
            let gained = rivers.capture(node, &mut Told::Owners { pull, changed });
            pull[node as usize].add(gained);
            changed.insert(node);
        }
    }

    /// Uses up the attractors that rivers have come near to.
    pub fn use_up(&mut self, rivers: &mut Rivers) {
        let Self { pull, changed, .. } = self;
        rivers.use_up(|owner, lost| {
            pull[owner as usize].subtract(lost);
            changed.insert(owner);
        });
    }
}

fn try_to_grow(rivers: &mut Rivers, node: u32, pull: Vec2, tick: u32) {
    let index = node as usize;
    let at = rivers.tree.at[index];
    let clockwise = is_clockwise(&rivers.settings, rivers.from_mouth[index]);
    let steps = rivers.steps(index, pull, clockwise, [at.x.to_bits(), at.y.to_bits(), tick]);
    let child = steps.into_iter().find(|&child| rivers.settings.allows(at, child));
    if let Some(child) = child
        && !rivers.has_twin(index, child)
    {
        rivers.add(child, node);
    }
}

/// Extends nodes that still have attractors, but balanced ones or ones that no bend led to, straight toward the
/// nearest. This happens when nothing else grows; without it, a map could run dry at its first few nodes.
fn reach_out(rivers: &mut Rivers) {
    for (node, attractor) in rivers.attractors.nearest_by_owner() {
        let at = rivers.tree.at[node as usize];
        if let Some(pull) = Pull::toward(at, attractor).direction() {
            let child = at + pull * rivers.settings.step;
            if rivers.settings.allows(at, child) && !rivers.has_twin(node as usize, child) {
                rivers.add(child, node);
            }
        }
    }
}
