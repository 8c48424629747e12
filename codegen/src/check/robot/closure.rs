//! The loops of the described robot.
//!
//! In: the loops of the chain, and the bodies of the links. Out: their frames, as bodies fixed to the links, and their
//! residuals.

use std::collections::HashMap;

use super::matrices::{of_length_1, with_z};
use super::{Approximate, Contradiction, RobotReader, fixed};
use crate::chain::Chain;
use crate::dense::{BodyId, Closed, DenseBody};
use crate::expression::Arithmetic;
use crate::list::{Id, List};
use crate::space::FrameId;

impl RobotReader<'_> {
    /// The loops of the chain, with their frames as bodies fixed to the links.
    pub(super) fn loops(
        &self,
        chain: &Chain,
        attached: &HashMap<&str, BodyId>,
        bodies: &mut List<BodyId, DenseBody>,
        frames: &mut List<FrameId, Option<BodyId>>,
    ) -> Result<Vec<Closed>, Contradiction> {
        let mut loops = Vec::new();
        for closed in &chain.loops {
            let mut described = self.description.loops.iter();
            let described = described
                .find(|described| described.name.text == closed.name)
                .ok_or_else(|| Contradiction(format!("that loop {} is there", closed.name)))?;
            let name = &described.name.text;
            let ends = [
                (&described.from, &described.at),
                (&described.to, &described.to_at),
            ];
            let first = frames.next();
            let mut axes = Vec::new();
            for ((link, steps), axis) in ends.into_iter().zip(&described.axes) {
                let mut placement = self.placement(name, steps)?;
                if described.closure.definition().axes > 0 {
                    let axis = of_length_1(self.components(name, axis)?);
                    placement = placement.times(&with_z(axis));
                    axes.push(axis);
                }
                let link = attached.get(link.text.as_str()).copied();
                frames.push(Some(bodies.push(fixed(link, placement))));
            }
            let size = match (described.closure.length(), &*axes) {
                (Some(length), _) => Approximate::written(length.exact()),
                (None, [[ax, ay, az], [bx, by, bz]]) => *ax * *bx + *ay * *by + *az * *bz,
                (None, _) => Approximate::literal(0.0),
            };
            loops.push(Closed {
                frames: [first, first.plus(1)],
                rows: closed.rows.clone(),
                size,
            });
        }
        Ok(loops)
    }
}
