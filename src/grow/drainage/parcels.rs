//! Parcels: pieces of land that each drain themselves, with their neighbours, and the outlets through which water
//! leaves the land.

use glam::Vec2;

use super::adjacency::Adjacency;
use super::country::Country;
use super::directions::NONE;
use super::lattice::Lattice;
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
    /// The neighbours of each parcel that water may come from or go to.
    pub neighbours: Adjacency,
    /// The cost at which water arrives from each of these neighbours: effort times hardness of the ground, less where
    /// the land falls that way. Empty if no water has to find its way.
    costs: Vec<f32>,
    /// `true` for parcels on the rim of the land: a coast, a ridge or the border of the domain.
    pub is_on_rim: Vec<bool>,
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
        let (mut this, unbent) = Self::lay_out(settings);
        this.border = this.at.iter().map(|&at| nearness_to_border(settings, at)).collect();
        this.toll = tolls(settings, &this.at);
        this.weigh(settings, &unbent);
        this
    }

    /// Lays out the parcels without costs and their ingredients, for use without drainage.
    pub fn without_costs(settings: &GrowthSettings) -> Self {
        Self::lay_out(settings).0
    }

    /// Lays out the parcels without costs. Returns them with their positions before the plane was bent.
    fn lay_out(settings: &GrowthSettings) -> (Self, Vec<Vec2>) {
        let lattice = Lattice::new(settings);
        let around = Adjacency::of_places(&lattice.at);
        let on_land = places_on_land(settings, &lattice.at);
        let mut number = vec![NONE; lattice.at.len()];
        for (i, &place) in (0..).zip(&on_land) {
            number[place] = i;
        }
        let neighbours = join_neighbours(settings, &lattice.at, &around, &on_land, &number);
        let rim = |(parcel, &place): (usize, &usize)| neighbours.of(parcel).len() < around.of(place).len();
        let mut this = Self {
            at: on_land.iter().map(|&place| lattice.at[place]).collect(),
            identity: on_land.iter().map(|&place| lattice.identity[place]).collect(),
            is_on_rim: on_land.iter().enumerate().map(rim).collect(),
            ..Self::default()
        };
        let beyond = |parcel: usize| {
            let (joined, around) = (neighbours.of(parcel), around.of(on_land[parcel]));
            let others = around.iter().filter(|&&there| !joined.contains(&number[there as usize]));
            others.map(|&there| lattice.at[there as usize])
        };
        this.outlets = outlets::find(settings, &this.at, beyond);
        this.outlet_of = vec![NONE; this.len()];
        for (i, outlet) in (0..).zip(&this.outlets) {
            this.outlet_of[outlet.parcel as usize] = i;
        }
        this.neighbours = neighbours;
        (this, on_land.iter().map(|&place| lattice.unbent[place]).collect())
    }

    /// Returns the number of parcels.
    pub fn len(&self) -> usize {
        self.at.len()
    }

    /// Iterates over the neighbours of a parcel, each with the cost of crossing from it.
    #[inline]
    pub fn ways_to(&self, parcel: usize) -> impl Iterator<Item = (u32, f32)> {
        let range = self.neighbours.range(parcel);
        self.neighbours.to[range.clone()].iter().copied().zip(self.costs[range].iter().copied())
    }

    /// Returns the cost of leaving the land from the parcel of an outlet.
    pub fn cost_out(&self, parcel: usize) -> f32 {
        let outlet = self.outlets.get(self.outlet_of[parcel] as usize);
        outlet.map_or(f32::INFINITY, |outlet| distance(self.at[parcel], outlet.at))
    }

    /// Returns the cost of crossing from a parcel to a neighbour.
    pub fn cost_to(&self, parcel: usize, neighbour: u32) -> f32 {
        self.ways_to(neighbour as usize)
            .find(|&(from, _)| from as usize == parcel)
            .map_or(f32::INFINITY, |(_, cost)| cost)
    }

    /// Adds hard and soft ground, its grain and its fall. Each edge has its own random part, and one that it shares with
    /// many around it.
    fn weigh(&mut self, growth: &GrowthSettings, unbent: &[Vec2]) {
        const CHANCE: f32 = 0.2;
        let settings = &growth.drainage;
        let noise = settings.rock();
        let country = Country::new(growth);
        let ground = |(&at, border): (&Vec2, &f32)| {
            settings.hardness * DEVIATION * noise.get_noise_2d(at.x, at.y) + BORDER * border + country.hardness(at)
        };
        let hardness: Vec<f32> = self.at.iter().zip(&self.border).map(ground).collect();
        let chance = settings.seed.item_hash(Purpose::Ground);
        self.costs = vec![0.0; self.neighbours.to.len()];
        for parcel in 0..self.len() {
            for way in self.neighbours.range(parcel) {
                let there = self.neighbours.to[way] as usize;
                // Each edge is met twice, once from either end.
                if there < parcel {
                    continue;
                }
                let (from, to) = (self.at[parcel], self.at[there]);
                let own = CHANCE * chance.normal(edge_between(self.identity[parcel], self.identity[there]));
                let ground = 0.5 * (hardness[parcel] + hardness[there]);
                let toll = self.toll[parcel].max(self.toll[there]);
                let effort = effort([from, to], [unbent[parcel], unbent[there]]);
                let cost = effort * libm::expf(own + ground) * toll;
                let [forward, back] = country.costs(from, to, cost);
                self.costs[way] = back;
                let range = self.neighbours.range(there);
                let same = |way: &usize| self.neighbours.to[*way] as usize == parcel;
                range.into_iter().filter(same).for_each(|way| self.costs[way] = forward);
            }
        }
    }
}

/// Returns the cost of an edge on level, even ground, from its ends and those before the plane was bent: l₀²/l, where l
/// is its length and l₀ its length before. An edge along which the plane was drawn out is cheap, so the cheapest ways
/// follow the bends.
fn effort([from, to]: [Vec2; 2], unbent: [Vec2; 2]) -> f32 {
    unbent[0].distance_squared(unbent[1]) / distance(from, to)
}

/// Joins parcels that are neighbours if water may cross from one to the other.
fn join_neighbours(
    settings: &GrowthSettings,
    places: &[Vec2],
    around: &Adjacency,
    on_land: &[usize],
    number: &[u32],
) -> Adjacency {
    let mut pairs = Vec::with_capacity(3 * on_land.len());
    for (parcel, &place) in (0..).zip(on_land) {
        for &there in around.of(place) {
            let other = number[there as usize];
            if other != NONE && other > parcel && settings.allows(places[place], places[there as usize]) {
                pairs.push((parcel, other));
            }
        }
    }
    work::count(around.to.len());
    Adjacency::of_edges(on_land.len(), pairs.iter().flat_map(|&(a, b)| [(a, b), (b, a)]))
}

/// Returns the numbers that identify an edge between two cells: those of one cell, and the way to the other.
fn edge_between(a: [u32; 2], b: [u32; 2]) -> [u32; 3] {
    let [[i, j], [k, l]] = if a < b { [a, b] } else { [b, a] };
    let (across, down) = (k.wrapping_sub(i) & 0xffff, l.wrapping_sub(j) & 0xffff);
    // Neither 0 nor 1, which stand for other random numbers of a cell.
    [i, j, ((down << 16) | across).wrapping_add(2)]
}

/// The logarithm of the additional hardness of ground at a border beyond which land continues.
const BORDER: f32 = 1.5;

/// Returns the nearness of a place to a border of the domain beyond which land continues. A rectangle has the sea
/// beyond its chosen sides, unless mouths are drawn.
fn nearness_to_border(settings: &GrowthSettings, at: Vec2) -> f32 {
    const SPACINGS: f32 = 8.0;
    let is_closed = |side| settings.land.is_some() || !settings.starts.is_empty() || !settings.sides.contains(side);
    let sides = settings.domain.sides(at).into_iter();
    let nearest = sides.filter(|&(side, _)| is_closed(side)).map(|(_, far)| far).fold(f32::INFINITY, f32::min);
    let share = (1.0 - nearest / (SPACINGS * settings.drainage.spacing)).max(0.0);
    share * share
}

/// Computes the toll of each place. Tolls rise so steeply beside a drawn river that the cheapest way follows its bends.
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

/// Lists the indices of the places that are parcels: those on land and, if mouths are drawn, on land that has one.
fn places_on_land(settings: &GrowthSettings, places: &[Vec2]) -> Vec<usize> {
    let with_a_mouth = settings.land.as_deref().filter(|_| !settings.starts.is_empty());
    let watered = with_a_mouth.map(|land| Watered::of(settings, land));
    let is_on_land = |&place: &usize| {
        let at = places[place];
        settings.domain.contains(at)
            && settings.land.as_ref().is_none_or(|land| land.at(at) == Cell::Land)
            && watered.as_ref().is_none_or(|watered| watered.holds(at))
    };
    (0..places.len()).filter(is_on_land).collect()
}
