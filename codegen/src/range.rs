//! Ranges of states: limits of coordinates, velocities and accelerations, for which error bounds hold.
//!
//! In: a chain. Out: the [`Range`] of every argument, from the limits of the description or else from defaults.

use std::f64::consts::PI;

use crate::chain::Chain;
use crate::expression::Input;
use crate::list::{Id, List};
use crate::space::{Arguments, CoordinateId, Entry, FieldId, Kind, Variable, VelocityId};

/// Range of each argument of a function.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Range {
    /// Range of each entry in its unit; empty for arguments without one.
    pub arguments: Arguments<[f64; 2]>,
    /// Range of the entries of each struct field, in their units.
    pub fields: List<FieldId, Vec<[f64; 2]>>,
    /// First of the four entries of each quaternion in q, which has length 1 up to rounding.
    pub quaternions: Vec<Input>,
}

/// Range of an entry by the description.
fn described(variable: Variable, entry: &Entry) -> Option<[f64; 2]> {
    entry.range.filter(|_| variable.has_limits())
}

impl Range {
    /// Ranges of a chain. A field has its declared range, or else one that contains zero and twice the largest entry of
    /// its described value, since its entries may be any numbers of that magnitude.
    #[must_use]
    pub fn of(chain: &Chain) -> Self {
        let spaces = chain.spaces();
        let ranges = |variable: Variable| {
            let entries = spaces.entries(variable.space()).iter();
            let ranges = entries.filter_map(|entry| {
                let otherwise = || variable.usual(entry.kind).map(|size| [-size, size]);
                described(variable, entry).or_else(otherwise)
            });
            ranges.collect()
        };
        Self {
            arguments: Arguments::of(ranges),
            fields: (chain.request.parameters.iter().zip(&chain.nominal))
                .map(|(field, nominal)| field.ranges(nominal))
                .collect(),
            quaternions: (spaces.quaternions())
                .map(|first| {
                    let first = u16::try_from(first.index()).expect("as many as coordinates");
                    Input::Variable(Variable::Q, first)
                })
                .collect(),
        }
    }

    /// Range of each coordinate, cut to angles at which sines are accurate, since some vendors write limits of 1e16.
    #[must_use]
    pub fn turns_with_digits(&self) -> Vec<[f64; 2]> {
        const FARTHEST: f64 = 1e6;
        let ends = |ends: &[f64; 2]| ends.map(|end| end.clamp(-FARTHEST, FARTHEST));
        self.arguments[Variable::Q].iter().map(ends).collect()
    }

    /// The range of a coordinate [rad or m].
    #[must_use]
    pub fn coordinate(&self, k: CoordinateId) -> [f64; 2] {
        self.arguments[Variable::Q][k.index()]
    }

    /// Range of an argument's entry for a velocity.
    #[must_use]
    pub fn of_velocity(&self, variable: Variable, k: VelocityId) -> [f64; 2] {
        self.arguments[variable][k.index()]
    }

    /// Range of one input; `None` if it is unknown.
    #[must_use]
    pub fn get(&self, input: Input) -> Option<[f64; 2]> {
        match input {
            Input::Variable(variable, k) => self.arguments.get(variable, k).copied(),
            Input::Parameter(field, k) => {
                let entries = self.fields.get(field.into());
                entries.and_then(|entries| entries.get(usize::from(k)).copied())
            }
        }
    }
}

/// Text of the ranges of some arguments and of the fields that are read:
/// ``q and q̇ within their limits, |q̈| ≤ 10 rad/s², `payload` from 0 to 3 kg``.
#[must_use]
pub fn words(chain: &Chain, arguments: &[Variable], reads: impl Fn(FieldId) -> bool) -> String {
    let mut within_limits = Vec::new();
    let mut sizes = Vec::new();
    let spaces = chain.spaces();
    for &argument in arguments {
        let letter = argument.letter();
        let entries = spaces.entries(argument.space()).iter();
        let (limited, unlimited): (Vec<&Entry>, Vec<&Entry>) =
            entries.partition(|entry| described(argument, entry).is_some());
        if !limited.is_empty() {
            within_limits.push(letter);
        }
        // Quaternions have no limits to print.
        let kinds = [Kind::Rotation, Kind::Translation].into_iter();
        let kinds = kinds.filter(|&kind| unlimited.iter().any(|entry| entry.kind == kind));
        let kinds = kinds.filter_map(|kind| {
            let size = number(argument.usual(kind)?);
            Some(match argument.unit(kind) {
                "1" => size,
                unit => format!("{size} {unit}"),
            })
        });
        let mut kinds: Vec<String> = kinds.collect();
        kinds.dedup();
        if !kinds.is_empty() {
            let or = if limited.is_empty() { "" } else { "else " };
            sizes.push(format!("{or}|{letter}| ≤ {}", kinds.join(", ")));
        }
    }
    let within_limits = match &*within_limits {
        [] => None,
        [one] => Some(format!("{one} within its limits")),
        several => Some(format!("{} within their limits", several.join(" and "))),
    };
    let fields = chain.nominal.numbered().filter(|(k, _)| reads(*k));
    let fields = fields.map(|(k, nominal)| chain.field(k).range_words(nominal));
    let words = within_limits.into_iter().chain(sizes);
    let words: Vec<String> = words.chain(fields).collect();
    words.join(", ")
}

fn number(size: f64) -> String {
    if size == PI {
        "π".to_owned()
    } else {
        size.to_string()
    }
}

#[cfg(test)]
mod tests {
    use super::{Range, words};
    use crate::chain::{self, Chain};
    use crate::description::read_text;
    use crate::error::Errors;
    use crate::expression::Input;
    use crate::request::Request;
    use crate::space::Variable;

    const ALL: [Variable; 3] = [Variable::Q, Variable::Qd, Variable::Qdd];

    /// A revolute joint with a prismatic one behind it.
    fn arm(revolute: &str, prismatic: &str) -> Chain {
        let joint = |name: &str, kind: &str, parent: &str, child: &str, limit: &str| {
            format!(
                r#"<joint name="{name}" type="{kind}"><parent link="{parent}"/>
                <child link="{child}"/><axis xyz="0 0 1"/>{limit}</joint>"#
            )
        };
        let text = [
            r#"<robot name="arm"><link name="base"/><link name="a"/><link name="b"/>"#.to_owned(),
            joint("turns", "revolute", "base", "a", revolute),
            joint("slides", "prismatic", "a", "b", prismatic),
            "</robot>".to_owned(),
        ];
        let mut errors = Errors::new();
        let description = read_text(&text.concat(), "arm.urdf", None, &mut errors);
        assert!(errors.is_empty(), "{errors}");
        let description = description.expect("no mistakes, so a description");
        chain::build(&description, &Request::default()).expect("a tree")
    }

    #[test]
    fn described_limits_are_used() {
        let limit = r#"<limit lower="-1" upper="2" velocity="3" effort="4"/>"#;
        let chain = arm(limit, limit);
        let range = Range::of(&chain);
        assert_eq!(
            range.get(Input::Variable(Variable::Q, 0)),
            Some([-1.0, 2.0])
        );
        assert_eq!(
            range.get(Input::Variable(Variable::Qd, 1)),
            Some([-3.0, 3.0])
        );
        assert_eq!(
            range.get(Input::Variable(Variable::Qdd, 0)),
            Some([-10.0, 10.0])
        );
        assert_eq!(range.get(Input::Variable(Variable::Tau, 0)), None);
        assert_eq!(words(&chain, &ALL[..1], |_| true), "q within its limits");
        assert_eq!(
            words(&chain, &ALL, |_| true),
            "q and q̇ within their limits, |q̈| ≤ 10 rad/s², 10 m/s²"
        );
    }

    #[test]
    fn default_ranges_are_documented() {
        let nothing = r#"<limit effort="4" velocity="0"/>"#;
        let chain = arm(
            r#"<limit lower="-1" upper="2" effort="4" velocity="0"/>"#,
            nothing,
        );
        let range = Range::of(&chain);
        assert_eq!(
            range.get(Input::Variable(Variable::Q, 1)),
            Some([-1.0, 1.0])
        );
        assert_eq!(
            words(&chain, &ALL, |_| true),
            "q within its limits, else |q| ≤ 1 m, |q̇| ≤ 10 rad/s, 1 m/s, |q̈| ≤ 10 rad/s², 10 m/s²"
        );
    }
}
