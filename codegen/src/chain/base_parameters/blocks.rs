//! Blocks of links whose columns of the regressor may depend on each other.
//!
//! In: for each link its parent link, and the velocities of the joints between. Out: blocks of links, outermost
//! first. A part of some links' mass whose energies do not change with the coordinates between them and their parents
//! acts on all other joints like mass of the parents. So the links of a block depend on each other and on their
//! parents alone, if no other link is moved by their coordinates and all links that they carry belong to earlier
//! blocks. A block is as small as that allows: one link, if no joint mimics another.

use crate::list::{List, id};
use crate::space::VelocityId;

id! {
    /// The number of a link that a joint moves, in the order of the inertial parameters.
    LinkId
}

/// A link that joints move.
pub(super) struct Hung {
    /// The parent link, with only bodies of its own joint between; `None` for the base.
    pub(super) parent: Option<LinkId>,
    /// The velocities of the joints between.
    pub(super) velocities: Vec<VelocityId>,
}

/// The blocks, each with its links in order.
pub(super) fn blocks(links: &List<LinkId, Hung>, velocities: usize) -> Vec<Vec<LinkId>> {
    let of_link = components(links, velocities);
    let mut blocks: List<LinkId, Vec<LinkId>> = links.map(|_| Vec::new());
    // For each block the number of child links in other blocks that have not been listed.
    let mut waiting: List<LinkId, usize> = links.map(|_| 0);
    for (link, hung) in links.numbered() {
        blocks[of_link[link]].push(link);
        if let Some(outer) = hung.parent.map(|parent| of_link[parent])
            && outer != of_link[link]
        {
            waiting[outer] += 1;
        }
    }
    let free = |block: &LinkId| waiting[*block] == 0 && !blocks[*block].is_empty();
    let mut ready: Vec<LinkId> = links.ids().filter(free).collect();
    let mut order = Vec::new();
    while let Some(block) = ready.pop() {
        let members = std::mem::take(&mut blocks[block]);
        for &link in &members {
            let outer = links[link].parent.map(|parent| of_link[parent]);
            if let Some(outer) = outer.filter(|outer| *outer != block) {
                waiting[outer] -= 1;
                if waiting[outer] == 0 {
                    ready.push(outer);
                }
            }
        }
        order.push(members);
    }
    order
}

/// For each link the first link of its block: links that a velocity moves relative to their parents belong together,
/// and so does a link between two links of a block.
fn components(links: &List<LinkId, Hung>, velocities: usize) -> List<LinkId, LinkId> {
    let mut first_of: List<VelocityId, Option<LinkId>> = List::filled(None, velocities);
    let mut of_link: List<LinkId, LinkId> = links.ids().collect();
    for (link, hung) in links.numbered() {
        for &velocity in &hung.velocities {
            let first = *first_of[velocity].get_or_insert(link);
            join(&mut of_link, first, link);
        }
    }
    if of_link.numbered().all(|(link, block)| link == *block) {
        return of_link;
    }
    let apart = of_link.clone();
    for (link, hung) in links.numbered() {
        if let Some(parent) = hung.parent
            && reaches(links, &apart, apart[parent], apart[link])
        {
            join(&mut of_link, parent, link);
        }
    }
    of_link
}

/// Merges two blocks.
fn join(of_link: &mut List<LinkId, LinkId>, a: LinkId, b: LinkId) {
    let (from, to) = (of_link[a].max(of_link[b]), of_link[a].min(of_link[b]));
    for block in of_link.iter_mut().filter(|block| **block == from) {
        *block = to;
    }
}

/// True if links of a block are descendants of those of another.
fn reaches(
    links: &List<LinkId, Hung>,
    of_link: &List<LinkId, LinkId>,
    from: LinkId,
    to: LinkId,
) -> bool {
    let mut seen = links.map(|_| false);
    let mut waiting = vec![from];
    while let Some(block) = waiting.pop() {
        if block == to {
            return true;
        }
        if std::mem::replace(&mut seen[block], true) {
            continue;
        }
        let members = links.numbered().filter(|(link, _)| of_link[*link] == block);
        waiting.extend(members.filter_map(|(_, hung)| Some(of_link[hung.parent?])));
    }
    false
}

#[cfg(test)]
mod tests {
    use super::{Hung, blocks};
    use crate::list::{Id, List};

    /// The blocks of links that are given by their parent and velocity.
    fn found(links: &[(Option<usize>, usize)]) -> Vec<Vec<usize>> {
        let links: List<_, Hung> = (links.iter())
            .map(|&(parent, velocity)| Hung {
                parent: parent.map(Id::new),
                velocities: vec![Id::new(velocity)],
            })
            .collect();
        let blocks = blocks(&links, links.len()).into_iter();
        blocks
            .map(|block| block.into_iter().map(Id::index).collect())
            .collect()
    }

    #[test]
    fn without_mimic_joints_each_link_is_a_block_and_comes_before_its_parent() {
        let blocks = found(&[(None, 0), (Some(0), 1), (Some(0), 2), (Some(2), 3)]);
        assert_eq!(blocks.len(), 4);
        let place = |link| blocks.iter().position(|block| block == &[link]);
        for (outer, inner) in [(3, 2), (2, 0), (1, 0)] {
            assert!(place(outer) < place(inner), "{blocks:?}");
        }
    }

    #[test]
    fn links_that_one_coordinate_moves_are_one_block() {
        let fingers = found(&[(None, 0), (Some(0), 1), (Some(0), 1), (Some(1), 2)]);
        assert_eq!(fingers, [vec![3], vec![1, 2], vec![0]]);
    }

    #[test]
    fn a_link_between_links_of_a_block_belongs_to_it() {
        assert_eq!(found(&[(None, 0), (Some(0), 1), (Some(1), 0)]), [[0, 1, 2]]);
        // Two blocks, each of which carries a link of the other, are one.
        let crossed = [(None, 0), (None, 1), (Some(0), 1), (Some(1), 0)];
        assert_eq!(found(&crossed), [[0, 1, 2, 3]]);
    }
}
