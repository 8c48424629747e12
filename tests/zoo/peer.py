"""What Pinocchio says of a robot.

In: a URDF file, names of joints in the order of q, states. Out: every function's values
in the order and the conventions of `homogen eval`. It never reads anything of homogen's: that the two
agree is worth something because they share nothing.
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
    """The model, and what is said on standard error: of a link that it cannot read it complains there,
    and goes on with zeros."""
    standard_error = os.dup(2)
    root = [pin.JointModelFreeFlyer()] if floating else []
    with tempfile.TemporaryFile() as said:
        os.dup2(said.fileno(), 2)
        try:
            model = pin.buildModelFromUrdf(str(file), *root)
        except Exception as reason:
            raise Unreadable(str(reason)) from reason
        finally:
            os.dup2(standard_error, 2)
            os.close(standard_error)
        said.seek(0)
        return model, said.read().decode(errors="replace")


def followers(file, moving):
    """Of each joint that moves and mimics another: the one that has the coordinate, a multiplier, an offset."""
    # Files with prefixes that nothing declares are no XML, and are read all the same.
    text = re.sub(r"<!--.*?-->", "", read_text(file), flags=re.DOTALL)
    mimics = {}
    for joint in re.findall(r"<joint\b[^>]*[^/]>.*?</joint>", text, flags=re.DOTALL):
        mimic = re.search(r"<mimic\b[^>]*>", joint)
        name, leader = attribute(joint, "name"), mimic and attribute(mimic.group(), "joint")
        if name in moving and leader in moving:
            values = [float(attribute(mimic.group(), *default)) for default in (("multiplier", "1"), ("offset", "0"))]
            mimics[name] = (leader, *values)
    found = {}
    for joint in mimics:
        leader, multiplier, offset = joint, 1.0, 0.0
        while leader in mimics:
            leader, own, more = mimics[leader]
            multiplier, offset = multiplier * own, offset + multiplier * more
        found[joint] = (leader, multiplier, offset)
    return found


def attribute(tag, name, otherwise=None):
    found = re.search(rf'''\b{name}\s*=\s*(["'])(.*?)\1''', tag, flags=re.DOTALL)
    return found.group(2) if found else otherwise


# What stands behind the name of a joint with several coordinates.
POSITIONS = {"x": 0, "y": 1, "z": 2, "qx": 3, "qy": 4, "qz": 5, "qw": 6}
VELOCITIES = {"vx": 0, "vy": 1, "vz": 2, "wx": 3, "wy": 4, "wz": 5}


class Peer:
    """A robot as Pinocchio reads it; joints that mimic others are full joints there, and projected here."""

    def __init__(self, file, floating=False):
        self.model, said = read(file, floating)
        self.is_sure = "Error" not in said
        self.data = self.model.createData()
        self.joints = list(self.model.names)[1:]
        self.followers = followers(Path(file), self.joints)

    def joint(self, name):
        """The joint of an entry, and what stands behind its name."""
        joint, _, entry = (name, "", "") if name in self.joints else name.rpartition(".")
        joint = "root_joint" if joint == "root" and joint not in self.joints else joint
        return self.model.joints[self.model.getJointId(joint)], entry

    def order(self, coordinates, velocities):
        """Sets the order of q and of its rates; the joints must be those of the model, in any order."""
        self.coordinates = [self.joint(name) for name in coordinates]
        # Columns: what a velocity moves.
        self.project = np.zeros((self.model.nv, len(velocities)))
        for k, name in enumerate(velocities):
            joint, entry = self.joint(name)
            planar = "Planar" in joint.shortname()
            place = (2 if planar and entry == "wz" else VELOCITIES[entry]) if entry else 0
            self.project[joint.idx_v + place, k] = 1.0
        for follower, (leader, multiplier, _) in self.followers.items():
            row, of = (self.model.joints[self.model.getJointId(name)].idx_v for name in (follower, leader))
            self.project[row] = multiplier * self.project[of]
        alone = np.count_nonzero(self.project, axis=1) == 1
        assert np.all(alone), f"other joints: {velocities} and {self.joints}"

    def slides(self):
        """Which of the coordinates, in the order of q, are lengths."""
        return ["JointModelP" in j.shortname() and "Planar" not in j.shortname() or entry in ("x", "y", "z") for j, entry in self.coordinates]

    def quaternions(self):
        """Where those begin, in the order of q."""
        return [k for k, (_, entry) in enumerate(self.coordinates) if entry == "qx"]

    def leaves(self):
        """Links that carry nothing, those with the most joints before them first."""
        bodies = [frame for frame in self.model.frames if frame.type == pin.BODY]
        carrying = {self.model.frames[frame.parentFrame].parentFrame for frame in bodies}
        at = {frame.name: self.model.getFrameId(frame.name, pin.BODY) for frame in bodies}
        leaves = [frame for frame in bodies if at[frame.name] not in carrying]
        depth = {frame.name: len(self.model.supports[frame.parentJoint]) for frame in leaves}
        return [frame.name for frame in sorted(leaves, key=lambda frame: -depth[frame.name])]

    def configuration(self, q):
        """q as Pinocchio has it: an angle without limits is a cosine and a sine."""
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
        for follower, (leader, multiplier, offset) in self.followers.items():
            follower, leader = (self.model.getJointId(name) for name in (follower, leader))
            self.put(full, self.model.joints[follower], multiplier * values[leader] + offset)
        return full

    def put(self, full, joint, value):
        turns = joint.nq == 2
        full[joint.idx_q : joint.idx_q + joint.nq] = [np.cos(value), np.sin(value)] if turns else value

    def vector(self, values):
        return self.project @ values

    def dynamics(self, state):
        """The functions of the whole robot; the mass matrix tells whether the others exist."""
        model, data = self.model, self.data
        q = self.configuration(state["q"])
        v, a = (self.vector(state[key]) for key in ("qd", "qdd"))
        gather = self.project.T
        mass = gather @ whole(pin.crba(model, data, q)) @ self.project
        bias = gather @ pin.rnea(model, data, q, v, 0 * v)
        if self.followers:
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
        """The smallest eigenvalue of the mass matrix over postures inside the limits, in units of the
        largest, each joint on a scale of its own."""
        rng = np.random.default_rng(0)
        low = np.maximum(self.model.lowerPositionLimit, -np.pi)
        high = np.maximum(low, np.minimum(self.model.upperPositionLimit, np.pi))

        def mass():
            q = pin.normalize(self.model, rng.uniform(low, high))
            return self.project.T @ whole(pin.crba(self.model, self.data, q)) @ self.project

        return min(spread(mass()) for _ in range(samples))

    def kinematics(self, state, link):
        """The functions of a link's frame."""
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
            # Of one joint it is a vector.
            rows = pin.getFrameJacobian(model, data, frame, axes).reshape(6, model.nv)
            return np.vstack([rows[3:], rows[:3]]) @ self.project

        spin = pin.skew(velocity.angular)
        rate = pin.skew(acceleration.angular) + spin @ spin
        return {
            "forward_kinematics": pose.homogeneous,
            "spatial_jacobian": jacobian(pin.WORLD),
            "body_jacobian": jacobian(pin.LOCAL),
            "geometric_jacobian": jacobian(pin.LOCAL_WORLD_ALIGNED),
            "velocity": beside(spin, velocity.linear - spin @ pose.translation),
            "acceleration": beside(rate, acceleration.linear - rate @ pose.translation),
        }


def beside(block, column):
    matrix = np.zeros((4, 4))
    matrix[:3, :3], matrix[:3, 3] = block, column
    return matrix


def whole(upper):
    """The symmetric matrix of which the upper triangle is given."""
    upper = np.triu(upper)
    return upper + np.triu(upper, 1).T


def spread(mass):
    """The smallest eigenvalue in units of the largest, of a matrix whose diagonal is made one."""
    root = np.sqrt(np.maximum(np.diag(mass), 0.0))
    if np.any(root == 0.0):
        return 0.0
    values = np.linalg.eigvalsh(mass / np.outer(root, root))
    return values[0] / values[-1]
