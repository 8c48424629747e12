//! Functions of arrays: what a front end for arrays of states needs of a function beside its code, as data.
//!
//! In: a [`Module`]. Out: names, shapes, units and documentation of arguments and results; and programs whose results
//! stand in the order of those shapes. It prints nothing.
//!
//! The last axes of an array are those of one state. A 4×4 matrix is whole; what each joint has is a column, so that a
//! Jacobian is (6, n), and its derivatives are (n, 6, n), one after the other; six numbers that turn and move stand in
//! one of two orders, in arguments as in results.

use super::documentation;
use super::steps::ConfigurationFunction;
use crate::expression::Input;
use crate::function::Function;
use crate::module::{GeneratedFunction, Module, arguments};
use crate::schedule::{Operand, Program};
pub use crate::space::Order;
use crate::space::{ACTION, Outcome, Quantity, Space, Spaces, Variable};

/// An argument or a result.
#[derive(Clone, Debug)]
pub struct Array {
    /// Its name.
    pub name: String,
    /// The lengths of its last axes.
    pub shape: Vec<usize>,
    /// Numbers of a state that a program reads or stores: fewer than the shape has where a row below them is constant.
    pub len: usize,
    /// The constant row below.
    pub below: Option<[f64; 4]>,
    /// The units of its numbers, each once, 1 where there is none.
    pub units: Vec<&'static str>,
    /// True if it is zero where it is left out.
    pub is_change: bool,
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
    /// It is about a frame.
    pub of_a_frame: bool,
    /// An argument or a result has six numbers that turn and move.
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
            len: arranged(&quantity, spaces, Order::AngularFirst).count(),
            below: below(&quantity),
            units: distinct(quantity.units(spaces)),
            is_change: false,
        }
    });
    let mut about = documentation::sentences(module, &[function], frame);
    let remarks = documentation::remarks(spaces, &[function]);
    about.extend((!remarks.is_empty()).then(String::new));
    about.extend(remarks);
    Signature {
        name: function.name(),
        about,
        arguments: taken.iter().map(|&of| argument(of, spaces)).collect(),
        results: results.collect(),
        of_a_frame: function.of_a_frame(),
        has_order: has_order(function, &taken),
    }
}

/// True if an argument or a result of a function with such arguments has six numbers that turn and move.
#[must_use]
pub fn has_order(function: Function, arguments: &[Variable]) -> bool {
    let mut parts = function.result().parts();
    arguments.iter().any(|of| of.has_wrenches())
        || parts.any(|(_, part)| part.entity.halves().is_some())
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
    let steps = ConfigurationFunction::ALL
        .into_iter()
        .filter(|step| !step.arguments().is_empty());
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
    arrange_results(generated, spaces, order);
    if order == Order::LinearFirst {
        read_linear_first(&mut generated.program);
    }
}

/// Puts results into the order of their shapes, with a fourth row below each of several matrices.
pub fn arrange_results(generated: &mut GeneratedFunction, spaces: &Spaces, order: Order) {
    let mut first = 0;
    let mut places: Vec<NumberSource> = Vec::new();
    let results = generated.functions.iter().map(|function| function.result());
    for (_, quantity) in results.flat_map(Outcome::parts) {
        let own = arranged(&quantity, spaces, order);
        places.extend(own.map(|source| match source {
            NumberSource::Result(place) => NumberSource::Result(first + place),
            constant @ NumberSource::Constant(_) => constant,
        }));
        first += quantity.size(spaces);
    }
    let program = &mut generated.program;
    program.results = places
        .into_iter()
        .map(|source| match source {
            NumberSource::Result(place) => program.results[place],
            NumberSource::Constant(value) => Operand::Literal(value),
        })
        .collect();
}

/// Reads wrenches with the force first.
fn read_linear_first(program: &mut Program) {
    let read = |operand: Operand| match operand {
        Operand::Input(Input::Variable(of, entry)) if of.has_wrenches() => {
            let entry = Order::LinearFirst.place(usize::from(entry));
            let entry = u16::try_from(entry).expect("of the same wrench");
            Operand::Input(Input::Variable(of, entry))
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

/// Source of a number of an array.
#[derive(Clone, Copy, Debug, PartialEq)]
enum NumberSource {
    /// An index into the results of a program.
    Result(usize),
    /// A number of the fourth row of a matrix.
    Constant(f64),
}

/// The numbers that are stored of a quantity, in the order of its shape.
fn arranged(
    quantity: &Quantity,
    spaces: &Spaces,
    order: Order,
) -> impl Iterator<Item = NumberSource> + use<> {
    let each = quantity.entity.size();
    let row = quantity
        .entity
        .fourth_row()
        .filter(|_| !quantity.over.is_empty());
    in_order(quantity, spaces, order).flat_map(move |place| {
        let is_last = place % each == each - 1;
        let row = row.filter(|_| is_last).into_iter().flatten();
        std::iter::once(NumberSource::Result(place)).chain(row.map(NumberSource::Constant))
    })
}

/// Indices into the results of a program, in the order of the shape of a quantity.
fn in_order(
    quantity: &Quantity,
    spaces: &Spaces,
    order: Order,
) -> impl Iterator<Item = usize> + use<> {
    let each = quantity.entity.size();
    let count = quantity.size(spaces) / each.max(1);
    let columns = quantity.over.last().filter(|_| has_columns(quantity));
    let columns = columns.map(|&space| spaces.len(space));
    let order = (quantity.entity.halves()).map_or(Order::AngularFirst, |_| order);
    (0..count * each).map(move |place| {
        let (entity, entry) = match columns {
            Some(columns) => {
                let (matrix, within) = (place / (each * columns), place % (each * columns));
                (matrix * columns + within % columns, within / columns)
            }
            None => (place / each, place % each),
        };
        order.place(entity * each + entry)
    })
}

/// True for matrices with a column for each velocity, the last space; points of several spheres are rows.
pub(super) fn has_columns(quantity: &Quantity) -> bool {
    matches!(
        (quantity.over, quantity.entity.dimensions()),
        ([.., Space::Velocities], [_])
    )
}

fn shape(quantity: &Quantity, spaces: &Spaces) -> Vec<usize> {
    let mut shape = quantity.lengths(spaces);
    match (quantity.entity.fourth_row(), quantity.entity.dimensions()) {
        (Some(_), _) => shape.extend([4, 4]),
        (None, &[rows]) if has_columns(quantity) => shape.insert(shape.len() - 1, rows),
        (None, dimensions) => shape.extend(dimensions),
    }
    shape
}

/// The row below the results of a single matrix, of which a program has three rows.
pub(super) fn below(quantity: &Quantity) -> Option<[f64; 4]> {
    quantity
        .entity
        .fourth_row()
        .filter(|_| quantity.over.is_empty())
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
        is_change: of.is_change(),
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::description;
    use crate::error::Errors;
    use crate::expand::{expand, understand, without_functions};
    use crate::request::Request;

    /// A robot with such an external force, and the function if one is named.
    fn robot(file: &str, functions: &[Function], external: &[&str]) -> Module {
        let path = format!("{}/../robots/{file}", env!("CARGO_MANIFEST_DIR"));
        let description = description::read_file(path.as_ref(), None, &mut Errors::new());
        let description = description.expect("a robot that ships");
        let request = Request {
            functions: vec![functions.to_vec()],
            external: external.iter().map(|&link| link.into()).collect(),
            ..Request::default()
        };
        if functions.is_empty() {
            let request = Request {
                functions: Vec::new(),
                ..request
            };
            return without_functions(&understand(&description, &request).expect("no mistakes"));
        }
        expand(&description, &request).expect("no mistakes")
    }

    fn shapes(arrays: &[Array]) -> Vec<(&str, &[usize])> {
        let shapes = arrays.iter();
        shapes
            .map(|of| (of.name.as_str(), of.shape.as_slice()))
            .collect()
    }

    #[test]
    fn shapes_are_those_of_matrices_with_a_column_for_each_joint() {
        let module = robot("two_link.urdf", &[], &["fore"]);
        let of = |function| signature(&module, function, "tip");
        let jacobian = of(Function::SpatialJacobian);
        assert_eq!(
            shapes(&jacobian.results),
            [("spatial_jacobian", &[6, 2][..])]
        );
        assert!(jacobian.of_a_frame && jacobian.has_order);
        let by_q = of(Function::JacobianDerivative);
        assert_eq!(
            shapes(&by_q.results),
            [("jacobian_derivative", &[2, 6, 2][..])]
        );
        let pose = of(Function::ForwardKinematics);
        assert_eq!(shapes(&pose.results), [("forward_kinematics", &[4, 4][..])]);
        assert_eq!(pose.results[0].len, 12);
        assert_eq!(pose.results[0].below, Some([0.0, 0.0, 0.0, 1.0]));
        let point = of(Function::CenterOfMassJacobian);
        assert_eq!(
            shapes(&point.results),
            [("center_of_mass_jacobian", &[3, 2][..])]
        );
        assert!(!point.has_order);
        let derivatives = of(Function::InverseDynamicsDerivatives);
        assert_eq!(
            shapes(&derivatives.results),
            [("dq", &[2, 2][..]), ("dqd", &[2, 2][..])]
        );
        let dynamics = of(Function::InverseDynamics);
        assert_eq!(
            shapes(&dynamics.arguments),
            [
                ("q", &[2][..]),
                ("qd", &[2]),
                ("qdd", &[2]),
                ("actions", &[1, 6])
            ]
        );
        assert_eq!(dynamics.arguments[3].units, ["N m", "N"]);
        assert!(dynamics.has_order && !dynamics.of_a_frame);
        assert_eq!(of(Function::KineticEnergy).results[0].shape, [0; 0]);
    }

    #[test]
    fn steps_are_over_coordinates_and_velocities_of_any_robot() {
        let module = robot("two_link.urdf", &[], &[]);
        let steps: Vec<Signature> = steps(&module).collect();
        let names = steps.iter().map(|step| step.name).collect::<Vec<_>>();
        assert_eq!(names, ["integrate", "difference", "normalize"]);
        assert_eq!(shapes(&steps[0].arguments), [("q", &[2][..]), ("v", &[2])]);
        assert_eq!(shapes(&steps[1].results), [("difference", &[2][..])]);
    }

    #[test]
    fn results_are_put_in_the_order_of_their_shapes() {
        let module = robot("two_link.urdf", &[Function::SpatialJacobian], &[]);
        let [generated] = &module.functions[..] else {
            panic!("one function");
        };
        let arranged = |order| {
            let mut generated = generated.clone();
            arrange(&mut generated, &module.spaces, order);
            generated.program.results
        };
        let (before, angular) = (&generated.program.results, arranged(Order::AngularFirst));
        let by_rows = (0..6).flat_map(|row| [before[row], before[6 + row]]);
        assert_eq!(angular, by_rows.collect::<Vec<_>>());
        let linear = arranged(Order::LinearFirst);
        assert_eq!(linear, [&angular[6..], &angular[..6]].concat());
    }

    #[test]
    fn matrices_follow_one_another_with_their_columns() {
        let module = robot("two_link.urdf", &[], &[]);
        let (_, quantity) = (Function::JacobianDerivative.result().parts().next()).unwrap();
        let places = in_order(&quantity, &module.spaces, Order::AngularFirst);
        let matrix = |first: usize| (0..6).flat_map(move |row| [first + row, first + 6 + row]);
        let expected: Vec<usize> = matrix(0).chain(matrix(12)).collect();
        assert_eq!(places.collect::<Vec<_>>(), expected);
    }

    #[test]
    fn several_matrices_are_complete() {
        let module = robot("two_link.urdf", &[Function::FramePoses], &[]);
        let of = signature(&module, Function::FramePoses, "tip");
        assert_eq!(shapes(&of.results), [("frame_poses", &[1, 4, 4][..])]);
        assert_eq!((of.results[0].len, of.results[0].below), (16, None));
        let mut generated = module.functions[0].clone();
        let before = generated.program.results.clone();
        arrange(&mut generated, &module.spaces, Order::AngularFirst);
        let row = [0.0, 0.0, 0.0, 1.0].map(Operand::Literal);
        assert_eq!(generated.program.results, [&before[..], &row].concat());
    }

    #[test]
    fn forces_from_outside_are_read_in_the_order_that_is_asked_for() {
        let module = robot("two_link.urdf", &[Function::InverseDynamics], &["fore"]);
        let read = |order| {
            let mut generated = module.functions[0].clone();
            arrange(&mut generated, &module.spaces, order);
            let operands = generated.program.operands().collect::<Vec<_>>();
            let entries = operands.into_iter().filter_map(|operand| match operand {
                Operand::Input(Input::Variable(Variable::Actions, entry)) => Some(entry),
                _ => None,
            });
            entries.collect::<Vec<u16>>()
        };
        let linear = read(Order::LinearFirst);
        let swapped = linear.iter().map(|entry| (entry + 3) % 6);
        assert!(!linear.is_empty());
        assert_eq!(swapped.collect::<Vec<_>>(), read(Order::AngularFirst));
    }
}
