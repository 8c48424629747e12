//! Configurations with names, which a description may have.
//!
//! In: a robot. Out: the name and the coordinates of each configuration that has a value for every joint that moves.

use crate::chain::Chain;
use crate::module::NamedConfiguration;

/// The configurations of the description, in its order; those without a value for each joint are left out.
pub fn configurations(chain: &Chain) -> impl Iterator<Item = NamedConfiguration> {
    let report = &chain.report;
    let configurations = chain.description.configurations.iter();
    configurations.filter_map(move |configuration| {
        let mut q = Vec::new();
        for joint in &report.joints {
            if report.mimicked.iter().any(|mimic| mimic.joint == *joint) {
                continue;
            }
            let mut joints = configuration.joints.iter();
            let (_, own) = joints.find(|(name, _)| name.text == *joint)?;
            q.extend(own.iter().map(|entry| entry.value));
        }
        let name = configuration.name.text.clone();
        let is_whole = q.len() == chain.spaces().coordinates.len();
        is_whole.then_some(NamedConfiguration { name, q })
    })
}
