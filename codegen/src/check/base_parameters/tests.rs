//! Base parameters: their number is the rank of the regressor, their values are right, and uncertain ones are refused.

use std::fmt::Write;
use std::path::Path;

use super::judge_base_parameters;
use crate::chain::base_parameters::{BaseParameter, BaseParameters};
use crate::check::is_fault;
use crate::check::tests::{all_of, described, table};
use crate::description::{Description, inline, read_text};
use crate::error::Errors;
use crate::expand::{expand, understand};
use crate::function::Function;
use crate::list::Id;
use crate::request::Request;

/// An arm with a residue in its third axis, which is parallel to the second but for the last digit of a number of 64
/// bits: the residue and its square are so far apart that 106 bits do not hold both.
const ASKEW: &str = r#"<robot name="askew"><link name="base"/>
    <link name="a"><inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
    <link name="b"><inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
    <link name="c"><inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
    <joint name="one" type="continuous"><parent link="base"/><child link="a"/><axis xyz="0 0 1"/></joint>
    <joint name="two" type="continuous"><parent link="a"/><child link="b"/><axis xyz="0 1 0"/>
    <origin xyz="0.3 0 0.1" rpy="1.5707963267948966 0 0"/></joint>
    <joint name="three" type="continuous"><parent link="b"/><child link="c"/><axis xyz="0 1 0"/>
    <origin xyz="0.2 0.1 0" rpy="0 0 1.5707963267948966"/></joint></robot>"#;

#[test]
fn undeterminable_base_parameters_are_refused_by_name() {
    let mut errors = Errors::new();
    let askew = read_text(ASKEW, "askew.urdf", None, &mut errors).expect("a robot");
    let asked = |functions| Request {
        exact: true,
        functions,
        ..Request::default()
    };
    let alone = asked(vec![vec![Function::BaseRegressor]]);
    let refusal = expand(&askew, &alone).expect_err("106 bits do not tell");
    let found = refusal.to_string();
    assert!(
        found.contains("base parameters cannot be told apart"),
        "{found}"
    );
    assert!(!found.contains("fault"), "{found}");
    // A request of all functions leaves that one out.
    let module = expand(&askew, &asked(Vec::new())).unwrap_or_else(|errors| panic!("{errors}"));
    let of = |generated: &crate::module::GeneratedFunction| {
        generated.functions.contains(&Function::BaseRegressor)
    };
    assert!(!module.functions.iter().any(of) && module.functions.len() > 20);
    let left_out = module.about.left_out.iter();
    let left_out = left_out.filter(|left_out| left_out.functions == ["base_regressor"]);
    assert_eq!(
        left_out.map(|one| one.is_fault).collect::<Vec<_>>(),
        [false]
    );
}

/// An arm whose last link moves a hundred kilometres away, where moments of inertia are a billionth of the effect of
/// its mass on torques.
#[test]
fn base_parameters_of_lengths_that_differ_by_five_orders_are_determined() {
    let far = table(
        "convention modified
joint     kind        a    alpha   d     theta  link    mass cx   cy cz   ixx  ixy ixz iyy  iyz izz
waist     revolute    0    0       0.4   0      trunk   3.2  0.1  0  0    0.1  0   0   0.1  0   0.1
shoulder  revolute    0    -pi/2   0     0      upper   2    0.2  0  0.01 0.02 0   0   0.1  0   0.1
elbow     revolute    0.43 0       0.15  pi/2   fore    1    0    -0.1 0  0.01 0   0   0.01 0   0.01
quill     prismatic   0    1.5708  100000.1 0   rod     0.5  0    0  0    0    0   0   0    0   0
",
    );
    assert_eq!(judged(&far, &Request::default()), Ok(BASE_OF_FAR));
}

/// As many as for the same arm with a last link that moves 10 cm away.
const BASE_OF_FAR: usize = 19;

/// The number of a robot's base parameters, if they are right.
fn judged(description: &Description, request: &Request) -> Result<usize, String> {
    let chain = understand(description, request).unwrap_or_else(|errors| panic!("{errors}"));
    let chain = chain.identified();
    let judged = judge_base_parameters(&chain);
    let found = chain.base_parameters.expect("they are found");
    judged.map_or_else(
        |errors| Err(errors.to_string()),
        |()| Ok(found.groups.len()),
    )
}

/// A chain of joints about y, x and z in turn, with links of a length, in which all but the first of some joints
/// mimic it.
fn snake(joints: usize, length: f64, mimics: usize) -> Description {
    let mut text = r#"<robot name="snake"><link name="l0"/>"#.to_owned();
    let [mass, inertia] = [
        length * length * length,
        length * length * length * length * length,
    ];
    for k in 1..=joints {
        let axis = ["0 0 1", "0 1 0", "1 0 0"][k % 3];
        let before = k - 1;
        let mimic = match k {
            2.. if k <= mimics + 1 => {
                let multiplier = ["0.75", "-1", "1.5", "2"][k % 4];
                format!(r#"<mimic joint="j1" multiplier="{multiplier}"/>"#)
            }
            _ => String::new(),
        };
        // Writing to a string cannot fail.
        let _ = write!(
            text,
            r#"<link name="l{k}"><inertial><origin xyz="{x} {y} {z}"/><mass value="{mass}"/>
            <inertia ixx="{ixx}" iyy="{iyy}" izz="{iyy}" ixy="0" ixz="0" iyz="0"/></inertial></link>
            <joint name="j{k}" type="continuous"><parent link="l{before}"/><child link="l{k}"/>
            <origin xyz="{long} 0 0" rpy="0.1 0 0.2"/><axis xyz="{axis}"/>{mimic}</joint>"#,
            x = 0.1 * length,
            y = 0.02 * length,
            z = 0.03 * length,
            long = 0.2 * length,
            ixx = 0.01 * inertia,
            iyy = 0.02 * inertia,
        );
    }
    text += "</robot>";
    let mut errors = Errors::new();
    read_text(&text, "snake.urdf", None, &mut errors).expect("a robot")
}

#[test]
fn base_parameters_of_many_joints_on_a_path_are_as_many_as_the_rank() {
    // The first joint, about a horizontal axis, has three, each other one seven: 136 for 20 joints.
    let request = Request::default();
    for joints in [1, 12, 20, 40] {
        let expected = judged(&snake(joints, 1.0, 0), &request);
        assert_eq!(expected, Ok(3 + 7 * (joints - 1)), "{joints} joints");
    }
}

#[test]
fn base_parameters_do_not_depend_on_the_unit_of_length() {
    let actuated = Request {
        friction: true,
        ..Request::default()
    };
    for request in [Request::default(), actuated] {
        let expected = judged(&snake(5, 1.0, 2), &request);
        assert!(expected.is_ok(), "{expected:?}");
        for length in [1e-6, 1e-3, 1e3] {
            assert_eq!(
                judged(&snake(5, length, 2), &request),
                expected,
                "{length} m"
            );
        }
    }
}

/// A link slides along the axis about which gravity rotates it: its armature acts like mass, except for the weight
/// and the moment of that mass, which the first link's parameters compensate.
#[test]
fn an_armature_along_a_rotating_axis_is_mass_without_weight() {
    let text = r#"<robot name="lathe"><link name="bed"/>
        <link name="arm"><inertial><mass value="2"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
        <link name="slide"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
        <joint name="turn" type="continuous"><parent link="bed"/><child link="arm"/><axis xyz="0 1 0"/></joint>
        <joint name="push" type="prismatic"><parent link="arm"/><child link="slide"/><origin xyz="0.3 0 0.1"/><axis xyz="0 1 0"/>
        <limit lower="-1" upper="1" velocity="1" effort="1"/></joint></robot>"#;
    let mut errors = Errors::new();
    let lathe = read_text(text, "lathe.urdf", None, &mut errors).expect("a robot");
    let request = Request {
        friction: true,
        ..Request::default()
    };
    // J_yy, q_x and q_z of the arm, the mass of the slider, and damping and friction of both.
    assert_eq!(judged(&lathe, &request), Ok(8));
}

#[test]
fn wrong_base_parameters_are_a_fault() {
    let (description, request) = (described("puma560.urdf"), Request::default());
    let chain = understand(&description, &request).unwrap_or_else(|errors| panic!("{errors}"));
    let chain = chain.identified();
    let refused = |change: &dyn Fn(&mut BaseParameters)| {
        let mut chain = chain.clone();
        change(chain.base_parameters.as_mut().expect("they are found"));
        let judged = judge_base_parameters(&chain);
        judged
            .err()
            .map(|refusal| (is_fault(&refusal), refusal.to_string()))
    };
    assert_eq!(refused(&|_| {}), None);
    let expect = |change: &dyn Fn(&mut BaseParameters), what: &str| {
        let (fault, found) = refused(change).expect("it is wrong");
        assert!(fault && found.contains(what), "{found}");
    };
    let off = "by base parameters would be off by";
    // One too few, and a factor with an error of a millionth.
    expect(&|base| drop(base.groups.remove(5)), off);
    let changed = |base: &mut BaseParameters| {
        let mut members = base
            .groups
            .iter_mut()
            .flat_map(|group| &mut group.members[1..]);
        members.next().expect("one is grouped").1 *= 1.0 + 1e-6;
    };
    expect(&changed, off);
    // A value.
    let valued =
        |base: &mut BaseParameters| base.groups[5].value += 0.1 * base.groups[5].size + 1e-3;
    expect(&valued, "by base parameters would be");
    // One too many: a member leads a group of its own.
    let split = |base: &mut BaseParameters| {
        let grouped = base.groups.iter().find(|group| group.members.len() > 1);
        let (member, _) = grouped.expect("one is grouped").members[1];
        for group in &mut base.groups {
            group.members.retain(|(parameter, _)| *parameter != member);
        }
        base.groups.push(BaseParameter {
            members: vec![(member, 1.0)],
            value: 0.0,
            size: 0.0,
        });
        let of_link = member.index() / 10;
        let block = base.blocks.iter_mut().find(|block| {
            block
                .leading
                .iter()
                .any(|leading| leading.index() / 10 == of_link)
        });
        block.expect("its link has others").leading.push(member);
    };
    let (fault, found) = refused(&split).expect("it is wrong");
    assert!(fault, "{found}");
}

#[test]
fn base_parameters_have_the_rounding_errors_of_their_terms() {
    let tokens = quote::quote! {
        struct Scara { tip: tool }
        link base;
        joint shoulder: revolute(z) { at: xyz(0.0, 0.0, 0.4), velocity: 2.0 }
        link upper { mass: 3.2, com: [0.12, 0, 0], inertia: [123456789.123456789, 0.02, 0.02] }
        joint elbow: continuous(-z) { at: xyz(0.3, 0, 0) rpy(0.1, 0.2, pi/2) rx(-pi) }
        link fore { mass: 1.5, inertia: [0.02, 0.03, 0.03], inertia_rpy: [0, 0, 0.1] }
        joint slide: screw([0.0, 0.6, 0.8], pitch: 0.01);
        link tool { mass: 0.8, com: [0.0, 0.0, 0.05], inertia: [0.001, 0.001, 0.0005] }
    };
    let mut errors = Errors::new();
    let heavy = inline::read(tokens, Path::new(""), &mut errors).expect("a robot");
    all_of(&heavy.description.expect("a robot"), &heavy.request);
}
