"""Functions of a robot for CasADi: plain Python on symbols, which CasADi differentiates and prints as C itself, or code in C
with generated derivatives."""

import tempfile
from pathlib import Path

from . import _engine
from ._library import STEPS, Library, flat, imported


class Casadi(Library):
    """The functions of a robot as `casadi.Function`s of columns; matrices have their usual shape, and wrenches a row for each
    link. Fields are further arguments, by their names."""

    def __init__(self, robot):
        super().__init__(robot)
        self._casadi = imported("casadi", "casadi", "robot.casadi")

    def _make(self, name, frame, order):
        casadi, robot = self._casadi, self._robot
        function = robot.plain.of(name, frame, order)
        arguments, shapes = getattr(robot, name).arrays()
        symbols = [casadi.SX.sym(argument, *shape) for argument, shape in arguments]
        # A matrix of CasADi has no rows that could be indexed.
        values = [
            symbol if len(shape) == 1 else [symbol[row, :] for row in range(shape[0])]
            for symbol, (_, shape) in zip(symbols, arguments)
        ]
        fields = {field: casadi.SX.sym(field, *_lengths(value)) for field, value in robot.fields.items()}
        found = function(*values, library=casadi, **fields)
        found = found if isinstance(found, tuple) else (found,)
        matrices = [_matrix(casadi, list(flat(result)), shape) for result, (_, shape) in zip(found, shapes)]
        inputs = [argument for argument, _ in arguments]
        return casadi.Function(name, [*symbols, *fields.values()], matrices, [*inputs, *fields], [result for result, _ in shapes])


    def external(self, name, flags=("-O2", "-ffp-contract=off")):
        """A function as code in C with its generated derivatives, first and second ones, which the C compiler of this machine
        compiles; it is called as the others are, and a problem of CasADi with it is faster than with symbols.

        flags: of the compiler

        Fields are one argument, `p`, without a derivative. Raises `AttributeError` for a name that is no function's, and
        `OSError` where code cannot be compiled.
        """
        robot = self._robot
        if name not in robot._functions or name in STEPS:
            raise AttributeError(f"there is no function {name!r} for casadi")
        first, second, products = map("+".join, _engine.derivatives(name) if robot._is_euclidean else ["", "", ""])
        functions = [name, *(functions for functions in (first, second, products) if functions)]
        with tempfile.TemporaryDirectory(prefix="homogen-") as folder:
            source = Path(folder) / "robot.c"
            robot.generate("c", *functions, output=source, name="robot", casadi=True)
            options = {"flags": list(flags), "directory": f"{folder}/", "cleanup": False}
            try:
                library = self._casadi.Importer(str(source), "shell", options)
            except RuntimeError as reason:
                raise OSError("robot.casadi.external needs a C compiler, which CasADi calls `gcc`") from reason
            return self._casadi.external(f"robot_casadi_{name}", library)


def _lengths(value):
    """The shape of the value of a field."""
    return getattr(value, "shape", ())


def _matrix(casadi, entries, shape):
    """A matrix of entries that stand row by row."""
    rows, columns = (*shape, 1, 1)[:2]
    if not entries:
        return casadi.SX(rows, columns)
    # Zeros are no entries of a sparse matrix.
    return casadi.sparsify(casadi.reshape(casadi.vertcat(*entries), columns, rows).T)
