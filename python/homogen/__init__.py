"""Kinematics and dynamics of robots, compiled in the process.

    import homogen

    panda = homogen.load("panda.urdf", tip="panda_hand_tcp")
    tau = panda.inverse_dynamics(q, qd, qdd)    # one state, or arrays (..., n)

A description is expanded to straight-line code for one robot, and LLVM compiles that for the processor at hand when a
function is first called. Compiled code is kept on disk. `help(homogen.load)` lists the options, `dir(panda)` the functions
of a robot, and `help(panda.inverse_dynamics)` says shapes, units and equations of one.
"""

from . import results
from ._engine import VERSION as __version__
from ._load import DescriptionWarning, load
from ._robot import Robot

__all__ = ["DescriptionWarning", "Robot", "__version__", "load", "results"]
