//! Both conventions compared with the products of their textbooks, and each message of the tables.

use super::*;
use crate::description::changed::changed;
use crate::description::{Axis, Description, Step};
use crate::error::{Errors, Place};
use crate::joint::JointKind;

fn try_read(text: &str) -> (Option<Description>, String) {
    let mut errors = Errors::new();
    let description = read(text, "arm.dh", None, &mut errors);
    (description, errors.to_string())
}

fn fine(text: &str) -> Description {
    let (description, messages) = try_read(text);
    assert_eq!(messages, "");
    description.unwrap()
}

/// The errors of rows that begin in line 3.
fn errors_in(rows: &str) -> String {
    let columns = "joint kind a alpha d theta mass cx ixx ixy ixz iyy iyz izz lower upper pitch";
    try_read(&format!("convention modified\n{columns}\n{rows}")).1
}

type Matrix = [[f64; 4]; 4];

const IDENTITY: Matrix = [
    [1.0, 0.0, 0.0, 0.0],
    [0.0, 1.0, 0.0, 0.0],
    [0.0, 0.0, 1.0, 0.0],
    [0.0, 0.0, 0.0, 1.0],
];

fn product(a: &Matrix, b: &Matrix) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| (0..4).map(|k| a[i][k] * b[k][j]).sum()))
}

fn translation(t: [f64; 3]) -> Matrix {
    let mut m = IDENTITY;
    for i in 0..3 {
        m[i][3] = t[i];
    }
    m
}

fn rotation(axis: Axis, angle: f64) -> Matrix {
    let (i, j) = match axis {
        Axis::X => (1, 2),
        Axis::Y => (2, 0),
        Axis::Z => (0, 1),
    };
    let (s, c) = angle.sin_cos();
    let mut m = IDENTITY;
    m[i][i] = c;
    m[i][j] = -s;
    m[j][i] = s;
    m[j][j] = c;
    m
}

fn placement(steps: &[Step]) -> Matrix {
    steps.iter().fold(IDENTITY, |m, step| match step {
        Step::Translate(t) => product(&m, &translation(t.map(|x| x.value))),
        Step::Rotate(axis, angle) => product(&m, &rotation(*axis, angle.value)),
        Step::Quaternion(_) => unreachable!("tables have no quaternions"),
    })
}

/// The pose of a link of a serial chain in which all moving joints have the coordinate q.
fn pose(description: &Description, link: &str, q: f64) -> Matrix {
    let mut m = IDENTITY;
    for joint in &description.joints {
        m = product(&m, &placement(&joint.origin));
        assert!((joint.axis[2].value - 1.0).abs() < 1e-15);
        let motion = match joint.kind {
            JointKind::Revolute | JointKind::Continuous => rotation(Axis::Z, q),
            JointKind::Prismatic => translation([0.0, 0.0, q]),
            JointKind::Screw { pitch } => product(
                &rotation(Axis::Z, q),
                &translation([0.0, 0.0, pitch.value * q]),
            ),
            JointKind::Fixed => IDENTITY,
            other => panic!("{other:?} is in no table here"),
        };
        m = product(&m, &motion);
        if joint.child.text == link {
            return m;
        }
    }
    panic!("no link {link}")
}

fn assert_close(a: &Matrix, b: &Matrix) {
    for (a, b) in a.iter().flatten().zip(b.iter().flatten()) {
        assert!((a - b).abs() < 1e-14, "{a} {b}");
    }
}

const ROWS: &str = "
joint     kind       a     alpha   d     theta  # an arm
one       revolute   0.1   pi/2    0.4   0.3
two       prismatic  0     -pi/2   0.2   -pi/4
three     continuous 0     0       0.5   0
four      fixed      0.7   0.2     0.1   0.6
";

/// a, α, d, θ of the rows above, and true for rotations and for translations.
const NUMBERS: [[f64; 6]; 4] = [
    [0.1, std::f64::consts::FRAC_PI_2, 0.4, 0.3, 1.0, 0.0],
    [
        0.0,
        -std::f64::consts::FRAC_PI_2,
        0.2,
        -std::f64::consts::FRAC_PI_4,
        0.0,
        1.0,
    ],
    [0.0, 0.0, 0.5, 0.0, 1.0, 0.0],
    [0.7, 0.2, 0.1, 0.6, 0.0, 0.0],
];

#[test]
fn standard_frames_are_those_of_the_book() {
    let arm = fine(&format!("convention standard\n{ROWS}"));
    let mut m = IDENTITY;
    let q = 0.7;
    for (name, [a, alpha, d, theta, rotates, translates]) in
        ["one", "two", "three", "four"].iter().zip(NUMBERS)
    {
        m = product(&m, &rotation(Axis::Z, theta + rotates * q));
        m = product(&m, &translation([0.0, 0.0, d + translates * q]));
        m = product(&m, &translation([a, 0.0, 0.0]));
        m = product(&m, &rotation(Axis::X, alpha));
        assert_close(&m, &pose(&arm, &format!("{name}_link"), q));
    }
    // Only rows with a frame off the joint's axis need a frame on it.
    let links: Vec<_> = arm
        .links
        .iter()
        .map(|link| link.name.text.as_str())
        .collect();
    assert_eq!(
        links,
        [
            "base",
            "one_axis",
            "one_link",
            "two_axis",
            "two_link",
            "three_link",
            "four_link"
        ]
    );
    assert!(arm.links[1].inertial.is_some() && arm.links[2].inertial.is_none());
}

#[test]
fn modified_frames_are_those_of_the_book() {
    let arm = fine(&format!("convention modified\n{ROWS}"));
    let mut m = IDENTITY;
    let q = -0.4;
    for (name, [a, alpha, d, theta, rotates, translates]) in
        ["one", "two", "three", "four"].iter().zip(NUMBERS)
    {
        m = product(&m, &rotation(Axis::X, alpha));
        m = product(&m, &translation([a, 0.0, 0.0]));
        m = product(&m, &rotation(Axis::Z, theta + rotates * q));
        m = product(&m, &translation([0.0, 0.0, d + translates * q]));
        assert_close(&m, &pose(&arm, &format!("{name}_link"), q));
    }
    assert_eq!(arm.links.len(), 5);
    assert_eq!(arm.name.text, "arm");
}

#[test]
#[expect(clippy::float_cmp, reason = "reading is exact")]
fn a_row_may_have_mass_limits_pitch_and_a_name() {
    let arm = fine(
        "convention modified
        kind joint link a alpha d theta pitch lower upper velocity \
         mass cx cy cz ixx ixy ixz iyy iyz izz
        screw spindle nut 0 0 0 0 0.01 -pi pi 2 1.5 0.1 0 0 1 2 3 4 5 6
        fixed tool - 0 0 0 0",
    );
    let joint = &arm.joints[0];
    let JointKind::Screw { pitch } = joint.kind else {
        panic!("{:?}", joint.kind);
    };
    assert_eq!(pitch.value, 0.01);
    assert_eq!(joint.child.text, "nut");
    let limits = joint.limits.unwrap();
    assert_eq!(limits.lower, -std::f64::consts::PI);
    assert_eq!(limits.velocity, 2.0);
    let inertial = arm.links[1].inertial.as_ref().unwrap();
    assert_eq!((inertial.mass.value, inertial.mass.resolution), (1.5, 0.1));
    assert_eq!(
        inertial.inertia.map(|x| x.value),
        [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]
    );
    assert!(matches!(inertial.mass.place, Place::File { line: 3, .. }));
    assert_eq!(arm.joints[1].parent.text, "nut");
    assert_eq!(arm.joints[1].child.text, "tool_link");
    assert!(arm.joints[1].limits.is_none());
}

#[test]
fn all_mistakes_are_reported_at_once() {
    assert_eq!(
        errors_in(
            "one  revolut  0 0 0 0\n\
             two  revolute 0 pi/0 x 0,5\n\
             three universal 0 0 0 0\n\
             two fixed 0 0 0 0  -1 0 1 1 1 1 1 inf\n\
             four screw 0 0 - 0\n\
             - fixed 0 0 0 0\n\
             five\n"
        ),
        "error: arm.dh:3:6: joint \"one\" has the unknown type \"revolut\"\n  \
         hint: did you mean \"revolute\"? known types: \
         revolute, continuous, prismatic, screw, cylindrical, universal, translation, planar, spherical, floating and fixed\n\
         error: arm.dh:4:17: alpha of joint \"two\" divides by zero: \"pi/0\"\n\
         error: arm.dh:4:22: d of joint \"two\" is not a number: \"x\"\n\
         error: arm.dh:4:24: theta of joint \"two\" is not a number: \"0,5\"\n  \
         hint: write a decimal point, and spaces between numbers\n\
         error: arm.dh:5:7: joint \"three\" has the type universal, but a row of a table has one axis\n  \
         hint: write a revolute row for each axis\n\
         error: arm.dh:6:20: mass of joint \"two\" is negative: -1\n\
         error: arm.dh:6:35: izz of joint \"two\" is infinite: \"inf\"\n\
         error: arm.dh:7:6: joint \"four\" has no pitch\n  \
         hint: add a column pitch, in metres per radian\n\
         error: arm.dh:7:1: joint \"four\" has no d\n\
         error: arm.dh:8:1: the joint of this row has no name\n\
         error: arm.dh:9:1: joint \"five\" has no kind\n\
         error: arm.dh:9:1: joint \"five\" has no a\n\
         error: arm.dh:9:1: joint \"five\" has no alpha\n\
         error: arm.dh:9:1: joint \"five\" has no d\n\
         error: arm.dh:9:1: joint \"five\" has no theta\n\
         error: arm.dh:6:1: there is another link \"two_link\"\n  \
         hint: the other one is in line 4\n\
         error: arm.dh:6:1: there is another joint \"two\"\n  \
         hint: the other one is in line 4\n"
    );
}

#[test]
fn masses_and_limits_are_checked() {
    assert_eq!(
        errors_in("one fixed 0 0 0 0 1.0 0"),
        "error: arm.dh:3:19: the link of joint \"one\" has a mass but no inertia\n  \
         hint: fill the columns ixx to izz, with zeros for a point mass\n"
    );
    assert_eq!(
        errors_in("one fixed 0 0 0 0 - 0.1"),
        "error: arm.dh:3:1: the link of joint \"one\" has an inertia but no mass\n"
    );
    assert_eq!(
        errors_in("one revolute 0 0 0 0 - - - - - - - - 1 -1"),
        "error: arm.dh:3:38: the lower limit of joint \"one\", 1, is above the upper one, -1\n"
    );
    assert_eq!(
        errors_in("one fixed 0 0 0 0 - - - - - - - - - - - 7"),
        "error: arm.dh:3:41: the row of joint \"one\" has more than 17 cells\n"
    );
}

#[test]
fn a_table_names_its_convention_and_its_columns() {
    let columns = "joint kind a alpha d theta\none fixed 0 0 0 0\n";
    assert_eq!(
        try_read(columns).1,
        "error: the table names no convention\n  \
         hint: write a line: convention modified, or convention standard\n"
    );
    assert_eq!(
        try_read(&format!("convention craig\n{columns}")).1,
        "error: arm.dh:1:12: unknown convention \"craig\"\n  \
         hint: known conventions: standard and modified\n"
    );
    assert_eq!(
        try_read(&format!("convention\nconvention standard\n{columns}")).1,
        "error: arm.dh:1:1: expected one convention\n  \
         hint: write convention modified, or convention standard\n\
         error: arm.dh:2:1: the convention is named twice\n"
    );
    let header = "name the columns first: joint kind a alpha d theta";
    assert_eq!(
        try_read("convention standard\none fixed 0 0 0 0").1,
        format!("error: arm.dh:2:1: this line has no names of columns\n  hint: {header}\n")
    );
    assert_eq!(
        try_read("# nothing\n").1,
        format!("error: the table has no columns\n  hint: {header}\n")
    );
    assert_eq!(
        try_read("convention standard\njoint kind a a alpah d").1,
        format!(
            "error: arm.dh:2:14: column \"a\" occurs twice\n\
             error: arm.dh:2:16: unknown column \"alpah\"\n  \
             hint: did you mean \"alpha\"? known columns: joint, kind, a, alpha, d, theta, pitch, \
             link, lower, upper, velocity, mass, cx, cy, cz, ixx, ixy, ixz, iyy, iyz and izz\n\
             error: arm.dh:2:1: the table lacks the columns alpha and theta\n  hint: {header}\n"
        )
    );
}

#[test]
fn hostile_tables_are_refused_quickly() {
    let rows = "x fixed 0 0 0 0\n".repeat(10_001);
    assert_eq!(
        errors_in(&rows),
        "error: arm.dh:10003:1: the table has more than 10000 rows\n"
    );
    assert_eq!(
        errors_in(&"\n".repeat(100_000)),
        "error: arm.dh:100001:1: the table has more than 100000 lines\n"
    );
    let wide = "joint ".repeat(100_000);
    assert!(try_read(&wide).1.contains("column \"joint\" occurs twice"));
    assert_eq!(
        errors_in(&format!("one fixed {}", "0 ".repeat(1_000_000)))
            .lines()
            .count(),
        1
    );
}

#[test]
fn random_changes_never_panic() {
    let text = format!("convention standard\n{ROWS}");
    let bytes = b"#\n -+./*pie0\xc3\xa4";
    for text in changed(&text, bytes, 0x9e37_79b9_7f4a_7c15).take(2000) {
        let _ = try_read(&text);
    }
}
