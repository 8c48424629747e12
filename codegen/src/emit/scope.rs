//! What the operands of a program are called.
//!
//! In: a program, the arguments and fields it can read. Out: the statements that bind what it does
//! read, and from then on a name for each operand. It never binds what nobody reads.

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::{Ident, Span, TokenStream};
use quote::{ToTokens, format_ident, quote, quote_spanned};
use syn::ext::IdentExt;

use super::dialect::Dialect;
use super::literals::Numerals;
use super::names::Names;
use crate::expression::Input;
use crate::request::Parameter;
use crate::schedule::{LONGEST_SCOPE, Operand, Operation, Program, Step};
use crate::space::{Spaces, Variable};

/// What a function can read.
pub(super) struct Readable<'a> {
    /// Its arguments.
    pub arguments: &'a [Variable],
    /// What they are over.
    pub spaces: &'a Spaces,
    /// The fields of `self`.
    pub parameters: &'a [Parameter],
}

/// How many fields are loaded in one scope; three numbers of a field take up to four `let`s.
const FIELDS: usize = LONGEST_SCOPE / 4;

/// How a field is loaded.
struct Load {
    /// The names of its numbers, as far as they are read.
    names: Vec<Ident>,
    /// What binds them.
    statements: TokenStream,
}

/// The names of operands that are bound so far.
pub(super) struct Scope {
    names: Names,
    numerals: Numerals,
    fused: Option<Ident>,
    inputs: BTreeMap<Input, Ident>,
    sines: Vec<Option<Ident>>,
    cosines: Vec<Option<Ident>>,
    steps: Vec<Ident>,
    /// The joints whose coordinates a step is the sum of.
    sums: Vec<Option<Vec<u16>>>,
    unnamed: usize,
}

impl Scope {
    /// A scope in which everything that `program` reads from outside is bound, and the statements
    /// that bind it.
    pub fn open(
        program: &Program,
        readable: &Readable<'_>,
        dialect: &Dialect,
        mut names: Names,
    ) -> (Self, TokenStream) {
        for argument in readable.arguments {
            names.take(argument.name());
        }
        let (numerals, constant) = dialect.numerals(&mut names);
        let (fused, mul_add) = dialect.fused(&mut names);
        let mut scope = Self {
            names,
            numerals,
            fused,
            inputs: BTreeMap::new(),
            sines: Vec::new(),
            cosines: Vec::new(),
            steps: Vec::with_capacity(program.steps.len()),
            sums: Vec::with_capacity(program.steps.len()),
            unnamed: 0,
        };
        let used: BTreeSet<Input> = program.operands().filter_map(input).collect();
        let mut statements = TokenStream::new();
        let is_numeral = |operand| {
            matches!(
                operand,
                Operand::Literal(_) | Operand::Input(Input::Parameter(..))
            )
        };
        if program.operands().any(is_numeral) {
            statements.extend(constant);
        }
        if program.steps.iter().any(|step| step.operation.is_fused()) {
            statements.extend(mul_add);
        }
        for argument in readable.arguments {
            statements.extend(scope.unpack(*argument, readable.spaces, &used));
        }
        let parameters = (0_u16..).zip(readable.parameters);
        let loads = parameters.map(|(index, field)| scope.load(index, field, &used, dialect));
        let loads: Vec<_> = loads.filter(|load| !load.names.is_empty()).collect();
        if loads.len() <= FIELDS {
            statements.extend(loads.into_iter().map(|load| load.statements));
        } else {
            statements.extend(loads.chunks(FIELDS).map(|loads| {
                let inside = loads.iter().map(|load| load.statements.clone());
                let names = loads.iter().flat_map(|load| &load.names);
                block(&inside.collect(), names)
            }));
        }
        (scope, statements)
    }

    /// An operand as an expression that binds tighter than any infix operator.
    pub fn read(&self, operand: Operand) -> TokenStream {
        let ident = match operand {
            Operand::Literal(value) => return self.numerals.write(value),
            Operand::Input(input) => self.inputs.get(&input),
            Operand::Sin(angle) => self.sines.get(angle as usize).and_then(Option::as_ref),
            Operand::Cos(angle) => self.cosines.get(angle as usize).and_then(Option::as_ref),
            Operand::Step(step) => self.steps.get(step as usize),
        };
        ident.map_or_else(
            // A program that reads what it has not computed is a mistake of an earlier stage.
            || quote! { ::core::compile_error!("homogen: an operand before its step") },
            |ident| quote! { #ident },
        )
    }

    /// The same with the opposite sign.
    pub fn read_negative(&self, operand: Operand) -> TokenStream {
        if let Operand::Literal(value) = operand {
            return self.numerals.write(-value);
        }
        let positive = self.read(operand);
        quote! { -#positive }
    }

    /// a b + c, rounded once where the target can; `plain` where there is no such function.
    pub fn fused(
        &self,
        a: &TokenStream,
        b: &TokenStream,
        c: &TokenStream,
        plain: TokenStream,
    ) -> TokenStream {
        match &self.fused {
            Some(mul_add) => quote! { #mul_add(#a, #b, #c) },
            None => plain,
        }
    }

    /// Names the result of the next step.
    pub fn bind_step(&mut self, step: &Step) -> Ident {
        let sum = self.sum(step.operation);
        let wish = match (&step.label, &sum) {
            (Some(label), _) => label.clone(),
            (None, Some(joints)) => format!("q_{}", numbers(joints)),
            (None, None) => {
                self.unnamed += 1;
                format!("t_{}", self.unnamed)
            }
        };
        let name = self.names.fresh(&wish);
        self.sums.push(sum);
        self.steps.push(name.clone());
        name
    }

    /// Names the sines and cosines and binds them all: of a joint's own angle after the joint, of
    /// a sum of angles after the joints. Those that nobody reads are `_`.
    pub fn bind_angles(&mut self, program: &Program, dialect: &Dialect) -> TokenStream {
        let read: Vec<_> = program.operands().collect();
        let mut values = Vec::new();
        for (index, angle) in (0_u32..).zip(&program.angles) {
            let subject = self.subject(*angle);
            let mut bind = |letter: char, operand: Operand| {
                let name = || self.names.fresh(&format!("{letter}_{subject}"));
                read.contains(&operand).then(name)
            };
            let sine = bind('s', Operand::Sin(index));
            let cosine = bind('c', Operand::Cos(index));
            values.push(self.read(*angle));
            self.sines.push(sine);
            self.cosines.push(cosine);
        }
        let patterns = |names: &[Option<Ident>]| -> Vec<_> {
            names.iter().map(Option::as_ref).map(pattern).collect()
        };
        let (sines, cosines) = (patterns(&self.sines), patterns(&self.cosines));
        dialect.sines_and_cosines(&sines, &cosines, &values, &mut self.names)
    }

    /// What an angle is of: `2`, `2_3` for q₂ + q₃, or the name of a step.
    fn subject(&self, angle: Operand) -> String {
        match (self.joints_of(angle), angle) {
            (Some(joints), _) => numbers(&joints),
            (None, Operand::Step(step)) => {
                let name = self.steps.get(step as usize);
                name.map_or_else(String::new, Ident::to_string)
            }
            (None, _) => "a".to_owned(),
        }
    }

    /// The joints that an operation sums the coordinates of, if it does nothing else.
    fn sum(&self, operation: Operation) -> Option<Vec<u16>> {
        let Operation::Add(a, b) = operation else {
            return None;
        };
        let mut joints = self.joints_of(a)?;
        joints.extend(self.joints_of(b)?);
        joints.sort_unstable();
        Some(joints)
    }

    fn joints_of(&self, operand: Operand) -> Option<Vec<u16>> {
        match operand {
            Operand::Input(Input::Variable(Variable::Q, joint)) => Some(vec![joint]),
            Operand::Step(step) => self.sums.get(step as usize)?.clone(),
            _ => None,
        }
    }

    /// `let [q_1, _, q_3] = *q;`, or `let _ = q;` where no entry is read.
    fn unpack(
        &mut self,
        argument: Variable,
        spaces: &Spaces,
        used: &BTreeSet<Input>,
    ) -> TokenStream {
        let array = format_ident!("{}", argument.name());
        let entries = (0_u16..).zip(spaces.entries(argument.space()));
        let entries = entries.map(|(k, _)| {
            let wish = format!("{}_{}", argument.name(), k + 1);
            self.bind_input(Input::Variable(argument, k), &wish, used)
        });
        let entries: Vec<_> = entries.collect();
        if entries.iter().all(Option::is_none) {
            return quote! { let _ = #array; };
        }
        let entries = entries.iter().map(Option::as_ref).map(pattern);
        quote! { let [#(#entries),*] = *#array; }
    }

    /// `let payload = self.payload;` or `let [gravity_x, _, gravity_z] = self.gravity;`, converted.
    fn load(
        &mut self,
        index: u16,
        parameter: &Parameter,
        used: &BTreeSet<Input>,
        dialect: &Dialect,
    ) -> Load {
        let field = &parameter.field;
        let name = field.unraw().to_string();
        let mut bind =
            |entry, wish: &str| self.bind_input(Input::Parameter(index, entry), wish, used);
        let bound = if parameter.target.entries() == 1 {
            vec![bind(0, &name)]
        } else {
            let axes = (0_u16..).zip(["x", "y", "z"]);
            axes.map(|(entry, axis)| bind(entry, &format!("{name}_{axis}")))
                .collect()
        };
        // The compiler's complaint about a field of another type belongs under the field.
        let span = field.span().resolved_at(Span::call_site());
        let value = quote_spanned! {span=> self.#field };
        let statements = if let [Some(name)] = &*bound {
            let value = dialect.converted(&self.numerals, &value, span);
            quote! { let #name = #value; }
        } else {
            let patterns = bound.iter().map(Option::as_ref).map(pattern);
            let conversions = bound.iter().flatten().filter_map(|name| {
                let value = quote! { #name };
                let converted = dialect.converted(&self.numerals, &value, span);
                // Without a conversion the pattern has said it all.
                let needed = converted.to_string() != value.to_string();
                needed.then(|| quote! { let #name = #converted; })
            });
            quote! { let [#(#patterns),*] = #value; #(#conversions)* }
        };
        Load {
            names: bound.into_iter().flatten().collect(),
            statements,
        }
    }

    fn bind_input(&mut self, input: Input, wish: &str, used: &BTreeSet<Input>) -> Option<Ident> {
        let name = used.contains(&input).then(|| self.names.fresh(wish))?;
        self.inputs.insert(input, name.clone());
        Some(name)
    }
}

/// `let [a, b] = { …; [a, b] };`: statements in a scope of their own, and what is left of them.
pub(super) fn block(
    inside: &TokenStream,
    names: impl Iterator<Item = impl ToTokens>,
) -> TokenStream {
    let names: Vec<_> = names.collect();
    quote! { let [#(#names),*] = { #inside [#(#names),*] }; }
}

fn input(operand: Operand) -> Option<Input> {
    match operand {
        Operand::Input(input) => Some(input),
        _ => None,
    }
}

/// What stands in a pattern for a value that may have no name.
fn pattern(name: Option<&Ident>) -> TokenStream {
    name.map_or_else(|| quote! { _ }, |name| quote! { #name })
}

/// Joints as the paper counts them, from 1.
fn numbers(joints: &[u16]) -> String {
    let numbers: Vec<_> = joints.iter().map(|joint| (joint + 1).to_string()).collect();
    numbers.join("_")
}
