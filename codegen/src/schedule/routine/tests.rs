//! Names and structure of routines.

use super::{Angle, Meaning, Names, Readable, RotationAngle, Routine, Statement, Stored, Value};
use crate::expression::{Block, Component, Input, LabelledBodies, Numeral};
use crate::schedule::{Length, Operand, Operation, Program, Step};
use crate::space::{Entry, Kind, Spaces, Variable};

fn name(name: &str) -> Value {
    Value::Name(name.to_owned())
}

/// q₁ + q₂, and c₁₂ (0.5 s₁ + m) of a field whose other entry is not read.
fn program() -> Program {
    let q = [0, 1].map(|joint| Operand::Input(Input::Variable(Variable::Q, joint)));
    let mass = Operand::Input(Input::Parameter(1, 1));
    let step = |label, operation| Step { label, operation };
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
                Some(
                    Block::Pivot
                        .of(LabelledBodies::Body(Numeral(2)))
                        .entry(Component::Scalar),
                ),
                Operation::Mul(Operand::Cos(1), Operand::Step(1)),
            ),
        ],
        results: vec![Operand::Step(2), Operand::Literal(0.0)],
        ..Program::default()
    }
}

fn routine(names: Names, stored: Stored) -> Routine {
    let entry = |name: &str| Entry {
        name: name.to_owned(),
        kind: Kind::Rotation,
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
        limbs: &[],
        fields: &fields,
    };
    Routine::of((&program(), Length::UNBOUNDED), &readable, names, stored)
}

#[test]
fn only_values_that_are_read_have_names() {
    let routine = routine(Names::beside(&["q_2", "d_2"]), Stored::AtTheEnd);
    let some = |name: &str| Some(name.to_owned());
    let arguments = [
        (Variable::Q, vec![some("q_1"), some("q_2_"), None]),
        (Variable::Qd, vec![None]),
    ];
    assert_eq!(routine.arguments, arguments);
    // The name of an argument is used for nothing else.
    assert_eq!(routine.fields, [vec![None], vec![None, some("qd_")]]);
    let operation = |name: &str, of| Statement::Operation(name.to_owned(), of);
    let angle = |value, sine, cosine| Angle {
        value,
        sine,
        cosine,
    };
    // A value without a meaning that is read once is written where it is read.
    let part = Operation::MulAdd(Value::Literal(0.5), name("s_1"), name("qd_"));
    let part = Value::Operation(Box::new(part));
    let statements = [
        operation("q_1_2", Operation::Add(name("q_2_"), name("q_1"))),
        Statement::SinesAndCosines(vec![
            angle(name("q_1"), some("s_1"), None),
            angle(name("q_1_2"), None, some("c_1_2")),
        ]),
        operation("d_2_", Operation::Mul(name("c_1_2"), part)),
    ];
    assert_eq!(routine.statements, statements);
    assert_eq!(routine.results, [name("d_2_"), Value::Literal(0.0)]);
    assert!(routine.has_literals && routine.is_fused);
    let turn = |name: &str, coordinates: &[u16]| RotationAngle {
        name: name.to_owned(),
        coordinates: coordinates.to_vec(),
    };
    let pivot = Block::Pivot.of(LabelledBodies::Body(Numeral(2)));
    let meanings = [
        ("q_1", Meaning::Argument(Variable::Q, 0)),
        ("q_2_", Meaning::Argument(Variable::Q, 1)),
        ("q_1_2", Meaning::Sum(vec![0, 1])),
        ("s_1", Meaning::Sine(turn("q_1", &[0]))),
        ("c_1_2", Meaning::Cosine(turn("q_1_2", &[0, 1]))),
        ("d_2_", Meaning::Entry(pivot.entry(Component::Scalar))),
    ];
    let meanings = meanings.map(|(name, meaning)| (name.to_owned(), meaning));
    assert_eq!(routine.meanings, meanings);
    // Further names of a language are unique.
    let mut names = routine.names;
    assert_eq!(
        ["c_1_2", "c_1"].map(|wish| names.fresh(wish)),
        ["c_1_2_", "c_1"]
    );
}

#[test]
fn results_are_stored_early_on_request() {
    let names = || Names::beside(&[]);
    let at_the_end = routine(names(), Stored::AtTheEnd);
    assert!(at_the_end.stored.is_empty());
    let mut as_found = routine(names(), Stored::Early);
    assert_eq!(as_found.results, at_the_end.results);
    // A literal is in the array from the start.
    assert_eq!(as_found.stored, [0].into());
    let last = as_found.statements.pop();
    assert_eq!(last, Some(Statement::StoreResult(0, name("d_2"))));
    assert_eq!(as_found.statements, at_the_end.statements);
}

/// Routine of a program that reads the angle of a hinge.
fn of_a_hinge(program: (&Program, Length), names: Names, stored: Stored) -> Routine {
    let entry = Entry {
        name: "hip".to_owned(),
        kind: Kind::Rotation,
        range: None,
    };
    let spaces = Spaces {
        coordinates: vec![entry].into(),
        ..Spaces::default()
    };
    let readable = Readable {
        arguments: &[Variable::Q],
        spaces: &spaces,
        limbs: &[],
        fields: &[],
    };
    Routine::of(program, &readable, names, stored)
}

/// The sine of q₁, and a chain of steps that are all results.
#[test]
fn a_stored_result_is_not_returned_by_its_block() {
    let steps = 1000_u32;
    let q = Operand::Input(Input::Variable(Variable::Q, 0));
    let operation = |k: u32| match k {
        0 => Operation::Mul(Operand::Literal(0.5), Operand::Sin(0)),
        k => Operation::Mul(Operand::Cos(0), Operand::Step(k - 1)),
    };
    let program = Program {
        angles: vec![q],
        before_angles: 0,
        steps: (0..steps)
            .map(|k| Step {
                label: None,
                operation: operation(k),
            })
            .collect(),
        results: std::iter::once(Operand::Sin(0))
            .chain((0..steps).map(Operand::Step))
            .collect(),
        ..Program::default()
    };
    let outputs = |stored| {
        let names = Names::beside(&[]);
        let routine = of_a_hinge((&program, Length::UNBOUNDED), names, stored);
        let outputs = |statement: &Statement| match statement {
            Statement::Block { outputs, .. } => outputs.len(),
            _ => 0,
        };
        let blocks: usize = routine.statements.iter().map(outputs).sum();
        (blocks, routine.stored.len())
    };
    assert_eq!(outputs(Stored::AtTheEnd), (1000, 0));
    let (blocks, stored) = outputs(Stored::Early);
    // The next block reads only the last step of each block.
    assert!((1..20).contains(&blocks), "{blocks}");
    assert_eq!(stored, 1001);
}
