"""The types of results that are several arrays: named tuples, one for each function that has such."""

from collections import namedtuple

from ._engine import functions

_TYPES = {
    name: namedtuple("".join(word.capitalize() for word in name.split("_")), parts, module=__name__)
    for name, _, _, parts, *_ in functions()
    if parts
}
globals().update({of.__name__: of for of in _TYPES.values()})

__all__ = sorted(of.__name__ for of in _TYPES.values())


def of(name):
    """The type of the results of a function; `None` where they are one array."""
    return _TYPES.get(name)
