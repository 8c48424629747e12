//! The numbers of a chain in 106 bits.
//!
//! In: a chain, whose fields have their values in the description. Out: placements, screws, inertias and
//! terms of actuators.

use super::blocks::LinkId;
use crate::chain::{BodyId, Chain, Joint, Position};
use crate::dense::Matrix;
use crate::expression::{Double, Evaluation, Expr, Input, Term};
use crate::list::List;

/// Number of inertial parameters of a link.
pub(super) const MOMENTS: usize = 10;

/// Their places in J: m; q_x, q_y, q_z; J_xx, J_xy, J_xz, J_yy, J_yz, J_zz.
pub(super) const PLACES: [(usize, usize); MOMENTS] = [
    (3, 3),
    (0, 3),
    (1, 3),
    (2, 3),
    (0, 0),
    (0, 1),
    (0, 2),
    (1, 1),
    (1, 2),
    (2, 2),
];

/// Number of parameters of a joint's actuator: armature, damping and friction.
pub(super) const ACTUATOR: usize = 3;

/// The numbers of a chain.
pub(super) struct Numbers {
    /// M of each joint's frame in the parent body's, at q = 0.
    pub(super) placements: List<BodyId, Matrix<Double>>,
    /// u and b of each joint.
    pub(super) screws: List<BodyId, [[Double; 3]; 2]>,
    /// Multiplier of each joint's coordinate and velocity.
    pub(super) factors: List<BodyId, Double>,
    /// M of each link in the frame of its body.
    pub(super) links: List<LinkId, Matrix<Double>>,
    /// J of each link, in its own frame.
    pub(super) inertias: List<LinkId, Matrix<Double>>,
    /// Armature, damping and friction of each joint.
    pub(super) actuators: List<BodyId, [Double; ACTUATOR]>,
    /// Acceleration of gravity in frame 0 [m/s²].
    pub(super) gravity: [Double; 3],
}

impl Numbers {
    pub(super) fn of(chain: &Chain) -> Self {
        let described = |input| match input {
            Input::Parameter(field, entry) => {
                Double::from(chain.nominal[field.into()][usize::from(entry)])
            }
            Input::Variable(..) => unreachable!("a chain depends on no state"),
        };
        let numbers = |exprs: &[Expr]| Evaluation::<Double>::of(&chain.graph, exprs).at(described);
        let array = |exprs: [Expr; 3]| -> [Double; 3] {
            let found = numbers(&exprs);
            [0, 1, 2].map(|k| found[k])
        };
        let screw = |joint: &Joint| {
            let entries = chain.screw(joint).map(Term::expr);
            let found = numbers(&entries);
            [0, 3].map(|first| [0, 1, 2].map(|k| found[first + k]))
        };
        let factor = |joint: &Joint| match joint.position {
            Position::Along { factor, .. } => numbers(&[factor])[0],
            Position::Manifold(..) | Position::Taken => Double::from(1.0),
        };
        let bodies = || chain.joints.iter();
        let of_links = || bodies().filter_map(|joint| Some((joint, &joint.link.as_ref()?.1)));
        let links = of_links().map(|(_, pose)| placement(&numbers(&pose.entries())));
        let links: List<LinkId, Matrix<Double>> = links.collect();
        let inertias = of_links().zip(&links).map(|((joint, _), link)| {
            let [xx, yy, zz, xy, xz, yz, x, y, z, m] = joint.inertia.entries();
            let rows = [xx, xy, xz, x, xy, yy, yz, y, xz, yz, zz, z, x, y, z, m];
            let rows = numbers(&rows);
            let j = Matrix([0, 4, 8, 12].map(|row| [0, 1, 2, 3].map(|column| rows[row + column])));
            let back = link.inverse();
            back.times(&j).times(&back.transposed())
        });
        Self {
            placements: bodies()
                .map(|joint| placement(&numbers(&joint.placement.entries())))
                .collect(),
            screws: bodies().map(screw).collect(),
            factors: bodies().map(factor).collect(),
            inertias: inertias.collect(),
            links,
            actuators: bodies()
                .map(|joint| array(joint.actuator.entries()))
                .collect(),
            gravity: array(chain.gravity.0),
        }
    }

    /// A length of the robot \[m\]: the longest offset between the frames of joints and links; 1 m if all are zero.
    pub(super) fn length(&self, chain: &Chain) -> f64 {
        let joints = chain.joints.iter().zip(&self.placements);
        // The distance of the robot from frame 0 is left out.
        let joints = joints.filter_map(|(joint, placement)| joint.parent.map(|_| placement));
        let offsets = joints.chain(&self.links).map(|pose| norm(&pose.column()));
        let longest = offsets.fold(0.0, f64::max);
        if longest > 0.0 { longest } else { 1.0 }
    }
}

/// The length of a vector.
pub(super) fn norm(vector: &[Double]) -> f64 {
    let squares = vector.iter().map(|x| x.to_f64() * x.to_f64());
    squares.sum::<f64>().sqrt()
}

fn placement(entries: &[Double]) -> Matrix<Double> {
    let mut placement = Matrix::identity();
    for (row, entries) in placement.0.iter_mut().zip(entries.chunks(4)) {
        row.copy_from_slice(entries);
    }
    placement
}
