"""The implicit midpoint rule over arrays of states, as an equation for the velocities after a step, as in `homogen::step` in
Rust: q⁺ = q ⊕ Δt w with w = (q̇ + q̇⁺)/2, and inverse dynamics at q ⊕ Δt w/2, w and (q̇⁺ − q̇)/Δt needs τ.
"""

import numpy as np

from . import results
from ._step import moved, number_type, refuse_loops


def residual(robot, q, qd, next_qd, tau, dt, actions):
    """The torques and forces that velocities need, less τ."""
    q, qd, next_qd, tau, dt = _arrays(robot, q, qd, next_qd, tau, dt)
    mean, second = _rates(qd, next_qd, dt)
    return robot.inverse_dynamics(robot.integrate(q, dt / 2 * mean), mean, second, *actions) - tau


def derivatives(robot, q, qd, next_qd, dt, actions):
    """The derivatives of the residual by q, q̇ and q̇⁺."""
    q, qd, next_qd, dt = _arrays(robot, q, qd, next_qd, dt)
    mean, second = _rates(qd, next_qd, dt)
    step = np.broadcast_to(dt / 2 * mean, np.broadcast_shapes((*q.shape[:-1], robot.NV), (dt * mean).shape))
    middle, dt = robot.integrate(q, step), dt[..., None]
    one = np.broadcast_to(np.eye(robot.NV, dtype=step.dtype), (*step.shape, robot.NV))
    zero = np.zeros_like(one)
    by_q, by_mean = moved(robot._motions, one, step, zero), moved(robot._motions, zero, step, dt / 2 * one)
    of = robot.inverse_dynamics_derivatives(middle, mean, second, *actions)
    half, inertia = (of.dq @ by_mean + of.dqd) / 2, robot.mass_matrix(middle) / dt
    return results.MidpointDerivatives(of.dq @ by_q, half - inertia, half + inertia)


def configuration(robot, q, qd, next_qd, dt):
    """The configuration after the step."""
    q, qd, next_qd, dt = _arrays(robot, q, qd, next_qd, dt)
    return robot.integrate(q, dt * _rates(qd, next_qd, dt)[0])


def _arrays(robot, *given):
    """All but the last as arrays of one type, and the duration as one beside their entries."""
    refuse_loops(robot)
    dtype = number_type(*given[:-1])
    return [*(np.asarray(array, dtype) for array in given[:-1]), np.asarray(given[-1], dtype)[..., None]]


def _rates(qd, next_qd, dt):
    """The mean of the velocities, and the accelerations that lead from one to the other."""
    return (qd + next_qd) / 2, (next_qd - qd) / dt
