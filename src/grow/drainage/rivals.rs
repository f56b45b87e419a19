//! Rivals: great rivers that leave the land side by side, or meet just before. Between rounds the lesser one loses its
//! outlet, or the bed of its last reach, so that its water finds another way to the greater, and they meet inland.

use super::directions::FlowDirections;
use super::parcels::Parcels;
use super::settings::DrainageSettings;
use crate::base::geometry::distance;
use crate::base::sort;
use crate::base::work;
use crate::grow::GrowthSettings;

/// The distance between outlets up to which great rivers are rivals, in units.
const APART: f32 = 24.0;

/// The length of a river above its outlet in which great ones that join it are rivals, in units: that of a small river, and
/// what is added as a share of the root of the area that it drains.
const LENGTH: f32 = 20.0;
const LENGTH_BY_AREA: f32 = 0.1;

/// The network that a round has found.
pub(super) struct Found<'a> {
    pub settings: &'a GrowthSettings,
    pub parcels: &'a Parcels,
    pub directions: &'a FlowDirections,
    /// The number of parcels that each parcel drains.
    pub areas: &'a [u32],
}

/// A great river's way to its outlet.
#[derive(Clone, Copy, Debug)]
struct Way {
    /// The distance to the outlet along the river, in units, and that up to which others are rivals.
    far: f32,
    length: f32,
    /// `true` if a greater river takes it in on the way.
    is_lesser: bool,
}

impl Found<'_> {
    /// Lists the outlets of great rivers near that of a greater one on the same land. Where a recipe gives the number or the distance of
    /// mouths there are none.
    pub fn rival_outlets(&self) -> Vec<usize> {
        let Self { settings, parcels, directions, areas } = self;
        if settings.mouths > 0 || settings.mouth_spacing > 0.0 || !settings.starts.is_empty() {
            return Vec::new();
        }
        let parcel = |outlet: usize| parcels.outlets[outlet].parcel as usize;
        let ends_here = |outlet: &usize| directions.to[parcel(*outlet)] == FlowDirections::OUT;
        let great: Vec<usize> =
            (0..parcels.outlets.len()).filter(|outlet| ends_here(outlet) && self.is_great(parcel(*outlet))).collect();
        let greatest_first = sort::argsort(great.iter().map(|&outlet| u32::MAX - areas[parcel(outlet)]));
        let (mut others, mut rivals) = (Vec::new(), Vec::new());
        for outlet in greatest_first.into_iter().map(|i| great[i]) {
            work::count(others.len());
            let at = parcels.outlets[outlet].at;
            let is_near = |&other| distance(other, at) < APART && settings.is_same_region(other, at);
            if others.iter().any(is_near) {
                rivals.push(outlet);
            } else {
                others.push(at);
            }
        }
        rivals
    }

    /// Lists the parcels in the last reaches of great rivers that meet a greater one close above its outlet.
    pub fn rival_reaches(&self) -> Vec<usize> {
        let Self { parcels, directions, areas, .. } = self;
        let great: Vec<usize> =
            directions.order.iter().map(|&here| here as usize).filter(|&here| self.is_great(here)).collect();
        work::count(2 * great.len());
        let mut greatest = vec![0; parcels.len()];
        for &here in &great {
            if let Some(most) = greatest.get_mut(directions.to[here] as usize) {
                *most = areas[here].max(*most);
            }
        }
        let mut ways: Vec<Option<Way>> = vec![None; parcels.len()];
        let mut rivals = Vec::new();
        for here in great {
            ways[here] = match directions.to[here] {
                FlowDirections::OUT => Some(self.begin(here)),
                below => ways[below as usize].and_then(|way| {
                    let far = way.far + distance(parcels.at[here], parcels.at[below as usize]);
                    let is_lesser = way.is_lesser || areas[here] < greatest[below as usize];
                    (far < way.length).then_some(Way { far, is_lesser, ..way })
                }),
            };
            rivals.extend(ways[here].filter(|way| way.is_lesser).map(|_| here));
        }
        rivals
    }

    /// Begins the way of a river at its outlet.
    fn begin(&self, parcel: usize) -> Way {
        let area = self.areas[parcel] as f32 * self.of_a_parcel();
        Way { far: self.parcels.cost_out(parcel), length: LENGTH + LENGTH_BY_AREA * area.sqrt(), is_lesser: false }
    }

    fn is_great(&self, parcel: usize) -> bool {
        self.areas[parcel] as f32 * self.of_a_parcel() >= DrainageSettings::GREAT
    }

    /// Returns the area of a parcel, in square units.
    fn of_a_parcel(&self) -> f32 {
        self.settings.drainage.spacing * self.settings.drainage.spacing
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test fails by panicking")]
mod tests {
    use glam::Vec2;

    use super::super::outlets::Outlet;
    use super::*;
    use crate::recipe::link;

    /// Parcels at places, which drain to one another, and their outlets.
    fn parcels(at: Vec<Vec2>, outlets: &[(f32, f32, u32)]) -> Parcels {
        let mut outlet_of = vec![u32::MAX; at.len()];
        (0..).zip(outlets).for_each(|(i, &(_, _, parcel))| outlet_of[parcel as usize] = i);
        let mut parcels = Parcels::default();
        (parcels.at, parcels.outlet_of) = (at, outlet_of);
        parcels.outlets = outlets.iter().map(|&(x, y, parcel)| Outlet { at: Vec2::new(x, y), parcel }).collect();
        parcels
    }

    fn settings(over: &str) -> GrowthSettings {
        let text = format!("growth=drainage&land=rectangle&sides=s&attractors=10000&country=usual&seed=kauri{over}");
        let mut settings = GrowthSettings::of(&link::read(&text).unwrap());
        settings.drainage.spacing = 10.0;
        settings
    }

    /// Finds rivals among four rivers that drain 100, 90, 41 and 39 parcels of 100 square units, 10 units apart.
    fn outlets(settings: &GrowthSettings) -> Vec<usize> {
        let at = |i: usize| Vec2::new(10.0 * i as f32, 500.0);
        let parcels = parcels((0..4).map(at).collect(), &[0, 1, 2, 3].map(|i| (10.0 * i as f32, 505.0, i)));
        let directions = FlowDirections { to: vec![FlowDirections::OUT; 4], order: vec![0, 1, 2, 3] };
        Found { settings, parcels: &parcels, directions: &directions, areas: &[90, 100, 39, 41] }.rival_outlets()
    }

    #[test]
    fn great_rivers_near_a_greater_one_lose_their_outlets() {
        // The third is too small, and the greatest is the second.
        assert_eq!(outlets(&settings("")), [0, 3]);
    }

    #[test]
    fn mouths_that_are_asked_for_stay() {
        assert!(outlets(&settings("&mouths=4")).is_empty());
        assert!(outlets(&settings("&mouth-spacing=5")).is_empty());
    }

    #[test]
    fn the_lesser_of_two_that_meet_close_above_the_sea_loses_its_last_reach() {
        // The trunk runs north; the second parcel takes in a lesser river from the east, the sixth another, 60 units from the sea.
        let trunk = (0..7).map(|i| Vec2::new(500.0, 500.0 - 10.0 * i as f32));
        let [lower, upper] = [480.0, 450.0].map(|y| (1..6).map(move |i| Vec2::new(500.0 + 10.0 * i as f32, y)));
        let parcels = parcels(trunk.chain(lower).chain(upper).collect(), &[(500.0, 505.0, 0)]);
        let to = vec![FlowDirections::OUT, 0, 1, 2, 3, 4, 5, 2, 7, 8, 9, 10, 5, 12, 13, 14, 15];
        let order = (0..17).collect();
        let directions = FlowDirections { to, order };
        let mut areas = [400; 17];
        areas[7..].fill(100);
        areas[9] = 39;
        let found = Found { settings: &settings(""), parcels: &parcels, directions: &directions, areas: &areas };
        // 20 units and a tenth of the root of 40,000 square units: only the first two of the lower arm are near enough, but the second
        // place above them is that of a small river.
        assert_eq!(found.rival_reaches(), [7], "up to 40 units from the sea");
    }
}
