"""Gravity torques of an arm over its workspace, as a picture, and compared with Pinocchio.

Needs the package of the Panda-class arm, built as in README.md, and matplotlib. Where Pinocchio
(`pip install pin`) is not installed, nothing is compared.
"""

import argparse
import pathlib
import time

import numpy as np
from panda_py import PandaClass

HERE = pathlib.Path(__file__).resolve().parent
URDF = HERE.parent.parent / "robots" / "panda_class.urdf"


def configurations(arm, steps):
    """Configurations in the plane y = 0: the shoulder and the elbow within their limits, all others at rest."""
    limits = arm.coordinate_limits
    shoulder, elbow = (np.linspace(*limits[k], steps) for k in (1, 3))
    q = np.zeros((steps, steps, arm.NQ))
    q[..., 1] = shoulder[:, None]
    q[..., 3] = elbow
    return q


def draw(arm, q, path):
    """Draws the torques of shoulder and elbow over the position of the hand."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    hand = arm.forward_kinematics(q)[..., :3, 3]
    tau = arm.gravity(q)
    figure, panels = plt.subplots(1, 2, figsize=(8, 3.8), sharey=True, layout="constrained")
    for panel, joint in zip(panels, (1, 3)):
        most = np.abs(tau[..., joint]).max()
        colours = panel.pcolormesh(
            hand[..., 0], hand[..., 2], tau[..., joint], cmap="RdBu_r", vmin=-most, vmax=most, shading="gouraud"
        )
        figure.colorbar(colours, ax=panel, label="N m")
        panel.set_title(f"gravity torque of {arm.velocity_names[joint]}")
        panel.set_xlabel("x of the hand [m]")
        panel.set_aspect("equal")
    panels[0].set_ylabel("z of the hand [m]")
    figure.savefig(path, dpi=72)
    print(f"{path}: {q[..., 0].size} configurations")


def compare(arm, count):
    """The same torques by Pinocchio, state by state."""
    try:
        import pinocchio
    except ImportError:
        print("Pinocchio is not installed: nothing is compared")
        return
    model = pinocchio.buildModelFromUrdf(str(URDF))
    data = model.createData()
    low, high = arm.coordinate_limits.T
    q = np.random.default_rng(1).uniform(low, high, (count, arm.NQ))
    arm.gravity(q)  # the first call starts the threads
    began = time.perf_counter()
    tau = arm.gravity(q)
    ours = time.perf_counter() - began
    began = time.perf_counter()
    theirs = np.array([pinocchio.computeGeneralizedGravity(model, data, state) for state in q])
    apart = time.perf_counter() - began
    print(f"{count} states: at most {np.abs(tau - theirs).max():.1e} N m from Pinocchio's")
    print(f"{ours / count * 1e9:.0f} ns a state, {apart / count * 1e9:.0f} by Pinocchio called from Python")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--picture", default="gravity.png", help="the file to draw")
    options = parser.parse_args()
    panda = PandaClass()
    draw(panda, configurations(panda, 181), options.picture)
    compare(panda, 20_000)
