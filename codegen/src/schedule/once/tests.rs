//! Separated programs compute the same as whole ones.

use super::{SeparatedPrograms, part};
use crate::expression::{Block, Component, Input, LabelledBodies, Numeral};
use crate::schedule::{Operand, Operation, Program, Step, run};
use crate::space::Variable;

const Q: Operand = Operand::Input(Input::Variable(Variable::Q, 0));
const MASS: Operand = Operand::Input(Input::Parameter(0, 0));
const TURN: Operand = Operand::Input(Input::Parameter(1, 2));

fn program(
    steps: &[Operation],
    before_angles: usize,
    angles: &[Operand],
    results: &[Operand],
) -> Program {
    let steps = steps.iter().map(|&operation| Step {
        label: Some(
            Block::Pivot
                .of(LabelledBodies::Body(Numeral(1)))
                .entry(Component::Scalar),
        ),
        operation,
    });
    Program {
        angles: angles.to_vec(),
        before_angles,
        steps: steps.collect(),
        results: results.to_vec(),
        ..Program::default()
    }
}

/// m² s(2 t) s(q + 2 t), and the mass itself.
fn first() -> Program {
    program(
        &[
            Operation::Mul(Operand::Literal(2.0), TURN),
            Operation::Add(Q, Operand::Step(0)),
            Operation::Mul(MASS, MASS),
            Operation::Mul(Operand::Step(2), Operand::Sin(0)),
            Operation::Mul(Operand::Step(3), Operand::Sin(1)),
        ],
        2,
        &[Operand::Step(0), Operand::Step(1)],
        &[Operand::Step(4), MASS],
    )
}

/// q + m² + m, c(m²): steps that follow the angles in the other program precede them here.
fn second() -> Program {
    program(
        &[
            Operation::Mul(MASS, MASS),
            Operation::Add(Operand::Step(0), MASS),
            Operation::Add(Q, Operand::Step(1)),
        ],
        1,
        &[Operand::Step(0)],
        &[Operand::Step(2), Operand::Cos(0), Operand::Literal(3.0)],
    )
}

fn parts() -> SeparatedPrograms {
    let fields = [
        vec!["mass".to_owned()],
        ["x", "y", "z"].map(str::to_owned).to_vec(),
    ];
    part(&[&first(), &second()], &fields)
}

#[test]
fn results_keep_their_bits() {
    let SeparatedPrograms { once, each, .. } = parts();
    for (q, mass, turn) in [
        (0.3, 1.7, -0.4),
        (1e9, -2.5, 3.0),
        (f64::INFINITY, 0.1, 0.2),
    ] {
        let state = |input| match input {
            Input::Variable(..) => q,
            Input::Parameter(0, 0) => mass,
            Input::Parameter(..) => turn,
        };
        let values = run(&once, state);
        for (whole, left) in [first(), second()].iter().zip(&each) {
            let found = run(left, |input| match input {
                Input::Parameter(0, value) => values[usize::from(value)],
                Input::Parameter(..) => panic!("another field"),
                Input::Variable(..) => q,
            });
            let bits =
                |results: Vec<f64>| results.into_iter().map(f64::to_bits).collect::<Vec<_>>();
            assert_eq!(bits(found), bits(run(whole, state)));
        }
    }
}

#[test]
fn shared_work_is_computed_once() {
    let SeparatedPrograms { once, names, each } = parts();
    // 2 t, m², m² s(2 t), m² + m.
    assert_eq!(once.steps.len(), 4);
    assert_eq!(once.angles.len(), 2);
    let left: Vec<_> = each
        .iter()
        .map(|left| (left.steps.len(), left.angles.len()))
        .collect();
    assert_eq!(left, [(2, 1), (1, 0)]);
    assert_eq!((each[0].before_angles, each[1].before_angles), (1, 0));
    // 2 t, m² s(2 t), m; m² + m, c(m²).
    assert_eq!(names, ["d_1", "d_1_2", "mass", "d_1_3", "cosine"]);
    assert_eq!(once.results.len(), names.len());
    assert_eq!(each[1].results[2], Operand::Literal(3.0));
}

#[test]
fn nothing_moves_without_fields() {
    let bare = program(
        &[Operation::Mul(Operand::Sin(0), Q)],
        0,
        &[Q],
        &[Operand::Step(0)],
    );
    let SeparatedPrograms { once, names, each } = part(&[&bare], &[]);
    assert!(once.steps.is_empty() && names.is_empty());
    assert_eq!(each[0].steps.len(), 1);
    assert_eq!(each[0].angles, [Q]);
}
