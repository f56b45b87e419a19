use super::*;
use crate::base::geometry::meet;
use crate::land::{Cell, CoastDistance, Land};
use crate::property::cases;
use crate::recipe::{Choice, Pattern, link};
use crate::tree::Hydrology;
use glam::Vec2;
use proptest::prelude::*;
use std::collections::{BTreeMap, BTreeSet};

fn settings(text: &str) -> GrowthSettings {
    GrowthSettings::of(&link::read(&format!("growth=drainage&{text}")).unwrap())
}

fn grown(text: &str) -> Drainage {
    let mut growth = Drainage::new(settings(text)).unwrap();
    while growth.tick() {}
    growth
}

/// Generates recipes for all kinds of land, with all parameters of drainage.
fn recipes() -> impl Strategy<Value = String> {
    let lands = prop::sample::select(vec![
        "land=rectangle&sides=s",
        "land=rectangle&sides=nw",
        "land=island",
        "land=continent&sides=e",
        "land=archipelago",
        "land=valley",
        "land=basin",
        "land=drawn&outline=.MzMzzMMzzMzM",
        "land=drawn&outline=.MzMzzMMzzMzM...MzgAcAgAgAcA...gAMz",
        "land=drawn&outline=...AAgAMzczTMmZgAgA...zM__",
    ]);
    let shape = (0u32..1000, 100u32..900, 0.2f32..0.7, 0.3f32..3.0);
    let ground = (0.0f32..=1.0, 4.0f32..60.0, 0.2f32..0.8, 0u32..6, 0.0f32..1.5, 0.0f32..=4.0);
    let patterns = prop::sample::select(Pattern::WORDS.iter().map(|word| word.name).collect::<Vec<_>>());
    let country = (prop_oneof![Just("dendritic"), patterns], prop_oneof![Just(0.0f32), 0.0f32..=2.0], 0.0f32..=1.0);
    let mouths = (prop::sample::select(vec![0, 0, 1, 5]), prop::sample::select(vec!["nesw", "n", "se"]), 0u32..2);
    (lands, shape, ground, mouths, country).prop_map(
        |(land, (seed, attractors, sea, aspect), ground, (mouths, shores, apart), (pattern, fall, uneven))| {
            let (valleys, valley_spacing, concavity, captures, hardness, bending) = ground;
            format!(
                "{land}&country=usual&seed={seed}&attractors={attractors}&sea={sea:.2}&aspect={aspect:.2}&valleys={valleys:.2}\
             &valley-spacing={valley_spacing:.1}&concavity={concavity:.2}&captures={captures}&hardness={hardness:.2}\
             &bending={bending:.2}&pattern={pattern}&fall={fall:.2}&bending-variation={uneven:.2}&mouths={mouths}&shores={shores}&mouth-spacing={}",
                apart * 60
            )
        },
    )
}

/// Iterates over the edges between parcels, each once.
fn joined(parcels: &Parcels) -> impl Iterator<Item = (usize, usize)> {
    let from = |a: usize| parcels.neighbours.of(a).iter().map(move |&b| (a, b as usize)).filter(|(a, b)| a < b);
    (0..parcels.len()).flat_map(from)
}

/// Lists all edges between parcels, and those to their outlets.
fn edges(parcels: &Parcels) -> Vec<(Vec2, Vec2)> {
    let between = joined(parcels).map(|(a, b)| (parcels.at[a], parcels.at[b]));
    let out = parcels.outlets.iter().map(|outlet| (parcels.at[outlet.parcel as usize], outlet.at));
    between.chain(out).collect()
}

/// Relaxes every way to the sea until nothing changes (Bellman and Ford), with the ties that a queue leaves out.
fn relaxed(parcels: &Parcels, area: &[f32], concavity: f32) -> Vec<f32> {
    let slope: Vec<f32> = area.iter().map(|&area| round::slope(area, concavity)).collect();
    let mut cost = vec![f32::INFINITY; parcels.len()];
    for outlet in &parcels.outlets {
        let parcel = outlet.parcel as usize;
        cost[parcel] = parcels.cost_out(parcel) * slope[parcel];
    }
    loop {
        let before = cost.clone();
        for here in 0..parcels.len() {
            for &there in parcels.neighbours.of(here) {
                let through = cost[there as usize] + parcels.cost_to(here, there) * slope[here];
                cost[here] = cost[here].min(through);
            }
        }
        if cost == before {
            return cost;
        }
    }
}

/// Counts the parcels that each parcel drains, by one walk to the sea at a time.
fn recounted(directions: &FlowDirections) -> Vec<u32> {
    let mut areas = vec![0; directions.to.len()];
    for &start in &directions.order {
        let mut here = start;
        while here != FlowDirections::OUT {
            areas[here as usize] += 1;
            here = directions.to[here as usize];
        }
    }
    areas
}

/// Computes the energy of a network under the law of its rounds.
fn energy(parcels: &Parcels, directions: &FlowDirections, concavity: f32) -> f64 {
    let areas = directions.areas();
    let step = |&here: &u32| {
        let cost = match directions.to[here as usize] {
            FlowDirections::OUT => parcels.cost_out(here as usize),
            to => parcels.cost_to(here as usize, to),
        };
        f64::from(cost) * libm::pow(areas[here as usize].into(), 1.0 - f64::from(concavity))
    };
    directions.order.iter().map(step).sum()
}

/// Returns the parcel that each parcel drains to, by the tree; `None` without a node.
fn ways_of(growth: &Drainage) -> Vec<Option<u32>> {
    let tree = growth.tree();
    let mut parcels = vec![NO_PARENT; tree.len()];
    let nodes = || (0..).zip(&growth.node).filter(|(_, node)| **node != NONE);
    nodes().for_each(|(parcel, &node)| parcels[node as usize] = parcel);
    let mut ways = vec![None; growth.node.len()];
    // A mouth is not a parcel.
    nodes().for_each(|(parcel, &node): (u32, _)| {
        ways[parcel as usize] = Some(parcels[tree.parent[node as usize] as usize])
    });
    ways
}

fn whole_round(parcels: &Parcels, area: &[f32], concavity: f32) -> Round {
    let is_closed = vec![false; parcels.outlets.len()];
    let mut round = Round::new(parcels, area, &is_closed, concavity).unwrap();
    while round.advance(parcels, 7).unwrap() {}
    round
}

proptest! {
    #![proptest_config(cases(64))]

    #[test]
    fn no_edge_crosses_water_or_a_ridge_or_another_edge(recipe in recipes()) {
        let settings = settings(&recipe);
        let parcels = Parcels::new(&settings);
        let edges = edges(&parcels);
        for (i, &(a, b)) in edges.iter().enumerate() {
            prop_assert!(settings.allows(a, b), "{recipe}: {a} to {b}");
            for &(c, d) in &edges[..i] {
                let is_joined = [c, d].contains(&a) || [c, d].contains(&b);
                prop_assert!(is_joined || !meet((a, b), (c, d)), "{recipe}: {a} to {b} meets {c} to {d}");
            }
        }
    }

    #[test]
    fn neighbours_are_mutual_and_cost_the_same_before_the_land_falls(recipe in recipes()) {
        let settings = settings(&recipe);
        let parcels = Parcels::new(&settings);
        for (a, b) in joined(&parcels) {
            prop_assert!(parcels.neighbours.of(b).contains(&(a as u32)), "{}: {} and {}", recipe, a, b);
            let [there, back] = [parcels.cost_to(a, b as u32), parcels.cost_to(b, a as u32)];
            prop_assert!(there > 0.0 && back > 0.0 && there.is_finite() && back.is_finite(), "{}", recipe);
            if settings.drainage.fall == 0.0 {
                prop_assert_eq!(there, back, "{}", recipe);
            }
        }
    }

    #[test]
    fn each_round_finds_the_cheapest_ways_there_are(recipe in recipes()) {
        let settings = settings(&recipe);
        let parcels = Parcels::new(&settings);
        let mut area = vec![1.0f32; parcels.len()];
        for _ in 0..4 {
            let round = whole_round(&parcels, &area, settings.drainage.concavity);
            let twin = relaxed(&parcels, &area, settings.drainage.concavity);
            prop_assert_eq!(round.costs().collect::<Vec<f32>>(), twin, "{}", recipe);
            let areas = round.directions().areas();
            prop_assert_eq!(&areas, &recounted(round.directions()));
            for (area, new) in area.iter_mut().zip(areas) {
                *area = (*area * new.max(1) as f32).sqrt();
            }
        }
    }

    #[test]
    fn invasion_takes_the_lowest_parcel_beside_it(recipe in recipes()) {
        let settings = settings(&recipe);
        let parcels = Parcels::new(&settings);
        let mut invasion = Invasion::new(&settings, &parcels).unwrap();
        while invasion.advance(&parcels, 5).unwrap() {}
        let heights = heights::heights(&settings, &parcels);
        // By scanning everything beside the parcels taken so far.
        let mut to = vec![NONE; parcels.len()];
        parcels.outlets.iter().for_each(|outlet| to[outlet.parcel as usize] = FlowDirections::OUT);
        let (mut order, mut is_taken) = (Vec::new(), vec![false; parcels.len()]);
        while let Some(lowest) = (0..parcels.len())
            .filter(|&i| to[i] != NONE && !is_taken[i])
            .reduce(|a, b| if heights[b] < heights[a] { b } else { a })
        {
            is_taken[lowest] = true;
            order.push(lowest as u32);
            for &there in parcels.neighbours.of(lowest) {
                if to[there as usize] == NONE {
                    to[there as usize] = lowest as u32;
                }
            }
        }
        let directions = invasion.into_directions();
        prop_assert_eq!((directions.to, directions.order), (to, order));
    }

    #[test]
    fn every_parcel_that_is_connected_to_an_outlet_drains_downhill(recipe in recipes()) {
        let growth = grown(&recipe);
        let parcels = &growth.parcels;
        let mut is_reached = vec![false; parcels.len()];
        let mut next: Vec<u32> = parcels.outlets.iter().map(|outlet| outlet.parcel).collect();
        while let Some(here) = next.pop() {
            if !std::mem::replace(&mut is_reached[here as usize], true) {
                next.extend(parcels.neighbours.of(here as usize));
            }
        }
        let reached = is_reached.iter().filter(|&&reached| reached).count() as u32;
        prop_assert_eq!(growth.parcels() - growth.unreached(), reached, "{}", recipe);
        let tree = growth.tree();
        prop_assert_eq!(tree.elevation.len(), tree.len());
        for node in 0..tree.len() {
            match tree.parent_of(node) {
                Some(parent) => {
                    prop_assert!(parent < node && tree.elevation[node] > tree.elevation[parent]);
                    prop_assert!(growth.settings.allows(tree.at[node], tree.at[parent]), "{}", recipe);
                }
                None => prop_assert_eq!((tree.elevation[node], tree.drained[node]), (0.0, 0)),
            }
        }
        prop_assert_eq!(tree.drained.iter().sum::<u32>(), reached);
        prop_assert_eq!(tree.ticks().count(), tree.len());
    }

    #[test]
    fn captures_lead_from_each_tree_to_the_next(recipe in recipes()) {
        let mut growth = Drainage::new(settings(&recipe)).unwrap();
        let mut rounds = 0;
        let mut ways = Vec::new();
        while growth.ending().is_none() {
            growth.tick();
            if growth.rounds == rounds {
                continue;
            }
            if rounds == 0 {
                ways = ways_of(&growth);
            }
            for capture in growth.captures().iter().filter(|capture| capture.round == rounds) {
                prop_assert_eq!(ways[capture.parcel as usize], Some(capture.from), "{}: {:?}", recipe, capture);
                prop_assert!(capture.from != capture.to, "{}: {:?}", recipe, capture);
                ways[capture.parcel as usize] = Some(capture.to);
            }
            prop_assert_eq!(&ways, &ways_of(&growth), "{}: round {}", recipe, rounds);
            rounds = growth.rounds;
        }
        prop_assert!(growth.captures().iter().all(|capture| (1..rounds).contains(&capture.round)));
    }

    #[test]
    fn energy_rises_by_a_thousandth_at_most_from_round_to_round(recipe in recipes()) {
        // There is no theorem: now and then the energy rises by a few ten-thousandths, and by a hundredth with few
        // parcels or with an exponent unlike nature's.
        let mut settings = settings(&recipe);
        settings.drainage.spacing = 18.0;
        let (parcels, concavity) = (Parcels::new(&settings), 0.5);
        let mut area = vec![1.0f32; parcels.len()];
        let mut last = f64::INFINITY;
        for _ in 0..6 {
            let round = whole_round(&parcels, &area, concavity);
            let now = energy(&parcels, round.directions(), concavity);
            prop_assert!(now <= last * 1.001, "{recipe}: {last}, then {now}");
            last = now;
            for (area, new) in area.iter_mut().zip(round.directions().areas()) {
                *area = (*area * new.max(1) as f32).sqrt();
            }
        }
    }
}

#[test]
fn land_hides_parcels_and_moves_none() {
    let places = |over: &str| {
        let parcels =
            Parcels::new(&settings(&format!("country=usual&seed=kauri&attractors=500&aspect=1.4&bending=2&{over}")));
        parcels.identity.into_iter().zip(parcels.at).collect::<Vec<_>>()
    };
    let (whole, island) = (places("land=island&sea=0.01"), places("land=island&sea=0.6"));
    assert!(island.len() < whole.len() / 2 && island.len() > 100);
    assert!(island.iter().all(|place| whole.contains(place)));
}

#[test]
fn bends_move_no_place_farther_than_they_are_said_to() {
    for (bending, variation) in [(0.5, 0.8), (2.0, 0.0), (2.0, 0.4), (2.0, 0.8), (2.8, 0.5), (4.0, 0.0), (4.0, 1.0)] {
        for seed in 0..6 {
            let link = format!(
                "land=rectangle&attractors=5000&bending={bending}&bending-variation={variation}&country=usual&seed={seed}"
            );
            let bent = settings(&link);
            let mut straight = bent.clone();
            straight.drainage.bending = 0.0;
            let places = |settings: &GrowthSettings| {
                let lattice = Lattice::new(settings);
                lattice.identity.into_iter().zip(lattice.at).collect::<BTreeMap<_, _>>()
            };
            let (straight, farthest) = (places(&straight), bent.drainage.farthest_bend());
            let moved = |(cell, at): (&[u32; 2], &Vec2)| Some(straight.get(cell)?.distance(*at));
            let most = places(&bent).iter().filter_map(moved).fold(0.0, f32::max);
            assert!((0.4 * farthest..farthest).contains(&most), "{link}: {most} of {farthest}");
        }
    }
}

#[test]
fn the_sea_takes_no_neighbour_from_places_on_land() {
    for over in ["bending=2&bending-variation=1&attractors=6000", "bending=1&attractors=3000&pattern=trellis"] {
        let island = settings(&format!("land=archipelago&sea=0.7&aspect=1.4&country=usual&seed=kauri&{over}"));
        let land = island.land.clone().unwrap();
        let whole = GrowthSettings { land: None, ..island.clone() };
        let around = |settings: &GrowthSettings| {
            let lattice = Lattice::new(settings);
            let adjacency = adjacency::Adjacency::of_places(&lattice.at);
            let neighbours = |place: usize| {
                let around = adjacency.of(place).iter().map(|&there| lattice.identity[there as usize]);
                around.collect::<BTreeSet<_>>()
            };
            let of_place = |place: usize| (lattice.identity[place], (lattice.at[place], neighbours(place)));
            (0..lattice.at.len()).map(of_place).collect::<BTreeMap<_, _>>()
        };
        let (near, all) = (around(&island), around(&whole));
        assert!(near.len() < all.len(), "{over}: places far out at sea are left out");
        let on_land = |(_, (at, _)): &(&[u32; 2], &(Vec2, BTreeSet<[u32; 2]>))| {
            island.domain.contains(*at) && land.at(*at) == Cell::Land
        };
        let on_land: Vec<_> = all.iter().filter(on_land).collect();
        assert!(
            on_land.len() > 100 && on_land.iter().all(|(cell, as_before)| near.get(*cell) == Some(as_before)),
            "{over}"
        );
    }
}

#[test]
fn a_triangulation_has_the_edges_of_all_circles_that_hold_no_other_place() {
    // Delaunay's own definition, by comparing every three places with all others.
    let settings = settings("land=rectangle&attractors=100&bending=4&bending-variation=1&country=usual&seed=rata");
    let places = &Lattice::new(&settings).at[..160];
    let adjacency = adjacency::Adjacency::of_places(places);
    let is_in_circle = |[a, b, c]: [Vec2; 3], at: Vec2| {
        let [a, b, c] = [a, b, c].map(|corner| (corner - at).as_dvec2());
        let sum = a.length_squared() * b.perp_dot(c)
            + b.length_squared() * c.perp_dot(a)
            + c.length_squared() * a.perp_dot(b);
        sum * (b - a).perp_dot(c - a).signum() > 1e-3
    };
    let mut edges = BTreeSet::new();
    for a in 0..places.len() {
        for b in a + 1..places.len() {
            for c in b + 1..places.len() {
                if !places.iter().any(|&at| is_in_circle([a, b, c].map(|corner| places[corner]), at)) {
                    edges.extend([(a, b), (b, c), (a, c)]);
                }
            }
        }
    }
    let found = (0..places.len()).flat_map(|a| adjacency.of(a).iter().map(move |&b| (a, b as usize)));
    assert_eq!(found.filter(|(a, b)| a < b).collect::<BTreeSet<_>>(), edges);
}

#[test]
fn a_ridge_with_one_gap_is_passed_through_the_gap() {
    // There is water only in the south, and between it and half of the land a ridge with a gap.
    let mut settings = settings("land=rectangle&attractors=900&aspect=1");
    let coasts = CoastDistance::of_strait(&settings.domain, Vec2::new(-500.0, 960.0), Vec2::new(1500.0, 960.0), 30.0);
    let ridge = |from, to| vec![Vec2::new(from, 500.0), Vec2::new(to, 500.0)];
    let gap = 300.0..420.0;
    let land = Land::new(&settings.domain, coasts, vec![ridge(-1.0, gap.start), ridge(gap.end, 1001.0)]);
    settings.land = Some(land.into());
    let mut growth = Drainage::new(settings).unwrap();
    while growth.tick() {}
    // A few parcels beside the ridge have only edges that cross it.
    assert!(growth.unreached() * 50 < growth.parcels(), "{} are unreached", growth.unreached());
    let tree = growth.tree();
    let steps = (0..tree.len()).filter_map(|node| Some((tree.at[node], tree.at[tree.parent_of(node)?])));
    let across = steps.filter(|(a, b)| (a.y < 500.0) != (b.y < 500.0));
    let crossings: Vec<f32> = across.map(|(a, b)| a.lerp(b, (500.0 - a.y) / (b.y - a.y)).x).collect();
    assert!(!crossings.is_empty() && crossings.iter().all(|x| gap.contains(x)), "{crossings:?}");
}

#[test]
fn the_floor_of_a_valley_carries_its_trunk() {
    const FLOOR: f32 = 420.0;
    for seed in ["kauri", "rimu", "totara"] {
        // Walls rise from the floor to both sides, four times as steeply as the floor rises from the sea in the south.
        let text = format!(
            "country=usual&seed={seed}&land=rectangle&sides=s&aspect=1&attractors=1600&valleys=1&hardness=0&bending=1"
        );
        let mut growth = Drainage::new(settings(&text)).unwrap();
        let heights = growth.parcels.at.iter().map(|at| (at.x - FLOOR).abs() + 0.25 * (1000.0 - at.y)).collect();
        growth.stage = Stage::Invasion(Invasion::over(heights, &growth.parcels).unwrap().into());
        while growth.tick() {}
        let (tree, discharge) = (growth.tree(), Hydrology::of(growth.tree()).discharge);
        // From the sea upward, always to where most of the water comes from.
        let greatest = |of: u32| (0..tree.len()).filter(|&i| tree.parent[i] == of).max_by_key(|&i| discharge[i]);
        let is_great = |node: &usize| discharge[*node] > growth.parcels() / 4;
        let up = |below: Option<usize>| greatest(below.map_or(NO_PARENT, |node| node as u32)).filter(is_great);
        let nodes = std::iter::successors(up(None), |&node| up(Some(node)));
        let trunk: Vec<Vec2> = nodes.map(|node| tree.at[node]).collect();
        let farthest = trunk.iter().map(|at| (at.x - FLOOR).abs()).fold(0.0, f32::max);
        let upper = trunk.iter().map(|at| at.y).fold(f32::INFINITY, f32::min);
        assert!(upper < 500.0, "{seed}: the trunk ends at {upper}");
        assert!(farthest < 3.0 * growth.settings.drainage.spacing, "{seed}: the trunk leaves the floor by {farthest}");
    }
}
