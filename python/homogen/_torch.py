"""Functions of a robot for PyTorch: the compiled code as an operator whose backward pass is that of generated derivatives.

The operators `homogen::compute` and `homogen::pull` take the tensors and the key of a function; the key stands for the function
as long as somebody holds it, so that robots can be dropped. Functions without generated derivatives are plain Python on tensors.
"""

import itertools
import math
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

    def _make(self, name, frame, order):
        make = Operation if name in DERIVATIVES and self._robot._is_euclidean else plain
        return make(self._robot, name, frame, order)


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
        self.key = next(_keys)
        _alive[self.key] = self

    def __call__(self, *values):
        counted(self.name, self.arguments, values)
        found = _compute(same_type(values), self.key)
        return self._several(*found) if self._several else found[0]

    def ranks(self):
        """How many axes one state of each argument has."""
        return [len(own) for _, own in self.arguments]

    def leading(self, tensors):
        return leading(self.arguments, [tensor.shape for tensor in tensors])

    def leading_of_gradients(self, tensors, gradient):
        """The leading axes of the gradients by arguments: those of the gradient by the result may be more."""
        arrays = [*self.arguments, ("gradient", self.shapes[0][1])]
        return leading(arrays, [tensor.shape for tensor in (*tensors, gradient)])

    def compute(self, tensors):
        """The results, by NumPy."""
        for (name, _), tensor in zip(self.arguments, tensors):
            if tensor.device.type != "cpu":
                raise ValueError(f"{name} is on {tensor.device}, and must be on the CPU")
        found = self._function(*(tensor.detach().numpy() for tensor in tensors), **self._options)
        found = found if self._several else [found]
        return [torch.from_numpy(np.asarray(array)) for array in found]

    def of(self, name, *arrays):
        """The result of another function of the robot, of arrays."""
        function = getattr(self.robot, name)
        options = {"order": self.order} if "order" in function.parameters()[1] else {}
        shapes = [shape for _, shape in function.arrays()[1]]
        if len(shapes) > 1:
            options["out"] = _side_by_side(arrays[0].shape[0], shapes, arrays[0].dtype)
        return function(*arrays, **options)


def _side_by_side(count, shapes, number):
    """Arrays in one block: when it is freed, the allocator keeps it for the next ones, and of several it returns some to the
    system, whose new pages would take as long as the computation."""
    ends = np.cumsum([count * math.prod(shape) for shape in shapes])
    parts = np.split(np.empty(ends[-1], number), ends[:-1])
    return [part.reshape(count, *shape) for part, shape in zip(parts, shapes)]


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
    moved = _in_front(tensors, places[0], operation.ranks())
    return _compute(moved, key), [0] * len(operation.shapes)


def _keep(ctx, inputs, output):
    tensors, key = inputs
    # The backward pass may come after everybody else has dropped the robot.
    ctx.operation = _alive[key]
    ctx.save_for_backward(*tensors)


def _backward(ctx, gradients):
    operation, tensors = ctx.operation, ctx.saved_tensors
    if operation.name not in DERIVATIVES:
        raise NotImplementedError(f"{operation.name} {_NO_DERIVATIVE}{operation.name}")
    (gradient,) = gradients
    found = _pull(tensors, gradient, operation.key)
    return [_summed(gradient, tensor.shape) for gradient, tensor in zip(found, tensors)], None


_compute.register_autograd(_backward, setup_context=_keep)


# The gradients by the arguments, each with all leading axes: an operator of its own, so that nobody differentiates NumPy.
@torch.library.custom_op("homogen::pull", mutates_args=())
def _pull(tensors: Sequence[torch.Tensor], gradient: torch.Tensor, key: str) -> list[torch.Tensor]:
    operation = _alive[key]
    axes = operation.leading_of_gradients(tensors, gradient)
    count = math.prod(axes)
    own = [shape for _, shape in operation.arguments]
    arrays = [
        np.broadcast_to(tensor.detach().numpy(), (*axes, *shape)).reshape(count, *shape)
        for tensor, shape in zip((*tensors, gradient), (*own, operation.shapes[0][1]))
    ]
    rule = DERIVATIVES[operation.name]
    if count <= _CACHED or (operation.name in BY_VECTORS and "actions" not in dict(operation.arguments)):
        found = rule(operation, *arrays)
    else:
        found = [np.empty((count, *shape), array.dtype) for shape, array in zip(own, arrays)]
        for start in range(0, count, _CACHED):
            some = slice(start, start + _CACHED)
            for whole, part in zip(found, rule(operation, *(array[some] for array in arrays))):
                whole[some] = part
    return [torch.from_numpy(array.reshape(*axes, *shape)) for array, shape in zip(found, own)]


@_pull.register_fake
def _(tensors, gradient, key):
    operation = _alive[key]
    axes = operation.leading_of_gradients(tensors, gradient)
    return [gradient.new_empty((*axes, *shape)) for _, shape in operation.arguments]


@_pull.register_vmap
def _(info, places, tensors, gradient, key):
    operation = _alive[key]
    ranks = [*operation.ranks(), len(operation.shapes[0][1])]
    *moved, gradient = _in_front([*tensors, gradient], [*places[0], places[1]], ranks)
    return _pull(moved, gradient, key), [0] * len(operation.arguments)


def _keep_name(ctx, inputs, output):
    ctx.name = _alive[inputs[2]].name


def _no_second(ctx, gradients):
    raise NotImplementedError(f"the gradient of {ctx.name} {_NO_DERIVATIVE}{ctx.name}")


_pull.register_autograd(_no_second, setup_context=_keep_name)

#: States whose matrices stay in the caches of a core.
_CACHED = 1024

_NO_DERIVATIVE = "has no generated derivative; differentiate robot.plain."


def _in_front(tensors, places, ranks):
    """Tensors with the axis of a batch before all others, aligned so that leading axes are broadcast."""
    axes = max(tensor.dim() - (place is not None) - rank for tensor, place, rank in zip(tensors, places, ranks))
    moved = []
    for tensor, place, rank in zip(tensors, places, ranks):
        if place is not None:
            tensor = tensor.movedim(place, 0)
            missing = axes - (tensor.dim() - 1 - rank)
            tensor = tensor.reshape(tensor.shape[0], *[1] * missing, *tensor.shape[1:])
        moved.append(tensor)
    return moved


def _summed(gradient, shape):
    """A gradient in the shape of an argument that was broadcast."""
    return gradient.sum_to_size(shape) if gradient.shape != shape else gradient


def _row(gradient, matrix):
    """gᵀ A, state by state."""
    return np.einsum("...i,...ij->...j", gradient, matrix)


def _column(matrix, vector):
    """A v, state by state."""
    return np.einsum("...ij,...j->...i", matrix, vector)


def _wrenches(operation, q, gradient):
    """The gradient by external wrenches: inverse dynamics subtracts Jᵀ times each of them."""
    recipe, robot = operation.robot._recipe, operation.robot
    links = [link for key, link in recipe.options if key == "external"]
    in_frame_0 = any(key == "external_in_frame_0" for key, _ in recipe.options)
    jacobian = robot.spatial_jacobian if in_frame_0 else robot.body_jacobian
    parts = [_column(jacobian(q, frame=link, order=operation.order), gradient) for link in links]
    return np.stack(parts, axis=-2)


def _inverse_dynamics(operation, q, qd, qdd, *rest):
    *actions, gradient = rest
    further = [-_wrenches(operation, q, gradient) for _ in actions]
    return [*operation.of("inverse_dynamics_vjp", q, qd, qdd, gradient, *actions), *further]


def _forward_dynamics(operation, q, qd, tau, *rest):
    *actions, gradient = rest
    found = operation.of("forward_dynamics_vjp", q, qd, tau, gradient, *actions)
    further = [_wrenches(operation, q, found.dtau) for _ in actions]
    return [*found, *further]


def _bias(operation, q, qd, gradient):
    # External wrenches enter inverse dynamics alone.
    links = sum(key == "external" for key, _ in operation.robot._recipe.options)
    actions = [np.zeros((links, 6), q.dtype)] * bool(links)
    by = operation.of("inverse_dynamics_vjp", q, qd, np.zeros_like(qd), gradient, *actions)
    return [by.dq, by.dqd]


def _gravity(operation, q, gradient):
    return [_row(gradient, operation.robot.gravity_derivative(q))]


def _potential_energy(operation, q, gradient):
    return [gradient[..., None] * operation.robot.gravity(q)]


def _center_of_mass(operation, q, gradient):
    return [_row(gradient, operation.robot.center_of_mass_jacobian(q))]


def _forward_kinematics(operation, q, gradient):
    """Along joint j a pose M changes by L M, with the screw L of its column."""
    frame = operation.frame
    columns = operation.robot.spatial_jacobian(q, frame=frame, order="linear_first")
    pose = operation.robot.forward_kinematics(q, frame=frame)
    linear, angular = columns[..., :3, :], columns[..., 3:, :]
    # The rows of the gradient times those of the pose: of a translation their last column, of a rotation the moments.
    work = np.einsum("...rc,...sc->...rs", gradient, pose)[..., :3, :]
    turning = np.stack(
        [work[..., 2, 1] - work[..., 1, 2], work[..., 0, 2] - work[..., 2, 0], work[..., 1, 0] - work[..., 0, 1]], axis=-1
    )
    return [_row(work[..., 3], linear) + _row(turning, angular)]


#: For each function the gradients by its arguments, of these and of the gradient by its result, as arrays.
DERIVATIVES = {
    "inverse_dynamics": _inverse_dynamics,
    "forward_dynamics": _forward_dynamics,
    "bias": _bias,
    "gravity": _gravity,
    "potential_energy": _potential_energy,
    "center_of_mass": _center_of_mass,
    "forward_kinematics": _forward_kinematics,
}

#: Those whose gradients take no matrices, but for external wrenches.
BY_VECTORS = {"inverse_dynamics", "forward_dynamics", "bias"}


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
