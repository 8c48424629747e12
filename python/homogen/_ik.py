"""Inverse kinematics over arrays of poses: configurations at which a frame is at its target.

Damped least squares with damping proportional to the squared error, within the limits of the joints, and restarts from other
configurations, as `homogen::ik` in Rust. Each target is solved as if it were alone.
"""

import numpy as np

from . import results

#: Maximum number of evaluations from one start.
_EVALUATIONS = 64
#: Damping, in squared errors, beyond which no step helps.
_MOST_DAMPING = 1e4
#: Share of the squared error above which a step is slow, and how many slow steps end a search.
_SLOW, _PATIENCE = 0.95, 8
#: Largest difference of R Rᵀ from 1 that is rounding of printed digits.
_ROUNDING = 1e-6


def inverse_kinematics(robot, pose, start, frame, tolerance, length, restarts):
    """The best configurations, whether they meet the tolerance, and their errors."""
    if not robot._is_euclidean or robot.constraint_names:
        raise ValueError(f"{robot.name!r} has quaternions, planar joints or loops: its inverse kinematics are not solved")
    if restarts < 0 or not length > 0 or not min(tolerance) >= 0:
        raise ValueError("restarts and tolerances are from 0 on, and length is positive")
    pose = np.asarray(pose, float)
    if pose.shape[-2:] != (4, 4):
        raise ValueError(f"pose has the shape {pose.shape}, and must have (..., 4, 4)")
    _check_poses(pose)
    n = robot.NQ
    first = _middle(robot) if start is None else np.asarray(start, float)
    if first.shape[-1:] != (n,) or not np.isfinite(first).all():
        raise ValueError(f"start has the shape {first.shape}, and must have (..., {n}) of finite numbers")
    axes = np.broadcast_shapes(pose.shape[:-2], first.shape[:-1])
    targets = np.broadcast_to(pose, (*axes, 4, 4)).reshape(-1, 4, 4)
    first = np.broadcast_to(first, (*axes, n)).reshape(-1, n)
    found = _Search(robot, targets, frame, length)
    # The same configurations at each call and for each target.
    rng = np.random.default_rng(0)
    left = np.arange(len(targets))
    for attempt in range(restarts + 1):
        if not left.size:
            break
        begin = first[left] if attempt == 0 else _anywhere(robot, first[left], rng.random(n))
        found.descend(left, np.clip(begin, robot.lower, robot.upper), tolerance)
        left = np.flatnonzero(~found.is_met(tolerance))
    return results.InverseKinematics(
        found.q.reshape(*axes, n),
        found.is_met(tolerance).reshape(axes)[()],
        found.angle.reshape(axes)[()],
        found.distance.reshape(axes)[()],
    )


def _check_poses(pose):
    turn = pose[..., :3, :3]
    # Where entries are not finite nothing is at most anything.
    with np.errstate(all="ignore"):
        square = turn @ np.swapaxes(turn, -1, -2)
        is_rotation = (np.abs(square - np.eye(3)) <= _ROUNDING).all((-2, -1)) & (np.linalg.det(turn) > 0)
    is_pose = is_rotation & np.isfinite(pose).all((-2, -1)) & (pose[..., 3, :] == [0, 0, 0, 1]).all(-1)
    if not is_pose.all():
        place = tuple(map(int, np.argwhere(~is_pose)[0]))
        raise ValueError(f"pose{list(place) or ''} is no pose: a rotation orthogonal to 1e-6, a finite translation, 0, 0, 0, 1")


def _middle(robot):
    """The middle of the limits; without limits the neutral configuration."""
    is_bounded = np.isfinite(robot.lower) & np.isfinite(robot.upper)
    middle = np.clip(robot.neutral(), robot.lower, robot.upper)
    middle[is_bounded] = ((robot.lower + robot.upper) / 2)[is_bounded]
    return middle


def _anywhere(robot, first, part):
    """Parts of the way between limits; without limits within π of the first start."""
    is_bounded = np.isfinite(robot.lower) & np.isfinite(robot.upper)
    lower, upper = (np.where(is_bounded, limit, 0) for limit in (robot.lower, robot.upper))
    return np.where(is_bounded, lower + part * (upper - lower), first + (2 * part - 1) * np.pi)


class _Search:
    """The best configuration for each target."""

    def __init__(self, robot, targets, frame, length):
        self._robot, self._targets, self._frame, self._length = robot, targets, frame, length
        count = len(targets)
        self.q = np.zeros((count, robot.NQ))
        self.cost, self.angle, self.distance = (np.full(count, np.inf) for _ in range(3))

    def is_met(self, tolerance):
        return (self.angle <= tolerance[0]) & (self.distance <= tolerance[1])

    def descend(self, which, q, tolerance):
        """Descends for some targets from a start each, and keeps what is better than before."""
        own = self._errors(which, q)
        damping, slow = np.full(len(which), 0.1), np.zeros(len(which), int)
        is_open = np.isfinite(own["cost"])
        for _ in range(1, _EVALUATIONS):
            is_open &= (own["angle"] > tolerance[0]) | (own["distance"] > tolerance[1])
            is_open &= ~self._is_stationary(own)
            some = np.flatnonzero(is_open)
            if not some.size:
                break
            at = {name: array[some] for name, array in own.items()}
            step = self._step(at, damping[some] * at["cost"])
            following = self._errors(which[some], np.clip(at["q"] + step, self._robot.lower, self._robot.upper))
            is_better = following["cost"] < at["cost"]
            is_slow = ~is_better | (following["cost"] > _SLOW * at["cost"])
            slow[some] = np.where(is_slow, slow[some] + 1, 0)
            damping[some] = np.where(is_better, np.maximum(damping[some] / 4, 1e-4), damping[some] * 4)
            for name, array in own.items():
                array[some[is_better]] = following[name][is_better]
            is_open &= (damping <= _MOST_DAMPING) & (slow < _PATIENCE)
        is_better = own["cost"] < self.cost[which]
        for name in ("q", "cost", "angle", "distance"):
            getattr(self, name)[which[is_better]] = own[name][is_better]

    def _errors(self, which, q):
        """Errors at configurations, JᵗJ and Jᵗe; an angle of 1 rad weighs as much as the length."""
        pose = self._robot.forward_kinematics(q, frame=self._frame)
        jacobian = self._robot.geometric_jacobian(q, frame=self._frame, order="linear_first")
        target = self._targets[which]
        turn = self._length * _rotation_vector(target[:, :3, :3] @ np.swapaxes(pose[:, :3, :3], -1, -2))
        error = np.concatenate([target[:, :3, 3] - pose[:, :3, 3], turn], -1)
        jacobian[:, 3:] *= self._length
        transposed = np.swapaxes(jacobian, -1, -2)
        return {
            "q": q,
            "cost": np.sum(error * error, -1),
            "angle": np.linalg.norm(turn, axis=-1) / self._length,
            "distance": np.linalg.norm(error[:, :3], axis=-1),
            "square": transposed @ jacobian,
            "gradient": (transposed @ error[..., None])[..., 0],
        }

    def _stops(self, q, direction):
        """Joints that a limit stops in a direction."""
        return (direction < 0) & (q <= self._robot.lower) | (direction > 0) & (q >= self._robot.upper)

    def _is_stationary(self, at):
        """True where the error is perpendicular to all motions of the joints that may move."""
        gradient = at["gradient"]
        diagonal = np.diagonal(at["square"], axis1=-2, axis2=-1)
        is_small = gradient * gradient <= 1e-8 * at["cost"][:, None] * diagonal
        return (is_small | self._stops(at["q"], gradient)).all(-1)

    def _step(self, at, damping):
        """(JᵗJ + damping) step = Jᵗe, over the joints that no limit stops."""
        n = self._robot.NQ
        epsilon = np.finfo(float).eps
        damping = damping + 16 * epsilon * np.trace(at["square"], axis1=-2, axis2=-1) + np.finfo(float).tiny
        full = at["square"] + damping[:, None, None] * np.eye(n)
        is_free = np.ones(at["q"].shape, bool)
        while True:
            pairs = is_free[:, :, None] & is_free[:, None, :]
            matrix = np.where(pairs, full, np.eye(n))
            step = np.linalg.solve(matrix, np.where(is_free, at["gradient"], 0)[..., None])[..., 0]
            stopped = is_free & self._stops(at["q"], step)
            # Each pass stops a joint or is the last one.
            if not stopped.any():
                return step
            is_free &= ~stopped


def _rotation_vector(turn):
    """The axis of rotation matrices (..., 3, 3) times the angle, from 0 to π."""
    # Four times the products of the entries of the quaternion w, x, y, z; its largest entry is where the diagonal is.
    diagonal = np.diagonal(turn, axis1=-2, axis2=-1)
    x, y, z = np.moveaxis(diagonal, -1, 0)
    products = np.empty((*turn.shape[:-2], 4, 4))
    for k, entry in enumerate([1 + x + y + z, 1 + x - y - z, 1 - x + y - z, 1 - x - y + z]):
        products[..., k, k] = entry
    for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        products[..., 0, k + 1] = products[..., k + 1, 0] = turn[..., j, i] - turn[..., i, j]
        products[..., i + 1, j + 1] = products[..., j + 1, i + 1] = turn[..., i, j] + turn[..., j, i]
    largest = np.argmax(np.diagonal(products, axis1=-2, axis2=-1), -1)
    quaternion = np.take_along_axis(products, largest[..., None, None], -2)[..., 0, :]
    quaternion = np.where(quaternion[..., :1] < 0, -quaternion, quaternion)
    axis = quaternion[..., 1:]
    sine = np.linalg.norm(axis, axis=-1, keepdims=True)
    angle = 2 * np.arctan2(sine, quaternion[..., :1])
    # Where the sine vanishes the angle is twice the axis by the cosine.
    return axis * np.where(sine > 0, angle / np.where(sine > 0, sine, 1), 0)
