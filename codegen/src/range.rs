//! The states that a robot is meant for: how far its joints go, and how fast.
//!
//! In: a chain. Out: a [`Range`] of every argument, from the limits that are described and, where
//! there are none, from the defaults below. It never looks at what is computed of a state.

use std::f64::consts::PI;

use crate::chain::Chain;
use crate::expression::Input;
use crate::list::List;
use crate::space::{CoordinateId, Entry, FieldId, Kind, Spaces, Variable, VelocityId};

/// The least and the greatest that each argument of a function can be.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Range {
    /// Of each coordinate [rad or m].
    pub q: List<CoordinateId, [f64; 2]>,
    /// Of each rate [rad/s or m/s].
    pub qd: List<VelocityId, [f64; 2]>,
    /// Of each second rate [rad/s² or m/s²].
    pub qdd: List<VelocityId, [f64; 2]>,
    /// Of the entries of each action from outside \[N m, N\].
    pub actions: Vec<[f64; 2]>,
    /// Of the entries of each struct field, in the units of what it stands for.
    pub fields: List<FieldId, Vec<[f64; 2]>>,
}

/// How large an entry is of which no description tells: coordinates go π rad or 1 m to both sides, with
/// 10 rad/s or 1 m/s, and 10 rad/s² or 10 m/s²; the surroundings act with 100 N m and 100 N. Nothing is said
/// of forces of joints.
const fn default(variable: Variable, kind: Kind) -> Option<f64> {
    match (variable, kind) {
        (Variable::Q, Kind::Turn) => Some(PI),
        (Variable::Q, Kind::Slide | Kind::Quaternion) | (Variable::Qd, Kind::Slide) => Some(1.0),
        (Variable::Tau, _) | (_, Kind::Moment(_) | Kind::Drive { .. }) => None,
        (Variable::Qd | Variable::Qdd, _) => Some(10.0),
        (Variable::Actions, _) => Some(100.0),
    }
}

/// What the entry of a variable is described to stay in; accelerations never are.
const fn described(variable: Variable, entry: &Entry) -> Option<[f64; 2]> {
    match variable {
        Variable::Q | Variable::Qd => entry.range,
        Variable::Qdd | Variable::Tau | Variable::Actions => None,
    }
}

/// The range of each entry of a variable; of none where nothing is said.
fn ranges<R: FromIterator<[f64; 2]>>(spaces: &Spaces, variable: Variable) -> R {
    let entries = spaces.entries(variable.space()).iter();
    let ranges = entries.filter_map(|entry| {
        let otherwise = || default(variable, entry.kind).map(|size| [-size, size]);
        described(variable, entry).or_else(otherwise)
    });
    ranges.collect()
}

impl Range {
    /// The states of a chain. A field has the range that is declared for it, or else one that holds
    /// zero and twice the largest entry that is described in its place: its entries may be anything
    /// that has this size.
    #[must_use]
    pub fn of(chain: &Chain) -> Self {
        let spaces = chain.spaces();
        Self {
            q: ranges(spaces, Variable::Q),
            qd: ranges(spaces, Variable::Qd),
            qdd: ranges(spaces, Variable::Qdd),
            actions: ranges(spaces, Variable::Actions),
            fields: (chain.parameters.iter().zip(&chain.nominal))
                .map(|(field, nominal)| field.ranges(nominal))
                .collect(),
        }
    }

    /// The range of each coordinate, as far as a turn has digits in it: some vendors write limits of 1e16.
    #[must_use]
    pub fn turns_with_digits(&self) -> Vec<[f64; 2]> {
        const FARTHEST: f64 = 1e6;
        let ends = |ends: &[f64; 2]| ends.map(|end| end.clamp(-FARTHEST, FARTHEST));
        self.q.iter().map(ends).collect()
    }

    /// The range of one input; none where nothing is known of it.
    #[must_use]
    pub fn get(&self, input: Input) -> Option<[f64; 2]> {
        let at = |ranges: &[[f64; 2]], k: u16| ranges.get(usize::from(k)).copied();
        match input {
            Input::Variable(variable, k) => match variable {
                Variable::Q => at(&self.q, k),
                Variable::Qd => at(&self.qd, k),
                Variable::Qdd => at(&self.qdd, k),
                Variable::Tau => None,
                Variable::Actions => at(&self.actions, k),
            },
            Input::Parameter(field, k) => {
                self.fields.get(field.into()).and_then(|field| at(field, k))
            }
        }
    }
}

/// The range of some arguments, and of the fields that are read, in words:
/// ``q and q̇ within their limits, |q̈| ≤ 10 rad/s², `payload` from 0 to 3 kg``.
#[must_use]
pub fn words(chain: &Chain, arguments: &[Variable], reads: impl Fn(FieldId) -> bool) -> String {
    let mut within_limits = Vec::new();
    let mut sizes = Vec::new();
    let spaces = chain.spaces();
    for &argument in arguments {
        let letter = argument.letter();
        let entries = spaces.entries(argument.space()).iter();
        let (has, lacks): (Vec<&Entry>, Vec<&Entry>) =
            entries.partition(|entry| described(argument, entry).is_some());
        if !has.is_empty() {
            within_limits.push(letter);
        }
        // A quaternion is what it is.
        let kinds = [Kind::Turn, Kind::Slide].into_iter();
        let kinds = kinds.filter(|&kind| lacks.iter().any(|entry| entry.kind == kind));
        let kinds = kinds.filter_map(|kind| {
            let size = number(default(argument, kind)?);
            Some(format!("{size} {}", argument.unit(kind)))
        });
        let kinds: Vec<String> = kinds.collect();
        if !kinds.is_empty() {
            let or = if has.is_empty() { "" } else { "else " };
            sizes.push(format!("{or}|{letter}| ≤ {}", kinds.join(", ")));
        }
    }
    let within_limits = match &*within_limits {
        [] => None,
        [one] => Some(format!("{one} within its limits")),
        several => Some(format!("{} within their limits", several.join(" and "))),
    };
    let fields = chain.parameters.numbered().filter(|(k, _)| reads(*k));
    let fields = fields.map(|(k, field)| field.range_words(&chain.nominal[k]));
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

    /// A joint that turns and one that slides on it.
    fn arm(turning: &str, sliding: &str) -> Chain {
        let joint = |name: &str, kind: &str, parent: &str, child: &str, limit: &str| {
            format!(
                r#"<joint name="{name}" type="{kind}"><parent link="{parent}"/>
                <child link="{child}"/><axis xyz="0 0 1"/>{limit}</joint>"#
            )
        };
        let text = [
            r#"<robot name="arm"><link name="base"/><link name="a"/><link name="b"/>"#.to_owned(),
            joint("turns", "revolute", "base", "a", turning),
            joint("slides", "prismatic", "a", "b", sliding),
            "</robot>".to_owned(),
        ];
        let mut errors = Errors::new();
        let description = read_text(&text.concat(), "arm.urdf", None, &mut errors);
        assert!(errors.is_empty(), "{errors}");
        let description = description.expect("no mistakes, so a description");
        chain::build(&description, &Request::default()).expect("a tree")
    }

    #[test]
    fn limits_are_taken_where_they_are_described() {
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
    fn where_no_limit_is_described_the_range_is_told() {
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
