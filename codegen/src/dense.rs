//! The functions of a robot, by products of 4×4 matrices in frame 0, as the paper writes them.
//!
//! In: a [`Robot`], link by link, and a [`State`]. Out: a [`Dense`], which each function's own file
//! asks for what it is. Every product is multiplied out, and no recursion is known but that from
//! parents to children: nothing here is shared with the matrices that are expanded.

mod approximate;
mod matrix;
mod posture;
mod robot;

use std::cell::OnceCell;

pub(crate) use approximate::Approximate;
pub(crate) use matrix::Matrix;
pub(crate) use robot::{Body, Freedom, Moved, Robot};

use crate::expression::{Double, Input};
use crate::space::Variable;
use posture::{Posture, Rates};

/// What a program reads.
#[derive(Clone, Debug, Default)]
pub(crate) struct State {
    pub(crate) q: Vec<Double>,
    pub(crate) qd: Vec<f64>,
    pub(crate) qdd: Vec<f64>,
    pub(crate) tau: Vec<f64>,
    pub(crate) fields: Vec<Vec<f64>>,
}

impl State {
    pub(crate) fn get(&self, input: Input) -> Double {
        let (list, k) = match input {
            Input::Variable(Variable::Q, k) => return self.q[usize::from(k)],
            Input::Variable(Variable::Qd, k) => (&self.qd, k),
            Input::Variable(Variable::Qdd, k) => (&self.qdd, k),
            Input::Variable(Variable::Tau, k) => (&self.tau, k),
            Input::Parameter(field, k) => (&self.fields[usize::from(field)], k),
        };
        list[usize::from(k)].into()
    }
}

/// How much of a state's motion is taken.
#[derive(Clone, Copy)]
pub(crate) enum Motion {
    /// None: at rest.
    Rest,
    /// q̇ alone.
    Coasting,
    /// q̇ and q̈.
    Driven,
}

/// A robot at a state.
pub(crate) struct Dense {
    pub(crate) state: State,
    posture: Posture,
    mass_matrix: OnceCell<Vec<Vec<Approximate>>>,
}

impl Dense {
    pub(crate) fn of(robot: Robot, state: State) -> Self {
        Self {
            posture: Posture::of(robot, &state.q),
            state,
            mass_matrix: OnceCell::new(),
        }
    }

    /// M of a frame.
    pub(crate) fn pose(&self, frame: usize) -> Matrix<Approximate> {
        self.posture.pose(frame)
    }

    /// The columns of a Jacobian: u and b of the joints that move a frame, each seen in some way, and
    /// zeros for the others.
    pub(crate) fn columns(
        &self,
        frame: usize,
        seen: impl Fn(&Matrix<Approximate>) -> Matrix<Approximate>,
    ) -> Vec<Approximate> {
        let mut columns = vec![Approximate::exact(0.0); 6 * self.state.qd.len()];
        for (k, screw) in self.posture.moving(frame) {
            let column = &mut columns[6 * k..6 * k + 6];
            for (entry, own) in column.iter_mut().zip(seen(screw).vectors()) {
                *entry = *entry + own;
            }
        }
        columns
    }

    /// W and H of a frame.
    pub(crate) fn motion(
        &self,
        frame: usize,
        motion: Motion,
    ) -> (Matrix<Approximate>, Matrix<Approximate>) {
        self.posture.motion(frame, &self.rates(motion))
    }

    /// W and J of each link that a joint moves.
    pub(crate) fn links(
        &self,
        motion: Motion,
    ) -> impl Iterator<Item = (Matrix<Approximate>, &Matrix<Approximate>)> {
        let motions = self.posture.motions(&self.rates(motion)).into_iter();
        let velocities = motions.map(|(velocity, _)| velocity);
        let links = velocities.zip(self.posture.inertias());
        let moves = self.posture.moves().into_iter();
        links
            .zip(moves)
            .filter_map(|(link, moves)| moves.then_some(link))
    }

    /// H_g, the acceleration of gravity.
    pub(crate) fn gravity(&self) -> Matrix<Approximate> {
        let mut gravity = Matrix::zero();
        gravity.set_column(self.posture.gravity());
        gravity
    }

    /// τ of a motion, against gravity.
    pub(crate) fn torques(&self, motion: Motion) -> Vec<Approximate> {
        self.posture.torques(&self.rates(motion))
    }

    /// τ of accelerations that were found.
    pub(crate) fn torques_of(&self, qdd: Vec<Approximate>) -> Vec<Approximate> {
        let first = Approximate::exactly(&self.state.qd);
        self.posture.torques(&Rates { first, second: qdd })
    }

    /// M, row by row.
    pub(crate) fn mass_matrix(&self) -> &[Vec<Approximate>] {
        self.mass_matrix.get_or_init(|| self.posture.mass_matrix())
    }

    fn rates(&self, motion: Motion) -> Rates {
        let nothing = || vec![Approximate::exact(0.0); self.state.qd.len()];
        let [qd, qdd] = [&self.state.qd, &self.state.qdd].map(|of| Approximate::exactly(of));
        let (first, second) = match motion {
            Motion::Rest => (nothing(), nothing()),
            Motion::Coasting => (qd, nothing()),
            Motion::Driven => (qd, qdd),
        };
        Rates { first, second }
    }
}
