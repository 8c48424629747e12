"""Values of a robot by Pinocchio.

In: a URDF file, names of joints in the order of q, states. Out: every function's values
in the order and the conventions of `homogen eval`. It shares no code and no data with homogen.
"""

import os
import re
import tempfile
from pathlib import Path

import numpy as np
import pinocchio as pin
from urdf import read as read_text


class Unreadable(Exception):
    """Pinocchio does not read this file."""


def read(file, floating):
    """Returns the model and the messages on standard error. Pinocchio reports unreadable links there, and continues with
    zeros."""
    standard_error = os.dup(2)
    root = [pin.JointModelFreeFlyer()] if floating else []
    with tempfile.TemporaryFile() as messages:
        os.dup2(messages.fileno(), 2)
        try:
            model = pin.buildModelFromUrdf(str(file), *root)
        except Exception as reason:
            raise Unreadable(str(reason)) from reason
        finally:
            os.dup2(standard_error, 2)
            os.close(standard_error)
        messages.seek(0)
        return model, messages.read().decode(errors="replace")


def mimic_joints(file, moving):
    """For each moving mimic joint: the independent joint that it depends on, multiplier and offset."""
    # By regular expressions: files with undeclared prefixes are not valid XML, but are read.
    text = re.sub(r"<!--.*?-->", "", read_text(file), flags=re.DOTALL)
    mimics = {}
    for joint in re.findall(r"<joint\b[^>]*[^/]>.*?</joint>", text, flags=re.DOTALL):
        mimic = re.search(r"<mimic\b[^>]*>", joint)
        name, mimicked = attribute(joint, "name"), mimic and attribute(mimic.group(), "joint")
        if name in moving and mimicked in moving:
            values = [float(attribute(mimic.group(), *default)) for default in (("multiplier", "1"), ("offset", "0"))]
            mimics[name] = (mimicked, *values)
    found = {}
    for joint in mimics:
        mimicked, multiplier, offset = joint, 1.0, 0.0
        while mimicked in mimics:
            mimicked, own, more = mimics[mimicked]
            multiplier, offset = multiplier * own, offset + multiplier * more
        found[joint] = (mimicked, multiplier, offset)
    return found


def attribute(tag, name, otherwise=None):
    found = re.search(rf'''\b{name}\s*=\s*(["'])(.*?)\1''', tag, flags=re.DOTALL)
    return found.group(2) if found else otherwise


# Suffixes of coordinate and velocity names of a joint with several coordinates.
POSITIONS = {"x": 0, "y": 1, "z": 2, "qx": 3, "qy": 4, "qz": 5, "qw": 6}
VELOCITIES = {"vx": 0, "vy": 1, "vz": 2, "wx": 3, "wy": 4, "wz": 5}


class Peer:
    """A robot as Pinocchio reads it; mimic joints are independent in the model; their motion is projected here."""

    def __init__(self, file, floating=False):
        self.model, messages = read(file, floating)
        self.is_sure = "Error" not in messages
        self.data = self.model.createData()
        self.joints = list(self.model.names)[1:]
        self.mimics = mimic_joints(Path(file), self.joints)

    def joint(self, name):
        """The joint of an entry, and the suffix of its name."""
        joint, _, entry = (name, "", "") if name in self.joints else name.rpartition(".")
        joint = "root_joint" if joint == "root" and joint not in self.joints else joint
        return self.model.joints[self.model.getJointId(joint)], entry

    def order(self, coordinates, velocities):
        """Sets the order of q and of the velocities; the joints must be those of the model, in any order."""
        self.coordinates = [self.joint(name) for name in coordinates]
        # Each column: velocities of the model for one velocity of homogen.
        self.project = np.zeros((self.model.nv, len(velocities)))
        for k, name in enumerate(velocities):
            joint, entry = self.joint(name)
            planar = "Planar" in joint.shortname()
            place = (2 if planar and entry == "wz" else VELOCITIES[entry]) if entry else 0
            self.project[joint.idx_v + place, k] = 1.0
        for mimic, (mimicked, multiplier, _) in self.mimics.items():
            row, source = (self.model.joints[self.model.getJointId(name)].idx_v for name in (mimic, mimicked))
            self.project[row] = multiplier * self.project[source]
        alone = np.count_nonzero(self.project, axis=1) == 1
        assert np.all(alone), f"different joints: {velocities} and {self.joints}"

    def translations(self):
        """True for each coordinate, in the order of q, that is a length."""
        return ["JointModelP" in j.shortname() and "Planar" not in j.shortname() or entry in ("x", "y", "z") for j, entry in self.coordinates]

    def quaternions(self):
        """Indices in q at which quaternions begin."""
        return [k for k, (_, entry) in enumerate(self.coordinates) if entry == "qx"]

    def leaves(self):
        """Links without children, those with the most joints on their path first."""
        bodies = [frame for frame in self.model.frames if frame.type == pin.BODY]
        carrying = {self.model.frames[frame.parentFrame].parentFrame for frame in bodies}
        at = {frame.name: self.model.getFrameId(frame.name, pin.BODY) for frame in bodies}
        leaves = [frame for frame in bodies if at[frame.name] not in carrying]
        depth = {frame.name: len(self.model.supports[frame.parentJoint]) for frame in leaves}
        return [frame.name for frame in sorted(leaves, key=lambda frame: -depth[frame.name])]

    def configuration(self, q):
        """q in the coordinates of Pinocchio: an angle without limits is a cosine and a sine."""
        full = np.zeros(self.model.nq)
        values = {}
        for (joint, entry), value in zip(self.coordinates, q):
            values[joint.id] = value
            if entry == "angle":
                full[joint.idx_q + 2 : joint.idx_q + 4] = [np.cos(value), np.sin(value)]
            elif entry:
                full[joint.idx_q + POSITIONS[entry]] = value
            else:
                self.put(full, joint, value)
        for mimic, (mimicked, multiplier, offset) in self.mimics.items():
            joint, independent = (self.model.getJointId(name) for name in (mimic, mimicked))
            self.put(full, self.model.joints[joint], multiplier * values[independent] + offset)
        return full

    def put(self, full, joint, value):
        is_unlimited = joint.nq == 2
        full[joint.idx_q : joint.idx_q + joint.nq] = [np.cos(value), np.sin(value)] if is_unlimited else value

    def vector(self, values):
        return self.project @ values

    def dynamics(self, state):
        """Values of the functions of the whole robot."""
        model, data = self.model, self.data
        q = self.configuration(state["q"])
        v, a = (self.vector(state[key]) for key in ("qd", "qdd"))
        gather = self.project.T
        mass = gather @ whole(pin.crba(model, data, q)) @ self.project
        bias = gather @ pin.rnea(model, data, q, v, 0 * v)
        if self.mimics:
            forward = np.linalg.lstsq(mass, np.array(state["tau"]) - bias, rcond=None)[0]
        else:
            forward = gather @ pin.aba(model, data, q, v, self.vector(state["tau"]))
        return {
            "inverse_dynamics": gather @ pin.rnea(model, data, q, v, a),
            "gravity": gather @ pin.computeGeneralizedGravity(model, data, q),
            "bias": bias,
            "mass_matrix": mass,
            "forward_dynamics": forward,
        }

    def least_conditioned(self, samples=20000):
        """The smallest relative eigenvalue of the mass matrix over configurations inside the limits, each joint on its own
        scale."""
        rng = np.random.default_rng(0)
        low = np.maximum(self.model.lowerPositionLimit, -np.pi)
        high = np.maximum(low, np.minimum(self.model.upperPositionLimit, np.pi))

        def mass():
            q = pin.normalize(self.model, rng.uniform(low, high))
            return self.project.T @ whole(pin.crba(self.model, self.data, q)) @ self.project

        return min(spread(mass()) for _ in range(samples))

    def kinematics(self, state, link):
        """Values of the functions of a link's frame."""
        model, data = self.model, self.data
        q = self.configuration(state["q"])
        v, a = (self.vector(state[key]) for key in ("qd", "qdd"))
        frame = model.getFrameId(link, pin.BODY)
        pin.forwardKinematics(model, data, q, v, a)
        pin.updateFramePlacements(model, data)
        pose = data.oMf[frame].copy()
        velocity = pin.getFrameVelocity(model, data, frame, pin.LOCAL_WORLD_ALIGNED).copy()
        acceleration = pin.getFrameClassicalAcceleration(model, data, frame, pin.LOCAL_WORLD_ALIGNED).copy()
        pin.computeJointJacobians(model, data, q)

        def jacobian(axes):
            # For one joint Pinocchio returns a vector.
            rows = pin.getFrameJacobian(model, data, frame, axes).reshape(6, model.nv)
            return np.vstack([rows[3:], rows[:3]]) @ self.project

        spin = pin.skew(velocity.angular)
        rate = pin.skew(acceleration.angular) + spin @ spin
        return {
            "forward_kinematics": pose.homogeneous,
            "spatial_jacobian": jacobian(pin.WORLD),
            "body_jacobian": jacobian(pin.LOCAL),
            "geometric_jacobian": jacobian(pin.LOCAL_WORLD_ALIGNED),
            "velocity": with_column(spin, velocity.linear - spin @ pose.translation),
            "acceleration": with_column(rate, acceleration.linear - rate @ pose.translation),
        }


def with_column(block, column):
    matrix = np.zeros((4, 4))
    matrix[:3, :3], matrix[:3, 3] = block, column
    return matrix


def whole(upper):
    """The symmetric matrix with this upper triangle."""
    upper = np.triu(upper)
    return upper + np.triu(upper, 1).T


def spread(mass):
    """Smallest eigenvalue relative to the largest, after scaling the diagonal to 1."""
    root = np.sqrt(np.maximum(np.diag(mass), 0.0))
    if np.any(root == 0.0):
        return 0.0
    values = np.linalg.eigvalsh(mass / np.outer(root, root))
    return values[0] / values[-1]
