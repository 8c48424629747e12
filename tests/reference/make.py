#!/usr/bin/env python3
"""Makes the reference values of every shipped robot.

In: robots/*.urdf. Out: tests/reference/<robot>.json, 16 random states each with Pinocchio's
results, every f64 in full. The tests read the JSON and never run this script.

    python3 -m venv venv && venv/bin/pip install -r tests/reference/requirements.txt
    venv/bin/python tests/reference/make.py            # all robots
    venv/bin/python tests/reference/make.py scara      # some

Robots in ACTUATORS are also made with armatures and friction, as <robot>_driven.json.

Rejects a robot with non-physical bodies, or whose mass matrix is not positive definite.
"""

import json
import sys
from pathlib import Path

import numpy as np
import pinocchio as pin

HERE = Path(__file__).resolve().parent
ROBOTS = HERE.parent.parent / "robots"
PINOCCHIO = "4.1.0"
STATES = 16

# robot: (the frame whose pose and Jacobians are written, seed of its states)
FRAMES = {
    "two_link": ("tip", 1),
    "scara": ("tool", 2),
    "stanford": ("tool", 3),
    "stanford_general": ("tool", 4),
    "puma560": ("tool", 5),
    "puma560_general": ("tool", 6),
    "ur5_class": ("tool0", 7),
    "panda_class": ("link8", 8),
    "quadruped": ("hr_foot", 9),
}

# The same robots with a floating base, as <robot>_free.
FREE = {"quadruped_free": ("hr_foot", 10)}

# robot: for each joint, armature, damping and friction
ACTUATORS = {
    "stanford_general": (
        [0.95, 2.2, 0.78, 0.11, 0.1, 0.02],
        [3.5, 2.0, 6.25, 0.5, 0.0, 0.25],
        [1.25, 0.0, 4.5, 0.75, 0.5, 0.125],
    ),
}

CONVENTIONS = (
    "SI units; matrices are row-major nested lists; Jacobian rows linear then angular; "
    "gravity (0,0,-9.81); tau = rnea(q,v,a); bias = rnea(q,v,0); ddq = aba(q,v,torque); "
    "gravity_torque = rnea(q,0,0); M_upper is the upper triangle of the mass matrix by rows; "
    "coriolis is the matrix C(q,v) made of Christoffel symbols, bias = coriolis v + gravity_torque; "
    "frame_R, frame_p: rotation and position of the frame relative to the base; "
    "J_local_world_aligned: pole at the frame's origin, axes of the base; "
    "J_world: pole at the base's origin, axes of the base; "
    "frame_linear_velocity and frame_linear_acceleration are those of the frame's origin (the "
    "acceleration is the classical one, the second derivative of frame_p, without gravity), "
    "frame_angular_velocity and frame_angular_acceleration those of the frame, all in axes of the base; "
    "energies of the moving links, potential energy zero at the base's origin"
)
FIXED = "fixed base; "
FLOATING = (
    "free base: q of joint root_joint is x y z and the quaternion x y z w, v is linear then angular, in the "
    "axes of the base; the base of what follows is the frame that it moves in; "
)


def upper(matrix):
    return [float(matrix[i, j]) for i in range(len(matrix)) for j in range(i, len(matrix))]


def rows(matrix):
    return [[float(x) for x in row] for row in np.asarray(matrix)]


def numbers(vector):
    return [float(x) for x in np.asarray(vector)]


def random_states(model, seed):
    """q within the limits (and within a turn), quaternions of unit length, v in ±2, a in ±5, torque in ±20."""
    rng = np.random.default_rng(seed)
    low = np.maximum(model.lowerPositionLimit, -np.pi)
    high = np.minimum(model.upperPositionLimit, np.pi)
    q = rng.uniform(low, high, (STATES, model.nq))
    if model.nq != model.nv:
        q = [pin.normalize(model, one) for one in q]
    v = rng.uniform(-2, 2, (STATES, model.nv))
    a = rng.uniform(-5, 5, (STATES, model.nv))
    torque = rng.uniform(-20, 20, (STATES, model.nv))
    return zip(q, v, a, torque)


def evaluate(model, frame, q, v, a, torque):
    data = model.createData()
    tau = pin.rnea(model, data, q, v, a).copy()
    bias = pin.rnea(model, data, q, v, np.zeros(model.nv)).copy()
    gravity = pin.computeGeneralizedGravity(model, data, q).copy()
    mass = np.triu(pin.crba(model, data, q).copy())
    ddq = pin.aba(model, data, q, v, torque).copy()
    coriolis = pin.computeCoriolisMatrix(model, data, q, v).copy()

    pin.forwardKinematics(model, data, q, v, a)
    pin.updateFramePlacements(model, data)
    pose = data.oMf[frame].copy()
    velocity = pin.getFrameVelocity(model, data, frame, pin.LOCAL_WORLD_ALIGNED)
    acceleration = pin.getFrameClassicalAcceleration(model, data, frame, pin.LOCAL_WORLD_ALIGNED)
    linear, angular = velocity.linear.copy(), velocity.angular.copy()
    linear_rate, angular_rate = acceleration.linear.copy(), acceleration.angular.copy()

    pin.computeJointJacobians(model, data, q)
    aligned = pin.getFrameJacobian(model, data, frame, pin.LOCAL_WORLD_ALIGNED).copy()
    world = pin.getFrameJacobian(model, data, frame, pin.WORLD).copy()
    kinetic = pin.computeKineticEnergy(model, data, q, v)
    potential = pin.computePotentialEnergy(model, data, q)

    whole = mass + np.triu(mass, 1).T
    scale = max(1.0, float(np.max(np.abs(tau))))
    assert np.min(np.linalg.eigvalsh(whole)) > 0, "the mass matrix is not positive definite"
    assert np.allclose(whole @ a + bias, tau, rtol=0, atol=1e-12 * scale)
    assert np.allclose(coriolis @ v + gravity, bias, rtol=0, atol=1e-12 * scale)
    assert np.isclose(v @ whole @ v / 2, kinetic, rtol=1e-12)
    assert np.allclose(aligned @ v, np.concatenate([linear, angular]), rtol=0, atol=1e-12)

    return {
        "q": numbers(q),
        "v": numbers(v),
        "a": numbers(a),
        "torque": numbers(torque),
        "tau": numbers(tau),
        "bias": numbers(bias),
        "gravity_torque": numbers(gravity),
        "ddq": numbers(ddq),
        "M_upper": upper(mass),
        "coriolis": rows(coriolis),
        "frame_R": rows(pose.rotation),
        "frame_p": numbers(pose.translation),
        "frame_angular_velocity": numbers(angular),
        "frame_linear_velocity": numbers(linear),
        "frame_angular_acceleration": numbers(angular_rate),
        "frame_linear_acceleration": numbers(linear_rate),
        "J_local_world_aligned": rows(aligned),
        "J_world": rows(world),
        "kinetic_energy": float(kinetic),
        "potential_energy": float(potential),
    }


def check_bodies(model):
    """Second moments of mass must be positive definite for each body: it could consist of point masses."""
    for name, body in zip(list(model.names)[1:], list(model.inertias)[1:]):
        moments = 0.5 * np.trace(body.inertia) * np.eye(3) - body.inertia
        least = float(np.min(np.linalg.eigvalsh(moments)))
        assert body.mass > 0 and least > 0, f"joint {name} carries a body that is not physical: {least}"


def with_friction(state, damping, friction, ddq):
    """Adds damping v + friction sign(v) to the torques of a state."""
    v = np.array(state["v"])
    resistance = damping * v + friction * np.sign(v)
    tau, bias = np.array(state["tau"]) + resistance, np.array(state["bias"]) + resistance
    fields = ["q", "v", "a", "torque", "gravity_torque", "M_upper", "kinetic_energy"]
    kept = {field: state[field] for field in fields}
    return kept | {"tau": numbers(tau), "bias": numbers(bias), "ddq": numbers(ddq(state, resistance))}


def with_actuators(name):
    """Makes a robot with actuators: armatures by Pinocchio, friction added to its torques."""
    armature, damping, friction = (np.array(each) for each in ACTUATORS[name])
    frame_name, seed = FRAMES[name]
    model = pin.buildModelFromUrdf(str(ROBOTS / f"{name}.urdf"))
    model.armature = armature
    frame = model.getFrameId(frame_name)

    def ddq(state, resistance):
        q, v, torque = (np.array(state[field]) for field in ["q", "v", "torque"])
        return pin.aba(model, model.createData(), q, v, torque - resistance).copy()

    states = [evaluate(model, frame, *state) for state in random_states(model, seed)]
    states = [with_friction(state, damping, friction, ddq) for state in states]
    head = {
        "robot": name,
        "made_with": f"pinocchio {PINOCCHIO}",
        "conventions": CONVENTIONS,
        "armature": numbers(armature),
        "damping": numbers(damping),
        "friction": numbers(friction),
    }
    write(f"{name}_driven", model, head, states)


def make(name):
    frame_name, seed = (FRAMES | FREE)[name]
    root = [pin.JointModelFreeFlyer()] if name in FREE else []
    urdf = name.removesuffix("_free") if name in FREE else name
    model = pin.buildModelFromUrdf(str(ROBOTS / f"{urdf}.urdf"), *root)
    check_bodies(model)
    frame = model.getFrameId(frame_name)
    assert frame < model.nframes, f"{name} has no frame {frame_name}"
    head = {
        "robot": name,
        "urdf": f"robots/{urdf}.urdf",
        "made_with": f"pinocchio {PINOCCHIO}",
        "conventions": (FLOATING if name in FREE else FIXED) + CONVENTIONS,
        "gravity": numbers(model.gravity.linear),
        "nq": model.nq,
        "nv": model.nv,
        "joints": [
            {
                "name": model.names[i],
                "type": model.joints[i].shortname(),
                "idx_q": model.joints[i].idx_q,
                "idx_v": model.joints[i].idx_v,
                "parent": model.names[model.parents[i]],
            }
            for i in range(1, model.njoints)
        ],
        "frame": frame_name,
        "total_mass_of_moving_links": float(sum(body.mass for body in list(model.inertias)[1:])),
    }
    states = [evaluate(model, frame, *state) for state in random_states(model, seed)]
    write(name, model, head, states)


def write(name, model, head, states):
    text = json.dumps(head, separators=(",", ":"))[:-1] + ',"states":[\n'
    text += ",\n".join(json.dumps(state, separators=(",", ":")) for state in states) + "\n]}\n"
    path = HERE / f"{name}.json"
    path.write_text(text, encoding="utf-8")
    print(f"{path.name}: {model.nv} velocities, {len(text) / 1000:.0f} kB")


def main():
    assert pin.__version__ == PINOCCHIO, f"pinocchio {PINOCCHIO} is wanted, {pin.__version__} is here"
    assert set(FRAMES) == {path.stem for path in ROBOTS.glob("*.urdf")}, "FRAMES and robots/ differ"
    for name in sys.argv[1:] or FRAMES | FREE:
        make(name)
        if name in ACTUATORS:
            with_actuators(name)


if __name__ == "__main__":
    main()
