//! Robots with closed loops, compared with what is known without any code of this project: the paper's closed form of a
//! slider-crank, the triangles of a four-bar linkage, the spheres of a Delta robot; with equations of motion solved in
//! 256 bits; and over time, since a closed loop keeps its energy and stays closed.

mod delta;
mod equations;
mod four_bar;
mod leg;
mod slider_crank;
mod twin;

/// A Runge–Kutta step of fourth order, for coordinates that are the integrals of their rates.
fn step<const N: usize>(
    q: &mut [f64; N],
    qd: &mut [f64; N],
    step: f64,
    accelerations: impl Fn(&[f64; N], &[f64; N]) -> [f64; N],
) {
    let moved = |x: &[f64; N], rate: &[f64; N], by: f64| -> [f64; N] {
        std::array::from_fn(|k| x[k] + by * rate[k])
    };
    let (q_1, v_1) = (*q, *qd);
    let a_1 = accelerations(&q_1, &v_1);
    let (q_2, v_2) = (moved(q, &v_1, step / 2.0), moved(qd, &a_1, step / 2.0));
    let a_2 = accelerations(&q_2, &v_2);
    let (q_3, v_3) = (moved(q, &v_2, step / 2.0), moved(qd, &a_2, step / 2.0));
    let a_3 = accelerations(&q_3, &v_3);
    let (q_4, v_4) = (moved(q, &v_3, step), moved(qd, &a_3, step));
    let a_4 = accelerations(&q_4, &v_4);
    for k in 0..N {
        q[k] += step / 6.0 * (v_1[k] + 2.0 * v_2[k] + 2.0 * v_3[k] + v_4[k]);
        qd[k] += step / 6.0 * (a_1[k] + 2.0 * a_2[k] + 2.0 * a_3[k] + a_4[k]);
    }
}

/// The largest magnitude.
fn largest(numbers: &[f64]) -> f64 {
    numbers.iter().fold(0.0, |most, x| most.max(x.abs()))
}

/// The largest difference.
fn difference(found: &[f64], expected: &[f64]) -> f64 {
    assert_eq!(found.len(), expected.len());
    let pairs = found.iter().zip(expected);
    pairs.fold(0.0, |most, (x, y)| most.max((x - y).abs()))
}
