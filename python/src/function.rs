//! A function of a robot, as Python calls it.
//!
//! In: a recipe, a name, and how code is compiled. Out: a callable object, which asks for code when it is called with other
//! options or another type of number than before, and keeps it. It never knows LLVM.

use std::collections::HashMap;
use std::sync::{Arc, OnceLock, PoisonError, RwLock};

use homogen_codegen::print::arrays::{Array, Order, Signature};
use numpy::{IxDyn, PyArrayDyn, PyUntypedArray, PyUntypedArrayMethods};
use pyo3::exceptions::{PyAttributeError, PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PySlice, PyTuple};

use super::recipe::{Recipe, order_name, order_of, refused};
use super::states::{Fields, Given, One, States, Type, Work, argument, is_direct, out, room};

/// A function of a robot, compiled when it is first called.
#[pyclass(frozen, subclass, module = "homogen._engine")]
pub struct Function {
    recipe: Py<Recipe>,
    /// Compiles: recipe, name, frame, order, whether numbers are single, whether states are many; an address, how many
    /// operations a state takes, and what keeps the code alive.
    compile: Py<PyAny>,
    /// The type of several results.
    tuple: Option<Py<PyAny>>,
    signature: Signature,
    kernels: RwLock<HashMap<Variant, Arc<Kernel>>>,
    /// The code for one state of a call without options, in double and in single precision.
    usual: [OnceLock<Arc<Kernel>>; 2],
}

/// The code of a function for one kind of call.
#[derive(Clone, PartialEq, Eq, Hash)]
struct Variant {
    frame: Option<String>,
    order: Order,
    single: bool,
    many: bool,
}

/// An array's name, and its shape for one state.
type Shape = (String, Vec<usize>);

/// Compiled code.
struct Kernel {
    address: usize,
    /// The operations that a state takes, about.
    operations: usize,
    /// The Python object that keeps the code alive.
    _code: Py<PyAny>,
}

/// The least count of states that are computed in the lanes of vectors.
const MANY: usize = 16;

/// Keywords of a call beside its arguments.
#[derive(Default)]
struct Options<'py> {
    frames: Frames,
    order: Option<Order>,
    out: Option<Bound<'py, PyAny>>,
}

/// The links whose frames a function is about.
enum Frames {
    /// One; the tip where none is named.
    One(Option<String>),
    /// Several, each with results of its own.
    Several(Vec<String>),
}

impl Default for Frames {
    fn default() -> Self {
        Self::One(None)
    }
}

#[pymethods]
impl Function {
    #[new]
    fn new(
        py: Python<'_>,
        recipe: Py<Recipe>,
        name: &str,
        compile: Py<PyAny>,
        tuple: Option<Py<PyAny>>,
    ) -> PyResult<Self> {
        let of = recipe.get();
        let signature = py.detach(|| of.signature(name).map_err(refused))?;
        let signature = signature.ok_or_else(|| {
            PyAttributeError::new_err(format!("a robot has no function {name:?}"))
        })?;
        Ok(Self {
            recipe,
            compile,
            tuple,
            signature,
            kernels: RwLock::default(),
            usual: Default::default(),
        })
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyTuple>> {
        let (py, of) = (slf.py(), slf.get());
        let given = (
            of.recipe.clone_ref(py),
            of.signature.name,
            of.compile.clone_ref(py),
            of.tuple.as_ref().map(|tuple| tuple.clone_ref(py)),
        );
        (slf.get_type(), given).into_pyobject(py)
    }

    fn __repr__(&self) -> String {
        let shown = |arrays: &[Array]| {
            let shown = arrays.iter().map(|of| format!("{} {}", of.name, shape(of)));
            shown.collect::<Vec<_>>().join(", ")
        };
        let of = &self.signature;
        let results = match &*of.results {
            [one] => shape(one),
            several => shown(several),
        };
        format!("<{}: {} -> {results}>", of.name, shown(&of.arguments))
    }

    /// Its name.
    #[getter]
    fn name(&self) -> &'static str {
        self.signature.name
    }

    /// Its documentation: meaning, shapes, units.
    fn about(&self) -> String {
        let of = &self.signature;
        let mut lines = of.about.clone();
        lines.push(String::new());
        let line = |array: &Array| {
            let units = match &*array.units {
                [] => String::new(),
                units => format!(", in {}", units.join(", ")),
            };
            let otherwise = if array.is_change {
                " [default: zeros]"
            } else {
                ""
            };
            format!("{}: {}{units}{otherwise}", array.name, shape(array))
        };
        lines.extend(of.arguments.iter().map(line));
        lines.push(match &*of.results {
            [_] => "Returns:".to_owned(),
            _ => "Returns a tuple:".to_owned(),
        });
        let results = of.results.iter().map(|of| format!("    {}", line(of)));
        lines.extend(results);
        if of.has_order {
            let order = order_name(self.recipe.get().default_order());
            lines.push(format!(
                "order: \"linear_first\" (v, ω; f, c; ρ, γ) or \"angular_first\", the order of six numbers [default: {order:?}]"
            ));
        }
        if of.of_a_frame {
            lines.push("frame: the link whose frame it is about [default: the tip]; several are an axis before those of a result".to_owned());
        }
        lines
            .push("out: the array, or the tuple of arrays, that results are written to".to_owned());
        lines.join("\n")
    }

    /// The names of arguments, and of the keywords besides.
    fn parameters(&self) -> (Vec<String>, Vec<&'static str>) {
        let of = &self.signature;
        let names = of.arguments.iter().map(|of| of.name.clone());
        let keywords = [
            (of.of_a_frame, "frame"),
            (of.has_order, "order"),
            (true, "out"),
        ];
        let keywords = keywords.into_iter().filter(|(has, _)| *has);
        (names.collect(), keywords.map(|(_, name)| name).collect())
    }

    /// The number of arguments before the first that may be left out.
    fn needed(&self) -> usize {
        let arguments = &self.signature.arguments;
        let first = arguments.iter().position(|of| of.is_change);
        first.unwrap_or(arguments.len())
    }

    /// The names of arguments and of results, each with the shape of one state.
    fn arrays(&self) -> [Vec<Shape>; 2] {
        let of = |arrays: &[Array]| {
            let arrays = arrays.iter();
            arrays
                .map(|of| (of.name.clone(), of.shape.clone()))
                .collect()
        };
        [&self.signature.arguments, &self.signature.results].map(|arrays| of(arrays))
    }

    /// The constant row below each result that has one.
    fn below(&self) -> Vec<Option<[f64; 4]>> {
        let results = self.signature.results.iter();
        results.map(|of| of.below).collect()
    }

    /// Compiles what a call with these options and so many states would wait for.
    #[pyo3(signature = (*, frame = None, order = None, single = false, many = false))]
    fn compile(
        &self,
        py: Python<'_>,
        frame: Option<&str>,
        order: Option<&str>,
        single: bool,
        many: bool,
    ) -> PyResult<()> {
        let order = order.map(order_of).transpose()?;
        self.kernel(py, frame, order, single, many).map(|_| ())
    }

    #[pyo3(signature = (*arguments, **options))]
    fn __call__<'py>(
        &self,
        py: Python<'py>,
        arguments: &Bound<'py, PyTuple>,
        options: Option<&Bound<'py, PyDict>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        if let (None, Some(done)) = (options, self.one(py, arguments)) {
            return done;
        }
        let (values, options) = self.read(arguments, options)?;
        let of = &self.signature;
        let single = values.iter().all(|value| Type::of(value) == Type::Single);
        let given = values.iter().zip(&of.arguments);
        let given: Vec<Bound<'py, PyUntypedArray>> = given
            .map(|(value, of)| argument(value, of, single))
            .collect::<PyResult<_>>()?;
        let given = (&*given, &*of.arguments);
        let states = States::of(given)?;
        let further: &[usize] = match &options.frames {
            Frames::One(_) => &[],
            Frames::Several(frames) => &[frames.len()],
        };
        let wanted = self.wanted(&options, &states, further, single)?;
        let mut rooms: Vec<Bound<'py, PyUntypedArray>> = Vec::new();
        for (k, result) in of.results.iter().enumerate() {
            let own = further.len() + result.shape.len();
            let direct = wanted.get(k).filter(|array| {
                is_direct(array, result.shape.len(), given.0) && is_direct(array, own, &rooms)
            });
            rooms.push(match direct {
                Some(array) => array.clone(),
                None => room(py, &states.shape_of(further, result), single),
            });
        }
        let many = states.count >= MANY;
        match &options.frames {
            Frames::One(frame) => {
                let code = self.kernel(py, frame.as_deref(), options.order, single, many)?;
                self.run(py, &code, &states, given, &rooms, single);
            }
            Frames::Several(frames) => {
                for (k, frame) in frames.iter().enumerate() {
                    let code = self.kernel(py, Some(frame), options.order, single, many)?;
                    let parts = rooms.iter().zip(&of.results);
                    let parts = parts.map(|(room, result)| part(room, k, result.shape.len()));
                    let parts = parts.collect::<PyResult<Vec<_>>>()?;
                    self.run(py, &code, &states, given, &parts, single);
                }
            }
        }
        for (array, room) in wanted.iter().zip(&rooms) {
            if !array.is(room) {
                array.set_item(py.Ellipsis(), room)?;
            }
        }
        self.returned(py, if wanted.is_empty() { rooms } else { wanted })
    }
}

impl Function {
    /// The usual call: of one state, whose code is there and whose arguments can be read as they are. `None` of any other.
    fn one<'py>(
        &self,
        py: Python<'py>,
        arguments: &Bound<'py, PyTuple>,
    ) -> Option<PyResult<Bound<'py, PyAny>>> {
        let of = &self.signature;
        let one = One::read(arguments, &of.arguments, of.results.len())?;
        let kernel = self.usual[usize::from(one.single)].get()?;
        let fields = self.recipe.get().field_values(one.single);
        let results = one.run(py, &self.work(kernel, &fields), &of.results);
        Some(self.returned(py, results))
    }

    fn run(
        &self,
        py: Python<'_>,
        code: &Kernel,
        states: &States,
        given: Given<'_, '_>,
        results: &[Bound<'_, PyUntypedArray>],
        single: bool,
    ) {
        let fields = self.recipe.get().field_values(single);
        let work = self.work(code, &fields);
        states.run(py, &work, given, (results, &self.signature.results));
    }

    fn work<'f>(&self, kernel: &Kernel, fields: &'f Fields) -> Work<'f> {
        Work {
            address: kernel.address,
            operations: kernel.operations,
            fields,
            size: match fields {
                Fields::Single(_) => 4,
                Fields::Double(_) => 8,
            },
            threads: self.recipe.get().threads(),
        }
    }

    /// The values of the arguments in their order, and the options.
    fn read<'py>(
        &self,
        arguments: &Bound<'py, PyTuple>,
        keywords: Option<&Bound<'py, PyDict>>,
    ) -> PyResult<(Vec<Bound<'py, PyAny>>, Options<'py>)> {
        let of = &self.signature;
        let mut values: Vec<Option<Bound<'py, PyAny>>> = arguments.iter().map(Some).collect();
        if values.len() > of.arguments.len() {
            return Err(self.misused(&format!("{} were given", values.len())));
        }
        values.resize(of.arguments.len(), None);
        let mut options = Options::default();
        for (key, value) in keywords.into_iter().flatten() {
            let key: String = key.extract()?;
            let place = of.arguments.iter().position(|of| of.name == key);
            match (&*key, place) {
                (_, Some(place)) if values[place].is_none() => values[place] = Some(value),
                (_, Some(_)) => return Err(self.misused(&format!("{key} was given twice"))),
                (_, None) if value.is_none() => {}
                ("frame", _) if of.of_a_frame => options.frames = frames(&value)?,
                ("order", _) if of.has_order => {
                    options.order = Some(order_of(&value.extract::<String>()?)?);
                }
                ("out", _) => options.out = Some(value),
                _ => return Err(self.misused(&format!("it has no keyword {key}"))),
            }
        }
        self.fill_changes(arguments.py(), &mut values);
        let missing = values.iter().position(Option::is_none);
        if let Some(missing) = missing {
            let name = &of.arguments[missing].name;
            return Err(self.misused(&format!("{name} is missing")));
        }
        Ok((values.into_iter().flatten().collect(), options))
    }

    /// Gives zeros for changes that are left out, unless all are.
    fn fill_changes<'py>(&self, py: Python<'py>, values: &mut [Option<Bound<'py, PyAny>>]) {
        let pairs = || values.iter().zip(&self.signature.arguments);
        let is_given = |value: &Option<Bound<'py, PyAny>>| {
            value.as_ref().is_some_and(|value| !value.is_none())
        };
        if !pairs().any(|(value, of)| of.is_change && is_given(value)) {
            return;
        }
        for (value, of) in values.iter_mut().zip(&self.signature.arguments) {
            if of.is_change && !is_given(value) {
                // In single precision, so that the others determine the type of the results.
                let zeros = PyArrayDyn::<f32>::zeros(py, IxDyn(&of.shape), false);
                *value = Some(zeros.into_any());
            }
        }
    }

    fn misused(&self, problem: &str) -> PyErr {
        let (names, keywords) = self.parameters();
        let (name, names, keywords) = (self.signature.name, names.join(", "), keywords.join(", "));
        PyTypeError::new_err(format!("{name}({names}, *, {keywords}): {problem}"))
    }

    /// The code of a call.
    fn kernel(
        &self,
        py: Python<'_>,
        frame: Option<&str>,
        order: Option<Order>,
        single: bool,
        many: bool,
    ) -> PyResult<Arc<Kernel>> {
        let order = order.unwrap_or(self.recipe.get().default_order());
        let variant = Variant {
            frame: frame.map(str::to_owned),
            order,
            single,
            many,
        };
        let found = self.kernels.read().unwrap_or_else(PoisonError::into_inner);
        if let Some(kernel) = found.get(&variant) {
            return Ok(Arc::clone(kernel));
        }
        drop(found);
        let (recipe, name) = (self.recipe.clone_ref(py), self.signature.name);
        let asked = (recipe, name, frame, order_name(order), single, many);
        // No lock is held meanwhile: who waited for it could hold Python's.
        let (address, operations, code) = self.compile.call1(py, asked)?.extract(py)?;
        let made = Arc::new(Kernel {
            address,
            operations,
            _code: code,
        });
        let mut kernels = self.kernels.write().unwrap_or_else(PoisonError::into_inner);
        // Of two threads that compile the same, the first counts; what the other has made goes behind the lock, as Python
        // code may run then, and wait for threads that wait for the lock.
        let kernel = Arc::clone(kernels.entry(variant).or_insert_with(|| Arc::clone(&made)));
        drop(kernels);
        drop(made);
        if !many && frame.is_none() && order == self.recipe.get().default_order() {
            let usual = &self.usual[usize::from(single)];
            usual.get_or_init(|| Arc::clone(&kernel));
        }
        Ok(kernel)
    }

    /// The arrays that results are to be written to; none where nobody wants any.
    fn wanted<'py>(
        &self,
        options: &Options<'py>,
        states: &States,
        further: &[usize],
        single: bool,
    ) -> PyResult<Vec<Bound<'py, PyUntypedArray>>> {
        let Some(value) = &options.out else {
            return Ok(Vec::new());
        };
        let results = &self.signature.results;
        let values: Vec<Bound<'py, PyAny>> = match &**results {
            [_] => vec![value.clone()],
            several => {
                let values: Vec<_> = value.try_iter()?.collect::<PyResult<_>>()?;
                if values.len() != several.len() {
                    let count = several.len();
                    let message = format!("out must be {count} arrays, one a result");
                    return Err(PyValueError::new_err(message));
                }
                values
            }
        };
        let values = values.iter().zip(results);
        let arrays = values.map(|(value, result)| {
            let shape = states.shape_of(further, result);
            out(value, (&result.name, &shape), single)
        });
        arrays.collect()
    }

    fn returned<'py>(
        &self,
        py: Python<'py>,
        arrays: Vec<Bound<'py, PyUntypedArray>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let mut results = arrays.into_iter().map(number_or_array);
        match &self.tuple {
            Some(tuple) => {
                let results = results.collect::<PyResult<Vec<_>>>()?;
                tuple.bind(py).call1(PyTuple::new(py, results)?)
            }
            None => results
                .next()
                .unwrap_or_else(|| Ok(py.None().into_bound(py))),
        }
    }
}

/// A link, or several.
fn frames(value: &Bound<'_, PyAny>) -> PyResult<Frames> {
    if let Ok(frame) = value.extract::<String>() {
        return Ok(Frames::One(Some(frame)));
    }
    let several = value.extract::<Vec<String>>();
    let refused = |_| PyTypeError::new_err("frame is the name of a link, or a list of names");
    several.map(Frames::Several).map_err(refused)
}

/// The part of a result that belongs to one of several frames, which are an axis before its own.
fn part<'py>(
    room: &Bound<'py, PyUntypedArray>,
    frame: usize,
    own: usize,
) -> PyResult<Bound<'py, PyUntypedArray>> {
    let py = room.py();
    let whole = PySlice::full(py).into_any();
    let place = frame.into_pyobject(py)?.into_any();
    let mut index = vec![py.Ellipsis().into_bound(py), place];
    index.extend(std::iter::repeat_n(whole, own));
    let part = room.get_item(PyTuple::new(py, index)?)?;
    Ok(part.cast_into::<PyUntypedArray>()?)
}

/// A number where an array has no axis.
fn number_or_array(array: Bound<'_, PyUntypedArray>) -> PyResult<Bound<'_, PyAny>> {
    if array.ndim() == 0 {
        return array.get_item(PyTuple::empty(array.py()));
    }
    Ok(array.into_any())
}

/// `(..., 7)`.
fn shape(of: &Array) -> String {
    let lengths = of.shape.iter().map(|length| format!(", {length}"));
    format!("(...{})", lengths.collect::<String>())
}
