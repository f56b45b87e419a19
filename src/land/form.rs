//! Forms: the height of the land of a shape, from spines, the distance from sides, noise and the frame.

use glam::Vec2;

use super::archipelago::archipelago;
use super::breakthrough;
use super::coast_distance::CoastDistance;
use super::drafts::{self, Wanted};
use super::draws::Draws;
use super::figures::{arms, crescent, long, twins};
use super::gulf::outlet;
use super::island::{island, lake};
use super::kinds::Shape;
use super::ragged::Ragged;
use super::rock::{Amplitudes, Relief, Rock};
use super::room::centred;
use super::sides::Coasts;
use super::spine::{Spine, Spines};
use crate::recipe::LandKind;

impl Shape {
    /// Makes the coast distances of the shape, on a lattice with a spacing. `None` for the plain rectangle and for a
    /// drawn land, which has them from its outline.
    pub fn coast_distance(&self, spacing: f32) -> Option<CoastDistance> {
        let form = Form::of(self)?;
        Some(form.finished(form.with_sea(spacing, self.sea)))
    }
}

/// The ingredients of a shape's height.
pub(super) struct Form<'a> {
    shape: &'a Shape,
    spines: Spines,
    /// The strait between twin islands, or from a gulf to the ocean.
    strait: Option<Spine>,
    coasts: Option<Coasts>,
    rock: Rock,
    amplitudes: Amplitudes,
}

impl<'a> Form<'a> {
    /// Makes the form of a shape; `None` for the plain rectangle and for a drawn land. Where layouts are drafted,
    /// neither the share of the sea nor roughness nor a given place decides which draft is taken: they change a coast a
    /// little, or move it, but do not replace it.
    pub fn of(shape: &'a Shape) -> Option<Self> {
        if matches!(shape.kind, LandKind::Rectangle | LandKind::Drawn) {
            return None;
        }
        let usual = Shape { sea: shape.kind.usual_sea(), roughness: 1.0, center: Vec2::ZERO, ..shape.clone() };
        let draft = wanted(shape.kind).map_or(0, |wanted| Form::with_draft(&usual, 0).best_draft(&wanted));
        Some(Self::with_draft(shape, draft))
    }

    /// Makes the land where the sea covers a share of the domain, not [settled](CoastDistance::settled) yet.
    pub fn with_sea(&self, spacing: f32, sea: f32) -> CoastDistance {
        CoastDistance::with_sea(&self.shape.domain, spacing, sea, &|point| self.height(point))
    }

    /// Gives each inner water of a land of this form its outlet, [settles](CoastDistance::settled) the land, and makes coasts
    /// ragged where they are straight.
    pub fn finished(&self, land: CoastDistance) -> CoastDistance {
        Ragged::of(self.shape).applied(self.opened(land).settled())
    }

    /// Joins the inner waters of a land of this form to the open sea, but for a basin, whose waters are closed. The result
    /// has yet to be [settled](CoastDistance::settled).
    fn opened(&self, land: CoastDistance) -> CoastDistance {
        /// The waves of ways and banks across the shorter side of the domain.
        const BUMPS: f32 = 24.0;
        if self.shape.kind == LandKind::Basin {
            return land;
        }
        let noise = self.shape.noise(9, BUMPS, 2);
        breakthrough::open(land, self.shape.domain.size, &|at| noise.get_noise_2d(at.x, at.y))
    }

    fn with_draft(shape: &'a Shape, draft: u32) -> Self {
        let coasts = matches!(shape.kind, LandKind::Continent | LandKind::Valley).then(|| Coasts::new(shape));
        let (rock, amplitudes) = (Rock::new(shape), amplitudes(shape.kind));
        let (spines, strait) = layout(shape, draft);
        Self { shape, spines, strait, coasts, rock, amplitudes }
    }

    fn best_draft(&self, wanted: &Wanted) -> u32 {
        let Shape { domain, sea, kind, .. } = self.shape;
        let (sign, sea) = if kind.holds_water() { (-1.0, 1.0 - sea) } else { (1.0, *sea) };
        let points = drafts::points(domain);
        // All drafts lie on the same rock, and points are too far apart for its detail.
        let broad = Amplitudes { fine: 0.0, ..self.amplitudes };
        let reliefs: Vec<Relief> = points.iter().map(|&at| self.rock.at(at, &broad)).collect();
        drafts::best(domain, sea, wanted, |draft| {
            let (spines, _) = layout(self.shape, draft);
            points.iter().zip(&reliefs).map(|(&at, relief)| sign * self.with(&spines, at, relief)).collect()
        })
    }

    /// Returns the height of a point, in units.
    pub fn height(&self, point: Vec2) -> f32 {
        /// The steepness of a strait's banks: so much that a change of the sea's level hardly narrows it.
        const STEEP: f32 = 6.0;
        /// The share of noise that moves its banks: not so much that they meet.
        const SWAY: f32 = 0.3;
        let relief = self.rock.at(point, &self.amplitudes);
        let height = self.with(&self.spines, point, &relief);
        let bed = |strait: &Spine| SWAY * relief.rise - STEEP * strait.height(relief.at);
        self.strait.as_ref().map_or(height, |strait| height.min(bed(strait)))
    }

    /// Returns the height of a point, in units, by some spines and the relief at the point.
    fn with(&self, spines: &Spines, point: Vec2, relief: &Relief) -> f32 {
        /// The steepness of the sea bed of an archipelago, or of a figure, over that of its land. With less, noise would
        /// join islands and fill bays.
        const STEEP: f32 = 2.5;
        let moat = || self.moat(point, relief.rise / self.shape.span(), relief.stray);
        let spines = || spines.height(relief.at);
        match self.shape.kind {
            LandKind::Rectangle | LandKind::Drawn => self.shape.span(),
            LandKind::Island => spines() + relief.rise - moat(),
            LandKind::Archipelago | LandKind::Crescent | LandKind::Twins | LandKind::Long | LandKind::Arms => {
                let height = spines();
                height.max(0.0) + STEEP * height.min(0.0) + relief.rise - moat()
            }
            LandKind::Basin | LandKind::Gulf => moat() - spines() - relief.rise,
            LandKind::Continent | LandKind::Valley => {
                self.coasts.as_ref().map_or(0.0, |coasts| coasts.height(relief.at)) + relief.rise
            }
        }
    }

    /// Lowers the height towards the border of the domain, so that the border cuts neither land surrounded by sea nor a
    /// lake surrounded by land. The drop begins at a margin, which varies by itself and with the coast (`bend`), so
    /// that it straightens no coast, and ends in a wall. The more land there is, the nearer both lie to the border.
    fn moat(&self, point: Vec2, bend: f32, stray: f32) -> f32 {
        let Shape { kind, domain, sea, .. } = self.shape;
        let within = if kind.holds_water() { *sea } else { 1.0 - sea }.max(0.4);
        let room = 0.5 * (1.0 - within.sqrt());
        // Land that fills the map keeps its coast from the frame by a moat that is wide in places.
        let full = ((within - 0.4) / 0.4).clamp(0.0, 1.0);
        let width = (0.6 + 0.3 * full) * room;
        let margin = room * (0.25 + 0.15 * full + (0.7 + 0.3 * full) * stray - (0.8 + 2.2 * full) * bend).max(0.0);
        let inside = point.min(domain.size - point) / self.shape.span();
        let near = (1.0 - (inside - margin) / width).max(Vec2::ZERO).length_squared();
        let wall = 0.06 * room / (inside.min_element().max(0.0) + 0.015 * room);
        (near * near * 2.0 * room + wall) * self.shape.span()
    }
}

/// Lays out the spines of a draft, and the strait of twin islands or of a gulf.
fn layout(shape: &Shape, draft: u32) -> (Spines, Option<Spine>) {
    let draws = &mut Draws::new(shape, draft);
    let (size, usual) = (shape.domain.size, shape.kind.usual_sea());
    let share = if shape.kind.holds_water() { usual } else { 1.0 - usual };
    let area = share * size.x * size.y;
    let mut strait = None;
    let spines = match shape.kind {
        LandKind::Island => island(draws, size, area),
        LandKind::Archipelago => archipelago(draws, size, area),
        LandKind::Crescent => crescent(draws, size, area),
        LandKind::Twins => {
            let (islands, between) = twins(draws, size, area);
            strait = Some(between);
            islands
        }
        LandKind::Long => long(draws, size, area),
        LandKind::Arms => arms(draws, size, area),
        LandKind::Basin => centred(lake(draws, size, area), size, shape.center),
        LandKind::Gulf => {
            // Its outlet has a share of the water, too.
            let sea = centred(lake(draws, size, 0.9 * area), size, shape.center);
            strait = Some(outlet(draws, size, &sea));
            sea
        }
        LandKind::Continent | LandKind::Valley | LandKind::Rectangle | LandKind::Drawn => Vec::new(),
    };
    // Straits between the islands of an archipelago are narrow.
    let round = if shape.kind == LandKind::Archipelago { 0.012 } else { 0.05 };
    (Spines::new(&spines, size, round * shape.span()), strait)
}

/// Returns the ranges of measures of a kind of land, those of real islands, from Madagascar to Skye; `None` if it is not drafted.
fn wanted(kind: LandKind) -> Option<Wanted> {
    match kind {
        LandKind::Island => Some(Wanted {
            boxed: [0.32, 0.64],
            coast: [1.4, 2.3],
            share: [0.72, 0.99],
            count: [2, 20],
            counted: 2,
            straight: 0.33,
        }),
        LandKind::Twins => Some(Wanted {
            boxed: [0.3, 0.75],
            coast: [1.3, 2.6],
            share: [0.48, 0.7],
            count: [2, 12],
            counted: 2,
            straight: 0.5,
        }),
        LandKind::Archipelago => Some(Wanted {
            boxed: [0.2, 0.75],
            coast: [1.0, 3.6],
            share: [0.1, 0.62],
            count: [6, 40],
            counted: 2,
            straight: 0.9,
        }),
        LandKind::Basin | LandKind::Gulf => Some(Wanted {
            boxed: [0.25, 0.62],
            coast: [1.6, 3.2],
            share: [0.8, 1.0],
            count: [1, 1],
            counted: 25,
            straight: 0.33,
        }),
        _ => None,
    }
}

/// Returns the amplitudes with which noise moves the coasts of a kind of land.
fn amplitudes(kind: LandKind) -> Amplitudes {
    match kind {
        LandKind::Archipelago => Amplitudes { warp: 90.0, broad: 30.0, spurs: 36.0, fine: 28.0 },
        LandKind::Continent => Amplitudes { warp: 130.0, broad: 200.0, spurs: 70.0, fine: 30.0 },
        LandKind::Valley => Amplitudes { warp: 100.0, broad: 110.0, spurs: 50.0, fine: 30.0 },
        kind if kind.is_figure() => Amplitudes { warp: 90.0, broad: 45.0, spurs: 54.0, fine: 38.0 },
        LandKind::Basin | LandKind::Gulf => Amplitudes { warp: 120.0, broad: 140.0, spurs: 60.0, fine: 30.0 },
        _ => Amplitudes { warp: 120.0, broad: 125.0, spurs: 70.0, fine: 30.0 },
    }
}
