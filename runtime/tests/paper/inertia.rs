//! § 4.3 and § 4.4: the pseudo-inertia, the usual tensor, physical bodies, and changes of frame.

use crate::dense::{assert_same, assert_within, product, size, size_of, transpose};
use crate::sample::{Random, inertias, poses};
use homogen::{Action, Error, Inertia, Momentum, Pose, Real, vector};

fn flat<T: Real>(x: &[[T; 3]; 3]) -> Vec<T> {
    x.as_flattened().to_vec()
}

fn usual_tensor_and_back<T: Real>() {
    for j in inertias::<T>(50) {
        let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = j.second_moments();
        let tensor = j.tensor_at_origin();
        let literal = [
            [yy + zz, -xy, -xz],
            [-xy, xx + zz, -yz],
            [-xz, -yz, xx + yy],
        ];
        assert_eq!(tensor, literal);
        if j.mass() == T::constant(0.0) {
            continue;
        }
        let scale = size_of(&j.to_matrix());
        let back = Inertia::from_tensor_at_origin(j.mass(), j.center_of_mass(), &tensor);
        assert_same(&back.to_matrix(), &j.to_matrix(), scale, 8.0);
        let central = j.tensor_at_center_of_mass();
        let back = Inertia::from_tensor_at_center_of_mass(j.mass(), j.center_of_mass(), &central);
        assert_same(&back.to_matrix(), &j.to_matrix(), scale, 16.0);
    }
}

fn tensor_about_the_center_is_that_of_huygens_and_steiner<T: Real>() {
    for j in inertias::<T>(51) {
        if j.mass() == T::constant(0.0) {
            continue;
        }
        // I_G = I_O − m (|c|² I − c cᵗ).
        let c = j.center_of_mass();
        let square = vector::matrix_scale(vector::dot(c, c), &vector::identity());
        let dyad = vector::matrix_scale(T::constant(-1.0), &vector::outer(c, c));
        let shift = vector::matrix_scale(-j.mass(), &vector::matrix_sum(&square, &dyad));
        let literal = vector::matrix_sum(&j.tensor_at_origin(), &shift);
        let scale = size_of(&j.to_matrix());
        assert_within(
            flat(&j.tensor_at_center_of_mass()),
            flat(&literal),
            scale,
            16.0,
        );
    }
}

fn dynamic_matrices_change_frame<T: Real>() {
    let mut random = Random::new(52);
    let bodies = inertias::<T>(52);
    for (m, j) in poses::<T>(52).into_iter().zip(bodies.iter().cycle()) {
        // (17): M · Mᵗ.
        let congruent = |x| product(&product(&m.to_matrix(), &x), &transpose(&m.to_matrix()));
        let reach = size_of(&m.to_matrix());
        let scale = |x: &[[T; 4]; 4]| T::constant(4.0) * size_of(x) * reach * reach;
        let phi = Action::new(random.vector(), random.vector()).to_matrix();
        let found = Action::new(
            [phi[2][1], phi[0][2], phi[1][0]],
            [phi[0][3], phi[1][3], phi[2][3]],
        );
        assert_same(
            &m.change_frame(&found).to_matrix(),
            &congruent(phi),
            scale(&phi),
            16.0,
        );
        let gamma = Momentum::new(random.vector(), random.vector());
        let literal = congruent(gamma.to_matrix());
        assert_same(
            &m.change_frame(&gamma).to_matrix(),
            &literal,
            scale(&gamma.to_matrix()),
            16.0,
        );
        let literal = congruent(j.to_matrix());
        assert_same(
            &m.change_frame(j).to_matrix(),
            &literal,
            scale(&j.to_matrix()),
            16.0,
        );
        assert_eq!(m.change_frame(j).mass(), j.mass());
    }
}

fn joined_bodies_add<T: Real>() {
    for (a, b) in inertias::<T>(53)
        .into_iter()
        .zip(inertias::<T>(54).into_iter().rev())
    {
        let scale = size_of(&a.to_matrix()).max(size_of(&b.to_matrix()));
        let back = (a + b) - b;
        assert_same(
            &back.to_matrix(),
            &a.to_matrix(),
            T::constant(2.0) * scale,
            2.0,
        );
    }
}

fn real_bodies_are_physical<T: Real>() {
    let tolerance = T::constant(32.0) * T::EPSILON;
    for (j, m) in inertias::<T>(55).into_iter().zip(poses::<T>(55)) {
        assert_eq!(j.check(tolerance), Ok(()));
        // A change of frame changes neither that nor the principal moments.
        let moved = m.change_frame(&j);
        let scale = size_of(&moved.to_matrix()).max(size_of(&j.to_matrix()));
        assert_eq!(moved.check(tolerance), Ok(()), "{j:?}");
        let smallest = [moved.smallest_second_moment()];
        assert_within(smallest, [j.smallest_second_moment()], scale, 64.0);
    }
}

fn non_physical_inertias_are_errors_with_the_amount<T: Real>() {
    let mut random = Random::new(56);
    let tolerance = T::constant(32.0) * T::EPSILON;
    for _ in 0..50 {
        // Principal second moments a, b and −d: d is the amount by which J_xx + J_yy ≥ J_zz fails.
        let d = random.positive::<T>() * T::constant(0.1) + T::constant(0.01);
        let (a, b) = (d + random.positive(), d + random.positive());
        let zero = T::constant(0.0);
        let j = Inertia::new([a, b, -d, zero, zero, zero], [zero; 3], T::constant(2.0));
        let moved = Pose::new(random.rotation(), random.vector()).change_frame(&j);
        let Err(Error::NotPhysical { value, .. }) = moved.check(tolerance) else {
            panic!("accepted {moved:?}");
        };
        assert_within([T::constant(value)], [-d], T::constant(8.0), 32.0);
    }
}

fn principal_axes_make_inertia_diagonal<T: Real>() {
    for j in inertias::<T>(57) {
        if j.mass() == T::constant(0.0) {
            continue;
        }
        let (pose, moments) = j.principal_frame();
        assert!(homogen::rotation::check(pose.rotation(), T::constant(16.0) * T::EPSILON).is_ok());
        let seen = pose.inverse().change_frame(&j);
        let [a, b, c] = moments;
        assert!(a >= b && b >= c);
        let zero = T::constant(0.0);
        let literal = Inertia::new([a, b, c, zero, zero, zero], [zero; 3], j.mass());
        let far = size(j.center_of_mass()).max(T::constant(1.0));
        let scale = size_of(&j.to_matrix()) * far;
        assert_same(&seen.to_matrix(), &literal.to_matrix(), scale, 64.0);
    }
}

in_both_precisions! {
    usual_tensor_and_back
    tensor_about_the_center_is_that_of_huygens_and_steiner
    dynamic_matrices_change_frame
    joined_bodies_add
    real_bodies_are_physical
    non_physical_inertias_are_errors_with_the_amount
    principal_axes_make_inertia_diagonal
}
