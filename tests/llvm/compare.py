"""Compares functions of a robot as LLVM IR and as C, bit for bit.

    compare.py HOMOGEN FOLDER "FILE OPTIONS" ...

For each robot, in f32 and f64: C compiled by `cc -O2 -ffp-contract=off`, LLVM IR by llvmlite for this processor, in
vectors of 8 and of 1; states are random. Functions of one state are called one state at a time. Batches take states by
rows, by columns and with gaps; the number of states is not a multiple of any vector length.
"""

import ctypes
import re
import shlex
import subprocess
import sys
from pathlib import Path

import llvmlite.binding as llvm
import numpy as np

STATES = 21
GAP = 3

llvm.initialize_native_target()
llvm.initialize_native_asmprinter()


def compiled(text):
    """Compiles a module for this processor; returns the engine with its functions."""
    module = llvm.parse_assembly(text)
    module.verify()
    features = llvm.get_host_cpu_features().flatten()
    target = llvm.Target.from_default_triple()
    machine = target.create_target_machine(cpu=llvm.get_host_cpu_name(), features=features, opt=2)
    options = llvm.create_pipeline_tuning_options(speed_level=2)
    passes = llvm.create_pass_builder(machine, options)
    passes.getModulePassManager().run(module, passes)
    engine = llvm.create_mcjit_compiler(module, machine)
    engine.finalize_object()
    return engine


def prototypes(header):
    """Name, argument lengths and result lengths of each function."""
    header = re.sub(r"/\*.*?\*/", "", header, flags=re.DOTALL)
    for name, parameters in re.findall(r"HOMOGEN_FN void (\w+)\(([^)]*)\);", header):
        arguments, results = [], []
        for parameter in parameters.split(","):
            if "robot" in parameter.split():
                continue
            if "*robot" in parameter:
                continue
            length = int(np.prod([int(n) for n in re.findall(r"\[(\d+)\]", parameter)], initial=1))
            (arguments if "const" in parameter else results).append(length)
        yield name, arguments, results


def fields(header):
    """Number of values in the struct of fields."""
    struct = re.search(r"typedef struct \{(.*?)\} \w*robot;", re.sub(r"/\*.*?\*/", "", header, flags=re.DOTALL), re.DOTALL)
    if not struct:
        return 0
    members = re.findall(r"\w+ \w+(?:\[(\d+)\])?;", struct[1])
    return sum(int(length or 1) for length in members)


def call(address, pointers):
    ctypes.CFUNCTYPE(None, *[ctypes.c_void_p] * len(pointers))(address)(*pointers)


def strided(address, count, robot, arrays):
    """Calls a batch with arrays of states and their strides."""
    kinds, values = [ctypes.c_int64], [count]
    if robot is not None:
        kinds.append(ctypes.c_void_p)
        values.append(robot.ctypes.data)
    for array in arrays:
        kinds += [ctypes.c_void_p, ctypes.c_int64, ctypes.c_int64]
        values += [array.ctypes.data] + [stride // array.itemsize for stride in array.strides]
    ctypes.CFUNCTYPE(None, *kinds)(address)(*values)


def layouts(array):
    """Yields the same states by rows, by columns, and with gaps."""
    yield np.ascontiguousarray(array)
    yield np.asfortranarray(array)
    with_gaps = np.full((array.shape[0] * 2, array.shape[1] + GAP), np.nan, array.dtype)[::2, : array.shape[1]]
    with_gaps[:] = array
    yield with_gaps


def same(found, expected):
    bits = {4: np.uint32, 8: np.uint64}[expected.itemsize]
    return np.array_equal(np.ascontiguousarray(found).view(bits), np.ascontiguousarray(expected).view(bits))


def compare(homogen, folder, robot, scalar):
    """Returns the number of comparisons; exits at the first difference."""
    words = [homogen, "generate", *shlex.split(robot), "--name", "arm", "--scalar", scalar]
    source, library = folder / "robot.c", folder / f"robot_{abs(hash((robot, scalar)))}.so"

    def run(*more):
        return subprocess.run([*words, *more], check=True, stdout=subprocess.PIPE, stderr=None, text=True).stdout

    run("--language", "c", "-o", str(source))
    subprocess.run(
        ["cc", "-std=c99", "-O2", "-ffp-contract=off", "-shared", "-fPIC", str(source), "-o", str(library), "-lm"], check=True
    )
    in_c = ctypes.CDLL(str(library))
    header = source.with_suffix(".h").read_text()
    dtype = {"f32": np.float32, "f64": np.float64}[scalar]
    random = np.random.default_rng(7)
    count = fields(header)
    robot_fields = random.uniform(0.1, 1.0, count).astype(dtype) if count else None
    engines = {lanes: compiled(run("--language", "llvm", "--lanes", str(lanes))) for lanes in (1, 8)}
    compared = 0
    for name, arguments, results in prototypes(header):
        states = [random.uniform(-1.5, 1.5, (STATES, n)).astype(dtype) for n in arguments]
        expected = [np.zeros((STATES, n), dtype) for n in results]
        for one in range(STATES):
            pointers = [array[one].ctypes.data for array in [*states, *expected]]
            if robot_fields is not None:
                pointers.insert(0, robot_fields.ctypes.data)
            call(ctypes.cast(getattr(in_c, name), ctypes.c_void_p).value, pointers)
        for lanes, engine in engines.items():
            found = [np.zeros((STATES, n), dtype) for n in results]
            for one in range(STATES):
                pointers = [array[one].ctypes.data for array in [*states, *found]]
                if robot_fields is not None:
                    pointers.insert(0, robot_fields.ctypes.data)
                call(engine.get_function_address(name), pointers)
            if not all(map(same, found, expected)):
                sys.exit(f"{robot}, {scalar}: {name} differs from C")
            for layout in range(3):
                inputs = [list(layouts(array))[layout] for array in states]
                found = [list(layouts(np.zeros((STATES, n), dtype)))[layout] for n in results]
                strided(engine.get_function_address(f"{name}_batch"), STATES, robot_fields, [*inputs, *found])
                if not all(map(same, found, expected)):
                    sys.exit(f"{robot}, {scalar}: {name} differs from C in vectors of {lanes}, layout {layout}")
                compared += 1
    return compared


def main():
    homogen, folder, *robots = sys.argv[1:]
    for robot in robots:
        for scalar in ("f64", "f32"):
            compared = compare(homogen, Path(folder), robot, scalar)
            print(f"{robot}, {scalar}: {compared} batches and all single states agree with C")


main()
