"""Labels random states of an arm with inverse dynamics, on the workers of a cluster, chunk by chunk into Parquet.

The bytes depend only on the seed, the number of states and the size of a chunk: each chunk has random numbers of its
own, is written to a temporary file and then renamed, and is not made again if it exists. They do not depend on the
number of workers, on workers that fail, or on restarts.

Needs the package of the Panda-class arm (README.md has the command), pyarrow, and ray or dask[distributed].
"""

import argparse
import hashlib
import importlib
import os
import pathlib
import signal
import time
import uuid

# One thread a worker, since the cluster has one worker a core. No usage statistics are sent.
os.environ.setdefault("RAYON_NUM_THREADS", "1")
os.environ.setdefault("RAY_USAGE_STATS_ENABLED", "0")


def states(arm, seed, first, count):
    """The random states of a chunk, seeded by the chunk."""
    import numpy as np

    random = np.random.default_rng([seed, first, count])
    low, high = np.clip(arm.coordinate_limits.T, -np.pi, np.pi)
    fastest = np.clip(arm.velocity_limits[:, 1], 0, 10)
    q = random.uniform(low, high, (count, arm.NQ))
    qd = random.uniform(-fastest, fastest, (count, arm.NV))
    qdd = random.uniform(-10, 10, (count, arm.NV))
    return q, qd, qdd


def label(chunk, options):
    """Makes a chunk, if it is not there: its number, its SHA-256, and the time of a core for all and for computing."""
    import pyarrow as pa
    import pyarrow.parquet as pq

    folder = pathlib.Path(options["folder"])
    first = chunk * options["chunk"]
    count = min(options["chunk"], options["states"] - first)
    # All that its bytes depend on.
    path = folder / f"{options['module']}-{options['seed']}-{first:012}-{count}.parquet"
    began, computing = time.process_time(), 0.0
    if not path.exists():
        module = importlib.import_module(options["module"])
        arm = getattr(module, module.__all__[0])()
        arguments = states(arm, options["seed"], first, count)
        computing = -time.process_time()
        tau = arm.inverse_dynamics(*arguments)
        computing += time.process_time()
        # A list of constant length a state, whose numbers are not copied.
        columns = {
            name: pa.FixedSizeListArray.from_arrays(pa.array(numbers.reshape(-1)), numbers.shape[1])
            for name, numbers in zip(("q", "qd", "qdd", "tau"), (*arguments, tau))
        }
        fresh = folder / f".{path.name}.{uuid.uuid4().hex}"
        try:
            with open(fresh, "wb") as file:
                pq.write_table(pa.table(columns), file, compression="none", use_dictionary=False)
                if chunk in options["lose"]:
                    lose(folder / f".lost-{chunk}", file)
                file.flush()
                os.fsync(file.fileno())
            os.replace(fresh, path)
        finally:
            fresh.unlink(missing_ok=True)
    with open(path, "rb") as file:
        digest = hashlib.file_digest(file, "sha256").hexdigest()
    return chunk, digest, time.process_time() - began, computing


def lose(mark, file):
    """Kills this worker in the middle of its file, once."""
    if not mark.exists():
        mark.touch()
        file.truncate(file.tell() // 2)
        os.kill(os.getpid(), signal.SIGKILL)


def here(chunks, options):
    """In this process."""
    yield from (label(chunk, options) for chunk in chunks)


def on_ray(chunks, options):
    """On a cluster of Ray: the one at `--address`, or processes of this machine."""
    import ray

    local = {"address": "local", "num_cpus": options["workers"], "_node_ip_address": "127.0.0.1"}
    where = {"address": options["address"]} if options["address"] else local
    ray.init(**where, include_dashboard=False if where is local else None, log_to_driver=False)
    # A worker that dies is replaced, and its chunk is made again.
    task = ray.remote(num_cpus=1, max_retries=5)(label)
    waiting = [task.remote(chunk, options) for chunk in chunks]
    while waiting:
        done, waiting = ray.wait(waiting)
        yield from ray.get(done)
    ray.shutdown()


def on_dask(chunks, options):
    """The same on Dask."""
    from dask.distributed import Client, LocalCluster, as_completed

    if options["address"]:
        client = Client(options["address"])
    else:
        cluster = LocalCluster(
            n_workers=options["workers"],
            threads_per_worker=1,
            host="127.0.0.1",
            dashboard_address=None,
            silence_logs="CRITICAL",
        )
        client = Client(cluster)
    futures = client.map(label, list(chunks), options=options, retries=5, pure=False)
    yield from (result for _, result in as_completed(futures, with_results=True))
    client.close()
    if not options["address"]:
        cluster.close()


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--on", choices=["here", "ray", "dask"], default="here", help="who does it")
    parser.add_argument("--address", help="of a cluster that runs [default: one is started on this machine]")
    parser.add_argument("--workers", type=int, default=2, help="how many processes, where a cluster is started")
    parser.add_argument("--states", type=int, default=2_000_000)
    parser.add_argument("--chunk", type=int, default=100_000, help="states in a file")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--module", default="panda_py", help="the package of the robot")
    parser.add_argument("--folder", default="labels", help="where the files go, which every worker must see")
    parser.add_argument("--lose", type=int, action="append", default=[], metavar="CHUNK", help="kill who makes it, once")
    options = vars(parser.parse_args())
    folder = pathlib.Path(options["folder"]).absolute()
    folder.mkdir(parents=True, exist_ok=True)
    options["folder"] = str(folder)

    chunks = range(-(-options["states"] // options["chunk"]))
    run = {"here": here, "ray": on_ray, "dask": on_dask}[options["on"]]
    digests, all_of_it, computing, began = {}, 0.0, 0.0, None
    for chunk, digest, *times in run(chunks, options):
        # The first one started the workers.
        began = began or time.perf_counter()
        digests[chunk] = digest
        all_of_it, computing = all_of_it + times[0], computing + times[1]
    wall = time.perf_counter() - began
    for left in [*folder.glob(".*.parquet.*"), *folder.glob(".lost-*")]:
        left.unlink()
    count = options["states"]
    whole = hashlib.sha256("".join(digests[chunk] for chunk in chunks).encode()).hexdigest()
    print(f"{count} states in {len(chunks)} chunks, sha256 {whole}")
    if len(chunks) > 1:
        rate = (count - options["chunk"]) / wall
        print(f"{rate:.3g} states a second; of a core {all_of_it / count * 1e9:.0f} ns a state, {computing / count * 1e9:.0f} of them computing")
