"""Functions of a robot on GPUs of NVIDIA: LLVM makes PTX of the same IR, and the driver launches it over arrays by pointer.

Arrays are those with `__cuda_array_interface__`: of CuPy, PyTorch, JAX and Numba. A thread computes a state. Neither a toolkit
nor another compiler is needed. What is loaded stays in the GPU until the process ends, since launches return before it is run.
"""

import ctypes
import math
import os
import re
import threading

import llvmlite.binding as llvm
import numpy

from . import results
from ._compile import key_of, kept, optimise, parsed
from ._engine import VERSION
from ._library import Library, counted, imported, leading
from ._progress import working

_TRIPLE = "nvptx64-nvidia-cuda"
#: Optimisation level: entries of arguments must become registers.
_EFFORT = 2
#: Threads of a block. A function that takes all registers of a thread leaves room for two such blocks.
_THREADS = 128
#: The latest compute capability that is compiled for; the driver runs that on later GPUs, too.
_LATEST = (9, 0)

#: Guards LLVM, the driver and what has been loaded.
_lock = threading.RLock()


class Cuda(Library):
    """The functions of a robot on a GPU of NVIDIA, of arrays (..., n) there of one type, `float32` or `float64`.

    Results are arrays of the library that the first argument is of, computed on its stream. Axes of any strides are read in
    place: those of states, taken together, must be as far apart as each other. Fields have their values at the call.
    """

    def _make(self, name, frame, order):
        return Operation(self._robot, name, frame, order)


class Operation:
    """A function of a robot for arrays on a GPU."""

    def __init__(self, robot, name, frame, order):
        self.robot, self.name, self.frame, self.order = robot, name, frame, order
        function = getattr(robot, name)
        self.arguments, self.shapes = function.arrays()
        self._several = results.of(name)
        self._loaded = {}
        self.__name__, self.__doc__ = name, function.__doc__

    def __call__(self, *values, out=None):
        """The results, or those in `out`: an array, or one for each of several results."""
        counted(self.name, self.arguments, values)
        given = [_Array(name, value) for (name, _), value in zip(self.arguments, values)]
        number = given[0].number
        for array in given:
            if array.number != number:
                raise TypeError(f"{given[0].name} is of {number}, and {array.name} of {array.number}: give arguments of one type")
        axes = leading(self.arguments, [array.shape for array in given])
        wanted = [(*axes, *shape) for _, shape in self.shapes]
        found = [_new_like(values[0], shape, number) for shape in wanted] if out is None else self._out(out)
        made = [_Array(name, value, written=True) for (name, _), value in zip(self.shapes, found)]
        for array, shape in zip(made, wanted):
            if array.shape != shape or array.number != number:
                raise ValueError(f"out: {array.name} has the shape {array.shape} of {array.number}, and must have {shape} of {number}")
        shapes = [shape for _, shape in (*self.arguments, *self.shapes)]
        places = [array.placed(axes, shape) for array, shape in zip((*given, *made), shapes)]
        count = math.prod(axes)
        if count:
            self._launch(count, places, given[0], number == numpy.float32)
        return self._several(*found) if self._several else found[0]

    def _out(self, out):
        found = [out] if len(self.shapes) == 1 else list(out)
        if len(found) != len(self.shapes):
            raise ValueError(f"out must be {len(self.shapes)} arrays, one a result")
        return found

    def _launch(self, count, places, first, single):
        type_ = ctypes.c_float if single else ctypes.c_double
        fields = self.robot._recipe.values
        parameters = [ctypes.c_int64(count)]
        if fields:
            parameters.append((type_ * len(fields))(*fields))
        for address, state, entry in places:
            parameters += [ctypes.c_void_p(address), ctypes.c_int64(state), ctypes.c_int64(entry)]
        with _lock:
            gpu = driver()
            device = gpu.device(first.address)
            key = device, single
            if key not in self._loaded:
                self._loaded[key] = gpu.load(device, *self.code(single))
            gpu.launch(device, self._loaded[key], -(-count // _THREADS), first.stream, parameters)
            if first.waits:
                gpu.wait(device, first.stream)

    def code(self, single):
        """The name of the kernel, and its IR."""
        recipe = self.robot._recipe
        entry, ir, _ = recipe.code(self.name, self.frame, self.order, single, 0, not recipe.reproducible)
        if re.search(r"call \w+ @llvm\.(sin|cos)\.", ir):
            raise ValueError(f"{self.name} takes sines of the platform, and a GPU has none that are exact: leave platform-sines out")
        return entry, ir


class _Array:
    """An array on a GPU: address, shape, strides in numbers, and the stream on which it is used."""

    def __init__(self, name, value, written=False):
        self.name = name
        # PyTorch shows no memory of tensors that have gradients.
        value = value.detach() if hasattr(value, "detach") else value
        #: Its library knows nothing of streams, and reads results once they are there.
        self.waits = hasattr(value, "block_until_ready")
        if self.waits:
            value.block_until_ready()
        try:
            about = value.__cuda_array_interface__
        except AttributeError:
            raise TypeError(f"{name} is no array on a GPU: give one of CuPy, PyTorch, JAX or Numba") from None
        self.number = numpy.dtype(about["typestr"])
        if self.number not in (numpy.float32, numpy.float64):
            raise TypeError(f"{name} is of {self.number}: give float32 or float64")
        if about.get("mask") is not None:
            raise TypeError(f"{name} is masked, and its mask would be lost: fill it, or select what is not masked")
        self.address, is_constant = about["data"]
        if written and is_constant and not self.waits:
            raise ValueError(f"out: {name} cannot be written")
        self.shape = tuple(about["shape"])
        size = self.number.itemsize
        strides = about.get("strides")
        if strides is None:
            strides = [math.prod(self.shape[k + 1 :]) * size for k in range(len(self.shape))]
        if any(stride % size for stride in strides):
            raise ValueError(f"{name} has strides that are no multiples of its numbers: copy it")
        self.strides = [stride // size for stride in strides]
        stream = _stream_of_torch(value)
        self.stream = (about.get("stream") or 0) if stream is None else stream

    def placed(self, axes, own):
        """The address, and how far states and entries of a state are apart, of states with these leading axes."""
        before = len(self.shape) - len(own)
        entry = _pace(own, self.strides[before:])
        missing = len(axes) - before
        of_axes = [0] * missing + [0 if length == 1 else stride for length, stride in zip(self.shape[:before], self.strides)]
        state = _pace(axes, of_axes)
        if entry is None or state is None:
            shown = tuple(self.strides)
            raise ValueError(f"{self.name} has strides {shown} that are not one distance for all its states: copy it first")
        return self.address, state, entry


def _pace(lengths, strides):
    """The distance between neighbours on all these axes; `None` where they have more than one."""
    count, pace = 1, 0
    for length, stride in zip(reversed(lengths), reversed(strides)):
        if length == 1:
            continue
        if count == 1:
            pace = stride
        elif stride != pace * count:
            return None
        count *= length
    return pace


def _library_of(value):
    return type(value).__module__.partition(".")[0]


def _stream_of_torch(value):
    """The address of PyTorch's stream; `None` for arrays of other libraries, which show it themselves."""
    if _library_of(value) != "torch":
        return None
    torch = imported("torch", "torch", "robot.cuda")
    return torch.cuda.current_stream(value.device).cuda_stream


def _new_like(value, shape, number):
    """A new array of the library that a value is of, on the same GPU."""
    library = _library_of(value)
    if library == "torch":
        return value.detach().new_empty(shape)
    if library == "cupy":
        with value.device:
            return imported("cupy", "cupy", "robot.cuda").empty(shape, number)
    if library == "numba":
        return imported("numba.cuda", "numba", "robot.cuda").device_array(shape, number)
    if library in ("jax", "jaxlib"):
        # Nobody has seen it yet, so that it may be written.
        jax = imported("jax", "jax", "robot.cuda")
        return jax.device_put(jax.numpy.empty(shape, number), value.device)
    raise TypeError(f"an array of {type(value).__name__} cannot be made: give one as out")


def ptx(entry, ir, capability):
    """The code of a kernel for GPUs of a compute capability, from the cache on disk or compiled."""
    processor = "sm_{}{}".format(*min(capability, _LATEST))
    about = (VERSION, *llvm.llvm_version_info, _TRIPLE, processor, _EFFORT, entry, ir)
    return kept(key_of(about), lambda: _compile(entry, ir, processor))


def _compile(entry, ir, processor):
    llvm.initialize_all_targets()
    llvm.initialize_all_asmprinters()
    machine = llvm.Target.from_triple(_TRIPLE).create_target_machine(cpu=processor, opt=_EFFORT)
    module, inner = parsed(entry, ir, _TRIPLE)
    module.data_layout = str(machine.target_data)
    for function in inner:
        if b"noinline" not in b"".join(function.attributes):
            function.add_function_attribute("alwaysinline")
    optimise(module, machine, _EFFORT)
    # The driver reads it up to a zero.
    return machine.emit_assembly(module).encode() + b"\0"


_driver = None


def driver():
    """The driver, looked for when it is first needed."""
    global _driver
    if _driver is None:
        _driver = Driver()
    return _driver


class Driver:
    """The driver of NVIDIA's GPUs, by the interface that it has in C (`cuda.h`). It works in the primary contexts of GPUs, as
    libraries of arrays do."""

    #: Attributes of a pointer and of a GPU.
    _ORDINAL, _MAJOR, _MINOR = 9, 75, 76

    def __init__(self):
        try:
            self._library = ctypes.CDLL("nvcuda.dll" if os.name == "nt" else "libcuda.so.1")
        except OSError as reason:
            raise RuntimeError("robot.cuda needs the driver of a GPU of NVIDIA, which is not installed") from reason
        self._call("cuInit", ctypes.c_uint(0))
        self._contexts = {}

    def device(self, address):
        """The GPU in whose memory an address is."""
        device = ctypes.c_int()
        self._call("cuPointerGetAttribute", ctypes.byref(device), ctypes.c_int(self._ORDINAL), ctypes.c_uint64(address))
        return device.value

    def load(self, device, entry, ir):
        """A kernel in the memory of a GPU."""
        capability = []
        for attribute in (self._MAJOR, self._MINOR):
            value = ctypes.c_int()
            self._call("cuDeviceGetAttribute", ctypes.byref(value), ctypes.c_int(attribute), ctypes.c_int(device))
            capability.append(value.value)
        with working(f"compiling {entry}"):
            code = ptx(entry, ir, tuple(capability))
        module, kernel = ctypes.c_void_p(), ctypes.c_void_p()
        with _Current(self, device):
            self._call("cuModuleLoadData", ctypes.byref(module), ctypes.c_char_p(code))
            self._call("cuModuleGetFunction", ctypes.byref(kernel), module, ctypes.c_char_p(entry.encode()))
        return kernel

    def launch(self, device, kernel, blocks, stream, parameters):
        """Begins to compute blocks of states on a stream."""
        addresses = (ctypes.c_void_p * len(parameters))(*map(ctypes.addressof, parameters))
        size = [ctypes.c_uint(length) for length in (blocks, 1, 1, _THREADS, 1, 1, 0)]
        with _Current(self, device):
            self._call("cuLaunchKernel", kernel, *size, ctypes.c_void_p(stream), addresses, None)

    def wait(self, device, stream):
        """Waits until all on a stream is done."""
        with _Current(self, device):
            self._call("cuStreamSynchronize", ctypes.c_void_p(stream))

    def context(self, device):
        """The primary context of a GPU."""
        if device not in self._contexts:
            context = ctypes.c_void_p()
            self._call("cuDevicePrimaryCtxRetain", ctypes.byref(context), ctypes.c_int(device))
            self._contexts[device] = context
        return self._contexts[device]

    def _call(self, name, *arguments):
        status = getattr(self._library, name)(*arguments)
        if status:
            text = ctypes.c_char_p()
            self._library.cuGetErrorString(ctypes.c_int(status), ctypes.byref(text))
            reason = text.value.decode() if text.value else "unknown error"
            raise RuntimeError(f"the GPU's driver refuses {name}: {reason} ({status})")


class _Current:
    """A GPU whose primary context is the current one of this thread."""

    def __init__(self, driver, device):
        self._driver, self._context = driver, driver.context(device)

    def __enter__(self):
        self._driver._call("cuCtxPushCurrent_v2", self._context)

    def __exit__(self, *_):
        self._driver._call("cuCtxPopCurrent_v2", ctypes.byref(ctypes.c_void_p()))
