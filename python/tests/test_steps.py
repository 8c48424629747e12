"""Time steps: the classical rules where coordinates are added, convergence with quaternions, derivatives by differences; the
implicit midpoint rule, whose steps can be taken back."""

import numpy as np
import pytest
from conftest import robot, states

import homogen

#: A planar, a ball and a mimic joint.
WALKER = """
link world;
joint puck: planar([0.0, 0.6, 0.8]) { from: world, to: puck, at: xyz(0.2, 0.0, 0.1) rpy(0.1, 0.2, 0.3) }
link puck { mass: 3.0, com: [0.05, 0.02, 0.1], inertia: [0.04, 0.001, 0.002, 0.05, -0.003, 0.06] }
joint ball: spherical { from: puck, to: upper, at: xyz(0.1, -0.2, 0.3) rpy(0.5, -0.4, 0.3) }
link upper { mass: 2.0, com: [0.0, 0.1, 0.2], inertia: [0.03, 0.001, -0.002, 0.025, 0.001, 0.02] }
joint hinge: revolute(y) { from: upper, to: fore, at: xyz(0.0, 0.05, 0.4) rpy(0.2, 0.0, 0.0) }
link fore { mass: 1.0, com: [0.02, 0.0, 0.15], inertia: [0.01, 0.01, 0.003] }
joint copy: revolute(x) { from: fore, to: hand, at: xyz(0.0, 0.05, 0.4), mimic: hinge, multiplier: 0.5 }
link hand { mass: 0.5, com: [0.0, 0.01, 0.05], inertia: [0.002, 0.002, 0.001] }
"""

INTEGRATORS = ["semi_implicit", "euler", "rk4"]


def drawn(of, count, seed=0):
    return states(of, ["q", "qd", "tau"], count, float, seed)


def loaded(case):
    return homogen.load(WALKER) if case == "walker" else robot(case)


def by_differences(n, change, difference, small=1e-6):
    """A column for each entry of three vectors: the difference of what `change` gives for a small step back and ahead."""
    columns = []
    for step in small * np.eye(3 * n):
        less, more = (change(sign, *np.split(step, 3)) for sign in (-1, 1))
        columns.append(difference(less, more) / (2 * small))
    return np.stack(columns, -1)


def test_an_arm_moves_by_the_classical_rules():
    of = robot("arm")
    q, qd, tau = drawn(of, 10)
    dt = 0.01

    def rate(q, qd):
        return np.stack([qd, of.forward_dynamics(q, qd, tau)])

    state = np.stack([q, qd])
    k1 = rate(*state)
    k2 = rate(*(state + dt / 2 * k1))
    k3 = rate(*(state + dt / 2 * k2))
    k4 = rate(*(state + dt * k3))
    assert np.allclose(of.step(q, qd, tau, dt, integrator="rk4"), state + dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4), atol=1e-11)
    assert np.allclose(of.step(q, qd, tau, dt, integrator="euler"), state + dt * k1)
    faster = qd + dt * k1[1]
    assert np.allclose(of.step(q, qd, tau, dt), [q + dt * faster, faster])


@pytest.mark.parametrize("integrator,order", list(zip(INTEGRATORS, [1, 1, 4])))
def test_steps_have_their_orders_with_quaternions(integrator, order):
    of = robot("floating")
    q, qd, tau = drawn(of, 5, seed=2)

    def after(integrator, steps):
        state = q, 0.3 * qd
        for _ in range(steps):
            state = of.step(*state, tau * 0.02, 0.05 / steps, integrator=integrator)
        return state

    exact = after("rk4", 400)

    def error(steps):
        found = after(integrator, steps)
        return max(np.abs(of.difference(found[0], exact[0])).max(), np.abs(found[1] - exact[1]).max())

    assert abs(np.log2(error(16) / error(32)) - order) < 0.3


@pytest.mark.parametrize("integrator", INTEGRATORS)
@pytest.mark.parametrize("case", ["arm", "floating", "walker"])
def test_derivatives_are_those_of_differences(case, integrator):
    of = loaded(case)
    q, qd, tau = drawn(of, 3, seed=3)
    tau, dt, n = 0.1 * tau, 0.01, of.NV
    by = of.step_derivatives(q, qd, tau, dt, integrator=integrator)

    def change(sign, x, v, f):
        return of.step(of.integrate(q, sign * x), qd + sign * v, tau + sign * f, dt, integrator=integrator)

    def difference(less, more):
        return np.concatenate([of.difference(less.q, more.q), more.qd - less.qd], -1)

    expected = by_differences(n, change, difference)
    found = np.concatenate([by.a, by.b], -1)
    assert np.allclose(found, expected, atol=1e-7 * np.abs(expected).max())


def test_rotations_of_any_size_have_derivatives():
    of = robot("floating")
    q, qd, _ = drawn(of, 1, seed=4)
    direction = qd[..., 3:6] / np.linalg.norm(qd[..., 3:6])
    for angle in [0.0, 1e-12, 1e-9, 1e-6, 1e-3, 1.0, 3.0, 7.0]:
        qd[..., 3:6] = direction * angle
        by = of.step_derivatives(q, qd, 0 * qd, 1.0, integrator="euler")
        small = 1e-6
        for k in range(6):
            change = np.zeros(of.NV)
            change[k] = small
            less, more = (of.step(q, qd + sign * change, 0 * qd, 1.0, integrator="euler").q for sign in (-1, 1))
            assert np.allclose(by.q_by_qd[0, :, k], of.difference(less, more)[0] / (2 * small), atol=1e-8), (angle, k)


def test_shapes_types_and_durations_broadcast():
    of = robot("arm")
    q, qd, tau = drawn(of, 6)
    some = of.step(q, qd[0], tau[:1], np.linspace(0.001, 0.01, 6), integrator="rk4")
    assert some.q.shape == (6, 7)
    one = of.step(q[3], qd[0], tau[0], 0.0064, integrator="rk4")
    assert np.allclose(some.q[3], one.q) and one.q.shape == (7,)
    single = of.step_derivatives(*(array.astype(np.float32) for array in (q, qd, tau)), 0.01)
    assert single.q_by_q.dtype == np.float32 and single.b.shape == (6, 14, 7)
    assert of.step(q.tolist(), qd.tolist(), tau.tolist(), 0.01).q.dtype == np.float64


def test_external_wrenches_are_constant():
    of = robot("external")
    q, qd, tau, actions = states(of, ["q", "qd", "tau", "actions"], 4, float)
    found = of.step(q, qd, tau, 0.01, actions)
    assert np.allclose(found.qd, qd + 0.01 * of.forward_dynamics(q, qd, tau, actions))


def by_the_midpoint_rule(of, q, qd, tau, dt, *actions):
    """The state after a step, by Newton's method from the velocities before it."""
    faster = qd
    for _ in range(8):
        rest = of.midpoint_residual(q, qd, faster, tau, dt, *actions)
        slope = of.midpoint_derivatives(q, qd, faster, dt, *actions).next_qd
        faster = faster - np.linalg.solve(slope, rest[..., None])[..., 0]
    return of.midpoint_configuration(q, qd, faster, dt), faster


def test_the_midpoint_rule_of_an_arm_is_that_of_the_books():
    of = robot("arm")
    q, qd, tau = drawn(of, 5, seed=5)
    dt = np.linspace(0.001, 0.02, 5)
    after, faster = by_the_midpoint_rule(of, q, qd, tau, dt)
    middle = of.forward_dynamics((q + after) / 2, (qd + faster) / 2, tau)
    assert np.allclose(after - q, dt[:, None] * (qd + faster) / 2, atol=1e-14)
    assert np.allclose(faster - qd, dt[:, None] * middle, atol=1e-10)


@pytest.mark.parametrize("case", ["arm", "floating", "walker"])
def test_a_step_back_by_the_midpoint_rule_returns_to_the_start(case):
    of = loaded(case)
    q, qd, tau = drawn(of, 4, seed=6)
    there = by_the_midpoint_rule(of, q, 0.3 * qd, 0.02 * tau, 0.01)
    back = by_the_midpoint_rule(of, *there, 0.02 * tau, -0.01)
    assert np.abs(of.difference(q, back[0])).max() < 1e-11
    assert np.abs(back[1] - 0.3 * qd).max() < 1e-9


@pytest.mark.parametrize("case", ["arm", "floating", "walker"])
def test_derivatives_of_the_midpoint_rule_are_those_of_differences(case):
    of = loaded(case)
    q, qd, tau = drawn(of, 3, seed=7)
    faster, dt, n = qd + 0.01 * tau, 0.01, of.NV
    by = of.midpoint_derivatives(q, qd, faster, dt)
    assert by.q.shape == (3, n, n)

    def change(sign, x, v, f):
        return of.midpoint_residual(of.integrate(q, sign * x), qd + sign * v, faster + sign * f, tau, dt)

    expected = by_differences(n, change, lambda less, more: more - less)
    found = np.concatenate(by, -1)
    assert np.allclose(found, expected, atol=1e-7 * np.abs(expected).max())


def test_the_midpoint_rule_takes_wrenches_types_and_shapes():
    of = robot("external")
    q, qd, tau, actions = states(of, ["q", "qd", "tau", "actions"], 4, float)
    _, faster = by_the_midpoint_rule(of, q, qd, tau, 0.01, actions)
    found = of.inverse_dynamics(q + 0.0025 * (qd + faster), (qd + faster) / 2, (faster - qd) / 0.01, actions)
    assert np.allclose(found, tau, atol=1e-9)
    of = robot("arm")
    q, qd, tau = drawn(of, 6)
    assert of.midpoint_derivatives(q[0], qd, qd[1], np.full((2, 1), 0.01)).q.shape == (2, 6, 7, 7)
    assert of.midpoint_residual(q[0], qd[0], qd[1], tau, 0.01).shape == (6, 7)
    single = [array.astype(np.float32) for array in (q, qd, qd, tau)]
    assert of.midpoint_residual(*single, 0.01).dtype == of.midpoint_derivatives(*single[:3], 0.01).next_qd.dtype == np.float32
    assert of.midpoint_configuration(*single[:3], 0.01).dtype == np.float32


def test_loops_are_refused():
    of = robot("loop")
    zeros = np.zeros(2)
    with pytest.raises(ValueError, match="has loops"):
        of.step(zeros, zeros, zeros, 0.01)
    with pytest.raises(ValueError, match="has loops"):
        of.midpoint_residual(zeros, zeros, zeros, zeros, 0.01)


def test_an_unknown_integrator_is_named():
    of = robot("arm")
    with pytest.raises(ValueError, match="'midpoint'"):
        of.step(np.zeros(7), np.zeros(7), np.zeros(7), 0.01, integrator="midpoint")
