"""Threads work at the same time, and signals are heard."""

import signal
import sys
import threading
import time
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor

import pytest
from conftest import SMALL

import riverseed

MAKERS: list[Callable[[riverseed.Map], object]] = [
    lambda _: riverseed.grow(SMALL),
    lambda grown: grown.png(size=400),
    lambda grown: grown.zip(size=400),
    lambda grown: grown.svg(),
    lambda grown: grown.json(),
    lambda grown: grown.finer_relief(700),
]

# Longer than any test may take.
LARGE = "attractors=300000&captures=20"


@pytest.fixture
def threads_keep_the_lock() -> Iterator[None]:
    """Let no thread have the interpreter's lock before another gives it away."""
    before = sys.getswitchinterval()
    sys.setswitchinterval(1000)
    yield
    sys.setswitchinterval(before)


@pytest.mark.usefixtures("threads_keep_the_lock")
@pytest.mark.parametrize("make", MAKERS)
def test_other_threads_go_on_while_something_is_made(
    make: Callable[[riverseed.Map], object], small: riverseed.Map
) -> None:
    turns = 0
    is_over = threading.Event()

    def count() -> None:
        nonlocal turns
        while not is_over.is_set():
            turns += 1
            time.sleep(0.001)

    other = threading.Thread(target=count)
    other.start()
    # With the lock held there is never a turn; without, a busy machine may give none for the time of one map.
    seen = 0
    for _ in range(50):
        before = turns
        make(small)
        seen = turns - before
        if seen:
            break
    is_over.set()
    other.join()
    assert seen > 0


def test_maps_made_at_the_same_time_are_the_maps_made_alone() -> None:
    links = [f"{SMALL.replace('Te+Awa', f'word{number}')}" for number in range(6)]

    def drawn(link: str) -> bytes:
        return riverseed.grow(link).png(size=200)

    alone = [drawn(link) for link in links]
    with ThreadPoolExecutor(4) as pool:
        assert list(pool.map(drawn, links)) == alone
    assert len(set(alone)) == len(alone)


def test_threads_that_share_a_map_make_what_one_makes_alone(small: riverseed.Map) -> None:
    makers: list[Callable[[riverseed.Map], bytes]] = [
        lambda grown: grown.png(size=200),
        lambda grown: grown.geojson(),
        lambda grown: grown.raster("heights"),
        lambda grown: grown.zip(size=100),
        lambda grown: grown.svg(),
        lambda grown: grown.relief.heights.tobytes(),
    ]
    alone = [make(small) for make in makers]
    for _ in range(3):
        shared = riverseed.grow(SMALL)
        with ThreadPoolExecutor(len(makers)) as pool:
            assert list(pool.map(lambda make: make(shared), makers)) == alone  # noqa: B023


@pytest.mark.skipif(not hasattr(signal, "SIGALRM"), reason="this system has no alarms")
def test_a_map_in_the_making_can_be_interrupted() -> None:
    heard = 0

    def interrupt(*_: object) -> None:
        # One signal is heard before or after the making of any map, and so perhaps one each. The third comes within.
        nonlocal heard
        heard += 1
        if heard == 3:
            raise KeyboardInterrupt

    before = signal.signal(signal.SIGALRM, interrupt)
    signal.setitimer(signal.ITIMER_REAL, 0.02, 0.02)
    try:
        with pytest.raises(KeyboardInterrupt):
            riverseed.grow(LARGE)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)


@pytest.mark.skipif(not hasattr(signal, "SIGALRM"), reason="this system has no alarms")
def test_a_signals_handler_may_use_the_map_that_it_interrupts() -> None:
    grown = riverseed.grow("attractors=3000&style=ink")
    made: list[bytes] = []

    def use(*_: object) -> None:
        if not made:
            made.append(grown.raster("heights"))

    before = signal.signal(signal.SIGALRM, use)
    signal.setitimer(signal.ITIMER_REAL, 0.01)
    try:
        heights = grown.raster("heights")
        while not made:
            time.sleep(0.001)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
    assert made == [heights]
