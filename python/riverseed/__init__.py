"""River networks that grow from a word.

A link says everything about a map: a seed, and the parameters that somebody chose. The country, which the seed draws,
decides the others. The same link gives the same map on every machine, to the bit.

>>> import riverseed
>>> kauri = riverseed.grow("seed=kauri", attractors=500)
>>> picture = kauri.png(size=300)
>>> len(kauri.rivers) == len(kauri.rivers.order)
True
>>> kauri.relief.heights.shape == kauri.relief.land.shape
True

A map grows once, however many files and arrays are made of it. Everything long runs without the interpreter's lock, so
threads work at the same time, and hears Ctrl+C.
"""

from importlib.metadata import version as _version
from typing import TYPE_CHECKING

from riverseed import _native
from riverseed._arrays import Distributaries, Lakes, Nodes, Oxbows, Relief, Rivers
from riverseed._map import Map, Name
from riverseed._options import texts as _texts
from riverseed._parameters import Parameter, parameters
from riverseed._summary import Summary

if TYPE_CHECKING:
    from riverseed.widget import Widget as Widget

# Not `Widget`, which needs anywidget: `from riverseed import *` works without.
__all__ = [
    "FORMS",
    "LAYERS",
    "Distributaries",
    "Lakes",
    "Map",
    "Name",
    "Nodes",
    "Oxbows",
    "Parameter",
    "Relief",
    "Rivers",
    "Summary",
    "grow",
    "parameters",
]

__version__ = _version("riverseed")

FORMS = tuple(_native.FORMS)
"""The forms of a file, as the endings of `Map.save` name them."""

LAYERS = tuple(_native.LAYERS)
"""The rasters that `Map.raster` makes."""


def grow(link: str = "", /, **parameters: str | float) -> Map:
    """Grow a map.

    Args:
        link: Link text, such as ``"seed=kauri&curl=0.6"``, the address of a map, or a word.
        parameters: Values over those of the link, by their names with underscores for dashes: ``meander_rounds=20``.

    Raises:
        ValueError: A parameter is unknown or out of its range; the message names it, its value and the range.
        TypeError: A value is neither a text nor a number.
        MemoryError: There is not enough memory.

    >>> import riverseed
    >>> rimu = riverseed.grow("seed=rimu", attractors=500)
    >>> rimu.png(size=200)[1:4]
    b'PNG'
    >>> int(rimu.rivers.parent.min())  # -1: it reaches the sea
    -1
    >>> riverseed.grow("seed=rimu", curl=3)
    Traceback (most recent call last):
    ValueError: curl: 3 is not between 0 and 2
    """
    return Map(_native.grow(link, _texts(parameters)))


def __getattr__(name: str) -> object:
    """Return `Widget`, which is loaded when it is first asked for."""
    if name != "Widget":
        message = f"module 'riverseed' has no attribute {name!r}"
        raise AttributeError(message)
    try:
        from riverseed.widget import Widget
    except ModuleNotFoundError as error:
        message = f"riverseed.Widget needs anywidget, and there is no {error.name}: pip install anywidget"
        raise ImportError(message, name=error.name) from error
    return Widget


def __dir__() -> list[str]:
    """Return all names, for completion: `Widget` too, before it is loaded."""
    return sorted({*globals(), "Widget"})
