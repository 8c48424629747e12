//! From a program to statements.
//!
//! In: a [`Program`]. Out: one `let` for each operation, in blocks where there are many, and its
//! results as expressions. It never indexes, branches, or calls anything but sines, cosines, roots
//! and fused products.

use proc_macro2::TokenStream;
use quote::quote;

use super::dialect::Dialect;
use super::names::Names;
use super::scope::{Readable, Scope, block};
use crate::schedule::{Block, Operand, Operation, Part, Program, Step, nested};

/// The inside of a function.
pub(super) struct Body {
    /// What comes before the result.
    pub statements: TokenStream,
    /// The numbers of the result.
    pub results: Vec<TokenStream>,
}

/// Writes a program down, with names that are not in `names` yet.
pub(super) fn body(
    program: &Program,
    readable: &Readable<'_>,
    dialect: &Dialect,
    names: Names,
) -> Body {
    let (mut scope, mut statements) = Scope::open(program, readable, dialect, names);
    let [before, after] = nested(program);
    statements.extend(lets(&before, program, dialect, &mut scope));
    statements.extend(scope.bind_angles(program, dialect));
    statements.extend(lets(&after, program, dialect, &mut scope));
    let results = program.results.iter();
    Body {
        statements,
        results: results.map(|result| scope.read(*result)).collect(),
    }
}

/// A scope's statements: a `let` for each step, and one for all that a block hands on.
fn lets(parts: &[Part], program: &Program, dialect: &Dialect, scope: &mut Scope) -> TokenStream {
    let mut statements = TokenStream::new();
    for part in parts {
        statements.extend(match part {
            Part::Step(step) => statement(&program.steps[*step as usize], dialect, scope),
            Part::Block(Block { parts, handed_on }) => {
                let inside = lets(parts, program, dialect, scope);
                let names = handed_on.iter().copied().map(Operand::Step);
                block(&inside, names.map(|step| scope.read(step)))
            }
        });
    }
    statements
}

fn statement(step: &Step, dialect: &Dialect, scope: &mut Scope) -> TokenStream {
    let value = operation(step.operation, dialect, scope);
    let name = scope.bind_step(step);
    quote! { let #name = #value; }
}

fn operation(operation: Operation, dialect: &Dialect, scope: &Scope) -> TokenStream {
    let read = |operand| scope.read(operand);
    let [a, b, c] = padded(operation).map(read);
    match operation {
        Operation::Add(..) => quote! { #a + #b },
        Operation::Sub(..) => quote! { #a - #b },
        Operation::Mul(..) => quote! { #a * #b },
        Operation::Div(..) => quote! { #a / #b },
        Operation::Sqrt(_) => dialect.sqrt(&a),
        Operation::Neg(a) => scope.read_negative(a),
        Operation::MulAdd(..) => {
            let plain = quote! { #a * #b + #c };
            scope.fused(&a, &b, &c, plain)
        }
        Operation::MulSub(_, _, term) => {
            let plain = quote! { #a * #b - #c };
            scope.fused(&a, &b, &scope.read_negative(term), plain)
        }
        Operation::NegMulAdd(factor, _, _) => {
            let plain = quote! { #c - #a * #b };
            scope.fused(&scope.read_negative(factor), &b, &c, plain)
        }
    }
}

/// The operands, and zeros where there are fewer than three.
fn padded(operation: Operation) -> [Operand; 3] {
    let mut operands = operation.operands().into_iter();
    [(); 3].map(|()| operands.next().unwrap_or(Operand::Literal(0.0)))
}
