//! Arguments of a function for a robot with any number of joints.
//!
//! In: a seed, or a line of text. Out: q, q̇, q̈ and τ as vectors. A line holds every number exactly.

use homogen_codegen::expression::Input;
use homogen_codegen::space::{self, Variable};

use crate::hexadecimal;
use crate::states::Random;

/// A value for every argument; a function reads those that it has.
pub type Arguments = space::Arguments<f64>;

/// Random arguments: all entries in [−4, 4) and multiples of 2⁻²¹, exact in `f32`; changes and the wrench repeat other
/// arguments, and there are no external wrenches.
pub fn random(joints: usize, random: &mut Random) -> Arguments {
    of_lists(joints, joints, random)
}

/// The same for different numbers of coordinates and velocities; quaternions are not normalised.
pub fn of_lists(coordinates: usize, velocities: usize, random: &mut Random) -> Arguments {
    let mut arguments = Arguments::of(|variable| {
        let count = match variable {
            Variable::Q => coordinates,
            Variable::Wrench | Variable::Actions => 0,
            change if change.is_change() => 0,
            _ => velocities,
        };
        (0..count).map(|_| 4.0 * random.unit()).collect()
    });
    let repeated = arguments[Variable::Tau].iter().copied().cycle();
    arguments[Variable::Wrench] = repeated.take(6).collect();
    fill_changes(&mut arguments);
    arguments
}

/// Gives arguments without changes those that repeat other arguments, in the opposite order.
pub fn fill_changes(arguments: &mut Arguments) {
    for (change, of) in [
        (Variable::QChange, Variable::Qdd),
        (Variable::QdChange, Variable::Tau),
        (Variable::QddChange, Variable::Weights),
        (Variable::TauChange, Variable::Qd),
    ] {
        arguments[change] = arguments[of].iter().rev().copied().collect();
    }
}

/// The value of an input of a program.
///
/// # Panics
/// For a struct field, and for an index out of range.
#[must_use]
pub fn at<T: Clone>(arguments: &space::Arguments<T>, input: Input) -> T {
    match input {
        Input::Variable(variable, k) => arguments[variable][usize::from(k)].clone(),
        Input::Parameter(..) => panic!("robots with struct fields have more arguments"),
    }
}

/// `q 0x1.8p+0 … qd … qdd … tau …`, to the last bit; changes and wrenches if there are any.
#[must_use]
pub fn line(arguments: &Arguments) -> String {
    let mut words = Vec::new();
    for variable in Variable::ALL {
        let entries = &arguments[variable];
        let may_lack =
            matches!(variable, Variable::Wrench | Variable::Actions) || variable.is_change();
        if may_lack && entries.is_empty() {
            continue;
        }
        words.push(variable.name().to_owned());
        words.extend(entries.iter().map(|entry| hexadecimal::format(*entry)));
    }
    words.join(" ")
}

/// Reads the arguments of a line.
///
/// # Errors
/// For a word that is neither the name of an argument nor a number.
pub fn parse(line: &str) -> Result<Arguments, String> {
    let mut arguments = Arguments::default();
    let mut read = None;
    for word in line.split_whitespace() {
        let named = Variable::ALL.into_iter().find(|of| of.name() == word);
        if named.is_some() {
            read = named;
            continue;
        }
        let variable = read.ok_or_else(|| format!("{word:?} stands before any argument's name"))?;
        let entry = hexadecimal::parse(word);
        arguments[variable].push(entry.ok_or_else(|| format!("{word:?} is not a number"))?);
    }
    Ok(arguments)
}

#[cfg(test)]
mod tests {
    use homogen_codegen::space::Variable;

    use super::{line, parse, random};
    use crate::states::Random;

    #[test]
    fn a_line_holds_every_bit() {
        let mut arguments = random(3, &mut Random::new(1));
        arguments[Variable::Qd][1] = f64::from_bits(1);
        arguments[Variable::Tau][2] = -0.1;
        arguments[Variable::Actions].push(0.75);
        assert_eq!(parse(&line(&arguments)), Ok(arguments));
    }

    #[test]
    fn numbers_without_a_name_and_decimal_numbers_are_refused() {
        assert!(parse("0x1p+0").is_err());
        assert!(parse("q 1.0").is_err());
    }
}
