//! Which forms of forward dynamics and of the mass matrix's inverse there are.
//!
//! In: a chain, functions, a formulation, and what has been measured of a program. Out: the forms to
//! be tried, in rounds; a doubt about the form that was asked for, or about a robot for which none is
//! as good as it should be; or the mistake that no form helps. It never measures or counts.

use super::measured::{ENOUGH, LIMIT, Measure, Off, allowed};
use super::program::program_by;
use super::solvable::{self, Worst, solvable};
use crate::chain::{Chain, Joint, Mimicked};
use crate::error::{Complaint, Errors, Place};
use crate::formulation::{Formulation, Forward, Frame};
use crate::function::Function;
use crate::layout::Layout;
use crate::model::{Congruence, Way};
use crate::real::Real;
use crate::request::Request;
use crate::space::FrameId;
use crate::wording::{list, quoted};

/// Beyond which a robot is told that no form is any better \[u\].
const DOUBTFUL: f64 = 10.0 * LIMIT;

/// A form of forward dynamics, and how the inertias turn of which it is made.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) struct Form {
    pub(super) forward: Forward,
    congruence: Congruence,
}

impl Form {
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

    /// That of a way.
    pub(super) const fn of(way: Way) -> Self {
        Self {
            forward: way.forward,
            congruence: way.congruence,
        }
    }

    /// A way with this form.
    pub(super) const fn along(self, way: Way) -> Way {
        Way {
            forward: self.forward,
            congruence: self.congruence,
            ..way
        }
    }
}

/// The forms, in rounds: the first that has one that is accurate enough decides, and in it the count.
///
/// Factors cost ever more for each further joint: with skew axes they are dearer than articulated bodies
/// from 11 on, with right angles from 13. In a plane they are from 4 on, but an arm keeps the form that
/// has the closer error bound, and is expanded in half of the time. Of a [long](Chain::is_long) chain nothing else
/// is tried.
pub(super) fn rounds(
    chain: &Chain,
    functions: &[Function],
    formulation: Formulation,
) -> Vec<Vec<Form>> {
    const COMPARED: usize = 8;
    const DEARER: usize = 20;
    let [plain, once, twice] = [0, 1, 2].map(Form::refined);
    // In frame 0 no inertia turns from body to body.
    let full = (formulation.frame == Frame::Link).then_some(Form::full(plain.forward));
    // A joint that follows another closes a loop, over which articulated bodies do not go.
    let open = formulation.frame == Frame::Link && chain.all_lead();
    let bodies = open.then_some(Form::sparing(Forward::Articulated));
    if let Some(bodies) = bodies.filter(|_| chain.is_long()) {
        return vec![vec![bodies]];
    }
    let first = match (chain.longest(), bodies) {
        (DEARER.., Some(bodies)) => vec![bodies],
        (COMPARED.., Some(bodies)) => vec![plain, bodies],
        _ => vec![plain],
    };
    let full = full.filter(|_| first.contains(&plain));
    let left = bodies.filter(|bodies| !first.contains(bodies));
    let left = full.into_iter().chain(left);
    // Each column of an inverse has a residual of its own, which is much dearer than articulated bodies.
    let rounds = if functions.iter().any(|function| function.inverts()) {
        [first, left.collect(), vec![once], vec![twice]]
    } else {
        [first, left.chain([once]).collect(), vec![twice], Vec::new()]
    };
    rounds
        .into_iter()
        .filter(|round| !round.is_empty())
        .collect()
}

/// Refuses a form that a chain has not.
///
/// # Errors
/// Articulated bodies where a joint follows another.
pub(super) fn check(chain: &Chain, asked: Forward) -> Result<(), Errors> {
    let mut errors = chain.description.source.errors();
    if asked == Forward::Articulated
        && let Some(mimic) = chain.report.mimicked.first()
    {
        errors.push_with_hint(
            Place::Unknown,
            format!(
                "articulated bodies do not go over the loop that joint \"{}\" closes, which follows \
                 joint \"{}\"",
                mimic.joint, mimic.leader
            ),
            "leave the form to the engine, or lock the joint",
        );
    }
    errors.into_result(())
}

/// Whether an error leaves half of the digits of a type.
#[must_use]
pub fn keeps_half(error: f64, scalar: Real) -> bool {
    error <= scalar.roundoff().sqrt().recip()
}

/// What is to be said of functions that no form leaves half of the digits, in the frame that was asked
/// for.
pub(super) fn hopeless(
    chain: &Chain,
    worst: Worst,
    error: f64,
    functions: &[Function],
    (scalar, frame): (Real, Frame),
) -> Errors {
    let mut errors = chain.description.source.errors();
    let cause = Cause::of(chain, worst);
    let complaint = cause.complaint(
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
        complaint.place,
        complaint.message,
        format!("{hint}{}", solvable::at_the_end(chain)),
    );
    errors
}

/// What is doubtful about accelerations: the form that is asked for, instead of the one that would be
/// chosen; what all forms lose; and fields that must not be zero.
///
/// Where no function is named, a robot of many joints is not looked at: that takes as long as to generate
/// its mass matrix.
pub(crate) fn doubts(chain: &Chain, request: &Request) -> Vec<Complaint> {
    const UNASKED: usize = 40;
    let most = if request.functions.is_empty() {
        UNASKED
    } else {
        super::MOST
    };
    if chain.joints.len() > most {
        return Vec::new();
    }
    let items = request.items(false).into_iter();
    let items: Vec<Vec<Function>> = items
        .filter(|item| item.iter().any(|function| function.solves()))
        .collect();
    if items.is_empty() {
        return Vec::new();
    }
    // What is singular is refused, function by function.
    let Ok(worst) = solvable(chain) else {
        return Vec::new();
    };
    let of_items = items
        .iter()
        .filter_map(|functions| doubt(chain, worst, functions, request));
    (solvable::doubts(chain, worst).into_iter())
        .chain(of_items)
        .collect()
}

fn doubt(
    chain: &Chain,
    worst: Worst,
    functions: &[Function],
    request: &Request,
) -> Option<Complaint> {
    let (scalar, name) = (request.scalar, named(functions));
    // A loss below the cube root of 1/u is what a refinement brings back.
    let harmless = worst.loss * worst.loss * worst.loss * scalar.roundoff() < 1.0;
    let (error, most, by, hint) = if let Some(forward) = request.formulation.forward {
        // It is the form that is doubted, and not what a frame or a sum of angles costs.
        let way = Way {
            forward,
            ..Way::PLAIN
        };
        let error = least_error(chain, worst, functions, scalar, [way]).worst;
        let form = Formulation {
            forward: Some(forward),
            ..Formulation::default()
        };
        let by = format!("{name} with {}", form.words().concat());
        let hint = "leave the form to the engine".to_owned();
        (error, LIMIT, by, hint)
    } else if !harmless {
        let plain = match request.formulation.frame {
            Frame::Link => Way::PLAIN,
            Frame::Base => Way::IN_FRAME_0,
        };
        let forms = rounds(chain, functions, request.formulation).into_iter();
        let ways = forms.flatten().map(|form| form.along(plain));
        let off = least_error(chain, worst, functions, scalar, ways);
        // What no form helps is refused, function by function.
        let off = Some(off).filter(|off| keeps_half(off.eighth, scalar))?;
        let hint = Cause::of(chain, worst).remedy(Real::F32);
        (off.worst, DOUBTFUL, format!("{name} in any form"), hint)
    } else {
        return None;
    };
    let what = format!("{by} loses {}", lost(functions, error, scalar));
    (error > most).then(|| Complaint {
        hint: Some(hint),
        ..Cause::of(chain, worst).complaint(scalar, &what)
    })
}

/// The error that the first way leaves that is accurate enough, or else the best one: in the frames of
/// the description, for it is the form that decides.
fn least_error(
    chain: &Chain,
    worst: Worst,
    functions: &[Function],
    scalar: Real,
    ways: impl IntoIterator<Item = Way>,
) -> Off {
    let mut measure = Measure::of(chain, functions, worst.loss, scalar);
    let mut least = Off::INFINITE;
    for way in ways {
        let program = program_by(chain, functions, FrameId::FIRST, Layout::DESCRIBED, way);
        least = least.least(measure.error(&program));
        if least.worst <= ENOUGH {
            break;
        }
    }
    least
}

/// The cause of a loss of digits.
enum Cause<'c> {
    /// A joint at which a pivot of the mass matrix is small beside its diagonal entry, and their ratio.
    MassMatrix(&'c Joint, f64),
    /// A mimic joint that is much faster than the joint it mimics: forces have the square of its multiplier.
    Multiplier(&'c Mimicked, Place),
}

impl<'c> Cause<'c> {
    fn of(chain: &'c Chain, worst: Worst) -> Self {
        let fastest = chain.report.mimicked.iter();
        let square = |mimicked: &Mimicked| mimicked.multiplier * mimicked.multiplier;
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

    fn complaint(&self, scalar: Real, what: &str) -> Complaint {
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
                    quoted(&mimicked.leader),
                    mimicked.multiplier
                ),
            ),
        };
        Complaint {
            place,
            message: format!("{what}: {why}, and the unit roundoff is {roundoff:.0e}"),
            hint: None,
        }
    }

    fn remedy(&self, scalar: Real) -> String {
        let model = match self {
            Self::MassMatrix(..) => "model a robot whose masses and lengths differ less".to_owned(),
            Self::Multiplier(mimicked, _) => format!(
                "give joint {} the inertia of what turns so fast as a rotor or an armature",
                quoted(&mimicked.leader)
            ),
        };
        match scalar {
            Real::F32 => format!("generate it for f64, or {model}"),
            Real::F64 | Real::Generic => model,
        }
    }
}

/// How much of the largest result an error is, or may be of one function among others.
fn lost(functions: &[Function], error: f64, scalar: Real) -> String {
    let allowed = functions.iter().map(|&function| allowed(function));
    let share = error * allowed.fold(1.0, f64::max) * scalar.roundoff();
    if share < 0.1 {
        format!("{share:.0e} of its largest result")
    } else {
        "every digit".to_owned()
    }
}

/// The functions that solve something.
fn named(functions: &[Function]) -> String {
    let names = functions.iter().filter(|function| function.solves());
    list(names.map(|function| function.name()))
}

#[cfg(test)]
mod tests;
