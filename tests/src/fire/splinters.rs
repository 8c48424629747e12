//! Pieces of text that are likely to break readers.
//!
//! Numbers, vectors and words replace others; the texts of each language are inserted.

/// Numbers, and texts that look like numbers.
#[rustfmt::skip]
pub(super) const NUMBERS: [&str; 64] = [
    "", "0", "1e50", "-1e50", "1e49", "1e20", "1e-50", "-1e-30", "-0", "-0.0", "+0", "1", "-1", "2",
    "1e-17", "-1.6653e-16", "1.1102e-16", "1e-9", "1.5708", "-1.5707", "3.14159",
    "1.57079632679489661923", "0.33333", "1e308", "-1e308", "1e160", "1e-160",
    "1.7976931348623157e308", "1e309", "1e999", "-1e999", "1e-999", "5e-324", "2.2e-308", "1e-310",
    "1e99999999999999999999", "1e-99999999999999999999", "0e99999999999999999999", "nan", "NaN",
    "-nan", "inf", "-Inf", "infinity", "0x10", "0b1", "1_000", "1,5", "1;5", "1.2.3", "1e", "e1",
    ".", "+", "--1", "1e+", "\u{ff11}", "\u{221e}", "\u{2212}1", "1f64", "1.5708rad", "90deg",
    "1 000", "1d-3",
];

/// Numbers that readers accept, so that the stages behind them meet them.
#[rustfmt::skip]
pub(super) const BORNE: [&str; 24] = [
    "0", "-0", "0.0", "1", "-1", "2", "1e-17", "-1.6653e-16", "1.1102e-16", "1e-9", "-3e-7",
    "1e-30", "5e-324", "-1e-300", "1.5708", "-1.570796", "3.14159", "6.2832", "1000000.1", "-1e20",
    "1e50", "123456789.123456789", "0.1000000000000000055511151231257827021181583404541015625",
    "00000.5",
];

/// Vectors, and texts that look like vectors.
#[rustfmt::skip]
pub(super) const VECTORS: [&str; 18] = [
    "0 0 0", "0 0 2", "0 0", "0 0 0 0", "1 0 0 0 0 0 0", "1e300 1e300 1e300",
    "1e-300 1e-300 1e-300", "1e-17 0 1", "0 1e-9 1", "-1 -1 -1", "0.577 0.577 0.577", "nan nan nan",
    "1e-320 0 0", "1.5708 0 1.5708", "1e6 1e-6 0", "\t1\n0\r0 ", "0,0,1", "[0, 0, 1]",
];

/// Words with a meaning somewhere, and difficult names.
#[rustfmt::skip]
pub(super) const WORDS: [&str; 58] = [
    "base", "tip", "tool", "link1", "joint1", "revolute", "continuous", "prismatic", "fixed",
    "floating", "planar", "mimic", "screw", "spherical", "Revolute", "pi", "pi/2", "pi/0", "2*pi",
    "-pi*pi*pi/3/7", "1/3", "pi*", "convention", "modified", "standard", "joint", "mass", "ixx",
    "theta", "-", "#", "x", "-z", "xyz", "rpy", "rx", "at", "to", "from", "link", "struct",
    "generate", "all_of", "none", "frames", "lock", "fn", "Self", "_", "r#fn", "*/", "/*", "`",
    "\u{202e}", "\u{0}", "\u{1b}[2J", "\u{feff}", "${x}",
];

/// Texts to insert into a URDF file.
#[rustfmt::skip]
pub(super) const URDF: [&str; 26] = [
    "<link name=\"x\"/>", "<joint name=\"x\" type=\"fixed\"/>", "<origin xyz=\"1 2 3\"/>",
    "<axis/>", "<limit lower=\"1\" upper=\"-1\" velocity=\"-1\"/>",
    "<mimic joint=\"shoulder\" multiplier=\"2\"/>", "<dynamics friction=\"-1\"/>", "<inertial/>",
    "<mass value=\"-1\"/>", "<mass value=\"1e300\"/>",
    "<inertia ixx=\"1e300\" ixy=\"0\" ixz=\"0\" iyy=\"1\" iyz=\"0\" izz=\"1\"/>",
    "<!DOCTYPE r [<!ENTITY a \"aaaaaaaaaa\"><!ENTITY b \"&a;&a;&a;&a;&a;&a;&a;&a;\"><!ENTITY c \"&b;&b;&b;&b;&b;&b;&b;&b;\">]>",
    "<!DOCTYPE r SYSTEM \"file:///etc/passwd\">", "&c;", "&lt;", "&#0;", "&#x202e;", "&#xd800;",
    "&#99999999999;", "<![CDATA[<link name=\"x\"/>]]>", "<!-- -- -->", "<!--",
    "<?xml version=\"1.1\"?>", "<?php ?>",
    "<xacro:macro name=\"m\" xmlns:xacro=\"http://ros.org/wiki/xacro\"/>", "xmlns=\"u\"",
];

/// Texts to insert into a xacro file.
#[rustfmt::skip]
pub(super) const XACRO: [&str; 22] = [
    "<xacro:chain k=\"1\" last=\"1\"/>", "<xacro:chain k=\"-1000000\"/>", "<xacro:include filename=\"arm.urdf.xacro\"/>",
    "<xacro:include filename=\"../../../etc/passwd\"/>", "<xacro:include filename=\"$(find x)/*\"/>",
    "<xacro:property name=\"k\" value=\"${k}\"/>", "<xacro:property name=\"a\" value=\"${a + a}\" lazy_eval=\"false\"/>",
    "<xacro:macro name=\"m\" params=\"a *b\"><xacro:m a=\"1\"><b/></xacro:m></xacro:macro><xacro:m a=\"1\"><b/></xacro:m>",
    "<xacro:macro name=\"property\" params=\":= ^ ** a:=^|\"/>", "<xacro:insert_block name=\"body\"/>",
    "<xacro:if value=\"maybe\"/>", "<xacro:call macro=\"chain\"/>", "<xacro:attribute name=\"x\" value=\"1\"/>",
    "${'a' * 10**9}", "${9**9**9}", "${[[0] * 1000 for i in range(100000)]}", "${((((1", "${1 if}", "$${", "$(arg )",
    "${load_yaml('x.yaml')}", "<!DOCTYPE r [<!ENTITY a \"aa\"><!ENTITY b \"&a;&a;&a;\">]>",
];

/// Texts to insert into an MJCF file.
#[rustfmt::skip]
pub(super) const MJCF: [&str; 24] = [
    "<body><joint/><geom size=\"1\"/></body>", "<joint type=\"ball\"/>", "<freejoint/>", "<inertial pos=\"0 0 0\" mass=\"-1\"/>",
    "<geom type=\"mesh\" mesh=\"m\" size=\"1\"/>", "<geom type=\"capsule\" fromto=\"0 0 0 0 0 0\"/>", "<site name=\"tip\"/>",
    "<mesh name=\"m\" vertex=\"0 0 0 1 0 0 0 1 0\"/>", "<mesh name=\"m\" vertex=\"0 0 0 0 0 0 0 0 0 0 0 0\"/>",
    "<mesh name=\"m\" vertex=\"0 0 0 1 0 0 0 1 0 0 0 1\" face=\"0 1 9\"/>", "<replicate count=\"100000\"><body/></replicate>",
    "<include file=\"arm.xml\"/>", "<include file=\"/etc/passwd\"/>", "<include/>", "<default class=\"main\"><default/></default>",
    "<attach model=\"x\" body=\"y\" prefix=\"z\"/>", "<composite/>", "<compiler coordinate=\"global\" eulerseq=\"xxx\"/>",
    "<compiler settotalmass=\"1e-300\" inertiafromgeom=\"true\"/>", "<equality><connect body1=\"tip\" anchor=\"0 0 0\"/></equality>",
    "<equality><joint joint1=\"yaw\" joint2=\"yaw\"/></equality>", "<equality><weld site1=\"end\" site2=\"end\"/></equality>",
    "<keyframe><key qpos=\"nan\"/><key/></keyframe>", "<tendon><fixed stiffness=\"1\"/></tendon>",
];

/// Texts to insert into an SDF file.
#[rustfmt::skip]
pub(super) const SDF: [&str; 16] = [
    "<link name=\"x\"/>", "<frame name=\"base\" attached_to=\"base\"/>", "<frame name=\"a\" attached_to=\"a\"/>",
    "<frame name=\"c\"><pose relative_to=\"d\"/></frame><frame name=\"d\"><pose relative_to=\"c\"/></frame>",
    "<pose relative_to=\"\">0 0</pose>", "<pose rotation_format=\"quat_xyzw\">0 0 0 0 0 0 0</pose>",
    "<include><uri>model://arm</uri></include>", "<include><uri>../../etc</uri><name>x</name></include>", "<include merge=\"true\"/>",
    "<joint name=\"g\" type=\"gearbox\"><parent>base</parent><child>fore</child><gearbox_ratio>0</gearbox_ratio></joint>",
    "<joint name=\"x\" type=\"revolute2\"><parent>world</parent><child>world</child></joint>", "<axis><xyz>0 0 0</xyz></axis>",
    "<inertial auto=\"true\"/>", "<static>true</static>", "<model name=\"__model__\"/>", "<mimic joint=\"both\" axis=\"axis2\"/>",
];

/// Texts to insert into a table.
#[rustfmt::skip]
pub(super) const TABLE: [&str; 12] = [
    "\nconvention standard\n", "\nconvention modified\n", "\njoint kind a alpha d theta\n",
    "\nx revolute 0 0 0 0\n", "\nx screw 0 0 0 0 1e300\n", " - ", " # ", "\t", "\r", "\u{a0}",
    "\u{2003}", " - - - - - - - - - - - - - - - - - - - - - - - -",
];

/// Texts to insert into an inline description.
#[rustfmt::skip]
pub(super) const INLINE: [&str; 24] = [
    "link x;", "joint x: fixed;", "joint x: revolute(z) { from: base, to: base }", "{", "}", "(",
    ")", "[", "]", ",", ";", ":", "=", "\"", "'", "/*", "//", "urdf = \"no.urdf\"",
    "dh = \"/dev/null\"", "generate(bias, bias)", "formulation(refined = 2, articulated)",
    "gravity = [1e308, 1e308, 1e308]", "#[robot(x)]", "target = \"cortex-m4\"",
];
