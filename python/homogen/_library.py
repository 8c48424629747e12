"""The functions of a robot for other libraries: plain Python, and what the front ends to libraries share."""

import importlib

#: Functions of configurations, which have no front ends to other libraries.
STEPS = ("integrate", "difference", "normalize")


class Library:
    """The functions of a robot for a library, as attributes; `of` names another frame or order of six numbers."""

    def __init__(self, robot):
        self._robot = robot
        self._made = {}

    def __getattr__(self, name):
        # Before it has a robot it has nothing: copies are made so.
        robot = self.__dict__.get("_robot")
        if robot is None or name not in robot._functions or name in STEPS:
            raise AttributeError(f"there is no function {name!r} for {type(self).__name__.lower()}")
        return self.of(name)

    def __dir__(self):
        return [*super().__dir__(), *(name for name in self._robot._functions if name not in STEPS)]

    def __repr__(self):
        return f"<the functions of {self._robot.name!r} for {type(self).__name__.lower()}>"

    def of(self, name, frame=None, order=None):
        """A function about the frame of a link, the tip where none is named, with its six numbers in an order."""
        key = name, frame, order or self._robot._recipe.order
        if key not in self._made:
            self._made[key] = self._make(*key)
        return self._made[key]

    def _make(self, name, frame, order):
        raise NotImplementedError


class Plain(Library):
    """The functions in plain Python: of numbers of any type, with the module that has their sines as `library`.

    Vectors are what can be indexed along the first axis; results are numbers, lists, and lists of rows. Fields are keywords.
    """

    def _make(self, name, frame, order):
        text = self._robot._recipe.plain(name, frame, order)
        scope = {"__name__": f"homogen.plain.{name}"}
        exec(compile(text, f"<{name} of {self._robot.name}>", "exec"), scope)
        scope[name].text = text
        return scope[name]


def imported(module, package, attribute):
    """A module of another library."""
    try:
        return importlib.import_module(module)
    except ImportError as reason:
        raise ImportError(f"{attribute} needs {package}, which is not installed: pip install {package}") from reason


def flat(result):
    """The entries of a result of plain Python, row by row."""
    if isinstance(result, (list, tuple)):
        for part in result:
            yield from flat(part)
    else:
        yield result


def leading(arguments, shapes):
    """The leading axes of the results of arguments, each given by its shape; `shapes` are those of one state."""
    axes = []
    for (name, own), shape in zip(arguments, shapes):
        shape = tuple(shape)
        if len(shape) < len(own) or shape[len(shape) - len(own) :] != tuple(own):
            wanted = ", ".join(["...", *map(str, own)])
            raise ValueError(f"{name} has the shape {shape}, and must have ({wanted})")
        axes.append(shape[: len(shape) - len(own)])
    rank = max(map(len, axes), default=0)
    result = []
    for lengths in zip(*((1,) * (rank - len(one)) + one for one in axes)):
        length = 1
        for one in lengths:
            if length == 1:
                length = one
            elif one != 1 and one != length:
                shown = ", ".join(f"{name} {own}" for (name, _), own in zip(arguments, axes))
                raise ValueError(f"leading axes cannot be broadcast together: {shown}")
        result.append(length)
    return tuple(result)


def counted(function, arguments, values):
    """Raises `TypeError` unless there is a value for each argument."""
    if len(values) != len(arguments):
        names = ", ".join(name for name, _ in arguments)
        raise TypeError(f"{function}({names}): {len(values)} arguments were given")
