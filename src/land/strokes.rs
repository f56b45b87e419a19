//! Turns lines with many points, drawn or traced, into an outline that fits into a link.

use glam::Vec2;
use thiserror::Error;

use super::queries::LEAST_DRAWN;
use crate::base::simplify::significance;
use crate::base::sort;
use crate::domain::AREA;
use crate::recipe::{GridPoint, LONGEST_OUTLINE, LineKind, Outline, OutlineError};

/// The area of a point's triangle up to which it is left out, in square units: the width of a drawn coast hides it.
const LEAST_AREA: f32 = 8.0;
/// The area of a line's bounding box below which it is left out, in square units.
const SPECK: f32 = 120.0;

/// The reason why a drawing is not a land.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum DrawError {
    /// Ridges without a coast.
    #[error("there is no coast yet: a ridge needs land to stand on")]
    NoCoast,
    /// Less land than rivers need.
    #[error("the land is too small: it should fill at least a hundredth of the map")]
    TooSmall,
    /// No water remains.
    #[error("the land fills the whole map: rivers need water to run to")]
    NoWater,
    /// A coordinate that is not a number.
    #[error("a line holds something that is not a number")]
    NotANumber,
    /// Lines that an outline cannot hold.
    #[error(transparent)]
    Outline(#[from] OutlineError),
}

impl Outline {
    /// Makes an outline from lines with any number of points, in fractions of the domain's width and height. Points
    /// outside are moved to the border. To fit the [limit](LONGEST_OUTLINE) of the text, the least important points are
    /// removed, as are specks and the smallest of too many lines.
    ///
    /// # Errors
    /// Fails if hardly any land remains, or no water. Rivers alone run on the whole domain.
    pub fn from_polylines(
        coasts: Vec<Vec<Vec2>>,
        ridges: Vec<Vec<Vec2>>,
        rivers: Vec<Vec<Vec2>>,
    ) -> Result<Self, DrawError> {
        use LineKind::{Coast, Ridge, River};
        let mut given = [(Coast, coasts), (Ridge, ridges), (River, rivers)];
        if !given.iter().flat_map(|(_, lines)| lines).flatten().all(|point| point.is_finite()) {
            return Err(DrawError::NotANumber);
        }
        let [has_coasts, has_ridges, has_rivers] = [0, 1, 2].map(|kind| !given[kind].1.is_empty());
        let lines =
            given.iter_mut().flat_map(|(kind, lines)| lines.drain(..).filter_map(|points| Line::new(*kind, points)));
        let mut all: Vec<Line> = lines.collect();
        keep_largest(&mut all);
        let least = least_area(&all);
        let of_kind = |kind| all.iter().filter(|line| line.kind == kind).map(|line| line.simplified(least)).collect();
        let [coasts, ridges, rivers]: [Vec<_>; 3] = [Coast, Ridge, River].map(of_kind);
        if has_rivers && !has_coasts && !has_ridges {
            return Ok(Self::new(coasts, ridges, rivers)?);
        }
        if coasts.is_empty() {
            return Err(if ridges.is_empty() { DrawError::TooSmall } else { DrawError::NoCoast });
        }
        check_land(&coasts)?;
        Ok(Self::new(coasts, ridges, rivers)?)
    }
}

/// A line with the importance of each point.
struct Line {
    kind: LineKind,
    points: Vec<Vec2>,
    /// The area of each point's triangle, in square units.
    areas: Vec<f32>,
    /// The area of the bounding box, in square units.
    size: f32,
}

impl Line {
    /// Measures the importance of a line's points; `None` if the line is a speck.
    fn new(kind: LineKind, points: Vec<Vec2>) -> Option<Self> {
        let mut points: Vec<Vec2> = points.into_iter().map(|point| point.clamp(Vec2::ZERO, Vec2::ONE)).collect();
        points.dedup();
        let low = points.iter().copied().reduce(Vec2::min)?;
        let high = points.iter().copied().reduce(Vec2::max)?;
        // A straight ridge has a bounding box without area.
        let sides = match kind {
            LineKind::Coast => high - low,
            LineKind::Ridge | LineKind::River => Vec2::splat((high - low).max_element()),
        };
        let mut size = sides.element_product() * AREA;
        if kind == LineKind::River && size < SPECK {
            // Such a river is a mouth without a noticeable course.
            points.truncate(1);
            size = SPECK;
        }
        let areas = significance(&points, kind == LineKind::Coast).into_iter().map(|area| area * AREA).collect();
        (points.len() >= kind.fewest() && size >= SPECK).then_some(Self { kind, points, areas, size })
    }

    /// Returns the points whose triangles have more than the least area.
    fn simplified(&self, least: f32) -> Vec<GridPoint> {
        let kept = self.points.iter().zip(&self.areas).filter(|(_, area)| **area > least);
        kept.map(|(point, _)| GridPoint::nearest(*point)).collect()
    }
}

/// Keeps the largest lines in their order, few enough that there is room for their shapes too.
fn keep_largest(lines: &mut Vec<Line>) {
    let order = sort::argsort(lines.iter().map(|line| !line.size.to_bits()));
    let mut length = 0;
    let mut is_kept = vec![false; lines.len()];
    for i in order {
        length += lines[i].kind.length_of(2 * lines[i].kind.fewest());
        is_kept[i] = length <= LONGEST_OUTLINE;
    }
    let mut is_kept = is_kept.into_iter();
    lines.retain(|_| is_kept.next().unwrap_or(false));
}

/// Returns the area of their triangles above which points are kept, so that all of these fit.
fn least_area(lines: &[Line]) -> f32 {
    let fewest: usize = lines.iter().map(|line| line.kind.length_of(line.kind.fewest())).sum();
    let room = LONGEST_OUTLINE.saturating_sub(fewest) / 4;
    let areas: Vec<f32> = lines.iter().flat_map(|line| &line.areas).copied().filter(|a| a.is_finite()).collect();
    let above = areas.len().saturating_sub(room + 1);
    if areas.len() > room { sort::sorted(&areas)[above].max(LEAST_AREA) } else { LEAST_AREA }
}

/// Checks on some rows across the domain that there are both land and water.
fn check_land(coasts: &[Vec<GridPoint>]) -> Result<(), DrawError> {
    const ROWS: u32 = 128;
    let rows = (0..ROWS).map(|row| (row as f32 + 0.5) / ROWS as f32);
    let share = rows.map(|y| land_on_row(coasts, y)).sum::<f32>() / ROWS as f32;
    if share < LEAST_DRAWN * 1.2 {
        return Err(DrawError::TooSmall);
    }
    if share > 0.998 { Err(DrawError::NoWater) } else { Ok(()) }
}

/// Returns the share of a row that lies within an odd number of coasts.
fn land_on_row(coasts: &[Vec<GridPoint>], y: f32) -> f32 {
    let fractions = |ring: &[GridPoint]| ring.iter().map(|point| point.fraction()).collect::<Vec<_>>();
    let mut crossings = Vec::new();
    for ring in coasts.iter().map(|ring| fractions(ring)) {
        let edges = ring.iter().zip(ring.iter().cycle().skip(1));
        let crossing = edges.filter(|(a, b)| (a.y > y) != (b.y > y));
        crossings.extend(crossing.map(|(a, b)| a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y)));
    }
    sort::sorted(&crossings).chunks_exact(2).map(|pair| pair[1] - pair[0]).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::property::cases;
    use proptest::prelude::*;

    fn circle(centre: Vec2, radius: f32, points: u32) -> Vec<Vec2> {
        let angle = |i: u32| std::f32::consts::TAU * i as f32 / points as f32;
        (0..points).map(|i| centre + Vec2::new(libm::cosf(angle(i)), libm::sinf(angle(i))) * radius).collect()
    }

    fn refusal(coasts: Vec<Vec<Vec2>>, ridges: Vec<Vec<Vec2>>) -> DrawError {
        Outline::from_polylines(coasts, ridges, vec![]).unwrap_err()
    }

    #[test]
    fn a_circle_keeps_its_area_and_costs_no_more_than_it_needs() {
        let outline = Outline::from_polylines(vec![circle(Vec2::splat(0.5), 0.3, 2000)], vec![], vec![]).unwrap();
        let area: f32 = (0..500).map(|i| land_on_row(outline.coasts(), (i as f32 + 0.5) / 500.0) / 500.0).sum();
        assert!((area / (std::f32::consts::PI * 0.09) - 1.0).abs() < 0.01, "{area}");
        assert!((40..200).contains(&outline.coasts()[0].len()), "{}", outline.coasts()[0].len());
    }

    #[test]
    fn what_is_no_land_is_said() {
        let ridge = vec![Vec2::splat(0.2), Vec2::splat(0.8)];
        let corners = vec![Vec2::new(-1.0, -1.0), Vec2::new(2.0, -1.0), Vec2::new(2.0, 2.0), Vec2::new(-1.0, 2.0)];
        assert_eq!(refusal(vec![], vec![]), DrawError::TooSmall);
        assert_eq!(refusal(vec![], vec![ridge]), DrawError::NoCoast);
        assert_eq!(refusal(vec![circle(Vec2::splat(0.5), 0.03, 50)], vec![]), DrawError::TooSmall);
        assert_eq!(refusal(vec![corners], vec![]), DrawError::NoWater);
        assert_eq!(refusal(vec![vec![Vec2::splat(f32::NAN); 9]], vec![]), DrawError::NotANumber);
        let there_and_back = (0..200).map(|i| Vec2::splat(0.1 + 0.8 * (i.min(200 - i) as f32 / 100.0))).collect();
        assert_eq!(refusal(vec![there_and_back], vec![]), DrawError::TooSmall);
    }

    #[test]
    fn the_largest_of_too_many_lines_stay() {
        let islands = (0..100).map(|i| {
            let centre = Vec2::new((i % 10) as f32, (i / 10) as f32) / 10.0 + 0.05;
            circle(centre, 0.02 + 0.0002 * i as f32, 30)
        });
        let outline = Outline::from_polylines(islands.collect(), vec![], vec![]).unwrap();
        assert!((30..80).contains(&outline.coasts().len()), "{}", outline.coasts().len());
        assert!(outline.coasts().iter().flatten().all(|point| point.fraction().y > 0.4));
    }

    #[test]
    fn a_river_too_short_for_a_course_is_its_mouth() {
        let river = |length: f32| vec![Vec2::new(0.2, 0.5), Vec2::new(0.2 + length, 0.5)];
        let rivers = vec![river(0.0), river(0.009), river(0.2)];
        let outline = Outline::from_polylines(vec![], vec![], rivers.clone()).unwrap();
        assert_eq!(outline.rivers().iter().map(Vec::len).collect::<Vec<_>>(), [1, 1, 2]);
        assert_eq!(outline.rivers()[1][0], GridPoint::nearest(river(0.0)[0]));
        // A coast that is drawn must give land, and a ridge needs a coast.
        let speck = circle(Vec2::splat(0.5), 0.003, 50);
        assert_eq!(Outline::from_polylines(vec![speck], vec![], rivers.clone()), Err(DrawError::TooSmall));
        assert_eq!(Outline::from_polylines(vec![], vec![river(0.5)], rivers), Err(DrawError::NoCoast));
    }

    proptest! {
        #![proptest_config(cases(256))]

        #[test]
        fn any_lines_fit_or_are_refused(
            coasts in proptest::collection::vec(proptest::collection::vec((-200i16..1200, -200i16..1200), 0..400), 0..5),
            ridges in proptest::collection::vec(proptest::collection::vec((-200i16..1200, -200i16..1200), 0..100), 0..4),
            rivers in proptest::collection::vec(proptest::collection::vec((-200i16..1200, -200i16..1200), 0..100), 0..4),
        ) {
            let thousandths = |(x, y): (i16, i16)| Vec2::new(f32::from(x), f32::from(y)) / 1000.0;
            let lines = |lines: Vec<Vec<(i16, i16)>>| -> Vec<Vec<Vec2>> {
                lines.into_iter().map(|line| line.into_iter().map(thousandths).collect()).collect()
            };
            if let Ok(outline) = Outline::from_polylines(lines(coasts), lines(ridges), lines(rivers)) {
                let text = outline.to_string();
                prop_assert!(text.len() <= LONGEST_OUTLINE);
                prop_assert_eq!(Outline::parse(&text), Ok(outline));
            }
        }
    }
}
