//! Equal limbs: subtrees with the same joints on the same body, such as the legs of a quadruped.
//!
//! In: the joints of a chain, and the bodies with external wrenches. Out: the entries of arguments that are at the same
//! place in each limb. Numbers do not matter: limbs may be mirrored, longer or heavier.

use std::mem::{Discriminant, discriminant};

use super::{BodyId, Joint, Position};
use crate::joint::Motion;
use crate::list::{Id, List};
use crate::space::{ACTION, CoordinateId, Limbs};

/// Sets of equal limbs; of limbs inside limbs, the larger ones.
pub(super) fn limbs(
    joints: &List<BodyId, Joint>,
    external: impl Iterator<Item = Option<BodyId>>,
) -> Vec<Limbs> {
    let mut children = vec![Vec::new(); joints.len() + 1];
    for (body, joint) in joints.numbered() {
        children[joint.parent.map_or(0, Id::number)].push(body);
    }
    let mut actions = List::filled(Vec::new(), joints.len());
    for (action, body) in external.enumerate() {
        if let Some(body) = body {
            actions[body].push(action);
        }
    }
    let tree = BodyTree {
        joints,
        actions,
        children,
    };
    tree.search()
}

/// For each joint of a subtree, parents first: motion, number of children, and number of external wrenches.
type Shape = Vec<(Discriminant<Motion>, usize, usize)>;

struct BodyTree<'c> {
    joints: &'c List<BodyId, Joint>,
    /// Indices of the external wrenches on each body.
    actions: List<BodyId, Vec<usize>>,
    /// Children of the base, then those of each body.
    children: Vec<Vec<BodyId>>,
}

impl BodyTree<'_> {
    fn children(&self, body: Option<BodyId>) -> &[BodyId] {
        &self.children[body.map_or(0, Id::number)]
    }

    /// All sets. Chains of any length are searched, so that nothing is recursive.
    fn search(&self) -> Vec<Limbs> {
        let mut found = Vec::new();
        let mut open = vec![None];
        while let Some(body) = open.pop() {
            let children = self.children(body);
            if children.len() < Limbs::FEWEST {
                open.extend(children.iter().copied().map(Some));
                continue;
            }
            let mut sets: Vec<(Shape, Vec<Vec<BodyId>>)> = Vec::new();
            for &child in children {
                let bodies = self.subtree(child);
                let shape = bodies.iter().map(|&body| self.shape(body)).collect();
                match sets.iter_mut().find(|(other, _)| *other == shape) {
                    Some((_, limbs)) => limbs.push(bodies),
                    None => sets.push((shape, vec![bodies])),
                }
            }
            for (_, limbs) in &sets {
                if limbs.len() >= Limbs::FEWEST {
                    found.push(self.places(limbs));
                } else {
                    open.extend(limbs.iter().map(|limb| limb.first().copied()));
                }
            }
        }
        found
    }

    /// A body with all that it carries, parents first.
    fn subtree(&self, body: BodyId) -> Vec<BodyId> {
        let mut bodies = vec![body];
        let mut next = 0;
        while let Some(&body) = bodies.get(next) {
            bodies.extend(self.children(Some(body)));
            next += 1;
        }
        bodies
    }

    fn shape(&self, body: BodyId) -> (Discriminant<Motion>, usize, usize) {
        let children = self.children(Some(body)).len();
        let motion = discriminant(&self.joints[body].motion);
        (motion, children, self.actions[body].len())
    }

    /// The entries of limbs that are given by their bodies in the same order.
    fn places(&self, limbs: &[Vec<BodyId>]) -> Limbs {
        let mut found = Limbs::default();
        for place in 0..limbs[0].len() {
            let bodies = || limbs.iter().map(|limb| limb[place]);
            let coordinate = |body: BodyId| match self.joints[body].position {
                Position::Along { coordinate, .. } => Some(coordinate),
                Position::Manifold(..) | Position::Taken => None,
            };
            let all: Option<Vec<CoordinateId>> = bodies().map(coordinate).collect();
            found.coordinates.extend(all);
            let velocities = bodies().map(|body| self.joints[body].velocity);
            found.velocities.push(velocities.collect());
            for action in 0..self.actions[limbs[0][place]].len() {
                let first = |body| self.actions[body][action] * ACTION.len();
                let row = |entry| bodies().map(|body| first(body) + entry).collect();
                found.actions.extend((0..ACTION.len()).map(row));
            }
        }
        found
    }
}
