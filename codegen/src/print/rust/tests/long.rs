//! Text of a function with more operations, joints and fields than one scope may have.

use quote::{ToTokens, format_ident};
use syn::{Block, Expr, ImplItem, Item as SynItem, Stmt};

use super::super::{CoreFunctions, Library, print};
use super::{generated, made, module, name, pretty, revolute, with_runtime};
use crate::expression::Input;
use crate::formulation::Sines;
use crate::function::Function;
use crate::module::Module;
use crate::real::Real;
use crate::request::{Parameter, Target};
use crate::schedule::{LONGEST_SCOPE, Length, Operand, Operation, Program, Step};
use crate::space::Variable;

const JOINTS: u16 = 160;
const FIELDS: u16 = 40;
const STEPS: u32 = 1000;

/// A chain of products with every sine and with every number of every field. Each value is read twice, so that it has a
/// name.
fn program() -> Program {
    let angles = (0..JOINTS).map(|joint| Operand::Input(Input::Variable(Variable::Q, joint)));
    let numbers = (0..FIELDS).cycle().zip((0..3).cycle());
    let numbers = numbers.map(|(field, entry)| Operand::Input(Input::Parameter(field, entry)));
    let sines = (0..u32::from(JOINTS)).cycle().map(Operand::Sin);
    let factors = numbers.zip(sines).flat_map(|(number, sine)| [number, sine]);
    let steps = (0..STEPS).zip(factors).map(|(k, factor)| {
        let before = k.checked_sub(1);
        let before = before.map_or(Operand::Cos(0), Operand::Step);
        Step {
            label: None,
            operation: Operation::MulAdd(factor, before, before),
        }
    });
    Program {
        angles: angles.collect(),
        before_angles: 0,
        steps: steps.collect(),
        results: (STEPS - u32::from(JOINTS)..STEPS)
            .map(Operand::Step)
            .collect(),
        ..Program::default()
    }
}

fn long(scalar: Real) -> Module {
    let mut module = module(scalar);
    module.spaces = revolute((0..JOINTS).map(|joint| format!("joint {joint}")));
    module.parameters = (0..FIELDS)
        .map(|field| Parameter {
            field: format_ident!("center_{field}"),
            target: Target::CenterOfMassOf(name("link")),
            range: None,
        })
        .collect();
    module.functions = vec![generated(&[Function::Gravity], program())];
    module.sines = Sines::Platform;
    module
}

/// Maximum number of consecutive statements of a block and those around it.
fn deepest(block: &Block) -> usize {
    let inside = block.stmts.iter().enumerate().map(|(before, statement)| {
        let Stmt::Local(local) = statement else {
            return 0;
        };
        match local.init.as_ref().map(|init| &*init.expr) {
            Some(Expr::Block(inside)) => before + deepest(&inside.block),
            _ => 0,
        }
    });
    inside.max().unwrap_or(0).max(block.stmts.len())
}

/// The block with the equations of a method.
fn equations(block: Block) -> Block {
    let runs = block.stmts.iter().find_map(|statement| match statement {
        Stmt::Item(SynItem::Impl(item)) => item.items.iter().find_map(|item| match item {
            ImplItem::Fn(method) => Some(method.block.clone()),
            _ => None,
        }),
        _ => None,
    });
    runs.unwrap_or(block)
}

/// Blocks with the equations of all methods called `gravity`.
fn gravities(text: &str) -> Vec<Block> {
    let file = syn::parse_file(text).expect("Rust");
    let items = file.items.into_iter().filter_map(|item| match item {
        SynItem::Impl(item) if item.trait_.is_none() => Some(item.items),
        _ => None,
    });
    let methods = items.flatten().filter_map(|item| match item {
        ImplItem::Fn(method) if method.sig.ident == "gravity" => Some(equations(method.block)),
        _ => None,
    });
    methods.collect()
}

#[test]
fn scopes_are_nested_at_most_twice() {
    let core = Library::Core(CoreFunctions::default());
    for text in [
        with_runtime(&long(Real::Generic)),
        pretty(&print(&long(Real::F32), &made(), &core)),
    ] {
        let gravities = gravities(&text);
        assert_eq!(gravities.len(), 1);
        let found = deepest(&gravities[0]);
        assert!(found <= 2 * LONGEST_SCOPE, "{found} statements");
        // All steps are there.
        assert!(text.contains(&format!("let t_{STEPS} = ")), "{text}");
    }
}

/// With sections, the function calls functions within itself that have at most the allowed length, and all steps are
/// there.
#[test]
fn sections_are_inside_the_function_that_calls_them() {
    const MOST: usize = 120;
    let cut = |scalar| Module {
        length: Length::at_most(MOST),
        ..long(scalar)
    };
    let core = Library::Core(CoreFunctions::default());
    for text in [
        with_runtime(&cut(Real::Generic)),
        pretty(&print(&cut(Real::F32), &made(), &core)),
    ] {
        let gravities = gravities(&text);
        let sections = gravities[0]
            .stmts
            .iter()
            .filter_map(|statement| match statement {
                Stmt::Item(SynItem::Fn(section)) => Some(section),
                _ => None,
            });
        let sections: Vec<_> = sections.collect();
        assert!((9..20).contains(&sections.len()), "{}", sections.len());
        let mut all = 0;
        for section in &sections {
            // Apart from its steps, bindings of functions for literals and products, loads and stores.
            let text = section.block.to_token_stream().to_string();
            let steps = text
                .matches("mul_add (")
                .count()
                .max(text.matches(" * ").count());
            assert!((1..=MOST).contains(&steps), "{steps} steps");
            all += steps;
            assert_eq!(section.sig.inputs.len(), 1);
        }
        assert_eq!(all, STEPS as usize);
        assert!(text.contains("statements, called in order"), "{text}");
    }
}

/// With batches a section shows a number of the work array, which carries the proof of its instructions.
#[test]
fn sections_of_batches_carry_the_proof_of_their_instructions() {
    let text = |batch| {
        with_runtime(&Module {
            length: Length::at_most(120),
            batch,
            ..long(Real::Generic)
        })
    };
    let (with_batch, without) = (text(true), text(false));
    let sections = with_batch.matches("#[inline(never)]").count();
    assert!(sections > 0, "{with_batch}");
    let proof = "::core::option::Option::Some(self.0[0])";
    assert_eq!(with_batch.matches(proof).count(), sections);
    assert!(!without.contains(proof), "{without}");
}

/// A function within the allowed length stays the same, byte for byte.
#[test]
fn short_functions_have_no_sections() {
    let whole = Module {
        length: Length::at_most(STEPS as usize),
        ..long(Real::Generic)
    };
    assert_eq!(with_runtime(&whole), with_runtime(&long(Real::Generic)));
}
