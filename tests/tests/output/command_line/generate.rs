//! `homogen generate`: files of functions, for Rust and for C.

use homogen_codegen::{Builder, Function};

use super::{ARM, homogen, refused};

#[test]
fn writes_what_the_builder_writes() {
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

#[test]
fn writes_a_header_for_c() {
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
    assert!(refused("generate - --extern-c 2nd", ARM).contains("cannot begin a name in C"));
}

#[test]
fn writes_c() {
    let robot = concat!(env!("CARGO_MANIFEST_DIR"), "/../robots/two_link.urdf");
    let command = format!("generate {robot} --language c --functions gravity --scalar f32");
    let built = Builder::from_urdf(robot)
        .scalar(homogen_codegen::Real::F32)
        .generate([Function::Gravity]);
    let whole = homogen(&command, "").output;
    let source = built.to_c("robot.h").expect("no mistakes");
    assert_eq!(whole, format!("{}\n{}", source.header, source.text));

    let name = format!("homogen-{}-c", std::process::id());
    let path = std::env::temp_dir().join(&name).with_extension("c");
    let answer = homogen(&format!("{command} --name arm -o {}", path.display()), "");
    assert_eq!(
        (answer.code, &*answer.output),
        (0, ""),
        "{}",
        answer.remarks
    );
    let source = built.name("arm").to_c(&format!("{name}.h"));
    let source = source.expect("no mistakes");
    for (extension, text) in [("c", source.text), ("h", source.header)] {
        let path = path.with_extension(extension);
        let written = std::fs::read_to_string(&path).expect("it was written");
        std::fs::remove_file(&path).expect("it is there");
        assert_eq!(written, text);
    }
}

#[test]
fn options_that_only_rust_has_are_told_together() {
    let said = refused(
        "generate - --language c --sin-cos ::libm::sincos --extern-c arm_ --c-header arm.h",
        ARM,
    );
    for part in [
        "--c-header is for functions written in Rust",
        "`sin_cos` is for Rust only",
    ] {
        assert!(said.contains(part), "{said}");
    }
    let said = refused("generate - --language c -o arm.h", ARM);
    assert!(
        said.contains("arm.h would overwrite its own header"),
        "{said}"
    );
}

/// The options of the command in the head of a file, behind the name of the description.
fn options_again(text: &str) -> String {
    let start = "Made by `homogen generate - ";
    let at = text.find(start).expect("a command in its head") + start.len();
    let end = text[at..].find('`').expect("its end");
    text[at..at + end].to_owned()
}

#[test]
fn the_command_in_the_head_of_a_file_makes_it_again() {
    for options in [
        "--tip hand --scalar f32 --functions inverse_dynamics,mass_matrix+bias --lock elbow=-0.25",
        "--tip hand --field load=payload_on:hand --range load=0..2.5 --field g=gravity --prepare --ascii",
        "--base base --floating --external hand --external-in-frame-0 --functions inverse_dynamics",
        "--tip hand --runtime ::homogen --batch --frames camera --functions gravity,forward_kinematics",
        "--tip hand --friction=elbow=0.1 --damping elbow=0.2 --rotor elbow=1e-5 --ratio elbow=50 --armature slide=0.3",
        "--tip hand --gravity 0,0,-1.62 --formulation raw,refined=1 --exact --processor cortex-m7 --scalar f32 --language c",
        "--tip hand --name Left --extern-c left_ --sin-cos crate::fast::sin_cos --drop camera --functions gravity",
        "--actuated slide --tip hand --path-only --field p=placement_of:elbow --field m=mass_of:fore --functions bias",
    ] {
        let file = homogen(&format!("generate - {options}"), ARM);
        assert_eq!(file.code, 0, "{}", file.remarks);
        let again = options_again(&file.output);
        // To standard output, which is where the first has gone.
        let again = again.replace(" --output robot.c", "");
        let again = homogen(&format!("generate - {again}"), ARM);
        assert_eq!(again.output, file.output, "{options}");
    }
}

#[test]
fn fields_that_cannot_be_are_told() {
    for (options, part) in [
        ("--field m=mass_of", "`mass_of` needs a name: mass_of:hand"),
        ("--field m=mas_of:hand", "did you mean \"mass_of\"?"),
        ("--field m", "write FIELD=WORD:NAME"),
        ("--field m=mass_of:hand --range m=3", "FIELD=LEAST..MOST"),
    ] {
        let answer = homogen(&format!("generate - {options}"), ARM);
        assert_eq!(answer.code, 2, "{}", answer.output);
        assert!(answer.remarks.contains(part), "{}", answer.remarks);
    }
    let said = refused("generate - --range m=0..1", ARM);
    assert!(said.contains("needs a --field with the name `m`"), "{said}");
    let said = refused("generate - --field m=mass_of:hand --range m=-1..1", ARM);
    assert!(said.contains("has negative masses"), "{said}");
}
