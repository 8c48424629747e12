//! The recursions at run time over joints with several velocities, and over mimic joints, against automatic
//! derivatives of positions and d'Alembert's principle.
//!
//! In: random trees with a floating root, spherical and planar joints, screws and mimic joints. The derivatives
//! assume only that M⁻¹ Ṁ = Σ L q̇ in the frame of a moved body.
#![cfg(feature = "nalgebra")]

use crate::jet::Jet;
use crate::sample::{Random, agree, largest};
use homogen::robot::manifold::normalized;
use homogen::{Chain, Frame, Joint, Motion, Pose, Screw, generic, vector};
use std::array::from_fn;

const V: usize = 15;
const Q: usize = 17;
const JOINTS: usize = 8;

type Tree = Chain<V, 1, Q, JOINTS>;
type Matrix = [[f64; 4]; 4];

/// A tree with a mimicked joint behind its mimic joint, branches, and every type of motion.
fn tree(random: &mut Random) -> Tree {
    let joints = from_fn(|i| {
        let (placement, inertia) = (random.pose(), random.inertia());
        let parent = [
            None,
            Some(0),
            Some(1),
            Some(1),
            Some(0),
            Some(4),
            Some(5),
            Some(6),
        ][i];
        let along = Joint::new("joint", parent, placement, random.screw(i), inertia);
        match i {
            0 => Joint::floating("root", parent, placement, inertia),
            1 => along.mimic(3, -1.5),
            2 => Joint::spherical("ball", parent, placement, inertia),
            4 => Joint::planar("puck", parent, placement, inertia),
            6 => along.mimic(3, 0.25),
            _ => along,
        }
    });
    let tip = Frame::new("tip", Some(6), random.pose());
    Chain::new(joints, [tip], random.numbers::<f64, 3>().map(|g| 9.81 * g))
}

fn coordinates(random: &mut Random) -> [f64; Q] {
    let mut q: [f64; Q] = random.numbers();
    for start in [3, 7] {
        let quaternion: [f64; 4] = from_fn(|k| q[start + k]);
        q[start..start + 4].copy_from_slice(&normalized(quaternion));
    }
    q
}

/// The poses of the bodies with derivatives: each joint moves by M exp(W t + …).
fn poses(chain: &Tree, q: &[f64; Q], rates: &[[f64; V]; 2]) -> [Pose<Jet>; JOINTS] {
    let mut poses: [Pose<Jet>; JOINTS] = from_fn(|_| Pose::identity());
    for (i, joint) in chain.joints.iter().enumerate() {
        let at = &q[chain.coordinates(i)];
        let [rate, second] = rates.map(|rates| rates[chain.velocities(i)].to_vec());
        let along = |times: f64| {
            let phi = Jet(times * at[0], times * rate[0], times * second[0]);
            let l = Screw::new(
                joint.screw.u().map(Jet::still),
                joint.screw.b().map(Jet::still),
            );
            l.exp(phi).to_relative_pose()
        };
        let zero = [0.0; 3];
        let moved = match joint.motion {
            Motion::Along => along(1.0),
            Motion::Mimic { multiplier, .. } => along(multiplier),
            Motion::Planar => {
                let (sine, cosine) = at[2].sin_cos();
                let turned = [[cosine, -sine, 0.0], [sine, cosine, 0.0], [0.0, 0.0, 1.0]];
                let twist = |x: &[f64]| [[0.0, 0.0, x[2]], [x[0], x[1], 0.0]];
                moving(&turned, [at[0], at[1], 0.0], twist(&rate), twist(&second))
            }
            Motion::Spherical => {
                let twist = |x: &[f64]| [[x[0], x[1], x[2]], zero];
                moving(&rotation(at), zero, twist(&rate), twist(&second))
            }
            Motion::Floating => {
                let twist = |x: &[f64]| [[x[3], x[4], x[5]], [x[0], x[1], x[2]]];
                let t = [at[0], at[1], at[2]];
                moving(&rotation(&at[3..]), t, twist(&rate), twist(&second))
            }
            other => panic!("{other:?} has no position here"),
        };
        let parent = joint
            .parent
            .map_or_else(Pose::identity, |parent| poses[parent]);
        let placement = Pose::new(
            joint.placement.rotation().map(|row| row.map(Jet::still)),
            joint.placement.translation().map(Jet::still),
        );
        poses[i] = parent * placement * moved;
    }
    poses
}

/// R by the products of quaternions with vectors, v + 2 w (u × v) + 2 u × (u × v).
fn rotation(quaternion: &[f64]) -> [[f64; 3]; 3] {
    let (u, w) = ([quaternion[0], quaternion[1], quaternion[2]], quaternion[3]);
    let column = |k: usize| {
        let v: [f64; 3] = from_fn(|i| if i == k { 1.0 } else { 0.0 });
        let once = vector::cross(u, v);
        let twice = vector::cross(u, once);
        from_fn(|i| v[i] + 2.0 * w * once[i] + 2.0 * twice[i])
    };
    let columns: [[f64; 3]; 3] = from_fn(column);
    from_fn(|i| from_fn(|k| columns[k][i]))
}

/// M, M W, M (W² + Ẇ) of a velocity in the moved frame.
fn moving(r: &[[f64; 3]; 3], t: [f64; 3], w: [[f64; 3]; 2], w_dot: [[f64; 3]; 2]) -> Pose<Jet> {
    let dense = |[omega, v]: [[f64; 3]; 2]| Screw::new(omega, v).to_matrix();
    let m = Pose::new(*r, t).to_matrix();
    let (w, w_dot) = (dense(w), dense(w_dot));
    let square = product(&w, &w);
    let second: Matrix = from_fn(|i| from_fn(|k| square[i][k] + w_dot[i][k]));
    let (rate, second) = (product(&m, &w), product(&m, &second));
    let jet = |i: usize, k: usize| Jet(m[i][k], rate[i][k], second[i][k]);
    Pose::new(from_fn(|i| from_fn(|k| jet(i, k))), from_fn(|i| jet(i, 3)))
}

fn product(a: &Matrix, b: &Matrix) -> Matrix {
    from_fn(|i| from_fn(|k| (0..4).map(|j| a[i][j] * b[j][k]).sum()))
}

fn transposed(a: &Matrix) -> Matrix {
    from_fn(|i| from_fn(|k| a[k][i]))
}

/// M with its first and second derivative, as dense matrices.
fn derivatives(pose: &Pose<Jet>) -> [Matrix; 3] {
    let m = pose.to_matrix();
    [
        m.map(|row| row.map(|x| x.0)),
        m.map(|row| row.map(|x| x.1)),
        m.map(|row| row.map(|x| x.2)),
    ]
}

/// Ṁ M⁻¹ or M̈ M⁻¹.
fn in_0(pose: &Pose<Jet>, derivative: usize) -> Matrix {
    let all = derivatives(pose);
    let rotation = pose.rotation().map(|row| row.map(|x| x.0));
    let inverse = Pose::new(rotation, pose.translation().map(|x| x.0)).inverse();
    product(&all[derivative], &inverse.to_matrix())
}

fn unit(k: usize) -> [f64; V] {
    from_fn(|i| if i == k { 1.0 } else { 0.0 })
}

/// The torque of each velocity: Σ Tr(H J Wᵗ) over the bodies, with W at a unit velocity (Part II, d'Alembert).
fn torques(chain: &Tree, q: &[f64; Q], rates: &[[f64; V]; 2]) -> [f64; V] {
    let moved = poses(chain, q, rates);
    let g = Screw::new([0.0; 3], chain.gravity).to_matrix();
    let inertia = |i: usize| {
        let [m, ..] = derivatives(&moved[i]);
        let j = chain.joints[i].inertia.to_matrix();
        product(&product(&m, &j), &transposed(&m))
    };
    from_fn(|k| {
        let by_one = poses(chain, q, &[unit(k), [0.0; V]]);
        let work = (0..JOINTS).map(|i| {
            let (h, w) = (in_0(&moved[i], 2), in_0(&by_one[i], 1));
            let lacking: Matrix = from_fn(|r| from_fn(|c| h[r][c] - g[r][c]));
            let dense = product(&product(&lacking, &inertia(i)), &transposed(&w));
            (0..4).map(|k| dense[k][k]).sum::<f64>()
        });
        work.sum()
    })
}

#[test]
fn kinematics_are_derivatives_of_positions() {
    for seed in 0..40 {
        let mut random = Random::new(seed);
        let (chain, q) = (tree(&mut random), coordinates(&mut random));
        let [qd, qdd]: [[f64; V]; 2] = [random.numbers(), random.numbers()];
        let tip = chain.tip();
        let placement = Pose::new(
            tip.placement.rotation().map(|row| row.map(Jet::still)),
            tip.placement.translation().map(Jet::still),
        );
        let moved = poses(&chain, &q, &[qd, qdd])[6] * placement;
        let [m, ..] = derivatives(&moved);
        let flat = |matrix: &Matrix| matrix.as_flattened().to_vec();
        let found = generic::forward_kinematics(&chain, &tip, &q).to_matrix();
        agree(&flat(&found), &flat(&m), 64.0, 10.0);
        let w = in_0(&moved, 1);
        let found = generic::velocity(&chain, &tip, &q, &qd).to_matrix();
        agree(&flat(&found), &flat(&w), 256.0, largest(&flat(&w)));
        let h = in_0(&moved, 2);
        let found = generic::acceleration(&chain, &tip, &q, &qd, &qdd).to_matrix();
        agree(&flat(&found), &flat(&h), 512.0, largest(&flat(&h)));
        let columns = generic::spatial_jacobian(&chain, &tip, &q);
        for (k, column) in columns.iter().enumerate() {
            let by_one = poses(&chain, &q, &[unit(k), [0.0; V]])[6] * placement;
            agree(
                &flat(&column.to_matrix()),
                &flat(&in_0(&by_one, 1)),
                256.0,
                20.0,
            );
        }
    }
}

#[test]
fn dynamics_are_virtual_work() {
    for seed in 0..40 {
        let mut random = Random::new(100 + seed);
        let (chain, q) = (tree(&mut random), coordinates(&mut random));
        let [qd, qdd]: [[f64; V]; 2] = [random.numbers(), random.numbers()];
        let rest = [0.0; V];
        let expected = torques(&chain, &q, &[qd, qdd]);
        let size = largest(&expected);
        let tau = generic::inverse_dynamics(&chain, &q, &qd, &qdd);
        agree(&tau, &expected, 512.0, size);
        let bias = torques(&chain, &q, &[qd, rest]);
        agree(&generic::bias(&chain, &q, &qd), &bias, 512.0, size);
        let gravity = torques(&chain, &q, &[rest, rest]);
        agree(&generic::gravity(&chain, &q), &gravity, 512.0, size);
        let mass = generic::mass_matrix(&chain, &q);
        for (k, row) in mass.iter().enumerate() {
            let column = torques(&chain, &q, &[rest, unit(k)]);
            let column: [f64; V] = from_fn(|i| column[i] - gravity[i]);
            agree(row, &column, 512.0, size);
        }
        let energy: f64 = (0..V)
            .map(|i| 0.5 * qd[i] * vector_product(&mass[i], &qd))
            .sum();
        agree(
            &[generic::kinetic_energy(&chain, &q, &qd)],
            &[energy],
            512.0,
            energy,
        );
    }
}

#[test]
fn forward_dynamics_inverts_inverse_dynamics() {
    for seed in 0..20 {
        let mut random = Random::new(200 + seed);
        let (chain, q) = (tree(&mut random), coordinates(&mut random));
        let [qd, tau]: [[f64; V]; 2] = [random.numbers(), random.numbers()];
        let qdd = generic::forward_dynamics(&chain, &q, &qd, &tau);
        let again = generic::inverse_dynamics(&chain, &q, &qd, &qdd);
        agree(&again, &tau, 1e5, largest(&generic::bias(&chain, &q, &qd)));
        let (mass, inverse) = (
            generic::mass_matrix(&chain, &q),
            generic::mass_matrix_inverse(&chain, &q),
        );
        for (i, row) in mass.iter().enumerate() {
            let off: [f64; V] = from_fn(|k| vector_product(row, &inverse.map(|row| row[k])));
            agree(&off, &unit(i), 1e6, 1.0);
        }
    }
}

fn vector_product(a: &[f64; V], b: &[f64; V]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// The documented error of [`Motion`] for a quaternion whose length is not 1.
#[test]
fn a_quaternion_of_another_length_distorts_by_four_times_as_much() {
    let mut random = Random::new(300);
    for off in [1e-3, -1e-3, 1e-9] {
        let (chain, q) = (tree(&mut random), coordinates(&mut random));
        let root = Frame::new("root", Some(0), Pose::identity());
        let mut longer = q;
        longer[3..7]
            .iter_mut()
            .for_each(|entry| *entry *= 1.0 + off);
        let [is, was] = [longer, q].map(|q| generic::forward_kinematics(&chain, &root, &q));
        let [is, was] = [is, was].map(|pose| {
            // Relative to the placement, so that R is that of the quaternion.
            *(chain.joints[0].placement.inverse() * pose).rotation()
        });
        let more = 2.0 * off + off * off;
        for i in 0..3 {
            let expected: [f64; 3] =
                from_fn(|k| was[i][k] + more * (was[i][k] - f64::from(u8::from(i == k))));
            agree(&is[i], &expected, 16.0, 1.0);
            let column: [f64; 3] = from_fn(|k| is[k][i] - was[k][i]);
            assert!(vector::norm(column) <= 4.0 * off.abs() * (1.0 + off.abs()));
        }
        let mended = chain.normalize(&longer);
        agree(&mended, &q, 4.0, 1.0);
    }
}

#[test]
fn wrong_mimicked_joints_and_counts_are_errors() {
    use homogen::Error;
    let chain = tree(&mut Random::new(301));
    assert_eq!(chain.check(1e-9), Ok(()));
    for (mimicked, name) in [(99, "joint"), (6, "joint"), (2, "joint"), (1, "joint")] {
        let mut wrong = chain;
        wrong.joints[1] = wrong.joints[1].mimic(mimicked, 1.0);
        let error = Error::InvalidMimic {
            joint: name,
            mimicked,
        };
        assert_eq!(wrong.check(1e-9), Err(error));
    }
    let mut wrong = chain;
    wrong.joints[1] = wrong.joints[1].mimic(3, f64::NAN);
    assert!(matches!(wrong.check(1e-9), Err(Error::NotFinite { .. })));
    let short: Chain<14, 1, Q, JOINTS> = Chain::new(chain.joints, chain.frames, [0.0; 3]);
    let counted = |quantity, stated, found| Error::WrongCount {
        quantity,
        stated,
        found,
    };
    assert_eq!(short.check(1e-9), Err(counted("velocities", 14, V)));
    let long: Chain<V, 1, 18, JOINTS> = Chain::new(chain.joints, chain.frames, [0.0; 3]);
    let refused = long.check(1e-9).unwrap_err();
    assert_eq!(refused, counted("coordinates", 18, Q));
    assert_eq!(
        refused.to_string(),
        "the type of the chain has 18 coordinates, its joints have 17"
    );
    // The functions still return without a panic.
    let _ = generic::mass_matrix(&long, &[0.1; 18]);
    let _ = generic::mass_matrix(&short, &[0.1; Q]);
}
