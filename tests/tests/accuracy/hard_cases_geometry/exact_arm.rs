//! Jacobians of an arm in 256 bits.
//!
//! In: a chain of revolute joints as data, and a configuration. Out: the columns of its three Jacobians by the
//! textbook's cross products of axes and lever arms, independent of the runtime.

use std::array::from_fn;

use homogen::{Chain, Pose, Screw};

use crate::hard_cases_geometry::exact::{
    Matrix, Vector, add, cross, dot, exact, exact_matrix, product, sub, transpose,
};
use crate::hard_cases_geometry::measure::Number;

/// A column: u, and b at the reference point.
pub type Column = [Vector; 2];

/// An arm in a configuration.
pub struct ExactArm {
    /// The pose of the end effector.
    pub tip: Place,
    /// The spatial Jacobian: reference point and axes of frame 0.
    pub spatial: Vec<Column>,
    /// The geometric Jacobian: reference point at the end effector, axes of frame 0.
    pub geometric: Vec<Column>,
    /// The body Jacobian: reference point and axes of the end effector.
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

/// The Jacobians of an arm in a configuration.
///
/// # Panics
/// If the axis of a joint is not the z axis of its frame.
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
        let rotate = |[x, y, z]: Vector| [&x * &cosine + &y * &sine, y * &cosine - x * &sine, z];
        place.r = place.r.map(rotate);
        places.push(place);
    }
    let end = chain.tip();
    let tip = moved(end.body.map_or(&base, |k| &places[k]), &end.placement);
    let about = |origin: &Vector| -> Vec<Column> {
        let column = |place: &Place| {
            let u = from_fn(|i| place.r[i][2].clone());
            let b = cross(&sub(&place.t, origin), &u);
            [u, b]
        };
        places.iter().map(column).collect()
    };
    let (spatial, geometric) = (about(&base.t), about(&tip.t));
    let back = transpose(&tip.r);
    let body = geometric
        .iter()
        .map(|column| column.each_ref().map(|v| rotated(&back, v)));
    let body = body.collect();
    ExactArm {
        tip,
        spatial,
        geometric,
        body,
    }
}

/// The sum of all distances between joints, a bound of the entries of b \[m\].
pub fn reach<const N: usize, const F: usize>(chain: &Chain<N, F>) -> f64 {
    let places = chain.joints.iter().map(|joint| joint.placement);
    let places = places.chain([chain.tip().placement]);
    places
        .map(|place| homogen::vector::norm(place.translation()))
        .sum()
}

/// The pose of a frame that is placed in another.
fn moved(place: &Place, by: &Pose<f64>) -> Place {
    Place {
        r: product(&place.r, &exact_matrix(by.rotation())),
        t: add(&place.t, &rotated(&place.r, &exact(by.translation()))),
    }
}

fn rotated(x: &Matrix, v: &Vector) -> Vector {
    from_fn(|i| dot(&x[i], v))
}
