//! `homogen inspect`: the code of one function.

use super::{ARM, homogen};

#[test]
fn shows_one_method() {
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
