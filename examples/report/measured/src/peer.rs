//! Functions of other generators, loaded from shared libraries.
//!
//! In: `NAME=SYMBOL@LIBRARY`, a C function with CasADi's calling convention,
//! `int f(const double **arg, double **res, long long *iw, double *w, int mem)`, and the length of its
//! work arrays from `SYMBOL_work`. Out: a [`Case`] that stands beside ours. Only `f64`.
#![expect(
    unsafe_code,
    reason = "code in a shared library can be called in no other way"
)]

use std::cell::RefCell;
use std::error::Error;
use std::ffi::{c_int, c_longlong};
use std::rc::Rc;

use libloading::Library;

use crate::case::Case;
use crate::truth::Truth;

type Function = unsafe extern "C" fn(
    *const *const f64,
    *const *mut f64,
    *mut c_longlong,
    *mut f64,
    c_int,
) -> c_int;
type Work = unsafe extern "C" fn(
    *mut c_longlong,
    *mut c_longlong,
    *mut c_longlong,
    *mut c_longlong,
) -> c_int;

/// A library and the arrays its function works on.
struct Peer {
    function: Function,
    joints: usize,
    states: Vec<f64>,
    arguments: &'static [usize],
    result: RefCell<Vec<f64>>,
    integers: RefCell<Vec<c_longlong>>,
    numbers: RefCell<Vec<f64>>,
    _library: Library,
}

/// The program that `what` names, for a function of ours.
pub fn load(what: &str, function: &str, truth: &Truth) -> Result<Case, Box<dyn Error>> {
    let parts = what.split_once('=');
    let parts = parts.and_then(|(name, rest)| Some((name, rest.split_once('@')?)));
    let (name, (symbol, path)) = parts.ok_or_else(|| format!("{what}: NAME=SYMBOL@LIBRARY"))?;
    // SAFETY: the libraries are what a code generator wrote and a C compiler compiled: loading them
    // runs nothing.
    let library = unsafe { Library::new(path) }?;
    // SAFETY: both have these signatures in all that CasADi generates.
    let (call, work): (Function, Work) = unsafe {
        let work = format!("{symbol}_work");
        (
            *library.get(symbol.as_bytes())?,
            *library.get(work.as_bytes())?,
        )
    };
    let mut sizes = [0; 4];
    let [a, r, integers, numbers] = &mut sizes;
    // SAFETY: it writes one number through each pointer.
    unsafe { work(a, r, integers, numbers) };
    let [integers, numbers] = [sizes[2], sizes[3]].map(usize::try_from);
    let joints = truth.joints;
    let peer = Rc::new(Peer {
        function: call,
        joints,
        states: truth.arguments().to_vec(),
        arguments: if function == "forward_dynamics" {
            &[0, 1, 3]
        } else {
            &[0, 1, 2]
        },
        result: RefCell::new(vec![0.0; entries(function, joints).len()]),
        integers: RefCell::new(vec![0; integers?]),
        numbers: RefCell::new(vec![0.0; numbers?]),
        _library: library,
    });
    let same = Rc::clone(&peer);
    Ok(Case {
        name: name.to_owned(),
        scalar: "f64",
        batch: Box::new(move || {
            for state in peer.states.chunks_exact(4 * joints) {
                peer.call(state);
            }
        }),
        results: Box::new(move |state| {
            let length = 4 * joints;
            same.call(&same.states[state * length..][..length]);
            same.result.borrow().clone()
        }),
        entries: entries(function, joints),
    })
}

impl Peer {
    fn call(&self, state: &[f64]) {
        let argument = |k: usize| state[self.arguments[k] * self.joints..].as_ptr();
        let arguments = [argument(0), argument(1), argument(2)];
        let mut result = self.result.borrow_mut();
        let results = [result.as_mut_ptr()];
        let mut integers = self.integers.borrow_mut();
        let mut numbers = self.numbers.borrow_mut();
        // SAFETY: the function reads as many numbers of each argument as there are joints, writes one
        // result of the length that `entries` has, and works on arrays of the length it asked for.
        unsafe {
            (self.function)(
                arguments.as_ptr(),
                results.as_ptr(),
                integers.as_mut_ptr(),
                numbers.as_mut_ptr(),
                0,
            );
        }
    }
}

/// Which entry of our result each of theirs is: they store columns first, Jacobians linear part
/// first, and of symmetric matrices the upper triangle, row by row.
fn entries(function: &str, joints: usize) -> Vec<usize> {
    match function {
        "forward_kinematics" => (0..4)
            .flat_map(|column| (0..3).map(move |row| 4 * row + column))
            .collect(),
        "geometric_jacobian" => (0..joints)
            .flat_map(|joint| [3, 4, 5, 0, 1, 2].map(|k| 6 * joint + k))
            .collect(),
        "mass_matrix" | "mass_matrix_inverse" => (0..joints)
            .flat_map(|row| (row..joints).map(move |column| row * joints + column))
            .collect(),
        _ => (0..joints).collect(),
    }
}
