"""`homogen.load`: from a description and options to a robot."""

import inspect
import numbers
import os
import warnings
from collections.abc import Iterable, Mapping
from pathlib import Path

from ._engine import Recipe, options
from ._progress import working
from ._robot import TEXT, Robot, listed

_OPTIONS = dict(options())


class DescriptionWarning(UserWarning):
    """A warning about a description: its place, and the value that is used instead."""


def load(
    source,
    *,
    order="linear_first",
    fields=None,
    ranges=None,
    threads=None,
    functions=(),
    **options,
):
    """The robot of a description.

    source: the path of a URDF, xacro or MJCF file or of a Denavit-Hartenberg table; or the description itself: `bytes`,
        or a `str` that contains a line break or begins with `<`, which may be links and joints in the grammar of Rust's
        `chain!`. Included files and meshes are found from the folder of a file, and may not change while it is loaded
    order: what six numbers that turn and move begin with, in results and in external forces: "linear_first", as Pinocchio
        and ROS have it and as the velocities of a floating base stand, or "angular_first", as Featherstone has it
    fields: numbers that stay free at run time, as attributes: `{"payload": "mass_of:hand"}`
    ranges: the least and the greatest number of a field, for bounds of errors: `{"payload": (0, 3)}`
    threads: how many threads share a call with many states [default: all cores]
    functions: names of functions that are compiled in the background from now on, for one state and for many, in `float64`;
        a call waits for its own and for the one at hand [default: each is compiled when it is first called]

    A switch is `True`; a link or a joint is a name, several are a list; joints with numbers are a dict:
    `lock={"finger": 0.02}`, `friction={"elbow": 0.1}`; and so are arguments of xacro files and folders of packages:
    `arguments={"ur_type": "ur5e"}`, `packages={"ur_description": "../ur_description"}`. Options, as on the command line:

    """
    given = list(_said(options))
    described = [(field, target, _range(ranges, field)) for field, target in (fields or {}).items()]
    for field in ranges or {}:
        if field not in (fields or {}):
            raise ValueError(f"ranges: there is no field {field!r}")
    if threads is not None and threads < 1:
        raise ValueError(f"threads is a number from 1 on, and not {threads}")
    name, text, folder = _text(source)
    with working(f"reading {name}"):
        recipe = Recipe(name, text, folder and (folder, None), given, described, order, threads, None)
        robot = Robot(recipe)
    functions = [functions] if isinstance(functions, str) else list(functions)
    for many in (False, True) if functions else ():
        robot.compile(*functions, many=many, wait=False)
    for warning in robot.warnings:
        warnings.warn(warning, DescriptionWarning, stacklevel=2)
    return robot


load.__doc__ = listed(load.__doc__, _OPTIONS)


def _signature():
    """The signature with each option, for `help` and completion."""
    own = [of for of in inspect.signature(load).parameters.values() if of.kind is not inspect.Parameter.VAR_KEYWORD]
    return inspect.Signature([*own, *(inspect.Parameter(key, inspect.Parameter.KEYWORD_ONLY, default=None) for key in _OPTIONS)])


load.__signature__ = _signature()


def _text(source):
    """The name and the bytes of a description, and the folder of its file."""
    if isinstance(source, (bytes, bytearray)):
        return TEXT, bytes(source), None
    if isinstance(source, str) and ("\n" in source or source.lstrip().startswith("<")):
        return TEXT, source.encode(), None
    path = Path(source)
    try:
        return path.name, path.read_bytes(), path.absolute().parent
    except OSError as reason:
        raise type(reason)(reason.errno, f"cannot read {path}: {reason.strerror}") from None


def _range(ranges, field):
    if not ranges or field not in ranges:
        return None
    least, most = ranges[field]
    return float(least), float(most)


def _said(options):
    """Options as words of the command line, each a key and a value."""
    for key, value in options.items():
        if key not in _OPTIONS:
            raise TypeError(f"load() has no option {key!r}; there are {', '.join(_OPTIONS)}")
        for word in _words(key, value):
            yield key, word


def _words(key, value):
    if value is None or value is False:
        return
    if value is True:
        yield ""
    elif isinstance(value, str):
        yield value
    elif isinstance(value, Mapping):
        for name, of in value.items():
            yield name if of is None else f"{name}={_VALUES.get(key, _numbers)(of)}"
    elif isinstance(value, numbers.Real):
        yield _numbers(value)
    elif isinstance(value, Iterable):
        items = list(value)
        if items and all(isinstance(item, str) for item in items):
            # The words of a formulation are one value.
            yield from [",".join(items)] if key == "formulation" else items
        elif items:
            yield _numbers(items)
    else:
        raise TypeError(f"{key} cannot be {value!r}")


def _argument(value):
    """The value of an argument, as xacro reads it."""
    if isinstance(value, str):
        return value
    return str(value).lower() if isinstance(value, bool) else _numbers(value)


def _numbers(value):
    """A number, or several with commas between them."""
    if isinstance(value, numbers.Integral):
        return str(int(value))
    if isinstance(value, numbers.Real):
        return repr(float(value))
    return ",".join(_numbers(item) for item in value)


# How the values of a dict are written, where they are no numbers.
_VALUES = {"arguments": _argument, "packages": os.path.abspath}
