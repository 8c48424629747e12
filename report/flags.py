#!/usr/bin/env python3
"""Times and bits of every function of the robots that ship, without flags and compiled for this processor.

    report/flags.py [ROUNDS]

Compiles `report/flags` in three ways and runs the programs in turns, ROUNDS times (3):

- `target`: for the baseline of the architecture alone, without a choice at run time (no feature `std`),
- `chosen`: the same with the choice, as a crate without flags is compiled,
- `native`: with `-C target-cpu=native`.

Prints the least time of each in nanoseconds a call. Fails if a result of `chosen` differs from `native` in a bit, or if
one of a `reproducible` robot differs between any two, or from `target` without the key. Needs cargo.
"""

import os
import subprocess
import sys

from command import ROOT, said

WAYS = {
    "target": (["--no-default-features", "--features", "libm"], ""),
    "chosen": ([], ""),
    "native": ([], "-C target-cpu=native"),
}
REPRODUCIBLE = "_reproducible"


def main():
    rounds = int(sys.argv[1]) if len(sys.argv) > 1 else 3
    programs = {way: compiled(way, *options) for way, options in WAYS.items()}
    times, bits = {}, {}
    for _ in range(rounds):
        for way, program in programs.items():
            for line in said(program).splitlines():
                robot, function, time, digest = line.split()
                row = times.setdefault((robot, function), {})
                row[way] = min(float(time), row.get(way, float("inf")))
                bits[robot, function, way] = digest
    print(f"{'':<54} {'target':>8} {'chosen':>8} {'native':>8} {'chosen/native':>14}")
    for (robot, function), row in times.items():
        of = " ".join(f"{row[way]:8.1f}" for way in WAYS)
        print(f"{robot + ' ' + function:<54} {of} {row['chosen'] / row['native']:14.2f}")
    slow = [row["chosen"] / row["native"] for row in times.values() if row["native"] > 40]
    print(f"\nLargest ratio of functions above 40 ns: {max(slow):.2f}")
    sys.exit(differences(times, bits))


def differences(rows, bits):
    """The functions whose bits differ where they must not, as a message; none if there are none."""
    found = []
    for robot, function in rows:
        of = [bits[robot, function, way] for way in WAYS]
        if robot.endswith(REPRODUCIBLE):
            of.append(bits[robot.removesuffix(REPRODUCIBLE), function, "target"])
            same = len(set(of)) == 1
        else:
            same = of[1] == of[2]
        if not same:
            found.append(f"{robot} {function}: {' '.join(of)}")
    return "\n".join(["bits differ:", *found]) if found else None


def compiled(way, options, flags):
    """The program, compiled in one way."""
    folder = ROOT / "report/flags"
    target = ROOT / "target/flags" / way
    environment = {**os.environ, "RUSTFLAGS": flags, "CARGO_TARGET_DIR": str(target)}
    command = ["cargo", "build", "--quiet", "--release", "--manifest-path", folder / "Cargo.toml", *options]
    subprocess.run(command, check=True, env=environment)
    return target / "release/flags"


if __name__ == "__main__":
    main()
