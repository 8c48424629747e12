//! Functions of arrays: what a front end for arrays of states needs of a function beside its code, as data.
//!
//! In: a [`Module`]. Out: names, shapes, units and documentation of arguments and results; and programs whose results
//! stand in the order of those shapes. It prints nothing.
//!
//! The last axes of an array are those of one state. A 4×4 matrix is whole; what each joint has is a column, so that a
//! Jacobian is (6, n); six numbers that turn and move stand in one of two orders, in arguments as in results.

use super::documentation;
use super::steps::Step;
use crate::expression::Input;
use crate::function::Function;
use crate::module::{GeneratedFunction, Module, arguments};
use crate::schedule::Operand;
use crate::space::{ACTION, Entity, Outcome, Quantity, Space, Spaces, Variable};

/// Which of the halves of six numbers stands first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Order {
    /// v before ω, f before the couple, the linear momentum before the angular one.
    LinearFirst,
    /// The other way round, as programs have it.
    AngularFirst,
}

/// An argument or a result.
#[derive(Clone, Debug)]
pub struct Array {
    /// Its name.
    pub name: String,
    /// The lengths of its last axes.
    pub shape: Vec<usize>,
    /// How many numbers of a state a program reads or stores: fewer than the shape has where a row below them is constant.
    pub len: usize,
    /// The constant row below.
    pub below: Option<[f64; 4]>,
    /// The units of its numbers, each once, 1 where there is none.
    pub units: Vec<&'static str>,
}

/// A function without its program.
#[derive(Clone, Debug)]
pub struct Signature {
    /// Its name.
    pub name: &'static str,
    /// Its documentation, without arguments and results.
    pub about: Vec<String>,
    /// Its arguments, in their order.
    pub arguments: Vec<Array>,
    /// Its results; several have names of their own.
    pub results: Vec<Array>,
    /// Whether it is about a frame.
    pub of_a_frame: bool,
    /// Whether any argument or result has six numbers that turn and move.
    pub has_order: bool,
}

/// The signature of a function of a frame, whose name counts where the function is of one.
#[must_use]
pub fn signature(module: &Module, function: Function, frame: &str) -> Signature {
    let spaces = &module.spaces;
    let taken = arguments(&[function], spaces.actions() > 0);
    let parts = function.result().parts();
    let results = parts.map(|(name, quantity)| {
        let shape = shape(&quantity, spaces);
        Array {
            name: name.unwrap_or(function.name()).to_owned(),
            shape,
            len: quantity.size(spaces),
            below: below(quantity.entity),
            units: distinct(quantity.units(spaces)),
        }
    });
    let mut about = documentation::sentences(module, &[function], frame);
    let remarks = documentation::remarks(spaces, &[function]);
    about.extend((!remarks.is_empty()).then(String::new));
    about.extend(remarks);
    let six = |(_, quantity): (_, Quantity)| is_six(quantity.entity);
    Signature {
        name: function.name(),
        about,
        arguments: taken.iter().map(|&of| argument(of, spaces)).collect(),
        results: results.collect(),
        of_a_frame: function.of_a_frame(),
        has_order: taken.contains(&Variable::Actions) || function.result().parts().any(six),
    }
}

/// The signatures of the functions of configurations: integration, difference and normalisation.
pub fn steps(module: &Module) -> impl Iterator<Item = Signature> {
    let spaces = &module.spaces;
    let entries = |name: &str, space| {
        let variable = match space {
            Space::Coordinates => Variable::Q,
            _ => Variable::Qd,
        };
        Array {
            name: name.to_owned(),
            ..argument(variable, spaces)
        }
    };
    let steps = Step::ALL.into_iter().filter(|step| !step.arguments().is_empty());
    steps.map(move |step| Signature {
        name: step.name(),
        about: documentation::of_step(module, step, None),
        arguments: (step.arguments().iter())
            .map(|&(name, space)| entries(name, space))
            .collect(),
        results: vec![entries(step.name(), step.result())],
        of_a_frame: false,
        has_order: false,
    })
}

/// Puts results into the order of their shapes, and reads arguments in that order.
pub fn arrange(generated: &mut GeneratedFunction, spaces: &Spaces, order: Order) {
    let mut first = 0;
    let mut places = Vec::new();
    let results = generated.functions.iter().map(|function| function.result());
    for (_, quantity) in results.flat_map(Outcome::parts) {
        places.extend(arranged(&quantity, spaces, order).map(|place| first + place));
        first += quantity.size(spaces);
    }
    let program = &mut generated.program;
    program.results = places.into_iter().map(|place| program.results[place]).collect();
    if order == Order::AngularFirst {
        return;
    }
    let read = |operand: Operand| match operand {
        Operand::Input(Input::Variable(Variable::Actions, entry)) => {
            let each = u16::try_from(ACTION.len()).expect("six");
            let (action, entry) = (entry / each, entry % each);
            let entry = action * each + (entry + each / 2) % each;
            Operand::Input(Input::Variable(Variable::Actions, entry))
        }
        other => other,
    };
    for step in &mut program.steps {
        step.operation = step.operation.map(read);
    }
    for operand in program.angles.iter_mut().chain(&mut program.results) {
        *operand = read(*operand);
    }
}

/// Where in the results of a program each number of a quantity stands, in the order of its shape.
fn arranged(
    quantity: &Quantity,
    spaces: &Spaces,
    order: Order,
) -> impl Iterator<Item = usize> + use<> {
    let each = quantity.entity.size();
    let count = quantity.size(spaces) / each.max(1);
    let columns = has_columns(quantity);
    let half = match (is_six(quantity.entity), order) {
        (true, Order::LinearFirst) => each / 2,
        _ => 0,
    };
    (0..count * each).map(move |place| {
        let (entity, entry) = if columns {
            (place % count, place / count)
        } else {
            (place / each, place % each)
        };
        entity * each + (entry + half) % each
    })
}

/// Whether it is a column for each entry of a space.
fn has_columns(quantity: &Quantity) -> bool {
    matches!((quantity.over, quantity.entity.dimensions()), ([_], [_]))
}

/// Whether it is six numbers of which three turn.
const fn is_six(entity: Entity) -> bool {
    matches!(
        entity,
        Entity::Velocity | Entity::Momentum | Entity::Action | Entity::Screw
    )
}

fn shape(quantity: &Quantity, spaces: &Spaces) -> Vec<usize> {
    let mut shape = quantity.lengths(spaces);
    match (below(quantity.entity), quantity.entity.dimensions()) {
        (Some(_), _) => shape.extend([4, 4]),
        (None, &[rows]) if has_columns(quantity) => shape.insert(0, rows),
        (None, dimensions) => shape.extend(dimensions),
    }
    shape
}

/// The row below three that a program has.
const fn below(entity: Entity) -> Option<[f64; 4]> {
    match entity {
        Entity::Pose => Some([0.0, 0.0, 0.0, 1.0]),
        Entity::Acceleration => Some([0.0; 4]),
        _ => None,
    }
}

fn argument(of: Variable, spaces: &Spaces) -> Array {
    let entries = spaces.entries(of.space());
    let shape = match of {
        Variable::Actions => vec![spaces.actions(), ACTION.len()],
        _ => vec![entries.len()],
    };
    Array {
        name: of.name().to_owned(),
        shape,
        len: entries.len(),
        below: None,
        units: distinct(entries.iter().map(|entry| of.unit(entry.kind))),
    }
}

fn distinct(units: impl IntoIterator<Item = &'static str>) -> Vec<&'static str> {
    let mut found = Vec::new();
    for unit in units {
        if !found.contains(&unit) {
            found.push(unit);
        }
    }
    found
}
