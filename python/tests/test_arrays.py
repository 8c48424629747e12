"""Arrays: leading axes, layouts, types, places for results, and what is refused."""

import numpy as np
import pytest
from conftest import robot, same, states


@pytest.fixture(scope="module")
def of():
    return robot("arm")


def test_leading_axes_are_broadcast(of):
    q, qd, qdd = states(of, ["q", "qd", "qdd"], 24, float)
    flat = of.inverse_dynamics(q, qd, qdd)
    axes = [array.reshape(2, 3, 4, 7) for array in (q, qd, qdd)]
    assert same(of.inverse_dynamics(*axes), flat.reshape(2, 3, 4, 7))
    grid = of.inverse_dynamics(q[:5, None], qd[:20], qdd[0])
    each = [[of.inverse_dynamics(q[i], qd[j], qdd[0]) for j in range(20)] for i in range(5)]
    assert same(grid, np.array(each))
    turned = of.inverse_dynamics(*(array.transpose(2, 0, 1, 3) for array in axes))
    assert same(turned, flat.reshape(2, 3, 4, 7).transpose(2, 0, 1, 3))
    for shape in [(0,), (2, 0), (0, 3)]:
        empty = np.zeros((*shape, 7))
        assert of.mass_matrix(empty).shape == (*shape, 7, 7)
        assert of.inverse_dynamics(empty, qd[0], qdd[0]).shape == (*shape, 7)


def test_arrays_are_read_as_they_lie(of):
    (q,) = states(of, ["q"], 20, float)
    gravity = of.gravity(q)
    wide = np.full((40, 8), np.nan)
    wide[::2, :7] = q
    shifted = np.zeros(q.nbytes + 1, np.uint8)[1:].view(float).reshape(q.shape)
    shifted[...] = q
    locked = q.copy()
    locked.flags.writeable = False
    for layout, array in {
        "with gaps": wide[::2, :7],
        "by columns": np.asfortranarray(q),
        "backwards": q[::-1][::-1],
        "each backwards": np.ascontiguousarray(q[:, ::-1])[:, ::-1],
        "of the other order of bytes": q.astype(">f8"),
        "not aligned": shifted,
        "read-only": locked,
        "lists": q.tolist(),
        "a class of its own": q.view(type("Own", (np.ndarray,), {})),
    }.items():
        assert same(of.gravity(array), gravity), layout
        assert same(of.gravity(array[3]), gravity[3]), f"one, {layout}"
    assert same(of.gravity(q=q), gravity)


def test_types_decide_the_precision(of):
    q, qd = states(of, ["q", "qd"], 20, np.float32)
    assert of.bias(q, qd).dtype == np.float32
    wide = of.bias(q.astype(float), qd.astype(float))
    assert same(of.bias(q, qd.astype(float)), wide)
    assert of.kinetic_energy(q[0], qd[0]).dtype == np.float32
    assert isinstance(of.kinetic_energy(q[0], qd[0]), np.float32)
    assert same(of.gravity(q.astype(np.float16)), of.gravity(q.astype(np.float16).astype(float)))
    assert same(of.gravity([1, 2, 3, 4, 5, 6, 7]), of.gravity(np.arange(1.0, 8)))


def test_what_would_lose_something_is_refused(of):
    (q,) = states(of, ["q"], 3, float)
    for wrong in [q.astype(complex), q.astype(object), q.astype(str), q.astype(np.longdouble), None, "q", [1j] * 7]:
        with pytest.raises(TypeError, match="q is of "):
            of.gravity(wrong)
    with pytest.raises(TypeError, match="mask would be lost"):
        of.gravity(np.ma.masked_less(q, 0))
    with pytest.raises(ValueError, match="q is no array"):
        of.gravity([[1, 2], [3]])


@pytest.mark.parametrize("shape", [(8,), (7, 1), (), (3, 6)])
def test_shapes_are_named(of, shape):
    with pytest.raises(ValueError, match=r"q has the shape \(.*\), and must have \(\.\.\., 7\)"):
        of.gravity(np.zeros(shape))


def test_leading_axes_that_differ_are_named(of):
    with pytest.raises(ValueError, match=r"cannot be broadcast together: q \(12,\), qd \(5,\)"):
        of.bias(np.zeros((12, 7)), np.zeros((5, 7)))


def test_calls_that_cannot_be_meant_are_refused(of):
    q = np.zeros(7)
    for call, words in [
        (lambda: of.bias(q), "qd is missing"),
        (lambda: of.gravity(q, q), "2 were given"),
        (lambda: of.gravity(q, q=q), "q was given twice"),
        (lambda: of.gravity(q, frame="link3"), "it has no keyword frame"),
        (lambda: of.gravity(q, order="linear_first"), "it has no keyword order"),
    ]:
        with pytest.raises(TypeError, match=words):
            call()
    with pytest.raises(ValueError, match="order is"):
        of.spatial_jacobian(q, order="angular")


def test_results_go_where_they_are_wanted(of):
    q, qd, tau = states(of, ["q", "qd", "tau"], 20, float)
    expected = of.bias(q, qd)
    out = np.full((20, 7), np.nan)
    assert of.bias(q, qd, out=out) is out and same(out, expected)
    one = np.full(7, np.nan)
    assert of.bias(q[4], qd[4], out=one) is one and same(one, expected[4])
    wide = np.full((20, 9), np.nan)
    of.bias(q, qd, out=wide[:, 1:8])
    assert same(wide[:, 1:8], expected) and np.isnan(wide[:, [0, 8]]).all()
    pose = np.full((20, 4, 4), np.nan)
    assert same(of.forward_kinematics(q, out=pose), of.forward_kinematics(q))
    parts = [np.full((20, 7, 7), np.nan) for _ in range(3)]
    found = of.forward_dynamics_derivatives(q, qd, tau, out=parts)
    assert found.dtau is parts[2]
    assert all(same(*pair) for pair in zip(found, of.forward_dynamics_derivatives(q, qd, tau)))
    columns = np.full((7, 20), np.nan).T
    assert of.bias(q, qd, out=columns) is columns and same(columns, expected)
    turned = np.full((4, 4, 20), np.nan).transpose(2, 1, 0)
    assert same(of.forward_kinematics(q, out=turned), of.forward_kinematics(q))
    spread = np.full((20, 4, 8), np.nan)[..., ::2]
    assert same(of.forward_kinematics(q, out=spread), of.forward_kinematics(q))
    energy = np.array(np.nan)
    assert of.potential_energy(q[0], out=energy) == of.potential_energy(q[0]) == energy


def test_results_may_take_the_place_of_arguments(of):
    q, qd = states(of, ["q", "qd"], 40, float)
    expected = of.bias(q, qd)
    taken = qd.copy()
    of.bias(q, taken, out=taken)
    assert same(taken, expected)
    parts = np.full((20, 7, 7), np.nan)
    of.inverse_dynamics_derivatives(q[:20], qd[:20], qd[:20], out=[parts, parts])
    assert same(parts, of.inverse_dynamics_derivatives(q[:20], qd[:20], qd[:20]).dqd)
    both = np.concatenate([qd, qd[:1]])
    of.bias(q, both[:-1], out=both[1:])
    assert same(both[1:], expected)


def test_wrong_places_for_results_are_refused(of):
    q = np.zeros((3, 7))
    locked = np.zeros((3, 7))
    locked.flags.writeable = False
    for out, error, words in [
        (np.zeros((2, 7)), ValueError, r"out for gravity has the shape \(2, 7\), and must have \(3, 7\)"),
        (np.zeros((3, 7), np.float32), TypeError, "must be an array of float64"),
        (locked, ValueError, "read-only"),
        ([0.0] * 7, TypeError, "must be an array"),
    ]:
        with pytest.raises(error, match=words):
            of.gravity(q, out=out)
    with pytest.raises(ValueError, match="2 arrays"):
        of.inverse_dynamics_derivatives(q, q, q, out=[np.zeros((3, 7, 7))])


def test_a_state_is_what_it_is_alone(of):
    q, qd, qdd = states(of, ["q", "qd", "qdd"], 40, float)
    right = of.inverse_dynamics(q, qd, qdd)
    q[5], qd[11, 0], qdd[17], q[23] = np.nan, np.inf, np.nan, 1e5
    found = of.inverse_dynamics(q, qd, qdd)
    strange = [5, 11, 17, 23]
    others = np.setdiff1d(np.arange(40), strange)
    assert same(found[others], right[others])
    assert np.isnan(found[5]).all() and np.isnan(found[17]).any() and np.isfinite(found[23]).all()
    alone = np.array([of.inverse_dynamics(q[k], qd[k], qdd[k]) for k in strange])
    assert np.array_equal(found[strange], alone, equal_nan=True)


def test_threads_change_no_bit():
    one, several = robot("arm", threads=1), robot("arm", threads=5)
    arguments = states(one, ["q", "qd", "qdd"], 100_001, float)
    assert same(one.inverse_dynamics(*arguments), several.inverse_dynamics(*arguments))
    grid = [arguments[0][:400, None], arguments[1][None, :300], arguments[2][0]]
    assert same(one.inverse_dynamics(*grid), several.inverse_dynamics(*grid))
    q = arguments[0]
    assert same(one.forward_kinematics(q), several.forward_kinematics(q))
