//! States at which programs are measured.
//!
//! In: a chain and a type of numbers. Out: arguments of all functions, exact in that type: a sequence that fills the
//! range of the robot evenly, one that fills all angles, and states near a given one.

use crate::chain::Chain;
use crate::list::Id;
use crate::quaternion::of_length_1;
use crate::random::Random;
use crate::range::Range;
use crate::real::Real;
use crate::space::{Arguments, Kind, Variable};

/// Share of the range for states near the configuration of the description.
const NEAR: f64 = 1e-3;

/// Size of joint forces and torques \[N m or N\]: so small that most robots' accelerations come from the motion.
const TORQUE: f64 = 4.0;

/// Largest change of an entry from a state to one near it, relative to its range.
const STEP: f64 = 0.2;

/// The angles of a state.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum AngleRange {
    /// Within the limits of the joints.
    Limited,
    /// Any: a controller may overshoot a limit, a simulation may have none, and a singular configuration beyond the
    /// limits acts before it is reached.
    Any,
}

/// The ranges from which states are drawn.
pub(super) struct StateRanges<'c> {
    chain: &'c Chain,
    scalar: Real,
    limited: Arguments<[f64; 2]>,
    any: Arguments<[f64; 2]>,
}

impl<'c> StateRanges<'c> {
    pub(super) fn of(chain: &'c Chain, scalar: Real) -> Self {
        let (spaces, range) = (chain.spaces(), Range::of(chain));
        let limited = Arguments::of(|variable| match variable {
            Variable::Q => range.turns_with_digits(),
            _ if is_constant(variable) => vec![[1.0; 2]; spaces.len(variable.space())],
            Variable::Tau | Variable::Actions => {
                vec![[-TORQUE, TORQUE]; spaces.len(variable.space())]
            }
            _ => range.arguments[variable].clone(),
        });
        let mut any = limited.clone();
        for (entry, ends) in spaces.coordinates.iter().zip(&mut any[Variable::Q]) {
            if let Some(size) = Variable::Q
                .usual(entry.kind)
                .filter(|_| entry.kind == Kind::Rotation)
            {
                *ends = [ends[0].min(-size), ends[1].max(size)];
            }
        }
        Self {
            chain,
            scalar,
            limited,
            any,
        }
    }

    /// A state of a sequence that fills the range evenly: multiples of the golden ratio and of roots. Every eighth
    /// state is near the configuration of the description, in which axes and links are in line.
    pub(super) fn numbered(&self, number: usize, angles: AngleRange) -> Arguments<f64> {
        let ranges = match angles {
            AngleRange::Limited => &self.limited,
            AngleRange::Any => &self.any,
        };
        let is_near = number % 8 == 7;
        let step = u32::try_from(number + 1).map_or(1.0, f64::from);
        let mut entry = 0.0_f64;
        let mut next = |[lower, upper]: [f64; 2]| {
            entry += 1.0;
            let share = 0.5 + step * 0.618_033_988_749_895 * entry.sqrt();
            Real::F32.rounded(lower + (upper - lower) * share.fract())
        };
        let mut arguments = Arguments::of(|variable| {
            let ends = ranges[variable].iter();
            ends.map(|&[lower, upper]| {
                if is_constant(variable) {
                    return lower;
                }
                if is_near && variable == Variable::Q {
                    let zero = 0.0_f64.clamp(lower, upper);
                    return next([lower, upper].map(|end| zero + NEAR * (end - zero)));
                }
                next([lower, upper])
            })
            .collect()
        });
        for first in self.chain.spaces().quaternions() {
            let entries = quaternion(&mut arguments, first.index());
            // x, y, z, w: no rotation if all but w are zero.
            let small = if is_near { 0 } else { number % 4 };
            if is_near {
                entries[3] = 1.0;
            }
            *entries = of_length_1(*entries, small, self.scalar);
        }
        arguments
    }

    /// A state near another one, at any angles: half of its entries are changed, within their ranges.
    pub(super) fn near(&self, state: &Arguments<f64>, random: &mut Random) -> Arguments<f64> {
        let mut arguments = state.clone();
        let read = Variable::ALL
            .into_iter()
            .filter(|of| *of == Variable::Qdd || !is_constant(*of));
        for variable in read {
            for (entry, &[lower, upper]) in arguments[variable].iter_mut().zip(&self.any[variable])
            {
                if random.unit() < 0.5 {
                    let moved = *entry + STEP * (upper - lower) * (2.0 * random.unit() - 1.0);
                    // Reflected at the ends, so that no state is more frequent than another.
                    let moved = if moved > upper {
                        2.0 * upper - moved
                    } else {
                        moved
                    };
                    let moved = if moved < lower {
                        2.0 * lower - moved
                    } else {
                        moved
                    };
                    *entry = Real::F32.rounded(moved);
                }
            }
        }
        for first in self.chain.spaces().quaternions() {
            let entries = quaternion(&mut arguments, first.index());
            let sizes = entries.map(f64::abs).into_iter().enumerate();
            let small = sizes.min_by(|(_, one), (_, other)| one.total_cmp(other));
            let small = small.map_or(0, |(small, _)| small);
            *entries = of_length_1(*entries, small, self.scalar);
        }
        arguments
    }
}

/// True if an argument is the same at all states: no measured result depends on it, but another function beside a
/// measured one may read it.
const fn is_constant(variable: Variable) -> bool {
    matches!(variable, Variable::Qdd | Variable::Wrench) || variable.is_change()
}

/// The entries of the quaternion that begins at a coordinate.
fn quaternion(arguments: &mut Arguments<f64>, first: usize) -> &mut [f64; 4] {
    let entries = arguments[Variable::Q][first..].first_chunk_mut();
    entries.expect("a quaternion has four entries")
}
