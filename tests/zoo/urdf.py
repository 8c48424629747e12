"""Edits the text of a URDF file, so that homogen and Pinocchio read the same numbers.

In: a file. Out: the edited text. It does not parse XML: the command line reports line and column of each edit.
"""

import math
import re

MARK = "\ufeff"


def read(file):
    """Text of a file, as Latin-1 if it is not UTF-8."""
    data = file.read_bytes()
    try:
        return data.decode("utf-8")
    except UnicodeDecodeError:
        return data.decode("latin-1")


def with_right_angles(text, snapped):
    """Writes in full the numbers that were snapped to multiples of a right angle or to zero."""
    lines = text.removeprefix(MARK).split("\n")
    # From the end of a line to its start, so that the remaining columns stay valid.
    for angle in sorted(snapped, key=lambda angle: (angle["line"], -angle["column"])):
        line, column = angle["line"] - 1, angle["column"] - 1
        word = re.match(r"[-+.0-9eE]+", lines[line][column:]).group()
        assert float(word) == angle["written"], f"{word} at {angle}"
        exact = repr(angle["quarter_turns"] * math.pi / 2)
        lines[line] = lines[line][:column] + exact + lines[line][column + len(word) :]
    return "\n".join(lines)
