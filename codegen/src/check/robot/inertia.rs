//! Inertias of links and actuators, by matrices.
//!
//! In: the description, and the struct fields that replace parts of it or add a payload. Out: J of a link in its own
//! frame; armature, damping and friction of a velocity.

use super::matrices::loaded;
use super::{Approximate, Contradiction, RobotReader};
use crate::dense::Matrix;
use crate::description::{Inertial, Joint, Link, Name, Number};
use crate::expression::Arithmetic;
use crate::joint::actuator::ActuatorQuantity;
use crate::request::Target;

impl RobotReader<'_> {
    pub(super) fn inertia(&self, link: &Link) -> Result<Matrix<Approximate>, Contradiction> {
        let is = |name: &Name| name.text == link.name.text;
        let mass = self.field(|target| matches!(target, Target::MassOf(of) if is(of)));
        let center = self.field(|target| matches!(target, Target::CenterOfMassOf(of) if is(of)));
        let nothing = Inertial {
            origin: Vec::new(),
            mass: Number::default(),
            inertia: [Number::default(); 6],
            place: link.name.place,
        };
        let inertial = link.inertial.as_ref().unwrap_or(&nothing);
        let [mass] = mass.unwrap_or([Approximate::written(inertial.mass.exact())]);
        let tensor = self.field(|target| matches!(target, Target::InertiaOf(of) if is(of)));
        let described = inertial
            .inertia
            .map(|entry| Approximate::written(entry.exact()));
        let [xx, xy, xz, yy, yz, zz] = tensor.unwrap_or(described);
        // ½ Tr(I) − I, and the mass.
        let half = (xx + yy + zz) * Approximate::exact(0.5);
        let none = Approximate::exact(0.0);
        let central = Matrix([
            [half - xx, -xy, -xz, none],
            [-xy, half - yy, -yz, none],
            [-xz, -yz, half - zz, none],
            [none, none, none, mass],
        ]);
        let mut origin = self.placement(&link.name.text, &inertial.origin)?;
        if let Some(center) = center {
            origin.set_column(center);
        }
        let payload = self.field(|target| matches!(target, Target::PayloadOn(of) if is(of)));
        let inertia = origin.times(&central).times(&origin.transposed());
        Ok(match payload {
            Some(payload) => inertia.plus(&loaded(payload)),
            None => inertia,
        })
    }

    /// Armature, damping and friction of the velocity with this index among those of a joint.
    pub(super) fn actuator(&self, joint: &Joint, place: usize) -> [Approximate; 3] {
        let number = |part: ActuatorQuantity| {
            let numbers = self
                .request
                .actuator(&joint.name.text, &joint.actuator, part);
            let number = numbers.get(if numbers.len() == 1 { 0 } else { place });
            number.map(|number| Approximate::written(number.exact()))
        };
        let zero = Approximate::literal(0.0);
        let ratio = number(ActuatorQuantity::Ratio).unwrap_or(Approximate::exact(1.0));
        let mut rotor = number(ActuatorQuantity::Rotor).map_or(zero, |rotor| ratio * ratio * rotor);
        for motor in self
            .request
            .further_motors(&joint.name.text, &joint.actuator)
        {
            let ratio = motor.ratio.map_or(Approximate::exact(1.0), |ratio| {
                Approximate::written(ratio.exact())
            });
            let inertia = motor
                .rotor
                .map_or(zero, |rotor| Approximate::written(rotor.exact()));
            rotor = rotor + ratio * ratio * inertia;
        }
        [
            ActuatorQuantity::Armature,
            ActuatorQuantity::Damping,
            ActuatorQuantity::Friction,
        ]
        .map(|part| {
            let field = self.field(|target| {
                let of = target.actuators();
                of.is_some_and(|(name, of)| of == part && name.text == joint.name.text)
            });
            let described = number(part).unwrap_or(zero);
            match (field, part) {
                (Some([field]), _) => field,
                (None, ActuatorQuantity::Armature) => described + rotor,
                (None, _) => described,
            }
        })
    }
}
