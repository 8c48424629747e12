//! Configurations with names: the keyframes of an MJCF file as constants of a derived robot.

use homogen::Robot;

#[derive(Robot)]
#[robot(mjcf = "../robots/keyframes.xml", generate(gravity))]
struct Walker;

#[derive(Robot)]
#[robot(mjcf = "../robots/keyframes.xml", scalar = f32, generate(gravity))]
struct Single;

#[derive(Robot)]
#[robot(urdf = "../../robots/two_link.urdf", generate(gravity))]
struct Arm;

/// Quaternions are x, y, z, w, of length 1.
const KEYS: [(&str, [f64; 8]); 2] = [
    ("stand", [0.0, 0.0, 0.5, 0.0, 0.0, 0.0, 1.0, 0.25]),
    (
        "on its \"side\"",
        [0.0, 0.0, 0.25, 1.0, 0.0, 0.0, 0.0, -1.0],
    ),
];

fn of<R: Robot<N, Q>, const N: usize, const Q: usize>(_: R) -> &'static [(&'static str, [f64; Q])] {
    R::CONFIGURATIONS
}

#[test]
fn keyframes_are_constants() {
    assert_eq!(Walker::CONFIGURATIONS, KEYS);
    assert_eq!(of(Walker), KEYS);
    assert_eq!(of(Single), KEYS);
    assert_eq!(Single::CONFIGURATIONS[1].1[3].to_bits(), 1.0_f32.to_bits());
    assert!(of(Arm).is_empty());
}
