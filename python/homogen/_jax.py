"""Functions of a robot for JAX: traced from plain Python, so that JAX compiles and differentiates them itself.

`jit`, `vmap`, `grad`, `jacfwd`, `jacrev` and all that is made of them apply, as often as one likes and on any device.
"""

from . import results
from ._library import Library, counted, flat, imported, leading


class Jax(Library):
    """The functions of a robot for JAX, of arrays (..., n). Fields are keywords, by default with their values."""

    def __init__(self, robot):
        super().__init__(robot)
        self._jax = imported("jax", "jax", "robot.jax")
        self._numpy = imported("jax.numpy", "jax", "robot.jax")

    def _make(self, name, frame, order):
        np, robot = self._numpy, self._robot
        function = robot.plain.of(name, frame, order)
        arguments, shapes = getattr(robot, name).arrays()
        several = results.of(name)

        @self._jax.jit
        def compute(values, fields):
            axes = leading(arguments, [value.shape for value in values])
            number = np.result_type(*values, np.float32)
            # Entries stand along the first axes.
            ranks = [len(own) for _, own in arguments]
            columns = [np.moveaxis(value, range(-rank, 0), range(rank)) for value, rank in zip(values, ranks)]
            found = function(*columns, library=np, **fields)
            arrays = []
            for result, (_, shape) in zip(found if several else [found], shapes):
                entries = [np.broadcast_to(np.asarray(entry, number), axes) for entry in flat(result)]
                stacked = np.stack(entries, axis=-1) if entries else np.zeros((*axes, 0), number)
                arrays.append(stacked.reshape(*axes, *shape))
            return several(*arrays) if several else arrays[0]

        def call(*values, **fields):
            counted(name, arguments, values)
            return compute([np.asarray(value) for value in values], {**robot.fields, **fields})

        call.__name__, call.__doc__ = name, getattr(robot, name).__doc__
        return call
