//! The slider-crank: closed form against the library, and its dead centres.

use crate::jet::Jet;
use crate::sample::{Random, agree, largest};
use homogen::Real;
use homogen::loop_closure::{acceleration, matrix, mobility, position, rank, velocity};
use homogen::worked_examples::slider_crank::SliderCrank;
use std::array::from_fn;
use std::f64::consts::{FRAC_PI_2, PI};

const UNEQUAL: SliderCrank = SliderCrank {
    crank: 0.375,
    rod: 1.125,
};

/// Crank and rod of the same length: the slider reaches the axis of the crank.
const EQUAL: SliderCrank = SliderCrank {
    crank: 0.5,
    rod: 0.5,
};

fn closed_form<T: Real>() {
    let closed = UNEQUAL.closed_chain();
    for k in 0..720 {
        let alpha = T::constant(f64::from(k) * PI / 180.0);
        let (alpha_d, alpha_dd) = (T::constant(2.5), T::constant(-1.5));
        let state = UNEQUAL.state(alpha, alpha_d, alpha_dd);
        let a = matrix(&closed, &state.q);
        agree(
            a.as_flattened().as_flattened(),
            UNEQUAL.matrix(&state.q).as_flattened(),
            16.0,
            4.0,
        );
        assert_eq!(
            (rank(&closed, &state.q), mobility(&closed, &state.q)),
            (3, 1)
        );

        let driving = |given| [Some(given), None, None, None];
        let start = from_fn(|i| state.q[i] + T::constant([0.0, 0.3, -0.2, 0.1][i]));
        let found = position(&closed, &driving(alpha), &start).expect("the crank rotates fully");
        agree(&found.q, &state.q, 16.0, 7.0);
        let rates = velocity(&closed, &state.q, &driving(alpha_d));
        agree(&rates.values, &state.qd, 32.0, 4.0);
        let second = acceleration(&closed, &state.q, &state.qd, &driving(alpha_dd));
        agree(&second.values, &state.qdd, 64.0, 16.0);
        assert!(!found.is_singular && !rates.is_singular() && !second.is_singular());
        let rounding = T::constant(64.0) * T::EPSILON;
        assert!(rates.residual <= rounding && second.residual <= rounding);
    }
}

#[test]
fn slider_crank_in_closed_form() {
    closed_form::<f64>();
    closed_form::<f32>();
}

/// The rates of the closed form are the derivatives of its positions.
#[test]
fn the_closed_form_closes_the_loop() {
    for k in 0..720 {
        let alpha = f64::from(k) * PI / 180.0;
        let state = UNEQUAL.state(alpha, 2.5, -1.5);
        let q: [Jet; 4] = from_fn(|i| Jet(state.q[i], state.qd[i], state.qdd[i]));
        let closed = UNEQUAL.closed_chain();
        let [.., end] = homogen::open_chain::poses(&closed.chain, &q);
        let identity = homogen::Pose::<f64>::identity().to_matrix();
        let entries = |part: fn(Jet) -> f64| end.to_matrix().map(|row| row.map(part));
        agree(
            entries(|x| x.0).as_flattened(),
            identity.as_flattened(),
            16.0,
            2.0,
        );
        agree(entries(|x| x.1).as_flattened(), &[0.0; 16], 16.0, 10.0);
        agree(entries(|x| x.2).as_flattened(), &[0.0; 16], 32.0, 40.0);
    }
}

/// ‖A q̇‖ over ‖A‖ ‖q̇‖, in units of rounding.
fn backward_error<T: Real>(a: &[[T; 4]; 6], rates: &[T; 4]) -> f64 {
    let residuals = a.map(|row| {
        let products = row.iter().zip(rates).map(|(a, x)| *a * *x);
        products.fold(T::constant(0.0), |sum, x| sum + x)
    });
    let scale = largest(a.as_flattened()) * largest(rates);
    largest(&residuals) / (scale * 0.5 * T::EPSILON.to_f64())
}

/// Residual of the position and backward error of the rates, in units of rounding, at `offset` from
/// the dead centre `alpha` of the driving joint `driver`.
fn near<T: Real>(mechanism: &SliderCrank, driver: usize, alpha: f64, offset: f64) -> [f64; 2] {
    let closed = mechanism.closed_chain();
    let unit = 0.5 * T::EPSILON.to_f64();
    let q_at = |alpha| mechanism.state(alpha, T::constant(0.0), T::constant(0.0)).q;
    let angle = T::constant(alpha) + T::constant(offset);
    let given = if driver == 0 { angle } else { q_at(angle)[3] };
    let driving = |value| from_fn(|i| (i == driver).then_some(value));
    // The start, a little further on, determines the branch.
    let start = q_at(T::constant(alpha + if offset < 0.0 { -0.1 } else { 0.1 }));
    let found = position(&closed, &driving(given), &start).expect("within reach");
    let residual = found.residual.to_f64() / unit;

    let rates = velocity(&closed, &found.q, &driving(T::constant(1.0)));
    // If A is singular the driving joint cannot move: the rates are those of least norm.
    assert!(largest(&rates.values).is_finite());
    let backward = if rates.is_singular() {
        0.0
    } else {
        backward_error(&mechanism.matrix(&found.q), &rates.values)
    };
    [residual, backward]
}

fn dead_centres<T: Real>() {
    let mut worst = [0.0_f64; 2];
    let mut check = |mechanism: &SliderCrank, driver, alpha, offset| {
        let met = near::<T>(mechanism, driver, alpha, offset);
        worst = from_fn(|k| worst[k].max(met[k]));
        assert!(
            met[0] <= 8.0 && met[1] <= 16.0,
            "{mechanism:?} actuated at joint {driver} at {alpha} {offset:+e}: {met:?} u"
        );
    };
    let powers = (2..=16).map(|k| 10_f64.powi(-k));
    let offsets = powers.flat_map(|x| [x, -x]).chain([0.0]);
    for offset in offsets {
        check(&UNEQUAL, 3, 0.0, offset);
        check(&UNEQUAL, 3, PI, offset);
        check(&EQUAL, 3, 0.0, offset);
        // With l₁ = l₂ a driving crank is stuck upright.
        check(&EQUAL, 0, FRAC_PI_2, offset);
        check(&EQUAL, 0, -FRAC_PI_2, offset);
    }
    // Four states a seed.
    for seed in 0..250 {
        let mut random = Random::new(seed);
        let crank = 0.6 + 0.4 * random.number::<f64>();
        let longer = 1.1 + random.number::<f64>().abs();
        let unequal = SliderCrank {
            crank,
            rod: crank * longer,
        };
        let equal = SliderCrank { crank, rod: crank };
        let size = 10_f64.powf(-9.0 + 7.0 * random.number::<f64>());
        let offset = if random.number::<f64>() < 0.0 {
            -size
        } else {
            size
        };
        check(&unequal, 3, 0.0, offset);
        check(&unequal, 3, PI, offset);
        check(&equal, 3, 0.0, offset);
        check(&equal, 0, FRAC_PI_2, offset);
    }
    let [residual, backward] = worst;
    println!("position {residual:.1} u, velocity {backward:.1} u");
}

/// Hard case 29: the loop at and near its dead centres, and with l₁ = l₂.
#[test]
fn slider_crank_dead() {
    dead_centres::<f64>();
    dead_centres::<f32>();
}

fn rank_flag<T: Real>() {
    let rates_at = |mechanism: &SliderCrank, driver: usize, q: &[T; 4]| {
        let driving = from_fn(|i| (i == driver).then_some(T::constant(1.0)));
        velocity(&mechanism.closed_chain(), q, &driving)
    };
    for mechanism in [UNEQUAL, EQUAL] {
        let (l_1, l_2) = (T::constant(mechanism.crank), T::constant(mechanism.rod));
        let (zero, pi) = (T::constant(0.0), T::constant(PI));
        let outer = [zero, zero, zero, l_1 + l_2];
        let inner = [pi, -pi, zero, l_2 - l_1];
        for q in [outer, inner] {
            // A dead centre of the slider: its rate contradicts the loop, and the crank is undetermined.
            let by_slider = rates_at(&mechanism, 3, &q);
            assert!(by_slider.is_singular(), "{by_slider:?}");
            assert!(by_slider.residual > T::constant(0.1));
            // The crank determines the motion, and the slider is at rest.
            let by_crank = rates_at(&mechanism, 0, &q);
            assert!(!by_crank.is_singular());
            assert!(by_crank.values[3].abs() <= T::constant(4.0) * T::EPSILON);
        }
    }
    // l₁ = l₂ upright: the axes of crank and pin coincide, and the mobility to first order is 2.
    let up = T::constant(FRAC_PI_2);
    let upright = [up, -up - up, up, T::constant(0.0)];
    let closed = EQUAL.closed_chain();
    assert_eq!(
        (rank(&closed, &upright), mobility(&closed, &upright)),
        (2, 2)
    );
    assert!(rates_at(&EQUAL, 0, &upright).is_singular());
    // At a distance of 0.01 rad nothing is flagged.
    let beside = EQUAL.state(
        T::constant(FRAC_PI_2 - 0.01),
        T::constant(0.0),
        T::constant(0.0),
    );
    assert_eq!(mobility(&closed, &beside.q), 1);
    assert!(!rates_at(&EQUAL, 0, &beside.q).is_singular());
}

#[test]
fn slider_crank_dead_is_flagged_by_rank() {
    rank_flag::<f64>();
    rank_flag::<f32>();
}

/// A rod that is too short for the crank angle.
#[test]
fn an_unreachable_crank_angle_is_an_error() {
    let short = SliderCrank {
        crank: 1.0,
        rod: 0.5,
    };
    let start = short.state(0.1, 0.0, 0.0).q;
    let driving = [Some(FRAC_PI_2), None, None, None];
    let error = position(&short.closed_chain(), &driving, &start).expect_err("out of reach");
    // The gap is 0.5 m, the size of the robot 1.5 m.
    assert!(error.residual > 0.1 && error.iterations == 100, "{error}");
    let nan = position(
        &short.closed_chain(),
        &[Some(f64::NAN), None, None, None],
        &start,
    );
    assert!(nan.expect_err("not a number").residual.is_nan());
}
