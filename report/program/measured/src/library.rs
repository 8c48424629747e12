//! A function of another program, in a shared library.
//!
//! In: a library, and the symbol of a C function with CasADi's calling convention,
//! `int f(const real **arg, real **res, long long *iw, real *w, int mem)`, whose results are in our order. Out: calls
//! of it.
#![expect(
    unsafe_code,
    reason = "code in a shared library can be called in no other way"
)]

use std::ffi::{OsStr, c_int, c_longlong};
use std::ptr;

use libloading::{Error, Library};

type Function<T> =
    unsafe extern "C" fn(*const *const T, *const *mut T, *mut c_longlong, *mut T, c_int) -> c_int;

/// A function in a library.
pub struct Foreign<T> {
    function: Function<T>,
    _library: Library,
}

impl<T> Foreign<T> {
    /// The function of a symbol in a library.
    ///
    /// # Errors
    /// If the library or the symbol is missing.
    pub fn load(library: impl AsRef<OsStr>, symbol: &str) -> Result<Self, Error> {
        // SAFETY: the libraries are those of `report/peer/setup.sh`: loading them runs at most the constructor of a
        // robot.
        let library = unsafe { Library::new(library) }?;
        // SAFETY: all functions in them have this signature.
        let function: Function<T> = unsafe { *library.get(symbol.as_bytes())? };
        Ok(Self {
            function,
            _library: library,
        })
    }

    /// Calls it with arguments of as many numbers as the robot has coordinates or velocities, and a result of as many as
    /// ours. Without `result` the numbers stay in the memory of the function.
    pub fn call(&self, arguments: [&[T]; 3], result: Option<&mut [T]>) {
        let arguments = arguments.map(<[T]>::as_ptr);
        let results = [result.map_or(ptr::null_mut(), <[T]>::as_mut_ptr)];
        // SAFETY: the function reads and writes no more than that. It needs no work space, because CasADi's functions of
        // scalars use local variables.
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
