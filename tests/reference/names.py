#!/usr/bin/env python3
"""Checks the table of names in guide/src/coming-from.md: names of functions, and orders of rows.

In: the Panda-class arm at a random state. Out: a line for each pair of functions, and exit status 1 if a
pair differs. Needs the packages of make.py, and the command line:

    cargo build -p homogen-cli --bin homogen
    venv/bin/python tests/reference/names.py target/debug/homogen
"""

import json
import subprocess
import sys
from pathlib import Path

import numpy as np
import pinocchio as pin

ROBOTS = Path(__file__).resolve().parent.parent.parent / "robots"
URDF, TIP = str(ROBOTS / "panda_class.urdf"), "link8"
TOLERANCE = 1e-11


class Ours:
    """The functions of an arm at one state, by the command line."""

    def __init__(self, program, state):
        self.program, self.states = program, json.dumps({"states": [state]})

    def __getattr__(self, function):
        command = [self.program, "eval", URDF, "--tip", TIP, "--function", function]
        command += ["--states", "/dev/stdin", "--format", "json"]
        answer = subprocess.run(command, input=self.states, capture_output=True, text=True, check=True)
        result = json.loads(answer.stdout)["results"][0]
        if isinstance(result, dict):
            return {name: np.array(part) for name, part in result.items()}
        return np.array(result)


def linear_first(angular_first):
    return np.vstack([angular_first[3:], angular_first[:3]])


def vector(matrix):
    """Entries of a matrix with the structure of W or Γ, linear first."""
    return np.array([*matrix[:3, 3], matrix[2, 1], matrix[0, 2], matrix[1, 0]])


def parameters():
    """Pinocchio's parameters of a body from ours: moments of inertia from second moments."""
    xx, xy, xz, yy, yz, zz = range(4, 10)
    of = np.zeros((10, 10))
    of[range(4), range(4)] = 1.0  # m, q
    of[4, [yy, zz]] = of[6, [xx, zz]] = of[9, [xx, yy]] = 1.0  # I_xx, I_yy, I_zz
    of[5, xy] = of[7, xz] = of[8, yz] = -1.0
    return of


def pairs(ours, q, v, a, torque):
    model = pin.buildModelFromUrdf(URDF)
    data = model.createData()
    frame = model.getFrameId(TIP)
    pin.forwardKinematics(model, data, q, v, a)
    pin.updateFramePlacements(model, data)
    pin.computeJointJacobians(model, data, q)
    pin.computeJointJacobiansTimeVariation(model, data, q, v)
    pose = data.oMf[frame].homogeneous.copy()
    yield "forward_kinematics", ours.forward_kinematics, pose
    for name, of in [("spatial", pin.WORLD), ("body", pin.LOCAL), ("geometric", pin.LOCAL_WORLD_ALIGNED)]:
        jacobian = pin.getFrameJacobian(model, data, frame, of).copy()
        rate = pin.getFrameJacobianTimeVariation(model, data, frame, of).copy()
        yield f"{name}_jacobian", linear_first(getattr(ours, f"{name}_jacobian")), jacobian
        yield f"{name}_jacobian_rate", linear_first(getattr(ours, f"{name}_jacobian_rate")), rate
    w, h = ours.velocity, ours.acceleration
    yield "velocity", vector(w), pin.getFrameVelocity(model, data, frame, pin.WORLD).vector
    spatial = pin.getFrameAcceleration(model, data, frame, pin.WORLD).vector
    yield "acceleration, Ẇ", vector(h - w @ w), spatial
    classical = pin.getFrameClassicalAcceleration(model, data, frame, pin.LOCAL_WORLD_ALIGNED).linear
    yield "acceleration, H P", (h @ pose[:, 3])[:3], classical
    yield "inverse_dynamics", ours.inverse_dynamics, pin.rnea(model, data, q, v, a)
    yield "bias", ours.bias, pin.nle(model, data, q, v)
    yield "gravity", ours.gravity, pin.computeGeneralizedGravity(model, data, q)
    yield "gravity_derivative", ours.gravity_derivative, pin.computeGeneralizedGravityDerivatives(model, data, q)
    yield "mass_matrix", ours.mass_matrix, pin.crba(model, data, q)
    yield "mass_matrix_inverse", ours.mass_matrix_inverse, pin.computeMinverse(model, data, q)
    yield "forward_dynamics", ours.forward_dynamics, pin.aba(model, data, q, v, torque)
    yield "coriolis_matrix", ours.coriolis_matrix, pin.computeCoriolisMatrix(model, data, q, v)
    dq, dv, _ = pin.computeRNEADerivatives(model, data, q, v, a)
    derivatives = ours.inverse_dynamics_derivatives
    yield "inverse_dynamics_derivatives, dq", derivatives["dq"], dq
    yield "inverse_dynamics_derivatives, dqd", derivatives["dqd"], dv
    parts = pin.computeABADerivatives(model, data, q, v, torque)
    derivatives = ours.forward_dynamics_derivatives
    for name, part in zip(["dq", "dqd", "dtau"], parts):
        yield f"forward_dynamics_derivatives, {name}", derivatives[name], part
    regressor = pin.computeJointTorqueRegressor(model, data, q, v, a)
    yield "regressor", ours.regressor, regressor @ np.kron(np.eye(model.nv), parameters())
    yield "kinetic_energy", ours.kinetic_energy, pin.computeKineticEnergy(model, data, q, v)
    yield "potential_energy", ours.potential_energy, pin.computePotentialEnergy(model, data, q)
    yield "center_of_mass", ours.center_of_mass, pin.centerOfMass(model, data, q, v, a)
    yield "center_of_mass_velocity", ours.center_of_mass_velocity, data.vcom[0]
    yield "center_of_mass_jacobian", ours.center_of_mass_jacobian, pin.jacobianCenterOfMass(model, data, q)
    map_ = pin.ccrba(model, data, q, v).copy()
    yield "centroidal_momentum_matrix", linear_first(ours.centroidal_momentum_matrix), map_
    yield "centroidal_momentum", vector(ours.centroidal_momentum), data.hg.vector
    yield "centroidal_momentum_bias", vector(ours.centroidal_momentum_bias), pin.dccrba(model, data, q, v) @ v


def main():
    random = np.random.default_rng(1)
    q, v, a, torque = (random.uniform(-1, 1, 7) for _ in range(4))
    q[3] -= 1.5
    state = {"q": list(q), "qd": list(v), "qdd": list(a), "tau": list(torque)}
    wrong = 0
    for name, ours, theirs in pairs(Ours(sys.argv[1], state), q, v, a, torque):
        ours, theirs = np.ravel(ours), np.ravel(theirs)
        difference = np.max(np.abs(ours - theirs)) / max(1.0, np.max(np.abs(theirs)))
        wrong += not difference < TOLERANCE
        print(f"{name:36} {difference:8.1e}")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
