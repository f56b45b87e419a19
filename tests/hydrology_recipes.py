"""The recipes of docs/hydrology.md run as they stand there, and what they find is what the page says.

    python3 tests/hydrology_recipes.py target/debug/riverseed

Needs the packages of tests/hydrology.txt (`make test-hydrology` gets them).
"""

import json
import os
import re
import subprocess
import sys
import tempfile
import warnings
from pathlib import Path

import geopandas
import numpy as np
import pyflwdir
import rasterio
import xrspatial
from hydrology import HALF, SHARE, gathered_by, greatest_near

PAGE = Path(__file__).resolve().parent.parent / "docs" / "hydrology.md"
ACROSS = 200_000  # metres, of a map of the usual span


def blocks(text, language):
    return re.findall(rf"^```{language}\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)


def ours():
    """Our heights and directions, as rasterio reads them, with how many cells' water runs through each cell."""
    with rasterio.open("kauri.heights.tif") as heights, rasterio.open("kauri.flow.tif") as flow:
        land, codes, transform = heights.read(1) > 0, flow.read(1).astype(np.int64), flow.transform
    return land, codes, gathered_by(codes, land), transform


def found(gathered):
    """The share of the length of our rivers of order 2 and more near which as much water gathers as ours."""
    land, _, own, transform = ours()
    near, length, share = greatest_near(gathered), 0.0, 0.0
    rivers = geopandas.read_file("kauri.gpkg", layer="rivers")
    for line in rivers[rivers.order > 1].geometry:
        places = np.array(line.coords)[:, :2]
        for start, end in zip(places, places[1:]):
            column, row = ~transform * tuple((start + end) / 2)
            row, column = min(int(row), land.shape[0] - 1), min(int(column), land.shape[1] - 1)
            way = np.hypot(*(end - start))
            length += way
            share += way * bool(near[row, column] >= HALF * own[row, column])
    return share / length


def rasterio_s(names):
    west, south, east, north = names["around"]
    assert -1 < (south + north) / 2 < 1 and west < 10.5 < east, names["around"]
    assert abs(names["cell"] - 2 * ACROSS / np.sqrt(1.6e6)) < 1e-3 and names["land"].any() and not names["land"].all()


def pysheds_s(names):
    land = ours()[0]
    filled = names["grid"].fill_depressions(names["grid"].fill_pits(names["heights"]))
    changed = int(((np.asarray(filled) != np.asarray(names["heights"])) & land).sum())
    share = found(np.asarray(names["gathered"]))
    print(f"pysheds: {changed} cells filled; {share:.1%} of the length of rivers found")
    assert changed == 0 and share >= SHARE


def pyflwdir_s(names):
    land, codes, own, transform = ours()
    assert np.array_equal(names["cells"][land], own[land])
    heights = np.asarray(names["heights"], dtype=np.float32)
    by_heights = pyflwdir.from_dem(np.where(land, heights, -9999), nodata=-9999, transform=transform, latlon=False)
    theirs = (by_heights.to_array("d8") == codes)[land].mean()
    steepest = (np.asarray(names["directions"]) == codes)[land].mean()
    print(
        f"pyflwdir: {names['orders'].max()} orders; {theirs:.0%} of from_dem's directions are ours, of pysheds' {steepest:.0%}"
    )
    assert theirs < 0.7 < 0.9 < steepest, "from_dem is better now, and the page warns of it"


def geopandas_s(names):
    segments, rivers = names["segments"], names["rivers"]
    assert len(names["systems"]) == rivers.parent.isna().sum() == (segments.next == 0).sum()
    assert rivers.crs.to_epsg() == 3035 and np.isfinite(rivers.total_bounds).all()
    ends = segments.groupby("to_node").discharge.sum()
    begins = segments.set_index("from_node").eval("discharge - lateral")
    joined = begins[begins.index.isin(ends.index)]
    assert (joined == ends[joined.index]).all() and (begins[~begins.index.isin(ends.index)] == 0).all()
    for layer in ("land", "lakes", "basins", "oxbow_lakes"):
        # GEOS also refuses polygons whose holes cut their inside in two.
        assert geopandas.read_file("kauri.gpkg", layer=layer).is_valid.all(), layer


def xarray_s(names):
    heights, shade = names["heights"], np.asarray(names["shade"])
    wider = heights.assign_coords(x=heights.x * 10, y=heights.y * 10)
    assert np.array_equal(xrspatial.hillshade(heights), xrspatial.hillshade(wider), equal_nan=True), (
        "it knows the cell size"
    )
    assert np.nanmax(names["slopes"]) < 45 and 0.2 < np.nanmean(shade) < 0.9 and np.nanstd(shade) > 0.02


def topojson_s(names):
    shapes = json.loads(names["topology"].to_json())["objects"]["data"]["geometries"]
    assert {shape["type"] for shape in shapes} >= {"Polygon", "LineString"}


def pillow_s(names):
    values, grey = np.asarray(names["picture"]).astype(float), np.asarray(names["grey"])
    with rasterio.open("kauri.heights.tif") as file:
        metres = file.read(1)
    # Where land is almost level, whole steps raise it.
    assert np.abs((values - names["sea"]) * names["step"] - metres).max() < 2
    assert grey.max() == 255 and grey.std() > 10


CHECKS = (rasterio_s, pysheds_s, pyflwdir_s, geopandas_s, xarray_s, topojson_s, pillow_s)

if __name__ == "__main__":
    program, page = Path(sys.argv[1]).resolve(), PAGE.read_text()
    (command,) = [line for block in blocks(page, "sh") for line in block.splitlines()]
    recipes = blocks(page, "python")
    assert len(recipes) == len(CHECKS), "each recipe has its check"
    warnings.simplefilter("ignore")
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        assert command.startswith("riverseed ")
        subprocess.run(["bash", "-c", command.replace("riverseed", str(program), 1)], check=True)
        names = {}
        for recipe, check in zip(recipes, CHECKS):
            exec(recipe, names)
            check(names)
    print(f"{len(recipes)} recipes of {PAGE.name} run")
