//! All functions of a robot as lists of numbers.
//!
//! In: a robot and a state. Out: every result, cut into blocks whose entries have one meaning and
//! one unit where the result has (rotations, translations, angular and linear parts), so that the
//! entries of a block can share one measure of error.

use homogen::robot::{
    Acceleration, Bias, BodyJacobian, ForwardKinematics, GeometricJacobian, Gravity,
    InverseDynamics, MassMatrix, SpatialJacobian, Velocity,
};
use homogen::{Pose, Scalar, Screw};

use crate::states::State;

/// A robot that has all functions: a generated one, or a chain that is read at run time.
pub trait EveryFunction<const N: usize, T>:
    ForwardKinematics<N, T>
    + SpatialJacobian<N, T>
    + BodyJacobian<N, T>
    + GeometricJacobian<N, T>
    + Velocity<N, T>
    + Acceleration<N, T>
    + InverseDynamics<N, T>
    + Gravity<N, T>
    + Bias<N, T>
    + MassMatrix<N, T>
{
}

impl<R, const N: usize, T> EveryFunction<N, T> for R where
    R: ForwardKinematics<N, T>
        + SpatialJacobian<N, T>
        + BodyJacobian<N, T>
        + GeometricJacobian<N, T>
        + Velocity<N, T>
        + Acceleration<N, T>
        + InverseDynamics<N, T>
        + Gravity<N, T>
        + Bias<N, T>
        + MassMatrix<N, T>
{
}

/// A result, or the part of it that has one meaning.
#[derive(Clone, Debug)]
pub struct Block<T> {
    /// The function and the part: `velocity ω`.
    pub name: &'static str,
    /// The entries, row by row.
    pub entries: Vec<T>,
}

impl<T: Copy> Block<T> {
    /// A block of some entries.
    pub fn new(name: &'static str, entries: impl IntoIterator<Item = T>) -> Self {
        Self {
            name,
            entries: entries.into_iter().collect(),
        }
    }

    /// The same block in another type of number.
    #[must_use]
    pub fn map<U>(&self, convert: impl Fn(T) -> U) -> Block<U> {
        Block {
            name: self.name,
            entries: self.entries.iter().copied().map(convert).collect(),
        }
    }
}

/// Every function at one state.
pub fn evaluate<R, T, const N: usize>(robot: &R, state: &State<T, N>) -> Vec<Block<T>>
where
    R: EveryFunction<N, T> + ?Sized,
    T: Scalar,
{
    let State { q, qd, qdd } = state;
    let mut blocks = Vec::new();
    blocks.extend(pose(&robot.forward_kinematics(q)));
    blocks.extend(screws(
        ["spatial_jacobian u", "spatial_jacobian b"],
        &robot.spatial_jacobian(q),
    ));
    blocks.extend(screws(
        ["body_jacobian u", "body_jacobian b"],
        &robot.body_jacobian(q),
    ));
    blocks.extend(screws(
        ["geometric_jacobian u", "geometric_jacobian b"],
        &robot.geometric_jacobian(q),
    ));
    let w = robot.velocity(q, qd);
    blocks.push(Block::new("velocity ω", w.omega()));
    blocks.push(Block::new("velocity v", w.v()));
    let h = robot.acceleration(q, qd, qdd);
    blocks.push(Block::new("acceleration G", h.g().as_flattened().to_vec()));
    blocks.push(Block::new("acceleration a", h.a()));
    blocks.push(Block::new(
        "inverse_dynamics",
        robot.inverse_dynamics(q, qd, qdd),
    ));
    blocks.push(Block::new("gravity", robot.gravity(q)));
    blocks.push(Block::new("bias", robot.bias(q, qd)));
    blocks.push(Block::new(
        "mass_matrix",
        robot.mass_matrix(q).as_flattened().to_vec(),
    ));
    blocks
}

/// A robot with functions that were generated to share their work.
pub trait Shared<const N: usize, T> {
    /// Pose and geometric Jacobian made together; mass matrix and bias made together.
    fn shared(&self, state: &State<T, N>) -> [Vec<Block<T>>; 2];
}

/// A pose and a geometric Jacobian, in blocks named as those of [`evaluate`].
#[must_use]
pub fn of_the_tip<T: Scalar>(m: &Pose<T>, geometric: &[Screw<T>]) -> Vec<Block<T>> {
    let names = ["geometric_jacobian u", "geometric_jacobian b"];
    [pose(m), screws(names, geometric)].concat()
}

/// A mass matrix and a bias, in blocks named as those of [`evaluate`].
#[must_use]
pub fn of_the_whole<T: Scalar, const N: usize>(mass: &[[T; N]; N], bias: &[T; N]) -> Vec<Block<T>> {
    vec![
        Block::new("bias", *bias),
        Block::new("mass_matrix", mass.as_flattened().to_vec()),
    ]
}

fn pose<T: Scalar>(m: &Pose<T>) -> [Block<T>; 2] {
    [
        Block::new("forward_kinematics R", m.rotation().as_flattened().to_vec()),
        Block::new("forward_kinematics t", m.translation()),
    ]
}

fn screws<T: Scalar>(names: [&'static str; 2], columns: &[Screw<T>]) -> [Block<T>; 2] {
    [
        Block::new(names[0], columns.iter().flat_map(Screw::u)),
        Block::new(names[1], columns.iter().flat_map(Screw::b)),
    ]
}
