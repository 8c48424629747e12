"""One description, from the file to a verdict.

In: a file. Out: whether both read it, and how far every function is from the peer's: with right angles
and zeros taken for what they are, as written, and with a free base. It never lets one file's failure end the run.
"""

import json
import re
import tempfile
from dataclasses import dataclass, field
from pathlib import Path

import compare
import numpy as np
import urdf
from peer import Peer, Unreadable
from program import Failed, Refused

# The largest error that rounding explains.
LIMIT = 1e-11
# A mass matrix that loses more than that at some posture inside the limits may be called singular.
SINGULAR = 1e-9
STATES = 8
# Poses of so many ends of a tree are compared, and the other functions of a frame at the first of them.
ENDS = 6

DYNAMICS = [
    "inverse_dynamics",
    "gravity",
    "bias",
    "mass_matrix",
    "forward_dynamics",
    "mass_matrix_inverse",
]
SOLVED = ["forward_dynamics", "mass_matrix_inverse"]
KINEMATICS = [
    "forward_kinematics",
    "spatial_jacobian",
    "body_jacobian",
    "geometric_jacobian",
    "velocity",
    "acceleration",
]

NOTHING_MOVES = re.compile(r"no joint of .* moves")


@dataclass(frozen=True)
class How:
    """One of the ways in which a file is read."""

    words: str
    options: tuple
    floating: bool = False


WAYS = [
    How("with right angles", ()),
    How("as written", ("--exact",)),
    How("with a free base", ("--exact", "--floating"), True),
]


@dataclass
class Verdict:
    """What became of a file."""

    name: str
    # "read", "nothing moves", "refused", "refused by both"
    outcome: str = "read"
    # Why not, or what was left out.
    reason: str = ""
    joints: int = 0
    warnings: int = 0
    # The largest error of each function, in each way.
    errors: dict = field(default_factory=lambda: {how: {} for how in WAYS})
    # Of a robot without forward dynamics, how near to singular its mass matrix comes.
    least: float = None
    # What must not be.
    failures: list = field(default_factory=list)


def judge(program, file, name):
    """The verdict on a file."""
    verdict = Verdict(name)
    try:
        with tempfile.TemporaryDirectory() as folder:
            examine(program, Path(file), Path(folder), verdict)
    except Failed as failed:
        verdict.failures.append(str(failed))
    except Exception as reason:
        verdict.failures.append(f"not compared: {type(reason).__name__}: {reason}")
    return verdict


def examine(program, file, folder, verdict):
    for how in WAYS:
        try:
            program.run("check", file, *how.options)
        except Refused as refused:
            refuse(file, how, refused, verdict)
            continue
        measure(program, file, folder, how, verdict)


def refuse(file, how, refused, verdict):
    """A refusal is a failure where the peer reads the file."""
    if any(NOTHING_MOVES.search(mistake) for mistake in refused.mistakes):
        verdict.outcome = "nothing moves"
        return
    verdict.outcome, verdict.reason = "refused by both", str(refused)
    try:
        peer = Peer(file, how.floating)
        if not peer.is_sure:
            return
    except Unreadable:
        return
    if peer.model.nv == 0:
        verdict.outcome = "nothing moves"
        return
    verdict.outcome = "refused"
    verdict.failures.append(f"refused {how.words}: {refused}")


def measure(program, file, folder, how, verdict):
    """Compares every function."""
    found = program.check(file, how)
    if not how.floating:
        verdict.joints, verdict.warnings = len(found["joints"]), len(found["warnings"])
        verdict.reason = f"{len(found['mimicked'])} mimic" if found["mimicked"] else ""
    same = folder / "same.urdf"
    same.write_text(urdf.with_right_angles(urdf.read(file), found["snapped"]), "utf-8")
    try:
        peer = Peer(same, how.floating)
    except Unreadable:
        verdict.reason = "not read by Pinocchio"
        return
    peer.order(found["coordinates"], found["velocities"])
    states = random_states(peer.slides(), peer.quaternions(), len(found["velocities"]))
    listed = folder / "states.json"
    listed.write_text(json.dumps({"states": states}))

    theirs = [{**peer.dynamics(state), "tau": np.array(state["tau"])} for state in states]
    for function in DYNAMICS:
        try:
            ours = program.eval(file, how, function, listed)
        except Refused as refused:
            if function in SOLVED:
                verdict.least = peer.least_conditioned() if verdict.least is None else verdict.least
            if function not in SOLVED or verdict.least > SINGULAR:
                verdict.failures.append(f"{function} {how.words}: {refused}")
            continue
        record(verdict, how, function, compare.dynamics(function, ours, theirs), "")
    for end, link in enumerate(peer.leaves()[:ENDS]):
        theirs = [peer.kinematics(state, link) for state in states]
        for function in KINEMATICS if end == 0 else KINEMATICS[:1]:
            try:
                ours = program.eval(file, how, function, listed, link)
            except Refused as refused:
                verdict.failures.append(f"{function} of {link} {how.words}: {refused}")
                continue
            record(verdict, how, function, compare.kinematics(function, ours, theirs), f" of {link}")


def record(verdict, how, function, error, whose):
    errors = verdict.errors[how]
    errors[function] = max(error, errors.get(function, 0.0))
    if not error <= LIMIT:
        verdict.failures.append(f"{function}{whose} differs by {error:.1e} {how.words}")


def random_states(slides, quaternions, velocities):
    """The same for every robot with as many joints: q in ±π or ±0.5 m, quaternions of length 1, q̇ in ±2, q̈
    in ±5, τ in ±20."""
    rng = np.random.default_rng(len(slides))
    reach = np.where(slides, 0.5, np.pi)

    def posture():
        q = rng.uniform(-reach, reach)
        for first in quaternions:
            q[first : first + 4] /= np.linalg.norm(q[first : first + 4])
        return list(q)

    return [
        {
            "q": posture(),
            "qd": list(rng.uniform(-2, 2, velocities)),
            "qdd": list(rng.uniform(-5, 5, velocities)),
            "tau": list(rng.uniform(-20, 20, velocities)),
        }
        for _ in range(STATES)
    ]
