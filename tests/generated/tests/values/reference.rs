//! Generated code and the generic recursions, compared with numbers of Pinocchio at 16 random states for each robot
//! (tests/reference/*.json, with conventions in each file).
//!
//! Pinocchio returns velocity and acceleration of the frame's origin, W and H have the reference point at the origin of
//! frame 0: a point P has velocity W P and acceleration H P. Pinocchio's Jacobians have linear rows first; the methods
//! here have the order in their names.

use homogen::{Chain, Jacobian, Point, generic};
use homogen_robots::for_every_robot;
use homogen_robots::jointed::FreeQuadruped;
use homogen_robots::shipped::{
    PandaClass, Puma560, Puma560General, Quadruped, Scara, Stanford, StanfordGeneral, TwoLink,
    Ur5Class,
};
use homogen_tests::functions::{Block, EveryFunction};
use homogen_tests::rounding::Worst;
use homogen_tests::states::State;
use serde_json::Value;

/// Relative to the largest entry of a result. The worst is 2e-15.
const TOLERANCE: f64 = 1e-12;

/// The same for torques at Pinocchio's q̈, which is computed with the inverse of M: the worst is 3e-13, and 2e-12 for
/// the quadruped on a floating base, with feet of a hundredth of its mass.
const TOLERANCE_OF_SOLUTIONS: f64 = 1e-11;

/// A state, and Pinocchio's results for it.
struct Reference<'j>(&'j Value);

impl Reference<'_> {
    /// All numbers of a field, row by row.
    fn all(&self, field: &str) -> Vec<f64> {
        fn flatten(value: &Value, into: &mut Vec<f64>) {
            match value {
                Value::Array(values) => values.iter().for_each(|value| flatten(value, into)),
                other => into.push(other.as_f64().expect("a number")),
            }
        }
        let mut numbers = Vec::new();
        flatten(&self.0[field], &mut numbers);
        numbers
    }

    fn vector<const N: usize>(&self, field: &str) -> [f64; N] {
        let numbers = self.all(field);
        numbers.try_into().expect("a number for each entry")
    }

    fn state<const N: usize, const Q: usize>(&self) -> State<f64, N, Q> {
        State {
            q: self.vector("q"),
            qd: self.vector("v"),
            qdd: self.vector("a"),
        }
    }

    /// Blocks with the names of the fields in the file.
    fn blocks(&self, fields: &[&'static str]) -> Vec<Block<f64>> {
        let blocks = fields.iter();
        blocks
            .map(|field| Block::new(field, self.all(field)))
            .collect()
    }
}

/// The fields to compare with, for functions of the frame and of the whole robot.
const FIELDS: [&str; 15] = [
    "frame_R",
    "frame_p",
    "J_world",
    "J_local_world_aligned",
    "frame_angular_velocity",
    "frame_linear_velocity",
    "frame_angular_acceleration",
    "frame_linear_acceleration",
    "tau",
    "gravity_torque",
    "bias",
    "M_upper",
    // M q̈ + bias, at the q̈ that these torques cause.
    "torque",
    // The body Jacobian, rotated to the axes of frame 0.
    "J_local_world_aligned",
    "bias",
];

/// Results of a robot in the conventions of the file.
fn converted<R, const N: usize, const Q: usize>(
    robot: &R,
    state: &State<f64, N, Q>,
    reference: &Reference,
) -> Vec<Block<f64>>
where
    R: EveryFunction<N, f64, Q>,
{
    let State { q, qd, qdd } = state;
    let m = robot.forward_kinematics(q);
    let origin = Point(m.translation());
    let w = robot.velocity(q, qd);
    let h = robot.acceleration(q, qd, qdd);
    let mass = robot.mass_matrix(q);
    let bias = robot.bias(q, qd);
    let rows = |rows: [[f64; N]; 6]| rows.as_flattened().to_vec();
    let upper = (0..N).flat_map(|i| mass[i][i..].to_vec()).collect();
    let times = |vector: [f64; N]| -> Vec<f64> {
        let rows = mass.iter();
        rows.map(|row| row.iter().zip(vector).map(|(m, x)| m * x).sum())
            .collect()
    };
    let plus = |a: Vec<f64>, b: [f64; N]| a.iter().zip(b).map(|(a, b)| a + b).collect();
    // The body Jacobian has the same reference point, and the axes of the frame.
    let rotation = homogen::Pose::new(*m.rotation(), [0.0; 3]);
    let rotated = robot
        .body_jacobian(q)
        .map(|column| rotation.change_frame(&column));
    let results: [Vec<f64>; FIELDS.len()] = [
        m.rotation().as_flattened().to_vec(),
        m.translation().to_vec(),
        rows(robot.spatial_jacobian(q).to_matrix_linear_first()),
        rows(robot.geometric_jacobian(q).to_matrix_linear_first()),
        w.omega().to_vec(),
        (w * origin).0.to_vec(),
        h.omega_dot().to_vec(),
        (h * origin).0.to_vec(),
        robot.inverse_dynamics(q, qd, qdd).to_vec(),
        robot.gravity(q).to_vec(),
        bias.to_vec(),
        upper,
        plus(times(reference.vector("ddq")), bias),
        rows(rotated.to_matrix_linear_first()),
        // C q̇ + gravity = bias, with Pinocchio's Coriolis matrix.
        plus(coriolis(reference, qd), robot.gravity(q)),
    ];
    let named = FIELDS.into_iter().zip(results);
    named
        .map(|(name, entries)| Block::new(name, entries))
        .collect()
}

/// C q̇ with the matrix of the file.
fn coriolis<const N: usize>(reference: &Reference, qd: &[f64; N]) -> Vec<f64> {
    let matrix = reference.all("coriolis");
    let rows = matrix.chunks(N);
    rows.map(|row| row.iter().zip(qd).map(|(c, rate)| c * rate).sum())
        .collect()
}

fn agree<R, const N: usize, const F: usize, const Q: usize, const B: usize>(
    robot: &R,
    chain: &Chain<N, F, Q, B>,
    file: &str,
    json: &str,
) where
    R: EveryFunction<N, f64, Q>,
{
    let document: Value = serde_json::from_str(json).expect("JSON");
    assert_eq!(document["robot"], file);
    assert_eq!(document["frame"], chain.tip().name);
    let joints = document["joints"].as_array().expect("joints").iter();
    let joints = joints.map(|joint| match joint["name"].as_str() {
        Some("root_joint") => "root",
        other => other.expect("a name"),
    });
    assert!(joints.eq(chain.joints.map(|joint| joint.name)));
    let states = document["states"].as_array().expect("states");
    assert_eq!(states.len(), 16);

    let mut generated = Worst::in_units_of(1.0);
    let mut interpreted = Worst::in_units_of(1.0);
    let mut solved = Worst::in_units_of(1.0);
    for reference in states.iter().map(Reference) {
        let state = reference.state::<N, Q>();
        let expected = reference.blocks(&FIELDS);
        let split = |blocks: Vec<Block<f64>>| -> [Vec<Block<f64>>; 2] {
            let (solved, evaluated) = blocks.into_iter().partition(|block| block.name == "torque");
            [solved, evaluated]
        };
        let [solutions, expected] = split(expected);
        let [by_generated, found] = split(converted(robot, &state, &reference));
        generated.note(&found, &expected);
        let [by_interpreted, found] = split(converted(chain, &state, &reference));
        interpreted.note(&found, &expected);
        solved.note(&by_generated, &solutions);
        solved.note(&by_interpreted, &solutions);
        let energies = [
            (
                "kinetic_energy",
                generic::kinetic_energy(chain, &state.q, &state.qd),
            ),
            (
                "potential_energy",
                generic::potential_energy(chain, &state.q),
            ),
        ];
        let energies = energies.map(|(name, energy)| Block::new(name, [energy]));
        interpreted.note(
            &energies,
            &reference.blocks(&["kinetic_energy", "potential_energy"]),
        );
    }
    println!("generated\n{generated}\ngeneric\n{interpreted}\nboth\n{solved}");
    generated.assert_within(TOLERANCE);
    interpreted.assert_within(TOLERANCE);
    solved.assert_within(TOLERANCE_OF_SOLUTIONS);
}

macro_rules! reference {
    ($name:ident, $robot:ident) => {
        #[test]
        fn $name() {
            let json = include_str!(concat!("../../../reference/", stringify!($name), ".json"));
            agree(&$robot, &$robot::chain(), stringify!($name), json);
        }
    };
}
for_every_robot!(reference);
reference!(quadruped_free, FreeQuadruped);
