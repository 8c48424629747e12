//! A robot as it was asked for: the bytes of its description, options, fields and their values.
//!
//! In: what `homogen.load` was called with. Out: facts about the robot, the signatures of its functions, and LLVM IR. It is
//! read again for each of them, so that it can be shared between threads and processes. Files that the description names,
//! included files and meshes, stay where they are, and may not change meanwhile.

use std::fs;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::num::NonZero;
use std::path::{Path, PathBuf};
use std::sync::{PoisonError, RwLock};

use super::states::Fields;
use homogen_codegen::builder::Builder;
use homogen_codegen::chain::Chain;
use homogen_codegen::description::Given;
use homogen_codegen::description::{self, Description, inline};
use homogen_codegen::error::{Errors, Place};
use homogen_codegen::expand;
use homogen_codegen::function::Function;
use homogen_codegen::module::{DataMotion, Module};
use homogen_codegen::name::Name;
use homogen_codegen::print::arrays::{self, Order, Signature};
use homogen_codegen::print::c::own;
use homogen_codegen::print::described;
use homogen_codegen::print::llvm::{self, LlvmOptions, States, Steps};
use homogen_codegen::print::plain_python;
use homogen_codegen::real::Real;
use homogen_codegen::request::Request;
use homogen_codegen::request::setting::{SETTINGS, text};
use homogen_codegen::schedule::Program;
use homogen_codegen::space::{Kind, Space};
use pyo3::exceptions::{PyAttributeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict, PyTuple};

/// A field: its name, what it takes the place of, and its range.
type Field = (String, String, Option<(f64, f64)>);

/// The folder that paths in a description begin at, and a hash of the files that it names, once they are read.
type Folder = (PathBuf, Option<u64>);

/// A robot as it was asked for.
#[pyclass(frozen, module = "homogen._engine")]
pub struct Recipe {
    name: String,
    bytes: Vec<u8>,
    /// `None` for a description that names no other files.
    folder: Option<Folder>,
    options: Vec<(String, String)>,
    fields: Vec<Field>,
    order: Order,
    /// Maximum number of threads that share the states of a call; `None` for one a core.
    #[pyo3(get)]
    threads: Option<NonZero<usize>>,
    /// The numbers of the fields, one field after the other.
    values: RwLock<Vec<f64>>,
}

/// Operations of a sine and a cosine together; about as many as the integration of a coordinate takes.
const TURN: usize = 40;

/// Prefix of the names of compiled functions.
const PREFIX: &str = "robot_";

#[pymethods]
impl Recipe {
    #[new]
    #[expect(
        clippy::too_many_arguments,
        reason = "it is what `load` is called with"
    )]
    fn new(
        py: Python<'_>,
        name: String,
        bytes: Vec<u8>,
        folder: Option<Folder>,
        options: Vec<(String, String)>,
        fields: Vec<Field>,
        order: &str,
        threads: Option<NonZero<usize>>,
        values: Option<Vec<f64>>,
    ) -> PyResult<Self> {
        let mut recipe = Self {
            name,
            bytes,
            folder,
            options,
            fields,
            order: order_of(order)?,
            threads,
            values: RwLock::default(),
        };
        let values = if let Some(values) = values {
            values
        } else {
            let (beside, values) = py.detach(|| recipe.read().map_err(refused))?;
            let folder = recipe.folder.take().filter(|_| beside.is_some());
            recipe.folder = folder.map(|(folder, _)| (folder, beside));
            values
        };
        Ok(Self {
            values: RwLock::new(values),
            ..recipe
        })
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyTuple>> {
        let (py, of) = (slf.py(), slf.get());
        let bytes = PyBytes::new(py, &of.bytes);
        let given = (
            &of.name,
            bytes,
            of.folder.clone(),
            &of.options,
            &of.fields,
            of.order(),
            of.threads,
            Some(of.values()),
        );
        (slf.get_type(), given).into_pyobject(py)
    }

    /// The values that equal robots have in common: all but those of fields, and the number of threads.
    fn identity<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        let bytes = PyBytes::new(py, &self.bytes);
        let options = PyTuple::new(py, &self.options)?;
        let fields = PyTuple::new(py, &self.fields)?;
        let beside = self.folder.as_ref().and_then(|(_, hash)| *hash);
        (bytes, beside, options, fields, self.order()).into_pyobject(py)
    }

    /// True if results have the same bits on every processor.
    #[getter]
    fn reproducible(&self) -> bool {
        self.options.iter().any(|(key, _)| key == "reproducible")
    }

    /// The order of six numbers that turn and move.
    #[getter]
    fn order(&self) -> &'static str {
        match self.order {
            Order::LinearFirst => LINEAR_FIRST,
            Order::AngularFirst => ANGULAR_FIRST,
        }
    }

    /// The name of the description's file.
    #[getter]
    fn file(&self) -> &str {
        &self.name
    }

    /// The description.
    #[getter]
    fn bytes<'py>(&self, py: Python<'py>) -> Bound<'py, PyBytes> {
        PyBytes::new(py, &self.bytes)
    }

    /// The path of a description that names other files; `None` for one that is whole without them.
    fn path(&self) -> PyResult<Option<PathBuf>> {
        let Some((folder, _)) = &self.folder else {
            return Ok(None);
        };
        let path = folder.join(&self.name);
        if fs::read(&path).ok().as_ref() != Some(&self.bytes) {
            return Err(refused(changed(&self.name)));
        }
        // Reading compares the other files.
        self.chain(Vec::new()).map_err(refused)?;
        Ok(Some(path))
    }

    /// The options, each a keyword and a value of the command line.
    #[getter]
    fn options(&self) -> Vec<(String, String)> {
        self.options.clone()
    }

    /// The fields: name, what each takes the place of, its range.
    #[getter]
    fn fields(&self) -> Vec<Field> {
        self.fields.clone()
    }

    /// The numbers of the fields, one field after the other.
    #[getter]
    fn values(&self) -> Vec<f64> {
        // A thread that panicked has left numbers all the same.
        let values = self.values.read().unwrap_or_else(PoisonError::into_inner);
        values.clone()
    }

    /// Sets the numbers of a field, from its first place among all on.
    fn set_values(&self, first: usize, numbers: Vec<f64>) -> PyResult<()> {
        let mut values = self.values.write().unwrap_or_else(PoisonError::into_inner);
        let place = values.get_mut(first..first + numbers.len());
        let place = place.ok_or_else(|| PyValueError::new_err("a field has fewer numbers"))?;
        for (place, number) in place.iter_mut().zip(numbers) {
            *place = number;
        }
        Ok(())
    }

    /// Facts about the robot, by name.
    fn facts<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let chain = self.chain(Vec::new()).map_err(refused)?;
        let module = expand::without_functions(&chain);
        let (about, spaces) = (&module.about, &module.spaces);
        let facts = PyDict::new(py);
        let set = |name: &str, value: Bound<'py, PyAny>| facts.set_item(name, value);
        set("name", about.robot.clone().into_pyobject(py)?.into_any())?;
        set("base", about.base.clone().into_pyobject(py)?.into_any())?;
        let tip = chain.has_tip.then(|| about.tip.clone());
        set("tip", tip.into_pyobject(py)?)?;
        for list in described::names(&module) {
            set(list.name, list.names.into_pyobject(py)?)?;
        }
        for list in described::limits(&module)
            .into_iter()
            .chain(described::radii(&module))
        {
            set(list.name, list.numbers.into_pyobject(py)?)?;
        }
        set(
            "neutral",
            described::neutral(&module).numbers.into_pyobject(py)?,
        )?;
        let configurations = PyDict::new(py);
        for configuration in &module.configurations {
            configurations.set_item(&configuration.name, configuration.q.clone())?;
        }
        set("configurations", configurations.into_any())?;
        let kinds = spaces.coordinates.iter().map(|entry| match entry.kind {
            Kind::Translation => "slide",
            Kind::Quaternion => "quaternion",
            _ => "turn",
        });
        let motions = module.data.motions.iter().map(|motion| match motion {
            DataMotion::Along => "along",
            DataMotion::Mimic { .. } => "mimic",
            DataMotion::Manifold(manifold) => manifold.word(),
        });
        set("motions", motions.collect::<Vec<_>>().into_pyobject(py)?)?;
        set("kinds", kinds.collect::<Vec<_>>().into_pyobject(py)?)?;
        let names = |space| spaces.names(space).map(str::to_owned).collect::<Vec<_>>();
        set("constraints", names(Space::Constraints).into_pyobject(py)?)?;
        set("parameters", names(Space::Parameters).into_pyobject(py)?)?;
        let dropped = &chain.report.dropped;
        let links = chain.description.links.iter();
        let links = links.filter(|link| !dropped.contains(&link.name.text));
        let (links, masses): (Vec<&str>, Vec<f64>) = links
            .map(|link| {
                let mass = link.inertial.as_ref().map_or(0.0, |of| of.mass.value);
                (link.name.text.as_str(), mass)
            })
            .unzip();
        set("links", links.into_pyobject(py)?)?;
        set("masses", masses.into_pyobject(py)?)?;
        set(
            "external",
            chain.external.len().into_pyobject(py)?.into_any(),
        )?;
        set("warnings", about.located_warnings().into_pyobject(py)?)?;
        let fields = self.request(Vec::new()).map_err(refused)?.parameters;
        let entries = fields.iter().map(|field| field.target.entries());
        set("fields", entries.collect::<Vec<_>>().into_pyobject(py)?)?;
        Ok(facts)
    }

    /// The base parameters as described: the name of the parameter that leads each, and its value.
    fn base_parameters(&self) -> PyResult<(Vec<String>, Vec<f64>)> {
        let chain = self.chain(vec![vec![Function::BaseRegressor]]);
        let chain = chain.and_then(expand::identified).map_err(refused)?;
        let module = expand::without_functions(&chain);
        let names = module.spaces.names(Space::BaseParameters);
        Ok((names.map(str::to_owned).collect(), module.base_values))
    }

    /// The LLVM IR of a function, the name of its entry in there, and about how many operations a state takes. `lanes` is how
    /// many states a vector holds, 0 for a kernel of a GPU; `fused` is whether products fuse with sums.
    #[expect(clippy::too_many_arguments, reason = "each decides which code it is")]
    fn code(
        &self,
        py: Python<'_>,
        name: &str,
        frame: Option<&str>,
        order: &str,
        single: bool,
        lanes: usize,
        fused: bool,
    ) -> PyResult<(String, String, usize)> {
        let order = order_of(order)?;
        let scalar = if single { Real::F32 } else { Real::F64 };
        py.detach(|| {
            let code = self.llvm(name, frame, order, scalar, lanes, fused);
            code.map_err(refused)
        })
    }

    /// A function in plain Python, as a module that defines it by its name.
    fn plain(
        &self,
        py: Python<'_>,
        name: &str,
        frame: Option<&str>,
        order: &str,
    ) -> PyResult<String> {
        let order = order_of(order)?;
        let function = Function::from_name(name).ok_or_else(|| {
            PyAttributeError::new_err(format!("{name:?} is no function in plain Python"))
        })?;
        py.detach(|| {
            let module = self.module(function, frame, Real::F64).map_err(refused)?;
            let asked = "Made in the process.";
            Ok(plain_python::print(
                &module,
                &plain_python::PythonOptions { asked, order },
            ))
        })
    }
}

impl Recipe {
    /// The hash of the files that the description names, `None` where there are none, and the numbers of the fields.
    fn read(&self) -> Result<(Option<u64>, Vec<f64>), Errors> {
        let chain = self.chain(Vec::new())?;
        let beside = &chain.description.source.beside;
        let beside = (!beside.is_empty()).then(|| hash(beside));
        Ok((beside, chain.nominal.iter().flatten().copied().collect()))
    }

    /// The signature of a function; `None` where there is none of that name.
    pub fn signature(&self, name: &str) -> Result<Option<Signature>, Errors> {
        let function = Function::from_name(name);
        let chain = self.chain(Vec::new())?;
        let chain = match function {
            Some(Function::BaseRegressor) => expand::identified(chain)?,
            _ => chain,
        };
        let module = expand::without_functions(&chain);
        Ok(match function {
            Some(function) => {
                let frame = if chain.has_tip {
                    &module.about.tip
                } else {
                    "frame"
                };
                Some(arrays::signature(&module, function, frame))
            }
            None => arrays::steps(&module).find(|step| step.name == name),
        })
    }

    /// The order of six numbers where a call names none.
    pub const fn default_order(&self) -> Order {
        self.order
    }

    /// Maximum number of threads that share the states of a call; `None` for one a core.
    pub const fn threads(&self) -> Option<NonZero<usize>> {
        self.threads
    }

    /// The numbers of the fields, in the type of the code that reads them.
    pub fn field_values(&self, single: bool) -> Fields {
        let values = self.values.read().unwrap_or_else(PoisonError::into_inner);
        if single {
            #[expect(
                clippy::cast_possible_truncation,
                reason = "it is the type of the code"
            )]
            let singles = values.iter().map(|&value| value as f32);
            Fields::Single(singles.collect())
        } else {
            Fields::Double(values.clone())
        }
    }

    fn llvm(
        &self,
        name: &str,
        frame: Option<&str>,
        order: Order,
        scalar: Real,
        lanes: usize,
        fused: bool,
    ) -> Result<(String, String, usize), Errors> {
        let (module, steps) = if let Some(function) = Function::from_name(name) {
            let mut module = self.module(function, frame, scalar)?;
            let Module {
                functions, spaces, ..
            } = &mut module;
            for generated in functions {
                arrays::arrange(generated, spaces, order);
            }
            (module, Steps::None)
        } else {
            let mut request = self.request(Vec::new())?;
            request.scalar = scalar;
            let chain = expand::understand(&self.description(&request)?, &request)?;
            (expand::without_functions(&chain), Steps::All)
        };
        let (states, entry) = match lanes {
            0 => (States::InThreads, "kernel"),
            lanes => (States::InLanes(lanes), "arrays"),
        };
        let options = LlvmOptions {
            prefix: PREFIX,
            asked: None,
            steps,
            states,
            fused,
        };
        let entry = own(PREFIX, &format!("{name}_{entry}"));
        let operations = match module.functions.first() {
            Some(generated) => {
                let Program { steps, angles, .. } = &generated.program;
                steps.len() + TURN * angles.len()
            }
            None => TURN * module.spaces.len(Space::Coordinates),
        };
        Ok((entry, llvm::print(&module, &options), operations))
    }

    /// The robot with one function, whose results are in the order of Rust.
    fn module(
        &self,
        function: Function,
        frame: Option<&str>,
        scalar: Real,
    ) -> Result<Module, Errors> {
        let mut request = self.request(vec![vec![function]])?;
        request.frames.extend(frame.map(Name::from));
        request.scalar = scalar;
        let mut module = expand::expand(&self.description(&request)?, &request)?;
        // That of a further frame comes after that of the tip; alone it needs no name of its own.
        let last = module.functions.len().saturating_sub(1);
        module.functions.drain(..last);
        for generated in &mut module.functions {
            generated.frame = None;
        }
        Ok(module)
    }

    fn chain(&self, functions: Vec<Vec<Function>>) -> Result<Chain, Errors> {
        let request = self.request(functions)?;
        expand::understand(&self.description(&request)?, &request)
    }

    fn description(&self, request: &Request) -> Result<Description, Errors> {
        let mut errors = Errors::new();
        let given = Given::of(request, Path::new(""));
        let folder = self.folder.as_ref().map(|(folder, _)| folder.as_path());
        let (bytes, name) = (&self.bytes, &self.name);
        let read = description::read_bytes_in(bytes, name, folder, &given, None, &mut errors);
        let Some(mut description) = read else {
            return Err(errors);
        };
        let known = self.folder.as_ref().and_then(|(_, hash)| *hash);
        if known.is_some_and(|known| known != hash(&description.source.beside)) {
            return Err(changed(&self.name));
        }
        let loops = request.loops.iter().map(String::as_str);
        inline::close(&mut description, loops, &mut errors);
        errors.into_result(description)
    }

    fn request(&self, functions: Vec<Vec<Function>>) -> Result<Request, Errors> {
        let mut errors = Errors::new();
        let mut request = Request::default();
        for (key, value) in &self.options {
            let setting = SETTINGS.iter().find(|setting| setting.key == key);
            let taken = setting.map_or_else(
                || Err("there is no such option".to_owned()),
                |setting| setting.take(value, &mut request),
            );
            if let Err(mistake) = taken {
                errors.push(Place::Unknown, format!("{key}: {mistake}"));
            }
        }
        let empty = Builder::from_urdf("").request(request);
        let mut builder = empty;
        for (field, target, range) in &self.fields {
            match text::target(target) {
                Ok(target) => {
                    builder = match range {
                        Some((least, most)) => {
                            builder.parameter_within(field, target, *least..=*most)
                        }
                        None => builder.parameter(field, target),
                    };
                }
                Err(mistake) => errors.push(Place::Unknown, format!("{field}: {mistake}")),
            }
        }
        let (mut request, mistakes) = builder.into_request();
        errors.append(mistakes);
        // Without a function that takes them there are none.
        let mut named = functions.iter().flatten();
        if !functions.is_empty() && !named.any(|function| function.takes_actions()) {
            request.external.clear();
            request.external_in_frame_0 = false;
        }
        request.functions = functions;
        errors.into_result(request)
    }
}

/// Hash of the bytes of files.
fn hash(files: &[PathBuf]) -> u64 {
    let mut hasher = DefaultHasher::new();
    for file in files {
        fs::read(file).unwrap_or_default().hash(&mut hasher);
    }
    hasher.finish()
}

/// The error of a robot whose files are not those any more that it was loaded from.
fn changed(name: &str) -> Errors {
    let mut errors = Errors::new();
    let message = format!("{name} or a file that it names has changed since it was loaded");
    errors.push_with_hint(Place::Unknown, message, "load it again");
    errors
}

const LINEAR_FIRST: &str = "linear_first";
const ANGULAR_FIRST: &str = "angular_first";

/// The order of that name.
pub fn order_of(name: &str) -> PyResult<Order> {
    match name {
        LINEAR_FIRST => Ok(Order::LinearFirst),
        ANGULAR_FIRST => Ok(Order::AngularFirst),
        _ => Err(PyValueError::new_err(format!(
            "order is {LINEAR_FIRST:?} or {ANGULAR_FIRST:?}, and not {name:?}"
        ))),
    }
}

/// The name of an order in Python.
pub const fn order_name(order: Order) -> &'static str {
    match order {
        Order::LinearFirst => LINEAR_FIRST,
        Order::AngularFirst => ANGULAR_FIRST,
    }
}

/// All mistakes as one exception.
#[expect(clippy::needless_pass_by_value, reason = "as `map_err` hands it over")]
pub fn refused(errors: Errors) -> PyErr {
    let reported = errors.to_string();
    let reported = reported.trim_end();
    PyValueError::new_err(
        reported
            .strip_prefix("error: ")
            .unwrap_or(reported)
            .to_owned(),
    )
}
