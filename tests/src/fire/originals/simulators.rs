//! Files of xacro, MJCF and SDF before they are damaged: those that ship, and one with more elements each.

pub(super) const XACRO: [&str; 2] = [
    include_str!("../../../../robots/two_link.urdf.xacro"),
    r#"<?xml version="1.0"?>
<robot name="${prefix}arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:arg name="count" default="2"/>
  <xacro:property name="prefix" value="left_"/>
  <xacro:property name="sizes" value="${dict(a=0.3, b=[1, 2.5, 'x'])}"/>
  <xacro:property name="body"><mass value="${2 * sizes['a']}"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></xacro:property>
  <link name="l0"/>
  <xacro:macro name="chain" params="k:=1 last:=^|3 scale:=${1/3} **more">
    <xacro:if value="${k <= last}">
      <link name="l${k}"><inertial><xacro:insert_block name="body"/></inertial></link>
      <joint name="${prefix}j${k}" type="${'revolute' if k % 2 else 'continuous'}">
        <parent link="l${k - 1}"/><child link="l${k}"/>
        <origin xyz="${scale * k} 0 ${sqrt(k) if k in [1, 2] else sizes['b'][1]}" rpy="${-pi/2} 0 0"/>
        <axis xyz="0 ${max(0, 1)} 0"/><xacro:insert_block name="more"/>
      </joint>
      <xacro:chain k="${k + 1}"><limit lower="${-radians(90)}" upper="2" velocity="1" effort="1"/></xacro:chain>
    </xacro:if>
    <xacro:unless value="${k <= last}"><!-- ${k} links --></xacro:unless>
  </xacro:macro>
  <xacro:property name="last" value="$(arg count)"/>
  <xacro:chain><limit lower="-1" upper="${[i * 2 for i in range(3) if i > 0][0]}" velocity="1" effort="1"/></xacro:chain>
  <xacro:element xacro:name="${'li' + 'nk'}" name="$(eval 'x' + str(arg('count')))"/>
  <joint name="end" type="fixed"><parent link="l${last}"/><child link="x2"/></joint>
</robot>
"#,
];

pub(super) const MJCF: [&str; 2] = [
    include_str!("../../../../robots/two_link.xml"),
    r#"<mujoco model="creature">
  <compiler angle="radian" eulerseq="zyx" boundmass="0.01" boundinertia="1e-5" balanceinertia="true"/>
  <option gravity="0 0 -9.81"><flag contact="disable"/></option>
  <default>
    <joint armature="0.01" damping="0.1"/><geom type="capsule" size="0.05" density="900"/>
    <default class="finger"><joint axis="0 1 0" range="-1 1"/><geom size="0.02"/><position kp="3"/></default>
  </default>
  <asset>
    <mesh name="m" vertex="0 0 0  0.1 0 0  0 0.2 0  0 0 0.1  0.1 0.1 0.1" inertia="convex" scale="1 -1 1"/>
    <hfield name="h" nrow="2" ncol="2" size="1 1 0.5 0.1"/>
  </asset>
  <worldbody>
    <geom type="hfield" hfield="h"/><light pos="0 0 3"/>
    <body name="trunk" pos="0 0 1" quat="1 0 0.1 0">
      <joint name="lift" type="slide" axis="0 0 1" ref="0.1" stiffness="1"/><joint name="yaw" pos="0.1 0 0"/>
      <geom type="box" size="0.1 0.2 0.3" mass="2"/><geom type="mesh" mesh="m" euler="0.1 0.2 0.3"/>
      <geom type="ellipsoid" mesh="m" fitscale="1.1"/>
      <frame pos="0.1 0 0" axisangle="0 0 1 0.3" childclass="finger">
        <replicate count="2" offset="0 0.1 0" euler="0 0 0.4" sep="_">
          <body name="tip" xyaxes="1 0 0 0 0 1" gravcomp="1"><joint name="bend"/><geom fromto="0 0 0 0.1 0 0"/>
            <site name="end" pos="0.1 0 0" zaxis="1 0 1"/></body>
        </replicate>
      </frame>
      <body name="ball" pos="0 0.3 0"><joint name="swivel" type="ball" pos="0 0 0.1"/>
        <inertial pos="0 0 0.1" mass="1" fullinertia="0.1 0.2 0.2 0.01 0 -0.01"/></body>
    </body>
  </worldbody>
  <equality><joint joint1="bend_1" joint2="bend_0" polycoef="0.1 -1 0 0 0"/></equality>
  <actuator><motor joint="lift" gear="30" armature="1e-4"/><position class="finger" joint="yaw"/></actuator>
  <keyframe><key name="home" qpos="0 0 0 0 1 0 0 0"/></keyframe>
</mujoco>
"#,
];

pub(super) const SDF: [&str; 2] = [
    include_str!("../../../../robots/two_link.sdf"),
    r#"<?xml version="1.0"?>
<sdf version="1.9"><world name="w"><gravity>0 0 -9.8</gravity>
  <model name="arm" placement_frame="base"><pose degrees="true">1 2 3 10 20 30</pose>
    <link name="base"><inertial><mass>2</mass><pose rotation_format="quat_xyzw">0 0 0.1 0 0 0.6 0.8</pose>
      <inertia><ixx>0.1</ixx><iyy>0.2</iyy><izz>0.2</izz></inertia></inertial></link>
    <frame name="shoulder" attached_to="base"><pose relative_to="base">0 0 0.5 0 0.1 0</pose></frame>
    <link name="upper"><pose relative_to="turn"/><inertial><mass>1</mass></inertial></link>
    <link name="fore"><pose relative_to="upper">0.3 0 0 0 0 0</pose></link>
    <link name="rod"><pose relative_to="fore">0.3 0 0 0 0 0</pose></link>
    <joint name="root" type="fixed"><parent>world</parent><child>base</child></joint>
    <joint name="turn" type="revolute"><pose relative_to="shoulder"/><parent>base</parent><child>upper</child>
      <axis><xyz expressed_in="__model__">0 0.6 0.8</xyz><limit><lower>-1</lower><upper>1</upper><effort>5</effort></limit>
      <dynamics><damping>0.1</damping><friction>0.2</friction><spring_stiffness>0</spring_stiffness></dynamics></axis></joint>
    <joint name="both" type="universal"><parent>upper</parent><child>fore</child>
      <axis><xyz>1 0 0</xyz></axis><axis2><xyz>0 1 0</xyz></axis2></joint>
    <joint name="push" type="screw"><pose>0 0 0.1 0 0 0</pose><parent>fore</parent><child>rod</child>
      <screw_thread_pitch>0.01</screw_thread_pitch>
      <axis><xyz>0 0 1</xyz><mimic joint="turn"><multiplier>2</multiplier><offset>0.1</offset></mimic></axis></joint>
    <model name="hand"><pose relative_to="rod">0 0 0.1 0 0 0</pose><link name="palm"/><link name="finger"/>
      <joint name="grip" type="prismatic"><parent>palm</parent><child>finger</child><axis/></joint></model>
    <joint name="mount" type="fixed"><parent>rod</parent><child>hand::palm</child></joint>
  </model>
</world></sdf>
"#,
];
