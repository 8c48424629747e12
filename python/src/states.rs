//! Arrays of states: how those of NumPy are read, broadcast and shared between threads.
//!
//! In: arguments, their shapes, and the address of a compiled function. Out: results. Arguments are read where they lie,
//! at any stride; states are a loop of the compiled function. It never computes a number.

use std::num::NonZero;
use std::thread;

use homogen_codegen::print::arrays::Array;
use numpy::{
    Element, PyArrayDescrMethods, PyArrayDyn, PyArrayMethods, PyUntypedArray,
    PyUntypedArrayMethods,
    npyffi::{self, NPY_TYPES},
};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::PyTuple;

/// An array as compiled code takes it: where it starts, and how far states and entries of one state are apart, in numbers.
#[repr(C)]
#[derive(Clone, Copy)]
struct Strided {
    start: *mut u8,
    state: i64,
    entry: i64,
}

/// A compiled function: the count of states, the fields, and a pointer to as many arrays as it has arguments and results.
type Entry = unsafe extern "C" fn(i64, *const u8, *const Strided);

/// The numbers of all fields.
pub enum Fields {
    /// In single precision.
    Single(Vec<f32>),
    /// In double precision.
    Double(Vec<f64>),
}

impl Fields {
    const fn start(&self) -> *const u8 {
        match self {
            Self::Single(numbers) => numbers.as_ptr().cast(),
            Self::Double(numbers) => numbers.as_ptr().cast(),
        }
    }
}

/// Code, and what it is to work on.
pub struct Work<'a> {
    /// The address of the code.
    pub address: usize,
    /// The numbers of the fields, in the type of the code.
    pub fields: &'a Fields,
    /// Bytes of a number.
    pub size: usize,
    /// The operations that a state takes, about.
    pub operations: usize,
    /// Maximum number of threads that share it; `None` for one a core.
    pub threads: Option<NonZero<usize>>,
}

/// The type of an argument.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Type {
    /// An array of `float32`.
    Single,
    /// An array of `float64`.
    Double,
    /// Anything else.
    Other,
}

impl Type {
    /// The type of a value: single or double for an array itself, and none of a class made of it, whose numbers are aligned and in the order of bytes
    /// of the processor.
    #[expect(unsafe_code, reason = "NumPy hands out flags and type in structs")]
    pub fn of(value: &Bound<'_, PyAny>) -> Self {
        // SAFETY: the object is alive, and its structs are read only where it is an array.
        unsafe {
            if npyffi::PyArray_CheckExact(value.py(), value.as_ptr()) == 0 {
                return Self::Other;
            }
            let array = &(*value.as_ptr().cast::<npyffi::PyArrayObject>()).fields;
            let of = &(*array.descr).fields;
            let is_native = of.byteorder.cast_unsigned() == b'=';
            if !is_native || array.flags & npyffi::NPY_ARRAY_ALIGNED == 0 {
                return Self::Other;
            }
            match NPY_TYPES::NPY_DOUBLE as i32 - of.type_num {
                0 => Self::Double,
                1 => Self::Single,
                _ => Self::Other,
            }
        }
    }
}

/// The function in Python that converts arguments which cannot be read as they are.
static CONVERTED: PyOnceLock<Py<PyAny>> = PyOnceLock::new();

/// An argument as an array that compiled code can read.
pub fn argument<'py>(
    value: &Bound<'py, PyAny>,
    of: &Array,
    single: bool,
) -> PyResult<Bound<'py, PyUntypedArray>> {
    let wanted = if single { Type::Single } else { Type::Double };
    if Type::of(value) == wanted {
        let array = value.cast::<PyUntypedArray>()?;
        if entry(array, of.shape.len()).is_some() {
            return check(array.clone(), of);
        }
    }
    let py = value.py();
    let converted = CONVERTED.import(py, "homogen._arrays", "converted")?;
    let array = converted.call1((of.name.as_str(), value, single))?;
    check(array.cast_into::<PyUntypedArray>()?, of)
}

/// Refuses an array whose last axes are not those of an argument.
fn check<'py>(
    array: Bound<'py, PyUntypedArray>,
    of: &Array,
) -> PyResult<Bound<'py, PyUntypedArray>> {
    if array.shape().ends_with(&of.shape) {
        return Ok(array);
    }
    let has = shape_text(array.shape());
    Err(PyValueError::new_err(format!(
        "{} has the shape {has}, and must have (..., {})",
        of.name,
        commas(&of.shape)
    )))
}

/// Distance between entries of one state in an array whose last axes are those of a state, in numbers; `None` where that is
/// not one distance, or states do not begin at numbers.
fn entry(array: &Bound<'_, PyUntypedArray>, own: usize) -> Option<i64> {
    let size = array.dtype().itemsize().cast_signed();
    let strides = array.strides();
    let is_aligned = data(array).addr().is_multiple_of(size.unsigned_abs())
        && strides.iter().all(|stride| stride % size == 0);
    let first = array.ndim().checked_sub(own)?;
    let axes = array.shape()[first..].iter().zip(&strides[first..]);
    let mut before: Option<(usize, isize)> = None;
    for (&length, &stride) in axes.rev() {
        match before {
            Some((count, least)) if length != 1 => {
                if stride != least * count.cast_signed() {
                    return None;
                }
                before = Some((count * length, least));
            }
            Some(_) => {}
            None => before = Some((length, stride)),
        }
    }
    is_aligned.then(|| before.map_or(0, |(_, stride)| (stride / size) as i64))
}

#[expect(unsafe_code, reason = "NumPy hands out the address in a struct")]
fn data(array: &Bound<'_, PyUntypedArray>) -> *mut u8 {
    // SAFETY: the array is alive, and its struct holds the address.
    unsafe { (*array.as_array_ptr()).fields.data.cast() }
}

/// One state whose arguments are arrays that can be read as they are: the usual call, without broadcasting.
pub struct One {
    arrays: [Strided; MOST],
    count: usize,
    /// Its numbers are in single precision.
    pub single: bool,
}

/// The most arguments and results of a function that is called in this way.
const MOST: usize = 8;

impl One {
    /// The arguments of a call of a function with so many results; `None` where they are anything else.
    pub fn read(arguments: &Bound<'_, PyTuple>, of: &[Array], results: usize) -> Option<Self> {
        let nothing = Strided {
            start: std::ptr::null_mut(),
            state: 0,
            entry: 0,
        };
        let kind = Type::of(arguments.get_borrowed_item(0).ok()?.as_any());
        let fits = arguments.len() == of.len() && of.len() + results <= MOST;
        if !fits || kind == Type::Other {
            return None;
        }
        let mut one = Self {
            arrays: [nothing; MOST],
            count: of.len(),
            single: kind == Type::Single,
        };
        let places = one.arrays.iter_mut().zip(arguments.iter_borrowed());
        for ((place, value), of) in places.zip(of) {
            let array = value.cast::<PyUntypedArray>().ok()?;
            if Type::of(&value) != kind || array.shape() != of.shape {
                return None;
            }
            place.start = data(&array);
            place.entry = entry(&array, of.shape.len())?;
        }
        Some(one)
    }

    /// Computes it into new arrays.
    pub fn run<'py>(
        mut self,
        py: Python<'py>,
        work: &Work<'_>,
        results: &[Array],
    ) -> Vec<Bound<'py, PyUntypedArray>> {
        let first = self.count;
        let rooms = results.iter().zip(&mut self.arrays[first..]);
        let rooms = rooms.map(|(result, place)| {
            let array = room(py, &result.shape, self.single);
            place.start = data(&array);
            place.entry = 1;
            array
        });
        let rooms = rooms.collect();
        work.call(1, &self.arrays);
        for (array, of) in self.arrays[first..].iter().zip(results) {
            work.write_below(array, of, 1);
        }
        rooms
    }
}

/// The states that arguments are of, whatever their leading axes.
pub struct States {
    /// The leading axes of results.
    pub shape: Vec<usize>,
    /// The number of states.
    pub count: usize,
}

/// Arrays, and what they are in the signature of a function.
pub type Given<'a, 'py> = (&'a [Bound<'py, PyUntypedArray>], &'a [Array]);

impl States {
    /// The states of arguments, broadcast as NumPy does.
    pub fn of((arrays, of): Given<'_, '_>) -> PyResult<Self> {
        let leading = || {
            let arrays = arrays.iter().zip(of);
            arrays.map(|(array, of)| &array.shape()[..array.ndim() - of.shape.len()])
        };
        let axes = leading().map(<[usize]>::len).max().unwrap_or(0);
        let mut shape = vec![1; axes];
        for lengths in leading() {
            let behind = axes - lengths.len();
            for (found, &length) in shape[behind..].iter_mut().zip(lengths) {
                if *found == 1 {
                    *found = length;
                } else if length != 1 && length != *found {
                    return Err(apart(arrays, of));
                }
            }
        }
        Ok(Self {
            count: shape.iter().product(),
            shape,
        })
    }

    /// The shape of a result of all states, with further axes before its own.
    pub fn shape_of(&self, further: &[usize], of: &Array) -> Vec<usize> {
        [&self.shape, further, &of.shape].concat()
    }

    /// The leading axes as loops, the innermost last: the length, and how far each array goes in bytes.
    fn loops(&self, arrays: &[Given<'_, '_>]) -> Vec<(usize, Vec<isize>)> {
        let axes = self.shape.len();
        let mut loops: Vec<(usize, Vec<isize>)> = Vec::new();
        for (axis, &length) in self.shape.iter().enumerate() {
            if length == 1 {
                continue;
            }
            let all = arrays
                .iter()
                .flat_map(|(arrays, of)| arrays.iter().zip(*of));
            let steps = all.map(|(array, of)| {
                let behind = axes - (array.ndim() - of.shape.len());
                let own = axis.checked_sub(behind);
                let own = own.filter(|&own| array.shape()[own] != 1);
                own.map_or(0, |own| array.strides()[own])
            });
            let steps: Vec<isize> = steps.collect();
            // Axes that follow each other in every array are one.
            match loops.last_mut() {
                Some((count, before))
                    if (before.iter().zip(&steps))
                        .all(|(&outer, &inner)| outer == inner * length.cast_signed()) =>
                {
                    *count *= length;
                    *before = steps;
                }
                _ => loops.push((length, steps)),
            }
        }
        loops
    }

    /// Computes all states.
    pub fn run(
        &self,
        py: Python<'_>,
        work: &Work<'_>,
        arguments: Given<'_, '_>,
        results: Given<'_, '_>,
    ) {
        /// So many operations take about as long as a thread that begins.
        const SHARE: usize = 1 << 21;
        /// So many take less than a microsecond or a few.
        const SHORT: usize = 1 << 14;
        if self.count == 0 {
            return;
        }
        let all = [arguments, results];
        let starts = all.iter().flat_map(|(arrays, of)| arrays.iter().zip(*of));
        let starts = starts.map(|(array, of)| Strided {
            start: data(array),
            state: 0,
            entry: entry(array, of.shape.len()).unwrap_or(0),
        });
        let job = Job {
            loops: self.loops(&all),
            work,
            arrays: starts.collect(),
            results: results.1,
        };
        let operations = self.count.saturating_mul(work.operations);
        let threads = match operations / SHARE {
            few @ 0..2 => few,
            most => work.threads.map_or_else(cores, NonZero::get).min(most),
        };
        match threads {
            // Other threads of Python wait no longer for that than for the lock itself.
            _ if operations < SHORT => job.compute(0, self.count),
            0 | 1 => py.detach(|| job.compute(0, self.count)),
            _ => py.detach(|| {
                let share = self.count.div_ceil(threads);
                let job = &job;
                thread::scope(|scope| {
                    for first in (share..self.count).step_by(share) {
                        let end = (first + share).min(self.count);
                        scope.spawn(move || job.compute(first, end));
                    }
                    job.compute(0, share);
                });
            }),
        }
    }
}

/// The number of cores that the process may use.
fn cores() -> usize {
    thread::available_parallelism().map_or(1, NonZero::get)
}

/// A new array.
pub fn room<'py>(py: Python<'py>, shape: &[usize], single: bool) -> Bound<'py, PyUntypedArray> {
    if single {
        unwritten::<f32>(py, shape)
    } else {
        unwritten::<f64>(py, shape)
    }
}

#[expect(unsafe_code, reason = "what is in it is written before it is read")]
fn unwritten<'py, T: Element>(py: Python<'py>, shape: &[usize]) -> Bound<'py, PyUntypedArray> {
    // SAFETY: numbers of any bits are numbers, and all of them are written.
    let array = unsafe { PyArrayDyn::<T>::new(py, shape, false) };
    array.as_untyped().clone()
}

/// A call, as its threads share it.
struct Job<'a> {
    /// The leading axes as loops, as [`States::loops`] has them.
    loops: Vec<(usize, Vec<isize>)>,
    work: &'a Work<'a>,
    /// The arguments, then the results, at their first state.
    arrays: Vec<Strided>,
    results: &'a [Array],
}

#[expect(unsafe_code, reason = "threads share addresses")]
// SAFETY: arguments are only read, and no two threads write the same state of a result.
unsafe impl Sync for Job<'_> {}

impl Job<'_> {
    /// Computes the states from one up to another, in the order of the leading axes.
    fn compute(&self, first: usize, end: usize) {
        let alone = (1, vec![0; self.arrays.len()]);
        let (last, outer) = self.loops.split_last().unwrap_or((&alone, &[]));
        let (inner, last) = last;
        let size = self.work.size.cast_signed();
        let mut arrays = self.arrays.clone();
        let mut state = first;
        while state < end {
            let within = state % inner;
            let count = (inner - within).min(end - state);
            for (k, (array, begin)) in arrays.iter_mut().zip(&self.arrays).enumerate() {
                let mut bytes = within.cast_signed() * last[k];
                let mut rest = state / inner;
                for (length, steps) in outer.iter().rev() {
                    bytes += (rest % length).cast_signed() * steps[k];
                    rest /= length;
                }
                array.start = begin.start.wrapping_offset(bytes);
                array.state = (last[k] / size) as i64;
            }
            self.work.call(count, &arrays);
            let results = &arrays[arrays.len() - self.results.len()..];
            for (array, of) in results.iter().zip(self.results) {
                self.work.write_below(array, of, count);
            }
            state += count;
        }
    }
}

impl Work<'_> {
    #[expect(unsafe_code, reason = "compiled code is called by its address")]
    fn call(&self, count: usize, arrays: &[Strided]) {
        // SAFETY: the address is that of a function of this signature, whose code is kept by whoever holds the address; it
        // reads and writes these states of the arrays, whose shapes have been checked.
        unsafe {
            let entry: Entry = std::mem::transmute(self.address);
            entry(
                count.cast_signed() as i64,
                self.fields.start(),
                arrays.as_ptr(),
            );
        }
    }

    /// Writes the constant row below the others, where a result has one, of some states.
    #[expect(unsafe_code, reason = "results are known by their addresses")]
    fn write_below(&self, array: &Strided, of: &Array, count: usize) {
        let Some(row) = of.below else {
            return;
        };
        #[expect(
            clippy::cast_possible_truncation,
            reason = "NumPy's strides were so before"
        )]
        let strides = [array.state, array.entry].map(|stride| stride as isize);
        for state in 0..count {
            for (k, value) in row.into_iter().enumerate() {
                let [state, entry] = [state, of.len + k].map(usize::cast_signed);
                let place = (state * strides[0] + entry * strides[1]) * self.size.cast_signed();
                let place = array.start.wrapping_offset(place);
                // SAFETY: the result has four numbers of each state behind those that code writes.
                unsafe {
                    if self.size == size_of::<f32>() {
                        #[expect(clippy::cast_possible_truncation, reason = "it is 0 or 1")]
                        let bytes = (value as f32).to_ne_bytes();
                        place.copy_from_nonoverlapping(bytes.as_ptr(), bytes.len());
                    } else {
                        let bytes = value.to_ne_bytes();
                        place.copy_from_nonoverlapping(bytes.as_ptr(), bytes.len());
                    }
                }
            }
        }
    }
}

/// The exception for leading axes that cannot be broadcast together.
fn apart(arrays: &[Bound<'_, PyUntypedArray>], of: &[Array]) -> PyErr {
    let leading = arrays.iter().zip(of).map(|(array, of)| {
        let shape = array.shape();
        let leading = &shape[..shape.len() - of.shape.len()];
        format!("{} {}", of.name, shape_text(leading))
    });
    let leading: Vec<String> = leading.collect();
    PyValueError::new_err(format!(
        "leading axes cannot be broadcast together: {}",
        leading.join(", ")
    ))
}

/// A place for a result that the user has named.
pub fn out<'py>(
    value: &Bound<'py, PyAny>,
    (name, shape): (&str, &[usize]),
    single: bool,
) -> PyResult<Bound<'py, PyUntypedArray>> {
    let wanted = if single { Type::Single } else { Type::Double };
    if Type::of(value) != wanted {
        let words = if single { "float32" } else { "float64" };
        return Err(PyTypeError::new_err(format!(
            "out for {name} must be an array of {words}"
        )));
    }
    let array = value.cast::<PyUntypedArray>()?;
    if array.shape() != shape {
        return Err(PyValueError::new_err(format!(
            "out for {name} has the shape {}, and must have {}",
            shape_text(array.shape()),
            shape_text(shape)
        )));
    }
    if !is_writeable(array) {
        return Err(PyValueError::new_err(format!(
            "out for {name} is read-only"
        )));
    }
    Ok(array.clone())
}

#[expect(unsafe_code, reason = "NumPy hands out the flags in a struct")]
fn is_writeable(array: &Bound<'_, PyUntypedArray>) -> bool {
    // SAFETY: the array is alive, and its struct holds the flags.
    unsafe { (*array.as_array_ptr()).fields.flags & npyffi::NPY_ARRAY_WRITEABLE != 0 }
}

/// True if results can be written to an array as they are computed: no two of its numbers share a place, those of a state
/// are at one distance, and none is read, or written as another result.
pub fn is_direct(
    array: &Bound<'_, PyUntypedArray>,
    own: usize,
    others: &[Bound<'_, PyUntypedArray>],
) -> bool {
    let [start, end] = extent(array);
    let is_apart = others.iter().all(|other| {
        let [first, last] = extent(other);
        last <= start || end <= first
    });
    let axes = array.shape().iter().zip(array.strides());
    let mut axes: Vec<(usize, usize)> = axes
        .map(|(&length, stride)| (stride.unsigned_abs(), length))
        .filter(|(_, length)| *length > 1)
        .collect();
    axes.sort_unstable();
    let mut taken = array.dtype().itemsize();
    let is_open = axes.into_iter().all(|(stride, length)| {
        let is_clear = stride >= taken;
        taken = stride * length;
        is_clear
    });
    is_apart && is_open && entry(array, own).is_some()
}

/// The addresses from which on, and up to which, an array has numbers.
fn extent(array: &Bound<'_, PyUntypedArray>) -> [usize; 2] {
    let start = data(array).addr();
    let mut ends = [start, start];
    for (&length, &stride) in array.shape().iter().zip(array.strides()) {
        let reach = length.saturating_sub(1).cast_signed() * stride;
        let end = usize::from(reach > 0);
        ends[end] = ends[end].wrapping_add_signed(reach);
    }
    ends[1] += array.dtype().itemsize();
    ends
}

/// A shape as Python writes it.
fn shape_text(shape: &[usize]) -> String {
    match shape {
        [one] => format!("({one},)"),
        _ => format!("({})", commas(shape)),
    }
}

fn commas(lengths: &[usize]) -> String {
    let lengths: Vec<String> = lengths.iter().map(ToString::to_string).collect();
    lengths.join(", ")
}
