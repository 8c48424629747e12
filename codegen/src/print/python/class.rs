//! The extension in Rust: the class, and the functions that it calls.
//!
//! In: a [`Class`]. Out: tokens of two files. Text of a description is printed only in literals and as checked names.

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{format_ident, quote};

use super::described::{Class, Method};
use crate::print::described::neutral;
use crate::print::documentation;
use crate::space::Space;
use crate::wording::visible;

/// The functions on many states, as text, since line breaks in the macro matter.
pub(super) fn functions(class: &Class<'_>) -> String {
    let functions = class.methods.iter().map(|method| {
        let arguments = method.arguments.iter();
        let arguments: Vec<String> = arguments
            .map(|(argument, last)| format!("{argument}: {}", size(last)))
            .collect();
        let results = method.results.iter();
        let results: Vec<String> = results
            .map(|result| format!("{}: {}", result.name, size(&result.last)))
            .collect();
        let [arguments, results] = [arguments, results].map(|list| list.join(", "));
        format!("    {}({arguments}) -> ({results});\n", method.name)
    });
    format!(
        "//! The functions of the robot, each of as many states as there are: how many numbers a state has in each\n\
         //! argument and result.\n\n\
         crate::batch::functions! {{\n    crate::robot::{}:\n{}}}\n",
        class.robot,
        functions.collect::<String>()
    )
}

/// The module and the class.
pub(super) fn class(class: &Class<'_>) -> TokenStream {
    let module = format_ident!("_{}", class.import_name);
    let (name, python_module) = (&class.name, class.import_name);
    let robot = &class.robot;
    let about = doc(&class.about);
    let methods = class.methods.iter();
    let methods = methods.map(|each| method(class, each));
    let whole = whole(class);
    let attributes = attributes(class);
    quote! {
        #![doc = " The robot as a class of Python."]
        #![allow(clippy::approx_constant, reason = "limits are what a description says")]

        mod array;
        mod batch;
        mod functions;
        mod number;
        mod pack;
        mod processor;
        mod real;
        #[allow(clippy::all, reason = "generated code has one form for every robot")]
        mod robot;
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        mod turned;

        use numpy::{PyArray1, PyArray2, PyArrayMethods};
        use pyo3::prelude::*;
        use pyo3::types::{PyTuple, PyType};

        use array::{States, run};

        #about
        #[pyclass(name = #name, module = #python_module, frozen)]
        struct Robot {
            robot: robot::#robot,
        }

        #[pymethods]
        impl Robot {
            #whole
            #attributes
            #(#methods)*
        }

        #[pymodule]
        mod #module {
            #[pymodule_export]
            use super::Robot;
        }
    }
}

fn method(class: &Class<'_>, method: &Method) -> TokenStream {
    let about = doc(&method.about);
    let name = &method.name;
    let arguments = method.arguments.iter();
    let arguments: Vec<Ident> = arguments.map(|(argument, _)| name_of(argument)).collect();
    let parameters = arguments
        .iter()
        .map(|argument| quote! { #argument: &Bound<'py, PyAny> });
    let given = method.arguments.iter().zip(&arguments);
    let given = given.map(|((name, last), argument)| {
        let last = shape(last);
        quote! { (#name, #argument, #last) }
    });
    let places = (0..arguments.len()).map(Literal::usize_unsuffixed);
    let results: Vec<&Ident> = method.results.iter().map(|result| &result.name).collect();
    let (signature, out, room) = match &*method.results {
        [_] => (
            quote! { (#(#arguments,)* *, out = None) },
            Some(quote! { , out: Option<&Bound<'py, PyAny>> }),
            quote! { out },
        ),
        _ => (quote! { (#(#arguments),*) }, None, quote! { None }),
    };
    let rooms = method.results.iter().map(|result| {
        let (name, last) = (&result.name, shape(&result.last));
        quote! { let mut #name = states.room(py, #last, #room)?; }
    });
    let returned = match &method.tuple {
        None => quote! { #(#results.into_python())* },
        Some(tuple) => {
            let module = class.import_name;
            quote! {
                static TUPLE: pyo3::sync::PyOnceLock<Py<PyType>> = pyo3::sync::PyOnceLock::new();
                let tuple = TUPLE.import(py, #module, #tuple)?;
                tuple.call1((#(#results.into_python()?,)*))
            }
        }
    };
    quote! {
        #about
        #[pyo3(signature = #signature)]
        fn #name<'py>(
            &self,
            py: Python<'py>,
            #(#parameters),*
            #out
        ) -> PyResult<Bound<'py, PyAny>> {
            let states = States::of(py, [#(#given),*])?;
            #(#rooms)*
            let work = functions::#name {
                robot: &self.robot,
                states: states.count(),
                #(#arguments: states.argument(#places)?,)*
                #(#results: #results.numbers()?,)*
            };
            run(py, work);
            #returned
        }
    }
}

/// Constructor, display and pickling.
fn whole(class: &Class<'_>) -> TokenStream {
    let robot = &class.robot;
    let name = &class.name;
    if class.fields.is_empty() {
        let shown = format!("{name}()");
        return quote! {
            #[new]
            fn new() -> Self {
                Self { robot: robot::#robot }
            }

            fn __repr__(&self) -> &'static str {
                #shown
            }

            fn __reduce__<'py>(&self, py: Python<'py>) -> (Bound<'py, PyType>, Bound<'py, PyTuple>) {
                (py.get_type::<Self>(), PyTuple::empty(py))
            }
        };
    }
    let names: Vec<Ident> = class.fields.iter().map(|(name, _)| name_of(name)).collect();
    let texts: Vec<&String> = class.fields.iter().map(|(name, _)| name).collect();
    let types = class
        .fields
        .iter()
        .map(|(_, field)| match field.target.entries() {
            1 => quote! { f64 },
            entries => {
                let entries = Literal::usize_unsuffixed(entries);
                quote! { [f64; #entries] }
            }
        });
    let types: Vec<TokenStream> = types.collect();
    let fields: Vec<&Ident> = class.fields.iter().map(|(_, field)| &field.field).collect();
    let abouts = class.fields.iter();
    let abouts = abouts.map(|(_, field)| doc(&[documentation::of_field(&field.target)]));
    let shown = texts
        .iter()
        .map(|name| format!("{name}={{:?}}"))
        .collect::<Vec<_>>();
    let shown = format!("{name}({})", shown.join(", "));
    quote! {
        #[new]
        #[pyo3(signature = (#(#names),*))]
        fn new(#(#names: #types),*) -> Self {
            Self { robot: robot::#robot { #(#fields: #names),* } }
        }

        fn __repr__(&self) -> String {
            format!(#shown, #(self.robot.#fields),*)
        }

        fn __reduce__<'py>(&self, py: Python<'py>) -> (Bound<'py, PyType>, (#(#types,)*)) {
            (py.get_type::<Self>(), (#(self.robot.#fields,)*))
        }

        #(
            #abouts
            #[getter]
            fn #names(&self) -> #types {
                self.robot.#fields
            }
        )*
    }
}

/// Attributes that do not depend on a state.
fn attributes(class: &Class<'_>) -> TokenStream {
    let spaces = &class.module.spaces;
    let counts = [
        ("NQ", "Number of coordinates.", Space::Coordinates),
        ("NV", "Number of degrees of freedom.", Space::Velocities),
    ];
    let counts = counts.into_iter().map(|(name, about, space)| {
        let (name, about) = (name_of(name), doc(&[about.to_owned()]));
        let count = Literal::usize_unsuffixed(spaces.len(space));
        quote! { #about #[classattr] const #name: usize = #count; }
    });
    let names = class.names.iter().map(|(name, about, space)| {
        let (name, about) = (name_of(name), doc(&[(*about).to_owned()]));
        let (entries, count) = (
            spaces.names(*space),
            Literal::usize_unsuffixed(spaces.len(*space)),
        );
        quote! {
            #about
            #[classattr]
            fn #name(py: Python<'_>) -> PyResult<Bound<'_, PyTuple>> {
                let names: [&str; #count] = [#(#entries),*];
                PyTuple::new(py, names)
            }
        }
    });
    let limits = LIMITS.into_iter().map(|(name, about, space)| {
        let (name, about) = (name_of(name), doc(&[about.to_owned()]));
        let limits = class.limits(space);
        let count = Literal::usize_unsuffixed(limits.len());
        let rows = limits.iter().map(|limits| {
            let [least, most] = limits.map(number);
            quote! { [#least, #most] }
        });
        quote! {
            #about
            #[getter]
            fn #name<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
                let limits: [[f64; 2]; #count] = [#(#rows),*];
                PyArray1::from_slice(py, limits.as_flattened()).reshape([#count, 2])
            }
        }
    });
    let vectors = vectors(class).into_iter().map(|(name, about, values)| {
        let (name, about) = (name_of(name), doc(&[about.to_owned()]));
        let numbers = values.iter().map(|&value| number(value));
        quote! {
            #about
            #[getter]
            fn #name<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
                let numbers: &[f64] = &[#(#numbers),*];
                PyArray1::from_slice(py, numbers)
            }
        }
    });
    quote! { #(#counts)* #(#names)* #(#limits)* #(#vectors)* }
}

/// Properties with limits.
pub(super) const LIMITS: [(&str, &str, Space); 2] = [
    (
        "coordinate_limits",
        "Lower and upper limit of each entry of q in rad or m, shape (NQ, 2); infinite where the description has none.",
        Space::Coordinates,
    ),
    (
        "velocity_limits",
        "Lower and upper limit of each entry of qd in rad/s or m/s, shape (NV, 2); infinite where the description has none.",
        Space::Velocities,
    ),
];

/// Properties that are vectors.
pub(super) fn vectors(class: &Class<'_>) -> Vec<(&'static str, &'static str, Vec<f64>)> {
    let neutral = (
        "neutral",
        "The configuration at which every joint is where it was placed: zeros, and quaternions 0, 0, 0, 1.",
        neutral(class.module).numbers,
    );
    let base = class.module.base_parameters().map(|values| {
        let about = "Values of the base parameters by the description; kg, kg m, kg m².";
        ("base_parameters", about, values.to_vec())
    });
    [neutral].into_iter().chain(base).collect()
}

fn number(value: f64) -> TokenStream {
    if value.is_infinite() {
        let sign = (value < 0.0).then(|| quote! { - });
        return quote! { #sign f64::INFINITY };
    }
    let size = Literal::f64_unsuffixed(value.abs());
    let sign = value.is_sign_negative().then(|| quote! { - });
    quote! { #sign #size }
}

/// Number of entries of an array with these axes.
fn size(last: &[usize]) -> Literal {
    Literal::usize_unsuffixed(last.iter().product())
}

fn shape(last: &[usize]) -> TokenStream {
    let last = last.iter().map(|&length| Literal::usize_unsuffixed(length));
    quote! { &[#(#last),*] }
}

fn name_of(name: &str) -> Ident {
    Ident::new(name, Span::call_site())
}

/// Lines as a doc comment, which Python shows.
fn doc(lines: &[String]) -> TokenStream {
    let lines = lines.iter().map(|line| match &*visible(line) {
        "" => String::new(),
        line => format!(" {line}"),
    });
    quote! { #(#[doc = #lines])* }
}
