"""A program that is type-checked, and runs: what its annotations say is what the package returns."""

import sys
from typing import Any

import numpy as np
from numpy.typing import NDArray

import homogen


def main(file: str) -> None:
    arm: homogen.Robot = homogen.load(file, tip="link8", lock={"joint7": 0.1}, fields={"mass": "mass_of:link6"})
    arm.mass = 1.5
    q = arm.random(0, (20,))
    qd = np.zeros_like(q)
    tau: NDArray[np.floating[Any]] = arm.inverse_dynamics(q, qd, qdd=qd)
    jacobian = arm.spatial_jacobian(q, frame="link3", order="angular_first")
    derivatives = arm.inverse_dynamics_derivatives(q, qd, qd)
    parts: homogen.results.InverseDynamicsDerivatives = derivatives
    assert parts.dqd.shape == (20, 6, 6) and tau.shape == (20, arm.NV) and jacobian.shape == (20, 6, 6)
    after: homogen.results.NextState = arm.step(q, qd, tau, 1e-3, integrator="rk4")
    a: NDArray[np.floating[Any]] = arm.step_derivatives(q, qd, tau, 1e-3).a
    assert after.q.shape == (20, 6) and a.shape == (20, 12, 12)
    energy = float(arm.kinetic_energy(q[0], qd[0]))
    text: str | None = arm.generate("c", "gravity", scalar="f32")
    assert energy == 0.0 and text is not None and arm.tip == "link8"


main(sys.argv[1])
