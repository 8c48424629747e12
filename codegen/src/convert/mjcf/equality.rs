//! Mimic joints and loops as constraints.

use super::{Mjcf, Site};
use crate::closure::Closure;
use crate::convert::elementary::Elementary;
use crate::convert::numbers::text;
use crate::description::Loop;
use crate::wording::quoted;

impl<'d> Mjcf<'d> {
    /// A loop between two sites.
    pub(super) fn closed(&mut self, closed: &'d Loop) {
        let name = &closed.name;
        let tag = match closed.closure {
            Closure::Fixed => "weld",
            Closure::Spherical => "connect",
            other => {
                let message = format!(
                    "loop {} is {}, and MJCF has constraints of type fixed and spherical only",
                    quoted(&name.text),
                    other.definition().word
                );
                self.errors.push(name.place, message);
                return;
            }
        };
        let ends = [(&closed.from, &closed.at), (&closed.to, &closed.to_at)];
        let [first, second] = ends.map(|(link, at)| {
            let site = self.bodies.fresh(&format!("{}.{}", name.text, link.text));
            self.sites.entry(&link.text).or_default().push(Site {
                name: site.clone(),
                at,
            });
            site
        });
        let attributes = vec![
            ("name", name.text.clone()),
            ("site1", first),
            ("site2", second),
        ];
        self.equalities.push((tag, attributes));
    }

    /// The constraint of a mimic joint.
    pub(super) fn mimic(&mut self, part: &Elementary<'_>) {
        let Some(mimic) = &part.mimic else { return };
        let mut joints = self.description.joints.iter();
        let mimicked = joints.find(|joint| joint.name.text == mimic.mimicked.text);
        if !mimicked.is_some_and(|joint| joint.kind.moves() && !joint.kind.has_several()) {
            let message = format!(
                "joint {} mimics joint {}, which does not exist or has no coordinate: left out",
                quoted(&part.name),
                quoted(&mimic.mimicked.text)
            );
            self.warn(mimic.place, message, None);
            return;
        }
        let (offset, multiplier) = (text(&mimic.offset), text(&mimic.multiplier));
        let attributes = vec![
            ("joint1", part.name.clone()),
            ("joint2", mimic.mimicked.text.clone()),
            ("polycoef", format!("{offset} {multiplier} 0 0 0")),
        ];
        self.equalities.push(("joint", attributes));
    }
}
