//! A function of others, in a shared library.
//!
//! In: a library, and a symbol in it. That names a C function with CasADi's calling convention,
//! `int f(const real **arg, real **res, long long *iw, real *w, int mem)`, which returns numbers in the order
//! in which ours do. Out: calls of it.
#![expect(
    unsafe_code,
    reason = "code in a shared library can be called in no other way"
)]

use std::ffi::{OsStr, c_int, c_longlong};
use std::ptr;

use libloading::{Error, Library};

type Function<T> =
    unsafe extern "C" fn(*const *const T, *const *mut T, *mut c_longlong, *mut T, c_int) -> c_int;

/// A library, and the function in it.
pub struct Foreign<T> {
    function: Function<T>,
    _library: Library,
}

impl<T> Foreign<T> {
    /// The function that a symbol names in a library.
    ///
    /// # Errors
    /// Where the library or the symbol in it is missing.
    pub fn load(library: impl AsRef<OsStr>, symbol: &str) -> Result<Self, Error> {
        // SAFETY: the libraries are what `report/peer/setup.sh` compiled: loading them runs at most the
        // constructor of a robot.
        let library = unsafe { Library::new(library) }?;
        // SAFETY: all functions in them have this signature.
        let function: Function<T> = unsafe { *library.get(symbol.as_bytes())? };
        Ok(Self {
            function,
            _library: library,
        })
    }

    /// Calls it with as many numbers of each argument as the robot has coordinates or velocities; `result` takes as
    /// many as ours has, or else they stay where the function computes them.
    pub fn call(&self, arguments: [&[T]; 3], result: Option<&mut [T]>) {
        let arguments = arguments.map(<[T]>::as_ptr);
        let results = [result.map_or(ptr::null_mut(), <[T]>::as_mut_ptr)];
        // SAFETY: the function reads and writes no more than that. It needs no work space: CasADi's functions of
        // scalars keep all in local variables.
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
