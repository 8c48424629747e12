//! Every function as Part II of the paper writes it: dense 4×4 matrices in frame 0, at 256 bits.
//!
//! In: a robot in matrices and the arguments. Out: what the function should return. No matrix is
//! taken apart and no zero is known: this is the definition, and therefore slow (about 1 ms a
//! joint).

use homogen_codegen::Function;

use super::matrix::Matrix;
use super::robot::{Coordinate, Robot};
use super::solve::solve;
use crate::arguments::Arguments;
use crate::big::Big;

/// Every function that is told here: of a base regressor, the selection of columns is the engine's own.
pub fn told() -> impl Iterator<Item = Function> {
    let all = Function::ALL.into_iter();
    all.filter(|&function| function != Function::BaseRegressor)
}

/// What a function returns; of the frame of that index where it is of one.
///
/// # Panics
/// Where a frame is asked for that is not there, the mass matrix is singular and asked to be inverted, or
/// a function has no oracle.
#[must_use]
pub fn evaluate(
    robot: &Robot,
    function: Function,
    frame: usize,
    arguments: &Arguments,
) -> Vec<Big> {
    let of = |vector: &[f64]| -> Vec<Big> { vector.iter().map(|&x| Big::new(x)).collect() };
    let rest = vec![Big::zero(); robot.joints()];
    let positions = Positions::at(robot, &of(&arguments.q));
    let moving = |qd: &[Big], qdd: &[Big]| Motion::at(robot, &positions, qd, qdd);
    let bias = || torques(robot, &positions, &moving(&of(&arguments.qd), &rest));
    let at = || robot.frames[frame];
    match function {
        Function::ForwardKinematics => positions.of_frame(at()).rows(),
        Function::SpatialJacobian => jacobian(robot, &positions, at(), &Matrix::identity()),
        Function::BodyJacobian => {
            jacobian(robot, &positions, at(), &positions.of_frame(at()).inverse())
        }
        Function::GeometricJacobian => {
            let tip = positions.of_frame(at()).column().map(|entry| -entry);
            jacobian(robot, &positions, at(), &Matrix::translation(&tip))
        }
        Function::SpatialJacobianRate => {
            let motion = moving(&of(&arguments.qd), &rest);
            let still = Matrix::zero();
            jacobian_rate(
                robot,
                &positions,
                &motion,
                at(),
                (&Matrix::identity(), &still),
            )
        }
        Function::BodyJacobianRate => {
            let motion = moving(&of(&arguments.qd), &rest);
            let back = positions.of_frame(at()).inverse();
            jacobian_rate(
                robot,
                &positions,
                &motion,
                at(),
                (&back, &motion.w_of(at())),
            )
        }
        Function::GeometricJacobianRate => {
            let motion = moving(&of(&arguments.qd), &rest);
            let tip = positions.of_frame(at()).column();
            let rate = (&motion.w_of(at()) * &Matrix::translation(&tip)).column();
            let of_pole = Matrix::screw(&[(); 3].map(|()| Big::zero()), &rate);
            let back = Matrix::translation(&tip.map(|entry| -entry));
            jacobian_rate(robot, &positions, &motion, at(), (&back, &of_pole))
        }
        Function::AccelerationBias => moving(&of(&arguments.qd), &rest).h_of(at()).rows(),
        Function::Velocity => {
            let w = moving(&of(&arguments.qd), &rest).w_of(at());
            [w.vector(), w.column()].concat()
        }
        Function::Acceleration => {
            let motion = moving(&of(&arguments.qd), &of(&arguments.qdd));
            motion.h_of(at()).rows()
        }
        Function::InverseDynamics => {
            let motion = moving(&of(&arguments.qd), &of(&arguments.qdd));
            torques(robot, &positions, &motion)
        }
        Function::Gravity => torques(robot, &positions, &moving(&rest, &rest)),
        Function::Bias => bias(),
        Function::MassMatrix => mass_matrix(robot, &positions).concat(),
        Function::ForwardDynamics => {
            let tau = of(&arguments.tau).into_iter().zip(bias());
            let lacking = tau.map(|(tau, bias)| vec![tau - bias]).collect();
            solve(mass_matrix(robot, &positions), lacking).concat()
        }
        Function::MassMatrixInverse => {
            let unit =
                |i: usize| (0..rest.len()).map(move |j| Big::new(f64::from(u8::from(i == j))));
            let identity = (0..rest.len()).map(|i| unit(i).collect()).collect();
            solve(mass_matrix(robot, &positions), identity).concat()
        }
        Function::KineticEnergy => {
            let motion = moving(&of(&arguments.qd), &rest);
            let links = motion.w.iter().zip(&positions.j);
            let energies = links.map(|(w, j)| (&(w * j) * &w.transposed()).trace());
            vec![energies.fold(Big::zero(), |sum, energy| sum + energy) * Big::new(0.5)]
        }
        Function::PotentialEnergy => {
            let links = moved(robot).map(|body| &positions.j[body]);
            let energies = links.map(|j| (&robot.gravity * j).trace());
            vec![energies.fold(Big::zero(), |sum, energy| sum - energy)]
        }
        Function::Regressor => {
            let motion = moving(&of(&arguments.qd), &of(&arguments.qdd));
            regressor(robot, &positions, &motion)
        }
        Function::CenterOfMass => mass_center(robot, &positions).to_vec(),
        Function::CenterOfMassVelocity => {
            let motion = moving(&of(&arguments.qd), &rest);
            by_mass(robot, &positions, &moments(robot, &positions, &motion.w))
        }
        Function::CenterOfMassJacobian => unit_motions(robot, &positions)
            .flat_map(|motion| by_mass(robot, &positions, &moments(robot, &positions, &motion.w)))
            .collect(),
        Function::Momentum => {
            let motion = moving(&of(&arguments.qd), &rest);
            let moments = moments(robot, &positions, &motion.w);
            let gamma = &moments - &moments.transposed();
            [gamma.vector(), gamma.column()].concat()
        }
        Function::CentroidalMomentum => {
            let motion = moving(&of(&arguments.qd), &rest);
            about_mass_center(robot, &positions, &moments(robot, &positions, &motion.w))
        }
        Function::CentroidalMomentumMatrix => unit_motions(robot, &positions)
            .flat_map(|motion| {
                let moments = moments(robot, &positions, &motion.w);
                about_mass_center(robot, &positions, &moments)
            })
            .collect(),
        Function::CentroidalMomentumBias => {
            let motion = moving(&of(&arguments.qd), &rest);
            about_mass_center(robot, &positions, &moments(robot, &positions, &motion.h))
        }
        other => panic!("{} has no oracle", other.name()),
    }
}

/// Y of τ = Y π, row by row: of each link that a coordinate moves ten columns, which are the torques of
/// Φ = skew[(H − H_g) J] of a J that is 1 in one place and its mirror image.
fn regressor(robot: &Robot, positions: &Positions, motion: &Motion) -> Vec<Big> {
    let first = [(3, 3), (0, 3), (1, 3), (2, 3)];
    let second = [(0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)];
    let units = first.into_iter().chain(second).map(|(row, column)| {
        let is = |i, j| (i, j) == (row, column) || (j, i) == (row, column);
        Matrix::of(|i, j| Big::new(f64::from(u8::from(is(i, j)))))
    });
    let units: Vec<Matrix> = units.collect();
    let links = moving(robot).filter(|&body| robot.bodies[body].link);
    let columns = links.flat_map(|body| {
        let h = &motion.h[body] - &robot.gravity;
        let m = &positions.m[body];
        units.iter().map(move |unit| {
            let j = &(m * unit) * &m.transposed();
            let moved = &h * &j;
            (body, &moved - &moved.transposed())
        })
    });
    let columns: Vec<(usize, Matrix)> = columns.collect();
    let rows = moving(robot).flat_map(|joint| {
        columns.iter().map(move |(body, action)| {
            let feels = robot.upwards(Some(*body)).any(|carrier| carrier == joint);
            if feels {
                pseudo_product(&positions.l[joint], action)
            } else {
                Big::zero()
            }
        })
    });
    rows.collect()
}

/// The bodies that a joint moves: what none moves is not the robot's.
fn moved(robot: &Robot) -> impl Iterator<Item = usize> {
    let mut moves: Vec<bool> = Vec::new();
    for body in &robot.bodies {
        let carried = body.parent.is_some_and(|parent| moves[parent]);
        moves.push(carried || matches!(body.coordinate, Coordinate::Free(_)));
    }
    let bodies = moves.into_iter().enumerate();
    bodies.filter_map(|(body, moves)| moves.then_some(body))
}

/// What the bodies that joints move weigh together \[kg\].
#[must_use]
pub fn mass(robot: &Robot) -> f64 {
    let masses = moved(robot).map(|body| robot.bodies[body].inertia.0[3][3].to_f64());
    masses.sum()
}

/// Σ J of what joints move.
fn inertia(robot: &Robot, positions: &Positions) -> Matrix {
    moved(robot).fold(Matrix::zero(), |sum, body| &sum + &positions.j[body])
}

/// Σ X J of what joints move, where X is W or H of each body.
fn moments(robot: &Robot, positions: &Positions, of: &[Matrix]) -> Matrix {
    moved(robot).fold(Matrix::zero(), |sum, body| {
        &sum + &(&of[body] * &positions.j[body])
    })
}

/// Where the mass has its centre: Σ J has the first moments and the mass in the last column.
fn mass_center(robot: &Robot, positions: &Positions) -> [Big; 3] {
    let inertia = inertia(robot, positions);
    inertia.column().map(|moment| moment / &inertia.0[3][3])
}

/// The velocity of the centre of mass by Σ W J.
fn by_mass(robot: &Robot, positions: &Positions, moments: &Matrix) -> Vec<Big> {
    let mass = &inertia(robot, positions).0[3][3];
    let column = moments.column();
    column.map(|momentum| momentum / mass).to_vec()
}

/// skew\[X\] with the centre of mass as pole.
fn about_mass_center(robot: &Robot, positions: &Positions, moments: &Matrix) -> Vec<Big> {
    let skew = moments - &moments.transposed();
    let back = Matrix::translation(&mass_center(robot, positions).map(|entry| -entry));
    let seen = &(&back * &skew) * &back.transposed();
    [seen.vector(), seen.column()].concat()
}

/// The motions at a unit rate of each joint alone.
fn unit_motions<'r>(
    robot: &'r Robot,
    positions: &'r Positions,
) -> impl Iterator<Item = Motion> + use<'r> {
    let rest = vec![Big::zero(); robot.joints()];
    (0..robot.joints()).map(move |k| {
        let mut unit = rest.clone();
        unit[k] = Big::one();
        Motion::at(robot, positions, &unit, &rest)
    })
}

/// What depends on q alone, in frame 0.
struct Positions {
    /// M₀ᵢ.
    m: Vec<Matrix>,
    /// Lᵢ₍₀₎.
    l: Vec<Matrix>,
    /// Jᵢ₍₀₎.
    j: Vec<Matrix>,
}

impl Positions {
    fn at(robot: &Robot, q: &[Big]) -> Self {
        let mut positions = Self {
            m: Vec::new(),
            l: Vec::new(),
            j: Vec::new(),
        };
        for body in &robot.bodies {
            let at = match &body.coordinate {
                Coordinate::Free(index) => &q[*index],
                Coordinate::Held(at) => at,
            };
            let placed = &positions.of_frame(body.parent) * &body.placement;
            let m = &placed * &exponential(&body.screw, at);
            let l = &(&m * &body.screw) * &m.inverse();
            let j = &(&m * &body.inertia) * &m.transposed();
            positions.m.push(m);
            positions.l.push(l);
            positions.j.push(j);
        }
        positions
    }

    fn of_frame(&self, body: Option<usize>) -> Matrix {
        body.map_or_else(Matrix::identity, |body| self.m[body].clone())
    }
}

/// What depends on the rates as well, in frame 0.
struct Motion {
    /// W₀ᵢ.
    w: Vec<Matrix>,
    /// H₀ᵢ.
    h: Vec<Matrix>,
}

impl Motion {
    /// W = L q̇ and H = L q̈ + L² q̇² of one joint, composed by (12) and (13).
    fn at(robot: &Robot, positions: &Positions, qd: &[Big], qdd: &[Big]) -> Self {
        let mut motion = Self {
            w: Vec::new(),
            h: Vec::new(),
        };
        for (body, l) in robot.bodies.iter().zip(&positions.l) {
            let (mut w, mut h) = (motion.w_of(body.parent), motion.h_of(body.parent));
            if let Coordinate::Free(index) = body.coordinate {
                let (rate, second) = (&qd[index], &qdd[index]);
                let of_joint = l.times(rate);
                let drift = &(&w * &of_joint).times(&Big::new(2.0)) + &(&of_joint * &of_joint);
                h = &(&h + &l.times(second)) + &drift;
                w = &w + &of_joint;
            }
            motion.w.push(w);
            motion.h.push(h);
        }
        motion
    }

    fn w_of(&self, body: Option<usize>) -> Matrix {
        body.map_or_else(Matrix::zero, |body| self.w[body].clone())
    }

    fn h_of(&self, body: Option<usize>) -> Matrix {
        body.map_or_else(Matrix::zero, |body| self.h[body].clone())
    }
}

/// Q = 1 + L φ + L² (1 − cos φ) + L³ (φ − sin φ), the series of § 5 summed by u̲ⁿ⁺² = −u̲ⁿ.
fn exponential(l: &Matrix, phi: &Big) -> Matrix {
    let (sine, cosine) = phi.sin_cos();
    let square = l * l;
    let cube = &square * l;
    let linear = &Matrix::identity() + &l.times(phi);
    let quadratic = square.times(&(Big::one() - cosine));
    &(&linear + &quadratic) + &cube.times(&(phi - sine))
}

/// The bodies' matrices, each with those of all that hang on it.
fn carried(robot: &Robot, mut each: Vec<Matrix>) -> Vec<Matrix> {
    for (index, body) in robot.bodies.iter().enumerate().rev() {
        if let Some(parent) = body.parent {
            each[parent] = &each[parent] + &each[index];
        }
    }
    each
}

/// τ = L ⊗ Σ Φ over the bodies that the joint carries (Newton–Euler).
fn torques(robot: &Robot, positions: &Positions, motion: &Motion) -> Vec<Big> {
    let actions = carried(robot, actions(robot, positions, motion).collect());
    moving(robot)
        .map(|body| pseudo_product(&positions.l[body], &actions[body]))
        .collect()
}

/// For each joint, the sum of the sizes of what the bodies it carries ask of it: |u| times the couple of
/// each body's Φ about the joint's origin, and |b| times its force.
///
/// It measures rounding where S cannot: S of a long chain grows as the product of |sin| + |cos| of all
/// its angles, which no sum of torques does.
#[must_use]
pub fn torque_sizes(robot: &Robot, arguments: &Arguments) -> Vec<f64> {
    let of = |vector: &[f64]| -> Vec<Big> { vector.iter().map(|&x| Big::new(x)).collect() };
    let positions = Positions::at(robot, &of(&arguments.q));
    let motion = Motion::at(robot, &positions, &of(&arguments.qd), &of(&arguments.qdd));
    // A measure needs no more than `f64`: of Φ the couple and the force, of L the direction and the
    // rest, about the origin of frame 0.
    let parts = |matrix: &Matrix| {
        [matrix.vector(), matrix.column()].map(|vector| vector.map(|x| x.to_f64()))
    };
    let actions: Vec<_> = actions(robot, &positions, &motion)
        .map(|action| parts(&action))
        .collect();
    let asked = |joint: usize, body: usize| {
        let origin = positions.m[joint].column().map(|x| x.to_f64());
        let ([u, b], [c, f]) = (parts(&positions.l[joint]), actions[body]);
        // About the joint's origin: b + u × o, c − o × f.
        let (b, c) = (sum(b, cross(u, origin)), sum(c, cross(f, origin)));
        length(u) * length(c) + length(b) * length(f)
    };
    moving(robot)
        .map(|joint| {
            let bodies = (joint..actions.len())
                .filter(|&body| robot.upwards(Some(body)).any(|carrier| carrier == joint));
            bodies.map(|body| asked(joint, body)).sum()
        })
        .collect()
}

fn cross([x, y, z]: [f64; 3], [a, b, c]: [f64; 3]) -> [f64; 3] {
    [y * c - z * b, z * a - x * c, x * b - y * a]
}

fn sum(x: [f64; 3], y: [f64; 3]) -> [f64; 3] {
    core::array::from_fn(|k| x[k] + y[k])
}

fn length(x: [f64; 3]) -> f64 {
    x.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// Φ = skew[(H − H_g) J] of each body.
fn actions(robot: &Robot, positions: &Positions, motion: &Motion) -> impl Iterator<Item = Matrix> {
    motion.h.iter().zip(&positions.j).map(|(h, j)| {
        let moved = &(h - &robot.gravity) * j;
        &moved - &moved.transposed()
    })
}

/// L ⊗ Φ = u · c + b · f.
fn pseudo_product(l: &Matrix, phi: &Matrix) -> Big {
    let dot = |x: [Big; 3], y: [Big; 3]| {
        let pairs = x.into_iter().zip(y);
        pairs.fold(Big::zero(), |sum, (x, y)| sum + x * y)
    };
    dot(l.vector(), phi.vector()) + dot(l.column(), phi.column())
}

/// M\[i\]\[m\] = Tr(Lᵢ Σ J Lₘᵗ), over the bodies that both joints carry (Lagrange).
fn mass_matrix(robot: &Robot, positions: &Positions) -> Vec<Vec<Big>> {
    let inertias = carried(robot, positions.j.clone());
    let entry = |i: usize, m: usize| {
        let carries =
            |outer: usize, inner: usize| robot.upwards(Some(outer)).any(|body| body == inner);
        let outermost = if carries(i, m) {
            i
        } else if carries(m, i) {
            m
        } else {
            return Big::zero();
        };
        let product = &positions.l[i] * &inertias[outermost];
        (&product * &positions.l[m].transposed()).trace()
    };
    moving(robot)
        .map(|i| moving(robot).map(|m| entry(i, m)).collect())
        .collect()
}

/// The columns M L₍₀₎ M⁻¹; null for the joints that do not move the frame.
fn jacobian(robot: &Robot, positions: &Positions, frame: Option<usize>, m: &Matrix) -> Vec<Big> {
    let moves = |joint: usize| robot.upwards(frame).any(|body| body == joint);
    let columns = moving(robot).map(|joint| {
        if moves(joint) {
            let l = &(m * &positions.l[joint]) * &m.inverse();
            [l.vector(), l.column()].concat()
        } else {
            vec![Big::zero(); 6]
        }
    });
    columns.flatten().collect()
}

/// The rates of the columns M L₍₀₎ M⁻¹, of a frame that moves by M and W: M (V L − L V) M⁻¹ where V is the
/// velocity of the body less W; null for the joints that do not move the frame.
fn jacobian_rate(
    robot: &Robot,
    positions: &Positions,
    motion: &Motion,
    frame: Option<usize>,
    (m, w): (&Matrix, &Matrix),
) -> Vec<Big> {
    let moves = |joint: usize| robot.upwards(frame).any(|body| body == joint);
    let columns = moving(robot).map(|joint| {
        if moves(joint) {
            let (v, l) = (&motion.w[joint] - w, &positions.l[joint]);
            let rate = &(&v * l) - &(l * &v);
            let seen = &(m * &rate) * &m.inverse();
            [seen.vector(), seen.column()].concat()
        } else {
            vec![Big::zero(); 6]
        }
    });
    columns.flatten().collect()
}

/// The bodies whose joints move, in the order of q.
fn moving(robot: &Robot) -> impl Iterator<Item = usize> {
    let bodies = robot.bodies.iter().enumerate();
    bodies
        .filter(|(_, body)| matches!(body.coordinate, Coordinate::Free(_)))
        .map(|(index, _)| index)
}
