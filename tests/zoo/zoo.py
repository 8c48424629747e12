"""All descriptions of some packages, and the report about them.

In: the binary, a folder with a folder a package. Out: lines as it goes, report/ZOO.md, and an exit
status that is not 0 where anything must not be as it is. The order of files is that of their names.
"""

import argparse
import hashlib
import sys
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

import report
from program import Program
from robot import DYNAMICS, ENDS, KINEMATICS, LIMIT, STATES, judge

# A thousand bricks and bolts, each of one link.
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
        arguments.report.write_text(report.document(verdicts, STATES, ENDS, functions, LIMIT))
    sys.exit(any(verdict.failures for verdict in verdicts))


def distinct(robots, only):
    """Every file once, however many packages carry it."""
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
