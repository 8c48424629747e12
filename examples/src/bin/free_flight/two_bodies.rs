//! The free motion of two bodies with a hinge and a spring between them.
//!
//! In: inertias, the hinge, the spring; a state. Out: the state after a step, and the momentum and the energy of a
//! state. The integration does not enforce that these are constant.

use homogen::open_chain::commutator;
use homogen::{Acceleration, Inertia, Momentum, Pose, Screw, Velocity, vector};
use nalgebra::{SMatrix, SVector};
use std::array::from_fn;

/// Two bodies and the hinge between them.
pub struct Bodies {
    /// J of the first body, in its frame (1).
    pub first: Inertia<f64>,
    /// J of the second body, in its frame (2).
    pub second: Inertia<f64>,
    /// M₁,₂ with the spring at rest.
    pub placement: Pose<f64>,
    /// L of the hinge, in frame (2).
    pub hinge: Screw<f64>,
    /// The spring of the hinge [N m/rad].
    pub stiffness: f64,
}

/// The state of the bodies.
#[derive(Clone, Copy)]
pub struct State {
    /// M₀,₁.
    pub pose: Pose<f64>,
    /// The rates.
    pub rates: Rates,
    /// The derivative of the rates.
    pub slope: Rates,
}

/// W₀,₁₍₁₎, the angle of the hinge \[rad\] and its rate; or their derivatives.
#[derive(Clone, Copy)]
pub struct Rates {
    /// W₀,₁₍₁₎ or Ẇ₀,₁₍₁₎.
    pub w: Velocity<f64>,
    /// The angle of the hinge \[rad\], or its rate.
    pub angle: f64,
    /// Its rate, or its second rate.
    pub rate: f64,
}

/// The constants of the motion.
#[derive(Clone, Copy)]
pub struct Constants {
    /// Γ₍₀₎ of both bodies.
    pub momentum: Momentum<f64>,
    /// Kinetic energy and that of the spring \[J\].
    pub energy: f64,
}

impl Bodies {
    /// A box of 12 kg and a boom of 3 kg, hinged at a corner about a skew axis.
    pub fn example() -> Self {
        let tensor = |[xx, yy, zz]: [f64; 3]| [[xx, 0.0, 0.0], [0.0, yy, 0.0], [0.0, 0.0, zz]];
        let body = |mass, center, moments| {
            Inertia::from_tensor_at_center_of_mass(mass, center, &tensor(moments))
        };
        Self {
            first: body(12.0, [0.0; 3], [0.5, 0.8, 1.1]),
            second: body(3.0, [0.45, 0.0, 0.0], [0.01, 0.21, 0.21]),
            placement: Pose::from_translation([0.3, 0.2, 0.1]),
            hinge: Screw::revolute([0.0, 0.6, 0.8], [0.0; 3]),
            stiffness: 6.0,
        }
    }

    /// The initial state.
    pub fn start(&self) -> State {
        let rates = Rates {
            w: Velocity::new([0.4, 1.2, -0.3], [0.1, -0.05, 0.08]),
            angle: 0.8,
            rate: -0.5,
        };
        State {
            pose: Pose::identity(),
            rates,
            slope: self.slope(&rates),
        }
    }

    /// M₁,₂.
    fn relative_pose(&self, angle: f64) -> Pose<f64> {
        self.placement * self.hinge.exp(angle).to_relative_pose()
    }

    /// Ẇ and q̈ without external wrenches: Lagrange's equations in frame (1), for the six unit screws of that frame
    /// and the hinge.
    pub fn slope(&self, rates: &Rates) -> Rates {
        let m_1_2 = self.relative_pose(rates.angle);
        let (hinge, second) = (
            m_1_2.change_frame(&self.hinge),
            m_1_2.change_frame(&self.second),
        );
        let both = self.first + second;
        let screws: [Screw<f64>; 7] = from_fn(|i| {
            let unit = |k: usize| if i == k { 1.0 } else { 0.0 };
            if i == 6 {
                hinge
            } else {
                Screw::new([unit(0), unit(1), unit(2)], [unit(3), unit(4), unit(5)])
            }
        });
        let mass = SMatrix::<f64, 7, 7>::from_fn(|i, m| {
            let carried = if i == 6 || m == 6 { &second } else { &both };
            carried.coupling(&screws[i], &screws[m])
        });
        // H̃ of both bodies: H at Ẇ = 0 and q̈ = 0.
        let h_1 = Acceleration::from_velocity_derivative(&rates.w, &Velocity::zero());
        let w_1_2 = hinge.velocity(rates.rate);
        let h_2 = h_1.compose(&hinge.acceleration(rates.rate, 0.0), &rates.w, &w_1_2);
        let phi_2 = second.action(&h_2);
        let phi = self.first.action(&h_1) + phi_2;
        let bias = SVector::<f64, 7>::from_fn(|i, _| {
            if i == 6 {
                hinge.pseudo_scalar_product(&phi_2) + self.stiffness * rates.angle
            } else {
                screws[i].pseudo_scalar_product(&phi)
            }
        });
        let solved = mass.cholesky().map(|factors| factors.solve(&-bias));
        // Bodies with mass have a positive definite mass matrix; NaN would show in the drift.
        let x = solved.unwrap_or_else(|| SVector::repeat(f64::NAN));
        Rates {
            w: Velocity::new([x[0], x[1], x[2]], [x[3], x[4], x[5]]),
            angle: rates.rate,
            rate: x[6],
        }
    }

    /// One step of fourth order: Runge–Kutta for the rates, the Magnus series for the pose.
    ///
    /// The rates do not depend on the pose, because there are no external forces.
    pub fn step(&self, state: &State, h: f64) -> State {
        let (y, k_1) = (&state.rates, &state.slope);
        let k_2 = self.slope(&y.plus(0.5 * h, k_1));
        let k_3 = self.slope(&y.plus(0.5 * h, &k_2));
        let k_4 = self.slope(&y.plus(h, &k_3));
        let rates = y
            .plus(h / 6.0, k_1)
            .plus(h / 3.0, &k_2)
            .plus(h / 3.0, &k_3)
            .plus(h / 6.0, &k_4);
        let slope = self.slope(&rates);
        // W halfway, by Hermite's cubic; then Simpson's mean and the first commutator.
        let (w_0, w_1) = (y.w, rates.w);
        let mean = scaled(0.5, &(w_0 + w_1));
        let middle = mean + scaled(h / 8.0, &(k_1.w - slope.w));
        let mean = scaled(1.0 / 3.0, &mean) + scaled(2.0 / 3.0, &middle);
        let twist = mean + scaled(h / 12.0, &commutator(&w_0, &w_1));
        State {
            pose: state.pose * twist.displacement(h).to_relative_pose(),
            rates,
            slope,
        }
    }

    /// Momentum and energy of both bodies in a state.
    pub fn constants(&self, state: &State) -> Constants {
        let rates = &state.rates;
        let m_1_2 = self.relative_pose(rates.angle);
        let (hinge, second) = (
            m_1_2.change_frame(&self.hinge),
            m_1_2.change_frame(&self.second),
        );
        let w_2 = rates.w + hinge.velocity(rates.rate);
        let momentum = self.first.momentum(&rates.w) + second.momentum(&w_2);
        let spring = 0.5 * self.stiffness * rates.angle * rates.angle;
        Constants {
            momentum: state.pose.change_frame(&momentum),
            energy: self.first.kinetic_energy(&rates.w) + second.kinetic_energy(&w_2) + spring,
        }
    }
}

impl Rates {
    fn plus(&self, h: f64, slope: &Self) -> Self {
        Self {
            w: self.w + scaled(h, &slope.w),
            angle: self.angle + h * slope.angle,
            rate: self.rate + h * slope.rate,
        }
    }
}

impl Constants {
    /// The relative change of momentum, the larger of γ and ρ, and of energy.
    pub fn drift(&self, after: &Self) -> [f64; 2] {
        let change = after.momentum - self.momentum;
        let relative = |change, whole| vector::norm(change) / vector::norm(whole);
        let gamma = relative(change.gamma(), self.momentum.gamma());
        let rho = relative(change.rho(), self.momentum.rho());
        [
            gamma.max(rho),
            ((after.energy - self.energy) / self.energy).abs(),
        ]
    }
}

fn scaled(factor: f64, w: &Velocity<f64>) -> Velocity<f64> {
    Velocity::new(
        vector::scale(factor, w.omega()),
        vector::scale(factor, w.v()),
    )
}
