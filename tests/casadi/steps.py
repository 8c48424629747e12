"""Compares time steps in C, their derivatives and their Hessian with CasADi's own of the same rules, to 1e-11, and times a
step with its derivatives beside the C that CasADi generates of its own.

    steps.py HOMOGEN FOLDER
"""

import ctypes
import subprocess
import sys
from pathlib import Path

import casadi as ca
import numpy as np
from compare import close, matrix
from compiled import generated

FUNCTIONS = "forward_dynamics,forward_dynamics+forward_dynamics_derivatives,forward_dynamics_hessian"
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
        *next_too, a, b = called("step_derivatives", [n, n, (2 * n, 2 * n), (2 * n, n)], *state)
        worst = max(worst, close(np.concatenate(next_too), expected, f"{prefix}: step with derivatives"))
        worst = max(worst, close(np.hstack([a, b]), jacobian, f"{prefix}: derivatives"))
        (hessian,) = called("step_hessian", [(3 * n, 3 * n)], *state, lam)
        worst = max(worst, close(hessian, second(*state, 0.01, lam), f"{prefix}: Hessian"))
    return worst, timed(folder, prefix, n, ca.Function("by_casadi", symbols, [after, ca.jacobian(after, z)]))


def timed(folder, prefix, n, function):
    """Nanoseconds of a step with A and B: of the generated functions, and of CasADi's C, compiled alike."""
    own = folder / f"{prefix}_by_casadi.c"
    function.generate(own.name, {"with_header": False})
    Path(own.name).rename(own)
    program = folder / f"{prefix}_timed"
    flags = ["-O2", "-march=native", f'-DHEADER="{prefix}.h"', f"-DCOUNT={n}", f"-I{folder}"]
    sources = [Path(__file__).with_name("timed.c"), folder / f"{prefix}.c", own]
    subprocess.run(["cc", *flags, f"-DSTEP={prefix}_step_derivatives", *sources, "-lm", "-o", program], check=True)
    return [int(word) for word in subprocess.run(program, check=True, capture_output=True, text=True).stdout.split()]


def main(homogen, folder):
    for name, options, n in ROBOTS:
        for chosen in RULES:
            error, [ours, theirs] = check(homogen, Path(folder), name, options, n, chosen)
            print(f"{name}, {chosen}: step, derivatives and Hessian within {error:.0e} of CasADi's;", end=" ")
            print(f"step with derivatives {ours / 1000:.2f} µs, CasADi's C {theirs / 1000:.2f} µs")


if __name__ == "__main__":
    main(*sys.argv[1:])
