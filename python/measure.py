"""Measures the package: from a file to the first torques, one state, and many.

    python measure.py [--wheel WHEEL] [FILE [TIP [HUMANOID]]]

FILE and TIP are robots/panda_class.urdf and link8 where nothing else is named; HUMANOID, which gets a floating base, is that of
the tests. With a WHEEL of the package, its installation in a fresh environment is measured, downloads included. Where cargo is
installed, the batch in Rust of as many states of that arm is beside ours, built without flags; where FILE is named, it is not.

Each figure is the least of several runs: what the machine does besides only adds. Where `pin` is installed, Pinocchio does
the same beside it (`pip install pin`). So do PyTorch, JAX and CasADi with the functions for them, and frax, adam and MuJoCo for
many states (`pip install frax adam-robotics mujoco`; frax needs JAX, adam PyTorch). Nothing cached and cached are processes of
their own, without their imports.
"""

import argparse
import json
import os
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

# Beside this file the package has no engine: the installed one is meant.
if str(Path(__file__).resolve().parent) in sys.path:
    sys.path.remove(str(Path(__file__).resolve().parent))

REPOSITORY = Path(__file__).resolve().parents[1]
PANDA = str(REPOSITORY / "robots" / "panda_class.urdf")
STATES = 1_000_000

parser = argparse.ArgumentParser(description="Measures the package for Python.")
parser.add_argument("file", nargs="?", default=PANDA)
parser.add_argument("tip", nargs="?", default="link8")
parser.add_argument("humanoid", nargs="?", default=str(REPOSITORY / "tests" / "robots" / "humanoid.urdf"))
parser.add_argument("--wheel")
given = parser.parse_args()
FILE, TIP, HUMANOID = given.file, given.tip, given.humanoid

FIRST = """
import json, sys, time
import numpy as np
import homogen
began = time.perf_counter()
of = homogen.load(sys.argv[1], tip=sys.argv[2])
loaded = time.perf_counter()
zeros = np.zeros(of.NV)
of.inverse_dynamics(of.neutral(), zeros, zeros)
print(json.dumps([loaded - began, time.perf_counter() - began]))
"""


HUMANOIDS = """
import json, sys, time
import numpy as np
import homogen
began = time.perf_counter()
of = homogen.load(sys.argv[1], floating=True)
rest = np.zeros(of.NV)
of.inverse_dynamics(of.neutral(), rest, rest)
of.inverse_dynamics_derivatives(of.neutral(), rest, rest)
print(json.dumps([time.perf_counter() - began]))
"""


def least(call, repeats, rounds):
    """The seconds of one call."""
    best = float("inf")
    for _ in range(rounds):
        began = time.perf_counter()
        for _ in range(repeats):
            call()
        best = min(best, (time.perf_counter() - began) / repeats)
    return best


def first(cache, program=FIRST, arguments=(FILE, TIP), runs=7):
    """The seconds of loading, and of loading with the first call, in a process of its own."""
    environment = {**os.environ, "HOMOGEN_CACHE": cache}
    words = [sys.executable, "-W", "ignore", "-c", program, *arguments]
    runs = [json.loads(subprocess.run(words, check=True, capture_output=True, env=environment).stdout) for _ in range(runs)]
    return [min(column) for column in zip(*runs)]


def show(what, value, unit):
    print(f"{what:58} {value:10.3f} {unit}")


def installation(wheel):
    """The seconds that pip takes in an environment of its own, with neither cargo nor a compiler on the path."""
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([sys.executable, "-m", "venv", folder], check=True)
        alone = {**os.environ, "PATH": f"{folder}/bin"}
        words = [f"{folder}/bin/pip", "install", "--quiet", "--disable-pip-version-check", "--no-cache-dir", wheel]
        began = time.perf_counter()
        subprocess.run(words, check=True, env=alone)
        return time.perf_counter() - began


def batches_in_rust():
    """Nanoseconds a state of Rust's batch on one thread: pairs of a row's name and its time, of one run."""
    words = ["cargo", "run", "--quiet", "--release", "-p", "homogen-examples", "--bin", "batch", "--", str(STATES)]
    alone = {**os.environ, "RAYON_NUM_THREADS": "1"}
    said = subprocess.run(words, check=True, cwd=REPOSITORY, env=alone, capture_output=True, text=True).stdout
    rows = [line.split() for line in said.splitlines()]
    return [(f"    Rust's {row[1]}, float{row[0][1:]}, one thread", float(row[5])) for row in rows if row[2:5] == ["on", "all", "cores"]]


def libraries(of):
    """Other libraries, as far as they are installed."""
    count = 100_000
    states = [of.random(0, count), *np.random.default_rng(0).uniform(-1, 1, (2, count, of.NV))]
    try:
        import torch
    except ImportError:
        print("not measured: PyTorch is not installed")
    else:
        tensors = [torch.tensor(array, requires_grad=True) for array in states]
        dynamics = of.torch.inverse_dynamics
        forward = least(lambda: dynamics(*tensors), 1, 9)
        show(f"PyTorch: inverse dynamics, {count} states", 1e9 * forward / count, "ns a state")
        torques = dynamics(*tensors)
        weights = torch.ones_like(torques)
        backward = least(lambda: torch.autograd.grad(torques, tensors, weights, retain_graph=True), 1, 9)
        show("    backward, in parts of the forward pass", backward / forward, "")
    try:
        import jax
    except ImportError:
        print("not measured: JAX is not installed")
    else:
        jax.config.update("jax_enable_x64", True)
        for size in (1024, count):
            arrays = [jax.numpy.asarray(array[:size]) for array in states]
            dynamics = jax.jit(of.jax.inverse_dynamics)
            forward = least(lambda: dynamics(*arrays).block_until_ready(), 1, 9)
            show(f"JAX: inverse dynamics, {size} states", 1e9 * forward / size, "ns a state")
            gradient = jax.jit(jax.grad(lambda *given: of.jax.inverse_dynamics(*given).sum(), (0, 1, 2)))
            backward = least(lambda: jax.block_until_ready(gradient(*arrays)), 1, 9)
            show("    value and gradient, in parts of that", backward / forward, "")
    try:
        import casadi  # noqa: F401
    except ImportError:
        print("not measured: CasADi is not installed")
    else:
        show("CasADi: instructions of inverse dynamics on SX", of.casadi.inverse_dynamics.n_instructions(), "")


def peers(of):
    """Other libraries with many states, as far as they are installed, with their results compared."""
    count = 100_000
    q, qd, qdd = [of.random(0, count), *np.random.default_rng(0).uniform(-1, 1, (2, count, of.NV))]
    gravity = [0.0, 0.0, -9.81, 0.0, 0.0, 0.0]

    def shown(who, call, number, wanted):
        off = np.abs(np.asarray(call()) - wanted).max() / np.abs(wanted).max()
        show(f"{who}, {number} states", 1e9 * least(call, 1, 3) / number, "ns a state")
        show("    largest difference, in parts of the largest value", 1e15 * off, "1e-15")

    torques = of.inverse_dynamics(q, qd, qdd)
    try:
        import frax
        import jax
    except ImportError:
        print("not measured: frax is not installed")
    else:
        jax.config.update("jax_enable_x64", True)
        with tempfile.TemporaryDirectory() as folder:
            robot = frax.Robot(with_inertias(folder))
        weight = -jax.numpy.array(gravity)
        dynamics = jax.jit(jax.vmap(lambda q, qd, qdd: robot.rnea(q, qd, qdd, weight, None)))
        arrays = [jax.numpy.asarray(array) for array in (q, qd, qdd)]
        shown("frax.rnea", lambda: dynamics(*arrays).block_until_ready(), count, torques)
    try:
        import torch
        from adam.pytorch import KinDynComputations
    except ImportError:
        print("not measured: adam is not installed")
    else:
        few = count // 100
        type_of = {"dtype": torch.float64}
        model = KinDynComputations(FILE, list(of.joint_names), gravity=torch.tensor(gravity, **type_of), **type_of)
        base, still = torch.eye(4, **type_of).expand(few, 4, 4), torch.zeros(few, 6, **type_of)
        angles, rates, seconds = (torch.tensor(array[:few]) for array in (q, qd, qdd))

        @torch.no_grad()
        def by_mass_matrix():
            mass = model.mass_matrix(base, angles)[:, 6:, 6:]
            return (mass @ seconds[..., None])[..., 0] + model.bias_force(base, angles, still, rates)[:, 6:]

        shown("adam on PyTorch, M q̈ and bias_force", by_mass_matrix, few, torques[:few])
    try:
        import mujoco
        from mujoco import rollout
    except ImportError:
        print("not measured: MuJoCo is not installed")
    else:
        model = mujoco.MjModel.from_xml_path(FILE)
        data = mujoco.MjData(model)
        start = np.concatenate([np.zeros((count, 1)), q, qd], axis=1)
        step = model.opt.timestep

        def rolled():
            reached, _ = rollout.rollout(model, [data], start, nstep=1)
            return (reached[:, 0, 1 + of.NQ :] - qd) / step

        free = of.forward_dynamics(q, qd, np.zeros_like(qd))
        shown("mujoco.rollout, one step, one thread", rolled, count, free)
        alone = least(lambda: of.step(q, qd, np.zeros_like(qd), step), 1, 3)
        show(f"step, {count} states", 1e9 * alone / count, "ns a state")


def with_inertias(folder):
    """The file with an inertial element for each link, which frax needs."""
    import xml.etree.ElementTree as xml

    tree = xml.parse(FILE)
    for link in tree.getroot().iter("link"):
        if link.find("inertial") is None:
            inertial = xml.SubElement(link, "inertial")
            xml.SubElement(inertial, "origin", xyz="0 0 0", rpy="0 0 0")
            xml.SubElement(inertial, "mass", value="0")
            xml.SubElement(inertial, "inertia", **dict.fromkeys(["ixx", "ixy", "ixz", "iyy", "iyz", "izz"], "0"))
    path = Path(folder) / "robot.urdf"
    tree.write(path)
    return str(path)


def main():
    import homogen

    if given.wheel:
        show("pip install of the wheel", installation(given.wheel), "s")
    load, compiled = first("")
    show("load", 1e3 * load, "ms")
    show("load and the first inverse dynamics, nothing cached", 1e3 * compiled, "ms")
    with tempfile.TemporaryDirectory() as cache:
        first(cache)
        show("load and the first inverse dynamics, cached", 1e3 * first(cache)[1], "ms")

    [both] = first("", HUMANOIDS, [HUMANOID], 2)
    show("humanoid: load, inverse dynamics and derivatives", both, "s")

    of = homogen.load(FILE, tip=TIP)
    alone = homogen.load(FILE, tip=TIP, threads=1)
    state = [of.random(0), *np.random.default_rng(0).uniform(-1, 1, (2, of.NV))]
    one = least(lambda: of.inverse_dynamics(*state), 20_000, 9)
    show("inverse dynamics, one state", 1e6 * one, "µs")
    try:
        import pinocchio
    except ImportError:
        print("not measured: Pinocchio is not installed")
    else:
        model = pinocchio.buildModelFromUrdf(FILE)
        data = model.createData()
        show("load, Pinocchio", 1e3 * least(lambda: pinocchio.buildModelFromUrdf(FILE), 5, 9), "ms")
        other = least(lambda: pinocchio.rnea(model, data, *state), 20_000, 9)
        show("pinocchio.rnea, one state", 1e6 * other, "µs")
        show("    ours in parts of that", one / other, "")

    for dtype in (np.float64, np.float32):
        states = [of.random(0, STATES), *np.random.default_rng(0).uniform(-1, 1, (2, STATES, of.NV))]
        states = [array.astype(dtype) for array in states]
        out = np.empty((STATES, of.NV), dtype)
        for robot, who in ((alone, "one thread"), (of, f"{os.cpu_count()} cores")):
            seconds = least(lambda: robot.inverse_dynamics(*states, out=out), 1, 9)
            show(f"inverse dynamics, {STATES} states, {np.dtype(dtype)}, {who}", 1e9 * seconds / STATES, "ns a state")
        columns = [np.asfortranarray(array) for array in states]
        out = np.asfortranarray(out)
        seconds = least(lambda: alone.inverse_dynamics(*columns, out=out), 1, 9)
        show("    the same by columns, one thread", 1e9 * seconds / STATES, "ns a state")
    if FILE != PANDA or not shutil.which("cargo"):
        print("not measured: Rust's batch, without cargo or of another file")
    else:
        for what, time_of_one in batches_in_rust():
            show(what, time_of_one, "ns a state")
    libraries(of)
    peers(alone)


if __name__ == "__main__":
    main()
