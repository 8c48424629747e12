"""Arguments that compiled code cannot read as they are."""

import numpy as np

_SINGLE, _DOUBLE = np.dtype(np.float32), np.dtype(np.float64)


def converted(name, value, single):
    """`value` as a C-contiguous array of `float32` or `float64`.

    Raises `TypeError` where numbers would be lost: masks, complex and text; a `float64` never becomes a `float32`, as a
    function computes in single precision only where all arguments are so.
    """
    if isinstance(value, np.ma.MaskedArray):
        raise TypeError(f"{name} is a masked array, whose mask would be lost: fill it, or select what is not masked")
    try:
        array = np.asarray(value)
    except ValueError as reason:
        raise ValueError(f"{name} is no array of numbers: {reason}") from None
    wanted = _SINGLE if single else _DOUBLE
    if array.dtype != wanted:
        if array.dtype.kind not in "iuf" or not np.can_cast(array.dtype, _DOUBLE, "safe"):
            raise TypeError(f"{name} is of {array.dtype}, which cannot safely be cast to {wanted}")
        array = array.astype(wanted, order="C")
    is_read = array.flags.c_contiguous and array.flags.aligned
    return array if is_read else np.require(array, wanted, ["C", "A"])

