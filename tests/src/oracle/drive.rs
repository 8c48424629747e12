//! What drives a velocity beside the bodies, at 256 bits.
//!
//! In: what a request and a description say of a joint. Out: armature, damping and friction, and what they
//! take at a rate. It knows no body.

use homogen_codegen::description::Joint;
use homogen_codegen::expression::Arithmetic;
use homogen_codegen::joint::drive::Part;
use homogen_codegen::request::Request;

use super::motion::Motion;
use crate::big::Big;

/// The drive of a joint on one of the velocities.
#[derive(Clone, Debug)]
pub struct Drive {
    /// The place of the velocity.
    pub velocity: usize,
    /// What the joint's own rate is times it.
    factor: Big,
    armature: Big,
    damping: Big,
    friction: Big,
}

impl Drive {
    /// Armature, damping and friction of a joint whose own rate is so many times that of a velocity.
    #[must_use]
    pub fn new(velocity: usize, factor: Big, [armature, damping, friction]: [Big; 3]) -> Self {
        Self {
            velocity,
            factor,
            armature,
            damping,
            friction,
        }
    }

    /// Those of a part of a joint, which is that of the given number.
    pub fn of<'d>(
        request: &'d Request,
        joint: &'d Joint,
        part: usize,
        motion: &Motion,
    ) -> impl Iterator<Item = Self> + use<'d> {
        let factor = match motion {
            Motion::Along { factor, .. } => factor.clone(),
            _ => Big::one(),
        };
        let screws = motion.screws().into_iter().enumerate();
        screws.map(move |(k, (velocity, _))| {
            let said = |of: Part| said(request, joint, of, part + k);
            let or_zero = |number: Option<Big>| number.unwrap_or_else(Big::zero);
            let ratio = said(Part::Ratio).unwrap_or_else(Big::one);
            // A rotor turns so many times as fast, and with as many times the torque.
            let mut rotor = or_zero(said(Part::Rotor)) * &ratio * &ratio;
            for motor in request.further_motors(&joint.name.text, &joint.drive) {
                let ratio = motor
                    .ratio
                    .map_or_else(Big::one, |ratio| Big::new(ratio.value));
                let inertia = motor
                    .rotor
                    .map_or_else(Big::zero, |rotor| Big::new(rotor.value));
                rotor = rotor + inertia * &ratio * &ratio;
            }
            Self {
                velocity,
                factor: factor.clone(),
                armature: or_zero(said(Part::Armature)) + rotor,
                damping: or_zero(said(Part::Damping)),
                friction: or_zero(said(Part::Friction)),
            }
        })
    }

    /// What it takes of the velocity's torque: armature q̈ + damping q̇ + friction sign q̇.
    #[must_use]
    pub fn takes(&self, qd: &[Big], qdd: &[Big]) -> Big {
        let [.., rubs] = self.columns(qd, qdd);
        self.takes_smoothly(qd, qdd) + &self.friction * rubs
    }

    /// What an armature, a damping and a friction of 1 would take.
    #[must_use]
    pub fn columns(&self, qd: &[Big], qdd: &[Big]) -> [Big; 3] {
        let own = |rates: &[Big]| &self.factor * &rates[self.velocity];
        let rate = own(qd);
        let sign = Arithmetic::sign(rate.clone());
        [own(qdd), rate, sign].map(|felt| &self.factor * felt)
    }

    /// The part of it that does not step: armature q̈ + damping q̇.
    #[must_use]
    pub fn takes_smoothly(&self, qd: &[Big], qdd: &[Big]) -> Big {
        let own = |rates: &[Big]| &self.factor * &rates[self.velocity];
        let force = &self.armature * own(qdd) + &self.damping * own(qd);
        &self.factor * force
    }

    /// The damping as the velocity feels it.
    #[must_use]
    pub fn damping(&self) -> Big {
        &self.factor * &self.factor * &self.damping
    }

    /// The sum of the sizes of what it takes.
    #[must_use]
    pub fn size(&self, qd: f64, qdd: f64) -> f64 {
        let factor = self.factor.abs().to_f64();
        let rubs = if qd == 0.0 {
            0.0
        } else {
            self.friction.to_f64()
        };
        let (inertia, damping) = (self.armature().to_f64(), self.damping().to_f64());
        inertia * qdd.abs() + damping * qd.abs() + factor * rubs
    }

    /// The armature as the velocity feels it.
    #[must_use]
    pub fn armature(&self) -> Big {
        &self.factor * &self.factor * &self.armature
    }
}

/// What is to be modelled of a part, for one of the joint's velocities.
fn said(request: &Request, joint: &Joint, part: Part, velocity: usize) -> Option<Big> {
    let mut asked = request.drives.iter();
    let asked = asked.find(|(name, of, _)| *of == part && name.text == joint.name.text);
    let modelled = if part.resists() {
        request.models_friction()
    } else {
        request.models_armature()
    };
    let numbers = match asked {
        Some((_, _, numbers)) => numbers.as_slice(),
        None if modelled => joint.drive.of(part),
        None => &[],
    };
    let number = numbers.get(velocity).or(numbers.first())?;
    Some(Big::new(number.value))
}
