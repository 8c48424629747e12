//! Attached bodies, frames and models: names, settings, gravity, constraints and keyframes.

use super::files::read_in;
use super::{all_near, errors, fine, in_world, inertial, joint, near, pose, values};
use crate::description::Description;
use crate::joint::actuator::ActuatorQuantity;

/// A model whose settings differ from those of the model around it.
const CHILD: &str = r#"<mujoco model="child">
  <compiler angle="radian" boundmass="0.7"/>
  <option gravity="0 0 -5"/>
  <default><joint armature="0.25"/><default class="slow"><joint damping="3"/></default></default>
  <asset><mesh name="part" file="part.obj"/></asset>
  <worldbody>
    <site name="mark" pos="0 0 2"/>
    <body name="a" pos="0 0 1">
      <joint name="j1"/>
      <geom size="0.1" mass="1"/>
      <frame name="frame" pos="0 1 0" euler="0 0 0.5">
        <joint name="j2" axis="1 0 0" class="slow"/>
        <body name="b" pos="0.1 0 0"><joint name="j3" ref="0.2"/><joint axis="1 0 0"/><geom size="0.1" mass="0.1"/></body>
      </frame>
    </body>
  </worldbody>
  <equality>
    <joint name="pair" joint1="j3" joint2="j2"/>
    <connect name="held" body1="b" body2="world" anchor="0 0 0"/>
  </equality>
  <actuator><motor joint="j2" armature="0.5" gear="3"/></actuator>
  <keyframe><key name="home" qpos="1 2 3 4"/></keyframe>
</mujoco>
"#;

/// Reads a file that can attach the model `child`.
fn attaching(name: &str, settings: &str, bodies: &str) -> (Option<Description>, String) {
    let text = format!(
        "<mujoco>{settings}<asset><model file=\"parts/child.xml\"/></asset>\n<worldbody>{bodies}</worldbody></mujoco>"
    );
    read_in(name, &[("arm.xml", &text), ("parts/child.xml", CHILD)])
}

fn attached(name: &str, bodies: &str) -> Description {
    let (robot, errors) = attaching(name, "", bodies);
    assert_eq!(errors, "");
    robot.unwrap()
}

fn joint_names(robot: &Description) -> Vec<&str> {
    let joints = robot.joints.iter().filter(|joint| joint.kind.moves());
    joints.map(|joint| &*joint.name.text).collect()
}

fn link_names(robot: &Description) -> Vec<&str> {
    robot.links.iter().map(|link| &*link.name.text).collect()
}

/// The configurations: each with its name, and its coordinates by joint.
fn configurations(robot: &Description) -> Vec<(&str, Vec<f64>)> {
    let configurations = robot.configurations.iter();
    configurations
        .map(|configuration| {
            let joints = configuration.joints.iter();
            let q = joints.flat_map(|(_, own)| own.iter().map(|entry| entry.value));
            (&*configuration.name.text, q.collect())
        })
        .collect()
}

#[test]
fn an_attached_body_keeps_its_settings_and_gets_a_prefix() {
    let robot = attached(
        "attached-body",
        "<frame pos=\"1 0 0\"><attach model=\"child\" body=\"a\" prefix=\"L_\"/></frame><body name=\"own\"><joint name=\"j\"/></body>",
    );
    assert_eq!(
        joint_names(&robot),
        ["L_j1", "L_j2", "L_j3", "L_b_hinge", "j"]
    );
    // Angles in radians, and in the frames of the attached model.
    let (rotation, position) = pose(&joint(&robot, "L_j1").origin);
    all_near(position, [1.0, 0.0, 1.0]);
    near(rotation[0][0], 1.0);
    let second = joint(&robot, "L_j2");
    all_near(values(second.axis), [0.5_f64.cos(), 0.5_f64.sin(), 0.0]);
    near(inertial(&robot, "L_b").mass.value, 0.7);
    assert!(
        robot
            .links
            .iter()
            .find(|link| link.name.text == "own")
            .unwrap()
            .inertial
            .is_none()
    );
    let mimic = joint(&robot, "L_j3").mimic.as_ref().unwrap();
    assert_eq!(mimic.mimicked.text, "L_j2");
    near(second.actuator.of(ActuatorQuantity::Rotor)[0].value, 0.5);
    assert_eq!(robot.loops.len(), 1);
    assert_eq!(robot.loops[0].name.text, "L_held");
    assert_eq!(robot.loops[0].to.text, "world");
}

#[test]
fn an_attached_frame_moves_its_body() {
    let robot = attached(
        "attached-frame",
        "<body name=\"base\"><attach model=\"child\" frame=\"frame\" prefix=\"L_\"/></body>",
    );
    assert_eq!(joint_names(&robot), ["L_j2", "L_j3", "L_b_hinge"]);
    assert_eq!(joint(&robot, "L_j2").parent.text, "world");
    let (_, position) = pose(&joint(&robot, "L_j3").origin);
    all_near(
        position,
        [0.1 * 0.5_f64.cos(), 1.0 + 0.1 * 0.5_f64.sin(), 0.0],
    );
    assert_eq!(configurations(&robot), [("L_home", vec![2.0, 3.0, 4.0])]);
}

#[test]
fn an_attached_world_is_part_of_the_body_around_it() {
    let robot = attached(
        "attached-world",
        "<body name=\"base\"><joint name=\"j\"/><attach model=\"child\" prefix=\"L_\"/></body>",
    );
    assert_eq!(
        link_names(&robot),
        [
            "world", "base", "L_mark", "L_a.L_j1", "L_a.L_j2", "L_a", "L_b.L_j3", "L_b"
        ]
    );
    assert_eq!(joint(&robot, "L_mark").parent.text, "base");
    assert_eq!(joint(&robot, "L_j1").parent.text, "base");
}

#[test]
fn a_body_may_be_attached_several_times() {
    let robot = attached(
        "attached-twice",
        "<attach model=\"child\" body=\"b\" prefix=\"L_\"/>\
         <replicate count=\"2\" offset=\"1 0 0\"><attach model=\"child\" body=\"a\" prefix=\"R_\"/></replicate>",
    );
    assert_eq!(
        joint_names(&robot),
        [
            "L_j3",
            "L_b_hinge",
            "R_j10",
            "R_j20",
            "R_j30",
            "R_b0_hinge",
            "R_j11",
            "R_j21",
            "R_j31",
            "R_b1_hinge",
        ]
    );
    for (mimic, mimicked) in [("R_j30", "R_j20"), ("R_j31", "R_j21")] {
        let found = joint(&robot, mimic).mimic.as_ref().unwrap();
        assert_eq!(found.mimicked.text, mimicked);
    }
    assert!(joint(&robot, "L_j3").mimic.is_none());
    // The values of the first copy; those of the others are the described ones.
    assert_eq!(
        configurations(&robot),
        [
            (
                "L_home",
                vec![3.0, 4.0, 0.0, 0.0, 0.2, 0.0, 0.0, 0.0, 0.2, 0.0]
            ),
            (
                "R_home",
                vec![0.2, 0.0, 1.0, 2.0, 3.0, 4.0, 0.0, 0.0, 0.2, 0.0]
            ),
        ]
    );
}

#[test]
fn attached_models_attach_others() {
    let middle = "<mujoco model=\"middle\"><asset><model name=\"c\" file=\"child.xml\"/></asset><worldbody>\
                  <body name=\"m\"><joint name=\"jm\"/><attach model=\"c\" body=\"a\" prefix=\"C_\"/></body></worldbody>\
                  <keyframe><key name=\"all\" qpos=\"9 1 2 3 4\"/></keyframe></mujoco>";
    let robot = |name: &str, body: &str| {
        let text = format!(
            "<mujoco><asset><model name=\"m\" file=\"parts/middle.xml\"/></asset><worldbody>\
             <attach model=\"m\" body=\"{body}\" prefix=\"M_\"/></worldbody></mujoco>"
        );
        let files = [
            ("arm.xml", &*text),
            ("parts/middle.xml", middle),
            ("parts/child.xml", CHILD),
        ];
        let (robot, errors) = read_in(name, &files);
        assert_eq!(errors, "");
        robot.unwrap()
    };
    let whole = robot("nested-attachment", "m");
    assert_eq!(
        joint_names(&whole),
        ["M_jm", "M_C_j1", "M_C_j2", "M_C_j3", "M_C_b_hinge"]
    );
    assert_eq!(
        configurations(&whole),
        [
            ("M_all", vec![9.0, 1.0, 2.0, 3.0, 4.0]),
            ("M_C_home", vec![0.0, 1.0, 2.0, 3.0, 4.0]),
        ]
    );
    let part = robot("part-of-an-attachment", "C_b");
    assert_eq!(joint_names(&part), ["M_C_j3", "M_C_b_hinge"]);
    assert_eq!(
        configurations(&part),
        [("M_all", vec![3.0, 4.0]), ("M_C_home", vec![3.0, 4.0])]
    );
}

#[test]
fn a_model_attaches_its_own_bodies() {
    let robot = fine(
        "<mujoco><worldbody><body name=\"a\"><joint name=\"j\"/><body name=\"b\"><joint name=\"k\"/></body></body>\
         <frame pos=\"1 0 0\"><attach body=\"a\" prefix=\"L_\"/></frame></worldbody>\
         <equality><joint joint1=\"k\" joint2=\"j\"/></equality>\
         <keyframe><key name=\"home\" qpos=\"1 2 3 4\"/></keyframe></mujoco>",
    );
    assert_eq!(joint_names(&robot), ["j", "k", "L_j", "L_k"]);
    for (mimic, mimicked) in [("k", "j"), ("L_k", "L_j")] {
        let found = joint(&robot, mimic).mimic.as_ref().unwrap();
        assert_eq!(found.mimicked.text, mimicked);
    }
    assert_eq!(configurations(&robot), [("home", vec![1.0, 2.0, 3.0, 4.0])]);
}

#[test]
fn constraints_and_actuators_are_copied_with_their_joints() {
    let robot = fine(
        "<mujoco><worldbody><replicate count=\"2\"><body name=\"a\"><joint name=\"j\"/><body><joint name=\"k\"/></body></body>\
         </replicate></worldbody><equality><joint name=\"e\" joint1=\"k\" joint2=\"j\"/></equality>\
         <actuator><motor joint=\"j\" armature=\"1\"/></actuator></mujoco>",
    );
    for (mimic, mimicked) in [("k0", "j0"), ("k1", "j1")] {
        let found = joint(&robot, mimic).mimic.as_ref().unwrap();
        assert_eq!(found.mimicked.text, mimicked);
        assert_eq!(
            joint(&robot, mimicked)
                .actuator
                .of(ActuatorQuantity::Rotor)
                .len(),
            1
        );
    }
}

#[test]
fn a_name_that_only_looks_like_that_of_a_copy_is_another_one() {
    let robot = fine(
        "<mujoco><worldbody><body name=\"a\"><joint name=\"j1\"/></body><body name=\"b\"><joint name=\"j10\"/></body>\
         <replicate count=\"2\"><body name=\"c\"/></replicate></worldbody>\
         <actuator><motor joint=\"j1\" armature=\"1\"/></actuator></mujoco>",
    );
    assert_eq!(
        joint(&robot, "j1")
            .actuator
            .of(ActuatorQuantity::Rotor)
            .len(),
        1
    );
    assert!(
        joint(&robot, "j10")
            .actuator
            .of(ActuatorQuantity::Rotor)
            .is_empty()
    );
}

#[test]
fn classes_and_meshes_of_an_attached_model_have_names_with_the_prefix() {
    let text = "<mujoco><asset><model file=\"parts/child.xml\"/></asset><worldbody><body name=\"x\" childclass=\"L_slow\">\
                <joint name=\"j\"/><geom type=\"mesh\" mesh=\"L_part\"/></body>\
                <attach model=\"child\" body=\"b\" prefix=\"L_\"/><body name=\"y\" childclass=\"L_slow\"><joint name=\"k\"/></body>\
                </worldbody></mujoco>";
    let text = text.replace("x\" childclass=\"L_slow\"", "x\"");
    let files = [
        ("arm.xml", &*text),
        ("parts/child.xml", CHILD),
        ("parts/part.obj", super::files::TETRAHEDRON),
    ];
    let (robot, errors) = read_in("imported", &files);
    assert_eq!(errors, "");
    let robot = robot.unwrap();
    near(inertial(&robot, "x").mass.value, 1000.0 / 6.0);
    near(
        joint(&robot, "k").actuator.of(ActuatorQuantity::Damping)[0].value,
        3.0,
    );
}

#[test]
fn gravity_is_that_of_the_first_file_unless_settings_are_merged() {
    let attach = "<attach model=\"child\" body=\"b\" prefix=\"L_\"/>";
    let gravity = |name: &str, settings: &str| {
        let (robot, errors) = attaching(name, settings, attach);
        let robot = robot.unwrap();
        let warning = robot
            .warnings
            .iter()
            .any(|warning| warning.message == "gravity of the attached model \"child\" is ignored");
        (robot.gravity.map(values), warning, errors)
    };
    let none = String::new();
    assert_eq!(gravity("gravity-none", ""), (None, true, none.clone()));
    assert_eq!(
        gravity("gravity-same", "<option gravity=\"0 0 -5\"/>"),
        (Some([0.0, 0.0, -5.0]), false, none.clone())
    );
    assert_eq!(
        gravity("gravity-other", "<option gravity=\"0 0 1\"/>"),
        (Some([0.0, 0.0, 1.0]), true, none.clone())
    );
    assert_eq!(
        gravity("gravity-merge", "<compiler conflict=\"merge\"/>"),
        (Some([0.0, 0.0, -5.0]), false, none)
    );
    for policy in ["merge", "error"] {
        let settings = format!("<compiler conflict=\"{policy}\"/><option gravity=\"0 0 1\"/>");
        let (_, _, errors) = gravity(&format!("gravity-{policy}-two"), &settings);
        assert!(
            errors.contains("the attached model \"child\" has another gravity"),
            "{errors}"
        );
    }
}

#[test]
fn constraints_on_elements_that_are_not_attached_are_warnings() {
    let robot = attached(
        "detached",
        "<attach model=\"child\" body=\"b\" prefix=\"L_\"/>",
    );
    let messages: Vec<&str> = robot
        .warnings
        .iter()
        .map(|warning| &*warning.message)
        .collect();
    assert!(
        messages.contains(&"not modelled: <joint>: a constraint on elements that are not attached"),
        "{messages:?}"
    );
}

#[test]
fn mistakes_of_attachments_are_errors() {
    let error = |name: &str, bodies: &str| attaching(name, "", bodies).1;
    for (name, bodies, message) in [
        (
            "wrong-model",
            "<attach model=\"chid\" prefix=\"\"/>",
            "error: arm.xml:2:27: an <attach> names a model that does not exist: \"chid\"\n  hint: did you mean \"child\"? known models: child\n",
        ),
        (
            "wrong-body",
            "<attach model=\"child\" body=\"c\" prefix=\"\"/>",
            "an <attach> names a body that does not exist: \"c\"\n  hint: known bodies: a and b\n",
        ),
        (
            "wrong-frame",
            "<attach model=\"child\" frame=\"fram\" prefix=\"\"/>",
            "an <attach> names a frame that does not exist: \"fram\"\n  hint: did you mean \"frame\"? known frames: frame\n",
        ),
        (
            "no-prefix",
            "<attach model=\"child\"/>",
            "an <attach> has no prefix\n  hint: write prefix=\"…\"; it may be empty\n",
        ),
        (
            "body-and-frame",
            "<attach model=\"child\" body=\"a\" frame=\"frame\" prefix=\"\"/>",
            "an <attach> has both body and frame\n  hint: leave one of them out\n",
        ),
        (
            "no-model",
            "<attach prefix=\"a\"/>",
            "an <attach> has no model\n",
        ),
    ] {
        let found = error(name, bodies);
        assert!(found.contains(message), "{bodies}: {found}");
    }
    let twice = "<attach model=\"child\" body=\"b\" prefix=\"\"/>".repeat(2);
    assert!(error("same-prefix", &twice).contains("\"b\""));
}

#[test]
fn files_that_cannot_be_attached_are_errors() {
    let error = |name: &str, file: &str, others: &[(&str, &str)]| {
        let text = format!("<mujoco><asset>\n<model name=\"m\" file=\"{file}\"/></asset></mujoco>");
        let mut files = vec![("arm.xml", text.as_str())];
        files.extend(others);
        read_in(name, &files).1
    };
    assert!(
        error("attach-missing", "no.xml", &[])
            .starts_with("error: arm.xml:2:1: cannot attach \"no.xml\": there is no such file\n")
    );
    assert!(error("attach-outside", "../a.xml", &[]).contains("it is outside the folder"));
    assert!(
        error("attach-itself", "arm.xml", &[]).contains("\"arm.xml\" is attached within itself")
    );
    let other = (
        "b.xml",
        "<mujoco><asset>\n <model file=\"arm.xml\"/></asset></mujoco>",
    );
    assert_eq!(
        error("attach-loop", "b.xml", &[other]),
        "error: b.xml:2:2: \"arm.xml\" is attached within itself\n  hint: attached models must not form a loop\n"
    );
    let urdf = ("b.urdf", "<robot/>");
    assert!(
        error("attach-urdf", "b.urdf", &[urdf])
            .contains("cannot attach \"b.urdf\": it is not an MJCF file")
    );
    let text = "<mujoco><asset><model/></asset></mujoco>";
    assert!(errors(text).contains("<model> has no attribute \"file\""));
    let text = "<mujoco><asset><model file=\"a\"/></asset></mujoco>";
    assert!(errors(text).contains("cannot attach \"a\": a text without a file has no folder"));
}

#[test]
fn generated_bodies_are_errors() {
    for tag in ["composite", "flexcomp"] {
        let found = errors(&in_world(&format!(
            "<body name=\"a\"><{tag} type=\"grid\"/></body>"
        )));
        assert!(
            found.contains(&format!("the bodies of a <{tag}> are not read")),
            "{found}"
        );
    }
    let rigid = in_world("<body name=\"a\"><flexcomp name=\"f\" rigid=\"true\"/></body>");
    assert_eq!(errors(&rigid), "");
}

#[test]
fn attachments_of_attachments_are_bounded() {
    const LEVELS: usize = 25;
    let files: Vec<(String, String)> = (0..LEVELS)
        .map(|level| {
            let name = match level {
                0 => "arm.xml".to_owned(),
                _ => format!("{level}.xml"),
            };
            let asset = format!(
                "<asset><model name=\"m\" file=\"{}.xml\"/></asset>",
                level + 1
            );
            let bodies = "<attach model=\"m\" prefix=\"a\"/><attach model=\"m\" prefix=\"b\"/>";
            let text = if level + 1 == LEVELS {
                "<mujoco><worldbody><body name=\"c\"/></worldbody></mujoco>".to_owned()
            } else {
                format!("<mujoco>{asset}<worldbody>{bodies}</worldbody></mujoco>")
            };
            (name, text)
        })
        .collect();
    let files: Vec<(&str, &str)> = (files.iter())
        .map(|(name, text)| (name.as_str(), text.as_str()))
        .collect();
    let (_, errors) = read_in("attachments", &files);
    assert!(errors.contains("attach or replicate less"), "{errors}");
}
