//! All words of the grammar, by the place where they are allowed, for tests of the documentation.

use super::inline::{body, closure as loops, composite, joint as joints, table};
use super::{attributes, denavit_hartenberg, settings};
use crate::formulation;
use crate::function::Function;
use crate::joint::actuator::ActuatorQuantity;
use crate::processor::Processor;
use crate::real::Real;
use crate::{closure, joint};

/// The place where words are allowed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GrammarPlace {
    /// In `#[robot(…)]` above a struct, and in the braces of `chain!`.
    Robot,
    /// In `#[robot(…)]` on a field.
    Field,
    /// In the braces of a link.
    Link,
    /// In the braces of a joint.
    Joint,
    /// After the colon of a joint.
    JointType,
    /// After `at:`.
    Step,
    /// In the braces of a loop.
    Loop,
    /// After the colon of a loop.
    LoopType,
    /// In the braces of a row of a table.
    Row,
    /// In the first line of a table in a file.
    Column,
    /// In `generate(…)`.
    Function,
    /// After `scalar`.
    Scalar,
    /// In `formulation(…)`.
    Formulation,
    /// After `processor`.
    Processor,
}

/// The words of each place.
#[must_use]
pub fn words() -> Vec<(GrammarPlace, Vec<&'static str>)> {
    let actuators = ActuatorQuantity::ALL.map(ActuatorQuantity::word);
    let joint = joints::KEYS.into_iter().chain(actuators).collect();
    let kinds = joint::ALL.map(|kind| kind.word).into_iter();
    vec![
        (GrammarPlace::Robot, settings::words()),
        (GrammarPlace::Field, attributes::keys()),
        (GrammarPlace::Link, body::INERTIA.to_vec()),
        (GrammarPlace::Joint, joint),
        (
            GrammarPlace::JointType,
            kinds.chain([composite::WORD]).collect(),
        ),
        (GrammarPlace::Step, joints::STEPS.to_vec()),
        (GrammarPlace::Loop, loops::KEYS.to_vec()),
        (
            GrammarPlace::LoopType,
            closure::ALL.map(|kind| kind.word).to_vec(),
        ),
        (GrammarPlace::Row, table::KEYS.to_vec()),
        (GrammarPlace::Column, denavit_hartenberg::COLUMNS.to_vec()),
        (GrammarPlace::Function, Function::names()),
        (GrammarPlace::Scalar, Real::ALL.map(Real::name).to_vec()),
        (GrammarPlace::Formulation, formulation::words()),
        (
            GrammarPlace::Processor,
            Processor::ALL.map(Processor::name).to_vec(),
        ),
    ]
}
