"""Functions of a robot for JAX: a primitive over compiled code, which XLA calls by its address, with derivatives and batches.

On the CPU a call is one of XLA's foreign functions; on other devices, and where there are no generated derivatives, JAX traces
plain Python, so that functions can be differentiated as often as one likes. Code that a program of JAX calls is kept until
the process ends, as such programs may outlive the robot; the robot is kept as long as JAX keeps what it has compiled.
"""

import ctypes
import math
import re
from functools import partial
from pathlib import Path

import numpy

from . import results
from ._compile import compiled, loaded
from ._library import Library, counted, flat, imported, leading

jax = imported("jax", "jax", "robot.jax")
np = imported("jax.numpy", "jax", "robot.jax")
ad = imported("jax.interpreters.ad", "jax", "robot.jax")
batching = imported("jax.interpreters.batching", "jax", "robot.jax")
core = imported("jax.extend.core", "jax", "robot.jax")
mlir = imported("jax.interpreters.mlir", "jax", "robot.jax")

#: The least count of states that are computed in the lanes of vectors.
_MANY = 16

# Code that programs of JAX call.
_held = {}


class Jax(Library):
    """The functions of a robot for JAX, of arrays (..., n). Fields are keywords, by default with their values."""

    def _make(self, name, frame, order):
        return Operation(self._robot, name, frame, order)


class Operation:
    """A function of a robot for arrays of JAX."""

    def __init__(self, robot, name, frame, order):
        self.robot, self.name, self.frame, self.order = robot, name, frame, order
        function = getattr(robot, name)
        self.arguments, self.shapes = function.arrays()
        self.below = function.below()
        self._several = results.of(name)
        self.__name__, self.__doc__ = name, function.__doc__

    def __call__(self, *values, **fields):
        counted(self.name, self.arguments, values)
        values = [np.asarray(value) for value in values]
        number = np.result_type(*values, numpy.float32)
        parts = []
        for field, value in self.robot.fields.items():
            parts.append(np.ravel(np.asarray(fields.pop(field, value), number)))
        if fields:
            raise TypeError(f"{self.name}: there are no fields {', '.join(fields)}")
        vector = np.concatenate(parts) if parts else np.zeros(0, number)
        found = _compute.bind(vector, *(np.asarray(value, number) for value in values), operation=self)
        return self._several(*found) if self._several else found[0]

    def leading(self, values):
        return leading(self.arguments, [value.shape for value in values])

    def other(self, name, frame=None, order=None):
        """Another function of the robot."""
        return self.robot.jax.of(name, frame, order or self.order)


def _by_code(fields, *values, operation):
    """The results by compiled code."""
    axes, number = operation.leading(values), fields.dtype
    count = math.prod(axes)
    if count == 0:
        return [np.zeros((*axes, *shape), number) for _, shape in operation.shapes]
    single, many = number == numpy.float32, count >= _MANY
    address, _, code = compiled(operation.robot._recipe, operation.name, operation.frame, operation.order, single, many)
    _held[address] = code
    rows = [
        np.broadcast_to(value, (*axes, *own)).reshape(count, math.prod(own))
        for value, (_, own) in zip(values, operation.arguments)
    ]
    # Code does not write the constant row below some matrices.
    sizes = [math.prod(shape) - (0 if row is None else len(row)) for row, (_, shape) in zip(operation.below, operation.shapes)]
    places = [row.shape[1] for row in rows] + sizes
    head = numpy.array([address, count, len(rows), len(sizes), *places], numpy.int64)
    types = [jax.ShapeDtypeStruct((count, size), number) for size in sizes]
    # Integers of 64 bits are not to be had everywhere.
    found = jax.ffi.ffi_call(_target(), types)(head.view(numpy.uint32), fields, *rows)
    arrays = []
    for array, row, (_, shape) in zip(found, operation.below, operation.shapes):
        if row is not None:
            array = np.concatenate([array, np.broadcast_to(np.asarray(row, number), (count, len(row)))], axis=1)
        arrays.append(array.reshape(*axes, *shape))
    return arrays


def _by_plain(fields, *values, operation):
    """The results by plain Python."""
    function = operation.robot.plain.of(operation.name, operation.frame, operation.order)
    axes, number = operation.leading(values), fields.dtype
    given, first = {}, 0
    for field, value in operation.robot.fields.items():
        count = numpy.size(value)
        given[field] = fields[first : first + count].reshape(numpy.shape(value))
        first += count
    # Entries stand along the first axes.
    ranks = [len(own) for _, own in operation.arguments]
    columns = [np.moveaxis(value, range(-rank, 0), range(rank)) for value, rank in zip(values, ranks)]
    found = function(*columns, library=np, **given)
    arrays = []
    for result, (_, shape) in zip(found if operation._several else [found], operation.shapes):
        entries = [np.broadcast_to(np.asarray(entry, number), axes) for entry in flat(result)]
        stacked = np.stack(entries, axis=-1) if entries else np.zeros((*axes, 0), number)
        arrays.append(stacked.reshape(*axes, *shape))
    return arrays


def _types(fields, *values, operation):
    axes = operation.leading(values)
    return [jax.core.ShapedArray((*axes, *shape), fields.dtype) for _, shape in operation.shapes]


def _batched(values, places, *, operation):
    """Leading axes are broadcast, so that a batch is one more of them."""
    fields, *values = values
    of_fields, *places = places
    if of_fields is not None:
        mapped = jax.vmap(partial(_by_plain, operation=operation), in_axes=(of_fields, *places))
        return mapped(fields, *values), [0] * len(operation.shapes)
    ranks = [len(own) for _, own in operation.arguments]
    return _compute.bind(fields, *_moved(values, places, ranks), operation=operation), [0] * len(operation.shapes)


def _moved(values, places, ranks):
    """Values whose axis of a batch, if they have one, is the first of as many leading axes as the longest has."""
    axes = max(value.ndim - (place is not None) - rank for value, place, rank in zip(values, places, ranks))
    moved = []
    for value, place, rank in zip(values, places, ranks):
        if place is not None:
            value = np.moveaxis(value, place, 0)
            missing = axes - (value.ndim - 1 - rank)
            value = value.reshape(value.shape[0], *[1] * missing, *value.shape[1:])
        moved.append(value)
    return moved


def _pushed(primals, tangents, *, operation):
    """Values and their change along tangents."""
    fields, *values = primals
    of_fields, *of_values = tangents
    found = _compute.bind(*primals, operation=operation)
    has_rule = operation.robot._is_euclidean and operation.name in DERIVATIVES
    if not has_rule or type(of_fields) is not ad.Zero:
        made = tuple(map(ad.instantiate_zeros, tangents))
        _, changes = jax.jvp(partial(_by_plain, operation=operation), tuple(primals), made)
        return found, changes
    along = tuple(type(tangent) is not ad.Zero for tangent in of_values)
    given = [tangent for tangent, is_given in zip(of_values, along) if is_given]
    change = _change.bind if operation.name in GRADIENTS else _changed
    return found, [change(fields, *values, *given, operation=operation, along=along)]


def _other(operation, fields):
    """Calls of other functions of the robot."""

    def call(name, *arguments, frame=None, order=None):
        several = _compute.bind(fields, *arguments, operation=operation.other(name, frame, order))
        return several if len(several) > 1 else several[0]

    return call


def _leading_of_change(arguments, operation, along):
    """The leading axes of a change: those of values and of tangents, of which JAX has batches where it has one value."""
    own = operation.arguments
    own = [*own, *(argument for argument, is_given in zip(own, along) if is_given)]
    return leading(own, [array.shape for array in arguments])


def _parted(arguments, operation, along):
    """Values, and the tangents along some of them; `None` for the others."""
    count = len(operation.arguments)
    tangents = iter(arguments[count:])
    return arguments[:count], [next(tangents) if is_given else None for is_given in along]


def _changed(fields, *arguments, operation, along):
    """The change of the result, by matrices of derivatives."""
    values, tangents = _parted(arguments, operation, along)
    change = DERIVATIVES[operation.name](operation, _other(operation, fields), values, tangents)
    return np.broadcast_to(change, (*_leading_of_change(arguments, operation, along), *operation.shapes[0][1]))


def _changed_by_plain(fields, *arguments, operation, along):
    """The same by plain Python."""
    values, tangents = _parted(arguments, operation, along)
    axes = _leading_of_change(arguments, operation, along)
    made = []
    for value, tangent, (_, own) in zip(values, tangents, operation.arguments):
        tangent = np.zeros_like(value) if tangent is None else tangent
        made.append([np.broadcast_to(array, (*axes, *own)) for array in (value, tangent)])
    primals, tangents = zip(*made)
    return jax.jvp(partial(_by_plain, fields, operation=operation), primals, tangents)[1][0]


def _type_of_change(fields, *arguments, operation, along):
    axes = _leading_of_change(arguments, operation, along)
    return jax.core.ShapedArray((*axes, *operation.shapes[0][1]), fields.dtype)


def _pushed_change(primals, tangents, **given):
    made = tuple(map(ad.instantiate_zeros, tangents))
    return jax.jvp(partial(_changed, **given), tuple(primals), made)


def _batched_change(values, places, *, operation, along):
    fields, *values = values
    of_fields, *places = places
    given = {"operation": operation, "along": along}
    if of_fields is not None:
        return jax.vmap(partial(_changed_by_plain, **given), in_axes=(of_fields, *places))(fields, *values), 0
    ranks = [len(own) for _, own in operation.arguments]
    ranks += [rank for rank, is_given in zip(ranks, along) if is_given]
    return _change.bind(fields, *_moved(values, places, ranks), **given), 0


def _pulled(cotangent, fields, *arguments, operation, along):
    """The gradients by the tangents: products of the cotangent and the derivatives, without a matrix of these."""
    values, tangents = _parted(arguments, operation, along)
    if type(cotangent) is ad.Zero:
        return [None] * (1 + len(arguments))
    found = GRADIENTS[operation.name](operation, _other(operation, fields), values, cotangent)
    pairs = [(gradient, tangent) for gradient, tangent in zip(found, tangents) if tangent is not None]
    nothing = [None] * (1 + len(values))
    return [*nothing, *(_summed(gradient, tangent.aval.shape) for gradient, tangent in pairs)]


def _summed(gradient, shape):
    """The sum over axes along which an argument was broadcast."""
    gradient = gradient.sum(tuple(range(gradient.ndim - len(shape))))
    axes = [k for k, (own, wanted) in enumerate(zip(gradient.shape, shape)) if own != wanted]
    return gradient.sum(tuple(axes), keepdims=True)


_compute = core.Primitive("homogen")
_compute.multiple_results = True
_compute.def_abstract_eval(_types)
_compute.def_impl(jax.jit(lambda *values, operation: _compute.bind(*values, operation=operation), static_argnames="operation"))
batching.primitive_batchers[_compute] = _batched
ad.primitive_jvps[_compute] = _pushed
mlir.register_lowering(_compute, mlir.lower_fun(_by_plain, multiple_results=True))
mlir.register_lowering(_compute, mlir.lower_fun(_by_code, multiple_results=True), platform="cpu")

# The change of a result along tangents: linear in them, so that JAX goes back through it by products of a vector and the
# derivatives.
_change = core.Primitive("homogen_change")
_change.def_abstract_eval(_type_of_change)
_change.def_impl(jax.jit(lambda *values, **given: _change.bind(*values, **given), static_argnames=("operation", "along")))
batching.primitive_batchers[_change] = _batched_change
ad.primitive_jvps[_change] = _pushed_change
ad.primitive_transposes[_change] = _pulled
mlir.register_lowering(_change, mlir.lower_fun(_changed, multiple_results=False))


def _along(*pairs):
    """The sum of matrices times tangents, of those that are not zero."""
    terms = [np.einsum("...ij,...j->...i", matrix, tangent) for matrix, tangent in pairs if tangent is not None]
    return sum(terms[1:], terms[0])


def _jacobians(operation, other, q):
    """The Jacobian of each external wrench."""
    options = operation.robot._recipe.options
    name = "spatial_jacobian" if any(key == "external_in_frame_0" for key, _ in options) else "body_jacobian"
    return [other(name, q, frame=link) for key, link in options if key == "external"]


def _wrenches(operation, other, q, wrenches):
    """Jᵀ times the change of each external wrench."""
    jacobians = enumerate(_jacobians(operation, other, q))
    terms = [np.einsum("...ij,...i->...j", jacobian, wrenches[..., k, :]) for k, jacobian in jacobians]
    return sum(terms[1:], terms[0])


def _pulled_wrenches(operation, other, q, weights):
    """J times weights for each external wrench."""
    return np.stack([_along((jacobian, weights)) for jacobian in _jacobians(operation, other, q)], axis=-2)


def _directions(values, tangents):
    """The tangents of q, q̇ and q̈ or τ, zeros where there are none."""
    return [np.zeros_like(values[1]) if tangent is None else tangent for tangent in tangents[:3]]


def _is_batched(values, tangents):
    """True if there are several tangents for each value: then matrices of derivatives serve all of them."""
    return max(np.ndim(tangent) for tangent in tangents if tangent is not None) > max(map(np.ndim, values[:3]))


def _inverse_dynamics(operation, other, values, tangents):
    q, qd, qdd, *actions = values
    if actions and tangents[3] is not None:
        change = -_wrenches(operation, other, q, tangents[3])
        if all(tangent is None for tangent in tangents[:3]):
            return change
    else:
        change = 0
    if _is_batched(values, tangents[:3]):
        dq, dqd = other("inverse_dynamics_derivatives", *values)
        return change + _along((dq, tangents[0]), (dqd, tangents[1]), (other("mass_matrix", q), tangents[2]))
    return change + other("inverse_dynamics_jvp", q, qd, qdd, *_directions(values, tangents), *actions)[1]


def _forward_dynamics(operation, other, values, tangents):
    q, qd, tau, *actions = values
    forces = tangents[2]
    if actions and tangents[3] is not None:
        # A change of a wrench is one of torques.
        more = _wrenches(operation, other, q, tangents[3])
        forces = more if forces is None else forces + more
    tangents = [*tangents[:2], forces]
    if _is_batched(values, tangents):
        dq, dqd, dtau = other("forward_dynamics_derivatives", *values)
        return _along((dq, tangents[0]), (dqd, tangents[1]), (dtau, tangents[2]))
    return other("forward_dynamics_jvp", q, qd, tau, *_directions(values, tangents), *actions)[1]


def _without_accelerations(operation, values):
    """The arguments of inverse dynamics that give the bias: external wrenches enter inverse dynamics alone."""
    q, qd = values
    links = sum(key == "external" for key, _ in operation.robot._recipe.options)
    return [q, qd, np.zeros_like(qd), *[np.zeros((links, 6), q.dtype)] * bool(links)]


def _bias(operation, other, values, tangents):
    values = _without_accelerations(operation, values)
    return _inverse_dynamics(operation, other, values, [*tangents, *[None] * (len(values) - 2)])


def _gravity(operation, other, values, tangents):
    return _along((other("gravity_derivative", *values), tangents[0]))


def _potential_energy(operation, other, values, tangents):
    return np.einsum("...j,...j->...", other("gravity", *values), tangents[0])


def _center_of_mass(operation, other, values, tangents):
    return _along((other("center_of_mass_jacobian", *values), tangents[0]))


def _forward_kinematics(operation, other, values, tangents):
    """Along a screw L a pose M changes by L M."""
    jacobian = other("spatial_jacobian", *values, frame=operation.frame, order="linear_first")
    twist = _along((jacobian, tangents[0]))
    pose = other("forward_kinematics", *values, frame=operation.frame)
    linear, angular = twist[..., :3], twist[..., 3:]
    turned = np.cross(angular[..., None, :], np.swapaxes(pose[..., :3, :], -1, -2))
    change = np.swapaxes(turned, -1, -2).at[..., 3].add(linear)
    return np.concatenate([change, np.zeros_like(change[..., :1, :])], axis=-2)


#: For each function its change along tangents, of which those that are zero are `None`.
DERIVATIVES = {
    "inverse_dynamics": _inverse_dynamics,
    "forward_dynamics": _forward_dynamics,
    "bias": _bias,
    "gravity": _gravity,
    "potential_energy": _potential_energy,
    "center_of_mass": _center_of_mass,
    "forward_kinematics": _forward_kinematics,
}


def _weighted_torques(operation, other, values, weights):
    q, qd, qdd, *actions = values
    found = other("inverse_dynamics_vjp", q, qd, qdd, weights, *actions)
    return [*found, *(-_pulled_wrenches(operation, other, q, weights) for _ in actions)]


def _weighted_accelerations(operation, other, values, weights):
    q, qd, tau, *actions = values
    found = other("forward_dynamics_vjp", q, qd, tau, weights, *actions)
    return [*found, *(_pulled_wrenches(operation, other, q, found[2]) for _ in actions)]


def _weighted_bias(operation, other, values, weights):
    q, qd, qdd, *actions = _without_accelerations(operation, values)
    return other("inverse_dynamics_vjp", q, qd, qdd, weights, *actions)[:2]


#: For some functions the gradients by the arguments of the sum of the results times weights.
GRADIENTS = {
    "inverse_dynamics": _weighted_torques,
    "forward_dynamics": _weighted_accelerations,
    "bias": _weighted_bias,
}


# --- the foreign function -------------------------------------------------------------------------

#: A handler of XLA's foreign functions (`xla/ffi/api/c_api.h`). Its first argument holds the address of the code, the number
#: of states, of arguments and of results, and for each of these how many numbers a state has; its second the fields.
_HANDLER = """
define ptr @homogen_xla(ptr %frame) nounwind {
  %extension.at = getelementptr i8, ptr %frame, i64 8
  %extension = load ptr, ptr %extension.at
  %is.call = icmp eq ptr %extension, null
  br i1 %is.call, label %call, label %extended
extended:
  %type.at = getelementptr i8, ptr %extension, i64 8
  %type = load i32, ptr %type.at
  %is.question = icmp eq i32 %type, 1
  br i1 %is.question, label %question, label %call
question:
  %metadata.at = getelementptr i8, ptr %extension, i64 24
  %metadata = load ptr, ptr %metadata.at
  %major.at = getelementptr i8, ptr %metadata, i64 24
  store i32 MAJOR, ptr %major.at
  %minor.at = getelementptr i8, ptr %metadata, i64 28
  store i32 MINOR, ptr %minor.at
  ret ptr null
call:
  %arguments.at = getelementptr i8, ptr %frame, i64 72
  %arguments = load ptr, ptr %arguments.at
  %results.at = getelementptr i8, ptr %frame, i64 112
  %results = load ptr, ptr %results.at
  %head = call ptr @data(ptr %arguments, i64 0)
  %fields = call ptr @data(ptr %arguments, i64 1)
  %code = load ptr, ptr %head
  %states.at = getelementptr i64, ptr %head, i64 1
  %states = load i64, ptr %states.at
  %given.at = getelementptr i64, ptr %head, i64 2
  %given = load i64, ptr %given.at
  %made.at = getelementptr i64, ptr %head, i64 3
  %made = load i64, ptr %made.at
  %all = add i64 %given, %made
  %arrays = alloca { ptr, i64, i64 }, i64 %all
  br label %next
next:
  %k = phi i64 [ 0, %call ], [ %k.next, %filled ]
  %more = icmp ult i64 %k, %all
  br i1 %more, label %which, label %compute
which:
  %is.argument = icmp ult i64 %k, %given
  br i1 %is.argument, label %argument, label %result
argument:
  %k.argument = add i64 %k, 2
  %start.argument = call ptr @data(ptr %arguments, i64 %k.argument)
  br label %filled
result:
  %k.result = sub i64 %k, %given
  %start.result = call ptr @data(ptr %results, i64 %k.result)
  br label %filled
filled:
  %start = phi ptr [ %start.argument, %argument ], [ %start.result, %result ]
  %k.head = add i64 %k, 4
  %stride.at = getelementptr i64, ptr %head, i64 %k.head
  %stride = load i64, ptr %stride.at
  %start.at = getelementptr { ptr, i64, i64 }, ptr %arrays, i64 %k, i32 0
  store ptr %start, ptr %start.at
  %state.at = getelementptr { ptr, i64, i64 }, ptr %arrays, i64 %k, i32 1
  store i64 %stride, ptr %state.at
  %entry.at = getelementptr { ptr, i64, i64 }, ptr %arrays, i64 %k, i32 2
  store i64 1, ptr %entry.at
  %k.next = add i64 %k, 1
  br label %next
compute:
  call void %code(i64 %states, ptr %fields, ptr %arrays)
  ret ptr null
}

define internal ptr @data(ptr %buffers, i64 %k) nounwind {
  %buffer.at = getelementptr ptr, ptr %buffers, i64 %k
  %buffer = load ptr, ptr %buffer.at
  %data.at = getelementptr i8, ptr %buffer, i64 24
  %data = load ptr, ptr %data.at
  ret ptr %data
}
"""

#: The type of a capsule with a handler.
_CAPSULE = b"xla._CUSTOM_CALL_TARGET"


def _target():
    """The name of the foreign function."""
    name = "homogen"
    if name not in _held:
        header = (Path(jax.ffi.include_dir()) / "xla/ffi/api/c_api.h").read_text()
        text = _HANDLER
        for part in ("MAJOR", "MINOR"):
            number = re.search(rf"#define XLA_FFI_API_{part} (\d+)", header)
            text = text.replace(f"i32 {part}", f"i32 {number[1]}")
        code = loaded("homogen_xla", text)
        capsule = ctypes.pythonapi.PyCapsule_New
        capsule.restype, capsule.argtypes = ctypes.py_object, (ctypes.c_void_p, ctypes.c_char_p, ctypes.c_void_p)
        jax.ffi.register_ffi_target(name, capsule(code.address, _CAPSULE, None), platform="cpu")
        _held[name] = code
    return name
