//! Actions of the surroundings on bodies.
//!
//! In: the links on which they are, in whose frames or in frame 0, and a way. Out: each as Φ where the matrices of
//! its body's joint are. What they do to torques is for the recursions.

use std::iter::successors;

use super::carry::{joints, left, placed};
use super::state::State;
use super::way::Way;
use crate::chain::BodyId;
use crate::expression::Term;
use crate::formulation::Frame;
use crate::layout::Bodies;
use crate::list::List;
use crate::matrix::{Action, Pose, Rotation};

/// The actions from outside, each on a body, where the matrices of its joint are.
pub fn outside<'g>(
    bodies: &Bodies<'g>,
    state: &State<'g>,
    way: Way,
) -> Vec<(BodyId, Action<Term<'g>>)> {
    if bodies.external.is_empty() {
        return Vec::new();
    }
    let left = left(bodies, state, way);
    let joints = joints(bodies, state, way);
    let acted = bodies.external.iter().enumerate();
    acted
        .filter_map(|(k, &(body, placement))| {
            let body = body?;
            let action = state.action(k);
            let action = match (bodies.external_in_frame_0, way.frame) {
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
                    let turned = match left[body] {
                        Some(turn) => {
                            let turn = turn.sine_and_cosine(state.graph);
                            Pose::rotation(Rotation::about_z(turn)) * placement
                        }
                        None => placement,
                    };
                    let seen = action.change_frame(turned);
                    match way.frame {
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
