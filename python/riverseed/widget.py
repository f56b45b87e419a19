"""A map as a widget of notebooks: Jupyter, JupyterLab, VS Code, Colab and marimo.

It is the element `<river-seed>`, which grows in the reader's browser. Python says what it shows, and hears how far it
is. Needs anywidget (``pip install anywidget``) and a package with the element in it, such as `make wheel` builds in a
clone. Use it as `riverseed.Widget`.
"""

from collections.abc import Mapping
from importlib.resources import files
from typing import Any

import traitlets
from anywidget import AnyWidget

from riverseed import _native
from riverseed._map import Map
from riverseed._options import by_keyword, texts
from riverseed._parameters import parameters

_PARAMETERS = parameters()

_OPTIONS = ("still", "controls", "speed", "theme", "alt", "paused", "layout")

_THEMES = ("auto", "light", "dark")
_LEAST_SPEED, _MOST_SPEED = 0.25, 8

ELEMENT = "river-seed.classic.js"
"""The file of the element, with all that it needs, as `make widget` builds it."""


def _module() -> str:
    """Return the script of the widget, and with it the element, which it defines on a page that has none."""
    folder = files("riverseed").joinpath("static")
    try:
        element = folder.joinpath(ELEMENT).read_text(encoding="utf-8")
    except FileNotFoundError:
        message = (
            f"riverseed.Widget: this package was built without {ELEMENT}, the element that the widget shows; "
            "run `make wheel` in a clone of the repository, "
            "then `pip install --force-reinstall --no-deps target/package/riverseed-*.whl`"
        )
        raise ImportError(message) from None
    script = folder.joinpath("widget.js").read_text(encoding="utf-8")
    return f"{script}\nfunction defineElement() {{\n{element}\n}}\n"


class Widget(AnyWidget):
    """A map that grows in a notebook.

    Every parameter is a trait by its keyword, and so is `link`, which has all of them: what is set changes the rest, in
    Python and before the reader's eyes. What the reader's browser tells is in traits that can only be read: `phase`,
    `progress`, `summary`, `shown` and `error`.

    >>> import riverseed
    >>> river = riverseed.Widget("seed=kauri", curl=0.4)
    >>> river.link
    'seed=kauri&edition=1&curl=0.4'
    >>> river.seed = "rimu"
    >>> river.link
    'seed=rimu&edition=1&curl=0.4'
    >>> river.curl = 3
    Traceback (most recent call last):
    ValueError: curl: 3 is not between 0 and 2
    >>> river.crul = 1
    Traceback (most recent call last):
    ValueError: there is no parameter 'crul'
    """

    _esm = _module()
    _is_made = False

    link = traitlets.Unicode(help="The whole recipe, as a link.").tag(sync=True)
    still = traitlets.Bool(False, help="Shows the finished map at once.").tag(sync=True)
    controls = traitlets.Bool(False, help="Always shows the button that plays and pauses.").tag(sync=True)
    speed = traitlets.Float(1.0, help="How fast the rivers grow, as a multiple of the ordinary speed.").tag(sync=True)
    theme = traitlets.Unicode("auto", help="The page's colour scheme: auto, light or dark.").tag(sync=True)
    alt = traitlets.Unicode(None, allow_none=True, help="The text alternative; by itself, a sentence.").tag(sync=True)
    paused = traitlets.Bool(False, help="True while growth is paused, by the reader or from Python.").tag(sync=True)

    phase = traitlets.Unicode("idle", read_only=True, help="How far the rivers are, in a word.").tag(sync=True)
    progress = traitlets.Float(0.0, read_only=True, help="How far the rivers are, from 0 to 1.").tag(sync=True)
    summary = traitlets.Dict(None, allow_none=True, read_only=True, help="The rivers in numbers.").tag(sync=True)
    shown = traitlets.Unicode(
        "",
        read_only=True,
        help="The link of what is seen: within the element's limits, and by night on a dark page.",
    ).tag(sync=True)
    error = traitlets.Dict(
        None, allow_none=True, read_only=True, help="Why there is no map: code, message and advice."
    ).tag(sync=True)

    # A trait for every parameter. Browsers read the link, which has them all.
    locals().update({name: traitlets.Any(one.default, help=one.help) for name, one in _PARAMETERS.items()})

    def __init__(self, link: str | Map = "", /, **options: object) -> None:
        """Make a widget of a map.

        Args:
            link: Link text, such as ``"seed=kauri&curl=0.6"``, the address of a map, a word, or a map.
            options: Values of parameters, as for `riverseed.grow`; ``still``, ``controls``, ``speed``, ``theme``,
                ``alt`` and ``paused``; ``layout``, as for all widgets.

        Raises:
            ValueError: A parameter or an option is unknown or out of its range.
            TypeError: A value is neither a text nor a number.
        """
        given = {name: options.pop(name) for name in _OPTIONS if name in options}
        link, values = _native.read(link.link if isinstance(link, Map) else link, texts(options))
        super().__init__(link=link, **by_keyword(values), **given)
        self._is_made = True
        self.on_msg(self._answer)

    def __setattr__(self, name: str, value: object) -> None:
        """Set a trait. A public name that the class has not is refused, since setting it would not change the map.

        Raises:
            ValueError: There is no parameter or option of this name, or it is ``preset``.
        """
        if name == "preset":
            message = "preset: a widget takes it when it is made, and in its link"
            raise ValueError(message)
        if name in _PARAMETERS and self._is_made:
            # Named in the link, even if its country has drawn that value; `auto` is the opposite.
            self.link = _native.read(self.link, texts({name: value}))[0]
        elif name.startswith("_") or hasattr(type(self), name):
            super().__setattr__(name, value)
        else:
            _native.read("", texts({name: ""}))  # which says that there is no such parameter

    def __repr__(self) -> str:
        """Return the call that makes the widget."""
        return f"riverseed.Widget({self.link!r})"

    def grow(self) -> Map:
        """Grow the map in Python too, for its files and arrays."""
        return Map(_native.grow(self.link, []))

    def play(self) -> None:
        """Continue; let a finished map grow again."""
        if self.paused:
            self.paused = False
        else:
            self.send({"do": "play"})

    def pause(self) -> None:
        """Pause until `play`."""
        self.paused = True

    def restart(self) -> None:
        """Let the map grow again from the start; after an error, try again."""
        self.paused = False
        self.send({"do": "restart"})

    def seek(self, share: float) -> None:
        """Go to a share of the way to the finished map, and pause there.

        Args:
            share: From 0 to 1.

        Raises:
            ValueError: It is not in that range.
        """
        if not 0 <= share <= 1:
            message = f"share: {share} is not between 0 and 1"
            raise ValueError(message)
        self.send({"do": "seek", "share": float(share)})

    def _answer(self, _widget: object, content: object, _buffers: object) -> None:
        """Answer the browser, which asks whether anybody hears it."""
        if isinstance(content, Mapping) and "ask" in content:
            self.send({"answer": content["ask"]})

    @traitlets.validate("link")
    def _read_link(self, proposal: Mapping[str, Any]) -> str:
        return _native.read(proposal["value"], [])[0]

    @traitlets.observe("link")
    def _follow_link(self, change: Mapping[str, Any]) -> None:
        for keyword, value in by_keyword(_native.read(change["new"], [])[1]).items():
            self.set_trait(keyword, value)

    @traitlets.validate(*_PARAMETERS)
    def _read_parameter(self, proposal: Mapping[str, Any]) -> object:
        name = proposal["trait"].name
        return by_keyword(_native.read(self.link, texts({name: proposal["value"]}))[1])[name]

    @traitlets.observe(*_PARAMETERS)
    def _follow_parameter(self, change: Mapping[str, Any]) -> None:
        name, value = change["name"], change["new"]
        # What follows the link, as the values of its country do, is not named in it.
        if by_keyword(_native.read(self.link, [])[1])[name] != value:
            self.link = _native.read(self.link, texts({name: value}))[0]

    @traitlets.validate("speed")
    def _check_speed(self, proposal: Mapping[str, Any]) -> float:
        speed = float(proposal["value"])
        if not _LEAST_SPEED <= speed <= _MOST_SPEED:
            message = f"speed: {speed} is not between {_LEAST_SPEED} and {_MOST_SPEED}"
            raise ValueError(message)
        return speed

    @traitlets.validate("theme")
    def _check_theme(self, proposal: Mapping[str, Any]) -> str:
        theme = str(proposal["value"])
        if theme not in _THEMES:
            message = f"theme: {theme[:40]!r} is not one of {', '.join(_THEMES)}"
            raise ValueError(message)
        return theme
