//! The derive: reads `#[robot(…)]` on a struct and on its fields.
//!
//! Yields an [`Item`] with the description, the request, and the numbers that fields stand for. Types of fields are
//! checked only for the count of their numbers, if the type shows it; the generated code checks the rest.

use std::path::Path;

use proc_macro2::{Span, TokenStream};
use syn::parse::ParseStream;
use syn::spanned::Spanned;
use syn::{
    Attribute, Data, DeriveInput, Expr, ExprLit, Field, Fields, Ident, Lit, Meta, Token, Type,
};

use super::inline::{self, Contents};
use super::item::Item;
use super::tokens::{self, Parsed, diagnostic, diagnostic_with_hint};
use crate::error::Errors;
use crate::request::{Parameter, Target, TargetOf};
use crate::wording::{known, quoted};

/// The keys of a field's attribute.
pub(super) fn keys() -> Vec<&'static str> {
    let targets = Target::keys().into_iter();
    targets.chain([RANGE]).collect()
}

const RANGE: &str = "range";

/// Reads a struct; paths of files are relative to `folder`.
///
/// `None` if the tokens are not a struct, enum or union.
pub fn read(tokens: TokenStream, folder: &Path, errors: &mut Errors) -> Option<Item> {
    let parsed = tokens::check_depth(&tokens);
    let input: DeriveInput = match parsed.and_then(|()| Ok(syn::parse2(tokens)?)) {
        Ok(input) => input,
        Err(diagnostic) => {
            tokens::push(errors, diagnostic);
            return None;
        }
    };
    let mut contents = Contents::default();
    let (robot, attributes): (Vec<_>, Vec<_>) = input.attrs.into_iter().partition(is_robot);
    for attribute in robot {
        arguments(
            &attribute,
            "#[robot(urdf = \"arm.urdf\")]",
            errors,
            |input, errors| {
                inline::entries(input, &mut contents, errors);
            },
        );
    }
    let parameters = match &input.data {
        Data::Struct(data) => match &data.fields {
            Fields::Named(fields) => parameters(fields.named.iter(), errors),
            Fields::Unit => Vec::new(),
            Fields::Unnamed(fields) => {
                errors.push_with_hint(
                    crate::error::Place::Token(fields.span()),
                    format!("the fields of {} have no names", input.ident),
                    "write struct Arm { payload: f64 }, or struct Arm;",
                );
                Vec::new()
            }
        },
        Data::Enum(data) => {
            refuse_kind(data.enum_token.span, &input.ident, "an enum", errors);
            Vec::new()
        }
        Data::Union(data) => {
            refuse_kind(data.union_token.span, &input.ident, "a union", errors);
            Vec::new()
        }
    };
    let own_fields = match &input.data {
        Data::Struct(data) => {
            let own = data.fields.iter();
            let is_number = |field: &&Field| matches!(field.ty, Type::Path(_) | Type::Array(_));
            let own = own.filter(is_number);
            let own = own.filter(|field| !field.attrs.iter().any(is_robot));
            own.filter_map(|field| field.ident.clone()).collect()
        }
        Data::Enum(_) | Data::Union(_) => Vec::new(),
    };
    let mut item = inline::item(contents, input.ident, folder, errors);
    item.attributes = attributes;
    item.visibility = input.vis;
    item.generics = input.generics;
    item.request.parameters = parameters;
    item.own_fields = own_fields;
    for clash in item.request.clashes() {
        errors.record(clash);
    }
    Some(item)
}

fn is_robot(attribute: &Attribute) -> bool {
    attribute.path().is_ident("robot")
}

fn refuse_kind(span: Span, ident: &Ident, kind: &str, errors: &mut Errors) {
    let problem = diagnostic(span, format!("{ident} is {kind}: a robot is a struct"));
    tokens::push(errors, problem);
}

/// Reads the arguments of an attribute.
fn arguments(
    attribute: &Attribute,
    example: &str,
    errors: &mut Errors,
    mut read: impl FnMut(ParseStream, &mut Errors),
) {
    if !matches!(attribute.meta, Meta::List(_)) {
        let message = "`robot` needs a list in parentheses";
        let hint = format!("write {example}");
        let span = attribute.meta.span();
        tokens::push(errors, diagnostic_with_hint(span, message, hint));
        return;
    }
    // Errors were reported where they were found.
    let _ = attribute.parse_args_with(|input: ParseStream| {
        read(input, errors);
        tokens::skip(input, |_| false);
        Ok(())
    });
}

/// Parameters from fields with an attribute; other fields belong to the user.
fn parameters<'f>(fields: impl Iterator<Item = &'f Field>, errors: &mut Errors) -> Vec<Parameter> {
    let mut parameters: Vec<Parameter> = Vec::new();
    for field in fields {
        let Some(ident) = &field.ident else { continue };
        let mut found: Option<Target> = None;
        let mut range: Option<FieldRange> = None;
        let mut is_clear = true;
        for attribute in field.attrs.iter().filter(|attribute| is_robot(attribute)) {
            let example = "#[robot(mass_of = \"link\")]";
            let mut read = Vec::new();
            arguments(
                attribute,
                example,
                errors,
                |input, errors| match tokens::list(input, argument) {
                    Ok(arguments) => read = arguments,
                    Err(diagnostic) => tokens::push(errors, diagnostic),
                },
            );
            for argument in read {
                let span = attribute.meta.span();
                let target = match argument {
                    FieldArgument::Range(second) => {
                        if range.is_some() {
                            let message = format!("field `{ident}` has two ranges");
                            tokens::push(errors, diagnostic(second.span, message));
                        }
                        range = Some(second);
                        continue;
                    }
                    FieldArgument::Target(target) => target,
                };
                if found.is_some() {
                    let message = format!("field `{ident}` stands for two numbers");
                    tokens::push(errors, diagnostic(span, message));
                    is_clear = false;
                } else {
                    found = Some(target);
                }
            }
        }
        if let Some(target) = found.as_ref().filter(|_| is_clear) {
            check_type(&field.ty, target, ident, errors);
        }
        let range = range.and_then(|range| range.of(found.as_ref(), ident, errors));
        parameters.extend(found.map(|target| Parameter {
            field: ident.clone(),
            target,
            range,
        }));
    }
    parameters
}

/// Reports a type that holds more or fewer numbers than its target.
fn check_type(of: &Type, target: &Target, field: &Ident, errors: &mut Errors) {
    let entries = target.entries();
    let is_as_large = match of {
        Type::Paren(inner) => return check_type(&inner.elem, target, field, errors),
        Type::Group(inner) => return check_type(&inner.elem, target, field, errors),
        Type::Array(array) => match &array.len {
            Expr::Lit(ExprLit {
                lit: Lit::Int(length),
                ..
            }) => entries > 1 && length.base10_parse().ok() == Some(entries),
            _ => entries > 1,
        },
        Type::Path(path) => {
            let is_number = ["f32", "f64"].iter().any(|word| path.path.is_ident(word));
            entries == 1 || !is_number
        }
        Type::Reference(_) | Type::Slice(_) | Type::Tuple(_) => false,
        _ => true,
    };
    if is_as_large {
        return;
    }
    let what = target.words();
    let (numbers, example) = match entries {
        1 => ("one number".to_owned(), "f64".to_owned()),
        _ => (format!("{entries} numbers"), format!("[f64; {entries}]")),
    };
    let message = format!("field `{field}` stands for {what}, which is {numbers}");
    let hint = format!("write {field}: {example}");
    tokens::push(errors, diagnostic_with_hint(of.span(), message, hint));
}

/// An argument of a field's attribute.
enum FieldArgument {
    Target(Target),
    Range(FieldRange),
}

/// `range = 3.0` or `range = 0.5..=3.0`, as written.
struct FieldRange {
    span: Span,
    least: Option<f64>,
    most: f64,
}

impl FieldRange {
    fn read(input: ParseStream, key: &Ident) -> Parsed<Self> {
        tokens::separator(input, key)?;
        let span = input.span();
        let first = tokens::number(input, "the range")?.value;
        if !input.peek(Token![..=]) {
            return Ok(Self {
                span,
                least: None,
                most: first,
            });
        }
        input.parse::<Token![..=]>()?;
        Ok(Self {
            span,
            least: Some(first),
            most: tokens::number(input, "the range")?.value,
        })
    }

    /// The ends of the range, if the target can have one.
    fn of(&self, target: Option<&Target>, field: &Ident, errors: &mut Errors) -> Option<[f64; 2]> {
        let Some(target) = target else {
            let message = format!("field `{field}` has a range and stands for no number");
            let hint = "write what it stands for beside it: #[robot(gravity, range = 12.0)]";
            tokens::push(errors, diagnostic_with_hint(self.span, message, hint));
            return None;
        };
        let ends = match self.least {
            Some(least) => [least, self.most],
            None => target.range_up_to(self.most),
        };
        if let Some([problem, hint]) = target.refusal(ends) {
            let message = format!("the range of field `{field}` {problem}");
            tokens::push(errors, diagnostic_with_hint(self.span, message, hint));
            return None;
        }
        Some(ends)
    }
}

fn argument(input: ParseStream) -> Parsed<FieldArgument> {
    let key = tokens::word(input)?;
    let text = key.to_string();
    if text == RANGE {
        return FieldRange::read(input, &key).map(FieldArgument::Range);
    }
    Ok(FieldArgument::Target(match Target::of(&text) {
        Some(TargetOf::Robot(of)) => of(),
        Some(TargetOf::Item(of)) => {
            tokens::separator(input, &key)?;
            of(tokens::name(input)?)
        }
        None => {
            let message = format!("a field cannot stand for {}", quoted(&text));
            let hint = known(&text, "keys", &keys());
            return Err(diagnostic_with_hint(key.span(), message, hint));
        }
    }))
}

#[cfg(test)]
mod tests;
