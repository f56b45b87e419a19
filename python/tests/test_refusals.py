"""What is no good is refused, with the name, the value and what is allowed."""

import subprocess
import sys
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import riverseed

REFUSED: list[tuple[dict[str, Any], str]] = [
    ({"curl": 3}, "curl: 3 is not between 0 and 2"),
    ({"curl": float("nan")}, "curl: 'nan' is not a number in plain digits"),
    ({"curl": float("inf")}, "curl: 'inf' is not a number in plain digits"),
    ({"curl": -1e300}, "curl: .* is not between 0 and 2"),
    ({"curl": np.float32(2.5)}, "curl: 2.5 is not between 0 and 2"),
    ({"attractors": np.int64(7)}, "attractors: 7 is not between 100 and 1000000"),
    ({"attractors": 10**10_000}, "attractors: the number has too many digits"),
    ({"attractors": 2.5}, "attractors: '2.5' is not a whole number"),
    ({"depth": 3}, "there is no parameter 'depth'"),
    ({"style": "neon"}, "style: 'neon' is not one of atlas, night, "),
    ({"seed": "x" * 1000}, "seed: the text has 1000 characters, at most 64 are allowed"),
    ({"seed": "a\0b"}, "seed: the text holds a character that cannot be shown"),
    ({"edition": 7}, "edition: 7 is unknown here"),
    ({"preset": "best"}, "there is no preset 'best': choose from original, "),
    ({"meander_rounds": 1, "meander-rounds": 2}, "'meander-rounds' is given more than once"),
]


@pytest.mark.parametrize(("parameters", "message"), REFUSED)
def test_parameters_are_refused_in_words_that_help(parameters: dict[str, Any], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        riverseed.grow("seed=kauri", **parameters)


def test_addresses_and_words_are_read_and_damage_is_told() -> None:
    wanted = riverseed.grow("seed=rimu", attractors=100).link
    address = "https://rivers.example/?seed=rimu&attractors=100"
    assert [riverseed.grow(text).link for text in (address, "?seed=rimu&attractors=100")] == [wanted] * 2
    assert riverseed.grow("rimu", attractors=100).link == wanted
    assert riverseed.grow("curl=1", seed=address).link == wanted
    with pytest.warns(UserWarning, match="damaged on its way, and has been mended"):
        assert riverseed.grow("seed=rimu&amp;attractors=100").link == wanted
    with pytest.warns(UserWarning, match="there is no parameter 'utm_source': it is left out"):
        assert riverseed.grow(f"{address}&utm_source=mail").link == wanted


def test_links_are_refused_in_words_that_help() -> None:
    links = {
        "curl=3": "curl: 3 is not between 0 and 2",
        "curl=1&curl=1": "'curl' is given more than once",
        "seed=%FF": "seed: the text holds a character that cannot be shown",
        "seed=" + "x" * 21_000: "link: the text has 21005 characters, at most 20480 are allowed",
        "\0": "seed: the text holds a character that cannot be shown",
        "frog=1": "there is no parameter 'frog'",
        "outline=~~~&land=drawn": "outline: ",
        "seed=\ud800": "surrogates not allowed",
    }
    for link, message in links.items():
        with pytest.raises(ValueError, match=message):
            riverseed.grow(link)


def test_what_is_no_text_is_refused() -> None:
    links: list[Any] = [None, 5, b"seed=kauri", ["seed=kauri"]]
    for link in links:
        with pytest.raises(TypeError, match="str"):
            riverseed.grow(link)
    values: list[Any] = [None, True, b"0.5", [0.5], 1j]
    for value in values:
        with pytest.raises(TypeError, match=f"curl: a text or a number is wanted, not {type(value).__name__}"):
            riverseed.grow("seed=kauri", curl=value)


def test_options_are_refused_in_words_that_help(small: riverseed.Map) -> None:
    raster_range = "raster_size: rasters of this map are from 633 to 4097 pixels long, not 3"
    refused: list[tuple[Callable[..., object], dict[str, Any], str]] = [
        (small.raster, {"layer": "gif"}, "layer: 'gif' is not one of heights, land, rivers, flow, basins"),
        (small.raster, {"layer": "x" * 1000}, "layer: 'x{40}' is not one of heights, "),
        (small.file, {"form": "gif"}, "form: 'gif' is not one of png, svg, "),
        (small.file, {"form": "gpkg", "raster_size": 700}, "raster_size does not go with form 'gpkg'"),
        (small.png, {"size": 0}, "size: 0 is not between 1 and 8192"),
        (small.png, {"size": -5}, "size: -5 is not between 1 and 8192"),
        (small.png, {"size": 8193}, "size: 8193 is not between 1 and 8192"),
        (small.zip, {"size": 2**64}, "size: 18446744073709551616 is not between 1 and 8192"),
        (small.save, {"path": "a.svg", "size": 300}, "size does not go with form 'svg'"),
        (small.save, {"path": "a.json", "ratio": 2}, "ratio does not go with form 'json'"),
        (small.save, {"path": "a.png", "text": True}, "text does not go with form 'png'"),
        (small.png, {"ratio": 0.6}, "ratio: 0.6 is not from 0.5 to 4, in quarters"),
        (small.png, {"ratio": float("nan")}, "ratio: NaN is not from 0.5 to 4, in quarters"),
        (small.zip, {"raster_size": 5000}, "raster_size: 5000 is not between 1 and 4097"),
        (small.zip, {"raster_size": 3}, raster_range),
        (small.raster, {"layer": "flow", "raster_size": 3}, raster_range),
        (small.finer_relief, {"raster_size": 3}, raster_range),
    ]
    for function, options, message in refused:
        with pytest.raises(ValueError, match=message):
            function(**options)
    sizes: list[Any] = [300.0, "300", [300]]
    for size in sizes:
        with pytest.raises(TypeError, match=f"size: a whole number is wanted, not {type(size).__name__}"):
            small.png(size=size)


def test_the_ends_of_the_ranges_are_those_of_the_library() -> None:
    tiny = riverseed.grow("attractors=100&aspect=4")
    assert tiny.png(size=1)
    assert max(tiny.finer_relief(4096).heights.shape) == 4096


def test_a_size_of_numpy_is_a_size(small: riverseed.Map) -> None:
    size: Any = np.int32(50)
    assert small.png(size=size) == small.png(size=50)


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="memory is limited as Linux does it")
def test_too_little_memory_is_a_memory_error() -> None:
    program = """
import resource, riverseed
small = riverseed.grow("attractors=300&style=ink&labels=none")
# Lakes would leave memory behind that is free again.
dense = riverseed.grow("growth=brownian&sensitivity=8&trim=0&meander=none&lakes=0&style=ink&labels=none")
pages = int(open("/proc/self/statm").read().split()[0]) * resource.getpagesize()
makers = {
    "nodes": (1, lambda: dense.nodes),
    "grow": (64, lambda: riverseed.grow(attractors=1_000_000)),
    "png": (64, lambda: small.png(size=8192)),
    "raster": (64, lambda: small.raster("heights", raster_size=4096)),
    "finer_relief": (64, lambda: small.finer_relief(4096)),
}
for name, (megabytes, make) in makers.items():
    resource.setrlimit(resource.RLIMIT_AS, (pages + (megabytes << 20), resource.RLIM_INFINITY))
    try:
        make()
    except MemoryError as error:
        assert " MB, and the allocation failed" in str(error), error
    else:
        raise SystemExit(f"{name}: there was memory")
assert small.png(size=50)
"""
    subprocess.run([sys.executable, "-c", program], check=True)
