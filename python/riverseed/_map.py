"""The finished map: its files, and its parts as data."""

import os
from base64 import b64encode
from collections.abc import Collection, Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from riverseed import _native
from riverseed._arrays import Distributaries, Lakes, Nodes, Oxbows, Relief, Rivers
from riverseed._options import by_keyword, pixels
from riverseed._summary import Summary
from riverseed._words import describe

# The picture in a notebook: as wide as its text, and sharp on screens of more than a pixel to a CSS pixel.
_SHOWN_SIZE, _SHOWN_RATIO = 1200, 1.5


@dataclass(frozen=True, eq=False)
class Name:
    """The name of the map, a reach or a place."""

    kind: str
    """``"title"``, ``"reach"``, ``"sea"``, ``"gulf"``, ``"lake"``, ``"island"``, ``"bay"``, ``"cape"``, ``"strait"`` or
    ``"range"``."""
    identity: int | None
    """The identity of a reach's river or the number in a place's mark (0 for the main land); None for the title."""
    text: str | None
    """The name; None if the recipe takes it away."""
    points: NDArray[np.float32]
    """Where it is, in units, in rows of x and y: the course of a reach, a point in the midst of a place, none for the
    title."""


@dataclass(frozen=True, eq=False, repr=False)
class Map:
    """A finished map, as `riverseed.grow` makes it.

    It does not change, and any number of threads may use it at the same time. What is a property is made when it is
    first asked for, and kept; files are made anew each time, but for the relief that some of them share.

    A method that makes something raises MemoryError if there is not enough memory for it.
    """

    _grown: _native.Map

    def __repr__(self) -> str:
        """Return the call that grows the map and, as a comment, the map in a sentence."""
        return describe(self.link, self.title, self.summary, self.rivers, self._grown.kilometres)

    def _repr_mimebundle_(
        self, include: Collection[str] | None = None, exclude: Collection[str] | None = None
    ) -> tuple[dict[str, str], dict[str, Any]]:
        """Return what a notebook shows: the picture, and `repr` where there are no pictures."""
        wanted = {"image/png", "text/plain"} if include is None else set(include)
        wanted -= set(exclude or ())
        data, metadata = {}, {}
        if "text/plain" in wanted:
            data["text/plain"] = repr(self)
        if "image/png" in wanted:
            picture = self.png(size=_SHOWN_SIZE, ratio=_SHOWN_RATIO)
            data["image/png"] = b64encode(picture).decode()
            metadata["image/png"] = _shown_size(picture)
        return data, metadata

    def png(self, *, size: int | None = None, ratio: float | None = None) -> bytes:
        """Return the picture as a PNG file.

        Args:
            size: The longer side in pixels: from 1 to 8192, 1200 unless given.
            ratio: Pixels of the screen to a CSS pixel, from 0.5 to 4 in quarters, 1 unless given: letters are at least
                11 CSS pixels large.

        Raises:
            ValueError: An option is out of its range.
        """
        return self._file("png", size=size, ratio=ratio)

    def svg(self, *, text: bool = False) -> bytes:
        """Return the map as an SVG file.

        Args:
            text: Whether labels are text on paths, for readers that have EB Garamond, and not outlines.
        """
        return self._file("svg", text=text)

    def geojson(self, *, segments: bool = False, flat: bool = False) -> bytes:
        """Return the rivers, coasts and ridges as a GeoJSON file, for geographic information systems.

        Args:
            segments: Whether rivers are there once more, cut at their confluences: a graph.
            flat: Whether heights are left out, for readers that want all positions in two dimensions.
        """
        return self._file("geojson", segments=segments, flat=flat)

    def json(self) -> bytes:
        """Return the network as a JSON file: all that is known of it."""
        return self._file("json")

    def zip(self, *, size: int | None = None, ratio: float | None = None, raster_size: int | None = None) -> bytes:
        """Return the game pack: the picture, all rasters and the GeoJSON file in one ZIP file.

        Args:
            size: As for `png`.
            ratio: As for `png`.
            raster_size: As for `raster`.

        Raises:
            ValueError: An option is out of its range.
        """
        return self._file("zip", size=size, ratio=ratio, raster_size=raster_size)

    def raster(self, layer: str, *, raster_size: int | None = None) -> bytes:
        """Return one raster as a PNG file; `relief` has the same as arrays.

        Args:
            layer: One of `riverseed.LAYERS`, such as ``"heights"``.
            raster_size: The longer side in pixels: at most 4097; at least, and unless given, a pixel for 2 units of the
                map, which is 500 on a square map.

        Raises:
            ValueError: There is no such layer, or `raster_size` is out of its range.
        """
        if layer not in _native.LAYERS:
            message = f"layer: {str(layer)[:40]!r} is not one of {', '.join(_native.LAYERS)}"
            raise ValueError(message)
        return self._file(f"{layer}.png", raster_size=raster_size)

    def file(
        self,
        form: str,
        *,
        size: int | None = None,
        ratio: float | None = None,
        raster_size: int | None = None,
        text: bool = False,
        segments: bool = False,
        flat: bool = False,
        crs: str | None = None,
    ) -> bytes:
        """Return a file in any form, also for plotters (on A4), game engines and geographic information systems.

        Args:
            form: One of `riverseed.FORMS`.
            size: As for `png`.
            ratio: As for `png`.
            raster_size: As for `raster`; for an engine one of its own sizes.
            text: As for `svg`.
            segments: As for `geojson`.
            flat: As for `geojson`.
            crs: The coordinate system that GeoTIFF and GeoPackage say they have, such as ``"EPSG:32633"``, or
                ``"none"``; the map's own, which lies nowhere on Earth, unless given.

        Raises:
            ValueError: There is no such form, an option does not go with it or is out of its range.
        """
        return self._file(
            form, size=size, ratio=ratio, raster_size=raster_size, text=text, segments=segments, flat=flat, crs=crs
        )

    def save(
        self,
        path: str | os.PathLike[str],
        *,
        size: int | None = None,
        ratio: float | None = None,
        raster_size: int | None = None,
        text: bool = False,
        segments: bool = False,
        flat: bool = False,
        crs: str | None = None,
    ) -> None:
        """Write a file in the form that the ending of its path names, one of `riverseed.FORMS`.

        The file is opened once all of its bytes are made.

        Args:
            path: Where to write: ``"kauri.png"``, say, or ``"kauri.heights.png"`` for one raster.
            size: As for `png`.
            ratio: As for `png`.
            raster_size: As for `raster`.
            text: As for `svg`.
            segments: As for `geojson`.
            flat: As for `geojson`.
            crs: As for `file`.

        Raises:
            ValueError: The path has no known ending, an option does not go with it or is out of its range.
            OSError: The file cannot be written.
        """
        form = _native.form_of_file(Path(path).name)
        Path(path).write_bytes(
            self._file(
                form, size=size, ratio=ratio, raster_size=raster_size, text=text, segments=segments, flat=flat, crs=crs
            )
        )

    def _file(
        self,
        form: str,
        *,
        size: int | None = None,
        ratio: float | None = None,
        raster_size: int | None = None,
        text: bool = False,
        segments: bool = False,
        flat: bool = False,
        crs: str | None = None,
    ) -> bytes:
        options = {
            "size": pixels("size", size, _native.LONGEST_SIDE),
            "ratio": ratio,
            "raster_size": pixels("raster_size", raster_size, _native.LONGEST_RASTER),
            "text": text,
            "segments": segments,
            "flat": flat,
            "crs": crs,
        }
        return self._grown.file(form, options)

    @cached_property
    def link(self) -> str:
        """The whole recipe as a link; it gives the same map again."""
        return self._grown.link()

    @cached_property
    def recipe(self) -> Mapping[str, str | int | float]:
        """The value of each parameter, by its name as a keyword: `riverseed.grow(**recipe)` gives the same map."""
        return MappingProxyType(by_keyword(self._grown.recipe()))

    @cached_property
    def size(self) -> tuple[float, float]:
        """Width and height of the map, in units."""
        return self._grown.size()

    @cached_property
    def metres_a_unit(self) -> float:
        """How many metres a unit is on the ground: the map is as many kilometres wide as its `span` says."""
        return self._grown.scale()[0]

    @cached_property
    def metres_a_unit_of_height(self) -> float:
        """How many metres a unit of height is."""
        return self._grown.scale()[1]

    @cached_property
    def title(self) -> str | None:
        """The name of the map; None if the recipe takes it away."""
        return self.names[0].text

    @cached_property
    def summary(self) -> Summary:
        """The map in numbers."""
        return Summary(**self._grown.summary())

    @cached_property
    def measures(self) -> Mapping[str, float | None]:
        """What is measured of the network, by the names of the JSON form; None where it is too small."""
        return MappingProxyType(self._grown.measures())

    @cached_property
    def names(self) -> tuple[Name, ...]:
        """All names but those of rivers: the title, reaches, seas, lakes and islands, as the JSON form lists them."""
        return tuple(Name(**fields) for fields in self._grown.names())

    @cached_property
    def nodes(self) -> Nodes:
        """The trimmed tree that rivers are made of."""
        return Nodes(**self._grown.nodes())

    @cached_property
    def rivers(self) -> Rivers:
        """The rivers, with their names and courses."""
        return Rivers(**self._grown.rivers())

    @cached_property
    def oxbows(self) -> Oxbows:
        """The lakes that rivers have left."""
        return Oxbows(**self._grown.oxbows())

    @cached_property
    def distributaries(self) -> Distributaries:
        """The branches of rivers in their deltas."""
        return Distributaries(**self._grown.distributaries())

    @cached_property
    def lakes(self) -> Lakes:
        """The lakes that rivers run through."""
        return Lakes(**self._grown.lakes())

    @cached_property
    def relief(self) -> Relief:
        """The land that belongs to the rivers, on cells of 2 units, in any style."""
        return self._relief(None)

    def finer_relief(self, raster_size: int) -> Relief:
        """Return the relief on smaller cells. It is made anew, and not kept.

        Args:
            raster_size: The longer side of the arrays: at least that of `relief`, and at most 4097.

        Raises:
            ValueError: `raster_size` is out of its range.
        """
        return self._relief(raster_size)

    def _relief(self, raster_size: int | None) -> Relief:
        return Relief(**self._grown.relief(pixels("raster_size", raster_size, _native.LONGEST_RASTER)))


def _shown_size(picture: bytes) -> dict[str, int]:
    """Return width and height in CSS pixels, of those in the head of a PNG file."""
    width, height = (int.from_bytes(picture[at : at + 4], "big") for at in (16, 20))
    return {"width": round(width / _SHOWN_RATIO), "height": round(height / _SHOWN_RATIO)}
