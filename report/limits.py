#!/usr/bin/env python3
"""Bottlenecks of each function of a robot on a processor, by a model of its core.

    report/limits.py ROBOT.urdf [OPTION…]      [HOMOGEN=PATH: the command, where it is built already]

Compiles functions as the derive writes them, optimised for this processor, and passes the machine code of each to
LLVM's model of the core (`llvm-mca`, of the package `llvm`). OPTION is one of `homogen generate`, such as `--floating`.
Prints a table; needs cargo, llvm-mca and nm (`binutils`).

Columns: arithmetic instructions, those among them on vectors, loads, stores; bytes of machine code; clock cycles that
the ports of the core need (`ports`), of a single call (`alone`), of a call among a hundred independent ones (`each`);
the bottlenecks that the model reports. Where `each` is near `ports`, only fewer operations help; where it is well above,
the window of the core is too short to overlap calls.

The model assumes that instructions are in the cache. A loop over more bytes than the cache holds (in bold) fetches all
of them in each iteration, and takes longer than the model predicts.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

from command import ROOT, homogen, processor, said

FUNCTIONS = [
    "forward_kinematics",
    "geometric_jacobian",
    "gravity",
    "inverse_dynamics",
    "mass_matrix",
    "mass_matrix_inverse",
    "forward_dynamics",
    "inverse_dynamics_derivatives",
    "forward_dynamics_derivatives",
    "coriolis_matrix",
]
CALLS = 100


def main():
    if len(sys.argv) < 2 or sys.argv[1].startswith("-"):
        sys.exit(__doc__.strip())
    for tool in ("cargo", "llvm-mca", "nm"):
        if shutil.which(tool) is None:
            sys.exit(f"limits.py: {tool} is missing; please install it")
    with tempfile.TemporaryDirectory() as folder:
        text, sizes = compiled(pathlib.Path(folder), sys.argv[1:])
    held = int(said("getconf", "LEVEL1_ICACHE_SIZE"))
    print(f"{processor()}; {said('rustc', '--version')}, opt-level 3, target-cpu native; {version()}; {held} bytes of instructions")
    print()
    print("| function | numbers | vectors | loads | stores | bytes | ports | alone | each | waits for |")
    print("|---|---:|---:|---:|---:|---:|---:|---:|---:|---|")
    for function in FUNCTIONS:
        listing = until_it_returns(text, function)
        size = next(size for symbol, size in sizes.items() if re.search(rf"Robot\d+{function}17h", symbol))
        size = str(size) if size <= held or held == 0 else f"**{size}**"
        if reason := unmodelled(listing):
            print(f"| `{function}` |" + " – |" * 4 + f" {size} |" + " – |" * 3 + f" {reason} |")
            continue
        body = straight(listing)
        many, one = modelled(body, CALLS), modelled(body, 1)
        row = [*counted(body), size, f"{many['ports']:.0f}", one["cycles"], f"{many['cycles'] / CALLS:.0f}"]
        print(f"| `{function}` | {' | '.join(map(str, row))} | {many['waits']} |")


def compiled(folder, robot):
    """The machine code of the functions, as text, and how many bytes each has, by its symbol."""
    generate = [homogen(), "generate", *robot, "--runtime", "::homogen", "--scalar", "f64", "--name", "Robot"]
    code = said(*generate, "--functions", ",".join(FUNCTIONS))
    manifest = (
        '[package]\nname = "limits"\nversion = "0.1.0"\nedition = "2024"\n\n[workspace]\n\n'
        f'[dependencies]\nhomogen = {{ path = "{ROOT / "runtime"}", default-features = false, features = ["std"] }}\n\n'
        "[profile.release]\ncodegen-units = 1\n"
    )
    (folder / "src").mkdir()
    (folder / "Cargo.toml").write_text(manifest)
    shutil.copy(ROOT / "Cargo.lock", folder)
    (folder / "src/lib.rs").write_text(code)
    target = ROOT / "target/limits"
    environment = {**os.environ, "RUSTFLAGS": "-C target-cpu=native", "CARGO_TARGET_DIR": str(target)}
    command = ["cargo", "rustc", "--quiet", "--release", "--manifest-path", folder / "Cargo.toml", "--", "--emit", "asm,obj"]
    subprocess.run(command, check=True, env=environment)
    text, code = (newest(target / "release/deps", f"limits-*.{kind}") for kind in ("s", "o"))
    symbols = [line.split() for line in said("nm", "--print-size", code).splitlines()]
    return text.read_text(), {words[3]: int(words[1], 16) for words in symbols if len(words) == 4}


def newest(folder, pattern):
    """Of the files that fit a pattern."""
    return max(folder.glob(pattern), key=lambda file: file.stat().st_mtime)


def until_it_returns(text, function):
    """The listing of a function up to its return, behind which stands what is cold."""
    body = text[re.search(rf"^\w+Robot\d+{function}17h\w+:$", text, re.MULTILINE).end() :]
    return body[: re.search(r"^\tretq$", body, re.MULTILINE).end()]


def unmodelled(listing):
    """Why the model has nothing to say: it knows one stretch of operations, each of them once."""
    if "section_" in listing:
        return "it is cut into sections"
    for jump in re.finditer(r"^\tj\w+\s+(\.\w+)", listing, re.MULTILINE):
        if f"\n{jump.group(1)}:" in listing[: jump.start()]:
            return "a loop goes round in it"
    return None


def straight(listing):
    """The operations of a listing; jumps to what is cold are not taken."""
    lines = [line for line in listing.split("\n") if line.startswith("\t") and not line.startswith("\t.")]
    return [line for line in lines if not re.match(r"\t(j\w+|call\w*|ret\w*)\b", line)]


def counted(body):
    """How many operations compute, how many of these on vectors, load, and store."""
    computing = [line for line in body if re.match(r"\tv?\w*(add|sub|mul|div|sqrt)\w*[ps][sd]\b", line)]
    vectors = [line for line in computing if re.search(r"p[sd]\b", line.split()[0])]
    memory = [line for line in body if "(" in line and not line.startswith("\tlea")]
    stores = [line for line in memory if line.rstrip().endswith(")")]
    return len(computing), len(vectors), len(memory) - len(stores), len(stores)


def modelled(body, calls):
    """What the model says of so many calls."""
    command = ["llvm-mca", "-mcpu=native", f"-iterations={calls}", "-bottleneck-analysis", "-instruction-info=false"]
    answer = subprocess.run(command, input="\n".join(body), capture_output=True, text=True, check=True).stdout
    number = lambda name: float(re.search(rf"{name}:? +\[? *([\d.]+)", answer).group(1))
    reasons = {"ports": "Resource Pressure", "registers": "- Register Dependencies", "memory": "- Memory Dependencies"}
    parts = [f"{number(name):.0f} % {reason}" for reason, name in reasons.items() if re.search(name, answer)]
    return {"cycles": int(number("Total Cycles")), "ports": number("Block RThroughput"), "waits": ", ".join(parts)}


def version():
    """Of the model, and which core it has."""
    text = said("llvm-mca", "--version")
    release = re.search(r"LLVM version \S+", text).group(0)
    return f"{release}, which takes the core for {re.search(r'Host CPU: (.*)', text).group(1)}"


if __name__ == "__main__":
    main()
