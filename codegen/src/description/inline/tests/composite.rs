//! Composite joints, and their errors.

use super::*;

/// For each joint: name, type, links, translations and upper limit.
fn joints(text: &str) -> Vec<String> {
    let description = fine(text).description.unwrap();
    let joints = description.joints.iter().map(|joint| {
        let steps = joint.origin.iter().map(|step| match step {
            Step::Translate(shift) => shift.map(|number| number.value),
            Step::Rotate(_, angle) => [angle.value; 3],
            Step::Quaternion(_) => unreachable!("the grammar has no quaternions"),
        });
        format!(
            "{} {} {} {} {:?} {:?}",
            joint.name.text,
            joint.kind.word(),
            joint.parent.text,
            joint.child.text,
            steps.collect::<Vec<_>>(),
            joint.limits.map(|limits| limits.upper),
        )
    });
    joints.collect()
}

#[test]
fn a_composite_is_joints_in_series_with_massless_links() {
    let composed = "struct Leg;
        link pelvis;
        joint hip: composite(
            yaw: revolute(z) { limits: [-1, 1] },
            \"roll\": prismatic(x) { at: xyz(0, 0.1, 0), velocity: 2, armature: 0.1 },
            pitch: universal(y, x),
        ) { at: xyz(0.3, 0, 0) }
        link thigh { mass: 1, inertia: [1, 1, 1] }
        joint ankle: composite(a: revolute(x), b: revolute(y) { mimic: \"ankle.a\" }) { from: thigh, to: foot }
        link foot";
    let apart = "struct Leg;
        link pelvis;
        joint \"hip.yaw\": revolute(z) { from: pelvis, to: \"hip.yaw\", at: xyz(0.3, 0, 0), limits: [-1, 1] }
        joint \"hip.roll\": prismatic(x) {
            from: \"hip.yaw\", to: \"hip.roll\", at: xyz(0, 0.1, 0), velocity: 2, armature: 0.1
        }
        joint \"hip.pitch\": universal(y, x) { from: \"hip.roll\" }
        link thigh { mass: 1, inertia: [1, 1, 1] }
        joint \"ankle.a\": revolute(x) { from: thigh, to: \"ankle.a\" }
        joint \"ankle.b\": revolute(y) { from: \"ankle.a\", to: foot, mimic: \"ankle.a\" }
        link foot; link \"hip.yaw\"; link \"hip.roll\"; link \"ankle.a\"";
    assert_eq!(joints(composed), joints(apart));
    let description = fine(composed).description.unwrap();
    let links: Vec<&str> = (description.links.iter().map(|link| link.name.text.as_str())).collect();
    assert_eq!(
        links,
        ["pelvis", "thigh", "foot", "hip.yaw", "hip.roll", "ankle.a"]
    );
}

#[test]
fn errors_of_composites_show_the_syntax() {
    let nothing = "2:12: joint \"hip\" has no motions
  hint: write composite(yaw: revolute(z), roll: revolute(x))
";
    assert_eq!(errors_in_joint("joint hip: composite;"), nothing);
    assert_eq!(
        errors_in_joint("joint hip: composite() { from: a, to: b }"),
        nothing
    );
    assert_eq!(
        errors_in_joint(
            "joint hip: composite(yaw: revolute, roll: hinge(x), revolute(y), pitch: revolute(y) \
             { from: a }, sway: composite(x: revolute(x)) extra) { from: a, to: b, limits: [0, 1], armature: 1 }"
        ),
        "2:27: joint \"hip.yaw\" has no axis
  hint: write revolute(z)
2:43: joint \"hip.roll\" has the unknown type \"hinge\"
  hint: write revolute
2:61: expected `:` after joint \"revolute\"
  hint: write joint elbow: revolute(z)
2:87: joint \"hip.pitch\" has the unknown key \"from\"
  hint: known keys: at, limits, velocity, mimic, multiplier, offset, armature, rotor, ratio, damping and friction
2:104: joint \"hip.sway\" has the unknown type \"composite\"
  hint: known types: revolute, continuous, prismatic, screw, cylindrical, universal, translation, planar, spherical, floating and fixed
2:130: expected `{` or `;` after joint \"hip.sway\"
2:163: joint \"hip\" has the key \"limits\" for all of its motions
  hint: write it after one of them: yaw: revolute(z) { limits: … }
2:181: joint \"hip\" has the key \"armature\" for all of its motions
  hint: write it after one of them: yaw: revolute(z) { armature: … }
"
    );
    assert_eq!(
        errors_in_joint(
            "joint hip: composite(yaw: revolute(z), yaw: revolute(x)) { from: a, to: b }"
        ),
        "2:40: there is another joint \"hip.yaw\"
"
    );
}
