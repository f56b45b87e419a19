//! The greatest work of a session's step, whatever the recipe, in elementary steps: the bound that keeps a page from
//! freezing.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use std::collections::BTreeMap;

use crate::common::lands::every_land;
use crate::common::tier::{Tier, one_in, pairs, tiers};
use riverseed::base::random::{Purpose, Seed};
use riverseed::base::work;
use riverseed::recipe::{Stage, link};
use riverseed::session::{Phase, Session};

/// Closed lines with this number of points in all, anywhere on the map: they cross themselves and each other.
fn coasts(seed: &str, lines: u32, points: u32) -> String {
    const ALPHABET: &[u8] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
    let mut chance = Seed::from_text(seed).stream(Purpose::Land);
    let mut line =
        || (0..points / lines * 4).map(|_| char::from(ALPHABET[chance.below(64) as usize])).collect::<String>();
    (0..lines).map(|_| format!(".{}", line())).collect()
}

/// The greatest number of elementary steps in a step of a session, by phase.
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

    /// Checks that no call took more than the bound.
    fn check(&self, session: &Session) {
        let bound = bound(session);
        for (phase, most) in &self.0 {
            let link = link::write(session.recipe());
            assert!(*most <= bound, "{phase}: {most} elementary steps, over {bound}: {link}");
        }
    }
}

/// The bound for a step. A map of land is a million cells and more, whatever grows on it, and meandering takes longer
/// the more rivers there are, by attractors or by cells of a Brownian tree.
fn bound(session: &Session) -> u64 {
    9_750_000 + 250 * u64::from(session.growth().total_discharge())
}

/// No step of a recipe takes more than the bound.
fn check(recipe: &str) {
    let mut most = Most::default();
    let mut session = most.plant(recipe);
    most.finish(&mut session);
    most.check(&session);
}

/// A mouth more was searched for among fifty thousand places, all of them again for each, in a single tick: over 100
/// million elementary steps, and as much for the next.
fn no_drawn_coast_of_random_points_holds_a_tick() {
    let growths = [
        "attractors=100&growth=colonize&reach=12",
        "attractors=1000&growth=colonize&reach=12&kill=0.5&step=0.2",
        "attractors=1000&growth=colonize&reach=12&step=0.2&mouths=64&mouth-spacing=0&meander=none",
        "attractors=3000&growth=colonize&reach=12&curl=2&momentum=0.9&mouths=64&mouth-spacing=0&scatter=grid",
        "growth=brownian&sensitivity=8",
    ];
    let drainage = EXTREMES_OF_DRAINAGE.map(|drainage| format!("attractors=20000&trim=0&{drainage}"));
    let growths: Vec<String> = growths.map(String::from).into_iter().chain(drainage).collect();
    for ((seed, lines), growth) in one_in(7, pairs([("a", 1), ("b", 1), ("c", 8)], growths)) {
        check(&format!("country=usual&seed={seed}&land=drawn&outline={}&{growth}", coasts(seed, lines, 240)));
    }
}

tiers!(no_drawn_coast_of_random_points_holds_a_tick);

/// Drainage at both ends of its ranges: an invasion alone decides, or nothing but distance, or the country.
const EXTREMES_OF_DRAINAGE: [&str; 4] = [
    "growth=drainage&valleys=1&valley-spacing=60&concavity=0.8&hardness=1.5&hardness-scale=60&captures=24&bending=4&channel-area=1",
    "growth=drainage&valleys=1&valley-spacing=4&concavity=0.2&hardness=1.5&hardness-scale=8&captures=24&bending=4&channel-area=1",
    "growth=drainage&valleys=0&concavity=0.2&hardness=0&captures=0&bending=0&channel-area=60",
    "growth=drainage&pattern=rectangular&strike=45&fall=2&bending=4&bending-variation=1&channel-area=1&head-variation=1&tributary-spacing=0.1",
];

/// Lands that water can hardly leave: without a coast, with one outlet, and with a part that ridges shut off.
const CLOSED_LANDS: [&str; 4] = [
    "land=drawn&roughness=0&aspect=1&outline=.MzMzzMMzzMzMMzzM..M1M1zKM1zKzKM1zKM1M1",
    "land=island&mouths=1",
    "land=rectangle&sides=s&mouths=1&mouth-spacing=400",
    "land=drawn&roughness=0&aspect=1&outline=.MzMzzMMzzMzMMzzM..YAYAnnYAnnnnYAnnYAYA",
];

fn no_extreme_of_drainage_holds_a_tick_where_water_can_hardly_leave() {
    for (land, drainage) in one_in(5, pairs(CLOSED_LANDS, EXTREMES_OF_DRAINAGE)) {
        check(&format!("{land}&attractors=20000&trim=0&{drainage}"));
    }
}

tiers!(no_extreme_of_drainage_holds_a_tick_where_water_can_hardly_leave);

/// Parcels are laid out over the whole map, and few of them are kept where there is little land.
#[test]
fn parcels_of_little_land_are_laid_out_with_little_work() {
    for growth in ["drainage&bending=4", "drainage&bending=2", "colonize&valleys=0.5"] {
        let mut most = Most::default();
        let outline = ".AAAAIAAAIAIAAAIA...EAEA";
        let session = most
            .plant(&format!("country=usual&seed=a&land=drawn&outline={outline}&attractors=1000000&growth={growth}"));
        assert!((1..20_000).contains(&session.growth().attractors()), "{growth}: {}", session.growth().attractors());
        most.check(&session);
    }
}

/// However many parcels there are, a tick settles some thousand of them; what begins and ends a round looks at each
/// once.
#[test]
fn a_tick_of_drainage_is_a_small_part_of_a_round() {
    const RECIPE: &str = "growth=drainage&land=rectangle&attractors=300000&valleys=0.5&captures=2&bending=0";
    let mut session = Session::new(link::read(RECIPE).unwrap()).unwrap();
    let parcels = u64::from(session.growth().total_discharge());
    while session.phase() == Phase::Growing {
        let before = work::steps();
        session.advance(1).unwrap();
        // A whole round takes six a parcel.
        let most = 2 * parcels;
        assert!(work::steps() - before < most, "{} elementary steps, over {most}", work::steps() - before);
    }
}

/// The search for mouths is short on the whole, too: each place is counted once, and few of them again.
#[test]
fn a_search_for_a_mouth_ends_soon() {
    let begun = work::steps();
    check(&format!(
        "country=usual&seed=b&growth=colonize&land=drawn&outline={}&attractors=100&reach=12",
        coasts("b", 1, 240)
    ));
    assert!(work::steps() - begun < 300_000_000, "{}", work::steps() - begun);
}

/// With valleys a tick takes up so many attractors, however long the way to each is.
fn no_tick_along_valleys_takes_long() {
    let lands = every_land().into_iter().chain([format!("land=drawn&outline={}", coasts("c", 8, 240))]);
    let growths = ["valleys=0.5&attractors=100&kill=0.5", "valleys=1&attractors=20000&curl=2&mouths=64"];
    for (land, growth) in one_in(5, pairs(lands, growths)) {
        check(&format!("{land}&growth=colonize&reach=12&step=0.2&meander=none&{growth}"));
    }
}

tiers!(no_tick_along_valleys_takes_long);

/// Rivers that meander as much as recipes allow.
const WILD: &str = "&trim=0&simplify=0&width=40&neck=4&clearance=1&meander-rounds=12&meander-strength=1&meander-elsewhere=1&great-rivers=16&flat-share=1";

fn no_land_holds_a_step_however_its_rivers_grow_and_meander() {
    let drainage = format!("{}&attractors=3000", EXTREMES_OF_DRAINAGE[0]);
    let growths = [
        "growth=colonize&attractors=100&reach=12&step=0.2",
        "growth=colonize&attractors=3000&reach=12&step=0.2",
        "growth=brownian&sensitivity=8",
        &drainage,
    ];
    let maps = pairs(every_land(), growths).map(|(land, growth)| format!("{land}&roughness=1&{growth}"));
    let large =
        ["colonize&step=0.5", "drainage&channel-area=1"].map(|growth| format!("attractors=20000&growth={growth}"));
    for map in one_in(9, maps.chain(large)) {
        check(&format!("{map}{WILD}"));
    }
}

tiers!(no_land_holds_a_step_however_its_rivers_grow_and_meander);

/// However many rivers there are, however wide, straight or winding: each step of their relief is a small part of it.
/// The worst for valleys are wide rivers with many vertices; for ridges, many long ones.
fn no_relief_holds_a_step() {
    let ridges = coasts("e", 1, 200).replacen('.', "..", 1);
    let ridges = format!("land=drawn&outline={}{ridges}", coasts("d", 1, 40));
    let course = format!("land=drawn&outline=..{}", coasts("a", 1, 240));
    let growths = [
        "drainage&attractors=20000&channel-area=1&mouths=1",
        "colonize&attractors=1000&step=0.2",
        "brownian&sensitivity=12",
    ];
    for (land, growth) in one_in(10, pairs(every_land().into_iter().chain([ridges, course]), growths)) {
        let recipe = format!("{land}&growth={growth}&style=atlas&trim=0&simplify=0&courses=grown&width=40");
        let mut session = Session::new(link::read(&recipe).unwrap()).unwrap();
        while session.phase() != Phase::Relief {
            assert!(session.advance(1).unwrap(), "there is no relief: {recipe}");
        }
        let begun = work::steps();
        assert!(session.advance(1).unwrap());
        let nodes = session.tree().len() as u64;
        assert!(work::steps() - begun <= 40 * nodes, "the first step only asks for memory, and lists the rills");
        let (mut most, mut all) = (0, 0);
        while session.phase() == Phase::Relief {
            let before = work::steps();
            session.advance(1).unwrap();
            most = most.max(work::steps() - before);
            all += work::steps() - before;
        }
        let vertices = session.network().unwrap().vertices.len() as u64;
        let bound = 2_300_000 + 20 * vertices;
        assert!(most < bound, "{most} elementary steps, over {bound}: {recipe}");
        assert!(all > 10 * 250_000, "{all} elementary steps, fewer than are made: {recipe}");
    }
}

tiers!(no_relief_holds_a_step);

/// A change of how rivers are shaped made all steps up to the first round of meandering in one call. Now it makes none,
/// and a change of land or growth only plants.
fn no_change_holds_a_page() {
    let attractors = if Tier::here() == Tier::First { 3000 } else { 20_000 };
    for growth in ["colonize&step=0.5", "drainage&channel-area=2"] {
        let mut most = Most::default();
        let mut session = most.plant(&format!("style=ink&attractors={attractors}&growth={growth}{WILD}"));
        most.finish(&mut session);
        for (change, first) in [
            ("width=39", Stage::Shape),
            ("simplify=5", Stage::Shape),
            ("meander-strength=0.9", Stage::Shape),
            ("channel-area=1", Stage::Prune),
            ("trim=1", Stage::Prune),
            ("style=atlas", Stage::Paint),
            ("land=valley", Stage::Land),
        ] {
            let changed = link::pairs(change).unwrap();
            let changed = link::apply(session.recipe().clone(), &changed).unwrap();
            let stage = most.count(change, || session.change(changed).unwrap());
            // Colonization knows no such area.
            let is_idle = growth == "colonize" && change.starts_with("channel-area");
            assert_eq!(stage, (!is_idle).then_some(first), "{growth}, {change}");
            assert!(most.0[change] == 0 || first < Stage::Prune, "{change}: {} elementary steps", most.0[change]);
            most.finish(&mut session);
            most.check(&session);
        }
    }
}

tiers!(no_change_holds_a_page);

/// As long a course as a drawing holds is followed at once, and so are as many mouths.
fn no_scribbled_rivers_hold_a_tick() {
    let course = format!("..{}", coasts("a", 1, 240));
    let mouths = coasts("b", 140, 140).replace('.', "...");
    let land = coasts("c", 1, 120);
    let half = format!("{land}..{}", coasts("d", 1, 120));
    let growths = [
        "colonize&attractors=1000&reach=12&kill=0.5&step=0.2",
        "colonize&attractors=20000&reach=12&step=0.2&curl=2&trim=400&meander=none",
        "brownian&sensitivity=8",
        "drainage&attractors=40000&bending=4&captures=24&channel-area=1&trim=0",
    ];
    for (outline, growth) in one_in(5, pairs([course, mouths, half], growths)) {
        check(&format!("country=usual&seed=a&land=drawn&outline={outline}&growth={growth}"));
    }
}

tiers!(no_scribbled_rivers_hold_a_tick);
