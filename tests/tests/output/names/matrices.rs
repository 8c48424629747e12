//! All matrices of a robot at a state, and the entry that a label names.
//!
//! In: a chain, its layout, a state; the label of a value. Out: the entry of the label, by products and sums of
//! [`homogen`] in frame 0, independent of functions and programs.

use std::array::from_fn;

use homogen::{Acceleration, Action, Inertia, Pose, Screw, Velocity};
use homogen_codegen::chain::Chain;
use homogen_codegen::expression::{
    Block, Component, Label, LabelledBodies, Numeral, Quantity, Term, evaluate,
};
use homogen_codegen::joint::Motion;
use homogen_codegen::layout::{Body, Layout, arrange};
use homogen_codegen::list::Id;
use homogen_codegen::matrix;
use homogen_codegen::space::Variable;
use homogen_tests::arguments::Arguments;

/// All matrices of a robot at a state, in frame 0 unless stated otherwise.
pub struct Matrices {
    parents: Vec<Option<usize>>,
    pub m: Vec<Pose<f64>>,
    /// The body of the function's frame, and M of the frame.
    end: (Option<usize>, Pose<f64>),
    l: Vec<Screw<f64>>,
    pub w: Vec<Velocity<f64>>,
    /// H, and H − H_g.
    pub h: [Vec<Acceleration<f64>>; 2],
    j: Vec<Inertia<f64>>,
    /// The mass of all bodies, and of what regrouping has moved to the base.
    mass: f64,
}

/// The numbers of terms without inputs.
fn numbers<const N: usize>(terms: [Term<'_>; N]) -> [f64; N] {
    let found = evaluate(terms[0].graph(), &terms.map(Term::expr), |_| unreachable!());
    from_fn(|k| found[k])
}

fn pose(m: &matrix::Pose<Term<'_>>) -> Pose<f64> {
    Pose::new(m.rotation.0.map(numbers), numbers(m.translation.0))
}

fn inertia(j: &matrix::Inertia<Term<'_>>) -> Inertia<f64> {
    let [mass] = numbers([j.mass]);
    Inertia::new(numbers(j.second.0), numbers(j.q.0), mass)
}

/// L of a body's joint, in its own frame.
fn screw(body: &Body<'_>) -> Screw<f64> {
    let z = [0.0, 0.0, 1.0];
    match body.motion {
        Motion::Revolute => Screw::revolute(z, [0.0; 3]),
        Motion::Prismatic => Screw::prismatic(z),
        Motion::Screw(pitch) => {
            let [pitch] = numbers([body.inertia.mass.graph().term(pitch)]);
            Screw::helical(z, [0.0; 3], pitch)
        }
    }
}

impl Matrices {
    pub fn at(chain: &Chain, layout: Layout, state: &Arguments) -> Self {
        let graph = chain.graph.clone();
        let bodies = arrange(&graph, chain, layout);
        let gravity = numbers(bodies.gravity.0);
        let mut all = Self {
            parents: (bodies.bodies.iter())
                .map(|body| body.parent.map(Id::index))
                .collect(),
            m: Vec::new(),
            end: (None, Pose::identity()),
            l: Vec::new(),
            w: Vec::new(),
            h: [Vec::new(), Vec::new()],
            j: Vec::new(),
            mass: inertia(&bodies.base).mass(),
        };
        for (k, body) in bodies.bodies.iter().enumerate() {
            let (l, carrier) = (screw(body), body.parent.map(Id::index));
            let offset = body.offset.map_or([0.0, 1.0], |(s, c)| numbers([s, c]));
            let angle = offset[0].atan2(offset[1]);
            let rotated = Screw::revolute([0.0, 0.0, 1.0], [0.0; 3]).exp(angle);
            let step = rotated.to_relative_pose() * l.exp(state[Variable::Q][k]).to_relative_pose();
            let outer = all.of_body(carrier);
            let m = outer * pose(&body.placement) * step;
            let (l, j) = (m.change_frame(&l), m.change_frame(&inertia(&body.inertia)));
            let parent =
                |list: &Vec<Acceleration<f64>>, base| carrier.map_or(base, |parent| list[parent]);
            let w_outer = carrier.map_or_else(Velocity::zero, |parent| all.w[parent]);
            let own = (
                l.velocity(state[Variable::Qd][k]),
                l.acceleration(state[Variable::Qd][k], state[Variable::Qdd][k]),
            );
            let base = Acceleration::zero();
            let h = [
                parent(&all.h[0], base),
                parent(&all.h[1], base.less_gravity(gravity)),
            ]
            .map(|outer| outer.compose(&own.1, &w_outer, &own.0));
            all.m.push(m);
            all.l.push(l);
            all.mass += j.mass();
            all.j.push(j);
            all.w.push(w_outer + own.0);
            all.h.iter_mut().zip(h).for_each(|(list, h)| list.push(h));
        }
        if let Some((body, end)) = bodies.frames.first() {
            let body = body.map(Id::index);
            all.end = (body, all.of_body(body) * pose(end));
        }
        all
    }

    fn of_body(&self, body: Option<usize>) -> Pose<f64> {
        body.map_or_else(Pose::identity, |body| self.m[body])
    }

    /// M₀ of frame k, which is the frame of body k − 1 counted from 0.
    fn frame(&self, k: usize) -> Pose<f64> {
        self.of_body(k.checked_sub(1))
    }

    /// The body and all bodies that it carries.
    fn outboard(&self, body: usize) -> impl Iterator<Item = usize> + '_ {
        (body..self.m.len()).filter(move |k| {
            let mut inwards = std::iter::successors(Some(*k), |k| self.parents[*k]);
            inwards.any(|k| k == body)
        })
    }

    /// Possible values of the entry. Wrenches have two: of a motion, and of a column of the mass matrix. Inertias in
    /// frame 0 have two: of a body, and of all that it carries. None for what is not a matrix of the paper.
    pub fn of(&self, label: Label) -> Vec<f64> {
        let Quantity { block, of, frame } = label.quantity;
        let m_k_0 = frame.map_or_else(Pose::identity, |frame| self.frame(frame.0).inverse());
        let at = |vector: [f64; 3]| match label.component {
            Component::Along(k) => vector[k],
            other => panic!("{other:?} of a vector"),
        };
        let (LabelledBodies::Body(body)
        | LabelledBodies::FromBase(body)
        | LabelledBodies::TipFrom(body)
        | LabelledBodies::Pair(body, _)) = of;
        // Bodies are counted from 1; frame 0 has no body.
        let i = || body.0.checked_sub(1).expect("a body");
        let h = |which: usize| m_k_0.change_frame(&self.h[which][i()]);
        let values = match block {
            Block::Axis(axis) => {
                let pose = self.seen(of);
                vec![at(from_fn(|row| pose.rotation()[row][axis]))]
            }
            Block::Origin => vec![at(self.seen(of).translation())],
            Block::AngularVelocity => vec![at(m_k_0.change_frame(&self.velocity(of)).omega())],
            Block::LinearVelocity => vec![at(m_k_0.change_frame(&self.velocity(of)).v())],
            Block::AngularAcceleration => vec![at(h(0).omega_dot())],
            // In dynamics gravity is subtracted, in momentum it is not.
            Block::LinearAcceleration => vec![at(h(1).a()), at(h(0).a())],
            Block::Direction => vec![at(m_k_0.change_frame(&self.l[i()]).u())],
            Block::Moment => vec![at(m_k_0.change_frame(&self.l[i()]).b())],
            Block::Inertia => {
                // With all that it carries, as in the mass matrix; in frame 0 also by itself.
                let own = (frame == Some(Numeral(0))).then_some(self.j[i()]);
                let known = [Some(self.carried(i())), own].into_iter().flatten();
                let entry = |j: Inertia<f64>| match (m_k_0.change_frame(&j), label.component) {
                    (j, Component::Second(row, column)) => j.second_moments()[row][column],
                    (j, Component::Mass) => j.mass(),
                    (j, _) => at(j.q()),
                };
                known.map(entry).collect()
            }
            // The first moment in J, divided by the mass of the robot.
            Block::MassCenter => vec![at(m_k_0.change_frame(&self.carried(i())).q()) / self.mass],
            Block::Couple => self
                .actions(i())
                .map(|phi| at(m_k_0.change_frame(&phi).c()))
                .into(),
            Block::Force => self
                .actions(i())
                .map(|phi| at(m_k_0.change_frame(&phi).f()))
                .into(),
            Block::Pivot | Block::Factor => Vec::new(),
        };
        let sign = if label.negative { -1.0 } else { 1.0 };
        values.into_iter().map(|value| sign * value).collect()
    }

    /// M of a label.
    fn seen(&self, of: LabelledBodies) -> Pose<f64> {
        match of {
            LabelledBodies::TipFrom(i) => self.frame(i.0).inverse() * self.end.1,
            LabelledBodies::FromBase(i) => self.frame(i.0),
            LabelledBodies::Body(_) | LabelledBodies::Pair(..) => panic!("{of:?} of a pose"),
        }
    }

    /// W of a label, in frame 0.
    fn velocity(&self, of: LabelledBodies) -> Velocity<f64> {
        let at = |body: Option<usize>| body.map_or_else(Velocity::zero, |body| self.w[body]);
        match of {
            LabelledBodies::TipFrom(i) => at(self.end.0) - at(i.0.checked_sub(1)),
            LabelledBodies::FromBase(i) => at(i.0.checked_sub(1)),
            LabelledBodies::Body(_) | LabelledBodies::Pair(..) => panic!("{of:?} of a velocity"),
        }
    }

    /// J of a body with all that it carries, in frame 0.
    fn carried(&self, i: usize) -> Inertia<f64> {
        self.outboard(i)
            .fold(Inertia::zero(), |sum, k| sum + self.j[k])
    }

    /// Φ through a joint, in frame 0: of the motion, and of its own column of the mass matrix.
    fn actions(&self, i: usize) -> [Action<f64>; 2] {
        let of_motion = self.outboard(i).fold(Action::zero(), |sum, k| {
            sum + self.j[k].action(&self.h[1][k])
        });
        let second =
            Acceleration::from_velocity_derivative(&Velocity::zero(), &self.l[i].velocity(1.0));
        [of_motion, self.carried(i).action(&second)]
    }
}
