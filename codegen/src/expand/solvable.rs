//! Whether forces determine accelerations at all: whether the mass matrix is positive definite.
//!
//! In: a chain. Out: what a pivot of its mass matrix loses at most, in a handful of postures and in
//! extended precision; or the mistake that says which joint nothing holds, or which body is none. It
//! never looks at a type of number.

use crate::chain::frames::{Layout, arrange};
use crate::chain::range::Range;
use crate::chain::{Chain, Joint, physical};
use crate::error::{Complaint, Errors};
use crate::expression::{Double, Expr, Graph, Input, Term};
use crate::model;
use crate::schedule::{Program, run, schedule};
use crate::wording::{list, quoted};

/// How many postures are looked at.
const POSTURES: u32 = 16;

/// What nothing but rounding is left of, beside a diagonal entry.
const SINGULAR: f64 = 1e20;

/// Where the mass matrix loses most.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Worst {
    /// The largest ratio of a diagonal entry to its pivot.
    pub(super) loss: f64,
    /// The joint that they belong to.
    pub(super) joint: usize,
}

/// What a chain has in place of a mass matrix that is positive definite.
enum Lack {
    /// A joint that moves nothing, whatever the posture.
    Inertia(usize),
    /// A joint that accelerates against its force.
    Sign(usize),
}

/// What the mass matrix loses, with fields at what they are described as, or at the end of their range
/// where nothing is described.
///
/// # Errors
/// Where it is singular or has a negative pivot in every posture.
pub(super) fn solvable(chain: &Chain) -> Result<Worst, Errors> {
    let range = Range::of(chain);
    worst(chain, |input| field(chain, &range, input)).map_err(|lack| refusal(chain, &lack))
}

/// What fields must not be, if forces are to determine accelerations.
pub(super) fn doubt(chain: &Chain) -> Option<Complaint> {
    let zeros = undescribed(chain);
    if zeros.is_empty() || solvable(chain).is_err() {
        return None;
    }
    let Err(Lack::Inertia(joint) | Lack::Sign(joint)) =
        worst(chain, |input| described(chain, input))
    else {
        return None;
    };
    let joint = &chain.joints[joint];
    Some(Complaint {
        place: joint.place,
        message: format!(
            "joint \"{}\" can accelerate without any force where {} as described, zero: \
             accelerations are infinite there",
            joint.name,
            are(&zeros)
        ),
        hint: Some("never give them zero, or give the link an inertial".to_owned()),
    })
}

/// The value of a field's entry: what is described in its place, or the end of its range where nothing
/// but zeros are.
pub(super) fn field(chain: &Chain, range: &Range, input: Input) -> f64 {
    match input {
        Input::Parameter(field, _) if is_zero(&chain.nominal[usize::from(field)]) => {
            range.get(input).map_or(0.0, |[_, most]| most)
        }
        _ => described(chain, input),
    }
}

fn described(chain: &Chain, input: Input) -> f64 {
    let Input::Parameter(field, entry) = input else {
        return 0.0;
    };
    let field = chain.nominal.get(usize::from(field));
    let entry = field.and_then(|field| field.get(usize::from(entry)));
    entry.copied().unwrap_or(0.0)
}

fn is_zero(nominal: &[f64]) -> bool {
    nominal.iter().all(|&entry| entry == 0.0)
}

/// The fields in whose place nothing but zeros are described.
fn undescribed(chain: &Chain) -> Vec<&str> {
    let fields = chain.fields.iter().zip(&chain.nominal);
    let zeros = fields.filter(|(_, nominal)| is_zero(nominal));
    zeros.map(|(name, _)| name.as_str()).collect()
}

/// `field "payload" is` or `fields "a" and "b" are`.
fn are(fields: &[&str]) -> String {
    let names: Vec<String> = fields.iter().map(|name| quoted(name)).collect();
    let names = list(names.iter().map(String::as_str));
    match fields {
        [_] => format!("field {names} is"),
        _ => format!("fields {names} are"),
    }
}

fn worst(chain: &Chain, field: impl Fn(Input) -> f64) -> Result<Worst, Lack> {
    let graph = chain.graph.clone();
    let program = pivots(&graph, chain);
    let range = Range::of(chain);
    let mut worst = Worst {
        loss: 1.0,
        joint: 0,
    };
    let count = chain.joints.len();
    // A joint that is singular in one posture may only be passing through it.
    let mut least = vec![f64::INFINITY; count];
    let mut negative = vec![true; count];
    for posture in 0..POSTURES {
        let values = run::<Double>(&program, |input| {
            Double::from(match input {
                Input::Q(k) => coordinate(&range, k, posture),
                _ => field(input),
            })
        });
        for (joint, pair) in values.chunks(2).enumerate() {
            let (entry, pivot) = (pair[0].to_f64(), pair[1].to_f64());
            let loss = if pivot > 0.0 {
                entry / pivot
            } else {
                f64::INFINITY
            };
            least[joint] = least[joint].min(loss);
            negative[joint] &= pivot * SINGULAR < -entry.abs();
            if loss > worst.loss && loss.is_finite() {
                worst = Worst { loss, joint };
            }
        }
    }
    // Outermost first: what is outboard spoils what is inboard of it.
    for joint in (0..count).rev() {
        if negative[joint] {
            return Err(Lack::Sign(joint));
        }
        if least[joint] > SINGULAR {
            return Err(Lack::Inertia(joint));
        }
    }
    Ok(worst)
}

fn pivots(graph: &Graph, chain: &Chain) -> Program {
    let layout = Layout {
        regroup: true,
        ..Layout::DESCRIBED
    };
    let bodies = arrange(graph, chain, layout);
    let results: Vec<Expr> = model::pivots(graph, &bodies)
        .into_iter()
        .map(Term::expr)
        .collect();
    schedule(graph, &results)
}

/// A coordinate of a posture, from a sequence that fills the range evenly: multiples of the golden
/// ratio and of roots.
fn coordinate(range: &Range, k: u16, posture: u32) -> f64 {
    let [lower, upper] = range.q[usize::from(k)];
    let step = 0.618_033_988_749_895 * f64::from(k + 1).sqrt();
    lower + (upper - lower) * (0.5 + f64::from(posture) * step).fract()
}

fn refusal(chain: &Chain, lack: &Lack) -> Errors {
    let mut errors = chain.source.errors();
    let zeros = undescribed(chain);
    let but = if zeros.is_empty() {
        String::new()
    } else {
        format!(" ({} described as zero, and does not help)", are(&zeros))
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
            let (joint, cause) = (&chain.joints[joint], cause(chain, joint));
            let message = match cause {
                Some(carrier) => format!(
                    "the mass matrix is not positive definite: joint \"{}\" carries an inertia that \
                     no body has, and joint \"{}\" accelerates against its force",
                    carrier.name, joint.name
                ),
                None => format!(
                    "the mass matrix is not positive definite: joint \"{}\" accelerates against its \
                     force",
                    joint.name
                ),
            };
            let place = cause.unwrap_or(joint).place;
            errors.push_with_hint(
                place,
                message,
                format!("correct the inertias; check tells which no body can have{but}"),
            );
        }
    }
    errors
}

/// The first joint, from one outwards, that carries what no body is.
fn cause(chain: &Chain, from: usize) -> Option<&Joint> {
    let mut outboard = vec![false; chain.joints.len()];
    for k in 0..chain.joints.len() {
        let parent = chain.joints[k].parent;
        outboard[k] = k == from || parent.is_some_and(|parent| outboard[parent]);
    }
    let carried = chain.joints.iter().zip(outboard);
    let mut carried = carried.filter_map(|(joint, outboard)| outboard.then_some(joint));
    carried.find(|joint| {
        let inertia = joint.inertia.map(|entry| chain.graph.term(entry));
        physical::is_possible(inertia) == Some(false)
    })
}
