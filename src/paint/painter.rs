//! The painter: keeps a picture up to date with a growing tree by drawing only what is new.
//!
//! While a tree grows, it is not known yet what trimming will take. A node at least as deep as the trimming threshold
//! will certainly stay (its depth can only grow), so those are drawn at once, the growing tips a little later; when
//! growth is over, all that stays is drawn. The finished picture is the one painted at once, to the byte.

use std::sync::Arc;

use tiny_skia::Pixmap;

use super::chart::{self, ChartMasks};
use super::coverage::{Coverage, Rect};
#[cfg(feature = "files")]
use super::cut_out;
use super::flow::Flow;
use super::ground_cache::GroundCache;
use super::palette::Lines;
use super::rivers::{Rivers, Widening, draw_network};
use super::strokes::{Pen, Widths};
use super::styles::palette;
use super::view::{Framing, PaintError, View};
use super::{ink, skeleton};
use crate::domain::Domain;
use crate::land::Land;
use crate::memory;
#[cfg(feature = "controls")]
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

/// What came of painting.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Painted {
    /// Nothing to be seen yet: there is more to do.
    Part,
    /// The picture is up to date. With the rectangle that changed; `None` if nothing did.
    Whole(Option<Rect>),
}

impl Painted {
    /// The rectangle that changed; `None` if nothing did.
    pub fn changed(self) -> Option<Rect> {
        match self {
            Self::Part => None,
            Self::Whole(changed) => changed,
        }
    }
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
    /// The picture without rivers.
    ground: GroundCache,
    /// Whether nothing of the picture can be kept.
    is_blank: bool,
    /// Whether the picture shows a finished tree.
    is_finished: bool,
    /// The round that the rivers shown have meandered to; `None` as long as a tree is shown.
    round: Option<u32>,
    /// The relief of the finished rivers that the mask shows, which has but these, and the lines; `None` if it shows anything else.
    drawn_rivers: Option<(Arc<Relief>, Lines)>,
    /// The chart that the picture shows.
    chart: Option<Arc<ChartMasks>>,
}

impl Painter {
    /// An empty picture.
    ///
    /// # Errors
    /// If a side is 0 or too long, or there is not enough memory.
    pub fn new(domain: &Domain, width: u32, height: u32) -> Result<Self, PaintError> {
        /// Of picture, mask and ground. The copy of the mask that a skeleton thins is less than what a relief takes.
        const BYTES_A_PIXEL: usize = 4 + 1 + GroundCache::BYTES_A_PIXEL;
        let view = View::new(domain, width, height)?;
        let bytes = BYTES_A_PIXEL * view.pixels() + GroundCache::BYTES;
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
            ground: GroundCache::default(),
            is_blank: true,
            is_finished: false,
            round: None,
            drawn_rivers: None,
            chart: None,
        })
    }

    /// The picture: RGBA, opaque.
    pub fn pixmap(&self) -> &Pixmap {
        &self.pixmap
    }

    /// Forgets the ground: other land comes next, of a domain that may have another shape.
    pub fn invalidate_ground(&mut self, next: &Domain) {
        self.view = self.view.of(next);
        self.ground = GroundCache::default();
    }

    /// Shows another part of the domain; all of it, if no part is named.
    pub fn frame(&mut self, domain: &Domain, framing: Option<Framing>) {
        let view = self.view.framed(domain, framing);
        if view != self.view {
            self.view = view;
            self.ground = GroundCache::default();
            self.forget_drawing();
            self.reset();
        }
    }

    /// Forgets the picture: another tree, trim, width or style comes next.
    pub fn reset(&mut self) {
        self.ground.forget_rivers();
        self.is_blank = true;
        self.is_finished = false;
        self.round = None;
    }

    /// Forgets what of a tree or of rivers has been drawn.
    fn forget_drawing(&mut self) {
        self.coverage.clear();
        self.drawn.clear();
        self.flow = Flow::default();
        self.drawn_rivers = None;
    }

    /// How the domain lies on the picture.
    pub fn view(&self) -> &View {
        &self.view
    }

    /// How much of the ground for a style is painted, from 0 to 1.
    #[cfg(feature = "files")]
    pub fn progress(&self, style: Style) -> f32 {
        self.ground.progress(&self.view, palette(style).relief.is_some())
    }

    /// Takes the sea, or the paper, out of the picture, which is painted anew when next it is.
    #[cfg(feature = "files")]
    pub fn cut_out(&mut self, style: Style) {
        cut_out::cut_out(&mut self.pixmap, self.ground.flat_pixels(), self.chart.as_deref(), style);
        self.reset();
    }

    /// Whether the picture shows a relief.
    pub fn is_raised(&self) -> bool {
        self.ground.is_raised()
    }

    /// Brings the picture up to date. Returns the rectangle that changed; `None` if nothing did.
    pub fn paint(&mut self, progress: &Progress<'_>) -> Option<Rect> {
        if self.is_finished {
            return None;
        }
        let is_blank = std::mem::take(&mut self.is_blank);
        if is_blank {
            self.forget_drawing();
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
        if is_blank || (progress.finished && palette(progress.style).lines == Lines::Skeleton) {
            self.coverage.touch_all();
        }
        self.ground.forget_relief();
        self.ground.lay(&self.view, progress.land, progress.style);
        self.compose(progress.style)
    }

    /// Does a part of painting rivers, in place of the tree that they were. The picture changes with the last part.
    pub fn paint_rivers(&mut self, rivers: &Rivers<'_>) -> Painted {
        let has_chart = chart::is_same(self.chart.as_ref(), rivers.chart);
        if self.round == Some(rivers.rounds) && self.ground.shows(rivers.relief) && has_chart {
            return Painted::Whole(None);
        }
        if self.ground.advance(&self.view, rivers) {
            return Painted::Part;
        }
        self.round = Some(rivers.rounds);
        self.is_finished = true;
        self.chart = rivers.chart.cloned();
        self.draw_rivers(rivers);
        if let Some(chart) = rivers.chart {
            chart::take_away(&mut self.coverage, chart);
            self.drawn_rivers = None;
        }
        self.coverage.touch_all();
        let changed = self.compose(rivers.style);
        if let Some(chart) = rivers.chart {
            chart::lay(&mut self.pixmap, chart, rivers.style);
        }
        Painted::Whole(changed)
    }

    /// Paints rivers in one go, so many times as wide as they are, without a chart, on the ground that is there, be its relief that of other
    /// rivers: for a moment, until `paint_rivers` paints them as they are. Returns the rectangle that changed; `None`, and nothing has, if
    /// there is no such ground.
    #[cfg(feature = "controls")]
    pub fn paint_draft(&mut self, network: &Network, courses: CourseShape, style: Style, times: f32) -> Option<Rect> {
        if !self.ground.is_ready_for_draft(&self.view, style) {
            return None;
        }
        (self.round, self.drawn_rivers, self.chart) = (None, None, None);
        self.is_finished = true;
        self.coverage.clear();
        let widening = Widening { times, ..Widening::NONE };
        draw_network(&mut self.coverage, &self.view, network, courses, palette(style).lines, widening);
        self.coverage.touch_all();
        self.compose(style)
    }

    /// Draws rivers, unless it is they that the mask shows: a style may have changed alone.
    fn draw_rivers(&mut self, rivers: &Rivers<'_>) {
        let (lines, relief) = (palette(rivers.style).lines, rivers.relief.map(|(relief, _)| relief));
        let is_drawn = |(of, as_lines): &(Arc<Relief>, Lines)| {
            relief.is_some_and(|relief| Arc::ptr_eq(of, relief)) && *as_lines == lines
        };
        if !self.drawn_rivers.as_ref().is_some_and(is_drawn) {
            self.coverage.clear();
            draw_network(&mut self.coverage, &self.view, rivers.network, rivers.courses, lines, Widening::NONE);
            self.drawn_rivers = relief.map(|relief| (relief.clone(), lines));
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
        let ground = self.ground.pixels(style);
        match palette(style).lines {
            Lines::Wide | Lines::Thin => {
                ink::compose(&mut self.pixmap, &self.coverage, ground, palette(style), &touched);
            }
            Lines::Skeleton if self.is_finished => {
                skeleton::compose_thinned(&mut self.pixmap, &self.coverage, ground.map(|ground| ground.0));
                return Some(self.coverage.bounds());
            }
            Lines::Skeleton => {
                let ground = ground.map(|ground| ground.0);
                touched.iter().for_each(|&rect| skeleton::compose(&mut self.pixmap, &self.coverage, ground, rect));
            }
        }
        Some(around)
    }
}

fn widths(progress: &Progress<'_>) -> Widths {
    let lines = palette(progress.style).lines;
    match lines {
        Lines::Wide | Lines::Thin => {
            Widths::ByDischarge { full: progress.max_width * lines.share(), total_discharge: progress.total_discharge }
        }
        Lines::Skeleton => Widths::Even { width_px: skeleton::WIDTH_PX },
    }
}
