//! The inertia of a link, as scalars.
//!
//! In: the description, and the struct fields that replace parts of it or add a payload. Out: J in the link's own
//! frame, `None` for a link without inertial data.

use super::TermReader;
use crate::description::{Link, Name};
use crate::expression::Term;
use crate::matrix::{Inertia, Pose, Symmetric, Vector};
use crate::request::Target;

impl<'g> TermReader<'g, '_> {
    /// J of a link in its own frame, if it has inertial data.
    pub(super) fn inertia(&mut self, link: &Link) -> Option<Inertia<Term<'g>>> {
        let is = |name: &Name| name.text == link.name.text;
        let of_mass = |target: &Target| matches!(target, Target::MassOf(name) if is(name));
        let of_center =
            |target: &Target| matches!(target, Target::CenterOfMassOf(name) if is(name));
        let of_inertia = |target: &Target| matches!(target, Target::InertiaOf(name) if is(name));
        let nothing = self.graph.constant(0.0);
        let (mass, tensor, mut origin) = match &link.inertial {
            Some(inertial) => (
                self.number(&inertial.mass),
                inertial.inertia.map(|entry| self.number(&entry)),
                self.placement(&link.name.text, &inertial.origin),
            ),
            // A struct field can give a mass to a link without inertial data.
            None => (nothing, [nothing; 6], Pose::identity(self.graph)),
        };
        let [mass] = self.free(of_mass, [mass]);
        origin.translation = Vector(self.free(of_center, origin.translation.0));
        let tensor = self.free(of_inertia, tensor);
        let free = (tensor.iter().chain([&mass])).any(|entry| entry.value().is_none());
        let own = (free || link.inertial.is_some())
            .then(|| Inertia::central(mass, Symmetric::from_tensor(tensor)).change_frame(origin));
        let payload = self.payload(link);
        match (own, payload) {
            (Some(own), Some(payload)) => Some(own + payload),
            (own, payload) => own.or(payload),
        }
    }

    /// J of a payload in a struct field, in the link's frame.
    fn payload(&mut self, link: &Link) -> Option<Inertia<Term<'g>>> {
        let is = |target: &Target| matches!(target, Target::PayloadOn(name) if name.text == link.name.text);
        let free = self.request.loads(&link.name);
        free.then(|| {
            let nothing = [self.graph.constant(0.0); 10];
            let [mass, x, y, z, tensor @ ..] = self.free(is, nothing);
            let center = Pose::translation(Vector([x, y, z]));
            Inertia::central(mass, Symmetric::from_tensor(tensor)).change_frame(center)
        })
    }
}
