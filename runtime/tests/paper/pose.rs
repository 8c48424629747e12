//! § 2.2 and § 2.3: position matrices and rototranslations.

use crate::dense::{apply, assert_same, assert_within, product, size_of};
use crate::sample::{Random, displacements, poses};
use homogen::denavit_hartenberg::Parameters;
use homogen::{Direction, Displacement, Point, Pose, Real, Screw, vector};

fn points_change_frame<T: Real>() {
    let mut random = Random::new(10);
    for m in poses::<T>(10) {
        let (point, direction) = (Point(random.vector()), Direction(random.vector()));
        let scale = size_of(&m.to_matrix());
        let literal = apply(&m.to_matrix(), point.to_homogeneous());
        assert_within((m * point).to_homogeneous(), literal, scale, 8.0);
        assert_eq!(m.change_frame(&point), m * point);
        let literal = apply(&m.to_matrix(), direction.to_homogeneous());
        assert_within((m * direction).to_homogeneous(), literal, scale, 8.0);
        assert_eq!((m * direction).to_homogeneous()[3], T::constant(0.0));
        assert_eq!(m.change_frame(&direction), m * direction);
    }
}

fn columns_are_the_images_of_axes_and_origin<T: Real>() {
    for m in poses::<T>(11) {
        let columns = vector::transpose(m.rotation());
        let [x, y, z] = vector::identity::<T>().map(|axis| (m * Direction(axis)).0);
        assert_eq!(columns, [x, y, z]);
        assert_eq!((m * Point::origin()).0, m.translation());
    }
}

fn inverse_poses_undo<T: Real>() {
    for m in poses::<T>(12) {
        let identity = Pose::identity().to_matrix();
        let scale = size_of(&m.to_matrix());
        assert_same(&(m * m.inverse()).to_matrix(), &identity, scale, 16.0);
        assert_same(&(m.inverse() * m).to_matrix(), &identity, scale, 16.0);
        assert_eq!(*m.inverse().rotation(), vector::transpose(m.rotation()));
    }
}

fn poses_compose_by_product<T: Real>() {
    for (m_i_j, m_j_k) in poses::<T>(13).into_iter().zip(poses(14).into_iter().rev()) {
        let literal = product(&m_i_j.to_matrix(), &m_j_k.to_matrix());
        assert_same(
            &(m_i_j * m_j_k).to_matrix(),
            &literal,
            T::constant(1.0),
            8.0,
        );
        assert_eq!(m_i_j.change_frame(&m_j_k), m_i_j * m_j_k);
    }
}

fn displacements_take_poses_to_poses<T: Real>() {
    for (m_0_1, m_0_2) in poses::<T>(15).into_iter().zip(poses(16).into_iter().rev()) {
        // (2), (3), (4)
        let q = Displacement::between(&m_0_1, &m_0_2);
        let scale = size_of(&m_0_1.to_matrix()).max(size_of(&m_0_2.to_matrix()));
        assert_same(&(q * m_0_1).to_matrix(), &m_0_2.to_matrix(), scale, 32.0);
        let p = Point([0.3, -0.2, 0.5].map(T::constant));
        assert_within((q * (m_0_1 * p)).0, (m_0_2 * p).0, scale, 32.0);
        assert_within(
            (q * (m_0_1 * Direction(p.0))).0,
            (m_0_2 * Direction(p.0)).0,
            scale,
            32.0,
        );
        assert_same(
            &(q.inverse() * m_0_2).to_matrix(),
            &m_0_1.to_matrix(),
            scale,
            32.0,
        );
        let back = (q.inverse() * q).to_matrix();
        assert_same(&back, &Displacement::identity().to_matrix(), scale, 32.0);
    }
}

fn displacements_change_frame<T: Real>() {
    for (q, m_k_0) in displacements::<T>(17)
        .into_iter()
        .zip(poses(18).into_iter().rev())
    {
        // After (5): Q₍ₖ₎ = Mₖ₀ Q₍₀₎ Mₖ₀⁻¹.
        let (q, m_k_0) = (q, m_k_0);
        let literal = product(
            &product(&m_k_0.to_matrix(), &q.to_matrix()),
            &m_k_0.inverse().to_matrix(),
        );
        let scale = size_of(&q.to_matrix()).max(size_of(&m_k_0.to_matrix()));
        assert_same(&m_k_0.change_frame(&q).to_matrix(), &literal, scale, 32.0);
    }
}

fn a_displacement_in_its_own_frame_is_the_relative_pose<T: Real>() {
    for (m_0_1, m_0_2) in poses::<T>(19).into_iter().zip(poses(20).into_iter().rev()) {
        let m_1_2 = m_0_1.inverse() * m_0_2;
        let q_in_0 = Displacement::between(&m_0_1, &m_0_2);
        let scale = size_of(&m_0_1.to_matrix()).max(size_of(&m_0_2.to_matrix()));
        for m in [m_0_1, m_0_2] {
            let q = m.inverse().change_frame(&q_in_0);
            assert_same(
                &q.to_relative_pose().to_matrix(),
                &m_1_2.to_matrix(),
                scale,
                64.0,
            );
            let back = m.change_frame(&Displacement::from_relative_pose(m_1_2));
            assert_same(&back.to_matrix(), &q_in_0.to_matrix(), scale, 64.0);
        }
    }
}

fn four_numbers_of_a_link<T: Real>() {
    let mut random = Random::new(21);
    let zero = [T::constant(0.0); 3];
    let along = |axis: [f64; 3], x: T, turn: T| {
        let axis = axis.map(T::constant);
        let step = Screw::prismatic(axis).exp(x) * Screw::revolute(axis, zero).exp(turn);
        step.to_relative_pose()
    };
    for _ in 0..50 {
        let mut angle = || T::constant(3.0) * random.number::<T>();
        let (theta, alpha) = (angle(), angle());
        let (d, a) = (random.number(), random.number());
        let link = Parameters { theta, d, a, alpha };
        let (z, x) = (
            along([0.0, 0.0, 1.0], d, theta),
            along([1.0, 0.0, 0.0], a, alpha),
        );
        let one = T::constant(1.0);
        assert_same(&link.standard().to_matrix(), &(z * x).to_matrix(), one, 8.0);
        assert_same(&link.modified().to_matrix(), &(x * z).to_matrix(), one, 8.0);
    }
}

in_both_precisions! {
    four_numbers_of_a_link
    points_change_frame
    columns_are_the_images_of_axes_and_origin
    inverse_poses_undo
    poses_compose_by_product
    displacements_take_poses_to_poses
    displacements_change_frame
    a_displacement_in_its_own_frame_is_the_relative_pose
}
