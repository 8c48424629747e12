//! Laws of mechanics between the results of one robot.
//!
//! They need hardly any other implementation: derivatives come from generated code on dual numbers, to rounding. Errors
//! are in units of rounding times the largest value of either side in any state.

use std::array::from_fn;

use homogen::{
    Acceleration, Action, Chain, Jacobian, Momentum, Point, Pose, Screw, Velocity, generic,
};
use homogen_robots::for_every_robot;
use homogen_robots::shipped::{
    PandaClass, Puma560, Puma560General, Quadruped, Scara, Stanford, StanfordGeneral, TwoLink,
    Ur5Class,
};
use homogen_tests::cholesky::least_pivot;
use homogen_tests::dual::Dual;
use homogen_tests::functions::{Block, EveryFunction};
use homogen_tests::rounding::{DOUBLE, Worst};
use homogen_tests::states::{Random, State};

/// States of each robot. Errors are relative to the largest value in any state: with fewer states it is too small.
const STATES: usize = 100;

/// The worst is 20 u, of the power balance, whose terms are larger than their sum.
const LIMIT: f64 = 64.0;

/// Differences of the potential energy lose ten bits by their step, and as much by its fourth power; the worst is
/// 10,000 u.
const LIMIT_OF_DIFFERENCES: f64 = 40_000.0;

/// A robot whose code runs on `f64` and on dual numbers.
trait Differentiable<const N: usize>: EveryFunction<N, f64> + EveryFunction<N, Dual> {}

impl<R: EveryFunction<N, f64> + EveryFunction<N, Dual>, const N: usize> Differentiable<N> for R {}

/// The errors of the identities of one robot.
struct Identities(Worst);

impl Identities {
    fn note(&mut self, name: &'static str, left: impl Into<Vec<f64>>, right: impl Into<Vec<f64>>) {
        let (left, right) = (left.into(), right.into());
        self.0
            .note(&[Block::new(name, left)], &[Block::new(name, right)]);
    }
}

fn hold<R, const N: usize, const F: usize>(robot: &R, chain: &Chain<N, F>)
where
    R: Differentiable<N>,
{
    let mut random = Random::new(2);
    let mut found = Identities(Worst::in_units_of(DOUBLE));
    let mut differences = Identities(Worst::in_units_of(DOUBLE));
    for _ in 0..STATES {
        let state = State::random(&mut random);
        equations_of_motion(robot, &state, &mut found);
        energies(robot, chain, &state, &mut found);
        columns(robot, &state, &mut found);
        motion_of_the_tip(robot, &state, &mut found);
        rates_of_columns(robot, &state, &mut found);
        centroids(robot, &state, &mut found);
        gravity_is_a_gradient(robot, chain, &state, &mut differences);
    }
    println!("{}{}", found.0, differences.0);
    found.0.assert_within(LIMIT);
    differences.0.assert_within(LIMIT_OF_DIFFERENCES);
}

/// τ = M q̈ + bias, with a symmetric and positive definite M.
fn equations_of_motion<R, const N: usize>(
    robot: &R,
    State { q, qd, qdd }: &State<f64, N>,
    found: &mut Identities,
) where
    R: Differentiable<N>,
{
    let rest = [0.0; N];
    let (mass, bias, gravity) = (robot.mass_matrix(q), robot.bias(q, qd), robot.gravity(q));
    let torque = robot.inverse_dynamics(q, qd, qdd);
    let sum: [f64; N] = from_fn(|i| dot(&mass[i], qdd) + bias[i]);
    found.note("M q̈ + bias = τ", sum, torque);
    found.note(
        "τ(q, q̇, 0) = bias",
        robot.inverse_dynamics(q, qd, &rest),
        bias,
    );
    found.note(
        "τ(q, 0, 0) = gravity",
        robot.inverse_dynamics(q, &rest, &rest),
        gravity,
    );

    for k in 0..N {
        let torques = robot.inverse_dynamics(
            &Dual::pairs(q, &rest),
            &Dual::pairs(qd, &rest),
            &Dual::pairs(qdd, &unit(k)),
        );
        found.note("∂τ/∂q̈ = M", slopes(torques), mass.map(|row| row[k]));
    }
    let transposed: [[f64; N]; N] = from_fn(|k| mass.map(|row| row[k]));
    assert_eq!(mass, transposed, "M is symmetric");
    assert!(least_pivot(mass) > 0.0, "M is positive definite: {mass:?}");
}

/// ½ q̇ᵗ M q̇ is the kinetic energy; its rate is the power of the torques, so Ṁ − 2C is skew.
fn energies<R, const N: usize, const F: usize>(
    robot: &R,
    chain: &Chain<N, F>,
    State { q, qd, .. }: &State<f64, N>,
    found: &mut Identities,
) where
    R: Differentiable<N>,
{
    let mass = robot.mass_matrix(q);
    let energy = 0.5 * dot(qd, &mass.map(|row| dot(&row, qd)));
    found.note(
        "½ q̇ᵗ M q̇ = kinetic energy",
        [energy],
        [generic::kinetic_energy(chain, q, qd)],
    );

    let rate = robot.mass_matrix(&Dual::pairs(q, qd));
    let gained = 0.5 * dot(qd, &rate.map(|row| dot(&slopes(row), qd)));
    let (bias, gravity) = (robot.bias(q, qd), robot.gravity(q));
    let power = dot(qd, &bias) - dot(qd, &gravity);
    found.note("½ q̇ᵗ Ṁ q̇ = q̇ᵗ (bias − gravity)", [gained], [power]);
}

/// The columns of the Jacobians are derivatives of the pose: Lᵢ = ∂M/∂qᵢ M⁻¹.
fn columns<R, const N: usize>(robot: &R, State { q, .. }: &State<f64, N>, found: &mut Identities)
where
    R: Differentiable<N>,
{
    let spatial: [Screw<f64>; N] = robot.spatial_jacobian(q);
    let body: [Screw<f64>; N] = robot.body_jacobian(q);
    let geometric: [Screw<f64>; N] = robot.geometric_jacobian(q);
    for k in 0..N {
        let moved = Moved::of(robot, q, &unit(k));
        let entries = |column: &Screw<f64>| [column.u(), column.b()].concat();
        found.note("L in (0)", entries(&spatial[k]), moved.in_0());
        found.note("L in (tip)", entries(&body[k]), moved.in_tip());
        found.note("L at the tip", entries(&geometric[k]), moved.at_tip());
        let changed = moved.pose.change_frame(&body[k]);
        found.note(
            "M L in (tip) M⁻¹ = L in (0)",
            entries(&changed),
            entries(&spatial[k]),
        );
    }
}

/// W = Ṁ M⁻¹ = Σ Lᵢ q̇ᵢ and H = Ẇ + W².
fn motion_of_the_tip<R, const N: usize>(
    robot: &R,
    State { q, qd, qdd }: &State<f64, N>,
    found: &mut Identities,
) where
    R: Differentiable<N>,
{
    let w: Velocity<f64> = robot.velocity(q, qd);
    let entries = |w: Velocity<f64>| [w.omega(), w.v()].concat();
    found.note("W = Ṁ M⁻¹", entries(w), Moved::of(robot, q, qd).in_0());
    let jacobian: [Screw<f64>; N] = robot.spatial_jacobian(q);
    found.note("W = Σ L q̇", entries(w), entries(jacobian.velocity(qd)));

    let in_time = robot.velocity(&Dual::pairs(q, qd), &Dual::pairs(qd, qdd));
    let w_dot = Velocity::new(slopes(in_time.omega()), slopes(in_time.v()));
    let h: Acceleration<f64> = robot.acceleration(q, qd, qdd);
    let expected = Acceleration::from_velocity_derivative(&w, &w_dot);
    let entries = |h: Acceleration<f64>| [h.g().as_flattened(), &h.a()].concat();
    found.note("H = Ẇ + W²", entries(h), entries(expected));
}

/// The rates of the Jacobians are their derivatives in time; Ẇ = Σ L q̈ + L̇ q̇; the acceleration bias is H at q̈ = 0.
fn rates_of_columns<R, const N: usize>(
    robot: &R,
    State { q, qd, qdd }: &State<f64, N>,
    found: &mut Identities,
) where
    R: Differentiable<N>,
{
    type Columns<T, const N: usize> = [Screw<T>; N];
    let in_time = Dual::pairs(q, qd);
    let expected = |columns: Columns<Dual, N>| -> Vec<f64> {
        let slopes = columns.map(|column| [slopes(column.u()), slopes(column.b())].concat());
        slopes.concat()
    };
    let entries = |columns: &Columns<f64, N>| -> Vec<f64> {
        let columns = columns
            .each_ref()
            .map(|column| [column.u(), column.b()].concat());
        columns.concat()
    };
    let spatial: Columns<f64, N> = robot.spatial_jacobian_rate(q, qd);
    found.note(
        "L̇ in (0)",
        entries(&spatial),
        expected(robot.spatial_jacobian(&in_time)),
    );
    found.note(
        "L̇ in (tip)",
        entries(&robot.body_jacobian_rate(q, qd)),
        expected(robot.body_jacobian(&in_time)),
    );
    found.note(
        "L̇ at the tip",
        entries(&robot.geometric_jacobian_rate(q, qd)),
        expected(robot.geometric_jacobian(&in_time)),
    );

    let columns: Columns<f64, N> = robot.spatial_jacobian(q);
    let w_dot = columns.velocity(qdd) + spatial.velocity(qd);
    let w: Velocity<f64> = robot.velocity(q, qd);
    let entries = |h: Acceleration<f64>| [h.g().as_flattened(), &h.a()].concat();
    found.note(
        "H = Σ L q̈ + L̇ q̇ + W²",
        entries(Acceleration::from_velocity_derivative(&w, &w_dot)),
        entries(robot.acceleration(q, qd, qdd)),
    );
    found.note(
        "H(q, q̇, 0) = H̃",
        entries(robot.acceleration(q, qd, &[0.0; N])),
        entries(robot.acceleration_bias(q, qd)),
    );
}

/// The velocity of the centre of mass is the derivative of its position, and its Jacobian times q̇. The momentum about
/// it is its matrix times q̇, and the rate of that at q̈ = 0 is the rate of the matrix times q̇.
fn centroids<R, const N: usize>(
    robot: &R,
    State { q, qd, .. }: &State<f64, N>,
    found: &mut Identities,
) where
    R: Differentiable<N>,
{
    let in_time = Dual::pairs(q, qd);
    let velocity = robot.center_of_mass_velocity(q, qd);
    found.note(
        "ċ = dc/dt",
        velocity,
        slopes(robot.center_of_mass(&in_time).0),
    );
    let jacobian: [[f64; 3]; N] = robot.center_of_mass_jacobian(q);
    let row = |k: usize| jacobian.map(|column| column[k]);
    let sum: [f64; 3] = from_fn(|k| dot(&row(k), qd));
    found.note("ċ = Σ columns q̇", velocity, sum);

    let gamma: Momentum<f64> = robot.momentum(q, qd);
    let centroidal: Momentum<f64> = robot.centroidal_momentum(q, qd);
    let entries = |gamma: Momentum<f64>| [gamma.gamma(), gamma.rho()].concat();
    let Point([x, y, z]) = robot.center_of_mass(q);
    let [p, q_, r] = gamma.rho();
    let moved = [y * r - z * q_, z * p - x * r, x * q_ - y * p];
    let about: [f64; 3] = from_fn(|k| gamma.gamma()[k] - moved[k]);
    found.note(
        "Γ about c",
        entries(centroidal),
        [about, gamma.rho()].concat(),
    );
    let matrix: [Momentum<f64>; N] = robot.centroidal_momentum_matrix(q);
    let sum = |matrix: [Vec<f64>; N]| -> Vec<f64> {
        let row = |k: usize| matrix.each_ref().map(|column| column[k]);
        (0..6).map(|k| dot(&row(k), qd)).collect()
    };
    found.note("Γ = A q̇", entries(centroidal), sum(matrix.map(entries)));
    let rates: [Momentum<Dual>; N] = robot.centroidal_momentum_matrix(&in_time);
    let rates = rates.map(|column| [slopes(column.gamma()), slopes(column.rho())].concat());
    let bias: Action<f64> = robot.centroidal_momentum_bias(q, qd);
    found.note("Φ = Ȧ q̇", [bias.c(), bias.f()].concat(), sum(rates));
}

/// Gravity torques are the gradient of the potential energy.
fn gravity_is_a_gradient<R, const N: usize, const F: usize>(
    robot: &R,
    chain: &Chain<N, F>,
    State { q, .. }: &State<f64, N>,
    found: &mut Identities,
) where
    R: Differentiable<N>,
{
    let step = 1.0 / 1024.0;
    let gradient: [f64; N] = from_fn(|k| {
        let energy = |steps: f64| {
            let mut q = *q;
            q[k] += steps * step;
            generic::potential_energy(chain, &q)
        };
        let near = energy(1.0) - energy(-1.0);
        let far = energy(2.0) - energy(-2.0);
        (8.0 * near - far) / (12.0 * step)
    });
    found.note("∂U/∂q = gravity", gradient, robot.gravity(q));
}

/// A pose and its derivative.
struct Moved {
    pose: Pose<f64>,
    /// ω and the velocity of the origin, in the axes of frame 0.
    omega: [f64; 3],
    v: [f64; 3],
}

impl Moved {
    /// The pose of the end effector and its derivative at some rates.
    fn of<R: Differentiable<N>, const N: usize>(robot: &R, q: &[f64; N], qd: &[f64; N]) -> Self {
        let m: Pose<Dual> = robot.forward_kinematics(&Dual::pairs(q, qd));
        let rotation = m.rotation().map(|row| row.map(|entry| entry.value));
        let rate = m.rotation().map(slopes);
        // Ṙ Rᵗ is skew; the mean of both triangles is taken.
        let w: [[f64; 3]; 3] = from_fn(|i| from_fn(|j| dot(&rate[i], &rotation[j])));
        Self {
            pose: Pose::new(rotation, m.translation().map(|entry| entry.value)),
            omega: [
                (w[2][1] - w[1][2]) / 2.0,
                (w[0][2] - w[2][0]) / 2.0,
                (w[1][0] - w[0][1]) / 2.0,
            ],
            v: slopes(m.translation()),
        }
    }

    /// With the reference point at the end effector.
    fn at_tip(&self) -> Vec<f64> {
        [self.omega, self.v].concat()
    }

    /// With the reference point at the origin of frame 0: v − ω × t.
    fn in_0(&self) -> Vec<f64> {
        let ([x, y, z], [p, q, r]) = (self.omega, self.pose.translation());
        let lever = [y * r - z * q, z * p - x * r, x * q - y * p];
        [self.omega, from_fn(|i| self.v[i] - lever[i])].concat()
    }

    /// In the axes of the end effector.
    fn in_tip(&self) -> Vec<f64> {
        let rotation = self.pose.rotation();
        let rotated = |vector: [f64; 3]| -> [f64; 3] {
            from_fn(|i| dot(&rotation.map(|row| row[i]), &vector))
        };
        [rotated(self.omega), rotated(self.v)].concat()
    }
}

fn dot<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn unit<const N: usize>(k: usize) -> [f64; N] {
    from_fn(|i| if i == k { 1.0 } else { 0.0 })
}

fn slopes<const N: usize>(duals: [Dual; N]) -> [f64; N] {
    duals.map(|dual| dual.slope)
}

macro_rules! identities {
    ($name:ident, $robot:ident) => {
        #[test]
        fn $name() {
            hold(&$robot, &$robot::chain());
        }
    };
}
for_every_robot!(identities);

/// The structure of the paper's matrices, by dense products: W, Γ and Φ are skew where they should be, J is symmetric
/// in every frame, Γ = W J − J Wᵗ and Φ = H J − J Hᵗ.
#[test]
fn matrices_have_the_structure_of_the_paper() {
    let mut random = Random::new(3);
    let mut found = Identities(Worst::in_units_of(DOUBLE));
    let chain = PandaClass::chain();
    for joint in &chain.joints {
        let State { q, qd, qdd } = State::<f64, 7>::random(&mut random);
        let (w, h) = (
            PandaClass.velocity(&q, &qd),
            PandaClass.acceleration(&q, &qd, &qdd),
        );
        let moved = PandaClass
            .forward_kinematics(&q)
            .change_frame(&joint.inertia);
        for j in [joint.inertia, moved] {
            let (gamma, phi) = (j.momentum(&w).to_matrix(), j.action(&h).to_matrix());
            let (w, h, j) = (w.to_matrix(), h.to_matrix(), j.to_matrix());
            for (i, k) in (0..4).flat_map(|i| (0..4).map(move |k| (i, k))) {
                assert_eq!(j[i][k], j[k][i], "J is symmetric");
                assert_eq!(gamma[i][k], -gamma[k][i], "Γ is skew");
                assert_eq!(phi[i][k], -phi[k][i], "Φ is skew");
                if i < 3 && k < 3 {
                    assert_eq!(w[i][k], -w[k][i], "ω̲ is skew");
                }
            }
            assert_eq!([w[3], h[3]], [[0.0; 4]; 2]);
            found.note("Γ = W J − J Wᵗ", gamma.concat(), skew(&w, &j));
            found.note("Φ = H J − J Hᵗ", phi.concat(), skew(&h, &j));
        }
    }
    found.0.assert_within(LIMIT);
}

/// X J − J Xᵗ, row by row, for a symmetric J.
fn skew(x: &[[f64; 4]; 4], j: &[[f64; 4]; 4]) -> Vec<f64> {
    let product = |i: usize, k: usize| dot(&x[i], &j[k]);
    let entries = (0..4).flat_map(|i| (0..4).map(move |k| (i, k)));
    entries
        .map(|(i, k)| product(i, k) - product(k, i))
        .collect()
}
