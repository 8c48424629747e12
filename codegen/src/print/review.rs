//! Material for reviewers that languages share.
//!
//! In: a [`Module`] with its [`Review`](crate::module::Review). Out: lines about the origin of inertial numbers.

use std::fmt::Write;

use crate::module::{Module, Origins, Sum};
use crate::wording::{code, list};

/// Maximum number of terms of a sum that is written out; longer sums list their links.
const TERMS: usize = 8;

/// Origins of numbers that are not in the description, a line each.
pub(super) fn origins(module: &Module) -> Vec<String> {
    let mut lines = Vec::new();
    let Some(review) = module
        .review
        .as_ref()
        .filter(|review| !review.origins.is_empty())
    else {
        return lines;
    };
    for (link, carrier) in &review.merged {
        lines.push(format!("{} has {} with it.", code(carrier), code(link)));
    }
    for Origins { functions, bodies } in &review.origins {
        let functions = functions.iter().map(|name| code(name));
        let functions: Vec<String> = functions.collect();
        let functions = list(functions.iter().map(String::as_str));
        lines.push(format!("{functions}:"));
        for (link, sums) in bodies {
            lines.push(format!("  {}", code(link)));
            lines.extend(sums.iter().map(|sum| format!("    {}", words(sum))));
        }
    }
    if !lines.is_empty() {
        let title = "Origins of inertial numbers: J, q and m of each body in its frame, after regrouping to base \
                     parameters, as sums of those of links in their own frames.";
        lines.insert(0, title.to_owned());
    }
    lines
}

/// Maximum number of link names listed.
const LINKS: usize = 40;

/// `J_xx = 0.3 = upper.J_xx + 0.16 fore.m`.
fn words(sum: &Sum) -> String {
    let Sum {
        entry,
        value,
        terms,
    } = sum;
    let mut words = format!("{entry} = {value}");
    if terms.len() > TERMS {
        let mut links: Vec<String> = Vec::new();
        for (_, name) in terms {
            let link = code(name.rsplit_once('.').map_or(name, |(link, _)| link));
            if !links.contains(&link) {
                links.push(link);
            }
        }
        let links = match links.len() {
            0..=LINKS => list(links.iter().map(String::as_str)),
            many => format!("{many} links"),
        };
        return format!("{words}, of {} parameters of {links}", terms.len());
    }
    for (k, (factor, name)) in terms.iter().enumerate() {
        words.push_str(match (k, *factor < 0.0) {
            (0, false) => " = ",
            (0, true) => " = −",
            (_, false) => " + ",
            (_, true) => " − ",
        });
        let size = factor.abs();
        if size != 1.0 {
            // Writing to a string cannot fail.
            let _ = write!(words, "{size} ");
        }
        words.push_str(&code(name));
    }
    words
}

/// Items between a start and an end, as many on a line as fit; all lines but the first begin with `indent`.
pub(super) fn filled((start, indent): (&str, &str), items: &[String], end: &str) -> String {
    const WIDTH: usize = 92;
    let mut text = start.to_owned();
    let mut column = text.chars().count();
    for (k, item) in items.iter().enumerate() {
        let between = if k + 1 == items.len() { end } else { "," };
        let width = item.chars().count() + between.len();
        if k > 0 && column + 1 + width > WIDTH {
            text.push('\n');
            text.push_str(indent);
            column = indent.len();
        } else if k > 0 {
            text.push(' ');
            column += 1;
        }
        text.push_str(item);
        text.push_str(between);
        column += width;
    }
    if items.is_empty() {
        text.push_str(end);
    }
    text
}
