"""The arrays of a network are the JSON form."""

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
def form() -> dict[str, Any]:
    """Return the JSON form of the small map."""
    parsed: dict[str, Any] = json.loads(riverseed.render(SMALL, form="json"))
    return parsed


@pytest.fixture(scope="module")
def network() -> riverseed.Network:
    """Return the small map."""
    return riverseed.network(SMALL)


def same(column: NDArray[Any], numbers: list[float]) -> bool:
    """Return whether a column holds these numbers, to the bit."""
    return bool(column.tolist() == np.array(numbers, column.dtype).tolist())


@pytest.mark.parametrize("name", NODES)
def test_nodes_are_the_columns_of_the_json_form(name: str, form: dict[str, Any], network: riverseed.Network) -> None:
    assert len(network.nodes) == len(form["nodes"]["x"]) > 100
    assert same(getattr(network.nodes, name), form["nodes"][name])


@pytest.mark.parametrize("name", RIVERS)
def test_rivers_are_those_of_the_json_form(name: str, form: dict[str, Any], network: riverseed.Network) -> None:
    assert len(network.rivers) == len(form["rivers"]) > 10
    assert same(getattr(network.rivers, name), [river[name] for river in form["rivers"]])


def test_rivers_have_their_parents_and_names(form: dict[str, Any], network: riverseed.Network) -> None:
    parents = [-1 if river["parent"] is None else river["parent"] for river in form["rivers"]]
    assert network.rivers.parent.tolist() == parents
    assert -1 in parents
    assert max(parents) > 0
    assert network.rivers.name == [river["name"] for river in form["rivers"]]
    assert network.title == form["names"][0]["text"]


def test_a_name_that_is_taken_away_is_none() -> None:
    identity = riverseed.network(SMALL).rivers.identity[0]
    assert riverseed.network(SMALL, names=f"{identity}.").rivers.name[0] is None


def test_courses_are_those_of_the_json_form(form: dict[str, Any], network: riverseed.Network) -> None:
    for line, river in zip(network.rivers.lines(), form["rivers"], strict=True):
        assert line.tolist() == np.array(river["points"], np.float32).tolist()
    assert network.rivers.line(3).base is not None, "a line is a view"


def test_a_tributary_ends_on_a_point_of_its_parent(network: riverseed.Network) -> None:
    rivers = network.rivers
    joining = np.flatnonzero(rivers.parent >= 0)
    assert len(joining) > 5
    for river in joining.tolist():
        parent = rivers.line(int(rivers.parent[river]))
        assert (parent[:, :2] == rivers.line(river)[-1, :2]).all(axis=1).any()


def test_lakes_are_those_of_the_json_form(form: dict[str, Any], network: riverseed.Network) -> None:
    assert len(network.oxbows) == len(form["oxbows"]) > 0
    assert same(network.oxbows.river, [lake["river"] for lake in form["oxbows"]])
    assert same(network.oxbows.born, [lake["born"] for lake in form["oxbows"]])
    for line, lake in zip(network.oxbows.lines(), form["oxbows"], strict=True):
        assert line.tolist() == np.array(lake["points"], np.float32).reshape(-1, 3).tolist()


def test_a_line_that_is_not_there_is_an_error(network: riverseed.Network) -> None:
    for number in (-1, len(network.rivers)):
        with pytest.raises(IndexError, match=f"there is no line {number}: there are {len(network.rivers)}"):
            network.rivers.line(number)


def test_facts_of_a_map_are_those_of_the_json_form(form: dict[str, Any], network: riverseed.Network) -> None:
    growth = {"ticks": network.ticks, "attractors": network.attractors, "unreached": network.unreached}
    assert {**growth, "complete": network.complete} == form["growth"]
    assert network.size == (np.float32(form["domain"]["width"]), np.float32(form["domain"]["height"]))
    assert network.measures == form["measures"]
    assert riverseed.network(network.link).link == network.link


def test_columns_are_the_memory_that_rust_made(network: riverseed.Network) -> None:
    for name in NODES:
        column: NDArray[Any] = getattr(network.nodes, name)
        assert is_handed_over(column), f"{name} is a copy"
        assert column.flags.writeable
        assert column.flags.c_contiguous
    assert is_handed_over(network.rivers.points)
    assert network.rivers.points.flags.c_contiguous


def test_arrays_outlive_their_map() -> None:
    x = riverseed.network(SMALL).nodes.x
    assert x.sum() == riverseed.network(SMALL).nodes.x.sum() > 0


def test_a_network_can_be_sent_to_another_process(network: riverseed.Network) -> None:
    sent: riverseed.Network = pickle.loads(pickle.dumps(network))
    assert (sent.rivers.points == network.rivers.points).all()
    assert sent.link == network.link


def test_a_map_without_rivers_has_empty_arrays() -> None:
    # Ridges all along the coast: no land lies open to the sea.
    no_coast = "land=drawn&roughness=0&aspect=1&outline=.MzMzzMMzzMzMMzzM..M1M1zKM1zKzKM1zKM1M1"
    network = riverseed.network(no_coast, attractors=300)
    assert len(network.nodes) == len(network.rivers) == len(network.oxbows) == 0
    assert network.rivers.points.shape == (0, 3)
    assert network.rivers.offsets.tolist() == [0]
    assert riverseed.relief(no_coast, attractors=300).basins.max() == 0
