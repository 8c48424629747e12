"""Plain Python: the bits of compiled code where sines have the same, and what runs it."""

import math

import numpy as np
import pytest
from conftest import CASES, ROBOTS, functions, robot, same, states

import homogen
from homogen._library import flat


class OwnSines:
    """A library for arrays with the sines of compiled code: entries of the pose of one joint."""

    joint = homogen.load("link base;\njoint turn: revolute(z);\nlink arm;", reproducible=True)
    sqrt, sign = np.sqrt, np.sign

    @classmethod
    def sin(cls, angle):
        return cls.joint.forward_kinematics(np.asarray(angle)[..., None])[..., 1, 0]

    @classmethod
    def cos(cls, angle):
        return cls.joint.forward_kinematics(np.asarray(angle)[..., None])[..., 0, 0]


def computed(function, arguments, shapes, library):
    """Results for states in rows, in the shapes of compiled code."""
    found = function(*(np.moveaxis(array, 0, -1) for array in arguments), library=library)
    found = found if isinstance(found, tuple) else (found,)
    count = len(arguments[0])
    arrays = []
    for result, (_, shape) in zip(found, shapes):
        entries = [np.broadcast_to(np.asarray(entry, float), count) for entry in flat(result)]
        arrays.append(np.stack(entries, axis=-1).reshape(count, *shape))
    return arrays


@pytest.mark.parametrize("order", ["linear_first", "angular_first"])
@pytest.mark.parametrize("case", CASES)
def test_results_have_the_bits_of_compiled_code(case, order):
    of = robot(case, order=order, reproducible=True)
    compared = 0
    for name, function in functions(of):
        arguments = states(of, function.parameters()[0], 19, float)
        expected = function(*arguments)
        expected = expected if isinstance(expected, tuple) else (expected,)
        _, shapes = function.arrays()
        plain = getattr(of.plain, name)
        for found, wanted in zip(computed(plain, arguments, shapes, OwnSines), expected, strict=True):
            assert same(found, wanted), name
        # The sines of NumPy are other ones, within a unit of the last place.
        for found, wanted in zip(computed(plain, arguments, shapes, np), expected):
            assert np.allclose(found, wanted, rtol=1e-9, atol=1e-9 * (1 + np.abs(wanted).max())), name
        compared += 1
    assert compared > 10


def test_numbers_and_lists_are_enough(arm):
    q, qd, qdd = states(arm, ["q", "qd", "qdd"], 1, float)
    found = arm.plain.inverse_dynamics(q[0].tolist(), qd[0].tolist(), qdd[0].tolist())
    assert all(type(torque) is float for torque in found)
    assert np.allclose(found, arm.inverse_dynamics(q[0], qd[0], qdd[0]), rtol=1e-12)
    pose = arm.plain.of("forward_kinematics", frame="link3")(q[0])
    assert pose[3] == [0.0, 0.0, 0.0, 1.0]
    assert np.allclose(pose, arm.forward_kinematics(q[0], frame="link3"))
    with pytest.raises(AttributeError, match="no function 'gravty' for plain"):
        arm.plain.gravty


def test_fields_are_keywords():
    of = homogen.load(ROBOTS / "two_link.urdf", fields={"load": "mass_of:fore", "down": "gravity", "q_1": "damping_of:elbow"})
    of.load, of.down, of.q_1 = 1.5, [0.1, 0.2, -1.6], 0.3
    q, qd, qdd = states(of, ["q", "qd", "qdd"], 1, float)
    # The parameter of a field is another where an entry of an argument has its name.
    found = of.plain.inverse_dynamics(q[0], qd[0], qdd[0], load=1.5, down=[0.1, 0.2, -1.6], q_1_=0.3)
    assert np.allclose(found, of.inverse_dynamics(q[0], qd[0], qdd[0]), rtol=1e-12)
    with pytest.raises(TypeError, match="load"):
        of.plain.gravity(q[0])


def test_a_file_has_all_functions_and_the_robot(tmp_path):
    of = robot("floating")
    text = of.generate("python", output=tmp_path / "quadruped.py")
    assert text is None
    text = (tmp_path / "quadruped.py").read_text()
    assert [line for line in text.splitlines() if "import" in line] == ["import math"]
    scope = {}
    exec(compile(text, "quadruped.py", "exec"), scope)
    assert scope["NQ"] == of.NQ and scope["COORDINATES"] == list(of.coordinate_names)
    assert scope["UPPER"] == of.upper.tolist() and scope["NEUTRAL"] == of.neutral().tolist()
    q, v = of.random(3), np.linspace(-1, 1, of.NV)
    ahead = scope["integrate"](q, v)
    assert np.allclose(ahead, of.integrate(q, v)) and np.allclose(scope["difference"](q, ahead), v)
    assert np.allclose(scope["spatial_jacobian"](q), of.spatial_jacobian(q))
    angular = robot("floating", order="angular_first")
    exec(angular.generate("python", "spatial_jacobian"), scope)
    assert np.allclose(scope["spatial_jacobian"](q), of.spatial_jacobian(q, order="angular_first"))
    assert "Order of six numbers: ω, v; c, f; γ, ρ." in scope["spatial_jacobian"].__doc__


def test_options_of_other_languages_are_refused(arm):
    with pytest.raises(ValueError, match="`processor` is for compiled languages, and not for Python"):
        robot("arm", processor="cortex-m4").generate("python", "gravity")
    with pytest.raises(ValueError, match="`name` is for compiled languages"):
        arm.generate("python", "gravity", name="Arm")


def test_names_of_a_hostile_file_become_no_code():
    names = ['"""; raise SystemExit', "'''\\", "\\N{DASH}", "a\nimport os", "math", "library"]
    links = "".join(f'<link name="{k}"><inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>' for k in range(7))
    joints = "".join(
        f'<joint name="{name.replace(chr(34), "&quot;").replace(chr(10), "&#10;")}" type="continuous"><parent link="{k}"/><child link="{k + 1}"/>'
        f'<origin xyz="0.1 0 0"/><axis xyz="0 1 0"/></joint>'
        for k, name in enumerate(names)
    )
    of = homogen.load(f'<robot name="&quot;&quot;&quot;\\">{links}{joints}</robot>')
    scope = {}
    exec(of.generate("python", "gravity", "forward_kinematics"), scope)
    assert scope["JOINTS"] == list(of.joint_names)
    assert np.allclose(scope["gravity"]([0.1] * 6), of.gravity([0.1] * 6))
    assert {name for name in scope if not name.startswith("__") and name.islower()} == {"math", "gravity", "forward_kinematics"}
    assert math.isclose(scope["gravity"]([0.1] * 6)[5], of.gravity([0.1] * 6)[5], abs_tol=1e-9)
