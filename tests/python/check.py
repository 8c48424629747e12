"""Checks Python packages: results bit for bit against `homogen eval`, behaviour against NumPy's rules.

Called by run.sh with the command `homogen` and the packages, each with the arguments that it was written with: "MODULE FILE OPTION…".
"""

import ast
import importlib
import inspect
import json
import keyword
import os
import pathlib
import pickle
import pydoc
import shlex
import subprocess
import sys
import tempfile
import threading

import numpy as np

HOMOGEN, *PACKAGES = sys.argv[1:]
passed, failed = 0, 0


def check(right, what):
    """Counts a check, and prints it if it fails."""
    global passed, failed
    if right:
        passed += 1
    else:
        failed += 1
        print(f"failed: {what}")


def raises(error, words, call, what):
    """Checks that a call raises an error with these words in its message."""
    try:
        call()
    except error as found:
        check(type(found) is error and words in str(found), f"{what}: {found!r}")
    except BaseException as found:
        check(False, f"{what}: {found!r}")
    else:
        check(False, f"{what}: nothing was raised")


def same(one, other):
    """True if two arrays have the same shape, type and bits; NaN equals any NaN."""
    one, other = np.asarray(one), np.asarray(other)
    if (one.shape, one.dtype) != (other.shape, other.dtype):
        return False
    bits = f"u{one.dtype.itemsize}"
    equal = one.reshape(-1).view(bits) == other.reshape(-1).view(bits)
    return bool((equal | (np.isnan(one) & np.isnan(other)).reshape(-1)).all())


class Package:
    """A package, and the options that it was written with."""

    def __init__(self, text):
        folder, self.file, *self.options = shlex.split(text)
        self.module = f"{folder}_" if keyword.iskeyword(folder) else folder
        self.python = importlib.import_module(self.module)
        [name] = [name for name in self.python.__all__ if hasattr(getattr(self.python, name), "NQ")]
        self.robot = getattr(self.python, name)()
        self.dtype = np.float32 if "f32" in self.options else np.float64
        self.shared = []  # options shared with eval
        self.frames, options = [], iter(self.options)
        for option in options:
            if option == "--functions":
                next(options)
            elif option == "--frames":
                self.frames = next(options).split(",")
            else:
                self.shared.append(option)

    def methods(self):
        """Yields each function with its arguments."""
        stub = ast.parse(self.stub())
        [cls] = [item for item in stub.body if isinstance(item, ast.ClassDef) and item.name == type(self.robot).__name__]
        for item in cls.body:
            if isinstance(item, ast.FunctionDef) and not item.decorator_list and item.name not in ("__init__", *STEPS):
                yield item.name, [argument.arg for argument in item.args.args[1:]]

    def stub(self):
        return pathlib.Path(self.python.__file__).with_name("__init__.pyi").read_text()

    def states(self, count):
        """Random states, by the names of arguments."""
        random = np.random.default_rng(7)
        robot = self.robot
        q = random.uniform(-2, 2, (count, robot.NQ))
        for first in np.flatnonzero([name.endswith(".qx") for name in robot.coordinate_names]):
            q[:, first : first + 4] /= np.linalg.norm(q[:, first : first + 4], axis=1, keepdims=True)
        over_velocities = "qd", "qdd", "tau", "weights", "q_change", "qd_change", "qdd_change", "tau_change"
        rates = {name: random.uniform(-2, 2, (count, robot.NV)) for name in over_velocities}
        links = sum(len(text.split(",")) for text in following(self.options, "--external"))
        actions = random.uniform(-2, 2, (count, links, 6))
        wrench = random.uniform(-2, 2, (count, 6))
        states = {"q": q, **rates, "wrench": wrench, "actions": actions}
        return {name: values.astype(self.dtype) for name, values in states.items()}

    def eval(self, function, frame, states):
        """Results of `homogen eval`."""
        count = len(states["q"])
        records = [{name: values[k].astype(float).tolist() for name, values in states.items()} for k in range(count)]
        with tempfile.NamedTemporaryFile("w", suffix=".json") as file:
            json.dump({"states": records}, file)
            file.flush()
            command = [HOMOGEN, "eval", self.file, *self.shared, "--function", function]
            command += ["--states", file.name, "--format", "json"]
            command += ["--frame", frame] if frame else []
            answer = subprocess.run(command, capture_output=True, text=True, check=True)
        return json.loads(answer.stdout)


def following(options, wanted):
    return [value for option, value in zip(options, options[1:]) if option == wanted]


STEPS = ("integrate", "difference", "normalize")
SIX = {"velocity", "momentum", "centroidal_momentum", "centroidal_momentum_bias"}
COLUMNS = {"spatial_jacobian", "body_jacobian", "geometric_jacobian"}
COLUMNS |= {f"{name}_rate" for name in COLUMNS}
COLUMNS |= {"jacobian_derivative", "center_of_mass_jacobian", "centroidal_momentum_matrix"}


def as_array(function, values, dtype):
    """Converts a result of `eval` to the layout of the package."""
    # Through decimal digits: f32 results are printed with the shortest digits of f32.
    array = np.array(values, dtype=dtype) if dtype == np.float64 else np.array(
        json.loads(json.dumps(values), parse_float=lambda text: float(np.float32(text))), dtype=dtype
    )
    if function in SIX:
        w = array[..., [2, 0, 1], [1, 2, 0]]
        return np.concatenate([w, array[..., :3, 3]], axis=-1)
    if function in COLUMNS:
        return np.ascontiguousarray(np.swapaxes(array, -1, -2))
    return array


def parts(value):
    return value._asdict() if hasattr(value, "_asdict") else {None: value}


def results_are_those_of_eval(package):
    """Every function, for one state and for many, bit for bit."""
    states = package.states(37)
    for name, arguments in package.methods():
        method = getattr(package.robot, name)
        many = method(*(states[argument] for argument in arguments))
        one = [method(*(states[argument][k] for argument in arguments)) for k in range(37)]
        for part, values in parts(many).items():
            alone = np.array([parts(value)[part] for value in one])
            check(same(values, alone), f"{package.module}: {name} {part}: many states are each state")
        if "_and_" in name and not name.startswith(("velocity_and_a",)):
            continue
        function, _, frame = name.partition("_of_")
        if name.startswith("center_of_mass"):
            function, frame = name, ""
        wanted = [link for link in package.frames if frame and clean(link) == frame.rstrip("_")]
        if frame:
            # Equal identifiers are distinguished by underscores, in the requested order.
            wanted = wanted[len(frame) - len(frame.rstrip("_"))]
        if function == "frame_poses":
            # `eval` has one further frame at most. The poses of one alone may be computed in another order.
            frames = [None] * hasattr(package.robot, "forward_kinematics") + package.frames
            each = [package.eval("forward_kinematics", frame, states)["results"] for frame in frames]
            each = np.stack([as_array(function, one, package.dtype) for one in each], axis=1)
            near = np.allclose(many, each, rtol=0, atol=50 * np.finfo(package.dtype).eps)
            check(many.shape == each.shape and near, f"{package.module}: {name}: the pose of each frame")
            continue
        answer = package.eval(function, wanted, states)
        names = list(package.robot.coordinate_names), list(package.robot.velocity_names)
        check((answer["coordinates"], answer["velocities"]) == names, f"{package.module}: names")
        for part, values in parts(many).items():
            found = [result[part] if part else result for result in answer["results"]]
            found = as_array(function, found, package.dtype)
            check(same(values, found), f"{package.module}: {name} {part}: the bits of eval")


def coordinates_are_integrated(package):
    """Integrates velocities from a configuration, and back, if coordinates include quaternions."""
    robot, states = package.robot, package.states(37)
    has = [hasattr(robot, step) for step in STEPS]
    quaternions = np.flatnonzero([name.endswith(".qx") for name in robot.coordinate_names])
    check(has == [len(quaternions) > 0] * 3, "only robots with quaternions have integrate, difference and normalize")
    if not all(has):
        return
    q, v, tolerance = states["q"], states["qd"] / 2, 50 * np.finfo(package.dtype).eps
    near = lambda one, other: np.allclose(one, other, rtol=0, atol=tolerance)
    ahead = robot.integrate(q, v)
    apart = robot.difference(q, ahead)
    for name, many, one in [
        ("integrate", ahead, [robot.integrate(q[k], v[k]) for k in range(37)]),
        ("difference", apart, [robot.difference(q[k], ahead[k]) for k in range(37)]),
        ("normalize", robot.normalize(2 * q), [robot.normalize(2 * q[k]) for k in range(37)]),
    ]:
        check(same(many, np.array(one)), f"{name}: many states at once differ from one at a time")
    check(same(robot.integrate(q, np.zeros(robot.NV, package.dtype))[:, :3], q[:, :3]), "zero velocity leaves the position")
    check(near(apart, v), "the difference equals the integrated velocity")
    # Along a constant screw, two half steps equal one whole step.
    check(near(robot.integrate(robot.integrate(q, v / 2), v / 2), ahead), "two half steps equal one")
    twice = q.copy()
    for first in quaternions:
        twice[:, first : first + 4] *= 2
    check(near(robot.normalize(twice), q), "quaternions of length 1")


def clean(link):
    """Converts a link name to an identifier of Rust and Python."""
    word = "".join(letter.lower() if letter.isascii() and letter.isalnum() or letter > "一" else "_" for letter in link)
    while "__" in word:
        word = word.replace("__", "_")
    return word.strip("_")


def shapes_follow_numpy(package):
    """Any number of leading axes, broadcasting, and empty axes."""
    robot, states = package.robot, package.states(24)
    q, qd, qdd = states["q"], states["qd"], states["qdd"]
    flat = robot.inverse_dynamics(q, qd, qdd)
    axes = lambda values, *shape: values.reshape(*shape, values.shape[-1])
    check(same(robot.inverse_dynamics(*(axes(x, 2, 3, 4) for x in (q, qd, qdd))), axes(flat, 2, 3, 4)), "three axes")
    one = robot.inverse_dynamics(q, qd[0], qdd[0])
    whole = robot.inverse_dynamics(q, np.tile(qd[0], (24, 1)), np.tile(qdd[0], (24, 1)))
    check(same(one, whole), "one state for all")
    check(same(robot.inverse_dynamics(q, qd[:1], qdd[:1]), whole), "one row for all")
    grid = robot.inverse_dynamics(axes(q[:3], 3, 1), qd[:4], qdd[0])
    each = [[robot.inverse_dynamics(q[i], qd[j], qdd[0]) for j in range(4)] for i in range(3)]
    check(same(grid, np.array(each)), "a grid")
    check(robot.inverse_dynamics(q[0], qd[0], qdd[0]).shape == (robot.NV,), "one state")
    for shape in [(0,), (2, 0), (0, 3)]:
        empty = np.zeros((*shape, robot.NQ), package.dtype)
        rates = np.zeros((*shape, robot.NV), package.dtype)
        check(robot.inverse_dynamics(empty, rates, rates).shape == (*shape, robot.NV), "empty")
        check(robot.mass_matrix(empty).shape == (*shape, robot.NV, robot.NV), "empty")
    check(robot.inverse_dynamics(np.zeros((0, robot.NQ), package.dtype), qd[0], qdd[0]).shape == (0, robot.NV), "one state for an empty axis")
    many = package.states(5003)
    tau = robot.inverse_dynamics(many["q"], many["qd"], many["qdd"])
    some = [0, 511, 512, 2500, 5001, 5002]
    check(same(tau[some], robot.inverse_dynamics(*(many[x][some] for x in ("q", "qd", "qdd")))), "remainder at the end")


def array_arguments_are_read(package):
    """Memory layouts, types and access rights of arguments."""
    robot, states, dtype = package.robot, package.states(12), package.dtype
    q = states["q"]
    gravity = robot.gravity(q)
    wide = np.zeros((24, robot.NQ + 1), dtype)
    wide[::2, :-1] = q
    locked = q.copy()
    locked.flags.writeable = False
    bytes_ = np.zeros(q.nbytes + 1, np.uint8)
    shifted = bytes_[1:].view(dtype).reshape(q.shape)
    shifted[...] = q
    for layout, same_states in {
        "strided": wide[::2, :-1],
        "in Fortran order": np.asfortranarray(q),
        "backwards": q[::-1][::-1],
        "read-only": locked,
        "of the other byte order": q.astype(q.dtype.newbyteorder()),
        "unaligned": shifted,
        "lists": q.tolist(),
    }.items():
        check(same(robot.gravity(same_states), gravity), f"arrays {layout}")
    half = q.astype(np.float16)
    check(same(robot.gravity(half), robot.gravity(half.astype(dtype))), "float16 is safe")
    small = np.ones((3, robot.NQ), np.int8)
    check(same(robot.gravity(small), robot.gravity(small.astype(dtype))), "int8 is safe")
    whole = [[1] * robot.NQ] * 3
    check(same(robot.gravity(whole), robot.gravity(np.ones((3, robot.NQ), dtype))), "whole numbers in lists")
    name = np.dtype(dtype).name
    if dtype == np.float32:
        raises(TypeError, f"q is of float64, which cannot safely be cast to {name}", lambda: robot.gravity(q.astype(float)), "float64")
    else:
        single = q.astype(np.float32)
        check(same(robot.gravity(single), robot.gravity(single.astype(float))), "float32 is safe")
    for wrong in [q.astype(complex), q.astype(object), q.astype(str), q.astype(np.longdouble), [1j] * robot.NQ, None, "q"]:
        raises(TypeError, "q is of ", lambda: robot.gravity(wrong), f"{type(wrong)}")
    shape = f"q must have a shape of (..., {robot.NQ}), and has "
    raises(ValueError, shape + f"({robot.NQ + 1},)", lambda: robot.gravity(np.zeros(robot.NQ + 1, dtype)), "too long")
    raises(ValueError, shape + f"({robot.NQ}, 1)", lambda: robot.gravity(np.zeros((robot.NQ, 1), dtype)), "transposed")
    raises(ValueError, shape + "()", lambda: robot.gravity(0.0), "a scalar")
    rates = np.zeros((5, robot.NV), dtype)
    words = "leading axes that cannot be broadcast together: q (12,), qd (5,)"
    raises(ValueError, words, lambda: robot.bias(q, rates), "lengths")


def out_receives_results(package):
    """The argument `out`."""
    robot, states, dtype = package.robot, package.states(9), package.dtype
    q, qd = states["q"], states["qd"]
    out = np.full((9, robot.NV), np.nan, dtype)
    found = robot.bias(q, qd, out=out)
    check(found is out and same(out, robot.bias(q, qd)), "out")
    raises(ValueError, "out must have a shape of", lambda: robot.bias(q, qd, out=out[1:]), "out too short")
    raises(TypeError, "out must be an array of", lambda: robot.bias(q, qd, out=out.astype(complex)), "complex out")
    raises(ValueError, "contiguous", lambda: robot.bias(q, qd, out=np.asfortranarray(out)), "out in Fortran order")
    raises(ValueError, "overlaps", lambda: robot.bias(q, qd, out=qd), "out overlaps an input")
    out.flags.writeable = False
    raises(ValueError, "written", lambda: robot.bias(q, qd, out=out), "read-only out")


def states_are_independent(package):
    """NaN, infinite and huge inputs affect only their own state."""
    robot, states = package.robot, package.states(40)
    q, qd, qdd = states["q"], states["qd"], states["qdd"]
    right = robot.inverse_dynamics(q, qd, qdd)
    q[5], qd[11, 0], qdd[17], q[23] = np.nan, np.inf, np.nan, 1e9
    found = robot.inverse_dynamics(q, qd, qdd)
    unusual = [5, 11, 17, 23]
    others = np.setdiff1d(np.arange(40), unusual)
    check(same(found[others], right[others]), "the other states")
    check(np.isnan(found[5]).all() and np.isnan(found[17]).any(), "NaN")
    check(np.isfinite(found[23]).all(), "an angle of many turns")
    alone = np.array([robot.inverse_dynamics(q[k], qd[k], qdd[k]) for k in unusual])
    check(same(found[unusual], alone), "each unusual state alone")


def results_do_not_depend_on_cores(package):
    """The same bytes for any number of cores; the global interpreter lock is released during a batch."""
    program = (
        f"import numpy as np, hashlib, {package.module} as m\n"
        f"r = m.{type(package.robot).__name__}()\n"
        "x = np.random.default_rng(3).uniform(-2, 2, (3, 20001, r.NV))\n"
        "print(hashlib.sha256(r.inverse_dynamics(*x).tobytes()).hexdigest())\n"
    )
    run = lambda cores: subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=True, env={**os.environ, "RAYON_NUM_THREADS": cores}
    ).stdout
    check(len({run(cores) for cores in "1235"}) == 1, "cores")

    program += (
        "import os, signal, sys\n"
        "child = os.fork()\n"
        "signal.alarm(20)\n"
        "y = r.inverse_dynamics(*x)\n"
        "if child: sys.exit(os.waitpid(child, 0)[1])\n"
    )
    answer = subprocess.run([sys.executable, "-c", program], capture_output=True)
    check(answer.returncode == 0, f"a forked process has threads of its own: {answer}")

    x = np.zeros((3_000_000, package.robot.NV))
    began, steps = threading.Event(), 0

    def work():
        began.set()
        package.robot.inverse_dynamics(x, x, x)

    # A waiting thread gets the lock from one that runs Python code after this time.
    sys.setswitchinterval(1e-4)
    thread = threading.Thread(target=work)
    thread.start()
    began.wait()
    while thread.is_alive():
        steps += 1
    check(steps > 1000, f"the global interpreter lock is released: {steps} steps during a batch")

    wrong = []

    def repeat(seed):
        q = np.random.default_rng(seed).uniform(-2, 2, (999, package.robot.NV))
        first = package.robot.inverse_dynamics(q, q, q)
        for _ in range(50):
            if not same(package.robot.inverse_dynamics(q, q, q), first):
                wrong.append(seed)

    threads = [threading.Thread(target=repeat, args=(seed,)) for seed in range(6)]
    [thread.start() for thread in threads]
    [thread.join() for thread in threads]
    check(not wrong, "many threads at once")


def the_class_documents_itself(package):
    """Help, stubs, attributes and pickling."""
    robot, cls = package.robot, type(package.robot)
    check(cls.__module__ == package.module, "module of the class")
    stub = ast.parse(package.stub())
    [described] = [item for item in stub.body if isinstance(item, ast.ClassDef) and item.name == cls.__name__]
    written = {item.name for item in described.body if isinstance(item, ast.FunctionDef)}
    written |= {item.target.id for item in described.body if isinstance(item, ast.AnnAssign)}
    real = {name for name in dir(cls) if not name.startswith("__")}
    check(written - {"__init__"} == real, f"names in the stub and in the class: {written ^ real}")
    for item in described.body:
        if not isinstance(item, ast.FunctionDef) or item.name == "__init__":
            continue
        found = getattr(cls, item.name)
        check(pydoc.getdoc(found) == inspect.cleandoc(ast.get_docstring(item, clean=False)), f"{item.name}: help and stub differ")
        if not item.decorator_list:
            arguments = [argument.arg for argument in item.args.args[1:]]
            out = ", *, out=None" if item.args.kwonlyargs else ""
            check(found.__text_signature__ == f"($self, {', '.join(arguments)}{out})", f"{item.name}: {found.__text_signature__}")
    for name in package.python.__all__:
        names = [item.name for item in stub.body if isinstance(item, ast.ClassDef)]
        check(name in names and getattr(package.python, name).__module__ == package.module, f"{name} is public")
    check(pathlib.Path(package.python.__file__).with_name("py.typed").exists(), "py.typed")
    for name, _ in package.methods():
        text = pydoc.render_doc(getattr(robot, name))
        check("Shapes: q (..., " in text and "Returns " in text and "mul, " in text, f"help of {name}")
    copy = pickle.loads(pickle.dumps(robot))
    check(repr(copy) == repr(robot) == f"{cls.__name__}()", "copies")
    for limits, length in [(robot.coordinate_limits, robot.NQ), (robot.velocity_limits, robot.NV)]:
        check(limits.shape == (length, 2) and (limits[:, 0] <= limits[:, 1]).all(), "limits")
    check(len(robot.coordinate_names) == robot.NQ == len(robot.neutral), "coordinates")
    if hasattr(robot, "base_parameters"):
        state = package.states(1)
        q, qd, qdd = (state[name][0] for name in ("q", "qd", "qdd"))
        product = robot.base_regressor(q, qd, qdd) @ robot.base_parameters
        scale = 1e-12 if package.dtype == np.float64 else 1e-4
        check(np.allclose(product, robot.inverse_dynamics(q, qd, qdd), atol=scale, rtol=scale), "Y π is τ")


def hostile_names_stay_text(package):
    """A file with names that would be code if they were not escaped."""
    check(package.module == "class_" and package.python.__all__ == ["None_"] + package.python.__all__[1:], "names")
    check(package.robot.coordinate_names[0] == "class" and package.robot.coordinate_names[2] == "\\", "names are kept")
    check(package.robot.coordinate_names[1] == "''' \\N{DELETE} \\\"{q} %s \u202e\u2066\u200b", "every character of a name")
    text = package.stub() + pathlib.Path(package.python.__file__).read_text()
    check(not any(letter in text for letter in "\u202e\u2066\u200b"), "no invisible letters in the stub")
    check(not any(letter in (getattr(type(package.robot), name).__doc__ or "") for name in dir(package.robot) for letter in "\u202e\u2066\u200b"), "no invisible letters in help")


def other_files_are_kept():
    """A package is written only into a folder without files of others."""
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        write = lambda folder, *options: subprocess.run(
            [HOMOGEN, "python", "robots/two_link.urdf", "-o", str(folder), "--functions", "gravity", *options],
            capture_output=True,
            text=True,
        )
        arm = root / "arm"
        answer = write(arm)
        check(answer.returncode == 0 and answer.stdout == "from arm import TwoLink\n", f"written: {answer}")
        (arm / "target").mkdir()
        (arm / "target" / "built").touch()
        check(write(arm, "--name", "Arm").stdout == "from arm import Arm\n", "written again")
        check((arm / "target" / "built").exists(), "build output stays")
        (arm / "notes.txt").touch()
        answer = write(arm)
        check(answer.returncode == 1 and "notes.txt in it was not written by homogen" in answer.stderr, f"{answer}")
        (root / "mine").mkdir()
        (root / "mine" / "thesis").touch()
        answer = write(root / "mine")
        check(answer.returncode == 1 and "it is not a package written by homogen" in answer.stderr, f"{answer}")
        (root / "file").touch()
        check(write(root / "file").returncode == 1, "a file")
        answer = write(root / "numpy")
        check(answer.returncode == 1 and "would hide NumPy" in answer.stderr, f"{answer}")
        check(write(root / "missing" / "arm").returncode == 1 or (root / "missing" / "arm").exists(), "a missing parent folder")
        answer = write(root / "cortex", "--processor", "cortex-m7", "--scalar", "f32")
        check(answer.returncode == 1 and not (root / "cortex").exists(), f"{answer}")
        left = {path.name for path in root.iterdir()} - {"arm", "mine", "file", "missing"}
        check(not left, f"nothing is left: {left}")


for text in PACKAGES:
    package = Package(text)
    results_are_those_of_eval(package)
    coordinates_are_integrated(package)
    the_class_documents_itself(package)
    if "--functions" not in package.options and package.robot.NQ == package.robot.NV:
        shapes_follow_numpy(package)
        array_arguments_are_read(package)
        out_receives_results(package)
        states_are_independent(package)
    if package.module == "class_":
        hostile_names_stay_text(package)
    if package.module == "panda_py":
        results_do_not_depend_on_cores(package)
other_files_are_kept()
print(f"{passed} passed, {failed} failed")
sys.exit(failed > 0)
