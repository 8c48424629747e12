//! Tests of the constants of the derivation, with articulated inertias of random points of mass.
//!
//! In: seeds. Out: no block, no force of a joint or of a unit force, no computed inertia and no rounding of a joint
//! exceeds its bound, and the bounds that the derivation calls sharp are attained.

mod points;

use self::points::{Chain, Inertia, Random, Twist, cross, dot, left, norm, plus, times, twist};
use super::inertias::{FROBENIUS, SPOILT, TRUST};

/// More than rounding adds here.
const NEARLY: f64 = 1.0 + 1e-7;

#[test]
fn no_inertia_is_beyond_its_size_and_some_reach_it() {
    let mut random = Random::new(1);
    let (mut rigid, mut eliminate, mut actions) = ([0.0_f64; 3], [0.0_f64; 3], 0.0_f64);
    for rotation in 0..1000 {
        let chain = Chain::new(&mut random, 1 + rotation % 4);
        for (body, inertia) in chain
            .bodies
            .iter()
            .zip(chain.articulated(|_| [[0.0; 6]; 6]))
        {
            let [angular, linear] = body.sizes;
            let most = [angular * angular, angular * linear, linear * linear];
            let of_body = [&body.inertia, &inertia, &left(&inertia, &body.screw)];
            for (number, inertia) in of_body.into_iter().enumerate() {
                for (k, size) in body.blocks(inertia).into_iter().enumerate() {
                    let reached = if number == 0 {
                        &mut rigid
                    } else {
                        &mut eliminate
                    };
                    reached[k] = reached[k].max(size / most[k]);
                }
            }
            let (x, y) = (twist(random.vector(), random.vector()), random.vector());
            let y = twist(y, random.vector());
            assert!(dot(&x, &times(&inertia, &y)).abs() <= NEARLY * body.g(x) * body.g(y));
            let u = times(&inertia, &body.screw);
            let share = dot(&x, &u).abs() / (body.g(x) * dot(&u, &body.screw).sqrt());
            actions = actions.max(share);
        }
    }
    let root_2 = 2.0_f64.sqrt();
    for (reached, least, most) in [
        (rigid[0], 0.999, root_2),
        (rigid[1], 0.99, root_2),
        (rigid[2], 0.999, FROBENIUS),
        (eliminate[0], 0.999, root_2),
        (eliminate[1], 0.8, FROBENIUS),
        (eliminate[2], 0.999, FROBENIUS),
        (actions, 0.9, 1.0),
    ] {
        assert!(reached <= NEARLY * most, "{reached} of {most}");
        assert!(reached >= least * most, "{reached} of {most}");
    }
}

/// Errors of inertias that take as much of the energy as is allowed, in the worst shape.
#[test]
fn computed_inertias_have_the_sizes_of_exact_ones_but_for_trust() {
    let mut random = Random::new(2);
    let (mut pivots, mut sizes) = (0.0_f64, 0.0_f64);
    for rotation in 0..1000 {
        let chain = Chain::new(&mut random, 2 + rotation % 4);
        let exact = chain.articulated(|_| [[0.0; 6]; 6]);
        let pairs = chain.bodies.iter().zip(chain.mobility());
        let speeds: Vec<f64> = pairs
            .map(|(body, [rotations, translations])| {
                body.sizes[0] * rotations.sqrt() + body.sizes[1] * translations.sqrt()
            })
            .collect();
        assert!(
            speeds.iter().all(|&speed| speed * NEARLY >= 1.0),
            "{speeds:?}"
        );
        let shares: Vec<f64> = speeds.iter().map(|_| random.unit().powi(6)).collect();
        let sum: f64 = speeds
            .iter()
            .zip(&shares)
            .map(|(g, share)| share * g * g)
            .sum();
        let off: Vec<Inertia> = (chain.bodies.iter().zip(&shares))
            .map(|(body, share)| {
                // wwᵗ with |wᵗx| ≤ g(x), for some x as large.
                let (rotation, translation) = (random.direction(), random.direction());
                let [angular, linear] = body.sizes;
                let force = translation.map(|entry| linear * entry);
                let moment = cross(body.origin, force);
                let w: Twist = std::array::from_fn(|k| match k {
                    0..3 => angular * rotation[k] + moment[k],
                    _ => force[k - 3],
                });
                let share = share * SPOILT / sum * random.unit().signum();
                plus(&[[0.0; 6]; 6], |i, j| share * w[i] * w[j])
            })
            .collect();
        let found = chain.articulated(|k| off[k]);
        for ((body, exact), found) in chain.bodies.iter().zip(&exact).zip(&found) {
            let d = |inertia: &Inertia| dot(&body.screw, &times(inertia, &body.screw));
            let apart = (d(found) / d(exact) - 1.0).abs();
            pivots = pivots.max(apart);
            for _ in 0..8 {
                let x = twist(random.vector(), random.vector());
                let y = twist(random.vector(), random.vector());
                let size = dot(&x, &times(found, &y)).abs() / (body.g(x) * body.g(y));
                let apart = plus(found, |i, j| -exact[i][j]);
                let apart = dot(&x, &times(&apart, &y)).abs() / (body.g(x) * body.g(y));
                let u = times(found, &body.screw);
                let action = dot(&x, &u).powi(2) / (body.g(x).powi(2) * d(found));
                assert!(size.max(action) <= TRUST, "{size} {action}");
                sizes = sizes.max(apart);
            }
        }
    }
    assert!(
        (0.3 * SPOILT..=SPOILT * NEARLY).contains(&pivots),
        "{pivots}"
    );
    assert!((0.1 * SPOILT..=TRUST - 1.0).contains(&sizes), "{sizes}");
}

/// Unit forces on their way inwards, with the largest errors allowed, and the inverse computed with them.
#[test]
fn no_unit_force_is_beyond_its_size_and_no_entry_beyond_what_its_way_loses() {
    let mut random = Random::new(4);
    let (mut sizes, mut entries) = (0.0_f64, 0.0_f64);
    for rotation in 0..1000 {
        let chain = Chain::new(&mut random, 2 + rotation % 4);
        let (exact, mobility) = (chain.inverse(), chain.mobility());
        let articulated = chain.articulated(|_| [[0.0; 6]; 6]);
        let actions: Vec<Twist> = (articulated.iter().zip(&chain.bodies))
            .map(|(inertia, body)| times(inertia, &body.screw))
            .collect();
        let d: Vec<f64> = (actions.iter().zip(&chain.bodies))
            .map(|(action, body)| dot(action, &body.screw))
            .collect();
        let share = 1e-4 * random.unit().abs();
        let mut losses = Vec::new();
        let unbalanced_rows: Vec<Vec<f64>> = (0..chain.bodies.len())
            .map(|column| {
                let unit = exact[column][column].sqrt();
                let (mut action, mut loss) = ([0.0; 6], 0.0);
                let mut unbalanced_rows = vec![0.0; column + 1];
                for k in (0..=column).rev() {
                    let body = &chain.bodies[k];
                    let own = f64::from(u8::from(k == column));
                    unbalanced_rows[k] = own - dot(&action, &body.screw);
                    for (entry, pushed) in action.iter_mut().zip(actions[k]) {
                        *entry += pushed * unbalanced_rows[k] / d[k];
                    }
                    let x = twist(random.vector(), random.vector());
                    sizes = sizes.max(dot(&x, &action).abs() / (body.g(x) * unit));
                    // The error on the way to the parent body, about the origin of that body.
                    if let Some(parent) = k.checked_sub(1).map(|k| &chain.bodies[k]) {
                        let lost = parent.sizes.map(|size| share * unit * size);
                        let force = random.direction().map(|entry| lost[1] * entry);
                        let moment = random.direction().map(|entry| lost[0] * entry);
                        let carried = cross(parent.origin, force);
                        for (k, entry) in action.iter_mut().enumerate() {
                            *entry += if k < 3 {
                                moment[k] + carried[k]
                            } else {
                                force[k - 3]
                            };
                        }
                        let speeds = mobility[k - 1].map(f64::sqrt);
                        loss += dot(&speeds, &lost) / unit;
                    }
                }
                losses.push(loss);
                unbalanced_rows
            })
            .collect();
        for (row, of_row) in unbalanced_rows.iter().enumerate() {
            for (column, of_column) in unbalanced_rows.iter().enumerate() {
                let products = of_row.iter().zip(of_column).zip(&d);
                let entry: f64 = products.map(|((a, b), d)| a * b / d).sum();
                let unit = (exact[row][row] * exact[column][column]).sqrt();
                let most = (1.0 + losses[row]) * (1.0 + losses[column]) - 1.0;
                let off = (entry - exact[row][column]).abs() / unit;
                assert!(off <= NEARLY * most + 1e-9, "{off} of {most}");
                if most > 1e-6 {
                    entries = entries.max(off / most);
                }
            }
        }
    }
    assert!((0.5..=NEARLY).contains(&sizes), "{sizes}");
    assert!((0.2..=NEARLY).contains(&entries), "{entries}");
}

/// A number rounded to `f32`.
fn single(x: f64) -> f64 {
    #[expect(
        clippy::cast_possible_truncation,
        reason = "rounding is what it is for"
    )]
    let rounded = x as f32;
    f64::from(rounded)
}

/// The sum of products, one after the other, in `f32`.
fn summed(a: &[f64], b: &[f64]) -> f64 {
    let products = a.iter().zip(b).map(|(a, b)| single(a * b));
    products
        .reduce(|sum, product| single(sum + product))
        .unwrap_or(0.0)
}

/// The roundings at a joint, in units of the bounding size and of u.
#[test]
fn no_joint_loses_more_than_is_counted() {
    let roundoff = f64::from(f32::EPSILON) / 2.0;
    let mut random = Random::new(3);
    let (mut residual, mut entries, mut drifted, mut pushed) = (0.0_f64, 0.0_f64, 0.0_f64, 0.0_f64);
    for rotation in 0..6_000 {
        let chain = Chain::new(&mut random, 1 + rotation % 3);
        let [body, ..] = &chain.bodies[..] else {
            unreachable!("there is one")
        };
        let inertia = body.about(&chain.articulated(|_| [[0.0; 6]; 6])[0]);
        let inertia: Inertia = inertia.map(|row| row.map(single));
        let [angular, linear] = body.sizes;
        let sizes: Twist = std::array::from_fn(|k| if k < 3 { angular } else { linear });
        let clears = if rotation % 2 == 0 { 2 } else { 5 };
        let (u, d) = (inertia[clears], inertia[clears][clears]);
        // A thin body whose D may be a rounding error of `f32` is left out.
        if d < 1e-3 * sizes[clears] * sizes[clears] {
            continue;
        }
        let g = |x: &Twist| angular * norm(&x[..3]) + linear * norm(&x[3..]);
        // Scales of both parts differ widely, so that neither hides the error of the other.
        let scale = |random: &mut Random| 10.0_f64.powf(3.0 * random.unit());
        let scales = [scale(&mut random), scale(&mut random)];
        let any = |random: &mut Random| -> Twist {
            std::array::from_fn(|k| single(scales[k / 3] * random.unit()))
        };
        let carried = any(&mut random);
        let unbalanced = single(scale(&mut random) * random.unit());
        let inverse = single(1.0 / d);

        let opposed = summed(&u, &carried);
        let rate = single(single(unbalanced - opposed) * inverse);
        let mut whole = carried;
        whole[clears] += rate;
        let free = g(&whole) + sizes[clears] * rate.abs();
        let error = d * rate - (unbalanced - dot(&u, &carried));
        residual = residual.max(error.abs() / (d.sqrt() * free * roundoff));

        let over = u.map(|entry| single(entry * inverse));
        let (mut left, mut exact) = ([[0.0; 6]; 6], [[0.0; 6]; 6]);
        for i in (0..6).filter(|&i| i != clears) {
            for j in (0..6).filter(|&j| j != clears) {
                left[i][j] = single(inertia[i][j] - single(over[i] * u[j]));
                exact[i][j] = inertia[i][j] - u[i] * u[j] / d;
                let error = (left[i][j] - exact[i][j]).abs();
                entries = entries.max(error / (sizes[i] * sizes[j] * roundoff));
            }
        }
        let drift = any(&mut random);
        let push = single(unbalanced * inverse);
        for part in [0..3, 3..6] {
            let size = sizes[part.start] * roundoff;
            let lost = |of: &dyn Fn(usize) -> f64| norm(&part.clone().map(of).collect::<Vec<_>>());
            let moved = lost(&|i| summed(&left[i], &drift) - dot(&exact[i], &drift));
            drifted = drifted.max(moved / (size * g(&drift)));
            let moved = lost(&|i| single(u[i] * push) - u[i] * unbalanced / d);
            pushed = pushed.max(moved / (size * unbalanced.abs() / d.sqrt()));
        }
    }
    // The rounding of the right side, which is 1 of 12 and of 4, has gone before.
    for (reached, least, most) in [
        (residual, 1.5, 11.0),
        (entries, 1.5, 4.0),
        (drifted, 1.5, 6.0 * FROBENIUS + 3.0),
        (pushed, 1.5, 3.0),
    ] {
        assert!(reached <= most, "{reached} of {most}");
        assert!(reached >= least, "{reached} of {most}");
    }
}
