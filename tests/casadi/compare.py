"""Compares the external interface of CasADi in C files with CasADi's derivatives of the same functions in plain Python.

    compare.py HOMOGEN FOLDER "FILE OPTIONS" ...

For each function of each robot, at random states: values; and where there are derivatives the Jacobian, the gradient of
the result times weights, and its Hessian, of which no entry may be missing in a sparsity pattern. Where there are none
CasADi refuses to differentiate. Null inputs are zero, and null outputs are skipped.
"""

import ctypes
import inspect
import re
import shlex
import sys
from pathlib import Path

import casadi as ca
import numpy as np
from compiled import generated

STATES = 5
# Relative to the largest entry.
TOLERANCE = 1e-11


def flat(value):
    """The entries of nested lists, row by row."""
    return [entry for part in value for entry in flat(part)] if isinstance(value, (list, tuple)) else [value]


def matrix(value):
    """A number, a list or a list of rows as a matrix of CasADi; matrices of a list one below the other."""
    if isinstance(value, list) and isinstance(value[0], list) and isinstance(value[0][0], list):
        return ca.vertcat(*map(matrix, value))
    rows = value if isinstance(value, list) else [value]
    rows = [row if isinstance(row, list) else [row] for row in rows]
    return ca.vertcat(*[ca.horzcat(*row) for row in rows])


def expression(module, name, external):
    """The same function as an expression of CasADi's own symbols."""
    function = getattr(module, name)
    symbols = [ca.SX.sym(external.name_in(k), *external.size_in(k)) for k in range(external.n_in())]
    parameters = inspect.signature(function).parameters.values()
    keywords = [parameter.name for parameter in parameters if parameter.kind == parameter.KEYWORD_ONLY]
    arguments = symbols[: len(symbols) - bool(keywords)]
    values = [
        [argument[row, :] for row in range(argument.shape[0])] if argument.shape[1] > 1 or external.name_in(k) == "actions" else argument
        for k, argument in enumerate(arguments)
    ]
    fields, place = {}, 0
    for keyword in keywords:
        size = FIELDS[keyword]
        fields[keyword] = symbols[-1][place] if size == 1 else symbols[-1][place : place + size]
        place += size
    results = function(*values, library=ca, **fields)
    results = results if external.n_out() > 1 else (results,)
    return ca.Function(name, symbols, [matrix(result) for result in results], external.name_in(), external.name_out())


# Numbers of each field in the robots of the script.
FIELDS = {"payload": 1, "lift": 3}


def close(found, expected, what):
    found, expected = np.array(ca.DM(found).full()), np.array(ca.DM(expected).full())
    assert found.shape == expected.shape, f"{what}: {found.shape}, not {expected.shape}"
    assert np.isfinite(found).all(), f"{what}: not finite"
    error = np.abs(found - expected).max(initial=0.0) / max(1.0, np.abs(expected).max(initial=0.0))
    assert error <= TOLERANCE, f"{what}: off by {error:.1e}"
    return error


def derivatives(function, kind):
    """Jacobian, gradient and Hessian of the first result of a function by all arguments but the fields."""
    names = [name for name in function.name_in() if name != "p"]
    inputs = [kind.sym(name, *function.size_in(k)) for k, name in enumerate(function.name_in())]
    weights = kind.sym("weights", *function.size_out(0))
    by = ca.vertcat(*[ca.vec(inputs[k]) for k in range(len(names))])
    # CasADi differentiates by symbols alone.
    whole = kind.sym("x", by.shape[0])
    parts = ca.vertsplit(whole, np.cumsum([0] + [function.numel_in(k) for k in range(len(names))]).tolist())
    arguments = [ca.reshape(part, *function.size_in(k)) for k, part in enumerate(parts)]
    result = function.call([*arguments, *inputs[len(names) :]])[0]
    scalar = ca.dot(weights, result)
    inputs = [whole, *inputs[len(names) :], weights]
    gradient = ca.Function("gradient", inputs, [ca.jacobian(result, whole), ca.gradient(scalar, whole)])
    return gradient, lambda: ca.Function("hessian", inputs, [ca.hessian(scalar, whole)[0]])


def refuses(make, what):
    """CasADi says that a function has no derivative."""
    try:
        make()
    except RuntimeError:
        return
    raise AssertionError(f"{what}: CasADi believes a derivative that is not there")


def nulls(library, external, own):
    """Null inputs are zeros, and null outputs are skipped."""
    doubles = ctypes.POINTER(ctypes.c_double)
    call = getattr(ctypes.CDLL(str(library)), external.name())
    arguments = (doubles * external.n_in())()
    zero = own(*[0] * own.n_in())
    zero = zero if isinstance(zero, tuple) else (zero,)
    for wanted in range(external.n_out()):
        count = external.nnz_out(wanted)
        found = (ctypes.c_double * (count + 1))(*[7.0] * (count + 1))
        results = (doubles * external.n_out())()
        results[wanted] = ctypes.cast(found, doubles)
        assert call(arguments, results, None, None, 0) == 0
        assert found[count] == 7.0, "written beyond the end"
        sparse = ca.DM(external.sparsity_out(wanted), list(found[:count]))
        close(ca.densify(sparse), ca.densify(zero[wanted]), f"{external.name()} at zero")
    assert call(arguments, (doubles * external.n_out())(), None, None, 0) == 0


def check(library, text, module, name, rng):
    own_name = re.sub(r"^\w*?_casadi_", "", name)
    external = ca.external(name, str(library))
    own = expression(module, own_name, external)
    if external.name_in()[-1] == "p":
        assert not external.is_diff_in(external.n_in() - 1)
    nulls(library, external, own)
    has = {kind: bool(re.search(rf"int {kind}_{name}\(", text)) for kind in ("jac", "adj1", "jac_adj1")}
    worst = dict.fromkeys(("value", "Jacobian", "gradient", "Hessian"), 0.0)
    entries = "no derivatives"
    # Without a Jacobian CasADi makes one of gradients.
    if has["adj1"]:
        (ours, our_hessian), (theirs, their_hessian) = derivatives(external, ca.MX), derivatives(own, ca.SX)
        entries = f"Jacobian {ours.nnz_out(0)}/{theirs.nnz_out(0)} entries"
        if has["jac_adj1"]:
            our_hessian, their_hessian = our_hessian(), their_hessian()
            entries += f", Hessian {our_hessian.nnz_out(0)}/{their_hessian.nnz_out(0)}"
        else:
            refuses(our_hessian, f"Hessian of {name}")
    elif external.nnz_out(0) > 0:
        refuses(lambda: derivatives(external, ca.MX), f"gradient of {name}")
    for _ in range(STATES):
        state = [rng.uniform(-1.0, 1.0, external.size_in(k)) for k in range(external.n_in())]
        found, expected = external.call(state), own.call(state)
        for k, (one, other) in enumerate(zip(found, expected)):
            worst["value"] = max(worst["value"], close(ca.densify(one), ca.densify(other), f"{name}, result {k}"))
        if not has["adj1"]:
            continue
        count = external.n_in() - (external.name_in()[-1] == "p")
        point = [np.concatenate([part.ravel() for part in state[:count]]), *state[count:]]
        point.append(rng.uniform(-1.0, 1.0, external.size_out(0)))
        for what, one, other in zip(("Jacobian", "gradient"), ours.call(point), theirs.call(point)):
            worst[what] = max(worst[what], close(ca.densify(one), ca.densify(other), f"{what} of {name}"))
        if has["jac_adj1"]:
            one, other = our_hessian(*point), their_hessian(*point)
            worst["Hessian"] = max(worst["Hessian"], close(ca.densify(one), ca.densify(other), f"Hessian of {name}"))
    errors = ", ".join(f"{what} {error:.0e}" for what, error in worst.items() if error)
    print(f"  {own_name}: {entries}; {errors}")
    return has


def main(homogen, folder, *robots):
    folder, rng = Path(folder), np.random.default_rng(41)
    counted = dict.fromkeys(("jac", "adj1", "jac_adj1"), 0)
    for k, robot in enumerate(robots):
        print(robot.split(" --functions")[0])
        library, text, module = generated(homogen, folder, f"robot_{k}", shlex.split(robot))
        names = re.findall(r"EXPORT int (\w+)\(const double \*\*arg", text)
        for name in names:
            if name.startswith(("jac_", "adj1_")):
                continue
            for kind, there in check(library, text, module, name, rng).items():
                counted[kind] += there
    print(", ".join(f"{kind}_: {count}" for kind, count in counted.items()))
    assert all(counted.values())


if __name__ == "__main__":
    main(*sys.argv[1:])
