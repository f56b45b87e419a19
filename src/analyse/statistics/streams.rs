//! Streams by Strahler's order, and the laws that their numbers and lengths follow (Horton 1945, Tokunaga 1978).
//!
//! A stream of an order begins at a source, or where two of the order below meet. It ends where it joins one of a
//! higher order, or at the sea. Streams are read from the trimmed tree, along its own steps, in one pass: smoothing and
//! meanders add about the same share to all orders. All basins of a map are counted together.

use super::fit;
use crate::base::geometry::distance;
use crate::tree::{NO_PARENT, Tree};

/// The streams of a tree, counted by order.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Streams {
    /// Number of streams of each order, starting with order 1.
    pub counts: Vec<u32>,
    /// Total length of the streams of each order, in units.
    pub lengths: Vec<f64>,
    /// Number of streams of one order that flow into streams of another: `joins[own - 1][other - 1]`.
    pub joins: Vec<Vec<u32>>,
}

/// The fewest orders for a fit. Two points are always on a line, so a line through fewer orders says nothing.
const LEAST_ORDERS: usize = 3;

impl Streams {
    /// Counts the streams of a tree whose nodes have these orders. A mouth from which nothing grew is not a stream.
    pub fn of(tree: &Tree, order: &[u8]) -> Self {
        let highest = order.iter().copied().max().unwrap_or(0) as usize;
        let mut this =
            Self { counts: vec![0; highest], lengths: vec![0.0; highest], joins: vec![vec![0; highest]; highest] };
        let mut has_grown = vec![false; tree.len()];
        for node in (0..tree.len()).rev() {
            let own = order[node] as usize - 1;
            let Some(parent) = tree.parent_of(node) else {
                this.counts[own] += u32::from(has_grown[node]);
                continue;
            };
            has_grown[parent] = true;
            this.lengths[own] += f64::from(distance(tree.at[node], tree.at[parent]));
            if order[parent] != order[node] {
                this.counts[own] += 1;
                this.joins[own][order[parent] as usize - 1] += 1;
            }
        }
        this
    }

    /// Returns Horton's bifurcation ratio R_B: the factor by which the number of streams falls from each order to the next.
    /// It is fitted by least squares to the logarithms of the numbers over the orders. A single stream of the highest
    /// order is left out. `None` for fewer than three orders.
    pub fn bifurcation_ratio(&self) -> Option<f64> {
        let counts: Vec<f64> = self.counts[..self.fitted()?].iter().map(|&count| count.into()).collect();
        fit::ratio(&counts).map(|ratio| 1.0 / ratio)
    }

    /// Returns Horton's length ratio R_L: the factor by which the mean length of streams rises from each order to the
    /// next, fitted in the same way.
    pub fn length_ratio(&self) -> Option<f64> {
        let orders = self.lengths.iter().zip(&self.counts);
        let means: Vec<f64> = orders.map(|(length, &count)| length / f64::from(count)).collect();
        fit::ratio(&means[..self.fitted()?])
    }

    /// Returns the number of orders used in a fit; `None` if there are too few.
    fn fitted(&self) -> Option<usize> {
        let orders = self.counts.len() - usize::from(self.counts.last() == Some(&1));
        (orders >= LEAST_ORDERS).then_some(orders)
    }

    /// Returns Tokunaga's T_k: the mean number of side branches of order w − k in a stream of order w, over all streams
    /// of orders above k. `None` if there are no such streams.
    pub fn side_branches(&self, k: usize) -> Option<f64> {
        let orders = k..self.counts.len();
        let branches: u32 = orders.clone().map(|own| self.branches(own - k, own)).sum();
        let streams: u32 = orders.map(|own| self.counts[own]).sum();
        (streams > 0).then(|| f64::from(branches) / f64::from(streams))
    }

    /// Counts the side branches of one order in all streams of a higher one. The two branches of the order below that
    /// form a stream do not count.
    fn branches(&self, order: usize, own: usize) -> u32 {
        let forming = if order + 1 == own { 2 * self.counts[own] } else { 0 };
        self.joins[order][own] - forming
    }

    /// Returns Tokunaga's c: the factor by which the number of side branches grows with each lower order, T_k =
    /// a c^(k−1). It is fitted by least squares to the logarithms of T_1, T_2 and T_3 (Peckham 1995). `None` for fewer
    /// than four orders, and if one of the three is 0.
    pub fn tokunaga_c(&self) -> Option<f64> {
        let numbers: Option<Vec<f64>> = (1..=3).map(|k| self.side_branches(k)).collect();
        fit::ratio(&numbers?)
    }
}

/// Returns Hack's exponent h in L ∝ A^h (Hack 1957), where L is the length of the longest river in a basin of area A.
/// It is fitted by least squares to their logarithms. There is a basin for each stream of order 2 and higher, above the
/// stream's lower end. `None` for fewer than ten basins.
pub fn hack_exponent(tree: &Tree, order: &[u8], area: &[u32]) -> Option<f64> {
    const LEAST_BASINS: usize = 10;
    let above = longest_above(tree);
    let basin = |node: usize| {
        let below = tree.parent_of(node);
        let ends = order[node] >= 2 && below.is_none_or(|below| order[below] != order[node]);
        let last = below.map_or(0.0, |below| distance(tree.at[node], tree.at[below]));
        let length = f64::from(above[node] + last);
        (ends && area[node] > 0 && length > 0.0).then(|| (fit::log(area[node].into()), fit::log(length)))
    };
    let basins: Vec<(f64, f64)> = (0..tree.len()).filter_map(basin).collect();
    if basins.len() < LEAST_BASINS { None } else { fit::slope(&basins) }
}

/// Returns the length of the longest river above each node, in units.
fn longest_above(tree: &Tree) -> Vec<f32> {
    let mut longest = vec![0.0f32; tree.len()];
    for node in (0..tree.len()).rev().filter(|&node| tree.parent[node] != NO_PARENT) {
        let parent = tree.parent[node] as usize;
        longest[parent] = longest[parent].max(longest[node] + distance(tree.at[node], tree.at[parent]));
    }
    longest
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tree::Hydrology;
    use glam::Vec2;

    /// Makes a tree of a mouth without a river.
    fn mouth() -> Tree {
        Tree { at: vec![Vec2::ZERO], parent: vec![NO_PARENT], drained: vec![1], ..Tree::default() }
    }

    /// Adds a node upstream of another, at this distance to the east.
    fn add(tree: &mut Tree, parent: usize, length: f32) -> usize {
        tree.at.push(tree.at[parent] + Vec2::new(length, 0.0));
        tree.parent.push(parent as u32);
        tree.drained.push(1);
        tree.len() - 1
    }

    /// Adds a stream of an order with everything that flows into it: `branches` side branches of each lower order, as a
    /// function of the difference, and two streams of the order below at its head. A stream of order w is length(w)
    /// long.
    fn add_stream(tree: &mut Tree, below: usize, order: u32, length: fn(u32) -> f32, branches: fn(u32) -> u32) {
        let sides: Vec<u32> = (1..order).flat_map(|k| (0..branches(k)).map(move |_| order - k)).collect();
        let link = length(order) / (sides.len() + 1) as f32;
        let mut node = below;
        for side in sides {
            node = add(tree, node, link);
            add_stream(tree, node, side, length, branches);
        }
        node = add(tree, node, link);
        for _ in 0..if order > 1 { 2 } else { 0 } {
            add_stream(tree, node, order - 1, length, branches);
        }
    }

    fn of_order(order: u32, length: fn(u32) -> f32, branches: fn(u32) -> u32) -> Tree {
        let mut tree = mouth();
        add_stream(&mut tree, 0, order, length, branches);
        tree
    }

    fn streams(tree: &Tree) -> Streams {
        Streams::of(tree, &Hydrology::of(tree).order)
    }

    fn is_near(value: Option<f64>, expected: f64) -> bool {
        value.is_some_and(|value| (value - expected).abs() < 1e-5)
    }

    /// ```text
    ///  1   1     1   1       Each link is one unit long.
    ///   \ /       \ /
    ///    2         2         Order 1: four springs, a side branch of the left stream of order 2,
    /// 1──2         2         and a side branch of the stream of order 3.
    ///     \       /          Order 2: two links on the left, with the side branch between them, and two on the right.
    ///      `──3──´           Order 3: two links, to its side branch and to the sea.
    ///      1──3
    ///         ~
    /// ```
    #[test]
    fn streams_are_counted_by_order_and_by_what_they_join() {
        let mut tree = mouth();
        let low = add(&mut tree, 0, 1.0);
        add(&mut tree, low, 1.0);
        let high = add(&mut tree, low, 1.0);
        for is_left in [true, false] {
            let middle = add(&mut tree, high, 1.0);
            if is_left {
                add(&mut tree, middle, 1.0);
            }
            let head = add(&mut tree, middle, 1.0);
            add(&mut tree, head, 1.0);
            add(&mut tree, head, 1.0);
        }
        let streams = streams(&tree);
        assert_eq!(streams.counts, [6, 2, 1]);
        assert_eq!(streams.lengths, [6.0, 4.0, 2.0]);
        assert_eq!(streams.joins, [[0, 5, 1], [0, 0, 2], [0, 0, 0]]);
        // Three streams have one side branch of the order below in all; one stream has one of two orders below.
        assert!(is_near(streams.side_branches(1), 1.0 / 3.0) && is_near(streams.side_branches(2), 1.0));
        assert_eq!(streams.side_branches(3), None);
        // Without the single stream of the highest order, two orders are left: too few for a line.
        assert_eq!((streams.bifurcation_ratio(), streams.length_ratio(), streams.tokunaga_c()), (None, None, None));
    }

    #[test]
    fn a_third_arm_is_a_side_branch_and_a_lone_mouth_no_stream() {
        let mut tree = mouth();
        let head = add(&mut tree, 0, 1.0);
        for _ in 0..3 {
            add(&mut tree, head, 1.0);
        }
        assert_eq!(streams(&tree).side_branches(1), Some(1.0));
        assert_eq!(streams(&mouth()).counts, [0]);
        assert_eq!(streams(&Tree::default()).bifurcation_ratio(), None);
    }

    /// Measures a tree without side branches: 16, 8, 4 and 2 streams of orders 1 to 4, and one of order 5, which is
    /// left out. Each is three times as long as those of the order below.
    #[test]
    fn ratios_are_those_of_a_forked_tree() {
        let streams = streams(&of_order(5, |order| 3u32.pow(order) as f32, |_| 0));
        assert_eq!(streams.counts, [16, 8, 4, 2, 1]);
        assert!(is_near(streams.bifurcation_ratio(), 2.0) && is_near(streams.length_ratio(), 3.0), "{streams:?}");
        assert_eq!(streams.tokunaga_c(), None);
    }

    /// Measures a tree each of whose streams has one side branch of the order below, then two, four and eight of the
    /// lower ones: a = 1, c = 2. In the long run there are then 4 times as many streams of an order as of the next; the
    /// line through 683, 171, 43, 11 and 3 gives e^1.35996.
    #[test]
    fn side_branches_are_those_of_a_self_similar_tree() {
        let streams = streams(&of_order(6, |_| 1.0, |k| 1 << (k - 1)));
        assert_eq!(streams.counts, [683, 171, 43, 11, 3, 1]);
        assert!(is_near(streams.side_branches(1), 1.0) && is_near(streams.side_branches(3), 4.0));
        assert!(is_near(streams.tokunaga_c(), 2.0));
        assert!((streams.bifurcation_ratio().unwrap() - libm::exp(1.35996)).abs() < 1e-4);
    }

    /// The longest river of a basin of order w is 2 + 2 + 4 + … = 2^w long. If its area is 4^w, h is a half; if it is
    /// 2^w, h is one.
    #[test]
    fn hack_s_exponent_is_that_of_a_tree_whose_basins_grow_alike() {
        let length = |order: u32| if order == 1 { 2.0 } else { (1 << (order - 1)) as f32 };
        let tree = of_order(6, length, |_| 0);
        let order = Hydrology::of(&tree).order;
        let area = |base: u32| order.iter().map(|&order| base.pow(order.into())).collect::<Vec<_>>();
        assert!(is_near(hack_exponent(&tree, &order, &area(4)), 0.5));
        assert!(is_near(hack_exponent(&tree, &order, &area(2)), 1.0));
        let small = of_order(3, length, |_| 0);
        let order = Hydrology::of(&small).order;
        assert_eq!(hack_exponent(&small, &order, &vec![1; small.len()]), None, "three basins");
    }
}
