//! The feature `serde`: written matrices are read back bit for bit.

use crate::sample::Random;
use homogen::{
    Acceleration, Action, Direction, Displacement, Inertia, Momentum, Point, Pose, Real, Screw,
    Velocity,
};
use serde::{Serialize, de::DeserializeOwned};
use std::fmt::Debug;

fn same<X: Serialize + DeserializeOwned + PartialEq + Debug>(x: &X) {
    let text = serde_json::to_string(x).expect("finite numbers");
    let back: X = serde_json::from_str(&text).expect("what was written");
    assert_eq!(&back, x);
}

fn written_matrices_read_back<T: Real + Serialize + DeserializeOwned>() {
    let mut random = Random::new(190);
    for _ in 0..20 {
        let w = random.velocity::<T>();
        same(&random.pose::<T>());
        same(&Displacement::from_relative_pose(random.pose::<T>()));
        same(&random.screw::<T>());
        same(&w);
        same(&Acceleration::from_parts(
            random.vector::<T>(),
            w.omega(),
            w.v(),
        ));
        same(&random.inertia::<T>());
        same(&Momentum::new(random.vector::<T>(), random.vector()));
        same(&Action::new(random.vector::<T>(), random.vector()));
        same(&Point(random.vector::<T>()));
        same(&Direction(random.vector::<T>()));
    }
}

#[test]
fn written_names_are_those_of_the_blocks() {
    let text =
        serde_json::to_string(&Velocity::new([1.0, 2.0, 3.0], [4.0, 5.0, 6.0])).expect("finite");
    assert_eq!(text, r#"{"omega":[1.0,2.0,3.0],"v":[4.0,5.0,6.0]}"#);
    let text = serde_json::to_string(&Screw::prismatic([0.0, 0.0, 1.0])).expect("finite");
    assert_eq!(text, r#"{"u":[0.0,0.0,0.0],"b":[0.0,0.0,1.0]}"#);
    assert!(serde_json::from_str::<Inertia<f64>>(r#"{"mass":1.0}"#).is_err());
    assert!(serde_json::from_str::<Pose<f64>>("{}").is_err());
}

in_both_precisions! {
    written_matrices_read_back
}
