"""Relative differences between two sets of values.

In: values of homogen and of the peer, for each state. Out: one number for each function, a few units of rounding if
both are correct. Every entry is relative to the scale of its own joint, so that a finger is not hidden by a shoulder.
Solutions are measured by the residual of their equation, because those of a nearly singular robot are not unique to
rounding.
"""

import numpy as np

# Lower limit of a joint's scale, relative to that of the joint with the largest torques.
FINEST = 1e-3


def dynamics(function, ours, theirs):
    """Difference of a function of the whole robot; `theirs` has all functions for each state."""
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
    """Difference of a function of a frame: rotations and translations, each on its own scale."""
    ours = np.array(ours, dtype=float)
    theirs = np.array([state[function] for state in theirs])
    if "jacobian" in function:
        blocks = [np.s_[:, :3, :], np.s_[:, 3:, :]]
    else:
        blocks = [np.s_[:, :3, :3], np.s_[:, :3, 3]]
    return worst(
        np.abs(ours[block] - theirs[block]) / max(1e-3, np.max(np.abs(theirs[block]), initial=0.0)) for block in blocks
    )


def configurations(ours, theirs, quaternions):
    """Difference of the configurations with names, where quaternions begin at given places; infinite if the names differ."""
    if set(ours) != set(theirs):
        return float("inf")
    theirs = {name: np.array(q) for name, q in theirs.items()}
    for name, q in theirs.items():
        for first in quaternions:
            # A quaternion and its negative are one rotation.
            if q[first : first + 4] @ np.array(ours[name][first : first + 4]) < 0:
                q[first : first + 4] *= -1
    return worst(np.abs(np.array(ours[name]) - theirs[name]) for name in ours)


def residual_of_accelerations(qdd, state):
    """|M q̈ + h − τ|, each joint relative to the sum of its absolute terms."""
    mass, bias, tau = (state[name] for name in ("mass_matrix", "bias", "tau"))
    root = np.sqrt(np.abs(np.diag(mass)))
    scale = root * (root @ np.abs(qdd)) + np.abs(bias) + np.abs(tau)
    return np.abs(mass @ qdd + bias - tau) / scale


def residual_of_inverse(inverse, mass):
    """|M X − 1|, each entry relative to the sum of its absolute terms."""
    root = np.sqrt(np.abs(np.diag(mass)))
    scale = np.outer(root, root @ np.abs(inverse))
    return np.abs(mass @ inverse - np.eye(len(mass))) / scale


def floored(sizes, part):
    return np.maximum(sizes, max(part * np.max(sizes, initial=0.0), 1e-100))


def worst(errors):
    """The largest error, 0 if there is none; infinite if one is NaN or infinite."""
    errors = [np.max(error, initial=0.0) for error in errors]
    return float("inf") if any(not np.isfinite(error) for error in errors) else float(max(errors, default=0.0))
