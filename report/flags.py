#!/usr/bin/env python3
"""Times and bits of every function of the robots that ship, without flags and compiled for this processor.

    report/flags.py [ROUNDS] > report/FLAGS.md

Compiles `report/flags` in several ways and runs the programs in turns, ROUNDS times (3):

- `target`: for the baseline of the architecture, without a choice at run time (no feature `std`),
- `chosen`: without flags, instructions are chosen at run time, as in `cargo build --release` of a user,
- `native`: with `-C target-cpu=native`,
- `narrow`: the same without AVX-512, on x86. What is chosen at run time has AVX2 and FMA, and 16 registers; a native
  build may have 32.

Prints the least time of each in nanoseconds a call, as Markdown. Fails if a result of `chosen` differs from `native` in
a bit, or if a result of a `reproducible` robot differs between any two, or from `target` without the key. Needs cargo.
"""

import os
import platform
import statistics
import subprocess
import sys

from command import ROOT, origin, said

WAYS = {
    "target": (["--no-default-features", "--features", "libm"], ""),
    "chosen": ([], ""),
    "native": ([], "-C target-cpu=native"),
}
if platform.machine() in ("x86_64", "AMD64"):
    WAYS["narrow"] = ([], "-C target-cpu=native -C target-feature=-avx512f")
REPRODUCIBLE = "_reproducible"
# The largest accepted ratio chosen/native, of functions that take more nanoseconds than LONG.
BAR, LONG = 1.15, 40


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
    print(written(times, rounds))
    sys.exit(differences(times, bits))


def written(times, rounds):
    """The times as Markdown."""
    others = [way for way in ("native", "narrow") if way in WAYS]
    lines = [
        "# Every function without flags",
        "",
        f"Measured by `report/flags.py {rounds}` on {origin()}.",
        "",
        "`f64`, one thread, ns a call, least of all rounds and of four places on the stack. `target`: baseline of the",
        "architecture, no choice at run time; `chosen`: without flags, instructions are chosen at run time; `native`:",
        "`-C target-cpu=native`; `narrow`: the same without AVX-512, on x86: the instructions that are chosen.",
        "",
        *(compared(times, other) for other in others),
        "",
        "| robot | function | " + " | ".join(WAYS) + "".join(f" | chosen / {other}" for other in others) + " |",
        "|---|---|" + "---:|" * (len(WAYS) + len(others)),
    ]
    for (robot, function), row in times.items():
        of = [f"{row[way]:.1f}" for way in WAYS] + [f"{row['chosen'] / row[other]:.2f}" for other in others]
        lines.append(f"| {robot} | `{function}` | " + " | ".join(of) + " |")
    return "\n".join(lines)


def compared(times, other):
    """A line on the ratios of what is chosen to another way."""
    ratios = [row["chosen"] / row[other] for row in times.values() if row[other] > LONG]
    slow = sum(ratio > BAR for ratio in ratios)
    met = f"exceeded by {slow}" if slow else "met by all"
    middle = statistics.median(ratios)
    return (
        f"- Chosen / {other}: {middle:.2f} in the median and at most {max(ratios):.2f} among the {len(ratios)}"
        f" functions above {LONG} ns; the bar is {BAR}, {met}."
    )


def differences(rows, bits):
    """A message with the functions whose bits differ where they must not; `None` if there are none."""
    found = []
    for robot, function in rows:
        of = [bits[robot, function, way] for way in WAYS]
        if robot.endswith(REPRODUCIBLE):
            of.append(bits[robot.removesuffix(REPRODUCIBLE), function, "target"])
            same = len(set(of)) == 1
        else:
            same = len(set(of[1:])) == 1
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
