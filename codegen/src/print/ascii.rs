//! ASCII text.
//!
//! In: the text of a file. Out: the same with letters and symbols spelt out, `θ` as theta and `q̈` as `q_ddot`. A
//! character without a spelling, in names of users, becomes `\u{6a5f}`, which strings of Rust read back.

use std::fmt::Write;

use crate::module::Module;
use crate::print::rust::names;
use crate::request::Parameter;

/// Spellings of letters and symbols.
const SPELT: [(char, &str); 51] = [
    ('α', "alpha"),
    ('β', "beta"),
    ('γ', "gamma"),
    ('Γ', "Gamma"),
    ('δ', "delta"),
    ('Δ', "Delta"),
    ('ε', "epsilon"),
    ('θ', "theta"),
    ('λ', "lambda"),
    ('μ', "mu"),
    ('π', "pi"),
    ('ρ', "rho"),
    ('Σ', "sum"),
    ('τ', "tau"),
    ('φ', "phi"),
    ('Φ', "Phi"),
    ('ω', "omega"),
    ('Ω', "Omega"),
    ('∂', "d"),
    ('∫', "integral "),
    ('√', "sqrt "),
    ('∞', "infinity"),
    ('½', "1/2"),
    ('·', " "),
    ('×', "x"),
    ('−', "-"),
    ('–', "-"),
    ('—', "-"),
    ('…', "..."),
    ('≤', "<="),
    ('≥', ">="),
    ('≠', "/="),
    ('≈', "~"),
    ('±', "+-"),
    ('→', "->"),
    ('∈', "in"),
    ('“', "\""),
    ('”', "\""),
    ('‘', "'"),
    ('’', "'"),
    ('ä', "ae"),
    ('ö', "oe"),
    ('ü', "ue"),
    ('é', "e"),
    ('è', "e"),
    ('\u{307}', "_dot"),
    ('\u{308}', "_ddot"),
    ('\u{332}', ""),
    ('°', " degrees"),
    ('ẋ', "x_dot"),
    ('Ṁ', "M_dot"),
];

/// Subscripts and superscripts, each before its ASCII character.
const BELOW: &str = "₀0₁1₂2₃3₄4₅5₆6₇7₈8₉9₊+₋-₍(₎)ₐaₑeᵢiⱼjₖkₗlₘmₙnₚpᵣrₛsₜtᵥvₓx";
const ABOVE: &str = "⁰0¹1²2³3⁴4⁵5⁶6⁷7⁸8⁹9⁺+⁻-ᵀTᵗt";

fn at_a_height(letter: char) -> Option<(char, char)> {
    let find = |list: &str| {
        let mut letters = list.chars();
        while let (Some(small), Some(plain)) = (letters.next(), letters.next()) {
            if small == letter {
                return Some(plain);
            }
        }
        None
    };
    let below = find(BELOW).map(|plain| ('_', plain));
    below.or_else(|| find(ABOVE).map(|plain| ('^', plain)))
}

/// The text in ASCII.
pub(crate) fn spelt(text: &str) -> String {
    let mut spelt = String::with_capacity(text.len());
    let mut height = None;
    for letter in text.chars() {
        let before = height.take();
        if letter.is_ascii() {
            spelt.push(letter);
        } else if let Some((sign, plain)) = at_a_height(letter) {
            // `₀₁` is `_01`.
            if before != Some(sign) {
                spelt.push(sign);
            }
            spelt.push(plain);
            height = Some(sign);
        } else if let Some((_, word)) = SPELT.iter().find(|(of, _)| *of == letter) {
            spelt.push_str(word);
        } else {
            // Writing to a string cannot fail.
            let _ = write!(spelt, "\\u{{{:x}}}", u32::from(letter));
        }
    }
    spelt
}

/// Names in code that can't be spelt in ASCII, since user code refers to them: functions and fields.
pub(crate) fn beyond(module: &Module) -> Vec<String> {
    let methods = names::of_methods(module).into_iter();
    let methods = methods.map(|name| name.to_string());
    let fields = module.parameters.iter().map(Parameter::name);
    methods
        .chain(fields)
        .filter(|name| !name.is_ascii())
        .collect()
}

#[cfg(test)]
mod tests {
    use super::spelt;

    #[test]
    fn letters_and_signs_are_spelt() {
        for (text, ascii) in [
            (
                "q̇ in rad/s², q̈ in rad/s²",
                "q_dot in rad/s^2, q_ddot in rad/s^2",
            ),
            ("Pose M₀,ₜ of W₀ₜ₍₀₎", "Pose M_0,_t of W_0t(0)"),
            ("−Σ Tr(H_g J) ½ ≤ 3·10⁻³³", "-sum Tr(H_g J) 1/2 <= 3 10^-33"),
            ("`機器` and \\", "`\\u{6a5f}\\u{5668}` and \\"),
            ("J_xx = 0.3 − 2 τ", "J_xx = 0.3 - 2 tau"),
        ] {
            assert_eq!(spelt(text), ascii);
        }
    }
}
