"""The line that says what takes long: on a terminal alone."""

import os
import subprocess
import sys
import time

import pytest
from conftest import ROBOTS

import homogen
from homogen import _progress

PROGRAM = """
import sys, time
from homogen._progress import working
with working("compiling gravity"):
    with working("something within"):
        time.sleep(float(sys.argv[1]))
print("ended")
"""


def on_a_terminal(seconds):
    """What a process writes to a terminal that computes for so long."""
    pty = pytest.importorskip("pty")
    ours, theirs = pty.openpty()
    words = [sys.executable, "-c", PROGRAM, str(seconds)]
    process = subprocess.Popen(words, stdout=subprocess.PIPE, stderr=theirs)
    assert process.communicate(timeout=60)[0] == b"ended\n"
    os.write(theirs, b"|")
    os.close(theirs)
    found = b""
    while not found.endswith(b"|"):
        found += os.read(ours, 10_000)
    os.close(ours)
    return found.decode()


def test_a_terminal_shows_what_takes_long():
    found = on_a_terminal(2.5)
    line = "compiling gravity, 1 s"
    assert found == f"\r{line}\r{line.replace('1', '2')}\r{' ' * len(line)}\r|"
    assert on_a_terminal(0.2) == "|"


def test_a_pipe_stays_empty():
    words = [sys.executable, "-c", PROGRAM, "1.5"]
    done = subprocess.run(words, check=True, capture_output=True, text=True)
    assert done.stderr == "" and done.stdout == "ended\n"


def test_a_stream_that_fails_stops_nothing(monkeypatch, arm):
    class Closed:
        def isatty(self):
            return True

        def write(self, text):
            raise OSError("it is gone")

    monkeypatch.setattr(_progress, "PERIOD", 0.01)
    monkeypatch.setattr(sys, "stderr", Closed())
    with _progress.working("anything"):
        time.sleep(0.05)
    monkeypatch.setattr(sys, "stderr", None)
    with _progress.working("anything"):
        assert "joint1" in arm.check()


def test_robots_say_what_they_do(monkeypatch):
    shown = []

    class Terminal:
        def isatty(self):
            return True

        def write(self, text):
            shown.append(text)

        def flush(self):
            pass

    monkeypatch.setattr(_progress, "PERIOD", 0.005)
    monkeypatch.setattr(sys, "stderr", Terminal())
    of = homogen.load(ROBOTS / "panda_class.urdf", tip="link8", gravity=[0, 0, -1.23456])
    of.compile("mass_matrix", "forward_dynamics")
    assert any("compiling forward_dynamics, 2 of 2, 0 s" in text for text in shown)
    assert shown[-1].isspace()
