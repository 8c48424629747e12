"""Model predictive path integral control of an arm: its hand moves to a point within the limits of joints and torques.

Each control step draws random accelerations over a horizon, follows all of them at once, and applies the mean of the better
ones. Positions of the hand come from `forward_kinematics` and torques from `inverse_dynamics`, for all rollouts and times in
one call each, in single precision. The arm itself moves by `step`, in double precision.

    python mppi.py [--rollouts 1024] [--steps 150] [--threads 1]

It prints the distance to the point, the largest torque in parts of its limit, and rollouts a second a core. Needs the package `homogen` alone.
"""

import argparse
import os
import time
from pathlib import Path

import numpy as np

import homogen

URDF = Path(__file__).resolve().parents[2] / "robots" / "panda_class.urdf"
TARGET = np.array([0.4, -0.35, 0.45], np.float32)
#: Times of the horizon, their distance in s, and the deviation of accelerations in rad/s².
HORIZON, DT, DEVIATION = 12, 0.04, 3.0
#: Costs per metre of distance, per (rad/s)² at the end, per N m beyond a limit and per rad beyond one.
DISTANCE, SPEED, TORQUE, RANGE = 20.0, 0.2, 0.1, 100.0
#: Cost by which a rollout may be worse and still count.
TEMPERATURE = 0.2


class Controller:
    """Accelerations over a horizon, which each call of `control` improves and moves on."""

    def __init__(self, arm, rollouts, seed=0):
        self.arm = arm
        self.rng = np.random.default_rng(seed)
        self.mean = np.zeros((HORIZON, arm.NV), np.float32)
        # Rollouts are the last axis, so that they lie side by side. Random numbers are drawn once; each control step
        # begins elsewhere in them.
        self.shape = HORIZON, arm.NV, rollouts
        self.table = self.rng.standard_normal(4 * np.prod(self.shape), np.float32) * np.float32(DEVIATION)
        limits = arm.lower, arm.upper, arm.max_effort
        self.lower, self.upper, self.effort = (limit.astype(np.float32)[:, None] for limit in limits)
        self.v, self.q, self.tau, self.rest = (np.empty(self.shape, np.float32) for _ in range(4))
        self.poses = np.empty((HORIZON, 4, 4, rollouts), np.float32)

    def control(self, q, qd):
        """The acceleration to apply at a state."""
        begin = self.rng.integers(3 * np.prod(self.shape))
        noise = self.table[begin : begin + np.prod(self.shape)].reshape(self.shape)
        cost = self.cost(q, qd, self.mean[..., None] + noise)
        weights = np.exp((cost.min() - cost) / np.float32(TEMPERATURE))
        self.mean += noise @ (weights / weights.sum())
        first = self.mean[0].copy()
        self.mean[:-1] = self.mean[1:]
        self.mean[-1] = 0
        return first

    def cost(self, q, qd, qdd):
        """The costs of accelerations (horizon, n, rollouts), each constant for `DT`."""
        before = [vector.astype(np.float32)[:, None] for vector in (q, qd)]
        for v, x, a in zip(self.v, self.q, qdd):
            np.multiply(a, np.float32(DT), out=v)
            v += before[1]
            np.multiply(v, np.float32(DT), out=x)
            x += before[0]
            before = x, v
        # Arrays are read and written where they lie.
        states = [array.swapaxes(1, 2) for array in (self.q, self.v, qdd)]
        self.arm.inverse_dynamics(*states, out=self.tau.swapaxes(1, 2))
        self.arm.forward_kinematics(states[0], out=np.moveaxis(self.poses, -1, 1))
        distance = np.sqrt(sum(np.square(self.poses[:, k, 3] - TARGET[k]) for k in range(3)))
        cost = np.float32(DISTANCE) * distance.sum(0) + np.float32(SPEED) * np.square(self.v[-1]).sum(0)
        cost += np.float32(TORQUE) * self.beyond(self.tau, -self.effort, self.effort)
        return cost + np.float32(RANGE) * self.beyond(self.q, self.lower, self.upper)

    def beyond(self, array, lower, upper):
        """How far entries are beyond limits, summed over joints and times."""
        np.clip(array, lower, upper, out=self.rest)
        np.subtract(array, self.rest, out=self.rest)
        return np.abs(self.rest, out=self.rest).sum((0, 1))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rollouts", type=int, default=1024)
    parser.add_argument("--steps", type=int, default=150)
    parser.add_argument("--threads", type=int, default=1)
    options = parser.parse_args()
    arm = homogen.load(URDF, tip="link8", threads=options.threads)
    controller = Controller(arm, options.rollouts)
    q, qd = np.array([0.0, -0.5, 0.0, -2.0, 0.0, 1.5, 0.8]), np.zeros(arm.NV)
    controller.control(q, qd)  # the first call compiles
    worst, seconds = 0.0, []
    for step in range(options.steps):
        began = time.perf_counter()
        qdd = controller.control(q, qd)
        seconds.append(time.perf_counter() - began)
        tau = np.clip(arm.inverse_dynamics(q, qd, qdd.astype(float)), -arm.max_effort, arm.max_effort)
        worst = max(worst, np.abs(tau / arm.max_effort).max())
        q, qd = arm.step(q, qd, tau, DT, integrator="rk4")
        if step % 25 == 24:
            print(f"{DT * (step + 1):5.2f} s: {1e3 * np.linalg.norm(arm.forward_kinematics(q)[:3, 3] - TARGET):6.1f} mm")
    median = np.median(seconds)
    cores = min(options.threads, os.cpu_count() or 1)
    print(f"largest torque: {worst:.2f} of its limit")
    print(f"{options.rollouts} rollouts of {HORIZON} times in {1e3 * median:.1f} ms: {options.rollouts / median / cores:.2e} a second a core")


if __name__ == "__main__":
    main()
