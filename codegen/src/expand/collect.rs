//! Collects the generated module of a robot.
//!
//! In: the plans of its functions, or the errors. Out: a [`Module`] and all errors. A function that the robot cannot
//! have is an error if it was named, and left out if all functions were requested.

use super::about::about;
use super::batches;
use super::configurations::configurations;
use super::data::data;
use super::left_out::{functions_with_a_frame, leave_out};
use super::prepared::prepared;
#[cfg(feature = "files")]
use super::review::review;
use crate::accuracy::{RoundingModel, of_plan};
use crate::chain::Chain;
use crate::error::Errors;
use crate::module::{About, FoundError, GeneratedFunction, LeftOut, Module, Review};
use crate::plan::{Plan, Planned};
use crate::real::Real;
use crate::request::Request;

/// The generated module, and every error that was found.
pub(super) fn collect<'c>(
    chain: &Chain,
    plans: impl Iterator<Item = Planned<'c>>,
) -> (Module, Errors) {
    let request = &*chain.request;
    let mut errors = Errors::new();
    let mut functions = Vec::new();
    // A request of all functions leaves out those that the robot cannot have.
    let all = request.functions.is_empty();
    let without_frame = || chain.frames.is_empty().then(functions_with_a_frame);
    let mut left_out: Vec<LeftOut> = all.then(without_frame).flatten().into_iter().collect();
    for Planned { name, plan } in plans {
        match plan {
            Ok(plan) => functions.push(generated(plan, request)),
            Err(refusal) if all => leave_out(&mut left_out, name, &refusal),
            Err(refusal) => errors.append(refusal),
        }
    }
    let mut about = About {
        left_out,
        ..about(chain)
    };
    if request.batch
        && let Err(refusal) = batches::report(&functions, chain, &mut about)
    {
        errors.append(refusal);
    }
    let prepared = request.prepare.then(|| prepared(&functions, request));
    let prepared = prepared.and_then(|prepared| match prepared {
        Ok(prepared) => Some(prepared),
        Err(refusal) => {
            if errors.is_empty() {
                errors.append(refusal);
            }
            None
        }
    });
    let module = Module {
        about,
        spaces: chain.spaces().clone(),
        review: reviewed(chain, &functions),
        functions,
        data: data(chain),
        efforts: efforts(chain),
        radii: radii(chain),
        configurations: configurations(chain).collect(),
        base_values: base_values(chain),
        batch: request.batch,
        length: request.length(),
        scalar: request.scalar,
        reproducible: request.reproducible,
        sines: request.formulation.sines,
        parameters: request.parameters.clone(),
        prepared,
    };
    (module, errors)
}

/// The review of a file, if it is requested.
#[cfg(feature = "files")]
fn reviewed(chain: &Chain, functions: &[GeneratedFunction]) -> Option<Review> {
    let is_wanted = chain.request.review;
    is_wanted.then(|| review(chain, functions))
}

/// No review: this build writes no files.
#[cfg(not(feature = "files"))]
fn reviewed(_: &Chain, _: &[GeneratedFunction]) -> Option<Review> {
    None
}

/// The generated function of a plan, with the bounds of its results.
fn generated(plan: Plan<'_>, request: &Request) -> GeneratedFunction {
    let accuracy = of_plan(&plan, RoundingModel::of(request));
    let frame = plan.further_frame().map(str::to_owned);
    let error = plan.error;
    let found = FoundError {
        scalar: match request.scalar {
            Real::F32 => Real::F32,
            Real::F64 | Real::Generic => Real::F64,
        },
        relative: error.found,
        random: error.random,
        uphill: error.uphill,
    };
    GeneratedFunction {
        functions: plan.functions,
        frame,
        layout: plan.layout,
        program: plan.program,
        operation_count: plan.operation_count,
        accuracy,
        found: error.is_measured().then_some(found),
    }
}

/// The radius of each collision sphere.
fn radii(chain: &Chain) -> Vec<f64> {
    let radii = chain.spheres.iter().map(|sphere| {
        let radius = chain.graph.value(sphere.radius);
        radius
            .expect("radii are numbers of the description")
            .to_f64()
    });
    radii.collect()
}

/// Largest torque or force of each velocity; infinite if the description has none.
fn efforts(chain: &Chain) -> Vec<f64> {
    let efforts = chain.spaces().velocities.ids().map(|velocity| {
        let of = &chain.joints[chain.mover(velocity)].of;
        let mut joints = chain.description.joints.iter();
        let joint = joints.find(|joint| joint.name.text == *of && !joint.kind.has_several());
        let limits = joint.and_then(|joint| joint.limits);
        limits.map_or(f64::INFINITY, |limits| limits.effort)
    });
    efforts.collect()
}

/// Values of the base parameters, from the description.
fn base_values(chain: &Chain) -> Vec<f64> {
    let groups = chain.base_parameters.iter().flat_map(|base| &base.groups);
    groups.map(|group| group.value).collect()
}
