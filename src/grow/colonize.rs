//! Space colonization (section 2.2 of the paper, after Runions, Lane and Prusinkiewicz 2007) as a stepper.
//!
//! Read literally, the procedure never ends: a node between balanced pulls makes the same child for ever. The rule
//! that ends it: a node tries to grow only when its set of attractors has changed since it last tried. Sets of old
//! nodes only shrink, so every node stops growing. Once all have, those that still have attractors reach out for the
//! nearest of them; when not even that makes a node, growth is over, and attractors that stay unreached are counted.
//! (Unless land is left over that no river sees, beyond an isthmus too narrow for a step: then it gets a mouth of its own. Or
//! unless most are: then a gap among the first attractors has cut the river off, and its last node runs straight on.)
//!
//! With valleys attractors have heights, and pull one at a time: the lowest within reach of any node draws a river to itself, step by step,
//! then the lowest of those within reach by then (as water invades the ground: Wilkinson and Willemsen 1983).

use glam::Vec2;

use super::attractors::{Attractors, NO_NODE};
use super::changed::Changed;
use super::drainage::can_lay_out;
use super::driest::Search;
use super::heading::{curl_toward, heading, is_clockwise, is_duplicate};
use super::starts::PIECE;
use super::waiting::Waiting;
use super::{BYTES_AN_ATTRACTOR, GrowError, GrowthSettings, Mouth, Pull, front, mouths, shores};
use crate::geometry::{direction, length};
use crate::land::Shore;
use crate::memory::{self, Refused};
use crate::tree::{NO_PARENT, Tree};
use crate::work;

/// How growth came to its end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ending {
    /// No node could grow any more, as the paper intends.
    Complete,
    /// The tree reached its limit of nodes.
    NodeLimit,
    /// There was not enough memory for more nodes.
    OutOfMemory,
}

/// Growth in progress.
#[derive(Clone, Debug)]
pub struct Colonize {
    settings: GrowthSettings,
    attractors: Attractors,
    tree: Tree,
    shoots: Shoots,
    /// Nodes whose attractors have changed since they last tried to grow.
    changed: Changed,
    /// With valleys, the attractors that a river may come to next.
    waiting: Option<Box<Waiting>>,
    /// How many nodes a tick has with valleys, but for the rest of a river's way to an attractor.
    nodes_a_tick: usize,
    /// How many nodes have looked for attractors.
    captured: usize,
    /// Room for one tick's work, kept between ticks.
    trying: Vec<u32>,
    /// Rivers that no attractor has reached yet.
    pilots: Vec<StraightTip>,
    /// Where rivers reach the sea.
    mouths: Vec<Vec2>,
    /// The search for another mouth, once there has been one.
    search: Option<Box<Search>>,
    unreached: u32,
    node_limit: usize,
    ending: Option<Ending>,
}

/// Memory is bounded by the recipe: this many nodes per attractor, and some. Ordinary trees have one or two; the wildest
/// that the ranges allow were found to have seven and a half.
const MOST_NODES_PER_ATTRACTOR: usize = 10;
const MOST_NODES_BESIDES: usize = 10_000;

/// What growth, and nothing after it, has to know of each node.
#[derive(Clone, Debug, Default)]
struct Shoots {
    pull: Vec<Pull>,
    /// Steps from the mouth.
    from_mouth: Vec<u32>,
    /// The youngest child, and each child's elder sibling, to find twins.
    youngest: Vec<u32>,
    elder: Vec<u32>,
}

/// The end of a river that nothing pulls yet: it runs straight inland.
#[derive(Clone, Copy, Debug)]
struct StraightTip {
    tip: u32,
    inland: Vec2,
}

impl Colonize {
    /// Plants the mouths of a recipe among its attractors: tick 0.
    ///
    /// # Errors
    /// If there is not enough memory.
    pub fn new(settings: GrowthSettings) -> Result<Self, GrowError> {
        let has_room = memory::can_allocate(settings.attractors as usize * BYTES_AN_ATTRACTOR);
        if !has_room || (settings.has_valleys() && !can_lay_out(&settings)) {
            return Err(GrowError::out_of_memory(&settings));
        }
        let (attractors, places) = Attractors::new(&settings)?;
        let waiting = settings.has_valleys().then(|| Waiting::new(places)).transpose();
        let mut this = Self {
            mouths: Vec::new(),
            search: None,
            unreached: attractors.count(),
            attractors,
            tree: Tree::default(),
            shoots: Shoots::default(),
            changed: Changed::default(),
            waiting: waiting.map_err(|_| GrowError::out_of_memory(&settings))?.map(Box::new),
            nodes_a_tick: front(settings.attractors as usize),
            captured: 0,
            trying: Vec::new(),
            pilots: Vec::new(),
            node_limit: MOST_NODES_PER_ATTRACTOR * settings.attractors as usize + MOST_NODES_BESIDES,
            ending: None,
            settings,
        };
        // A usual tree's memory at once, so that no frame waits for a long array to move.
        this.reserve(this.usual_nodes() + this.stem_nodes()).map_err(|_| GrowError::out_of_memory(&this.settings))?;
        this.tree.tick_starts.push(0);
        let starts = this.settings.starts.clone();
        for (i, mouth) in mouths(&this.settings).into_iter().enumerate() {
            this.plant(mouth, starts.get(i).map_or(&[], |start| &start.course));
        }
        this.capture();
        Ok(this)
    }

    /// Plants a mouth and its stem, the start nodes of the paper: along the course that is drawn of its river or, if none is, about a
    /// spacing straight inland, so that no river leaves along the coast.
    fn plant(&mut self, Mouth { at, inland }: Mouth, course: &[Vec2]) {
        let mouth = self.add(at, NO_PARENT);
        let mut pilot = self.follow(course, StraightTip { tip: mouth, inland });
        if pilot.tip == mouth {
            for _ in 0..stem_nodes(&self.settings) {
                pilot.tip = self.extend(pilot).unwrap_or(pilot.tip);
            }
        }
        self.pilots.push(pilot);
        self.mouths.push(at);
    }

    /// Extends a river along a course, a step at a time, until that or the land ends.
    fn follow(&mut self, course: &[Vec2], mut pilot: StraightTip) -> StraightTip {
        for &ahead in course {
            loop {
                let way = ahead - self.tree.at[pilot.tip as usize];
                if length(way) < self.settings.step {
                    break;
                }
                let onward = StraightTip { inland: direction(way), ..pilot };
                let Some(tip) = self.extend(onward) else { return pilot };
                pilot = StraightTip { tip, ..onward };
            }
        }
        pilot
    }

    /// Grows by one tick, everywhere at once. Returns whether there is more to grow. A tick that only searches for where
    /// to grow on, because that takes long, does not count.
    pub fn tick(&mut self) -> bool {
        if self.ending.is_some() {
            return false;
        }
        let born_from = self.tree.len();
        self.tree.tick_starts.push(born_from as u32);
        if !self.is_searching() {
            self.extend_pilots();
            self.grow(born_from);
        }
        if self.tree.len() == born_from && self.ending.is_none() {
            self.seed_unreached_land();
        }
        if self.is_searching() {
            self.tree.tick_starts.pop();
            return true;
        }
        if self.tree.len() == born_from && self.is_dry() {
            self.extend_last_tip();
        }
        self.capture();
        self.use_up();
        if self.tree.len() == born_from {
            self.tree.tick_starts.pop();
            self.finish();
        }
        self.ending.is_none()
    }

    /// Grows at all nodes, or where the ground is lowest.
    fn grow(&mut self, born_from: usize) {
        if self.waiting.is_none() {
            self.grow_everywhere();
            if self.tree.len() == born_from && self.ending.is_none() {
                self.reach_out();
            }
        } else if self.tree.len() == born_from {
            self.follow_valleys();
        }
    }

    /// Steps 3 and 4 of the paper: every node whose attractors have changed tries to grow.
    fn grow_everywhere(&mut self) {
        let mut trying = std::mem::take(&mut self.trying);
        self.changed.drain_into(&mut trying);
        if self.tree.len() + trying.len() > self.node_limit {
            self.ending = Some(Ending::NodeLimit);
        } else if self.reserve(trying.len()).is_err() {
            self.ending = Some(Ending::OutOfMemory);
        } else {
            let tick = self.tree.tick_starts.len() as u32 - 1;
            trying.iter().for_each(|&node| self.try_to_grow(node, tick));
        }
        self.trying = trying;
    }

    fn try_to_grow(&mut self, node: u32, tick: u32) {
        let index = node as usize;
        let Some(pull) = self.shoots.pull[index].direction() else { return };
        let at = self.tree.at[index];
        let clockwise = is_clockwise(&self.settings, self.shoots.from_mouth[index]);
        let steps = self.steps(index, pull, clockwise, [at.x.to_bits(), at.y.to_bits(), tick]);
        let child = steps.into_iter().find(|&child| self.settings.allows(at, child));
        if let Some(child) = child
            && !self.has_twin(index, child)
        {
            self.add(child, node);
        }
    }

    /// Where a step of a node may lead: bent by momentum and curl, or straight. A bend that would leave the land is not made: a river
    /// beside the coast must not stop growing because of it.
    fn steps(&self, node: usize, pull: Vec2, clockwise: bool, identity: [u32; 3]) -> [Vec2; 2] {
        let at = self.tree.at[node];
        let came_from = self.tree.parent_of(node).map(|parent| self.tree.at[parent]);
        let bent = heading(&self.settings, at, came_from, pull, clockwise, identity);
        [bent, at + pull * self.settings.step]
    }

    /// The lowest attractor within reach of a node draws a river to itself, then the next lowest. What a tick shows of that changes no
    /// tree.
    fn follow_valleys(&mut self) {
        self.use_up();
        let enough = self.tree.len() + self.nodes_a_tick;
        while self.tree.len() < enough
            && self.ending.is_none()
            && let Some((rank, place)) = self.waiting.as_mut().and_then(|waiting| waiting.next())
        {
            work::count(1);
            self.grow_toward(rank, place);
        }
    }

    /// A river grows from its nearest node to an attractor, until that is used up or no step brings it nearer.
    fn grow_toward(&mut self, rank: u32, place: u32) {
        let first = self.tree.len();
        while let Some((node, squared, attractor)) = self.attractors.remaining_at(place) {
            let steps = (self.tree.len() - first) as u32;
            let Some(child) = self.step_toward(node as usize, squared, attractor, steps) else {
                self.waiting.iter_mut().for_each(|waiting| waiting.put_back(rank));
                return;
            };
            if self.tree.len() >= self.node_limit {
                self.ending = Some(Ending::NodeLimit);
                return;
            }
            if self.reserve(1).is_err() {
                self.ending = Some(Ending::OutOfMemory);
                return;
            }
            self.add(child, node);
            self.capture();
            self.use_up();
        }
    }

    /// A step from a node that brings it nearer to an attractor, at such a distance squared, after so many.
    fn step_toward(&self, node: usize, squared: f32, attractor: Vec2, steps: u32) -> Option<Vec2> {
        let at = self.tree.at[node];
        let pull = Pull::toward(at, attractor).direction()?;
        let ([column, row], clockwise) = curl_toward(&self.settings, attractor);
        self.steps(node, pull, clockwise, [column, row, steps]).into_iter().find(|&child| {
            child.distance_squared(attractor) < squared
                && self.settings.allows(at, child)
                && !self.has_twin(node, child)
        })
    }

    /// When nothing else grows: nodes that still have attractors, but balanced ones, or ones that no bend led to, grow
    /// straight toward the nearest. Without this a map could run dry at its first few nodes.
    fn reach_out(&mut self) {
        for (node, attractor) in self.attractors.nearest_by_owner() {
            let at = self.tree.at[node as usize];
            if let Some(pull) = Pull::toward(at, attractor).direction() {
                let child = at + pull * self.settings.step;
                if self.settings.allows(at, child) && !self.has_twin(node as usize, child) {
                    self.add(child, node);
                }
            }
        }
    }

    fn has_twin(&self, node: usize, child: Vec2) -> bool {
        let mut sibling = self.shoots.youngest[node];
        while sibling != NO_NODE {
            if is_duplicate(child, self.tree.at[sibling as usize], self.settings.step) {
                return true;
            }
            sibling = self.shoots.elder[sibling as usize];
        }
        false
    }

    fn add(&mut self, at: Vec2, parent: u32) -> u32 {
        let node = self.tree.len() as u32;
        self.tree.at.push(at);
        self.tree.parent.push(parent);
        self.tree.drained.push(0);
        self.shoots.pull.push(Pull::default());
        self.shoots.youngest.push(NO_NODE);
        let (elder, from_mouth) = match self.shoots.youngest.get_mut(parent as usize) {
            Some(youngest) => (std::mem::replace(youngest, node), self.shoots.from_mouth[parent as usize] + 1),
            None => (NO_NODE, 0),
        };
        self.shoots.elder.push(elder);
        self.shoots.from_mouth.push(from_mouth);
        node
    }

    /// Step 2 of the paper, for new nodes only: attractors that are now nearer to one of them change hands.
    fn capture(&mut self) {
        self.changed.grow(self.tree.len());
        let Self { settings, attractors, tree, shoots, changed, waiting, captured, .. } = self;
        for node in *captured..tree.len() {
            let at = tree.at[node];
            let gained = attractors.capture(node as u32, at, settings.hidden_from(at), |place, owner, pull| {
                if let Some(waiting) = waiting {
                    waiting.join(place);
                } else if owner != NO_NODE {
                    shoots.pull[owner as usize].subtract(pull);
                    changed.insert(owner);
                }
            });
            shoots.pull[node].add(gained);
            changed.insert(node as u32);
        }
        *captured = tree.len();
    }

    /// Step 5 of the paper: attractors that a river has come near to are used up, and drain into it.
    fn use_up(&mut self) {
        let Self { attractors, tree, shoots, changed, unreached, .. } = self;
        attractors.use_up(|owner, pull| {
            shoots.pull[owner as usize].subtract(pull);
            tree.drained[owner as usize] += 1;
            *unreached -= 1;
            changed.insert(owner);
        });
    }

    /// Rivers that nothing reaches run straight inland until something does, or the land ends.
    fn extend_pilots(&mut self) {
        for pilot in std::mem::take(&mut self.pilots) {
            if self.attractors.within_reach(self.tree.at[pilot.tip as usize]).next().is_none()
                && let Some(tip) = self.extend(pilot)
            {
                self.pilots.push(StraightTip { tip, ..pilot });
            }
        }
    }

    /// When no node grows and land is left over that no river sees: another mouth, where it sees the most of it. It takes what
    /// it sees, so there is an end to them.
    fn seed_unreached_land(&mut self) {
        /// A patch shows if one in this many attractors lies in it, out of sight.
        const PATCH: u32 = 50;
        let is_patch = |lost: u32| lost > self.attractors.count() / PATCH;
        if (self.is_searching() || is_patch(self.unreached - self.attractors.remaining().count() as u32))
            && let Some(Shore { at, inland }) = self.driest_shore()
        {
            self.plant(Mouth { at, inland }, &[]);
        }
    }

    /// The place on a coast from which the most attractors are in reach that no node has, apart from all mouths; the first of
    /// equals. `None` also while the search for it is under way.
    fn driest_shore(&mut self) -> Option<Shore> {
        let Self { settings, attractors, mouths, search, .. } = self;
        let seen_from = |shore: Vec2| {
            work::count(mouths.len());
            if mouths.iter().any(|mouth| mouth.distance(shore) <= settings.mouth_spacing) {
                return 0;
            }
            let is_lost = |&(owner, place): &(u32, Vec2)| owner == NO_NODE && settings.sees(shore, place);
            attractors.within_reach(shore).filter(is_lost).count() as u32
        };
        search.get_or_insert_with(|| Box::new(Search::among(shores(settings)))).go_on(seen_from)
    }

    fn is_searching(&self) -> bool {
        self.search.as_ref().is_some_and(|search| search.is_under_way())
    }

    /// Whether most attractors are left.
    fn is_dry(&self) -> bool {
        self.ending.is_none() && self.unreached > self.attractors.count() / 2
    }

    /// When a tree has died out among attractors that are all beyond its reach: its last node runs straight on, like a
    /// root that nothing reaches.
    fn extend_last_tip(&mut self) {
        let Some(tip) = self.tree.len().checked_sub(1) else { return };
        let Some(parent) = self.tree.parent_of(tip) else { return };
        let onward = (self.tree.at[tip] - self.tree.at[parent]) / self.settings.step;
        let pilot = StraightTip { tip: tip as u32, inland: onward };
        if let Some(tip) = self.extend(pilot) {
            self.pilots.push(StraightTip { tip, ..pilot });
        }
    }

    /// Adds a node straight inland; `None` where the land ends.
    fn extend(&mut self, StraightTip { tip, inland }: StraightTip) -> Option<u32> {
        let from = self.tree.at[tip as usize];
        let at = from + inland * self.settings.step;
        self.settings.allows(from, at).then(|| self.add(at, tip))
    }

    /// Attractors that pull to the end, but were never come near to, drain to their nearest node all the same.
    fn finish(&mut self) {
        self.ending.get_or_insert(Ending::Complete);
        for (owner, _) in self.attractors.remaining() {
            self.tree.drained[owner as usize] += 1;
        }
    }
}

impl Colonize {
    /// The tree so far.
    pub fn tree(&self) -> &Tree {
        &self.tree
    }

    /// The settings it grows by.
    pub fn settings(&self) -> &GrowthSettings {
        &self.settings
    }

    /// How growth ended; `None` while it goes on.
    pub fn ending(&self) -> Option<Ending> {
        self.ending
    }

    /// How many mouths were planted.
    pub fn mouths(&self) -> u32 {
        self.mouths.len() as u32
    }

    /// How many attractors were scattered.
    pub fn attractors(&self) -> u32 {
        self.attractors.count()
    }

    /// How many attractors are not used up: no river has come near enough.
    pub fn unreached(&self) -> u32 {
        self.unreached
    }

    /// Stops growth before the tree has more nodes than this.
    #[must_use]
    pub fn with_node_limit(self, node_limit: usize) -> Self {
        Self { node_limit, ..self }
    }

    /// Allocates memory for more nodes.
    fn reserve(&mut self, nodes: usize) -> Result<(), Refused> {
        memory::reserve(&mut self.tree.at, nodes)?;
        memory::reserve(&mut self.tree.parent, nodes)?;
        memory::reserve(&mut self.tree.drained, nodes)?;
        memory::reserve(&mut self.shoots.pull, nodes)?;
        memory::reserve(&mut self.shoots.from_mouth, nodes)?;
        memory::reserve(&mut self.shoots.youngest, nodes)?;
        memory::reserve(&mut self.shoots.elder, nodes)
    }

    /// How many nodes the drawn courses have at most.
    fn stem_nodes(&self) -> usize {
        let points: usize = self.settings.starts.iter().map(|start| start.course.len()).sum();
        (points as f32 * PIECE / self.settings.step) as usize
    }

    /// About how many nodes a tree has, rather too many: by trials over reach 2.4 to 10, kill 0.5 to 2 and step 0.2 to 1
    /// the number goes with kill^−½ and step^−¾ (both in spacings).
    fn usual_nodes(&self) -> usize {
        let GrowthSettings { attractors, spacing, kill, step, .. } = self.settings;
        let (kill, step) = (kill / spacing, (step / spacing).sqrt());
        (0.65 * attractors as f32 / (kill.sqrt() * step * step.sqrt())) as usize
    }
}

/// How many nodes of a stem make about a spacing.
pub fn stem_nodes(settings: &GrowthSettings) -> u32 {
    ((settings.spacing / settings.step + 0.5) as u32).max(1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::recipe::link;

    fn grown(link: &str, nodes_a_tick: usize) -> Tree {
        let mut growth = Colonize::new(GrowthSettings::of(&link::read(link).unwrap())).unwrap();
        growth.nodes_a_tick = nodes_a_tick;
        while growth.tick() {}
        growth.tree
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
