//! A session: one recipe at a time, each stage's result kept, and after a change only what it touches run again.

use thiserror::Error;

use crate::grow::{Ending, GrowError, Growth, Parameters};
use crate::memory;
use crate::network::{self, Courses, Meander, NONE, Network};
use crate::paint::{PaintError, Painter, Progress, Rect, Rivers};
use crate::prune::{self, Pruned, Trim};
use crate::recipe::{GrowthMethod, Key, Recipe, Stage, Style};
use crate::tree::{Hydrology, Tree};

/// Why a recipe cannot be shown.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum SessionError {
    /// It cannot be grown.
    #[error(transparent)]
    Grow(#[from] GrowError),
    /// It cannot be painted.
    #[error(transparent)]
    Paint(#[from] PaintError),
    /// The memory to make rivers of its tree was not to be had.
    #[error("attractors: rivers of {nodes} nodes need about {megabytes} MB, which this machine does not give")]
    NoRivers {
        /// How many nodes the tree has.
        nodes: u32,
        /// About how much is needed.
        megabytes: u32,
    },
}

/// A recipe, its tree as far as it has grown, and its picture.
///
/// ```
/// use riverseed::{recipe::link, session::Session};
///
/// let recipe = link::read("seed=kauri&curl=0.6")?;
/// let mut session = Session::new(recipe, 300, 200)?;
/// while session.advance(10)? {
///     session.paint(); // only what is new
/// }
/// session.paint();
/// assert_eq!(session.pixmap().width(), 300);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Session {
    recipe: Recipe,
    growth: Growth,
    /// Once growth has ended.
    shaped: Option<Shaped>,
    painter: Painter,
}

/// A tree on its way to rivers.
#[derive(Clone, Debug)]
struct Shaped {
    /// How many nodes are left of the tree, trimmed.
    nodes: u32,
    rivers: Shaping,
}

/// What has been made of a tree: a stage a step, so that none keeps a page waiting for long.
#[derive(Clone, Debug)]
enum Shaping {
    Courses(Network),
    Ranked(Courses),
    /// Smooth courses, and how often they may be thinned out.
    Smooth(Courses, Network, u32),
    Rivers(Courses, Box<Meander>),
}

impl Shaping {
    /// Goes back to the courses that were smoothed: they are to be simplified otherwise.
    fn unsmooth(&mut self) {
        if let Self::Smooth(courses, ..) = self {
            *self = Self::Ranked(std::mem::take(courses));
        }
    }
}

/// What the next step of a session does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Phase {
    /// A tick of growth.
    Growing,
    /// Rivers are made of the tree, in a few steps.
    Shaping,
    /// A round of meandering.
    Meandering,
    /// Nothing: there is nothing more to do.
    Finished,
}

/// What a picture shows, in numbers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Summary {
    /// Ticks grown.
    pub ticks: u32,
    /// Nodes: of the trimmed tree once it is grown.
    pub nodes: u32,
    /// River mouths: those that trimming has left, once there are rivers.
    pub mouths: u32,
    /// Sources of the rivers; 0 until there are any.
    pub sources: u32,
    /// The highest stream order (Strahler) of the rivers; 0 until there are any.
    pub order: u8,
    /// Attractors scattered: none for a Brownian tree.
    pub attractors: u32,
    /// Attractors that no river came near enough to.
    pub unreached: u32,
    /// How growth ended; `None` while it goes on.
    pub ending: Option<Ending>,
    /// Rounds that rivers have meandered.
    pub rounds: u32,
    /// Oxbow lakes that they have left.
    pub oxbows: u32,
}

impl Summary {
    /// Whether growth ended with over a tenth of the attractors left, or no river has grown at all: step is then too long for
    /// kill, reach too small, mouths too far apart, or the land shut off from the sea.
    pub fn is_stalled(&self) -> bool {
        self.ending == Some(Ending::Complete) && (self.nodes == 0 || self.unreached > self.attractors / 10)
    }
}

impl Session {
    /// Plants a recipe, for a picture of the given size in pixels.
    ///
    /// # Errors
    /// If a side is out of range, or the memory is not to be had.
    pub fn new(recipe: Recipe, width: u32, height: u32) -> Result<Self, SessionError> {
        let growth = Growth::new(Parameters::of(&recipe))?;
        let painter = Painter::new(&growth.parameters().domain, width, height)?;
        Ok(Self { recipe, growth, shaped: None, painter })
    }

    /// The recipe.
    pub fn recipe(&self) -> &Recipe {
        &self.recipe
    }

    /// How it is painted.
    pub fn style(&self) -> Style {
        self.recipe.get()
    }

    /// Goes over to another recipe. Returns the earliest stage that has to run again, `None` if nothing is different.
    ///
    /// # Errors
    /// As [`Session::new`]; everything is then as before.
    pub fn change(&mut self, recipe: Recipe) -> Result<Option<Stage>, SessionError> {
        let stage = self.recipe.first_difference(&recipe);
        match stage {
            Some(Stage::Land) => self.grow(Parameters::of(&recipe), recipe)?,
            Some(Stage::Grow) => {
                let land = self.growth.parameters().land.clone();
                self.grow(Parameters::on_land(&recipe, land), recipe)?;
            }
            Some(Stage::Prune) => {
                self.recipe = recipe;
                self.shaped = None;
                self.painter.start_over();
            }
            Some(Stage::Shape) => {
                self.recipe = recipe;
                let parameters = network::Parameters::of(&self.recipe, &self.growth);
                match self.shaped.as_mut().map(|shaped| &mut shaped.rivers) {
                    Some(Shaping::Rivers(courses, meander)) => **meander = Meander::new(courses, parameters),
                    Some(rivers @ Shaping::Smooth(..)) => rivers.unsmooth(),
                    _ => {}
                }
                self.painter.start_over();
            }
            Some(Stage::Paint) => {
                self.recipe = recipe;
                self.painter.start_over();
            }
            None => {}
        }
        Ok(stage)
    }

    /// Plants another recipe. The picture's memory is kept if its shape is, and the land that it shows.
    fn grow(&mut self, parameters: Parameters, recipe: Recipe) -> Result<(), SessionError> {
        let growth = Growth::new(parameters)?;
        let (old, new) = (self.growth.parameters(), growth.parameters());
        let is_same_land = old.is_on_land_of(new);
        if old.domain == new.domain {
            self.painter.start_over();
        } else {
            self.painter = Painter::new(&new.domain, self.pixmap().width(), self.pixmap().height())?;
        }
        if !is_same_land {
            self.painter.leave_land();
        }
        (self.recipe, self.growth, self.shaped) = (recipe, growth, None);
        Ok(())
    }

    /// Paints the same rivers at another size.
    ///
    /// # Errors
    /// If a side is out of range; everything is then as before.
    pub fn resize(&mut self, width: u32, height: u32) -> Result<(), SessionError> {
        self.painter = Painter::new(&self.growth.parameters().domain, width, height)?;
        Ok(())
    }

    /// Goes back to tick 0.
    ///
    /// # Errors
    /// If the memory is not to be had; everything is then as before.
    pub fn restart(&mut self) -> Result<(), SessionError> {
        self.growth = Growth::new(self.growth.parameters().clone())?;
        self.shaped = None;
        self.painter.start_over();
        Ok(())
    }

    /// Goes on by so many steps at most: ticks of growth, then a few that make rivers of the tree, then rounds of meandering.
    /// Returns whether there is more to do. No recipe is known of which a step takes more than 8 million elementary steps, as
    /// [`crate::work`] counts them, and 250 for each attractor or cell of a Brownian tree.
    ///
    /// # Errors
    /// If the memory for the rest of the tree, or for its rivers, is not to be had. What is there then is no picture of the
    /// recipe, and there are no rivers to export. A further call meets the same error, or goes on if there is memory by
    /// then; a tree that is not whole only grows anew, after [`Session::restart`] or [`Session::change`].
    pub fn advance(&mut self, steps: u32) -> Result<bool, SessionError> {
        for _ in 0..steps {
            if !self.step()? {
                return Ok(false);
            }
        }
        Ok(true)
    }

    fn step(&mut self) -> Result<bool, SessionError> {
        if self.growth.ending().is_none() {
            self.growth.tick();
            return self.growth.failure().map_or(Ok(true), |failure| Err(failure.into()));
        }
        if let Some(failure) = self.growth.failure() {
            return Err(failure.into());
        }
        self.shaped = Some(match self.shaped.take() {
            None => self.draw_courses()?,
            Some(Shaped { nodes, rivers }) => Shaped { nodes, rivers: self.shape(rivers) },
        });
        Ok(!self.is_finished())
    }

    /// Finds the courses of rivers in the tree.
    fn draw_courses(&self) -> Result<Shaped, SessionError> {
        /// Of the trimmed tree, and both trees' hydrology.
        const BYTES_A_NODE_TO_TRIM: usize = 64;
        /// By trials with less and less memory, rivers of 300,000 attractors take 200 to 235 at most.
        const BYTES_A_NODE: usize = 256;
        ask_for_rivers(self.tree().len(), BYTES_A_NODE_TO_TRIM)?;
        let Pruned { tree, .. } = self.pruned();
        ask_for_rivers(tree.len(), BYTES_A_NODE)?;
        // The rivers of a Brownian tree never touch, so they do not cross.
        let may_cross = self.growth.parameters().method == GrowthMethod::Colonize;
        let rivers = Shaping::Courses(Courses::unranked(&tree, may_cross));
        Ok(Shaped { nodes: tree.len() as u32, rivers })
    }

    /// The next stage of rivers.
    fn shape(&self, rivers: Shaping) -> Shaping {
        match rivers {
            Shaping::Courses(network) => {
                Shaping::Ranked(Courses::ranked(network, self.growth.parameters().land.as_deref()))
            }
            Shaping::Ranked(courses) => {
                let network = network::smooth_courses(&courses, &self.network_parameters());
                Shaping::Smooth(courses, network, network::THINNINGS)
            }
            Shaping::Smooth(courses, mut network, times) => {
                if times > 0 && network::thin_out(&mut network, &self.network_parameters()) {
                    return Shaping::Smooth(courses, network, times - 1);
                }
                let meander = Box::new(Meander::along(network, self.network_parameters()));
                Shaping::Rivers(courses, meander)
            }
            Shaping::Rivers(courses, mut meander) => {
                meander.round();
                Shaping::Rivers(courses, meander)
            }
        }
    }

    /// Whether there is nothing more to do.
    pub fn is_finished(&self) -> bool {
        self.phase() == Phase::Finished
    }

    /// What the next step does.
    pub fn phase(&self) -> Phase {
        match self.shaped.as_ref().map(|shaped| &shaped.rivers) {
            Some(Shaping::Rivers(_, meander)) if !meander.is_finished() => Phase::Meandering,
            Some(Shaping::Rivers(..)) => Phase::Finished,
            Some(Shaping::Courses(_) | Shaping::Ranked(_) | Shaping::Smooth(..)) => Phase::Shaping,
            None if self.growth.ending().is_some() => Phase::Shaping,
            None => Phase::Growing,
        }
    }

    /// How far what the next step goes on with has come, from 0 to 1: growth by what is drained, meandering by its rounds.
    /// 0 while rivers are made of the tree, and when all is finished.
    pub fn progress(&self) -> f32 {
        match (self.phase(), self.meander()) {
            (Phase::Growing, _) => self.growth.progress(),
            (Phase::Meandering, Some(meander)) => meander.rounds() as f32 / meander.parameters().rounds.max(1) as f32,
            _ => 0.0,
        }
    }

    /// The rivers; `None` while there are none yet.
    pub fn network(&self) -> Option<&Network> {
        self.meander().map(Meander::network)
    }

    fn meander(&self) -> Option<&Meander> {
        match &self.shaped {
            Some(Shaped { rivers: Shaping::Rivers(_, meander), .. }) => Some(meander),
            _ => None,
        }
    }

    /// How the rivers of this recipe are made of its tree.
    pub fn network_parameters(&self) -> network::Parameters {
        network::Parameters::of(&self.recipe, &self.growth)
    }

    /// Brings the picture up to date. Returns the rectangle that changed; `None` if nothing did.
    pub fn paint(&mut self) -> Option<Rect> {
        let recipe = &self.recipe;
        let land = self.growth.parameters().land.as_deref();
        if let Some(Shaped { rivers: Shaping::Rivers(_, meander), .. }) = &self.shaped {
            let (network, rounds) = (meander.network(), meander.rounds());
            return self.painter.paint_rivers(&Rivers { network, rounds, land, style: recipe.get() });
        }
        self.painter.paint(&Progress {
            tree: self.growth.tree(),
            finished: self.growth.ending().is_some(),
            trim: Trim::of(recipe),
            everything: self.growth.everything(),
            full_width: recipe.number(Key::Width),
            land,
            style: recipe.get(),
        })
    }

    /// The picture: RGBA, opaque.
    pub fn pixmap(&self) -> &tiny_skia::Pixmap {
        self.painter.pixmap()
    }

    /// The untrimmed tree, as far as it has grown.
    pub fn tree(&self) -> &Tree {
        self.growth.tree()
    }

    /// Growth in progress.
    pub fn growth(&self) -> &Growth {
        &self.growth
    }

    /// The trimmed tree with its hydrology, as things stand.
    pub fn pruned(&self) -> Pruned {
        let tree = self.growth.tree();
        prune::trim(tree, &Hydrology::of(tree), Trim::of(&self.recipe))
    }

    /// The picture in numbers. While growth goes on this costs nothing, and does not know order and sources yet.
    pub fn summary(&self) -> Summary {
        let tree = self.growth.tree();
        let so_far = Summary {
            ticks: tree.tick_starts.len() as u32 - 1,
            nodes: tree.len() as u32,
            mouths: self.growth.mouths(),
            sources: 0,
            order: 0,
            attractors: self.growth.attractors(),
            unreached: self.growth.unreached(),
            ending: self.growth.ending(),
            rounds: 0,
            oxbows: 0,
        };
        match &self.shaped {
            Some(Shaped { nodes, rivers: Shaping::Rivers(_, meander) }) => {
                let rivers = &meander.network().rivers;
                Summary {
                    nodes: *nodes,
                    mouths: rivers.iter().filter(|river| river.joins == NONE).count() as u32,
                    sources: rivers.len() as u32,
                    order: rivers.iter().map(|river| river.order).max().unwrap_or(0),
                    rounds: meander.rounds(),
                    oxbows: meander.network().oxbows.len() as u32,
                    ..so_far
                }
            }
            _ => so_far,
        }
    }
}

/// Asks for the memory of so many nodes on their way to rivers.
fn ask_for_rivers(nodes: usize, bytes_a_node: usize) -> Result<(), SessionError> {
    let bytes = nodes * bytes_a_node;
    if memory::is_to_be_had(bytes) {
        return Ok(());
    }
    Err(SessionError::NoRivers { nodes: nodes as u32, megabytes: (bytes / 1_000_000) as u32 + 1 })
}
#[cfg(test)]
mod tests;
