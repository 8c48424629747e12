#!/usr/bin/env python3
"""Makes the reference values of the derivatives of every shipped robot.

In: robots/*.urdf and the first states of tests/reference/<robot>.json. Out:
tests/reference/<robot>_derivatives.json, Pinocchio's results at these states, every f64 in full. The tests
read the JSON and never run this script.

    python3 -m venv venv && venv/bin/pip install -r tests/reference/requirements.txt
    venv/bin/python tests/reference/derivatives.py
"""

import json
from pathlib import Path

import numpy as np
import pinocchio as pin

HERE = Path(__file__).resolve().parent
ROBOTS = HERE.parent.parent / "robots"
PINOCCHIO = "4.1.0"
STATES = 4

CONVENTIONS = (
    "as in the file beside it, whose first states these are, in that order; a row for each force or "
    "acceleration; tau_dq, tau_dv of rnea(q,v,a); gravity_dq of rnea(q,0,0); ddq_dq, ddq_dv, ddq_dtau of "
    "aba(q,v,torque); coriolis as there"
)


def rows(matrix):
    return [[float(x) for x in row] for row in np.asarray(matrix)]


def evaluate(model, state):
    data = model.createData()
    q, v, a, torque = (np.array(state[name]) for name in ("q", "v", "a", "torque"))
    tau_dq, tau_dv, _ = (x.copy() for x in pin.computeRNEADerivatives(model, data, q, v, a))
    ddq_dq, ddq_dv, ddq_dtau = (
        x.copy() for x in pin.computeABADerivatives(model, data, q, v, torque)
    )
    gravity_dq = pin.computeGeneralizedGravityDerivatives(model, data, q).copy()
    coriolis = pin.computeCoriolisMatrix(model, data, q, v).copy()
    mass = pin.crba(model, data, q).copy()
    mass = np.triu(mass) + np.triu(mass, 1).T
    ddq_dtau = np.triu(ddq_dtau) + np.triu(ddq_dtau, 1).T

    assert np.allclose(mass @ ddq_dtau, np.eye(model.nv), rtol=0, atol=1e-9)
    step = 1e-6
    for k in range(model.nv):
        along = np.eye(model.nv)[k] * step
        near = pin.rnea(model, data, q + along, v, a) - pin.rnea(model, data, q - along, v, a)
        size = 1 + np.max(np.abs(tau_dq))
        assert np.allclose(near / (2 * step), tau_dq[:, k], rtol=0, atol=1e-6 * size)
    return {
        "tau_dq": rows(tau_dq),
        "tau_dv": rows(tau_dv),
        "gravity_dq": rows(gravity_dq),
        "ddq_dq": rows(ddq_dq),
        "ddq_dv": rows(ddq_dv),
        "ddq_dtau": rows(ddq_dtau),
        "coriolis": rows(coriolis),
    }


def make(name):
    model = pin.buildModelFromUrdf(str(ROBOTS / f"{name}.urdf"))
    states = json.loads((HERE / f"{name}.json").read_text(encoding="utf-8"))["states"]
    head = {
        "robot": name,
        "urdf": f"robots/{name}.urdf",
        "made_with": f"pinocchio {PINOCCHIO}",
        "conventions": CONVENTIONS,
    }
    states = [evaluate(model, state) for state in states[:STATES]]
    text = json.dumps(head, separators=(",", ":"))[:-1] + ',"states":[\n'
    text += ",\n".join(json.dumps(state, separators=(",", ":")) for state in states) + "\n]}\n"
    path = HERE / f"{name}_derivatives.json"
    path.write_text(text, encoding="utf-8")
    print(f"{path.name}: {model.nv} joints, {len(text) / 1000:.0f} kB")


def main():
    assert pin.__version__ == PINOCCHIO, f"pinocchio {PINOCCHIO} is wanted, {pin.__version__} is here"
    for path in sorted(ROBOTS.glob("*.urdf")):
        make(path.stem)


if __name__ == "__main__":
    main()
