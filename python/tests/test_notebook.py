"""In a notebook: what a map is shown as, and the widget."""

from __future__ import annotations

import re
import subprocess
import sys
from base64 import b64decode
from importlib import import_module
from importlib.resources import files
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING
from urllib.parse import parse_qs

import numpy as np
import pytest
from PIL import Image

import riverseed

if TYPE_CHECKING:
    from riverseed import Widget

README = Path(__file__).parents[1] / "README.md"
ELEMENT = Path(str(files("riverseed"))) / "static" / "river-seed.classic.js"
HOSTILE = [
    "<script>alert(1)</script>",
    "\"'><img src=x onerror=alert(1)>",
    "../../etc/passwd",
    "</script>\\u003c`${1}`",
    "abc\u202edef\u2066",
    "x" * 64,
]
TINY = "attractors=300&land=island"


@pytest.fixture(scope="session")
def hostile() -> list[riverseed.Map]:
    """Return maps whose seed and title are no good names."""
    return [riverseed.grow(TINY, seed=seed) for seed in HOSTILE]


# ---- the map as an output


def test_a_map_is_a_picture_and_words(small: riverseed.Map) -> None:
    data, metadata = small._repr_mimebundle_()
    assert data["text/plain"] == repr(small)
    picture = Image.open(BytesIO(b64decode(data["image/png"], validate=True)))
    assert picture.size == (1200, round(1200 * small.size[1] / small.size[0]))
    shown = metadata["image/png"]
    assert (shown["width"], shown["height"]) == (800, round(picture.height / 1.5))


def test_only_what_is_wanted_is_made(small: riverseed.Map, monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*_: object, **__: object) -> bytes:
        raise AssertionError

    monkeypatch.setattr(riverseed.Map, "png", refuse)
    assert small._repr_mimebundle_(exclude={"image/png"}) == ({"text/plain": repr(small)}, {})
    assert small._repr_mimebundle_(include=["text/plain"]) == ({"text/plain": repr(small)}, {})
    assert small._repr_mimebundle_(include=["text/html"]) == ({}, {})


def test_the_words_are_the_call_and_its_numbers(small: riverseed.Map) -> None:
    rivers, longest = small.rivers, int(small.rivers.lengths.argmax())
    said = repr(small)
    assert eval(said).link == small.link
    assert said.startswith(f"riverseed.grow({small.link!r})  # {small.title}: {len(rivers)} rivers, ")
    assert f"{small.summary.mouths} of which reach the sea" in said
    assert f"the longest, {rivers.name[longest]}, runs " in said


def test_the_longest_river_is_as_long_as_its_plate_says() -> None:
    map_ = riverseed.grow("country=usual&seed=kauri", cartouche="lengths", attractors=3000)
    longest = int(map_.rivers.lengths.argmax())
    kilometres = f"{map_.rivers.lengths[longest] * map_.metres_a_unit / 1000:.0f} km"
    assert f"{map_.rivers.name[longest]}, {kilometres}" in map_.svg(text=True).decode()
    assert kilometres in repr(map_)


def test_a_map_is_as_wide_as_its_span(small: riverseed.Map) -> None:
    assert small.metres_a_unit * small.size[0] == pytest.approx(small.recipe["span"] * 1000)
    near = riverseed.grow(TINY, country="usual", span=10)
    assert near.metres_a_unit * near.size[0] == pytest.approx(10_000)
    # 25 m a unit at 200 km, and 25 · (10 / 200)^0.4 at 10.
    assert small.metres_a_unit_of_height == pytest.approx(25.0)
    assert near.metres_a_unit_of_height == pytest.approx(7.54, abs=1e-3)
    longest = near.rivers.lengths.max() * near.metres_a_unit / 1000
    assert f"runs {longest:.1f} km" in repr(near)


def test_lengths_are_those_of_the_lines(small: riverseed.Map) -> None:
    for lines in (small.rivers, small.oxbows):
        assert len(lines.lengths) == len(lines) > 0
        for length, line in zip(lines.lengths, lines.lines(), strict=True):
            steps = np.diff(line[:, :2].astype(float), axis=0)
            assert length == pytest.approx(np.hypot(*steps.T).sum(), abs=1e-6)


def test_a_map_without_names_or_rivers_has_words_too() -> None:
    nameless = riverseed.grow(TINY, country="usual", names="t.")
    assert "rivers, " in repr(nameless)
    dry = riverseed.grow("attractors=100&trim=400&land=island")
    empty = riverseed.Rivers(
        points=np.empty((0, 3), np.float32),
        offsets=np.zeros(1, np.int64),
        parent=np.empty(0, np.int32),
        order=np.empty(0, np.uint8),
        magnitude=np.empty(0, np.uint32),
        discharge=np.empty(0, np.uint32),
        identity=np.empty(0, np.uint32),
        name=[],
    )
    assert len(empty.lengths) == 0
    vars(dry)["rivers"] = empty
    assert repr(dry).endswith("no rivers")


def test_a_hostile_seed_is_no_markup_and_turns_no_line(hostile: list[riverseed.Map]) -> None:
    for seed, map_ in zip(HOSTILE, hostile, strict=True):
        data, _ = map_._repr_mimebundle_()
        assert set(data) == {"image/png", "text/plain"}
        assert data["text/plain"].isprintable()
        assert "<" not in map_.link
        assert parse_qs(map_.link)["seed"] == [seed]


def test_a_name_that_would_turn_the_line_does_not() -> None:
    map_ = riverseed.grow(TINY)
    vars(map_)["title"] = "Te\u202eAwa\u2066\u200f"
    assert "# TeAwa: " in repr(map_)


# ---- the widget


@pytest.fixture
def river() -> Widget:
    """Return a widget."""
    if not ELEMENT.is_file():
        pytest.skip("the element is not built (make widget)")
    return riverseed.Widget("seed=kauri", curl=0.4)


def test_a_link_and_its_parameters_follow_each_other(river: Widget) -> None:
    assert river.link == "seed=kauri&edition=1&curl=0.4"
    river.seed = "rimu & totara"
    assert parse_qs(river.link)["seed"] == ["rimu & totara"]
    river.link = "seed=kahikatea&sea=0.5"
    assert (river.seed, river.curl, river.sea) == ("kahikatea", 0.7, 0.5)
    assert river.link == riverseed.Widget(seed="kahikatea", sea=0.5).link


def test_what_is_set_stays_and_auto_leaves_it_to_the_country_again(river: Widget) -> None:
    drawn = river.land
    river.land = "island"
    river.land = "auto"
    assert (river.land, river.link) == (drawn, "seed=kauri&edition=1&curl=0.4")
    river.land = drawn
    assert parse_qs(river.link)["land"] == [drawn]
    for seed in ("rimu", "totara", "kea"):
        river.seed = seed
        assert river.land == drawn


def test_a_parameter_can_be_observed_and_linked(river: Widget) -> None:
    heard: list[object] = []
    river.observe(lambda change: heard.append((change["name"], change["new"])), ["curl", "link"])
    river.curl = np.float32(0.5)
    assert ("curl", 0.5) in heard
    assert ("link", river.link) in heard
    assert len(heard) == 2


def test_a_slider_moves_a_parameter_and_is_moved(river: Widget) -> None:
    ipywidgets = import_module("ipywidgets")  # untyped
    slider = ipywidgets.FloatSlider(0.7, min=0, max=2)
    ipywidgets.link((slider, "value"), (river, "curl"))
    assert river.curl == 0.7
    slider.value = 1.5
    assert (river.curl, parse_qs(river.link)["curl"]) == (1.5, ["1.5"])
    river.link = "seed=kauri&curl=0.2"
    assert slider.value == 0.2


@pytest.mark.usefixtures("river")
def test_what_the_readme_says_of_notebooks_runs() -> None:
    readme = README.read_text()
    assert f"\n{riverseed.grow('seed=kauri')!r}\n" in readme
    examples = re.findall(r"^```py\n(.*?)^```", readme, re.MULTILINE | re.DOTALL)
    assert len(examples) == 2
    known: dict[str, object] = {"riverseed": riverseed}
    for example in examples:
        exec(compile(example, str(README), "exec"), known)
    assert isinstance(known["river"], riverseed.Widget)


def test_all_parameters_are_traits_and_hide_nothing_of_a_widget(river: Widget) -> None:
    from anywidget import AnyWidget

    river.country = "usual"
    for keyword, parameter in riverseed.parameters().items():
        assert not hasattr(AnyWidget, keyword), keyword
        assert river.trait_metadata(keyword, "help") == parameter.help
        if keyword not in ("seed", "curl", "country"):
            assert getattr(river, keyword) == parameter.default


def test_what_is_no_good_is_refused_by_name_and_changes_nothing(river: Widget) -> None:
    before = river.link
    refused: list[tuple[str, object, str]] = [
        ("curl", 3, "curl: 3 is not between 0 and 2"),
        ("curl", "x", "curl: 'x' is not a number in plain digits"),
        ("style", "neon", "style: 'neon' is not one of atlas"),
        ("seed", "x" * 200, "seed: the text has 200 characters, at most 64 are allowed"),
        ("seed", "a\0b", "seed: the text holds a character that cannot be shown"),
        ("meander_rounds", 1000, "meander-rounds: 1000 is not between 0 and 400"),
        ("link", "sead=kauri", "there is no parameter 'sead'"),
        ("speed", 9, "speed: 9.0 is not between 0.25 and 8"),
        ("theme", "<b>", "theme: '<b>' is not one of auto, light, dark"),
    ]
    for name, value, message in refused:
        with pytest.raises(ValueError, match=message):
            setattr(river, name, value)
        assert river.link == before, name
    with pytest.raises(TypeError, match="curl: a text or a number is wanted, not list"):
        river.curl = [1]
    for share in (-0.1, 1.1, float("nan")):
        with pytest.raises(ValueError, match=r"share: .* is not between 0 and 1"):
            river.seek(share)
    with pytest.raises(ValueError, match="there is no parameter 'colour'"):
        riverseed.Widget(colour="red")


def test_a_name_that_a_widget_has_not_is_refused_as_when_it_is_made(river: Widget) -> None:
    before, had = river.link, set(vars(river))
    for name in ("crul", "meander_round", "colour", "x" * 200, "<script>"):
        with pytest.raises(ValueError, match="there is no parameter ") as made:
            riverseed.Widget(**{name: 1})
        for value in (1, "x", [1], None):
            with pytest.raises(ValueError, match="there is no parameter ") as told:
                setattr(river, name, value)
            assert str(told.value) == str(made.value)
    with pytest.raises(ValueError, match="preset: a widget takes it when it is made, and in its link"):
        river.preset = "curl"
    assert (river.link, set(vars(river))) == (before, had)
    assert riverseed.Widget(preset="curl").link == riverseed.Widget("preset=curl").link != riverseed.Widget().link


def test_what_a_widget_has_can_be_set(river: Widget) -> None:
    ipywidgets, traitlets = import_module("ipywidgets"), import_module("traitlets")  # untyped
    layout = ipywidgets.Layout(width="50%")
    for name, value in {"layout": layout, "tabbable": True, "tooltip": "a river", "_mine": 1, "still": True}.items():
        setattr(river, name, value)
        assert getattr(river, name) == value
    river.add_traits(mine=traitlets.Int(1))
    river.mine = 2
    assert river.mine == 2
    river.close()


def test_only_the_browser_says_how_far_it_is(river: Widget) -> None:
    from traitlets import TraitError

    told = {"phase": "growing", "progress": 0.5, "summary": {"nodes": 7}, "shown": "seed=a", "error": {"code": "x"}}
    for name, value in told.items():
        with pytest.raises(TraitError, match=name):
            setattr(river, name, value)
    river.set_state(told)
    assert {name: getattr(river, name) for name in told} == told


def test_a_browser_that_asks_is_answered(river: Widget, monkeypatch: pytest.MonkeyPatch) -> None:
    said: list[object] = []
    monkeypatch.setattr(type(river), "send", lambda _, content: said.append(content))
    contents: list[object] = [{"ask": "heard"}, {"else": 1}, "text", None, []]
    for content in contents:
        river._answer(river, content, [])
    assert said == [{"answer": "heard"}]
    river.seek(0.5)
    river.play()
    river.pause()
    river.play()
    river.restart()
    assert said[1:] == [{"do": "seek", "share": 0.5}, {"do": "play"}, {"do": "restart"}]


def test_a_widget_is_made_of_a_map_and_grows_into_one(river: Widget) -> None:
    river.attractors = 300
    grown = river.grow()
    assert riverseed.Widget(grown).link == river.link == grown.link
    assert repr(river) == f"riverseed.Widget({river.link!r})"
    assert eval(repr(river)).link == river.link


def test_a_hostile_seed_is_escaped_in_all_that_the_browser_gets(river: Widget) -> None:
    scripts = river.get_state()["_esm"]
    for seed in HOSTILE:
        river.seed = seed
        state = river.get_state()
        assert state["_esm"] == scripts
        assert not set("<>\"'`\u202e") & set(state["link"])
        assert "seed" not in state, "only the link goes to the browser"
        bundle = river._repr_mimebundle_()
        assert bundle is not None
        data, _ = bundle
        assert set(data) == {"text/plain", "application/vnd.jupyter.widget-view+json"}
        assert data["text/plain"] == repr(river)


def test_the_element_has_its_notices_beside_it(river: Widget) -> None:
    assert river.get_state()["_esm"].endswith(f"{ELEMENT.read_text()}\n}}\n")
    notices = (ELEMENT.parent / "THIRD-PARTY.txt").read_text()
    assert "  wasm-bindgen " in notices


def run(program: str) -> str:
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    return done.stdout


BLOCKED = "import sys; sys.modules['anywidget'] = None\nimport riverseed\n"


def test_without_anywidget_all_else_works_and_the_widget_says_what_it_needs() -> None:
    program = """
assert "Widget" not in riverseed.__all__ and "Widget" in dir(riverseed)
from riverseed import *
assert repr(riverseed.grow(attractors=100))
try:
    riverseed.Widget
except ImportError as error:
    print(error)
"""
    assert run(BLOCKED + program) == (
        "riverseed.Widget needs anywidget, and there is no anywidget: pip install anywidget\n"
    )


def test_anywidget_is_loaded_for_the_widget_alone() -> None:
    assert run("import riverseed, sys; print({'anywidget', 'ipywidgets', 'traitlets'} & set(sys.modules))") == "set()\n"


def test_a_name_that_is_not_there_is_named() -> None:
    with pytest.raises(AttributeError, match="module 'riverseed' has no attribute 'Wigdet'"):
        riverseed.Wigdet  # noqa: B018


def test_a_package_without_the_element_says_so(tmp_path: Path) -> None:
    program = f"""
import importlib.resources, pathlib
importlib.resources.files = lambda _: pathlib.Path({str(tmp_path)!r})
import riverseed
try:
    riverseed.Widget
except ImportError as error:
    print(error)
"""
    said = run(program)
    assert said.startswith("riverseed.Widget: this package was built without river-seed.classic.js, ")
    for command in ("make wheel", "pip install --force-reinstall --no-deps target/package/riverseed-*.whl"):
        assert f"`{command}`" in said
