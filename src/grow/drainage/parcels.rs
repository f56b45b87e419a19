//! Parcels: pieces of land that each drain themselves, with their neighbours, and the outlets through which water
//! leaves the land.

use glam::Vec2;

use super::country::Country;
use super::directions::NONE;
use super::lattice::{Lattice, WAYS};
use super::outlets::{self, Outlet};
use crate::base::geometry::distance;
use crate::base::random::{DEVIATION, Purpose};
use crate::base::work;
use crate::grow::GrowthSettings;
use crate::grow::watered::Watered;
use crate::land::{Cell, CoastDistance};

/// All parcels, with the costs between them.
#[derive(Clone, Debug, Default)]
pub(super) struct Parcels {
    /// The position of each parcel, in domain units.
    pub at: Vec<Vec2>,
    /// The neighbours in the six directions of the lattice that water may come from or go to; [`NONE`] where it may
    /// not.
    pub neighbours: Vec<[u32; 6]>,
    /// The cost at which water arrives from the neighbour in each of the six directions: length times hardness of the
    /// ground, less where the land falls that way. Empty if no water has to find its way.
    costs: Vec<[f32; 6]>,
    /// The identity of each parcel's cell, which belongs to the plane and not to this land.
    pub identity: Vec<[u32; 2]>,
    /// The nearness of each parcel to a border of the domain beyond which land continues, from 0, far away, to 1, at
    /// the border. The ground rises toward such borders, so that divides follow them, and not rivers. Empty like the
    /// costs.
    pub border: Vec<f32>,
    /// The factor for the cost of each step: 1, but small along drawn rivers, so that water keeps to them. Empty like
    /// the costs.
    pub toll: Vec<f32>,
    /// The places where water leaves the land.
    pub outlets: Vec<Outlet>,
    /// The outlet of each parcel; [`NONE`] for most.
    pub outlet_of: Vec<u32>,
}

impl Parcels {
    /// Lays out the parcels of a land.
    pub fn new(settings: &GrowthSettings) -> Self {
        let mut this = Self::without_costs(settings);
        this.border = this.at.iter().map(|&at| nearness_to_border(settings, at)).collect();
        this.toll = tolls(settings, &this.at);
        this.weigh(settings);
        this
    }

    /// Lays out the parcels without costs and their ingredients, for use without drainage.
    pub fn without_costs(settings: &GrowthSettings) -> Self {
        let mut lattice = Lattice::new(settings);
        let cells = land_cells(settings, &mut lattice);
        let mut number = vec![NONE; lattice.at.len()];
        for (i, &cell) in (0..).zip(&cells) {
            number[cell] = i;
        }
        let mut this = Self {
            at: cells.iter().map(|&cell| lattice.at[cell]).collect(),
            identity: cells.iter().map(|&cell| lattice.identity(cell)).collect(),
            neighbours: vec![[NONE; 6]; cells.len()],
            ..Self::default()
        };
        this.join_neighbours(settings, &lattice, &cells, &number);
        this.outlets = outlets::find(settings, &lattice, &cells, &this.neighbours);
        this.outlet_of = vec![NONE; cells.len()];
        for (i, outlet) in (0..).zip(&this.outlets) {
            this.outlet_of[outlet.parcel as usize] = i;
        }
        this
    }

    /// The number of parcels.
    pub fn len(&self) -> usize {
        self.at.len()
    }

    /// The cost of crossing to a parcel from its neighbour in a direction.
    #[inline]
    pub fn cost_from(&self, parcel: usize, way: usize) -> f32 {
        self.costs[parcel][way]
    }

    /// The cost of leaving the land from the parcel of an outlet.
    pub fn cost_out(&self, parcel: usize) -> f32 {
        let outlet = self.outlets.get(self.outlet_of[parcel] as usize);
        outlet.map_or(f32::INFINITY, |outlet| distance(self.at[parcel], outlet.at))
    }

    /// The cost of crossing from a parcel to a neighbour.
    pub fn cost_to(&self, parcel: usize, neighbour: u32) -> f32 {
        let way = self.neighbours[parcel].iter().position(|&there| there == neighbour);
        way.map_or(f32::INFINITY, |way| self.cost_from(neighbour as usize, (way + WAYS) % 6))
    }

    fn join_neighbours(&mut self, settings: &GrowthSettings, lattice: &Lattice, cells: &[usize], number: &[u32]) {
        work::count(cells.len() * WAYS);
        for (parcel, &cell) in cells.iter().enumerate() {
            let around = lattice.neighbours(cell);
            for way in 0..WAYS {
                let there = number[around[way]];
                if there != NONE
                    && lattice.is_edge(cell, way)
                    && settings.allows(lattice.at[cell], lattice.at[around[way]])
                {
                    self.neighbours[parcel][way] = there;
                    self.neighbours[there as usize][way + WAYS] = parcel as u32;
                }
            }
        }
    }

    /// Adds hard and soft ground, its grain and its fall. Each edge has its own random part, and one that it shares with
    /// many around it.
    fn weigh(&mut self, growth: &GrowthSettings) {
        const CHANCE: f32 = 0.47;
        let settings = &growth.drainage;
        let noise = settings.noise(2, settings.hardness_scale, 4, 0.6);
        let country = Country::new(growth);
        let ground = |(&at, border): (&Vec2, &f32)| {
            settings.hardness * DEVIATION * noise.get_noise_2d(at.x, at.y) + BORDER * border + country.hardness(at)
        };
        let hardness: Vec<f32> = self.at.iter().zip(&self.border).map(ground).collect();
        let chance = settings.seed.item_hash(Purpose::Ground);
        self.costs = vec![[0.0; 6]; self.len()];
        for parcel in 0..self.len() {
            for way in 0..WAYS {
                let there = self.neighbours[parcel][way] as usize;
                if let Some(&to) = self.at.get(there) {
                    let (from, [i, j]) = (self.at[parcel], self.identity[parcel]);
                    let own = CHANCE * chance.normal([i, j, 2 + way as u32]);
                    let ground = 0.5 * (hardness[parcel] + hardness[there]);
                    let toll = self.toll[parcel].max(self.toll[there]);
                    let cost = distance(from, to) * libm::expf(own + ground) * toll;
                    let [forward, back] = country.costs(from, to, cost);
                    self.costs[there][way + WAYS] = forward;
                    self.costs[parcel][way] = back;
                }
            }
        }
    }
}

/// The logarithm of the additional hardness of ground at a border beyond which land continues.
const BORDER: f32 = 1.5;

/// The nearness of a place to a border of the domain beyond which land continues. A rectangle has the sea beyond its
/// chosen sides, unless mouths are drawn.
fn nearness_to_border(settings: &GrowthSettings, at: Vec2) -> f32 {
    const SPACINGS: f32 = 8.0;
    let is_closed = |side| settings.land.is_some() || !settings.starts.is_empty() || !settings.sides.contains(side);
    let sides = settings.domain.sides(at).into_iter();
    let nearest = sides.filter(|&(side, _)| is_closed(side)).map(|(_, far)| far).fold(f32::INFINITY, f32::min);
    let share = (1.0 - nearest / (SPACINGS * settings.drainage.spacing)).max(0.0);
    share * share
}

/// The tolls of places. They rise so steeply beside a drawn river that the cheapest way follows its bends.
fn tolls(settings: &GrowthSettings, places: &[Vec2]) -> Vec<f32> {
    const LEAST: f32 = 0.01;
    const BESIDE: f32 = 0.1;
    let courses = settings.starts.iter().map(|start| &start.course);
    let pieces: Vec<[Vec2; 2]> = courses.flat_map(|course| course.windows(2)).map(|pair| [pair[0], pair[1]]).collect();
    if pieces.is_empty() {
        return vec![1.0; places.len()];
    }
    let from_courses = CoastDistance::from_lines(&settings.domain, &pieces);
    let toll = |&at: &Vec2| {
        let away = from_courses.height(at) / settings.drainage.spacing;
        let squared = away * away;
        (LEAST + BESIDE * squared * squared).min(1.0)
    };
    places.iter().map(toll).collect()
}

/// The cells of the lattice that are parcels: those on land and, if mouths are drawn, on land that has one.
fn land_cells(settings: &GrowthSettings, lattice: &mut Lattice) -> Vec<usize> {
    let with_a_mouth = settings.land.as_deref().filter(|_| !settings.starts.is_empty());
    let watered = with_a_mouth.map(|land| Watered::of(settings, land));
    let is_land = |&cell: &usize| {
        let at = lattice.at[cell];
        lattice.is_inner(cell)
            && settings.domain.contains(at)
            && settings.land.as_ref().is_none_or(|land| land.at(at) == Cell::Land)
            && watered.as_ref().is_none_or(|watered| watered.holds(at))
    };
    let mut cells: Vec<usize> = (0..lattice.at.len()).filter(is_land).collect();
    lattice.break_edges(&cells);
    cells.retain(|&cell| lattice.has_edges(cell));
    cells
}
