//! Which form of forward dynamics a chain can bear.
//!
//! In: a chain and the unit roundoff of the generated code. Out: how often to refine; a doubt about
//! the form that was asked for; or the mistake that no form helps. It looks at the pivots of the
//! mass matrix in a handful of postures, in extended precision: what a pivot lost of its diagonal
//! entry is what rounding takes from the result.

use crate::chain::Chain;
use crate::chain::frames::{Layout, arrange};
use crate::chain::range::Range;
use crate::error::{Complaint, Errors};
use crate::expression::{Double, Expr, Graph, Input, Term};
use crate::formulation::Forward;
use crate::function::Function;
use crate::model;
use crate::request::{Real, Request};
use crate::schedule::{Program, run, schedule};

/// How many postures are looked at.
const POSTURES: u32 = 16;

/// The form that some functions take: the one that is asked for, or else the one that keeps more
/// than half of the digits.
///
/// # Errors
/// Where the mass matrix is singular in every posture; where it loses so much that refining
/// diverges, unless a form is asked for.
pub fn form(
    chain: &Chain,
    functions: &[Function],
    scalar: Real,
    asked: Option<Forward>,
) -> Result<Forward, Errors> {
    let solves = functions.contains(&Function::ForwardDynamics);
    // The inverse of the mass matrix has one form, which must do.
    let inverts = functions.contains(&Function::MassMatrixInverse);
    match asked {
        Some(asked) if solves && !inverts => Worst::of(chain).regular(chain).map(|_| asked),
        _ if solves || inverts => {
            let chosen = choose(chain, scalar)?;
            Ok(asked.unwrap_or(chosen))
        }
        _ => Ok(model::Way::PLAIN.forward),
    }
}

/// What a form that is asked for, instead of the one that would be chosen, may cost.
pub fn doubt(chain: &Chain, request: &Request) -> Option<Complaint> {
    let Some(Forward::MassMatrix { refinements }) = request.formulation.forward else {
        return None;
    };
    let wanted = request.items().concat();
    if !wanted.contains(&Function::ForwardDynamics) {
        return None;
    }
    // A singular chain is refused, function by function.
    let worst = Worst::of(chain).regular(chain).ok()?;
    let roundoff = request.scalar.roundoff();
    let error = worst.error(chain, roundoff);
    if keeps_half(error, roundoff, refinements) {
        return None;
    }
    let joint = &chain.joints[worst.joint];
    let (name, loss) = (&joint.name, worst.loss);
    let hint = match refinements_needed(error, roundoff) {
        Some(needed) => format!("write refined = {needed}, or leave the choice to the engine"),
        None => "generate it for f64, or model a robot whose masses differ less".to_owned(),
    };
    Some(Complaint {
        place: joint.place,
        message: format!(
            "forward dynamics with refined = {refinements} loses more than half of the digits: at \
             joint \"{name}\" the mass matrix loses a factor of {loss:.0e}, and the unit roundoff \
             is {roundoff:.0e}"
        ),
        hint: Some(hint),
    })
}

/// The form whose result keeps more than half of the digits.
///
/// # Errors
/// Where the mass matrix is singular in every posture, or loses so much that refining diverges.
pub fn choose(chain: &Chain, scalar: Real) -> Result<Forward, Errors> {
    let roundoff = scalar.roundoff();
    let worst = Worst::of(chain).regular(chain)?;
    let loss = worst.loss;
    if let Some(refinements) = refinements_needed(worst.error(chain, roundoff), roundoff) {
        return Ok(Forward::MassMatrix { refinements });
    }
    let joint = &chain.joints[worst.joint];
    let mut errors = chain.source.errors();
    errors.push_with_hint(
        joint.place,
        format!(
            "forward dynamics would be left without a correct digit: at joint \"{}\" the mass \
             matrix loses a factor of {loss:.0e}, and the unit roundoff is {roundoff:.0e}",
            joint.name
        ),
        "generate it for f64, or model a robot whose masses differ less",
    );
    Err(errors)
}

/// The fewest refinements that keep half of the digits, if two do.
fn refinements_needed(error: f64, roundoff: f64) -> Option<usize> {
    (0..3).find(|&refinements| keeps_half(error, roundoff, refinements))
}

/// Whether half of the digits are left of a result with a relative error after so many refinements,
/// of which each multiplies the error by itself once more.
fn keeps_half(error: f64, roundoff: f64, refinements: usize) -> bool {
    let exponent = i32::try_from(refinements).map_or(i32::MAX, |count| count.saturating_add(1));
    error.powi(exponent) <= roundoff.sqrt() && (refinements == 0 || error < 0.1)
}

/// Where the mass matrix loses most.
struct Worst {
    /// The largest ratio of a diagonal entry to its pivot; infinite where it is singular.
    loss: f64,
    /// The joint that they belong to.
    joint: usize,
}

impl Worst {
    fn of(chain: &Chain) -> Self {
        let graph = chain.graph.clone();
        let program = pivots(&graph, chain);
        let range = Range::of(chain);
        let mut worst = Self {
            loss: 1.0,
            joint: 0,
        };
        let count = chain.joints.len();
        // A joint that is singular in one posture may only be passing through it.
        let mut least = vec![f64::INFINITY; count];
        for posture in 0..POSTURES {
            let values = run::<Double>(&program, |input| {
                Double::from(value(chain, &range, input, posture))
            });
            for (joint, pair) in values.chunks(2).enumerate() {
                let (entry, pivot) = (pair[0].to_f64(), pair[1].to_f64());
                let loss = if pivot > 0.0 {
                    entry / pivot
                } else {
                    f64::INFINITY
                };
                least[joint] = least[joint].min(loss);
                if loss > worst.loss && loss.is_finite() {
                    worst = Self { loss, joint };
                }
            }
        }
        // Outermost first: what is outboard spoils what is inboard of it.
        let singular = (0..count).rev().find(|&joint| !least[joint].is_finite());
        singular.map_or(worst, |joint| Self {
            loss: f64::INFINITY,
            joint,
        })
    }

    /// The relative error to be expected of what is not refined: the loss magnifies as many roundings
    /// as there are joints.
    fn error(&self, chain: &Chain, roundoff: f64) -> f64 {
        let joints = u32::try_from(chain.joints.len()).expect("fewer than 65536 joints");
        self.loss * f64::from(joints) * roundoff
    }

    /// Itself, where the mass matrix is regular.
    fn regular(self, chain: &Chain) -> Result<Self, Errors> {
        if self.loss.is_finite() && self.loss <= 1e20 {
            return Ok(self);
        }
        let joint = &chain.joints[self.joint];
        let mut errors = chain.source.errors();
        errors.push_with_hint(
            joint.place,
            format!(
                "joint \"{}\" can accelerate without any force: the mass matrix is singular",
                joint.name
            ),
            "give what it carries a mass or an inertia about its axis, or lock it",
        );
        Err(errors)
    }
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

/// A coordinate of a posture, from a sequence that fills the range evenly (multiples of the golden
/// ratio's powers); or what is described where a struct field stands.
fn value(chain: &Chain, range: &Range, input: Input, posture: u32) -> f64 {
    match input {
        Input::Q(k) => {
            let [lower, upper] = range.q[usize::from(k)];
            let step = 0.618_033_988_749_895 * f64::from(k + 1).sqrt();
            lower + (upper - lower) * (0.5 + f64::from(posture) * step).fract()
        }
        Input::Parameter(field, entry) => {
            let field = chain.nominal.get(usize::from(field));
            field
                .and_then(|field| field.get(usize::from(entry)))
                .copied()
                .unwrap_or(0.0)
        }
        Input::Qd(_) | Input::Qdd(_) | Input::Tau(_) => 0.0,
    }
}

#[cfg(test)]
mod tests {
    use super::choose;
    use crate::chain::frames::Layout;
    use crate::chain::{self, Chain};
    use crate::description::read_text;
    use crate::error::Errors;
    use crate::expand::program_by;
    use crate::expression::{Double, Input};
    use crate::formulation::Forward;
    use crate::function::Function;
    use crate::model::Way;
    use crate::request::{Real, Request};
    use crate::schedule::run;

    /// Two links in a plane, with masses at their ends.
    fn arm(first: f64, second: f64) -> Chain {
        let link = |name: &str, mass: f64| {
            format!(
                r#"<link name="{name}"><inertial><origin xyz="1 0 0"/><mass value="{mass}"/>
                <inertia ixx="0" ixy="0" ixz="0" iyy="0" iyz="0" izz="0"/></inertial></link>"#
            )
        };
        let joint = |name: &str, parent: &str, child: &str| {
            format!(
                r#"<joint name="{name}" type="continuous"><parent link="{parent}"/>
                <child link="{child}"/><origin xyz="1 0 0"/><axis xyz="0 0 1"/></joint>"#
            )
        };
        let text = [
            r#"<robot name="arm"><link name="base"/>"#.to_owned(),
            link("upper", first),
            link("lower", second),
            joint("shoulder", "base", "upper"),
            joint("elbow", "upper", "lower"),
            "</robot>".to_owned(),
        ];
        let mut errors = Errors::new();
        let description = read_text(&text.concat(), "arm.urdf", None, &mut errors);
        assert!(errors.is_empty(), "{errors}");
        let description = description.expect("no mistakes, so a description");
        chain::build(&description, &Request::default()).expect("a tree")
    }

    #[test]
    fn an_ordinary_arm_needs_no_refinement() {
        for scalar in [Real::F32, Real::F64, Real::Generic] {
            let form = choose(&arm(1.0, 1.0), scalar).expect("regular");
            assert_eq!(form, Forward::UNREFINED);
        }
    }

    #[test]
    fn a_heavy_tip_is_refined_in_f64_and_refused_in_f32() {
        let arm = arm(1.0, 1e10);
        let form = choose(&arm, Real::F64).expect("regular");
        assert!(
            matches!(form, Forward::MassMatrix { refinements: 1.. }),
            "{form:?}"
        );
        let refusal = choose(&arm, Real::F32).expect_err("hopeless").to_string();
        assert!(refusal.contains("without a correct digit"), "{refusal}");
        assert!(refusal.contains("generate it for f64"), "{refusal}");
    }

    /// The larger relative error of both accelerations in f64, against 106 bits, nearly stretched.
    fn error(chain: &Chain, refinements: usize) -> f64 {
        let forward = Forward::MassMatrix { refinements };
        let way = Way {
            forward,
            ..Way::PLAIN
        };
        let functions = [Function::ForwardDynamics];
        let program = program_by(chain, &functions, 0, Layout::DESCRIBED, way);
        let state = |input| match input {
            Input::Q(_) => 1e-4,
            Input::Qd(_) => 0.3,
            _ => 1.1,
        };
        let found = run::<f64>(&program, state);
        let exact = run::<Double>(&program, |input| Double::from(state(input)));
        let pairs = found.iter().zip(&exact);
        pairs.fold(0.0, |worst, (found, exact)| {
            worst.max((found / exact.to_f64() - 1.0).abs())
        })
    }

    #[test]
    fn a_refinement_brings_back_the_digits_that_the_mass_matrix_lost() {
        let arm = arm(1.0, 1e8);
        let [plain, refined] = [0, 1].map(|refinements| error(&arm, refinements));
        assert!(
            plain > 1e-10 && refined < 1e-14,
            "{plain:e} and {refined:e}"
        );
    }

    #[test]
    fn a_massless_end_is_refused_by_the_name_of_its_joint() {
        let refusal = choose(&arm(1.0, 0.0), Real::F64)
            .expect_err("singular")
            .to_string();
        assert!(
            refusal.starts_with(
                "error: arm.urdf:4:99: joint \"elbow\" can accelerate without any force"
            ),
            "{refusal}"
        );
    }
}
