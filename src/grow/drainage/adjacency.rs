//! Adjacency: the places that are neighbours of one another, by a Delaunay triangulation.
//!
//! The triangulation is that of the places as they lie, however much the plane was bent: no two of its edges cross, no
//! place is without one, and none is long where there are others nearby.

use std::ops::Range;

use delaunator::{EMPTY, Point, next_halfedge, triangulate};
use glam::Vec2;

use crate::base::work;

/// Neighbours of all places, those of one place side by side. Neighbours are mutual.
#[derive(Clone, Debug, Default)]
pub(super) struct Adjacency {
    /// The start of each place's neighbours, and the end of the last's.
    first: Vec<u32>,
    /// The neighbours.
    pub to: Vec<u32>,
}

impl Adjacency {
    /// Triangulates places.
    pub fn of_places(places: &[Vec2]) -> Self {
        work::count(16 * places.len());
        let points: Vec<Point> = places.iter().map(|at| Point { x: at.x.into(), y: at.y.into() }).collect();
        let triangulation = triangulate(&points);
        let (corners, opposite) = (&triangulation.triangles, &triangulation.halfedges);
        // An edge between two triangles is a halfedge of both; one of the hull belongs to one triangle only.
        let halfedges = (0..corners.len()).flat_map(|halfedge| {
            let (from, to) = (corners[halfedge] as u32, corners[next_halfedge(halfedge)] as u32);
            [Some((from, to)), (opposite[halfedge] == EMPTY).then_some((to, from))].into_iter().flatten()
        });
        Self::of_edges(places.len(), halfedges)
    }

    /// Sorts directed edges by the place that they begin at.
    pub fn of_edges(places: usize, edges: impl Iterator<Item = (u32, u32)> + Clone) -> Self {
        let mut first = vec![0; places + 1];
        edges.clone().for_each(|(from, _)| first[from as usize + 1] += 1);
        for place in 0..places {
            first[place + 1] += first[place];
        }
        let mut to = vec![0; first[places] as usize];
        let mut next = first.clone();
        for (from, there) in edges {
            to[next[from as usize] as usize] = there;
            next[from as usize] += 1;
        }
        Self { first, to }
    }

    /// Returns the range of a place's neighbours within [`to`](Self::to).
    #[inline]
    pub fn range(&self, place: usize) -> Range<usize> {
        self.first[place] as usize..self.first[place + 1] as usize
    }

    /// Returns the neighbours of a place.
    #[inline]
    pub fn of(&self, place: usize) -> &[u32] {
        &self.to[self.range(place)]
    }
}
