//! Climbs to the worst error of a function.
//!
//! In: a description, a function, a type of number. Out: the greatest share of its bound that the error
//! of a result takes, in corners of the range, anywhere in it, and uphill from the worst of them.
//! Programs run as the generated code does; the truth is the same function in the frames of the
//! description, with 106 bits.

use std::marker::PhantomData;

use homogen_codegen::accuracy::{Accuracy, Bound};
use homogen_codegen::chain::{self, Chain};
use homogen_codegen::description::Description;
use homogen_codegen::expand::expand;
use homogen_codegen::expression::{Double, Evaluation, Expr, Input, Term};
use homogen_codegen::layout::{Layout, arrange};
use homogen_codegen::model::Way;
use homogen_codegen::module::GeneratedFunction;
use homogen_codegen::range::Range;
use homogen_codegen::request::Request;
use homogen_codegen::schedule::run;
use homogen_codegen::space::{FrameId, Variable};
use homogen_codegen::{Function, Real};

use crate::states::Random;
use crate::tested::Tested;

/// One function of a robot, by itself.
///
/// # Panics
/// Where it is refused.
#[must_use]
pub fn listed(
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

/// The bounds of a function, of results or of what they are exact for.
///
/// # Panics
/// Where there are none.
#[must_use]
pub fn bounds(generated: &GeneratedFunction) -> &[Bound] {
    match &*generated.accuracy {
        [Accuracy::Within(promise) | Accuracy::Backward(_, promise)] => &promise.bounds,
        other => panic!("{other:?}"),
    }
}

/// The bound of each result of a function, of those of its joints and units.
///
/// # Panics
/// Where one is missing.
#[must_use]
pub fn of_results(chain: &Chain, function: Function, bounds: &[Bound]) -> Vec<f64> {
    let (result, spaces) = (function.result(), chain.spaces());
    let units = result.units(spaces).into_iter().enumerate();
    let of_result = units.map(|(k, unit)| {
        let owner = result.owner(spaces, k);
        let joint = owner.map(|(space, entry)| &spaces.entries(space)[entry].name);
        let of = |bound: &&Bound| bound.unit == unit && bound.joint.as_ref() == joint;
        let bound = bounds.iter().find(of).expect("each has a bound");
        bound.double.or(bound.single).expect("it is of one type")
    });
    of_result.collect()
}

/// What a climb looks at: one function in one type, its bounds and its truth.
pub struct Climb<T> {
    generated: GeneratedFunction,
    /// Of each result.
    bounds: Vec<f64>,
    units: Vec<&'static str>,
    exact: Evaluation<Double>,
    range: Range,
    as_type: PhantomData<T>,
}

/// A state: every number that the range has.
type State = Vec<f64>;

impl<T: Tested> Climb<T> {
    /// Of a function that has a bound for each joint.
    ///
    /// # Panics
    /// Where the robot is refused, or the function has no bound.
    #[must_use]
    pub fn new(description: &Description, request: &Request, function: Function) -> Self {
        let generated = listed(description, request.clone(), function, T::REAL);
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

    /// The ranges of all inputs.
    fn ends(&self) -> Vec<(Input, [f64; 2])> {
        let index = |k: usize| u16::try_from(k).expect("few");
        let mut ends = Vec::new();
        for of in Variable::ALL {
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

    /// Makes quaternions of the entries of a state that are of one: of length 1 but for their rounding, or longer by as
    /// much as a computed length may be off.
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

    /// The errors of all results in a state.
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

    /// The share of its bound that the worst error takes, of each result: in corners of the range and
    /// anywhere in it, and then uphill from the worst of those in a unit, or of all.
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
        for turn in 0..states + steps {
            let mut state = best.1.clone();
            if turn < states {
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
                assert!(share.is_finite(), "an error that is no number");
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

    /// Holds every result against its bound; the worst share of all.
    ///
    /// # Panics
    /// Where one is beyond it.
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

    /// For each unit of the results the worst share of their bounds, uphill from the worst of its own.
    ///
    /// # Panics
    /// Where one is beyond its bound.
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

/// A number of the type within a range, often at its ends and sometimes near its middle.
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

/// What a function computes, with 106 bits.
#[must_use]
pub fn exactly(chain: &Chain, function: Function) -> Evaluation<Double> {
    let graph = chain.graph.clone();
    let bodies = arrange(&graph, chain, Layout::DESCRIBED);
    let results = function
        .build(&graph, &bodies, FrameId::FIRST, Way::PLAIN)
        .into_iter();
    let results: Vec<Expr> = results.map(Term::expr).collect();
    Evaluation::of(&graph, &results)
}
