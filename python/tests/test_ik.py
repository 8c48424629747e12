"""Inverse kinematics: reachable poses, poses out of reach, and what is refused."""

import numpy as np
import pytest
from conftest import ROBOTS, robot, same

import homogen


@pytest.fixture(scope="module")
def of():
    return robot("arm")


@pytest.mark.parametrize("file,options", [("panda_class.urdf", {"tip": "link8"}), ("ur5_class.urdf", {"tip": "tool0"})])
def test_reachable_poses_are_reached(file, options):
    of = homogen.load(ROBOTS / file, **options)
    targets = of.forward_kinematics(of.random(5, (20, 25)))
    found = of.inverse_kinematics(targets)
    assert found.q.shape == (20, 25, of.NQ) and found.converged.shape == (20, 25)
    assert found.converged.mean() >= 0.998
    assert ((found.q >= of.lower) & (found.q <= of.upper)).all()
    off = np.abs(of.forward_kinematics(found.q) - targets).max((-2, -1))
    assert (off[found.converged] < 4e-6).all()
    assert (found.orientation_error[found.converged] <= 1e-6).all()


def test_each_target_is_solved_as_if_it_were_alone(of):
    targets = of.forward_kinematics(of.random(6, 30))
    several = of.inverse_kinematics(targets)
    for k in (0, 7, 29):
        one = of.inverse_kinematics(targets[k])
        assert one.q.shape == (7,) and one.converged == several.converged[k]
        assert np.allclose(one.q, several.q[k], atol=1e-9)
    assert same(of.inverse_kinematics(targets).q, several.q)


def test_starts_and_frames_are_named(of):
    q = of.random(8, 5)
    target = of.forward_kinematics(q, frame="link5")
    found = of.inverse_kinematics(target, q + 0.01, frame="link5")
    assert found.converged.all()
    # From a start beside it the search ends beside it.
    assert np.abs(found.q - q).max() < 0.2
    exact = of.inverse_kinematics(target, q, frame="link5", restarts=0)
    assert same(exact.q, q)
    grid = of.inverse_kinematics(target[:, None], q[:3], frame="link5", restarts=0)
    assert grid.q.shape == (5, 3, 7)


def test_a_pose_out_of_reach_is_approached(of):
    far = np.eye(4)
    far[0, 3] = 3.0
    found = of.inverse_kinematics(far, restarts=4)
    assert found.converged.dtype == bool and not found.converged and found.position_error > 1.9
    assert np.isfinite(found.q).all()
    near = of.inverse_kinematics(far, orientation_tolerance=np.inf, restarts=4)
    assert not near.converged and near.position_error > 1.9


def test_half_turns_have_an_axis():
    from homogen._ik import _rotation_vector

    rng = np.random.default_rng(1)
    axis = rng.normal(size=(200, 3))
    axis /= np.linalg.norm(axis, axis=-1, keepdims=True)
    for angle in [0.0, 1e-12, 1e-6, 0.5, 2.0, np.pi - 1e-9, np.pi]:
        skew = np.cross(np.eye(3), axis[:, None, :])
        turn = np.eye(3) + np.sin(angle) * skew + (1 - np.cos(angle)) * skew @ skew
        found = _rotation_vector(turn)
        assert np.allclose(np.linalg.norm(found, axis=-1), angle, rtol=1e-9, atol=1e-15)
        off = np.minimum(np.abs(found - angle * axis).max(-1), np.abs(found + angle * axis).max(-1) if angle > 3 else np.inf)
        assert (off < 1e-8).all(), angle


def test_what_cannot_be_meant_is_refused(of):
    pose = np.stack([np.eye(4)] * 3)
    pose[1, 0, 0] = 1.1
    for wrong, words in [
        (pose, r"pose\[1\] is no pose"),
        (np.full((4, 4), np.nan), "pose is no pose"),
        (np.diag([-1.0, 1, 1, 1]), "pose is no pose"),
        (np.eye(3), r"pose has the shape \(3, 3\)"),
    ]:
        with pytest.raises(ValueError, match=words):
            of.inverse_kinematics(wrong)
    with pytest.raises(ValueError, match=r"start has the shape \(6,\)"):
        of.inverse_kinematics(np.eye(4), np.zeros(6))
    with pytest.raises(ValueError, match="restarts"):
        of.inverse_kinematics(np.eye(4), restarts=-1)
    for case in ("floating", "loop"):
        with pytest.raises(ValueError, match="quaternions, planar joints or loops"):
            robot(case).inverse_kinematics(np.eye(4))
