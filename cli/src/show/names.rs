//! What names in generated code say: which matrix of the paper, of which links, in which frame, and which
//! of its entries.
//!
//! In: nothing. Out: the matrices with their equations, and the forms of names with what each is. The
//! model gives the names; a test finds each of them here. It never reads a name: the page does.

use serde_json::{Map, Value, json};

/// A matrix of the paper.
struct Matrix {
    letter: &'static str,
    noun: &'static str,
    /// Its entries, row by row.
    cells: [&'static str; 16],
    /// What it is, with the equation's number.
    is: &'static str,
    /// How it gets from link to link and from frame to frame.
    moves: &'static str,
}

/// A form of names: `{i}` and `{k}` stand for numbers, `{e}` for the entry.
struct Form {
    name: &'static str,
    letter: &'static str,
    /// Its subscripts, as the paper writes them.
    subscript: &'static str,
    /// What takes the place of `{e}`, and the entry that it is.
    entries: &'static [(&'static str, &'static str)],
    /// What the matrix is of.
    tells: &'static str,
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

const OMEGA: &[(&str, &str)] = &[("x", "ω_x"), ("y", "ω_y"), ("z", "ω_z")];
const V: &[(&str, &str)] = &[("vx", "v_x"), ("vy", "v_y"), ("vz", "v_z")];
const OMEGA_DOT: &[(&str, &str)] = &[("x", "ω̇_x"), ("y", "ω̇_y"), ("z", "ω̇_z")];
const A: &[(&str, &str)] = &[("x", "a_x"), ("y", "a_y"), ("z", "a_z")];
const SCREW: &[(&str, &str)] = &[
    ("ux", "u_x"),
    ("uy", "u_y"),
    ("uz", "u_z"),
    ("bx", "b_x"),
    ("by", "b_y"),
    ("bz", "b_z"),
];
const POSE: &[(&str, &str)] = &[
    ("xx", "x_x"),
    ("xy", "x_y"),
    ("xz", "x_z"),
    ("yx", "y_x"),
    ("yy", "y_y"),
    ("yz", "y_z"),
    ("zx", "z_x"),
    ("zy", "z_y"),
    ("zz", "z_z"),
    ("tx", "t_x"),
    ("ty", "t_y"),
    ("tz", "t_z"),
];
const INERTIA: &[(&str, &str)] = &[
    ("xx", "J_xx"),
    ("yy", "J_yy"),
    ("zz", "J_zz"),
    ("xy", "J_xy"),
    ("xz", "J_xz"),
    ("yz", "J_yz"),
    ("x", "q_x"),
    ("y", "q_y"),
    ("z", "q_z"),
    ("m", "m"),
];
const FIRST_MOMENT: &[(&str, &str)] = &[("x", "q_x"), ("y", "q_y"), ("z", "q_z")];
const ACTION: &[(&str, &str)] = &[
    ("cx", "c_x"),
    ("cy", "c_y"),
    ("cz", "c_z"),
    ("fx", "f_x"),
    ("fy", "f_y"),
    ("fz", "f_z"),
];
const NONE: &[(&str, &str)] = &[("", "")];

/// All forms; a name has the first one that it fits.
#[rustfmt::skip]
const FORMS: [Form; 16] = [
    Form { name: "w_0_{i}_in_{k}_{e}", letter: "W", subscript: "0,{i}({k})", entries: OMEGA, tells: "Angular velocity of {i} as seen from {0}, in the axes of {k}." },
    Form { name: "w_0_{i}_in_{k}_{e}", letter: "W", subscript: "0,{i}({k})", entries: V, tells: "Velocity, as seen from {0}, of the point of {i} that is just passing through the origin of {k}." },
    Form { name: "w_{i}_n_in_{k}_{e}", letter: "W", subscript: "{i},n({k})", entries: OMEGA, tells: "Angular velocity of frame n ({n}) as seen from {i}, in the axes of {k}." },
    Form { name: "w_{i}_n_in_{k}_{e}", letter: "W", subscript: "{i},n({k})", entries: V, tells: "Velocity, as seen from {i}, of the point of n ({n}) that is just passing through the origin of {k}." },
    Form { name: "wd_0_{i}_in_{k}_{e}", letter: "H", subscript: "0,{i}({k})", entries: OMEGA_DOT, tells: "Angular acceleration of {i}, in the axes of {k}." },
    Form { name: "h_0_{i}_in_{k}_{e}", letter: "H", subscript: "0,{i}({k})", entries: A, tells: "Acceleration of the origin of {k}, taken with {i}; in dynamics the base is accelerated against gravity, so that this is less g." },
    Form { name: "m_{i}_n_{e}", letter: "M", subscript: "{i},n", entries: POSE, tells: "Pose of frame n ({n}) as seen from {i}: its axes x, y, z and its origin t." },
    Form { name: "m_0_{i}_{e}", letter: "M", subscript: "0,{i}", entries: POSE, tells: "Pose of {i} as seen from {0}: its axes x, y, z and its origin t." },
    Form { name: "l_{i}_in_0_{e}", letter: "L", subscript: "{i}(0)", entries: SCREW, tells: "Screw of the joint of {i}, in {0}." },
    Form { name: "j_{i}_in_0_{e}", letter: "J", subscript: "{i}(0)", entries: INERTIA, tells: "Inertia of {i} in {0}, or of it with all that it carries." },
    Form { name: "j_{i}_in_{k}_{e}", letter: "J", subscript: "{i}({k})", entries: INERTIA, tells: "Inertia of {i} with all that it carries, in {k}; mass that no joint can feel there may be counted further in." },
    Form { name: "c_{i}_in_{k}_{e}", letter: "J", subscript: "{i}({k})", entries: FIRST_MOMENT, tells: "First moment of {i} with all that it carries, by the mass of the robot, in {k}." },
    Form { name: "phi_{i}_in_{i}_{e}", letter: "Φ", subscript: "{i}({i})", entries: ACTION, tells: "What the joint of {i} exerts on all that it carries, in {i}; where a mass matrix is made, at a unit acceleration of that joint." },
    Form { name: "phi_{i}_in_{k}_{e}", letter: "Φ", subscript: "{i}({k})", entries: ACTION, tells: "What the joint of {i} exerts on all that it carries, in {k}; where a mass matrix is made, at a unit acceleration of that joint." },
    Form { name: "d_{i}{e}", letter: "", subscript: "", entries: NONE, tells: "What the joint of {i} itself opposes to its acceleration: D of the mass matrix Lᵗ D L, or of articulated bodies (Featherstone). No matrix of the paper." },
    Form { name: "l_{i}_{k}{e}", letter: "", subscript: "", entries: NONE, tells: "Row {i}, column {k} of L of the mass matrix Lᵗ D L (Featherstone). No matrix of the paper." },
];

/// The matrices by their letters, and the forms.
pub(super) fn letters() -> Value {
    let matrices = MATRICES.iter().map(|matrix| {
        let told = json!({
            "noun": matrix.noun, "cells": matrix.cells, "is": matrix.is, "moves": matrix.moves,
        });
        (matrix.letter.to_owned(), told)
    });
    let forms = FORMS.iter().map(|form| {
        let entries = form.entries.iter();
        let entries = entries.map(|(suffix, entry)| ((*suffix).to_owned(), json!(entry)));
        json!({
            "form": form.name, "letter": form.letter, "subscript": form.subscript,
            "entries": entries.collect::<Map<String, Value>>(), "tells": form.tells,
        })
    });
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

    /// Whether a name is of a form; what follows a number is no digit.
    fn fits(form: &str, entry: &str, name: &str) -> bool {
        let (mut name, mut bound) = (name, [None::<&str>; 2]);
        let form = form.replace("{e}", entry);
        let mut parts = form.split('{');
        let Some(mut rest) = parts.next().and_then(|first| name.strip_prefix(first)) else {
            return false;
        };
        for part in parts {
            let (which, literal) = part.split_once('}').expect("what is open is closed");
            let end = rest
                .find(|c: char| !c.is_ascii_digit())
                .unwrap_or(rest.len());
            (name, rest) = rest.split_at(end);
            let seen = &mut bound[usize::from(which == "k")];
            let same = seen.is_none_or(|before| before == name);
            *seen = Some(name);
            match rest.strip_prefix(literal) {
                Some(after) if same && !name.is_empty() => rest = after,
                _ => return false,
            }
        }
        rest.is_empty()
    }

    #[test]
    fn forms_are_told_apart() {
        assert!(fits("w_0_{i}_in_{k}_{e}", "x", "w_0_12_in_3_x"));
        assert!(!fits("w_0_{i}_in_{k}_{e}", "x", "w_0_12_in_3_vx"));
        assert!(fits("phi_{i}_in_{i}_{e}", "cz", "phi_2_in_2_cz"));
        assert!(!fits("phi_{i}_in_{i}_{e}", "cz", "phi_2_in_1_cz"));
        assert!(fits("l_{i}_{k}{e}", "", "l_3_1") && !fits("d_{i}{e}", "", "d_1_2"));
    }

    #[test]
    fn every_entry_is_one_of_its_matrix() {
        for form in &FORMS {
            let matrix = MATRICES.iter().find(|matrix| matrix.letter == form.letter);
            for (_, entry) in form.entries {
                let in_cells = |matrix: &Matrix| {
                    let has = |cell: &&str| {
                        cell.split_whitespace()
                            .any(|part| part.trim_start_matches('−') == *entry)
                    };
                    matrix.cells.iter().any(has)
                };
                assert_eq!(
                    matrix.is_some_and(in_cells),
                    !form.letter.is_empty(),
                    "{entry}"
                );
            }
        }
    }

    /// Functions of robots in all formulations, and the names that the model gives.
    #[test]
    fn the_model_gives_no_name_that_is_not_told() {
        let robots = [
            ("scara", include_str!("../../../robots/scara.urdf")),
            (
                "stanford",
                include_str!("../../../robots/stanford_general.urdf"),
            ),
        ];
        let default = Formulation::default();
        let formulations = [
            default,
            Formulation {
                frame: Frame::Base,
                ..default
            },
            Formulation {
                angles: Angles::Merged,
                ..default
            },
            Formulation {
                forward: Some(Forward::Articulated),
                ..default
            },
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
                    let label = label.quantity.entry(label.component).to_string();
                    let is = |form: &&Form| {
                        form.entries
                            .iter()
                            .any(|(entry, _)| fits(form.name, entry, &label))
                    };
                    let form = FORMS.iter().find(is);
                    let form = form.unwrap_or_else(|| panic!("nobody tells what `{label}` is"));
                    met.insert(form.name);
                }
            }
        }
        let all: BTreeSet<&str> = FORMS.iter().map(|form| form.name).collect();
        assert_eq!(met, all);
    }
}
