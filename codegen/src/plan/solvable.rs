//! Solvability: whether forces determine accelerations, so that the mass matrix is positive definite.
//!
//! In: a chain. Out: the largest loss of a pivot of its mass matrix, in a few configurations and in extended precision;
//! or an error with the joint that can accelerate without force, or with the body whose inertia is not physical. It is
//! the same for every scalar type.

use std::collections::BTreeSet;

use super::program::arranged;
use crate::chain::{BodyId, Chain, Joint, physical};
use crate::error::{Diagnostic, Errors};
use crate::expression::{Double, Evaluation, Expr, Graph, Input, Node, Term};
use crate::layout::Layout;
use crate::list::{Id, List};
use crate::model;
use crate::quaternion::normalize;
use crate::range::Range;
use crate::space::{FieldId, Variable, VelocityId};
use crate::wording::{list, quoted};

/// Number of configurations.
const SAMPLES: u32 = 16;

/// Ratio Mᵢᵢ / pivot beyond which a pivot is pure rounding error.
const SINGULAR: f64 = 1e20;

/// The largest loss of the mass matrix.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Worst {
    /// The largest ratio of a diagonal entry to its pivot.
    pub(super) loss: f64,
    /// The joint with that ratio.
    pub(super) joint: BodyId,
    /// A joint that accelerates against its force in some configuration.
    against: Option<BodyId>,
}

/// The reason why a mass matrix is not positive definite.
enum Lack {
    /// A joint that moves no inertia, in any configuration.
    Inertia(BodyId),
    /// A joint that accelerates against its force.
    Sign(BodyId),
}

/// The loss of the mass matrix, with fields at their values in the description, or at the end of their range if those
/// are zero.
///
/// # Errors
/// If it is singular or has a negative pivot in every configuration.
pub(super) fn solvable(chain: &Chain) -> Result<Worst, Errors> {
    worst(chain, |input| field(chain, input)).map_err(|lack| refusal(chain, &lack))
}

/// Warnings about a chain that is solvable in some configuration: fields that must not have their described values, and
/// inertias that are non-physical in some configurations.
pub(super) fn warnings(chain: &Chain, worst: Worst) -> Vec<Diagnostic> {
    let against = worst.against.map(|joint| {
        let cause = cause(chain, joint).unwrap_or(&chain.joints[joint]);
        Diagnostic {
            place: cause.place,
            message: format!("{}, in some configurations", against_force(chain, joint)),
            hint: Some(CORRECT.to_owned()),
        }
    });
    against.into_iter().chain(zero(chain)).collect()
}

/// The warning that a chain is singular if fields have their described values.
fn zero(chain: &Chain) -> Option<Diagnostic> {
    if chain.nominal.iter().all(|nominal| !is_zero(nominal)) {
        return None;
    }
    let zeros = undescribed(chain);
    let Err(Lack::Inertia(joint)) = worst(chain, |input| described(chain, input)) else {
        return None;
    };
    let joint = &chain.joints[joint];
    Some(Diagnostic {
        place: joint.place,
        message: format!(
            "joint \"{}\" can accelerate without any force where {} {} as described, zero: \
             accelerations are infinite there",
            joint.name,
            fields(&zeros),
            one_or_more(&zeros, "is", "are"),
        ),
        hint: Some(format!(
            "never give {} zero, or give the link an inertial",
            one_or_more(&zeros, "it", "them")
        )),
    })
}

/// The value of a field's entry: from the description, or the end of its range if all entries of the field are zero
/// there.
pub(super) fn field(chain: &Chain, input: Input) -> f64 {
    match input {
        Input::Parameter(field, entry) if is_zero(&chain.nominal[field.into()]) => {
            chain.field(field.into()).at_the_end(entry.into())
        }
        _ => described(chain, input),
    }
}

fn described(chain: &Chain, input: Input) -> f64 {
    let Input::Parameter(field, entry) = input else {
        return 0.0;
    };
    let field = chain.nominal.get(field.into());
    let entry = field.and_then(|field| field.get(usize::from(entry)));
    entry.copied().unwrap_or(0.0)
}

fn is_zero(nominal: &[f64]) -> bool {
    nominal.iter().all(|&entry| entry == 0.0)
}

/// The fields that enter the mass matrix and are zero in the description.
fn undescribed(chain: &Chain) -> Vec<String> {
    let graph = chain.graph.clone();
    let (needed, _) = graph.needed(&pivots(&graph, chain));
    let entering: BTreeSet<FieldId> = needed
        .into_iter()
        .filter_map(|expr| match graph.node(expr) {
            Node::Input(Input::Parameter(field, _)) => Some(field.into()),
            _ => None,
        })
        .collect();
    let zeros = entering
        .into_iter()
        .filter(|&field| is_zero(&chain.nominal[field]));
    zeros
        .map(|field| chain.field(field).field.to_string())
        .collect()
}

/// The sentence that a hint adds if fields are taken at the end of their range, since they are zero in the
/// description.
pub(super) fn at_the_end(chain: &Chain) -> String {
    let zeros = undescribed(chain);
    if zeros.is_empty() {
        return String::new();
    }
    let taken = one_or_more(
        &zeros,
        "is described as zero and taken at the end of its range: declare the range",
        "are described as zero and taken at the ends of their ranges: declare the ranges",
    );
    format!("; {} {taken}", fields(&zeros))
}

/// `field "payload"` or `fields "a" and "b"`.
fn fields(names: &[String]) -> String {
    let quoted: Vec<String> = names.iter().map(|name| quoted(name)).collect();
    let fields = one_or_more(names, "field", "fields");
    format!("{fields} {}", list(quoted.iter().map(String::as_str)))
}

/// The singular or the plural words.
const fn one_or_more<'w>(names: &[String], one: &'w str, several: &'w str) -> &'w str {
    match names {
        [_] => one,
        _ => several,
    }
}

fn worst(chain: &Chain, field: impl Fn(Input) -> f64) -> Result<Worst, Lack> {
    let graph = chain.graph.clone();
    // Evaluated on the graph, whose numbers have all their digits: a pivot that cancels would otherwise be the rounding
    // of literals.
    let pivots = Evaluation::of(&graph, &pivots(&graph, chain));
    let range = Range::of(chain);
    let velocities = &chain.spaces().velocities;
    let mut worst = (1.0, VelocityId::new(0));
    let mut against = None;
    // A joint that is singular in one configuration may only pass through it.
    let mut least = velocities.map(|_| f64::INFINITY);
    let mut always = velocities.map(|_| true);
    for sample in 0..SAMPLES {
        let coordinates = (0..).zip(range.turns_with_digits());
        let coordinates = coordinates.map(|(k, ends)| coordinate(ends, k, sample));
        let mut q: Vec<Double> = coordinates.map(Double::from).collect();
        for first in chain.spaces().quaternions() {
            normalize(&mut q[first.index()..][..4]);
        }
        let values = pivots.at(|input| match input {
            Input::Variable(Variable::Q, k) => q[usize::from(k)],
            _ => Double::from(field(input)),
        });
        for (velocity, pair) in velocities.ids().zip(values.chunks(2)) {
            let (entry, pivot) = (pair[0].to_f64(), pair[1].to_f64());
            let loss = if pivot > 0.0 {
                entry / pivot
            } else {
                f64::INFINITY
            };
            least[velocity] = least[velocity].min(loss);
            let is_against = pivot * SINGULAR < -entry.abs();
            always[velocity] &= is_against;
            if is_against {
                against = against.max(Some(velocity));
            }
            if loss > worst.0 && loss.is_finite() {
                worst = (loss, velocity);
            }
        }
    }
    // Outermost first: a singular joint makes those inboard of it singular too.
    for velocity in velocities.ids().rev() {
        if always[velocity] {
            return Err(Lack::Sign(chain.mover(velocity)));
        }
        if least[velocity] > SINGULAR {
            return Err(Lack::Inertia(chain.mover(velocity)));
        }
    }
    let (loss, velocity) = worst;
    Ok(Worst {
        loss,
        joint: chain.mover(velocity),
        against: against.map(|velocity| chain.mover(velocity)),
    })
}

/// A diagonal entry and its pivot, for each joint.
fn pivots(graph: &Graph, chain: &Chain) -> Vec<Expr> {
    if chain.is_long() {
        let bodies = arranged(graph, chain, Layout::DESCRIBED);
        let pivots = model::articulated_pivots(graph, &bodies).into_iter();
        return pivots.map(Term::expr).collect();
    }
    let layout = Layout {
        regroup: true,
        ..Layout::DESCRIBED
    };
    let bodies = arranged(graph, chain, layout);
    let pivots = model::pivots(graph, &bodies).into_iter();
    pivots.map(Term::expr).collect()
}

/// A coordinate of a configuration, from a sequence that fills the range evenly: multiples of the golden ratio and of
/// roots.
fn coordinate([lower, upper]: [f64; 2], k: u16, sample: u32) -> f64 {
    let step = 0.618_033_988_749_895 * f64::from(k + 1).sqrt();
    lower + (upper - lower) * (0.5 + f64::from(sample) * step).fract()
}

fn refusal(chain: &Chain, lack: &Lack) -> Errors {
    let mut errors = chain.description.source.errors();
    let zeros = undescribed(chain);
    let but = if zeros.is_empty() {
        String::new()
    } else {
        let help = one_or_more(
            &zeros,
            "which is described as zero, does not help",
            "which are described as zero, do not help",
        );
        format!(" ({}, {help})", fields(&zeros))
    };
    match *lack {
        Lack::Inertia(joint) => {
            let joint = &chain.joints[joint];
            errors.push_with_hint(
                joint.place,
                format!(
                    "joint \"{}\" can accelerate without any force: the mass matrix is singular",
                    joint.name
                ),
                format!(
                    "give what it carries a mass or an inertia about its axis, or lock it{but}"
                ),
            );
        }
        Lack::Sign(joint) => {
            let place = cause(chain, joint).unwrap_or(&chain.joints[joint]).place;
            let message = against_force(chain, joint);
            errors.push_with_hint(place, message, format!("{CORRECT}{but}"));
        }
    }
    errors
}

/// Hint about non-physical inertias.
const CORRECT: &str = "correct the inertias; `homogen check` lists the non-physical ones";

fn against_force(chain: &Chain, joint: BodyId) -> String {
    let carries = cause(chain, joint).map_or_else(String::new, |carrier| {
        format!(
            "joint \"{}\" carries a non-physical inertia, and ",
            carrier.name
        )
    });
    let name = &chain.joints[joint].name;
    format!(
        "the mass matrix is not positive definite: {carries}joint \"{name}\" accelerates against \
         its force"
    )
}

/// The first joint, from one outwards, that carries a non-physical inertia.
fn cause(chain: &Chain, from: BodyId) -> Option<&Joint> {
    let mut outboard = List::new();
    for (k, joint) in chain.joints.numbered() {
        let carried = joint.parent.is_some_and(|parent| outboard[parent]);
        outboard.push(k == from || carried);
    }
    let carried = chain.joints.iter().zip(outboard);
    let mut carried = carried.filter_map(|(joint, outboard)| outboard.then_some(joint));
    carried.find(|joint| {
        let inertia = joint.inertia.map(|entry| chain.graph.term(entry));
        physical::is_possible(inertia) == Some(false)
    })
}
