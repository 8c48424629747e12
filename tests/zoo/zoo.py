"""Compares all descriptions of some packages with Pinocchio, and writes the report.

In: the binary, and a folder with one folder for each package. Out: a line for each file, its section of report/ZOO.md, and a nonzero
exit status if a check fails. Files are in the order of their names.
"""

import argparse
import hashlib
import sys
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

import report
import section
from program import Program
from robot import DYNAMICS, ENDS, KINEMATICS, LIMIT, STATES, judge

# A thousand bricks and bolts, each with one link: skipped.
UNINTERESTING = "random_urdfs"


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("binary", type=Path)
    arguments.add_argument("robots", type=Path)
    arguments.add_argument("--report", type=Path)
    arguments.add_argument("--only", default="")
    arguments = arguments.parse_args()

    files = distinct(arguments.robots, arguments.only)
    names = [str(file.relative_to(arguments.robots)) for file in files]
    program = Program(arguments.binary)
    verdicts = []
    with ProcessPoolExecutor(2) as pool:
        for verdict in pool.map(judge, [program] * len(files), files, names):
            verdicts.append(verdict)
            print(report.line(verdict), flush=True)
            for failure in verdict.failures:
                print(f"    {failure}", flush=True)
    print(report.summary(verdicts))
    if arguments.report:
        functions = len(DYNAMICS + KINEMATICS)
        text = report.document(verdicts, STATES, ENDS, functions, LIMIT)
        section.write(arguments.report, "URDF", text)
    sys.exit(any(verdict.failures for verdict in verdicts))


def distinct(robots, only):
    """Each distinct file once, even if several packages contain it."""
    seen, files = set(), []
    for file in sorted(robots.rglob("*")):
        if file.suffix.lower() != ".urdf" or UNINTERESTING in file.parts or only not in str(file):
            continue
        print_of_file = hashlib.sha256(file.read_bytes()).digest()
        if print_of_file not in seen:
            seen.add(print_of_file)
            files.append(file)
    return files


if __name__ == "__main__":
    main()
