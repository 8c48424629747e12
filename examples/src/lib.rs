//! Shared code of the examples.
//!
//! Controllers, a filter, an optimiser and the design of exciting motions for any robot; random states, functions called by name, times with the machine
//! of the measurement. Users of `homogen` do not need this crate. Its documentation tests compile and run the blocks of
//! Rust in the README and the guide.

pub mod bars;
pub mod bound;
pub mod control;
pub mod drawing;
pub mod entries;
pub mod excitation;
pub mod filter;
pub mod listing;
pub mod machine;
pub mod motion;
pub mod operation_count;
pub mod optimal;
pub mod states;
pub mod timing;

/// Pages whose blocks of Rust are compiled and run.
#[cfg(doctest)]
mod guide {
    #[doc = include_str!("../../README.md")]
    struct Readme;
    #[doc = include_str!("../../runtime/README.md")]
    struct ReadmeOfTheRuntime;
    #[doc = include_str!("../../codegen/README.md")]
    struct ReadmeOfTheEngine;
    #[doc = include_str!("../../guide/src/first-robot.md")]
    struct FirstRobot;
    #[doc = include_str!("../../guide/src/conventions.md")]
    struct Conventions;
    #[doc = include_str!("../../guide/src/troubleshooting.md")]
    struct Troubleshooting;
    #[doc = include_str!("../../guide/src/examples.md")]
    struct Examples;
    #[doc = include_str!("../../guide/src/glossary.md")]
    struct Glossary;
    #[doc = include_str!("../../guide/src/fields.md")]
    struct Fields;
    #[doc = include_str!("../../guide/src/page.md")]
    struct Page;
    #[doc = include_str!("../../guide/src/command-line.md")]
    struct CommandLine;
    #[doc = include_str!("../../guide/src/build-script.md")]
    struct BuildScript;
    #[doc = include_str!("../../guide/src/python.md")]
    struct Python;
    #[doc = include_str!("../../guide/src/from-pinocchio.md")]
    struct FromPinocchio;
    #[doc = include_str!("../../guide/src/from-mujoco.md")]
    struct FromMujoco;
    #[doc = include_str!("../../guide/src/from-robotics-toolbox.md")]
    struct FromRoboticsToolbox;
    #[doc = include_str!("../../guide/src/cpp.md")]
    struct Cpp;
    #[doc = include_str!("../../guide/src/solvers.md")]
    struct Solvers;
    #[doc = include_str!("../../guide/src/functions.md")]
    struct Functions;
    #[doc = include_str!("../../guide/src/joints.md")]
    struct Joints;
    #[doc = include_str!("../../guide/src/collisions.md")]
    struct Collisions;
    #[doc = include_str!("../../guide/src/loops.md")]
    struct Loops;
    #[doc = include_str!("../../guide/src/what-is-read.md")]
    struct WhatIsRead;
    #[doc = include_str!("../../guide/src/xacro.md")]
    struct Xacro;
    #[doc = include_str!("../../guide/src/mjcf.md")]
    struct Mjcf;
    #[doc = include_str!("../../guide/src/sdf.md")]
    struct Sdf;
    #[doc = include_str!("../../guide/src/derivatives.md")]
    struct Derivatives;
    #[doc = include_str!("../../guide/src/time-steps.md")]
    struct TimeSteps;
    #[doc = include_str!("../../guide/src/inverse-kinematics.md")]
    struct InverseKinematics;
    #[doc = include_str!("../../guide/src/batches.md")]
    struct Batches;
    #[doc = include_str!("../../guide/src/cluster.md")]
    struct Cluster;
    #[doc = include_str!("../../guide/src/embedded.md")]
    struct Embedded;
    #[doc = include_str!("../../guide/src/large-robots.md")]
    struct LargeRobots;
    #[doc = include_str!("../../guide/src/generated-code.md")]
    struct GeneratedCode;
    #[doc = include_str!("../../guide/src/formulations.md")]
    struct Formulations;
    #[doc = include_str!("../../guide/src/accuracy.md")]
    struct Accuracy;
    #[doc = include_str!("../../guide/src/paper.md")]
    struct Paper;
    #[doc = include_str!("../../guide/src/coming-from.md")]
    struct ComingFrom;
    #[doc = include_str!("../../guide/src/how-it-is-built.md")]
    struct HowItIsBuilt;
}
