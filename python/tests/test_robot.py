"""A robot as an object: facts, fields, copies, what it shows, and what is refused of descriptions."""

import copy
import gc
import html
import inspect
import json
import pickle
import pydoc
import subprocess
import sys

import numpy as np
import pytest
from conftest import REPOSITORY, ROBOTS, functions, robot, same, states

import homogen

PANDA = ROBOTS / "panda_class.urdf"


def test_a_robot_describes_itself(arm):
    assert (arm.NQ, arm.NV, arm.base, arm.tip, arm.name) == (7, 7, "link0", "link8", "panda_class")
    assert arm.joint_names == arm.coordinate_names == arm.velocity_names == tuple(f"joint{k}" for k in range(1, 8))
    assert arm.frames == tuple(f"link{k}" for k in range(9))
    for limits in (arm.lower, arm.upper, arm.max_velocity, arm.max_effort):
        assert limits.shape == (7,) and np.isfinite(limits).all()
        with pytest.raises(ValueError):
            limits[0] = 0
    assert (arm.lower < arm.upper).all() and (arm.max_effort > 0).all()
    assert arm.masses.shape == (9,) and arm.masses.sum() > 10
    floating = robot("floating")
    assert (floating.NQ, floating.NV) == (19, 18)
    assert floating.neutral()[:7].tolist() == [0, 0, 0, 0, 0, 0, 1]
    assert floating.lower[0] == -np.inf


def test_random_configurations_are_within_limits():
    for name in ("arm", "floating", "table"):
        of = robot(name)
        q = of.random(7, (50, 3))
        assert q.shape == (50, 3, of.NQ)
        assert (q >= of.lower).all() and (q <= of.upper).all()
        assert same(q, of.random(7, (50, 3))) and of.random().shape == (of.NQ,)
        assert same(of.random(np.random.default_rng(7), (50, 3)), q)
    q = robot("floating").random(1, 100)
    assert np.allclose(np.linalg.norm(q[:, 3:7], axis=1), 1)


def test_base_parameters_make_torques_with_their_regressor(arm):
    q, qd, qdd = np.random.default_rng(2).uniform(-1, 1, (3, 7))
    torques = arm.base_regressor(q, qd, qdd) @ list(arm.base_parameters.values())
    assert np.allclose(torques, arm.inverse_dynamics(q, qd, qdd))


def test_fields_are_attributes():
    of = homogen.load(PANDA, fields={"payload": "payload_on:link8", "mass": "mass_of:link7"}, ranges={"mass": (0, 3)})
    assert of.fields.keys() == {"payload", "mass"} and of.payload.shape == (10,) and isinstance(of.mass, float)
    of.mass = 1
    assert of.mass == 1.0
    for name, value, error, words in [
        ("payload", 1.2, ValueError, r"payload has the shape \(\), and must have \(10,\)"),
        ("mass", [1, 2], ValueError, "mass has the shape"),
        ("mass", np.nan, ValueError, "finite"),
        ("mas", 1.2, AttributeError, "is no field of 'panda_class'; fields are payload, mass"),
        ("gravity", 1.2, AttributeError, "is no field"),
    ]:
        with pytest.raises(error, match=words):
            setattr(of, name, value)
    with pytest.raises(AttributeError):
        del of.mass
    with pytest.raises(ValueError, match="no field can be called 'gravity'"):
        homogen.load(PANDA, fields={"gravity": "gravity"})
    with pytest.raises(ValueError, match="a field cannot stand for `mas_of:link7`"):
        homogen.load(PANDA, fields={"mass": "mas_of:link7"})
    with pytest.raises(ValueError, match="no field 'm'"):
        homogen.load(PANDA, ranges={"m": (0, 1)})


def test_copies_are_equal_and_apart():
    of = homogen.load(PANDA, tip="link8", fields={"mass": "mass_of:link7"})
    q = np.full(7, 0.3)
    of.mass = 2.0
    for other in (copy.copy(of), copy.deepcopy(of), pickle.loads(pickle.dumps(of))):
        assert other == of and hash(other) == hash(of) and other.mass == 2.0
        assert same(other.gravity(q), of.gravity(q))
        other.mass = 3.0
        assert of.mass == 2.0 and other != of
        assert not same(other.gravity(q), of.gravity(q))
    assert of != homogen.load(PANDA, tip="link7", fields={"mass": "mass_of:link7"})
    assert homogen.load(PANDA) == homogen.load(PANDA.read_bytes()) and of != 3
    gravity = pickle.loads(pickle.dumps(of.gravity))
    assert same(gravity(q), of.gravity(q))
    found = of.inverse_dynamics_derivatives(q, q, q)
    again = pickle.loads(pickle.dumps(found))
    assert type(again) is type(found) is homogen.results.InverseDynamicsDerivatives and same(again.dqd, found.dqd)


def test_robots_show_what_they_are(arm):
    assert repr(arm).startswith("<homogen.Robot panda_class: base link0, tip link8; 7 coordinates: joint1, ")
    assert repr(arm.bias) == "<bias: q (..., 7), qd (..., 7) -> (..., 7)>"
    assert str(inspect.signature(arm.body_jacobian)) == "(q, *, frame=None, order=None, out=None)"
    for name, function in functions(arm):
        text = pydoc.render_doc(function)
        assert "q: (..., 7), in rad" in text and "Returns" in text and "out: " in text, name
        assert name in homogen.Robot.__doc__
    assert {"inverse_dynamics", "integrate", "NQ"} < set(dir(arm)) and "constraint" not in dir(arm)
    with pytest.raises(AttributeError, match="robots with loops"):
        arm.constraint
    with pytest.raises(AttributeError, match="'dynamics'"):
        arm.dynamics
    assert homogen.__version__ and "floating: " in homogen.load.__doc__
    assert all(hasattr(homogen, name) for name in homogen.__all__)


def test_what_the_command_line_says_is_said_of_a_robot(arm, tmp_path):
    assert "7 joints, in the order of q" in arm.check()
    counted = arm.count("inverse_dynamics", "gravity")
    assert counted["functions"].keys() == {"inverse_dynamics", "gravity"}
    assert "pub fn gravity" in arm.inspect("gravity")
    assert "pub fn gravity" in arm.generate("rust", "gravity")
    assert arm.generate("c", "gravity", output=tmp_path / "arm.c", scalar="f32") is None
    assert "float" in (tmp_path / "arm.h").read_text() and (tmp_path / "arm.c").exists()
    with pytest.raises(ValueError, match="unknown function"):
        arm.inspect("gravitation")
    held = homogen.load(PANDA, lock={"joint7": 0.25}, fields={"mass": "mass_of:link6"})
    assert held.NQ == 6 and "joint7 at 0.25" in held.check()
    assert "pub mass: f64" in held.generate("rust", "gravity")


def test_options_are_those_of_the_command_line():
    of = homogen.load(
        ROBOTS / "two_link.urdf", gravity=[0, 0, -1.62], damping={"elbow": 0.5}, external=["fore"], formulation=["unfused"]
    )
    assert of._recipe.options == [
        ("gravity", "0,0,-1.62"),
        ("damping", "elbow=0.5"),
        ("external", "fore"),
        ("formulation", "unfused"),
    ]
    with pytest.raises(TypeError, match="no option 'tool'; there are arguments, packages, base, floating, tip"):
        homogen.load(PANDA, tool="link8")
    with pytest.raises(ValueError, match='"link9"'):
        homogen.load(PANDA, tip="link9")
    with pytest.raises(ValueError, match="order is"):
        homogen.load(PANDA, order="linear")
    with pytest.raises(ValueError, match="threads"):
        homogen.load(PANDA, threads=0)


def test_mistakes_have_their_places():
    with pytest.raises(FileNotFoundError, match="cannot read no.urdf"):
        homogen.load("no.urdf")
    with pytest.raises(ValueError, match=r"^<text>:1:"):
        homogen.load("<robot><link/></robot>")
    text = PANDA.read_text().replace('<mass value="', '<mass value="-', 1)
    with pytest.raises(ValueError, match="mass"):
        homogen.load(text)


def test_doubtful_input_is_a_warning():
    text = '<robot name="r"><link name="a"/><joint name="j" type="revolute"><parent link="a"/><child link="b"/>'
    text += '<axis xyz="0 0 2"/><limit lower="-1" upper="1" effort="1" velocity="1"/></joint><link name="b"><inertial>'
    text += '<mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link></robot>'
    with pytest.warns(homogen.DescriptionWarning, match="axis"):
        of = homogen.load(text)
    assert len(of.warnings) == 1
    with pytest.raises(ValueError, match="strict"):
        homogen.load(text, strict=True)


def test_names_of_a_hostile_file_become_no_code():
    of = homogen.load(REPOSITORY / "tests/python/hostile.urdf")
    assert of.name == "None" and of.coordinate_names[0] == "class"
    q = of.random(0, 20)
    for name, function in functions(of):
        arguments = states(of, function.parameters()[0], 20, float)
        found = function(*arguments)
        assert np.isfinite(found[0] if isinstance(found, tuple) else found).all(), name
    for frame in of.frames:
        assert of.forward_kinematics(q, frame=frame).shape == (20, 4, 4)
    for text in ("<!DOCTYPE a [<!ENTITY b SYSTEM 'file:///etc/passwd'>]><robot name='&b;'/>", "<" * 100_000, "\0\n"):
        with pytest.raises(ValueError):
            homogen.load(text)


HOSTILE_XACRO = """<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:property name="x" value="${{{}}}"/>
  <link name="a"/><link name="b"/>
  <joint name="j" type="continuous"><parent link="a"/><child link="b"/><origin xyz="${{x}} 0 0"/></joint>
</robot>"""


@pytest.mark.parametrize(
    "expression",
    [
        "__import__('os').system('touch PATH')",
        "open('PATH', 'w').write('1')",
        "[c for c in ().__class__.__base__.__subclasses__()]",
        "exec('open(0)')",
        "load_yaml('/etc/passwd')",
        "9**9**9**9",
        "'a' * 10**10",
    ],
)
def test_expressions_of_a_hostile_file_run_nothing(expression, tmp_path):
    path = tmp_path / "arm.xacro"
    path.write_text(HOSTILE_XACRO.format(expression.replace("PATH", str(tmp_path / "made"))))
    with pytest.raises(ValueError):
        homogen.load(path)
    assert sorted(entry.name for entry in tmp_path.iterdir()) == ["arm.xacro"]


def test_a_hostile_name_is_text_in_a_notebook():
    text = PANDA.read_text().replace("link8", "&lt;/script>&lt;script>alert(1)&lt;/script>&quot; onload=&quot;alert(1)")
    frame = homogen.load(text)._repr_html_()
    page = html.unescape(frame.split('"')[1])
    assert frame.count('"') == 6 and "<script>alert" not in page and 'sandbox="allow-scripts"' in frame


def test_robots_that_are_dropped_leave_nothing():
    # A process of its own: what the others keep does not count.
    program = f"""
import gc, homogen, json, threading
def resident():
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * 4096
def once(k=0):
    named = [] if k % 10 else ["gravity", "mass_matrix"]
    of = homogen.load({str(ROBOTS / "two_link.urdf")!r}, fields={{"m": "mass_of:fore"}}, functions=named)
    of.m = 2.0
    of.gravity([0.1, 0.2]); of.bias([[0.1, 0.2]] * 20, [0.3, 0.4])
for _ in range(100):
    once()
gc.collect(); before = resident()
for k in range(1000):
    once(k)
for thread in threading.enumerate():
    if thread.name == "homogen":
        thread.join()
gc.collect()
assert not homogen._compile._loaded
print(json.dumps(resident() - before))
"""
    if not sys.platform.startswith("linux"):
        pytest.skip("memory is read from /proc")
    grown = json.loads(subprocess.run([sys.executable, "-c", program], check=True, capture_output=True, text=True).stdout)
    assert grown < 1000 * 4096
    gc.collect()


def test_a_notebook_shows_the_robot_that_moves(arm):
    frame = arm._repr_html_()
    assert frame.startswith('<iframe srcdoc="') and frame.count('"') == 6
    page = html.unescape(frame.split('"')[1])
    assert page.lstrip().lower().startswith("<!doctype html>") and "panda_class" in page
    assert homogen.load(ROBOTS / "quadruped.urdf", floating=True)._repr_html_().startswith("<iframe")


def test_show_opens_a_page(arm, tmp_path, monkeypatch):
    opened = []
    monkeypatch.setattr("webbrowser.open", opened.append)
    path = arm.show("gravity", output=tmp_path / "arm.html")
    assert opened == [path.as_uri()] and "gravity" in path.read_text(encoding="utf-8")
    with pytest.raises(ValueError, match="gravty"):
        arm.show("gravty", output=path)
