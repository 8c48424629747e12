"""Text and tables of the report.

In: outcomes. Out: text. It never judges a result.
"""

import os
import platform
from collections import Counter
from importlib.metadata import version
from itertools import groupby
from pathlib import Path

HEAD = """\
What `homogen check` and `homogen eval` make of robot descriptions as vendors and simulators ship them,
untouched, beside Pinocchio {pinocchio} (written by `tests/zoo/run.sh`, on {machine}).

Every file of the packages below is read by both. Of a link that Pinocchio cannot read it complains, and
goes on with zeros: that counts as refused. Each of the {functions} functions is evaluated at {states} random
states, in f64, once with right angles and zeros taken for what they are, once as written (`--exact`) and
once so with a floating base (`--floating`), and compared with Pinocchio; for the first, Pinocchio is given the
same file with those numbers in full. Of a joint that mimics another, Pinocchio's full model is projected. Poses are compared at up to {ends} ends of a tree. An error is relative: of a
torque, in units of the largest of its joint at these states (and of a thousandth of the largest of all);
of M, of √(Mᵢᵢ Mⱼⱼ); of poses, Jacobians, velocities and accelerations, of the largest entry of the block
that turns and of the one that slides; of what was solved for, what it leaves of the equation, in units
of what that is summed of. More than {limit:.0e} is a failure.

{summary}
"""

ROBOTS = """
| file | joints | besides | functions | worst error | as written | with a floating base |
| --- | --- | --- | --- | --- | --- | --- |
"""

REFUSED = """
Refused:

| file | by | why |
| --- | --- | --- |
"""


def line(verdict):
    """One line for a file."""
    if any(verdict.errors.values()):
        reason = f" ({verdict.reason})" if verdict.reason else ""
        return f"{verdict.name}: {verdict.joints} joints{reason}: {', '.join(errors(verdict))}"
    return f"{verdict.name}: {verdict.outcome}: {verdict.reason}"


def errors(verdict):
    """Largest error of a file, for each set of options."""
    worst = [max(errors.values(), default=None) for errors in verdict.errors.values()]
    return ["not compared" if error is None else f"{error:.0e}" for error in worst]


def summary(verdicts):
    """Summary of all files in two sentences."""
    counted = Counter(verdict.outcome for verdict in verdicts)
    compared = [verdict for verdict in verdicts if any(verdict.errors.values())]
    worst = max((max(v.errors[k].values()) for v in compared for k in v.errors if v.errors[k]), default=0.0)
    failed = sum(bool(verdict.failures) for verdict in verdicts)
    words = ", ".join(f"{count} {outcome}" for outcome, count in sorted(counted.items()))
    values = sum(len(errors) for verdict in verdicts for errors in verdict.errors.values())
    return (
        f"{len(verdicts)} files: {words}. {len(compared)} compared, {values} comparisons, worst error {worst:.0e}; "
        f"{failed} with failures."
    )


def document(verdicts, states, ends, functions, limit):
    """The report: one line for each file, by package."""
    text = HEAD.format(
        pinocchio=version("pin"),
        machine=machine(),
        functions=functions,
        states=states,
        ends=ends,
        limit=limit,
        summary=summary(verdicts),
    )
    for package, verdicts in groupby(verdicts, key=lambda verdict: Path(verdict.name).parts[0]):
        verdicts = list(verdicts)
        folder = os.path.commonpath([str(Path(verdict.name).parent) for verdict in verdicts])
        text += f"\n### {package.replace('==', ' ')}\n"
        read = [verdict for verdict in verdicts if any(verdict.errors.values()) or verdict.joints]
        if read:
            text += ROBOTS + "".join(row(verdict, folder, functions) for verdict in read)
        refused = [verdict for verdict in verdicts if "refused" in verdict.outcome]
        if refused:
            text += REFUSED + "".join(refusal(verdict, folder) for verdict in refused)
        still = sum(verdict.outcome == "nothing moves" for verdict in verdicts)
        if still:
            text += f"\nNothing moves in {still} of them but a floating base.\n"
    return text


def row(verdict, folder, functions):
    compared = max(map(len, verdict.errors.values()))
    count = f"{compared}" if compared == functions else f"{compared} of {functions}"
    if verdict.least is not None:
        count += f" (M singular to {verdict.least:.0e})"
    failed = f"; {'; '.join(verdict.failures)}" if verdict.failures else ""
    return cells(short(verdict, folder), verdict.joints, verdict.reason, count + failed, *errors(verdict))


def refusal(verdict, folder):
    by = "homogen alone" if verdict.failures else "both"
    first, *others = verdict.reason.split("; ")
    more = f"; and {len(others)} more" if others else ""
    return cells(short(verdict, folder), by, first.partition(": ")[2] + more)


def short(verdict, folder):
    return f"`{Path(verdict.name).relative_to(folder)}`"


def cells(*entries):
    return "| " + " | ".join(str(entry).replace("|", "\\|") for entry in entries) + " |\n"


def machine():
    names = Path("/proc/cpuinfo").read_text() if Path("/proc/cpuinfo").exists() else ""
    name = next((line.split(":")[1].strip() for line in names.splitlines() if line.startswith("model name")), "")
    return f"{name or platform.machine()}, {platform.system()}, Python {platform.python_version()}"
