//! Armature, rotors, damping and friction of joints.
//!
//! [`Actuator`] holds the described numbers of a joint, [`ActuatorTerms`] the resulting terms of one velocity. Motors
//! are not modelled beyond their inertia: torques and rates are those of the joint.

use crate::expression::Term;
use crate::number::Number;

/// A described quantity of an actuator.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ActuatorQuantity {
    /// Inertia at the joint in addition to the bodies [kg m², of a translation kg].
    Armature,
    /// Inertia of a rotor about its own axis \[kg m²\]; reflected at the joint, it is multiplied by the square of the
    /// ratio.
    Rotor,
    /// Turns of the rotor for one of the joint; of a translation rad/m.
    Ratio,
    /// Viscous friction [N m s/rad, N s/m].
    Damping,
    /// Coulomb friction: a torque or force against the motion, independent of the velocity [N m, N].
    Friction,
}

impl ActuatorQuantity {
    /// All quantities.
    pub const ALL: [Self; 5] = [
        Self::Armature,
        Self::Rotor,
        Self::Ratio,
        Self::Damping,
        Self::Friction,
    ];

    /// Its key in all formats.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Armature => "armature",
            Self::Rotor => "rotor",
            Self::Ratio => "ratio",
            Self::Damping => "damping",
            Self::Friction => "friction",
        }
    }

    /// The quantity with a key.
    #[must_use]
    pub fn from_word(word: &str) -> Option<Self> {
        Self::ALL
            .into_iter()
            .find(|quantity| quantity.word() == word)
    }

    /// True for friction, false for inertias.
    #[must_use]
    pub const fn resists(self) -> bool {
        matches!(self, Self::Damping | Self::Friction)
    }
}

/// The described numbers of a joint: for each quantity none, one for all of the joint's velocities, or one for each;
/// and further motors.
#[derive(Clone, Debug, Default)]
pub struct Actuator {
    numbers: [Vec<Number>; ActuatorQuantity::ALL.len()],
    further: Vec<Motor>,
}

/// A motor as described.
#[derive(Clone, Copy, Debug)]
pub struct Motor {
    /// Inertia of its rotor \[kg m²\].
    pub rotor: Option<Number>,
    /// Turns of the rotor for one of the joint; of a translation rad/m. 1 if it is not written.
    pub ratio: Option<Number>,
}

impl Actuator {
    /// The numbers of a quantity.
    #[must_use]
    pub fn of(&self, quantity: ActuatorQuantity) -> &[Number] {
        &self.numbers[quantity as usize]
    }

    /// Motors beyond the first; their reflected inertias are added.
    #[must_use]
    pub fn further(&self) -> &[Motor] {
        &self.further
    }

    /// Adds a motor: the first with a rotor sets the rotor and the ratio.
    pub fn mount(&mut self, motor: Motor) {
        let [rotor, ratio] = [ActuatorQuantity::Rotor, ActuatorQuantity::Ratio]
            .map(|quantity| self.of(quantity).first().copied());
        let first = Motor { rotor, ratio };
        let value = |number: Option<Number>| number.map(|number| number.value);
        if rotor.is_some() || (ratio.is_some() && motor.rotor.is_none()) {
            // A gear without a rotor reflects nothing, and files often repeat it for each interface.
            if motor.rotor.is_some() || value(motor.ratio) != value(ratio) {
                self.further.push(motor);
            }
            return;
        }
        if value(motor.ratio) != value(ratio) {
            self.further.extend(ratio.map(|_| first));
        }
        let numbers = [
            (ActuatorQuantity::Rotor, motor.rotor),
            (ActuatorQuantity::Ratio, motor.ratio),
        ];
        for (quantity, number) in numbers {
            self.say(quantity, number.into_iter().collect());
        }
    }

    /// Sets the numbers of a quantity.
    pub fn say(&mut self, quantity: ActuatorQuantity, numbers: Vec<Number>) {
        self.numbers[quantity as usize] = numbers;
    }
}

/// Armature and friction of one velocity.
#[derive(Clone, Copy, Debug)]
pub struct ActuatorTerms<T> {
    /// Reflected inertia: the torque `armature` q̈.
    pub armature: T,
    /// Viscous friction: the torque `damping` q̇.
    pub damping: T,
    /// Coulomb friction: the torque `friction` sign q̇, zero at rest.
    pub friction: T,
}

impl<T> ActuatorTerms<T> {
    /// Applies a function to each number.
    #[must_use]
    pub fn map<U>(self, mut of: impl FnMut(T) -> U) -> ActuatorTerms<U> {
        ActuatorTerms {
            armature: of(self.armature),
            damping: of(self.damping),
            friction: of(self.friction),
        }
    }

    /// Armature, damping, friction.
    #[must_use]
    pub fn entries(self) -> [T; 3] {
        [self.armature, self.damping, self.friction]
    }
}

impl<'g> ActuatorTerms<Term<'g>> {
    /// The torque or force that friction requires at a rate.
    #[must_use]
    pub fn resistance(self, rate: Term<'g>) -> Term<'g> {
        // The sign is not computed if there is no Coulomb friction.
        let mut force = self.damping * rate;
        if !self.friction.is_zero() {
            force = force + self.friction * rate.sign();
        }
        force
    }
}

#[cfg(test)]
mod tests {
    use super::ActuatorQuantity;

    #[test]
    fn words_are_read_back() {
        for quantity in ActuatorQuantity::ALL {
            assert_eq!(ActuatorQuantity::from_word(quantity.word()), Some(quantity));
        }
        assert_eq!(ActuatorQuantity::from_word("stiction"), None);
    }
}
