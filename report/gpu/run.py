#!/usr/bin/env python3
"""Many states on a GPU: inverse and forward dynamics of robots by the C that `homogen generate` writes.

    report/gpu/run.py write FOLDER ROBOT.urdf [OPTION…]     once a robot; [HOMOGEN=PATH: the command, where it is built]
    report/gpu/run.py measure FOLDER

`write` needs cargo and puts a robot's source and random states into the folder; OPTION is one of `homogen generate`,
as `--floating`. `measure` needs nvcc and a GPU, and may run on another machine, with a copy of this one's `report`: it
compiles `many.cu` with each source, and prints a table. Where `frax` is installed it is measured beside ours, on
robots with a fixed base.

Columns: registers and bytes of local memory a thread; 10⁶ states a second, their quartiles and what these move of the
GPU's memory in GB/s; the same with copies from the host and back, one after the other; numbers that differ from those
of the host by the same source. Products are fused with sums where the source says so and nowhere else, on both sides.
"""

import array
import importlib.util
import json
import pathlib
import random
import re
import shutil
import subprocess
import sys
import time

sys.path += [str(pathlib.Path(__file__).resolve().parent.parent / folder) for folder in (".", "peer")]
from command import ROOT, homogen, said

FUNCTIONS = ["inverse_dynamics", "forward_dynamics"]
TYPES = {"float": "f32", "double": "f64"}
GIVEN, COUNT, ROUNDS = 10_000, 4_000_000, 21


def main():
    match sys.argv[1:]:
        case ["write", folder, urdf, *options] if not urdf.startswith("-"):
            write(pathlib.Path(folder), pathlib.Path(urdf), options)
        case ["measure", folder]:
            measure(pathlib.Path(folder))
        case _:
            sys.exit(__doc__.strip())


# --- write ----------------------------------------------------------------------------------------


def write(folder, urdf, options):
    """A robot's source for both types of number, what its coordinates are called, and states."""
    command = homogen()
    told = json.loads(said(command, "check", urdf, *options, "--format", "json"))
    to = folder / urdf.stem
    to.mkdir(parents=True, exist_ok=True)
    for scalar in TYPES.values():
        for function in FUNCTIONS:
            generate = [command, "generate", urdf, *options, "--language", "c", "--name", "arm", "--scalar", scalar]
            generate += ["--processor", "x86-64-v3", "--functions", function]
            said(*generate, "-o", to / f"{function}_{scalar}.c")
    shutil.copy(urdf, to / "robot.urdf")
    (to / "names.json").write_text(json.dumps({key: told[key] for key in ("coordinates", "velocities")}))
    states(told["coordinates"], told["velocities"]).tofile((to / "states").open("wb"))


def states(coordinates, velocities):
    """Normal random numbers, quaternions of unit length: q, q̇ and the third argument, one state after the other."""
    draw = random.Random(1).gauss
    numbers = array.array("d")
    quaternion = [k for k, name in enumerate(coordinates) if re.search(r"\.q[xyzw]$", name)]
    for _ in range(GIVEN):
        q = [draw(0, 1) for _ in coordinates]
        for first in range(0, len(quaternion), 4):
            turn = quaternion[first : first + 4]
            length = sum(q[k] ** 2 for k in turn) ** 0.5
            for k in turn:
                q[k] /= length
        numbers.extend(q)
        numbers.extend(draw(0, 1) for _ in range(2 * len(velocities)))
    return numbers


# --- measure --------------------------------------------------------------------------------------


def measure(folder):
    """Compiles, runs and prints."""
    for tool in ("nvcc", "nvidia-smi"):
        if shutil.which(tool) is None:
            sys.exit(f"run.py: {tool} is missing; please install it")
    gpu = said("nvidia-smi", "--query-gpu=name,driver_version", "--format=csv,noheader").splitlines()[0]
    release = re.search(r"release \S+", said("nvcc", "--version")).group(0).rstrip(",")
    print(f"{gpu}; nvcc {release}; {COUNT} states, {ROUNDS} times\n")
    columns = "robot | function | type | registers | local | 10⁶ states/s | quartiles | GB/s | with copies | differing"
    print(f"| {columns} |\n|---|---|---" + "|---:" * 7 + "|")
    robots = sorted(names.parent for names in folder.glob("*/names.json"))
    for robot in robots:
        for function in FUNCTIONS:
            for real, scalar in TYPES.items():
                print(row(robot, function, real, scalar), flush=True)
    if importlib.util.find_spec("frax") is None:
        print("\nfrax is not installed")
        return
    for robot in robots:
        names = json.loads((robot / "names.json").read_text())
        if names["coordinates"] == names["velocities"]:
            by_frax(robot, names["coordinates"])


def row(robot, function, real, scalar):
    """What a program says of a function."""
    names = json.loads((robot / "names.json").read_text())
    coordinates, velocities = len(names["coordinates"]), len(names["velocities"])
    program = robot / f"{function}_{scalar}"
    macros = {
        "SOURCE": f'"{program.with_suffix(".c").resolve()}"',
        "FUNCTION": f"arm_{function}",
        "REAL": real,
        "NQ": coordinates,
        "NV": velocities,
    }
    build = ["nvcc", "-O3", "-arch=native", "-fmad=false", "-Xcompiler", "-mfma,-ffp-contract=off"]
    build += [f"-D{name}={value}" for name, value in macros.items()]
    subprocess.run([*build, ROOT / "report/gpu/many.cu", "-o", program], check=True)
    words = said(program, robot / "states", COUNT, ROUNDS).split()
    registers, local = words[:2]
    alone, copied = [[1e6 / float(time) for time in words[k : k + 3]] for k in (2, 5)]
    moved = (coordinates + 3 * velocities) * (4 if scalar == "f32" else 8) * alone[1] / 1e3
    differing = "none" if words[8] == "0" else f"{words[8]}, by {words[9]}"
    cells = [robot.name, f"`{function}`", scalar, registers, local, f"{alone[1]:.0f}"]
    cells += [f"{alone[2]:.0f} to {alone[0]:.0f}", f"{moved:.0f}", f"{copied[1]:.0f}", differing]
    return f"| {' | '.join(cells)} |"


def by_frax(robot, joints):
    """The same states by frax: prints how many it does in a second, for both types and growing batches."""
    import in_frax
    import jax
    import jax.numpy as jnp
    import numpy as np

    for scalar in TYPES.values():
        jax.config.update("jax_enable_x64", scalar == "f64")
        model = in_frax.robot(robot / "robot.urdf", joints, False)
        gravity = jnp.array(in_frax.GRAVITY)
        many = jax.jit(jax.vmap(lambda q, qd, qdd: model.rnea(q, qd, qdd, gravity, None)))
        given = np.fromfile(robot / "states").reshape(GIVEN, 3, len(joints))
        for count in (16_384, 1_048_576, COUNT):
            arguments = [jnp.asarray(np.resize(given[:, k], (count, len(joints)))) for k in range(3)]
            many(*arguments).block_until_ready()
            times = []
            for _ in range(ROUNDS):
                start = time.perf_counter()
                many(*arguments).block_until_ready()
                times.append(time.perf_counter() - start)
            rate = count / sorted(times)[ROUNDS // 2] / 1e6
            print(f"frax on {jax.devices()[0]}: {robot.name}, inverse dynamics, {scalar}, {count} states: {rate:.1f} · 10⁶/s")


if __name__ == "__main__":
    main()
