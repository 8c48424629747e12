//! What a routine is called and made of.

use super::{Angle, Names, Readable, Routine, Statement, Value};
use crate::expression::Input;
use crate::schedule::{Length, Operand, Operation, Program, Step};
use crate::space::{Entry, Kind, Spaces, Variable};

fn name(name: &str) -> Value {
    Value::Name(name.to_owned())
}

/// q₁ + q₂, and c₁₂ (0.5 s₁ + m) of a field whose other entry is not read.
fn program() -> Program {
    let q = [0, 1].map(|joint| Operand::Input(Input::Variable(Variable::Q, joint)));
    let mass = Operand::Input(Input::Parameter(1, 1));
    let step = |label: Option<&str>, operation| Step {
        label: label.map(str::to_owned),
        operation,
    };
    Program {
        angles: vec![q[0], Operand::Step(0)],
        before_angles: 1,
        steps: vec![
            step(None, Operation::Add(q[1], q[0])),
            step(
                None,
                Operation::MulAdd(Operand::Literal(0.5), Operand::Sin(0), mass),
            ),
            step(
                Some("phi"),
                Operation::Mul(Operand::Cos(1), Operand::Step(1)),
            ),
        ],
        results: vec![Operand::Step(2), Operand::Literal(0.0)],
    }
}

fn routine(names: Names) -> Routine {
    let entry = |name: &str| Entry {
        name: name.to_owned(),
        kind: Kind::Turn,
        range: None,
    };
    let spaces = Spaces {
        actions: Vec::new(),
        coordinates: ["hip", "knee", "toe"].into_iter().map(entry).collect(),
        constraints: Vec::new(),
        velocities: vec![entry("hip")].into(),
        ..Spaces::default()
    };
    let fields = [vec!["load"], vec!["t_1", "qd"]];
    let fields = fields.map(|wishes| wishes.into_iter().map(str::to_owned).collect());
    let readable = Readable {
        arguments: &[Variable::Q, Variable::Qd],
        spaces: &spaces,
        fields: &fields,
    };
    Routine::of((&program(), Length::UNBOUNDED), &readable, names)
}

#[test]
fn what_is_read_has_a_name_and_nothing_else() {
    let routine = routine(Names::beside(&["q_2", "phi"]));
    let some = |name: &str| Some(name.to_owned());
    let arguments = [
        (Variable::Q, vec![some("q_1"), some("q_2_"), None]),
        (Variable::Qd, vec![None]),
    ];
    assert_eq!(routine.arguments, arguments);
    // The name of an argument is not given away.
    assert_eq!(routine.fields, [vec![None], vec![None, some("qd_")]]);
    let operation = |name: &str, of| Statement::Operation(name.to_owned(), of);
    let angle = |value, sine, cosine| Angle {
        value,
        sine,
        cosine,
    };
    let half = Value::Literal(0.5);
    let statements = [
        operation("q_1_2", Operation::Add(name("q_2_"), name("q_1"))),
        Statement::SinesAndCosines(vec![
            angle(name("q_1"), some("s_1"), None),
            angle(name("q_1_2"), None, some("c_1_2")),
        ]),
        operation("t_1", Operation::MulAdd(half, name("s_1"), name("qd_"))),
        operation("phi_", Operation::Mul(name("c_1_2"), name("t_1"))),
    ];
    assert_eq!(routine.statements, statements);
    assert_eq!(routine.results, [name("phi_"), Value::Literal(0.0)]);
    assert!(routine.has_literals && routine.is_fused);
    // What a language binds besides has a name of its own.
    let mut names = routine.names;
    assert_eq!(
        ["t_1", "t_2"].map(|wish| names.fresh(wish)),
        ["t_1_", "t_2"]
    );
}
