"""The parts of a map as arrays: the columns of the JSON form, and the rasters.

Lengths are in units: a map has a million square units. x runs east, y runs south. Arrays are read-only, since a map
does not change: `array.copy()` gives one that can be written to.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True, eq=False)
class Nodes:
    """The trimmed tree that rivers are made of, a column each."""

    x: NDArray[np.float32]
    """How far east, in units."""
    y: NDArray[np.float32]
    """How far south, in units."""
    parent: NDArray[np.int32]
    """The node downstream, always earlier in the list; -1 at a mouth."""
    tick: NDArray[np.uint32]
    """The tick in which it grew."""
    depth: NDArray[np.uint32]
    """Nodes to the farthest source."""
    order: NDArray[np.uint8]
    """Strahler's order."""
    magnitude: NDArray[np.uint32]
    """Shreve's magnitude: the number of sources upstream."""
    discharge: NDArray[np.uint32]
    """What is drained at the node and above it."""

    def __len__(self) -> int:
        """Return how many nodes there are."""
        return len(self.x)


@dataclass(frozen=True, eq=False)
class _Lines:
    """Lines whose points stand in one array, line after line."""

    points: NDArray[np.float32]
    """x, y and width of every point, in units: n rows of 3."""
    offsets: NDArray[np.int64]
    """Where each line begins in `points`, and last where the last one ends."""

    def __len__(self) -> int:
        """Return how many lines there are."""
        return len(self.offsets) - 1

    def line(self, number: int) -> NDArray[np.float32]:
        """Return x, y and width of the points of one line, as a view; IndexError if there is none of this number."""
        if not 0 <= number < len(self):
            message = f"there is no line {number}: there are {len(self)}, counted from 0"
            raise IndexError(message)
        return self.points[self.offsets[number] : self.offsets[number + 1]]

    def lines(self) -> Iterator[NDArray[np.float32]]:
        """Return all lines in their order, as views."""
        return map(self.line, range(len(self)))

    @property
    def lengths(self) -> NDArray[np.float64]:
        """The length of each line along its course, in units."""
        steps = np.hypot(*np.diff(self.points[:, :2].astype(np.float64), axis=0).T)
        along = np.zeros(len(self.points) + 1)
        along[1:-1] = np.cumsum(steps)
        first = self.offsets[:-1]
        # A line without points has no last one.
        last = np.maximum(self.offsets[1:] - 1, first)
        return along[last] - along[first]


@dataclass(frozen=True, eq=False)
class Rivers(_Lines):
    """The rivers, a column each, and their courses as lines from source to end.

    A tributary's last point is one of its parent's.
    """

    parent: NDArray[np.int32]
    """The river that it joins; -1 if it reaches the sea."""
    order: NDArray[np.uint8]
    """Strahler's order, at its end."""
    magnitude: NDArray[np.uint32]
    """Shreve's magnitude, at its end."""
    discharge: NDArray[np.uint32]
    """What it drains."""
    identity: NDArray[np.uint32]
    """The number that it keeps, however it is trimmed and shaped."""
    name: list[str | None]
    """Its name; None if the recipe takes it away."""


@dataclass(frozen=True, eq=False)
class Oxbows(_Lines):
    """The lakes that rivers have left, as lines; a line without points is one that silt has closed."""

    river: NDArray[np.uint32]
    """The river that left it."""
    born: NDArray[np.uint32]
    """The round of meandering in which it did."""


@dataclass(frozen=True, eq=False)
class Distributaries(_Lines):
    """The branches of rivers in their deltas, as lines, each after the one that it belongs to. They are no rivers."""

    river: NDArray[np.uint32]
    """The river that divides."""
    parent: NDArray[np.int32]
    """The branch that it is one of the two arms of; -1 if it begins where the river divides."""
    share: NDArray[np.float32]
    """The share of the river's water that it carries."""
    sea: NDArray[np.bool_]
    """True if it ends in the sea, False if it divides."""


@dataclass(frozen=True, eq=False)
class Lakes:
    """The lakes that rivers run through, a column each, the greatest first, and their shores as rings.

    A lake has one outlet. Shores run around the water; the last point of a ring is followed by its first.
    """

    identity: NDArray[np.uint32]
    """The number that it keeps as long as its river and its dam stay."""
    x: NDArray[np.float32]
    """How far east a place in its midst is, in units."""
    y: NDArray[np.float32]
    """How far south, in units."""
    level: NDArray[np.float32]
    """The height of its water: metres above the sea."""
    depth: NDArray[np.float32]
    """Its greatest depth, in metres."""
    area: NDArray[np.float32]
    """The area of its water, in square units."""
    river: NDArray[np.uint32]
    """The river that runs out of it."""
    point: NDArray[np.uint32]
    """The point of that river's course at the outlet."""
    name: list[str | None]
    """Its name; None if it has none, as small lakes do."""
    points: NDArray[np.float32]
    """x and y of the points of all shores, in units: n rows of 2."""
    offsets: NDArray[np.int64]
    """Where each ring begins in `points`, and last where the last one ends."""
    rings: NDArray[np.int64]
    """Where the rings of each lake begin in `offsets`, and last where those of the last one end."""

    def __len__(self) -> int:
        """Return how many lakes there are."""
        return len(self.identity)

    def shores(self, number: int) -> list[NDArray[np.float32]]:
        """Return x and y of the shores of one lake, as views: the outer ring, then those of islands.

        Raises:
            IndexError: There is no lake of this number.
        """
        if not 0 <= number < len(self):
            message = f"there is no lake {number}: there are {len(self)}, counted from 0"
            raise IndexError(message)
        first, end = self.rings[number : number + 2]
        return [self.points[self.offsets[ring] : self.offsets[ring + 1]] for ring in range(first, end)]


@dataclass(frozen=True, eq=False)
class Relief:
    """The land of a map, cell by cell: rows from north to south, in each the cells from west to east."""

    link: str
    """The whole recipe; it gives the same map again."""
    size: tuple[float, float]
    """Width and height of the map, in units: the last row and column may reach beyond."""
    cell_size: float
    """The side of a cell, in units."""
    heights: NDArray[np.float32]
    """Metres above the sea: more than 0 on land, 0 or less at sea. Lakes are as high as their water."""
    depths: NDArray[np.float32]
    """Metres of water over the bed in lakes, 0 elsewhere: `heights` less `depths` is the ground."""
    lakes: NDArray[np.int32]
    """The number of the lake in `riverseed.Lakes`; -1 elsewhere."""
    widths: NDArray[np.float32]
    """The width of the river, in units, rounded up to thousandths; 0 where there is none."""
    flow: NDArray[np.uint8]
    """Where water runs (D8): 1 east, 2 south-east, 4 south, 8 south-west, 16 west, 32 north-west, 64 north, 128
    north-east; 0 at sea."""
    basins: NDArray[np.uint32]
    """The number of the river basin, counted from 1; 0 at sea, and where water runs to the sea in no river."""

    @property
    def land(self) -> NDArray[np.bool_]:
        """True on land, False at sea."""
        return self.heights > 0
