//! Every function as Part II of the paper writes it: dense 4×4 matrices in frame 0, at 256 bits.
//!
//! In: a robot in matrices and the arguments, whose quaternions are taken with length 1. Out: what the
//! function should return. No matrix is taken apart and no zero is known: this is the definition, and
//! therefore slow (about 1 ms a joint).

mod closure;
mod derivatives;

use homogen_codegen::Function;

use super::matrix::Matrix;
use super::robot::Robot;
use super::solve::solve;
use super::state::State;
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
#[expect(
    clippy::too_many_lines,
    reason = "one arm for each function, which is its definition"
)]
pub fn evaluate(
    robot: &Robot,
    function: Function,
    frame: usize,
    arguments: &Arguments,
) -> Vec<Big> {
    let State {
        q, qd, qdd, tau, ..
    } = State::of(arguments, robot.quaternions());
    let rest = vec![Big::zero(); robot.velocities()];
    let positions = Positions::at(robot, &q);
    let moving = |qd: &[Big], qdd: &[Big]| Motion::at(robot, &positions, qd, qdd);
    let bias = || torques(robot, &positions, &moving(&qd, &rest));
    let at = || robot.frames[frame];
    let less_outside = |torques: Vec<Big>| {
        let outside = outside(robot, &positions, &arguments.actions);
        let both = torques.into_iter().zip(outside);
        both.map(|(torque, outside)| torque - outside)
            .collect::<Vec<Big>>()
    };
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
            let motion = moving(&qd, &rest);
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
            let motion = moving(&qd, &rest);
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
            let motion = moving(&qd, &rest);
            let tip = positions.of_frame(at()).column();
            let rate = (&motion.w_of(at()) * &Matrix::translation(&tip)).column();
            let of_pole = Matrix::screw(&[(); 3].map(|()| Big::zero()), &rate);
            let back = Matrix::translation(&tip.map(|entry| -entry));
            jacobian_rate(robot, &positions, &motion, at(), (&back, &of_pole))
        }
        Function::AccelerationBias => moving(&qd, &rest).h_of(at()).rows(),
        Function::Velocity => {
            let w = moving(&qd, &rest).w_of(at());
            [w.vector(), w.column()].concat()
        }
        Function::Acceleration => {
            let motion = moving(&qd, &qdd);
            motion.h_of(at()).rows()
        }
        Function::InverseDynamics => {
            let motion = moving(&qd, &qdd);
            less_outside(torques(robot, &positions, &motion))
        }
        Function::Gravity => torques(robot, &positions, &moving(&rest, &rest)),
        Function::Bias => bias(),
        Function::MassMatrix => mass_matrix(robot, &positions).concat(),
        Function::ForwardDynamics => {
            let tau = tau.into_iter().zip(less_outside(bias()));
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
            let motion = moving(&qd, &rest);
            let links = motion.w.iter().zip(&positions.j);
            let energies = links.map(|(w, j)| (&(w * j) * &w.transposed()).trace());
            let drives = robot.drives.iter();
            let drives = drives.map(|drive| {
                let rate = &qd[drive.velocity];
                drive.armature() * rate * rate
            });
            let twice = energies.chain(drives);
            vec![twice.fold(Big::zero(), |sum, energy| sum + energy) * Big::new(0.5)]
        }
        Function::PotentialEnergy => {
            let links = moved(robot).map(|body| &positions.j[body]);
            let energies = links.map(|j| (&robot.gravity * j).trace());
            vec![energies.fold(Big::zero(), |sum, energy| sum - energy)]
        }
        Function::Regressor => {
            let motion = moving(&qd, &qdd);
            let of_links = regressor(robot, &positions, &motion);
            with_columns_of_drives(robot, of_links, [&qd, &qdd])
        }
        Function::CenterOfMass => mass_center(robot, &positions).to_vec(),
        Function::CenterOfMassVelocity => {
            let motion = moving(&qd, &rest);
            by_mass(robot, &positions, &moments(robot, &positions, &motion.w))
        }
        Function::CenterOfMassJacobian => unit_motions(robot, &positions)
            .flat_map(|motion| by_mass(robot, &positions, &moments(robot, &positions, &motion.w)))
            .collect(),
        Function::Momentum => {
            let motion = moving(&qd, &rest);
            let moments = moments(robot, &positions, &motion.w);
            let gamma = &moments - &moments.transposed();
            [gamma.vector(), gamma.column()].concat()
        }
        Function::CentroidalMomentum => {
            let motion = moving(&qd, &rest);
            about_mass_center(robot, &positions, &moments(robot, &positions, &motion.w))
        }
        Function::CentroidalMomentumMatrix => unit_motions(robot, &positions)
            .flat_map(|motion| {
                let moments = moments(robot, &positions, &motion.w);
                about_mass_center(robot, &positions, &moments)
            })
            .collect(),
        Function::CentroidalMomentumBias => {
            let motion = moving(&qd, &rest);
            about_mass_center(robot, &positions, &moments(robot, &positions, &motion.h))
        }
        Function::InverseDynamicsDerivatives => {
            derivatives::of_torques(robot, &positions, [&qd, &qdd], &arguments.actions).concat()
        }
        Function::ForwardDynamicsDerivatives => {
            let qdd = evaluate(robot, Function::ForwardDynamics, frame, arguments);
            let motion = [&*qd, &*qdd];
            let found = derivatives::of_torques(robot, &positions, motion, &arguments.actions).map(
                |needed| {
                    let rows = needed.chunks(rest.len().max(1));
                    let lacking = rows.map(|row| row.iter().map(|entry| -entry).collect());
                    solve(mass_matrix(robot, &positions), lacking.collect()).concat()
                },
            );
            let dtau = evaluate(robot, Function::MassMatrixInverse, frame, arguments);
            [found.concat(), dtau].concat()
        }
        Function::GravityDerivative => {
            derivatives::by_coordinate(robot, &positions, [&rest, &rest], &[])
        }
        Function::CoriolisMatrix => {
            let motion = moving(&qd, &rest);
            derivatives::coriolis(robot, &positions, &motion)
        }
        Function::Constraint => closure::residuals(robot, &positions),
        Function::ConstraintJacobian => closure::jacobian(robot, &positions),
        Function::ConstraintBias => closure::bias(robot, &positions, &moving(&qd, &rest)),
        Function::ConstrainedForwardDynamics => {
            let tau = tau.into_iter().zip(bias());
            let (matrix, right) = closure::system(
                &mass_matrix(robot, &positions),
                tau.map(|(tau, bias)| tau - bias).collect(),
                &closure::jacobian(robot, &positions),
                &closure::bias(robot, &positions, &moving(&qd, &rest)),
            );
            solve(matrix, right).concat()
        }
        other => panic!("{} has no oracle", other.name()),
    }
}

/// Y of τ = Y π, row by row: of each link that a joint moves ten columns, which are the torques of
/// Φ = skew[(H − H_g) J] of a J that is 1 in one place and its mirror image.
fn regressor(robot: &Robot, positions: &Positions, motion: &Motion) -> Vec<Big> {
    let first = [(3, 3), (0, 3), (1, 3), (2, 3)];
    let second = [(0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)];
    let units = first.into_iter().chain(second).map(|(row, column)| {
        let is = |i, j| (i, j) == (row, column) || (j, i) == (row, column);
        Matrix::of(|i, j| Big::new(f64::from(u8::from(is(i, j)))))
    });
    let units: Vec<Matrix> = units.collect();
    let links = (0..robot.bodies.len()).filter(|&body| robot.bodies[body].link);
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
    let row = |velocity: usize| {
        let freedoms = positions
            .freedoms
            .iter()
            .filter(move |one| one.velocity == velocity);
        let freedoms: Vec<&Freedom> = freedoms.collect();
        let entries = columns.iter().map(|(body, action)| {
            let feels = |one: &&&Freedom| {
                robot
                    .upwards(Some(*body))
                    .any(|carrier| carrier == one.body)
            };
            let felt = freedoms.iter().filter(feels);
            felt.fold(Big::zero(), |sum, one| sum + pseudo_product(&one.l, action))
        });
        entries.collect::<Vec<Big>>()
    };
    (0..robot.velocities()).flat_map(row).collect()
}

/// Rows of a regressor, with three columns behind them for each velocity of a joint where drives are identified.
fn with_columns_of_drives(robot: &Robot, of_links: Vec<Big>, [qd, qdd]: [&[Big]; 2]) -> Vec<Big> {
    if !robot.identifies_drives {
        return of_links;
    }
    let columns = robot.drives.iter().flat_map(|drive| {
        let columns = drive.columns(qd, qdd).into_iter();
        columns.map(|column| (drive.velocity, column))
    });
    let columns: Vec<(usize, Big)> = columns.collect();
    let rows = of_links
        .chunks(of_links.len() / qd.len().max(1))
        .enumerate();
    let rows = rows.flat_map(|(row, of_links)| {
        let of_drives = columns.iter().map(move |(velocity, column)| {
            if *velocity == row {
                column.clone()
            } else {
                Big::zero()
            }
        });
        of_links.iter().cloned().chain(of_drives)
    });
    rows.collect()
}

/// The bodies that a joint moves: what none moves is not the robot's.
fn moved(robot: &Robot) -> impl Iterator<Item = usize> {
    let mut moves: Vec<bool> = Vec::new();
    for body in &robot.bodies {
        let carried = body.parent.is_some_and(|parent| moves[parent]);
        moves.push(carried || body.motion.moves());
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
    let rest = vec![Big::zero(); robot.velocities()];
    (0..robot.velocities()).map(move |k| {
        let mut unit = rest.clone();
        unit[k] = Big::one();
        Motion::at(robot, positions, &unit, &rest)
    })
}

/// What depends on q alone, in frame 0.
struct Positions {
    /// M₀ᵢ.
    m: Vec<Matrix>,
    /// Jᵢ₍₀₎.
    j: Vec<Matrix>,
    /// What each velocity moves: several bodies, where joints follow others.
    freedoms: Vec<Freedom>,
}

/// What a velocity does to a body, and to all that it carries.
struct Freedom {
    /// The body.
    body: usize,
    /// The place of the velocity.
    velocity: usize,
    /// L₍₀₎.
    l: Matrix,
}

impl Positions {
    fn at(robot: &Robot, q: &[Big]) -> Self {
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
    fn of_body(&self, body: usize) -> impl Iterator<Item = &Freedom> {
        let all = self.freedoms.iter();
        all.filter(move |freedom| freedom.body == body)
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
    /// What drives take of the torque of each velocity.
    driven: Vec<Big>,
}

impl Motion {
    /// W = Σ L q̇ and H = Σ L q̈ + W² of one joint, whose screws are constant in the frame of the moved
    /// body; composed by (12) and (13).
    fn at(robot: &Robot, positions: &Positions, qd: &[Big], qdd: &[Big]) -> Self {
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

    fn w_of(&self, body: Option<usize>) -> Matrix {
        body.map_or_else(Matrix::zero, |body| self.w[body].clone())
    }

    fn h_of(&self, body: Option<usize>) -> Matrix {
        body.map_or_else(Matrix::zero, |body| self.h[body].clone())
    }
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

/// τ = Σ L ⊗ Σ Φ: over what a velocity moves, of the bodies that that carries (Newton–Euler); and what
/// drives take.
fn torques(robot: &Robot, positions: &Positions, motion: &Motion) -> Vec<Big> {
    let actions = carried(robot, actions(robot, positions, motion).collect());
    let mut torques = motion.driven.clone();
    for Freedom { body, velocity, l } in &positions.freedoms {
        let torque = pseudo_product(l, &actions[*body]);
        torques[*velocity] = &torques[*velocity] + torque;
    }
    torques
}

/// Σ L ⊗ Φ of the actions from outside, over what a velocity moves, where it carries what is acted on.
fn outside(robot: &Robot, positions: &Positions, actions: &[f64]) -> Vec<Big> {
    let mut torques = vec![Big::zero(); robot.velocities()];
    let (bodies, in_frame_0) = &robot.external;
    for (&acted, entries) in bodies.iter().zip(actions.chunks(6)) {
        let [c, f] = [0, 3].map(|first| [0, 1, 2].map(|k| Big::new(entries[first + k])));
        let mut phi = Matrix::screw(&c, &f);
        for (entry, of_force) in phi.0[3].iter_mut().zip(&f) {
            *entry = -of_force;
        }
        if !in_frame_0 {
            let m = &positions.m[acted];
            phi = &(m * &phi) * &m.transposed();
        }
        for Freedom { body, velocity, l } in &positions.freedoms {
            if robot.upwards(Some(acted)).any(|carrier| carrier == *body) {
                let torque = pseudo_product(l, &phi);
                torques[*velocity] = &torques[*velocity] + torque;
            }
        }
    }
    torques
}

/// For each velocity, the sum of the sizes of what the bodies it moves ask of it: |u| times the couple of
/// each body's Φ about the joint's origin, and |b| times its force.
///
/// It measures rounding where S cannot: S of a long chain grows as the product of |sin| + |cos| of all
/// its angles, which no sum of torques does.
#[must_use]
pub fn torque_sizes(robot: &Robot, arguments: &Arguments) -> Vec<f64> {
    let State { q, qd, qdd, .. } = State::of(arguments, robot.quaternions());
    let positions = Positions::at(robot, &q);
    let motion = Motion::at(robot, &positions, &qd, &qdd);
    // A measure needs no more than `f64`: of Φ the couple and the force, of L the direction and the
    // rest, about the origin of frame 0.
    let parts = |matrix: &Matrix| {
        [matrix.vector(), matrix.column()].map(|vector| vector.map(|x| x.to_f64()))
    };
    let actions: Vec<_> = actions(robot, &positions, &motion)
        .map(|action| parts(&action))
        .collect();
    let asked = |freedom: &Freedom, body: usize| {
        let origin = positions.m[freedom.body].column().map(|x| x.to_f64());
        let ([u, b], [c, f]) = (parts(&freedom.l), actions[body]);
        // About the joint's origin: b + u × o, c − o × f.
        let (b, c) = (sum(b, cross(u, origin)), sum(c, cross(f, origin)));
        length(u) * length(c) + length(b) * length(f)
    };
    let mut sizes = vec![0.0; robot.velocities()];
    for freedom in &positions.freedoms {
        let bodies = (freedom.body..actions.len()).filter(|&body| {
            let mut carriers = robot.upwards(Some(body));
            carriers.any(|carrier| carrier == freedom.body)
        });
        sizes[freedom.velocity] += bodies.map(|body| asked(freedom, body)).sum::<f64>();
    }
    sizes
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

/// M\[i\]\[m\] = Σ Tr(Lᵢ Σ J Lₘᵗ), over what both velocities move, and the bodies that both of these carry
/// (Lagrange).
fn mass_matrix(robot: &Robot, positions: &Positions) -> Vec<Vec<Big>> {
    let inertias = carried(robot, positions.j.clone());
    let carries = |outer: usize, inner: usize| robot.upwards(Some(outer)).any(|body| body == inner);
    let count = robot.velocities();
    let mut rows = vec![vec![Big::zero(); count]; count];
    for one in &positions.freedoms {
        for other in &positions.freedoms {
            let outermost = if carries(one.body, other.body) {
                one.body
            } else if carries(other.body, one.body) {
                other.body
            } else {
                continue;
            };
            let product = &one.l * &inertias[outermost];
            let entry = (&product * &other.l.transposed()).trace();
            let sum = &mut rows[one.velocity][other.velocity];
            *sum = &*sum + entry;
        }
    }
    for drive in &robot.drives {
        let entry = &mut rows[drive.velocity][drive.velocity];
        *entry = &*entry + drive.armature();
    }
    rows
}

/// The columns M L₍₀₎ M⁻¹; null for the velocities that do not move the frame.
fn jacobian(robot: &Robot, positions: &Positions, frame: Option<usize>, m: &Matrix) -> Vec<Big> {
    let moves = |joint: usize| robot.upwards(frame).any(|body| body == joint);
    let mut columns = vec![Matrix::zero(); robot.velocities()];
    for Freedom { body, velocity, l } in &positions.freedoms {
        if moves(*body) {
            columns[*velocity] = &columns[*velocity] + &(&(m * l) * &m.inverse());
        }
    }
    let entries = columns.iter().map(|l| [l.vector(), l.column()].concat());
    entries.flatten().collect()
}

/// The rates of the columns M L₍₀₎ M⁻¹, of a frame that moves by M and W: M (V L − L V) M⁻¹ where V is the
/// velocity of the body less W; null for the velocities that do not move the frame.
fn jacobian_rate(
    robot: &Robot,
    positions: &Positions,
    motion: &Motion,
    frame: Option<usize>,
    (m, w): (&Matrix, &Matrix),
) -> Vec<Big> {
    let moves = |joint: usize| robot.upwards(frame).any(|body| body == joint);
    let mut columns = vec![Matrix::zero(); robot.velocities()];
    for Freedom { body, velocity, l } in &positions.freedoms {
        if moves(*body) {
            let v = &motion.w[*body] - w;
            let rate = &(&v * l) - &(l * &v);
            columns[*velocity] = &columns[*velocity] + &(&(m * &rate) * &m.inverse());
        }
    }
    let entries = columns.iter().map(|l| [l.vector(), l.column()].concat());
    entries.flatten().collect()
}
