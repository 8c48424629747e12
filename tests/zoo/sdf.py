"""Compares random SDF files with Drake.

In: the binary, and a count. Out: a line for each file that differs, its section of report/ZOO.md, and a nonzero exit
status if there is one.
"""

import argparse
import json
import shutil
import sys
import tempfile
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path

import compare
import numpy as np
import random_sdf
import report
import section
from drake_peer import DrakePeer, Unreadable
from program import Failed, Program, Refused

# Largest error due to rounding.
LIMIT = 1e-11
STATES = 8
POSES = 6
DYNAMICS = ["inverse_dynamics", "gravity", "bias", "mass_matrix"]


@dataclass(frozen=True)
class How:
    """A set of options to read a file with."""

    options: tuple


EXACT = How(("--exact",))

SECTION = """\
Random SDF files, with models in models, frames, joints of each type, axes in any frame and mimic joints, beside Drake
{drake} (written by `tests/zoo/sdf.sh`, on {machine}). {functions} are evaluated at {states} random states, and the poses
of up to {poses} frames. Errors are relative, as for URDF; more than {limit:.0e} is a failure.

{summary}
"""


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("binary", type=Path)
    arguments.add_argument("--random", type=int, default=500)
    arguments.add_argument("--seed", type=int, default=0)
    arguments.add_argument("--keep", type=Path, help="a folder for files that failed")
    arguments.add_argument("--report", type=Path)
    arguments = arguments.parse_args()
    program = Program(arguments.binary.resolve())
    seeds = range(arguments.seed, arguments.seed + arguments.random)
    outcomes, worst, failed = {}, 0.0, 0
    with tempfile.TemporaryDirectory() as folder, ProcessPoolExecutor(2) as pool:
        files = [random_sdf.write(Path(folder) / str(seed), seed) for seed in seeds]
        for seed, file, (outcome, error, failures) in zip(seeds, files, pool.map(judge, [program] * len(files), files)):
            outcomes[outcome] = outcomes.get(outcome, 0) + 1
            worst = max(worst, error)
            for failure in failures:
                print(f"random {seed}: {failure}", flush=True)
            failed += bool(failures)
            if failures and arguments.keep:
                shutil.copytree(file.parent, arguments.keep / str(seed), dirs_exist_ok=True)
    counted = ", ".join(f"{count} {outcome}" for outcome, count in sorted(outcomes.items()))
    summary = f"{len(seeds)} random files: {counted}; worst error {worst:.0e}; {failed} with failures."
    print(summary)
    if arguments.report:
        text = SECTION.format(
            drake=version("drake"),
            machine=report.machine(),
            functions=", ".join(DYNAMICS).replace("_", " ").capitalize(),
            states=STATES,
            poses=POSES,
            limit=LIMIT,
            summary=summary,
        )
        section.write(arguments.report, "SDF", text)
    sys.exit(failed > 0)


def judge(program, file):
    """Outcome, largest error and failures of a file; never raises."""
    try:
        return examine(program, file)
    except Failed as failed:
        return "failed", 0.0, [str(failed)]
    except Exception as reason:
        return "failed", 0.0, [f"not compared: {type(reason).__name__}: {reason}"]


def examine(program, file):
    try:
        peer = DrakePeer(file)
    except Unreadable as reason:
        return "not read by Drake", 0.0, [f"not read by Drake: {reason}"]
    if peer.size() == 0:
        return "nothing moves", 0.0, []
    try:
        found = program.check(file, EXACT)
    except Refused as refused:
        return "refused", 0.0, [f"refused: {refused}"]
    peer.order(found["coordinates"])
    if len(found["coordinates"]) != peer.size():
        return "failed", 0.0, [f"other joints: {found['joints']}"]
    states = random_states(peer.translations())
    failures, worst = [], 0.0

    def record(what, error):
        nonlocal worst
        worst = max(worst, error)
        if not error <= LIMIT:
            failures.append(f"{what} differs by {error:.1e}")

    state_file = file.parent / "states.json"
    state_file.write_text(json.dumps({"states": states}))
    theirs = [peer.dynamics(state) for state in states]
    for function in DYNAMICS:
        record(function, compare.dynamics(function, program.eval(file, EXACT, function, state_file), theirs))
    frames = peer.frames()
    for name in sorted(frames)[:POSES]:
        theirs = [{"forward_kinematics": peer.pose(state, frames[name])} for state in states]
        try:
            ours = program.eval(file, EXACT, "forward_kinematics", state_file, name)
        except Refused as refused:
            if "moves" not in str(refused):
                failures.append(f"pose of {name}: {refused}")
            continue
        record(f"pose of {name}", compare.kinematics("forward_kinematics", ours, theirs))
    return "read", worst, failures


def random_states(translations):
    """Random states: q in ±π or ±0.5 m, q̇ in ±2, q̈ in ±5."""
    rng = np.random.default_rng(len(translations))
    reach = np.where(translations, 0.5, np.pi)
    count = len(translations)
    return [
        {
            "q": list(rng.uniform(-reach, reach)),
            "qd": list(rng.uniform(-2, 2, count)),
            "qdd": list(rng.uniform(-5, 5, count)),
        }
        for _ in range(STATES)
    ]


if __name__ == "__main__":
    main()
