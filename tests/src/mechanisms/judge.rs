//! Comparison of a generated robot with closed loops with two independent solutions.
//!
//! In: a [`Mechanism`] and a [`Mounting`]. Out: the outcome, or an error. The solutions are those of the equations of
//! the text in 256 bits, and of the robot as drawn, unmounted and unrounded, whose joints move alike.

use std::collections::BTreeMap;

use homogen_codegen::closure::ResidualKind;
use homogen_codegen::description::Description;
use homogen_codegen::request::Request;
use homogen_codegen::space::Variable;
use homogen_codegen::{Function, Real, chain};

use super::draw::{Kind, Mechanism};
use super::programs::Programs;
use super::text::{Mounting, read, text};
use super::truth::{Accelerations, Equations, Pivots, dot};
use crate::arguments::Arguments;
use crate::big::Big;
use crate::oracle::robot::Robot;
use crate::states::Random;

/// The number of digits up to which a robot may be refused, by name.
const FEW: usize = 5;

/// The number of digits from which roundings of the text do not matter.
const ALL: usize = 15;

/// Relative pivot of a residual below which a state is singular.
const SINGULAR: f64 = 1e-5;

/// The number of roundings of the largest term that results may differ by; that of accelerations is divided by the least
/// relative pivot.
const ROUNDINGS: f64 = 1e3;

/// The largest errors, by the compared quantity.
pub type Worst = BTreeMap<&'static str, f64>;

/// The outcome without a failure.
#[derive(Debug)]
pub enum Outcome {
    /// Refused, as robots with few digits may be.
    Refused,
    /// Reported as singular, or singular in all states.
    Singular,
    /// Its motion is right.
    Right(Worst),
}

/// Generates a robot in a scalar type and compares it with both solutions.
///
/// # Errors
/// The failure.
pub fn judge(
    mechanism: &Mechanism,
    mounting: &Mounting,
    scalar: Real,
    random: &mut Random,
) -> Result<Outcome, String> {
    let (description, request) =
        read(&text(mechanism, mounting)).map_err(|errors| errors.to_string())?;
    let programs = match Programs::of(&description, &request, scalar) {
        Ok(programs) => programs,
        Err(errors) => return refused(&errors.to_string(), mounting),
    };
    let warned = programs.chain.report.warnings.iter().any(|warning| {
        let message = &warning.message;
        let words = ["nearly depend", "no configuration was found"];
        words.iter().any(|words| message.contains(words)) || message.ends_with("no motion")
    });
    if warned && mounting.digits >= ALL {
        return Err(format!("warned: {:?}", programs.chain.report.warnings));
    }
    let robot = Robot::of(&description, &request);
    let rows = Rows::of(&programs, &description, &request)?;
    let straight = read(&text(mechanism, &Mounting::straight(mechanism)))
        .map_err(|errors| errors.to_string())?;
    let straight = Robot::of(&straight.0, &straight.1);
    let mut judge = Judge {
        programs: &programs,
        rows,
        digits: mounting.digits,
        scalar,
        is_reported: warned,
        worst: Worst::new(),
    };
    let mut compared = 0;
    for size in [0.3, 0.2, 0.1, 0.05, 0.01] {
        // With redundant residuals, few digits close the loops only approximately.
        let most = if mounting.digits >= ALL && scalar != Real::F32 {
            1e-12
        } else {
            1e-2
        };
        let Some(mut state) = programs.closed(size, most, random) else {
            continue;
        };
        if scalar == Real::F32 {
            state = rounded(&state);
        }
        let equations = Equations::at(&robot, &state);
        judge.kinematics(&equations, &state)?;
        let ideal = Equations::at(&straight, &state);
        let is_regular = judge.dynamics(&equations, &ideal, &state)?;
        compared += usize::from(is_regular);
        if compared == 2 {
            break;
        }
    }
    let must_move = mounting.digits >= ALL && !warned && scalar != Real::F32;
    match compared {
        0 if must_move && mechanism.kind != Kind::Stewart => Err("no state is regular".to_owned()),
        0 => Ok(Outcome::Singular),
        _ if warned => Ok(Outcome::Singular),
        _ => Ok(Outcome::Right(judge.worst)),
    }
}

fn refused(message: &str, mounting: &Mounting) -> Result<Outcome, String> {
    let by_name = ["blocks the joints", "cannot close"];
    let is_by_name = by_name.iter().any(|words| message.contains(words));
    if is_by_name && mounting.digits <= FEW {
        Ok(Outcome::Refused)
    } else {
        Err(format!("refused: {message}"))
    }
}

/// The state rounded to single precision.
fn rounded(state: &Arguments) -> Arguments {
    Arguments::of(|variable| {
        let entries = state[variable].iter();
        entries.map(|&entry| Real::F32.rounded(entry)).collect()
    })
}

/// Indices of the residuals that are generated, and of those that are left out.
struct Rows {
    kept: Vec<usize>,
    left_out: Vec<usize>,
}

impl Rows {
    fn of(
        programs: &Programs,
        description: &Description,
        request: &Request,
    ) -> Result<Self, String> {
        let all = chain::build(description, request).map_err(|errors| errors.to_string())?;
        let names = |chain: &chain::Chain| -> Vec<(String, ResidualKind)> {
            let loops = chain.loops.iter();
            let rows = loops
                .flat_map(|closed| closed.rows.iter().map(|row| (row.name(&closed.name), *row)));
            rows.collect()
        };
        let kept = names(&programs.chain);
        let mut rows = Self {
            kept: Vec::new(),
            left_out: Vec::new(),
        };
        for (place, named) in names(&all).into_iter().enumerate() {
            if kept.contains(&named) {
                rows.kept.push(place);
            } else {
                rows.left_out.push(place);
            }
        }
        Ok(rows)
    }
}

struct Judge<'p> {
    programs: &'p Programs,
    rows: Rows,
    digits: usize,
    scalar: Real,
    /// True if a warning said that residuals nearly depend on others.
    is_reported: bool,
    worst: Worst,
}

impl Judge<'_> {
    /// The limit of an error relative to the largest term.
    const fn rounding(&self) -> f64 {
        ROUNDINGS * self.scalar.roundoff()
    }

    /// A limit in double and in single precision.
    fn allowed(&self, double: f64, single: f64) -> f64 {
        if self.scalar == Real::F32 {
            single
        } else {
            double
        }
    }

    fn note(&mut self, what: &'static str, error: f64, most: f64) -> Result<(), String> {
        let worst = self.worst.entry(what).or_default();
        *worst = worst.max(error);
        if error <= most {
            Ok(())
        } else {
            Err(format!(
                "{what}: {error:.1e} of the largest entry; the limit is {most:.1e}"
            ))
        }
    }

    /// Compares residuals, their Jacobian and their bias, also of the residuals that are left out.
    fn kinematics(&mut self, all: &Equations, state: &Arguments) -> Result<(), String> {
        let kept =
            |of: &[Big]| -> Vec<f64> { self.rows.kept.iter().map(|&k| of[k].to_f64()).collect() };
        let (residuals, bias) = (kept(&all.residuals), kept(&all.jacobian_bias));
        let rows = self.rows.kept.iter().flat_map(|&k| &all.jacobian[k]);
        let jacobian: Vec<f64> = rows.map(Big::to_f64).collect();
        let speed = state[Variable::Qd]
            .iter()
            .fold(1.0, |most: f64, rate| most.max(rate.abs()));
        let most = self.rounding();
        for (function, expected, size) in [
            (Function::Constraint, residuals, 1.0),
            (Function::ConstraintJacobian, jacobian, 1.0),
            (Function::ConstraintBias, bias, speed * speed),
        ] {
            let found = self.programs.run(function, state);
            self.note(function.name(), difference(&found, &expected) / size, most)?;
        }
        for k in self.rows.left_out.clone() {
            let entries = all.jacobian[k].iter().chain([&all.residuals[k]]);
            let largest = entries
                .map(|entry| entry.to_f64().abs())
                .fold(0.0, f64::max);
            let (name, most) = match self.digits {
                ALL.. => ("left out, with all digits", 1e-13),
                _ => ("left out, with few digits", 2e-3),
            };
            self.note(name, largest, most)?;
        }
        Ok(())
    }

    /// Compares accelerations, multipliers and torques of actuated joints. Returns true if the state is regular.
    fn dynamics(
        &mut self,
        all: &Equations,
        ideal: &Equations,
        state: &Arguments,
    ) -> Result<bool, String> {
        let n = self.programs.velocities();
        let found = self
            .programs
            .run(Function::ConstrainedForwardDynamics, state);
        if let Some(bad) = found.iter().find(|entry| !entry.is_finite()) {
            return Err(format!("{bad} among accelerations and multipliers"));
        }
        let (qdd, multipliers) = found.split_at(n);
        let held = all.of(&self.rows.kept);
        let residual = held.torque_residual(qdd, multipliers, &state[Variable::Tau]);
        // In singular states, too, where multipliers grow and cancel.
        let most = self.allowed(1e-10, 1e-3);
        self.note("M q̈ + h − τ − Jᵗ λ", residual, most)?;
        let expected = held.accelerations(&state[Variable::Tau]);
        let pivots = expected.pivots;
        if self.is_reported || !self.is_regular(pivots) {
            return Ok(false);
        }
        let loss = pivots.least.recip();
        let error = share(qdd, &expected);
        // Residuals that depend on others up to the text's digits are left out in part.
        let in_part = self.in_part(&held, pivots);
        let name = if in_part > 0.0 {
            "q̈ of the text, with few digits"
        } else {
            "q̈ of the text"
        };
        let most = self.rounding() * loss;
        self.note(name, error, most + in_part)?;
        let expected = ideal.accelerations(&state[Variable::Tau]);
        if self.digits > FEW && self.is_regular(expected.pivots) {
            let (name, rounding) = match self.digits {
                ALL.. => ("q̈ as drawn, with all digits", self.allowed(1e-12, 1e-5)),
                _ => ("q̈ as drawn, with few digits", 1e-4),
            };
            self.note(name, share(qdd, &expected), 10.0 * rounding * loss)?;
        }
        self.actuated(&held, state)?;
        Ok(true)
    }

    /// Compares the accelerations that actuator torques cause with those that they were computed for.
    fn actuated(&mut self, held: &Equations, state: &Arguments) -> Result<(), String> {
        let Accelerations {
            qdd,
            pivots: of_motion,
            ..
        } = held.accelerations(&state[Variable::Tau]);
        let chain = &self.programs.chain;
        let velocities = chain.actuated.numbered();
        let passive: Vec<usize> = velocities
            .filter(|(_, actuated)| !**actuated)
            .map(|(k, _)| homogen_codegen::list::Id::index(k))
            .collect();
        let pivots = held.pivots_of(&passive);
        if pivots.rank != passive.len() || of_motion.rank != pivots.rank || !self.is_regular(pivots)
        {
            return Ok(());
        }
        let qdd: Vec<f64> = qdd.iter().map(Big::to_f64).collect();
        let mut state = state.clone();
        state[Variable::Qdd] = match self.scalar {
            Real::F32 => qdd.iter().map(|&entry| Real::F32.rounded(entry)).collect(),
            _ => qdd.clone(),
        };
        let tau = self.programs.run(Function::ActuatedInverseDynamics, &state);
        let again = held.accelerations(&tau);
        let loss = (pivots.least * of_motion.least).recip();
        let most = self.rounding() * loss;
        let in_part = self.in_part(held, of_motion) * loss;
        self.note("q̈ of actuated τ", share(&qdd, &again), most + in_part)
    }

    /// An additional limit where residuals depend on others up to the text's digits.
    fn in_part(&self, held: &Equations, pivots: Pivots) -> f64 {
        if self.digits < ALL && pivots.rank < held.jacobian.len() {
            1e-3
        } else {
            0.0
        }
    }

    fn is_regular(&self, pivots: Pivots) -> bool {
        let (least, left) = match (self.scalar, self.digits) {
            (Real::F32, _) => (0.03, 1e-12),
            (_, ALL..) => (SINGULAR, 1e-16),
            _ => (SINGULAR, 1e-12),
        };
        pivots.least > least && pivots.left < left
    }
}

impl Equations {
    /// The equations with these residuals alone.
    #[must_use]
    pub fn of(&self, places: &[usize]) -> Self {
        Self {
            mass_matrix: self.mass_matrix.clone(),
            bias: self.bias.clone(),
            residuals: places.iter().map(|&k| self.residuals[k].clone()).collect(),
            jacobian: places.iter().map(|&k| self.jacobian[k].clone()).collect(),
            jacobian_bias: places
                .iter()
                .map(|&k| self.jacobian_bias[k].clone())
                .collect(),
        }
    }

    /// The largest entry of M q̈ + h − τ − Jᵗ λ, relative to the largest term.
    fn torque_residual(&self, qdd: &[f64], multipliers: &[f64], tau: &[f64]) -> f64 {
        let qdd: Vec<Big> = qdd.iter().map(|&entry| Big::new(entry)).collect();
        let (mut residual, mut largest) = (0.0_f64, 0.0_f64);
        for (k, row) in self.mass_matrix.iter().enumerate() {
            let mut sum = dot(row, &qdd) + &self.bias[k] - Big::new(tau[k]);
            let mut terms = vec![self.bias[k].to_f64(), tau[k]];
            terms.extend(row.iter().zip(&qdd).map(|(m, x)| (m * x).to_f64()));
            for (row, &multiplier) in self.jacobian.iter().zip(multipliers) {
                let term = &row[k] * Big::new(multiplier);
                terms.push(term.to_f64());
                sum = sum - term;
            }
            residual = residual.max(sum.to_f64().abs());
            largest = terms
                .into_iter()
                .fold(largest, |most, term| most.max(term.abs()));
        }
        residual / largest
    }
}

/// The largest difference of accelerations, relative to the largest term that they are summed from: where constraint
/// forces cancel the others, rounding of the terms remains.
fn share(found: &[f64], expected: &Accelerations) -> f64 {
    let qdd: Vec<f64> = expected.qdd.iter().map(Big::to_f64).collect();
    difference(found, &qdd) / expected.largest_term
}

fn difference(found: &[f64], expected: &[f64]) -> f64 {
    assert_eq!(found.len(), expected.len(), "number of results");
    let pairs = found.iter().zip(expected);
    pairs.fold(0.0, |most, (a, b)| most.max((a - b).abs()))
}
