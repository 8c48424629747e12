"""Functions on a GPU of NVIDIA: a million states against the processor's results, and how many are computed a second.

    python gpu.py [FILE [TIP]]     robots/panda_class.urdf and link8 where nothing else is named

Needs the package, a GPU with its driver, and PyTorch or CuPy. Both sides fuse the same products with sums where the processor
can do that, so that results have the same bits; the number of those that differ is printed. Times are the least of several
runs, of arrays in the GPU's memory, by rows and by columns. Where `frax` and JAX are installed it computes the same states.
"""

import sys
import time
from pathlib import Path

import numpy as np

# Beside this file the package has no engine: the installed one is meant.
if str(Path(__file__).resolve().parent) in sys.path:
    sys.path.remove(str(Path(__file__).resolve().parent))

FILE = sys.argv[1] if len(sys.argv) > 1 else str(Path(__file__).parents[1] / "robots" / "panda_class.urdf")
TIP = sys.argv[2] if len(sys.argv) > 2 else "link8"
STATES, RUNS = 1_000_000, 21
FUNCTIONS = ["forward_kinematics", "body_jacobian", "gravity", "inverse_dynamics", "mass_matrix", "forward_dynamics"]


def library():
    """To the GPU, back from there, wait for it: of the first library that is installed."""
    try:
        import torch
    except ImportError:
        import cupy

        return cupy.asarray, cupy.asnumpy, cupy.cuda.Device().synchronize
    return lambda array: torch.as_tensor(array, device="cuda"), lambda tensor: tensor.cpu().numpy(), torch.cuda.synchronize


def least(call, wait):
    """The seconds of one call."""
    call()
    best = float("inf")
    for _ in range(RUNS):
        wait()
        began = time.perf_counter()
        call()
        wait()
        best = min(best, time.perf_counter() - began)
    return best


def by_columns(there, array):
    """An array on the GPU whose states lie beside each other."""
    return there(np.ascontiguousarray(array.T)).T


def beside(joints, states, wait):
    """States a second of frax, where it is installed."""
    sys.path.append(str(Path(__file__).resolve().parents[1] / "report" / "peer"))
    try:
        import in_frax
        import jax
    except ImportError:
        print("not measured: frax is not installed")
        return
    model, gravity = in_frax.robot(Path(FILE), joints, False), jax.numpy.array(in_frax.GRAVITY)
    dynamics = jax.jit(jax.vmap(lambda q, qd, qdd: model.rnea(q, qd, qdd, gravity, None)))
    arrays = [jax.numpy.asarray(array, np.float32) for array in states]
    seconds = least(lambda: dynamics(*arrays).block_until_ready(), wait)
    print(f"{'frax: inverse_dynamics':24} float32 {'':10} {STATES / seconds / 1e6:20.0f}")


def main():
    import homogen

    of = homogen.load(FILE, tip=TIP)
    there, back, wait = library()
    rng = np.random.default_rng(0)
    drawn = {"q": of.random(rng, STATES), **{name: rng.uniform(-1, 1, (STATES, of.NV)) for name in ("qd", "qdd", "tau")}}
    print(f"{'':24} {'':7} {'differ':>10} {'rows, 10⁶ states/s':>20} {'columns':>10}")
    for name in FUNCTIONS:
        for dtype in (np.float64, np.float32):
            function = getattr(of, name)
            states = [drawn[argument].astype(dtype) for argument, _ in function.arrays()[0]]
            expected = function(*states)
            rows = [there(array) for array in states]
            columns = [by_columns(there, array) for array in states]
            kernel = getattr(of.cuda, name)
            differ = np.count_nonzero((back(kernel(*rows)) != expected).reshape(STATES, -1).any(axis=1))
            out = by_columns(there, np.empty(expected.reshape(STATES, -1).shape, dtype)) if expected.ndim == 2 else kernel(*rows)
            speeds = [STATES / least(lambda: kernel(*given, out=out), wait) / 1e6 for given in (rows, columns)]
            print(f"{name:24} {np.dtype(dtype).name} {differ:10} {speeds[0]:20.0f} {speeds[1]:10.0f}")
    beside(list(of.coordinate_names), [drawn[name] for name in ("q", "qd", "qdd")], wait)


if __name__ == "__main__":
    main()
