"""Robots of Pinocchio's own unit tests, which its library makes: every value and derivative that these tests assert there."""

import numpy as np
import pytest
from conftest import REPOSITORY, library

import homogen

SAMPLES = ["Manipulator", "Humanoid", "HumanoidRandom"]


@pytest.fixture(scope="module", params=SAMPLES)
def sample(request):
    """A model of Pinocchio, its data, and the same robot."""
    pin = library("pinocchio")
    model = getattr(pin, f"buildSampleModel{request.param}")()
    floating = model.joints[1].shortname() == "JointModelFreeFlyer"
    of = homogen.load(description(pin, model), floating=floating, external=[link(model, model.njoints - 1)])
    assert (of.NQ, of.NV) == (model.nq, model.nv)
    return pin, model, model.createData(), of


def link(model, joint):
    return f"link_of_{model.names[joint]}"


def row(values):
    return " ".join(repr(float(value)) for value in values)


def description(pin, model):
    """A model as URDF. A free root is the root link of a floating base."""
    text = ["<robot name='sample'>"]
    first = 2 if model.joints[1].shortname() == "JointModelFreeFlyer" else 1
    if first == 1:
        text.append("<link name='base'/>")
    for joint in range(1, model.njoints):
        inertia = model.inertias[joint]
        second = inertia.inertia
        entries = " ".join(f"i{'xyz'[a]}{'xyz'[b]}='{float(second[a, b])!r}'" for a in range(3) for b in range(a, 3))
        text.append(
            f"<link name='{link(model, joint)}'><inertial><origin xyz='{row(inertia.lever)}'/>"
            f"<mass value='{inertia.mass!r}'/><inertia {entries}/></inertial></link>"
        )
    for joint in range(first, model.njoints):
        parent = model.parents[joint]
        placement = model.jointPlacements[joint]
        axis = {"JointModelRX": "1 0 0", "JointModelRY": "0 1 0", "JointModelRZ": "0 0 1"}[model.joints[joint].shortname()]
        angles = pin.rpy.matrixToRpy(placement.rotation)
        text.append(
            f"<joint name='{model.names[joint]}' type='continuous'><parent link='{link(model, parent) if parent else 'base'}'/>"
            f"<child link='{link(model, joint)}'/><origin xyz='{row(placement.translation)}' rpy='{row(angles)}'/>"
            f"<axis xyz='{axis}'/></joint>"
        )
    return "\n".join([*text, "</robot>"])


def close(found, wanted):
    return np.allclose(found, wanted, rtol=1e-9, atol=1e-9 * (1 + np.abs(wanted).max()))


def state(pin, model):
    """A configuration, and two vectors over velocities."""
    rng = np.random.default_rng(0)
    q = pin.integrate(model, pin.neutral(model), rng.uniform(-1, 1, model.nv))
    return q, *rng.uniform(-1, 1, (2, model.nv))


@pytest.fixture(scope="module")
def same_order(sample):
    """Joints stand in the same order, so that arrays are the same."""
    pin, model, _, of = sample
    names = [model.names[joint] for joint in range(1, model.njoints)]
    own = [name for name in of.joint_names if name != "root"]
    assert own == [name for name in names if name != "root_joint"]


@pytest.mark.usefixtures("same_order")
def test_rnea_bias_gravity_and_external_forces(sample):
    pin, model, data, of = sample
    q, v, a = state(pin, model)
    none = np.zeros((1, 6))
    torques = pin.rnea(model, data, q, v, a)
    assert close(of.inverse_dynamics(q, v, a, none), torques)
    bias = pin.nonLinearEffects(model, data, q, v)
    assert close(of.bias(q, v), bias)
    assert close(of.gravity(q), pin.computeGeneralizedGravity(model, data, q))
    assert close(of.mass_matrix(q) @ a + of.bias(q, v), torques)
    wrench = np.random.default_rng(1).uniform(-1, 1, 6)
    wrenches = [pin.Force.Zero() for _ in range(model.njoints - 1)] + [pin.Force(wrench)]
    wanted = pin.rnea(model, data, q, v, a, wrenches)
    assert close(of.inverse_dynamics(q, v, a, wrench[None], order="linear_first"), wanted)
    assert close(of.forward_dynamics(q, v, wanted, wrench[None], order="linear_first"), a)


@pytest.mark.usefixtures("same_order")
def test_crba_aba_and_the_inverse_of_the_mass_matrix(sample):
    pin, model, data, of = sample
    q, v, tau = state(pin, model)
    mass = pin.crba(model, data, q)
    assert close(np.triu(of.mass_matrix(q)), np.triu(mass))
    accelerations = pin.aba(model, data, q, v, tau)
    assert close(of.forward_dynamics(q, v, tau, np.zeros((1, 6))), accelerations)
    inverse = pin.computeMinverse(model, data, q)
    assert close(np.triu(of.mass_matrix_inverse(q)), np.triu(inverse))


@pytest.mark.usefixtures("same_order")
def test_derivatives_of_rnea_and_aba(sample):
    pin, model, data, of = sample
    q, v, a = state(pin, model)
    none = np.zeros((1, 6))
    by_q, by_v, by_a = pin.computeRNEADerivatives(model, data, q, v, a)
    found = of.inverse_dynamics_derivatives(q, v, a, none)
    assert close(found.dq, by_q) and close(found.dqd, by_v)
    assert close(np.triu(of.mass_matrix(q)), np.triu(by_a))
    assert close(of.gravity_derivative(q), pin.computeGeneralizedGravityDerivatives(model, data, q))
    found = of.forward_dynamics_derivatives(q, v, a, none)
    for one, other in zip(found, pin.computeABADerivatives(model, data, q, v, a)):
        assert close(one, other)
    assert close(of.coriolis_matrix(q, v) @ v, pin.computeCoriolisMatrix(model, data, q, v) @ v)


@pytest.mark.usefixtures("same_order")
def test_centre_of_mass_momentum_and_energies(sample):
    pin, model, data, of = sample
    q, v, a = state(pin, model)
    assert close(of.center_of_mass(q), pin.centerOfMass(model, data, q))
    assert close(of.center_of_mass_jacobian(q), pin.jacobianCenterOfMass(model, data, q))
    assert close(of.centroidal_momentum_matrix(q, order="linear_first"), pin.computeCentroidalMap(model, data, q))
    assert close(of.kinetic_energy(q, v), pin.computeKineticEnergy(model, data, q, v))
    assert close(of.potential_energy(q), pin.computePotentialEnergy(model, data, q))
    pin.forwardKinematics(model, data, q, v, a)
    last = model.njoints - 1
    assert close(of.forward_kinematics(q, frame=link(model, last)), data.oMi[last].homogeneous)
    pin.computeJointJacobians(model, data, q)
    jacobian = pin.getJointJacobian(model, data, last, pin.LOCAL)
    assert close(of.body_jacobian(q, frame=link(model, last), order="linear_first"), jacobian)


def test_distances_of_spheres_and_their_derivatives():
    pin = library("pinocchio")
    file = str(REPOSITORY / "tests/robots/two_arms.urdf")
    of = homogen.load(file, collision=True)
    model = pin.buildModelFromUrdf(file)
    shapes = pin.buildGeomFromUrdf(model, file, pin.GeometryType.COLLISION)
    places = [list(model.names[1:]).index(name) for name in of.joint_names]
    # Pinocchio counts the shapes of each link from 0, boxes among them.
    numbers = {shape.name: k for k, shape in enumerate(shapes.geometryObjects)}
    links = [name.rsplit("_", 1) for name in numbers]
    several = {link for link, _ in links if f"{link}_1" in of.sphere_names}
    called = {f"{link}_{int(k) + 1}" if link in several else link: f"{link}_{k}" for link, k in reversed(links)}
    for pair in of.pair_names:
        shapes.addCollisionPair(pin.CollisionPair(*(numbers[called[name]] for name in pair.split("/"))))
    data, measured = model.createData(), shapes.createData()
    for own in of.random(1, 20):
        q = np.empty(model.nq)
        q[places] = own
        pin.computeJointJacobians(model, data, q)
        pin.updateGeometryPlacements(model, data, shapes, measured)
        pin.computeDistances(shapes, measured)
        assert close(of.distances(own), [result.min_distance for result in measured.distanceResults])
        rows = []
        for pair in shapes.collisionPairs:
            centers = [measured.oMg[shape].translation for shape in (pair.first, pair.second)]
            normal = (centers[0] - centers[1]) / np.linalg.norm(centers[0] - centers[1])
            speeds = np.zeros(model.nv)
            for shape, center, sign in zip((pair.first, pair.second), centers, (1, -1), strict=True):
                joint = shapes.geometryObjects[shape].parentJoint
                twists = pin.getJointJacobian(model, data, joint, pin.ReferenceFrame.WORLD) if joint else np.zeros((6, model.nv))
                speeds += sign * normal @ (twists[:3] + np.cross(twists[3:].T, center).T)
            rows.append(speeds[places])
        assert close(of.distance_jacobian(own), np.array(rows))
