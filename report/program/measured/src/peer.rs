//! Functions of others, loaded from shared libraries.
//!
//! In: who made it, the type of its numbers, a symbol and a library. That names a C function with
//! CasADi's calling convention, `int f(const real **arg, real **res, long long *iw, real *w, int mem)`,
//! which returns numbers in the order in which ours do. Out: a [`Case`] that stands beside ours.
#![expect(
    unsafe_code,
    reason = "code in a shared library can be called in no other way"
)]

use std::cell::RefCell;
use std::error::Error;
use std::ffi::{c_int, c_longlong};
use std::ptr;
use std::rc::Rc;

use homogen::Scalar;
use libloading::Library;

use crate::case::Case;
use crate::entries::Entries;
use crate::truth::Truths;

type Function<T> =
    unsafe extern "C" fn(*const *const T, *const *mut T, *mut c_longlong, *mut T, c_int) -> c_int;

/// A library, and what its function is called with.
struct Peer<T> {
    function: Function<T>,
    states: Vec<T>,
    /// Where the parts of a state begin that it takes.
    arguments: [usize; 3],
    result: RefCell<Vec<T>>,
    _library: Library,
}

/// The program that MAKER, TYPE, SYMBOL and LIBRARY tell, for a function of ours.
pub fn load(what: &[String; 4], function: &str, truths: &Truths) -> Result<Case, Box<dyn Error>> {
    match &*what[1] {
        "f64" => load_of::<f64>(what, "f64", function, truths),
        "f32" => load_of::<f32>(what, "f32", function, truths),
        other => Err(format!("no type {other}").into()),
    }
}

fn load_of<T: Scalar + Entries + 'static>(
    [maker, _, symbol, path]: &[String; 4],
    scalar: &'static str,
    function: &str,
    truths: &Truths,
) -> Result<Case, Box<dyn Error>> {
    // SAFETY: the libraries are what `report/peer/setup.sh` compiled: loading them runs at most the
    // constructor of a robot.
    let library = unsafe { Library::new(path) }?;
    // SAFETY: all functions in them have this signature.
    let call: Function<T> = unsafe { *library.get(symbol.as_bytes())? };
    let truth = truths.of(scalar);
    let rates = |k: usize| truth.coordinates + k * truth.velocities;
    let peer = Rc::new(Peer {
        function: call,
        states: truth.arguments().iter().map(|x| T::constant(*x)).collect(),
        arguments: if function.starts_with("forward_dynamics") {
            [0, rates(0), rates(2)]
        } else {
            [0, rates(0), rates(1)]
        },
        result: RefCell::new(vec![T::constant(0.0); truth.entries()]),
        _library: library,
    });
    // Pinocchio's users read results where it leaves them: copies of them are not part of its time.
    let copies = maker != "pinocchio";
    let length = truth.length();
    let same = Rc::clone(&peer);
    Ok(Case {
        name: format!("{maker}/{symbol}"),
        scalar,
        batch: Box::new(move || {
            for state in peer.states.chunks_exact(length) {
                peer.call(state, copies);
            }
        }),
        results: Box::new(move |state| {
            same.call(&same.states[state * length..][..length], true);
            let mut numbers = Vec::new();
            for entry in &*same.result.borrow() {
                entry.push(&mut numbers);
            }
            numbers
        }),
        entries: Vec::new(),
    })
}

impl<T> Peer<T> {
    fn call(&self, state: &[T], copies: bool) {
        let arguments = self.arguments.map(|start| state[start..].as_ptr());
        let mut result = self.result.borrow_mut();
        let results = [if copies {
            result.as_mut_ptr()
        } else {
            ptr::null_mut()
        }];
        // SAFETY: the function reads as many numbers of each argument as the robot has coordinates or velocities, and writes
        // as many as our result has, or none where there is no place for them. It needs no work space:
        // CasADi's functions of scalars keep all in local variables.
        unsafe {
            (self.function)(
                arguments.as_ptr(),
                results.as_ptr(),
                ptr::null_mut(),
                ptr::null_mut(),
                0,
            );
        }
    }
}
