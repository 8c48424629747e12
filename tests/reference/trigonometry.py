#!/usr/bin/env python3
"""Derives every constant of the runtime's sines and cosines, and pins reference values for the tests.

Needs Python 3 and mpmath; the tests need neither, they read the output of this script.

    python3 trigonometry.py constants      the constants of runtime/src/scalar/trigonometry/*.rs
    python3 trigonometry.py table          tests/reference/trigonometry.txt

Polynomials: the minimax (smallest worst relative error) of the free coefficients on
|r| <= pi/4 (1 + 1e-3) by the exchange algorithm of Remez, one coefficient rounded to the type at a
time, lowest power first, and the rest fitted again. pi/2: parts with few enough bits that their product
with the number of the quadrant is exact. 2/pi: its binary digits.
"""

import struct
import sys

from mpmath import cos, floor, ldexp, lu_solve, matrix, mp, mpf, nint, pi, sin

mp.prec = 300

# name: (bits of the significand, bits of each part of pi/2 but the last, parts, digits of 2/pi)
TYPES = {"f64": (53, 36, 3, (64, 19)), "f32": (24, 13, 3, (32, 7))}
# Known terms of each function, leading power, number of free coefficients.
SINE = ("sine", sin, lambda x: x, 3)
COSINE = ("cosine", cos, lambda x: 1 - x * x / 2, 4)
DEGREES = {("f64", "sine"): 6, ("f64", "cosine"): 6, ("f32", "sine"): 3, ("f32", "cosine"): 3}
REACH = pi / 4 * (1 + mpf("1e-3"))


def rounded(x, bits):
    """Rounds x to the nearest number with this many bits."""
    if x == 0:
        return mpf(0)
    shift = bits - (int(floor(mp.log(abs(x), 2))) + 1)
    return ldexp(nint(ldexp(x, shift)), -shift)


def literal(x, name):
    """The shortest decimal that reads back as x, which is exactly representable, as Rust groups it."""
    text = repr(float(x))
    if name == "f32":
        text = next(
            candidate
            for candidate in (f"{float(x):.{digits}e}" for digits in range(12))
            if struct.unpack("f", struct.pack("f", float(candidate)))[0] == float(x)
        )
    digits, _, exponent = text.partition("e")
    whole, _, fraction = digits.partition(".")
    fraction = "_".join(fraction[i : i + 3] for i in range(0, len(fraction), 3))
    return f"{whole}.{fraction}" + (f"e{int(exponent)}" if exponent and int(exponent) else "")


def grouped(integer, bits):
    """A hexadecimal integer as Rust groups it."""
    text = f"{integer:0{bits // 4}x}"
    return "0x" + "_".join(text[i : i + 4] for i in range(0, len(text), 4))


def minimax(function, known, power, fixed, count):
    """The `count` next coefficients after `fixed`, and the worst relative error."""
    free = count - len(fixed)

    def rest(x):
        return function(x) - known(x) - sum(c * x ** (power + 2 * i) for i, c in enumerate(fixed))

    def basis(x, i):
        return x ** (power + 2 * (len(fixed) + i))

    def error(x, c):
        return (sum(c[i] * basis(x, i) for i in range(free)) - rest(x)) / function(x)

    low = mpf(1) / 50
    nodes = [
        low + (REACH - low) * (1 - cos(pi * (i + mpf(1) / 2) / (free + 1))) / 2
        for i in range(free + 1)
    ]
    grid = [low + (REACH - low) * i / 2000 for i in range(2001)]
    worst = mpf(0)
    for _ in range(30):
        system = matrix(free + 1)
        right = matrix(free + 1, 1)
        for row, x in enumerate(nodes):
            for i in range(free):
                system[row, i] = basis(x, i) / function(x)
            system[row, free] = (-1) ** row
            right[row] = rest(x) / function(x)
        solution = lu_solve(system, right)
        c = [solution[i] for i in range(free)]
        errors = [error(x, c) for x in grid]
        peaks = [
            i
            for i in range(len(grid))
            if (i == 0 or abs(errors[i]) >= abs(errors[i - 1]) or errors[i] * errors[i - 1] < 0)
            and (
                i + 1 == len(grid)
                or abs(errors[i]) >= abs(errors[i + 1])
                or errors[i] * errors[i + 1] < 0
            )
        ]
        alternating = []
        for i in peaks:
            if alternating and errors[alternating[-1]] * errors[i] > 0:
                if abs(errors[i]) > abs(errors[alternating[-1]]):
                    alternating[-1] = i
            else:
                alternating.append(i)
        while len(alternating) > free + 1:
            ends = (alternating[0], alternating[-1])
            alternating.remove(min(ends, key=lambda i: abs(errors[i])))
        worst = max(abs(e) for e in errors)
        if len(alternating) < free + 1:
            break
        nodes = [grid[i] for i in alternating]
        if worst - abs(solution[free]) <= worst * mpf("1e-3"):
            break
    return c, worst


def polynomial(name, case):
    """All coefficients of one polynomial in one type."""
    bits = TYPES[name][0]
    title, function, known, power = case
    count = DEGREES[name, title]
    fixed = []
    while len(fixed) < count:
        c, _ = minimax(function, known, power, fixed, count)
        fixed.append(rounded(c[0], bits))
    worst = max(
        abs((known(x) + sum(c * x ** (power + 2 * i) for i, c in enumerate(fixed))) / function(x) - 1)
        for x in (REACH * i / 4000 for i in range(1, 4001))
    )
    print(f"// {name} {title}, x^{power}...: worst relative error 2^{mp.nstr(mp.log(worst, 2), 5)}")
    for c in fixed:
        print(f"    {literal(c, name)},")


def constants():
    """Prints the constants of both types."""
    for name, (bits, part, parts, (word, words)) in TYPES.items():
        polynomial(name, SINE)
        polynomial(name, COSINE)
        rest = pi / 2
        print(f"// {name}: pi/2 in parts of {part} bits")
        for i in range(parts):
            piece = rounded(rest, part if i + 1 < parts else bits)
            print(f"    {literal(piece, name)},")
            rest -= piece
        print(f"// {name}: 2/pi, rounded: {literal(rounded(2 / pi, bits), name)}")
        print(f"// {name}: the first {word * words} binary digits of 2/pi")
        mp.prec = 3000
        digits = int(floor(ldexp(2 / pi, word * words)))
        print("   ", ", ".join(
            grouped(digits >> word * (words - 1 - i) & (1 << word) - 1, word) for i in range(words)
        ))
        print(f"// {name}: pi/2 as an integer: {grouped(int(nint(ldexp(pi / 2, word - 1))), word)}")
        mp.prec = 300


def table():
    """Prints the bits of the angle, its sine and its cosine with 70 digits."""
    mp.prec = 4000
    state = 1
    angles = [0.5, 1.0, 2.0, 3.0, 1e-8, 1e-300, 100.0, 1e5, 1e8, 1e22, 2.0**1023, 5e-324]
    # Nearest to multiples of pi/2: in the range of three parts, and of all f64 (Payne and Hanek's).
    for k in (1, 2, 29, 58285, 116570, 87981, 122925461, 10**15):
        angles.append(float(k * pi / 2))
    angles.append(6381956970095103.0 * 2.0**797)
    while len(angles) < 60:
        state = (state * 6364136223846793005 + 1442695040888963407) % 2**64
        exponent = -20 + (state >> 59) * 2
        angles.append((1 + (state >> 7) % 2**52 / 2.0**52) * 2.0**exponent)
    for angle in angles:
        exact = mpf(angle)
        print(struct.pack(">d", angle).hex(), mp.nstr(sin(exact), 70), mp.nstr(cos(exact), 70))


if __name__ == "__main__":
    commands = {"constants": constants, "table": table}
    if len(sys.argv) != 2 or sys.argv[1] not in commands:
        sys.exit(__doc__)
    commands[sys.argv[1]]()
