//! Arrays of states: how those of NumPy are read, broadcast and shared between threads.
//!
//! In: arguments, their shapes, and the address of a compiled function. Out: results. Arguments are read where they lie,
//! at any stride; states are a loop of the compiled function. It never computes a number.

use std::num::NonZero;
use std::ops::Range;
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
    /// How many bytes a number has.
    pub size: usize,
    /// How many operations a state takes.
    pub operations: usize,
    /// How many threads share it, at most; as many as there are cores where nobody says.
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
    /// That of a value: an array itself, and none of a class made of it, whose numbers are aligned and in the order of bytes
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

/// What Python makes of arguments that cannot be read as they are.
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

/// How far entries of one state are apart in an array whose last axes are those of a state, in numbers; `None` where that is
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
    /// Whether its numbers are single.
    pub single: bool,
}

/// The most arguments and results of a function.
const MOST: usize = 8;

impl One {
    /// The arguments of a call; `None` where they are anything else.
    pub fn read(arguments: &Bound<'_, PyTuple>, of: &[Array]) -> Option<Self> {
        let nothing = Strided {
            start: std::ptr::null_mut(),
            state: 0,
            entry: 0,
        };
        let kind = Type::of(arguments.get_borrowed_item(0).ok()?.as_any());
        if arguments.len() != of.len() || kind == Type::Other {
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
            if let Some(row) = of.below {
                work.write_below(array, of, row, 0..1);
            }
        }
        rooms
    }
}

/// The states that arguments are of, whatever their leading axes.
pub struct States {
    /// The leading axes of results.
    pub shape: Vec<usize>,
    /// How many states there are.
    pub count: usize,
    /// The leading axes as loops, the innermost last: the length, and how far each argument goes in bytes.
    loops: Vec<(usize, Vec<isize>)>,
}

impl States {
    /// Those of some arguments, broadcast as NumPy does.
    pub fn of(arrays: &[Bound<'_, PyUntypedArray>], of: &[Array]) -> PyResult<Self> {
        let own = of.iter().map(|of| of.shape.len());
        let leading = || arrays.iter().zip(own.clone());
        let axes = leading().map(|(array, own)| array.ndim() - own).max();
        let axes = axes.unwrap_or(0);
        let mut states = Self {
            shape: vec![1; axes],
            count: 1,
            loops: Vec::new(),
        };
        for axis in 0..axes {
            for (array, own) in leading() {
                let length = at(array.shape(), own, axes, axis).copied().unwrap_or(1);
                let found = &mut states.shape[axis];
                if *found == 1 {
                    *found = length;
                } else if length != 1 && length != *found {
                    return Err(apart(arrays, of));
                }
            }
            let length = states.shape[axis];
            states.count *= length;
            if length == 1 {
                continue;
            }
            let steps = leading().map(|(array, own)| {
                let is_longer = at(array.shape(), own, axes, axis).is_some_and(|&own| own != 1);
                let stride = at(array.strides(), own, axes, axis).copied();
                stride.filter(|_| is_longer).unwrap_or(0)
            });
            let steps: Vec<isize> = steps.collect();
            // Axes that follow each other in every argument are one.
            match states.loops.last_mut() {
                Some((count, before))
                    if (before.iter().zip(&steps))
                        .all(|(&outer, &inner)| outer == inner * length.cast_signed()) =>
                {
                    *count *= length;
                    *before = steps;
                }
                _ => states.loops.push((length, steps)),
            }
        }
        Ok(states)
    }

    /// An array for a result of all states.
    pub fn room<'py>(
        &self,
        py: Python<'py>,
        of: &Array,
        single: bool,
    ) -> Bound<'py, PyUntypedArray> {
        room(py, &[self.shape.as_slice(), &of.shape].concat(), single)
    }

    /// Computes all states.
    pub fn run(
        &self,
        py: Python<'_>,
        work: &Work<'_>,
        arguments: (&[Bound<'_, PyUntypedArray>], &[Array]),
        results: (&[Bound<'_, PyUntypedArray>], &[Array]),
    ) {
        /// So many operations take about as long as a thread that begins.
        const SHARE: usize = 1 << 21;
        /// So many take less than a microsecond or a few.
        const SHORT: usize = 1 << 14;
        if self.count == 0 {
            return;
        }
        let read = arguments.0.iter().zip(arguments.1);
        let read = read.map(|(array, of)| Strided {
            start: data(array),
            state: 0,
            entry: entry(array, of.shape.len()).unwrap_or(0),
        });
        let write = results.0.iter().zip(results.1);
        let write = write.map(|(array, of)| Strided {
            start: data(array),
            state: size_of_state(of) as i64,
            entry: 1,
        });
        let job = Job {
            states: self,
            work,
            arrays: read.chain(write).collect(),
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

/// How many threads a call is shared by where nobody says.
fn cores() -> usize {
    thread::available_parallelism().map_or(1, NonZero::get)
}

/// An entry of the leading axes of an array, of `axes` of them; `None` where it has none there.
fn at<T>(values: &[T], own: usize, axes: usize, place: usize) -> Option<&T> {
    let leading = values.len() - own;
    let within = (place + leading).checked_sub(axes);
    within.map(|place| &values[place])
}

/// How many numbers a result has of a state.
fn size_of_state(of: &Array) -> isize {
    of.shape.iter().product::<usize>().cast_signed()
}

/// A new array.
fn room<'py>(py: Python<'py>, shape: &[usize], single: bool) -> Bound<'py, PyUntypedArray> {
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

/// What threads share.
struct Job<'a> {
    states: &'a States,
    work: &'a Work<'a>,
    /// The arguments, then the results, at their first state.
    arrays: Vec<Strided>,
    results: &'a [Array],
}

#[expect(unsafe_code, reason = "threads share addresses")]
// SAFETY: arguments are only read, and no two threads write the same state of a result.
unsafe impl Sync for Job<'_> {}

impl Job<'_> {
    /// Computes the states from one up to another, of all in the order of results.
    fn compute(&self, first: usize, end: usize) {
        let loops = &self.states.loops;
        let (inner, outer) = loops
            .split_last()
            .map_or((1, loops.as_slice()), |(last, outer)| (last.0, outer));
        let size = self.work.size.cast_signed();
        let arguments = self.arrays.len() - self.results.len();
        let mut arrays = self.arrays.clone();
        let mut state = first;
        while state < end {
            let within = state % inner;
            let count = (inner - within).min(end - state);
            for (k, (array, begin)) in arrays.iter_mut().zip(&self.arrays).enumerate() {
                let bytes = if k < arguments {
                    let step = loops.last().map_or(0, |(_, steps)| steps[k]);
                    array.state = (step / size) as i64;
                    let mut rest = state / inner;
                    let mut bytes = within.cast_signed() * step;
                    for (length, steps) in outer.iter().rev() {
                        bytes += (rest % length).cast_signed() * steps[k];
                        rest /= length;
                    }
                    bytes
                } else {
                    let each = size_of_state(&self.results[k - arguments]);
                    state.cast_signed() * each * size
                };
                array.start = begin.start.wrapping_offset(bytes);
            }
            self.work.call(count, &arrays);
            state += count;
        }
        for (array, of) in self.arrays[arguments..].iter().zip(self.results) {
            if let Some(row) = of.below {
                self.work.write_below(array, of, row, first..end);
            }
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

    /// Writes the constant last row of matrices of some states, which stand one behind the other.
    #[expect(unsafe_code, reason = "results are known by their addresses")]
    fn write_below(&self, array: &Strided, of: &Array, row: [f64; 4], states: Range<usize>) {
        let each = size_of_state(of).unsigned_abs();
        for state in states {
            for (k, value) in row.into_iter().enumerate() {
                let place = (state * each + of.len + k) * self.size;
                let place = array.start.wrapping_add(place);
                // SAFETY: the result has `each` numbers of each state, of which these are the last.
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

/// That leading axes cannot be broadcast together.
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

/// Whether results can be written to an array as they are computed: one number behind the other, and nothing of it read.
pub fn is_direct(
    array: &Bound<'_, PyUntypedArray>,
    arguments: &[Bound<'_, PyUntypedArray>],
) -> bool {
    let is_aligned = data(array).addr().is_multiple_of(array.dtype().itemsize());
    let [start, end] = extent(array);
    let apart = arguments.iter().all(|argument| {
        let [first, last] = extent(argument);
        last <= start || end <= first
    });
    array.is_c_contiguous() && is_aligned && apart
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
