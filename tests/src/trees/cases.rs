//! Choice of the programs to run for a robot.
//!
//! In: a chain and a seed. Out: for each function, the engine's default choice and a random one.

use std::fmt;

use homogen_codegen::Function;
use homogen_codegen::chain::Chain;
use homogen_codegen::formulation::{Angles, Formulation, Forward, Frame, Parameters, Products};
use homogen_codegen::layout::Layout;
use homogen_codegen::model::Algorithm;

use crate::oracle::frame_0;
use crate::states::Random;

/// The amount of testing of a robot.
#[derive(Clone, Copy, Debug)]
pub struct Effort {
    /// States that each program runs at.
    pub states: usize,
    /// The number of moving joints up to which every function is tested with the default choice, which takes time;
    /// longer robots have a part of the functions tested so.
    pub all_up_to: usize,
}

/// The source of the choice of layout and algorithm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Choice {
    /// The engine: the default.
    Default,
    /// The engine, within a formulation.
    Within(Formulation),
    /// This layout and this algorithm.
    By(Layout, Algorithm),
}

/// A program to run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Case {
    /// Its function.
    pub function: Function,
    /// Its frame among those of the chain, modulo their number.
    pub frame: usize,
    /// The choice of layout and algorithm.
    pub choice: Choice,
}

/// The programs to run: every function with the default choice and with a random one.
#[must_use]
pub fn cases(chain: &Chain, seed: u64, effort: Effort) -> Vec<Case> {
    let mut random = Random::new(seed);
    let share = chain.joints.len().div_ceil(effort.all_up_to);
    let mut cases = Vec::new();
    // The true value of a Hessian takes longer than those of all other functions.
    let hessian = frame_0::HESSIANS[random.below(frame_0::HESSIANS.len())];
    for function in frame_0::functions().chain([hessian]) {
        let frame = random.below(64);
        let own = random.chance(share);
        if own {
            let choice = Choice::Default;
            cases.push(Case {
                function,
                frame,
                choice,
            });
        }
        let choice = if own && random.chance(8) {
            Choice::Within(formulation(chain, function, &mut random))
        } else {
            by(chain, function, &mut random)
        };
        cases.push(Case {
            function,
            frame,
            choice,
        });
    }
    cases
}

fn formulation(chain: &Chain, function: Function, random: &mut Random) -> Formulation {
    let mut formulation = Formulation::default()
        .with_frame(*random.choose(&[Frame::Link, Frame::Base]))
        .with_parameters(*random.choose(&[Parameters::Regrouped, Parameters::Raw]))
        .with_angles(*random.choose(&[Angles::Apart, Angles::Merged]))
        .with_products(*random.choose(&[Products::Fused, Products::Unfused]));
    if function == Function::ForwardDynamics {
        formulation.forward = Some(forward(chain, random));
        if formulation.check().is_err() {
            formulation.frame = Frame::Link;
        }
    }
    formulation
}

fn forward(chain: &Chain, random: &mut Random) -> Forward {
    // The articulated-body algorithm cannot have mimic joints.
    let has_mimics = chain.joints.len() > chain.spaces().velocities.len();
    match random.below(4) {
        0 if !has_mimics => Forward::Articulated,
        refinements => Forward::MassMatrix {
            refinements: refinements.saturating_sub(1),
        },
    }
}

fn by(chain: &Chain, function: Function, random: &mut Random) -> Choice {
    let mut layouts = if function.needs_a_frame() {
        Layout::for_kinematics(chain)
    } else {
        Layout::for_dynamics(chain)
    };
    layouts.push(Layout::DESCRIBED);
    let mut layout = *random.choose(&layouts);
    let mut algorithm = Algorithm {
        frame: *random.choose(&[Frame::Link, Frame::Base]),
        angles: *random.choose(&[Angles::Apart, Angles::Merged]),
        ..*random.choose(&function.algorithms())
    };
    if function == Function::ForwardDynamics {
        algorithm.forward = forward(chain, random);
        // Articulated bodies need the inertias of real bodies.
        if algorithm.forward == Forward::Articulated {
            (layout.regroup, algorithm.frame) = (false, Frame::Link);
        }
    }
    Choice::By(layout, algorithm)
}

impl Case {
    /// True if the recursions run in frame 0, which is less accurate far from its origin.
    #[must_use]
    pub fn in_frame_0(self) -> bool {
        match self.choice {
            Choice::Default => false,
            Choice::Within(formulation) => formulation.frame == Frame::Base,
            Choice::By(_, algorithm) => algorithm.frame == Frame::Base,
        }
    }
}

impl fmt::Display for Case {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            function,
            frame,
            choice,
        } = self;
        write!(out, "{}, frame {frame}, {choice:?}", function.name())
    }
}
