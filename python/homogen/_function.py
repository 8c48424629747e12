"""Functions of a robot, as Python shows them."""

import inspect

from . import _engine


class Function(_engine.Function):
    """A function of a robot, compiled when it is first called."""

    __slots__ = ()

    __name__ = property(lambda self: self.name)

    @property
    def __signature__(self):
        names, keywords = self.parameters()
        kind = inspect.Parameter
        needed = self.needed()
        parameters = [kind(name, kind.POSITIONAL_OR_KEYWORD) for name in names[:needed]]
        parameters += [kind(name, kind.POSITIONAL_OR_KEYWORD, default=None) for name in names[needed:]]
        parameters += [kind(name, kind.KEYWORD_ONLY, default=None) for name in keywords]
        return inspect.Signature(parameters)


# What a function computes is said of each; a docstring would be the same for all.
Function.__doc__ = property(_engine.Function.about)
