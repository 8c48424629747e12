"""Reads an arm from a URDF by Pinocchio's parser, which its packages have for Python alone.

usage: model.py URDF FRAME MODEL. Joints that do not move the frame, such as those of fingers, are
locked at zero. MODEL is what model.hpp reads: the number of joints; for each its axis (0 to 2),
placement (rows of R, then t), and its body's mass, centre and rotational inertia (xx, xy, yy, xz,
yz, zz); and the placement of the frame on the last joint.
"""

import sys

import pinocchio

urdf, name, file = sys.argv[1:]
arm = pinocchio.buildModelFromUrdf(urdf)
assert arm.existFrame(name), f"{urdf} has no frame {name}"
moving = arm.supports[arm.frames[arm.getFrameId(name)].parentJoint]
still = [joint for joint in range(1, arm.njoints) if joint not in moving]
if still:
    arm = pinocchio.buildReducedModel(arm, still, pinocchio.neutral(arm))
frame = arm.frames[arm.getFrameId(name)]
AXES = ["JointModelRX", "JointModelRY", "JointModelRZ"]


def placement(of):
    return [*of.rotation.flatten(), *of.translation]


rows = [[arm.njoints - 1]]
for joint in range(1, arm.njoints):
    assert arm.parents[joint] == joint - 1, "one joint carries the next"
    body = arm.inertias[joint]
    i = body.inertia
    inertia = [i[0, 0], i[0, 1], i[1, 1], i[0, 2], i[1, 2], i[2, 2]]
    rows.append([AXES.index(arm.joints[joint].shortname()), *placement(arm.jointPlacements[joint])])
    rows.append([body.mass, *body.lever, *inertia])
assert frame.parentJoint == arm.njoints - 1, "the frame is at the end"
rows.append(placement(frame.placement))
with open(file, "w") as out:
    for row in rows:
        print(*[repr(float(number)) for number in row], file=out)
