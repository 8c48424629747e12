"""The command line of this repository, and the origin of a measurement, for the scripts of this folder."""

import datetime
import os
import pathlib
import re
import subprocess

ROOT = pathlib.Path(__file__).resolve().parent.parent


def homogen():
    """The path of the command line: that in the variable HOMOGEN, otherwise it is built."""
    path = os.environ.get("HOMOGEN")
    if path is not None:
        return path
    build = ["cargo", "build", "--quiet", "--locked", "-p", "homogen-cli", "--bin", "homogen"]
    subprocess.run(build, check=True, cwd=ROOT)
    return pathlib.Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target")) / "debug/homogen"


def said(*words):
    """The output of a command."""
    return subprocess.run([str(word) for word in words], capture_output=True, text=True, check=True).stdout.strip()


def origin():
    """UTC date, commit and processor of a measurement, as a line; files that reports write are not counted as changes."""
    git = ["git", "-C", ROOT]
    commit = said(*git, "rev-parse", "--short=8", "HEAD")
    if said(*git, "status", "--porcelain", "--", ".", ":!report/*.md", ":!report/*.svg"):
        commit += ", with changes"
    date = datetime.datetime.now(datetime.timezone.utc).date()
    return f"{date} (UTC), commit {commit}, on {processor()}, {os.cpu_count()} threads; {said('rustc', '--version')}"


def processor():
    """The name of the processor."""
    words = pathlib.Path("/proc/cpuinfo").read_text()
    return re.search(r"model name\s*: (.*)", words).group(1)
