//! Functions of a page: name, operation count, error bound, layout of frames, packed code, and packed meanings of the
//! names in it.

use serde_json::{Value, json};

use super::names::meanings;
use super::packed::packed;
use super::shown;
use super::skeleton::Layouts;
use crate::count::{have_signs, operation_count};
use homogen_codegen::module::{GeneratedFunction, Module};
use homogen_codegen::print::rust::{Item, Library, Source, each_method};
use homogen_codegen::space::Variable;
use homogen_codegen::wording::visible;

/// The functions of a module.
pub(super) fn functions(module: &Module, layouts: &Layouts) -> Value {
    let item = Item::named_after(&module.about.robot);
    let methods = each_method(module, &item, &Library::default());
    let signs = have_signs(&module.functions);
    let functions = module.functions.iter().zip(methods).zip(&layouts.of);
    let functions = functions.map(|((generated, method), layout)| {
        let code = Source::new("", &method.text).to_string();
        let arguments = generated.arguments(&module.spaces);
        json!({
            "name": visible(&generated.name()),
            "of": generated.frame.as_deref().map(visible),
            "sentence": sentence(module, generated),
            "arguments": arguments.into_iter().map(Variable::name).collect::<Value>(),
            "count": shown(operation_count(generated, signs)),
            "layout": layout,
            "lines": code.lines().count(),
            "code": packed(&code),
            "names": packed(&meanings(&method.meanings).to_string()),
        })
    });
    functions.collect()
}

/// The sentence of a function; of several together, that of each.
fn sentence(module: &Module, generated: &GeneratedFunction) -> String {
    let about = &module.about;
    let frame = generated.frame.as_deref().unwrap_or(&about.tip);
    let [base, frame] = [&about.base, frame].map(visible);
    let functions = generated.functions.iter();
    let sentences: Vec<String> = functions
        .map(|function| function.sentence(&base, &frame))
        .collect();
    sentences.join(" ")
}
