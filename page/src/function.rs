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
use homogen_codegen::print::rust::{FormattedSource, Item, Library, each_method};
use homogen_codegen::space::{FrameId, Variable};
use homogen_codegen::wording::visible;

/// The functions of a module, each with its explained code.
#[must_use]
pub fn functions(module: &Module, layouts: &Layouts) -> Value {
    let functions = counted(module, layouts).into_iter().zip(explained(module));
    let functions = functions.map(|(mut function, code)| {
        for (key, value) in code {
            function[key] = value;
        }
        function
    });
    functions.collect()
}

/// The functions of a module without their code.
#[must_use]
pub fn counted(module: &Module, layouts: &Layouts) -> Vec<Value> {
    let signs = have_signs(&module.functions);
    let functions = module.functions.iter().zip(&layouts.of);
    let functions = functions.map(|(generated, layout)| {
        let frame = generated.frame.as_deref().unwrap_or(&module.about.tip);
        let arguments = generated.arguments(&module.spaces);
        json!({
            "name": visible(&generated.name()),
            "of": generated.frame.as_deref().map(visible),
            "sentence": sentence(&generated.functions, &module.about.base, frame),
            "arguments": arguments.into_iter().map(Variable::name).collect::<Value>(),
            "count": shown(operation_count(generated, signs)),
            "layout": layout,
        })
    });
    functions.collect()
}

/// The code of each function of a module, and the meanings of the names in it. Printing takes almost as long as expanding.
pub fn explained(module: &Module) -> impl Iterator<Item = [(&'static str, Value); 3]> {
    let item = Item::named_after(&module.about.robot);
    let methods = each_method(module, &item, &Library::default()).into_iter();
    methods.map(|method| {
        let code = FormattedSource::new("", &method.text).to_string();
        [
            ("lines", json!(code.lines().count())),
            ("code", json!(packed(&code))),
            (
                "names",
                json!(packed(&meanings(&method.meanings).to_string())),
            ),
        ]
    })
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
