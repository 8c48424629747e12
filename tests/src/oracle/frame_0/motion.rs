//! Where bodies are and how they move, in frame 0.
//!
//! In: a robot in matrices, q, q̇ and q̈. Out: M, J and L, and of the rates W and H, of every body by dense products.

use crate::big::Big;
use crate::oracle::matrix::Matrix;
use crate::oracle::robot::Robot;

/// What depends on q alone, in frame 0.
pub(super) struct Positions {
    /// M₀ᵢ.
    pub(super) m: Vec<Matrix>,
    /// Jᵢ₍₀₎.
    pub(super) j: Vec<Matrix>,
    /// What each velocity moves: several bodies, where joints follow others.
    pub(super) freedoms: Vec<Freedom>,
}

/// What a velocity does to a body, and to all that it carries.
pub(super) struct Freedom {
    /// The body.
    pub(super) body: usize,
    /// The place of the velocity.
    pub(super) velocity: usize,
    /// L₍₀₎.
    pub(super) l: Matrix,
}

impl Positions {
    pub(super) fn at(robot: &Robot, q: &[Big]) -> Self {
        let mut positions = Self {
            m: Vec::new(),
            j: Vec::new(),
            freedoms: Vec::new(),
        };
        for (index, body) in robot.bodies.iter().enumerate() {
            let placed = &positions.of_frame(body.parent) * &body.placement;
            let m = &placed * &body.motion.displacement(q);
            let back = m.inverse();
            let freedoms = body.motion.screws().into_iter();
            let freedoms = freedoms.map(|(velocity, screw)| Freedom {
                body: index,
                velocity,
                l: &(&m * &screw) * &back,
            });
            positions.freedoms.extend(freedoms);
            positions.j.push(&(&m * &body.inertia) * &m.transposed());
            positions.m.push(m);
        }
        positions
    }

    /// What moves one body against the one it hangs on.
    pub(super) fn of_body(&self, body: usize) -> impl Iterator<Item = &Freedom> {
        let all = self.freedoms.iter();
        all.filter(move |freedom| freedom.body == body)
    }

    pub(super) fn of_frame(&self, body: Option<usize>) -> Matrix {
        body.map_or_else(Matrix::identity, |body| self.m[body].clone())
    }
}

/// What depends on the rates as well, in frame 0.
pub(super) struct Motion {
    /// W₀ᵢ.
    pub(super) w: Vec<Matrix>,
    /// H₀ᵢ.
    pub(super) h: Vec<Matrix>,
    /// What drives take of the torque of each velocity.
    pub(super) driven: Vec<Big>,
}

impl Motion {
    /// W = Σ L q̇ and H = Σ L q̈ + W² of one joint, whose screws are constant in the frame of the moved
    /// body; composed by (12) and (13).
    pub(super) fn at(robot: &Robot, positions: &Positions, qd: &[Big], qdd: &[Big]) -> Self {
        let mut motion = Self {
            w: Vec::new(),
            h: Vec::new(),
            driven: vec![Big::zero(); robot.velocities()],
        };
        for drive in &robot.drives {
            let taken = &mut motion.driven[drive.velocity];
            *taken = &*taken + drive.takes(qd, qdd);
        }
        for (index, body) in robot.bodies.iter().enumerate() {
            let (mut w, mut h) = (motion.w_of(body.parent), motion.h_of(body.parent));
            let along = |rates: &[Big]| {
                let each = positions.of_body(index);
                each.fold(Matrix::zero(), |sum, freedom| {
                    &sum + &freedom.l.times(&rates[freedom.velocity])
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
