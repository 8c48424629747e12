//! The Jacobians of an arm in numbers of 256 bits.
//!
//! In: a chain of revolute joints as data, and a posture. Out: the columns of its three Jacobians, each
//! axis crossed with the vector to the pole, as a textbook has it. It shares nothing with the runtime
//! but the description.

use std::array::from_fn;

use homogen::{Chain, Pose, Screw};

use crate::exact::{Matrix, Vector, add, cross, dot, exact, exact_matrix, product, sub, transpose};
use crate::measure::Number;

/// A column: u, and b at the pole.
pub type Column = [Vector; 2];

/// An arm at a posture.
pub struct ExactArm {
    /// The pose of the tip.
    pub tip: Place,
    /// About the origin of frame 0, in its axes.
    pub spatial: Vec<Column>,
    /// About the tip, in the axes of frame 0.
    pub geometric: Vec<Column>,
    /// About the tip, in its axes.
    pub body: Vec<Column>,
}

/// A pose.
#[derive(Clone)]
pub struct Place {
    /// R.
    pub r: Matrix,
    /// t.
    pub t: Vector,
}

/// The arm at a posture.
///
/// # Panics
/// Where a joint does not turn about the z axis of its frame.
pub fn at<T: Number, const N: usize, const F: usize>(chain: &Chain<N, F>, q: &[T; N]) -> ExactArm {
    let identity = exact_matrix(Pose::<f64>::identity().rotation());
    let base = Place {
        r: identity,
        t: exact([0.0; 3]),
    };
    let mut places: Vec<Place> = Vec::new();
    for (joint, q) in chain.joints.iter().zip(q) {
        assert_eq!(joint.screw, Screw::revolute([0.0, 0.0, 1.0], [0.0; 3]));
        let parent = joint.parent.map_or(&base, |k| &places[k]);
        let mut place = moved(parent, &joint.placement);
        let (sine, cosine) = q.big().sin_cos();
        let turned = |[x, y, z]: Vector| [&x * &cosine + &y * &sine, y * &cosine - x * &sine, z];
        place.r = place.r.map(turned);
        places.push(place);
    }
    let end = chain.tip();
    let tip = moved(end.body.map_or(&base, |k| &places[k]), &end.placement);
    let about = |pole: &Vector| -> Vec<Column> {
        let column = |place: &Place| {
            let u = from_fn(|i| place.r[i][2].clone());
            let b = cross(&sub(&place.t, pole), &u);
            [u, b]
        };
        places.iter().map(column).collect()
    };
    let (spatial, geometric) = (about(&base.t), about(&tip.t));
    let back = transpose(&tip.r);
    let body = geometric
        .iter()
        .map(|column| column.each_ref().map(|v| turn(&back, v)));
    let body = body.collect();
    ExactArm {
        tip,
        spatial,
        geometric,
        body,
    }
}

/// A length that no entry of b exceeds: the sum of all distances between joints.
pub fn reach<const N: usize, const F: usize>(chain: &Chain<N, F>) -> f64 {
    let places = chain.joints.iter().map(|joint| joint.placement);
    let places = places.chain([chain.tip().placement]);
    places
        .map(|place| homogen::vector::norm(place.translation()))
        .sum()
}

/// M₀ₖ of a frame placed in another.
fn moved(place: &Place, by: &Pose<f64>) -> Place {
    Place {
        r: product(&place.r, &exact_matrix(by.rotation())),
        t: add(&place.t, &turn(&place.r, &exact(by.translation()))),
    }
}

fn turn(x: &Matrix, v: &Vector) -> Vector {
    from_fn(|i| dot(&x[i], v))
}
