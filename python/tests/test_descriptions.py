"""Descriptions: files that name other files, arguments of xacro, inline texts."""

import copy
import pickle
import shutil

import numpy as np
import pytest
from conftest import ROBOTS, same, states

import homogen

#: The links and joints of two_link.urdf in the grammar of `chain!`.
INLINE = """
// The two-link arm.
link base;
joint shoulder: revolute(z) { at: rpy(pi/2, 0, 0), limits: [-3.14, 3.14], velocity: 4.0 }
link upper { mass: 2.0, com: [0.2, 0, 0], inertia: [0.002, 0.03, 0.03] }
joint elbow: revolute(z) { at: xyz(0.4, 0, 0), limits: [-2.8, 2.8], velocity: 4.0 }
link fore { mass: 1.0, com: [0.15, 0, 0], inertia: [0.001, 0.01, 0.01] }
joint tip: fixed { at: xyz(0.3, 0, 0) }
link tool;
"""

BODY = """
<mujoco>
  <body name="arm">
    <joint name="hinge" axis="0 1 0"/>
    <geom type="mesh" mesh="bob" density="1000"/>
  </body>
</mujoco>
"""

MAIN = """
<mujoco model="pendulum">
  <asset><mesh name="bob" file="bob.obj"/></asset>
  <worldbody><include file="parts/body.xml"/></worldbody>
</mujoco>
"""

#: A tetrahedron with three edges of 0.3 m at right angles: 4.5 kg of water.
BOB = """
v 0 0 0
v 0.3 0 0
v 0 0.3 0
v 0 0 0.3
f 1 3 2
f 1 2 4
f 1 4 3
f 2 3 4
"""


@pytest.fixture(scope="module")
def urdf():
    return homogen.load(ROBOTS / "two_link.urdf")


def torques(of):
    return of.inverse_dynamics(*states(of, ["q", "qd", "qdd"], 20, float))


def test_a_text_of_links_and_joints_is_a_robot(urdf):
    of = homogen.load(INLINE)
    assert (of.name, of.base, of.tip, of.NQ) == ("robot", "base", "tool", 2)
    q, qd, qdd = states(urdf, ["q", "qd", "qdd"], 20, float)
    assert np.allclose(of.inverse_dynamics(q, qd, qdd), urdf.inverse_dynamics(q, qd, qdd), rtol=1e-12)
    assert homogen.load("struct Arm;" + INLINE).name == "Arm"
    assert "struct Robot" in of.generate("rust", "gravity") and "joint" in of.check()
    assert pickle.loads(pickle.dumps(of)) == of
    with pytest.raises(ValueError, match=r"<text>:4:17: .*revolte"):
        homogen.load(INLINE.replace("revolute", "revolte", 1))
    with pytest.raises(ValueError, match=r'<text>:2:3: the setting "tip" stands in a text'):
        homogen.load("struct Arm {\n  tip: tool }" + INLINE)


def test_friction_of_a_text_is_modelled_on_request():
    text = INLINE.replace("[-2.8, 2.8],", "[-2.8, 2.8], damping: 0.5,")
    with pytest.warns(homogen.DescriptionWarning, match='not modelled: damping of joint "elbow"'):
        rigid = homogen.load(text)
    of = homogen.load(text, friction=True)
    q, qd, qdd = states(of, ["q", "qd", "qdd"], 20, float)
    difference = of.inverse_dynamics(q, qd, qdd) - rigid.inverse_dynamics(q, qd, qdd)
    assert np.allclose(difference, qd * [0, 0.5])


def test_mjcf_files_are_read(urdf):
    of = homogen.load(ROBOTS / "two_link.xml")
    q, qd, qdd = states(urdf, ["q", "qd", "qdd"], 20, float)
    assert np.allclose(of.inverse_dynamics(q, qd, qdd), urdf.inverse_dynamics(q, qd, qdd), rtol=1e-12)
    assert "tip" in of.frames


@pytest.fixture
def pendulum(tmp_path):
    """The path of an MJCF file that includes another and names a mesh."""
    (tmp_path / "parts").mkdir()
    (tmp_path / "parts/body.xml").write_text(BODY)
    (tmp_path / "bob.obj").write_text(BOB)
    path = tmp_path / "pendulum.xml"
    path.write_text(MAIN)
    return path


def test_included_files_and_meshes_are_found(pendulum, monkeypatch):
    monkeypatch.chdir(pendulum.parent)
    of = homogen.load("pendulum.xml")
    monkeypatch.chdir("/")
    # MuJoCo moves a mesh's frame to its centre of mass, so that only the inertia remains.
    assert np.isclose(of.masses.sum(), 4.5)
    assert same(torques(copy.deepcopy(of)), torques(of))
    assert same(torques(pickle.loads(pickle.dumps(of))), torques(of))
    assert "pendulum" in of.check() and of.count("gravity")
    shutil.copytree(pendulum.parent, pendulum.parent / "copy")
    assert homogen.load(pendulum.parent / "copy/pendulum.xml") == of


@pytest.mark.parametrize("name", ["bob.obj", "parts/body.xml"])
def test_files_that_have_changed_are_not_used(pendulum, name):
    of = homogen.load(pendulum)
    arguments = states(of, ["q", "qd", "qdd"], 20, float)
    before = of.inverse_dynamics(*arguments)
    file = pendulum.parent / name
    text = file.read_text()
    file.write_text(text.replace("0.3", "0.4").replace("1000", "2000"))
    assert same(of.inverse_dynamics(*arguments), before)
    for use in (lambda: of.gravity([0.1]), of.check, lambda: pickle.loads(pickle.dumps(of))):
        with pytest.raises(ValueError, match="pendulum.xml or a file that it names has changed since it was loaded"):
            use()
    assert homogen.load(pendulum) != of
    file.unlink()
    with pytest.raises(ValueError, match="has changed|cannot include"):
        of.gravity([0.1])


def test_a_file_that_has_changed_is_what_it_was(tmp_path):
    path = tmp_path / "arm.urdf"
    shutil.copy(ROBOTS / "two_link.urdf", path)
    of = homogen.load(path)
    path.unlink()
    assert of.gravity([0.1, 0.2]).shape == (2,) and "two_link" in of.check()


def test_xacro_files_take_arguments(urdf, tmp_path):
    file = ROBOTS / "two_link.urdf.xacro"
    assert same(torques(homogen.load(file)), torques(urdf))
    long = homogen.load(file, arguments={"upper_length": 0.6})
    assert same(torques(long), torques(homogen.load(file, arguments={"upper_length": "0.6"})))
    assert not np.allclose(torques(long), torques(urdf))
    assert long != homogen.load(file) and "two_link" in long.check()
    with pytest.raises(ValueError, match="arguments are given, but the file is not xacro"):
        homogen.load(ROBOTS / "two_link.urdf", arguments={"upper_length": 0.6})


def test_xacro_files_find_packages(tmp_path, monkeypatch):
    (tmp_path / "arms").mkdir()
    shutil.copy(ROBOTS / "two_link.urdf.xacro", tmp_path / "arms/arm.xacro")
    text = """<robot name="held" xmlns:xacro="http://www.ros.org/wiki/xacro">
      <xacro:arg name="is_held" default="false"/>
      <xacro:if value="$(arg is_held)"><link name="hand"/><joint name="grip" type="continuous"><parent link="hand"/><child link="thing"/></joint><link name="thing"/></xacro:if>
      <xacro:unless value="$(arg is_held)"><xacro:include filename="$(find arms)/arm.xacro"/></xacro:unless>
    </robot>"""
    (tmp_path / "elsewhere").mkdir()
    (tmp_path / "elsewhere/held.xacro").write_text(text)
    monkeypatch.chdir(tmp_path)
    of = homogen.load("elsewhere/held.xacro", packages={"arms": "arms"})
    monkeypatch.chdir("/")
    assert of.joint_names == ("shoulder", "elbow") and torques(of).shape == (20, 2)
    held = homogen.load(tmp_path / "elsewhere/held.xacro", packages={"arms": tmp_path / "arms"}, arguments={"is_held": True})
    assert held.joint_names == ("grip",)


def test_keyframes_are_configurations(tmp_path):
    file = tmp_path / "arm.xml"
    key = '<keyframe><key name="home" qpos="0.5"/></keyframe></mujoco>'
    file.write_text(BODY.replace('type="mesh" mesh="bob" density="1000"', 'size="0.1"').replace("<mujoco>", "<mujoco><worldbody>").replace("</mujoco>", "</worldbody>" + key))
    robot = homogen.load(file)
    assert {name: list(q) for name, q in robot.configurations.items()} == {"home": [0.5]}
    robot.configurations["home"][0] = 1.0
    assert robot.configurations["home"][0] == 0.5


def test_a_file_without_keyframes_has_no_configurations(urdf):
    assert urdf.configurations == {}
