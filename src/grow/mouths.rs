//! Positions of river mouths.

use glam::Vec2;

use super::mouth::Mouth;
use super::settings::GrowthSettings;
use crate::base::geometry::distance;
use crate::base::random::{Purpose, Stream};
use crate::base::sort;
use crate::base::work;
use crate::land::{Land, Region, Shore};
use crate::recipe::Sides;

/// The distance that a mouth may stray from the middle of its share of the coast, as a part of that share.
const STRAY: f32 = 0.7;

/// Places the mouths of a recipe: the drawn ones; otherwise along the sides of a plain rectangle, or on the coasts of
/// the regions that have any.
pub fn mouths(settings: &GrowthSettings) -> Vec<Mouth> {
    if !settings.starts.is_empty() {
        return settings.starts.iter().map(|start| start.mouth).collect();
    }
    let Some(land) = &settings.land else { return on_sides(settings) };
    let mut chance = settings.seed.stream(Purpose::Mouths);
    let mut mouths = Vec::new();
    for (region, &count) in land.regions().iter().zip(&settings.basins) {
        let coast = chosen_shores(region, settings.shores);
        mouths.extend(if settings.has_valleys() {
            steadily_on_coast(settings, land, &coast, count)
        } else {
            on_coast(land, &coast, count, settings.mouth_spacing, &mut chance)
        });
    }
    mouths
}

/// Lists the places where further rivers may reach the sea. Empty where mouths are drawn, and on a plain rectangle,
/// which has a border but no coast.
pub fn shores(settings: &GrowthSettings) -> Vec<Shore> {
    let mut shores = Vec::new();
    if settings.starts.is_empty() {
        settings.watered().for_each(|region| shores.extend(chosen_shores(region, settings.shores)));
    }
    shores
}

/// Lists the shores of a region that lie on some sides, seen from the middle of its coast: the north shore of an island
/// faces north, that of a lake south. All shores if none lies on these sides, because no land is left dry.
fn chosen_shores(region: &Region, sides: Sides) -> Vec<Shore> {
    on_chosen_sides(region, sides, region.shores.clone(), |shore| shore.at)
}

/// Keeps the places on the coast of a region that lie on some sides, seen from the middle of the coast; all of them if
/// none does.
pub(super) fn on_chosen_sides<T>(region: &Region, sides: Sides, mut places: Vec<T>, at: impl Fn(&T) -> Vec2) -> Vec<T> {
    let middle = region.shores.iter().map(|shore| shore.at).sum::<Vec2>() / region.shores.len() as f32;
    let is_chosen = |place: &T| sides.contains(side_toward(at(place) - middle));
    if places.iter().any(is_chosen) {
        places.retain(is_chosen);
    }
    places
}

/// The side that a direction leads to.
#[inline(never)] // each copy weighs a hundred bytes
fn side_toward(Vec2 { x, y }: Vec2) -> char {
    match (x.abs() > y.abs(), x > 0.0, y > 0.0) {
        (true, true, _) => 'e',
        (true, false, _) => 'w',
        (false, _, true) => 's',
        (false, _, false) => 'n',
    }
}

/// Places mouths on a coast, each at the best of some random places: far from the previous mouths, so that they keep
/// apart (Mitchell 1991), and in a bay rather than on a cape, where rivers usually meet the sea. Places fewer mouths if
/// they would come too close to each other.
fn on_coast(land: &Land, coast: &[Shore], count: u32, apart: f32, chance: &mut Stream) -> Vec<Mouth> {
    const CANDIDATES: usize = 24;
    /// The distance, in units, beyond which a greater one does not make a place better.
    const REMOTE: f32 = 400.0;
    let mut mouths: Vec<Mouth> = Vec::new();
    for _ in 0..count {
        work::count(CANDIDATES * (mouths.len() + 1));
        let mut best: Option<(f32, &Shore)> = None;
        for _ in 0..CANDIDATES {
            let Some(shore) = coast.get((chance.unit() * coast.len() as f32) as usize) else { continue };
            let remoteness = mouths.iter().map(|mouth| distance(mouth.at, shore.at)).fold(f32::INFINITY, f32::min);
            let score = remoteness.min(REMOTE) * (1.0 + land.shelter(shore.at)).max(0.1);
            if remoteness > apart && best.is_none_or(|(greatest, _)| score > greatest) {
                best = Some((score, shore));
            }
        }
        mouths.extend(best.map(|(_, shore)| Mouth { at: shore.at, inland: shore.inland }));
    }
    mouths
}

/// Places mouths on a coast so that they stay where they are when it changes slightly. Each cell of the plane that the
/// coast runs through has one place, with a weight that depends on chance, on its being in a bay, and on how well the
/// coast fills the cell. Mouths are the places farthest from any place of greater weight: so they keep apart, and a
/// change in one place leaves the others alone.
fn steadily_on_coast(settings: &GrowthSettings, land: &Land, coast: &[Shore], count: u32) -> Vec<Mouth> {
    // In units; smaller if many mouths are asked for.
    let side = if settings.mouths > 16 { 25.0 } else { 50.0 };
    let chance = settings.seed.item_hash(Purpose::Mouths);
    let weight = |&(fitness, [column, row], shore): &Place| {
        // Chance has a large part, so that a slightly larger or smaller bay seldom decides, and the best places have no
        // further advantage.
        ((2.0 * fitness).clamp(0.0, 1.6) / (1.005 - chance.unit([column, row, 2])), shore)
    };
    let weighed: Vec<(f32, Shore)> = places_by_cell(settings, land, coast, side).iter().map(weight).collect();
    work::count(weighed.len() * weighed.len());
    let remoteness = |&(weight, shore): &(f32, Shore)| {
        let greater = weighed.iter().filter(|(other, _)| *other > weight);
        greater.map(|(_, other)| distance(other.at, shore.at)).fold(f32::INFINITY, f32::min)
    };
    let remoteness: Vec<f32> = weighed.iter().map(remoteness).collect();
    let remotest_first = sort::argsort(remoteness.iter().map(|&far| !sort::key(far)));
    let chosen = remotest_first.into_iter().take(count as usize).filter(|&i| remoteness[i] > settings.mouth_spacing);
    chosen.map(|i| Mouth { at: weighed[i].1.at, inland: weighed[i].1.inland }).collect()
}

/// A place on a coast: its fitness for a mouth, its cell of the plane, and the shore.
type Place = (f32, [u32; 2], Shore);

/// Finds the fittest place in each cell of the plane: in a bay, and near a random point of the cell, so that it hardly moves.
fn places_by_cell(settings: &GrowthSettings, land: &Land, coast: &[Shore], side: f32) -> Vec<Place> {
    let chance = settings.seed.item_hash(Purpose::Mouths);
    let (columns, rows) = ((settings.domain.size.x / side) as usize + 1, (settings.domain.size.y / side) as usize + 1);
    let mut fittest: Vec<Option<Place>> = vec![None; columns * rows];
    work::count(8 * coast.len());
    for &shore in coast {
        let cell = [shore.at.x, shore.at.y].map(|along| (along / side) as u32);
        let point = Vec2::new(chance.unit([cell[0], cell[1], 0]), chance.unit([cell[0], cell[1], 1]));
        let corner = Vec2::new(cell[0] as f32, cell[1] as f32);
        let fitness = 1.0 + land.shelter(shore.at) - distance(shore.at, (corner + point) * side) / side;
        let fittest = &mut fittest[cell[1] as usize * columns + cell[0] as usize];
        if fittest.is_none_or(|(other, ..)| fitness > other) {
            *fittest = Some((fitness, cell, shore));
        }
    }
    fittest.into_iter().flatten().collect()
}

/// Places mouths along the chosen sides, one in each of equal shares of their total length, so that they keep apart.
fn on_sides(settings: &GrowthSettings) -> Vec<Mouth> {
    let coast = coast(settings);
    let length: f32 = coast.iter().map(|side| side.length).sum();
    let share = length / settings.mouths as f32;
    let mut chance = settings.seed.stream(Purpose::Mouths);
    (0..settings.mouths)
        .map(|i| {
            let stray = (chance.unit() - 0.5) * STRAY;
            along(&coast, (i as f32 + 0.5 + stray) * share)
        })
        .collect()
}

/// A side of the domain that is a coast, in clockwise direction.
struct Side {
    start: Vec2,
    direction: Vec2,
    length: f32,
}

fn coast(settings: &GrowthSettings) -> Vec<Side> {
    let Vec2 { x: width, y: height } = settings.domain.size;
    let side = |initial: char, start: Vec2, direction: Vec2, length: f32| {
        settings.sides.contains(initial).then_some(Side { start, direction, length })
    };
    [
        side('n', Vec2::ZERO, Vec2::X, width),
        side('e', Vec2::new(width, 0.0), Vec2::Y, height),
        side('s', Vec2::new(width, height), Vec2::NEG_X, width),
        side('w', Vec2::new(0.0, height), Vec2::NEG_Y, height),
    ]
    .into_iter()
    .flatten()
    .collect()
}

/// Returns the mouth at a distance along the coast.
fn along(coast: &[Side], mut way: f32) -> Mouth {
    let mut sides = coast.iter().peekable();
    while let Some(side) = sides.next() {
        if way <= side.length || sides.peek().is_none() {
            // Walking clockwise, with y down, the land is on the right.
            return Mouth { at: side.start + side.direction * way.min(side.length), inland: side.direction.perp() };
        }
        way -= side.length;
    }
    Mouth { at: Vec2::ZERO, inland: Vec2::Y }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grow::Colonize;
    use crate::lands::lands_with_a_coast;
    use crate::recipe::link;
    use crate::tree::NO_PARENT;

    #[test]
    fn mouths_lie_on_the_chosen_sides_and_look_inland() {
        for sides in ["n", "e", "s", "w", "ns", "nesw"] {
            let recipe = link::read(&format!("land=rectangle&mouths=9&sides={sides}")).unwrap();
            let settings = GrowthSettings::of(&recipe);
            let size = settings.domain.size;
            for mouth in mouths(&settings) {
                let gap = |side| match side {
                    'n' => mouth.at.y,
                    'e' => size.x - mouth.at.x,
                    's' => size.y - mouth.at.y,
                    _ => mouth.at.x,
                };
                assert!(sides.chars().any(|side| gap(side) == 0.0), "{sides}: {mouth:?}");
                assert!(settings.domain.contains(mouth.at + mouth.inland), "{sides}: {mouth:?}");
            }
        }
    }

    const GROWTHS: [&str; 2] = ["growth=colonize&valleys=0", "growth=colonize&valleys=0.2"];

    #[test]
    fn mouths_lie_in_bays_rather_than_on_capes() {
        for (kind, growth) in
            lands_with_a_coast().into_iter().flat_map(|kind| GROWTHS.map(|growth| (kind.clone(), growth)))
        {
            let (mut at_mouths, mut along_coasts) = (Vec::new(), Vec::new());
            for seed in 0..8 {
                let link =
                    format!("{kind}&{growth}&roughness=1&sea=0.4&mouths=6&mouth-spacing=0&shores=nesw&seed={seed}");
                let settings = GrowthSettings::of(&link::read(&link).unwrap());
                let land = settings.land.as_ref().unwrap();
                at_mouths.extend(mouths(&settings).iter().map(|mouth| land.shelter(mouth.at)));
                along_coasts.extend(shores(&settings).iter().map(|shore| land.shelter(shore.at)));
            }
            let mean = |shelters: &[f32]| shelters.iter().sum::<f32>() / shelters.len() as f32;
            let (mouths, coasts) = (mean(&at_mouths), mean(&along_coasts));
            assert!(mouths > coasts + 0.03, "{kind}, {growth}: {mouths} at mouths, {coasts} along coasts");
        }
    }

    /// Returns the mouths of a grown tree's rivers, region by region.
    fn grown_mouths(link: &str) -> Vec<Vec<Vec2>> {
        let mut growth = Colonize::new(GrowthSettings::of(&link::read(link).unwrap())).unwrap();
        while growth.tick() {}
        let (tree, land) = (growth.tree(), growth.settings().land.as_ref().unwrap());
        let roots: Vec<Vec2> = (0..tree.len()).filter(|&i| tree.parent[i] == NO_PARENT).map(|i| tree.at[i]).collect();
        let is_of = |region: &Region, root: &Vec2| region.shores.iter().any(|shore| shore.at == *root);
        let of_region = |region| roots.iter().filter(|root| is_of(region, root)).copied().collect();
        land.regions().iter().map(of_region).collect()
    }

    #[test]
    fn mouths_of_a_coast_keep_as_far_apart_as_asked() {
        for kind in lands_with_a_coast() {
            let mut counts = Vec::new();
            for (apart, growth) in [0, 60, 150, 400].into_iter().flat_map(|apart| GROWTHS.map(|growth| (apart, growth)))
            {
                let link =
                    format!("{kind}&{growth}&seed=kauri&shores=nesw&attractors=300&mouths=40&mouth-spacing={apart}");
                let regions = grown_mouths(&link);
                for mouths in &regions {
                    let pairs =
                        mouths.iter().enumerate().flat_map(|(i, a)| mouths[..i].iter().map(move |b| a.distance(*b)));
                    let nearest = pairs.fold(f32::INFINITY, f32::min);
                    assert!(nearest > apart as f32, "{link}: two mouths are {nearest} apart, not {apart}");
                }
                counts.push(regions.iter().map(Vec::len).sum::<usize>());
            }
            assert!(counts[..2].iter().all(|&count| count >= 40), "{kind}: {counts:?} mouths");
            assert!(counts[6..].iter().all(|&count| (1..20).contains(&count)), "{kind}: {counts:?} mouths");
        }
    }
}
