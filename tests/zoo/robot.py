"""One description, from the file to a verdict.

In: a file. Out: whether both read it, and how far every function is from the peer's, with right angles
and zeros taken for what they are and as written. It never lets one file's failure end the run.
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

NOT_MODELLED = re.compile(r"mimic joints are not modelled|is (floating|planar|spherical), and such joints are not modelled")
NOTHING_MOVES = re.compile(r"no joint of .* moves")


@dataclass
class Verdict:
    """What became of a file."""

    name: str
    # "read", "read but for what is not modelled", "nothing moves", "refused", "refused by both"
    outcome: str = "read"
    # Why not, or what was left out.
    reason: str = ""
    joints: int = 0
    warnings: int = 0
    # The largest error of each function, with right angles taken for what they are and as written.
    errors: dict = field(default_factory=lambda: {False: {}, True: {}})
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
    try:
        program.run("check", file)
    except Refused as refused:
        if not all(NOT_MODELLED.search(mistake) for mistake in refused.mistakes):
            refuse(file, refused, verdict)
            return
        verdict.outcome = "read but for what is not modelled"
        verdict.reason = kinds(refused.mistakes)
        changed = folder / "reduced.urdf"
        changed.write_text(urdf.reduced(urdf.read(file)), "utf-8")
        file = changed
        try:
            program.run("check", file)
        except Refused as refused:
            refuse(file, refused, verdict)
            return
    for exact in (False, True):
        measure(program, file, folder, exact, verdict)


def refuse(file, refused, verdict):
    """A refusal is a failure where the peer reads the file."""
    if any(NOTHING_MOVES.search(mistake) for mistake in refused.mistakes):
        verdict.outcome = "nothing moves"
        return
    verdict.outcome, verdict.reason = "refused by both", str(refused)
    try:
        peer = Peer(file)
        if not peer.is_sure:
            return
    except Unreadable:
        return
    if peer.model.nv == 0:
        verdict.outcome = "nothing moves"
        return
    verdict.outcome = "refused"
    verdict.failures.append(f"refused: {refused}")


def kinds(mistakes):
    """How many joints there are of each kind that is not modelled."""
    words = [(NOT_MODELLED.search(mistake).group(1) or "mimic") for mistake in mistakes]
    return ", ".join(f"{words.count(word)} {word}" for word in sorted(set(words)))


def measure(program, file, folder, exact, verdict):
    """Compares every function."""
    how = "as written" if exact else "with right angles"
    found = program.check(file, exact)
    verdict.joints, verdict.warnings = len(found["joints"]), len(found["warnings"])
    same = folder / "same.urdf"
    same.write_text(urdf.with_right_angles(urdf.read(file), found["snapped"]), "utf-8")
    try:
        peer = Peer(same)
    except Unreadable:
        verdict.reason = "; ".join(filter(None, [verdict.reason, "not read by Pinocchio"]))
        return
    peer.order(found["joints"])
    states = random_states(peer.slides())
    listed = folder / "states.json"
    listed.write_text(json.dumps({"states": states}))

    theirs = [{**peer.dynamics(state), "tau": np.array(state["tau"])} for state in states]
    for function in DYNAMICS:
        try:
            ours = program.eval(file, exact, function, listed)
        except Refused as refused:
            if function in SOLVED:
                verdict.least = peer.least_conditioned() if verdict.least is None else verdict.least
            if function not in SOLVED or verdict.least > SINGULAR:
                verdict.failures.append(f"{function} {how}: {refused}")
            continue
        record(verdict, exact, function, compare.dynamics(function, ours, theirs), "")
    for end, link in enumerate(peer.leaves()[:ENDS]):
        theirs = [peer.kinematics(state, link) for state in states]
        for function in KINEMATICS if end == 0 else KINEMATICS[:1]:
            try:
                ours = program.eval(file, exact, function, listed, link)
            except Refused as refused:
                verdict.failures.append(f"{function} of {link} {how}: {refused}")
                continue
            record(verdict, exact, function, compare.kinematics(function, ours, theirs), f" of {link}")


def record(verdict, exact, function, error, whose):
    errors = verdict.errors[exact]
    errors[function] = max(error, errors.get(function, 0.0))
    if not error <= LIMIT:
        how = "as written" if exact else "with right angles"
        verdict.failures.append(f"{function}{whose} differs by {error:.1e} {how}")


def random_states(slides):
    """The same for every robot with as many joints: q in ±π or ±0.5 m, q̇ in ±2, q̈ in ±5, τ in ±20."""
    rng = np.random.default_rng(len(slides))
    reach = np.where(slides, 0.5, np.pi)
    return [
        {
            "q": list(rng.uniform(-reach, reach)),
            "qd": list(rng.uniform(-2, 2, len(slides))),
            "qdd": list(rng.uniform(-5, 5, len(slides))),
            "tau": list(rng.uniform(-20, 20, len(slides))),
        }
        for _ in range(STATES)
    ]
