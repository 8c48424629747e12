"""Writes `homogen/_robot.pyi` and `homogen/results.pyi`, the types of a robot, from the engine's table of functions.

    python stub.py                  writes them
    python stub.py --check FOLDER   fails where those of a folder are not what it would write
"""

import sys
from pathlib import Path

# Beside this file the package has no engine: the installed one is meant.
sys.path.remove(str(Path(__file__).resolve().parent))

from homogen import _engine  # noqa: E402
from homogen import results as types_of_results  # noqa: E402


HEAD = '''# Written by stub.py from the engine's table of functions.
from collections.abc import Sequence
from os import PathLike
from pathlib import Path
from typing import Any, Literal, TypeAlias, final

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from . import results

_Floats: TypeAlias = NDArray[np.floating[Any]]
_Order: TypeAlias = Literal["linear_first", "angular_first"]
_Integrator: TypeAlias = Literal["semi_implicit", "euler", "rk4"]

@final
class Robot:
    NQ: int
    NV: int
    name: str
    base: str
    tip: str | None
    joint_names: tuple[str, ...]
    coordinate_names: tuple[str, ...]
    velocity_names: tuple[str, ...]
    constraint_names: tuple[str, ...]
    parameter_names: tuple[str, ...]
    sphere_names: tuple[str, ...]
    pair_names: tuple[str, ...]
    frames: tuple[str, ...]
    warnings: tuple[str, ...]
    lower: NDArray[np.float64]
    upper: NDArray[np.float64]
    max_velocity: NDArray[np.float64]
    max_effort: NDArray[np.float64]
    masses: NDArray[np.float64]
    radii: NDArray[np.float64]
    # Functions by name, of the types of other libraries.
    @property
    def plain(self) -> Any: ...
    @property
    def torch(self) -> Any: ...
    @property
    def jax(self) -> Any: ...
    @property
    def casadi(self) -> Any: ...
    @property
    def numba(self) -> Any: ...
    @property
    def cuda(self) -> Any: ...
    @property
    def fields(self) -> dict[str, float | NDArray[np.float64]]: ...
    @property
    def base_parameters(self) -> dict[str, float]: ...
    @property
    def configurations(self) -> dict[str, NDArray[np.float64]]: ...
    def neutral(self) -> NDArray[np.float64]: ...
    def random(
        self, rng: np.random.Generator | int | None = None, size: int | tuple[int, ...] = ()
    ) -> NDArray[np.float64]: ...
    def step(
        self, q: ArrayLike, qd: ArrayLike, tau: ArrayLike, dt: ArrayLike, actions: ArrayLike | None = None, *,
        integrator: _Integrator = "semi_implicit",
    ) -> results.NextState: ...
    def step_derivatives(
        self, q: ArrayLike, qd: ArrayLike, tau: ArrayLike, dt: ArrayLike, actions: ArrayLike | None = None, *,
        integrator: _Integrator = "semi_implicit",
    ) -> results.StepDerivatives: ...
    def midpoint_residual(
        self, q: ArrayLike, qd: ArrayLike, next_qd: ArrayLike, tau: ArrayLike, dt: ArrayLike, actions: ArrayLike | None = None
    ) -> _Floats: ...
    def midpoint_derivatives(
        self, q: ArrayLike, qd: ArrayLike, next_qd: ArrayLike, dt: ArrayLike, actions: ArrayLike | None = None
    ) -> results.MidpointDerivatives: ...
    def midpoint_configuration(self, q: ArrayLike, qd: ArrayLike, next_qd: ArrayLike, dt: ArrayLike) -> _Floats: ...
    def inverse_kinematics(
        self, pose: ArrayLike, start: ArrayLike | None = None, *, frame: str | None = None, orientation_tolerance: float = 1e-6,
        position_tolerance: float = 1e-6, length_scale: float = 0.5, restarts: int = 31,
    ) -> results.InverseKinematics: ...
    def compile(self, *names: str, dtype: DTypeLike = ..., many: bool = True, wait: bool = True) -> None: ...
    def check(self) -> str: ...
    def count(self, *functions: str, frames: Sequence[str] = ()) -> dict[str, Any]: ...
    def inspect(self, function: str, frame: str | None = None) -> str: ...
    def generate(
        self,
        language: Literal["rust", "c", "llvm", "python"] = "rust",
        *functions: str,
        output: str | PathLike[str] | None = None,
        scalar: Literal["f64", "f32"] = "f64",
        frames: Sequence[str] = (),
        name: str | None = None,
        casadi: bool = False,
    ) -> str | None: ...
    def show(self, *functions: str, output: str | PathLike[str] | None = None) -> Path: ...
    # Fields, by the names that `homogen.load` was called with.
    def __getattr__(self, name: str) -> Any: ...
    def __setattr__(self, name: str, value: ArrayLike) -> None: ...
'''

STEPS = {"integrate": ["q", "v"], "difference": ["q0", "q1"], "normalize": ["q"]}


def method(name, arguments, parts, of_frame, has_order, is_number):
    """A function as a method."""
    words = ["self", *map(parameter, arguments), "*"]
    if "actions" in arguments:
        words[words.index("actions: ArrayLike")] = "actions: ArrayLike = ..."
    if of_frame:
        words.append("frame: str | Sequence[str] | None = None")
    if has_order:
        words.append("order: _Order | None = None")
    # One state has a number, several an array.
    result = f"results.{title(name)}" if parts else "Any" if is_number else "_Floats"
    place = f"tuple[{', '.join(['_Floats'] * len(parts))}]" if parts else "_Floats"
    words.append(f"out: {place} | None = None")
    return f"    def {name}({', '.join(words)}) -> {result}: ...\n"


def parameter(argument):
    """An argument, of which changes may be left out."""
    return f"{argument}: ArrayLike" + (" | None = None" if argument.endswith("_change") else "")


def title(name):
    return "".join(word.capitalize() for word in name.split("_"))


def robot():
    text = HEAD
    for name, arguments in STEPS.items():
        text += method(name, arguments, [], False, False, False)
    for name, _, arguments, parts, of_frame, has_order, is_number, _ in _engine.functions():
        text += method(name, arguments, parts, of_frame, has_order, is_number)
    return text


def results():
    text = "# Written by stub.py from the engine's table of functions.\nfrom typing import Any, NamedTuple\n\n"
    text += "import numpy as np\nfrom numpy.typing import NDArray\n"
    array = "NDArray[np.floating[Any]]"
    # In the order of the table; those of methods in Python follow.
    types = [types_of_results.of(name) for name, _, _, parts, *_ in _engine.functions() if parts]
    for of in [*types, *types_of_results.OTHERS]:
        text += f"\nclass {of.__name__}(NamedTuple):\n"
        text += "".join(f"    {part}: {'NDArray[np.bool_]' if part == 'converged' else array}\n" for part in of._fields)
        for name, member in vars(of).items():
            if isinstance(member, property):
                text += f"    @property\n    def {name}(self) -> {array}: ...\n"
    return text + f"\ndef of(name: str) -> type[tuple[{array}, ...]] | None: ...\n"


def main():
    """Writes the stubs beside this file, or compares those of the folder that is named."""
    check = "--check" in sys.argv
    folder = Path(sys.argv[-1]) if check else Path(__file__).parent / "homogen"
    for name, text in [("_robot.pyi", robot()), ("results.pyi", results())]:
        path = folder / name
        if not check:
            path.write_text(text)
        elif path.read_text() != text:
            sys.exit(f"{path} is not what stub.py writes")


if __name__ == "__main__":
    main()
