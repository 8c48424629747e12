//! Random search for the worst error of a function, relative to its printed bound.
//!
//! In: a description, a function, a type of number. Out: for each result, the largest ratio of error to bound, at
//! corners of the range, inside it, and uphill from the worst state. Programs run as the generated code does; the
//! truth is the same function in the frames of the description, in 106 bits.

use std::marker::PhantomData;

use homogen_codegen::accuracy::{Accuracy, Bound};
use homogen_codegen::chain::{self, Chain};
use homogen_codegen::description::Description;
use homogen_codegen::expand::expand;
use homogen_codegen::expression::{Double, Evaluation, Expr, Input, Term};
use homogen_codegen::layout::{Layout, arrange};
use homogen_codegen::model::Algorithm;
use homogen_codegen::module::GeneratedFunction;
use homogen_codegen::range::Range;
use homogen_codegen::request::Request;
use homogen_codegen::schedule::run;
use homogen_codegen::space::{FrameId, Variable};
use homogen_codegen::{Function, Real};

use crate::states::Random;
use crate::tested::Tested;

/// A module's only function: the requested one.
///
/// # Panics
/// If the robot is rejected.
#[must_use]
pub fn generated(
    description: &Description,
    request: Request,
    function: Function,
    scalar: Real,
) -> GeneratedFunction {
    let request = Request {
        functions: vec![vec![function]],
        scalar,
        ..request
    };
    let module = expand(description, &request);
    let module = module.unwrap_or_else(|errors| panic!("{errors}"));
    let generated = module.functions.into_iter().next();
    generated.expect("one function was asked for")
}

/// The bounds of a function: of its results, or backward.
///
/// # Panics
/// If it has none.
#[must_use]
pub fn bounds(generated: &GeneratedFunction) -> &[Bound] {
    match &*generated.accuracy {
        [Accuracy::Within(bound) | Accuracy::Backward(_, bound)] => &bound.bounds,
        other => panic!("{other:?}"),
    }
}

/// The bound of each result of a function, chosen by joint and unit.
///
/// # Panics
/// If one is missing.
#[must_use]
pub fn of_results(chain: &Chain, function: Function, bounds: &[Bound]) -> Vec<f64> {
    let (result, spaces) = (function.result(), chain.spaces());
    let units = result.units(spaces).into_iter().enumerate();
    let of_result = units.map(|(k, unit)| {
        let owner = result.owner(spaces, k);
        let joint = owner.map(|(space, entry)| &spaces.entries(space)[entry].name);
        let of = |bound: &&Bound| bound.unit == unit && bound.joint.as_ref() == joint;
        let bound = bounds.iter().find(of).expect("each has a bound");
        bound.double.or(bound.single).expect("a bound in one type")
    });
    of_result.collect()
}

/// A function in one type, with its bounds and its true value.
pub struct Climb<T> {
    generated: GeneratedFunction,
    /// One for each result.
    bounds: Vec<f64>,
    units: Vec<&'static str>,
    exact: Evaluation<Double>,
    range: Range,
    as_type: PhantomData<T>,
}

/// A value for every input.
type State = Vec<f64>;

impl<T: Tested> Climb<T> {
    /// The search for a function that has a bound for each joint.
    ///
    /// # Panics
    /// If the robot is rejected, or the function has no bound.
    #[must_use]
    pub fn new(description: &Description, request: &Request, function: Function) -> Self {
        let generated = generated(description, request.clone(), function, T::REAL);
        let chain = chain::build(description, request)
            .unwrap_or_else(|errors| panic!("{errors}"))
            .identified();
        Self {
            bounds: of_results(&chain, function, bounds(&generated)),
            units: function.result().units(chain.spaces()),
            generated,
            exact: exactly(&chain, function),
            range: Range::of(&chain),
            as_type: PhantomData,
        }
    }

    /// The ranges of all inputs, of changes where the function has them.
    fn ends(&self) -> Vec<(Input, [f64; 2])> {
        let index = |k: usize| u16::try_from(k).expect("few");
        let mut ends = Vec::new();
        let functions = &self.generated.functions;
        let takes = |of: &Variable| {
            functions
                .iter()
                .any(|function| function.arguments().contains(of))
        };
        let arguments = Variable::ALL.into_iter();
        for of in arguments.filter(|of| !of.is_change() || takes(of)) {
            let ranges = self.range.arguments[of].iter().enumerate();
            ends.extend(ranges.map(|(k, &range)| (Input::Variable(of, index(k)), range)));
        }
        for (field, ranges) in self.range.fields.iter().enumerate() {
            for (k, &range) in ranges.iter().enumerate() {
                ends.push((Input::Parameter(index(field), index(k)), range));
            }
        }
        ends
    }

    /// Normalises the quaternions of a state: length 1 but for rounding, or longer by as much as a computed length may
    /// be off.
    fn settle(&self, ends: &[(Input, [f64; 2])], state: &mut [f64], random: &mut Random) {
        for first in &self.range.quaternions {
            let at = ends.iter().position(|(input, _)| input == first);
            let at = at.expect("every input has a range");
            let quaternion = &mut state[at..][..4];
            let length = quaternion.iter().map(|x| x * x).sum::<f64>().sqrt();
            let longer = [1.0, 1.0 + 2.0 * T::ROUNDOFF, 1.0 + 6.0 * T::ROUNDOFF][random.below(3)];
            for x in quaternion {
                *x = T::literal(longer * (*x / length)).to_f64();
            }
        }
    }

    /// Absolute errors of all results at a state.
    fn errors(&self, ends: &[(Input, [f64; 2])], state: &[f64]) -> Vec<f64> {
        let at = |input: Input| {
            let place = ends.iter().position(|(of, _)| *of == input);
            state[place.expect("every input has a range")]
        };
        let exact = self.exact.at(|input| Double::from(at(input)));
        let found = run(&self.generated.program, |input| T::literal(at(input)));
        let pairs = found.into_iter().zip(exact);
        pairs
            .map(|(found, exact)| (Double::from(found.to_f64()) - exact).to_f64().abs())
            .collect()
    }

    /// The largest ratio of error to bound of each result: at random states, often corners of the range, and uphill
    /// from the worst state, judged by the results with one unit, or by all.
    fn attack(&self, seed: u64, unit: Option<&str>, states: usize, steps: usize) -> Vec<f64> {
        let ends = self.ends();
        let mut random = Random::new(seed);
        let mut worst = vec![0.0_f64; self.bounds.len()];
        let mut best = (0.0, State::new());
        let share = |errors: &[f64]| -> Vec<f64> {
            let pairs = errors.iter().zip(&self.bounds);
            pairs
                .map(|(error, bound)| if *error == 0.0 { 0.0 } else { error / bound })
                .collect()
        };
        for step in 0..states + steps {
            let mut state = best.1.clone();
            if step < states {
                state = ends
                    .iter()
                    .map(|(_, range)| any::<T>(*range, &mut random))
                    .collect();
            } else {
                for _ in 0..=random.below(3) {
                    let at = random.below(ends.len());
                    state[at] = any::<T>(ends[at].1, &mut random);
                }
            }
            self.settle(&ends, &mut state, &mut random);
            let shares = share(&self.errors(&ends, &state));
            for (worst, share) in worst.iter_mut().zip(&shares) {
                assert!(share.is_finite(), "an error is not finite");
                *worst = worst.max(*share);
            }
            let own = shares.into_iter().zip(&self.units);
            let own = own.filter(|(_, of)| unit.is_none_or(|unit| unit == **of));
            let most = own.fold(0.0, |most, (share, _)| f64::max(most, share));
            if most >= best.0 {
                best = (most, state);
            }
        }
        worst
    }

    /// Compares every result with its bound. Returns the largest ratio of error to bound.
    ///
    /// # Panics
    /// If an error exceeds its bound.
    #[must_use]
    pub fn holds(&self, name: &str, states: usize, steps: usize) -> f64 {
        let worst = self
            .attack(7, None, states, steps)
            .into_iter()
            .fold(0.0, f64::max);
        println!("{name} in {}: {worst:.1e} of the bound", T::NAME);
        assert!(worst <= 1.0, "{name} in {}: {worst}", T::NAME);
        worst
    }

    /// For each unit, the largest ratio of error to bound, uphill from the worst state of its own results.
    ///
    /// # Panics
    /// If an error exceeds its bound.
    #[must_use]
    pub fn by_unit(&self, name: &str, states: usize, steps: usize) -> Vec<(&'static str, f64)> {
        let mut units = self.units.clone();
        units.sort_unstable();
        units.dedup();
        let climbed = units.into_iter().map(|unit| {
            let worst = self.attack(7, Some(unit), states, steps).into_iter();
            let own = worst.zip(&self.units).filter(|(_, of)| **of == unit);
            let worst = own.fold(0.0, |most, (share, _)| f64::max(most, share));
            println!("{name}, {unit}, in {}: {worst:.1e} of the bound", T::NAME);
            assert!(worst <= 1.0, "{name} in {}: {worst}", T::NAME);
            (unit, worst)
        });
        climbed.collect()
    }
}

/// A number of the type within a range: often an end, sometimes near its middle.
pub fn any<T: Tested>([lo, hi]: [f64; 2], random: &mut Random) -> f64 {
    let x = match random.below(8) {
        0..3 => lo,
        3..6 => hi,
        6 => 0.5 * (lo + hi) + 0.5 * (hi - lo) * random.unit() * 2.0_f64.powi(-20),
        _ => 0.5 * (lo + hi) + 0.5 * (hi - lo) * random.unit(),
    };
    let near = T::literal(x).to_f64();
    let step = 2.0 * T::ROUNDOFF * near.abs();
    let back = if near > hi {
        T::literal(near - step).to_f64()
    } else {
        near
    };
    if back < lo {
        T::literal(back + step).to_f64()
    } else {
        back
    }
}

/// A function in 106 bits, by the frames of the description.
#[must_use]
pub fn exactly(chain: &Chain, function: Function) -> Evaluation<Double> {
    let graph = chain.graph.clone();
    let bodies = arrange(&graph, chain, Layout::DESCRIBED);
    let results = function
        .build(&graph, &bodies, FrameId::FIRST, Algorithm::PLAIN)
        .into_iter();
    let results: Vec<Expr> = results.map(Term::expr).collect();
    Evaluation::of(&graph, &results)
}
