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
    assert!(refused("generate - --extern-c 2nd", ARM).contains("no name in C"));
}
