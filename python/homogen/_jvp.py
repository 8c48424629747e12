"""Jacobian-vector products of inverse and forward dynamics: their matrices of derivatives times a direction."""

import numpy as np

from . import results


def jvp(robot, name, values, actions, directions, order):
    """The result of a function of dynamics, and its change along directions."""
    further = () if actions is None else (actions,)
    options = {} if order is None or actions is None else {"order": order}
    found = getattr(robot, name)(*values, *further, **options)
    matrices = [*getattr(robot, f"{name}_derivatives")(*values, *further, **options)]
    if name == "inverse_dynamics":
        matrices.append(robot.mass_matrix(values[0]))
    terms = [_times(matrix, direction) for matrix, direction in zip(matrices, directions) if direction is not None]
    if not terms:
        raise TypeError(f"{name}_jvp needs a direction")
    change = sum(terms[1:], terms[0])
    return results.Jvp(found, np.broadcast_to(change, np.broadcast_shapes(change.shape, found.shape)).copy())


def _times(matrix, direction):
    direction = np.asarray(direction, matrix.dtype)
    if direction.shape[-1:] != matrix.shape[-1:]:
        raise ValueError(f"a direction has the shape {direction.shape}, and must have (..., {matrix.shape[-1]})")
    return (matrix @ direction[..., None])[..., 0]
