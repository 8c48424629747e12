from collections.abc import Mapping, Sequence
from os import PathLike
from typing import Literal

from ._robot import Robot

class DescriptionWarning(UserWarning): ...

def load(
    source: str | PathLike[str] | bytes,
    *,
    order: Literal["linear_first", "angular_first"] = "linear_first",
    fields: Mapping[str, str] | None = None,
    ranges: Mapping[str, tuple[float, float]] | None = None,
    threads: int | None = None,
    functions: str | Sequence[str] = ...,
    arguments: Mapping[str, str | float | bool] | None = None,
    packages: Mapping[str, str | PathLike[str]] | None = None,
    base: str | None = None,
    floating: bool = False,
    tip: str | None = None,
    path_only: bool = False,
    lock: str | Sequence[str] | Mapping[str, float | None] | None = None,
    drop: str | Sequence[str] | None = None,
    loop: str | Sequence[str] | None = None,
    actuated: str | Sequence[str] | None = None,
    gravity: Sequence[float] | Literal["none"] | None = None,
    external: str | Sequence[str] | None = None,
    external_in_frame_0: bool = False,
    friction: bool | Mapping[str, float | Sequence[float]] = False,
    damping: Mapping[str, float | Sequence[float]] | None = None,
    rotors: bool = False,
    armature: Mapping[str, float | Sequence[float]] | None = None,
    rotor: Mapping[str, float] | None = None,
    ratio: Mapping[str, float] | None = None,
    exact: bool = False,
    strict: bool = False,
    processor: str | None = None,
    formulation: str | Sequence[str] | None = None,
    collision: bool | str | Sequence[str] = False,
    reproducible: bool = False,
) -> Robot: ...
