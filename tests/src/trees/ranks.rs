//! Base parameters of random robots, compared with the rank of their regressors in 256 bits.
//!
//! In: a [`Robot`] and its unit of length. Out: the number of its base parameters, if it is the rank of the regressor
//! and if the base parameters reproduce all columns, Y_b K = Y; or a refusal by name. Regressors are those of the
//! [oracle](crate::oracle) at random states; their elimination shares nothing with the engine.

mod elimination;

use homogen_codegen::Function;
use homogen_codegen::chain::base_parameters::BaseParameters;
use homogen_codegen::expand::{identified, understand};
use homogen_codegen::list::Id;
use homogen_codegen::space::{Kind, Space, Variable};

use crate::arguments::Arguments;
use crate::big::Big;
use crate::oracle::frame_0;
use crate::states::Random;

use super::prepared::{Prepared, guarded};
use super::robot::Robot;
use super::text;
use elimination::rank;

/// The limit of an error in Y_b K, relative to the column.
const OFF: f64 = 1e-10;

/// Rounding error of 106 bits after elimination, relative to the largest entry of a column.
const ROUNDING: f64 = 1e-22;

/// The same without units, for a column of zeros.
const NOTHING: f64 = 1e-26;

/// The comparison of the number of base parameters with the rank.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ranked {
    /// Equal to the rank.
    Right(usize),
    /// Refused: the engine cannot decide.
    Refused,
}

/// A regressor at a state, by columns, without units.
type Columns = Vec<Vec<Big>>;

/// Compares the base parameters of a robot.
///
/// # Errors
/// A description of the difference.
///
/// # Panics
/// If an identified chain has no base parameters.
pub fn ranked(robot: &Robot, length: f64, seed: u64) -> Result<Ranked, String> {
    let prepared = Prepared::of(robot, seed, 1)?;
    let found = guarded(|| {
        let (description, request) = text::read(robot)?;
        let chain = understand(&description, &request)?;
        identified(chain)
    })?;
    let found = match found {
        Ok(chain) => chain.base_parameters.expect("it is identified"),
        Err(refusal) => {
            let message = refusal.to_string();
            let by_name = message.contains("cannot be told apart") && !message.contains("fault");
            return if by_name {
                Ok(Ranked::Refused)
            } else {
                Err(format!("refused: {message}"))
            };
        }
    };
    let states = Regressors::new(&prepared, length, seed);
    reproduces_all(&found, &prepared, &states)?;
    let rows: Vec<Columns> = (0..states.enough()).map(|state| states.at(state)).collect();
    let groups = found.groups.len();
    match rank(&rows, &states.order()) {
        Some(rank) if rank == groups => Ok(Ranked::Right(rank)),
        Some(rank) => Err(format!(
            "{groups} base parameters, and the rank of the regressor is {rank}"
        )),
        None => Err("the rank of the regressor is undecided in 256 bits".to_owned()),
    }
}

/// Compares each column of Y with that of Y_b K, at two states.
fn reproduces_all(
    found: &BaseParameters,
    prepared: &Prepared<'_>,
    states: &Regressors<'_>,
) -> Result<(), String> {
    let places = prepared.parameters();
    let column = |parameter: usize| {
        let mut places = places.iter();
        places
            .position(|&place| place == parameter)
            .expect("the same parameters")
    };
    let mut terms: Vec<Vec<(usize, f64)>> = vec![Vec::new(); places.len()];
    for group in &found.groups {
        let leading = column(group.leading().index());
        for (member, factor) in &group.members {
            terms[column(member.index())].push((leading, *factor));
        }
    }
    let seen = [1_000_000, 1_000_001].map(|state| states.at(state));
    for (k, terms) in terms.iter().enumerate() {
        let entries = seen.iter().flat_map(|at| &at[k]);
        let entries = entries.map(|entry| entry.abs().to_f64());
        let rounding = NOTHING + ROUNDING * entries.fold(0.0, f64::max);
        // Each row has its own unit.
        for row in 0..seen[0][k].len() {
            let (mut off, mut whole) = (0.0_f64, 0.0_f64);
            for at in &seen {
                let mut rest = at[k][row].clone();
                whole = whole.max(rest.abs().to_f64());
                for (leading, factor) in terms {
                    let term = &at[*leading][row] * &Big::new(*factor) * &states.ratio(*leading, k);
                    whole = whole.max(term.abs().to_f64());
                    rest = rest - term;
                }
                off = off.max(rest.abs().to_f64());
            }
            // NaN fails too.
            if off.is_nan() || off > OFF * whole + rounding {
                let name = &prepared.chain().spaces().parameters[Id::new(places[k])].name;
                return Err(format!(
                    "Y_b K is off by {off:e} of {whole:e} in the column of {name}"
                ));
            }
        }
    }
    Ok(())
}

/// Regressors of a robot at random states, scaled by its length and gravity.
struct Regressors<'p> {
    prepared: &'p Prepared<'p>,
    length: f64,
    rate: f64,
    seed: u64,
    /// The divisors of rows, one for each velocity, and of columns.
    rows: Vec<f64>,
    columns: Vec<f64>,
}

impl<'p> Regressors<'p> {
    fn new(prepared: &'p Prepared<'p>, length: f64, seed: u64) -> Self {
        let rate = (10.0 / length).sqrt();
        let links = prepared
            .dense()
            .robot
            .bodies
            .iter()
            .filter(|body| body.link);
        let second = rate * rate;
        let of_link = [second * length * length]
            .into_iter()
            .chain([second * length; 3])
            .chain([second; 6]);
        let of_links = links.flat_map(|_| of_link.clone());
        let parameters = prepared.parameters().len();
        let mut columns: Vec<f64> = of_links.collect();
        let velocities = (parameters - columns.len()) / 3;
        columns.extend((0..velocities).flat_map(|_| [second, rate, 1.0]));
        let mut seen = Self {
            prepared,
            length,
            rate,
            seed,
            rows: Vec::new(),
            columns,
        };
        seen.rows = seen
            .units(Space::Velocities)
            .map(|unit| 1.0 / unit)
            .collect();
        seen
    }

    /// The unit of each entry: the unit of length for translations, else 1; in the order of the dense robot.
    fn units(&self, space: Space) -> impl Iterator<Item = f64> {
        let entries = self.prepared.chain().spaces().entries(space);
        let mut units = vec![1.0; entries.len()];
        for (k, entry) in entries.iter().enumerate() {
            if entry.kind == Kind::Translation {
                units[self.prepared.place(space, k)] = self.length;
            }
        }
        units.into_iter()
    }

    /// A number of states that suffices for the rank: each state has one row for each velocity.
    fn enough(&self) -> u64 {
        let robot = &self.prepared.dense().robot;
        let mut moved = vec![0_u64; robot.velocities()];
        for body in &robot.bodies {
            for (velocity, _) in body.motion.screws() {
                moved[velocity] += 1;
            }
        }
        2 + 10 * moved.into_iter().max().unwrap_or(0)
    }

    /// Velocities, outermost first.
    fn order(&self) -> Vec<usize> {
        let bodies = self.prepared.dense().robot.bodies.iter().rev();
        let mut order: Vec<usize> = Vec::new();
        for (velocity, _) in bodies.flat_map(|body| body.motion.screws()) {
            if !order.contains(&velocity) {
                order.push(velocity);
            }
        }
        order
    }

    /// The factor that converts an entry of one column to the units of another.
    fn ratio(&self, from: usize, to: usize) -> Big {
        Big::new(self.columns[from]) / Big::new(self.columns[to])
    }

    /// The regressor at a state.
    fn at(&self, state: u64) -> Columns {
        let mut random = Random::new(self.seed ^ (state << 20));
        let mut drawn = |space, scale: f64| -> Vec<f64> {
            let units: Vec<f64> = self.units(space).collect();
            units
                .into_iter()
                .map(|unit| 3.0 * unit * scale * random.unit())
                .collect()
        };
        let mut q = drawn(Space::Coordinates, 1.0);
        for start in self.prepared.dense().robot.quaternions() {
            for entry in &mut q[start..start + 4] {
                *entry *= 0.3;
            }
        }
        let mut arguments = Arguments::default();
        arguments[Variable::Q] = q;
        arguments[Variable::Qd] = drawn(Space::Velocities, self.rate);
        arguments[Variable::Qdd] = drawn(Space::Velocities, self.rate * self.rate);
        arguments[Variable::Tau] = vec![0.0; self.rows.len()];
        assert_eq!(arguments[Variable::Qd].len(), self.rows.len());
        let robot = &self.prepared.dense().robot;
        let entries = frame_0::evaluate(robot, Function::Regressor, 0, &arguments);
        let count = self.columns.len();
        let scaled = |row: usize, column: usize| {
            let unit = Big::new(self.rows[row]) * Big::new(self.columns[column]);
            &entries[row * count + column] / &unit
        };
        let rows = self.rows.len();
        let column = |column: usize| (0..rows).map(|row| scaled(row, column)).collect();
        (0..count).map(column).collect()
    }
}
