"""What all tests share."""

import os
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import riverseed

SMALL = (
    "country=usual&seed=Te+Awa&land=island&sea=0.55&attractors=1500&trim=8&channel-area=2&width=10&labels=some"
    "&meander=flow&meander-rounds=300&meander-elsewhere=1&great-rivers=5&oxbows=1"
)
"""A map that takes a moment, with rivers, lakes and names."""


def is_handed_over(array: NDArray[Any]) -> bool:
    """Return whether an array lies in memory that is not NumPy's: a copy would."""
    owner: object = array
    while isinstance(owner, np.ndarray):
        if owner.flags.owndata:
            return False
        owner = owner.base
    return owner is not None


@pytest.fixture(scope="session")
def program() -> Path:
    """Return the command line, by which bytes are judged."""
    return Path(os.environ["RIVERSEED_PROGRAM"])


@pytest.fixture(scope="session")
def small() -> riverseed.Map:
    """Return the small map, grown once for all tests: it does not change."""
    return riverseed.grow(SMALL)


@pytest.fixture
def rendered(program: Path, tmp_path: Path) -> Callable[..., bytes]:
    """Return what renders a file by the command line."""

    def render(form: str, *words: str) -> bytes:
        output = tmp_path / f"map.{form}"
        subprocess.run([program, "render", *words, "-o", output], check=True)
        return output.read_bytes()

    return render
