//! All matrices of a robot at a state, and the entry that a name stands for.
//!
//! In: a chain, where its frames stand, a state; a name such as `w_0_3_in_3_x`. Out: the number that the
//! name says, by the products and sums of [`homogen`] in frame 0. It knows no function and no program.

use std::array::from_fn;

use homogen::{Acceleration, Action, Inertia, Pose, Screw, Velocity};
use homogen_codegen::chain::Chain;
use homogen_codegen::expression::{Term, evaluate};
use homogen_codegen::joint::Motion;
use homogen_codegen::layout::{Body, Layout, arrange};
use homogen_codegen::list::Id;
use homogen_codegen::matrix;
use homogen_tests::arguments::Arguments;

/// All matrices of a robot at a state, in frame 0, where nothing says otherwise.
pub struct Matrices {
    parents: Vec<Option<usize>>,
    pub m: Vec<Pose<f64>>,
    /// M of the frame that the function is of, and the body that carries it.
    end: (Option<usize>, Pose<f64>),
    l: Vec<Screw<f64>>,
    pub w: Vec<Velocity<f64>>,
    /// H, and H − H_g.
    pub h: [Vec<Acceleration<f64>>; 2],
    j: Vec<Inertia<f64>>,
    /// Of all bodies, and of what regrouping has left to the base.
    mass: f64,
}

/// The numbers of terms that no input enters.
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
            let turned = Screw::revolute([0.0, 0.0, 1.0], [0.0; 3]).exp(angle);
            let step = turned.to_relative_pose() * l.exp(state.q[k]).to_relative_pose();
            let outer = all.of_body(carrier);
            let m = outer * pose(&body.placement) * step;
            let (l, j) = (m.change_frame(&l), m.change_frame(&inertia(&body.inertia)));
            let parent =
                |list: &Vec<Acceleration<f64>>, base| carrier.map_or(base, |parent| list[parent]);
            let w_outer = carrier.map_or_else(Velocity::zero, |parent| all.w[parent]);
            let own = (
                l.velocity(state.qd[k]),
                l.acceleration(state.qd[k], state.qdd[k]),
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

    /// M₀ of frame k, which is that of body k − 1 counted from 0.
    fn frame(&self, k: usize) -> Pose<f64> {
        self.of_body(k.checked_sub(1))
    }

    /// The body and all that it carries.
    fn outboard(&self, body: usize) -> impl Iterator<Item = usize> + '_ {
        (body..self.m.len()).filter(move |k| {
            let mut inwards = std::iter::successors(Some(*k), |k| self.parents[*k]);
            inwards.any(|k| k == body)
        })
    }

    /// What the entry of that name may be: of actions there are those of a motion and those of the columns
    /// of the mass matrix, and of inertias in frame 0 those of a body and of all that it carries.
    pub fn named(&self, name: &str) -> Option<Vec<f64>> {
        let (name, sign) = match name.strip_prefix("minus_") {
            Some(name) => (name, -1.0),
            None => (name, 1.0),
        };
        let (letter, subscripts) = name.split_once('_')?;
        let (pair, rest) = match subscripts.split_once("_in_") {
            Some((pair, rest)) => (pair, Some(rest)),
            None => (subscripts, None),
        };
        let values = match rest {
            Some(rest) => {
                let (frame, entry) = rest.split_once('_')?;
                let m_k_0 = self.frame(frame.parse().ok()?).inverse();
                self.in_frame(letter, pair, &m_k_0, entry, frame == "0")?
            }
            None if letter == "m" => {
                let (pair, entry) = pair.rsplit_once('_')?;
                vec![self.relative_pose(pair, entry)?]
            }
            None => return None,
        };
        Some(values.into_iter().map(|value| sign * value).collect())
    }

    /// An entry of Mᵢⱼ: column and row.
    fn relative_pose(&self, pair: &str, entry: &str) -> Option<f64> {
        let (i, j) = pair.split_once('_')?;
        let to = match j {
            "n" => self.end.1,
            j => self.frame(j.parse().ok()?),
        };
        let m = self.frame(i.parse().ok()?).inverse() * to;
        let row = axis(entry.get(1..)?)?;
        Some(match entry.get(..1)? {
            "t" => m.translation()[row],
            column => m.rotation()[row][axis(column)?],
        })
    }

    fn in_frame(
        &self,
        letter: &str,
        pair: &str,
        m_k_0: &Pose<f64>,
        entry: &str,
        in_base: bool,
    ) -> Option<Vec<f64>> {
        let body = |i: &str| {
            i.parse::<usize>()
                .ok()?
                .checked_sub(1)
                .filter(|i| *i < self.m.len())
        };
        let of_base = || pair.strip_prefix("0_").and_then(body);
        let value = match letter {
            "w" => {
                let w = match pair.split_once('_')? {
                    (i, "n") => {
                        let w = self.end.0.map_or_else(Velocity::zero, |end| self.w[end]);
                        let i = i.parse::<usize>().ok()?.checked_sub(1);
                        w - i.map_or_else(Velocity::zero, |i| self.w[i])
                    }
                    _ => self.w[of_base()?],
                };
                let w = m_k_0.change_frame(&w);
                match entry.strip_prefix('v') {
                    Some(entry) => w.v()[axis(entry)?],
                    None => w.omega()[axis(entry)?],
                }
            }
            "wd" => m_k_0.change_frame(&self.h[0][of_base()?]).omega_dot()[axis(entry)?],
            // Of dynamics, from which gravity is taken, or of momentum, from which it is not.
            "h" => {
                let (body, entry) = (of_base()?, axis(entry)?);
                let known = [1, 0].map(|which| m_k_0.change_frame(&self.h[which][body]).a()[entry]);
                return Some(known.to_vec());
            }
            "l" => {
                let l = m_k_0.change_frame(&self.l[body(pair)?]);
                let part = if entry.starts_with('u') { l.u() } else { l.b() };
                part[axis(entry.get(1..)?)?]
            }
            "j" => {
                // With what it carries, of which the mass matrix is made; in frame 0 also by itself.
                let i = body(pair)?;
                let whole = self
                    .outboard(i)
                    .fold(Inertia::zero(), |sum, k| sum + self.j[k]);
                let known = [Some(whole), in_base.then_some(self.j[i])];
                let known = known.into_iter().flatten();
                return known
                    .map(|j| inertia_entry(&m_k_0.change_frame(&j), entry))
                    .collect();
            }
            // The first moment in J, by the mass of the robot.
            "c" => {
                let carried = self.outboard(body(pair)?);
                let whole = carried.fold(Inertia::zero(), |sum, k| sum + self.j[k]);
                m_k_0.change_frame(&whole).q()[axis(entry)?] / self.mass
            }
            "phi" => return self.actions(body(pair)?, m_k_0, entry),
            _ => return None,
        };
        Some(vec![value])
    }

    /// Φ through a joint: of the motion, and of its own column of the mass matrix.
    fn actions(&self, i: usize, m_k_0: &Pose<f64>, entry: &str) -> Option<Vec<f64>> {
        let of_motion = self.outboard(i).fold(Action::zero(), |sum, k| {
            sum + self.j[k].action(&self.h[1][k])
        });
        let whole = self
            .outboard(i)
            .fold(Inertia::zero(), |sum, k| sum + self.j[k]);
        let second =
            Acceleration::from_velocity_derivative(&Velocity::zero(), &self.l[i].velocity(1.0));
        let at = axis(entry.get(1..)?)?;
        let part = |phi: Action<f64>| {
            let phi = m_k_0.change_frame(&phi);
            if entry.starts_with('c') {
                phi.c()[at]
            } else {
                phi.f()[at]
            }
        };
        Some(vec![part(of_motion), part(whole.action(&second))])
    }
}

fn inertia_entry(j: &Inertia<f64>, entry: &str) -> Option<f64> {
    let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = j.second_moments();
    let known = [
        ("xx", xx),
        ("yy", yy),
        ("zz", zz),
        ("xy", xy),
        ("xz", xz),
        ("yz", yz),
    ];
    match known.iter().find(|(name, _)| *name == entry) {
        Some((_, value)) => Some(*value),
        None if entry == "m" => Some(j.mass()),
        None => Some(j.q()[axis(entry)?]),
    }
}

fn axis(name: &str) -> Option<usize> {
    ["x", "y", "z"].iter().position(|axis| *axis == name)
}
