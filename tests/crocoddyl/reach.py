"""The problem of the example `optimal_motion`, solved by Crocoddyl with the robot that Pinocchio reads from the same file.

    reach.py PROGRAM

PROGRAM is the compiled example. Both must have the same cost at the beginning and find the same optimum; iterations until
the cost is within 1e-9 of it, and times of both are printed.
"""

import re
import subprocess
import sys
import tempfile
import time

import crocoddyl
import numpy as np
import pinocchio

# As in examples/src/bin/optimal_motion.rs.
START, GOAL = np.array([0.0, -0.6, 0.0, -2.2, 0.0, 1.6, 0.8]), np.array([0.36, 0.45, 0.64])
STEPS, PERIOD = 100, 0.01
EFFORT, HASTE, MISS, REST = 1e-3, 0.05, 1000.0, 10.0
NEAR = 1e-9
REPEATS = 20


def problem(model):
    state = crocoddyl.StateMultibody(model)
    actuation = crocoddyl.ActuationModelFull(state)
    rest = np.concatenate([START, np.zeros(model.nv)])
    # A copy: Pinocchio returns a view of its data.
    hold = pinocchio.computeGeneralizedGravity(model, model.createData(), START).copy()
    rates = crocoddyl.CostModelResidual(
        state,
        crocoddyl.ActivationModelWeightedQuad(np.repeat([0.0, 1.0], model.nv)),
        crocoddyl.ResidualModelState(state, rest, actuation.nu),
    )
    torques = crocoddyl.CostModelResidual(state, crocoddyl.ResidualModelControl(state, hold))
    place = crocoddyl.CostModelResidual(
        state, crocoddyl.ResidualModelFrameTranslation(state, model.getFrameId("link8"), GOAL, actuation.nu)
    )

    def action(costs, period):
        total = crocoddyl.CostModelSum(state, actuation.nu)
        for name, (cost, weight) in costs.items():
            total.addCost(name, cost, weight)
        dynamics = crocoddyl.DifferentialActionModelFreeFwdDynamics(state, actuation, total)
        return crocoddyl.IntegratedActionModelEuler(dynamics, period)

    running = action({"rates": (rates, HASTE), "torques": (torques, EFFORT)}, PERIOD)
    end = action({"rates": (rates, REST + PERIOD * HASTE), "place": (place, MISS)}, 0.0)
    shooting = crocoddyl.ShootingProblem(rest, [running] * STEPS, end)
    shooting.nthreads = 1
    return shooting, [hold] * STEPS


def solve(shooting, torques):
    """Costs at the beginning and after each iteration, and the time of one."""
    solver = crocoddyl.SolverDDP(shooting)
    solver.th_stop = 1e-18
    logger = crocoddyl.CallbackLogger()
    solver.setCallbacks([logger])
    states = shooting.rollout(torques)
    begun = shooting.calc(states, torques)
    solver.solve(states, torques, 200, True)
    costs = [begun, *logger.costs]
    # Without the logger, for the time.
    solver = crocoddyl.SolverDDP(shooting)
    solver.th_stop = 1e-18
    times = []
    for _ in range(REPEATS):
        began = time.perf_counter()
        solver.solve(states, torques, 20, True)
        times.append((time.perf_counter() - began) / solver.iter)
    return costs, min(times)


def needed(costs):
    return next(k for k, cost in enumerate(costs) if cost <= (1 + NEAR) * costs[-1])


def ours(program):
    """What the example prints: the cost at the beginning, and of each method cost, iterations and time."""
    with tempfile.TemporaryDirectory() as folder:
        text = subprocess.run([program, f"{folder}/picture.svg"], check=True, capture_output=True, text=True).stdout
    begun = float(re.search(r"cost (\S+) at the beginning", text)[1])
    methods = re.findall(r"^  (.*): cost (\S+); (\d+) iterations .*, (\S+) ms each", text, re.MULTILINE)
    assert len(methods) == 2, text
    return begun, methods


def main(program):
    model = pinocchio.buildModelFromUrdf("robots/panda_class.urdf")
    costs, seconds = solve(*problem(model))
    print(f"Crocoddyl {crocoddyl.__version__}, cost {costs[0]:.9f} at the beginning")
    print(f"  SolverDDP: cost {costs[-1]:.9f}; {needed(costs)} iterations, {1e3 * seconds:.2f} ms each")
    begun, methods = ours(program)
    assert abs(begun / costs[0] - 1) <= 1e-8, (begun, costs[0])
    for name, cost, iterations, milliseconds in methods:
        print(f"  {name}: cost {cost}; {iterations} iterations, {milliseconds} ms each")
        assert abs(float(cost) / costs[-1] - 1) <= 1e-7, name


main(*sys.argv[1:])
