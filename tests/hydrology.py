"""A hydrology library of others reads the game pack: nothing is to be filled, and water gathers where our rivers are.

    python3 tests/hydrology.py target/debug/riverseed

Needs pysheds and Pillow (`make test-hydrology` gets them). It prints what it measures, and fails if a promise is broken.
"""

import io
import json
import subprocess
import sys
import tempfile
import zipfile

import numpy as np
from affine import Affine
from PIL import Image
from pysheds.grid import Grid
from pysheds.view import Raster, ViewFinder
from scipy.ndimage import label

NO_DATA = -1
# North, north-east and so on: the codes of ESRI.
DIRECTIONS = (64, 128, 1, 2, 4, 8, 16, 32)
OFFSETS = ((-1, 0), (-1, 1), (0, 1), (1, 1), (1, 0), (1, -1), (0, -1), (-1, -1))
# How near, in cells, and on which share of the length of rivers of order 2 and more.
NEAR = 2
SHARE = 0.93
# Two readers may part water on slopes in other ways: a cell is our river's if at least this much of its water gathers there.
HALF = 0.5

LINKS = (
    "seed=kauri",
    "seed=rimu&land=archipelago",
    "seed=kea&land=continent",
    "seed=matai&land=valley",
    "seed=totara&land=basin",
    "seed=kauri&land=rectangle",
    "seed=kauri&growth=colonize",
    "seed=rimu&growth=brownian",
    "seed=kea&growth=colonize&curl=0.6&trim=12",
    "seed=saimaa&country=lakeland&lakes=0.7",
)
# The same of a finer grid.
FINER = ("seed=kauri", "--raster-size", "1500")


def pack(program, link, *options):
    """The files that Riverseed writes for a link."""
    with tempfile.NamedTemporaryFile(suffix=".zip") as file:
        subprocess.run([program, "render", link, "-o", file.name, "--size", "64", *options], check=True)
        with zipfile.ZipFile(file.name) as archive:
            return {name: archive.read(name) for name in archive.namelist()}


def picture(files, name):
    image = Image.open(io.BytesIO(files[name]))
    return np.asarray(image).astype(np.int64), image.text


def elevation(heights, land, sea, cell):
    """Heights as pysheds takes them, with a rim of sea: the sea is level, or no data."""
    heights, land = np.pad(heights, 1), np.pad(land, 1)
    values = np.where(land, heights, NO_DATA if sea is None else sea).astype(np.float64)
    view = ViewFinder(affine=Affine(cell, 0, 0, 0, -cell, 0), shape=values.shape, nodata=np.float64(NO_DATA))
    return Raster(values, view)


def with_canals(land):
    """The land with a canal from each lake that lies at the sea's level to the western border: pysheds knows no water that ends
    anywhere else, and would fill the lake and all around it."""
    cut = land.copy()
    lakes, count = label(np.pad(~land, 1, constant_values=True), structure=np.ones((3, 3)))
    for lake in range(2, count + 1):
        row, column = np.argwhere(lakes[1:-1, 1:-1] == lake)[0]
        cut[row, :column] = False
    return cut


def filled(heights, land, sea, cell):
    """How many cells of land pysheds fills. The sea is level."""
    cut = with_canals(land)
    before = elevation(heights, cut, sea, cell)
    grid = Grid(viewfinder=before.viewfinder)
    # It works in place.
    after = [fill(before.copy()) for fill in (grid.fill_pits, grid.fill_depressions)]
    changed = np.any([np.asarray(one) != np.asarray(before) for one in after], axis=0)
    return int(np.sum(changed & np.pad(cut, 1)))


def with_holes(heights, land, sea):
    """The same with one hole of a cell and one of three: both have to be found, or nothing is proved."""
    dug = heights.copy()
    inland = np.zeros_like(heights)
    inland[5:-5, 5:-5] = np.where(land, heights, 0)[5:-5, 5:-5]
    row, column = np.unravel_index(np.argmax(inland), heights.shape)
    dug[row, column] = sea + 1
    inland[max(row - 9, 0) : row + 10, max(column - 9, 0) : column + 10] = 0
    row, column = np.unravel_index(np.argmax(inland), heights.shape)
    dug[row, column - 1 : column + 2] = sea + 1
    return dug


def gathered_by(directions, land):
    """How many cells' water runs through each cell, by our own flow directions."""
    codes = {code: offset for code, offset in zip(DIRECTIONS, OFFSETS)}
    rows, columns = directions.shape
    target = np.full(directions.size, -1)
    for code, (south, east) in codes.items():
        row, column = np.nonzero(directions == code)
        to = (row + south, column + east)
        inside = (0 <= to[0]) & (to[0] < rows) & (0 <= to[1]) & (to[1] < columns)
        target[(row * columns + column)[inside]] = (to[0] * columns + to[1])[inside]
    waiting = np.bincount(target[target >= 0], minlength=directions.size)
    total = np.ones(directions.size)
    ready = list(np.flatnonzero((waiting == 0) & land.ravel()))
    while ready:
        cell = ready.pop()
        to = target[cell]
        if to >= 0:
            total[to] += total[cell]
            waiting[to] -= 1
            if waiting[to] == 0:
                ready.append(to)
    return total.reshape(directions.shape)


def greatest_near(values):
    """The greatest value within two cells, straight and across."""
    out = values.copy()
    padded = np.pad(values, NEAR)
    for south in range(2 * NEAR + 1):
        for east in range(2 * NEAR + 1):
            out = np.maximum(out, padded[south : south + values.shape[0], east : east + values.shape[1]])
    return out


def places(files, size):
    """The middle of each segment of our rivers of order 2 and more, in units, with its length."""
    for feature in json.loads(files["map.geojson"])["features"]:
        if feature["properties"]["kind"] == "river" and feature["properties"]["order"] > 1:
            line = np.array([at[:2] for at in feature["geometry"]["coordinates"]]) * [100, -100] + size / 2
            yield from zip((line[1:] + line[:-1]) / 2, np.hypot(*(line[1:] - line[:-1]).T))


def follow(grid, dem, ours, files, size, cell):
    """Length of our rivers, and of what has, within two cells, a cell that at least half as much water gathers in."""
    flow = grid.flowdir(grid.resolve_flats(dem), dirmap=DIRECTIONS)
    theirs = greatest_near(np.asarray(grid.accumulation(flow, dirmap=DIRECTIONS))[1:-1, 1:-1])
    length = found = 0.0
    for at, way in places(files, size):
        column, row = np.minimum((np.maximum(at, 0) // cell).astype(int), [ours.shape[1] - 1, ours.shape[0] - 1])
        length += way
        found += way * bool(theirs[row, column] >= HALF * ours[row, column])
    return length, found


def check(program, link, *options):
    files = pack(program, link, *options)
    heights, texts = picture(files, "heights.png")
    land = picture(files, "land.png")[0] > 0
    sea, cell = int(texts["sea-level"]), float(texts["units-a-pixel"])
    changed = filled(heights, land, sea, cell)
    assert filled(with_holes(heights, land, sea), land, sea, cell) >= 4, "holes are not found"
    dem = elevation(heights, land, None, cell)
    ours = gathered_by(picture(files, "flow.png")[0], land)
    size = np.array([float(length) for length in texts["map-units"].split(" x ")])
    length, found = follow(Grid(viewfinder=dem.viewfinder), dem, ours, files, size, cell)
    share = found / length if length else 1.0
    called = " ".join((link, *options))
    print(f"{called}: {changed} of {land.sum()} cells filled; {share:.1%} of {length:.0f} units of river found", flush=True)
    return changed == 0 and found >= SHARE * length


if __name__ == "__main__":
    sys.exit(0 if all([check(sys.argv[1], *call) for call in (*zip(LINKS), FINER)]) else 1)
