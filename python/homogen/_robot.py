"""A robot: its functions, its fields, and what it says of itself."""

import html
import inspect
import json
import tempfile
import webbrowser
from pathlib import Path
from typing import final

import numpy as np

from . import _engine, _midpoint, results
from ._background import begin
from ._compile import compiled
from ._function import Function
from ._ik import inverse_kinematics
from ._library import STEPS, Plain
from ._progress import working
from ._step import step

_FUNCTIONS = {name: sentence for name, sentence, *_ in _engine.functions()}
# The functions that not every robot has, and what they are of.
_NEEDS = {name: needs for name, *_, needs in _engine.functions() if needs}
#: The name, in messages, of a description that is no file.
TEXT = "<text>"


def listed(text, lines):
    """A docstring with lines after it, each a name and a sentence."""
    return "\n".join([inspect.cleandoc(text), "", *(f"    {name}: {sentence}" for name, sentence in lines.items())])


@final
class Robot:
    """A robot, made by `homogen.load`.

    Functions take arrays (..., n) of any leading axes, broadcast as NumPy does, in float64, or in float32 where all
    arguments are so. They are compiled when they are first called; `compile` does that before. Jacobians are (6, n), poses
    are 4×4.

    """

    def __init__(self, recipe):
        facts = recipe.facts()
        own = self.__dict__
        own["_recipe"] = recipe
        own["NQ"], own["NV"] = len(facts["coordinates"]), len(facts["velocities"])
        for name, fact in [
            ("name", "name"),
            ("base", "base"),
            ("tip", "tip"),
            ("joint_names", "joints"),
            ("coordinate_names", "coordinates"),
            ("velocity_names", "velocities"),
            ("constraint_names", "constraints"),
            ("parameter_names", "parameters"),
            ("frames", "links"),
            ("warnings", "warnings"),
        ]:
            own[name] = tuple(facts[fact]) if isinstance(facts[fact], list) else facts[fact]
        for name in ("lower", "upper", "max_velocity", "max_effort", "masses"):
            own[name] = np.array(facts[name], float)
            own[name].flags.writeable = False
        own["_neutral"] = np.array(facts["neutral"], float)
        own["_configurations"] = facts["configurations"]
        own["_kinds"] = np.array(facts["kinds"])
        own["_motions"] = tuple(facts["motions"])
        # Each coordinate is added to and has a velocity of its own: there are no quaternions and no planar joints.
        own["_is_euclidean"] = set(self._motions) <= {"along", "mimic"}
        own["_fields"] = _places(recipe, facts["fields"])
        names = [*STEPS, *_FUNCTIONS]
        for name, fact in [("sphere_names", "spheres"), ("pair_names", "pairs")]:
            own[name] = tuple(facts.get(fact, ()))
        own["radii"] = np.array(facts.get("radii", ()), float)
        own["radii"].flags.writeable = False
        has = {"loops": self.constraint_names, "spheres": self.sphere_names}
        names = [name for name in names if name not in _NEEDS or has[_NEEDS[name]]]
        own["_functions"] = tuple(names)
        own["_libraries"] = {}

    def __getattr__(self, name):
        own = self.__dict__
        # Before it has a recipe it has nothing: copies are made so.
        if "_functions" in own:
            if name in self._functions:
                function = Function(self._recipe, name, compiled, results.of(name))
                own[name] = function
                return function
            if name in self._fields:
                first, count = self._fields[name]
                values = np.array(self._recipe.values[first : first + count])
                return float(values[0]) if count == 1 else values
            if name in _FUNCTIONS:
                raise AttributeError(f"{self.name!r} has no {_NEEDS[name]}, and {name} is of robots with {_NEEDS[name]}")
        raise AttributeError(f"a robot has no attribute {name!r}")

    def __setattr__(self, name, value):
        if name not in self._fields:
            fields = ", ".join(self._fields) or "none"
            raise AttributeError(f"{name!r} is no field of {self.name!r}; fields are {fields}")
        first, count = self._fields[name]
        numbers = np.asarray(value, float)
        if numbers.shape not in ((count,), *([()] if count == 1 else [])):
            raise ValueError(f"{name} has the shape {numbers.shape}, and must have ({count},)")
        if not np.isfinite(numbers).all():
            raise ValueError(f"{name} must be finite")
        self._recipe.set_values(first, numbers.ravel().tolist())

    def __delattr__(self, name):
        raise AttributeError(f"{name!r} cannot be deleted")

    def __dir__(self):
        return [*super().__dir__(), *self._functions, *self._fields]

    def __repr__(self):
        joints = ", ".join(self.joint_names)
        tip = "" if self.tip is None else f", tip {self.tip}"
        fields = "".join(f", {name}={getattr(self, name)}" for name in self._fields)
        return f"<homogen.Robot {self.name}: base {self.base}{tip}{fields}; {self.NQ} coordinates: {joints}>"

    def __eq__(self, other):
        if not isinstance(other, Robot):
            return NotImplemented
        mine, theirs = self._recipe, other._recipe
        return mine.identity() == theirs.identity() and mine.values == theirs.values

    def __hash__(self):
        return hash(self._recipe.identity())

    def __reduce__(self):
        return Robot, (self._recipe,)

    def __copy__(self):
        kind, given = self._recipe.__reduce__()
        return Robot(kind(*given))

    def __deepcopy__(self, memo):
        return self.__copy__()

    @property
    def plain(self):
        """The functions in plain Python, for numbers of any library: `panda.plain.gravity(q, library=numpy)`."""
        return self._of(Plain)

    @property
    def torch(self):
        """The functions for PyTorch, of tensors (..., n), with gradients."""
        from ._torch import Torch

        return self._of(Torch)

    @property
    def jax(self):
        """The functions for JAX, of arrays (..., n): `jit`, `vmap`, `jvp` and `vjp` apply."""
        from ._jax import Jax

        return self._of(Jax)

    @property
    def casadi(self):
        """The functions as functions of CasADi."""
        from ._casadi import Casadi

        return self._of(Casadi)

    @property
    def numba(self):
        """The functions for code that Numba compiles, of one state."""
        from ._numba import Numba

        return self._of(Numba)

    @property
    def cuda(self):
        """The functions on a GPU of NVIDIA, of arrays there: of CuPy, PyTorch, JAX or Numba."""
        from ._cuda import Cuda

        return self._of(Cuda)

    def _of(self, library):
        """The functions for a library, made once."""
        own = self._libraries
        if library not in own:
            own[library] = library(self)
        return own[library]

    @property
    def fields(self):
        """The fields and their values."""
        return {name: getattr(self, name) for name in self._fields}

    @property
    def base_parameters(self):
        """The base parameters as described, which the base regressor is multiplied by: a dict of the parameter that leads each
        and its value, in kg, kg m, kg m²."""
        names, values = self._recipe.base_parameters()
        return dict(zip(names, values))

    @property
    def configurations(self):
        """The configurations with names, from the keyframes of an MJCF file: a dict of arrays."""
        return {name: np.array(q, float) for name, q in self._configurations.items()}

    def neutral(self):
        """The configuration at which every joint is where it was placed: zeros, and 0, 0, 0, 1 of quaternions."""
        return self._neutral.copy()

    def random(self, rng=None, size=()):
        """Configurations, uniform within limits; without limits angles within π to both sides, lengths within 1 m.

        rng: a `numpy.random.Generator`, or the seed of one
        size: the leading axes
        """
        rng = np.random.default_rng(rng)
        size = (size,) if np.isscalar(size) else tuple(size)
        most = np.where(self._kinds == "turn", np.pi, 1.0)
        lower = np.where(np.isfinite(self.lower), self.lower, np.minimum(-most, self.upper - most))
        upper = np.where(np.isfinite(self.upper), self.upper, np.maximum(most, lower + most))
        q = rng.uniform(lower, upper, (*size, self.NQ))
        for first in np.flatnonzero(self._kinds == "quaternion")[::4]:
            # Normal numbers have no direction that they prefer.
            numbers = rng.standard_normal((*size, 4))
            q[..., first : first + 4] = numbers / np.linalg.norm(numbers, axis=-1, keepdims=True)
        return q

    def step(self, q, qd, tau, dt, actions=None, *, integrator="semi_implicit"):
        """The state after `dt` seconds under constant τ: q and qd.

        integrator: `semi_implicit`, q̇⁺ = q̇ + Δt q̈ and q⁺ = q ⊕ Δt q̇⁺; `euler`, q⁺ = q ⊕ Δt q̇; `rk4`, of order 4
        actions: constant external wrenches, of robots that have them
        """
        return step(self, integrator, q, qd, tau, dt, () if actions is None else (actions,), False)

    def step_derivatives(self, q, qd, tau, dt, actions=None, *, integrator="semi_implicit"):
        """The derivatives of `step` by q, q̇ and τ; `a` and `b` of the result are the matrices of a discrete-time controller.

        With quaternions, rows and columns of q are along velocities.
        """
        return step(self, integrator, q, qd, tau, dt, () if actions is None else (actions,), True)

    def midpoint_residual(self, q, qd, next_qd, tau, dt, actions=None):
        """The torques and forces that velocities `next_qd` after `dt` seconds need by the implicit midpoint rule, less τ; zero
        for those of the rule: q⁺ = q ⊕ Δt w with w = (q̇ + q̇⁺)/2, and inverse dynamics at q ⊕ Δt w/2, w and (q̇⁺ − q̇)/Δt
        needs τ.

        actions: constant external wrenches, of robots that have them
        """
        return _midpoint.residual(self, q, qd, next_qd, tau, dt, () if actions is None else (actions,))

    def midpoint_derivatives(self, q, qd, next_qd, dt, actions=None):
        """The derivatives of `midpoint_residual` by q along velocities, by q̇ and by q̇⁺; that by τ is −1."""
        return _midpoint.derivatives(self, q, qd, next_qd, dt, () if actions is None else (actions,))

    def midpoint_configuration(self, q, qd, next_qd, dt):
        """The configuration after a step by the implicit midpoint rule, q ⊕ Δt (q̇ + q̇⁺)/2."""
        return _midpoint.configuration(self, q, qd, next_qd, dt)

    def inverse_kinematics(
        self, pose, start=None, *, frame=None, orientation_tolerance=1e-6, position_tolerance=1e-6, length_scale=0.5, restarts=31
    ):
        """Configurations within the limits at which a frame is at a target: q, whether each has converged, and the remaining
        angle in rad and distance in m. What does not converge is the closest configuration found.

        pose: (..., 4, 4), the target in the axes of the base
        start: (..., n), where the search begins [default: the middle of the limits]
        frame: the link [default: the tip]
        orientation_tolerance, position_tolerance: largest angle in rad, largest distance in m
        length_scale: an angle of 1 rad weighs as much as this distance in m
        restarts: maximum number of further starts, the same ones at each call

        Raises `ValueError` for a target that is no pose, and for robots with quaternions, planar joints or loops.
        """
        tolerance = orientation_tolerance, position_tolerance
        return inverse_kinematics(self, pose, start, frame, tolerance, length_scale, restarts)

    def compile(self, *names, dtype=np.float64, many=True, wait=True):
        """Compiles functions before they are called; where none is named all of them, without those of a frame if there is
        no tip.

        dtype: `float64` or `float32`
        many: for arrays of states; otherwise for one state
        wait: until they are compiled; otherwise that happens in the background, and a call waits for its function and the one at
            hand

        Raises `AttributeError` for a name that is no function's, and `ValueError` for a function of a frame where there is no
        tip.
        """
        dtype = np.dtype(dtype)
        if dtype not in (np.float32, np.float64):
            raise ValueError(f"dtype is float32 or float64, and not {dtype}")
        functions = [self._function(name) for name in names or self._functions]
        if not names and self.tip is None:
            functions = [function for function in functions if "frame" not in function.parameters()[1]]
        options = {"single": dtype == np.float32, "many": bool(many)}
        if not wait:
            begin(self, [function.name for function in functions], **options)
            return
        for k, function in enumerate(functions):
            with working(f"compiling {function.name}, {k + 1} of {len(functions)}"):
                function.compile(**options)

    def _function(self, name):
        """The function of a name; raises `AttributeError` for any other name."""
        if name not in self._functions:
            raise AttributeError(f"{self.name!r} has no function {name!r}")
        return getattr(self, name)

    def check(self):
        """Report, as text: links and joints that were read, merged, locked or left out, and every warning."""
        return self._answer("check")

    def count(self, *functions, frames=()):
        """What functions cost and how exact they are, all of them where none is named: operations, depth, bounds."""
        named = [f"--functions={','.join(functions)}"] if functions else []
        return json.loads(self._answer("count", "--format=json", *named, *(f"--frames={frame}" for frame in frames)))

    def inspect(self, function, frame=None):
        """The code of a function in Rust, with its documentation."""
        return self._answer("inspect", f"--function={function}", *([f"--frame={frame}"] if frame else []))

    def generate(self, language="rust", *functions, output=None, scalar="f64", frames=(), name=None, casadi=False):
        """The functions as a file: `rust`, `c`, `llvm` or `python`; all of them where none is named.

        output: the file, a header beside it in C; without it the text is returned
        scalar: `f64` or `f32`
        casadi: with the interface of CasADi's external functions, in C
        """
        words = [f"--language={language}", f"--scalar={scalar}", *(f"--frames={frame}" for frame in frames)]
        if language == "python":
            words.append(f"--order={self._recipe.order.replace('_', '-')}")
        if functions:
            words.append(f"--functions={','.join(functions)}")
        if name is not None:
            words.append(f"--name={name}")
        if casadi:
            words.append("--casadi")
        for field, target, reach in self._recipe.fields:
            words.append(f"--field={field}={target}")
            if reach is not None:
                words.append(f"--range={field}={reach[0]!r}..{reach[1]!r}")
        if output is not None:
            words.append(f"--output={Path(output).absolute()}")
        return self._answer("generate", *words) or None

    def show(self, *functions, output=None):
        """Opens a page in the browser: the robot as a skeleton to move, and functions with cost, bound and code, all of them
        where none is named. Returns the path of the page.

        output: the file of the page; otherwise one in a new folder of the system's folder for temporary files
        """
        path = Path(output) if output is not None else Path(tempfile.mkdtemp(prefix="homogen-")) / "robot.html"
        named = [f"--functions={','.join(functions)}"] if functions else []
        path.write_text(self._answer("show", *named), encoding="utf-8")
        webbrowser.open(path.absolute().as_uri())
        return path

    def _repr_html_(self):
        """The skeleton with joints to move, in a frame of its own, for notebooks."""
        page = html.escape(self._answer("show", "--functions=potential_energy"))
        return f'<iframe srcdoc="{page}" sandbox="allow-scripts" style="width: 100%; height: 40em; border: 0"></iframe>'

    def _answer(self, command, *words):
        """What the command line answers about this robot."""
        names = dict(_engine.options())
        flags = [
            f"--{key.replace('_', '-')}={value}" if value else f"--{key.replace('_', '-')}"
            for key, value in self._recipe.options
            if key in names
        ]
        with tempfile.TemporaryDirectory() as room:
            name = self._recipe.file
            file = self._recipe.path()
            if file is None:
                file = Path(room) / ("robot" if name == TEXT else name)
                file.write_bytes(self._recipe.bytes)
            with working(f"homogen {command}"):
                output, remarks, status = _engine.answer([command, str(file), *flags, *words])
        if status in (1, 2):
            raise ValueError(remarks.removeprefix("error: ").rstrip().replace(f"{room}/", ""))
        return output


Robot.__doc__ = listed(Robot.__doc__, _FUNCTIONS)


def _places(recipe, counts):
    """Where the numbers of each field stand, and how many they are."""
    places, first = {}, 0
    for (name, *_), count in zip(recipe.fields, counts):
        if name in _FUNCTIONS or hasattr(Robot, name) or name in STEPS or not name.isidentifier():
            raise ValueError(f"no field can be called {name!r}: a robot has that name already; choose another")
        places[name] = first, count
        first += count
    return places
