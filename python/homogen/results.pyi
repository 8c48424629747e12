# Written by stub.py from the engine's table of functions.
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

class InverseDynamicsDerivatives(NamedTuple):
    dq: NDArray[np.floating[Any]]
    dqd: NDArray[np.floating[Any]]

class InverseDynamicsVjp(NamedTuple):
    dq: NDArray[np.floating[Any]]
    dqd: NDArray[np.floating[Any]]
    dqdd: NDArray[np.floating[Any]]

class InverseDynamicsJvp(NamedTuple):
    value: NDArray[np.floating[Any]]
    change: NDArray[np.floating[Any]]

class InverseDynamicsHessian(NamedTuple):
    dq_dq: NDArray[np.floating[Any]]
    dq_dqd: NDArray[np.floating[Any]]
    dqd_dqd: NDArray[np.floating[Any]]
    dq_dqdd: NDArray[np.floating[Any]]

class ForwardDynamicsDerivatives(NamedTuple):
    dq: NDArray[np.floating[Any]]
    dqd: NDArray[np.floating[Any]]
    dtau: NDArray[np.floating[Any]]

class ForwardDynamicsVjp(NamedTuple):
    dq: NDArray[np.floating[Any]]
    dqd: NDArray[np.floating[Any]]
    dtau: NDArray[np.floating[Any]]

class ForwardDynamicsJvp(NamedTuple):
    value: NDArray[np.floating[Any]]
    change: NDArray[np.floating[Any]]

class ForwardDynamicsHessian(NamedTuple):
    dq_dq: NDArray[np.floating[Any]]
    dq_dqd: NDArray[np.floating[Any]]
    dqd_dqd: NDArray[np.floating[Any]]
    dq_dtau: NDArray[np.floating[Any]]

class ConstrainedForwardDynamics(NamedTuple):
    qdd: NDArray[np.floating[Any]]
    multipliers: NDArray[np.floating[Any]]

class InverseKinematics(NamedTuple):
    q: NDArray[np.floating[Any]]
    converged: NDArray[np.bool_]
    orientation_error: NDArray[np.floating[Any]]
    position_error: NDArray[np.floating[Any]]

class NextState(NamedTuple):
    q: NDArray[np.floating[Any]]
    qd: NDArray[np.floating[Any]]

class StepDerivatives(NamedTuple):
    q_by_q: NDArray[np.floating[Any]]
    q_by_qd: NDArray[np.floating[Any]]
    q_by_tau: NDArray[np.floating[Any]]
    qd_by_q: NDArray[np.floating[Any]]
    qd_by_qd: NDArray[np.floating[Any]]
    qd_by_tau: NDArray[np.floating[Any]]
    @property
    def a(self) -> NDArray[np.floating[Any]]: ...
    @property
    def b(self) -> NDArray[np.floating[Any]]: ...

class MidpointDerivatives(NamedTuple):
    q: NDArray[np.floating[Any]]
    qd: NDArray[np.floating[Any]]
    next_qd: NDArray[np.floating[Any]]

def of(name: str) -> type[tuple[NDArray[np.floating[Any]], ...]] | None: ...
