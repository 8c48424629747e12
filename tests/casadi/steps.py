"""Compares time steps in C, their derivatives and their Hessian with CasADi's own of the same rules, to 1e-11.

    steps.py HOMOGEN FOLDER
"""

import ctypes
import sys
from pathlib import Path

import casadi as ca
import numpy as np
from compare import close, matrix
from compiled import generated

FUNCTIONS = "forward_dynamics,forward_dynamics_derivatives,forward_dynamics_hessian"
ROBOTS = [
    ("two_link", ["robots/two_link.urdf", "--damping=elbow=0.3"], 2),
    ("scara", ["robots/scara.urdf"], 4),
    ("panda", ["robots/panda_class.urdf", "--tip", "link8"], 7),
]
RULES = ["semi-implicit", "euler", "rk4"]
STATES = 3


def rule(name, dynamics, q, qd, tau, dt):
    """The next state, as an expression."""
    k1 = dynamics(q, qd, tau)
    if name != "rk4":
        faster = qd + dt * k1
        return ca.vertcat(q + dt * (qd if name == "euler" else faster), faster)
    v2 = qd + dt / 2 * k1
    k2 = dynamics(q + dt / 2 * qd, v2, tau)
    v3 = qd + dt / 2 * k2
    k3 = dynamics(q + dt / 2 * v2, v3, tau)
    v4 = qd + dt * k3
    k4 = dynamics(q + dt * v3, v4, tau)
    return ca.vertcat(q + dt / 6 * (qd + 2 * v2 + 2 * v3 + v4), qd + dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4))


def check(homogen, folder, name, options, n, chosen):
    """The largest relative error of a robot and a rule."""
    prefix = f"{name}_{chosen.replace('-', '_')}"
    given = [*options, "--functions", FUNCTIONS]
    library, _, module = generated(homogen, folder, prefix, given, ["--name", prefix, "--steps", chosen])
    in_c = ctypes.CDLL(str(library))
    q, qd, tau, weights = (ca.SX.sym(letter, size) for letter, size in [("q", n), ("qd", n), ("tau", n), ("w", 2 * n)])
    dt = ca.SX.sym("dt")
    symbols, z = [q, qd, tau, dt], ca.vertcat(q, qd, tau)
    dynamics = ca.Function("f", [q, qd, tau], [matrix(module.forward_dynamics(q, qd, tau, library=ca))])
    after = rule(chosen, dynamics, q, qd, tau, dt)
    value = ca.Function("v", symbols, [after, ca.jacobian(after, z)])
    second = ca.Function("h", [*symbols, weights], [ca.hessian(ca.dot(weights, after), z)[0]])
    rng = np.random.default_rng(1)
    worst = 0.0

    def called(function, shapes, *arguments):
        """The results of a function in C, in numbers of these shapes."""
        results = [np.full(shape, np.nan) for shape in shapes]
        pointers = [array.ctypes.data_as(ctypes.c_void_p) for array in (*arguments, *results)]
        # The duration stands behind τ.
        in_c[f"{prefix}_{function}"](*pointers[:3], ctypes.c_double(0.01), *pointers[3:])
        return results

    for _ in range(STATES):
        state = [rng.uniform(-1.5, 1.5, n), rng.uniform(-1.5, 1.5, n), rng.uniform(-10, 10, n)]
        lam = rng.uniform(-1, 1, 2 * n)
        expected, jacobian = value(*state, 0.01)
        found = np.concatenate(called("step", [n, n], *state))
        worst = max(worst, close(found, expected, f"{prefix}: step"))
        a, b = called("step_derivatives", [(2 * n, 2 * n), (2 * n, n)], *state)
        worst = max(worst, close(np.hstack([a, b]), jacobian, f"{prefix}: derivatives"))
        (hessian,) = called("step_hessian", [(3 * n, 3 * n)], *state, lam)
        worst = max(worst, close(hessian, second(*state, 0.01, lam), f"{prefix}: Hessian"))
    return worst


def main(homogen, folder):
    for name, options, n in ROBOTS:
        errors = [check(homogen, Path(folder), name, options, n, chosen) for chosen in RULES]
        print(f"{name}: steps, derivatives and Hessians within {max(errors):.0e} of CasADi's")


if __name__ == "__main__":
    main(*sys.argv[1:])
