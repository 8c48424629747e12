//! The states that a robot is meant for: how far its joints go, and how fast.
//!
//! In: a chain. Out: a [`Range`] of every argument, from the limits that are described and, where
//! there are none, from the defaults below. It never looks at what is computed of a state.

use std::f64::consts::PI;

use crate::chain::{Chain, Joint, Motion};
use crate::expression::Input;
use crate::function::Argument;
use crate::request::Parameter;

/// The least and the greatest that each argument of a function can be.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Range {
    /// Of each coordinate [rad or m].
    pub q: Vec<[f64; 2]>,
    /// Of each rate [rad/s or m/s].
    pub qd: Vec<[f64; 2]>,
    /// Of each second rate [rad/s² or m/s²].
    pub qdd: Vec<[f64; 2]>,
    /// Of the entries of each struct field, in the units of what it stands for.
    pub fields: Vec<Vec<[f64; 2]>>,
}

/// How far a joint without limits goes to both sides: π rad, or 1 m.
const REACH: [f64; 2] = [PI, 1.0];

/// How fast a joint without a limit of its rate moves: 10 rad/s, or 1 m/s.
const RATE: [f64; 2] = [10.0, 1.0];

/// How much joints are accelerated, of which no description tells: 10 rad/s², or 10 m/s².
const SECOND_RATE: [f64; 2] = [10.0, 10.0];

/// How large the entries of a field are in whose place nothing but zeros are described: 1 kg, 1 m or
/// 1 m/s².
const FIELD: f64 = 1.0;

/// How many times as large as described they are otherwise.
const TIMES: f64 = 2.0;

impl Range {
    /// The states of a chain. A field has the range that is declared for it, or else one that holds
    /// zero and twice the largest entry that is described in its place: its entries may be anything
    /// that has this size.
    #[must_use]
    pub fn of(chain: &Chain) -> Self {
        let both = |size: f64| [-size, size];
        let joints = || chain.joints.iter();
        Self {
            q: joints()
                .map(|joint| reach(joint).unwrap_or_else(|| both(REACH[slides(joint)])))
                .collect(),
            qd: joints()
                .map(|joint| both(rate(joint).unwrap_or(RATE[slides(joint)])))
                .collect(),
            qdd: joints()
                .map(|joint| both(SECOND_RATE[slides(joint)]))
                .collect(),
            fields: (chain.parameters.iter().zip(&chain.nominal))
                .map(|(field, nominal)| vec![within(field, nominal); nominal.len()])
                .collect(),
        }
    }

    /// The range of one input; none where nothing is known of it.
    #[must_use]
    pub fn get(&self, input: Input) -> Option<[f64; 2]> {
        let at = |ranges: &[[f64; 2]], k: u16| ranges.get(usize::from(k)).copied();
        match input {
            Input::Q(k) => at(&self.q, k),
            Input::Qd(k) => at(&self.qd, k),
            Input::Qdd(k) => at(&self.qdd, k),
            Input::Tau(_) => None,
            Input::Parameter(field, k) => self
                .fields
                .get(usize::from(field))
                .and_then(|field| at(field, k)),
        }
    }
}

/// The range of some arguments, and of the fields that are read, in words:
/// ``q and q̇ within their limits, |q̈| ≤ 10 rad/s², `payload` from 0 to 3 kg``.
#[must_use]
pub fn words(chain: &Chain, arguments: &[Argument], reads: impl Fn(usize) -> bool) -> String {
    let mut within_limits = Vec::new();
    let mut sizes = Vec::new();
    for argument in arguments {
        let (letter, defaults, units, limited): (_, _, _, fn(&Joint) -> bool) = match argument {
            Argument::Q => ("q", REACH, ["rad", "m"], |joint| reach(joint).is_some()),
            Argument::Qd => ("q̇", RATE, ["rad/s", "m/s"], |joint| rate(joint).is_some()),
            Argument::Qdd => ("q̈", SECOND_RATE, ["rad/s²", "m/s²"], |_| false),
            Argument::Tau => continue,
        };
        let (has, lacks): (Vec<&Joint>, Vec<&Joint>) =
            chain.joints.iter().partition(|joint| limited(joint));
        if !has.is_empty() {
            within_limits.push(letter);
        }
        let kinds = [0, 1].into_iter();
        let kinds = kinds.filter(|&kind| lacks.iter().any(|joint| slides(joint) == kind));
        let kinds: Vec<String> = kinds
            .map(|kind| format!("{} {}", number(defaults[kind]), units[kind]))
            .collect();
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
    let fields = chain.parameters.iter().zip(&chain.nominal).enumerate();
    let fields = fields.filter(|(field, _)| reads(*field));
    let fields = fields.map(|(_, (field, nominal))| {
        let [least, most] = within(field, nominal);
        let (name, unit) = (&field.field, field.target.unit());
        if least == -most {
            format!("entries of `{name}` ≤ {most} {unit}")
        } else {
            format!("`{name}` from {least} to {most} {unit}")
        }
    });
    let words = within_limits.into_iter().chain(sizes);
    let words: Vec<String> = words.chain(fields).collect();
    words.join(", ")
}

/// The least and the greatest of each entry of a field.
fn within(field: &Parameter, nominal: &[f64]) -> [f64; 2] {
    field.range.unwrap_or_else(|| {
        let described = nominal
            .iter()
            .fold(0.0, |most: f64, entry| most.max(entry.abs()));
        let most = if described > 0.0 {
            TIMES * described
        } else {
            FIELD
        };
        field.target.range_up_to(most)
    })
}

fn number(size: f64) -> String {
    if size == PI {
        "π".to_owned()
    } else {
        size.to_string()
    }
}

/// 0 for a joint that turns, 1 for one that slides.
const fn slides(joint: &Joint) -> usize {
    matches!(joint.motion, Motion::Prismatic) as usize
}

/// The limits of a coordinate: one point where they are equal, but for two zeros, which in a URDF
/// stand for limits that were not written.
fn reach(joint: &Joint) -> Option<[f64; 2]> {
    let limits = joint.limits?;
    let [lower, upper] = [limits.lower, limits.upper];
    let finite = lower.is_finite() && upper.is_finite() && (upper - lower).is_finite();
    let written = lower != 0.0 || upper != 0.0;
    (finite && written && lower <= upper).then_some([lower, upper])
}

fn rate(joint: &Joint) -> Option<f64> {
    let rate = joint.limits?.velocity;
    (rate > 0.0 && rate.is_finite()).then_some(rate)
}

#[cfg(test)]
mod tests {
    use super::{Range, words};
    use crate::chain::{self, Chain};
    use crate::description::read_text;
    use crate::error::Errors;
    use crate::expression::Input;
    use crate::function::Argument;
    use crate::request::Request;

    const ALL: [Argument; 3] = [Argument::Q, Argument::Qd, Argument::Qdd];

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
        assert_eq!(range.get(Input::Q(0)), Some([-1.0, 2.0]));
        assert_eq!(range.get(Input::Qd(1)), Some([-3.0, 3.0]));
        assert_eq!(range.get(Input::Qdd(0)), Some([-10.0, 10.0]));
        assert_eq!(range.get(Input::Tau(0)), None);
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
        assert_eq!(range.get(Input::Q(1)), Some([-1.0, 1.0]));
        assert_eq!(
            words(&chain, &ALL, |_| true),
            "q within its limits, else |q| ≤ 1 m, |q̇| ≤ 10 rad/s, 1 m/s, |q̈| ≤ 10 rad/s², 10 m/s²"
        );
    }
}
