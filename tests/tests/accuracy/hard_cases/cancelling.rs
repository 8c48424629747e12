//! States at which large terms nearly cancel, or dominate everything else.

use homogen_codegen::Function;
use homogen_codegen::chain::Chain;
use homogen_codegen::layout::Layout;
use homogen_codegen::model::Algorithm;
use homogen_codegen::plan::program_by;
use homogen_codegen::schedule::Program;
use homogen_codegen::space::{FrameId, Variable};
use homogen_tests::arguments::{self, Arguments};
use homogen_tests::metrics;
use homogen_tests::states::Random;
use homogen_tests::tested::F64;

use crate::hard_cases::case::{Case, judge};
use crate::hard_cases::states::{of_size, single, states};

use Function::{Bias, Gravity, InverseDynamics};

pub const CASES: &[Case] = &[BALANCED, FALLING, FAST_ID, FAST_BIAS, CANCEL];

/// The worst is 6.6 u.
const BALANCED: Case = Case::scaled("gravity_balanced", Gravity, 10.0);
/// The worst is 0.37 u, the rounding of gravity to the type.
const FALLING: Case = Case::scaled("gravity_balanced/falling", InverseDynamics, 2.0);
/// The worst is 3.3 u.
const FAST_ID: Case = Case::scaled("spin_fast", InverseDynamics, 10.0);
const FAST_BIAS: Case = Case::scaled("spin_fast/bias", Bias, 10.0);
/// The worst is 3.0 u.
const CANCEL: Case = Case::scaled("coriolis_cancel", Bias, 10.0);

/// All links upright or hanging, to 10⁻¹² … 10⁻² rad; and in free fall with the base.
#[test]
fn gravity_balanced() {
    let upright = |arguments: &mut Arguments, random: &mut Random, first: usize| {
        for (k, angle) in arguments[Variable::Q].iter_mut().enumerate().skip(first) {
            let quarters = if k == first {
                1.0
            } else {
                2.0 * f64::from(u8::from(random.chance(2)))
            };
            let off = of_size(random, -12.0, -2.0);
            *angle = single(quarters * std::f64::consts::FRAC_PI_2 + off);
        }
    };
    for links in [2, 3, 6] {
        judge(&[&BALANCED], &format!("planar/{links}"), |_| {
            states(336, links, |arguments, random| {
                upright(arguments, random, 0);
            })
        });
        judge(&[&FALLING], &format!("lift/{links}"), |_| {
            states(168, links + 1, |arguments, random| {
                upright(arguments, random, 1);
                arguments[Variable::Qd].fill(0.0);
                arguments[Variable::Qdd].fill(0.0);
                arguments[Variable::Qdd][0] = single(-9.81);
                if random.chance(2) {
                    arguments[Variable::Qdd][0] += of_size(random, -5.0, -1.0);
                    arguments[Variable::Qdd][0] = single(arguments[Variable::Qdd][0]);
                }
            })
        });
    }
}

/// Rates of 10³ to 10⁴ rad/s, at which gravity is negligible.
#[test]
fn spin_fast() {
    for (label, joints) in [("panda_class/0", 7), ("spatial/6", 6), ("planar/6", 6)] {
        for (case, count) in [(FAST_ID, 336), (FAST_BIAS, 60)] {
            judge(&[&case], label, |_| {
                states(count, joints, |arguments, random| {
                    for rate in &mut arguments[Variable::Qd] {
                        *rate = of_size(random, 3.0, 4.0);
                    }
                })
            });
        }
    }
}

/// Rates at which the first joint's torque vanishes: a root of the quadratic polynomial that it is of the rate of one
/// joint.
#[test]
fn coriolis_cancel() {
    for (label, joints) in [
        ("floating/2", 2),
        ("floating/4", 4),
        ("floating_panda_class/0", 7),
    ] {
        judge(&[&CANCEL], label, |chain| {
            let bias = bias(chain);
            states(336, joints, |arguments, random| {
                let of = 1 + random.below(joints - 1);
                if let Some(root) = root(&bias, arguments, of) {
                    arguments[Variable::Qd][of] = single(root);
                }
            })
        });
    }
    some_torques_are_cancelled(&homogen_tests::subjects::subject("floating/4").chain());
}

/// The program of the bias torques, in the layout of the description.
fn bias(chain: &Chain) -> Program {
    program_by(
        chain,
        &[Bias],
        FrameId::FIRST,
        Layout::DESCRIBED,
        Algorithm::PLAIN,
    )
}

/// A rate of a joint at which the first torque is zero, if there is one.
fn root(bias: &Program, arguments: &Arguments, of: usize) -> Option<f64> {
    let at = |rate: f64| {
        let mut arguments = arguments.clone();
        arguments[Variable::Qd][of] = rate;
        metrics::results::<F64>(bias, &arguments)[0]
    };
    let (below, constant, above) = (at(-1.0), at(0.0), at(1.0));
    let (square, linear) = (
        f64::midpoint(above, below) - constant,
        (above - below) / 2.0,
    );
    let discriminant = linear * linear - 4.0 * square * constant;
    let root = (-linear - discriminant.sqrt().copysign(linear)) / (2.0 * square);
    root.is_finite()
        .then_some(root)
        .filter(|root| root.abs() < 1e6)
}

/// The states are hard: most such torques lose five digits of S.
fn some_torques_are_cancelled(chain: &Chain) {
    let bias = bias(chain);
    let mut random = Random::new(27);
    let mut cancelled = 0;
    for _ in 0..100 {
        let mut arguments = arguments::random(chain.joints.len(), &mut random);
        let Some(root) = root(&bias, &arguments, 1) else {
            continue;
        };
        arguments[Variable::Qd][1] = single(root);
        let torque = metrics::results::<F64>(&bias, &arguments)[0];
        let size = metrics::sizes::<F64>(&bias, &arguments)[0];
        cancelled += usize::from(torque.abs() < 1e-5 * size);
    }
    assert!(cancelled > 30, "{cancelled} of 100");
}
