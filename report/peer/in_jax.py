"""Times and judges `frax`, dynamics in JAX, on many states at once.

usage: in_jax.py ROBOT TRUTH BATCHES STATES f64 | f32

ROBOT is a folder that setup.sh made, TRUTH what the report wrote of the robot's inverse dynamics: states, and
their exact results. STATES, of which each further thousand is the first one again, are one call of a compiled
function, on all the threads that it takes. Out: a line as those of `many`: name and type, quartiles of the time
per state in ns, median, 99th percentile and worst of the error. What is copied between coordinates of the two
is not part of the time.
"""

import os
import sys
import time
from pathlib import Path

robot, truth, batches, count, scalar = sys.argv[1:]
robot, truth, batches, count = Path(robot), Path(truth), int(batches), int(count)
os.environ["JAX_PLATFORMS"] = "cpu"  # read by what is imported next

import in_frax
import jax
import jax.numpy as jnp
import numpy as np

jax.config.update("jax_enable_x64", scalar == "f64")
# Rounds of a report start it anew, and compiling takes longer than running.
jax.config.update("jax_compilation_cache_dir", str(robot / "jax"))
jax.config.update("jax_persistent_cache_min_compile_time_secs", 0)

FREE = "root"


def rotation(quaternion):
    """Of x, y, z, w, one a row."""
    x, y, z, w = quaternion.T
    rows = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ]
    return np.array(rows).transpose(2, 0, 1)


moving = (robot / "model.joints").read_text().split()
free = moving[0] == FREE
moving = [name for name in moving if name != FREE]
model = in_frax.robot(robot / "robot.urdf", moving, free)

of_type = truth / "f32" if scalar == "f32" and (truth / "f32").exists() else truth
coordinates, velocities = map(int, (of_type / "lengths").read_text().split())
numbers = np.fromfile(of_type / "states").reshape(-1, coordinates + 3 * velocities)
q, qd, qdd, _ = np.split(numbers, np.cumsum([coordinates, velocities, velocities]), axis=1)
if free:
    # frax has w first, and the linear velocity in the axes of the world, of which it takes the rate.
    turn = rotation(q[:, 3:7])
    qdd = qdd.copy()
    qdd[:, :3] += np.cross(qd[:, 3:6], qd[:, :3])
    qd, qdd = (np.concatenate([np.einsum("nij,nj->ni", turn, x[:, :3]), x[:, 3:]], axis=1) for x in (qd, qdd))
    q = np.concatenate([q[:, :3], q[:, 6:7], q[:, 3:6], q[:, 7:]], axis=1)


def inverse_dynamics(q, qd, qdd):
    return model.rnea(q, qd, qdd, jnp.array(in_frax.GRAVITY), None)


many = jax.jit(jax.vmap(inverse_dynamics))
repeats = -(-count // len(q))
states = [jnp.asarray(np.tile(x, (repeats, 1))[:count]) for x in (q, qd, qdd)]
tau = many(*states).block_until_ready()
times = []
for _ in range(batches):
    start = time.perf_counter()
    many(*states).block_until_ready()
    times.append((time.perf_counter() - start) * 1e9 / count)

tau = np.asarray(tau, dtype=float)[: len(q)]
if free:
    tau = np.concatenate([np.einsum("nji,nj->ni", turn, tau[:, :3]), tau[:, 3:]], axis=1)
high, low, size = np.fromfile(of_type / "inverse_dynamics").reshape(len(q), -1, 3).transpose(2, 0, 1)
error = np.abs(tau - high - low)
errors = np.sort(np.divide(error, size, out=np.zeros_like(error), where=error > 0).max(axis=1))
quartiles = np.sort(times)[[(len(times) - 1) * quarter // 4 for quarter in (1, 2, 3)]]
judged = [errors[len(errors) // 2], errors[len(errors) * 99 // 100], errors[-1]]
print(f"frax/rnea:all {scalar}", *[f"{x:.3f}" for x in quartiles], *[f"{x:e}" for x in judged])
