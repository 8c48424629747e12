"""Sections of report/ZOO.md, of which each script writes its own.

In: the report, the heading of a section, its text. Out: the report with that section replaced, and all others as they
were, in the order of HEADINGS.
"""

from pathlib import Path

TITLE = """\
# The zoo

Robot descriptions as vendors, simulators and researchers ship them, untouched, and random ones: what `homogen` makes
of each file, beside the program that its format belongs to.

"""
HEADINGS = ["URDF", "MJCF", "xacro", "Expressions of xacro", "SDF"]


def write(path, heading, text):
    """Replaces a section, or adds it."""
    sections = read(path)
    sections[heading] = text.strip() + "\n"
    found = [f"## {heading}\n\n{sections[heading]}" for heading in HEADINGS if heading in sections]
    Path(path).write_text(TITLE + "\n".join(found))


def read(path):
    """The texts of the sections, by heading."""
    sections, heading = {}, None
    path = Path(path)
    for line in path.read_text().splitlines() if path.exists() else []:
        if line.startswith("## "):
            heading = line.removeprefix("## ")
            sections[heading] = ""
        elif heading:
            sections[heading] += line + "\n"
    return {heading: text.strip() + "\n" for heading, text in sections.items()}


def table(columns, rows):
    """A table in Markdown."""
    lines = [columns, ["---"] * len(columns), *rows]
    return "".join("| " + " | ".join(str(cell).replace("|", "\\|") for cell in line) + " |\n" for line in lines)
