//! The numbers of places: those of the cells in which their midst lies, so that an own name stays on its place when the coast moves a little.

use super::lattice::SIDE;
use super::places::Place;
use super::squares::Squares;
use super::{PlaceKind, PlaceName};
use crate::base::sort;
use crate::recipe::{Mark, OwnNames};

/// Squares of the size of the cells on which coasts are read.
const SQUARES: Squares = Squares(SIDE);

/// The greatest distance of a place from its mark, in units, to which half its size is added.
const TOLERANCE: f32 = 48.0;

/// Returns the mark of a place.
pub(super) fn mark(kind: PlaceKind, number: u32) -> Mark {
    match kind {
        PlaceKind::Sea => Mark::Sea(number),
        PlaceKind::Lake => Mark::Lake(number),
        PlaceKind::Island => Mark::Island(number),
        // A gulf that a little more land makes a bay keeps its name.
        PlaceKind::Gulf | PlaceKind::Bay => Mark::Bay(number),
        PlaceKind::Cape => Mark::Cape(number),
        PlaceKind::Strait => Mark::Strait(number),
        PlaceKind::Range => Mark::Range(number),
    }
}

impl PlaceName {
    /// Returns the mark by which own names know it.
    pub fn mark(&self) -> Mark {
        mark(self.kind, self.number)
    }
}

/// Numbers places: by an own mark for a place of the same kind that is the nearest to it and near enough, else by the place's cell. No two
/// marks are alike. The main land has 0.
pub(super) fn numbers(places: &[Place], own: &OwnNames) -> Vec<u32> {
    let main_land = |place: &Place| place.is_main_land().then_some(0);
    let mut numbers: Vec<Option<u32>> = places.iter().map(main_land).collect();
    let mut pairs = Vec::new();
    for (i, place) in places.iter().enumerate().filter(|(_, place)| !place.is_main_land()) {
        for number in own.marks().filter_map(|own| number_of(own, place.found.kind)).filter(|&number| number > 0) {
            let away = place.found.at.distance(SQUARES.middle(number));
            if away <= TOLERANCE + 0.5 * place.found.size {
                pairs.push((away, i, number));
            }
        }
    }
    // The nearest first; of those as near, the greater place.
    for next in sort::argsort(pairs.iter().map(|(away, ..)| sort::key(*away))) {
        let (_, i, number) = pairs[next];
        if numbers[i].is_none() && !is_taken(places, &numbers, places[i].found.kind, number) {
            numbers[i] = Some(number);
        }
    }
    for (i, place) in places.iter().enumerate() {
        // 0 is the main land's.
        let free = || {
            (SQUARES.number(place.found.at).max(1)..)
                .find(|&number| !is_taken(places, &numbers, place.found.kind, number))
        };
        numbers[i] = numbers[i].or_else(free);
    }
    numbers.into_iter().map(Option::unwrap_or_default).collect()
}

/// Returns `true` if a place has the mark of a kind and number.
fn is_taken(places: &[Place], numbers: &[Option<u32>], kind: PlaceKind, number: u32) -> bool {
    let wanted = mark(kind, number);
    places.iter().zip(numbers).any(|(place, of)| of.is_some_and(|of| mark(place.found.kind, of) == wanted))
}

/// Returns the number in a mark, if it is one for places of a kind.
fn number_of(own: Mark, kind: PlaceKind) -> Option<u32> {
    let number = match own {
        Mark::Sea(number)
        | Mark::Lake(number)
        | Mark::Island(number)
        | Mark::Bay(number)
        | Mark::Cape(number)
        | Mark::Strait(number)
        | Mark::Range(number) => number,
        _ => return None,
    };
    (mark(kind, number) == own).then_some(number)
}

#[cfg(test)]
mod tests {
    use glam::Vec2;

    use super::super::regions::Found;
    use super::*;
    use crate::land::Region;

    fn place(kind: PlaceKind, x: f32, y: f32, size: f32) -> Place {
        let found = Found { kind, at: Vec2::new(x, y), line: vec![], size };
        Place { found, region: Region::default(), rank: 0, extent: size }
    }

    #[test]
    fn a_mark_is_taken_by_the_nearest_place_of_its_kind_that_is_near_enough() {
        let own = OwnNames::readable("b50050.a_b1.b_c50050.c_s50050.d");
        let places = [
            place(PlaceKind::Bay, 420.0, 404.0, 30.0),
            place(PlaceKind::Gulf, 404.0, 410.0, 200.0),
            place(PlaceKind::Cape, 520.0, 404.0, 60.0),
            place(PlaceKind::Sea, 604.0, 404.0, 400.0),
            place(PlaceKind::Island, 604.0, 404.0, 400.0),
        ];
        let numbers = numbers(&places, &own);
        assert_eq!(numbers, [50_052, 50_050, 50_065, 50_050, 0]);
    }

    #[test]
    fn places_in_one_cell_have_numbers_of_their_own_and_no_number_panics() {
        let places = [place(PlaceKind::Bay, 1.0, 1.0, 9.0), place(PlaceKind::Gulf, 2.0, 2.0, 9.0)];
        assert_eq!(numbers(&places, &OwnNames::readable("b4294967295.x_b0.y")), [1, 2]);
    }
}
