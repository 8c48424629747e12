//! `--formulation`, which every command that generates takes: words, operation counts, warnings.

use homogen_codegen::formulation::{
    Angles, Formulation, Forward, Frame, Parameters, Products, Sines,
};
use homogen_codegen::{Builder, Function};

use super::{ARM, homogen, json, refused};

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

/// The equations as the builder writes them, and as `inspect` shows them, in a formulation.
#[test]
fn inspect_shows_the_formulation_that_the_builder_takes() {
    let formulation = Formulation::default()
        .with_frame(Frame::Base)
        .with_parameters(Parameters::Raw)
        .with_forward(Forward::MassMatrix { refinements: 1 })
        .with_angles(Angles::Merged)
        .with_products(Products::Unfused)
        .with_sines(Sines::Platform);
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
    // Comment and signature, then the equations, which are inside a choice of the processor.
    let (head, equations) = shown.output.split_once("{\n").expect("a method");
    for part in [head, equations.trim_end().trim_end_matches('}')] {
        assert!(bare(&built).contains(&bare(part)), "{built}\n{part}");
    }
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
fn a_form_that_loses_too_much_is_generated_and_doubted() {
    let doubt = "forward_dynamics with refined = 0 loses ";
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
        written.output.contains("/// Warnings: "),
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
