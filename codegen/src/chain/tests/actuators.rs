//! Armature, damping and friction: their sources, and which of them are modelled.

use super::*;
use crate::builder::Builder;
use crate::description::{Number, read_text};
use crate::expression::Double;
use crate::function::Function;
use crate::joint::actuator::ActuatorQuantity;
use crate::request::Request;

/// Armature, damping and friction of each velocity.
fn actuators(chain: &Chain) -> Vec<[f64; 3]> {
    let value = |entry| chain.graph.value(entry).map_or(f64::NAN, Double::to_f64);
    let joints = chain.joints.iter();
    joints
        .map(|joint| joint.actuator.entries().map(value))
        .collect()
}

const NOTHING: [f64; 3] = [0.0; 3];

#[test]
fn actuators_in_attributes_are_modelled() {
    let chain = fine(&arm(
        "armature(shoulder = 0.5), rotor(shoulder = 0.25, elbow = 2.0), ratio(shoulder = -4), \
         damping(elbow: 3/4), friction(\"elbow\" = [0.125])",
    ));
    assert_eq!(actuators(&chain), [[4.5, 0.0, 0.0], [2.0, 0.75, 0.125]]);
}

/// A setting of the struct replaces the value in the joint.
#[test]
fn actuators_in_an_inline_joint_are_modelled() {
    let arm = arm("damping(elbow = 7)").replace(
        "joint elbow: revolute(y) { ",
        "joint elbow: cylindrical(y) { armature: [0.5, 2.0], damping: 0.25, friction: [1, 0], ",
    );
    let expected = [NOTHING, [0.5, 7.0, 1.0], [2.0, 7.0, 0.0]];
    assert_eq!(actuators(&fine(&arm)), expected);
}

#[test]
fn impossible_actuators_are_refused() {
    let settings = "lock(elbow), armature(shoulder = -1, mount = 1, elbow = 2, elbo = 3), \
        damping(shoulder = [1, 2]), ratio(shoulder = 100), friction(shoulder = 1, shoulder = 2), \
        rotor(shoulder = 1e60)";
    assert_eq!(
        said(&arm(settings)),
        lines(&[
            r#"error: joint "mount" is fixed and has no armature"#,
            r#"error: joint "elbow" does not move: its armature changes nothing"#,
            "  hint: leave it out, or do not lock the joint",
            r#"error: there is no joint "elbo""#,
            r#"  hint: did you mean "elbow"? joints: "shoulder", "elbow" and "mount""#,
            r#"error: the friction of joint "shoulder" occurs twice"#,
            r#"error: the armature of joint "shoulder" is negative: -1"#,
            r#"error: the rotor of joint "shoulder" is too large"#,
            r#"error: the damping of joint "shoulder" has 2 numbers for 1 of its velocities"#,
            "  hint: give one number for all of them, or one for each",
        ])
    );
    assert_eq!(
        said(&arm(
            "ratio(shoulder = 100), drop(fore), damping(elbow = 1)"
        )),
        lines(&[
            r#"error: joint "elbow" is not modelled"#,
            r#"error: the ratio of joint "shoulder" has no rotor"#,
            "  hint: set rotor as well, or only armature, which includes the ratio",
        ])
    );
}

/// A file whose joint has friction, and a rotor behind a gear.
fn file(dynamics: &str) -> String {
    let inertial = "<inertial><mass value=\"1\"/><inertia ixx=\"1\" ixy=\"0\" ixz=\"0\" iyy=\"1\" \
         iyz=\"0\" izz=\"1\"/></inertial>";
    format!(
        "<robot name=\"r\"><link name=\"a\"/><link name=\"b\">{inertial}</link>\n\
         <joint name=\"j\" type=\"revolute\"><parent link=\"a\"/><child link=\"b\"/>\
         <axis xyz=\"0 0 1\"/>{dynamics}</joint>\n\
         <transmission name=\"t\"><joint name=\"j\"/>\n\
         <actuator name=\"m\"><mechanicalReduction>20</mechanicalReduction>\n\
         <drake:rotor_inertia value=\"0.01\"/></actuator></transmission></robot>"
    )
}

const DYNAMICS: &str = "<dynamics damping=\"0.5\" friction=\"0.25\" D=\"1\"/>";

fn read_file(text: &str) -> Description {
    let mut errors = Errors::new();
    let description = read_text(text, "r.urdf", None, &mut errors);
    assert!(errors.is_empty(), "{errors}");
    description.expect("no mistakes, so a description")
}

/// The armature, damping and friction of a file, and the warnings.
fn modelled(request: &Request) -> (Vec<[f64; 3]>, Vec<String>) {
    let description = read_file(&file(DYNAMICS));
    let chain = build(&description, request).expect("a chain");
    let warnings = chain.report.warnings.iter();
    let warnings = warnings.map(|warning| description.source.errors().locate(warning));
    (actuators(&chain), warnings.collect())
}

#[test]
fn actuators_of_a_file_are_modelled_if_requested() {
    let friction = "r.urdf:2:87: not modelled: damping and friction of joint \"j\"";
    let other = "r.urdf:2:127: not modelled: attribute \"D\" of the <dynamics> of joint \"j\": other dynamics";
    let gear = "r.urdf:4:20: not modelled: the reduction of transmission \"t\"";
    let rotor = "r.urdf:5:1: not modelled: the rotor of transmission \"t\"";
    let reported = |warnings: &[&str]| warnings.iter().map(|&warning| warning.to_owned()).collect();
    let nothing = Request::default();
    let expected = (vec![NOTHING], reported(&[other, friction, gear, rotor]));
    assert_eq!(modelled(&nothing), expected);
    let asked = Request {
        friction: true,
        ..Request::default()
    };
    let expected = (vec![[0.0, 0.5, 0.25]], reported(&[other, gear, rotor]));
    assert_eq!(modelled(&asked), expected);
    let asked = Request {
        rotors: true,
        ..Request::default()
    };
    let expected = (vec![[4.0, 0.0, 0.0]], reported(&[other, friction]));
    assert_eq!(modelled(&asked), expected);
}

#[test]
fn drakes_gear_ratio_takes_precedence_over_a_reduction() {
    let text = file("").replace(
        "<drake:rotor_inertia",
        "<drake:gear_ratio value=\"10\"/><drake:rotor_inertia",
    );
    let asked = Request {
        rotors: true,
        ..Request::default()
    };
    let chain = build(&read_file(&text), &asked).expect("a chain");
    assert_eq!(actuators(&chain), [[1.0, 0.0, 0.0]]);
}

#[test]
fn the_inertias_of_several_motors_of_a_joint_add_up() {
    let asked = || Request {
        rotors: true,
        ..Request::default()
    };
    let motor = |name: &str, rotor: &str, ratio: &str| {
        format!(
            "<actuator name=\"{name}\"><drake:rotor_inertia value=\"{rotor}\"/><drake:gear_ratio value=\"{ratio}\"/></actuator>"
        )
    };
    let (one, two) = (motor("m", "0.25", "2"), motor("n", "0.5", "4"));
    let joint = "<joint name=\"j\"/>";
    let gear = "<transmission name=\"g\"><joint name=\"j\"/><actuator name=\"x\"><mechanicalReduction>9</mechanicalReduction></actuator></transmission>";
    let apart = format!(
        "<transmission name=\"t\">{joint}{one}</transmission><transmission name=\"u\">{joint}{two}</transmission>"
    );
    let together = format!("<transmission name=\"t\">{joint}{one}{two}</transmission>");
    for motors in [
        apart.clone(),
        together,
        format!("{gear}{apart}"),
        format!("{apart}{gear}"),
    ] {
        let text = file("").replace("<transmission name=\"t\"><joint name=\"j\"/>\n", "<gazebo>");
        let (robot, _) = text.split_once("<gazebo>").expect("a robot");
        let description = read_file(&format!("{robot}{motors}</robot>"));
        let chain = build(&description, &asked()).expect("a chain");
        assert_eq!(actuators(&chain), [[9.0, 0.0, 0.0]], "{motors}");
        // The check of every expansion computes the sum independently.
        let request = Request {
            functions: vec![vec![Function::InverseDynamics]],
            ..asked()
        };
        let module = crate::expand::expand(&description, &request);
        assert!(module.is_ok(), "{:?}", module.err());
        // The request replaces them all, rotor and ratio together.
        let number = |value: f64| Number {
            value,
            ..Number::default()
        };
        let alone = (named("j"), ActuatorQuantity::Rotor, vec![number(1.0)]);
        let ratio = (named("j"), ActuatorQuantity::Ratio, vec![number(3.0)]);
        let mut request = asked();
        request.actuators = vec![alone.clone()];
        let refused = build(&description, &request)
            .expect_err("a rotor of which motor")
            .to_string();
        assert!(
            refused.contains("the rotor of joint \"j\" is for one motor, but the file has"),
            "{refused}"
        );
        request.actuators = vec![alone, ratio];
        let chain = build(&description, &request).expect("a chain");
        assert_eq!(actuators(&chain), [[9.0, 0.0, 0.0]]);
    }
}

#[test]
fn a_rotor_of_no_joint_is_reported_although_rotors_are_requested() {
    let text = file("").replace(
        "<transmission name=\"t\"><joint name=\"j\"/>",
        "<transmission name=\"t\"><joint name=\"k\"/>",
    );
    let asked = Request {
        rotors: true,
        ..Request::default()
    };
    let chain = build(&read_file(&text), &asked).expect("a chain");
    let reported: Vec<&str> = chain
        .report
        .warnings
        .iter()
        .map(|reported| reported.message.as_str())
        .collect();
    let lost = "not modelled: the rotor of transmission \"t\", which has no single joint";
    assert!(reported.contains(&lost), "{reported:?}");
}

#[test]
fn impossible_numbers_of_actuators_are_refused_if_requested() {
    let description = read_file(&file("<dynamics damping=\"much\" friction=\"-1\"/>"));
    assert!(build(&description, &Request::default()).is_ok());
    let asked = Request {
        friction: true,
        ..Request::default()
    };
    assert_eq!(
        build(&description, &asked)
            .expect_err("two mistakes")
            .to_string(),
        lines(&[
            r#"error: r.urdf:2:106: the damping of joint "j" is not a number"#,
            r#"error: r.urdf:2:122: the friction of joint "j" is negative: -1"#,
        ])
    );
}

#[test]
fn requested_and_undescribed_actuators_give_a_warning() {
    let chain = fine(&arm("friction, rotors"));
    let warnings = chain.report.warnings.iter();
    let warnings: Vec<&str> = warnings.map(|warning| warning.message.as_str()).collect();
    let any = "is requested, but no moving joint has it in the description";
    assert!(
        warnings.contains(&format!("friction {any}").as_str()),
        "{warnings:?}"
    );
    assert!(
        warnings.contains(&format!("armature {any}").as_str()),
        "{warnings:?}"
    );
}

#[test]
fn every_front_end_gives_the_same_and_documents_it() {
    let builder = Builder::from_description(read_file(&file(DYNAMICS)))
        .friction()
        .damping("j", [2.0])
        .rotor("j", 0.5, 2.0)
        .armature("j", [1.0]);
    let module = builder
        .clone()
        .generate([Function::InverseDynamics])
        .module()
        .expect("no mistakes");
    let facts = module.about.facts.join("; ");
    let expected = "armature of 1 joint; viscous friction of 1 joint; Coulomb friction (its sign \
         that of q̇, 0 at rest: a step) of 1 joint; ";
    assert!(facts.starts_with(expected), "{facts}");
    let operation_count = module.functions[0].operation_count.to_string();
    // 1 kg m² of the link, 3 of the armature.
    assert!(
        operation_count.starts_with("3 mul, 2 add, 0 div, 1 sign, "),
        "{operation_count}"
    );
    let parameter = |target: fn(Name) -> Target| {
        builder
            .clone()
            .parameter("field", target(named("j")))
            .generate([Function::InverseDynamics])
            .module()
            .expect("no mistakes")
            .functions[0]
            .operation_count
            .to_string()
    };
    for target in [Target::ArmatureOf, Target::DampingOf, Target::FrictionOf] {
        assert!(parameter(target).contains("1 sign"));
    }
}

/// Every expansion is compared with dense matrices of the description, which compute these terms independently.
#[test]
fn every_type_of_joint_can_have_an_actuator() {
    let link = |name: &str| {
        format!(
            "link {name} {{ mass: 1.5, com: [0.1, 0.02, -0.03], inertia: [0.02, 0.001, 0, 0.03, 0, 0.04] }}"
        )
    };
    let actuator = |count: usize| {
        let list = |size: f64| {
            let entries = (1..=count)
                .map(|k| format!("{:?}", size / f64::from(u8::try_from(k).unwrap_or(1))));
            format!("[{}]", entries.collect::<Vec<_>>().join(", "))
        };
        let (armature, damping, friction) = (list(0.5), list(2.0), list(0.3));
        format!(
            "at: xyz(0.2, 0.1, 0.3) rpy(0.4, -0.3, 0.2), armature: {armature}, damping: {damping}, friction: {friction}"
        )
    };
    for (joint, count) in [
        ("revolute(y)", 1),
        ("prismatic(y)", 1),
        ("screw(y, pitch: 0.1)", 1),
        ("cylindrical(y)", 2),
        ("universal(x, y)", 2),
        ("translation", 3),
        ("planar(y)", 3),
        ("spherical", 3),
        ("floating", 6),
    ] {
        let (actuator, links) = (actuator(count), [link("a"), link("b"), link("c")].concat());
        let text = format!(
            "struct Robot; link base; {links}
            joint one: revolute(z) {{ from: base, to: a, armature: 0.25, friction: 0.5 }}
            joint two: {joint} {{ from: a, to: b, {actuator} }}
            joint three: revolute(x) {{ from: b, to: c, at: xyz(0, 0.2, 0), mimic: one, multiplier: -2.0,
                armature: 0.125, damping: 0.5, friction: 0.75 }}"
        );
        let (description, request) = read(&text);
        let generate = |request: &Request, functions: &[Function]| {
            let builder = Builder::from_description(description.clone()).request(request.clone());
            let module = builder.generate(functions.iter().copied()).module();
            module.unwrap_or_else(|errors| panic!("{joint}: {errors}"))
        };
        let module = generate(
            &request,
            &[
                Function::InverseDynamics,
                Function::Bias,
                Function::MassMatrix,
                Function::ForwardDynamics,
                Function::MassMatrixInverse,
                Function::KineticEnergy,
                Function::InverseDynamicsDerivatives,
                Function::CoriolisMatrix,
                Function::Regressor,
                Function::BaseRegressor,
            ],
        );
        let facts = module.about.facts.join("; ");
        assert!(facts.starts_with("armature of 3 joints"), "{facts}");
        // Without the mimic joint there are articulated bodies as well.
        let alone = Request {
            drop: vec![named("c")],
            formulation: crate::formulation::Formulation::default()
                .with_forward(crate::formulation::Forward::Articulated),
            ..request
        };
        generate(
            &alone,
            &[
                Function::ForwardDynamics,
                Function::ForwardDynamicsDerivatives,
                Function::MassMatrixInverse,
            ],
        );
    }
}

/// Armature, damping, friction and external wrenches together, with wrenches in the link's frame and in frame 0, on
/// joints with several velocities and on a mimic joint.
#[test]
fn derivatives_include_actuators_and_wrenches_on_every_type_of_joint() {
    let link = |name: &str| {
        format!(
            "link {name} {{ mass: 1.5, com: [0.1, 0.02, -0.03], inertia: [0.02, 0.001, 0, 0.03, 0, 0.04] }}"
        )
    };
    let links = ["a", "b", "c", "d"].map(link).concat();
    for joint in ["cylindrical(y)", "planar(y)", "spherical", "floating"] {
        for frame in ["", ", frame = 0"] {
            let (description, request) = read(&format!(
                "struct Robot {{ external(b, c, d{frame}) }} link base; {links}
                joint one: revolute(z) {{ from: base, to: a, armature: 0.25, friction: 0.5 }}
                joint two: {joint} {{ from: a, to: b, at: xyz(0.2, 0.1, 0.3) rpy(0.4, -0.3, 0.2), damping: 0.5 }}
                joint three: revolute(x) {{ from: b, to: c, at: xyz(0, 0.2, 0), mimic: one, multiplier: -2.0,
                    armature: 0.125, damping: 0.5, friction: 0.75 }}
                joint four: prismatic(x) {{ from: b, to: d, at: rz(0.3), damping: 2 }}"
            ));
            let builder = Builder::from_description(description).request(request);
            let functions = [
                Function::InverseDynamicsDerivatives,
                Function::ForwardDynamicsDerivatives,
            ];
            let module = builder.generate(functions).module();
            module.unwrap_or_else(|errors| panic!("{joint}{frame}: {errors}"));
        }
    }
}

/// Ṁ − 2C is skew-symmetric, with and without friction, since friction is not in C.
#[test]
fn the_coriolis_matrix_has_no_friction() {
    let builder = |settings: &str| {
        let (description, request) = read(&arm(settings));
        let builder = Builder::from_description(description).request(request);
        builder.generate([Function::CoriolisMatrix])
    };
    let program = |settings: &str| {
        let module = builder(settings).module().expect("no mistakes");
        format!("{:?}", module.functions[0].program)
    };
    let actuators = "armature(shoulder = 1), damping(elbow = 2), friction(shoulder = 3)";
    assert_eq!(program(actuators), program(""));
    let says = |settings: &str| {
        let source = builder(settings)
            .to_source()
            .expect("no mistakes")
            .to_string();
        source.contains("do not include friction and armature")
    };
    assert_eq!([says(actuators), says("")], [true, false]);
}

/// The columns of links are followed by three for each velocity of a joint, if any of these is modelled. Every
/// expansion checks their values.
#[test]
fn regressors_have_columns_of_actuators() {
    let said_of = |settings: &str| {
        let (description, request) = read(&arm(settings));
        let builder = Builder::from_description(description).request(request);
        let module = builder.generate([Function::BaseRegressor, Function::Regressor]);
        module.module().expect("no mistakes").spaces
    };
    let of_actuators = |settings: &str| -> Vec<String> {
        let parameters = said_of(settings).parameters;
        let names = parameters.into_iter().map(|entry| entry.name);
        names
            .filter(|name| !name.contains(".J_") && !name.contains(".q_") && !name.contains(".m"))
            .collect()
    };
    assert_eq!(of_actuators(""), [""; 0]);
    let expected = ["shoulder", "elbow"]
        .map(|joint| ["armature", "damping", "friction"].map(|part| format!("{joint}.{part}")));
    for settings in ["damping(elbow = 2)", "friction", "rotors"] {
        assert_eq!(of_actuators(settings), expected.concat(), "{settings}");
    }
}

/// Checks the comments of generated code, and the names beside the values of base parameters.
#[test]
fn regressors_document_their_columns() {
    let source = |settings: &str| {
        let (description, request) = read(&arm(settings));
        let builder = Builder::from_description(description).request(request);
        let builder = builder.generate([Function::BaseRegressor, Function::Regressor]);
        builder.to_source().expect("no mistakes").to_string()
    };
    for said in [
        "armature, damping and friction of each degree of freedom",
        "damping in N m s/rad or N s/m",
    ] {
        assert!(source("friction").contains(said), "{said}");
        assert!(!source("").contains(said), "{said}");
    }
}
