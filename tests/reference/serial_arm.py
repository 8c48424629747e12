#!/usr/bin/env python3
"""Makes the reference values of the arms that are shipped as tables, along their motions.

In: robots/*.dh and the .motion beside each. Out: tests/reference/<robot>.txt, one line for each time: the time,
q, q', q'', the rows of R and p of the last frame, and the torques and forces that Pinocchio's RNEA needs.
Tables are read and configurations interpolated independently; no code of this project is used.

    python3 -m venv venv && venv/bin/pip install -r tests/reference/requirements.txt
    venv/bin/python tests/reference/serial_arm.py
"""

from pathlib import Path

import numpy as np
import pinocchio as pin

HERE = Path(__file__).resolve().parent
ROBOTS = HERE.parent.parent / "robots"
PINOCCHIO = "4.1.0"
MOMENTS = 12  # equal steps from one configuration to the next


def lines(path):
    text = path.read_text(encoding="utf-8")
    return [words for line in text.splitlines() if (words := line.split("#")[0].split())]


def number(word):
    return {"pi/2": np.pi / 2, "-pi/2": -np.pi / 2}.get(word) if "pi" in word else float(word)


def turn(axis, angle):
    return pin.SE3(pin.exp3(angle * np.eye(3)[axis]), np.zeros(3))


def shift(axis, length):
    return pin.SE3(np.eye(3), length * np.eye(3)[axis])


def read(path):
    """The model, and the frame of the last row on the last joint."""
    (word, convention), columns, *rows = lines(path)
    assert word == "convention" and convention in ("modified", "standard")
    model, joint, hangs_on = pin.Model(), 0, pin.SE3.Identity()
    for row in rows:
        cell = dict(zip(columns, row))
        a, alpha, d, theta = (number(cell[key]) for key in ("a", "alpha", "d", "theta"))
        across = shift(0, a) * turn(0, alpha)
        along = turn(2, theta) * shift(2, d)
        # Joints rotate about or translate along z, and so commute with `along`.
        before, behind = (across * along, pin.SE3.Identity()) if convention == "modified" else (along, across)
        hangs_on = hangs_on * before
        if cell["kind"] != "fixed":
            kind = {"revolute": pin.JointModelRZ, "prismatic": pin.JointModelPZ}[cell["kind"]]
            joint = model.addJoint(joint, kind(), hangs_on, cell["joint"])
            hangs_on = pin.SE3.Identity()
        hangs_on = hangs_on * behind
        if cell.get("mass", "-") != "-":
            center = np.array([float(cell[key]) for key in ("cx", "cy", "cz")])
            xx, xy, xz, yy, yz, zz = (float(cell[key]) for key in ("ixx", "ixy", "ixz", "iyy", "iyz", "izz"))
            tensor = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
            moments = np.trace(tensor) / 2 * np.eye(3) - tensor
            assert np.min(np.linalg.eigvalsh(moments)) > 0, f"{path.name}: {cell['joint']} is not physical"
            model.appendBodyToJoint(joint, pin.Inertia(float(cell["mass"]), center, tensor), hangs_on)
    return model, joint, hangs_on


def motion(path):
    """Time, q, q' and q'' from one configuration to the next by polynomials of fifth degree, from rest to rest."""
    configurations = [np.array([float(word) for word in words]) for words in lines(path)]
    for start, end in zip(configurations, configurations[1:]):
        for k in range(MOMENTS + 1):
            s = k / MOMENTS
            span, step = end[0] - start[0], end[1:] - start[1:]
            way = np.polynomial.Polynomial([0, 0, 0, 10, -15, 6])
            yield (
                start[0] + s * span,
                start[1:] + way(s) * step,
                way.deriv()(s) * step / span,
                way.deriv(2)(s) * step / span**2,
            )


def main():
    assert pin.__version__ == PINOCCHIO, f"pinocchio {PINOCCHIO} is wanted, {pin.__version__} is here"
    for path in sorted(ROBOTS.glob("*.dh")):
        model, joint, frame = read(path)
        data = model.createData()
        text = f"# By pinocchio {PINOCCHIO} and serial_arm.py: time, q, qd, qdd, R by rows, p, tau.\n"
        for time, q, qd, qdd in motion(path.with_suffix(".motion")):
            tau = pin.rnea(model, data, q, qd, qdd).copy()
            pin.forwardKinematics(model, data, q)
            pose = data.oMi[joint] * frame
            numbers = np.concatenate([[time], q, qd, qdd, pose.rotation.flatten(), pose.translation, tau])
            text += " ".join(repr(float(x)) for x in numbers) + "\n"
        out = HERE / f"{path.stem}.txt"
        out.write_text(text, encoding="utf-8")
        print(f"{out.name}: {model.nv} joints, {len(text) / 1000:.0f} kB")


if __name__ == "__main__":
    main()
