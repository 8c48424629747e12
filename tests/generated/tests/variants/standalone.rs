//! The file for `core` alone compared with the derive, both in single precision: the same bits for all arguments.
//!
//! The derive computes in numbers that fuse no product with a sum, as the file does; on targets that fuse, the sines
//! differ, so there is nothing to compare.
#![cfg(not(any(target_feature = "fma", target_arch = "aarch64")))]

use homogen::Chain;
use homogen::robot::{ForwardDynamics, ForwardDynamicsDerivatives, MassMatrixInverse};
use homogen::trigonometry::single;
use homogen_robots::shipped::{PandaClass, Puma560, Quadruped, StanfordGeneral, TwoLink};
use homogen_tests::effort::effort;
use homogen_tests::functions::{EveryFunction, evaluate};
use homogen_tests::states::{NASTY, Random, State};
use homogen_tests::tested::F32;

/// Random states of each robot.
fn count() -> usize {
    effort(100, 200)
}

/// A state and the torques of forward dynamics.
struct Arguments<const N: usize> {
    state: State<f32, N>,
    tau: [f32; N],
}

impl<const N: usize> Arguments<N> {
    /// State and torques in numbers that fuse no product with a sum.
    fn unfused(&self) -> (State<F32, N>, [F32; N]) {
        let State { q, qd, qdd } = &self.state;
        let [q, qd, qdd, tau] = [q, qd, qdd, &self.tau].map(|list| list.map(F32));
        (State { q, qd, qdd }, tau)
    }

    fn random(random: &mut Random) -> Self {
        let state = State::random(random).to();
        let tau = State::random(random).to().q;
        Self { state, tau }
    }

    /// The same with about a third of the numbers replaced by adverse ones.
    fn spoilt(mut self, random: &mut Random) -> Self {
        let State { q, qd, qdd } = &mut self.state;
        for number in [q, qd, qdd, &mut self.tau].into_iter().flatten() {
            if random.chance(3) {
                *number = *random.choose(&NASTY);
            }
        }
        self
    }

    /// The same with angles limited to the range of the sines without branches.
    fn moderate(mut self) -> Self {
        self.state.q = self.state.q.map(|angle| {
            let huge = angle.is_finite() && angle.abs() > single::LIMIT;
            if huge { single::LIMIT } else { angle }
        });
        self
    }
}

/// Results of every function of a derived robot except regressors, in the order of [`standalone`].
fn derived<R, const N: usize>(robot: &R, arguments: &Arguments<N>) -> Vec<f32>
where
    R: EveryFunction<N, F32>
        + ForwardDynamics<N, F32>
        + MassMatrixInverse<N, F32>
        + ForwardDynamicsDerivatives<N, F32>,
{
    let (state, tau) = arguments.unfused();
    let blocks = evaluate(robot, &state).into_iter();
    let mut numbers: Vec<_> = blocks.flat_map(|block| block.entries).collect();
    numbers.extend(robot.forward_dynamics(&state.q, &state.qd, &tau));
    numbers.extend(robot.mass_matrix_inverse(&state.q).as_flattened());
    let by = robot.forward_dynamics_derivatives(&state.q, &state.qd, &tau);
    let parts = [by.dq, by.dqd, by.dtau];
    numbers.extend(parts.as_flattened().as_flattened());
    numbers.into_iter().map(|number| number.0).collect()
}

/// The 3×3 blocks of 3×4 rows, then the last column.
fn square_and_column(rows: [[f32; 4]; 3]) -> Vec<f32> {
    let square = rows.iter().flat_map(|row| row[..3].to_vec());
    square.chain(rows.iter().map(|row| row[3])).collect()
}

/// The first halves of all screws, then the second halves.
fn halves(screws: &[[f32; 6]]) -> Vec<f32> {
    let [first, second] = [0..3, 3..6].map(|half| {
        let halves = screws.iter().map(|screw| screw[half.clone()].to_vec());
        halves.collect::<Vec<_>>().concat()
    });
    [first, second].concat()
}

/// Results of every function of a robot in a file for `core` alone, except regressors.
macro_rules! standalone {
    ($robot:expr, $arguments:expr) => {{
        let Arguments {
            state: State { q, qd, qdd },
            tau,
        } = $arguments;
        [
            square_and_column($robot.forward_kinematics(q)),
            halves(&$robot.spatial_jacobian(q)),
            halves(&$robot.body_jacobian(q)),
            halves(&$robot.geometric_jacobian(q)),
            $robot.spatial_jacobian_rate(q, qd).concat(),
            $robot.body_jacobian_rate(q, qd).concat(),
            $robot.geometric_jacobian_rate(q, qd).concat(),
            $robot.jacobian_derivative(q).concat().concat(),
            $robot.velocity(q, qd).to_vec(),
            square_and_column($robot.acceleration(q, qd, qdd)),
            square_and_column($robot.acceleration_bias(q, qd)),
            $robot.inverse_dynamics(q, qd, qdd).to_vec(),
            $robot.gravity(q).to_vec(),
            $robot.bias(q, qd).to_vec(),
            $robot.mass_matrix(q).as_flattened().to_vec(),
            vec![$robot.kinetic_energy(q, qd)],
            vec![$robot.potential_energy(q)],
            $robot.center_of_mass(q).to_vec(),
            $robot.center_of_mass_velocity(q, qd).to_vec(),
            $robot.center_of_mass_jacobian(q).as_flattened().to_vec(),
            $robot.momentum(q, qd).to_vec(),
            $robot.centroidal_momentum(q, qd).to_vec(),
            halves(&$robot.centroidal_momentum_matrix(q)),
            $robot.centroidal_momentum_bias(q, qd).to_vec(),
            {
                let by = $robot.inverse_dynamics_derivatives(q, qd, qdd);
                [by.dq, by.dqd].as_flattened().as_flattened().to_vec()
            },
            $robot.gravity_derivative(q).as_flattened().to_vec(),
            $robot.coriolis_matrix(q, qd).as_flattened().to_vec(),
            $robot.forward_dynamics(q, qd, tau).to_vec(),
            $robot.mass_matrix_inverse(q).as_flattened().to_vec(),
            {
                let by = $robot.forward_dynamics_derivatives(q, qd, tau);
                let parts = [by.dq, by.dqd, by.dtau];
                parts.as_flattened().as_flattened().to_vec()
            },
        ]
        .concat()
    }};
}

/// The regressors of a robot; a macro, since their lengths depend on the robot.
macro_rules! regressors {
    ($robot:expr, $state:expr) => {{
        let State { q, qd, qdd } = $state;
        [
            $robot.regressor(q, qd, qdd).as_flattened(),
            $robot.base_regressor(q, qd, qdd).as_flattened(),
            &$robot.kinetic_energy_regressor(q, qd),
            &$robot.potential_energy_regressor(q),
        ]
        .concat()
    }};
}

/// Bits, the same for every NaN, since the language leaves those open.
fn bits(numbers: &[f32]) -> Vec<u32> {
    let one = |number: &f32| {
        if number.is_nan() {
            f32::NAN.to_bits()
        } else {
            number.to_bits()
        }
    };
    numbers.iter().map(one).collect()
}

/// Angles that the sines of a file are made for.
#[derive(Clone, Copy)]
enum Angles {
    /// Any, by the sines of the runtime.
    Any,
    /// Those within the range of the file's own sines.
    Moderate,
}

/// Compares a robot with its file. The chain's type states the number of joints.
fn agree<R, const N: usize, const F: usize>(
    robot: &R,
    _: &Chain<N, F>,
    angles: Angles,
    regressors: impl Fn(&Arguments<N>) -> Vec<f32>,
    file: impl Fn(&Arguments<N>) -> Vec<f32>,
) where
    R: EveryFunction<N, F32>
        + ForwardDynamics<N, F32>
        + MassMatrixInverse<N, F32>
        + ForwardDynamicsDerivatives<N, F32>,
{
    let mut random = Random::new(5);
    let assert_bits = |arguments: &Arguments<N>| {
        let expected = [derived(robot, arguments), regressors(arguments)].concat();
        assert_eq!(bits(&file(arguments)), bits(&expected));
    };
    for _ in 0..count() {
        let arguments = Arguments::random(&mut random);
        assert_bits(&arguments);
        let arguments = arguments.spoilt(&mut random);
        assert_bits(&match angles {
            Angles::Any => arguments,
            Angles::Moderate => arguments.moderate(),
        });
    }
}

macro_rules! standalone_file {
    ($name:ident, $robot:ident, $angles:ident) => {
        mod $name {
            include!(concat!(env!("OUT_DIR"), "/", stringify!($name), ".rs"));
        }

        #[test]
        fn $name() {
            let parameters = $name::Standalone::BASE_PARAMETERS.into_iter();
            assert_eq!(parameters.len(), $robot::BASE_PARAMETERS.len());
            for (in_f32, parameter) in parameters.zip($robot::BASE_PARAMETERS) {
                let off = (f64::from(in_f32) - parameter).abs();
                assert!(off <= f64::from(f32::EPSILON) * parameter.abs(), "{off:e}");
            }
            agree(
                &$robot,
                &$robot::chain(),
                Angles::$angles,
                |arguments| {
                    let numbers = regressors!($robot, &arguments.unfused().0);
                    numbers.into_iter().map(|number| number.0).collect()
                },
                |arguments| {
                    let regressors = regressors!($name::Standalone, &arguments.state);
                    [standalone!($name::Standalone, arguments), regressors].concat()
                },
            );
        }
    };
}

/// A robot with armature, damping and friction.
#[derive(homogen::Robot)]
#[robot(
    urdf = "../../robots/scara.urdf",
    armature(shoulder = 0.25),
    rotor(lift = 2e-5),
    ratio(lift = 300),
    generate(all)
)]
#[robot(damping(elbow = 0.75), friction(elbow = 0.5, lift = 3))]
struct WithActuators;

standalone_file!(two_link_own, TwoLink, Moderate);
standalone_file!(two_link_named, TwoLink, Any);
standalone_file!(stanford_general_own, StanfordGeneral, Moderate);
standalone_file!(stanford_general_named, StanfordGeneral, Any);
standalone_file!(puma560_own, Puma560, Moderate);
standalone_file!(panda_class_own, PandaClass, Moderate);
standalone_file!(quadruped_own, Quadruped, Moderate);
standalone_file!(with_actuators_own, WithActuators, Moderate);

/// The sines of a file are the runtime's without branches.
mod single_sines {
    use super::{bits, single};

    include!("../../../../codegen/src/print/rust/sines/single.rs");

    #[test]
    fn have_the_bits_of_the_runtime() {
        // Every 997th bit pattern, NaN and infinities among them.
        for word in (0..=u32::MAX).step_by(997) {
            let angle = f32::from_bits(word);
            let (s, c) = single::sin_cos_moderate(angle);
            let (sine, cosine) = sin_cos(angle);
            assert_eq!(bits(&[sine, cosine]), bits(&[s, c]), "{angle:?}");
        }
    }
}

/// The same in double precision.
mod double_sines {
    use super::Random;
    use homogen::trigonometry::double;

    include!("../../../../codegen/src/print/rust/sines/double.rs");

    #[test]
    fn have_the_bits_of_the_runtime() {
        let one = |number: f64| (!number.is_nan()).then(|| number.to_bits());
        let mut random = Random::new(6);
        for _ in 0..1_000_000 {
            // Any number, and an ordinary angle.
            for angle in [f64::from_bits(random.bits()), 1000.0 * random.unit()] {
                let (s, c) = double::sin_cos_moderate(angle);
                let (sine, cosine) = sin_cos(angle);
                assert_eq!([sine, cosine].map(one), [s, c].map(one), "{angle:?}");
            }
        }
    }
}
