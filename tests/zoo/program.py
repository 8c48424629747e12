"""The command line of homogen.

In: a file, and a function to evaluate. Out: the program's output. A timeout or a crash is never taken for a refusal.
"""

import json
import os
import resource
import subprocess

# Limit of processor time \[s\]; the limit of elapsed time is longer, since the machine may be busy.
MOST = 10


class Failed(Exception):
    """The program crashed, or took too long."""


class Refused(Exception):
    """The program rejected its input: one message for each mistake."""

    def __init__(self, output):
        mistakes = [line.removeprefix("error: ") for line in output.splitlines() if line.startswith("error: ")]
        super().__init__("; ".join(mistakes))
        self.mistakes = mistakes


class Program:
    """Runs commands of the binary."""

    def __init__(self, binary):
        self.binary = str(binary)

    def run(self, *arguments):
        """Output for these arguments."""
        command = [self.binary, *map(str, arguments)]

        def limit():
            resource.setrlimit(resource.RLIMIT_CPU, (MOST, MOST))

        try:
            done = subprocess.run(
                command,
                capture_output=True,
                text=True,
                timeout=20 * MOST,
                preexec_fn=limit,
                env={**os.environ, "RUST_BACKTRACE": "0"},
            )
        except subprocess.TimeoutExpired:
            raise Failed(f"took more than {20 * MOST} s: {arguments[:1]}") from None
        if done.returncode == 0:
            return done.stdout
        if done.returncode == 1 and "panicked" not in done.stderr:
            raise Refused(done.stderr)
        what = f"took more than {MOST} s" if done.returncode in (-9, -24) else f"ended with {done.returncode}"
        raise Failed(f"{arguments[0]} {what}: {done.stderr.strip()[-200:]}")

    def check(self, file, how):
        """Output of `check` for a description."""
        return json.loads(self.run("check", file, "--format", "json", *how.options))

    def eval(self, file, how, function, states, link=None):
        """Values of a function at all states."""
        options = ["--function", function, "--states", states, "--format", "json"]
        options += ["--tip", link] if link else []
        return json.loads(self.run("eval", file, *options, *how.options))["results"]
