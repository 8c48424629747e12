"""Writes a robot that model.py has read as MuJoCo's description of it, on standard output.

usage: mjcf.py MODEL. A body a joint, with the masses that Pinocchio has, and nothing to be seen or touched; what
can be switched off of constraints, passive forces, actuators and sensors is.
"""

import sys

OFF = [
    "constraint", "equality", "frictionloss", "limit", "contact", "spring", "damper", "actuation", "sensor",
]

lines = [[float(number) for number in line.split()] for line in open(sys.argv[1])]
joints = int(lines[0][0])
bodies = [lines[1 + 3 * k : 4 + 3 * k] for k in range(joints)]


def words(numbers):
    return " ".join(map(repr, numbers))


def write(carrier):
    """What a joint carries, by its number; 0 is the fixed base."""
    for k, ((parent, kind, *axis), placement, (mass, *inertia)) in enumerate(bodies, 1):
        if int(parent) != carrier:
            continue
        rows, place = placement[:9], placement[9:]
        xx, xy, yy, xz, yz, zz = inertia[3:]
        print(f'<body pos="{words(place)}" xyaxes="{words([*rows[0::3], *rows[1::3]])}">')
        print(f'<inertial pos="{words(inertia[:3])}" mass="{mass!r}"')
        print(f' fullinertia="{words([xx, yy, zz, xy, xz, yz])}"/>')
        if kind == 0:
            print("<freejoint/>")
        else:
            print(f'<joint type="{"hinge" if kind == 1 else "slide"}" axis="{words(axis)}"/>')
        write(k)
        print("</body>")


print("<mujoco><compiler angle=\"radian\"/><option gravity=\"0 0 -9.81\"><flag")
print(" ".join(f'{what}="disable"' for what in OFF), "/></option><worldbody>")
write(0)
print("</worldbody></mujoco>")
