"""How far two sets of values are from each other.

In: ours and those of the peer, for each state. Out: one number a function, which is a few units of
rounding where both are right. Every entry is measured on the scale of its own joint, so that a finger
is not lost beside a shoulder; solutions are measured by what they leave of the equation, since a
nearly singular robot has no others.
"""

import numpy as np

# Joints whose torques are smaller than that, in units of the largest, are not compared any finer.
FINEST = 1e-3


def dynamics(function, ours, theirs):
    """The functions of the whole robot; `theirs` has all of them for each state."""
    ours = [np.array(values, dtype=float) for values in ours]
    if function == "forward_dynamics":
        return worst(residual_of_accelerations(x, state) for x, state in zip(ours, theirs))
    if function == "mass_matrix_inverse":
        return worst(residual_of_inverse(x, state["mass_matrix"]) for x, state in zip(ours, theirs))
    if function == "mass_matrix":
        size = np.sqrt(np.max([np.abs(np.diag(state["mass_matrix"])) for state in theirs], axis=0))
        scale = floored(size, FINEST)
        scale = np.outer(scale, scale)
    else:
        torques = [np.abs(state[name]) for state in theirs for name in ("inverse_dynamics", "bias", "gravity")]
        scale = floored(np.max(torques, axis=0), FINEST)
    return worst(np.abs(x - state[function]) / scale for x, state in zip(ours, theirs))


def kinematics(function, ours, theirs):
    """The functions of a frame: what turns and what slides, each on its own scale."""
    ours = np.array(ours, dtype=float)
    theirs = np.array([state[function] for state in theirs])
    if "jacobian" in function:
        blocks = [np.s_[:, :3, :], np.s_[:, 3:, :]]
    else:
        blocks = [np.s_[:, :3, :3], np.s_[:, :3, 3]]
    return worst(
        np.abs(ours[block] - theirs[block]) / max(1e-3, np.max(np.abs(theirs[block]), initial=0.0)) for block in blocks
    )


def residual_of_accelerations(qdd, state):
    """|M q̈ + h − τ|, each joint in units of what it is summed of."""
    mass, bias, tau = (state[name] for name in ("mass_matrix", "bias", "tau"))
    root = np.sqrt(np.abs(np.diag(mass)))
    scale = root * (root @ np.abs(qdd)) + np.abs(bias) + np.abs(tau)
    return np.abs(mass @ qdd + bias - tau) / scale


def residual_of_inverse(inverse, mass):
    """|M X − 1|, each entry in units of what it is summed of."""
    root = np.sqrt(np.abs(np.diag(mass)))
    scale = np.outer(root, root @ np.abs(inverse))
    return np.abs(mass @ inverse - np.eye(len(mass))) / scale


def floored(sizes, part):
    return np.maximum(sizes, max(part * np.max(sizes, initial=0.0), 1e-100))


def worst(errors):
    """The largest; something that is no number is the worst of all."""
    errors = [np.max(error, initial=0.0) for error in errors]
    return float("inf") if any(not np.isfinite(error) for error in errors) else float(max(errors))
