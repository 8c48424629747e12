//! Actuator and joint losses on a velocity (armature, damping, Coulomb friction), in 256 bits.
//!
//! In: the settings of a joint in a request and in a description. Out: armature, damping and friction, and their torque
//! at a rate.

use homogen_codegen::description::Joint;
use homogen_codegen::expression::Arithmetic;
use homogen_codegen::joint::actuator::ActuatorQuantity;
use homogen_codegen::request::Request;

use super::motion::Motion;
use crate::big::Big;

/// Armature, damping and friction of a joint, on one of the velocities.
#[derive(Clone, Debug)]
pub struct Actuator {
    /// The index of the velocity.
    pub velocity: usize,
    /// Rate of the joint / velocity.
    factor: Big,
    armature: Big,
    damping: Big,
    friction: Big,
}

impl Actuator {
    /// From armature, damping and friction of a joint whose rate is `factor` times a velocity.
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

    /// Those of one motion of a joint; `part` is the number of its first velocity within the joint.
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
            let number = |of: ActuatorQuantity| setting(request, joint, of, part + k);
            let or_zero = |number: Option<Big>| number.unwrap_or_else(Big::zero);
            let ratio = number(ActuatorQuantity::Ratio).unwrap_or_else(Big::one);
            // A gear multiplies the rotor's speed and its torque, so its inertia by the square of the ratio.
            let mut rotor = or_zero(number(ActuatorQuantity::Rotor)) * &ratio * &ratio;
            for motor in request.further_motors(&joint.name.text, &joint.actuator) {
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
                armature: or_zero(number(ActuatorQuantity::Armature)) + rotor,
                damping: or_zero(number(ActuatorQuantity::Damping)),
                friction: or_zero(number(ActuatorQuantity::Friction)),
            }
        })
    }

    /// Torque on the velocity: armature q̈ + damping q̇ + friction sign q̇.
    #[must_use]
    pub fn torque(&self, qd: &[Big], qdd: &[Big]) -> Big {
        let [.., sign] = self.columns(qd, qdd);
        self.smooth_torque(qd, qdd) + &self.friction * sign
    }

    /// The torques of an armature, a damping and a friction of 1.
    #[must_use]
    pub fn columns(&self, qd: &[Big], qdd: &[Big]) -> [Big; 3] {
        let rate = self.rate(qd);
        let sign = Arithmetic::sign(rate.clone());
        [self.rate(qdd), rate, sign].map(|joint| &self.factor * joint)
    }

    /// The rate of the joint, from q̇, or its second rate from q̈.
    #[must_use]
    pub fn rate(&self, rates: &[Big]) -> Big {
        &self.factor * &rates[self.velocity]
    }

    /// The torque without friction, which is continuous: armature q̈ + damping q̇.
    #[must_use]
    pub fn smooth_torque(&self, qd: &[Big], qdd: &[Big]) -> Big {
        let force = &self.armature * self.rate(qdd) + &self.damping * self.rate(qd);
        &self.factor * force
    }

    /// The damping, reflected to the velocity.
    #[must_use]
    pub fn damping(&self) -> Big {
        &self.factor * &self.factor * &self.damping
    }

    /// The sum of the absolute values of the torque's terms.
    #[must_use]
    pub fn size(&self, qd: f64, qdd: f64) -> f64 {
        let factor = self.factor.abs().to_f64();
        let friction = if qd == 0.0 {
            0.0
        } else {
            self.friction.to_f64()
        };
        let (inertia, damping) = (self.armature().to_f64(), self.damping().to_f64());
        inertia * qdd.abs() + damping * qd.abs() + factor * friction
    }

    /// The armature, reflected to the velocity.
    #[must_use]
    pub fn armature(&self) -> Big {
        &self.factor * &self.factor * &self.armature
    }
}

/// The number of a quantity that is modelled, for one of the joint's velocities.
fn setting(
    request: &Request,
    joint: &Joint,
    quantity: ActuatorQuantity,
    velocity: usize,
) -> Option<Big> {
    let mut settings = request.actuators.iter();
    let setting = settings.find(|(name, of, _)| *of == quantity && name.text == joint.name.text);
    let modelled = if quantity.resists() {
        request.models_friction()
    } else {
        request.models_armature()
    };
    let numbers = match setting {
        Some((_, _, numbers)) => numbers.as_slice(),
        None if modelled => joint.actuator.of(quantity),
        None => &[],
    };
    let number = numbers.get(velocity).or(numbers.first())?;
    Some(Big::new(number.value))
}
