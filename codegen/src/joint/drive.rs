//! What a joint's drive adds to the bodies that it moves: reflected inertia and friction.
//!
//! In: the numbers that are said of it. Out: [`Parts`], in the words in which they are said, and the
//! [`Drive`] of one velocity. It knows no motor: torques and rates are those of the joint.

use crate::expression::Term;
use crate::number::Number;

/// A number that can be said of a joint's drive.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Part {
    /// Inertia that the joint feels beside that of the bodies [kg m², of a slide kg].
    Armature,
    /// Inertia of the motor's rotor about its own axis \[kg m²\]; the joint feels it times the square of
    /// the ratio.
    Rotor,
    /// Turns of the rotor for each of the joint; of a slide rad/m.
    Ratio,
    /// Viscous friction: torque for each rate [N m s/rad, N s/m].
    Damping,
    /// Coulomb friction: torque against the motion, however slow it is [N m, N].
    Friction,
}

impl Part {
    /// All of them.
    pub const ALL: [Self; 5] = [
        Self::Armature,
        Self::Rotor,
        Self::Ratio,
        Self::Damping,
        Self::Friction,
    ];

    /// What it is called in every reader.
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

    /// The part of that name.
    #[must_use]
    pub fn from_word(word: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|part| part.word() == word)
    }

    /// Whether it takes power from the robot, and is not an inertia.
    #[must_use]
    pub const fn resists(self) -> bool {
        matches!(self, Self::Damping | Self::Friction)
    }
}

/// What is said of a joint: of each part nothing, one number for all of the joint's velocities, or one for
/// each; and of motors beyond the first.
#[derive(Clone, Debug, Default)]
pub struct Parts {
    numbers: [Vec<Number>; Part::ALL.len()],
    further: Vec<Motor>,
}

/// A motor, as far as it is told.
#[derive(Clone, Copy, Debug)]
pub struct Motor {
    /// The inertia of its rotor \[kg m²\].
    pub rotor: Option<Number>,
    /// Turns of the rotor for each of the joint; of a slide rad/m. One where it is not told.
    pub ratio: Option<Number>,
}

impl Parts {
    /// What is said of a part.
    #[must_use]
    pub fn of(&self, part: Part) -> &[Number] {
        &self.numbers[part as usize]
    }

    /// Motors beside the one whose rotor and ratio are parts: what they reflect adds to it.
    #[must_use]
    pub fn further(&self) -> &[Motor] {
        &self.further
    }

    /// Adds a motor: the first with a rotor becomes the rotor and the ratio.
    pub fn mount(&mut self, motor: Motor) {
        let [rotor, ratio] = [Part::Rotor, Part::Ratio].map(|part| self.of(part).first().copied());
        let first = Motor { rotor, ratio };
        let value = |number: Option<Number>| number.map(|number| number.value);
        if rotor.is_some() || (ratio.is_some() && motor.rotor.is_none()) {
            // A gear without a rotor reflects nothing, and is often told once for each interface.
            if motor.rotor.is_some() || value(motor.ratio) != value(ratio) {
                self.further.push(motor);
            }
            return;
        }
        if value(motor.ratio) != value(ratio) {
            self.further.extend(ratio.map(|_| first));
        }
        let parts = [(Part::Rotor, motor.rotor), (Part::Ratio, motor.ratio)];
        for (part, number) in parts {
            self.say(part, number.into_iter().collect());
        }
    }

    /// Says something of a part, in place of what was said before.
    pub fn say(&mut self, part: Part, numbers: Vec<Number>) {
        self.numbers[part as usize] = numbers;
    }
}

/// What one velocity of a joint meets beside the bodies.
#[derive(Clone, Copy, Debug)]
pub struct Drive<T> {
    /// Reflected inertia: takes `armature` q̈.
    pub armature: T,
    /// Viscous friction: takes `damping` q̇.
    pub damping: T,
    /// Coulomb friction: takes `friction` sign q̇, nothing at rest.
    pub friction: T,
}

impl<T> Drive<T> {
    /// The same with other numbers.
    #[must_use]
    pub fn map<U>(self, mut of: impl FnMut(T) -> U) -> Drive<U> {
        Drive {
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

impl<'g> Drive<Term<'g>> {
    /// The force or torque that friction takes at a rate.
    #[must_use]
    pub fn resistance(self, rate: Term<'g>) -> Term<'g> {
        // What no friction is multiplied by is not made.
        let mut force = self.damping * rate;
        if !self.friction.is_zero() {
            force = force + self.friction * rate.sign();
        }
        force
    }
}

#[cfg(test)]
mod tests {
    use super::Part;

    #[test]
    fn words_are_read_back() {
        for part in Part::ALL {
            assert_eq!(Part::from_word(part.word()), Some(part));
        }
        assert_eq!(Part::from_word("stiction"), None);
    }
}
