"""Text of the section of MJCF in the report.

In: outcomes. Out: text. It never judges a result.
"""

import os
from collections import Counter
from importlib.metadata import version
from itertools import groupby
from pathlib import Path

from report import machine
from section import table

HEAD = """\
What `homogen check` and `homogen eval` make of every MJCF file of four packages, beside MuJoCo {mujoco} (written by
`tests/zoo/mjcf.sh`, on {machine}). Each of the {functions} functions is evaluated at {states} random states as written
(`--exact`), inverse and forward dynamics, gravity, bias and mass matrix also with `--rotors`, and compared with MuJoCo's
compiled model without contacts and constraints. Poses are compared for the first and last bodies and sites, and keyframes
with names as configurations. Errors are relative, as for URDF; more than {limit:.0e} is a failure, and more than {sums:.0e}
of random files that add up geoms, whose principal axes MuJoCo computes to that.

{summary}
"""


def text(verdicts, states, functions, limit, sums):
    """The section: one line for each file, by package, and one for all random files."""
    random = [verdict for verdict in verdicts if verdict.name.startswith("random")]
    files = [verdict for verdict in verdicts if not verdict.name.startswith("random")]
    head = HEAD.format(
        mujoco=version("mujoco"),
        machine=machine(),
        functions=functions,
        states=states,
        limit=limit,
        sums=sums,
        summary="\n".join(f"- {summary(group, name)}" for group, name in [(files, "files"), (random, "random files")]),
    )
    for package, group in groupby(files, key=lambda verdict: Path(verdict.name).parts[0]):
        group = list(group)
        folder = os.path.commonpath([str(Path(verdict.name).parent) for verdict in group])
        head += f"\n### {package.replace('==', ' ')}\n"
        for outcomes, columns, row in [
            (["read"], ["file", "joints", "mimic", "loops", "warnings", "worst error"], numbers),
            (["without its meshes", "not read by MuJoCo", "refused", "refused by both"], ["file", "outcome", "why"], reasons),
        ]:
            rows = [[f"`{Path(v.name).relative_to(folder)}`", *row(v)] for v in group if v.outcome in outcomes]
            if rows:
                head += "\n" + table(columns, rows)
        still = sum(verdict.outcome == "nothing moves" for verdict in group)
        if still:
            head += f"\nNothing moves in {still} of them.\n"
    return head


def numbers(verdict):
    failed = f"; {'; '.join(verdict.failures)}" if verdict.failures else ""
    return [verdict.joints, verdict.mimics or "", verdict.loops or "", len(verdict.warnings) or "", f"{verdict.worst:.0e}{failed}"]


def reasons(verdict):
    return [verdict.outcome, verdict.reason.removeprefix("not read by MuJoCo: ")]


def summary(verdicts, what):
    counted = Counter(verdict.outcome for verdict in verdicts)
    outcomes = ", ".join(f"{count} {outcome}" for outcome, count in sorted(counted.items()))
    worst = max((verdict.worst for verdict in verdicts), default=0.0)
    failed = sum(bool(verdict.failures) for verdict in verdicts)
    return f"{len(verdicts)} {what}: {outcomes}; worst error {worst:.0e}; {failed} with failures."
