//! Forms of forward dynamics and of the inverse of the mass matrix.
//!
//! In: a chain, functions, a formulation, and the measured error of a program. Out: the forms to be tried, in groups;
//! a warning about the form that was requested, or about a robot for which every form loses many digits; or an error
//! if no form is usable.

use super::measured::{ENOUGH, LIMIT, Measure, MeasuredError, allowed};
use super::program::program_by;
use super::solvable::{self, Worst, solvable};
use crate::chain::{Chain, Joint, MimicJoint};
use crate::error::{Diagnostic, Errors, Place};
use crate::formulation::{Formulation, Forward, Frame};
use crate::function::{Function, Given, Truth};
use crate::layout::Layout;
use crate::model::{Algorithm, Congruence};
use crate::real::Real;
use crate::request::Request;
use crate::space::FrameId;
use crate::wording::{list, quoted};

/// Error beyond which a warning says that no form is better \[u\].
const DOUBTFUL: f64 = 10.0 * LIMIT;

/// A form of forward dynamics, and the change of frame of inertias that it uses.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) struct ForwardForm {
    pub(super) forward: Forward,
    congruence: Congruence,
}

impl ForwardForm {
    const fn refined(refinements: usize) -> Self {
        Self::sparing(Forward::MassMatrix { refinements })
    }

    pub(super) const fn sparing(forward: Forward) -> Self {
        Self {
            forward,
            congruence: Congruence::Sparing,
        }
    }

    pub(super) const fn full(forward: Forward) -> Self {
        Self {
            forward,
            congruence: Congruence::Full,
        }
    }

    /// The form of an algorithm.
    pub(super) const fn of(algorithm: Algorithm) -> Self {
        Self {
            forward: algorithm.forward,
            congruence: algorithm.congruence,
        }
    }

    /// An algorithm with this form.
    pub(super) const fn along(self, algorithm: Algorithm) -> Algorithm {
        Algorithm {
            forward: self.forward,
            congruence: self.congruence,
            ..algorithm
        }
    }
}

/// The forms in groups. The first group with a form that is accurate enough decides, and in it the operation count.
///
/// The cost of factors grows with each further joint: with skew axes they cost more than articulated bodies from 11
/// joints on, with right angles from 13. In a plane they do from 4 on, but there the factors stay, which have the
/// closer error bound and are expanded in half of the time. A [long](Chain::is_long) chain has articulated bodies only.
pub(super) fn groups(
    chain: &Chain,
    functions: &[Function],
    formulation: Formulation,
) -> Vec<Vec<ForwardForm>> {
    const COMPARED: usize = 8;
    const DEARER: usize = 20;
    let [plain, once, twice] = [0, 1, 2].map(ForwardForm::refined);
    // In frame 0 inertias are not rotated from body to body.
    let full = (formulation.frame == Frame::Link).then_some(ForwardForm::full(plain.forward));
    // A mimic joint closes a loop, which the articulated-body algorithm does not cover.
    let open = formulation.frame == Frame::Link && chain.all_lead();
    let bodies = open.then_some(ForwardForm::sparing(Forward::Articulated));
    let full_bodies = open.then_some(ForwardForm::full(Forward::Articulated));
    if open && chain.is_long() {
        let each = bodies.into_iter().chain(full_bodies);
        return each.map(|form| vec![form]).collect();
    }
    let first = match (chain.longest(), bodies) {
        (DEARER.., Some(bodies)) => vec![bodies],
        (COMPARED.., Some(bodies)) => vec![plain, bodies],
        _ => vec![plain],
    };
    let full = full.filter(|_| first.contains(&plain));
    let left = bodies.filter(|bodies| !first.contains(bodies));
    let left = full.into_iter().chain(left).chain(full_bodies);
    // Each column of an inverse has a residual of its own, which costs much more than articulated bodies.
    let groups = if functions.iter().any(|function| function.inverts()) {
        [first, left.collect(), vec![once], vec![twice]]
    } else {
        [first, left.chain([once]).collect(), vec![twice], Vec::new()]
    };
    groups
        .into_iter()
        .filter(|group| !group.is_empty())
        .collect()
}

/// Rejects a form that a chain cannot have.
///
/// # Errors
/// Articulated bodies with a mimic joint.
pub(super) fn check(chain: &Chain, asked: Forward) -> Result<(), Errors> {
    let mut errors = chain.description.source.errors();
    if asked == Forward::Articulated
        && let Some(mimic) = chain.report.mimicked.first()
    {
        errors.push_with_hint(
            Place::Unknown,
            format!(
                "articulated bodies do not cover mimic joints: joint \"{}\" mimics joint \"{}\"",
                mimic.joint, mimic.mimicked
            ),
            "leave the form out, or lock the joint",
        );
    }
    errors.into_result(())
}

/// True if an error leaves half of the digits of a type.
#[must_use]
pub fn keeps_half(error: f64, scalar: Real) -> bool {
    error <= scalar.roundoff().sqrt().recip()
}

/// The error for functions of which no form leaves half of the digits, in the requested frame.
pub(super) fn hopeless(
    chain: &Chain,
    worst: Worst,
    error: f64,
    functions: &[Function],
    (scalar, frame): (Real, Frame),
) -> Errors {
    let mut errors = chain.description.source.errors();
    let cause = Cause::of(chain, worst);
    let diagnostic = cause.diagnostic(
        scalar,
        &format!(
            "{} would lose {}",
            named(functions),
            lost(functions, error, scalar)
        ),
    );
    let hint = match frame {
        Frame::Base => "leave frame_0 out: link frames keep the digits that it loses".to_owned(),
        Frame::Link => cause.remedy(scalar),
    };
    errors.push_with_hint(
        diagnostic.place,
        diagnostic.message,
        format!("{hint}{}", solvable::at_the_end(chain)),
    );
    errors
}

/// Warnings about accelerations: about the form that is requested, instead of the one that would be chosen; about the
/// loss of all forms; and about fields that must not be zero.
///
/// If no function is named, only accelerations and the inverse mass matrix are measured, which lose as much as their
/// derivatives, and no robot with many joints: that takes as long as generating its mass matrix.
pub(crate) fn warnings(chain: &Chain, request: &Request) -> Vec<Diagnostic> {
    const UNASKED: usize = 40;
    let is_asked = !request.functions.is_empty();
    let most = if is_asked { super::MOST } else { UNASKED };
    if chain.joints.len() > most {
        return Vec::new();
    }
    let is_measured = |function: &Function| match function.truth() {
        Truth::Solution(Given::Torques | Given::MassMatrix) => true,
        Truth::Solution(_) => is_asked,
        _ => false,
    };
    let items = request.items(false).into_iter();
    let items: Vec<Vec<Function>> = items.filter(|item| item.iter().any(is_measured)).collect();
    if items.is_empty() {
        return Vec::new();
    }
    // Singular robots are refused, function by function.
    let Ok(worst) = solvable(chain) else {
        return Vec::new();
    };
    let of_items = items
        .iter()
        .filter_map(|functions| warning(chain, worst, functions, request));
    (solvable::warnings(chain, worst).into_iter())
        .chain(of_items)
        .collect()
}

fn warning(
    chain: &Chain,
    worst: Worst,
    functions: &[Function],
    request: &Request,
) -> Option<Diagnostic> {
    let (scalar, name) = (request.scalar, named(functions));
    // A refinement restores a loss below the cube root of 1/u.
    let harmless = worst.loss * worst.loss * worst.loss * scalar.roundoff() < 1.0;
    let (error, most, by, hint) = if let Some(forward) = request.formulation.forward {
        // The warning is about the form, not about the cost of a frame or of a sum of angles.
        let algorithm = Algorithm {
            forward,
            ..Algorithm::PLAIN
        };
        let error = least_error(chain, worst, functions, scalar, [algorithm]).worst;
        let form = Formulation::default().with_forward(forward);
        let by = format!("{name} with {}", form.words().concat());
        let hint = "leave the form out".to_owned();
        (error, LIMIT, by, hint)
    } else if !harmless {
        let plain = match request.formulation.frame {
            Frame::Link => Algorithm::PLAIN,
            Frame::Base => Algorithm::IN_FRAME_0,
        };
        let forms = groups(chain, functions, request.formulation).into_iter();
        let algorithms = forms.flatten().map(|form| form.along(plain));
        let error = least_error(chain, worst, functions, scalar, algorithms);
        // If every form is unusable, the functions are refused one by one.
        let error = Some(error).filter(|error| keeps_half(error.eighth, scalar))?;
        let hint = Cause::of(chain, worst).remedy(Real::F32);
        (error.worst, DOUBTFUL, format!("{name} in any form"), hint)
    } else {
        return None;
    };
    let what = format!("{by} loses {}", lost(functions, error, scalar));
    (error > most).then(|| Diagnostic {
        hint: Some(hint),
        ..Cause::of(chain, worst).diagnostic(scalar, &what)
    })
}

/// The error of the first algorithm that is accurate enough, or else of the best one. It is measured in the frames of
/// the description, since the form decides.
fn least_error(
    chain: &Chain,
    worst: Worst,
    functions: &[Function],
    scalar: Real,
    algorithms: impl IntoIterator<Item = Algorithm>,
) -> MeasuredError {
    let mut measure = Measure::of(chain, functions, worst.loss, scalar);
    let mut least = MeasuredError::INFINITE;
    for algorithm in algorithms {
        let program = program_by(
            chain,
            functions,
            FrameId::FIRST,
            Layout::DESCRIBED,
            algorithm,
        );
        least = least.least(measure.error_within_limits(&program));
        if least.worst <= ENOUGH {
            break;
        }
    }
    least
}

/// The cause of a loss of digits.
enum Cause<'c> {
    /// A joint whose pivot of the mass matrix is small compared to its diagonal entry, and their ratio.
    MassMatrix(&'c Joint, f64),
    /// A mimic joint that is much faster than the joint it mimics: forces scale with the square of its multiplier.
    Multiplier(&'c MimicJoint, Place),
}

impl<'c> Cause<'c> {
    fn of(chain: &'c Chain, worst: Worst) -> Self {
        let fastest = chain.report.mimicked.iter();
        let square = |mimicked: &MimicJoint| mimicked.multiplier * mimicked.multiplier;
        let fastest = fastest.max_by(|one, other| square(one).total_cmp(&square(other)));
        match fastest.filter(|fastest| square(fastest) > worst.loss) {
            Some(fastest) => {
                let mut joints = chain.joints.iter();
                let joint = joints.find(|joint| joint.of == fastest.joint);
                Self::Multiplier(fastest, joint.map_or(Place::Unknown, |joint| joint.place))
            }
            None => Self::MassMatrix(&chain.joints[worst.joint], worst.loss),
        }
    }

    fn diagnostic(&self, scalar: Real, what: &str) -> Diagnostic {
        let roundoff = scalar.roundoff();
        let (place, why) = match self {
            Self::MassMatrix(joint, loss) => (
                joint.place,
                format!(
                    "at joint {} the mass matrix loses a factor of {loss:.0e}",
                    quoted(&joint.name)
                ),
            ),
            Self::Multiplier(mimicked, place) => (
                *place,
                format!(
                    "joint {} mimics joint {} with a multiplier of {}, whose square forces have",
                    quoted(&mimicked.joint),
                    quoted(&mimicked.mimicked),
                    mimicked.multiplier
                ),
            ),
        };
        Diagnostic {
            place,
            message: format!("{what}: {why}, and the unit roundoff is {roundoff:.0e}"),
            hint: None,
        }
    }

    fn remedy(&self, scalar: Real) -> String {
        let model = match self {
            Self::MassMatrix(..) => "model a robot whose masses and lengths differ less".to_owned(),
            Self::Multiplier(mimicked, _) => format!(
                "give joint {} the inertia of the fast part as a rotor or an armature",
                quoted(&mimicked.mimicked)
            ),
        };
        match scalar {
            Real::F32 => format!("generate it for f64, or {model}"),
            Real::F64 | Real::Generic => model,
        }
    }
}

/// The share of an error in the largest result, or its largest share over several functions.
fn lost(functions: &[Function], error: f64, scalar: Real) -> String {
    let allowed = functions.iter().map(|&function| allowed(function));
    let share = error * allowed.fold(1.0, f64::max) * scalar.roundoff();
    if share < 0.1 {
        format!("{share:.0e} of its largest result")
    } else {
        "every digit".to_owned()
    }
}

/// The functions that solve an equation.
fn named(functions: &[Function]) -> String {
    let names = functions.iter().filter(|function| function.solves());
    list(names.map(|function| function.name()))
}

#[cfg(test)]
mod tests;
