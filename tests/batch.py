"""The program of docs/batch.md on a local cluster: what its workers make is what one plain call makes, byte for byte, also if one of them is
killed.

    python3 tests/batch.py target/debug/riverseed

Needs Dask (`make test-batch` gets it). It says what it has compared, and fails if a promise is broken.
"""

import json
import os
import re
import signal
import subprocess
import sys
import tempfile
from pathlib import Path

import dask.bag
from dask.distributed import Client, LocalCluster

PAGE = Path(__file__).parent.parent / "docs" / "batch.md"
SEEDS = [*map(str, range(1, 21)), "Te Awa", "../kea", "\u014dhau", "con"]
PARTITION = 6


def page_s_program():
    """The program on the page."""
    (program,) = re.findall(r"```python\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL)
    return program


def make_and_be_killed_once(seeds):
    """Makes a partition. The worker that is the first to try is killed half-way."""
    import many_maps

    try:
        note = os.open("killed", os.O_CREAT | os.O_EXCL | os.O_WRONLY)
    except FileExistsError:
        return many_maps.make(seeds)
    many_maps.make(seeds[: PARTITION // 2])
    os.write(note, json.dumps(times()).encode())
    os.kill(os.getpid(), signal.SIGKILL)


def times():
    """When each file was made."""
    return {path.name: path.stat().st_mtime_ns for path in Path("out").iterdir()}


def plain(many_maps, outputs):
    """One call for all seeds. Returns what it prints."""
    call = ["riverseed", "render", many_maps.RECIPE, "--seeds", "-", *outputs]
    return subprocess.run(call, input="\n".join(SEEDS), encoding="utf-8", check=True, stdout=subprocess.PIPE).stdout


def check_files(many_maps, bag):
    made = bag.map_partitions(make_and_be_killed_once).compute()
    assert sorted(made) == sorted(SEEDS), "a seed is lost"
    before = json.loads(Path("killed").read_text())
    after = times()
    assert len(before) >= PARTITION // 2 * 2, "the worker was killed before it had made anything"
    assert all(after[name] == time for name, time in before.items()), "what was there was made again"
    os.mkdir("plain")
    plain(many_maps, [word.replace("out/", "plain/") for word in many_maps.OUTPUTS])
    names = sorted(path.name for path in Path("plain").iterdir())
    assert len(names) == 2 * len(SEEDS) and names == sorted(after), "files are missing"
    differing = [name for name in names if Path("out", name).read_bytes() != Path("plain", name).read_bytes()]
    assert not differing, differing
    print(f"{len(names)} files of {len(SEEDS)} maps by a cluster, a worker of which was killed: as by one call, to the byte")


def check_networks(many_maps, bag):
    lines = plain(many_maps, ["-o", "-"]).split("\n")[:-1]
    assert bag.map_partitions(many_maps.networks).compute() == [json.loads(line) for line in lines]
    print(f"{len(lines)} networks of a bag: as by one call, in its order")


def check(program):
    os.environ["PATH"] = f"{Path(program).resolve().parent}{os.pathsep}{os.environ['PATH']}"
    with tempfile.TemporaryDirectory() as folder:
        os.environ["PYTHONPATH"] = folder  # of the workers, too
        sys.path.insert(0, folder)
        Path(folder, "many_maps.py").write_text(page_s_program(), encoding="utf-8")
        os.chdir(folder)
        os.mkdir("out")
        import many_maps

        bag = dask.bag.from_sequence(SEEDS, partition_size=PARTITION)
        with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster, Client(cluster):
            check_files(many_maps, bag)
            check_networks(many_maps, bag)
        os.chdir("/")


if __name__ == "__main__":
    check(sys.argv[1])
