"""Collision spheres: distances by their centres, derivatives by differences and in libraries, and what is refused."""

import numpy as np
import pytest
from conftest import REPOSITORY, ROBOTS, library

import homogen

FILE = REPOSITORY / "tests/robots/two_arms.urdf"


@pytest.fixture(scope="module")
def arms():
    with pytest.warns(homogen.DescriptionWarning, match="is no sphere"):
        return homogen.load(FILE, collision=True)


def test_spheres_have_names_and_radii(arms):
    assert arms.sphere_names[:3] == ("stand", "torso_1", "torso_2")
    assert arms.radii.shape == (9,) and arms.radii[0] == 0.2
    assert len(arms.pair_names) == 22 and arms.pair_names[-1] == "left_hand/right_hand"


def test_distances_are_those_of_the_centers(arms):
    q = arms.random(1, (4, 3))
    centers, distances = arms.sphere_centers(q), arms.distances(q)
    assert centers.shape == (4, 3, 9, 3) and distances.shape == (4, 3, 22)
    for k, pair in enumerate(arms.pair_names):
        a, b = (arms.sphere_names.index(name) for name in pair.split("/"))
        expected = np.linalg.norm(centers[..., a, :] - centers[..., b, :], axis=-1) - arms.radii[a] - arms.radii[b]
        np.testing.assert_allclose(distances[..., k], expected, atol=1e-14)


def test_jacobians_are_the_derivatives_of_distances(arms):
    q = arms.random(2, 5)
    jacobian = arms.distance_jacobian(q)
    assert jacobian.shape == (5, 22, 5)
    for k in range(5):
        step = np.zeros(5)
        step[k] = 1e-5
        expected = (arms.distances(q + step) - arms.distances(q - step)) / 2e-5
        np.testing.assert_allclose(jacobian[..., k], expected, atol=1e-6)


def test_named_pairs_alone_have_distances():
    hands = homogen.load(FILE, collision=["left_hand:right_hand", "stand:right_hand"], floating=True, functions=["distances"])
    assert hands.pair_names == ("stand/right_hand", "left_hand/right_hand")
    assert hands.distances(hands.neutral()).shape == (2,)


def test_torch_differentiates_distances(arms):
    torch = library("torch")
    q = torch.tensor(arms.random(3), requires_grad=True)
    arms.torch.distances(q)[4].backward()
    np.testing.assert_allclose(q.grad.numpy(), arms.distance_jacobian(q.detach().numpy())[4], atol=1e-14)


def test_a_robot_without_spheres_has_no_distances():
    arm = homogen.load(ROBOTS / "two_link.urdf")
    assert "distances" not in dir(arm) and arm.sphere_names == () and arm.radii.shape == (0,)
    with pytest.raises(AttributeError, match="has no spheres, and distances is of robots with spheres"):
        arm.distances  # noqa: B018
    with pytest.raises(ValueError, match="no collision spheres"):
        homogen.load(ROBOTS / "two_link.urdf", collision=True)
