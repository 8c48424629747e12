//! Gravity torques: inverse dynamics at rest.

use super::definition::{Definition, Property, Truth};
use super::quantities;
use super::tally::{ACTION, INERTIA, KINEMATIC, Size, Tally};
use crate::dense::MotionOrder;
use crate::expression::Term;
use crate::model::{Scene, gravity};
use crate::space::Variable;

pub(super) const DEFINITION: Definition = Definition {
    name: "gravity",
    sentence,
    arguments: &[Variable::Q],
    result: quantities::FORCES,
    properties: &[Property::Mass],
    truth: Truth::Value(|dense, _| dense.torques(MotionOrder::Rest).into()),
    algorithms: Definition::one_way,
    dense,
    build,
};

fn sentence(_: &str, _: &str) -> String {
    "Joint torques and forces τ that hold the robot at rest against gravity; N m, N.".to_owned()
}

fn dense(size: Size) -> Tally {
    KINEMATIC.plus(INERTIA).plus(ACTION).times(size.joints)
}

fn build<'g>(scene: &Scene<'_, 'g>) -> Vec<Term<'g>> {
    let driving = gravity::gravity(&scene.joints(), scene.gravity, &scene.state);
    scene.forces(&driving).into()
}
