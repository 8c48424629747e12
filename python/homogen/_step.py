"""Time steps of a robot and their derivatives, over arrays of states, by the rules of `homogen::step` in Rust.

A vector over velocities is an array (..., n, 1 + m): its value, and m columns of derivatives by q, q̇ and τ of the start, or
none. Sums then hold for both at once.
"""

import numpy as np

from . import results

INTEGRATORS = ("semi_implicit", "euler", "rk4")


def step(robot, integrator, q, qd, tau, dt, actions, derivatives):
    """The state after `dt`, or its derivatives."""
    if integrator not in INTEGRATORS:
        raise ValueError(f"integrator is {', '.join(INTEGRATORS)}, and not {integrator!r}")
    refuse_loops(robot)
    n = robot.NV
    dtype = number_type(q, qd, tau)
    q, qd, tau = map(np.asarray, (q, qd, tau))
    axes = np.broadcast_shapes(np.shape(dt), *(array.shape[:-1] for array in (q, qd, tau)))
    dt = np.asarray(dt, dtype)[..., None, None]
    columns = 3 * n if derivatives else 0

    def carried(value, first):
        """A vector with the derivatives of that entry of the start."""
        array = np.zeros((*axes, n, 1 + columns), dtype)
        array[..., 0] = value
        if derivatives and first is not None:
            array[..., 1 + first : 1 + first + n] = np.eye(n)
        return array

    def accelerations(q, by, qd):
        given = (q, qd[..., 0], tau, *actions)
        found = carried(robot.forward_dynamics(*given), None)
        if derivatives:
            of = robot.forward_dynamics_derivatives(*given)
            found[..., 1:] = of.dq @ by + of.dqd @ qd[..., 1:]
            found[..., 1 + 2 * n :] += of.dtau
        return found

    def moved_by(q, by, x):
        by = moved(robot._motions, by, x[..., 0], x[..., 1:]) if derivatives else by
        return robot.integrate(q, x[..., 0]), by

    # The configuration, and its derivatives along velocities.
    start = np.broadcast_to(q, (*axes, robot.NQ)).astype(dtype), carried(0, 0)[..., 1:]
    v1 = carried(qd, n)
    a1 = accelerations(*start, v1)
    if integrator == "semi_implicit":
        faster = v1 + dt * a1
        end = moved_by(*start, dt * faster)
    elif integrator == "euler":
        faster = v1 + dt * a1
        end = moved_by(*start, dt * v1)
    else:
        half = dt / 2
        second, v2 = moved_by(*start, half * v1), v1 + half * a1
        a2 = accelerations(*second, v2)
        third, v3 = moved_by(*start, half * v2), v1 + half * a2
        a3 = accelerations(*third, v3)
        # From the second state, so that both motions together are of the order of the rule.
        fourth, v4 = moved_by(*second, dt * v3 - half * v1), v1 + dt * a3
        a4 = accelerations(*fourth, v4)
        faster = v1 + dt / 6 * (a1 + 2 * a2 + 2 * a3 + a4)
        middle = moved_by(*start, dt / 12 * (3 * v1 + 2 * v2 + 2 * v3 - v4))
        end = moved_by(*middle, dt / 12 * (-v1 + 2 * v2 + 2 * v3 + 3 * v4))
    q, by = end
    if not derivatives:
        return results.NextState(q, faster[..., 0].copy())
    blocks = [array[..., first : first + n] for array in (by, faster[..., 1:]) for first in (0, n, 2 * n)]
    return results.StepDerivatives(*blocks)


def refuse_loops(robot):
    if robot.constraint_names:
        raise ValueError(f"{robot.name!r} has loops, which a step would open: there are no steps")


def number_type(*arrays):
    """Single precision where all arrays have it."""
    return np.float32 if {np.asarray(array).dtype for array in arrays} == {np.dtype(np.float32)} else np.float64


def moved(motions, by, step, by_step):
    """The derivatives of a configuration that is moved by a step: those along a screw are sums."""
    after = by + by_step
    first = 0
    for motion in motions:
        # Angular and linear entries among the joint's velocities.
        count, omega, v = {
            "along": (1, (), ()),
            "mimic": (0, (), ()),
            "planar": (3, (2,), (0, 1)),
            "spherical": (3, (0, 1, 2), ()),
            "floating": (6, (3, 4, 5), (0, 1, 2)),
        }[motion]
        if omega:
            # Which of six entries of a displacement the joint has, angular first.
            own = [2] if motion == "planar" else [0, 1, 2]
            own += [3 + k for k in range(len(v))]
            rows = [first + k for k in (*omega, *v)]
            x = np.zeros((*step.shape[:-1], 6), step.dtype)
            x[..., own] = step[..., rows]
            before, of_step = (matrix[..., own, :][..., own] for matrix in _change(x[..., :3], x[..., 3:]))
            after[..., rows, :] = before @ by[..., rows, :] + of_step @ by_step[..., rows, :]
        first += count
    return after


def _change(omega, v):
    """Two matrices (..., 6, 6), angular first: the change of a body's displacement due to one before a step (ω, v) in its own
    axes, and due to one of the step. `homogen::step` has the formulas."""
    square = np.sum(omega * omega, -1)[..., None, None] + 1e-20
    angle = np.sqrt(square)
    sine, ratio = np.sin(angle), np.sin(angle / 2) / angle
    bend = 2 * ratio * ratio
    bulge = _minus_sine(angle, sine) / (square * angle)
    turn = sine / angle
    share = np.sum(omega * v, -1)[..., None, None]
    w, along, one = _skew(omega), _skew(v), np.eye(3)
    twice = w @ w
    back = one - turn * w + bend * twice
    e = one - bend * w + bulge * twice
    f = bulge * (w @ along + along @ w) - bend * along
    f = f + share * ((bend - 3 * bulge) / square * twice - (turn - 2 * bend) / square * w)
    shift = _skew((e @ v[..., None])[..., 0])
    before, of_step = (np.zeros((*omega.shape[:-1], 6, 6), omega.dtype) for _ in range(2))
    before[..., :3, :3] = before[..., 3:, 3:] = back
    before[..., 3:, :3] = -shift @ back
    of_step[..., :3, :3] = of_step[..., 3:, 3:] = e
    of_step[..., 3:, :3] = f
    return before, of_step


def _minus_sine(angle, sine):
    """φ − sin φ, by its series up to 2 rad, where the difference would cancel."""
    small = np.minimum(angle, 2)
    square = small * small
    bracket = np.ones_like(small)
    for k in range(12, 1, -1):
        bracket = 1 - square / (2 * k * (2 * k + 1)) * bracket
    return np.where(angle > 2, angle - sine, small * square * bracket / 6)


def _skew(v):
    matrix = np.zeros((*v.shape, 3), v.dtype)
    for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        matrix[..., k, j] = v[..., i]
        matrix[..., j, k] = -v[..., i]
    return matrix
