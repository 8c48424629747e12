//! Large matrices of numbers, whose entries are stored as soon as they are computed.
//!
//! In: functions. Out: the length of their rows. Otherwise hundreds of results would wait on the stack for the end of the
//! function, since compilers do not move stores forward that far.

use crate::function::Function;
use crate::schedule::LONGEST_SCOPE;
use crate::space::{Entity, Outcome, Spaces};

/// Row length of the result of `functions` if it is a matrix with more numbers than a scope has; `None` for solutions,
/// since their entries are read again.
pub(super) fn columns(functions: &[Function], spaces: &Spaces) -> Option<usize> {
    let [function] = functions else {
        return None;
    };
    let Outcome::One(quantity) = function.result() else {
        return None;
    };
    let has_numbers = quantity.entity == Entity::Number;
    if !has_numbers || function.solves() || function.is_constrained() {
        return None;
    }
    let [rows, columns] = quantity.lengths(spaces)[..] else {
        return None;
    };
    (rows * columns > LONGEST_SCOPE).then_some(columns)
}

#[cfg(test)]
mod tests {
    use super::columns;
    use crate::chain;
    use crate::description;
    use crate::error::Errors;
    use crate::function::Function;
    use crate::request::Request;
    use crate::space::Spaces;

    fn spaces(robot: &str, request: &Request) -> Spaces {
        let path = format!("{}/../robots/{robot}.urdf", env!("CARGO_MANIFEST_DIR"));
        let description = description::read_file(path.as_ref(), None, &mut Errors::new());
        let description = description.expect("a robot that ships");
        let chain = chain::build(&description, request).expect("no mistakes");
        chain.identified().spaces().clone()
    }

    #[test]
    fn large_matrices_are_filled_early_unless_they_are_solutions() {
        let fixed = Request::default();
        let [two_link, ur5, quadruped] =
            ["two_link", "ur5_class", "quadruped"].map(|robot| spaces(robot, &fixed));
        let floating = Request {
            floating: true,
            ..fixed
        };
        let free = spaces("quadruped", &floating);
        assert_eq!(columns(&[Function::Regressor], &ur5), Some(60));
        assert_eq!(columns(&[Function::BaseRegressor], &ur5), Some(36));
        assert_eq!(columns(&[Function::Regressor], &two_link), None);
        assert_eq!(
            columns(&[Function::Regressor, Function::Gravity], &ur5),
            None
        );
        assert_eq!(columns(&[Function::InverseDynamicsDerivatives], &ur5), None);
        for function in [Function::MassMatrix, Function::CoriolisMatrix] {
            assert_eq!(columns(&[function], &free), Some(18));
            assert_eq!(columns(&[function], &quadruped), None);
        }
        assert_eq!(columns(&[Function::MassMatrixInverse], &free), None);
        assert_eq!(columns(&[Function::JacobianDerivative], &free), None);
    }
}
