//! The painter keeps a picture up to date with a growing tree and draws only what is new.
//!
//! While a tree grows, it is not yet known which nodes trimming will remove. A node at least as deep as the trimming
//! threshold will certainly stay, because its depth can only grow; those nodes are drawn at once, and the growing tips
//! a little later. When growth is over, everything that stays is drawn. The finished picture equals the one painted at
//! once, to the byte.

use std::sync::Arc;

use tiny_skia::Pixmap;

use super::annotation::masks::{self, AnnotationMasks};
use super::coverage::{Coverage, Rect};
use super::cut_out;
use super::flow::Flow;
use super::ground::{COAST_WIDTH, river_share, thinned};
use super::ground_cache::GroundCache;
use super::mouths::{self, Drawn, SeaShares, TonguePainter};
use super::palette::Lines;
use super::paper::WaterColour;
use super::rivers::{Inland, Rivers, VISIBLE_PX, Widening, draw_network, is_same_lakes};
use super::settings::PaintSettings;
use super::strokes::{Pen, Widths};
use super::styles::{Scheme, palette};
use super::view::{Framing, PaintError, View};
use super::waters::{Opening, Waters};
use super::{ink, skeleton};
use crate::base::memory;
use crate::domain::Domain;
use crate::lakes::Lakes;
use crate::land::Land;
use crate::network::PastCourses;
use crate::prune::{self, Trim};
use crate::relief::Relief;
use crate::tree::Tree;

/// A tree to paint, as far as it has grown.
#[derive(Clone, Copy, Debug)]
pub struct Progress<'a> {
    /// The untrimmed tree. Between two calls it may only have grown.
    pub tree: &'a Tree,
    /// `true` once it will not grow any more.
    pub finished: bool,
    /// The trimming that will be applied.
    pub trim: Trim,
    /// The discharge of a river that would drain the whole map.
    pub total_discharge: u32,
    /// The land; `None` if the whole domain is land.
    pub land: Option<&'a Land>,
    /// The settings.
    pub settings: PaintSettings,
}

/// The result of a part of painting.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Painted {
    /// There is more to do, and nothing to see yet.
    Part,
    /// The picture is up to date. Holds the rectangle that changed, or `None` if nothing did.
    Whole(Option<Rect>),
}

impl Painted {
    /// Returns the rectangle that changed; `None` if nothing did.
    pub fn changed(self) -> Option<Rect> {
        match self {
            Self::Part => None,
            Self::Whole(changed) => changed,
        }
    }
}

/// A picture that is being painted.
#[derive(Clone, Debug)]
pub struct Painter {
    view: View,
    pixmap: Pixmap,
    waters: Waters,
    /// The radius with which each node was last drawn; 0 if it was not.
    drawn: Vec<u16>,
    flow: Flow,
    /// The picture without rivers.
    ground: GroundCache,
    /// `true` if nothing of the picture can be kept.
    is_blank: bool,
    /// `true` if the land is new, and its ground not in the picture yet.
    is_on_new_ground: bool,
    /// `true` if the picture shows a finished tree.
    is_finished: bool,
    /// The round of meandering that the picture shows; `None` while it shows a tree.
    round: Option<u32>,
    /// The relief that belongs to the finished rivers in the masks, the kind of their lines, and how they open; `None` if
    /// the masks hold anything else.
    drawn_rivers: Option<DrawnRivers>,
    /// The sea in the mouths of the rivers that the picture shows.
    tongues: SeaShares,
    /// The lakes that the picture shows.
    lakes: Option<Arc<Lakes>>,
    /// The annotation that the picture shows.
    annotation: Option<Arc<AnnotationMasks>>,
}

/// The finished rivers in the masks: the relief that they belong to, and what they are drawn with.
#[derive(Clone, Debug)]
struct DrawnRivers {
    relief: Arc<Relief>,
    lakes: Option<Arc<Lakes>>,
    lines: Lines,
    opening: Option<Opening>,
}

impl Painter {
    /// Makes an empty picture.
    ///
    /// # Errors
    /// Fails if a side is 0 or too long, or if there is not enough memory.
    pub fn new(domain: &Domain, width: u32, height: u32) -> Result<Self, PaintError> {
        /// The memory of picture, both masks and ground. The copy of the mask that a skeleton thins needs less than a relief.
        const BYTES_A_PIXEL: usize = 4 + 2 + GroundCache::BYTES_A_PIXEL;
        let view = View::new(domain, width, height)?;
        let bytes = BYTES_A_PIXEL * view.pixels() + GroundCache::BYTES;
        if !memory::can_allocate(bytes) {
            return Err(PaintError::OutOfMemory { width, height, megabytes: (bytes / 1_000_000) as u32 + 1 });
        }
        let none = PaintError::Size { width, height };
        let pixmap = Pixmap::new(width, height).ok_or(none.clone())?;
        let waters = Waters::of(Coverage::new(width, height).ok_or(none)?);
        let (drawn, flow) = (Vec::new(), Flow::default());
        Ok(Self {
            view,
            pixmap,
            waters,
            drawn,
            flow,
            ground: GroundCache::default(),
            is_blank: true,
            is_on_new_ground: true,
            is_finished: false,
            round: None,
            drawn_rivers: None,
            tongues: SeaShares::new(),
            lakes: None,
            annotation: None,
        })
    }

    /// Returns the pixels: RGBA, opaque.
    pub fn pixmap(&self) -> &Pixmap {
        &self.pixmap
    }

    /// Drops the ground, because the land has changed. The next domain may have another shape.
    pub fn invalidate_ground(&mut self, next: &Domain) {
        self.view = self.view.of(next);
        self.ground = GroundCache::default();
        self.is_on_new_ground = true;
    }

    /// Shows a part of the domain, or all of it for `None`.
    pub fn frame(&mut self, domain: &Domain, framing: Option<Framing>) {
        let view = self.view.framed(domain, framing);
        if view != self.view {
            self.ground.forget_view(&self.view, &view);
            self.view = view;
            self.forget_drawing(None);
            self.reset();
        }
    }

    /// Starts the picture anew, because the tree, its trimming, the width or the style has changed.
    pub fn reset(&mut self) {
        self.ground.forget_rivers();
        self.is_blank = true;
        self.is_finished = false;
        self.round = None;
    }

    /// Drops all drawings of trees and rivers. The next ones open as those of a scheme do; `None` if that is not known yet.
    fn forget_drawing(&mut self, scheme: Option<Scheme>) {
        self.waters.clear(scheme.and_then(|scheme| self.opening(scheme)));
        self.drawn.clear();
        self.flow = Flow::default();
        self.drawn_rivers = None;
    }

    /// Returns the map from the domain to the pixels.
    pub fn view(&self) -> &View {
        &self.view
    }

    /// Returns the painted share of the ground for a style, from 0 to 1.
    pub fn progress(&self, scheme: Scheme) -> f32 {
        self.ground.progress(&self.view, palette(scheme).relief.is_some())
    }

    /// Makes the background transparent: the sea, or in line styles the paper. The next call of `paint` or
    /// `paint_rivers` paints everything anew.
    pub fn cut_out(&mut self, scheme: Scheme) {
        cut_out::cut_out(
            &mut self.pixmap,
            self.ground.flat_pixels(),
            self.waters.open(),
            &self.tongues,
            self.annotation.as_deref(),
            scheme,
        );
        self.reset();
    }

    /// Returns `true` if the picture shows a relief.
    pub fn is_raised(&self) -> bool {
        self.ground.is_raised()
    }

    /// Brings the picture up to date. Returns the rectangle that changed; `None` if nothing did.
    pub fn paint(&mut self, progress: &Progress<'_>) -> Option<Rect> {
        // The sea may rise over a tree that stays as it is.
        let is_on_new_ground = std::mem::take(&mut self.is_on_new_ground);
        if self.is_finished && !is_on_new_ground {
            return None;
        }
        let is_blank = std::mem::take(&mut self.is_blank);
        if is_blank {
            self.forget_drawing(Some(progress.settings.scheme));
        }
        self.tongues.clear();
        if !self.is_finished {
            self.draw_tree(progress);
        }
        self.is_finished = progress.finished;
        if is_blank
            || is_on_new_ground
            || (progress.finished && palette(progress.settings.scheme).lines == Lines::Skeleton)
        {
            self.waters.banks.touch_all();
        }
        while self.lay_ground(progress.land, progress.settings.scheme) {}
        self.compose(progress.settings.scheme)
    }

    /// Lays a part of the ground of a tree, which `paint` would lay at once. Returns `true` if there is more.
    pub fn lay_ground(&mut self, land: Option<&Land>, scheme: Scheme) -> bool {
        self.ground.forget_relief();
        self.ground.lay(&self.view, land, scheme)
    }

    /// Does a part of painting rivers, which replace the tree. The picture changes with the last part.
    pub fn paint_rivers(&mut self, rivers: &Rivers<'_>) -> Painted {
        let has_annotation = masks::is_same(self.annotation.as_ref(), rivers.annotation);
        let has_lakes = is_same_lakes(self.lakes.as_ref(), rivers.lakes);
        if self.round == Some(rivers.rounds) && self.ground.shows(rivers) && has_lakes && has_annotation {
            return Painted::Whole(None);
        }
        if self.ground.advance(&self.view, rivers) {
            return Painted::Part;
        }
        self.round = Some(rivers.rounds);
        self.is_finished = true;
        self.annotation = rivers.annotation.cloned();
        self.lakes = rivers.lakes.cloned();
        self.draw_rivers(rivers);
        if let Some(annotation) = rivers.annotation {
            self.waters.for_each(|mask| masks::take_away(mask, annotation));
            self.drawn_rivers = None;
        }
        self.waters.banks.touch_all();
        let PaintSettings { scheme, .. } = rivers.settings;
        let changed = self.compose(scheme);
        self.open_mouths(rivers.inland(), Some(rivers.past), &rivers.settings, 1.0);
        if let Some(annotation) = rivers.annotation {
            masks::lay(&mut self.pixmap, annotation, scheme);
        }
        Painted::Whole(changed)
    }

    /// Paints rivers at once as a preview: `times` as wide as they are, without an annotation, on the existing ground, even
    /// if its relief belongs to other rivers. `paint_rivers` replaces it. Returns the rectangle that changed; `None`,
    /// without any change, if there is no suitable ground.
    pub fn paint_draft(&mut self, inland: Inland<'_>, settings: &PaintSettings, times: f32) -> Option<Rect> {
        let PaintSettings { scheme, courses, .. } = *settings;
        if !self.ground.is_ready_for_draft(&self.view, scheme) {
            return None;
        }
        (self.round, self.drawn_rivers, self.annotation) = (None, None, None);
        self.is_finished = true;
        self.waters.clear(self.opening(scheme));
        let widening = Widening { times, ..Widening::NONE };
        draw_network(&mut self.waters, &self.view, inland, courses, palette(scheme).lines, widening);
        self.waters.banks.touch_all();
        let changed = self.compose(scheme);
        self.open_mouths(inland, None, settings, times);
        changed
    }

    /// Returns how the rivers of a style open; `None` if they do not.
    fn opening(&self, scheme: Scheme) -> Option<Opening> {
        Opening::of(&palette(scheme), self.view.scale)
    }

    /// Lays the sea into the mouths of rivers.
    fn open_mouths(&mut self, inland: Inland<'_>, past: Option<&PastCourses>, settings: &PaintSettings, times: f32) {
        /// The width of a line that can be seen.
        const HAIRLINE_PX: f32 = 0.8;
        self.tongues.clear();
        let Some(shown) = self.ground.shown() else { return };
        let palette = palette(settings.scheme);
        let drawn = Drawn {
            palette: &palette,
            opening: self.waters.opening(),
            scale: self.view.scale,
            past,
            times,
            margin: VISIBLE_PX / self.view.scale,
            hairline: HAIRLINE_PX / self.view.scale,
            coast_width: COAST_WIDTH * thinned(self.view.scale),
        };
        let tongues = drawn.tongues(inland.network, inland.distributaries, shown);
        let painter = TonguePainter {
            view: &self.view,
            courses: settings.courses,
            shown,
            rivers: &self.waters.banks,
            open: self.waters.open(),
        };
        tongues.iter().for_each(|tongue| painter.draw(tongue, &mut self.tongues));
        // What a river has opened already is not laid twice.
        let (open, ground) = (self.waters.open(), self.ground.pixels(settings.scheme));
        let shown = |i: usize| ground.map_or(255, |ground| river_share(ground.0[i][3]));
        let opened = |i: usize| open.map_or(0, |open| (u32::from(open[i]) * u32::from(shown(i)) + 127) / 255);
        mouths::lay(&mut self.pixmap, &self.tongues, &opened, &WaterColour::new(&self.view, &palette));
    }

    /// Draws rivers, unless the mask already holds them because only the style has changed.
    fn draw_rivers(&mut self, rivers: &Rivers<'_>) {
        let (lines, relief) = (palette(rivers.settings.scheme).lines, rivers.relief);
        let opening = self.opening(rivers.settings.scheme);
        let is_drawn = |drawn: &DrawnRivers| {
            relief.is_some_and(|relief| Arc::ptr_eq(&drawn.relief, relief))
                && is_same_lakes(drawn.lakes.as_ref(), rivers.lakes)
                && (drawn.lines, drawn.opening) == (lines, opening)
        };
        if !self.drawn_rivers.as_ref().is_some_and(is_drawn) {
            self.waters.clear(opening);
            let courses = rivers.settings.courses;
            draw_network(&mut self.waters, &self.view, rivers.inland(), courses, lines, Widening::NONE);
            let lakes = rivers.lakes.cloned();
            self.drawn_rivers = relief.cloned().map(|relief| DrawnRivers { relief, lakes, lines, opening });
        }
    }

    /// Draws what is new of a tree.
    fn draw_tree(&mut self, progress: &Progress<'_>) {
        let (tree, pen) = (progress.tree, Pen::new(self.view, widths(progress), progress.settings.courses));
        if progress.finished || self.flow.is_stale(tree) {
            self.flow.measure(tree, &pen, progress.trim);
            self.draw_changes(progress, &pen);
        } else if progress.trim.heads.channel_area == 0 {
            let near_tip = self.flow.follow(tree, &pen, progress.trim.nodes);
            let radii = &self.flow.radii;
            near_tip.iter().for_each(|&child| pen.draw_water(&mut self.waters, tree, radii, child as usize));
        }
    }

    /// Draws all strokes that are new or have grown wider since the last call. Strokes near the tips have been drawn in
    /// between; drawing them again, now at least as wide, leaves no trace of that.
    fn draw_changes(&mut self, progress: &Progress<'_>, pen: &Pen) {
        let Progress { tree, finished, trim, .. } = *progress;
        let Flow { depth, discharge, channels, .. } = &self.flow;
        let stays = if finished {
            prune::stays(tree, discharge, trim)
        } else {
            let is_certain = |(&depth, &is_channel)| depth >= trim.nodes && is_channel;
            depth.iter().zip(channels).map(is_certain).collect()
        };
        self.drawn.resize(tree.len(), 0);
        let radii = &self.flow.radii;
        for child in (0..tree.len()).filter(|&child| stays[child]) {
            let Some(node) = tree.parent_of(child) else { continue };
            let below = tree.parent_of(node).unwrap_or(node);
            let wider = |node: usize| radii[node] > self.drawn[node];
            if wider(child) || wider(node) || wider(below) {
                pen.draw_water(&mut self.waters, tree, radii, child);
            }
        }
        for (drawn, (&radius, &stays)) in self.drawn.iter_mut().zip(radii.iter().zip(&stays)) {
            if stays {
                *drawn = radius;
            }
        }
    }

    /// Colours the parts of the picture where the mask has changed. Returns the rectangle around them.
    fn compose(&mut self, scheme: Scheme) -> Option<Rect> {
        // What is open lies between banks, so it touches nothing more.
        let touched = self.waters.banks.take_touched();
        let around = touched.iter().copied().reduce(Rect::union)?;
        let ground = self.ground.pixels(scheme);
        let banks = &self.waters.banks;
        match palette(scheme).lines {
            Lines::Wide | Lines::Thin => {
                ink::compose(&mut self.pixmap, (&self.waters, &self.view), ground, &palette(scheme), &touched);
            }
            Lines::Skeleton if self.is_finished => {
                skeleton::compose_thinned(&mut self.pixmap, banks, ground.map(|ground| ground.0));
                return Some(banks.bounds());
            }
            Lines::Skeleton => {
                let ground = ground.map(|ground| ground.0);
                touched.iter().for_each(|&rect| skeleton::compose(&mut self.pixmap, banks, ground, rect));
            }
        }
        Some(around)
    }
}

fn widths(progress: &Progress<'_>) -> Widths {
    let lines = palette(progress.settings.scheme).lines;
    match lines {
        Lines::Wide | Lines::Thin => {
            let full = progress.settings.max_width * lines.share();
            Widths::ByDischarge { full, total_discharge: progress.total_discharge }
        }
        Lines::Skeleton => Widths::Even { width_px: skeleton::WIDTH_PX },
    }
}
