"""Compares expansions of xacro files with those of ROS's tool, element by element.

In: the binary, a folder with checkouts of repositories, and the table of arguments. Out: a line for each file whose
expansions differ, a section of report/ZOO.md, and a nonzero exit status if there is one. Texts must be equal; numbers may differ by two units in
the last place, because the tool computes sines by the platform. Declarations of namespaces and comments are left out.
Files of a line `file name=value …` in the table are compared with these arguments in addition.
"""

import argparse
import io
import math
import os
import re
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from concurrent.futures import ProcessPoolExecutor
from contextlib import redirect_stderr, redirect_stdout
from importlib.metadata import version
from pathlib import Path

import report
import section
import xacro
import xacro.substitution_args

SECTION = """\
Every xacro file of the repositories below, and some of them with further arguments, expanded by `homogen expand` and by
ROS's tool, version {xacro} of PyPI (written by `tests/zoo/xacro.sh`, on {machine}), and compared element by element,
attribute by attribute. Files of macros alone expand to a robot without links.

{summary}

"""

XACRO = "http://www.ros.org/wiki/xacro"
PACKAGES = {}
FOUND = {}
CHECKOUT = [None]


class Unreadable(Exception):
    """The tool rejects a file."""


def packages(folder):
    """The folder of each package by its name; of several, the one with the shortest path in the first checkout."""
    found = {}
    for manifest in sorted(folder.rglob("package.xml"), key=lambda path: (len(path.parts), str(path))):
        try:
            name = ElementTree.parse(manifest).getroot().findtext("name")
        except ElementTree.ParseError:
            continue
        if name:
            found.setdefault(name.strip(), manifest.parent)
    return found


def find(name):
    """The tool's `$(find name)`, without an installation of ROS."""
    # Several repositories may have a package of the name.
    own = PACKAGES.get(CHECKOUT[0], {})
    folder = own.get(name) or next((others[name] for others in PACKAGES.values() if name in others), None)
    if folder is None:
        raise xacro.substitution_args.SubstitutionException(f"package {name} is not found")
    FOUND[name] = str(folder)
    return FOUND[name]


def by_tool(file, arguments):
    """The tool's expansion and the packages that it looked for."""
    FOUND.clear()
    xacro.substitution_args._eval_find = find
    xacro.substitution_args._eval_dict["find"] = find
    try:
        with redirect_stderr(io.StringIO()), redirect_stdout(io.StringIO()):
            # The tool's table of global names keeps what an expansion wrote into it.
            xacro._global_symbols = xacro.create_global_symbols()
            document = xacro.process_file(str(file), mappings=dict(arguments), verbosity=0)
            text = document.toprettyxml(indent="  ")
    except (Exception, RecursionError) as reason:
        raise Unreadable(f"{type(reason).__name__}: {reason}".splitlines()[0]) from None
    for name, folder in sorted(FOUND.items(), key=lambda item: -len(item[1])):
        text = text.replace(folder, f"/package/{name}")
    return text, dict(FOUND)


def by_homogen(binary, file, arguments, found):
    """Our expansion, or the error."""
    options = [f"--arguments={name}={value}" for name, value in arguments]
    options += [f"--packages={name}={folder}" for name, folder in found.items()]
    command = [binary, "expand", str(file), *options]
    done = subprocess.run(command, capture_output=True, text=True, timeout=60)
    if done.returncode not in (0, 1):
        raise RuntimeError(f"exit status {done.returncode}: {done.stderr[:300]}")
    return (done.stdout, None) if done.returncode == 0 else (None, done.stderr.strip())


def parsed(text):
    """The root element; undeclared prefixes become parts of names."""
    text = re.sub(r"xmlns(:[\w.-]+)?=\"[^\"]*\"", "", text)
    text = re.sub(r"(<!--.*?-->)", "", text, flags=re.S)
    text = re.sub(r"(</?|\s)([A-Za-z_][\w.-]*):(?=[\w.-]+[\s=/>])", r"\1\2..", text)
    return ElementTree.fromstring(text)


def is_near(a, b):
    """True if two words are the same number up to the platform's rounding."""
    try:
        a, b = float(a), float(b)
    except ValueError:
        return False
    return a == b or (math.isnan(a) and math.isnan(b)) or abs(a - b) <= 2 * math.ulp(max(abs(a), abs(b)))


def difference(a, b, where, near):
    """The first difference of two elements; `near` counts numbers that differ in the last place."""
    where = f"{where}/{a.tag}[{a.get('name', '')}]"
    if a.tag != b.tag:
        return f"{where}: tags {a.tag} and {b.tag}"
    texts = [(f"attribute {key}", a.get(key), b.get(key)) for key in sorted(set(a.attrib) | set(b.attrib))]
    # An element beside text divides it.
    texts.append(("text", "".join([a.text or "", *(child.tail or "" for child in a)]), "".join([b.text or "", *(child.tail or "" for child in b)])))
    for what, one, other in texts:
        if one == other:
            continue
        if one is None or other is None:
            return f"{where}: {what} {one!r} and {other!r}"
        words, others = one.split(), other.split()
        if len(words) != len(others) or not all(x == y or is_near(x, y) for x, y in zip(words, others)):
            return f"{where}: {what} {one!r} and {other!r}"
        near[0] += words != others
    if len(a) != len(b):
        return f"{where}: {len(a)} and {len(b)} children: {[c.tag for c in a][:30]} and {[c.tag for c in b][:30]}"
    for one, other in zip(a, b):
        found = difference(one, other, where, near)
        if found:
            return found
    return None


def judge(binary, file, arguments):
    """Outcome for a file, a reason, the numbers that differ in the last place, and the number of elements."""
    refusal = None
    CHECKOUT[0] = next(checkout for checkout in PACKAGES if checkout in file.parents)
    # The tool resolves relative paths against the folder that it runs in.
    os.chdir(file.parent)
    try:
        theirs, found = by_tool(file, arguments)
    except Unreadable as reason:
        refusal, found = str(reason), dict(FOUND)
    try:
        ours, error = by_homogen(binary, file, arguments, found)
    except (RuntimeError, subprocess.TimeoutExpired) as reason:
        return "fails", str(reason), 0, 0
    if refusal is not None:
        if error is not None:
            return "rejected by both", f"{refusal} | {error.splitlines()[0]}", 0, 0
        # By design: readers of URDF need no declarations of prefixes.
        alone = "undeclared prefix, rejected by the tool alone" if "unbound prefix" in refusal else "rejected by the tool alone"
        return alone, refusal, 0, 0
    if error is not None:
        # By design: the folder that the tool runs in is no part of the description.
        alone = "$(cwd), rejected by homogen alone" if "$(cwd)" in error else "rejected by homogen alone"
        return alone, error, 0, 0
    near = [0]
    one, other = parsed(theirs), parsed(ours)
    different = difference(one, other, "", near)
    if different:
        return "different", different, 0, 0
    return "equal", "", near[0], sum(1 for _ in one.iter())


def main():
    options = argparse.ArgumentParser()
    options.add_argument("binary", type=Path)
    options.add_argument("robots", type=Path)
    options.add_argument("table", type=Path)
    options.add_argument("--only", default="")
    options.add_argument("--verbose", action="store_true")
    options.add_argument("--report", type=Path)
    options = options.parse_args()
    binary, robots = options.binary.resolve(), options.robots.resolve()
    for checkout in sorted(robots.iterdir()):
        PACKAGES[checkout] = packages(checkout)
    cases = [(file, ()) for file in sorted(robots.rglob("*.xacro"))]
    for line in options.table.read_text().splitlines():
        if line and not line.startswith("#"):
            file, *words = line.split()
            cases.append((robots / file, tuple(tuple(word.split("=", 1)) for word in words)))
    cases = [case for case in cases if options.only in str(case[0])]
    counts, near, elements = {}, 0, 0
    repositories = {}
    with ProcessPoolExecutor(2) as pool:
        results = pool.map(judge, [binary] * len(cases), [case[0] for case in cases], [case[1] for case in cases], chunksize=4)
        for (file, arguments), (outcome, reason, count, size) in zip(cases, results):
            name = f"{file.relative_to(robots)} {' '.join('='.join(pair) for pair in arguments)}".strip()
            key = outcome if outcome != "equal" or size > 3 else "equal, without links"
            counts[key] = counts.get(key, 0) + 1
            near += count
            elements += size
            repository = repositories.setdefault(file.relative_to(robots).parts[0].replace("+", "/"), {})
            repository[key] = repository.get(key, 0) + 1
            if options.verbose or outcome not in ("equal", "rejected by both"):
                print(f"{name}: {outcome}: {reason}", flush=True)
    counted = "; ".join(f"{count} {outcome}" for outcome, count in sorted(counts.items()))
    summary = f"{len(cases)} expansions with {elements} elements: {counted}. {near} values differ in the last place of a number."
    print(summary)
    if options.report:
        columns = sorted(counts)
        rows = [[f"`{name}`", *(found.get(key, "") for key in columns)] for name, found in repositories.items()]
        head = SECTION.format(xacro=version("xacro"), machine=report.machine(), summary=summary)
        section.write(options.report, "xacro", head + section.table(["repository", *columns], rows))
    bad = [outcome for outcome in counts if outcome in ("different", "fails", "rejected by homogen alone", "rejected by the tool alone")]
    sys.exit(bool(bad))


if __name__ == "__main__":
    main()
