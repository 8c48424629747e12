"""The types of results that are several arrays: named tuples, one for each function that has such, and those of steps."""

from collections import namedtuple

import numpy as np

from ._engine import functions

_TYPES = {
    name: namedtuple("".join(word.capitalize() for word in name.split("_")), parts, module=__name__)
    for name, _, _, parts, *_ in functions()
    if parts
}
globals().update({of.__name__: of for of in _TYPES.values()})

#: Configurations of inverse kinematics, whether they have converged, and the remaining angles in rad and distances in m.
InverseKinematics = namedtuple("InverseKinematics", ["q", "converged", "orientation_error", "position_error"])

#: The state after a time step.
NextState = namedtuple("NextState", ["q", "qd"])


class StepDerivatives(namedtuple("StepDerivatives", "q_by_q q_by_qd q_by_tau qd_by_q qd_by_qd qd_by_tau")):
    """The derivatives of the state after a time step, a row for each entry of it: by q along velocities, q̇ and τ."""

    __slots__ = ()

    @property
    def a(self):
        """A = ∂(q, q̇)⁺/∂(q, q̇), (..., 2n, 2n)."""
        return np.block([[self.q_by_q, self.q_by_qd], [self.qd_by_q, self.qd_by_qd]])

    @property
    def b(self):
        """B = ∂(q, q̇)⁺/∂τ, (..., 2n, n)."""
        return np.concatenate([self.q_by_tau, self.qd_by_tau], -2)


#: Of `midpoint_residual`, a row for each torque or force: by q along velocities, by q̇ before the step, and after it.
MidpointDerivatives = namedtuple("MidpointDerivatives", ["q", "qd", "next_qd"])

#: Types of results of methods in Python.
OTHERS = (InverseKinematics, NextState, StepDerivatives, MidpointDerivatives)

__all__ = sorted([*(of.__name__ for of in OTHERS), *(of.__name__ for of in _TYPES.values())])


def of(name):
    """The type of the results of a function; `None` where they are one array."""
    return _TYPES.get(name)
