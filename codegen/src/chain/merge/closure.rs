//! The two frames of each loop, in the bodies of its links.
//!
//! In: the loops of a description, and the place of each link. Out: their frames A and B, rotated so that z is the axis
//! of the loop, if it has one. A loop with a link that is not modelled is left out with a warning.

use super::{Attachment, TermReader};
use crate::chain::{Frame, Loop};
use crate::description::{self, Description};
use crate::error::Diagnostic;
use crate::expression::Term;
use crate::matrix::{Pose, Rotation, Vector};
use crate::wording::quoted;

/// The loops between two modelled links.
pub(super) fn closed<'g>(
    description: &Description,
    attachments: &[Option<Attachment<'g>>],
    reader: &mut TermReader<'g, '_>,
) -> Vec<Loop> {
    let loops = description.loops.iter();
    loops
        .filter_map(|described| {
            let links = [&described.from, &described.to];
            let attachments = links.map(|end| {
                let mut links = description.links.iter().zip(attachments);
                let link = links.find(|(link, _)| link.name.text == end.text);
                link.and_then(|(_, attachment)| *attachment)
            });
            if let Some(missing) = (0..2).find(|&k| attachments[k].is_none()) {
                let [name, link] = [&described.name, links[missing]].map(|name| quoted(&name.text));
                reader.report.warnings.push(Diagnostic {
                    place: described.name.place,
                    message: format!("loop {name} is left open: link {link} is not modelled"),
                    hint: None,
                });
                return None;
            }
            let attachments = attachments.map(|attachment| attachment.expect("neither is missing"));
            Some(one(described, &attachments, reader))
        })
        .collect()
}

fn one<'g>(
    described: &description::Loop,
    attachments: &[Attachment<'g>; 2],
    reader: &mut TermReader<'g, '_>,
) -> Loop {
    let graph = reader.graph;
    let (name, kind) = (&described.name, described.closure.definition());
    let ends = [
        (&described.from, &described.at),
        (&described.to, &described.to_at),
    ];
    let mut axes = [Vector::zero(graph); 2];
    let mut frames = Vec::with_capacity(2);
    for (k, (link, steps)) in ends.into_iter().enumerate() {
        let mut placement = attachments[k].pose * reader.placement(&name.text, steps);
        if kind.axes > 0 {
            let axis = described.axes[k].map(|entry| reader.component(&name.text, &entry));
            axes[k] = (Vector(axis).normalized()).expect("an axis without a direction is refused");
            placement = placement * Pose::rotation(Rotation::with_z(axes[k]));
        }
        frames.push(Frame {
            name: link.text.clone(),
            body: attachments[k].body,
            placement: placement.map(Term::expr),
        });
    }
    let size = match described.closure.length() {
        Some(length) => reader.number(&length),
        None => axes[0].dot(axes[1]),
    };
    Loop {
        name: name.text.clone(),
        place: name.place,
        word: kind.word,
        frames: frames.try_into().expect("two were pushed"),
        rows: kind.rows.to_vec(),
        size: size.expr(),
    }
}
