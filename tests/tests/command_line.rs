//! What the program `homogen` says, to people and to programs.
//!
//! In: arguments and standard input. Out: the answer, word for word where others rely on it.

use std::ffi::OsString;
use std::io::{self, Write};
use std::process::ExitCode;

use homogen_codegen::cli::{Answer, answer, run};
use homogen_codegen::formulation::{
    Angles, Formulation, Forward, Frame, Parameters, Products, Sines,
};
use homogen_codegen::{Builder, Function};
use serde_json::{Value, json};

/// Four links that move and one that does not, right angles in six digits, a doubtful inertia.
const ARM: &str = r#"<robot name="arm">
  <link name="base"/>
  <link name="upper">
    <inertial><mass value="2"/><inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.3"/></inertial>
  </link>
  <link name="fore">
    <inertial><mass value="1"/><inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/></inertial>
  </link>
  <link name="hand">
    <inertial><mass value="0.5"/><inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/></inertial>
  </link>
  <link name="camera"/>
  <joint name="shoulder" type="revolute">
    <parent link="base"/><child link="upper"/><axis xyz="0 0 1"/>
    <origin rpy="1.5708 0 0"/>
    <limit lower="-1" upper="2" velocity="3" effort="4"/>
  </joint>
  <joint name="elbow" type="continuous">
    <parent link="upper"/><child link="fore"/><axis xyz="0 0 1"/><origin xyz="0.5 0 0"/>
  </joint>
  <joint name="slide" type="prismatic">
    <parent link="fore"/><child link="hand"/><axis xyz="1 0 0"/>
    <limit lower="0" upper="1" effort="4" velocity="1"/>
  </joint>
  <joint name="mount" type="fixed">
    <parent link="upper"/><child link="camera"/><origin xyz="0 0.1 0"/>
  </joint>
</robot>
"#;

/// The program called with these words, on a standard input.
fn homogen(arguments: &str, input: &str) -> Answer {
    let words = std::iter::once("homogen").chain(arguments.split_whitespace());
    answer(words.map(OsString::from), &mut input.as_bytes())
}

/// The JSON of an answer without a mistake.
fn json(arguments: &str, input: &str) -> Value {
    let answer = homogen(arguments, input);
    assert_eq!((&*answer.remarks, answer.code), ("", 0), "{arguments}");
    serde_json::from_str(&answer.output).expect("JSON")
}

/// What standard error has of an answer that is a mistake.
fn refused(arguments: &str, input: &str) -> String {
    let answer = homogen(arguments, input);
    assert_eq!((&*answer.output, answer.code), ("", 1), "{arguments}");
    answer.remarks
}

#[test]
fn check_tells_what_became_of_the_description() {
    let arm = json("check - --tip hand --lock elbow=0.3 --format json", ARM);
    let keys: Vec<&str> = arm
        .as_object()
        .unwrap()
        .keys()
        .map(String::as_str)
        .collect();
    let wanted = [
        "robot", "file", "base", "tip", "joints", "links", "merged", "locked", "dropped",
        "snapped", "warnings", "details",
    ];
    assert_eq!(keys, wanted);
    assert_eq!(arm["robot"], "arm");
    assert_eq!(arm["file"], "<stdin>");
    assert_eq!(arm["base"], "base");
    assert_eq!(arm["tip"], "hand");
    assert_eq!(arm["joints"], json!(["shoulder", "slide"]));
    assert_eq!(
        arm["links"],
        json!(["base", "upper", "fore", "hand", "camera"])
    );
    assert_eq!(
        arm["merged"],
        json!([{ "link": "fore", "into": "upper" }, { "link": "camera", "into": "upper" }])
    );
    assert_eq!(arm["locked"], json!([{ "joint": "elbow", "q": 0.3 }]));
    assert_eq!(arm["dropped"], json!([]));
    let written: f64 = "1.5708".parse().expect("a number");
    let snapped = json!({
        "line": 15, "column": 18, "item": "shoulder", "written": written, "quarter_turns": 1,
    });
    assert_eq!(arm["snapped"], json!([snapped]));
    assert_eq!(arm["warnings"][0]["line"], 4);
    assert_eq!(arm["warnings"][0]["column"], 5);
    let message = arm["warnings"][0]["message"].as_str().unwrap();
    assert!(
        message.starts_with("no body has the inertia of link \"upper\""),
        "{message}"
    );
    let shoulder = &arm["details"]["joints"][0];
    assert_eq!(shoulder["kind"], "revolute");
    assert_eq!(shoulder["mass"], 3.0);
    assert_eq!(
        shoulder["limits"],
        json!({ "lower": -1.0, "upper": 2.0, "velocity": 3.0 })
    );
}

#[test]
fn check_of_several_ends_has_no_tip() {
    let arm = json("check - --exact --format json", ARM);
    assert_eq!(arm["tip"], Value::Null);
    assert_eq!(arm["snapped"], json!([]));
    let rest = json("check - --drop fore --base base --format json", ARM);
    assert_eq!(rest["dropped"], json!(["fore", "hand"]));
    assert_eq!(rest["joints"], json!(["shoulder"]));
    assert_eq!(rest["tip"], "camera");
}

#[test]
fn check_in_words() {
    let answer = homogen("check - --tip hand --lock elbow --drop camera", ARM);
    let expected = "\
robot arm from <stdin>
base base
tip hand
2 joints, in the order of q:
    0  shoulder: revolute, from base to upper, carries 3 kg
    1  slide: prismatic, from fore to hand, carries 0.5 kg
4 links modelled
1 link merged
  fore into upper
1 joint locked
  elbow at 0
1 link left out
  camera
1 angle taken for a right angle
  15:18: 1.5708 of shoulder is 1 × π/2
1 warning
warning: <stdin>:4:5: no body has the inertia of link \"upper\": a second moment about its centre \
of mass is -5.000e-2 kg m² (-33.3 % of the largest)
  hint: computed as given; correct the file, or refuse such files with strict
";
    assert_eq!(answer.output, expected);
    assert_eq!((&*answer.remarks, answer.code), ("", 0));
}

#[test]
fn strict_refuses_what_is_doubtful() {
    let remarks = refused("check - --strict", ARM);
    assert!(
        remarks.starts_with("error: <stdin>:4:5: no body has the inertia"),
        "{remarks}"
    );
    assert!(remarks.contains("(refused: strict)"), "{remarks}");
}

#[test]
fn each_mistake_has_its_line() {
    let text = ARM
        .replace("prismatic", "prismatik")
        .replace("value=\"2\"", "value=\"heavy\"");
    let remarks = refused("count - --format json", &text);
    let mistakes: Vec<&str> = remarks
        .lines()
        .filter(|line| line.starts_with("error"))
        .collect();
    let [mass, kind] = mistakes[..] else {
        panic!("{remarks}");
    };
    assert!(
        mass.starts_with("error: <stdin>:4:28: the mass of link \"upper\""),
        "{mass}"
    );
    assert!(
        kind.starts_with("error: <stdin>:21:29: joint \"slide\" has the unknown type"),
        "{kind}"
    );
    assert!(
        remarks.contains("\n  hint: did you mean \"prismatic\"?"),
        "{remarks}"
    );
}

#[test]
fn a_file_that_is_not_there() {
    assert_eq!(
        refused("check no/such.urdf", ""),
        "error: cannot read no/such.urdf: there is no such file\n"
    );
    assert_eq!(
        refused("eval - --function gravity --states no/such.json", ARM),
        "error: cannot read no/such.json: there is no such file\n"
    );
    assert_eq!(
        refused("eval - --function gravity --states -", ARM),
        "error: description and states cannot both be standard input\n"
    );
}

#[test]
fn count_gives_every_price_by_name() {
    let counted = json("count - --format json", ARM);
    let functions = counted["functions"].as_object().unwrap();
    // Two ends and no tip: functions of a frame are absent.
    let names: Vec<&str> = functions.keys().map(String::as_str).collect();
    let whole = Function::ALL
        .into_iter()
        .filter(|function| !function.of_a_frame());
    assert_eq!(names, whole.map(Function::name).collect::<Vec<_>>());
    for price in functions.values() {
        let keys: Vec<&str> = price
            .as_object()
            .unwrap()
            .keys()
            .map(String::as_str)
            .collect();
        let wanted = [
            "mul", "add", "div", "sqrt", "sin", "cos", "neg", "fused", "depth", "literals",
            "naive", "errors",
        ];
        assert_eq!(keys, wanted);
    }
    let errors = |name: &str| &functions[name]["errors"][0];
    let error = errors("gravity")["f64"]["N m"].as_f64();
    assert!(error.is_some_and(|error| (1e-17..1e-13).contains(&error)));
    let of = |name: &str| errors(name)["of"].as_str();
    assert_eq!(of("gravity"), Some("results"));
    assert_eq!(of("forward_dynamics"), Some("tau"));
    assert_eq!(of("mass_matrix_inverse"), Some("M"));
    let dynamics = &functions["inverse_dynamics"];
    let number = |value: &Value| value.as_u64().expect("a number");
    assert!(number(&dynamics["mul"]) * 10 < number(&dynamics["naive"]["mul"]));
    assert!(number(&dynamics["add"]) * 10 < number(&dynamics["naive"]["add"]));
    assert_eq!((number(&dynamics["sin"]), number(&dynamics["cos"])), (2, 2));

    let with_tip = json("count - --tip hand --frames camera --format json", ARM);
    let names: Vec<&String> = with_tip["functions"].as_object().unwrap().keys().collect();
    assert!(names.iter().any(|name| *name == "forward_kinematics"));
    assert!(
        names
            .iter()
            .any(|name| *name == "forward_kinematics_of_camera")
    );
}

#[test]
fn count_in_words_is_a_table() {
    let answer = homogen("count - --functions gravity,mass_matrix+bias", ARM);
    let lines: Vec<&str> = answer.output.lines().collect();
    assert_eq!(lines.len(), 3, "{}", answer.output);
    assert!(
        lines[0].trim_start().starts_with("mul  add  div"),
        "{}",
        lines[0]
    );
    assert!(lines[1].starts_with("gravity "), "{}", lines[1]);
    assert!(
        lines[2].starts_with("mass_matrix_and_bias "),
        "{}",
        lines[2]
    );
    assert!(
        lines.iter().all(|line| line.len() == lines[0].len()),
        "{}",
        answer.output
    );
    assert!(
        answer.remarks.starts_with("warning: <stdin>:4:5: "),
        "{}",
        answer.remarks
    );

    let all = homogen("count -", ARM);
    assert!(
        all.remarks
            .contains("note: left out: forward_kinematics, spatial_jacobian"),
        "{}",
        all.remarks
    );
    let why = refused("count - --functions forward_kinematics", ARM);
    assert!(why.contains("The robot has more than one end"), "{why}");
}

#[test]
fn functions_that_share_their_work_cost_less() {
    let robot = concat!(env!("CARGO_MANIFEST_DIR"), "/../robots/ur5_class.urdf");
    let (pose, jacobian) = ("forward_kinematics", "geometric_jacobian");
    let functions = format!("{pose},{jacobian},{pose}+{jacobian}");
    let counted = json(
        &format!("count {robot} --functions {functions} --format json"),
        "",
    );
    let mul = |name: &str| {
        counted["functions"][name]["mul"]
            .as_u64()
            .expect("a number")
    };
    assert!(mul(&format!("{pose}_and_{jacobian}")) < mul(pose) + mul(jacobian));
}

/// The answer of `eval` for states that come from a file, and a robot from standard input.
fn eval(arguments: &str, states: &str) -> Answer {
    // A name of its own for each call: tests run at the same time.
    let name = format!(
        "homogen-states-{:016x}.json",
        fingerprint(arguments, states)
    );
    let path = std::env::temp_dir().join(name);
    std::fs::write(&path, states).expect("a temporary file");
    let arguments = format!("eval - {arguments} --states {}", path.display());
    let answer = homogen(&arguments, ARM);
    std::fs::remove_file(&path).expect("it is still there");
    let name = path.file_name().unwrap().to_string_lossy().into_owned();
    Answer {
        remarks: answer.remarks.replace(&name, "states.json"),
        ..answer
    }
}

fn fingerprint(arguments: &str, states: &str) -> u64 {
    use std::hash::{DefaultHasher, Hash, Hasher};
    let mut hasher = DefaultHasher::new();
    (arguments, states, std::process::id()).hash(&mut hasher);
    hasher.finish()
}

#[test]
fn eval_says_the_shape_and_the_rows() {
    let states = r#"{"states":[{"q":[0.5,1,0.25]}]}"#;
    let answer = eval(
        "--function geometric_jacobian --frame camera --format json",
        states,
    );
    let jacobian: Value = serde_json::from_str(&answer.output).expect("JSON");
    assert_eq!(jacobian["function"], "geometric_jacobian");
    assert_eq!(jacobian["joints"], json!(["shoulder", "elbow", "slide"]));
    assert_eq!(jacobian["frame"], "camera");
    assert_eq!(jacobian["shape"], json!([6, 3]));
    assert_eq!(jacobian["rows"][0], "angular_x");
    assert_eq!(jacobian["rows"][5], "linear_z");
    // The camera hangs on the shoulder, whose axis is −y of the base; its arm is (−sin, cos)/10.
    let rows = jacobian["results"][0].as_array().unwrap();
    assert_eq!(rows[1], json!([-1.0, 0.0, 0.0]));
    assert_eq!(rows[3][0], json!(-0.1 * 0.5_f64.cos()));
    assert_eq!(rows[5][0], json!(-0.1 * 0.5_f64.sin()));

    let answer = eval(
        "--function forward_kinematics --tip camera --format json",
        states,
    );
    let pose: Value = serde_json::from_str(&answer.output).expect("JSON");
    assert_eq!(pose["shape"], json!([4, 4]));
    assert_eq!(pose["results"][0][3], json!([0.0, 0.0, 0.0, 1.0]));
    assert_eq!(pose["results"][0][2][3], json!(0.1 * 0.5_f64.cos()));
}

#[test]
fn eval_prints_the_shortest_digits_of_the_arithmetic() {
    let states = r#"{"states":[{"q":[0.5,1,0.25]}]}"#;
    let results = |scalar: &str| {
        let arguments = format!("--function gravity --scalar {scalar} --format json");
        let answer: Value = serde_json::from_str(&eval(&arguments, states).output).expect("JSON");
        let results: Vec<String> = answer["results"][0]
            .as_array()
            .unwrap()
            .iter()
            .map(Value::to_string)
            .collect();
        results
    };
    for (single, double) in results("f32").iter().zip(results("f64")) {
        let number: f32 = single.parse().expect("a number");
        assert_eq!(format!("{number:?}"), *single);
        let double: f64 = double.parse().expect("a number");
        assert!((double - f64::from(number)).abs() <= 1e-5 * double.abs());
    }
}

#[test]
fn eval_in_words_names_the_joints() {
    let answer = eval("--function gravity", r#"{"states":[{"q":[0,0,0]}]}"#);
    let lines: Vec<&str> = answer.output.lines().collect();
    assert_eq!(lines[0], "gravity of state 0");
    assert!(
        lines[1].ends_with("  shoulder") && lines[3].ends_with("  slide"),
        "{lines:?}"
    );
    assert!(
        answer.remarks.starts_with("warning: <stdin>:4:5: "),
        "{}",
        answer.remarks
    );
}

#[test]
fn eval_names_the_state_and_the_key_of_each_mistake() {
    let states = r#"{"states":[
        {"q":[0,0,0],"qd":[0,0,0]},
        {"q":[0,0],"qd":[0,NaN,0]},
        {"qd":[0,0,null],"q":[0,0,0],"tau":"unneeded"},
        {"q":{},"qd":[0,0,"one"]},
        7
    ]}"#;
    let answer = eval("--function bias --format json", states);
    let expected = "\
error: states.json: state 1 has 2 numbers in \"q\" for 3 joints
error: states.json: state 1 has a \"qd\" whose entry 1 is not a finite number
error: states.json: state 2 has a \"qd\" whose entry 2 is not a finite number
error: states.json: state 3 has a \"q\" that is not a list
error: states.json: state 3 has a \"qd\" whose entry 2 is not a finite number
error: states.json: state 4 is not an object
";
    assert_eq!(answer.remarks, expected);
    assert_eq!((&*answer.output, answer.code), ("", 1));
}

#[test]
fn eval_wants_json() {
    let answer = eval("--function bias", "{\"states\":[{\"q\":[0,0,}]}");
    assert_eq!(
        answer.remarks,
        "error: states.json:1:22: not JSON: expected value\n"
    );
    let answer = eval("--function bias", "{\"state\":[]}");
    assert!(
        answer
            .remarks
            .starts_with("error: states.json: there is no list \"states\"\n")
    );
    assert!(answer.remarks.contains("  hint: write {\"states\":"));
    let answer = eval("--function bias", r#"{"states":[{"q":[0,0,0]}]}"#);
    assert_eq!(
        answer.remarks,
        "error: states.json: state 0 has no \"qd\"\n"
    );
}

#[test]
fn a_result_that_no_number_can_hold_is_a_mistake() {
    let states = r#"{"states":[{"q":[0,0,0],"qd":[1e30,0,0]}]}"#;
    let answer = eval("--function bias --scalar f32 --format json", states);
    let expected = "error: state 0: a result is too large for f32\n";
    assert_eq!((&*answer.remarks, answer.code), (expected, 1));
    let answer = eval("--function bias --scalar f64 --format json", states);
    assert_eq!(answer.code, 0);
}

#[test]
fn inspect_shows_one_method() {
    let answer = homogen("inspect - --function gravity --tip hand", ARM);
    assert_eq!(answer.code, 0);
    let start =
        "/// Joint torques and forces τ that hold the robot at rest against gravity; N m, N.\n";
    assert!(answer.output.starts_with(start), "{}", answer.output);
    assert!(
        answer
            .output
            .contains("\npub fn gravity<T: ::homogen::Scalar>(&self, q: &[T; 3])")
    );
    assert_eq!(answer.output.matches("fn ").count(), 1, "{}", answer.output);

    let answer = homogen(
        "inspect - --function forward_kinematics --tip hand --frame camera --scalar f32",
        ARM,
    );
    assert!(
        answer
            .output
            .contains("pub fn forward_kinematics_of_camera(\n"),
        "{}",
        answer.output
    );
    assert_eq!(answer.output.matches("fn ").count(), 1, "{}", answer.output);
}

#[test]
fn generate_writes_what_the_builder_writes() {
    let robot = concat!(env!("CARGO_MANIFEST_DIR"), "/../robots/two_link.urdf");
    let answer = homogen(
        &format!("generate {robot} --functions inverse_dynamics,gravity --scalar f32 --tip fore"),
        "",
    );
    let built = Builder::from_urdf(robot)
        .tip("fore")
        .scalar(homogen_codegen::Real::F32)
        .generate([Function::InverseDynamics, Function::Gravity])
        .to_source()
        .expect("no mistakes");
    assert_eq!(answer.output, built.to_string());

    let path = std::env::temp_dir().join(format!("homogen-{}.rs", std::process::id()));
    let to_file = homogen(
        &format!(
            "generate {robot} --functions inverse_dynamics,gravity --scalar f32 --tip fore -o {}",
            path.display()
        ),
        "",
    );
    let written = std::fs::read_to_string(&path).expect("it was written");
    std::fs::remove_file(&path).expect("it is there");
    assert_eq!((written, to_file.output), (answer.output, String::new()));
}

/// The method as the builder writes it, and as `inspect` shows it, in a formulation.
#[test]
fn inspect_shows_the_formulation_that_the_builder_takes() {
    let formulation = Formulation {
        frame: Frame::Base,
        parameters: Parameters::Raw,
        forward: Some(Forward::MassMatrix { refinements: 1 }),
        angles: Angles::Merged,
        products: Products::Unfused,
        sines: Sines::Platform,
    };
    let words = "frame-0,raw,refined=1,merged,unfused,platform-sines";
    let arm = "../robots/two_link.urdf";
    let shown = homogen(
        &format!("inspect {arm} --function forward_dynamics --formulation {words}"),
        "",
    );
    assert_eq!((&*shown.remarks, shown.code), ("", 0));
    let doc = "/// Formulation: frame_0, raw, refined = 1, merged, unfused, platform_sines.\n";
    assert!(shown.output.contains(doc), "{}", shown.output);
    let builder = Builder::from_urdf(arm).formulation(formulation);
    let built = builder
        .generate([Function::ForwardDynamics])
        .runtime("::homogen")
        .to_source()
        .expect("no mistakes")
        .to_string();
    assert!(built.starts_with("// @generated"), "{built}");
    let head = "// Formulation: frame_0, raw, refined = 1, merged, unfused, platform_sines.\n";
    assert!(built.contains(head), "{built}");
    let bare = |text: &str| text.replace([' ', '\n'], "");
    assert!(
        bare(&built).contains(&bare(&shown.output)),
        "{built}\n{}",
        shown.output
    );
}

#[test]
fn count_gives_the_price_of_a_formulation() {
    let arm = "../robots/puma560_general.urdf --tip tool";
    let mul = |more: &str| {
        let words = format!("count {arm} --functions inverse_dynamics --format json {more}");
        json(&words, "")["functions"]["inverse_dynamics"]["mul"].clone()
    };
    let (chosen, raw) = (mul("").as_u64(), mul("--formulation raw").as_u64());
    assert!(chosen < raw, "{chosen:?} {raw:?}");
    assert_eq!(mul("--formulation regrouped,fused").as_u64(), chosen);
}

#[test]
fn words_of_a_formulation_that_make_no_sense() {
    for (words, said) in [
        (
            "articulated,refined=1",
            "\"refined=1\" contradicts \"articulated\"\n  hint: leave one of them out",
        ),
        (
            "refined",
            "\"refined\" needs a number of refinements\n  hint: write refined=0, refined=1 or refined=2",
        ),
        (
            "own-sinus",
            "unknown word \"own-sinus\"\n  hint: did you mean \"own-sines\"? known words: link-frames,",
        ),
    ] {
        let answer = homogen(&format!("count - --formulation {words}"), ARM);
        assert_eq!((&*answer.output, answer.code), ("", 2), "{words}");
        assert!(answer.remarks.contains(said), "{}", answer.remarks);
    }
}

/// A pendulum that carries a hundred thousand million times its own mass.
const TOP_HEAVY: &str = r#"<robot name="pole"><link name="base"/>
<link name="upper"><inertial><origin xyz="1 0 0"/><mass value="1"/>
  <inertia ixx="0" ixy="0" ixz="0" iyy="0" iyz="0" izz="0"/></inertial></link>
<link name="lower"><inertial><origin xyz="1 0 0"/><mass value="1e11"/>
  <inertia ixx="0" ixy="0" ixz="0" iyy="0" iyz="0" izz="0"/></inertial></link>
<joint name="shoulder" type="continuous">
  <parent link="base"/><child link="upper"/><axis xyz="0 0 1"/></joint>
<joint name="elbow" type="continuous">
  <parent link="upper"/><child link="lower"/><origin xyz="1 0 0"/><axis xyz="0 0 1"/></joint>
</robot>"#;

#[test]
fn a_form_that_loses_too_much_is_generated_and_doubted() {
    let doubt = "forward dynamics with refined = 0 loses more than half of the digits: at joint \"";
    for command in [
        "check -",
        "inspect - --function forward_dynamics",
        "count - --functions forward_dynamics",
        "generate - --functions forward_dynamics",
    ] {
        let words = format!("{command} --formulation refined=0");
        let answer = homogen(&words, TOP_HEAVY);
        assert_eq!(answer.code, 0, "{}", answer.remarks);
        assert!(
            format!("{}{}", answer.output, answer.remarks).contains(doubt),
            "{answer:?}"
        );
        let remarks = refused(&format!("{words} --strict"), TOP_HEAVY);
        assert!(
            remarks.contains(doubt) && remarks.contains("(refused: strict)"),
            "{remarks}"
        );
        // The engine chooses better, and other functions do not need it to.
        assert_eq!(homogen(command, TOP_HEAVY).remarks, "");
        let chosen = homogen(&format!("{command} --formulation refined=2"), TOP_HEAVY);
        assert_eq!((&*chosen.remarks, chosen.code), ("", 0));
    }
    let others = homogen(
        "count - --functions gravity --formulation refined=0",
        TOP_HEAVY,
    );
    assert_eq!((&*others.remarks, others.code), ("", 0));
    let written = homogen(
        "generate - --functions forward_dynamics --formulation refined=0",
        TOP_HEAVY,
    );
    assert!(
        written.output.contains("/// Doubts: "),
        "{}",
        written.output
    );
}

#[test]
fn no_form_saves_a_singular_chain() {
    let massless = TOP_HEAVY.replace("1e11", "0");
    for words in ["refined=0", "refined=2", "articulated"] {
        let words = format!("count - --functions forward_dynamics --formulation {words}");
        let remarks = refused(&words, &massless);
        assert!(
            remarks.contains("joint \"elbow\" can accelerate without any force"),
            "{remarks}"
        );
    }
}

#[test]
fn generate_writes_a_header_for_c() {
    let robot = concat!(env!("CARGO_MANIFEST_DIR"), "/../robots/two_link.urdf");
    let path = std::env::temp_dir().join(format!("homogen-{}.h", std::process::id()));
    let answer = homogen(
        &format!(
            "generate {robot} --functions forward_kinematics,mass_matrix+bias --tip fore \
             --extern-c arm_ --c-header {}",
            path.display()
        ),
        "",
    );
    let header = std::fs::read_to_string(&path).expect("it was written");
    std::fs::remove_file(&path).expect("it is there");
    for declaration in [
        "void arm_forward_kinematics(const double q[2], double forward_kinematics[3][4]);",
        "void arm_mass_matrix_and_bias(const double q[2], const double qd[2], \
         double mass_matrix[2][2], double bias[2]);",
    ] {
        assert!(header.contains(declaration), "{header}");
    }
    assert_eq!(answer.output.matches("pub extern \"C\" fn arm_").count(), 2);
    assert!(refused("generate - --extern-c 2nd", ARM).contains("no name in C"));
}

#[test]
fn gravity_may_be_anything() {
    let states = r#"{"states":[{"q":[0,0,0]}]}"#;
    let at = |gravity: &str| {
        let arguments = format!("--function gravity --format json --gravity {gravity}");
        let answer: Value = serde_json::from_str(&eval(&arguments, states).output).expect("JSON");
        answer["results"][0][2].as_f64().expect("a number")
    };
    // The hand slides along x.
    assert_eq!(at("none"), 0.0);
    assert_eq!(at("-2,0,0"), 1.0);
    assert_eq!(at("0,0,-9.81"), 0.0);
}

#[test]
fn arguments_that_make_no_sense() {
    for (arguments, said) in [
        (
            "count - --functions mass_matix",
            "did you mean \"mass_matrix\"? known functions: forward",
        ),
        ("count - --functions bias+bias", "bias is asked for twice"),
        (
            "check - --gravity 0,0",
            "gravity is three numbers with commas between them, or none",
        ),
        ("check - --gravity 0,0,inf", "`inf` is not a finite number"),
        (
            "count - --target cortex-m5",
            "there is no such target\n  hint: did you mean \"cortex-m4\"? known targets: portable,",
        ),
        ("check - --lock elbow=bent", "`bent` is not a number"),
        ("eval - --function gravity", "--states <FILE>"),
        ("fly", "unrecognized subcommand"),
    ] {
        let answer = homogen(arguments, ARM);
        assert_eq!((&*answer.output, answer.code), ("", 2), "{arguments}");
        assert!(
            answer.remarks.contains(said),
            "{arguments}: {}",
            answer.remarks
        );
    }
}

#[test]
fn help_has_an_example_for_every_command() {
    let answer = homogen("--help", "");
    assert_eq!((&*answer.remarks, answer.code), ("", 0));
    for command in ["check", "inspect", "count", "eval", "generate"] {
        assert!(answer.output.contains(command));
        let help = homogen(&format!("{command} --help"), "");
        let example = format!("\nExample:\n  homogen {command} arm.urdf");
        assert!(help.output.contains(&example), "{}", help.output);
    }
}

#[test]
fn a_robot_of_any_size_is_read_and_one_of_reasonable_size_generated() {
    let links = (1..1200).map(|k| {
        let parent = k - 1;
        format!(
            "<link name=\"l{k}\"/><joint name=\"j{k}\" type=\"continuous\">\
             <parent link=\"l{parent}\"/><child link=\"l{k}\"/></joint>"
        )
    });
    let text = format!(
        "<robot name=\"snake\"><link name=\"l0\"/>{}</robot>",
        links.collect::<String>()
    );
    let snake = json("check - --format json", &text);
    assert_eq!(snake["joints"].as_array().map(Vec::len), Some(1199));
    let expected = "error: 1199 joints move, and functions are generated for at most 1000\n";
    assert!(refused("count -", &text).starts_with(expected));
    assert!(refused("generate -", &text).starts_with(expected));
}

/// A stream that nobody reads any more.
struct Closed(io::ErrorKind);

impl Write for Closed {
    fn write(&mut self, _: &[u8]) -> io::Result<usize> {
        Err(self.0.into())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

#[test]
fn a_reader_that_has_gone_is_no_mistake_and_a_full_disk_is_one() {
    let call = |kind| {
        let arguments = ["homogen", "check", "-"].map(OsString::from);
        let mut remarks = Vec::new();
        let code = run(
            arguments,
            &mut ARM.as_bytes(),
            &mut Closed(kind),
            &mut remarks,
        );
        (code, String::from_utf8(remarks).expect("text"))
    };
    assert_eq!(
        call(io::ErrorKind::BrokenPipe),
        (ExitCode::SUCCESS, String::new())
    );
    let (code, remarks) = call(io::ErrorKind::StorageFull);
    assert_eq!(code, ExitCode::FAILURE);
    assert!(remarks.starts_with("error: cannot write: "), "{remarks}");
}
