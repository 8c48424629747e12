"""What the tests share: robots, states, and what `homogen eval` computes of them."""

import importlib
import os
import subprocess
from pathlib import Path

import numpy as np
import pytest

import homogen

REPOSITORY = Path(os.environ.get("HOMOGEN_REPOSITORY", Path(__file__).parents[2]))
ROBOTS = REPOSITORY / "robots"
HOMOGEN = os.environ.get("HOMOGEN")

#: True in the long form of the tests.
LONG = bool(os.environ.get("HOMOGEN_LONG"))

#: Libraries that are installed, by the names of their modules.
DEMANDED = os.environ.get("HOMOGEN_LIBRARIES", "").replace("pin", "pinocchio").replace("-python", "").split(",")

ROD = "pin: rod(0.5) { from: fore, to: base, at: xyz(0.3, 0, 0) }"

#: An arm, a floating quadruped, a robot with a loop, forces from outside with friction, a table of Denavit and Hartenberg.
CASES = {
    "arm": ("panda_class.urdf", {"tip": "link8"}),
    "floating": ("quadruped.urdf", {"floating": True, "tip": "fl_foot"}),
    "loop": ("two_link.urdf", {"loop": ROD, "actuated": "shoulder"}),
    "external": ("two_link.urdf", {"external": ["fore"], "friction": {"elbow": 0.2}}),
    "table": ("rx90_class.dh", {}),
}


def library(name):
    """The module of a library; the test is skipped where it is missing and not demanded."""
    if name.partition(".")[0] in DEMANDED:
        return importlib.import_module(name)
    return pytest.importorskip(name)


def robot(name, **more):
    """A robot of the table above."""
    file, options = CASES[name]
    return homogen.load(ROBOTS / file, **options, **more)


def flags(options):
    """Options as flags of the command line."""
    for key, value in options.items():
        key = f"--{key}"
        if value is True:
            yield key
        elif isinstance(value, dict):
            yield from (f"{key}={joint}={number}" for joint, number in value.items())
        else:
            yield from (f"{key}={one}" for one in ([value] if isinstance(value, str) else value))


#: Functions that take most of the time to compile for the floating quadruped. Without HOMOGEN_LONG they are compared for the
#: other robots alone.
SLOW = {
    "base_regressor",
    "forward_dynamics_derivatives",
    "forward_dynamics_hessian",
    "forward_dynamics_parameter_derivatives",
    "forward_dynamics_vjp",
    "inverse_dynamics_hessian",
    "regressor",
}


def functions(of):
    """The functions that a robot has, by name, without those of configurations and, of many joints, the slow ones."""
    is_short = of.NV > 10 and not LONG
    for name in dir(of):
        if is_short and name in SLOW:
            continue
        try:
            function = getattr(of, name)
        except (ImportError, ValueError):
            continue
        if type(function).__name__ == "Function" and name not in ("integrate", "difference", "normalize"):
            yield name, function


def states(of, names, count, dtype, seed=0):
    """Arguments of these names."""
    rng = np.random.default_rng(seed)
    shapes = {"q": of.NQ, "wrench": 6, "actions": 6 * of._recipe.facts()["external"]}
    made = {name: rng.uniform(-1.5, 1.5, (count, shapes.get(name, of.NV))) for name in names}
    if "q" in made:
        made["q"] = of.random(rng, count)
    if "actions" in made:
        made["actions"] = made["actions"].reshape(count, -1, 6)
    return [made[name].astype(dtype) for name in names]


def evaluated(case, name, arguments, results, dtype, room):
    """The results of `homogen eval --reproducible`: an array for each, as it lays them out."""
    file, options = CASES[case]
    if "actions" not in arguments:
        options = {key: value for key, value in options.items() if key != "external"}
    words = [HOMOGEN, "eval", str(ROBOTS / file), *flags(options), "--reproducible", f"--function={name}"]
    words += ["--scalar", {"float32": "f32", "float64": "f64"}[np.dtype(dtype).name]]
    for argument, array in arguments.items():
        path = room / f"{argument}.npy"
        np.save(path, array)
        words.append(f"--states={argument}={path}" if len(arguments) > 1 else f"--states={path}")
    paths = {result: room / f"out_{result}.npy" for result in results}
    for result, path in paths.items():
        words += ["--output", f"{result}={path}" if len(paths) > 1 else str(path)]
    subprocess.run(words, check=True, capture_output=True, text=True)
    return [np.load(path) for path in paths.values()]


def same(found, expected):
    """Whether arrays have the same shape, type and bits."""
    found, expected = np.ascontiguousarray(found), np.ascontiguousarray(expected)
    return found.shape == expected.shape and found.dtype == expected.dtype and found.tobytes() == expected.tobytes()


@pytest.fixture
def arm():
    return robot("arm")
