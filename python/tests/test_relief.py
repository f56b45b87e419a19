"""The arrays of a relief are the rasters of the command line."""

import io
import zipfile
from typing import Any

import numpy as np
import pytest
from conftest import SMALL, is_handed_over
from numpy.typing import NDArray
from PIL import Image

import riverseed


def read(pack: zipfile.ZipFile, name: str) -> tuple[NDArray[Any], dict[str, str]]:
    """Return the values of a raster of a game pack, and its texts."""
    image = Image.open(io.BytesIO(pack.read(f"{name}.png")))
    return np.asarray(image), {str(key): str(text) for key, text in image.info.items()}


def below(steps: NDArray[Any], flow: NDArray[np.uint8]) -> NDArray[Any]:
    """Return for each cell the value of the cell that its water runs to, or its own where it runs to none."""
    found: NDArray[Any] = steps.copy()
    shifts = {1: (0, 1), 2: (1, 1), 4: (1, 0), 8: (1, -1), 16: (0, -1), 32: (-1, -1), 64: (-1, 0), 128: (-1, 1)}
    for code, shift in shifts.items():
        rows, columns = np.nonzero(flow == code)
        inside = (rows + shift[0]).clip(0, steps.shape[0] - 1), (columns + shift[1]).clip(0, steps.shape[1] - 1)
        found[rows, columns] = steps[inside]
    return found


@pytest.mark.parametrize("size", [None, 700])
def test_arrays_are_the_rasters(size: int | None, small: riverseed.Map) -> None:
    relief = small.finer_relief(size) if size else small.relief
    pack = zipfile.ZipFile(io.BytesIO(small.zip(size=50, raster_size=size)))
    steps, texts = read(pack, "heights")
    metres = (steps.astype(float) - int(texts["sea-level"])) * float(texts["metres-a-step"])
    step = float(texts["metres-a-step"])
    assert relief.heights.shape == steps.shape
    # A height is rounded to half a step, and a step is told in millionths of a metre: most of one more on a summit.
    assert (relief.heights - metres).max() <= step * 1.4
    # Land is a step above the sea at least, and above the cell that its water runs to: level plains rise step by step.
    raised = relief.land & (metres - relief.heights > step * 2)
    assert (steps[raised] == below(steps, relief.flow)[raised] + 1).all()
    assert (relief.land == (read(pack, "land")[0] == 255)).all()
    assert (relief.flow == read(pack, "flow")[0]).all()
    assert (relief.basins == read(pack, "basins")[0]).all()
    widths = read(pack, "rivers")[0]
    assert (np.rint(relief.widths * 1000) == widths).all()
    assert relief.land.any()
    assert not relief.land.all()
    assert relief.basins.max() > 1


def test_cells_cover_the_map(small: riverseed.Map) -> None:
    for relief in (small.relief, small.finer_relief(700)):
        rows, columns = relief.heights.shape
        for cells, length in ((columns, relief.size[0]), (rows, relief.size[1])):
            assert -0.01 < cells * relief.cell_size - length < relief.cell_size + 0.01
    assert small.relief.cell_size == 2
    assert max(small.finer_relief(700).heights.shape) == 700


def test_arrays_have_their_types_and_are_no_copies(small: riverseed.Map) -> None:
    relief = small.relief
    types = {"heights": np.float32, "widths": np.float32, "flow": np.uint8, "basins": np.uint32}
    for name, dtype in types.items():
        array: NDArray[Any] = getattr(relief, name)
        assert array.dtype == dtype
        assert array.flags.c_contiguous
        assert is_handed_over(array), f"{name} is a copy"
    assert relief.land.dtype == np.bool_


def test_there_is_a_relief_in_any_style() -> None:
    inked, atlas = (riverseed.grow(SMALL, style=style).relief for style in ("ink", "atlas"))
    assert (inked.heights == atlas.heights).all()
