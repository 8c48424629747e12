"""Values: the bits of `homogen eval` where no product fuses, and laws that every layout keeps."""

import numpy as np
import pytest
from conftest import CASES, HOMOGEN, LONG, ROBOTS, evaluated, functions, robot, same, states

import homogen

needs_eval = pytest.mark.skipif(HOMOGEN is None, reason="HOMOGEN names no command line")


def laid_out(expected, shape):
    """What `homogen eval` has as a 4×4 matrix of a skew block and a vector, as six numbers, angular first."""
    if expected.shape[1:] == (4, 4) and shape == (6,):
        turn = np.stack([expected[:, 2, 1], expected[:, 0, 2], expected[:, 1, 0]], axis=1)
        return np.concatenate([turn, expected[:, :3, 3]], axis=1)
    return expected


#: Without HOMOGEN_LONG a table of joints is left out, whose functions have the shapes of the arm's.
COMPARED = [case for case in CASES if LONG or case != "table"]


# The floating quadruped has its functions in single precision in `tests/llvm/run.sh`.
@needs_eval
@pytest.mark.parametrize(
    ("case", "dtype"),
    [(case, dtype) for case in COMPARED for dtype in ("float64", "float32") if (case, dtype) != ("floating", "float32")],
)
def test_every_function_has_the_bits_of_eval(case, dtype, tmp_path):
    of = robot(case, reproducible=True, order="angular_first", threads=1)
    compared = 0
    for name, function in functions(of):
        names, _ = function.parameters()
        arguments = states(of, names, 19, dtype)
        found = function(*arguments)
        parts = list(getattr(found, "_fields", [name]))
        found = list(found) if isinstance(found, tuple) else [found]
        expected = evaluated(case, name, dict(zip(names, arguments)), parts, dtype, tmp_path)
        for part, array, wanted in zip(parts, found, expected):
            wanted = laid_out(wanted, array.shape[1:])
            assert same(array, wanted), f"{name}, {part}"
        if dtype == "float64":
            one = function(*(argument[7] for argument in arguments))
            one = list(one) if isinstance(one, tuple) else [one]
            assert all(same(single, array[7]) for single, array in zip(one, found)), f"{name}: one state"
        compared += 1
    assert compared > 10


@pytest.mark.parametrize("case", COMPARED)
def test_without_reproducible_values_differ_by_rounding_alone(case):
    fused, plain = (robot(case, order="angular_first", reproducible=bits) for bits in (False, True))
    for name, function in functions(plain):
        arguments = states(plain, function.parameters()[0], 17, float)
        pairs = [f(*arguments) for f in (function, getattr(fused, name))]
        for one, other in zip(*(pair if isinstance(pair, tuple) else [pair] for pair in pairs)):
            assert np.allclose(one, other, rtol=1e-9, atol=1e-9 * (1 + np.abs(one).max())), name


@pytest.mark.parametrize("case", ["arm", "floating"])
def test_jacobians_map_velocities_to_twists_in_either_order(case):
    for order in ("linear_first", "angular_first"):
        of = robot(case, order=order)
        q, qd = states(of, ["q", "qd"], 20, float)
        twist = np.einsum("sij,sj->si", of.spatial_jacobian(q), qd)
        assert np.allclose(twist, of.velocity(q, qd))
        momentum = np.einsum("sij,sj->si", of.centroidal_momentum_matrix(q), qd)
        assert np.allclose(momentum, of.centroidal_momentum(q, qd))
        other = {"linear_first": "angular_first", "angular_first": "linear_first"}[order]
        swapped = of.spatial_jacobian(q, order=other)
        assert same(swapped, np.roll(of.spatial_jacobian(q), 3, axis=-2))


def test_forces_from_outside_have_the_order_of_jacobians():
    of = homogen.load(ROBOTS / "panda_class.urdf", tip="link8", external="link8")
    q, qd, qdd, actions = states(of, ["q", "qd", "qdd", "actions"], 20, float)
    free = of.inverse_dynamics(q, qd, qdd, np.zeros_like(actions))
    for order in ("linear_first", "angular_first"):
        torques = np.einsum("sij,si->sj", of.body_jacobian(q, order=order), actions[:, 0])
        assert np.allclose(of.inverse_dynamics(q, qd, qdd, actions, order=order), free - torques)


def test_any_frame_is_one_of_the_robot():
    of = homogen.load(ROBOTS / "quadruped.urdf")
    q = of.random(3, 5)
    with pytest.raises(ValueError, match="need a tip"):
        of.forward_kinematics(q)
    for frame in of.frames:
        pose = of.forward_kinematics(q, frame=frame)
        named = homogen.load(ROBOTS / "quadruped.urdf", tip=frame)
        assert same(pose, named.forward_kinematics(q)), frame
        assert same(pose[:, 3], np.broadcast_to([0.0, 0, 0, 1], (5, 4)))
    with pytest.raises(ValueError, match="nose"):
        of.forward_kinematics(q, frame="nose")


def test_several_frames_are_an_axis():
    of = homogen.load(ROBOTS / "quadruped.urdf", floating=True)
    q, frames = of.random(3, (5, 4)), of.frames
    poses = of.forward_kinematics(q, frame=frames)
    assert poses.shape == (5, 4, len(frames), 4, 4)
    for k, frame in enumerate(frames):
        assert same(poses[..., k, :, :], of.forward_kinematics(q, frame=frame))
    out = np.full((len(frames), 4, 4), np.nan)
    assert of.forward_kinematics(q[1, 2], frame=list(frames), out=out) is out and same(out, poses[1, 2])
    feet = of.geometric_jacobian(q[0], frame=["fl_foot", "hr_foot"])
    assert feet.shape == (4, 2, 6, 18) and same(feet[:, 1], of.geometric_jacobian(q[0], frame="hr_foot"))
    assert of.forward_kinematics(q, frame=[]).shape == (5, 4, 0, 4, 4)
    with pytest.raises(TypeError, match="frame is the name of a link"):
        of.forward_kinematics(q, frame=3)


def test_fields_take_the_place_of_numbers():
    fields = {"load": "mass_of:fore", "down": "gravity"}
    of = homogen.load(ROBOTS / "two_link.urdf", fields=fields)
    plain = homogen.load(ROBOTS / "two_link.urdf")
    q, qd, qdd = states(of, ["q", "qd", "qdd"], 20, float)
    assert np.allclose(of.inverse_dynamics(q, qd, qdd), plain.inverse_dynamics(q, qd, qdd), rtol=1e-14)
    mass = of.load
    text = (ROBOTS / "two_link.urdf").read_text()
    assert text.count(f'<mass value="{mass}"/>') == 1
    of.load, of.down = 2 * mass, [0, 0, -1.62]
    assert of.fields["load"] == 2 * mass and of.down.tolist() == [0, 0, -1.62]
    heavy = text.replace(f'<mass value="{mass}"/>', f'<mass value="{2 * mass}"/>')
    moon = homogen.load(heavy, gravity=[0, 0, -1.62])
    for dtype, error in [(np.float64, 1e-13), (np.float32, 1e-4)]:
        arguments = [array.astype(dtype) for array in (q, qd, qdd)]
        found = of.inverse_dynamics(*arguments)
        assert found.dtype == dtype and np.allclose(found, moon.inverse_dynamics(q, qd, qdd), rtol=error, atol=error)


@pytest.mark.parametrize("case", ["arm", "floating"])
def test_configurations_are_integrated_and_subtracted(case):
    of = robot(case)
    q, ahead = of.random(1, 30), of.random(2, 30)
    v = of.difference(q, ahead)
    assert v.shape == (30, of.NV)
    reached = of.integrate(q, v)
    assert np.allclose(of.difference(reached, ahead), 0, atol=1e-12)
    assert np.allclose(of.normalize(reached), reached, atol=1e-12)
    assert same(of.integrate(of.neutral(), np.zeros(of.NV)), of.neutral())
