"""Values of a robot by Drake.

In: an SDF file, names of coordinates, states. Out: every function's values in the order of `homogen eval`. The base is
welded where the file places it. It shares no code and no data with homogen.
"""

import logging

import numpy as np
from pydrake.multibody.parsing import Parser
from pydrake.multibody.plant import MultibodyPlant
from pydrake.multibody.tree import ModelInstanceIndex, MultibodyForces, PrismaticJoint

logging.getLogger("drake").setLevel(logging.ERROR)


class Unreadable(Exception):
    """Drake does not read this file."""


class DrakePeer:
    """A robot as Drake reads it."""

    def __init__(self, file):
        try:
            self.plant = MultibodyPlant(0.0)
            parser = Parser(self.plant)
            part = file.parent / "part"
            if part.exists():
                parser.package_map().Add("part", str(part))
            parser.AddModels(str(file))
            self.weld()
            self.plant.Finalize()
        except Exception as reason:
            raise Unreadable(str(reason).split("\n")[0]) from reason
        self.context = self.plant.CreateDefaultContext()
        self.joints = {}
        for index in self.plant.GetJointIndices():
            joint = self.plant.get_joint(index)
            self.joints[self.name_of(joint)] = joint

    def weld(self):
        """Welds the body that no joint moves, at its pose."""
        plant = self.plant
        moved = {int(plant.get_joint(index).child_body().index()) for index in plant.GetJointIndices()}
        bodies = [plant.get_body(index) for index in plant.GetBodyIndices(plant.GetModelInstanceByName("robot"))]
        for body in bodies:
            if int(body.index()) not in moved:
                plant.WeldFrames(plant.world_frame(), body.body_frame(), plant.GetDefaultFloatingBaseBodyPose(body))

    def name_of(self, item):
        """The name with those of the models around it, without that of the robot."""
        instance = self.plant.GetModelInstanceName(item.model_instance())
        prefix = instance.removeprefix("robot").removeprefix("::")
        return f"{prefix}::{item.name()}" if prefix else item.name()

    def order(self, coordinates):
        """Finds the entries of q by the names of homogen."""
        self.entries = []
        for name in coordinates:
            joint, _, which = name.partition(".")
            # Drake files a joint under the model of its child.
            joint = self.joints.get(joint) or self.joints[f"sub::{joint}"]
            self.entries.append((joint, 1 if which == "second" else 0))
        self.velocities = [joint.velocity_start() + k for joint, k in self.entries]

    def size(self):
        return self.plant.num_velocities()

    def translations(self):
        """True for each coordinate that is a length."""
        return [isinstance(joint, PrismaticJoint) for joint, _ in self.entries]

    def place(self, state):
        q = np.zeros(self.plant.num_positions())
        v = np.zeros(self.plant.num_velocities())
        for (joint, k), position, rate in zip(self.entries, state["q"], state["qd"]):
            q[joint.position_start() + k] = position
            v[joint.velocity_start() + k] = rate
        self.plant.SetPositions(self.context, q)
        self.plant.SetVelocities(self.context, v)

    def dynamics(self, state):
        """Values of the functions of the whole robot."""
        self.place(state)
        plant, context, at = self.plant, self.context, self.velocities
        mass = plant.CalcMassMatrix(context)
        gravity = -plant.CalcGravityGeneralizedForces(context)
        bias = plant.CalcBiasTerm(context) + gravity
        acceleration = np.zeros(plant.num_velocities())
        acceleration[at] = state["qdd"]
        inverse = plant.CalcInverseDynamics(context, acceleration, MultibodyForces(plant)) + gravity
        return {
            "inverse_dynamics": inverse[at],
            "gravity": gravity[at],
            "bias": bias[at],
            "mass_matrix": mass[np.ix_(at, at)],
        }

    def frames(self):
        """Links and named frames, by their names."""
        found = {}
        for instance in range(2, self.plant.num_model_instances()):
            for index in self.plant.GetFrameIndices(ModelInstanceIndex(instance)):
                frame = self.plant.get_frame(index)
                # The file has no frames of joints and models.
                if frame.name()[:1] in ("l", "f") and len(frame.name()) == 2:
                    found[self.name_of(frame)] = frame
        return found

    def pose(self, state, frame):
        self.place(state)
        return frame.CalcPoseInWorld(self.context).GetAsMatrix4()
