//! The functions that can be generated: names, arguments, results.
//!
//! A shared noun: one table that every stage and every door reads, so that a function is added in
//! one place and in its own file of the model stage. It never computes anything.

/// A function of the state of a robot with N joints.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Function {
    /// M₀,tip.
    ForwardKinematics,
    /// Columns L₁…L_N in frame 0, pole at its origin.
    SpatialJacobian,
    /// Columns L₁…L_N in the frame of the tip, pole at its origin.
    BodyJacobian,
    /// Columns in the axes of frame 0, pole at the origin of the tip.
    GeometricJacobian,
    /// W₀,tip₍₀₎.
    Velocity,
    /// H₀,tip₍₀₎, without gravity.
    Acceleration,
    /// Joint forces and torques that produce q̈.
    InverseDynamics,
    /// Inverse dynamics at rest.
    Gravity,
    /// Inverse dynamics at q̈ = 0: Coriolis, centrifugal and gravity terms.
    Bias,
    /// The joint-space inertia matrix.
    MassMatrix,
    /// Joint accelerations that forces and torques produce.
    ForwardDynamics,
    /// The inverse of the joint-space inertia matrix.
    MassMatrixInverse,
}

/// An argument of a generated function: an array of N numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Argument {
    /// Joint coordinates [rad or m].
    Q,
    /// Their rates [rad/s or m/s].
    Qd,
    /// Their second rates [rad/s² or m/s²].
    Qdd,
    /// Joint torques and forces \[N m or N\].
    Tau,
}

/// The shape of a result.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// A pose: 12 entries, row by row of the upper 3×4 block (r_xx, r_xy, r_xz, t_x, …).
    Pose,
    /// A velocity matrix: ω_x, ω_y, ω_z, v_x, v_y, v_z.
    Velocity,
    /// An acceleration matrix: 12 entries, row by row of the upper 3×4 block (G, a).
    Acceleration,
    /// N screws, each u_x, u_y, u_z, b_x, b_y, b_z.
    Screws,
    /// N numbers.
    Vector,
    /// N rows of N numbers, row by row.
    Matrix,
}

impl Function {
    /// All of them, in the order of the documentation.
    pub const ALL: [Self; 12] = [
        Self::ForwardKinematics,
        Self::SpatialJacobian,
        Self::BodyJacobian,
        Self::GeometricJacobian,
        Self::Velocity,
        Self::Acceleration,
        Self::InverseDynamics,
        Self::Gravity,
        Self::Bias,
        Self::MassMatrix,
        Self::ForwardDynamics,
        Self::MassMatrixInverse,
    ];

    /// The name in generated code, in attributes and on the command line.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::ForwardKinematics => "forward_kinematics",
            Self::SpatialJacobian => "spatial_jacobian",
            Self::BodyJacobian => "body_jacobian",
            Self::GeometricJacobian => "geometric_jacobian",
            Self::Velocity => "velocity",
            Self::Acceleration => "acceleration",
            Self::InverseDynamics => "inverse_dynamics",
            Self::Gravity => "gravity",
            Self::Bias => "bias",
            Self::MassMatrix => "mass_matrix",
            Self::ForwardDynamics => "forward_dynamics",
            Self::MassMatrixInverse => "mass_matrix_inverse",
        }
    }

    /// The function of that name.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL
            .into_iter()
            .find(|function| function.name() == name)
    }

    /// What it is a function of, in the order of its parameters.
    #[must_use]
    pub const fn arguments(self) -> &'static [Argument] {
        match self {
            Self::ForwardKinematics
            | Self::SpatialJacobian
            | Self::BodyJacobian
            | Self::GeometricJacobian
            | Self::Gravity
            | Self::MassMatrix
            | Self::MassMatrixInverse => &[Argument::Q],
            Self::Velocity | Self::Bias => &[Argument::Q, Argument::Qd],
            Self::ForwardDynamics => &[Argument::Q, Argument::Qd, Argument::Tau],
            Self::Acceleration | Self::InverseDynamics => {
                &[Argument::Q, Argument::Qd, Argument::Qdd]
            }
        }
    }

    /// The shape of its result.
    #[must_use]
    pub const fn shape(self) -> Shape {
        match self {
            Self::ForwardKinematics => Shape::Pose,
            Self::SpatialJacobian | Self::BodyJacobian | Self::GeometricJacobian => Shape::Screws,
            Self::Velocity => Shape::Velocity,
            Self::Acceleration => Shape::Acceleration,
            Self::InverseDynamics | Self::Gravity | Self::Bias | Self::ForwardDynamics => {
                Shape::Vector
            }
            Self::MassMatrix | Self::MassMatrixInverse => Shape::Matrix,
        }
    }

    /// The unit of each number of its result, 1 where it has none; `slides` says of each joint whether
    /// it is prismatic.
    #[must_use]
    pub fn units(self, slides: &[bool]) -> Vec<&'static str> {
        let by_joint =
            |turning, sliding| move |&slides: &bool| if slides { sliding } else { turning };
        let rows = |rotation: &'static str, translation: &'static str| {
            [rotation, rotation, rotation, translation].repeat(3)
        };
        let by_pair = |[both, one, none]: [&'static str; 3]| {
            let pairs = slides
                .iter()
                .flat_map(|a| slides.iter().map(move |b| (*a, *b)));
            pairs
                .map(|pair| match pair {
                    (false, false) => both,
                    (true, true) => none,
                    _ => one,
                })
                .collect()
        };
        match self {
            Self::ForwardKinematics => rows("1", "m"),
            Self::Acceleration => rows("1/s²", "m/s²"),
            Self::Velocity => ["rad/s", "m/s"].map(|unit| [unit; 3]).concat(),
            Self::SpatialJacobian | Self::BodyJacobian | Self::GeometricJacobian => {
                let b = slides.iter().map(by_joint("m", "1"));
                b.flat_map(|b| ["1", "1", "1", b, b, b]).collect()
            }
            Self::InverseDynamics | Self::Gravity | Self::Bias => {
                slides.iter().map(by_joint("N m", "N")).collect()
            }
            Self::ForwardDynamics => slides.iter().map(by_joint("rad/s²", "m/s²")).collect(),
            Self::MassMatrix => by_pair(["kg m²", "kg m", "kg"]),
            Self::MassMatrixInverse => by_pair(["1/(kg m²)", "1/(kg m)", "1/kg"]),
        }
    }

    /// Whether it solves for what forces do to accelerations.
    #[must_use]
    pub const fn solves(self) -> bool {
        matches!(self, Self::ForwardDynamics | Self::MassMatrixInverse)
    }

    /// Whether it is about a frame (the tip's, or a further one) rather than about the whole robot.
    #[must_use]
    pub const fn of_a_frame(self) -> bool {
        !matches!(self.shape(), Shape::Vector | Shape::Matrix)
    }
}

impl Argument {
    /// Its name in generated code and in state files.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Q => "q",
            Self::Qd => "qd",
            Self::Qdd => "qdd",
            Self::Tau => "tau",
        }
    }
}

impl Shape {
    /// How many numbers it holds for a robot with `joints` joints.
    #[must_use]
    pub const fn len(self, joints: usize) -> usize {
        match self {
            Self::Pose | Self::Acceleration => 12,
            Self::Velocity => 6,
            Self::Screws => 6 * joints,
            Self::Vector => joints,
            Self::Matrix => joints * joints,
        }
    }
}
