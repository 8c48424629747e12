"""Functions of a robot for Numba: calls of the compiled code, from compiled loops, without the interpreter."""

import ctypes

import numpy as np

from . import results
from ._compile import compiled
from ._library import Library, imported

#: States, fields, and of each array its address and the distances between its states and between its entries.
_ENTRY = ctypes.CFUNCTYPE(None, ctypes.c_int64, ctypes.c_void_p, ctypes.c_void_p)


class Numba(Library):
    """The functions of a robot for code that Numba compiles: of contiguous arrays of `float64` for one state, with the values
    that fields have when a function is taken."""

    def __init__(self, robot):
        super().__init__(robot)
        self._numba = imported("numba", "numba", "robot.numba")

    def _make(self, name, frame, order):
        recipe = self._robot._recipe
        arguments, shapes = getattr(self._robot, name).arrays()
        below = getattr(self._robot, name).below()
        address, _, code = compiled(recipe, name, frame, order, False, False)
        fields = np.array(recipe.values, float)
        names = [argument for argument, _ in arguments]
        made = [f"result_{k}" for k in range(len(shapes))]
        arrays = [*names, *made]
        lines = [f"def {name}({', '.join(names)}):"]
        for argument, shape in arguments:
            lines += [
                f"    if {argument}.shape != {tuple(shape)}:",
                f"        raise ValueError('{argument} must have the shape {tuple(shape)}')",
            ]
        for result, (_, shape) in zip(made, shapes):
            lines.append(f"    {result} = np.empty({tuple(shape) or (1,)})")
        lines.append(f"    places = np.empty(({len(arrays)}, 3), np.int64)")
        for k, array in enumerate(arrays):
            lines.append(f"    places[{k}, 0], places[{k}, 1], places[{k}, 2] = {array}.ctypes.data, 0, 1")
        lines.append("    entry(1, fields.ctypes, places.ctypes)")
        for result, row in zip(made, below):
            lines += [f"    {result}[3, {k}] = {value!r}" for k, value in enumerate(row or ())]
        found = [result if shape else f"{result}[0]" for result, (_, shape) in zip(made, shapes)]
        several = results.of(name)
        lines.append(f"    return {'several' if several else ''}({', '.join(found)})")
        scope = {"np": np, "entry": _ENTRY(address), "fields": fields, "several": several}
        exec("\n".join(lines), scope)
        function = self._numba.njit(scope[name])
        # The code is in memory as long as it is held.
        function.code = code
        return function
