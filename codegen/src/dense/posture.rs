//! All matrices of a robot in a posture.
//!
//! In: a [`Robot`] and q. Out: poses, screws and inertias in frame 0; of rates, velocities,
//! accelerations and actions, and what they add up to.

use super::{Approximate, Matrix, Moved, Robot};
use crate::expression::Arithmetic;

type Scalar = Approximate;

/// A robot in a posture: all matrices of its links, in frame 0.
pub(super) struct Posture {
    robot: Robot,
    joints: usize,
    poses: Vec<Matrix<Scalar>>,
    /// L of the joint that carries each link.
    screws: Vec<Matrix<Scalar>>,
    /// J of each link.
    inertias: Vec<Matrix<Scalar>>,
}

/// What the joints do: q̇ and q̈.
pub(super) struct Rates {
    pub(super) first: Vec<Scalar>,
    pub(super) second: Vec<Scalar>,
}

impl Posture {
    pub(super) fn of(robot: Robot, q: &[f64]) -> Self {
        let mut poses: Vec<Matrix<Scalar>> = Vec::new();
        let (mut screws, mut inertias) = (Vec::new(), Vec::new());
        for body in &robot.bodies {
            let [u, b] = body.screw;
            let at = match body.moved {
                Moved::By(k) => Scalar::exact(q[k]),
                Moved::Held(at) => Scalar::literal(at),
            };
            let mut pose = body.placement.times(&displacement(u, b, at));
            if let Some(parent) = body.parent {
                pose = poses[parent].times(&pose);
            }
            screws.push(pose.carries(&Matrix::screw(u, b)));
            inertias.push(pose.times(&body.inertia).times(&pose.transposed()));
            poses.push(pose);
        }
        Self {
            robot,
            joints: q.len(),
            poses,
            screws,
            inertias,
        }
    }

    /// J of each link.
    pub(super) fn inertias(&self) -> &[Matrix<Scalar>] {
        &self.inertias
    }

    /// Whether a joint moves each link.
    pub(super) fn moves(&self) -> Vec<bool> {
        let mut moves: Vec<bool> = Vec::new();
        for body in &self.robot.bodies {
            let carried = body.parent.is_some_and(|parent| moves[parent]);
            moves.push(carried || matches!(body.moved, Moved::By(_)));
        }
        moves
    }

    /// Acceleration of gravity in frame 0.
    pub(super) const fn gravity(&self) -> [Scalar; 3] {
        self.robot.gravity
    }

    /// M of a frame.
    pub(super) fn pose(&self, frame: usize) -> Matrix<Scalar> {
        self.robot.frames[frame].map_or_else(Matrix::identity, |body| self.poses[body].clone())
    }

    /// The screws of the joints that move a frame, by their place in q̇.
    pub(super) fn moving(&self, frame: usize) -> Vec<(usize, &Matrix<Scalar>)> {
        let mut moving = Vec::new();
        let mut at = self.robot.frames[frame];
        while let Some(body) = at {
            if let Moved::By(k) = self.robot.bodies[body].moved {
                moving.push((k, &self.screws[body]));
            }
            at = self.robot.bodies[body].parent;
        }
        moving
    }

    /// W and H of each link: W + L q̇, and H + L q̈ + L² q̇² + 2 W L q̇.
    pub(super) fn motions(&self, rates: &Rates) -> Vec<(Matrix<Scalar>, Matrix<Scalar>)> {
        let mut motions: Vec<(Matrix<Scalar>, Matrix<Scalar>)> = Vec::new();
        for (body, screw) in self.robot.bodies.iter().zip(&self.screws) {
            let (w, h) = match body.parent {
                Some(parent) => motions[parent].clone(),
                None => (Matrix::zero(), Matrix::zero()),
            };
            let Moved::By(k) = body.moved else {
                motions.push((w, h));
                continue;
            };
            let own = screw.scaled(&rates.first[k]);
            let twice = w.times(&own).scaled(&Scalar::exact(2.0));
            let second = screw.scaled(&rates.second[k]).plus(&own.times(&own));
            motions.push((w.plus(&own), h.plus(&second).plus(&twice)));
        }
        motions
    }

    /// W and H of a frame.
    pub(super) fn motion(&self, frame: usize, rates: &Rates) -> (Matrix<Scalar>, Matrix<Scalar>) {
        match self.robot.frames[frame] {
            Some(body) => self.motions(rates).swap_remove(body),
            None => (Matrix::zero(), Matrix::zero()),
        }
    }

    /// What every joint feels where each link has the given acceleration: Φ = skew(H J) of all links
    /// outboard, along L.
    fn forces(&self, acceleration: impl Fn(usize) -> Option<Matrix<Scalar>>) -> Vec<Scalar> {
        let mut forces = vec![Scalar::exact(0.0); self.joints];
        let mut actions: Vec<Option<Matrix<Scalar>>> = (self.inertias.iter().enumerate())
            .map(|(k, inertia)| Some(acceleration(k)?.times(inertia).skew()))
            .collect();
        for (k, body) in self.robot.bodies.iter().enumerate().rev() {
            let Some(action) = actions[k].take() else {
                continue;
            };
            if let Moved::By(joint) = body.moved {
                let terms = self.screws[k].vectors().into_iter().zip(action.vectors());
                let along = terms.map(|(screw, action)| screw * action);
                forces[joint] = along.fold(Scalar::exact(0.0), |sum, term| sum + term);
            }
            if let Some(parent) = body.parent {
                actions[parent] = Some(match actions[parent].take() {
                    Some(outer) => outer.plus(&action),
                    None => action,
                });
            }
        }
        forces
    }

    /// τ of a motion, against gravity.
    pub(super) fn torques(&self, rates: &Rates) -> Vec<Scalar> {
        let mut falling = Matrix::zero();
        falling.set_column(self.robot.gravity.map(|entry| -entry));
        let motions = self.motions(rates);
        self.forces(|k| Some(motions[k].1.plus(&falling)))
    }

    /// M, row by row: column k is what the joints feel where H = L of joint k in all links outboard.
    pub(super) fn mass_matrix(&self) -> Vec<Vec<Scalar>> {
        let mut columns = vec![Vec::new(); self.joints];
        for (joint, body) in self.robot.bodies.iter().enumerate() {
            let Moved::By(k) = body.moved else { continue };
            let mut outboard = vec![false; self.robot.bodies.len()];
            outboard[joint] = true;
            for (link, body) in self.robot.bodies.iter().enumerate() {
                outboard[link] |= body.parent.is_some_and(|parent| outboard[parent]);
            }
            columns[k] = self.forces(|link| outboard[link].then(|| self.screws[joint].clone()));
        }
        let row = |row: usize| columns.iter().map(|column| column[row]).collect();
        (0..self.joints).map(row).collect()
    }
}

/// Q of a joint at a coordinate: 1 + u̲ sin q + u̲² (1 − cos q) and b q along the axis.
fn displacement(u: [Scalar; 3], b: [Scalar; 3], q: Scalar) -> Matrix<Scalar> {
    let nothing = [Scalar::exact(0.0); 3];
    let turn = Matrix::screw(u, nothing);
    let (sine, cosine) = q.sin_cos();
    let versine = Scalar::exact(1.0) - cosine;
    let mut displacement = Matrix::identity()
        .plus(&turn.scaled(&sine))
        .plus(&turn.times(&turn).scaled(&versine));
    displacement.set_column(b.map(|entry| entry * q));
    displacement
}
