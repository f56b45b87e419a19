"""What is no good is refused, with the name, the value and what is allowed."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import riverseed

ALL: list[Callable[..., object]] = [riverseed.render, riverseed.network, riverseed.relief]

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
    ({"style": "neon"}, "style: 'neon' is not one of ink, skeleton, "),
    ({"seed": "x" * 1000}, "seed: the text has 1000 characters, at most 64 are allowed"),
    ({"seed": "a\0b"}, "seed: the text holds a character that cannot be shown"),
    ({"edition": 7}, "edition: 7 is unknown here"),
    ({"preset": "best"}, "there is no preset 'best': choose from original, "),
    ({"meander_rounds": 1, "meander-rounds": 2}, "'meander-rounds' is given more than once"),
]


@pytest.mark.parametrize("function", ALL)
@pytest.mark.parametrize(("parameters", "message"), REFUSED)
def test_parameters_are_refused_in_words_that_help(
    function: Callable[..., object], parameters: dict[str, Any], message: str
) -> None:
    with pytest.raises(ValueError, match=message):
        function("seed=kauri", **parameters)


@pytest.mark.parametrize("function", ALL)
def test_links_are_refused_in_words_that_help(function: Callable[..., object]) -> None:
    links = {
        "curl=3": "curl: 3 is not between 0 and 2",
        "curl=1&curl=1": "'curl' is given more than once",
        "seed=%FF": "seed: the text holds a character that cannot be shown",
        "seed=" + "x" * 9000: "link: the text has 9005 characters, at most 8192 are allowed",
        "\0": "there is no parameter",
        "outline=~~~&land=drawn": "outline: ",
        "seed=\ud800": "surrogates not allowed",
    }
    for link, message in links.items():
        with pytest.raises(ValueError, match=message):
            function(link)


@pytest.mark.parametrize("function", ALL)
def test_what_is_no_text_is_refused(function: Callable[..., object]) -> None:
    for link in (None, 5, b"seed=kauri", ["seed=kauri"]):
        with pytest.raises(TypeError, match="str"):
            function(link)
    for value in (None, True, b"0.5", [0.5], 1j):
        with pytest.raises(TypeError, match=f"curl: a text or a number is wanted, not {type(value).__name__}"):
            function("seed=kauri", curl=value)


def test_options_are_refused_in_words_that_help() -> None:
    refused: list[tuple[dict[str, Any], str]] = [
        ({"form": "gif"}, "form: 'gif' is none of png, svg, "),
        ({"form": ""}, "form: '' is none of png, svg, "),
        ({"size": 0}, "size: 0 is not between 1 and 8192"),
        ({"size": -5}, "size: -5 is not between 1 and 8192"),
        ({"size": 8193}, "size: 8193 is not between 1 and 8192"),
        ({"size": 2**64}, "size: 18446744073709551616 is not between 1 and 8192"),
        ({"size": 300, "form": "svg"}, "size does not go with form 'svg'"),
        ({"ratio": 2, "form": "json"}, "ratio does not go with form 'json'"),
        ({"raster_size": 700}, "raster_size does not go with form 'png'"),
        ({"ratio": 0.6}, "ratio: 0.6 is not from 0.5 to 4, in quarters"),
        ({"ratio": float("nan")}, "ratio: NaN is not from 0.5 to 4, in quarters"),
        ({"raster_size": 5000, "form": "zip"}, "raster_size: 5000 is not between 1 and 4096"),
        ({"raster_size": 3, "form": "zip"}, "raster_size: rasters of this map are from 633 to 4096 pixels long, not 3"),
    ]
    for options, message in refused:
        with pytest.raises(ValueError, match=message):
            riverseed.render("seed=kauri", **options)
    with pytest.raises(ValueError, match="raster_size: rasters of this map are from 633 to 4096 pixels long, not 3"):
        riverseed.relief("seed=kauri", raster_size=3)
    for size in (300.0, "300", [300]):
        with pytest.raises(TypeError, match=f"size: a whole number is wanted, not {type(size).__name__}"):
            riverseed.render("seed=kauri", size=size)  # type: ignore[arg-type]


def test_a_size_of_numpy_is_a_size() -> None:
    size: Any = np.int32(50)
    assert riverseed.render("attractors=100", size=size) == riverseed.render("attractors=100", size=50)
