//! Functions of a page: name, operation count, error bound, layout of frames, packed code, and packed meanings of the
//! names in it.

use serde_json::{Value, json};

use crate::count::{have_signs, operation_count};
use crate::names::meanings;
use crate::packed::packed;
use crate::shown;
use crate::skeleton::Layouts;
use homogen_codegen::chain::Chain;
use homogen_codegen::function::Function;
use homogen_codegen::module::{Module, name};
use homogen_codegen::print::rust::{Item, Library, Source, each_method};
use homogen_codegen::space::{FrameId, Variable};
use homogen_codegen::wording::visible;

/// The functions of a module.
#[must_use]
pub fn functions(module: &Module, layouts: &Layouts) -> Value {
    let item = Item::named_after(&module.about.robot);
    let methods = each_method(module, &item, &Library::default());
    let signs = have_signs(&module.functions);
    let functions = module.functions.iter().zip(methods).zip(&layouts.of);
    let functions = functions.map(|((generated, method), layout)| {
        let code = Source::new("", &method.text).to_string();
        let frame = generated.frame.as_deref().unwrap_or(&module.about.tip);
        let arguments = generated.arguments(&module.spaces);
        json!({
            "name": visible(&generated.name()),
            "of": generated.frame.as_deref().map(visible),
            "sentence": sentence(&generated.functions, &module.about.base, frame),
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

/// A function that has not been expanded: its name, the link of its frame, and its sentence.
#[must_use]
pub fn announced(chain: &Chain, functions: &[Function], frame: FrameId) -> Value {
    let of_a_frame = functions.iter().all(|function| function.of_a_frame());
    let link = chain.frames.get(frame).map_or("", |frame| &*frame.name);
    let further = of_a_frame && (frame > FrameId::FIRST || !chain.has_tip);
    json!({
        "name": visible(&name(functions, further.then_some(link))),
        "of": further.then(|| visible(link)),
        "sentence": sentence(functions, &chain.report.base, link),
    })
}

/// The sentence of a function; of several together, that of each.
fn sentence(functions: &[Function], base: &str, frame: &str) -> String {
    let [base, frame] = [base, frame].map(visible);
    let sentences = functions.iter();
    let sentences: Vec<String> = sentences
        .map(|function| function.sentence(&base, &frame))
        .collect();
    sentences.join(" ")
}
