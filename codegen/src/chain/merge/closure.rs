//! The two frames of each joint that closes a loop, in the bodies that its links became part of.
//!
//! In: the loops of a description, and where its links ended up. Out: their frames A and B, turned so that
//! z is the joint's axis where it has one. A loop of a link that is not modelled is left out with a doubt. It
//! never looks at whether a loop can close.

use super::{Reader, Seat};
use crate::chain::{Frame, Loop};
use crate::description::{self, Description};
use crate::error::Complaint;
use crate::expression::Term;
use crate::matrix::{Pose, Rotation, Vector};
use crate::wording::quoted;

/// All that join two links which are modelled.
pub(super) fn closed<'g>(
    description: &Description,
    seats: &[Option<Seat<'g>>],
    reader: &mut Reader<'g, '_>,
) -> Vec<Loop> {
    let loops = description.loops.iter();
    loops
        .filter_map(|described| {
            let links = [&described.from, &described.to];
            let seats = links.map(|end| {
                let mut links = description.links.iter().zip(seats);
                let link = links.find(|(link, _)| link.name.text == end.text);
                link.and_then(|(_, seat)| *seat)
            });
            if let Some(missing) = (0..2).find(|&k| seats[k].is_none()) {
                let [name, link] = [&described.name, links[missing]].map(|name| quoted(&name.text));
                reader.report.warnings.push(Complaint {
                    place: described.name.place,
                    message: format!("loop {name} is left open: link {link} is not modelled"),
                    hint: None,
                });
                return None;
            }
            let seats = seats.map(|seat| seat.expect("neither is missing"));
            Some(one(described, &seats, reader))
        })
        .collect()
}

fn one<'g>(
    described: &description::Loop,
    seats: &[Seat<'g>; 2],
    reader: &mut Reader<'g, '_>,
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
        let mut placement = seats[k].pose * reader.placement(&name.text, steps);
        if kind.axes > 0 {
            let axis = described.axes[k].map(|entry| reader.component(&name.text, &entry));
            axes[k] = (Vector(axis).normalized()).expect("an axis without a direction is refused");
            placement = placement * Pose::rotation(Rotation::with_z(axes[k]));
        }
        frames.push(Frame {
            name: link.text.clone(),
            body: seats[k].body,
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
