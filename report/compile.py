#!/usr/bin/env python3
"""Compile times and memory of generated code: first build, check, release build, package, batch, C.

    report/compile.py [PEERS] > report/COMPILE.md      [HOMOGEN=PATH: the command line, if it is built]

PEERS is the folder of `report/peer/setup.sh`, with the Panda, the quadruped Solo 12 and the humanoid G1 as their vendors
describe them; without it, the arm and the quadruped that ship are measured.

Each crate is made in a temporary folder and depends on the runtime of this repository. Its dependencies are downloaded
first, and except for the first build they are compiled first. Prints a table as Markdown: wall seconds, and the peak
memory of the largest process (`ru_maxrss` of cargo and all that it runs). Needs cargo and gcc.

| cost | measured |
|---|---|
| first build | `cargo build` in an empty target folder: runtime, engine and a derive of inverse dynamics |
| check | `cargo check` after a change of `main.rs`, a derive of all functions; median of three changes |
| release | `cargo build --release` of a derive of ten functions, each called |
| again | the same after a change elsewhere in `main.rs`: what was expanded is kept |
| again, no SLP | the same with `-C no-vectorize-slp`, without LLVM's vectorizer of straight-line code |
| batch | `cargo build --release` of five functions with `batch` |
| package | `cargo build --release` of the Python package of these five functions |
| C, generated | `homogen generate --language c` of all functions, by a development build of the command line; size of the file |
| C, compiled | `gcc -O2 -c` of it |
"""

import os
import pathlib
import shutil
import statistics
import subprocess
import sys
import tempfile
import time

from command import ROOT, homogen, origin, said
from limits import FUNCTIONS as TEN

FIVE = ["forward_kinematics", "geometric_jacobian", "inverse_dynamics", "mass_matrix", "forward_dynamics"]
# Number of arguments, if not one.
ARGUMENTS = {
    "inverse_dynamics": 3,
    "forward_dynamics": 3,
    "inverse_dynamics_derivatives": 3,
    "forward_dynamics_derivatives": 3,
    "coriolis_matrix": 2,
}
# Title, file, end effector, floating: without PEERS.
SHIPPED = [
    ("Panda class", ROOT / "robots/panda_class.urdf", "link8", False),
    ("Quadruped", ROOT / "robots/quadruped.urdf", "fl_foot", True),
]
PEERS = ["panda", "solo12", "g1"]
ARM, HUMANOID = 0, 2
# Cost, index of the robot: largest accepted number of seconds, of MB.
BARS = {
    ("check", ARM): (0.5, None),
    ("release", HUMANOID): (15, 1000),
    ("C, generated", HUMANOID): (None, 5.1),
    ("C, compiled", HUMANOID): (56, None),
}
NO_SLP = ["cargo", "rustc", "--quiet", "--release", "--", "-C", "no-vectorize-slp"]
# The user's choice of flags and profiles is not measured.
ENVIRONMENT = {
    name: value
    for name, value in os.environ.items()
    if name not in ("RUSTFLAGS", "CARGO_ENCODED_RUSTFLAGS", "CARGO_INCREMENTAL") and not name.startswith("CARGO_PROFILE_")
}

MANIFEST = """\
[package]
name = "compiled"
version = "0.1.0"
edition = "2024"

[workspace]

[dependencies]
homogen = {{ path = "{runtime}", features = ["batch"] }}
"""
MAIN = """\
use std::hint::black_box;

#[derive(homogen::Robot)]
#[robot(urdf = "{urdf}", tip = "{tip}", quiet, generate({functions}){keys})]
struct Robot;

fn numbers<const N: usize>() -> [f64; N] {{
    black_box([0.1; N])
}}

fn main() {{
{calls}
}}
"""
# Generated functions are generic over the scalar: only what is called is compiled.
CALL = "    black_box(Robot.{function}({arguments}));"
BATCH = "    let mut all = vec![Robot.{function}({arguments}); 64];\n    Robot.{function}_batch({slices}, &mut all).unwrap();"


def main():
    if any(word.startswith("-") for word in sys.argv[1:]) or len(sys.argv) > 2:
        sys.exit(__doc__.strip())
    robots = peers(pathlib.Path(sys.argv[1])) if len(sys.argv) > 1 else SHIPPED
    command = pathlib.Path(homogen()).resolve()
    rows = []
    for k, robot in enumerate(robots):
        with tempfile.TemporaryDirectory() as folder:
            for cost, seconds, megabytes in costs(pathlib.Path(folder), robot, command):
                print(f"{robot[0]}, {cost}: {seconds:.2f} s, {megabytes:.1f} MB", file=sys.stderr)
                rows.append((cost, robot[0], seconds, megabytes, BARS.get((cost, k))))
    print(written(rows))


def peers(folder):
    """The compared robots of a folder of `setup.sh`."""
    read = lambda robot, file: (folder / robot / file).read_text().strip()
    return [
        (read(robot, "title"), (folder / robot / "robot.urdf").resolve(), read(robot, "frame"), read(robot, "base") == "floating")
        for robot in PEERS
    ]


def costs(folder, robot, command):
    """Every cost of a robot: its name, wall seconds, MB of memory, for generated C of the file."""
    crate = folder / "crate"
    write_crate(crate, robot, ["inverse_dynamics"])
    run(["cargo", "fetch", "--quiet"], crate)
    yield "first build", *run(["cargo", "build", "--quiet"], crate)
    yield "check", *checked(crate, robot)
    release = ["cargo", "build", "--quiet", "--release"]
    # Compiles the dependencies.
    run(release, crate)
    write_main(crate, robot, TEN)
    yield "release", *run(release, crate)
    for cost, words in (("again", release), ("again, no SLP", NO_SLP)):
        change(crate)
        yield cost, *run(words, crate)
    write_main(crate, robot, FIVE, ", batch")
    yield "batch", *run(release, crate)
    yield "package", *package(folder, robot, command)
    yield from in_c(folder, robot, command)


def write_crate(crate, robot, functions):
    """A crate with a derive."""
    (crate / "src").mkdir(parents=True)
    (crate / "Cargo.toml").write_text(MANIFEST.format(runtime=ROOT / "runtime"))
    shutil.copy(ROOT / "Cargo.lock", crate)
    write_main(crate, robot, functions)


def write_main(crate, robot, functions, keys=""):
    """The derive of some functions, with further keys, and a call of each."""
    _, urdf, tip, floating = robot
    calls = []
    for function in functions:
        count = ARGUMENTS.get(function, 1)
        arguments = ", ".join(["&numbers()"] * count)
        slices = ", ".join(["&[numbers(); 64]"] * count)
        call = BATCH if "batch" in keys else CALL
        calls.append(call.format(function=function, arguments=arguments, slices=slices))
    keys += ", floating" if floating else ", path_only"
    main = MAIN.format(urdf=urdf, tip=tip, functions=", ".join(functions), keys=keys, calls="\n".join(calls))
    (crate / "src/main.rs").write_text(main)


def checked(crate, robot):
    """Median of three checks, each after a change, and the largest peak of memory."""
    write_main(crate, robot, ["inverse_dynamics"])
    source = crate / "src/main.rs"
    source.write_text(source.read_text().replace("generate(inverse_dynamics)", "generate(all)"))
    check = ["cargo", "check", "--quiet"]
    run(check, crate)
    found = []
    for _ in range(3):
        change(crate)
        found.append(run(check, crate))
    seconds, megabytes = zip(*found)
    return statistics.median(seconds), max(megabytes)


def change(crate):
    """Adds a function to `main.rs`."""
    source = crate / "src/main.rs"
    text = source.read_text()
    source.write_text(f"{text}\npub fn change_{len(text)}() {{}}\n")


def package(folder, robot, command):
    """The Python package of five functions, by the command that pip runs; its dependencies are compiled first."""
    for functions, name in ((["forward_kinematics"], "first"), (FIVE, "second")):
        shutil.rmtree(folder / name, ignore_errors=True)
        run([command, "python", *options(robot), "--functions", ",".join(functions), "-o", folder / name], folder)
        if name == "second":
            shutil.copy(folder / "first/Cargo.lock", folder / name)
        build = ["cargo", "build", "--quiet", "--release", "--lib", "--target-dir", folder / "package"]
        cost = run(build, folder / name)
    return cost


def in_c(folder, robot, command):
    """All functions in C, generated and compiled."""
    file = folder / "robot.c"
    seconds, _ = run([command, "generate", *options(robot), "--language", "c", "-o", file], folder)
    yield "C, generated", seconds, file.stat().st_size / 1e6
    yield "C, compiled", *run(["gcc", "-O2", "-c", file, "-o", folder / "robot.o"], folder)


def options(robot):
    """The options of the command line for a robot."""
    _, urdf, tip, floating = robot
    return [urdf, "--tip", tip, "--floating" if floating else "--path-only"]


def run(command, folder):
    """Wall seconds of a command, and the peak memory of its largest process in MB."""
    environment = {**ENVIRONMENT, "CARGO_TARGET_DIR": str(folder / "target")}
    start = time.monotonic()
    with tempfile.TemporaryFile() as output:
        process = subprocess.Popen([str(word) for word in command], cwd=folder, env=environment, stdout=output, stderr=output)
        _, status, usage = os.wait4(process.pid, 0)
        seconds = time.monotonic() - start
        process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode:
            output.seek(0)
            sys.exit(f"{' '.join(map(str, command))}: {output.read().decode()}")
    return seconds, usage.ru_maxrss / 1e3


def written(rows):
    """The table as Markdown."""
    lines = [
        "# Compile time",
        "",
        f"Measured by `report/compile.py` on {origin()}; {said('gcc', '--version').splitlines()[0]}.",
        "",
        *(line for line in __doc__.splitlines() if line.startswith("|")),
        "",
        "MB: peak memory of the largest process; of generated C, size of the file.",
        "",
        "| cost | robot | s | MB | bar | |",
        "|---|---|---:|---:|---|---|",
    ]
    order = list(dict.fromkeys(row[0] for row in rows))
    for cost, robot, seconds, megabytes, bar in sorted(rows, key=lambda row: order.index(row[0])):
        size = f"{megabytes:.1f}" if megabytes < 100 else f"{megabytes:.0f}"
        lines.append(f"| {cost} | {robot} | {seconds:.2f} | {size} | {' | '.join(verdict(seconds, megabytes, bar))} |")
    return "\n".join(lines)


def verdict(seconds, megabytes, bar):
    """A bar, and whether it is met; empty without any."""
    if bar is None:
        return "", ""
    parts = [(seconds, bar[0], "s"), (megabytes, bar[1], "MB")]
    parts = [(found, most, unit) for found, most, unit in parts if most is not None]
    met = all(found <= most for found, most, _ in parts)
    return ", ".join(f"{most} {unit}" for _, most, unit in parts), "met" if met else "**not met**"


if __name__ == "__main__":
    main()
