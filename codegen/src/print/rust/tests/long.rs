//! A function with more operations, joints and fields than one scope may have, as text.

use quote::format_ident;
use syn::{Block, Expr, ImplItem, Item as SynItem, Stmt};

use super::super::{Library, World, print};
use super::{listed, listing, made, name, pretty, turning, with_runtime};
use crate::expression::Input;
use crate::formulation::Sines;
use crate::function::Function;
use crate::print::Listing;
use crate::real::Real;
use crate::request::{Parameter, Target};
use crate::schedule::{LONGEST_SCOPE, Operand, Operation, Program, Step};
use crate::space::Variable;

const JOINTS: u16 = 160;
const FIELDS: u16 = 40;
const STEPS: u32 = 1000;

/// Sums of every sine times every number of every field.
fn program() -> Program {
    let angles = (0..JOINTS).map(|joint| Operand::Input(Input::Variable(Variable::Q, joint)));
    let steps = (0..STEPS).zip((0..FIELDS).cycle()).map(|(k, field)| {
        let entry = u16::try_from(k % 3).expect("an axis");
        let number = Operand::Input(Input::Parameter(field, entry));
        let before = k.checked_sub(1);
        Step {
            label: None,
            operation: Operation::MulAdd(
                number,
                Operand::Sin(k % u32::from(JOINTS)),
                before.map_or(Operand::Cos(0), Operand::Step),
            ),
        }
    });
    Program {
        angles: angles.collect(),
        before_angles: 0,
        steps: steps.collect(),
        results: (STEPS - u32::from(JOINTS)..STEPS)
            .map(Operand::Step)
            .collect(),
    }
}

fn long(scalar: Real) -> Listing {
    let mut listing = listing(scalar);
    listing.spaces = turning((0..JOINTS).map(|joint| format!("joint {joint}")));
    listing.parameters = (0..FIELDS)
        .map(|field| Parameter {
            field: format_ident!("center_{field}"),
            target: Target::CenterOfMassOf(name("link")),
            range: None,
        })
        .collect();
    listing.functions = vec![listed(&[Function::Gravity], program())];
    listing.sines = Sines::Platform;
    listing
}

/// How many statements of a block and of those around it come one after the other at most.
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

/// The blocks of all methods called `gravity`.
fn gravities(text: &str) -> Vec<Block> {
    let file = syn::parse_file(text).expect("Rust");
    let items = file.items.into_iter().filter_map(|item| match item {
        SynItem::Impl(item) if item.trait_.is_none() => Some(item.items),
        _ => None,
    });
    let methods = items.flatten().filter_map(|item| match item {
        ImplItem::Fn(method) if method.sig.ident == "gravity" => Some(method.block),
        _ => None,
    });
    methods.collect()
}

#[test]
fn nothing_is_below_more_than_two_scopes() {
    let core = World::Core(Library::default());
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
