//! Large distances from the origin, and many joints.

use homogen::generic;
use homogen_codegen::Function;
use homogen_codegen::space::Variable;
use homogen_robots::shipped::PandaClass;
use homogen_tests::metrics;
use homogen_tests::tested::{F64, Tested};

use crate::hard_cases::case::{Bench, Case, Growth, Metric, judge};
use crate::hard_cases::states::{states, third};

use Function::{Bias, ForwardKinematics, Gravity, InverseDynamics, MassMatrix};

pub const CASES: &[Case] = &[FAR_ID, FAR_GRAVITY, FAR_BIAS, FAR_MASS, FK, ID];

/// The worst is 3.1 u, the same at every distance.
const FAR_ID: Case = Case::scaled("base_far_d", InverseDynamics, 10.0);
const FAR_GRAVITY: Case = Case::scaled("base_far_d/gravity", Gravity, 10.0);
const FAR_BIAS: Case = Case::scaled("base_far_d/bias", Bias, 10.0);
const FAR_MASS: Case = Case::scaled("base_far_d/mass_matrix", MassMatrix, 10.0);
/// The target was 4 u per joint; the worst is 2.1 u times the square root of the number of joints.
const FK: Case = Case::scaled("chain_fk_n", ForwardKinematics, 4.0)
    .measured_by(Metric::Reach)
    .growing(Growth::Root);
/// The worst is 5.8 u per joint, of eight joints, and less for more.
const ID: Case = Case::scaled("chain_id_n", InverseDynamics, 10.0)
    .measured_by(Metric::Carried)
    .growing(Growth::Joints);

/// The arm of seven joints at 0, 1, 10 … 10⁶ m to the side and up.
#[test]
fn base_far_d() {
    for distance in ["0", "1", "1e1", "1e2", "1e3", "1e4", "1e5", "1e6"] {
        let label = format!("panda_class/{distance}");
        for (case, count) in [
            (FAR_ID, 126),
            (FAR_GRAVITY, 24),
            (FAR_BIAS, 24),
            (FAR_MASS, 24),
        ] {
            judge(&[&case], &label, |_| states(count, 7, |_, _| ()));
        }
    }
}

/// The loss of frame 0, which grows with the square of the distance; the reason why link frames are the default.
#[test]
fn base_far_d_in_frame_0() {
    let worst = |distance: f64| {
        let bench = Bench::new(&format!("panda_class/{distance}"), InverseDynamics);
        let near = PandaClass::chain();
        let mut chain = near;
        let aside = homogen::Pose::from_translation([distance, 0.0, distance]);
        chain.joints[0].placement = aside * near.joints[0].placement;
        let errors = states(60, 7, |_, _| ()).into_iter().map(|state| {
            let [q, qd, qdd] = [Variable::Q, Variable::Qd, Variable::Qdd]
                .map(|variable| std::array::from_fn(|k| state[variable][k]));
            let found = generic::inverse_dynamics(&chain, &q, &qd, &qdd);
            metrics::relative::<F64>(&found, &bench.truth(&state))
        });
        metrics::largest(errors) * F64::ROUNDOFF
    };
    let errors = [1e2, 1e3, 1e4].map(worst);
    println!("relative errors of frame 0 at 100 m, 1 km and 10 km: {errors:?}");
    for pair in errors.windows(2) {
        let growth = pair[1] / pair[0];
        assert!((30.0..300.0).contains(&growth), "{growth}");
    }
    assert!(
        errors[2] > 1e-9,
        "frame 0 is more accurate than documented: {errors:?}"
    );
}

/// Poses of 8 to 512 links.
#[test]
fn chain_fk_n() {
    for (links, count) in [
        (8, 360),
        (16, 300),
        (32, 180),
        (64, 90),
        (128, 48),
        (256, 18),
        (512, 6),
    ] {
        judge(&[&FK], &format!("spatial/{links}"), |_| {
            states(third(count), links, |_, _| ())
        });
    }
}

/// Torques of 2 to 64 links, joint by joint.
#[test]
fn chain_id_n() {
    for (links, count) in [(2, 240), (4, 240), (8, 240), (16, 120), (32, 60), (64, 24)] {
        for family in ["spatial", "tilted"] {
            let label = format!("{family}/{links}");
            judge(&[&ID], &label, |_| states(third(count), links, |_, _| ()));
        }
    }
}
