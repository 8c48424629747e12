//! Every robot that ships, derived once with all its functions.
//!
//! In: robots/*.urdf. Out: a struct for each robot, and a macro that runs a test for each.

use homogen::{Pose, Robot, Scalar, Screw};

/// A robot with functions that were generated together.
pub trait Together<const N: usize, T> {
    /// Pose and geometric Jacobian from one function.
    fn pose_and_jacobian(&self, q: &[T; N]) -> (Pose<T>, [Screw<T>; N]);

    /// Mass matrix and bias from one function.
    fn mass_and_bias(&self, q: &[T; N], qd: &[T; N]) -> ([[T; N]; N], [T; N]);
}

/// Derives a robot with all functions, alone and shared.
macro_rules! robot {
    ($(#[$about:meta])* $name:ident, $joints:literal, $file:literal, $tip:literal) => {
        $(#[$about])*
        #[derive(Robot, Clone, Copy, Debug)]
        #[robot(urdf = $file, tip = $tip, generate(all))]
        pub struct $name;

        const _: () = {
            #[derive(Robot)]
            #[robot(urdf = $file, tip = $tip)]
            #[robot(generate(
                all_of(forward_kinematics, geometric_jacobian),
                all_of(mass_matrix, bias),
            ))]
            struct Both;

            impl<T: Scalar> Together<$joints, T> for $name {
                fn pose_and_jacobian(&self, q: &[T; $joints]) -> (Pose<T>, [Screw<T>; $joints]) {
                    Both.forward_kinematics_and_geometric_jacobian(q)
                }

                fn mass_and_bias(
                    &self,
                    q: &[T; $joints],
                    qd: &[T; $joints],
                ) -> ([[T; $joints]; $joints], [T; $joints]) {
                    Both.mass_matrix_and_bias(q, qd)
                }
            }
        };
    };
}

robot! {
    /// Two links in a vertical plane.
    TwoLink, 2, "../../robots/two_link.urdf", "tip"
}
#[cfg(not(doc))]
robot! {
    /// Four joints with parallel axes, one of them prismatic.
    Scara, 4, "../../robots/scara.urdf", "tool"
}
#[cfg(not(doc))]
robot! {
    /// The Stanford arm.
    Stanford, 6, "../../robots/stanford.urdf", "tool"
}
#[cfg(not(doc))]
robot! {
    /// The Stanford arm without a zero among its inertial parameters.
    StanfordGeneral, 6, "../../robots/stanford_general.urdf", "tool"
}
#[cfg(not(doc))]
robot! {
    /// The PUMA 560.
    Puma560, 6, "../../robots/puma560.urdf", "tool"
}
#[cfg(not(doc))]
robot! {
    /// The PUMA 560 without a zero among its inertial parameters.
    Puma560General, 6, "../../robots/puma560_general.urdf", "tool"
}
#[cfg(not(doc))]
robot! {
    /// Six joints, three of them parallel.
    Ur5Class, 6, "../../robots/ur5_class.urdf", "tool0"
}
#[cfg(not(doc))]
robot! {
    /// Seven joints.
    PandaClass, 7, "../../robots/panda_class.urdf", "link8"
}
#[cfg(not(doc))]
robot! {
    /// A tree of twelve joints on a fixed base.
    Quadruped, 12, "../../robots/quadruped.urdf", "hr_foot"
}

/// Calls a macro with the file name and the struct of every robot that ships.
#[macro_export]
macro_rules! for_every_robot {
    ($run:ident) => {
        $run!(two_link, TwoLink);
        $run!(scara, Scara);
        $run!(stanford, Stanford);
        $run!(stanford_general, StanfordGeneral);
        $run!(puma560, Puma560);
        $run!(puma560_general, Puma560General);
        $run!(ur5_class, Ur5Class);
        $run!(panda_class, PandaClass);
        $run!(quadruped, Quadruped);
    };
}
