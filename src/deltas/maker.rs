//! The deltas of a map in the making: no step keeps a page waiting for long.

use std::sync::Arc;

use glam::Vec2;

use super::ends::extended;
use super::fan::{Fan, Link, Site, count_tips};
use super::pieces::Pieces;
use super::plain::{Most, Plain, radii};
use super::sediment::{LEAST, Load, RIVERS, Sediment, expected_area};
use super::{Delta, Deltas, Distributary, tips};
use crate::base::geometry::{direction, distance, fast_max, fast_min};
use crate::base::memory::{Refused, ask, lengthen};
use crate::base::rings;
use crate::base::sort::argsort;
use crate::base::work;
use crate::domain::Domain;
use crate::land::{CoastDistance, Land, SmoothedDistance};
use crate::network::{Network, Place};

/// The settings of deltas.
#[derive(Clone, Debug)]
pub(crate) struct DeltaSettings {
    pub sediment: Sediment,
    /// The strength of waves, from 0 to 1.
    pub waves: f32,
    /// The discharge of a river that would drain the whole map.
    pub total_discharge: u32,
    /// The mouths of great rivers with what they have left after filling their rias; `None` if no sea has risen.
    pub loads: Option<Vec<Load>>,
    /// The corners of the plains in rias, each with its distance from their edge, in units.
    pub plains: Vec<(u32, f32)>,
}

/// A land with deltas.
#[derive(Clone, Debug)]
pub(crate) struct Shore {
    pub deltas: Arc<Deltas>,
    pub land: Arc<Land>,
    /// The distance into flat ground that rivers have laid, in units, negative elsewhere; `None` if there is none.
    pub flats: Option<Arc<CoastDistance>>,
    /// The rivers, if some of them run on over new land; `None` if they are as before.
    pub network: Option<Arc<Network>>,
}

/// The deltas of a map, as far as they are made.
#[derive(Debug)]
pub(crate) struct DeltaMaker {
    settings: DeltaSettings,
    land: Arc<Land>,
    /// The distances from the coast, as deltas have changed it so far, and those into flat ground.
    heights: Vec<f32>,
    flats: Vec<f32>,
    /// The waters and lands of the map with the deltas that it has so far.
    pieces: Pieces,
    /// The rivers that are left, the greatest last, with their sediment.
    rivers: Vec<(u32, f32)>,
    /// The delta that is built next.
    plan: Option<Plan>,
    /// The area that new land may still have, in square units.
    area: f32,
    made: Deltas,
    /// The ways on which rivers run on to the sea from mouths that lie in new land now.
    ends: Vec<(u32, Vec<Vec2>)>,
    has_begun: bool,
}

/// A delta that is to be built.
#[derive(Clone, Debug)]
struct Plan {
    river: u32,
    apex: Vec2,
    /// The places that its branches keep clear of, each with a distance in units.
    kept: Vec<(Vec2, f32)>,
    most: Most,
    links: Vec<Link>,
    /// The land along the branches.
    bare: Plain,
    /// The radii of bays that are yet to be tried, in units, the greatest last.
    radii: Vec<f32>,
}

/// The greatest share of the map that deltas take from the sea, besides the area that was left for them.
const MOST: f32 = 0.008;

/// The least number of branches that reach the sea: fewer look like a broken finger.
const TIPS: usize = 3;

impl DeltaMaker {
    /// The approximate memory of the work, in megabytes.
    pub const MEGABYTES: u32 = 8;

    /// Begins the deltas of a land.
    pub fn new(settings: DeltaSettings, land: Arc<Land>) -> Self {
        let size = land.size();
        let area = MOST * size.x * size.y + settings.loads.as_deref().map_or(0.0, expected_area);
        Self {
            settings,
            land,
            heights: Vec::new(),
            flats: Vec::new(),
            pieces: Pieces::default(),
            rivers: Vec::new(),
            plan: None,
            area,
            made: Deltas::default(),
            ends: Vec::new(),
            has_begun: false,
        }
    }

    /// Plans a delta, or tries to build the one that is planned. Returns the land once all are made.
    ///
    /// # Errors
    /// If there is not enough memory. A further call tries the same step again.
    pub fn step(&mut self, network: &Network) -> Result<Option<Shore>, Refused> {
        if !std::mem::replace(&mut self.has_begun, true) {
            self.begin(network).inspect_err(|_| self.has_begun = false)?;
            return Ok(None);
        }
        if let Some(plan) = self.plan.take() {
            self.plan = self.build(network, plan);
            return Ok(None);
        }
        let Some((river, volume)) = self.rivers.pop() else { return self.shore(network).map(Some) };
        if volume >= LEAST {
            self.plan = self.plan(network, river, volume);
        }
        Ok(None)
    }

    fn begin(&mut self, network: &Network) -> Result<(), Refused> {
        ask(Self::MEGABYTES as usize * 1_000_000)?;
        let heights = self.land.coast_distance().heights();
        self.heights = heights.to_vec();
        self.flats.clear();
        lengthen(&mut self.flats, heights.len(), -FLAT)?;
        work::count(2 * heights.len());
        for &(corner, within) in &self.settings.plains {
            self.flats[corner as usize] = fast_max(self.flats[corner as usize], within);
        }
        self.pieces = Pieces::of(heights, self.land.coast_distance().size().0);
        self.rivers = self.great_rivers(network);
        Ok(())
    }

    /// Lists the rivers that may have a delta with their sediment, the greatest last.
    fn great_rivers(&self, network: &Network) -> Vec<(u32, f32)> {
        let mouths = network.mouths();
        let discharge = |river: u32| network.discharge(&network.rivers[river as usize]);
        let order = argsort(mouths.iter().map(|&river| !discharge(river)));
        let great = order.into_iter().take(RIVERS).map(|i| mouths[i]);
        let mut loads = self.settings.loads.clone();
        let mut rivers: Vec<(u32, f32)> =
            great.map(|river| (river, self.sediment_of(network, river, loads.as_mut()))).collect();
        rivers.reverse();
        rivers
    }

    /// Returns the sediment that a river has left at its mouth, in cubic units. Takes it from the loads, if there are any.
    fn sediment_of(&self, network: &Network, river: u32, loads: Option<&mut Vec<Load>>) -> f32 {
        /// The farthest that a mouth lies from where its plain was to end, in units.
        const FAR: f32 = 40.0;
        let river = &network.rivers[river as usize];
        let Some(mouth) = network.vertices[river.vertex_range()].last() else { return 0.0 };
        let Some(loads) = loads else {
            let share = mouth.discharge as f32 / self.settings.total_discharge.max(1) as f32;
            return self.settings.sediment.of_river(share, river.identity);
        };
        let away = |load: &Load| distance(load.at, mouth.at);
        let near = (0..loads.len()).filter(|&i| away(&loads[i]) < FAR);
        let nearest = near.min_by(|&a, &b| away(&loads[a]).total_cmp(&away(&loads[b])));
        nearest.map_or(0.0, |i| loads.remove(i).left)
    }

    /// Grows the branches of a river's delta; `None` if there is no room for one.
    fn plan(&self, network: &Network, river: u32, volume: f32) -> Option<Plan> {
        let course = network.middle(&network.rivers[river as usize]);
        let [.., above, mouth, _] = course[..] else { return None };
        let coast = self.land.coast_distance();
        let kept = self.surroundings(network, river, mouth);
        let site = Site {
            domain: Domain { size: self.land.size() },
            coast,
            apex: mouth.at,
            heading: direction(mouth.at - above.at),
            width: 2.0 * mouth.half,
            kept: &kept,
            identity: network.rivers[river as usize].identity,
            chance: self.settings.sediment.chance(),
        };
        let Fan { links, left, reach, .. } = Fan::grow(site, volume);
        if count_tips(&links) < TIPS {
            return None;
        }
        let most = Most { volume: volume + left, area: self.area };
        let mut radii = radii(self.settings.waves, reach).to_vec();
        radii.reverse();
        let bare = Plain::along(coast, &self.heights, &links);
        Some(Plan { river, apex: mouth.at, kept, most, links, bare, radii })
    }

    /// Builds a planned delta with bays of the greatest radius that is left. Returns the plan if that failed and another is left.
    fn build(&mut self, network: &Network, mut plan: Plan) -> Option<Plan> {
        let radius = plan.radii.pop()?;
        let settled = self.settled(&plan, radius).filter(|(plain, _)| !self.covers_a_tip(plain));
        let Some((plain, links)) = settled else { return Some(plan) };
        let Some(pieces) = self.pieces_with(&plain) else { return Some(plan) };
        let Some(ends) = self.lead_on(network, plan.river, &plain, &links) else { return Some(plan) };
        self.ends.extend(ends);
        self.pieces = pieces;
        self.take(plan.river, plan.apex, &plain, &links);
        None
    }

    /// Closes the bays of a planned delta up to a radius and brings its branches to the sea, without those that cannot reach it. `None`
    /// if too few do, or if the plain is too large.
    fn settled(&self, plan: &Plan, radius: f32) -> Option<(Plain, Vec<Link>)> {
        // A smaller plain is better than one that hardly a branch crosses.
        let least = if radius > 0.0 { TIPS.max(count_tips(&plan.links).div_ceil(2)) } else { TIPS };
        let (mut plain, mut links) = (plan.bare.clone(), plan.links.clone());
        loop {
            if !plain.close(radius, plan.most) {
                return None;
            }
            links = match tips::carry(&links, &plain, &plan.kept) {
                Ok(links) => return Some((plain, links)),
                Err(fewer) => fewer,
            };
            if count_tips(&links) < least {
                return None;
            }
            plain = Plain::along(self.land.coast_distance(), &self.heights, &links);
        }
    }

    /// Lists the places that the branches of a river keep clear of: those of all other rivers nearby and of its own above.
    fn surroundings(&self, network: &Network, river: u32, apex: Place) -> Vec<(Vec2, f32)> {
        /// The farthest that a delta reaches, in widths and in units.
        const WIDTHS: f32 = 16.0;
        const FAR: f32 = 120.0;
        let far = WIDTHS * 2.0 * apex.half + FAR;
        let own = 2.5 * 2.0 * apex.half + 6.0;
        let mut kept = Vec::new();
        for (id, other) in (0..).zip(&network.rivers) {
            work::count(other.vertex_range().len());
            for vertex in &network.vertices[other.vertex_range()] {
                let away = distance(vertex.at, apex.at);
                if away < far && (id != river || away > own) {
                    kept.push((vertex.at, 0.5 * vertex.width() + 1.5));
                }
            }
        }
        let branches = self.made.distributaries.iter().flat_map(|branch| &branch.line);
        kept.extend(branches.map(|place| (place.at, place.half + 3.0)));
        kept.extend(self.ends.iter().flat_map(|(_, way)| way).map(|&at| (at, 3.0)));
        kept
    }

    /// Leads the rivers whose mouths lie in a new plain on to the sea. `None` if a way is barred.
    fn lead_on(&self, network: &Network, river: u32, plain: &Plain, links: &[Link]) -> Option<Vec<(u32, Vec<Vec2>)>> {
        let mut passable = plain.passable(links);
        let mut ends = Vec::new();
        for id in network.mouths().into_iter().filter(|id| *id != river) {
            let known = self.ends.iter().rev().find(|(other, _)| *other == id).and_then(|(_, way)| way.last().copied());
            let last = network.vertices[network.rivers[id as usize].vertex_range()].last().map(|vertex| vertex.at);
            let Some(mouth) = known.or(last) else { continue };
            if plain.cuts_off(mouth) {
                ends.push((id, plain.way_out(mouth, &mut passable)?));
            }
        }
        Some(ends)
    }

    /// Returns `true` if a plain has taken the sea from a branch of an earlier delta.
    fn covers_a_tip(&self, plain: &Plain) -> bool {
        let mut tips = self.made.distributaries.iter().filter(|branch| branch.reaches_sea);
        tips.any(|branch| branch.line.last().is_some_and(|tip| plain.has_changed(tip.at)))
    }

    /// Finds the waters and lands of the map with a plain; `None` if it cuts water off or joins two islands.
    fn pieces_with(&self, plain: &Plain) -> Option<Pieces> {
        let columns = self.land.coast_distance().size().0;
        let mut heights = self.heights.clone();
        plain.changes(columns).for_each(|(corner, height)| heights[corner] = height);
        self.pieces.after(&heights, columns)
    }

    /// Takes over a delta.
    fn take(&mut self, river: u32, apex: Vec2, plain: &Plain, links: &[Link]) {
        let coast = self.land.coast_distance();
        let mut new = vec![-coast.spacing(); self.heights.len()];
        work::count(new.len());
        for (corner, height) in plain.changes(coast.size().0) {
            let before = coast.heights()[corner];
            new[corner] = fast_min(height, -before);
            self.heights[corner] = height;
            self.flats[corner] = fast_max(self.flats[corner], fast_min(height, FLAT));
        }
        let mut rings = SmoothedDistance::of(&coast.with_heights_of(&new)).rings_above(0.0);
        rings.retain(|ring| rings::area(ring).abs() > SPECK);
        let area = plain.area();
        self.area -= area;
        self.made.list.push(Delta { river, apex, waves: self.settings.waves, area, rings });
        let first = self.made.distributaries.len();
        for (i, link) in links.iter().enumerate() {
            self.made.distributaries.push(Distributary {
                id: (first + i) as u32,
                river,
                parent: link.parent.map(|parent| (first + parent) as u32),
                share: link.share,
                line: link.line.iter().map(|&at| Place { at, half: 0.5 * link.width }).collect(),
                reaches_sea: link.arms.is_none(),
            });
        }
    }

    /// Makes the land with all deltas.
    fn shore(&mut self, network: &Network) -> Result<Shore, Refused> {
        ask(Self::MEGABYTES as usize * 1_000_000)?;
        let land = match self.made.is_empty() {
            true => self.land.clone(),
            false => self.land.with_plains(&self.heights).into(),
        };
        let is_flat = self.flats.iter().any(|flat| *flat > 0.0);
        let flats = is_flat.then(|| self.land.coast_distance().with_heights_of(&self.flats).into());
        let network = (!self.ends.is_empty()).then(|| extended(network, &self.ends).into());
        Ok(Shore { deltas: std::mem::take(&mut self.made).into(), land, flats, network })
    }
}

/// The area of a ring that is too small to tell, in square units.
const SPECK: f32 = 24.0;

/// The distance into flat ground that is told, and the other way, in units.
const FLAT: f32 = 8.0;
