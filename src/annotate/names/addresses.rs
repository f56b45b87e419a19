//! The identities of rivers, by which names know them: the numbers of squares through which they run.
//!
//! A river's square is the one with the least hash of all along its lower course in the untrimmed tree (after Broder 1997: two sets
//! have the same least hash as often as their members are the same). While most of the course stays where it is, so does the number,
//! however its ends move: neither a mouth on a coast that moves nor a source that another brook takes over renames a river.

use std::collections::BTreeSet;

use super::heads::Heads;
use super::squares::Squares;
use crate::base::random::ItemHash;
use crate::base::sort;
use crate::recipe::{Mark, OwnNames};

/// Squares as large as a parcel with few others.
const SQUARES: Squares = Squares(2.0);

/// The greatest distance of a river from the square of an own name that no river has, in units.
const REACH: f32 = 6.0;

/// The item of the chances of squares.
const SQUARE: u32 = 1 << 18;

/// Numbers the nodes of an untrimmed tree. Rivers have the number of a square each, the greatest river choosing first; all other nodes, and
/// rivers that find none, one beyond all squares.
pub(super) fn of(heads: &Heads, rivers: &[usize], chance: ItemHash) -> Vec<u32> {
    let beyond = |node: usize| Squares::COUNT.wrapping_add(heads.identity(node));
    let mut numbers: Vec<u32> = (0..heads.len()).map(beyond).collect();
    let mut taken = BTreeSet::new();
    for &river in rivers {
        let squares = heads.lower_course(river).map(|at| SQUARES.number(at));
        let free = squares.filter(|square| !taken.contains(square));
        if let Some(square) = free.min_by_key(|&square| (chance.bits([square, 0, SQUARE]), square)) {
            taken.insert(square);
            numbers[river] = square;
        }
    }
    numbers
}

/// Gives rivers on the map the numbers of own names that no river has: each to the river that is nearest to its square, and near enough. A
/// river's course may have changed so much that its own number is another. `on_map` are the lowest nodes of the rivers on the map.
pub(super) fn follow(own: &OwnNames, heads: &Heads, on_map: &[usize], numbers: &mut [u32]) {
    let marks = own.marks().filter_map(|mark| match mark {
        Mark::River(number) | Mark::Reach(number) => Some(number),
        _ => None,
    });
    let marks: Vec<u32> = marks.collect();
    let mut lost: Vec<u32> = marks.iter().copied().filter(|number| !numbers.contains(number)).collect();
    lost.dedup();
    let mut pairs = Vec::new();
    for number in lost {
        let middle = SQUARES.middle(number);
        let away = |node: usize| heads.course(node).map(|at| at.distance(middle)).fold(f32::INFINITY, f32::min);
        let unnamed = on_map.iter().copied().filter(|&node| !marks.contains(&numbers[node]));
        pairs.extend(unnamed.map(|node| (away(node), node, number)).filter(|(away, ..)| *away <= REACH));
    }
    // The nearest first.
    for next in sort::argsort(pairs.iter().map(|(away, ..)| sort::key(*away))) {
        let (_, node, number) = pairs[next];
        if !marks.contains(&numbers[node]) && !numbers.contains(&number) {
            numbers[node] = number;
        }
    }
}

#[cfg(test)]
mod tests {
    use glam::Vec2;

    use super::*;
    use crate::base::random::{Purpose, Seed};
    use crate::tree::{NO_PARENT, Tree};

    /// Makes the tree of a river along a line, from its mouth on.
    fn river(line: &[Vec2]) -> Tree {
        let parents = (0..line.len() as u32).map(|node| node.checked_sub(1).unwrap_or(NO_PARENT));
        Tree { at: line.to_vec(), parent: parents.collect(), drained: vec![1; line.len()], ..Tree::default() }
    }

    fn number(tree: &Tree) -> u32 {
        let heads = Heads::of(tree);
        of(&heads, &heads.rivers(), Seed::from_text("kauri").item_hash(Purpose::Names))[0]
    }

    fn line(range: std::ops::Range<u32>) -> Vec<Vec2> {
        range.map(|i| Vec2::new(100.0, 100.0 + 4.0 * i as f32)).collect()
    }

    #[test]
    fn a_river_keeps_its_number_when_its_mouth_and_its_source_move() {
        let numbers: Vec<u32> = (0..20).map(|moved| number(&river(&line(moved..moved + 60)))).collect();
        let kept = numbers.windows(2).filter(|pair| pair[0] == pair[1]).count();
        assert!(kept >= 16, "{numbers:?}");
        let [column, row] = SQUARES.cell(SQUARES.middle(numbers[0]));
        assert!(column == 50 && (52..=142).contains(&row), "{column} {row}");
    }

    #[test]
    fn a_mark_that_no_river_has_goes_to_the_river_beside_its_square() {
        let tree = river(&line(0..40));
        let heads = Heads::of(&tree);
        let plain = of(&heads, &heads.rivers(), Seed::from_text("kauri").item_hash(Purpose::Names));
        let after = |own: &str| {
            let mut numbers = plain.clone();
            follow(&OwnNames::readable(own), &heads, &[0], &mut numbers);
            numbers[0]
        };
        let near = SQUARES.number(Vec2::new(104.0, 150.0));
        assert_ne!(near, plain[0]);
        assert_eq!((after(&format!("{near}.A")), after(&format!("m{near}.A"))), (near, near));
        assert_eq!(after(&format!("{}.A", SQUARES.number(Vec2::new(110.0, 150.0)))), plain[0]);
        assert_eq!(after(&format!("{near}.A_{}.B", plain[0])), plain[0], "a river with a name of its own keeps it");
        assert_eq!(after("4294967295.A"), plain[0]);
    }
}
