"""River networks that grow from a word.

A link says everything about a map: a seed, and parameters that differ from their defaults. The same link gives the
same map on every machine, to the bit.

>>> import riverseed
>>> picture = riverseed.render("seed=kauri&attractors=500", size=300)
>>> network = riverseed.network("seed=kauri", attractors=500)
>>> len(network.rivers) == len(network.rivers.order)
True
>>> relief = riverseed.relief("seed=kauri", attractors=500)
>>> relief.heights.shape == relief.land.shape
True

Every function runs without the interpreter's lock, so threads work at the same time, and hears Ctrl+C.
"""

from importlib.metadata import version as _version
from typing import Literal

from riverseed import _native
from riverseed._maps import Network, Nodes, Oxbows, Relief, Rivers
from riverseed._options import pixels as _pixels
from riverseed._options import texts as _texts

__all__ = [
    "Form",
    "Network",
    "Nodes",
    "Oxbows",
    "Relief",
    "Rivers",
    "network",
    "parameters",
    "relief",
    "render",
]

__version__ = _version("riverseed")

Form = Literal[
    "png",
    "svg",
    "geojson",
    "json",
    "zip",
    "heights.png",
    "land.png",
    "rivers.png",
    "flow.png",
    "basins.png",
]
"""The forms of a file, as the endings of the command line name them."""

_LONGEST_SIDE = 8192
_LONGEST_RASTER = 4096


def render(
    link: str = "",
    /,
    *,
    form: Form = "png",
    size: int | None = None,
    ratio: float | None = None,
    raster_size: int | None = None,
    **parameters: str | float,
) -> bytes:
    """Make a map as the bytes of a file: the same bytes that `riverseed render` writes.

    Args:
        link: Link text, such as ``"seed=kauri&curl=0.6"``.
        form: What to make: ``"png"``, ``"svg"``, ``"geojson"``, ``"json"``, ``"zip"`` for all that games need, or
            one raster of that, such as ``"heights.png"``.
        size: Of ``"png"`` and ``"zip"``, the longer side of the picture in pixels: from 1 to 8192, 1200 unless given.
        ratio: Of ``"png"`` and ``"zip"``, pixels of the screen to a CSS pixel, from 0.5 to 4 in quarters, 1 unless
            given: letters are at least 11 CSS pixels large.
        raster_size: Of rasters and ``"zip"``, the longer side of rasters in pixels: at most 4096; at least, and unless
            given, a pixel for 2 units of the map, which is 500 on a square map.
        parameters: Values over those of the link, by their names with underscores for dashes: ``meander_rounds=20``.

    Raises:
        ValueError: A parameter or an option is unknown or out of its range; the message names it, its value and the
            range.
        TypeError: A value is neither a text nor a number.
        MemoryError: There is not enough memory.

    >>> import riverseed
    >>> riverseed.render("seed=rimu", attractors=500, size=200)[1:4]
    b'PNG'
    >>> riverseed.render("seed=rimu", curl=3)
    Traceback (most recent call last):
    ValueError: curl: 3 is not between 0 and 2
    """
    return _native.render(
        link,
        _texts(parameters),
        form,
        _pixels("size", size, _LONGEST_SIDE),
        ratio,
        _pixels("raster_size", raster_size, _LONGEST_RASTER),
    )


def network(link: str = "", /, **parameters: str | float) -> Network:
    """Grow a map and return its rivers as arrays.

    Args:
        link: Link text, such as ``"seed=kauri&curl=0.6"``.
        parameters: Values over those of the link, by their names with underscores for dashes.

    Raises:
        ValueError: A parameter is unknown or out of its range.
        TypeError: A value is neither a text nor a number.
        MemoryError: There is not enough memory.

    >>> import riverseed
    >>> network = riverseed.network("seed=rimu", attractors=500)
    >>> int(network.rivers.parent.min())  # -1: it reaches the sea
    -1
    """
    fields = _native.network(link, _texts(parameters))
    nodes, rivers, oxbows = (fields.pop(part) for part in ("nodes", "rivers", "oxbows"))
    return Network(nodes=Nodes(**nodes), rivers=Rivers(**rivers), oxbows=Oxbows(**oxbows), **fields)


def relief(link: str = "", /, *, raster_size: int | None = None, **parameters: str | float) -> Relief:
    """Grow a map and return the land that belongs to its rivers as arrays, in any style.

    Args:
        link: Link text, such as ``"seed=kauri&curl=0.6"``.
        raster_size: The longer side of the arrays: at most 4096; at least, and unless given, a cell for 2 units of
            the map, which is 500 on a square map.
        parameters: Values over those of the link, by their names with underscores for dashes.

    Raises:
        ValueError: A parameter is unknown, or it or `raster_size` is out of its range.
        TypeError: A value is neither a text nor a number.
        MemoryError: There is not enough memory.

    >>> import riverseed
    >>> relief = riverseed.relief("seed=rimu&land=island", attractors=500)
    >>> bool(relief.heights[relief.land].min() > 0)
    True
    """
    return Relief(**_native.relief(link, _texts(parameters), _pixels("raster_size", raster_size, _LONGEST_RASTER)))


def parameters() -> dict[str, str]:
    """Return what each parameter does, by its name as a keyword.

    >>> import riverseed
    >>> riverseed.parameters()["seed"]
    'The word that the rivers grow from: any text.'
    """
    return {name.replace("-", "_"): text for name, text in _native.parameters()}
