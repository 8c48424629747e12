"""A trajectory of the Panda with the least effort, by CasADi and IPOPT, with three models of its inverse dynamics.

    trajectory.py HOMOGEN FOLDER

The models are the external interface of the generated C file, and the same function as an expression of CasADi, run by
CasADi and as the C code that CasADi generates of it and of its derivatives. All must find the same optimum.
"""

import subprocess
import sys
import time
from pathlib import Path

import casadi as ca
import numpy as np
from compiled import generated

NODES = 30
DURATION = 1.0  # s
START, END = [0.0, -0.6, 0.0, -2.2, 0.0, 1.6, 0.8], [1.2, 0.4, -0.5, -1.2, 0.6, 2.4, -0.4]
REPEATS = 5

FUNCTIONS = "inverse_dynamics,inverse_dynamics_derivatives+mass_matrix,inverse_dynamics_hessian"


def problem(model, module):
    """The problem in q, q̇ and q̈ of all nodes, by the trapezoidal rule."""
    count, step = len(START), DURATION / (NODES - 1)
    q, qd, qdd = (ca.MX.sym(name, count, NODES) for name in ("q", "qd", "qdd"))
    # One call for all nodes: CasADi differentiates it as one, too.
    tau = model.map(NODES)(q, qd, qdd)
    effort = ca.DM(module.MAX_EFFORT)
    cost = step * ca.sumsqr(tau / ca.repmat(effort, 1, NODES))
    moves = [
        after[:, 1:] - after[:, :-1] - step / 2 * (rate[:, 1:] + rate[:, :-1]) for after, rate in ((q, qd), (qd, qdd))
    ]
    # At rest at both ends, within the limits between them.
    lower, upper = np.tile(module.LOWER, (NODES, 1)), np.tile(module.UPPER, (NODES, 1))
    lower[0] = upper[0] = START
    lower[-1] = upper[-1] = END
    most = np.tile(module.MAX_VELOCITY, (NODES, 1))
    most[0] = most[-1] = 0.0
    free = np.full((NODES, count), np.inf)
    guess = np.linspace(START, END, NODES)
    torque = np.tile(module.MAX_EFFORT, (NODES, 1)).ravel()
    zeros = np.zeros(2 * count * (NODES - 1))
    nlp = {
        "x": ca.vertcat(*[ca.vec(part) for part in (q, qd, qdd)]),
        "f": cost,
        "g": ca.vertcat(ca.vec(tau), *[ca.vec(part) for part in moves]),
    }
    bounds = {
        "x0": np.concatenate([guess.ravel(), np.zeros(2 * guess.size)]),
        "lbx": np.concatenate([lower.ravel(), -most.ravel(), -free.ravel()]),
        "ubx": np.concatenate([upper.ravel(), most.ravel(), free.ravel()]),
        "lbg": np.concatenate([-torque, zeros]),
        "ubg": np.concatenate([torque, zeros]),
    }
    return nlp, bounds


def solve(model, module):
    nlp, bounds = problem(model, module)
    options = {"print_time": False, "ipopt": {"print_level": 0, "sb": "yes", "tol": 1e-9}}
    solver = ca.nlpsol("solver", "ipopt", nlp, options)
    times = []
    for _ in range(REPEATS):
        began = time.perf_counter()
        found = solver(**bounds)
        seconds, stats = time.perf_counter() - began, solver.stats()
        assert stats["success"], stats["return_status"]
        times.append((seconds, sum(stats[key] for key in stats if key.startswith("t_wall_nlp_"))))
    return found, stats["iter_count"], *min(times)


def by_casadi(module):
    """The expression of CasADi's own symbols."""
    q, qd, qdd = (ca.SX.sym(name, len(START)) for name in ("q", "qd", "qdd"))
    tau = ca.vertcat(*module.inverse_dynamics(q, qd, qdd, library=ca))
    return ca.Function("own", [q, qd, qdd], [tau])


def in_c(function, folder):
    """The code that CasADi generates of a function and of its derivatives, with the compiler's options of ours."""
    generator = ca.CodeGenerator("own.c")
    for each in (function, function.jacobian(), function.reverse(1), function.reverse(1).jacobian()):
        generator.add(each)
    generator.generate(f"{folder}/")
    source, library = folder / "own.c", folder / "own.so"
    subprocess.run(["cc", "-O2", "-ffp-contract=off", "-shared", "-fPIC", source, "-o", library, "-lm"], check=True)
    return ca.external("own", str(library))


def main(homogen, folder):
    folder = Path(folder)
    options = ["robots/panda_class.urdf", "--tip", "link8", "--functions", FUNCTIONS]
    library, _, module = generated(homogen, folder, "panda", options)
    own = by_casadi(module)
    models = {
        "generated C": ca.external("panda_class_casadi_inverse_dynamics", str(library)),
        "CasADi": own,
        "CasADi's C": in_c(own, folder),
    }
    results = {name: solve(model, module) for name, model in models.items()}
    first = results["generated C"][0]
    unknowns = first["x"].numel()
    print(f"a trajectory of {unknowns} unknowns")
    for name, (found, iterations, seconds, functions) in results.items():
        print(
            f"  {name}: {1e3 * seconds:.1f} ms in {iterations} iterations, {1e3 * functions:.1f} ms of them in functions; "
            f"cost {float(found['f']):.12f}"
        )
        assert abs(float(found["f"] - first["f"])) <= 1e-8 * abs(float(first["f"]))
        assert np.abs((found["x"] - first["x"]).full()).max() <= 1e-4


main(*sys.argv[1:])
