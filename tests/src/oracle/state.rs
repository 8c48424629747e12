//! A state at 256 bits.
//!
//! In: arguments, and where quaternions stand among the coordinates. Out: the same numbers, with
//! quaternions of length 1 to the last of the 256 bits: none that `f64` holds is one, but for the trivial
//! ones, and two truths about a robot agree at those alone.

use homogen_codegen::expression::Input;
use homogen_codegen::space::Variable;

use crate::arguments::Arguments;
use crate::big::Big;

/// One value of every argument.
#[derive(Clone, Debug)]
pub struct State {
    /// Coordinates [rad or m, or 1].
    pub q: Vec<Big>,
    /// Velocities.
    pub qd: Vec<Big>,
    /// Accelerations.
    pub qdd: Vec<Big>,
    /// Torques and forces \[N m or N\].
    pub tau: Vec<Big>,
    /// Of each action from outside c and f \[N m, N\].
    pub actions: Vec<Big>,
}

impl State {
    /// The state that arguments stand for; a quaternion begins at each of the places given.
    #[must_use]
    pub fn of(arguments: &Arguments, quaternions: impl IntoIterator<Item = usize>) -> Self {
        let exact = |vector: &[f64]| -> Vec<Big> { vector.iter().map(|&x| Big::new(x)).collect() };
        let mut q = exact(&arguments.q);
        for start in quaternions {
            let quaternion = &mut q[start..start + 4];
            let square = quaternion.iter().fold(Big::zero(), |sum, x| sum + x * x);
            let length = square.sqrt();
            for entry in quaternion {
                *entry = &*entry / &length;
            }
        }
        Self {
            q,
            qd: exact(&arguments.qd),
            qdd: exact(&arguments.qdd),
            tau: exact(&arguments.tau),
            actions: exact(&arguments.actions),
        }
    }

    /// What a program reads under a name.
    ///
    /// # Panics
    /// For a struct field, and for an argument that no function here has.
    #[must_use]
    pub fn at(&self, input: Input) -> Big {
        let (list, entry) = match input {
            Input::Variable(Variable::Q, k) => (&self.q, k),
            Input::Variable(Variable::Qd, k) => (&self.qd, k),
            Input::Variable(Variable::Qdd, k) => (&self.qdd, k),
            Input::Variable(Variable::Tau, k) => (&self.tau, k),
            Input::Variable(Variable::Actions, k) => (&self.actions, k),
            other => panic!("no function here has {other:?}"),
        };
        list[usize::from(entry)].clone()
    }
}
