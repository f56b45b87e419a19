//! JSON: each member and column.

use riverseed::analyse::statistics::{Measures, TABLE as TABLE_OF_MEASURES};
use riverseed::export::json as to_json;
use riverseed::grow::{Ending, scatter};
use riverseed::recipe::{self, IntegerKey, Key, NumberKey, is_decided, json as json_recipe, link, table::TABLE};
use riverseed::tree::{Hydrology, NO_PARENT};
use serde_json::Value;

use super::definitions::{course, magnitudes, orders};
use super::{json, list, names, of_all, singles, some, wholes, written};

#[test]
fn members_are_those_that_are_told_of() {
    of_all(|session| {
        let file = json(session);
        let members = [
            "recipe",
            "resolved",
            "domain",
            "growth",
            "measures",
            "pattern",
            "nodes",
            "rivers",
            "oxbows",
            "lakes",
            "distributaries",
            "deltas",
            "names",
            "attractors",
        ];
        assert_eq!(names(&file), members);
        let without = written(|text| to_json::write(text, &session.map().unwrap(), None));
        assert_eq!(names(&without), members[..13]);
    });
}

#[test]
fn recipe_is_the_recipe_with_all_its_values() {
    of_all(|session| {
        let recipe = &json(session)["recipe"];
        let is_left = |key: Key| is_decided(key) && !session.recipe().is_named(key);
        let written: Vec<_> = TABLE.iter().filter(|parameter| !is_left(parameter.key)).collect();
        assert_eq!(names(recipe), written.iter().map(|parameter| parameter.name).collect::<Vec<_>>());
        for parameter in written {
            let value = &recipe[parameter.name];
            match session.recipe().value(parameter.key) {
                recipe::Value::Integer(number) => assert_eq!(value.as_u64(), Some((*number).into())),
                recipe::Value::Number(number) => {
                    assert_eq!(value.as_f64().map(|value| value as f32), Some(number.to_f64() as f32))
                }
                other => assert_eq!(value.as_str().unwrap(), parameter.text_of(other)),
            }
        }
        assert_eq!(json_recipe::read(&json(session).to_string()).as_ref(), Ok(session.recipe()));
    });
}

/// What needs no resolving.
const AS_THEY_ARE: &str = "momentum curl stretch sensitivity trim width bank-variation meander-rounds meander-strength meander-mix meander-elsewhere great-rivers \
                           flat-share neck taper";

#[test]
fn measures_are_those_of_the_rivers() {
    of_all(|session| {
        let (written, measures) = (&json(session)["measures"], Measures::of(&session.map().unwrap()));
        assert_eq!(names(written), TABLE_OF_MEASURES.iter().map(|measure| measure.name).collect::<Vec<_>>());
        for measure in &TABLE_OF_MEASURES {
            let (read, value) = (written[measure.name].as_f64(), (measure.value)(&measures));
            // Readers of JSON may miss the last bit.
            let is_same = read
                .zip(value)
                .map_or(read == value, |(read, value)| (read - value).abs() <= 2.0 * f64::EPSILON * value.abs());
            assert!(is_same, "{}: {read:?}, not {value:?}", measure.name);
        }
    });
}

#[test]
fn patterns_come_with_the_nearest_first() {
    of_all(|session| {
        let (written, measures) = (&json(session)["pattern"], Measures::of(&session.map().unwrap()));
        let Some(pattern) = measures.pattern() else { return assert!(written.is_null()) };
        let expected = pattern.nearest_first();
        assert_eq!(names(written), expected.map(|(name, _)| name));
        for (name, distance) in expected {
            assert_eq!(written[name].as_f64().map(|value| value as f32), Some(distance as f32), "{name}");
        }
    });
}

#[test]
fn lengths_are_resolved() {
    of_all(|session| {
        let (file, recipe) = (json(session), session.recipe());
        let (resolved, domain) = (&file["resolved"], &file["domain"]);
        let near = |value: &Value, expected: f32| {
            let value = value.as_f64().unwrap() as f32;
            assert!((value - expected).abs() <= expected.abs() * 1e-5, "{value} and not {expected}");
        };
        let aspect = recipe.number(NumberKey::Aspect);
        near(&domain["width"], 1000.0 * aspect.sqrt());
        near(&domain["height"], 1000.0 / aspect.sqrt());
        let spacing = resolved["spacing"].as_f64().unwrap() as f32;
        near(&resolved["sea"], recipe.sea());
        if session.land().is_none() {
            near(&resolved["spacing"], (1e6 / recipe.integer(IntegerKey::Attractors) as f32).sqrt());
        }
        for key in [NumberKey::Reach, NumberKey::Kill, NumberKey::Step] {
            near(&resolved[Key::from(key).parameter().name], recipe.number(key) * spacing);
        }
        let is_brownian = recipe.value(Key::Growth) == link::read("growth=brownian").unwrap().value(Key::Growth);
        let between = if is_brownian { recipe.integer(IntegerKey::Sensitivity) as f32 } else { spacing };
        let node_length = if is_brownian { 1.1 } else { resolved["step"].as_f64().unwrap() as f32 };
        near(&resolved["trim-nodes"], (recipe.number(NumberKey::Trim) / node_length).round());
        near(&resolved["simplify"], recipe.number(NumberKey::Simplify) / 100.0);
        near(&resolved["clearance"], recipe.number(NumberKey::Clearance) * between);
        near(&resolved["vertex-spacing"], (0.32 * between).clamp(0.25, 5.0));
        if !is_brownian {
            near(&resolved["total-discharge"], session.growth().attractors() as f32);
        }
        assert_eq!(resolved["total-discharge"], session.growth().total_discharge());
        assert_eq!(resolved["meander"], Key::Meander.parameter().text_of(recipe.value(Key::Meander)));
        assert_eq!(resolved["country"], recipe.country());
        let known = |name: &str| name == "simplify" || AS_THEY_ARE.split(' ').any(|other| other == name);
        let decided: Vec<_> =
            TABLE.iter().filter(|row| is_decided(row.key) && row.key != Key::Sea && !known(row.name)).collect();
        for row in &decided {
            let value = &resolved[row.name];
            let text = value.as_str().map_or_else(|| value.to_string(), String::from);
            assert_eq!(row.parse(&text).as_ref(), Ok(recipe.value(row.key)), "{}", row.name);
        }
        let as_they_are = AS_THEY_ARE.split(' ').map(|name| Key::from_name(name).unwrap());
        let number = |key: Key| key.parameter().text_of(recipe.value(key)).parse().unwrap();
        as_they_are.for_each(|key| near(&resolved[key.parameter().name], number(key)));
        // All there is: what is not named above is looked at nowhere.
        assert_eq!(names(resolved).len(), AS_THEY_ARE.split(' ').count() + 12 + decided.len());
    });
}

#[test]
fn growth_is_what_the_tree_says() {
    of_all(|session| {
        let (growth, tree) = (&json(session)["growth"], session.tree());
        assert_eq!(names(growth), ["ticks", "attractors", "unreached", "complete"]);
        assert_eq!(growth["ticks"], tree.tick_starts.len() - 1);
        assert_eq!(growth["attractors"], session.growth().attractors());
        assert_eq!(growth["unreached"], session.growth().unreached());
        assert_eq!(growth["complete"], session.growth().ending() == Some(Ending::Complete));
    });
}

#[test]
fn nodes_are_those_of_the_trimmed_tree_column_by_column() {
    of_all(|session| {
        let (file, tree, origin) = (json(session), session.tree(), session.pruned().origin);
        let nodes = &file["nodes"];
        assert_eq!(names(nodes), ["x", "y", "parent", "tick", "depth", "order", "magnitude", "discharge"]);
        let old = |i: usize| origin[i] as usize;
        let all = || 0..origin.len();
        assert_eq!(singles(&nodes["x"]), all().map(|i| tree.at[old(i)].x).collect::<Vec<_>>());
        assert_eq!(singles(&nodes["y"]), all().map(|i| tree.at[old(i)].y).collect::<Vec<_>>());
        let parents = wholes(&nodes["parent"]);
        let parent_of = |i: usize| tree.parent[old(i)];
        let is_parent = |i: usize| match parents[i] {
            -1 => parent_of(i) == NO_PARENT,
            parent => origin[parent as usize] == parent_of(i) && (parent as usize) < i,
        };
        assert!(parents.len() == origin.len() && all().all(is_parent));
        let ticks: Vec<i64> = tree.ticks().map(i64::from).collect();
        assert_eq!(wholes(&nodes["tick"]), all().map(|i| ticks[old(i)]).collect::<Vec<_>>());
        let discharge = Hydrology::of(tree).discharge;
        assert_eq!(wholes(&nodes["discharge"]), all().map(|i| discharge[old(i)].into()).collect::<Vec<i64>>());
        let by_definition = by_definition(&parents);
        let columns = [wholes(&nodes["depth"]), wholes(&nodes["order"]), wholes(&nodes["magnitude"])];
        assert_eq!(columns, by_definition);
    });
}

/// Depth, Strahler's order and Shreve's magnitude of the nodes of a tree, of which each stands after its parent.
fn by_definition(parents: &[i64]) -> [Vec<i64>; 3] {
    let mut children = vec![Vec::new(); parents.len()];
    for (i, &parent) in parents.iter().enumerate().filter(|(_, parent)| **parent >= 0) {
        children[parent as usize].push(i);
    }
    let [mut depth, mut order, mut magnitude] = [0, 1, 1].map(|at_source| vec![at_source; parents.len()]);
    for i in (0..parents.len()).rev().filter(|&i| !children[i].is_empty()) {
        let of_children = |column: &[i64]| children[i].iter().map(|&child| column[child]).collect::<Vec<_>>();
        depth[i] = of_children(&depth).into_iter().max().unwrap() + 1;
        magnitude[i] = of_children(&magnitude).into_iter().sum();
        let orders = of_children(&order);
        let highest = orders.iter().copied().max().unwrap();
        order[i] = highest + i64::from(orders.iter().filter(|order| **order == highest).count() > 1);
    }
    [depth, order, magnitude]
}

/// Points as they are written.
fn points(value: &Value) -> Vec<[f32; 3]> {
    list(value).iter().map(|point| <[f32; 3]>::try_from(singles(point)).unwrap()).collect()
}

#[test]
fn rivers_and_lakes_are_the_network_s() {
    of_all(|session| {
        let (file, network) = (json(session), session.network().unwrap());
        let (orders, magnitudes) = (orders(network), magnitudes(network));
        assert_eq!(list(&file["rivers"]).len(), network.rivers.len());
        for (id, (river, written)) in network.rivers.iter().zip(list(&file["rivers"])).enumerate() {
            assert_eq!(
                names(written),
                ["id", "parent", "order", "magnitude", "discharge", "identity", "name", "points"]
            );
            assert_eq!((written["id"].as_u64(), written["parent"].as_u64()), (Some(id as u64), some(river.parent)));
            assert_eq!((&written["order"], &written["magnitude"]), (&orders[id].into(), &magnitudes[id].into()));
            let course: Vec<_> = course(river).into_iter().map(|i| network.vertices[i]).collect();
            assert_eq!(written["discharge"], network.vertices[river.vertex_range()].last().unwrap().discharge);
            let expected = course.iter().map(|vertex| [vertex.at.x, vertex.at.y, vertex.left + vertex.right]);
            assert_eq!(points(&written["points"]), expected.collect::<Vec<_>>());
        }
        assert_eq!(list(&file["oxbows"]).len(), network.oxbows.len());
        for (id, (oxbow, written)) in network.oxbows.iter().zip(list(&file["oxbows"])).enumerate() {
            assert_eq!(names(written), ["id", "river", "born", "points"]);
            assert_eq!(written["id"], id);
            assert_eq!((&written["river"], &written["born"]), (&oxbow.river.into(), &oxbow.born.into()));
            let lake = oxbow.lake();
            let expected = lake.iter().map(|(vertex, share)| [vertex.at.x, vertex.at.y, vertex.width() * share]);
            assert_eq!(points(&written["points"]), expected.collect::<Vec<_>>());
        }
    });
}

#[test]
fn attractors_are_those_that_were_scattered() {
    of_all(|session| {
        let attractors = &json(session)["attractors"];
        assert_eq!(names(attractors), ["x", "y"]);
        let parameters = session.growth().settings();
        let scattered = if session.growth().attractors() > 0 { scatter(parameters) } else { Vec::new() };
        assert_eq!(scattered.len() as u32, session.growth().attractors());
        assert_eq!(singles(&attractors["x"]), scattered.iter().map(|at| at.x).collect::<Vec<_>>());
        assert_eq!(singles(&attractors["y"]), scattered.iter().map(|at| at.y).collect::<Vec<_>>());
    });
}
