//! Streams that captured one another while drainage settled: the former ways of the greatest of them.

use glam::Vec2;

use crate::base::sort::argsort;
use crate::grow::Capture;
use crate::session::Session;
use crate::tree::{Hydrology, NO_PARENT};

/// The most ways that readers of a map can tell apart.
const MOST: usize = 40;

/// Traces the former ways of captured streams. Each line begins where the stream was turned aside, goes to the parcel
/// that it drained to before, and follows the present drainage from there to the next stream. Streams that drain the
/// most come first. Parcels that drained directly to the sea before have none. Only drainage has captures.
pub fn former_ways(session: &Session) -> Vec<Vec<Vec2>> {
    let (growth, tree) = (session.growth(), session.tree());
    let (places, nodes) = (growth.scattered(), growth.nodes_of_parcels());
    let (discharge, trim) = (Hydrology::of(tree).discharge, session.trim());
    let channels = trim.heads.channels(tree, &discharge, trim.seed);
    let node = |parcel: u32| nodes[parcel as usize] as usize;
    let is_stream = |node: usize| channels[node];
    let mut captures = last_of_each_parcel(growth.captures(), places.len());
    // Parcels that the sea has risen over have no node any more.
    let has_node = |parcel: u32| node(parcel) < tree.len();
    captures.retain(|&Capture { parcel, from, .. }| {
        from != NO_PARENT && has_node(parcel) && has_node(from) && is_stream(node(parcel))
    });
    let by_discharge = argsort(captures.iter().map(|capture| u32::MAX - discharge[node(capture.parcel)]));
    let former_way = |i: usize| {
        let Capture { parcel, from, .. } = captures[i];
        let mut way = vec![places[parcel as usize]];
        let mut next = Some(node(from));
        while let Some(here) = next {
            way.push(tree.at[here]);
            next = tree.parent_of(here).filter(|_| !is_stream(here));
        }
        way
    };
    by_discharge.into_iter().take(MOST).map(former_way).collect()
}

/// Returns the last capture of each parcel, in the order of parcels, without those that were never captured.
fn last_of_each_parcel(captures: &[Capture], parcels: usize) -> Vec<Capture> {
    let mut last = vec![None; parcels];
    for &capture in captures {
        last[capture.parcel as usize] = Some(capture);
    }
    last.into_iter().flatten().collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::recipe::link;

    fn finished(link: &str) -> Session {
        let mut session = Session::new(link::read(link).unwrap()).unwrap();
        session.finish().unwrap();
        session
    }

    #[test]
    fn former_ways_lead_from_streams_over_another_parcel_to_the_next_stream() {
        // On some of these, streams were captured twice: their way before the last capture counts.
        let mut twice = 0;
        for seed in 0..12 {
            let link = format!("country=usual&seed={seed}&attractors=1680&sea=0.55&growth=drainage&head-variation=0");
            let session = finished(&link);
            twice += u32::from(former_ways(&session).iter().any(|way| is_captured_twice(&session, way[0])));
            check(&session);
        }
        assert!((1..12).contains(&twice), "{twice} maps with streams that were captured twice");
    }

    /// Returns `true` if the parcel at a place was captured twice, from two others.
    fn is_captured_twice(session: &Session, at: Vec2) -> bool {
        let growth = session.growth();
        let is_of = |capture: &&Capture| growth.scattered()[capture.parcel as usize] == at;
        let mut captures = growth.captures().iter().filter(is_of);
        let first = captures.next().unwrap();
        captures.any(|capture| capture.from != first.from)
    }

    fn check(session: &Session) {
        let (growth, tree) = (session.growth(), session.tree());
        let ways = former_ways(session);
        assert!((4..=MOST).contains(&ways.len()), "{}", ways.len());
        let discharge = Hydrology::of(tree).discharge;
        let node = |at: Vec2| tree.at.iter().rposition(|&place| place == at).unwrap();
        let parcel = |at: Vec2| growth.scattered().iter().position(|&place| place == at).unwrap() as u32;
        let mut last = u32::MAX;
        for way in &ways {
            let (source, before) = (node(way[0]), node(way[1]));
            assert!(discharge[source] >= session.trim().heads.channel_area && discharge[source] <= last);
            last = discharge[source];
            assert_ne!(tree.parent_of(source), Some(before), "it drains another way now");
            let capture = growth.captures().iter().rfind(|capture| capture.parcel == parcel(way[0])).unwrap();
            assert_eq!(capture.from, parcel(way[1]));
            let mut end = before;
            for &place in &way[2..] {
                end = tree.parent_of(end).unwrap();
                assert_eq!(tree.at[end], place);
            }
            assert!(discharge[end] >= session.trim().heads.channel_area || tree.parent_of(end).is_none());
        }
    }

    #[test]
    fn without_captures_there_are_no_former_ways() {
        for more in ["growth=drainage&captures=0", "growth=colonize", "growth=brownian&sensitivity=30"] {
            let session = finished(&format!("seed=kea&attractors=2000&{more}"));
            assert!(former_ways(&session).is_empty(), "{more}");
        }
    }
}
