"""Compares one description with Pinocchio.

In: a file. Out: which programs read it, and the error of every function: with right angles and zeros snapped, as
written, and with a floating base. A failure for one file never ends the run.
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

# Largest error due to rounding.
LIMIT = 1e-11
# Smallest relative eigenvalue, within the limits, below which homogen may call a mass matrix singular.
SINGULAR = 1e-9
STATES = 8
# Number of leaf links whose poses are compared; the other functions of a frame are compared at the first one.
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
    """A set of options to read a file with."""

    words: str
    options: tuple
    floating: bool = False


WAYS = [
    How("with right angles", ()),
    How("as written", ("--exact",)),
    How("with a floating base", ("--exact", "--floating"), True),
]


@dataclass
class Verdict:
    """Outcome for a file."""

    name: str
    # "read", "nothing moves", "refused", "refused by both"
    outcome: str = "read"
    # Reason of a refusal, or the parts that were not compared.
    reason: str = ""
    joints: int = 0
    warnings: int = 0
    # Largest error of each function, for each set of options.
    errors: dict = field(default_factory=lambda: {how: {} for how in WAYS})
    # Smallest relative eigenvalue of the mass matrix, for a robot without forward dynamics.
    least: float = None
    # Failed checks.
    failures: list = field(default_factory=list)


def judge(program, file, name):
    """Compares a file; never raises."""
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
    """Records a refusal; it is a failure if the peer reads the file."""
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
    try:
        # Of a file with expressions of xacro, which homogen alone expands, no number can be written in full.
        Peer(file, how.floating)
        same = folder / "same.urdf"
        same.write_text(urdf.with_right_angles(urdf.read(file), found["snapped"]), "utf-8")
        peer = Peer(same, how.floating)
    except Unreadable:
        verdict.reason = "not read by Pinocchio"
        return
    peer.order(found["coordinates"], found["velocities"])
    states = random_states(peer.translations(), peer.quaternions(), len(found["velocities"]))
    state_file = folder / "states.json"
    state_file.write_text(json.dumps({"states": states}))

    theirs = [{**peer.dynamics(state), "tau": np.array(state["tau"])} for state in states]
    for function in DYNAMICS:
        try:
            ours = program.eval(file, how, function, state_file)
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
                ours = program.eval(file, how, function, state_file, link)
            except Refused as refused:
                verdict.failures.append(f"{function} of {link} {how.words}: {refused}")
                continue
            record(verdict, how, function, compare.kinematics(function, ours, theirs), f" of {link}")


def record(verdict, how, function, error, whose):
    errors = verdict.errors[how]
    errors[function] = max(error, errors.get(function, 0.0))
    if not error <= LIMIT:
        verdict.failures.append(f"{function}{whose} differs by {error:.1e} {how.words}")


def random_states(translations, quaternions, velocities):
    """Random states, the same for every robot with as many joints: q in ±π or ±0.5 m, quaternions of length 1, q̇ in ±2, q̈
    in ±5, τ in ±20."""
    rng = np.random.default_rng(len(translations))
    reach = np.where(translations, 0.5, np.pi)

    def configuration():
        q = rng.uniform(-reach, reach)
        for first in quaternions:
            q[first : first + 4] /= np.linalg.norm(q[first : first + 4])
        return list(q)

    return [
        {
            "q": configuration(),
            "qd": list(rng.uniform(-2, 2, velocities)),
            "qdd": list(rng.uniform(-5, 5, velocities)),
            "tau": list(rng.uniform(-20, 20, velocities)),
        }
        for _ in range(STATES)
    ]
