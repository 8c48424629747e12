//! Configurations with names in every language.

use crate::builder::Builder;
use crate::description::read_text;
use crate::error::Errors;
use crate::function::Function;
use crate::print::arrays::Order;
use crate::real::Real;

/// A robot with two keyframes, or with none.
fn robot(keys: &str) -> Builder {
    let text = format!(
        "<mujoco model=\"arm\"><compiler angle=\"radian\"/><worldbody><body name=\"a\"><joint name=\"j\"/><geom size=\"0.1\"/>\
         <body name=\"b\" pos=\"0 0 1\"><joint name=\"k\" type=\"slide\"/><geom size=\"0.1\"/></body></body></worldbody>{keys}</mujoco>"
    );
    let mut errors = Errors::new();
    let description = read_text(&text, "arm.xml", None, &mut errors);
    assert!(errors.is_empty(), "{errors}");
    Builder::from_description(description.expect("it is a robot")).generate([Function::Gravity])
}

const KEYS: &str =
    "<keyframe><key name=\"home\" qpos=\"0.5 -1\"/><key name=\"ä?\" qpos=\"0 2\"/></keyframe>";

#[test]
fn each_language_has_the_configurations_of_the_file() {
    let robot = robot(KEYS);
    let rust = robot.to_source().expect("no mistakes").to_string();
    let part = "pub const CONFIGURATIONS: [(&'static str, [f64; 2]); 2] =";
    assert!(rust.contains(part), "{rust}");
    assert!(rust.contains("(\"home\", [0.5, -1.0])"), "{rust}");
    let single = robot.clone().scalar(Real::F32).to_tokens();
    let single = single.expect("no mistakes").to_string();
    assert!(single.contains("0.5_f32"), "{single}");
    let c = robot.to_c("arm.h").expect("no mistakes").header;
    for part in [
        "#define ARM_CONFIGURATION_NAMES {\"home\", \"\\303\\244\\077\"}\n",
        "#define ARM_CONFIGURATIONS {{0.5, -1.0}, {0.0, 2.0}}\n",
        "static const double configurations[2][2].",
    ] {
        assert!(c.contains(part), "{part}\n{c}");
    }
    let cpp = robot
        .to_cpp("arm.hpp", Order::AngularFirst)
        .expect("no mistakes");
    for part in [
        "inline constexpr std::array<const char*, 2> CONFIGURATION_NAMES = {\"home\", \"\\303\\244\\077\"};\n",
        "inline constexpr std::array<std::array<double, 2>, 2> CONFIGURATIONS = {{{0.5, -1.0},\n    {0.0, 2.0}}};\n",
    ] {
        assert!(cpp.contains(part), "{part}\n{cpp}");
    }
    let python = robot.to_plain_python(Order::LinearFirst);
    let python = python.expect("no mistakes");
    let part = "CONFIGURATIONS = {\"home\": [0.5, -1.0], \"\\U000000e4?\": [0.0, 2.0]}\n";
    assert!(python.contains(part), "{python}");
}

#[test]
fn a_robot_without_configurations_prints_nothing_of_them() {
    let robot = robot("");
    let texts = [
        robot.to_source().expect("no mistakes").to_string(),
        robot.to_tokens().expect("no mistakes").to_string(),
        robot.to_c("arm.h").expect("no mistakes").header,
        robot
            .to_cpp("arm.hpp", Order::AngularFirst)
            .expect("no mistakes"),
        robot
            .to_plain_python(Order::LinearFirst)
            .expect("no mistakes"),
    ];
    for text in texts {
        assert!(
            !text.to_lowercase().contains("configuration_names"),
            "{text}"
        );
        assert!(!text.contains("CONFIGURATIONS"), "{text}");
    }
}
