//! Random trees: what a user may describe and ask for, and the same robot as the runtime's chain.
//!
//! In: a source of random numbers. Out: a [`Tree`], whose description and request go through the
//! generator, and whose chain keeps every joint of the description, moving or not, so that nothing
//! of merging, locking, dropping and ordering is shared between the two.

mod grow;
mod reference;

use std::fmt;

use homogen::{Frame, Pose, Screw, generic};
use homogen_codegen::chain::Chain;
use homogen_codegen::description::{Description, JointKind, Name, Number, Step};
use homogen_codegen::expression::Input;
use homogen_codegen::function::Function;
use homogen_codegen::request::{Request, Target};

use crate::states::{Random, State};
use reference::{Reference, index};

/// Joints of a tree, moving or not; it has one link more.
pub const JOINTS: usize = 6;

/// A robot, twice.
#[derive(Clone, Debug)]
pub struct Tree {
    /// What goes through the generator.
    pub description: Description,
    /// What is asked for of it.
    pub request: Request,
    /// The values of the struct's fields.
    fields: Vec<[f64; 3]>,
    reference: Reference,
}

impl Tree {
    /// A tree in which something moves, and all that struct fields weigh.
    pub fn random(random: &mut Random) -> Self {
        loop {
            let grown = grow::grow(random);
            let reference = Reference::of(&grown.description, &grown.request, &grown.fields);
            let mut weighed =
                grown
                    .request
                    .parameters
                    .iter()
                    .filter_map(|field| match &field.target {
                        Target::MassOf(link) | Target::CenterOfMassOf(link) => {
                            Some(index(&link.text))
                        }
                        Target::OriginOf(_) | Target::Gravity => None,
                    });
            if reference.held.contains(&None) && weighed.all(|link| reference.moves(link)) {
                return Self {
                    description: grown.description,
                    request: grown.request,
                    fields: grown.fields,
                    reference,
                };
            }
        }
    }

    /// A state of the description's joints, in which held joints are where they are held.
    pub fn state(&self, random: &mut Random) -> State<f64, JOINTS> {
        let mut state = State::random(random);
        for (k, held) in self.reference.held.iter().enumerate() {
            if let Some(held) = held {
                (state.q[k], state.qd[k], state.qdd[k]) = (*held, 0.0, 0.0);
            }
        }
        state
    }

    /// What a program of the tree's chain reads at a state.
    #[must_use]
    pub fn input(&self, chain: &Chain, state: &State<f64, JOINTS>, input: Input) -> f64 {
        let joint = |k: u16| index(&chain.joints[usize::from(k)].name);
        match input {
            Input::Q(k) => state.q[joint(k)],
            Input::Qd(k) => state.qd[joint(k)],
            // Torques of forward dynamics, for which any number will do.
            Input::Qdd(k) | Input::Tau(k) => state.qdd[joint(k)],
            Input::Parameter(field, entry) => self.fields[usize::from(field)][usize::from(entry)],
        }
    }

    /// What a function of the tree's chain should return, by the generic recursions.
    ///
    /// # Panics
    /// For functions that solve with the mass matrix: that of a random tree may be singular.
    #[must_use]
    pub fn expected(
        &self,
        chain: &Chain,
        function: Function,
        frame: usize,
        state: &State<f64, JOINTS>,
    ) -> Vec<f64> {
        let State { q, qd, qdd } = state;
        let robot = &self.reference.chain;
        let joints = chain.joints.iter();
        let moving: Vec<usize> = joints.map(|joint| index(&joint.name)).collect();
        let of_moving =
            |all: [f64; JOINTS]| -> Vec<f64> { moving.iter().map(|&k| all[k]).collect() };
        let columns = |all: [Screw<f64>; JOINTS]| -> Vec<f64> {
            let columns = moving.iter().map(|&k| [all[k].u(), all[k].b()]);
            columns.flatten().flatten().collect()
        };
        let frame = || {
            let body = self.reference.body(index(&chain.frames[frame].name));
            Frame::new("", body, Pose::identity())
        };
        match function {
            Function::ForwardKinematics => {
                rows(&generic::forward_kinematics(robot, &frame(), q).to_matrix())
            }
            Function::SpatialJacobian => columns(generic::spatial_jacobian(robot, &frame(), q)),
            Function::BodyJacobian => columns(generic::body_jacobian(robot, &frame(), q)),
            Function::GeometricJacobian => columns(generic::geometric_jacobian(robot, &frame(), q)),
            Function::Velocity => {
                let w = generic::velocity(robot, &frame(), q, qd);
                [w.omega(), w.v()].concat()
            }
            Function::Acceleration => {
                rows(&generic::acceleration(robot, &frame(), q, qd, qdd).to_matrix())
            }
            Function::InverseDynamics => of_moving(generic::inverse_dynamics(robot, q, qd, qdd)),
            Function::Gravity => of_moving(generic::gravity(robot, q)),
            Function::Bias => of_moving(generic::bias(robot, q, qd)),
            Function::MassMatrix => {
                let all = generic::mass_matrix(robot, q);
                moving.iter().flat_map(|&row| of_moving(all[row])).collect()
            }
            Function::ForwardDynamics | Function::MassMatrixInverse => {
                panic!("the mass matrix of a random tree may be singular")
            }
        }
    }
}

/// The upper three rows.
fn rows(matrix: &[[f64; 4]; 4]) -> Vec<f64> {
    matrix[..3].as_flattened().to_vec()
}

/// What one needs to rebuild a tree that failed by hand.
impl fmt::Display for Tree {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let numbers = |numbers: &[Number]| {
            let numbers: Vec<String> = numbers.iter().map(|x| x.value.to_string()).collect();
            numbers.join(", ")
        };
        let steps = |steps: &[Step]| {
            let steps = steps.iter().map(|step| match step {
                Step::Translate(offset) => format!("xyz({})", numbers(offset)),
                Step::Rotate(axis, angle) => format!("{axis:?}({})", angle.value),
            });
            steps.collect::<Vec<_>>().join(" ")
        };
        for joint in &self.description.joints {
            let (name, axis, at) = (&joint.name.text, numbers(&joint.axis), steps(&joint.origin));
            let [from, to] = [&joint.parent, &joint.child].map(|link| &link.text);
            let kind = match joint.kind {
                JointKind::Screw { pitch } => format!("Screw of pitch {}", pitch.value),
                kind => format!("{kind:?}"),
            };
            writeln!(out, "{name}: {kind}([{axis}]) from {from} to {to} at {at}")?;
        }
        for link in &self.description.links {
            let name = &link.name.text;
            match &link.inertial {
                Some(inertial) => {
                    let tensor = numbers(&inertial.inertia);
                    let at = steps(&inertial.origin);
                    let mass = inertial.mass.value;
                    writeln!(out, "{name}: {mass} kg, [{tensor}] at {at}")?;
                }
                None => writeln!(out, "{name}: nothing")?,
            }
        }
        let request = &self.request;
        let names = |names: &[Name]| -> Vec<String> {
            names.iter().map(|name| name.text.clone()).collect()
        };
        let locks = request.lock.iter();
        let locks: Vec<_> = locks
            .map(|(name, at)| (&name.text, at.map(|at| at.value)))
            .collect();
        let targets = request.parameters.iter().map(|field| match &field.target {
            Target::MassOf(of) => format!("mass_of {}", of.text),
            Target::CenterOfMassOf(of) => format!("com_of {}", of.text),
            Target::OriginOf(of) => format!("origin_of {}", of.text),
            Target::Gravity => "gravity".to_owned(),
        });
        let fields: Vec<_> = targets.zip(&self.fields).collect();
        let base = request.base.as_ref().map(|name| &name.text);
        let tip = request.tip.as_ref().map(|name| &name.text);
        writeln!(
            out,
            "base {base:?}, tip {tip:?}, frames {:?}",
            names(&request.frames)
        )?;
        writeln!(
            out,
            "drop {:?}, path_only {}",
            names(&request.drop),
            request.path_only
        )?;
        writeln!(out, "lock {locks:?}, fields {fields:?}")?;
        let gravity = request.gravity.map(|entries| numbers(&entries));
        writeln!(out, "gravity {gravity:?}")
    }
}
