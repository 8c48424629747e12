"""The command line of this repository, for the scripts of this folder, which import it."""

import os
import pathlib
import subprocess

ROOT = pathlib.Path(__file__).resolve().parent.parent


def homogen():
    """Where it is, which HOMOGEN may tell; else it is built."""
    told = os.environ.get("HOMOGEN")
    if told is not None:
        return told
    build = ["cargo", "build", "--quiet", "--locked", "-p", "homogen-cli", "--bin", "homogen"]
    subprocess.run(build, check=True, cwd=ROOT)
    return pathlib.Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target")) / "debug/homogen"


def said(*words):
    """What a command prints."""
    return subprocess.run([str(word) for word in words], capture_output=True, text=True, check=True).stdout.strip()
