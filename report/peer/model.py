"""Reads a robot from a URDF by Pinocchio's parser, which its packages have for Python alone.

usage: model.py URDF FRAME MODEL [fixed | floating]. On a fixed base, as by default, joints that do not
move the frame, such as those of fingers, are locked at zero; on a floating one every joint moves.

MODEL is what model.hpp reads: the number of joints; for each the joint that carries it (1 for the
first, 0 for the fixed base), what it is (0 a free base, 1 it turns, 2 it slides), its axis, its
placement (rows of R, then t), and its body's mass, centre and rotational inertia (xx, xy, yy, xz, yz,
zz); and for the frame the joint that carries it and its placement. Joints come branch by branch,
siblings as the file has them, which is homogen's order; MODEL.joints has their names, a line each.
"""

import sys
import xml.etree.ElementTree as xml

import numpy
import pinocchio

urdf, name, file, *base = sys.argv[1:]
assert base in ([], ["fixed"], ["floating"]), __doc__
floats = base == ["floating"]
# What Pinocchio calls a free base, and what homogen does.
ROOT, FREE = "root_joint", "root"


def by_branch(path):
    """The names of a file's joints, parents before children, siblings as described."""
    described = xml.parse(path).getroot().findall("joint")
    ends = [(j.find("parent").get("link"), j.find("child").get("link"), j.get("name")) for j in described]
    carried = {child for _, child, _ in ends}
    waiting = [("", next(parent for parent, _, _ in ends if parent not in carried))]
    while waiting:
        joint, link = waiting.pop()
        yield joint
        waiting += [(joint, child) for parent, child, joint in reversed(ends) if parent == link]


def placement(of):
    return [*of.rotation.flatten(), *of.translation]


def kind_and_axis(joint):
    screws = joint.createData().S
    if joint.shortname() == "JointModelFreeFlyer":
        return [0, 0, 0, 0]
    assert screws.size == 6, f"{joint.shortname()} has several velocities"
    # Pinocchio's rows are linear, then angular.
    linear, angular = screws.flatten()[:3], screws.flatten()[3:]
    assert not (linear.any() and angular.any()), f"{joint.shortname()} is no plain joint"
    return [1, *angular] if angular.any() else [2, *linear]


root = [pinocchio.JointModelFreeFlyer()] if floats else []
robot = pinocchio.buildModelFromUrdf(urdf, *root)
assert robot.existFrame(name), f"{urdf} has no frame {name}"
if not floats:
    moving = robot.supports[robot.frames[robot.getFrameId(name)].parentJoint]
    still = [joint for joint in range(1, robot.njoints) if joint not in moving]
    if still:
        robot = pinocchio.buildReducedModel(robot, still, pinocchio.neutral(robot))
frame = robot.frames[robot.getFrameId(name)]

names = [joint for joint in [ROOT, *by_branch(urdf)] if joint in list(robot.names)]
order = [robot.getJointId(joint) for joint in names]
assert len(order) == robot.njoints - 1, "each joint comes once"
place = {0: 0} | {joint: k for k, joint in enumerate(order, 1)}
rows = [[len(order)]]
for joint in order:
    body = robot.inertias[joint]
    inertia = body.inertia[numpy.tril_indices(3)]
    rows.append([place[robot.parents[joint]], *kind_and_axis(robot.joints[joint])])
    rows.append(placement(robot.jointPlacements[joint]))
    rows.append([body.mass, *body.lever, *inertia])
rows.append([place[frame.parentJoint], *placement(frame.placement)])
with open(file, "w") as out:
    for row in rows:
        print(*[repr(float(number)) for number in row], file=out)
with open(f"{file}.joints", "w") as out:
    for joint in names:
        print(FREE if joint == ROOT else joint, file=out)
