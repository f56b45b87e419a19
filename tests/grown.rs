//! `courses=grown`: rivers follow the tree's own steps, in pictures as in files.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use crate::common::plain::plain;
use glam::Vec2;
use riverseed::export::svg;
use riverseed::network::NONE;
use riverseed::picture::Picture;
use riverseed::recipe::link;
use riverseed::session::{Phase, Session};

fn finished(link: &str) -> Session {
    let mut session = Session::new(link::read(&plain(link)).unwrap()).unwrap();
    while session.advance(u32::MAX).unwrap() {}
    session
}

/// Places, and for each the index of the next one downstream; [`NONE`] at a mouth.
struct Lines(Vec<Vec2>, Vec<u32>);

impl Lines {
    fn of_tree(session: &Session) -> Self {
        let tree = session.pruned().tree;
        Self(tree.at, tree.parent)
    }

    /// As drawn and written.
    fn of_rivers(session: &Session) -> Self {
        let network = session.network().unwrap();
        Self(network.vertices.iter().map(|vertex| vertex.at).collect(), network.downstream())
    }

    fn next(&self, i: u32) -> Option<u32> {
        self.1.get(i as usize).copied().filter(|&next| next != NONE)
    }

    fn at(&self, i: u32) -> Vec2 {
        self.0[i as usize]
    }

    /// Every step: where it begins and ends, in whatever order, to the bit.
    fn steps(&self) -> Vec<[u32; 4]> {
        let bits = |at: Vec2| [at.x.to_bits(), at.y.to_bits()];
        let step = |i: u32| self.next(i).map(|next| [bits(self.at(i)), bits(self.at(next))].as_flattened().try_into());
        let mut steps: Vec<[u32; 4]> = (0..self.0.len() as u32).filter_map(step).map(Result::unwrap).collect();
        steps.sort_unstable();
        steps
    }

    fn length(&self) -> f32 {
        (0..self.0.len() as u32).filter_map(|i| self.next(i).map(|next| self.at(i).distance(self.at(next)))).sum()
    }

    /// The number of places where a river turns by more than 60°, and the number of places, without confluences.
    fn turns(&self) -> [f32; 2] {
        let mut arms = vec![0; self.0.len()];
        (0..self.0.len() as u32).filter_map(|i| self.next(i)).for_each(|next| arms[next as usize] += 1);
        let turn = |i: u32| {
            let next = self.next(i).filter(|&next| arms[next as usize] == 1)?;
            let after = self.next(next)?;
            Some((self.at(next) - self.at(i)).angle_to(self.at(after) - self.at(next)).abs() > 60f32.to_radians())
        };
        let turns: Vec<bool> = (0..self.0.len() as u32).filter_map(turn).collect();
        [turns.iter().filter(|sharp| **sharp).count() as f32, turns.len() as f32]
    }
}

/// Where steps may not cross each other, rivers are the tree, but for what runs on over the land of deltas.
#[test]
fn rivers_as_grown_are_the_tree() {
    for link in [
        "growth=brownian&sensitivity=40&trim=60",
        "growth=brownian&sensitivity=40&trim=0&land=archipelago",
        "growth=drainage&attractors=3000&land=island&mouths=0&trim=0",
    ] {
        let session = finished(&format!("{link}&deltas=0&courses=grown&simplify=70&meander=flow&meander-rounds=50"));
        assert!(!session.growth().may_cross() && session.summary().rounds == 0);
        let (drawn, tree) = (Lines::of_rivers(&session).steps(), Lines::of_tree(&session).steps());
        assert!(tree.len() > 250 && drawn == tree, "{link}: {} steps of {}", drawn.len(), tree.len());
        let smooth = finished(&format!("{link}&deltas=0&courses=smooth&simplify=70&meander=none"));
        assert!(Lines::of_rivers(&smooth).steps() != tree, "{link}");
    }
}

/// Measures of four maps of a preset: the share of turns over 60° in percent, in the tree and as drawn, and the ratio
/// of the drawn length to that of the tree.
fn measured(link: &str) -> (f32, f32, f32) {
    let sum = |a: [f32; 2], b: [f32; 2]| [a[0] + b[0], a[1] + b[1]];
    let (mut grown, mut drawn, mut length) = ([0.0; 2], [0.0; 2], [0.0; 2]);
    for seed in 0..4 {
        let session = finished(&format!("country=usual&seed=s{seed}&attractors=3000&mouths=3&{link}"));
        let (tree, rivers) = (Lines::of_tree(&session), Lines::of_rivers(&session));
        (grown, drawn) = (sum(grown, tree.turns()), sum(drawn, rivers.turns()));
        length = sum(length, [rivers.length(), tree.length()]);
    }
    let measured = (100.0 * grown[0] / grown[1], 100.0 * drawn[0] / drawn[1], length[0] / length[1]);
    println!("{link}: {measured:.3?}");
    measured
}

#[test]
fn presets_are_drawn_with_the_turns_and_the_length_of_their_trees() {
    let names = ["original", "momentum", "curl", "trimmed-original", "trimmed-momentum", "trimmed-curl"];
    let sharp = names.map(|name| {
        let (grown, drawn, length) = measured(&format!("preset={name}"));
        assert!((drawn - grown).abs() < 0.25, "{name}: {drawn} % of turns are sharp, not {grown} %");
        assert!((0.99..=1.01).contains(&length), "{name}: {length} of the length");
        drawn
    });
    assert!(sharp[1] > sharp[2] && sharp[4] > sharp[5], "momentum zigzags, curl does less: {sharp:?}");
    // Smooth courses lose most of them.
    let (grown, drawn, _) = measured("preset=momentum&courses=smooth");
    assert!(drawn < grown / 2.0, "{drawn} % of {grown} %");
    let (_, _, zigzag) = measured("preset=momentum&momentum=0.8");
    let (_, _, straight) = measured("preset=momentum&momentum=0.8&courses=smooth");
    assert!((0.99..=1.01).contains(&zigzag) && straight < 0.9, "{zigzag} and {straight} of the length");
}

/// A picture of lines alone, when the last node has grown, and when its rivers are finished.
fn pictures(link: &str) -> [Vec<u8>; 2] {
    let mut session = Session::new(link::read(&plain(link)).unwrap()).unwrap();
    while session.phase() == Phase::Growing {
        session.advance(1).unwrap();
    }
    let painted = |session: &Session| {
        let mut picture = Picture::new(600, 400).unwrap();
        picture.paint(session);
        picture.pixmap().data().to_vec()
    };
    let grown = painted(&session);
    while session.advance(u32::MAX).unwrap() {}
    [grown, painted(&session)]
}

#[test]
fn the_last_picture_of_growth_is_the_one_of_the_rivers() {
    for link in ["growth=brownian&sensitivity=40&trim=60", "preset=trimmed-original&attractors=600"] {
        let [grown, finished] = pictures(&format!("{link}&style=skeleton&courses=grown"));
        assert!(grown == finished, "{link}");
        let [grown, finished] = pictures(&format!("{link}&style=skeleton&courses=smooth&simplify=0&meander=none"));
        assert!(grown != finished, "{link}");
    }
}

#[test]
fn svg_of_rivers_as_grown_has_straight_lines_alone() {
    let rivers = |link: &str| {
        let text = svg::svg(&finished(&format!("attractors=400&preset=momentum&{link}")).map().unwrap()).unwrap();
        text.lines().filter(|line| line.contains("id=\"river-")).map(str::to_owned).collect::<Vec<_>>()
    };
    let is_curved = |path: &String| path.split_once(" d=\"").unwrap().1.contains(['q', 't']);
    let (grown, smooth) = (rivers("style=ink"), rivers("style=ink&courses=smooth"));
    assert!(grown.len() > 20 && !grown.iter().any(is_curved), "{grown:?}");
    assert!(smooth.iter().any(is_curved));
}
