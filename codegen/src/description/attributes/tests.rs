//! Tests of each message of the attributes, and of the request.

use super::*;
use crate::description::tokens::show;
use crate::function::Function;
use crate::real::Real;
use crate::wording::list;

const ARM: &str = r#"<robot name="arm"><link name="base"/><link name="tool"/>
<joint name="j" type="revolute"><parent link="base"/><child link="tool"/>
<axis xyz="0 0 1"/></joint></robot>"#;

/// A folder with `arm.urdf` and the broken `bad.urdf`.
fn folder() -> &'static Path {
    static FOLDER: std::sync::OnceLock<std::path::PathBuf> = std::sync::OnceLock::new();
    FOLDER.get_or_init(|| {
        let folder = std::env::temp_dir().join(format!("homogen-derive-{}", std::process::id()));
        std::fs::create_dir_all(folder.join("robots")).unwrap();
        std::fs::write(folder.join("robots/arm.urdf"), ARM).unwrap();
        std::fs::write(
            folder.join("bad.urdf"),
            "<robot name=\"r\">\n<link/></robot>",
        )
        .unwrap();
        folder
    })
}

fn try_read(text: &str) -> (Option<Item>, String) {
    let mut errors = Errors::new();
    let item = read(text.parse().unwrap(), folder(), &mut errors);
    (item, show(&errors))
}

fn fine(text: &str) -> Item {
    let (item, messages) = try_read(text);
    assert_eq!(messages, "");
    item.unwrap()
}

/// The errors of an attribute in line 1 from column 9.
fn errors_in(attribute: &str) -> String {
    try_read(&format!(
        "#[robot({attribute})]\n#[robot(link base)]\nstruct Arm;"
    ))
    .1
}

/// The errors of the fields of a struct, in line 2 from column 1.
fn errors_in_fields(fields: &str) -> String {
    try_read(&format!("#[robot(link base)] struct Arm {{\n{fields} }}")).1
}

#[test]
#[expect(clippy::float_cmp, reason = "reading is exact")]
fn all_settings_are_read() {
    let item = fine(
        r#"/// Docs.
        #[derive(Clone)]
        #[robot(urdf = "robots/arm.urdf", base = "base", tip = tool, path_only)]
        #[robot(lock("a-1", b = -pi/2), drop("c"), frames(d, "e"), gravity = [0, 0, -9.81], collision(d: "e"))]
        #[robot(exact, strict, scalar = f32, crate = "::my::homogen")]
        #[robot(generate(forward_kinematics, all_of(mass_matrix, bias)))]
        #[robot(formulation(raw, refined = 1, platform_sines,))]
        pub struct Arm<T> where T: Copy {
            #[robot(mass_of = "tool")]
            payload: T,
            #[robot(com_of = tool)] center: [T; 3],
            #[robot(origin_of = "j")] offset: [T; 3],
            /// A field of the user.
            counter: u32,
        }"#,
    );
    assert_eq!(item.ident, "Arm");
    assert_eq!(item.attributes.len(), 2);
    assert_eq!(item.generics.params.len(), 1);
    assert!(item.generics.where_clause.is_some());
    assert_eq!(item.file.unwrap().value(), "robots/arm.urdf");
    let description = item.description.unwrap();
    assert_eq!(description.links.len(), 2);
    assert_eq!(description.source.file.as_deref(), Some("arm.urdf"));
    assert!(description.source.anchor.is_some());

    let request = item.request;
    assert_eq!(request.base.unwrap().text, "base");
    assert_eq!(request.tip.unwrap().text, "tool");
    assert!(request.path_only && request.exact && request.strict);
    assert_eq!(request.lock.len(), 2);
    assert_eq!(request.lock[0].0.text, "a-1");
    assert!(request.lock[0].1.is_none());
    assert_eq!(
        request.lock[1].1.unwrap().value,
        -std::f64::consts::FRAC_PI_2
    );
    assert_eq!(request.drop[0].text, "c");
    assert_eq!(request.frames[1].text, "e");
    assert!(request.collision);
    let pairs = request.collision_pairs.iter();
    let pairs: Vec<_> = pairs
        .map(|pair| pair.each_ref().map(|name| &*name.text))
        .collect();
    assert_eq!(pairs, [["d", "e"]]);
    assert_eq!(request.gravity.unwrap().map(|g| g.value), [0.0, 0.0, -9.81]);
    assert_eq!(request.scalar, Real::F32);
    assert_eq!(request.runtime.unwrap().to_string(), ":: my :: homogen");
    assert_eq!(
        request.functions,
        [
            vec![Function::ForwardKinematics],
            vec![Function::MassMatrix, Function::Bias]
        ]
    );
    assert_eq!(
        request.formulation.words(),
        ["raw", "refined = 1", "platform_sines"]
    );
    let fields: Vec<_> = request
        .parameters
        .iter()
        .map(|p| p.field.to_string())
        .collect();
    assert_eq!(fields, ["payload", "center", "offset"]);
    assert!(matches!(&request.parameters[0].target, Target::MassOf(name) if name.text == "tool"));
    assert!(matches!(&request.parameters[2].target, Target::OriginOf(name) if name.text == "j"));
}

#[test]
#[expect(clippy::float_cmp, reason = "reading is exact")]
fn gravity_may_be_none_or_a_field() {
    let item = fine("#[robot(link base, gravity = none)] struct Arm;");
    assert_eq!(item.request.gravity.unwrap().map(|g| g.value), [0.0; 3]);
    let item = fine("#[robot(link base)] struct Arm { #[robot(gravity)] g: [f64; 3] }");
    assert!(matches!(item.request.parameters[0].target, Target::Gravity));
    assert!(item.request.gravity.is_none());
    assert_eq!(
        try_read(
            "#[robot(link base, gravity = none)] struct Arm { #[robot(gravity)] g: [f64; 3] }"
        )
        .1,
        "1:68: gravity is both a vector and the field `g`\n  hint: leave out one of them\n"
    );
}

#[test]
fn a_robot_may_be_described_in_the_attribute() {
    let item = fine(
        "#[robot(tip = tool; link base; joint j: revolute(z) { at: xyz(0, 0, 0.4) } link tool)]
         struct Arm;",
    );
    let description = item.description.unwrap();
    assert_eq!(description.name.text, "Arm");
    assert_eq!(description.joints[0].child.text, "tool");
    assert!(item.file.is_none());
}

#[test]
fn all_mistakes_are_reported_at_once() {
    let (item, messages) = try_read(
        "#[robot(tipp = \"a\", scalar = f16, gravity = [0, 0])]\n\
         #[robot(generate(inverse_dynamic, gravity), link base)]\n\
         struct Arm {\n\
         #[robot(mass = \"a\")] m: f64,\n\
         #[robot(gravity, mass_of = \"a\")] g: f64,\n\
         }",
    );
    let functions = list(Function::names());
    let expected = format!(
        "1:9: unknown key \"tipp\"\n  hint: did you mean \"tip\"? known keys: urdf, mjcf, sdf, dh, arguments, packages, base, floating, tip, \
         path_only, lock, drop, actuated, gravity, external, friction, damping, rotors, armature, rotor, ratio, exact, strict, quiet, processor, formulation, generate, frames, collision, scalar, reproducible, prepare, batch, section, crate, link, joint, loop and denavit_hartenberg\n\
         1:30: unknown scalar \"f16\"\n  \
         hint: known scalars: f32, f64 and generic\n\
         1:45: gravity has 2 numbers instead of 3\n\
         2:18: unknown function \"inverse_dynamic\"\n  \
         hint: did you mean \"inverse_dynamics\"? known functions: {functions}\n\
         4:9: a field cannot stand for \"mass\"\n  \
         hint: did you mean \"mass_of\"? known keys: mass_of, com_of, inertia_of, payload_on, gravity, origin_of, placement_of, base_position, base_placement, armature_of, damping_of, friction_of and range\n\
         5:3: field `g` stands for two numbers\n"
    );
    assert_eq!(messages, expected);
    // The valid functions stay, for the stub.
    assert_eq!(item.unwrap().request.functions, [[Function::Gravity]]);
}

#[test]
fn settings_need_their_values() {
    assert_eq!(errors_in("tip"), "1:9: expected `=` or `:` after `tip`\n");
    assert_eq!(errors_in("tip = 3"), "1:15: expected a name\n");
    assert_eq!(errors_in("tip = \"\""), "1:15: this name is empty\n");
    assert_eq!(
        errors_in("tip = a, tip = b"),
        "1:18: the key \"tip\" occurs twice\n"
    );
    assert_eq!(
        errors_in("tip = a base = b"),
        "1:17: expected `,` after the setting `tip`\n"
    );
    assert_eq!(
        errors_in("lock = a"),
        "1:14: `lock` needs a list in parentheses\n  hint: write lock(joint, other = 0.3)\n"
    );
    assert_eq!(
        errors_in("lock(a = b)"),
        "1:18: the position of joint \"a\" is not a number\n  \
         hint: write digits, or pi: 0.5, -1e-3, pi/2\n"
    );
    for few in ["0", "-1", "2.5", "\"800\"", "few"] {
        assert_eq!(
            errors_in(&format!("section = {few}")),
            "1:19: `section` needs the maximum number of statements of one compiled function\n  hint: write section = 2000\n"
        );
    }
    assert_eq!(errors_in("drop(a b)"), "1:16: expected `,`\n");
    assert_eq!(
        errors_in("gravity = down"),
        "1:19: gravity must be a vector or none\n  \
         hint: write gravity = [0.0, 0.0, -9.81], or gravity = none\n"
    );
    assert_eq!(
        errors_in("gravity = [0, 0, 1e999]"),
        "1:26: gravity is too large for 64 bits: \"1e999\"\n"
    );
    assert_eq!(
        errors_in("gravity = [0.0f32, 0, 0]"),
        "1:20: gravity has the suffix \"f32\"\n  hint: leave it out\n"
    );
    assert_eq!(
        errors_in("crate = \"a b\""),
        "1:17: \"a b\" is not a path\n  hint: write crate = \"::homogen\"\n"
    );
    assert_eq!(
        errors_in("urdf = arm"),
        "1:16: `urdf` needs the path of a file\n  hint: write urdf = \"arm.urdf\"\n"
    );
    assert_eq!(
        errors_in("= 3"),
        "1:9: expected a setting, `link`, `joint` or `loop`\n"
    );
}

#[test]
fn functions_are_asked_for_once() {
    assert_eq!(
        errors_in("generate(bias, bias)"),
        "1:24: \"bias\" occurs twice\n"
    );
    assert_eq!(
        errors_in("generate(all_of(bias, bias))"),
        "1:31: \"bias\" occurs twice\n"
    );
    assert_eq!(errors_in("generate(all_of())"), "1:18: `all_of` is empty\n");
    assert_eq!(
        errors_in("generate(all_of)"),
        "1:24: `all_of` needs a list in parentheses\n  hint: write all_of(mass_matrix, bias)\n"
    );
}

#[test]
fn the_description_is_named_once() {
    assert_eq!(
        try_read("#[robot(exact)] struct Arm;").1,
        "1:24: Arm has no description\n  \
         hint: name a file, urdf = \"arm.urdf\", or describe links and joints\n"
    );
    assert_eq!(
        errors_in("urdf = \"robots/arm.urdf\""),
        "1:16: Arm is described twice\n  \
         hint: name one file, or describe links and joints in place\n"
    );
    assert_eq!(
        try_read("#[robot]\nstruct Arm;").1,
        "1:3: `robot` needs a list in parentheses\n  hint: write #[robot(urdf = \"arm.urdf\")]\n"
    );
}

#[test]
fn a_file_that_cannot_be_read_is_said_under_its_path() {
    let path = folder().join("robots/amr.urdf");
    assert_eq!(
        try_read("#[robot(urdf = \"robots/amr.urdf\")] struct Arm;").1,
        format!(
            "1:16: cannot read {}: there is no such file\n  \
             hint: paths are relative to the folder of Cargo.toml\n",
            path.display()
        )
    );
    assert_eq!(
        try_read("#[robot(urdf = \"bad.urdf\")] struct Arm;").1,
        "bad.urdf:2:1: a link has no attribute \"name\"\n"
    );
}

#[test]
fn a_robot_is_a_struct_with_named_fields() {
    assert_eq!(
        try_read("#[robot(link base)] struct Arm(f64);").1,
        "1:31: the fields of Arm have no names\n  \
         hint: write struct Arm { payload: f64 }, or struct Arm;\n"
    );
    assert_eq!(
        try_read("#[robot(link base)] enum Arm { A }").1,
        "1:21: Arm is an enum: a robot is a struct\n"
    );
    assert_eq!(
        try_read("#[robot(link base)] union Arm { a: f64 }").1,
        "1:21: Arm is a union: a robot is a struct\n"
    );
    let (item, message) = try_read("fn arm() {}");
    assert!(item.is_none());
    assert_eq!(message, "1:1: expected one of: `struct`, `enum`, `union`\n");
}

#[test]
fn a_field_stands_for_one_number_and_a_number_for_one_field() {
    assert_eq!(
        errors_in_fields(
            "#[robot(mass_of = a)] m: f64, #[robot(mass_of = \"a\")] n: f64,\n\
             #[robot(com_of = a)] c: [f64; 3], #[robot(com_of = a)] d: [f64; 3]"
        ),
        "2:55: field `n` stands for the mass of link \"a\", as `m` does\n  \
         hint: leave out one of them\n\
         3:56: field `d` stands for the centre of mass of link \"a\", as `c` does\n  \
         hint: leave out one of them\n"
    );
    assert_eq!(
        errors_in_fields("#[robot(mass_of)] m: f64"),
        "2:9: expected `=` or `:` after `mass_of`\n"
    );
    assert_eq!(
        errors_in_fields("#[robot] m: f64"),
        "2:3: `robot` needs a list in parentheses\n  hint: write #[robot(mass_of = \"link\")]\n"
    );
}

#[test]
fn each_wrong_word_of_a_formulation_is_an_error() {
    assert_eq!(
        errors_in("formulation(row, refined, articulated, refined: 1, unfused = yes, raw)"),
        "1:21: unknown word \"row\"\n  hint: did you mean \"raw\"? known words: link_frames, \
         frame_0, regrouped, raw, refined, articulated, apart, merged, fused, unfused, \
         own_sines and platform_sines\n\
         1:26: \"refined\" needs a number of refinements\n  \
         hint: write refined = 0, refined = 1 or refined = 2\n\
         1:48: \"refined = 1\" contradicts \"articulated\"\n  hint: leave one of them out\n\
         1:60: \"unfused\" takes no value\n  hint: write unfused\n"
    );
    assert_eq!(
        errors_in("formulation = raw"),
        "1:21: `formulation` needs a list in parentheses\n  \
         hint: write formulation(raw, refined = 1)\n"
    );
}

#[test]
fn a_field_may_have_a_range() {
    let text = r#"
        #[robot(urdf = "arm.urdf")]
        struct Arm {
            #[robot(mass_of = "tool", range = 0.5..=3)]
            tool: f64,
            #[robot(gravity, range = 12.0)]
            gravity: [f64; 3],
            #[robot(range = 1.5, mass_of = "hand")]
            hand: f64,
            #[robot(com_of = "tool")]
            com: [f64; 3],
        }
    "#;
    let mut errors = Errors::new();
    let item = read(text.parse().unwrap(), Path::new(""), &mut errors).unwrap();
    let ranges = item.request.parameters.iter().map(|field| field.range);
    assert_eq!(
        ranges.collect::<Vec<_>>(),
        [
            Some([0.5, 3.0]),
            Some([-12.0, 12.0]),
            Some([0.0, 1.5]),
            None
        ]
    );
}

#[test]
fn impossible_ranges_are_errors() {
    let text = "#[robot(urdf = \"none.urdf\")] struct Arm {\n\
                #[robot(mass_of = \"a\", range = -1.0..=3.0)] a: f64,\n\
                #[robot(mass_of = \"b\", range = 3.0..=1.0)] b: f64,\n\
                #[robot(gravity, range = -12.0)] g: [f64; 3],\n\
                #[robot(range = 2.0)] c: f64,\n\
                #[robot(mass_of = \"d\", range = 1.0, range = 2.0)] d: f64,\n\
                #[robot(mass_of = \"e\", range = much)] e: f64 }";
    let (_, found) = try_read(text);
    let expected = [
        "2:32: the range of field `a` has negative masses\n  hint: write range = 0.0..=3.0, or range = 3.0 for the same",
        "3:32: the range of field `b` is empty",
        "4:26: the range of field `g` is empty\n  hint: write range = 12.0, or range = -12.0..=12.0 for the same",
        "5:17: field `c` has a range and stands for no number\n  hint: write what it stands for beside it",
        "6:45: field `d` has two ranges",
        "7:32: the range is not a number",
    ];
    for expected in expected {
        assert!(found.contains(expected), "{expected}\nis not in\n{found}");
    }
}

#[test]
fn a_field_holds_as_many_numbers_as_it_stands_for() {
    let text = "#[robot(urdf = \"none.urdf\")] struct Arm {\n\
                #[robot(mass_of = \"a\")] a: [f64; 3],\n\
                #[robot(gravity)] g: f64,\n\
                #[robot(com_of = \"b\")] b: [f64; 4],\n\
                #[robot(damping_of = \"c\")] c: &'static f64,\n\
                #[robot(com_of = \"d\")] d: [f64; SIZE],\n\
                #[robot(com_of = \"e\")] e: My,\n\
                #[robot(mass_of = \"f\")] f: T }";
    let (_, found) = try_read(text);
    let expected = [
        "2:28: field `a` stands for the mass of link \"a\", which is one number\n  hint: write a: f64\n",
        "3:22: field `g` stands for gravity, which is 3 numbers\n  hint: write g: [f64; 3]\n",
        "4:27: field `b` stands for the centre of mass of link \"b\", which is 3 numbers\n  hint: write b: [f64; 3]\n",
        "5:31: field `c` stands for the damping of joint \"c\", which is one number\n  hint: write c: f64\n",
    ];
    for expected in expected {
        assert!(found.contains(expected), "{expected}\nis not in\n{found}");
    }
    // The size of a named type is unknown here.
    assert!(
        !["`d`", "`e`", "`f`"]
            .iter()
            .any(|field| found.contains(field))
    );
}

#[test]
fn a_string_is_not_a_word() {
    assert_eq!(
        errors_in("scalar = \"f32\""),
        "1:18: expected a word, not the string \"f32\"\n  hint: write f32, without quotes\n"
    );
    assert_eq!(
        errors_in("generate(\"mass matrix\")"),
        "1:18: expected a word, not the string \"mass matrix\"\n"
    );
}
