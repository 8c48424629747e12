"""Values of a robot by MuJoCo.

In: an MJCF file, names of coordinates and velocities, states. Out: every function's values in the order and the
conventions of `homogen eval`, from MuJoCo's own compiled model, without contacts and constraints. It shares no code
and no data with homogen.
"""

import os
from pathlib import Path

import mujoco
import numpy as np

# Substitute for a mesh that is not in the package: its body has an <inertial>, or homogen rejects the file.
TETRAHEDRON = [0, 0, 0, 0.1, 0, 0, 0, 0.1, 0, 0, 0, 0.1]
FACES = [0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3]

FREE, BALL, SLIDE = (int(kind) for kind in (mujoco.mjtJoint.mjJNT_FREE, mujoco.mjtJoint.mjJNT_BALL, mujoco.mjtJoint.mjJNT_SLIDE))


class Unreadable(Exception):
    """MuJoCo does not read this file."""


def attached(file, mesh):
    """True if a mesh is beside a model that the file attaches, which MuJoCo finds by itself."""
    return any(Path(file).parent.glob(f"*/{mesh}"))


def compiled(file):
    """Returns the model, and True if meshes or textures were missing."""
    try:
        spec = mujoco.MjSpec.from_file(str(file))
        missing = False
        for mesh in spec.meshes:
            folder = os.path.join(os.path.dirname(str(file)), spec.compiler.meshdir)
            if mesh.file and not os.path.exists(os.path.join(folder, mesh.file)) and not attached(file, mesh.file):
                mesh.name = mesh.name or os.path.splitext(os.path.basename(mesh.file))[0]
                mesh.file, mesh.uservert, mesh.userface = "", TETRAHEDRON, FACES
                missing = True
        for texture in spec.textures:
            folder = os.path.join(os.path.dirname(str(file)), spec.compiler.texturedir)
            if texture.file and not os.path.exists(os.path.join(folder, texture.file)):
                texture.file, texture.builtin = "", mujoco.mjtBuiltin.mjBUILTIN_FLAT
                texture.width = texture.height = 1
                missing = True
        return spec.compile(), missing
    except Exception as reason:
        raise Unreadable(str(reason).split("\n")[0]) from reason


class MujocoPeer:
    """A robot as MuJoCo compiles it; mimic joints are independent in the model; their motion is projected here."""

    def __init__(self, file):
        self.model, self.missing = compiled(file)
        flags = mujoco.mjtDisableBit
        for flag in (flags.mjDSBL_CONTACT, flags.mjDSBL_CONSTRAINT, flags.mjDSBL_ACTUATION):
            self.model.opt.disableflags |= flag
        self.data = mujoco.MjData(self.model)

    def without_free_armatures(self):
        """Removes the armatures of free joints, which homogen ignores with a warning."""
        model = self.model
        for joint in range(model.njnt):
            if model.jnt_type[joint] == FREE:
                model.dof_armature[model.jnt_dofadr[joint] :][:6] = 0

    def order(self, mimic_names):
        """Finds the mimic joints by name, and the remaining entries of q and of the velocities."""
        model = self.model
        self.mimics = {}
        for k in range(model.neq):
            if model.eq_type[k] != mujoco.mjtEq.mjEQ_JOINT or model.eq_obj2id[k] < 0 or not model.eq_active0[k]:
                continue
            mimic, mimicked = model.eq_obj1id[k], model.eq_obj2id[k]
            if model.joint(mimic).name in mimic_names and mimic not in self.mimics:
                a, b = model.eq_data[k][:2]
                y, x = (model.qpos0[model.jnt_qposadr[joint]] for joint in (mimic, mimicked))
                self.mimics[mimic] = (mimicked, b, y + a - b * x)
        self.joints = [joint for joint in range(model.njnt) if joint not in self.mimics]
        self.velocities = [v for joint in self.joints for v in self.entries(joint)]
        self.nq = sum({FREE: 7, BALL: 4}.get(int(model.jnt_type[joint]), 1) for joint in self.joints)

    def entries(self, joint):
        first = self.model.jnt_dofadr[joint]
        return range(first, first + {FREE: 6, BALL: 3}.get(int(self.model.jnt_type[joint]), 1))

    def translations(self):
        """True for each coordinate, in the order of q, that is a length."""
        kinds = {FREE: [True] * 3 + [False] * 4, BALL: [False] * 4, SLIDE: [True]}
        return [is_length for joint in self.joints for is_length in kinds.get(int(self.model.jnt_type[joint]), [False])]

    def quaternions(self):
        """Indices in q at which quaternions begin."""
        found, at = [], 0
        for joint in self.joints:
            kind = int(self.model.jnt_type[joint])
            if kind in (FREE, BALL):
                found.append(at + (3 if kind == FREE else 0))
            at += {FREE: 7, BALL: 4}.get(kind, 1)
        return found

    def place(self, state):
        """Sets q, and converts velocities to those of MuJoCo, where linear ones of a free joint are in the world frame."""
        model, data = self.model, self.data
        rest = list(state["q"])
        values = {}
        for joint in self.joints:
            kind, at = int(model.jnt_type[joint]), model.jnt_qposadr[joint]
            if kind in (FREE, BALL):
                position = [rest.pop(0) for _ in range(3)] if kind == FREE else []
                x, y, z, w = (rest.pop(0) for _ in range(4))
                data.qpos[at : at + len(position) + 4] = [*position, w, x, y, z]
            else:
                values[joint] = data.qpos[at] = rest.pop(0)
        for mimic in self.mimics:
            data.qpos[model.jnt_qposadr[mimic]] = self.mimic_value(mimic, values)
        mujoco.mj_kinematics(model, data)
        mujoco.mj_comPos(model, data)
        self.project = np.zeros((model.nv, len(self.velocities)))
        for k, v in enumerate(self.velocities):
            self.project[v, k] = 1.0
        for mimic in self.mimics:
            mimicked, factor = self.independent(mimic)
            self.project[model.jnt_dofadr[mimic]] = factor * self.project[model.jnt_dofadr[mimicked]]
        rate = np.array(state["qd"])
        self.rest = np.zeros(model.nv)
        for k, joint in ((self.velocities.index(model.jnt_dofadr[j]), j) for j in self.joints):
            if model.jnt_type[joint] == FREE:
                at = model.jnt_dofadr[joint]
                turn = np.zeros(9)
                mujoco.mju_quat2Mat(turn, data.qpos[model.jnt_qposadr[joint] + 3 :][:4])
                turn = turn.reshape(3, 3)
                self.project[at : at + 3, k : k + 3] = turn
                self.rest[at : at + 3] = turn @ np.cross(rate[k + 3 : k + 6], rate[k : k + 3])
        data.qvel[:] = self.project @ rate
        mujoco.mj_fwdPosition(model, data)
        mujoco.mj_fwdVelocity(model, data)

    def independent(self, joint):
        """The independent joint that a mimic joint depends on, and the factor between their velocities."""
        factor = 1.0
        while joint in self.mimics:
            joint, own, _ = self.mimics[joint]
            factor *= own
        return joint, factor

    def mimic_value(self, joint, values):
        """The coordinate of a joint, computed from the mimicked one if it is a mimic joint."""
        if joint in values:
            return values[joint]
        mimicked, factor, offset = self.mimics[joint]
        return factor * self.mimic_value(mimicked, values) + offset

    def torques(self, acceleration):
        """M q̈ + h, without springs, friction and armature."""
        self.data.qacc[:] = acceleration
        torques = np.zeros(self.model.nv)
        mujoco.mj_rne(self.model, self.data, 1, torques)
        return torques

    def dynamics(self, state, rotors):
        """Values of the functions of the whole robot."""
        model, data = self.model, self.data
        self.place(state)
        gather = self.project.T
        armature = np.array(model.dof_armature)
        for k in range(model.nu):
            joint = model.actuator_trnid[k, 0]
            if model.actuator_trntype[k] == mujoco.mjtTrn.mjTRN_JOINT:
                armature[model.jnt_dofadr[joint]] += model.actuator_gear[k, 0] ** 2 * model.actuator_armature[k]
        full = np.zeros((model.nv, model.nv))
        mujoco.mj_fullM(model, data, full)
        if not rotors:
            full -= np.diag(armature)
            armature = 0 * armature
        mass = gather @ full @ self.project
        acceleration = self.project @ np.array(state["qdd"]) + self.rest
        inverse = gather @ (self.torques(acceleration) + armature * acceleration)
        bias = gather @ (self.torques(self.rest) + armature * self.rest)
        tau = np.array(state["tau"])
        forward = np.linalg.lstsq(mass, tau - bias, rcond=None)[0]
        gravity = self.gravity(state)
        return {
            "inverse_dynamics": inverse,
            "gravity": gravity,
            "bias": bias,
            "mass_matrix": mass,
            "forward_dynamics": forward,
            "tau": tau,
        }

    def gravity(self, state):
        self.data.qvel[:] = 0
        mujoco.mj_fwdVelocity(self.model, self.data)
        gravity = self.project.T @ self.torques(np.zeros(self.model.nv))
        self.place(state)
        return gravity

    def configurations(self):
        """The keyframes with names, each in the order of q."""
        model, found = self.model, {}
        for key in range(model.nkey):
            q = []
            for joint in self.joints:
                kind, at = int(model.jnt_type[joint]), model.jnt_qposadr[joint]
                count = {FREE: 7, BALL: 4}.get(kind, 1)
                own = model.key_qpos[key, at : at + count]
                if kind in (FREE, BALL):
                    turn = own[-4:] / np.linalg.norm(own[-4:])
                    own = [*own[:-4], *turn[1:], turn[0]]
                q += list(own)
            if model.key(key).name:
                found[model.key(key).name] = q
        return found

    def bodies(self):
        """Names of bodies without children, the last first, and of sites."""
        model = self.model
        carrying = set(model.body_parentid[1:])
        names = [("body", model.body(k).name) for k in reversed(range(1, model.nbody)) if k not in carrying]
        sites = [("site", model.site(k).name) for k in range(model.nsite)]
        return [(kind, name) for kind, name in names if name] + [(kind, name) for kind, name in sites if name]

    def kinematics(self, state, kind, name):
        """The pose and the Jacobian of a body or a site."""
        model, data = self.model, self.data
        self.place(state)
        found = data.body(name) if kind == "body" else data.site(name)
        pose = np.eye(4)
        pose[:3, :3], pose[:3, 3] = found.xmat.reshape(3, 3), found.xpos
        body = model.body(name).id if kind == "body" else model.site(name).bodyid[0]
        rows = np.zeros((2, 3, model.nv))
        mujoco.mj_jac(model, data, rows[1], rows[0], np.array(found.xpos), body)
        return {
            "forward_kinematics": pose,
            "geometric_jacobian": np.vstack([rows[0], rows[1]]) @ self.project,
        }
