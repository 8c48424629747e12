"""Compares random expressions with ROS's tool, which evaluates them in Python.

In: the binary, a count and a seed. Out: a line for each expression whose values differ, a section of report/ZOO.md, and
a nonzero exit status if there is one. What Python rejects must be rejected. What homogen does not support by its grammar, or because of a limit,
is counted.
"""

import argparse
import io
import random
import re
import subprocess
import sys
import tempfile
import warnings
import xml.etree.ElementTree as ElementTree
from contextlib import redirect_stderr
from pathlib import Path
from xml.sax.saxutils import quoteattr

import report
import section
import xacro

from xacro_peer import is_near

SECTION = """\
Random expressions, evaluated by `homogen expand` and by ROS's tool, which gives them to Python (written by
`tests/zoo/xacro.sh`, on {machine}). Not supported are those beyond the [grammar](../guide/src/xacro.md#expressions).

{summary}
"""

# Reasons for which homogen may reject what Python accepts.
LIMITS = [
    "larger than 2^53", "is complex", "not supported", "not known to a digit", "`is` compares", "more than 400", "too large",
    # Python accepts a word right behind a number, and warns.
    "is not a number",
    # `for i, in pairs`
    'unexpected "in"',
    # Differences of types that print differently in Python, or not at all.
    "has no member", "cannot be called", "is no integer", "has no operator", "have no operator", "is not defined",
]
NAMES = {"a": "0.5", "b": "-3", "name": "left arm", "flag": "True", "items": "${[1, 2.5, 'x']}", "table": "${dict(k=1, m=[2, 3])}"}


class Source:
    """Random expressions of the grammar, with some mistakes."""

    def __init__(self, seed):
        self.random = random.Random(seed)

    def pick(self, *choices):
        return self.random.choice(choices)

    def number(self):
        kind = self.random.randrange(6)
        if kind < 3:
            return str(self.random.randrange(12))
        if kind == 3:
            return repr(round(self.random.uniform(-5, 5), self.random.randrange(1, 5))).lstrip("-")
        return self.pick("0.1", "1e-7", "1e16", "2.5e3", ".5", "3.", "180", "1.5708", "123456789.125", "1e22", "0x1f", "1_000")

    def text(self):
        return self.pick("'x'", "'1.5'", "'7'", "''", "\"it's\"", "'a b c'", "'true'", "'_'", "r'\\n'", "'a' 'b'")

    def expression(self, depth):
        if depth <= 0 or self.random.random() < 0.08:
            return self.pick(self.number, self.number, self.text, lambda: self.pick(*NAMES), lambda: self.pick("True", "False", "None", "pi", "e", "inf"))()
        inner = lambda: self.expression(depth - self.random.randrange(1, 3))
        kind = self.random.randrange(20)
        if kind < 6:
            return f"{inner()} {self.pick('+', '-', '*', '/', '//', '%', '**', '+', '-', '*')} {inner()}"
        if kind == 6:
            return f"({inner()})"
        if kind == 7:
            return f"{self.pick('-', '+', 'not ', '- -')}{inner()}"
        if kind == 8:
            return f"{inner()} {self.pick('==', '!=', '<', '<=', '>', '>=', 'in', 'not in', 'is', 'is not')} {inner()}"
        if kind == 9:
            return f"{inner()} {self.pick('and', 'or')} {inner()}"
        if kind == 10:
            return f"{inner()} if {inner()} else {inner()}"
        if kind == 11:
            items = ", ".join(inner() for _ in range(self.random.randrange(4)))
            return self.pick(f"[{items}]", f"({items},)" if items else "()", f"dict(p={inner()}, q={inner()})")
        if kind == 12:
            return f"{inner()}[{inner()}]"
        if kind == 13:
            end = lambda: self.pick("", str(self.random.randrange(-4, 5)), "None")
            return f"{inner()}[{end()}:{end()}{self.pick('', ':' + end())}]"
        if kind == 14:
            return f"[{inner()} for i in {inner()} if {inner()}]".replace("name", "i") if self.random.random() < 0.5 else f"[i * 2 for i in range({self.random.randrange(6)})]"
        if kind < 18:
            name = self.pick(
                "sin", "cos", "tan", "asin", "acos", "atan", "sqrt", "radians", "degrees", "floor", "ceil", "exp", "log", "fabs", "int", "float", "str",
                "len", "bool", "max", "min", "round", "list", "sorted", "python.abs", "python.sum", "math.trunc", "log10", "isnan", "python.tuple", "python.any", "python.all",
            )
            return f"{name}({inner()})"
        if kind == 18:
            name = self.pick("atan2", "hypot", "pow", "fmod", "max", "min", "round", "copysign", "python.isinstance", "range", "log", "python.divmod")
            return f"{name}({inner()}, {inner()})"
        method = self.pick(
            "split()", "split(' ')", "upper()", "lower()", "strip()", "replace('a', 'b')", "startswith('a')", "endswith('x')", "join(['p', 'q'])", "find('b')", "count('a')",
            "index('x')", "get('k')", "get('z', 3)", "keys()", "title()", "isdigit()", "capitalize()", "format(1, 2)", "rsplit(' ', 1)", "zfill(3)",
        )
        return f"{inner()}.{method}"

    def broken(self, text):
        """The expression with one character removed, added or moved."""
        at = self.random.randrange(len(text))
        return self.pick(text[:at] + text[at + 1 :], text[:at] + self.pick("(", ")", "[", "'", ".", ",", "=", "!", "&", "0", "e", " ") + text[at:])


def document(expressions):
    properties = "".join(f"<xacro:property name={quoteattr(name)} value={quoteattr(value)}/>" for name, value in NAMES.items())
    lines = [f"<e v={quoteattr('${' + text + '}')}/>" for text in expressions]
    return f"<r xmlns:xacro=\"http://www.ros.org/wiki/xacro\">{properties}\n" + "\n".join(lines) + "\n</r>\n"


def by_tool(expression):
    """The tool's value as text; None if it rejects the expression."""
    try:
        with redirect_stderr(io.StringIO()), warnings.catch_warnings():
            warnings.simplefilter("ignore")
            xacro.filestack = None
            parsed = xacro.parse(document([expression]))
            xacro.process_doc(parsed, verbosity=0)
            return parsed.documentElement.getElementsByTagName("e")[0].getAttribute("v")
    except (Exception, RecursionError):
        return None


def is_equal(one, other):
    """True if two texts are equal up to the platform's rounding of numbers."""
    words = lambda text: re.findall(r"[-+]?(?:\d+\.?\d*(?:e[-+]\d+)?|inf|nan)|\D", text)
    one, other = words(one), words(other)
    return len(one) == len(other) and all(x == y or is_near(x, y) for x, y in zip(one, other))


def main():
    options = argparse.ArgumentParser()
    options.add_argument("binary", type=Path)
    options.add_argument("--count", type=int, default=20000)
    options.add_argument("--seed", type=int, default=0)
    options.add_argument("--report", type=Path)
    options = options.parse_args()
    source = Source(options.seed)
    expressions = []
    while len(expressions) < options.count:
        text = source.expression(source.random.randrange(1, 5))
        text = source.broken(text) if source.random.random() < 0.15 else text
        # Braces end an expression, and large powers take Python for ever.
        if "}" not in text and "{" not in text and text.count("**") < 2 and len(text) < 300:
            expressions.append(text)
    theirs = [by_tool(text) for text in expressions]
    wrong, limited, equal, rejected = 0, 0, 0, 0
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "e.xacro"

        def run(texts):
            file.write_text(document(texts))
            return subprocess.run([options.binary, "expand", str(file)], capture_output=True, text=True, timeout=120)

        for at in range(0, len(expressions), 500):
            chunk = list(zip(expressions[at : at + 500], theirs[at : at + 500]))
            # An error that ends the expansion hides those behind it.
            errors, more = {}, True
            while more:
                good = [k for k in range(len(chunk)) if k not in errors]
                done = run([chunk[k][0] for k in good])
                found = [re.match(r"error: e\.xacro:(\d+):\d+: (.*)", line) for line in done.stderr.splitlines()]
                more = {good[int(line[1]) - 2]: line[2] for line in found if line}
                errors |= more
            good = [chunk[k] for k in good]
            values = [element.get("v") for element in ElementTree.fromstring(done.stdout).iter("e")]
            for (text, value), ours in zip(good, values, strict=True):
                if value is None and ".keys()" in text:
                    limited += 1
                elif value is None:
                    wrong += 1
                    print(f"${{{text}}}: {ours!r}, rejected by the tool")
                # Ranges and views of dictionaries are lists here, and functions have no name.
                elif any(word in value for word in ("range(", "dict_", "<built-in")):
                    limited += 1
                # An attribute has spaces for line breaks once it is read again.
                elif not is_equal(re.sub(r"\s", " ", value), ours):
                    wrong += 1
                    print(f"${{{text}}}: {ours!r} instead of {value!r}")
                else:
                    equal += 1
            for k, (text, value) in enumerate(chunk):
                if k in errors and value is None:
                    rejected += 1
                elif k in errors and any(limit in errors[k] for limit in LIMITS):
                    limited += 1
                elif k in errors:
                    wrong += 1
                    print(f"${{{text}}}: {errors[k]}, but {value!r} by the tool")
    summary = f"{len(expressions)} expressions: {equal} equal, {rejected} rejected by both, {limited} not supported, {wrong} wrong."
    print(summary)
    if options.report:
        text = SECTION.format(machine=report.machine(), summary=summary)
        section.write(options.report, "Expressions of xacro", text)
    sys.exit(wrong > 0)


if __name__ == "__main__":
    main()
