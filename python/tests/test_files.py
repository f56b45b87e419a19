"""Files are those of the command line."""

from collections.abc import Callable
from pathlib import Path
from urllib.parse import parse_qs

import pytest
from conftest import SMALL

import riverseed

Rendered = Callable[..., bytes]

MAKERS: dict[str, Callable[[riverseed.Map], bytes]] = {
    "png": lambda map_: map_.png(),
    "svg": lambda map_: map_.svg(),
    "geojson": lambda map_: map_.geojson(),
    "json": lambda map_: map_.json(),
    "zip": lambda map_: map_.zip(),
    "heights.png": lambda map_: map_.raster("heights"),
    "land.png": lambda map_: map_.raster("land"),
    "rivers.png": lambda map_: map_.raster("rivers"),
    "flow.png": lambda map_: map_.raster("flow"),
    "basins.png": lambda map_: map_.raster("basins"),
    "water.png": lambda map_: map_.raster("water"),
    "depth.png": lambda map_: map_.raster("depth"),
}

LANDSCAPES = {"unreal.zip": 1009, "unity.zip": 1025, "godot.zip": 1025}
"""The packs of engines, with a size that is not theirs by default and takes less time."""


def test_every_method_makes_a_form_of_the_library() -> None:
    assert set(MAKERS) | set(LANDSCAPES) < set(riverseed.FORMS)
    assert {f"{layer}.{kind}" for layer in riverseed.LAYERS for kind in ("png", "tif")} < set(riverseed.FORMS)


@pytest.mark.parametrize("form", [form for form in riverseed.FORMS if form not in LANDSCAPES])
def test_every_form_has_the_bytes_of_the_command_line(
    form: str, small: riverseed.Map, rendered: Rendered, tmp_path: Path
) -> None:
    expected = rendered(form, SMALL)
    assert small.file(form) == expected
    if form in MAKERS:
        assert MAKERS[form](small) == expected
    path = tmp_path / f"saved.{form}"
    small.save(path)
    assert path.read_bytes() == expected


@pytest.mark.parametrize(("form", "side"), LANDSCAPES.items())
def test_packs_of_engines_have_the_bytes_of_the_command_line(
    form: str, side: int, small: riverseed.Map, rendered: Rendered
) -> None:
    expected = rendered(form, SMALL, "--size", "50", "--raster-size", str(side))
    assert small.file(form, size=50, raster_size=side) == expected
    message = rf"raster_size: a landscape of this map in \w+( Engine)? is {side}, \d+ or \d+ pixels wide, not 700"
    with pytest.raises(ValueError, match=message):
        small.file(form, raster_size=700)


def test_options_mean_what_they_mean_on_the_command_line(
    small: riverseed.Map, rendered: Rendered, tmp_path: Path
) -> None:
    picture = rendered("png", SMALL, "--size", "300", "--ratio", "1.5")
    assert small.png(size=300, ratio=1.5) == picture
    pack = rendered("zip", SMALL, "--size", "300", "--raster-size", "700")
    assert small.zip(size=300, raster_size=700) == pack
    assert small.raster("flow", raster_size=700) == rendered("flow.png", SMALL, "--raster-size", "700")
    labelled = rendered("svg", SMALL, "--svg-text")
    assert small.svg(text=True) == labelled != small.svg()
    cut = rendered("geojson", SMALL, "--geojson-segments", "--geojson-flat")
    assert small.geojson(segments=True, flat=True) == small.file("geojson", segments=True, flat=True) == cut
    placed = rendered("gpkg", SMALL, "--crs", "EPSG:32633")
    assert small.file("gpkg", crs="EPSG:32633") == placed != small.file("gpkg", crs="none")
    for name, expected in (("a.png", picture), ("a.zip", pack), ("a.svg", labelled)):
        options = {"a.png": {"size": 300, "ratio": 1.5}, "a.zip": {"size": 300, "raster_size": 700}}
        small.save(tmp_path / name, text=name == "a.svg", **options.get(name, {}))  # type: ignore[arg-type]
        assert (tmp_path / name).read_bytes() == expected


def test_a_coordinate_system_is_one_in_metres_and_goes_with_files_that_have_one(small: riverseed.Map) -> None:
    with pytest.raises(ValueError, match=r"crs: 'EPSG:4326' must be none, or EPSG: and the number .* 32601 to 32660"):
        small.file("gpkg", crs="EPSG:4326")
    with pytest.raises(ValueError, match="crs does not go with form 'png'"):
        small.file("png", crs="none")


def test_a_path_is_text_or_a_path_and_its_ending_counts_in_capitals_too(small: riverseed.Map, tmp_path: Path) -> None:
    small.save(str(tmp_path / "Kauri.Flow.PNG"))
    assert (tmp_path / "Kauri.Flow.PNG").read_bytes() == small.raster("flow")


def test_nothing_is_written_if_a_file_is_refused(small: riverseed.Map, tmp_path: Path) -> None:
    (tmp_path / "kept.png").write_bytes(b"before")
    with pytest.raises(ValueError, match="raster_size does not go with form 'png'"):
        small.save(tmp_path / "kept.png", raster_size=700)
    for name in ("map.gif", "map", ".png"):
        with pytest.raises(ValueError, match=rf"path: '{name}' ends with none of \.png, \.svg, "):
            small.save(tmp_path / name)
    with pytest.raises(FileNotFoundError):
        small.save(tmp_path / "nowhere" / "map.png", size=20)
    assert [path.name for path in tmp_path.iterdir()] == ["kept.png"]
    assert (tmp_path / "kept.png").read_bytes() == b"before"


def test_parameters_override_the_link_and_a_preset_comes_first(rendered: Rendered) -> None:
    made = riverseed.grow(
        "seed=kauri&attractors=9000", attractors=600, preset="trimmed-curl", meander_rounds=3, curl=0.5
    )
    words = ["--preset", "trimmed-curl", "seed=kauri&attractors=600&meander-rounds=3&curl=0.5"]
    assert made.json() == rendered("json", *words)


def test_a_seed_is_any_text() -> None:
    for seed in ("川", "Ōtākaro & 🏔️ = 50 %", "ā" * 64, "+"):
        grown = riverseed.grow("attractors=300", seed=seed)
        assert parse_qs(grown.link)["seed"] == [seed]
        assert (riverseed.grow(grown.link).nodes.x == grown.nodes.x).all()


def test_numbers_are_spelled_as_in_links() -> None:
    made = riverseed.grow("attractors=300", valleys=0.00001, sea=0.5, mouths=3, seed="5.0")
    spelled = riverseed.grow("attractors=300&valleys=0.00001&sea=0.5&mouths=3&seed=5.0")
    assert made.link == spelled.link
    assert riverseed.grow(made.link).link == made.link
