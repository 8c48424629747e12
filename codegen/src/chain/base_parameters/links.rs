//! The links of a chain, and their blocks.
//!
//! In: a chain. Out: the tree of its links, the numbers of their parameters, and the number of states for each.

use super::blocks::{Hung, LinkId, blocks};
use super::numbers::{ACTUATOR, MOMENTS, Numbers, PLACES};
use crate::chain::{BodyId, Chain, Position};
use crate::dense::Matrix;
use crate::expression::Double;
use crate::list::{Id, List};
use crate::space::ParameterId;

/// The links of a chain.
pub(super) struct Links<'c> {
    pub(super) chain: &'c Chain,
    /// The body of each link.
    pub(super) bodies: List<LinkId, BodyId>,
    /// For each link the bodies of the joints between its parent link and it, from the base outwards.
    pub(super) own: List<LinkId, Vec<BodyId>>,
    hung: List<LinkId, Hung>,
}

/// A block of links with their parents.
pub(super) struct Together {
    /// The parent links outside the block, in order.
    pub(super) outer: Vec<LinkId>,
    /// The links of the block, in order.
    pub(super) links: Vec<LinkId>,
    /// Numbers of kinetic and potential energies: more than there are columns.
    pub(super) rows: [usize; 2],
    /// Joints whose armatures must be zero in a combination without torque, or the same as that of another joint.
    pub(super) bound: Vec<(BodyId, Option<BodyId>)>,
}

/// Number of energies beyond the number of columns.
const MORE: usize = 6;

impl<'c> Links<'c> {
    pub(super) fn of(chain: &'c Chain) -> Self {
        let inwards =
            |body: BodyId| std::iter::successors(Some(body), |&body| chain.joints[body].parent);
        let is_link = |body: &BodyId| chain.joints[*body].link.is_some();
        let bodies: List<LinkId, BodyId> = chain.joints.ids().filter(is_link).collect();
        let mut links: List<BodyId, Option<LinkId>> = chain.joints.map(|_| None);
        let (mut own, mut hung) = (List::new(), List::new());
        for (link, &body) in bodies.numbered() {
            let parent = inwards(body).skip(1).find(is_link);
            let between = inwards(body).take_while(|&other| Some(other) != parent);
            let mut between: Vec<BodyId> = between.collect();
            between.reverse();
            let velocities = between.iter().map(|&body| chain.joints[body].velocity);
            hung.push(Hung {
                parent: parent.and_then(|parent| links[parent]),
                velocities: velocities.collect(),
            });
            own.push(between);
            links[body] = Some(link);
        }
        Self {
            chain,
            bodies,
            own,
            hung,
        }
    }

    /// The blocks of links, outermost first.
    pub(super) fn together(&self) -> Vec<Together> {
        let blocks = blocks(&self.hung, self.chain.spaces().velocities.len()).into_iter();
        let together = blocks.map(|links| {
            let parents = links.iter().filter_map(|&link| self.hung[link].parent);
            let mut outer: Vec<LinkId> = parents.filter(|link| !links.contains(link)).collect();
            outer.sort_unstable();
            outer.dedup();
            let count = outer.len() + links.len();
            let armatures: usize = links.iter().map(|&link| self.own[link].len()).sum();
            // A constant is one more column of the potential energies.
            let rows = [MOMENTS * count + armatures + MORE, 4 * count + 1 + MORE];
            let bound = links.iter().flat_map(|&link| self.bound(&self.own[link]));
            let bound = bound.collect();
            Together {
                outer,
                links,
                rows,
                bound,
            }
        });
        together.collect()
    }

    /// Armatures of velocities in the axes of the moved frame, which are no derivatives of coordinates. The torque of
    /// such an armature acts on its own velocity only, while a kinetic energy ½ v A v + ½ ω B ω also has the torques
    /// ω × A v and ω × B ω. They agree only if A is zero, and B the same about all axes.
    fn bound(&self, own: &[BodyId]) -> Vec<(BodyId, Option<BodyId>)> {
        let joints = &self.chain.joints;
        let in_own_frame = own.iter().copied().filter(|&body| {
            matches!(
                joints[body].position,
                Position::Manifold(..) | Position::Taken
            )
        });
        let (translates, turns): (Vec<BodyId>, Vec<BodyId>) =
            in_own_frame.partition(|&body| joints[body].motion.translates());
        let pairs = turns.windows(2).map(|pair| (pair[0], Some(pair[1])));
        let translates = translates.into_iter().map(|slide| (slide, None));
        translates.chain(pairs).collect()
    }

    /// Number of states for each body: the largest of any link that its joint moves.
    pub(super) fn often(&self, together: &[Together]) -> List<BodyId, usize> {
        let mut often = self.chain.joints.map(|_| 0);
        for Together {
            outer, links, rows, ..
        } in together
        {
            for &link in outer.iter().chain(links) {
                let body = self.bodies[link];
                often[body] = often[body].max(rows[0]).max(rows[1]);
            }
        }
        for (body, joint) in self.chain.joints.numbered().rev() {
            if let Some(parent) = joint.parent {
                often[parent] = often[parent].max(often[body]);
            }
        }
        often
    }

    /// The number of a link's parameter.
    pub(super) fn moment(link: LinkId, moment: usize) -> ParameterId {
        ParameterId::new(MOMENTS * link.index() + moment)
    }

    /// The numbers of a joint's armature, damping and friction, which follow those of all links; `None` if they are not
    /// identified.
    pub(super) fn actuator(&self, joint: BodyId) -> Option<[ParameterId; ACTUATOR]> {
        let first = ParameterId::new(MOMENTS * self.bodies.len() + ACTUATOR * joint.index());
        let identified = self.chain.identifies_actuators;
        identified.then(|| [0, 1, 2].map(|part| first.plus(part)))
    }

    /// All parameters of the description, in their order.
    pub(super) fn described(&self, numbers: &Numbers) -> List<ParameterId, Double> {
        let moments = numbers.inertias.iter();
        let moments = moments.flat_map(|Matrix(j)| PLACES.map(|(row, column)| j[row][column]));
        let actuators = numbers.actuators.iter().flatten().copied();
        moments
            .chain(actuators.filter(|_| self.chain.identifies_actuators))
            .collect()
    }
}
