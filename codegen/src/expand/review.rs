//! Data for the reviewer of a file.
//!
//! In: a chain, the functions. Out: a [`Review`]: expected results of the functions, and each inertial number as a sum
//! of inertial parameters of links. It affects no other output.

use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::accuracy::RoundingModel;
use crate::chain::Chain;
use crate::check::vectors;
use crate::expression::{Arithmetic, Double, Evaluation, Expr, Input, Term};
use crate::layout::{Layout, Sliding};
use crate::list::Id;
use crate::matrix::{Inertia, Symmetric, Vector};
use crate::module::{GeneratedFunction, Origins, Review, Sum};
use crate::plan;
use crate::real::Real;
use crate::space::{FieldId, ParameterId};

/// Number of inertial parameters of a link.
const PARAMETERS: usize = 10;

/// Factors below this ratio to the largest of a sum are rounding errors.
const RESIDUE: f64 = 1e-12;

pub(super) fn review(chain: &Chain, functions: &[GeneratedFunction]) -> Review {
    let rounding = RoundingModel::of(&chain.request);
    Review {
        // No test vectors for generic scalars.
        vectors: if rounding.scalar == Real::Generic {
            Vec::new()
        } else {
            vectors(chain, (functions, rounding))
        },
        origins: origins(chain, functions),
        merged: chain.report.merged.clone(),
    }
}

/// The origins of inertial numbers, for each layout of functions that have any.
fn origins(chain: &Chain, functions: &[GeneratedFunction]) -> Vec<Origins> {
    let mut layouts: Vec<(Layout, Vec<String>)> = Vec::new();
    let with_mass = functions.iter().filter(|generated| {
        let mut functions = generated.functions.iter();
        functions.any(|function| function.has_mass())
    });
    for generated in with_mass {
        let name = generated.name();
        match layouts
            .iter_mut()
            .find(|(layout, _)| *layout == generated.layout)
        {
            Some((_, names)) => names.push(name),
            None => layouts.push((generated.layout, vec![name])),
        }
    }
    let layouts = layouts.into_iter();
    layouts
        .map(|(layout, functions)| Origins {
            functions,
            bodies: bodies(chain, layout),
        })
        .collect()
}

/// The inertial numbers of each body in the frames of a layout.
fn bodies(chain: &Chain, layout: Layout) -> Vec<(String, Vec<Sum>)> {
    // A frame at the centre of mass makes the numbers nonlinear in the parameters.
    let is_linear = layout.sliding != Sliding::AtMassCenter;
    let numbers = arranged(chain, layout);
    let forms = is_linear.then(|| arranged(&with_inputs(chain), layout));
    let links = chain.joints.iter().enumerate();
    let bodies = links.filter_map(|(k, joint)| {
        let (link, _) = joint.link.as_ref()?;
        let entries = numbers[k].iter().zip(ENTRIES).enumerate();
        let sums = entries.filter(|(_, (number, _))| number.constant.is_sharp());
        let sums = sums.map(|(entry, (number, name))| Sum {
            entry: name,
            value: number.constant.to_f64(),
            terms: forms
                .as_ref()
                .map_or_else(Vec::new, |forms| terms(chain, &forms[k][entry])),
        });
        let sums: Vec<Sum> = sums.collect();
        (!sums.is_empty()).then(|| (link.clone(), sums))
    });
    bodies.collect()
}

/// The entries of J, in the order of [`Inertia::entries`].
const ENTRIES: [&str; PARAMETERS] = [
    "J_xx", "J_yy", "J_zz", "J_xy", "J_xz", "J_yz", "q_x", "q_y", "q_z", "m",
];

/// Index of each entry in the order of [`Space::Parameters`](crate::space::Space).
const PLACES: [usize; PARAMETERS] = [4, 7, 9, 5, 6, 8, 1, 2, 3, 0];

fn terms(chain: &Chain, form: &LinearFunction) -> Vec<(f64, String)> {
    let names = &chain.spaces().parameters;
    let sizes = form.factors.iter().map(|(_, factor)| factor.to_f64().abs());
    let least = RESIDUE * sizes.fold(0.0, f64::max);
    let factors = form
        .factors
        .iter()
        .filter(|(_, factor)| factor.to_f64().abs() > least);
    factors
        .map(|&(parameter, factor)| (shortened(factor.to_f64()), names[parameter].name.clone()))
        .collect()
}

/// A number with ten digits, the same on every platform.
fn shortened(factor: f64) -> f64 {
    format!("{factor:.9e}").parse().unwrap_or(factor)
}

/// The entries of J of each body in the frames of a layout.
fn arranged(chain: &Chain, layout: Layout) -> Vec<Vec<LinearFunction>> {
    let graph = chain.graph.clone();
    let bodies = plan::arranged(&graph, chain, layout);
    let entries = bodies.bodies.iter();
    let entries: Vec<Expr> = entries
        .flat_map(|body| body.inertia.entries().map(Term::expr))
        .collect();
    let fields = chain.nominal.len();
    let found = Evaluation::of(&graph, &entries).at(|input| match input {
        Input::Parameter(field, entry) if usize::from(field) < fields => {
            LinearFunction::literal(chain.nominal[FieldId::from(field)][usize::from(entry)])
        }
        Input::Parameter(link, entry) => LinearFunction {
            constant: Double::ZERO,
            factors: vec![(
                ParameterId::new(
                    PARAMETERS * (usize::from(link) - fields) + PLACES[usize::from(entry)],
                ),
                1.0.into(),
            )],
        },
        Input::Variable(..) => unreachable!("a body is what it is in every state"),
    });
    found
        .chunks(PARAMETERS)
        .map(<[LinearFunction]>::to_vec)
        .collect()
}

/// The same chain with inertial parameters of links as inputs, numbered after the fields.
fn with_inputs(chain: &Chain) -> Chain {
    let mut chain = chain.clone();
    let graph = chain.graph.clone();
    let mut inputs = chain.nominal.len()..;
    for joint in &mut chain.joints {
        let Some((_, link)) = &joint.link else {
            continue;
        };
        let Some(Ok(input)) = inputs.next().map(u16::try_from) else {
            return chain;
        };
        let mut entries = 0..;
        let mut entry = || graph.input(Input::Parameter(input, entries.next().unwrap_or(0)));
        let own = Inertia {
            second: Symmetric([(); 6].map(|()| entry())),
            q: Vector([(); 3].map(|()| entry())),
            mass: entry(),
        };
        let placement = link.map(|expr| graph.term(expr));
        joint.inertia = own.change_frame(placement).map(Term::expr);
    }
    chain.graph = graph;
    chain
}

/// A linear function of parameters.
#[derive(Clone, Debug)]
struct LinearFunction {
    constant: Double,
    /// Each parameter with its factor, in their order.
    factors: Vec<(ParameterId, Double)>,
}

impl LinearFunction {
    const fn of(constant: Double) -> Self {
        Self {
            constant,
            factors: Vec::new(),
        }
    }

    fn map(self, change: impl Fn(Double) -> Double) -> Self {
        let factors = self.factors.into_iter();
        Self {
            constant: change(self.constant),
            factors: factors.map(|(of, factor)| (of, change(factor))).collect(),
        }
    }

    /// The constant; NaN if it depends on parameters.
    fn number(&self) -> Double {
        if self.factors.is_empty() {
            self.constant
        } else {
            f64::NAN.into()
        }
    }
}

impl Add for LinearFunction {
    type Output = Self;

    fn add(mut self, other: Self) -> Self {
        self.constant = self.constant + other.constant;
        for (of, factor) in other.factors {
            match self.factors.binary_search_by_key(&of, |(of, _)| *of) {
                Ok(place) => self.factors[place].1 = self.factors[place].1 + factor,
                Err(place) => self.factors.insert(place, (of, factor)),
            }
        }
        self
    }
}

impl Neg for LinearFunction {
    type Output = Self;

    fn neg(self) -> Self {
        self.map(|number| -number)
    }
}

impl Sub for LinearFunction {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for LinearFunction {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let (form, number) = if self.factors.is_empty() {
            (other, self.constant)
        } else {
            let number = other.number();
            (self, number)
        };
        form.map(|factor| factor * number)
    }
}

impl Div for LinearFunction {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        let number = other.number();
        self.map(|factor| factor / number)
    }
}

impl Arithmetic for LinearFunction {
    fn literal(value: f64) -> Self {
        Self::of(value.into())
    }

    fn sqrt(self) -> Self {
        Self::of(self.number().sqrt())
    }

    fn sign(self) -> Self {
        Self::of(self.number().sign())
    }

    fn sin_cos(self) -> (Self, Self) {
        let (sine, cosine) = self.number().sin_cos();
        (Self::of(sine), Self::of(cosine))
    }
}
