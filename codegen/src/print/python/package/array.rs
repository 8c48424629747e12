//! Arguments from Python, and results for it.
//!
//! Arguments are read in place if they are aligned, contiguous in C order and of the robot's scalar type, and copied
//! otherwise. Leading axes are broadcast as in NumPy.

use numpy::{
    PyArrayDyn, PyArrayMethods, PyReadonlyArrayDyn, PyReadwriteArrayDyn, PyUntypedArrayMethods,
};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{PyDict, PyFloat, PyInt, PyList, PyTuple};

use crate::batch::{self, Argument, Work};
use crate::real::{DTYPE, Real};

/// The arguments of a call: name, object and required last axes of each.
pub type Given<'a, 'py> = (&'static str, &'a Bound<'py, PyAny>, &'static [usize]);

/// The arguments of a call, broadcast to the same leading axes.
pub struct States<'py, const K: usize> {
    arrays: [PyReadonlyArrayDyn<'py, Real>; K],
    /// True for an argument with one value for all states.
    is_for_all: [bool; K],
    /// The leading axes.
    leading: Vec<usize>,
    /// Number of states.
    count: usize,
}

impl<'py, const K: usize> States<'py, K> {
    /// Reads arguments.
    ///
    /// # Errors
    /// `TypeError` if numbers cannot safely be cast to the robot's type, `ValueError` if the last axes of an argument
    /// are wrong or its leading axes cannot be broadcast.
    pub fn of(py: Python<'py>, given: [Given<'_, 'py>; K]) -> PyResult<Self> {
        let mut arrays = Vec::with_capacity(K);
        for (name, object, last) in &given {
            arrays.push(array(py, name, object, last)?);
        }
        let mut leading = leading(&arrays[0], given[0].2).to_vec();
        if (1..K).any(|k| self::leading(&arrays[k], given[k].2) != leading) {
            leading = broadcast(&arrays, &given)?;
        }
        let count = states(&leading)?;
        let mut is_for_all = [false; K];
        for (k, (name, _, last)) in given.iter().enumerate() {
            let own = self::leading(&arrays[k], last);
            if own == leading {
                continue;
            }
            is_for_all[k] = own.iter().all(|&length| length == 1);
            if !is_for_all[k] {
                let shape = PyTuple::new(py, [&leading, *last].concat())?;
                let lying: &Bound<'py, PyArrayDyn<Real>> = &arrays[k];
                let whole = numpy(py)?.call_method1("broadcast_to", (lying, shape))?;
                let whole = numpy(py)?.call_method1("ascontiguousarray", (whole,))?;
                arrays[k] = readable(name, whole.cast::<PyArrayDyn<Real>>()?)?;
            }
        }
        let Ok(arrays) = arrays.try_into() else {
            unreachable!("an array for each argument");
        };
        Ok(Self {
            arrays,
            is_for_all,
            leading,
            count,
        })
    }

    /// Number of states.
    pub fn count(&self) -> usize {
        self.count
    }

    /// One of the arguments.
    pub fn argument<const N: usize>(&self, k: usize) -> PyResult<Argument<'_, N>> {
        Ok(Argument::of(self.arrays[k].as_slice()?, self.is_for_all[k]))
    }

    /// Array for results with these last axes.
    ///
    /// # Errors
    /// `TypeError` or `ValueError` if `out` is not such an array, `MemoryError` if memory is exhausted.
    pub fn room(
        &self,
        py: Python<'py>,
        last: &[usize],
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Room<'py>> {
        let shape = [&*self.leading, last].concat();
        let array = match out {
            Some(out) => written(out, &shape)?,
            None => {
                static ZEROS: PyOnceLock<Py<PyAny>> = PyOnceLock::new();
                let zeros = ZEROS.import(py, "numpy", "zeros")?;
                let type_of_number = numpy::dtype::<Real>(py);
                let array = zeros.call1((PyTuple::new(py, &shape)?, type_of_number))?;
                array.cast_into::<PyArrayDyn<Real>>()?
            }
        };
        let array = array.try_readwrite().map_err(|_| {
            PyValueError::new_err("out cannot be written to, or overlaps with an argument")
        })?;
        Ok(Room { array })
    }
}

/// Array for results.
pub struct Room<'py> {
    array: PyReadwriteArrayDyn<'py, Real>,
}

impl<'py> Room<'py> {
    /// The numbers, one state after the other.
    pub fn numbers(&mut self) -> PyResult<&mut [Real]> {
        Ok(self.array.as_slice_mut()?)
    }

    /// The array; a number if it has no axes.
    pub fn into_python(self) -> PyResult<Bound<'py, PyAny>> {
        let array: &Bound<'py, PyArrayDyn<Real>> = &self.array;
        let array = array.clone();
        if array.ndim() == 0 {
            return array.get_item(PyTuple::empty(array.py()));
        }
        Ok(array.into_any())
    }
}

/// Does the work, without Python's lock if the work takes longer than releasing it.
pub fn run<W: Work>(py: Python<'_>, work: W) {
    if work.states() < FEW {
        batch::run(work);
    } else {
        py.detach(|| batch::run(work));
    }
}

/// Number of states that take as long as releasing and acquiring Python's lock.
const FEW: usize = 8;

/// Argument as an array that can be read in place.
fn array<'py>(
    py: Python<'py>,
    name: &str,
    object: &Bound<'py, PyAny>,
    last: &[usize],
) -> PyResult<PyReadonlyArrayDyn<'py, Real>> {
    let own = object.cast::<PyArrayDyn<Real>>();
    let array = match own {
        Ok(array) if array.is_c_contiguous() && array.is_aligned() => array.clone(),
        _ => converted(py, name, object)?,
    };
    if !array.shape().ends_with(last) {
        let mut wanted = vec!["...".to_owned()];
        wanted.extend(last.iter().map(usize::to_string));
        return Err(PyValueError::new_err(format!(
            "{name} must have a shape of ({}), and has {}",
            wanted.join(", "),
            shown(array.shape())
        )));
    }
    readable(name, &array)
}

fn readable<'py>(
    name: &str,
    array: &Bound<'py, PyArrayDyn<Real>>,
) -> PyResult<PyReadonlyArrayDyn<'py, Real>> {
    let refuse = |_| PyValueError::new_err(format!("{name} is being written to by another call"));
    array.try_readonly().map_err(refuse)
}

/// Copy in the robot's scalar type of anything that NumPy safely casts to it.
fn converted<'py>(
    py: Python<'py>,
    name: &str,
    object: &Bound<'py, PyAny>,
) -> PyResult<Bound<'py, PyArrayDyn<Real>>> {
    let numpy = numpy(py)?;
    let array = numpy.call_method1("asarray", (object,))?;
    let given = array.getattr("dtype")?;
    // Python's own numbers have no scalar type to lose.
    let is_plain = object.is_instance_of::<PyList>()
        || object.is_instance_of::<PyTuple>()
        || object.is_instance_of::<PyFloat>()
        || object.is_instance_of::<PyInt>();
    let rule = if is_plain { "same_kind" } else { "safe" };
    let wanted = numpy::dtype::<Real>(py);
    let is_safe = numpy.call_method1("can_cast", (&given, &wanted, rule))?;
    if !is_safe.is_truthy()? {
        return Err(PyTypeError::new_err(format!(
            "{name} is of {given}, which cannot safely be cast to {DTYPE}"
        )));
    }
    let options = PyDict::new(py);
    options.set_item("dtype", wanted)?;
    options.set_item("requirements", ["C", "A"])?;
    let array = numpy.call_method("require", (array,), Some(&options))?;
    Ok(array.cast_into::<PyArrayDyn<Real>>()?)
}

/// The array to be written to.
fn written<'py>(
    out: &Bound<'py, PyAny>,
    shape: &[usize],
) -> PyResult<Bound<'py, PyArrayDyn<Real>>> {
    let array = out
        .cast::<PyArrayDyn<Real>>()
        .map_err(|_| PyTypeError::new_err(format!("out must be an array of {DTYPE}")))?;
    if array.shape() != shape {
        return Err(PyValueError::new_err(format!(
            "out must have a shape of {}, and has {}",
            shown(shape),
            shown(array.shape())
        )));
    }
    if !(array.is_c_contiguous() && array.is_aligned()) {
        return Err(PyValueError::new_err(
            "out must be contiguous in C's order, and aligned",
        ));
    }
    Ok(array.clone())
}

fn numpy(py: Python<'_>) -> PyResult<&Bound<'_, PyAny>> {
    static NUMPY: PyOnceLock<Py<PyAny>> = PyOnceLock::new();
    let numpy = NUMPY.get_or_try_init(py, || {
        Ok::<_, PyErr>(py.import("numpy")?.into_any().unbind())
    })?;
    Ok(numpy.bind(py))
}

/// Axes of an array before the last ones.
fn leading<'a>(array: &'a PyReadonlyArrayDyn<'_, Real>, last: &[usize]) -> &'a [usize] {
    let shape = array.shape();
    &shape[..shape.len() - last.len()]
}

/// Leading axes that all arguments are broadcast to.
fn broadcast(
    arrays: &[PyReadonlyArrayDyn<'_, Real>],
    given: &[Given<'_, '_>],
) -> PyResult<Vec<usize>> {
    let leading = |k: usize| leading(&arrays[k], given[k].2);
    let mut all = (0..given.len()).map(leading);
    let common = all.try_fold(Vec::new(), |common, own| together(&common, own));
    common.ok_or_else(|| {
        let each = (0..given.len()).map(|k| format!("{} {}", given[k].0, shown(leading(k))));
        let each = each.collect::<Vec<_>>().join(", ");
        PyValueError::new_err(format!(
            "leading axes that cannot be broadcast together: {each}"
        ))
    })
}

/// Axes that two shapes are broadcast to, if they are compatible.
fn together(one: &[usize], other: &[usize]) -> Option<Vec<usize>> {
    let axes = one.len().max(other.len());
    let axis = |shape: &[usize], k: usize| {
        let missing = axes - shape.len();
        if k < missing { 1 } else { shape[k - missing] }
    };
    let pair = |k: usize| match (axis(one, k), axis(other, k)) {
        (1, length) | (length, 1) => Some(length),
        (length, same) => (length == same).then_some(length),
    };
    (0..axes).map(pair).collect()
}

/// Number of states of these leading axes.
fn states(leading: &[usize]) -> PyResult<usize> {
    let count = leading
        .iter()
        .try_fold(1_usize, |count, &length| count.checked_mul(length));
    count.ok_or_else(|| PyValueError::new_err("there are too many states"))
}

/// Shape as in Python.
fn shown(shape: &[usize]) -> String {
    match shape {
        [only] => format!("({only},)"),
        all => {
            let all: Vec<String> = all.iter().map(usize::to_string).collect();
            format!("({})", all.join(", "))
        }
    }
}
