//! Which form of forward dynamics a chain can bear.
//!
//! In: a chain and the unit roundoff of the generated code. Out: how often to refine, or the
//! mistake that no form helps. It looks at the pivots of the mass matrix in a handful of postures,
//! in extended precision: what a pivot lost of its diagonal entry is what rounding takes from the
//! result.

use crate::chain::Chain;
use crate::chain::frames::{Layout, arrange};
use crate::chain::range::Range;
use crate::error::Errors;
use crate::expression::{Double, Expr, Graph, Input, Term};
use crate::model::{self, Forward};
use crate::request::Real;
use crate::schedule::{Program, run, schedule};

/// How many postures are looked at.
const POSTURES: u32 = 16;

/// The form whose result keeps more than half of the digits.
///
/// # Errors
/// Where the mass matrix is singular in every posture, or loses so much that refining diverges.
pub fn choose(chain: &Chain, scalar: Real) -> Result<Forward, Errors> {
    let roundoff = scalar.roundoff();
    let (loss, joint) = loss(chain);
    let name = &chain.joints[joint].name;
    let refuse = |message: String, hint: &str| {
        let mut errors = chain.source.errors();
        errors.push_with_hint(chain.joints[joint].place, message, hint);
        Err(errors)
    };
    if !loss.is_finite() || loss > 1e20 {
        return refuse(
            format!(
                "joint \"{name}\" can accelerate without any force: the mass matrix is singular"
            ),
            "give what it carries a mass or an inertia about its axis, or lock it",
        );
    }
    let error = loss * roundoff;
    // Each refinement multiplies the error by itself once more.
    let enough = (0..3_u32).find(|&refinements| {
        let exponent = i32::try_from(refinements).expect("few") + 1;
        error.powi(exponent) <= roundoff.sqrt() && (refinements == 0 || error < 0.1)
    });
    match enough {
        Some(refinements) => Ok(Forward::MassMatrix {
            refinements: refinements as usize,
        }),
        None => refuse(
            format!(
                "forward dynamics would be left without a correct digit: at joint \"{name}\" the \
                 mass matrix loses a factor of {loss:.0e}, and the unit roundoff is {roundoff:.0e}"
            ),
            "generate it for f64, or model a robot whose masses differ less",
        ),
    }
}

/// The largest ratio of a diagonal entry of the mass matrix to its pivot, and the joint it belongs
/// to.
fn loss(chain: &Chain) -> (f64, usize) {
    let graph = chain.graph.clone();
    let program = pivots(&graph, chain);
    let range = Range::of(chain);
    let mut worst = (1.0_f64, 0);
    let count = chain.joints.len();
    // A joint that is singular in one posture may only be passing through it.
    let mut least = vec![f64::INFINITY; count];
    for posture in 0..POSTURES {
        let values = run::<Double>(&program, |input| {
            Double::from(value(chain, &range, input, posture))
        });
        for (joint, pair) in values.chunks(2).enumerate() {
            let (entry, pivot) = (pair[0].to_f64(), pair[1].to_f64());
            let ratio = if pivot > 0.0 {
                entry / pivot
            } else {
                f64::INFINITY
            };
            least[joint] = least[joint].min(ratio);
            if ratio > worst.0 && ratio.is_finite() {
                worst = (ratio, joint);
            }
        }
    }
    // Outermost first: what is outboard spoils what is inboard of it.
    match (0..count).rev().find(|&joint| !least[joint].is_finite()) {
        Some(joint) => (f64::INFINITY, joint),
        None => worst,
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
    use crate::chain::{self, Chain};
    use crate::description::read_text;
    use crate::error::Errors;
    use crate::model::Forward;
    use crate::request::{Real, Request};

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
            assert_eq!(form, Forward::MassMatrix { refinements: 0 });
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
