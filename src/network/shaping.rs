//! From a tree to rivers, as a stepper: courses, the order in which their vertices go, smooth courses, thinned out in a few
//! steps, then widths and rounds of meandering. No step keeps a page waiting for long. Courses as grown keep all their vertices, the
//! nodes of the tree, where they are: only widths are made.

use std::sync::Arc;

use thiserror::Error;

use super::courses::Courses;
use super::meander::{Meander, smooth_courses, thin_out};
use super::{Network, NetworkSettings, PastCourses};
use crate::base::memory;
use crate::land::Land;
use crate::recipe::CourseShape;
use crate::tree::Tree;

/// The reason why a tree cannot be made into rivers.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum ShapeError {
    /// There was not enough memory.
    #[error("the rivers of {nodes} nodes need about {megabytes} MB, and the allocation failed")]
    OutOfMemory {
        /// The number of nodes in the tree.
        nodes: u32,
        /// The memory that is needed, approximately.
        megabytes: u32,
    },
}

/// A tree on its way to rivers.
#[derive(Clone, Debug)]
pub struct Shaping {
    settings: NetworkSettings,
    /// The land; `None` if all of the domain is.
    land: Option<Arc<Land>>,
    /// The number of nodes in the tree.
    nodes: u32,
    state: State,
}

#[derive(Clone, Debug, Default)]
enum State {
    /// No state: only while a step is made.
    #[default]
    Between,
    Courses(Network),
    Ranked(Courses),
    /// Smooth courses, and how often they may still be thinned out; or courses as grown, which are not.
    Smooth(Courses, Network, u32),
    Rivers(Courses, Box<Meander>),
}

/// The greatest number of times that courses are thinned out.
const THINNINGS: u32 = 4;

impl Shaping {
    /// Finds the courses of rivers in a tree, which may have been trimmed, and may come from anywhere. `may_cross` says
    /// whether its steps may cross each other; `land` is `None` if all of the domain is.
    ///
    /// # Errors
    /// If there is not enough memory for its rivers.
    pub fn new(
        tree: &Tree,
        may_cross: bool,
        land: Option<Arc<Land>>,
        settings: NetworkSettings,
    ) -> Result<Self, ShapeError> {
        /// By trials with less and less memory, rivers of 300,000 attractors take 200 to 235 bytes a node at most.
        const BYTES_A_NODE: usize = 256;
        ask_for_memory(tree.len(), BYTES_A_NODE, PastCourses::BYTES)?;
        let state = State::Courses(Courses::unranked(tree, may_cross));
        Ok(Self { settings, land, nodes: tree.len() as u32, state })
    }

    /// Does a step of the work. Returns `true` if there is more to do.
    pub fn step(&mut self) -> bool {
        self.state = match std::mem::take(&mut self.state) {
            State::Between => State::Between,
            State::Courses(network) => State::Ranked(Courses::ranked(network, self.land.as_deref())),
            State::Ranked(courses) if self.settings.courses == CourseShape::Grown => {
                let network = courses.network.clone();
                State::Smooth(courses, network, 0)
            }
            State::Ranked(courses) => {
                let network = smooth_courses(&courses, self.land.as_deref(), &self.settings);
                State::Smooth(courses, network, THINNINGS)
            }
            State::Smooth(courses, mut network, times) => {
                if times > 0 && thin_out(&mut network, &self.settings) {
                    State::Smooth(courses, network, times - 1)
                } else {
                    let meander = Meander::along(network, self.land.clone(), self.settings.clone());
                    State::Rivers(courses, Box::new(meander))
                }
            }
            State::Rivers(courses, mut meander) => {
                meander.step();
                State::Rivers(courses, meander)
            }
        };
        !self.is_finished()
    }

    /// Changes to other settings for the same tree on the same land. Whatever depends on the settings is discarded, and
    /// made again by the steps that follow.
    pub fn change(&mut self, settings: NetworkSettings) {
        self.settings = settings;
        self.state = match std::mem::take(&mut self.state) {
            State::Smooth(courses, ..) | State::Rivers(courses, _) => State::Ranked(courses),
            state => state,
        };
    }

    /// Makes sure that the rivers, which the next rounds change, are not shared: copies them if need be.
    pub(crate) fn unshare(&mut self) {
        if let State::Rivers(_, meander) = &mut self.state {
            meander.unshare();
        }
    }

    /// Returns `true` if there is nothing more to do.
    pub fn is_finished(&self) -> bool {
        self.meander().is_some_and(Meander::is_finished)
    }

    /// Returns the meandering rivers; `None` until there are any.
    pub fn meander(&self) -> Option<&Meander> {
        match &self.state {
            State::Rivers(_, meander) => Some(meander),
            _ => None,
        }
    }

    /// Returns the rivers; `None` until there are any.
    pub fn network(&self) -> Option<&Network> {
        self.meander().map(|meander| &**meander.network())
    }

    /// Returns the courses as the tree has them, and the ranking of their vertices; `None` until that is known.
    pub fn courses(&self) -> Option<&Courses> {
        match &self.state {
            State::Ranked(courses) | State::Smooth(courses, ..) | State::Rivers(courses, _) => Some(courses),
            State::Between | State::Courses(_) => None,
        }
    }

    /// Returns the settings that rivers are made with.
    pub fn settings(&self) -> &NetworkSettings {
        &self.settings
    }

    /// Returns the number of nodes in the tree.
    pub fn nodes(&self) -> u32 {
        self.nodes
    }
}

/// Checks that there is enough memory for a number of nodes, and for `more` bytes.
///
/// # Errors
/// If there is not enough.
pub(crate) fn ask_for_memory(nodes: usize, bytes_a_node: usize, more: usize) -> Result<(), ShapeError> {
    let bytes = nodes.saturating_mul(bytes_a_node).saturating_add(more);
    if memory::can_allocate(bytes) {
        return Ok(());
    }
    Err(ShapeError::OutOfMemory { nodes: nodes as u32, megabytes: (bytes / 1_000_000) as u32 + 1 })
}
