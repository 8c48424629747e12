//! One program: a function in one formulation and one type of number.
//!
//! In: a closure that calls it. Out: a batch over all states for its time, and single results for its errors. Calls
//! inside a batch are direct, as in a controller.

use std::array;
use std::hint::black_box;
use std::rc::Rc;

use homogen::Scalar;

use crate::entries::Entries;
use crate::truth::{Truth, Truths};

/// Arguments of a robot with `NQ` coordinates and `NV` velocities.
#[derive(Clone, Copy)]
#[allow(
    dead_code,
    reason = "the generated robots read it, where there are any"
)]
pub struct State<T, const NQ: usize, const NV: usize> {
    /// q.
    pub q: [T; NQ],
    /// q̇.
    pub qd: [T; NV],
    /// q̈.
    pub qdd: [T; NV],
    /// τ.
    pub tau: [T; NV],
}

/// A program whose time and errors are measured.
pub struct Case {
    /// Its name.
    pub name: String,
    /// The type of its numbers.
    pub scalar: &'static str,
    /// One call a state.
    pub batch: Box<dyn Fn()>,
    /// The numbers of its result at a state.
    pub results: Box<dyn Fn(usize) -> Vec<f64>>,
    /// Their indices in the exact result; all in order if empty.
    pub entries: Vec<usize>,
}

impl Case {
    /// The program that `call` calls.
    #[allow(
        dead_code,
        reason = "the generated robots need it, where there are any"
    )]
    pub fn of<T, R, F, const NQ: usize, const NV: usize>(
        [name, scalar]: [&'static str; 2],
        truths: &Truths,
        entries: &[usize],
        call: F,
    ) -> Self
    where
        T: Scalar + 'static,
        R: Entries,
        F: Fn(&State<T, NQ, NV>) -> R + Copy + 'static,
    {
        let states: Rc<[State<T, NQ, NV>]> = states(truths.of(scalar)).into();
        let same = Rc::clone(&states);
        Self {
            name: name.to_owned(),
            scalar,
            batch: Box::new(move || {
                // By reference: a moved result would be loaded again, after its stores.
                for state in &*states {
                    black_box(&call(black_box(state)));
                }
            }),
            results: Box::new(move |state| {
                let mut numbers = Vec::new();
                call(&same[state]).push(&mut numbers);
                numbers
            }),
            entries: entries.to_vec(),
        }
    }
}

/// The states in a type of number.
///
/// # Panics
/// If the robot has other numbers of coordinates and velocities.
#[allow(
    dead_code,
    reason = "the generated robots need it, where there are any"
)]
fn states<T: Scalar, const NQ: usize, const NV: usize>(truth: &Truth) -> Vec<State<T, NQ, NV>> {
    let lengths = (truth.coordinates, truth.velocities);
    assert_eq!(lengths, (NQ, NV), "the scene was made for another robot");
    let state = |numbers: &[f64]| {
        let (q, rates) = numbers.split_at(NQ);
        let part = |k: usize| array::from_fn(|i| T::constant(rates[k * NV + i]));
        State {
            q: array::from_fn(|i| T::constant(q[i])),
            qd: part(0),
            qdd: part(1),
            tau: part(2),
        }
    };
    let states = truth.arguments().chunks_exact(truth.length());
    states.map(state).collect()
}
