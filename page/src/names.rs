//! Meanings of names in generated code, as data of the page: the matrix of the paper, its bodies, its frame, and the
//! entry; the matrices with their equations, and a sentence for each quantity.

use serde_json::{Map, Value, json};

use homogen_codegen::expression::{Block, Component, Label, LabelledBodies, Numeral, Quantity};
use homogen_codegen::schedule::{Meaning, RotationAngle};
use homogen_codegen::space::{Variable, action_entry};

/// A matrix of the paper.
struct Matrix {
    letter: &'static str,
    noun: &'static str,
    /// Its entries, by rows.
    cells: [&'static str; 16],
    /// Its definition, with the number of the equation.
    is: &'static str,
    /// Its change from link to link and of frames.
    moves: &'static str,
}

/// A kind of quantity: `{i}` and `{k}` stand for its two numbers.
struct QuantityKind {
    /// True for a quantity of this kind.
    fits: fn(Quantity) -> bool,
    /// The letter of its matrix; empty if the paper has none.
    letter: &'static str,
    /// Its subscripts, as in the paper.
    subscript: &'static str,
    /// Its sentence; `{i}` is the body of the first number, `{k}` the frame of the second, `{0}` and `{n}` the base and
    /// the end effector; `{row}` and `{column}` are the numbers themselves.
    sentence: &'static str,
}

const MATRICES: [Matrix; 6] = [
    Matrix {
        letter: "M",
        noun: "pose",
        cells: [
            "x_x", "y_x", "z_x", "t_x", "x_y", "y_y", "z_y", "t_y", "x_z", "y_z", "z_z", "t_z",
            "0", "0", "0", "1",
        ],
        is: "P₍ᵢ₎ = Mᵢⱼ P₍ⱼ₎ (1)",
        moves: "Mᵢₖ = Mᵢⱼ Mⱼₖ",
    },
    Matrix {
        letter: "W",
        noun: "velocity",
        cells: [
            "0", "−ω_z", "ω_y", "v_x", "ω_z", "0", "−ω_x", "v_y", "−ω_y", "ω_x", "0", "v_z", "0",
            "0", "0", "0",
        ],
        is: "W = Ṁ M⁻¹ (6)",
        moves: "Wᵢₖ = Wᵢⱼ + Wⱼₖ (10), and M W M⁻¹ into another frame (8)",
    },
    Matrix {
        letter: "H",
        noun: "acceleration",
        cells: [
            "ω²_xx",
            "−ω̇_z + ω²_xy",
            "ω̇_y + ω²_xz",
            "a_x",
            "ω̇_z + ω²_xy",
            "ω²_yy",
            "−ω̇_x + ω²_yz",
            "a_y",
            "−ω̇_y + ω²_xz",
            "ω̇_x + ω²_yz",
            "ω²_zz",
            "a_z",
            "0",
            "0",
            "0",
            "0",
        ],
        is: "H = Ẇ + W², so that G = ω̲̇ + ω̲² (7)",
        moves: "Hᵢₖ = Hᵢⱼ + Hⱼₖ + 2 Wᵢⱼ Wⱼₖ (11), and M H M⁻¹ into another frame (9)",
    },
    Matrix {
        letter: "L",
        noun: "screw",
        cells: [
            "0", "−u_z", "u_y", "b_x", "u_z", "0", "−u_x", "b_y", "−u_y", "u_x", "0", "b_z", "0",
            "0", "0", "0",
        ],
        is: "W = L q̇, with b = −u̲ p + pitch u (§ 5)",
        moves: "M L M⁻¹ into another frame (8)",
    },
    Matrix {
        letter: "J",
        noun: "pseudo-inertia",
        cells: [
            "J_xx", "J_xy", "J_xz", "q_x", "J_xy", "J_yy", "J_yz", "q_y", "J_xz", "J_yz", "J_zz",
            "q_z", "q_x", "q_y", "q_z", "m",
        ],
        is: "J = ∫ P Pᵗ dm (16)",
        moves: "a sum over what is carried, and M J Mᵗ into another frame (17)",
    },
    Matrix {
        letter: "Φ",
        noun: "action",
        cells: [
            "0", "−c_z", "c_y", "f_x", "c_z", "0", "−c_x", "f_y", "−c_y", "c_x", "0", "f_z",
            "−f_x", "−f_y", "−f_z", "0",
        ],
        is: "Φ = H J − J Hᵗ = skew[H J] (18, 25), and τ = L ⊗ Φ = u · c + b · f",
        moves: "a sum over what is carried, and M Φ Mᵗ into another frame (17)",
    },
];

/// All kinds; a quantity has the first one that fits.
#[rustfmt::skip]
const QUANTITY_KINDS: [QuantityKind; 16] = [
    QuantityKind { fits: |of| is(of, Block::AngularVelocity) && from_base(of), letter: "W", subscript: "0,{i}({k})", sentence: "Angular velocity of {i} as seen from {0}, in the axes of {k}." },
    QuantityKind { fits: |of| is(of, Block::LinearVelocity) && from_base(of), letter: "W", subscript: "0,{i}({k})", sentence: "Velocity, as seen from {0}, of the point of {i} that is just passing through the origin of {k}." },
    QuantityKind { fits: |of| is(of, Block::AngularVelocity) && of_tip(of), letter: "W", subscript: "{i},n({k})", sentence: "Angular velocity of frame n ({n}) as seen from {i}, in the axes of {k}." },
    QuantityKind { fits: |of| is(of, Block::LinearVelocity) && of_tip(of), letter: "W", subscript: "{i},n({k})", sentence: "Velocity, as seen from {i}, of the point of n ({n}) that is just passing through the origin of {k}." },
    QuantityKind { fits: |of| is(of, Block::AngularAcceleration) && from_base(of), letter: "H", subscript: "0,{i}({k})", sentence: "Angular acceleration of {i}, in the axes of {k}." },
    QuantityKind { fits: |of| is(of, Block::LinearAcceleration) && from_base(of), letter: "H", subscript: "0,{i}({k})", sentence: "Acceleration of the origin of {k}, taken with {i}; in dynamics the base is accelerated against gravity, so that this is less g." },
    QuantityKind { fits: |of| is_pose(of) && of_tip(of), letter: "M", subscript: "{i},n", sentence: "Pose of frame n ({n}) as seen from {i}: its axes x, y, z and its origin t." },
    QuantityKind { fits: |of| is_pose(of) && from_base(of), letter: "M", subscript: "0,{i}", sentence: "Pose of {i} as seen from {0}: its axes x, y, z and its origin t." },
    QuantityKind { fits: |of| (is(of, Block::Direction) || is(of, Block::Moment)) && in_base(of), letter: "L", subscript: "{i}(0)", sentence: "Screw of the joint of {i}, in {0}." },
    QuantityKind { fits: |of| is(of, Block::Inertia) && in_base(of), letter: "J", subscript: "{i}(0)", sentence: "Inertia of {i} in {0}, or of it with all that it carries." },
    QuantityKind { fits: |of| is(of, Block::Inertia), letter: "J", subscript: "{i}({k})", sentence: "Inertia of {i} with all that it carries, in {k}; mass without effect on the joints there may belong to an inner body." },
    QuantityKind { fits: |of| is(of, Block::MassCenter), letter: "J", subscript: "{i}({k})", sentence: "First moment of {i} with all that it carries, by the mass of the robot, in {k}." },
    QuantityKind { fits: |of| is_action(of) && in_its_own(of), letter: "Φ", subscript: "{i}({i})", sentence: "Wrench of the joint of {i} on all that it carries, in {i}; in a mass matrix, for a unit acceleration of that joint." },
    QuantityKind { fits: |of| is_action(of), letter: "Φ", subscript: "{i}({k})", sentence: "Wrench of the joint of {i} on all that it carries, in {k}; in a mass matrix, for a unit acceleration of that joint." },
    QuantityKind { fits: |of| is(of, Block::Pivot), letter: "", subscript: "{i}", sentence: "Inertia at the joint of {i}: D of the mass matrix Lᵗ D L, or of articulated bodies (Featherstone). No matrix of the paper." },
    QuantityKind { fits: |of| is(of, Block::Factor), letter: "", subscript: "{i},{k}", sentence: "Row {row}, column {column} of L of the mass matrix Lᵗ D L (Featherstone). No matrix of the paper." },
];

fn is(of: Quantity, block: Block) -> bool {
    of.block == block
}

fn is_pose(of: Quantity) -> bool {
    matches!(of.block, Block::Axis(_) | Block::Origin)
}

fn is_action(of: Quantity) -> bool {
    matches!(of.block, Block::Couple | Block::Force)
}

fn from_base(of: Quantity) -> bool {
    matches!(of.of, LabelledBodies::FromBase(_))
}

fn of_tip(of: Quantity) -> bool {
    matches!(of.of, LabelledBodies::TipFrom(_))
}

fn in_base(of: Quantity) -> bool {
    of.frame == Some(Numeral::BASE)
}

fn in_its_own(of: Quantity) -> bool {
    let [body, _] = numbers(of);
    of.frame.map(|frame| frame.0) == body
}

/// The numbers `{i}` and `{k}` of a quantity.
fn numbers(of: Quantity) -> [Option<usize>; 2] {
    match of.of {
        LabelledBodies::Body(Numeral(i))
        | LabelledBodies::FromBase(Numeral(i))
        | LabelledBodies::TipFrom(Numeral(i)) => [Some(i), of.frame.map(|frame| frame.0)],
        LabelledBodies::Pair(Numeral(row), Numeral(column)) => [Some(row), Some(column)],
    }
}

/// An entry as in the cells of its matrix: a letter, and subscripts after `_`.
fn entry(label: Label) -> String {
    const AXES: [&str; 3] = ["x", "y", "z"];
    let letter = match (label.quantity.block, label.component) {
        (Block::Axis(k), _) => AXES[k],
        (Block::Origin, _) => "t",
        (Block::AngularVelocity, _) => "ω",
        (Block::LinearVelocity, _) => "v",
        (Block::AngularAcceleration, _) => "ω̇",
        (Block::LinearAcceleration, _) => "a",
        (Block::Direction, _) => "u",
        (Block::Moment, _) => "b",
        (Block::Inertia, Component::Second(..)) => "J",
        (Block::Inertia, Component::Mass) => "m",
        (Block::Inertia | Block::MassCenter, _) => "q",
        (Block::Couple, _) => "c",
        (Block::Force, _) => "f",
        (Block::Pivot, _) => "d",
        (Block::Factor, _) => "ℓ",
    };
    match label.component {
        Component::Scalar | Component::Mass => letter.to_owned(),
        Component::Along(k) => format!("{letter}_{}", AXES[k]),
        Component::Second(i, k) => format!("{letter}_{}{}", AXES[i], AXES[k]),
    }
}

/// The meanings of names, by name.
#[must_use]
pub fn meanings(named: &[(String, Meaning)]) -> Value {
    let named = named.iter();
    let named = named.map(|(name, meaning)| (name.clone(), data(meaning)));
    Value::Object(named.collect())
}

/// The meaning of a name; bodies, coordinates and entries of arguments count from 1.
fn data(meaning: &Meaning) -> Value {
    match meaning {
        Meaning::Argument(Variable::Actions, entry) => {
            let (action, entry) = action_entry(usize::from(*entry));
            json!({ "kind": "action", "index": action + 1, "entry": entry })
        }
        Meaning::Argument(argument, entry) => {
            json!({ "kind": "argument", "argument": argument.name(), "index": entry + 1 })
        }
        Meaning::Entry(label) => {
            let [i, k] = numbers(label.quantity);
            let form = QUANTITY_KINDS
                .iter()
                .position(|form| (form.fits)(label.quantity));
            json!({
                "kind": "entry", "form": form, "entry": entry(*label), "i": i, "k": k,
                "negative": label.negative,
            })
        }
        Meaning::Sum(coordinates) => {
            json!({ "kind": "sum", "coordinates": from_one(coordinates) })
        }
        Meaning::Sine(rotation) => angle(rotation, true),
        Meaning::Cosine(rotation) => angle(rotation, false),
        Meaning::Part(number) => json!({ "kind": "part", "index": number }),
        Meaning::Table(_) => json!({ "kind": "table" }),
        Meaning::Found(_) => json!({ "kind": "found" }),
        Meaning::LoopIndex => json!({ "kind": "loop" }),
    }
}

fn angle(rotation: &RotationAngle, sine: bool) -> Value {
    json!({
        "kind": "angle", "sine": sine, "of": rotation.name, "coordinates": from_one(&rotation.coordinates),
    })
}

fn from_one(coordinates: &[u16]) -> Value {
    coordinates.iter().map(|k| k + 1).collect()
}

/// The matrices by their letters, and the kinds.
#[must_use]
pub fn letters() -> Value {
    let matrices = MATRICES.iter().map(|matrix| {
        let data = json!({
            "noun": matrix.noun, "cells": matrix.cells, "is": matrix.is, "moves": matrix.moves,
        });
        (matrix.letter.to_owned(), data)
    });
    let forms = QUANTITY_KINDS.iter().map(
        |form| json!({ "letter": form.letter, "subscript": form.subscript, "sentence": form.sentence }),
    );
    json!({
        "matrices": matrices.collect::<Map<String, Value>>(),
        "forms": forms.collect::<Value>(),
    })
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;
    use homogen_codegen::description::read_text;
    use homogen_codegen::error::Errors;
    use homogen_codegen::expand::expand;
    use homogen_codegen::formulation::{Angles, Formulation, Forward, Frame};
    use homogen_codegen::request::Request;

    /// The letter and the first words of the sentence of a quantity.
    fn beginning(quantity: Quantity) -> (&'static str, &'static str) {
        let form = QUANTITY_KINDS.iter().find(|form| (form.fits)(quantity));
        let form = form.expect("a form");
        let end = form.sentence.find('{').expect("a number");
        (form.letter, form.sentence[..end].trim())
    }

    #[test]
    fn kinds_are_distinguished() {
        let [two, three] = [2, 3].map(Numeral);
        let quantity = |block: Block, of, frame| block.of(of).seen_in(frame);
        for (quantity, expected) in [
            (
                quantity(Block::AngularVelocity, LabelledBodies::FromBase(two), three),
                ("W", "Angular velocity of"),
            ),
            (
                quantity(Block::LinearVelocity, LabelledBodies::TipFrom(two), three),
                ("W", "Velocity, as seen from"),
            ),
            (
                Block::Axis(2).of(LabelledBodies::TipFrom(two)),
                ("M", "Pose of frame n ("),
            ),
            (
                Block::Origin.of(LabelledBodies::FromBase(two)),
                ("M", "Pose of"),
            ),
            (
                Block::Factor.of(LabelledBodies::Pair(three, two)),
                ("", "Row"),
            ),
        ] {
            assert_eq!(beginning(quantity), expected);
        }
        let action = |frame| quantity(Block::Force, LabelledBodies::Body(two), frame);
        assert!(in_its_own(action(two)) && !in_its_own(action(three)));
        assert!(!in_its_own(Block::Force.of(LabelledBodies::Body(two))));
    }

    #[test]
    fn names_are_data() {
        let label = Block::AngularVelocity
            .of(LabelledBodies::FromBase(Numeral(12)))
            .seen_in(Numeral(3))
            .entry(Component::Along(0));
        let rotation = RotationAngle {
            name: "q_2_3".to_owned(),
            coordinates: vec![1, 2],
        };
        for (meaning, expected) in [
            (
                Meaning::Entry(label.opposite()),
                json!({ "kind": "entry", "form": 0, "entry": "ω_x", "i": 12, "k": 3, "negative": true }),
            ),
            (
                Meaning::Argument(Variable::Qdd, 4),
                json!({ "kind": "argument", "argument": "qdd", "index": 5 }),
            ),
            (
                Meaning::Argument(Variable::Actions, 9),
                json!({ "kind": "action", "index": 2, "entry": "fx" }),
            ),
            (
                Meaning::Cosine(rotation),
                json!({ "kind": "angle", "sine": false, "of": "q_2_3", "coordinates": [2, 3] }),
            ),
        ] {
            assert_eq!(data(&meaning), expected);
        }
    }

    /// In functions of robots in all formulations, each entry has a kind and is an entry of its matrix, and each kind
    /// occurs.
    #[test]
    fn each_entry_of_a_function_has_a_form_and_a_cell() {
        let robots = [
            ("scara", include_str!("../../robots/scara.urdf")),
            (
                "stanford",
                include_str!("../../robots/stanford_general.urdf"),
            ),
        ];
        let default = Formulation::default();
        let formulations = [
            default,
            default.with_frame(Frame::Base),
            default.with_angles(Angles::Merged),
            default.with_forward(Forward::Articulated),
        ];
        let mut met = BTreeSet::new();
        for (name, text) in robots {
            for formulation in formulations {
                let mut errors = Errors::new();
                let robot = read_text(text, name, None, &mut errors).expect("a robot");
                let request = Request {
                    formulation,
                    ..Request::default()
                };
                let module = expand(&robot, &request).unwrap_or_else(|errors| panic!("{errors}"));
                let steps = module
                    .functions
                    .iter()
                    .flat_map(|generated| &generated.program.steps);
                for label in steps.filter_map(|step| step.label) {
                    let form = (QUANTITY_KINDS.iter()).position(|form| (form.fits)(label.quantity));
                    let form = form.unwrap_or_else(|| panic!("`{label}` has no form"));
                    let letter = QUANTITY_KINDS[form].letter;
                    let matrix = MATRICES.iter().find(|matrix| matrix.letter == letter);
                    assert_eq!(matrix.is_some(), !letter.is_empty(), "{letter}");
                    let entry = entry(label);
                    let has = |cell: &str| {
                        let mut parts = cell.split_whitespace();
                        parts.any(|part| part.trim_start_matches('−') == entry)
                    };
                    assert!(
                        matrix.is_none_or(|matrix| matrix.cells.into_iter().any(has)),
                        "{entry} of `{label}` is not in {letter}"
                    );
                    met.insert(form);
                }
            }
        }
        assert_eq!(met, (0..QUANTITY_KINDS.len()).collect());
    }
}
