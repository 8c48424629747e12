"""Changes to the text of a URDF file, so that two readers can be asked the same.

In: a file. Out: another text. It never parses XML: what is changed stands where the
command line said that it stands.
"""

import math
import re

MARK = "\ufeff"


def read(file):
    """The text of a file; in Latin-1 where it is not UTF-8."""
    data = file.read_bytes()
    try:
        return data.decode("utf-8")
    except UnicodeDecodeError:
        return data.decode("latin-1")


def with_right_angles(text, snapped):
    """The numbers that were taken for multiples of a right angle or for zero, written in full."""
    lines = text.removeprefix(MARK).split("\n")
    # From the end of a line to its start, so that columns stay what they are.
    for angle in sorted(snapped, key=lambda angle: (angle["line"], -angle["column"])):
        line, column = angle["line"] - 1, angle["column"] - 1
        word = re.match(r"[-+.0-9eE]+", lines[line][column:]).group()
        assert float(word) == angle["written"], f"{word} at {angle}"
        exact = repr(angle["quarter_turns"] * math.pi / 2)
        lines[line] = lines[line][:column] + exact + lines[line][column + len(word) :]
    return "\n".join(lines)
