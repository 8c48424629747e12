//! External wrenches on bodies.
//!
//! In: the links with a wrench, in their frames or in frame 0, and an algorithm. Out: each Φ in the frame of the
//! matrices of its body's joint. Recursions subtract them from the torques.

use std::iter::successors;

use super::algorithm::Algorithm;
use super::carry::{joints, left, placed};
use super::state::State;
use crate::chain::BodyId;
use crate::expression::Term;
use crate::formulation::Frame;
use crate::layout::Bodies;
use crate::list::List;
use crate::matrix::{Action, Pose, Rotation};

/// The external wrenches, each with its body, in the frame of the matrices of the body's joint.
pub fn external<'g>(
    bodies: &Bodies<'g>,
    state: &State<'g>,
    algorithm: Algorithm,
) -> Vec<(BodyId, Action<Term<'g>>)> {
    if bodies.external.is_empty() {
        return Vec::new();
    }
    let left = left(bodies, state, algorithm);
    let joints = joints(bodies, state, algorithm);
    let external = bodies.external.iter().enumerate();
    external
        .filter_map(|(k, &(body, placement))| {
            let body = body?;
            let action = state.action(k);
            let action = match (bodies.external_in_frame_0, algorithm.frame) {
                (true, Frame::Base) => action,
                (true, Frame::Link) => {
                    let inwards = |&body: &BodyId| joints[body].parent;
                    let mut outwards: Vec<BodyId> = successors(Some(body), inwards).collect();
                    outwards.reverse();
                    outwards.iter().fold(action, |action, &k| {
                        let placed = action.seen_from(joints[k].placement);
                        placed.seen_from(joints[k].displacement())
                    })
                }
                (false, _) => {
                    let rotated = match left[body] {
                        Some(turn) => {
                            let angle = turn.sine_and_cosine(state.graph);
                            Pose::rotation(Rotation::about_z(angle)) * placement
                        }
                        None => placement,
                    };
                    let seen = action.change_frame(rotated);
                    match algorithm.frame {
                        Frame::Link => seen,
                        Frame::Base => {
                            let poses: List<BodyId, _> = placed(&joints).into();
                            seen.change_frame(poses[body].1)
                        }
                    }
                }
            };
            Some((body, action))
        })
        .collect()
}
