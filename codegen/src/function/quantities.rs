//! Results that several functions return, with their units.

use crate::space::{Entity, Kind, Outcome, Part, Quantity, Space};

/// A pose.
pub(super) const POSE: Outcome = poses(&[]);

/// The poses of all requested frames.
pub(super) const POSES: Outcome = poses(&[Space::Frames]);

const fn poses(over: &'static [Space]) -> Outcome {
    Outcome::One(Quantity {
        over,
        entity: Entity::Pose,
        units: |_| ["1", "1", "1", "m"].repeat(3),
    })
}

/// A velocity matrix.
pub(super) const VELOCITY: Outcome = Outcome::One(Quantity {
    over: &[],
    entity: Entity::Velocity,
    units: |_| ["rad/s", "m/s"].map(|unit| [unit; 3]).concat(),
});

/// An acceleration matrix.
pub(super) const ACCELERATION: Outcome = Outcome::One(Quantity {
    over: &[],
    entity: Entity::Acceleration,
    units: |_| ["1/s²", "1/s²", "1/s²", "m/s²"].repeat(3),
});

/// A screw for each velocity.
pub(super) const SCREWS: Outcome = Outcome::One(Quantity {
    over: &[Space::Velocities],
    entity: Entity::Screw,
    units: |of| {
        let b = by_one(of, "m", "1");
        vec!["1", "1", "1", b, b, b]
    },
});

/// The time derivative of a screw for each velocity.
pub(super) const SCREW_RATES: Outcome = Outcome::One(Quantity {
    over: &[Space::Velocities],
    entity: Entity::Screw,
    units: |of| {
        let b = by_one(of, "m/s", "1/s");
        vec!["1/s", "1/s", "1/s", b, b, b]
    },
});

/// The derivative of a screw by each coordinate, for each velocity.
pub(super) const SCREW_DERIVATIVES: Outcome = Outcome::One(Quantity {
    over: &[Space::Velocities, Space::Velocities],
    entity: Entity::Screw,
    units: |of| {
        let u = by_one(of, "1", "1/m");
        let b = by_one(&of[1..], by_one(of, "m", "1"), by_one(of, "1", "1/m"));
        vec![u, u, u, b, b, b]
    },
});

/// A point.
pub(super) const POINT: Outcome = Outcome::One(Quantity {
    over: &[],
    entity: Entity::Point,
    units: |_| vec!["m"; 3],
});

/// A point of each collision sphere.
pub(super) const CENTERS: Outcome = Outcome::One(Quantity {
    over: &[Space::Spheres],
    entity: Entity::Point,
    units: |_| vec!["m"; 3],
});

/// A length for each pair of collision spheres.
pub(super) const DISTANCES: Outcome = Outcome::One(Quantity {
    over: &[Space::Pairs],
    entity: Entity::Number,
    units: |_| vec!["m"],
});

/// The derivatives of these by q.
pub(super) const DISTANCE_DERIVATIVES: Outcome = Outcome::One(Quantity {
    over: &[Space::Pairs, Space::Velocities],
    entity: Entity::Number,
    units: |of| vec![by_one(&of[1..], "m", "1")],
});

/// The velocity of a point.
pub(super) const POINT_RATE: Outcome = Outcome::One(Quantity {
    over: &[],
    entity: Entity::Vector,
    units: |_| vec!["m/s"; 3],
});

/// The velocity of a point at unit velocity of each degree of freedom.
pub(super) const POINT_RATES: Outcome = Outcome::One(Quantity {
    over: &[Space::Velocities],
    entity: Entity::Vector,
    units: |of| vec![by_one(of, "m", "1"); 3],
});

/// A momentum matrix.
pub(super) const MOMENTUM: Outcome = Outcome::One(Quantity {
    over: &[],
    entity: Entity::Momentum,
    units: |_| ["kg m²/s", "kg m/s"].map(|unit| [unit; 3]).concat(),
});

/// The momentum matrix at unit velocity of each degree of freedom.
pub(super) const MOMENTA: Outcome = Outcome::One(Quantity {
    over: &[Space::Velocities],
    entity: Entity::Momentum,
    units: |of| {
        let (gamma, rho) = (by_one(of, "kg m²", "kg m"), by_one(of, "kg m", "kg"));
        [gamma, rho].map(|unit| [unit; 3]).concat()
    },
});

/// A wrench matrix.
pub(super) const ACTION: Outcome = Outcome::One(Quantity {
    over: &[],
    entity: Entity::Action,
    units: |_| ["N m", "N"].map(|unit| [unit; 3]).concat(),
});

/// An energy.
pub(super) const ENERGY: Outcome = Outcome::One(Quantity {
    over: &[],
    entity: Entity::Number,
    units: |_| vec!["J"],
});

/// Joint torques and forces.
pub(super) const FORCES: Outcome = Outcome::One(TORQUES);

/// Joint accelerations.
pub(super) const SECOND_RATES: Outcome = Outcome::One(ACCELERATIONS);

/// Mass matrix: torques and forces by accelerations.
pub(super) const INERTIAS: Outcome =
    Outcome::One(matrix(|of| vec![by_two(of, ["kg m²", "kg m", "kg"])]));

/// Inverse mass matrix: accelerations by torques and forces.
pub(super) const INVERSE_INERTIAS: Outcome = Outcome::One(MOBILITIES);

/// Derivatives of joint torques and forces by coordinates and velocities.
pub(super) const FORCE_DERIVATIVES: Outcome = Outcome::Parts(
    "TorqueDerivatives",
    &[
        Part {
            name: "dq",
            about: "∂τ/∂q, a row for each force; N m, N, N/m.",
            quantity: STIFFNESSES,
        },
        Part {
            name: "dqd",
            about: "∂τ/∂q̇, a row for each force; N m s, N s, N s/m.",
            quantity: DAMPINGS,
        },
    ],
);

/// Joint torques and forces, and their change along a direction.
pub(super) const FORCE_CHANGE: Outcome = Outcome::Parts(
    "TorqueChange",
    &[
        Part {
            name: "value",
            about: "τ; N m, N.",
            quantity: TORQUES,
        },
        Part {
            name: "change",
            about: "δτ; N m, N.",
            quantity: TORQUES,
        },
    ],
);

/// Joint accelerations, and their change along a direction.
pub(super) const ACCELERATION_CHANGE: Outcome = Outcome::Parts(
    "AccelerationChange",
    &[
        Part {
            name: "value",
            about: "q̈; rad/s², m/s².",
            quantity: ACCELERATIONS,
        },
        Part {
            name: "change",
            about: "δq̈; rad/s², m/s².",
            quantity: ACCELERATIONS,
        },
    ],
);

/// Derivatives of λᵀτ, with λ a virtual displacement, so that λᵀτ is a work.
pub(super) const WORK_GRADIENT: Outcome = Outcome::Parts(
    "TorqueGradient",
    &[
        Part {
            name: "dq",
            about: "∂(λᵀτ)/∂q = (∂τ/∂q)ᵀ λ; J, J/m.",
            quantity: vector(|of| vec![by_one(of, "J", "J/m")]),
        },
        Part {
            name: "dqd",
            about: "∂(λᵀτ)/∂q̇ = (∂τ/∂q̇)ᵀ λ; J s, J s/m.",
            quantity: vector(|of| vec![by_one(of, "J s", "J s/m")]),
        },
        Part {
            name: "dqdd",
            about: "∂(λᵀτ)/∂q̈ = M λ; J s², J s²/m.",
            quantity: vector(|of| vec![by_one(of, "J s²", "J s²/m")]),
        },
    ],
);

/// Derivatives of λᵀq̈, with λ torques and forces, so that λᵀq̈ is a power by time.
pub(super) const ACCELERATION_GRADIENT: Outcome = Outcome::Parts(
    "AccelerationGradient",
    &[
        Part {
            name: "dq",
            about: "∂(λᵀq̈)/∂q = (∂q̈/∂q)ᵀ λ; W/s, W/(s m).",
            quantity: vector(|of| vec![by_one(of, "W/s", "W/(s m)")]),
        },
        Part {
            name: "dqd",
            about: "∂(λᵀq̈)/∂q̇ = (∂q̈/∂q̇)ᵀ λ; W, W/m.",
            quantity: vector(|of| vec![by_one(of, "W", "W/m")]),
        },
        Part {
            name: "dtau",
            about: "∂(λᵀq̈)/∂τ = M⁻¹ λ; rad/s², m/s².",
            quantity: ACCELERATIONS,
        },
    ],
);

/// Second derivatives of λᵀq̈, with λ torques and forces, so that λᵀq̈ is a power by time.
pub(super) const ACCELERATION_HESSIAN: Outcome = Outcome::Parts(
    "AccelerationHessian",
    &[
        Part {
            name: "dq_dq",
            about: "∂²(λᵀq̈)/∂q∂q; W/s, W/(s m), W/(s m²).",
            quantity: matrix(|of| vec![by_two(of, ["W/s", "W/(s m)", "W/(s m²)"])]),
        },
        Part {
            name: "dq_dqd",
            about: "∂²(λᵀq̈)/∂q∂q̇, a row for each coordinate; W, W/m, W/m².",
            quantity: matrix(|of| vec![by_two(of, ["W", "W/m", "W/m²"])]),
        },
        Part {
            name: "dqd_dqd",
            about: "∂²(λᵀq̈)/∂q̇∂q̇; W s, W s/m, W s/m².",
            quantity: matrix(|of| vec![by_two(of, ["W s", "W s/m", "W s/m²"])]),
        },
        Part {
            name: "dq_dtau",
            about: "∂²(λᵀq̈)/∂q∂τ = ∂(M⁻¹ λ)/∂q, a row for each coordinate; 1/s², 1/(s² m), m/s².",
            quantity: matrix(|of| vec![by_row_and_column(of, ["1/s²", "1/(s² m)", "m/s²"])]),
        },
    ],
);

/// Second derivatives of λᵀτ, with λ a virtual displacement, so that λᵀτ is a work.
pub(super) const WORK_HESSIAN: Outcome = Outcome::Parts(
    "TorqueHessian",
    &[
        Part {
            name: "dq_dq",
            about: "∂²(λᵀτ)/∂q∂q; J, J/m, J/m².",
            quantity: matrix(|of| vec![by_two(of, ["J", "J/m", "J/m²"])]),
        },
        Part {
            name: "dq_dqd",
            about: "∂²(λᵀτ)/∂q∂q̇, a row for each coordinate; J s, J s/m, J s/m².",
            quantity: matrix(|of| vec![by_two(of, ["J s", "J s/m", "J s/m²"])]),
        },
        Part {
            name: "dqd_dqd",
            about: "∂²(λᵀτ)/∂q̇∂q̇; J s², J s²/m, J s²/m².",
            quantity: WORKS,
        },
        Part {
            name: "dq_dqdd",
            about: "∂²(λᵀτ)/∂q∂q̈ = ∂(M λ)/∂q, a row for each coordinate; J s², J s²/m, J s²/m².",
            quantity: WORKS,
        },
    ],
);

const WORKS: Quantity = matrix(|of| vec![by_two(of, ["J s²", "J s²/m", "J s²/m²"])]);

/// Derivatives of joint accelerations by coordinates, velocities, and torques and forces.
pub(super) const ACCELERATION_DERIVATIVES: Outcome = Outcome::Parts(
    "AccelerationDerivatives",
    &[
        Part {
            name: "dq",
            about: "∂q̈/∂q, a row for each acceleration; 1/s², 1/(m s²), m/s².",
            quantity: matrix(|of| vec![by_row_and_column(of, ["1/s²", "1/(m s²)", "m/s²"])]),
        },
        Part {
            name: "dqd",
            about: "∂q̈/∂q̇, a row for each acceleration; 1/s, 1/(m s), m/s.",
            quantity: matrix(|of| vec![by_row_and_column(of, ["1/s", "1/(m s)", "m/s"])]),
        },
        Part {
            name: "dtau",
            about: "∂q̈/∂τ = M⁻¹, by rows; 1/(kg m²), 1/(kg m), 1/kg.",
            quantity: MOBILITIES,
        },
    ],
);

/// Derivative of torques and forces by coordinates.
pub(super) const STIFFNESS: Outcome = Outcome::One(STIFFNESSES);

/// Matrix that gives torques and forces from velocities.
pub(super) const DAMPING: Outcome = Outcome::One(DAMPINGS);

const TORQUES: Quantity = vector(|of| vec![by_one(of, "N m", "N")]);

const ACCELERATIONS: Quantity = vector(|of| vec![by_one(of, "rad/s²", "m/s²")]);

const STIFFNESSES: Quantity = matrix(|of| vec![by_two(of, ["N m", "N", "N/m"])]);

const DAMPINGS: Quantity = matrix(|of| vec![by_two(of, ["N m s", "N s", "N s/m"])]);

const MOBILITIES: Quantity = matrix(|of| vec![by_two(of, ["1/(kg m²)", "1/(kg m)", "1/kg"])]);

/// Regressor: torques and forces by inertial parameters.
pub(super) const REGRESSOR: Outcome = of_parameters(&[Space::Velocities, Space::Parameters]);

/// Base regressor: torques and forces by base parameters.
pub(super) const BASE_REGRESSOR: Outcome =
    of_parameters(&[Space::Velocities, Space::BaseParameters]);

const fn of_parameters(over: &'static [Space]) -> Outcome {
    Outcome::One(Quantity {
        over,
        entity: Entity::Number,
        units: |of| {
            let [rotation, translation] = match of[1] {
                Kind::Moment(0) => ["m²/s²", "m/s²"],
                Kind::Moment(1) => ["m/s²", "1/s²"],
                Kind::Actuator { order: 2, .. } => ["1/s²", "m/s²"],
                Kind::Actuator { order: 1, .. } => ["1/s", "m/s"],
                Kind::Actuator { .. } => ["1", "1"],
                _ => ["1/s²", "1/(m s²)"],
            };
            vec![by_one(of, rotation, translation)]
        },
    })
}

/// Energy by inertial parameters.
pub(super) const ENERGIES: Outcome = Outcome::One(Quantity {
    over: &[Space::Parameters],
    entity: Entity::Number,
    units: |of| {
        vec![match of[0] {
            Kind::Moment(0) => "m²/s²",
            Kind::Moment(1) => "m/s²",
            Kind::Actuator { order, translates } => match (order, translates) {
                (2, true) => "m²/s²",
                (1, false) => "1/s",
                (1, true) => "m²/s",
                (0, false) => "1",
                (0, true) => "m",
                _ => "1/s²",
            },
            _ => "1/s²",
        }]
    },
});

/// Joint accelerations by inertial parameters.
pub(super) const ACCELERATIONS_BY_PARAMETERS: Outcome = Outcome::One(Quantity {
    over: &[Space::Velocities, Space::Parameters],
    entity: Entity::Number,
    units: |of| {
        let [rotation, translation] = match of[1] {
            Kind::Moment(0) => ["1/(kg s²)", "m/(kg s²)"],
            Kind::Moment(1) => ["1/(kg m s²)", "1/(kg s²)"],
            Kind::Actuator { order, translates } => match (order, translates) {
                (2, true) => ["1/(kg s²)", "m/(kg s²)"],
                (1, false) => ["1/(kg m² s)", "1/(kg m s)"],
                (1, true) => ["1/(kg s)", "m/(kg s)"],
                (0, false) => ["1/(kg m²)", "1/(kg m)"],
                (0, true) => ["1/(kg m)", "1/kg"],
                _ => ["1/(kg m² s²)", "1/(kg m s²)"],
            },
            _ => ["1/(kg m² s²)", "1/(kg m s²)"],
        };
        vec![by_one(of, rotation, translation)]
    },
});

/// Residuals of the loops.
pub(super) const RESIDUALS: Outcome = Outcome::One(of_loops(|of| vec![by_one(of, "1", "m")]));

/// Second time derivatives of the residuals.
pub(super) const RESIDUAL_ACCELERATIONS: Outcome =
    Outcome::One(of_loops(|of| vec![by_one(of, "1/s²", "m/s²")]));

/// Joint accelerations and constraint forces: torques for products of axes, forces for lengths.
pub(super) const CONSTRAINED_MOTION: Outcome = Outcome::Parts(
    "ConstrainedAccelerations",
    &[
        Part {
            name: "qdd",
            about: "q̈, the joint accelerations; rad/s², m/s².",
            quantity: ACCELERATIONS,
        },
        Part {
            name: "multipliers",
            about: "λ, the constraint forces of the loops, one for each residual; N m, N.",
            quantity: of_loops(|of| vec![by_one(of, "N m", "N")]),
        },
    ],
);

/// Jacobian of the residuals.
pub(super) const RESIDUAL_RATES: Outcome = Outcome::One(Quantity {
    over: &[Space::Constraints, Space::Velocities],
    entity: Entity::Number,
    units: |of| {
        vec![match [of[0], of[1]] {
            [Kind::Translation, Kind::Translation] => "1",
            [Kind::Translation, _] => "m",
            [_, Kind::Translation] => "1/m",
            _ => "1",
        }]
    },
});

const fn of_loops(units: fn(&[Kind]) -> Vec<&'static str>) -> Quantity {
    Quantity {
        over: &[Space::Constraints],
        entity: Entity::Number,
        units,
    }
}

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

fn by_one(of: &[Kind], rotation: &'static str, translation: &'static str) -> &'static str {
    match of[0] {
        Kind::Translation => translation,
        _ => rotation,
    }
}

/// Unit of an entry of two rotations, of one rotation and one translation, and of two translations.
fn by_two(of: &[Kind], [both, one, none]: [&'static str; 3]) -> &'static str {
    match [of[0], of[1]] {
        [Kind::Translation, Kind::Translation] => none,
        [Kind::Translation, _] | [_, Kind::Translation] => one,
        _ => both,
    }
}

/// Unit of an entry whose row and column are alike, of a rotation by a translation, and of a translation by a rotation.
fn by_row_and_column(of: &[Kind], [alike, mixed, inverse]: [&'static str; 3]) -> &'static str {
    match [of[0], of[1]] {
        [Kind::Rotation, Kind::Translation] => mixed,
        [Kind::Translation, Kind::Rotation] => inverse,
        _ => alike,
    }
}
