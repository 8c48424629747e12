//! The slider-crank at and near its dead centres.
//!
//! In: lengths, and angles at which the actuated joint cannot move the others, or nearly so. Out: residuals of the loop
//! at the computed position, and of the computed rates.

use std::array::from_fn;
use std::f64::consts::{FRAC_PI_2, PI};

use homogen::loop_closure::{position, velocity};
use homogen::worked_examples::slider_crank::SliderCrank;
use homogen_tests::big::Big;
use homogen_tests::states::Random;

use crate::hard_cases_geometry::exact::exact;
use crate::hard_cases_geometry::measure::{Number, hold, size};
use crate::hard_cases_geometry::worst::SLIDER_CRANK;

/// The lengths of crank and rod, the actuated joint, the dead centre, the distance from it, the actuated rate.
type State<T> = [T; 6];

fn states<T: Number>() -> Vec<State<T>> {
    let mut random = Random::new(9);
    let mut states = Vec::new();
    for k in 0..1000 {
        let crank = 0.6 + 0.4 * random.unit();
        let rod = crank * (1.1 + random.unit().abs());
        // Dead centres: with an actuated slider stretched and folded; for l₁ = l₂ also upright, with an actuated crank.
        let (rod, actuated, dead) = [
            (rod, 3.0, 0.0),
            (rod, 3.0, PI),
            (crank, 3.0, 0.0),
            (crank, 0.0, FRAC_PI_2),
            (crank, 0.0, -FRAC_PI_2),
        ][k % 5];
        let away = match k / 5 % 4 {
            0 => T::constant(0.0),
            1 => size(&mut random, -16.0, -9.0),
            _ => size(&mut random, -9.0, -2.0),
        };
        let rate = match k / 20 % 4 {
            0 => T::constant(0.0),
            1 => T::MIN_POSITIVE * T::constant(random.unit()),
            _ => T::constant(1.0),
        };
        // The description is in f64; rounding to the type would be an error of its own.
        let [crank, rod] = [crank, rod].map(|x| T::nearest(&Big::new(x)));
        states.push([
            crank,
            rod,
            T::constant(actuated),
            T::constant(dead),
            away,
            rate,
        ]);
    }
    states
}

/// Π M − 1 at q: the angle, and the two lengths relative to the linkage's.
fn gap<T: Number>(crank: &Big, rod: &Big, q: [T; 4]) -> [Big; 3] {
    let [crank_q, rod_q, pin_q, slider_q] = exact(q);
    let (s_1, c_1) = crank_q.sin_cos();
    let elbow = &crank_q + &rod_q;
    let (s_2, c_2) = elbow.sin_cos();
    let angle = &elbow + &pin_q;
    let (s_3, c_3) = angle.sin_cos();
    let size = crank + rod;
    [
        s_3,
        (crank * c_1 + rod * c_2 - c_3 * &slider_q) / &size,
        (crank * s_1 + rod * s_2 - angle.sin_cos().0 * slider_q) / size,
    ]
}

/// The rows of A that are not zero, without scaling of lengths.
fn rows<T: Number>(crank: &Big, q: [T; 4]) -> [[Big; 4]; 3] {
    let [crank_q, .., slider_q] = exact(q);
    let (sine, cosine) = crank_q.sin_cos();
    let (zero, one) = (Big::zero, Big::one);
    [
        [one(), one(), one(), zero()],
        [zero(), crank * sine, zero(), -one()],
        [zero(), -(crank * cosine), -slider_q, zero()],
    ]
}

/// Residuals of the computed position, and of its rates.
fn errors<T: Number>(state: &State<T>) -> [f64; 2] {
    let &[crank, rod, actuated, dead, away, _] = state;
    let (linkage, driver) = described(crank, rod, actuated);
    let still = T::constant(0.0);
    let q_at = |alpha| linkage.state(alpha, still, still).q;
    let given = if driver == 0 {
        dead + away
    } else {
        q_at(dead + away)[3]
    };
    let driving = from_fn(|i| (i == driver).then_some(given));
    // The start selects the branch; it is a little farther from the dead centre.
    let further = T::constant(if away < still { -0.1 } else { 0.1 });
    let found = position(&linkage.closed_chain(), &driving, &q_at(dead + further));
    let q = found.expect("within reach").q;
    let residual = most(&gap(&crank.big(), &rod.big(), q)) / Big::new(T::UNIT);
    [residual.to_f64(), backward(state, q)]
}

/// ‖A q̇‖ relative to ‖A‖ ‖q̇‖ at the computed position, in u. If the rank is reported as lost, the matrix must be
/// singular to rounding.
fn backward<T: Number>(state: &State<T>, q: [T; 4]) -> f64 {
    let &[crank, rod, actuated, _, _, rate] = state;
    let (linkage, driver) = described(crank, rod, actuated);
    let driving = from_fn(|i| (i == driver).then_some(rate));
    let found = velocity(&linkage.closed_chain(), &q, &driving);
    if !found.values.iter().all(|x| x.is_finite()) {
        return f64::NAN;
    }
    let (alpha, slider_q) = (q[0].big(), q[3].big());
    let (sine, cosine) = alpha.sin_cos();
    if found.is_singular() {
        // The minor of the unknown joints (the paper, Part II).
        let minor = if driver == 0 {
            slider_q - crank.big() * cosine
        } else {
            sine * slider_q
        };
        let is_lost = minor.abs() <= Big::new(4096.0 * T::UNIT);
        return if is_lost { 0.0 } else { f64::INFINITY };
    }
    let rates = exact(found.values);
    let a = rows(&crank.big(), q);
    let size = most(a.as_flattened()) * most(&rates) * Big::new(T::UNIT);
    let products = a.map(|row| {
        let terms = row.iter().zip(&rates).map(|(a, x)| a * x);
        terms.fold(Big::zero(), |sum, x| sum + x)
    });
    (most(&products) / (size + Big::new(T::UNDERFLOW))).to_f64()
}

/// The largest magnitude.
fn most(x: &[Big]) -> Big {
    x.iter().fold(Big::zero(), |most, x| most.max(x.abs()))
}

fn described<T: Number>(crank: T, rod: T, actuated: T) -> (SliderCrank, usize) {
    let (crank, rod) = (crank.to_f64(), rod.to_f64());
    (
        SliderCrank { crank, rod },
        if actuated > T::constant(0.0) { 3 } else { 0 },
    )
}

fn dead<T: Number>() {
    // The worst are 4.4 and 7.0 u; the limits are about twice as large.
    let limits = [
        ("slider_crank_dead, q", 8.0),
        ("slider_crank_dead, rates", 14.0),
    ];
    hold(limits, &SLIDER_CRANK, &states::<T>(), errors);
}

crate::in_every_type! {
    /// Hard case 29.
    slider_crank_dead => dead;
}
