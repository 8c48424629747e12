"""Kernels of a GPU: compiled to PTX here, and run on the CPU, thread after thread, by a driver that stands for the GPU's."""

import ctypes
import re

import llvmlite.binding as llvm
import numpy as np
import pytest

import homogen
from conftest import CASES, DEMANDED, ROBOTS, functions, robot, same, states
from homogen import _cuda

#: What registers of a GPU have in a kernel on the CPU: variables.
HOST = """
@{0} = global i32 0
define i32 @register.{0}() alwaysinline {{
  %value = load i32, ptr @{0}
  ret i32 %value
}}
"""
REGISTERS = ("tid.x", "ctaid.x", "ntid.x")


#: Functions that are compiled in the short form of the tests; the long form, that with libraries, compiles all.
SHORT = {"forward_kinematics", "geometric_jacobian", "gravity", "inverse_dynamics", "mass_matrix", "potential_energy", "constraint"}


def kernels(of):
    """Functions that a robot has, by name."""
    for name, function in functions(of):
        if name in SHORT or any(DEMANDED):
            yield name, function


class Host:
    """A driver whose GPU is the CPU."""

    def __init__(self):
        llvm.initialize_native_target()
        llvm.initialize_native_asmprinter()
        self.launches = []

    def device(self, address):
        return 0

    def load(self, device, entry, ir):
        ir = ir.replace("ptx_kernel ", "")
        for register in REGISTERS:
            ir = re.sub(rf"declare i32 @llvm\.nvvm\.read\.ptx\.sreg\.{register}\(\)\n", HOST.format(register), ir)
            ir = ir.replace(f"@llvm.nvvm.read.ptx.sreg.{register}", f"@register.{register}")
        # By value an array has another place on every processor.
        ir = re.sub(r"ptr byval\([^)]*\) align \d+ %robot", "ptr %robot", ir)
        machine = llvm.Target.from_default_triple().create_target_machine(
            cpu=llvm.get_host_cpu_name(), features=llvm.get_host_cpu_features().flatten(), opt=1, jit=True
        )
        engine = llvm.create_mcjit_compiler(llvm.parse_assembly(ir), machine)
        engine.finalize_object()
        return engine, entry

    def launch(self, device, kernel, blocks, stream, parameters):
        self.launches.append((blocks, stream))
        engine, entry = kernel
        variables = [ctypes.c_uint32.from_address(engine.get_global_value_address(name)) for name in REGISTERS]
        thread, block, threads = variables
        threads.value = _cuda._THREADS
        given = [ctypes.c_void_p(ctypes.addressof(one)) if isinstance(one, ctypes.Array) else one for one in parameters]
        call = ctypes.CFUNCTYPE(None, *map(type, given))(engine.get_function_address(entry))
        for block.value in range(blocks):
            for thread.value in range(_cuda._THREADS):
                call(*given)


class OnGpu:
    """An array of NumPy that says it is on a GPU."""

    def __init__(self, array, stream=None):
        self.array = array
        about = dict(array.__array_interface__, version=3, stream=stream)
        about["data"] = array.ctypes.data, not array.flags.writeable
        self.__cuda_array_interface__ = about


@pytest.fixture
def host(monkeypatch):
    gpu = Host()
    monkeypatch.setattr(_cuda, "_driver", gpu)
    return gpu


def computed(of, name, arguments, count):
    """The results of a kernel, as arrays of NumPy that held other numbers before."""
    function = getattr(of.cuda, name)
    made = [np.full((count, *shape), 7.0, arguments[0].dtype) for _, shape in function.shapes]
    out = [OnGpu(array) for array in made]
    function(*map(OnGpu, arguments), out=out if len(out) > 1 else out[0])
    return made


@pytest.mark.parametrize("case", CASES)
@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_kernels_have_the_bits_of_the_processor(case, dtype, host):
    of = robot(case, reproducible=True)
    for name, function in kernels(of):
        arguments = states(of, [argument for argument, _ in function.arrays()[0]], 3, dtype)
        found = computed(of, name, arguments, 3)
        expected = function(*arguments)
        expected = list(expected) if len(found) > 1 else [expected]
        for (result, _), one, other in zip(function.arrays()[1], found, expected):
            assert same(one, other), f"{name}: {result}"


@pytest.mark.parametrize("case", CASES)
def test_every_function_has_ptx(case):
    of = robot(case)
    for single in (False, True):
        for name, _ in kernels(of):
            entry, ir = of.cuda.of(name).code(single)
            text = _cuda.ptx(entry, ir, (8, 0)).decode()
            assert f".visible .entry {entry}(" in text and text.endswith("\0")
            assert ".extern" not in text, f"{name} calls what nobody has"


def test_a_state_stays_in_registers_and_products_are_fused_as_asked(arm):
    for name in ("inverse_dynamics", "mass_matrix", "body_jacobian"):
        text = _cuda.ptx(*arm.cuda.of(name).code(True), (8, 0)).decode()
        assert ".local" not in text, name
        assert "fma.rn.f32" in text
    plain = robot("arm", reproducible=True)
    assert "fma" not in _cuda.ptx(*plain.cuda.of("inverse_dynamics").code(False), (8, 0)).decode()


def test_a_later_gpu_takes_the_latest_code_that_is_known(arm):
    code = arm.cuda.of("gravity").code(False)
    assert b".target sm_90" in _cuda.ptx(*code, (12, 1))
    assert _cuda.ptx(*code, (12, 1)) == _cuda.ptx(*code, (9, 0))


def test_states_are_shared_between_blocks_and_none_is_beyond_the_last(arm, host):
    count = 2 * _cuda._THREADS + 1
    (q,) = states(arm, ["q"], count, np.float64)
    made = np.full((count + 5, 7), 7.0)
    out = OnGpu(made[:count])
    arm.cuda.gravity(OnGpu(q, stream=42), out=out)
    assert host.launches == [(3, 42)]
    assert np.allclose(made[:count], arm.gravity(q), rtol=1e-13, atol=1e-13)
    assert (made[count:] == 7.0).all()


def test_arrays_are_read_and_written_where_they_lie(arm, host):
    q, qd, qdd = states(arm, ["q", "qd", "qdd"], 6, np.float64)
    expected = arm.inverse_dynamics(q, qd, qdd)
    columns = np.zeros((7, 6))
    by_column = [np.asfortranarray(array) for array in (q, qd, qdd)]
    arm.cuda.inverse_dynamics(*map(OnGpu, by_column), out=OnGpu(columns.T))
    assert np.allclose(columns.T, expected, rtol=1e-13, atol=1e-13)
    # One configuration with many rates, on two axes.
    made = np.zeros((2, 3, 7))
    arm.cuda.inverse_dynamics(OnGpu(q[0]), OnGpu(qd.reshape(2, 3, 7)), OnGpu(qdd.reshape(2, 3, 7)), out=OnGpu(made))
    assert np.allclose(made.reshape(6, 7), arm.inverse_dynamics(q[0], qd, qdd), rtol=1e-13, atol=1e-13)
    arm.cuda.gravity(OnGpu(q[:0]), out=OnGpu(np.zeros((0, 7))))


def test_fields_have_their_values_at_the_call(host):
    of = homogen.load(ROBOTS / "panda_class.urdf", tip="link8", fields={"payload": "mass_of:link7"})
    (q,) = states(of, ["q"], 4, np.float64)
    for payload in (1.0, 3.0):
        of.payload = payload
        (found,) = computed(of, "gravity", [q], 4)
        assert np.allclose(found, of.gravity(q), rtol=1e-13, atol=1e-13)


def test_what_a_gpu_cannot_read_is_refused(arm, host):
    (q,) = states(arm, ["q"], 4, np.float64)
    made = OnGpu(np.zeros((4, 7)))
    for values, out, problem in [
        ((q,), made, "q is no array on a GPU"),
        ((OnGpu(q.astype(int)),), made, "q is of int64"),
        ((OnGpu(q[:, :6].copy()),), made, r"q has the shape \(4, 6\)"),
        ((OnGpu(q),), OnGpu(np.zeros((4, 7), np.float32)), "out: gravity has the shape"),
        ((OnGpu(q),), OnGpu(np.zeros((5, 7))), "out: gravity has the shape"),
        ((OnGpu(q),), None, "cannot be made: give one as out"),
        ((), made, "0 arguments"),
    ]:
        with pytest.raises((TypeError, ValueError), match=problem):
            arm.cuda.gravity(*values, out=out)
    constant = np.zeros((4, 7))
    constant.flags.writeable = False
    with pytest.raises(ValueError, match="cannot be written"):
        arm.cuda.gravity(OnGpu(q), out=OnGpu(constant))
    apart = np.zeros((8, 3, 7))[::2, :2]
    with pytest.raises(ValueError, match="copy it first"):
        arm.cuda.gravity(OnGpu(apart), out=OnGpu(np.zeros((4, 2, 7))))
    with pytest.raises(TypeError, match="arguments of one type"):
        arm.cuda.bias(OnGpu(q), OnGpu(q.astype(np.float32)), out=made)


def test_without_a_driver_there_is_an_error(arm, monkeypatch):
    def absent(name):
        raise OSError(name)

    monkeypatch.setattr(_cuda, "_driver", None)
    monkeypatch.setattr(ctypes, "CDLL", absent)
    with pytest.raises(RuntimeError, match="driver of a GPU"):
        arm.cuda.gravity(OnGpu(np.zeros((1, 7))), out=OnGpu(np.zeros((1, 7))))
