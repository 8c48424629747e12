//! Generated derivatives compared with those that the graph makes of the functions themselves.
//!
//! Both are evaluated in 106 bits, so that only a wrong formula can make a difference: the recursions share no rule
//! with differentiation node by node.

use std::collections::BTreeMap;
use std::path::Path;

use homogen_codegen::Function;
use homogen_codegen::chain::{self, Chain};
use homogen_codegen::description::{self, Description};
use homogen_codegen::error::Errors;
use homogen_codegen::expression::{Double, Expr, Graph, Input, Term, along, evaluate, gradient};
use homogen_codegen::layout::Layout;
use homogen_codegen::list::Id;
use homogen_codegen::model::{Algorithm, coordinate_rates};
use homogen_codegen::plan::expressions_by;
use homogen_codegen::request::Request;
use homogen_codegen::space::{FrameId, Variable, VelocityId};

/// Relative to the largest entry of a result.
const TOLERANCE: f64 = 1e-24;

fn shipped(file: &str) -> Description {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../robots")
        .join(file);
    let mut errors = Errors::new();
    let read = description::read_file(&path, None, &mut errors);
    read.unwrap_or_else(|| panic!("{errors}"))
}

fn build(description: &Description, request: &Request) -> Chain {
    chain::build(description, request).unwrap_or_else(|errors| panic!("{errors}"))
}

/// A number for each input; quaternions have length 1.
fn number(chain: &Chain, input: Input) -> Double {
    let digits = |seed: u32| {
        let bits = seed
            .wrapping_mul(2_654_435_761)
            .rotate_left(13)
            .wrapping_mul(40_503);
        f64::from(bits >> 8) / f64::from(1_u32 << 24) - 0.5
    };
    let Input::Variable(variable, k) = input else {
        unreachable!("no robot here has fields")
    };
    if variable == Variable::Q {
        let quaternions = chain.spaces().quaternions();
        let mut first = quaternions
            .map(Id::index)
            .filter(|&first| (first..first + 4).contains(&usize::from(k)));
        if let Some(first) = first.next() {
            // 1² + 5² + 7² + 5² = 10².
            return Double::from([1.0, 5.0, -7.0, 5.0][usize::from(k) - first])
                / Double::from(10.0);
        }
    }
    Double::from(2.0 * digits(u32::from(k) + 1 + 1000 * (variable as u32 + 1)))
}

/// The results of a function in the frames of the description.
fn expressions(chain: &Chain, function: Function) -> (Graph, Vec<Expr>) {
    expressions_by(
        chain,
        &[function],
        FrameId::FIRST,
        Layout::DESCRIBED,
        Algorithm::PLAIN,
    )
}

fn numbers(chain: &Chain, graph: &Graph, terms: &[Term<'_>]) -> Vec<Double> {
    let exprs: Vec<Expr> = terms.iter().map(|term| term.expr()).collect();
    evaluate(graph, &exprs, |input| number(chain, input))
}

fn values(chain: &Chain, function: Function) -> Vec<Double> {
    let (graph, results) = expressions(chain, function);
    evaluate(&graph, &results, |input| number(chain, input))
}

#[track_caller]
fn assert_same(what: &str, found: &[Double], expected: &[Double]) {
    assert_eq!(found.len(), expected.len(), "{what}");
    let largest = expected.iter().map(|entry| entry.to_f64().abs());
    let largest = largest.fold(1e-3, f64::max);
    for (k, (found, expected)) in found.iter().zip(expected).enumerate() {
        let off = (*found - *expected).to_f64().abs();
        assert!(
            off <= TOLERANCE * largest,
            "{what}, entry {k}: {found:?} is not {expected:?}"
        );
    }
}

/// The derivatives of a function's results by the configuration: for each velocity, along it.
fn by_configuration(chain: &Chain, function: Function) -> Vec<Vec<Double>> {
    let (graph, results) = expressions(chain, function);
    let columns = chain.spaces().velocities.ids().map(|velocity| {
        let rates = coordinate_rates(&graph, chain, velocity);
        let changes = along(&graph, &results, |input| rates.get(&input).copied());
        numbers(chain, &graph, &changes)
    });
    columns.collect()
}

/// The derivatives of a function's results by an argument over velocities: for each result, by all entries.
fn by_argument(chain: &Chain, function: Function, argument: Variable) -> Vec<Vec<Double>> {
    let (graph, results) = expressions(chain, function);
    let zero = graph.constant(0.0);
    let entries = chain.spaces().velocities.ids().map(|k| input(argument, k));
    let entries: Vec<Input> = entries.collect();
    let rows = results.iter().map(|&result| {
        let row = gradient(&graph, &[(result, graph.constant(1.0))]);
        let row = entries.iter().map(|entry| row.get(entry).copied());
        let row: Vec<Term<'_>> = row.map(|entry| entry.unwrap_or(zero)).collect();
        numbers(chain, &graph, &row)
    });
    rows.collect()
}

fn input(variable: Variable, velocity: VelocityId) -> Input {
    let k = u16::try_from(velocity.index()).expect("few velocities");
    Input::Variable(variable, k)
}

fn transposed(matrix: &[Vec<Double>]) -> Vec<Vec<Double>> {
    let columns = 0..matrix[0].len();
    let column = |k: usize| matrix.iter().map(|row| row[k]).collect();
    columns.map(column).collect()
}

/// Asserts that the derivatives of a robot's dynamics are those of the graph: matrices with a row for each result.
fn assert_dynamics(name: &str, chain: &Chain) {
    let by_motion = |function: Function| {
        let by_rates = by_argument(chain, function, Variable::Qd);
        [transposed(&by_configuration(chain, function)), by_rates].concat()
    };
    let torques = by_motion(Function::InverseDynamics).concat();
    let generated = values(chain, Function::InverseDynamicsDerivatives);
    assert_same(&format!("{name}: ∂τ"), &torques, &generated);
    let gravity = transposed(&by_configuration(chain, Function::Gravity)).concat();
    let generated = values(chain, Function::GravityDerivative);
    assert_same(&format!("{name}: ∂ of gravity"), &gravity, &generated);
    let by_torques = by_argument(chain, Function::ForwardDynamics, Variable::Tau);
    let accelerations = [by_motion(Function::ForwardDynamics), by_torques].concat();
    let generated = values(chain, Function::ForwardDynamicsDerivatives);
    assert_same(&format!("{name}: ∂q̈"), &accelerations.concat(), &generated);
}

/// The derivatives of a matrix over velocities along each velocity, or by each entry of an argument, contracted over
/// its rows with λ: for each direction, an entry for each column.
fn contracted(
    chain: &Chain,
    function: Function,
    block: usize,
    along_velocity: impl Fn(&Graph, VelocityId) -> BTreeMap<Input, Expr>,
) -> Vec<Vec<Double>> {
    let (graph, results) = expressions(chain, function);
    let velocities = &chain.spaces().velocities;
    let size = velocities.len();
    let results = &results[block * size * size..][..size * size];
    let directions = velocities.ids().map(|velocity| {
        let rates = along_velocity(&graph, velocity);
        let changes = along(&graph, results, |input| {
            rates.get(&input).map(|&rate| graph.term(rate))
        });
        let changes = numbers(chain, &graph, &changes);
        let mut sums = vec![Double::ZERO; size];
        for (row, weight) in changes.chunks(size).zip(velocities.ids()) {
            let weight = number(chain, input(Variable::Weights, weight));
            for (sum, &entry) in sums.iter_mut().zip(row) {
                *sum = *sum + weight * entry;
            }
        }
        sums
    });
    directions.collect()
}

/// Asserts that the Hessians of λᵀτ and λᵀq̈ have the derivatives of the first derivatives.
fn assert_hessians(name: &str, chain: &Chain) {
    let configuration = |graph: &Graph, velocity: VelocityId| {
        let rates = coordinate_rates(graph, chain, velocity);
        let rates = rates.into_iter().map(|(of, rate)| (of, rate.expr()));
        rates.collect()
    };
    let rate = |graph: &Graph, velocity: VelocityId| {
        BTreeMap::from([(input(Variable::Qd, velocity), graph.constant(1.0).expr())])
    };
    let of = |first: Function, (last, block): (Function, usize), hessian: Function| {
        let blocks = [
            contracted(chain, first, 0, configuration),
            contracted(chain, first, 1, configuration),
            contracted(chain, first, 1, rate),
            contracted(chain, last, block, configuration),
        ];
        let generated = values(chain, hessian);
        let size = generated.len() / blocks.len();
        for (k, (block, generated)) in blocks.iter().zip(generated.chunks(size)).enumerate() {
            let what = format!("{name}: block {k} of {}", hessian.name());
            assert_same(&what, &block.concat(), generated);
        }
    };
    of(
        Function::InverseDynamicsDerivatives,
        (Function::MassMatrix, 0),
        Function::InverseDynamicsHessian,
    );
    of(
        Function::ForwardDynamicsDerivatives,
        (Function::ForwardDynamicsDerivatives, 2),
        Function::ForwardDynamicsHessian,
    );
}

/// Asserts that Jacobian–vector products are values, and products of the matrices of first derivatives with changes.
fn assert_changes(name: &str, chain: &Chain) {
    let inverse = [Function::InverseDynamicsDerivatives, Function::MassMatrix];
    let forward = [Function::ForwardDynamicsDerivatives];
    for (of, matrices, last, product) in [
        (
            Function::InverseDynamics,
            &inverse[..],
            Variable::QddChange,
            Function::InverseDynamicsJvp,
        ),
        (
            Function::ForwardDynamics,
            &forward[..],
            Variable::TauChange,
            Function::ForwardDynamicsJvp,
        ),
    ] {
        let size = chain.spaces().velocities.len();
        let matrices = matrices.iter().flat_map(|&of| values(chain, of));
        let matrices: Vec<Double> = matrices.collect();
        let changes = [Variable::QChange, Variable::QdChange, last];
        let mut sums = vec![Double::ZERO; size];
        for (matrix, change) in matrices.chunks(size * size).zip(changes) {
            for (sum, row) in sums.iter_mut().zip(matrix.chunks(size)) {
                for (&entry, k) in row.iter().zip(chain.spaces().velocities.ids()) {
                    *sum = *sum + entry * number(chain, input(change, k));
                }
            }
        }
        let what = format!("{name}: {}", product.name());
        let expected = [values(chain, of), sums].concat();
        assert_same(&what, &values(chain, product), &expected);
    }
}

/// Asserts that vector–Jacobian products are products with the matrices of first derivatives.
fn assert_products(name: &str, chain: &Chain) {
    let velocities = chain.spaces().velocities.ids();
    let weights = velocities.map(|k| number(chain, input(Variable::Weights, k)));
    let weights: Vec<Double> = weights.collect();
    let inverse_dynamics = [Function::InverseDynamicsDerivatives, Function::MassMatrix];
    for (of, product) in [
        (&inverse_dynamics[..], Function::InverseDynamicsVjp),
        (
            &[Function::ForwardDynamicsDerivatives],
            Function::ForwardDynamicsVjp,
        ),
    ] {
        let matrices = of.iter().flat_map(|&of| values(chain, of));
        let matrices: Vec<Double> = matrices.collect();
        let products = matrices.chunks(weights.len().pow(2)).flat_map(|matrix| {
            let mut sums = vec![Double::ZERO; weights.len()];
            for (row, &weight) in matrix.chunks(weights.len()).zip(&weights) {
                for (sum, &entry) in sums.iter_mut().zip(row) {
                    *sum = *sum + weight * entry;
                }
            }
            sums
        });
        let what = format!("{name}: {}", product.name());
        assert_same(
            &what,
            &values(chain, product),
            &products.collect::<Vec<_>>(),
        );
    }
}

/// Asserts the same for Jacobians and momenta: matrices that are stored by velocities.
fn assert_rates(name: &str, chain: &Chain) {
    let center = by_configuration(chain, Function::CenterOfMass).concat();
    let generated = values(chain, Function::CenterOfMassJacobian);
    assert_same(
        &format!("{name}: ∂ of the centre of mass"),
        &center,
        &generated,
    );
    let momentum = by_argument(chain, Function::CentroidalMomentum, Variable::Qd);
    let generated = values(chain, Function::CentroidalMomentumMatrix);
    let momentum = transposed(&momentum).concat();
    assert_same(&format!("{name}: ∂Γ/∂q̇"), &momentum, &generated);
    // ∂T/∂q̇ = M q̇.
    let energy = by_argument(chain, Function::KineticEnergy, Variable::Qd).concat();
    let velocities = chain.spaces().velocities.ids();
    let rates = velocities.map(|k| number(chain, input(Variable::Qd, k)));
    let rates: Vec<Double> = rates.collect();
    let mass_matrix = values(chain, Function::MassMatrix);
    let momenta = mass_matrix.chunks(rates.len()).map(|row| {
        let terms = row.iter().zip(&rates);
        terms.fold(Double::ZERO, |sum, (entry, rate)| sum + *entry * *rate)
    });
    let momenta: Vec<Double> = momenta.collect();
    assert_same(&format!("{name}: ∂T/∂q̇"), &energy, &momenta);
}

#[test]
fn distances_of_spheres_have_the_derivatives_of_the_graph() {
    let two_arms = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/robots/two_arms.urdf");
    let mut errors = Errors::new();
    let two_arms = description::read_file(&two_arms, None, &mut errors);
    let two_arms = two_arms.unwrap_or_else(|| panic!("{errors}"));
    for floating in [false, true] {
        let request = Request {
            collision: true,
            floating,
            ..Request::default()
        };
        let chain = build(&two_arms, &request);
        let expected = transposed(&by_configuration(&chain, Function::Distances)).concat();
        let generated = values(&chain, Function::DistanceJacobian);
        assert_same("distances", &generated, &expected);
    }
}

#[test]
fn arms_have_the_derivatives_of_the_graph() {
    for file in ["two_link", "ur5_class", "panda_class", "scara"] {
        let chain = build(&shipped(&format!("{file}.urdf")), &Request::default());
        assert_dynamics(file, &chain);
        assert_hessians(file, &chain);
        assert_products(file, &chain);
        assert_changes(file, &chain);
        assert_rates(file, &chain);
    }
}

#[test]
fn a_floating_quadruped_has_the_derivatives_of_the_graph() {
    let request = Request {
        floating: true,
        ..Request::default()
    };
    let chain = build(&shipped("quadruped.urdf"), &request);
    assert_dynamics("quadruped", &chain);
    assert_hessians("quadruped", &chain);
    assert_products("quadruped", &chain);
    assert_changes("quadruped", &chain);
    assert_rates("quadruped", &chain);
}
