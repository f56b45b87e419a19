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

MAKERS: list[Callable[[], object]] = [
    lambda: riverseed.render(SMALL, size=400),
    lambda: riverseed.network(SMALL),
    lambda: riverseed.relief(SMALL),
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
def test_other_threads_go_on_while_a_map_is_made(make: Callable[[], object]) -> None:
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
        make()
        seen = turns - before
        if seen:
            break
    is_over.set()
    other.join()
    assert seen > 0


def test_maps_made_at_the_same_time_are_the_maps_made_alone() -> None:
    seeds = [f"{SMALL.replace('Te+Awa', f'word{number}')}" for number in range(8)]
    alone = [riverseed.render(link, size=200) for link in seeds]
    with ThreadPoolExecutor(4) as pool:
        assert list(pool.map(lambda link: riverseed.render(link, size=200), seeds)) == alone
    assert len(set(alone)) == len(alone)


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
            riverseed.network(LARGE)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
