"""Functions of a robot for PyTorch: the compiled code as an operator whose backward pass is that of generated derivatives.

There is one operator, `homogen::compute`, of the tensors and the key of a function; the key stands for the function as long as
somebody holds it, so that robots can be dropped. Functions without generated derivatives are plain Python on tensors.
"""

import itertools
import weakref
from collections.abc import Sequence

import numpy as np

from . import results
from ._library import Library, counted, flat, imported, leading

torch = imported("torch", "torch", "robot.torch")

_alive = weakref.WeakValueDictionary()
_keys = map(str, itertools.count())


class Torch(Library):
    """The functions of a robot for PyTorch, of tensors (..., n) on the CPU, with the values that fields have at the call."""

    def __init__(self, robot):
        super().__init__(robot)
        self._operations = {}

    def _make(self, name, frame, order):
        if name in DERIVATIVES and self._robot._is_euclidean:
            return self.compiled(name, frame, order)
        return plain(self._robot, name, frame, order)

    def compiled(self, name, frame, order):
        """A function by compiled code, whether it can be differentiated or not."""
        key = name, frame, order
        if key not in self._operations:
            self._operations[key] = Operation(self._robot, *key)
        return self._operations[key]


class Operation:
    """A function of a robot for tensors, by compiled code."""

    def __init__(self, robot, name, frame, order):
        self.robot, self.name, self.frame, self.order = robot, name, frame, order
        self._function = getattr(robot, name)
        self.arguments, self.shapes = self._function.arrays()
        keywords = self._function.parameters()[1]
        self._options = {key: value for key, value in [("frame", frame), ("order", order)] if key in keywords}
        self._several = results.of(name)
        self.__name__, self.__doc__ = name, self._function.__doc__
        self._key = next(_keys)
        _alive[self._key] = self

    def __call__(self, *values):
        counted(self.name, self.arguments, values)
        found = _compute(same_type(values), self._key)
        return self._several(*found) if self._several else found[0]

    def ranks(self):
        """How many axes one state of each argument has."""
        return [len(own) for _, own in self.arguments]

    def leading(self, tensors):
        return leading(self.arguments, [tensor.shape for tensor in tensors])

    def compute(self, tensors):
        """The results, by NumPy."""
        for (name, _), tensor in zip(self.arguments, tensors):
            if tensor.device.type != "cpu":
                raise ValueError(f"{name} is on {tensor.device}, and must be on the CPU")
        found = self._function(*(tensor.detach().numpy() for tensor in tensors), **self._options)
        found = found if self._several else [found]
        return [torch.from_numpy(np.asarray(array)) for array in found]

    def other(self, name, *tensors, frame=None, order=None):
        """The result of another function of the robot."""
        return self.robot.torch.compiled(name, frame, order or self.order)(*tensors)


def same_type(values):
    """Values as tensors of one type, single or double."""
    tensors = [torch.as_tensor(value) for value in values]
    types = {tensor.dtype for tensor in tensors}
    number = torch.float32 if types == {torch.float32} else torch.float64
    return [tensor.to(number) for tensor in tensors]


@torch.library.custom_op("homogen::compute", mutates_args=())
def _compute(tensors: Sequence[torch.Tensor], key: str) -> list[torch.Tensor]:
    return _alive[key].compute(tensors)


@_compute.register_fake
def _(tensors, key):
    operation = _alive[key]
    axes = operation.leading(tensors)
    return [tensors[0].new_empty((*axes, *shape)) for _, shape in operation.shapes]


@_compute.register_vmap
def _(info, places, tensors, key):
    operation = _alive[key]
    places, _ = places
    ranks = operation.ranks()
    axes = max(tensor.dim() - (place is not None) - rank for tensor, place, rank in zip(tensors, places, ranks))
    moved = []
    for tensor, place, rank in zip(tensors, places, ranks):
        if place is not None:
            tensor = tensor.movedim(place, 0)
            missing = axes - (tensor.dim() - 1 - rank)
            tensor = tensor.reshape(tensor.shape[0], *[1] * missing, *tensor.shape[1:])
        moved.append(tensor)
    return _compute(moved, key), [0] * len(operation.shapes)


def _keep(ctx, inputs, output):
    tensors, key = inputs
    # The backward pass may come after everybody else has dropped the robot.
    ctx.operation = _alive[key]
    ctx.save_for_backward(*tensors)


def _backward(ctx, gradients):
    operation, tensors = ctx.operation, ctx.saved_tensors
    derivative = DERIVATIVES.get(operation.name)
    if derivative is None:
        raise NotImplementedError(
            f"{operation.name} has no generated derivative; robot.plain.{operation.name} is differentiated as often as you like"
        )
    found = derivative(operation, *tensors, *gradients)
    return [_summed(gradient, tensor.shape) for gradient, tensor in zip(found, tensors)], None


_compute.register_autograd(_backward, setup_context=_keep)


def _summed(gradient, shape):
    """A gradient in the shape of an argument that was broadcast."""
    return gradient.sum_to_size(shape) if gradient.shape != shape else gradient


def _row(gradient, matrix):
    """gᵀ A, state by state."""
    return torch.einsum("...i,...ij->...j", gradient, matrix)


def _column(matrix, vector):
    """A v, state by state."""
    return torch.einsum("...ij,...j->...i", matrix, vector)


def _wrenches(operation, q, gradient):
    """The gradient by external wrenches: inverse dynamics subtracts Jᵀ times each of them."""
    recipe = operation.robot._recipe
    links = [link for key, link in recipe.options if key == "external"]
    in_frame_0 = any(key == "external_in_frame_0" for key, _ in recipe.options)
    name = "spatial_jacobian" if in_frame_0 else "body_jacobian"
    parts = [_column(operation.other(name, q, frame=link), gradient) for link in links]
    return torch.stack(parts, dim=-2)


def _inverse_dynamics(operation, q, qd, qdd, *rest):
    *actions, gradient = rest
    dq, dqd = operation.other("inverse_dynamics_derivatives", q, qd, qdd, *actions)
    mass = operation.other("mass_matrix", q)
    further = [-_wrenches(operation, q, gradient) for _ in actions]
    return [_row(gradient, dq), _row(gradient, dqd), _row(gradient, mass), *further]


def _forward_dynamics(operation, q, qd, tau, *rest):
    *actions, gradient = rest
    dq, dqd, dtau = operation.other("forward_dynamics_derivatives", q, qd, tau, *actions)
    by_torque = _row(gradient, dtau)
    further = [_wrenches(operation, q, by_torque) for _ in actions]
    return [_row(gradient, dq), _row(gradient, dqd), by_torque, *further]


def _bias(operation, q, qd, gradient):
    # External wrenches enter inverse dynamics alone.
    links = sum(key == "external" for key, _ in operation.robot._recipe.options)
    actions = [q.new_zeros(links, 6)] * bool(links)
    dq, dqd = operation.other("inverse_dynamics_derivatives", q, qd, torch.zeros_like(qd), *actions)
    return [_row(gradient, dq), _row(gradient, dqd)]


def _gravity(operation, q, gradient):
    return [_row(gradient, operation.other("gravity_derivative", q))]


def _potential_energy(operation, q, gradient):
    return [gradient[..., None] * operation.other("gravity", q)]


def _center_of_mass(operation, q, gradient):
    return [_row(gradient, operation.other("center_of_mass_jacobian", q))]


def _forward_kinematics(operation, q, gradient):
    """Along joint j a pose M changes by L M, with the screw L of its column."""
    frame = operation.frame
    columns = operation.other("spatial_jacobian", q, frame=frame, order="linear_first")
    pose = operation.other("forward_kinematics", q, frame=frame)
    linear, angular = columns[..., :3, :], columns[..., 3:, :]
    # The rows of the gradient times those of the pose: of a translation their last column, of a rotation the moments.
    work = torch.einsum("...rc,...sc->...rs", gradient, pose)[..., :3, :]
    turning = torch.stack(
        [work[..., 2, 1] - work[..., 1, 2], work[..., 0, 2] - work[..., 2, 0], work[..., 1, 0] - work[..., 0, 1]], dim=-1
    )
    return [_row(work[..., 3], linear) + _row(turning, angular)]


#: For each function the gradients by its arguments, of these and of the gradient by its result.
DERIVATIVES = {
    "inverse_dynamics": _inverse_dynamics,
    "forward_dynamics": _forward_dynamics,
    "bias": _bias,
    "gravity": _gravity,
    "potential_energy": _potential_energy,
    "center_of_mass": _center_of_mass,
    "forward_kinematics": _forward_kinematics,
}


def plain(robot, name, frame, order):
    """A function in plain Python on tensors."""
    function = robot.plain.of(name, frame, order)
    arguments, shapes = getattr(robot, name).arrays()
    several = results.of(name)

    def call(*values):
        counted(name, arguments, values)
        tensors = same_type(values)
        axes = leading(arguments, [tensor.shape for tensor in tensors])
        ranks = [len(own) for _, own in arguments]
        columns = [tensor.movedim(tuple(range(-rank, 0)), tuple(range(rank))) for tensor, rank in zip(tensors, ranks)]
        fields = {field: tensors[0].new_tensor(value) for field, value in robot.fields.items()}
        found = function(*columns, library=torch, **fields)
        made = []
        for result, (_, shape) in zip(found if several else [found], shapes):
            entries = [torch.as_tensor(entry, dtype=tensors[0].dtype).expand(axes) for entry in flat(result)]
            stacked = torch.stack(entries, dim=-1) if entries else tensors[0].new_zeros(*axes, 0)
            made.append(stacked.reshape(*axes, *shape))
        return several(*made) if several else made[0]

    call.__name__, call.__doc__ = name, getattr(robot, name).__doc__
    return call
