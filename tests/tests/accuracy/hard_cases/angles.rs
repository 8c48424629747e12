//! Angles of many full turns, and sums of angles.

use homogen_codegen::Function;
use homogen_codegen::formulation::Angles;
use homogen_codegen::layout::Layout;
use homogen_codegen::model::Algorithm;
use homogen_codegen::plan::program_by;
use homogen_codegen::schedule::{Operand, Program};
use homogen_codegen::space::{FrameId, Variable};
use homogen_tests::arguments::{self, Arguments};
use homogen_tests::big::Big;
use homogen_tests::metrics;
use homogen_tests::oracle::link_frames;
use homogen_tests::states::Random;
use homogen_tests::subjects::subject;
use homogen_tests::tested::{F32, F64, Flushed, Fused32, Fused64, Tested};

use crate::hard_cases::case::{Case, Metric, judge};
use crate::hard_cases::states::{of_size, single, states};

use Function::{ForwardKinematics, InverseDynamics};

pub const CASES: &[Case] = &[BIG_ID, BIG_FK, PARALLEL_ID, PARALLEL_FK];

/// The worst are 4.2 u of torques and 5.4 u of poses, as for small angles.
const BIG_ID: Case = Case::scaled("big_angles", InverseDynamics, 10.0);
const BIG_FK: Case = Case::scaled("big_angles/pose", ForwardKinematics, 10.0);

/// Measured independently of the program, since its S grows with the length of the common normals. The worst are 26 u
/// of torques and 8 u of poses, on both sides of the switch.
const PARALLEL_ID: Case =
    Case::scaled("axes_nearly_parallel", InverseDynamics, 60.0).measured_by(Metric::Carried);
const PARALLEL_FK: Case =
    Case::scaled("axes_nearly_parallel/pose", ForwardKinematics, 16.0).measured_by(Metric::Reach);

/// An angle of 10² to 10⁸ rad; every other one is next to a multiple of π/2.
fn big_angle(random: &mut Random) -> f64 {
    let angle = of_size(random, 2.0, 8.0);
    if random.chance(2) {
        let quarter = std::f64::consts::FRAC_PI_2;
        single((angle / quarter).round() * quarter)
    } else {
        angle
    }
}

/// Torques and poses at large angles.
#[test]
fn big_angles() {
    for (label, joints) in [("panda_class/0", 7), ("ur5_class/0", 6), ("spatial/6", 6)] {
        for case in [BIG_ID, BIG_FK] {
            judge(&[&case], label, |_| {
                states(336, joints, |arguments, random| {
                    arguments[Variable::Q].fill_with(|| big_angle(random));
                })
            });
        }
    }
}

/// Axes so nearly parallel that their common normal is far away, on both sides of 0.1002 rad, below which the generator
/// does not use it.
#[test]
fn axes_nearly_parallel() {
    for twist in ["1e-15", "1e-9", "1e-3", "0.1001", "0.1002", "0.3"] {
        for (case, count) in [(PARALLEL_ID, 168), (PARALLEL_FK, 60)] {
            judge(&[&case], &format!("twisted/{twist}"), |_| {
                states(count, 6, |_, _| ())
            });
        }
    }
}

/// Sines and cosines of large angles within 2 ulp; another test has the limit of 0.92 ulp.
#[test]
fn big_angles_sines() {
    let mut random = Random::new(23);
    for _ in 0..2000 {
        let angle = big_angle(&mut random);
        let (sine, cosine) = Big::new(angle).sin_cos();
        check_sines::<F64>(angle, &sine, &cosine);
        check_sines::<F32>(angle, &sine, &cosine);
        check_sines::<Flushed>(angle, &sine, &cosine);
        check_sines::<Fused32>(angle, &sine, &cosine);
        check_sines::<Fused64>(angle, &sine, &cosine);
    }
}

fn check_sines<T: Tested>(angle: f64, sine: &Big, cosine: &Big) {
    let found = T::literal(angle).sin_cos();
    let pairs = [(found.0, sine), (found.1, cosine)];
    let worst = metrics::largest(pairs.map(|(x, exact)| metrics::ulps::<T>(x.to_f64(), exact)));
    assert!(worst <= 2.0, "{angle:e} in {}: {worst} ulp", T::NAME);
}

/// Poses with merged angles of parallel axes, and with one rotation after the other, where two angles up to 10⁶ rad
/// nearly cancel. Each sum of angles is rounded before its sine, so rotations have errors of 2 u of the angles; what
/// cancels is exact. Products of rotations have errors of a few u at any angle.
#[test]
fn merged_angle() {
    // The number of joints before the parallel axes, the number of parallel axes, and the length of the arm [m].
    for (label, before, parallel, reach) in [("planar/2", 0, 2, 2.0), ("ur5_class/0", 1, 3, 1.3)] {
        let chain = subject(label).chain();
        let joints = chain.joints.len();
        let made = |angles| {
            let algorithm = Algorithm {
                angles,
                ..Algorithm::PLAIN
            };
            program_by(
                &chain,
                &[ForwardKinematics],
                FrameId::FIRST,
                Layout::DESCRIBED,
                algorithm,
            )
        };
        let (merged, products) = (made(Angles::Merged), made(Angles::Apart));
        // Sines of sums in one, of coordinates alone in the other.
        let sums = |program: &Program| {
            let sums = |angle: &&Operand| matches!(angle, Operand::Step(_));
            program.angles.iter().filter(sums).count()
        };
        assert_eq!((sums(&merged), sums(&products)), (parallel - 1, 0));
        let truth = link_frames::truth(&chain, ForwardKinematics, FrameId::FIRST);
        let mut worst = [[0.0_f64; 2]; 5];
        let mut random = Random::new(24);
        for k in 0..1200 {
            let mut arguments = arguments::random(joints, &mut random);
            let turns = &mut arguments[Variable::Q][before..before + parallel];
            turns[0] = single(match k % 3 {
                0 => 4.0 * random.unit(),
                1 => of_size(&mut random, 0.0, 6.0),
                _ => 1e6 * random.unit(),
            });
            turns[1] = match k % 4 {
                0 => single(1e-9 - turns[0]),
                1 => single(of_size(&mut random, -9.0, -3.0) - turns[0]),
                _ => single(4.0 * random.unit()),
            };
            let size = turns.iter().map(|q| q.abs()).sum::<f64>().max(1.0);
            let truth = link_frames::evaluate(&truth, &arguments);
            let errors = [
                absolute::<F64>([&merged, &products], &arguments, &truth, reach),
                absolute::<F32>([&merged, &products], &arguments, &truth, reach),
                absolute::<Flushed>([&merged, &products], &arguments, &truth, reach),
                absolute::<Fused32>([&merged, &products], &arguments, &truth, reach),
                absolute::<Fused64>([&merged, &products], &arguments, &truth, reach),
            ];
            for (worst, [merged, products]) in worst.iter_mut().zip(errors) {
                *worst = [worst[0].max(merged / size), worst[1].max(products)];
            }
        }
        println!("{label}: merged, by u max(1, Σ|q|), and products, by u: {worst:?}");
        for [merged, products] in worst {
            assert!(merged <= 2.0, "{label}: {merged} u max(1, Σ|q|)");
            assert!(products <= 5.0, "{label}: {products} u");
        }
    }
}

/// The largest errors of two programs for a pose, in u, relative to 1 for rotations and to the robot's size \[m\] for
/// translations.
fn absolute<T: Tested>(
    programs: [&Program; 2],
    arguments: &Arguments,
    truth: &[Big],
    reach: f64,
) -> [f64; 2] {
    let sizes: Vec<f64> = (0..12)
        .map(|entry| if entry % 4 == 3 { reach } else { 1.0 })
        .collect();
    programs.map(|program| {
        let found = metrics::results::<T>(program, arguments);
        metrics::largest(metrics::scaled::<T>(&found, truth, &sizes))
    })
}
