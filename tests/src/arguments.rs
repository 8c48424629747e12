//! The arguments of a function of a robot with any number of joints.
//!
//! In: a seed, or a line of text. Out: q, q̇, q̈ and τ as vectors, which programs read entry by
//! entry; the line holds every number exactly. Nothing here knows a robot.

use std::fmt;
use std::str::FromStr;

use homogen_codegen::expression::Input;
use homogen_codegen::space::Variable;

use crate::hexadecimal;
use crate::states::Random;

/// One value of every argument; a function reads those that it has.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Arguments {
    /// Coordinates [rad or m].
    pub q: Vec<f64>,
    /// Their rates.
    pub qd: Vec<f64>,
    /// Their second rates.
    pub qdd: Vec<f64>,
    /// Torques and forces \[N m or N\].
    pub tau: Vec<f64>,
    /// Of each action from outside c and f \[N m, N\].
    pub actions: Vec<f64>,
}

impl Arguments {
    /// All entries in [−4, 4) and multiples of 2⁻²¹, which `f32` holds exactly.
    pub fn random(joints: usize, random: &mut Random) -> Self {
        Self::of_lists(joints, joints, random)
    }

    /// The same where there are not as many velocities as coordinates; quaternions are of any length.
    pub fn of_lists(coordinates: usize, velocities: usize, random: &mut Random) -> Self {
        let mut vector = |count| (0..count).map(|_| 4.0 * random.unit()).collect();
        Self {
            q: vector(coordinates),
            qd: vector(velocities),
            qdd: vector(velocities),
            tau: vector(velocities),
            actions: Vec::new(),
        }
    }

    /// What a program reads under a name.
    ///
    /// # Panics
    /// For a struct field, and for a joint that is not there.
    #[must_use]
    pub fn at(&self, input: Input) -> f64 {
        match input {
            Input::Variable(variable, k) => self.of(variable)[usize::from(k)],
            Input::Parameter(..) => panic!("robots with struct fields have more arguments"),
        }
    }

    /// The entries of one of them.
    ///
    /// # Panics
    /// For an argument that no function here has.
    #[must_use]
    pub fn of(&self, variable: Variable) -> &[f64] {
        match variable {
            Variable::Q => &self.q,
            Variable::Qd => &self.qd,
            Variable::Qdd => &self.qdd,
            Variable::Tau => &self.tau,
            Variable::Actions => &self.actions,
            other => panic!("no function has {other:?}"),
        }
    }

    /// Those that every robot has, and actions where there are any.
    fn vectors(&self) -> impl Iterator<Item = (&'static str, &Vec<f64>)> {
        let actions = (!self.actions.is_empty()).then_some(("actions", &self.actions));
        let others = [
            ("q", &self.q),
            ("qd", &self.qd),
            ("qdd", &self.qdd),
            ("tau", &self.tau),
        ];
        others.into_iter().chain(actions)
    }
}

/// `q 0x1.8p+0 … qd … qdd … tau …`, to the last bit.
impl fmt::Display for Arguments {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, (name, entries)) in self.vectors().enumerate() {
            let blank = if index == 0 { "" } else { " " };
            write!(out, "{blank}{name}")?;
            for entry in entries {
                write!(out, " {}", hexadecimal::format(*entry))?;
            }
        }
        Ok(())
    }
}

impl FromStr for Arguments {
    type Err = String;

    fn from_str(line: &str) -> Result<Self, String> {
        let mut arguments = Self::default();
        let mut vector = None;
        for word in line.split_whitespace() {
            vector = match word {
                "q" => Some(&mut arguments.q),
                "qd" => Some(&mut arguments.qd),
                "qdd" => Some(&mut arguments.qdd),
                "tau" => Some(&mut arguments.tau),
                "actions" => Some(&mut arguments.actions),
                _ => {
                    let entries = vector.ok_or_else(|| format!("{word:?} belongs to nothing"))?;
                    let entry = hexadecimal::parse(word);
                    entries.push(entry.ok_or_else(|| format!("{word:?} is no number"))?);
                    Some(entries)
                }
            };
        }
        Ok(arguments)
    }
}

#[cfg(test)]
mod tests {
    use super::Arguments;
    use crate::states::Random;

    #[test]
    fn a_line_says_everything() {
        let mut arguments = Arguments::random(3, &mut Random::new(1));
        arguments.qd[1] = f64::from_bits(1);
        arguments.tau[2] = -0.1;
        arguments.actions.push(0.75);
        assert_eq!(arguments.to_string().parse(), Ok(arguments));
    }

    #[test]
    fn what_is_no_line_is_refused() {
        assert!("0x1p+0".parse::<Arguments>().is_err());
        assert!("q 1.0".parse::<Arguments>().is_err());
    }
}
