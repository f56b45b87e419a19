"""Files are those of the command line."""

from collections.abc import Callable
from typing import get_args
from urllib.parse import parse_qs

import pytest
from conftest import SMALL

import riverseed

Rendered = Callable[..., bytes]


@pytest.mark.parametrize("form", get_args(riverseed.Form))
def test_every_form_has_the_bytes_of_the_command_line(form: riverseed.Form, rendered: Rendered) -> None:
    assert riverseed.render(SMALL, form=form) == rendered(form, SMALL)


def test_options_mean_what_they_mean_on_the_command_line(rendered: Rendered) -> None:
    picture = riverseed.render(SMALL, form="png", size=300, ratio=1.5)
    assert picture == rendered("png", SMALL, "--size", "300", "--ratio", "1.5")
    pack = riverseed.render(SMALL, form="zip", size=300, raster_size=700)
    assert pack == rendered("zip", SMALL, "--size", "300", "--raster-size", "700")


def test_parameters_override_the_link_and_a_preset_comes_first(rendered: Rendered) -> None:
    made = riverseed.render(
        "seed=kauri&attractors=9000", form="json", attractors=600, preset="trimmed-curl", meander_rounds=3, curl=0.5
    )
    words = ["--preset", "trimmed-curl", "seed=kauri&attractors=600&meander-rounds=3&curl=0.5"]
    assert made == rendered("json", *words)


def test_a_seed_is_any_text() -> None:
    for seed in ("川", "Ōtākaro & 🏔️ = 50 %", "ā" * 64, "+"):
        network = riverseed.network("attractors=300", seed=seed)
        assert parse_qs(network.link)["seed"] == [seed]
        assert (riverseed.network(network.link).nodes.x == network.nodes.x).all()


def test_numbers_are_spelled_as_in_links() -> None:
    made = riverseed.network("attractors=300", valleys=0.00001, sea=0.5, mouths=3, seed="5.0")
    spelled = riverseed.network("attractors=300&valleys=0.00001&sea=0.5&mouths=3&seed=5.0")
    assert made.link == spelled.link
    assert riverseed.network(made.link).link == made.link
