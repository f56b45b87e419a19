//! Every map keeps its promises, whatever its land is and however its rivers grow.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use crate::common::lands::every_land;
use crate::common::tier::{one_in, pairs, tiers};
use riverseed::Session;
use riverseed::analyse::proof::{Proof, findings};
use riverseed::digest::digest_of_session;
use riverseed::recipe::link;

/// The ways of growing, with smooth courses and as grown, and trees with all their branches.
const GROWTHS: [&str; 6] = [
    "growth=drainage",
    "growth=drainage&courses=grown&trim=0",
    "growth=colonize",
    "preset=momentum",
    "growth=brownian&sensitivity=24",
    "growth=brownian&sensitivity=24&courses=grown&trim=0",
];

/// A coast of 24 points, and two rivers: one from the sea in the east, one from the north.
const ISLAND: &str =
    ".4UgA5qmw30r9yyxIsK2_lt6ggA5maS27T11VNNzDILtoGVmfHrgAKsZgNtSXQaM8T1KqZHJEf_Gam4FfsKJAvlO3ySUC1TZP";
const RIVERS: &str = "...7gczzMa4sygAmZa4gAgAa4nrTMmZ...ZmGa";

/// The words, one after the other.
const WORDS: [&str; 5] = ["kea", "rimu", "loire", "kauri", "Anna%20%26%20Tom"];

fn maps_keep_their_promises() {
    let maps = pairs(every_land(), GROWTHS).zip(WORDS.into_iter().cycle());
    for ((land, growth), word) in one_in(7, maps) {
        let link = format!("seed={word}&{growth}&{land}&attractors=3000");
        let map = Session::new(link::read(&link).unwrap()).unwrap().finish().unwrap();
        for finding in findings(&map).unwrap() {
            assert!(finding.looked_at > 0, "{link}: there are no {}", finding.promise.counted);
            assert_eq!(finding.breaches, [], "{link}: {}", finding.promise.says);
        }
    }
}

tiers!(maps_keep_their_promises);

/// Drawn rivers begin on the coast of the drawing, or where all of the map is land on any of its sides.
#[test]
fn drawn_rivers_keep_their_promises() {
    for (coast, growth) in pairs([ISLAND, ""], GROWTHS) {
        let link = format!("seed=kea&{growth}&land=drawn&outline={coast}{RIVERS}&sides=n&attractors=1500");
        let map = Session::new(link::read(&link).unwrap()).unwrap().finish().unwrap();
        for finding in findings(&map).unwrap() {
            assert_eq!(finding.breaches, [], "{link}: {}", finding.promise.says);
        }
    }
}

#[test]
fn bits_are_the_same_however_a_session_is_stepped() {
    for link in ["seed=kea&attractors=900", "seed=kea&preset=original&attractors=900&land=rectangle"] {
        let [mut one, mut other] = [(); 2].map(|()| Session::new(link::read(link).unwrap()).unwrap());
        while other.advance(1).unwrap() {}
        let proof = Proof::of(&mut one, digest_of_session(&mut other).unwrap()).unwrap();
        assert!(proof.bits.are_the_same(), "{link}: {:?}", proof.bits);
        assert_eq!(proof.broken(), 0);
    }
}
