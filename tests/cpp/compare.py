"""Compares headers in C++17 with the C files of the same robots, bit for bit.

    compare.py HOMOGEN FOLDER "FILE OPTIONS" ...

A program calls each function of both at random states, and the function of C++ with every kind of array. Of robots with
gravity and its derivative it compares the derivative with that of a dual number, whose conversion from a number is
explicit.
"""

import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

STATES = 100

EIGEN = "/usr/include/eigen3"

WARNINGS = ["-std=c++17", "-isystem", EIGEN, "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wsign-conversion", "-Wold-style-cast"]
WARNINGS += ["-Wdouble-promotion", "-Wshadow", "-Werror"]
OF_CLANG = ["-std=c++17", "-isystem", EIGEN, "-Weverything", "-Wno-c++98-compat", "-Wno-c++98-compat-pedantic", "-Wno-padded", "-Wno-missing-prototypes"]
OF_CLANG += ["-Wno-unknown-warning-option", "-Wno-unsafe-buffer-usage", "-Wno-unsafe-buffer-usage-in-libc-call", "-Werror"]


def prototypes(header):
    """Name, arguments and results of each function, with the lengths of their arrays."""
    header = re.sub(r"/\*.*?\*/", "", header, flags=re.DOTALL)
    for name, parameters in re.findall(r"HOMOGEN_FN void (\w+)\(([^)]*)\);", header):
        arguments, results = [], []
        for parameter in parameters.split(", "):
            lengths = re.findall(r"\[(\d+)\]", parameter)
            word = re.sub(r"\[.*", "", parameter.split()[-1]).lstrip("*")
            if word != "robot":
                (arguments if "const" in parameter else results).append((word, lengths))
        yield name, arguments, results


def brackets(lengths):
    return "".join(f"[{length}]" for length in lengths)


def nested(number, lengths):
    text = number
    for length in reversed(lengths):
        text = f"std::array<{text}, {length}>"
    return text


def swaps(arrays, is_linear, prefix=""):
    """Lines that bring six numbers of C into the order of C++; no robot of that order has another six."""
    for word, lengths in arrays:
        if is_linear and lengths[-1:] == ["6"]:
            yield f"swap_halves(&{prefix}{word}{'[0]' * len(lengths)}, {'*'.join(lengths)});"


def call(prefix, name, arguments, results, number, fields, is_linear):
    """Lines that call a function in both languages and compare the results."""
    short = re.sub("^_", "", name.removeprefix(prefix))
    lines = ["{"]
    for word, lengths in arguments:
        lines.append(f"{number} {word}{brackets(lengths)}; fill(&{word}{'[0]' * len(lengths)}, {'*'.join(lengths)});")
    for word, lengths in results:
        lines.append(f"{number} c_{word}{brackets(lengths)};")
    words = [word for word, _ in arguments]
    in_c = [f"reinterpret_cast<const {number}(*)[{lengths[1]}]>({word})" if len(lengths) > 1 else word for word, lengths in arguments]
    to = [f"{'' if lengths else '&'}c_{word}" for word, lengths in results]
    robot = ["&robot"] if fields else []
    lines.append(f"{name}({', '.join([*robot, *in_c, *to])});")
    lines += [*swaps(arguments, is_linear), *swaps(results, is_linear, "c_")]
    own = ["own"] if fields else []
    ways = [words]
    if all(len(lengths) == 1 for _, lengths in arguments) and arguments:
        for kind, template in (("array", "std::array<{n}, {l}>"), ("vector", "std::vector<{n}>"), ("eigen", "Eigen::Matrix<{n}, {l}, 1>")):
            made = []
            for word, lengths in arguments:
                made.append(f"{word}_{kind}")
                declaration = template.format(n=number, l=lengths[0])
                size = f"({lengths[0]})" if kind == "vector" else ""
                guard = kind == "eigen"
                lines += ["#if __has_include(<Eigen/Core>)"] * guard
                lines.append(f"{declaration} {made[-1]}{size}; std::copy({word}, {word} + {lengths[0]}, {made[-1]}.data());")
                lines += ["#endif"] * guard
            ways.append(made)
    for way in ways:
        guard = bool(way) and way[0].endswith("_eigen")
        lines += ["#if __has_include(<Eigen/Core>)"] * guard
        lines.append("{")
        lines.append(f"const auto found = SPACE::{short}({', '.join([*own, *way])});")
        if len(results) == 1:
            lines.append(f'same(&found, &c_{results[0][0]}, sizeof found, "{name}");')
        else:
            lines.append(f"const auto& [{', '.join('r_' + word for word, _ in results)}] = found;")
            lines += [f'same(&r_{word}, &c_{word}, sizeof r_{word}, "{name}");' for word, _ in results]
        lines.append("}")
        lines += ["#endif"] * guard
    return "\n".join([*lines, "}"])


HEAD = r"""
#include "robot.hpp"
#include "robot.h"
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <random>
#include <vector>

static std::mt19937_64 source(41);
static int failures = 0;

template <class T>
static void fill(T* to, int count)
{
    std::uniform_real_distribution<T> uniform(T(-2), T(2));
    std::generate(to, to + count, [&] { return uniform(source); });
}

template <class T>
[[maybe_unused]] static void swap_halves(T* six, int count)
{
    for (int k = 0; k < count; k += 6) {
        std::swap_ranges(six + k, six + k + 3, six + k + 3);
    }
}

static void same(const void* found, const void* expected, std::size_t size, const char* name)
{
    if (std::memcmp(found, expected, size) != 0) {
        std::printf("%s differs\n", name);
        failures++;
    }
}
"""

DUAL = r"""
struct Dual {
    double value, slope;
    explicit Dual(double v = 0.0, double s = 0.0) : value(v), slope(s) {}
};
static Dual operator+(const Dual& a, const Dual& b) { return Dual(a.value + b.value, a.slope + b.slope); }
static Dual operator-(const Dual& a, const Dual& b) { return Dual(a.value - b.value, a.slope - b.slope); }
static Dual operator*(const Dual& a, const Dual& b) { return Dual(a.value * b.value, a.slope * b.value + a.value * b.slope); }
[[maybe_unused]] static Dual operator-(const Dual& a) { return Dual(-a.value, -a.slope); }
[[maybe_unused]] static Dual operator*(double a, const Dual& b) { return Dual(a) * b; }
[[maybe_unused]] static Dual operator*(const Dual& a, double b) { return a * Dual(b); }
[[maybe_unused]] static Dual operator+(double a, const Dual& b) { return Dual(a) + b; }
[[maybe_unused]] static Dual operator+(const Dual& a, double b) { return a + Dual(b); }
[[maybe_unused]] static Dual operator-(double a, const Dual& b) { return Dual(a) - b; }
[[maybe_unused]] static Dual operator-(const Dual& a, double b) { return a - Dual(b); }
static Dual sin(const Dual& a) { return Dual(std::sin(a.value), a.slope * std::cos(a.value)); }
static Dual cos(const Dual& a) { return Dual(std::cos(a.value), -a.slope * std::sin(a.value)); }

static void dual(ARGUMENT)
{
    double q[SPACE::NQ];
    fill(q, int(SPACE::NQ));
    const auto derivative = SPACE::gravity_derivative(OWN q);
    for (std::size_t column = 0; column < SPACE::NQ; column++) {
        std::array<Dual, SPACE::NQ> along;
        for (std::size_t k = 0; k < SPACE::NQ; k++) {
            along[k] = Dual(q[k], k == column ? 1.0 : 0.0);
        }
        const auto found = SPACE::gravity(OWN along);
        for (std::size_t row = 0; row < SPACE::NV; row++) {
            if (!(std::abs(found[row].slope - derivative[row][column]) < 1e-11)) {
                std::printf("the derivative by a dual number differs\n");
                failures++;
            }
        }
    }
}
"""


def program(header, text, number, is_linear):
    """The text of the program."""
    space = re.search(r"^namespace (\w+) \{", header, re.MULTILINE)[1]
    prefix = re.search(r"typedef struct \{.*?\} (\w+?)robot;", text, re.DOTALL)
    struct = re.search(r"typedef struct \{(.*?)\} (\w+);", re.sub(r"/\*.*?\*/", "", text, flags=re.DOTALL), re.DOTALL)
    main = ["int main()\n{", f"for (int state = 0; state < {STATES}; state++) {{"]
    own = ""
    if struct:
        main.append(f"{struct[2]} robot; SPACE::Robot<> own;")
        for member, length in re.findall(r"\w+ (\w+)(?:\[(\d+)\])?;", struct[1]):
            first = f"{member}[0]" if length else member
            main.append(f"fill(&robot.{first}, {length or 1}); std::copy(&robot.{first}, &robot.{first} + {length or 1}, &own.{first});")
        own = "own, "
    names = [name for name, *_ in prototypes(text)]
    prefix = prefix[1] if prefix else space + "_"
    for name, arguments, results in prototypes(text):
        main.append(call(prefix, name, arguments, results, number, struct, is_linear))
    dual = ""
    if f"{prefix}gravity_derivative" in names:
        dual = DUAL.replace("ARGUMENT", "const SPACE::Robot<>& own" if own else "").replace("OWN ", own)
        main.append(f"dual({own.rstrip(', ')});")
    # Sections, which are whole in C++, or nothing at all: the names are those of the description.
    main.append("}\nstatic_assert(SPACE::NEUTRAL.size() == SPACE::NQ && SPACE::MAX_EFFORT.size() == SPACE::NV);")
    main.append('std::printf("%d differences\\n", failures);\nreturn failures != 0;\n}')
    return (HEAD + dual + "\n".join(main)).replace("SPACE", space)


def compiled(compiler, flags, folder, name):
    """Checks the header alone with all warnings, and builds the program with those that its own code has not."""
    alone = folder / "alone.cpp"
    alone.write_text('#include "robot.hpp"\nint main() {}\n')
    # Templates are checked where they are used.
    subprocess.run([compiler, *flags, "-fsyntax-only", "-I", folder, alone], check=True)
    # What templates do is seen where they are used.
    flags = ["-O2", "-ffp-contract=off", *WARNINGS] if compiler == "c++" else ["-std=c++17", "-isystem", EIGEN, "-O2", "-ffp-contract=off", "-Wall", "-Wextra", "-Wconversion", "-Werror"]
    subprocess.run([compiler, *flags, "-I", folder, folder / "main.cpp", folder / "robot.o", "-lm", "-o", folder / name], check=True)


def main(homogen, folder, *robots):
    folder = Path(folder)
    compilers = [("c++", WARNINGS)] + [("clang++", OF_CLANG)] * bool(shutil.which("clang++"))
    for robot in robots:
        options = shlex.split(robot)
        in_c = [option for option in options if option not in ("--order", "linear-first")]
        subprocess.run([homogen, "generate", *in_c, "--language", "c", "-o", folder / "robot.c"], check=True)
        subprocess.run([homogen, "generate", *options, "--language", "cpp", "-o", folder / "robot.hpp"], check=True)
        subprocess.run(["cc", "-std=c99", "-O2", "-ffp-contract=off", "-c", folder / "robot.c", "-o", folder / "robot.o"], check=True)
        header, text = (folder / "robot.hpp").read_text(), (folder / "robot.h").read_text()
        number = "float" if "--scalar f32" in robot else "double"
        (folder / "main.cpp").write_text(program(header, text, number, "--order" in options))
        for compiler, flags in compilers:
            compiled(compiler, flags, folder, "main")
            found = subprocess.run([folder / "main"], check=False, capture_output=True, text=True)
            print(f"{robot.split(' --functions')[0]} by {compiler}: {found.stdout.strip()}")
            assert found.returncode == 0, found.stderr


main(*sys.argv[1:])
