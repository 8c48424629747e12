//! The functions of a robot, called by name.
//!
//! In: anything that has all functions, generated or generic. Out: closures that no longer show which
//! function they call, so that tables can be made row by row. Calls inside a batch stay direct, and
//! are timed as a controller would make them.

use std::hint::black_box;

use homogen::Real;
use homogen::robot::{
    Acceleration, Bias, BodyJacobian, ForwardDynamics, ForwardKinematics, GeometricJacobian,
    Gravity, InverseDynamics, MassMatrix, MassMatrixInverse, SpatialJacobian, Velocity,
};
use homogen_codegen::Function;

use crate::entries::Entries;
use crate::states::State;

/// A robot that has every function.
pub trait Complete<const N: usize, T>:
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
    + ForwardDynamics<N, T>
    + MassMatrixInverse<N, T>
{
}

impl<R, const N: usize, T> Complete<N, T> for R where
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
        + ForwardDynamics<N, T>
        + MassMatrixInverse<N, T>
{
}

/// A type of number that results can be taken apart into.
pub trait Number: Real + Entries {}

impl Number for f32 {}
impl Number for f64 {}

type OneCall<'r, S> = Box<dyn Fn(&S) -> Vec<f64> + 'r>;
type ManyCalls<'r, S> = Box<dyn Fn(&[S]) + 'r>;

/// A function of a robot.
pub struct Bound<'r, T, const N: usize> {
    entries: OneCall<'r, State<T, N>>,
    batch: ManyCalls<'r, State<T, N>>,
}

impl<T, const N: usize> Bound<'_, T, N> {
    /// All numbers of the result.
    #[must_use]
    pub fn entries(&self, state: &State<T, N>) -> Vec<f64> {
        (self.entries)(state)
    }

    /// Calls the function once a state, for its time alone.
    pub fn batch(&self, states: &[State<T, N>]) {
        (self.batch)(states);
    }
}

/// That function of that robot.
///
/// # Panics
/// For a function that is not in the list below.
pub fn bind<R: Complete<N, T>, T: Number, const N: usize>(
    robot: &R,
    function: Function,
) -> Bound<'_, T, N> {
    type S<T, const N: usize> = State<T, N>;
    match function {
        Function::ForwardKinematics => bound(|s: &S<T, N>| robot.forward_kinematics(&s.q)),
        Function::SpatialJacobian => bound(|s: &S<T, N>| robot.spatial_jacobian(&s.q)),
        Function::BodyJacobian => bound(|s: &S<T, N>| robot.body_jacobian(&s.q)),
        Function::GeometricJacobian => bound(|s: &S<T, N>| robot.geometric_jacobian(&s.q)),
        Function::Velocity => bound(|s: &S<T, N>| robot.velocity(&s.q, &s.qd)),
        Function::Acceleration => bound(|s: &S<T, N>| robot.acceleration(&s.q, &s.qd, &s.qdd)),
        Function::InverseDynamics => {
            bound(|s: &S<T, N>| robot.inverse_dynamics(&s.q, &s.qd, &s.qdd))
        }
        Function::Gravity => bound(|s: &S<T, N>| robot.gravity(&s.q)),
        Function::Bias => bound(|s: &S<T, N>| robot.bias(&s.q, &s.qd)),
        Function::MassMatrix => bound(|s: &S<T, N>| robot.mass_matrix(&s.q)),
        Function::ForwardDynamics => {
            bound(|s: &S<T, N>| robot.forward_dynamics(&s.q, &s.qd, &s.tau))
        }
        Function::MassMatrixInverse => bound(|s: &S<T, N>| robot.mass_matrix_inverse(&s.q)),
        other => panic!("{} is not bound", other.name()),
    }
}

fn bound<'r, T, O: Entries, const N: usize>(
    call: impl Fn(&State<T, N>) -> O + Copy + 'r,
) -> Bound<'r, T, N> {
    Bound {
        entries: Box::new(move |state| {
            let mut numbers = Vec::new();
            call(state).push(&mut numbers);
            numbers
        }),
        batch: Box::new(move |states| {
            // By reference: a result that is moved is loaded once more, which waits for its stores.
            for state in states {
                black_box(&call(black_box(state)));
            }
        }),
    }
}
