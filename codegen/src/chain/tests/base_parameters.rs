//! Base parameters compared with the rank of the whole regressor.

use std::path::Path;

use super::{fine, read};
use crate::chain::base_parameters::BaseParameter;
use crate::chain::{Chain, build};
use crate::description::{Description, read_file};
use crate::error::Errors;
use crate::expression::{Double, Input};
use crate::function::Function;
use crate::list::Id;
use crate::plan::{Programs, plan};
use crate::request::{Parameter, Request, Target};
use crate::schedule::{Program, run};
use crate::space::{FrameId, Space, Spaces, Variable};

fn built(description: &Description, request: &Request) -> Chain {
    let chain = build(description, request).unwrap_or_else(|errors| panic!("{errors}"));
    chain.identified()
}

fn identified(text: &str) -> Chain {
    fine(text).identified()
}

fn groups(chain: &Chain) -> &[BaseParameter] {
    let found = chain.base_parameters.as_ref();
    &found.expect("it is identified").groups
}

/// Number of states, so that there are more rows than columns.
const STATES: u64 = 40;

/// Relative residual of a dependent column.
const NOTHING: f64 = 1e-10;

fn shipped(name: &str) -> Chain {
    let file = format!("{}/../robots/{name}.urdf", env!("CARGO_MANIFEST_DIR"));
    let mut errors = Errors::new();
    let described: Option<Description> = read_file(Path::new(&file), None, &mut errors);
    let described = described.expect("a robot that ships");
    built(&described, &Request::default())
}

fn planned(chain: &Chain, function: Function) -> Result<Program, Errors> {
    let plan = plan(&Programs::of(chain), vec![function], FrameId::FIRST)?;
    Ok(plan.program)
}

fn program_of(chain: &Chain, function: Function) -> Program {
    planned(chain, function).unwrap_or_else(|errors| panic!("{errors}"))
}

/// The results of a program of a robot at the state with a number; all programs get the same state.
fn at(program: &Program, spaces: &Spaces, state: u64) -> Vec<f64> {
    /// A quaternion of length 1.
    const UNIT: [f64; 4] = [0.1, -0.7, 0.5, 0.5];
    let results = run(program, |input| {
        let Input::Variable(variable, k) = input else {
            unreachable!("there are no fields");
        };
        let of_quaternion = spaces.quaternions().find_map(|first| {
            let place = usize::from(k).checked_sub(first.index());
            place.filter(|&place| place < 4 && variable == Variable::Q)
        });
        if let Some(place) = of_quaternion {
            let turned = usize::try_from(state).expect("a few") + place;
            return Double::from(UNIT[turned % 4]);
        }
        let seed = 1000 * state + 100 * variable as u64 + u64::from(k);
        let mut random = homogen_random::Random::new(seed);
        Double::from(3.0 * random.unit())
    });
    results.into_iter().map(Double::to_f64).collect()
}

/// Number of independent columns, by pivoted orthogonalisation of columns of length 1: the column with the longest
/// residual comes next.
fn rank(mut columns: Vec<Vec<f64>>) -> usize {
    let dot = |a: &[f64], b: &[f64]| -> f64 { a.iter().zip(b).map(|(a, b)| a * b).sum() };
    let length = |column: &[f64]| dot(column, column).sqrt();
    let longest = columns
        .iter()
        .map(|column| length(column))
        .fold(0.0, f64::max);
    columns.retain(|column| length(column) > NOTHING * longest);
    for column in &mut columns {
        let length = length(column);
        for entry in column {
            *entry /= length;
        }
    }
    let mut rank = 0;
    while rank < columns.len() {
        let left = |k: &usize| length(&columns[*k]);
        let most = (rank..columns.len()).max_by(|a, b| left(a).total_cmp(&left(b)));
        let most = most.expect("some are left");
        if left(&most) < NOTHING {
            break;
        }
        columns.swap(rank, most);
        let (before, after) = columns.split_at_mut(rank + 1);
        let pivot = &before[rank];
        let square = dot(pivot, pivot);
        for column in after {
            let part = dot(pivot, column) / square;
            for (entry, pivot) in column.iter_mut().zip(pivot) {
                *entry -= part * pivot;
            }
        }
        rank += 1;
    }
    rank
}

/// Checks that there are as many base parameters as the rank of the regressor, that any parameters cause the torques
/// of their groups, and that the described ones cause those of inverse dynamics. Returns the number of base parameters.
fn hold(chain: &Chain) -> usize {
    let spaces = chain.spaces();
    let [all, some] = [Space::Parameters, Space::BaseParameters].map(|space| spaces.len(space));
    let [regressor, base, torques] = [
        Function::Regressor,
        Function::BaseRegressor,
        Function::InverseDynamics,
    ]
    .map(|function| program_of(chain, function));
    let groups = groups(chain);
    let mut columns = vec![Vec::new(); all];
    for state in 0..STATES {
        let [regressor, base, torques] =
            [&regressor, &base, &torques].map(|program| at(program, spaces, state));
        for (row, torque) in torques.iter().enumerate() {
            let whole = &regressor[all * row..][..all];
            let part = &base[some * row..][..some];
            for (column, entry) in columns.iter_mut().zip(whole) {
                column.push(*entry);
            }
            let terms = groups
                .iter()
                .zip(part)
                .map(|(group, entry)| group.value * entry);
            let size: f64 = terms.clone().map(f64::abs).sum();
            let off = (terms.sum::<f64>() - torque).abs();
            assert!(
                off <= 1e-12 * size.max(1e-6),
                "{torque} is off by {off:e} of {size}"
            );
            for (parameter, entry) in spaces.parameters.ids().zip(whole) {
                let of_groups = groups.iter().zip(part).map(|(group, column)| {
                    let member = group
                        .members
                        .iter()
                        .find(|(member, _)| *member == parameter);
                    member.map_or(0.0, |(_, factor)| factor * column)
                });
                let size: f64 = of_groups.clone().map(f64::abs).sum();
                let off = (of_groups.sum::<f64>() - entry).abs();
                assert!(
                    off <= 1e-10 * size.max(1.0),
                    "{parameter:?} is off by {off:e} of {size}"
                );
            }
        }
    }
    let found = rank(columns);
    assert_eq!(
        some, found,
        "base parameters, and the rank of the regressor"
    );
    some
}

#[test]
fn the_numbers_of_known_robots_are_the_published_ones() {
    // Khalil and Dombre, "Modeling, identification and control of robots", 2002: 36 for the PUMA 560 and 33 for the
    // Stanford arm, 43 for a Panda; for planar arms 3 a link.
    for (robot, known) in [
        ("two_link", 6),
        ("scara", 8),
        ("stanford_general", 33),
        ("puma560_general", 36),
        ("ur5_class", 36),
        ("panda_class", 43),
        ("quadruped", 68),
    ] {
        assert_eq!(hold(&shipped(robot)), known, "{robot}");
    }
}

/// The armatures of joints 1 and 2 are grouped with J_zz of their links, whose axes nothing inboard rotates; all
/// friction parameters are base parameters of their own.
#[test]
fn actuator_parameters_are_grouped_with_links_or_alone() {
    let of = |request: &Request| {
        let file = format!(
            "{}/../robots/puma560_general.urdf",
            env!("CARGO_MANIFEST_DIR")
        );
        let described = read_file(Path::new(&file), None, &mut Errors::new());
        built(&described.expect("a robot that ships"), request)
    };
    let chain = of(&Request {
        friction: true,
        ..Request::default()
    });
    assert_eq!(hold(&chain), 36 + 3 * 6 - 2);
    let led = |name: &str| {
        chain
            .spaces()
            .names(Space::BaseParameters)
            .any(|leading| leading == name)
    };
    let parts = ["armature", "damping", "friction"];
    let alone: Vec<[bool; 3]> = (1..=6)
        .map(|joint| parts.map(|part| led(&format!("joint_{joint}.{part}"))))
        .collect();
    let [reported, hidden] = [[true; 3], [false, true, true]];
    assert_eq!(
        alone,
        [hidden, hidden, reported, reported, reported, reported]
    );
}

#[test]
fn actuators_on_every_type_of_joint_and_on_mimic_joints() {
    let link = |name: &str| {
        format!(
            "link {name} {{ mass: 1.5, com: [0.1, 0.02, -0.03], inertia: [0.02, 0.001, 0, 0.03, 0, 0.04] }}"
        )
    };
    let links = ["a", "b", "c", "d"].map(link).concat();
    for joint in [
        "prismatic(y)",
        "cylindrical(y)",
        "universal(x, y)",
        "planar(y)",
        "spherical",
        "floating",
    ] {
        for mimic in ["", "mimic: one, multiplier: -2.0, "] {
            let chain = identified(&format!(
                "struct Robot; link base; {links}
                joint one: revolute(z) {{ from: base, to: a, armature: 0.25, friction: 0.5 }}
                joint two: {joint} {{ from: a, to: b, at: xyz(0.2, 0.1, 0.3) rpy(0.4, -0.3, 0.2), damping: 0.5 }}
                joint three: revolute(x) {{ from: b, to: c, at: xyz(0, 0.2, 0), {mimic}armature: 0.125, damping: 0.5, friction: 0.75 }}
                joint four: prismatic(x) {{ from: b, to: d, at: rz(0.3) }}"
            ));
            assert!(hold(&chain) > 0, "{joint}");
        }
    }
}

#[test]
fn every_type_of_joint_on_a_tree_of_oblique_axes() {
    let (description, request) = read(include_str!("../../layout/oblique.txt"));
    let chain = built(&description, &request);
    assert!(hold(&chain) > 0);
}

#[test]
fn without_gravity_fewer_parameters_are_determined() {
    let arm = |gravity: &str| {
        identified(&format!(
            "struct Arm {{ gravity: {gravity} }}
            link base;
            joint shoulder: revolute([0.36, 0.48, 0.8]) {{ from: base, to: upper, at: xyz(0.1, 0.2, 0.3) rx(0.3) }}
            joint slide: cylindrical([0.6, 0.0, 0.8]) {{ from: upper, to: fore, at: xyz(0.4, 0.1, 0) ry(0.2) }}
            link upper {{ mass: 1.0, com: [0.1, 0.2, 0.3], inertia: [0.1, 0.2, 0.15] }}
            link fore {{ mass: 2.0, com: [0.1, 0.2, -0.3], inertia: [0.1, 0.2, 0.15, 0.01, 0.02, 0.03] }}"
        ))
    };
    let [with, without] =
        ["[0.0, 0.0, -9.81]", "[0.0, 0.0, 0.0]"].map(|gravity| hold(&arm(gravity)));
    assert!(without < with, "{without} and {with}");
}

#[test]
fn undetermined_parameters_are_in_no_group() {
    // About a vertical axis only the moment about that axis has an effect.
    let chain = identified(
        "struct Turntable { }
        link base;
        joint pan: revolute(z) { from: base, to: plate, at: xyz(1, 2, 3) }
        link plate { mass: 3.0, com: [0.1, 0.2, 0.3], inertia: [0.1, 0.2, 0.15] }",
    );
    let members: Vec<_> = (groups(&chain).iter())
        .map(|group| group.members.iter().map(|&(k, factor)| (k.index(), factor)))
        .map(Vec::from_iter)
        .collect();
    // J_xx and J_yy.
    assert_eq!(members, [[(4, 1.0), (7, 1.0)]]);
    assert_eq!(
        chain
            .spaces()
            .names(Space::BaseParameters)
            .collect::<Vec<_>>(),
        ["plate.J_xx"]
    );
}

/// Number of independent columns among a function's rows, if fields are far from their described values.
fn rank_elsewhere(chain: &Chain, function: Function, columns: usize) -> usize {
    let program = program_of(chain, function);
    let mut found = vec![Vec::new(); columns];
    for state in 0..STATES {
        let results = run(&program, |input| {
            let seed = match input {
                Input::Variable(variable, k) => 1000 * state + 100 * variable as u64 + u64::from(k),
                Input::Parameter(field, k) => 7_000_000 + 100 * u64::from(field) + u64::from(k),
            };
            Double::from(3.0 * homogen_random::Random::new(seed).unit())
        });
        let results: Vec<f64> = results.into_iter().map(Double::to_f64).collect();
        for row in results.chunks(columns) {
            for (column, entry) in found.iter_mut().zip(row) {
                column.push(*entry);
            }
        }
    }
    rank(found)
}

#[test]
fn base_parameters_are_refused_if_fields_reveal_others() {
    let file = format!("{}/../robots/panda_class.urdf", env!("CARGO_MANIFEST_DIR"));
    let mut errors = Errors::new();
    let described = read_file(Path::new(&file), None, &mut errors).expect("a robot that ships");
    for (target, reveals) in [
        (Target::MassOf("link5".into()), false),
        (Target::PayloadOn("link8".into()), false),
        (Target::InertiaOf("link3".into()), false),
        (Target::BasePosition, false),
        (Target::BasePlacement, true),
        (Target::Gravity, true),
        (Target::OriginOf("joint1".into()), false),
        (Target::PlacementOf("joint4".into()), false),
    ] {
        let field = quote::format_ident!("free");
        let request = Request {
            parameters: vec![Parameter {
                field,
                target: target.clone(),
                range: None,
            }],
            ..Request::default()
        };
        let chain = built(&described, &request);
        let spaces = chain.spaces();
        let [all, some] = [Space::Parameters, Space::BaseParameters].map(|space| spaces.len(space));
        let rank = rank_elsewhere(&chain, Function::Regressor, all);
        assert_eq!(rank > some, reveals, "{target:?}: {rank} for {some}");
        let base = planned(&chain, Function::BaseRegressor);
        if reveals {
            let refusal = base.expect_err("it is wrong elsewhere").to_string();
            let expected = "error: torques determine other base parameters if field `free` differs from the \
                            description\n  hint: ask for `regressor`";
            assert!(refusal.contains(&expected[7..]), "{refusal}");
        } else {
            assert!(base.is_ok(), "{target:?}");
            assert_eq!(rank_elsewhere(&chain, Function::BaseRegressor, some), some);
        }
    }
}
