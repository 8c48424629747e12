//! The feature `approx`: equality within a tolerance, entry by entry.

use crate::sample::Random;
use approx::{abs_diff_eq, relative_eq, ulps_eq};
use homogen::{
    Acceleration, Action, Direction, Displacement, Inertia, Momentum, Point, Pose, Screw, Velocity,
};

/// True if the comparisons distinguish `x` from `y`, which differs in one stored number by 1e-6.
macro_rules! told_apart {
    ($x:expr, $y:expr) => {
        let (x, y) = ($x, $y);
        assert!(abs_diff_eq!(x, x) && relative_eq!(x, x) && ulps_eq!(x, x));
        assert!(abs_diff_eq!(x, y, epsilon = 1e-5) && !abs_diff_eq!(x, y, epsilon = 1e-7));
        assert!(relative_eq!(x, y, epsilon = 1e-5) && !relative_eq!(x, y, epsilon = 1e-7));
        assert!(ulps_eq!(x, y, epsilon = 1e-5) && !ulps_eq!(x, y, epsilon = 1e-7));
    };
}

#[test]
fn every_stored_number_counts() {
    let mut random = Random::new(200);
    let rows: [[f64; 3]; 3] = [random.vector(), random.vector(), random.vector()];
    let (a, b) = (random.vector::<f64>(), random.vector::<f64>());
    for i in 0..3 {
        let mut c = b;
        c[i] += 1e-6;
        told_apart!(Pose::new(rows, b), Pose::new(rows, c));
        told_apart!(Displacement::new(rows, b), Displacement::new(rows, c));
        told_apart!(Acceleration::new(rows, b), Acceleration::new(rows, c));
        told_apart!(Screw::new(a, b), Screw::new(a, c));
        told_apart!(Screw::new(b, a), Screw::new(c, a));
        told_apart!(Velocity::new(a, b), Velocity::new(a, c));
        told_apart!(Velocity::new(b, a), Velocity::new(c, a));
        told_apart!(Momentum::new(a, b), Momentum::new(a, c));
        told_apart!(Momentum::new(b, a), Momentum::new(c, a));
        told_apart!(Action::new(a, b), Action::new(a, c));
        told_apart!(Action::new(b, a), Action::new(c, a));
        told_apart!(Point(b), Point(c));
        told_apart!(Direction(b), Direction(c));
        let six = |x: [f64; 3]| [x[0], x[1], x[2], 0.5, 0.25, 0.125];
        told_apart!(Inertia::new(six(b), a, 1.0), Inertia::new(six(c), a, 1.0));
        told_apart!(Inertia::new(six(a), b, 1.0), Inertia::new(six(a), c, 1.0));
        for j in 0..3 {
            let mut turned = rows;
            turned[i][j] += 1e-6;
            told_apart!(Pose::new(rows, a), Pose::new(turned, a));
            told_apart!(Displacement::new(rows, a), Displacement::new(turned, a));
            told_apart!(Acceleration::new(rows, a), Acceleration::new(turned, a));
        }
    }
    for k in 0..6 {
        let moments = [1.0, 2.0, 3.0, 0.1, 0.2, 0.3];
        let mut other = moments;
        other[k] += 1e-6;
        told_apart!(Inertia::new(moments, a, 1.0), Inertia::new(other, a, 1.0));
    }
    told_apart!(
        Inertia::new([1.0; 6], a, 1.0),
        Inertia::new([1.0; 6], a, 1.0 + 1e-6)
    );
}
