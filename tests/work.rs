//! How much work a step of a session is at most, whatever the recipe, in elementary steps: what keeps a page from freezing.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

#[path = "common/lands.rs"]
mod lands;

use std::collections::BTreeMap;

use lands::every_land;
use riverseed::random::{Purpose, Seed};
use riverseed::recipe::{Stage, link};
use riverseed::session::Session;
use riverseed::work;

/// Closed lines of so many points in all, anywhere on the map: they cross themselves and each other.
fn coasts(seed: &str, lines: u32, points: u32) -> String {
    const ALPHABET: &[u8] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
    let mut chance = Seed::from_text(seed).stream(Purpose::Land);
    let mut line =
        || (0..points / lines * 4).map(|_| char::from(ALPHABET[chance.below(64) as usize])).collect::<String>();
    (0..lines).map(|_| format!(".{}", line())).collect()
}

/// The most elementary steps that a step of a session takes, by phase.
#[derive(Default)]
struct Most(BTreeMap<String, u64>);

impl Most {
    /// Counts what a call of a phase takes.
    fn count<T>(&mut self, phase: &str, call: impl FnOnce() -> T) -> T {
        let before = work::steps();
        let result = call();
        let most = self.0.entry(phase.to_owned()).or_default();
        *most = (*most).max(work::steps() - before);
        result
    }

    /// Plants a recipe.
    fn plant(&mut self, recipe: &str) -> Session {
        self.count("Planting", || Session::new(link::read(recipe).unwrap()).unwrap())
    }

    /// Advances a session step by step to its end.
    fn finish(&mut self, session: &mut Session) {
        while self.count(&format!("{:?}", session.phase()), || session.advance(1).unwrap()) {}
    }

    /// No call took more than the bound.
    fn check(&self, session: &Session) {
        let bound = bound(session);
        for (phase, most) in &self.0 {
            let link = link::write(session.recipe());
            assert!(*most <= bound, "{phase}: {most} elementary steps, over {bound}: {link}");
        }
    }
}

/// What a step may take at most: a map of land is a million cells and more, whatever grows on it; and rivers meander the longer
/// the more of them there are, by attractors or by cells of a Brownian tree.
fn bound(session: &Session) -> u64 {
    8_000_000 + 250 * u64::from(session.growth().total_discharge())
}

/// No step of a recipe takes more than the bound.
fn check(recipe: &str) {
    let mut most = Most::default();
    let mut session = most.plant(recipe);
    most.finish(&mut session);
    most.check(&session);
}

/// A mouth more was searched for among fifty thousand places, all of them anew for each, in a single tick: over 100 million
/// elementary steps, and as much for the next.
#[test]
fn no_drawn_coast_of_random_points_holds_a_tick() {
    for (seed, lines) in [("a", 1), ("b", 1), ("c", 8)] {
        let land = format!("seed={seed}&land=drawn&outline={}", coasts(seed, lines, 240));
        for (attractors, growth) in [
            (100, "reach=12"),
            (1000, "reach=12&kill=0.5&step=0.2"),
            (1000, "reach=12&step=0.2&mouths=64&mouth-spacing=0&meander=none"),
            (3000, "reach=12&curl=2&momentum=0.9&mouths=64&mouth-spacing=0&scatter=grid"),
        ] {
            check(&format!("{land}&attractors={attractors}&{growth}"));
        }
        check(&format!("{land}&growth=brownian&sensitivity=8"));
        check(&format!("{land}&growth=drainage&attractors=40000&bending=4&captures=24&channel-area=1&trim=0"));
    }
}

/// The search for mouths is short on the whole, too: each place is counted once, and few of them again.
#[test]
fn a_search_for_a_mouth_ends_soon() {
    let begun = work::steps();
    check(&format!("seed=b&land=drawn&outline={}&attractors=100&reach=12", coasts("b", 1, 240)));
    assert!(work::steps() - begun < 300_000_000, "{}", work::steps() - begun);
}

/// With valleys a tick takes up so many attractors, however long the way to each is.
#[test]
fn no_tick_along_valleys_takes_long() {
    for land in every_land().into_iter().chain([format!("land=drawn&outline={}", coasts("c", 8, 240))]) {
        check(&format!("{land}&growth=colonize&valleys=0.5&attractors=100&reach=12&kill=0.5&step=0.2&meander=none"));
        check(&format!(
            "{land}&growth=colonize&valleys=1&attractors=20000&reach=12&step=0.2&curl=2&mouths=64&meander=none"
        ));
    }
}

/// Rivers that meander as much as recipes allow.
const WILD: &str = "&trim=0&simplify=0&width=40&neck=4&clearance=1&meander-rounds=12&meander-strength=1&meander-elsewhere=1&great-rivers=16&flat-share=1";

#[test]
fn no_land_holds_a_step_however_its_rivers_grow_and_meander() {
    for land in every_land() {
        check(&format!("{land}&roughness=1&attractors=100&reach=12&step=0.2{WILD}"));
        check(&format!("{land}&roughness=1&attractors=3000&reach=12&step=0.2{WILD}"));
        check(&format!("{land}&roughness=1&growth=brownian&sensitivity=8{WILD}"));
    }
    check(&format!("attractors=20000&step=0.5{WILD}"));
}

/// A change of how rivers are shaped made all steps up to the first round of meandering in one call. Now it makes none, and a
/// change of land or growth only plants.
#[test]
fn no_change_holds_a_page() {
    let mut most = Most::default();
    let recipe = format!("attractors=20000&step=0.5{WILD}");
    let mut session = most.plant(&recipe);
    most.finish(&mut session);
    for change in ["width=39", "simplify=5", "meander-strength=0.9", "trim=1", "style=map", "land=valley"] {
        let changed = link::pairs(change).unwrap();
        let changed = link::apply(session.recipe().clone(), &changed).unwrap();
        let stage = most.count(change, || session.change(changed).unwrap());
        assert!(most.0[change] == 0 || stage < Some(Stage::Prune), "{change}: {} elementary steps", most.0[change]);
        most.finish(&mut session);
        most.check(&session);
    }
}
