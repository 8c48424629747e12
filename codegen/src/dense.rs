//! The functions of a robot by products of 4×4 matrices in frame 0, as the paper writes them.
//!
//! In: a [`Robot`], link by link, and a [`State`]. Out: a [`Dense`], from which each function's own file takes its
//! value. Every product is multiplied out, and the only recursion is that from parents to children: nothing is shared
//! with the matrices that are expanded.

mod approximate;
mod collision;
mod configuration;
mod constrained;
mod matrix;
mod products;
mod robot;
mod solved;

use std::cell::OnceCell;

pub(crate) use approximate::{Approximate, ROUNDOFF};
pub(crate) use matrix::Matrix;
pub(crate) use products::row_times;
pub(crate) use robot::{BodyId, Closed, Columns, DegreeOfFreedom, DenseBody, Moved, Robot};

use crate::expression::{Double, Input};
use crate::list::{self, Id, List, Square};
use crate::space::{Arguments, FieldId, FrameId, ParameterId, Variable, VelocityId};
use configuration::{Configuration, Direction, Gradient, Rates};

/// The inputs of a program.
#[derive(Clone, Debug, Default)]
pub(crate) struct State {
    pub(crate) arguments: Arguments<Double>,
    pub(crate) fields: List<FieldId, Vec<f64>>,
}

impl State {
    pub(crate) fn get(&self, input: Input) -> Double {
        match input {
            Input::Variable(variable, k) => self.arguments[variable][usize::from(k)],
            Input::Parameter(field, k) => self.fields[field.into()][usize::from(k)].into(),
        }
    }

    /// The entries of an argument over velocities.
    pub(crate) fn of_velocities(&self, variable: Variable) -> List<VelocityId, Approximate> {
        let entries = self.arguments[variable].iter().copied();
        entries.map(Approximate::exact).collect()
    }

    /// The number of velocities.
    pub(crate) fn velocities(&self) -> usize {
        self.arguments[Variable::Qd].len()
    }
}

/// The part of a state's motion that is used.
#[derive(Clone, Copy)]
pub(crate) enum MotionOrder {
    /// At rest.
    Rest,
    /// q̇ alone.
    Coasting,
    /// q̇ and q̈.
    Accelerated,
}

/// W, H and J of a link.
type MovingLink<'a> = (
    (Matrix<Approximate>, Matrix<Approximate>),
    &'a Matrix<Approximate>,
);

/// A robot at a state.
pub(crate) struct Dense {
    pub(crate) state: State,
    /// The part of the whole that is added to each pivot of the equations of loops, like a rounding error.
    pub(crate) disturbance: f64,
    configuration: Configuration,
    mass_matrix: OnceCell<Square<VelocityId, Approximate>>,
    regressor: OnceCell<List<ParameterId, List<VelocityId, Approximate>>>,
}

impl Dense {
    pub(crate) fn of(robot: Robot, state: State) -> Self {
        Self {
            configuration: Configuration::of(robot, &state.arguments[Variable::Q]),
            disturbance: 0.0,
            state,
            mass_matrix: OnceCell::new(),
            regressor: OnceCell::new(),
        }
    }

    /// M of a frame.
    pub(crate) fn pose(&self, frame: FrameId) -> Matrix<Approximate> {
        self.configuration.pose(frame)
    }

    /// M of all requested frames.
    pub(crate) fn poses(&self) -> Vec<Approximate> {
        let frames = self.configuration.frames();
        frames.flat_map(|frame| self.pose(frame).upper()).collect()
    }

    /// The columns of a Jacobian: u and b of the joints that move a frame, after a change of frame, and zeros for the
    /// others.
    pub(crate) fn columns(
        &self,
        frame: FrameId,
        seen: impl Fn(&Matrix<Approximate>) -> Matrix<Approximate>,
    ) -> Vec<Approximate> {
        let mut columns = vec![Approximate::exact(0.0); 6 * self.state.velocities()];
        for (k, screw) in self.configuration.moving(frame) {
            let column = &mut columns[6 * k.index()..][..6];
            for (entry, own) in column.iter_mut().zip(seen(screw).vectors()) {
                *entry = *entry + own;
            }
        }
        columns
    }

    /// The same for the derivatives: a function of L and of L̇ = W L − L W.
    pub(crate) fn column_rates(
        &self,
        frame: FrameId,
        seen: impl Fn(&Matrix<Approximate>, &Matrix<Approximate>) -> Matrix<Approximate>,
    ) -> Vec<Approximate> {
        self.column_rates_at(frame, &self.rates(MotionOrder::Coasting), seen)
    }

    fn column_rates_at(
        &self,
        frame: FrameId,
        rates: &Rates,
        seen: impl Fn(&Matrix<Approximate>, &Matrix<Approximate>) -> Matrix<Approximate>,
    ) -> Vec<Approximate> {
        let mut columns = vec![Approximate::exact(0.0); 6 * self.state.velocities()];
        for (k, screw, rate) in self.configuration.moving_rates(frame, rates) {
            let column = &mut columns[6 * k.index()..][..6];
            for (entry, own) in column.iter_mut().zip(seen(screw, &rate).vectors()) {
                *entry = *entry + own;
            }
        }
        columns
    }

    /// The rates of the columns of the geometric Jacobian, in the axes of frame 0 with the reference point at the moving
    /// origin of a frame.
    pub(crate) fn geometric_rates(&self, frame: FrameId) -> Vec<Approximate> {
        self.geometric_rates_at(frame, &self.rates(MotionOrder::Coasting))
    }

    fn geometric_rates_at(&self, frame: FrameId, rates: &Rates) -> Vec<Approximate> {
        let tip = self.pose(frame).column();
        let (w, _) = self.configuration.motion(frame, rates);
        // The reference point moves by W P; the axes keep their directions.
        let mut pole = Matrix::zero();
        pole.set_column(w.times(&Matrix::translation(tip)).column());
        let back = Matrix::translation(tip.map(|entry| -entry));
        self.column_rates_at(frame, rates, |screw, rate| {
            back.carries(&rate.minus(&pole.commutator(screw)))
        })
    }

    /// The derivatives of the geometric Jacobian by each coordinate: its rates at a unit velocity of each joint alone.
    pub(crate) fn jacobian_derivative(&self, frame: FrameId) -> Vec<Approximate> {
        let rates = self.unit_rates();
        rates
            .flat_map(|rates| self.geometric_rates_at(frame, &rates))
            .collect()
    }

    /// The powers of these derivatives against a wrench, with a row for each column of the Jacobian.
    pub(crate) fn forward_kinematics_hessian(&self, frame: FrameId) -> Vec<Approximate> {
        let count = self.state.velocities();
        let derivatives = self.jacobian_derivative(frame);
        let wrench = self.state.arguments[Variable::Wrench].iter();
        let wrench: Vec<Approximate> = wrench.copied().map(Approximate::exact).collect();
        let power = |row: usize, column: usize| {
            let screw = derivatives[6 * (count * column + row)..].iter();
            let terms = wrench.iter().zip(screw);
            terms.fold(Approximate::exact(0.0), |sum, (&force, &rate)| {
                sum + force * rate
            })
        };
        let rows = (0..count).flat_map(|row| (0..count).map(move |column| (row, column)));
        rows.map(|(row, column)| power(row, column)).collect()
    }

    /// The rates at a unit velocity of each joint alone.
    fn unit_rates(&self) -> impl Iterator<Item = Rates> {
        list::ids(self.state.velocities()).map(move |k| {
            let mut rates = self.rates(MotionOrder::Rest);
            rates.first[k] = Approximate::exact(1.0);
            rates
        })
    }

    /// The loops.
    fn loops(&self) -> &[Closed] {
        self.configuration.loops()
    }

    /// The screws of the joints that move a frame, with their indices in q̇.
    fn moving(&self, frame: FrameId) -> Vec<&(VelocityId, Matrix<Approximate>)> {
        self.configuration.moving(frame)
    }

    /// W and H of a frame.
    pub(crate) fn motion(
        &self,
        frame: FrameId,
        motion: MotionOrder,
    ) -> (Matrix<Approximate>, Matrix<Approximate>) {
        self.configuration.motion(frame, &self.rates(motion))
    }

    /// W and J of each link that a joint moves.
    pub(crate) fn links(
        &self,
        motion: MotionOrder,
    ) -> impl Iterator<Item = (Matrix<Approximate>, &Matrix<Approximate>)> {
        let links = self.moved(&self.rates(motion));
        links.map(|((velocity, _), inertia)| (velocity, inertia))
    }

    /// W, H and J of each link that a joint moves.
    fn moved<'a>(&'a self, rates: &Rates) -> impl Iterator<Item = MovingLink<'a>> + use<'a> {
        let motions = self.configuration.motions(rates).into_iter();
        let links = motions.zip(self.configuration.inertias());
        let moves = self.configuration.moves().into_iter();
        links
            .zip(moves)
            .filter_map(|(link, moves)| moves.then_some(link))
    }

    /// Σ J of the links that joints move.
    fn inertia(&self) -> Matrix<Approximate> {
        let links = self.links(MotionOrder::Rest);
        links.fold(Matrix::zero(), |sum, (_, inertia)| sum.plus(inertia))
    }

    /// The centre of the mass that joints move.
    pub(crate) fn mass_center(&self) -> [Approximate; 3] {
        let inertia = self.inertia();
        inertia.column().map(|moment| moment / inertia.0[3][3])
    }

    /// Σ W J of the links that joints move; its last column is the linear momentum.
    pub(crate) fn moments(&self, motion: MotionOrder) -> Matrix<Approximate> {
        self.moments_at(&self.rates(motion))
    }

    /// The same at a unit velocity of each joint alone.
    pub(crate) fn unit_moments(&self) -> impl Iterator<Item = Matrix<Approximate>> {
        self.unit_rates().map(|rates| self.moments_at(&rates))
    }

    fn moments_at(&self, rates: &Rates) -> Matrix<Approximate> {
        let moments = self.moved(rates).map(|((w, _), inertia)| w.times(inertia));
        moments.fold(Matrix::zero(), |sum, moment| sum.plus(&moment))
    }

    /// Σ H J of the links that joints move.
    pub(crate) fn inertia_forces(&self, motion: MotionOrder) -> Matrix<Approximate> {
        let links = self.moved(&self.rates(motion));
        let forces = links.map(|((_, h), inertia)| h.times(inertia));
        forces.fold(Matrix::zero(), |sum, force| sum.plus(&force))
    }

    /// Γ or Φ about the centre of mass.
    pub(crate) fn about_mass_center(&self, action: &Matrix<Approximate>) -> Matrix<Approximate> {
        let back = Matrix::translation(self.mass_center().map(|entry| -entry));
        back.times(action).times(&back.transposed())
    }

    /// The velocity of the centre of mass, from a linear momentum.
    pub(crate) fn by_mass(&self, momentum: [Approximate; 3]) -> [Approximate; 3] {
        let mass = self.inertia().0[3][3];
        momentum.map(|entry| entry / mass)
    }

    /// The sum of armature times squared velocity over all joints: twice their kinetic energy.
    pub(crate) fn twice_energy_of_actuators(&self) -> Approximate {
        let rates = self.rates(MotionOrder::Coasting).first;
        let energies = self
            .configuration
            .degrees_of_freedom()
            .map(|degree_of_freedom| {
                let rate = degree_of_freedom.factor * rates[degree_of_freedom.velocity];
                let [armature, ..] = degree_of_freedom.actuator;
                armature * rate * rate
            });
        energies.fold(Approximate::exact(0.0), |sum, energy| sum + energy)
    }

    /// H_g, the acceleration of gravity.
    pub(crate) fn gravity(&self) -> Matrix<Approximate> {
        let mut gravity = Matrix::zero();
        gravity.set_column(self.configuration.gravity());
        gravity
    }

    /// τ of a motion, against gravity.
    pub(crate) fn torques(&self, motion: MotionOrder) -> List<VelocityId, Approximate> {
        self.configuration.torques(&self.rates(motion))
    }

    /// τ of the whole motion, with the external wrenches.
    pub(crate) fn driving_torques(&self) -> List<VelocityId, Approximate> {
        self.less_external(self.torques(MotionOrder::Accelerated))
    }

    /// τ less the torques of the external wrenches.
    fn less_external(
        &self,
        torques: List<VelocityId, Approximate>,
    ) -> List<VelocityId, Approximate> {
        let external = self
            .configuration
            .external_torques(&self.state.arguments[Variable::Actions]);
        let both = torques.into_iter().zip(external);
        both.map(|(torque, external)| torque - external).collect()
    }

    /// τ of computed accelerations, with the external wrenches.
    pub(crate) fn torques_of(
        &self,
        qdd: List<VelocityId, Approximate>,
    ) -> List<VelocityId, Approximate> {
        self.less_external(self.configuration.torques(&self.rates_with(qdd)))
    }

    /// Y of τ = Y π, by rows.
    pub(crate) fn regressor(&self) -> Vec<Approximate> {
        self.rows_of(&self.columns_of_regressor().iter().collect::<Vec<_>>())
    }

    /// The row y of T = y π.
    pub(crate) fn kinetic_energy_regressor(&self) -> Vec<Approximate> {
        let rates = self.rates(MotionOrder::Coasting);
        let motions = self.configuration.motions(&rates);
        let half = Approximate::exact(0.5);
        let mut energies = self.configuration.of_each_parameter(|link, inertia| {
            let (w, _) = &motions[link];
            half * w.times(inertia).times(&w.transposed()).trace()
        });
        for one in self.configuration.identified() {
            let rate = one.factor * rates.first[one.velocity];
            let zero = Approximate::exact(0.0);
            energies.extend([half * rate * rate, zero, zero]);
        }
        energies
    }

    /// The row y of U = y π.
    pub(crate) fn potential_energy_regressor(&self) -> Vec<Approximate> {
        let gravity = self.gravity();
        let mut energies = self
            .configuration
            .of_each_parameter(|_, inertia| -gravity.times(inertia).trace());
        for _ in self.configuration.identified() {
            energies.extend([Approximate::exact(0.0); 3]);
        }
        energies
    }

    fn columns_of_regressor(&self) -> &List<ParameterId, List<VelocityId, Approximate>> {
        let found = || {
            self.configuration
                .regressor(&self.rates(MotionOrder::Accelerated), |_| true)
        };
        self.regressor.get_or_init(found)
    }

    /// Y by its columns, at computed accelerations.
    fn regressor_of(&self, qdd: List<VelocityId, Approximate>) -> Columns<Approximate> {
        self.configuration
            .regressor(&self.rates_with(qdd), |_| true)
    }

    /// Y by its columns, and the sizes of the terms of their entries; links without a wanted column are left out.
    pub(crate) fn regressor_and_sizes(
        &self,
        is_wanted: impl Fn(ParameterId) -> bool,
    ) -> (Columns<Approximate>, Columns<f64>) {
        let rates = self.rates(MotionOrder::Accelerated);
        (
            self.configuration.regressor(&rates, &is_wanted),
            self.configuration.regressor_sizes(&rates, &is_wanted),
        )
    }

    /// A matrix by rows, from its columns.
    fn rows_of(&self, columns: &[&List<VelocityId, Approximate>]) -> Vec<Approximate> {
        let row = |row: VelocityId| columns.iter().map(move |column| column[row]);
        list::ids(self.state.velocities()).flat_map(row).collect()
    }

    /// The columns of the base regressor, by rows.
    pub(crate) fn base_regressor(&self) -> Vec<Approximate> {
        let all = self.columns_of_regressor();
        let columns = self.configuration.base_columns().iter();
        self.rows_of(&columns.map(|&column| &all[column]).collect::<Vec<_>>())
    }

    /// τ of the motion without q̈, with the external wrenches.
    pub(crate) fn coasting_torques(&self) -> List<VelocityId, Approximate> {
        self.less_external(self.torques(MotionOrder::Coasting))
    }

    /// ∂τ/∂q at rest, against gravity.
    pub(crate) fn gravity_derivative(&self) -> Square<VelocityId, Approximate> {
        let [by_coordinate, _] = self
            .configuration
            .torque_derivatives(&self.rates(MotionOrder::Rest));
        by_coordinate
    }

    /// ∂τ/∂q and ∂τ/∂q̇ of the whole motion, with the external wrenches.
    pub(crate) fn torque_derivatives(&self) -> [Square<VelocityId, Approximate>; 2] {
        self.derivatives_at(&self.rates(MotionOrder::Accelerated))
    }

    /// The same at computed accelerations.
    pub(crate) fn torque_derivatives_of(
        &self,
        qdd: List<VelocityId, Approximate>,
    ) -> [Square<VelocityId, Approximate>; 2] {
        self.derivatives_at(&self.rates_with(qdd))
    }

    fn derivatives_at(&self, rates: &Rates) -> [Square<VelocityId, Approximate>; 2] {
        let [mut by_coordinate, by_rate] = self.configuration.torque_derivatives(rates);
        let external = self
            .configuration
            .external_derivative(&self.state.arguments[Variable::Actions]);
        for place in by_coordinate.places() {
            by_coordinate[place] = by_coordinate[place] - external[place];
        }
        [by_coordinate, by_rate]
    }

    /// The second derivatives of λᵀτ, of the blocks by q and q, q and q̇, q̇ and q̇, q and q̈: the sum of the rows of
    /// each, times the entries of a direction.
    pub(crate) fn torque_hessian(
        &self,
        direction: &List<VelocityId, Approximate>,
    ) -> Vec<Approximate> {
        let [qdd, weights] =
            [Variable::Qdd, Variable::Weights].map(|of| self.state.of_velocities(of));
        let blocks = self.torque_hessian_of(qdd, &weights, direction);
        blocks.into_iter().flatten().collect()
    }

    /// The same of computed accelerations and weights, a list for each block.
    fn torque_hessian_of(
        &self,
        qdd: List<VelocityId, Approximate>,
        weights: &List<VelocityId, Approximate>,
        direction: &List<VelocityId, Approximate>,
    ) -> [List<VelocityId, Approximate>; 4] {
        let rates = self.rates_with(qdd);
        let along = |direction: Direction<'_>| {
            let actions = &self.state.arguments[Variable::Actions];
            self.configuration
                .torque_hessian(&rates, weights, actions, direction)
        };
        let Gradient { q, qd, qdd } = along(Direction::Coordinates(direction));
        let of_rates = along(Direction::Rates(direction)).qd;
        [q, qd, of_rates, qdd]
    }

    /// The Coriolis matrix C.
    pub(crate) fn coriolis_matrix(&self) -> Square<VelocityId, Approximate> {
        self.configuration
            .coriolis_matrix(&self.rates(MotionOrder::Coasting))
    }

    /// The mass matrix M.
    pub(crate) fn mass_matrix(&self) -> &Square<VelocityId, Approximate> {
        self.mass_matrix
            .get_or_init(|| self.configuration.mass_matrix())
    }

    /// q̇ with computed accelerations.
    fn rates_with(&self, second: List<VelocityId, Approximate>) -> Rates {
        Rates {
            second,
            ..self.rates(MotionOrder::Coasting)
        }
    }

    fn rates(&self, motion: MotionOrder) -> Rates {
        let nothing = || List::filled(Approximate::exact(0.0), self.state.velocities());
        let [qd, qdd] = [Variable::Qd, Variable::Qdd].map(|of| self.state.of_velocities(of));
        let (first, second) = match motion {
            MotionOrder::Rest => (nothing(), nothing()),
            MotionOrder::Coasting => (qd, nothing()),
            MotionOrder::Accelerated => (qd, qdd),
        };
        Rates { first, second }
    }
}
