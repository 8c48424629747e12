//! Residuals of loops in a few configurations: their values, and their derivatives by the joints.
//!
//! In: a chain. Out: for each residual of each loop its largest value, and the largest ratio of its rate to the
//! motion of frame B relative to frame A, over all joints and configurations: the angular velocity for an angle, the
//! linear velocity for a length.

use crate::chain::Chain;
use crate::closure::ResidualKind;
use crate::expression::{Double, Evaluation, Input};
use crate::function::Function;
use crate::layout::Layout;
use crate::list::{Id, List};
use crate::model::Algorithm;
use crate::plan::expressions_by;
use crate::quaternion::normalize;
use crate::random::Random;
use crate::space::{Entry, FieldId, FrameId, Kind, Variable};

/// Number of random configurations.
const CONFIGURATIONS: usize = 8;

/// The least size of a loop \[m\]: offsets that cancel leave 10⁻¹⁶ m of rounding.
const LEAST_SIZE: f64 = 1e-12;

/// The least motion of a joint, relative to the loop's size: a joint and its mimic joint that rotate in opposite
/// directions leave the rounding of their axes.
const LEAST_MOTION: f64 = 1e-3;

/// The entries of M of frame B in frame A: the origin, and the axes.
const WHOLE: [ResidualKind; 12] = [
    ResidualKind::Along(0),
    ResidualKind::Along(1),
    ResidualKind::Along(2),
    ResidualKind::Product(0, 0),
    ResidualKind::Product(0, 1),
    ResidualKind::Product(0, 2),
    ResidualKind::Product(1, 0),
    ResidualKind::Product(1, 1),
    ResidualKind::Product(1, 2),
    ResidualKind::Product(2, 0),
    ResidualKind::Product(2, 1),
    ResidualKind::Product(2, 2),
];

/// A residual.
pub(super) struct MeasuredResidual {
    /// The value of largest magnitude [m, 1].
    pub(super) value: f64,
    /// The value's scale: the largest distance of A and B \[m\], or 1 for an angle.
    pub(super) size: f64,
    /// The largest ratio to a joint's motion: 0 if no joint changes the residual, about 1 if one does.
    pub(super) share: f64,
}

/// The residuals of all loops, one list a loop.
pub(super) fn measured(chain: &Chain) -> Vec<Vec<MeasuredResidual>> {
    let mut whole = chain.clone();
    whole.close(|loops| {
        for closed in loops {
            closed.rows.extend(WHOLE);
        }
    });
    let functions = [Function::Constraint, Function::ConstraintJacobian];
    let (layout, algorithm) = (Layout::DESCRIBED, Algorithm::PLAIN);
    let (graph, results) = expressions_by(&whole, &functions, FrameId::FIRST, layout, algorithm);
    let evaluation = Evaluation::of(&graph, &results);
    let rows: Vec<usize> = whole.loops.iter().map(|closed| closed.rows.len()).collect();
    let mut random = Random(0);
    let samples: Vec<Vec<Sample>> = (0..CONFIGURATIONS)
        .map(|_| sampled(&whole, &evaluation, &rows, &mut random))
        .collect();
    let loops = chain.loops.iter().enumerate();
    loops
        .map(|(k, closed)| {
            let samples: Vec<&Sample> = samples.iter().map(|samples| &samples[k]).collect();
            of_loop(&closed.rows, &samples)
        })
        .collect()
}

/// A loop in one configuration.
struct Sample {
    /// The residuals, followed by the entries of M.
    values: Vec<f64>,
    /// For each of them, its derivative by each velocity.
    rates: Vec<Vec<f64>>,
}

fn sampled(
    chain: &Chain,
    evaluation: &Evaluation<Double>,
    rows: &[usize],
    random: &mut Random,
) -> Vec<Sample> {
    let q = configuration(chain, random);
    let fields = chain.request.parameters.iter().zip(&chain.nominal);
    let fields: List<FieldId, Vec<f64>> = fields
        .map(|(parameter, nominal)| parameter.near(nominal, || random.unit()))
        .collect();
    let found = evaluation.at(|input| match input {
        Input::Variable(Variable::Q, k) => q[usize::from(k)],
        Input::Variable(..) => Double::ZERO,
        Input::Parameter(field, k) => fields[field.into()][usize::from(k)].into(),
    });
    let found: Vec<f64> = found.into_iter().map(Double::to_f64).collect();
    let velocities = chain.spaces().velocities.len();
    let (mut values, rates) = found.split_at(rows.iter().sum());
    let mut rates = rates.chunks(velocities).map(<[f64]>::to_vec);
    let mut samples = Vec::new();
    for &count in rows {
        let (own, others) = values.split_at(count);
        values = others;
        samples.push(Sample {
            values: own.to_vec(),
            rates: rates.by_ref().take(count).collect(),
        });
    }
    samples
}

/// A random configuration. Angles ignore limits, since a dependence on an angle shows everywhere; displacements are
/// within their limits, which give the size of the robot.
fn configuration(chain: &Chain, random: &mut Random) -> Vec<Double> {
    const FARTHEST: f64 = 1e6;
    let ends = |entry: &Entry| match (entry.kind, entry.range) {
        (Kind::Rotation, _) => [-3.0, 3.0],
        (_, Some(ends)) => ends.map(|end| end.clamp(-FARTHEST, FARTHEST)),
        (_, None) => [-1.0, 1.0],
    };
    let coordinates = chain.spaces().coordinates.iter().map(ends);
    let mut q: Vec<Double> = coordinates
        .map(|[lower, upper]| Double::from(lower + (upper - lower) * random.unit()))
        .collect();
    for first in chain.spaces().quaternions() {
        normalize(&mut q[first.index()..][..4]);
    }
    q
}

fn of_loop(rows: &[ResidualKind], samples: &[&Sample]) -> Vec<MeasuredResidual> {
    let first = rows.len();
    let distance = |sample: &Sample| length(&sample.values[first..][..3]);
    let distances = samples.iter().map(|sample| distance(sample));
    let extent = distances.fold(LEAST_SIZE, f64::max);
    let measure = |(k, row): (usize, &ResidualKind)| {
        let values = samples.iter().map(|sample| sample.values[k]);
        let value = values.fold(0.0, |most: f64, value| {
            if value.abs() > most.abs() {
                value
            } else {
                most
            }
        });
        let size = if row.kind() == Kind::Translation {
            extent
        } else {
            1.0
        };
        let share = |sample: &&Sample| share(sample, k, (first, row.kind()), size);
        MeasuredResidual {
            value,
            size,
            share: samples.iter().map(share).fold(0.0, f64::max),
        }
    };
    rows.iter().enumerate().map(measure).collect()
}

/// The largest ratio, over all velocities, of a residual's rate to the motion; `first` is the place of the entries
/// of M.
fn share(sample: &Sample, residual: usize, (first, kind): (usize, Kind), size: f64) -> f64 {
    let whole = &sample.rates[first..];
    let of_velocity = |(k, rate): (usize, &f64)| {
        let column: Vec<f64> = whole.iter().map(|rates| rates[k]).collect();
        let (linear, angular) = column.split_at(3);
        // The rates of all nine products have twice the square of the rotation.
        let angular = length(angular) / 2.0_f64.sqrt();
        let motion = if kind == Kind::Translation {
            length(linear).max(angular * size)
        } else {
            angular
        };
        rate.abs() / motion.max(LEAST_MOTION * size)
    };
    let rates = sample.rates[residual].iter().enumerate();
    rates.map(of_velocity).fold(0.0, f64::max)
}

fn length(entries: &[f64]) -> f64 {
    let squares = entries.iter().map(|entry| entry * entry);
    squares.sum::<f64>().sqrt()
}
