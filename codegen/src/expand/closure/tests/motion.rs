//! Residuals along a motion of the joints, which is integrated by the rates of their coordinates alone.

use super::{arms_held_by, chain, kinds, numbers, plain, upright, values};
use crate::chain::Chain;
use crate::function::Function;
use crate::space::Space;

/// A motion of the two arms with constant velocities.
struct Motion<'c> {
    chain: &'c Chain,
    q: Vec<f64>,
    qd: Vec<f64>,
}

impl Motion<'_> {
    /// q at a time, by the rates of coordinates alone (Runge and Kutta), without a product of quaternions.
    fn at(&self, time: f64) -> Vec<f64> {
        const STEPS: u32 = 16;
        let mut q = self.q.clone();
        let step = time / f64::from(STEPS);
        let moved = |q: &[f64], rates: &[f64], by: f64| -> Vec<f64> {
            q.iter().zip(rates).map(|(q, rate)| q + by * rate).collect()
        };
        for _ in 0..STEPS {
            let first = self.rates(&q);
            let second = self.rates(&moved(&q, &first, step / 2.0));
            let third = self.rates(&moved(&q, &second, step / 2.0));
            let last = self.rates(&moved(&q, &third, step));
            for (k, q) in q.iter_mut().enumerate() {
                *q += step / 6.0 * (first[k] + 2.0 * second[k] + 2.0 * third[k] + last[k]);
            }
        }
        q
    }

    fn rates(&self, q: &[f64]) -> Vec<f64> {
        let spaces = self.chain.spaces();
        let names: Vec<&str> = spaces.names(Space::Coordinates).collect();
        let velocity = |name: &str| {
            let mut names = spaces.names(Space::Velocities);
            self.qd[names.position(|other| other == name).expect("a velocity")]
        };
        let mut rates = Vec::new();
        while rates.len() < names.len() {
            let name = names[rates.len()];
            if let Some(joint) = name.strip_suffix(".qx") {
                let at = rates.len();
                let [x, y, z, w] = [q[at], q[at + 1], q[at + 2], q[at + 3]];
                let [p, r, s] =
                    ["wx", "wy", "wz"].map(|entry| velocity(&format!("{joint}.{entry}")));
                rates.extend(
                    [
                        w * p + y * s - z * r,
                        w * r + z * p - x * s,
                        w * s + x * r - y * p,
                        -(x * p + y * r + z * s),
                    ]
                    .map(|rate| rate / 2.0),
                );
            } else if let Some(joint) = name.strip_suffix(".x") {
                // Planar: velocities are in the moved frame.
                let (sine, cosine) = q[rates.len() + 2].sin_cos();
                let [x, y] = ["vx", "vy"].map(|entry| velocity(&format!("{joint}.{entry}")));
                rates.extend([cosine * x - sine * y, sine * x + cosine * y]);
            } else {
                let of_planar = name.strip_suffix(".theta").or(name.strip_suffix(".angle"));
                let own = spaces.names(Space::Velocities).find(|other| *other == name);
                let turning = || {
                    let joint = of_planar.expect("the angle of a planar joint");
                    let first = spaces.names(Space::Velocities);
                    let own = first.filter(|other| other.starts_with(joint)).last();
                    velocity(own.expect("it turns"))
                };
                rates.push(own.map_or_else(turning, velocity));
            }
        }
        rates
    }
}

#[test]
fn rates_and_accelerations_of_residuals_are_those_of_a_motion() {
    const STEP: f64 = 1e-3;
    for (kind, count) in kinds() {
        let chain = chain(&arms_held_by(&kind)).expect("a robot");
        let spaces = chain.spaces();
        assert_eq!(spaces.len(Space::Constraints), count, "{kind}");
        let [constraint, jacobian, bias] = [
            Function::Constraint,
            Function::ConstraintJacobian,
            Function::ConstraintBias,
        ]
        .map(|function| plain(&chain, function));
        let velocities = spaces.velocities.len();
        for seed in 0..4 {
            let q = upright(&chain, seed);
            let qd = numbers(velocities, seed + 100);
            let chain = &chain;
            let motion = Motion { chain, q, qd };
            let of = |time: f64| values(&constraint, [&motion.at(time), &[], &[], &[]]);
            let [before, now, after] = [-STEP, 0.0, STEP].map(of);
            let [wide_before, wide_after] = [-2.0 * STEP, 2.0 * STEP].map(of);
            let j = values(&jacobian, [&motion.q, &[], &[], &[]]);
            let gamma = values(&bias, [&motion.q, &motion.qd, &[], &[]]);
            for row in 0..count {
                let terms = j[row * velocities..].iter().zip(&motion.qd);
                let rate: f64 = terms.map(|(j, qd)| j * qd).sum();
                let near = after[row] - before[row];
                let wide = wide_after[row] - wide_before[row];
                let expected = (8.0 * near - wide) / (12.0 * STEP);
                assert!(
                    (rate - expected).abs() < 1e-9,
                    "{kind}: {rate} is {expected}"
                );
                let near = after[row] + before[row] - 2.0 * now[row];
                let wide = wide_after[row] + wide_before[row] - 2.0 * now[row];
                let expected = (16.0 * near - wide) / (12.0 * STEP * STEP);
                let found = gamma[row];
                assert!(
                    (found - expected).abs() < 1e-7,
                    "{kind}: {found} is {expected}"
                );
            }
        }
    }
}
