//! The source of the measured program.
//!
//! In: scenes. Out: a module for every variant of every robot, as the derive would write it, and a table
//! of the calls in it; and what each costs. It never compiles.

use std::error::Error;
use std::fmt::Write;

use homogen_codegen::Function;
use homogen_codegen::expand::expand;
use homogen_codegen::print::rust::{self, Item, World};
use homogen_codegen::schedule::Price;
use homogen_codegen::space::{Space, Variable};

use crate::scene::{Scalar, Scene, Variant};
use crate::truth::told;

/// What the recursions of the runtime are called among the variants.
pub const GENERIC: &str = "generic";

/// The source of all scenes, and the price of every program in it.
pub struct Source {
    /// What `measured` includes.
    pub text: String,
    /// Scene, variant, function, price.
    pub prices: Vec<(String, &'static str, Function, Price)>,
}

/// Expands every variant of every scene.
///
/// # Errors
/// Where a robot has mistakes.
pub fn source<'a>(scenes: impl Iterator<Item = &'a Scene>) -> Result<Source, Box<dyn Error>> {
    let mut modules = String::new();
    let mut arms = String::new();
    let mut prices = Vec::new();
    let mut count = 0;
    for scene in scenes {
        let mut cases = vec![String::new(); scene.functions.len()];
        for variant in &scene.variants {
            let (description, mut request) = scene.of(variant);
            let all = 0..scene.functions.len();
            let served: Vec<usize> = all
                .filter(|k| variant.serves(scene.functions[*k]))
                .collect();
            if served.is_empty() {
                continue;
            }
            let wanted = |function| variant.instead.unwrap_or(function);
            let functions = served.iter().map(|k| vec![wanted(scene.functions[*k])]);
            request.functions = functions.collect();
            let listing = expand(&description, &request).map_err(told)?;
            let item = Item::named_after("robot");
            let methods = rust::print(&listing, &item, &World::default());
            let module = format!("m_{count}");
            count += 1;
            writeln!(
                modules,
                "#[allow(dead_code, reason = \"steps are not measured\")] mod {module} {{ {methods} }}"
            )?;
            for (generated, k) in listing.functions.iter().zip(served) {
                let (function, cases) = (scene.functions[k], &mut cases[k]);
                prices.push((scene.name.clone(), variant.name, function, generated.price));
                let robot = format!("{module}::Robot");
                for &scalar in variant.scalars {
                    let function = wanted(function);
                    cases.push_str(&case(
                        scene,
                        variant.name,
                        variant,
                        &robot,
                        function,
                        scalar,
                    ));
                }
                if scene.generic && variant.name == Variant::DEFAULT.name {
                    let chain = format!("const {{ {robot}::chain() }}");
                    for scalar in [Scalar::F64, Scalar::F32] {
                        cases.push_str(&case(scene, GENERIC, variant, &chain, function, scalar));
                    }
                }
            }
        }
        for (function, cases) in scene.functions.iter().zip(cases) {
            writeln!(
                arms,
                "(\"{}\", \"{}\") => vec![{cases}],",
                scene.name,
                function.name()
            )?;
        }
    }
    let text = format!(
        "#[allow(unused_imports, reason = \"for the functions of chains\")]\n\
         use homogen::robot::*;\n\
         fn cases(scene: &str, function: &str, truths: &Truths) -> Vec<Case> {{\n\
         match (scene, function) {{ {arms} _ => Vec::new() }}\n}}\n{modules}"
    );
    Ok(Source { text, prices })
}

/// A call of a function of a robot, as a program of `measured`.
fn case(
    scene: &Scene,
    name: &str,
    variant: &Variant,
    robot: &str,
    function: Function,
    scalar: Scalar,
) -> String {
    let argument = |argument: &Variable| {
        let name = argument.name();
        if variant.joints.is_empty() {
            return format!("&s.{name}");
        }
        let parts = variant.joints.iter().map(|k| format!("s.{name}[{k}]"));
        format!("&[{}]", parts.collect::<Vec<_>>().join(", "))
    };
    let arguments: Vec<String> = function.arguments().iter().map(argument).collect();
    let has_parameters =
        (function.result().parts()).any(|(_, part)| part.over.contains(&Space::Parameters));
    let (arguments, function) = (arguments.join(", "), function.name());
    let lengths = [Space::Coordinates, Space::Velocities].map(|space| scene.length(space));
    let ([coordinates, velocities], entries) = (lengths, variant.joints);
    let scalar = scalar.name();
    let number = variant.number.unwrap_or(scalar);
    // How long the rows of a regressor are, the trait of a chain leaves open.
    let result = if has_parameters && name == GENERIC {
        let parameters = scene.length(Space::Parameters);
        format!(" -> [[{number}; {parameters}]; {velocities}]")
    } else {
        String::new()
    };
    format!(
        "Case::of([\"{name}\", \"{scalar}\"], truths, &{entries:?}, \
         |s: &State<{number}, {coordinates}, {velocities}>|{result} {{ ({robot}).{function}({arguments}) }}),\n"
    )
}
