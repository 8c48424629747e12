"""Compares all MJCF files of some packages, and random ones, with MuJoCo.

In: the binary, and a folder with MJCF files or a count of random ones. Out: a line for each file, its section of
report/ZOO.md, and a nonzero exit status if a number differs or homogen rejects a file that MuJoCo reads. Files are in
the order of their names.
"""

import argparse
import hashlib
import json
import os
import shutil
import sys
import tempfile
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path

import compare
import mjcf_report
import numpy as np
import random_mjcf
import section
from mujoco_peer import MujocoPeer, Unreadable
from program import Failed, Program, Refused

# Largest error due to rounding, and due to principal axes as MuJoCo computes them.
LIMIT = 1e-11
LIMIT_OF_SUMS = 1e-6
STATES = 8
ENDS = 4
DYNAMICS = ["inverse_dynamics", "gravity", "bias", "mass_matrix", "forward_dynamics"]
KINEMATICS = ["forward_kinematics", "geometric_jacobian"]


@dataclass(frozen=True)
class How:
    """A set of options to read a file with."""

    words: str
    options: tuple
    rotors: bool


WAYS = [How("without rotors", ("--exact",), False), How("with rotors", ("--exact", "--rotors"), True)]


@dataclass
class Verdict:
    """Outcome for a file."""

    name: str
    outcome: str = "read"
    reason: str = ""
    joints: int = 0
    mimics: int = 0
    loops: int = 0
    warnings: list = field(default_factory=list)
    worst: float = 0.0
    limit: float = LIMIT
    failures: list = field(default_factory=list)


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("binary", type=Path)
    arguments.add_argument("robots", type=Path, nargs="?")
    arguments.add_argument("--only", default="")
    arguments.add_argument("--random", type=int, default=0)
    arguments.add_argument("--seed", type=int, default=0)
    arguments.add_argument("--keep", type=Path, help="a folder for random files that failed")
    arguments.add_argument("--report", type=Path)
    arguments = arguments.parse_args()
    arguments.report = arguments.report and arguments.report.resolve()
    program = Program(arguments.binary.resolve())
    arguments.robots = arguments.robots and arguments.robots.resolve()
    arguments.keep = arguments.keep and arguments.keep.resolve()
    with tempfile.TemporaryDirectory() as folder:
        # MuJoCo writes its warnings to a file in the working directory.
        os.chdir(folder)
        files, names = [], []
        if arguments.robots:
            files = distinct(arguments.robots, arguments.only)
            names = [str(file.relative_to(arguments.robots)) for file in files]
        for seed in range(arguments.seed, arguments.seed + arguments.random):
            files.append(random_mjcf.write(Path(folder) / str(seed), seed))
            names.append(f"random {seed}")
        verdicts = []
        with ProcessPoolExecutor(2) as pool:
            for file, verdict in zip(files, pool.map(judge, [program] * len(files), files, names)):
                verdicts.append(verdict)
                print(f"{verdict.name}: {verdict.outcome}: {verdict.joints} joints, worst {verdict.worst:.1e} {verdict.reason}", flush=True)
                for failure in verdict.failures:
                    print(f"    {failure}", flush=True)
                if verdict.failures and arguments.keep and verdict.name.startswith("random"):
                    shutil.copytree(file.parent, arguments.keep / verdict.name.replace(" ", "_"), dirs_exist_ok=True)
    failed = sum(bool(verdict.failures) for verdict in verdicts)
    outcomes = {outcome: sum(verdict.outcome == outcome for verdict in verdicts) for outcome in sorted({v.outcome for v in verdicts})}
    worst = max((verdict.worst for verdict in verdicts), default=0.0)
    print(f"{len(verdicts)} files, {failed} with failures, {outcomes}, worst {worst:.1e}")
    if arguments.report:
        functions = len(DYNAMICS + KINEMATICS)
        section.write(arguments.report, "MJCF", mjcf_report.text(verdicts, STATES, functions, LIMIT, LIMIT_OF_SUMS))
    sys.exit(failed > 0)


def distinct(robots, only):
    """Each distinct file once, even if several packages contain it."""
    seen, files = set(), []
    for file in sorted(robots.rglob("*.xml")):
        if only not in str(file) or b"<mujoco" not in file.read_bytes():
            continue
        print_of_file = hashlib.sha256(file.read_bytes()).digest()
        if print_of_file not in seen or "scene" in file.name:
            seen.add(print_of_file)
            files.append(file)
    return files


def judge(program, file, name):
    """Compares a file; never raises."""
    verdict = Verdict(name)
    if name.startswith("random") and random_mjcf.sums(int(name.split()[1])):
        verdict.limit = LIMIT_OF_SUMS
    try:
        for how in WAYS:
            examine(program, file, how, verdict)
    except Failed as failed:
        verdict.failures.append(str(failed))
    except Exception as reason:
        verdict.failures.append(f"not compared: {type(reason).__name__}: {reason}")
    # The report is the same wherever the files are.
    verdict.reason = verdict.reason.replace(f"{file.parent}/", "")
    return verdict


def examine(program, file, how, verdict):
    try:
        peer = MujocoPeer(file)
    except Unreadable as reason:
        peer = None
        verdict.reason = f"not read by MuJoCo: {reason}"
    if peer and peer.model.nv == 0:
        verdict.outcome = "nothing moves"
        return
    try:
        found = program.check(file, how)
    except Refused as refused:
        verdict.outcome = "refused by both" if peer is None else "refused"
        if peer and peer.missing and "there is no such file" in str(refused):
            # MuJoCo used a substitute mesh.
            verdict.outcome, verdict.reason = "without its meshes", str(refused)
        elif peer:
            verdict.failures.append(f"refused {how.words}: {refused}")
        return
    if peer is None:
        verdict.outcome = "not read by MuJoCo"
        return
    verdict.joints, verdict.mimics = len(found["joints"]), len(found["mimicked"])
    verdict.loops = len(found.get("loops", []))
    verdict.warnings = [warning["message"] for warning in found["warnings"]]
    if any("armature or friction of a free joint" in warning for warning in verdict.warnings):
        peer.without_free_armatures()
    peer.order({mimicked["joint"] for mimicked in found["mimicked"]})
    if peer.nq != len(found["coordinates"]):
        verdict.failures.append(f"different joints: {found['joints']}")
        return
    if not how.rotors:
        record(verdict, how, "configurations", compare.configurations(found.get("configurations", {}), peer.configurations(), peer.quaternions()), "")
    states = random_states(peer.translations(), peer.quaternions(), len(found["velocities"]))
    with tempfile.TemporaryDirectory() as folder:
        state_file = Path(folder) / "states.json"
        state_file.write_text(json.dumps({"states": states}))
        theirs = [peer.dynamics(state, how.rotors) for state in states]
        for function in DYNAMICS:
            try:
                ours = program.eval(file, how, function, state_file)
            except Refused as refused:
                if function != "forward_dynamics" or least(theirs) > 1e-9:
                    verdict.failures.append(f"{function} {how.words}: {refused}")
                continue
            record(verdict, how, function, compare.dynamics(function, ours, theirs), "")
        if how.rotors:
            return
        bodies = peer.bodies()
        picked = bodies[:ENDS] + bodies[-ENDS:] if len(bodies) > 2 * ENDS else bodies
        for number, (kind, name) in enumerate(picked):
            theirs = [peer.kinematics(state, kind, name) for state in states]
            link = name if kind == "body" or name in found["links"] and f"{name}_site" not in found["links"] else f"{name}_site"
            for function in KINEMATICS if number in (0, len(picked) - 1) else KINEMATICS[:1]:
                try:
                    ours = program.eval(file, how, function, state_file, link)
                except Refused as refused:
                    if "moves" not in str(refused):
                        verdict.failures.append(f"{function} of {link} {how.words}: {refused}")
                    continue
                record(verdict, how, function, compare.kinematics(function, ours, theirs), f" of {link}")


def least(theirs):
    """Smallest relative eigenvalue of the scaled mass matrix over all states."""
    values = []
    for state in theirs:
        mass = state["mass_matrix"]
        root = np.sqrt(np.maximum(np.diag(mass), 0.0))
        if np.any(root == 0.0):
            return 0.0
        eigenvalues = np.linalg.eigvalsh(mass / np.outer(root, root))
        values.append(eigenvalues[0] / eigenvalues[-1])
    return min(values)


def record(verdict, how, function, error, whose):
    verdict.worst = max(verdict.worst, error)
    if not error <= verdict.limit:
        verdict.failures.append(f"{function}{whose} differs by {error:.1e} {how.words}")


def random_states(translations, quaternions, velocities):
    """Random states, the same for every robot with as many joints: q in ±π or ±0.5 m, quaternions of length 1, q̇ in ±2, q̈ in ±5,
    τ in ±20."""
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


if __name__ == "__main__":
    main()
