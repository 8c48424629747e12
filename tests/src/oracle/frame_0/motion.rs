//! Poses, velocities and accelerations of all bodies, in frame 0.
//!
//! In: a robot in matrices, q, q̇ and q̈. Out: M, J, L, W and H of every body by dense products.

use crate::big::Big;
use crate::oracle::matrix::Matrix;
use crate::oracle::robot::Robot;

/// All that depends on q alone, in frame 0.
#[derive(Clone)]
pub(super) struct Positions {
    /// M₀ᵢ.
    pub(super) m: Vec<Matrix>,
    /// Jᵢ₍₀₎.
    pub(super) j: Vec<Matrix>,
    /// The screws of all joints; several for one velocity if joints mimic others.
    pub(super) screws: Vec<JointScrew>,
}

/// A motion of a body, and of all that it carries, at unit velocity.
#[derive(Clone)]
pub(super) struct JointScrew {
    /// The body.
    pub(super) body: usize,
    /// The index of the velocity.
    pub(super) velocity: usize,
    /// L₍₀₎.
    pub(super) l: Matrix,
}

impl Positions {
    pub(super) fn at(robot: &Robot, q: &[Big]) -> Self {
        let mut positions = Self {
            m: Vec::new(),
            j: Vec::new(),
            screws: Vec::new(),
        };
        for (index, body) in robot.bodies.iter().enumerate() {
            let placed = &positions.of_frame(body.parent) * &body.placement;
            let m = &placed * &body.motion.displacement(q);
            let back = m.inverse();
            let screws = body.motion.screws().into_iter();
            let screws = screws.map(|(velocity, screw)| JointScrew {
                body: index,
                velocity,
                l: &(&m * &screw) * &back,
            });
            positions.screws.extend(screws);
            positions.j.push(&(&m * &body.inertia) * &m.transposed());
            positions.m.push(m);
        }
        positions
    }

    /// The screws of a body's joint.
    pub(super) fn of_body(&self, body: usize) -> impl Iterator<Item = &JointScrew> {
        let all = self.screws.iter();
        all.filter(move |screw| screw.body == body)
    }

    pub(super) fn of_frame(&self, body: Option<usize>) -> Matrix {
        body.map_or_else(Matrix::identity, |body| self.m[body].clone())
    }
}

/// All that depends on q̇ and q̈ too, in frame 0.
pub(super) struct Motion {
    /// W₀ᵢ.
    pub(super) w: Vec<Matrix>,
    /// H₀ᵢ.
    pub(super) h: Vec<Matrix>,
    /// Torques of armature, damping and friction on each velocity.
    pub(super) actuator_torques: Vec<Big>,
}

impl Motion {
    /// Composes W = Σ L q̇ and H = Σ L q̈ + W² of each joint by (12) and (13). Screws of one joint are constant in the
    /// frame of the moved body.
    pub(super) fn at(robot: &Robot, positions: &Positions, qd: &[Big], qdd: &[Big]) -> Self {
        let mut motion = Self {
            w: Vec::new(),
            h: Vec::new(),
            actuator_torques: vec![Big::zero(); robot.velocities()],
        };
        for actuator in &robot.actuators {
            let sum = &mut motion.actuator_torques[actuator.velocity];
            *sum = &*sum + actuator.torque(qd, qdd);
        }
        for (index, body) in robot.bodies.iter().enumerate() {
            let (mut w, mut h) = (motion.w_of(body.parent), motion.h_of(body.parent));
            let along = |rates: &[Big]| {
                let each = positions.of_body(index);
                each.fold(Matrix::zero(), |sum, screw| {
                    &sum + &screw.l.times(&rates[screw.velocity])
                })
            };
            if body.motion.moves() {
                let of_joint = along(qd);
                let drift = &(&w * &of_joint).times(&Big::new(2.0)) + &(&of_joint * &of_joint);
                h = &(&h + &along(qdd)) + &drift;
                w = &w + &of_joint;
            }
            motion.w.push(w);
            motion.h.push(h);
        }
        motion
    }

    pub(super) fn w_of(&self, body: Option<usize>) -> Matrix {
        body.map_or_else(Matrix::zero, |body| self.w[body].clone())
    }

    pub(super) fn h_of(&self, body: Option<usize>) -> Matrix {
        body.map_or_else(Matrix::zero, |body| self.h[body].clone())
    }
}
