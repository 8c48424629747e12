//! The quantities that several functions return, with their units.

use crate::space::{Entity, Kind, Quantity, Space};

/// A pose.
pub(super) const POSE: Quantity = Quantity {
    over: &[],
    entity: Entity::Pose,
    units: |_| ["1", "1", "1", "m"].repeat(3),
};

/// A velocity matrix.
pub(super) const VELOCITY: Quantity = Quantity {
    over: &[],
    entity: Entity::Velocity,
    units: |_| ["rad/s", "m/s"].map(|unit| [unit; 3]).concat(),
};

/// An acceleration matrix.
pub(super) const ACCELERATION: Quantity = Quantity {
    over: &[],
    entity: Entity::Acceleration,
    units: |_| ["1/s²", "1/s²", "1/s²", "m/s²"].repeat(3),
};

/// A screw for each velocity.
pub(super) const SCREWS: Quantity = Quantity {
    over: &[Space::Velocities],
    entity: Entity::Screw,
    units: |of| {
        let b = by_one(of, "m", "1");
        vec!["1", "1", "1", b, b, b]
    },
};

/// An energy.
pub(super) const ENERGY: Quantity = Quantity {
    over: &[],
    entity: Entity::Number,
    units: |_| vec!["J"],
};

/// Joint torques and forces.
pub(super) const FORCES: Quantity = vector(|of| vec![by_one(of, "N m", "N")]);

/// Joint accelerations.
pub(super) const SECOND_RATES: Quantity = vector(|of| vec![by_one(of, "rad/s²", "m/s²")]);

/// What torques and forces are for accelerations.
pub(super) const INERTIAS: Quantity = matrix(|of| vec![by_two(of, ["kg m²", "kg m", "kg"])]);

/// What accelerations are for torques and forces.
pub(super) const INVERSE_INERTIAS: Quantity =
    matrix(|of| vec![by_two(of, ["1/(kg m²)", "1/(kg m)", "1/kg"])]);

const fn vector(units: fn(&[Kind]) -> Vec<&'static str>) -> Quantity {
    Quantity {
        over: &[Space::Velocities],
        entity: Entity::Number,
        units,
    }
}

const fn matrix(units: fn(&[Kind]) -> Vec<&'static str>) -> Quantity {
    Quantity {
        over: &[Space::Velocities, Space::Velocities],
        entity: Entity::Number,
        units,
    }
}

fn by_one(of: &[Kind], turning: &'static str, sliding: &'static str) -> &'static str {
    match of[0] {
        Kind::Slide => sliding,
        _ => turning,
    }
}

/// Of two entries that turn, of which one does, of which none does.
fn by_two(of: &[Kind], [both, one, none]: [&'static str; 3]) -> &'static str {
    match [of[0], of[1]] {
        [Kind::Slide, Kind::Slide] => none,
        [Kind::Slide, _] | [_, Kind::Slide] => one,
        _ => both,
    }
}
