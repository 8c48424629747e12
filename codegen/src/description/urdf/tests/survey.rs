//! Warnings of elements and attributes that are not read: one for all mechanics and misspelt names, none for settings.

use super::{TENSOR, errors, errors_in_joint, fine, warnings, warnings_in_joint};

/// The warnings of an element in line 2 of a robot.
fn warnings_in(item: &str) -> Vec<String> {
    warnings(&format!(
        "<robot name=\"r\" xmlns:drake=\"http://drake.mit.edu\"><link name=\"a\"/>\n{item}</robot>"
    ))
}

/// Asserts one warning, of mechanics with this name that are not modelled.
fn assert_lost(item: &str, name: &str) {
    let found = warnings_in(item);
    let start = format!("arm.urdf:2:1: not modelled: {name} in ");
    assert!(
        found.len() == 1 && found[0].starts_with(&start),
        "{item}: {found:?}"
    );
}

#[test]
fn springs_dampers_and_constraints_are_warnings() {
    assert_eq!(
        warnings_in(
            "<force_element name=\"s\"><torsional_spring stiffness=\"5\"><joint name=\"j\"/></torsional_spring></force_element>"
        ),
        [
            "arm.urdf:2:1: not modelled: <force_element> in robot \"r\": a spring, a damper or another force"
        ]
    );
    for name in [
        "drake:linear_bushing_rpy",
        "drake:linear_spring_damper",
        "linear_spring_damper",
        "drake:ball_constraint",
        "drake:distance_constraint",
        "drake:tendon_constraint",
        "deformable",
        "frame",
        "virtual_joint",
    ] {
        assert_lost(
            &format!("<{name} name=\"x\"><inner/></{name}>"),
            &format!("<{name}>"),
        );
    }
    let damped = |attributes: &str| {
        warnings_in_joint(
            "revolute",
            &format!("<axis xyz=\"0 0 1\"/><dynamics {attributes}/>"),
        )
    };
    assert_eq!(
        damped("spring_stiffness=\"3\" spring_reference=\"0.5\""),
        [
            "arm.urdf:2:30: not modelled: attribute \"spring_stiffness\" of the <dynamics> of joint \"j\" and 1 other: a spring, a damper or another force"
        ]
    );
    assert_eq!(
        damped("spring_stiffness=\"0\" spring_reference=\"0.0\""),
        [""; 0]
    );
}

#[test]
fn mechanics_among_the_settings_of_simulators_are_warnings() {
    let gazebo = |inner: &str| warnings_in(&format!("<gazebo reference=\"a\">{inner}</gazebo>"));
    for (inner, name) in [
        ("<springStiffness>20</springStiffness>", "springStiffness"),
        (
            "<joint name=\"c\" type=\"revolute\"><parent>a</parent></joint>",
            "joint",
        ),
        ("<a><b><joint name=\"c\"/></b></a>", "joint"),
        ("<turnGravityOff>true</turnGravityOff>", "turnGravityOff"),
        ("<turnGravityOff value=\"1\"/>", "turnGravityOff"),
        ("<gravity>0</gravity>", "gravity"),
        ("<link name=\"c\"><inertial/></link>", "link"),
        ("<dampingFactor>0.1</dampingFactor>", "dampingFactor"),
        (
            "<axis><dynamics><damping>1</damping></dynamics></axis>",
            "dynamics",
        ),
    ] {
        let found = gazebo(inner);
        let start = format!("not modelled: <{name}> in ");
        assert!(
            found.len() == 1 && found[0].contains(&start),
            "{inner}: {found:?}"
        );
    }
    let mujoco = |inner: &str| warnings_in(&format!("<mujoco>{inner}</mujoco>"));
    for (inner, name) in [
        (
            "<equality><connect body1=\"a\" body2=\"b\"/></equality>",
            "<equality>",
        ),
        ("<tendon/>", "<tendon>"),
        ("<compiler boundmass=\"0.1\"/>", "attribute \"boundmass\""),
        ("<option gravity=\"0 0 -1.62\"/>", "attribute \"gravity\""),
    ] {
        let found = mujoco(inner);
        let start = format!("not modelled: {name} ");
        assert!(
            found.len() == 1 && found[0].contains(&start),
            "{inner}: {found:?}"
        );
    }
    let scaled = "<contact><inertia_scaling value=\"3.0\"/></contact>";
    let robot = fine(&format!(
        "<robot name=\"r\"><link name=\"a\">{scaled}</link></robot>"
    ));
    assert_eq!(robot.warnings.len(), 1);
}

#[test]
fn settings_without_mechanics_are_ignored() {
    for item in [
        "<material name=\"grey\"><color rgba=\"1 1 1 1\"/></material>",
        "<gazebo/>",
        "<gazebo reference=\"a\"><mu1>0.2</mu1><mu2 value=\"1\"/><kp>1e6</kp><kd>1</kd><selfCollide>1</selfCollide>\
         <maxVel>0.1</maxVel><minDepth>0.001</minDepth><material>Gazebo/Grey</material><implicitSpringDamper>1\
         </implicitSpringDamper><provideFeedback>true</provideFeedback><turnGravityOff>false</turnGravityOff>\
         <gravity>true</gravity><springStiffness>0</springStiffness><fudgeFactor value=\"0.5\"/></gazebo>",
        "<gazebo><plugin name=\"p\" filename=\"p.so\"><joint>j</joint><springStiffness>3</springStiffness></plugin>\
         <static>false</static></gazebo>",
        "<gazebo reference=\"a\"><sensor type=\"ray\"><joint/><pose>0 0 0 0 0 0</pose></sensor><visual/></gazebo>",
        "<ros2_control name=\"c\" type=\"system\"><hardware><plugin>p</plugin></hardware><joint name=\"j\">\
         <command_interface name=\"position\"><param name=\"min\">-1</param></command_interface></joint></ros2_control>",
        "<mujoco><compiler meshdir=\"m\" discardvisual=\"false\" balanceinertia=\"true\"/><option timestep=\"0.002\" \
         gravity=\"0 0 -9.81\"/><contact><exclude body1=\"a\" body2=\"b\"/></contact></mujoco>",
        "<drake:collision_filter_group name=\"g\"><drake:member link=\"a\"/></drake:collision_filter_group>",
        "<transmission name=\"t\" type=\"x/SimpleTransmission\"><type>x</type><joint name=\"j\"><hardwareInterface>e\
         </hardwareInterface><offset>0.0</offset></joint><actuator name=\"m\"><mechanicalReduction>1</mechanicalReduction>\
         <role>r</role></actuator><motorTorqueConstant>1</motorTorqueConstant></transmission>",
        "<link name=\"b\"><visual name=\"v\"><geometry><box size=\"1 1 1\"/></geometry><origin xyz=\"1 0 0\"/></visual>\
         <collision><geometry/><verbose value=\"true\"/></collision><sensor name=\"s\"/><contact><lateral_friction \
         value=\"1\"/><inertia_scaling value=\"1.0\"/><contact_cfm value=\"0.0\"/></contact></link>",
        "<group name=\"arm\"><chain base_link=\"a\" tip_link=\"b\"/></group>",
        "<webots><device/></webots>",
    ] {
        assert_eq!(warnings_in(item), [""; 0], "{item}");
    }
    let limit = "<axis xyz=\"0 0 1\"/><limit lower=\"-1\" upper=\"1\" effort=\"1\" velocity=\"1\" drake:acceleration=\"5\"/>";
    assert_eq!(warnings_in_joint("revolute", limit), [""; 0]);
}

#[test]
fn values_as_elements_or_text_are_warnings() {
    let joint =
        |inner: &str| warnings_in_joint("revolute", &format!("<axis xyz=\"0 0 1\"/>\n{inner}"));
    assert_eq!(
        joint("<origin><xyz>0 0 1</xyz><rpy>0 0 0</rpy></origin>"),
        [
            "arm.urdf:3:9: <xyz> in the <origin> of joint \"j\" is ignored",
            "arm.urdf:3:25: <rpy> in the <origin> of joint \"j\" is ignored",
        ]
    );
    assert_eq!(
        joint("<mimic joint=\"k\"><multiplier>2</multiplier></mimic>"),
        ["arm.urdf:3:18: <multiplier> in the <mimic> of joint \"j\" is ignored"]
    );
    assert_eq!(
        joint("<dynamics>\n 5</dynamics>"),
        ["arm.urdf:4:2: text in the <dynamics> of joint \"j\" is ignored"]
    );
    assert_eq!(
        joint("<joint_properties damping=\"10\" friction=\"10\"/>"),
        ["arm.urdf:3:1: not modelled: <joint_properties> in joint \"j\": damping and friction"]
    );
    let text = "<robot name=\"r\"><link name=\"a\"/><link name=\"b\"/><joint name=\"j\" type=\"revolute\"><parent link=\"a\"/>\
         <child link=\"b\"/><axis xyz=\"0 0 1\"/><dynamics><damping>5</damping></dynamics></joint></robot>";
    let hint = fine(text).warnings[0].hint.clone();
    assert_eq!(
        hint.as_deref(),
        Some("write it as an attribute: <dynamics damping=\"5\"/>")
    );
}

#[test]
fn unknown_attributes_are_warnings_with_a_hint() {
    let hint = |inner: &str| {
        let text = format!(
            "<robot name=\"r\"><link name=\"a\"/><link name=\"b\"/><joint name=\"j\" type=\"revolute\"><parent link=\"a\"/>\
             <child link=\"b\"/><axis xyz=\"0 0 1\"/>{inner}</joint></robot>"
        );
        let warnings = fine(&text).warnings;
        let [warning] = &warnings[..] else {
            panic!("{inner}: {warnings:?}");
        };
        (
            warning.message.clone(),
            warning.hint.clone().unwrap_or_default(),
        )
    };
    for (inner, attribute, of, meant) in [
        (
            "<limit lower_limit=\"-1\" velocity=\"1\"/>",
            "lower_limit",
            "limit",
            "lower",
        ),
        ("<dynamics damp=\"2\"/>", "damp", "dynamics", "damping"),
        (
            "<mimic joint=\"a\" Multiplier=\"2\"/>",
            "Multiplier",
            "mimic",
            "multiplier",
        ),
    ] {
        assert_eq!(
            hint(inner),
            (
                format!("attribute \"{attribute}\" of the <{of}> of joint \"j\" is ignored"),
                format!("did you mean {meant}?")
            )
        );
    }
    // The warning explains the missing entry.
    let tensor = TENSOR.replace("ixx", "Ixx");
    let found = errors(&format!(
        "<robot name=\"r\"><link name=\"a\"><inertial>\n<mass value=\"1\"/>{tensor}</inertial></link></robot>"
    ));
    assert!(found.contains("ixx of link \"a\" is missing"), "{found}");
    assert!(
        found.contains("warning: arm.urdf:2:27: attribute \"Ixx\""),
        "{found}"
    );
    assert!(found.contains("did you mean ixx?"), "{found}");
}

#[test]
fn misplaced_elements_are_warnings_with_their_place() {
    let inertial = format!("<inertial><mass value=\"1\"/>{TENSOR}</inertial>");
    let nested = format!(
        "<robot name=\"r\"><link name=\"a\">\n<link name=\"b\">{inertial}</link></link></robot>"
    );
    let robot = fine(&nested);
    assert_eq!(robot.links.len(), 1);
    let [warning] = &robot.warnings[..] else {
        panic!("{:?}", robot.warnings);
    };
    assert_eq!(warning.message, "<link> in link \"a\" is ignored");
    assert_eq!(warning.hint.as_deref(), Some("move it into <robot>"));
    assert_eq!(
        warnings_in(&format!(
            "<robot name=\"s\"><link name=\"b\">{inertial}</link></robot>"
        )),
        ["arm.urdf:2:1: not modelled: <robot> in robot \"r\": a second robot"]
    );
    let grouped = fine(&format!(
        "<robot name=\"r\"><link name=\"a\"/><g:part><link name=\"b\">{inertial}</link></g:part></robot>"
    ));
    assert_eq!(
        grouped.warnings[0].hint.as_deref(),
        Some("so are the elements in it: 1 <link> and 1 <inertial>")
    );
    assert_eq!(
        fine("<robot name=\"r\"><link name=\"a\"/><damping>5</damping></robot>").warnings[0]
            .hint
            .as_deref(),
        Some("write it as an attribute of <dynamics>")
    );
    assert_eq!(
        warnings_in("<damping>5</damping><inertia ixx=\"1\"/>"),
        [
            "arm.urdf:2:1: <damping> in robot \"r\" is ignored",
            "arm.urdf:2:21: <inertia> in robot \"r\" is ignored",
        ]
    );
}

#[test]
fn one_warning_for_each_kind() {
    assert_eq!(
        warnings_in("<my:tag/>\n<my:tag/><my:tag a=\"1\"/>\n<my:other/>"),
        [
            "arm.urdf:2:1: <my:tag> in robot \"r\" and 2 other places is ignored",
            "arm.urdf:4:1: <my:other> in robot \"r\" is ignored",
        ]
    );
    let many: Vec<String> = (0..5000).map(|k| format!("<t{k}/>")).collect();
    assert_eq!(warnings_in(&many.concat()).len(), 1000);
}

#[test]
fn an_element_in_capitals_is_a_warning_beside_the_error() {
    let text = "<robot name=\"r\"><link name=\"a\"/>\n<Link name=\"b\"/><joint name=\"j\" type=\"fixed\"><parent link=\"a\"/></joint></robot>";
    assert_eq!(
        errors(text),
        "error: arm.urdf:2:17: joint \"j\" has no <child>\n  hint: add <child link=\"…\"/>\n\
         warning: arm.urdf:2:1: <Link> in robot \"r\" is ignored\n  hint: did you mean <link>?\n"
    );
}

#[test]
fn joints_of_drake_are_read() {
    let robot = |kind: &str, inner: &str| {
        format!(
            "<robot name=\"r\"><link name=\"a\"/><link name=\"b\"/>\n<drake:joint name=\"j\" type=\"{kind}\">\
             <parent link=\"a\"/><child link=\"b\"/>{inner}</drake:joint></robot>"
        )
    };
    for (kind, read, axes) in [
        ("ball", "spherical", None),
        ("planar", "planar", Some([0.0, 0.0, 1.0])),
        ("universal", "universal", Some([1.0, 0.0, 0.0])),
    ] {
        let description = fine(&robot(kind, ""));
        let joint = &description.joints[0];
        assert_eq!(joint.kind.word(), read);
        if let Some(axis) = axes {
            assert_eq!(joint.axis.map(|entry| entry.value), axis, "{kind}");
            assert_eq!(joint.second_axis.map(|entry| entry.value), [0.0, 1.0, 0.0]);
        }
        assert!(
            description.warnings.is_empty(),
            "{:?}",
            description.warnings
        );
    }
    assert_eq!(
        warnings(&robot("planar", "<axis xyz=\"0 1 0\"/>")),
        ["arm.urdf:2:72: the axis of joint \"j\" is ignored, as in Drake for type planar"]
    );
    assert!(errors(&robot("curved", "")).contains("joint \"j\" has the unknown type \"curved\""));
}

#[test]
fn a_second_axis_and_a_thread_are_warnings_if_the_type_has_none() {
    assert_eq!(
        warnings_in_joint(
            "revolute",
            "<axis xyz=\"0 0 1\"/>\n<thread pitch=\"0.1\"/>\n<axis2 xyz=\"1 0 0\"/>"
        ),
        [
            "arm.urdf:3:1: <thread> in joint \"j\" is ignored: its type is revolute",
            "arm.urdf:4:1: <axis2> in joint \"j\" is ignored: its type is revolute",
        ]
    );
    let screw = "<axis xyz=\"0 0 1\"/><thread pitch=\"0.1\"/>";
    assert_eq!(errors_in_joint("screw", screw), "");
    assert_eq!(warnings_in_joint("screw", screw), [""; 0]);
}

#[test]
fn other_forms_of_rotors_and_gears_are_warnings() {
    assert_eq!(
        warnings_in(
            "<transmission name=\"t\"><joint name=\"j\"/><actuator name=\"m\">\n<motorInertia>1e-4</motorInertia></actuator></transmission>"
        ),
        ["arm.urdf:3:1: not modelled: <motorInertia> in <actuator> \"m\": the inertia of a rotor"]
    );
    assert_eq!(
        warnings_in(
            "<transmission name=\"t\"><rightActuator name=\"m\" mechanicalReduction=\"50\"/></transmission>"
        ),
        ["arm.urdf:2:48: not modelled: the reduction of transmission \"t\""]
    );
    assert_eq!(
        warnings_in(
            "<transmission name=\"t\"><joint name=\"j\"/><joint name=\"k\"/><actuator name=\"m\">\n<drake:rotor_inertia value=\"1\"/></actuator></transmission>"
        ),
        ["arm.urdf:3:1: not modelled: the rotor of transmission \"t\", which has no single joint"]
    );
}

#[test]
fn a_planar_joint_with_another_normal_is_a_warning() {
    let warnings = |axis: &str| warnings_in_joint("planar", &format!("<axis xyz=\"{axis}\"/>"));
    for other in ["0 1 0", "0 0 -1", "0 0.6 0.8"] {
        assert_eq!(
            warnings(other),
            [
                "arm.urdf:2:1: joint \"j\" is planar with a normal other than z: Pinocchio and MoveIt use z"
            ]
        );
    }
    assert_eq!(warnings("0 0 1"), [""; 0]);
    assert_eq!(warnings("1e-17 0 1"), [""; 0]);
}
