"""Inverse kinematics by TRAC-IK, of the arms and the limits of `cargo run --release -p homogen-examples --bin inverse_kinematics`.

In: robots/*.urdf. Out: of ten thousand poses that each arm has at random coordinates within its limits, how many are
found from the middle of them, and the time of a call. TRAC-IK (Beeson and Ames, 2015) runs two solvers in threads of
their own, until one has found or the time is up.
"""

import math
import pathlib
import time

import numpy
import pytracik
from trac_ik.trac_ik import quaternion_from_matrix

TARGETS = 10_000
TIMEOUT = 0.005
EPSILON = 1e-6

ROBOTS = pathlib.Path(__file__).resolve().parents[2] / "robots"


def iiwa():
    """Seven joints without an offset between their axes, as the example has them."""
    joints = [("z", 0.36, 170), ("y", 0, 120), ("z", 0.42, 170), ("-y", 0, 120), ("z", 0.4, 170), ("y", 0, 120), ("z", 0.126, 175)]
    axes = {"z": "0 0 1", "y": "0 1 0", "-y": "0 -1 0"}
    text = '<robot name="iiwa"><link name="l0"/>'
    for k, (axis, height, limit) in enumerate(joints):
        limit = math.radians(limit)
        text += (
            f'<link name="l{k + 1}"/><joint name="j{k}" type="revolute"><parent link="l{k}"/><child link="l{k + 1}"/>'
            f'<origin xyz="0 0 {height}"/><axis xyz="{axes[axis]}"/>'
            f'<limit lower="{-limit!r}" upper="{limit!r}" velocity="1" effort="1"/></joint>'
        )
    return text + "</robot>"


ARMS = {
    "Panda": ((ROBOTS / "panda_class.urdf").read_text(), "link8"),
    "UR5": ((ROBOTS / "ur5_class.urdf").read_text(), "tool0"),
    "iiwa": (iiwa(), "l7"),
}

for name, (urdf, tip) in ARMS.items():
    base = {"Panda": "link0", "UR5": "base", "iiwa": "l0"}[name]
    solver = pytracik.TRAC_IK(base, tip, urdf, TIMEOUT, EPSILON, pytracik.SolveType.Speed)
    least, most = (numpy.array(f(solver)) for f in (pytracik.get_joint_lower_bounds, pytracik.get_joint_upper_bounds))
    random = numpy.random.default_rng(1)
    met, times = 0, []
    for q in random.uniform(least, most, (TARGETS, len(least))):
        pose = pytracik.fk(solver, q)
        w, x, y, z = quaternion_from_matrix(pose)
        seconds = time.perf_counter()
        found = pytracik.ik(solver, (least + most) / 2, *pose[:3, 3], x, y, z, w)
        times.append(time.perf_counter() - seconds)
        if found[0] >= 0:
            off = numpy.linalg.inv(pytracik.fk(solver, found[1:])) @ pose
            angle = numpy.linalg.norm([off[2, 1] - off[1, 2], off[0, 2] - off[2, 0], off[1, 0] - off[0, 1]]) / 2
            met += max(angle, numpy.linalg.norm(off[:3, 3])) < 2 * EPSILON
    times = numpy.sort(times) * 1e6
    print(f"{name:6} {met:6} met  {times[len(times) // 2]:8.1f} µs in the middle {times[len(times) * 99 // 100]:8.1f} of 99 %")
