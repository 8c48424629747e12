"""What Pinocchio says of a robot.

In: a URDF file, names of joints in the order of q, states. Out: every function's values
in the order and the conventions of `homogen eval`. It never reads anything of homogen's: that the two
agree is worth something because they share nothing.
"""

import os
import tempfile

import numpy as np
import pinocchio as pin


class Unreadable(Exception):
    """Pinocchio does not read this file."""


def read(file):
    """The model, and what is said on standard error: of a link that it cannot read it complains there,
    and goes on with zeros."""
    standard_error = os.dup(2)
    with tempfile.TemporaryFile() as said:
        os.dup2(said.fileno(), 2)
        try:
            model = pin.buildModelFromUrdf(str(file))
        except Exception as reason:
            raise Unreadable(str(reason)) from reason
        finally:
            os.dup2(standard_error, 2)
            os.close(standard_error)
        said.seek(0)
        return model, said.read().decode(errors="replace")


class Peer:
    """A robot as Pinocchio reads it."""

    def __init__(self, file):
        self.model, said = read(file)
        self.is_sure = "Error" not in said
        self.data = self.model.createData()
        self.joints = list(self.model.names)[1:]

    def order(self, joints):
        """Sets the order of q; the joints must be those of the model, in any order."""
        assert sorted(joints) == sorted(self.joints), f"other joints: {joints} and {self.joints}"
        ids = [self.model.getJointId(name) for name in joints]
        self.ids = ids
        self.columns = [self.model.joints[i].idx_v for i in ids]

    def slides(self):
        """Which of the joints, in the order of q, are prismatic."""
        return ["JointModelP" in self.model.joints[i].shortname() for i in self.ids]

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
        for joint, value in zip(self.ids, q):
            joint = self.model.joints[joint]
            turns = joint.nq == 2
            full[joint.idx_q : joint.idx_q + joint.nq] = [np.cos(value), np.sin(value)] if turns else value
        return full

    def vector(self, values):
        full = np.zeros(self.model.nv)
        full[self.columns] = values
        return full

    def dynamics(self, state):
        """The functions of the whole robot; the mass matrix tells whether the others exist."""
        model, data = self.model, self.data
        q = self.configuration(state["q"])
        v, a, tau = (self.vector(state[key]) for key in ("qd", "qdd", "tau"))
        mass = whole(pin.crba(model, data, q))
        return {
            "inverse_dynamics": pin.rnea(model, data, q, v, a).copy()[self.columns],
            "gravity": pin.computeGeneralizedGravity(model, data, q).copy()[self.columns],
            "bias": pin.rnea(model, data, q, v, 0 * v).copy()[self.columns],
            "mass_matrix": mass[np.ix_(self.columns, self.columns)],
            "forward_dynamics": pin.aba(model, data, q, v, tau).copy()[self.columns],
        }

    def least_conditioned(self, samples=20000):
        """The smallest eigenvalue of the mass matrix over postures inside the limits, in units of the
        largest, each joint on a scale of its own."""
        rng = np.random.default_rng(0)
        low = np.maximum(self.model.lowerPositionLimit, -np.pi)
        high = np.maximum(low, np.minimum(self.model.upperPositionLimit, np.pi))
        return min(
            spread(whole(pin.crba(self.model, self.data, rng.uniform(low, high)))) for _ in range(samples)
        )

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
            return np.vstack([rows[3:], rows[:3]])[:, self.columns]

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
