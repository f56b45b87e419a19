"""The arrays of a map are the JSON form."""

import json
import pickle
from typing import Any

import numpy as np
import pytest
from conftest import SMALL, is_handed_over
from numpy.typing import NDArray

import riverseed

NODES = ["x", "y", "parent", "tick", "depth", "order", "magnitude", "discharge"]
RIVERS = ["order", "magnitude", "discharge", "identity"]


@pytest.fixture(scope="module")
def form(small: riverseed.Map) -> dict[str, Any]:
    """Return the JSON form of the small map."""
    parsed: dict[str, Any] = json.loads(small.json())
    return parsed


def same(column: NDArray[Any], numbers: list[float]) -> bool:
    """Return whether a column holds these numbers, to the bit."""
    return bool(column.tolist() == np.array(numbers, column.dtype).tolist())


@pytest.mark.parametrize("name", NODES)
def test_nodes_are_the_columns_of_the_json_form(name: str, form: dict[str, Any], small: riverseed.Map) -> None:
    assert len(small.nodes) == len(form["nodes"]["x"]) > 100
    assert same(getattr(small.nodes, name), form["nodes"][name])


@pytest.mark.parametrize("name", RIVERS)
def test_rivers_are_those_of_the_json_form(name: str, form: dict[str, Any], small: riverseed.Map) -> None:
    assert len(small.rivers) == len(form["rivers"]) > 10
    assert same(getattr(small.rivers, name), [river[name] for river in form["rivers"]])


def test_rivers_have_their_parents_and_names(form: dict[str, Any], small: riverseed.Map) -> None:
    parents = [-1 if river["parent"] is None else river["parent"] for river in form["rivers"]]
    assert small.rivers.parent.tolist() == parents
    assert -1 in parents
    assert max(parents) > 0
    assert small.rivers.name == [river["name"] for river in form["rivers"]]
    assert small.title == form["names"][0]["text"]


def test_a_name_that_is_taken_away_is_none(small: riverseed.Map) -> None:
    nameless = riverseed.grow(SMALL, names=f"{small.rivers.identity[0]}.")
    assert nameless.rivers.name[0] is None
    assert nameless.rivers.name[1:] == small.rivers.name[1:]


def test_names_are_those_of_the_json_form(form: dict[str, Any], small: riverseed.Map) -> None:
    listed = [{"kind": name.kind, "identity": name.identity, "text": name.text} for name in small.names]
    assert listed == form["names"]
    assert {name.kind for name in small.names} >= {"title", "sea", "island"}


def test_names_lie_where_geojson_has_them(small: riverseed.Map) -> None:
    features = json.loads(small.geojson())["features"]
    places = {(at["kind"], at["number"]): at for at in (feature["properties"] for feature in features)}
    kinds = {"reach": "LineString", "sea": "Point", "lake": "Point", "island": "Point"}
    kinds |= dict.fromkeys(("gulf", "bay", "cape", "strait", "range"), "Point")
    wanted = [feature["geometry"] for feature in features if feature["properties"]["kind"] in kinds]
    assert places
    named = small.names[1:]
    assert len(wanted) == len(named) > 1
    for name, geometry in zip(named, wanted, strict=True):
        assert geometry["type"] == kinds[name.kind]
        assert np.shape(name.points) == np.reshape(geometry["coordinates"], (-1, 2)).shape
    assert small.names[0].points.shape == (0, 2)


def test_courses_are_those_of_the_json_form(form: dict[str, Any], small: riverseed.Map) -> None:
    for line, river in zip(small.rivers.lines(), form["rivers"], strict=True):
        assert line.tolist() == np.array(river["points"], np.float32).tolist()
    assert small.rivers.line(3).base is not None, "a line is a view"


def test_a_tributary_ends_on_a_point_of_its_parent(small: riverseed.Map) -> None:
    rivers = small.rivers
    joining = np.flatnonzero(rivers.parent >= 0)
    assert len(joining) > 5
    for river in joining.tolist():
        parent = rivers.line(int(rivers.parent[river]))
        assert (parent[:, :2] == rivers.line(river)[-1, :2]).all(axis=1).any()


@pytest.fixture(scope="module")
def lakeland() -> riverseed.Map:
    """Return a small map with lakes along its rivers."""
    return riverseed.grow(SMALL, lakes=0.7, attractors=3000)


def test_lakes_along_rivers_are_those_of_the_json_form(lakeland: riverseed.Map) -> None:
    lakes, listed = lakeland.lakes, json.loads(lakeland.json())["lakes"]
    assert len(lakes) == len(listed) > 3
    assert same(lakes.identity, [lake["identity"] for lake in listed])
    assert same(lakes.area, [lake["area"] for lake in listed])
    assert same(lakes.river, [lake["outlet"]["river"] for lake in listed])
    assert same(lakes.point, [lake["outlet"]["point"] for lake in listed])
    assert lakes.name == [lake["name"] for lake in listed]
    metres = np.float32(lakeland.metres_a_unit_of_height)
    assert np.allclose(lakes.level, np.array([lake["level"] for lake in listed], np.float32) * metres)
    assert np.allclose(lakes.depth, np.array([lake["depth"] for lake in listed], np.float32) * metres)
    for number, lake in enumerate(listed):
        rings = [ring.tolist() for ring in lakes.shores(number)]
        assert rings == [np.array(ring, np.float32).tolist() for ring in lake["rings"]]
    with pytest.raises(IndexError, match=f"there is no lake {len(lakes)}: there are {len(lakes)}"):
        lakes.shores(len(lakes))


def test_a_relief_has_lakes_level_over_their_beds(lakeland: riverseed.Map) -> None:
    relief, lakes = lakeland.relief, lakeland.lakes
    for number in range(len(lakes)):
        cells = relief.lakes == number
        assert (relief.heights[cells] == lakes.level[number]).all()
        assert relief.depths[cells].max() <= lakes.depth[number] * 1.0001
    assert (relief.depths[relief.lakes < 0] == 0).all()
    assert (relief.depths > 0).sum() > 100


def test_distributaries_are_those_of_the_json_form() -> None:
    grown = riverseed.grow(seed="Thornwick", deltas=0.6, style="ink", labels="none")
    branches, listed = grown.distributaries, json.loads(grown.json())["distributaries"]
    assert len(branches) == len(listed) > 4
    assert same(branches.river, [branch["river"] for branch in listed])
    assert same(branches.parent, [-1 if branch["parent"] is None else branch["parent"] for branch in listed])
    assert same(branches.share, [branch["share"] for branch in listed])
    assert same(branches.sea, [branch["sea"] for branch in listed])
    for line, branch in zip(branches.lines(), listed, strict=True):
        assert line.tolist() == np.array(branch["points"], np.float32).tolist()


def test_oxbow_lakes_are_those_of_the_json_form(form: dict[str, Any], small: riverseed.Map) -> None:
    assert len(small.oxbows) == len(form["oxbows"]) > 0
    assert same(small.oxbows.river, [lake["river"] for lake in form["oxbows"]])
    assert same(small.oxbows.born, [lake["born"] for lake in form["oxbows"]])
    for line, lake in zip(small.oxbows.lines(), form["oxbows"], strict=True):
        assert line.tolist() == np.array(lake["points"], np.float32).reshape(-1, 3).tolist()


def test_a_line_that_is_not_there_is_an_error(small: riverseed.Map) -> None:
    for number in (-1, len(small.rivers)):
        with pytest.raises(IndexError, match=f"there is no line {number}: there are {len(small.rivers)}"):
            small.rivers.line(number)


def test_facts_of_a_map_are_those_of_the_json_form(form: dict[str, Any], small: riverseed.Map) -> None:
    summary = small.summary
    growth = {"ticks": summary.ticks, "attractors": summary.attractors, "unreached": summary.unreached}
    assert {**growth, "complete": summary.complete} == form["growth"]
    assert summary.nodes == len(small.nodes)
    assert summary.sources == len(small.rivers)
    assert summary.mouths == np.count_nonzero(small.rivers.parent < 0)
    assert summary.order == small.rivers.order.max()
    assert summary.oxbows == len(small.oxbows)
    assert summary.rounds == 300
    assert summary.shortfall is None
    assert small.size == (np.float32(form["domain"]["width"]), np.float32(form["domain"]["height"]))
    assert small.measures == form["measures"]


def test_the_recipe_holds_every_value_and_gives_the_same_map(form: dict[str, Any], small: riverseed.Map) -> None:
    values = {name.replace("_", "-"): value for name, value in small.recipe.items()}
    assert values == {**{name: values[name] for name in form["resolved"] if name in values}, **form["recipe"]}
    assert set(small.recipe) == set(riverseed.parameters())
    # All values are named then, also those that the country decides.
    assert riverseed.grow(**small.recipe).recipe == small.recipe
    assert riverseed.grow(small.link).link == small.link


def test_a_map_does_not_change(small: riverseed.Map) -> None:
    assert small.rivers is small.rivers
    for name in ("link", "rivers", "relief"):
        with pytest.raises(AttributeError):
            setattr(small, name, None)
    for column in (small.rivers.points, small.rivers.order, small.nodes.x, small.relief.heights, small.names[1].points):
        with pytest.raises(ValueError, match="read-only"):
            column[0] = 0
    values: Any = small.recipe
    with pytest.raises(TypeError):
        values["seed"] = "rata"


def test_files_do_not_depend_on_what_was_made_before(small: riverseed.Map) -> None:
    made = small.json(), small.geojson(), small.svg(), small.png(size=200)
    fresh = riverseed.grow(SMALL)
    assert (fresh.json(), fresh.geojson(), fresh.svg(), fresh.png(size=200)) == made


def test_columns_are_the_memory_that_rust_made(small: riverseed.Map) -> None:
    for name in NODES:
        column: NDArray[Any] = getattr(small.nodes, name)
        assert is_handed_over(column), f"{name} is a copy"
        assert column.flags.c_contiguous
    assert is_handed_over(small.rivers.points)
    assert small.rivers.points.flags.c_contiguous


def test_arrays_outlive_their_map() -> None:
    x = riverseed.grow(SMALL).nodes.x
    assert x.sum() == riverseed.grow(SMALL).nodes.x.sum() > 0


def test_parts_can_be_sent_to_another_process(small: riverseed.Map) -> None:
    rivers: riverseed.Rivers = pickle.loads(pickle.dumps(small.rivers))
    assert (rivers.points == small.rivers.points).all()
    assert rivers.name == small.rivers.name
    relief: riverseed.Relief = pickle.loads(pickle.dumps(small.relief))
    assert (relief.heights == small.relief.heights).all()


def test_a_map_without_rivers_has_empty_arrays() -> None:
    # Ridges all along the coast: no land lies open to the sea.
    no_coast = "land=drawn&roughness=0&aspect=1&outline=.MzMzzMMzzMzMMzzM..M1M1zKM1zKzKM1zKM1M1"
    bare = riverseed.grow(no_coast, attractors=300)
    assert len(bare.nodes) == len(bare.rivers) == len(bare.oxbows) == 0
    assert bare.rivers.points.shape == (0, 3)
    assert bare.rivers.offsets.tolist() == [0]
    assert bare.relief.basins.max() == 0
    assert bare.summary.shortfall == "no-river"
