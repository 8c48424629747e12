//! Text of hand-made modules, as users of the command see it.

use super::{PythonOptions, print};
use crate::function::Function;
use crate::module::Module;
use crate::print::arrays::Order;
use crate::print::rust::tests::{generated, literal, module, step, with_payload};
use crate::real::Real;
use crate::schedule::{Operand, Operation, Program};

fn written(module: &Module) -> String {
    let asked = "Made by hand.";
    let order = Order::LinearFirst;
    print(module, &PythonOptions { asked, order })
}

/// Lines of a function from its documentation's end.
fn body<'t>(text: &'t str, name: &str) -> &'t str {
    let at = text.find(&format!("def {name}(")).expect("the function");
    let end = text[at..]
        .find("\n\n\n")
        .map_or(text.len(), |end| at + end + 1);
    let (_, body) = text[at..end]
        .rsplit_once("\"\"\"\n")
        .expect("documentation");
    body
}

/// A gravity function with these operations, whose results are the last and a number.
fn steps(operations: &[Operation]) -> Module {
    let last = u32::try_from(operations.len() - 1).expect("few steps");
    let program = Program {
        steps: operations.iter().map(|&of| step(None, of)).collect(),
        results: vec![Operand::Step(last), literal(-0.5)],
        ..Program::default()
    };
    Module {
        functions: vec![generated(&[Function::Gravity], program)],
        ..module(Real::F64)
    }
}

#[test]
fn a_function_reads_its_arguments_once_and_returns_a_list() {
    let text = written(&module(Real::F64));
    let expected = "    q_1, q_2 = (q[k] for k in range(2))
    q_1_2 = q_1 + q_2
    c_1 = library.cos(q_1)
    c_1_2 = library.cos(q_1_2)
    d_2 = 0.5 * 2.4525 * c_1_2
    d_1 = 9.81 * c_1 + d_2
    return [d_1, d_2]
";
    assert_eq!(body(&text, "gravity"), expected);
    assert!(
        text.contains("def gravity(q, library=math):\n    \"\"\""),
        "{text}"
    );
    assert!(text.contains("\n    Returns a list of 2.\n"), "{text}");
    assert!(
        text.contains("\nimport math\n\n#: Number of coordinates.\nNQ = 2\n"),
        "{text}"
    );
}

#[test]
fn fields_are_keywords() {
    let text = written(&with_payload(module(Real::F64)));
    assert!(
        text.contains("def gravity(q, library=math, *, payload):"),
        "{text}"
    );
    assert!(
        body(&text, "gravity").contains("payload * 2.4525"),
        "{text}"
    );
}

#[test]
fn products_and_sums_are_apart_and_signs_are_a_function() {
    let [a, b, c] = [2.0, -3.0, 4.0].map(literal);
    let first = Operand::Step(0);
    let text = written(&steps(&[
        Operation::NegMulAdd(a, b, c),
        Operation::MulSub(first, b, c),
        Operation::Neg(b),
        Operation::Sign(first),
        Operation::Sqrt(first),
    ]));
    let expected = "    t_1 = 4.0 - 2.0 * -3.0
    t_2 = t_1 * -3.0 - 4.0
    t_3 = -(-3.0)
    t_4 = _sign(t_1, library)
    t_5 = library.sqrt(t_1)
    return [t_5, -0.5]
";
    assert_eq!(body(&text, "gravity"), expected);
    assert!(text.contains("def _sign(a, library):"), "{text}");
    assert!(!written(&module(Real::F64)).contains("_sign"));
}
