//! The painter: keeps a picture up to date with a growing tree by drawing only what is new.
//!
//! While a tree grows, it is not known yet what trimming will take. A node at least as deep as the trimming threshold
//! will certainly stay (its depth can only grow), so those are drawn at once, the growing tips a little later; when
//! growth is over, all that stays is drawn. The finished picture is the one painted at once, to the byte.

use std::sync::Arc;

use tiny_skia::Pixmap;

use super::coverage::{Coverage, Rect};
use super::flow::Flow;
use super::ground::ground;
use super::palette::{LAND_ONLY, Lines, palette};
use super::relief::{Surface, lay_casing};
use super::rivers::draw_network;
use super::strokes::{Pen, Widths};
use super::view::{PaintError, View};
use super::{ink, skeleton};
use crate::domain::Domain;
use crate::land::Land;
use crate::memory;
use crate::network::Network;
use crate::prune::{self, Trim};
use crate::recipe::{CourseShape, Style};
use crate::relief::Relief;
use crate::tree::Tree;

/// A tree to be painted, as far as it has grown.
#[derive(Clone, Copy, Debug)]
pub struct Progress<'a> {
    /// The untrimmed tree. Between two calls it may only have grown.
    pub tree: &'a Tree,
    /// Whether it will not grow any more.
    pub finished: bool,
    /// How it will be trimmed.
    pub trim: Trim,
    /// The discharge that would be everything a river can drain.
    pub total_discharge: u32,
    /// The width, in domain units, of a river that drains everything.
    pub max_width: f32,
    /// The lines that rivers follow.
    pub courses: CourseShape,
    /// The land; `None` if all of the domain is.
    pub land: Option<&'a Land>,
    /// The style.
    pub style: Style,
}

/// A picture in the making.
#[derive(Clone, Debug)]
pub struct Painter {
    view: View,
    pixmap: Pixmap,
    coverage: Coverage,
    /// The radius that each node was last drawn with; 0 before it is drawn.
    drawn: Vec<u16>,
    flow: Flow,
    /// The picture without rivers, in a style; painted when it is first needed, and not for plain land.
    ground: Option<(Style, Vec<[u8; 4]>)>,
    /// The relief on the ground, and how much it is exaggerated.
    raised: Option<(Arc<Relief>, f32)>,
    /// Whether nothing of the picture can be kept.
    is_blank: bool,
    /// Whether the picture shows a finished tree.
    is_finished: bool,
    /// The round that the rivers shown have meandered to; `None` as long as a tree is shown.
    round: Option<u32>,
}

/// Rivers to be painted.
#[derive(Clone, Copy, Debug)]
pub struct Rivers<'a> {
    /// The network. Between two calls only rounds of meandering may have changed it.
    pub network: &'a Network,
    /// How many rounds that were.
    pub rounds: u32,
    /// The lines that rivers follow.
    pub courses: CourseShape,
    /// The land; `None` if all of the domain is.
    pub land: Option<&'a Land>,
    /// The relief, and by how much its slopes are exaggerated; `None` while there is none.
    pub relief: Option<(&'a Arc<Relief>, f32)>,
    /// The style.
    pub style: Style,
}

impl Painter {
    /// An empty picture.
    ///
    /// # Errors
    /// If a side is 0 or too long, or there is not enough memory.
    pub fn new(domain: &Domain, width: u32, height: u32) -> Result<Self, PaintError> {
        /// Of picture, ground, mask, and the copy that is thinned.
        const BYTES_A_PIXEL: usize = 10;
        let view = View::new(domain, width, height)?;
        let bytes = BYTES_A_PIXEL * width as usize * height as usize;
        if !memory::can_allocate(bytes) {
            return Err(PaintError::OutOfMemory { width, height, megabytes: (bytes / 1_000_000) as u32 + 1 });
        }
        let none = PaintError::Size { width, height };
        let pixmap = Pixmap::new(width, height).ok_or(none.clone())?;
        let coverage = Coverage::new(width, height).ok_or(none)?;
        let (drawn, flow) = (Vec::new(), Flow::default());
        Ok(Self {
            view,
            pixmap,
            coverage,
            drawn,
            flow,
            ground: None,
            raised: None,
            is_blank: true,
            is_finished: false,
            round: None,
        })
    }

    /// The picture: RGBA, opaque.
    pub fn pixmap(&self) -> &Pixmap {
        &self.pixmap
    }

    /// Forgets the ground: other land comes next, of a domain that may have another shape.
    pub fn invalidate_ground(&mut self, next: &Domain) {
        self.view = self.view.of(next);
        self.ground = None;
        self.raised = None;
    }

    /// Forgets the picture: another tree, trim, width or style comes next.
    pub fn reset(&mut self) {
        if self.raised.take().is_some() {
            self.ground = None;
        }
        self.coverage.clear();
        self.drawn.clear();
        self.flow = Flow::default();
        self.is_blank = true;
        self.is_finished = false;
        self.round = None;
    }

    /// Brings the picture up to date. Returns the rectangle that changed; `None` if nothing did.
    pub fn paint(&mut self, progress: &Progress<'_>) -> Option<Rect> {
        if self.is_finished {
            return None;
        }
        let (tree, pen) = (progress.tree, Pen::new(self.view, widths(progress), progress.courses));
        if progress.finished || self.flow.is_stale(tree) {
            self.flow.measure(tree, &pen, progress.trim.channel_area);
            self.draw_changes(progress, &pen);
        } else if progress.trim.channel_area == 0 {
            let near_tip = self.flow.follow(tree, &pen, progress.trim.nodes);
            let radii = &self.flow.radii;
            near_tip.iter().for_each(|&child| pen.draw(&mut self.coverage, tree, radii, child as usize));
        }
        self.is_finished = progress.finished;
        if std::mem::take(&mut self.is_blank) || (progress.finished && palette(progress.style).lines == Lines::Skeleton)
        {
            self.coverage.touch_all();
        }
        self.lay_ground(progress.land, progress.style);
        self.compose(progress.style)
    }

    /// Paints rivers, in place of the tree that they were. Returns the rectangle that changed; `None` if nothing did.
    pub fn paint_rivers(&mut self, rivers: &Rivers<'_>) -> Option<Rect> {
        let is_raised = same_relief(self.raised.as_ref(), rivers.relief);
        if self.round == Some(rivers.rounds) && is_raised {
            return None;
        }
        self.round = Some(rivers.rounds);
        self.is_finished = true;
        self.coverage.clear();
        draw_network(&mut self.coverage, &self.view, rivers.network, rivers.courses, palette(rivers.style).lines, 0.0);
        self.coverage.touch_all();
        if !is_raised {
            self.ground = None;
        }
        // Ground that is laid again, in another style, say, is flat.
        self.lay_ground(rivers.land, rivers.style);
        if self.raised.is_none()
            && let Some((relief, exaggeration)) = rivers.relief
        {
            self.raise_ground(rivers, relief, exaggeration);
            self.raised = Some((relief.clone(), exaggeration));
        }
        self.compose(rivers.style)
    }

    /// Paints the ground if it is not there yet.
    fn lay_ground(&mut self, land: Option<&Land>, style: Style) {
        if self.ground.as_ref().is_none_or(|(painted, _)| *painted != style) {
            self.ground = land.map(|land| (style, ground(&self.view, land, palette(style))));
            self.raised = None;
        }
    }

    /// Lays relief over a fresh ground, and casings along the rivers.
    fn raise_ground(&mut self, rivers: &Rivers<'_>, relief: &Relief, exaggeration: f32) {
        let palette = palette(rivers.style);
        let Some(tints) = palette.relief else { return };
        let count = self.view.width as usize * self.view.height as usize;
        let [r, g, b] = palette.plain;
        let (_, pixels) = self.ground.get_or_insert_with(|| (rivers.style, vec![[r, g, b, 255]; count]));
        let shares = rivers.land.map_or_else(
            || vec![255; count],
            |land| ground(&self.view, land, &LAND_ONLY).into_iter().map(|[share, ..]| share).collect(),
        );
        Surface::new(relief, exaggeration).lay(&self.view, tints, palette.plain, &shares, pixels);
        if let Some(mut coverage) = Coverage::new(self.view.width, self.view.height) {
            draw_network(&mut coverage, &self.view, rivers.network, rivers.courses, palette.lines, tints.casing.margin);
            lay_casing(&self.view, coverage, &tints.casing, pixels);
        }
    }

    /// Draws all strokes that are new or have grown wider since this was last called. Strokes near the tips have been
    /// drawn in between, too; drawing them again, now at least as wide, leaves no trace of that.
    fn draw_changes(&mut self, progress: &Progress<'_>, pen: &Pen) {
        let Progress { tree, finished, trim, .. } = *progress;
        let Flow { depth, discharge, .. } = &self.flow;
        let stays = if finished {
            prune::stays(tree, depth, discharge, trim)
        } else {
            let is_certain = |(&depth, &discharge)| depth >= trim.nodes && discharge >= trim.channel_area;
            depth.iter().zip(discharge).map(is_certain).collect()
        };
        self.drawn.resize(tree.len(), 0);
        let radii = &self.flow.radii;
        for child in (0..tree.len()).filter(|&child| stays[child]) {
            let Some(node) = tree.parent_of(child) else { continue };
            let below = tree.parent_of(node).unwrap_or(node);
            let wider = |node: usize| radii[node] > self.drawn[node];
            if wider(child) || wider(node) || wider(below) {
                pen.draw(&mut self.coverage, tree, radii, child);
            }
        }
        for (drawn, (&radius, &stays)) in self.drawn.iter_mut().zip(radii.iter().zip(&stays)) {
            if stays {
                *drawn = radius;
            }
        }
    }

    /// Lays colour where the mask has changed. Returns the rectangle around that.
    fn compose(&mut self, style: Style) -> Option<Rect> {
        let touched = self.coverage.take_touched();
        let around = touched.iter().copied().reduce(Rect::union)?;
        let ground = self.ground.as_ref().map(|(_, ground)| ground.as_slice());
        match palette(style).lines {
            Lines::Wide => {
                ink::compose(&mut self.pixmap, &self.coverage, ground, palette(style), &touched);
            }
            Lines::Skeleton if self.is_finished => {
                skeleton::compose_thinned(&mut self.pixmap, &self.coverage, ground);
                return Some(self.coverage.bounds());
            }
            Lines::Skeleton => {
                touched.iter().for_each(|&rect| skeleton::compose(&mut self.pixmap, &self.coverage, ground, rect));
            }
        }
        Some(around)
    }
}

fn same_relief(shown: Option<&(Arc<Relief>, f32)>, next: Option<(&Arc<Relief>, f32)>) -> bool {
    match (shown, next) {
        (None, None) => true,
        (Some((shown, by)), Some((next, by_next))) => Arc::ptr_eq(shown, next) && *by == by_next,
        (None, Some(_)) | (Some(_), None) => false,
    }
}

fn widths(progress: &Progress<'_>) -> Widths {
    match palette(progress.style).lines {
        Lines::Wide => Widths::ByDischarge { full: progress.max_width, total_discharge: progress.total_discharge },
        Lines::Skeleton => Widths::Even { width_px: skeleton::WIDTH_PX },
    }
}
