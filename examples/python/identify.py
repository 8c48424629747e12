"""Identification by gradients in PyTorch: offsets of encoders, friction, and a payload of an arm, from measured torques.

First the arm moves without a load. Offsets of the angles and viscous friction are found by descent through
`arm.torch.inverse_dynamics`, whose backward pass is generated. Then it holds a payload. Torques are linear in the ten inertial
parameters of a body, τ = Y π with `arm.regressor`, but only those parameters are a body's whose pseudo-inertia J, second
moments beside first moments and mass, is positive definite: J = L Lᵗ with a positive diagonal of L, so that every step of the
descent is a body.

    python identify.py [--states 2000] [--noise 0.05]

It prints what was found beside what was true. Needs the package `homogen` and PyTorch.
"""

import argparse
from pathlib import Path

import numpy as np
import torch

import homogen

URDF = Path(__file__).resolve().parents[2] / "robots" / "panda_class.urdf"
#: What the measurements are made with: offsets in rad, friction in N m s, mass in kg, its centre in m in the last link's frame.
#: No torque depends on the angle of the first joint, whose axis is vertical.
OFFSETS = np.array([0.0, -0.02, 0.015, 0.03, -0.01, 0.02, -0.025])
FRICTION = np.array([1.0, 1.2, 0.9, 0.8, 0.3, 0.25, 0.2])
MASS, CENTRE, RADIUS = 1.5, np.array([0.02, -0.01, 0.12]), 0.05


def minimised(parameters, loss, steps=60):
    """Descends to the least loss by L-BFGS."""
    optimiser = torch.optim.LBFGS(parameters, max_iter=steps, line_search_fn="strong_wolfe", tolerance_grad=1e-10)

    def closure():
        optimiser.zero_grad()
        value = loss()
        value.backward()
        return value

    optimiser.step(closure)


def calibrated(arm, q, qd, qdd, torques):
    """Offsets of the encoders and viscous friction: the angles are q and the offsets."""
    offsets, friction = torch.zeros(arm.NV, dtype=torch.float64), torch.zeros(arm.NV, dtype=torch.float64)
    parameters = [offsets.requires_grad_(), friction.requires_grad_()]
    given = [torch.tensor(array) for array in (q, qd, qdd, torques)]

    def loss():
        angles, rates, seconds, measured = given
        found = arm.torch.inverse_dynamics(angles + offsets, rates, seconds) + friction * rates
        return (found - measured).square().mean()

    minimised(parameters, loss)
    return offsets.detach().numpy(), friction.detach().numpy()


def payload(columns, residual):
    """π of a body from its columns of the regressor and the torques that it adds: m, first moments, second moments."""
    # L of the pseudo-inertia, with the logarithms of its diagonal; at first half a kilogram in a ball.
    rows, places = np.tril_indices(4)
    entries = torch.tensor(np.where(rows == places, np.log([0.05] * 10), 0.0))
    with torch.no_grad():
        entries[-1] = np.log(np.sqrt(0.5))
    entries.requires_grad_()
    matrix, wanted = torch.tensor(columns), torch.tensor(residual)

    def pi():
        factor = torch.zeros(4, 4, dtype=torch.float64)
        factor[rows, places] = torch.where(torch.tensor(rows == places), entries.exp(), entries)
        j = factor @ factor.T
        return torch.stack([j[3, 3], *j[3, :3], j[0, 0], j[0, 1], j[0, 2], j[1, 1], j[1, 2], j[2, 2]])

    minimised([entries], lambda: (matrix @ pi() - wanted).square().mean(), 200)
    return pi().detach().numpy()


def body(mass, centre, radius):
    """π of a homogeneous ball."""
    second = mass * (np.outer(centre, centre) + np.eye(3) * radius**2 / 5)
    return np.array([mass, *mass * centre, *second[np.triu_indices(3)]])


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--states", type=int, default=2000)
    parser.add_argument("--noise", type=float, default=0.05, help="deviation of measured torques in N m")
    asked = parser.parse_args()
    arm = homogen.load(URDF, tip="link8")
    rng = np.random.default_rng(0)

    def measured(load):
        """States by the encoders, and torques."""
        q = arm.random(rng, asked.states)
        qd, qdd = rng.uniform(-2, 2, (2, asked.states, arm.NV))
        tau = arm.inverse_dynamics(q, qd, qdd) + FRICTION * qd + arm.regressor(q, qd, qdd)[..., -10:] @ load
        return q - OFFSETS, qd, qdd, tau + asked.noise * rng.standard_normal(tau.shape)

    offsets, friction = calibrated(arm, *measured(np.zeros(10)))
    print("offset [rad]     found", np.round(offsets, 4), " true", OFFSETS)
    print("friction [N m s] found", np.round(friction, 3), " true", FRICTION)

    load = body(MASS, CENTRE, RADIUS)
    q, qd, qdd, tau = measured(load)
    q = q + offsets
    residual = tau - arm.inverse_dynamics(q, qd, qdd) - friction * qd
    found = payload(arm.regressor(q, qd, qdd)[..., -10:].reshape(-1, 10), residual.reshape(-1))
    print(f"mass [kg]        found {found[0]:.4f}  true {MASS}")
    print("centre [m]       found", np.round(found[1:4] / found[0], 4), " true", CENTRE)
    print("second [kg m²]   found", np.round(found[4:], 4), " true", np.round(load[4:], 4))


if __name__ == "__main__":
    main()
